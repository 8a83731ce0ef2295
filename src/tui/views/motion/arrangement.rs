//! Arranges the motion view: tables next to the drawing if the screen is wide enough, or else below
//! it, independent of the scene.

use super::super::layout::{moved, percent_of};
use super::super::{inset, split, split_columns, table};
use crate::drawing::{self, LegendPiece};
use crate::tui::app::{App, Mode};
use ratatui::layout::Rect;
use std::borrow::Cow;

/// The areas of the motion view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MotionAreas {
    /// The title above the drawing, if there are enough rows.
    pub(super) title: Option<Rect>,
    pub(super) drawing: Rect,
    /// The line with the position in the cycle; empty if there are too few rows.
    pub(super) cycle: Rect,
    /// The legend below the drawing; empty if it has no entries.
    pub(super) legend: Rect,
    /// The separator, one cell wide or high.
    pub(super) rule: Rect,
    pub(super) table: Rect,
}

/// Minimum width for tables next to the drawing.
const MIN_WIDTH_WITH_TABLES: u16 = 72;
/// Minimum width of the drawing next to tables, in percent: half of a screen of 80 x 24 and more.
const MIN_DRAWING_PERCENT: u16 = 58;
/// Tables below the drawing get at most one third of the height.
const TABLE_SHARE: u16 = 3;
const MIN_TABLE_HEIGHT: u16 = 4;
/// Minimum height for the separator and the title; on lower screens the drawing gets their lines.
const MIN_HEIGHT_WITH_RULE: u16 = 14;
/// Minimum height for the line with the position in the cycle.
const ROOM_FOR_CYCLE: u16 = 14;
/// Minimum height of a drawing.
const MIN_DRAWING_HEIGHT: u16 = 4;
/// Maximum number of legend lines; a low screen shows one.
const MAX_LEGEND: usize = 2;

/// Arranges the view's parts in an area.
pub(super) fn arrange(app: &App, area: Rect) -> MotionAreas {
    let [part, rule, table] = if area.width >= MIN_WIDTH_WITH_TABLES {
        side_by_side(app, area)
    } else {
        below(app, area)
    };
    let lines = u16::from(area.height >= MIN_HEIGHT_WITH_RULE);
    let (title, untitled) = split(part, lines);
    let [drawing, cycle, legend] = with_legend(app, untitled);
    MotionAreas {
        title: (lines > 0).then_some(title),
        drawing,
        cycle,
        legend,
        rule,
        table: inset(table),
    }
}

/// Splits an area into the drawing, the line with the position in the cycle, and the legend.
pub(super) fn with_legend(app: &App, area: Rect) -> [Rect; 3] {
    let lines = u16::try_from(legend(app, area).len()).unwrap_or(0);
    let cycle = u16::from(area.height >= ROOM_FOR_CYCLE);
    let height = area.height.saturating_sub(lines + cycle).max(1);
    let (drawing, below) = split(area, height);
    let (cycle, legend) = split(below, cycle);
    [drawing, inset(cycle), inset(legend)]
}

/// Returns the lines of the legend for a drawing in this area.
pub(super) fn legend(app: &App, area: Rect) -> Vec<Vec<LegendPiece>> {
    let maximum = if area.height < MIN_HEIGHT_WITH_RULE {
        1
    } else {
        MAX_LEGEND
    };
    let view = window(app, area);
    let width = usize::from(inset(area).width);
    drawing::legend_lines(
        &app.views.viewport.legend(app.open_scene(), &view),
        app.glyphs(),
        width,
        maximum,
    )
}

/// Returns the part of the scene's plane visible in this area.
pub(super) fn window(app: &App, area: Rect) -> drawing::WorldView {
    let extents = extents(app, area.height);
    let size = (area.width, area.height);
    let viewport = &app.views.viewport;
    viewport.view(app.open_scene(), &extents, size, app.aspect())
}

/// Returns the extents that a drawing of this height must contain.
fn extents(app: &App, rows: u16) -> Cow<'_, drawing::Extents> {
    let open_scene = app.open_scene();
    let own = app.views.viewport.extents(open_scene, rows);
    match (app.mode(), app.compared()) {
        (Mode::Assemblies(assemblies), _) => Cow::Borrowed(&assemblies.reach),
        // If the drawing needs only the linkage's extents, the union is cached.
        (_, Some(compared)) if std::ptr::eq(own, open_scene.extents()) => {
            Cow::Borrowed(compared.extents())
        }
        (_, Some(compared)) => Cow::Owned(compared.union_of_extents(own)),
        _ => Cow::Borrowed(own),
    }
}

/// Returns the areas of drawing, separator and tables side by side. The drawing gets the columns
/// that the tables cannot use.
fn side_by_side(app: &App, area: Rect) -> [Rect; 3] {
    let (_, wide) = app.sheet().widths(app.glyphs());
    let used = table::columns_of(wide).saturating_add(1 + 1 + super::super::MARGIN);
    let share = percent_of(area.width, MIN_DRAWING_PERCENT);
    let drawing = share.max(area.width.saturating_sub(used));
    let drawing = moved(drawing, area.width, app.composition().split());
    let (drawing, side) = split_columns(area, drawing);
    let (rule, table) = split_columns(side, 1);
    [drawing, rule, table]
}

/// Returns the areas of drawing, separator and tables, one below another.
fn below(app: &App, area: Rect) -> [Rect; 3] {
    let width = usize::from(inset(area).width);
    let placed = app.sheet().placed(width, app.glyphs());
    let [vectors, all] = [placed.vector_lines(), placed.lines().len()]
        .map(|lines| u16::try_from(lines).unwrap_or(u16::MAX))
        .map(|lines| lines.saturating_add(table::title_lines(app)));
    // Next to the tour of a low screen, there is no space for both.
    let share = match area.height < MIN_DRAWING_HEIGHT + MIN_TABLE_HEIGHT {
        true => 0,
        false => (area.height / TABLE_SHARE).max(MIN_TABLE_HEIGHT),
    };
    let rule = u16::from(area.height >= MIN_HEIGHT_WITH_RULE);
    let drawing = area.height.saturating_sub(vectors.min(share) + rule);
    // If the width limits the drawing's scale, the unused rows show more of the tables.
    let lowest = area.height.saturating_sub(all.saturating_add(rule));
    // Uses the extents of the whole motion, so that the separator stays fixed while the linkage
    // moves.
    let scale_at = |height| {
        let extents = extents(app, height);
        drawing::WorldView::fit(&extents, area.width, height, app.aspect()).cells_along(1.0)
    };
    // A tolerance, so that a rounding error does not shrink the drawing.
    let minimum = scale_at(drawing) * (1.0 - 1e-9);
    let drawing = (lowest.max(MIN_DRAWING_HEIGHT)..drawing)
        .find(|&lower| scale_at(lower) >= minimum)
        .unwrap_or(drawing);
    let (drawing, below) = split(area, drawing);
    let (rule, table) = split(below, rule);
    [drawing, rule, table]
}
