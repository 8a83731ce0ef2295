//! Tests the tour of the workbench.

use crate::claims::{cells, collapse_blanks, differences, places};
use crate::screen::four_bar;
use std::ops::RangeInclusive;

const THROUGH_THE_TOUR: [&str; 5] = ["I", "Enter", "Right", "space", "Enter"];

/// Returns the rows and columns of the tour's box.
fn tour_box(screen: &str) -> (RangeInclusive<usize>, RangeInclusive<usize>) {
    let rows = cells(screen);
    let top = screen
        .lines()
        .position(|line| line.contains("+- Tour"))
        .unwrap();
    let start = screen
        .lines()
        .nth(top)
        .and_then(|line| line.find("+- Tour"));
    let mut corners = places(&rows[top..=top], &['+']);
    corners.retain(|(_, col)| Some(*col) >= start);
    let (left, right) = (corners[0].1, corners[1].1);
    let height = rows[top + 1..]
        .iter()
        .position(|row| row[left] == '+')
        .unwrap();
    (top..=top + 1 + height, left..=right)
}

/// Returns the tour's text as one line.
fn tour_text(screen: &str) -> String {
    let (rows, cols) = tour_box(screen);
    let inner = cells(screen)[rows.start() + 1..*rows.end()].to_vec();
    let line = |row: &Vec<char>| {
        row[cols.start() + 1..*cols.end()]
            .iter()
            .collect::<String>()
    };
    collapse_blanks(&inner.iter().map(line).collect::<Vec<_>>().join("\n"))
}

/// Shows every screen of the tour, next to the linkage where it fits.
#[test]
fn tour_shows_five_screens_and_restores_the_view() {
    let screens = THROUGH_THE_TOUR.iter().scan(four_bar(40, 12), |tiny, key| {
        Some(tiny.press(key).painted_text())
    });
    let small: Vec<String> = screens.collect();
    insta::assert_snapshot!("tour-40x12", small.join("\n") + "\n");
    for (cols, rows) in [(80, 24), (40, 12), (120, 40)] {
        let mut session = four_bar(cols, rows);
        let before = session.painted_text();
        for (key, small) in THROUGH_THE_TOUR.iter().zip(&small) {
            let screen = session.press(key).painted_text();
            // The text is the same at every size, and only cells below the box are hidden.
            assert_eq!(tour_text(&screen), tour_text(small), "{screen}");
            let (box_rows, box_cols) = tour_box(&screen);
            let last = usize::from(rows) - 1;
            let mut outside = differences(&before, &screen);
            outside.retain(|(row, col, ..)| !box_rows.contains(row) || !box_cols.contains(col));
            assert!(outside.iter().all(|(row, ..)| *row == last), "{screen}");
            assert!(session.last_line().contains("Esc end"), "{screen}");
        }
        assert!(session.press("Left").painted_text().contains("Tour 4/5"));
        assert!(!session.press("Enter Enter").painted_text().contains("Tour"));
        assert_eq!(session.painted_text(), before, "nothing else has happened");
        assert!(!session.press("F2 Esc").painted_text().contains("Tour"));
    }
}

/// Motion keys work during the tour; keys that would leave it do not.
#[test]
fn tour_accepts_motion_keys_but_no_view_changes() {
    let mut session = four_bar(80, 24);
    let line = session.press("I Enter . .").last_line();
    assert!(line.contains("70.00 deg"), "{line}");
    assert!(session.press("n w a g").painted_text().contains("Tour 2/5"));
    assert!(session.press("2").painted_text().contains("Tour 2/5"));
    assert!(session.press("?").painted_text().contains("Help"));
}
