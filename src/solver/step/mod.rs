//! The elementary steps of a plan, in closed form.
//!
//! A step reads points and links that earlier steps have placed and places a few more, with the
//! first and second derivatives by the driver's coordinate. Notation: P, Q known points, X the point
//! sought; e = X - P; t the direction of a guide and n = k x t its normal; (V, w) and (A, alpha)
//! first and second derivatives of points and angles.

mod circles;
mod dyad;
mod lines;
mod swing;
mod through;

pub(super) use circles::{Circles, Cylinder};
pub(super) use dyad::Dyad;
pub(super) use lines::{CircleLine, CircleRail, Line};
pub(super) use swing::Swing;
pub(super) use through::{Height, Snap, ZERO, root};

use super::state::{LinkState, PointState, State};
use crate::{Constant, LinkId, Number, PointId, SlideId, Vec2};
use lines::meet;

/// How many derivatives a solve carries, as a constant of the compiled code.
pub(super) const POSITION: u8 = 0;
pub(super) const VELOCITY: u8 = 1;
pub(super) const ACCELERATION: u8 = 2;

/// How far beyond its reach a group still counts as just stretched: 4 u of the lengths, the
/// rounding of a computed distance. Less would refuse limits that were typed in exactly; more would
/// clamp states that really are open.
pub(super) const REACH_SLACK: f64 = 4.0 * 0.5 * f64::EPSILON;

/// What became of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// Solved.
    Done,
    /// So close to its limit that rounding decides: [`Dyad::stretch`] looks closer.
    Unclear,
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
    /// Its length, and the square of it.
    pub length: Constant,
    pub square: Constant,
    /// The link whose direction it tells.
    pub link: LinkId,
    /// The conjugate of the arm in the link's frame over the square of its length.
    pub factor: Vec2<Constant>,
}

impl Arm {
    pub(super) fn new(pivot: PointId, link: LinkId, local: Vec2<Constant>) -> Arm {
        Arm {
            pivot,
            length: local.norm(),
            square: local.norm2(),
            link,
            factor: local.conj() / local.norm2(),
        }
    }

    /// The direction of the link whose arm stands so.
    #[inline(always)]
    pub(super) fn direction<T: Number>(&self, arm: Vec2<T>) -> Vec2<T> {
        // Most arms lie along the x axis of their link.
        if !T::IS_CHEAP && self.factor.y == Constant::default() {
            arm * T::of(self.factor.x)
        } else {
            arm.turned(Vec2::of(self.factor))
        }
    }
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
        local: Vec2<Constant>,
    },
    /// A point at `local` on a link, seen from another point of the same link.
    Ride {
        point: PointId,
        base: PointId,
        link: LinkId,
        local: Vec2<Constant>,
    },
    /// The driven slide: the point lies at `local + along q` on a link, seen from `base`.
    Push {
        point: PointId,
        base: PointId,
        link: LinkId,
        local: Vec2<Constant>,
        along: Vec2<Constant>,
    },
    /// The direction of a link both of whose ends are known.
    Aim { arm: Arm, end: PointId },
    /// A link that keeps its angle to another one.
    Lock {
        link: LinkId,
        to: LinkId,
        turn: Vec2<Constant>,
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

/// X = P + R(d) r, V = V_P + w k x r, A = A_P + alpha k x r - w^2 r.
#[inline(always)]
fn carried<T: Number, const ORDER: u8>(
    base: &PointState<T>,
    link: &LinkState<T>,
    local: Vec2<T>,
) -> PointState<T> {
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

impl Step {
    /// Runs the step at the driver's coordinate `q`; `direction` is its unit vector where it is an
    /// angle.
    #[inline(always)]
    pub(super) fn run<T: Number, const ORDER: u8>(
        &self,
        q: T,
        direction: Vec2<T>,
        state: &mut State<T>,
    ) -> Outcome {
        match self {
            Step::Crank { link } => {
                state.links[link.index()] = LinkState {
                    d: direction,
                    w: T::exactly(1.0),
                    a: T::default(),
                };
            }
            Step::Spin {
                point,
                pivot,
                local,
            } => {
                let r = Vec2::of(*local).turned(direction);
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
                state.points[point.index()] = carried::<T, ORDER>(&base, &link, Vec2::of(*local));
            }
            Step::Push {
                point,
                base,
                link,
                local,
                along,
            } => {
                let (base, link) = (state.points[base.index()], state.links[link.index()]);
                let along = Vec2::of(*along);
                let mut pushed = carried::<T, ORDER>(&base, &link, Vec2::of(*local) + along * q);
                let tau = along.turned(link.d);
                pushed.v += tau;
                pushed.a += tau.perp() * link.w.scaled(2.0);
                state.points[point.index()] = pushed;
            }
            Step::Aim { arm, end } => aim::<T, ORDER>(arm, *end, state),
            Step::Lock { link, to, turn } => {
                let mut locked = state.links[to.index()];
                locked.d = locked.d.turned(Vec2::of(*turn));
                state.links[link.index()] = locked;
            }
            Step::Circles(circles) => return circles.run::<T, ORDER>(state),
            Step::CircleLine(circle_line) => return circle_line.run::<T, ORDER>(state),
            Step::CircleRail(circle_rail) => return circle_rail.run::<T, ORDER>(state),
            Step::Swing(swing) => return swing.run::<T, ORDER>(state),
            Step::Cylinder(cylinder) => return cylinder.run::<T, ORDER>(q, state),
            Step::Lines {
                point,
                first,
                second,
                group,
            } => {
                let (one, two) = (first.at(state), second.at(state));
                let det = two.n.dot(one.t);
                state.measures[*group] = det * det;
                let Some(met) = meet::<T, ORDER>(&one, &two) else {
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

    /// The dyad with two assemblies, if the step is one.
    pub(super) fn dyad(&self) -> Option<Dyad<'_>> {
        match self {
            Step::Circles(circles) => Some(Dyad::Circles(circles)),
            Step::CircleLine(circle_line) => Some(Dyad::CircleLine(circle_line)),
            Step::CircleRail(circle_rail) => Some(Dyad::CircleRail(circle_rail)),
            Step::Swing(swing) => Some(Dyad::Swing(swing)),
            Step::Cylinder(cylinder) => Some(Dyad::Cylinder(cylinder)),
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

    /// The group whose sign chooses between the two assemblies of this step, if it has two.
    pub(super) fn choice(&self) -> Option<usize> {
        self.dyad().map(Dyad::group)
    }
}

fn aim<T: Number, const ORDER: u8>(arm: &Arm, end: PointId, state: &mut State<T>) {
    let (p, x) = (state.points[arm.pivot.index()], state.points[end.index()]);
    let e = x.p - p.p;
    let mut link = LinkState {
        d: arm.direction(e),
        ..LinkState::default()
    };
    let length = T::of(arm.length);
    let scale = T::exactly(1.0) / (length * length);
    if ORDER >= VELOCITY {
        link.w = e.cross(x.v - p.v) * scale;
    }
    if ORDER >= ACCELERATION {
        link.a = e.cross(x.a - p.a) * scale;
    }
    state.links[arm.link.index()] = link;
}

/// X - Q = s t: s' = t.(V_X - V_Q), s'' = t.(A_X - A_Q) + w^2 s.
#[inline(always)]
fn travel<T: Number>(slide: SlideId, point: PointId, line: &Line, state: &mut State<T>) {
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
