//! The general solver beside closed forms written by hand for the same mechanisms, in the same run,
//! and a long chain of dyads.
//!
//! `cargo bench --bench solve` prints the medians side by side. Both sides
//! give position, velocity and acceleration of the same points and the turning of the same links, and
//! are held against each other first.
#![allow(clippy::print_stdout, reason = "the medians are to be read")]

mod both;
mod chains;
mod handwritten;
mod median;

use both::{Agreement, Figures, General, SWEEP, Visitor, angles, closed_form, visit_all};
use krank::solver::{Order, Solver};
use median::{median, median_time};
use std::hint::black_box;
use std::time::Instant;

/// Sweeps timed for one sample, and samples for a median.
const REPEATS: u32 = 20;
const SAMPLES: usize = 101;

/// Medians of samples taken in turn, so that a disturbance meets all sides alike.
struct Ratios;

impl Visitor for Ratios {
    fn visit<const P: usize, const L: usize>(
        &mut self,
        name: &str,
        general: &General<P, L>,
        form: impl Fn(f64) -> Figures<P, L>,
        lean: impl Fn(f64) -> Figures<P, L>,
    ) {
        let angles = angles();
        let mut state = general.solver.state();
        let mut lanes = general.solver.lanes();
        let mut enclosure = general.solver.enclosure();
        let mut samples: [Vec<f64>; WAYS.len() + 1] = Default::default();
        for _ in 0..SAMPLES {
            let [hand, leanest, solved, read, at_once, at_once_read, bounds] = &mut samples;
            hand.push(time(|| closed_form(&form, &angles)));
            leanest.push(time(|| closed_form(&lean, &angles)));
            solved.push(time(|| general.sweep(&angles, &mut state)));
            read.push(time(|| general.sweep_and_read(&angles, &mut state)));
            at_once.push(time(|| general.sweep_in_lanes(&angles, &mut lanes)));
            at_once_read.push(time(|| {
                general.sweep_in_lanes_and_read(&angles, &mut lanes)
            }));
            bounds.push(time(|| {
                general.sweep_with_bounds(&angles, &mut state, &mut enclosure);
            }));
        }
        let [hand, ways @ ..] = samples.map(median);
        print!("{name:<14}{hand:>8.1} ns");
        for variant in ways {
            print!("{variant:>9.1} ns {:>5.2}", variant / hand);
        }
        println!();
    }
}

/// What is timed beside the closed form.
const WAYS: [&str; 6] = [
    "leanest",
    "solved",
    "and read",
    "in lanes",
    "and read",
    "with bounds",
];

/// Nanoseconds per position of a sweep.
fn time(mut sweep: impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..REPEATS {
        sweep();
    }
    start.elapsed().as_nanos() as f64 / (f64::from(REPEATS) * SWEEP as f64)
}

const CHAINS: [usize; 4] = [1, 10, 100, 1000];

fn print_chains() {
    println!(
        "\n{:<14}{:>13}{:>16}{:>18}",
        "dyads", "open", "solve", "solve per dyad"
    );
    for dyads in CHAINS {
        let mechanism = chains::grounded(dyads);
        let runs = if dyads >= 1000 { 5 } else { 21 };
        let opening = median_time(runs, || {
            Solver::new(black_box(&mechanism)).expect("the chain closes")
        });
        let solver = Solver::new(&mechanism).expect("the chain closes");
        let mut state = solver.state();
        let mut at = 0.0;
        let solving = median_time(SAMPLES, || {
            for _ in 0..REPEATS {
                at += 1.0;
                let _ = solver.solve(black_box(at), Order::Acceleration, &mut state);
            }
        });
        let (opening, solving) = (1e3 * opening, 1e9 * solving / f64::from(REPEATS));
        println!(
            "{dyads:<14}{opening:>10.2} ms{solving:>13.0} ns{:>15.1} ns",
            solving / dyads as f64
        );
    }
}

fn main() {
    visit_all(&mut Agreement);
    // `cargo test --benches` runs this too, to see that it works; then nothing is timed.
    if std::env::args().any(|argument| argument == "--bench") {
        println!(
            "\nmedians per position, and as parts of the closed form's: points and links with both rates"
        );
        print!("{:<14}{:>11}", "", "by hand");
        for variant in WAYS {
            print!("{variant:>12}      ");
        }
        println!();
        visit_all(&mut Ratios);
        print_chains();
    }
}
