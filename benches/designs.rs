//! Many designs of one mechanism: what it takes to open one from its text, to build a solver, and to change lengths in
//! place, as tolerances and studies do. Then searches for the best design, and studies of a crank that turns fully and of
//! one that does not.
//!
//! `cargo bench --bench designs` prints the time of each, the least of a few runs; a search runs once.
#![allow(clippy::print_stdout, reason = "the times are to be read")]

use krank::quantity::{Catalogue, Quantity, demand};
use krank::scene::{Scene, presets};
use krank::solver::Solver;
use krank::study::{
    BestDesign, CycleFigure, DesignFigures, DesignSpace, Distribution, Goal, OptimiseOrder,
    PlanAxis, SampleOrder, ToleranceStudy,
};
use krank::{LANES, Tolerances};
use std::hint::black_box;
use std::time::Instant;

/// Runs of which the shortest counts.
const RUNS: usize = 5;
/// The samples of a tolerance at one place.
const SAMPLES: u32 = 100_000;
/// The angles of a design.
const ANGLES: u32 = 360;

fn main() {
    // `cargo test --benches` runs this too, to see that it works.
    let is_timed = std::env::args().any(|argument| argument == "--bench");
    let shrink = if is_timed { 1 } else { 1000 };
    println!(
        "{:<28}{:>10}{:>10}{:>12}{:>14}{:>14}",
        "", "read", "opened", "in place", "360 angles", "100,000"
    );
    for (name, column) in [
        ("four-bar", "C.x"),
        ("slider-crank", "r4.length"),
        ("press", "r6.angle"),
        ("jansen-leg", "T.y"),
        ("stephenson-six-bar", "E.x"),
    ] {
        timed(name, column, shrink);
    }
    println!();
    search(
        "press: equalities",
        include_str!("designs/press.toml"),
        &["r=60..120", "ax=-900..-500", "ay=-450..-200", "l=450..800"],
        "transmission",
        &["D.y.stroke = 120", "upper.angle.greatest = 269"],
        (300 / shrink).max(1),
    );
    search(
        "leg: kinks",
        include_str!("designs/leg.toml"),
        &[
            "r=20..60",
            "c=80..150",
            "k=70..130",
            "gx=60..110",
            "gy=-40..20",
            "fx=120..260",
            "fy=-40..80",
        ],
        "F.x.stroke",
        &["F.y.stroke = 30", "transmission >= 40"],
        (20 / shrink).max(1),
    );
    let four_bar = presets::find("four-bar").expect("the preset is built in");
    study("crank-rocker", four_bar.text, [95.0, 105.0], shrink);
    // The longest link and the shortest one are together longer than the other two.
    let limited = four_bar.text.replacen("length = 100", "length = 300", 1);
    let limited = limited.replacen(
        "length = 300, com = [150, 0]",
        "length = 200, com = [150, 0]",
        1,
    );
    study(
        "crank with a limited range",
        &limited,
        [295.0, 305.0],
        shrink,
    );
}

/// Searches for the best design on two threads.
fn search(name: &str, text: &str, axes: &[&str], maximized: &str, kept: &[&str], generations: u32) {
    let scene = Scene::parse(text, name).expect("it is a scene");
    let solver = Solver::new(&scene.mechanism).expect("it closes");
    let axes: Vec<PlanAxis> = axes
        .iter()
        .map(|axis| axis.parse().expect("it is an axis"))
        .collect();
    let space = DesignSpace::of_axes(&scene, &solver, &axes).expect("it has the values");
    let catalogue = Catalogue::new(&scene);
    let goal = |text: &&str| Goal::parse(text, &catalogue).expect("it is a goal");
    let goals: Vec<Goal> = kept.iter().map(goal).collect();
    let figure = CycleFigure::parse(maximized, &catalogue).expect("it is a figure");
    let all = std::iter::once(figure).chain(goals.iter().map(|goal| goal.figure.clone()));
    let figures = DesignFigures::new(&space, all.collect(), None);
    let order = OptimiseOrder {
        greatest: true,
        generations,
        seed: 1,
        threads: 2,
    };
    let start = Instant::now();
    let best =
        BestDesign::find(&figures, &goals, &axes, order, &mut |_| true).expect("there is a design");
    println!(
        "{name:<28}{:>7.2} s for {} generations: {maximized} = {:.5}, missed {:.1e}",
        start.elapsed().as_secs_f64(),
        best.generations,
        best.value,
        best.missed
    );
}

/// Computes the swing of many designs with other cranks.
fn study(name: &str, text: &str, [low, high]: [f64; 2], shrink: u32) {
    let scene = Scene::parse(text, name).expect("it is a scene");
    let solver = Solver::new(&scene.mechanism).expect("it closes");
    let crank = scene.value_named("r2.length").expect("it has a crank");
    let space = DesignSpace::new(&scene, &solver, vec![crank]);
    let figure =
        CycleFigure::parse("r4.angle.swing", &Catalogue::new(&scene)).expect("it is a figure");
    let mut figures = DesignFigures::new(&space, vec![figure], None);
    let count = 1000 / shrink + 1;
    let time = min_time(|| {
        for k in 0..count {
            let number = low + (high - low) * f64::from(k) / f64::from(count);
            let _ = black_box(figures.of(&[number]));
        }
    });
    println!(
        "{name:<28}{:>7.1} us a design",
        1e6 * time / f64::from(count)
    );
}

fn min_time(mut run: impl FnMut()) -> f64 {
    let times = (0..RUNS).map(|_| {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64()
    });
    times.fold(f64::INFINITY, f64::min)
}

fn timed(name: &str, column: &str, shrink: u32) {
    let preset = presets::find(name).expect("the preset is built in");
    let read = || Scene::parse(preset.text, name).expect("presets are scenes");
    let scene = read();
    let solver = Solver::new(&scene.mechanism).expect("presets close");
    let quantity: Quantity = Catalogue::new(&scene)
        .find(column)
        .expect("it has the figure")
        .clone();
    let (wanted, order) = demand([&quantity]);
    let reading = min_time(|| drop(black_box(read())));
    let opening = min_time(|| drop(black_box(Solver::new(&scene.mechanism))));
    let lengths = scene.mechanism.lengths();
    let mut varied = solver
        .varied(&lengths, &wanted)
        .expect("no preset here is redundant");
    let mut by = vec![0.0; lengths.len()];
    let count = 10_000 / shrink + 1;
    let place = min_time(|| {
        for k in 0..count {
            by.fill(1e-3 * f64::from(k));
            varied.change(&by);
            let _ = black_box(varied.solve(60.0, order));
        }
    }) / f64::from(count);
    let complete = min_time(|| {
        for k in 0..count / 100 + 1 {
            by.fill(1e-3 * f64::from(k));
            varied.change(&by);
            for first in (0..ANGLES).step_by(LANES) {
                let at = std::array::from_fn(|lane| f64::from(first) + lane as f64);
                if let Some(lanes) = varied.solve_lanes(at, order) {
                    black_box(quantity.value(lanes));
                }
            }
        }
    }) / f64::from(count / 100 + 1);
    let all = lengths.iter().map(|&length| (length, 0.01));
    let tolerances = Tolerances {
        lengths: all.collect(),
        clearances: Vec::new(),
    };
    let mut study = ToleranceStudy::new(&scene, &solver, &tolerances, &[quantity])
        .expect("there are tolerances");
    let samples = SampleOrder {
        count: SAMPLES / shrink,
        seed: 1,
        distribution: Distribution::Normal,
    };
    let sampled = min_time(|| drop(black_box(study.sampled(60.0, samples))));
    println!(
        "{name:<28}{:>7.1} us{:>7.1} us{:>9.3} us{:>11.2} us{:>12.3} s",
        1e6 * reading,
        1e6 * opening,
        1e6 * place,
        1e6 * complete,
        sampled
    );
}
