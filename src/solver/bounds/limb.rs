//! Two points of one link: by how much the way between them, as computed, misses what the link says of it, and
//! what the true way is then.
//!
//! With d the link's computed direction, omega and alpha its computed rates, l the place of the one point seen from
//! the other in the link's frame, and e the computed way with its rates w and a,
//!
//! ```text
//! e = R(d) l + miss      w = omega k x e + rho      a = alpha k x e + omega k x w + sigma
//! ```
//!
//! where miss, rho and sigma would be zero without rounding. They are found in twice the digits; everything that
//! follows from them is small, and doubles will do. The true direction is d (1 + s + i theta), the true rates are
//! omega + omega' and alpha + alpha', and so the true way and its rates are, to the first order,
//!
//! ```text
//! e + de     de = (s e - miss)                                + theta k x e
//! w + dw     dw = (omega k x de - rho)                        + omega' k x e
//! a + da     da = (alpha k x de + omega k x dw + omega' k x w - sigma) + alpha' k x e
//! ```
//!
//! What is in brackets is known before the order's own turning: the drift. All sizes are lengths of vectors, or more.
//! What the first order leaves out are products of two errors: one of the turning with one of the way, at each order
//! at most `slack` times the turning; and the others where they arise.

use super::errors::size;
use super::shape::{Shape, turned_closely};
use crate::arithmetic::{Halves, U, two_sum};
use crate::solver::state::{LinkState, PointState};
use crate::{Number, Vec2};

/// What residuals in twice the precision still round, in parts of the size of their terms.
pub(super) const RESIDUAL: f64 = 32.0 * U * U;
/// A way may be longer than its link says by this part of it; beyond that nothing is said of it.
const LONGER: f64 = 1.0 / 1_048_576.0;
/// What a short sum of products in doubles rounds, in parts of the size of its terms.
pub(super) const SUM: f64 = 8.0 * U;
/// What a turning found by a computed way rounds besides, and what e leaves out of that, in parts of the way: see
/// [`meet`](super::meeting::meet).
const TURNING: f64 = 16.0 * U;

/// What moves a way, or a rate of it, besides the order's own turning: the shift, how far it is moved at most, and what
/// is not known of it but for what the rests of lower orders make of it, see [`Limb::carried_rate`].
#[derive(Clone, Copy)]
pub(super) struct Drift<T> {
    pub shift: Vec2<T>,
    pub most: T,
    pub new: T,
}

/// What moves a vector: the shift to the first order, how far it is moved at most, and what is not known of it.
#[derive(Clone, Copy)]
pub(super) struct Moved<T> {
    pub shift: Vec2<T>,
    pub most: T,
    pub rest: T,
}

/// The same of an angle or of its rates.
#[derive(Clone, Copy)]
pub(super) struct Turned<T> {
    pub shift: T,
    pub most: T,
    pub rest: T,
}

/// A way between two points of a link, with what it misses; or two such at once. What the rates miss is found when it is
/// asked for: it has nothing to do with what the orders before have come to, and so takes no time beside that.
pub(super) struct Limb<T, const FUSED: bool> {
    pub e: Vec2<T>,
    /// What e leaves out of the way.
    lost: Vec2<T>,
    halves: Vec2<Halves<T, FUSED>>,
    ends: [PointState<T>; 2],
    link: LinkState<T>,
    miss: Vec2<T>,
    /// By how much the true direction is longer than the computed one.
    pub stretch: T,
    /// |s e| + |miss| at most, |e| at most, and what typed digits and residuals leave open of e: eight times as much
    /// of residuals as theirs, which covers, times the link's rates, the residuals of the way's.
    strain: T,
    pub length: T,
    open: T,
}

/// The rate of a way.
pub(super) struct Rate<T> {
    w: Vec2<T>,
    /// What w leaves out.
    lost: Vec2<T>,
    /// |w| at most.
    speed: T,
}

/// x - p, and what that leaves out.
#[inline(always)]
fn difference<T: Number>(x: Vec2<T>, p: Vec2<T>) -> [Vec2<T>; 2] {
    let (dx, lost_x) = two_sum(x.x, -p.x);
    let (dy, lost_y) = two_sum(x.y, -p.y);
    [Vec2::new(dx, dy), Vec2::new(lost_x, lost_y)]
}

impl<T: Number, const FUSED: bool> Limb<T, FUSED> {
    /// From `p` to `x`, on a link in a direction that is too short by `stretch`.
    #[inline(always)]
    pub(super) fn new(
        x: &PointState<T>,
        p: &PointState<T>,
        link: &LinkState<T>,
        shape: &Shape<T>,
        stretch: T,
    ) -> Self {
        let [e, lost] = difference(x.p, p.p);
        let [carried, low] =
            turned_closely::<T, FUSED>([shape.local, shape.low], shape.is_straight, link.d);
        let miss = (e - carried) + (lost - low);
        let strain = size(miss) + stretch.abs() * shape.length;
        let length = shape.length * T::exactly(1.0 + LONGER);
        Limb {
            e,
            lost,
            halves: e.map(Halves::of),
            ends: [*x, *p],
            link: *link,
            miss,
            stretch,
            strain,
            length,
            open: shape.off + length * T::exactly(8.0 * RESIDUAL),
        }
    }

    /// The rate of the way, and rho.
    #[inline(always)]
    fn see_rate(&self) -> ([Vec2<T>; 2], Vec2<T>) {
        let [x, p] = &self.ends;
        let [w, low] = difference(x.v, p.v);
        let (spin, omega, lost) = (self.link.w, Halves::of(self.link.w), self.lost);
        // w + omega (e.y, -e.x), the products largest and almost opposite.
        let (y, x) = (omega.times(self.halves.y), omega.times(self.halves.x));
        let rho = Vec2::new(
            (w.x + y.hi) + (low.x + (y.lo + spin * lost.y)),
            (w.y - x.hi) + (low.y - (x.lo + spin * lost.x)),
        );
        ([w, low], rho)
    }

    /// Sigma.
    #[inline(always)]
    fn see_second(&self, rate: &Rate<T>) -> Vec2<T> {
        let [x, p] = &self.ends;
        let [a, low] = difference(x.a, p.a);
        let LinkState {
            w: spin, a: gain, ..
        } = self.link;
        let (omega, alpha) = (Halves::<T, FUSED>::of(spin), Halves::of(gain));
        // alpha e + omega w, of one component.
        let part = |e: Halves<T, FUSED>, lost: T, w: T, low: T| {
            let (turning, driven) = (alpha.times(e), omega.times(Halves::of(w)));
            let (sum, rest) = two_sum(turning.hi, driven.hi);
            let small = rest + (turning.lo + driven.lo) + (gain * lost + spin * low);
            (sum, small)
        };
        let y = part(self.halves.y, self.lost.y, rate.w.y, rate.lost.y);
        let x = part(self.halves.x, self.lost.x, rate.w.x, rate.lost.x);
        Vec2::new((a.x + y.0) + (low.x + y.1), (a.y - x.0) + (low.y - x.1))
    }

    /// What moves e besides the turning.
    #[inline(always)]
    pub(super) fn drift(&self) -> Drift<T> {
        // The direction's length is 1 to the first order in the stretch; the second is in the strain.
        let rounding = T::exactly(SUM) + self.stretch.abs().scaled(2.0);
        Drift {
            shift: self.e * self.stretch - self.miss,
            most: self.strain,
            new: self.open + self.strain * rounding,
        }
    }

    /// The same of its rate, once it is known what moves e; and that rate.
    #[inline(always)]
    pub(super) fn drift_of_rate(&self, e: &Moved<T>) -> (Drift<T>, Rate<T>) {
        let ([w, lost], rho) = self.see_rate();
        let (omega, off) = (self.link.w.abs(), size(rho));
        let most = omega * e.most + off;
        let drift = Drift {
            shift: e.shift.perp() * self.link.w - rho,
            most,
            new: most * T::exactly(2.0 * SUM),
        };
        let speed = omega * self.length + off;
        (drift, Rate { w, lost, speed })
    }

    /// The same of its second rate, once it is known what moves the angular velocity.
    #[inline(always)]
    pub(super) fn drift_of_second(
        &self,
        [e, w]: [&Moved<T>; 2],
        rate: &Rate<T>,
        spin: &Turned<T>,
    ) -> Drift<T> {
        let sigma = self.see_second(rate);
        let (omega, alpha) = (self.link.w.abs(), self.link.a.abs());
        let most = alpha * e.most + omega * w.most + spin.most * rate.speed + size(sigma);
        Drift {
            shift: e.shift.perp() * self.link.a
                + w.shift.perp() * self.link.w
                + rate.w.perp() * spin.shift
                - sigma,
            most,
            new: spin.most * w.most + most * T::exactly(2.0 * SUM),
        }
    }

    /// What a rest of e makes of the rate.
    #[inline(always)]
    pub(super) fn carried_rate(&self, e: T) -> T {
        self.link.w.abs() * e
    }

    /// What a rest of e makes of the second rate.
    #[inline(always)]
    pub(super) fn carried_second(&self, e: T) -> T {
        self.link.a.abs() * e
    }

    /// What rests of w and of the angular velocity make of it.
    #[inline(always)]
    pub(super) fn carried_by_rate(&self, w: T, rate: &Rate<T>, spin: T) -> T {
        self.link.w.abs() * w + rate.speed * spin
    }

    /// The same of a way that may be longer than its link says by as much as it likes.
    #[inline(always)]
    pub(super) fn lengthened(self) -> Self {
        let length = self.length + self.strain;
        Limb { length, ..self }
    }

    /// Whether the way is as long as the link says. Written so that NaN is not.
    #[inline(always)]
    pub(super) fn fits(&self) -> bool {
        (self.length * T::exactly(0.5 * LONGER)).exceeds(self.strain)
    }

    /// How far the way that the link turns can be from the computed one, if the link is off by so much.
    #[inline(always)]
    pub(super) fn slack(&self, turned: T) -> T {
        self.strain + self.length * (turned + T::exactly(TURNING))
    }

    /// What moves the way, or a rate of it: its drift and the turning, with this rest.
    #[inline(always)]
    pub(super) fn way(&self, drift: &Drift<T>, turned: &Turned<T>, rest: T) -> Moved<T> {
        Moved {
            shift: drift.shift + self.e.perp() * turned.shift,
            most: drift.most + self.length * turned.most,
            rest,
        }
    }
}
