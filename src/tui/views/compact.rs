//! What a screen tells that has no room for a view: where the driver stands, and how the mechanism.
//!
//! ```text
//! four-bar
//!  60.00 deg
//! ok
//!
//! 40 x 12 show more
//! ```

use super::{LEAST, SMALLEST, cut, print, status};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let text = theme::part(ScreenPart::Text);
    if area.width < LEAST.width || area.height < LEAST.height {
        let needed = words().screen_too_small(LEAST.width, LEAST.height);
        print(buffer, area.x, area.y, area.width, &needed, text);
        return;
    }
    let [scene, driver, state] = status::in_short(app);
    let message = shown(app.message().unwrap_or_default(), app.glyphs());
    let more = words().more_is_shown(SMALLEST.width, SMALLEST.height);
    let lines = [
        (0, scene),
        (1, driver),
        (2, state),
        (3, message),
        (area.height - 1, more),
    ];
    for (y, line) in lines {
        let line = cut(&line, area.width.into());
        print(buffer, area.x, area.y + y, area.width, &line, text);
    }
}
