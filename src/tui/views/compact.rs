//! The minimal display on a screen too small for any view: the driver's value and the state.
//!
//! ```text
//! four-bar
//!  60.00 deg
//! ok
//!
//! 40 x 12 show more
//! ```

use super::{MIN_SIZE, MIN_VALUE, cut, fits_text, print, question, row, status};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let text = theme::part(ScreenPart::Text);
    if !fits_text(app.size()) {
        let needed = words().screen_too_small(MIN_VALUE.width, MIN_VALUE.height);
        let lines = status::broken(&needed, area.width.into());
        for (line, row) in lines.iter().zip(area.rows()) {
            print(buffer, row.x, row.y, row.width, line, text);
        }
        return;
    }
    let mut put = |y: u16, line: &str| {
        let line = cut(line, area.width.into());
        print(buffer, area.x, area.y + y, area.width, &line, text);
    };
    // A question about losing data comes before state and angle, which can wait.
    let requested = question::lines(app, area);
    if !requested.is_empty() {
        for (y, line) in (0..area.height).zip(&requested) {
            put(y, line);
        }
        return;
    }
    let [scene, driver, state] = status::in_short(app);
    let message = shown(app.message().unwrap_or_default(), app.glyphs());
    let texts = status::broken(&message, area.width.into());
    let lines = [scene, driver, state].into_iter().chain(texts);
    for (y, line) in (0..area.height.saturating_sub(1)).zip(lines) {
        put(y, &line);
    }
    if app.mode().is_normal() {
        let more = words().more_is_shown(MIN_SIZE.width, MIN_SIZE.height);
        put(area.height - 1, &more);
    } else {
        let _ = status::line(app, row(area, area.height - 1), buffer);
    }
}
