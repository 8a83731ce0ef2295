//! Tests keys and commands that users of vi, pagers and other full-screen programs expect.

use crate::screen::{Session, folder, four_bar, open, text};
use krank::drawing::Glyphs;
use krank::tui::Origin;
use std::fs;

/// Returns the name in the row under the cursor of the tables.
fn row(session: &mut Session) -> String {
    let screen = session.painted_text();
    let line = screen.lines().find(|line| line.starts_with('>'));
    let name = line.and_then(|line| line.split_whitespace().nth(1));
    name.unwrap_or_default().to_owned()
}

#[test]
fn n_repeats_a_search_until_esc() {
    let mut session = four_bar(80, 24);
    session.press("2 /").type_in("com").press("Enter");
    assert_eq!(row(&mut session), "r2.com");
    for (key, name) in [("n", "r3.com"), ("n", "r4.com"), ("N", "r3.com")] {
        session.press(key);
        assert_eq!(row(&mut session), name, "{key}");
    }
    let before = session.press("Esc").last_line();
    let after = session.press("n").last_line();
    assert_ne!(after, before, "it opens the next preset again");
    // In lines of text, the cursor is a mark next to the line.
    let mut session = four_bar(80, 24);
    let first = session.press("7 /").type_in("mm").press("Enter").body();
    let second = session.press("n").body();
    assert_ne!(second, first);
    assert_eq!(session.press("N").body(), first);
}

#[test]
fn q_closes_the_help_before_it_quits() {
    let mut session = four_bar(80, 24);
    let before = session.body();
    for keys in ["?", "? Tab", "a", "I", ":"] {
        session.press(keys);
        assert_ne!(session.body(), before, "{keys}");
        if keys == ":" {
            session.press("Esc");
        }
        assert!(keys == ":" || session.workbench.press("q"), "{keys}");
        assert_eq!(session.body(), before, "{keys}");
    }
    assert!(!session.workbench.press("q"), "nothing else is open");
}

#[test]
fn going_to_an_angle_pauses() {
    for keys in ["space g 9 0 Enter", "space : 9 0 Enter"] {
        let mut session = four_bar(80, 24);
        session.press(keys);
        assert!(session.last_line().contains("90.00 deg"), "{keys}");
        session.pass(1.0);
        assert!(session.last_line().contains("90.00 deg"), "{keys}");
    }
}

/// Digits show views at once, so a count is typed behind `:`, with the key of the step or without it.
#[test]
fn counts_repeat_steps() {
    let mut session = four_bar(80, 24);
    for (typed, keys, at) in [
        ("10.", "", "110.00 deg"),
        ("3,", "", "95.00 deg"),
        ("2", "Down", "105.00 deg"),
    ] {
        session.press(":").type_in(typed).press(keys).press("Enter");
        assert!(
            session.last_line().contains(at),
            "{typed}: {}",
            session.last_line()
        );
    }
    session.press(":").type_in("9,").press("Enter");
    assert!(session.last_line().contains("60.00 deg"));
}

#[test]
fn first_key_replaces_a_proposed_name() {
    let mut session = four_bar(80, 24);
    assert!(
        session
            .press("W")
            .last_line()
            .contains("write to: four-bar.toml")
    );
    assert!(session.press("m").last_line().contains("write to: m "));
    let kept = session.press("Esc W Right 2").last_line();
    assert!(kept.contains("write to: four-bar.toml2 "), "{kept}");
    let shorter = session.press("Esc W Backspace m").last_line();
    assert!(shorter.contains("write to: four-bar.tomm "), "{shorter}");
}

#[test]
fn notices_disappear_after_three_seconds() {
    let mut session = four_bar(80, 24);
    let named = "names of points and links";
    assert!(session.press("i").last_line().contains(named));
    assert!(session.pass(2.9).last_line().contains(named));
    assert!(!session.pass(0.2).last_line().contains(named));
}

#[test]
fn commands_of_vi_save_open_and_quit() {
    let folder = folder("habits");
    let [own, other] = ["own.toml", "other.toml"].map(|name| folder.join(name));
    fs::write(&own, text("four-bar")).unwrap();
    let opened = open(text("four-bar"), Origin::File(own.clone()));
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    session.press("6 Down > :").type_in("w").press("Enter");
    let saved = fs::read_to_string(&own).unwrap();
    assert_ne!(saved, text("four-bar"));
    session
        .press("> :")
        .type_in(&format!("w {}", other.display()));
    session.press("Enter");
    assert_eq!(fs::read_to_string(&own).unwrap(), saved);
    assert_ne!(fs::read_to_string(&other).unwrap(), saved);
    session.press(":").type_in(&format!("e {}", own.display()));
    assert!(session.press("Enter").last_line().contains("own.toml "));
    session.press(":").type_in("e peaucellier").press("Enter");
    assert!(session.last_line().contains("peaucellier "));
    let gone = session.press(":").type_in("e nowhere.toml").press("Enter");
    assert!(
        gone.last_line().contains("nowhere.toml cannot be read"),
        "{}",
        gone.painted_text()
    );
    session.press(":").type_in(&format!("e {}", own.display()));
    session.press("Enter 6 Down < :").type_in("wq");
    assert!(!session.workbench.press("Enter"), "saved, and left");
    assert_ne!(fs::read_to_string(&own).unwrap(), saved);
}

#[test]
fn theme_is_switched_by_a_command() {
    let mut session = four_bar(80, 24);
    for theme in ["dark", "plain", "auto"] {
        session.press(":").type_in(&format!("theme {theme}"));
        let line = session.press("Enter").last_line();
        assert!(line.contains(&format!("theme: {theme}")), "{line}");
    }
}

/// Staged edits belong to the view of the scene: in another view, Esc ends what that view shows.
#[test]
fn esc_ends_only_what_the_view_shows() {
    let mut session = four_bar(80, 24);
    session.press("6 b Down >");
    assert!(
        session.painted_text().contains(">+"),
        "{}",
        session.painted_text()
    );
    session.press("1 D").type_in("press").press("Enter");
    assert!(session.last_line().contains("Esc ends the comparison"));
    assert!(
        session
            .press("Esc")
            .last_line()
            .contains("comparison ended")
    );
    assert!(
        session.press("6").painted_text().contains(">+"),
        "still staged"
    );
    session.press("Esc");
    assert!(!session.painted_text().contains(">+"));
}
