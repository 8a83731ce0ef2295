//! The four-bar of most cases, and the comparison of a value with its exact value.

use crate::exact::DoubleDouble;
use krank::scene::Scene;
use krank::solver::{Condition, Fault, Order, Solver, State};
use krank::{Body, Driver, Input, LinkId, Mechanism, PointId, SlideId, Vec2, angle};

/// Half an ulp of 1: the unit of rounding.
pub(crate) const U: f64 = f64::EPSILON / 2.0;

/// Parses an exact value.
pub(crate) fn exact(decimal: &str) -> DoubleDouble {
    DoubleDouble::parse(decimal).expect("a decimal")
}

/// Asserts that a value agrees with a decimal of more digits than a double has.
pub(crate) fn assert_near(what: &str, found: f64, decimal: &str, tolerance: f64) {
    let error = exact(decimal).minus(found).abs();
    assert!(
        error <= tolerance,
        "{what}: {found:e} instead of {decimal}, off by {error:e}, allowed {tolerance:e}"
    );
}

/// Prints a measured error, visible with `--nocapture`.
#[expect(clippy::print_stdout, reason = "the measured figures are to be read")]
pub(crate) fn note(text: &str) {
    println!("{text}");
}

/// Returns a point by its name in the scene.
pub(crate) fn point(scene: &Scene, name: &str) -> PointId {
    let mut points = scene.mechanism.point_ids();
    points.find(|&p| scene.point_name(p) == Some(name)).unwrap()
}

/// A four-bar AB, BC, CD on a ground AD along x, driven at the crank AB.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FourBar {
    pub(crate) crank: f64,
    pub(crate) coupler: f64,
    pub(crate) rocker: f64,
    pub(crate) ground: f64,
    /// The position of A.
    pub(crate) origin: Vec2,
    /// +1 for C on the left of B -> D.
    pub(crate) side: f64,
    /// The crank's start angle, in degrees.
    pub(crate) start: f64,
    pub(crate) speed: f64,
    pub(crate) acceleration: f64,
}

/// The four-bar of the lecture at its own 60 degrees and 15 rad/s.
pub(crate) const LECTURE: FourBar = FourBar {
    crank: 100.0,
    coupler: 300.0,
    rocker: 250.0,
    ground: 400.0,
    origin: Vec2::ZERO,
    side: 1.0,
    start: 60.0,
    speed: 15.0,
    acceleration: 0.0,
};

/// A solver for a four-bar; the rocker is the link from D to C.
pub(crate) struct Opened {
    pub(crate) of: FourBar,
    pub(crate) mechanism: Mechanism,
    pub(crate) solver: Solver,
    pub(crate) pin: PointId,
    pub(crate) joint: PointId,
    pub(crate) coupler: LinkId,
    pub(crate) rocker: LinkId,
}

impl FourBar {
    pub(crate) fn scaled(self, by: f64) -> FourBar {
        FourBar {
            crank: self.crank * by,
            coupler: self.coupler * by,
            rocker: self.rocker * by,
            ground: self.ground * by,
            origin: self.origin * by,
            ..self
        }
    }

    pub(crate) fn longest(self) -> f64 {
        self.crank
            .max(self.coupler)
            .max(self.rocker)
            .max(self.ground)
    }

    /// Returns an approximate position of C on its side of B -> D.
    fn near(self) -> Vec2 {
        let b = angle::unit(self.start) * self.crank;
        let line = Vec2::new(self.ground, 0.0) - b;
        let middle = self.origin + b + line * 0.5;
        middle + line.perp() / line.norm() * (self.side * self.coupler.min(self.rocker))
    }

    pub(crate) fn try_open(self) -> Result<Opened, Fault> {
        let mut builder = Mechanism::builder();
        let a = builder.ground_point(self.origin.x, self.origin.y);
        let d = builder.ground_point(self.origin.x + self.ground, self.origin.y);
        let (pin, joint) = (builder.moving_point(), builder.moving_point());
        let crank = builder.link(a, pin, self.crank);
        let coupler = builder.link(pin, joint, self.coupler);
        let rocker = builder.link(d, joint, self.rocker);
        builder.driver(Driver {
            input: Input::Turn(crank),
            start: self.start,
            speed: self.speed,
            acceleration: self.acceleration,
        });
        builder.start(joint, self.near());
        let mechanism = builder.build().expect("every element is sound");
        Ok(Opened {
            of: self,
            solver: Solver::new(&mechanism)?,
            mechanism,
            pin,
            joint,
            coupler,
            rocker,
        })
    }

    pub(crate) fn open(self) -> Opened {
        self.try_open().unwrap_or_else(|e| panic!("{self:?}: {e}"))
    }
}

impl Opened {
    pub(crate) fn at(&self, degrees: f64) -> State {
        solved(&self.solver, degrees)
    }

    /// Returns the sine of the transmission angle.
    pub(crate) fn sin_mu(&self, state: &State) -> f64 {
        let cross = state
            .direction(self.coupler)
            .unwrap()
            .cross(state.direction(self.rocker).unwrap());
        cross.abs()
    }

    /// Returns the allowed error of a position: the rounding error of C divided by the sine of the
    /// transmission angle.
    pub(crate) fn position_slack(&self, state: &State) -> f64 {
        3.6 * U * self.of.longest() / self.sin_mu(state)
    }

    /// Returns the allowed error of an angular velocity.
    pub(crate) fn omega_slack(&self, state: &State, omega: f64) -> f64 {
        let sin_mu = self.sin_mu(state);
        let size = omega.abs().max(self.of.speed.abs());
        7.0 * U * size * self.lever() / (sin_mu * sin_mu)
    }

    /// Returns the allowed error of an angular acceleration.
    pub(crate) fn alpha_slack(&self, state: &State, alpha: f64) -> f64 {
        let sin_mu = self.sin_mu(state);
        let own = self.of.speed.powi(2).max(self.of.acceleration.abs());
        40.0 * U * alpha.abs().max(own) * self.lever().powi(2) / (sin_mu * sin_mu)
    }

    /// Returns the ratio of the longest link to the shorter link of the dyad.
    fn lever(&self) -> f64 {
        self.of.longest() / self.of.coupler.min(self.of.rocker)
    }
}

/// Returns the state at a coordinate, which must have positions and rates.
pub(crate) fn solved(solver: &Solver, at: f64) -> State {
    let mut state = solver.state();
    let condition = solver.solve(at, Order::Acceleration, &mut state);
    assert_eq!(condition, Condition::Ok, "at {at}");
    state.into_state()
}

/// Returns the solver's condition at a coordinate.
pub(crate) fn condition(solver: &Solver, at: f64) -> Condition {
    solver.solve(at, Order::Position, &mut solver.state())
}

/// Two links that meet at C; one end is at the origin, the other is pushed along x.
pub(crate) struct Triangle {
    pub(crate) solver: Solver,
    pub(crate) apex: PointId,
}

impl Triangle {
    /// Opens with C approximately at `near`.
    pub(crate) fn open(base: f64, left: f64, right: f64, near: Vec2) -> Result<Triangle, Fault> {
        let mut builder = Mechanism::builder();
        let origin = builder.ground_point(0.0, 0.0);
        let (foot, apex) = (builder.moving_point(), builder.moving_point());
        builder.link(origin, apex, left);
        builder.link(apex, foot, right);
        let slide = builder.pin_in_slot(foot, Body::Ground, Vec2::ZERO, 0.0);
        builder.driver(push(slide, base));
        builder.start(apex, near);
        let mechanism = builder.build().expect("every element is sound");
        let solver = Solver::new(&mechanism)?;
        Ok(Triangle { solver, apex })
    }
}

/// Creates a driver that pushes a slide at one unit per second.
pub(crate) fn push(slide: SlideId, start: f64) -> Driver {
    Driver {
        input: Input::Push(slide),
        start,
        speed: 1.0,
        acceleration: 0.0,
    }
}

/// Creates a driver that turns a link at one radian per second.
pub(crate) fn turn(link: LinkId, start: f64) -> Driver {
    Driver {
        input: Input::Turn(link),
        start,
        speed: 1.0,
        acceleration: 0.0,
    }
}
