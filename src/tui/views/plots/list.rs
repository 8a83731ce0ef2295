//! The list in which the plotted quantities are selected.

use crate::quantity::{Catalogue, Quantity, Subject};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::study::changing;
use crate::tui::commands::line::EditLine;

/// All quantities of a scene, filtered by the search.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PlotList {
    all: Vec<Quantity>,
    /// Indices of the listed quantities.
    found: Vec<usize>,
    cursor: usize,
    search: EditLine,
    typing: bool,
    /// The first visible line of the selected quantity's summary, if it is open.
    read: Option<usize>,
}

/// Returns all quantities that can be plotted, including unlisted ones. Those constant over the
/// motion are left out, unless they are plotted already.
fn all_of(scene: &Scene, solver: &Solver, is_chosen: impl Fn(&str) -> bool) -> Vec<Quantity> {
    let catalogue = Catalogue::new(scene);
    let mut all = catalogue.figures();
    all.extend(catalogue.unlisted());
    let changes = changing(solver, &all);
    let figures = all.into_iter().zip(changes);
    let told = figures.filter(|(figure, changes)| *changes || is_chosen(&figure.name));
    told.map(|(figure, _)| figure).collect()
}

impl PlotList {
    /// Creates the list of a scene's quantities, with the cursor on the first selected one.
    pub(crate) fn new(scene: &Scene, solver: &Solver, is_chosen: impl Fn(&str) -> bool) -> Self {
        let all = all_of(scene, solver, &is_chosen);
        let cursor = all.iter().position(|q| is_chosen(&q.name));
        PlotList {
            found: (0..all.len()).collect(),
            cursor: cursor.unwrap_or(0),
            all,
            search: EditLine::for_words(),
            typing: false,
            read: None,
        }
    }

    /// Lists the quantities of the edited scene; the cursor stays on the same name.
    pub(crate) fn move_to(
        &mut self,
        scene: &Scene,
        solver: &Solver,
        is_chosen: impl Fn(&str) -> bool,
    ) {
        let current = self.current().map(str::to_owned);
        self.all = all_of(scene, solver, is_chosen);
        self.narrow();
        let stays = self
            .rows()
            .position(|(name, _)| Some(name) == current.as_deref());
        self.cursor = stays.unwrap_or(0);
    }

    /// Yields the names and units of the listed quantities.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&str, &str)> {
        let rows = self.found.iter().filter_map(|&i| self.all.get(i));
        rows.map(|q| (q.name.as_str(), q.unit.as_str()))
    }

    /// Returns the number of listed quantities and the number of all.
    pub(crate) fn count(&self) -> (usize, usize) {
        (self.found.len(), self.all.len())
    }

    pub(crate) fn cursor(&self) -> usize {
        self.cursor
    }

    /// Returns the name under the cursor.
    pub(crate) fn current(&self) -> Option<&str> {
        self.rows().nth(self.cursor).map(|(name, _)| name)
    }

    /// Returns the subject of the quantity under the cursor.
    pub(crate) fn subject(&self) -> Option<Subject> {
        let current = self.all.get(*self.found.get(self.cursor)?)?;
        current.subject()
    }

    /// Returns the search text and whether it is being typed; `None` without a search.
    pub(crate) fn search(&self) -> Option<(&str, bool)> {
        let text = self.search.text();
        (self.typing || !text.is_empty()).then_some((text, self.typing))
    }

    pub(crate) fn is_typing(&self) -> bool {
        self.typing
    }

    /// Starts or ends typing the search.
    pub(crate) fn set_typing(&mut self, typing: bool) {
        self.typing = typing;
    }

    /// Returns the search's input line while it is being typed; [`PlotList::narrow`] must be called
    /// after a change.
    pub(crate) fn typed(&mut self) -> Option<&mut EditLine> {
        self.typing.then_some(&mut self.search)
    }

    /// Ends the search and lists everything again; returns `false` if there was no search.
    pub(crate) fn end_search(&mut self) -> bool {
        let was = self.search().is_some();
        let current = self.found.get(self.cursor).copied();
        self.search.clear();
        self.typing = false;
        self.narrow();
        self.cursor = current.unwrap_or(0);
        was
    }

    /// Lists the quantities whose name or unit contains all words of the search, ignoring case.
    pub(crate) fn narrow(&mut self) {
        let text = self.search.text().to_ascii_lowercase();
        let fits = |q: &Quantity| {
            let row = format!("{} {}", q.name, q.unit).to_ascii_lowercase();
            text.split_whitespace().all(|word| row.contains(word))
        };
        let current = self.found.get(self.cursor).copied();
        self.found = (0..self.all.len())
            .filter(|&i| fits(&self.all[i]))
            .collect();
        let stays = self.found.iter().position(|&i| Some(i) == current);
        self.cursor = stays.unwrap_or(0);
    }

    /// Returns the first visible line of the selected quantity's summary; `None` if it is closed.
    pub(crate) fn read(&self) -> Option<usize> {
        self.read
    }

    /// Opens or closes the summary of the selected quantity.
    pub(crate) fn set_reading(&mut self, reads: bool) {
        self.read = (reads && self.current().is_some()).then_some(0);
    }

    /// Scrolls the summary by `lines`, at most to line `most`.
    pub(crate) fn scroll_by(&mut self, lines: isize, most: usize) {
        self.read = self
            .read
            .map(|first| first.saturating_add_signed(lines).min(most));
    }

    /// Moves the cursor within the list.
    pub(crate) fn move_by(&mut self, rows: isize) {
        let most = self.found.len().saturating_sub(1);
        self.cursor = self.cursor.saturating_add_signed(rows).min(most);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    /// Rewriting the file while the list is open removes only the columns that the scene no longer
    /// has.
    #[test]
    fn reloaded_scene_keeps_list_and_cursor() {
        let text = presets::find("four-bar").unwrap().text;
        let scene = Scene::parse(text, "four-bar").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let mut list = PlotList::new(&scene, &solver, |name| name == "C.a");
        let before = list.clone();
        assert_eq!(list.current(), Some("C.a"));
        let edited = scene.again(&text.replace("length = 300", "length = 310"));
        list.move_to(&edited.unwrap(), &solver, |_| false);
        assert_eq!(list, before);
        let renamed = scene.again(&text.replace("\"C\"", "\"K\"").replace("C = [", "K = ["));
        let renamed = renamed.unwrap();
        let solver = Solver::new(&renamed.mechanism).unwrap();
        list.move_to(&renamed, &solver, |_| false);
        assert_eq!(list.current(), before.rows().next().map(|(name, _)| name));
    }

    /// The crank of a four-bar has constant speed, so its rates are not listed, unless they are
    /// already plotted.
    #[test]
    fn constant_columns_are_not_listed() {
        let scene = Scene::parse(presets::find("four-bar").unwrap().text, "four-bar").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let has = |list: &PlotList, name: &str| list.rows().any(|(other, _)| other == name);
        let list = PlotList::new(&scene, &solver, |_| false);
        for stays in ["r2.omega", "r2.alpha", "B.v"] {
            assert!(!has(&list, stays), "{stays}");
        }
        for changes in ["r2.angle", "B.x", "r4.omega", "C.a"] {
            assert!(has(&list, changes), "{changes}");
        }
        let list = PlotList::new(&scene, &solver, |name| name == "r2.omega");
        assert!(has(&list, "r2.omega"));
    }
}
