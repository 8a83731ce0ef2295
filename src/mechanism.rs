//! The mechanism: points, links, slides and the driver, by typed ids. No names, no text, no I/O.
//!
//! A [`Mechanism`] is immutable; [`Builder::build`] checks once what each element must be by itself
//! (lengths, coordinates, references). What the elements are together - mobility, groups, whether
//! the loops close - is the solver's to say.

use crate::Vec2;
use std::collections::HashSet;
use thiserror::Error;

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(u32);

        impl $name {
            pub(crate) fn new(index: usize) -> Self {
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
}

/// A point of a link in the link's own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// The point.
    pub point: PointId,
    /// Its local coordinates, in the scene's length unit.
    pub local: Vec2,
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
        self.members
            .iter()
            .find(|m| m.point == point)
            .map(|m| m.local)
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
        /// The direction of the link's x axis as seen from the guide's: a unit vector.
        turn: Vec2,
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
    /// The guide's direction in the frame of `on`: a unit vector.
    pub direction: Vec2,
}

/// The coordinate that the driver imposes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// The direction of a link that turns about a ground point.
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

/// A load, kept for the balance of forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// A force in N at a point, constant in the ground frame.
    Force {
        /// Where it acts.
        point: PointId,
        /// Its components.
        force: Vec2,
    },
    /// A torque in N m on a link, counter-clockwise.
    Torque {
        /// The loaded link.
        link: LinkId,
        /// Its size.
        torque: f64,
    },
}

/// A planar mechanism with one input.
#[derive(Clone, Debug)]
pub struct Mechanism {
    points: Vec<Point>,
    links: Vec<Link>,
    slides: Vec<Slide>,
    driver: Driver,
    start: Vec<(PointId, Vec2)>,
    loads: Vec<Load>,
    gravity: Vec2,
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
        &self.points
    }

    /// All links, by [`LinkId`].
    #[must_use]
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// All slides, by [`SlideId`].
    #[must_use]
    pub fn slides(&self) -> &[Slide] {
        &self.slides
    }

    /// The driver.
    #[must_use]
    pub fn driver(&self) -> &Driver {
        &self.driver
    }

    /// Rough positions of moving points at the opening; they choose the assembly.
    #[must_use]
    pub fn start(&self) -> &[(PointId, Vec2)] {
        &self.start
    }

    /// The loads.
    #[must_use]
    pub fn loads(&self) -> &[Load] {
        &self.loads
    }

    /// The acceleration of free fall in m/s^2.
    #[must_use]
    pub fn gravity(&self) -> Vec2 {
        self.gravity
    }

    /// One point.
    #[must_use]
    pub fn point(&self, id: PointId) -> &Point {
        &self.points[id.index()]
    }

    /// One link.
    #[must_use]
    pub fn link(&self, id: LinkId) -> &Link {
        &self.links[id.index()]
    }

    /// One slide.
    #[must_use]
    pub fn slide(&self, id: SlideId) -> &Slide {
        &self.slides[id.index()]
    }

    /// The ids of all points.
    pub fn point_ids(&self) -> impl Iterator<Item = PointId> + use<> {
        (0..self.points.len()).map(PointId::new)
    }

    /// The ids of all links.
    pub fn link_ids(&self) -> impl Iterator<Item = LinkId> + use<> {
        (0..self.links.len()).map(LinkId::new)
    }

    /// The ids of all slides.
    pub fn slide_ids(&self) -> impl Iterator<Item = SlideId> + use<> {
        (0..self.slides.len()).map(SlideId::new)
    }
}

/// What is wrong with one element of a mechanism, found by [`Builder::build`].
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Defect {
    /// A link of no length, or with a length that is no positive number.
    #[error("the length must be a positive number, not {length}")]
    Length {
        /// The link.
        link: LinkId,
        /// The length given.
        length: f64,
    },
    /// A coordinate of a ground point, a member, a guide or a start that is not finite.
    #[error("the coordinates must be finite numbers")]
    Coordinates {
        /// Whose.
        of: Element,
    },
    /// The same point twice in one link.
    #[error("the point stands twice in the link")]
    Twice {
        /// The link.
        link: LinkId,
        /// The point.
        point: PointId,
    },
    /// A link without a point.
    #[error("the link has no point")]
    Empty {
        /// The link.
        link: LinkId,
    },
    /// A point on neither the ground, nor a link, nor a slide.
    #[error("the point belongs to no link, no slide and not to the ground")]
    Stray {
        /// The point.
        point: PointId,
    },
    /// A slide of a link on itself, or of a point that the guide's body carries.
    #[error("nothing can slide on itself")]
    OnItself {
        /// The slide.
        slide: SlideId,
    },
    /// A driven link without a ground point to turn about.
    #[error("the driven link has no ground point to turn about")]
    NoPivot {
        /// The link.
        link: LinkId,
    },
    /// A driver coordinate or rate that is not finite.
    #[error("the driver's coordinate, speed and acceleration must be finite numbers")]
    Driver,
    /// No driver was set.
    #[error("there is no driver")]
    NoDriver,
    /// A mass or an inertia that is negative or not finite.
    #[error("mass and inertia must be finite and not negative")]
    Mass {
        /// The link.
        link: LinkId,
    },
    /// A mass without a centre.
    #[error("a mass needs a centre of mass")]
    NoCentre {
        /// The link.
        link: LinkId,
    },
    /// A load or the gravity that is not finite.
    #[error("loads and gravity must be finite")]
    Load,
}

/// An element of a mechanism that a message is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A point.
    Point(PointId),
    /// A link.
    Link(LinkId),
    /// A slide.
    Slide(SlideId),
    /// The driver.
    Driver,
}

/// Builds a [`Mechanism`]: see the crate's front page for an example.
///
/// Ids belong to the builder that gave them. Those of another name whatever stands at their place
/// here, and a method given one that has no such place panics.
#[derive(Clone, Debug, Default)]
pub struct Builder {
    points: Vec<Point>,
    links: Vec<Link>,
    slides: Vec<Slide>,
    driver: Option<Driver>,
    start: Vec<(PointId, Vec2)>,
    loads: Vec<Load>,
    gravity: Vec2,
}

impl Builder {
    /// A point fixed in the ground at (x, y).
    pub fn ground_point(&mut self, x: f64, y: f64) -> PointId {
        self.push_point(Some(Vec2::new(x, y)))
    }

    /// A point that moves: links or slides that name it give it its place.
    pub fn moving_point(&mut self) -> PointId {
        self.push_point(None)
    }

    fn push_point(&mut self, ground: Option<Vec2>) -> PointId {
        self.points.push(Point {
            ground,
            links: Vec::new(),
        });
        PointId::new(self.points.len() - 1)
    }

    /// A link that runs `from` one point `to` another.
    pub fn link(&mut self, from: PointId, to: PointId, length: f64) -> LinkId {
        let link = self.free_link();
        self.links[link.index()].ends = Some((from, to));
        self.carry(link, from, Vec2::ZERO);
        self.carry(link, to, Vec2::new(length, 0.0));
        link
    }

    /// A link that is given by its points alone: add them with [`Builder::carry`].
    pub fn free_link(&mut self) -> LinkId {
        self.links.push(Link {
            members: Vec::new(),
            ends: None,
            com: None,
            mass: 0.0,
            inertia: 0.0,
        });
        LinkId::new(self.links.len() - 1)
    }

    /// Puts a point on a link, at `local` in the link's frame.
    pub fn carry(&mut self, link: LinkId, point: PointId, local: Vec2) {
        self.links[link.index()]
            .members
            .push(Member { point, local });
        self.points[point.index()].links.push(link);
    }

    /// Gives a link its centre of mass; the returned point rides on the link.
    pub fn centre_of_mass(&mut self, link: LinkId, local: Vec2) -> PointId {
        let com = self.moving_point();
        self.carry(link, com, local);
        self.links[link.index()].com = Some(com);
        com
    }

    /// Gives a link its mass in kg and its moment of inertia about the centre of mass in kg m^2.
    pub fn mass(&mut self, link: LinkId, mass: f64, inertia: f64) {
        self.links[link.index()].mass = mass;
        self.links[link.index()].inertia = inertia;
    }

    /// A pin in a slot of `on`: the slot runs through `through` at `angle` degrees, both in the
    /// frame of `on`.
    pub fn pin_in_slot(&mut self, point: PointId, on: Body, through: Vec2, angle: f64) -> SlideId {
        self.push_slide(Slider::Pin(point), on, through, angle)
    }

    /// A link that slides along a guide of `on` without turning: its origin on the guide, its x axis
    /// at `turn` degrees to it.
    pub fn sliding_link(
        &mut self,
        link: LinkId,
        turn: f64,
        on: Body,
        through: Vec2,
        angle: f64,
    ) -> SlideId {
        let at_origin = self.links[link.index()]
            .members
            .iter()
            .find(|m| m.local == Vec2::ZERO)
            .map(|m| m.point);
        let origin = at_origin.unwrap_or_else(|| {
            let hidden = self.moving_point();
            self.carry(link, hidden, Vec2::ZERO);
            hidden
        });
        let turn = crate::angle::unit(turn);
        self.push_slide(Slider::Link { link, origin, turn }, on, through, angle)
    }

    fn push_slide(&mut self, slider: Slider, on: Body, through: Vec2, angle: f64) -> SlideId {
        self.slides.push(Slide {
            slider,
            on,
            through,
            direction: crate::angle::unit(angle),
        });
        SlideId::new(self.slides.len() - 1)
    }

    /// Sets the driver.
    pub fn driver(&mut self, driver: Driver) {
        self.driver = Some(driver);
    }

    /// A rough position of a moving point at the opening.
    pub fn start(&mut self, point: PointId, near: Vec2) {
        self.start.push((point, near));
    }

    /// Adds a load.
    pub fn load(&mut self, load: Load) {
        self.loads.push(load);
    }

    /// Sets the acceleration of free fall in m/s^2.
    pub fn gravity(&mut self, gravity: Vec2) {
        self.gravity = gravity;
    }

    /// Checks every element by itself.
    ///
    /// # Errors
    /// All defects found, in the order of the elements.
    pub fn build(self) -> Result<Mechanism, Vec<Defect>> {
        let defects = self.defects();
        match self.driver {
            Some(driver) if defects.is_empty() => Ok(Mechanism {
                points: self.points,
                links: self.links,
                slides: self.slides,
                driver,
                start: self.start,
                loads: self.loads,
                gravity: self.gravity,
            }),
            _ => Err(defects),
        }
    }

    fn defects(&self) -> Vec<Defect> {
        let mut found = Vec::new();
        self.check_points(&mut found);
        for (i, link) in self.links.iter().enumerate() {
            check_link(LinkId::new(i), link, &mut found);
        }
        self.check_slides(&mut found);
        self.check_driver(&mut found);
        let loads_finite = self.loads.iter().all(|load| match *load {
            Load::Force { force, .. } => force.is_finite(),
            Load::Torque { torque, .. } => torque.is_finite(),
        });
        if !(loads_finite && self.gravity.is_finite()) {
            found.push(Defect::Load);
        }
        found
    }

    fn check_points(&self, found: &mut Vec<Defect>) {
        for (i, point) in self.points.iter().enumerate() {
            let id = PointId::new(i);
            if point.ground.is_some_and(|p| !p.is_finite()) {
                let of = Element::Point(id);
                found.push(Defect::Coordinates { of });
            }
            let slides = || self.slides.iter().any(|s| s.slider.point() == id);
            if point.ground.is_none() && point.links.is_empty() && !slides() {
                found.push(Defect::Stray { point: id });
            }
        }
        for &(point, near) in &self.start {
            if !near.is_finite() {
                let of = Element::Point(point);
                found.push(Defect::Coordinates { of });
            }
        }
    }

    fn check_slides(&self, found: &mut Vec<Defect>) {
        for (i, slide) in self.slides.iter().enumerate() {
            let id = SlideId::new(i);
            if !(slide.through.is_finite() && slide.direction.is_finite()) {
                let of = Element::Slide(id);
                found.push(Defect::Coordinates { of });
            }
            let carried = match slide.on {
                Body::Ground => self.points[slide.slider.point().index()].ground.is_some(),
                Body::Link(on) => {
                    let point = &self.points[slide.slider.point().index()];
                    point.links.contains(&on)
                }
            };
            if carried {
                found.push(Defect::OnItself { slide: id });
            }
        }
    }

    fn check_driver(&self, found: &mut Vec<Defect>) {
        let Some(driver) = self.driver else {
            found.push(Defect::NoDriver);
            return;
        };
        let rates = [driver.start, driver.speed, driver.acceleration];
        if !rates.iter().all(|v| v.is_finite()) {
            found.push(Defect::Driver);
        }
        if let Input::Turn(link) = driver.input {
            let on_ground = |m: &Member| self.points[m.point.index()].ground.is_some();
            if !self.links[link.index()].members.iter().any(on_ground) {
                found.push(Defect::NoPivot { link });
            }
        }
    }
}

fn check_link(id: LinkId, link: &Link, found: &mut Vec<Defect>) {
    if link.members.is_empty() {
        found.push(Defect::Empty { link: id });
    }
    if let (Some(_), [_, to, ..]) = (link.ends, link.members.as_slice()) {
        let length = to.local.x;
        // Written so that NaN is refused too.
        if !(length > 0.0 && length.is_finite()) {
            found.push(Defect::Length { link: id, length });
        }
    }
    let further = if link.ends.is_some() { 2 } else { 0 };
    if !link
        .members
        .iter()
        .skip(further)
        .all(|m| m.local.is_finite())
    {
        let of = Element::Link(id);
        found.push(Defect::Coordinates { of });
    }
    let mut carried = HashSet::new();
    for &Member { point, .. } in &link.members {
        if !carried.insert(point) {
            found.push(Defect::Twice { link: id, point });
        }
    }
    // Written so that NaN is refused too.
    let fits = |v: f64| v >= 0.0 && v.is_finite();
    if !(fits(link.mass) && fits(link.inertia)) {
        found.push(Defect::Mass { link: id });
    } else if link.com.is_none() && (link.mass > 0.0 || link.inertia > 0.0) {
        found.push(Defect::NoCentre { link: id });
    }
}
