//! Writing along a line.

use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown;
use crate::tui::views::{columns, print};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Writes along the line.
pub(super) struct Writer<'a> {
    buffer: &'a mut Buffer,
    x: u16,
    area: Rect,
    /// What was said and has no room in the line.
    untold: Option<String>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(area: Rect, buffer: &'a mut Buffer) -> Writer<'a> {
        Writer {
            buffer,
            x: area.x,
            area,
            untold: None,
        }
    }

    /// Columns that are left.
    pub(super) fn room(&self) -> u16 {
        self.room_from(self.x)
    }

    /// Columns from a place on.
    pub(super) fn room_from(&self, x: u16) -> u16 {
        self.area.right().saturating_sub(x)
    }

    /// Where the next text begins.
    pub(super) fn x(&self) -> u16 {
        self.x
    }

    /// Goes on to this place, if it lies ahead.
    pub(super) fn go_to(&mut self, x: u16) {
        self.x = self.x.max(x);
    }

    pub(super) fn say(&mut self, text: &str, part: ScreenPart) {
        let (room, style) = (self.room(), theme::part(part));
        self.x = print(self.buffer, self.x, self.area.y, room, text, style);
    }

    pub(super) fn gap(&mut self, columns: u16) {
        self.x = self.x.saturating_add(columns);
    }

    /// A message, as a whole; false where there is no room for that, and it is left to be told above the line.
    pub(super) fn tell(&mut self, message: &str, app: &App) -> bool {
        let told = shown(message, app.glyphs());
        if columns(&told) > self.room() {
            self.leave_untold(message);
            return false;
        }
        self.say(&told, ScreenPart::Warning);
        true
    }

    /// A message in the place of all that stands in the line; false where it is longer than that, and is left to be told
    /// above.
    pub(super) fn tell_alone(&mut self, message: &str, app: &App) -> bool {
        let told = shown(message, app.glyphs());
        let spare = self.area.width.checked_sub(columns(&told));
        let Some(spare) = spare else {
            self.leave_untold(message);
            return false;
        };
        self.x = self.area.x;
        self.say(&" ".repeat(self.area.width.into()), ScreenPart::Text);
        self.x = self.area.x + spare.min(1);
        self.say(&told, ScreenPart::Warning);
        true
    }

    /// This has no room in the line.
    pub(super) fn leave_untold(&mut self, message: &str) {
        self.untold = Some(message.to_owned());
    }

    /// What has no room in the line.
    pub(super) fn untold(self) -> Option<String> {
        self.untold
    }

    /// The end of what is typed that has room, with the caret behind it.
    pub(super) fn typed(&mut self, text: &str) {
        let room = usize::from(self.room().saturating_sub(1));
        let skipped = text.chars().count().saturating_sub(room);
        let seen: String = text.chars().skip(skipped).collect();
        self.say(&seen, ScreenPart::Text);
        self.say(" ", ScreenPart::Caret);
    }

    /// A key and what it does; nothing where there is no room for both.
    pub(super) fn hint(&mut self, key: &str, name: &str) {
        let needed = columns(key) + 1 + columns(name);
        if needed > self.room() {
            self.x = self.area.right();
            return;
        }
        self.say(key, ScreenPart::Key);
        self.gap(1);
        self.say(name, ScreenPart::Quiet);
        self.gap(2);
    }
}
