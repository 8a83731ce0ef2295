//! What is known of the errors of a state's points and links.
//!
//! The true figure is what was computed, plus a shift, plus a rest. The shift is signed: it is what the
//! residuals say, to the first order. The rest is only known to be small: what no residual tells, such
//! as what a typed coordinate of the driver is off by, and what is of the second order.

use super::driver::AskedCoordinate;
use super::influence::Influences;
use super::limb::SUM;
use super::off::{Enclosed, LinkOff, PointOff};
use super::places::{Bodies, Places};
use crate::arithmetic::plane::{Fallback, Simd, f64x2};
use crate::arithmetic::{Sharp, TWICE, U};
use crate::solver::Workspace;
use crate::solver::elements::Step;
use crate::solver::engine::Engine;
use crate::solver::state::{LinkState, PointState, State};
use crate::{Ball, Constant, Double, LinkId, PointId, Vec2};

/// The length of a vector is at most its larger component and this part of the other one: where they are equal, and
/// where one is zero, that is what it is, and in between it is less.
const SQRT_2_LESS_1: f64 = 0.414_213_562_4;

/// The errors of a point's position, velocity and acceleration.
///
/// Aligned as states are, see [`PointState`].
#[derive(Clone, Copy, Debug)]
#[repr(align(128))]
pub(super) struct PointError {
    pub shift: [Vec2; 3],
    /// Bounds of the length of the rest, with what adding up the shift rounds.
    pub left: [f64; 3],
}

/// The errors of a link's direction, angular velocity and acceleration.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct LinkError {
    /// By how much the true direction is longer than the computed one, and turned: d becomes d (1 + x + i y).
    pub turn: Vec2,
    /// Of the velocity and of the acceleration.
    pub shift: [f64; 2],
    /// Bounds of the rest: of the direction and of the rates.
    pub rest: [f64; 3],
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
    pub(in crate::solver) edge: Option<Box<State<Sharp>>>,
    /// Whether numbers stand for the decimals that they were typed as.
    pub(super) is_decimal: bool,
    /// How far the driver's coordinate can be from what was meant where it was not typed but follows from a time, in
    /// its own unit.
    pub(in crate::solver) driven: f64,
}

/// The sum of the sizes of the components.
#[inline(always)]
pub(super) fn size(v: Vec2) -> f64 {
    v.x.abs() + v.y.abs()
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
    fn new(shift: [Vec2; 3], left: [f64; 3]) -> PointError {
        let left = std::array::from_fn(|order| left[order] + size(shift[order]) * SUM);
        PointError { shift, left }
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
}

impl LinkError {
    /// Where the true direction is so much beyond the computed one, but for the rest.
    #[inline(always)]
    pub(super) fn of_way(d: Vec2, way: Vec2, rest: f64) -> LinkError {
        // 1 / d is the conjugate of d, over the square of a length that is as far from 1 as this way is long.
        let most = size(way) + rest;
        LinkError {
            turn: way.turned(d.conj()),
            shift: [0.0; 2],
            rest: [rest + most * (4.0 * most + SUM), 0.0, 0.0],
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
}

impl Errors {
    /// Room for the errors of an engine's states: those of its constants, of which `meant` knows best what they are.
    pub(super) fn new(engine: &Engine, meant: &Engine, sharp: Workspace<Sharp>) -> Errors {
        let program = &meant.program;
        let computed = &engine.program;
        let off = |v: Vec2<Constant>| v.map(|v| v.radius + TWICE * v.hi.abs());
        let way =
            |v: Vec2<Constant>, from: Vec2| (v.map(Constant::value) - from.exactly()).nearest();
        let points = program.points.iter().zip(&computed.points).map(|(&p, of)| {
            let shift = [way(p, of.nearest()), Vec2::ZERO, Vec2::ZERO];
            PointError::new(shift, [size(off(p)), 0.0, 0.0])
        });
        let links = program.links.iter().zip(&computed.links).map(|(&d, of)| {
            let near = of.nearest();
            LinkError::of_way(near, way(d, near), size(off(d)))
        });
        Errors {
            points: points.collect(),
            links: links.collect(),
            influences: Influences::new(program),
            sharp: Some(Box::new(sharp)),
            has_close_steps: program.steps.iter().any(|step| !step.has_residuals()),
            feeds_sharp: false,
            edge: None,
            is_decimal: false,
            driven: 0.0,
        }
    }

    /// Where the driver's coordinate lies that was meant; close to an end of the motion its double may be meant as well.
    #[inline(always)]
    pub(super) fn asked<const FUSED: bool>(&self, at: f64, is_clear: bool) -> AskedCoordinate {
        let asked = AskedCoordinate::of::<FUSED>(at);
        if self.is_decimal && is_clear && self.driven == 0.0 {
            asked
        } else {
            AskedCoordinate::within(asked.most().max(self.driven))
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
    pub(super) fn travel(&mut self, step: &Step, order: u8) {
        if self.feeds_sharp
            && let Some(sharp) = &mut self.sharp
        {
            super::travel(step, order, &mut sharp.state);
        }
    }

    /// Notes the error of a point that is here, and encloses it.
    #[inline(always)]
    pub(super) fn set_point<S: Simd>(
        &mut self,
        point: PointId,
        error: &PointOff<f64x2<S>>,
        here: &Places<f64x2<S>>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let i = point.index();
        self.points[i] = error.kept();
        enclosure.points[i] = error.balls(here);
        if self.feeds_sharp {
            self.sharpen_point(i, state);
        }
    }

    /// The same of an error that was found apart.
    pub(super) fn put_point(
        &mut self,
        point: PointId,
        error: &PointError,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let simd = Fallback::new();
        let here = Places::of(simd, &state.points[point.index()]);
        self.set_point(point, &PointOff::of(simd, error), &here, state, enclosure);
    }

    /// Notes the error of a link, and encloses it.
    #[inline(always)]
    pub(super) fn set_link<S: Simd>(
        &mut self,
        link: LinkId,
        enclosed: &Enclosed<f64x2<S>>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let i = link.index();
        self.links[i] = enclosed.kept();
        enclosure.links[i] = enclosed.balls();
        if self.feeds_sharp {
            self.sharpen_link(i, state);
        }
    }

    /// The same of an error that was found apart.
    pub(super) fn put_link(
        &mut self,
        link: LinkId,
        error: &LinkError,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let simd = Fallback::new();
        let here = Bodies::of(simd, &state.links[link.index()]);
        let enclosed = LinkOff::of(simd, error).enclosed(&here);
        self.set_link(link, &enclosed, state, enclosure);
    }

    #[cold]
    fn sharpen_point(&mut self, i: usize, state: &State) {
        if let Some(sharp) = &mut self.sharp {
            sharp.state.points[i] = self.points[i].sharp(&state.points[i]);
        }
    }

    #[cold]
    fn sharpen_link(&mut self, i: usize, state: &State) {
        if let Some(sharp) = &mut self.sharp {
            sharp.state.links[i] = self.links[i].sharp(&state.links[i]);
        }
    }
}
