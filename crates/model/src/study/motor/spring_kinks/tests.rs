//! Tests the energy balance of springs: the driver's work equals that of the springs' closed
//! formulas, for any bodies.

use crate::numeric::SeededRng;
use crate::scene::{Scene, presets};
use crate::solver::{Condition, Order, Range, Solver};
use crate::study::motor::Duty;
use crate::{Body, Load};
use std::f64::consts::PI;

fn of(text: &str) -> (Scene, Solver) {
    let scene = Scene::parse(text, "test").unwrap_or_else(|e| panic!("{e}\n{text}"));
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

/// Returns the energy in J of all springs at a coordinate; `None` at a dead point, where a position
/// is only accurate to the root of a rounding error.
fn energy(scene: &Scene, solver: &Solver, at: f64) -> Option<f64> {
    let mut state = solver.state();
    if solver.solve(at, Order::Position, &mut state) == Condition::DeadPoint {
        return None;
    }
    let mechanism = &scene.mechanism;
    let metres = mechanism.metres();
    let energy = |load: &Load| match *load {
        Load::Spring {
            from,
            to,
            stiffness,
            length,
            preload,
            ..
        } => {
            let stretch = ((state.position(to).unwrap() - state.position(from).unwrap()).norm()
                - length)
                * metres;
            0.5 * stiffness * stretch * stretch + preload * stretch
        }
        Load::GasSpring {
            from,
            to,
            ref force,
            ..
        } => {
            let length = (state.position(to).unwrap() - state.position(from).unwrap()).norm();
            -area(force.knots(), length) * metres
        }
        Load::TorsionSpring {
            link,
            to,
            stiffness,
            angle,
            ..
        } => {
            let other = match to {
                Body::Ground => 0.0,
                Body::Link(to) => state.angle(to).unwrap(),
            };
            let off =
                (state.angle(link).unwrap() - other - angle + 180.0).rem_euclid(360.0) - 180.0;
            0.5 * stiffness * off.to_radians().powi(2)
        }
        ref other => panic!("{other:?}"),
    };
    Some(mechanism.loads().iter().map(energy).sum())
}

/// Returns the integral from 0 of the lines between knots, and of the constants beyond them.
fn area(knots: &[[f64; 2]], to: f64) -> f64 {
    let first = knots[0];
    let mut area = first[1] * to.min(first[0]);
    for pair in knots.windows(2) {
        let ([a, p], [b, q]) = (pair[0], pair[1]);
        if a < b && to > a {
            let end = to.min(b);
            let here = p + (q - p) / (b - a) * (end - a);
            area += 0.5 * (p + here) * (end - a);
        }
    }
    let last = knots[knots.len() - 1];
    area + last[1] * (to - last[0]).max(0.0)
}

/// Returns springs of every kind on the last links and points of a scene, in random order.
fn sprung(scene: &Scene, rng: &mut SeededRng) -> String {
    let mechanism = &scene.mechanism;
    let points: Vec<_> = mechanism.point_ids().collect();
    let named = |id| scene.point_name(id);
    let is_fixed = |id| mechanism.point(id).ground.is_some();
    let together = |a, b| {
        let carries = |link: &crate::Link, id| link.members.iter().any(|m| m.point == id);
        mechanism
            .links()
            .iter()
            .any(|link| carries(link, a) && carries(link, b))
    };
    let moving = points.iter().filter(|&&id| !is_fixed(id)).rev();
    let ends = moving.filter_map(|&to| {
        let from = points
            .iter()
            .find(|&&id| is_fixed(id) && !together(id, to))?;
        named(*from).zip(named(to))
    });
    let ends: Vec<(&str, &str)> = ends.take(2).collect();
    let links: Vec<&str> = mechanism.link_ids().map(|id| scene.link_name(id)).collect();
    let size = mechanism.lengths().len() as f64 * 10.0;
    let mut within = |low: f64, high: f64| rng.within(low, high);
    let mut springs = Vec::new();
    for (from, to) in ends {
        let ends = format!("from = \"{from}\"\nto = \"{to}\"");
        let (a, b) = (within(0.0, size), within(10.0, 300.0));
        springs.push(format!(
            "{ends}\nstiffness = {}\nlength = {a}\npreload = {}",
            within(10.0, 2000.0),
            within(-20.0, 60.0)
        ));
        springs.push(format!(
            "{ends}\nforce = [[{a}, 90], [{}, 40], [{}, 70]]",
            a + b,
            a + 2.0 * b
        ));
        springs.push(format!(
            "{ends}\nforce = [[{}, 30], [{}, 80]]",
            a + b,
            a + b
        ));
    }
    let stiff = within(1.0, 40.0);
    let free = within(-90.0, 200.0);
    for pair in links.windows(2) {
        springs.push(format!(
            "link = \"{}\"\nstiffness = {stiff}\nangle = {free}",
            pair[1]
        ));
        springs.push(format!(
            "link = \"{}\"\nto = \"{}\"\nstiffness = {stiff}\nangle = {free}",
            pair[1], pair[0]
        ));
    }
    for k in (1..springs.len()).rev() {
        springs.swap(
            k,
            usize::try_from(rng.between(0, u32::try_from(k).unwrap())).unwrap(),
        );
    }
    springs
        .iter()
        .map(|spring| format!("\n[[springs]]\n{spring}\n"))
        .collect()
}

#[test]
fn driver_work_equals_spring_energy() {
    let mut rng = SeededRng::new(16);
    let mut tried = 0;
    for preset in presets::all() {
        let (plain, _) = of(preset.text);
        if plain.mechanism.has_forces() {
            continue;
        }
        tried += 1;
        let text = preset.text.to_owned() + &sprung(&plain, &mut rng);
        let (scene, solver) = of(&text);
        let duty = Duty::new(&scene.mechanism, &solver, None).unwrap();
        let cycle = &duty.cycle;
        let scale = cycle.all.supplied.unwrap();
        assert!(scale > 0.0);
        assert!(cycle.has_converged(), "{}: {:e}", preset.name, cycle.error);
        let work = cycle.all.work().unwrap();
        assert!(
            work.abs() < 1e-9 * scale,
            "{}: {work:e} of {scale}",
            preset.name
        );
        // Starts away from the ends, which can be dead points.
        let length = cycle.course.length();
        let held = |travel: f64| energy(&scene, &solver, cycle.coordinate(travel));
        let first = length / 48.0;
        let (before, put_before) = (held(first).unwrap(), cycle.work(first).unwrap());
        for k in 1..24 {
            let travel = length * f64::from(k) / 24.0;
            let Some(held) = held(travel) else { continue };
            let put = cycle.work(travel).unwrap() - put_before;
            let miss = (put - (held - before)).abs() / scale;
            assert!(
                miss < 1e-9,
                "{} after {travel}: {put} for {held} less {before}",
                preset.name
            );
        }
    }
    assert!(tried > 10, "{tried}");
}

/// Returns the duty of a crank of 100 mm that turns at 2 rad/s, with the rest of its scene.
fn crank(rest: &str) -> Duty {
    let text = format!(
        "[ground]\nA = [0, 0]\nD = [400, 0]\n[driver]\nlink = \"r2\"\nangle = 0\nspeed = \"2 rad/s\"
[links]\nr2 = {{ from = \"A\", to = \"B\", length = 100 }}\n[vectors]\nr1 = [\"A\", \"D\"]\n{rest}"
    );
    let (scene, solver) = of(&text);
    assert!(matches!(solver.motion().range, Range::Full { .. }));
    Duty::new(&scene.mechanism, &solver, None).unwrap()
}

fn near(value: Option<f64>, exact: f64) {
    let value = value.unwrap();
    assert!(
        (value - exact).abs() < 1e-12 * exact.abs().max(1.0),
        "{value} for {exact}"
    );
}

/// A stroke of 40 deg at 5 N m takes 5 * 2 pi / 9 J per turn, which lasts pi s.
#[test]
fn cutting_stroke_work_is_torque_times_angle() {
    let cut = |over: &str| {
        crank(&format!(
            "[[loads]]\nlink = \"r2\"\ntorque = -5\nover = {over}\n"
        ))
    };
    let duty = cut("[[0, 0], [80, 0], [80, 1], [120, 1], [120, 0], [360, 0]]");
    let angle = 40.0 * PI / 180.0;
    near(duty.cycle.all.work(), 5.0 * angle);
    near(duty.cycle.all.mean, 5.0 * 40.0 / 360.0);
    near(duty.cycle.all.rms, 5.0 * (40.0_f64 / 360.0).sqrt());
    near(duty.cycle.all.largest.map(|peak| peak.value), 5.0);
    near(duty.cycle.all.least.map(|peak| peak.value), 0.0);
    near(duty.seconds(), PI);
    // Between the jumps the torque is 5, its mean 5/9: the work above the mean is 5 (1 - 1/9) of 40 deg.
    let fluctuation = duty.cycle.fluctuation.unwrap();
    near(Some(fluctuation.energy), 5.0 * (1.0 - 40.0 / 360.0) * angle);
    near(Some(fluctuation.fastest), 80.0);
    near(Some(fluctuation.slowest), 120.0);
    for (at, torque) in [(79.999, 0.0), (80.0, 5.0), (119.999, 5.0), (120.0, 0.0)] {
        near(
            duty.step(at).effort(false).map(|effort| effort.torque),
            torque,
        );
    }
    // The curve breaks at both jumps, without a slope between its parts.
    let parts = duty.cycle.curve(360);
    assert_eq!(parts.len(), 3);
    // A slope of 0.001 deg instead adds half of it on either side.
    let slope = cut("[[0, 0], [80, 0], [80.001, 1], [120, 1], [120.001, 0], [360, 0]]");
    near(slope.cycle.all.work(), 5.0 * angle);
}

/// A torsion spring on a crank that turns fully winds up to half a turn and snaps over. Its energy
/// is 1/2 k pi^2 there.
#[test]
fn torsion_spring_on_crank_snaps_over_after_half_turn() {
    let duty = crank("[[springs]]\nlink = \"r2\"\nstiffness = 3\nangle = 30\n");
    near(duty.cycle.all.largest.map(|peak| peak.value), 3.0 * PI);
    near(duty.cycle.all.largest.map(|peak| peak.at), 210.0);
    near(duty.cycle.all.supplied, 1.5 * PI * PI);
    near(duty.cycle.all.returned, 1.5 * PI * PI);
    near(
        duty.step(75.0).effort(false).map(|effort| effort.torque),
        3.0 * PI / 4.0,
    );
}

/// The damper takes c w at every angle; the preload drives the link.
#[test]
fn torsion_damper_and_preload_are_constant_torques() {
    let duty = crank("[[springs]]\nlink = \"r2\"\ndamping = 0.25\npreload = 2\n");
    near(duty.cycle.all.mean, 0.25 * 2.0 - 2.0);
    near(duty.cycle.all.largest.map(|peak| peak.value), -1.5);
}

/// The springs run from D at 400 mm to B on a circle of 100 mm: 300 mm at 0 deg, 500 mm at 180 deg.
#[test]
fn spring_work_depends_on_end_lengths() {
    let spring = |rest: &str| crank(&format!("[[springs]]\nfrom = \"D\"\nto = \"B\"\n{rest}\n"));
    // Compressed once a turn: 0.1 m at 600 N and 0.1 m at 200 N.
    let gas = spring("force = [[400, 600], [400, 200]]");
    near(gas.cycle.all.supplied, 80.0);
    near(gas.cycle.all.returned, 80.0);
    // 1/2 k (x2^2 - x1^2) + F x: k = 1000 N/m, stretched from 50 to 250 mm beyond 250 mm.
    let line = spring("stiffness = 1000\nlength = 250\npreload = 40");
    near(
        line.cycle.all.supplied,
        500.0 * (0.0625 - 0.0025) + 40.0 * 0.2,
    );
}
