//! Tests of `krank draw --format cast`: a turn in characters; and messages for formats that are not built in.

use super::{json, run_ok};
use std::num::NonZeroU16;

/// Returns the screen after playing events on a terminal emulator with cursor positions, colours
/// and erasing to the end of a line.
fn played(events: &[serde_json::Value], cols: u16, rows: u16) -> Vec<String> {
    let [height, width] = [rows, cols].map(|n| NonZeroU16::new(n).unwrap());
    let mut terminal = vt100::Parser::new(height, width, 0);
    for event in events {
        assert_eq!(event[1], "o");
        terminal.process(event[2].as_str().unwrap().as_bytes());
    }
    terminal.screen().rows(0, cols).collect()
}

fn cast(arguments: &[&str]) -> (serde_json::Value, Vec<serde_json::Value>) {
    let text = run_ok(&[&["draw"], arguments, &["--format", "cast"]].concat());
    assert!(
        text.bytes()
            .all(|b| b == b'\n' || (b' '..=b'~').contains(&b))
    );
    let mut lines = text.lines().map(json);
    (lines.next().unwrap(), lines.collect())
}

#[test]
fn cast_frames_are_ordered_and_end_as_they_began() {
    let (header, events) = cast(&["four-bar", "--traces", "--size", "60x20"]);
    assert_eq!(header["version"], 2);
    assert_eq!(
        (header["width"].as_u64(), header["height"].as_u64()),
        (Some(60), Some(20))
    );
    assert_eq!(header["title"], "Four-bar crank-rocker at 60 deg");
    assert!(
        header.get("timestamp").is_none(),
        "the bytes would differ each time"
    );

    // Six seconds with fifteen frames each, and the first frame again.
    assert_eq!(events.len(), 6 * 15 + 1);
    let times: Vec<f64> = events
        .iter()
        .map(|event| event[0].as_f64().unwrap())
        .collect();
    assert!(times.is_sorted_by(|a, b| a < b));
    assert_eq!([times[0], times[90]], [0.0, 6.0]);
    let [started, quarter, ended] = [1, 23, 91].map(|n| played(&events[..n], 60, 20));
    assert_eq!(started, ended);
    assert_ne!(started, quarter);
    assert_eq!(cast(&["four-bar", "--traces", "--size", "60x20"]).1, events);
}

/// Each frame erases the previous one: the screen equals the drawing of its position. Names are
/// off, since they may keep the sides of earlier frames.
#[test]
fn cast_frames_equal_drawn_pictures() {
    let arguments = ["four-bar", "--traces", "--names", "none", "--size", "60x20"];
    let (_, events) = cast(&arguments);
    // Frames are 4 degrees apart.
    for (events, at) in [
        (&events[..1], "60"),
        (&events[..23], "148"),
        (&events[..76], "360"),
    ] {
        let still = ["--glyphs", "braille", "--at", at];
        let still = run_ok(&[&["draw"], &arguments[..], &still].concat());
        let lines = played(events, 60, 20);
        let lines: String = lines
            .iter()
            .map(|line| line.trim_end().to_owned() + "\n")
            .collect();
        assert_eq!(lines, still);
    }
}

#[test]
fn limited_motion_plays_there_and_back() {
    let arguments = ["excavator-boom", "--seconds", "2", "--size", "40x16"];
    let (_, events) = cast(&arguments);
    assert_eq!(events.len(), 2 * 15 + 1);
    let [started, half, ended] = [1, 16, 31].map(|n| played(&events[..n], 40, 16));
    assert_eq!(started, ended);
    assert_ne!(started, half);
}

/// The driver keeps its hue, and there are at most 256 colours.
#[test]
fn cast_has_the_colours_of_the_drawing() {
    let (_, events) = cast(&["four-bar"]);
    let all: String = events
        .iter()
        .map(|event| event[2].as_str().unwrap())
        .collect();
    assert!(all.contains("\u{1b}[0;38;5;131m") && all.contains("\u{1b}[0;38;5;63m"));
    assert!(!all.contains("38;2;"));
}

/// After a character in the last column, erasing to the end of the line deletes that character on some terminals.
#[test]
fn cast_does_not_erase_after_the_last_column() {
    let (_, events) = cast(&["engine"]);
    let full = events.iter().filter_map(|event| event[2].as_str());
    let full = full.flat_map(|text| text.split(";1H").skip(1));
    for row in full.filter(|row| row.ends_with("\u{1b}[K")) {
        let glyphs = row
            .split("\u{1b}[")
            .map(|piece| match piece.split_once('m') {
                Some((style, rest)) if style.chars().all(|c| c.is_ascii_digit() || c == ';') => {
                    rest
                }
                _ => piece,
            });
        let columns: usize = glyphs
            .filter(|piece| *piece != "K")
            .map(|p| p.chars().count())
            .sum();
        assert!(columns < 80, "{row:?}");
    }
}

/// The arrows have a scale, and after playing, the shell has a visible cursor below the picture.
#[test]
fn cast_shows_arrow_scale_and_restores_the_cursor() {
    let (_, events) = cast(&["four-bar", "--velocities", "--size", "60x20"]);
    let screen = played(&events, 60, 20);
    assert!(screen[19].contains("mm/s ="), "{screen:#?}");
    let texts: Vec<&str> = events
        .iter()
        .filter_map(|event| event[2].as_str())
        .collect();
    assert!(texts[0].starts_with("\u{1b}[?25l"));
    assert!(texts[texts.len() - 1].ends_with("\u{1b}[20;1H\u{1b}[?25h"));
}

/// An option without meaning for a format is an error, and the message lists its formats.
#[test]
fn options_of_other_formats_are_rejected() {
    for (arguments, option, others) in [
        (
            &["--width", "800", "--format", "svg"][..],
            "--width",
            "png, gif",
        ),
        (&["--dark"], "--dark", "svg, png, gif"),
        (
            &["--format", "svg", "--seconds", "3"],
            "--seconds",
            "gif, cast",
        ),
        (
            &["--format", "svg", "--glyphs", "line"],
            "--glyphs",
            "text, cast",
        ),
    ] {
        let error = super::refused(2, &[&["draw", "four-bar"], arguments].concat());
        assert!(error.contains(option) && error.contains(others), "{error}");
    }
}

/// Formats that are not built in are known, so that they are not reported as typing errors.
#[cfg(not(feature = "pictures"))]
#[test]
fn missing_pixels_feature_is_explained() {
    for format in ["png", "gif"] {
        let error = super::refused(2, &["draw", "four-bar", "--format", format]);
        assert!(error.contains("--features pictures"), "{error}");
    }
}
