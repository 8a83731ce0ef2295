//! Formulas as one tree that yields symbols, numbers and value, so that these always agree.

use crate::angle;
use crate::page::Formula;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A formula; angles are in degrees.
#[derive(Clone, Debug)]
pub(super) enum Expression {
    /// A value with its symbol.
    Known {
        symbol: Formula,
        /// The value as written.
        figure: Formula,
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
    Tan,
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
    formula: Formula,
    precedence: Precedence,
}

impl Expression {
    pub(super) fn known(symbol: impl Into<Formula>, figure: String, value: f64) -> Expression {
        Expression::Known {
            symbol: symbol.into(),
            figure: Formula::number(&figure),
            value,
        }
    }

    /// Returns a symbol without a value.
    pub(super) fn symbol(symbol: impl Into<Formula>) -> Expression {
        Expression::unknown(symbol, f64::NAN)
    }

    /// Returns an unknown, which has no number yet.
    pub(super) fn unknown(symbol: impl Into<Formula>, value: f64) -> Expression {
        let symbol = symbol.into();
        let figure = symbol.clone();
        Expression::Known {
            symbol,
            figure,
            value,
        }
    }

    pub(super) fn of<const N: usize>(function: Function, of: [Expression; N]) -> Expression {
        Expression::Function(function, of.into())
    }

    /// Returns cosine and sine.
    pub(super) fn cos_and_sin(self) -> [Expression; 2] {
        [Function::Cos, Function::Sin].map(|function| Expression::of(function, [self.clone()]))
    }

    /// Returns the angle of a vector.
    pub(super) fn atan2(y: Expression, x: Expression) -> Expression {
        Expression::of(Function::Atan2, [y, x])
    }

    pub(super) fn squared(self) -> Expression {
        Expression::Square(Box::new(self))
    }

    pub(super) fn sqrt(self) -> Expression {
        Expression::of(Function::Sqrt, [self])
    }

    /// Returns the formula in brackets, wherever it stands.
    pub(super) fn in_brackets(self) -> Expression {
        Expression::Known {
            symbol: self.symbols().in_brackets(),
            figure: self.numbers().in_brackets(),
            value: self.value(),
        }
    }

    /// Returns the formula, negated if `negative`.
    pub(super) fn minus_if(self, negative: bool) -> Expression {
        if negative { -self } else { self }
    }

    /// Returns a value without a symbol, as a term of a sum.
    pub(super) fn figure(figure: String, value: f64) -> Expression {
        Expression::unknown(Formula::number(&figure), value)
    }

    /// Returns the sum of terms, if there are any.
    pub(super) fn total(terms: impl IntoIterator<Item = Expression>) -> Option<Expression> {
        terms.into_iter().reduce(|sum, term| sum + term)
    }

    /// Returns the sum of terms, or 0.
    pub(super) fn sum(terms: impl IntoIterator<Item = Expression>) -> Expression {
        Expression::total(terms).unwrap_or(Expression::Number(0.0))
    }

    /// Returns a number as a term of a sum, times a factor if there is one; `None` for 0.
    pub(super) fn term(figure: String, factor: Option<Expression>) -> Option<Expression> {
        let (negative, size) = match figure.strip_prefix('-') {
            Some(size) if !size.is_empty() => (true, size),
            _ => (false, figure.as_str()),
        };
        let number = || Expression::symbol(Formula::number(size));
        let term = match (size, factor) {
            ("0", _) => return None,
            ("1", Some(factor)) => factor,
            (_, Some(factor)) => number() * factor,
            (_, None) => number(),
        };
        Some(term.minus_if(negative))
    }

    /// Returns the product of factors, if there are any.
    pub(super) fn product(factors: impl IntoIterator<Item = Expression>) -> Option<Expression> {
        factors
            .into_iter()
            .reduce(|product, factor| product * factor)
    }

    /// Writes the formula in symbols.
    pub(super) fn symbols(&self) -> Formula {
        self.written(Notation::Symbols).signed()
    }

    /// Writes the formula with numbers.
    pub(super) fn numbers(&self) -> Formula {
        self.written(Notation::Numbers).signed()
    }

    /// Returns the value.
    pub(super) fn value(&self) -> f64 {
        self.at(f64::NAN)
    }

    /// Returns the value for this value of the symbols without a value.
    pub(super) fn at(&self, x: f64) -> f64 {
        match self {
            Expression::Known { value, .. } if value.is_nan() => x,
            Expression::Known { value, .. } | Expression::Number(value) => *value,
            Expression::Minus(of) => -of.at(x),
            Expression::Sum(of) => of[0].at(x) + of[1].at(x),
            Expression::Product(of) => of[0].at(x) * of[1].at(x),
            Expression::Ratio(of) => of[0].at(x) / of[1].at(x),
            Expression::Square(of) => of.at(x) * of.at(x),
            Expression::Function(function, of) => {
                let of: Vec<f64> = of.iter().map(|of| of.at(x)).collect();
                match (function, &of[..]) {
                    // A tried angle may be a right one, whose components are exact.
                    (Function::Sin, [angle]) if !x.is_nan() => angle::unit(*angle).y,
                    (Function::Cos, [angle]) if !x.is_nan() => angle::unit(*angle).x,
                    _ => function.value(&of),
                }
            }
        }
    }

    /// Returns the maximum absolute value of a product at any angle.
    pub(super) fn maximum(&self) -> f64 {
        match self {
            Expression::Function(..) => 1.0,
            Expression::Product(of) => of[0].maximum() * of[1].maximum(),
            _ => self.value().abs(),
        }
    }

    fn written(&self, form: Notation) -> Written {
        match self {
            Expression::Known { symbol, figure, .. } => match form {
                Notation::Symbols => Written::figure(symbol),
                Notation::Numbers => Written::figure(figure),
            },
            Expression::Number(number) => Written::figure(&Formula::number(&number.to_string())),
            Expression::Minus(of) => {
                let of = of.written(form);
                let is_nothing = form == Notation::Numbers && of.formula == Formula::zero();
                Written {
                    negative: !of.negative && !is_nothing,
                    precedence: if of.precedence < Precedence::Ratio {
                        Precedence::Alone
                    } else {
                        of.precedence
                    },
                    formula: of.bracketed(Precedence::Ratio),
                }
            }
            Expression::Sum(of) => {
                let [first, second] = [&of[0], &of[1]].map(|part| part.written(form));
                // A zero has no sign of its own, but keeps the minus of a subtraction.
                let is_zero = second.formula == Formula::zero();
                let is_less = matches!(&of[1], Expression::Minus(_)) && is_zero;
                let sign = if second.negative || is_less { '-' } else { '+' };
                let second = match &of[1] {
                    // A sum that begins with a minus would have two signs before it.
                    Expression::Sum(_) if second.formula.without_minus().is_some() => {
                        second.bracketed(Precedence::Ratio)
                    }
                    _ => second.formula,
                };
                let sum = first.signed().blank().with_sign(sign).blank();
                Written::of(sum.then(second), Precedence::Sum)
            }
            Expression::Product(of) => {
                let [first, second] =
                    [&of[0], &of[1]].map(|part| part.written(form).factor(Precedence::Product));
                let is_spaced = form == Notation::Symbols && second.leading_number().is_none();
                let first = match is_spaced {
                    true => first.blank(),
                    false => first.with_sign('·'),
                };
                Written::of(first.then(second), Precedence::Product)
            }
            Expression::Ratio(of) => {
                let [above, below] = [&of[0], &of[1]].map(|part| part.written(form));
                let above = above.factor(Precedence::Ratio).with_sign('/');
                Written::of(
                    above.then(below.factor(Precedence::Alone)),
                    Precedence::Ratio,
                )
            }
            Expression::Square(of) => {
                let of = of.written(form).factor(Precedence::Alone);
                Written::of(of.power("2"), Precedence::Alone)
            }
            Expression::Function(function, of) => {
                let of = of.iter().map(|of| of.written(form).signed());
                Written::of(Formula::function(function.name(), of), Precedence::Alone)
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
            Function::Tan => "tan",
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
            Function::Tan => first.to_radians().tan(),
            Function::Atan => first.atan().to_degrees(),
            Function::Atan2 => first
                .atan2(of.get(1).copied().unwrap_or(f64::NAN))
                .to_degrees(),
        }
    }
}

impl Written {
    fn of(formula: Formula, precedence: Precedence) -> Written {
        Written {
            negative: false,
            formula,
            precedence,
        }
    }

    fn figure(figure: &Formula) -> Written {
        let size = figure.without_minus();
        let negative = size.is_some();
        let formula = size.unwrap_or_else(|| figure.clone());
        // In a power, a number such as 2e-6 needs brackets.
        let number = formula.leading_number().filter(|_| formula.is_single());
        let precedence = match number {
            Some(number) if number.contains('e') => Precedence::Product,
            _ => Precedence::Alone,
        };
        Written {
            negative,
            formula,
            precedence,
        }
    }

    /// Returns the formula with its sign.
    fn signed(self) -> Formula {
        match self.negative {
            true => Formula::sign('-').then(self.formula),
            false => self.formula,
        }
    }

    /// Returns the formula without its sign, in brackets if it binds less strongly than `minimum`.
    fn bracketed(self, minimum: Precedence) -> Formula {
        match self.precedence < minimum {
            true => self.formula.in_brackets(),
            false => self.formula,
        }
    }

    /// Returns the formula as a factor, in brackets also if it is negative.
    fn factor(self, minimum: Precedence) -> Formula {
        match self.negative {
            true => self.signed().in_brackets(),
            false => self.bracketed(minimum),
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
        assert_eq!(
            beta.symbols().to_string(),
            "acos((m^2 + r3^2 - r4^2)/(2 m r3))"
        );
        assert_eq!(
            beta.numbers().to_string(),
            "acos((5^2 + 4^2 - 3^2)/(2·5·4))"
        );
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
            assert_eq!(expression.symbols().to_string(), symbols);
            assert_eq!(expression.numbers().to_string(), numbers);
            assert!((expression.value() - value).abs() < 1e-12, "{symbols}");
        }
    }

    #[test]
    fn terms_omit_zeros_and_factors_of_one() {
        let x = || Some(Expression::symbol("x"));
        for (figure, factor, expected) in [
            ("2", x(), Some("2·x")),
            ("-2", x(), Some("-2·x")),
            ("1", x(), Some("x")),
            ("-1", x(), Some("-x")),
            ("1", None, Some("1")),
            ("0", x(), None),
            ("0", None, None),
            ("-", None, Some("-")),
        ] {
            let term = Expression::term(figure.into(), factor);
            let numbers = term.map(|term| term.numbers().to_string());
            assert_eq!(numbers.as_deref(), expected, "{figure}");
        }
        assert_eq!(Expression::sum([]).symbols().to_string(), "0");
    }

    #[test]
    fn formula_is_evaluated_for_a_tried_unknown() {
        let [cos, _] = Expression::symbol("θ3").cos_and_sin();
        let function = known("m", 5.0) - known("r3", 3.0) * cos;
        assert_eq!(function.symbols().to_string(), "m - r3 cos(θ3)");
        assert_eq!((function.at(90.0), function.at(180.0)), (5.0, 8.0));
        assert!(function.value().is_nan());
    }
}
