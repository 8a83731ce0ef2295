//! Dyads in series, at their own change points.
//!
//! There the product under a dyad's root has a double zero, h^2 = t^2 (c2 + c3 t + ...), so that
//! h = +-t sqrt(c2 + c3 t + ...) is a series, and with it everything that the dyad places: its
//! tangents, its second and its higher derivatives. (The two signs are the two roots of the
//! second-order tangents' quadratic; here one of them is chosen already, by the motion.) Where the
//! pivots of equal arms meet, or a pin meets the pivot that its guide runs through, the distance has a
//! double zero as well, and the common factor is divided out.
//!
//! The products are written as polynomials of the distance squared: its root is no series where the
//! distance vanishes.

use super::{CircleLine, CircleRail, Circles, Cylinder, Dyad, Outcome, POSITION, Swing};
use crate::arithmetic::Series;
use crate::solver::state::State;
use crate::{Number, Vec2};

/// A squared distance below this part of the squares of the arms is a double zero.
const MEETING: f64 = 1e-24;

impl Dyad<'_> {
    /// Places it at a change point, t before and behind it; `side` is the sign that its group has
    /// for positive t.
    pub(in crate::solver) fn run_through(
        self,
        q: Series,
        side: f64,
        state: &mut State<Series>,
    ) -> Outcome {
        match self {
            Dyad::Circles(c) => c.run_through(side, state),
            Dyad::CircleLine(c) => c.run_through(side, state),
            Dyad::CircleRail(c) => c.run_through(side, state),
            Dyad::Swing(s) => s.run_through(side, state),
            Dyad::Cylinder(c) => c.run_through(q, side, state),
        }
    }
}

/// The root of a product with a double zero: `side` is its sign for positive t.
fn root(product: Series, side: f64) -> Option<Series> {
    let square = product.lowered(2);
    let root = (square.nearest() > 0.0).then(|| square.sqrt().raised(1))?;
    Some(if side < 0.0 { -root } else { root })
}

/// A quotient whose divisor may begin with t^2, and the dividend then with it.
fn quotient(dividend: Vec2<Series>, divisor: Series, size: f64) -> Vec2<Series> {
    if divisor.nearest().abs() > MEETING * size {
        return dividend / divisor;
    }
    dividend.map(|v| v.lowered(2)) / divisor.lowered(2)
}

impl Circles {
    fn run_through(&self, side: f64, state: &mut State<Series>) -> Outcome {
        let p = state.points[self.near.pivot.index()].p;
        let u = state.points[self.far.pivot.index()].p - p;
        let (b, c) = (self.near.length, self.far.length);
        let [least, most, squares] =
            [(c - b) * (c - b), (c + b) * (c + b), (b - c) * (b + c)].map(Series::of);
        let d2 = u.norm2();
        let Some(root) = root((d2 - least) * (most - d2), side) else {
            return Outcome::Open;
        };
        let (x, sh) = ((d2 + squares).scaled(0.5), root.scaled(0.5));
        let e = quotient(u * x + u.perp() * sh, d2, most.nearest());
        self.place::<Series, POSITION>(e, e - u, sh, state);
        Outcome::Done
    }
}

impl Cylinder {
    fn run_through(&self, q: Series, side: f64, state: &mut State<Series>) -> Outcome {
        let p = state.points[self.pivot.index()].p;
        let u = state.points[self.far.pivot.index()].p - p;
        let rho2 = self.arm_square(q);
        let c2 = Series::of(self.far.length * self.far.length);
        let d2 = u.norm2();
        let twice = rho2 + c2 - d2;
        let Some(root) = root((rho2 * c2).scaled(4.0) - twice * twice, side) else {
            return Outcome::Open;
        };
        let (x, sh) = ((d2 + rho2 - c2).scaled(0.5), root.scaled(0.5));
        let e = quotient(u * x + u.perp() * sh, d2, (rho2 + c2).nearest());
        self.place::<Series, POSITION>(q, e, e - u, sh, state);
        Outcome::Done
    }
}

impl CircleRail {
    fn run_through(&self, side: f64, state: &mut State<Series>) -> Outcome {
        let along = Vec2::of(self.along);
        let from = state.points[self.arm.pivot.index()].p - Vec2::of(self.through);
        let h0 = along.cross(from);
        let b = Series::of(self.arm.length);
        let Some(root) = root((b - h0) * (b + h0), side) else {
            return Outcome::Open;
        };
        let e = along * root - along.perp() * h0;
        self.place::<Series, POSITION>(along.dot(from) + root, e, [h0, root], state);
        Outcome::Done
    }
}

impl CircleLine {
    fn run_through(&self, side: f64, state: &mut State<Series>) -> Outcome {
        let guide = self.line.at(state);
        let from = state.points[self.arm.pivot.index()].p - guide.q.p;
        let h0 = guide.n.dot(from);
        let b = Series::of(self.arm.length);
        let Some(root) = root((b - h0) * (b + h0), side) else {
            return Outcome::Open;
        };
        let e = guide.t * root - guide.n * h0;
        self.place::<Series, POSITION>(&guide, guide.t.dot(from) + root, e, [h0, root], state);
        Outcome::Done
    }
}

impl Swing {
    fn run_through(&self, side: f64, state: &mut State<Series>) -> Outcome {
        let w = state.points[self.pin.index()].p - state.points[self.pivot.index()].p;
        let e = Series::of(self.offset);
        let d2 = w.norm2();
        let Some(s) = root(d2 - e * e, side) else {
            return Outcome::Open;
        };
        let t = quotient(w.turned(Vec2::new(s, -e)), d2, 1.0);
        self.place::<Series, POSITION>(t, s, state);
        Outcome::Done
    }
}
