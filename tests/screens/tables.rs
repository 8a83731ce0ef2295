//! Tests the tables view and its cursor.

use crate::screen::{Session, four_bar, preset};
use krank::drawing::Glyphs;

/// Returns the row under the cursor.
pub(crate) fn under_cursor(session: &mut Session) -> String {
    let screen = session.painted_text();
    let mut marked = screen.lines().filter(|line| line.starts_with('>'));
    let line = marked.next().unwrap_or_else(|| panic!("{screen}"));
    assert_eq!(marked.next(), None, "{screen}");
    assert_eq!(line.matches('[').count(), 1, "{screen}");
    line.to_owned()
}

/// Returns the text of the reversed cells, without tabs and the last line.
fn reversed(session: &mut Session) -> String {
    let screen = session.painted_text();
    let cell = |row: usize, col: usize| {
        let [row, col] = [row, col].map(|n| u16::try_from(n).unwrap());
        let cell = session.terminal.screen().cell(row, col).unwrap();
        cell.inverse().then(|| cell.contents().to_owned())
    };
    // The active tab is reversed, too.
    let rows = 1..screen.lines().count() - 1;
    let cells = rows.flat_map(|row| (0..80).filter_map(move |col| cell(row, col)));
    cells.collect()
}

#[test]
fn cursor_marks_one_row_and_one_value() {
    let mut session = four_bar(80, 24);
    assert!(under_cursor(session.press("2")).starts_with("> r2        [100.000] "));
    assert_eq!(reversed(&mut session), "100.000");
    let row = under_cursor(session.press("Down j L"));
    assert!(row.starts_with("> r4         250.000  [290.753*]"), "{row}");
    // Moving down crosses headings to the points and keeps the column number.
    let row = under_cursor(session.press("Down Down"));
    assert!(row.starts_with("> A           0.000     [0.000] "), "{row}");
    assert!(under_cursor(session.press("k Up Up H")).starts_with("> r3        [300.000]"));
    assert!(under_cursor(session.press("Up Up Up Up")).starts_with("> r2        [100.000]"));
    assert!(under_cursor(session.press("PgDn")).starts_with("> r4.com"));
    // L moves through the columns of all chunks and stops at the last.
    session.press("PgUp Down Down Down Down Down Down Down L L L L L L L L L L L L L");
    let row = under_cursor(&mut session);
    assert!(row.contains("[206.466]"), "{row}");
    // Apart from the cursor and its brackets, the tables equal those of the manual.
    let unmarked = |body: String| body.replace(['>', '[', ']'], " ").replace(" \n", "\n");
    let first = four_bar(80, 24).press("2").body();
    assert_eq!(unmarked(session.body()), unmarked(first));
    let line = session.last_line();
    assert!(
        line.contains(" ok  +-") && line.contains(" deg  ? help"),
        "{line}"
    );
    // The values change and the cursor stays.
    let row = under_cursor(session.press("."));
    assert!(row.starts_with("> C ") && !row.contains("206.466"), "{row}");
}

#[test]
fn view_scrolls_with_cursor_and_keeps_column_names() {
    let mut session = Session::new(preset("jansen-leg"), Glyphs::Ascii, 40, 12);
    session.press("2");
    let mut last = String::new();
    for _ in 0..200 {
        let row = under_cursor(session.press("Down"));
        let screen = session.painted_text();
        let heading = screen.lines().nth(1).unwrap();
        assert!(!row.is_empty() && !heading.is_empty(), "{screen}");
        let above = screen.lines().take_while(|line| !line.starts_with('>'));
        let names = |line: &&str| line.starts_with("  vector ") || line.starts_with("  point ");
        assert!(above.filter(names).count() >= 1, "{screen}");
        last = row;
    }
    // The cursor stops at the end, and moves back the same way.
    assert_eq!(under_cursor(session.press("Down")), last);
    insta::assert_snapshot!("tables-end-ascii-40x12", session.painted_text());
    for _ in 0..200 {
        session.press("Up");
    }
    assert_eq!(
        session
            .painted_text()
            .lines()
            .nth(2)
            .unwrap()
            .chars()
            .next(),
        Some('>')
    );
    // A screen that is too small loses nothing, and another width keeps the value under the cursor.
    session.press("PgDn PgDn PgDn");
    let figure = |row: &str| row.split(['[', ']']).nth(1).unwrap().to_owned();
    let before = figure(&under_cursor(&mut session));
    for (cols, rows) in [(20, 5), (100, 40), (40, 12)] {
        session.workbench.resize(cols, rows);
        session = Session::on(session.workbench, cols, rows);
        session.workbench.forget();
        if cols > 20 {
            assert_eq!(figure(&under_cursor(&mut session)).trim(), before.trim());
        }
    }
}

#[test]
fn rows_are_found_by_name() {
    let mut session = four_bar(80, 24);
    let line = session.press("2 /").last_line();
    assert_eq!(line, " search  name:     Enter keep  Esc back");
    assert!(under_cursor(session.press("C")).starts_with("> C "));
    assert!(under_cursor(session.press("O")).starts_with("> r2.com "));
    assert!(under_cursor(session.press("Enter")).starts_with("> r2.com "));
    // Repeated searches find the next rows and wrap around.
    for name in ["r3.com", "r4.com", "r2.com"] {
        let row = under_cursor(session.press("/ Enter"));
        assert!(row.starts_with(&format!("> {name} ")), "{row}");
    }
    // Esc restores the cursor.
    assert!(under_cursor(session.press("/ r 4 .")).starts_with("> r4.com "));
    assert!(under_cursor(session.press("Esc")).starts_with("> r2.com "));
    // An unknown name is reported and can be corrected.
    let line = session.press("/ r 4 z").last_line();
    assert_eq!(line, " search  name: r4z    no row is named r4z");
    assert!(under_cursor(&mut session).starts_with("> r2.com "));
    assert!(
        session
            .press("Enter")
            .last_line()
            .contains("no row is named")
    );
    let line = session.press("Backspace Enter").last_line();
    assert!(line.starts_with(" tables "), "{line}");
    assert!(under_cursor(&mut session).starts_with("> r4 "));
    let mut tiny = four_bar(40, 12);
    let screen = tiny.press("2 /").type_in("nothing").painted_text();
    assert!(screen.contains(" no row is named nothing"), "{screen}");
    let line = tiny.last_line();
    assert!(line.starts_with(" search  name: nothing "), "{line}");
    let line = four_bar(80, 24).press("1 /").last_line();
    assert!(line.contains("nothing to search here"), "{line}");
}

#[test]
fn points_are_selected_for_the_motion_view() {
    let mut session = four_bar(80, 24);
    let line = session.press("2 / C Enter x").last_line();
    assert!(line.ends_with("C chosen for the motion view"), "{line}");
    assert!(under_cursor(&mut session).starts_with(">+C "));
    // A vector selects its moving end points.
    let line = session.press("/ r 3 Enter x").last_line();
    assert!(
        line.ends_with("B and C chosen for the motion view"),
        "{line}"
    );
    let marked = |screen: &str| screen.lines().filter(|line| line.starts_with(" +")).count();
    assert_eq!(marked(&session.painted_text()), 4, "B and C, each twice");
    let line = session.press("x").last_line();
    assert!(line.ends_with("B and C no longer chosen"), "{line}");
    assert_eq!(marked(&session.painted_text()), 0);
    for name in ["A", "r 1"] {
        let line = session.press(&format!("/ {name} Enter x")).last_line();
        assert!(line.contains("never moves: nothing to follow"), "{line}");
    }
    // A scene change clears the selection.
    session.press("/ C Enter x Esc n p");
    assert_eq!(marked(&session.painted_text()), 0);
}
