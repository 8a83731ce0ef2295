//! Tests the drawing of the workbench over a whole turn: the ground and the scale stay fixed.

use crate::Body;
use crate::capability::{Capability, Colours};
use crate::drawing::{CharCell, Glyphs, Raster, Role};
use crate::scene::presets;
use crate::tui::document::opening;
use crate::tui::workbench::Workbench;
use ratatui::layout::{Position, Size};
use std::collections::BTreeMap;
use std::time::Duration;

/// Number of frames in a turn, which takes four seconds.
const FRAMES: u32 = 24;

/// Opens a preset and starts playback.
fn playing(preset: &str, glyphs: Glyphs, (cols, rows): (u16, u16)) -> Workbench {
    let capability = Capability {
        glyphs,
        colours: Colours::Sixteen,
        modern: true,
    };
    let opened = opening::preset(presets::find(preset).unwrap()).unwrap();
    let mut workbench = Workbench::on(opened, None, capability, Size::new(cols, rows));
    workbench.paint();
    workbench.press("space");
    workbench
}

/// Calls `check` for each frame of a turn, the first one included.
fn over_a_turn(workbench: &mut Workbench, mut check: impl FnMut(&Workbench)) {
    for _ in 0..=FRAMES {
        workbench.paint();
        check(workbench);
        workbench.pass(Duration::from_secs(4) / FRAMES);
    }
}

/// Returns `true` for a cell of the ground. The stops of a moving guide look like a fixed guide, so
/// guides count only if all of them are fixed.
fn is_ground(cell: CharCell, are_guides_fixed: bool) -> bool {
    match cell.role {
        Role::Ground | Role::GroundPin => true,
        Role::Guide => are_guides_fixed,
        _ => false,
    }
}

/// Returns the cells of a drawing with their columns and rows.
fn cells(raster: &Raster) -> impl Iterator<Item = (i32, i32, CharCell)> {
    let lines = (0..).zip(raster.lines());
    lines.flat_map(|(row, line)| (0..).zip(line).map(move |(col, cell)| (col, row, *cell)))
}

/// Returns `true` if a part above the ground hides it in a cell: a moving part, or a name with the
/// blanks next to it.
fn is_covered(raster: &Raster, col: i32, row: i32) -> bool {
    let cell = |col| raster.cell(col, row).unwrap_or(CharCell::EMPTY);
    let is_name = |cell: CharCell| matches!(cell.role, Role::Label | Role::LinkName(_));
    match cell(col).role {
        Role::Empty => is_name(cell(col - 1)) || is_name(cell(col + 1)),
        Role::Ghost | Role::Echo | Role::Trace => false,
        _ => true,
    }
}

/// Regression: while the crank turned, the ground of 4 presets moved between up to 18 places.
#[test]
fn ground_and_scale_stay_fixed_over_a_turn() {
    let screens = [
        ((80, 24), Glyphs::Ascii),
        ((120, 40), Glyphs::Braille),
        ((40, 12), Glyphs::Ascii),
    ];
    let mut moved = Vec::new();
    for preset in presets::all() {
        for (size, glyphs) in screens {
            let mut workbench = playing(preset.name, glyphs, size);
            let window =
                |workbench: &Workbench| workbench.place(Position::new(2, 2)).unwrap().window;
            let seen = window(&workbench);
            let mut frames = Vec::new();
            over_a_turn(&mut workbench, |workbench| {
                if window(workbench) != seen {
                    moved.push(format!(
                        "{}, {size:?}: {:?}",
                        preset.name,
                        window(workbench)
                    ));
                }
                frames.push(workbench.drawing().clone());
            });
            let grounds = frames.iter().flat_map(cells);
            let mut slides = workbench
                .app()
                .open_scene()
                .scene()
                .mechanism
                .slides()
                .iter();
            let are_fixed = slides.all(|slide| slide.on == Body::Ground);
            let grounds = grounds.filter(|(.., cell)| is_ground(*cell, are_fixed));
            let grounds = grounds.map(|(col, row, cell)| ((col, row), cell));
            let grounds: BTreeMap<(i32, i32), CharCell> = grounds.collect();
            assert!(!grounds.is_empty(), "{}", preset.name);
            for frame in &frames {
                let differs = grounds.iter().find(|((col, row), cell)| {
                    frame.cell(*col, *row) != Some(**cell) && !is_covered(frame, *col, *row)
                });
                if let Some(differs) = differs {
                    moved.push(format!("{}, {size:?}: {differs:?}", preset.name));
                }
            }
        }
    }
    moved.dedup();
    assert!(moved.is_empty(), "{moved:#?}");
}
