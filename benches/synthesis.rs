//! From a task to linkages.

use criterion::{Criterion, criterion_group, criterion_main};
use krank::synthesis::functions::{FunctionSearch, chebyshev_pairs};
use krank::synthesis::{FunctionTask, Given, Output};
use std::hint::black_box;

/// log10 x from 1 to 2 over 60 deg each: five pairs by algebra, 13 by least squares.
fn functions(criterion: &mut Criterion) {
    let task = |count| FunctionTask {
        pairs: chebyshev_pairs(|x: f64| Some(x.log10()), [1.0, 2.0], count).unwrap_or_default(),
        between: Vec::new(),
        output: Output::Angle,
        crank_datum: Given::Free,
        crank_scale: Given::Value(60.0),
        output_datum: Given::Free,
        output_scale: Given::Value(60.0 / 2.0_f64.log10()),
        size: 100.0,
    };
    for (name, count) in [("five pairs", 5), ("13 pairs", 13)] {
        let task = task(count);
        criterion.bench_function(&format!("functions/{name}"), |bench| {
            let search = FunctionSearch {
                task: &task,
                threads: 1,
            };
            bench.iter(|| black_box(&search).run(&mut |_| true));
        });
    }
}

criterion_group!(benches, functions);
criterion_main!(benches);
