//! Bounds of what follows from points and links without a constraint to solve.

use super::errors::{Errors, LinkError, PointError, size};
use super::limb::{Limb, SUM};
use crate::arithmetic::{Halves, Sharp, U, two_sum};
use crate::solver::demand::Part;
use crate::solver::state::{LinkState, State};
use crate::solver::step::Arm;
use crate::{Ball, Constant, Double, LinkId, PointId, Vec2};

impl Errors {
    /// A link by two of its points: `along` bounds e . of the rests of the way between them and of its
    /// rate.
    #[inline(always)]
    pub(super) fn aim<const ORDER: u8>(
        &mut self,
        arm: &Arm,
        end: PointId,
        limb: &Limb,
        along: [f64; 2],
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let link = &state.links[arm.link.index()];
        let ends = [self.point(end), self.point(arm.pivot)];
        let mut error = limb.link_error::<ORDER>(arm, link, ends, along);
        let ends = [end, arm.pivot];
        self.influences.between(arm.link, limb.across(), ends);
        for order in 0..=ORDER as usize {
            let moved = self.influences.of_link(arm.link, order);
            error.rest[order] = moved * (1.0 + SUM) + error.own[order];
        }
        self.set_link(arm.link, &error, link, enclosure);
    }

    /// A link both of whose ends are known.
    pub(super) fn aim_at<const ORDER: u8>(
        &mut self,
        arm: &Arm,
        end: PointId,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let points = [end, arm.pivot];
        let [x, p] = points.map(|point| &state.points[point.index()]);
        let limb = Limb::new::<ORDER>(x, p, &state.links[arm.link.index()]);
        let rest = |order: usize| -> f64 {
            let [x, p] = points.map(|point| self.point(point).left[order]);
            limb.sizes[0] * (x + p)
        };
        let along = [rest(0), rest(1)];
        self.aim::<ORDER>(arm, end, &limb, along, state, enclosure);
    }

    /// A point that rides on a link.
    #[inline(always)]
    pub(super) fn ride<const ORDER: u8>(
        &mut self,
        [point, base]: [PointId; 2],
        link: LinkId,
        local: Vec2<Constant>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let [x, p] = [point, base].map(|point| &state.points[point.index()]);
        let body = &state.links[link.index()];
        let limb = Limb::new::<ORDER>(x, p, body);
        let mut error = limb.point_error::<ORDER>(local, body, self.point(base), self.link(link));
        self.influences.ride(point, base, link, limb.e.perp());
        let bounds = error.own.map(|own| Vec2::new(own, own));
        if self.influences.add_own(point, bounds) {
            error.own = [0.0; 3];
        }
        for order in 0..=ORDER as usize {
            let moved = self.influences.of_point(point, order);
            error.rest[order] = moved.map(|v| v * (1.0 + SUM) + error.own[order]);
            error.settle(order);
        }
        self.set_point(point, &error, state, enclosure);
    }

    /// A point of the driven link.
    #[inline(always)]
    pub(super) fn spin<const ORDER: u8>(
        &mut self,
        [point, pivot]: [PointId; 2],
        (crank, turned): (&LinkState, &LinkError),
        local: Vec2<Constant>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let [x, p] = [point, pivot].map(|point| &state.points[point.index()]);
        let limb = Limb::new::<ORDER>(x, p, crank);
        let mut error = limb.point_error::<ORDER>(local, crank, self.point(pivot), turned);
        for order in 0..=ORDER as usize {
            error.rest[order] = Vec2::new(error.own[order], error.own[order]);
            error.settle(order);
        }
        self.set_point(point, &error, state, enclosure);
    }

    /// A link that keeps its angle to another one.
    pub(super) fn lock(
        &mut self,
        [link, to]: [LinkId; 2],
        turn: Vec2<Constant>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let (here, there) = (&state.links[link.index()], &state.links[to.index()]);
        let from = *self.link(to);
        let by = turn.map(|v| v.hi);
        let miss = missed(here.d, there.d, turn);
        let moved = from.direction.turned(by);
        let typed = turn.x.radius + turn.y.radius;
        let rounding = SUM * (size(miss) + size(moved) + U);
        let mut error = LinkError {
            direction: moved - miss,
            ..from
        };
        for error in [&mut error.own[0], &mut error.rest[0]] {
            *error = 2.0 * *error + 2.0 * typed + rounding;
        }
        error.rest[0] = from.rest[0] + error.own[0];
        self.influences.lock(link, to);
        self.set_link(link, &error, here, enclosure);
    }

    /// What was found in twice the digits.
    pub(super) fn take(
        &mut self,
        part: Part,
        from: &State<Sharp>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        match part {
            Part::Point(point) => {
                let i = point.index();
                let error = PointError::of_sharp(&from.points[i], &state.points[i]);
                self.stand_alone(point, error, state, enclosure);
            }
            Part::Link(link) => {
                let i = link.index();
                let error = LinkError::of_sharp(&from.links[i], &state.links[i]);
                self.turn_alone(link, error, state, enclosure);
            }
            Part::Slide(_) => {}
        }
    }

    /// A point whose error has nothing to do with those of others.
    fn stand_alone(
        &mut self,
        point: PointId,
        mut error: PointError,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        if self.influences.point_alone(point, error.rest) {
            error.own = [0.0; 3];
        }
        self.set_point(point, &error, state, enclosure);
    }

    /// A link whose error has nothing to do with those of others.
    fn turn_alone(
        &mut self,
        link: LinkId,
        mut error: LinkError,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let value = &state.links[link.index()];
        if self.influences.link_alone(link, error.rest) {
            // The truth is a unit vector.
            let d = value.d.map(Double::exactly) + error.direction.map(Double::exactly);
            let long = (d.norm2() - Double::ONE).hi.abs();
            let along = long + error.rest[0] * error.rest[0];
            error.own = [along.min(error.own[0]), 0.0, 0.0];
        }
        self.set_link(link, &error, value, enclosure);
    }
}

/// d - R(turn) d0, to twice the digits.
fn missed(d: Vec2, from: Vec2, turn: Vec2<Constant>) -> Vec2 {
    let (t, f) = (turn.map(|v| Halves::of(v.hi)), from.map(Halves::of));
    let ((a, b), (p, q)) = (
        (t.x.times(f.x), t.y.times(f.y)),
        (t.x.times(f.y), t.y.times(f.x)),
    );
    let (sx, lost_x) = two_sum(a.hi, -b.hi);
    let (sy, lost_y) = two_sum(p.hi, q.hi);
    let low = from.turned(turn.map(|v| v.lo));
    Vec2::new(
        (d.x - sx) - (lost_x + (a.lo - b.lo) + low.x),
        (d.y - sy) - (lost_y + (p.lo + q.lo) + low.y),
    )
}
