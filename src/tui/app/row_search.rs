//! Searches rows by name, moves the cursor of the tables, and marks points for the motion view.

use super::super::views::{self, Listing};
use super::{App, Effect, Mode, View};
use crate::tui::commands::action::TablesAction;
use crate::tui::commands::key::Key;
use crate::tui::commands::line::EditLine;
use crate::tui::figures::cursor::{self, Cursor};
use crate::tui::figures::search::{self, FoundLine, NameSearch, SearchOrigin};
use crate::tui::figures::sheet;
use crate::tui::views::motion::tracked_points;
use crate::wording::words;

impl App {
    /// Opens the search line, in the views that have rows or lines.
    pub(super) fn search(&mut self) {
        let from = match self.shell.view.pane_in(self).list() {
            Listing::Figures => SearchOrigin::Tables(self.views.cursor),
            Listing::Values => SearchOrigin::Scene(self.document.editor.cursor()),
            Listing::Lines if views::current_view_lines(self).is_empty() => {
                self.set_message(words().nothing_to_search());
                return;
            }
            Listing::Lines => SearchOrigin::Lines(self.views.scroll[self.shell.view as usize]),
        };
        let name = EditLine::for_search();
        self.shell.mode = Mode::Search(NameSearch { name, from });
    }

    /// Handles a key of the search line. Returns `None` for keys with the same meaning everywhere.
    pub(super) fn search_key(&mut self, key: Key) -> Option<Effect> {
        let Mode::Search(search) = &mut self.shell.mode else {
            return None;
        };
        match key {
            Key::Escape => {
                let from = search.from;
                self.shell.mode = Mode::Normal;
                self.shell.message = None;
                self.go_back(from);
            }
            Key::Enter => self.accept_search(),
            _ => match search.name.change(key) {
                Some(true) => self.find(),
                None if matches!(key, Key::Ctrl(_)) => return None,
                Some(false) | None => {}
            },
        }
        Some(Effect::Show)
    }

    /// Moves the cursor back to where the search began.
    fn go_back(&mut self, from: SearchOrigin) {
        match from {
            SearchOrigin::Tables(cursor) => self.place_cursor(|_, _| cursor),
            SearchOrigin::Scene(row) => self.document.editor.go_to(row),
            SearchOrigin::Lines(line) => {
                self.views.found = None;
                self.scroll_to(line);
            }
        }
    }

    /// Scrolls the current view to a line.
    fn scroll_to(&mut self, line: usize) {
        let maximum = views::max_scroll(self);
        self.views.scroll[self.shell.view as usize] = line.min(maximum);
    }

    /// Returns the line from which to search on: the last match if that is visible, or else the
    /// first visible line. Forwards, the match itself is left out.
    fn next_line(&self, forward: bool) -> usize {
        let first = self.views.scroll[self.shell.view as usize];
        let seen = first..first + views::page(self);
        let found = self.found_line().filter(|line| seen.contains(line));
        found.map_or(first, |line| line + usize::from(forward))
    }

    pub(super) fn found_line(&self) -> Option<usize> {
        self.views.found.as_ref().map(|found| found.line)
    }

    /// Moves to the best match for the text typed so far, or reports that there is none.
    pub(super) fn find(&mut self) {
        let Mode::Search(search) = &self.shell.mode else {
            return;
        };
        let (typed, from) = (search.name.text().trim().to_owned(), search.from);
        if typed.is_empty() {
            self.shell.message = None;
            self.go_back(from);
            return;
        }
        let found = self.go_to_name(&typed, from);
        self.shell.message = (!found).then(|| nameless(&typed));
    }

    /// Moves to the first match after `from` and returns `true`; without a match, moves back to
    /// `from` and returns `false`.
    fn go_to_name(&mut self, typed: &str, from: SearchOrigin) -> bool {
        match from {
            SearchOrigin::Tables(from) => {
                let found = search::best(self.player.open_scene.tables(), typed, from);
                self.place_cursor(|_, _| found.unwrap_or(from));
                found.is_some()
            }
            SearchOrigin::Scene(row) => {
                self.document.editor.go_to(row);
                self.document.editor.seek(typed, 0)
            }
            SearchOrigin::Lines(from) => {
                self.views.found =
                    FoundLine::of(&views::current_view_lines(self), typed, from, true);
                self.scroll_to(self.found_line().unwrap_or(from));
                self.views.found.is_some()
            }
        }
    }

    /// Accepts the search. An empty line repeats the last search; a name without a match stays for
    /// correction.
    fn accept_search(&mut self) {
        let Mode::Search(search) = &self.shell.mode else {
            return;
        };
        let (typed, from) = (search.name.text().trim().to_owned(), search.from);
        if typed.is_empty() {
            self.shell.mode = Mode::Normal;
            self.find_next(true);
            return;
        }
        if self.go_to_name(&typed, from) {
            self.views.sought = typed;
            self.views.searched = Some(self.shell.view);
            self.shell.mode = Mode::Normal;
        }
    }

    /// Handles `n` and `N` after a search. Returns `None` for all other keys, and once the search has
    /// ended.
    pub(super) fn repeat_search(&mut self, key: Key) -> Option<Effect> {
        let forward = match key {
            Key::Char('n') => true,
            Key::Char('N') => false,
            _ => return None,
        };
        self.views
            .searched
            .filter(|view| *view == self.shell.view)?;
        self.shell.message = None;
        self.find_next(forward);
        Some(Effect::Show)
    }

    /// Moves to the next or the previous match of the last search.
    fn find_next(&mut self, forward: bool) {
        if self.views.sought.is_empty() {
            return;
        }
        self.views.searched = Some(self.shell.view);
        let query = self.views.sought.clone();
        let found = match self.shell.view.pane_in(self).list() {
            Listing::Figures => {
                let (tables, here) = (self.player.open_scene.tables(), self.views.cursor);
                let next = search::next(tables, &query, here, forward);
                next.map(|next| self.place_cursor(|_, _| next)).is_some()
            }
            Listing::Values => {
                let step = if forward { 1 } else { -1 };
                self.document.editor.seek(&query, step)
            }
            Listing::Lines => {
                let (lines, from) = (views::current_view_lines(self), self.next_line(forward));
                self.views.found = FoundLine::of(&lines, &query, from, forward);
                self.found_line().map(|line| self.scroll_to(line)).is_some()
            }
        };
        if !found {
            self.set_message(nameless(&query));
        }
    }

    pub(super) fn browse(&mut self, action: TablesAction) {
        match action {
            TablesAction::Choose => self.choose(),
            // Only the tables have columns to move sideways.
            _ if self.shell.view != View::Tables => self.set_message(words().nothing_at_the_side()),
            TablesAction::Left => self.place_cursor(|cursor, lines| cursor.aside(lines, -1)),
            TablesAction::Right => self.place_cursor(|cursor, lines| cursor.aside(lines, 1)),
        }
    }

    /// Moves the cursor of the tables and scrolls them to it.
    pub(super) fn place_cursor(
        &mut self,
        there: impl FnOnce(Cursor, &[sheet::TableLine]) -> Cursor,
    ) {
        let (lines, height) = views::table_lines(self);
        self.views.cursor = there(self.views.cursor, &lines).settled(&lines);
        let scroll = &mut self.views.scroll[View::Tables as usize];
        *scroll = cursor::follow(&lines, self.views.cursor, *scroll, height);
    }

    /// Marks or unmarks the points of the row under the cursor: a point, or the moving ends of a
    /// vector.
    fn choose(&mut self) {
        let Cursor { part, row, .. } = self.views.cursor;
        let moving = tracked_points::moving(self.player.open_scene.scene(), part, row);
        if moving.is_empty() {
            let name = part.name(self.player.open_scene.tables(), row);
            self.set_message(words().never_moves(name));
            return;
        }
        let all = moving
            .iter()
            .all(|(point, _)| self.views.followed.contains(*point));
        let names = moving.iter().map(|(_, name)| *name).collect::<Vec<_>>();
        let names = words().all_of(&names);
        self.shell.set_message(if all {
            words().no_longer_chosen(&names)
        } else {
            words().chosen_for_motion(&names)
        });
        for (point, _) in moving {
            if self.views.followed.contains(point) == all {
                self.views.followed.toggle(point);
            }
        }
    }
}

fn nameless(typed: &str) -> String {
    words().no_row_named(typed)
}
