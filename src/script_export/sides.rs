//! Finds the side of each group, and the coordinates where it changes.

use crate::numeric::root;
use crate::solver::{Condition, Known, Order, Range, Solver};

/// Number of places in a period or over the range at which a side is evaluated; they avoid round
/// coordinates.
const PLACES: u32 = 1440;
/// The distance from a change point, in the driver's coordinate, within which a group changes sides
/// at that point.
const EQUALITY_TOLERANCE: f64 = 1e-4;

/// The side of a group over the motion.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SideHistory {
    /// The period of the motion, if it has one.
    pub(super) period: Option<f64>,
    /// `true` if the side is positive at the beginning of the range.
    pub(super) is_plus: bool,
    /// The coordinates where the side changes, ascending.
    pub(super) changes: Vec<f64>,
}

impl SideHistory {
    /// Follows a function over the motion; its sign is the side.
    pub(super) fn of(solver: &Solver, figure: impl Fn(Known<'_>) -> f64) -> SideHistory {
        let range = solver.motion().range;
        let (low, high) = range.ends();
        let mut workspace = solver.state();
        let mut at = |place: f64| {
            let condition = solver.solve(place, Order::Position, &mut workspace);
            let value =
                (condition != Condition::NoAssembly).then(|| figure(workspace.state().known()));
            value.filter(|value| value.is_finite())
        };
        let place = |k: u32| low + (high - low) * (f64::from(k) + 0.37) / f64::from(PLACES);
        let mut changes = Vec::new();
        let mut is_plus = None;
        let mut last: Option<(f64, f64)> = None;
        for place in (0..PLACES).map(place) {
            let Some(value) = at(place) else { continue };
            is_plus = is_plus.or(Some(value > 0.0));
            if let Some(before) = last.filter(|before| (before.1 > 0.0) != (value > 0.0)) {
                let found = root(before, (place, value), 0.0, &mut at).unwrap_or(place);
                changes.push(settled(solver, found));
            }
            last = Some((place, value));
        }
        let mut course = SideHistory {
            period: match range {
                Range::Full { period } => Some(period),
                Range::Limited { .. } => None,
            },
            is_plus: is_plus.unwrap_or(true),
            changes,
        };
        course.close(low);
        course
    }

    /// Adds a change at the beginning of a period if the sides at its ends differ.
    fn close(&mut self, low: f64) {
        if self.period.is_some() && self.changes.len() % 2 == 1 {
            self.changes.insert(0, low);
            self.is_plus = !self.is_plus;
        }
    }

    /// Returns the sides as 1 or -1, from each change on.
    pub(super) fn signs(&self) -> Vec<i8> {
        let sign = |k: usize| {
            if k.is_multiple_of(2) == self.is_plus {
                1
            } else {
                -1
            }
        };
        (0..=self.changes.len()).map(sign).collect()
    }
}

/// Replaces a root by the change point next to it, which is more accurate.
fn settled(solver: &Solver, found: f64) -> f64 {
    let known = &solver.motion().change_points;
    let near = known
        .iter()
        .find(|place| (*place - found).abs() < EQUALITY_TOLERANCE);
    near.copied().unwrap_or(found)
}
