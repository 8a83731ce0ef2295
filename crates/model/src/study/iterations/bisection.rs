//! Bisection of an interval in which a function changes its sign.

/// An interval and its midpoint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Halving {
    /// The first end.
    pub a: f64,
    /// The other end.
    pub b: f64,
    /// The midpoint.
    pub middle: f64,
    /// The function's value at the midpoint.
    pub value: f64,
}

/// An interval bisected until it is small.
#[derive(Clone, Debug, PartialEq)]
pub struct Bisection {
    /// The function's values at both ends of the first interval.
    pub ends: [f64; 2],
    /// The intervals; empty if the signs at the ends do not differ.
    pub halvings: Vec<Halving>,
}

/// Maximum number of bisections; after that there is no double between the ends.
const MAX_HALVINGS: usize = 64;

impl Bisection {
    /// Bisects the interval from `a` to `b` until its length is at most `finest`.
    #[must_use]
    pub fn of(a: f64, b: f64, finest: f64, f: impl Fn(f64) -> f64) -> Bisection {
        let ends = [f(a), f(b)];
        let mut bisection = Bisection {
            ends,
            halvings: Vec::new(),
        };
        let differ = ends[0] * ends[1] <= 0.0 && ends.iter().all(|v| v.is_finite());
        // A root at an end takes the sign opposite to the other end's.
        let is_above = if ends[0] == 0.0 {
            ends[1] < 0.0
        } else {
            ends[0] > 0.0
        };
        let (mut low, mut high) = (a, b);
        while differ && bisection.halvings.len() < MAX_HALVINGS {
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

    /// Returns the last midpoint; `None` without a bisection.
    #[must_use]
    pub fn root(&self) -> Option<f64> {
        self.halvings.last().map(|last| last.middle)
    }
}
