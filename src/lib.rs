//! Planar linkages with one input: position, velocity and acceleration of every point and link.
//!
//! krank is a program and this library. The program has a workbench in the terminal and commands.
//! The library provides scene files, the solver and the reports, for other front ends.
//! Without the feature `tui`, the workbench and all terminal crates are left out.
//!
//! # Data flow
//!
//! ```text
//! scene file (TOML)
//!   -> scene      text, units and names; every fault has a line and column
//!   -> mechanism  points, links, slides and the driver, with typed ids: no text, no I/O
//!   -> solver     once: the groups, their order and the range of motion
//!                 then: the driver's coordinate -> a state, without history or allocation;
//!                 with loads, also the forces
//!   -> quantity   everything with a name, a unit and a value
//!   -> study      all solution methods, timed and compared with a reference; the motor over a
//!                 cycle
//!   -> synthesis  from a required motion to linkages; a task is a file, too
//!   -> report     pages, CSV, JSON       -> drawing, tui   the linkage in characters, live tables
//! ```
//!
//! The [`guide`] explains each part of the solver, with derivations.
//!
//! No module imports against this direction: [`solver`] knows no file, no unit name and no terminal.
//! The solver's errors refer to ids; [`scene::Scene::explain`] adds the lines of the file.
//!
//! # A four-bar in code
//!
//! The four-bar of the lectures has a crank of 100 mm, a coupler of 300 mm, a rocker of 250 mm and
//! ground pivots 400 mm apart. The crank turns at 15 rad/s.
//!
//! ```
//! use krank::solver::{Condition, Order, Solver};
//! use krank::{Driver, Input, Mechanism, Vec2};
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
//! // The loop has two assemblies; the start position of C selects one.
//! builder.start(c, Vec2::new(310.0, 230.0));
//!
//! // Checks once that all elements are valid, and that the linkage can be assembled and has one input.
//! let solver = Solver::new(&builder.build()?)?;
//! let mut state = solver.state();
//! assert_eq!(solver.solve(60.0, Order::Acceleration, &mut state), Condition::Ok);
//!
//! // The velocity of C in mm/s, and the coupler's angular velocity in rad/s. Values that were not solved
//! // or do not exist are None.
//! let v = state.velocity(c).expect("no dead point");
//! assert!((v.x + 722.630802).abs() < 1e-6 && (v.y + 273.816684).abs() < 1e-6);
//! assert!((state.omega(coupler).expect("no dead point") + 3.916412730).abs() < 1e-9);
//!
//! // A proved bound of the error: the ball contains the exact velocity.
//! let mut enclosure = solver.enclosure();
//! solver.enclose(&mut state, Order::Acceleration, &mut enclosure);
//! let ball = enclosure.velocity(c).expect("no dead point");
//! assert!(ball.x.bound(v.x).expect("no dead point is near") < 1e-11);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The notation is that of the crate [`kinematics`](kinematics#notation).
#![cfg_attr(test, allow(clippy::unwrap_used, reason = "a test fails by panicking"))]

#[cfg(all(feature = "tui", not(unix)))]
compile_error!("the workbench needs the terminal of a Unix: build with --no-default-features");

#[cfg_attr(
    not(feature = "tui"),
    allow(
        dead_code,
        unreachable_pub,
        reason = "messages need less of it than the workbench"
    )
)]
mod capability;
pub mod cli;
pub mod drawing;
mod files;
pub mod import;
mod manual;
pub mod page;
mod pixels;
pub mod report;
pub mod scene;
pub mod script_export;
pub mod synthesis;
pub mod task_file;
#[cfg(test)]
mod tests;
#[cfg(feature = "tui")]
pub mod tui;

pub use kinematics::{guide, solver};
use kinematics::{numeric, parallel};
#[doc(inline)]
pub use model::{assembly, quantity, study};
use model::{document, expression, nearest, wording};

pub use kinematics::{Ball, Constant, Double, Dual, LANES, Lanes, Number, Vec2, angle, vectorized};
pub use kinematics::{
    Body, Builder, ClampedSpline, CoordinateAxis, Defect, Defects, Driver, DriverMoment, ElementId,
    Input, InputLaw, InputTable, Length, Limit, LimitId, LimitOf, Link, LinkId, Load, Mechanism,
    Member, MotionLaw, MotionPeaks, Point, PointCircle, PointId, PointLead, PointPath,
    PolarPosition, Profile, SineStep, Slide, SlideId, Slider, StepLaw, StrokeEnd, TimedInput,
    TimedStep, Tolerances,
};
