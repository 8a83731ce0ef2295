//! Formulas as data: pieces that every writer typesets in its own way.

use compact_str::{CompactString, ToCompactString as _};
use std::fmt::{self, Write as _};

/// A formula: its pieces in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Formula(pub(super) Vec<MathPiece>);

/// A piece of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum MathPiece {
    Symbol(Symbol),
    /// `cos` with its arguments.
    Function(&'static str, Formula),
    /// A word or a unit, which is no symbol.
    Word(CompactString),
    /// A number without its sign: `5.7e-14`.
    Number(CompactString),
    /// An exponent: `2`.
    Power(CompactString),
    /// A sign or a bracket.
    Sign(char),
    Blank,
}

/// A symbol: its letter or name, its index, and its order of differentiation by time.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Symbol {
    pub(super) letter: CompactString,
    pub(super) index: CompactString,
    /// The order of differentiation by time.
    pub(super) order: usize,
    /// Whether an underscore separates the index in plain text.
    is_separate: bool,
}

impl Symbol {
    /// Creates the symbol of a name, with the number at its end or the part after its first
    /// underscore as index.
    pub(crate) fn named(name: &str) -> Symbol {
        let first = name.chars().next().map_or(0, char::len_utf8);
        let number = name[first..].trim_end_matches('\'');
        let is_number = !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit());
        match name.split_once('_') {
            Some((letter, index)) if !letter.is_empty() => Symbol::separate(letter, index),
            _ if is_number => Symbol::indexed(&name[..first], &name[first..]),
            _ => Symbol::indexed(name, ""),
        }
    }

    /// Creates a symbol whose index follows directly in plain text: `Kx`.
    pub(crate) fn indexed(
        letter: impl Into<CompactString>,
        index: impl Into<CompactString>,
    ) -> Symbol {
        Symbol {
            letter: letter.into(),
            index: index.into(),
            ..Symbol::default()
        }
    }

    /// Creates a symbol whose index follows an underscore in plain text: `θ_ram`.
    pub(crate) fn separate(
        letter: impl Into<CompactString>,
        index: impl Into<CompactString>,
    ) -> Symbol {
        Symbol {
            is_separate: true,
            ..Symbol::indexed(letter, index)
        }
    }

    /// Returns the derivative of this order by time.
    pub(crate) fn derivative(self, order: usize) -> Symbol {
        Symbol { order, ..self }
    }

    /// Returns `true` if the symbol is a word, which is upright.
    pub(super) fn is_word(&self) -> bool {
        self.index.is_empty() && self.letter.len() > 1 && self.letter.is_ascii()
    }
}

impl Formula {
    fn one(piece: MathPiece) -> Formula {
        Formula(vec![piece])
    }

    /// Creates the formula of a formatted number.
    pub(crate) fn number(figure: &str) -> Formula {
        match figure.strip_prefix('-') {
            Some("") => Formula::sign('-'),
            Some(size) => Formula::sign('-').then(Formula::number(size)),
            None => Formula::one(MathPiece::Number(figure.into())),
        }
    }

    /// Creates the formula of a formatted number with its unit.
    pub(crate) fn measured(figure: impl AsRef<str>, unit: &str) -> Formula {
        let number = Formula::number(figure.as_ref());
        match unit {
            "" => number,
            unit => number.blank().then(Formula::words(unit)),
        }
    }

    /// Creates a formula of words and units: `force at B`, `N m`, `mm/s^2`.
    pub(crate) fn words(text: &str) -> Formula {
        let mut pieces = Vec::new();
        let mut before = ' ';
        for c in text.chars() {
            // A hyphen within a name belongs to it.
            let is_sign = "/^(),:|".contains(c) || c == '-' && !before.is_alphanumeric();
            match (c, pieces.last_mut()) {
                (' ', _) => pieces.push(MathPiece::Blank),
                (_, Some(MathPiece::Power(name) | MathPiece::Word(name))) if !is_sign => {
                    name.push(c);
                }
                ('^', _) => pieces.push(MathPiece::Power(CompactString::default())),
                _ if is_sign => pieces.push(MathPiece::Sign(c)),
                _ => pieces.push(MathPiece::Word(c.to_compact_string())),
            }
            before = c;
        }
        for piece in &mut pieces {
            if let MathPiece::Word(name) = piece
                && name.bytes().all(|b| b.is_ascii_digit())
            {
                *piece = MathPiece::Number(std::mem::take(name));
            }
        }
        Formula(pieces)
    }

    /// Creates a message whose arguments are formulas.
    pub(crate) fn message<const N: usize>(
        message: impl FnOnce([&str; N]) -> String,
        arguments: [Formula; N],
    ) -> Formula {
        // Characters for private use hold the places of the arguments.
        let places: [char; N] = std::array::from_fn(|k| ('\u{e000}'..).nth(k).unwrap_or_default());
        let marks = places.map(String::from);
        let text = message(marks.each_ref().map(String::as_str));
        let mut formula = Formula::default();
        for part in text.split_inclusive(places) {
            formula = formula.then(Formula::words(part.trim_end_matches(places)));
            if let Some(k) = places.iter().position(|&place| part.ends_with(place)) {
                formula = formula.then(arguments[k].clone());
            }
        }
        formula
    }

    /// Creates a call of a function with its arguments.
    pub(crate) fn function(
        name: &'static str,
        arguments: impl IntoIterator<Item = Formula>,
    ) -> Formula {
        let listed = arguments
            .into_iter()
            .reduce(|all, one| all.with_sign(',').blank().then(one));
        Formula::one(MathPiece::Function(name, listed.unwrap_or_default()))
    }

    pub(crate) fn sign(sign: char) -> Formula {
        Formula::one(MathPiece::Sign(sign))
    }

    pub(crate) fn zero() -> Formula {
        Formula::number("0")
    }

    pub(crate) fn then(mut self, other: impl Into<Formula>) -> Formula {
        self.0.extend(other.into().0);
        self
    }

    fn with(mut self, piece: MathPiece) -> Formula {
        self.0.push(piece);
        self
    }

    pub(crate) fn blank(self) -> Formula {
        self.with(MathPiece::Blank)
    }

    pub(crate) fn with_sign(self, sign: char) -> Formula {
        self.with(MathPiece::Sign(sign))
    }

    pub(crate) fn power(self, exponent: &str) -> Formula {
        self.with(MathPiece::Power(exponent.into()))
    }

    /// Returns the formula between two signs, such as bars.
    pub(crate) fn between(self, [open, close]: [char; 2]) -> Formula {
        Formula::sign(open).then(self).with_sign(close)
    }

    pub(crate) fn in_brackets(self) -> Formula {
        self.between(['(', ')'])
    }

    pub(crate) fn equals(self, other: Formula) -> Formula {
        self.blank().with_sign('=').blank().then(other)
    }

    /// Returns the formula without the minus sign in front of it, if it has one.
    pub(crate) fn without_minus(&self) -> Option<Formula> {
        match self.0.split_first() {
            Some((MathPiece::Sign('-'), rest)) if !rest.is_empty() => Some(Formula(rest.into())),
            _ => None,
        }
    }

    /// Returns the number that the formula begins with.
    pub(crate) fn leading_number(&self) -> Option<&str> {
        match self.0.first() {
            Some(MathPiece::Number(number)) => Some(number),
            _ => None,
        }
    }

    /// Returns `true` if the formula is a single number or symbol.
    pub(crate) fn is_single(&self) -> bool {
        self.0.len() == 1
    }

    /// Returns the formula with every text replaced.
    pub(super) fn with_texts(&self, shown: &impl Fn(&str) -> String) -> Formula {
        let piece = |piece: &MathPiece| match piece {
            MathPiece::Symbol(symbol) => MathPiece::Symbol(Symbol {
                letter: shown(&symbol.letter).into(),
                index: shown(&symbol.index).into(),
                order: symbol.order,
                is_separate: symbol.is_separate,
            }),
            MathPiece::Function(name, of) => MathPiece::Function(name, of.with_texts(shown)),
            MathPiece::Word(word) => MathPiece::Word(shown(word).into()),
            // In plain text, two characters.
            MathPiece::Sign('±') => piece.clone(),
            MathPiece::Sign(sign) => {
                let sign = shown(&sign.to_string()).chars().next();
                MathPiece::Sign(sign.unwrap_or_default())
            }
            MathPiece::Number(_) | MathPiece::Power(_) | MathPiece::Blank => piece.clone(),
        };
        Formula(self.0.iter().map(piece).collect())
    }
}

impl From<Symbol> for Formula {
    fn from(symbol: Symbol) -> Formula {
        Formula::one(MathPiece::Symbol(symbol))
    }
}

impl From<&str> for Symbol {
    fn from(name: &str) -> Symbol {
        Symbol::named(name)
    }
}

impl From<&Symbol> for Formula {
    fn from(symbol: &Symbol) -> Formula {
        symbol.clone().into()
    }
}

impl From<&str> for Formula {
    /// Creates the symbol of a name.
    fn from(name: &str) -> Formula {
        Symbol::named(name).into()
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [letter, index] = [&*self.letter, &*self.index];
        let [before, after] = [["", ""], ["d", "/dt"], ["d2", "/dt2"]][self.order.min(2)];
        let between = if self.is_separate { "_" } else { "" };
        [before, letter, between, index, after]
            .into_iter()
            .try_for_each(|part| f.write_str(part))
    }
}

impl fmt::Display for MathPiece {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MathPiece::Symbol(symbol) => symbol.fmt(f),
            MathPiece::Function(name, of) => write!(f, "{name}({of})"),
            MathPiece::Word(text) | MathPiece::Number(text) => f.write_str(text),
            MathPiece::Power(exponent) => write!(f, "^{exponent}"),
            MathPiece::Sign('±') => f.write_str("+-"),
            MathPiece::Sign(sign) => f.write_char(*sign),
            MathPiece::Blank => f.write_char(' '),
        }
    }
}

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|piece| piece.fmt(f))
    }
}

#[cfg(test)]
impl Formula {
    /// Returns `-r2 ω2^2 cos(θ2)`.
    pub(super) fn example() -> Formula {
        let cos = Formula::function("cos", ["θ2".into()]);
        let square = Formula::from("ω2").power("2");
        let factors = Formula::from("r2").blank().then(square).blank().then(cos);
        Formula::sign('-').then(factors)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_split_into_letter_and_index() {
        for (name, letter, index) in [
            ("r3", "r", "3"),
            ("θ3", "θ", "3"),
            ("θ3'", "θ", "3'"),
            ("α_ram", "α", "ram"),
            ("a_r3.com_t", "a", "r3.com_t"),
            ("a-b", "a-b", ""),
            ("mx", "mx", ""),
            ("sin", "sin", ""),
            ("_", "_", ""),
            ("", "", ""),
        ] {
            let symbol = Symbol::named(name);
            assert_eq!((&*symbol.letter, &*symbol.index), (letter, index), "{name}");
            assert_eq!(symbol.to_string(), name);
        }
        assert_eq!(Symbol::named("r4").derivative(2).to_string(), "d2r4/dt2");
    }

    #[test]
    fn words_split_into_units_numbers_and_signs() {
        let word = |text: &str| MathPiece::Word(text.into());
        let acceleration = [
            word("mm"),
            MathPiece::Sign('/'),
            word("s"),
            MathPiece::Power("2".into()),
        ];
        assert_eq!(Formula::words("mm/s^2").0, acceleration);
        let loop_of = [
            word("loop"),
            MathPiece::Blank,
            MathPiece::Number("1".into()),
        ];
        assert_eq!(Formula::words("loop 1").0, loop_of);
        assert_eq!(Formula::words("boom-rod").0, [word("boom-rod")]);
        for text in ["N m", "1/rad", "angle of -(", "", " deg", "a  b,"] {
            assert_eq!(Formula::words(text).to_string(), text);
        }
    }

    #[test]
    fn messages_take_formulas_as_arguments_in_any_order() {
        let arguments = [Formula::from("x"), Formula::measured("-2.5", "mm")];
        let message = |[one, other]: [&str; 2]| format!("{other} of {one}: {other}");
        let formula = Formula::message(message, arguments);
        assert_eq!(formula.to_string(), "-2.5 mm of x: -2.5 mm");
        assert_eq!(formula.0[1], MathPiece::Number("2.5".into()));
    }
}
