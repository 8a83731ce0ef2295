//! The first line: what is open, and how it is stepped and played.
//!
//! ```text
//!  Four-bar crank-rocker          step 5 deg   1 turn in 4 s   1/9.5 of real time
//!  Four-bar crank-rocker against mine.toml           step 5 deg   1 turn in 4 s
//! ```

use super::{columns, cut, print, print_right};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::figures::format::coordinate;
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

const GAP: &str = "   ";
/// The title keeps so many columns before the settings beside it are dropped one by one.
const TITLE: u16 = 16;
/// Longer names of what it is held against are cut.
const LONGEST_NAME: usize = 20;

pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let title = shown(&app.open_scene().scene().name, app.glyphs());
    let title = if app.is_changed() {
        title + " *"
    } else {
        title
    };
    let against = shown(&against(app), app.glyphs());
    let room = area.width.saturating_sub(2);
    let wanted = columns(&title).min(TITLE) + columns(&against) + columns(GAP);
    let mut settings = settings(app);
    let joined = loop {
        let joined = settings.join(GAP);
        if columns(&joined) + wanted <= room || settings.pop().is_none() {
            break joined;
        }
    };
    let left = room.saturating_sub(columns(&joined) + columns(GAP));
    let most = left.saturating_sub(columns(&against)).max(TITLE.min(left));
    let title = cut(&title, most.into()) + &against;
    let style = theme::part(ScreenPart::Title);
    print(
        buffer,
        area.x + 1,
        area.y,
        left,
        &cut(&title, left.into()),
        style,
    );
    let style = theme::part(ScreenPart::Quiet);
    print_right(
        buffer,
        area.right().saturating_sub(1),
        area.y,
        &joined,
        style,
    );
}

/// What the scene is held against, behind its title.
fn against(app: &App) -> String {
    let Some(compared) = app.compared() else {
        return String::new();
    };
    let name = cut(compared.name(), LONGEST_NAME);
    let against = match compared.is_assembled() {
        true => words().against(&name),
        false => words().against_without_assembly(&name),
    };
    format!(" {against}")
}

/// The most important first.
fn settings(app: &App) -> Vec<String> {
    let (open_scene, playback) = (app.open_scene(), app.playback());
    let step = coordinate(app.steps().size(), 0);
    let mut settings = vec![
        words().step_of(&step, open_scene.unit()),
        words().plays_in(
            open_scene.driver_range().turns(),
            &playback.seconds(),
            playback.is_backwards(),
        ),
    ];
    settings.push(match playback.ratio(open_scene.driver_range()) {
        None => words().driver_stands_still().into(),
        Some(ratio) if ratio < 1.0 => words().slower_than_real(&short(1.0 / ratio)),
        Some(ratio) => words().faster_than_real(&short(ratio)),
    });
    settings
}

/// Two or three digits.
fn short(number: f64) -> String {
    if number < 99.95 {
        format!("{number:.1}")
    } else if number < 1e6 {
        format!("{number:.0}")
    } else {
        format!("{number:.0e}")
    }
}
