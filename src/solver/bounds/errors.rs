//! What is known of the errors of a state's points and links.
//!
//! The true figure is what was computed, plus a shift, plus a rest. The shift is signed: it is what the
//! residuals say, to the first order. The rest is only known to be small: what no residual tells, such
//! as what a typed coordinate of the driver is off by, and what is of the second order.

use super::influence::Influences;
use super::limb::SUM;
use crate::arithmetic::{Both, INFLATION, Sharp, U};
use crate::solver::Workspace;
use crate::solver::elements::Step;
use crate::solver::engine::Engine;
use crate::solver::state::{LinkState, PointState, State};
use crate::{Ball, Constant, Double, LinkId, Number, PointId, Vec2};

/// The length of a vector is at most its larger component and this part of the other one: where they are equal, and
/// where one is zero, that is what it is, and in between it is less.
const SQRT_2_LESS_1: f64 = 0.414_213_562_4;
/// What is lost of a constant in twice the precision, with room.
const TWICE: f64 = 1e-31;

/// The errors of a point's position, velocity and acceleration.
///
/// Aligned as states are, see [`PointState`].
#[derive(Clone, Copy, Debug)]
#[repr(align(128))]
pub(super) struct PointError<T = f64> {
    pub shift: [Vec2<T>; 3],
    /// Bounds of the length of the rest, with what adding up the shift rounds.
    pub left: [T; 3],
}

/// The errors of a link's direction, angular velocity and acceleration.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct LinkError<T = f64> {
    /// By how much the true direction is longer than the computed one, and turned: d becomes d (1 + x + i y).
    pub turn: Vec2<T>,
    /// Of the velocity and of the acceleration.
    pub shift: [T; 2],
    /// Bounds of the rest: of the direction and of the rates.
    pub rest: [T; 3],
}

/// Of all points and links, and what of their rests comes from which constraint.
#[derive(Clone, Debug, Default)]
pub(in crate::solver) struct Errors {
    pub(super) points: Vec<PointError>,
    pub(super) links: Vec<LinkError>,
    pub(super) influences: Influences,
    /// The same in twice the digits: what rare steps and the forces are run in.
    pub(in crate::solver) sharp: Option<Box<Workspace<Sharp>>>,
    /// Whether a step asks for these, whatever is asked for; and whether anything of this run does.
    has_close_steps: bool,
    feeds_sharp: bool,
    /// All steps in the numbers that are meant, for what is near to an end.
    pub(super) edge: Option<Box<State<Sharp>>>,
}

/// The sum of the sizes of the components.
#[inline(always)]
pub(super) fn size<T: Number>(v: Vec2<T>) -> T {
    v.x.abs() + v.y.abs()
}

/// What sums that a shift stands in round.
#[inline(always)]
pub(super) fn rounding<T: Number>(shift: Vec2<T>) -> T {
    size(shift) * T::exactly(SUM)
}

/// Here a rest becomes a bound: it is a sum of positive terms, each rounded to nearest, and is widened by
/// more than these can have lost. What the middle rounds is told by Dekker's short sum, or, where the shift is the
/// larger one, is below 4 u of the shift: every rest is more.
#[inline(always)]
fn ball<T: Number>(value: T, shift: T, rest: T) -> (T, T) {
    let mid = value + shift;
    let lost = shift - (mid - value);
    (mid, rest * T::exactly(INFLATION) + lost.abs())
}

#[inline(always)]
fn balls(value: Vec2, shift: Vec2, rest: f64) -> Vec2<Ball> {
    let (value, shift) = (Both([value.x, value.y]), Both([shift.x, shift.y]));
    let (mid, radius) = ball(value, shift, Both::exactly(rest));
    let at = |i: usize| Ball::new(mid.0[i], radius.0[i]);
    Vec2::new(at(0), at(1))
}

fn sharp(value: Vec2, shift: Vec2, rest: f64) -> Vec2<Sharp> {
    Vec2::new(
        Sharp::new(Double::sum(value.x, shift.x), rest),
        Sharp::new(Double::sum(value.y, shift.y), rest),
    )
}

/// From a computed value to one in twice the digits, and a bound of what is left: with what the way rounds,
/// which is two sums, and as much again.
fn way(sharp: Sharp, value: f64) -> (f64, f64) {
    let way = sharp.way_from(value);
    (way, sharp.radius + 4.0 * U * way.abs())
}

/// The same of a vector.
fn ways(sharp: Vec2<Sharp>, value: Vec2) -> (Vec2, f64) {
    let ((x, rest_x), (y, rest_y)) = (way(sharp.x, value.x), way(sharp.y, value.y));
    // Written so that NaN is kept.
    let (less, more) = if rest_x <= rest_y {
        (rest_x, rest_y)
    } else {
        (rest_y, rest_x)
    };
    (Vec2::new(x, y), more + SQRT_2_LESS_1 * less)
}

impl PointError {
    /// Notes the shift of an order, and what is left.
    #[inline(always)]
    pub(super) fn settle(&mut self, order: usize, shift: Vec2, left: f64) {
        self.shift[order] = shift;
        self.left[order] = left + rounding(shift);
    }

    fn new(shift: [Vec2; 3], left: [f64; 3]) -> PointError {
        let mut error = PointError::none();
        (0..3).for_each(|order| error.settle(order, shift[order], left[order]));
        error
    }

    /// Of a point that was found in twice the digits.
    pub(super) fn of_sharp(sharp: &PointState<Sharp>, value: &PointState) -> PointError {
        let found = [
            ways(sharp.p, value.p),
            ways(sharp.v, value.v),
            ways(sharp.a, value.a),
        ];
        PointError::new(found.map(|f| f.0), found.map(|f| f.1))
    }

    fn sharp(&self, value: &PointState) -> PointState<Sharp> {
        PointState {
            p: sharp(value.p, self.shift[0], self.left[0]),
            v: sharp(value.v, self.shift[1], self.left[1]),
            a: sharp(value.a, self.shift[2], self.left[2]),
        }
    }

    #[inline(always)]
    fn balls(&self, value: &PointState) -> PointState<Ball> {
        PointState {
            p: balls(value.p, self.shift[0], self.left[0]),
            v: balls(value.v, self.shift[1], self.left[1]),
            a: balls(value.a, self.shift[2], self.left[2]),
        }
    }
}

impl<T: Number> PointError<T> {
    /// No error.
    #[inline(always)]
    pub(super) fn none() -> PointError<T> {
        let none = T::default();
        PointError {
            shift: [Vec2::new(none, none); 3],
            left: [none; 3],
        }
    }
}

impl<T: Number> LinkError<T> {
    /// No error.
    #[inline(always)]
    pub(super) fn none() -> LinkError<T> {
        let none = T::default();
        LinkError {
            turn: Vec2::new(none, none),
            shift: [none; 2],
            rest: [none; 3],
        }
    }
}

impl LinkError {
    /// Where the true direction is so much beyond the computed one, but for the rest.
    #[inline(always)]
    pub(super) fn of_way(d: Vec2, way: Vec2, rest: f64) -> LinkError {
        // 1 / d is the conjugate of d, over the square of a length that is as far from 1 as this way is long.
        let most = size(way) + rest;
        LinkError {
            turn: way.turned(d.conj()),
            rest: [rest + most * (4.0 * most + SUM), 0.0, 0.0],
            ..LinkError::none()
        }
    }

    /// Of a link that was found in twice the digits.
    pub(super) fn of_sharp(sharp: &LinkState<Sharp>, value: &LinkState) -> LinkError {
        let (direction, turned) = ways(sharp.d, value.d);
        let ((w, rest_w), (a, rest_a)) = (way(sharp.w, value.w), way(sharp.a, value.a));
        let error = LinkError::of_way(value.d, direction, turned);
        LinkError {
            shift: [w, a],
            rest: [error.rest[0], rest_w, rest_a],
            ..error
        }
    }

    fn sharp(&self, value: &LinkState) -> LinkState<Sharp> {
        let number = |v: f64, shift: f64, rest: f64| Sharp::new(Double::sum(v, shift), rest);
        let direction = value.d.turned(self.turn);
        LinkState {
            d: sharp(value.d, direction, self.rest[0]),
            w: number(value.w, self.shift[0], self.rest[1]),
            a: number(value.a, self.shift[1], self.rest[2]),
        }
    }

    #[inline(always)]
    fn balls(&self, value: &LinkState) -> LinkState<Ball> {
        let rests = Both([self.rest[1], self.rest[2]]);
        let (mid, radius) = ball(Both([value.w, value.a]), Both(self.shift), rests);
        let at = |i: usize| Ball::new(mid.0[i], radius.0[i]);
        let direction = value.d.turned(self.turn);
        LinkState {
            d: balls(value.d, direction, self.rest[0]),
            w: at(0),
            a: at(1),
        }
    }
}

impl Errors {
    /// Room for the errors of an engine's states, with those of its constants in it.
    pub(super) fn new(engine: &Engine, sharp: Workspace<Sharp>) -> Errors {
        let program = &engine.program;
        let off = |v: Vec2<Constant>| v.map(|v| v.radius + TWICE * v.hi.abs());
        let points = program.points.iter().map(|&p| {
            let shift = [p.map(|v| v.lo), Vec2::ZERO, Vec2::ZERO];
            PointError::new(shift, [size(off(p)), 0.0, 0.0])
        });
        let links = program.links.iter().map(|&d| {
            let [near, low] = [d.map(|v| v.hi), d.map(|v| v.lo)];
            LinkError::of_way(near, low, size(off(d)))
        });
        Errors {
            points: points.collect(),
            links: links.collect(),
            influences: Influences::new(program),
            sharp: Some(Box::new(sharp)),
            has_close_steps: program.steps.iter().any(|step| !step.has_residuals()),
            feeds_sharp: false,
            edge: None,
        }
    }

    /// Before a state, and whether its forces are asked for.
    pub(super) fn begin(&mut self, with_forces: bool) {
        self.influences.begin();
        self.feeds_sharp = with_forces || self.has_close_steps;
    }

    #[inline(always)]
    pub(super) fn point(&self, point: PointId) -> &PointError {
        &self.points[point.index()]
    }

    #[inline(always)]
    pub(super) fn link(&self, link: LinkId) -> &LinkError {
        &self.links[link.index()]
    }

    /// Where a slide is, in twice the digits, where these are asked for.
    pub(super) fn travel<const ORDER: u8>(&mut self, step: &Step) {
        if self.feeds_sharp
            && let Some(sharp) = &mut self.sharp
        {
            super::travel::<Sharp, ORDER>(step, &mut sharp.state);
        }
    }

    /// Notes the error of a point, and encloses it.
    #[inline(always)]
    pub(super) fn set_point(
        &mut self,
        point: PointId,
        error: &PointError,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let i = point.index();
        self.points[i] = *error;
        enclosure.points[i] = error.balls(&state.points[i]);
        if self.feeds_sharp {
            self.sharpen_point(i, state);
        }
    }

    #[cold]
    fn sharpen_point(&mut self, i: usize, state: &State) {
        if let Some(sharp) = &mut self.sharp {
            sharp.state.points[i] = self.points[i].sharp(&state.points[i]);
        }
    }

    #[cold]
    fn sharpen_link(&mut self, i: usize, value: &LinkState) {
        if let Some(sharp) = &mut self.sharp {
            sharp.state.links[i] = self.links[i].sharp(value);
        }
    }

    /// Notes the errors of two links, and encloses them.
    #[inline(always)]
    pub(super) fn set_links(
        &mut self,
        links: [LinkId; 2],
        error: &LinkError<Both>,
        value: &LinkState<Both>,
        enclosure: &mut State<Ball>,
    ) {
        let direction = value.d.turned(error.turn);
        let enclosed = [
            ball(value.d.x, direction.x, error.rest[0]),
            ball(value.d.y, direction.y, error.rest[0]),
            ball(value.w, error.shift[0], error.rest[1]),
            ball(value.a, error.shift[1], error.rest[2]),
        ];
        for (i, link) in links.into_iter().enumerate() {
            let at = |k: usize| Ball::new(enclosed[k].0.0[i], enclosed[k].1.0[i]);
            let error = LinkError {
                turn: error.turn.one(i),
                shift: [error.shift[0].0[i], error.shift[1].0[i]],
                rest: [error.rest[0].0[i], error.rest[1].0[i], error.rest[2].0[i]],
            };
            enclosure.links[link.index()] = LinkState {
                d: Vec2::new(at(0), at(1)),
                w: at(2),
                a: at(3),
            };
            self.links[link.index()] = error;
            if self.feeds_sharp {
                let value = LinkState {
                    d: value.d.one(i),
                    w: value.w.0[i],
                    a: value.a.0[i],
                };
                self.sharpen_link(link.index(), &value);
            }
        }
    }

    /// Notes the error of a link, and encloses it.
    #[inline(always)]
    pub(super) fn set_link(
        &mut self,
        link: LinkId,
        error: &LinkError,
        value: &LinkState,
        enclosure: &mut State<Ball>,
    ) {
        let i = link.index();
        self.links[i] = *error;
        enclosure.links[i] = error.balls(value);
        if self.feeds_sharp {
            self.sharpen_link(i, value);
        }
    }
}
