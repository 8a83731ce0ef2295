//! What a formula of plain numbers is worth.

use super::dimension::METRE;
use super::evaluated::{Evaluated, MeasuredNumber};
use super::tree::{ExpressionTree, MathFunction, Node, Operation, WrittenUnit};
use super::{Dimension, LengthScale, Malformed};
use crate::Double;
use crate::arithmetic::Decimal;
use crate::wording::words;
use std::ops::Range;

/// pi, to twice the digits.
const PI: Double = Double {
    hi: std::f64::consts::PI,
    lo: 1.224_646_799_147_353_2e-16,
};

/// What a name is worth; else what would mend it.
pub(crate) type NamedWorth<'e> = &'e dyn Fn(&str) -> Result<MeasuredNumber, Option<String>>;

/// Works a formula out. Units are converted: lengths to `length`, angles to degrees, all else to that of metres.
///
/// # Errors
/// What is wrong first.
pub(crate) fn evaluate(
    text: &str,
    tree: &ExpressionTree,
    length: LengthScale,
    names: NamedWorth<'_>,
) -> Result<Evaluated, Malformed> {
    let evaluator = Evaluator {
        text,
        length,
        names,
    };
    let found = evaluator.worth(tree)?;
    Ok(found.settled())
}

/// What a tree needs beside itself.
struct Evaluator<'e> {
    text: &'e str,
    length: LengthScale,
    names: NamedWorth<'e>,
}

impl Evaluator<'_> {
    /// What a part is worth: a finite figure.
    fn worth(&self, tree: &ExpressionTree) -> Result<Evaluated, Malformed> {
        let found = match &tree.node {
            Node::Number(number, unit) => self.number(*number, unit.as_ref()),
            Node::Name(name) if name == "pi" => Evaluated::rounded(PI, 0.0),
            Node::Name(name) => self.named(name, tree)?,
            Node::Negative(of) => self.worth(of)?.negative(),
            Node::Pair(operation, sides) => self.pair(*operation, sides)?,
            Node::Power(of, exponent) => self.power(of, *exponent, tree)?,
            Node::Call(function, given) => self.call(*function, given, tree)?,
        };
        let is_finite = found.value.hi.is_finite() && found.value.lo.is_finite();
        match is_finite {
            true => Ok(found),
            false => Err(self.nothing(tree)),
        }
    }

    fn quoted(&self, tree: &ExpressionTree) -> &str {
        self.text.get(tree.span.clone()).unwrap_or("")
    }

    /// The fault of a part that no number is.
    fn nothing(&self, tree: &ExpressionTree) -> Malformed {
        let message = words().has_no_worth(self.quoted(tree));
        Malformed::new(tree.span.clone(), message)
    }

    fn number(&self, number: f64, unit: Option<&WrittenUnit>) -> Evaluated {
        let decimal = Decimal::of(number);
        let plain = match decimal.is_double {
            true => Evaluated::of(decimal.value, 0.0),
            false => Evaluated::rounded(decimal.value, 0.0),
        };
        let Some(unit) = unit else {
            return plain;
        };
        let of_scene = match unit.dimension == Dimension::LENGTH {
            true => self.length.tenths_of_mm,
            false => METRE,
        };
        let mut found = plain;
        for &(tenths, power) in &unit.lengths {
            let (times, over) = match power > 0 {
                true => (tenths, of_scene),
                false => (of_scene, tenths),
            };
            for _ in 0..power.unsigned_abs() {
                let product = found.times(Evaluated::exactly(times));
                found = product.over(Evaluated::exactly(over));
            }
        }
        let degrees = Evaluated::rounded(Double::DEGREES, 0.0);
        let is_angle = unit.dimension == Dimension::RADIANS;
        let turned = unit.degrees - i8::from(is_angle);
        for _ in 0..turned.unsigned_abs() {
            found = match turned > 0 {
                true => found.over(degrees),
                false => found.times(degrees),
            };
        }
        found.measuring(match unit.dimension {
            Dimension::NUMBER => None,
            Dimension::RADIANS => Some(Dimension::DEGREES),
            Dimension::LENGTH => Some(Dimension::LENGTH),
            other => Some(other.in_metres()),
        })
    }

    fn named(&self, name: &str, tree: &ExpressionTree) -> Result<Evaluated, Malformed> {
        let found = (self.names)(name);
        let found = found.map(|MeasuredNumber { value, dimension }| {
            Evaluated::rounded(value, 0.0).measuring(dimension)
        });
        found.map_err(|help| Malformed {
            help,
            ..Malformed::new(tree.span.clone(), words().no_parameter(name))
        })
    }

    fn pair(
        &self,
        operation: Operation,
        sides: &[ExpressionTree; 2],
    ) -> Result<Evaluated, Malformed> {
        let [left, right] = sides;
        let (a, b) = (self.worth(left)?, self.worth(right)?);
        let measures = |found: Evaluated, dimension| Ok(found.measuring(dimension));
        match operation {
            Operation::Add => measures(a.plus(b), self.alike((a, left), (b, right))?),
            Operation::Subtract => {
                let difference = a.plus(b.negative());
                measures(difference, self.alike((a, left), (b, right))?)
            }
            Operation::Multiply => match (a.dimension, b.dimension) {
                (Some(_), Some(_)) => {
                    Err(self.of_units(&of_both(sides), |product| words().units_multiplied(product)))
                }
                (one, other) => measures(a.times(b), one.or(other)),
            },
            Operation::Divide => {
                if b.size() == 0.0 {
                    return Err(self.by_nothing(right));
                }
                let dimension = match (a.dimension, b.dimension) {
                    (_, None) => a.dimension,
                    (Some(one), Some(other)) if are_alike(one, other) => None,
                    _ => {
                        return Err(self.of_units(&of_both(sides), |quotient| {
                            words().units_divided(quotient)
                        }));
                    }
                };
                measures(a.over(b), dimension)
            }
        }
    }

    /// The fault of what is divided by.
    fn by_nothing(&self, tree: &ExpressionTree) -> Malformed {
        let message = words().divided_by_nothing(self.quoted(tree));
        Malformed::new(tree.span.clone(), message)
    }

    /// What two figures measure that are added or compared.
    fn alike(
        &self,
        one: (Evaluated, &ExpressionTree),
        other: (Evaluated, &ExpressionTree),
    ) -> Result<Option<Dimension>, Malformed> {
        match (one.0.dimension, other.0.dimension) {
            (Some(a), Some(b)) if !are_alike(a, b) => Err(self.apart(one, other)),
            (a, b) => Ok(a.or(b)),
        }
    }

    /// The fault of figures that do not go together.
    fn apart(
        &self,
        one: (Evaluated, &ExpressionTree),
        other: (Evaluated, &ExpressionTree),
    ) -> Malformed {
        let span = one.1.span.start..other.1.span.end;
        let told = |(found, tree): (Evaluated, &ExpressionTree)| {
            let dimension = found.dimension.unwrap_or(Dimension::NUMBER);
            words().measured_in(self.quoted(tree), &dimension.symbol(self.length.symbol))
        };
        let message = words().do_not_go_together(&told(one), &told(other));
        Malformed::new(span, message).help(words().units_stand_alone())
    }

    /// The fault of units that are multiplied or divided.
    fn of_units(&self, span: &Range<usize>, told: impl Fn(&str) -> String) -> Malformed {
        let message = told(self.text.get(span.clone()).unwrap_or(""));
        Malformed::new(span.clone(), message).help(words().units_divide_their_like())
    }

    /// A plain number: what it measures is lost on what follows.
    fn plain(&self, tree: &ExpressionTree, function: &str) -> Result<Evaluated, Malformed> {
        let found = self.worth(tree)?;
        match found.dimension {
            None => Ok(found),
            Some(dimension) => {
                let unit = dimension.symbol(self.length.symbol);
                let message = words().takes_a_number(function, &unit);
                Err(Malformed::new(tree.span.clone(), message))
            }
        }
    }

    fn power(
        &self,
        of: &ExpressionTree,
        exponent: i8,
        tree: &ExpressionTree,
    ) -> Result<Evaluated, Malformed> {
        let base = self.worth(of)?;
        if base.dimension.is_some() {
            return Err(self.of_units(&tree.span, |power| words().units_multiplied(power)));
        }
        let factors = std::iter::repeat_n(base, exponent.unsigned_abs().into());
        let power = factors.fold(Evaluated::exactly(1.0), Evaluated::times);
        match exponent < 0 {
            false => Ok(power),
            true if power.size() == 0.0 => Err(self.by_nothing(of)),
            true => Ok(Evaluated::exactly(1.0).over(power)),
        }
    }

    fn call(
        &self,
        function: MathFunction,
        given: &[ExpressionTree],
        tree: &ExpressionTree,
    ) -> Result<Evaluated, Malformed> {
        let name = function.name();
        let Some(first) = given.first() else {
            return Err(self.nothing(tree));
        };
        match function {
            MathFunction::Sqrt => match self.plain(first, name)? {
                found if found.value.hi >= 0.0 => Ok(found.root()),
                _ => Err(self.nothing(tree)),
            },
            MathFunction::Abs => match self.worth(first)? {
                found if found.value.hi < 0.0 => Ok(found.negative()),
                found => Ok(found),
            },
            MathFunction::Min => self.fold(given, |a, b| match Evaluated::is_below(b, a) {
                true => b,
                false => a,
            }),
            MathFunction::Max => self.fold(given, |a, b| match Evaluated::is_below(a, b) {
                true => b,
                false => a,
            }),
            MathFunction::Hypot => self.fold(given, Evaluated::hypotenuse),
            MathFunction::Sin => Ok(self.angle(first, name)?.unit()[1]),
            MathFunction::Cos => Ok(self.angle(first, name)?.unit()[0]),
            MathFunction::Tan => {
                let [cosine, sine] = self.angle(first, name)?.unit();
                match cosine.size() == 0.0 {
                    true => Err(self.nothing(tree)),
                    false => Ok(sine.over(cosine)),
                }
            }
            MathFunction::Asin | MathFunction::Acos => {
                let part = self.plain(first, name)?;
                let one = Evaluated::exactly(1.0);
                let rest = one.plus(part.times(part).negative());
                if rest.value.hi < 0.0 {
                    return Err(self.nothing(tree));
                }
                Ok(match function {
                    MathFunction::Asin => Evaluated::direction(rest.root(), part),
                    _ => Evaluated::direction(part, rest.root()),
                })
            }
            MathFunction::Exp => {
                let power = self.plain(first, name)?.exponential();
                power.ok_or_else(|| self.nothing(tree))
            }
            MathFunction::Ln => {
                let logarithm = self.plain(first, name)?.logarithm(Double::ln);
                logarithm.ok_or_else(|| self.nothing(tree))
            }
            MathFunction::Log10 => {
                let logarithm = self.plain(first, name)?.logarithm(Double::log10);
                logarithm.ok_or_else(|| self.nothing(tree))
            }
            MathFunction::Atan2 => {
                let [y, x] = given else {
                    return Err(self.nothing(tree));
                };
                let (across, along) = (self.worth(y)?, self.worth(x)?);
                self.alike((across, y), (along, x))?;
                match across.size().max(along.size()) == 0.0 {
                    true => Err(self.nothing(tree)),
                    false => Ok(Evaluated::direction(along, across)),
                }
            }
        }
    }

    /// An angle in degrees, with its unit or without.
    fn angle(&self, tree: &ExpressionTree, function: &str) -> Result<Evaluated, Malformed> {
        let found = self.worth(tree)?;
        match found.dimension {
            Some(dimension) if !dimension.is_angle() => {
                let unit = dimension.symbol(self.length.symbol);
                let message = words().takes_an_angle(function, &unit);
                Err(Malformed::new(tree.span.clone(), message))
            }
            _ => Ok(found),
        }
    }

    /// One of several figures that measure the same, or what is made of them.
    fn fold(
        &self,
        given: &[ExpressionTree],
        join: impl Fn(Evaluated, Evaluated) -> Evaluated,
    ) -> Result<Evaluated, Malformed> {
        let mut all: Option<(Evaluated, &ExpressionTree)> = None;
        for tree in given {
            let found = self.worth(tree)?;
            all = Some(match all {
                None => (found, tree),
                Some((before, of)) => {
                    let dimension = self.alike((before, of), (found, tree))?;
                    (join(before, found).measuring(dimension), of)
                }
            });
        }
        Ok(all.map_or(Evaluated::exactly(0.0), |(found, _)| found))
    }
}

/// Where both sides of an operation stand.
fn of_both(sides: &[ExpressionTree; 2]) -> Range<usize> {
    sides[0].span.start..sides[1].span.end
}

/// Whether two units measure the same: degrees and radians do, plain numbers and angles do not.
fn are_alike(one: Dimension, other: Dimension) -> bool {
    one.adds_to(other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::parse;

    const INCH: LengthScale = LengthScale {
        symbol: "in",
        tenths_of_mm: 254.0,
    };

    fn names(name: &str) -> Result<MeasuredNumber, Option<String>> {
        let (value, dimension) = match name {
            "a" => (Double::exactly(100.0), None),
            "third" => (Double::ONE / Double::exactly(3.0), None),
            "rod" => (Double::exactly(10.0), Some(Dimension::LENGTH)),
            "lean" => (Double::exactly(30.0), Some(Dimension::DEGREES)),
            _ => return Err(None),
        };
        Ok(MeasuredNumber { value, dimension })
    }

    fn worth(text: &str) -> Result<f64, String> {
        let tree = parse(text).unwrap();
        let found = evaluate(text, &tree, INCH, &names);
        found
            .map(|found| found.value.hi)
            .map_err(|fault| fault.message)
    }

    /// Each of these decimals has one double; sums of doubles miss most of them.
    #[test]
    fn decimals_come_out_as_decimals() {
        for (text, decimal) in [
            ("0.1 + 0.2", 0.3),
            ("0.1 + 0.2 - 0.3", 0.0),
            ("2 * a + 5", 205.0),
            ("1.1 * 1.1", 1.21),
            ("4.35 * 100", 435.0),
            ("0.3 / 3", 0.1),
            ("3 * third", 1.0),
            ("third * 3 - 1", 0.0),
            ("1e15 + 0.1 - 1e15", 0.1),
            ("-0.7 ^ 2", -0.49),
            ("0.2 ^ -2", 25.0),
            ("0.09 ^ 1.5", 0.027),
            ("0 ^ 2.5", 0.0),
            ("4 ^ -0.5", 0.5),
            ("1024 ^ 0.3", 8.0),
            ("254 mm", 10.0),
            ("1 cm * 2.54", 1.0),
            ("sin(30)", 0.5),
            ("sin(30 deg) + cos(60)", 1.0),
            ("tan(45)", 1.0),
            ("cos(90)", 0.0),
            ("asin(0.5)", 30.0),
            ("acos(-0.5)", 120.0),
            ("acos(1)", 0.0),
            ("atan2(-1, -1)", -135.0),
            ("atan2(5 mm, 5 mm)", 45.0),
            ("sqrt(0.09)", 0.3),
            ("hypot(0.3, 0.4)", 0.5),
            ("hypot(3e200, 4e200)", 5e200),
            ("hypot(-3, 0)", 3.0),
            ("min(3, -2, 7) + max(3, 8) + abs(-4)", 10.0),
            ("pi - 2 * pi / 2", 0.0),
            ("1 rad - 180 / pi", 0.0),
            ("rod + 2.54 cm", 11.0),
            ("rod / 5 in + sin(lean)", 2.5),
            // All but lengths in metres, and of degrees only those that stand alone.
            ("5 N/mm + 1 N/m", 5001.0),
            ("1 N m/deg * pi - 180 N m", 0.0),
        ] {
            assert_eq!(worth(text), Ok(decimal), "{text}");
        }
    }

    /// The doubles next to what mpmath gives with 50 digits.
    #[test]
    fn what_is_no_decimal_is_the_nearest_double() {
        for (text, nearest) in [
            ("sqrt(2)", std::f64::consts::SQRT_2),
            ("2 ^ 1.5", 2.828_427_124_746_190_3),
            ("3 ^ -1.2", 0.267_580_520_586_743_6),
            ("sin(10)", 0.173_648_177_666_930_36),
            ("tan(89.9)", 572.957_213_354_287_8),
            ("acos(0.3)", 72.542_396_876_277_9),
            ("atan2(1, 3)", 18.434_948_822_922_01),
            ("hypot(1, 2, 3)", 3.741_657_386_773_941_3),
            ("1 cm + 2.54", 2.933_700_787_401_574_6),
            ("pi * a", 314.159_265_358_979_3),
        ] {
            assert_eq!(worth(text), Ok(nearest), "{text}");
        }
    }

    #[test]
    fn what_has_no_worth_says_why() {
        for (text, message) in [
            (
                "a / (0.1 + 0.2 - 0.3)",
                "`(0.1 + 0.2 - 0.3)` is 0, and nothing is divided by that",
            ),
            ("2 / 0", "`0` is 0, and nothing is divided by that"),
            ("0 ^ -1", "`0` is 0, and nothing is divided by that"),
            ("1 + sqrt(-1)", "`sqrt(-1)` is no number"),
            ("(0 - 2) ^ 1.2", "`(0 - 2)` is no number"),
            ("asin(1.01)", "`asin(1.01)` is no number"),
            ("atan2(0, 0)", "`atan2(0, 0)` is no number"),
            ("tan(90)", "`tan(90)` is no number"),
            ("1e200 * 1e200", "`1e200 * 1e200` is no number"),
            ("b + 1", "there is no parameter `b`"),
            (
                "5 mm + 3 deg",
                "`5 mm` is in inch and `3 deg` is in deg: these do not go together",
            ),
            (
                "5 mm * 2 mm",
                "`5 mm * 2 mm` multiplies one unit by another",
            ),
            ("(5 mm)^2", "`(5 mm)^2` multiplies one unit by another"),
            (
                "sqrt(4 mm)",
                "sqrt() takes a plain number, and this is in inch: divide it by a figure of that unit",
            ),
            ("sin(4 mm)", "sin() takes an angle, and this is in inch"),
        ] {
            assert_eq!(worth(text), Err(message.to_owned()), "{text}");
        }
    }
}
