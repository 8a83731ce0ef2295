//! Recovers the typed decimal from the double that it was read as.

use super::double::Double;

/// Number of decimal digits that always survive the conversion to a double and back.
const DIGITS: i32 = 15;
/// Powers of ten are exact doubles up to this exponent.
const EXACT_POWERS: i32 = 22;

/// A number as a decimal of up to 15 digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decimal {
    /// The value in double-double.
    pub value: Double,
    /// The number of double-double roundings in `value`.
    pub(crate) roundings: i32,
    /// Half a unit of the fifteenth digit.
    pub(crate) rounding: f64,
    /// `true` for 15 digits or more: such a number was probably rounded when it was typed.
    pub is_long: bool,
    /// `true` for 13 digits or more: such a number was probably rounded if others are long, and its
    /// last digits are zeros.
    pub(crate) is_nearly_long: bool,
    /// Whether the decimal is exactly a double, or has more than 15 digits and is taken as the
    /// double.
    pub is_double: bool,
}

impl Decimal {
    /// Returns the shortest decimal that is read as `value`, or the double itself if that has more
    /// than 15 digits.
    pub fn of(value: f64) -> Decimal {
        let exactly = Decimal {
            value: Double::exactly(value),
            roundings: 0,
            rounding: 0.0,
            is_long: value != 0.0,
            is_nearly_long: value != 0.0,
            is_double: value == 0.0,
        };
        let size = value.abs();
        // Negated so that NaN, infinities and numbers with fewer than 15 digits of precision are
        // returned as they are.
        if !(1e-290..1e290).contains(&size) {
            return exactly;
        }
        let first = size.log10().floor() as i32;
        let mut unit = first + 1 - DIGITS;
        let mut digits = times_power(exactly.value, -unit).nearest_integer();
        // The rounded logarithm can be off by one.
        if digits.abs() >= 1e15 {
            unit += 1;
            digits = times_power(exactly.value, -unit).nearest_integer();
        }
        let decimal = times_power(Double::exactly(digits), unit);
        let is_read_so = decimal.hi == value;
        Decimal {
            value: if is_read_so { decimal } else { exactly.value },
            roundings: if is_read_so && decimal.lo != 0.0 {
                1 + unit.abs() / EXACT_POWERS
            } else {
                0
            },
            rounding: 0.5 * times_power(Double::ONE, unit).hi,
            is_long: !is_read_so || digits % 10.0 != 0.0,
            is_nearly_long: !is_read_so || digits % 1000.0 != 0.0,
            is_double: !is_read_so || decimal.lo == 0.0,
        }
    }
}

impl Double {
    fn nearest_integer(self) -> f64 {
        let complete = self.hi.round();
        // Half-way cases may round either way: no decimal of 15 digits is one.
        complete + ((self.hi - complete) + self.lo).round()
    }
}

/// Multiplies by a power of ten, in double-double.
fn times_power(value: Double, power: i32) -> Double {
    let mut product = value;
    let mut left = power.abs();
    while left > 0 {
        let part = left.min(EXACT_POWERS);
        let ten = Double::exactly(10.0_f64.powi(part));
        product = if power > 0 {
            product * ten
        } else {
            product / ten
        };
        left -= part;
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_decimal_is_exactly_as_typed() {
        let sum = Decimal::of(0.1).value + Decimal::of(0.2).value;
        assert!((sum - Decimal::of(0.3).value).hi.abs() < 1e-31);
        for exact in [0.0, 1.0, -250.0, 0.625, 1e6 + 3.0] {
            assert_eq!(Decimal::of(exact).value, Double::exactly(exact));
            assert!(!Decimal::of(exact).is_long);
        }
        let tenth = Decimal::of(1e-17).value * Double::exactly(1e17);
        assert!((tenth - Double::ONE).hi.abs() < 1e-31);
    }

    #[test]
    fn long_number_is_its_nearest_double() {
        let long = 0.1 + 0.2;
        assert_eq!(Decimal::of(long).value, Double::exactly(long));
        assert!(Decimal::of(long).is_long);
        assert!((Decimal::of(long).rounding / 5e-16 - 1.0).abs() < 1e-12);
        let fifteen = Decimal::of(123.456789012345);
        assert!(fifteen.is_long && fifteen.value.lo != 0.0);
        assert!((fifteen.rounding / 5e-13 - 1.0).abs() < 1e-12);
    }

    /// The doubles nearest to the first two end with twenty zero bits, but do not equal these
    /// decimals.
    #[test]
    fn trailing_zero_bits_do_not_make_decimal_a_double() {
        for rounded in [9.47615610808134, 9.98348635993898, 0.1, 1e-9] {
            assert!(!Decimal::of(rounded).is_double, "{rounded}");
        }
        for exact in [250.0, 0.625, -1.25, 1e6 + 1.0, 0.1 + 0.2] {
            assert!(Decimal::of(exact).is_double, "{exact}");
        }
    }

    #[test]
    fn non_finite_and_subnormal_values_stay_unchanged() {
        assert!(Decimal::of(f64::NAN).value.hi.is_nan());
        assert_eq!(Decimal::of(f64::INFINITY).value.hi, f64::INFINITY);
        assert_eq!(Decimal::of(5e-324).value.hi, 5e-324);
    }
}
