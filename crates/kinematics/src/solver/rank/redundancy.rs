//! Finds the constraints that each set-aside constraint repeats, and their disagreement.

use super::rows::{RankPose, Rows};
use super::spectrum::IndependentRows;
use super::{MAX_UNKNOWNS, Redundancy};
use crate::solver::plan::network::{Network, ScalarEquation};
use crate::solver::plan::order;
use crate::solver::state::{Condition, State};
use crate::solver::{Order, Range, Solver};
use crate::{ElementId, Vec2};

/// Positions besides the start at which a motion is examined, as fractions of its range: away from
/// positions of symmetry.
const EXAMINED_FRACTIONS: [f64; 2] = [0.291, 0.637];
/// Coefficients in a sum up to this size are far from a change point.
const MAX_REGULAR_COEFFICIENT: f64 = 1e3;
/// A coefficient in a sum below this is rounding error.
const PART: f64 = 1e-8;

/// Returns states of the motion: at the start and at two other positions.
pub(super) fn reached(solver: &Solver) -> impl Iterator<Item = State> + '_ {
    let (low, high) = match solver.motion.range {
        Range::Full { period } => (solver.opening, solver.opening + period),
        Range::Limited { low, high } => (low, high),
    };
    let elsewhere = EXAMINED_FRACTIONS.map(|part| low + part * (high - low));
    let places = std::iter::once(solver.opening).chain(elsewhere);
    places.filter_map(|at| {
        let mut workspace = solver.state();
        let solved = solver.solve(at, Order::Position, &mut workspace) != Condition::NoAssembly;
        solved.then(|| workspace.into_state())
    })
}

/// Returns the pose of every joint and every class of links in a state.
pub(super) fn pose_of(network: &Network<'_>, state: &State) -> RankPose {
    let points = network.mechanism.points().len();
    let class = |members: &Vec<crate::LinkId>| {
        let first = members.first().map(|&link| {
            let turn = network.turn[link.index()].nearest();
            state.links[link.index()].d.turned(turn.conj())
        });
        first.unwrap_or(Vec2::X)
    };
    RankPose {
        points: state.points.iter().take(points).map(|p| p.p).collect(),
        classes: network.members.iter().map(class).collect(),
    }
}

/// Returns every element with redundant constraints.
pub(super) fn redundancies(network: &Network<'_>, solver: &Solver) -> Vec<Redundancy> {
    let set_aside = &solver.ordering.set_aside;
    let sums = sums(network, solver);
    let mut found: Vec<Redundancy> = Vec::new();
    for (i, row) in set_aside.iter().enumerate() {
        let element = row.element();
        let repeats = sums.get(i).map_or(&[][..], |rows| rows);
        let known = found.iter().position(|r| r.element == element);
        let redundancy = match known {
            Some(known) => &mut found[known],
            None => {
                found.push(Redundancy {
                    element,
                    constraints: 0,
                    repeats: Vec::new(),
                    misfit: 0.0,
                });
                let last = found.len() - 1;
                &mut found[last]
            }
        };
        redundancy.constraints += 1;
        for other in order::elements(repeats) {
            if other != element && !redundancy.repeats.contains(&other) {
                redundancy.repeats.push(other);
            }
        }
    }
    for redundancy in &mut found {
        redundancy.misfit = misfit(solver, redundancy);
    }
    let scale = solver.engine.frame.scale * solver.engine.frame.longest;
    found.extend(network.repeated_locks.iter().map(|&slide| Redundancy {
        element: ElementId::Slide(slide),
        constraints: 1,
        repeats: Vec::new(),
        misfit: network.lock_disagreement * scale,
    }));
    found
}

/// Returns, for every set-aside constraint, the constraints of which it is the sum.
fn sums(network: &Network<'_>, solver: &Solver) -> Vec<Vec<ScalarEquation>> {
    let ordering = &solver.ordering;
    if ordering.set_aside.is_empty() {
        return Vec::new();
    }
    let mut over: Vec<ScalarEquation> = Vec::new();
    let mut seen = std::collections::HashSet::new();
    over.extend(ordering.over.iter().filter(|&&row| seen.insert(row)));
    let unknowns = over.iter().flat_map(|&row| network.unknowns(row));
    let unknowns: Vec<_> = unknowns.collect();
    let rows = Rows::new(network, solver.engine.frame, over, unknowns);
    if rows.width > MAX_UNKNOWNS {
        return Vec::new();
    }
    let place = |row: &ScalarEquation| rows.rows.iter().position(|r| r == row);
    let aside: Vec<usize> = ordering.set_aside.iter().filter_map(place).collect();
    let kept = (0..rows.rows.len())
        .filter(|i| !aside.contains(i))
        .collect::<Vec<_>>();
    // Near a change point of the kept constraints the coefficients grow without bound, so the
    // position with the smallest is used.
    let mut choices = reached(solver).map(|state| {
        let matrix = rows.matrix(state.at, &pose_of(network, &state));
        let matrix = matrix.columns(0, rows.width).into_owned();
        IndependentRows::new(&matrix, kept.clone(), aside.clone())
    });
    let Some(mut smoothest) = choices.next() else {
        return Vec::new();
    };
    while smoothest.largest() > MAX_REGULAR_COEFFICIENT {
        match choices.next() {
            Some(other) if other.largest() < smoothest.largest() => smoothest = other,
            Some(_) => {}
            None => break,
        }
    }
    let sum = |i| {
        let rows = smoothest
            .repeated_by(i, PART)
            .into_iter()
            .map(|i| rows.rows[i]);
        rows.collect()
    };
    (0..aside.len()).map(sum).collect()
}

/// Returns the maximum disagreement over the motion of the constraints that repeat each other.
fn misfit(solver: &Solver, redundancy: &Redundancy) -> f64 {
    let watches = solver.engine.program.watches.iter();
    let of = |element| element == redundancy.element || redundancy.repeats.contains(&element);
    let ours = watches
        .zip(&solver.motion.misfits)
        .filter(|(w, _)| of(w.element));
    let largest = ours.map(|(_, &miss)| miss).fold(0.0, f64::max);
    largest * solver.engine.frame.scale
}
