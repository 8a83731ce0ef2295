//! Describes a mechanism: points, links, slides and the driver, by typed ids, without names, text
//! or I/O.
//!
//! A [`Mechanism`] is immutable. [`Builder::build`] checks each element by itself, once: lengths,
//! coordinates, references. The solver checks the elements together: mobility, groups and whether
//! the loops close.

mod builder;
mod defect;
mod input_table;
mod inputs;
mod law;
mod lengths;
mod limit;
mod load;
mod name_ranks;
mod point_path;
mod polar;
mod spline;
mod tolerances;

pub use builder::Builder;
pub use defect::{Defect, Defects};
pub use input_table::InputTable;
pub(crate) use inputs::fraction;
pub use inputs::{InputLaw, TimedInput};
pub use law::{DriverMoment, MotionLaw, MotionPeaks, SineStep, StepLaw, TimedStep};
pub use lengths::{CoordinateAxis, Length};
pub use limit::MAX_TURNS;
pub use limit::{Limit, LimitId, LimitOf};
pub use load::{Load, Profile, StrokeEnd};
pub use point_path::{PointCircle, PointLead, PointPath};
pub use polar::PolarPosition;
pub use polar::polar_position;
pub use spline::ClampedSpline;
pub(crate) use spline::{SplineEnds, bends, cubic};
pub use tolerances::Tolerances;

use crate::{Double, Vec2};
use std::sync::Arc;

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(u32);

        impl $name {
            /// Creates an id from a position in the mechanism's list.
            pub fn new(index: usize) -> Self {
                // The scene's limits (10,000 links) and memory keep indices far below 2^32.
                $name(u32::try_from(index).unwrap_or(u32::MAX))
            }

            /// Returns the position in the mechanism's list.
            #[inline]
            #[must_use]
            pub fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

pub(crate) use id;

id!(
    /// The id of a point: fixed in the ground, a joint, or riding on a link.
    PointId
);
id!(
    /// The id of a rigid moving link.
    LinkId
);
id!(
    /// The id of a slide: a guide and the pin or link that moves along it.
    SlideId
);

/// A body to which something can be attached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// The fixed frame.
    Ground,
    /// A moving link.
    Link(LinkId),
}

/// A point of the mechanism.
#[derive(Clone, Debug)]
pub struct Point {
    /// The position in the fixed frame, for a ground point.
    pub ground: Option<Vec2>,
    /// The links that carry the point. It is a pin joint with two links, or with one link and the
    /// ground.
    pub links: Vec<LinkId>,
    /// Whether the point is a mark on the ground: it holds nothing, and its coordinates do not
    /// count as lengths.
    pub is_mark: bool,
}

/// A point of a link in the link's own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// The point.
    pub point: PointId,
    /// The local coordinates, in the scene's length unit.
    pub local: Vec2,
    /// The length and angle from which the coordinates follow, for a point given in polar form.
    pub polar: Option<PolarPosition>,
}

/// A rigid link. Its local x axis is its direction.
#[derive(Clone, Debug)]
pub struct Link {
    /// The link's points in the order given, including the centre of mass if there is one.
    pub members: Vec<Member>,
    /// The two natural ends (from, to), for a link that is a vector of the loop equation.
    pub ends: Option<(PointId, PointId)>,
    /// The centre of mass.
    pub com: Option<PointId>,
    /// The mass, in kg.
    pub mass: f64,
    /// The moment of inertia about the centre of mass, in kg m^2.
    pub inertia: f64,
}

impl Link {
    /// Returns the local coordinates of one of the link's points, or `None` if the link does not
    /// carry it.
    #[must_use]
    pub fn local(&self, point: PointId) -> Option<Vec2> {
        self.member(point).map(|m| m.local)
    }

    /// Returns the member for one of the link's points, or `None` if the link does not carry it.
    #[must_use]
    pub fn member(&self, point: PointId) -> Option<&Member> {
        self.members.iter().find(|m| m.point == point)
    }
}

/// The element that moves along a guide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Slider {
    /// A pin in a slot: free to turn.
    Pin(PointId),
    /// A link that does not rotate relative to the guide.
    Link {
        /// The sliding link.
        link: LinkId,
        /// The point at the link's origin, which stays on the guide.
        origin: PointId,
        /// The direction of the link's x axis relative to the guide's direction, in degrees.
        turn: f64,
    },
}

impl Slider {
    /// Returns the point that stays on the guide.
    #[must_use]
    pub fn point(&self) -> PointId {
        match *self {
            Slider::Pin(point) => point,
            Slider::Link { origin, .. } => origin,
        }
    }
}

/// A guide on a body, and the pin or link that slides along it.
///
/// The position along the guide is measured from `through`, positive along `direction`.
#[derive(Clone, Debug)]
pub struct Slide {
    /// The moving element.
    pub slider: Slider,
    /// The body that carries the guide.
    pub on: Body,
    /// A point of the guide, in the frame of `on`.
    pub through: Vec2,
    /// The point of `on` through which the guide was declared to run, if any. The guide moves with
    /// this point.
    pub named: Option<PointId>,
    /// The guide's direction in the frame of `on`, in degrees from its x axis.
    pub angle: f64,
}

impl Slide {
    /// Returns the guide's direction in the frame of `on`, as a unit vector.
    #[must_use]
    pub fn direction(&self) -> Vec2 {
        crate::angle::unit(self.angle)
    }
}

/// The coordinate that the driver imposes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// The direction of a link that turns about a ground point. For a link turned against another
    /// link ([`Builder::turned_from`]), the angle from that link.
    Turn(LinkId),
    /// The position along a slide.
    Push(SlideId),
}

/// The input of the mechanism.
///
/// For a turned link, `start` is in degrees and the rates are in rad/s and rad/s^2. For a pushed
/// slide, `start` is in the scene's length unit and the rates are per s and s^2.
#[derive(Clone, Copy, Debug)]
pub struct Driver {
    /// The driven link or slide.
    pub input: Input,
    /// The coordinate at which the scene opens.
    pub start: f64,
    /// The first time derivative of the coordinate.
    pub speed: f64,
    /// The second time derivative of the coordinate.
    pub acceleration: f64,
}

/// A planar mechanism with one degree of freedom.
///
/// It is immutable and shared: a clone copies no elements.
#[derive(Clone, Debug)]
pub struct Mechanism {
    parts: Arc<Parts>,
}

/// The elements and settings of a mechanism.
#[derive(Clone, Debug)]
struct Parts {
    points: Vec<Point>,
    links: Vec<Link>,
    slides: Vec<Slide>,
    driver: Driver,
    timed: Vec<TimedInput>,
    /// The links that inputs turn against other links, each with that other link.
    turned_from: Vec<(LinkId, LinkId)>,
    start: Vec<(PointId, Vec2)>,
    loads: Vec<Load>,
    limits: Vec<Limit>,
    gravity: Vec2,
    metres: f64,
    misfit: f64,
    decimals: bool,
    rounded: bool,
    converted_rates: bool,
    ranks: name_ranks::NameRanks,
    typed_rates: Option<[Double; 2]>,
}

impl Mechanism {
    /// Creates an empty builder.
    #[must_use]
    pub fn builder() -> Builder {
        Builder::default()
    }

    /// Returns all points, indexed by [`PointId`].
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.parts.points
    }

    /// Returns all links, indexed by [`LinkId`].
    #[must_use]
    pub fn links(&self) -> &[Link] {
        &self.parts.links
    }

    /// Returns all slides, indexed by [`SlideId`].
    #[must_use]
    pub fn slides(&self) -> &[Slide] {
        &self.parts.slides
    }

    /// Returns the driver.
    #[must_use]
    pub fn driver(&self) -> &Driver {
        &self.parts.driver
    }

    /// Returns the approximate start positions of moving points, which select the assembly.
    #[must_use]
    pub fn start(&self) -> &[(PointId, Vec2)] {
        &self.parts.start
    }

    /// Returns the loads.
    #[must_use]
    pub fn loads(&self) -> &[Load] {
        &self.parts.loads
    }

    /// Returns the coordinates limited by stops, indexed by [`LimitId`].
    #[must_use]
    pub fn limits(&self) -> &[Limit] {
        &self.parts.limits
    }

    /// Returns one limit.
    #[must_use]
    pub fn limit(&self, id: LimitId) -> &Limit {
        &self.parts.limits[id.index()]
    }

    /// Returns the ids of all limits.
    pub fn limit_ids(&self) -> impl Iterator<Item = LimitId> + use<> {
        (0..self.parts.limits.len()).map(LimitId::new)
    }

    /// Returns the acceleration of free fall, in m/s^2.
    #[must_use]
    pub fn gravity(&self) -> Vec2 {
        self.parts.gravity
    }

    /// Returns the length unit, in metres.
    #[must_use]
    pub fn metres(&self) -> f64 {
        self.parts.metres
    }

    /// Returns the accepted disagreement of redundant constraints, in the scene's length unit. Zero
    /// accepts rounding errors only.
    #[must_use]
    pub fn misfit(&self) -> f64 {
        self.parts.misfit
    }

    /// Returns `true` if the driver's speed and acceleration were converted from another unit.
    #[must_use]
    pub fn has_converted_rates(&self) -> bool {
        self.parts.converted_rates
    }

    /// Returns `true` if lengths and coordinates mean the decimals as typed, not the nearest
    /// doubles.
    #[must_use]
    pub fn has_decimals(&self) -> bool {
        self.parts.decimals
    }

    /// Returns `true` if all numbers of up to 14 digits are the decimals that they read as, none of
    /// them rounded.
    pub(crate) fn is_typed(&self) -> bool {
        self.parts.decimals && !self.parts.rounded
    }

    /// Returns the driver's speed and acceleration as typed, in double-double, if known.
    pub(crate) fn typed_rates(&self) -> Option<[Double; 2]> {
        self.parts.typed_rates
    }

    /// Returns `true` if a load acts or a link has a mass or an inertia.
    #[must_use]
    pub fn has_forces(&self) -> bool {
        let has_mass = |link: &Link| link.mass > 0.0 || link.inertia > 0.0;
        !self.parts.loads.is_empty() || self.parts.links.iter().any(has_mass)
    }

    /// Returns the joints of a link that transmit a force: pinned to another link or to the ground,
    /// or a pin in a slot.
    pub fn pins(&self, link: LinkId) -> impl Iterator<Item = PointId> + '_ {
        let is_pin = |point: PointId| {
            let given = self.point(point);
            let others = given.links.len() + usize::from(given.ground.is_some());
            let slides = || {
                self.parts
                    .slides
                    .iter()
                    .any(|s| s.slider == Slider::Pin(point))
            };
            others > 1 || slides()
        };
        let members = self.link(link).members.iter().map(|m| m.point);
        members.filter(move |&point| is_pin(point))
    }

    /// Returns the only other body at a pin of a link, or `None` if anything else acts on the pin.
    #[must_use]
    pub fn partner(&self, link: LinkId, point: PointId) -> Option<Body> {
        if self.is_loaded(point) || self.is_guided(point) {
            return None;
        }
        let given = self.point(point);
        let mut others = given.links.iter().filter(|&&other| other != link);
        match (others.next(), others.next(), given.ground) {
            (None, _, Some(_)) => Some(Body::Ground),
            (Some(&other), None, None) => Some(Body::Link(other)),
            _ => None,
        }
    }

    /// Returns `true` if a load acts on the point itself.
    fn is_loaded(&self, point: PointId) -> bool {
        let acts = |load: &Load| match *load {
            Load::Force { point: at, .. } => at == point,
            Load::Spring { from, to, .. } | Load::GasSpring { from, to, .. } => {
                from == point || to == point
            }
            // If a link slides, the press acts on the link.
            Load::Press { slide, .. } => self.slide(slide).slider == Slider::Pin(point),
            Load::Torque { .. } | Load::TorsionSpring { .. } => false,
        };
        self.loads().iter().any(acts)
    }

    /// Returns `true` if a guide acts on the point as a pin in its slot. For a sliding link, the
    /// guide acts on the link instead.
    fn is_guided(&self, point: PointId) -> bool {
        let slides = |slide: &Slide| slide.slider == Slider::Pin(point);
        self.slides().iter().any(slides)
    }

    /// Returns `true` if the whole force on a link at a pin comes from the pin's guides: their
    /// reactions and the effort that drives the pin along them.
    #[must_use]
    pub fn is_guided_alone(&self, point: PointId) -> bool {
        let given = self.point(point);
        let alone = given.links.len() == 1 && given.ground.is_none();
        alone && self.is_guided(point) && !self.is_loaded(point)
    }

    /// Returns `true` if a point belongs to one moving link only: it is no joint, is in no slot,
    /// and no guide is named after it.
    #[must_use]
    pub fn is_free(&self, point: PointId) -> bool {
        let given = self.point(point);
        let slides = |slide: &Slide| slide.slider.point() == point || slide.named == Some(point);
        given.ground.is_none() && given.links.len() == 1 && !self.slides().iter().any(slides)
    }

    /// Returns one point.
    #[must_use]
    pub fn point(&self, id: PointId) -> &Point {
        &self.parts.points[id.index()]
    }

    /// Returns one link.
    #[must_use]
    pub fn link(&self, id: LinkId) -> &Link {
        &self.parts.links[id.index()]
    }

    /// Returns one slide.
    #[must_use]
    pub fn slide(&self, id: SlideId) -> &Slide {
        &self.parts.slides[id.index()]
    }

    /// Returns the polar point of a link after which a guide was named, if any.
    pub(crate) fn polar_through(&self, slide: &Slide) -> Option<&Member> {
        let (Body::Link(link), Some(point)) = (slide.on, slide.named) else {
            return None;
        };
        let member = self.link(link).member(point);
        member.filter(|member| member.polar.is_some())
    }

    /// Returns the ids of all points.
    pub fn point_ids(&self) -> impl Iterator<Item = PointId> + use<> {
        (0..self.parts.points.len()).map(PointId::new)
    }

    /// Returns the ids of all links.
    pub fn link_ids(&self) -> impl Iterator<Item = LinkId> + use<> {
        (0..self.parts.links.len()).map(LinkId::new)
    }

    /// Returns the ids of all slides.
    pub fn slide_ids(&self) -> impl Iterator<Item = SlideId> + use<> {
        (0..self.parts.slides.len()).map(SlideId::new)
    }
}

/// The element that a message refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementId {
    /// A point.
    Point(PointId),
    /// A link.
    Link(LinkId),
    /// A slide.
    Slide(SlideId),
    /// The driver.
    Driver,
}
