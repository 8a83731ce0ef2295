//! Computes round ticks along an axis and formats their labels.

/// Steps that divide a turn, in degrees; smaller steps are decimal.
const ANGLES: [f64; 7] = [15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0];
/// Exponents of ten that suffice for every range of doubles.
const POWERS: std::ops::RangeInclusive<i32> = -320..=308;

/// Multiples of a round step along an axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Ticks {
    /// The values, from the low end.
    pub(super) values: Vec<f64>,
    /// The number format.
    pub(super) style: TickStyle,
}

impl Ticks {
    /// Returns the multiples from `low` to `high` of the smallest round step with at most `most`
    /// multiples. Round steps are 1, 2 or 5 times a power of ten; for angles also 15, 30, 45, 60,
    /// 90 degrees and more. Returns no ticks for a range that is too small for doubles.
    pub(super) fn between(low: f64, high: f64, is_angle: bool, maximum: usize) -> Ticks {
        let none = Ticks {
            values: Vec::new(),
            style: TickStyle::of_ticks(0.0, 1.0),
        };
        let size = high - low;
        let largest = low.abs().max(high.abs());
        // Doubles do not resolve multiples of smaller ranges.
        let is_some = size > largest * MIN_PART && size.is_finite();
        if !is_some || maximum == 0 {
            return none;
        }
        let few = |step: &f64| count(low, high, *step) <= maximum as f64;
        let Some(step) = steps(size / maximum as f64, is_angle).find(few) else {
            return none;
        };
        let first = multiple((low / step).ceil(), (low / step).round(), low / step);
        let values = (0..maximum).map(|k| (first + k as f64) * step);
        let end = high + step * MULTIPLE_TOLERANCE;
        // Far from 0 a multiple may round by more than the slack, out of the axis.
        let inside = |v: f64| v.clamp(low, high);
        let values: Vec<f64> = values.take_while(|&v| v <= end).map(inside).collect();
        Ticks {
            values,
            style: TickStyle::of_ticks(largest, step),
        }
    }

    /// Returns `count` multiples of a step, beginning at multiple number `first`.
    pub(super) fn multiples(step: f64, first: i64, count: i64) -> Ticks {
        let values: Vec<f64> = (first..first + count).map(|k| k as f64 * step).collect();
        let largest = values
            .iter()
            .fold(0.0, |largest: f64, v| largest.max(v.abs()));
        Ticks {
            values,
            style: TickStyle::of_ticks(largest, step),
        }
    }

    pub(super) fn labels(&self) -> impl Iterator<Item = (f64, String)> + '_ {
        self.values.iter().map(|&v| (v, self.style.text(v)))
    }

    /// Returns the number of characters of the longest label.
    pub(super) fn widest(&self) -> usize {
        self.labels().map(|(_, l)| l.len()).max().unwrap_or(0)
    }
}

/// The range below which an axis has no ticks, relative to its values.
const MIN_PART: f64 = 1e-13;

/// Tolerance, in steps, within which an end counts as a multiple.
const MULTIPLE_TOLERANCE: f64 = 1e-9;

/// Returns `near` if it equals the quotient up to rounding error, or else `inside`.
fn multiple(inside: f64, near: f64, quotient: f64) -> f64 {
    if (near - quotient).abs() <= MULTIPLE_TOLERANCE {
        near
    } else {
        inside
    }
}

/// Returns the number of multiples from `low` to `high`.
fn count(low: f64, high: f64, step: f64) -> f64 {
    let first = multiple((low / step).ceil(), (low / step).round(), low / step);
    let last = multiple((high / step).floor(), (high / step).round(), high / step);
    last - first + 1.0
}

/// Returns round steps in ascending order, from below `least` on.
pub(super) fn steps(minimum: f64, is_angle: bool) -> impl Iterator<Item = f64> {
    let power = minimum.log10().floor().clamp(-320.0, 308.0) as i32;
    // Degrees have steps of their own above 5.
    let end = if is_angle { 0 } else { *POWERS.end() };
    let powers = (power - 1).max(*POWERS.start())..=end;
    let decimal = powers.flat_map(|power| [1, 2, 5].map(|n| format!("{n}e{power}")));
    let decimal = decimal.filter_map(|step| step.parse::<f64>().ok());
    let decimal = decimal.filter(move |&s| s > 0.0 && s.is_finite() && !(is_angle && s > 5.0));
    let doubled = (1..64).map(|k| 360.0 * f64::from(k).exp2());
    let angles = ANGLES.into_iter().chain(doubled);
    decimal.chain(angles.filter(move |&s| is_angle && s >= minimum / 2.0))
}

/// The number format of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TickStyle {
    /// Fixed-point, with this number of decimals.
    Fixed(usize),
    /// Exponent notation, down to the digit of this power of ten.
    Exponent(i32),
}

/// Numbers from `LARGE` and below `SMALL` have exponents.
const LARGE: f64 = 1e6;
const SMALL: f64 = 1e-4;
/// Maximum number of significant digits of a value.
const DIGITS: i32 = 5;
/// Number of significant digits of the part that differs between values.
const CHANGING: i32 = 4;
/// Maximum number of decimals.
const MAX_DECIMALS: i32 = 14;
/// The relative change below which a value counts as constant.
const MIN_CHANGE: f64 = 1e-12;

impl TickStyle {
    /// Chooses a format for multiples of a step up to a size.
    fn of_ticks(largest: f64, step: f64) -> TickStyle {
        let power = exponent(step);
        if largest >= LARGE || step < SMALL {
            return TickStyle::Exponent(power);
        }
        TickStyle::Fixed(usize::try_from(-power).unwrap_or(0))
    }

    /// Chooses a format for values between two ends.
    pub(super) fn of_range(low: f64, high: f64) -> TickStyle {
        let largest = low.abs().max(high.abs());
        if largest == 0.0 {
            return TickStyle::Fixed(0);
        }
        let change = Some(high - low).filter(|&c| c > largest * MIN_CHANGE);
        let digits = (DIGITS - 1) - exponent(largest);
        let digits = change.map_or(digits, |c| digits.max(CHANGING - 1 - exponent(c)));
        if !(SMALL..LARGE * 10.0).contains(&largest) {
            return TickStyle::Exponent(-digits);
        }
        TickStyle::Fixed(usize::try_from(digits.min(MAX_DECIMALS)).unwrap_or(0))
    }

    /// Formats a number; zero has no sign.
    pub(super) fn text(self, value: f64) -> String {
        let text = match self {
            TickStyle::Fixed(decimals) => format!("{value:.decimals$}"),
            TickStyle::Exponent(_) if value == 0.0 => "0".into(),
            TickStyle::Exponent(last) => {
                // A number rounded up to the next power of ten has one more digit.
                let shorter = exponential(value, last);
                let rounded = shorter.parse().unwrap_or(value);
                if exponent(rounded) > exponent(value) {
                    exponential(rounded, last)
                } else {
                    shorter
                }
            }
        };
        let is_nought = !text.contains(|c: char| ('1'..='9').contains(&c));
        match text.strip_prefix('-') {
            Some(plain) if is_nought => plain.to_owned(),
            Some(_) | None => text,
        }
    }
}

/// Formats a number in exponent notation, down to the digit of a power of ten.
fn exponential(value: f64, last: i32) -> String {
    let digits = usize::try_from(exponent(value) - last).unwrap_or(0);
    let digits = digits.min(17);
    format!("{value:.digits$e}")
}

/// Returns the exponent of ten of the first digit.
fn exponent(value: f64) -> i32 {
    let text = format!("{:e}", value.abs());
    let exponent = text.split_once('e').and_then(|(_, e)| e.parse().ok());
    exponent.unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn labels(low: f64, high: f64, is_angle: bool, maximum: usize) -> Vec<String> {
        let ticks = Ticks::between(low, high, is_angle, maximum);
        ticks.labels().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_of_usual_ranges_are_round() {
        assert_eq!(
            labels(0.0, 360.0, true, 9),
            ["0", "45", "90", "135", "180", "225", "270", "315", "360"]
        );
        assert_eq!(
            labels(0.0, 360.0, true, 5),
            ["0", "90", "180", "270", "360"]
        );
        assert_eq!(labels(-46.6, 46.6, true, 4), ["-30", "0", "30"]);
        assert_eq!(
            labels(-46.6, 46.6, true, 12),
            ["-45", "-30", "-15", "0", "15", "30", "45"]
        );
        assert_eq!(
            labels(0.0, 0.42, false, 5),
            ["0.0", "0.1", "0.2", "0.3", "0.4"]
        );
        assert_eq!(
            labels(-820.0, 1083.0, false, 4),
            ["-500", "0", "500", "1000"]
        );
        assert_eq!(
            labels(-1.2e6, 3.1e6, false, 5),
            ["-1e6", "0", "1e6", "2e6", "3e6"]
        );
        assert_eq!(labels(1.0, 1.0, false, 5), [""; 0]);
        assert_eq!(labels(f64::NAN, 1.0, false, 5), [""; 0]);
    }

    #[test]
    fn values_have_enough_digits_for_visible_changes() {
        let text = |low, high, value| TickStyle::of_range(low, high).text(value);
        assert_eq!(text(-820.0, 1083.0, -722.630_802), "-722.6");
        assert_eq!(text(0.0, 360.0, 60.0), "60.00");
        assert_eq!(text(-1e-17, 0.3, -1e-17), "0.00000");
        assert_eq!(text(0.0, 0.0, 0.0), "0");
        assert_eq!(text(1000.0, 1000.2, 1_000.123_456), "1000.1235");
        assert_eq!(text(-2.5e7, 2.5e7, 1_234_567.0), "1.235e6");
        assert_eq!(text(0.0, 2e-7, 1.5e-7), "1.5000e-7");
        // Every change that is visible in a curve is visible in the number.
        assert_eq!(text(100.0, 100.0 + 5e-9, 100.0 + 3e-9), "100.000000003000");
    }

    #[test]
    fn tick_labels_differ_on_tiny_ranges() {
        for (low, high) in [
            (100.0, 100.0 + 1e-9),
            (-100.0 - 2e-10, -100.0),
            (1.0, 1.0 + 5e-13),
        ] {
            let labels = labels(low, high, false, 9);
            assert!(labels.len() > 2, "{labels:?}");
            assert!(
                labels.windows(2).all(|pair| pair[0] != pair[1]),
                "{labels:?}"
            );
        }
        // Ten times 1e-6 is a little less than 1e-5.
        assert_eq!(
            labels(8e-6, 1.1e-5, false, 5),
            ["8e-6", "9e-6", "1.0e-5", "1.1e-5"]
        );
    }

    #[test]
    fn ticks_far_from_zero_stay_in_range() {
        let low = -450_234_668.079_885;
        let high = low + 10_f64.powf(-4.073_692_900_992_865);
        for maximum in 1..20 {
            let ticks = Ticks::between(low, high, false, maximum);
            assert!(ticks.values.iter().all(|v| (low..=high).contains(v)));
        }
    }

    proptest! {
        #[test]
        fn ticks_are_round_and_in_range(
            low in -1e9..1e9_f64,
            power in -9.0..9.0_f64,
            is_angle: bool,
            maximum in 1..20_usize,
        ) {
            let high = low + 10_f64.powf(power);
            let ticks = Ticks::between(low, high, is_angle, maximum);
            prop_assert!(ticks.values.len() <= maximum);
            let slack = (high - low) * 1e-6;
            prop_assert!(ticks.values.iter().all(|&v| low - slack <= v && v <= high + slack));
            // At least a fifth of the permitted ticks: angle steps are farther apart than decimal
            // ones.
            if maximum >= 5 && (high - low) > 1e-6 * low.abs() {
                prop_assert!(ticks.values.len() >= maximum / 5, "{ticks:?}");
            }
            for pair in ticks.values.windows(2) {
                let step = pair[1] - pair[0];
                // Far from 0, cancellation makes the difference of two ticks inaccurate.
                if step < 1e-6 * low.abs() {
                    continue;
                }
                let lead = step / 10_f64.powf(step.log10().floor());
                let decimal = [1.0, 2.0, 5.0, 10.0].iter().any(|n| (lead - n).abs() < 1e-3);
                let angle = is_angle && (step.rem_euclid(15.0).min(15.0 - step.rem_euclid(15.0))) < 1e-3;
                prop_assert!(decimal || angle, "{step}");
                let complete = pair[0] / step;
                prop_assert!((complete - complete.round()).abs() < 1e-3);
            }
        }

        #[test]
        fn any_number_is_formatted(value: f64, low: f64, high: f64) {
            let text = TickStyle::of_range(low.min(high), low.max(high)).text(value);
            prop_assert!(text.is_ascii() && !text.is_empty());
            for maximum in 0..9 {
                let _ = Ticks::between(low.min(high), low.max(high), false, maximum);
                let _ = Ticks::between(low.min(high), low.max(high), true, maximum);
            }
        }
    }
}
