//! Represents the syntax tree of a formula.

use super::Dimension;
use std::ops::Range;

/// A part of a formula, with its position.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ExpressionTree {
    pub(crate) span: Range<usize>,
    pub(super) node: Node,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Node {
    /// A number, with its unit if there is one.
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

/// A number as typed, because doubles cannot represent numbers such as `0.1`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WrittenNumber {
    pub(super) digits: String,
    /// The nearest double.
    pub(super) value: f64,
}

/// A unit following a number. `lengths` gives its size relative to the formula's own length unit,
/// as a quotient of whole numbers to a power for each length.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WrittenUnit {
    pub(super) dimension: Dimension,
    /// The lengths in it, in tenths of a millimetre, each with its power.
    pub(super) lengths: Vec<(f64, i8)>,
    /// The power of degrees in it.
    pub(super) degrees: i8,
}

/// A function of formulas.
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
    const NAMES: [(&'static str, MathFunction); 14] = [
        ("sqrt", MathFunction::Sqrt),
        ("abs", MathFunction::Abs),
        ("min", MathFunction::Min),
        ("max", MathFunction::Max),
        ("hypot", MathFunction::Hypot),
        ("sin", MathFunction::Sin),
        ("cos", MathFunction::Cos),
        ("tan", MathFunction::Tan),
        ("asin", MathFunction::Asin),
        ("acos", MathFunction::Acos),
        ("atan2", MathFunction::Atan2),
        ("exp", MathFunction::Exp),
        ("ln", MathFunction::Ln),
        ("log10", MathFunction::Log10),
    ];

    /// Returns the function with this name.
    pub(super) fn named(name: &str) -> Option<MathFunction> {
        let mut names = MathFunction::NAMES.into_iter();
        names.find_map(|(own, function)| (own == name).then_some(function))
    }

    pub(super) fn name(self) -> &'static str {
        let mut names = MathFunction::NAMES.into_iter();
        let named = names.find(|(_, function)| *function == self);
        named.map_or("", |(name, _)| name)
    }

    /// Returns the minimum and maximum number of arguments.
    pub(super) fn takes(self) -> (usize, usize) {
        match self {
            MathFunction::Min | MathFunction::Max | MathFunction::Hypot => (2, 16),
            MathFunction::Atan2 => (2, 2),
            _ => (1, 1),
        }
    }
}

/// Returns the names of all functions.
pub fn functions() -> impl Iterator<Item = &'static str> {
    MathFunction::NAMES.into_iter().map(|(name, _)| name)
}

/// Returns `true` if a word is the name of a function.
pub(crate) fn is_function(word: &str) -> bool {
    functions().any(|name| name == word)
}

impl ExpressionTree {
    /// Returns `true` for a number with its sign and unit, without any operation.
    pub(crate) fn is_number(&self) -> bool {
        match &self.node {
            Node::Number(..) => true,
            Node::Negative(of) => of.is_number(),
            Node::Name(_) | Node::Pair(..) | Node::Power(..) | Node::Call(..) => false,
        }
    }

    /// Returns `true` for a single name.
    pub(crate) fn is_name(&self) -> bool {
        matches!(self.node, Node::Name(_))
    }

    /// Calls `tell` with every name in it.
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
