//! Renders a screen of the tour in a strip below the panes, which get the other rows, so that nothing
//! that the tour describes is covered.
//!
//! ```text
//!  drawing                         | tables
//! =[Tour 2/5: Moving the crank]==== Enter next  Left back  Esc end =
//!  . and , step: try it now.
//! ```

pub(crate) mod screens;

use super::{columns, print_line, title};
use crate::tui::app::App;
use crate::tui::appearance::theme::ScreenPart;
use crate::tui::commands::key::Key;
use crate::tui::commands::keymap::Keymap;
use crate::tui::views::tour::screens::{SCREENS, TourPage, screen, wrapped};
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Blanks on both sides of the text.
const INDENT: u16 = 1;
/// Maximum width of the text; longer lines are hard to read.
const MAX_TEXT: u16 = 96;
/// Rows that the panes keep, at least.
const MIN_ROWS_OF_PANES: u16 = 4;

pub(super) fn render(app: &App, page: TourPage, body: Rect, buffer: &mut Buffer) {
    let parts = parts(page.screen, app.keymap(), body);
    let place = placed(app, page, body);
    let part = page.part.min(parts.len() - 1);
    let last = page.screen + 1 == SCREENS && part + 1 == parts.len();
    let next = if last { words().done() } else { words().next() };
    let heading = |space| {
        let own = screen(page.screen, app.keymap()).title;
        let number = page.screen + 1;
        let title = words().tour_title(number, SCREENS, own);
        // The last line of a narrow terminal has the key that ends the tour.
        let enter = format!("{} {next}", Key::Enter);
        let forms = [
            (title.clone(), words().tour_keys(next)),
            (title.clone(), enter.clone()),
            (format!("{number}/{SCREENS} {own}"), enter.clone()),
            (format!("{number}/{SCREENS}"), enter),
        ];
        let fits = |(left, right): &(String, String)| columns(left) + columns(right) <= space;
        forms
            .into_iter()
            .find(fits)
            .unwrap_or((title, String::new()))
    };
    let top = Rect { height: 1, ..place };
    title::over_pane(app, true, heading, top, buffer);
    for (row, line) in place.rows().skip(1).zip(&parts[part]) {
        let row = Rect {
            x: row.x + INDENT,
            width: row.width.saturating_sub(2 * INDENT),
            ..row
        };
        print_line(buffer, row, line, ScreenPart::Text);
    }
}

/// Returns the area of a page of the tour: the last rows of the body. The parts of a screen have the
/// same height, so that the panes stand still.
pub(super) fn placed(app: &App, page: TourPage, body: Rect) -> Rect {
    let parts = parts(page.screen, app.keymap(), body);
    let rows = parts.iter().map(Vec::len).max().unwrap_or(0);
    let height = u16::try_from(rows + 1).unwrap_or(u16::MAX).min(body.height);
    Rect {
        y: body.bottom() - height,
        height,
        ..body
    }
}

/// Returns the number of parts into which a screen of the tour is divided in a body of this size.
pub(crate) fn part_count(screen: usize, keymap: &Keymap, body: Rect) -> usize {
    parts(screen, keymap, body).len()
}

/// Divides the lines of a screen into parts that leave the panes their rows; there is at least one.
fn parts(number: usize, keymap: &Keymap, body: Rect) -> Vec<Vec<String>> {
    let width = body.width.saturating_sub(2 * INDENT).min(MAX_TEXT);
    let lines = wrapped(&screen(number, keymap).text, width.into());
    let most = body.height.saturating_sub(MIN_ROWS_OF_PANES + 1).max(1);
    // Parts of equal height, none with a single left-over line.
    let count = lines.len().div_ceil(most.into()).max(1);
    let rows = lines.len().div_ceil(count).max(1);
    let parts: Vec<Vec<String>> = lines.chunks(rows).map(<[String]>::to_vec).collect();
    match parts.is_empty() {
        true => vec![Vec::new()],
        false => parts,
    }
}
