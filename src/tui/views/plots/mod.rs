//! Plots view: quantities over the motion, with the list of quantities at their left.
//!
//! ```text
//!  plot what?        2 of 28  | mm/s  * C.vx -722.6      over driver.angle 60.00 deg
//!   [x] C.vx     mm/s         |  1000 |   **^***
//! > [ ] C.vy     mm/s         |     0 |***:.....
//! ```

pub(crate) mod curves;
mod excursion_note;
pub(crate) mod list;

use super::pane::{Copied, Pane, PaneSpot};
use super::{
    Sketch, columns, cut, first_visible_line, inset, list_rows, mark_more, page, print, print_line,
    print_right, show, split, split_columns,
};
use crate::drawing::plot::{Plot, PlotStyle};
use crate::page::Line;
use crate::quantity::{Abscissa, Quantity, Subject};
use crate::tui::app::{App, Mode, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{Action, PlotsAction};
use crate::tui::figures::copying;
use crate::tui::player::open_scene::shown;
use crate::tui::views::plots::list::PlotList;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Width of the list next to a plot, and the minimum screen width for both; on a narrower screen
/// the list is alone.
const LIST: u16 = 30;
const BOTH: u16 = 70;
/// Height of the list's heading.
const HEAD: u16 = 1;
/// Column of the selection mark.
const MARKED: usize = 3;
/// Maximum width of a name; longer names are cut.
const NAME: u16 = 16;

/// The areas of the list and of the plot.
struct PlotAreas {
    list: Option<Rect>,
    plot: Option<Rect>,
}

fn arrange(app: &App, area: Rect) -> PlotAreas {
    let complete = inset(area);
    if !matches!(app.mode(), Mode::PlotList(_)) {
        return PlotAreas {
            list: None,
            plot: Some(complete),
        };
    }
    if area.width < BOTH {
        return PlotAreas {
            list: Some(inset(area)),
            plot: None,
        };
    }
    PlotAreas {
        list: Some(inset(split_columns(area, LIST).0)),
        plot: Some(split_columns(complete, LIST).1),
    }
}

/// The plots view: quantities over the motion.
pub(super) struct PlotsView;

impl Pane for PlotsView {
    fn view(&self) -> View {
        View::Plots
    }

    fn subject(&self, app: &App) -> Option<Subject> {
        match app.mode() {
            Mode::PlotList(list) => list.subject(),
            _ => None,
        }
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        if let Some((first, lines)) = read(app, body) {
            render_read(app, first, &lines, inset(body), buffer);
            return;
        }
        let PlotAreas { list, plot } = arrange(app, body);
        if let Some(body) = plot {
            render_plot(app, body, buffer);
        }
        if let (Some(body), Mode::PlotList(list)) = (list, app.mode()) {
            render_list(app, list, body, buffer);
        }
    }

    fn under(&self, app: &App, body: Rect, at: Position) -> Option<PaneSpot> {
        let area = arrange(app, body).plot.filter(|area| area.contains(at))?;
        let plot = app.views.plots.plot().ok()?;
        let along = || plot.along(&style(app, area), at.x - area.x);
        match app.views.plots.curves()?.abscissa {
            Abscissa::Driver => along().map(PaneSpot::PlotAxis),
            Abscissa::Time if app.open_scene().timetable().is_some() => along().map(PaneSpot::Time),
            Abscissa::Time | Abscissa::Figure(_) => None,
        }
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        if let Some((_, lines)) = read(app, body) {
            return (lines.len(), inset(body).height.into());
        }
        match (arrange(app, body).list, app.mode(), app.views.plots.plot()) {
            (Some(body), Mode::PlotList(list), _) => {
                (list.list.count().0, rows_of_list(app, body).height.into())
            }
            (_, _, Ok(plot)) => (plot.panels.len(), plot.panels_in(body.height)),
            (_, _, Err(_)) => (0, 0),
        }
    }

    fn is_timed(&self, app: &App) -> bool {
        app.views.plots.is_timed()
    }

    fn hints(&self, _app: &App) -> &'static [Action] {
        &[
            Action::Help,
            Action::Plots(PlotsAction::Choose),
            Action::LineDown,
            Action::Plots(PlotsAction::Abscissa),
            Action::MOTION,
            Action::Play,
            Action::StepForward,
            Action::Quit,
        ]
    }

    fn copy(&self, app: &App) -> Copied {
        app.views.plots.curves().map_or(Copied::Nothing, |curves| {
            let here = app.views.plots.here(app.open_scene());
            Copied::Text(copying::plotted(curves, app.open_scene().at(), here))
        })
    }

    fn csv(&self, app: &App) -> Result<String, String> {
        app.views
            .plots
            .csv(app.csv_dialect())
            .ok_or_else(|| words().nothing_plotted_to_write().into())
    }

    fn svg(&self, app: &App) -> Result<(&'static str, String), String> {
        let text = app.views.plots.svg(app.open_scene());
        let text = text.ok_or(words().nothing_plotted_to_write())?;
        Ok((words().the_plot(), text))
    }

    fn file_part(&self) -> Option<&'static str> {
        Some("plot")
    }
}

/// Returns the first visible line and the lines of the selected quantity's summary, if it is open.
fn read(app: &App, body: Rect) -> Option<(usize, Vec<Line>)> {
    let Mode::PlotList(list) = app.mode() else {
        return None;
    };
    let first = list.read()?;
    Some((
        first,
        page::lines(app, app.views.plots.noted_page(), inset(body)),
    ))
}

fn render_read(app: &App, first: usize, lines: &[Line], area: Rect, buffer: &mut Buffer) {
    let first = first_visible_line(first, lines.len(), area, buffer);
    for (row, line) in area.rows().zip(lines.iter().skip(first)) {
        page::render_line((app.glyphs(), app.colours()), line, row, buffer);
    }
}

fn render_plot(app: &App, area: Rect, buffer: &mut Buffer) {
    let plot = match app.views.plots.plot() {
        Ok(plot) => plot,
        Err(why) => {
            print_reason(app, why, area, buffer);
            return;
        }
    };
    let area = print_hidden_reason(app, area, buffer);
    let look = style(app, area);
    if let Some(raster) = app.views.plots.render(&look, app.open_scene()) {
        show(&raster, area, buffer);
    }
    mark_panels(plot, &look, area, buffer);
}

/// Returns the style of the plot in an area.
fn style(app: &App, area: Rect) -> PlotStyle {
    PlotStyle {
        cols: area.width,
        rows: area.height,
        glyphs: app.glyphs(),
        aspect: app.aspect(),
        extrema: app.views.plots.extrema(),
        first: app.views.scroll[View::Plots as usize],
    }
}

/// Prints the reason why some curves are hidden, and returns the area below it.
fn print_hidden_reason(app: &App, area: Rect, buffer: &mut Buffer) -> Rect {
    let Some(why) = app.views.plots.hidden() else {
        return area;
    };
    let lines = crate::page::wrapped(&shown(&why, app.glyphs()), area.width.into());
    let height = u16::try_from(lines.len()).unwrap_or(area.height);
    let (text, rest) = split(area, height.min(area.height / 2));
    for (row, line) in text.rows().zip(&lines) {
        print_line(buffer, row, line, ScreenPart::Text);
    }
    rest
}

/// Marks at the right edge if there are more panels above or below.
fn mark_panels(plot: &Plot, style: &PlotStyle, area: Rect, buffer: &mut Buffer) {
    let hidden = plot.panels.len() - plot.panels_in(style.rows);
    let first = style.first.min(hidden);
    mark_more(area, first > 0, first < hidden, buffer);
}

/// Prints the reason why there is no plot in the middle of the area, with the keys that help.
fn print_reason(app: &App, why: &str, area: Rect, buffer: &mut Buffer) {
    let lead = |(action, what)| {
        let key = app.keymap().key(Action::Plots(action))?;
        Some(format!("{key}  {what}"))
    };
    let leads = [
        (PlotsAction::Choose, words().choose_what_is_plotted()),
        (PlotsAction::Abscissa, words().put_something_else_along_x()),
    ];
    let leads: Vec<String> = leads.into_iter().filter_map(lead).collect();
    let width = usize::from(area.width);
    let lines = crate::page::wrapped(&shown(why, app.glyphs()), width);
    let rows = u16::try_from(lines.len() + 1 + leads.len()).unwrap_or(area.height);
    let mut y = area.y + area.height.saturating_sub(rows) / 2;
    let block = leads.iter().map(|line| columns(line)).max().unwrap_or(0);
    let mut wording = |text: &str, width: u16, part| {
        if y < area.bottom() {
            let x = area.x + area.width.saturating_sub(width) / 2;
            print(buffer, x, y, area.width, text, theme::part(part));
        }
        y += 1;
    };
    for line in &lines {
        wording(line, columns(line), ScreenPart::Text);
    }
    wording("", 0, ScreenPart::Text);
    for line in &leads {
        wording(line, block, ScreenPart::Quiet);
    }
}

fn render_list(app: &App, list: &PlotList, area: Rect, buffer: &mut Buffer) {
    let (found, all) = list.list.count();
    let quiet = theme::part(ScreenPart::Quiet);
    match list.search() {
        None => {
            print_line(buffer, area, words().plot_what(), ScreenPart::Quiet);
            let count = words().some_of(app.views.plots.count(), all);
            print_right(buffer, area.right(), area.y, &count, quiet);
        }
        Some((text, typing)) => {
            let space = usize::from(area.width).saturating_sub(columns_of(found) + 3);
            let skipped = text.len().saturating_sub(space.saturating_sub(1));
            let seen = text.get(skipped..).unwrap_or_default();
            let x = print(buffer, area.x, area.y, area.width, "/", quiet);
            let style = theme::part(ScreenPart::Text);
            let x = print(buffer, x, area.y, area.width, seen, style);
            if typing {
                print(buffer, x, area.y, 1, " ", theme::part(ScreenPart::Caret));
            }
            print_right(buffer, area.right(), area.y, &found.to_string(), quiet);
        }
    }
    let rows = rows_of_list(app, area);
    if found == 0 {
        print_line(
            buffer,
            rows,
            words().no_figure_has_that(),
            ScreenPart::Quiet,
        );
        return;
    }
    let (listed, cursor): (Vec<_>, _) = (list.list.listed().collect(), list.list.cursor());
    for (at, row) in list_rows(cursor, found, rows, buffer) {
        render_row(app, listed[at], at == cursor, row, buffer);
    }
    let notes = app.views.plots.noted();
    for (row, line) in area
        .rows()
        .skip_while(|row| row.y <= rows.bottom())
        .zip(notes)
    {
        let line = cut(&shown(line, app.glyphs()), area.width.into());
        print_line(buffer, row, &line, ScreenPart::Quiet);
    }
}

/// Renders a quantity of the list: the cursor, the mark of a plotted one, its name and its unit.
fn render_row(app: &App, quantity: &Quantity, is_here: bool, row: Rect, buffer: &mut Buffer) {
    let part = |other| theme::part(if is_here { ScreenPart::Key } else { other });
    let mark = match (is_here, app.views.plots.is_chosen(&quantity.name)) {
        (true, true) => "> [x] ",
        (true, false) => "> [ ] ",
        (false, true) => "  [x] ",
        (false, false) => "  [ ] ",
    };
    let style = part(ScreenPart::Text);
    let x = print(buffer, row.x, row.y, row.width, mark, style);
    let plot = app.views.plots.plot().ok();
    if let Some(role) = plot.and_then(|plot| plot.role_of(&quantity.name)) {
        // The mark between the brackets has the curve's hue.
        let at = row.x + columns(&mark[..MARKED]);
        let sign = &mark[MARKED..=MARKED];
        print(buffer, at, row.y, 1, sign, theme::role(role));
    }
    let space = row.right().saturating_sub(x);
    let name = cut(&quantity.name, usize::from(NAME.min(space)));
    let name = shown(&name, app.glyphs());
    print(buffer, x, row.y, space, &name, part(ScreenPart::Name));
    let x = (x + NAME + 1).min(x + columns(&name).max(9) + 1);
    let space = row.right().saturating_sub(x);
    let style = part(ScreenPart::Quiet);
    print(buffer, x, row.y, space, &quantity.unit, style);
}

/// Returns the area of the list's rows. The summary of the selected quantity is below them, if both
/// fit.
fn rows_of_list(app: &App, area: Rect) -> Rect {
    let rows = split(area, HEAD).1;
    let notes = u16::try_from(app.views.plots.noted().len()).unwrap_or(0);
    match notes > 0 && rows.height >= 2 * (notes + 1) {
        true => split(rows, rows.height - notes - 1).0,
        false => rows,
    }
}

/// Returns the number of decimal digits of `count`.
fn columns_of(count: usize) -> usize {
    count.to_string().len()
}
