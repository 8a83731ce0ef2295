//! Tests the accuracy view: time against error, measured in the background.

use crate::screen::{preset, timed};
use krank::drawing::Glyphs;
use std::time::Duration;

/// Masks the digits of errors, because rounding may change with a formula.
fn without_errors(screen: &str) -> String {
    let mut masked = String::new();
    let mut rest = screen;
    while let Some(at) = rest.find("e-1") {
        let (before, after) = rest.split_at(at);
        let kept = before.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
        let digits = before.len() - kept.len();
        masked.push_str(kept);
        // Labels of the axis have a single digit.
        masked.push_str(if digits == 3 {
            "#.#"
        } else {
            &before[kept.len()..]
        });
        masked.push_str(&after[..3]);
        rest = &after[3..];
    }
    masked + rest
}

/// Returns the list of methods without the chart next to it.
fn list_of_methods(screen: &str) -> String {
    let lines = screen.lines().skip(1).take(22);
    let list = lines.map(|line| line.chars().skip(40).collect::<String>());
    without_errors(&list.collect::<Vec<_>>().join("\n"))
}

#[test]
fn accuracy_study_leaves_keys_live_and_stops_on_esc() {
    let mut session = timed(preset("four-bar"), Glyphs::Ascii, 80, 24);
    let line = session.press("4").last_line();
    assert!(
        line.starts_with(" accuracy  four-bar  measuring  0 %"),
        "{line}"
    );
    assert!(line.contains("Esc stop"), "{line}");
    // Other views stay usable during a study.
    assert!(session.press("1").last_line().contains("60.00 deg  ok"));
    assert!(session.press(".").last_line().contains("65.00 deg  ok"));
    session.press("4");
    for _ in 0..2000 {
        session.workbench.pass(Duration::from_millis(40));
        if session.last_line().contains("measuring 25 %") {
            break;
        }
    }
    let line = session.press("Esc").last_line();
    assert!(
        line.contains("stopped at 25 %    ? help  4 resume"),
        "{line}"
    );
    let before = session.workbench.frames();
    session.pass(10.0).paint();
    assert_eq!(session.workbench.frames(), before, "stopped is stopped");
    let screen = session.painted_text();
    insta::assert_snapshot!("accuracy-list-ascii-80x24", list_of_methods(&screen));
    for axis in ["error over time", "1e-16+"] {
        assert!(screen.contains(axis), "{screen}");
    }
    assert!(session.press("4").last_line().contains("measuring 25 %"));
}

#[test]
fn next_scene_restarts_study_and_small_screen_scrolls() {
    let mut session = timed(preset("stephenson-six-bar"), Glyphs::Ascii, 40, 12);
    session.press("4");
    for _ in 0..1200 {
        session.workbench.pass(Duration::from_millis(40));
    }
    let screen = session.press("Down").painted_text();
    assert!(
        screen.contains("\n   the group at E has no closed form"),
        "{screen}"
    );
    assert!(
        screen.lines().all(|line| line.chars().count() <= 40),
        "{screen}"
    );
    let end = session.press(&"PgDn ".repeat(20)).painted_text();
    assert!(end.contains("v RK4 3600 x 1000"), "{end}");
    let line = session.press("n").last_line();
    assert!(line.contains("measuring  0 %"), "{line}");
}

#[test]
fn m_key_steps_through_methods_and_esc_returns_to_study() {
    let mut session = timed(preset("four-bar"), Glyphs::Ascii, 80, 24);
    session.press("4");
    let screen = session.press("m").painted_text();
    assert!(screen.contains("1 Newton-Raphson"), "{screen}");
    assert!(screen.contains("error over iteration"), "{screen}");
    let line = session.last_line();
    assert!(
        line.starts_with(" accuracy  four-bar  Newton-Raphson"),
        "{line}"
    );
    assert!(line.contains("m method  Esc back"), "{line}");
    let below = session.press("End").painted_text();
    assert!(below.contains("to the assembly of this motion"), "{below}");
    // The guess stays at the opening state: stepping the driver moves the state away from it.
    let before = session.press("Home").painted_text();
    assert_ne!(session.press(".").painted_text(), before);
    assert!(session.press("m").painted_text().contains("1 Bisection"));
    let drawing = session.press("m").painted_text();
    assert!(drawing.contains("1 By compass and ruler"), "{drawing}");
    assert!(!drawing.contains("error over"), "{drawing}");
    // After the last method, and on Esc, the study returns; another Esc stops it.
    assert!(session.press("m").painted_text().contains("closed form"));
    assert!(
        session
            .press("m Esc")
            .painted_text()
            .contains("closed form")
    );
    assert!(session.last_line().contains("measuring"));
    assert!(session.press("Esc").last_line().contains("stopped"));
}

#[test]
fn method_starts_from_typed_guess() {
    let mut session = timed(preset("four-bar"), Glyphs::Ascii, 120, 40);
    let line = session.press("4 Enter").last_line();
    assert!(line.contains("press m for the first"), "{line}");
    let sketch = session.press("m").painted_text();
    let line = session.press("Enter").last_line();
    assert!(
        line.contains("r3=20, r4=280") && line.contains("Esc cancel"),
        "{line}"
    );
    // An invalid guess is reported and can be corrected.
    let line = session.type_in("r3=20, r9=280").press("Enter").last_line();
    assert!(line.contains("no vector is named `r9`"), "{line}");
    let guessed = session
        .press("Backspace Backspace Backspace Backspace Backspace Backspace")
        .type_in("r4=280")
        .press("Enter")
        .painted_text();
    assert!(guessed.contains("From the guess"), "{guessed}");
    assert!(guessed.contains("30.0538  289.934"), "{guessed}");
    // The guess survives driver steps and edits, and the prompt proposes it again.
    assert!(session.press(".").painted_text().contains("From the guess"));
    let line = session.press("Enter").last_line();
    assert!(line.contains("r3=20, r4=280"), "{line}");
    let again = session.press("Ctrl-U Enter").press(",").painted_text();
    assert_eq!(again, sketch);
    // Only bisection accepts an interval; the graphical method takes no guess.
    let line = session
        .press("Enter")
        .type_in("r3=0..90")
        .press("Enter")
        .last_line();
    assert!(line.contains("is for bisection"), "{line}");
    session.press("Esc m Enter").type_in("r3=0..90");
    let halved = session.press("Enter").painted_text();
    assert!(
        halved.contains("1 Bisection") && halved.contains("45.0000"),
        "{halved}"
    );
    let line = session.press("m Enter").last_line();
    assert!(line.contains("uses no guess"), "{line}");
}

#[test]
fn method_view_fits_every_screen_size() {
    for (cols, rows) in [(40, 12), (80, 24), (120, 40)] {
        let mut session = timed(preset("press"), Glyphs::Ascii, cols, rows);
        session.press("4");
        for _ in 0..3 {
            let screen = session.press("m").painted_text();
            let fits = |line: &str| line.chars().count() <= usize::from(cols);
            assert!(screen.lines().all(fits), "{screen}");
            assert_eq!(screen.lines().count(), usize::from(rows), "{screen}");
        }
    }
}
