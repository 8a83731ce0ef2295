//! Determines how a formula jumps where a direction in it passes a full turn.

use super::code::{Code, Op};

/// The effect of a direction's jump by a full turn on a formula's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum DirectionCut {
    /// The value does not jump.
    Nowhere,
    /// The value jumps by full turns, and values whole turns apart are equivalent, as for a
    /// direction.
    ByTurns,
    /// The value jumps by another or an unknown amount.
    Otherwise,
}

/// A value on the stack, with its number if it is constant.
#[derive(Clone, Copy)]
struct Traced {
    cut: DirectionCut,
    number: Option<f64>,
}

impl Code {
    /// Returns how the value jumps. `is_direction` returns `true` for the inputs that are
    /// directions.
    pub(crate) fn cut(&self, is_direction: impl Fn(u16) -> bool) -> DirectionCut {
        let mut stack: Vec<Traced> = Vec::new();
        for &op in self.ops() {
            let from = stack.len().saturating_sub(op.takes());
            let taken = stack.split_off(from);
            stack.push(traced(op, &taken, &is_direction));
        }
        stack.last().map_or(DirectionCut::Nowhere, |made| made.cut)
    }
}

fn traced(op: Op, taken: &[Traced], is_direction: impl Fn(u16) -> bool) -> Traced {
    let cuts = taken.iter().map(|of| of.cut);
    let maximum = cuts.max().unwrap_or(DirectionCut::Nowhere);
    let numbers = [0, 1].map(|i| taken.get(i).and_then(|of| of.number));
    let number = match (op, numbers) {
        (Op::Number(number), _) => Some(number),
        (Op::Negate, [Some(a), _]) => Some(-a),
        (Op::Add, [Some(a), Some(b)]) => Some(a + b),
        (Op::Subtract, [Some(a), Some(b)]) => Some(a - b),
        (Op::Multiply, [Some(a), Some(b)]) => Some(a * b),
        (Op::Divide, [Some(a), Some(b)]) => Some(a / b),
        _ => None,
    };
    // The step is continuous, so that only its arguments can jump.
    let otherwise = match maximum {
        DirectionCut::Nowhere => DirectionCut::Nowhere,
        DirectionCut::ByTurns | DirectionCut::Otherwise => DirectionCut::Otherwise,
    };
    let times = |factor: f64| match factor.fract() == 0.0 {
        true => maximum,
        false => otherwise,
    };
    let cut = match (op, numbers) {
        (Op::Leaf(leaf), _) if is_direction(leaf) => DirectionCut::ByTurns,
        (Op::Number(_) | Op::Pi | Op::Leaf(_), _) => DirectionCut::Nowhere,
        (Op::Add | Op::Subtract | Op::Negate | Op::Uncut, _) => maximum,
        (Op::ShortWay | Op::Wrap, _) => maximum.max(DirectionCut::ByTurns),
        (Op::Multiply, [Some(factor), None] | [None, Some(factor)]) => times(factor),
        (Op::Divide, [None, Some(by)]) => times(1.0 / by),
        (Op::Atan2, _) => otherwise.max(DirectionCut::ByTurns),
        // A full turn changes neither these functions nor a slope.
        (Op::Sin | Op::Cos | Op::Tan | Op::Rate, _) if maximum == DirectionCut::ByTurns => {
            DirectionCut::Nowhere
        }
        (
            Op::Multiply
            | Op::Divide
            | Op::Power(_)
            | Op::Sqrt
            | Op::Abs
            | Op::Min
            | Op::Max
            | Op::Hypot
            | Op::Sin
            | Op::Cos
            | Op::Tan
            | Op::Asin
            | Op::Acos
            | Op::Scale(..)
            | Op::Radians
            | Op::Degrees
            | Op::Rate,
            _,
        ) => otherwise,
    };
    Traced { cut, number }
}
