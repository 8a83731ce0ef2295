//! Solves the dyad RRR: a joint at given distances from two known joints.
//!
//! With u = Q - P from pivot to pivot, b and c the arms, e = X - P and f = X - Q:
//!
//! ```text
//! |e| = b, |f| = c       e.V = e.V_P, f.V = f.V_Q       e x f = s h: twice the area of the triangle
//! ```

use super::singular_series::{SeriesTriangle, SingularShift, ZERO, between, shifted};
use super::{
    ACCELERATION, Arm, BackwardPass, Dyad, Element, POSITION, REACH_SLACK, StepOutcome,
    TwoAssemblies, VELOCITY, triangle_reserve,
};
use crate::arithmetic::{Series, TERMS};
use crate::solver::forces::{ArmSite, ForceState, Site};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, PointState, State};
use crate::solver::transmission::{InnerJoint, Ray};
use crate::{Constant, Number, PointId, Vec2};

/// Minimum number of known coefficients to conclude that a link does not rotate.
const MIN_KNOWN_COEFFICIENTS: usize = 8;

/// Two circles, RRR. The shorter arm comes first: the point is computed from its pivot. The sign of
/// the group is +1 if the point lies on the left of near.pivot -> far.pivot.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Circles {
    pub point: PointId,
    pub near: Arm,
    pub far: Arm,
    /// The squares of far - near and far + near, which are compared with the squared distance of
    /// the pivots without loss of digits.
    least: Constant,
    most: Constant,
    /// (near - far)(near + far).
    squares: Constant,
    /// 1 / (2 near far)^2, which scales the product of the reaches to the square of a sine.
    inverse_square: f64,
    /// Twice the minimum and maximum distance of the pivots, and the tolerance for reaching them.
    ends: [f64; 2],
    slack: f64,
    pub group: usize,
}

impl Circles {
    pub(in crate::solver) fn new(point: PointId, arms: [Arm; 2], group: usize) -> Circles {
        let [a, b] = arms;
        let arms = if (a.length - b.length).hi <= 0.0 {
            [a, b]
        } else {
            [b, a]
        };
        Circles::measured(point, arms, group)
    }

    /// Makes this pivot the near one, from which the point is computed.
    pub(in crate::solver) fn measure_from(&mut self, pivot: PointId) {
        if self.near.pivot != pivot {
            *self = Circles::measured(self.point, [self.far, self.near], self.group);
        }
    }

    fn measured(point: PointId, [near, far]: [Arm; 2], group: usize) -> Circles {
        let (b, c) = (near.length, far.length);
        Circles {
            point,
            near,
            far,
            least: (c - b) * (c - b),
            most: (c + b) * (c + b),
            squares: (b - c) * (b + c),
            inverse_square: (2.0 * b.hi * c.hi).powi(-2),
            ends: [2.0 * (c - b).hi.abs(), 2.0 * (c + b).hi],
            slack: REACH_SLACK * (b.hi + c.hi),
            group,
        }
    }

    /// Returns how far the squared distance of the pivots is above its minimum and below its
    /// maximum.
    #[inline(always)]
    fn reaches<T: Number>(&self, d2: T) -> (T, T) {
        if T::DERIVES_CONSTANTS {
            let [b, c] = [self.near.length::<T>(), self.far.length()];
            let [difference, sum] = [c - b, c + b];
            return (d2 - difference * difference, sum * sum - d2);
        }
        (d2 - T::of(self.least), T::of(self.most) - d2)
    }

    /// Returns (near - far)(near + far).
    #[inline(always)]
    fn squares<T: Number>(&self) -> T {
        if T::DERIVES_CONSTANTS {
            let [b, c] = [self.near.length::<T>(), self.far.length()];
            return (b - c) * (b + c);
        }
        T::of(self.squares)
    }

    /// Returns the tolerances of the reaches: (d + slack)^2 - d^2.
    #[inline(always)]
    fn slacks<T: Number>(&self) -> [T; 2] {
        let slack = self.slack * T::RELATIVE_ROUNDING;
        self.ends.map(|d| T::exactly(slack * (d + slack)))
    }

    /// Stores the dyad with X = P + e = Q + f. Uses V_P + w1 k x e = V_Q + w2 k x f, and e x f = s
    /// h.
    #[inline(always)]
    pub(in crate::solver) fn place<T: Number, const ORDER: u8>(
        &self,
        e: Vec2<T>,
        f: Vec2<T>,
        sh: T,
        state: &mut State<T>,
    ) {
        let p = state.points[self.near.pivot.index()];
        let q = state.points[self.far.pivot.index()];
        let mut point = PointState::fixed(p.p + e);
        let mut near = LinkState::fixed(self.near.direction(e));
        let mut far = LinkState::fixed(self.far.direction(f));
        if ORDER >= VELOCITY {
            let scale = T::exactly(1.0) / sh;
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
    }

    /// Restores the direction of a link that passes a change point without rotating, as in a
    /// parallelogram. The square root of the height has lost coefficients of this link which are
    /// nevertheless known.
    pub(in crate::solver) fn translate(&self, state: &mut State<Series>) {
        let stays = |v: Series| {
            let mut rest = v.c[..v.known].iter().skip(1);
            v.known >= MIN_KNOWN_COEFFICIENTS && rest.all(|c| c.hi.abs() <= ZERO)
        };
        for arm in [&self.near, &self.far] {
            let link = &mut state.links[arm.link.index()].d;
            if !(stays(link.x) && stays(link.y)) {
                continue;
            }
            *link = link.map(|v| Series::constant(v.c[0]));
            let pivot = state.points[arm.pivot.index()].p;
            let point = &mut state.points[self.point.index()].p;
            *point = pivot + (*point - pivot).map(|v| Series::constant(v.c[0]));
            return;
        }
    }

    /// Returns the vector from pivot to pivot.
    #[inline(always)]
    pub(in crate::solver) fn between<T: Number>(&self, state: &State<T>) -> Vec2<T> {
        let at = |pivot: PointId| state.points[pivot.index()].p;
        at(self.far.pivot) - at(self.near.pivot)
    }
}

impl Element for Circles {
    const IS_FREQUENT: bool = true;
    const HAS_RESIDUALS: bool = true;
    type Back = CirclesBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Point(self.point));
        places(PlacedPart::Link(self.near.link));
        places(PlacedPart::Link(self.far.link));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.near.pivot));
        reads(PlacedPart::Point(self.far.pivot));
    }

    /// X = P + (x u + s h k x u) / u.u with u = Q - P, x = (u.u + b^2 - c^2) / 2 and h twice the
    /// area of the triangle of sides b, c, |u|: 16 A^2 = (d^2 - m^2)(M^2 - d^2), m = c - b, M = b +
    /// c.
    ///
    /// These are the factors of Kahan's product (Miscalculating Area and Angles of a Needle-like
    /// Triangle), two by two. d enters by its square, because the root would only add a rounding
    /// error.
    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let u = self.between(state);
        let d2 = u.norm2();
        let (inner, outer) = self.reaches(d2);
        let product = inner * outer;
        let measure = product * T::exactly(self.inverse_square);
        let [minimum, maximum] = self.slacks();
        if !(inner.exceeds(minimum) && outer.exceeds(maximum)) {
            state.set_measure(self.group, measure);
            return StepOutcome::Unclear;
        }
        let x = (d2 + self.squares::<T>()).scaled(0.5);
        let inverse = T::exactly(1.0) / d2;
        let sh = state.signs[self.group].scaled(0.5) * product.sqrt();
        let e = (u * x + u.perp() * sh) * inverse;
        self.place::<T, ORDER>(e, e - u, sh, state);
        // Stored last: after a store, the compiler checks the indices of the pivots again.
        state.set_measure(self.group, measure);
        StepOutcome::Done
    }

    fn dyad(&self) -> Option<Dyad<'_>> {
        Some(Dyad::Circles(self))
    }

    fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        let arms = [self.near, self.far].map(|arm| arm.varied(place));
        *self = Circles::measured(self.point, arms, self.group);
    }

    fn back(&self, site: &Site<'_>) -> Option<CirclesBackward> {
        Some(CirclesBackward {
            point: self.point,
            near: site.reach(&self.near, self.point),
            far: site.reach(&self.far, self.point),
        })
    }

    fn rays(&self, state: &State) -> Option<[Ray; 2]> {
        let [near, far] =
            [&self.near, &self.far].map(|arm| Ray::between(arm.pivot, self.point, state));
        Some([near, far])
    }

    fn inner_joint(&self) -> Option<InnerJoint> {
        Some(InnerJoint::of_links(self.group))
    }
}

impl TwoAssemblies for Circles {
    type InSeries = SeriesTriangle;

    fn group(&self) -> usize {
        self.group
    }

    /// Returns `true` if the arms reach each other within rounding and their direction is defined.
    fn is_in_reach<T: Number>(&self, _q: T, state: &State<T>) -> bool {
        let u = self.between(state);
        let d2 = u.norm2();
        let (inner, outer) = self.reaches(d2);
        let [minimum, maximum] = self.slacks::<T>();
        let is_open = (-minimum).exceeds(inner) || (-maximum).exceeds(outer);
        let slack = T::exactly(self.slack * T::RELATIVE_ROUNDING);
        // With equal arms about one pivot, the point could be anywhere around it.
        d2.is_finite() && T::norm(u).exceeds(slack) && !is_open
    }

    /// Places the arms in line: positions only. The near arm keeps its length even if the pivots
    /// almost coincide.
    fn align<T: Number>(&self, _q: T, state: &mut State<T>) {
        let u = self.between(state);
        let x = u.norm2() + T::exactly(self.squares.hi);
        let length = self.near.length::<T>();
        let along = if x.nearest() < 0.0 { -length } else { length };
        let e = u * (along / T::norm(u));
        self.place::<T, { POSITION }>(e, e - u, T::default(), state);
    }

    fn reserve<T: Number>(&self, _q: T, state: &State<T>) -> T {
        let [b, c] = [self.near.length, self.far.length].map(T::of);
        triangle_reserve(self.between(state).norm(), b, c)
    }

    fn pivots(&self) -> Option<[PointId; 2]> {
        Some([self.near.pivot, self.far.pivot])
    }

    fn arm_difference(&self, _q: Series) -> f64 {
        (self.near.length - self.far.length).hi
    }

    /// Returns the triangle in series.
    fn in_series(
        &self,
        _q: Series,
        snap: SingularShift,
        terms: usize,
        state: &State<Series>,
    ) -> SeriesTriangle {
        let u = shifted(between(self.near.pivot, self.far.pivot, state), snap, terms);
        let (b, c) = (self.near.length, self.far.length);
        let c = if snap.equal_arms { b } else { c };
        let [minimum, maximum, squares] =
            [(c - b) * (c - b), (c + b) * (c + b), (b - c) * (b + c)].map(Series::of);
        SeriesTriangle {
            u,
            d2: u.norm2(),
            least: minimum,
            most: maximum,
            squares,
            pair: snap.pair,
        }
    }

    fn right_angle(&self, _q: Series, _state: &State<Series>) -> f64 {
        self.near.length.hi.powi(2) * self.far.length.hi.powi(2)
    }

    fn run_through(
        &self,
        q: Series,
        snap: SingularShift,
        height: Series,
        state: &mut State<Series>,
    ) {
        let triangle = self.in_series(q, snap, TERMS, state);
        let e = triangle.arm(height);
        self.place::<Series, POSITION>(e, e - triangle.u, height, state);
    }
}

/// The backward pass: two arms share the force at their joint.
#[derive(Clone, Debug)]
pub(in crate::solver) struct CirclesBackward {
    point: PointId,
    near: ArmSite,
    far: ArmSite,
}

impl BackwardPass for CirclesBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        forces.share(self.point, &self.near, &self.far, state);
    }
}
