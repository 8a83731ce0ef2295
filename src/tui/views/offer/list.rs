//! The offer of edits that earlier sessions have left: a list in the middle of the screen, and what is looked
//! at of it.

use crate::tui::document::difference::difference;
use crate::tui::document::recovery::{Generation, Others};
use crate::wording::words;

/// What is offered, and where the cursor is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Offer {
    pub(crate) others: Others,
    pub(crate) cursor: usize,
    /// What is read of the edits under the cursor.
    pub(crate) page: Option<OfferPage>,
    /// Whether it is asked if the edits under the cursor are to go.
    pub(crate) asks: bool,
}

/// Lines that are read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct OfferPage {
    pub(crate) title: &'static str,
    pub(crate) lines: Vec<String>,
    pub(crate) scroll: usize,
}

impl Offer {
    /// What others have kept, if that is anything.
    pub(crate) fn of(others: Others) -> Option<Offer> {
        let is_any = !others.alive.is_empty() || !others.left.is_empty();
        is_any.then_some(Offer {
            others,
            cursor: 0,
            page: None,
            asks: false,
        })
    }

    /// The edits under the cursor.
    pub(crate) fn chosen(&self) -> Option<&Generation> {
        self.others.left.get(self.cursor)
    }

    /// Reads the text of the edits.
    pub(crate) fn look(&mut self) {
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

    /// Reads what they change of the text that the file has now.
    pub(crate) fn compare(&mut self, present: &str) {
        self.page = self.chosen().map(|chosen| OfferPage {
            title: words().what_the_edits_change(),
            lines: [waiting(chosen), difference(present, &chosen.edits.text)].concat(),
            scroll: 0,
        });
    }

    /// Moves the cursor, or the page, by so many lines.
    pub(crate) fn move_by(&mut self, lines: isize) {
        self.asks = false;
        match &mut self.page {
            Some(page) => {
                let most = page.lines.len().saturating_sub(1);
                page.scroll = page.scroll.saturating_add_signed(lines).min(most);
            }
            None => {
                let most = self.others.left.len().saturating_sub(1);
                self.cursor = self.cursor.saturating_add_signed(lines).min(most);
            }
        }
    }

    /// The edits under the cursor are gone; whether others are left.
    pub(crate) fn forget(&mut self) -> bool {
        if self.cursor < self.others.left.len() {
            self.others.left.remove(self.cursor);
        }
        self.page = None;
        self.move_by(0);
        !self.others.left.is_empty()
    }
}

/// What waits to be made together, a line each.
fn waiting(chosen: &Generation) -> Vec<String> {
    let edits = chosen.edits.waiting.list().iter();
    let lines = edits.map(|(name, text)| words().edit_that_waits(name, text));
    lines.collect()
}
