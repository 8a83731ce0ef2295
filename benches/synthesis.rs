//! From a task to linkages.
//!
//! `cargo bench --bench synthesis` prints the median time of each search.
#![allow(clippy::print_stdout, reason = "the times are to be read")]

mod median;

use krank::synthesis::functions::{FunctionSearch, chebyshev_pairs};
use krank::synthesis::{FunctionTask, GivenNumber, Output};
use median::median_time;
use std::hint::black_box;

/// log10 x from 1 to 2 over 60 deg each: five pairs by algebra, 13 by least squares.
fn main() {
    // `cargo test --benches` runs this too, to see that it works.
    let is_timed = std::env::args().any(|argument| argument == "--bench");
    let runs = if is_timed { 21 } else { 1 };
    let task = |count| FunctionTask {
        pairs: chebyshev_pairs(|x: f64| Some(x.log10()), [1.0, 2.0], count).unwrap_or_default(),
        between: Vec::new(),
        output: Output::Angle,
        crank_datum: GivenNumber::Free,
        crank_scale: GivenNumber::Value(60.0),
        output_datum: GivenNumber::Free,
        output_scale: GivenNumber::Value(60.0 / 2.0_f64.log10()),
        size: 100.0,
    };
    for (name, count) in [("five pairs", 5), ("13 pairs", 13)] {
        let task = task(count);
        let search = FunctionSearch {
            task: &task,
            threads: 1,
        };
        let time = median_time(runs, || black_box(&search).run(&mut |_| true));
        println!("functions/{name:<12}{:>10.3} ms", 1e3 * time);
    }
}
