//! Tests the places of names over whole motions: they rarely change sides, and hide nothing.

use super::*;
use crate::drawing::cells::labels::Side;

/// Returns the figure of a linkage with the names of its points, as drawings show it.
fn usual(stage: &DrawingStage, at: f64) -> Figure {
    linkage(
        &stage.scene,
        &stage.reach,
        &stage.state(at),
        Layers::default(),
    )
}

/// Plans the labels of a stage, beginning where the scene opens.
fn planned(stage: &DrawingStage, view: &WorldView, glyphs: Glyphs) -> Labels {
    let mut labels = Labels::default();
    let start = stage.scene.mechanism.driver().start;
    let mut raster = Raster::new();
    render_into(&usual(stage, start), view, glyphs, &mut labels, &mut raster);
    labels.plan(&stage.reach, start, view, glyphs, |at| usual(stage, at));
    labels
}

/// Returns the number of names that hide a part of a bar, a mark or an arrow.
fn covering(figure: &Figure, view: &WorldView, glyphs: Glyphs, labels: &Labels) -> usize {
    let mut plain = Raster::new();
    crate::drawing::cells::render::render_bare(figure, view, glyphs, &mut plain);
    let covers = |(text, at, right, down): &(&str, Vec2, i32, i32)| {
        let (col, row) = cell(view, *at);
        let mut cells = (0..).zip(text.chars());
        cells.any(|(k, _)| {
            let role = plain
                .cell(col + right + k, row + down)
                .map(|cell| cell.role);
            role.is_some_and(|role| !role.is_behind() && role != Role::Empty && role != Role::Guide)
        })
    };
    labels.placed_names(figure, view).filter(covers).count()
}

/// Of this many names in frames, at most one hides a part of a bar or has no place for a frame.
const MAX_COVERING: usize = 150;

/// Removes single frames without the name, between two frames with it on one side, and returns their
/// number.
fn fill_gaps(sides: &mut [Side]) -> usize {
    let mut gaps = 0;
    for k in 1..sides.len().saturating_sub(1) {
        if sides[k] == Side::Hidden && sides[k - 1] == sides[k + 1] && sides[k - 1] != sides[k] {
            sides[k] = sides[k - 1];
            gaps += 1;
        }
    }
    gaps
}

/// Asserts that no name changes sides more than twice in a cycle or from limit to limit, and that
/// names lie on bars, or have no place, only for moments. Appearing and disappearing for more than a
/// frame counts as a change, too.
fn assert_calm((cols, rows): (u16, u16), glyphs: Glyphs) {
    let (mut restless, mut covered) = (Vec::new(), Vec::new());
    for stage in DrawingStage::presets() {
        let view = WorldView::fit(&stage.reach, cols, rows, 2.0);
        let mut labels = planned(&stage, &view, glyphs);
        let mut raster = Raster::new();
        let mut sides: Vec<Vec<Side>> = Vec::new();
        let mut on_bars = 0;
        for state in stage.motion().step_by(2) {
            labels.go(&stage.reach, state.at());
            let figure = linkage(&stage.scene, &stage.reach, &state, Layers::default());
            render_into(&figure, &view, glyphs, &mut labels, &mut raster);
            sides.resize_with(labels.len(), Vec::new);
            for (sides, side) in sides.iter_mut().zip(labels.sides()) {
                sides.push(side);
            }
            on_bars += covering(&figure, &view, glyphs, &labels);
        }
        let gaps: usize = sides.iter_mut().map(|sides| fill_gaps(sides)).sum();
        let count = |sides: &Vec<Side>| sides.windows(2).filter(|w| w[0] != w[1]).count();
        let changes: Vec<usize> = sides.iter().map(count).collect();
        if changes.iter().any(|changes| *changes > 2) {
            restless.push(format!("{}: {changes:?}", stage.name));
        }
        // Where no place on its side is free, a bar passes below a name.
        let frames = 101 * changes.len();
        if (on_bars + gaps) * MAX_COVERING > frames {
            covered.push(format!("{}: {on_bars} and {gaps} of {frames}", stage.name));
        }
    }
    assert!(restless.is_empty(), "{cols} x {rows}: {restless:#?}");
    assert!(covered.is_empty(), "{cols} x {rows}: {covered:#?}");
}

/// Regression: names changed sides 18 times a turn on the press, and 24 times on Peaucellier's cell.
#[test]
fn names_change_sides_at_most_twice_per_cycle() {
    assert_calm((80, 24), Glyphs::Ascii);
}

#[test]
fn names_change_sides_at_most_twice_in_large_view() {
    assert_calm((120, 40), Glyphs::Braille);
}

#[test]
fn names_change_sides_at_most_twice_in_small_view() {
    assert_calm((40, 12), Glyphs::Ascii);
}

/// Every name of a textbook linkage has a free place, with a plan and without one.
#[test]
fn every_name_of_textbook_linkages_is_shown() {
    let crowded = ["scissor-lift"];
    let mut hidden = Vec::new();
    for stage in DrawingStage::presets() {
        if crowded.iter().any(|name| stage.name.contains(name)) {
            continue;
        }
        let view = WorldView::fit(&stage.reach, 80, 24, 2.0);
        let mut raster = Raster::new();
        for mut labels in [Labels::default(), planned(&stage, &view, Glyphs::Ascii)] {
            for state in stage.motion() {
                labels.go(&stage.reach, state.at());
                let figure = linkage(&stage.scene, &stage.reach, &state, Layers::default());
                render_into(&figure, &view, Glyphs::Ascii, &mut labels, &mut raster);
                if labels.hidden() > 0 {
                    let (name, at, plan) = (&stage.name, state.at(), labels.is_planned());
                    hidden.push(format!("{name} at {at:.1}, plan {plan}"));
                }
            }
        }
    }
    assert!(hidden.is_empty(), "{hidden:#?}");
}

/// Prints how often names touch other parts over whole motions.
#[test]
#[ignore = "prints a measurement"]
fn measure_names() {
    let wanted = std::env::var("KRANK_STAGE").unwrap_or_default();
    let arrows = std::env::var("KRANK_ARROWS").is_ok();
    for ((cols, rows), glyphs) in [
        ((40, 12), Glyphs::Ascii),
        ((80, 24), Glyphs::Ascii),
        ((80, 24), Glyphs::Braille),
        ((120, 40), Glyphs::Braille),
    ] {
        let mut total = [0_usize; 8];
        for stage in DrawingStage::presets() {
            if !stage.name.contains(&wanted) {
                continue;
            }
            let points = usual_arrows(&stage.scene.mechanism);
            let overlay = stage.overlay(&OverlayRequest {
                velocities: points,
                ..OverlayRequest::default()
            });
            let figure_at = |at: f64| {
                let state = stage.state(at);
                let mut figure = linkage(&stage.scene, &stage.reach, &state, Layers::default());
                if arrows {
                    overlay.add_to(&mut figure, &stage.scene, &stage.solver, &state, 1.0);
                }
                figure
            };
            let view = WorldView::fit(&stage.reach, cols, rows, 2.0);
            let mut labels = Labels::default();
            let mut raster = Raster::new();
            let start = stage.scene.mechanism.driver().start;
            if std::env::var("KRANK_FRESH").is_err() {
                render_into(&figure_at(start), &view, glyphs, &mut labels, &mut raster);
            }
            labels.plan(&stage.reach, start, &view, glyphs, figure_at);
            let mut sides: Vec<Vec<Side>> = Vec::new();
            // names, hidden, on a bar, beside a bar, beside a mark, on or beside an arrow, a name
            let mut own = [0_usize; 8];
            let mut plain = Raster::new();
            for state in stage.motion().step_by(3) {
                labels.go(&stage.reach, state.at());
                let figure = figure_at(state.at());
                render_into(&figure, &view, glyphs, &mut labels, &mut raster);
                crate::drawing::cells::render::render_bare(&figure, &view, glyphs, &mut plain);
                sides.resize_with(labels.len(), Vec::new);
                for (sides, side) in sides.iter_mut().zip(labels.sides()) {
                    sides.push(side);
                }
                let spans: Vec<(i32, i32, i32)> = labels
                    .placed_names(&figure, &view)
                    .map(|(text, at, right, down)| {
                        let (col, row) = cell(&view, at);
                        let first = col + right;
                        (row + down, first, first + text.chars().count() as i32)
                    })
                    .collect();
                own[0] += labels.len();
                own[1] += labels.hidden();
                for (k, &(row, from, to)) in spans.iter().enumerate() {
                    let role = |col| plain.cell(col, row).map_or(Role::Empty, |cell| cell.role);
                    let is_bar = |col| role(col).is_body() || role(col) == Role::Spring;
                    let is_arrow = |col| {
                        matches!(role(col), Role::Velocity | Role::Acceleration | Role::Force)
                    };
                    own[2] += usize::from((from..to).any(is_bar));
                    own[3] += usize::from([from - 1, to].into_iter().any(is_bar));
                    own[4] += usize::from([from - 1, to].into_iter().any(|c| role(c).is_mark()));
                    own[5] += usize::from((from - 1..=to).any(is_arrow));
                    let others = spans.iter().enumerate().filter(|(other, _)| *other != k);
                    let touches =
                        |(_, s): (usize, &(i32, i32, i32))| s.0 == row && from <= s.2 && s.1 <= to;
                    own[6] += usize::from(others.map(touches).any(|is| is));
                }
            }
            for sides in &mut sides {
                fill_gaps(sides);
            }
            let count = |sides: &Vec<Side>| sides.windows(2).filter(|w| w[0] != w[1]).count();
            let changes: Vec<usize> = sides.iter().map(count).collect();
            own[7] = changes.iter().filter(|changes| **changes > 2).count();
            println!("{:24} {cols}x{rows} {own:?} {changes:?}", stage.name);
            for (sum, own) in total.iter_mut().zip(own) {
                *sum += own;
            }
        }
        let share = |k: usize| 100.0 * total[k] as f64 / total[0] as f64;
        println!(
            "ALL {cols}x{rows} {glyphs:?}: names {}, hidden {:.2}, on bar {:.2}, by bar {:.2}, \
             by mark {:.2}, arrow {:.2}, name {:.2} %, restless {}",
            total[0],
            share(1),
            share(2),
            share(3),
            share(4),
            share(5),
            share(6),
            total[7]
        );
    }
}
