//! Checks internals of the solver on every preset.

use crate::scene::{Scene, presets};
use crate::solver::testing::{
    check_bounds_of_a_disturbed_state, check_conditioning, compare_bounds_without_vectors,
    compare_extremes, part_in_lanes,
};
use crate::solver::{GroupKind, Order, Solver};

/// Returns every preset's name and solver.
fn solvers() -> impl Iterator<Item = (&'static str, Solver)> {
    presets::all().iter().map(|preset| {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        (preset.name, Solver::new(&scene.mechanism).unwrap())
    })
}

fn solver(wanted: &str) -> Solver {
    let mut found = solvers().filter(|(name, _)| *name == wanted);
    found.next().unwrap().1
}

#[test]
fn lanes_are_bit_identical_to_single_states() {
    for (name, solver) in solvers() {
        eprintln!("{name}");
        let mut groups = solver.plan().groups.iter();
        let coupled = groups.any(|group| matches!(group.kind, GroupKind::Coupled { .. }));
        for order in [Order::Position, Order::Velocity, Order::Acceleration] {
            let part = part_in_lanes(&solver, order);
            if coupled {
                assert_eq!(part, 0.0, "{name} is solved one by one");
            } else {
                assert!(part > 0.9, "{name}: only {part} at once");
            }
        }
    }
}

#[test]
fn bounds_without_simd_are_bit_identical() {
    let compared: u32 = solvers()
        .map(|(name, solver)| {
            eprintln!("{name}");
            compare_bounds_without_vectors(&solver)
        })
        .sum();
    assert!(compared > 1500, "{compared}");
}

#[test]
fn bounds_of_disturbed_state_contain_true_values() {
    for (name, solver) in solvers() {
        eprintln!("{name}");
        check_bounds_of_a_disturbed_state(&solver);
    }
}

#[test]
fn shared_sums_find_equal_extreme_transmission_angles() {
    let compared: u32 = solvers()
        .map(|(name, solver)| {
            eprintln!("{name}");
            compare_extremes(&solver)
        })
        .sum();
    // In most presets the extrema are exactly at a sample and need no search; 23 positions remain.
    assert!(compared >= 20, "{compared}");
}

#[test]
fn only_coupled_groups_have_a_worst_condition() {
    assert_eq!(solver("four-bar").conditioning(), []);
    check_conditioning(&solver("stephenson-six-bar"));
}
