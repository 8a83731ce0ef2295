//! The driver's coordinates of a sweep.
//!
//! Row k of a sweep stands at the double nearest to the exact decimal `from + k * step`, so that
//! the tenth row of a sweep by 0.1 is 1 and not 0.9999999999999999. The ends and the step are
//! therefore kept as the decimals that were written.

use crate::scene::with_point;
use crate::wording::words;
use std::fmt::Write;
use std::str::FromStr;
use thiserror::Error;

/// A sweep has no more rows than this: 10^9 are already hundreds of gigabytes.
pub const MOST_ROWS: u64 = 1_000_000_000;

/// Up to this size an integer is exactly a double.
const EXACT_INTEGER: i128 = 1 << 53;
/// The largest power of ten that is exactly a double.
const EXACT_TEN: u32 = 22;

/// A finite decimal number as it was written, with a point or a comma.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrittenDecimal {
    value: f64,
    /// `digits * 10^exponent` is the number; `None` where 38 digits do not hold it.
    exact: Option<(i128, i32)>,
}

/// Why a text is no [`WrittenDecimal`].
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecimalError {
    /// No number at all.
    #[error("{}", words().not_a_decimal())]
    Syntax,
    /// Nobody knows which mark is the decimal one, as in `1,500`.
    #[error("{}", words().digits_without_groups())]
    TwoMarks,
    /// NaN, infinity, or too large for a double.
    #[error("{}", words().decimal_not_finite())]
    NotFinite,
}

impl WrittenDecimal {
    /// The nearest double.
    #[must_use]
    pub fn value(self) -> f64 {
        self.value
    }

    /// The shortest decimal that stands for this double; `None` if it is not finite.
    #[must_use]
    pub fn of(value: f64) -> Option<WrittenDecimal> {
        format!("{value:e}").parse().ok()
    }

    /// The number in units of `10^exponent`, if it is a whole one that fits.
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

/// The digits and the power of ten of a text that is known to be a finite number.
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

/// Why a sweep is refused.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum StepsError {
    /// A step of 0.
    #[error("{}", words().step_is_zero())]
    Zero,
    /// The step leads away from the end.
    #[error("{}", words().step_leads_away(*step, *from, *to, -step))]
    Away {
        /// Where the sweep begins.
        from: f64,
        /// Where it should end.
        to: f64,
        /// The step.
        step: f64,
    },
    /// More rows than [`MOST_ROWS`].
    #[error("{}", words().sweep_too_long(*from, *to, *step))]
    TooMany {
        /// Where the sweep begins.
        from: f64,
        /// Where it ends.
        to: f64,
        /// The step.
        step: f64,
    },
}

/// The driver's coordinates of a sweep, both ends included where they are hit.
#[derive(Clone, Debug)]
pub struct Steps {
    kind: StepsKind,
    count: u64,
    /// A last coordinate that the step does not hit.
    end: Option<f64>,
}

#[derive(Clone, Debug)]
enum StepsKind {
    /// `from + k * step` in units of `10^exponent`: exact.
    Exact {
        from: i128,
        step: i128,
        exponent: i32,
    },
    /// Numbers that 38 digits do not hold together: one rounding of the doubles.
    Fused { from: f64, step: f64 },
}

impl Steps {
    /// The coordinates `from`, `from + step`, ... up to `to`, which is included where it is hit.
    ///
    /// # Errors
    /// A step of 0, one that leads away from `to`, or more than 10^9 rows.
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
                (kind, to.checked_sub(from).map(|way| way / step))
            }
            None => (StepsKind::Fused { from: a, step: s }, fused_last(a, b, s)),
        };
        let count = last.and_then(|last| u64::try_from(last).ok()?.checked_add(1));
        match count {
            Some(count) if count <= MOST_ROWS => Ok(Steps {
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

    /// The same, with a last row on `end` itself where the step does not hit it.
    #[must_use]
    pub fn ending_on(mut self, end: f64) -> Steps {
        let last = self.coordinate(self.count - 1, &mut String::new());
        self.end = (last != end).then_some(end);
        self
    }

    /// The number of rows.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count + u64::from(self.end.is_some())
    }

    /// The coordinates in their order. Allocates once, not per row.
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

/// All three in units of the same power of ten, which comes last.
fn counted(
    from: WrittenDecimal,
    to: WrittenDecimal,
    step: WrittenDecimal,
) -> Option<(i128, i128, i128, i32)> {
    let exponent = from.exact?.1.min(to.exact?.1).min(step.exact?.1);
    let in_units = |d: WrittenDecimal| d.counted_in(exponent);
    let (from, to, step) = (in_units(from)?, in_units(to)?, in_units(step)?);
    // A step that the text has and the double has not would be 0 here as well.
    (step != 0).then_some((from, to, step, exponent))
}

/// The number of whole steps from `from` to `to`.
#[expect(
    clippy::cast_possible_truncation,
    reason = "anything above 10^9 is refused, and the cast saturates"
)]
fn fused_last(from: f64, to: f64, step: f64) -> Option<i128> {
    let steps = (to - from) / step;
    // The quotient may have rounded up to a whole number that the last row would overshoot.
    let last = steps.floor();
    let beyond = step.mul_add(last, from) - to;
    let last = if beyond * step > 0.0 {
        last - 1.0
    } else {
        last
    };
    last.is_finite().then_some(last as i128)
}

/// The double nearest to `digits * 10^exponent`.
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
    fn tenths_are_the_nearest_doubles_and_the_end_is_hit() {
        let rows = rows("0", "360", "0.1");
        assert_eq!(rows.len(), 3601);
        for (k, row) in rows.iter().enumerate() {
            let text = format!("{}.{}", k / 10, k % 10);
            assert_eq!(*row, text.parse::<f64>().unwrap());
        }
    }

    #[test]
    fn ends_signs_and_single_rows() {
        assert_eq!(rows("-10", "10", "10"), [-10.0, 0.0, 10.0]);
        assert_eq!(rows("10", "-10", "-10"), [10.0, 0.0, -10.0]);
        assert_eq!(rows("0", "1", "0.3"), [0.0, 0.3, 0.6, 0.9]);
        assert_eq!(rows("60", "60", "1"), [60.0]);
        assert_eq!(rows("60", "60.0", "-1e-3"), [60.0]);
        assert_eq!(rows("1e2", ".2e3", "+5E1"), [100.0, 150.0, 200.0]);
    }

    #[test]
    fn an_end_that_is_not_hit_can_have_its_own_row() {
        let ends = |step| {
            let steps = steps("0", "1", step).unwrap().ending_on(1.0);
            assert_eq!(steps.count() as usize, steps.iter().count());
            steps.iter().collect::<Vec<_>>()
        };
        assert_eq!(ends("0.4"), [0.0, 0.4, 0.8, 1.0]);
        assert_eq!(ends("0.5"), [0.0, 0.5, 1.0]);
    }

    #[test]
    fn what_makes_no_sweep_is_refused() {
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
    fn what_is_no_finite_decimal_is_refused() {
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
    fn numbers_too_long_for_exact_sums_are_fused() {
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
        fn a_limit_is_its_own_first_row(bits: u64, step in 1..900_i32) {
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
        fn any_row_is_the_nearest_double(from in -1_000_000_i64..1_000_000, step in 1..100_000_i64, places in 0..30_u32, k in 0..2_000_u64) {
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
