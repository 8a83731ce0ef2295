//! What is done once for a mechanism of many dyads: opening it and following its motion, the extremes of its
//! transmission angles, and a study of all methods.
//!
//! `cargo bench --bench open` prints seconds of each, the least of a few runs.
#![allow(clippy::print_stdout, reason = "the times are to be read")]

mod chains;

use krank::Mechanism;
use krank::solver::{Range, Solver};
use krank::study::{DEFAULT_POSITIONS, Study};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Runs of which the shortest counts.
const RUNS: usize = 3;

fn main() {
    // `cargo test --benches` runs this too, to see that it works.
    let is_timed = std::env::args().any(|argument| argument == "--bench");
    let shrink = if is_timed { 1 } else { 100 };
    println!(
        "{:<28}{:>10}{:>14}{:>10}",
        "", "opened", "transmission", "range"
    );
    let grounded = |dyads: usize| chains::grounded(dyads / shrink + 1);
    opened("4,900 grounded dyads", &grounded(4899));
    opened("1,000 grounded dyads", &grounded(999));
    let plain = chains::on_plain_points(999 / shrink + 1);
    opened("1,000 on plain points", &plain);
    if is_timed {
        for dyads in [1, 20, 100] {
            studied(dyads);
        }
    }
}

fn min_time<T>(mut run: impl FnMut() -> T) -> (f64, T) {
    let mut best: Option<(f64, T)> = None;
    for _ in 0..RUNS {
        let start = Instant::now();
        let result = black_box(run());
        let took = start.elapsed().as_secs_f64();
        if best.as_ref().is_none_or(|best| took < best.0) {
            best = Some((took, result));
        }
    }
    best.expect("there is a run")
}

fn opened(name: &str, mechanism: &Mechanism) {
    let (opening, solver) = min_time(|| Solver::new(mechanism).expect("the chain closes"));
    let (seeing, _) = min_time(|| solver.transmission());
    let range = match solver.motion().range {
        Range::Full { period } => format!("{period} deg"),
        Range::Limited { low, high } => format!("{:.2} deg", high - low),
    };
    println!("{name:<28}{opening:>8.3} s{seeing:>12.3} s{range:>12}");
}

/// A study of all methods, as `krank accuracy` makes it.
fn studied(dyads: usize) {
    let solver = Solver::new(&chains::grounded(dyads)).expect("the chain closes");
    let start = Instant::now();
    let mut study = Study::new(&solver, DEFAULT_POSITIONS);
    while study.advance(&mut || start.elapsed(), Duration::from_millis(50)) {}
    let took = start.elapsed().as_secs_f64();
    println!("{:<28}{took:>8.3} s", format!("all methods, {dyads} dyads"));
}
