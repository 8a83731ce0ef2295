//! Tests scenes of several inputs, of which one moves while the others are held.

use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Range, Solver, State};
use krank::{Load, PointId, Vec2};

fn preset(name: &str) -> Scene {
    let preset = presets::find(name).unwrap();
    Scene::parse(preset.text, preset.name).unwrap()
}

fn solver(scene: &Scene) -> Solver {
    Solver::new(&scene.mechanism).unwrap()
}

/// Returns the scene with another input as its driver.
fn led(scene: &Scene, input: &str, at: f64) -> Scene {
    let input = scene.input_named(input).unwrap();
    scene.led_by(&solver(scene), input, at).unwrap()
}

fn point(scene: &Scene, name: &str) -> PointId {
    let mut points = scene.mechanism.point_ids();
    let found = points.find(|&point| scene.point_name(point) == Some(name));
    found.unwrap()
}

fn solved(scene: &Scene, at: f64) -> State {
    let solver = solver(scene);
    let mut state = solver.state();
    assert_eq!(
        solver.solve(at, Order::Acceleration, &mut state),
        Condition::Ok
    );
    state.into_state()
}

#[track_caller]
fn assert_near(found: Vec2, x: f64, y: f64) {
    let expected = Vec2::new(x, y);
    assert!(
        (found - expected).norm() < 1e-12,
        "{found:?}, not {expected:?}"
    );
}

/// P is the upper intersection of two circles of 140 about the elbows, computed with complex
/// numbers.
#[test]
fn each_motor_of_five_bar_moves_alone() {
    let scene = preset("five-bar");
    let p = point(&scene, "P");
    let at = |scene: &Scene, at: f64| solved(scene, at).position(p).unwrap();
    assert_near(at(&scene, 120.0), 0.0, 173.205_080_756_888);
    let second = led(&scene, "r5", 120.0);
    assert_eq!(second.mechanism.driver().start, 60.0);
    assert_near(at(&second, 60.0), 0.0, 173.205_080_756_888);
    assert_near(
        at(&second, 45.0),
        15.037_466_530_647_28,
        149.575_804_257_627_3,
    );
    assert_near(
        at(&second, 90.0),
        -33.723_943_111_887_96,
        203.999_146_571_304_07,
    );
    // Back to the first motor, with the second one at 90 deg.
    let first = led(&second, "r2", 90.0);
    assert_near(at(&first, 90.0), 0.0, 226.491_106_406_735);
    assert_eq!(first.text(), scene.text());
}

/// A line leads the five-bar: P moves up the y axis, and both motors follow. The rod BP keeps its
/// length, so that its ends have equal speeds along it: (P - B) x y' = (P - B) . (B - A) turned by 90
/// degrees x omega. At the edge of the workspace the arms are straight.
#[test]
fn line_leads_both_motors() {
    let text = presets::find("five-bar").unwrap().text;
    let [before, rest] = text
        .split("[driver]")
        .collect::<Vec<_>>()
        .try_into()
        .unwrap();
    let (_, links) = rest.split_once("[links]").unwrap();
    let line = "[driver]\nslide = \"path\"\nposition = 173\nspeed = \"50 mm/s\"\n\
        [slides]\npath = { point = \"P\", on = \"ground\", through = [0, 0], angle = 90 }\n[links]";
    let text =
        format!("{before}{line}{links}").replace("P = [0, 173]", "B = [-110, 87]\nD = [110, 87]");
    let scene = Scene::parse(&text, "line").unwrap();
    let mut links = scene.mechanism.link_ids();
    let crank = links.find(|&id| scene.link_name(id) == "r2").unwrap();
    let base = Vec2::new(-60.0, 0.0);
    for (y, angle) in [
        (173.205_080_756_888, 120.0_f64),
        (226.491_106_406_735, 90.0),
    ] {
        let state = solved(&scene, y);
        let direction = state.direction(crank).unwrap();
        assert_near(
            direction,
            angle.to_radians().cos(),
            angle.to_radians().sin(),
        );
        let [b, p] = ["B", "P"].map(|name| state.position(point(&scene, name)).unwrap());
        let expected = (p - b).y * 50.0 / (p - b).dot((b - base).perp());
        let found = state.omega(crank).unwrap();
        assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
    }
    let Range::Limited { low, high } = solver(&scene).motion().range else {
        panic!("it turns fully");
    };
    let edge = (240.0_f64.powi(2) - 60.0_f64.powi(2)).sqrt();
    assert!(
        (high - edge).abs() < 1e-9 && (low + edge).abs() < 1e-9,
        "{low} to {high}"
    );
}

/// The elbow's angle is relative to the upper arm. Turned at 1 rad/s, the tool moves with the
/// radius from the elbow, and the upper arm rests.
#[test]
fn motor_on_a_link_moves_alone() {
    let scene = preset("robot-arm");
    let [elbow, tool] = ["E", "W"].map(|name| point(&scene, name));
    let moved = led(&scene, "fore", 60.0);
    assert_eq!(moved.mechanism.driver().start, -75.0);
    // 400 at 60 deg, and 300 at 60 - 75 deg.
    let state = solved(&moved, -75.0);
    assert_near(
        state.position(tool).unwrap(),
        489.777_747_886_720_5,
        268.764_447_983_019_24,
    );
    let arm = state.position(tool).unwrap() - state.position(elbow).unwrap();
    assert_near(state.velocity(tool).unwrap(), -arm.y, arm.x);
    assert_near(state.velocity(elbow).unwrap(), 0.0, 0.0);
    // Stretched: 700 at 60 deg.
    let stretched = solved(&moved, 0.0).position(tool).unwrap();
    assert_near(stretched, 350.0, 606.217_782_649_107);
}

/// Limits of slides hold for every input; the range of the driver ends with its motion.
#[test]
fn cylinders_of_excavator_keep_their_strokes() {
    let scene = preset("excavator");
    let range = |scene: &Scene| solver(scene).motion().range;
    let limited = |low, high| Range::Limited { low, high };
    assert_eq!(range(&scene), limited(1.7, 2.7));
    for (rod, low, high) in [("arm-rod", 2.2, 3.2), ("bucket-rod", 1.75, 2.35)] {
        let moved = led(&scene, rod, 2.5);
        assert_eq!(range(&moved), limited(low, high), "{rod}");
        let limits = moved.mechanism.limit_ids();
        let names: Vec<&str> = limits.map(|limit| moved.limit_name(limit)).collect();
        assert_eq!(names, ["arm-rod", "bucket-rod"]);
    }
}

/// The factor rises by 1 over 90 deg: at 45 deg it is a half.
#[test]
fn load_over_the_driver_rests_with_it() {
    let load = "[[loads]]\npoint = \"P\"\nforce = [0, -90]\nover = [[0, 0], [90, 1], [360, 0]]\n";
    let text = format!("{}{load}", presets::find("five-bar").unwrap().text);
    let scene = Scene::parse(&text, "five-bar").unwrap();
    let moved = led(&scene, "r5", 45.0);
    let expected = Load::force(point(&scene, "P"), Vec2::new(0.0, -45.0));
    assert_eq!(moved.mechanism.loads(), [expected]);
}

#[test]
fn unknown_inputs_and_unreachable_places_are_refused() {
    let scene = preset("five-bar");
    let message = "the scene has no input `r3`; its inputs: r2, r5";
    let found = scene.input_named("r3").unwrap_err();
    assert!(found.starts_with(message), "{found}");
    let r5 = scene.input_named("r5").unwrap();
    // Beyond 173.99 deg the rods do not reach.
    assert!(scene.led_by(&solver(&scene), r5, 175.0).is_none());
}
