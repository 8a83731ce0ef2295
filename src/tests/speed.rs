//! Tests states at another driver speed.

use crate::quantity::Catalogue;
use crate::scene::{Scene, presets};
use crate::solver::{Order, Solver};
use crate::{DriverMoment, Input};

/// Compares all values with a solver at that speed, including forces and error bounds.
#[test]
fn driven_state_matches_solver_at_that_speed() {
    for name in ["four-bar", "excavator-boom", "press-ram", "press"] {
        let scene = Scene::parse(presets::find(name).unwrap().text, name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let (speed, acceleration) = (0.75, -3.0);
        let is_rotary = matches!(scene.mechanism.driver().input, Input::Turn(_));
        let scale = if is_rotary { 1.0_f64.to_degrees() } else { 1.0 };
        let at = scene.mechanism.driver().start + 0.125;
        let moment = DriverMoment {
            at,
            speed: speed * scale,
            acceleration: acceleration * scale,
            off: [0.0; 3],
        };
        let other = solver.at_speed(moment.speed / scale, moment.acceleration / scale);
        let (mut one, mut two) = (solver.state(), other.state());
        let (mut ball, mut plain) = (solver.enclosure(), other.enclosure());
        solver.drive(&mut one, &moment);
        solver.drive(&mut ball, &moment);
        let _ = solver.solve(at, Order::Force, &mut one);
        let _ = other.solve(at, Order::Force, &mut two);
        solver.enclose(&mut one, Order::Force, &mut ball);
        other.enclose(&mut two, Order::Force, &mut plain);
        for point in scene.mechanism.point_ids() {
            let [driven, intended] = [&ball, &plain].map(|ball| ball.acceleration(point));
            assert_eq!(driven.is_some(), intended.is_some(), "{name}");
            for (driven, intended) in driven.into_iter().zip(intended) {
                let distance = (driven.nearest() - intended.nearest()).norm();
                assert!(
                    distance <= 1e-11 * intended.nearest().norm(),
                    "{name} {distance}"
                );
            }
        }
        for quantity in Catalogue::new(&scene).all() {
            let [one, two] = [&one, &two].map(|state| quantity.value(state));
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (a.abs() + b.abs());
            let agree = one.zip(two).map_or(one == two, |(a, b)| near(a, b));
            assert!(agree, "{name} {}: {one:?} {two:?}", quantity.name);
        }
    }
}

#[test]
fn solver_at_speed_matches_scene_with_that_speed() {
    for (name, given, other) in [
        ("four-bar", "15 rad/s", "-2.5 rad/s"),
        ("excavator-boom", "0.15 m/s", "-0.4 m/s"),
        ("press-ram", "10 rad/s", "1 rad/s"),
    ] {
        let preset = presets::find(name).unwrap();
        let opened = |text: &str| {
            let scene = Scene::parse(text, name).unwrap();
            Solver::new(&scene.mechanism).unwrap()
        };
        let text = preset.text.replace(given, other);
        assert_ne!(text, preset.text, "{name} has another speed now");
        let speed: f64 = other.split(' ').next().unwrap().parse().unwrap();
        let paced = opened(preset.text).at_speed(speed, 0.0);
        let complete = opened(&text);
        let scene = Scene::parse(&text, name).unwrap();
        let at = scene.mechanism.driver().start + 0.125;
        let (mut one, mut two) = (paced.state(), complete.state());
        let _ = paced.solve(at, Order::Acceleration, &mut one);
        let _ = complete.solve(at, Order::Acceleration, &mut two);
        for point in scene.mechanism.point_ids() {
            assert_eq!(
                one.velocity(point).unwrap(),
                two.velocity(point).unwrap(),
                "{name}"
            );
            assert_eq!(
                one.acceleration(point).unwrap(),
                two.acceleration(point).unwrap(),
                "{name}"
            );
        }
    }
}
