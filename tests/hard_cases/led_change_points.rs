//! Change points of parallelograms driven by elements other than their own crank.

use crate::rig::point;
use krank::Vec2;
use krank::scene::Scene;
use krank::solver::{Condition, Order, Range, Solver};

const PUSHED_PIN: &str = include_str!("scenes/pushed_pin.toml");
const PUSHED_CRANK: &str = include_str!("scenes/pushed_crank.toml");
const FOURBAR_CUT: &str = include_str!("scenes/fourbar_cut.toml");
const FOURBAR_TURNED: &str = include_str!("scenes/fourbar_turned.toml");

/// Number of steps over the range, or the period.
const STEPS: u32 = 2000;

fn open(text: &str) -> (Scene, Solver) {
    let scene = Scene::parse(text, "parallelogram").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

/// Asserts that C keeps a constant offset from B over the whole motion.
fn assert_translates(scene: &Scene, solver: &Solver, shift: Vec2) {
    let [b, c] = ["B", "C"].map(|name| point(scene, name));
    let (low, high) = solver.motion().range.ends();
    let mut work = solver.state();
    for k in 1..STEPS {
        let at = low + (high - low) * f64::from(k) / f64::from(STEPS);
        let condition = solver.solve(at, Order::Position, &mut work);
        assert!(
            matches!(condition, Condition::Ok | Condition::ChangePoint),
            "{condition:?} at {at}"
        );
        let [b, c] = [b, c].map(|p| work.state().position(p).unwrap());
        let off = (c - b - shift).norm();
        assert!(off < 1e-8, "at {at} C is off by {off:e}");
    }
}

/// Asserts the ends of the range and the change points, each within 1e-9 of a degree or of a
/// length.
fn assert_places(solver: &Solver, ends: Option<[f64; 2]>, changes: &[f64]) {
    let motion = solver.motion();
    let near = |found: f64, expected: f64| {
        assert!((found - expected).abs() < 1e-9, "{found} is not {expected}");
    };
    match (motion.range, ends) {
        (Range::Limited { low, high }, Some(expected)) => {
            near(low, expected[0]);
            near(high, expected[1]);
        }
        (range, None) => assert_eq!(range, Range::Full { period: 360.0 }),
        (range, Some(_)) => panic!("{range:?}"),
    }
    assert_eq!(motion.change_points.len(), changes.len());
    for (&found, &expected) in motion.change_points.iter().zip(changes) {
        near(found, expected);
    }
    assert!(motion.lined_up.is_empty());
}

/// The parallelogram used to change its assembly 0.33 mm before the end of the cylinder, without
/// notice.
#[test]
fn cylinder_pushes_parallelogram_through_change_point_near_end() {
    let (scene, solver) = open(PUSHED_PIN);
    let reach = 200.0_f64.hypot(20.0);
    let change = 300.0_f64.hypot(20.0);
    assert_places(&solver, Some([reach - 100.0, reach + 100.0]), &[change]);
    assert_translates(&scene, &solver, Vec2::new(300.0, 0.0));
}

#[test]
fn ground_cylinder_pushes_parallelogram_through_change_point() {
    let (scene, solver) = open(PUSHED_CRANK);
    let arm = 60.0_f64.hypot(10.0);
    assert_places(&solver, Some([100.0 - arm, 100.0 + arm]), &[90.0]);
    assert_translates(&scene, &solver, Vec2::new(300.0, 0.0));
}

/// The orientation of the frame used to decide whether the motion passed: with the frame along an
/// axis it ended.
#[test]
fn four_bar_turns_parallelogram_through_change_points() {
    let turn = 0.8_f64.atan2(0.6).to_degrees();
    let changes = [9.594_068_226_860_5, 170.405_931_773_139_5];
    let (scene, solver) = open(FOURBAR_CUT);
    assert_places(&solver, None, &changes);
    assert_translates(&scene, &solver, Vec2::new(300.0, 0.0));
    let (scene, solver) = open(FOURBAR_TURNED);
    assert_places(&solver, None, &changes.map(|at| at + turn));
    assert_translates(&scene, &solver, Vec2::new(180.0, 240.0));
}

const SHORT_RANGE: &str = include_str!("scenes/short_range.toml");

/// A coupled group with a range of 2e-6 cm used to lose the states from which it is solved: opening
/// failed with no assembly, unless an end of the range was solved before.
#[test]
fn coupled_group_with_tiny_range_is_solved_without_history() {
    let (scene, solver) = open(SHORT_RANGE);
    let (low, high) = solver.motion().range.ends();
    let start = scene.mechanism.driver().start;
    assert!(low < start && start < high, "{start}: {low} to {high}");
    let link = scene.mechanism.link_ids().last().unwrap();
    let mut work = solver.state();
    let _ = solver.solve(low, Order::Position, &mut work);
    let inside = (1..50).map(|k| low + (high - low) * f64::from(k) / 50.0);
    for at in inside.chain([start]) {
        let mut fresh = solver.state();
        assert_eq!(
            solver.solve(at, Order::Position, &mut fresh),
            Condition::Ok,
            "{at}"
        );
        assert_eq!(
            solver.solve(at, Order::Position, &mut work),
            Condition::Ok,
            "{at}"
        );
        assert_eq!(
            fresh.state().direction(link),
            work.state().direction(link),
            "{at}"
        );
    }
}
