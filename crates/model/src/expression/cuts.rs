//! How a formula jumps where a direction that it is made of passes a full turn.

use super::code::{Code, Op};

/// What the jump of a direction by a full turn makes of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum DirectionCut {
    /// Nothing.
    Nowhere,
    /// A jump by full turns: whole turns away the figure is the same, as a direction is.
    ByTurns,
    /// A jump by something else, or nobody knows.
    Otherwise,
}

/// A figure on the stack; of a number that never changes its value.
#[derive(Clone, Copy)]
struct Traced {
    cut: DirectionCut,
    number: Option<f64>,
}

impl Code {
    /// How the figure jumps; `is_direction` tells which of those that it is made of are directions.
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
    let most = cuts.max().unwrap_or(DirectionCut::Nowhere);
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
    // Continuous in what it takes, so that no other jump is left than one that this has.
    let otherwise = match most {
        DirectionCut::Nowhere => DirectionCut::Nowhere,
        DirectionCut::ByTurns | DirectionCut::Otherwise => DirectionCut::Otherwise,
    };
    let times = |factor: f64| match factor.fract() == 0.0 {
        true => most,
        false => otherwise,
    };
    let cut = match (op, numbers) {
        (Op::Leaf(leaf), _) if is_direction(leaf) => DirectionCut::ByTurns,
        (Op::Number(_) | Op::Pi | Op::Leaf(_), _) => DirectionCut::Nowhere,
        (Op::Add | Op::Subtract | Op::Negate | Op::Uncut, _) => most,
        (Op::ShortWay | Op::Wrap, _) => most.max(DirectionCut::ByTurns),
        (Op::Multiply, [Some(factor), None] | [None, Some(factor)]) => times(factor),
        (Op::Divide, [None, Some(by)]) => times(1.0 / by),
        (Op::Atan2, _) => otherwise.max(DirectionCut::ByTurns),
        // A full turn more is the same angle to these, and to every slope.
        (Op::Sin | Op::Cos | Op::Tan | Op::Rate, _) if most == DirectionCut::ByTurns => {
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
