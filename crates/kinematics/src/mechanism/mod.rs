//! The mechanism: points, links, slides and the driver, by typed ids. No names, no text, no I/O.
//!
//! A [`Mechanism`] is immutable; [`Builder::build`] checks once what each element must be by itself
//! (lengths, coordinates, references). What the elements are together - mobility, groups, whether
//! the loops close - is the solver's to say.

mod builder;
mod defect;
mod input_table;
mod inputs;
mod law;
mod lengths;
mod limit;
mod load;
mod polar;
mod ranks;
mod spline;
mod tolerances;

pub use builder::Builder;
pub use defect::{Defect, Defects};
pub use input_table::InputTable;
pub(crate) use inputs::fraction;
pub use inputs::{InputLaw, TimedInput};
pub use law::{DriverMoment, MotionLaw, MotionPeaks, StepLaw, TimedStep};
pub use lengths::{CoordinateAxis, Length};
pub use limit::MOST_TURNS;
pub use limit::{Limit, LimitId, LimitOf};
pub use load::{Load, Profile, StrokeEnd};
pub use polar::PolarPlace;
pub use polar::seen_from;
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

            /// The position in the mechanism's list.
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
    /// A point: fixed in the ground, a joint, or riding on a link.
    PointId
);
id!(
    /// A rigid moving link.
    LinkId
);
id!(
    /// A slide: a guide and what moves along it.
    SlideId
);

/// What something can be attached to.
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
    /// Its place in the fixed frame, if it is a ground point.
    pub ground: Option<Vec2>,
    /// The links that carry it: a pin joint if there are two, or one and the ground.
    pub links: Vec<LinkId>,
    /// Whether it is a mark on the ground: nothing is held there, and its coordinates are no lengths.
    pub is_mark: bool,
}

/// A point of a link in the link's own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// The point.
    pub point: PointId,
    /// Its local coordinates, in the scene's length unit.
    pub local: Vec2,
    /// The length and the angle that it was given by, if it was: the coordinates follow from these.
    pub polar: Option<PolarPlace>,
}

/// A rigid link. Its local x axis is its direction.
#[derive(Clone, Debug)]
pub struct Link {
    /// Its points, in the order given; the centre of mass among them if there is one.
    pub members: Vec<Member>,
    /// The two natural ends (from, to) of a link that is a vector of the loop equation.
    pub ends: Option<(PointId, PointId)>,
    /// The centre of mass.
    pub com: Option<PointId>,
    /// Mass in kg.
    pub mass: f64,
    /// Moment of inertia about the centre of mass in kg m^2.
    pub inertia: f64,
}

impl Link {
    /// The local coordinates of one of the link's points.
    #[must_use]
    pub fn local(&self, point: PointId) -> Option<Vec2> {
        self.member(point).map(|m| m.local)
    }

    /// One of the link's points, with all that is known of its place.
    #[must_use]
    pub fn member(&self, point: PointId) -> Option<&Member> {
        self.members.iter().find(|m| m.point == point)
    }
}

/// What moves along a guide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Slider {
    /// A pin in a slot: free to turn.
    Pin(PointId),
    /// A link that does not turn against the guide.
    Link {
        /// The sliding link.
        link: LinkId,
        /// The point at the link's origin, which stays on the guide.
        origin: PointId,
        /// The direction of the link's x axis as seen from the guide's, in degrees.
        turn: f64,
    },
}

impl Slider {
    /// The point that stays on the guide.
    #[must_use]
    pub fn point(&self) -> PointId {
        match *self {
            Slider::Pin(point) => point,
            Slider::Link { origin, .. } => origin,
        }
    }
}

/// A guide on a body, and what slides along it.
///
/// The position along the guide is counted from `through`, positive along `direction`.
#[derive(Clone, Debug)]
pub struct Slide {
    /// What moves.
    pub slider: Slider,
    /// The body that carries the guide.
    pub on: Body,
    /// A point of the guide, in the frame of `on`.
    pub through: Vec2,
    /// The point of `on` that `through` was named after, if it was: where that point lies, the guide
    /// runs.
    pub named: Option<PointId>,
    /// The guide's direction in the frame of `on`, in degrees from its x axis.
    pub angle: f64,
}

impl Slide {
    /// The guide's direction in the frame of `on`: a unit vector.
    #[must_use]
    pub fn direction(&self) -> Vec2 {
        crate::angle::unit(self.angle)
    }
}

/// The coordinate that the driver imposes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// The direction of a link that turns about a ground point; of one that is turned against another link
    /// ([`Builder::turned_from`]), its angle from that.
    Turn(LinkId),
    /// The position along a slide.
    Push(SlideId),
}

/// The input of the mechanism.
///
/// A turned link counts in degrees for `start`, rad/s and rad/s^2 for the rates; a pushed slide in
/// the scene's length unit, per s and s^2.
#[derive(Clone, Copy, Debug)]
pub struct Driver {
    /// What is driven.
    pub input: Input,
    /// The coordinate at which the scene opens.
    pub start: f64,
    /// Its rate.
    pub speed: f64,
    /// The rate of its rate.
    pub acceleration: f64,
}

/// A planar mechanism that moves by one coordinate.
///
/// It never changes, and is shared by whoever holds it: a clone copies no elements.
#[derive(Clone, Debug)]
pub struct Mechanism {
    parts: Arc<Parts>,
}

/// What a mechanism consists of.
#[derive(Clone, Debug)]
struct Parts {
    points: Vec<Point>,
    links: Vec<Link>,
    slides: Vec<Slide>,
    driver: Driver,
    timed: Vec<TimedInput>,
    /// The links that inputs turn against others, and these.
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
    ranks: ranks::NameRanks,
    typed_rates: Option<[Double; 2]>,
}

impl Mechanism {
    /// Begins a mechanism in code.
    #[must_use]
    pub fn builder() -> Builder {
        Builder::default()
    }

    /// All points, by [`PointId`].
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.parts.points
    }

    /// All links, by [`LinkId`].
    #[must_use]
    pub fn links(&self) -> &[Link] {
        &self.parts.links
    }

    /// All slides, by [`SlideId`].
    #[must_use]
    pub fn slides(&self) -> &[Slide] {
        &self.parts.slides
    }

    /// The driver.
    #[must_use]
    pub fn driver(&self) -> &Driver {
        &self.parts.driver
    }

    /// Rough positions of moving points at the opening; they choose the assembly.
    #[must_use]
    pub fn start(&self) -> &[(PointId, Vec2)] {
        &self.parts.start
    }

    /// The loads.
    #[must_use]
    pub fn loads(&self) -> &[Load] {
        &self.parts.loads
    }

    /// The coordinates that stay between stops, by [`LimitId`].
    #[must_use]
    pub fn limits(&self) -> &[Limit] {
        &self.parts.limits
    }

    /// One of them.
    #[must_use]
    pub fn limit(&self, id: LimitId) -> &Limit {
        &self.parts.limits[id.index()]
    }

    /// The ids of all limits.
    pub fn limit_ids(&self) -> impl Iterator<Item = LimitId> + use<> {
        (0..self.parts.limits.len()).map(LimitId::new)
    }

    /// The acceleration of free fall in m/s^2.
    #[must_use]
    pub fn gravity(&self) -> Vec2 {
        self.parts.gravity
    }

    /// The metres of the unit of its lengths.
    #[must_use]
    pub fn metres(&self) -> f64 {
        self.parts.metres
    }

    /// By how much constraints that repeat others may disagree with them, in the scene's length unit: 0
    /// where they may by rounding alone.
    #[must_use]
    pub fn misfit(&self) -> f64 {
        self.parts.misfit
    }

    /// Whether its driver's speed and acceleration were given in another unit and converted.
    #[must_use]
    pub fn has_converted_rates(&self) -> bool {
        self.parts.converted_rates
    }

    /// Whether its lengths and coordinates stand for the decimals that they were typed as.
    #[must_use]
    pub fn has_decimals(&self) -> bool {
        self.parts.decimals
    }

    /// Whether all its numbers of up to 14 digits are the decimals that they read as: none was rounded to one.
    pub(crate) fn is_typed(&self) -> bool {
        self.parts.decimals && !self.parts.rounded
    }

    /// The driver's speed and acceleration as they were typed, in twice the digits, where that is known.
    pub(crate) fn typed_rates(&self) -> Option<[Double; 2]> {
        self.parts.typed_rates
    }

    /// Whether anything acts on it: a load, a weight, or what resists being accelerated.
    #[must_use]
    pub fn has_forces(&self) -> bool {
        let has_mass = |link: &Link| link.mass > 0.0 || link.inertia > 0.0;
        !self.parts.loads.is_empty() || self.parts.links.iter().any(has_mass)
    }

    /// The joints of a link that a force can pass: pinned to another link or to the ground, or with a
    /// pin that slides.
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

    /// The only other body at a pin of a link, where nothing but the two acts on the pin.
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

    /// Whether a load acts on a point itself.
    fn is_loaded(&self, point: PointId) -> bool {
        let acts = |load: &Load| match *load {
            Load::Force { point: at, .. } => at == point,
            Load::Spring { from, to, .. } | Load::GasSpring { from, to, .. } => {
                from == point || to == point
            }
            // Of a link that slides it presses on the link.
            Load::Press { slide, .. } => self.slide(slide).slider == Slider::Pin(point),
            Load::Torque { .. } | Load::TorsionSpring { .. } => false,
        };
        self.loads().iter().any(acts)
    }

    /// Whether a guide presses on a point, as on the pin in its slot; of a link that slides it holds the link.
    fn is_guided(&self, point: PointId) -> bool {
        let slides = |slide: &Slide| slide.slider == Slider::Pin(point);
        self.slides().iter().any(slides)
    }

    /// Whether all that a link feels at a pin comes from the guides that the pin slides along: what these bear, and
    /// what drives it along them, is that force.
    #[must_use]
    pub fn is_guided_alone(&self, point: PointId) -> bool {
        let given = self.point(point);
        let alone = given.links.len() == 1 && given.ground.is_none();
        alone && self.is_guided(point) && !self.is_loaded(point)
    }

    /// Whether a point is of one moving link alone: no joint, not in a slot, and no guide runs through it because it is
    /// there.
    #[must_use]
    pub fn is_free(&self, point: PointId) -> bool {
        let given = self.point(point);
        let slides = |slide: &Slide| slide.slider.point() == point || slide.named == Some(point);
        given.ground.is_none() && given.links.len() == 1 && !self.slides().iter().any(slides)
    }

    /// One point.
    #[must_use]
    pub fn point(&self, id: PointId) -> &Point {
        &self.parts.points[id.index()]
    }

    /// One link.
    #[must_use]
    pub fn link(&self, id: LinkId) -> &Link {
        &self.parts.links[id.index()]
    }

    /// One slide.
    #[must_use]
    pub fn slide(&self, id: SlideId) -> &Slide {
        &self.parts.slides[id.index()]
    }

    /// The point by length and angle that a guide on a link was named after, if it was.
    pub(crate) fn polar_through(&self, slide: &Slide) -> Option<&Member> {
        let (Body::Link(link), Some(point)) = (slide.on, slide.named) else {
            return None;
        };
        let member = self.link(link).member(point);
        member.filter(|member| member.polar.is_some())
    }

    /// The ids of all points.
    pub fn point_ids(&self) -> impl Iterator<Item = PointId> + use<> {
        (0..self.parts.points.len()).map(PointId::new)
    }

    /// The ids of all links.
    pub fn link_ids(&self) -> impl Iterator<Item = LinkId> + use<> {
        (0..self.parts.links.len()).map(LinkId::new)
    }

    /// The ids of all slides.
    pub fn slide_ids(&self) -> impl Iterator<Item = SlideId> + use<> {
        (0..self.parts.slides.len()).map(SlideId::new)
    }
}

/// An element of a mechanism that a message is about.
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
