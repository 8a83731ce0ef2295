//! The result of a solve: kinematic coefficients inside, figures in the scene's units outside.

use super::coupled::Scratch;
use super::frame::Frame;
use crate::{LinkId, PointId, SlideId, Vec2, angle};

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
pub(super) struct PointState {
    pub p: Vec2,
    pub v: Vec2,
    pub a: Vec2,
}

/// A link's direction (a unit vector) and the first two derivatives of its angle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct LinkState {
    pub d: Vec2,
    pub w: f64,
    pub a: f64,
}

impl LinkState {
    /// A body that does not turn.
    pub(super) const FIXED: LinkState = LinkState {
        d: Vec2::X,
        w: 0.0,
        a: 0.0,
    };
}

/// A slide's position along its guide and its first two derivatives, and the guide itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct TravelState {
    pub s: f64,
    pub v: f64,
    pub a: f64,
    pub guide: LinkState,
}

/// What turns coefficients into rates: q', q'^2 and q'' of the driver, in radians or scaled lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Rates {
    speed: f64,
    square: f64,
    acceleration: f64,
}

/// Position, velocity and acceleration of every point and link, in the scene's units and frame.
///
/// Velocities and accelerations are for the driver's speed and acceleration: with x' and x'' the
/// kinematic coefficients of first and second order, v = x' q' and a = x'' q'^2 + x' q''. Whoever
/// reads asks [`State::condition`] first, or reads through a `Quantity`, which does.
#[derive(Clone, Debug)]
pub struct State {
    pub(super) condition: Condition,
    pub(super) at: f64,
    pub(super) points: Vec<PointState>,
    pub(super) links: Vec<LinkState>,
    pub(super) travels: Vec<TravelState>,
    /// One signed measure a group: the square of the sine of its transmission angle, or what
    /// plays that part; zero at a singularity, negative where the group cannot close.
    pub(super) measures: Vec<f64>,
    /// For every group the sign that chooses its assembly, where it has two.
    pub(super) signs: Vec<f64>,
    /// Room for the coupled groups.
    pub(super) scratch: Scratch,
    pub(super) frame: Frame,
    /// For angles, and for lengths in the scene's unit.
    pub(super) rates: Rates,
    pub(super) length_rates: Rates,
    /// The driven link, whose angle is the driver's coordinate to the bit.
    pub(super) driven: Option<LinkId>,
    /// The size of the driver's unit in the coordinate of the derivatives: 1 for radians.
    pub(super) driver_scale: f64,
}

impl State {
    /// What this state is.
    #[must_use]
    pub fn condition(&self) -> Condition {
        self.condition
    }

    /// The driver's coordinate, as asked.
    #[must_use]
    pub fn at(&self) -> f64 {
        self.at
    }

    /// The driver's speed: rad/s or length/s.
    #[must_use]
    pub fn driver_speed(&self) -> f64 {
        self.rates.speed * self.driver_scale
    }

    /// The driver's acceleration: rad/s^2 or length/s^2.
    #[must_use]
    pub fn driver_acceleration(&self) -> f64 {
        self.rates.acceleration * self.driver_scale
    }

    /// The position of a point.
    #[must_use]
    pub fn position(&self, point: PointId) -> Vec2 {
        self.frame.place(self.points[point.index()].p)
    }

    /// Its velocity, per second.
    #[must_use]
    pub fn velocity(&self, point: PointId) -> Vec2 {
        self.points[point.index()].v * self.length_rates.speed
    }

    /// Its acceleration, per second squared.
    #[must_use]
    pub fn acceleration(&self, point: PointId) -> Vec2 {
        let point = &self.points[point.index()];
        let rates = &self.length_rates;
        point.a * rates.square + point.v * rates.acceleration
    }

    /// The direction of a link's x axis: a unit vector.
    #[must_use]
    pub fn direction(&self, link: LinkId) -> Vec2 {
        self.links[link.index()].d
    }

    /// The angle of a link's x axis in degrees, from 0 to below 360.
    #[must_use]
    pub fn angle(&self, link: LinkId) -> f64 {
        if self.driven == Some(link) {
            angle::wrapped(self.at)
        } else {
            angle::degrees(self.direction(link))
        }
    }

    /// Angular velocity in rad/s.
    #[must_use]
    pub fn omega(&self, link: LinkId) -> f64 {
        self.links[link.index()].w * self.rates.speed
    }

    /// Angular acceleration in rad/s^2.
    #[must_use]
    pub fn alpha(&self, link: LinkId) -> f64 {
        let link = &self.links[link.index()];
        self.rates.second(link.w, link.a)
    }

    /// Where a slide is along its guide, and how the guide lies.
    #[must_use]
    pub fn travel(&self, slide: SlideId) -> Travel {
        let travel = &self.travels[slide.index()];
        let TravelState { s, v, a, guide } = *travel;
        Travel {
            position: s * self.frame.scale,
            rate: v * self.length_rates.speed,
            accel: self.length_rates.second(v, a),
            guide: guide.d,
            omega: guide.w * self.rates.speed,
            alpha: self.rates.second(guide.w, guide.a),
        }
    }
}

impl Rates {
    pub(super) fn new(speed: f64, acceleration: f64) -> Rates {
        Rates {
            speed,
            square: speed * speed,
            acceleration,
        }
    }

    /// The same for a coordinate counted in units of this size.
    pub(super) fn times(self, unit: f64) -> Rates {
        Rates {
            speed: self.speed * unit,
            square: self.square * unit,
            acceleration: self.acceleration * unit,
        }
    }

    /// The second rate of a coordinate from its coefficients of first and second order.
    fn second(self, first: f64, second: f64) -> f64 {
        second * self.square + first * self.acceleration
    }
}

/// A slide in a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Travel {
    /// The sliding point's signed position along the guide, counted from `through`.
    pub position: f64,
    /// Its rate, per second.
    pub rate: f64,
    /// The rate of its rate, per second squared.
    pub accel: f64,
    /// The guide's direction in the ground frame: a unit vector.
    pub guide: Vec2,
    /// The guide's angular velocity in rad/s.
    pub omega: f64,
    /// The guide's angular acceleration in rad/s^2.
    pub alpha: f64,
}
