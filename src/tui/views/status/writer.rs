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
}

impl<'a> Writer<'a> {
    pub(super) fn new(area: Rect, buffer: &'a mut Buffer) -> Writer<'a> {
        Writer {
            buffer,
            x: area.x,
            area,
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

    /// A message, over what stands before it if there is no room behind.
    pub(super) fn tell(&mut self, message: &str, app: &App) {
        let message = shown(message, app.glyphs());
        let latest = self.area.right().saturating_sub(columns(&message));
        let latest = latest.max(self.area.x);
        if latest < self.x {
            // It covers, but does not run into what it does not cover.
            self.x = latest.saturating_sub(1).max(self.area.x);
            self.say(" ", ScreenPart::Text);
            self.x = latest;
        }
        self.say(&message, ScreenPart::Warning);
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
