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

use super::places::{Bodies, Places};
use super::shape::LinkShape;
use crate::arithmetic::U;
use crate::arithmetic::plane::Plane;

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
pub(super) struct Drift<V> {
    pub shift: V,
    pub most: V,
    pub new: V,
}

/// What moves a vector: the shift to the first order, how far it is moved at most, and what is not known of it.
#[derive(Clone, Copy)]
pub(super) struct Moved<V> {
    pub shift: V,
    pub most: V,
    pub rest: V,
}

/// The same of an angle or of its rates.
#[derive(Clone, Copy)]
pub(super) struct Turned<V> {
    pub shift: V,
    pub most: V,
    pub rest: V,
}

/// A way between two points of a link, with what it misses; or two such at once. What the rates miss is found when it is
/// asked for: it has nothing to do with what the orders before have come to, and so takes no time beside that.
pub(super) struct Limb<V, const FUSED: bool> {
    pub e: V,
    /// k x e, and of what e leaves out of the way.
    pub across: [V; 2],
    ends: [Places<V>; 2],
    omega: V,
    alpha: V,
    miss: V,
    /// By how much the true direction is longer than the computed one.
    pub stretch: V,
    /// |s e| + |miss| at most, |e| at most, and what typed digits and residuals leave open of e: eight times as much
    /// of residuals as theirs, which covers, times the link's rates, the residuals of the way's.
    strain: V,
    pub length: V,
    open: V,
}

/// The rate of a way.
pub(super) struct LimbRate<V> {
    /// k x w, and of what w leaves out.
    across: [V; 2],
    /// |w| at most.
    speed: V,
}

impl<V: Plane, const FUSED: bool> Limb<V, FUSED> {
    /// From `p` to `x`, on a link in a direction that is too short by `stretch`.
    #[inline(always)]
    pub(super) fn new(
        x: &Places<V>,
        p: &Places<V>,
        link: &Bodies<V>,
        shape: &LinkShape<V>,
        stretch: V,
    ) -> Self {
        let [e, lost] = x.p.plus(-p.p);
        let [carried, low] = shape.turned::<FUSED>(link.d);
        let miss = (e - carried) + (lost - low);
        let strain = miss.size() + stretch.abs() * shape.length;
        let length = shape.length * (1.0 + LONGER);
        Limb {
            e,
            across: [e.perp(), lost.perp()],
            ends: [*x, *p],
            omega: link.rates.x(),
            alpha: link.rates.y(),
            miss,
            stretch,
            strain,
            length,
            open: shape.off + length * (8.0 * RESIDUAL),
        }
    }

    /// The rate of the way, and rho.
    #[inline(always)]
    fn see_rate(&self) -> ([V; 2], V) {
        let [x, p] = &self.ends;
        let [w, low] = x.v.plus(-p.v);
        let [across, lost] = self.across;
        let [turning, rest] = self.omega.times::<FUSED>(across);
        // The first two are all but equal.
        let rho = (w - turning) + (low - (rest + self.omega * lost));
        ([w.perp(), low.perp()], rho)
    }

    /// Sigma.
    #[inline(always)]
    fn see_second(&self, rate: &LimbRate<V>) -> V {
        let [x, p] = &self.ends;
        let [a, low] = x.a.plus(-p.a);
        let ([e, e_lost], [w, w_lost]) = (self.across, rate.across);
        let [turning, rest] = self.alpha.times::<FUSED>(e);
        let [driven, rest_driven] = self.omega.times::<FUSED>(w);
        let [sum, lost] = turning.plus(driven);
        let small = lost + (rest + rest_driven) + (self.alpha * e_lost + self.omega * w_lost);
        (a - sum) + (low - small)
    }

    /// What moves e besides the turning.
    #[inline(always)]
    pub(super) fn drift(&self) -> Drift<V> {
        // The direction's length is 1 to the first order in the stretch; the second is in the strain.
        let rounding = self.stretch.abs() * 2.0 + SUM;
        Drift {
            shift: self.e * self.stretch - self.miss,
            most: self.strain,
            new: self.open + self.strain * rounding,
        }
    }

    /// The same of its rate, once it is known what moves e; and that rate.
    #[inline(always)]
    pub(super) fn drift_of_rate(&self, e: &Moved<V>) -> (Drift<V>, LimbRate<V>) {
        let (across, rho) = self.see_rate();
        let (omega, off) = (self.omega.abs(), rho.size());
        let most = omega * e.most + off;
        let drift = Drift {
            shift: e.shift.perp() * self.omega - rho,
            most,
            new: most * (2.0 * SUM),
        };
        let speed = omega * self.length + off;
        (drift, LimbRate { across, speed })
    }

    /// The same of its second rate, once it is known what moves the angular velocity.
    #[inline(always)]
    pub(super) fn drift_of_second(
        &self,
        [e, w]: [&Moved<V>; 2],
        rate: &LimbRate<V>,
        spin: &Turned<V>,
    ) -> Drift<V> {
        let sigma = self.see_second(rate);
        let (omega, alpha) = (self.omega.abs(), self.alpha.abs());
        let most = alpha * e.most + omega * w.most + spin.most * rate.speed + sigma.size();
        Drift {
            shift: e.shift.perp() * self.alpha
                + w.shift.perp() * self.omega
                + rate.across[0] * spin.shift
                - sigma,
            most,
            new: spin.most * w.most + most * (2.0 * SUM),
        }
    }

    /// What a rest of e makes of the rate.
    #[inline(always)]
    pub(super) fn carried_rate(&self, e: V) -> V {
        self.omega.abs() * e
    }

    /// What a rest of e makes of the second rate.
    #[inline(always)]
    pub(super) fn carried_second(&self, e: V) -> V {
        self.alpha.abs() * e
    }

    /// What rests of w and of the angular velocity make of it.
    #[inline(always)]
    pub(super) fn carried_by_rate(&self, w: V, rate: &LimbRate<V>, spin: V) -> V {
        self.omega.abs() * w + rate.speed * spin
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
        (self.length * (0.5 * LONGER)).exceeds(self.strain)
    }

    /// How far the way that the link turns can be from the computed one, if the link is off by so much.
    #[inline(always)]
    pub(super) fn slack(&self, turned: V) -> V {
        self.strain + self.length * (turned + TURNING)
    }

    /// How far something at the end of the way turns it at most: the way may be as much shorter than `length` as it may
    /// be longer than its link says, twice.
    #[inline(always)]
    pub(super) fn turning(&self, end: V) -> V {
        end * (1.0 + 3.0 * LONGER) / self.length
    }

    /// What moves the way, or a rate of it: its drift and the turning, with this rest.
    #[inline(always)]
    pub(super) fn way(&self, drift: &Drift<V>, turned: &Turned<V>, rest: V) -> Moved<V> {
        Moved {
            shift: drift.shift + self.across[0] * turned.shift,
            most: drift.most + self.length * turned.most,
            rest,
        }
    }
}
