//! Solves the dyad RRP: a joint at a given distance from a known joint and on a known line.
//!
//! With Q a point of the line, t and n along and across it, h0 = n.(P - Q) and e = X - P:
//!
//! ```text
//! |e| = b, n.(X - Q) = 0       e = root t - h0 n, root = s sqrt((b - h0)(b + h0))
//! ```

use super::line::{Chord, GuideAt};
use super::singular_series::{Cut, FEW_TERMS, SingularShift, turned};
use super::{
    ACCELERATION, Arm, BackwardPass, Dyad, Element, FRAMES, GuideLine, POSITION, RelativeMotion,
    StepOutcome, Stretching, TwoAssemblies, VELOCITY, sum,
};
use crate::arithmetic::{Series, TERMS};
use crate::solver::forces::{ArmSite, ForceState, LineReaction, Site};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, State};
use crate::solver::transmission::{InnerJoint, Ray};
use crate::{Constant, Number, PointId, Vec2};

/// A circle and a line, RRP. The sign is the side along the line on which the point lies, relative
/// to the foot of the pivot.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct CircleLine {
    pub point: PointId,
    pub arm: Arm,
    pub line: GuideLine,
    /// 1 / length^2, which scales the product of the reaches to the square of a sine.
    inverse_square: f64,
    pub group: usize,
}

impl CircleLine {
    pub(in crate::solver) fn new(
        point: PointId,
        arm: Arm,
        line: GuideLine,
        group: usize,
    ) -> CircleLine {
        CircleLine {
            point,
            arm,
            line,
            inverse_square: arm.length.hi.powi(-2),
            group,
        }
    }

    /// Returns the guide, the pivot relative to its point, h0 = n.(P - Q) and the chord.
    #[inline(always)]
    fn chord<T: Number>(&self, state: &State<T>) -> (GuideAt<T>, Vec2<T>, T, Chord<T>) {
        let guide = self.line.at(state);
        let from = state.points[self.arm.pivot.index()].p - guide.q.p;
        let h0 = guide.n.dot(from);
        let chord = Chord::new(self.arm.length::<T>(), h0, from);
        (guide, from, h0, chord)
    }

    /// Stores the dyad with X = P + e at s along the guide, e = root t - h0 n. The constraint n.(V
    /// - V_line) = 0 gives w n.(k x e) = w root.
    #[inline(always)]
    pub(in crate::solver) fn place<T: Number, const ORDER: u8>(
        &self,
        guide: &GuideAt<T>,
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
}

impl Element for CircleLine {
    type Back = CircleLineBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Point(self.point));
        places(PlacedPart::Link(self.arm.link));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.arm.pivot));
        self.line.inputs().into_iter().for_each(reads);
    }

    /// root = s sqrt((b - h0)(b + h0)): X = Q + (t.(P - Q) + root) t, e = root t - h0 n.
    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let (guide, from, h0, chord) = self.chord(state);
        let measure = chord.product * T::exactly(self.inverse_square);
        if !chord.is_clear() {
            state.set_measure(self.group, measure);
            return StepOutcome::Unclear;
        }
        let root = state.signs[self.group] * chord.product.sqrt();
        let e = guide.t * root - guide.n * h0;
        self.place::<T, ORDER>(&guide, guide.t.dot(from) + root, e, [h0, root], state);
        state.set_measure(self.group, measure);
        StepOutcome::Done
    }

    fn dyad(&self) -> Option<Dyad<'_>> {
        Some(Dyad::CircleLine(self))
    }

    fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        let arm = self.arm.varied(place);
        *self = CircleLine::new(self.point, arm, self.line, self.group);
    }

    fn back(&self, site: &Site<'_>) -> Option<CircleLineBackward> {
        Some(CircleLineBackward {
            point: self.point,
            arm: site.reach(&self.arm, self.point),
            line: self.line,
            hold: site.held(0, self.point)?,
        })
    }

    fn rays(&self, state: &State) -> Option<[Ray; 2]> {
        let arm = Ray::between(self.arm.pivot, self.point, state);
        let normal = Ray::on(self.line.link, self.line.along.nearest().perp(), state);
        Some([arm, normal])
    }

    fn inner_joint(&self) -> Option<InnerJoint> {
        Some(InnerJoint::line_and_normal(self.group))
    }
}

impl TwoAssemblies for CircleLine {
    type InSeries = Cut;

    fn group(&self) -> usize {
        self.group
    }

    /// Returns `true` if the arm reaches the guide within rounding.
    fn is_in_reach<T: Number>(&self, _q: T, state: &State<T>) -> bool {
        self.chord(state).3.touches()
    }

    /// Places the arm across the guide: positions only.
    fn align<T: Number>(&self, _q: T, state: &mut State<T>) {
        let (guide, from, h0, _) = self.chord(state);
        let (e, s) = (-guide.n * h0, guide.t.dot(from));
        self.place::<T, { POSITION }>(&guide, s, e, [h0, T::default()], state);
    }

    fn stretch_rate<T: Number>(&self, state: &State<T>) -> Option<T> {
        let guide = self.line.at(state);
        let pivot = state.points[self.arm.pivot.index()];
        let turning = guide.w * guide.t.dot(pivot.p - guide.q.p);
        Some(guide.n.dot(pivot.v - guide.q.v) - turning)
    }

    /// Returns the stretching relative to the guide.
    fn stretching(&self, _q: f64, _seen_from: LinkState, state: &State) -> Option<Stretching> {
        let guide = self.line.at(state);
        let pivot = state.points[self.arm.pivot.index()];
        let s = guide.t.dot(pivot.p - guide.q.p);
        Some(Stretching {
            toward: guide.n,
            growth: guide.n.dot(pivot.v - guide.velocity(s)),
            seen: [RelativeMotion {
                v: sum([pivot.v, -guide.velocity(s)]),
                a: sum([pivot.a, -guide.acceleration(s, 0.0)]),
            }; FRAMES],
        })
    }

    fn reserve<T: Number>(&self, _q: T, state: &State<T>) -> T {
        let guide = self.line.at(state);
        let from = state.points[self.arm.pivot.index()].p - guide.q.p;
        self.arm.length::<T>() - guide.n.dot(from).abs()
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
        let mut line = self.line;
        line.along = turned(line.along, snap);
        let guide = line.at(state);
        let from = state.points[self.arm.pivot.index()].p - guide.q.p;
        let from = from.map(|v| v.cut(terms));
        Cut::new(self.arm.length, from, guide.t, snap.by.x)
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
        let guide = self.line.at(state);
        self.place::<Series, POSITION>(&guide, cut.along + height, e, [cut.h0, height], state);
        let pivot = state.points[self.arm.pivot.index()].p;
        state.points[self.point.index()].p = pivot + e;
    }
}

/// The backward pass: the arm takes the force along the line, the guide takes the rest.
#[derive(Clone, Debug)]
pub(in crate::solver) struct CircleLineBackward {
    point: PointId,
    arm: ArmSite,
    line: GuideLine,
    hold: LineReaction,
}

impl BackwardPass for CircleLineBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let guide = self.line.at(state);
        let x = state.points[self.point.index()].p;
        let e = x - state.points[self.arm.pivot.index()].p;
        let across = forces.across(e, guide.t, self.point, self.arm.link);
        let force = forces.at(self.point) - guide.n * across;
        forces.hold(&self.arm, force, state);
        let s = guide.t.dot(x - guide.q.p);
        forces.press(&self.hold, Some((&self.line, s)), guide.n, across);
    }
}
