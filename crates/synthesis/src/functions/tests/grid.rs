//! Counts the tasks of a grid of common functions that have a usable function generator.

use super::super::{FunctionRun, chebyshev_pairs};
use super::propose;
use crate::{FunctionTask, GivenNumber, Output, PinConstraint, Proposal};
use kinematics::angle::unit;

struct FunctionPreference {
    f: fn(f64) -> f64,
    range: [f64; 2],
}

const PREFERENCES: [FunctionPreference; 10] = [
    FunctionPreference {
        f: |x| x.powf(1.5),
        range: [1.0, 2.0],
    },
    FunctionPreference {
        f: |x| x * x,
        range: [0.0, 1.0],
    },
    FunctionPreference {
        f: |x| x.powi(3),
        range: [0.0, 1.0],
    },
    FunctionPreference {
        f: f64::sqrt,
        range: [1.0, 4.0],
    },
    FunctionPreference {
        f: |x| 1.0 / x,
        range: [1.0, 2.0],
    },
    FunctionPreference {
        f: f64::log10,
        range: [1.0, 2.0],
    },
    FunctionPreference {
        f: f64::ln,
        range: [1.0, 5.0],
    },
    FunctionPreference {
        f: f64::exp,
        range: [0.0, 1.0],
    },
    FunctionPreference {
        f: f64::sin,
        range: [0.0, 1.5],
    },
    FunctionPreference {
        f: f64::tan,
        range: [0.0, 0.8],
    },
];
/// Swings of crank and output, and their initial angles, in degrees.
const SWINGS: [[f64; 2]; 3] = [[60.0, 60.0], [90.0, 60.0], [120.0, 90.0]];
const STARTS: [[f64; 2]; 4] = [[30.0, 60.0], [45.0, 200.0], [90.0, 90.0], [120.0, 240.0]];

/// Creates a task of the grid with `count` pairs at Chebyshev's zeros.
fn task(
    preference: &FunctionPreference,
    swing: [f64; 2],
    start: [f64; 2],
    count: usize,
    is_free: bool,
) -> FunctionTask {
    let [from, to] = preference.range;
    let (low, high) = ((preference.f)(from), (preference.f)(to));
    let (crank_scale, output_scale) = (swing[0] / (to - from), swing[1] / (high - low));
    let datum = |start: f64, scale: f64, at: f64| {
        if is_free {
            GivenNumber::Free
        } else {
            GivenNumber::Value(start - scale * at)
        }
    };
    FunctionTask {
        pairs: chebyshev_pairs(|x| Some((preference.f)(x)), preference.range, count).unwrap(),
        between: Vec::new(),
        output: Output::Angle,
        crank_datum: datum(start[0], crank_scale, from),
        crank_scale: GivenNumber::Value(crank_scale),
        output_datum: datum(start[1], output_scale, low),
        output_scale: GivenNumber::Value(output_scale),
        size: 1.0,
    }
}

/// Returns `true` if one assembly passes through all pairs and closes over the whole range, with a
/// length ratio below 20.
fn is_serviceable(
    preference: &FunctionPreference,
    task: &FunctionTask,
    proposal: &Proposal,
) -> bool {
    let (a, b, c) = proposal.lengths().unwrap();
    let lengths = [a, b, c.unwrap(), task.size];
    let longest = lengths.iter().fold(0.0_f64, |maximum, l| maximum.max(*l));
    let shortest = lengths
        .iter()
        .fold(f64::INFINITY, |minimum, l| minimum.min(*l));
    let Some(run) = FunctionRun::of(task, proposal) else {
        return false;
    };
    let mut errors = task.pairs.iter().map(|[x, y]| run.error(*x, *y));
    errors.all(|e| e.is_some_and(|e| e.abs() < 1e-6))
        && run
            .max_error(|x| Some((preference.f)(x)), preference.range)
            .is_some()
        && longest < 20.0 * shortest
}

/// Returns `true` if both links are at their own angles, not opposite. A method that requires
/// positive ratios finds only these.
fn is_positive(task: &FunctionTask, proposal: &Proposal) -> bool {
    let value = |given| match given {
        GivenNumber::Value(value) => value,
        GivenNumber::Free => f64::NAN,
    };
    let [x, y] = task.pairs[0];
    let crank = unit(value(task.crank_datum) + value(task.crank_scale) * x);
    let output = unit(value(task.output_datum) + value(task.output_scale) * y);
    let [b, c] = proposal.places[0];
    let PinConstraint::Rocker(d) = proposal.partner else {
        return false;
    };
    b.dot(crank) > 0.0 && (c - d).dot(output) > 0.0
}

fn over_the_grid(mut look: impl FnMut(&FunctionPreference, [f64; 2], [f64; 2])) {
    for preference in &PREFERENCES {
        for swing in SWINGS {
            for start in STARTS {
                look(preference, swing, start);
            }
        }
    }
}

/// Three pairs and given datums have one four-bar. Measured on 120 tasks: how many are serviceable,
/// and how many of these have positive ratios. A program that rejects negative ratios finds little
/// more than a third.
#[test]
fn negative_ratios_give_usable_linkages() {
    let (mut serviceable, mut positive) = (0, 0);
    over_the_grid(|preference, swing, start| {
        let task = task(preference, swing, start, 3, false);
        let proposals = propose(&task);
        assert!(proposals.is_complete && proposals.found.len() <= 1);
        for proposal in &proposals.found {
            let is_good = is_serviceable(preference, &task, proposal);
            serviceable += u32::from(is_good);
            positive += u32::from(is_good && is_positive(&task, proposal));
        }
    });
    assert!(serviceable >= 71, "{serviceable}");
    assert_eq!(positive, 27);
}

/// Five pairs with both datums free: measured on 30 tasks, how many have a serviceable four-bar.
#[test]
fn free_datums_solve_most_tasks() {
    let (mut serviceable, mut errors) = (0, Vec::new());
    over_the_grid(|preference, swing, start| {
        if start != STARTS[0] {
            return;
        }
        let task = task(preference, swing, start, 5, true);
        let proposals = propose(&task);
        assert!(proposals.is_complete && proposals.found.len() <= 3);
        let good = proposals
            .found
            .iter()
            .filter(|p| is_serviceable(preference, &task, p));
        let error = good.map(|p| {
            let run = FunctionRun::of(&task, p).unwrap();
            run.max_error(|x| Some((preference.f)(x)), preference.range)
                .unwrap()
                .error
                .abs()
        });
        let best = error.fold(f64::INFINITY, f64::min);
        if best.is_finite() {
            serviceable += 1;
            errors.push(best);
        }
    });
    errors.sort_by(f64::total_cmp);
    assert!(serviceable >= 28, "{serviceable}");
    // In degrees: the median over all tasks of the smallest error, and the largest.
    let (median, worst) = (errors[errors.len() / 2], errors[errors.len() - 1]);
    assert!(median < 0.08 && worst < 0.66, "{median} {worst}");
}
