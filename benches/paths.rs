//! Linkages for paths of 10 to 36 points: how long a search takes, and how near the best of what it finds comes.
//!
//! `cargo bench --bench paths` prints medians over tasks that are planted from random four-bars with noise of 1 % of
//! the path's size, and a row for each of some shapes drawn by hand.
#![allow(clippy::print_stdout, reason = "the figures are to be read")]

use krank::synthesis::{PathSearch, PathTask, Preferences, Proposal};
use krank::{Vec2, angle};
use std::time::Instant;

/// Planted tasks of each kind.
const TASKS: usize = 24;
/// The noise in parts of the path's size.
const NOISE: f64 = 0.01;

/// Chance of the simplest kind: the tasks are always the same.
struct TestRng(u64);

impl TestRng {
    /// From -1 to 1.
    fn even(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
    }

    fn place(&mut self, maximum: f64) -> Vec2 {
        Vec2::new(maximum * self.even(), maximum * self.even())
    }
}

fn main() {
    // `cargo test --benches` runs this too, to see that it works.
    let is_timed = std::env::args().any(|argument| argument == "--bench");
    let tasks = if is_timed { TASKS } else { 1 };
    println!("{:<34}{:>12}{:>12}", "medians", "rms/size", "s");
    for (closed, timed) in [(false, false), (false, true), (true, false), (true, true)] {
        let mut rng = TestRng(7);
        let all = (0..tasks).map(|k| {
            let (points, turns) = planted(&mut rng, 10 + k * 26 / TASKS.max(2), closed);
            searched(points, closed, timed.then_some(turns), is_timed)
        });
        let (misses, times): (Vec<f64>, Vec<f64>) = all.unzip();
        let name = format!(
            "planted {} {}",
            if closed { "closed" } else { "open" },
            if timed { "with times" } else { "without times" }
        );
        println!("{name:<34}{:>12.2e}{:>12.3}", median(misses), median(times));
    }
    for (name, closed, curve) in SHAPES {
        for timed in [false, true] {
            let count = 24_u32;
            let last = if closed { count } else { count - 1 };
            let part = |j: u32| f64::from(j) / f64::from(last);
            let points = (0..count).map(|j| curve(part(j))).collect();
            let span = if closed { 360.0 } else { 180.0 };
            let turns = timed.then(|| (0..count).map(|j| span * part(j)).collect());
            let (miss, time) = searched(points, closed, turns, is_timed);
            let name = format!("{name}{}", if timed { " with times" } else { "" });
            println!("{name:<34}{miss:>12.2e}{time:>12.3}");
        }
    }
}

/// A curve by the part of it that lies behind.
type Curve = fn(f64) -> Vec2;

const SHAPES: [(&str, bool, Curve); 5] = [
    ("ellipse", true, |part| {
        let e = angle::unit(360.0 * part);
        Vec2::new(2.0 * e.x, e.y)
    }),
    ("figure of eight", true, |part| {
        Vec2::new(
            2.0 * angle::unit(360.0 * part).y,
            0.7 * angle::unit(720.0 * part).y,
        )
    }),
    ("D", true, |part| drawn_d(part, 1.0)),
    ("line with a low return", true, |part| drawn_d(part, 0.5)),
    ("line", false, |part| Vec2::new(part, 0.0)),
];

fn drawn_d(part: f64, height: f64) -> Vec2 {
    if part < 0.5 {
        return Vec2::new(4.0 * part - 1.0, 0.0);
    }
    let e = angle::unit(360.0 * (part - 0.5));
    Vec2::new(e.x, height * e.y)
}

/// Points of a random four-bar's tracer, and the crank's turns, with noise.
fn planted(rng: &mut TestRng, count: usize, closed: bool) -> (Vec<Vec2>, Vec<f64>) {
    loop {
        let (a, d, arm) = (rng.place(3.0), rng.place(3.0), rng.place(1.5));
        let mut length = || 10_f64.powf(0.5 * rng.even());
        let [crank, coupler, rocker] = [length(), length(), length()];
        let (start, sign) = (180.0 * rng.even(), rng.even().signum());
        let span = if closed {
            360.0
        } else {
            200.0 + 110.0 * rng.even()
        };
        let at = |turn: f64| {
            let b = a + angle::unit(start + turn) * crank;
            let g = d - b;
            let x = 0.5 * (g.norm2() + coupler * coupler - rocker * rocker) / g.norm2();
            let h2 = coupler * coupler / g.norm2() - x * x;
            let along = g * x + g.perp() * (sign * h2.sqrt());
            (h2 * g.norm2() > 1e-3 * coupler * coupler).then(|| b + along.turned(arm))
        };
        let intervals = if closed { count } else { count - 1 } as f64;
        let turns: Vec<f64> = (0..count).map(|j| span * j as f64 / intervals).collect();
        let closes = (0..=90).all(|k| at(span * f64::from(k) / 90.0).is_some());
        let points: Option<Vec<Vec2>> = turns.iter().map(|turn| at(*turn)).collect();
        let Some(points) = points.filter(|points| closes && size(points) > 0.3) else {
            continue;
        };
        // Even noise from -1 to 1 in each direction has a mean square of 2/3.
        let noise = NOISE * size(&points) * 1.5_f64.sqrt();
        let points = points.iter().map(|p| *p + rng.place(noise)).collect();
        return (points, turns);
    }
}

/// The least root of the mean square of the misses, in parts of the size, and the seconds.
fn searched(
    points: Vec<Vec2>,
    closed: bool,
    turns: Option<Vec<f64>>,
    is_timed: bool,
) -> (f64, f64) {
    let task = PathTask {
        weights: vec![1.0; points.len()],
        points,
        closed,
        turns,
        pivots: Vec::new(),
    };
    let search = PathSearch {
        task: &task,
        four_bars: true,
        slider_cranks: false,
        preferences: Preferences::default(),
        seed: 1,
        threads: 2,
        starts: if is_timed { PathSearch::STARTS } else { 4 },
    };
    let start = Instant::now();
    let found = search.run(&mut |_| true).found;
    let took = start.elapsed().as_secs_f64();
    let misses = found.iter().map(|proposal| rms(proposal, &task.points));
    (misses.fold(f64::INFINITY, f64::min), took)
}

fn rms(proposal: &Proposal, points: &[Vec2]) -> f64 {
    let (Some([b, c]), Some(tracer)) = (proposal.places.first(), proposal.tracer) else {
        return f64::INFINITY;
    };
    let coupler = *c - *b;
    let arm = (tracer - *b).turned(coupler.conj()) * (1.0 / coupler.norm2());
    let squares: f64 = proposal
        .places
        .iter()
        .zip(points)
        .map(|([b, c], point)| (*b + (*c - *b).turned(arm) - *point).norm2())
        .sum();
    (squares / points.len() as f64).sqrt() / size(points)
}

/// The larger side of the box around the points.
fn size(points: &[Vec2]) -> f64 {
    let side = |of: fn(&Vec2) -> f64| {
        let maximum = points.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
        maximum - points.iter().map(of).fold(f64::INFINITY, f64::min)
    };
    side(|p| p.x).max(side(|p| p.y))
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
