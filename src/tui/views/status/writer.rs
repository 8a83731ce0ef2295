//! Writes text along a line.

use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown;
use crate::tui::views::{columns, print};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// A cursor that writes along a line.
pub(super) struct Writer<'a> {
    buffer: &'a mut Buffer,
    x: u16,
    area: Rect,
    /// The message that does not fit into the line.
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

    /// Returns the columns that are left.
    pub(super) fn room(&self) -> u16 {
        self.room_from(self.x)
    }

    /// Returns the columns from `x` to the end of the line.
    pub(super) fn room_from(&self, x: u16) -> u16 {
        self.area.right().saturating_sub(x)
    }

    /// Returns the column of the next text.
    pub(super) fn x(&self) -> u16 {
        self.x
    }

    /// Moves to a column if it is ahead.
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

    /// Writes a message. Returns `false` if it does not fit completely; it is then kept for the
    /// lines above.
    pub(super) fn tell(&mut self, message: &str, app: &App) -> bool {
        let told = shown(message, app.glyphs());
        if columns(&told) > self.room() {
            self.leave_untold(message);
            return false;
        }
        self.say(&told, ScreenPart::Warning);
        true
    }

    /// Writes a message in place of the whole line. Returns `false` if it is too long; it is then
    /// kept for the lines above.
    pub(super) fn replace_with_message(&mut self, message: &str, app: &App) -> bool {
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

    /// Keeps a message that does not fit into the line.
    pub(super) fn leave_untold(&mut self, message: &str) {
        self.untold = Some(message.to_owned());
    }

    /// Returns the message that does not fit into the line.
    pub(super) fn untold(self) -> Option<String> {
        self.untold
    }

    /// Writes the end of typed text that fits, with the caret behind it.
    pub(super) fn typed(&mut self, text: &str) {
        self.with_caret(text, ScreenPart::Text);
    }

    /// Writes a proposal, marked as text that the first key replaces.
    pub(super) fn proposed(&mut self, text: &str) {
        self.with_caret(text, ScreenPart::Cursor);
    }

    fn with_caret(&mut self, text: &str, part: ScreenPart) {
        let room = usize::from(self.room().saturating_sub(1));
        let skipped = text.chars().count().saturating_sub(room);
        let seen: String = text.chars().skip(skipped).collect();
        self.say(&seen, part);
        self.say(" ", ScreenPart::Caret);
    }

    /// Writes a key and its effect, or nothing if they do not fit.
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
