//! Tests that the search finds linkages with a known solution.

mod grid;
mod search;

use super::{FunctionRun, FunctionSearch};
use crate::{FunctionTask, GivenNumber, Output, PinConstraint, Proposal, Proposals};
use kinematics::numeric::SeededRng;

fn propose(task: &FunctionTask) -> Proposals {
    FunctionSearch { task, threads: 2 }.run(&mut |_| true)
}

/// A linkage with a known solution: its crank angles in degrees, each with the output, which is an
/// angle or a travel.
struct KnownFunction {
    output: Output,
    lengths: [f64; 3],
    pairs: Vec<[f64; 2]>,
}

/// Datums and scales: the pairs are `(angle - datum) / scale`.
#[derive(Clone, Copy)]
struct KnownLaw([f64; 4]);

const PLAIN: KnownLaw = KnownLaw([0.0, 1.0, 0.0, 1.0]);
const LAW: KnownLaw = KnownLaw([20.0, 40.0, -35.0, 25.0]);

impl KnownFunction {
    /// Draws a random linkage that closes at `count` angles over a swing. The circles' own formula
    /// gives its outputs; the tested code does not use it.
    fn draw(rng: &mut SeededRng, output: Output, count: usize) -> KnownFunction {
        loop {
            let mut length = |low: f64, high: f64| low + (high - low) * 0.5 * (1.0 + rng.even());
            let (a, b) = (length(0.3, 1.6), length(0.5, 2.0));
            let c = match output {
                Output::Angle => length(0.4, 1.8),
                Output::Slide => length(-0.8, 0.8),
            };
            let a = if output == Output::Slide { 1.0 } else { a };
            let (start, swing) = (length(-180.0, 180.0), length(60.0, 220.0));
            let side = if length(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
            let angles = (0..count).map(|k| start + swing * k as f64 / (count - 1) as f64);
            let pairs: Option<Vec<[f64; 2]>> = angles
                .map(|angle| Some([angle, output_of(output, [a, b, c], angle, side)?]))
                .collect();
            let Some(mut pairs) = pairs else { continue };
            if output == Output::Angle {
                for k in 1..count {
                    let turns = ((pairs[k - 1][1] - pairs[k][1]) / 360.0).round();
                    pairs[k][1] += 360.0 * turns;
                }
            }
            return KnownFunction {
                output,
                lengths: [a, b, c],
                pairs,
            };
        }
    }

    fn task(&self, law: KnownLaw, free: [bool; 4]) -> FunctionTask {
        let KnownLaw([a, b, c, d]) = law;
        let given = |i: usize| {
            if free[i] {
                GivenNumber::Free
            } else {
                GivenNumber::Value(law.0[i])
            }
        };
        let pair = |[x, y]: &[f64; 2]| [(x - a) / b, (y - c) / d];
        FunctionTask {
            pairs: self.pairs.iter().map(pair).collect(),
            between: Vec::new(),
            output: self.output,
            crank_datum: given(0),
            crank_scale: given(1),
            output_datum: given(2),
            output_scale: given(3),
            size: 1.0,
        }
    }

    /// Returns the difference between the known lengths and those of the nearest proposal.
    fn nearest(&self, proposals: &Proposals) -> f64 {
        let distance = |proposal: &Proposal| {
            let (a, b, c) = proposal.lengths().unwrap();
            let third = c.unwrap_or_else(|| proposal.places[0][1].y.abs());
            let [p, q, r] = self.lengths;
            [(a, p), (b, q), (third, r.abs())]
                .iter()
                .fold(0.0_f64, |maximum, (x, y)| maximum.max((x - y).abs()))
        };
        proposals
            .found
            .iter()
            .map(distance)
            .fold(f64::INFINITY, f64::min)
    }
}

fn output_of(output: Output, [a, b, c]: [f64; 3], angle: f64, side: f64) -> Option<f64> {
    let (sin, cos) = angle.to_radians().sin_cos();
    let (x, y) = (a * cos, a * sin);
    match output {
        Output::Angle => {
            let (dx, dy) = (x - 1.0, y);
            let d = dx.hypot(dy);
            // Along D-B, then perpendicular to it.
            let along = (d * d + c * c - b * b) / (2.0 * d);
            let h2 = c * c - along * along;
            (h2 > 0.01).then(|| {
                let h = side * h2.sqrt();
                let (px, py) = ((along * dx - h * dy) / d, (along * dy + h * dx) / d);
                py.atan2(px).to_degrees()
            })
        }
        Output::Slide => {
            let h2 = b * b - (c - y) * (c - y);
            (h2 > 0.01).then(|| x + side * h2.sqrt())
        }
    }
}

/// Draws `rounds` linkages. Returns how many are recovered to 1e-9, and whether every result is
/// complete.
fn recovered(output: Output, count: usize, free: [bool; 4], rounds: usize) -> (usize, bool) {
    let mut rng = SeededRng::new(200 + count as u64);
    let (mut found, mut is_complete) = (0, true);
    for _ in 0..rounds {
        let planted = KnownFunction::draw(&mut rng, output, count);
        let proposals = propose(&planted.task(law_of(output, free), free));
        found += usize::from(planted.nearest(&proposals) < 1e-9);
        is_complete &= proposals.is_complete;
    }
    (found, is_complete)
}

fn law_of(output: Output, free: [bool; 4]) -> KnownLaw {
    match output {
        Output::Angle if free == [false; 4] => PLAIN,
        Output::Angle => LAW,
        Output::Slide => KnownLaw([LAW.0[0], LAW.0[1], 0.3, 0.7]),
    }
}

/// By algebra: every known linkage is found, together with all others.
#[test]
fn exactly_determined_tasks_find_all_linkages() {
    let (t, f) = (true, false);
    for (output, count, free) in [
        (Output::Angle, 3, [f, f, f, f]),
        (Output::Angle, 4, [t, f, f, f]),
        (Output::Angle, 4, [f, f, t, f]),
        (Output::Angle, 5, [t, f, t, f]),
        (Output::Slide, 3, [f, f, t, f]),
        (Output::Slide, 3, [f, f, f, t]),
        (Output::Slide, 3, [t, f, f, f]),
        (Output::Slide, 4, [f, f, t, t]),
        (Output::Slide, 4, [t, f, t, f]),
        (Output::Slide, 5, [t, f, t, t]),
    ] {
        let found = recovered(output, count, free, 300);
        assert_eq!(found, (300, true), "{output:?} {count} {free:?}");
    }
}

/// By least squares from algebra, and from many starts if scales are free: the result is never
/// complete.
#[test]
fn more_pairs_and_free_scales_find_planted_linkage() {
    let (t, f) = (true, false);
    for (output, count, free, rounds) in [
        (Output::Angle, 5, [f, f, f, f], 40),
        (Output::Angle, 9, [t, f, t, f], 40),
        (Output::Slide, 8, [t, f, t, t], 40),
        (Output::Slide, 4, [t, f, f, t], 20),
        (Output::Angle, 6, [t, t, t, f], 3),
        (Output::Angle, 6, [t, f, t, t], 3),
        (Output::Angle, 12, [t, t, t, t], 2),
        (Output::Slide, 6, [t, t, t, t], 2),
    ] {
        let found = recovered(output, count, free, rounds);
        assert_eq!(found, (rounds, false), "{output:?} {count} {free:?}");
    }
}

/// With noise of a hundredth of a degree, the best linkage fits the pairs at least as well as the
/// known one.
#[test]
fn noise_is_fitted_as_well_as_by_planted_linkage() {
    let mut rng = SeededRng::new(77);
    for output in [Output::Angle, Output::Slide] {
        for _ in 0..20 {
            let planted = KnownFunction::draw(&mut rng, output, 9);
            let free = [true, false, true, false];
            let mut task = planted.task(law_of(output, free), free);
            let mut squares = 0.0;
            for pair in &mut task.pairs {
                let noise = 1e-4 * rng.normal()[0];
                let GivenNumber::Value(scale) = task.output_scale else {
                    panic!("it is given");
                };
                pair[1] += noise;
                squares += (noise * scale).powi(2);
            }
            let proposals = propose(&task);
            let sum = |proposal: &Proposal| {
                let run = FunctionRun::of(&task, proposal).unwrap();
                // A linkage at a dead point at a pair is not a fit.
                let error = |x, y| run.error(x, y).unwrap_or(f64::INFINITY);
                let errors = task.pairs.iter().map(|[x, y]| error(*x, *y));
                errors.map(|e| e * e).sum::<f64>()
            };
            let best = proposals
                .found
                .iter()
                .map(sum)
                .fold(f64::INFINITY, f64::min);
            assert!(best <= squares, "{best} {squares}");
        }
    }
}

/// Pairs that repeat exactly or nearly, constant outputs, equal angles and non-finite numbers: all
/// results are finite, with a place at every pair.
#[test]
fn degenerate_pairs_give_finite_linkages() {
    let nan = f64::NAN;
    let dwell = [
        [0.0, 50.0],
        [40.0, 50.0],
        [80.0, 50.0],
        [120.0, 50.0],
        [160.0, 50.0],
    ];
    let equal = [
        [10.0, 10.0],
        [50.0, 50.0],
        [90.0, 90.0],
        [130.0, 130.0],
        [170.0, 170.0],
    ];
    let near = [
        [30.0, 60.0],
        [30.0 + 1e-9, 60.0],
        [60.0, 80.0],
        [90.0, 100.0],
        [90.0, 100.0 + 1e-12],
    ];
    let turned = [
        [0.0, 0.0],
        [180.0, 180.0],
        [360.0, 360.0],
        [540.0, 540.0],
        [720.0, 720.0],
    ];
    let none = [
        [nan, 1.0],
        [2.0, f64::INFINITY],
        [1e300, -1e300],
        [0.0, 0.0],
        [1.0, 1.0],
    ];
    let huge = [
        [1e308, 1.0],
        [-1e308, 2.0],
        [1e200, 3.0],
        [1e100, 4.0],
        [1.0, 5.0],
    ];
    let mut count = 0;
    for (i, pairs) in [dwell, equal, near, turned, none, huge, [[0.0, 0.0]; 5]]
        .into_iter()
        .enumerate()
    {
        for (length, free) in (3..=5).flat_map(|n| (0..16_u8).map(move |bits| (n, bits))) {
            // A search takes long: one for every set of pairs.
            if free & 0b1010 != 0 && (length < 5 || usize::from(free) % 7 != i) {
                continue;
            }
            for output in [Output::Angle, Output::Slide] {
                let given = |bit: u8, value: f64| match free >> bit & 1 {
                    1 => GivenNumber::Free,
                    _ => GivenNumber::Value(value),
                };
                let task = FunctionTask {
                    pairs: pairs[..length].to_vec(),
                    between: Vec::new(),
                    output,
                    crank_datum: given(0, 0.0),
                    crank_scale: given(1, 1.0),
                    output_datum: given(2, 0.0),
                    output_scale: given(3, if output == Output::Angle { 1.0 } else { 0.02 }),
                    size: 2.0,
                };
                for proposal in propose(&task).found {
                    count += 1;
                    assert!(proposal.places.len() == length);
                    assert!(proposal.places.iter().flatten().all(|p| p.is_finite()));
                    if let Some(run) = FunctionRun::of(&task, &proposal) {
                        assert!(run.error(40.0, 50.0).is_none_or(f64::is_finite));
                    }
                }
            }
        }
    }
    // Equal angles are a parallelogram of any length, so that linkages exist.
    assert!(count > 100, "{count}");
}

/// An empty result is not complete if the task is not sound.
#[test]
fn unsound_task_finds_nothing() {
    let mut task =
        KnownFunction::draw(&mut SeededRng::new(1), Output::Angle, 3).task(PLAIN, [false; 4]);
    assert!(propose(&task).is_complete);
    task.size = 0.0;
    assert_eq!(propose(&task), Proposals::default());
    task.size = 1.0;
    task.crank_scale = GivenNumber::Value(0.0);
    assert_eq!(propose(&task), Proposals::default());
    task.crank_scale = GivenNumber::Value(1.0);
    task.pairs.pop();
    assert_eq!(propose(&task), Proposals::default());
}

/// Fewer pairs than unknowns: several linkages, all through the pairs, with constant lengths.
#[test]
fn underdetermined_task_proposes_sample_of_family() {
    let mut rng = SeededRng::new(9);
    for output in [Output::Angle, Output::Slide] {
        let planted = KnownFunction::draw(&mut rng, output, 3);
        let free = [true, false, true, false];
        let task = planted.task(law_of(output, free), free);
        let proposals = propose(&task);
        assert!(!proposals.is_complete && proposals.found.len() >= 8);
        for proposal in &proposals.found {
            let lengths = proposal.lengths().unwrap();
            let size = lengths.1.max(lengths.0).max(lengths.2.unwrap_or(0.0));
            for [b, c] in &proposal.places {
                assert!(((*c - *b).norm() - lengths.1).abs() < 1e-9 * size);
                if let PinConstraint::Rocker(d) = proposal.partner {
                    assert!(((*c - d).norm() - lengths.2.unwrap()).abs() < 1e-12 * size);
                }
            }
            let run = FunctionRun::of(&task, proposal).unwrap();
            let [x, y] = task.pairs[0];
            assert!(run.error(x, y).unwrap().abs() < 1e-6);
        }
    }
}

/// A run uses the fitted datums and scales, and follows a known function between its pairs, too.
#[test]
fn run_follows_planted_function_between_pairs() {
    let mut rng = SeededRng::new(21);
    let mut followed = 0;
    for round in 0..60 {
        let output = [Output::Angle, Output::Slide][round % 2];
        let free = match output {
            Output::Angle => [true, false, true, false],
            Output::Slide => [true, false, true, true],
        };
        // Every other angle is a pair; the ones between are checked.
        let planted = KnownFunction::draw(&mut rng, output, 9);
        let all = planted.task(law_of(output, free), free);
        let mut task = all.clone();
        task.pairs = all.pairs.iter().step_by(2).copied().collect();
        let proposals = propose(&task);
        let runs = proposals
            .found
            .iter()
            .filter_map(|p| FunctionRun::of(&task, p));
        let worst = runs.map(|run| {
            let errors = all
                .pairs
                .iter()
                .map(|[x, y]| run.error(*x, *y).map_or(9.0, f64::abs));
            errors.fold(0.0, f64::max)
        });
        followed += u32::from(worst.fold(f64::INFINITY, f64::min) < 1e-7);
    }
    assert_eq!(followed, 60);
}
