//! Tests properties of drawings that hold for every preset in every state.

mod names;
pub(in crate::drawing) mod stage;
mod windows;

use super::*;
use crate::Vec2;
use crate::solver::{Condition, Order, Range, State};
use stage::DrawingStage;

/// Returns the figure of a linkage with all names and centres of mass.
fn full_figure(stage: &DrawingStage, state: &State) -> Figure {
    linkage(&stage.scene, &stage.reach, state, EVERYTHING)
}

const EVERYTHING: Layers = Layers {
    ground: true,
    points: true,
    links: true,
    centres: true,
    highlighted: None,
};

fn cell(view: &WorldView, at: Vec2) -> (i32, i32) {
    let at = view.cell(at);
    (at.x.floor() as i32, at.y.floor() as i32)
}

#[test]
fn ascii_drawings_are_ascii() {
    for stage in DrawingStage::presets() {
        let view = WorldView::fit(&stage.reach, 80, 24, 2.0);
        for state in stage.motion().step_by(20) {
            let text = render(&full_figure(&stage, &state), &view, Glyphs::Ascii).text();
            assert!(text.is_ascii(), "{}\n{text}", stage.name);
        }
    }
}

#[test]
fn drawing_without_assembly_shows_only_ground() {
    let text = include_str!("../../presets/double-rocker.toml");
    let stage = DrawingStage::of("double-rocker", text);
    let mut state = stage.solver.state();
    let condition = stage.solver.solve(180.0, Order::Position, &mut state);
    assert_eq!(condition, Condition::NoAssembly);
    let figure = full_figure(&stage, &state);
    let is_moving = |shape: &Shape| {
        matches!(
            shape,
            Shape::Line { .. } | Shape::Outline { .. } | Shape::Block { .. }
        )
    };
    assert!(!figure.shapes().iter().any(is_moving));
    let supports = |shape: &&Shape| matches!(shape, Shape::Support { .. });
    assert_eq!(figure.shapes().iter().filter(supports).count(), 2);
}

/// Returns a four-bar of a fixed shape, enlarged by `scale`, with A at (x, y).
fn four_bar(scale: f64, x: f64, y: f64) -> DrawingStage {
    let [a, b, c, d] = [100.0, 300.0, 250.0, 400.0].map(|length| length * scale);
    let (cx, cy) = (x + 310.0 * scale, y + 230.0 * scale);
    let text = format!(
        "unit = \"m\"
        ground = {{ A = [{x:e}, {y:e}], D = [{:e}, {y:e}] }}
        driver = {{ link = \"r2\", angle = 60, speed = \"1 rad/s\" }}
        [links]
        r2 = {{ from = \"A\", to = \"B\", length = {a:e} }}
        r3 = {{ from = \"B\", to = \"C\", length = {b:e} }}
        r4 = {{ from = \"C\", to = \"D\", length = {c:e} }}
        [start]
        C = [{cx:e}, {cy:e}]",
        x + d
    );
    DrawingStage::of("a four-bar", &text)
}

#[test]
fn drawing_does_not_depend_on_scale_or_origin() {
    let picture = |stage: &DrawingStage| {
        let mut state = stage.solver.state();
        let _ = stage.solver.solve(60.0, Order::Position, &mut state);
        let view = WorldView::fit(&stage.reach, 80, 24, 2.0);
        render(&full_figure(stage, &state), &view, Glyphs::Ascii).text()
    };
    let plain = picture(&four_bar(1.0, 0.0, 0.0));
    for (scale, x, y) in [
        (1e-9, 0.0, 0.0),
        (1e9, 0.0, 0.0),
        (1e150, 0.0, 0.0),
        (1.0, 1e8, -3e8),
    ] {
        assert_eq!(picture(&four_bar(scale, x, y)), plain, "{scale:e} at {x:e}");
    }
}

/// Returns the corners of all shapes with a role.
fn corners(figure: &Figure, wanted: impl Fn(Role) -> bool) -> Vec<Vec2> {
    let shapes = figure.shapes().iter();
    let corners = shapes.flat_map(|shape| match shape {
        Shape::Line { from, to, role } if wanted(*role) => vec![*from, *to],
        Shape::Outline { corners, role } if wanted(*role) => corners.clone(),
        _ => Vec::new(),
    });
    corners.collect()
}

/// A scene in inches is drawn over the same one in millimetres, link by link, and needs no more
/// space.
#[test]
fn compared_scene_is_drawn_in_unit_of_this_one() {
    let text = crate::scene::presets::find("watt-six-bar")
        .expect("it is there")
        .text;
    let stage = DrawingStage::of("watt-six-bar", text);
    let mut state = stage.solver.state();
    let _ = stage.solver.solve(100.0, Order::Position, &mut state);
    let mut figure = Figure::new();
    add_other(&mut figure, &stage.scene, &state, 25.4);
    let ghost = corners(&figure, |role| role == Role::Ghost);
    let own = linkage(&stage.scene, &stage.reach, &state, Layers::default());
    let links = corners(&own, Role::is_body);
    assert_eq!(ghost.len(), links.len());
    for corner in links {
        let there = |g: &Vec2| (*g - corner * 25.4).norm() < 1e-9 * corner.norm().max(1.0);
        assert!(ghost.iter().any(there), "{corner:?}");
    }
    // The extents of both are those of the larger one.
    let both = stage.reach.union(&stage.reach, 25.4, 1.0).bounds();
    let size = stage.reach.bounds().size() * 25.4;
    assert!((both.high - both.low).x >= size.x * (1.0 - 1e-12));
    let same = stage.reach.union(&stage.reach, 1.0, 1.0).bounds();
    assert_eq!(same, stage.reach.bounds());
    // Without an assembly there is no ghost.
    let mut nothing = Figure::new();
    let unsolved = stage.solver.state();
    add_other(&mut nothing, &stage.scene, &unsolved, 1.0);
    assert!(nothing.shapes().is_empty());
}

/// Adjacent links have different hues, and a table row has the hue of its link.
#[test]
fn adjacent_links_have_distinct_hues() {
    for stage in DrawingStage::presets() {
        let mechanism = &stage.scene.mechanism;
        let roles = link_roles(mechanism);
        assert_eq!(roles.len(), mechanism.links().len());
        for point in mechanism.points() {
            for (k, one) in point.links.iter().enumerate() {
                for other in &point.links[k + 1..] {
                    let [one, other] = [one, other].map(|link| roles[link.index()]);
                    assert_ne!(one, other, "{}", stage.name);
                }
            }
        }
    }
    let text = crate::scene::presets::find("four-bar")
        .expect("it is there")
        .text;
    let stage = DrawingStage::of("four-bar", text);
    let rows = vector_roles(&stage.scene);
    let [crank, coupler, rocker] = [Role::Driver, Role::Link(0), Role::Link(1)].map(Some);
    assert_eq!(rows, [crank, coupler, rocker, None]);
}

/// Regression: a driver with three points was fragmented in block characters, and hollow on paper
/// with its edges drawn twice.
#[test]
fn driver_with_three_points_is_a_plate() {
    let text = "unit = \"mm\"
        ground = { A = [0, 0], D = [400, 0] }
        driver = { link = \"r2\", angle = 60, speed = \"1 rad/s\" }
        [links]
        r2 = { points = { A = [0, 0], B = [100, 0], P = [60, 90] } }
        r3 = { from = \"B\", to = \"C\", length = 300 }
        r4 = { from = \"C\", to = \"D\", length = 250 }
        [start]
        C = [310, 230]";
    let stage = DrawingStage::of("a triangle drives", text);
    let mut state = stage.solver.state();
    let _ = stage.solver.solve(60.0, Order::Position, &mut state);
    let highlighted = Some(crate::quantity::Subject::Driver);
    for layers in [
        Layers::default(),
        Layers {
            highlighted,
            ..Layers::default()
        },
    ] {
        let figure = linkage(&stage.scene, &stage.reach, &state, layers);
        let view = WorldView::fit(&stage.reach, 120, 40, 2.0);
        let raster = render(&figure, &view, Glyphs::Blocks(Blocks::Quadrants));
        let cells = raster.lines().flatten();
        let inside: Vec<char> = cells
            .filter(|cell| cell.role == Role::DriverPlate)
            .map(|cell| cell.glyph)
            .collect();
        assert!(inside.len() > 20, "{inside:?}");
        assert!(
            inside.iter().all(|&glyph| glyph == '\u{2591}'),
            "{inside:?}"
        );
        let document = svg(&figure, &view, "a plate", &[]);
        let closed = document.lines().filter(|line| line.contains("Z\""));
        let classes: Vec<&str> = closed.filter_map(|line| line.split('"').nth(1)).collect();
        let edge = if layers.highlighted.is_some() {
            "link"
        } else {
            "driver"
        };
        assert_eq!(classes, ["plate driven", edge]);
    }
}

/// In dots, a link is as wide as the size of the view permits, and a plate is filled.
#[test]
fn link_width_follows_size_and_plates_are_filled() {
    let dots = |raster: &Raster, wanted: fn(Role) -> bool| -> u32 {
        let cells = raster.lines().flatten().filter(|cell| wanted(cell.role));
        cells
            .map(|cell| (u32::from(cell.glyph) & 0xff).count_ones())
            .sum()
    };
    let text = crate::scene::presets::find("press")
        .expect("it is there")
        .text;
    let stage = DrawingStage::of("press", text);
    let mut state = stage.solver.state();
    let _ = stage.solver.solve(60.0, Order::Position, &mut state);
    let figure = linkage(&stage.scene, &stage.reach, &state, Layers::default());
    for (cols, rows, width) in [(20, 9, 1), (80, 24, 2), (200, 60, 3)] {
        let view = WorldView::fit(&stage.reach, cols, rows, 2.0);
        let raster = render(&figure, &view, Glyphs::Braille);
        let thin = {
            let mut thin = Figure::new();
            for shape in figure.shapes() {
                match *shape {
                    Shape::Line { from, to, role } if role.is_body() => {
                        let role = Role::Guide;
                        thin.add(Shape::Line { from, to, role });
                    }
                    ref other => thin.add(other.clone()),
                }
            }
            render(&thin, &view, Glyphs::Braille)
        };
        let [bars, lines] = [&raster, &thin]
            .map(|raster| dots(raster, |role| role.is_body() || role == Role::Guide));
        assert_eq!(view.weight(), width);
        if width == 1 {
            assert!(bars >= lines, "{bars} {lines}");
        } else {
            assert!(bars > lines * 13 / 10, "{cols} x {rows}: {bars} {lines}");
        }
        let plates = dots(&raster, |role| matches!(role, Role::Plate(_)));
        assert!(plates > 0 || rows < 10, "{cols} x {rows}");
    }
}

/// Regression: the pins of the scissor lift were rings that hid all its links.
#[test]
fn pins_are_small_if_they_are_close() {
    for (name, width) in [("scissor-lift", 2), ("radial-engine", 3), ("jansen-leg", 3)] {
        let text = crate::scene::presets::find(name).expect("it is there").text;
        let stage = DrawingStage::of(name, text);
        let view = WorldView::fit(&stage.reach, 200, 60, 2.0);
        assert_eq!(view.weight(), width, "{name}");
    }
}
