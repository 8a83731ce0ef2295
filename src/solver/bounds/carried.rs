//! Bounds of what follows from points and links without a constraint to solve.

use super::driver::Heading;
use super::errors::{Errors, LinkError, PointError, rounding, size};
use super::limb::{Drift, Limb, Moved, RESIDUAL, SUM, Turned};
use super::shape::{Shape, is_zero, turned_closely};
use crate::arithmetic::{Sharp, U};
use crate::solver::demand::Part;
use crate::solver::elements::{ACCELERATION, VELOCITY};
use crate::solver::state::State;
use crate::{Ball, Constant, LinkId, PointId, Vec2};

/// What moves a way on a link that is known, and what of it the way leaves open of itself.
#[derive(Clone, Copy)]
struct Swung {
    way: Moved<f64>,
    own: f64,
}

impl<const FUSED: bool> Limb<f64, FUSED> {
    /// What moves the way and its rates, on a link with this error.
    #[inline(always)]
    fn swung<const ORDER: u8>(&self, by: &LinkError) -> [Swung; 3] {
        let turned = by.turned(0);
        let slack = self.slack(turned.most);
        let swing = |drift: &Drift<f64>, carried: f64, turned: &Turned<f64>| {
            let own = drift.new + carried + slack * turned.most;
            let way = self.way(drift, turned, own + self.length * turned.rest);
            Swung { way, own }
        };
        let e = swing(&self.drift(), 0.0, &turned);
        let mut ways = [e; 3];
        if ORDER >= VELOCITY {
            let spin = by.turned(1);
            let (drift, rate) = self.drift_of_rate(&e.way);
            let w = swing(&drift, self.carried_rate(e.way.rest), &spin);
            ways[1] = w;
            if ORDER >= ACCELERATION {
                let drift = self.drift_of_second([&e.way, &w.way], &rate, &spin);
                let carried = self.carried_second(e.way.rest)
                    + self.carried_by_rate(w.way.rest, &rate, spin.rest);
                ways[2] = swing(&drift, carried, &by.turned(2));
            }
        }
        ways
    }
}

impl LinkError {
    /// What turns a link, at an order.
    #[inline(always)]
    fn turned(&self, order: usize) -> Turned<f64> {
        let (shift, size) = match order {
            0 => (self.turn.y, size(self.turn)),
            _ => (self.shift[order - 1], self.shift[order - 1].abs()),
        };
        let rest = self.rest[order];
        Turned {
            shift,
            most: size + rest,
            rest,
        }
    }
}

impl Errors {
    /// What is left of a point that has no row to say it.
    pub(super) fn left_without_row(&self, point: PointId) -> [f64; 3] {
        if self.influences.has_point(point) {
            [0.0; 3]
        } else {
            self.point(point).left
        }
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
        let (from, by) = (&self.points[base.index()], &self.links[link.index()]);
        let limb = Limb::<_, FUSED>::new(x, p, body, &Shape::at(local), by.turn.x).lengthened();
        let ways = limb.swung::<ORDER>(by);
        let mut left = [0.0; 3];
        if ROWS && self.influences.has_point(point) {
            let base_left = self.left_without_row(base);
            let is_rowed = self.influences.has_link(link);
            let turn_left = if is_rowed { [0.0; 3] } else { by.rest };
            for k in 0..3 {
                let noise = rounding(from.shift[k]);
                left[k] = ways[k].own + noise + base_left[k] + limb.length * turn_left[k];
            }
            let arm = (link, limb.e.perp());
            left = self.influences.ride(point, left, base, arm);
        } else {
            for k in 0..=ORDER as usize {
                left[k] = from.left[k] + ways[k].way.rest;
            }
        }
        let mut error = PointError::none();
        for k in 0..=ORDER as usize {
            error.settle(k, from.shift[k] + ways[k].way.shift, left[k]);
        }
        self.set_point(point, &error, state, enclosure);
    }

    /// A point of the driven link, whose angle is the coordinate: X = r, V = k x r and A = -r. The link's pivot
    /// is the origin of the solver's frame: whatever was typed for it, it is there, and at rest.
    #[inline(always)]
    pub(super) fn spin<const ORDER: u8, const FUSED: bool>(
        &mut self,
        point: PointId,
        heading: &Heading,
        local: Vec2<Constant>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let x = &state.points[point.index()];
        let v = [local.map(|v| v.hi), local.map(|v| v.lo)];
        let [arm, low] = turned_closely::<f64, FUSED>(v, is_zero(local.y), heading.d);
        let swing = low + v[0].turned(heading.low);
        let reach = size(v[0]);
        let typed = local.x.radius + local.y.radius;
        let rest = reach * (heading.off + RESIDUAL) + typed + SUM * size(swing);
        let mut error = PointError::none();
        let mut see = |k: usize, miss: Vec2, swing: Vec2| {
            error.settle(k, miss + swing, rest + SUM * size(miss));
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
        // d0 (1 + z0) R is (d - miss)(1 + z0).
        let miss = missed(here.d, there.d, turn);
        let off = size(miss);
        let typed = turn.x.radius + turn.y.radius;
        let most = size(from.turn) + from.rest[0] + off;
        let new = 2.0 * typed + SUM * (off + U) + 4.0 * off * most;
        let mut error = LinkError {
            turn: from.turn - miss.turned(here.d.conj()),
            ..from
        };
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
        error: LinkError,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        if self.influences.has_link(link) {
            self.influences.link_alone(link, error.rest);
        }
        self.set_link(link, &error, &state.links[link.index()], enclosure);
    }
}

/// d - R(turn) d0, to twice the digits.
fn missed(d: Vec2, from: Vec2, turn: Vec2<Constant>) -> Vec2 {
    let by = [turn.map(|v| v.hi), turn.map(|v| v.lo)];
    let [turned, low] = turned_closely::<f64, false>(by, false, from);
    (d - turned) - low
}
