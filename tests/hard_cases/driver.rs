//! The driver's angle and rates: after many turns, at right angles, from rest, and in any order.

use crate::bits::bits;
use crate::rig::{FourBar, LECTURE, U, assert_near, exact, solved};
use krank::solver::{Condition, Order, Range, Solver};
use krank::{Body, Driver, Input, Mechanism, Vec2};
use std::f64::consts::TAU;

#[test]
fn h11_a_billion_turns_on_the_bits_are_the_same() {
    let opened = LECTURE.open();
    for degrees in [60.0, 0.0, 90.0, 271.0] {
        let now = bits(&opened.mechanism, &opened.at(degrees), 1.0);
        for turns in [1e9, -1e9, 1.0] {
            let later = opened.at(360.0 * turns + degrees);
            assert_eq!(
                now,
                bits(&opened.mechanism, &later, 1.0),
                "{degrees} and {turns} turns"
            );
        }
    }
    let later = opened.at(360e9 + 60.0);
    let slack = opened.position_slack(&later);
    let c = later.position(opened.joint).unwrap();
    assert_near("C.x", c.x, "311.416953239068390194", slack);
    assert_near("C.y", c.y, "233.7799046679389075852", slack);
}

#[test]
fn h15_slider_crank_at_right_angle_has_exact_zeros() {
    let mut builder = Mechanism::builder();
    let (a, b, c) = (
        builder.ground_point(0.0, 0.0),
        builder.moving_point(),
        builder.moving_point(),
    );
    let crank = builder.link(a, b, 10.0);
    let rod = builder.link(b, c, 20.0);
    let slide = builder.pin_in_slot(c, Body::Ground, Vec2::ZERO, 0.0);
    builder.driver(Driver {
        input: Input::Turn(crank),
        start: 30.0,
        speed: 200.0,
        acceleration: 0.0,
    });
    builder.start(c, Vec2::new(28.0, 0.0));
    let mechanism = builder.build().expect("every element is sound");
    let solver = Solver::new(&mechanism).expect("it closes");
    for turns in [0.0, 1e9] {
        let state = solved(&solver, 90.0 + 360.0 * turns);
        assert_eq!(state.omega(rod).unwrap(), 0.0);
        let off = (state.angle(rod).unwrap() - 330.0).abs();
        assert!(off <= 4.0 * U * 330.0, "theta3 {off:e}");
        let travel = state.travel(slide).unwrap();
        assert_near(
            "r4",
            travel.position,
            "17.32050807568877293527",
            4.0 * U * 20.0,
        );
        assert_eq!(travel.rate, Some(-2000.0));
        assert_near(
            "a4",
            travel.accel.unwrap(),
            "230940.1076758503058037",
            8.0 * U * 230_940.0,
        );
        assert_near(
            "alpha3",
            state.alpha(rod).unwrap(),
            "23094.01076758503058037",
            8.0 * U * 23_094.0,
        );
    }
}

/// A drag link: the rocker turns fully too.
const DRAG: FourBar = FourBar {
    crank: 2.0,
    coupler: 2.5,
    rocker: 2.2,
    ground: 1.0,
    start: 0.0,
    speed: 1.0,
    ..LECTURE
};

#[test]
fn h27_fully_turning_follower_has_angle_from_0_to_360() {
    let opened = DRAG.open();
    assert_eq!(opened.solver.motion().range, Range::Full { period: 360.0 });
    for (at, decimal) in [
        (0.0, "-1.664113521913583860982"),
        (180.0, "2.183400474843519100526"),
    ] {
        let state = opened.at(at);
        let found = state.direction(opened.rocker).unwrap().angle();
        let slack = opened.position_slack(&state) / 2.2 + 2.0 * U;
        assert_near("theta4", found, decimal, slack);
        let shown = state.angle(opened.rocker).unwrap();
        let expected = exact(decimal).hi.rem_euclid(TAU).to_degrees();
        assert!(
            (shown - expected).abs() <= 8.0 * U * 360.0,
            "{shown} {expected}"
        );
    }
    let (first, next) = (opened.at(0.0), opened.at(360.0));
    assert_eq!(
        bits(&opened.mechanism, &first, 1.0),
        bits(&opened.mechanism, &next, 1.0)
    );
}

#[test]
fn h27_follower_rates_are_continuous_across_wrap() {
    let opened = DRAG.open();
    let (mut wraps, mut turned) = (0, 0.0);
    let mut last = opened.at(0.0);
    for degrees in 1..=360 {
        let state = opened.at(f64::from(degrees));
        let angle = state.angle(opened.rocker).unwrap();
        assert!((0.0..360.0).contains(&angle), "{angle}");
        wraps += i32::from(angle < last.angle(opened.rocker).unwrap());
        assert!(state.omega(opened.rocker).unwrap() > 0.0, "at {degrees}");
        // From one degree to the next, alpha explains the change of omega, also at the wrap.
        let mean = 0.5 * (state.alpha(opened.rocker).unwrap() + last.alpha(opened.rocker).unwrap());
        let change = state.omega(opened.rocker).unwrap() - last.omega(opened.rocker).unwrap();
        assert!((change - mean.to_radians()).abs() < 1e-4, "at {degrees}");
        turned += 0.5 * (state.omega(opened.rocker).unwrap() + last.omega(opened.rocker).unwrap());
        last = state;
    }
    assert_eq!(wraps, 1);
    assert!((turned - 360.0).abs() < 0.01, "{turned}");
}

#[test]
fn h28_accelerated_driver_from_rest_has_exact_accelerations() {
    let rows = [
        (15.0, "16.15760013278989017911", "116.1107631879278492783"),
        (0.0, "-26.10941820109625687257", "20.60715479680644348711"),
    ];
    for (speed, alpha3, alpha4) in rows {
        let accelerated = FourBar {
            speed,
            acceleration: 100.0,
            ..LECTURE
        };
        let opened = accelerated.open();
        let state = opened.at(60.0);
        for (link, alpha) in [(opened.coupler, alpha3), (opened.rocker, alpha4)] {
            let slack = opened.alpha_slack(&state, exact(alpha).hi);
            assert_near("alpha", state.alpha(link).unwrap(), alpha, slack);
            if speed == 0.0 {
                assert_eq!(state.omega(link).unwrap(), 0.0);
            }
        }
    }
}

#[test]
fn h29_state_does_not_depend_on_history() {
    let opened = LECTURE.open();
    let fresh = |at: f64| bits(&opened.mechanism, &opened.at(at), 1.0);
    let up = (0..=359).map(f64::from);
    let down = (0..=359).rev().map(f64::from);
    let ways: [Vec<f64>; 3] = [
        vec![60.0, 240.0],
        up.chain(down).collect(),
        vec![59.0, 61.0, 59.0],
    ];
    for way in ways {
        let mut state = opened.solver.state();
        for at in way {
            let _ = opened.solver.solve(at, Order::Acceleration, &mut state);
            assert_eq!(bits(&opened.mechanism, &state, 1.0), fresh(at), "at {at}");
        }
    }
}

#[test]
fn h29_step_of_half_turn_keeps_branch() {
    for (side, x, y) in [
        (1.0, "175.8975078189799874691", "110.8064664099341458066"),
        (-1.0, "233.0310636095914411023", "-186.0681979292960758229"),
    ] {
        let opened = FourBar { side, ..LECTURE }.open();
        let mut state = opened.solver.state();
        for at in [60.0, 240.0] {
            let condition = opened.solver.solve(at, Order::Acceleration, &mut state);
            assert_eq!(condition, Condition::Ok, "at {at}");
        }
        let slack = opened.position_slack(&state);
        let c = state.position(opened.joint).unwrap();
        assert_near("C.x", c.x, x, slack);
        assert_near("C.y", c.y, y, slack);
    }
}
