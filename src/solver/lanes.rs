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
            };
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

#[cfg(test)]
mod tests {
    use super::super::state::{LinkState, PointState, TravelState};
    use super::*;
    use crate::scene::{Scene, presets};
    use crate::solver::Range;

    const ORDERS: [Order; 3] = [Order::Position, Order::Velocity, Order::Acceleration];

    /// Everything in a state that a figure is read from, and the measures.
    fn numbers<T: Copy>(state: &State<T>) -> Vec<T> {
        let mut all = vec![state.at];
        for &PointState { p, v, a } in &state.points {
            all.extend([p.x, p.y, v.x, v.y, a.x, a.y]);
        }
        let turning = |l: LinkState<T>| [l.d.x, l.d.y, l.w, l.a];
        all.extend(state.links.iter().flat_map(|&l| turning(l)));
        for &TravelState { s, v, a, guide } in &state.travels {
            all.extend([s, v, a]);
            all.extend(turning(guide));
        }
        all.extend(&state.measures);
        all
    }

    /// Coordinates over the motion and a little beyond, closer than the lanes' own width in degrees.
    fn coordinates(solver: &Solver) -> Vec<f64> {
        let (low, high) = match solver.motion().range {
            Range::Full { period } => (-period, period),
            Range::Limited { low, high } => (low, high),
        };
        let beyond = 0.01 * (high - low);
        let at = |k: i32| low - beyond + (high - low + 2.0 * beyond) * f64::from(k) / 1999.0;
        (0..2000).map(at).collect()
    }

    /// Holds every lane against the same state alone, with all that the machine has and with what
    /// every machine has; gives the parts of the coordinates that were solved at once.
    fn part_in_lanes(solver: &Solver, order: Order) -> f64 {
        let (mut state, mut lanes, mut plain) = (solver.state(), solver.lanes(), solver.lanes());
        let coordinates = coordinates(solver);
        let blocks = coordinates.as_chunks::<LANES>().0;
        let mut solved = 0.0;
        for &at in blocks {
            if !solver.solve_lanes(at, order, &mut lanes) {
                continue;
            }
            solved += 1.0;
            solver.choose_in_lanes(at, &mut plain.state);
            let here = &mut plain.state;
            assert!(solver.engine.run_lanes_here(Lanes(at), order, here));
            let both = [numbers(&lanes), numbers(&plain)];
            for (lane, &at) in at.iter().enumerate() {
                assert_eq!(
                    solver.solve(at, order, &mut state),
                    Condition::Ok,
                    "at {at}"
                );
                let alone = numbers(&state);
                for found in &both {
                    let pairs = found.iter().zip(&alone);
                    let mut same = pairs.map(|(f, a)| f.0[lane].to_bits() == a.to_bits());
                    assert!(same.all(|same| same), "lane {lane} at {at}");
                }
            }
        }
        solved / blocks.len() as f64
    }

    #[test]
    fn every_preset_has_the_same_bits_in_lanes_as_alone() {
        for preset in presets::all() {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap();
            let coupled = !solver.engine.program.coupled.is_empty();
            for order in ORDERS {
                let part = part_in_lanes(&solver, order);
                if coupled {
                    assert_eq!(part, 0.0, "{} is solved one by one", preset.name);
                } else {
                    assert!(part > 0.9, "{}: only {part} at once", preset.name);
                }
            }
        }
    }
}
