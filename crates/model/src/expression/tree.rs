//! A formula as it is written.

use super::Dimension;
use std::ops::Range;

/// A part of a formula, and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ExpressionTree {
    pub(crate) span: Range<usize>,
    pub(super) node: Node,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Node {
    /// A number, and what stands behind it as its unit.
    Number(WrittenNumber, Option<WrittenUnit>),
    Name(String),
    Negative(Box<ExpressionTree>),
    Pair(Operation, Box<[ExpressionTree; 2]>),
    Power(Box<ExpressionTree>, i8),
    Call(MathFunction, Vec<ExpressionTree>),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operation {
    Add,
    Subtract,
    Multiply,
    Divide,
}

/// A number as it is written: no double holds `0.1`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WrittenNumber {
    pub(super) digits: String,
    /// The nearest double.
    pub(super) value: f64,
}

/// A unit behind a number: what it measures with every length in the formula's own unit, and the number of
/// such units in it, as a quotient of whole numbers to a power of each length.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WrittenUnit {
    pub(super) dimension: Dimension,
    /// The lengths in it as tenths of a millimetre, each with its power.
    pub(super) lengths: Vec<(f64, i8)>,
    /// Whether a part of it is in degrees, and to which power.
    pub(super) degrees: i8,
}

/// What a formula may call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MathFunction {
    Sqrt,
    Abs,
    Min,
    Max,
    Hypot,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan2,
    Exp,
    Ln,
    Log10,
}

impl MathFunction {
    pub(super) const ALL: [MathFunction; 14] = [
        MathFunction::Sqrt,
        MathFunction::Abs,
        MathFunction::Min,
        MathFunction::Max,
        MathFunction::Hypot,
        MathFunction::Sin,
        MathFunction::Cos,
        MathFunction::Tan,
        MathFunction::Asin,
        MathFunction::Acos,
        MathFunction::Atan2,
        MathFunction::Exp,
        MathFunction::Ln,
        MathFunction::Log10,
    ];

    pub(super) fn name(self) -> &'static str {
        match self {
            MathFunction::Sqrt => "sqrt",
            MathFunction::Abs => "abs",
            MathFunction::Min => "min",
            MathFunction::Max => "max",
            MathFunction::Hypot => "hypot",
            MathFunction::Sin => "sin",
            MathFunction::Cos => "cos",
            MathFunction::Tan => "tan",
            MathFunction::Asin => "asin",
            MathFunction::Acos => "acos",
            MathFunction::Atan2 => "atan2",
            MathFunction::Exp => "exp",
            MathFunction::Ln => "ln",
            MathFunction::Log10 => "log10",
        }
    }

    /// How many figures it takes: the fewest and the most.
    pub(super) fn takes(self) -> (usize, usize) {
        match self {
            MathFunction::Min | MathFunction::Max | MathFunction::Hypot => (2, 16),
            MathFunction::Atan2 => (2, 2),
            _ => (1, 1),
        }
    }
}

/// What a formula may call, by name.
pub fn functions() -> impl Iterator<Item = &'static str> {
    MathFunction::ALL.into_iter().map(MathFunction::name)
}

/// Whether a word is what a formula may call.
pub(crate) fn is_function(word: &str) -> bool {
    functions().any(|name| name == word)
}

impl ExpressionTree {
    /// Whether nothing is worked out here: a number with its sign and unit.
    pub(crate) fn is_number(&self) -> bool {
        match &self.node {
            Node::Number(..) => true,
            Node::Negative(of) => of.is_number(),
            Node::Name(_) | Node::Pair(..) | Node::Power(..) | Node::Call(..) => false,
        }
    }

    /// Whether it is a name alone.
    pub(crate) fn is_name(&self) -> bool {
        matches!(self.node, Node::Name(_))
    }

    /// Tells every name in it.
    pub(crate) fn each_name(&self, tell: &mut dyn FnMut(&str)) {
        match &self.node {
            Node::Number(..) => {}
            Node::Name(name) => tell(name),
            Node::Negative(of) | Node::Power(of, _) => of.each_name(tell),
            Node::Pair(_, sides) => sides.iter().for_each(|side| side.each_name(tell)),
            Node::Call(_, given) => given.iter().for_each(|of| of.each_name(tell)),
        }
    }
}
