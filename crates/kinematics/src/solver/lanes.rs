//! Several coordinates of the driver at once, in the lanes of the machine's vector registers.
//!
//! The steps are those of a single state, written once, in an arithmetic of several doubles.

use super::elements::{ACCELERATION, POSITION, StepOutcome, VELOCITY};
use super::engine::Engine;
use super::state::{Condition, State};
use super::{Order, Solver, Workspace};
use crate::{LANES, Lanes, vectorized};

impl Solver {
    /// Room for the states at several coordinates.
    #[must_use]
    pub fn lanes(&self) -> Workspace<Lanes> {
        self.room()
    }

    /// Solves for several of the driver's coordinates at once, if each is an ordinary one; otherwise,
    /// and for every mechanism with a coupled group, says `false`: then they want to be solved one by
    /// one, and what is in `state` means nothing.
    ///
    /// Each lane has the bits that [`Solver::solve`] gives for its coordinate, and is
    /// [`Condition::Ok`]. Allocates nothing.
    #[must_use]
    pub fn solve_lanes(&self, at: [f64; LANES], order: Order, work: &mut Workspace<Lanes>) -> bool {
        let state = &mut work.state;
        state.condition = Condition::NoAssembly;
        let is_smooth = order < Order::Force || self.balance.as_ref().is_none_or(|b| b.is_smooth());
        let solved = self.engine.program.coupled.is_empty()
            && is_smooth
            && at.iter().all(|&at| self.is_ordinary(at))
            && {
                self.choose_in_lanes(at, state);
                self.engine.run_lanes(Lanes(at), order, state)
            }
            && !state.is_thin();
        if solved {
            state.condition = Condition::Ok;
        }
        if self.follows_forces(work) {
            self.balance_lanes(order, work);
        }
        solved && !work.state.withholds()
    }

    /// With the instructions that the steps are run with.
    fn balance_lanes(&self, order: Order, work: &mut Workspace<Lanes>) {
        vectorized(
            #[inline(always)]
            || self.balance(order, work),
        );
    }

    /// Neither outside the motion nor at or near one of its singular places.
    fn is_ordinary(&self, at: f64) -> bool {
        self.motion.is_clear(at) && !self.is_passing(at)
    }

    /// Change points may lie between the lanes.
    pub(super) fn choose_in_lanes(&self, at: [f64; LANES], state: &mut State<Lanes>) {
        let passages = &self.motion.passages;
        if passages.is_empty() {
            return;
        }
        for (signs, &start) in state.signs.iter_mut().zip(&self.engine.signs) {
            *signs = Lanes([start; LANES]);
        }
        for (lane, at) in at.into_iter().enumerate() {
            for group in passages.changed(at) {
                let sign = &mut state.signs[group].0[lane];
                *sign = -*sign;
            }
        }
    }
}

impl Engine {
    /// Whether all steps are done in all lanes; none where the lanes of an input would lie in different parts of its
    /// table.
    pub(super) fn run_lanes(&self, at: Lanes, order: Order, state: &mut State<Lanes>) -> bool {
        !self.has_tables()
            && vectorized(
                #[inline(always)]
                || self.run_lanes_here(at, order, state),
            )
    }

    /// With the instructions that the code around is compiled for.
    #[inline(always)]
    fn run_lanes_here(&self, at: Lanes, order: Order, state: &mut State<Lanes>) -> bool {
        state.begin(at, order);
        match order {
            Order::Position => self.run_lanes_to::<POSITION>(at, state),
            Order::Velocity => self.run_lanes_to::<VELOCITY>(at, state),
            Order::Acceleration | Order::Force => self.run_lanes_to::<ACCELERATION>(at, state),
        }
    }

    #[inline(always)]
    fn run_lanes_to<const ORDER: u8>(&self, at: Lanes, state: &mut State<Lanes>) -> bool {
        let (q, direction) = self.coordinate(at);
        for step in &self.program.steps {
            match step.run::<Lanes, ORDER>(q, direction, state) {
                StepOutcome::Done => {}
                // Some lane wants to be looked at more closely.
                StepOutcome::Unclear | StepOutcome::Stretched | StepOutcome::Open => return false,
            }
        }
        true
    }
}

#[cfg(any(test, feature = "testing"))]
pub(super) mod testing;
