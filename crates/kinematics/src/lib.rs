//! Analyses planar linkages with one input: position, velocity and acceleration of every point and link,
//! forces, and a bound on the error of every value.
//!
//! A [`Mechanism`] holds points, links, slides and the driver by typed ids. [`solver::Solver`] plans
//! it once and then solves any coordinate of the driver, without a history and without allocating.
//! The crate knows no file, no unit name and no terminal; the crate `krank` adds scene files,
//! reports and the workbench.
//!
//! ```text
//! mechanism  points, links, slides and the driver, by typed ids
//!   -> solver  once: which groups, in which order, over which range
//!              then: the driver's coordinate -> a state
//! ```
//!
//! The derivations are in the [`guide`].
//!
//! # A four-bar
//!
//! Crank 100 mm, coupler 300 mm, rocker 250 mm, the ground pivots 400 mm apart; the crank turns at
//! 15 rad/s.
//!
//! ```
//! use kinematics::solver::{Condition, Order, Solver};
//! use kinematics::{Driver, Input, Mechanism, Vec2};
//!
//! let mut builder = Mechanism::builder();
//! let a = builder.ground_point(0.0, 0.0);
//! let d = builder.ground_point(400.0, 0.0);
//! let (b, c) = (builder.moving_point(), builder.moving_point());
//! let crank = builder.link(a, b, 100.0);
//! let coupler = builder.link(b, c, 300.0);
//! builder.link(c, d, 250.0);
//! builder.driver(Driver {
//!     input: Input::Turn(crank),
//!     start: 60.0,
//!     speed: 15.0,
//!     acceleration: 0.0,
//! });
//! // Two assemblies close this loop; the start selects one.
//! builder.start(c, Vec2::new(310.0, 230.0));
//!
//! let solver = Solver::new(&builder.build()?)?;
//! let mut state = solver.state();
//! assert_eq!(solver.solve(60.0, Order::Acceleration, &mut state), Condition::Ok);
//!
//! // Velocities in mm/s and rad/s. A value that was not solved or does not exist is `None`.
//! let v = state.velocity(c).expect("no dead point");
//! assert!((v.x + 722.630802).abs() < 1e-6 && (v.y + 273.816684).abs() < 1e-6);
//! assert!((state.omega(coupler).expect("no dead point") + 3.916412730).abs() < 1e-9);
//!
//! // Error bounds.
//! let mut enclosure = solver.enclosure();
//! solver.enclose(&mut state, Order::Acceleration, &mut enclosure);
//! let ball = enclosure.velocity(c).expect("no dead point");
//! assert!(ball.x.bound(v.x).expect("no dead point is near") < 1e-11);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![doc = include_str!("notation.md")]
#![cfg_attr(test, allow(clippy::unwrap_used, reason = "a test fails by panicking"))]

#[doc(hidden)]
pub mod arithmetic;
pub mod guide;
#[doc(hidden)]
pub mod mechanism;
#[doc(hidden)]
pub mod numeric;
#[doc(hidden)]
pub mod parallel;
pub mod solver;

pub use arithmetic::{Ball, Constant, Double, Dual, LANES, Lanes, Number, Vec2, angle, vectorized};
pub use mechanism::{
    Body, Builder, ClampedSpline, CoordinateAxis, Defect, Defects, Driver, DriverMoment, ElementId,
    Input, InputLaw, InputTable, Length, Limit, LimitId, LimitOf, Link, LinkId, Load, Mechanism,
    Member, MotionLaw, MotionPeaks, Point, PointCircle, PointId, PointLead, PointPath,
    PolarPosition, Profile, SineStep, Slide, SlideId, Slider, StepLaw, StrokeEnd, TimedInput,
    TimedStep, Tolerances,
};

/// The symbols and units of this crate as a Markdown table, for manuals.
pub const NOTATION: &str = include_str!("notation.md");
