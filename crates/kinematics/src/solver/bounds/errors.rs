//! Stores the errors of a state's points and links.
//!
//! The true value is the computed value plus a shift plus a rest. The shift is signed: the
//! first-order correction from the residuals. Only a bound of the rest is known: errors that no
//! residual shows, such as the error of a typed driver coordinate, and terms of second order.

use super::driver::IntendedCoordinate;
use super::influence::Influences;
use super::link_vector::SUM;
use super::loaded_state::{Bodies, Places};
use super::off::{Enclosed, LinkOff, PointOff};
use crate::arithmetic::plane::{Fallback, Simd, f64x2};
use crate::arithmetic::{DOUBLE_DOUBLE_ERROR, Sharp, U};
use crate::solver::Workspace;
use crate::solver::elements::Step;
use crate::solver::engine::Engine;
use crate::solver::state::{LinkState, PointState, State};
use crate::{Ball, Constant, Double, LinkId, PointId, Vec2};

/// The length of a vector is at most its larger component plus this multiple of the smaller one.
/// That is exact if the components are equal or if one is zero, and too much in between.
const SQRT_2_LESS_1: f64 = 0.414_213_562_4;

/// The errors of a point's position, velocity and acceleration.
///
/// Aligned like states, see [`PointState`].
#[derive(Clone, Copy, Debug)]
#[repr(align(128))]
pub(super) struct PointError {
    pub shift: [Vec2; 3],
    /// Bounds of the length of the rest, including the rounding of the shift's sums.
    pub left: [f64; 3],
}

/// The errors of a link's direction, angular velocity and angular acceleration.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct LinkError {
    /// The relative stretch and the rotation of the true direction: d becomes d (1 + x + i y).
    pub turn: Vec2,
    /// The shifts of the angular velocity and of the angular acceleration.
    pub shift: [f64; 2],
    /// Bounds of the rests of the direction and of the two rates.
    pub rest: [f64; 3],
}

/// The errors of all points and links, and the influence of each constraint on their rests.
#[derive(Debug, Default)]
pub(in crate::solver) struct Errors {
    pub(super) points: Vec<PointError>,
    pub(super) links: Vec<LinkError>,
    pub(super) influences: Influences,
    /// The state in double-double, in which rare steps and the forces run.
    pub(in crate::solver) sharp: Option<Box<Workspace<Sharp>>>,
    /// Whether some step always needs the double-double state. `feeds_double_double`: whether this run
    /// needs it.
    has_close_steps: bool,
    feeds_double_double: bool,
    /// The state of all steps run with typed decimals, for states near an end of the motion.
    pub(in crate::solver) edge: Option<Box<State<Sharp>>>,
    /// Whether numbers represent the decimals as which they were typed.
    pub(super) is_decimal: bool,
    /// The maximum error of a driver coordinate that was not typed but follows from a time, in its
    /// own unit.
    pub(in crate::solver) driven: f64,
}

impl Clone for Errors {
    fn clone(&self) -> Errors {
        let mut copy = Errors::default();
        copy.clone_from(self);
        copy
    }

    /// Copies errors without allocating their memory again: walks copy a workspace at each step.
    fn clone_from(&mut self, other: &Errors) {
        let Errors {
            points,
            links,
            influences,
            sharp,
            has_close_steps,
            feeds_double_double,
            edge,
            is_decimal,
            driven,
        } = self;
        points.clone_from(&other.points);
        links.clone_from(&other.links);
        influences.clone_from(&other.influences);
        sharp.clone_from(&other.sharp);
        *has_close_steps = other.has_close_steps;
        *feeds_double_double = other.feeds_double_double;
        edge.clone_from(&other.edge);
        *is_decimal = other.is_decimal;
        *driven = other.driven;
    }
}

/// Returns the sum of the absolute values of the components.
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

/// Returns the difference of a double-double value from a computed one, and a bound of its rest.
/// The bound includes the rounding of the difference, which takes two sums, twice over.
fn way(sharp: Sharp, value: f64) -> (f64, f64) {
    let way = sharp.way_from(value);
    (way, sharp.radius + 4.0 * U * way.abs())
}

/// Returns the difference of a double-double vector from a computed one, and a bound of its rest.
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

    /// Creates the error of a point computed in double-double.
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
    /// Creates the error of a link whose true direction is `d + way`, up to `rest`.
    #[inline(always)]
    pub(super) fn of_way(d: Vec2, way: Vec2, rest: f64) -> LinkError {
        // 1 / d is the conjugate of d over the square of its length, which differs from 1 by at
        // most |way|.
        let maximum = size(way) + rest;
        LinkError {
            turn: way.turned(d.conj()),
            shift: [0.0; 2],
            rest: [rest + maximum * (4.0 * maximum + SUM), 0.0, 0.0],
        }
    }

    /// Creates the error of a link computed in double-double.
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
    /// Creates the errors for an engine's states, with those of its constants. The most accurate
    /// constants are those of `meant`.
    pub(super) fn new(engine: &Engine, intended: &Engine, sharp: Workspace<Sharp>) -> Errors {
        let program = &intended.program;
        let computed = &engine.program;
        let off = |v: Vec2<Constant>| v.map(|v| v.radius + DOUBLE_DOUBLE_ERROR * v.hi.abs());
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
            feeds_double_double: false,
            edge: None,
            is_decimal: false,
            driven: 0.0,
        }
    }

    /// Returns the enclosure of the intended driver coordinate. Close to an end of the motion the
    /// double itself may be intended as well.
    #[inline(always)]
    pub(super) fn intended<const FUSED: bool>(
        &self,
        at: f64,
        is_clear: bool,
    ) -> IntendedCoordinate {
        let requested = IntendedCoordinate::of::<FUSED>(at);
        if self.is_decimal && is_clear && self.driven == 0.0 {
            requested
        } else {
            IntendedCoordinate::within(requested.max_distance().max(self.driven))
        }
    }

    /// Starts the errors of a state.
    pub(super) fn start(&mut self, with_forces: bool) {
        self.influences.start();
        self.feeds_double_double = with_forces || self.has_close_steps;
    }

    #[inline(always)]
    pub(super) fn point(&self, point: PointId) -> &PointError {
        &self.points[point.index()]
    }

    #[inline(always)]
    pub(super) fn link(&self, link: LinkId) -> &LinkError {
        &self.links[link.index()]
    }

    /// Computes a slide's travel in double-double if this run needs it.
    pub(super) fn travel(&mut self, step: &Step, order: u8) {
        if self.feeds_double_double
            && let Some(sharp) = &mut self.sharp
        {
            super::travel(step, order, &mut sharp.state);
        }
    }

    /// Stores the error of a point with the values `here`, and encloses it.
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
        self.points[i] = error.stored_error();
        enclosure.points[i] = error.balls(here);
        if self.feeds_double_double {
            self.sharpen_point(i, state);
        }
    }

    /// Stores the error of a point that was computed separately, and encloses it.
    pub(super) fn store_point(
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

    /// Stores the error of a link, and encloses it.
    #[inline(always)]
    pub(super) fn set_link<S: Simd>(
        &mut self,
        link: LinkId,
        enclosed: &Enclosed<f64x2<S>>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let i = link.index();
        self.links[i] = enclosed.stored_error();
        enclosure.links[i] = enclosed.balls();
        if self.feeds_double_double {
            self.sharpen_link(i, state);
        }
    }

    /// Stores the error of a link that was computed separately, and encloses it.
    pub(super) fn store_link(
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
