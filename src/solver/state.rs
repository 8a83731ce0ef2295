//! The result of a solve: kinematic coefficients inside, figures in the scene's units outside.

use super::forces::Forces;
use super::frame::Frame;
use crate::{Constant, LinkId, Number, PointId, SlideId, Vec2};

/// What a state is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct PointState<T = f64> {
    pub p: Vec2<T>,
    pub v: Vec2<T>,
    pub a: Vec2<T>,
}

/// A link's direction (a unit vector) and the first two derivatives of its angle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
pub(super) struct Rates<T = f64> {
    pub(super) speed: T,
    pub(super) square: T,
    pub(super) acceleration: T,
}

/// Position, velocity and acceleration of every point and link, in the scene's units and frame.
///
/// Velocities and accelerations are for the driver's speed and acceleration: with x' and x'' the
/// kinematic coefficients of first and second order, v = x' q' and a = x'' q'^2 + x' q''. Whoever
/// reads asks [`State::condition`] first, or reads through a `Quantity`, which does.
///
/// `T` is the arithmetic: doubles for figures, balls for figures with a bound, lanes for the figures
/// of several states at once.
#[derive(Clone, Debug)]
pub struct State<T = f64> {
    pub(super) condition: Condition,
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
    pub(super) forces: Option<Box<Forces<T>>>,
    pub(super) frame: Frame,
    /// For angles, and for lengths in the scene's unit.
    pub(super) rates: Rates<T>,
    pub(super) length_rates: Rates<T>,
    /// The driven link, whose angle is the driver's coordinate to the bit.
    pub(super) driven: Option<LinkId>,
    /// The size of the driver's unit in the coordinate of the derivatives: 1 for radians.
    pub(super) driver_scale: f64,
}

impl<T: Number> State<T> {
    /// What this state is.
    #[must_use]
    pub fn condition(&self) -> Condition {
        self.condition
    }

    /// Whether the driver turns a link, and does not push a slide.
    #[must_use]
    pub fn turns(&self) -> bool {
        self.driven.is_some()
    }

    /// The driver's coordinate, as asked.
    #[must_use]
    pub fn at(&self) -> T {
        self.at
    }

    /// The driver's speed: rad/s or length/s.
    #[must_use]
    pub fn driver_speed(&self) -> T {
        self.rates.speed.scaled(self.driver_scale)
    }

    /// The driver's acceleration: rad/s^2 or length/s^2.
    #[must_use]
    pub fn driver_acceleration(&self) -> T {
        self.rates.acceleration.scaled(self.driver_scale)
    }

    /// The position of a point.
    #[inline]
    #[must_use]
    pub fn position(&self, point: PointId) -> Vec2<T> {
        self.frame.place(self.points[point.index()].p)
    }

    /// Its velocity, per second.
    #[inline]
    #[must_use]
    pub fn velocity(&self, point: PointId) -> Vec2<T> {
        self.points[point.index()].v * self.length_rates.speed
    }

    /// Its acceleration, per second squared.
    #[inline]
    #[must_use]
    pub fn acceleration(&self, point: PointId) -> Vec2<T> {
        let point = &self.points[point.index()];
        let rates = &self.length_rates;
        point.a * rates.square + point.v * rates.acceleration
    }

    /// The direction of a link's x axis: a unit vector.
    #[inline]
    #[must_use]
    pub fn direction(&self, link: LinkId) -> Vec2<T> {
        self.links[link.index()].d
    }

    /// The angle of a link's x axis in degrees, from 0 to below 360.
    #[must_use]
    pub fn angle(&self, link: LinkId) -> T {
        if self.driven == Some(link) {
            T::wrapped(self.at)
        } else {
            T::degrees(self.direction(link))
        }
    }

    /// Angular velocity in rad/s.
    #[inline]
    #[must_use]
    pub fn omega(&self, link: LinkId) -> T {
        self.links[link.index()].w * self.rates.speed
    }

    /// Angular acceleration in rad/s^2.
    #[inline]
    #[must_use]
    pub fn alpha(&self, link: LinkId) -> T {
        let link = &self.links[link.index()];
        self.rates.second(link.w, link.a)
    }

    /// Where a slide is along its guide, and how the guide lies.
    #[must_use]
    pub fn travel(&self, slide: SlideId) -> Travel<T> {
        let travel = &self.travels[slide.index()];
        let TravelState { s, v, a, guide } = *travel;
        Travel {
            position: s.scaled(self.frame.scale),
            rate: v * self.length_rates.speed,
            accel: self.length_rates.second(v, a),
            guide: guide.d,
            omega: guide.w * self.rates.speed,
            alpha: self.rates.second(guide.w, guide.a),
        }
    }
}

impl<T: Number> Rates<T> {
    pub(super) fn new(speed: Constant, acceleration: Constant) -> Rates<T> {
        let speed = T::of(speed);
        Rates {
            speed,
            square: speed * speed,
            acceleration: T::of(acceleration),
        }
    }

    /// The same for a coordinate counted in units of this size, a power of two.
    pub(super) fn times(self, unit: f64) -> Rates<T> {
        Rates {
            speed: self.speed.scaled(unit),
            square: self.square.scaled(unit),
            acceleration: self.acceleration.scaled(unit),
        }
    }

    /// The second rate of a coordinate from its coefficients of first and second order.
    #[inline]
    fn second(self, first: T, second: T) -> T {
        second * self.square + first * self.acceleration
    }
}

/// A slide in a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Travel<T = f64> {
    /// The sliding point's signed position along the guide, counted from `through`.
    pub position: T,
    /// Its rate, per second.
    pub rate: T,
    /// The rate of its rate, per second squared.
    pub accel: T,
    /// The guide's direction in the ground frame: a unit vector.
    pub guide: Vec2<T>,
    /// The guide's angular velocity in rad/s.
    pub omega: T,
    /// The guide's angular acceleration in rad/s^2.
    pub alpha: T,
}
