//! The verdict line: properties of the whole linkage, which a designer watches while lengths
//! change. After an edit, changed properties are shown with their old and new values until the next
//! key.
//!
//! ```text
//!  turns fully  crank-rocker  transmission 40.5 deg off 90 at 0 deg
//!  turns fully -> -98.2..98.2 deg  crank-rocker -> triple rocker  40.5 off 90 -> 90.0 off 90
//! ```

use super::{columns, cut, print};
use crate::report::{Verdict, VerdictPart};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Blanks before the line, and between its parts.
const INDENT: u16 = 1;
const GAP: u16 = 2;

/// A part of the line, in a long and a short form.
struct Remark {
    texts: [String; 2],
    is_changed: bool,
}

pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let shown_text = remarks(app.open_scene().verdict(), app.verdict_before());
    let mut x = area.x + INDENT;
    for (text, is_changed) in fit(shown_text, area.width.saturating_sub(2 * INDENT)) {
        let part = match is_changed {
            true => ScreenPart::Warning,
            false => ScreenPart::Quiet,
        };
        let space = area.right().saturating_sub(x);
        let text = shown(&text, app.glyphs());
        x = print(buffer, x, area.y, space, &text, theme::part(part)) + GAP;
    }
}

/// Returns the parts of the verdict; a part changed by the last edit includes its old value.
fn remarks(now: &Verdict, before: Option<&Verdict>) -> Vec<Remark> {
    let before = before.unwrap_or(now);
    let pairs = now.parts.iter().zip(&before.parts);
    let shown_text = pairs.filter_map(|(now, before)| match (before, now) {
        (None, None) => None,
        (Some(old), Some(new)) if old == new => Some(Remark {
            texts: [new.long.clone(), new.short.clone()],
            is_changed: false,
        }),
        _ => {
            let text = |part: &Option<VerdictPart>, which: fn(&VerdictPart) -> &String| {
                let none = || words().nothing_of_it().to_owned();
                part.as_ref().map(which).cloned().unwrap_or_else(none)
            };
            let became = |which| words().became(&text(before, which), &text(now, which));
            Some(Remark {
                texts: [became(|part| &part.long), became(|part| &part.short)],
                is_changed: true,
            })
        }
    });
    shown_text.collect()
}

/// Returns the texts that fit. All parts are shortened before any is dropped, and changed parts are
/// dropped last.
fn fit(mut shown_text: Vec<Remark>, space: u16) -> Vec<(String, bool)> {
    let needed = |shown_text: &[Remark], brevity: usize| {
        let texts = shown_text
            .iter()
            .map(|shown_text| columns(&shown_text.texts[brevity]) + GAP);
        texts.sum::<u16>().saturating_sub(GAP)
    };
    while shown_text.len() > 1 && needed(&shown_text, 1) > space {
        let unchanged = shown_text
            .iter()
            .rposition(|shown_text| !shown_text.is_changed);
        shown_text.remove(unchanged.unwrap_or(shown_text.len() - 1));
    }
    let brevity = usize::from(needed(&shown_text, 0) > space);
    let texts = shown_text.into_iter().map(|shown_text| {
        let [long, short] = shown_text.texts;
        let text = if brevity == 0 { long } else { short };
        (cut(&text, space.into()), shown_text.is_changed)
    });
    texts.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(long: &str, short: &str) -> Option<VerdictPart> {
        Some(VerdictPart {
            long: long.into(),
            short: short.into(),
        })
    }

    fn texts(now: &Verdict, before: Option<&Verdict>, space: u16) -> Vec<String> {
        let fitted = fit(remarks(now, before), space);
        fitted.into_iter().map(|(text, _)| text).collect()
    }

    #[test]
    fn verdict_shortens_words_before_dropping_parts() {
        let of = |range: &str, angle: &str| Verdict {
            parts: [
                part(range, range),
                part("rocker", "rocker"),
                None,
                part(angle, &angle[..4]),
                None,
            ],
        };
        let (old, new) = (of("turns", "30.0 of mu"), of("rocks", "30.0 of mu"));
        assert_eq!(texts(&new, None, 80), ["rocks", "rocker", "30.0 of mu"]);
        assert_eq!(texts(&new, None, 20), ["rocks", "rocker", "30.0"]);
        assert_eq!(texts(&new, None, 14), ["rocks", "rocker"]);
        assert_eq!(
            texts(&new, Some(&old), 30),
            ["turns -> rocks", "rocker", "30.0"]
        );
        assert_eq!(texts(&new, Some(&old), 16), ["turns -> rocks"]);
    }
}
