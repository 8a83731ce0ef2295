//! Solves the dyad RRP on the ground: a [`CircleLine`](super::CircleLine) whose line is fixed.

use super::line::Chord;
use super::singular_series::{Cut, FEW_TERMS, SingularShift, turned};
use super::{
    ACCELERATION, Arm, BackwardPass, Dyad, Element, FRAMES, POSITION, RelativeMotion, StepOutcome,
    Stretching, TwoAssemblies, VELOCITY,
};
use crate::arithmetic::{Series, TERMS};
use crate::solver::forces::{ArmSite, ForceState, LineReaction, Site};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, PointState, State};
use crate::solver::transmission::{InnerJoint, Ray};
use crate::{Constant, Number, PointId, Vec2};

/// A circle and a fixed line, RRP: by far the most frequent kind of slide.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct CircleRail {
    pub point: PointId,
    pub arm: Arm,
    /// A point of the rail and its direction, a unit vector.
    pub through: Vec2<Constant>,
    pub along: Vec2<Constant>,
    /// The direction of the arm's link when the arm lies along the rail.
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

    /// Returns the components t.v and n.v.
    #[inline(always)]
    fn components<T: Number>(&self, v: Vec2<T>) -> Vec2<T> {
        v.turned(Vec2::of(self.along).conj())
    }

    /// Returns the pivot's coordinates along and across the rail, and the chord.
    #[inline(always)]
    fn chord<T: Number>(&self, state: &State<T>) -> (Vec2<T>, Chord<T>) {
        let from = state.points[self.arm.pivot.index()].p - Vec2::of(self.through);
        let seen = self.components(from);
        (seen, Chord::new(self.arm.length::<T>(), seen.y, from))
    }

    /// Stores the dyad with X at s along the rail and the link in the direction d.
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
            let v = self.components(p.v);
            link.w = -v.y * scale;
            point.v = t * (link.w * h0 + v.x);
            if ORDER >= ACCELERATION {
                let (a, w2) = (self.components(p.a), link.w * link.w);
                link.a = -(a.y + w2 * h0) * scale;
                point.a = t * (link.a * h0 - w2 * root + a.x);
            }
        }
        state.points[self.point.index()] = point;
        state.links[self.arm.link.index()] = link;
    }
}

impl Element for CircleRail {
    const IS_FREQUENT: bool = true;
    const HAS_RESIDUALS: bool = true;
    type Back = CircleRailBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Point(self.point));
        places(PlacedPart::Link(self.arm.link));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.arm.pivot));
    }

    /// Solves as [`CircleLine`](super::CircleLine) does, but the line has zero velocity and
    /// acceleration: e = t (root - i h0).
    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let (Vec2 { x: along, y: h0 }, chord) = self.chord(state);
        state.set_measure(self.group, chord.product * T::exactly(self.inverse_square));
        if !chord.is_clear() {
            return StepOutcome::Unclear;
        }
        let root = state.signs[self.group] * chord.product.sqrt();
        let d = Vec2::of(self.aligned).turned(Vec2::new(root, -h0));
        self.place::<T, ORDER>(along + root, d, [h0, root], state);
        StepOutcome::Done
    }

    fn dyad(&self) -> Option<Dyad<'_>> {
        Some(Dyad::CircleRail(self))
    }

    fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        let arm = self.arm.varied(place);
        place(&mut self.through);
        let rail = [self.through, self.along];
        *self = CircleRail::new(self.point, arm, rail, self.group);
    }

    fn back(&self, site: &Site<'_>) -> Option<CircleRailBackward> {
        Some(CircleRailBackward {
            point: self.point,
            arm: site.reach(&self.arm, self.point),
            along: self.along,
            hold: site.held(0, self.point)?,
        })
    }

    fn rays(&self, state: &State) -> Option<[Ray; 2]> {
        let arm = Ray::between(self.arm.pivot, self.point, state);
        let normal = Ray::fixed(self.along.nearest().perp());
        Some([arm, normal])
    }

    fn inner_joint(&self) -> Option<InnerJoint> {
        Some(InnerJoint::line_and_normal(self.group))
    }
}

impl TwoAssemblies for CircleRail {
    type InSeries = Cut;

    fn group(&self) -> usize {
        self.group
    }

    fn is_in_reach<T: Number>(&self, _q: T, state: &State<T>) -> bool {
        self.chord(state).1.touches()
    }

    fn align<T: Number>(&self, _q: T, state: &mut State<T>) {
        let (Vec2 { x: along, y: h0 }, _) = self.chord(state);
        let d = self.arm.direction(-Vec2::of(self.along).perp() * h0);
        self.place::<T, { POSITION }>(along, d, [h0, T::default()], state);
    }

    fn stretch_rate<T: Number>(&self, state: &State<T>) -> Option<T> {
        let v = state.points[self.arm.pivot.index()].v;
        Some(Vec2::of(self.along).cross(v))
    }

    fn stretching(&self, _q: f64, _seen_from: LinkState, state: &State) -> Option<Stretching> {
        let pivot = state.points[self.arm.pivot.index()];
        let toward = self.along.nearest().perp();
        Some(Stretching {
            toward,
            growth: toward.dot(pivot.v),
            seen: [RelativeMotion {
                v: pivot.v,
                a: pivot.a,
            }; FRAMES],
        })
    }

    fn reserve<T: Number>(&self, _q: T, state: &State<T>) -> T {
        let from = state.points[self.arm.pivot.index()].p - Vec2::of(self.through);
        self.arm.length::<T>() - Vec2::of(self.along).cross(from).abs()
    }

    fn reach(&self, state: &State<Series>) -> [Series; 2] {
        self.in_series(
            Series::default(),
            SingularShift::default(),
            FEW_TERMS,
            state,
        )
        .reach()
    }

    /// Returns the chord in series.
    fn in_series(
        &self,
        _q: Series,
        snap: SingularShift,
        terms: usize,
        state: &State<Series>,
    ) -> Cut {
        let t = Vec2::of(turned(self.along, snap));
        let from = state.points[self.arm.pivot.index()].p - Vec2::of(self.through);
        let from = from.map(|v| v.cut(terms));
        Cut::new(self.arm.length, from, t, snap.by.x)
    }

    fn right_angle(&self, _q: Series, _state: &State<Series>) -> f64 {
        self.arm.length.hi.powi(2)
    }

    fn run_through(
        &self,
        q: Series,
        snap: SingularShift,
        height: Series,
        state: &mut State<Series>,
    ) {
        let cut = self.in_series(q, snap, TERMS, state);
        let e = cut.arm(height);
        let s = cut.along + height;
        self.place::<Series, POSITION>(s, self.arm.direction(e), [cut.h0, height], state);
        let pivot = state.points[self.arm.pivot.index()].p;
        state.points[self.point.index()].p = pivot + e;
    }
}

/// The backward pass: the arm takes the force along the rail, the rail takes the rest.
#[derive(Clone, Debug)]
pub(in crate::solver) struct CircleRailBackward {
    point: PointId,
    arm: ArmSite,
    along: Vec2<Constant>,
    hold: LineReaction,
}

impl BackwardPass for CircleRailBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let at = |point: PointId| -> Vec2<T> { state.points[point.index()].p };
        let (t, e) = (Vec2::of(self.along), at(self.point) - at(self.arm.pivot));
        let across = forces.across(e, t, self.point, self.arm.link);
        let n = t.perp();
        let force = forces.at(self.point) - n * across;
        forces.hold(&self.arm, force, state);
        forces.press(&self.hold, None, n, across);
    }
}
