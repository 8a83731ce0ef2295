//! What is known of the errors of a state's points and links.
//!
//! The true figure is what was computed, plus a shift, plus a rest. The shift is signed: it is what the
//! residuals say, to the first order. The rest is only known to be small: what no residual tells, such
//! as the digits of a length that was typed, and what is of the second order.

use super::influence::Influences;
use crate::arithmetic::{Sharp, U, two_sum};
use crate::solver::coupled::Scratch;
use crate::solver::engine::Engine;
use crate::solver::state::{LinkState, PointState, State};
use crate::solver::step::Step;
use crate::{Ball, Constant, Double, LinkId, PointId, Vec2};

/// What is lost of a constant in twice the precision, with room.
const TWICE: f64 = 1e-31;

/// The errors of a point's position, velocity and acceleration.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct PointError {
    pub shift: [Vec2; 3],
    /// Bounds of the rest, in each component.
    pub rest: [Vec2; 3],
    /// What of the rest is not the influence of constraints: a bound of the sum of its components.
    pub own: [f64; 3],
    /// The size of the rest, and how far the true one can be from the computed one at most.
    pub left: [f64; 3],
    pub most: [f64; 3],
}

/// The errors of a link's direction, angular velocity and acceleration.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LinkError {
    pub direction: Vec2,
    /// Of the velocity and of the acceleration.
    pub shift: [f64; 2],
    /// Bounds of the rest: of the angle and its rates.
    pub rest: [f64; 3],
    /// What of the rest is not the influence of constraints; of the direction along itself, too.
    pub own: [f64; 3],
}

/// Of all points and links, and what of their rests comes from which constraint.
#[derive(Clone, Debug, Default)]
pub(in crate::solver) struct Errors {
    pub(super) points: Vec<PointError>,
    pub(super) links: Vec<LinkError>,
    pub(super) influences: Influences,
    /// The same in twice the digits, for steps that are run in these.
    pub(super) sharp: Option<Box<Closely>>,
}

/// Room to run steps in twice the digits.
#[derive(Clone, Debug)]
pub(super) struct Closely {
    pub state: State<Sharp>,
    pub scratch: Scratch<Sharp>,
}

/// Whether a step is run in twice the digits: what comes too seldom to be looked at more closely.
pub(super) fn is_run_closely(step: &Step) -> bool {
    matches!(
        step,
        Step::CircleLine(_)
            | Step::Cylinder(_)
            | Step::Swing(_)
            | Step::Coupled { .. }
            | Step::Push { .. }
            | Step::Lines { .. }
    )
}

/// The sum of the sizes of the components.
#[inline(always)]
pub(super) fn size(v: Vec2) -> f64 {
    v.x.abs() + v.y.abs()
}

fn widths(v: Vec2<Ball>) -> Vec2 {
    v.map(|v| v.radius)
}

#[inline(always)]
fn ball(value: f64, shift: f64, rest: f64) -> Ball {
    let (mid, lost) = two_sum(value, shift);
    Ball::new(mid, rest + lost.abs())
}

#[inline(always)]
fn balls(value: Vec2, shift: Vec2, rest: Vec2) -> Vec2<Ball> {
    Vec2::new(
        ball(value.x, shift.x, rest.x),
        ball(value.y, shift.y, rest.y),
    )
}

fn sharp(value: Vec2, shift: Vec2, rest: Vec2) -> Vec2<Sharp> {
    Vec2::new(
        Sharp::new(Double::sum(value.x, shift.x), rest.x),
        Sharp::new(Double::sum(value.y, shift.y), rest.y),
    )
}

/// From a computed value to the middle of a ball.
fn way(ball: Vec2<Ball>, value: Vec2) -> Vec2 {
    ball.map(|v| v.mid) - value
}

impl PointError {
    /// Sums up an order once its shift and its rest are known.
    #[inline(always)]
    pub(super) fn settle(&mut self, order: usize) {
        self.left[order] = self.rest[order].x + self.rest[order].y;
        self.most[order] = size(self.shift[order]) + self.left[order];
    }

    /// With a shift and a rest that is all its own.
    fn alone(shift: [Vec2; 3], rest: [Vec2; 3]) -> PointError {
        let mut error = PointError {
            shift,
            rest,
            own: rest.map(size),
            ..PointError::default()
        };
        (0..3).for_each(|order| error.settle(order));
        error
    }

    /// Of a point that was enclosed in balls.
    pub(super) fn of_balls(ball: &PointState<Ball>, value: &PointState) -> PointError {
        let rest = [ball.p, ball.v, ball.a].map(widths);
        let shift = [
            way(ball.p, value.p),
            way(ball.v, value.v),
            way(ball.a, value.a),
        ];
        PointError::alone(shift, rest)
    }

    /// Of a point that was found in twice the digits.
    pub(super) fn of_sharp(sharp: &PointState<Sharp>, value: &PointState) -> PointError {
        let found = [(sharp.p, value.p), (sharp.v, value.v), (sharp.a, value.a)];
        let shift = found
            .map(|(sharp, value)| Vec2::new(sharp.x.way_from(value.x), sharp.y.way_from(value.y)));
        let rest = std::array::from_fn(|k| {
            let (of, shift) = (found[k].0, shift[k]);
            Vec2::new(
                of.x.radius + U * shift.x.abs(),
                of.y.radius + U * shift.y.abs(),
            )
        });
        PointError::alone(shift, rest)
    }

    fn sharp(&self, value: &PointState) -> PointState<Sharp> {
        PointState {
            p: sharp(value.p, self.shift[0], self.rest[0]),
            v: sharp(value.v, self.shift[1], self.rest[1]),
            a: sharp(value.a, self.shift[2], self.rest[2]),
        }
    }

    #[inline(always)]
    fn balls(&self, value: &PointState) -> PointState<Ball> {
        PointState {
            p: balls(value.p, self.shift[0], self.rest[0]),
            v: balls(value.v, self.shift[1], self.rest[1]),
            a: balls(value.a, self.shift[2], self.rest[2]),
        }
    }
}

impl LinkError {
    /// How far the true one is from the computed one at most, at the velocity and beyond.
    #[inline(always)]
    pub(super) fn most_rate(&self, order: usize) -> f64 {
        self.shift[order - 1].abs() + self.rest[order]
    }

    /// Of a link that was enclosed in balls.
    pub(super) fn of_balls(ball: &LinkState<Ball>, value: &LinkState) -> LinkError {
        let rest = [size(widths(ball.d)), ball.w.radius, ball.a.radius];
        LinkError {
            direction: way(ball.d, value.d),
            shift: [ball.w.mid - value.w, ball.a.mid - value.a],
            rest,
            own: rest,
        }
    }

    /// Of a link that was found in twice the digits.
    pub(super) fn of_sharp(sharp: &LinkState<Sharp>, value: &LinkState) -> LinkError {
        let direction = Vec2::new(sharp.d.x.way_from(value.d.x), sharp.d.y.way_from(value.d.y));
        let shift = [sharp.w.way_from(value.w), sharp.a.way_from(value.a)];
        let rest = [
            sharp.d.x.radius + sharp.d.y.radius + U * size(direction),
            sharp.w.radius + U * shift[0].abs(),
            sharp.a.radius + U * shift[1].abs(),
        ];
        LinkError {
            direction,
            shift,
            rest,
            own: rest,
        }
    }

    /// How far the direction can be off in each component: turned, and along itself.
    #[inline(always)]
    fn spread(&self, d: Vec2) -> Vec2 {
        let turn = self.rest[0];
        let along = self.own[0] + turn * size(self.direction);
        Vec2::new(
            turn * d.y.abs() + along * d.x.abs(),
            turn * d.x.abs() + along * d.y.abs(),
        )
    }

    fn sharp(&self, value: &LinkState) -> LinkState<Sharp> {
        let number = |v: f64, shift: f64, rest: f64| Sharp::new(Double::sum(v, shift), rest);
        LinkState {
            d: sharp(value.d, self.direction, self.spread(value.d)),
            w: number(value.w, self.shift[0], self.rest[1]),
            a: number(value.a, self.shift[1], self.rest[2]),
        }
    }

    #[inline(always)]
    fn balls(&self, value: &LinkState) -> LinkState<Ball> {
        LinkState {
            d: balls(value.d, self.direction, self.spread(value.d)),
            w: ball(value.w, self.shift[0], self.rest[1]),
            a: ball(value.a, self.shift[1], self.rest[2]),
        }
    }
}

impl Errors {
    /// Room for the errors of an engine's states, with those of its constants in it.
    pub(super) fn new(engine: &Engine, slides: usize) -> Errors {
        let program = &engine.program;
        let off = |v: Vec2<Constant>| v.map(|v| v.radius + TWICE * v.hi.abs());
        let points = program.points.iter().map(|&p| {
            let shift = [p.map(|v| v.lo), Vec2::ZERO, Vec2::ZERO];
            PointError::alone(shift, [off(p), Vec2::ZERO, Vec2::ZERO])
        });
        let links = program.links.iter().map(|&d| LinkError {
            direction: d.map(|v| v.lo),
            rest: [size(off(d)), 0.0, 0.0],
            own: [size(off(d)), 0.0, 0.0],
            ..LinkError::default()
        });
        let closely = || {
            let work = engine.state(slides);
            Box::new(Closely {
                state: work.state,
                scratch: work.scratch,
            })
        };
        let is_close = program.steps.iter().any(is_run_closely);
        Errors {
            points: points.collect(),
            links: links.collect(),
            influences: Influences::new(program),
            sharp: is_close.then(closely),
        }
    }

    #[inline(always)]
    pub(super) fn point(&self, point: PointId) -> &PointError {
        &self.points[point.index()]
    }

    #[inline(always)]
    pub(super) fn link(&self, link: LinkId) -> &LinkError {
        &self.links[link.index()]
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
        let value = &state.points[i];
        enclosure.points[i] = error.balls(value);
        if let Some(closely) = &mut self.sharp {
            closely.state.points[i] = error.sharp(value);
        }
        self.points[i] = *error;
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
        enclosure.links[i] = error.balls(value);
        if let Some(closely) = &mut self.sharp {
            closely.state.links[i] = error.sharp(value);
        }
        self.links[i] = *error;
    }
}
