//! Tests of driving linkages with a known solution, against formulas of the tests' own.

use crate::{
    Candidate, FunctionTask, GivenNumber, Output, Preferences, Task, TaskDefect, TaskKind,
    functions::FunctionSearch,
};

/// A function with a known solution: the crank is at x degrees and the output at y.
struct KnownRange {
    output: Output,
    lengths: [f64; 3],
    side: f64,
    ends: [f64; 2],
}

impl KnownRange {
    fn at(&self, angle: f64) -> f64 {
        let [a, b, c] = self.lengths;
        let (sin, cos) = angle.to_radians().sin_cos();
        let (x, y) = (a * cos, a * sin);
        match self.output {
            Output::Angle => {
                // The direction from D to B, plus the angle to C by the law of cosines.
                let (dx, dy) = (x - 1.0, y);
                let square = dx * dx + dy * dy;
                let cosine = (square + c * c - b * b) / (2.0 * c * square.sqrt());
                let angle = dy.atan2(dx) + self.side * cosine.acos();
                // In the range from 0 to a turn, where it does not jump.
                angle.to_degrees().rem_euclid(360.0)
            }
            Output::Slide => x + self.side * (b * b - (c - y) * (c - y)).sqrt(),
        }
    }

    fn pairs(&self, count: u32) -> Vec<[f64; 2]> {
        let [from, to] = self.ends;
        let places = (0..=count).map(|k| from + (to - from) * f64::from(k) / f64::from(count));
        places.map(|x| [x, self.at(x)]).collect()
    }

    /// Creates the task with three pairs and 180 intervals in its range.
    fn task(&self) -> Task {
        let one = GivenNumber::Value(1.0);
        Task {
            kind: TaskKind::Function(FunctionTask {
                pairs: self.pairs(2),
                between: self.pairs(180),
                output: self.output,
                crank_datum: GivenNumber::Value(0.0),
                crank_scale: one,
                output_datum: GivenNumber::Value(0.0),
                output_scale: one,
                size: 1.0,
            }),
            four_bars: self.output == Output::Angle,
            slider_cranks: self.output == Output::Slide,
            preferences: Preferences::default(),
        }
    }

    /// Returns the angle between the coupler and the rocker, or the guide's normal, in degrees.
    fn transmission(&self, angle: f64) -> f64 {
        let (sin, cos) = angle.to_radians().sin_cos();
        let [a, b, c] = self.lengths;
        let cosine = match self.output {
            Output::Angle => {
                let across = (a * cos - 1.0).powi(2) + (a * sin).powi(2);
                (b * b + c * c - across) / (2.0 * b * c)
            }
            Output::Slide => (c - a * sin) / b,
        };
        cosine.abs().acos().to_degrees()
    }

    fn min_transmission(&self) -> f64 {
        let [from, to] = self.ends;
        let looks = (0..=20_000).map(|k| from + (to - from) * f64::from(k) / 20_000.0);
        looks.map(|at| self.transmission(at)).fold(90.0, f64::min)
    }
}

/// A linkage that reaches every pair but errs between them by more than a tenth of the swing does
/// not follow its function.
#[test]
fn straying_between_pairs_is_structural_error() {
    let planted = KnownRange {
        output: Output::Angle,
        lengths: [1.2, 0.9, 0.8],
        side: 1.0,
        ends: [20.0, 60.0],
    };
    // A wave that is zero at all three pairs: its root mean square is its height divided by the
    // root of 2.
    let judged = |part: f64| {
        let mut task = planted.task();
        let TaskKind::Function(function) = &mut task.kind else {
            unreachable!("it is a function")
        };
        let pairs = function.between.iter().map(|pair| pair[1]);
        let (low, high) = pairs.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| {
            (low.min(y), high.max(y))
        });
        let height = part * (high - low) * 2.0_f64.sqrt();
        for [x, y] in &mut function.between {
            *y += height * ((*x - 20.0) / 20.0 * std::f64::consts::PI).sin();
        }
        let search = FunctionSearch {
            task: function,
            threads: 1,
        };
        let found = search.run(&mut |_| true).found;
        let judged = found.iter().map(|one| Candidate::evaluate(&task, one));
        let nearest = |a: &Candidate, b: &Candidate| a.figures.rms.total_cmp(&b.figures.rms);
        let driven = judged.filter(|one| one.figures.rms > 0.0);
        (driven.min_by(nearest).expect("it is found"), high - low)
    };
    let (near, swing) = judged(0.08);
    assert_eq!(near.defects, []);
    assert!((near.figures.rms - 0.08 * swing).abs() < 2e-3 * swing);
    let (far, _) = judged(0.14);
    assert_eq!(far.defects, [TaskDefect::StructuralError]);
}

/// For a swinging linkage, the solver may count the crank's angle from another turn than the task
/// does.
#[test]
fn minimum_transmission_angle_is_over_task_range() {
    let swings = |ends| KnownRange {
        output: Output::Angle,
        lengths: [1.2, 0.9, 0.8],
        side: 1.0,
        ends,
    };
    let slides = |ends| KnownRange {
        output: Output::Slide,
        lengths: [1.0, 0.7, 0.3],
        side: 1.0,
        ends,
    };
    for planted in [
        swings([310.0, 335.0]),
        swings([-50.0, -25.0]),
        swings([385.0, 410.0]),
        swings([320.0, 400.0]),
        slides([370.0, 395.0]),
        slides([-20.0, 40.0]),
    ] {
        let task = planted.task();
        let TaskKind::Function(function) = &task.kind else {
            unreachable!("it is a function")
        };
        let search = FunctionSearch {
            task: function,
            threads: 2,
        };
        let found = search.run(&mut |_| true).found;
        let judged = found.iter().map(|one| Candidate::evaluate(&task, one));
        let good: Vec<Candidate> = judged.filter(|one| one.figures.miss < 1e-9).collect();
        let [one] = &good[..] else { panic!("{good:?}") };
        assert!(one.meets_task() && !one.figures.full_turn, "{one:?}");
        let minimum = planted.min_transmission();
        assert!(
            (one.figures.transmission - minimum).abs() < 1e-3 && minimum > 10.0,
            "{minimum} {one:?}"
        );
    }
}
