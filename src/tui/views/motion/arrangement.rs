//! Where the parts of the motion view stand: tables beside the drawing where there are columns for both, whatever the
//! scene, and below it on narrow screens.

use super::super::layout::{moved, percent_of};
use super::super::{inset, table};
use crate::drawing::{self, LegendPiece};
use crate::tui::app::{App, Mode};
use ratatui::layout::Rect;
use std::borrow::Cow;

/// Where the parts of the view are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MotionAreas {
    /// Above the drawing, where there are rows enough.
    pub(super) title: Option<Rect>,
    pub(super) drawing: Rect,
    /// Below the drawing, without a line where nothing needs to be told.
    pub(super) legend: Rect,
    /// One cell wide or high.
    pub(super) rule: Rect,
    pub(super) table: Rect,
}

/// From so many columns on the tables stand beside the drawing.
const ROOM_BESIDE: u16 = 72;
/// Percent of the columns that tables beside the drawing leave it: half of a screen of 80 x 24 and more.
const BESIDE_TABLES: u16 = 58;
/// Tables below the drawing leave it two thirds of the height.
const TABLE_SHARE: u16 = 3;
const LOWEST_TABLE: u16 = 4;
/// On lower screens the lines of the rule and of the title go to the drawing.
const ROOM_FOR_RULE: u16 = 14;
/// A drawing below this height is no drawing.
const LOWEST_DRAWING: u16 = 4;
/// A legend takes so many lines at the most, and one on low screens.
const MOST_LEGEND: usize = 2;

/// Puts the tables where there is room for them.
pub(super) fn arrange(app: &App, area: Rect) -> MotionAreas {
    let [part, rule, table] = if area.width >= ROOM_BESIDE {
        beside(app, area)
    } else {
        below(app, area)
    };
    let lines = u16::from(area.height >= ROOM_FOR_RULE);
    let untitled = Rect {
        y: part.y + lines,
        height: part.height - lines,
        ..part
    };
    let (drawing, legend) = with_legend(app, untitled);
    MotionAreas {
        title: (lines > 0).then_some(Rect { height: 1, ..part }),
        drawing,
        legend,
        rule,
        table: inset(table),
    }
}

/// An area for the drawing without its last lines, which are the legend's.
pub(super) fn with_legend(app: &App, area: Rect) -> (Rect, Rect) {
    let lines = u16::try_from(legend(app, area).len()).unwrap_or(0);
    let height = area.height.saturating_sub(lines).max(1);
    let drawing = Rect { height, ..area };
    let legend = Rect {
        y: area.y + height,
        height: area.height.saturating_sub(height),
        ..inset(area)
    };
    (drawing, legend)
}

/// The lines of the legend for a drawing in this area.
pub(super) fn legend(app: &App, area: Rect) -> Vec<Vec<LegendPiece>> {
    let most = if area.height < ROOM_FOR_RULE {
        1
    } else {
        MOST_LEGEND
    };
    let view = window(app, area);
    let width = usize::from(inset(area).width);
    drawing::legend_lines(&app.viewport().legend(&view), app.glyphs(), width, most)
}

/// The window on the drawing in this area.
pub(super) fn window(app: &App, area: Rect) -> drawing::WorldView {
    let reach = reach(app, area.height);
    let size = (area.width, area.height);
    let viewport = app.viewport();
    viewport.view(app.open_scene(), &reach, size, app.aspect())
}

/// The space that a drawing of so many rows must have room for.
fn reach(app: &App, rows: u16) -> Cow<'_, drawing::Reach> {
    let open_scene = app.open_scene();
    let own = app.viewport().reach(open_scene, rows);
    match (app.mode(), open_scene.assembly_list(), app.compared()) {
        (Mode::Assemblies(_), Some(assembly_list), _) => Cow::Borrowed(assembly_list.reach()),
        // As long as the drawing needs no more than the linkage, that is known already.
        (_, _, Some(compared)) if std::ptr::eq(own, open_scene.reach()) => {
            Cow::Borrowed(compared.reach())
        }
        (_, _, Some(compared)) => Cow::Owned(compared.reach_beside(own)),
        _ => Cow::Borrowed(own),
    }
}

/// The drawing, the line beside it, and the tables: what these cannot use is the drawing's.
fn beside(app: &App, area: Rect) -> [Rect; 3] {
    let (_, wide) = app.sheet().widths(app.glyphs());
    let used = table::columns_of(wide).saturating_add(1 + 1 + super::super::MARGIN);
    let share = percent_of(area.width, BESIDE_TABLES);
    let drawing = share.max(area.width.saturating_sub(used));
    let drawing = moved(drawing, area.width, app.composition().split());
    let table = area.width.saturating_sub(drawing + 1);
    let columns = [(0, drawing), (drawing, 1), (drawing + 1, table)];
    columns.map(|(x, width)| Rect {
        x: area.x + x,
        width,
        ..area
    })
}

/// The drawing, the line below it, and the tables.
fn below(app: &App, area: Rect) -> [Rect; 3] {
    let width = usize::from(inset(area).width);
    let placed = app.sheet().placed(width, app.glyphs());
    let [vectors, all] = [placed.vector_lines(), placed.lines().len()]
        .map(|lines| u16::try_from(lines).unwrap_or(u16::MAX))
        .map(|lines| lines.saturating_add(table::title_lines(app)));
    let share = (area.height / TABLE_SHARE).max(LOWEST_TABLE);
    let rule = u16::from(area.height >= ROOM_FOR_RULE);
    let drawing = area.height.saturating_sub(vectors.min(share) + rule);
    // What the width keeps the drawing from using shows more of the tables.
    let lowest = area.height.saturating_sub(all.saturating_add(rule));
    // Of the whole motion: the line must stand still while the linkage moves.
    let scale_at = |height| {
        let reach = reach(app, height);
        drawing::WorldView::fit(&reach, area.width, height, app.aspect()).cells_along(1.0)
    };
    // A rounding error makes no drawing smaller.
    let least = scale_at(drawing) * (1.0 - 1e-9);
    let drawing = (lowest.max(LOWEST_DRAWING)..drawing)
        .find(|&lower| scale_at(lower) >= least)
        .unwrap_or(drawing);
    let table = area.height.saturating_sub(drawing + rule);
    let rows = [(0, drawing), (drawing, rule), (drawing + rule, table)];
    rows.map(|(y, height)| Rect {
        y: area.y + y,
        height,
        ..area
    })
}
