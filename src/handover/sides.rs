//! On which side each group lies, and where along the motion it changes over.

use crate::numeric::root;
use crate::solver::{Condition, Known, Order, Range, Solver};

/// Places at which a side is looked at, in a period or over the range; none of them is a round one.
const PLACES: u32 = 1440;
/// This near to a change point a group changes over there.
const SAME: f64 = 1e-4;

/// The side of a group over the motion.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SideCourse {
    /// Where the motion repeats: after so many degrees.
    pub(super) period: Option<f64>,
    /// Whether it is the positive side at the beginning of the range.
    pub(super) is_plus: bool,
    /// Where it changes over, going up.
    pub(super) changes: Vec<f64>,
}

impl SideCourse {
    /// Follows a figure over the motion whose sign is the side.
    pub(super) fn of(solver: &Solver, figure: impl Fn(Known<'_>) -> f64) -> SideCourse {
        let range = solver.motion().range;
        let (low, high) = range.ends();
        let mut work = solver.state();
        let mut at = |place: f64| {
            let condition = solver.solve(place, Order::Position, &mut work);
            let value = (condition != Condition::NoAssembly).then(|| figure(work.state().known()));
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
        let mut course = SideCourse {
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

    /// Sides that differ at the ends of a period meet where it begins.
    fn close(&mut self, low: f64) {
        if self.period.is_some() && self.changes.len() % 2 == 1 {
            self.changes.insert(0, low);
            self.is_plus = !self.is_plus;
        }
    }

    /// As 1 or -1, from each change on.
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

/// A change point is known better than the place of a root that rounding has blurred.
fn settled(solver: &Solver, found: f64) -> f64 {
    let known = &solver.motion().change_points;
    let near = known.iter().find(|place| (*place - found).abs() < SAME);
    near.copied().unwrap_or(found)
}
