//! Dyads with a guide: RRP, a circle and a line; PRP and RPP, two lines.

use super::{ACCELERATION, Arm, Outcome, REACH_SLACK, VELOCITY};
use crate::solver::state::{LinkState, PointState, State};
use crate::{Constant, LinkId, Number, PointId, Vec2};

/// Two directions whose sine is below this are parallel: the rounding of two products of unit
/// vectors. Guides that differ by 2^-40 are told apart.
const PARALLEL: f64 = 8.0 * 0.5 * f64::EPSILON;

/// A line that is fixed in a body: through a point, along a direction of a link's frame.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Line {
    pub through: PointId,
    pub link: LinkId,
    /// The direction in the link's frame: a unit vector.
    pub along: Vec2<Constant>,
}

/// A line at one state: its point, direction and turning.
#[derive(Clone, Copy)]
pub(in crate::solver) struct Guide<T = f64> {
    pub(in crate::solver) q: PointState<T>,
    pub(in crate::solver) t: Vec2<T>,
    pub(in crate::solver) n: Vec2<T>,
    pub(in crate::solver) w: T,
    pub(in crate::solver) a: T,
}

impl Line {
    #[inline(always)]
    pub(in crate::solver) fn at<T: Number>(&self, state: &State<T>) -> Guide<T> {
        let link = state.links[self.link.index()];
        let t = Vec2::of(self.along).turned(link.d);
        Guide {
            q: state.points[self.through.index()],
            t,
            n: t.perp(),
            w: link.w,
            a: link.a,
        }
    }
}

impl<T: Number> Guide<T> {
    /// The point at s along the guide, with its rate and second rate.
    #[inline(always)]
    fn point(&self, s: T, rate: T, second: T) -> PointState<T> {
        PointState {
            p: self.q.p + self.t * s,
            v: self.velocity(s) + self.t * rate,
            a: self.acceleration(s, rate) + self.t * second,
        }
    }

    /// The velocity of the guide's own material at s.
    #[inline(always)]
    fn velocity(&self, s: T) -> Vec2<T> {
        self.q.v + self.n * (self.w * s)
    }

    /// The acceleration at s of what slides at a constant rate: with Coriolis' part.
    #[inline(always)]
    fn acceleration(&self, s: T, rate: T) -> Vec2<T> {
        let turning = self.a * s + (self.w * rate).scaled(2.0);
        self.q.a + self.n * turning - self.t * (self.w * self.w * s)
    }
}

/// What a line at distance h0 from a circle's centre cuts off: half the chord is the root of
/// (b - h0)(b + h0).
struct Chord<T> {
    product: T,
    /// How far the line is from just touching the circle on either side, and the rounding of that.
    reaches: [T; 2],
    slack: T,
}

impl<T: Number> Chord<T> {
    #[inline(always)]
    fn new(length: T, h0: T, from: Vec2<T>) -> Chord<T> {
        let (left, right) = (length - h0, length + h0);
        Chord {
            product: left * right,
            reaches: [left, right],
            slack: (length + from.x.abs() + from.y.abs()).scaled(REACH_SLACK * T::GRAIN),
        }
    }

    #[inline(always)]
    fn is_clear(&self) -> bool {
        let [left, right] = self.reaches;
        left.exceeds(self.slack) && right.exceeds(self.slack)
    }

    /// Whether within rounding the line touches the circle.
    fn touches(&self) -> bool {
        let touches = |reach: T| reach.is_finite() && !(-self.slack).exceeds(reach);
        self.reaches.into_iter().all(touches)
    }
}

/// A circle and a line, RRP. The sign is the side along the line on which the point lies, seen from
/// the foot of the pivot.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct CircleLine {
    pub point: PointId,
    pub arm: Arm,
    pub line: Line,
    /// 1 / length^2, which makes the product of the distances the square of a sine.
    inverse_square: f64,
    pub group: usize,
}

impl CircleLine {
    pub(in crate::solver) fn new(point: PointId, arm: Arm, line: Line, group: usize) -> CircleLine {
        CircleLine {
            point,
            arm,
            line,
            inverse_square: arm.length.hi.powi(-2),
            group,
        }
    }

    /// The guide, the pivot as seen from its point, and h0 = n.(P - Q) with what it cuts off.
    #[inline(always)]
    fn chord<T: Number>(&self, state: &State<T>) -> (Guide<T>, Vec2<T>, T, Chord<T>) {
        let guide = self.line.at(state);
        let from = state.points[self.arm.pivot.index()].p - guide.q.p;
        let h0 = guide.n.dot(from);
        let chord = Chord::new(T::of(self.arm.length), h0, from);
        (guide, from, h0, chord)
    }

    /// root = s sqrt((b - h0)(b + h0)): X = Q + (t.(P - Q) + root) t, e = root t - h0 n.
    #[inline(always)]
    pub(super) fn run<T: Number, const ORDER: u8>(&self, state: &mut State<T>) -> Outcome {
        let (guide, from, h0, chord) = self.chord(state);
        state.measures[self.group] = chord.product * T::exactly(self.inverse_square);
        if !chord.is_clear() {
            return Outcome::Unclear;
        }
        let root = state.signs[self.group] * chord.product.sqrt();
        let e = guide.t * root - guide.n * h0;
        self.place::<T, ORDER>(&guide, guide.t.dot(from) + root, e, [h0, root], state);
        Outcome::Done
    }

    /// Writes the dyad with X = P + e at s along the guide, e = root t - h0 n. The constraint
    /// n.(V - V_line) = 0 gives w n.(k x e) = w root.
    #[inline(always)]
    pub(in crate::solver) fn place<T: Number, const ORDER: u8>(
        &self,
        guide: &Guide<T>,
        s: T,
        e: Vec2<T>,
        [h0, root]: [T; 2],
        state: &mut State<T>,
    ) {
        let mut link = LinkState::fixed(self.arm.direction(e));
        let (mut rate, mut second) = (T::default(), T::default());
        if ORDER >= VELOCITY {
            let p = state.points[self.arm.pivot.index()];
            let scale = T::exactly(1.0) / root;
            let dv = guide.velocity(s) - p.v;
            link.w = guide.n.dot(dv) * scale;
            rate = link.w * h0 - guide.t.dot(dv);
            if ORDER >= ACCELERATION {
                let da = guide.acceleration(s, rate) - p.a;
                let w2 = link.w * link.w;
                link.a = (guide.n.dot(da) - w2 * h0) * scale;
                second = link.a * h0 - w2 * root - guide.t.dot(da);
            }
        }
        state.points[self.point.index()] = guide.point(s, rate, second);
        state.links[self.arm.link.index()] = link;
    }

    /// Whether within rounding the arm reaches the guide.
    pub(super) fn is_in_reach<T: Number>(&self, state: &State<T>) -> bool {
        self.chord(state).3.touches()
    }

    /// The arm across the guide: positions alone.
    pub(super) fn align<T: Number>(&self, state: &mut State<T>) {
        let (guide, from, h0, _) = self.chord(state);
        let (e, s) = (-guide.n * h0, guide.t.dot(from));
        self.place::<T, { super::POSITION }>(&guide, s, e, [h0, T::default()], state);
    }
}

/// A circle and a line that does not move, RRP: by far the most frequent kind of slide.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct CircleRail {
    pub point: PointId,
    pub arm: Arm,
    /// A point of the rail and its direction, a unit vector.
    pub through: Vec2<Constant>,
    pub along: Vec2<Constant>,
    /// The direction of the arm's link where the arm lies along the rail.
    aligned: Vec2<Constant>,
    inverse_square: f64,
    pub group: usize,
}

impl CircleRail {
    pub(in crate::solver) fn new(
        point: PointId,
        arm: Arm,
        [through, along]: [Vec2<Constant>; 2],
        group: usize,
    ) -> CircleRail {
        CircleRail {
            point,
            arm,
            through,
            along,
            aligned: along.turned(arm.factor),
            inverse_square: arm.length.hi.powi(-2),
            group,
        }
    }

    /// t.v and n.v.
    #[inline(always)]
    fn seen<T: Number>(&self, v: Vec2<T>) -> Vec2<T> {
        v.turned(Vec2::of(self.along).conj())
    }

    /// Where the pivot is along the rail and beside it, and what the rail cuts off.
    #[inline(always)]
    fn chord<T: Number>(&self, state: &State<T>) -> (Vec2<T>, Chord<T>) {
        let from = state.points[self.arm.pivot.index()].p - Vec2::of(self.through);
        let seen = self.seen(from);
        (seen, Chord::new(T::of(self.arm.length), seen.y, from))
    }

    /// As [`CircleLine`], with a line whose velocity and acceleration are zero: e = t (root - i h0).
    #[inline(always)]
    pub(super) fn run<T: Number, const ORDER: u8>(&self, state: &mut State<T>) -> Outcome {
        let (Vec2 { x: along, y: h0 }, chord) = self.chord(state);
        state.measures[self.group] = chord.product * T::exactly(self.inverse_square);
        if !chord.is_clear() {
            return Outcome::Unclear;
        }
        let root = state.signs[self.group] * chord.product.sqrt();
        let d = Vec2::of(self.aligned).turned(Vec2::new(root, -h0));
        self.place::<T, ORDER>(along + root, d, [h0, root], state);
        Outcome::Done
    }

    /// Writes the dyad with X at s along the rail, the link in the direction d.
    #[inline(always)]
    pub(in crate::solver) fn place<T: Number, const ORDER: u8>(
        &self,
        s: T,
        d: Vec2<T>,
        [h0, root]: [T; 2],
        state: &mut State<T>,
    ) {
        let t = Vec2::of(self.along);
        let mut link = LinkState::fixed(d);
        let mut point = PointState::fixed(Vec2::of(self.through) + t * s);
        if ORDER >= VELOCITY {
            let p = state.points[self.arm.pivot.index()];
            let scale = T::exactly(1.0) / root;
            let v = self.seen(p.v);
            link.w = -v.y * scale;
            point.v = t * (link.w * h0 + v.x);
            if ORDER >= ACCELERATION {
                let (a, w2) = (self.seen(p.a), link.w * link.w);
                link.a = -(a.y + w2 * h0) * scale;
                point.a = t * (link.a * h0 - w2 * root + a.x);
            }
        }
        state.points[self.point.index()] = point;
        state.links[self.arm.link.index()] = link;
    }

    /// As [`CircleLine::is_in_reach`].
    pub(super) fn is_in_reach<T: Number>(&self, state: &State<T>) -> bool {
        self.chord(state).1.touches()
    }

    /// As [`CircleLine::align`].
    pub(super) fn align<T: Number>(&self, state: &mut State<T>) {
        let (Vec2 { x: along, y: h0 }, _) = self.chord(state);
        let d = self.arm.direction(-Vec2::of(self.along).perp() * h0);
        self.place::<T, { super::POSITION }>(along, d, [h0, T::default()], state);
    }
}

/// The meeting of two lines: X = Z1 + l t1 with l = n2.(Z2 - Z1) / n2.t1, and the same determinant
/// for the rates, seen along n2.
#[inline(always)]
pub(super) fn meet<T: Number, const ORDER: u8>(
    one: &Guide<T>,
    two: &Guide<T>,
) -> Option<PointState<T>> {
    let det = two.n.dot(one.t);
    if !det.abs().exceeds(T::exactly(PARALLEL)) {
        return None;
    }
    let l = two.n.dot(two.q.p - one.q.p) / det;
    let m = two.t.dot(one.q.p + one.t * l - two.q.p);
    let (mut rate, mut second) = (T::default(), T::default());
    if ORDER >= VELOCITY {
        rate = two.n.dot(two.velocity(m) - one.velocity(l)) / det;
    }
    if ORDER >= ACCELERATION {
        let across = two.t.dot(one.velocity(l) + one.t * rate - two.q.v);
        second = two
            .n
            .dot(two.acceleration(m, across) - one.acceleration(l, rate))
            / det;
    }
    Some(one.point(l, rate, second))
}
