//! The driver's coordinates of a sweep.
//!
//! Row k of a sweep is at the double closest to the exact decimal `from + k * step`, so that the
//! tenth row of a sweep by 0.1 is 1 and not 0.9999999999999999. So the ends and the step are stored
//! as written decimals.

use crate::scene::with_point;
use crate::wording::words;
use std::fmt::Write;
use std::str::FromStr;
use thiserror::Error;

/// Maximum number of rows of a sweep: 10^9 already take hundreds of gigabytes.
pub const MAX_ROWS: u64 = 1_000_000_000;

/// Integers up to this size are exact doubles.
const EXACT_INTEGER: i128 = 1 << 53;
/// The largest power of ten that is an exact double.
const EXACT_TEN: u32 = 22;

/// A finite decimal number as written, with a point or a comma.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrittenDecimal {
    value: f64,
    /// The exact number is `digits * 10^exponent`; `None` if it needs more than 38 digits.
    exact: Option<(i128, i32)>,
}

/// The reason why a text is not a [`WrittenDecimal`].
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecimalError {
    /// The text is not a number.
    #[error("{}", words().not_a_decimal())]
    Syntax,
    /// The decimal mark is ambiguous, as in `1,500`.
    #[error("{}", words().digits_without_groups())]
    TwoMarks,
    /// The number is NaN, infinite, or too large for a double.
    #[error("{}", words().decimal_not_finite())]
    NotFinite,
}

impl WrittenDecimal {
    /// Returns the nearest double.
    #[must_use]
    pub fn value(self) -> f64 {
        self.value
    }

    /// Returns the shortest decimal that represents this double; `None` if it is not finite.
    #[must_use]
    pub fn of(value: f64) -> Option<WrittenDecimal> {
        format!("{value:e}").parse().ok()
    }

    /// Returns the number in units of `10^exponent`, if it is an integer that fits.
    fn counted_in(self, exponent: i32) -> Option<i128> {
        let (digits, own) = self.exact?;
        let shift = u32::try_from(own.checked_sub(exponent)?).ok()?;
        if digits == 0 {
            return Some(0);
        }
        digits.checked_mul(10_i128.checked_pow(shift)?)
    }
}

impl FromStr for WrittenDecimal {
    type Err = DecimalError;

    fn from_str(text: &str) -> Result<Self, DecimalError> {
        let text = with_point(text).ok_or(DecimalError::TwoMarks)?;
        let value: f64 = text.parse().map_err(|_| DecimalError::Syntax)?;
        if !value.is_finite() {
            return Err(DecimalError::NotFinite);
        }
        let exact = exact(&text);
        Ok(WrittenDecimal { value, exact })
    }
}

/// Returns the digits and the power of ten of a text that is a finite number; `None` if they do not
/// fit.
fn exact(text: &str) -> Option<(i128, i32)> {
    let (mantissa, power) = match text.split_once(['e', 'E']) {
        Some((mantissa, power)) => (mantissa, power.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let fraction = fraction.trim_end_matches('0');
    let places = i32::try_from(fraction.len()).ok()?;
    let digits: i128 = format!("{whole}{fraction}").parse().ok()?;
    if digits == 0 {
        return Some((0, 0));
    }
    Some((digits, power.checked_sub(places)?))
}

/// The reason why a sweep is invalid.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum StepsError {
    /// The step is 0.
    #[error("{}", words().step_is_zero())]
    Zero,
    /// The step leads away from the end.
    #[error("{}", words().step_leads_away(*step, *from, *to, -step))]
    Away {
        /// The start of the sweep.
        from: f64,
        /// The requested end.
        to: f64,
        /// The step.
        step: f64,
    },
    /// The sweep has more rows than [`MAX_ROWS`].
    #[error("{}", words().sweep_too_long(*from, *to, *step))]
    TooMany {
        /// The start of the sweep.
        from: f64,
        /// The end of the sweep.
        to: f64,
        /// The step.
        step: f64,
    },
}

/// The driver's coordinates of a sweep, including both ends if the steps reach them.
#[derive(Clone, Debug)]
pub struct Steps {
    kind: StepsKind,
    count: u64,
    /// A last coordinate that the steps do not reach.
    end: Option<f64>,
}

#[derive(Clone, Debug)]
enum StepsKind {
    /// `from + k * step` in units of `10^exponent`, exactly.
    Exact {
        from: i128,
        step: i128,
        exponent: i32,
    },
    /// Numbers that need more than 38 digits together: doubles, rounded once.
    Fused { from: f64, step: f64 },
}

impl Steps {
    /// Creates the coordinates `from`, `from + step`, ... up to `to`, which is included if the
    /// steps reach it.
    ///
    /// # Errors
    /// Returns an error for a step of 0, a step away from `to`, or more than 10^9 rows.
    pub fn new(
        from: WrittenDecimal,
        to: WrittenDecimal,
        step: WrittenDecimal,
    ) -> Result<Steps, StepsError> {
        let (a, b, s) = (from.value, to.value, step.value);
        if s == 0.0 {
            return Err(StepsError::Zero);
        }
        if a != b && (b > a) != (s > 0.0) {
            let (from, to, step) = (a, b, s);
            return Err(StepsError::Away { from, to, step });
        }
        let (kind, last) = match counted(from, to, step) {
            Some((from, to, step, exponent)) => {
                let kind = StepsKind::Exact {
                    from,
                    step,
                    exponent,
                };
                (kind, to.checked_sub(from).map(|path| path / step))
            }
            None => (StepsKind::Fused { from: a, step: s }, fused_last(a, b, s)),
        };
        let count = last.and_then(|last| u64::try_from(last).ok()?.checked_add(1));
        match count {
            Some(count) if count <= MAX_ROWS => Ok(Steps {
                kind,
                count,
                end: None,
            }),
            _ => Err(StepsError::TooMany {
                from: a,
                to: b,
                step: s,
            }),
        }
    }

    /// Adds a last row at `end` itself if the steps do not reach it.
    #[must_use]
    pub fn ending_on(mut self, end: f64) -> Steps {
        let last = self.coordinate(self.count - 1, &mut String::new());
        self.end = (last != end).then_some(end);
        self
    }

    /// Returns the number of rows.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count + u64::from(self.end.is_some())
    }

    /// Returns the coordinates in order. Allocates once, not per row.
    pub fn iter(&self) -> impl Iterator<Item = f64> {
        let mut text = String::with_capacity(64);
        (0..self.count)
            .map(move |k| self.coordinate(k, &mut text))
            .chain(self.end)
    }

    fn coordinate(&self, k: u64, text: &mut String) -> f64 {
        match self.kind {
            StepsKind::Exact {
                from,
                step,
                exponent,
            } => nearest(from + i128::from(k) * step, exponent, text),
            #[expect(clippy::cast_precision_loss, reason = "at most 10^9 rows")]
            StepsKind::Fused { from, step } => step.mul_add(k as f64, from),
        }
    }
}

/// Returns all three numbers in units of a common power of ten, which comes last; `None` if they do
/// not fit.
fn counted(
    from: WrittenDecimal,
    to: WrittenDecimal,
    step: WrittenDecimal,
) -> Option<(i128, i128, i128, i32)> {
    let exponent = from.exact?.1.min(to.exact?.1).min(step.exact?.1);
    let in_units = |d: WrittenDecimal| d.counted_in(exponent);
    let (from, to, step) = (in_units(from)?, in_units(to)?, in_units(step)?);
    // Guards the division by the step; a step of 0 was already rejected.
    (step != 0).then_some((from, to, step, exponent))
}

/// Returns the number of whole steps from `from` to `to`.
#[expect(
    clippy::cast_possible_truncation,
    reason = "anything above 10^9 is refused, and the cast saturates"
)]
fn fused_last(from: f64, to: f64, step: f64) -> Option<i128> {
    let steps = (to - from) / step;
    // The quotient may have been rounded up to an integer; the last row would then exceed the end.
    let last = steps.floor();
    let beyond = step.mul_add(last, from) - to;
    let last = if beyond * step > 0.0 {
        last - 1.0
    } else {
        last
    };
    last.is_finite().then_some(last as i128)
}

/// Returns the double nearest to `digits * 10^exponent`.
fn nearest(digits: i128, exponent: i32, text: &mut String) -> f64 {
    // Two exact doubles and one rounding (Clinger 1990, the fast path).
    if digits.abs() <= EXACT_INTEGER && exponent.unsigned_abs() <= EXACT_TEN {
        #[expect(clippy::cast_precision_loss, reason = "at most 2^53")]
        let digits = digits as f64;
        #[expect(clippy::cast_precision_loss, reason = "exact up to 10^22")]
        let ten = 10_i128.pow(exponent.unsigned_abs()) as f64;
        return if exponent < 0 {
            digits / ten
        } else {
            digits * ten
        };
    }
    text.clear();
    // Writing to a string does not fail, and the parser of the standard library rounds correctly.
    let written = write!(text, "{digits}e{exponent}");
    debug_assert!(written.is_ok());
    text.parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn decimal(text: &str) -> WrittenDecimal {
        text.parse().unwrap()
    }

    fn steps(from: &str, to: &str, step: &str) -> Result<Steps, StepsError> {
        Steps::new(decimal(from), decimal(to), decimal(step))
    }

    fn rows(from: &str, to: &str, step: &str) -> Vec<f64> {
        steps(from, to, step).unwrap().iter().collect()
    }

    #[test]
    fn tenths_are_nearest_doubles_and_include_end() {
        let rows = rows("0", "360", "0.1");
        assert_eq!(rows.len(), 3601);
        for (k, row) in rows.iter().enumerate() {
            let text = format!("{}.{}", k / 10, k % 10);
            assert_eq!(*row, text.parse::<f64>().unwrap());
        }
    }

    #[test]
    fn steps_accept_signs_exponents_and_single_rows() {
        assert_eq!(rows("-10", "10", "10"), [-10.0, 0.0, 10.0]);
        assert_eq!(rows("10", "-10", "-10"), [10.0, 0.0, -10.0]);
        assert_eq!(rows("0", "1", "0.3"), [0.0, 0.3, 0.6, 0.9]);
        assert_eq!(rows("60", "60", "1"), [60.0]);
        assert_eq!(rows("60", "60.0", "-1e-3"), [60.0]);
        assert_eq!(rows("1e2", ".2e3", "+5E1"), [100.0, 150.0, 200.0]);
    }

    #[test]
    fn end_off_the_grid_can_have_its_own_row() {
        let ends = |step| {
            let steps = steps("0", "1", step).unwrap().ending_on(1.0);
            assert_eq!(steps.count() as usize, steps.iter().count());
            steps.iter().collect::<Vec<_>>()
        };
        assert_eq!(ends("0.4"), [0.0, 0.4, 0.8, 1.0]);
        assert_eq!(ends("0.5"), [0.0, 0.5, 1.0]);
    }

    #[test]
    fn sweep_rejects_zero_opposite_and_tiny_steps() {
        assert_eq!(steps("0", "1", "0").unwrap_err(), StepsError::Zero);
        assert_eq!(steps("0", "1", "1e-999").unwrap_err(), StepsError::Zero);
        let away = steps("0", "1", "-0.5").unwrap_err();
        assert_eq!(
            away.to_string(),
            "a step of -0.5 does not lead from 0 to 1: use 0.5"
        );
        let full = steps("1", "1e9", "1").unwrap();
        assert_eq!(full.count(), 1_000_000_000);
        for (from, to, step) in [
            ("0", "1e9", "1"),
            ("0", "360", "1e-300"),
            ("-1e300", "1e300", "1"),
        ] {
            let refused = steps(from, to, step).unwrap_err();
            assert!(matches!(refused, StepsError::TooMany { .. }), "{refused}");
        }
    }

    #[test]
    fn decimals_must_be_finite_and_well_formed() {
        for text in ["", "x", "60deg", "--1", "0x10"] {
            assert_eq!(
                text.parse::<WrittenDecimal>(),
                Err(DecimalError::Syntax),
                "{text}"
            );
        }
        for text in ["1,500", "1,5,5", "1.5,5"] {
            assert_eq!(text.parse::<WrittenDecimal>(), Err(DecimalError::TwoMarks));
        }
        assert_eq!("1,5".parse::<WrittenDecimal>(), "1.50".parse());
        for text in ["nan", "inf", "-Infinity", "1e400"] {
            assert_eq!(text.parse::<WrittenDecimal>(), Err(DecimalError::NotFinite));
        }
    }

    #[test]
    fn overlong_numbers_use_fused_multiply_add() {
        let rows = rows("1e25", "1.5e25", "1e24");
        assert_eq!(rows.len(), 6);
        let wide = steps("1e-30", "3", "1").unwrap();
        assert_eq!(wide.iter().collect::<Vec<_>>(), [1e-30, 1.0, 2.0]);
        let long = steps("0.1234567890123456789012345678901234567890123", "2", "1").unwrap();
        assert_eq!(
            long.iter().collect::<Vec<_>>(),
            [0.123_456_789_012_345_68, 1.123_456_789_012_345_7]
        );
    }

    proptest! {
        #[test]
        fn first_row_equals_start(bits: u64, step in 1..900_i32) {
            let low = f64::from_bits(bits);
            prop_assume!(low.is_finite() && low.abs() < 1e12);
            let from = WrittenDecimal::of(low).unwrap();
            let step = decimal(&format!("{step}e-1"));
            let to = WrittenDecimal::of(low + 100.0).unwrap();
            let rows: Vec<f64> = Steps::new(from, to, step).unwrap().iter().collect();
            prop_assert_eq!(rows[0], low);
            prop_assert!(*rows.last().unwrap() <= low + 100.0);
        }

        #[test]
        fn every_row_is_nearest_double(from in -1_000_000_i64..1_000_000, step in 1..100_000_i64, places in 0..30_u32, k in 0..2_000_u64) {
            let at = |n: i64| format!("{n}e-{places}");
            let to = from + step * 2_000;
            let steps = Steps::new(decimal(&at(from)), decimal(&at(to)), decimal(&at(step))).unwrap();
            prop_assert_eq!(steps.count(), 2_001);
            let row = steps.iter().nth(usize::try_from(k).unwrap()).unwrap();
            let exact = at(from + step * i64::try_from(k).unwrap());
            prop_assert_eq!(row, exact.parse::<f64>().unwrap());
        }
    }
}
