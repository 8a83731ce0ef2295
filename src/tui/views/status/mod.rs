//! The status line: mode, scene, driver, state, its cost and its largest error bound, followed by
//! as many key hints as fit. A message that is too long for it is shown above.
//!
//! ```text
//!  motion  four-bar   60.00 deg  ok  63 ns, +-2e-13 mm  ? help  space play  q quit
//!  motion  peaucellier   79.60 deg  dead point in 3.2 deg  ? help  space play  q quit
//! ```

mod facts;
mod hints;
mod long_message;
mod prompts;
mod writer;

use super::{columns, cut, row};
use crate::solver::Condition;
use crate::tui::app::{App, Mode};
use crate::tui::appearance::theme::ScreenPart;
use crate::tui::commands::key::Key;
use crate::tui::player::open_scene::shown;
use crate::wording::words;
pub(super) use facts::{mode, state};
use long_message::MessageLines;
pub(super) use long_message::broken;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use writer::Writer;

/// Maximum and minimum width of a scene's name. It is cut, sooner on short lines, and left out if
/// less than the minimum remains.
const MAX_SCENE_LEN: usize = 20;
const MIN_SCENE_LEN: u16 = 6;

/// Minimum width of a line with double blanks between its parts.
const MIN_WIDTH_WITH_GAPS: u16 = 60;

/// Columns reserved for hints, which are more important than the cost of a state.
const HINTS: u16 = 26;

/// Renders the status line, and above it a message that is too long for it.
pub(super) fn render(app: &App, screen: Rect, buffer: &mut Buffer) {
    if let Some(message) = line(app, row(screen, screen.height - 1), buffer) {
        MessageLines::of(&message, app, screen).render(buffer);
    }
}

/// Returns the area of the message above the status line; zero if there is none.
pub(super) fn placed_above(app: &App, screen: Rect) -> Rect {
    if app.message().is_none() {
        return Rect::ZERO;
    }
    let last = row(screen, screen.height - 1);
    let untold = line(app, last, &mut Buffer::empty(last));
    untold.map_or(Rect::ZERO, |message| {
        MessageLines::of(&message, app, screen).place
    })
}

/// Renders the status line alone. Returns the message if it is too long for the line.
pub(super) fn line(app: &App, area: Rect, buffer: &mut Buffer) -> Option<String> {
    written(app, area, buffer).take_message()
}

/// Returns the key whose hint is at a column of the status line.
pub(super) fn key_at(app: &App, area: Rect, x: u16) -> Option<Key> {
    written(app, area, &mut Buffer::empty(area)).key_at(x)
}

/// Returns the part of the status line up to the driver and its limits: what moves during playback,
/// without the cost and the error bound of a state.
pub(super) fn moving(app: &App, area: Rect) -> Rect {
    let end = written(app, area, &mut Buffer::empty(area)).driver_end;
    let width = end.map_or(area.width, |end| end.saturating_sub(area.x).min(area.width));
    Rect { width, ..area }
}

/// Renders the status line and returns its writer.
fn written<'a>(app: &App, area: Rect, buffer: &'a mut Buffer) -> Writer<'a> {
    let mut line = Writer::new(area, buffer);
    line.write_text(&format!(" {} ", facts::mode(app)), ScreenPart::Mode);
    if !prompts::render(app, &mut line) {
        let narrow = area.width < MIN_WIDTH_WITH_GAPS;
        let is_shown = app
            .message()
            .is_some_and(|message| with_message(app, narrow, message, &mut line));
        if !is_shown {
            with_hints(app, narrow, &mut line);
        }
    }
    line
}

/// Returns scene, driver and state for a screen that shows nothing else.
pub(super) fn in_short(app: &App) -> [String; 3] {
    let state = facts::state(app.condition(), true).0;
    [facts::scene(app), facts::driver_in_time(app), state.into()]
}

/// Renders the most important facts and the message. Returns `false` and writes nothing if the
/// message does not fit.
fn with_message(app: &App, narrow: bool, message: &str, line: &mut Writer<'_>) -> bool {
    let studied = facts::progress(app);
    let is_studied = studied.is_some();
    let driver = studied.unwrap_or_else(|| facts::driver_in_time(app));
    let is_missing = app.condition() != Condition::Ok;
    let (state, part) = match is_studied {
        true => ("", ScreenPart::Text),
        false => facts::state(app.condition(), narrow),
    };
    let why = if is_missing { columns(state) + 2 } else { 0 };
    let needed = why + columns(&shown(message, app.glyphs()));
    let Some(spare) = line.columns_left().checked_sub(needed + 1) else {
        // The reason for missing values must stay visible.
        if is_missing {
            line.keep_message(message);
            return false;
        }
        return line.replace_with_message(message, app);
    };
    line.gap(1);
    // A truncated number would be a different one, so the driver is shown completely or not at all.
    if spare >= columns(&driver) + 2 {
        line.write_text(&driver, ScreenPart::Text);
        line.gap(2);
    }
    // The reason for missing values must stay visible in any case.
    if is_missing {
        line.write_text(state, part);
        line.gap(2);
    }
    line.write_message(message, app);
    true
}

/// Renders scene, driver and state, followed by key hints.
fn with_hints(app: &App, narrow: bool, line: &mut Writer<'_>) {
    let gap = if narrow { 1 } else { 2 };
    line.gap(1);
    let studied = facts::progress(app);
    let is_studied = studied.is_some();
    let driver = studied.unwrap_or_else(|| facts::driver_in_time(app));
    let state = match is_studied {
        true => "",
        false => facts::state(app.condition(), narrow).0,
    };
    // Reserves room for the most important key on a short line.
    let (key, name) = hints::first(app);
    let leading_on = columns(&key) + 1 + columns(name);
    let after = columns(&driver) + columns(state) + leading_on + 3 * gap;
    let space = line.columns_left().saturating_sub(after);
    if space >= MIN_SCENE_LEN && !(narrow && is_listing(app)) {
        let longest = usize::from(space - gap).min(MAX_SCENE_LEN);
        line.write_text(&cut(&facts::scene(app), longest), ScreenPart::Text);
        line.gap(gap);
    }
    line.write_text(&driver, ScreenPart::Text);
    line.gap(gap);
    if is_studied {
        line.gap(gap);
    } else {
        write_state(app, narrow, gap + leading_on, line);
    }
    hints::render(app, line);
}

/// Renders the state, or the next limit, and its error bound. If the line is long enough, room is
/// reserved so that the following parts keep their columns during the motion.
fn write_state(app: &App, narrow: bool, needed: u16, line: &mut Writer<'_>) {
    let gap = if narrow { 1 } else { 2 };
    let (state, part) = facts::state(app.condition(), narrow);
    let hints = columns(state) + 2 * gap + HINTS;
    let trust = facts::trust(app, line.columns_left().saturating_sub(hints));
    let near = facts::near(app);
    let near = near.filter(|text| !narrow && line.columns_left() >= columns(text) + needed);
    let reserved = if narrow || !facts::can_come_near(app) {
        0
    } else {
        columns_ahead()
    };
    let from = line.x() + reserved + gap;
    let of_trust = trust.as_deref().map_or(0, |trust| columns(trust) + gap);
    let side_by_side = line.columns_left() >= reserved + gap + of_trust + HINTS;
    if let Some(near) = &near {
        line.write_text(near, ScreenPart::Text);
        line.gap(gap);
    } else if !(narrow && is_listing(app) && app.condition() == Condition::Ok) {
        line.write_text(state, part);
        line.gap(gap);
    }
    if side_by_side && reserved > 0 {
        line.go_to(from);
    }
    line.driver_end = Some(line.x().max(from));
    let fits = |trust: &String| line.columns_left() >= columns(trust) + needed;
    let shown = trust.filter(|trust| (near.is_none() || side_by_side) && fits(trust));
    if let Some(trust) = shown {
        line.write_text(&trust, ScreenPart::Quiet);
        line.gap(gap);
    }
    if reserved > 0 && line.columns_from(from) >= needed {
        line.go_to(from);
    }
}

/// Returns the width of the longest description of a limit, such as `change point in 90.5 deg`.
fn columns_ahead() -> u16 {
    let kinds = [words().dead_point(), words().change_point()];
    let longest = kinds.map(|kind| columns(&words().near_in(kind, "90.5", "deg")));
    longest.into_iter().max().unwrap_or(0)
}

fn is_listing(app: &App) -> bool {
    matches!(app.mode(), Mode::Assemblies(_) | Mode::PlotList(_))
}
