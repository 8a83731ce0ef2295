//! Converts typed numbers, with or without a unit, to the text stored in a scene file.
//!
//! The conversion from another unit is exact in decimals (of radians, to 23 digits) and rounded
//! once, to the nearest double. The result is written with the fewest digits that identify it:
//! `12 in` become `304.8` mm, `30cm` become `300`.

use crate::expression::{self, FormulaError};
use crate::scene::Unit;
use crate::scene::numbers::measure::{Measure, MeasureUnits};
use crate::scene::numbers::numeral::{number_length, with_point};
use crate::scene::numbers::rate;
use crate::scene::values::{Value, quoted};
use crate::wording::words;
use std::fmt;

/// The reason why a typed text is not a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ValueError {
    /// The text does not begin with a number.
    NoNumber {
        /// The typed text.
        typed: String,
        /// The supported units.
        units: Vec<&'static str>,
    },
    /// The decimal mark is ambiguous: both a point and a comma, or a comma that could separate
    /// thousands.
    TwoMarks {
        /// The typed text.
        typed: String,
    },
    /// The unit is unknown or measures another quantity.
    Unit {
        /// The text after the number.
        unit: String,
        /// The supported units.
        units: Vec<&'static str>,
    },
    /// The formula cannot be evaluated.
    Formula {
        /// The reason, as a sentence.
        why: String,
    },
    /// The number is too large for a double.
    TooLarge {
        /// The typed text.
        typed: String,
    },
}

impl fmt::Display for ValueError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ValueError::NoNumber { typed, units } => {
                f.write_str(&words().no_number_typed(typed, &units.join(", ")))
            }
            ValueError::TwoMarks { typed } => f.write_str(&words().typed_two_marks(typed)),
            ValueError::Unit { unit, units } => {
                f.write_str(&words().unit_does_not_fit(unit, &units.join(", ")))
            }
            ValueError::Formula { why } => f.write_str(why),
            ValueError::TooLarge { typed } => f.write_str(&words().typed_too_large(typed)),
        }
    }
}

impl std::error::Error for ValueError {}

impl Value {
    /// Returns the text to store for a typed one: a number in the value's own unit or with a unit,
    /// or a formula. A comma is read as decimal point if it is unambiguous.
    ///
    /// # Errors
    /// Returns an error if the text is not a number, its unit measures another quantity, or its
    /// formula cannot be evaluated.
    pub fn typed(&self, typed: &str) -> Result<String, ValueError> {
        let typed = typed.trim();
        self.typed_number(typed)
            .or_else(|why| match self.typed_formula(typed) {
                Some(Ok(formula)) => Ok(formula),
                Some(Err(why)) => Err(ValueError::Formula { why }),
                None => Err(why),
            })
    }

    /// Returns the text to store for a formula, or a message why it cannot be evaluated. Returns
    /// `None` if the text is not a formula.
    fn typed_formula(&self, typed: &str) -> Option<Result<String, String>> {
        let is_parameter = self.measure == Measure::Parameter;
        let (head, unit) = match self.measure.units(self.scene) {
            MeasureUnits::Rate(kind, degree) => {
                let split = rate::formula(typed, kind, degree);
                split.unwrap_or((typed, self.unit))
            }
            _ => (typed, ""),
        };
        // A number and a unit may be typed without a blank, as in every other field.
        let spaced = expression::glued(head).map(|(number, unit)| format!("{number} {unit}"));
        let head = spaced.as_deref().unwrap_or(head);
        let tree = match expression::parse(head) {
            Ok(tree) => tree,
            Err(fault) => {
                let help = fault.help.clone().or_else(|| self.named.product(head));
                let fault = FormulaError { help, ..fault };
                return self
                    .is_probably_formula(head)
                    .then(|| Err(placed(&fault, head)));
            }
        };
        let is_number = match is_parameter {
            true => head.parse::<f64>().is_ok(),
            false => tree.is_number(),
        };
        // Without named parameters, a word is not a formula.
        let is_word = tree.is_name() && self.named.worth.is_empty();
        if is_number || is_word {
            return None;
        }
        let found = self.named.evaluate_text(head);
        let found = found.map_err(|fault| fault.words());
        Some(found.map(|_| match unit {
            "" => quoted(head),
            unit => format!("{head} {unit}"),
        }))
    }

    /// Returns `true` if an unreadable text was probably meant as a formula, rather than as a word
    /// or a number with an unsuitable unit.
    fn is_probably_formula(&self, typed: &str) -> bool {
        let (number, rest) = typed.split_at(number_length(typed));
        let rest = rest.trim();
        let has_sign = |text: &str| text.contains(['+', '-', '*', '(', ')']);
        // Powers and quotients inside a unit do not indicate a formula.
        let is_cut = rest.starts_with(['/', '^']) || rest.ends_with(['/', '^']);
        let is_listed = number.is_empty() && rest.contains([' ', '/', '^']);
        let is_parameter = self.measure == Measure::Parameter && !rest.is_empty();
        is_parameter || has_sign(rest) || is_cut || is_listed || self.named.worth.contains_key(rest)
    }

    /// Returns the text to store for a number with or without a unit.
    pub(crate) fn typed_number(&self, typed: &str) -> Result<String, ValueError> {
        let Some(text) = with_point(typed) else {
            let typed = typed.to_owned();
            return Err(ValueError::TwoMarks { typed });
        };
        let (number, unit) = text.split_at(number_length(&text));
        let unit = expression::plain_unit(unit);
        let unit = unit.as_ref();
        let Ok(plain) = number.parse::<f64>() else {
            return Err(self.no_number(typed));
        };
        if unit.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return Err(self.no_number(typed));
        }
        let written = if let MeasureUnits::Rate(kind, degree) = self.measure.units(self.scene) {
            let unit = if unit.is_empty() { self.unit } else { unit };
            let known = rate::known(kind, degree, unit);
            known.map(|unit| (plain, format!("{} {unit}", shortest(plain))))
        } else {
            let number = if unit.is_empty() || same(unit, self.unit) {
                Some(plain)
            } else {
                self.converted(number, plain, unit)
            };
            number.map(|number| (number, shortest(number)))
        };
        match written {
            Some((number, text)) if number.is_finite() => Ok(text),
            Some(_) => Err(ValueError::TooLarge {
                typed: typed.to_owned(),
            }),
            None => Err(ValueError::Unit {
                unit: unit.to_owned(),
                units: self.units(),
            }),
        }
    }

    /// Returns the text to store for this value moved by a number of steps in its own unit. Rounding
    /// adds no decimals beyond those of the value and one step.
    #[must_use]
    pub fn moved(&self, steps: f64, step: f64) -> String {
        let sum = self.number + steps * step;
        let decimals = decimals(self.number).max(decimals(step));
        let sum = format!("{sum:.decimals$}").parse().unwrap_or(sum);
        self.written(&shortest(sum))
    }

    fn no_number(&self, typed: &str) -> ValueError {
        ValueError::NoNumber {
            typed: typed.to_owned(),
            units: self.units(),
        }
    }

    /// Returns the units that may be typed, the file's own first.
    #[must_use]
    pub fn units(&self) -> Vec<&'static str> {
        let all: Vec<&'static str> = match self.measure.units(self.scene) {
            MeasureUnits::Length => Unit::ALL.map(Unit::symbol).to_vec(),
            MeasureUnits::Angle => vec!["deg", "rad"],
            MeasureUnits::Rate(kind, degree) => rate::units(kind, degree).to_vec(),
            MeasureUnits::Scales(scales) => scales.iter().map(|(unit, ..)| *unit).collect(),
        };
        let others = all.into_iter().filter(|&unit| unit != self.unit);
        let all = std::iter::once(self.unit).chain(others);
        // A plain number has an empty unit.
        all.filter(|unit| !unit.is_empty()).collect()
    }

    /// Converts a number from another unit to the file's; returns `None` if the unit does not fit.
    fn converted(&self, number: &str, plain: f64, unit: &str) -> Option<f64> {
        match self.measure.units(self.scene) {
            MeasureUnits::Length => {
                let typed = Unit::ALL.into_iter().find(|u| u.symbol() == unit)?;
                let [times, of] = [typed, self.scene].map(Unit::whole_tenths_of_mm);
                Some(scaled(number, plain, times, of))
            }
            MeasureUnits::Angle => {
                let degrees = degrees(number);
                (unit == "rad").then(|| degrees.unwrap_or(plain.to_degrees()))
            }
            MeasureUnits::Scales(scales) => {
                let (_, times, of) = scales.iter().find(|(known, ..)| same(known, unit))?;
                Some(scaled(number, plain, *times, *of))
            }
            // Rates keep the unit that was typed.
            MeasureUnits::Rate(..) => None,
        }
    }
}

/// Returns the message of a fault in a formula, with its position unless it is at the end.
fn placed(fault: &FormulaError, formula: &str) -> String {
    let before = formula.get(..fault.span.start).unwrap_or(formula);
    match before.trim_end().len() == formula.trim_end().len() {
        true => fault.words(),
        false => words().at_character(before.chars().count() + 1, &fault.words()),
    }
}

/// Returns `true` if two units differ only in blanks.
fn same(one: &str, other: &str) -> bool {
    let plain = |c: &char| *c != ' ';
    one.chars().filter(plain).eq(other.chars().filter(plain))
}

/// One radian in degrees, 180/pi, to 23 digits. The product with the typed digits is exact before
/// it is rounded.
const RADIAN: (u128, i64) = (57_295_779_513_082_320_876_798, -21);

/// Returns the double nearest to `number * times / of`.
fn scaled(number: &str, plain: f64, times: u32, of: u32) -> f64 {
    exactly(number, times, of).unwrap_or(plain * f64::from(times) / f64::from(of))
}

/// Returns the double nearest to `number * times / of`, computed in decimals; `None` if there are
/// too many digits.
fn exactly(number: &str, times: u32, of: u32) -> Option<f64> {
    let TypedDecimal {
        sign,
        digits,
        mut exponent,
    } = TypedDecimal::of(number)?;
    let (mut product, of) = (digits.checked_mul(times.into())?, u128::from(of));
    // Extend the product by decimal digits until the division is exact or the integer is full.
    while product % of != 0 {
        let Some(longer) = product.checked_mul(10) else {
            break;
        };
        product = longer;
        exponent -= 1;
    }
    let quotient = product / of;
    // The quotient has more than 30 digits; one further digit decides the rounding of ties.
    let (rest, shift) = if product % of == 0 { ("", 0) } else { ("1", 1) };
    format!("{sign}{quotient}{rest}e{}", exponent - shift)
        .parse()
        .ok()
}

/// Converts radians to the nearest double in degrees; returns `None` if there are too many digits.
fn degrees(number: &str) -> Option<f64> {
    let TypedDecimal {
        sign,
        digits,
        exponent,
    } = TypedDecimal::of(number)?;
    let product = digits.checked_mul(RADIAN.0)?;
    format!("{sign}{product}e{}", exponent + RADIAN.1)
        .parse()
        .ok()
}

/// A decimal number as typed: `digits` times ten to the power of `exponent`.
struct TypedDecimal {
    sign: &'static str,
    digits: u128,
    exponent: i64,
}

impl TypedDecimal {
    fn of(number: &str) -> Option<TypedDecimal> {
        let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
        let sign = if mantissa.starts_with('-') { "-" } else { "" };
        let mantissa = mantissa.trim_start_matches(['+', '-']);
        let (text, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let exponent: i64 = exponent.parse().ok()?;
        Some(TypedDecimal {
            sign,
            digits: format!("{text}{fraction}").parse().ok()?,
            // Clamped, so that adding a few digits cannot overflow.
            exponent: (exponent.clamp(-MAX_TOTAL_POWER, MAX_TOTAL_POWER))
                .checked_sub(i64::try_from(fraction.len()).ok()?)?,
        })
    }
}

/// Beyond these powers of ten every number is zero or infinite, however many digits precede.
const MAX_TOTAL_POWER: i64 = 1_000_000_000;

/// Formats a double with the fewest digits that identify it, in a form that TOML can read.
fn shortest(number: f64) -> String {
    // Adding 0.0 removes the sign of a negative zero.
    let text = format!("{:?}", number + 0.0);
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

/// Returns the number of decimals of a number written in full.
fn decimals(number: f64) -> usize {
    let text = number.to_string();
    text.split_once('.')
        .map_or(0, |(_, fraction)| fraction.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    const TEXT: &str = "unit = \"mm\"\ngravity = [0, -9.81]\n[ground]\nA = [0, 0]\nD = [400, 0]\n[driver]\n\
        link = \"r2\"\nangle = 60\nspeed = \"15 rad/s\"\n[links]\n\
        r2 = { from = \"A\", to = \"B\", length = 100, com = [50, 0], mass = 1, inertia = 2 }\n\
        r3 = { from = \"B\", to = \"C\", length = 300 }\nr4 = { from = \"C\", to = \"D\", length = 250 }\n\
        [start]\nC = [310, 230]\n[[loads]]\nlink = \"r4\"\ntorque = 1\n[[loads]]\npoint = \"C\"\nforce = [1, 2]\nover = [[0, 1], [9, 0]]\n\
        [[springs]]\nfrom = \"A\"\nto = \"C\"\nstiffness = 100\nlength = 20\ndamping = 3\n";

    fn value_in(text: &str, name: &str) -> Value {
        let values = Scene::parse(text, "test").unwrap().values();
        values.into_iter().find(|v| v.name == name).unwrap()
    }

    fn typed(name: &str, text: &str) -> String {
        value_in(TEXT, name).typed(text).unwrap()
    }

    #[test]
    fn typed_values_are_converted_to_shortest_decimal() {
        for (text, expected) in [
            ("100.5", "100.5"),
            ("100,5", "100.5"),
            (" 100.50 mm", "100.5"),
            ("12 in", "304.8"),
            ("1.1in", "27.94"),
            ("0.3 m", "300"),
            ("30cm", "300"),
            (".7 in", "17.78"),
            ("1e2", "100"),
            ("1e-3 m", "1"),
            ("-0", "0"),
            ("1e17", "1e17"),
            ("0.1", "0.1"),
        ] {
            assert_eq!(typed("r2 length", text), expected, "{text}");
        }
        let inches = TEXT.replace("\"mm\"", "\"in\"");
        let value = value_in(&inches, "r2 length");
        assert_eq!(value.typed("25.4 mm").unwrap(), "1");
        assert_eq!(value.typed("1 cm").unwrap().parse(), Ok(100.0 / 254.0));
    }

    #[test]
    fn typed_accepts_units_of_every_measure() {
        for (name, text, expected) in [
            ("driver angle", "90 deg", "90"),
            ("driver angle", "1.2 rad", "68.75493541569878"),
            ("driver speed", "143,2 rpm", "143.2 rpm"),
            ("driver speed", "12", "12 rad/s"),
            ("driver speed", "90deg/s", "90 deg/s"),
            ("r2 mass", "350 g", "0.35"),
            ("r2 inertia", "12 kg mm^2", "0.000012"),
            ("r4 torque", "12 Nm", "12"),
            ("r4 torque", "5 N mm", "0.005"),
            ("C force y", "-1.2kN", "-1200"),
            ("gravity y", "-9810 mm/s^2", "-9.81"),
            ("spring A-C stiffness", "1.2 N/mm", "1200"),
            ("spring A-C stiffness", "3kN/m", "3000"),
            ("spring A-C length", "2 cm", "20"),
            ("spring A-C damping", "0.5 N s/mm", "500"),
            ("spring A-C damping", "7 Ns/m", "7"),
            ("C force knot 2 at", "1 rad", "57.29577951308232"),
            ("C force knot 2 factor", "12.5 %", "0.125"),
            ("C force knot 2 factor", "-0.5", "-0.5"),
        ] {
            let found = typed(name, text);
            assert_eq!(found.parse::<f64>(), expected.parse::<f64>(), "{text}");
            assert!(found.len() <= expected.len(), "{found}");
        }
    }

    #[test]
    fn typed_rejects_bad_input_with_a_hint() {
        let refused =
            |name: &str, text: &str| value_in(TEXT, name).typed(text).unwrap_err().to_string();
        assert_eq!(
            refused("r2 length", "long"),
            "not a number: long; type one, plain or in mm, cm, m, in"
        );
        assert_eq!(
            refused("r2 length", "12 kg"),
            "kg does not fit here: mm, cm, m, in"
        );
        assert_eq!(
            refused("driver speed", "12 mm/s"),
            "mm/s does not fit here: rad/s, deg/s, rpm"
        );
        assert_eq!(
            refused("C force knot 1 factor", "2 N"),
            "N does not fit here: %"
        );
        assert_eq!(
            refused("r2 length", "1,500"),
            "1,500: leave out the thousands separator: 1234.5 or 1234,5"
        );
        for (typed, why) in [
            (
                "2 *",
                "the formula ends, but a number, a name or a bracket must follow",
            ),
            ("2 * (3 + 4", "the formula ends, but `)` must follow"),
            (
                "2 * ) 3",
                "character 5: expected a number, a name or a bracket, found `)`",
            ),
            (
                "sqrt(4) 5",
                "character 9: expected `+`, `-`, `*`, `/`, `^` or the end, found `5`",
            ),
            (
                "sqr(4)",
                "character 1: unknown function `sqr`; did you mean `sqrt`?",
            ),
            ("10 kg mm^2", "kg mm^2 does not fit here: mm, cm, m, in"),
        ] {
            assert!(
                refused("r2 length", typed).starts_with(why),
                "{typed}: {}",
                refused("r2 length", typed)
            );
        }
        for wrong in [
            "", "nan", "inf", "1,2,3", "1 2", "1,000.5", "1,000", "--1", "1e400", "-",
        ] {
            assert!(value_in(TEXT, "r2 length").typed(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn moved_adds_no_extra_decimals() {
        let moved_by = |literal: &str, steps: f64, step: f64| {
            let text = TEXT.replace("length = 100", &format!("length = {literal}"));
            value_in(&text, "r2 length").moved(steps, step)
        };
        let moved = |literal: &str, step: f64| moved_by(literal, 1.0, step);
        assert_eq!(moved("100.1", 0.2), "100.3");
        assert_eq!(moved("0.1", 0.2), "0.3");
        assert_eq!(moved("99.9", 0.1), "100");
        assert_eq!(moved_by("1_00", -1.0, 1.0), "99");
        assert_eq!(moved("1e-7", 1e-9), "1.01e-7");
        assert_eq!(moved("1e73", 1e72), "1.1e73");
        let speed = value_in(TEXT, "driver speed");
        assert_eq!(speed.moved(1.0, 0.5), "15.5 rad/s");
        // Products of steps and a decimal step have more digits than either.
        for steps in 1..400_i32 {
            let exact = format!("{}.{}", 12 + steps / 10, steps % 10);
            let exact = exact.trim_end_matches('0').trim_end_matches('.');
            assert_eq!(moved_by("12", f64::from(steps), 0.1), exact, "{steps}");
        }
    }

    /// The expected values were computed with 60 digits. Products of doubles differ in the last
    /// digit.
    #[test]
    fn radians_are_rounded_once() {
        for (text, expected) in [
            ("1.2 rad", "68.75493541569878"),
            ("0.1 rad", "5.729577951308232"),
            ("0.7 rad", "40.10704565915763"),
            ("1.1 rad", "63.02535746439055"),
            ("1.3 rad", "74.48451336700701"),
            ("1.9 rad", "108.86198107485642"),
            ("2.2 rad", "126.0507149287811"),
        ] {
            assert_eq!(typed("driver angle", text), expected, "{text}");
        }
    }

    #[test]
    fn conversions_are_rounded_once() {
        // By the definition of the inch, in exact integers: n tenths of an inch are 254 n hundredths
        // of a millimetre.
        for n in 0..5000_u32 {
            let typed = format!("{}.{} in", n / 10, n % 10);
            let exact = format!("{}.{:02}", 254 * n / 100, 254 * n % 100);
            let found = value_in(TEXT, "r2 length").typed(&typed).unwrap();
            assert_eq!(found.parse::<f64>(), exact.parse(), "{typed}");
        }
    }
}
