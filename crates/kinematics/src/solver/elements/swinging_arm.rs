//! Solves the dyad RPR: an arm that turns about a known joint and slides through another one.

use super::singular_series::{
    Height, InSeries, SingularShift, between, quotient, shifted, squared,
};
use super::{
    ACCELERATION, BackwardPass, Dyad, Element, POSITION, REACH_SLACK, StepOutcome, TwoAssemblies,
    VELOCITY,
};
use crate::arithmetic::{Series, TERMS};
use crate::solver::forces::{ForceState, LegSite, Site, Slot};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, State};
use crate::solver::transmission::{InnerJoint, Ray};
use crate::{Constant, LinkId, Number, PointId, SlideId, Vec2};

/// An arm that turns about a pivot and slides through a pin, RPR. The sign is that of t.(pin -
/// pivot).
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Swing {
    pub pivot: PointId,
    pub pin: PointId,
    pub link: LinkId,
    /// The guide's direction in the link's frame: a unit vector.
    pub along: Vec2<Constant>,
    /// n.(pin - pivot): the distance of the guide from the pivot.
    pub offset: Constant,
    pub group: usize,
}

impl Swing {
    /// Returns the vector from the pivot to the pin, its length and square, and the rounding
    /// tolerance.
    #[inline(always)]
    fn stretched<T: Number>(&self, state: &State<T>) -> (Vec2<T>, T, T, T) {
        let pin = state.points[self.pin.index()].p;
        let w = pin - state.points[self.pivot.index()].p;
        let d2 = w.norm2();
        let d = d2.sqrt();
        let size = d + T::of(self.offset.abs()) + pin.x.abs() + pin.y.abs();
        (w, d, d2, size.scaled(REACH_SLACK * T::RELATIVE_ROUNDING))
    }

    /// Stores the arm with its guide along t and the pin at s along it.
    #[inline(always)]
    pub(in crate::solver) fn place<T: Number, const ORDER: u8>(
        &self,
        t: Vec2<T>,
        s: T,
        state: &mut State<T>,
    ) {
        let mut link = LinkState::fixed(t.turned(Vec2::of(self.along.conj())));
        if ORDER >= VELOCITY {
            let o = state.points[self.pivot.index()];
            let b = state.points[self.pin.index()];
            let e = T::of(self.offset);
            let n = t.perp();
            let scale = T::exactly(1.0) / s;
            let dv = b.v - o.v;
            link.w = n.dot(dv) * scale;
            if ORDER >= ACCELERATION {
                let rate = t.dot(dv) + e * link.w;
                let da = b.a - o.a;
                link.a = (n.dot(da) - (rate * link.w).scaled(2.0) + e * link.w * link.w) * scale;
            }
        }
        state.links[self.link.index()] = link;
    }
}

impl Element for Swing {
    type Back = SwingBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Link(self.link));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.pivot));
        reads(PlacedPart::Point(self.pin));
    }

    /// w = B - O = s t + e n, hence s = +-sqrt((D - e)(D + e)) and t = w (s - i e) / D^2.
    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let (w, d, d2, slack) = self.stretched(state);
        let e = T::of(self.offset);
        let inner = d - e.abs();
        let product = inner * (d + e.abs());
        state.set_measure(self.group, product);
        if !inner.exceeds(slack) {
            return StepOutcome::Unclear;
        }
        let s = state.signs[self.group] * product.sqrt();
        let t = w.turned(Vec2::new(s, -e)) * (T::exactly(1.0) / d2);
        self.place::<T, ORDER>(t, s, state);
        StepOutcome::Done
    }

    fn dyad(&self) -> Option<Dyad<'_>> {
        Some(Dyad::Swing(self))
    }

    fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        // As a position, the offset is across the guide.
        let mut nearby = Vec2::new(Constant::default(), self.offset);
        place(&mut nearby);
        self.offset = nearby.y;
    }

    fn back(&self, site: &Site<'_>) -> Option<SwingBackward> {
        let (slide, legs) = site.swung(self.pin);
        Some(SwingBackward {
            pivot: self.pivot,
            pin: self.pin,
            link: self.link,
            along: self.along,
            slot: site.slot(self.link, self.pivot),
            slide,
            legs,
        })
    }

    fn rays(&self, state: &State) -> Option<[Ray; 2]> {
        let line = Ray::between(self.pivot, self.pin, state);
        let normal = Ray::on(self.link, self.along.nearest().perp(), state);
        Some([line, normal])
    }

    fn inner_joint(&self) -> Option<InnerJoint> {
        Some(InnerJoint::line_and_normal(self.group))
    }
}

impl TwoAssemblies for Swing {
    type InSeries = SwingSeries;

    fn group(&self) -> usize {
        self.group
    }

    /// Returns `true` if the pin reaches the guide within rounding and the line from pivot to pin
    /// has a direction.
    fn is_in_reach<T: Number>(&self, _q: T, state: &State<T>) -> bool {
        let (_, d, d2, slack) = self.stretched(state);
        let reach = d - T::of(self.offset).abs();
        d.is_finite() && d2.exceeds(T::default()) && !(-slack).exceeds(reach)
    }

    /// Places the guide across the line from pivot to pin: positions only.
    fn align<T: Number>(&self, _q: T, state: &mut State<T>) {
        let (w, _, d2, _) = self.stretched(state);
        let across = Vec2::new(T::default(), -T::of(self.offset));
        let t = w.turned(across) * (T::exactly(1.0) / d2);
        self.place::<T, { POSITION }>(t, T::default(), state);
    }

    fn reserve<T: Number>(&self, _q: T, state: &State<T>) -> T {
        let w = state.points[self.pin.index()].p - state.points[self.pivot.index()].p;
        w.norm() - T::of(self.offset).abs()
    }

    fn pivots(&self) -> Option<[PointId; 2]> {
        Some([self.pivot, self.pin])
    }

    fn arm_difference(&self, _q: Series) -> f64 {
        self.offset.hi
    }

    /// Returns the vector from pivot to pin and the guide's offset, in series.
    fn in_series(
        &self,
        _q: Series,
        snap: SingularShift,
        terms: usize,
        state: &State<Series>,
    ) -> SwingSeries {
        let w = shifted(between(self.pivot, self.pin, state), snap, terms);
        let offset = if snap.equal_arms {
            Series::default()
        } else {
            Series::of(self.offset)
        };
        SwingSeries { w, e: offset }
    }

    fn right_angle(&self, _q: Series, state: &State<Series>) -> f64 {
        let w = between(self.pivot, self.pin, state);
        w.map(|v| v.cut(1)).norm2().nearest()
    }

    fn run_through(
        &self,
        q: Series,
        snap: SingularShift,
        height: Series,
        state: &mut State<Series>,
    ) {
        let SwingSeries { w, e } = self.in_series(q, snap, TERMS, state);
        let t = quotient(w.turned(Vec2::new(height, -e)), w, w.norm2(), snap.pair);
        self.place::<Series, POSITION>(t, height, state);
    }
}

/// The vector from pivot to pin and the guide's offset from the pivot, in series.
pub(super) struct SwingSeries {
    w: Vec2<Series>,
    e: Series,
}

impl InSeries for SwingSeries {
    /// s^2 = w^2 - e^2.
    fn square(&self) -> Series {
        self.w.norm2() - self.e * self.e
    }

    fn height(&self) -> Height {
        let SwingSeries { w, e } = *self;
        Height {
            square: self.square(),
            size: squared(w)[1] + e * e,
            slopes: [w.x.scaled(2.0), w.y.scaled(2.0)],
        }
    }
}

/// The backward pass: the couple on the arm presses its guide against the pin.
#[derive(Clone, Debug)]
pub(in crate::solver) struct SwingBackward {
    pivot: PointId,
    pin: PointId,
    link: LinkId,
    along: Vec2<Constant>,
    slot: Slot,
    slide: Option<SlideId>,
    /// The links between the pin and the slide, each loaded by the force at both ends.
    legs: Vec<LegSite>,
}

impl BackwardPass for SwingBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let at = |point: PointId| -> Vec2<T> { state.points[point.index()].p };
        let t = Vec2::of(self.along).turned(state.links[self.link.index()].d);
        let s = t.dot(at(self.pin) - at(self.pivot));
        let across = forces.couple(self.link) / s;
        let force = t.perp() * across;
        forces.points[self.pin.index()] += force;
        forces.points[self.pivot.index()] += -force;
        forces.note(self.slot, force);
        let Some(slide) = self.slide else { return };
        forces.normals[slide.index()] = across;
        for leg in &self.legs {
            forces.note(leg.slots[0], force);
            forces.note(leg.slots[1], -force);
            let [out, near] = leg.joints.map(at);
            forces.couples[leg.link.index()] += (out - near).cross(force);
        }
    }
}
