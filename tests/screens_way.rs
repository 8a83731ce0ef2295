//! Finding one's way in the workbench, as a terminal shows it: the help and searching it.
#![cfg(feature = "tui")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "support/screen.rs"]
mod screen;

use krank::drawing::Glyphs;
use screen::{Session, preset};

fn four_bar(cols: u16, rows: u16) -> Session {
    Session::new(preset("four-bar"), Glyphs::Ascii, cols, rows)
}

#[test]
fn the_help_is_searched_by_words() {
    let mut session = four_bar(80, 24);
    let screen = session.press("? /").type_in("arrow vel").look();
    assert!(screen.contains("Help /arrow vel"), "{screen}");
    assert!(screen.contains("arrows of velocity"), "{screen}");
    assert!(!screen.contains("acceleration   "), "{screen}");
    let line = session.last_line();
    assert!(line.ends_with("Esc all keys  Enter keep"), "{line}");
    // Nothing that is typed is taken for a key.
    assert!(session.type_in("q?").look().contains("no key does that"));
    assert!(session.look().contains("Esc shows all keys"));
    // Enter keeps what was found, and keys are keys again.
    session.press("Ctrl-U").type_in("leave").press("Enter");
    let screen = session.look();
    assert!(screen.contains("leave from anywhere"), "{screen}");
    assert!(session.last_line().contains("/ search"));
    // First all keys again, then the view.
    let screen = session.press("Esc").look();
    assert!(screen.contains("play or pause"), "{screen}");
    assert!(!session.press("Esc").look().contains("Help"));
}

#[test]
fn the_help_of_each_view_begins_with_its_own_keys() {
    for (view, title, help) in [
        ("1", "What the motion view shows", "arrows of velocity"),
        ("2", "In the tables", "show it in the motion"),
        ("3", "In the plots", "mark the extrema"),
        ("4", "The motion", "play or pause"),
        ("6", "In the scene view", "nudge by more"),
    ] {
        let screen = four_bar(40, 12).press(view).press("?").look();
        let first = screen.lines().nth(2).unwrap();
        assert!(first.starts_with(&format!("| {title} ")), "{screen}");
        assert!(screen.contains(&help[..12]), "{screen}");
    }
}

/// Whatever the size, scrolling leads to every key.
#[test]
fn every_key_of_the_help_is_reached() {
    for (cols, rows) in [(40, 12), (80, 24), (120, 40), (200, 60)] {
        let mut session = four_bar(cols, rows);
        let mut seen = session.press("?").look();
        for _ in 0..20 {
            seen += &session.press("PgDn").look();
        }
        for (title, _, help) in krank::tui::key_list() {
            assert!(seen.contains(title), "{cols} x {rows}: {title}");
            assert!(seen.contains(help), "{cols} x {rows}: {help}");
        }
    }
}
