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

use super::influence::Influences;
use super::limb::{Drift, Limb, Moved, RESIDUAL, Turned};
use super::off::{LinkOff, PointOff, rounding};
use crate::arithmetic::plane::Plane;
use crate::solver::elements::{ACCELERATION, VELOCITY};

/// The most by which Krawczyk's operator may fail to shrink: beyond, nothing is proved.
const CONTRACTION: f64 = 0.25;
/// By how much more than to the first order an arm may turn.
const GROWTH: f64 = 1.5;

/// What the ends of one or two arms must keep to. What belongs to the meeting is in all places.
pub(super) trait Meeting<V> {
    /// The gains.
    fn gains(&self) -> V;

    /// What closes it at an order, once the ends are so much off: the turnings, and how much is open.
    fn close(&self, order: usize, ends: V) -> (V, V);

    /// So much that is not known of the ends, with what is not known at an order of what they must keep to.
    fn with_rest(&self, order: usize, ends: V) -> V;

    /// How far what is not known of the joint goes in a long chain, when the arms themselves leave so much open.
    fn rest_by_rows(&self, order: usize, own: V, from: &PointOff<V>, rows: &mut Influences) -> f64;
}

/// The joint's error, those of the links whose arms meet there, and what each arm leaves open at each order.
pub(super) struct Met<V: Plane> {
    pub joint: PointOff<V::One>,
    pub links: LinkOff<V>,
    pub own: [V; 3],
}

/// One order of a meeting: what is open in all, of which nothing is known, is the rest of the ends.
struct MeetingOrder<V> {
    turned: Turned<V>,
    way: Moved<V>,
    own: V,
    open: V,
    joint: V,
}

/// What is open at an order: of the drifts, what closes it, how much is not known of it before the turning is, and in
/// all. `carried` is what rests of lower orders make of each arm.
struct OpenOrder<V> {
    drift: Drift<V>,
    carried: V,
    turning: V,
    known: V,
    all: V,
}

/// How a meeting is looked at, at every order.
struct MeetingView<'a, V, M, const FUSED: bool> {
    limb: &'a Limb<V, FUSED>,
    from: &'a PointOff<V>,
    meeting: &'a M,
    gains: V,
    /// How far the rest of the ends goes in each way.
    reach: V,
}

impl<V: Plane, M: Meeting<V>, const FUSED: bool> MeetingView<'_, V, M, FUSED> {
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

    /// What is found at an order once it is known how large the turning can be, and how much that opens besides on each
    /// arm and in all.
    #[inline(always)]
    fn settle(
        &self,
        order: usize,
        of: &OpenOrder<V>,
        most: V,
        (besides, sum): (V, V),
        rows: &mut Influences,
    ) -> MeetingOrder<V> {
        let Self {
            limb,
            from,
            meeting,
            ..
        } = self;
        let none = most.all(0.0);
        let mut turned = Turned {
            shift: of.turning,
            most,
            rest: none,
        };
        if rows.matter::<FUSED>() {
            // What the point that an arm starts from rounds is in no row.
            let own = of.drift.new + of.carried + besides + rounding(from.shift[order]);
            let joint = most.all(meeting.rest_by_rows(order, own, from, rows));
            let between = from.left[order] + joint;
            turned.rest = limb.turning(between + own);
            return MeetingOrder {
                turned,
                way: limb.way(&of.drift, &turned, between),
                own,
                open: none,
                joint,
            };
        }
        let open = of.known + sum;
        turned.rest = self.gains * open;
        MeetingOrder {
            turned,
            way: limb.way(&of.drift, &turned, self.reach * open),
            own: none,
            open,
            joint: limb.length * turned.rest,
        }
    }

    /// The same of a rate, where a turning opens so much of it on each arm, and this part in all.
    #[inline(always)]
    fn rate(
        &self,
        order: usize,
        drift: Drift<V>,
        carried: (V, V),
        (slack, part): (V, V),
        rows: &mut Influences,
    ) -> MeetingOrder<V> {
        let open = self.open(order, drift, Some(carried));
        let most = self.gains * (open.all * GROWTH);
        self.settle(order, &open, most, (slack * most, part * open.all), rows)
    }

    /// The error of the joint at an order, by the first of its arms.
    #[inline(always)]
    fn note(&self, order: usize, found: &MeetingOrder<V>, joint: &mut PointOff<V::One>) {
        let shift = (self.from.shift[order] + found.way.shift).first();
        joint.settle(order, shift, found.joint.first());
    }

    /// What rests of lower orders make of each arm, in long chains alone, and of all.
    #[inline(always)]
    fn carried(
        &self,
        each: impl FnOnce() -> V,
        all: impl FnOnce() -> V,
        rows: &Influences,
    ) -> (V, V) {
        if rows.matter::<FUSED>() {
            let each = each();
            (each, each.total())
        } else {
            (self.gains.all(0.0), all())
        }
    }
}

/// Closes a meeting of arms, each from a point with this error; nothing where that cannot be proved.
#[inline(always)]
pub(super) fn meet<V: Plane, const FUSED: bool>(
    order: u8,
    limb: &Limb<V, FUSED>,
    from: &PointOff<V>,
    meeting: &impl Meeting<V>,
    rows: &mut Influences,
) -> Option<Met<V>> {
    let gains = meeting.gains();
    let none = gains.all(0.0);
    let mut joint = PointOff::none(none.first());
    let mut links = LinkOff::none(none);
    let mut own = [none; 3];
    let view = MeetingView {
        limb,
        from,
        meeting,
        gains,
        reach: limb.length * gains + 1.0,
    };

    let open = view.open(0, limb.drift(), None);
    let most = (limb.stretch.abs() + gains * open.all) * GROWTH;
    let slack = limb.slack(most);
    let change = (slack * gains).total();
    // Written so that NaN proves nothing.
    if !(change.number(0) <= CONTRACTION && limb.fits()) {
        return None;
    }
    let besides = slack * most;
    let found = view.settle(0, &open, most, (besides, besides.total()), rows);
    view.note(0, &found, &mut joint);
    (links.stretch, links.turn) = (limb.stretch, open.turning);
    // To the second order, and of a direction that is as much longer as the stretch says.
    let rest = found.turned.rest;
    links.rest[0] = rest + most * (rest + most * 2.0) + RESIDUAL;
    own[0] = found.own;
    let (e, first) = (found.way, found.open);

    // The rates are linear: what is open turns the arms by so much, and that opens a part of it.
    let opening = (slack, change * GROWTH);
    if order >= VELOCITY {
        let (drift, moving) = limb.drift_of_rate(&e);
        let carried = view.carried(
            #[inline(always)]
            || limb.carried_rate(e.rest),
            #[inline(always)]
            || limb.carried_rate(view.reach).total() * first,
            rows,
        );
        let found = view.rate(1, drift, carried, opening, rows);
        view.note(1, &found, &mut joint);
        (links.shift[0], links.rest[1]) = (found.turned.shift, found.turned.rest);
        own[1] = found.own;
        let (w, spin, second) = (found.way, found.turned, found.open);
        if order >= ACCELERATION {
            let drift = limb.drift_of_second([&e, &w], &moving, &spin);
            let carried = view.carried(
                #[inline(always)]
                || limb.carried_second(e.rest) + limb.carried_by_rate(w.rest, &moving, spin.rest),
                #[inline(always)]
                || {
                    let of_first = limb.carried_second(view.reach) * first;
                    let of_second = limb.carried_by_rate(view.reach, &moving, gains) * second;
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
    Some(Met { joint, links, own })
}
