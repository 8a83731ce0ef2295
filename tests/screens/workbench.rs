//! Tests the workbench as a whole: opening, moving, help, the lengths view, and every size.

use crate::claims::{assert_shown, collapse_blanks};
use crate::screen::{SWINGING, Session, emulator, krank, made_up, masked, open, preset, timed};
use krank::drawing::Glyphs;
use krank::scene::presets;
use krank::tui::{Colours, Origin, Workbench};
use proptest::prelude::*;
use std::time::Duration;

/// The manual and the command line name the workbench's keys.
#[test]
fn manual_and_command_line_name_the_keys() {
    let manual = krank(&["help", "keys"]).0;
    let mut lines = manual.lines();
    let mut group = "";
    for (title, keys, help) in krank::tui::key_list() {
        if title != group {
            assert!(lines.any(|line| line == title), "{title}:\n{manual}");
            group = title;
        }
        let keys: Vec<_> = keys.split(' ').map(|key| format!("`{key}`")).collect();
        let line = lines.next().unwrap();
        let row = line.strip_prefix(&keys.join(" ")).map(str::trim);
        assert_eq!(row, Some(help), "{line}");
    }
    let help = krank(&["--help"]).0;
    let keys = help.split("Keys of the workbench:").nth(1).unwrap();
    let keys = keys.split("Examples:").next().unwrap();
    let known: Vec<_> = krank::tui::key_list().collect();
    let named = ["space", ".", ",", "r", "g", "2", "n", "t", "?", "q"];
    for key in named {
        assert!(keys.split_whitespace().any(|word| word == key), "{keys}");
        let mut all = known.iter().flat_map(|(_, keys, _)| keys.split(' '));
        assert!(all.any(|known| known == key), "{key}");
    }
}

fn four_bar(glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    timed(preset("four-bar"), glyphs, cols, rows)
}

#[test]
fn opening_screen_shows_lecture_four_bar() {
    let screen = four_bar(Glyphs::Braille, 80, 24).painted_text();
    insta::assert_snapshot!("four-bar-braille-80x24", masked(&screen));
    let screen = four_bar(Glyphs::Ascii, 40, 12).painted_text();
    insta::assert_snapshot!("four-bar-ascii-40x12", masked(&screen));
}

#[test]
fn slider_crank_is_shown_next_to_its_tables() {
    let mut session = timed(preset("slider-crank"), Glyphs::Line, 80, 24);
    insta::assert_snapshot!("slider-crank-line-80x24", masked(&session.painted_text()));
}

/// On a small screen, a table is shown from its heading on, and continues in a second one below.
#[test]
fn scrolling_shows_all_tables_on_small_screens() {
    let mut tiny = four_bar(Glyphs::Ascii, 40, 13);
    let scrolled = tiny.press("Tab Down Down").body();
    let lines = [
        "vector r [mm] theta [deg]",
        "r2 100.000 60.000",
        "r3 300.000 29.379*",
        "> r4 [250.000] 290.753*",
        "r1 400.000 180.000",
        "vector r' [mm/s] omega [rad/s]",
        "r2 0 15.0000",
        "r3 0 -3.9164*",
        "r4 0 3.0911* v",
    ];
    assert_shown(&scrolled, &lines);
}

/// The lengths view shows how errors of lengths change the values, and follows the driver.
#[test]
fn lengths_view_shows_sensitivities_and_follows_driver() {
    let mut session = four_bar(Glyphs::Ascii, 80, 25);
    let screen = session.press("e").painted_text();
    let lines = [
        "change for 1 mm in every length in one in which",
        "r3.angle [deg] 0.843 0.193 r4.length",
        "r4.omega [rad/s] 0.116 0.0427 r2.length",
        "r1.length [mm] 2.00 -1.00 A.x",
        "B.vx [mm/s] 13.0 -13.0 r2.length",
        "C.ay [mm/s^2] 409 96.2 r3.length",
        "r2.com.x [mm] 2.37 1.00 A.x v",
        "lengths four-bar 60.00 deg ok ? help",
    ];
    assert_shown(&screen, &lines);
    let elsewhere = session.press(".").painted_text();
    assert!(elsewhere.contains("65.00 deg"), "{elsewhere}");
    assert_ne!(elsewhere, session.press(".").painted_text());
    let mut tiny = four_bar(Glyphs::Ascii, 40, 12);
    insta::assert_snapshot!(
        "lengths-ascii-40x12",
        masked(&tiny.press("e PgDn").painted_text())
    );
    // A redundant linkage jams if a length is wrong, and the view says so.
    let mut jammed = timed(preset("triple-parallelogram"), Glyphs::Ascii, 80, 24);
    let screen = jammed.press("e").painted_text();
    assert!(screen.contains("no derivatives by the lengths"), "{screen}");
    // The view stays open for the next scene.
    let screen = jammed.press("n").painted_text();
    let is_asked = screen.contains("in every length") && !screen.contains("no derivatives");
    assert!(is_asked, "{screen}");
}

#[test]
fn help_shows_the_keys() {
    let mut session = four_bar(Glyphs::Braille, 80, 24);
    insta::assert_snapshot!(
        "help-braille-80x24",
        masked(&session.press("?").painted_text())
    );
    let mut tiny = four_bar(Glyphs::Ascii, 40, 12);
    insta::assert_snapshot!(
        "help-ascii-40x12",
        masked(&tiny.press("F1 PgDn").painted_text())
    );
    assert!(!tiny.press("Esc").painted_text().contains("Help"));
}

/// Every screen names the key of the help.
#[test]
fn help_key_is_named_in_every_view_and_size() {
    for preset in presets::all() {
        for (cols, rows) in [(40, 12), (60, 16), (80, 24)] {
            let opened = open(preset.text, Origin::Preset(preset.name.into()));
            let mut session = timed(opened, Glyphs::Ascii, cols, rows);
            for view in ["1", "2", "3", "4", "5 Esc", "6"] {
                // Esc clears the message why a view is empty.
                let line = session.press(view).last_line();
                assert!(line.contains("? help"), "{}: {line}", preset.name);
            }
            let line = session.press("?").last_line();
            assert!(line.contains("Esc back"), "{}: {line}", preset.name);
        }
    }
}

#[test]
fn truncated_text_ends_with_dots() {
    let mut session = timed(preset("stephenson-six-bar"), Glyphs::Ascii, 80, 24);
    let screen = session.painted_text();
    let title = screen.lines().nth(1).unwrap();
    assert!(
        title.starts_with(" Stephenson's six-bar, driven across its lo.. "),
        "{title}"
    );
    let mut narrow = timed(preset("offset-slider-crank"), Glyphs::Ascii, 40, 12);
    let line = narrow.last_line();
    assert!(
        line.starts_with(" motion  offset-..  60.00 deg ok"),
        "{line}"
    );
}

/// Regression test: a wide and low mechanism had its tables below, and a taller screen showed fewer
/// of their rows.
#[test]
fn tables_are_next_to_drawing_and_taller_screens_show_no_less() {
    for preset in presets::all() {
        let mut before = 0;
        for (cols, rows) in [
            (80, 24),
            (80, 40),
            (120, 40),
            (120, 60),
            (160, 60),
            (200, 60),
        ] {
            let opened = open(preset.text, Origin::Preset(preset.name.into()));
            let screen = timed(opened, Glyphs::Ascii, cols, rows).painted_text();
            let nearby = screen.lines().nth(3).unwrap();
            let tables = nearby.rsplit('|').next().unwrap();
            assert!(
                nearby.contains('|') && !tables.trim().is_empty(),
                "{screen}"
            );
            let now = crate::claims::figures(&screen).len();
            assert!(
                now >= before || cols != 80,
                "{}: {before}, {now}\n{screen}",
                preset.name
            );
            before = now;
        }
    }
}

#[test]
fn preset_keys_wrap_around() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    for preset in presets::all().iter().skip(1).chain(presets::all().first()) {
        let line = session.press("n").last_line();
        assert!(line.contains(preset.name), "{line}");
    }
    let last = presets::all().last().unwrap().name;
    assert!(session.press("p").last_line().contains(last));
}

#[test]
fn presets_play_at_every_size_and_ascii_stays_seven_bit() {
    let sizes = [
        (40, 12),
        (80, 24),
        (200, 60),
        (41, 30),
        (300, 12),
        (10, 3),
        (1, 1),
    ];
    for preset in presets::all() {
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            let opened = open(preset.text, Origin::Preset(preset.name.into()));
            let workbench = Workbench::new(opened, glyphs, Colours::None, 80, 24);
            let mut workbench = workbench.timed_by(made_up);
            workbench.press("space");
            for (cols, rows) in sizes {
                workbench.resize(cols, rows);
                for view in ["1", "2", "e", "3", "4", "5", "6", "?", "PgDn", "Esc"] {
                    workbench.press(view);
                    workbench.pass(Duration::from_millis(130));
                    let frame = workbench.paint();
                    let seven_bits = frame.iter().all(|byte| *byte < 0x80);
                    assert!(glyphs != Glyphs::Ascii || seven_bits, "{}", preset.name);
                }
            }
        }
    }
}

#[test]
fn tiny_screens_state_the_required_size() {
    for (cols, rows) in [(20, 6), (39, 12), (80, 11)] {
        let mut session = four_bar(Glyphs::Ascii, cols, rows);
        assert_shown(
            &session.painted_text(),
            &["four-bar", "60.00 deg", "ok", "40 x 12 shows more"],
        );
        assert_shown(&session.press(".").painted_text(), &["65.00 deg"]);
    }
    for (cols, rows) in [(19, 6), (20, 5)] {
        let mut session = four_bar(Glyphs::Ascii, cols, rows);
        assert_eq!(session.painted_text().trim(), "krank needs 20 x 6");
    }
    let narrow = four_bar(Glyphs::Ascii, 12, 6).painted_text();
    assert_eq!(collapse_blanks(&narrow).trim(), "krank needs 20 x 6");
    four_bar(Glyphs::Ascii, 1, 1).painted_text();
}

#[test]
fn control_characters_in_titles_are_replaced() {
    let hostile = SWINGING.replace("Swinging crank", "A\\u001B[2J\\u202Eb\\u4E2D\\u00E9");
    let title = |glyphs| {
        let opened = open(&hostile, Origin::File("\u{1b}[2J.toml".into()));
        let screen = timed(opened, glyphs, 80, 24).painted_text();
        let line = screen.lines().nth(1).unwrap().to_owned();
        line.split_whitespace().next().unwrap().to_owned()
    };
    assert_eq!(title(Glyphs::Ascii), "A?[2J?b??");
    assert_eq!(title(Glyphs::Line), "A?[2J?b?\u{e9}");
    assert_eq!(title(Glyphs::Braille), "A?[2J?b?\u{e9}");
}

#[test]
fn frames_are_small_and_empty_without_changes() {
    for (colours, maximum) in [(Colours::Sixteen, 900), (Colours::None, 700)] {
        let mut workbench = Workbench::new(preset("four-bar"), Glyphs::Braille, colours, 80, 24);
        workbench.paint();
        assert!(workbench.paint().is_empty());
        workbench.press("space");
        let mut costs = Vec::new();
        for _ in 0..120 {
            workbench.pass(Duration::from_secs_f64(4.0 / 120.0));
            costs.push(workbench.paint().len());
        }
        costs.sort_unstable();
        assert!(
            costs[60] <= maximum,
            "{colours:?}: median {} bytes",
            costs[60]
        );
    }
}

/// An action on the workbench.
#[derive(Clone, Debug)]
enum TestAction {
    Press(&'static str),
    Pass(u16),
    Resize(u16, u16),
}

fn actions() -> impl Strategy<Value = Vec<TestAction>> {
    let keys = [
        "space",
        ",",
        ".",
        "[",
        "]",
        "-",
        "+",
        "r",
        "g",
        "Home",
        "n",
        "p",
        "t",
        "Tab",
        "1",
        "2",
        "4",
        "e",
        "Up",
        "Down",
        "PgUp",
        "PgDn",
        "?",
        "Esc",
        "3",
        "0",
        "9",
        "e",
        "Enter",
        "a",
        "Backspace",
        "Ctrl-U",
    ];
    let action = prop_oneof![
        8 => prop::sample::select(keys.to_vec()).prop_map(TestAction::Press),
        2 => (0_u16..9000).prop_map(TestAction::Pass),
        1 => (1_u16..140, 1_u16..50).prop_map(|(cols, rows)| TestAction::Resize(cols, rows)),
    ];
    prop::collection::vec(action, 1..60)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// After any actions, the incremental frames add up to a full repaint.
    #[test]
    fn random_actions_leave_screen_equal_to_full_repaint(actions in actions(), preset in 0_usize..19) {
        let preset = &presets::all()[preset % presets::all().len()];
        let opened = open(preset.text, Origin::Preset(preset.name.into()));
        let mut session = timed(opened, Glyphs::Ascii, 80, 24);
        for action in actions {
            match action {
                TestAction::Press(key) => {
                    session.workbench.press(key);
                }
                TestAction::Pass(ms) => session.workbench.pass(Duration::from_millis(ms.into())),
                TestAction::Resize(cols, rows) => {
                    session.workbench.resize(cols, rows);
                    session.terminal = emulator(cols, rows);
                }
            }
            session.paint();
        }
        let shown = session.painted_text();
        session.workbench.forget();
        let size = session.terminal.screen().size();
        session.terminal = emulator(size.1.get(), size.0.get());
        prop_assert_eq!(shown, session.painted_text());
    }
}

/// A window may shrink and grow again at once: the size is unchanged, but the terminal has lost its
/// content.
#[test]
fn resize_to_same_size_repaints_everything() {
    for (cols, rows) in [(80, 24), (11, 1)] {
        let mut session = four_bar(Glyphs::Ascii, cols, rows);
        let shown = session.painted_text();
        session.workbench.resize(cols, rows);
        session.terminal = emulator(cols, rows);
        assert_eq!(session.painted_text(), shown);
    }
}
