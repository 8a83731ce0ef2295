//! Searches for a row by its name.

use crate::report::Tables;
use crate::tui::commands::line::EditLine;
use crate::tui::figures::cursor::Cursor;
use crate::tui::figures::sheet::SheetPart;

/// A typed name, and the cursor's position before the search.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct NameSearch {
    pub(crate) name: EditLine,
    pub(crate) from: SearchOrigin,
}

/// The starting point of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SearchOrigin {
    /// In the tables.
    Tables(Cursor),
    /// In this row of the scene view.
    Scene(usize),
    /// At this line of a text view.
    Lines(usize),
}

/// The quality of a match, the best last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum NameMatch {
    Within,
    TrackingStart,
    Whole,
}

impl NameMatch {
    fn of(name: &str, typed: &str) -> Option<NameMatch> {
        let name = name.to_ascii_lowercase();
        match name.find(typed)? {
            0 if name.len() == typed.len() => Some(NameMatch::Whole),
            0 => Some(NameMatch::TrackingStart),
            _ => Some(NameMatch::Within),
        }
    }
}

/// A line with a search hit, and the searched text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct FoundLine {
    pub(crate) line: usize,
    text: String,
}

impl FoundLine {
    /// Finds the first line from `from` on, cyclically, that contains the typed text, ignoring
    /// case. Backwards, finds the last one before `from`.
    pub(crate) fn of(
        lines: &[String],
        typed: &str,
        from: usize,
        forward: bool,
    ) -> Option<FoundLine> {
        let count = lines.len();
        let mut round = (0..count).map(|by| match forward {
            true => (from + by) % count,
            false => (from + count - 1 - by) % count,
        });
        let line = round.find(|at| has(&lines[*at], typed))?;
        let text = typed.to_owned();
        Some(FoundLine { line, text })
    }

    /// Returns `true` if the line still contains the text; it may have changed with the scene or
    /// the driver.
    pub(crate) fn is_in(&self, line: &str) -> bool {
        has(line, &self.text)
    }
}

fn has(line: &str, typed: &str) -> bool {
    let [line, typed] = [line, typed].map(str::to_ascii_lowercase);
    line.contains(&typed)
}

/// Finds the row whose name matches best, ignoring case; the first one from `from` on if several
/// are equal.
pub(crate) fn best(tables: &Tables, typed: &str, from: Cursor) -> Option<Cursor> {
    let fits = fits(tables, typed, from);
    let best = fits.iter().map(|(fit, _)| *fit).max()?;
    let found = fits.into_iter().find(|(fit, _)| *fit == best);
    found.map(|(_, cursor)| cursor)
}

/// Finds the next row behind `from` whose name contains the typed text, or the row before it if not
/// `forward`; `from` itself comes last.
pub(crate) fn next(tables: &Tables, typed: &str, from: Cursor, forward: bool) -> Option<Cursor> {
    let fits = fits(tables, typed, from);
    let is_other = |(_, c): &&(NameMatch, Cursor)| (c.part, c.row) != (from.part, from.row);
    let other = match forward {
        true => fits.iter().find(is_other),
        false => fits.iter().rfind(is_other),
    };
    other.or(fits.first()).map(|(_, cursor)| *cursor)
}

/// Returns all matching rows, starting at `from` and cyclically.
fn fits(tables: &Tables, typed: &str, from: Cursor) -> Vec<(NameMatch, Cursor)> {
    let typed = typed.trim().to_ascii_lowercase();
    let vectors = tables.vectors.iter().map(|vector| &vector.name);
    let points = tables.points.iter().map(|point| &point.name);
    let vectors = vectors
        .enumerate()
        .map(|(row, name)| (Cursor::at(SheetPart::Vectors, row), name));
    let points = points
        .enumerate()
        .map(|(row, name)| (Cursor::at(SheetPart::Points, row), name));
    let mut rows: Vec<_> = vectors.chain(points).collect();
    let here = rows
        .iter()
        .position(|(c, _)| (c.part, c.row) == (from.part, from.row));
    rows.rotate_left(here.unwrap_or(0));
    let fits = rows.into_iter();
    fits.filter_map(|(cursor, name)| Some((NameMatch::of(name, &typed)?, cursor)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, presets};
    use crate::solver::{Order, Solver};

    fn tables() -> Tables {
        let text = presets::find("four-bar").unwrap().text;
        let scene = Scene::parse(text, "four-bar").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let mut state = solver.state();
        let _ = solver.solve(60.0, Order::Position, &mut state);
        Tables::new(&scene, &state)
    }

    fn name(tables: &Tables, cursor: Cursor) -> &str {
        match cursor.part {
            SheetPart::Vectors => &tables.vectors[cursor.row].name,
            SheetPart::Points => &tables.points[cursor.row].name,
        }
    }

    #[test]
    fn search_finds_best_match_first() {
        let tables = tables();
        let found = |typed| best(&tables, typed, Cursor::default()).map(|c| name(&tables, c));
        // `C` is a name, although `r2.com` contains it.
        assert_eq!(found("c"), Some("C"));
        assert_eq!(found("R3"), Some("r3"));
        assert_eq!(found("r3."), Some("r3.com"));
        assert_eq!(found("com"), Some("r2.com"));
        assert_eq!(found("nothing"), None);
    }

    #[test]
    fn next_match_wraps_around() {
        let tables = tables();
        let mut cursor = Cursor::default();
        let mut found = Vec::new();
        for _ in 0..4 {
            cursor = next(&tables, "com", cursor, true).unwrap();
            found.push(name(&tables, cursor));
        }
        assert_eq!(found, ["r2.com", "r3.com", "r4.com", "r2.com"]);
        let before = next(&tables, "com", cursor, false).unwrap();
        assert_eq!(name(&tables, before), "r4.com");
        for forward in [true, false] {
            let alone = next(&tables, "r2.com", cursor, forward).unwrap();
            assert_eq!(alone, cursor, "it is its own next");
            assert_eq!(next(&tables, "nothing", cursor, forward), None);
        }
    }

    #[test]
    fn lines_are_searched_in_both_directions() {
        let lines = ["a b", "c", "B", "d"].map(str::to_owned);
        let found = |from, forward| {
            let found = FoundLine::of(&lines, "b", from, forward);
            found.map(|found| found.line)
        };
        assert_eq!([0, 1, 3].map(|from| found(from, true)), [0, 2, 0].map(Some));
        assert_eq!(
            [0, 2, 3].map(|from| found(from, false)),
            [2, 0, 2].map(Some)
        );
        assert_eq!(FoundLine::of(&[], "b", 0, false), None);
    }
}
