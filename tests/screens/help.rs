//! Tests the help and its search.

use crate::screen::{Session, emulator, four_bar, preset};
use krank::drawing::Glyphs;
use krank::tui::{Colours, Config, Workbench};
use std::collections::{BTreeSet, HashSet};

#[test]
fn help_search_matches_all_words() {
    let mut session = four_bar(80, 24);
    let screen = session.press("? /").type_in("arrow vel").painted_text();
    assert!(screen.contains("Help /arrow vel"), "{screen}");
    assert!(screen.contains("velocity arrows"), "{screen}");
    assert!(!screen.contains("acceleration   "), "{screen}");
    let line = session.last_line();
    assert!(line.ends_with("Esc all keys  Enter keep"), "{line}");
    // Typed characters are not interpreted as keys.
    assert!(
        session
            .type_in("q?")
            .painted_text()
            .contains("no key does that")
    );
    assert!(session.painted_text().contains("Esc shows all keys"));
    // Enter keeps the filter, and keys work again.
    session.press("Ctrl-U").type_in("quit from").press("Enter");
    let screen = session.painted_text();
    assert!(screen.contains("quit from anywhere"), "{screen}");
    assert!(session.last_line().contains("/ search"));
    // Esc first shows all keys again, then closes the help.
    let screen = session.press("Esc").painted_text();
    assert!(screen.contains("play or pause"), "{screen}");
    assert!(!session.press("Esc").painted_text().contains("Help"));
}

/// Returns the names and texts of the topics of `krank help`, for a terminal of 80 columns.
fn topics() -> Vec<(String, String)> {
    let help = |topic: &[&str]| {
        let mut program = std::process::Command::new(env!("CARGO_BIN_EXE_krank"));
        let output = program.arg("help").args(topic).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let contents = help(&[]);
    let named = contents.lines().skip(2).take_while(|line| !line.is_empty());
    let names = named.map(|line| line.split(' ').next().unwrap());
    names.map(|name| (name.to_owned(), help(&[name]))).collect()
}

/// The first page of the help lists the keys, and the pages after it have the text of `krank help`.
#[test]
fn help_contains_all_manual_topics_after_the_keys() {
    let mut session = four_bar(80, 24);
    let keys = session.press("?").painted_text();
    assert!(session.last_line().contains("Tab manual"), "{keys}");
    for (name, text) in topics() {
        let mut seen = session.press("Tab").painted_text();
        assert!(seen.contains(&format!(" Help: {name} ")), "{seen}");
        for _ in 0..80 {
            seen += &session.press("PgDn").painted_text();
        }
        let words: HashSet<&str> = seen.split_whitespace().collect();
        let seen: HashSet<&str> = seen.lines().collect();
        for line in text.lines() {
            // An error message may be wider than the screen, which then wraps it.
            let is_there = match line.chars().count() > 80 {
                true => line.split_whitespace().all(|word| words.contains(word)),
                false => seen.contains(line.trim_end()),
            };
            assert!(is_there, "{name}: {line}");
        }
    }
    assert_eq!(session.press("Tab").painted_text(), keys);
    let screen = session.press("Left").painted_text();
    assert!(screen.contains("Help: glossary"), "{screen}");
    assert!(!session.press("Esc").painted_text().contains("Help"));
}

#[test]
fn manual_search_covers_all_topics() {
    let mut session = four_bar(80, 24);
    let screen = session
        .press("? Tab /")
        .type_in("SECOND dyad")
        .painted_text();
    assert!(
        screen.contains("Help: tutorial  1/17 /SECOND dyad"),
        "{screen}"
    );
    assert!(
        screen.lines().nth(2).unwrap().starts_with("A second dyad"),
        "{screen}"
    );
    let line = session.last_line();
    assert!(line.ends_with("Esc back  Enter next"), "{line}");
    // The word is only in other topics: Enter visits all of its hits and wraps around.
    let screen = session
        .press("Ctrl-U")
        .type_in("fluctuation")
        .painted_text();
    assert!(screen.contains("Help: scene"), "{screen}");
    let first = screen;
    let mut places = 0;
    let mut topics = BTreeSet::new();
    loop {
        let screen = session.press("Enter").painted_text();
        assert!(
            screen
                .lines()
                .skip(2)
                .any(|line| line.contains("fluctuation"))
        );
        topics.insert(screen.lines().nth(1).unwrap().to_owned());
        places += 1;
        if screen == first {
            break;
        }
    }
    assert!(places > 1 && topics.len() > 1, "{topics:?}");
    // Typed characters are not interpreted as keys, and a search without hits reports that.
    let screen = session.type_in("q?").painted_text();
    assert!(
        screen.lines().nth(1).unwrap().contains(" no hits "),
        "{screen}"
    );
    // Esc ends the search at its place, then closes the help.
    let screen = session.press("Esc").painted_text();
    assert!(screen.contains("Help: scene"), "{screen}");
    assert!(!session.press("Esc").painted_text().contains("Help"));
}

/// Regression test: the search looked at single lines and missed these words at 80 columns.
#[test]
fn search_finds_phrases_across_line_breaks() {
    for cols in [40, 60, 80, 120] {
        let mut session = four_bar(cols, 24);
        session.press("? Tab /").type_in("structure alone decides");
        let screen = session.painted_text();
        assert!(screen.contains("Help: limits"), "{screen}");
    }
}

/// Counts the rows of the view with a highlight.
fn marked(session: &Session) -> usize {
    let screen = session.terminal.screen();
    let (rows, columns) = screen.size();
    let is_marked = |row: u16| {
        let cells = (0..columns.get()).filter_map(|column| screen.cell(row, column));
        cells.into_iter().any(|cell| cell.inverse())
    };
    (1..rows.get() - 1).filter(|row| is_marked(*row)).count()
}

/// Regression test: typing jumped to the beginning of the topic, and Esc stayed there.
#[test]
fn search_starts_at_reading_position_and_esc_restores_it() {
    let mut session = four_bar(80, 24);
    let place = session.press("? Tab PgDn PgDn").painted_text();
    let before = |screen: &str, line: &str| screen.lines().any(|seen| seen == line);
    let last = place.lines().nth(20).unwrap().to_owned();
    // The topic begins with this word, and contains it again further on.
    let found = session.press("/").type_in("crank").painted_text();
    assert!(found.contains("Help: tutorial"), "{found}");
    assert!(before(&place, found.lines().nth(2).unwrap()), "{found}");
    assert_eq!(marked(&session), 2, "the caret and the line: {found}");
    // Without hits, and after deleting characters, the position is restored.
    let nowhere = session.type_in("zzz").painted_text();
    assert!(nowhere.contains(" no hits "), "{nowhere}");
    assert!(before(&nowhere, &last), "{nowhere}");
    let again = session
        .press("Backspace Backspace Backspace")
        .painted_text();
    assert_eq!(again, found);
    assert_eq!(session.press("Ctrl-U Enter").painted_text(), place);
    assert_eq!(
        session
            .press("/")
            .type_in("fluctuation")
            .press("Esc")
            .painted_text(),
        place
    );
    assert_eq!(marked(&session), 0);
    // A position reached by Enter or by scrolling after it is kept.
    let next = session
        .press("/")
        .type_in("fluctuation")
        .press("Enter Down")
        .painted_text();
    let stayed = session.press("Esc").painted_text();
    let text = |screen: &str| -> Vec<String> {
        let lines = screen.lines().skip(2).take(21);
        lines.map(str::to_owned).collect()
    };
    assert_eq!(text(&stayed), text(&next));
    assert_ne!(text(&stayed), text(&place));
    assert_eq!(marked(&session), 0);
}

/// Regression test: at 40 columns, wide lines were cut without any sign.
#[test]
fn topics_are_complete_on_the_smallest_screen() {
    let mut session = four_bar(40, 12);
    let keys = session.press("?").painted_text();
    assert!(keys.contains(" Tab manual "), "{keys}");
    let mut seen = session.press("Tab").painted_text();
    let heading = |screen: &str| screen.lines().nth(1).unwrap().to_owned();
    assert!(heading(&seen).ends_with("  v"), "{seen}");
    assert!(heading(&session.press("Down").painted_text()).ends_with(" ^v"));
    for _ in 0..80 {
        seen += &session.press("PgDn").painted_text();
    }
    assert!(heading(&session.painted_text()).ends_with(" ^"));
    assert!(seen.contains("-o output.csv"), "{seen}");
}

/// Hits are highlighted by line, and a narrow screen breaks lines elsewhere.
#[test]
fn search_hits_stay_visible_after_resize() {
    for (cols, rows) in [(40, 12), (80, 24), (200, 60)] {
        let mut session = four_bar(80, 24);
        session.press("? Tab Tab /").type_in("stiffness");
        session.workbench.resize(cols, rows);
        session.terminal = emulator(cols, rows);
        let screen = session.painted_text();
        assert!(screen.contains("Help: scene"), "{screen}");
        let screen = session.press("Enter").painted_text();
        assert!(
            screen
                .lines()
                .skip(2)
                .any(|line| line.contains("stiffness")),
            "{screen}"
        );
    }
}

#[test]
fn help_lists_keys_of_current_view_first() {
    for (view, title, help) in [
        ("1", "What the motion view shows", "velocity arrows"),
        ("2", "In the tables", "show in the motion view"),
        ("3", "In the plots", "mark the extrema"),
        ("4", "In the accuracy view", "step through a method"),
        ("6", "In the scene view", "larger increment"),
        ("7", "The motion", "play or pause"),
    ] {
        let screen = four_bar(40, 12).press(view).press("?").painted_text();
        let first = screen.lines().nth(2).unwrap();
        assert!(first.starts_with(&format!("| {title} ")), "{screen}");
        assert!(screen.contains(&help[..12]), "{screen}");
    }
}

/// Scrolling reaches every key at every size.
#[test]
fn scrolling_reaches_every_key_of_the_help() {
    for (cols, rows) in [(40, 12), (80, 24), (120, 40), (200, 60)] {
        let mut session = four_bar(cols, rows);
        let mut seen = session.press("?").painted_text();
        for _ in 0..80 {
            seen += &session.press("PgDn").painted_text();
        }
        for (title, _, help) in krank::tui::key_list() {
            assert!(seen.contains(title), "{cols} x {rows}: {title}");
            assert!(seen.contains(help), "{cols} x {rows}: {help}");
        }
    }
}

/// The help, the hints and the messages name the configured keys.
#[test]
fn configured_keys_appear_in_help_hints_and_messages() {
    let text = "[keys]\nhelp = \"F9\"\nplay = \"F5\"\nsave = \"F6\"\nnext = []\nstep-back = []\n";
    let config = Config::parse(text, "config.toml").unwrap();
    let workbench = Workbench::new(preset("four-bar"), Glyphs::Ascii, Colours::Sixteen, 80, 24);
    let mut session = Session::on(workbench.configured(&config), 80, 24);
    let line = session.last_line();
    assert!(line.contains("F9 help  F5 play  q quit"), "{line}");
    assert!(session.press("F5").last_line().contains("F5 pause"));
    session.press("F5");
    let before = session.body();
    assert_eq!(session.press("space ? n , Left h").body(), before);
    let line = session.last_line();
    assert!(
        line.contains("h does nothing here; F9 lists the keys"),
        "{line}"
    );
    let line = session.press("a Enter").last_line();
    assert!(line.contains("C=- now; F6 saves it"), "{line}");
    let help = session.press("F9 /").type_in("preset").painted_text();
    assert!(!help.contains("the next preset"), "{help}");
    let topic = session
        .press("Tab Tab Tab Tab Tab /")
        .type_in("pause")
        .painted_text();
    assert!(topic.contains("Help: keys"), "{topic}");
    assert!(
        topic.contains("`F5`") && !topic.contains("`space`"),
        "{topic}"
    );
    let tour = session.press("Esc Esc I Enter").painted_text();
    assert!(tour.contains("(no key) step"), "{tour}");
}

/// The manual's example of a configuration is valid, in both languages.
#[test]
fn example_configuration_of_the_manual_parses() {
    for keys in [
        include_str!("../../src/manual/english/keys.md"),
        include_str!("../../src/manual/turkish/keys.md"),
    ] {
        let block = keys
            .split("```toml\n")
            .find(|block| block.starts_with("glyphs"));
        let text = block.unwrap().split("```").next().unwrap();
        let config = Config::parse(text, "config.toml").unwrap();
        assert_eq!(config.glyphs, Some(Glyphs::Ascii));
        assert!(!config.tour);
    }
}
