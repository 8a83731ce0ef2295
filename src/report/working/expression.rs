//! Formulas as one tree that yields symbols, numbers and value, so that these always agree.

use super::figures::factor;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A formula; angles are in degrees.
#[derive(Clone, Debug)]
pub(super) enum Expression {
    /// A known value with its symbol.
    Known {
        symbol: String,
        /// The value as written.
        figure: String,
        value: f64,
    },
    /// A number that is part of the formula: the 2 of `2 p`.
    Number(f64),
    Minus(Box<Expression>),
    Sum(Box<[Expression; 2]>),
    Product(Box<[Expression; 2]>),
    Ratio(Box<[Expression; 2]>),
    Square(Box<Expression>),
    Function(Function, Vec<Expression>),
}

/// The functions in formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Function {
    Sqrt,
    Sin,
    Cos,
    Acos,
    Atan,
    Atan2,
}

/// The notation of known values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Notation {
    Symbols,
    Numbers,
}

/// The binding strength of a text, for brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Precedence {
    Sum,
    Ratio,
    Product,
    Alone,
}

/// A formula or a part of it in written form, with its sign separate.
struct Written {
    negative: bool,
    text: String,
    precedence: Precedence,
}

impl Expression {
    pub(super) fn known(symbol: impl Into<String>, figure: String, value: f64) -> Expression {
        Expression::Known {
            symbol: symbol.into(),
            figure,
            value,
        }
    }

    pub(super) fn of<const N: usize>(function: Function, of: [Expression; N]) -> Expression {
        Expression::Function(function, of.into())
    }

    pub(super) fn squared(self) -> Expression {
        Expression::Square(Box::new(self))
    }

    pub(super) fn sqrt(self) -> Expression {
        Expression::of(Function::Sqrt, [self])
    }

    /// Returns the formula, negated if `negative`.
    pub(super) fn minus_if(self, negative: bool) -> Expression {
        if negative { -self } else { self }
    }

    /// Returns a value without a symbol, as a term of a sum.
    pub(super) fn figure(figure: String, value: f64) -> Expression {
        Expression::known(figure.clone(), figure, value)
    }

    /// Returns the sum of terms, if there are any.
    pub(super) fn total(terms: impl IntoIterator<Item = Expression>) -> Option<Expression> {
        terms.into_iter().reduce(|sum, term| sum + term)
    }

    /// Writes the formula in symbols.
    pub(super) fn symbols(&self) -> String {
        self.written(Notation::Symbols).signed_text()
    }

    /// Writes the formula with numbers.
    pub(super) fn numbers(&self) -> String {
        self.written(Notation::Numbers).signed_text()
    }

    /// Returns the value.
    pub(super) fn value(&self) -> f64 {
        match self {
            Expression::Known { value, .. } | Expression::Number(value) => *value,
            Expression::Minus(of) => -of.value(),
            Expression::Sum(of) => of[0].value() + of[1].value(),
            Expression::Product(of) => of[0].value() * of[1].value(),
            Expression::Ratio(of) => of[0].value() / of[1].value(),
            Expression::Square(of) => of.value() * of.value(),
            Expression::Function(function, of) => {
                let of: Vec<f64> = of.iter().map(Expression::value).collect();
                function.value(&of)
            }
        }
    }

    fn written(&self, form: Notation) -> Written {
        match self {
            Expression::Known { symbol, figure, .. } => match form {
                Notation::Symbols => Written::figure(symbol),
                Notation::Numbers => Written::figure(figure),
            },
            Expression::Number(number) => Written::figure(&number.to_string()),
            Expression::Minus(of) => {
                let of = of.written(form);
                let is_nothing = form == Notation::Numbers && of.text == "0";
                Written {
                    negative: !of.negative && !is_nothing,
                    text: of.bracketed(Precedence::Ratio),
                    precedence: if of.precedence < Precedence::Ratio {
                        Precedence::Alone
                    } else {
                        of.precedence
                    },
                }
            }
            Expression::Sum(of) => {
                let [first, second] = [&of[0], &of[1]].map(|part| part.written(form));
                // A zero has no sign of its own, but keeps the minus of a subtraction.
                let is_less = matches!(&of[1], Expression::Minus(_)) && second.text == "0";
                let sign = if second.negative || is_less { "-" } else { "+" };
                let second = match &of[1] {
                    // A sum that begins with a minus would have two signs before it.
                    Expression::Sum(_) if second.text.starts_with('-') => {
                        second.bracketed(Precedence::Ratio)
                    }
                    _ => second.text,
                };
                Written::of(
                    format!("{} {sign} {second}", first.signed_text()),
                    Precedence::Sum,
                )
            }
            Expression::Product(of) => {
                let [first, second] =
                    [&of[0], &of[1]].map(|part| part.written(form).factor(Precedence::Product));
                let is_number = second.starts_with(|c: char| c.is_ascii_digit());
                let between = match form {
                    Notation::Symbols if !is_number => " ",
                    Notation::Symbols | Notation::Numbers => "·",
                };
                Written::of(format!("{first}{between}{second}"), Precedence::Product)
            }
            Expression::Ratio(of) => {
                let [above, below] = [&of[0], &of[1]].map(|part| part.written(form));
                let (above, below) = (
                    above.factor(Precedence::Ratio),
                    below.factor(Precedence::Alone),
                );
                Written::of(format!("{above}/{below}"), Precedence::Ratio)
            }
            Expression::Square(of) => {
                let of = of.written(form).factor(Precedence::Alone);
                Written::of(format!("{of}^2"), Precedence::Alone)
            }
            Expression::Function(function, of) => {
                let of: Vec<String> = of.iter().map(|of| of.written(form).signed_text()).collect();
                Written::of(
                    format!("{}({})", function.name(), of.join(", ")),
                    Precedence::Alone,
                )
            }
        }
    }
}

impl Function {
    fn name(self) -> &'static str {
        match self {
            Function::Sqrt => "sqrt",
            Function::Sin => "sin",
            Function::Cos => "cos",
            Function::Acos => "acos",
            Function::Atan => "atan",
            Function::Atan2 => "atan2",
        }
    }

    fn value(self, of: &[f64]) -> f64 {
        let first = of.first().copied().unwrap_or(f64::NAN);
        match self {
            // At a dead point, rounding errors may make a root's argument negative, or a cosine
            // larger than 1.
            Function::Sqrt => first.max(0.0).sqrt(),
            Function::Acos => first.clamp(-1.0, 1.0).acos().to_degrees(),
            Function::Sin => first.to_radians().sin(),
            Function::Cos => first.to_radians().cos(),
            Function::Atan => first.atan().to_degrees(),
            Function::Atan2 => first
                .atan2(of.get(1).copied().unwrap_or(f64::NAN))
                .to_degrees(),
        }
    }
}

impl Written {
    fn of(text: String, grip: Precedence) -> Written {
        Written {
            negative: false,
            text,
            precedence: grip,
        }
    }

    fn figure(figure: &str) -> Written {
        let size = figure.strip_prefix('-').filter(|size| !size.is_empty());
        Written {
            negative: size.is_some(),
            text: size.unwrap_or(figure).to_owned(),
            // In a power, a number such as 2e-6 needs brackets.
            precedence: match figure.parse::<f64>() {
                Ok(_) if figure.contains('e') => Precedence::Product,
                _ => Precedence::Alone,
            },
        }
    }

    /// Returns the text with its sign.
    fn signed_text(&self) -> String {
        let sign = if self.negative { "-" } else { "" };
        format!("{sign}{}", self.text)
    }

    /// Returns the text without its sign, in brackets if it binds less strongly than `minimum`.
    fn bracketed(&self, minimum: Precedence) -> String {
        if self.precedence < minimum {
            format!("({})", self.text)
        } else {
            self.text.clone()
        }
    }

    /// Returns the text as a factor, in brackets also if it is negative.
    fn factor(&self, minimum: Precedence) -> String {
        if self.negative {
            factor(&self.signed_text())
        } else {
            self.bracketed(minimum)
        }
    }
}

impl Neg for Expression {
    type Output = Expression;
    fn neg(self) -> Expression {
        Expression::Minus(Box::new(self))
    }
}

impl Add for Expression {
    type Output = Expression;
    fn add(self, other: Expression) -> Expression {
        Expression::Sum(Box::new([self, other]))
    }
}

impl Sub for Expression {
    type Output = Expression;
    fn sub(self, other: Expression) -> Expression {
        self + -other
    }
}

impl Mul for Expression {
    type Output = Expression;
    fn mul(self, other: Expression) -> Expression {
        Expression::Product(Box::new([self, other]))
    }
}

impl Div for Expression {
    type Output = Expression;
    fn div(self, other: Expression) -> Expression {
        Expression::Ratio(Box::new([self, other]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(symbol: &str, value: f64) -> Expression {
        Expression::known(
            symbol,
            crate::report::text::number::concise(value, 17),
            value,
        )
    }

    #[test]
    fn one_tree_yields_symbols_numbers_and_value() {
        let [m, b, c] = [("m", 5.0), ("r3", 4.0), ("r4", 3.0)].map(|(s, v)| known(s, v));
        let cosine = (m.clone().squared() + b.clone().squared() - c.squared())
            / (Expression::Number(2.0) * m * b);
        let beta = Expression::of(Function::Acos, [cosine]);
        assert_eq!(beta.symbols(), "acos((m^2 + r3^2 - r4^2)/(2 m r3))");
        assert_eq!(beta.numbers(), "acos((5^2 + 4^2 - 3^2)/(2·5·4))");
        assert!((beta.value() - 0.8_f64.acos().to_degrees()).abs() < 1e-12);
    }

    #[test]
    fn signs_and_brackets_appear_only_as_needed() {
        let (a, b) = (known("a", -2.0), known("b", -3.0));
        let cases = [
            (a.clone() + b.clone(), "a + b", "-2 - 3", -5.0),
            (a.clone() - b.clone(), "a - b", "-2 + 3", 1.0),
            (-a.clone() + b.clone(), "-a + b", "2 - 3", -1.0),
            (a.clone() * b.clone(), "a b", "(-2)·(-3)", 6.0),
            (a.clone().squared(), "a^2", "(-2)^2", 4.0),
            (-(a.clone() - b.clone()), "-(a - b)", "-(-2 + 3)", -1.0),
            (-(a.clone() / b.clone()), "-a/b", "-(-2)/(-3)", -2.0 / 3.0),
            (-known("z", 0.0) + known("k", 2.0), "-z + k", "0 + 2", 2.0),
            (known("t", 2e-6).squared(), "t^2", "(2e-6)^2", 4e-12),
            (
                (-(a.clone() + b.clone())).squared(),
                "(-(a + b))^2",
                "(-(-2 - 3))^2",
                25.0,
            ),
            (
                a.clone() - (a.clone() - b.clone()),
                "a - (a - b)",
                "-2 - (-2 + 3)",
                -3.0,
            ),
            (
                known("k", 2.0) * (a.clone() - b.clone()),
                "k (a - b)",
                "2·(-2 + 3)",
                2.0,
            ),
            (
                Expression::of(Function::Atan2, [-a.clone(), b]),
                "atan2(-a, b)",
                "atan2(2, -3)",
                2.0_f64.atan2(-3.0).to_degrees(),
            ),
        ];
        for (expression, symbols, numbers, value) in cases {
            assert_eq!(expression.symbols(), symbols);
            assert_eq!(expression.numbers(), numbers);
            assert!((expression.value() - value).abs() < 1e-12, "{symbols}");
        }
    }
}
