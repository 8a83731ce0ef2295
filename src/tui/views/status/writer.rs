//! Writes text along a line.

use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::key::Key;
use crate::tui::player::open_scene::shown;
use crate::tui::views::{columns, print};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use std::ops::Range;

/// A cursor that writes along a line.
pub(super) struct Writer<'a> {
    buffer: &'a mut Buffer,
    x: u16,
    area: Rect,
    /// The first column behind the driver and its limits, if the line shows them.
    pub(super) driver_end: Option<u16>,
    /// The keys of the hints, with the columns of each hint.
    keys: Vec<(Range<u16>, Key)>,
    /// The message that does not fit into the line.
    pending_message: Option<String>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(area: Rect, buffer: &'a mut Buffer) -> Writer<'a> {
        Writer {
            buffer,
            x: area.x,
            area,
            driver_end: None,
            keys: Vec::new(),
            pending_message: None,
        }
    }

    /// Returns the columns that are left.
    pub(super) fn columns_left(&self) -> u16 {
        self.columns_from(self.x)
    }

    /// Returns the columns from `x` to the end of the line.
    pub(super) fn columns_from(&self, x: u16) -> u16 {
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

    pub(super) fn write_text(&mut self, text: &str, part: ScreenPart) {
        let (space, style) = (self.columns_left(), theme::part(part));
        self.x = print(self.buffer, self.x, self.area.y, space, text, style);
    }

    pub(super) fn gap(&mut self, columns: u16) {
        self.x = self.x.saturating_add(columns);
    }

    /// Writes the message if there is one and it fits.
    pub(super) fn shows_message(&mut self, app: &App) -> bool {
        let message = app.message();
        message.is_some_and(|message| self.write_message(message, app))
    }

    /// Writes a message. Returns `false` if it does not fit completely; it is then kept for the
    /// lines above.
    pub(super) fn write_message(&mut self, message: &str, app: &App) -> bool {
        let text = shown(message, app.glyphs());
        if columns(&text) > self.columns_left() {
            self.keep_message(message);
            return false;
        }
        self.write_text(&text, ScreenPart::Warning);
        true
    }

    /// Writes a message in place of the whole line. Returns `false` if it is too long; it is then
    /// kept for the lines above.
    pub(super) fn replace_with_message(&mut self, message: &str, app: &App) -> bool {
        let text = shown(message, app.glyphs());
        let spare = self.area.width.checked_sub(columns(&text));
        let Some(spare) = spare else {
            self.keep_message(message);
            return false;
        };
        self.x = self.area.x;
        self.write_text(&" ".repeat(self.area.width.into()), ScreenPart::Text);
        self.x = self.area.x + spare.min(1);
        self.write_text(&text, ScreenPart::Warning);
        true
    }

    /// Keeps a message that does not fit into the line.
    pub(super) fn keep_message(&mut self, message: &str) {
        self.pending_message = Some(message.to_owned());
    }

    /// Returns the key whose hint is at a column.
    pub(super) fn key_at(&self, x: u16) -> Option<Key> {
        let mut keys = self.keys.iter();
        let found = keys.find(|(columns, _)| columns.contains(&x));
        found.map(|(_, key)| *key)
    }

    /// Returns the message that does not fit into the line.
    pub(super) fn take_message(self) -> Option<String> {
        self.pending_message
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
        let space = usize::from(self.columns_left().saturating_sub(1));
        let skipped = text.chars().count().saturating_sub(space);
        let seen: String = text.chars().skip(skipped).collect();
        self.write_text(&seen, part);
        self.write_text(" ", ScreenPart::Caret);
    }

    /// Writes a key and its effect, or nothing if they do not fit.
    pub(super) fn hint(&mut self, key: &str, name: &str) {
        let needed = columns(key) + 1 + columns(name);
        if needed > self.columns_left() {
            self.x = self.area.right();
            return;
        }
        let start = self.x;
        self.write_text(key, ScreenPart::Key);
        self.gap(1);
        self.write_text(name, ScreenPart::Quiet);
        // A hint of several keys, such as `n N`, stands for the first one.
        let first = key.split(' ').next().map(str::parse::<Key>);
        if let Some(Ok(key)) = first {
            self.keys.push((start..self.x, key));
        }
        self.gap(2);
    }
}
