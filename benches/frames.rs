//! What a frame of the workbench costs while it plays: solving with bounds, drawing with every layer,
//! the tables, and the bytes for the terminal.
//!
//! `cargo bench --bench frames` prints the median time of a frame.
#![allow(clippy::print_stdout, reason = "the times are to be read")]

mod median;

use krank::drawing::Glyphs;
use krank::scene::{Scene, presets};
use krank::solver::Solver;
use krank::tui::{Colours, OpenedScene, Origin, Workbench};
use median::median_time;
use std::time::Duration;

/// Names, arrows, traces, ghosts, centres of mass and guides, as far as the opening has them off.
const EVERY_LAYER: &str = "v A T G c d";
/// A frame at 30 a second.
const FRAME: Duration = Duration::from_micros(33_334);

fn workbench(name: &str, cols: u16, rows: u16) -> Workbench {
    let preset = presets::find(name).expect("the preset is built in");
    let scene = Scene::parse(preset.text, preset.name).expect("a preset is a scene");
    let solver = Solver::new(&scene.mechanism).expect("a preset can be solved");
    let opened = OpenedScene {
        scene,
        solver,
        origin: Origin::Preset(name.to_owned()),
    };
    Workbench::new(opened, Glyphs::Braille, Colours::Sixteen, cols, rows)
}

fn main() {
    // `cargo test --benches` runs this too, to see that it works.
    let is_timed = std::env::args().any(|argument| argument == "--bench");
    let frames = if is_timed { 1001 } else { 1 };
    for (cols, rows) in [(80, 24), (200, 60)] {
        for name in ["four-bar", "jansen-leg"] {
            for (what, keys) in [("as it opens", "space"), ("every layer", EVERY_LAYER)] {
                let mut workbench = workbench(name, cols, rows);
                workbench.press(keys);
                workbench.press(if keys == "space" { "" } else { "space" });
                workbench.paint();
                let time = median_time(frames, || {
                    workbench.pass(FRAME);
                    workbench.paint().len()
                });
                println!(
                    "{cols:>3} x {rows}  {name:<10}  {what}  {:>8.1} us",
                    1e6 * time
                );
            }
        }
    }
}
