//! `krank draw --format cast`: a turn in characters. And what is said of formats that are not built in.

use super::{done, json};
use std::num::NonZeroU16;

/// The screen of a terminal that knows what a cast is made of: places, colours, and erasing to the end of a row.
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
    let text = done(&[&["draw"], arguments, &["--format", "cast"]].concat());
    assert!(
        text.bytes()
            .all(|b| b == b'\n' || (b' '..=b'~').contains(&b))
    );
    let mut lines = text.lines().map(json);
    (lines.next().unwrap(), lines.collect())
}

#[test]
fn a_turn_is_played_in_order_and_ends_as_it_began() {
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

    // Six seconds, fifteen pictures in each, and the first one again.
    assert_eq!(events.len(), 6 * 15 + 1);
    let times: Vec<f64> = events
        .iter()
        .map(|event| event[0].as_f64().unwrap())
        .collect();
    assert!(times.is_sorted_by(|a, b| a < b));
    assert_eq!([times[0], times[90]], [0.0, 6.0]);
    let [begun, quarter, ended] = [1, 23, 91].map(|n| played(&events[..n], 60, 20));
    assert_eq!(begun, ended);
    assert_ne!(begun, quarter);
    assert_eq!(cast(&["four-bar", "--traces", "--size", "60x20"]).1, events);
}

/// What was there before is gone: a picture behind all others is the one that is drawn alone. Names may have kept
/// their sides on the way.
#[test]
fn a_picture_of_a_turn_is_the_one_that_is_drawn_there() {
    let arguments = ["four-bar", "--traces", "--names", "none", "--size", "60x20"];
    let (_, events) = cast(&arguments);
    // Steps of 4 degrees.
    for (events, at) in [
        (&events[..1], "60"),
        (&events[..23], "148"),
        (&events[..76], "360"),
    ] {
        let still = ["--glyphs", "braille", "--at", at];
        let still = done(&[&["draw"], &arguments[..], &still].concat());
        let lines = played(events, 60, 20);
        let lines: String = lines
            .iter()
            .map(|line| line.trim_end().to_owned() + "\n")
            .collect();
        assert_eq!(lines, still);
    }
}

#[test]
fn a_motion_between_limits_goes_there_and_back() {
    let arguments = ["excavator-boom", "--seconds", "2", "--size", "40x16"];
    let (_, events) = cast(&arguments);
    assert_eq!(events.len(), 2 * 15 + 1);
    let [begun, half, ended] = [1, 16, 31].map(|n| played(&events[..n], 40, 16));
    assert_eq!(begun, ended);
    assert_ne!(begun, half);
}

/// The driver keeps its hue, and nothing is told by more colours than 256.
#[test]
fn a_cast_has_the_colours_of_the_drawing() {
    let (_, events) = cast(&["four-bar"]);
    let all: String = events
        .iter()
        .map(|event| event[2].as_str().unwrap())
        .collect();
    assert!(all.contains("\u{1b}[0;38;5;131m") && all.contains("\u{1b}[0;38;5;63m"));
    assert!(!all.contains("38;2;"));
}

/// Behind a character in the last column, erasing to the end of the row takes it away on some terminals.
#[test]
fn nothing_is_erased_behind_the_last_column() {
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

/// Arrows have a scale, and who played it has a shell with a cursor below it.
#[test]
fn a_turn_tells_what_its_arrows_mean_and_gives_the_cursor_back() {
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

/// An option that means nothing to a format is a slip, and is told with the formats that it is for.
#[test]
fn options_of_other_formats_are_refused() {
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

/// The formats are known, so that nobody takes them for a slip of the fingers.
#[cfg(not(feature = "pictures"))]
#[test]
fn pixels_that_are_not_built_in_say_how_to_have_them() {
    for format in ["png", "gif"] {
        let error = super::refused(2, &["draw", "four-bar", "--format", format]);
        assert!(error.contains("--features pictures"), "{error}");
    }
}
