//! Renders the offer of unsaved edits from earlier sessions, in the middle of the screen.
//!
//! ```text
//! +- Unsaved edits of this scene -------------------+
//! | > 2026-11-21 14:03 UTC                          |
//! |   2026-11-20 09:12 UTC  older than the file     |
//! |                                                 |
//! | Enter look  c compare  t take  d drop  Esc later|
//! +-------------------------------------------------+
//! ```

pub(crate) mod list;

use super::popup::{self, BORDER};
use super::{cut, first_row, print};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::document::recovery::{Generation, OtherSession};
use crate::tui::player::open_scene::shown;
use crate::tui::views::recovery_offer::list::{Offer, OfferPage};
use crate::tui::views::tour::screens::wrapped;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Width of the list in columns.
const LIST: u16 = 54;
/// A line and its style.
type OfferLine = (String, ScreenPart);

pub(super) fn render(app: &App, offer: &Offer, area: Rect, buffer: &mut Buffer) {
    let OfferLayout { place, lines, keys } = OfferLayout::of(offer, area);
    let title = match &offer.page {
        Some(page) => page.title,
        None if offer.others.left.is_empty() => words().open_elsewhere(),
        None => words().unsaved_edits_here(),
    };
    popup::frame(app.glyphs(), place, title, buffer);
    let inner = popup::within(place);
    let below = inner.bottom().saturating_sub(rows(&keys)).max(inner.top());
    let mut put = |y, text: &str, part| {
        let text = cut(&shown(text, app.glyphs()), inner.width.into());
        print(buffer, inner.x, y, inner.width, &text, theme::part(part));
    };
    for (y, (text, part)) in (inner.top()..below).zip(&lines) {
        put(y, text, *part);
    }
    for (y, text) in (below..inner.bottom()).zip(&keys) {
        put(y, text, ScreenPart::Key);
    }
}

/// Returns the area of the offer's frame.
pub(super) fn placed(offer: &Offer, area: Rect) -> Rect {
    OfferLayout::of(offer, area).place
}

/// The contents and the place of the offer.
struct OfferLayout {
    place: Rect,
    lines: Vec<OfferLine>,
    /// The key hints below the lines.
    keys: Vec<String>,
}

impl OfferLayout {
    fn of(offer: &Offer, area: Rect) -> OfferLayout {
        let space = area.width.saturating_sub(BORDER.0);
        let columns = match offer.page {
            Some(_) => space,
            None => LIST.min(space),
        };
        let keys = hints(&keys(offer), columns.into());
        let maximum = area.height.saturating_sub(BORDER.1 + rows(&keys));
        let lines = match &offer.page {
            Some(page) => read(page, offer, maximum),
            None => listed(offer, columns, maximum),
        };
        let height = match offer.page {
            Some(_) => area.height,
            None => rows(&lines).saturating_add(rows(&keys)),
        };
        OfferLayout {
            place: popup::centred(area, columns, height),
            lines,
            keys,
        }
    }
}

fn rows<T>(lines: &[T]) -> u16 {
    u16::try_from(lines.len()).unwrap_or(u16::MAX)
}

/// Returns the relevant keys and their effects.
fn keys(offer: &Offer) -> Vec<String> {
    let [compare, take] = [("c", words().compare()), ("t", words().take())];
    let keys = match (&offer.page, offer.others.left.is_empty(), offer.asks) {
        (Some(_), ..) => vec![compare, take, ("Esc", words().back())],
        (None, true, _) => vec![("Enter", words().go_on())],
        (None, false, true) => {
            let drops = ("d", words().drops_for_ever());
            return vec![format_key(drops), words().any_other_key_does_not().into()];
        }
        (None, false, false) => {
            let [look, drop] = [("Enter", words().look()), ("d", words().drop_them())];
            vec![look, compare, take, drop, ("Esc", words().later())]
        }
    };
    keys.into_iter().map(format_key).collect()
}

/// Formats a key and its effect.
fn format_key((key, does): (&str, &str)) -> String {
    format!("{key} {does}")
}

/// Joins the key hints with two blanks and breaks them into lines.
fn hints(keys: &[String], width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for key in keys {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 2 + key.chars().count() <= width => {
                line.push_str("  ");
                line.push_str(key);
            }
            _ => lines.push(key.clone()),
        }
    }
    lines
}

/// Returns the generations of edits, scrolled to the cursor, and the other open sessions.
fn listed(offer: &Offer, columns: u16, maximum: u16) -> Vec<OfferLine> {
    let elsewhere = offer.others.alive.iter().flat_map(|other| {
        let lines = wrapped(&elsewhere(other), columns.into());
        lines.into_iter().map(|line| (line, ScreenPart::Warning))
    });
    let mut after: Vec<OfferLine> = elsewhere.collect();
    after.push((String::new(), ScreenPart::Text));
    let left = &offer.others.left;
    let space = usize::from(maximum).saturating_sub(after.len()).max(1);
    let first = first_row(offer.cursor, left.len(), space);
    let seen = left.iter().enumerate().skip(first).take(space);
    let mut lines: Vec<OfferLine> = seen
        .map(|(n, found)| row(found, n == offer.cursor))
        .collect();
    lines.append(&mut after);
    lines
}

fn row(found: &Generation, is_chosen: bool) -> OfferLine {
    let mark = if is_chosen { '>' } else { ' ' };
    let text = match (found.is_older, found.is_stale) {
        (true, _) => words().older_than_file(),
        (false, true) => words().made_on_another_text(),
        (false, false) => "",
    };
    let part = if is_chosen {
        ScreenPart::Key
    } else {
        ScreenPart::Text
    };
    (
        format!("{mark} {}  {text}", found.time).trim_end().into(),
        part,
    )
}

fn elsewhere(other: &OtherSession) -> String {
    let OtherSession {
        process,
        host,
        time,
    } = other;
    words().open_elsewhere_too(process, host, time)
}

/// Returns the visible lines of a scrolled page, below its time.
fn read(page: &OfferPage, offer: &Offer, maximum: u16) -> Vec<OfferLine> {
    let time = offer.chosen().map_or("", |chosen| &chosen.time);
    let head = (words().of_time(time), ScreenPart::Quiet);
    let lines = page.lines.iter().skip(page.scroll);
    let lines = lines.map(|line| (line.clone(), ScreenPart::Text));
    std::iter::once(head)
        .chain(lines)
        .take(maximum.into())
        .collect()
}
