//! Where a formula turns over: what it makes of a figure answers in another way on the other side.
//!
//! Which side holds is left open by rounding as soon as it lies within the bound of what is compared: the derivative on
//! the side that rounding chose says nothing.

use super::code::{Code, Op};
use crate::{Ball, Dual, Number};

impl Code {
    /// The steps that may turn over within the bounds of what they take, by their numbers.
    pub(crate) fn kinks(&self, leaf: impl Fn(u16, u8) -> Option<Ball>) -> Vec<usize> {
        let mut kinks = Vec::new();
        let _ = self.run_turning(leaf, |number, op, [a, b], _| {
            if may_turn_over(op, first(a), first(b)) {
                kinks.push(number);
            }
        });
        kinks
    }

    /// The figure with these steps on their other side.
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

    /// Whether any of its steps can turn over.
    pub(crate) fn has_sides(&self) -> bool {
        self.ops().iter().any(|op| {
            use Op::{Abs, Acos, Asin, Atan2, Hypot, Max, Min, Sqrt};
            matches!(op, Abs | Sqrt | Hypot | Atan2 | Min | Max | Asin | Acos)
        })
    }
}

/// A figure without its rates; what is not there is not known.
fn first(of: &[Ball]) -> Ball {
    let nothing = Ball::exactly(f64::NAN);
    of.first().copied().unwrap_or(nothing)
}

/// Whether both sides of a step lie within the bounds of what it takes. What is not known at all is not judged.
fn may_turn_over(op: Op, a: Ball, b: Ball) -> bool {
    let may_be_nought = |of: Ball| of.radius.is_finite() && of.smallest() == 0.0;
    match op {
        Op::Abs | Op::Sqrt => may_be_nought(a),
        Op::Hypot | Op::Atan2 => may_be_nought(a) && may_be_nought(b),
        Op::Min | Op::Max => may_be_nought(a - b),
        // At the ends of their range these have a root of what is 0.
        Op::Asin | Op::Acos => {
            let one = Ball::exactly(1.0);
            may_be_nought(one - a) || may_be_nought(one + a)
        }
        _ => false,
    }
}

/// Puts what a step makes on its other side. At the kink both sides have one value; slopes and rates are not the same.
fn turn_over(op: Op, [a, b]: [&[Dual]; 2], made: &mut [Dual]) {
    for (n, made) in made.iter_mut().enumerate() {
        let here = *made;
        let beyond = match (op, a.get(n), b.get(n)) {
            // Of two it is the other one.
            (Op::Min | Op::Max, Some(a), Some(b)) => *a + *b - here,
            // A direction may be any other.
            (Op::Atan2, ..) => Dual::new(f64::NAN, f64::NAN),
            _ => -here,
        };
        let value = if n == 0 { here.value } else { beyond.value };
        *made = Dual::new(value, beyond.slope);
    }
}
