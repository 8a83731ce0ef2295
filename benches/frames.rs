//! What a frame of the workbench costs while it plays: solving with bounds, drawing with every layer,
//! the tables, and the bytes for the terminal.

use criterion::{Criterion, criterion_group, criterion_main};
use krank::drawing::Glyphs;
use krank::scene::{Scene, presets};
use krank::solver::Solver;
use krank::tui::{Colours, Opened, Origin, Workbench};
use std::hint::black_box;
use std::time::Duration;

/// Names, arrows, traces, ghosts, centres of mass and guides, as far as the opening has them off.
const EVERY_LAYER: &str = "v A T G c d";
/// A frame at 30 a second.
const FRAME: Duration = Duration::from_micros(33_334);

fn workbench(name: &str, cols: u16, rows: u16) -> Workbench {
    let preset = presets::find(name).expect("the preset is built in");
    let scene = Scene::parse(preset.text, preset.name).expect("a preset is a scene");
    let solver = Solver::new(&scene.mechanism).expect("a preset can be solved");
    let opened = Opened {
        scene,
        solver,
        origin: Origin::Preset(name.to_owned()),
    };
    Workbench::new(opened, Glyphs::Braille, Colours::Sixteen, cols, rows)
}

fn frames(c: &mut Criterion) {
    for (cols, rows) in [(80, 24), (200, 60)] {
        let mut group = c.benchmark_group(format!("{cols}x{rows}"));
        for name in ["four-bar", "jansen-leg"] {
            for (what, keys) in [("as it opens", "space"), ("every layer", EVERY_LAYER)] {
                let mut workbench = workbench(name, cols, rows);
                workbench.press(keys);
                workbench.press(if keys == "space" { "" } else { "space" });
                workbench.paint();
                group.bench_function(format!("{name}, {what}"), |b| {
                    b.iter(|| {
                        workbench.pass(FRAME);
                        black_box(workbench.paint().len())
                    });
                });
            }
        }
        group.finish();
    }
}

criterion_group!(benches, frames);
criterion_main!(benches);
