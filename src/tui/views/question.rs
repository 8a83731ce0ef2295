//! Renders a question whose answer can lose data, in the middle of the screen so that it is
//! noticed.
//!
//! ```text
//! +- quit ------------------------------+
//! | unsaved edits                       |
//! |                                     |
//! | w save  q drop, quit  Esc stay      |
//! +-------------------------------------+
//! ```

use super::popup::{self, BORDER};
use super::{columns, print, print_line};
use crate::page::{truncate_lines, wrapped};
use crate::tui::app::{App, Mode, Unsaved};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::key::Key;
use crate::tui::document::writing::Question;
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Maximum width of the text, unless the keys need more.
const WIDTH: u16 = 48;
/// Blanks between two keys.
const GAP: u16 = 2;

/// The question and the keys that answer it.
struct QuestionText {
    text: String,
    keys: Vec<(String, &'static str)>,
}

impl QuestionText {
    fn of(app: &App) -> Option<QuestionText> {
        match app.mode() {
            Mode::Unsaved(requested) => Some(QuestionText::unsaved(requested, app)),
            Mode::Confirm(requested) => Some(QuestionText::confirm(requested, app)),
            _ => None,
        }
    }

    /// Returns the question about unsaved edits.
    fn unsaved(requested: &Unsaved, app: &App) -> QuestionText {
        let escape = Key::Escape.to_string();
        let unsaved = match app.is_unsaved() && !app.is_changed() {
            true => words().in_no_file_yet(),
            false => words().unsaved_edits(),
        };
        let (text, keys) = match requested {
            Unsaved::Quit => (
                unsaved,
                vec![
                    ("w".to_owned(), words().save()),
                    ("q".to_owned(), words().drop_and_quit()),
                    (escape, words().stay()),
                ],
            ),
            Unsaved::Open => (
                unsaved,
                vec![
                    ("w".to_owned(), words().save()),
                    ("d".to_owned(), words().drop_and_open()),
                    (escape, words().stay()),
                ],
            ),
            Unsaved::Reload => (
                words().read_over_edits(),
                vec![
                    (Key::Enter.to_string(), words().read()),
                    (escape, words().keep()),
                ],
            ),
        };
        let text = text.to_owned();
        QuestionText { text, keys }
    }

    /// Returns the question whether to overwrite a file.
    fn confirm(requested: &Question, app: &App) -> QuestionText {
        let to = &requested.to;
        let name = to.file_name().unwrap_or(to.as_os_str()).to_string_lossy();
        let keys = [
            (Key::Enter, words().writing()),
            (Key::Escape, words().cancel()),
        ];
        QuestionText {
            text: requested.reason.question(&shown(&name, app.glyphs())),
            keys: keys.map(|(key, name)| (key.to_string(), name)).into(),
        }
    }

    /// Returns the wrapped text and the area of the popup.
    fn arranged(&self, area: Rect) -> (Vec<String>, Rect) {
        let needed = |(key, name): &(String, &str)| columns(key) + 1 + columns(name) + GAP;
        let keys: u16 = self.keys.iter().map(needed).sum::<u16>() - GAP;
        let space = area.width.saturating_sub(BORDER.0);
        let width = columns(&self.text).min(WIDTH).max(keys).min(space);
        let lines = wrapped(&self.text, width.into());
        let height = u16::try_from(lines.len())
            .unwrap_or(u16::MAX)
            .saturating_add(2);
        (lines, popup::centred(area, width, height))
    }
}

pub(super) fn render(app: &App, title: &str, area: Rect, buffer: &mut Buffer) {
    let Some(requested) = QuestionText::of(app) else {
        return;
    };
    let (lines, place) = requested.arranged(area);
    popup::frame(app.glyphs(), place, title, buffer);
    let inner = popup::within(place);
    let last = inner.bottom().saturating_sub(1);
    for (row, line) in inner.rows().take_while(|row| row.y < last).zip(&lines) {
        print_line(buffer, row, line, ScreenPart::Text);
    }
    let mut x = inner.x;
    for (key, name) in &requested.keys {
        let mut put = |x: u16, text: &str, part| {
            let space = inner.right().saturating_sub(x);
            print(buffer, x, last, space, text, theme::part(part))
        };
        let after = put(x, key, ScreenPart::Key) + 1;
        x = put(after, name, ScreenPart::Quiet) + GAP;
    }
}

/// Returns the question as lines for an area too small for a frame; empty without a question. The
/// text is truncated so that all answers fit.
pub(super) fn lines(app: &App, area: Rect) -> Vec<String> {
    let Some(QuestionText { text, keys }) = QuestionText::of(app) else {
        return Vec::new();
    };
    let space = usize::from(area.height).saturating_sub(keys.len());
    let keys = keys.iter().map(|(key, name)| format!("{key} {name}"));
    let mut text = wrapped(&text, area.width.into());
    truncate_lines(&mut text, space, area.width.into());
    text.into_iter().chain(keys).collect()
}

/// Returns the area of the popup; zero without a question.
pub(super) fn placed(app: &App, area: Rect) -> Rect {
    QuestionText::of(app).map_or(Rect::ZERO, |requested| requested.arranged(area).1)
}
