//! Dyads with a guide: RRP, a circle and a line; PRP and RPP, two lines.

use super::{ACCELERATION, Arm, Outcome, REACH_SLACK, VELOCITY};
use crate::solver::state::{LinkState, PointState, State};
use crate::{LinkId, PointId, Vec2};

/// Two directions whose sine is below this are parallel: the rounding of two products of unit
/// vectors. Guides that differ by 2^-40 are told apart.
const PARALLEL: f64 = 8.0 * 0.5 * f64::EPSILON;

/// A line that is fixed in a body: through a point, along a direction of a link's frame.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Line {
    pub through: PointId,
    pub link: LinkId,
    /// The direction in the link's frame: a unit vector.
    pub along: Vec2,
}

/// A line at one state: its point, direction and turning.
pub(super) struct Guide {
    pub(super) q: PointState,
    pub(super) t: Vec2,
    pub(super) n: Vec2,
    pub(super) w: f64,
    pub(super) a: f64,
}

impl Line {
    #[inline]
    pub(super) fn at(&self, state: &State) -> Guide {
        let link = state.links[self.link.index()];
        let t = self.along.turned(link.d);
        Guide {
            q: state.points[self.through.index()],
            t,
            n: t.perp(),
            w: link.w,
            a: link.a,
        }
    }
}

impl Guide {
    /// The point at s along the guide, with its rate and second rate.
    #[inline]
    fn point(&self, s: f64, rate: f64, second: f64) -> PointState {
        PointState {
            p: self.q.p + self.t * s,
            v: self.velocity(s) + self.t * rate,
            a: self.acceleration(s, rate) + self.t * second,
        }
    }

    /// The velocity of the guide's own material at s.
    #[inline]
    fn velocity(&self, s: f64) -> Vec2 {
        self.q.v + self.n * (self.w * s)
    }

    /// The acceleration at s of what slides at a constant rate: with Coriolis' part.
    #[inline]
    fn acceleration(&self, s: f64, rate: f64) -> Vec2 {
        self.q.a + self.n * (self.a * s + 2.0 * self.w * rate) - self.t * (self.w * self.w * s)
    }
}

/// What a line at distance h0 from a circle's centre cuts off: half the chord is the root of
/// (b - h0)(b + h0).
struct Chord {
    product: f64,
    outcome: Outcome,
}

impl Chord {
    #[inline]
    fn new(length: f64, h0: f64, from: Vec2) -> Chord {
        let (left, right) = (length - h0, length + h0);
        let slack = REACH_SLACK * (length + from.x.abs() + from.y.abs());
        let reach = left.min(right);
        // Written so that NaN is open.
        let outcome = if reach > slack {
            Outcome::Done
        } else if reach >= -slack {
            Outcome::Stretched
        } else {
            Outcome::Open
        };
        Chord {
            product: left * right,
            outcome,
        }
    }

    /// Half the chord, on one side; nothing is left of it where the line just touches.
    #[inline]
    fn root(&self, sign: f64) -> f64 {
        match self.outcome {
            Outcome::Done => sign * self.product.sqrt(),
            Outcome::Stretched | Outcome::Open => 0.0,
        }
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
            inverse_square: arm.length.powi(-2),
            group,
        }
    }

    /// h0 = n.(P - Q), root = s sqrt((b - h0)(b + h0)): X = Q + (t.(P - Q) + root) t, e = root t - h0 n.
    /// The constraint n.(V - V_line) = 0 gives w n.(k x e) = w root.
    #[inline]
    pub(super) fn run<const ORDER: u8>(&self, state: &mut State) -> Outcome {
        let guide = self.line.at(state);
        let p = state.points[self.arm.pivot.index()];
        let from = p.p - guide.q.p;
        let h0 = guide.n.dot(from);
        let chord = Chord::new(self.arm.length, h0, from);
        state.measures[self.group] = chord.product * self.inverse_square;
        if chord.outcome == Outcome::Open {
            return Outcome::Open;
        }
        let stretched = chord.outcome == Outcome::Stretched;
        let root = chord.root(state.signs[self.group]);
        let s = guide.t.dot(from) + root;
        let e = guide.t * root - guide.n * h0;
        let mut link = LinkState {
            d: e.turned(self.arm.factor),
            ..LinkState::default()
        };
        if stretched {
            state.points[self.point.index()].p = guide.q.p + guide.t * s;
            state.links[self.arm.link.index()].d = link.d;
            return Outcome::Stretched;
        }
        let (mut rate, mut second) = (0.0, 0.0);
        if ORDER >= VELOCITY {
            let scale = 1.0 / root;
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
        Outcome::Done
    }
}

/// A circle and a line that does not move, RRP: by far the most frequent kind of slide.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct CircleRail {
    pub point: PointId,
    pub arm: Arm,
    /// A point of the rail and its direction, a unit vector.
    pub through: Vec2,
    pub along: Vec2,
    inverse_square: f64,
    pub group: usize,
}

impl CircleRail {
    pub(in crate::solver) fn new(
        point: PointId,
        arm: Arm,
        [through, along]: [Vec2; 2],
        group: usize,
    ) -> CircleRail {
        CircleRail {
            point,
            arm,
            through,
            along,
            inverse_square: arm.length.powi(-2),
            group,
        }
    }

    /// As [`CircleLine`], with a line whose velocity and acceleration are zero.
    #[inline]
    pub(super) fn run<const ORDER: u8>(&self, state: &mut State) -> Outcome {
        let (t, n) = (self.along, self.along.perp());
        let p = state.points[self.arm.pivot.index()];
        let from = p.p - self.through;
        let h0 = n.dot(from);
        let chord = Chord::new(self.arm.length, h0, from);
        state.measures[self.group] = chord.product * self.inverse_square;
        if chord.outcome == Outcome::Open {
            return Outcome::Open;
        }
        let stretched = chord.outcome == Outcome::Stretched;
        let root = chord.root(state.signs[self.group]);
        let e = t * root - n * h0;
        let mut link = LinkState {
            d: e.turned(self.arm.factor),
            ..LinkState::default()
        };
        let mut point = PointState {
            p: self.through + t * (t.dot(from) + root),
            ..PointState::default()
        };
        if ORDER >= VELOCITY && !stretched {
            let scale = 1.0 / root;
            link.w = -n.dot(p.v) * scale;
            point.v = t * (link.w * h0 + t.dot(p.v));
            if ORDER >= ACCELERATION {
                let w2 = link.w * link.w;
                link.a = -(n.dot(p.a) + w2 * h0) * scale;
                point.a = t * (link.a * h0 - w2 * root + t.dot(p.a));
            }
        }
        state.points[self.point.index()] = point;
        state.links[self.arm.link.index()] = link;
        if stretched {
            Outcome::Stretched
        } else {
            Outcome::Done
        }
    }
}

/// The meeting of two lines: X = Z1 + l t1 with l = n2.(Z2 - Z1) / n2.t1, and the same determinant
/// for the rates, seen along n2.
pub(super) fn meet<const ORDER: u8>(one: &Guide, two: &Guide) -> Option<PointState> {
    let det = two.n.dot(one.t);
    let l = two.n.dot(two.q.p - one.q.p) / det;
    if det.abs() <= PARALLEL || !l.is_finite() {
        return None;
    }
    let m = two.t.dot(one.q.p + one.t * l - two.q.p);
    let (mut rate, mut second) = (0.0, 0.0);
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
