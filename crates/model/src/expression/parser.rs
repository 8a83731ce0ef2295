//! Parses a text into a tree.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = signed { ("*" | "/") signed }
//! signed  = "-" signed | power
//! power   = atom [ "^" [ "-" ] number ]
//! atom    = number [ unit ] | name | name "(" sum { "," sum } ")" | "(" sum ")"
//! ```

use super::dimension::{MAX_POWER, METRE};
use super::lexer::{Lexeme, Lexer, number};
use super::tree::{MathFunction, Node, Operation, WrittenNumber, WrittenUnit, functions};
use super::unit_words::{is_of_unit, is_unit, unit_named};
use super::{Dimension, ExpressionTree, FormulaError, MAX_LEN, is_of_name};
use crate::nearest::did_you_mean;
use crate::wording::words;
use std::ops::Range;

/// Maximum depth of nested brackets and signs.
const MAX_DEPTH: usize = 32;
/// Maximum exponent.
const MAX_EXPONENT: u8 = 8;

/// Parses a formula.
///
/// # Errors
/// The first fault.
pub(crate) fn parse(text: &str) -> Result<ExpressionTree, FormulaError> {
    if text.len() > MAX_LEN {
        return Err(FormulaError::new(
            0..text.len(),
            words().formula_too_long(MAX_LEN),
        ));
    }
    let mut parser = Parser {
        lexer: Lexer::new(text),
        depth: 0,
    };
    let tree = parser.sum()?;
    match parser.lexer.next(false)? {
        (Lexeme::End, _) => Ok(tree),
        (_, span) => Err(parser.unexpected(span, words().operator_or_end())),
    }
}

struct Parser<'t> {
    lexer: Lexer<'t>,
    depth: usize,
}

impl Parser<'_> {
    fn unexpected(&self, span: Range<usize>, wanted: &str) -> FormulaError {
        let help = self.point_for_comma(&span);
        let fault = match self.lexer.text.get(span.clone()) {
            None | Some("") => FormulaError::new(span, words().formula_ends_early(wanted)),
            Some(found) => {
                FormulaError::new(span.clone(), words().expected_in_formula(wanted, found))
            }
        };
        FormulaError { help, ..fault }
    }

    /// Returns a hint for a comma between digits.
    fn point_for_comma(&self, span: &Range<usize>) -> Option<String> {
        let (before, after) = self.lexer.text.split_at_checked(span.start)?;
        let is_digit = |c: char| c.is_ascii_digit();
        let head = before.rsplit(|c| !is_digit(c)).next()?;
        let tail = after.strip_prefix(',')?.split(|c| !is_digit(c)).next()?;
        let is_cut = !head.is_empty() && !tail.is_empty();
        is_cut.then(|| words().number_with_comma(head, tail))
    }

    /// Consumes and returns the next mark, if `marks` contains it.
    fn mark(&mut self, marks: &[char]) -> Result<Option<char>, FormulaError> {
        let mut ahead = self.lexer.clone();
        let (Lexeme::Mark(mark), _) = ahead.next(false)? else {
            return Ok(None);
        };
        if !marks.contains(&mark) {
            return Ok(None);
        }
        self.lexer = ahead;
        Ok(Some(mark))
    }

    fn deeper<R>(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<R, FormulaError>,
    ) -> Result<R, FormulaError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            let at = self.lexer.at();
            return Err(FormulaError::new(
                at..at,
                words().formula_too_deep(MAX_DEPTH),
            ));
        }
        let read = read(self);
        self.depth -= 1;
        read
    }

    fn sum(&mut self) -> Result<ExpressionTree, FormulaError> {
        let mut left = self.product()?;
        while let Some(mark) = self.mark(&['+', '-'])? {
            let right = self.product()?;
            let operation = match mark {
                '+' => Operation::Add,
                _ => Operation::Subtract,
            };
            left = pair(operation, left, right);
        }
        Ok(left)
    }

    fn product(&mut self) -> Result<ExpressionTree, FormulaError> {
        let mut left = self.signed()?;
        while let Some(mark) = self.mark(&['*', '/'])? {
            let right = self.signed()?;
            let operation = match mark {
                '*' => Operation::Multiply,
                _ => Operation::Divide,
            };
            left = pair(operation, left, right);
        }
        Ok(left)
    }

    fn signed(&mut self) -> Result<ExpressionTree, FormulaError> {
        let mut ahead = self.lexer.clone();
        let (Lexeme::Mark('-'), span) = ahead.next(true)? else {
            return self.power();
        };
        self.lexer = ahead;
        let of = self.deeper(Self::signed)?;
        Ok(ExpressionTree {
            span: span.start..of.span.end,
            node: Node::Negative(Box::new(of)),
        })
    }

    fn power(&mut self) -> Result<ExpressionTree, FormulaError> {
        let base = self.atom()?;
        if self.mark(&['^'])?.is_none() {
            return Ok(base);
        }
        let mut sign = 1;
        let (mut lexeme, mut span) = self.lexer.next(true)?;
        let from = span.start;
        if lexeme == Lexeme::Mark('-') {
            sign = -1;
            (lexeme, span) = self.lexer.next(true)?;
        }
        let (at, span) = (span.clone(), base.span.start..span.end);
        let node = match lexeme {
            Lexeme::Number(value) => {
                let digits = self.lexer.text[at].to_owned();
                power_of(base, sign, WrittenNumber { digits, value })
            }
            _ => None,
        };
        let Some(node) = node else {
            let fault = FormulaError::new(from..span.end, words().exponent_must_be_number());
            return Err(fault.help(words().exponents_go_to(MAX_EXPONENT.into())));
        };
        Ok(ExpressionTree { span, node })
    }

    fn atom(&mut self) -> Result<ExpressionTree, FormulaError> {
        let (lexeme, span) = self.lexer.next(true)?;
        match lexeme {
            Lexeme::Number(value) => {
                let digits = self.lexer.text[span.clone()].to_owned();
                let unit = self.unit()?;
                let end = self.lexer.at();
                let node = Node::Number(WrittenNumber { digits, value }, unit);
                let span = span.start..end;
                Ok(ExpressionTree { span, node })
            }
            Lexeme::Name => self.named(span),
            Lexeme::Mark('(') => {
                let within = self.deeper(Self::sum)?;
                let end = self.close()?;
                Ok(ExpressionTree {
                    span: span.start..end,
                    ..within
                })
            }
            _ => Err(self.unexpected(span, words().number_or_name())),
        }
    }

    /// Consumes a closing bracket and returns its end.
    fn close(&mut self) -> Result<usize, FormulaError> {
        match self.lexer.next(false)? {
            (Lexeme::Mark(')'), span) => Ok(span.end),
            (_, span) => Err(self.unexpected(span, words().closing_bracket())),
        }
    }

    fn named(&mut self, span: Range<usize>) -> Result<ExpressionTree, FormulaError> {
        let name = &self.lexer.text[span.clone()];
        if self.mark(&['('])?.is_none() {
            let node = Node::Name(name.to_owned());
            return Ok(ExpressionTree { span, node });
        }
        let Some(function) = MathFunction::named(name) else {
            let names: Vec<&str> = functions().collect();
            let fault = FormulaError::new(span, words().no_function(name));
            let listed = || words().functions_are(&names.join(", "));
            let help = did_you_mean(name, functions()).unwrap_or_else(listed);
            return Err(fault.help(help));
        };
        let mut given = vec![self.deeper(Self::sum)?];
        while self.mark(&[','])?.is_some() {
            given.push(self.deeper(Self::sum)?);
        }
        let end = self.close()?;
        let span = span.start..end;
        let (minimum, maximum) = function.takes();
        if !(minimum..=maximum).contains(&given.len()) {
            let fault = words().function_takes(name, minimum, maximum, given.len());
            return Err(FormulaError::new(span, fault));
        }
        let node = Node::Call(function, given);
        Ok(ExpressionTree { span, node })
    }

    /// Parses the unit following a number, if there is one: `mm`, `rad/s^2`, `N m`.
    fn unit(&mut self) -> Result<Option<WrittenUnit>, FormulaError> {
        let text = self.lexer.text;
        let from = text.len() - text[self.lexer.at()..].trim_start().len();
        let Some((mut unit, mut end)) = unit_part(text, from, 1) else {
            return Ok(None);
        };
        loop {
            let next = match text[end..].chars().next() {
                Some('/') => unit_part(text, end + 1, -1),
                Some(' ') => unit_part(text, end + 1, 1),
                _ => None,
            };
            let Some((part, part_end)) = next else { break };
            let joined = unit.dimension.times(part.dimension);
            let too_much = || FormulaError::new(from..part_end, words().unit_beyond_use());
            unit.dimension = joined.ok_or_else(too_much)?;
            unit.lengths.extend(part.lengths);
            let degrees = unit.degrees.checked_add(part.degrees);
            let degrees = degrees.filter(|power| power.abs() <= MAX_POWER);
            unit.degrees = degrees.ok_or_else(too_much)?;
            end = part_end;
        }
        self.lexer.skip_to(end);
        // Degrees alone stay degrees.
        if unit.degrees == 1 && unit.dimension == Dimension::RADIANS {
            unit.dimension = Dimension::DEGREES;
            unit.degrees = 0;
        }
        Ok(Some(unit))
    }
}

/// Creates a power. A whole exponent is used directly. A half-integer exponent becomes a power of
/// the square root, which exists at 0, too. Any other one becomes an exponential of a logarithm.
/// Returns `None` for an invalid exponent.
fn power_of(base: ExpressionTree, sign: i8, exponent: WrittenNumber) -> Option<Node> {
    let integer = |exponent: f64, maximum: u8| {
        let mut all = 1..=maximum as i8;
        all.find(|&integer| f64::from(integer) == exponent)
    };
    let size = exponent.value;
    if let Some(integer) = integer(size, MAX_EXPONENT) {
        return Some(Node::Power(Box::new(base), sign * integer));
    }
    if !(size > 0.0 && size < f64::from(MAX_EXPONENT)) {
        return None;
    }
    let span = base.span.clone();
    let node = |node: Node| ExpressionTree {
        span: span.clone(),
        node,
    };
    if let Some(halves) = integer(2.0 * size, 2 * MAX_EXPONENT) {
        let root = node(Node::Call(MathFunction::Sqrt, vec![base]));
        return Some(Node::Power(Box::new(root), sign * halves));
    }
    let exponent = node(Node::Number(exponent, None));
    let exponent = match sign < 0 {
        true => node(Node::Negative(Box::new(exponent))),
        false => exponent,
    };
    let logarithm = node(Node::Call(MathFunction::Ln, vec![base]));
    let product = Node::Pair(Operation::Multiply, Box::new([exponent, logarithm]));
    Some(Node::Call(MathFunction::Exp, vec![node(product)]))
}

fn pair(operation: Operation, left: ExpressionTree, right: ExpressionTree) -> ExpressionTree {
    ExpressionTree {
        span: left.span.start..right.span.end,
        node: Node::Pair(operation, Box::new([left, right])),
    }
}

/// Parses a unit with its power at a position of a text, and returns it with its end; `None` if
/// there is no unit.
fn unit_part(text: &str, from: usize, sign: i8) -> Option<(WrittenUnit, usize)> {
    let rest = &text[from..];
    let is_of_word = |c| is_of_name(c) || is_of_unit(c);
    let word = &rest[..rest.find(|c| !is_of_word(c)).unwrap_or(rest.len())];
    let (dimension, tenths, degrees) = unit_of(word)?;
    let mut end = from + word.len();
    let mut power = 1;
    if let Some(digit) = text[end..].strip_prefix('^') {
        let digit = digit.get(..1).and_then(number);
        let integer = (1..=4).find(|&integer| digit == Some(f64::from(integer)))?;
        power = integer;
        end += 2;
    }
    // A function, or a name that begins like a unit.
    if text[end..].starts_with(|c| is_of_name(c) || c == '(') {
        return None;
    }
    let power = sign * power;
    let unit = WrittenUnit {
        dimension: dimension.power(power)?,
        lengths: tenths.map(|tenths| (tenths, power)).into_iter().collect(),
        degrees: degrees * power,
    };
    Some((unit, end))
}

/// Splits a number and a unit without a blank between them, which the lexer reads as a name.
pub(crate) fn glued(name: &str) -> Option<(&str, &str)> {
    let at = name.find(|c: char| !c.is_ascii_digit() && c != '.')?;
    let (number, unit) = name.split_at(at);
    (number.parse::<f64>().is_ok() && is_unit(unit)).then_some((number, unit))
}

/// Returns the dimension of a unit, the size of a length in tenths of a millimetre, and the power
/// of degrees.
fn unit_of(word: &str) -> Option<(Dimension, Option<f64>, i8)> {
    let length = |tenths| Some((Dimension::LENGTH, Some(tenths), 0));
    match unit_named(word)? {
        "mm" => length(10.0),
        "cm" => length(100.0),
        "m" => length(METRE),
        "in" => length(254.0),
        "s" => Some((Dimension::SECOND, None, 0)),
        "kg" => Some((Dimension::KILOGRAM, None, 0)),
        "N" => Some((Dimension::FORCE, None, 0)),
        "rad" => Some((Dimension::RADIANS, None, 0)),
        "deg" => Some((Dimension::RADIANS, None, 1)),
        _ => None,
    }
}
