//! Computes how arms must rotate so that their ends meet, and how unknown errors propagate.
//!
//! An arm from P ends at P + e; its true end is P + dP + e + de. The part of de that does not
//! depend on the rotation theta is the drift c, see [`limb`](super::limb). Two arms therefore meet
//! where
//!
//! ```text
//! theta1 k x e1 - theta2 k x e2 = D,     D = (dP2 + c2) - (dP1 + c1)
//! ```
//!
//! An arm on a rail, or towards a known point, has one such equation in theta. The equation is the
//! same at each order, for the angles and their rates, with the D of that order. Let M be the
//! inverse of this matrix. A D of length r rotates arm i by at most g_i r: these are the gains.
//!
//! Krawczyk's operator N(theta) = theta - M F(theta) proves that a solution is near (Rump,
//! Verification methods, Acta Numerica 19, 2010, section 13). F is the gap between the ends. The
//! columns of F' are the true vectors rotated by theta, times k. Within |theta_i| <= 3/2 g_i r,
//! with r the gap at theta = 0, they are within the slack of the computed vectors. Measured by the
//! largest |theta_i| / g_i, N therefore shrinks distances at least by q = sum g_i slack_i. If q <=
//! 1/4, it maps this neighbourhood into itself, with an eighth of r to spare: there is exactly one
//! solution. The matrix of the rates is F' there, so the rates are at most 3/2 g_i r as well. To
//! first order they are M D. The part left out, with the error that each arm leaves open, is
//! another gap, and rotates each arm by at most g_i times it.
//!
//! M is computed in doubles. That moves theta_i by at most 6 u + 2 u |e1| |e2| / |det| of g_i r.
//! Since the ratio |e1| |e2| / |det| is g_i |e_i| >= 1 in every case, it is as if the columns were
//! off by 4 u |e_i|. The slack includes this, the low part of the difference of the vector's
//! points, and the rounding of the sums of the vector's shift.
//!
//! The rest of a joint comes from the error that each arm leaves open, as a vector of at most that
//! length, and from the rest of the arm's pivot. It moves the joint along the other arm by at most
//! |e_i| g_i times its size. With R the sum of all that, the vector of arm i has a rest of at most
//! (1 + |e_i| g_i) R, and its angle of at most g_i R. The contribution of one order's rests to the
//! next is thus known as a multiple of R before R is.

use super::influence::Influences;
use super::link_vector::{ArmChange, Drift, LinkVector, RESIDUAL, Turned};
use super::off::{LinkOff, PointOff, rounding};
use crate::arithmetic::plane::Plane;
use crate::solver::elements::{ACCELERATION, VELOCITY};

/// Maximum contraction factor of Krawczyk's operator. Beyond it nothing is proved.
const CONTRACTION: f64 = 0.25;
/// Maximum ratio of an arm's rotation to its first-order value.
const GROWTH: f64 = 1.5;

/// The condition on the ends of one or two arms. Values common to all arms are in all lanes.
pub(super) trait ArmClosure<V> {
    /// Returns the gains.
    fn gains(&self) -> V;

    /// Returns the rotations that close the gap at an order, for these errors of the ends, and the
    /// size of the gap.
    fn close(&self, order: usize, ends: V) -> (V, V);

    /// Adds the unknown error of the ends' target at an order to that of the ends.
    fn with_rest(&self, order: usize, ends: V) -> V;

    /// Returns the bound of the joint's unknown error in a long chain. `own` is the error that the
    /// arms themselves leave open.
    fn rest_by_rows(&self, order: usize, own: V, from: &PointOff<V>, rows: &mut Influences) -> f64;
}

/// The errors of the joint and of the links that meet there, and the error that each arm leaves
/// open at each order.
pub(super) struct ClosureErrors<V: Plane> {
    pub joint: PointOff<V::One>,
    pub links: LinkOff<V>,
    pub own: [V; 3],
}

/// The result of one order of a meeting. `open` is the total gap of unknown direction: the rest of
/// the ends.
struct ClosureOrder<V> {
    turned: Turned<V>,
    way: ArmChange<V>,
    own: V,
    open: V,
    joint: V,
}

/// The gap at an order: the drifts, the rotations that close it, its unknown part before the
/// rotation is known, and its total. `carried` is the contribution of lower orders' rests to each
/// arm.
struct OpenOrder<V> {
    drift: Drift<V>,
    carried: V,
    turning: V,
    known: V,
    all: V,
}

/// The data common to all orders of a meeting.
struct ClosureView<'a, V, M, const FUSED: bool> {
    limb: &'a LinkVector<V, FUSED>,
    from: &'a PointOff<V>,
    meeting: &'a M,
    gains: V,
    /// The factor by which the rest of the ends contributes to each vector.
    reach: V,
}

impl<V: Plane, M: ArmClosure<V>, const FUSED: bool> ClosureView<'_, V, M, FUSED> {
    #[inline(always)]
    fn open(&self, order: usize, drift: Drift<V>, carried: Option<(V, V)>) -> OpenOrder<V> {
        let Self { from, meeting, .. } = self;
        let (turning, gap) = meeting.close(order, from.shift[order] + drift.shift);
        let new = (drift.new + from.left[order]).total();
        let new = meeting.with_rest(order, new);
        let (carried, known) = match carried {
            Some((each, all)) => (each, new + all),
            None => (gap.all(0.0), new),
        };
        OpenOrder {
            drift,
            carried,
            turning,
            known,
            all: gap + known,
        }
    }

    /// Computes the result of an order once the maximum rotation is known. `besides` and `sum` are
    /// the additional gap that it opens on each arm and in total.
    #[inline(always)]
    fn settle(
        &self,
        order: usize,
        of: &OpenOrder<V>,
        maximum: V,
        (besides, sum): (V, V),
        rows: &mut Influences,
    ) -> ClosureOrder<V> {
        let Self {
            limb: arm_vector,
            from,
            meeting,
            ..
        } = self;
        let none = maximum.all(0.0);
        let mut turned = Turned {
            shift: of.turning,
            most: maximum,
            rest: none,
        };
        if rows.is_long_chain::<FUSED>() {
            // The rounding error of the arm's starting point is in no row.
            let own = of.drift.new + of.carried + besides + rounding(from.shift[order]);
            let joint = maximum.all(meeting.rest_by_rows(order, own, from, rows));
            let between = from.left[order] + joint;
            turned.rest = arm_vector.turning(between + own);
            return ClosureOrder {
                turned,
                way: arm_vector.way(&of.drift, &turned, between),
                own,
                open: none,
                joint,
            };
        }
        let open = of.known + sum;
        turned.rest = self.gains * open;
        ClosureOrder {
            turned,
            way: arm_vector.way(&of.drift, &turned, self.reach * open),
            own: none,
            open,
            joint: arm_vector.length * turned.rest,
        }
    }

    /// Computes the result of a rate. A rotation opens `slack` times its size on each arm, and
    /// `part` of the gap in total.
    #[inline(always)]
    fn rate(
        &self,
        order: usize,
        drift: Drift<V>,
        carried: (V, V),
        (slack, part): (V, V),
        rows: &mut Influences,
    ) -> ClosureOrder<V> {
        let open = self.open(order, drift, Some(carried));
        let maximum = self.gains * (open.all * GROWTH);
        self.settle(
            order,
            &open,
            maximum,
            (slack * maximum, part * open.all),
            rows,
        )
    }

    /// Stores the error of the joint at an order, by the first of its arms.
    #[inline(always)]
    fn note(&self, order: usize, found: &ClosureOrder<V>, joint: &mut PointOff<V::One>) {
        let shift = (self.from.shift[order] + found.way.shift).first();
        joint.settle(order, shift, found.joint.first());
    }

    /// Returns the contribution of lower orders' rests to each arm, only in long chains, and to
    /// all.
    #[inline(always)]
    fn carried(
        &self,
        each: impl FnOnce() -> V,
        all: impl FnOnce() -> V,
        rows: &Influences,
    ) -> (V, V) {
        if rows.is_long_chain::<FUSED>() {
            let each = each();
            (each, each.total())
        } else {
            (self.gains.all(0.0), all())
        }
    }
}

/// Closes a meeting of arms, each from a point with this error; `None` if that cannot be proved.
#[inline(always)]
pub(super) fn meet<V: Plane, const FUSED: bool>(
    order: u8,
    arm_vector: &LinkVector<V, FUSED>,
    from: &PointOff<V>,
    meeting: &impl ArmClosure<V>,
    rows: &mut Influences,
) -> Option<ClosureErrors<V>> {
    let gains = meeting.gains();
    let none = gains.all(0.0);
    let mut joint = PointOff::none(none.first());
    let mut links = LinkOff::none(none);
    let mut own = [none; 3];
    let view = ClosureView {
        limb: arm_vector,
        from,
        meeting,
        gains,
        reach: arm_vector.length * gains + 1.0,
    };

    let open = view.open(0, arm_vector.drift(), None);
    let maximum = (arm_vector.stretch.abs() + gains * open.all) * GROWTH;
    let slack = arm_vector.slack(maximum);
    let change = (slack * gains).total();
    // Written so that NaN proves nothing.
    if !(change.number(0) <= CONTRACTION && arm_vector.fits()) {
        return None;
    }
    let besides = slack * maximum;
    let found = view.settle(0, &open, maximum, (besides, besides.total()), rows);
    view.note(0, &found, &mut joint);
    (links.stretch, links.turn) = (arm_vector.stretch, open.turning);
    // To second order, for a direction lengthened by the stretch.
    let rest = found.turned.rest;
    links.rest[0] = rest + maximum * (rest + maximum * 2.0) + RESIDUAL;
    own[0] = found.own;
    let (e, first) = (found.way, found.open);

    // The rates are linear: a gap rotates the arms by a proportional amount, and that opens a part
    // of it again.
    let opening = (slack, change * GROWTH);
    if order >= VELOCITY {
        let (drift, moving) = arm_vector.drift_of_rate(&e);
        let carried = view.carried(
            #[inline(always)]
            || arm_vector.carried_rate(e.rest),
            #[inline(always)]
            || arm_vector.carried_rate(view.reach).total() * first,
            rows,
        );
        let found = view.rate(1, drift, carried, opening, rows);
        view.note(1, &found, &mut joint);
        (links.shift[0], links.rest[1]) = (found.turned.shift, found.turned.rest);
        own[1] = found.own;
        let (w, spin, second) = (found.way, found.turned, found.open);
        if order >= ACCELERATION {
            let drift = arm_vector.drift_of_second([&e, &w], &moving, &spin);
            let carried = view.carried(
                #[inline(always)]
                || {
                    arm_vector.carried_second(e.rest)
                        + arm_vector.carried_by_rate(w.rest, &moving, spin.rest)
                },
                #[inline(always)]
                || {
                    let of_first = arm_vector.carried_second(view.reach) * first;
                    let of_second = arm_vector.carried_by_rate(view.reach, &moving, gains) * second;
                    (of_first + of_second).total()
                },
                rows,
            );
            let found = view.rate(2, drift, carried, opening, rows);
            view.note(2, &found, &mut joint);
            (links.shift[1], links.rest[2]) = (found.turned.shift, found.turned.rest);
            own[2] = found.own;
        }
    }
    Some(ClosureErrors { joint, links, own })
}
