//! Compares lanes with states solved one by one.

use super::*;
use crate::solver::Range;
use crate::solver::state::{LinkState, PointState, TravelState};

/// Returns all numbers of a state from which values are read, and the measures.
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

/// Compares every lane with the same state solved alone, with and without the machine's vector
/// instructions. Returns the share of the coordinates that lanes solve.
///
/// # Panics
/// If any bits differ.
pub fn part_in_lanes(solver: &Solver, order: Order) -> f64 {
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
