//! Checks the dimensions of a formula and compiles it to steps.

use super::code::{Code, Op};
use super::dimension::{Dimension, LengthScale, METRE};
use super::parser::glued;
use super::tree::{ExpressionTree, MathFunction, Node, Operation, WrittenUnit};
use super::{FormulaError, code::Excess};
use crate::wording::words;
use std::ops::Range;

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Kind {
    pub(crate) dimension: Dimension,
    /// `true` if the value is constant over the motion.
    pub(crate) is_constant: bool,
    /// For a direction, whether it counts turns.
    pub(crate) revolution: Option<Revolution>,
}

/// The range of a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Revolution {
    /// In [0, 360) degrees.
    Wrapped,
    /// With its turns counted, like the driver's.
    Counted,
}

impl Kind {
    /// Creates the kind of a variable that is not a direction.
    pub(crate) const fn plain(dimension: Dimension) -> Kind {
        Kind {
            dimension,
            is_constant: false,
            revolution: None,
        }
    }

    /// Creates the kind of a direction.
    pub(crate) const fn direction(revolution: Revolution) -> Kind {
        Kind {
            dimension: Dimension::DEGREES,
            is_constant: false,
            revolution: Some(revolution),
        }
    }
}

/// A part of a formula: its steps and the kind of their result.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    pub(crate) ops: Vec<Op>,
    pub(crate) kind: Kind,
}

impl Part {
    /// Creates a plain number.
    fn constant(number: f64) -> Part {
        Part {
            ops: vec![Op::Number(number)],
            kind: Kind {
                is_constant: true,
                ..Kind::plain(Dimension::NUMBER)
            },
        }
    }

    /// Creates a named number of a scene.
    pub(crate) fn named(number: f64, dimension: Option<Dimension>) -> Part {
        Part::constant(number).of(dimension.unwrap_or(Dimension::NUMBER))
    }

    fn then(mut self, op: Op) -> Part {
        self.ops.push(op);
        self
    }

    fn of(self, dimension: Dimension) -> Part {
        let kind = Kind {
            dimension,
            revolution: None,
            ..self.kind
        };
        Part { kind, ..self }
    }

    /// Converts a direction to a number of degrees; leaves everything else unchanged.
    fn number(self) -> Part {
        let dimension = self.kind.dimension;
        match self.kind.revolution {
            Some(Revolution::Wrapped) => self.then(Op::Uncut),
            _ => self,
        }
        .of(dimension)
    }

    /// Converts degrees to radians; leaves everything else unchanged.
    fn radians(self) -> Part {
        let part = self.number();
        match part.kind.dimension.degrees {
            true => part.then(Op::Radians).of(Dimension::RADIANS),
            false => part,
        }
    }

    /// Converts radians to degrees; leaves everything else unchanged.
    fn degrees(self) -> Part {
        match self.kind.dimension == Dimension::RADIANS {
            true => self.then(Op::Degrees).of(Dimension::DEGREES),
            false => self,
        }
    }

    /// Joins two parts by an operation.
    fn with(mut self, other: Part, op: Op, dimension: Dimension) -> Part {
        self.ops.extend(other.ops);
        self.kind.is_constant &= other.kind.is_constant;
        self.then(op).of(dimension)
    }

    fn is_factor(&self) -> bool {
        self.kind.is_constant && self.kind.dimension.is_number()
    }

    /// Multiplies by the ratio of two length units to the power `times`, which may be negative.
    fn scaled(mut self, times: i8, by: f64, over: f64) -> Part {
        if by != over {
            let scale = match times < 0 {
                true => Op::Scale(over, by),
                false => Op::Scale(by, over),
            };
            let times = usize::from(times.unsigned_abs());
            self.ops.extend(std::iter::repeat_n(scale, times));
        }
        self
    }
}

/// A function that returns the part for a name, or a hint for an unknown name.
pub(crate) type NamedPart<'n> = &'n mut dyn FnMut(&str) -> Result<Part, Option<String>>;

/// Compiles a formula to steps, and returns them with the kind of the result.
///
/// # Errors
/// The first fault: an unknown name, incompatible dimensions, too many steps.
pub(crate) fn compile(
    text: &str,
    tree: &ExpressionTree,
    length: LengthScale,
    names: NamedPart<'_>,
) -> Result<(Code, Kind), FormulaError> {
    let mut compiler = Compiler {
        text,
        length,
        names,
    };
    let Part { ops, kind } = compiler.part(tree)?;
    let code = Code::new(ops).map_err(|excess| {
        let message = match excess {
            Excess::Steps => words().formula_has_too_many_steps(),
            Excess::Rates => words().formula_has_no_such_rate(),
        };
        FormulaError::new(tree.span.clone(), message)
    })?;
    Ok((code, kind))
}

struct Compiler<'c> {
    text: &'c str,
    length: LengthScale,
    names: NamedPart<'c>,
}

impl Compiler<'_> {
    fn part(&mut self, tree: &ExpressionTree) -> Result<Part, FormulaError> {
        match &tree.node {
            Node::Number(number, unit) => self.number(number.value, unit.as_ref(), &tree.span),
            Node::Name(name) => self.named(name, &tree.span),
            Node::Negative(of) => {
                let part = self.part(of)?.number();
                Ok(part.then(Op::Negate))
            }
            Node::Pair(operation, sides) => {
                let [left, right] = &**sides;
                let (a, b) = (self.part(left)?, self.part(right)?);
                match operation {
                    Operation::Add => self.sum(a, b, Op::Add, [left, right]),
                    Operation::Subtract => self.sum(a, b, Op::Subtract, [left, right]),
                    Operation::Multiply => self.product(a, b, tree),
                    Operation::Divide => self.quotient(a, b, tree),
                }
            }
            Node::Power(of, exponent) => {
                let part = self.part(of)?.radians();
                let dimension = part.kind.dimension.power(*exponent);
                let dimension = dimension.ok_or_else(|| unsupported_power(&tree.span))?;
                Ok(part.then(Op::Power(*exponent)).of(dimension))
            }
            Node::Call(function, given) => self.call(*function, given, tree),
        }
    }

    fn number(
        &self,
        value: f64,
        unit: Option<&WrittenUnit>,
        span: &Range<usize>,
    ) -> Result<Part, FormulaError> {
        let mut part = Part::constant(value);
        let Some(unit) = unit else {
            return Ok(part);
        };
        for &(tenths, power) in &unit.lengths {
            part = part.scaled(power, tenths, self.length.tenths_of_mm);
        }
        let converted = match unit.degrees < 0 {
            true => Op::Degrees,
            false => Op::Radians,
        };
        let times = usize::from(unit.degrees.unsigned_abs());
        part.ops.extend(std::iter::repeat_n(converted, times));
        if part.ops.len() > 64 {
            return Err(unsupported_power(span));
        }
        Ok(part.of(unit.dimension))
    }

    fn named(&mut self, name: &str, span: &Range<usize>) -> Result<Part, FormulaError> {
        if name == "pi" {
            return Ok(Part {
                ops: vec![Op::Pi],
                kind: Kind {
                    is_constant: true,
                    ..Kind::plain(Dimension::NUMBER)
                },
            });
        }
        (self.names)(name).map_err(|help| {
            let fault = FormulaError::new(span.clone(), words().no_quantity(name, ""));
            let help = help.or_else(|| slip(name));
            FormulaError { help, ..fault }
        })
    }

    /// Compiles a sum or difference.
    fn sum(
        &self,
        a: Part,
        b: Part,
        op: Op,
        trees: [&ExpressionTree; 2],
    ) -> Result<Part, FormulaError> {
        let subtracts = op == Op::Subtract;
        let angle = |part: &Part| part.kind.dimension.is_angle();
        match (a.kind.revolution, b.kind.revolution) {
            (Some(_), Some(_)) if subtracts => {
                let way = a.with(b, op, Dimension::DEGREES);
                Ok(way.then(Op::ShortWay))
            }
            (Some(revolution), None) if angle(&b) => Ok(turned(
                a.with(b.degrees(), op, Dimension::DEGREES),
                revolution,
            )),
            (None, Some(revolution)) if angle(&a) && !subtracts => Ok(turned(
                a.degrees().with(b, op, Dimension::DEGREES),
                revolution,
            )),
            _ => self.alike(a.number(), b.number(), op, trees),
        }
    }

    /// Joins two values that must have the same dimension.
    fn alike(
        &self,
        a: Part,
        b: Part,
        op: Op,
        trees: [&ExpressionTree; 2],
    ) -> Result<Part, FormulaError> {
        let (left, right) = (a.kind.dimension, b.kind.dimension);
        if !left.adds_to(right) {
            let span = trees[0].span.start..trees[1].span.end;
            let [one, other] = [(trees[0], left), (trees[1], right)].map(|(tree, dimension)| {
                let unit = dimension.symbol(self.length.symbol);
                words().measured_in(self.text.get(tree.span.clone()).unwrap_or(""), &unit)
            });
            let fault = FormulaError::new(span, words().do_not_go_together(&one, &other));
            let is_bare = left.is_number() != right.is_number();
            return Err(match is_bare {
                true => fault.help(words().numbers_need_units()),
                false => fault,
            });
        }
        if left.is_angle() && left.degrees != right.degrees {
            return Ok(a.degrees().with(b.degrees(), op, Dimension::DEGREES));
        }
        let times = left.lengths_beyond(right);
        let b = b.scaled(times, self.length.tenths_of_mm, METRE);
        let dimension = match left.radian {
            0 => Dimension {
                radian: right.radian,
                ..left
            },
            _ => left,
        };
        Ok(a.with(b, op, dimension))
    }

    fn product(&self, a: Part, b: Part, tree: &ExpressionTree) -> Result<Part, FormulaError> {
        // A multiple of an angle stays in degrees.
        let degrees = |factor: &Part, of: &Part| factor.is_factor() && of.kind.dimension.degrees;
        if degrees(&a, &b) || degrees(&b, &a) {
            return Ok(a
                .number()
                .with(b.number(), Op::Multiply, Dimension::DEGREES));
        }
        let (a, b) = (a.radians(), b.radians());
        let dimension = a.kind.dimension.times(b.kind.dimension);
        let dimension = dimension.ok_or_else(|| unsupported_power(&tree.span))?;
        Ok(a.with(b, Op::Multiply, dimension))
    }

    fn quotient(&self, a: Part, b: Part, tree: &ExpressionTree) -> Result<Part, FormulaError> {
        if b.is_factor() && a.kind.dimension.degrees {
            return Ok(a.number().with(b, Op::Divide, Dimension::DEGREES));
        }
        let (a, b) = (a.radians(), b.radians());
        let dimension = a.kind.dimension.over(b.kind.dimension);
        let dimension = dimension.ok_or_else(|| unsupported_power(&tree.span))?;
        Ok(a.with(b, Op::Divide, dimension))
    }

    fn call(
        &mut self,
        function: MathFunction,
        given: &[ExpressionTree],
        tree: &ExpressionTree,
    ) -> Result<Part, FormulaError> {
        let mut parts = Vec::with_capacity(given.len());
        for tree in given {
            parts.push(self.part(tree)?);
        }
        let several = |op: Op, prepare: fn(Part) -> Part| {
            let mut parts = parts.clone().into_iter().map(prepare).zip(given);
            let first = parts.next();
            let (first, of) = first.ok_or_else(|| unsupported_power(&tree.span))?;
            parts.try_fold(first, |all, (part, tree)| {
                self.alike(all, part, op, [of, tree])
            })
        };
        let one = || {
            let first = parts.first().cloned();
            first.ok_or_else(|| unsupported_power(&tree.span))
        };
        match function {
            MathFunction::Min => several(Op::Min, Part::number),
            MathFunction::Max => several(Op::Max, Part::number),
            MathFunction::Hypot => several(Op::Hypot, Part::radians),
            MathFunction::Atan2 => {
                let mut part = several(Op::Atan2, Part::radians)?.of(Dimension::DEGREES);
                part.kind.revolution = Some(Revolution::Wrapped);
                Ok(part)
            }
            MathFunction::Abs => Ok(one()?.number().then(Op::Abs)),
            MathFunction::Sqrt => {
                let part = one()?.radians();
                let Some(root) = part.kind.dimension.root() else {
                    let unit = part.kind.dimension.symbol(self.length.symbol);
                    let message = words().no_root_of(&unit);
                    return Err(FormulaError::new(tree.span.clone(), message));
                };
                Ok(part.then(Op::Sqrt).of(root))
            }
            MathFunction::Sin => self.of_angle(one()?, function, Op::Sin, tree),
            MathFunction::Cos => self.of_angle(one()?, function, Op::Cos, tree),
            MathFunction::Tan => self.of_angle(one()?, function, Op::Tan, tree),
            MathFunction::Asin => self.of_number(one()?, function, Op::Asin, tree),
            MathFunction::Acos => self.of_number(one()?, function, Op::Acos, tree),
            // Not supported for variables: these functions have no rates here.
            MathFunction::Exp | MathFunction::Ln | MathFunction::Log10 => {
                let message = words().of_plain_numbers_only(function.name());
                Err(FormulaError::new(tree.span.clone(), message))
            }
        }
    }

    fn of_angle(
        &self,
        part: Part,
        function: MathFunction,
        op: Op,
        tree: &ExpressionTree,
    ) -> Result<Part, FormulaError> {
        if part.kind.dimension.is_angle() {
            return Ok(part.degrees().then(op).of(Dimension::NUMBER));
        }
        let unit = part.kind.dimension.symbol(self.length.symbol);
        let message = words().takes_an_angle(function.name(), &unit);
        Err(FormulaError::new(tree.span.clone(), message).help(words().angles_have_units()))
    }

    fn of_number(
        &self,
        part: Part,
        function: MathFunction,
        op: Op,
        tree: &ExpressionTree,
    ) -> Result<Part, FormulaError> {
        if part.kind.dimension.is_number() {
            return Ok(part.then(op).of(Dimension::DEGREES));
        }
        let unit = part.kind.dimension.symbol(self.length.symbol);
        let message = words().takes_a_number(function.name(), &unit);
        Err(FormulaError::new(tree.span.clone(), message))
    }
}

/// Makes a direction from a direction rotated by an angle.
fn turned(part: Part, revolution: Revolution) -> Part {
    let mut part = match revolution {
        Revolution::Wrapped => part.then(Op::Wrap),
        Revolution::Counted => part,
    };
    part.kind.revolution = Some(revolution);
    part
}

fn unsupported_power(span: &Range<usize>) -> FormulaError {
    FormulaError::new(span.clone(), words().unit_beyond_use())
}

/// Returns a hint for a word that names nothing.
fn slip(name: &str) -> Option<String> {
    if let Some((number, unit)) = glued(name) {
        Some(words().blank_before_unit(number, unit))
    } else if name.contains('-') {
        Some(words().minus_between_blanks().to_owned())
    } else {
        None
    }
}
