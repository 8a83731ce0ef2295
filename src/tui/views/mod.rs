//! The screen: views read the workbench and fill a buffer without changing state.
//!
//! ```text
//! 1 Motion  2 Tables  3 Plots  ..      one line: the views
//! drawing              | tables        what is left: panes, as many as have room
//! ---------------------|
//! plot                 |
//! range  class  transmission            one line
//! mode  scene  angle  state     hints  one line
//! ```

pub(crate) mod accuracy;
mod assemblies;
pub(crate) mod candidates;
mod compact;
pub(crate) mod forces;
pub(crate) mod help;
pub(crate) mod layout;
mod led;
pub(crate) mod lengths;
pub(crate) mod motion;
pub(crate) mod motor;
mod page;
pub(crate) mod palette;
mod pane;
pub(crate) mod plots;
pub(crate) mod polygons;
mod popup;
mod question;
pub(crate) mod recovery_offer;
mod scene;
pub(crate) mod scene_picker;
pub(crate) mod state;
mod status;
mod table;
mod tables;
mod tabs;
mod title;
pub(crate) mod tour;
mod verdict;
pub(crate) mod working;

use super::app::{App, Mode, View};
use crate::document::ascii_letter;
use crate::drawing::{self, Extents, Figure, Raster, WorldView};
use crate::page::{Line, TextRole, cut};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::key::Key;
use crate::tui::figures::sheet::TableLine;
use crate::wording::words;
use layout::PlacedView;
use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Position, Rect, Size};
use ratatui::style::Style;

/// Columns reserved at the right of a scrollable area: a blank and a scroll mark.
const MARGIN: u16 = 2;

/// Minimum screen size for views; a smaller screen shows only state and angle.
const MIN_SIZE: Size = Size::new(40, 12);
/// Minimum screen size for any content.
const MIN_VALUE: Size = Size::new(20, 6);

pub(crate) use motion::{DrawnPlace, Sketch};
pub(crate) use pane::{Copied, Listing, Pane, PaneSpot};

impl View {
    /// Returns the pane that shows this view.
    pub(crate) fn pane(self) -> &'static dyn Pane {
        match self {
            View::Motion => &motion::MotionView,
            View::Tables => &tables::TablesView,
            View::Plots => &plots::PlotsView,
            View::Accuracy => &accuracy::AccuracyView,
            View::Forces => &forces::ForcesView,
            View::Scene => &scene::SceneView,
            View::Lengths => &lengths::LengthsView,
            View::Working => &working::WorkingView,
            View::Motor => &motor::MotorView,
            View::Polygons => &polygons::PolygonsView,
        }
    }

    /// Returns the pane that shows this view at present: while a point leads, views of the driver's
    /// motion show nothing.
    pub(crate) fn pane_in(self, app: &App) -> &'static dyn Pane {
        match app.open_scene().led() {
            Some(_) => led::pane(self),
            None => self.pane(),
        }
    }
}

/// Updates the sketch, which persists from frame to frame.
pub(crate) fn prepare(app: &App, sketch: &mut Sketch) {
    if !fits_views(app.size()) || matches!(app.mode(), Mode::AssemblyChoice(_) | Mode::Candidates) {
        return;
    }
    sketch.start_frame();
    for PlacedView { view, title, area } in placed(app) {
        let pane = pane_of(app, view, title.is_some());
        pane.prepare(app, sketch, area);
    }
}

/// Returns the area of the whole screen.
pub(crate) fn area(app: &App) -> Rect {
    full_area(app.size())
}

/// Returns the areas that a slow line sends first: the last line, which answers a key, with the
/// messages above it, and then the overlay.
pub(crate) fn urgent(app: &App) -> [Rect; 2] {
    let area = full_area(app.size());
    if !fits_views(app.size()) {
        return [area; 2];
    }
    let overlay = match app.mode() {
        Mode::Help(help) => help::placed(app, help, body(area)),
        Mode::Tour(page) => tour::placed(app, *page, body(area)),
        Mode::Recovery(found) => recovery_offer::placed(found, body(area)),
        Mode::Unsaved(_) | Mode::Confirm(_) => question::placed(app, body(area)),
        Mode::Palette(_) => palette::placed(body(area)),
        _ => Rect::ZERO,
    };
    let last = row(area, area.height - 1);
    let text = status::placed_above(app, area);
    let answer = match text.is_empty() {
        true => last,
        false => last.union(text),
    };
    [answer, overlay]
}

/// Returns the areas that move during playback on a slow line: the drawing, the line below it with
/// the position in the cycle, and the driver in the last line. Empty if no drawing is visible, or
/// if its window follows the linkage, because the legend's scale then changes with it.
pub(crate) fn moving(app: &App, sketch: &Sketch) -> Vec<Rect> {
    let is_fixed = app.views.viewport.lens.is_fixed();
    let Some(drawing) = sketch.area().filter(|_| is_fixed) else {
        return Vec::new();
    };
    let area = full_area(app.size());
    let cycle = Rect {
        height: drawing.height + 1,
        ..drawing
    };
    vec![cycle, status::moving(app, row(area, area.height - 1))]
}

/// Renders the whole screen into an empty buffer.
pub(crate) fn render(app: &App, sketch: &Sketch, buffer: &mut Buffer) {
    draw(app, sketch, buffer);
    if !app.glyphs().is_dotted() {
        spell(buffer);
    }
}

/// Replaces letters that the terminal may lack by similar ASCII letters.
fn spell(buffer: &mut Buffer) {
    for cell in &mut buffer.content {
        let letter = cell.symbol().chars().next();
        if let Some(letter) = letter.filter(|c| !c.is_ascii()).and_then(ascii_letter) {
            cell.set_char(letter);
        }
    }
}

fn draw(app: &App, sketch: &Sketch, buffer: &mut Buffer) {
    let area = full_area(app.size());
    if !fits_views(app.size()) {
        compact::render(app, area, buffer);
        return;
    }
    if let Mode::AssemblyChoice(picker) = app.mode() {
        scene_picker::render(app, picker, area, buffer);
        status::render(app, area, buffer);
        return;
    }
    let help = match app.mode() {
        Mode::Help(help) if help.returns_to_candidates => Some(help),
        _ => None,
    };
    let is_list = help.is_some() || matches!(app.mode(), Mode::Candidates);
    if let (true, Some(list)) = (is_list, app.candidates()) {
        candidates::render(app, list, area, buffer);
        if let Some(help) = help {
            help::render(app, help, body(area), buffer);
        }
        status::render(app, area, buffer);
        return;
    }
    tabs::render(app, row(area, 0), buffer);
    render_panes(app, sketch, buffer);
    match app.mode() {
        Mode::Help(help) => help::render(app, help, body(area), buffer),
        Mode::Tour(page) => tour::render(app, *page, body(area), buffer),
        Mode::Recovery(found) => recovery_offer::render(app, found, body(area), buffer),
        Mode::Unsaved(_) | Mode::Confirm(_) => {
            question::render(app, status::mode(app), body(area), buffer);
        }
        Mode::Palette(palette) => palette::render(app, palette, body(area), buffer),
        _ => {}
    }
    verdict::render(app, row(area, area.height - 2), buffer);
    status::render(app, area, buffer);
}

/// Renders the panes with their titles and the lines between them.
fn render_panes(app: &App, sketch: &Sketch, buffer: &mut Buffer) {
    let placed = placed(app);
    for (n, &PlacedView { view, title, area }) in placed.iter().enumerate() {
        let pane = pane_of(app, view, title.is_some());
        let is_looked_at = view == app.view();
        let heading = |space| pane.heading(app, space);
        match app.mode() {
            // The list of assemblies takes the second pane's place, next to the drawing.
            Mode::Assemblies(list) if n == 1 => {
                assemblies::render(app, list, inset(area), buffer);
                if let Some(title) = title {
                    let heading = |_| (words().assemblies().to_owned(), String::new());
                    title::over_pane(app, true, heading, title, buffer);
                }
            }
            mode => {
                pane.render(app, sketch, area, buffer);
                if let Some(title) = title {
                    let is_looked_at = is_looked_at && !matches!(mode, Mode::Assemblies(_));
                    title::over_pane(app, is_looked_at, heading, title, buffer);
                }
            }
        }
    }
    title::lines_between(app.glyphs(), &placed, buffer);
}

/// Returns the pane of a view. Among other panes the drawing has no tables, which have a pane of
/// their own.
fn pane_of(app: &App, view: View, is_among_others: bool) -> &'static dyn Pane {
    match view {
        View::Motion if is_among_others => &motion::DrawingPane,
        _ => view.pane_in(app),
    }
}

/// Returns the shown views and their areas.
fn placed(app: &App) -> Vec<PlacedView> {
    app.views.placement.of(app)
}

/// Returns the shown views, each with the number of its lines, of the visible ones, and of all rows of
/// its pane.
#[cfg(test)]
pub(crate) fn extents(app: &App) -> Vec<(View, usize, usize, usize)> {
    let placed = placed(app).into_iter();
    let extent = |pane: PlacedView| {
        let (lines, visible) = pane_of(app, pane.view, pane.title.is_some()).extent(app, pane.area);
        (pane.view, lines, visible, usize::from(pane.area.height))
    };
    placed.map(extent).collect()
}

/// Returns the current view's pane and its area.
fn current_pane(app: &App) -> (&'static dyn Pane, Rect) {
    let placed = placed(app);
    let own = placed.iter().find(|pane| pane.view == app.view());
    own.map_or((app.view().pane_in(app), Rect::ZERO), |own| {
        (pane_of(app, own.view, own.title.is_some()), own.area)
    })
}

/// The target at a cell of the screen.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum CellTarget {
    Nothing,
    /// The tab of a view.
    Tab(View),
    /// The hint of a key.
    Hint(Key),
    /// The drawing in the pane of a view, and the place in the scene.
    Drawing(View, DrawnPlace),
    /// The pane of a view, and the spot in it.
    Pane(View, Option<PaneSpot>),
}

/// Returns the target at a cell of the screen as drawn in the last frame.
pub(crate) fn under(app: &App, sketch: &Sketch, at: Position) -> CellTarget {
    if !fits_views(app.size()) {
        return CellTarget::Nothing;
    }
    let screen = area(app);
    let last = row(screen, screen.height - 1);
    if last.contains(at) {
        return status::key_at(app, last, at.x).map_or(CellTarget::Nothing, CellTarget::Hint);
    }
    if at.y == 0 {
        let hint = || tabs::key_at(app, screen, at.x).map(CellTarget::Hint);
        let tab = tabs::at(app, screen, at.x).map(CellTarget::Tab);
        return tab.or_else(hint).unwrap_or(CellTarget::Nothing);
    }
    let placed = placed(app);
    let own = placed.iter().find(|pane| {
        let frame = pane.title.map_or(pane.area, |title| title.union(pane.area));
        frame.contains(at)
    });
    let Some(&PlacedView { view, title, area }) = own else {
        return CellTarget::Nothing;
    };
    if let Some(seen) = sketch.place(at) {
        return CellTarget::Drawing(view, seen);
    }
    CellTarget::Pane(
        view,
        pane_of(app, view, title.is_some()).under(app, area, at),
    )
}

/// Returns the maximum scroll offset of the topmost element, in lines.
pub(crate) fn max_scroll(app: &App) -> usize {
    let (lines, page) = on_top(app);
    lines.saturating_sub(page)
}

/// Returns the lines of the tables view and the number of visible ones.
pub(crate) fn table_lines(app: &App) -> (Vec<TableLine>, usize) {
    if !fits_views(app.size()) {
        return (Vec::new(), 0);
    }
    let placed = placed(app);
    let own = placed.iter().find(|pane| pane.view == View::Tables);
    tables::lines(app, own.map_or(body(full_area(app.size())), |own| own.area))
}

/// Returns the lines of the current view as text.
pub(crate) fn current_view_lines(app: &App) -> Vec<String> {
    if !fits_views(app.size()) {
        return Vec::new();
    }
    let (pane, area) = current_pane(app);
    let (lines, _) = pane.listed(app, area);
    lines.iter().map(Line::text).collect()
}

/// Returns the indices of the current view's lines that begin a part.
pub(crate) fn current_part_starts(app: &App) -> Vec<usize> {
    if !fits_views(app.size()) {
        return Vec::new();
    }
    let (pane, area) = current_pane(app);
    let (lines, _) = pane.listed(app, area);
    let starts = |line: &Line| matches!(line.role(), TextRole::Part | TextRole::Section);
    let parts = lines.iter().enumerate().filter(|(_, line)| starts(line));
    parts.map(|(number, _)| number).collect()
}

/// Converts a screen to text, with trailing blanks trimmed.
pub(crate) fn text(screen: &Buffer) -> String {
    let width = usize::from(screen.area.width).max(1);
    let lines = screen.content.chunks(width).map(|cells| {
        let line: String = cells.iter().map(|cell| cell.symbol()).collect();
        line.trim_end().to_owned() + "\n"
    });
    lines.collect()
}

/// Returns the number of visible lines of the topmost element.
pub(crate) fn page(app: &App) -> usize {
    on_top(app).1
}

/// Returns the number of lines of the topmost element and the number of visible ones.
fn on_top(app: &App) -> (usize, usize) {
    let area = full_area(app.size());
    if !fits_views(app.size()) {
        return (0, 0);
    }
    let body = body(area);
    match app.mode() {
        Mode::Help(help) => help::extent(app, help, body),
        Mode::AssemblyChoice(picker) => scene_picker::extent(picker, middle(area)),
        Mode::Palette(palette) => palette::extent(palette, body),
        Mode::Candidates if let Some(list) = app.candidates() => {
            candidates::extent(list, middle(area))
        }
        _ => {
            let (pane, area) = current_pane(app);
            pane.extent(app, area)
        }
    }
}

fn full_area(size: Size) -> Rect {
    Rect::from((Position::ORIGIN, size))
}

/// Returns `true` if the screen is large enough for any text.
pub(crate) fn fits_text(size: Size) -> bool {
    size.width >= MIN_VALUE.width && size.height >= MIN_VALUE.height
}

/// Returns `true` if the screen is large enough for views.
pub(crate) fn fits_views(size: Size) -> bool {
    size.width >= MIN_SIZE.width && size.height >= MIN_SIZE.height
}

/// Returns the area between the first line and the last one.
fn middle(area: Rect) -> Rect {
    area.inner(Margin::new(0, 1))
}

/// Returns the area between the first line and the verdict.
fn body(area: Rect) -> Rect {
    let middle = middle(area);
    Rect {
        height: middle.height.saturating_sub(1),
        ..middle
    }
}

/// Returns the area of the panes: the body without the strip of the tour.
fn pane_area(app: &App) -> Rect {
    let body = body(full_area(app.size()));
    match app.mode() {
        Mode::Tour(page) => Rect {
            height: body.height - tour::placed(app, *page, body).height,
            ..body
        },
        _ => body,
    }
}

/// Returns the number of parts of a screen of the tour on this terminal.
pub(crate) fn tour_parts(app: &App, screen: usize) -> usize {
    tour::part_count(screen, app.keymap(), body(full_area(app.size())))
}

/// Returns the area of tables within a pane: one blank to their left, their margin to their right.
fn inset(area: Rect) -> Rect {
    Rect {
        x: area.x + 1,
        width: area.width.saturating_sub(1 + MARGIN),
        ..area
    }
}

/// Marks in the right margin of a scrolled area if there is more above or below.
fn mark_more(area: Rect, above: bool, below: bool, buffer: &mut Buffer) {
    let ends = [
        ("^", area.top(), above),
        ("v", area.bottom().saturating_sub(1), below),
    ];
    for (glyph, y, _) in ends.into_iter().filter(|(_, _, more)| *more) {
        let x = area.right() + MARGIN - 1;
        print(buffer, x, y, 1, glyph, theme::part(ScreenPart::Key));
    }
}

/// Returns the first visible line of a scrolled area and draws its scroll marks.
fn first_visible_line(scroll: usize, lines: usize, area: Rect, buffer: &mut Buffer) -> usize {
    let maximum = lines.saturating_sub(area.height.into());
    let first = scroll.min(maximum);
    mark_more(area, first > 0, first < maximum, buffer);
    first
}

/// Returns the first visible row of a list, such that the cursor is in the middle if possible.
fn first_row(cursor: usize, count: usize, height: usize) -> usize {
    let maximum = count.saturating_sub(height);
    cursor.saturating_sub(height / 2).min(maximum)
}

/// Yields the index and the line of each visible row of a list, and draws its scroll marks.
fn list_rows(
    cursor: usize,
    count: usize,
    area: Rect,
    buffer: &mut Buffer,
) -> impl Iterator<Item = (usize, Rect)> + use<> {
    let first = first_row(cursor, count, area.height.into());
    let first = first_visible_line(first, count, area, buffer);
    (first..count).zip(area.rows())
}

/// Splits an area into its first `height` lines and the rest.
fn split(area: Rect, height: u16) -> (Rect, Rect) {
    let height = height.min(area.height);
    let below = Rect {
        y: area.y + height,
        height: area.height - height,
        ..area
    };
    (Rect { height, ..area }, below)
}

/// Places a chart next to a list of the first width that leaves it `minimum` columns, or else above
/// the list in `rows` lines. Returns the areas of both.
fn chart_and_list(area: Rect, widths: &[u16], minimum: u16, rows: u16) -> (Rect, Rect) {
    let left = |width: &u16| area.width.checked_sub(width + 1 + MARGIN);
    let mut left = widths.iter().filter_map(left);
    let (chart, list) = match left.find(|width| *width >= minimum) {
        Some(width) => split_columns(area, width),
        None => split(area, rows),
    };
    (chart, inset(list))
}

/// Splits an area into its first `width` columns and the rest.
fn split_columns(area: Rect, width: u16) -> (Rect, Rect) {
    let width = width.min(area.width);
    let after = Rect {
        x: area.x + width,
        width: area.width - width,
        ..area
    };
    (Rect { width, ..area }, after)
}

fn row(area: Rect, y: u16) -> Rect {
    Rect {
        y: area.y + y,
        height: 1,
        ..area
    }
}

/// Draws a figure as large as possible in an area, for a window of these extents.
fn show_figure(app: &App, figure: &Figure, extents: &Extents, area: Rect, buffer: &mut Buffer) {
    let view = WorldView::fit(extents, area.width, area.height, app.aspect());
    show(&drawing::render(figure, &view, app.glyphs()), area, buffer);
}

/// Copies a drawing to the screen.
fn show(raster: &Raster, area: Rect, buffer: &mut Buffer) {
    for (y, line) in (area.top()..area.bottom()).zip(raster.lines()) {
        // Most cells of a drawing are background, which is there already.
        let inked = (area.left()..area.right()).zip(line);
        for (x, cell) in inked.filter(|(_, cell)| cell.glyph != ' ') {
            buffer[(x, y)]
                .set_char(cell.glyph)
                .set_style(theme::role(cell.role));
        }
    }
}

/// Prints at most `width` characters and returns the end column. Each character must be one column
/// wide.
fn print(buffer: &mut Buffer, x: u16, y: u16, width: u16, text: &str, style: Style) -> u16 {
    let end = (x.saturating_add(width)).min(buffer.area.right());
    if y >= buffer.area.bottom() {
        return x;
    }
    let cells = (x..end).zip(text.chars());
    let mut next = x;
    for (x, c) in cells {
        buffer[(x, y)].set_char(c).set_style(style);
        next = x + 1;
    }
    next
}

/// Prints text in the first line of an area, as far as it fits.
fn print_line(buffer: &mut Buffer, area: Rect, text: &str, part: ScreenPart) {
    print(buffer, area.x, area.y, area.width, text, theme::part(part));
}

/// Prints text that ends before column `right`.
fn print_right(buffer: &mut Buffer, right: u16, y: u16, text: &str, style: Style) {
    let length = columns(text);
    let x = right.saturating_sub(length);
    print(buffer, x, y, length, text, style);
}

/// Returns the width of text whose characters are all one column wide.
fn columns(text: &str) -> u16 {
    u16::try_from(text.chars().count()).unwrap_or(u16::MAX)
}
