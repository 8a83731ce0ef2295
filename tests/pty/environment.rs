//! Tests of various terminals: none receives sequences that it does not support.

use crate::session::{Session, Setup, TerminalBehaviour};
use std::process::Command;

/// Plays for some frames, quits, and returns the bytes sent.
fn played(setup: Setup) -> Vec<u8> {
    let mut session = setup.start();
    session.wait_for("60.00 deg").send(" ");
    session.wait_until("another angle", |seen| {
        !seen.terminal.screen().contents().contains("60.00 deg")
    });
    session.send("?");
    session.wait_for("Help").send("\x1b");
    session.settle_playing();
    session.send("q");
    assert!(session.ended_as_found().success());
    let seen = session.seen.lock().unwrap();
    seen.bytes.clone()
}

impl Session {
    /// Waits for some more frames.
    fn settle_playing(&self) {
        let before = self.bytes();
        self.wait_until("frames", |seen| seen.bytes.len() > before + 500);
    }
}

/// Returns the parameters of all SGR sequences.
fn sgr(bytes: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(bytes);
    let pieces = text.split("\x1b[").skip(1);
    let ends = |c: char| !(c.is_ascii_digit() || c == ';');
    pieces
        .filter_map(|piece| {
            let end = piece.find(ends)?;
            piece[end..]
                .starts_with('m')
                .then(|| piece[..end].to_owned())
        })
        .collect()
}

fn has_colour(bytes: &[u8]) -> bool {
    let numbers = sgr(bytes);
    let mut all = numbers.iter().flat_map(|sgr| sgr.split(';'));
    all.any(|n| matches!(n.parse::<u8>(), Ok(30..=37 | 39..=47 | 90..=107)) || n == "38")
}

fn has(bytes: &[u8], sequence: &str) -> bool {
    let mut windows = bytes.windows(sequence.len());
    windows.any(|bytes| bytes == sequence.as_bytes())
}

fn has_braille(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes);
    text.chars().any(|c| ('\u{2800}'..'\u{2900}').contains(&c))
}

#[test]
fn emulator_gets_braille_and_colours() {
    let bytes = played(Setup::krank(&["four-bar"]));
    assert!(has_braille(&bytes) && has_colour(&bytes) && has(&bytes, "\x1b[?2026h"));
    assert!(has(&bytes, "38;5;") && !has(&bytes, "38;2;"));
    let bytes = played(Setup::krank(&["four-bar"]).env("COLORTERM", "truecolor"));
    assert!(has(&bytes, "38;2;"));
}

#[test]
fn old_terminals_get_no_colour_and_no_private_mode() {
    for term in ["vt100", "vt220", ""] {
        let setup = Setup::krank(&["four-bar"]).env("TERM", term);
        let bytes = played(if term.is_empty() {
            setup.without("TERM")
        } else {
            setup
        });
        assert!(!has_colour(&bytes) && bytes.is_ascii(), "{term}");
        assert!(
            !has(&bytes, "\x1b[?2026") && !has(&bytes, "\x1b[?2004"),
            "{term}"
        );
    }
}

#[test]
fn linux_console_gets_line_glyphs_and_palette_colours() {
    let bytes = played(Setup::krank(&["four-bar"]).env("TERM", "linux"));
    assert!(has_colour(&bytes) && !has(&bytes, "38;5;") && !has_braille(&bytes));
    assert!(!has(&bytes, "\x1b[?2026") && !has(&bytes, "\x1b[?2004"));
}

#[test]
fn c_locale_gets_ascii_only() {
    let bytes = played(
        Setup::krank(&["four-bar"])
            .env("LC_ALL", "C")
            .env("LANG", "C"),
    );
    assert!(bytes.is_ascii());
}

#[test]
fn no_color_keeps_bold_and_reverse() {
    let bytes = played(Setup::krank(&["four-bar"]).env("NO_COLOR", "1"));
    assert!(!has_colour(&bytes));
    let numbers = sgr(&bytes);
    assert!(numbers.iter().any(|n| n == "1") && numbers.iter().any(|n| n.contains('7')));
}

#[test]
fn colours_change_by_key_and_by_option() {
    let mut session = Session::krank(&["four-bar", "--colour", "none"]);
    session.wait_for("60.00 deg").wait_for("-3.9164");
    session.settle();
    assert!(!has_colour(&session.seen.lock().unwrap().bytes));
    session.send("C");
    session.wait_for("16 colours");
    session.wait_until("colours", |seen| has_colour(&seen.bytes));
    session.send("q");
    assert!(session.ended_as_found().success());
    let dark = ["four-bar", "--theme", "dark", "--colour", "16"];
    let bytes = played(Setup::krank(&dark));
    assert!(sgr(&bytes).iter().any(|n| n.split(';').any(|n| n == "33")));
    let bytes = played(Setup::krank(&["four-bar", "--theme", "plain"]));
    assert!(!has_colour(&bytes));
}

#[test]
fn dumb_terminal_exits_with_2() {
    let setup = Setup::krank(&["four-bar"]).env("TERM", "dumb");
    let mut session = setup.manner(TerminalBehaviour::Mute).start();
    assert_eq!(session.ended_as_found().exit_code(), 2);
    session.wait_for("krank table");
}

#[test]
fn diagnose_reports_findings_and_reasons() {
    let setup = Setup::krank(&["--diagnose"])
        .env("NO_COLOR", "1")
        .size(100, 30);
    let mut session = setup.start();
    assert!(session.ended_as_found().success());
    session
        .wait_for("TERM             \"xterm-256color\"")
        .wait_for("LC_ALL           \"C.UTF-8\"")
        .wait_for("standard output  a terminal")
        .wait_for("screen           100 x 30 characters")
        .wait_for("line             a pseudo-terminal")
        .wait_for("glyphs           braille: an emulator in a UTF-8 locale")
        .wait_for("colours          none: NO_COLOR is set")
        .wait_for("configuration    /nowhere/configuration/krank/config.toml (does not exist)");
}

#[test]
fn diagnose_works_in_a_pipe() {
    let output = Command::new(env!("CARGO_BIN_EXE_krank"))
        .args(["--diagnose", "--glyphs", "line"])
        .env("TERM", "odd\x1b[31mname")
        .env("LC_ALL", "C")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0));
    let printed = String::from_utf8(output.stdout).unwrap();
    assert!(printed.is_ascii() && !printed.contains('\x1b'), "{printed}");
    for line in [
        "standard output  no terminal\n",
        "glyphs           line: requested; otherwise ascii: the locale is not UTF-8\n",
    ] {
        assert!(printed.contains(line), "{printed}");
    }
}
