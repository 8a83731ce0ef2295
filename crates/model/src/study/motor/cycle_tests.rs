//! Tests cycles of functions with known integrals.

use super::*;
use crate::solver::Range;
use crate::study::motor::{fluctuation_with, flywheel_for};
use std::f64::consts::{PI, TAU};

const TURN: Range = Range::Full { period: 360.0 };
/// One degree of a turn, in J for 1 N m.
const DEGREE: f64 = PI / 180.0;

fn degrees(speed: f64) -> DriverUnits {
    DriverUnits {
        joule: DEGREE,
        speed,
        ..DriverUnits::default()
    }
}

fn torque(torque: f64) -> Option<Effort> {
    let parts = [torque, 0.0, 0.0];
    Some(Effort {
        torque,
        parts,
        ..Effort::default()
    })
}

fn round(marks: &[f64], f: impl Fn(f64) -> f64) -> Cycle {
    let course = CyclePath::new(TURN, 1, false, &[]);
    Cycle::new(course, marks, degrees(2.0), &mut |at, _| torque(f(at)))
}

fn near(value: f64, exact: f64) {
    let error = (value - exact).abs() / exact.abs().max(1.0);
    assert!(error < 1e-12, "{value} for {exact}: {error:e}");
}

#[test]
fn cosine_torque_matches_textbook_formulas() {
    let shift = 20.0;
    let cycle = round(&[], |at| 3.0 + 5.0 * ((at - shift) * DEGREE).cos());
    let all = cycle.all;
    near(all.mean.unwrap(), 3.0);
    near(all.rms.unwrap(), (9.0_f64 + 12.5).sqrt());
    // The torque is positive until cos u = -3/5.
    let u = (-0.6_f64).acos();
    near(all.supplied.unwrap(), 2.0 * (3.0 * u + 5.0 * u.sin()));
    near(
        all.returned.unwrap(),
        2.0 * (3.0 * u + 5.0 * u.sin()) - 6.0 * PI,
    );
    let (maximum, minimum) = (all.largest.unwrap(), all.least.unwrap());
    near(maximum.value, 8.0);
    near(minimum.value, -2.0);
    assert!((maximum.at - shift).abs() < 1e-9 && (minimum.at - shift - 180.0).abs() < 1e-9);
    near(all.largest_power.unwrap().value, 16.0);
    let fluctuation = cycle.fluctuation.unwrap();
    near(fluctuation.energy, 10.0);
    assert!((fluctuation.slowest - 90.0 - shift).abs() < 1e-9);
    assert!((fluctuation.fastest - 270.0 - shift).abs() < 1e-9);
    assert!(matches!(cycle.rule, Rule::Periodic(64)), "{:?}", cycle.rule);
    assert!(cycle.error < 1e-14 && cycle.has_converged());
}

#[test]
fn backward_driver_does_work_of_opposite_torque() {
    let course = CyclePath::new(TURN, 1, true, &[]);
    let f = |at: f64| torque(-3.0 + 5.0 * (at * DEGREE).cos());
    let cycle = Cycle::new(course, &[], degrees(-2.0), &mut |at, _| f(at));
    near(cycle.all.mean.unwrap(), -3.0);
    near(cycle.all.largest.unwrap().value, 2.0);
    near(cycle.all.least.unwrap().value, -8.0);
    near(
        cycle.all.supplied.unwrap() - cycle.all.returned.unwrap(),
        6.0 * PI,
    );
    near(cycle.all.largest_power.unwrap().value, 16.0);
    near(cycle.all.least_power.unwrap().value, -4.0);
}

#[test]
fn both_rules_integrate_narrow_peak() {
    // As for a toggle: 1 / (1 + e - cos), with the mean 1 / sqrt((1 + e)^2 - 1).
    let e: f64 = 1e-4;
    let f = |at: f64| 1.0 / (1.0 + e - ((at - 77.0) * DEGREE).cos());
    let exact = 1.0 / ((1.0 + e).powi(2) - 1.0).sqrt();
    let cycle = round(&[], f);
    assert!(matches!(cycle.rule, Rule::Periodic(_)), "{:?}", cycle.rule);
    near(cycle.all.mean.unwrap(), exact);
    near(cycle.all.supplied.unwrap(), TAU * exact);
    near(cycle.all.largest.unwrap().value, 1e4);
    // With a mark anywhere, only the pieces are left.
    let cut = round(&[100.0], f);
    assert!(matches!(cut.rule, Rule::Pieces(_)) && cut.has_converged());
    near(cut.all.mean.unwrap(), exact);
    near(cut.all.rms.unwrap(), cycle.all.rms.unwrap());
}

#[test]
fn integration_splits_at_bends_and_jumps() {
    let bent = round(&[180.0, 0.0], |at| (at * DEGREE).sin().abs());
    near(bent.all.mean.unwrap(), 2.0 / PI);
    near(bent.all.rms.unwrap(), 0.5_f64.sqrt());
    // A ramp up to half a turn, and zero after it.
    let ramp = |at: f64| if at < 180.0 { at / 180.0 } else { 0.0 };
    let jumps = round(&[180.0, 0.0], ramp);
    near(jumps.all.mean.unwrap(), 0.25);
    near(jumps.all.rms.unwrap(), 6.0_f64.sqrt().recip());
    near(jumps.all.largest.unwrap().value, 1.0);
    assert_eq!(jumps.all.largest.unwrap().at, 180.0);
    near(jumps.all.supplied.unwrap(), PI / 2.0);
    // The integral of (x / pi - 1/4) from 0 to pi has its minimum at pi / 4, and grows from there on.
    near(jumps.fluctuation.unwrap().energy, PI * (0.75 * 0.75) / 2.0);
    for cycle in [bent, jumps] {
        assert!(
            cycle.has_converged() && cycle.states < 400,
            "{}",
            cycle.states
        );
    }
}

#[test]
fn unmarked_bend_is_integrated_or_reported() {
    let cycle = round(&[], |at| ((at - 33.3) * DEGREE).sin().abs());
    let error = (cycle.all.mean.unwrap() - 2.0 / PI).abs();
    assert!(
        error <= cycle.error.max(1e-15) && error < 1e-12,
        "{error:e}"
    );
    let wild = round(&[], |at| (at * 1e6).sin());
    assert!(!wild.has_converged(), "{:e}", wild.error);
}

#[test]
fn cycle_there_and_back_returns_spring_work_only() {
    let range = Range::Limited {
        low: 0.0,
        high: 3.0,
    };
    let course = CyclePath::new(range, 1, false, &[]);
    let mut spring = |at: f64, back: bool| torque(2.0 * at - 1.0 + if back { -0.5 } else { 0.5 });
    let cycle = Cycle::new(course, &[], DriverUnits::default(), &mut spring);
    // Forwards 2 q - 1/2: -1/16 up to 1/4 and then 121/16. Backwards 2 q - 3/2: 9/16 and -81/16.
    near(cycle.all.supplied.unwrap(), 121.0 / 16.0 + 9.0 / 16.0);
    near(cycle.all.returned.unwrap(), 1.0 / 16.0 + 81.0 / 16.0);
    near(cycle.all.mean.unwrap(), 2.0);
    let (maximum, minimum) = (cycle.all.largest.unwrap(), cycle.all.least.unwrap());
    near(maximum.value, 5.5);
    near(minimum.value, -1.5);
    assert_eq!(
        (maximum.at, maximum.back, minimum.at, minimum.back),
        (3.0, false, 0.0, true)
    );
    assert!(cycle.fluctuation.is_none());
}

#[test]
fn dead_points_have_work_but_no_peaks() {
    let range = Range::Limited {
        low: -1.0,
        high: 1.0,
    };
    let course = CyclePath::new(range, 1, false, &[-1.0, 1.0]);
    let cycle = Cycle::new(course, &[], DriverUnits::default(), &mut |at, _| {
        torque(1.0 / (1.0 - at * at).sqrt())
    });
    near(cycle.all.supplied.unwrap(), PI);
    near(cycle.all.returned.unwrap(), PI);
    near(cycle.all.mean.unwrap(), PI / 2.0);
    assert_eq!((cycle.all.largest, cycle.all.rms), (None, None));
    assert!(cycle.has_converged());
}

#[test]
fn shaking_force_and_moment_match_closed_formulas() {
    let course = CyclePath::new(TURN, 1, false, &[]);
    let cycle = Cycle::new(course, &[], degrees(1.0), &mut |at, _| {
        let (s, c) = (at * DEGREE).sin_cos();
        Some(Effort {
            force: Vec2::new(3.0 * c + 0.5, 2.0 * s),
            moment: 1.0 - 4.0 * s,
            ..Effort::default()
        })
    });
    let shaking = cycle.shaking;
    near(shaking.force.unwrap().value, 3.5);
    near(shaking.vector.unwrap().x, 3.5);
    near(shaking.force_rms.unwrap(), (4.5_f64 + 0.25 + 2.0).sqrt());
    near(shaking.moment.unwrap().value, 5.0);
    near(shaking.moment.unwrap().at, 270.0);
    near(shaking.moment_rms.unwrap(), 3.0);
}

#[test]
fn cycle_with_missing_states_has_no_results() {
    let course = CyclePath::new(TURN, 1, false, &[]);
    let cycle = Cycle::new(course, &[], degrees(1.0), &mut |at, _| {
        (at < 90.0).then_some(Effort::default())
    });
    assert_eq!(cycle.all, DriveEffort::default());
    assert!(!cycle.has_converged() && cycle.fluctuation.is_none());
}

#[test]
fn flywheel_inertia_gives_requested_fluctuation() {
    let inertia = flywheel_for(10.0, 15.0, 0.02).unwrap();
    near(inertia, 10.0 / (225.0 * 0.02));
    near(fluctuation_with(10.0, 15.0, inertia).unwrap(), 0.02);
    assert_eq!(flywheel_for(10.0, 0.0, 0.02), None);
}

#[test]
fn cycle_can_be_evaluated_anywhere() {
    let f = |at: f64| {
        if at < 180.0 {
            at / 180.0
        } else {
            (at * DEGREE).sin()
        }
    };
    let cycle = round(&[180.0, 0.0], f);
    for k in 0..360 {
        let travel = f64::from(k) + 0.5;
        near(cycle.at(travel).unwrap().torque, f(travel));
    }
}
