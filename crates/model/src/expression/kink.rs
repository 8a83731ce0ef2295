//! Finds the kinks of a formula: where its derivative differs on both sides.
//!
//! Within the error bound of the compared values, rounding decides the side. The derivative on that
//! side alone is then meaningless.

use super::code::{Code, Op};
use crate::{Ball, Dual, Number};

impl Code {
    /// Returns the indices of the steps that may be at a kink, within the bounds of their
    /// arguments.
    pub(crate) fn kinks(&self, leaf: impl Fn(u16, u8) -> Option<Ball>) -> Vec<usize> {
        let mut kinks = Vec::new();
        let _ = self.run_turning(leaf, |number, op, [a, b], _| {
            if may_turn_over(op, first(a), first(b)) {
                kinks.push(number);
            }
        });
        kinks
    }

    /// Evaluates the formula with these steps on the other side of their kinks.
    pub(crate) fn beyond(
        &self,
        kinks: &[usize],
        leaf: impl Fn(u16, u8) -> Option<Dual>,
    ) -> Option<Dual> {
        self.run_turning(leaf, |number, op, taken, made| {
            if kinks.contains(&number) {
                turn_over(op, taken, made);
            }
        })
    }

    /// Returns `true` if any of its steps has a kink.
    pub(crate) fn has_sides(&self) -> bool {
        self.ops().iter().any(|op| {
            use Op::{Abs, Acos, Asin, Atan2, Hypot, Max, Min, Sqrt};
            matches!(op, Abs | Sqrt | Hypot | Atan2 | Min | Max | Asin | Acos)
        })
    }
}

/// Returns the value without its rates; NaN if there is none.
fn first(of: &[Ball]) -> Ball {
    let nothing = Ball::exactly(f64::NAN);
    of.first().copied().unwrap_or(nothing)
}

/// Returns `true` if both sides of a step are within the bounds of its arguments; `false` for
/// unbounded arguments.
fn may_turn_over(op: Op, a: Ball, b: Ball) -> bool {
    let may_be_nought = |of: Ball| of.radius.is_finite() && of.smallest() == 0.0;
    match op {
        Op::Abs | Op::Sqrt => may_be_nought(a),
        Op::Hypot | Op::Atan2 => may_be_nought(a) && may_be_nought(b),
        Op::Min | Op::Max => may_be_nought(a - b),
        // At the ends of their domain, these take the square root of 0.
        Op::Asin | Op::Acos => {
            let one = Ball::exactly(1.0);
            may_be_nought(one - a) || may_be_nought(one + a)
        }
        _ => false,
    }
}

/// Switches the result of a step to its other side. At the kink, the values on both sides agree,
/// but slopes and rates differ.
fn turn_over(op: Op, [a, b]: [&[Dual]; 2], made: &mut [Dual]) {
    for (n, made) in made.iter_mut().enumerate() {
        let here = *made;
        let beyond = match (op, a.get(n), b.get(n)) {
            // Selects the other argument.
            (Op::Min | Op::Max, Some(a), Some(b)) => *a + *b - here,
            // A direction may change to any other.
            (Op::Atan2, ..) => Dual::new(f64::NAN, f64::NAN),
            _ => -here,
        };
        let value = if n == 0 { here.value } else { beyond.value };
        *made = Dual::new(value, beyond.slope);
    }
}
