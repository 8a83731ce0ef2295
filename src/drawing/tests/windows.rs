//! Tests views over whole motions: their contents, their scale, and how they follow the linkage.

use super::*;

#[test]
fn joints_stay_inside_view() {
    for stage in DrawingStage::presets() {
        for (cols, rows) in [(200, 60), (80, 24), (40, 12), (13, 7)] {
            let view = WorldView::fit(&stage.reach, cols, rows, 2.0);
            let mut raster = Raster::new();
            for state in stage.motion() {
                let figure = full_figure(&stage, &state);
                render_into(
                    &figure,
                    &view,
                    Glyphs::Ascii,
                    &mut Labels::default(),
                    &mut raster,
                );
                for shape in figure.shapes() {
                    if let Shape::Mark { at, role } = *shape {
                        let (col, row) = cell(&view, at);
                        let shown = raster.cell(col, row).map(|cell| cell.role);
                        assert!(
                            shown.is_some_and(|shown| shown != Role::Empty),
                            "{}: {role:?} at {col}, {row} in {cols} x {rows}",
                            stage.name
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn supports_stay_inside_usual_view() {
    for stage in DrawingStage::presets() {
        let view = WorldView::fit(&stage.reach, 80, 24, 2.0);
        for point in stage.scene.mechanism.points() {
            if let Some(at) = point.ground {
                let (col, row) = cell(&view, at);
                assert!((2..78).contains(&col), "{}: column {col}", stage.name);
                assert!((0..22).contains(&row), "{}: row {row}", stage.name);
            }
        }
    }
}

/// Returns the fraction of a window's width or height that the bars, pins and sliders fill.
fn fill(raster: &Raster) -> f64 {
    let is_linkage = |role: Role| role.is_body() || role.is_mark();
    let mut cells = Vec::new();
    for (row, line) in raster.lines().enumerate() {
        for (col, _) in line.iter().enumerate().filter(|(_, c)| is_linkage(c.role)) {
            cells.push((col, row));
        }
    }
    let span = |of: fn(&(usize, usize)) -> usize| {
        let (low, high) = (cells.iter().map(of).min(), cells.iter().map(of).max());
        low.zip(high).map_or(0, |(low, high)| high - low + 1)
    };
    let across = span(|c| c.0) as f64 / f64::from(raster.cols());
    across.max(span(|c| c.1) as f64 / f64::from(raster.rows()))
}

/// Regression: the linkage filled only 7 % of the screen if its motion needs much more space than
/// the linkage itself.
#[test]
fn linkage_fills_view_throughout_motion() {
    let mut small = Vec::new();
    for stage in DrawingStage::presets() {
        for (cols, rows) in [(80, 24), (120, 40), (200, 60), (44, 21)] {
            let mut minimum = 1.0_f64;
            for state in stage.motion().step_by(10) {
                let figure = linkage(&stage.scene, &stage.reach, &state, Layers::default());
                let view = WorldView::along(&stage.reach, state.at(), cols, rows, 2.0);
                minimum = minimum.min(fill(&render(&figure, &view, Glyphs::Braille)));
            }
            if minimum < 0.6 {
                small.push(format!("{} in {cols} x {rows}: {minimum:.2}", stage.name));
            }
        }
    }
    assert!(small.is_empty(), "{small:#?}");
}

/// Regression: rings and names were cut off in a view so large that they are small in it.
#[test]
fn large_view_cuts_no_rings_or_labels() {
    /// Half the width and half the height of a ring, in columns and rows.
    const RING: Vec2 = Vec2::new(1.5, 0.75);
    let mut cut = Vec::new();
    for stage in DrawingStage::presets() {
        // A folded scissor lift has no space for its labels between its own bars.
        let is_crowded = stage.name.contains("scissor-lift");
        let mut raster = Raster::new();
        for state in stage.motion().step_by(50) {
            let figure = linkage(&stage.scene, &stage.reach, &state, Layers::default());
            for (cols, rows) in [(400, 120), (400, 200)] {
                let views = [
                    WorldView::fit(&stage.reach, cols, rows, 2.0),
                    WorldView::along(&stage.reach, state.at(), cols, rows, 2.0),
                    WorldView::pose(&stage.reach, state.at(), cols, rows, 2.0),
                ];
                for (view, kind) in views.into_iter().zip(["whole", "along", "pose"]) {
                    let size = Vec2::new(f64::from(cols), f64::from(rows));
                    let is_inside = |at: Vec2| {
                        let (low, high) = (at - RING, at + RING - size);
                        low.x >= 0.0 && low.y >= 0.0 && high.x <= 0.0 && high.y <= 0.0
                    };
                    let rings = figure.shapes().iter().filter_map(|shape| match *shape {
                        Shape::Mark { at, .. } => Some(view.cell(at)),
                        _ => None,
                    });
                    let rings = rings.filter(|at| !is_inside(*at)).count();
                    let mut labels = Labels::default();
                    render_into(&figure, &view, Glyphs::Braille, &mut labels, &mut raster);
                    let names = if is_crowded { 0 } else { labels.hidden() };
                    if rings + names > 0 {
                        let (name, at) = (&stage.name, state.at());
                        cut.push(format!(
                            "{name} {kind} {cols} x {rows} at {at}: {rings}, {names}"
                        ));
                    }
                }
            }
        }
    }
    assert!(cut.is_empty(), "{cut:#?}");
}

/// During playback, the view follows without jumps: per frame it moves by less than a tenth of its
/// size more than the linkage itself.
#[test]
fn following_view_moves_without_jumps() {
    /// Number of frames in a turn of four seconds.
    const FRAMES: u32 = 80;
    const MAX_SHARE: f64 = 0.1;
    let mut shaken = Vec::new();
    for stage in DrawingStage::presets() {
        let (low, high) = match stage.solver.motion().range {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        };
        for (cols, rows) in [(80, 24), (200, 60)] {
            let share = |v: Vec2| {
                (v.x / f64::from(cols))
                    .abs()
                    .max((v.y / f64::from(rows)).abs())
            };
            let mut state = stage.solver.state();
            let mut at = |k: u32| {
                let share = f64::from(k) / f64::from(FRAMES);
                // Near a limit the linkage itself moves ever faster.
                let share = match stage.solver.motion().range {
                    Range::Full { .. } => share,
                    Range::Limited { .. } => (1.0 - (std::f64::consts::PI * share).cos()) / 2.0,
                };
                let at = (low + (high - low) * share).min(high);
                let _ = stage.solver.solve(at, Order::Position, &mut state);
                let points = stage.scene.mechanism.point_ids();
                let points: Vec<Vec2> = points.map(|p| state.known().position(p)).collect();
                (WorldView::along(&stage.reach, at, cols, rows, 2.0), points)
            };
            let mut before = at(0);
            for k in 1..=FRAMES {
                let after = at(k);
                let pairs = before.1.iter().zip(&after.1);
                let own = pairs.map(|(a, b)| share(before.0.cell(*b) - before.0.cell(*a)));
                let maximum = MAX_SHARE + own.fold(0.0, f64::max);
                for corner in [Vec2::ZERO, Vec2::new(f64::from(cols), f64::from(rows))] {
                    let moved = share(after.0.cell(before.0.world(corner)) - corner);
                    if moved > maximum {
                        let name = &stage.name;
                        shaken.push(format!(
                            "{name} in {cols} x {rows}, {k}: {moved:.3}, {maximum:.3}"
                        ));
                    }
                }
                before = after;
            }
        }
    }
    assert!(shaken.is_empty(), "{shaken:#?}");
}

/// The view's anchor does not tremble while the view follows: it moves in one direction until the
/// view reverses, and not back and forth in between. Other ground pins depend on the anchor and on
/// the scale, which changes in steps of its own, so they may move back and forth by a cell or two.
#[test]
fn following_view_does_not_shake() {
    /// Number of positions in a motion: one per degree of a turn.
    const PLACES: u32 = 360;
    let mut shaken = Vec::new();
    for stage in DrawingStage::presets() {
        let (low, high) = match stage.solver.motion().range {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        };
        for (cols, rows) in [(46, 20), (80, 24), (120, 40), (200, 60)] {
            let at = |k: u32| low + (high - low) * f64::from(k) / f64::from(PLACES);
            let seen = |k| {
                let view = WorldView::along(&stage.reach, at(k), cols, rows, 2.0);
                let cell = view.cell(stage.reach.anchor()).map(f64::floor);
                let is_seen = (0.0..f64::from(cols)).contains(&cell.x)
                    && (0.0..f64::from(rows)).contains(&cell.y);
                is_seen.then_some([cell.x, cell.y])
            };
            let cells: Vec<[f64; 2]> = (0..=PLACES).filter_map(seen).collect();
            for axis in 0..2 {
                let moves = cells.windows(2).map(|pair| pair[1][axis] - pair[0][axis]);
                let moves: Vec<f64> = moves.filter(|by| *by != 0.0).collect();
                let turns = moves.windows(2).filter(|pair| pair[0] * pair[1] < 0.0);
                let turns = turns.count();
                if turns > 6 {
                    let name = &stage.name;
                    shaken.push(format!("{name} in {cols} x {rows}, axis {axis}: {turns}"));
                }
            }
        }
    }
    assert!(shaken.is_empty(), "{shaken:#?}");
}

/// Regression: a crank of one row was hidden between its pins, and a driven block looked like any
/// other.
#[test]
fn driver_is_visible_in_every_view() {
    let mut hidden = Vec::new();
    let mut raster = Raster::new();
    for stage in DrawingStage::presets() {
        for state in stage.motion().step_by(5) {
            let figure = linkage(&stage.scene, &stage.reach, &state, Layers::default());
            for (cols, rows) in [(40, 5), (40, 9), (40, 12), (46, 20), (60, 18), (80, 24)] {
                let view = WorldView::along(&stage.reach, state.at(), cols, rows, 2.0);
                for glyphs in Glyphs::ALL {
                    let labels = &mut Labels::default();
                    render_into(&figure, &view, glyphs, labels, &mut raster);
                    let cells = || raster.lines().flatten();
                    let has_hue = cells().any(|cell| cell.role == Role::DriverPin);
                    // If marks consist of dots, the core of the ring identifies the driver.
                    let is_shown = |cell: &CharCell| cell.glyph == '@';
                    let has_shape = view.weight() > 2 && glyphs.is_dotted()
                        || cells().filter(|c| c.role == Role::DriverPin).any(is_shown);
                    if !(has_hue && has_shape) {
                        let (name, at) = (&stage.name, state.at());
                        hidden.push(format!("{name} at {at} in {cols} x {rows}, {glyphs:?}"));
                    }
                }
            }
        }
    }
    assert!(hidden.is_empty(), "{hidden:#?}");
}

/// Regression: a velocity arrow covered the pin of a block: `[⠃]`.
#[test]
fn arrows_hide_no_pins() {
    let mut hidden = Vec::new();
    for stage in DrawingStage::presets() {
        let points = usual_arrows(&stage.scene.mechanism);
        let wanted = OverlayRequest {
            velocities: points.clone(),
            accelerations: points,
            forces: true,
            ..OverlayRequest::default()
        };
        let overlay = stage.overlay(&wanted);
        for state in stage.motion().step_by(20) {
            let state = stage.state(state.at());
            let plain = linkage(&stage.scene, &stage.reach, &state, Layers::default());
            let mut full = plain.clone();
            overlay.add_to(&mut full, &stage.scene, &stage.solver, &state, 1.0);
            for (cols, rows) in [(40, 12), (80, 24), (120, 40)] {
                let view = WorldView::along(&stage.reach, state.at(), cols, rows, 2.0);
                for glyphs in Glyphs::ALL {
                    let [without, with] = [&plain, &full].map(|f| render(f, &view, glyphs));
                    for shape in plain.shapes() {
                        let Shape::Mark { at, .. } = *shape else {
                            continue;
                        };
                        let (col, row) = cell(&view, at);
                        let role = |raster: &Raster| raster.cell(col, row).map(|cell| cell.role);
                        if role(&with) != role(&without) {
                            let (name, at) = (&stage.name, state.at());
                            hidden.push(format!(
                                "{name} at {at} in {cols} x {rows}, {glyphs:?}: {:?}",
                                role(&with)
                            ));
                        }
                    }
                }
            }
        }
    }
    assert!(hidden.is_empty(), "{hidden:#?}");
}
