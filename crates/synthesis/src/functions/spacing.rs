//! Chooses the points of a function that a linkage should meet.

use std::f64::consts::PI;

/// Returns pairs `[x, f(x)]` of a function at the zeros of Chebyshev's polynomial over a range,
/// from its first end to its second.
///
/// They are a good first choice for a small error over the whole range (Freudenstein 1955). Returns
/// `None` if the function has no finite value at one of them.
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
    fn three_chebyshev_pairs_between_one_and_two() {
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
