//! What the scene gives.

use super::print;
use crate::tui::app::App;
use crate::tui::theme::{self, Part};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

pub(super) fn render(_app: &App, area: Rect, buffer: &mut Buffer) {
    let text = "not there yet";
    print(
        buffer,
        area.x,
        area.y,
        area.width,
        text,
        theme::part(Part::Text),
    );
}
