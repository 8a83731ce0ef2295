//! The dyads with two assemblies, and what can be asked of each of them.

use super::{CircleLine, CircleRail, Circles, Cylinder, Outcome, Swing};
use crate::solver::state::State;
use crate::{LinkId, Number, PointId, Vec2};

/// A dyad with two assemblies, of which the sign of its group chooses one.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) enum Dyad<'a> {
    /// RRR.
    Circles(&'a Circles),
    /// RRP.
    CircleLine(&'a CircleLine),
    /// RRP on the ground.
    CircleRail(&'a CircleRail),
    /// RPR.
    Swing(&'a Swing),
    /// RRR with a driven arm.
    Cylinder(&'a Cylinder),
}

impl Dyad<'_> {
    /// Places it at its limit, if within rounding it still closes.
    #[cold]
    pub(in crate::solver) fn stretch<T: Number>(self, q: T, state: &mut State<T>) -> Outcome {
        if !self.is_in_reach(q, state) {
            return Outcome::Open;
        }
        self.align(q, state);
        Outcome::Stretched
    }

    /// Whether within rounding it still closes, in a direction that is told.
    fn is_in_reach<T: Number>(self, q: T, state: &State<T>) -> bool {
        match self {
            Dyad::Circles(c) => c.is_in_reach(state),
            Dyad::CircleLine(c) => c.is_in_reach(state),
            Dyad::CircleRail(c) => c.is_in_reach(state),
            Dyad::Swing(s) => s.is_in_reach(state),
            Dyad::Cylinder(c) => c.is_in_reach(q, state),
        }
    }

    /// Places it in line, as at its limit: positions alone.
    pub(in crate::solver) fn align<T: Number>(self, q: T, state: &mut State<T>) {
        match self {
            Dyad::Circles(c) => c.align(state),
            Dyad::CircleLine(c) => c.align(state),
            Dyad::CircleRail(c) => c.align(state),
            Dyad::Swing(s) => s.align(state),
            Dyad::Cylinder(c) => c.align(q, state),
        }
    }

    /// The group whose sign chooses between the two assemblies.
    pub(in crate::solver) fn group(self) -> usize {
        match self {
            Dyad::Circles(c) => c.group,
            Dyad::CircleLine(c) => c.group,
            Dyad::CircleRail(c) => c.group,
            Dyad::Swing(s) => s.group,
            Dyad::Cylinder(c) => c.group,
        }
    }

    /// What it places.
    pub(in crate::solver) fn outputs(self) -> (Option<PointId>, [Option<LinkId>; 2]) {
        match self {
            Dyad::Circles(c) => (Some(c.point), [Some(c.near.link), Some(c.far.link)]),
            Dyad::CircleLine(c) => (Some(c.point), [Some(c.arm.link), None]),
            Dyad::CircleRail(c) => (Some(c.point), [Some(c.arm.link), None]),
            Dyad::Swing(s) => (None, [Some(s.link), None]),
            Dyad::Cylinder(c) => (Some(c.point), [Some(c.link), Some(c.far.link)]),
        }
    }

    /// The rate of what it is stretched by - the distance of its pivots, or of pivot and guide - up
    /// to a positive factor: zero where the stretch is extreme. From the state of its inputs; `None`
    /// where its own reach changes.
    pub(in crate::solver) fn stretch_rate(self, state: &State) -> Option<f64> {
        let at = |point: PointId| state.points[point.index()];
        let growth = |a: PointId, b: PointId| (at(b).p - at(a).p).dot(at(b).v - at(a).v);
        match self {
            Dyad::Circles(c) => Some(growth(c.near.pivot, c.far.pivot)),
            Dyad::Swing(s) => Some(growth(s.pivot, s.pin)),
            Dyad::CircleRail(c) => Some(c.along.nearest().cross(at(c.arm.pivot).v)),
            Dyad::CircleLine(c) => {
                let guide = c.line.at(state);
                let pivot = at(c.arm.pivot);
                let turning = guide.w * guide.t.dot(pivot.p - guide.q.p);
                Some(guide.n.dot(pivot.v - guide.q.v) - turning)
            }
            Dyad::Cylinder(_) => None,
        }
    }

    /// By how much it misses to close; 0 where it closes.
    pub(in crate::solver) fn gap(self, q: f64, state: &State) -> f64 {
        (-self.reserve(q, state)).max(0.0)
    }

    /// How far it is from the extremes of its reach, as a length: negative where it is open.
    pub(in crate::solver) fn reserve<T: Number>(self, q: T, state: &State<T>) -> T {
        let at = |point: PointId| state.points[point.index()].p;
        let between = |a: PointId, b: PointId| (at(b) - at(a)).norm();
        let triangle = |d: T, b: T, c: T| ((b + c) - d).min(d - (b - c).abs());
        match self {
            Dyad::Circles(c) => triangle(
                between(c.near.pivot, c.far.pivot),
                T::of(c.near.length),
                T::of(c.far.length),
            ),
            Dyad::Cylinder(c) => {
                let arm = Vec2::of(c.through) + Vec2::of(c.along) * q;
                let far = T::of(c.far.length);
                triangle(between(c.pivot, c.far.pivot), arm.norm(), far)
            }
            Dyad::CircleLine(c) => {
                let guide = c.line.at(state);
                T::of(c.arm.length) - guide.n.dot(at(c.arm.pivot) - guide.q.p).abs()
            }
            Dyad::CircleRail(c) => {
                let from = at(c.arm.pivot) - Vec2::of(c.through);
                T::of(c.arm.length) - Vec2::of(c.along).cross(from).abs()
            }
            Dyad::Swing(s) => between(s.pivot, s.pin) - T::of(s.offset).abs(),
        }
    }
}
