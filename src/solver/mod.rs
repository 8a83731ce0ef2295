//! From a mechanism and the driver's coordinate to a state.
mod fault;
mod motion;
mod plan;
mod state;

pub use fault::Fault;
pub use motion::{Motion, Range};
pub use plan::{Group, GroupKind, Plan};
pub use state::{Condition, State, Travel};

use crate::{LinkId, Mechanism, PointId, SlideId};

/// How far a state is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// Positions alone.
    Position,
    /// Positions and velocities.
    Velocity,
    /// Positions, velocities and accelerations.
    Acceleration,
}

/// What a caller wants to read from a state: the solver leaves out everything else.
#[derive(Clone, Debug, Default)]
pub struct Demand {
    /// Points whose motion is read.
    pub points: Vec<PointId>,
    /// Links whose direction or turning is read.
    pub links: Vec<LinkId>,
    /// Slides whose guide or travel is read.
    pub slides: Vec<SlideId>,
}

/// A mechanism made ready to be solved at any coordinate of its driver.
#[derive(Clone, Debug)]
pub struct Solver {}

impl Solver {
    /// Plans the mechanism, assembles it at the driver's start and follows its whole motion once.
    pub fn new(mechanism: &Mechanism) -> Result<Solver, Fault> {
        todo!()
    }
    /// The groups in the order in which they are solved.
    pub fn plan(&self) -> &Plan {
        todo!()
    }
    /// The whole motion: the driver's range.
    pub fn motion(&self) -> &Motion {
        todo!()
    }
    /// The same solver, without the groups and points that `demand` does not depend on.
    pub fn only(&self, demand: &Demand) -> Solver {
        todo!()
    }
    /// An empty state with all the room that solving needs.
    pub fn state(&self) -> State {
        todo!()
    }
    /// Solves for the driver's coordinate `at` (deg, or the scene's length unit), not wrapped. Allocates nothing.
    pub fn solve(&self, at: f64, order: Order, state: &mut State) -> Condition {
        todo!()
    }
}
