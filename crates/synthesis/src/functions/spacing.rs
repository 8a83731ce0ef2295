//! Where a function is asked for the pairs that a linkage meets.

use std::f64::consts::PI;

/// Pairs `[x, f(x)]` of a function at the zeros of Chebyshev's polynomial over a range, from its first end to its other:
/// where the error between is to be small everywhere, they are a good first choice (Freudenstein 1955). `None` where
/// there is no value.
#[must_use]
pub fn chebyshev_pairs(
    f: impl Fn(f64) -> Option<f64>,
    [from, to]: [f64; 2],
    count: usize,
) -> Option<Vec<[f64; 2]>> {
    let pair = |k: usize| {
        let zero = (PI * (2 * k + 1) as f64 / (2 * count) as f64).cos();
        let x = 0.5 * (from + to) - 0.5 * (to - from) * zero;
        let y = f(x).filter(|y| y.is_finite())?;
        Some([x, y])
    };
    (0..count).map(pair).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_between_one_and_two() {
        let pairs = chebyshev_pairs(|x| Some(x * x), [1.0, 2.0], 3).unwrap();
        let known = [1.0 + 0.066_987_298, 1.5, 1.933_012_702];
        for ([x, y], known) in pairs.into_iter().zip(known) {
            assert!((x - known).abs() < 1e-9 && y == x * x);
        }
        assert_eq!(chebyshev_pairs(|_| None, [0.0, 1.0], 3), None);
        assert_eq!(chebyshev_pairs(Some, [0.0, f64::NAN], 3), None);
        assert_eq!(chebyshev_pairs(Some, [0.0, 1.0], 0), Some(Vec::new()));
    }
}
