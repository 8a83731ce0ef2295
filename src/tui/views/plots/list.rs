//! The list in which is chosen what is plotted.

use crate::quantity::Catalogue;
use crate::scene::Scene;
use crate::tui::commands::line::EditLine;

/// All quantities of a scene, narrowed by what is searched for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PlotList {
    /// Names and units.
    all: Vec<(String, String)>,
    /// Those that are listed, by their place among all.
    found: Vec<usize>,
    cursor: usize,
    search: EditLine,
    typing: bool,
}

impl PlotList {
    /// The quantities of a scene, with the cursor on the first of those for which `is_chosen` holds.
    pub(crate) fn new(scene: &Scene, is_chosen: impl Fn(&str) -> bool) -> Self {
        let figures = Catalogue::new(scene).figures().into_iter();
        let all: Vec<_> = figures.map(|q| (q.name, q.unit)).collect();
        let cursor = all.iter().position(|(name, _)| is_chosen(name));
        PlotList {
            found: (0..all.len()).collect(),
            cursor: cursor.unwrap_or(0),
            all,
            search: EditLine::for_words(),
            typing: false,
        }
    }

    /// Names and units of what is listed.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&str, &str)> {
        let rows = self.found.iter().filter_map(|&i| self.all.get(i));
        rows.map(|(name, unit)| (name.as_str(), unit.as_str()))
    }

    /// How many are listed, and of how many.
    pub(crate) fn count(&self) -> (usize, usize) {
        (self.found.len(), self.all.len())
    }

    pub(crate) fn cursor(&self) -> usize {
        self.cursor
    }

    /// The name under the cursor.
    pub(crate) fn current(&self) -> Option<&str> {
        self.rows().nth(self.cursor).map(|(name, _)| name)
    }

    /// What is searched for, and whether keys are typed into it; `None` where nothing is.
    pub(crate) fn search(&self) -> Option<(&str, bool)> {
        let text = self.search.text();
        (self.typing || !text.is_empty()).then_some((text, self.typing))
    }

    pub(crate) fn is_typing(&self) -> bool {
        self.typing
    }

    /// Keys are typed into the search, or no longer.
    pub(crate) fn set_typing(&mut self, typing: bool) {
        self.typing = typing;
    }

    /// The line that is typed into; [`PlotList::narrow`] has to follow.
    pub(crate) fn typed(&mut self) -> Option<&mut EditLine> {
        self.typing.then_some(&mut self.search)
    }

    /// Ends the search: everything is listed again. False where there was none.
    pub(crate) fn end_search(&mut self) -> bool {
        let was = self.search().is_some();
        let current = self.found.get(self.cursor).copied();
        self.search.clear();
        self.typing = false;
        self.narrow();
        self.cursor = current.unwrap_or(0);
        was
    }

    /// Lists what has all the words that are searched for in its name or unit, upper and lower case
    /// alike.
    pub(crate) fn narrow(&mut self) {
        let text = self.search.text().to_ascii_lowercase();
        let fits = |(name, unit): &(String, String)| {
            let row = format!("{name} {unit}").to_ascii_lowercase();
            text.split_whitespace().all(|word| row.contains(word))
        };
        let current = self.found.get(self.cursor).copied();
        self.found = (0..self.all.len())
            .filter(|&i| fits(&self.all[i]))
            .collect();
        let stays = self.found.iter().position(|&i| Some(i) == current);
        self.cursor = stays.unwrap_or(0);
    }

    /// Moves the cursor, within the list.
    pub(crate) fn move_by(&mut self, rows: isize) {
        let most = self.found.len().saturating_sub(1);
        self.cursor = self.cursor.saturating_add_signed(rows).min(most);
    }
}
