//! Bounds of the dyads that place a joint by two constraints: circles and lines.

use crate::arithmetic::{U, half_ulp, two_product, two_sum};
use crate::solver::state::{PointState, State};
use crate::solver::step::{CircleLine, CircleRail, Circles, Cylinder};
use crate::{Ball, Constant, Vec2};

/// What the residuals in twice the precision still round, in parts of the square of the length.
const RESIDUAL: f64 = 32.0 * U * U;
/// The part of a bound by which it may grow from what the matrix changes within it: beyond, nothing
/// is proved.
const CONTRACTION: f64 = 0.25;
/// The rounding of an inverse of two rows, in units of its condition number.
const INVERSE: f64 = 16.0 * U;

/// One constraint on X at the place where X was computed to be.
struct Row {
    /// Its derivative by X, and by how much (in length) it may differ.
    gradient: Vec2,
    wobble: f64,
    /// Its value there, and how far that may be from the true one.
    residual: f64,
    fuzz: f64,
    /// How fast the gradient changes with X.
    curvature: f64,
}

impl Row {
    /// (|X - P|^2 - b^2) / 2.
    #[inline]
    fn circle(x: Vec2, p: &PointState<Ball>, square: Constant) -> Row {
        let (ex, ex_rest) = two_sum(x.x, -p.p.x.mid);
        let (ey, ey_rest) = two_sum(x.y, -p.p.y.mid);
        let ((xx, xx_rest), (yy, yy_rest)) = (two_product(ex, ex), two_product(ey, ey));
        // Largest terms first; what each sum loses joins the small ones.
        let (sum, lost) = two_sum(xx, yy);
        let (rest, lost_too) = two_sum(sum, -square.hi);
        let small = (lost + lost_too) + (xx_rest + yy_rest) + 2.0 * (ex * ex_rest + ey * ey_rest)
            - square.lo;
        let Vec2 { x: rx, y: ry } = p.p.map(|v| v.radius);
        let moved = ex.abs() * rx + ey.abs() * ry + 0.5 * (rx * rx + ry * ry);
        Row {
            gradient: Vec2::new(ex, ey),
            wobble: rx + ry + U * (ex.abs() + ey.abs()),
            residual: 0.5 * (rest + small),
            fuzz: moved
                + 0.5 * square.radius
                + RESIDUAL * square.hi
                + U * (0.5 * (rest + small)).abs(),
            curvature: 1.0,
        }
    }

    /// n.(X - Q).
    #[inline]
    fn line(x: Vec2, n: Vec2<Ball>, rest: Vec2, q: Vec2<Ball>) -> Row {
        let (dx, dx_rest) = two_sum(x.x, -q.x.mid);
        let (dy, dy_rest) = two_sum(x.y, -q.y.mid);
        let ((xx, xx_rest), (yy, yy_rest)) = (two_product(n.x.mid, dx), two_product(n.y.mid, dy));
        let (sum, lost) = two_sum(xx, yy);
        let small = lost
            + (xx_rest + yy_rest)
            + (n.x.mid * dx_rest + n.y.mid * dy_rest)
            + (rest.x * dx + rest.y * dy);
        let size = dx.abs() + dy.abs();
        let turned = dx.abs() * n.x.radius + dy.abs() * n.y.radius;
        let moved = (n.x.largest()) * q.x.radius + (n.y.largest()) * q.y.radius;
        Row {
            gradient: Vec2::new(n.x.mid, n.y.mid),
            wobble: n.x.radius + n.y.radius + U,
            residual: sum + small,
            fuzz: turned + moved + RESIDUAL * size + U * (sum + small).abs(),
            curvature: 0.0,
        }
    }
}

/// Where X truly is, if two constraints prove it to be near.
#[inline]
fn enclose(x: Vec2, [a, b]: [Row; 2]) -> Option<Vec2<Ball>> {
    let (g, h) = (a.gradient, b.gradient);
    let inverse = 1.0 / g.cross(h);
    // The columns of the inverse matrix.
    let (first, second) = (
        Vec2::new(h.y, -h.x) * inverse,
        Vec2::new(-g.y, g.x) * inverse,
    );
    let norm = (first.norm2() + second.norm2()).sqrt();
    let condition = norm * (g.norm2() + h.norm2()).sqrt();
    let spread = |ra: f64, rb: f64| {
        Vec2::new(
            first.x.abs() * ra + second.x.abs() * rb,
            first.y.abs() * ra + second.y.abs() * rb,
        )
    };
    let fuzz = spread(a.fuzz, b.fuzz);
    let shift = -(first * a.residual + second * b.residual);
    let step = spread(a.residual.abs(), b.residual.abs()) + fuzz;
    let reach = step.x + step.y;
    let curvature = (a.curvature + b.curvature).sqrt();
    // Within twice the step the matrix changes by no more than this part of itself.
    let change = INVERSE * condition + norm * (a.wobble + b.wobble + curvature * 2.0 * reach);
    // Written so that NaN proves nothing.
    if !(change <= CONTRACTION) {
        return None;
    }
    let more = change * reach / (1.0 - change);
    let middle = x + shift;
    let round = |step: f64, middle: f64| 4.0 * U * step + half_ulp(middle);
    Some(Vec2::new(
        Ball::new(middle.x, fuzz.x + more + round(step.x, middle.x)),
        Ball::new(middle.y, fuzz.y + more + round(step.y, middle.y)),
    ))
}

impl Circles {
    #[inline]
    pub(super) fn enclose<const ORDER: u8>(
        &self,
        state: &State,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let x = state.points[self.point.index()].p;
        let near = enclosure.points[self.near.pivot.index()];
        let far = enclosure.points[self.far.pivot.index()];
        let rows = [
            Row::circle(x, &near, self.near.square),
            Row::circle(x, &far, self.far.square),
        ];
        let Some(x) = enclose(x, rows) else {
            return false;
        };
        let (e, f) = (x - near.p, x - far.p);
        self.place::<Ball, ORDER>(e, f, e.cross(f), enclosure);
        enclosure.points[self.point.index()].p = x;
        true
    }
}

impl Cylinder {
    pub(super) fn enclose<const ORDER: u8>(
        &self,
        q: Ball,
        state: &State,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let x = state.points[self.point.index()].p;
        let pivot = enclosure.points[self.pivot.index()];
        let far = enclosure.points[self.far.pivot.index()];
        let pushed = Constant {
            hi: q.mid,
            lo: 0.0,
            radius: q.radius,
        };
        let square = self.arm_square(pushed);
        let rows = [
            Row::circle(x, &pivot, square),
            Row::circle(x, &far, self.far.square),
        ];
        let Some(x) = enclose(x, rows) else {
            return false;
        };
        let (e, f) = (x - pivot.p, x - far.p);
        self.place::<Ball, ORDER>(q, e, f, e.cross(f), enclosure);
        enclosure.points[self.point.index()].p = x;
        true
    }
}

impl CircleLine {
    pub(super) fn enclose<const ORDER: u8>(
        &self,
        state: &State,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let x = state.points[self.point.index()].p;
        let pivot = enclosure.points[self.arm.pivot.index()];
        let guide = self.line.at(enclosure);
        let rows = [
            Row::circle(x, &pivot, self.arm.square),
            Row::line(x, guide.n, Vec2::ZERO, guide.q.p),
        ];
        let Some(x) = enclose(x, rows) else {
            return false;
        };
        let e = x - pivot.p;
        let (h0, root) = (-guide.n.dot(e), guide.t.dot(e));
        let s = guide.t.dot(x - guide.q.p);
        self.place::<Ball, ORDER>(&guide, s, e, [h0, root], enclosure);
        enclosure.points[self.point.index()].p = x;
        true
    }
}

impl CircleRail {
    pub(super) fn enclose<const ORDER: u8>(
        &self,
        state: &State,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let x = state.points[self.point.index()].p;
        let pivot = enclosure.points[self.arm.pivot.index()];
        let (t, q) = (self.along, Vec2::<Ball>::of(self.through));
        let n = t.perp();
        // Its second half is taken into the residual; only what was meant can be elsewhere.
        let meant = n.map(|v| Ball::new(v.hi, v.radius));
        let rows = [
            Row::circle(x, &pivot, self.arm.square),
            Row::line(x, meant, n.map(|v| v.lo), q),
        ];
        let Some(x) = enclose(x, rows) else {
            return false;
        };
        let (t, n) = (Vec2::<Ball>::of(t), Vec2::<Ball>::of(n));
        let e = x - pivot.p;
        let (h0, root) = (-n.dot(e), t.dot(e));
        self.place::<Ball, ORDER>(t.dot(x - q), e, [h0, root], enclosure);
        enclosure.points[self.point.index()].p = x;
        true
    }
}
