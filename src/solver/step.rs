//! The elementary steps of a plan, in closed form.
//!
//! A step reads points and links that earlier steps have placed and places a few more, with the
//! first and second derivatives by the driver's coordinate. Notation: P, Q known points, X the point
//! sought; e = X - P; t the direction of a guide and n = k x t its normal; (V, w) and (A, alpha)
//! first and second derivatives of points and angles.

use super::state::{LinkState, PointState, State};
use crate::{LinkId, PointId, SlideId, Vec2};

/// How many derivatives a solve carries, as a constant of the compiled code.
pub(super) const POSITION: u8 = 0;
pub(super) const VELOCITY: u8 = 1;
pub(super) const ACCELERATION: u8 = 2;

/// How far beyond its reach a group still counts as just stretched: 4 u of the lengths, the
/// rounding of a computed distance. Less would refuse limits that were typed in exactly; more would
/// clamp states that really are open.
const REACH_SLACK: f64 = 4.0 * 0.5 * f64::EPSILON;

/// Two directions whose sine is below this are parallel: the rounding of two products of unit
/// vectors. Guides that differ by 2^-40 are told apart.
const PARALLEL: f64 = 8.0 * 0.5 * f64::EPSILON;

/// What became of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// Solved.
    Done,
    /// Stretched to its limit: positions are given, derivatives do not exist.
    Stretched,
    /// Cannot close.
    Open,
}

/// The end of an arm in the frame of its link, as a complex factor: direction = arm * factor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arm {
    /// The known end.
    pub pivot: PointId,
    /// Its length.
    pub length: f64,
    /// The link whose direction it tells.
    pub link: LinkId,
    /// The conjugate of the arm in the link's frame over the square of its length.
    pub factor: Vec2,
}

impl Arm {
    pub(super) fn new(pivot: PointId, link: LinkId, local: Vec2) -> Arm {
        Arm {
            pivot,
            length: local.norm(),
            link,
            factor: local.conj() / local.norm2(),
        }
    }
}

/// A line that is fixed in a body: through a point, along a direction of a link's frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub through: PointId,
    pub link: LinkId,
    /// The direction in the link's frame: a unit vector.
    pub along: Vec2,
}

/// Two circles, RRR. The shorter arm comes first: the point is measured from its pivot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circles {
    pub point: PointId,
    pub near: Arm,
    pub far: Arm,
    /// +1 where the point lies on the left of near.pivot -> far.pivot.
    pub sign: f64,
    /// far - near and near + far, each as a sum of two doubles: the factors of Kahan's product
    /// for a triangle keep their digits without sorting.
    difference: (f64, f64),
    sum: (f64, f64),
    /// (near - far)(near + far).
    squares: f64,
    /// 1 / (2 near far)^2, which makes the product of the factors the square of a sine.
    inverse_square: f64,
    slack: f64,
    pub group: usize,
}

/// A circle and a line, RRP.
#[derive(Clone, Copy, Debug)]
pub(super) struct CircleLine {
    pub point: PointId,
    pub arm: Arm,
    pub line: Line,
    /// The side along the line on which the point lies, seen from the foot of the pivot.
    pub sign: f64,
    /// 1 / length^2, which makes the product of the distances the square of a sine.
    inverse_square: f64,
    pub group: usize,
}

/// A circle and a line that does not move, RRP: by far the most frequent kind of slide.
#[derive(Clone, Copy, Debug)]
pub(super) struct CircleRail {
    pub point: PointId,
    pub arm: Arm,
    /// A point of the rail and its direction, a unit vector.
    pub through: Vec2,
    pub along: Vec2,
    /// As in [`CircleLine`].
    pub sign: f64,
    inverse_square: f64,
    pub group: usize,
}

/// An arm that turns about a pivot and slides through a pin, RPR.
#[derive(Clone, Copy, Debug)]
pub(super) struct Swing {
    pub pivot: PointId,
    pub pin: PointId,
    pub link: LinkId,
    /// The guide's direction in the link's frame: a unit vector.
    pub along: Vec2,
    /// n.(pin - pivot): how far the guide passes the pivot.
    pub offset: f64,
    /// The sign of t.(pin - pivot).
    pub sign: f64,
    pub group: usize,
}

/// An arm whose end is pushed along a guide of its own link, and a circle: a cylinder.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cylinder {
    pub point: PointId,
    pub pivot: PointId,
    pub link: LinkId,
    /// The guide's point and direction in the frame of the link, from the pivot.
    pub through: Vec2,
    pub along: Vec2,
    pub far: Arm,
    /// +1 where the point lies on the left of pivot -> far.pivot.
    pub sign: f64,
    pub group: usize,
}

/// One elementary step.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    /// The driven link takes the driver's direction.
    Crank { link: LinkId },
    /// A point of the driven link, at `local` from the ground point about which it turns.
    Spin {
        point: PointId,
        pivot: PointId,
        local: Vec2,
    },
    /// A point at `local` on a link, seen from another point of the same link.
    Ride {
        point: PointId,
        base: PointId,
        link: LinkId,
        local: Vec2,
    },
    /// The driven slide: the point lies at `local + along q` on a link, seen from `base`.
    Push {
        point: PointId,
        base: PointId,
        link: LinkId,
        local: Vec2,
        along: Vec2,
    },
    /// The direction of a link both of whose ends are known.
    Aim { arm: Arm, end: PointId },
    /// A link that keeps its angle to another one.
    Lock {
        link: LinkId,
        to: LinkId,
        turn: Vec2,
    },
    /// RRR.
    Circles(Circles),
    /// RRP.
    CircleLine(CircleLine),
    /// RRP on the ground.
    CircleRail(CircleRail),
    /// RPR.
    Swing(Swing),
    /// RRR with a driven arm.
    Cylinder(Cylinder),
    /// PRP and RPP: the meeting of two lines.
    Lines {
        point: PointId,
        first: Line,
        second: Line,
        group: usize,
    },
    /// A coupled group, by its number.
    Coupled { index: usize },
    /// What a slide's table shows.
    Travel {
        slide: SlideId,
        point: PointId,
        line: Line,
    },
}

/// a - b as the rounded difference and what it left out (Knuth's two-sum).
fn two_diff(a: f64, b: f64) -> (f64, f64) {
    let d = a - b;
    let back = d - a;
    (d, (a - (d - back)) - (b + back))
}

impl Circles {
    pub(super) fn new(point: PointId, arms: [Arm; 2], group: usize) -> Circles {
        let [a, b] = arms;
        let (near, far) = if a.length <= b.length { (a, b) } else { (b, a) };
        Circles {
            point,
            near,
            far,
            sign: 1.0,
            difference: two_diff(far.length, near.length),
            sum: two_diff(far.length, -near.length),
            squares: (near.length - far.length) * (near.length + far.length),
            inverse_square: (2.0 * near.length * far.length).powi(-2),
            slack: REACH_SLACK * (near.length + far.length),
            group,
        }
    }

    /// X = P + (x u + s h k x u) / u.u with u = Q - P, x = (u.u + b^2 - c^2) / 2 and h twice the area
    /// of the triangle of sides b, c, |u|: 16 A^2 = (d-m)(d+m)(M-d)(M+d), m = c - b, M = b + c
    /// (Kahan, Miscalculating Area and Angles of a Needle-like Triangle; here m and M carry their
    /// rounding errors, so that no sorting is needed).
    ///
    /// Then V_P + w1 k x e = V_Q + w2 k x f with f = X - Q, and e x f = s h.
    #[inline]
    fn run<const ORDER: u8>(&self, state: &mut State) -> Outcome {
        let p = state.points[self.near.pivot.index()];
        let q = state.points[self.far.pivot.index()];
        let u = q.p - p.p;
        let d2 = u.norm2();
        let d = d2.sqrt();
        let inner = (d - self.difference.0) - self.difference.1;
        let outer = (self.sum.0 - d) + self.sum.1;
        let product = (inner * ((d + self.difference.0) + self.difference.1))
            * (outer * ((self.sum.0 + d) + self.sum.1));
        state.measures[self.group] = product * self.inverse_square;
        let x = 0.5 * (d2 + self.squares);
        let inverse = 1.0 / d2;
        let reach = inner.min(outer);
        // Written so that NaN does not pass.
        if !(reach > self.slack) {
            return self.stretch(reach, p.p, u, x, state);
        }
        let sh = self.sign * (0.5 * product.sqrt());
        let e = (u * x + u.perp() * sh) * inverse;
        let f = e - u;
        let mut point = PointState {
            p: p.p + e,
            ..PointState::default()
        };
        let (mut near, mut far) = (LinkState::default(), LinkState::default());
        near.d = e.turned(self.near.factor);
        far.d = f.turned(self.far.factor);
        if ORDER >= VELOCITY {
            let scale = 1.0 / sh;
            let dv = q.v - p.v;
            near.w = f.dot(dv) * scale;
            far.w = e.dot(dv) * scale;
            point.v = p.v + e.perp() * near.w;
            if ORDER >= ACCELERATION {
                let da = (q.a - p.a) + e * (near.w * near.w) - f * (far.w * far.w);
                near.a = f.dot(da) * scale;
                far.a = e.dot(da) * scale;
                point.a = p.a + e.perp() * near.a - e * (near.w * near.w);
            }
        }
        state.points[self.point.index()] = point;
        state.links[self.near.link.index()] = near;
        state.links[self.far.link.index()] = far;
        Outcome::Done
    }

    /// The arms in line, if within rounding they reach each other: positions alone. Pivots that
    /// within rounding are one give the line no direction.
    #[cold]
    fn stretch(&self, reach: f64, p: Vec2, u: Vec2, x: f64, state: &mut State) -> Outcome {
        let d = u.norm();
        if !(reach >= -self.slack && d > self.slack) {
            return Outcome::Open;
        }
        let e = u * (self.near.length.copysign(x) / d);
        state.points[self.point.index()].p = p + e;
        state.links[self.near.link.index()].d = e.turned(self.near.factor);
        state.links[self.far.link.index()].d = (e - u).turned(self.far.factor);
        Outcome::Stretched
    }
}

/// A line at one state: its point, direction and turning.
struct Guide {
    q: PointState,
    t: Vec2,
    n: Vec2,
    w: f64,
    a: f64,
}

impl Line {
    #[inline]
    fn at(&self, state: &State) -> Guide {
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

impl CircleLine {
    pub(super) fn new(point: PointId, arm: Arm, line: Line, group: usize) -> CircleLine {
        CircleLine {
            point,
            arm,
            line,
            sign: 1.0,
            inverse_square: arm.length.powi(-2),
            group,
        }
    }

    /// h0 = n.(P - Q), root = s sqrt((b - h0)(b + h0)): X = Q + (t.(P - Q) + root) t, e = root t - h0 n.
    /// The constraint n.(V - V_line) = 0 gives w n.(k x e) = w root.
    #[inline]
    fn run<const ORDER: u8>(&self, state: &mut State) -> Outcome {
        let guide = self.line.at(state);
        let p = state.points[self.arm.pivot.index()];
        let b = self.arm.length;
        let from = p.p - guide.q.p;
        let h0 = guide.n.dot(from);
        let left = b - h0;
        let right = b + h0;
        let product = left * right;
        state.measures[self.group] = product * self.inverse_square;
        let slack = REACH_SLACK * (b + from.x.abs() + from.y.abs());
        if !(left >= -slack && right >= -slack) {
            return Outcome::Open;
        }
        let stretched = left <= slack || right <= slack;
        let root = if stretched {
            0.0
        } else {
            self.sign * product.sqrt()
        };
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

impl CircleRail {
    pub(super) fn new(
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
            sign: 1.0,
            inverse_square: arm.length.powi(-2),
            group,
        }
    }

    /// As [`CircleLine`], with a line whose velocity and acceleration are zero.
    #[inline]
    fn run<const ORDER: u8>(&self, state: &mut State) -> Outcome {
        let (t, n) = (self.along, self.along.perp());
        let p = state.points[self.arm.pivot.index()];
        let b = self.arm.length;
        let from = p.p - self.through;
        let h0 = n.dot(from);
        let left = b - h0;
        let right = b + h0;
        let product = left * right;
        state.measures[self.group] = product * self.inverse_square;
        let slack = REACH_SLACK * (b + from.x.abs() + from.y.abs());
        if !(left >= -slack && right >= -slack) {
            return Outcome::Open;
        }
        let stretched = left <= slack || right <= slack;
        let root = if stretched {
            0.0
        } else {
            self.sign * product.sqrt()
        };
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

impl Swing {
    /// w = B - O = s t + e n, hence s = +-sqrt((D - e)(D + e)) and t = w (s - i e) / D^2.
    #[inline]
    fn run<const ORDER: u8>(&self, state: &mut State) -> Outcome {
        let o = state.points[self.pivot.index()];
        let b = state.points[self.pin.index()];
        let e = self.offset;
        let w = b.p - o.p;
        let d2 = w.norm2();
        let d = d2.sqrt();
        let inner = d - e.abs();
        state.measures[self.group] = inner * (d + e.abs());
        let slack = REACH_SLACK * (d + e.abs() + b.p.x.abs() + b.p.y.abs());
        if !(inner >= -slack) {
            return Outcome::Open;
        }
        let stretched = inner <= slack;
        let s = if stretched {
            0.0
        } else {
            self.sign * (inner * (d + e.abs())).sqrt()
        };
        if d2 == 0.0 {
            // The pin stands on the pivot: no direction exists.
            return Outcome::Open;
        }
        let t = w.turned(Vec2::new(s, -e)) * (1.0 / d2);
        let mut link = LinkState {
            d: t.turned(self.along.conj()),
            ..LinkState::default()
        };
        if stretched {
            state.links[self.link.index()].d = link.d;
            return Outcome::Stretched;
        }
        if ORDER >= VELOCITY {
            let n = t.perp();
            let scale = 1.0 / s;
            let dv = b.v - o.v;
            link.w = n.dot(dv) * scale;
            if ORDER >= ACCELERATION {
                let rate = t.dot(dv) + e * link.w;
                let da = b.a - o.a;
                link.a = (n.dot(da) - 2.0 * rate * link.w + e * link.w * link.w) * scale;
            }
        }
        state.links[self.link.index()] = link;
        Outcome::Done
    }
}

impl Cylinder {
    /// The arm is r = through + along q in its link's frame: a circle whose radius varies, with
    /// V = V_P + w k x e + tau and A = A_P + alpha k x e - w^2 e + 2 w k x tau, tau the guide's
    /// direction in the ground. Otherwise as [`Circles`].
    fn run<const ORDER: u8>(&self, q: f64, state: &mut State) -> Outcome {
        let local = self.through + self.along * q;
        let rho2 = local.norm2();
        let (rho, c) = (rho2.sqrt(), self.far.length);
        let p = state.points[self.pivot.index()];
        let far = state.points[self.far.pivot.index()];
        let u = far.p - p.p;
        let d2 = u.norm2();
        let d = d2.sqrt();
        let (inner, outer) = (d - (rho - c).abs(), (rho + c) - d);
        let product = (inner * (d + (rho - c).abs())) * (outer * ((rho + c) + d));
        state.measures[self.group] = product / (4.0 * rho2 * c * c);
        let slack = REACH_SLACK * (rho + c);
        if !(inner >= -slack && outer >= -slack && rho > 0.0) {
            return Outcome::Open;
        }
        let stretched = inner <= slack || outer <= slack;
        if stretched && d2 == 0.0 {
            return Outcome::Open;
        }
        let sh = if stretched {
            0.0
        } else {
            self.sign * 0.5 * product.sqrt()
        };
        let x = 0.5 * (d2 + (rho - c) * (rho + c));
        let e = (u * x + u.perp() * sh) / d2;
        let f = e - u;
        let mut point = PointState {
            p: p.p + e,
            ..PointState::default()
        };
        let mut barrel = LinkState {
            d: e.turned(local.conj()) / rho2,
            ..LinkState::default()
        };
        let mut link = LinkState {
            d: f.turned(self.far.factor),
            ..LinkState::default()
        };
        if ORDER >= VELOCITY && !stretched {
            let scale = 1.0 / sh;
            let tau = self.along.turned(barrel.d);
            let dv = far.v - p.v - tau;
            barrel.w = f.dot(dv) * scale;
            link.w = e.dot(dv) * scale;
            point.v = far.v + f.perp() * link.w;
            if ORDER >= ACCELERATION {
                let coriolis = tau.perp() * (2.0 * barrel.w);
                let da =
                    (far.a - p.a) - coriolis + e * (barrel.w * barrel.w) - f * (link.w * link.w);
                barrel.a = f.dot(da) * scale;
                link.a = e.dot(da) * scale;
                point.a = far.a + f.perp() * link.a - f * (link.w * link.w);
            }
        }
        state.points[self.point.index()] = point;
        state.links[self.link.index()] = barrel;
        state.links[self.far.link.index()] = link;
        if stretched {
            Outcome::Stretched
        } else {
            Outcome::Done
        }
    }
}

/// X = P + R(d) r, V = V_P + w k x r, A = A_P + alpha k x r - w^2 r.
#[inline]
fn carried<const ORDER: u8>(base: &PointState, link: &LinkState, local: Vec2) -> PointState {
    let r = local.turned(link.d);
    let mut point = PointState {
        p: base.p + r,
        ..PointState::default()
    };
    if ORDER >= VELOCITY {
        point.v = base.v + r.perp() * link.w;
    }
    if ORDER >= ACCELERATION {
        point.a = base.a + r.perp() * link.a - r * (link.w * link.w);
    }
    point
}

/// The meeting of two lines: X = Z1 + l t1 with l = n2.(Z2 - Z1) / n2.t1, and the same determinant
/// for the rates, seen along n2.
fn meet<const ORDER: u8>(one: &Guide, two: &Guide) -> Option<PointState> {
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

impl Step {
    /// Runs the step at the driver's coordinate `q`; `direction` is its unit vector where it is an
    /// angle.
    #[inline]
    pub(super) fn run<const ORDER: u8>(
        &self,
        q: f64,
        direction: Vec2,
        state: &mut State,
    ) -> Outcome {
        match self {
            Step::Crank { link } => {
                state.links[link.index()] = LinkState {
                    d: direction,
                    w: 1.0,
                    a: 0.0,
                };
            }
            Step::Spin {
                point,
                pivot,
                local,
            } => {
                let r = local.turned(direction);
                state.points[point.index()] = PointState {
                    p: state.points[pivot.index()].p + r,
                    v: r.perp(),
                    a: -r,
                };
            }
            Step::Ride {
                point,
                base,
                link,
                local,
            } => {
                let (base, link) = (state.points[base.index()], state.links[link.index()]);
                state.points[point.index()] = carried::<ORDER>(&base, &link, *local);
            }
            Step::Push {
                point,
                base,
                link,
                local,
                along,
            } => {
                let (base, link) = (state.points[base.index()], state.links[link.index()]);
                let mut pushed = carried::<ORDER>(&base, &link, *local + *along * q);
                let tau = along.turned(link.d);
                pushed.v += tau;
                pushed.a += tau.perp() * (2.0 * link.w);
                state.points[point.index()] = pushed;
            }
            Step::Aim { arm, end } => aim::<ORDER>(arm, *end, state),
            Step::Lock { link, to, turn } => {
                let mut locked = state.links[to.index()];
                locked.d = locked.d.turned(*turn);
                state.links[link.index()] = locked;
            }
            Step::Circles(circles) => return circles.run::<ORDER>(state),
            Step::CircleLine(circle_line) => return circle_line.run::<ORDER>(state),
            Step::CircleRail(circle_rail) => return circle_rail.run::<ORDER>(state),
            Step::Swing(swing) => return swing.run::<ORDER>(state),
            Step::Cylinder(cylinder) => return cylinder.run::<ORDER>(q, state),
            Step::Lines {
                point,
                first,
                second,
                group,
            } => {
                let (one, two) = (first.at(state), second.at(state));
                let det = two.n.dot(one.t);
                state.measures[*group] = det * det;
                let Some(met) = meet::<ORDER>(&one, &two) else {
                    return Outcome::Open;
                };
                state.points[point.index()] = met;
            }
            Step::Travel { slide, point, line } => travel(*slide, *point, line, state),
            // Coupled groups are run by the solver, which owns them.
            Step::Coupled { .. } => {}
        }
        Outcome::Done
    }

    /// The sign that chooses between the two assemblies of a dyad.
    pub(super) fn sign(&self) -> Option<f64> {
        match self {
            Step::Circles(c) => Some(c.sign),
            Step::CircleLine(c) => Some(c.sign),
            Step::CircleRail(c) => Some(c.sign),
            Step::Swing(s) => Some(s.sign),
            Step::Cylinder(c) => Some(c.sign),
            Step::Crank { .. }
            | Step::Spin { .. }
            | Step::Ride { .. }
            | Step::Push { .. }
            | Step::Aim { .. }
            | Step::Lock { .. }
            | Step::Lines { .. }
            | Step::Coupled { .. }
            | Step::Travel { .. } => None,
        }
    }

    pub(super) fn set_sign(&mut self, sign: f64) {
        match self {
            Step::Circles(c) => c.sign = sign,
            Step::CircleLine(c) => c.sign = sign,
            Step::CircleRail(c) => c.sign = sign,
            Step::Swing(s) => s.sign = sign,
            Step::Cylinder(c) => c.sign = sign,
            Step::Crank { .. }
            | Step::Spin { .. }
            | Step::Ride { .. }
            | Step::Push { .. }
            | Step::Aim { .. }
            | Step::Lock { .. }
            | Step::Lines { .. }
            | Step::Coupled { .. }
            | Step::Travel { .. } => {}
        }
    }

    /// By how much a dyad misses to close; 0 where it closes.
    pub(super) fn gap(&self, q: f64, state: &State) -> f64 {
        let at = |point: PointId| state.points[point.index()].p;
        let between = |a: PointId, b: PointId| (at(b) - at(a)).norm();
        let triangle = |d: f64, b: f64, c: f64| (d - (b + c)).max((b - c).abs() - d);
        let gap = match self {
            Step::Circles(c) => triangle(
                between(c.near.pivot, c.far.pivot),
                c.near.length,
                c.far.length,
            ),
            Step::Cylinder(c) => {
                let arm = (c.through + c.along * q).norm();
                triangle(between(c.pivot, c.far.pivot), arm, c.far.length)
            }
            Step::CircleLine(c) => {
                let guide = c.line.at(state);
                guide.n.dot(at(c.arm.pivot) - guide.q.p).abs() - c.arm.length
            }
            Step::CircleRail(c) => c.along.cross(at(c.arm.pivot) - c.through).abs() - c.arm.length,
            Step::Swing(s) => s.offset.abs() - between(s.pivot, s.pin),
            Step::Crank { .. }
            | Step::Spin { .. }
            | Step::Ride { .. }
            | Step::Push { .. }
            | Step::Aim { .. }
            | Step::Lock { .. }
            | Step::Lines { .. }
            | Step::Coupled { .. }
            | Step::Travel { .. } => 0.0,
        };
        gap.max(0.0)
    }
}

fn aim<const ORDER: u8>(arm: &Arm, end: PointId, state: &mut State) {
    let (p, x) = (state.points[arm.pivot.index()], state.points[end.index()]);
    let e = x.p - p.p;
    let mut link = LinkState {
        d: e.turned(arm.factor),
        ..LinkState::default()
    };
    let scale = 1.0 / (arm.length * arm.length);
    if ORDER >= VELOCITY {
        link.w = e.cross(x.v - p.v) * scale;
    }
    if ORDER >= ACCELERATION {
        link.a = e.cross(x.a - p.a) * scale;
    }
    state.links[arm.link.index()] = link;
}

/// X - Q = s t: s' = t.(V_X - V_Q), s'' = t.(A_X - A_Q) + w^2 s.
fn travel(slide: SlideId, point: PointId, line: &Line, state: &mut State) {
    let guide = line.at(state);
    let x = state.points[point.index()];
    let s = guide.t.dot(x.p - guide.q.p);
    state.travels[slide.index()] = super::state::TravelState {
        s,
        v: guide.t.dot(x.v - guide.q.v),
        a: guide.t.dot(x.a - guide.q.a) + guide.w * guide.w * s,
        guide: LinkState {
            d: guide.t,
            w: guide.w,
            a: guide.a,
        },
    };
}
