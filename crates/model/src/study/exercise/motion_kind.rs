//! Compares the kind of motion of an exercise with that of its original.

use crate::angle::TURN;
use crate::scene::figure;
use crate::solver::{DrivenLoop, GroupKind, LoopKind, Order, Range, Solver, Workspace};
use crate::{Input, Mechanism};

/// The properties of a motion that an exercise must keep.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MotionKind {
    groups: Vec<GroupKind>,
    redundant: usize,
    first_loop: Option<LoopKind>,
    /// The period of the motion if the driver turns fully.
    period: Option<f64>,
    dead_points: usize,
    change_points: usize,
    has_near_miss: bool,
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
            has_near_miss: !motion.near_misses.is_empty(),
        }
    }
}

/// The step between places of a turning driver, in degrees.
const STEP: i32 = 5;
/// The fraction of a limited range at either end that is too close to the limit.
const NEAR_END: f64 = 0.1;
/// Number of places over the range of a pushed driver.
const PUSHED: u32 = 16;

/// Returns possible places of an exercise: multiples of 5 degrees, or numbers of two digits, well
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
            let mut coordinates: Vec<f64> = (0..=PUSHED)
                .filter_map(|n| two_digits(part(n)))
                .filter(inside)
                .collect();
            coordinates.dedup();
            coordinates
        }
    }
}

/// Returns for each place the smallest margin of a group from singularities; 0 if the state is not
/// regular. The margin of a coupled group is relative to its largest one.
pub(super) fn margins(solver: &Solver, coordinates: &[f64], workspace: &mut Workspace) -> Vec<f64> {
    let all: Vec<_> = coordinates
        .iter()
        .map(|&at| solver.margins(at, workspace))
        .collect();
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
    let minimum = |margins: &Option<Vec<f64>>| {
        let margins = margins.as_ref()?;
        let parts = margins
            .iter()
            .zip(&peaks)
            .map(|(margin, peak)| margin / peak);
        Some(parts.fold(1.0, f64::min))
    };
    all.iter().map(|m| minimum(m).unwrap_or(0.0)).collect()
}

/// Rates from `ZERO` to `SMALL`, relative to the largest one, are too small for an exercise;
/// smaller ones count as 0.
const SMALL: f64 = 0.01;
const ZERO: f64 = 1e-12;

/// Returns `true` if all rates exist at a place, and none is nearly but not exactly zero. Such a
/// rate would consist of rounding errors, or occur near a dead point of a rocker.
pub(super) fn is_lively(solver: &Solver, at: f64, workspace: &mut Workspace) -> bool {
    let condition = solver.solve(at, Order::Acceleration, workspace);
    if condition != crate::solver::Condition::Ok {
        return false;
    }
    let mechanism = solver.mechanism();
    let links = || mechanism.link_ids();
    let slides = || {
        mechanism
            .slide_ids()
            .filter_map(|slide| workspace.travel(slide))
    };
    [
        links().filter_map(|link| workspace.omega(link)).collect(),
        links().filter_map(|link| workspace.alpha(link)).collect(),
        slides().filter_map(|travel| travel.rate).collect(),
        slides().filter_map(|travel| travel.accel).collect(),
    ]
    .iter()
    .all(|rates: &Vec<f64>| {
        let largest = rates
            .iter()
            .fold(0.0_f64, |maximum, rate| maximum.max(rate.abs()));
        rates.iter().all(|rate| {
            let part = rate.abs() / largest.max(f64::MIN_POSITIVE);
            !(ZERO..SMALL).contains(&part)
        })
    })
}
