//! What people wait for with a scene of 4,901 links: opening it, the first frame, a report and all columns of a cycle.
//!
//! `cargo bench --bench large` prints seconds of each, the least of a few runs.
#![allow(clippy::print_stdout, reason = "the times are to be read")]

use krank::drawing::Glyphs;
use krank::quantity::Catalogue;
use krank::report::{CycleReport, Report, ReportFormat};
use krank::scene::Scene;
use krank::solver::{Condition, Order, Solver};
use krank::tui::{Colours, OpenedScene, Origin, Workbench};
use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

/// Runs of which the shortest counts.
const RUNS: usize = 3;

/// Returns a scene of four-bars on one crank.
fn parallel_dyads(dyads: usize) -> String {
    let mut text = String::from("unit = \"mm\"\n[ground]\nA = [0, 0]\n");
    for i in 0..dyads {
        let _ = writeln!(text, "D{i} = [{}, {}]", 400 + i % 7, i % 11);
    }
    text += "[driver]\nlink = \"r2\"\nangle = 60\nspeed = \"1 rad/s\"\n[links]\n\
             r2 = { from = \"A\", to = \"B\", length = 100 }\n";
    for i in 0..dyads {
        let _ = writeln!(
            text,
            "c{i} = {{ from = \"B\", to = \"C{i}\", length = 300 }}\n\
             r{} = {{ from = \"C{i}\", to = \"D{i}\", length = 250 }}",
            i + 3
        );
    }
    text += "[start]\n";
    for i in 0..dyads {
        let _ = writeln!(text, "C{i} = [310, 230]");
    }
    text
}

fn main() {
    // `cargo test --benches` runs this too, to see that it works.
    let is_timed = std::env::args().any(|argument| argument == "--bench");
    let text = parallel_dyads(if is_timed { 2450 } else { 5 });
    let open = || {
        let scene = Scene::parse(&text, "large").expect("it is a scene");
        let solver = Solver::new(&scene.mechanism).expect("it closes");
        (scene, solver)
    };
    timed("open", open);
    timed("open and first frame", || {
        let (scene, solver) = open();
        let opened = OpenedScene {
            scene,
            solver,
            origin: Origin::Stdin,
        };
        Workbench::new(opened, Glyphs::Braille, Colours::Sixteen, 200, 60)
            .paint()
            .len()
    });
    let (scene, solver) = open();
    timed("report", || {
        let mut state = solver.state();
        let condition = solver.solve(60.0, Order::Force, &mut state);
        assert_eq!(condition, Condition::Ok);
        solver.enclose(&mut state, Order::Force, &mut solver.enclosure());
        let report = Report::new(&scene, &solver, &state, 6);
        report.written(ReportFormat::Html, false).len()
    });
    let columns = Catalogue::new(&scene).figures();
    timed("cycle of all columns", || {
        CycleReport::new(&scene, &solver, &columns, None)
    });
}

fn timed<T>(name: &str, mut run: impl FnMut() -> T) {
    let times = (0..RUNS).map(|_| {
        let start = Instant::now();
        drop(black_box(run()));
        start.elapsed().as_secs_f64()
    });
    println!("{name:<24}{:>8.3} s", times.fold(f64::INFINITY, f64::min));
}
