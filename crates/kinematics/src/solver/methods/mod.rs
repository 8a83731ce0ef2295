//! Solves the mechanism by other methods, for comparison.
//!
//! The same network of constraints, in the same order, becomes a second program. In it every group,
//! dyads included, is a list of rows with unknowns, as only coupled groups are in the first
//! program. Residuals, rates and matrices of all methods therefore come from one source.

mod deviation;
mod integration;
mod method;
mod runner;

pub use deviation::Deviation;
pub use integration::DriftMethod;
pub use method::{Method, Start, Unsuitable};
pub use runner::Runner;

use super::coupled::{ClosingCondition, Coupled, Scratch};
use super::elements::ACCELERATION;
use super::engine::Engine;
use super::plan::network::Network;
use super::state::State;
use super::{Condition, Group, GroupKind, Order, Range, Solver, Workspace, chain};
use crate::{Double, LinkId, Mechanism, Number, PointId};
use deviation::Subjects;

/// A mechanism ready to be solved by any method.
pub struct Methods {
    solver: Solver,
    slides: usize,
    /// Every group by its rows; `None` if they cannot be listed.
    rows: Option<RowProgram>,
    subjects: Subjects,
    reference: Workspace<Double>,
    /// A state solved by the solver itself.
    guide: Workspace,
    /// The side of every group of rows at the last look-up.
    sides: Vec<f64>,
}

/// The program in which every group is a list of rows.
struct RowProgram {
    engine: Engine,
    /// A workspace for reading states.
    probe: Workspace,
    /// The points and links of earlier groups that each group reads.
    inputs: Vec<(Vec<PointId>, Vec<LinkId>)>,
    /// The one unknown angle of each group.
    closings: Vec<Option<ClosingCondition>>,
    /// The unknowns at the scene's start position.
    opening: Scratch,
}

impl Methods {
    /// Prepares the mechanism of a solver for all methods.
    pub fn new(solver: &Solver) -> Methods {
        let mechanism = solver.mechanism();
        Methods {
            rows: RowProgram::new(mechanism, solver),
            subjects: Subjects::new(mechanism, solver),
            slides: mechanism.slides().len(),
            reference: solver.twice(),
            guide: solver.state(),
            sides: Vec::new(),
            solver: solver.clone(),
        }
    }

    /// Returns the longest length of the mechanism, in the scene's unit.
    pub fn longest(&self) -> f64 {
        self.subjects.longest * self.solver.engine.frame.scale
    }

    /// Returns the number of unknowns of all groups as rows.
    pub fn unknowns(&self) -> usize {
        let groups = self
            .rows
            .iter()
            .flat_map(|rows| &rows.engine.program.coupled);
        groups.map(Coupled::unknowns).sum()
    }

    /// Returns the range of the motion.
    pub fn range(&self) -> Range {
        self.solver.motion().range
    }

    /// Checks whether a method can be used for this mechanism.
    ///
    /// # Errors
    /// The reason if not.
    pub fn usable(&self, method: Method) -> Result<(), Unsuitable> {
        let groups = &self.solver.plan().groups;
        let coupled = groups
            .iter()
            .find(|g| matches!(g.kind, GroupKind::Coupled { .. }));
        let closed = coupled.map_or(Ok(()), |group| Err(Unsuitable::Coupled(group.point)));
        let rows = self.rows.as_ref().ok_or(Unsuitable::NoRows);
        match method {
            Method::ClosedForm => closed,
            Method::Bounded | Method::Single => Ok(()),
            Method::Polished => closed.and(rows.map(|_| ())),
            Method::Anchored => coupled.map(|_| ()).ok_or(Unsuitable::AllClosed),
            Method::Newton { .. } => rows.map(|_| ()),
            Method::Bisection => rows?.one_condition_each(groups),
            Method::Integration { .. } => match self.range() {
                Range::Full { .. } => rows.map(|_| ()),
                Range::Limited { .. } => Err(Unsuitable::Limits),
            },
        }
    }

    /// Computes the reference state at a coordinate, in double-double. Returns `false` if the
    /// mechanism has no state there or is at a singular position.
    pub fn compute_reference(&mut self, at: f64) -> bool {
        if self.solver.solve(at, Order::Acceleration, &mut self.guide) != Condition::Ok {
            return false;
        }
        if let Some(rows) = &mut self.rows {
            rows.set_from_state(at, &self.guide, &mut self.sides);
        }
        let Methods {
            solver,
            guide,
            reference,
            ..
        } = self;
        solver.solve_twice(guide, Order::Acceleration, reference)
            && self.subjects.sizes(reference).is_finite()
    }

    /// Returns `true` if a state of rows has the same assembly as the state looked up last, judged
    /// by the sides of its groups.
    fn is_same_assembly(&self, workspace: &mut Workspace) -> bool {
        let Some(rows) = &self.rows else { return true };
        let (q, _) = rows.engine.coordinate(self.guide.at);
        let Workspace { state, scratch, .. } = workspace;
        let groups = rows.engine.program.coupled.iter().zip(&self.sides);
        let mut sides = groups.map(|(group, side)| side * group.side_at(q, state, scratch));
        sides.all(|product| product >= 0.0)
    }

    /// Moves the guide state to a coordinate, for methods that begin there, without a look-up.
    pub fn guide_to(&mut self, at: f64) {
        let _ = self.solver.solve(at, Order::Position, &mut self.guide);
    }

    /// Returns the maximum velocity and acceleration of the state looked up last.
    pub fn sizes(&self) -> Deviation {
        self.subjects.sizes(&self.reference)
    }
}

/// Copies the assembly and the unknowns of the coupled groups from a state of the solver.
fn follow<T: Number>(guide: &Workspace, workspace: &mut Workspace<T>) {
    for (to, from) in workspace.state.signs.iter_mut().zip(&guide.signs) {
        *to = T::exactly(*from);
    }
    let numbers = workspace.scratch.numbers.iter_mut();
    for (to, from) in numbers.zip(&guide.scratch.numbers) {
        *to = T::exactly(*from);
    }
}

/// Runs a program in any arithmetic; `solve` finds z of each coupled group. Returns `true` if
/// everything was found.
fn run<T: Number, const ORDER: u8>(
    engine: &Engine,
    at: T,
    workspace: &mut Workspace<T>,
    mut solve: impl FnMut(&Coupled, T, &State<T>, &mut Scratch<T>) -> bool,
) -> bool {
    engine.run_in::<T, ORDER>(at, workspace, |group, q, state, scratch| {
        solve(group, q, state, scratch) && group.finish(q, ORDER, state, scratch)
    })
}

impl RowProgram {
    fn new(mechanism: &Mechanism, solver: &Solver) -> Option<RowProgram> {
        let frame = solver.engine.frame;
        let network = Network::new(mechanism, frame);
        let (_, program) = chain::build(&network, &solver.ordering, chain::Dyads::AsRows).ok()?;
        let engine = Engine::new(mechanism, frame, program);
        let groups = &engine.program.coupled;
        let mut rows = RowProgram {
            inputs: groups.iter().map(Coupled::inputs).collect(),
            closings: groups.iter().map(Coupled::closing).collect(),
            probe: engine.state(mechanism.slides().len()),
            opening: Scratch::default(),
            engine,
        };
        rows.open(mechanism.driver().start, solver)?;
        Some(rows)
    }

    /// Finds z and the side of every group at the scene's start position.
    fn open(&mut self, start: f64, solver: &Solver) -> Option<()> {
        let (mut guide, mut sides) = (solver.state(), Vec::new());
        let _ = solver.solve(start, Order::Acceleration, &mut guide);
        let solved = self.set_from_state(start, &guide, &mut sides);
        for (group, side) in self.engine.program.coupled.iter_mut().zip(sides) {
            group.side = side;
        }
        self.opening = self.probe.scratch.clone();
        solved.then_some(())
    }

    /// Sets every group to its values in a state of the solver, and collects the sides.
    fn set_from_state(&mut self, at: f64, guide: &State, sides: &mut Vec<f64>) -> bool {
        sides.clear();
        let probe = &mut self.probe;
        run::<_, ACCELERATION>(&self.engine, at, probe, |group, q, state, scratch| {
            group.read(guide, group.open(scratch).z);
            sides.push(group.side_at(q, state, scratch));
            true
        })
    }

    /// Returns -1 if the motion has passed change points of a group an odd number of times since
    /// the start position, 1 if not. Derived from the signs of the dyads in closed form, if every
    /// group is one.
    fn flip(&self, number: usize, solver: &Solver, signs: &[f64]) -> f64 {
        let dyads = solver.plan.groups.len().saturating_sub(1);
        if dyads != self.closings.len() {
            return 1.0;
        }
        // The driver is the first group.
        signs[number + 1] * solver.engine.signs[number + 1]
    }

    fn one_condition_each(&self, planned: &[Group]) -> Result<(), Unsuitable> {
        let groups = self.engine.program.coupled.iter();
        let mut others = groups.zip(&self.closings).filter(|(_, c)| c.is_none());
        others.next().map_or(Ok(()), |(group, _)| {
            // Uses the same name as elsewhere: the point that names the group in the plan.
            let joint = group.joints().next();
            let holds = |group: &&Group| joint.is_some_and(|joint| group.points.contains(&joint));
            let named = planned.iter().find(holds).and_then(|group| group.point);
            Err(Unsuitable::Conditions {
                point: named.or(joint),
                unknowns: group.unknowns(),
            })
        })
    }
}
