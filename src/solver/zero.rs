//! The zero of a function between two places where its signs differ.

/// More evaluations than the method takes: it halves the interval at least every third time.
const MOST: usize = 200;
/// Decimals that a coordinate is tried at in the place of a zero that rounding has blurred.
const DECIMALS: f64 = 1e9;

/// The zero of `f` between `a` and `b`, each with its value, to `finest` or two units in the last
/// place. `None` where `f` does not exist on the way, or has the same sign at both.
///
/// Chandrupatla's method (Adv. Eng. Software 28, 1997): inverse quadratic interpolation where that
/// is safe, halving elsewhere.
pub(crate) fn zero(
    a: (f64, f64),
    b: (f64, f64),
    finest: f64,
    mut f: impl FnMut(f64) -> Option<f64>,
) -> Option<f64> {
    if a.1 == 0.0 || b.1 == 0.0 {
        return Some(if a.1 == 0.0 { a.0 } else { b.0 });
    }
    if !(a.1.signum() * b.1.signum() < 0.0) {
        return None;
    }
    let (mut new, mut other, mut share) = (b, a, 0.5);
    for _ in 0..MOST {
        let x = new.0 + share * (other.0 - new.0);
        let here = (x, f(x)?);
        let last = if (here.1 > 0.0) == (new.1 > 0.0) {
            new
        } else {
            std::mem::replace(&mut other, new)
        };
        new = here;
        let best = if new.1.abs() < other.1.abs() {
            new
        } else {
            other
        };
        let width = (other.0 - new.0).abs();
        let tolerance = finest.max(f64::EPSILON * best.0.abs());
        if best.1 == 0.0 || width <= 2.0 * tolerance {
            return rounded(best, &mut f);
        }
        let least = tolerance / width;
        share = interpolated(new, other, last).clamp(least, 1.0 - least);
    }
    None
}

/// The way from `new` to `other` on which the inverse parabola through three places has its zero;
/// half of it where the parabola is not to be trusted.
fn interpolated(new: (f64, f64), other: (f64, f64), last: (f64, f64)) -> f64 {
    let xi = (new.0 - other.0) / (last.0 - other.0);
    let phi = (new.1 - other.1) / (last.1 - other.1);
    let is_safe = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
    if !is_safe {
        return 0.5;
    }
    let [a, b, c] = [new.1, other.1, last.1];
    (a / (b - a)) * (c / (b - c))
        + (last.0 - new.0) / (other.0 - new.0) * (a / (c - a)) * (b / (c - b))
}

/// A zero lies somewhere within the rounding of `f`: of equally good places, the one that is
/// written with few decimals.
fn rounded(zero: (f64, f64), f: &mut impl FnMut(f64) -> Option<f64>) -> Option<f64> {
    let round = few_decimals(zero.0);
    let is_as_good = (round - zero.0).abs() < 1.0 / DECIMALS
        && f(round).is_some_and(|v| v.abs() <= zero.1.abs());
    Some(if is_as_good { round } else { zero.0 })
}

/// The nearest coordinate that is written with few decimals.
pub(super) fn few_decimals(at: f64) -> f64 {
    (at * DECIMALS).round() / DECIMALS
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(a: f64, b: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
        zero((a, f(a)), (b, f(b)), f64::MIN_POSITIVE, |x| Some(f(x)))
    }

    #[test]
    fn finds_zeros_to_the_last_digit_in_few_evaluations() {
        let count = std::cell::Cell::new(0);
        let cubed = |x: f64| {
            count.set(count.get() + 1);
            x * x * x - 2.0
        };
        let found = of(0.0, 5.0, cubed).unwrap();
        assert!(
            (found - 2.0_f64.cbrt()).abs() <= 2.0 * f64::EPSILON,
            "{found}"
        );
        assert!(count.get() < 20, "{}", count.get());
    }

    #[test]
    fn finds_steep_zeros_and_those_at_an_end() {
        // As a rate beside a limit: a square root, with a pole of the derivative at the end.
        let found = of(0.0, 1.0, |x| x.sqrt() - 1e-3).unwrap();
        assert!((found - 1e-6).abs() < 1e-19, "{found:e}");
        assert_eq!(of(0.0, 1.0, |x| x), Some(0.0));
        assert_eq!(of(1.0, 2.0, |x| x), None);
    }

    #[test]
    fn a_blurred_zero_is_a_round_one() {
        assert_eq!(of(-1.0, 0.7, |x| (x - 0.25) * 1e-300), Some(0.25));
        assert_eq!(of(-1.0, 0.7, f64::sin), Some(0.0));
    }

    #[test]
    fn what_does_not_exist_has_no_zero() {
        assert_eq!(zero((0.0, -1.0), (1.0, 1.0), 1e-9, |_| None), None);
        assert_eq!(zero((0.0, f64::NAN), (1.0, 1.0), 1e-9, Some), None);
    }
}
