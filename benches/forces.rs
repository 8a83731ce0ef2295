//! What forces cost beside the kinematics that they need: the same sweep solved to accelerations and to
//! forces, in turn; and a study of the motor over one cycle.
//!
//! `cargo bench --bench forces` prints medians and their ratio.
#![allow(clippy::print_stdout, reason = "the medians are to be read")]

mod median;

use krank::scene::{Scene, presets};
use krank::solver::{Order, Solver, Workspace};
use krank::study::motor::Duty;
use median::{median, median_time};
use std::hint::black_box;
use std::time::Instant;

/// Coordinates of a sweep, sweeps timed for one sample, and samples for a median.
const STATES: u32 = 360;
const REPEATS: u32 = 20;
const SAMPLES: usize = 101;

fn main() {
    println!(
        "ns a state, median                    kinematics     forces      ratio    bounds of both"
    );
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).expect("a preset is a scene");
        let solver = Solver::new(&scene.mechanism).expect("a preset opens");
        if solver.has_forces() {
            sweep(preset.name, &solver);
        }
    }
    println!("\nms a study of the motor, median         one cycle     states      error");
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).expect("a preset is a scene");
        let solver = Solver::new(&scene.mechanism).expect("a preset opens");
        if solver.has_forces() {
            motor(preset.name, &scene, &solver);
        }
    }
}

/// The three ways in turn, so that a disturbance meets all alike.
fn sweep(name: &str, solver: &Solver) {
    let mut state = solver.state();
    let mut enclosure = solver.enclosure();
    let mut samples: [Vec<f64>; 3] = Default::default();
    for _ in 0..SAMPLES {
        let [kinematics, forces, bounds] = &mut samples;
        kinematics.push(time(solver, |at| {
            solve(solver, at, Order::Acceleration, &mut state)
        }));
        forces.push(time(solver, |at| {
            solve(solver, at, Order::Force, &mut state)
        }));
        bounds.push(time(solver, |at| {
            solve(solver, at, Order::Force, &mut state);
            solver.enclose(&mut state, Order::Force, &mut enclosure);
        }));
    }
    let [kinematics, forces, bounds] = samples.map(median);
    println!(
        "{name:36} {kinematics:9.1} {forces:11.1} {:10.2} {bounds:15.1}",
        forces / kinematics
    );
}

/// A study of the motor over one cycle, in ms, with the states that it solves and its own error.
fn motor(name: &str, scene: &Scene, solver: &Solver) {
    let study = || Duty::new(black_box(&scene.mechanism), solver, None);
    let time = 1e3 * median_time(SAMPLES, study);
    if let Ok(Duty { cycle, .. }) = study() {
        let (states, error) = (cycle.states, cycle.error);
        println!("{name:36} {time:9.3} {states:11} {error:10.1e}");
    }
}

fn solve(solver: &Solver, at: f64, order: Order, state: &mut Workspace) {
    let _ = black_box(solver.solve(black_box(at), order, state));
}

/// Nanoseconds a state.
fn time(solver: &Solver, mut one: impl FnMut(f64)) -> f64 {
    let (low, high) = solver.motion().range.ends();
    let step = (high - low) / f64::from(STATES);
    let started = Instant::now();
    for _ in 0..REPEATS {
        for k in 0..STATES {
            one(low + step * (f64::from(k) + 0.5));
        }
    }
    started.elapsed().as_secs_f64() * 1e9 / f64::from(REPEATS * STATES)
}
