//! Formulas that a person writes: `armL.angle - armR.angle`, `hypot(C.vx, C.vy) / (100 mm)`.
//!
//! Formulas of plain numbers are evaluated once, in numbers of so many digits that none are lost (`Wide`).
//!
//! A text is parsed into a tree that remembers where each part stands, the tree is checked and made into
//! [`Code`], and that is run over any [`Number`](crate::Number): in doubles it gives figures, in balls their
//! bounds, in duals what a length does to them. Rates are exact, by Taylor's coefficients (`jet`). Nothing
//! here knows what a name stands for: whoever asks tells, as a [`Part`], and what it measures, as a
//! [`Dimension`].

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

/// Bytes that a formula may have.
pub const LONGEST: usize = 1000;

/// What is wrong with a formula, and where in its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Malformed {
    /// The bytes that it is about.
    pub(crate) span: Range<usize>,
    /// What is wrong.
    pub(crate) message: String,
    /// What would mend it.
    pub(crate) help: Option<String>,
}

impl Malformed {
    fn new(span: Range<usize>, message: impl Into<String>) -> Self {
        Malformed {
            span,
            message: message.into(),
            help: None,
        }
    }

    fn help(self, help: impl Into<String>) -> Self {
        Malformed {
            help: Some(help.into()),
            ..self
        }
    }

    /// In one line: what is wrong, and what would mend it.
    pub(crate) fn words(&self) -> String {
        match &self.help {
            Some(help) => format!("{}; {help}", self.message),
            None => self.message.clone(),
        }
    }
}

/// Whether a name reads as a difference of what is known and of numbers: `a-b`, `rod-2`. It is one name where nobody
/// puts blanks around its `-`.
pub(crate) fn is_difference(name: &str, is_known: impl Fn(&str) -> bool) -> bool {
    let is_part = |part: &str| lexer::number(part).is_some() || is_known(part);
    // Where a part may begin: all before it are known.
    let mut begins = vec![0];
    let mut next = 0;
    while let Some(&from) = begins.get(next) {
        next += 1;
        for (length, _) in name[from..].match_indices('-') {
            let behind = from + length + 1;
            if is_part(&name[from..behind - 1]) && !begins.contains(&behind) {
                begins.push(behind);
            }
        }
    }
    begins.iter().skip(1).any(|&from| is_part(&name[from..]))
}

/// Whether a character may stand in a name: those of the parts of a scene, and the dots between them.
pub(crate) fn is_of_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '\'' | '.')
}
