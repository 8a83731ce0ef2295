//! Five poses: finds all dyads, at most four.
//!
//! Four bilinear equations are a matrix of four rows, linear in the pin, times the pivot. A pin has
//! a pivot if the rank is two, so that all four determinants of three rows vanish. At a given y
//! these are four cubics in x, which have a common root only if the determinant of their
//! coefficients is zero. This determinant is a polynomial of degree six in y. The two circular
//! points at infinity, common to all cubics, reduce it to a quartic, as in Burmester's theory
//! (Bottema and Roth, Theoretical Kinematics, 1979, chapter 8). Slides are among its roots.
//!
//! All computations use double-double numbers: with doubles, nearly repeated poses would leave no
//! digit of the quartic.

use super::dyad::FullDyad;
use super::dyad_equations::Guidance;
use super::form::{self, Form};
use super::polynomial::{self, PlaneCubic};
use super::space::{self, Triple};
use kinematics::{Double, Vec2};

/// Directions of the body's x axis, in degrees, in which the quartic is set up. Pins with equal y
/// in one direction differ in the next. A pin would be missed only if it had the same y as one of
/// the three others in each direction.
const DIRECTIONS: [f64; 3] = [17.0, 71.0, 139.0];
/// Maximum distance of a pin, in units of the equations.
const MAX_PIN_DISTANCE: f64 = 4e6;
/// A quartic whose coefficients are below this limit, for cubics of size one, is zero up to
/// double-double rounding.
const ROUNDING: f64 = 1e-28;
/// Maximum number of Newton steps. Two or three suffice from the quartic's roots, unless two dyads
/// nearly coincide.
const MAX_STEPS: usize = 40;

/// The dyads through five poses.
pub(super) struct FoundDyads {
    pub found: Vec<FullDyad>,
    /// Whether these are all dyads: the quartic exceeds the rounding error of the poses, and every
    /// root has a dyad or degenerates.
    pub are_all: bool,
}

/// Returns all dyads through five poses; `None` unless there are four equations.
pub(super) fn dyads(guidance: &Guidance) -> Option<FoundDyads> {
    let forms: &[Form; 4] = guidance.forms.as_slice().try_into().ok()?;
    let mut all = FoundDyads {
        found: Vec::new(),
        are_all: true,
    };
    for direction in DIRECTIONS.map(Double::unit) {
        let forms = (*forms).map(|form| form::turned(&form, direction));
        let Some(quartic) = Quartic::new(&forms) else {
            all.are_all = false;
            continue;
        };
        all.are_all &= quartic.is_more_than(guidance.error);
        for root in quartic.roots(guidance.error) {
            let solution = quartic.pin(root.y).and_then(|pin| refined(&forms, pin));
            let solution = solution.map(|(pin, pivot)| (form::turned_back(pin, direction), pivot));
            let dyad = solution.and_then(|(pin, pivot)| guidance.dyad(pin, pivot));
            let is_nothing =
                || solution.is_some_and(|(pin, pivot)| guidance.is_nothing(pin, pivot));
            all.are_all &= !root.is_one || dyad.is_some() || is_nothing();
            let is_new = |new: &FullDyad| {
                let mut found = all.found.iter();
                !found.any(|other| guidance.is_same(new, other))
            };
            all.found.extend(dyad.filter(is_new));
        }
    }
    Some(all)
}

/// The quartic for the y of the pins, in one direction.
struct Quartic {
    cubics: [PlaneCubic; 4],
    /// The size of the smallest cubic before scaling to size one.
    least: f64,
    coefficients: Vec<Double>,
}

/// A possible y of a pin.
struct PinLevel {
    y: Double,
    /// Whether the quartic has a zero there, not only a small extremum.
    is_one: bool,
}

impl Quartic {
    /// Sets up the quartic. Returns `None` if it is zero up to double-double rounding.
    fn new(forms: &[Form; 4]) -> Option<Quartic> {
        let columns = forms.map(|form| form::columns(&form));
        let without = |k: usize| {
            let [a, b, c] = [0, 1, 2].map(|row| &columns[(k + 1 + row) % 4]);
            polynomial::determinant([a, b, c])
        };
        let cubics = [without(0), without(1), without(2), without(3)];
        let minimum = cubics.iter().map(size).fold(f64::INFINITY, f64::min);
        let cubics = cubics.map(|c| of_size_one(&c));
        let coefficients = resultant(&cubics);
        (polynomial::largest(&coefficients) > ROUNDING).then_some(Quartic {
            cubics,
            least: minimum,
            coefficients,
        })
    }

    /// Returns the error of a coefficient that follows from an error of the equations.
    fn blur(&self, error: f64) -> f64 {
        error / self.least
    }

    /// Returns `true` if the quartic exceeds the effect of an error of the equations. If not, there
    /// may be a continuous family of dyads.
    fn is_more_than(&self, error: f64) -> bool {
        polynomial::largest(&self.coefficients) > self.blur(error)
    }

    fn roots(&self, error: f64) -> Vec<PinLevel> {
        let roots = polynomial::real_roots(&self.coefficients, MAX_PIN_DISTANCE);
        let crossed = roots
            .crossed
            .into_iter()
            .map(|y| PinLevel { y, is_one: true });
        let touched = roots.touched.into_iter().map(|y| {
            let extent = y.hi.abs().max(1.0).powi(4);
            let here = polynomial::value(&self.coefficients, y).hi.abs();
            PinLevel {
                y,
                is_one: here <= self.blur(error) * extent,
            }
        });
        crossed.chain(touched).collect()
    }

    /// Returns the pin at a level.
    fn pin(&self, y: Double) -> Option<Triple> {
        Some([common_root(&self.cubics, y)?, y, Double::ONE])
    }
}

fn size(cubic: &PlaneCubic) -> f64 {
    let rows = cubic.iter().map(|row| space::largest(row));
    rows.fold(0.0, f64::max)
}

fn of_size_one(cubic: &PlaneCubic) -> PlaneCubic {
    let size = Double::exactly(size(cubic));
    if size.hi > 0.0 {
        cubic.map(|row| row.map(|c| c / size))
    } else {
        *cubic
    }
}

/// Computes the determinant of the coefficients of `x^3, x^2, x, 1` as a polynomial of y: by the
/// products of minors of its first two columns and its last two.
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
    // The circular points eliminate y^6 and y^5.
    sum.truncate(5);
    sum
}

/// Returns the common x of all cubics at a level y, from the three most independent ones.
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
    // The vector (1, x, x^2, x^3) up to a factor: the two larger entries give x more accurately.
    let x = if best[0].hi.abs() >= best[3].hi.abs() {
        best[1] / best[0]
    } else {
        best[3] / best[2]
    };
    x.hi.is_finite().then_some(x)
}

/// Improves a solution by Newton's method on all four equations, for the pin's coordinates and the
/// pivot's two smaller ones. Returns pin and pivot.
pub(super) fn refined(forms: &[Form; 4], pin: Triple) -> Option<(Triple, Triple)> {
    let mut pin = [pin[0] / pin[2], pin[1] / pin[2], Double::ONE];
    let mut pivot = space::kernel(&forms.map(|f| form::of_pin(&f, pin)))?;
    let mut before = f64::INFINITY;
    for _ in 0..MAX_STEPS {
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
        // Only rounding remains, or the steps no longer decrease.
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
