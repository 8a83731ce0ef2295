//! The list in which is chosen what is plotted.

use crate::quantity::{Catalogue, Quantity, Subject};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::study::changing;
use crate::tui::commands::line::EditLine;

/// All quantities of a scene, narrowed by what is searched for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PlotList {
    all: Vec<Quantity>,
    /// Those that are listed, by their place among all.
    found: Vec<usize>,
    cursor: usize,
    search: EditLine,
    typing: bool,
    /// The first line that is seen of what the figure under the cursor does, where that is read.
    read: Option<usize>,
}

/// All that can be plotted of a scene, also what comes only when it is named. What stays over the motion is left out,
/// unless it is plotted already.
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
    /// The quantities of a scene, with the cursor on the first of those for which `is_chosen` holds.
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

    /// The scene was changed: what it has now is listed, and the cursor stays on its name.
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

    /// Names and units of what is listed.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&str, &str)> {
        let rows = self.found.iter().filter_map(|&i| self.all.get(i));
        rows.map(|q| (q.name.as_str(), q.unit.as_str()))
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

    /// What the quantity under the cursor is about.
    pub(crate) fn subject(&self) -> Option<Subject> {
        let current = self.all.get(*self.found.get(self.cursor)?)?;
        current.subject()
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

    /// The first line that is seen of what the figure under the cursor does over the whole motion; `None` where that is
    /// not read.
    pub(crate) fn read(&self) -> Option<usize> {
        self.read
    }

    /// Reads what the figure under the cursor does, or no longer.
    pub(crate) fn set_reading(&mut self, reads: bool) {
        self.read = (reads && self.current().is_some()).then_some(0);
    }

    /// Scrolls what is read, by so many lines and to this one at the most.
    pub(crate) fn scroll_by(&mut self, lines: isize, most: usize) {
        self.read = self
            .read
            .map(|first| first.saturating_add_signed(lines).min(most));
    }

    /// Moves the cursor, within the list.
    pub(crate) fn move_by(&mut self, rows: isize) {
        let most = self.found.len().saturating_sub(1);
        self.cursor = self.cursor.saturating_add_signed(rows).min(most);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    /// A file that is written while the list is open takes nothing from it but what the scene no longer has.
    #[test]
    fn another_text_of_the_scene_leaves_the_list_and_its_cursor() {
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

    /// The crank of a four-bar keeps its speed: of its turning nothing is to be seen, unless it is plotted already.
    #[test]
    fn what_stays_over_the_motion_is_not_listed() {
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
