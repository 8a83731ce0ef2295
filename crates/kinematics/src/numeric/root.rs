//! Finds the roots of a function: between two points of opposite sign, and along a list of points.

use thiserror::Error;

/// Maximum number of evaluations. The method halves the interval at least every third time, so this
/// suffices down to the rounding of a position.
const MAX_COUNT: usize = 200;
/// Inverse of the unit to which a root blurred by rounding is tentatively rounded.
const DECIMALS: f64 = 1e9;

/// The reason why no root was found.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum RootError {
    /// The signs at both ends are equal, or one of the values is NaN.
    #[error("the signs at both places do not differ")]
    SameSign,
    /// The function does not exist at a point of the search.
    #[error("the function does not exist at {0}")]
    Gap(f64),
    /// The root lies between these positions, but the requested tolerance is too fine to reach.
    #[error("the root was only narrowed down to between {0} and {1}")]
    MinimumError(f64, f64),
}

/// Finds the root of `f` between `a` and `b`, each a position with its value, to within `finest` or
/// two ulps.
///
/// Uses Chandrupatla's method (Adv. Eng. Software 28, 1997): inverse quadratic interpolation where
/// that is safe, bisection elsewhere.
///
/// # Errors
/// If no root was found: see [`RootError`].
pub fn root(
    a: (f64, f64),
    b: (f64, f64),
    finest: f64,
    mut f: impl FnMut(f64) -> Option<f64>,
) -> Result<f64, RootError> {
    if a.1 == 0.0 || b.1 == 0.0 {
        return Ok(if a.1 == 0.0 { a.0 } else { b.0 });
    }
    if !(a.1.signum() * b.1.signum() < 0.0) {
        return Err(RootError::SameSign);
    }
    let (mut new, mut other, mut share) = (b, a, 0.5);
    for _ in 0..MAX_COUNT {
        let x = new.0 + share * (other.0 - new.0);
        let here = (x, f(x).ok_or(RootError::Gap(x))?);
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
            return Ok(rounded(best, &mut f));
        }
        let minimum = tolerance / width;
        share = interpolated(new, other, last).clamp(minimum, 1.0 - minimum);
    }
    Err(RootError::MinimumError(
        new.0.min(other.0),
        new.0.max(other.0),
    ))
}

/// Finds the roots between neighbouring positions, given in order, where the sign of `f` changes. A
/// double root or a gap does not change the sign; two roots between the same positions are missed.
pub fn roots(
    places: impl IntoIterator<Item = f64>,
    finest: f64,
    mut f: impl FnMut(f64) -> Option<f64>,
) -> Vec<f64> {
    let mut found = Vec::new();
    let mut before: Option<(f64, f64)> = None;
    for at in places {
        let here = f(at).map(|value| (at, value));
        if let (Some(a), Some(b)) = (before, here)
            && (a.1 < 0.0) != (b.1 < 0.0)
            && let Ok(at) = root(a, b, finest, &mut f)
        {
            // A double root touched from below was already found at the end of the previous
            // interval.
            if a.1 == 0.0 && found.last() == Some(&at) {
                found.pop();
            } else {
                found.push(at);
            }
        }
        before = here;
    }
    found
}

/// Returns the position of the zero of the inverse parabola through three points, as a fraction of
/// the distance from `new` to `other`. Returns one half if the parabola is not reliable.
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

/// Replaces a root by a position with few decimals if that is equally good: the root is only known
/// to within the rounding of `f`.
fn rounded(root: (f64, f64), f: &mut impl FnMut(f64) -> Option<f64>) -> f64 {
    let round = few_decimals(root.0);
    let is_as_good = (round - root.0).abs() < 1.0 / DECIMALS
        && f(round).is_some_and(|v| v.abs() <= root.1.abs());
    if is_as_good { round } else { root.0 }
}

/// Rounds a coordinate to a multiple of 1e-9.
pub fn few_decimals(at: f64) -> f64 {
    (at * DECIMALS).round() / DECIMALS
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(a: f64, b: f64, f: impl Fn(f64) -> f64) -> Result<f64, RootError> {
        root((a, f(a)), (b, f(b)), f64::MIN_POSITIVE, |x| Some(f(x)))
    }

    #[test]
    fn finds_root_to_last_digit_in_few_evaluations() {
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
    fn finds_steep_roots_and_roots_at_ends() {
        // Like a rate next to a limit: a square root, whose derivative has a pole at the end.
        let found = of(0.0, 1.0, |x| x.sqrt() - 1e-3).unwrap();
        assert!((found - 1e-6).abs() < 1e-19, "{found:e}");
        assert_eq!(of(0.0, 1.0, |x| x), Ok(0.0));
    }

    #[test]
    fn indistinct_root_is_rounded() {
        assert_eq!(of(-1.0, 0.7, |x| (x - 0.25) * 1e-300), Ok(0.25));
        assert_eq!(of(-1.0, 0.7, f64::sin), Ok(0.0));
    }

    #[test]
    fn error_explains_missing_root() {
        assert_eq!(of(1.0, 2.0, |x| x), Err(RootError::SameSign));
        let nan = root((0.0, f64::NAN), (1.0, 1.0), 1e-9, Some);
        assert_eq!(nan, Err(RootError::SameSign));
        let gap = root((0.0, -1.0), (1.0, 1.0), 1e-9, |_| None);
        assert_eq!(gap, Err(RootError::Gap(0.5)));
        // After 200 bisections, the interval is still wider than the smallest number.
        let step = |x: f64| if x > 0.0 { 1.0 } else { -1.0 };
        let Err(RootError::MinimumError(low, high)) = of(-1.0, 1.0, step) else {
            panic!("it cannot be settled");
        };
        assert!(
            low <= 0.0 && 0.0 < high && high - low < 1e-50,
            "{low} {high}"
        );
    }

    #[test]
    fn roots_are_sign_changes() {
        let places = || (0..=10).map(f64::from);
        let all = |f: fn(f64) -> Option<f64>| roots(places(), f64::EPSILON, f);
        assert_eq!(all(|x| Some((x - 2.5) * (x - 7.0))), [2.5, 7.0]);
        // Touched from above and from below, and crossed between two places that are both roots.
        assert_eq!(all(|x| Some((x - 3.0).powi(2))), [0.0; 0]);
        assert_eq!(all(|x| Some(-(x - 3.0).powi(2))), [0.0; 0]);
        let flat = all(|x| Some((x - 5.0).max(0.0) + (x - 4.0).min(0.0)));
        assert!(
            flat.len() == 1 && (4.0..=5.0).contains(&flat[0]),
            "{flat:?}"
        );
        // Without a value in between, there is no root.
        assert_eq!(all(|x| (x != 3.0).then_some(x - 3.0)), [0.0; 0]);
    }

    /// Returns the root of `f` between two places, and the number of evaluations.
    fn counted(f: impl Fn(f64) -> f64, [low, high]: [f64; 2], finest: f64) -> (f64, usize) {
        let mut count = 0;
        let evaluated = |x| {
            count += 1;
            Some(f(x))
        };
        let found = root((low, f(low)), (high, f(high)), finest, evaluated).unwrap();
        (found, count)
    }

    #[test]
    fn number_of_evaluations_stays() {
        let functions: [fn(f64) -> f64; 5] = [
            |x| x - 0.3,
            |x| x * x * x - 0.1,
            |x| x / (1.0 + x) - 0.3,
            |x| x.sqrt() - 0.2,
            |x| 1.0 / (x + 0.01) - 3.0,
        ];
        let counts = functions.map(|f| counted(f, [0.0, 1.0], f64::MIN_POSITIVE).1);
        assert_eq!(counts, [3, 10, 7, 8, 9]);
        let total: usize = (1..200)
            .map(|k| {
                let at = f64::from(k) / 200.0;
                let skew = f64::from(k % 7);
                let f = |x: f64| (x - at) * (0.1 + skew * x * x);
                counted(f, [0.0, 1.0], f64::MIN_POSITIVE).1
            })
            .sum();
        assert_eq!(total, 1666);
    }

    /// A function and its negative have the same root, whichever end is the better one.
    #[test]
    fn sign_of_the_function_does_not_matter() {
        for k in 1..30 {
            let at = f64::from(k) / 30.0;
            for finest in [1e-9, 1e-3, 0.1] {
                let f = |x: f64| (x - at) * (2.0 + x * x);
                let (found, count) = counted(f, [0.0, 1.01], finest);
                assert_eq!(
                    counted(|x| -f(x), [0.0, 1.01], finest),
                    (found, count),
                    "{at}"
                );
                // The end with the smaller value is returned.
                assert!(
                    (found - at).abs() <= finest.max(1e-15),
                    "{at} {finest}: {found}"
                );
            }
        }
    }

    #[test]
    fn root_is_found_to_the_tolerance() {
        for k in 1..50 {
            let at = f64::from(k) / 51.0;
            let step = |x: f64| if x > at { 1.0 } else { -1.0 };
            let (found, _) = counted(step, [0.0, 1.0], 1e-3);
            assert!((found - at).abs() <= 2e-3, "{at}: {found}");
        }
    }

    #[test]
    fn blurred_root_has_few_decimals() {
        // Products are multiples of the smallest number: zero within 1e-7 around the root.
        let (found, _) = counted(|x| (x - 0.3) * 1e6 * 5e-324, [0.0, 1.0], 1e-15);
        assert!(
            (found - 0.3).abs() < 1e-6 && found == few_decimals(found),
            "{found}"
        );
        assert_eq!(few_decimals(1.23456789049), 1.234_567_89);
    }

    #[test]
    fn root_at_a_place_keeps_the_roots_before_it() {
        let places = || (0..=10).map(f64::from);
        let found = roots(places(), f64::EPSILON, |x| Some((x - 2.5) * (7.0 - x)));
        assert_eq!(found, [2.5, 7.0]);
    }
}
