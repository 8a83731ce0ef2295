//! Tests cycles of mechanisms against the textbooks' closed formulas, which are written out here.

use super::*;
use crate::scene::{Scene, presets};
use crate::solver::Order;
use crate::study::motor::Rule;
use std::f64::consts::PI;

fn of(text: &str) -> (Scene, Solver) {
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

fn preset(name: &str) -> (Scene, Solver) {
    of(presets::find(name).unwrap().text)
}

fn duty(text: &str) -> Duty {
    let (scene, solver) = of(text);
    Duty::new(&scene.mechanism, &solver, None).unwrap()
}

fn near(value: f64, exact: f64, maximum: f64) {
    let error = (value - exact).abs();
    assert!(error <= maximum, "{value} for {exact}: {error:e}");
}

/// An in-line slider-crank: crank r and rod l in m, w in rad/s; the piston's mass in kg.
const R: f64 = 0.05;
const L: f64 = 0.16;
const W: f64 = 200.0;
const M: f64 = 0.8;

fn slider_crank(rest: &str) -> String {
    format!(
        "unit = \"mm\"
[ground]
A = [0, 0]
[driver]
link = \"r2\"
angle = 60
speed = \"{W} rad/s\"
[links]
r2 = {{ from = \"A\", to = \"B\", length = 50 }}
r3 = {{ from = \"B\", to = \"C\", length = 160 }}
piston = {{ points = {{ C = [0, 0] }}, com = [0, 0], mass = {M} }}
[slides]
r4 = {{ link = \"piston\", on = \"ground\", through = \"A\", angle = 0 }}
[start]
C = [180, 0]
{rest}"
    )
}

/// dx/dtheta and d2x/dtheta2 of x = r cos + sqrt(l^2 - r^2 sin^2).
fn piston(theta: f64) -> [f64; 2] {
    let (s, c) = theta.sin_cos();
    let root = (L * L - R * R * s * s).sqrt();
    let first = -R * s - R * R * s * c / root;
    let second = -R * c - R * R * (c * c - s * s) / root - (R * R * s * c).powi(2) / root.powi(3);
    [first, second]
}

/// Returns the mean over a turn by the midpoint rule, a trapezoidal rule shifted by half a step.
fn mean(f: impl Fn(f64) -> f64) -> f64 {
    let n = 4000;
    let sum: f64 = (0..n)
        .map(|k| f((f64::from(k) + 0.5) * 2.0 * PI / f64::from(n)))
        .sum();
    sum / f64::from(n)
}

#[test]
fn piston_inertia_torque_matches_textbook() {
    let duty = duty(&slider_crank(""));
    // m x' x'' w^2: the crank's torque due to inertia.
    let torque = |theta: f64| {
        let [first, second] = piston(theta);
        M * first * second * W * W
    };
    let cycle = &duty.cycle;
    assert!(matches!(cycle.rule, Rule::Periodic(_)) && cycle.has_converged());
    let size = cycle.all.worst().unwrap().value.abs();
    for k in 0..97 {
        let at = f64::from(k) * 360.0 / 97.0;
        let effort = cycle.at(at).unwrap();
        near(effort.torque, torque(at.to_radians()), 1e-11 * size);
        near(effort.parts[2], effort.torque, 1e-12 * size);
    }
    // Over a whole turn, inertia does no net work.
    near(cycle.all.mean.unwrap(), 0.0, 1e-13 * size);
    near(cycle.all.work().unwrap(), 0.0, 1e-12 * size);
    near(
        cycle.all.rms.unwrap(),
        mean(|t| torque(t).powi(2)).sqrt(),
        1e-11 * size,
    );
    // Twice a turn, the piston's maximum kinetic energy is put in and given back.
    let fastest = (0..720_000).map(|k| piston(f64::from(k) * PI / 360_000.0)[0].abs());
    let fastest = fastest.fold(0.0, f64::max) * W;
    near(
        cycle.all.supplied.unwrap(),
        M * fastest * fastest,
        1e-8 * size,
    );
    near(
        cycle.fluctuation.unwrap().energy,
        0.5 * M * fastest * fastest,
        1e-8 * size,
    );
    // The ground bears the piston's inertia force. It is largest at the outer dead centre: m r w^2 (1 + r / l).
    let shaking = cycle.shaking;
    near(
        shaking.force.unwrap().value,
        M * R * W * W * (1.0 + R / L),
        1e-8,
    );
    near(
        shaking.force.unwrap().at.rem_euclid(360.0).min(1.0),
        0.0,
        1e-6,
    );
    let rms = mean(|t| (M * piston(t)[1] * W * W).powi(2)).sqrt();
    near(shaking.force_rms.unwrap(), rms, 1e-8);
}

#[test]
fn four_stroke_gas_load_has_a_cycle_of_two_turns() {
    let gas = "[[loads]]
point = \"C\"
force = [-1000, 0]
over = [[0, 4], [180, 0.5], [540, 0.1], [720, 4]]
";
    let duty = duty(&slider_crank(gas));
    let cycle = &duty.cycle;
    assert_eq!((duty.turns(), cycle.course.length()), (2.0, 720.0));
    let force = |at: f64| -> f64 {
        let at = at.rem_euclid(720.0);
        1000.0
            * if at < 180.0 {
                4.0 - 3.5 * at / 180.0
            } else if at < 540.0 {
                0.5 - 0.4 * (at - 180.0) / 360.0
            } else {
                0.1 + 3.9 * (at - 540.0) / 180.0
            }
    };
    // The gas pushes with -F along x: the crank must hold F x'.
    let torque = |at: f64| force(at) * piston(at.to_radians())[0];
    let size = 200.0;
    for k in 0..101 {
        let at = f64::from(k) * 720.0 / 101.0;
        near(cycle.at(at).unwrap().parts[0], torque(at), 1e-11 * size);
    }
    // The work of a force on a piston, by Gauss's rule with four points on 2000 pieces between the knots.
    let work: f64 = [[0.0, 180.0], [180.0, 540.0], [540.0, 720.0]]
        .iter()
        .map(|[from, to]| {
            let n = 2000;
            let h = (to - from) / f64::from(n);
            let places = [
                (0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
                (0.861_136_311_594_052_6, 0.347_854_845_137_453_9),
            ];
            let piece = |k: i32| {
                let middle = from + (f64::from(k) + 0.5) * h;
                let both = |(t, w): (f64, f64)| {
                    w * (torque(middle - 0.5 * h * t) + torque(middle + 0.5 * h * t))
                };
                0.5 * h * places.into_iter().map(both).sum::<f64>()
            };
            (0..n).map(piece).sum::<f64>()
        })
        .sum::<f64>()
        .to_radians();
    near(cycle.parts[0].work().unwrap(), work, 1e-9);
    near(cycle.all.mean.unwrap() * 4.0 * PI, work, 1e-9);
    near(cycle.all.work().unwrap(), work, 1e-9);
    assert!(matches!(cycle.rule, Rule::Pieces(_)) && cycle.has_converged());
    assert!(work < 0.0, "an engine gives");
}

#[test]
fn gravity_and_inertia_do_no_net_work_per_cycle() {
    for name in ["four-bar-load", "engine", "press-ram", "toggle-press"] {
        let (scene, solver) = preset(name);
        let duty = Duty::new(&scene.mechanism, &solver, None).unwrap();
        let cycle = &duty.cycle;
        assert!(cycle.has_converged(), "{name}: {:e}", cycle.error);
        let [load, gravity, inertia] = cycle.parts;
        let size = cycle.all.supplied.unwrap() + inertia.supplied.unwrap();
        near(gravity.work().unwrap(), 0.0, 1e-12 * size);
        near(inertia.work().unwrap(), 0.0, 1e-11 * size);
        let [all, load] = [cycle.all, load].map(|effect| effect.work().unwrap());
        near(all, load, 1e-11 * size);
        let angle = cycle.course.length().to_radians();
        near(cycle.all.mean.unwrap() * angle, all, 1e-11 * size);
    }
}

#[test]
fn peaks_match_dense_solver_samples() {
    for name in ["four-bar-load", "engine", "press-ram", "toggle-press"] {
        let (scene, solver) = preset(name);
        let duty = Duty::new(&scene.mechanism, &solver, None).unwrap();
        let mut state = solver.state();
        let mut torque = |at: f64| {
            let _ = solver.solve(at, Order::Force, &mut state);
            state.drive().unwrap()
        };
        let all = duty.cycle.all;
        let length = duty.cycle.course.length();
        let samples: Vec<f64> = (0..7200)
            .map(|k| torque(length * f64::from(k) / 7200.0))
            .collect();
        let maximum = samples.iter().fold(f64::MIN, |a, &b| a.max(b));
        let minimum = samples.iter().fold(f64::MAX, |a, &b| a.min(b));
        let size = maximum.max(-minimum);
        let (largest, lowest) = (all.largest.unwrap(), all.least.unwrap());
        assert!(
            largest.value >= maximum - 1e-11 * size && largest.value - maximum < 3e-2 * size,
            "{name}"
        );
        assert!(
            lowest.value <= minimum + 1e-11 * size && minimum - lowest.value < 3e-2 * size,
            "{name}"
        );
        // The torque jumps where a press begins or ends: only one side has the value.
        let sides = [-1e-7, 0.0, 1e-7].map(|by| (torque(largest.at + by) - largest.value).abs());
        let nearest = sides.into_iter().fold(f64::MAX, f64::min);
        assert!(nearest < 1e-6 * size, "{name} {nearest:e} of {size}");
    }
}

#[test]
fn results_do_not_depend_on_length_unit() {
    let (scene, solver) = preset("four-bar-load");
    let one = Duty::new(&scene.mechanism, &solver, None)
        .unwrap()
        .cycle
        .all;
    let text = presets::find("four-bar-load").unwrap().text;
    let mut metres = text.replace("\"mm\"", "\"m\"");
    for (mm, m) in [
        ("[400, 0]", "[0.4, 0]"),
        ("length = 100", "length = 0.1"),
        (
            "length = 300, com = [150, 0]",
            "length = 0.3, com = [0.15, 0]",
        ),
        (
            "length = 250, com = [125, 0]",
            "length = 0.25, com = [0.125, 0]",
        ),
        ("E = [50, 0]", "E = [0.05, 0]"),
        ("[310, 230]", "[0.31, 0.23]"),
    ] {
        assert!(metres.contains(mm), "{mm}");
        metres = metres.replace(mm, m);
    }
    let two = duty(&metres).cycle.all;
    near(one.rms.unwrap(), two.rms.unwrap(), 1e-12);
    near(one.supplied.unwrap(), two.supplied.unwrap(), 1e-12);
    near(
        one.largest.unwrap().value,
        two.largest.unwrap().value,
        1e-12,
    );
    near(one.largest.unwrap().at, two.largest.unwrap().at, 1e-8);
}

#[test]
fn excavator_boom_duty_handles_dead_points() {
    let (scene, solver) = preset("excavator-boom");
    let duty = Duty::new(&scene.mechanism, &solver, None).unwrap();
    let cycle = &duty.cycle;
    assert_eq!(duty.dead_points.len(), 2);
    // Accelerations are unbounded there: only load and gravity have results, the whole has none.
    assert!(duty.reaches_dead_point && cycle.all == DriveEffort::default());
    let [load, gravity, inertia] = cycle.parts;
    assert_eq!(inertia, DriveEffort::default());
    assert_eq!((load.largest, load.rms), (None, None));
    for part in [load, gravity] {
        near(part.work().unwrap(), 0.0, 1e-9 * part.supplied.unwrap());
    }
    // Every state has all parts, including inertia, except at the dead points.
    let steps: Vec<Step> = duty.steps(100).map(|(_, step)| step).collect();
    for (k, step) in steps.iter().enumerate() {
        let is_dead = k % 50 == 0;
        assert_eq!(
            step.torque.is_none() && step.ground.is_none(),
            is_dead,
            "{step:?}"
        );
        if let Some(parts) = step.parts.filter(|_| !is_dead) {
            assert!(parts[2].abs() > 1.0, "{step:?}");
            near(
                parts.iter().sum(),
                step.torque.unwrap(),
                1e-9 * step.torque.unwrap().abs(),
            );
        }
    }
    let motor = Motor {
        rated: Some(10.0),
        speed: Some(1.0),
        ..Motor::default()
    };
    assert_eq!(duty.fit(&motor).is_enough(), None);
    assert!(duty.fit(&motor).is_unbounded);
    let ends = Duty::new(&scene.mechanism, &solver, Some((1.8, 2.8))).unwrap();
    let ends: Vec<f64> = ends.steps(4).map(|(_, step)| step.at).collect();
    assert_eq!([ends[0], ends[2], ends[4]], [1.8, 2.8, 1.8]);
    // A part of the stroke has all results. The work on the load is its potential energy.
    let part = Duty::new(&scene.mechanism, &solver, Some((1.8, 2.8))).unwrap();
    let mut state = solver.state();
    let point = |name: &str| {
        let mut ids = scene.mechanism.point_ids();
        ids.find(|&id| scene.point_name(id) == Some(name)).unwrap()
    };
    let tip = point("T");
    let mut height = |at: f64| {
        let _ = solver.solve(at, Order::Position, &mut state);
        state.position(tip).unwrap().y
    };
    let heights: Vec<f64> = (0..=1000)
        .map(|k| height(1.8 + f64::from(k) / 1000.0))
        .collect();
    let is_rising = heights.windows(2).all(|pair| pair[0] < pair[1]);
    assert!(is_rising, "the load is lifted all the way");
    let lift = 18e3 * (heights[1000] - heights[0]);
    near(part.cycle.parts[0].supplied.unwrap(), lift, 1e-9 * lift);
    near(part.cycle.parts[0].returned.unwrap(), lift, 1e-9 * lift);
    assert!(part.cycle.all.worst().is_some() && part.cycle.has_converged());
    assert!(part.dead_points.is_empty() && !part.reaches_dead_point);
    assert!(
        is_within(solver.motion().range, 1.8, 2.8) && !is_within(solver.motion().range, 0.0, 2.0)
    );
}

#[test]
fn change_points_are_listed_and_crossed() {
    let text = presets::find("parallelogram").unwrap().text;
    let (plain, bare_solver) = of(text);
    assert!(
        matches!(
            Duty::new(&plain.mechanism, &bare_solver, None),
            Err(DutyError::NothingActs)
        ),
        "nothing acts"
    );
    let link = "r4";
    let duty = duty(&format!(
        "{text}\n[[loads]]\nlink = \"{link}\"\ntorque = 3\n"
    ));
    assert_eq!(duty.change_points.len(), 2, "{:?}", duty.change_points);
    // Both cranks turn alike: the driver balances exactly the load.
    near(duty.cycle.all.largest.unwrap().value, -3.0, 1e-9);
    near(duty.cycle.all.least.unwrap().value, -3.0, 1e-9);
    near(duty.cycle.all.work().unwrap(), -6.0 * PI, 1e-9);
}

#[test]
fn motor_fit_compares_rms_and_worst_torque() {
    let (scene, solver) = preset("four-bar-load");
    let duty = Duty::new(&scene.mechanism, &solver, None).unwrap();
    let worst = duty.cycle.all.worst().unwrap().value.abs();
    let rms = duty.cycle.all.rms.unwrap();
    let motor = |rated, peak, speed| Motor {
        rated: Some(rated),
        peak: Some(peak),
        speed: Some(speed),
        ..Motor::default()
    };
    let enough = duty.fit(&motor(rms, worst, 15.0));
    assert_eq!((enough.is_enough(), enough.geared), (Some(true), None));
    let weak = duty.fit(&motor(0.5 * rms, 0.25 * worst, 60.0));
    assert_eq!(weak.is_enough(), Some(false));
    near(weak.rated.unwrap().deficit(), 0.5 * rms, 1e-12);
    near(weak.peak.unwrap().deficit(), 0.75 * worst, 1e-12);
    assert!(weak.speed.unwrap().is_enough());
    let geared = weak.geared.unwrap();
    assert_eq!((geared.ratio, geared.is_enough), (4.0, true));
    assert_eq!(duty.fit(&Motor::default()).is_enough(), None);
}
