//! Solves the dyads PRP and RPP: a joint on two known lines.

use super::line::GuideAt;
use super::{ACCELERATION, BackwardPass, Element, GuideLine, StepOutcome, VELOCITY};
use crate::solver::forces::{ForceState, LineReaction, Site};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{PointState, State};
use crate::solver::transmission::{InnerJoint, Ray};
use crate::{Number, PointId, Vec2};

/// Two directions with a smaller sine count as parallel: the rounding of two products of unit
/// vectors. Guides that differ by 2^-40 are distinguished.
const PARALLEL: f64 = 8.0 * 0.5 * f64::EPSILON;

/// The intersection of two lines, PRP and RPP.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Lines {
    pub point: PointId,
    pub first: GuideLine,
    pub second: GuideLine,
    pub group: usize,
}

impl Element for Lines {
    type Back = LinesBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Point(self.point));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        let lines = [self.first, self.second];
        lines.iter().flat_map(GuideLine::inputs).for_each(reads);
    }

    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let (one, two) = (self.first.at(state), self.second.at(state));
        let det = two.n.dot(one.t);
        state.set_measure(self.group, det * det);
        let Some(met) = meet::<T, ORDER>(&one, &two) else {
            return StepOutcome::Open;
        };
        state.points[self.point.index()] = met;
        StepOutcome::Done
    }

    fn back(&self, site: &Site<'_>) -> Option<LinesBackward> {
        Some(LinesBackward {
            point: self.point,
            lines: [self.first, self.second],
            holds: [site.held(0, self.point)?, site.held(1, self.point)?],
        })
    }

    fn rays(&self, state: &State) -> Option<[Ray; 2]> {
        let [first, second] =
            [self.first, self.second].map(|line| Ray::on(line.link, line.along.nearest(), state));
        Some([first, second])
    }

    fn inner_joint(&self) -> Option<InnerJoint> {
        Some(InnerJoint::line_and_normal(self.group))
    }
}

/// Returns the intersection of two lines: X = Z1 + l t1 with l = n2.(Z2 - Z1) / n2.t1. The rates
/// have the same determinant and are taken along n2.
#[inline(always)]
fn meet<T: Number, const ORDER: u8>(one: &GuideAt<T>, two: &GuideAt<T>) -> Option<PointState<T>> {
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

/// The backward pass: the force at the joint is resolved along the normals of the two lines.
#[derive(Clone, Debug)]
pub(in crate::solver) struct LinesBackward {
    point: PointId,
    lines: [GuideLine; 2],
    holds: [LineReaction; 2],
}

impl BackwardPass for LinesBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let [one, two] = [self.lines[0].at(state), self.lines[1].at(state)];
        let force = forces.at(self.point);
        let x = state.points[self.point.index()].p;
        // F = a n1 + b n2.
        let det = one.n.dot(two.t);
        let a = force.dot(two.t) / det;
        let b = -(force.dot(one.t) / det);
        let s = [&one, &two].map(|guide| guide.t.dot(x - guide.q.p));
        forces.press(&self.holds[0], Some((&self.lines[0], s[0])), one.n, a);
        forces.press(&self.holds[1], Some((&self.lines[1], s[1])), two.n, b);
    }
}
