//! Tests the public interface of the library as a dependent crate uses it.

use crate::scene::{Diagnostics, ValueError};
use crate::solver::{Condition, Fault, Order, Solver, State, Workspace};
use crate::{Defect, Defects, Driver, Input, Mechanism, Vec2};
use nalgebra::{Point2, Vector2};
use std::error::Error;

/// Errors can be sent to other threads, boxed and stored.
const fn is_boxable_error<E: Error + Send + Sync + 'static>() {}
const fn is_send_and_sync<T: Send + Sync + Clone + 'static>() {}

const _: () = {
    is_boxable_error::<Defect>();
    is_boxable_error::<Defects>();
    is_boxable_error::<Fault>();
    is_boxable_error::<Diagnostics>();
    is_boxable_error::<ValueError>();
    is_boxable_error::<crate::assembly::AssemblyError>();
    is_boxable_error::<crate::quantity::TimeError>();
    is_boxable_error::<crate::quantity::UnknownColumn>();
    is_boxable_error::<crate::report::StepsError>();
    is_boxable_error::<crate::study::motor::NoRam>();
    is_send_and_sync::<Mechanism>();
    is_send_and_sync::<Solver>();
    is_send_and_sync::<State>();
    is_send_and_sync::<Workspace>();
};

/// Returns the rocker's angular velocity of a four-bar, with `?` at every step from the builder to
/// the value.
fn rocker(crank: f64) -> Result<f64, Box<dyn Error + Send + Sync>> {
    let mut builder = Mechanism::builder();
    let a = builder.ground_point(0.0, 0.0);
    let d = builder.ground_point(4.0, 0.0);
    let (b, c) = (builder.moving_point(), builder.moving_point());
    let link = builder.link(a, b, crank);
    builder.link(b, c, 3.0);
    let rocker = builder.link(c, d, 2.5);
    builder.driver(Driver {
        input: Input::Turn(link),
        start: 60.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    builder.start(c, Point2::new(3.1, 2.3).into());
    let solver = Solver::new(&builder.build()?)?;
    let mut state = solver.state();
    match solver.solve(60.0, Order::Velocity, &mut state) {
        Condition::Ok | Condition::ChangePoint => {}
        other => return Err(format!("{other:?}").into()),
    }
    state.omega(rocker).ok_or_else(|| "no velocity".into())
}

#[test]
fn question_mark_operator_works_at_every_step() {
    assert!(rocker(1.0).unwrap().is_finite());
    let unsound = rocker(-1.0).unwrap_err();
    assert_eq!(
        unsound.to_string(),
        "the length must be a positive number, not -1"
    );
    let open = rocker(20.0).unwrap_err();
    assert!(open.downcast_ref::<Fault>().is_some(), "{open}");
}

#[test]
fn message_lists_all_defects() {
    let mut builder = Mechanism::builder();
    let (a, b) = (builder.ground_point(0.0, f64::NAN), builder.moving_point());
    builder.link(a, b, 0.0);
    let defects = builder.build().unwrap_err();
    assert_eq!(defects.list().len(), 3);
    assert_eq!(
        defects.to_string(),
        "the coordinates must be finite numbers; the length must be a positive number, not 0; \
         there is no driver"
    );
}

#[test]
fn vectors_convert_from_and_to_nalgebra() {
    let v = Vec2::new(1.5, -2.0);
    let (vector, point): (Vector2<f64>, Point2<f64>) = (v.into(), v.into());
    assert_eq!(
        (vector.x, vector.y, point.x, point.y),
        (1.5, -2.0, 1.5, -2.0)
    );
    assert_eq!((Vec2::from(vector), Vec2::from(point)), (v, v));
}

/// A solver owns its mechanism, so that a caller cannot pass a wrong one.
#[test]
fn solver_owns_its_mechanism() {
    let mut builder = Mechanism::builder();
    let (a, b) = (builder.ground_point(0.0, 0.0), builder.moving_point());
    let link = builder.link(a, b, 2.0);
    builder.driver(Driver {
        input: Input::Turn(link),
        start: 0.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    let solver = Solver::new(&builder.build().unwrap()).unwrap();
    assert_eq!(solver.mechanism().links().len(), 1);
    let faster = solver.at_speed(3.0, 1.0);
    let driver = faster.mechanism().driver();
    assert_eq!((driver.speed, driver.acceleration), (3.0, 1.0));
    assert_eq!(solver.mechanism().driver().speed, 1.0);
}
