//! Five poses: all dyads, at most four.
//!
//! Four bilinear equations are a matrix of four rows, linear in the pin, times the pivot: a pin has a pivot where the rank
//! falls to two, so that all four determinants of three rows vanish. At a given y these are four cubics in x, and four
//! cubics have a root in common only where the determinant of their coefficients is nought. That is a polynomial of y of
//! degree six, of which the two circular points at infinity, common to all, take two: a quartic, as Burmester had it
//! (Bottema and Roth, Theoretical Kinematics, 1979, chapter 8). Slides are among its roots.
//!
//! All in twice the digits: in doubles, nearly repeated poses would leave no digit of the quartic.

use super::dyad::{Guidance, PinHeld};
use super::form::{self, Form};
use super::polynomial::{self, PlaneCubic};
use super::space::{self, Triple};
use crate::{Double, Vec2};

/// Directions of the body's x axis, in degrees, in which the quartic is set up. Pins that are level in one are told apart
/// in the next: one would be missed only if it were level with the three others in just these.
const DIRECTIONS: [f64; 3] = [17.0, 71.0, 139.0];
/// How far a pin is looked for, in units of the equations.
const FAR: f64 = 4e6;
/// A quartic with less than this, where its cubics were of size one, is nought but for rounding: there are dyads in any
/// number.
const NOUGHT: f64 = 1e-13;
/// Newton's steps; from the quartic's roots two or three are enough, unless two dyads are about to be one.
const MOST_STEPS: usize = 40;

/// All dyads through five poses; none where there are any number.
pub(super) fn dyads(guidance: &Guidance) -> Option<Vec<PinHeld>> {
    let forms: &[Form; 4] = guidance.forms.as_slice().try_into().ok()?;
    let mut found: Vec<PinHeld> = Vec::new();
    for direction in DIRECTIONS.map(Double::unit) {
        let forms = (*forms).map(|form| form::turned(&form, direction));
        for (pin, pivot) in solutions(&forms)? {
            let dyad = guidance.dyad(form::turned_back(pin, direction), pivot);
            let is_new = |new: &PinHeld| !found.iter().any(|other| guidance.is_same(new, other));
            found.extend(dyad.filter(is_new));
        }
    }
    Some(found)
}

/// Pins and pivots that may solve four equations.
fn solutions(forms: &[Form; 4]) -> Option<Vec<(Triple, Triple)>> {
    let columns = forms.map(|form| form::columns(&form));
    let without = |k: usize| {
        let [a, b, c] = [0, 1, 2].map(|row| &columns[(k + 1 + row) % 4]);
        polynomial::determinant([a, b, c])
    };
    let cubics = [without(0), without(1), without(2), without(3)].map(|c| of_size_one(&c));
    let resultant = resultant(&cubics);
    if !(polynomial::largest(&resultant) > NOUGHT) {
        return None;
    }
    let roots = polynomial::real_roots(&resultant, FAR);
    let levels = roots.crossed.into_iter().chain(roots.touched);
    let pins = levels.filter_map(|y| Some([common_root(&cubics, y)?, y, Double::ONE]));
    Some(pins.filter_map(|pin| refined(forms, pin)).collect())
}

fn of_size_one(cubic: &PlaneCubic) -> PlaneCubic {
    let size = Double::exactly(
        cubic
            .iter()
            .map(|row| space::largest(row))
            .fold(0.0, f64::max),
    );
    if size.hi > 0.0 {
        cubic.map(|row| row.map(|c| c / size))
    } else {
        *cubic
    }
}

/// The coefficients of `x^3, x^2, x, 1` at a level y have no other determinant: by the products of its first two columns
/// and its last two, as polynomials of y.
fn resultant(cubics: &[PlaneCubic; 4]) -> Vec<Double> {
    let coefficient = |row: usize, power: usize| &cubics[row][power][..=3 - power];
    let minor = |[a, b]: [usize; 2], [p, q]: [usize; 2]| {
        let first = polynomial::product(coefficient(a, p), coefficient(b, q));
        let second = polynomial::product(coefficient(a, q), coefficient(b, p));
        polynomial::plus(&first, -1.0, &second)
    };
    const PARTS: [([usize; 2], [usize; 2], f64); 6] = [
        ([0, 1], [2, 3], 1.0),
        ([0, 2], [1, 3], -1.0),
        ([0, 3], [1, 2], 1.0),
        ([1, 2], [0, 3], 1.0),
        ([1, 3], [0, 2], -1.0),
        ([2, 3], [0, 1], 1.0),
    ];
    let mut sum = Vec::new();
    for (top, bottom, sign) in PARTS {
        let part = polynomial::product(&minor(top, [3, 2]), &minor(bottom, [1, 0]));
        sum = polynomial::plus(&sum, sign, &part);
    }
    // The circular points take y^6 and y^5.
    sum.truncate(5);
    sum
}

/// The x that all cubics have in common at a level y, from the three that differ most.
fn common_root(cubics: &[PlaneCubic; 4], y: Double) -> Option<Double> {
    let rows = cubics.map(|cubic| cubic.map(|c| polynomial::value(&c, y)));
    // Columns by rising powers of x; the product of three rows is orthogonal to them.
    let product = |k: usize| -> [Double; 4] {
        let [a, b, c] = [1, 2, 3].map(|step| rows[(k + step) % 4]);
        std::array::from_fn(|left_out| {
            let three = |row: [Double; 4]| -> Triple {
                std::array::from_fn(|column| row[column + usize::from(column >= left_out)])
            };
            let minor = space::determinant([three(a), three(b), three(c)]);
            if left_out % 2 == 0 { minor } else { -minor }
        })
    };
    let products = [product(0), product(1), product(2), product(3)];
    let best = products
        .iter()
        .max_by(|a, b| space::largest(*a).total_cmp(&space::largest(*b)))?;
    // (1, x, x^2, x^3), but for a factor: the larger two say more.
    let x = if best[0].hi.abs() >= best[3].hi.abs() {
        best[1] / best[0]
    } else {
        best[3] / best[2]
    };
    x.hi.is_finite().then_some(x)
}

/// Newton's method on all four equations, for the pin's place and the pivot's two smaller coordinates.
pub(super) fn refined(forms: &[Form; 4], pin: Triple) -> Option<(Triple, Triple)> {
    let mut pin = [pin[0] / pin[2], pin[1] / pin[2], Double::ONE];
    let mut pivot = space::kernel(&forms.map(|f| form::of_pin(&f, pin)))?;
    let mut before = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let fixed = (0..3).max_by(|&a, &b| pivot[a].hi.abs().total_cmp(&pivot[b].hi.abs()))?;
        let [i, k] = [(fixed + 1) % 3, (fixed + 2) % 3];
        let by_pin = forms.map(|f| form::of_pivot(&f, pivot));
        let by_pivot = forms.map(|f| form::of_pin(&f, pin));
        let rest = by_pin.map(|row| space::dot(row, pin));
        let rows =
            std::array::from_fn(|r| [by_pin[r][0], by_pin[r][1], by_pivot[r][i], by_pivot[r][k]]);
        let Some(step) = space::solved(rows, rest) else {
            break;
        };
        let extent = 1.0 + Vec2::new(pin[0], pin[1]).nearest().norm();
        let size = space::largest(&step) / extent;
        // Rounding is all that is left, or the steps no longer fall.
        if size < 1e-29 || (size < 1e-18 && size >= before) {
            break;
        }
        before = size;
        pin[0] = pin[0] - step[0];
        pin[1] = pin[1] - step[1];
        pivot[i] = pivot[i] - step[2];
        pivot[k] = pivot[k] - step[3];
        pivot = space::leveled(pivot)?;
    }
    Some((pin, pivot))
}
