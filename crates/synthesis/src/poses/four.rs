//! Four poses: traces the curve of all dyads along its length, with its single slide.
//!
//! Three bilinear equations are a matrix, linear in the pin, times the pivot: a pin has a pivot if
//! the determinant is zero. This is a cubic through the two circular points at infinity, the
//! circle-point curve; its pivots form the centre-point curve (Burmester, Lehrbuch der Kinematik,
//! 1888; McCarthy and Soh, chapter 5). Besides the circular points it has one point at infinity,
//! which follows from linear equations. In a frame with its y axis in this direction,
//!
//! ```text
//! F(x, y) = alpha(x) y^2 + beta(x) y + gamma(x),        D(x) = beta^2 - 4 alpha gamma, of degree four
//! ```
//!
//! so that a piece of the curve covers every interval with D >= 0, and no others. Every branch and
//! every oval is therefore found without a search. Over an interval `[l, u]` with `x = l + (u - l)
//! cos^2(s / 2)`, both roots y together are one smooth closed piece, s from 0 to 360 degrees.

use super::dyad::FullDyad;
use super::dyad_equations::Guidance;
use super::form::{self, Form};
use super::polynomial::{self, PlaneCubic};
use super::space::{self, Triple};
use super::trace::{self, CurveSpot, Piece};
use kinematics::{Double, Vec2};

/// Extent to which an unbounded curve that is not a cubic is followed, in units of the equations.
const MAX_CURVE_EXTENT: f64 = 1e3;
/// Range for the roots of D of a cubic, in units of the equations.
const MAX_DISTANCE: f64 = 1e9;
/// Coefficients below this limit are rounding errors, for equations of length one.
const NOUGHT: f64 = 1e-12;

/// Returns the pieces of the curve. Each ends where the pin or the pivot passes through infinity,
/// or where it began.
///
/// A slide is added where the pivot passes through infinity. The result is empty unless there are
/// three equations, or if every pin has a pivot.
pub(super) fn pieces(guidance: &Guidance) -> Vec<Vec<FullDyad>> {
    let Ok(forms) = guidance.forms.as_slice().try_into() else {
        return Vec::new();
    };
    let slide = slide(guidance);
    let dyads = |piece: &Piece| {
        let dyad = |spot: &CurveSpot| guidance.dyad(spot.pin, spot.pivot);
        let before = slide.iter().filter(|_| piece.starts_at_infinity).cloned();
        let after = slide.iter().filter(|_| piece.ends_at_infinity).cloned();
        let links = piece.spots.iter().filter_map(dyad);
        before.chain(links).chain(after).collect()
    };
    let mut pieces: Vec<Vec<FullDyad>> = traced(forms, guidance.offsets())
        .iter()
        .map(dyads)
        .collect();
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

/// Traces the solutions of three equations along their curve, for these drawing offsets of pins and
/// pivots.
pub(super) fn traced(forms: &[Form; 3], offsets: [Vec2<Double>; 2]) -> Vec<Piece> {
    let Some(curve) = PinCurve::new(*forms, offsets) else {
        return Vec::new();
    };
    let pieces = |run: &Run| trace::pieces(run, |s| curve.spot(run, s));
    curve.runs().iter().flat_map(pieces).collect()
}

/// Returns the single slide: the pin whose four positions are on a line. The determinant of the
/// equations with a normal `(X, Y, 0)` for the pivot is `(X^2 + Y^2) (p X + q Y)`: its values along
/// both axes are p and q.
///
/// Returns `None` unless there are three equations.
pub(super) fn slide(guidance: &Guidance) -> Option<FullDyad> {
    let forms: &[Form; 3] = guidance.forms.as_slice().try_into().ok()?;
    let rows = |normal: Triple| forms.map(|f| form::of_pivot(&f, normal));
    let along = |x: f64, y: f64| [Double::exactly(x), Double::exactly(y), Double::ZERO];
    let p = space::determinant(rows(along(1.0, 0.0)));
    let q = space::determinant(rows(along(0.0, 1.0)));
    if !(p.hi.hypot(q.hi) > NOUGHT) {
        return None;
    }
    let normal = space::leveled([q, -p, Double::ZERO])?;
    guidance.dyad(space::kernel(&rows(normal))?, normal)
}

/// The circle-point curve, in a frame with its real point at infinity in the direction of y.
struct PinCurve {
    forms: [Form; 3],
    offsets: [Vec2<Double>; 2],
    /// The x axis of that frame.
    direction: Vec2<Double>,
    /// The coefficients of y^2, y and 1, by powers of x.
    alpha: Vec<Double>,
    beta: Vec<Double>,
    gamma: Vec<Double>,
    discriminant: Vec<Double>,
    /// The x of a line contained in the curve; the rest is not a cubic then.
    line: Option<Double>,
    is_cubic: bool,
}

/// An interval of x covered by a part of the curve, or a line.
pub(super) enum Run {
    /// Both roots, from the first x to the second and back; open at an end beyond which the curve
    /// continues.
    Over {
        low: Double,
        high: Double,
        is_closed: [bool; 2],
    },
    /// All y at this x.
    Line(Double),
}

impl PinCurve {
    /// Sets up the curve. Returns `None` if every pin has a pivot.
    fn new(forms: [Form; 3], offsets: [Vec2<Double>; 2]) -> Option<PinCurve> {
        // With a pin at infinity the determinant is (x^2 + y^2) (p x + q y).
        let far = |x: f64, y: f64| [Double::exactly(x), Double::exactly(y), Double::ZERO];
        let at_infinity = |pin| space::determinant(forms.map(|f| form::of_pin(&f, pin)));
        let (p, q) = (at_infinity(far(1.0, 0.0)), at_infinity(far(0.0, 1.0)));
        let axis = Vec2::new(p, q);
        let is_cubic = axis.nearest().norm() > NOUGHT;
        let direction = if is_cubic {
            axis / axis.norm()
        } else {
            Double::unit(0.0)
        };
        let turned = forms.map(|f| form::turned(&f, direction));
        let columns = turned.map(|f| form::columns(&f));
        let cubic = polynomial::determinant([&columns[0], &columns[1], &columns[2]]);
        let [alpha, beta, gamma] = in_y(&cubic, is_cubic);
        let mut curve = PinCurve {
            forms: turned,
            offsets,
            direction,
            alpha,
            beta,
            gamma,
            discriminant: Vec::new(),
            line: None,
            is_cubic,
        };
        let all = [&curve.alpha, &curve.beta, &curve.gamma];
        if !(all.iter().any(|p| polynomial::largest(p) > NOUGHT)) {
            return None;
        }
        curve.split_off_line();
        let square = polynomial::product(&curve.beta, &curve.beta);
        let product = polynomial::product(&curve.alpha, &curve.gamma);
        curve.discriminant = polynomial::plus(&square, -4.0, &product);
        Some(curve)
    }

    /// Splits a cubic that contains a line into this line, in the direction of its real point at
    /// infinity, and a circle.
    fn split_off_line(&mut self) {
        if !self.is_cubic || !(self.alpha[1].hi.abs() > NOUGHT) {
            return;
        }
        let x = -self.alpha[0] / self.alpha[1];
        let extent = x.hi.abs().max(1.0);
        let is_nought = |p: &[Double], power: i32| {
            polynomial::value(p, x).hi.abs() <= NOUGHT * polynomial::largest(p) * extent.powi(power)
        };
        if is_nought(&self.beta, 2) && is_nought(&self.gamma, 3) {
            for part in [&mut self.alpha, &mut self.beta, &mut self.gamma] {
                *part = polynomial::deflated(part, x);
            }
            self.line = Some(x);
        }
    }

    /// Returns the intervals with D >= 0, including single points, and the line.
    fn runs(&self) -> Vec<Run> {
        let within = if self.is_cubic {
            MAX_DISTANCE
        } else {
            MAX_CURVE_EXTENT
        };
        let roots = polynomial::real_roots(&self.discriminant, within);
        let mut ends = vec![Double::exactly(-within)];
        ends.extend(&roots.crossed);
        ends.push(Double::exactly(within));
        let last = ends.len().saturating_sub(2);
        let mut runs: Vec<Run> = Vec::new();
        for (k, pair) in ends.windows(2).enumerate() {
            let middle = (pair[0] + pair[1]).scaled(0.5);
            if polynomial::value(&self.discriminant, middle).hi > 0.0 {
                runs.push(Run::Over {
                    low: pair[0],
                    high: pair[1],
                    is_closed: [k > 0, k < last],
                });
            }
        }
        let point = |x: &Double| Run::Over {
            low: *x,
            high: *x,
            is_closed: [true; 2],
        };
        runs.extend(roots.touched.iter().map(point));
        runs.extend(self.line.map(Run::Line));
        runs
    }

    /// Returns pin and pivot at s degrees of a run.
    fn spot(&self, run: &Run, s: f64) -> Option<CurveSpot> {
        let half = Double::unit(0.5 * s);
        let pin = match *run {
            Run::Line(x) => [x * half.x, half.y, half.x],
            Run::Over { low, high, .. } => {
                // Measured from the nearer end, since D depends on the distance to it.
                let x = if half.x.hi.abs() < half.y.hi.abs() {
                    low + (high - low) * half.x * half.x
                } else {
                    high - (high - low) * half.y * half.y
                };
                let (y, over) = self.root(x, half.x.hi >= 0.0)?;
                [x * over, y, over]
            }
        };
        let pin = space::leveled(pin)?;
        let pivot = space::kernel(&self.forms.map(|f| form::of_pin(&f, pin)))?;
        let pin = form::turned_back(pin, self.direction);
        let seen = [(pin, self.offsets[0]), (pivot, self.offsets[1])];
        let seen = seen.map(|([x, y, w], offset)| [x + offset.x * w, y + offset.y * w, w]);
        Some(CurveSpot { pin, pivot, seen })
    }

    /// Returns the y at an x as a ratio: the root with the positive square root of D, or the other
    /// one, both without cancellation.
    fn root(&self, x: Double, is_upper: bool) -> Option<(Double, Double)> {
        let at = |p: &[Double]| polynomial::value(p, x);
        let (alpha, beta, gamma) = (at(&self.alpha), at(&self.beta), at(&self.gamma));
        let square = at(&self.discriminant);
        let root = if square.hi > 0.0 {
            square.sqrt()
        } else {
            Double::ZERO
        };
        let is_negative = beta.hi < 0.0;
        let sum = if is_negative {
            root - beta
        } else {
            -beta - root
        };
        let ratio = if is_upper == is_negative && sum.hi != 0.0 || gamma.hi == 0.0 {
            (sum, alpha.scaled(2.0))
        } else {
            (gamma.scaled(2.0), sum)
        };
        (ratio.0.hi != 0.0 || ratio.1.hi != 0.0).then_some(ratio)
    }
}

/// Returns a cubic by powers of y. If its highest terms are rounding errors, it is a conic times
/// the line at infinity.
fn in_y(cubic: &PlaneCubic, is_cubic: bool) -> [Vec<Double>; 3] {
    let degree = if is_cubic { 3 } else { 2 };
    [2, 1, 0].map(|y| (0..=degree - y).map(|x| cubic[x][y]).collect())
}
