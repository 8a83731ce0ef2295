//! Prints the rocker's angle and angular velocity of a four-bar over one turn, with error bounds.

#![allow(clippy::print_stdout, reason = "the table is the result")]

use kinematics::solver::{Condition, Order, Solver};
use kinematics::{Driver, Input, Mechanism, Vec2};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut builder = Mechanism::builder();
    let a = builder.ground_point(0.0, 0.0);
    let d = builder.ground_point(400.0, 0.0);
    let (b, c) = (builder.moving_point(), builder.moving_point());
    let crank = builder.link(a, b, 100.0);
    builder.link(b, c, 300.0);
    let rocker = builder.link(d, c, 250.0);
    builder.driver(Driver {
        input: Input::Turn(crank),
        start: 60.0,
        speed: 15.0,
        acceleration: 0.0,
    });
    builder.start(c, Vec2::new(310.0, 230.0));
    let solver = Solver::new(&builder.build()?)?;
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    println!("crank [deg]  rocker [deg]  omega [rad/s]  bound [rad/s]");
    for step in 0..=12 {
        let at = 30.0 * f64::from(step);
        if solver.solve(at, Order::Velocity, &mut state) != Condition::Ok {
            continue;
        }
        solver.enclose(&mut state, Order::Velocity, &mut enclosure);
        let bound = |omega: f64| enclosure.omega(rocker).and_then(|ball| ball.bound(omega));
        if let (Some(angle), Some(omega)) = (state.angle(rocker), state.omega(rocker)) {
            let bound = bound(omega).unwrap_or(f64::INFINITY);
            println!("{at:11.1}  {angle:12.6}  {omega:13.9}  {bound:13.1e}");
        }
    }
    Ok(())
}
