//! Compares the vector between two points of a link, as computed, with the link's shape, and
//! corrects it.
//!
//! Let d be the link's computed direction, omega and alpha its computed rates, and l the position
//! of one point relative to the other in the link's frame. With e the computed vector, and w and a
//! its rates,
//!
//! ```text
//! e = R(d) l + miss      w = omega k x e + rho      a = alpha k x e + omega k x w + sigma
//! ```
//!
//! where miss, rho and sigma would be zero without rounding errors. They are computed in
//! double-double. Everything derived from them is small, so doubles suffice. The true direction is
//! d (1 + s + i theta), the true rates are omega + omega' and alpha + alpha'. To first order, the
//! true vector and its rates are
//!
//! ```text
//! e + de     de = (s e - miss)                                + theta k x e
//! w + dw     dw = (omega k x de - rho)                        + omega' k x e
//! a + da     da = (alpha k x de + omega k x dw + omega' k x w - sigma) + alpha' k x e
//! ```
//!
//! The terms in brackets, the drift, are known before the rotation of that order. All sizes are
//! lengths of vectors, or upper bounds of these. The first order leaves out products of two errors:
//! of the rotation and the vector, at each order at most `slack` times the rotation; and others
//! where they arise.

use super::loaded_state::{Bodies, Places};
use super::shape::LinkShape;
use crate::arithmetic::U;
use crate::arithmetic::plane::Plane;

/// Rounding error of residuals in double-double, relative to the size of their terms.
pub(super) const RESIDUAL: f64 = 32.0 * U * U;
/// Maximum relative amount by which a vector may be longer than its link. Beyond it nothing is
/// proved.
const LONGER: f64 = 1.0 / 1_048_576.0;
/// Rounding error of a short sum of products in doubles, relative to the size of its terms.
pub(super) const SUM: f64 = 8.0 * U;
/// Additional rounding error of a rotation computed from a computed vector, including the low part
/// of e, relative to the vector's length: see [`meet`](super::meeting::meet).
const TURNING: f64 = 16.0 * U;

/// The change of a vector, or of its rate, without the rotation of its own order: the shift, its
/// maximum size, and the unknown part. The latter excludes the contribution of rests of lower
/// orders, see [`LinkVector::carried_rate`].
#[derive(Clone, Copy)]
pub(super) struct Drift<V> {
    pub shift: V,
    pub most: V,
    pub new: V,
}

/// The change of a vector: the first-order shift, its maximum size, and the unknown part.
#[derive(Clone, Copy)]
pub(super) struct ArmChange<V> {
    pub shift: V,
    pub most: V,
    pub rest: V,
}

/// The change of an angle or of its rates.
#[derive(Clone, Copy)]
pub(super) struct Turned<V> {
    pub shift: V,
    pub most: V,
    pub rest: V,
}

/// A vector between two points of a link with its residual, or two such vectors at once. The
/// residuals of the rates are computed on demand: they do not depend on the results of lower
/// orders, so both computations overlap.
pub(super) struct LinkVector<V, const FUSED: bool> {
    pub e: V,
    /// k x e, for the high and the low part of the vector.
    pub across: [V; 2],
    ends: [Places<V>; 2],
    omega: V,
    alpha: V,
    miss: V,
    /// The relative amount by which the true direction is longer than the computed one.
    pub stretch: V,
    /// Upper bound of |s e| + |miss|. `length` is an upper bound of |e|, and `open` the error of e
    /// from typed digits and residuals. It contains eight times the error of the residuals, so that
    /// its product with the link's rates also covers the residuals of the vector's rates.
    strain: V,
    pub length: V,
    open: V,
}

/// The rate of a vector.
pub(super) struct ArmRate<V> {
    /// k x w, for the high and the low part.
    across: [V; 2],
    /// Upper bound of |w|.
    speed: V,
}

impl<V: Plane, const FUSED: bool> LinkVector<V, FUSED> {
    /// Creates the vector from `p` to `x`, on a link whose direction is too short by `stretch`.
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
        LinkVector {
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

    /// Computes the rate of the vector, and rho.
    #[inline(always)]
    fn rate_residual(&self) -> ([V; 2], V) {
        let [x, p] = &self.ends;
        let [w, low] = x.v.plus(-p.v);
        let [across, lost] = self.across;
        let [turning, rest] = self.omega.times::<FUSED>(across);
        // The first two are nearly equal.
        let rho = (w - turning) + (low - (rest + self.omega * lost));
        ([w.perp(), low.perp()], rho)
    }

    /// Computes sigma.
    #[inline(always)]
    fn second_residual(&self, rate: &ArmRate<V>) -> V {
        let [x, p] = &self.ends;
        let [a, low] = x.a.plus(-p.a);
        let ([e, e_lost], [w, w_lost]) = (self.across, rate.across);
        let [turning, rest] = self.alpha.times::<FUSED>(e);
        let [driven, rest_driven] = self.omega.times::<FUSED>(w);
        let [sum, lost] = turning.plus(driven);
        let small = lost + (rest + rest_driven) + (self.alpha * e_lost + self.omega * w_lost);
        (a - sum) + (low - small)
    }

    /// Returns the drift of e.
    #[inline(always)]
    pub(super) fn drift(&self) -> Drift<V> {
        // The direction's length is 1 to first order in the stretch; the second order is part of
        // the strain.
        let rounding = self.stretch.abs() * 2.0 + SUM;
        Drift {
            shift: self.e * self.stretch - self.miss,
            most: self.strain,
            new: self.open + self.strain * rounding,
        }
    }

    /// Returns the drift of the rate, given the change of e, and the rate.
    #[inline(always)]
    pub(super) fn drift_of_rate(&self, e: &ArmChange<V>) -> (Drift<V>, ArmRate<V>) {
        let (across, rho) = self.rate_residual();
        let (omega, off) = (self.omega.abs(), rho.size());
        let maximum = omega * e.most + off;
        let drift = Drift {
            shift: e.shift.perp() * self.omega - rho,
            most: maximum,
            new: maximum * (2.0 * SUM),
        };
        let speed = omega * self.length + off;
        (drift, ArmRate { across, speed })
    }

    /// Returns the drift of the second rate, given the changes of e, w and the angular velocity.
    #[inline(always)]
    pub(super) fn drift_of_second(
        &self,
        [e, w]: [&ArmChange<V>; 2],
        rate: &ArmRate<V>,
        spin: &Turned<V>,
    ) -> Drift<V> {
        let sigma = self.second_residual(rate);
        let (omega, alpha) = (self.omega.abs(), self.alpha.abs());
        let maximum = alpha * e.most + omega * w.most + spin.most * rate.speed + sigma.size();
        Drift {
            shift: e.shift.perp() * self.alpha
                + w.shift.perp() * self.omega
                + rate.across[0] * spin.shift
                - sigma,
            most: maximum,
            new: spin.most * w.most + maximum * (2.0 * SUM),
        }
    }

    /// Returns the contribution of a rest of e to the rate.
    #[inline(always)]
    pub(super) fn carried_rate(&self, e: V) -> V {
        self.omega.abs() * e
    }

    /// Returns the contribution of a rest of e to the second rate.
    #[inline(always)]
    pub(super) fn carried_second(&self, e: V) -> V {
        self.alpha.abs() * e
    }

    /// Returns the contribution of rests of w and of the angular velocity to the second rate.
    #[inline(always)]
    pub(super) fn carried_by_rate(&self, w: V, rate: &ArmRate<V>, spin: V) -> V {
        self.omega.abs() * w + rate.speed * spin
    }

    /// Returns the limb with a length bound for a vector that may be longer than its link by any
    /// amount.
    #[inline(always)]
    pub(super) fn lengthened(self) -> Self {
        let length = self.length + self.strain;
        LinkVector { length, ..self }
    }

    /// Returns `true` if the vector is as long as the link, within tolerance. Written so that NaN
    /// gives `false`.
    #[inline(always)]
    pub(super) fn fits(&self) -> bool {
        (self.length * (0.5 * LONGER)).exceeds(self.strain)
    }

    /// Bounds the difference of the link's rotated vector from the computed one, if the link is off
    /// by `turned`.
    #[inline(always)]
    pub(super) fn slack(&self, turned: V) -> V {
        self.strain + self.length * (turned + TURNING)
    }

    /// Bounds the rotation by a displacement of the vector's end. The vector may be shorter than
    /// `length` by twice the tolerance of a longer one.
    #[inline(always)]
    pub(super) fn turning(&self, end: V) -> V {
        end * (1.0 + 3.0 * LONGER) / self.length
    }

    /// Returns the change of the vector or of its rate: its drift plus the rotation, with this
    /// rest.
    #[inline(always)]
    pub(super) fn way(&self, drift: &Drift<V>, turned: &Turned<V>, rest: V) -> ArmChange<V> {
        ArmChange {
            shift: drift.shift + self.across[0] * turned.shift,
            most: drift.most + self.length * turned.most,
            rest,
        }
    }
}
