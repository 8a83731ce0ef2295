//! Tests of cases beyond algebra: noise, free scales, many pairs, and progress reports.

use super::super::FunctionSearch;
use super::{KnownFunction, KnownLaw, LAW, law_of, propose};
use crate::functions::FunctionRun;
use crate::{FunctionTask, GivenNumber, Output, Proposal};
use kinematics::numeric::SeededRng;

/// Returns the sum of squared errors of a proposal at the pairs, or infinity if the linkage is at a
/// dead point at one.
fn squares(task: &FunctionTask, proposal: &Proposal) -> f64 {
    let run = FunctionRun::of(task, proposal).unwrap();
    let error = |x, y| run.error(x, y).unwrap_or(f64::INFINITY);
    let errors = task.pairs.iter().map(|[x, y]| error(*x, *y));
    errors.map(|e| e * e).sum()
}

/// Twenty pairs with noise of a hundredth of the swing. The search used to find nothing, since
/// algebra led away from the minimum.
#[test]
fn noisy_pairs_are_fitted_as_well_as_by_planted_linkage() {
    let mut rng = SeededRng::new(501);
    let free = [true, false, true, false];
    let mut fitted = 0;
    for _ in 0..20 {
        let planted = KnownFunction::draw(&mut rng, Output::Angle, 20);
        let mut task = planted.task(LAW, free);
        let ys = || planted.pairs.iter().map(|pair| pair[1]);
        let swing = ys().fold(f64::NEG_INFINITY, f64::max) - ys().fold(f64::INFINITY, f64::min);
        let KnownLaw([.., scale]) = LAW;
        let mut noise = 0.0;
        for pair in &mut task.pairs {
            let off = 0.01 * swing * rng.normal()[0];
            pair[1] += off / scale;
            noise += off * off;
        }
        let found = propose(&task).found;
        assert!(!found.is_empty());
        let best = found.iter().map(|one| squares(&task, one));
        fitted += u32::from(best.fold(f64::INFINITY, f64::min) <= noise);
    }
    assert!(fitted >= 19, "{fitted}");
}

/// Both scales free and both datums given: five pairs have many linkages. The known one, with usual
/// lengths, is among the results; none occurs twice, and none is too slender.
#[test]
fn free_scales_find_distinct_linkages_of_usual_lengths() {
    let mut rng = SeededRng::new(77);
    let free = [false, true, false, true];
    let (mut recovered, rounds) = (0, 12);
    for _ in 0..rounds {
        let planted = KnownFunction::draw(&mut rng, Output::Angle, 5);
        let found = propose(&planted.task(law_of(Output::Angle, free), free));
        recovered += u32::from(planted.nearest(&found) < 1e-9);
        for (k, one) in found.found.iter().enumerate() {
            assert!(one.ratio() < 50.001, "{one:?}");
            let is_again = |other: &Proposal| {
                let pins = one.places.iter().flatten();
                let mut pairs = pins.zip(other.places.iter().flatten());
                pairs.all(|(a, b)| (*a - *b).norm() <= 1e-4)
            };
            assert!(!found.found[..k].iter().any(is_again), "{one:?}");
        }
    }
    assert!(recovered + 1 >= rounds, "{recovered}");
}

/// The result does not depend on the number of threads. The reported progress never decreases and
/// ends at 1. A stopped search returns the linkages found so far.
#[test]
fn search_reports_progress_and_can_be_stopped() {
    let planted = KnownFunction::draw(&mut SeededRng::new(3), Output::Angle, 100);
    let free = [true, false, true, false];
    let task = planted.task(LAW, free);
    let run = |threads, maximum: f64| {
        let mut parts = vec![0.0];
        let search = FunctionSearch {
            task: &task,
            threads,
        };
        let found = search.run(&mut |part| {
            parts.push(part);
            part < maximum
        });
        (found, parts)
    };
    let (found, parts) = run(1, 2.0);
    assert!(planted.nearest(&found) < 1e-9);
    assert!(parts.windows(2).all(|two| two[0] <= two[1]) && parts.last() == Some(&1.0));
    assert_eq!(run(3, 2.0).0, found);
    let (early, parts) = run(1, 0.6);
    assert!(!early.found.is_empty() && parts.last() < Some(&0.7));
    assert!(run(1, 0.05).0.found.is_empty());
}

/// A slider-crank begins at its given start angle, not opposite to it.
#[test]
fn slider_crank_keeps_given_start() {
    let mut rng = SeededRng::new(12);
    for free in [
        [false, false, true, true],
        [false, false, true, false],
        [false, true, true, true],
    ] {
        for _ in 0..10 {
            let planted = KnownFunction::draw(&mut rng, Output::Slide, 5);
            let task = planted.task(law_of(Output::Slide, free), free);
            let found = propose(&task).found;
            assert!(!found.is_empty());
            for one in &found {
                let run = FunctionRun::of(&task, one).unwrap();
                let GivenNumber::Value(datum) = task.crank_datum else {
                    unreachable!("it is given")
                };
                let turns = (run.crank(0.0) - datum) / 360.0;
                assert!((turns - turns.round()).abs() < 1e-9, "{free:?} {turns}");
                for ([x, _], [b, _]) in task.pairs.iter().zip(&one.places) {
                    let distance = (run.crank(*x) - b.angle().to_degrees()) / 360.0;
                    assert!((distance - distance.round()).abs() < 1e-9, "{free:?} {x}");
                }
            }
        }
    }
}
