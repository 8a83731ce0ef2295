//! Solves a mechanism: computes its state from the driver's coordinate.
//!
//! [`Solver::new`] does the work needed only once. It orders the constraint network into groups,
//! turns the groups into elementary steps, selects each group's assembly near the start, and
//! follows the whole motion. [`Solver::solve`] then runs the steps at any coordinate, in any order.
//! It keeps no history and does not allocate.
//!
//! ```text
//! once       plan       network: the constraints of points, links and slides; order: those solved
//!                       together, and the order of solving; pruning: the steps of a demand
//!            rank       redundant constraints and free motions, from the dimensions
//!            chain      converts groups to steps: dyads in closed form, the rest coupled
//!            assemble   the selected assembly at the start, and the alternatives
//!            motion     the range, its limits and change points  change_point  their crossings
//!            stops      the coordinates at which the motion meets the end of a limit
//! each time  workspace  the state, which is the result, and the memory to compute it
//!            engine     runs the steps: elements (closed forms), coupled (Newton's method with lu)
//!            exact      near an end: in double-double, from the typed decimals
//!            lanes      several coordinates at once
//!            bounds     error bounds
//!            forces     runs the steps backwards: joint forces, and the driver's torque or force
//! also       transmission, conditioning, dead_centres (of slides), classify,
//!            by_length (derivatives), methods (other methods, for comparison),
//!            free_inputs (each input by itself, and inputs that follow a point)
//! ```
//!
//! Formulas of steps and coupled groups are written once, generic over [`crate::Number`].

mod assemble;
mod bounds;
mod by_length;
mod chain;
mod change_point;
mod classify;
mod conditioning;
mod coupled;
mod dead_centres;
mod elements;
mod engine;
mod exact;
mod fault;
mod forces;
mod frame;
mod free_inputs;
mod further_inputs;
mod known_states;
mod lanes;
mod lu;
mod margin;
mod methods;
mod motion;
mod plan;
mod rank;
mod speed;
mod state;
mod stops;
mod transmission;
mod varied;
mod workspace;

pub use assemble::choices::{Assemblies, Choice, MAX_ASSEMBLIES};
pub use by_length::ByLength;
pub use classify::{DrivenLoop, Grashof, Inversion, LoopKind};
pub use conditioning::Conditioning;
pub use coupled::{Newton, NewtonRow, NewtonUnknown};
pub use dead_centres::DeadCentre;
pub use fault::{Fault, OpenChoice};
pub use forces::{
    ForceCheck, Indeterminate, LeastNorm, LoadAction, PressStroke, Residual, WithheldReason,
};
pub use free_inputs::point_lead::{LeadSingularity, LedPose, LedPosition, LedReach, PointLeader};
pub use free_inputs::{FreeInputs, InputMoment};
pub use known_states::Known;
pub use methods::{Deviation, DriftMethod, Methods, Runner};
pub use methods::{Method, Start, Unsuitable};
pub use motion::{EndStop, MeetingAssemblies, Motion, NearMiss, Range};
pub use plan::{AssemblyChoice, Group, GroupId, GroupKind, Plan};
pub use rank::{Rank, Redundancy};
pub use state::Sliding;
pub use state::{Condition, State, Travel};
pub use transmission::{Extreme, Transmission};
pub use varied::Varied;
pub use workspace::Workspace;

/// Test hooks for other crates. Not part of the interface.
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
use plan::network::Network;
use plan::order::Ordering;
use std::sync::Arc;

/// The highest order to which a state is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// Positions only.
    Position,
    /// Positions and velocities.
    Velocity,
    /// Positions, velocities and accelerations.
    Acceleration,
    /// Position, velocity, acceleration, and the forces if the mechanism has loads.
    Force,
}

/// The values that a caller reads from a state. The solver leaves out everything else.
#[derive(Clone, Debug, Default)]
pub struct Demand {
    /// Points whose motion is read.
    pub points: Vec<PointId>,
    /// Links whose direction or rotation is read.
    pub links: Vec<LinkId>,
    /// Slides whose guide or travel is read.
    pub slides: Vec<SlideId>,
    /// Whether forces are read. They depend on everything that moves, so nothing is left out.
    pub forces: bool,
}

impl Demand {
    /// Creates a demand for every point, link and slide, without forces.
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

/// A mechanism prepared for solving at any coordinate of its driver.
#[derive(Clone)]
pub struct Solver {
    mechanism: Mechanism,
    engine: Engine,
    /// The same mechanism with typed decimals instead of doubles, for double-double evaluation.
    exact: Option<Arc<Exact>>,
    /// The ordering from which the groups were built, kept to rebuild them for other lengths.
    ordering: Arc<Ordering>,
    plan: Arc<Plan>,
    motion: Motion,
    first_loop: Option<DrivenLoop>,
    slides: usize,
    /// The driver's coordinate at which the scene opens, if the motion reaches it.
    opening: f64,
    /// The result of the rank analysis of the constraints.
    rank: Rank,
    /// The force analysis, if the mechanism has loads.
    balance: Option<Arc<Balance>>,
}

impl Solver {
    /// Creates a solver: plans the mechanism, assembles it at the driver's start and follows its
    /// motion.
    ///
    /// # Errors
    /// Returns the reason why the mechanism as a whole cannot be solved: see [`Fault`].
    pub fn new(mechanism: &Mechanism) -> Result<Solver, Fault> {
        Solver::with_assembly(mechanism, &[])
    }

    /// Creates a solver with given assemblies at the driver's start. As [`Solver::new`], except
    /// that each group named in `picks` ([`Group::name`]) takes the assembly picked for it. All
    /// other groups follow the mechanism's start.
    ///
    /// # Errors
    /// See [`Fault`]. In particular, a pick that its group does not have is an error.
    pub fn with_assembly(
        mechanism: &Mechanism,
        choices: &[(ElementId, AssemblyChoice)],
    ) -> Result<Solver, Fault> {
        let start = mechanism.driver().start;
        Solver::open(mechanism, start, mechanism.start(), choices)
    }

    /// Assembles the mechanism at the coordinate `at`, near approximate positions, and follows its
    /// motion from there.
    fn open(
        mechanism: &Mechanism,
        at: f64,
        near: &[(PointId, Vec2)],
        choices: &[(ElementId, AssemblyChoice)],
    ) -> Result<Solver, Fault> {
        let frame = Frame::of(mechanism);
        let network = Network::new(mechanism, frame);
        if let Some(conflict) = network.conflict {
            let element = ElementId::Slide(conflict.slide);
            let misfit = conflict.misfit.abs() * frame.longest * frame.scale;
            return Err(Fault::OverConstrained {
                element,
                others: Vec::new(),
                misfit,
                at,
            });
        }
        if let Some((link, misfit)) = network.coincident_pins() {
            return Err(Fault::OverConstrained {
                element: ElementId::Link(link),
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
            let solver = Solver::with(&network, ordering, at, near, choices)?;
            rank::with_rank(&network, solver)
        };
        let first =
            plan::order::ordering(&network, &[]).and_then(|ordering| with(&ordering, at, near));
        let complete = first.or_else(|fault| rank::reopened(&network, fault, at, near, with));
        complete.and_then(Solver::between_stops)
    }

    fn with(
        network: &Network<'_>,
        ordering: &Ordering,
        at: f64,
        near: &[(PointId, Vec2)],
        choices: &[(ElementId, AssemblyChoice)],
    ) -> Result<Solver, Fault> {
        let mechanism = network.mechanism;
        let (plan, program) = chain::build(network, ordering, chain::Dyads::Closed)?;
        let slides = mechanism.slides().len();
        let mut engine = Engine::new(mechanism, network.frame, program);
        let exact = Exact::new(&engine, network, ordering);
        let mut state = engine.state(slides);
        let request = Request::new(&plan, at, near, choices)?;
        let started = assemble::assemble(
            &mut engine,
            network,
            &plan,
            &request,
            exact.as_ref(),
            &mut state,
        )?;
        let motion = motion::explore(&engine, exact.as_ref(), started.at, &state)?;
        if !motion.covers(at)
            && let Some(stuck) = started.stuck
        {
            return Err(stuck);
        }
        let first_loop = classify::classify(&engine, mechanism);
        let mut solver = Solver {
            mechanism: mechanism.clone(),
            first_loop,
            engine,
            exact: exact.map(Arc::new),
            ordering: Arc::new(ordering.clone()),
            plan: Arc::new(plan),
            motion,
            slides,
            opening: started.at,
            rank: Rank::default(),
            balance: None,
        };
        if let (Some(expected), Some(stuck)) = (started.expected, started.stuck) {
            let mut workspace = solver.state();
            let condition = solver.solve(at, Order::Position, &mut workspace);
            if condition == Condition::NoAssembly || !expected.are_in(&workspace.state) {
                return Err(stuck);
            }
        }
        solver.balance = Balance::new(network, &solver);
        Ok(solver)
    }

    /// Returns the mechanism.
    #[must_use]
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// Returns the groups in solving order.
    #[must_use]
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Returns the result of the rank analysis: the redundant constraints, and whether the rank is
    /// certain.
    #[must_use]
    pub fn rank(&self) -> &Rank {
        &self.rank
    }

    /// Returns the motion of the mechanism: the driver's range, its ends and its change points.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// Returns a copy of the solver without the groups and points on which `demand` does not
    /// depend.
    #[must_use]
    pub fn only(&self, demand: &Demand) -> Solver {
        let exact = self.exact.as_ref();
        Solver {
            exact: exact.map(|e| Arc::new(e.only(demand, self.slides))),
            balance: self.balance.clone().filter(|_| demand.forces),
            ..self.with_engine(self.engine.only(demand, self.slides))
        }
    }

    /// Returns a copy of the solver with another engine, without copying its own.
    fn with_engine(&self, engine: Engine) -> Solver {
        Solver {
            engine,
            mechanism: self.mechanism.clone(),
            exact: self.exact.clone(),
            ordering: Arc::clone(&self.ordering),
            plan: Arc::clone(&self.plan),
            motion: self.motion.clone(),
            first_loop: self.first_loop,
            slides: self.slides,
            opening: self.opening,
            rank: self.rank.clone(),
            balance: self.balance.clone(),
        }
    }

    /// Returns the loop of the driven link, a dyad and the ground, if the mechanism starts with
    /// one.
    #[must_use]
    pub fn first_loop(&self) -> Option<DrivenLoop> {
        self.first_loop
    }

    /// Creates a workspace with a state and all scratch memory for solving.
    #[must_use]
    pub fn state(&self) -> Workspace {
        let mut workspace = self.workspace();
        workspace.close = self.close_state().map(Box::new);
        workspace
    }

    /// Creates a workspace in any arithmetic.
    fn workspace<T: Number>(&self) -> Workspace<T> {
        self.workspace_for(&self.engine)
    }

    /// Creates a workspace with the constants of `engine`, at the driver speed of this solver.
    fn workspace_for<T: Number>(&self, engine: &Engine) -> Workspace<T> {
        let mut workspace = engine.state(self.slides);
        workspace.state.pass(self.engine.driver_rates());
        self.with_forces(workspace)
    }

    /// Allocates the force values of a workspace if the mechanism has loads.
    fn with_forces<T: Number>(&self, mut workspace: Workspace<T>) -> Workspace<T> {
        let balance = self.balance.as_ref();
        workspace.state.forces = balance.map(|b| b.force_state(&self.engine));
        workspace
    }

    /// Creates a state for double-double evaluation with typed decimals; `None` without an exact
    /// engine.
    fn close_state<T: Number>(&self) -> Option<State<T>> {
        Some(self.exact.as_ref()?.state(self.slides))
    }

    /// Returns `true` if the mechanism has loads, weights or inertia.
    #[must_use]
    pub fn has_forces(&self) -> bool {
        self.balance.is_some()
    }

    /// Returns the reactions that a redundant linkage leaves undetermined: any force of the
    /// redundant constraint is in equilibrium.
    #[must_use]
    pub fn indeterminate(&self) -> &[Indeterminate] {
        self.balance.as_ref().map_or(&[], |b| b.indeterminate())
    }

    /// Solves at the driver's coordinate `at` (degrees, or the scene's length unit), not wrapped.
    ///
    /// The result depends only on `at`, never on earlier contents of the workspace. Allocates
    /// nothing.
    pub fn solve(&self, at: f64, order: Order, workspace: &mut Workspace) -> Condition {
        let is_solved = self.motion.is_clear(at)
            && matches!(
                self.run_between(at, order, workspace),
                Condition::Ok | Condition::ChangePoint
            );
        if !is_solved {
            self.solve_closely(at, order, workspace);
        } else if workspace.state.is_thin {
            self.refine(at, order, workspace);
        }
        if self.follows_forces(workspace) {
            self.find_forces(order, workspace);
        }
        workspace.condition
    }

    /// Returns `true` if there are forces to compute, or old ones to clear.
    #[inline(always)]
    fn follows_forces<T>(&self, workspace: &Workspace<T>) -> bool {
        self.has_forces() || workspace.state.forces.is_some()
    }

    /// Computes the forces. Kept out of line, so that mechanisms without loads do not pay for it.
    #[inline(never)]
    fn find_forces(&self, order: Order, workspace: &mut Workspace) {
        self.balance(order, workspace);
    }

    /// Computes the forces of a solved state, or clears them if `order` does not include forces.
    #[inline(always)]
    fn balance<T: Number>(&self, order: Order, workspace: &mut Workspace<T>) {
        Balance::follow(self.balance.as_deref(), &self.engine, order, workspace);
    }

    /// Solves at a coordinate of the range, starting from the data that the motion keeps there.
    fn run(&self, at: f64, order: Order, workspace: &mut Workspace) -> Condition {
        if let Some(fold) = self.motion.fold_at(at) {
            self.aim(at, workspace);
            return self.engine.run_folded(fold, workspace);
        }
        self.run_between(at, order, workspace)
    }

    /// Solves between the ends of the range, where no group folds.
    #[inline(always)]
    fn run_between(&self, at: f64, order: Order, workspace: &mut Workspace) -> Condition {
        self.motion.anchors.predict(&self.engine, at, workspace);
        if self.motion.crossings.is_empty() {
            self.engine.run(at, order, workspace)
        } else {
            self.run_past(at, order, workspace)
        }
    }

    /// Solves in a motion with change points.
    #[inline(never)]
    fn run_past(&self, at: f64, order: Order, workspace: &mut Workspace) -> Condition {
        let crossings = &self.motion.crossings;
        crossings.choose(&self.engine, at, &mut workspace.state.signs);
        if crossings.is_near(&self.engine, at) {
            let steps = 0..self.engine.program.steps.len();
            self.engine.run_near(steps, at, order, crossings, workspace)
        } else {
            self.engine.run(at, order, workspace)
        }
    }

    /// Writes the motion's data for a coordinate to the workspace: the signs of all groups, and the
    /// starting values of the coupled groups.
    fn aim(&self, at: f64, workspace: &mut Workspace) {
        self.motion.anchors.predict(&self.engine, at, workspace);
        let crossings = &self.motion.crossings;
        if !crossings.is_empty() {
            crossings.choose(&self.engine, at, &mut workspace.state.signs);
        }
    }

    /// Returns `true` if a series replaces a group at a coordinate.
    fn is_passing(&self, at: f64) -> bool {
        let crossings = &self.motion.crossings;
        !crossings.is_empty() && crossings.is_near(&self.engine, at)
    }
}

/// Formats the plan and the range. The program is left out because it is long and hard to read.
impl std::fmt::Debug for Solver {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Solver")
            .field("plan", &self.plan)
            .field("range", &self.motion.range)
            .finish_non_exhaustive()
    }
}

/// Converts a number of turns to degrees.
fn angle_turn(turns: usize) -> f64 {
    crate::angle::TURN * turns as f64
}
