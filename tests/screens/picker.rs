//! Tests the scene picker, driven by keys: presets, files, and folders with arbitrary content.

use crate::claims::{assert_shown, collapse_blanks, pane};
use crate::screen::{SCREENS, Session, folder, open, text};
use krank::drawing::Glyphs;
use krank::scene::MAX_FILE_SIZE;
use krank::tui::Origin;
use std::fs;
use std::time::Duration;

/// Opens the four-bar as a file in a folder with some more scenes.
fn open_in_folder(name: &str, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    let folder = folder(name).join("scenes");
    fs::create_dir(&folder).unwrap();
    fs::create_dir(folder.join("old")).unwrap();
    for (file, preset) in [("mine.toml", "four-bar"), ("Leg.toml", "klann-leg")] {
        fs::write(folder.join(file), text(preset)).unwrap();
    }
    fs::write(folder.join("old/lift.toml"), text("scissor-lift")).unwrap();
    fs::write(folder.join("wrong.toml"), "[ground]\nA = [0, 0, 0]\n").unwrap();
    fs::write(folder.join("notes.txt"), "not a scene").unwrap();
    let origin = Origin::File(folder.join("mine.toml"));
    Session::new(open(text("four-bar"), origin), glyphs, cols, rows)
}

/// Masks the path of the folder, which differs between machines.
fn masked(screen: &str) -> String {
    const END: &str = "/scenes";
    let line = |line: &str| match line.find(END) {
        // The text next to it keeps its columns.
        Some(at) => {
            let (path, rest) = line.split_at(at + END.len());
            let space = path.chars().count().saturating_sub(2);
            format!(" ~{END:space$}{rest}").trim_end().to_owned() + "\n"
        }
        None => format!("{line}\n"),
    };
    screen.lines().map(line).collect()
}

#[test]
fn picker_lists_presets_and_files_with_preview() {
    for (name, glyphs, cols, rows) in SCREENS {
        let mut session = open_in_folder(name, glyphs, cols, rows);
        let screen = masked(&session.press("o").painted_text());
        if ["ascii-80x24", "braille-120x40", "ascii-40x12"].contains(&name) {
            insta::assert_snapshot!(format!("picker-{name}"), screen);
        }
        // The list, and the text below the drawing, are the same in all glyphs.
        let mut plain = open_in_folder(&format!("{name}-plain"), Glyphs::Ascii, cols, rows);
        let plain = masked(&plain.press("o").painted_text());
        assert_eq!(pane(&screen, false), pane(&plain, false));
        let words = |screen: &str| {
            let text = pane(screen, true);
            text.lines()
                .skip_while(|line| !line.contains("3 links"))
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        assert_eq!(words(&screen), words(&plain));
        assert!(cols == 40 || words(&plain).len() >= 4, "{plain}");
    }
}

#[test]
fn invalid_file_explains_its_error() {
    for (cols, rows) in [(80, 24), (40, 12)] {
        let name = format!("fault-{cols}x{rows}");
        let mut session = open_in_folder(&name, Glyphs::Ascii, cols, rows);
        let screen = session.press("o Down").painted_text();
        assert_shown(
            &screen,
            &["mine.toml", "> wrong.toml", "presets", "four-bar", "press"],
        );
        if cols == 80 {
            let why = "wrong.toml cannot be opened the scene has no links: nothing moves add, for example: \
                       [links] r2 = { from = \"A\", to = \"B\", length = 100 } 1 more below it";
            assert_eq!(collapse_blanks(&pane(&screen, true)), why);
            let line = " open  the scene has no links: nothing moves  Enter open  Esc back";
            assert_eq!(session.last_line(), line);
        } else {
            assert_eq!(
                session.last_line(),
                " open  the scene has no links: nothin.."
            );
        }
        // Enter repeats the error, and the list stays open.
        let line = session.press("Enter").last_line();
        assert!(line.starts_with(" open "), "{line}");
        assert!(session.press("Esc").last_line().contains("mine.toml"));
    }
}

#[test]
fn typing_filters_the_list_immediately() {
    let mut session = open_in_folder("search", Glyphs::Ascii, 80, 24);
    let screen = session.press("o").type_in("ram").painted_text();
    let found = "presets > press-ram parallelogram antiparallelogram triple-parallelogram";
    let list: Vec<&str> = screen.lines().skip(1).take(22).collect();
    assert_eq!(collapse_blanks(&pane(&list.join("\n"), false)), found);
    let lines = [
        "Open a scene search: ram 4 of 44",
        "| Press with a ram",
        "| 5 links, 1 slide, unit mm; r2 turns fully",
        "| without turning, so the tool below its pin",
        "open Press with a ram Enter open Esc back",
    ];
    assert_shown(&screen, &lines);
    // The filter matches titles as well as names, word by word, and letters are never keys.
    let screen = session
        .press("Ctrl-U")
        .type_in("LEG")
        .press("space")
        .type_in("walk")
        .painted_text();
    assert!(
        screen.contains("search: LEG walk") && screen.contains("2 of 44"),
        "{screen}"
    );
    assert!(screen.contains("> jansen-leg"), "{screen}");
    assert!(
        session
            .press("Backspace")
            .painted_text()
            .contains("search: LEG wal ")
    );
    let nothing = session.type_in("q?").painted_text();
    assert!(nothing.contains("no match; Ctrl-U"), "{nothing}");
    assert!(nothing.contains("0 of 44"), "{nothing}");
    // The list is empty, and Enter does nothing.
    assert_eq!(
        session.press("Enter Down Up PgDn Right").painted_text(),
        nothing
    );
    assert!(session.press("Ctrl-U").painted_text().contains("44 of 44"));
}

#[test]
fn browsing_changes_nothing_until_enter_opens() {
    let mut session = open_in_folder("esc", Glyphs::Ascii, 80, 24);
    let before = session.press("2 . . ]").painted_text();
    session
        .press("o Down Up PgDn End Home Left Left")
        .type_in("leg");
    assert_eq!(session.press("Esc").painted_text(), before);
    let opened = session
        .press("o")
        .type_in("jansen")
        .press("Enter")
        .painted_text();
    assert!(session.last_line().contains("jansen-leg"), "{opened}");
}

#[test]
fn files_open_and_folders_can_be_entered_and_left() {
    let mut session = open_in_folder("walk", Glyphs::Ascii, 80, 24);
    // The cursor starts at the open file.
    assert!(session.press("o").painted_text().contains("> mine.toml"));
    let inside = session.press("Up Up Enter").painted_text();
    assert!(
        inside.contains("> lift.toml") && inside.contains("| Scissor lift"),
        "{inside}"
    );
    // After leaving a folder, the cursor is on it.
    let outside = session.press("Left").painted_text();
    assert!(
        outside.contains("> old/") && outside.contains("| lift.toml"),
        "{outside}"
    );
    let again = session.press("Right").painted_text();
    assert_eq!(again, inside);
    let outside = session.press("Home Enter").painted_text();
    assert!(outside.contains("> old/"), "{outside}");
    let opened = session.press("Right Enter").painted_text();
    assert!(opened.contains("\n Scissor lift "), "{opened}");
    assert!(opened.contains("lift.toml"), "{opened}");
    // The picker now lists the file's own folder.
    assert!(session.press("o").painted_text().contains("> lift.toml"));
}

#[test]
fn playback_pauses_during_picker_and_resumes() {
    let mut session = open_in_folder("playing", Glyphs::Ascii, 80, 24);
    session.press("space");
    session.workbench.pass(Duration::from_millis(500));
    let before = session.painted_text();
    session.press("o");
    session.workbench.pass(Duration::from_secs(100));
    assert_eq!(session.press("Esc").painted_text(), before);
    session.workbench.pass(Duration::from_millis(500));
    assert!(
        session.last_line().contains("150.00 deg"),
        "{}",
        session.last_line()
    );
}

/// All entries of a folder are listed and described; none of them acts on the terminal or blocks
/// the user.
#[test]
fn hostile_folders_are_listed_without_harm() {
    use std::os::unix::ffi::OsStrExt;
    use std::os::unix::fs::symlink;
    let folder = folder("nasty");
    let put = |name: &str, text: &[u8]| fs::write(folder.join(name), text).unwrap();
    put("empty.toml", b"");
    put(
        "escape\u{1b}[2J\n\u{202e}.toml",
        text("four-bar").as_bytes(),
    );
    put("huge.toml", &vec![b'#'; MAX_FILE_SIZE + 1]);
    put("large.toml", &vec![b'#'; MAX_FILE_SIZE]);
    put("latin.toml", b"name = \"\xe4\"");
    put("nought.toml", &[0; 64]);
    let raw = std::ffi::OsStr::from_bytes(b"raw\xff\xfe.toml");
    fs::write(folder.join(raw), text("press")).unwrap();
    fs::create_dir(folder.join("folder.toml")).unwrap();
    symlink(folder.join("nowhere"), folder.join("dangling.toml")).unwrap();
    symlink(folder.join("loop.toml"), folder.join("loop.toml")).unwrap();
    symlink("/dev/zero", folder.join("zero.toml")).unwrap();
    symlink("/dev/tty", folder.join("tty.toml")).unwrap();
    symlink(&folder, folder.join("self")).unwrap();
    let pipe = folder.join("pipe.toml");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.unwrap().success());
    let origin = Origin::File(folder.join("empty.toml"));
    let mut session = Session::new(open(text("four-bar"), origin), Glyphs::Braille, 80, 24);
    session.press("o");
    let cases = [
        ("dangling", "No such file"),
        ("empty.toml", "cannot be opened"),
        ("escape", "Four-bar crank-rocker"),
        ("folder.toml/", "no scene file in it"),
        ("huge", "too large: a scene may have at most"),
        ("large", "1024 KiB: too large for a preview"),
        ("latin", "the file is not UTF-8"),
        ("loop", "cannot be read"),
        ("nought", "cannot be opened"),
        ("pipe", "it is a pipe, not a file"),
        ("raw", "Press of two four-bars"),
        ("self", "folder.toml/"),
        ("tty", "it is a device, not a file"),
        ("zero", "it is a device, not a file"),
    ];
    for (name, message) in cases {
        let screen = session.press("Ctrl-U").type_in(name).painted_text();
        assert!(screen.contains(message), "{name}:\n{screen}");
        assert!(
            !screen
                .chars()
                .any(|c| c != '\n' && krank::scene::is_harmful(c)),
            "{screen}"
        );
    }
    // Enter shows the error in the last line, and the list stays open.
    for name in [
        "dangling", "loop", "pipe", "tty", "zero", "huge", "large", "nought",
    ] {
        let line = session
            .press("Ctrl-U")
            .type_in(name)
            .press("Enter")
            .last_line();
        assert!(line.starts_with(" open "), "{line}");
        assert!(line.len() > 20, "{line}");
    }
    // Scrolls through the whole list.
    session.press("Ctrl-U Home");
    for _ in 0..40 {
        let screen = session.press("Down").painted_text();
        assert!(
            !screen
                .chars()
                .any(|c| c != '\n' && krank::scene::is_harmful(c)),
            "{screen}"
        );
    }
}

#[test]
fn unreadable_folder_is_reported_and_can_be_left() {
    let folder = folder("gone");
    let inner = folder.join("inner");
    fs::create_dir(&inner).unwrap();
    let origin = Origin::File(inner.join("mine.toml"));
    let mut session = Session::new(open(text("four-bar"), origin), Glyphs::Ascii, 80, 24);
    let empty = session.press("o").painted_text();
    assert!(empty.contains("no scene file here"), "{empty}");
    // The cursor is on the first preset, with its preview.
    assert!(empty.contains("> four-bar"), "{empty}");
    fs::remove_dir(&inner).unwrap();
    let gone = session.press("Esc o").painted_text();
    assert!(gone.contains("cannot be read: No such"), "{gone}");
    let left = session.press("Left").painted_text();
    assert!(left.contains("/gone"), "{left}");
    assert!(!left.contains("cannot be read"), "{left}");
}

#[test]
fn ten_thousand_files_are_listed_and_searched() {
    let folder = folder("many");
    for n in 0..10_000 {
        fs::write(folder.join(format!("scene-{n:04}.toml")), "").unwrap();
    }
    let origin = Origin::File(folder.join("scene-5000.toml"));
    let mut session = Session::new(open(text("four-bar"), origin), Glyphs::Ascii, 80, 24);
    let screen = session.press("o").painted_text();
    assert!(
        screen.contains("> scene-5000.toml") && screen.contains("10040 of 10040"),
        "{screen}"
    );
    assert!(
        session
            .press("Down")
            .painted_text()
            .contains("> scene-5001.toml")
    );
    assert!(session.press("End").painted_text().contains("> excavator"));
    assert!(session.press("Home").painted_text().contains("> .."));
    let screen = session.type_in("77").painted_text();
    assert!(screen.contains("280 of 10040"), "{screen}");
    fs::remove_dir_all(&folder).unwrap();
}

/// All printable characters extend the search.
#[test]
fn printable_keys_search_and_other_keys_do_no_harm() {
    let mut session = open_in_folder("keys", Glyphs::Ascii, 40, 12);
    session.press("o");
    for c in ' '..='~' {
        session.press(&c.to_string());
    }
    session.press("F1 F2 Tab Shift-Tab Ctrl-L Ctrl-A Ctrl-R Ctrl-W");
    assert!(session.painted_text().starts_with(" Open a scene"));
    session.workbench.resize(19, 5);
    assert!(session.painted_text().contains("krank needs"));
    session.workbench.resize(40, 12);
    assert!(session.press("Ctrl-U").painted_text().contains("44 of 44"));
    assert!(!session.workbench.press("Ctrl-C"));
}
