//! No bound is ever smaller than the true error; and how much larger it is.
//!
//! The truth is the same state in twice the precision.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use krank::quantity::{Aspect, Catalogue, Quantity};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Range, Solver, State};
use krank::{Ball, Double};

/// Everything that one scene is held against.
struct Bench {
    solver: Solver,
    quantities: Vec<Quantity>,
    state: State,
    enclosure: State<Ball>,
    twice: State<Double>,
}

/// What came of many figures of one kind.
#[derive(Default)]
struct Tally {
    checked: usize,
    unproved: usize,
    over: [Vec<f64>; 3],
}

impl Tally {
    fn medians(&mut self) -> [f64; 3] {
        self.over.each_mut().map(|over| {
            over.sort_by(f64::total_cmp);
            over.get(over.len() / 2).copied().unwrap_or(f64::NAN)
        })
    }
}

impl Bench {
    fn new(scene: &Scene) -> Option<Bench> {
        let solver = Solver::new(&scene.mechanism).ok()?;
        Some(Bench {
            quantities: Catalogue::new(scene).all().to_vec(),
            state: solver.state(),
            enclosure: solver.enclosure(),
            twice: solver.twice(),
            solver,
        })
    }

    /// Holds every bound at one coordinate against the true error.
    fn check(&mut self, at: f64, tally: &mut Tally) {
        let order = Order::Acceleration;
        if self.solver.solve(at, order, &mut self.state) != Condition::Ok {
            return;
        }
        self.solver.enclose(&self.state, order, &mut self.enclosure);
        if !self.solver.solve_twice(&self.state, order, &mut self.twice) {
            return;
        }
        for q in &self.quantities {
            let (Some(value), Some(truth)) = (q.value(&self.state), q.value(&self.twice)) else {
                continue;
            };
            tally.checked += 1;
            let Some(bound) = q.bound(&self.state, &self.enclosure) else {
                tally.unproved += 1;
                continue;
            };
            let mut error = (truth - Double::exactly(value)).hi.abs();
            if q.aspect == Aspect::Angle && error > 180.0 {
                error = (error - 360.0).abs();
            }
            assert!(
                error <= bound,
                "{} at {at}: off by {error:e}, bound {bound:e}",
                q.name
            );
            if error > 0.0 {
                tally.over[q.aspect.order() as usize].push(bound / error);
            }
        }
    }
}

#[test]
fn every_figure_of_every_preset_is_within_its_bound() {
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let mut bench = Bench::new(&scene).unwrap();
        let (low, high) = match bench.solver.motion().range {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        };
        let mut tally = Tally::default();
        for k in 0..=500 {
            bench.check(low + (high - low) * f64::from(k) / 500.0, &mut tally);
        }
        let [x, v, a] = tally.medians();
        println!(
            "{:24} {:6} figures, {:4} unproved; bound over error, median: {x:.1} {v:.1} {a:.1}",
            preset.name, tally.checked, tally.unproved
        );
    }
}
