//! Tests the working view.

use crate::claims::assert_shown;
use crate::screen::{Session, preset};
use krank::drawing::Glyphs;
use krank::scene::presets;

fn session(name: &str, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    let mut session = Session::new(preset(name), glyphs, cols, rows);
    session.press("7");
    session
}

/// Returns all lines of the view, found by scrolling.
fn all(session: &mut Session) -> Vec<String> {
    let mut shown = session.body();
    let mut lines: Vec<String> = shown.lines().map(str::to_owned).collect();
    for _ in 0..2_000 {
        let below = session.press("Down").body();
        if below == shown {
            break;
        }
        lines.push(below.lines().last().unwrap().to_owned());
        shown = below;
    }
    lines
        .iter()
        .map(|line| line.trim_end_matches(['v', '^']).trim_end().to_owned())
        .collect()
}

#[test]
fn keys_open_the_working_and_return() {
    let mut session = session("four-bar", Glyphs::Ascii, 80, 25);
    let screen = session.painted_text();
    assert!(
        session.last_line().starts_with(" working  four-bar"),
        "{screen}"
    );
    // The rows above these are in the manual.
    let lines = [
        "r1 + r2 + r3 + r4 = 0",
        "With the unit vectors u(theta) along an angle and n(theta) perpendicular to",
        "dn/dt = -omega u(theta)",
        "u(a)*u(b) = n(a)*n(b) = cos(a - b)",
    ];
    assert_shown(&screen, &lines);
    assert!(session.press("1").last_line().starts_with(" motion"));
}

#[test]
fn keys_jump_between_headings() {
    let mut session = session("four-bar", Glyphs::Ascii, 80, 24);
    let mut first = |key: &str| {
        session.press(key);
        let line = session.body().lines().next().unwrap().to_owned();
        line.trim().to_owned()
    };
    assert!(first("J").starts_with("1 Vector polygons"));
    assert!(first("J").starts_with("2 Position table"));
    assert!(first("J").starts_with("3 Loop equations"));
    assert!(first("J").starts_with("4 "));
    assert!(first("K").starts_with("3 Loop equations"));
    assert!(first("K").starts_with("2 Position table"));
    for _ in 0..40 {
        first("J");
    }
    let end = first("J");
    let last = session.last_line();
    assert!(last.contains("no further part"), "{end} {last}");
}

#[test]
fn working_wraps_on_small_screens_and_fits_large_ones() {
    insta::assert_snapshot!(
        "working-40x12",
        session("four-bar", Glyphs::Ascii, 40, 12)
            .press("PgDn PgDn PgDn PgDn PgDn PgDn PgDn")
            .body()
    );
    insta::assert_snapshot!(
        "working-120x40",
        session("four-bar", Glyphs::Braille, 120, 40)
            .press("O PgDn PgDn")
            .body()
    );
}

#[test]
fn scrolling_reaches_every_part() {
    for (cols, rows) in [(40, 12), (80, 24), (120, 40)] {
        let lines = all(&mut session("slider-crank", Glyphs::Ascii, cols, rows));
        let text = lines.join("\n");
        for part in [
            "Vector polygons",
            "Position table",
            "Loop equations",
            "Velocities",
            "Accelerations",
            "Points",
            "Instant centres",
            "Check",
        ] {
            assert!(text.contains(part), "{part} at {cols} x {rows}:\n{text}");
        }
        assert!(text.contains("= -89.4427 rad/s"), "{text}");
    }
}

/// The view shows the current state, both paused and playing.
#[test]
fn working_follows_the_driver() {
    let mut session = session("four-bar", Glyphs::Ascii, 80, 41);
    assert!(session.painted_text().contains("at 60 deg"));
    assert!(session.press(".").painted_text().contains("at 65 deg"));
    session.press("space").pass(1.0);
    let playing = session.painted_text();
    assert!(!playing.contains("at 65 deg"), "{playing}");
    // The scroll position is kept.
    let before = session.press("space J J J").body();
    let heading = before.lines().next().unwrap().to_owned();
    let after = session.press(".").body();
    assert_eq!(after.lines().next().unwrap(), heading);
}

#[test]
fn next_scene_shows_its_own_working() {
    let mut session = session("four-bar", Glyphs::Ascii, 80, 24);
    let before = session.body();
    assert_ne!(session.press("n").body(), before);
    assert!(session.last_line().starts_with(" working"));
}

#[test]
fn greek_letters_are_spelled_out_without_braille() {
    let shown = |glyphs| all(&mut session("four-bar", glyphs, 80, 24)).join("\n");
    for glyphs in [Glyphs::Ascii, Glyphs::Line] {
        let text = shown(glyphs);
        assert!(text.is_ascii() && text.contains("theta3"), "{text}");
    }
    let greek = shown(Glyphs::Braille);
    assert!(
        greek.contains("θ3") && greek.contains("ω4") && !greek.contains("theta"),
        "{greek}"
    );
}

#[test]
fn dead_point_is_reported() {
    let mut session = session("double-rocker", Glyphs::Ascii, 80, 24);
    session
        .press("g")
        .type_in("101.53695903281549")
        .press("Enter");
    let screen = session.painted_text();
    assert!(screen.contains("State: dead-point."), "{screen}");
    assert!(
        screen.contains("A dead point: the motion ends here."),
        "{screen}"
    );
}

#[test]
fn every_preset_is_shown_at_every_size() {
    for found in presets::all() {
        for (cols, rows) in [(40, 12), (80, 24), (120, 40)] {
            let mut session = session(found.name, Glyphs::Ascii, cols, rows);
            for keys in ["", "PgDn", "PgDn", "PgUp", ". . ."] {
                let screen = session.press(keys).painted_text();
                assert!(screen.is_ascii() && !screen.contains("NaN"), "{screen}");
            }
        }
    }
}
