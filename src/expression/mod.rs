//! Formulas that a person writes: `armL.angle - armR.angle`, `hypot(C.vx, C.vy) / (100 mm)`.
//!
//! A text is parsed into a tree that remembers where each part stands, the tree is checked and made into
//! [`Code`], and that is run over any [`Number`](crate::Number): in doubles it gives figures, in balls their
//! bounds, in duals what a length does to them. Rates are exact, by Taylor's coefficients (`jet`). Nothing
//! here knows what a name stands for: whoever asks tells, as a [`Part`], and what it measures, as a
//! [`Dimension`].

mod code;
mod compile;
mod dimension;
mod evaluate;
mod evaluated;
mod jet;
mod kink;
mod lexer;
mod parser;
#[cfg(test)]
mod tests;
mod tree;

pub(crate) use code::{Code, Op};
pub(crate) use compile::{Kind, Part, Revolution, compile};
pub(crate) use dimension::{Dimension, LengthScale};
pub(crate) use evaluate::evaluate;
pub(crate) use evaluated::Evaluated;
pub(crate) use parser::parse;
pub(crate) use tree::ExpressionTree;

use std::ops::Range;

/// Bytes that a formula may have.
pub(crate) const LONGEST: usize = 1000;

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

/// Whether a character may stand in a name: those of the parts of a scene, and the dots between them.
pub(crate) fn is_of_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '\'' | '.')
}
