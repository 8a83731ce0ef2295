//! Tests plots of made-up curves and of presets, in three kinds of glyphs.

use super::*;
use crate::quantity::{Catalogue, StateValues};
use crate::scene::{Scene, presets};
use crate::solver::Solver;
use proptest::prelude::*;

const GLYPHS: [Glyphs; 3] = [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille];

fn plot_style(cols: u16, rows: u16, glyphs: Glyphs) -> PlotStyle {
    PlotStyle {
        cols,
        rows,
        glyphs,
        aspect: 2.0,
        extrema: true,
        first: 0,
    }
}

fn opened(preset: &str) -> (Scene, Solver) {
    let preset = presets::find(preset).unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

fn curves(preset: &str, columns: &[&str], along: Option<&str>) -> Curves {
    let (scene, solver) = opened(preset);
    let catalogue = Catalogue::new(&scene);
    let quantities = catalogue.select(columns).unwrap();
    let abscissa = match along {
        None => Abscissa::Driver,
        Some("time") => Abscissa::Time,
        Some(name) => Abscissa::Figure(catalogue.select(&[name]).unwrap().remove(0)),
    };
    Curves::new(&scene, &solver, &quantities, abscissa, None).unwrap()
}

fn plot(preset: &str, columns: &[&str], along: Option<&str>) -> Plot {
    Plot::of(&curves(preset, columns, along))
}

fn line(points: &[(f64, f64)]) -> PlotCurve {
    PlotCurve {
        name: "f".into(),
        figure: Some(0),
        pieces: vec![points.iter().map(|&(x, y)| Vec2::new(x, y)).collect()],
        turns: Vec::new(),
        is_dotted: false,
        link: None,
        band: None,
    }
}

/// Returns panels of these curves, with axes that fit their values.
fn made(lines: Vec<PlotCurve>) -> Plot {
    let axis = |low, high| Axis {
        name: "t".into(),
        unit: "s".into(),
        is_angle: false,
        low,
        high,
    };
    let points = || lines.iter().flat_map(|line| line.pieces.iter().flatten());
    let ends = |part: fn(&Vec2) -> f64| {
        let values = || points().map(part);
        let low = values().fold(f64::INFINITY, f64::min);
        spread(Some((low, values().fold(f64::NEG_INFINITY, f64::max))))
    };
    let ((x0, x1), (y0, y1)) = (ends(|p| p.x), ends(|p| p.y));
    let panel = Panel {
        y: axis(y0, y1),
        curves: lines.clone(),
    };
    Plot {
        x: axis(x0, x1),
        panels: vec![panel],
        is_true: false,
    }
}

#[test]
fn small_plots_match_snapshots() {
    let pair = plot("four-bar", &["C.v*", "r4.omega"], None);
    let here = StateValues {
        along: Some(60.0),
        values: vec![Some(-722.630_802), Some(-273.816_684), Some(3.094)],
    };
    for (glyphs, name) in GLYPHS.into_iter().zip(["ascii", "line", "braille"]) {
        let text = pair.render(&plot_style(64, 20, glyphs), Some(&here)).text();
        insta::assert_snapshot!(format!("plot-four-bar-{name}-64x20"), text);
        let text = pair.render(&plot_style(40, 10, glyphs), Some(&here)).text();
        insta::assert_snapshot!(format!("plot-four-bar-{name}-40x10"), text);
    }
    // A coupler curve with equal scales, and a direction that wraps at 360 deg.
    let curve = plot("hoecken", &["P.y"], Some("P.x"));
    let text = curve
        .render(&plot_style(60, 14, Glyphs::Braille), None)
        .text();
    insta::assert_snapshot!("plot-coupler-curve-60x14", text);
    let angle = plot("drag-link", &["r4.angle"], Some("time"));
    let text = angle.render(&plot_style(60, 14, Glyphs::Line), None).text();
    insta::assert_snapshot!("plot-direction-60x14", text);
}

#[test]
fn angle_wrap_at_360_deg_is_a_gap() {
    let plot = plot("drag-link", &["r4.angle"], None);
    let pieces = &plot.panels[0].curves[0].pieces;
    assert_eq!(pieces.len(), 2, "one gap in a turn");
    for glyphs in GLYPHS {
        let raster = plot.render(&plot_style(80, 24, glyphs), None);
        for col in 0..80 {
            let rows = (0..24).filter(|&row| {
                raster
                    .cell(col, row)
                    .is_some_and(|cell| cell.role == crate::drawing::Role::Datum)
            });
            assert!(rows.count() <= 8, "column {col} in {glyphs:?}");
        }
    }
}

#[test]
fn compared_curve_is_dotted_and_has_no_value() {
    let mut both = plot("four-bar", &["r4.omega"], None);
    let other = plot("drag-link", &["r4.omega", "C.x"], None);
    both.compare(&other, "before");
    assert_eq!(both.panels.len(), 1, "C.x has nothing beside it");
    let added = &both.panels[0].curves[1];
    assert!(added.is_dotted && added.figure.is_none() && added.name == "r4.omega before");
    // Regression: the curve of one link had two hues, and neither was that of its bar.
    let roles: Vec<_> = (0..2).map(|curve| both.panels[0].role(curve)).collect();
    assert_eq!(roles[0], roles[1]);
    assert!(both.panels[0].y.high >= other.panels[0].y.high);
    for glyphs in GLYPHS {
        let text = both.render(&plot_style(70, 16, glyphs), None).text();
        assert!(text.contains("r4.omega before"), "{text}");
    }
}

#[test]
fn constant_curve_is_horizontal_in_the_middle() {
    let level = plot("slider-crank", &["C.y", "C.vy", "r2.omega"], None);
    for panel in &level.panels {
        let curve = &panel.curves[0];
        assert!(curve.turns.is_empty(), "{}", curve.name);
        let middle = 0.5 * (panel.y.low + panel.y.high);
        let size = panel.y.high - panel.y.low;
        for p in curve.pieces.iter().flatten() {
            assert!((p.y - middle).abs() < 1e-3 * size, "{} {p:?}", curve.name);
        }
    }
}

#[test]
fn svg_has_every_curve_axis_and_name() {
    let plot = plot("four-bar", &["C.v*", "r4.omega"], None);
    let text = plot.svg("Four-bar <1>", Vec2::new(800.0, 600.0), true, None);
    for part in [
        "Four-bar &lt;1&gt;",
        ">C.vx<",
        ">C.vy<",
        ">r4.omega<",
        "rad/s",
        "driver.angle [deg]",
        "class=\"c1\"",
        ">360<",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    assert!(!text.contains("NaN") && !text.contains("inf"));
    assert_eq!(
        text.matches("<circle").count(),
        6,
        "two turns of each curve"
    );
}

#[test]
fn equal_scale_plot_keeps_squares() {
    let square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (0.0, 0.0)];
    let mut plot = made(vec![line(&square)]);
    plot.is_true = true;
    for (cols, rows) in [(80, 24), (40, 40), (200, 12)] {
        let raster = plot.render(&plot_style(cols, rows, Glyphs::Ascii), None);
        let drawn = |row: i32, col: i32| {
            raster
                .cell(col, row)
                .is_some_and(|cell| cell.role == crate::drawing::Role::Datum)
        };
        // Below the legend.
        let (rows, cols) = (1..i32::from(rows), 0..i32::from(cols));
        let tall = rows
            .clone()
            .filter(|&row| cols.clone().any(|col| drawn(row, col)))
            .count();
        let wide = cols
            .filter(|&col| rows.clone().any(|row| drawn(row, col)))
            .count();
        let ratio = (wide as f64 - 1.0) / (tall as f64 - 1.0);
        assert!((ratio - 2.0).abs() < 0.35, "{wide} x {tall}");
    }
}

proptest! {
    #[test]
    fn every_sample_is_marked(
        points in prop::collection::vec((-1e3..1e3_f64, -1e3..1e3_f64), 1..40),
        more in prop::collection::vec((-1e3..1e3_f64, -1e3..1e3_f64), 1..10),
        (cols, rows) in (16_u16..120, 5_u16..40),
    ) {
        let plot = made(vec![line(&points), line(&more)]);
        for glyphs in GLYPHS {
            let style = plot_style(cols, rows, glyphs);
            let raster = plot.render(&style, None);
            let Some(layout) = plot.layout(&style) else {
                return Ok(());
            };
            let frame = &layout.panels[0].1;
            for &(x, y) in points.iter().chain(&more) {
                let cell = (layout.x.cell(x).unwrap(), frame.y.cell(y).unwrap());
                prop_assert!(frame.block.contains(cell));
                let found = raster.cell(cell.0, cell.1).unwrap();
                prop_assert!(matches!(found.role, crate::drawing::Role::Datum | crate::drawing::Role::Second), "{found:?}");
            }
        }
    }

    #[test]
    fn any_curve_renders_at_any_size(
        points in prop::collection::vec((any::<f64>(), any::<f64>()), 0..20),
        (x0, x1, y0, y1) in (any::<f64>(), any::<f64>(), any::<f64>(), any::<f64>()),
        (cols, rows) in (0_u16..130, 0_u16..50),
        is_true: bool,
        first in 0_usize..3,
    ) {
        let finite = |p: &Vec2| p.is_finite();
        let points: Vec<Vec2> = points.iter().map(|&(x, y)| Vec2::new(x, y)).filter(finite).collect();
        let mut curve = line(&[]);
        curve.turns = points.iter().map(|&at| CurveTurn { at, is_peak: true, is_extreme: false }).collect();
        curve.pieces = vec![points];
        let mut plot = made(vec![line(&[(0.0, 0.0), (1.0, 1.0)])]);
        (plot.x.low, plot.x.high) = spread(Some((x0.min(x1), x0.max(x1))));
        (plot.panels[0].y.low, plot.panels[0].y.high) = spread(Some((y0.min(y1), y0.max(y1))));
        plot.panels[0].curves.push(curve);
        plot.is_true = is_true;
        let here = StateValues { along: Some(x0), values: vec![Some(y0)] };
        for glyphs in GLYPHS {
            let style = PlotStyle { first, ..plot_style(cols, rows, glyphs) };
            let raster = plot.render(&style, Some(&here));
            prop_assert_eq!((raster.cols(), raster.rows()), (cols, rows));
            prop_assert!(glyphs != Glyphs::Ascii || raster.text().is_ascii());
        }
        let text = plot.svg("t", Vec2::new(f64::from(cols) * 8.0, f64::from(rows) * 16.0), true, Some(&here));
        prop_assert!(!text.contains("NaN"));
    }
}

/// A curve has the hue of its link in the drawing if all curves of its panel belong to different
/// links.
#[test]
fn curves_have_hues_of_links_if_these_differ() {
    use crate::drawing::Role;
    let (scene, _) = opened("four-bar");
    let roles = |names: &[&str]| {
        let curves = curves("four-bar", names, None);
        let plot = Plot::of(&curves).in_hues_of(&scene.mechanism, &curves);
        let role = |name: &&str| plot.role_of(name).unwrap();
        names.iter().map(role).collect::<Vec<_>>()
    };
    let links = crate::drawing::link_roles(&scene.mechanism);
    let own = roles(&["r3.omega", "r4.omega", "r4.alpha"]);
    assert_eq!(own, [links[1], links[2], links[2]]);
    assert_eq!(roles(&["r4.angle", "r2.angle"]), [links[2], Role::Driver]);
    // Two curves of one link, or a curve of a joint between two links, get the default hues.
    let usual = [Role::Datum, Role::Second];
    assert_eq!(roles(&["C.vx", "C.vy"]), usual);
}
