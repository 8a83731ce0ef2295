//! Bounds dyads so close to their limit that rounding decides between the two assemblies.
//!
//! Both assemblies lie within half a chord of the position with the arms in line, and the length of
//! that chord is bounded. The position therefore has a bound, about the square root of the rounding
//! error. The rates have none.

use super::UNKNOWN;
use crate::solver::elements::{CircleLine, CircleRail, Circles, POSITION, Swing};
use crate::solver::state::State;
use crate::{Ball, LinkId, Number, PointId, Vec2};

/// Returns an upper bound of the square root of a product that is about zero.
fn sqrt_bound(product: Ball) -> f64 {
    (product.mid + product.radius).max(0.0).sqrt() * (1.0 + f64::EPSILON)
}

fn widened(v: Vec2<Ball>, more: f64) -> Vec2<Ball> {
    v.map(|v| v.widened(more))
}

/// Marks the rates of a point and of links as unknown.
fn stop(point: Option<PointId>, links: &[LinkId], enclosure: &mut State<Ball>) {
    let none = Vec2::new(UNKNOWN, UNKNOWN);
    if let Some(point) = point {
        let point = &mut enclosure.points[point.index()];
        (point.v, point.a) = (none, none);
    }
    for link in links {
        let link = &mut enclosure.links[link.index()];
        (link.w, link.a) = (UNKNOWN, UNKNOWN);
    }
}

impl Circles {
    /// Encloses X = P + u x / u.u, at most h / |u| from there.
    pub(super) fn enclose_stretched(&self, enclosure: &mut State<Ball>) -> bool {
        let p = enclosure.points[self.near.pivot.index()].p;
        let u = enclosure.points[self.far.pivot.index()].p - p;
        let (b, c) = (Ball::of(self.near.length), Ball::of(self.far.length));
        let (d2, d) = (u.norm2(), u.norm());
        let reach = (d - (c - b).abs()) * (d + (c - b).abs()) * ((b + c) - d) * ((b + c) + d);
        let x = (d2 + (b - c) * (b + c)).scaled(0.5);
        let half_chord = sqrt_bound(reach.scaled(0.25)) / d.smallest();
        let e = widened(u * (x / d2), half_chord);
        if !(half_chord < f64::INFINITY && e.x.radius + e.y.radius < f64::INFINITY) {
            return false;
        }
        self.place::<Ball, POSITION>(e, e - u, Ball::default(), enclosure);
        stop(
            Some(self.point),
            &[self.near.link, self.far.link],
            enclosure,
        );
        true
    }
}

impl CircleLine {
    /// Encloses X = P - h0 n, at most half a chord from there.
    pub(super) fn enclose_stretched(&self, enclosure: &mut State<Ball>) -> bool {
        let guide = self.line.at(enclosure);
        let from = enclosure.points[self.arm.pivot.index()].p - guide.q.p;
        let (h0, b) = (guide.n.dot(from), Ball::of(self.arm.length));
        let root = Ball::new(0.0, sqrt_bound((b - h0) * (b + h0)));
        let e = guide.t * root - guide.n * h0;
        let s = guide.t.dot(from) + root;
        self.place::<Ball, POSITION>(&guide, s, e, [h0, root], enclosure);
        stop(Some(self.point), &[self.arm.link], enclosure);
        s.radius < f64::INFINITY
    }
}

impl CircleRail {
    /// Encloses the joint. As [`CircleLine::enclose_stretched`].
    pub(super) fn enclose_stretched(&self, enclosure: &mut State<Ball>) -> bool {
        let t = Vec2::<Ball>::of(self.along);
        let from = enclosure.points[self.arm.pivot.index()].p - Vec2::of(self.through);
        let (h0, b) = (t.perp().dot(from), Ball::of(self.arm.length));
        let root = Ball::new(0.0, sqrt_bound((b - h0) * (b + h0)));
        let e = t * root - t.perp() * h0;
        let s = t.dot(from) + root;
        self.place::<Ball, POSITION>(s, self.arm.direction(e), [h0, root], enclosure);
        stop(Some(self.point), &[self.arm.link], enclosure);
        s.radius < f64::INFINITY
    }
}

impl Swing {
    /// Encloses t = -i e w / D^2, at most s / D from there.
    pub(super) fn enclose_stretched(&self, enclosure: &mut State<Ball>) -> bool {
        let pivot = enclosure.points[self.pivot.index()].p;
        let w = enclosure.points[self.pin.index()].p - pivot;
        let (d, e) = (w.norm(), Ball::of(self.offset));
        let s = Ball::new(0.0, sqrt_bound((d - e.abs()) * (d + e.abs())));
        let t = w.turned(Vec2::new(s, -e)) / w.norm2();
        self.place::<Ball, POSITION>(t, s, enclosure);
        stop(None, &[self.link], enclosure);
        t.x.radius + t.y.radius < f64::INFINITY
    }
}
