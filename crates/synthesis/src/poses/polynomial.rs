//! Double-double polynomials: real roots of univariate ones, and bivariate ones as determinants of
//! linear forms.

use super::space::Triple;
use kinematics::Double;

/// Maximum number of Newton or bisection steps for a root; bisection alone yields 106 bits by then.
const MAX_STEPS: usize = 160;
/// Relative size of a step below which a root does not change.
const LAST_STEP: f64 = 1e-31;
/// An extremum with a value below this fraction of the sum of all terms' absolute values is returned as
/// a touched root. The poses verify its solutions and reject false ones.
const TOUCH_TOLERANCE: f64 = 1e-6;

/// Returns the value at `x`; the coefficients have rising powers.
pub(super) fn value(coefficients: &[Double], x: Double) -> Double {
    let horner = |sum, c: &Double| sum * x + *c;
    coefficients.iter().rev().fold(Double::ZERO, horner)
}

/// Returns the product.
pub(super) fn product(a: &[Double], b: &[Double]) -> Vec<Double> {
    let mut all = vec![Double::ZERO; (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            all[i + j] += *x * *y;
        }
    }
    all
}

/// Returns `a + factor b`.
pub(super) fn plus(a: &[Double], factor: f64, b: &[Double]) -> Vec<Double> {
    let at = |p: &[Double], k: usize| p.get(k).copied().unwrap_or_default();
    let factor = Double::exactly(factor);
    let sum = |k| at(a, k) + factor * at(b, k);
    (0..a.len().max(b.len())).map(sum).collect()
}

/// Returns the quotient by `x - root`, without the remainder.
pub(super) fn deflated(p: &[Double], root: Double) -> Vec<Double> {
    let mut carry = Double::ZERO;
    let mut quotient: Vec<Double> = p
        .iter()
        .rev()
        .map(|c| {
            carry = carry * root + *c;
            carry
        })
        .collect();
    quotient.pop();
    quotient.reverse();
    quotient
}

/// Returns the largest absolute value of the coefficients.
pub(super) fn largest(p: &[Double]) -> f64 {
    p.iter().fold(0.0, |maximum, c| c.hi.abs().max(maximum))
}

/// The real roots of a polynomial.
#[derive(Default)]
pub(super) struct RealRoots {
    /// Sign changes, in ascending order.
    pub crossed: Vec<Double>,
    /// Extrema near zero: double roots, and some false ones.
    pub touched: Vec<Double>,
}

/// Returns all real roots from `-within` to `within`. Between two extrema, which are roots of the
/// derivative, lies at most one root.
pub(super) fn real_roots(p: &[Double], within: f64) -> RealRoots {
    let mut roots = RealRoots::default();
    if p.len() < 2 || !largest(p).is_finite() {
        return roots;
    }
    let slope: Vec<Double> = (1_u8..)
        .zip(&p[1..])
        .map(|(power, c)| *c * Double::exactly(f64::from(power)))
        .collect();
    let turns = real_roots(&slope, within);
    let mut places = turns.crossed;
    places.extend(turns.touched);
    places.sort_by(|a, b| a.hi.total_cmp(&b.hi).then(a.lo.total_cmp(&b.lo)));
    let sizes: Vec<Double> = p.iter().map(|c| c.abs()).collect();
    for &place in &places {
        if value(p, place).hi.abs() <= TOUCH_TOLERANCE * value(&sizes, place.abs()).hi {
            roots.touched.push(place);
        }
    }
    places.insert(0, Double::exactly(-within));
    places.push(Double::exactly(within));
    for ends in places.windows(2) {
        if let Some(root) = between(p, &slope, ends[0], ends[1]) {
            roots.crossed.push(root);
        }
    }
    roots
}

/// Returns the root between two points with different signs, by Newton steps, with bisection if
/// these leave the bracket. Returns `None` if the signs are equal.
fn between(p: &[Double], slope: &[Double], low: Double, high: Double) -> Option<Double> {
    let half = Double::exactly(0.5);
    let (mut low, mut high) = (low, high);
    let begins_below = value(p, low).hi < 0.0;
    let ends_below = value(p, high).hi < 0.0;
    if begins_below == ends_below {
        return None;
    }
    let mut x = (low + high) * half;
    for _ in 0..MAX_STEPS {
        let here = value(p, x);
        if here.hi == 0.0 {
            return Some(x);
        }
        if (here.hi < 0.0) == begins_below {
            low = x;
        } else {
            high = x;
        }
        let step = here / value(slope, x);
        let newton = x - step;
        let is_inside = (newton - low).hi > 0.0 && (high - newton).hi > 0.0;
        let next = if is_inside {
            newton
        } else {
            (low + high) * half
        };
        let change = (next - x).hi.abs();
        x = next;
        if change <= LAST_STEP * x.hi.abs() {
            break;
        }
    }
    Some(x)
}

/// A cubic polynomial of two variables: `[i][j]` is the coefficient of `x^i y^j`.
pub(super) type PlaneCubic = [[Double; 4]; 4];

/// Returns the determinant of three rows of three linear forms `a x + b y + c` each.
pub(super) fn determinant(rows: [&[Triple; 3]; 3]) -> PlaneCubic {
    const EVEN: [[usize; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];
    let mut sum = PlaneCubic::default();
    for [i, j, k] in EVEN {
        add_product(&mut sum, [rows[0][i], rows[1][j], rows[2][k]], 1.0);
        add_product(&mut sum, [rows[0][i], rows[1][k], rows[2][j]], -1.0);
    }
    sum
}

fn add_product(sum: &mut PlaneCubic, forms: [Triple; 3], sign: f64) {
    for (i, a) in forms[0].into_iter().enumerate() {
        for (j, b) in forms[1].into_iter().enumerate() {
            let part = (a * b).scaled(sign);
            for (k, c) in forms[2].into_iter().enumerate() {
                let power = |variable| [i, j, k].iter().filter(|&&v| v == variable).count();
                sum[power(0)][power(1)] += part * c;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(values: &[f64]) -> Vec<Double> {
        values.iter().map(|&v| Double::exactly(v)).collect()
    }

    /// Returns the polynomial with these roots.
    fn planted(roots: &[f64]) -> Vec<Double> {
        let linear = |r: &f64| exact(&[-r, 1.0]);
        let one = exact(&[1.0]);
        roots.iter().fold(one, |p, r| product(&p, &linear(r)))
    }

    #[test]
    fn planted_roots_are_found_to_double_double_precision() {
        let roots = [-300.25, -1.5, -1.499_999_999, 0.0, 1e-7, 2.0];
        let found = real_roots(&planted(&roots), 1e6).crossed;
        assert_eq!(found.len(), roots.len());
        for (found, root) in found.iter().zip(roots) {
            let off = (*found - Double::exactly(root)).hi.abs();
            assert!(off < 1e-20 * root.abs().max(1.0), "{found:?} for {root}");
        }
    }

    #[test]
    fn double_root_is_touched_and_complex_roots_are_ignored() {
        let found = real_roots(&planted(&[3.0, 3.0, -1.0]), 1e6);
        assert_eq!(found.crossed.len() % 2, 1);
        assert!(found.touched.iter().any(|r| (r.hi - 3.0).abs() < 1e-14));
        let none = real_roots(&exact(&[1.0, 0.0, 1.0]), 1e6);
        assert!(none.crossed.is_empty() && none.touched.is_empty());
        assert!(real_roots(&exact(&[f64::NAN, 1.0]), 1e6).crossed.is_empty());
        assert!(real_roots(&[], 1e6).crossed.is_empty());
    }

    #[test]
    fn determinant_of_forms_matches_determinant_of_values() {
        let number = |k: usize| Double::exactly(((k * 37 + 11) % 23) as f64 - 11.0);
        let row = |r: usize| -> [Triple; 3] {
            std::array::from_fn(|c| std::array::from_fn(|v| number(9 * r + 3 * c + v)))
        };
        let rows = [row(0), row(1), row(2)];
        let surface = determinant([&rows[0], &rows[1], &rows[2]]);
        let (x, y) = (Double::exactly(0.75), Double::exactly(-1.25));
        let at = |form: Triple| form[0] * x + form[1] * y + form[2];
        let by_values = super::super::space::determinant([0, 1, 2].map(|r| rows[r].map(at)));
        let columns: Vec<Double> = surface.iter().map(|column| value(column, y)).collect();
        assert!((value(&columns, x) - by_values).hi.abs() < 1e-25);
    }

    #[test]
    fn deflation_divides_out_root() {
        let p = planted(&[2.0, -1.0, 5.0]);
        assert_eq!(deflated(&p, Double::exactly(5.0)), planted(&[2.0, -1.0]));
    }
}
