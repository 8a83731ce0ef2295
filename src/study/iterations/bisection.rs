//! Halving an interval in which a function changes its sign.

/// An interval, and its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Halving {
    /// Where it begins.
    pub a: f64,
    /// Where it ends.
    pub b: f64,
    /// Half way.
    pub middle: f64,
    /// The function there.
    pub value: f64,
}

/// An interval halved until it is small.
#[derive(Clone, Debug, PartialEq)]
pub struct Bisection {
    /// The function at both ends of the first interval.
    pub ends: [f64; 2],
    /// The intervals; none where the signs at the ends do not differ.
    pub halvings: Vec<Halving>,
}

/// Halvings after which no double lies between the ends.
const MOST_HALVINGS: usize = 64;

impl Bisection {
    /// Halves the interval from `a` to `b` until it is no longer than `finest`.
    #[must_use]
    pub fn of(a: f64, b: f64, finest: f64, f: impl Fn(f64) -> f64) -> Bisection {
        let ends = [f(a), f(b)];
        let mut bisection = Bisection {
            ends,
            halvings: Vec::new(),
        };
        let differ = ends[0] * ends[1] <= 0.0 && ends.iter().all(|v| v.is_finite());
        // A root at an end counts for the sign that the other end has not.
        let is_above = if ends[0] == 0.0 {
            ends[1] < 0.0
        } else {
            ends[0] > 0.0
        };
        let (mut low, mut high) = (a, b);
        while differ && bisection.halvings.len() < MOST_HALVINGS {
            let middle = 0.5 * (low + high);
            if !bisection.halvings.is_empty() && (middle == low || middle == high) {
                break;
            }
            let value = f(middle);
            bisection.halvings.push(Halving {
                a: low,
                b: high,
                middle,
                value,
            });
            if value == 0.0 || (high - low).abs() <= finest {
                break;
            }
            if (value > 0.0) == is_above {
                low = middle;
            } else {
                high = middle;
            }
        }
        bisection
    }

    /// Where it ended.
    #[must_use]
    pub fn root(&self) -> Option<f64> {
        self.halvings.last().map(|last| last.middle)
    }
}
