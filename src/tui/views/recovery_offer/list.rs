//! The offer of unsaved edits from earlier sessions: the list and the page read by the user.

use crate::tui::commands::list::moved;
use crate::tui::document::difference::difference;
use crate::tui::document::recovery::{Generation, OtherSessions};
use crate::wording::words;

/// The offered edits and the cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Offer {
    pub(crate) others: OtherSessions,
    pub(crate) cursor: usize,
    /// The opened page on the selected edits, if any.
    pub(crate) page: Option<OfferPage>,
    /// `true` while the user must confirm that the selected edits are dropped.
    pub(crate) asks: bool,
}

/// A page of scrollable lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct OfferPage {
    pub(crate) title: &'static str,
    pub(crate) lines: Vec<String>,
    pub(crate) scroll: usize,
}

impl Offer {
    /// Creates an offer; `None` if there are neither unsaved edits nor other open sessions.
    pub(crate) fn of(others: OtherSessions) -> Option<Offer> {
        let is_any = !others.alive.is_empty() || !others.left.is_empty();
        is_any.then_some(Offer {
            others,
            cursor: 0,
            page: None,
            asks: false,
        })
    }

    /// Returns the selected edits.
    pub(crate) fn chosen(&self) -> Option<&Generation> {
        self.others.left.get(self.cursor)
    }

    /// Opens the text of the selected edits as a page.
    pub(crate) fn open_page(&mut self) {
        let lines = |chosen: &Generation| {
            let lines = chosen.edits.text.lines().map(str::to_owned);
            waiting(chosen).into_iter().chain(lines).collect()
        };
        self.page = self.chosen().map(|chosen| OfferPage {
            title: words().the_edited_text(),
            lines: lines(chosen),
            scroll: 0,
        });
    }

    /// Opens the difference between the file's current text and the selected edits as a page.
    pub(crate) fn compare(&mut self, present: &str) {
        self.page = self.chosen().map(|chosen| OfferPage {
            title: words().what_the_edits_change(),
            lines: [waiting(chosen), difference(present, &chosen.edits.text)].concat(),
            scroll: 0,
        });
    }

    /// Moves the cursor, or scrolls the page, by `lines`.
    pub(crate) fn move_by(&mut self, lines: isize) {
        self.asks = false;
        match &mut self.page {
            Some(page) => page.scroll = moved(page.scroll, lines, page.lines.len()),
            None => self.cursor = moved(self.cursor, lines, self.others.left.len()),
        }
    }

    /// Removes the selected edits from the list; returns `true` if others remain.
    pub(crate) fn forget(&mut self) -> bool {
        if self.cursor < self.others.left.len() {
            self.others.left.remove(self.cursor);
        }
        self.page = None;
        self.move_by(0);
        !self.others.left.is_empty()
    }
}

/// Returns the staged edits, one per line.
fn waiting(chosen: &Generation) -> Vec<String> {
    let edits = chosen.edits.waiting.list().iter();
    let lines = edits.map(|(name, text)| words().edit_that_waits(name, text));
    lines.collect()
}
