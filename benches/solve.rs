//! The general solver beside closed forms written by hand for the same mechanisms, in the same run,
//! and a long chain of dyads.
//!
//! `cargo bench` prints criterion's figures and, at the end, the medians side by side. Both sides
//! give position, velocity and acceleration of the same points and the turning of the same links, and
//! are held against each other first.
#![allow(clippy::print_stdout, reason = "the medians are to be read")]

mod handwritten;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group};
use handwritten::{FourBar, Jansen, Joint, Press, SliderCrank, Turning};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Demand, Order, Solver, State};
use krank::{Driver, Input, LinkId, Mechanism, PointId, Vec2};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// How far solver and closed form may be apart, relative to the largest figure of the kind.
const AGREEMENT: f64 = 1e-9;
/// Positions in one sweep.
const SWEEP: usize = 360;
/// Sweeps timed for one sample, and samples for a median.
const REPEATS: u32 = 20;
const SAMPLES: usize = 101;

/// What both sides yield: points and links.
type Figures<const P: usize, const L: usize> = ([Joint; P], [Turning; L]);

/// A preset made ready to yield what a closed form yields.
struct General<const P: usize, const L: usize> {
    solver: Solver,
    points: [PointId; P],
    links: [LinkId; L],
}

impl<const P: usize, const L: usize> General<P, L> {
    fn new(preset: &str, points: [&str; P], links: [&str; L]) -> Self {
        let scene = scene(preset);
        let mechanism = &scene.mechanism;
        let point = |name| {
            let mut ids = mechanism.point_ids();
            ids.find(|&id| scene.point_name(id) == Some(name))
                .expect("a point of the preset")
        };
        let link = |name| {
            let mut ids = mechanism.link_ids();
            ids.find(|&id| scene.link_name(id) == name)
                .expect("a link of the preset")
        };
        let (points, links) = (points.map(point), links.map(link));
        let demand = Demand {
            points: points.to_vec(),
            links: links.to_vec(),
            slides: Vec::new(),
        };
        General {
            solver: Solver::new(mechanism)
                .expect("a preset opens")
                .only(&demand),
            points,
            links,
        }
    }

    #[inline]
    fn read(&self, state: &State) -> Figures<P, L> {
        let joint = |id| Joint {
            p: state.position(id),
            v: state.velocity(id),
            a: state.acceleration(id),
        };
        let turning = |id| Turning {
            omega: state.omega(id),
            alpha: state.alpha(id),
        };
        (self.points.map(joint), self.links.map(turning))
    }

    /// Solves at all angles, without reading anything.
    fn sweep(&self, angles: &[f64], state: &mut State) {
        for &at in angles {
            self.solver.solve(black_box(at), Order::Acceleration, state);
            black_box(&*state);
        }
    }

    /// Solves at all angles and reads everything.
    fn sweep_and_read(&self, angles: &[f64], state: &mut State) {
        for &at in angles {
            self.solver.solve(black_box(at), Order::Acceleration, state);
            black_box(self.read(state));
        }
    }
}

fn scene(preset: &str) -> Scene {
    let preset = presets::find(preset).expect("a preset");
    Scene::parse(preset.text, preset.name).expect("a preset is a sound scene")
}

/// Angles over a turn, in whole steps but off the multiples of 90 degrees.
fn angles() -> Vec<f64> {
    let step = 360.0 / SWEEP as f64;
    (0..SWEEP).map(|k| (k as f64 + 0.37) * step).collect()
}

fn by_hand<const P: usize, const L: usize>(form: impl Fn(f64) -> Figures<P, L>, angles: &[f64]) {
    for &at in angles {
        black_box(form(black_box(at)));
    }
}

/// Holds both sides against each other at every angle.
fn agree<const P: usize, const L: usize>(
    name: &str,
    general: &General<P, L>,
    form: impl Fn(f64) -> Figures<P, L>,
) {
    let mut state = general.solver.state();
    let rows: Vec<_> = angles()
        .into_iter()
        .map(|at| {
            let condition = general.solver.solve(at, Order::Acceleration, &mut state);
            assert_eq!(condition, Condition::Ok, "{name} at {at}");
            (kinds(general.read(&state)), kinds(form(at)))
        })
        .collect();
    for kind in 0..5 {
        let largest = rows
            .iter()
            .flat_map(|(_, hand)| &hand[kind])
            .fold(0.0_f64, |m, v| m.max(v.abs()));
        for (solved, hand) in &rows {
            for (a, b) in solved[kind].iter().zip(&hand[kind]) {
                assert!(
                    (a - b).abs() <= AGREEMENT * largest,
                    "{name}: {a} by the solver, {b} by hand"
                );
            }
        }
    }
}

/// The figures by kind: positions, velocities, accelerations, omegas, alphas.
fn kinds<const P: usize, const L: usize>((joints, links): Figures<P, L>) -> [Vec<f64>; 5] {
    let flat = |of: fn(&Joint) -> Vec2| -> Vec<f64> {
        joints.iter().map(of).flat_map(|v| [v.x, v.y]).collect()
    };
    [
        flat(|j| j.p),
        flat(|j| j.v),
        flat(|j| j.a),
        links.iter().map(|t| t.omega).collect(),
        links.iter().map(|t| t.alpha).collect(),
    ]
}

/// What is done with each mechanism: the closed form inlined in each case.
trait Visitor {
    fn visit<const P: usize, const L: usize>(
        &mut self,
        name: &str,
        general: &General<P, L>,
        form: impl Fn(f64) -> Figures<P, L>,
    );
}

fn visit_all(visitor: &mut impl Visitor) {
    let four_bar = FourBar::new();
    let general = General::new("four-bar", ["B", "C"], ["r3", "r4"]);
    visitor.visit("four-bar", &general, |at| four_bar.solve(at));

    let slider_crank = SliderCrank;
    let general = General::new("slider-crank", ["B", "C"], ["r3"]);
    visitor.visit("slider-crank", &general, |at| slider_crank.solve(at));

    let press = Press::new();
    let general = General::new("press", ["B", "C", "E", "F"], ["r3", "r4", "r5", "r6"]);
    visitor.visit("press", &general, |at| press.solve(at));

    let legs = scene("jansen-leg").mechanism;
    let corner = |link: usize| legs.links()[link].members[2].local;
    let jansen = Jansen::new(corner(2), corner(6));
    let general = General::new(
        "jansen-leg",
        ["M", "X", "W", "Y", "V", "T"],
        ["j", "bde", "k", "c", "f", "ghi"],
    );
    visitor.visit("jansen-leg", &general, |at| jansen.solve(at));
}

struct Agreement;

impl Visitor for Agreement {
    fn visit<const P: usize, const L: usize>(
        &mut self,
        name: &str,
        general: &General<P, L>,
        form: impl Fn(f64) -> Figures<P, L>,
    ) {
        agree(name, general, form);
    }
}

struct Measured<'c>(&'c mut Criterion);

impl Visitor for Measured<'_> {
    fn visit<const P: usize, const L: usize>(
        &mut self,
        name: &str,
        general: &General<P, L>,
        form: impl Fn(f64) -> Figures<P, L>,
    ) {
        let angles = angles();
        let mut state = general.solver.state();
        let mut group = self.0.benchmark_group(name);
        group
            .throughput(Throughput::Elements(SWEEP as u64))
            .warm_up_time(Duration::from_millis(500))
            .measurement_time(Duration::from_secs(2));
        group.bench_function("by hand", |b| b.iter(|| by_hand(&form, &angles)));
        group.bench_function("solved", |b| b.iter(|| general.sweep(&angles, &mut state)));
        group.bench_function("solved and read", |b| {
            b.iter(|| general.sweep_and_read(&angles, &mut state));
        });
        group.finish();
    }
}

/// Medians of samples taken in turn, so that a disturbance meets all sides alike.
struct Ratios;

impl Visitor for Ratios {
    fn visit<const P: usize, const L: usize>(
        &mut self,
        name: &str,
        general: &General<P, L>,
        form: impl Fn(f64) -> Figures<P, L>,
    ) {
        let angles = angles();
        let mut state = general.solver.state();
        let mut samples: [Vec<f64>; 3] = Default::default();
        for _ in 0..SAMPLES {
            samples[0].push(time(|| by_hand(&form, &angles)));
            samples[1].push(time(|| general.sweep(&angles, &mut state)));
            samples[2].push(time(|| general.sweep_and_read(&angles, &mut state)));
        }
        let [hand, solved, read] = samples.map(median);
        println!(
            "{name:<14}{hand:>10.1} ns{solved:>10.1} ns{read:>10.1} ns{:>9.2}{:>9.2}",
            solved / hand,
            read / hand
        );
    }
}

/// Nanoseconds per position of a sweep.
fn time(mut sweep: impl FnMut()) -> f64 {
    let begin = Instant::now();
    for _ in 0..REPEATS {
        sweep();
    }
    begin.elapsed().as_nanos() as f64 / (f64::from(REPEATS) * SWEEP as f64)
}

fn median(mut samples: Vec<f64>) -> f64 {
    samples.sort_by(f64::total_cmp);
    samples[samples.len() / 2]
}

/// A chain of four-bars, each driven by the rocker of the one before: rockers of length 1 on pivots
/// a unit apart, coupled by bars of length 1, the first one moved by a short crank.
fn chain(dyads: usize) -> Mechanism {
    let mut builder = Mechanism::builder();
    let pivot = builder.ground_point(-1.0, 1.0);
    let mut pin = builder.moving_point();
    let crank = builder.link(pivot, pin, 0.2);
    builder.driver(Driver {
        input: Input::Turn(crank),
        start: 90.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    for k in 0..dyads {
        let x = k as f64;
        let foot = builder.ground_point(x, 0.0);
        let joint = builder.moving_point();
        builder.link(pin, joint, 1.0);
        builder.link(foot, joint, 1.0);
        builder.start(joint, Vec2::new(x, 1.0));
        pin = joint;
    }
    builder.build().expect("a sound chain")
}

const CHAINS: [usize; 4] = [1, 10, 100, 1000];

fn chains(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("chain");
    group
        .sample_size(10)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2));
    for dyads in CHAINS {
        let mechanism = chain(dyads);
        group.bench_function(BenchmarkId::new("open", dyads), |b| {
            b.iter(|| Solver::new(black_box(&mechanism)));
        });
        let solver = Solver::new(&mechanism).expect("the chain closes");
        let mut state = solver.state();
        let mut at = 0.0;
        group.bench_function(BenchmarkId::new("solve", dyads), |b| {
            b.iter(|| {
                at += 1.0;
                solver.solve(at, Order::Acceleration, &mut state)
            });
        });
    }
    group.finish();
}

fn print_chains() {
    println!(
        "\n{:<14}{:>13}{:>16}{:>18}",
        "dyads", "open", "solve", "solve per dyad"
    );
    for dyads in CHAINS {
        let mechanism = chain(dyads);
        let runs = if dyads >= 1000 { 5 } else { 21 };
        let opening = (0..runs).map(|_| {
            let begin = Instant::now();
            black_box(Solver::new(black_box(&mechanism)).expect("the chain closes"));
            begin.elapsed().as_secs_f64() * 1e3
        });
        let opening = median(opening.collect());
        let solver = Solver::new(&mechanism).expect("the chain closes");
        let mut state = solver.state();
        let mut at = 0.0;
        let solving = (0..SAMPLES).map(|_| {
            let begin = Instant::now();
            for _ in 0..REPEATS {
                at += 1.0;
                solver.solve(black_box(at), Order::Acceleration, &mut state);
            }
            begin.elapsed().as_nanos() as f64 / f64::from(REPEATS)
        });
        let solving = median(solving.collect());
        println!(
            "{dyads:<14}{opening:>10.2} ms{solving:>13.0} ns{:>15.1} ns",
            solving / dyads as f64
        );
    }
}

fn beside_closed_forms(criterion: &mut Criterion) {
    visit_all(&mut Measured(criterion));
}

criterion_group!(benches, beside_closed_forms, chains);

fn main() {
    visit_all(&mut Agreement);
    benches();
    Criterion::default().configure_from_args().final_summary();
    // `cargo test --benches` runs this too, to see that it works; then nothing is timed.
    if std::env::args().any(|argument| argument == "--bench") {
        println!("\nmedians per position: points and links with both rates");
        println!(
            "{:<14}{:>13}{:>13}{:>13}{:>9}{:>9}",
            "", "by hand", "solved", "and read", "ratio", "and read"
        );
        visit_all(&mut Ratios);
        print_chains();
    }
}
