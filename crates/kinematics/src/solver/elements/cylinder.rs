//! Solves the dyad RRR with a driven arm: a cylinder between moving links.

use super::singular_series::{SeriesTriangle, SingularShift, between, shifted};
use super::{
    ACCELERATION, Arm, BackwardPass, Dyad, Element, FRAMES, POSITION, REACH_SLACK, RelativeMotion,
    StepOutcome, Stretching, TwoAssemblies, VELOCITY, settled, triangle_reserve,
};
use crate::arithmetic::{Series, TERMS};
use crate::solver::forces::{ArmSite, ForceState, Site};
use crate::solver::further_inputs::{Following, InputMotion};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, PointState, State};
use crate::solver::transmission::{InnerJoint, Ray};
use crate::{Constant, LinkId, Number, PointId, SlideId, Vec2};

/// An arm whose end is pushed along a guide of its own link, and a circle: a cylinder. The sign is
/// +1 if the point lies on the left of pivot -> far.pivot.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Cylinder {
    pub point: PointId,
    pub pivot: PointId,
    pub link: LinkId,
    /// The guide's point and direction in the frame of the link, relative to the pivot.
    pub through: Vec2<Constant>,
    pub along: Vec2<Constant>,
    pub far: Arm,
    pub group: usize,
    pub slide: SlideId,
    /// The law by which its input follows the driver; `None` if it is the driver.
    pub following: Option<Following>,
}

/// The triangle of a cylinder's two pivots and its pin.
#[derive(Clone, Copy)]
struct Triangle<T> {
    /// The square of the arm, and its length.
    rho2: T,
    rho: T,
    /// The vector from pivot to pivot, and its square.
    u: Vec2<T>,
    d2: T,
    /// The distances of the pivots from the arms' inner and outer limit.
    inner: T,
    outer: T,
    /// 16 A^2.
    product: T,
}

impl Cylinder {
    #[inline(always)]
    fn input<T: Number>(&self, q: T) -> InputMotion<T> {
        InputMotion::of(self.following.as_ref(), q)
    }

    /// Returns the arm in the frame of its link.
    #[inline(always)]
    fn local<T: Number>(&self, q: T) -> Vec2<T> {
        Vec2::of(self.through) + Vec2::of(self.along) * self.input(q).p
    }

    /// Returns the square of the arm.
    #[inline(always)]
    fn arm_square<T: Number>(&self, q: T) -> T {
        self.local(q).norm2()
    }

    #[inline(always)]
    fn triangle<T: Number>(&self, q: T, state: &State<T>) -> Triangle<T> {
        let rho2 = self.arm_square(q);
        let (rho, c) = (rho2.sqrt(), self.far.length::<T>());
        let u = state.points[self.far.pivot.index()].p - state.points[self.pivot.index()].p;
        let d2 = u.norm2();
        let d = d2.sqrt();
        let difference = (rho - c).abs();
        let (inner, outer) = (d - difference, (rho + c) - d);
        let product = (inner * (d + difference)) * (outer * ((rho + c) + d));
        Triangle {
            rho2,
            rho,
            u,
            d2,
            inner,
            outer,
            product,
        }
    }

    /// Returns the vector e from the pivot to the point, for e x f = `sh`.
    #[inline(always)]
    fn arm<T: Number>(&self, of: &Triangle<T>, sh: T) -> Vec2<T> {
        let c = self.far.length::<T>();
        let x = (of.d2 + (of.rho - c) * (of.rho + c)).scaled(0.5);
        (of.u * x + of.u.perp() * sh) / of.d2
    }

    /// Stores the dyad with X = P + e = Q + f. With tau p' the guide's direction in the ground, V =
    /// V_P + w k x e + tau and A = A_P + alpha k x e - w^2 e + 2 w k x tau + tau p'' / p'.
    #[inline(always)]
    pub(in crate::solver) fn place<T: Number, const ORDER: u8>(
        &self,
        q: T,
        e: Vec2<T>,
        f: Vec2<T>,
        sh: T,
        state: &mut State<T>,
    ) {
        let local = self.local(q);
        let p = state.points[self.pivot.index()];
        let far = state.points[self.far.pivot.index()];
        let mut point = PointState::fixed(p.p + e);
        let mut barrel = LinkState::fixed(e.turned(local.conj()) / local.norm2());
        let mut link = LinkState::fixed(self.far.direction(f));
        if ORDER >= VELOCITY {
            let scale = T::exactly(1.0) / sh;
            let mut tau = Vec2::of(self.along).turned(barrel.d);
            let mut growing = Vec2::default();
            if self.following.is_some() {
                let InputMotion { w, a, .. } = self.input(q);
                (tau, growing) = (tau * w, tau * a);
            }
            let dv = far.v - p.v - tau;
            barrel.w = f.dot(dv) * scale;
            link.w = e.dot(dv) * scale;
            point.v = far.v + f.perp() * link.w;
            if ORDER >= ACCELERATION {
                let mut coriolis = tau.perp() * barrel.w.scaled(2.0);
                if self.following.is_some() {
                    coriolis += growing;
                }
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
    }
}

impl Element for Cylinder {
    type Back = CylinderBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Point(self.point));
        places(PlacedPart::Link(self.link));
        places(PlacedPart::Link(self.far.link));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.pivot));
        reads(PlacedPart::Point(self.far.pivot));
    }

    /// Solves as [`Circles`] does, but with an arm r = through + along q in its link's frame: a
    /// circle of variable radius.
    fn run<T: Number, const ORDER: u8>(
        &self,
        q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let of = self.triangle(q, state);
        let c = self.far.length.hi;
        let scale = of.rho2 * T::exactly(4.0 * c * c);
        state.set_measure(self.group, of.product / scale);
        let slack = (of.rho + T::exactly(c)).scaled(REACH_SLACK * T::RELATIVE_ROUNDING);
        if !of.inner.min(of.outer).exceeds(slack) {
            return StepOutcome::Unclear;
        }
        let sh = state.signs[self.group] * of.product.sqrt().scaled(0.5);
        let e = self.arm(&of, sh);
        self.place::<T, ORDER>(q, e, e - of.u, sh, state);
        StepOutcome::Done
    }

    fn dyad(&self) -> Option<Dyad<'_>> {
        Some(Dyad::Cylinder(self))
    }

    fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        place(&mut self.through);
        self.far = self.far.varied(place);
    }

    fn change_laws(&mut self, change: &mut impl FnMut(&mut Following)) {
        self.following.iter_mut().for_each(change);
    }

    fn back(&self, site: &Site<'_>) -> Option<CylinderBackward> {
        Some(CylinderBackward {
            point: self.point,
            barrel: site.barrel(self.link, self.pivot),
            along: self.along,
            far: site.reach(&self.far, self.point),
            slide: self.slide,
            following: self.following.clone(),
        })
    }

    fn rays(&self, state: &State) -> Option<[Ray; 2]> {
        let [barrel, far] =
            [self.pivot, self.far.pivot].map(|p| Ray::between(p, self.point, state));
        Some([barrel, far])
    }

    fn inner_joint(&self) -> Option<InnerJoint> {
        Some(InnerJoint::of_links(self.group))
    }
}

impl TwoAssemblies for Cylinder {
    type InSeries = SeriesTriangle;

    fn group(&self) -> usize {
        self.group
    }

    /// Returns `true` if the arms reach each other within rounding: see [`Circles::is_in_reach`].
    fn is_in_reach<T: Number>(&self, q: T, state: &State<T>) -> bool {
        let of = self.triangle(q, state);
        let size = of.rho + T::exactly(self.far.length.hi);
        let slack = size.scaled(REACH_SLACK * T::RELATIVE_ROUNDING);
        let misses = |reach: T| (-slack).exceeds(reach);
        let has_direction = of.rho.exceeds(T::default()) && of.d2.sqrt().exceeds(slack);
        of.d2.is_finite() && has_direction && !misses(of.inner) && !misses(of.outer)
    }

    /// Places the arms in line: see [`Circles::align`].
    fn align<T: Number>(&self, q: T, state: &mut State<T>) {
        let of = self.triangle(q, state);
        let e = self.arm(&of, T::default());
        self.place::<T, { POSITION }>(q, e, e - of.u, T::default(), state);
    }

    /// Returns `None`, because the cylinder's own reach changes.
    fn stretch_rate<T: Number>(&self, _state: &State<T>) -> Option<T> {
        None
    }

    /// Returns the stretching. The two components of its vectors are the rates of the pivots'
    /// distance and of the cylinder's own arm, as both change.
    fn stretching(&self, q: f64, _seen_from: LinkState, state: &State) -> Option<Stretching> {
        let of = self.triangle(q, state);
        let (local, along) = (self.local(q), self.along.nearest());
        let [near, far] = [self.pivot, self.far.pivot].map(|p| state.points[p.index()]);
        let (dv, da) = (far.v - near.v, far.a - near.a);
        let input = self.input(q);
        let (d, rho) = (of.d2.sqrt(), of.rho);
        let across = of.u.cross(dv) / d;
        let arm = local.dot(along) / rho;
        let is_inner = of.inner < of.outer;
        let longer = if rho < self.far.length.hi { 1.0 } else { -1.0 };
        let toward = Vec2::new(1.0, if is_inner { longer } else { -1.0 });
        let inwards = across * across / d;
        let speed = settled(of.u.dot(dv) / d, dv.norm());
        let rate = settled(of.u.dot(da) / d + inwards, da.norm().max(inwards));
        let v = Vec2::new(speed, arm * input.w);
        Some(Stretching {
            toward,
            growth: toward.dot(v),
            seen: [RelativeMotion {
                v,
                a: Vec2::new(rate, arm * input.a),
            }; FRAMES],
        })
    }

    fn reserve<T: Number>(&self, q: T, state: &State<T>) -> T {
        let arm = self.local(q);
        let u = state.points[self.far.pivot.index()].p - state.points[self.pivot.index()].p;
        triangle_reserve(u.norm(), arm.norm(), self.far.length::<T>())
    }

    fn pivots(&self) -> Option<[PointId; 2]> {
        Some([self.pivot, self.far.pivot])
    }

    fn arm_difference(&self, q: Series) -> f64 {
        (self.arm_square(q.cut(1)).sqrt() - Series::of(self.far.length)).nearest()
    }

    /// Returns the triangle in series.
    fn in_series(
        &self,
        q: Series,
        snap: SingularShift,
        terms: usize,
        state: &State<Series>,
    ) -> SeriesTriangle {
        let u = shifted(between(self.pivot, self.far.pivot, state), snap, terms);
        let rho2 = self.arm_square(q);
        let (b, c) = (rho2.sqrt(), Series::of(self.far.length));
        SeriesTriangle {
            u,
            d2: u.norm2(),
            least: (c - b) * (c - b),
            most: (c + b) * (c + b),
            squares: rho2 - c * c,
            pair: snap.pair,
        }
    }

    fn right_angle(&self, q: Series, _state: &State<Series>) -> f64 {
        self.arm_square(q.cut(1)).nearest() * self.far.length.hi.powi(2)
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
        self.place::<Series, POSITION>(q, e, e - triangle.u, height, state);
    }
}

/// The backward pass: two arms share the force. The driver takes the component along the barrel,
/// the guide takes the rest.
#[derive(Clone, Debug)]
pub(in crate::solver) struct CylinderBackward {
    point: PointId,
    barrel: ArmSite,
    along: Vec2<Constant>,
    far: ArmSite,
    slide: SlideId,
    following: Option<Following>,
}

impl BackwardPass for CylinderBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let force = forces.share(self.point, &self.barrel, &self.far, state);
        let tau = Vec2::of(self.along).turned(state.links[self.barrel.link.index()].d);
        forces.drive_by(self.following.as_ref(), force.dot(tau), state);
        forces.normals[self.slide.index()] = -tau.cross(force);
    }
}
