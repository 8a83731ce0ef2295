//! Tests of colours on a terminal: the background is detected behind the first frame, and a moving
//! point has a trail.

use crate::session::{Seen, Setup};
use std::cell::RefCell;
use std::collections::HashSet;

/// The query of the colours of text and background.
const COLOUR_QUERY: &[u8] = b"\x1b]10;?\x1b\\\x1b]11;?\x1b\\";
/// The colours of a trail and of a trace on a dark background, with 256 colours.
const TRAIL: &str = "Idx(148)";

/// A cell with text: its row, its column and its colour.
type Ink = (u16, u16, String);

/// Returns the foreground colours of all cells with text, with their places.
fn inks(seen: &Seen) -> HashSet<Ink> {
    let screen = seen.terminal.screen();
    let (rows, cols) = screen.size();
    let places = (0..rows.get()).flat_map(|row| (0..cols.get()).map(move |col| (row, col)));
    let ink = |(row, col)| {
        let cell = screen.cell(row, col)?;
        (cell.contents().trim() != "").then(|| (row, col, format!("{:?}", cell.fgcolor())))
    };
    places.filter_map(ink).collect()
}

/// Returns the colours on the screen after a terminal has answered the query with the colours of its
/// text and its background.
fn colours_of(text: Option<&str>, ground: Option<&str>) -> HashSet<String> {
    let mut session = Setup::krank(&["four-bar"]).without("COLORFGBG").start();
    session.wait_for("60.00 deg").wait_for("-3.9164");
    // The first frame is complete before any answer.
    let first = RefCell::new(HashSet::new());
    session.wait_until("the query", |seen| {
        first.replace(inks(seen));
        seen.count(COLOUR_QUERY) == 1 && seen.is_between_frames()
    });
    let last = RefCell::new(first.borrow().clone());
    if let Some(text) = text {
        session.send_bytes(format!("\x1b]10;{text}\x1b\\").as_bytes());
    }
    if let Some(ground) = ground {
        session.send_bytes(format!("\x1b]11;{ground}\x1b\\").as_bytes());
        session.wait_until("other colours", |seen| {
            last.replace(inks(seen));
            seen.is_between_frames() && last != first
        });
    }
    session.send("q");
    assert!(session.ended_as_found().success());
    let last = last.into_inner().into_iter();
    last.map(|(.., colour)| colour).collect()
}

#[test]
fn reported_background_selects_colours() {
    let colours_on = |ground| colours_of(None, ground);
    let unknown = colours_on(None);
    let dark = colours_on(Some("rgb:0000/2b2b/3636"));
    let light = colours_on(Some("rgb:fdfd/f6f6/e3e3"));
    for (one, other) in [(&unknown, &dark), (&unknown, &light), (&dark, &light)] {
        assert!(one.len() > 3 && one != other, "{one:?} {other:?}");
    }
    // The same background by another name.
    assert_eq!(colours_on(Some("rgb:00/00/00")), dark);
}

/// Text with a contrast below 7 becomes white or black.
#[test]
fn weak_text_is_replaced() {
    let own = format!("{:?}", vt100::Color::Default);
    for (text, ground, ink) in [
        ("rgb:8383/9494/9696", "rgb:0000/2b2b/3636", "Idx(231)"),
        ("rgb:6565/7b7b/8383", "rgb:fdfd/f6f6/e3e3", "Idx(16)"),
    ] {
        let strong = colours_of(None, Some(ground));
        let weak = colours_of(Some(text), Some(ground));
        assert!(strong.contains(&own) && strong.contains(ink), "{strong:?}");
        assert!(!weak.contains(&own) && weak.contains(ink), "{weak:?}");
    }
}

/// The foot of the walking leg leaves a trail, which moves along with it.
#[test]
fn moving_point_has_trail() {
    let mut session = Setup::krank(&["jansen-leg"])
        .env("COLORFGBG", "15;0")
        .size(120, 40)
        .start();
    let trail = |seen: &Seen| -> HashSet<(u16, u16)> {
        let of_trail = inks(seen)
            .into_iter()
            .filter(|(.., colour)| colour == TRAIL);
        of_trail.map(|(row, col, _)| (row, col)).collect()
    };
    let before = RefCell::new(HashSet::new());
    session.wait_until("a trail", |seen| {
        before.replace(trail(seen));
        before.borrow().len() >= 3
    });
    for _ in 0..6 {
        session.send(".");
    }
    session.wait_until("another trail", |seen| {
        let after = trail(seen);
        after.len() >= 3 && !after.is_subset(&before.borrow())
    });
    session.send("q");
    assert!(session.ended_as_found().success());
}
