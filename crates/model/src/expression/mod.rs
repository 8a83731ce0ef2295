//! Parses and evaluates formulas, such as `armL.angle - armR.angle` or
//! `hypot(C.vx, C.vy) / (100 mm)`.
//!
//! Formulas of plain numbers are evaluated once, with so many digits that none are lost (`Wide`).
//!
//! A text is parsed into a tree with the position of each part. The tree is checked and compiled to
//! `Code`, which runs over any [`Number`](crate::Number): doubles give values, balls their
//! bounds, duals their derivatives by a length. Rates are exact, by Taylor coefficients (`jet`).
//! The module does not know the meaning of names: the caller supplies it as a `Part`, and its
//! unit as a [`Dimension`].

mod code;
mod compile;
mod conversion;
mod cuts;
mod dimension;
mod elementary;
mod evaluate;
mod jet;
mod kink;
mod lexer;
mod parser;
#[cfg(test)]
mod tests;
mod tree;
mod unit_words;
mod wide;

pub(crate) use code::{Code, Op};
pub(crate) use compile::{Kind, Part, Revolution, compile};
pub(crate) use conversion::converted;
pub(crate) use cuts::DirectionCut;
pub use dimension::{Dimension, LengthScale};
pub use evaluate::MeasuredNumber;
pub(crate) use evaluate::evaluate;
pub(crate) use parser::{glued, parse};
pub use tree::functions;
pub(crate) use tree::{ExpressionTree, is_function};
pub use unit_words::plain_unit;
pub(crate) use unit_words::{UNITS, is_unit};
pub use wide::Wide;

use std::ops::Range;

/// Maximum length of a formula, in bytes.
pub const MAX_LEN: usize = 1000;

/// A fault in a formula, with its position in the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct FormulaError {
    /// The bytes with the fault.
    pub(crate) span: Range<usize>,
    /// A description of the fault.
    pub(crate) message: String,
    /// A hint how to fix it.
    pub(crate) help: Option<String>,
}

impl FormulaError {
    fn new(span: Range<usize>, message: impl Into<String>) -> Self {
        FormulaError {
            span,
            message: message.into(),
            help: None,
        }
    }

    fn help(self, help: impl Into<String>) -> Self {
        FormulaError {
            help: Some(help.into()),
            ..self
        }
    }

    /// Returns the fault and the hint in one line.
    pub(crate) fn words(&self) -> String {
        match &self.help {
            Some(help) => format!("{}; {help}", self.message),
            None => self.message.clone(),
        }
    }
}

/// Dashes that are typed or pasted for a minus sign: the mathematical one and three typographic
/// ones.
pub(crate) const DASHES: [char; 4] = ['\u{2212}', '\u{2010}', '\u{2013}', '\u{2014}'];

/// Returns `true` if a name reads as a difference of known names and numbers, such as `a-b` or
/// `rod-2`. It is one name unless there are blanks around its `-`.
pub(crate) fn is_difference(name: &str, is_known: impl Fn(&str) -> bool) -> bool {
    let is_part = |part: &str| lexer::number(part).is_some() || is_known(part);
    // The positions where a part may begin, because everything before them is known.
    let mut starts = vec![0];
    let mut next = 0;
    while let Some(&from) = starts.get(next) {
        next += 1;
        for (length, _) in name[from..].match_indices('-') {
            let after = from + length + 1;
            if is_part(&name[from..after - 1]) && !starts.contains(&after) {
                starts.push(after);
            }
        }
    }
    starts.iter().skip(1).any(|&from| is_part(&name[from..]))
}

/// Returns `true` if a character can occur in a name: those of the names in a scene, and the dots
/// between their parts.
pub(crate) fn is_of_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '\'' | '.')
}
