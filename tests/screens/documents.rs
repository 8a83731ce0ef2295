//! Tests printed screens: by the program, in the README and in the manual.

use crate::screen::{krank, made_up, masked, preset};
use krank::drawing::Glyphs;
use krank::tui::{Colours, Workbench};

const README: &str = include_str!("../../README.md");
const VIEWS: &str = include_str!("../../src/manual/english/views.md");
/// The chapter on views in Turkish.
const GORUNUMLER: &str = include_str!("../../src/manual/turkish/views.md");

/// The printed screen equals the opening screen; printing needs no terminal and no environment.
#[test]
fn print_option_prints_opening_screen() {
    let opened =
        |name, cols, rows| Workbench::new(preset(name), Glyphs::Ascii, Colours::None, cols, rows);
    let printed = krank(&["four-bar", "--print"]);
    assert_eq!(printed, (opened("four-bar", 80, 24).text(), Some(0)));
    let mut tables = opened("press", 40, 12);
    tables.press("g 9 0 Enter 2");
    let args = [
        "press", "--print", "--at", "90", "--view", "tables", "--size", "40x12",
    ];
    assert_eq!(krank(&args), (tables.text(), Some(0)));
    let (tiny, code) = krank(&["press", "--print", "--size", "20x3"]);
    assert_eq!((tiny.as_str(), code), ("krank needs 20 x 6\n\n\n", Some(0)));
    for args in [
        &["--print", "--size", "80"][..],
        &["--print", "--size", "0x24"],
        &["--size", "80x24"],
    ] {
        assert_eq!(krank(args), (String::new(), Some(2)), "{args:?}");
    }
}

/// Returns the screen of a view as printed by `krank --print`.
fn printed(key: &str, rows: u16) -> String {
    let mut workbench = Workbench::new(preset("four-bar"), Glyphs::Ascii, Colours::None, 80, rows)
        .timed_by(made_up);
    workbench.press(key);
    workbench.text()
}

/// The manual shows a screen of every view and the README the first one; all match the program.
#[test]
fn manual_screens_match_program() {
    for (text, key, rows) in [
        (README, "1", 24),
        (VIEWS, "2", 24),
        (VIEWS, "3", 24),
        (VIEWS, "6", 22),
        (VIEWS, "7", 20),
        (VIEWS, "e", 14),
    ] {
        let screen = printed(key, rows);
        let block = format!("```txt\n{}\n```", screen.trim_end());
        assert!(
            masked(text).contains(&masked(&block)),
            "there should be for {key}\n{screen}"
        );
    }
    // Times differ between machines; names and order of the methods do not.
    let mut workbench = Workbench::new(preset("four-bar"), Glyphs::Ascii, Colours::None, 80, 25);
    workbench.press("4");
    let screen = workbench.text();
    assert_method_screen(VIEWS, "error over time", &screen);
}

/// The chapters show one screen of each view but the first, which the README shows; other tests compare the screens of
/// the forces and of the motor.
#[test]
fn no_screen_is_left_out_of_the_comparison() {
    let screens = |text: &str| text.matches("```txt\n").count();
    assert_eq!([README, VIEWS, GORUNUMLER].map(screens), [1, 8, 8]);
}

/// Asserts that the text has exactly one screen of the accuracy view, and that `screen` contains
/// all its methods.
fn assert_method_screen(text: &str, title: &str, screen: &str) {
    let blocks = text.split("```txt\n").skip(1);
    let shown = blocks.map(|block| block.split("```").next().unwrap());
    let shown = shown.filter(|block| block.contains(title));
    let [shown] = shown.collect::<Vec<_>>()[..] else {
        panic!("the manual has other screens of the accuracy view than one");
    };
    let mut methods = 0;
    for line in shown.lines().skip(2).filter_map(|line| line.get(41..)) {
        // A row has a letter, a mark, the method and its time.
        let method = line
            .get(2..)
            .unwrap_or_default()
            .split("  ")
            .next()
            .unwrap();
        if line.starts_with(|c: char| c.is_ascii_lowercase()) {
            assert!(screen.contains(method), "{method:?} is not in\n{screen}");
            methods += 1;
        }
    }
    assert!(methods >= 15, "{shown}");
}

/// The Turkish screens come from separate processes: this process uses English.
#[test]
fn turkish_manual_screens_match_program() {
    let printed = |scene: &str, view: &str, size: &str| -> String {
        let (screen, code) = krank(&[
            scene,
            "--print",
            "--view",
            view,
            "--size",
            size,
            "--language",
            "tr",
        ]);
        assert_eq!(code, Some(0), "{screen}");
        screen
    };
    for (scene, view, size) in [
        ("four-bar", "tables", "80x24"),
        ("four-bar", "plots", "80x24"),
        ("four-bar-load", "forces", "80x17"),
        ("four-bar", "scene", "80x22"),
        ("four-bar", "working", "80x20"),
        ("press-ram", "motor", "80x18"),
        ("four-bar", "lengths", "80x14"),
    ] {
        let screen = printed(scene, view, size);
        let block = format!("```txt\n{}\n```", screen.trim_end());
        assert!(
            masked(GORUNUMLER).contains(&masked(&block)),
            "there should be for {view}\n{screen}"
        );
    }
    // Integrating a full turn would take a minute; for a double-rocker the methods are listed
    // without being tried.
    let (methods, _) = krank(&[
        "accuracy",
        "double-rocker",
        "--positions",
        "1",
        "--language",
        "tr",
    ]);
    assert_method_screen(GORUNUMLER, "hata yatay: sure", &methods);
}
