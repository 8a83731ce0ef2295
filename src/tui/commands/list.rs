//! Lists with a cursor, a search and paging, and the keys that move in them.

use crate::tui::commands::action::Action;
use crate::tui::commands::key::Key;

/// Entries with a cursor, of which a search lists some.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct List<T> {
    items: Vec<T>,
    /// Indices of the listed entries.
    found: Vec<usize>,
    cursor: usize,
}

impl<T> List<T> {
    /// Creates a list of all entries, with the cursor on the first one.
    pub(crate) fn new(items: Vec<T>) -> List<T> {
        List {
            found: (0..items.len()).collect(),
            items,
            cursor: 0,
        }
    }

    /// Lists the entries that fit. The cursor stays on its entry, or moves to the first one if that
    /// entry is not listed.
    pub(crate) fn narrow(&mut self, fits: impl Fn(&T) -> bool) {
        let current = self.found.get(self.cursor).copied();
        let all = self.items.iter().enumerate();
        let found = all.filter(|(_, item)| fits(item));
        self.found = found.map(|(at, _)| at).collect();
        let stays = self.found.iter().position(|at| Some(*at) == current);
        self.cursor = stays.unwrap_or(0);
    }

    /// Yields the listed entries.
    pub(crate) fn listed(&self) -> impl Iterator<Item = &T> {
        self.found.iter().filter_map(|at| self.items.get(*at))
    }

    /// Returns the number of listed entries and the number of all.
    pub(crate) fn count(&self) -> (usize, usize) {
        (self.found.len(), self.items.len())
    }

    /// Returns the cursor's index among the listed entries.
    pub(crate) fn cursor(&self) -> usize {
        self.cursor
    }

    /// Returns the entry under the cursor; `None` if nothing is listed.
    pub(crate) fn chosen(&self) -> Option<&T> {
        self.listed().nth(self.cursor)
    }

    /// Moves the cursor by `rows` within the list.
    pub(crate) fn move_by(&mut self, rows: isize) {
        self.cursor = moved(self.cursor, rows, self.found.len());
    }

    /// Moves the cursor to the first listed entry that fits. Returns `false` if there is none.
    pub(crate) fn go_to(&mut self, fits: impl Fn(&T) -> bool) -> bool {
        let found = self.listed().position(fits);
        self.cursor = found.unwrap_or(self.cursor);
        found.is_some()
    }
}

/// Returns a cursor after a move by `rows` in a list of `count` rows.
pub(crate) fn moved(cursor: usize, rows: isize, count: usize) -> usize {
    cursor
        .saturating_add_signed(rows)
        .min(count.saturating_sub(1))
}

impl Key {
    /// Returns the rows by which the key moves the cursor of a list that shows `page` rows.
    pub(crate) fn rows(self, page: isize) -> Option<isize> {
        match self {
            Key::Up => Some(-1),
            Key::Down => Some(1),
            Key::PageUp | Key::Ctrl('b') => Some(-page),
            Key::PageDown | Key::Ctrl('f') => Some(page),
            Key::Home => Some(isize::MIN),
            Key::End => Some(isize::MAX),
            _ => None,
        }
    }

    /// Returns the rows by which the key moves in a list that takes no text, where `j` and `k` move
    /// as well.
    pub(crate) fn rows_or_letter(self, page: isize) -> Option<isize> {
        match self {
            Key::Char('k') => Some(-1),
            Key::Char('j') => Some(1),
            _ => self.rows(page),
        }
    }
}

impl Action {
    /// Returns the rows by which the action moves in a list that shows `page` rows.
    pub(crate) fn rows(self, page: isize) -> Option<isize> {
        let half = (page / 2).max(1);
        match self {
            Action::LineUp => Some(-1),
            Action::LineDown => Some(1),
            Action::PageUp => Some(-page),
            Action::PageDown => Some(page),
            Action::HalfUp => Some(-half),
            Action::HalfDown => Some(half),
            Action::Top => Some(isize::MIN),
            Action::End => Some(isize::MAX),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cursor_stays_on_its_entry_while_it_is_listed() {
        let mut list = List::new(vec!["A.x", "A.y", "B.x"]);
        list.move_by(isize::MAX);
        assert_eq!((list.cursor(), list.chosen()), (2, Some(&"B.x")));
        list.narrow(|name| name.ends_with('x'));
        assert_eq!((list.cursor(), list.count()), (1, (2, 3)));
        list.narrow(|name| name.starts_with('A'));
        assert_eq!(list.chosen(), Some(&"A.x"));
        assert!(list.go_to(|name| *name == "A.y") && !list.go_to(|name| *name == "B.x"));
        assert_eq!(list.chosen(), Some(&"A.y"));
        list.narrow(|_| false);
        list.move_by(1);
        assert_eq!((list.cursor(), list.chosen()), (0, None));
    }

    #[test]
    fn cursor_moves_by_lines_and_pages_within_the_list() {
        let mut cursor = 4;
        for (key, there) in [
            (Key::Up, 3),
            (Key::PageDown, 8),
            (Key::PageDown, 9),
            (Key::Home, 0),
            (Key::Up, 0),
            (Key::End, 9),
        ] {
            cursor = moved(cursor, key.rows(5).unwrap(), 10);
            assert_eq!(cursor, there, "{key}");
        }
        assert_eq!(Key::Char('j').rows(5), None, "letters are text in a search");
        assert_eq!(Key::Char('j').rows_or_letter(5), Some(1));
        assert_eq!(Action::HalfUp.rows(1), Some(-1));
    }
}
