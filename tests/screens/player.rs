//! Tests moving the crank: go to, single steps and playback.

use crate::screen::{SWINGING, Session, open, preset};
use krank::drawing::Glyphs;
use krank::tui::Origin;

fn four_bar(glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    Session::new(preset("four-bar"), glyphs, cols, rows)
}

/// The status line has the angle of the tables, also where a double has no decimals.
#[test]
fn angle_within_turn_is_exact_far_away() {
    for (typed, angle) in [
        ("1 e 1 8", "280.00 deg"),
        ("- 1 e 1 8", "80.00 deg"),
        ("1 0 8 0 . 5", "0.50 deg +3 turns"),
    ] {
        let mut session = four_bar(Glyphs::Ascii, 120, 40);
        session.press("g").press(typed);
        let line = session.press("Enter").last_line();
        assert!(line.contains(&format!(" {angle}")), "{typed}: {line}");
    }
}

#[test]
fn go_to_reaches_typed_angle_or_reports_range() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    let typed = session.press("g 1 2 3 . 5").last_line();
    assert_eq!(typed, " go to  angle [deg]: 123.5    Enter go  Esc cancel");
    assert!(
        session
            .press("Enter")
            .last_line()
            .contains("123.50 deg  ok")
    );
    assert!(
        session
            .press("g x Enter")
            .last_line()
            .contains("not a number in deg: x")
    );
    assert!(session.press("Esc").last_line().contains("123.50 deg"));

    let far = session.press("g Ctrl-U 1 e 3 0 0 Enter").last_line();
    assert!(
        far.contains("turns  ok  ") && far.contains("? help"),
        "{far}"
    );

    let opened = open(SWINGING, Origin::Stdin);
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    let refused = session.press("g 1 8 0 Enter").last_line();
    assert!(
        refused.ends_with("out of reach: -82.81 to 82.81 deg"),
        "{refused}"
    );
    // An angle one turn away names the same direction.
    let reached = session.press("Ctrl-U 4 2 0 Enter").last_line();
    assert!(
        reached.ends_with("60.00 deg  taken as 60.00 deg"),
        "{reached}"
    );
}

#[test]
fn steps_are_exact_decimals() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    session.press("[ [ [ [ [ [");
    for _ in 0..7 {
        session.press(".");
    }
    assert!(session.last_line().contains("   60.70 deg  ok"));
    session.press("] ] ] ] ] ] ] ] ] ] ] , , ,");
    assert!(session.last_line().contains("  150.70 deg -1 turn  ok"));
    assert!(
        session
            .press("Home")
            .last_line()
            .contains("   60.00 deg  ok")
    );
}

#[test]
fn turn_plays_in_four_seconds_and_pause_paints_nothing() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    session.press("space").pass(1.0);
    assert!(session.last_line().contains("  150.00 deg  ok"));
    // A terminal that blocks for more than a turn drops frames but keeps the time.
    assert!(
        session
            .pass(5.0)
            .last_line()
            .contains("  240.00 deg +1 turn  ok")
    );
    session.press("r").pass(1.0);
    assert!(session.last_line().contains("  150.00 deg +1 turn  ok"));
    session.press("+").pass(0.5);
    assert!(session.last_line().contains("   60.00 deg +1 turn  ok"));
    session.press("space");
    let before = session.workbench.frames();
    session.pass(10.0).paint();
    assert_eq!(session.workbench.frames(), before);
}

#[test]
fn playback_reverses_at_limits_of_the_motion() {
    let opened = open(SWINGING, Origin::Stdin);
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    session.press("space");
    let mut angles = Vec::new();
    for _ in 0..200 {
        let line = session.pass(0.05).last_line();
        let words: Vec<&str> = line.split_whitespace().collect();
        let at = words.iter().position(|w| *w == "deg").unwrap();
        angles.push(words[at - 1].parse::<f64>().unwrap());
        assert!(!line.contains("no assembly"), "{line}");
    }
    let turns = angles
        .windows(3)
        .filter(|a| (a[1] - a[0]) * (a[2] - a[1]) < 0.0);
    assert!(turns.count() >= 4, "{angles:?}");
}
