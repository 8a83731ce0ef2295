//! Finds the minimum of a function near a point, from values alone.

use thiserror::Error;

/// Maximum number of evaluations; a dozen is usual.
const MAX_STEPS: usize = 60;
/// Fraction of the larger part at which a golden section divides it.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// The reason why the search failed, with the lowest point found and its value.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum MinimumError {
    /// The function does not exist at a point of the search.
    #[error("the function does not exist at {at}")]
    Gap {
        /// The point at which the function does not exist.
        at: f64,
        /// The lowest point found and its value.
        best: (f64, f64),
    },
    /// The maximum number of steps was not enough.
    #[error("{MAX_STEPS} steps are not enough")]
    Spent {
        /// The lowest point found and its value.
        best: (f64, f64),
    },
}

impl MinimumError {
    /// Returns the lowest point found and its value.
    pub fn best(self) -> (f64, f64) {
        match self {
            MinimumError::Gap { best, .. } | MinimumError::Spent { best } => best,
        }
    }
}

/// Finds the minimum of `f` between `low` and `high`, and returns its position and value. `first`
/// is an interior point with its value, which must be below the values at both ends.
///
/// Uses Brent's method without derivatives (Brent 1973, Algorithms for Minimization, chapter 5):
/// parabolas through the best three points, and golden sections where parabolas make no progress.
/// The value is found to its rounding error. The position is accurate only to about the square root
/// of that, because a smooth function is flat at its minimum.
///
/// # Errors
/// If the search does not converge: see [`MinimumError`].
pub fn lowest(
    mut f: impl FnMut(f64) -> Option<f64>,
    [mut low, mut high]: [f64; 2],
    first: (f64, f64),
) -> Result<(f64, f64), MinimumError> {
    let (mut best, mut second, mut third) = (first, first, first);
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    let finest = f64::EPSILON.sqrt() * (high - low).abs().max(f64::MIN_POSITIVE);
    for _ in 0..MAX_STEPS {
        let middle = 0.5 * (low + high);
        let minimum = finest.max(4.0 * f64::EPSILON * best.0.abs());
        if (best.0 - middle).abs() <= 2.0 * minimum - 0.5 * (high - low) {
            return Ok(best);
        }
        let parabola = vertex(best, second, third).filter(|vertex| {
            let way = vertex - best.0;
            way.abs() < 0.5 * before.abs() && *vertex > low && *vertex < high
        });
        before = step;
        step = match parabola {
            Some(vertex) if vertex - low < 2.0 * minimum || high - vertex < 2.0 * minimum => {
                minimum.copysign(middle - best.0)
            }
            Some(vertex) => vertex - best.0,
            None => {
                before = if best.0 < middle {
                    high - best.0
                } else {
                    low - best.0
                };
                GOLDEN * before
            }
        };
        let place = best.0
            + if step.abs() < minimum {
                minimum.copysign(step)
            } else {
                step
            };
        let Some(value) = f(place) else {
            return Err(MinimumError::Gap { at: place, best });
        };
        let tried = (place, value);
        if value <= best.1 {
            *(if place < best.0 { &mut high } else { &mut low }) = best.0;
            (third, second, best) = (second, best, tried);
        } else {
            *(if place < best.0 { &mut low } else { &mut high }) = place;
            if value <= second.1 || second.0 == best.0 {
                (third, second) = (second, tried);
            } else if value <= third.1 || third.0 == best.0 || third.0 == second.0 {
                third = tried;
            }
        }
    }
    Err(MinimumError::Spent { best })
}

/// Returns the vertex of the parabola through three points.
fn vertex(a: (f64, f64), b: (f64, f64), c: (f64, f64)) -> Option<f64> {
    let r = (a.0 - b.0) * (a.1 - c.1);
    let q = (a.0 - c.0) * (a.1 - b.1);
    let p = (a.0 - c.0) * q - (a.0 - b.0) * r;
    let vertex = a.0 - p / (2.0 * (q - r));
    vertex.is_finite().then_some(vertex)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn minima_of_known_functions_are_accurate() {
        // The cosine at pi, and a quartic, which is flatter.
        let around = |f: fn(f64) -> f64, low: f64, at: f64, high: f64| {
            let mut count = 0;
            let counted = |x| {
                count += 1;
                Some(f(x))
            };
            (lowest(counted, [low, high], (at, f(at))).unwrap(), count)
        };
        let ((place, value), count) = around(f64::cos, 3.0, 3.1, 3.3);
        assert!((place - std::f64::consts::PI).abs() < 3e-8, "{place}");
        assert!(
            (value + 1.0).abs() < 1e-15 && count <= 15,
            "{value} {count}"
        );
        let ((place, value), _) = around(|x| (x - 0.3_f64).powi(4), -1.0, 0.2, 1.0);
        assert!(
            (place - 0.3).abs() < 1e-3 && value < 1e-12,
            "{place} {value}"
        );
        // A corner.
        let ((place, _), _) = around(|x| (x - 0.7_f64).abs(), 0.0, 0.5, 1.0);
        assert!((place - 0.7).abs() < 1e-7, "{place}");
    }

    #[test]
    fn error_explains_missing_minimum() {
        let gap = lowest(|_| None, [0.0, 1.0], (0.4, 2.0)).unwrap_err();
        assert!(matches!(gap, MinimumError::Gap { at, .. } if (0.4..1.0).contains(&at)));
        assert_eq!(gap.best(), (0.4, 2.0));
        // The function decreases up to the largest double.
        let spent = lowest(|x| Some(-x), [0.0, f64::MAX], (1.0, -1.0)).unwrap_err();
        assert!(matches!(spent, MinimumError::Spent { .. }), "{spent:?}");
        assert!(spent.best().0 > 1e300);
    }

    /// Returns the place of the minimum of `f` between two places, and the number of evaluations.
    fn counted(f: impl Fn(f64) -> f64, [low, high]: [f64; 2]) -> (f64, usize) {
        let mut count = 0;
        let first = low + 0.4 * (high - low);
        let evaluated = |x| {
            count += 1;
            Some(f(x))
        };
        let (place, _) = lowest(evaluated, [low, high], (first, f(first))).unwrap();
        (place, count)
    }

    #[test]
    fn search_is_independent_of_the_scale() {
        let f = |x: f64| (x - 0.3).powi(2) + 0.2 * (x - 0.3).powi(3);
        let (place, count) = counted(f, [-1.0, 1.0]);
        for scale in [2.0_f64.powi(40), 2.0_f64.powi(-40)] {
            let scaled = counted(|x| f(x / scale), [-scale, scale]);
            assert_eq!(scaled, (place * scale, count), "{scale:e}");
        }
    }

    #[test]
    fn number_of_evaluations_stays() {
        let functions: [fn(f64) -> f64; 4] = [
            |x| (x - 0.3) * (x - 0.3),
            |x| x * x * x - x,
            |x| (x - 0.7).abs(),
            |x| 1.0 / (x + 0.5) + 2.0 * x,
        ];
        let counts = functions.map(|f| counted(f, [0.0, 1.0]).1);
        assert_eq!(counts, [5, 10, 15, 11]);
        // Slopes that differ on both sides, at several places of the minimum in the interval.
        let total: usize = (1..200)
            .map(|k| {
                let (skew, high) = (f64::from(k % 7), 0.4 + 0.02 * f64::from(k % 11));
                let f = |x: f64| x * x * (1.0 + skew * x * x) / (2.0 + x);
                counted(f, [-0.5 - 1e-3 * f64::from(k), high]).1
            })
            .sum();
        assert_eq!(total, 1952);
    }

    #[test]
    fn corner_is_found_to_the_tolerance() {
        let finest = f64::EPSILON.sqrt();
        for k in 1..40 {
            let corner = f64::from(k) / 40.0 + 1e-3;
            let (place, count) = counted(|x| (x - corner).abs(), [0.0, 1.0]);
            assert!((place - corner).abs() <= 2.0 * finest, "{corner}: {place}");
            assert!(count < 45, "{corner}: {count}");
        }
    }

    /// Steps next to an end lead away from it, on both sides of zero.
    #[test]
    fn minimum_close_to_an_end_takes_few_steps() {
        for [low, high] in [[1.0, 3.0], [-3.0, -1.0], [-1.0, 1.0]] {
            for at in [low + 1e-7, high - 1e-7] {
                let (place, count) = counted(|x| (x - at).powi(2), [low, high]);
                assert!(
                    (place - at).abs() < 1e-7 && count <= 40,
                    "{at}: {place} {count}"
                );
            }
        }
    }
}
