//! Terms of a formula in a script.

use std::fmt;

/// A term, and `true` if it needs parentheses as a factor.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ScriptTerm {
    text: String,
    is_sum: bool,
}

impl ScriptTerm {
    /// Creates a term from a name, a call or a number.
    pub(super) fn of(text: impl Into<String>) -> Self {
        ScriptTerm {
            text: text.into(),
            is_sum: false,
        }
    }

    pub(super) fn zero() -> Self {
        ScriptTerm::of("0")
    }

    pub(super) fn one() -> Self {
        ScriptTerm::of("1")
    }

    fn is(&self, text: &str) -> bool {
        self.text == text
    }

    pub(super) fn plus(self, other: ScriptTerm) -> Self {
        match (self.is("0"), other.is("0")) {
            (true, _) => other,
            (_, true) => self,
            _ => ScriptTerm {
                text: format!("{self} + {other}"),
                is_sum: true,
            },
        }
    }

    pub(super) fn minus(self, other: ScriptTerm) -> Self {
        match (self.is("0"), other.is("0")) {
            (_, true) => self,
            (true, _) => ScriptTerm {
                text: format!("-{}", other.factor()),
                is_sum: true,
            },
            _ => ScriptTerm {
                text: format!("{self} - {}", other.factor()),
                is_sum: true,
            },
        }
    }

    pub(super) fn times(self, other: ScriptTerm) -> Self {
        match (self.is("0") || other.is("0"), self.is("1"), other.is("1")) {
            (true, ..) => ScriptTerm::zero(),
            (_, true, _) => other,
            (_, _, true) => self,
            _ => ScriptTerm::of(format!("{} * {}", self.factor(), other.factor())),
        }
    }

    pub(super) fn over(self, other: ScriptTerm) -> Self {
        match (other.is("1"), other.text.contains(' ')) {
            (true, _) => self,
            (_, true) => ScriptTerm::of(format!("{} / ({other})", self.factor())),
            (_, false) => ScriptTerm::of(format!("{} / {other}", self.factor())),
        }
    }

    /// Returns the term as a factor of a product.
    fn factor(&self) -> String {
        match self.is_sum {
            true => format!("({self})"),
            false => self.text.clone(),
        }
    }
}

impl fmt::Display for ScriptTerm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Formats a number so that it reads back to the same double.
pub(super) fn number(value: f64) -> String {
    format!("{value:?}")
}

/// Formats a place or a vector as a complex number, or as a real one if it lies along x.
pub(super) fn complex(x: f64, y: f64) -> String {
    match y == 0.0 {
        true => number(x),
        false => format!("complex({}, {})", number(x), number(y)),
    }
}
