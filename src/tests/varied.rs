//! Tests solving with lengths changed in place.

use crate::scene::{Scene, presets};
use crate::solver::{Condition, Demand, Order, Solver, Varied};
use crate::{CoordinateAxis, LANES, Length, Mechanism, Vec2};

fn size(mechanism: &Mechanism) -> f64 {
    let sizes = mechanism.links().iter().flat_map(|l| &l.members);
    sizes.map(|m| m.local.norm()).fold(0.0, f64::max)
}

/// Changes every length of every preset by 1e-4 of the machine's size, one at a time and all at
/// once. The result equals that of a mechanism built with these lengths, at positions in irregular
/// order.
#[test]
fn lengths_changed_in_place_match_rebuilt_mechanism() {
    let mut compared = 0;
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let mechanism = &scene.mechanism;
        let solver = Solver::new(mechanism).unwrap();
        let lengths = mechanism.lengths();
        let Some(fresh) = solver.varied(&lengths, &Demand::of_motion(mechanism)) else {
            assert!(!solver.rank().redundancies.is_empty(), "{}", preset.name);
            continue;
        };
        let mut varied = fresh.clone();
        // A point given by length and angle moves on its circle and not along the tangent; for
        // small changes both agree.
        let straight = |l: &Length| !matches!(l, Length::Across(..));
        let by = 1e-4 * size(mechanism);
        for (i, &length) in lengths.iter().enumerate() {
            let by = if straight(&length) { by } else { 1e-3 * by };
            let mut change = vec![0.0; lengths.len()];
            change[i] = by;
            compared += hold(
                (&fresh, &mut varied),
                &change,
                &mechanism.changed(length, by),
                preset.name,
            );
        }
        let (mut every, mut change) = (mechanism.clone(), Vec::new());
        for (i, length) in lengths.iter().enumerate() {
            let by = if straight(length) {
                by * (i as f64 / 7.0).sin()
            } else {
                0.0
            };
            every = every.changed(*length, by);
            change.push(by);
        }
        compared += hold((&fresh, &mut varied), &change, &every, preset.name);
    }
    assert!(compared > 2_000, "only {compared} states compared");
}

/// Compares states over the motion with those of a rebuilt mechanism, and with those of a machine
/// that was not changed before. Returns their number.
fn hold(
    (fresh, varied): (&Varied, &mut Varied),
    by: &[f64],
    changed: &Mechanism,
    name: &str,
) -> u32 {
    let Ok(solver) = Solver::new(changed) else {
        return 0;
    };
    varied.change(by);
    let nominal = fresh.nominal();
    let mut once = fresh.clone();
    once.change(by);
    let (low, high) = nominal.motion().range.ends();
    let mut state = solver.state();
    let mut compared = 0;
    // Multiples of the golden ratio give well-distributed positions in irregular order.
    for k in 1..=8 {
        let at = low + (high - low) * (f64::from(k) * 0.618_033_988_749_895).fract();
        let clear =
            solver.motion().change_points.is_empty() && nominal.motion().change_points.is_empty();
        let condition = solver.solve(at, Order::Acceleration, &mut state);
        if condition != Condition::Ok || !clear {
            continue;
        }
        assert_eq!(
            varied.solve(at, Order::Acceleration),
            Condition::Ok,
            "{name} at {at}"
        );
        compared += 1;
        let _ = once.solve(at, Order::Acceleration);
        let scale = 1e-8 * size(changed);
        for point in changed.point_ids() {
            let (one, two) = (varied.state().position(point), state.position(point));
            assert_eq!(one, once.state().position(point), "{name} at {at}");
            let (one, two) = (one.unwrap(), two.unwrap());
            assert!(
                (one - two).norm() <= scale,
                "{name} at {at}: {one:?} {two:?}"
            );
        }
    }
    compared
}

/// Lanes equal single states, and restored lengths give the original solver's values.
#[test]
fn lanes_match_single_states_and_lengths_can_be_restored() {
    let preset = presets::find("press").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let lengths = scene.mechanism.lengths();
    let mut varied = solver
        .varied(&lengths, &Demand::of_motion(&scene.mechanism))
        .unwrap();
    let mut state = solver.state();
    let at: [f64; LANES] = std::array::from_fn(|i| 40.0 * i as f64 + 1.0);
    for by in [0.25, 0.0] {
        varied.change(&vec![by; lengths.len()]);
        let lanes = varied.solve_lanes(at, Order::Velocity).unwrap().clone();
        for (lane, &at) in at.iter().enumerate() {
            assert_eq!(varied.solve(at, Order::Velocity), Condition::Ok);
            let _ = solver.solve(at, Order::Velocity, &mut state);
            for point in scene.mechanism.point_ids() {
                let alone = varied.state().velocity(point).unwrap();
                let nearby = lanes.velocity(point).unwrap();
                assert_eq!([nearby.x.0[lane], nearby.y.0[lane]], [alone.x, alone.y]);
                let given = state.velocity(point).unwrap();
                assert_eq!(
                    alone == given,
                    by == 0.0 || given == Vec2::ZERO,
                    "{point:?}"
                );
            }
        }
    }
}

/// A fixed pivot is moved: values that depend only on the ground are stored in states, and must be
/// updated.
#[test]
fn ground_points_can_be_moved() {
    let preset = presets::find("four-bar").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let pivot = scene.mechanism.point_ids().next().unwrap();
    let length = Length::Ground(pivot, CoordinateAxis::Y);
    let mut varied = solver
        .varied(&[length], &Demand::of_motion(&scene.mechanism))
        .unwrap();
    varied.change(&[2.0]);
    assert_eq!(varied.solve(60.0, Order::Position), Condition::Ok);
    assert_eq!(varied.state().position(pivot), Some(Vec2::new(0.0, 2.0)));
}
