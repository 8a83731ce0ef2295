//! Titles of panes; the drawing's title has the scene's name, the step and the playback speed.
//!
//! ```text
//!  Four-bar crank-rocker     step 5 deg   1 turn in 4 s         alone
//! =[Four-bar crank-rocker]== step 5 deg ==+- tables ---------   among others
//! ```

use super::layout::PlacedView;
use super::motion::rule;
use super::{columns, cut, print, print_right};
use crate::drawing::Glyphs;
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::figures::format::coordinate;
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

const GAP: &str = "   ";
/// Columns of a title reserved for its ends.
const SIDES: u16 = 6;
/// Minimum width of the title; settings next to it are dropped one by one to reach it.
const TITLE: u16 = 32;
/// Maximum width of the compared scene's name; longer names are cut.
const MAX_NAME_LEN: usize = 20;

/// Renders the drawing's title if it fills the screen.
pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let space = area.width.saturating_sub(2);
    let (title, settings) = heading(app, space);
    let style = theme::part(ScreenPart::Title);
    print(buffer, area.x + 1, area.y, space, &title, style);
    let style = theme::part(ScreenPart::Quiet);
    let right = area.right().saturating_sub(1);
    print_right(buffer, right, area.y, &settings, style);
}

/// Returns the scene's title with the compared scene, and as many of the step and playback settings
/// as fit.
pub(super) fn heading(app: &App, space: u16) -> (String, String) {
    let title = app.open_scene().scene().title();
    let title = shown(&title, app.glyphs());
    let title = if app.is_unsaved() {
        title + " *"
    } else {
        title
    };
    let against = against(app);
    let against = shown(&against, app.glyphs());
    let wanted = columns(&title).min(TITLE) + columns(&against) + columns(GAP);
    let mut settings = settings(app);
    let joined = loop {
        let joined = settings.join(GAP);
        if columns(&joined) + wanted <= space || settings.pop().is_none() {
            break joined;
        }
    };
    let side = match joined.is_empty() {
        true => 0,
        false => columns(&joined) + columns(GAP),
    };
    let left = space.saturating_sub(side);
    let maximum = left.saturating_sub(columns(&against)).max(TITLE.min(left));
    let title = cut(&title, maximum.into()) + &against;
    (cut(&title, left.into()), joined)
}

/// Renders the title of a pane among others in a line above it. That of the current pane is in
/// brackets, and its line is double and bright.
pub(super) fn over_pane(
    app: &App,
    is_looked_at: bool,
    heading: impl FnOnce(u16) -> (String, String),
    area: Rect,
    buffer: &mut Buffer,
) {
    match is_looked_at {
        true => double_rule(app.glyphs(), area, buffer),
        false => rule(app.glyphs(), area, buffer),
    }
    let (left, right) = heading(area.width.saturating_sub(SIDES));
    let (style, ends) = match is_looked_at {
        true => (theme::part(ScreenPart::Title), ('[', ']')),
        false => (theme::part(ScreenPart::Quiet), (' ', ' ')),
    };
    let left = format!("{}{left}{}", ends.0, ends.1);
    print(buffer, area.x + 1, area.y, area.width - 1, &left, style);
    if !right.is_empty() {
        let style = theme::part(ScreenPart::Quiet);
        let text = format!(" {right} ");
        let right = area.right().saturating_sub(1);
        print_right(buffer, right, area.y, &text, style);
    }
}

/// Draws the line above the current pane.
fn double_rule(glyphs: Glyphs, area: Rect, buffer: &mut Buffer) {
    let glyph = match glyphs {
        Glyphs::Ascii => '=',
        Glyphs::Line | Glyphs::Braille | Glyphs::Blocks(_) => '\u{2550}',
    };
    for position in area.positions() {
        buffer[position]
            .set_char(glyph)
            .set_style(theme::part(ScreenPart::Title));
    }
}

/// Draws the lines between adjacent panes, joined with the lines above them.
pub(super) fn lines_between(glyphs: Glyphs, placed: &[PlacedView], buffer: &mut Buffer) {
    let titles = || placed.iter().filter_map(|pane| pane.title);
    let [top, bottom] = [
        titles().map(|title| title.y).min(),
        placed.iter().map(|pane| pane.area.bottom()).max(),
    ];
    let (Some(top), Some(bottom)) = (top, bottom) else {
        return;
    };
    let first = titles().map(|title| title.x).min();
    for x in titles().map(|title| title.x).filter(|x| Some(*x) > first) {
        let line = Rect::new(x - 1, top, 1, bottom - top);
        rule(glyphs, line, buffer);
        for title in titles() {
            let [above, left, right, both] = joints(glyphs);
            let ends_here = titles().any(|other| other.y == title.y && other.right() == line.x);
            let begins_here = titles().any(|other| other.y == title.y && other.x == line.x + 1);
            let joint = match (title.y == top, ends_here, begins_here) {
                (true, ..) => above,
                (false, true, true) => both,
                (false, true, false) => left,
                (false, false, true) => right,
                (false, false, false) => continue,
            };
            buffer[(line.x, title.y)].set_char(joint);
        }
    }
}

/// Returns the characters where a line begins below a title, and where it has a title at its left,
/// at its right, and on both sides.
fn joints(glyphs: Glyphs) -> [char; 4] {
    match glyphs {
        Glyphs::Ascii => ['+'; 4],
        Glyphs::Line | Glyphs::Braille | Glyphs::Blocks(_) => {
            ['\u{252c}', '\u{2524}', '\u{251c}', '\u{253c}']
        }
    }
}

/// Describes the compared scene, for the space behind the title.
fn against(app: &App) -> String {
    let Some(compared) = app.compared() else {
        return String::new();
    };
    let name = cut(compared.name(), MAX_NAME_LEN);
    let against = match compared.is_assembled() {
        true => words().against(&name),
        false => words().against_without_assembly(&name),
    };
    format!(" {against}")
}

/// Returns the settings, the most important first.
fn settings(app: &App) -> Vec<String> {
    let (open_scene, playback) = (app.open_scene(), app.playback());
    let step = coordinate(app.steps().size(), 0);
    let mut settings: Vec<String> = app.views.viewport.lens.enlarged().into_iter().collect();
    let (seconds, backwards) = (playback.seconds(), playback.is_backwards());
    settings.extend([
        words().step_of(&step, app.step_unit()),
        match open_scene.timetable().is_some() || open_scene.led().is_some() {
            true => words().plays_period_in(&seconds, backwards),
            false => words().plays_in(open_scene.driver_range().turns(), &seconds, backwards),
        },
    ]);
    settings.push(match playback.ratio(&app.track()) {
        None => words().driver_stands_still().into(),
        Some(ratio) if ratio < 1.0 => words().slower_than_real(&short(1.0 / ratio)),
        Some(ratio) => words().faster_than_real(&short(ratio)),
    });
    settings
}

/// Formats a number with two or three digits.
fn short(number: f64) -> String {
    if number < 99.95 {
        format!("{number:.1}")
    } else if number < 1e6 {
        format!("{number:.0}")
    } else {
        format!("{number:.0e}")
    }
}
