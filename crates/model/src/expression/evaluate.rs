//! Evaluates formulas of plain numbers.

use super::dimension::METRE;
use super::elementary::{self, DEGREES, PI};
use super::tree::{ExpressionTree, MathFunction, Node, Operation, WrittenNumber, WrittenUnit};
use super::wide::Wide;
use super::{Dimension, FormulaError, LengthScale};
use crate::wording::words;
use std::ops::Range;

/// A number, and its dimension if it has a unit. Plain numbers are compatible with any dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredNumber {
    /// The value: lengths in the formula's unit, angles in degrees, everything else in units based on
    /// metres.
    pub(crate) value: Wide,
    pub dimension: Option<Dimension>,
}

impl MeasuredNumber {
    /// Creates a number without a unit.
    pub fn plain(value: Wide) -> MeasuredNumber {
        MeasuredNumber {
            value,
            dimension: None,
        }
    }

    /// Returns the nearest double.
    pub fn nearest(&self) -> f64 {
        self.value.nearest()
    }

    fn measuring(self, dimension: Option<Dimension>) -> MeasuredNumber {
        MeasuredNumber { dimension, ..self }
    }
}

/// A function that returns the value of a name, or a hint for an unknown name.
pub(crate) type NameLookupFn<'e> = &'e dyn Fn(&str) -> Result<MeasuredNumber, Option<String>>;

/// Evaluates a formula. Units are converted: lengths to `length`, angles to degrees, everything
/// else to units based on metres.
///
/// # Errors
/// The first fault, including a value that no double can represent or of which too few digits are
/// known.
pub(crate) fn evaluate(
    text: &str,
    tree: &ExpressionTree,
    length: LengthScale,
    names: NameLookupFn<'_>,
) -> Result<MeasuredNumber, FormulaError> {
    let evaluator = Evaluator {
        text,
        length,
        names,
    };
    let found = evaluator.evaluate_part(tree)?;
    let message = match found.nearest() {
        _ if !found.value.is_known() => words().has_no_worth(evaluator.quoted(tree)),
        nearest if nearest.is_infinite() => {
            words().number_too_large(&format!("`{}`", evaluator.quoted(tree)))
        }
        nearest if nearest == 0.0 && !found.value.is_zero() => {
            words().number_too_small(&format!("`{}`", evaluator.quoted(tree)))
        }
        _ => return Ok(found),
    };
    Err(FormulaError::new(tree.span.clone(), message))
}

/// The context for the evaluation of a tree.
struct Evaluator<'e> {
    text: &'e str,
    length: LengthScale,
    names: NameLookupFn<'e>,
}

impl Evaluator<'_> {
    /// Evaluates a part.
    fn evaluate_part(&self, tree: &ExpressionTree) -> Result<MeasuredNumber, FormulaError> {
        let MeasuredNumber { value, dimension } = match &tree.node {
            Node::Number(number, unit) => self.number(number, unit.as_ref(), tree)?,
            Node::Name(name) if name == "pi" => MeasuredNumber::plain(PI.clone()),
            Node::Name(name) => self.named(name, tree)?,
            Node::Negative(of) => {
                let MeasuredNumber { value, dimension } = self.evaluate_part(of)?;
                MeasuredNumber::plain(value.negative()).measuring(dimension)
            }
            Node::Pair(operation, sides) => self.pair(*operation, sides)?,
            Node::Power(of, exponent) => self.power(of, *exponent, tree)?,
            Node::Call(function, given) => self.call(*function, given, tree)?,
        };
        let value = value.settled();
        match value.is_in_range() {
            true => Ok(MeasuredNumber { value, dimension }),
            false => Err(self.no_value_fault(tree)),
        }
    }

    fn quoted(&self, tree: &ExpressionTree) -> &str {
        self.text.get(tree.span.clone()).unwrap_or("")
    }

    /// Returns the fault of a part without a numeric value.
    fn no_value_fault(&self, tree: &ExpressionTree) -> FormulaError {
        let message = words().has_no_worth(self.quoted(tree));
        FormulaError::new(tree.span.clone(), message)
    }

    fn number(
        &self,
        number: &WrittenNumber,
        unit: Option<&WrittenUnit>,
        tree: &ExpressionTree,
    ) -> Result<MeasuredNumber, FormulaError> {
        let mut found = Wide::decimal(&number.digits).ok_or_else(|| self.no_value_fault(tree))?;
        let Some(unit) = unit else {
            return Ok(MeasuredNumber::plain(found));
        };
        let of_scene = match unit.dimension == Dimension::LENGTH {
            true => self.length.tenths_of_mm,
            false => METRE,
        };
        for &(tenths, power) in &unit.lengths {
            let (times, over) = match power > 0 {
                true => (tenths, of_scene),
                false => (of_scene, tenths),
            };
            for _ in 0..power.unsigned_abs() {
                found = found
                    .times(&Wide::exactly(times))
                    .over(&Wide::exactly(over));
            }
        }
        let is_angle = unit.dimension == Dimension::RADIANS;
        let turned = unit.degrees - i8::from(is_angle);
        for _ in 0..turned.unsigned_abs() {
            found = match turned > 0 {
                true => found.over(&DEGREES),
                false => found.times(&DEGREES),
            };
        }
        let dimension = match unit.dimension {
            Dimension::NUMBER => None,
            Dimension::RADIANS => Some(Dimension::DEGREES),
            Dimension::LENGTH => Some(Dimension::LENGTH),
            other => Some(other.in_metres()),
        };
        Ok(MeasuredNumber::plain(found).measuring(dimension))
    }

    fn named(&self, name: &str, tree: &ExpressionTree) -> Result<MeasuredNumber, FormulaError> {
        (self.names)(name).map_err(|help| FormulaError {
            help,
            ..FormulaError::new(tree.span.clone(), words().no_parameter(name))
        })
    }

    fn pair(
        &self,
        operation: Operation,
        sides: &[ExpressionTree; 2],
    ) -> Result<MeasuredNumber, FormulaError> {
        let [left, right] = sides;
        let (a, b) = (self.evaluate_part(left)?, self.evaluate_part(right)?);
        let (value, dimension) = match operation {
            Operation::Add => {
                let dimension = self.alike((&a, left), (&b, right))?;
                (a.value.plus(&b.value), dimension)
            }
            Operation::Subtract => {
                let dimension = self.alike((&a, left), (&b, right))?;
                (a.value.minus(&b.value), dimension)
            }
            Operation::Multiply => match (a.dimension, b.dimension) {
                (Some(_), Some(_)) => {
                    return Err(
                        self.of_units(&of_both(sides), |product| words().units_multiplied(product))
                    );
                }
                (one, other) => (a.value.times(&b.value), one.or(other)),
            },
            Operation::Divide => {
                if b.value.is_zero() {
                    return Err(self.division_by_zero(right));
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
                (a.value.over(&b.value), dimension)
            }
        };
        Ok(MeasuredNumber { value, dimension })
    }

    /// Returns the fault of a division by zero.
    fn division_by_zero(&self, tree: &ExpressionTree) -> FormulaError {
        let message = words().divided_by_nothing(self.quoted(tree));
        FormulaError::new(tree.span.clone(), message)
    }

    /// Returns the common dimension of two added or compared values.
    fn alike(
        &self,
        one: (&MeasuredNumber, &ExpressionTree),
        other: (&MeasuredNumber, &ExpressionTree),
    ) -> Result<Option<Dimension>, FormulaError> {
        match (one.0.dimension, other.0.dimension) {
            (Some(a), Some(b)) if !are_alike(a, b) => Err(self.incompatible(one, other)),
            (a, b) => Ok(a.or(b)),
        }
    }

    /// Returns the fault of incompatible dimensions.
    fn incompatible(
        &self,
        one: (&MeasuredNumber, &ExpressionTree),
        other: (&MeasuredNumber, &ExpressionTree),
    ) -> FormulaError {
        let span = one.1.span.start..other.1.span.end;
        let text = |(found, tree): (&MeasuredNumber, &ExpressionTree)| {
            let dimension = found.dimension.unwrap_or(Dimension::NUMBER);
            words().measured_in(self.quoted(tree), &dimension.symbol(self.length.symbol))
        };
        let message = words().do_not_go_together(&text(one), &text(other));
        FormulaError::new(span, message).help(words().units_stand_alone())
    }

    /// Returns the fault of multiplied or divided units.
    fn of_units(&self, span: &Range<usize>, text: impl Fn(&str) -> String) -> FormulaError {
        let message = text(self.text.get(span.clone()).unwrap_or(""));
        FormulaError::new(span.clone(), message).help(words().units_divide_their_like())
    }

    /// Evaluates a part that must be a plain number.
    fn plain(&self, tree: &ExpressionTree, function: &str) -> Result<Wide, FormulaError> {
        let found = self.evaluate_part(tree)?;
        match found.dimension {
            None => Ok(found.value),
            Some(dimension) => {
                let unit = dimension.symbol(self.length.symbol);
                let message = words().takes_a_number(function, &unit);
                Err(FormulaError::new(tree.span.clone(), message))
            }
        }
    }

    fn power(
        &self,
        of: &ExpressionTree,
        exponent: i8,
        tree: &ExpressionTree,
    ) -> Result<MeasuredNumber, FormulaError> {
        let base = self.evaluate_part(of)?;
        if base.dimension.is_some() {
            return Err(self.of_units(&tree.span, |power| words().units_multiplied(power)));
        }
        let one = Wide::integer(1);
        let power = (0..exponent.unsigned_abs()).fold(one, |power, _| power.times(&base.value));
        let value = match exponent < 0 {
            false => power,
            true if base.value.is_zero() => return Err(self.division_by_zero(of)),
            true => Wide::integer(1).over(&power),
        };
        Ok(MeasuredNumber::plain(value))
    }

    fn call(
        &self,
        function: MathFunction,
        given: &[ExpressionTree],
        tree: &ExpressionTree,
    ) -> Result<MeasuredNumber, FormulaError> {
        let name = function.name();
        let Some(first) = given.first() else {
            return Err(self.no_value_fault(tree));
        };
        let value = match function {
            MathFunction::Sqrt => match self.plain(first, name)? {
                found if found.is_negative() => None,
                found => Some(found.root()),
            },
            MathFunction::Abs => {
                let found = self.evaluate_part(first)?;
                let value = found.value.size();
                return Ok(MeasuredNumber { value, ..found });
            }
            MathFunction::Min => return self.fold(given, lower_of),
            MathFunction::Max => {
                return self.fold(given, |a, b| {
                    lower_of(a.negative(), b.negative()).negative()
                });
            }
            MathFunction::Hypot => {
                return self.fold(given, |a, b| a.times(&a).plus(&b.times(&b)).root());
            }
            MathFunction::Sin => elementary::unit(&self.angle(first, name)?).map(|[_, sine]| sine),
            MathFunction::Cos => {
                elementary::unit(&self.angle(first, name)?).map(|[cosine, _]| cosine)
            }
            MathFunction::Tan => tangent(&self.angle(first, name)?),
            MathFunction::Asin | MathFunction::Acos => {
                let part = self.plain(first, name)?;
                let square = Wide::integer(1).minus(&part.times(&part)).settled();
                if square.is_negative() {
                    return Err(self.no_value_fault(tree));
                }
                let other = square.root();
                match function {
                    MathFunction::Asin => elementary::direction(&other, &part),
                    _ => elementary::direction(&part, &other),
                }
            }
            MathFunction::Exp => elementary::exponential(&self.plain(first, name)?),
            MathFunction::Ln => match self.plain(first, name)? {
                found if found.is_zero() || found.is_negative() => None,
                found => elementary::logarithm(&found),
            },
            MathFunction::Log10 => match self.plain(first, name)? {
                found if found.is_zero() || found.is_negative() => None,
                found => elementary::decimal_logarithm(&found),
            },
            MathFunction::Atan2 => {
                let [y, x] = given else {
                    return Err(self.no_value_fault(tree));
                };
                let (across, along) = (self.evaluate_part(y)?, self.evaluate_part(x)?);
                self.alike((&across, y), (&along, x))?;
                let is_zero = across.value.is_zero() && along.value.is_zero();
                match is_zero {
                    true => None,
                    false => elementary::direction(&along.value, &across.value),
                }
            }
        };
        let value = value.ok_or_else(|| self.no_value_fault(tree))?;
        Ok(MeasuredNumber::plain(value))
    }

    /// Evaluates an angle in degrees, with or without a unit.
    fn angle(&self, tree: &ExpressionTree, function: &str) -> Result<Wide, FormulaError> {
        let found = self.evaluate_part(tree)?;
        match found.dimension {
            Some(dimension) if !dimension.is_angle() => {
                let unit = dimension.symbol(self.length.symbol);
                let message = words().takes_an_angle(function, &unit);
                Err(FormulaError::new(tree.span.clone(), message))
            }
            _ => Ok(found.value),
        }
    }

    /// Combines several values of the same dimension.
    fn fold(
        &self,
        given: &[ExpressionTree],
        join: impl Fn(Wide, Wide) -> Wide,
    ) -> Result<MeasuredNumber, FormulaError> {
        let mut all: Option<(MeasuredNumber, &ExpressionTree)> = None;
        for tree in given {
            let found = self.evaluate_part(tree)?;
            all = Some(match all {
                None => (found, tree),
                Some((before, of)) => {
                    let dimension = self.alike((&before, of), (&found, tree))?;
                    let value = join(before.value, found.value).settled();
                    (MeasuredNumber { value, dimension }, of)
                }
            });
        }
        Ok(all.map_or(MeasuredNumber::plain(Wide::ZERO), |(found, _)| found))
    }
}

fn lower_of(a: Wide, b: Wide) -> Wide {
    match b.minus(&a).settled().is_negative() {
        true => b,
        false => a,
    }
}

/// Returns the tangent of an angle in degrees; `None` if its cosine is zero.
fn tangent(degrees: &Wide) -> Option<Wide> {
    let [cosine, sine] = elementary::unit(degrees)?.map(Wide::settled);
    (!cosine.is_zero()).then(|| sine.over(&cosine))
}

/// Returns the position of an operation with both operands.
fn of_both(sides: &[ExpressionTree; 2]) -> Range<usize> {
    sides[0].span.start..sides[1].span.end
}

/// Returns `true` if two units have the same dimension. Degrees and radians have, plain numbers and
/// angles have not.
fn are_alike(one: Dimension, other: Dimension) -> bool {
    one.adds_to(other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::parse;
    use num_bigint::{BigInt, BigUint, Sign};
    use proptest::prelude::*;

    const INCH: LengthScale = LengthScale {
        symbol: "in",
        tenths_of_mm: 254.0,
    };

    fn names(name: &str) -> Result<MeasuredNumber, Option<String>> {
        let (value, dimension) = match name {
            "a" => (Wide::integer(100), None),
            "third" => (Wide::integer(1).over(&Wide::integer(3)), None),
            "rod" => (Wide::integer(10), Some(Dimension::LENGTH)),
            "lean" => (Wide::integer(30), Some(Dimension::DEGREES)),
            _ => return Err(None),
        };
        Ok(MeasuredNumber { value, dimension })
    }

    fn evaluate_text(text: &str) -> Result<f64, String> {
        let tree = parse(text).unwrap();
        let found = evaluate(text, &tree, INCH, &names);
        found
            .map(|found| found.nearest())
            .map_err(|fault| fault.message)
    }

    /// Each result is a decimal with one nearest double. Sums of doubles miss most of them.
    #[test]
    fn decimal_formulas_evaluate_exactly() {
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
            // No intermediate result overflows, underflows or cancels.
            ("3e-308 / 3e-310", 100.0),
            ("1e-300 * 1e302", 100.0),
            ("1e305 / 1e303", 100.0),
            ("(1 + 1.5e-32 - 1) * 1e34", 150.0),
            ("1.1e-160 * 1.1e-160 * 1e300 * 1e22 / 1.21", 100.0),
            ("1e-320 * 1e300 * 1e22", 100.0),
            ("(1e308 + 1e-308 - 1e308) * 1e300 * 1e10", 100.0),
            ("(1e-300)^8 * 1e300^8", 1.0),
            ("(1e300)^-8 / 1e-300^8 * 2", 2.0),
            ("(1 / 3 - 0.3333333333333333) * 3e18", 100.0),
            ("0.3333333333333333 - 0.333333333333333", 3e-16),
            ("sqrt(1e-320) * 1e162", 100.0),
            ("hypot(3e-320, 4e-320) * 2e300 * 1e21", 100.0),
            ("hypot(3e300, 4e300) / 5e298", 100.0),
            ("(1 + exp(0 - 700) - 1) * exp(702)", 7.389_056_098_930_65),
            ("ln(1e-300) + ln(1e300)", 0.0),
            ("log10(1e-320) + log10(1e300 * 1e300)", 280.0),
            ("exp(ln(1e300 * 1e300) - ln(1e300 * 1e299))", 10.0),
            ("sin(1e-300) * 180e300 / pi", 1.0),
            // Regression test: a sine below 2^-1344 was 0.
            ("sin((1e-300)^8) / (1e-300)^8 * 180 / pi", 1.0),
            ("atan2(1e-320, 1e-320)", 45.0),
            ("atan2(1e300 * 1e300, 1e300 * 1e300)", 45.0),
            ("atan2(1e-160, 1e160) * 1e300 * 1e20 * pi / 180", 1.0),
            ("asin(1e-300) * pi * 1e300 / 180", 1.0),
            ("90 - acos(1e-20) - asin(1e-20)", 0.0),
            ("tan(90 - 1e-20) * pi / 180 * 1e-20", 1.0),
            ("sin(360e15 + 30)", 0.5),
            ("max(1e-320, 2e-320) * 1e300 * 1e20 / 2", 1.0),
            ("min(1e300 * 1e300, 1e300 * 1e299) / 1e300 / 1e299", 1.0),
            ("abs(0 - 1e-320) * 1e300 * 1e20", 1.0),
            ("pi - 2 * pi / 2", 0.0),
            ("1 rad - 180 / pi", 0.0),
            ("rod + 2.54 cm", 11.0),
            ("rod / 5 in + sin(lean)", 2.5),
            // Other units than lengths are based on metres. Only plain angles are in degrees.
            ("5 N/mm + 1 N/m", 5001.0),
            ("1 N m/deg * pi - 180 N m", 0.0),
        ] {
            assert_eq!(evaluate_text(text), Ok(decimal), "{text}");
        }
    }

    /// The expected doubles are nearest to results of mpmath with 50 digits.
    #[test]
    fn non_decimal_results_are_nearest_doubles() {
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
            assert_eq!(evaluate_text(text), Ok(nearest), "{text}");
        }
    }

    #[test]
    fn formula_without_value_explains_why() {
        for (text, message) in [
            (
                "a / (0.1 + 0.2 - 0.3)",
                "`(0.1 + 0.2 - 0.3)` is 0: division by zero",
            ),
            ("2 / 0", "`0` is 0: division by zero"),
            ("0 ^ -1", "`0` is 0: division by zero"),
            ("1 + sqrt(-1)", "`sqrt(-1)` has no value"),
            ("(0 - 2) ^ 1.2", "`(0 - 2)` has no value"),
            ("asin(1.01)", "`asin(1.01)` has no value"),
            ("atan2(0, 0)", "`atan2(0, 0)` has no value"),
            ("tan(90)", "`tan(90)` has no value"),
            ("1e200 * 1e200", "the number `1e200 * 1e200` is too large"),
            (
                "1e-200 * 1e-200",
                "the number `1e-200 * 1e-200` is too small",
            ),
            ("b + 1", "unknown parameter `b`"),
            (
                "5 mm + 3 deg",
                "`5 mm` is in `in` and `3 deg` is in deg: the units do not match",
            ),
            (
                "5 mm * 2 mm",
                "`5 mm * 2 mm` multiplies one unit by another",
            ),
            ("(5 mm)^2", "`(5 mm)^2` multiplies one unit by another"),
            (
                "sqrt(4 mm)",
                "sqrt() takes a plain number, but this is in `in`: divide it by a value of that unit",
            ),
            ("sin(4 mm)", "sin() takes an angle, but this is in `in`"),
        ] {
            assert_eq!(evaluate_text(text), Err(message.to_owned()), "{text}");
        }
    }

    /// A fraction of integers: the exact value of a formula of decimals.
    #[derive(Clone, Debug)]
    struct Fraction {
        above: BigInt,
        below: BigInt,
    }

    impl Fraction {
        fn new(above: BigInt, below: BigInt) -> Fraction {
            Fraction { above, below }
        }

        fn power_of_two(power: i32) -> Fraction {
            let size = BigInt::from(1) << power.unsigned_abs();
            match power < 0 {
                true => Fraction::new(1.into(), size),
                false => Fraction::new(size, 1.into()),
            }
        }

        /// Converts a double, exactly.
        fn of(value: f64) -> Fraction {
            let (bits, size) = (value.to_bits(), value.abs().to_bits());
            let power = i32::try_from(size >> 52).unwrap().max(1) - 1075;
            let digits = size & ((1 << 52) - 1) | if size >> 52 == 0 { 0 } else { 1 << 52 };
            let sign = if bits >> 63 == 1 { -1 } else { 1 };
            let scale = Fraction::power_of_two(power);
            Fraction::new(BigInt::from(digits) * sign * scale.above, scale.below)
        }

        fn apart(&self, other: &Fraction) -> Fraction {
            let above = &self.above * &other.below - &other.above * &self.below;
            Fraction::new(above, &self.below * &other.below)
        }

        fn size(&self) -> (BigUint, BigUint) {
            (
                self.above.magnitude().clone(),
                self.below.magnitude().clone(),
            )
        }

        fn exceeds(&self, other: &Fraction) -> bool {
            let ((a, b), (c, d)) = (self.size(), other.size());
            a * d > c * b
        }

        fn is_zero(&self) -> bool {
            self.above.sign() == Sign::NoSign
        }
    }

    /// Generates formulas with their exact values: decimals over the whole range of doubles, and sums,
    /// differences, products, quotients and powers of them.
    fn formulas() -> impl Strategy<Value = (String, Fraction)> {
        let decimal =
            (0_u64..=99_999_999_999_999_999, -323_i32..=290).prop_map(|(digits, power)| {
                let ten = BigInt::from(10).pow(power.unsigned_abs());
                let digits_of = BigInt::from(digits);
                let value = match power < 0 {
                    true => Fraction::new(digits_of, ten),
                    false => Fraction::new(digits_of * ten, 1.into()),
                };
                (format!("{digits}e{power}"), value)
            });
        let short = (1_u64..=999, -3_i32..=3).prop_map(|(digits, power)| {
            let ten = BigInt::from(10).pow(power.unsigned_abs());
            let value = match power < 0 {
                true => Fraction::new(digits.into(), ten),
                false => Fraction::new(BigInt::from(digits) * ten, 1.into()),
            };
            (format!("{digits}e{power}"), value)
        });
        prop_oneof![decimal, short].prop_recursive(4, 12, 2, |inner| {
            (inner.clone(), inner, 0_u8..5).prop_filter_map("divides by 0", |(a, b, kind)| {
                let ((a, x), (b, y)) = (a, b);
                Some(match kind {
                    0 => {
                        let above = &x.above * &y.below + &y.above * &x.below;
                        (
                            format!("({a} + {b})"),
                            Fraction::new(above, x.below * y.below),
                        )
                    }
                    1 => (format!("({a} - {b})"), x.apart(&y)),
                    2 => {
                        let value = Fraction::new(x.above * y.above, x.below * y.below);
                        (format!("({a} * {b})"), value)
                    }
                    3 if y.is_zero() => return None,
                    3 => {
                        let value = Fraction::new(x.above * &y.below, x.below * &y.above);
                        (format!("({a} / {b})"), value)
                    }
                    _ => {
                        let value = Fraction::new(x.above.pow(3), x.below.pow(3));
                        (format!("({a})^3"), value)
                    }
                })
            })
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        /// A result is within half an ulp of the exact one, or rejected because no double
        /// represents it.
        #[test]
        fn results_are_nearest_doubles_to_exact_fractions((text, exact) in formulas()) {
            let largest = Fraction::of(f64::MAX);
            let minimum = Fraction::power_of_two(-1074);
            match evaluate_text(&text) {
                Ok(found) => {
                    let off = Fraction::of(found).apart(&exact);
                    let ulp = (found.abs().next_up() - found.abs()).max(f64::from_bits(1));
                    let ulp = Fraction::of(ulp);
                    let two_off = Fraction::new(off.above * 2, off.below);
                    prop_assert!(!two_off.exceeds(&ulp), "{text} = {found:e}");
                }
                Err(message) => {
                    let is_beyond = exact.exceeds(&largest);
                    let is_lost = !exact.is_zero() && minimum.exceeds(&exact);
                    // A literal may be too small itself.
                    let is_refused = message.contains("too small") || message.contains("too large");
                    prop_assert!(is_beyond || is_lost || is_refused, "{text}: {message}");
                }
            }
        }
    }
}
