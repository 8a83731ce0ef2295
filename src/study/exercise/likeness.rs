//! Whether a mechanism moves as the one does that it was made from.

use crate::angle::TURN;
use crate::scene::figure;
use crate::solver::{DrivenLoop, GroupKind, LoopKind, Order, Range, Solver, Workspace};
use crate::{Input, Mechanism};

/// What has to stay as it is.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MotionKind {
    groups: Vec<GroupKind>,
    redundant: usize,
    first_loop: Option<LoopKind>,
    /// Whether the driver turns fully, and after how many turns the motion repeats.
    period: Option<f64>,
    dead_points: usize,
    change_points: usize,
    misses_nearly: bool,
}

impl MotionKind {
    pub(super) fn of(solver: &Solver) -> MotionKind {
        let (plan, motion) = (solver.plan(), solver.motion());
        MotionKind {
            groups: plan.groups.iter().map(|group| group.kind).collect(),
            redundant: plan.redundant.len(),
            first_loop: solver.first_loop().map(DrivenLoop::kind),
            period: match motion.range {
                Range::Full { period } => Some(period),
                Range::Limited { .. } => None,
            },
            dead_points: motion.dead_points.len(),
            change_points: motion.change_points.len(),
            misses_nearly: !motion.near_misses.is_empty(),
        }
    }
}

/// Degrees between two places of a driver that turns.
const STEP: i32 = 5;
/// Parts of a limited range from either end that are too near to its limits.
const NEAR_END: f64 = 0.1;
/// Places over the range of a driver that is pushed.
const PUSHED: u32 = 16;

/// The places of the motion at which an exercise may stand: multiples of 5 degrees, or numbers of two digits, well
/// inside a limited range.
pub(super) fn places(mechanism: &Mechanism, solver: &Solver) -> Vec<f64> {
    let range = solver.motion().range;
    let (low, high) = match range {
        Range::Full { .. } => (0.0, TURN - 1.0),
        Range::Limited { low, high } => {
            let end = NEAR_END * (high - low);
            (low + end, high - end)
        }
    };
    let inside = |at: &f64| (low..=high).contains(at);
    match mechanism.driver().input {
        Input::Turn(_) => {
            let step = f64::from(STEP);
            let multiples = (-200..=200).map(|n| f64::from(n) * step);
            multiples.filter(inside).collect()
        }
        Input::Push(_) => {
            let part = |n| low + (high - low) * f64::from(n) / f64::from(PUSHED);
            let two_digits = |at: f64| figure(format!("{at:.1e}").parse().ok()?).parse().ok();
            let mut places: Vec<f64> = (0..=PUSHED)
                .filter_map(|n| two_digits(part(n)))
                .filter(inside)
                .collect();
            places.dedup();
            places
        }
    }
}

/// How far a motion is from singularities at its places: for each of them the smallest margin of a group, 0 where the
/// state is no ordinary one. That of a coupled group tells in parts of its largest alone.
pub(super) fn margins(solver: &Solver, places: &[f64], work: &mut Workspace) -> Vec<f64> {
    let all: Vec<_> = places.iter().map(|&at| solver.margins(at, work)).collect();
    let groups = &solver.plan().groups;
    let mut peaks: Vec<f64> = groups
        .iter()
        .map(|group| match group.kind {
            GroupKind::Coupled { .. } => f64::MIN_POSITIVE,
            _ => 1.0,
        })
        .collect();
    for margins in all.iter().flatten() {
        for (peak, margin) in peaks.iter_mut().zip(margins) {
            *peak = peak.max(*margin);
        }
    }
    let least = |margins: &Option<Vec<f64>>| {
        let margins = margins.as_ref()?;
        let parts = margins
            .iter()
            .zip(&peaks)
            .map(|(margin, peak)| margin / peak);
        Some(parts.fold(1.0, f64::min))
    };
    all.iter().map(|m| least(m).unwrap_or(0.0)).collect()
}

/// Below this part of the largest rate a figure is too small to be asked for; below the second it is 0.
const SMALL: f64 = 0.01;
const ZERO: f64 = 1e-12;

/// Whether all rates exist at a place, and none is all but 0: nobody is asked for rounding, and no crank
/// stands where a rocker turns back.
pub(super) fn is_lively(solver: &Solver, at: f64, work: &mut Workspace) -> bool {
    let condition = solver.solve(at, Order::Acceleration, work);
    if condition != crate::solver::Condition::Ok {
        return false;
    }
    let mechanism = solver.mechanism();
    let links = || mechanism.link_ids();
    let slides = || mechanism.slide_ids().filter_map(|slide| work.travel(slide));
    [
        links().filter_map(|link| work.omega(link)).collect(),
        links().filter_map(|link| work.alpha(link)).collect(),
        slides().filter_map(|travel| travel.rate).collect(),
        slides().filter_map(|travel| travel.accel).collect(),
    ]
    .iter()
    .all(|rates: &Vec<f64>| {
        let largest = rates
            .iter()
            .fold(0.0_f64, |most, rate| most.max(rate.abs()));
        rates.iter().all(|rate| {
            let part = rate.abs() / largest.max(f64::MIN_POSITIVE);
            !(ZERO..SMALL).contains(&part)
        })
    })
}
