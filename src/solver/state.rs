use crate::{LinkId, PointId, SlideId, Vec2};

/// What a state is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Solved.
    Ok,
    /// A limit of the motion: positions exist, rates do not.
    DeadPoint,
    /// Where two assemblies meet: values are limits.
    ChangePoint,
    /// The mechanism cannot be here: no values.
    NoAssembly,
}

/// Position, velocity and acceleration of every point and link, in the scene's units and frame.
///
/// Velocities and accelerations are for the driver's speed and acceleration. Whoever reads asks
/// [`State::condition`] first, or reads through a `Quantity`, which does.
#[derive(Clone, Debug)]
pub struct State {}

impl State {
    /// What this state is.
    pub fn condition(&self) -> Condition {
        todo!()
    }
    /// The driver's coordinate, as asked.
    pub fn at(&self) -> f64 {
        todo!()
    }
    /// The driver's speed: rad/s or length/s.
    pub fn driver_speed(&self) -> f64 {
        todo!()
    }
    /// The driver's acceleration: rad/s^2 or length/s^2.
    pub fn driver_acceleration(&self) -> f64 {
        todo!()
    }
    /// The position of a point.
    pub fn position(&self, point: PointId) -> Vec2 {
        todo!()
    }
    /// Its velocity, per second.
    pub fn velocity(&self, point: PointId) -> Vec2 {
        todo!()
    }
    /// Its acceleration, per second squared.
    pub fn acceleration(&self, point: PointId) -> Vec2 {
        todo!()
    }
    /// The direction of a link's x axis: a unit vector.
    pub fn direction(&self, link: LinkId) -> Vec2 {
        todo!()
    }
    /// Angular velocity in rad/s.
    pub fn omega(&self, link: LinkId) -> f64 {
        todo!()
    }
    /// Angular acceleration in rad/s^2.
    pub fn alpha(&self, link: LinkId) -> f64 {
        todo!()
    }
    /// Where a slide is along its guide, and how the guide lies.
    pub fn travel(&self, slide: SlideId) -> Travel {
        todo!()
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
