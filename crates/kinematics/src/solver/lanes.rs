//! Solves at several coordinates of the driver at once, in the lanes of the machine's vector
//! registers.
//!
//! The steps are those of a single state, generic over an arithmetic of several doubles.

use super::elements::{ACCELERATION, POSITION, StepOutcome, VELOCITY};
use super::engine::Engine;
use super::state::{Condition, State};
use super::{Order, Solver, Workspace};
use crate::{LANES, Lanes, vectorized};

impl Solver {
    /// Creates a workspace for the states at several coordinates.
    #[must_use]
    pub fn lanes(&self) -> Workspace<Lanes> {
        self.workspace()
    }

    /// Solves for several of the driver's coordinates at once. Returns `true` if each of them is an
    /// ordinary one. Returns `false` if not, and for every mechanism with a coupled group. Then
    /// `work` is meaningless, and the coordinates must be solved one by one.
    ///
    /// Each lane has the same bits as [`Solver::solve`] at its coordinate, and is
    /// [`Condition::Ok`]. Allocates nothing.
    #[must_use]
    pub fn solve_lanes(
        &self,
        at: [f64; LANES],
        order: Order,
        workspace: &mut Workspace<Lanes>,
    ) -> bool {
        let state = &mut workspace.state;
        state.condition = Condition::NoAssembly;
        let is_smooth = order < Order::Force || self.balance.as_ref().is_none_or(|b| b.is_smooth());
        let solved = self.engine.program.coupled.is_empty()
            && is_smooth
            && self.are_ordinary(at)
            && {
                self.choose_in_lanes(at, state);
                self.engine.run_lanes(Lanes(at), order, state)
            }
            && !state.is_thin;
        if solved {
            state.condition = Condition::Ok;
        }
        if self.follows_forces(workspace) {
            self.balance_lanes(order, workspace);
        }
        solved && !workspace.state.withholds()
    }

    /// Computes the forces with the vector instructions that run the steps.
    fn balance_lanes(&self, order: Order, workspace: &mut Workspace<Lanes>) {
        vectorized(
            #[inline(always)]
            || self.balance(order, workspace),
        );
    }

    /// Returns `true` if all coordinates are inside the motion and away from its singularities.
    #[inline(always)]
    fn are_ordinary(&self, at: [f64; LANES]) -> bool {
        Lanes(at).all(|at| self.motion.is_clear(at))
            && (self.motion.crossings.is_empty() || !at.into_iter().any(|at| self.is_passing(at)))
    }

    /// Sets the signs of all groups in all lanes. Change points may lie between the lanes.
    #[inline(always)]
    pub(super) fn choose_in_lanes(&self, at: [f64; LANES], state: &mut State<Lanes>) {
        let crossings = &self.motion.crossings;
        if crossings.is_empty() {
            return;
        }
        for (signs, &start) in state.signs.iter_mut().zip(&self.engine.signs) {
            *signs = Lanes([start; LANES]);
        }
        for (lane, at) in at.into_iter().enumerate() {
            for group in crossings.changed(at) {
                let sign = &mut state.signs[group].0[lane];
                *sign = -*sign;
            }
        }
    }
}

impl Engine {
    /// Runs all steps in all lanes. Returns `true` if all succeed, and `false` if an input follows
    /// a table, since its lanes could lie in different parts of the table.
    pub(super) fn run_lanes(&self, at: Lanes, order: Order, state: &mut State<Lanes>) -> bool {
        !self.has_tables()
            && vectorized(
                #[inline(always)]
                || self.run_lanes_here(at, order, state),
            )
    }

    /// Runs all steps with the instructions for which the surrounding code is compiled.
    #[inline(always)]
    fn run_lanes_here(&self, at: Lanes, order: Order, state: &mut State<Lanes>) -> bool {
        state.start(at, order);
        match order {
            Order::Position => self.run_lanes_to::<POSITION>(at, state),
            Order::Velocity => self.run_lanes_to::<VELOCITY>(at, state),
            Order::Acceleration | Order::Force => self.run_lanes_to::<ACCELERATION>(at, state),
        }
    }

    #[inline(always)]
    fn run_lanes_to<const ORDER: u8>(&self, at: Lanes, state: &mut State<Lanes>) -> bool {
        let (q, direction) = self.coordinate_with_angle(at);
        for step in &self.program.steps {
            match step.run::<Lanes, ORDER>(q, direction, state) {
                StepOutcome::Done => {}
                // Some lane needs a closer evaluation.
                StepOutcome::Unclear | StepOutcome::Stretched | StepOutcome::Open => return false,
            }
        }
        true
    }
}

#[cfg(any(test, feature = "testing"))]
pub(super) mod testing;
