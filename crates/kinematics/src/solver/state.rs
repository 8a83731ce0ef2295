//! Holds the result of a solve: kinematic coefficients inside, values in the scene's units outside.

use super::Order;
use super::forces::ForceState;
use super::frame::Frame;
use super::plan::pruning::Marks;
use crate::{Constant, LinkId, Number, PointId, SlideId, Vec2};
use std::sync::Arc;

/// If the square of the sine of a transmission angle is not above this limit, doubles lose three
/// digits of a position and six of its rates.
const THIN: f64 = 1.0 / 1_048_576.0;

/// The kind of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[must_use = "a state may have no rates, or nothing at all"]
pub enum Condition {
    /// An ordinary solution.
    Ok,
    /// A point where two assemblies meet. Values are limits.
    ChangePoint,
    /// A limit of the motion. Positions exist, rates do not.
    DeadPoint,
    /// No assembly at this coordinate. There are no values.
    NoAssembly,
}

/// A point's position and its first two derivatives by the driver's coordinate.
///
/// Aligned, so that no vector instruction reads or writes across the end of a memory page: on some
/// processors that takes as long as computing a whole state. The order of the fields keeps the
/// rates apart, so that no load spans the y of one and the x of the other. Such a load of two
/// recent stores has to wait until both are in the cache.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub(super) struct PointState<T = f64> {
    pub v: Vec2<T>,
    pub p: Vec2<T>,
    pub a: Vec2<T>,
}

/// A link's direction (a unit vector) and the first two derivatives of its angle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(32))]
pub(super) struct LinkState<T = f64> {
    pub d: Vec2<T>,
    pub w: T,
    pub a: T,
}

impl<T: Number> PointState<T> {
    /// Creates a point at rest.
    pub(super) fn fixed(p: Vec2<T>) -> Self {
        PointState {
            p,
            ..PointState::default()
        }
    }
}

impl<T: Number> LinkState<T> {
    /// Creates a body at rest.
    pub(super) fn fixed(d: Vec2<T>) -> Self {
        LinkState {
            d,
            ..LinkState::default()
        }
    }
}

/// A slide's position along its guide, its first two derivatives, and the guide itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct TravelState<T = f64> {
    pub s: T,
    pub v: T,
    pub a: T,
    pub guide: LinkState<T>,
}

/// The driver's q', q'^2 and q'', in radians or scaled lengths. They convert coefficients to rates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Rates {
    pub(super) speed: Constant,
    pub(super) square: Constant,
    pub(super) acceleration: Constant,
}

/// Position, velocity and acceleration of every point and link, in the scene's units and frame.
///
/// Velocities and accelerations are for the driver's speed and acceleration. With the kinematic
/// coefficients x' and x'' of first and second order, v = x' q' and a = x'' q'^2 + x' q''.
///
/// Missing values read as `None`: all values without an assembly, rates at a dead point, values of
/// a higher order than solved, and elements left out by [`Solver::only`](super::Solver::only). Two
/// states are equal if all readable values are.
///
/// `T` is the arithmetic: doubles for plain values, balls for values with an error bound, lanes for
/// the values of several states at once.
#[derive(Debug)]
pub struct State<T = f64> {
    pub(super) condition: Condition,
    /// The order to which it is solved.
    pub(super) order: Order,
    pub(super) at: T,
    pub(super) points: Vec<PointState<T>>,
    pub(super) links: Vec<LinkState<T>>,
    pub(super) travels: Vec<TravelState<T>>,
    /// One signed measure for each group: the square of the sine of its transmission angle, or an
    /// equivalent. Zero at a singularity, negative if the group cannot close.
    pub(super) measures: Vec<T>,
    /// Whether a dyad of the last solve is near its limit, in any lane.
    pub(super) is_thin: bool,
    /// For each group the sign that selects its assembly, if it has two.
    pub(super) signs: Vec<T>,
    /// The forces, if the mechanism has loads.
    pub(super) forces: Option<Box<ForceState<T>>>,
    pub(super) frame: Frame,
    /// The elements that the solver never places.
    pub(super) left_out: Option<Arc<Marks>>,
    /// The rates for angles; `length_rates` are those for lengths in the scene's unit.
    pub(super) rates: Rates,
    pub(super) length_rates: Rates,
    /// The driver's speed and acceleration, if every input moves by itself. All derivatives are then
    /// by time.
    pub(super) free: Option<[f64; 2]>,
    /// The driven link, whose angle is exactly the driver's coordinate; `None` if its motor is on
    /// another link.
    pub(super) driven: Option<LinkId>,
    /// Whether the driver's coordinate is an angle.
    pub(super) is_turned: bool,
    /// The size of the driver's unit in the coordinate of the derivatives: 1 for radians.
    pub(super) driver_scale: f64,
}

impl<T: Copy> Clone for State<T> {
    fn clone(&self) -> State<T> {
        State {
            points: self.points.clone(),
            links: self.links.clone(),
            travels: self.travels.clone(),
            measures: self.measures.clone(),
            is_thin: self.is_thin,
            signs: self.signs.clone(),
            forces: self.forces.clone(),
            left_out: self.left_out.clone(),
            ..*self
        }
    }

    /// Copies a state without allocating memory for the values again.
    fn clone_from(&mut self, other: &State<T>) {
        let State {
            condition,
            order,
            at,
            points,
            links,
            travels,
            measures,
            is_thin,
            signs,
            forces,
            frame,
            left_out,
            rates,
            length_rates,
            free,
            driven,
            is_turned,
            driver_scale,
        } = self;
        (*condition, *order, *at) = (other.condition, other.order, other.at);
        points.clone_from(&other.points);
        links.clone_from(&other.links);
        travels.clone_from(&other.travels);
        measures.clone_from(&other.measures);
        *is_thin = other.is_thin;
        signs.clone_from(&other.signs);
        forces.clone_from(&other.forces);
        left_out.clone_from(&other.left_out);
        (*frame, *rates, *length_rates) = (other.frame, other.rates, other.length_rates);
        (*free, *driven, *is_turned) = (other.free, other.driven, other.is_turned);
        *driver_scale = other.driver_scale;
    }
}

impl<T: Number> State<T> {
    /// Starts a solve: sets its coordinate and order.
    #[inline(always)]
    pub(super) fn start(&mut self, at: T, order: Order) {
        (self.at, self.order, self.is_thin) = (at, order, false);
    }

    /// Stores the measure of a dyad.
    #[inline(always)]
    pub(super) fn set_measure(&mut self, group: usize, measure: T) {
        self.measures[group] = measure;
        if !measure.exceeds(T::exactly(THIN)) {
            self.is_thin = true;
        }
    }

    /// Returns the kind of this state.
    pub fn condition(&self) -> Condition {
        self.condition
    }

    /// Returns the order to which it is solved.
    #[must_use]
    pub fn order(&self) -> Order {
        self.order
    }

    /// Returns `true` if values of an order exist.
    #[inline]
    #[must_use]
    pub fn has(&self, order: Order) -> bool {
        match self.condition {
            Condition::Ok | Condition::ChangePoint => order <= self.order,
            Condition::DeadPoint => order == Order::Position,
            Condition::NoAssembly => false,
        }
    }

    #[inline]
    fn has_point(&self, point: PointId, order: Order) -> bool {
        let is_placed = |out: &Arc<Marks>| !out.points[point.index()];
        self.has(order) && self.left_out.as_ref().is_none_or(is_placed)
    }

    #[inline]
    fn has_link(&self, link: LinkId, order: Order) -> bool {
        let is_placed = |out: &Arc<Marks>| !out.links[link.index()];
        self.has(order) && self.left_out.as_ref().is_none_or(is_placed)
    }

    /// Returns `true` if the driver turns a link, `false` if it pushes a slide.
    #[must_use]
    pub fn turns(&self) -> bool {
        self.is_turned
    }

    /// Returns `true` if every input moves by itself: see [`FreeInputs`](super::FreeInputs).
    #[must_use]
    pub fn has_free_inputs(&self) -> bool {
        self.free.is_some()
    }

    /// Returns the driver's coordinate in the unit of the steps: degrees or scaled lengths.
    #[inline(always)]
    pub(super) fn coordinate(&self) -> T {
        if self.turns() {
            self.at
        } else {
            self.at / T::exactly(self.frame.scale)
        }
    }

    /// Returns the requested coordinate of the driver.
    #[must_use]
    pub fn at(&self) -> T {
        self.at
    }

    /// Returns the driver's speed: rad/s or length/s.
    #[must_use]
    pub fn driver_speed(&self) -> T {
        match self.free {
            None => T::of(self.rates.speed).scaled(self.driver_scale),
            Some([speed, _]) => T::exactly(speed),
        }
    }

    /// Returns the driver's acceleration: rad/s^2 or length/s^2.
    #[must_use]
    pub fn driver_acceleration(&self) -> T {
        match self.free {
            None => T::of(self.rates.acceleration).scaled(self.driver_scale),
            Some([_, acceleration]) => T::exactly(acceleration),
        }
    }

    /// Returns the position of a point, in the scene's frame.
    #[inline]
    #[must_use]
    pub fn position(&self, point: PointId) -> Option<Vec2<T>> {
        self.has_point(point, Order::Position)
            .then(|| self.place(point))
    }

    /// Returns the position of a point without checking that it has been placed.
    #[inline(always)]
    pub(super) fn place(&self, point: PointId) -> Vec2<T> {
        self.frame.place(self.points[point.index()].p)
    }

    /// Returns the velocity of a point, in the scene's length unit per second.
    #[inline]
    #[must_use]
    pub fn velocity(&self, point: PointId) -> Option<Vec2<T>> {
        self.has_point(point, Order::Velocity)
            .then(|| self.points[point.index()].v.times(self.length_rates.speed))
    }

    /// Returns the acceleration of a point, in the scene's length unit per second squared.
    #[inline]
    #[must_use]
    pub fn acceleration(&self, point: PointId) -> Option<Vec2<T>> {
        let rates = &self.length_rates;
        self.has_point(point, Order::Acceleration).then(|| {
            let point = &self.points[point.index()];
            point.a.times(rates.square) + point.v.times(rates.acceleration)
        })
    }

    /// Returns the direction of a link's x axis: a unit vector.
    #[inline]
    #[must_use]
    pub fn direction(&self, link: LinkId) -> Option<Vec2<T>> {
        self.has_link(link, Order::Position)
            .then(|| self.links[link.index()].d)
    }

    /// Returns the angle of a link's x axis in degrees, from 0 to below 360.
    #[must_use]
    pub fn angle(&self, link: LinkId) -> Option<T> {
        let direction = self.direction(link)?;
        Some(if self.driven == Some(link) {
            T::wrapped(self.at)
        } else {
            T::degrees(direction)
        })
    }

    /// Returns the angular velocity of a link in rad/s.
    #[inline]
    #[must_use]
    pub fn omega(&self, link: LinkId) -> Option<T> {
        self.has_link(link, Order::Velocity)
            .then(|| self.links[link.index()].w.times(self.rates.speed))
    }

    /// Returns the angular acceleration of a link in rad/s^2.
    #[inline]
    #[must_use]
    pub fn alpha(&self, link: LinkId) -> Option<T> {
        self.has_link(link, Order::Acceleration).then(|| {
            let link = &self.links[link.index()];
            self.rates.second(link.w, link.a)
        })
    }

    /// Returns the position of a slide along its guide, and the direction of the guide.
    #[must_use]
    pub fn travel(&self, slide: SlideId) -> Option<Travel<T>> {
        let is_placed = |out: &Arc<Marks>| !out.slides[slide.index()];
        if !self.has(Order::Position) || !self.left_out.as_ref().is_none_or(is_placed) {
            return None;
        }
        let sliding = self.sliding(slide);
        let (velocity, acceleration) = (self.has(Order::Velocity), self.has(Order::Acceleration));
        Some(Travel {
            position: sliding.position,
            guide: sliding.guide,
            rate: velocity.then_some(sliding.rate),
            omega: velocity.then_some(sliding.omega),
            accel: acceleration.then_some(sliding.accel),
            alpha: acceleration.then_some(sliding.alpha),
        })
    }

    /// Returns the motion of a slide without checking that it has been placed.
    #[inline(always)]
    pub(super) fn sliding(&self, slide: SlideId) -> Sliding<T> {
        let TravelState { s, v, a, guide } = self.travels[slide.index()];
        Sliding {
            position: s.scaled(self.frame.scale),
            rate: v.times(self.length_rates.speed),
            accel: self.length_rates.second(v, a),
            guide: guide.d,
            omega: guide.w.times(self.rates.speed),
            alpha: self.rates.second(guide.w, guide.a),
        }
    }
}

impl<T: Number + PartialEq> PartialEq for State<T> {
    fn eq(&self, other: &State<T>) -> bool {
        let points = self.points.len() == other.points.len()
            && (0..self.points.len()).map(PointId::new).all(|p| {
                self.position(p) == other.position(p)
                    && self.velocity(p) == other.velocity(p)
                    && self.acceleration(p) == other.acceleration(p)
            });
        let links = self.links.len() == other.links.len()
            && (0..self.links.len()).map(LinkId::new).all(|l| {
                self.angle(l) == other.angle(l)
                    && self.omega(l) == other.omega(l)
                    && self.alpha(l) == other.alpha(l)
            });
        let slides = self.travels.len() == other.travels.len()
            && (0..self.travels.len())
                .map(SlideId::new)
                .all(|s| self.travel(s) == other.travel(s));
        (self.condition, self.order, self.at) == (other.condition, other.order, other.at)
            && points
            && links
            && slides
            && self.forces == other.forces
    }
}

impl Rates {
    /// Creates rates. The square is the rounded square of the doubles, with the remainder in `lo`.
    pub(super) fn new(speed: Constant, acceleration: Constant) -> Rates {
        let square = speed * speed;
        Rates {
            speed,
            square: square.relative_to(speed.hi * speed.hi),
            acceleration,
        }
    }

    /// Returns the rates for a coordinate in a unit of this size, a power of two.
    pub(super) fn times(self, unit: f64) -> Rates {
        Rates {
            speed: self.speed.scaled(unit),
            square: self.square.scaled(unit),
            acceleration: self.acceleration.scaled(unit),
        }
    }

    /// Computes the second rate of a coordinate from its coefficients of first and second order.
    #[inline]
    fn second<T: Number>(&self, first: T, second: T) -> T {
        second.times(self.square) + first.times(self.acceleration)
    }
}

/// A slide in a state. Rates are `None` if they do not exist.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Travel<T = f64> {
    /// The sliding point's signed position along the guide, counted from `through`.
    pub position: T,
    /// The rate of the position, per second.
    pub rate: Option<T>,
    /// The second rate of the position, per second squared.
    pub accel: Option<T>,
    /// The guide's direction in the ground frame: a unit vector.
    pub guide: Vec2<T>,
    /// The guide's angular velocity in rad/s.
    pub omega: Option<T>,
    /// The guide's angular acceleration in rad/s^2.
    pub alpha: Option<T>,
}

/// A slide with all its rates.
#[derive(Clone, Copy, Debug)]
pub struct Sliding<T = f64> {
    /// The signed position along the guide.
    pub position: T,
    /// The first derivative of the position.
    pub rate: T,
    /// The second derivative of the position.
    pub accel: T,
    /// The unit vector along the guide.
    pub guide: Vec2<T>,
    /// The angular velocity of the guide.
    pub omega: T,
    /// The angular acceleration of the guide.
    pub alpha: T,
}
