//! Renders a screen of the tour: a panel at the right, so that the linkage stays visible, or over
//! the full width of a narrow screen.
//!
//! ```text
//!  drawing      +- Tour 2/5: Moving the crank -+
//!               | . and , step: try it now.    |
//!               +- Enter next  Left back ------+
//! ```

pub(crate) mod screens;

use super::popup::{self, BORDER};
use super::{print_line, print_right};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::views::tour::screens::{SCREENS, TourScreen, screen, wrapped};
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Width of the text; it is wider if the panel covers the full width.
const TEXT: u16 = 32;
/// Minimum width for a drawing next to the text.
const MIN_WIDTH_WITH_DRAWING: u16 = 70;

pub(super) fn render(app: &App, number: usize, area: Rect, buffer: &mut Buffer) {
    let screen = screen(number, app.keymap());
    let (place, text) = laid_out(&screen, area);
    let title = words().tour_title(number + 1, SCREENS, screen.title);
    popup::frame(app.glyphs(), place, &title, buffer);
    let inner = popup::within(place);
    for (row, line) in inner.rows().zip(&text) {
        print_line(buffer, row, line, ScreenPart::Text);
    }
    let next = match number + 1 < SCREENS {
        true => words().next(),
        false => words().done(),
    };
    let keys = format!(" {} ", words().tour_keys(next));
    let style = theme::part(ScreenPart::Quiet);
    print_right(buffer, place.right() - 1, place.bottom() - 1, &keys, style);
}

/// Returns the area of a screen of the tour.
pub(super) fn placed(app: &App, number: usize, area: Rect) -> Rect {
    laid_out(&screen(number, app.keymap()), area).0
}

/// Returns the area of a screen of the tour and its lines.
fn laid_out(screen: &TourScreen, area: Rect) -> (Rect, Vec<String>) {
    let side = area.width >= MIN_WIDTH_WITH_DRAWING;
    let width = if side { TEXT + BORDER.0 } else { area.width };
    let text = wrapped(&screen.text, (width - BORDER.0).into(), side);
    let rows = u16::try_from(text.len()).unwrap_or(u16::MAX);
    let height = rows.saturating_add(BORDER.1).min(area.height);
    // On a narrow screen the panel is at the bottom, below the drawing.
    let y = if side { area.y } else { area.bottom() - height };
    let place = Rect {
        x: area.right() - width,
        y,
        width,
        height,
    };
    (place, text)
}
