//! Builds a mechanism element by element and checks each by itself.

use super::name_ranks::NameRanks;
use super::{
    Body, Defect, Defects, Driver, ElementId, Input, InputTable, Limit, LimitId, LimitOf, Link,
    LinkId, Load, Mechanism, Member, Parts, Point, PointId, PolarPosition, Slide, SlideId, Slider,
    TimedInput,
};
use crate::{Double, Vec2};
use std::collections::HashSet;
use std::sync::Arc;

/// Builds a [`Mechanism`]: see the crate's front page for an example.
///
/// Ids are valid only for the builder that created them. An id from another builder refers to the
/// element with the same index here; a method panics if that index does not exist.
#[derive(Clone, Debug)]
pub struct Builder {
    points: Vec<Point>,
    links: Vec<Link>,
    slides: Vec<Slide>,
    driver: Option<Driver>,
    timed: Vec<TimedInput>,
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
    typed_rates: Option<[Double; 2]>,
}

impl Default for Builder {
    fn default() -> Self {
        Builder {
            points: Vec::new(),
            links: Vec::new(),
            slides: Vec::new(),
            driver: None,
            timed: Vec::new(),
            turned_from: Vec::new(),
            start: Vec::new(),
            loads: Vec::new(),
            limits: Vec::new(),
            gravity: Vec2::ZERO,
            metres: 1.0,
            misfit: 0.0,
            decimals: false,
            rounded: false,
            converted_rates: false,
            typed_rates: None,
        }
    }
}

/// Minimum ratio of a link's length to the longest length: products of four lengths stay normal.
const MIN_LEN: f64 = 1e-75;

impl Builder {
    /// Adds a point fixed in the ground at (x, y).
    pub fn ground_point(&mut self, x: f64, y: f64) -> PointId {
        self.push_point(Some(Vec2::new(x, y)))
    }

    /// Adds a mark at (x, y) on the ground: a position to show and compare with, which holds
    /// nothing.
    pub fn mark(&mut self, x: f64, y: f64) -> PointId {
        let mark = self.ground_point(x, y);
        self.points[mark.index()].is_mark = true;
        mark
    }

    /// Adds a moving point. The links or slides that refer to it determine its position.
    pub fn moving_point(&mut self) -> PointId {
        self.push_point(None)
    }

    fn push_point(&mut self, ground: Option<Vec2>) -> PointId {
        self.points.push(Point {
            ground,
            links: Vec::new(),
            is_mark: false,
        });
        PointId::new(self.points.len() - 1)
    }

    /// Adds a link that runs `from` one point `to` another.
    pub fn link(&mut self, from: PointId, to: PointId, length: f64) -> LinkId {
        let link = self.free_link();
        self.links[link.index()].ends = Some((from, to));
        self.carry(link, from, Vec2::ZERO);
        self.carry(link, to, Vec2::new(length, 0.0));
        link
    }

    /// Adds a link defined by its points alone. Add these with [`Builder::carry`].
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

    /// Attaches a point to a link, at `local` in the link's frame.
    pub fn carry(&mut self, link: LinkId, point: PointId, local: Vec2) {
        let polar = None;
        self.push_member(
            link,
            Member {
                point,
                local,
                polar,
            },
        );
    }

    /// Attaches a point to a link, at a length and angle from another point of the link. The angle
    /// is in degrees, counter-clockwise from the link's x axis.
    ///
    /// `from` of `None` is the origin of the link's frame. Any other point must already belong to
    /// the link; if not, [`Builder::build`] rejects the coordinates as not finite.
    pub fn carry_at(
        &mut self,
        link: LinkId,
        point: PointId,
        from: Option<PointId>,
        (length, angle): (f64, f64),
    ) {
        let before = &self.links[link.index()].members;
        let polar = Some(PolarPosition::new(from, length, angle, before));
        let local = Vec2::ZERO;
        self.push_member(
            link,
            Member {
                point,
                local,
                polar,
            },
        );
    }

    fn push_member(&mut self, link: LinkId, member: Member) {
        self.points[member.point.index()].links.push(link);
        self.links[link.index()].members.push(member);
    }

    /// Adds a link's centre of mass and returns it as a new point of the link.
    pub fn centre_of_mass(&mut self, link: LinkId, local: Vec2) -> PointId {
        let com = self.moving_point();
        self.carry(link, com, local);
        self.links[link.index()].com = Some(com);
        com
    }

    /// Adds a link's centre of mass by a length and an angle, in the form of [`Builder::carry_at`].
    pub fn centre_of_mass_at(
        &mut self,
        link: LinkId,
        from: Option<PointId>,
        place: (f64, f64),
    ) -> PointId {
        let com = self.moving_point();
        self.carry_at(link, com, from, place);
        self.links[link.index()].com = Some(com);
        com
    }

    /// Sets a link's mass in kg and its moment of inertia about the centre of mass in kg m^2.
    pub fn mass(&mut self, link: LinkId, mass: f64, inertia: f64) {
        self.links[link.index()].mass = mass;
        self.links[link.index()].inertia = inertia;
    }

    /// Adds a pin in a slot of `on`. The slot runs through `through` at `angle` degrees, both in
    /// the frame of `on`.
    pub fn pin_in_slot(&mut self, point: PointId, on: Body, through: Vec2, angle: f64) -> SlideId {
        self.push_slide(Slider::Pin(point), on, through, angle)
    }

    /// Adds a link that slides along a guide of `on` without rotating. The link's origin is on the
    /// guide, its x axis at `turn` degrees to it.
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
            .find(|m| m.polar.is_none() && m.local == Vec2::ZERO)
            .map(|m| m.point);
        let origin = at_origin.unwrap_or_else(|| {
            let hidden = self.moving_point();
            self.carry(link, hidden, Vec2::ZERO);
            hidden
        });
        self.push_slide(Slider::Link { link, origin, turn }, on, through, angle)
    }

    fn push_slide(&mut self, slider: Slider, on: Body, through: Vec2, angle: f64) -> SlideId {
        self.slides.push(Slide {
            slider,
            on,
            through,
            named: None,
            angle,
        });
        SlideId::new(self.slides.len() - 1)
    }

    /// Ties a guide to a point of its body, instead of to a fixed position. If the point is moved,
    /// the guide moves with it.
    pub fn named_through(&mut self, slide: SlideId, point: PointId) {
        self.slides[slide.index()].named = Some(point);
    }

    /// Sets the driver.
    pub fn driver(&mut self, driver: Driver) {
        self.driver = Some(driver);
    }

    /// Adds an input that follows the driver. Returns the limit that ends the motion where an open
    /// table ends.
    pub fn timed(&mut self, input: TimedInput) -> Option<LimitId> {
        let open = input.table().filter(|table| table.period().is_none());
        let ends = open.map(InputTable::ends);
        let of = LimitOf::Table(input.input);
        self.timed.push(input);
        ends.map(|[low, high]| self.limit(Limit { of, low, high }))
    }

    /// Measures a turned link's input angle from another link instead of the ground: the motor is
    /// mounted on that link.
    pub fn turned_from(&mut self, link: LinkId, from: LinkId) {
        self.turned_from.push((link, from));
    }

    /// Adds an approximate start position of a moving point.
    pub fn start(&mut self, point: PointId, near: Vec2) {
        self.start.push((point, near));
    }

    /// Adds a load.
    pub fn load(&mut self, load: Load) {
        self.loads.push(load);
    }

    /// Adds a limit: a coordinate bounded by two stops.
    pub fn limit(&mut self, limit: Limit) -> LimitId {
        self.limits.push(limit);
        LimitId::new(self.limits.len() - 1)
    }

    /// Sets the acceleration of free fall in m/s^2.
    pub fn gravity(&mut self, gravity: Vec2) {
        self.gravity = gravity;
    }

    /// Sets the length unit, in metres. The default is 1. Only forces need it.
    pub fn metres(&mut self, metres: f64) {
        self.metres = metres;
    }

    /// Sets the accepted disagreement of redundant constraints, in the length unit, for drawings of
    /// few digits. The default is 0.
    pub fn misfit(&mut self, misfit: f64) {
        self.misfit = misfit;
    }

    /// Declares that lengths and coordinates were typed as decimals. A number of up to 15 digits
    /// then means the decimal, not the nearest double.
    ///
    /// This matters where lengths are compared, see
    /// [`Motion::tolerance`](crate::solver::Motion::tolerance). Error bounds take numbers of up to
    /// 14 digits as exact decimals; longer ones count as rounded.
    pub fn decimals(&mut self) {
        self.decimals = true;
    }

    /// Declares that a number which reads as a decimal of up to 14 digits was rounded from another
    /// one. Error bounds then cover half an ulp of every number.
    pub fn rounded(&mut self) {
        self.rounded = true;
    }

    /// Sets the driver's speed and acceleration as typed, in double-double. Error bounds then
    /// account for the digits that the doubles leave out.
    pub fn typed_rates(&mut self, rates: [Double; 2]) {
        self.typed_rates = Some(rates);
    }

    /// Declares that the driver's speed and acceleration were converted from another unit. Error
    /// bounds then cover the rounding error of the conversion.
    pub fn converted_rates(&mut self) {
        self.converted_rates = true;
    }

    /// Checks every element by itself and builds the mechanism.
    ///
    /// # Errors
    /// All defects found, in the order of the elements.
    pub fn build(mut self) -> Result<Mechanism, Defects> {
        self.compute_polar_points();
        let defects = self.defects();
        match self.driver {
            Some(driver) if defects.is_empty() => Ok(Mechanism {
                parts: Arc::new(Parts {
                    points: self.points,
                    links: self.links,
                    slides: self.slides,
                    driver,
                    timed: self.timed,
                    turned_from: self.turned_from,
                    start: self.start,
                    loads: self.loads,
                    limits: self.limits,
                    gravity: self.gravity,
                    metres: self.metres,
                    misfit: self.misfit,
                    decimals: self.decimals,
                    rounded: self.rounded,
                    converted_rates: self.converted_rates,
                    ranks: NameRanks::default(),
                    typed_rates: self.typed_rates,
                }),
            }),
            _ => Err(Defects { list: defects }),
        }
    }

    /// Computes the coordinates given by lengths and angles. This waits for `build`, when it is
    /// known whether numbers mean decimals.
    fn compute_polar_points(&mut self) {
        for link in &mut self.links {
            link.compute_polar_points(self.decimals);
        }
        for slide in &mut self.slides {
            let (Body::Link(on), Some(named)) = (slide.on, slide.named) else {
                continue;
            };
            let named = self.links[on.index()].member(named);
            if let Some(member) = named.filter(|member| member.polar.is_some()) {
                slide.through = member.local;
            }
        }
    }

    fn defects(&self) -> Vec<Defect> {
        let mut found = Vec::new();
        self.check_points(&mut found);
        for (i, link) in self.links.iter().enumerate() {
            check_link(LinkId::new(i), link, &mut found);
        }
        self.check_proportions(&mut found);
        self.check_slides(&mut found);
        self.check_driver(&mut found);
        let is_unit = self.metres > 0.0 && self.metres.is_finite();
        let on_ground = |load: &Load| match load {
            Load::Press { slide, .. } => self.slides[slide.index()].on == Body::Ground,
            Load::Force { .. }
            | Load::Torque { .. }
            | Load::Spring { .. }
            | Load::GasSpring { .. }
            | Load::TorsionSpring { .. } => true,
        };
        let are_sound = self.loads.iter().all(|l| l.is_valid() && on_ground(l));
        if !(are_sound && self.gravity.is_finite() && is_unit) {
            found.push(Defect::Load);
        }
        let input = self.driver.map(|driver| driver.input);
        let unsound = self
            .limits
            .iter()
            .zip(0..)
            .filter(|(l, _)| !l.is_valid(input));
        found.extend(unsound.map(|(_, i)| Defect::Limit {
            limit: LimitId::new(i),
        }));
        // Negated so that NaN is rejected too.
        if !(self.misfit >= 0.0 && self.misfit.is_finite()) {
            found.push(Defect::RateError);
        }
        found
    }

    fn check_points(&self, found: &mut Vec<Defect>) {
        for (i, point) in self.points.iter().enumerate() {
            let id = PointId::new(i);
            if point.ground.is_some_and(|p| !p.is_finite()) {
                let of = ElementId::Point(id);
                found.push(Defect::Coordinates { of });
            }
            let slides = || self.slides.iter().any(|s| s.slider.point() == id);
            if point.ground.is_none() && point.links.is_empty() && !slides() {
                found.push(Defect::Stray { point: id });
            }
        }
        for &(point, near) in &self.start {
            if !near.is_finite() {
                let of = ElementId::Point(point);
                found.push(Defect::Coordinates { of });
            }
        }
    }

    /// Compares the shortest link with the longest length. Lengths that are not finite have a
    /// defect of their own.
    fn check_proportions(&self, found: &mut Vec<Defect>) {
        let origin = self.points.iter().find_map(|point| point.ground);
        let origin = origin.unwrap_or_default();
        let ground = self.points.iter().filter_map(|point| point.ground);
        let guides = self.slides.iter().map(|slide| match slide.on {
            Body::Ground => slide.through - origin,
            Body::Link(_) => slide.through,
        });
        let members = self.links.iter().flat_map(reaches).map(|(_, reach)| reach);
        let places = ground.map(|position| position - origin).chain(guides);
        let lengths = places.map(Vec2::norm).chain(members);
        let longest = lengths.fold(0.0, f64::max);
        let links = (0..self.links.len()).map(LinkId::new);
        let arms = links.flat_map(|id| {
            let link = &self.links[id.index()];
            let arms =
                reaches(link).filter(|&(point, reach)| Some(point) != link.com && reach > 0.0);
            arms.map(move |(_, reach)| (id, reach))
        });
        if let Some((link, length)) = arms.min_by(|a, b| a.1.total_cmp(&b.1))
            && longest.is_finite()
            && length < MIN_LEN * longest
        {
            found.push(Defect::Proportion {
                link,
                length,
                longest,
            });
        }
    }

    fn check_slides(&self, found: &mut Vec<Defect>) {
        for (i, slide) in self.slides.iter().enumerate() {
            let id = SlideId::new(i);
            let turn = match slide.slider {
                Slider::Pin(_) => 0.0,
                Slider::Link { turn, .. } => turn,
            };
            if !(slide.through.is_finite() && slide.angle.is_finite() && turn.is_finite()) {
                let of = ElementId::Slide(id);
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
        if let (Input::Turn(link), false) = (driver.input, self.has_pivot(driver.input)) {
            found.push(Defect::NoPivot { link });
        }
        let mut driven = vec![driver.input];
        for timed in &self.timed {
            timed.check(driver.input, self.has_pivot(timed.input), found);
            if driven.contains(&timed.input) {
                let of = timed.input.element();
                found.push(Defect::DrivenTwice { of });
            }
            driven.push(timed.input);
        }
        for &(link, from) in &self.turned_from {
            if link == from {
                found.push(Defect::TurnedFromItself { link });
            }
        }
    }

    /// Returns `true` if the input needs no ground pivot or the moved link has one.
    fn has_pivot(&self, input: Input) -> bool {
        let on_ground = |m: &Member| self.points[m.point.index()].ground.is_some();
        match input {
            Input::Turn(link) => {
                self.turned_from.iter().any(|(turned, _)| *turned == link)
                    || self.links[link.index()].members.iter().any(on_ground)
            }
            Input::Push(_) => true,
        }
    }
}

/// Returns the distance of each point of a link from the link's first point.
fn reaches(link: &Link) -> impl Iterator<Item = (PointId, f64)> + '_ {
    let first = link.members.first().map_or(Vec2::ZERO, |m| m.local);
    let members = link.members.iter();
    members.map(move |member| (member.point, (member.local - first).norm()))
}

fn check_link(id: LinkId, link: &Link, found: &mut Vec<Defect>) {
    if link.members.is_empty() {
        found.push(Defect::Empty { link: id });
    }
    if let (Some(_), [_, to, ..]) = (link.ends, link.members.as_slice()) {
        let length = to.local.x;
        // Negated so that NaN is rejected too.
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
        let of = ElementId::Link(id);
        found.push(Defect::Coordinates { of });
    }
    let mut carried = HashSet::new();
    for &Member { point, .. } in &link.members {
        if !carried.insert(point) {
            found.push(Defect::Twice { link: id, point });
        }
    }
    // Written so that NaN is rejected too.
    let fits = |v: f64| v >= 0.0 && v.is_finite();
    if !(fits(link.mass) && fits(link.inertia)) {
        found.push(Defect::Mass { link: id });
    } else if link.com.is_none() && (link.mass > 0.0 || link.inertia > 0.0) {
        found.push(Defect::NoCentre { link: id });
    }
}
