//! From a mechanism and the driver's coordinate to a state.
//!
//! [`Solver::new`] does everything that needs to be done once: the network of constraints is
//! ordered into groups, the groups become elementary steps, each takes the assembly that the
//! start means, and the whole motion is followed. [`Solver::solve`] then runs the steps at any
//! coordinate, in any order, without a history and without allocating.
//!
//! ```text
//! once       network   points, links and slides as constraints: what is known, what is sought
//!            order     which constraints are solved together, and in which order
//!            rank      which of them repeat others, and what is left free: by their dimensions
//!            chain     groups become steps: dyads in closed form, the rest coupled -> plan
//!            assemble  the assembly that is meant, at the start        choices  the others
//!            motion    the range, its limits and change points         passage  the way through these
//!            stops     where it meets the end of a limit, and ends
//! each time  workspace the room: a state, which is the result, and what finding it takes besides
//!            engine    runs the steps: elements (closed forms), coupled (Newton's method with lu)
//!            edge      near an end of the motion: in twice the digits, from the numbers that are meant (exact)
//!            lanes     several coordinates at once
//!            bounds    what the errors cannot exceed                   twice    the same, to twice the digits
//!            forces    the steps backwards: what joints carry and the driver must do
//! besides    transmission, conditioning, dead_centres (of slides), classify, by_length (derivatives), methods (other
//!            ways to solve, to compare)
//! ```
//!
//! Formulas of steps and coupled groups are written once, over [`crate::Number`].

mod assemble;
mod bounds;
mod by_length;
mod chain;
mod change_point;
mod choices;
mod classify;
mod conditioning;
mod coupled;
mod dead_centres;
mod demand;
mod edge;
mod elements;
mod engine;
mod exact;
mod fault;
mod following;
mod forces;
mod frame;
mod known;
mod lanes;
mod lu;
mod margin;
mod methods;
mod motion;
mod network;
mod order;
mod plan;
mod proved_run;
mod rank;
mod speed;
mod state;
mod stops;
mod transmission;
mod twice;
mod varied;
mod workspace;

pub use by_length::ByLength;
pub use choices::{Assemblies, Choice, MOST_ASSEMBLIES};
pub use classify::{DrivenLoop, Grashof, Inversion, LoopKind};
pub use conditioning::Conditioning;
pub use coupled::{Newton, NewtonRow, NewtonUnknown};
pub use dead_centres::DeadCentre;
pub use fault::{Fault, OpenChoice};
pub use forces::{Acted, ForceCheck, Indeterminate, LeastNorm, PressStroke, Residual, Withheld};
pub use known::Known;
pub use methods::{Deviation, DriftMethod, Methods, Runner};
pub use methods::{Method, Start, Unfit};
pub use motion::{EndStop, LinedUp, Motion, NearMiss, Range};
pub use plan::{Group, GroupId, GroupKind, Pick, Plan};
pub use rank::{Rank, Redundancy};
pub use state::Sliding;
pub use state::{Condition, State, Travel};
pub use transmission::{Extreme, Transmission};
pub use varied::Varied;
pub use workspace::Workspace;

/// Hooks for tests of other crates. Not part of the interface.
#[cfg(any(test, feature = "testing"))]
#[doc(hidden)]
pub mod testing {
    pub use crate::solver::bounds::testing::{
        check_bounds_of_a_disturbed_state, compare_bounds_without_vectors,
    };
    pub use crate::solver::conditioning::testing::check_conditioning;
    pub use crate::solver::forces::testing::{check_equilibrium, falsified};
    pub use crate::solver::lanes::testing::part_in_lanes;
    pub use crate::solver::transmission::compare_extremes;
}

use crate::{ElementId, LinkId, Mechanism, Number, PointId, SlideId, Vec2};
use assemble::Request;
use engine::Engine;
use exact::Exact;
use forces::Balance;
use frame::Frame;
use network::Network;
use order::Ordering;
use std::sync::Arc;

/// How far a state is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// Positions alone.
    Position,
    /// Positions and velocities.
    Velocity,
    /// Positions, velocities and accelerations.
    Acceleration,
    /// These, and the forces, where anything acts.
    Force,
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
    /// Whether forces are read: everything that moves has a part in them.
    pub forces: bool,
}

impl Demand {
    /// All that moves, and no forces.
    #[must_use]
    pub fn of_motion(mechanism: &Mechanism) -> Demand {
        Demand {
            points: mechanism.point_ids().collect(),
            links: mechanism.link_ids().collect(),
            slides: mechanism.slide_ids().collect(),
            forces: false,
        }
    }
}

/// A mechanism made ready to be solved at any coordinate of its driver.
#[derive(Clone)]
pub struct Solver {
    mechanism: Mechanism,
    engine: Engine,
    /// The same in the numbers that are meant, to look closer.
    exact: Option<Arc<Exact>>,
    /// What the groups were made from, to make them again for other lengths.
    ordering: Ordering,
    plan: Plan,
    motion: Motion,
    first_loop: Option<DrivenLoop>,
    slides: usize,
    /// Where the scene opens, if the motion comes there.
    opening: f64,
    /// What the rank of the constraints says.
    rank: Rank,
    /// How forces are found, where anything acts.
    balance: Option<Arc<Balance>>,
}

impl Solver {
    /// Plans the mechanism, assembles it at the driver's start and follows its whole motion once.
    ///
    /// # Errors
    /// What makes the mechanism impossible as a whole: see [`Fault`].
    pub fn new(mechanism: &Mechanism) -> Result<Solver, Fault> {
        Solver::with_assembly(mechanism, &[])
    }

    /// As [`Solver::new`], where the groups that are named ([`Group::name`]) take what was picked for
    /// them at the driver's start; the others go by the mechanism's start.
    ///
    /// # Errors
    /// See [`Fault`]; a pick that its group does not have among them.
    pub fn with_assembly(
        mechanism: &Mechanism,
        picks: &[(ElementId, Pick)],
    ) -> Result<Solver, Fault> {
        let start = mechanism.driver().start;
        Solver::open(mechanism, start, mechanism.start(), picks)
    }

    /// Assembles the mechanism at a coordinate, near rough places, and follows its motion from there.
    fn open(
        mechanism: &Mechanism,
        at: f64,
        near: &[(PointId, Vec2)],
        picks: &[(ElementId, Pick)],
    ) -> Result<Solver, Fault> {
        let frame = Frame::of(mechanism);
        let network = Network::new(mechanism, frame);
        if let Some(clash) = network.clash {
            let element = ElementId::Slide(clash.slide);
            let misfit = clash.misfit.abs() * frame.longest * frame.scale;
            return Err(Fault::OverConstrained {
                element,
                others: Vec::new(),
                misfit,
                at,
            });
        }
        if let Some(link) = network.given_twice() {
            return Err(Fault::OverConstrained {
                element: ElementId::Link(link),
                others: vec![mechanism.driver().input.element()],
                misfit: frame.longest * frame.scale,
                at,
            });
        }
        if let Some([link, from]) = network.locked_elbow() {
            return Err(Fault::OverConstrained {
                element: ElementId::Link(link),
                others: vec![ElementId::Link(from)],
                misfit: frame.longest * frame.scale,
                at,
            });
        }
        let with = |ordering: &Ordering, at: f64, near: &[(PointId, Vec2)]| {
            let solver = Solver::with(&network, ordering, at, near, picks)?;
            rank::judged(&network, solver)
        };
        let first = order::ordering(&network, &[]).and_then(|ordering| with(&ordering, at, near));
        let whole = first.or_else(|fault| rank::reopened(&network, fault, at, near, with));
        whole.and_then(Solver::between_stops)
    }

    fn with(
        network: &Network<'_>,
        ordering: &Ordering,
        at: f64,
        near: &[(PointId, Vec2)],
        picks: &[(ElementId, Pick)],
    ) -> Result<Solver, Fault> {
        let mechanism = network.mechanism;
        let (plan, program) = chain::build(network, ordering, chain::Dyads::Closed)?;
        let slides = mechanism.slides().len();
        let mut engine = Engine::new(mechanism, network.frame, program);
        let exact = Exact::new(&engine, network, ordering);
        let mut state = engine.state(slides);
        let request = Request::new(&plan, at, near, picks)?;
        let begun = assemble::assemble(
            &mut engine,
            network,
            &plan,
            &request,
            exact.as_ref(),
            &mut state,
        )?;
        let motion = motion::explore(&engine, exact.as_ref(), begun.at, &state)?;
        if let Some(stuck) = begun.stuck.filter(|_| !motion.covers(at)) {
            return Err(stuck);
        }
        let first_loop = classify::classify(&engine, mechanism);
        let mut solver = Solver {
            mechanism: mechanism.clone(),
            first_loop,
            engine,
            exact: exact.map(Arc::new),
            ordering: ordering.clone(),
            plan,
            motion,
            slides,
            opening: begun.at,
            rank: Rank::default(),
            balance: None,
        };
        solver.balance = Balance::new(network, &solver);
        Ok(solver)
    }

    /// The mechanism that it solves.
    #[must_use]
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// The groups in the order in which they are solved.
    #[must_use]
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// What the rank of the constraints says: which repeat others, and whether that is certain.
    #[must_use]
    pub fn rank(&self) -> &Rank {
        &self.rank
    }

    /// The whole motion: the driver's range.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The same solver, without the groups and points that `demand` does not depend on.
    #[must_use]
    pub fn only(&self, demand: &Demand) -> Solver {
        Solver {
            engine: self.engine.only(demand, self.slides),
            exact: self
                .exact
                .as_ref()
                .map(|e| Arc::new(e.only(demand, self.slides))),
            balance: self.balance.clone().filter(|_| demand.forces),
            ..self.clone()
        }
    }

    /// The loop of the driven link, a dyad and the ground, if the mechanism begins with one.
    #[must_use]
    pub fn first_loop(&self) -> Option<DrivenLoop> {
        self.first_loop
    }

    /// Room for a state: all that solving needs.
    #[must_use]
    pub fn state(&self) -> Workspace {
        let mut work = self.room();
        work.close = self.close_state().map(Box::new);
        work
    }

    /// Room for a state in any arithmetic.
    fn room<T: Number>(&self) -> Workspace<T> {
        self.room_of(&self.engine)
    }

    /// The same with the constants of an engine, at the speed of this solver.
    fn room_of<T: Number>(&self, engine: &Engine) -> Workspace<T> {
        let mut work = engine.state(self.slides);
        work.state.pass(self.engine.driver_rates());
        self.with_forces(work)
    }

    /// Makes room for the forces, where anything acts.
    fn with_forces<T: Number>(&self, mut work: Workspace<T>) -> Workspace<T> {
        let balance = self.balance.as_ref();
        work.state.forces = balance.map(|b| b.room(&self.engine));
        work
    }

    /// Room for what is looked at in twice the digits, from the numbers that are meant.
    fn close_state<T: Number>(&self) -> Option<State<T>> {
        Some(self.exact.as_ref()?.state(self.slides))
    }

    /// Whether anything acts on the mechanism: a load, a weight or inertia.
    #[must_use]
    pub fn has_forces(&self) -> bool {
        self.balance.is_some()
    }

    /// The reactions that a redundant linkage leaves open: any force of the constraint that repeats others
    /// is in equilibrium.
    #[must_use]
    pub fn indeterminate(&self) -> &[Indeterminate] {
        self.balance.as_ref().map_or(&[], |b| b.indeterminate())
    }

    /// Solves for the driver's coordinate `at` (deg, or the scene's length unit), not wrapped.
    ///
    /// The result depends on `at` alone, never on what the room held before. Allocates nothing.
    pub fn solve(&self, at: f64, order: Order, work: &mut Workspace) -> Condition {
        let is_solved = self.motion.is_clear(at)
            && matches!(
                self.run_between(at, order, work),
                Condition::Ok | Condition::ChangePoint
            );
        if !is_solved {
            self.solve_closely(at, order, work);
        } else if work.state.is_thin() {
            self.refine(at, order, work);
        }
        if self.follows_forces(work) {
            self.find_forces(order, work);
        }
        work.condition
    }

    /// Whether there are forces to find, or old ones to forget.
    #[inline(always)]
    fn follows_forces<T>(&self, work: &Workspace<T>) -> bool {
        self.has_forces() || work.state.forces.is_some()
    }

    /// Out of the way of what is solved without any.
    #[inline(never)]
    fn find_forces(&self, order: Order, work: &mut Workspace) {
        self.balance(order, work);
    }

    /// The forces of a state that has been solved; none where they were not asked for.
    #[inline(always)]
    fn balance<T: Number>(&self, order: Order, work: &mut Workspace<T>) {
        Balance::follow(self.balance.as_deref(), &self.engine, order, work);
    }

    /// Solves at a coordinate of the range, from the motion as it is known there.
    fn run(&self, at: f64, order: Order, work: &mut Workspace) -> Condition {
        if let Some(fold) = self.motion.fold_at(at) {
            self.aim(at, work);
            return self.engine.run_folded(fold, work);
        }
        self.run_between(at, order, work)
    }

    /// The same between the ends of the range, where no group folds.
    #[inline(always)]
    fn run_between(&self, at: f64, order: Order, work: &mut Workspace) -> Condition {
        self.motion.anchors.aim(&self.engine, at, work);
        if self.motion.passages.is_empty() {
            self.engine.run(at, order, work)
        } else {
            self.run_past(at, order, work)
        }
    }

    /// The same of a motion with change points.
    #[inline(never)]
    fn run_past(&self, at: f64, order: Order, work: &mut Workspace) -> Condition {
        let passages = &self.motion.passages;
        passages.choose(&self.engine, at, &mut work.state.signs);
        if passages.is_near(&self.engine, at) {
            let steps = 0..self.engine.program.steps.len();
            self.engine.run_near(steps, at, order, passages, work)
        } else {
            self.engine.run(at, order, work)
        }
    }

    /// Puts into the room what the motion tells of a coordinate: the signs of all groups, and where coupled
    /// ones are looked for.
    fn aim(&self, at: f64, work: &mut Workspace) {
        self.motion.anchors.aim(&self.engine, at, work);
        let passages = &self.motion.passages;
        if !passages.is_empty() {
            passages.choose(&self.engine, at, &mut work.state.signs);
        }
    }

    /// Whether a series stands in for a group at a coordinate.
    fn is_passing(&self, at: f64) -> bool {
        let passages = &self.motion.passages;
        !passages.is_empty() && passages.is_near(&self.engine, at)
    }
}

/// The plan and the motion; the program behind them is long and says nothing to a reader.
impl std::fmt::Debug for Solver {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Solver")
            .field("plan", &self.plan)
            .field("range", &self.motion.range)
            .finish_non_exhaustive()
    }
}

/// A number of turns in degrees.
fn angle_turn(turns: usize) -> f64 {
    crate::angle::TURN * turns as f64
}
