//! Snapshots of the drawings of presets. They are meant to be looked at: a change that makes one of
//! them worse to read is a bug.

use krank::drawing::{
    Extents, Figure, Glyphs, Labels, Layers, Raster, WorldView, linkage, render, render_into,
};
use krank::scene::{Scene, presets};
use krank::solver::{Order, Solver, State};
use krank::{PointId, Vec2};

/// Draws a scene at a driver coordinate, in the window that fits its motion.
fn drawn(
    text: &str,
    at: Option<f64>,
    (cols, rows): (u16, u16),
    layers: Layers,
) -> (Scene, State, WorldView, Figure) {
    let scene = Scene::parse(text, "a preset").expect("the scene reads");
    let solver = Solver::new(&scene.mechanism).expect("the scene moves");
    let mut state = solver.state();
    let at = at.unwrap_or(scene.mechanism.driver().start);
    let _ = solver.solve(at, Order::Position, &mut state);
    let extents = Extents::of(&scene, &solver);
    let view = WorldView::fit(&extents, cols, rows, 2.0);
    let figure = linkage(&scene, &extents, state.state(), layers);
    let state = state.state().clone();
    (scene, state, view, figure)
}

/// Renders a preset at a driver coordinate, in a frame.
fn picture(
    preset: &str,
    at: f64,
    (cols, rows): (u16, u16),
    glyphs: Glyphs,
    layers: Layers,
) -> String {
    let text = presets::find(preset).expect("the preset is there").text;
    let (_, _, view, figure) = drawn(text, Some(at), (cols, rows), layers);
    // The frame makes blank rows and columns visible in the snapshot.
    let raster = render(&figure, &view, glyphs);
    let edge = format!("+{}+\n", "-".repeat(usize::from(cols)));
    let line = |line: &str| format!("|{line:<width$}|\n", width = usize::from(cols));
    let lines: String = raster.text().lines().map(line).collect();
    format!("{edge}{lines}{edge}")
}

macro_rules! pictures {
    ($($test:ident: $preset:literal at $at:literal in $size:expr, $glyphs:ident;)*) => {
        $(#[test]
        fn $test() {
            let layers = Layers::default();
            insta::assert_snapshot!(picture($preset, $at, $size, Glyphs::$glyphs, layers));
        })*
    };
}

pictures! {
    four_bar_dots: "four-bar" at 60.0 in (50, 18), Braille;
    slider_crank: "slider-crank" at 30.0 in (80, 24), Ascii;
    press_ram: "press-ram" at 60.0 in (80, 24), Ascii;
    scotch_yoke: "scotch-yoke" at 60.0 in (60, 20), Ascii;
    whitworth: "whitworth" at 60.0 in (80, 24), Line;
    jansen_dots: "jansen-leg" at 60.0 in (50, 18), Braille;
    jansen_small: "jansen-leg" at 60.0 in (40, 12), Ascii;
    excavator_dots: "excavator-boom" at 2.0 in (80, 24), Braille;
    scissor: "scissor-lift" at 1.7 in (100, 40), Ascii;
}

#[test]
fn centres_of_mass_and_names_of_links() {
    let layers = Layers {
        links: true,
        centres: true,
        ..Layers::default()
    };
    let text = picture("four-bar", 60.0, (80, 24), Glyphs::Ascii, layers);
    insta::assert_snapshot!(text);
}

const SIZES: [(u16, u16); 4] = [(120, 40), (80, 24), (50, 18), (40, 12)];

/// Line glyphs show the same drawing as ASCII, cell by cell.
#[test]
fn line_glyphs_match_ascii_cell_by_cell() {
    for preset in presets::all() {
        for size in SIZES {
            let (_, _, view, figure) = drawn(preset.text, None, size, Layers::default());
            let lines = render(&figure, &view, Glyphs::Line).text();
            let spelled = lines.replace('─', "-").replace('│', "|").replace('▒', "#");
            let characters = render(&figure, &view, Glyphs::Ascii).text();
            assert_eq!(spelled, characters, "{}", preset.name);
            // A drawing such as that of the five-bar can have oblique lines only.
            let is_straight = characters.contains(['-', '|']);
            assert_eq!(lines.contains(['─', '│']), is_straight, "{}", preset.name);
        }
    }
}

/// Returns `true` if the cell of this place, or a neighbour of it, is not blank.
fn is_drawn(raster: &Raster, position: Vec2) -> bool {
    let (col, row) = (position.x.floor() as i32, position.y.floor() as i32);
    let near = [(0, 0), (-1, 0), (1, 0), (0, -1), (0, 1)];
    let cells = near.map(|(right, down)| raster.cell(col + right, row + down));
    cells.into_iter().flatten().any(|cell| cell.glyph != ' ')
}

/// A link has no gap between its two joints.
#[test]
fn every_link_is_drawn_without_gaps() {
    for preset in presets::all() {
        for (size, glyphs) in SIZES.into_iter().flat_map(|size| {
            [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille].map(|glyphs| (size, glyphs))
        }) {
            let plain = Layers {
                points: false,
                ground: false,
                ..Layers::default()
            };
            let (scene, state, view, figure) = drawn(preset.text, None, size, plain);
            let raster = render(&figure, &view, glyphs);
            let place = |point: PointId| view.cell(state.position(point).expect("it is placed"));
            for link in scene.mechanism.links() {
                let solid = link.members.iter().filter(|m| link.com != Some(m.point));
                let [from, to] = solid.map(|m| place(m.point)).collect::<Vec<_>>()[..] else {
                    continue;
                };
                let steps = (to - from).norm().ceil().max(1.0);
                let gap = (0..=steps as u32)
                    .map(|k| from + (to - from) * (f64::from(k) / steps))
                    .find(|place| !is_drawn(&raster, *place));
                assert_eq!(gap, None, "{} {glyphs:?}\n{}", preset.name, raster.text());
            }
        }
    }
}

/// A support is a triangle above hatching; on a small screen only the hatching.
#[test]
fn ground_joints_have_triangles_only_on_larger_screens() {
    for (size, triangles) in [((80, 24), 2), ((50, 18), 2), ((40, 12), 0)] {
        let text = picture("four-bar", 60.0, size, Glyphs::Ascii, Layers::default());
        assert_eq!(text.matches("/_\\").count(), triangles, "{text}");
        assert_eq!(text.matches("/////").count(), 2, "{text}");
    }
}

/// A pin in a slot is a block, and the slotted lever is drawn on both sides of it.
#[test]
fn slotted_link_continues_beyond_its_block() {
    let layers = Layers::default();
    let text = picture("slotted-lever", 60.0, (50, 18), Glyphs::Ascii, layers);
    let lines: Vec<&str> = text.lines().collect();
    let row = lines.iter().position(|line| line.contains("[@]"));
    let row = row.expect("the block is there");
    let col = lines[row].find("[@]").expect("the block is there") + 1;
    for beyond in [row - 1, row + 1] {
        assert!(lines[beyond][col - 1..col + 2].contains('|'), "{text}");
    }
}

/// The barrel of a cylinder is wide and lies between its pin and the end of its rod.
#[test]
fn cylinder_barrel_is_drawn_between_pin_and_rod() {
    let layers = Layers::default();
    let (scene, state, view, figure) = drawn(
        presets::find("excavator-boom").expect("it is there").text,
        Some(2.0),
        (80, 24),
        layers,
    );
    let raster = render(&figure, &view, Glyphs::Ascii);
    let named = |name: &str| {
        let mut all = scene.mechanism.point_ids();
        all.find(|point| scene.point_name(*point) == Some(name))
            .expect("it has this name")
    };
    let place = |name: &str| view.cell(state.position(named(name)).expect("it is placed"));
    let (pin, rod) = (place("O"), place("P"));
    let mut barrel = 0;
    for (row, line) in raster.text().lines().enumerate() {
        for (col, _) in line.char_indices().filter(|(_, glyph)| *glyph == '#') {
            let along = Vec2::new(col as f64 + 0.5, row as f64 + 0.5) - pin;
            let part = along.dot(rod - pin) / (rod - pin).dot(rod - pin);
            assert!((0.0..=1.0).contains(&part), "{}", raster.text());
            barrel += 1;
        }
    }
    assert!(barrel >= 3, "{}", raster.text());
}

#[test]
fn raster_can_be_reused_for_another_size() {
    let text = include_str!("../../presets/four-bar.toml");
    let scene = Scene::parse(text, "four-bar").expect("the scene reads");
    let solver = Solver::new(&scene.mechanism).expect("the scene moves");
    let mut state = solver.state();
    let _ = solver.solve(60.0, Order::Position, &mut state);
    let extents = Extents::of(&scene, &solver);
    let figure = linkage(&scene, &extents, &state, Layers::default());
    let mut raster = Raster::new();
    for (cols, rows) in [(80, 24), (0, 0), (200, 60), (40, 12)] {
        let view = WorldView::fit(&extents, cols, rows, 2.0);
        let labels = &mut Labels::default();
        render_into(&figure, &view, Glyphs::Ascii, labels, &mut raster);
        assert_eq!(raster, render(&figure, &view, Glyphs::Ascii));
    }
}
