//! Bounds points and links that follow from others without a constraint to solve.

use super::driver::CrankDirection;
use super::errors::{Errors, LinkError, PointError, size};
use super::link_vector::{ArmChange, Drift, LinkVector, RESIDUAL, SUM, Turned};
use super::loaded_state::{Bodies, Places};
use super::off::{LinkOff, PointOff, rounding};
use super::shape::LinkShape;
use crate::arithmetic::plane::{Fallback, Plane, Simd, number, vector};
use crate::arithmetic::{Sharp, U};
use crate::solver::elements::{ACCELERATION, VELOCITY};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::State;
use crate::{Ball, Constant, LinkId, PointId, Vec2};

/// The change of a vector on a known link, and the part of its rest that the vector itself leaves
/// open.
#[derive(Clone, Copy)]
struct ArmRotation<V> {
    way: ArmChange<V>,
    own: V,
}

impl<V: Plane, const FUSED: bool> LinkVector<V, FUSED> {
    /// Returns the change of the vector or of a rate. `carried` is the contribution of lower
    /// orders' rests.
    #[inline(always)]
    fn swing(
        &self,
        drift: &Drift<V>,
        carried: V,
        (turned, slack): (&Turned<V>, V),
    ) -> ArmRotation<V> {
        let own = drift.new + carried + slack * turned.most;
        let way = self.way(drift, turned, own + self.length * turned.rest);
        ArmRotation { way, own }
    }

    /// Returns the changes of the vector and of its rates, up to `order`, on a link with this
    /// error.
    #[inline(always)]
    fn swung(&self, order: u8, by: &LinkOff<V>) -> [ArmRotation<V>; 3] {
        let turned = by.turned();
        let slack = self.slack(turned.most);
        let e = self.swing(&self.drift(), slack.all(0.0), (&turned, slack));
        let mut directions = [e; 3];
        if order >= VELOCITY {
            let spin = by.spun(1);
            let (drift, rate) = self.drift_of_rate(&e.way);
            let w = self.swing(&drift, self.carried_rate(e.way.rest), (&spin, slack));
            directions[1] = w;
            if order >= ACCELERATION {
                let drift = self.drift_of_second([&e.way, &w.way], &rate, &spin);
                let carried = self.carried_second(e.way.rest)
                    + self.carried_by_rate(w.way.rest, &rate, spin.rest);
                directions[2] = self.swing(&drift, carried, (&by.spun(2), slack));
            }
        }
        directions
    }
}

impl<V: Plane> LinkOff<V> {
    /// Returns the change of a link's direction.
    #[inline(always)]
    fn turned(&self) -> Turned<V> {
        let rest = self.rest[0];
        Turned {
            shift: self.turn,
            most: self.stretch.abs() + self.turn.abs() + rest,
            rest,
        }
    }

    /// Returns the change of the link's rate of an order.
    #[inline(always)]
    fn spun(&self, order: usize) -> Turned<V> {
        let (shift, rest) = (self.shift[order - 1], self.rest[order]);
        Turned {
            shift,
            most: shift.abs() + rest,
            rest,
        }
    }
}

impl Errors {
    /// Returns the rest of a point without an influence row, and zeros for a point with one.
    pub(super) fn left_without_row(&self, point: PointId) -> [f64; 3] {
        if self.influences.has_point(point) {
            [0.0; 3]
        } else {
            self.point(point).left
        }
    }

    /// Encloses a point that rides on a link.
    #[inline(always)]
    pub(super) fn ride<S: Simd, const FUSED: bool>(
        &mut self,
        simd: S,
        order: u8,
        [point, base]: [PointId; 2],
        (link, local): (LinkId, Vec2<Constant>),
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let [x, p] = [point, base].map(
            #[inline(always)]
            |point| Places::of(simd, &state.points[point.index()]),
        );
        let body = Bodies::of(simd, &state.links[link.index()]);
        let from = PointOff::of(simd, self.point(base));
        let by = LinkOff::of(simd, self.link(link));
        let shape = LinkShape::at(simd, local);
        let arm_vector =
            LinkVector::<_, FUSED>::new(&x, &p, &body, &shape, by.stretch).lengthened();
        let directions = arm_vector.swung(order, &by);
        let mut error = PointOff::none(number(simd, 0.0));
        for (k, ArmRotation { way, .. }) in directions.iter().enumerate() {
            error.settle(k, from.shift[k] + way.shift, from.left[k] + way.rest);
        }
        if self.influences.is_long_chain::<FUSED>() && self.influences.has_point(point) {
            let base_left = self.left_without_row(base);
            let is_rowed = self.influences.has_link(link);
            let turn_left = if is_rowed {
                [0.0; 3]
            } else {
                self.link(link).rest
            };
            let left = std::array::from_fn(|k| {
                let own = (directions[k].own + rounding(from.shift[k])).number(0);
                own + base_left[k] + arm_vector.length.number(0) * turn_left[k]
            });
            let arm = (link, arm_vector.across[0].vector(0));
            let left = self.influences.ride(point, left, base, arm);
            for (k, left) in left.into_iter().enumerate() {
                error.settle(k, error.shift[k], number(simd, left));
            }
        }
        self.set_point(point, &error, &x, state, enclosure);
    }

    /// Encloses a point of the driven link, whose angle is the coordinate: X = r, V = k x r and A =
    /// -r. The link's pivot is the origin of the solver's frame, so it is exact and at rest.
    #[inline(always)]
    pub(super) fn spin<S: Simd, const FUSED: bool>(
        &mut self,
        simd: S,
        point: PointId,
        (heading, local): (&CrankDirection, Vec2<Constant>),
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let x = Places::of(simd, &state.points[point.index()]);
        let shape = LinkShape::at(simd, local);
        let [arm, low] = shape.turned::<FUSED>(vector(simd, heading.d));
        let swing = low + vector(simd, local.map(|v| v.hi).turned(heading.low));
        let rest = shape.length * (heading.off + RESIDUAL) + shape.off + rounding(swing);
        let mut error = PointOff::none(number(simd, 0.0));
        let misses = [arm - x.p, arm.perp() - x.v, -arm - x.a];
        let swings = [swing, swing.perp(), -swing];
        for k in 0..3 {
            error.settle(k, misses[k] + swings[k], rest + rounding(misses[k]));
        }
        self.set_point(point, &error, &x, state, enclosure);
    }

    /// Encloses a link locked to another one.
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
        let maximum = size(from.turn) + from.rest[0] + off;
        let new = 2.0 * typed + SUM * (off + U) + 4.0 * off * maximum;
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
        self.store_link(link, &error, state, enclosure);
    }

    /// Stores results computed in double-double.
    pub(super) fn take(
        &mut self,
        part: PlacedPart,
        from: &State<Sharp>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        match part {
            PlacedPart::Point(point) => {
                let i = point.index();
                let error = PointError::of_sharp(&from.points[i], &state.points[i]);
                self.set_independent_point(point, error, state, enclosure);
            }
            PlacedPart::Link(link) => {
                let i = link.index();
                let error = LinkError::of_sharp(&from.links[i], &state.links[i]);
                self.set_independent_link(link, error, state, enclosure);
            }
            PlacedPart::Slide(_) => {}
        }
    }

    /// Stores a point whose error is independent of all others.
    fn set_independent_point(
        &mut self,
        point: PointId,
        error: PointError,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        if self.influences.has_point(point) {
            self.influences.point_alone(point, error.left);
        }
        self.store_point(point, &error, state, enclosure);
    }

    /// Stores a link whose error is independent of all others.
    fn set_independent_link(
        &mut self,
        link: LinkId,
        error: LinkError,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        if self.influences.has_link(link) {
            self.influences.link_alone(link, error.rest);
        }
        self.store_link(link, &error, state, enclosure);
    }
}

/// Returns d - R(turn) d0, in double-double.
fn missed(d: Vec2, from: Vec2, turn: Vec2<Constant>) -> Vec2 {
    let simd = Fallback::new();
    let [turned, low] = LinkShape::unit(simd, turn).turned::<false>(vector(simd, from));
    ((vector(simd, d) - turned) - low).vector(0)
}
