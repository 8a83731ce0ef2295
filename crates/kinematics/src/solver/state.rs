//! The result of a solve: kinematic coefficients inside, figures in the scene's units outside.

use super::Order;
use super::demand::Marks;
use super::forces::ForceState;
use super::frame::Frame;
use crate::{Constant, LinkId, Number, PointId, SlideId, Vec2};
use std::sync::Arc;

/// What a state is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[must_use = "a state may have no rates, or nothing at all"]
pub enum Condition {
    /// Solved.
    Ok,
    /// Where two assemblies meet: values are limits.
    ChangePoint,
    /// A limit of the motion: positions exist, rates do not.
    DeadPoint,
    /// The mechanism cannot be here: no values.
    NoAssembly,
}

/// A point's position and its first two derivatives by the driver's coordinate.
///
/// Aligned, so that no vector instruction reads or writes across the end of a page of memory: some processors
/// take as long for that as for a whole state. Rates are apart, so that none reads the one's y and the other's x at
/// once: what has just been written in two pieces is not to be had as one before it is in the cache.
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
    /// A point that does not move.
    pub(super) fn fixed(p: Vec2<T>) -> Self {
        PointState {
            p,
            ..PointState::default()
        }
    }
}

impl<T: Number> LinkState<T> {
    /// A body that does not turn.
    pub(super) fn fixed(d: Vec2<T>) -> Self {
        LinkState {
            d,
            ..LinkState::default()
        }
    }
}

/// A slide's position along its guide and its first two derivatives, and the guide itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct TravelState<T = f64> {
    pub s: T,
    pub v: T,
    pub a: T,
    pub guide: LinkState<T>,
}

/// What turns coefficients into rates: q', q'^2 and q'' of the driver, in radians or scaled lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Rates {
    pub(super) speed: Constant,
    pub(super) square: Constant,
    pub(super) acceleration: Constant,
}

/// Position, velocity and acceleration of every point and link, in the scene's units and frame.
///
/// Velocities and accelerations are for the driver's speed and acceleration: with x' and x'' the
/// kinematic coefficients of first and second order, v = x' q' and a = x'' q'^2 + x' q''.
///
/// What there is not reads as `None`: everything without an assembly, rates at a dead point, what is of a
/// higher order than was solved, and what a solver leaves out ([`Solver::only`](super::Solver::only)).
/// Two states are equal where everything that can be read is.
///
/// `T` is the arithmetic: doubles for figures, balls for figures with a bound, lanes for the figures
/// of several states at once.
#[derive(Clone, Debug)]
pub struct State<T = f64> {
    pub(super) condition: Condition,
    /// How far it has been solved.
    pub(super) order: Order,
    pub(super) at: T,
    pub(super) points: Vec<PointState<T>>,
    pub(super) links: Vec<LinkState<T>>,
    pub(super) travels: Vec<TravelState<T>>,
    /// One signed measure a group: the square of the sine of its transmission angle, or what
    /// plays that part; zero at a singularity, negative where the group cannot close.
    pub(super) measures: Vec<T>,
    /// For every group the sign that chooses its assembly, where it has two.
    pub(super) signs: Vec<T>,
    /// The forces, where anything acts.
    pub(super) forces: Option<Box<ForceState<T>>>,
    pub(super) frame: Frame,
    /// What the solver never places.
    pub(super) left_out: Option<Arc<Marks>>,
    /// For angles, and for lengths in the scene's unit.
    pub(super) rates: Rates,
    pub(super) length_rates: Rates,
    /// The driven link, whose angle is the driver's coordinate to the bit; none where its motor sits on another link.
    pub(super) driven: Option<LinkId>,
    /// Whether the driver's coordinate is an angle.
    pub(super) is_turned: bool,
    /// The size of the driver's unit in the coordinate of the derivatives: 1 for radians.
    pub(super) driver_scale: f64,
}

impl<T: Number> State<T> {
    /// Begins a solve: to this order, at this coordinate.
    #[inline(always)]
    pub(super) fn begin(&mut self, at: T, order: Order) {
        (self.at, self.order) = (at, order);
    }

    /// What this state is.
    pub fn condition(&self) -> Condition {
        self.condition
    }

    /// How far it has been solved.
    #[must_use]
    pub fn order(&self) -> Order {
        self.order
    }

    /// Whether figures of an order exist.
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

    /// Whether the driver turns a link, and does not push a slide.
    #[must_use]
    pub fn turns(&self) -> bool {
        self.is_turned
    }

    /// The driver's coordinate as the steps have it: in degrees or scaled lengths.
    #[inline(always)]
    pub(super) fn coordinate(&self) -> T {
        if self.turns() {
            self.at
        } else {
            self.at / T::exactly(self.frame.scale)
        }
    }

    /// The driver's coordinate, as asked.
    #[must_use]
    pub fn at(&self) -> T {
        self.at
    }

    /// The driver's speed: rad/s or length/s.
    #[must_use]
    pub fn driver_speed(&self) -> T {
        T::of(self.rates.speed).scaled(self.driver_scale)
    }

    /// The driver's acceleration: rad/s^2 or length/s^2.
    #[must_use]
    pub fn driver_acceleration(&self) -> T {
        T::of(self.rates.acceleration).scaled(self.driver_scale)
    }

    /// The position of a point.
    #[inline]
    #[must_use]
    pub fn position(&self, point: PointId) -> Option<Vec2<T>> {
        self.has_point(point, Order::Position)
            .then(|| self.place(point))
    }

    /// Where a point has been put, by whoever has just put it there.
    #[inline(always)]
    pub(super) fn place(&self, point: PointId) -> Vec2<T> {
        self.frame.place(self.points[point.index()].p)
    }

    /// Its velocity, per second.
    #[inline]
    #[must_use]
    pub fn velocity(&self, point: PointId) -> Option<Vec2<T>> {
        self.has_point(point, Order::Velocity)
            .then(|| self.points[point.index()].v.times(self.length_rates.speed))
    }

    /// Its acceleration, per second squared.
    #[inline]
    #[must_use]
    pub fn acceleration(&self, point: PointId) -> Option<Vec2<T>> {
        let rates = &self.length_rates;
        self.has_point(point, Order::Acceleration).then(|| {
            let point = &self.points[point.index()];
            point.a.times(rates.square) + point.v.times(rates.acceleration)
        })
    }

    /// The direction of a link's x axis: a unit vector.
    #[inline]
    #[must_use]
    pub fn direction(&self, link: LinkId) -> Option<Vec2<T>> {
        self.has_link(link, Order::Position)
            .then(|| self.links[link.index()].d)
    }

    /// The angle of a link's x axis in degrees, from 0 to below 360.
    #[must_use]
    pub fn angle(&self, link: LinkId) -> Option<T> {
        let direction = self.direction(link)?;
        Some(if self.driven == Some(link) {
            T::wrapped(self.at)
        } else {
            T::degrees(direction)
        })
    }

    /// Angular velocity in rad/s.
    #[inline]
    #[must_use]
    pub fn omega(&self, link: LinkId) -> Option<T> {
        self.has_link(link, Order::Velocity)
            .then(|| self.links[link.index()].w.times(self.rates.speed))
    }

    /// Angular acceleration in rad/s^2.
    #[inline]
    #[must_use]
    pub fn alpha(&self, link: LinkId) -> Option<T> {
        self.has_link(link, Order::Acceleration).then(|| {
            let link = &self.links[link.index()];
            self.rates.second(link.w, link.a)
        })
    }

    /// Where a slide is along its guide, and how the guide lies.
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

    /// A slide as it has been put, by whoever has just put it there.
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
    /// The square is that of the doubles, rounded, with what is left of it.
    pub(super) fn new(speed: Constant, acceleration: Constant) -> Rates {
        let square = speed * speed;
        Rates {
            speed,
            square: square.beside(speed.hi * speed.hi),
            acceleration,
        }
    }

    /// The same for a coordinate counted in units of this size, a power of two.
    pub(super) fn times(self, unit: f64) -> Rates {
        Rates {
            speed: self.speed.scaled(unit),
            square: self.square.scaled(unit),
            acceleration: self.acceleration.scaled(unit),
        }
    }

    /// The second rate of a coordinate from its coefficients of first and second order.
    #[inline]
    fn second<T: Number>(&self, first: T, second: T) -> T {
        second.times(self.square) + first.times(self.acceleration)
    }
}

/// A slide in a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Travel<T = f64> {
    /// The sliding point's signed position along the guide, counted from `through`.
    pub position: T,
    /// Its rate, per second.
    pub rate: Option<T>,
    /// The rate of its rate, per second squared.
    pub accel: Option<T>,
    /// The guide's direction in the ground frame: a unit vector.
    pub guide: Vec2<T>,
    /// The guide's angular velocity in rad/s.
    pub omega: Option<T>,
    /// The guide's angular acceleration in rad/s^2.
    pub alpha: Option<T>,
}

/// The same with all rates.
#[derive(Clone, Copy, Debug)]
pub struct Sliding<T = f64> {
    /// The signed position along the guide.
    pub position: T,
    /// Its first derivative.
    pub rate: T,
    /// Its second derivative.
    pub accel: T,
    /// The unit vector along the guide.
    pub guide: Vec2<T>,
    /// The angular velocity of the guide.
    pub omega: T,
    /// The angular acceleration of the guide.
    pub alpha: T,
}
