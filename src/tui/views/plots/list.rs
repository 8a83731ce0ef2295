//! The list in which is chosen what is plotted.

use crate::quantity::{Catalogue, Quantity, Subject};
use crate::scene::Scene;
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
}

/// All that can be plotted of a scene, also what comes only when it is named.
fn all_of(scene: &Scene) -> Vec<Quantity> {
    let catalogue = Catalogue::new(scene);
    let mut all = catalogue.figures();
    all.extend(catalogue.unlisted());
    all
}

impl PlotList {
    /// The quantities of a scene, with the cursor on the first of those for which `is_chosen` holds.
    pub(crate) fn new(scene: &Scene, is_chosen: impl Fn(&str) -> bool) -> Self {
        let all = all_of(scene);
        let cursor = all.iter().position(|q| is_chosen(&q.name));
        PlotList {
            found: (0..all.len()).collect(),
            cursor: cursor.unwrap_or(0),
            all,
            search: EditLine::for_words(),
            typing: false,
        }
    }

    /// The scene was changed: what it has now is listed, and the cursor stays on its name.
    pub(crate) fn move_to(&mut self, scene: &Scene) {
        let current = self.current().map(str::to_owned);
        self.all = all_of(scene);
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
        let mut list = PlotList::new(&scene, |name| name == "C.a");
        let before = list.clone();
        assert_eq!(list.current(), Some("C.a"));
        let edited = scene.again(&text.replace("length = 300", "length = 310"));
        list.move_to(&edited.unwrap());
        assert_eq!(list, before);
        let renamed = scene.again(&text.replace("\"C\"", "\"K\"").replace("C = [", "K = ["));
        list.move_to(&renamed.unwrap());
        assert_eq!(list.current(), before.rows().next().map(|(name, _)| name));
    }
}
