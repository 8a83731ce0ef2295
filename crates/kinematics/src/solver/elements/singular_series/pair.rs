//! Represents two change points of a dyad close to each other, between which its input reverses.
//!
//! About each of them alone, a series holds only up to the other one. About both, the height is
//! t^2 + p t + q times a series: the polynomial is zero at the change points. Its square divides
//! that of the height.

use crate::Double;
use crate::Number;
use crate::arithmetic::Series;

/// The polynomial t^2 + p t + q of two close zeros of a height.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Pair {
    /// The coefficients q and p.
    pub lower: [Double; 2],
}

impl Pair {
    /// Returns the coefficients of the polynomial's square below t^4, lowest first.
    pub(in crate::solver) fn squared(self) -> [Double; 4] {
        let [q, p] = self.lower;
        [
            q * q,
            (p * q).scaled(2.0),
            p * p + q.scaled(2.0),
            p.scaled(2.0),
        ]
    }

    /// Returns the value of the polynomial.
    pub(in crate::solver) fn value(self, t: Double) -> Double {
        let [q, p] = self.lower;
        (t + p) * t + q
    }

    /// Returns the zeros in increasing order, or `None` if they are complex.
    pub(in crate::solver) fn zeros(self) -> Option<[Double; 2]> {
        let [q, p] = self.lower;
        let middle = -p.scaled(0.5);
        let square = middle * middle - q;
        let half = (square.hi >= 0.0).then(|| square.sqrt())?;
        Some([middle - half, middle + half])
    }

    /// Returns the height whose square contains the square of the polynomial, with the sign `side`
    /// outside the zeros.
    pub(in crate::solver) fn root(self, square: Series, side: f64) -> Series {
        let (rest, _) = square.divided(self.squared());
        let root = rest.sqrt().multiplied(self.lower);
        if side < 0.0 { -root } else { root }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// sqrt((t^2 - 1e-6)^2 (1 + t)) is (t^2 - 1e-6) sqrt(1 + t).
    #[test]
    fn root_keeps_all_coefficients() {
        let pair = Pair {
            lower: [Double::exactly(-1e-6), Double::ZERO],
        };
        let t = Series::line(Double::ONE, Double::ONE).cut(16);
        let square = t.multiplied(pair.squared());
        let root = pair.root(square, -1.0);
        let expected = [1e-6, 0.5e-6, -0.125e-6 - 1.0, 0.0625e-6 - 0.5];
        for (found, expected) in root.c.iter().zip(expected) {
            assert!((found.hi - expected).abs() < 1e-16, "{found:?} {expected}");
        }
        let zeros = pair.zeros().unwrap().map(|zero| zero.hi);
        assert!((zeros[0] + 1e-3).abs() < 1e-18 && (zeros[1] - 1e-3).abs() < 1e-18);
        let lower = [Double::exactly(1e-6), Double::ZERO];
        assert!(Pair { lower }.zeros().is_none());
    }
}
