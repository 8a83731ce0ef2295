//! Bounds of what follows from points and links without a constraint to solve.

use super::errors::{Errors, LinkError, PointError, size};
use super::limb::{Limb, SUM, Shape, across, swing_rest, turned_closely};
use crate::arithmetic::{Sharp, U};
use crate::solver::demand::Part;
use crate::solver::elements::{ACCELERATION, Arm, VELOCITY};
use crate::solver::state::State;
use crate::{Ball, Constant, Double, LinkId, PointId, Vec2};

impl Errors {
    /// A link by two of its points: `along` bounds e . of the rests of the way between them and of its
    /// rate.
    #[inline(always)]
    pub(super) fn aim<const ORDER: u8, const FUSED: bool, const ROWS: bool>(
        &mut self,
        arm: &Arm,
        end: PointId,
        (limb, shape): (&Limb<f64, FUSED>, &Shape),
        along: [f64; 2],
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let link = &state.links[arm.link.index()];
        let (x, p) = (self.point(end), self.point(arm.pivot));
        let (mut error, gain) = limb.link_error::<ORDER>(shape, link, [x, p], along);
        if ROWS && self.influences.has_link(arm.link) {
            error.rest = self.turn_by_rows(arm, (end, limb.e), error.rest, gain);
        } else {
            let lefts = x.left.iter().zip(&p.left);
            for (rest, (x, p)) in error.rest.iter_mut().zip(lefts) {
                *rest += gain * (x + p);
            }
        }
        self.set_link(arm.link, &error, link, enclosure);
    }

    /// What is left of a link with this way to an end, by rows of influences, when so much of it is new.
    #[inline(never)]
    pub(super) fn turn_by_rows(
        &mut self,
        arm: &Arm,
        (end, e): (PointId, Vec2),
        mut new: [f64; 3],
        gain: f64,
    ) -> [f64; 3] {
        let ends = [end, arm.pivot];
        for point in ends {
            let left = self.left_without_row(point);
            for (new, left) in new.iter_mut().zip(left) {
                *new += gain * left;
            }
        }
        self.influences.between(arm.link, new, across(e), ends)
    }

    /// What is left of a point that has no row to say it.
    fn left_without_row(&self, point: PointId) -> [f64; 3] {
        if self.influences.has_point(point) {
            [0.0; 3]
        } else {
            self.point(point).left
        }
    }

    /// A link both of whose ends are known.
    #[inline(always)]
    pub(super) fn aim_at<const ORDER: u8, const FUSED: bool, const ROWS: bool>(
        &mut self,
        arm: &Arm,
        end: PointId,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let points = [end, arm.pivot];
        let [x, p] = points.map(|point| &state.points[point.index()]);
        let limb = Limb::<f64, FUSED>::new::<ORDER>(x, p, &state.links[arm.link.index()]);
        let rest = |order: usize| -> f64 {
            let [x, p] = points.map(|point| self.point(point).left[order]);
            limb.sizes[0] * (x + p)
        };
        let along = [rest(0), rest(1)];
        let shape = Shape::of(arm);
        self.aim::<ORDER, FUSED, ROWS>(arm, end, (&limb, &shape), along, state, enclosure);
    }

    /// A point that rides on a link.
    #[inline(always)]
    pub(super) fn ride<const ORDER: u8, const FUSED: bool, const ROWS: bool>(
        &mut self,
        [point, base]: [PointId; 2],
        link: LinkId,
        local: Vec2<Constant>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let [x, p] = [point, base].map(|point| &state.points[point.index()]);
        let body = &state.links[link.index()];
        let limb = Limb::<f64, FUSED>::new::<ORDER>(x, p, body);
        let (from, turned) = (self.point(base), self.link(link));
        let mut error = limb.point_error::<ORDER>(local, body, from, turned);
        let length = limb.sizes[0];
        let mut left = error.left;
        if ROWS && self.influences.has_point(point) {
            let base_left = self.left_without_row(base);
            let is_rowed = self.influences.has_link(link);
            let turn_left = if is_rowed { [0.0; 3] } else { turned.rest };
            for k in 0..3 {
                left[k] += base_left[k] + length * turn_left[k];
            }
            let arm = (link, limb.e.perp());
            left = self.influences.ride(point, left, base, arm);
        } else {
            let rests = from.left.into_iter().zip(turned.rest);
            for (left, (from, turned)) in left.iter_mut().zip(rests) {
                *left += from + length * turned;
            }
        }
        for (k, left) in left.into_iter().enumerate().take(ORDER as usize + 1) {
            error.settle(k, left);
        }
        self.set_point(point, &error, state, enclosure);
    }

    /// A point of the driven link, whose angle is the coordinate: X = r, V = k x r and A = -r. The link's pivot
    /// is the origin of the solver's frame: whatever was typed for it, it is there, and at rest.
    #[inline(always)]
    pub(super) fn spin<const ORDER: u8, const FUSED: bool>(
        &mut self,
        point: PointId,
        (d, turned): (Vec2, &LinkError),
        local: Vec2<Constant>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let x = &state.points[point.index()];
        let [arm, low] = turned_closely::<FUSED>(local, d);
        let swing = low + local.map(|v| v.hi).turned(turned.direction);
        let rest = size(local.map(|v| v.hi)) * turned.along + swing_rest(local, turned);
        let mut error = PointError::none();
        let mut see = |k: usize, miss: Vec2, swing: Vec2| {
            error.shift[k] = miss + swing;
            error.settle(k, rest + SUM * (size(miss) + size(swing)));
        };
        see(0, arm - x.p, swing);
        if ORDER >= VELOCITY {
            see(1, arm.perp() - x.v, swing.perp());
        }
        if ORDER >= ACCELERATION {
            see(2, -arm - x.a, -swing);
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
        let new = 2.0 * typed + rounding;
        error.along = 2.0 * from.along + new;
        if self.influences.has_link(link) {
            let is_rowed = self.influences.has_link(to);
            let mut left = if is_rowed { [0.0; 3] } else { from.rest };
            left[0] += new;
            error.rest = self.influences.lock(link, left, to);
        } else {
            error.rest[0] += new;
        }
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
        error: PointError,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        if self.influences.has_point(point) {
            self.influences.point_alone(point, error.left);
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
        if self.influences.has_link(link) {
            self.influences.link_alone(link, error.rest);
        }
        // The truth is a unit vector.
        let d = value.d.map(Double::exactly) + error.direction.map(Double::exactly);
        let long = (d.norm2() - Double::ONE).hi.abs();
        let along = long + error.rest[0] * error.rest[0];
        error.along = along.min(error.along);
        self.set_link(link, &error, value, enclosure);
    }
}

/// d - R(turn) d0, to twice the digits.
fn missed(d: Vec2, from: Vec2, turn: Vec2<Constant>) -> Vec2 {
    let [turned, low] = turned_closely::<false>(turn, from);
    (d - turned) - low
}
