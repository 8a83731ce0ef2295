//! Where the stroke of a slide ends.

use crate::arithmetic::typed_radius;
use crate::solver::{Condition, Order, Range, Solver, State};
use crate::{Constant, SlideId, StrokeEnd};

/// The motion is looked at so many times before the end is closed in on.
const LOOKS: u32 = 720;
/// Halvings until a double has no more digits.
const HALVINGS: u32 = 80;

/// The least or greatest position of a slide in the whole motion, in the scene's unit.
///
/// There the position changes by the square of what the driver is off, so that it is as good as any
/// other.
pub(super) fn end(solver: &Solver, slide: SlideId, end: StrokeEnd) -> Constant {
    let (low, high) = match solver.motion().range {
        Range::Full { period } => (0.0, period),
        Range::Limited { low, high } => (low, high),
    };
    let mut look = Look {
        solver,
        state: solver.state(),
        slide,
        sign: match end {
            StrokeEnd::Least => 1.0,
            StrokeEnd::Greatest => -1.0,
        },
    };
    let step = (high - low) / f64::from(LOOKS);
    let coordinates = (0..=LOOKS).map(|k| low + step * f64::from(k));
    let mut best = (f64::INFINITY, low);
    for at in coordinates {
        if let Some((height, _)) = look.at(at) {
            best = if height < best.0 { (height, at) } else { best };
        }
    }
    let (mut left, mut right) = (best.1 - step, best.1 + step);
    for _ in 0..HALVINGS {
        let middle = left + 0.5 * (right - left);
        match look.at(middle) {
            Some((height, rate)) => {
                best = if height < best.0 {
                    (height, middle)
                } else {
                    best
                };
                if rate < 0.0 {
                    left = middle;
                } else {
                    right = middle;
                }
            }
            None if middle < best.1 => left = middle,
            None => right = middle,
        }
    }
    constant(look.sign * best.0)
}

/// Off by some roundings of positions of its size.
fn constant(position: f64) -> Constant {
    let mut end = Constant::given(position);
    end.radius = typed_radius(position).max(8.0 * f64::EPSILON * position.abs());
    end
}

/// The slide at a coordinate.
struct Look<'a> {
    solver: &'a Solver,
    state: State,
    slide: SlideId,
    sign: f64,
}

impl Look<'_> {
    /// Its height above the end that is meant, and how that changes with the driver's coordinate.
    fn at(&mut self, at: f64) -> Option<(f64, f64)> {
        let condition = self.solver.solve(at, Order::Velocity, &mut self.state);
        if condition == Condition::NoAssembly {
            return None;
        }
        let travel = &self.state.travels[self.slide.index()];
        let position = self.state.travel(self.slide).position;
        let rate = if condition == Condition::DeadPoint {
            0.0
        } else {
            travel.v
        };
        Some((self.sign * position, self.sign * rate))
    }
}
