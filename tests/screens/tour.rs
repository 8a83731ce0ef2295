//! Tests the tour of the workbench.

use crate::claims::collapse_blanks;
use crate::screen::four_bar;

/// Returns the rows of the tour, its title first, and the rows above it.
fn split(screen: &str) -> (Vec<&str>, Vec<&str>) {
    let rows: Vec<&str> = screen.lines().collect();
    let top = rows.iter().rposition(|row| row.starts_with("=["));
    let top = top.unwrap_or_else(|| panic!("no tour in\n{screen}"));
    // The verdict and the status follow.
    (rows[top..rows.len() - 2].to_vec(), rows[..top].to_vec())
}

/// Returns the text of a screen of the tour from all its parts, and moves to the next screen.
fn screens_text(session: &mut crate::screen::Session) -> String {
    let mut text = String::new();
    let first = session.painted_text();
    let number = |screen: &str| {
        let at = screen.find("/5");
        at.map(|at| screen[at - 1..at].to_owned())
    };
    let mut screen = first.clone();
    while number(&screen).is_some() && number(&screen) == number(&first) {
        let (tour, _) = split(&screen);
        text += &tour[1..].join(" ");
        text += " ";
        screen = session.press("Enter").painted_text();
    }
    collapse_blanks(&text)
}

/// Shows every screen of the tour below the panes, which it does not cover.
#[test]
fn tour_shows_five_screens_and_restores_the_view() {
    let mut texts = Vec::new();
    for (cols, rows) in [(40, 12), (80, 24), (120, 40)] {
        let mut session = four_bar(cols, rows);
        let before = session.painted_text();
        session.press("I");
        let own: Vec<String> = (0..5).map(|_| screens_text(&mut session)).collect();
        assert_eq!(session.painted_text(), before, "nothing else has happened");
        texts.push(own);
        assert!(!session.press("F2 Esc").painted_text().contains("Tour"));
    }
    assert_eq!(texts[0], texts[1]);
    assert_eq!(texts[0], texts[2]);
}

/// The panes keep their contents next to the tour: the drawing, and where they fit, the tables.
#[test]
fn tour_leaves_the_panes_visible() {
    for (cols, rows) in [(40, 12), (80, 24), (120, 40)] {
        let mut session = four_bar(cols, rows);
        for page in 0..5 {
            let keys = if page == 0 { "I" } else { "Enter" };
            let screen = session.press(keys).painted_text();
            let (tour, above) = split(&screen);
            assert!(above.len() >= 5 && tour.len() >= 2, "{screen}");
            let above = above.join("\n");
            let is_seen = |name: &str| above.contains(name);
            assert!(is_seen("B") && is_seen("C"), "{screen}");
            assert!(cols < 80 || is_seen("omega"), "{screen}");
            assert!(session.last_line().contains("Esc end"), "{screen}");
            let next = if page < 4 || cols < 80 {
                "Enter next"
            } else {
                "Enter done"
            };
            assert!(tour[0].contains(next), "{screen}");
        }
    }
    let mut session = four_bar(40, 12);
    insta::assert_snapshot!("tour-40x12", session.press("I Enter").painted_text());
}

#[test]
fn pages_are_turned_back() {
    for (cols, rows) in [(40, 12), (80, 24)] {
        let mut session = four_bar(cols, rows);
        // The drawing may place its names differently.
        let mut tour = |key: &str| {
            let screen = session.press(key).painted_text();
            split(&screen).0.join("\n")
        };
        let mut pages = vec![tour("I")];
        while pages.len() < 5 {
            pages.push(tour("Right"));
        }
        for page in pages.iter().rev().skip(1) {
            assert_eq!(&tour("Left"), page);
        }
        assert_eq!(tour("Left"), pages[0]);
    }
}

/// Keys of the motion and of the views work during the tour, which describes them; keys that would
/// leave it do not.
#[test]
fn tour_accepts_keys_of_motion_and_views() {
    let mut session = four_bar(80, 24);
    let line = session.press("I Enter . .").last_line();
    assert!(line.contains("70.00 deg"), "{line}");
    assert!(session.press("n w a g").painted_text().contains("Tour 2/5"));
    let tables = session.press("2").painted_text();
    assert!(
        tables.contains("Tour 2/5") && tables.contains("[2 Tables]"),
        "{tables}"
    );
    assert!(session.press("?").painted_text().contains("Help"));
}
