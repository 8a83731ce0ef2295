//! Where the ends of arms must meet: by how much that turns the arms, and how far what is not known goes.
//!
//! An arm from P ends at P + e; its true end is P + dP + e + de. The part of de that does not depend on the turning
//! theta is the drift c, see [`limb`](super::limb), and so two arms meet where
//!
//! ```text
//! theta1 k x e1 - theta2 k x e2 = D,     D = (dP2 + c2) - (dP1 + c1)
//! ```
//!
//! and an arm on a rail, or towards a point that is known, where one such equation in theta holds. It is the same at
//! each order, of the angles and of their rates, with the D of that order. With M the inverse of this matrix, a D of
//! the length r turns arm i by g_i r at most: these are the gains.
//!
//! That a solution is near is proved by Krawczyk's operator N(theta) = theta - M F(theta) (Rump, Verification methods,
//! Acta Numerica 19, 2010, section 13), F what is open between the ends. The columns of F' are the true ways turned by
//! theta, times k: within |theta_i| <= 3/2 g_i r, r what is open at theta = 0, they are within the slack of the
//! computed ways. So N shrinks distances, measured by the largest |theta_i| / g_i, by q = sum g_i slack_i at least,
//! and where q <= 1/4 it maps this neighbourhood into itself, with an eighth of r to spare: there is one solution. The
//! matrix of the rates is F' there, so that theirs are no more than 3/2 g_i r either. To the first order they are M D;
//! what that leaves out, with what each arm leaves open, is open once more, and turns each arm by g_i of it at most.
//!
//! That M is computed in doubles moves theta_i by 6 u + 2 u |e1| |e2| / |det| of g_i r at most, and |e1| |e2| / |det| =
//! g_i |e_i| >= 1 in every case: it is as if the columns were off by 4 u |e_i|. The slack holds this, and what a
//! computed way leaves out of the difference of its points, and what adding up the way's shift rounds.
//!
//! A rest of a joint: what each arm leaves open, as a vector of at most that length, with the rest of the point that
//! it starts from, moves the joint along the other arm, by |e_i| g_i of it at most. With R the sum of all that, the way
//! of arm i has a rest of (1 + |e_i| g_i) R at most, and the angle of g_i R: so what the rests of one order make of the
//! next is known as a part of R before R is.

use super::errors::{LinkError, PointError, rounding};
use super::influence::Influences;
use super::limb::{Drift, Limb, Moved, RESIDUAL, Turned};
use crate::solver::elements::{ACCELERATION, VELOCITY};
use crate::{Number, Vec2};

/// The most by which Krawczyk's operator may fail to shrink: beyond, nothing is proved.
const CONTRACTION: f64 = 0.25;
/// By how much more than to the first order an arm may turn.
const GROWTH: f64 = 1.5;

/// What the ends of one or two arms must keep to.
pub(super) trait Meeting<T> {
    /// The gains.
    fn gains(&self) -> T;

    /// What closes it at an order, once the ends are so much off: the turnings, and how much is open.
    fn close(&self, order: usize, ends: Vec2<T>) -> (T, f64);

    /// The sum over the arms.
    fn sum(&self, parts: T) -> f64;

    /// What is not known at an order of what the ends must keep to.
    fn rest(&self, order: usize) -> f64;

    /// How far what is not known of the joint goes in a long chain, when the arms themselves leave so much open.
    fn rest_by_rows(
        &self,
        order: usize,
        own: T,
        from: &PointError<T>,
        rows: &mut Influences,
    ) -> f64;
}

/// The joint's error, those of the links whose arms meet there, and what each arm leaves open at each order.
pub(super) struct Met<T> {
    pub joint: PointError,
    pub links: LinkError<T>,
    pub own: [T; 3],
}

/// One order of a meeting: what is open in all, of which nothing is known, is the rest of the ends.
struct Found<T> {
    turned: Turned<T>,
    way: Moved<T>,
    own: T,
    open: f64,
    joint: f64,
}

/// What is open at an order: of the drifts, what closes it, how much is not known of it before the turning is, and in
/// all. `carried` is what rests of lower orders make of each arm.
struct Open<T> {
    drift: Drift<T>,
    carried: T,
    turning: T,
    known: f64,
    all: f64,
}

/// How a meeting is looked at, at every order.
struct View<'a, T, M, const FUSED: bool, const ROWS: bool> {
    limb: &'a Limb<T, FUSED>,
    from: &'a PointError<T>,
    meeting: &'a M,
    gains: T,
    /// How far the rest of the ends goes in each way.
    reach: T,
}

impl<T: Number, M: Meeting<T>, const FUSED: bool, const ROWS: bool> View<'_, T, M, FUSED, ROWS> {
    #[inline(always)]
    fn open(&self, order: usize, drift: Drift<T>, (carried, all): (T, f64)) -> Open<T> {
        let Self { from, meeting, .. } = self;
        let (turning, gap) = meeting.close(order, from.shift[order] + drift.shift);
        let new = meeting.sum(drift.new + from.left[order]) + meeting.rest(order);
        let known = new + all;
        Open {
            drift,
            carried,
            turning,
            known,
            all: gap + known,
        }
    }

    /// How far something turns the arms.
    #[inline(always)]
    fn turned(&self, open: f64) -> T {
        self.gains * T::exactly(open)
    }

    /// What is found at an order once it is known how large the turning can be, and how much that opens besides on each
    /// arm and in all.
    #[inline(always)]
    fn settle(
        &self,
        order: usize,
        of: &Open<T>,
        most: T,
        (besides, sum): (T, f64),
        rows: &mut Influences,
    ) -> Found<T> {
        let Self {
            limb,
            from,
            meeting,
            ..
        } = self;
        let mut turned = Turned {
            shift: of.turning,
            most,
            rest: T::default(),
        };
        if ROWS {
            // What the point that an arm starts from rounds is in no row.
            let own = of.drift.new + of.carried + besides + rounding(from.shift[order]);
            let joint = meeting.rest_by_rows(order, own, from, rows);
            let between = from.left[order] + T::exactly(joint);
            turned.rest = (between + own) / limb.length;
            return Found {
                turned,
                way: limb.way(&of.drift, &turned, between),
                own,
                open: 0.0,
                joint,
            };
        }
        let open = of.known + sum;
        turned.rest = self.turned(open);
        Found {
            turned,
            way: limb.way(&of.drift, &turned, self.reach * T::exactly(open)),
            own: T::default(),
            open,
            joint: (limb.length * turned.rest).nearest(),
        }
    }

    /// The shift of the joint at an order, by the first of its arms.
    #[inline(always)]
    fn joint(&self, order: usize, way: &Moved<T>) -> Vec2 {
        (self.from.shift[order] + way.shift).nearest()
    }

    /// What rests of lower orders make of each arm and of all, the first in long chains alone.
    #[inline(always)]
    fn carried(&self, each: impl FnOnce() -> T, all: impl FnOnce() -> f64) -> (T, f64) {
        if ROWS {
            let each = each();
            (each, self.meeting.sum(each))
        } else {
            (T::default(), all())
        }
    }
}

/// Closes a meeting of arms, each from a point with this error; nothing where that cannot be proved.
#[inline(always)]
pub(super) fn meet<T: Number, const ORDER: u8, const FUSED: bool, const ROWS: bool>(
    limb: &Limb<T, FUSED>,
    from: &PointError<T>,
    meeting: &impl Meeting<T>,
    rows: &mut Influences,
) -> Option<Met<T>> {
    let (mut joint, mut links) = (PointError::none(), LinkError::none());
    let mut own = [T::default(); 3];
    let gains = meeting.gains();
    let view = View::<'_, _, _, FUSED, ROWS> {
        limb,
        from,
        meeting,
        gains,
        reach: T::exactly(1.0) + limb.length * gains,
    };

    let open = view.open(0, limb.drift(), (T::default(), 0.0));
    let most = (limb.stretch.abs() + view.turned(open.all)) * T::exactly(GROWTH);
    let slack = limb.slack(most);
    let change = meeting.sum(slack * gains);
    // Written so that NaN proves nothing.
    if !(change <= CONTRACTION && limb.fits()) {
        return None;
    }
    let besides = slack * most;
    let found = view.settle(0, &open, most, (besides, meeting.sum(besides)), rows);
    joint.settle(0, view.joint(0, &found.way), found.joint);
    links.turn = Vec2::new(limb.stretch, open.turning);
    // To the second order, and of a direction that is as much longer as the stretch says.
    let rest = found.turned.rest;
    links.rest[0] = rest + most * (rest + most.scaled(2.0)) + T::exactly(RESIDUAL);
    own[0] = found.own;
    let (e, first) = (found.way, found.open);

    // The rates are linear: what is open turns the arms by so much, and that opens a part of it.
    let part = GROWTH * change;
    let rate = |order: usize, drift: Drift<T>, carried: (T, f64), rows: &mut Influences| {
        let open = view.open(order, drift, carried);
        let most = view.turned(open.all * GROWTH);
        view.settle(order, &open, most, (slack * most, part * open.all), rows)
    };
    if ORDER >= VELOCITY {
        let (drift, moving) = limb.drift_of_rate(&e);
        let carried = view.carried(
            #[inline(always)]
            || limb.carried_rate(e.rest),
            #[inline(always)]
            || meeting.sum(limb.carried_rate(view.reach)) * first,
        );
        let found = rate(1, drift, carried, rows);
        joint.settle(1, view.joint(1, &found.way), found.joint);
        (links.shift[0], links.rest[1]) = (found.turned.shift, found.turned.rest);
        own[1] = found.own;
        let (w, spin, second) = (found.way, found.turned, found.open);
        if ORDER >= ACCELERATION {
            let drift = limb.drift_of_second([&e, &w], &moving, &spin);
            let by_rate = |w: T, spin: T| limb.carried_by_rate(w, &moving, spin);
            let carried = view.carried(
                #[inline(always)]
                || limb.carried_second(e.rest) + by_rate(w.rest, spin.rest),
                #[inline(always)]
                || {
                    meeting.sum(limb.carried_second(view.reach)) * first
                        + meeting.sum(by_rate(view.reach, gains)) * second
                },
            );
            let found = rate(2, drift, carried, rows);
            joint.settle(2, view.joint(2, &found.way), found.joint);
            (links.shift[1], links.rest[2]) = (found.turned.shift, found.turned.rest);
            own[2] = found.own;
        }
    }
    Some(Met { joint, links, own })
}
