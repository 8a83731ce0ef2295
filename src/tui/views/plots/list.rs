//! The list in which the plotted quantities are selected.

use crate::quantity::{Catalogue, Quantity, Subject};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::study::changing;
use crate::tui::commands::line::EditLine;
use crate::tui::commands::list::{List, moved};

/// All quantities of a scene, filtered by the search.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PlotList {
    pub(crate) list: List<Quantity>,
    search: EditLine,
    /// Whether keys edit the search.
    pub(crate) typing: bool,
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
    let quantities = all.into_iter().zip(changes);
    let text = quantities.filter(|(quantity, changes)| *changes || is_chosen(&quantity.name));
    text.map(|(quantity, _)| quantity).collect()
}

impl PlotList {
    /// Creates the list of a scene's quantities, with the cursor on the first selected one.
    pub(crate) fn new(scene: &Scene, solver: &Solver, is_chosen: impl Fn(&str) -> bool) -> Self {
        let mut list = List::new(all_of(scene, solver, &is_chosen));
        list.go_to(|quantity| is_chosen(&quantity.name));
        PlotList {
            list,
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
        self.list = List::new(all_of(scene, solver, is_chosen));
        self.narrow();
        self.list
            .go_to(|quantity| Some(&quantity.name) == current.as_ref());
    }

    /// Returns the name under the cursor.
    pub(crate) fn current(&self) -> Option<&str> {
        self.list.chosen().map(|quantity| quantity.name.as_str())
    }

    /// Returns the subject of the quantity under the cursor.
    pub(crate) fn subject(&self) -> Option<Subject> {
        self.list.chosen()?.subject()
    }

    /// Returns the search text and whether it is being typed; `None` without a search.
    pub(crate) fn search(&self) -> Option<(&str, bool)> {
        let text = self.search.text();
        (self.typing || !text.is_empty()).then_some((text, self.typing))
    }

    /// Returns the search's input line while it is being typed; [`PlotList::narrow`] must be called
    /// after a change.
    pub(crate) fn typed(&mut self) -> Option<&mut EditLine> {
        self.typing.then_some(&mut self.search)
    }

    /// Ends the search and lists everything again; returns `false` if there was no search.
    pub(crate) fn end_search(&mut self) -> bool {
        let was = self.search().is_some();
        self.search.clear();
        self.typing = false;
        self.narrow();
        was
    }

    /// Lists the quantities whose name or unit contains all words of the search, ignoring case.
    pub(crate) fn narrow(&mut self) {
        let text = self.search.text().to_ascii_lowercase();
        self.list.narrow(|quantity| {
            let row = format!("{} {}", quantity.name, quantity.unit).to_ascii_lowercase();
            text.split_whitespace().all(|word| row.contains(word))
        });
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
    pub(crate) fn scroll_by(&mut self, lines: isize, maximum: usize) {
        self.read = self.read.map(|first| moved(first, lines, maximum + 1));
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
        let edited = scene.reparse(&text.replace("length = 300", "length = 310"));
        list.move_to(&edited.unwrap(), &solver, |_| false);
        assert_eq!(list, before);
        let renamed = scene.reparse(&text.replace("\"C\"", "\"K\"").replace("C = [", "K = ["));
        let renamed = renamed.unwrap();
        let solver = Solver::new(&renamed.mechanism).unwrap();
        list.move_to(&renamed, &solver, |_| false);
        assert_eq!(
            list.current(),
            before.list.listed().next().map(|quantity| &*quantity.name)
        );
    }

    /// The crank of a four-bar has constant speed, so its rates are not listed, unless they are
    /// already plotted.
    #[test]
    fn constant_columns_are_not_listed() {
        let scene = Scene::parse(presets::find("four-bar").unwrap().text, "four-bar").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let has = |list: &PlotList, name: &str| list.list.listed().any(|other| other.name == name);
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
