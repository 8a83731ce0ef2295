//! Tests the extremes of transmission angles against textbook formulas and against states.

use crate::plant::*;
use krank::solver::{Condition, Order, Range, Solver, Transmission};
use krank::{Body, Driver, Input, LinkId, Mechanism, Vec2};
use proptest::prelude::*;

/// Returns the angle opposite to `opposite` in a triangle with sides b and c, in degrees, by the
/// half-angle formula: accurate also if it is small or close to straight.
fn angle_between(b: f64, c: f64, opposite: f64) -> f64 {
    let (near, far) = (
        (opposite - (b - c).abs()) * (opposite + (b - c).abs()),
        (b + c - opposite) * (b + c + opposite),
    );
    2.0 * near.max(0.0).sqrt().atan2(far.max(0.0).sqrt()).to_degrees()
}

fn four_bar([a, b, c, d]: [f64; 4], tilt: f64, start: f64, near: Vec2) -> (Mechanism, [LinkId; 2]) {
    let mut m = Mechanism::builder();
    let far = unit(tilt) * d;
    let (pivot, frame) = (m.ground_point(0.0, 0.0), m.ground_point(far.x, far.y));
    let (pin, joint) = (m.moving_point(), m.moving_point());
    let crank = m.link(pivot, pin, a);
    let (coupler, follower) = (m.link(pin, joint, b), m.link(frame, joint, c));
    m.driver(Driver {
        input: Input::Turn(crank),
        start,
        speed: 1.0,
        acceleration: 0.0,
    });
    m.start(joint, near);
    (m.build().unwrap(), [coupler, follower])
}

/// Returns the inner joint of a four-bar, on one side; `None` close to a toggle.
fn joint([a, b, c, d]: [f64; 4], tilt: f64, start: f64, side: f64) -> Option<Vec2> {
    let (pin, far) = (unit(start) * a, unit(tilt) * d);
    let u = far - pin;
    let along = 0.5 * (u.norm2() + b * b - c * c) / u.norm();
    let across = (b * b - along * along).sqrt() * side;
    let n = u / u.norm();
    (across.abs() > 1e-3).then(|| pin + n * along + n.perp() * across)
}

fn only(found: &[Transmission]) -> Transmission {
    match found {
        &[one] => one,
        _ => panic!("{found:?}"),
    }
}

/// Returns the angle between two links in a state, in degrees.
fn between(solver: &Solver, at: f64, [coupler, follower]: [LinkId; 2]) -> f64 {
    let mut state = solver.state();
    assert_ne!(
        solver.solve(at, Order::Position, &mut state),
        Condition::NoAssembly
    );
    let (e, f) = (
        state.direction(coupler).unwrap(),
        state.direction(follower).unwrap(),
    );
    e.cross(f).abs().atan2(e.dot(f)).to_degrees()
}

proptest! {
    /// If the crank turns fully, the extremes are where crank and frame are in line.
    #[test]
    fn crank_rocker_extremes_are_in_line_with_its_frame(
        lengths in [length(), length(), length(), length()],
        tilt in angle(),
        start in angle(),
        side in sign(),
    ) {
        let [a, b, c, d] = lengths;
        let Some(near) = joint(lengths, tilt, start, side) else { return Ok(()) };
        let (mechanism, links) = four_bar(lengths, tilt, start, near);
        let Ok(solver) = Solver::new(&mechanism) else { return Ok(()) };
        let found = only(&solver.transmission());
        let Range::Full { .. } = solver.motion().range else {
            // Between two dead points, mu goes from 0 or 180 degrees to the same or the other
            // value.
            let Range::Limited { low, high } = solver.motion().range else { unreachable!() };
            prop_assert!(found.deviation() > 89.999_9, "{found:?}");
            prop_assert!((low..=high).contains(&found.smallest.at));
            return Ok(());
        };
        let smallest = angle_between(b, c, (d - a).abs());
        let largest = angle_between(b, c, d + a);
        // The uncertainty of an angle is that of the lengths divided by its sine.
        let slack = |mu: f64| 1e-13 * (a + b + c + d) / b.min(c) / mu.to_radians().sin().max(1e-6);
        prop_assert!((found.smallest.angle - smallest).abs() <= slack(smallest).to_degrees(), "{found:?} {smallest}");
        prop_assert!((found.largest.angle - largest).abs() <= slack(largest).to_degrees(), "{found:?} {largest}");
        // The states at the extremes have these angles; mu is flat there, so that positions are
        // checked by their angles.
        for extreme in [found.smallest, found.largest] {
            prop_assert!((0.0..360.0).contains(&extreme.at));
            let there = between(&solver, extreme.at, links);
            prop_assert!((there - extreme.angle).abs() <= 1e-12 + slack(there).to_degrees(), "{there} {extreme:?}");
        }
        let off = |at: f64, to: f64| ((at - to + 180.0).rem_euclid(360.0) - 180.0).abs();
        // The distance of the pivots has the curvature a d / |d -+ a| at its extremes.
        let blur = 1e-11 * (a + b + c + d).powi(2) / (a * d);
        prop_assert!(off(found.smallest.at, tilt) <= blur, "{found:?} {tilt}");
        prop_assert!(off(found.largest.at, tilt + 180.0) <= blur, "{found:?} {tilt}");
    }

    /// sin(90 deg - mu) = (crank + offset) / rod, where the pin is farthest from the guide.
    #[test]
    fn slider_crank_minimum_is_where_its_pin_is_farthest_from_guide(
        crank in length(),
        offset in length(),
        more in 1.01..20.0_f64,
        tilt in angle(),
        above in sign(),
    ) {
        let rod = (crank + offset) * more;
        let mut m = Mechanism::builder();
        let (pivot, pin, slider) = (m.ground_point(0.0, 0.0), m.moving_point(), m.moving_point());
        let driven = m.link(pivot, pin, crank);
        m.link(pin, slider, rod);
        let through = unit(tilt).perp() * (offset * above);
        m.pin_in_slot(slider, Body::Ground, through, tilt);
        m.driver(Driver { input: Input::Turn(driven), start: tilt + 17.0, speed: 1.0, acceleration: 0.0 });
        m.start(slider, through + unit(tilt) * (crank + rod));
        let solver = Solver::new(&m.build().unwrap()).unwrap();
        let found = only(&solver.transmission());
        let expected = ((crank + offset) / rod).acos().to_degrees();
        prop_assert!((found.smallest.angle - expected).abs() < 1e-10 / (1.0 - 1.0 / more).sqrt(), "{found:?} {expected}");
        // With the pin on the guide's line, the rod lies along the guide.
        let largest = if offset <= crank { 90.0 } else { ((offset - crank) / rod).acos().to_degrees() };
        prop_assert!((found.largest.angle - largest).abs() < 1e-10, "{found:?} {largest}");
    }

    /// There is no formula for the second dyad: no state has an angle outside the two extremes.
    #[test]
    fn six_bar_states_stay_within_extremes(
        arms in [0.8..6.0_f64, 0.8..6.0_f64],
        far in [4.0..9.0_f64, -2.0..3.0_f64],
        side in sign(),
    ) {
        let mut m = Mechanism::builder();
        let (a, d, g) = (m.ground_point(0.0, 0.0), m.ground_point(4.0, 0.0), m.ground_point(far[0], far[1]));
        let [b, c, e] = [(); 3].map(|()| m.moving_point());
        let crank = m.link(a, b, 1.0);
        m.link(b, c, 3.0);
        m.link(d, c, 2.5);
        let links = [m.link(c, e, arms[0]), m.link(g, e, arms[1])];
        m.driver(Driver { input: Input::Turn(crank), start: 60.0, speed: 1.0, acceleration: 0.0 });
        m.start(c, Vec2::new(3.1, 2.3));
        let (from, to) = (Vec2::new(3.1, 2.3), Vec2::new(far[0], far[1]));
        m.start(e, (from + to) * 0.5 + (to - from).perp() * side);
        let Ok(solver) = Solver::new(&m.build().unwrap()) else { return Ok(()) };
        let found = solver.transmission();
        prop_assert_eq!(found.len(), 2);
        let (low, high) = match solver.motion().range {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        };
        for k in 0..=2000 {
            let at = low + (high - low) * f64::from(k) / 2000.0;
            let mu = between(&solver, at.min(high), links);
            // Near a limit, the error is the square root of the rounding error.
            prop_assert!(mu > found[1].smallest.angle - 1e-5, "{mu} {:?}", found[1]);
            prop_assert!(mu < found[1].largest.angle + 1e-5, "{mu} {:?}", found[1]);
        }
    }
}
