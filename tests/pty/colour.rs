//! Tests of colours on a terminal: the background is detected behind the first frame, and a moving
//! point has a trail.

use crate::session::{Session, Setup};
use std::collections::HashSet;

/// The query of the background's colour.
const GROUND_QUERY: &[u8] = b"\x1b]11;?";
/// The colours of a trail and of a trace on a dark background, with 256 colours.
const TRAIL: &str = "Idx(148)";

/// A cell with text: its row, its column and its colour.
type Ink = (u16, u16, String);

/// Returns the foreground colours of all cells with text, with their places.
fn inks(session: &Session) -> HashSet<Ink> {
    let seen = session.seen.lock().unwrap();
    let screen = seen.terminal.screen();
    let (rows, cols) = screen.size();
    let places = (0..rows.get()).flat_map(|row| (0..cols.get()).map(move |col| (row, col)));
    let ink = |(row, col)| {
        let cell = screen.cell(row, col)?;
        (cell.contents().trim() != "").then(|| (row, col, format!("{:?}", cell.fgcolor())))
    };
    places.filter_map(ink).collect()
}

/// Returns the colours on the screen after a terminal has answered the query with a colour.
fn colours_on(ground: Option<&str>) -> HashSet<String> {
    let mut session = Setup::krank(&["four-bar"]).without("COLORFGBG").start();
    session.wait_for("60.00 deg").wait_for("-3.9164");
    session.wait_until("the query", |seen| seen.count(GROUND_QUERY) == 1);
    // The first frame is complete before any answer.
    let before = inks(&session);
    if let Some(ground) = ground {
        session.send_bytes(format!("\x1b]11;{ground}\x1b\\").as_bytes());
        session.wait_until("other colours", |seen| {
            let screen = seen.terminal.screen();
            let changed = |(row, col, colour): &Ink| {
                screen
                    .cell(*row, *col)
                    .is_some_and(|cell| format!("{:?}", cell.fgcolor()) != *colour)
            };
            before.iter().any(changed)
        });
        session.settle();
    }
    let colours = inks(&session)
        .into_iter()
        .map(|(.., colour)| colour)
        .collect();
    session.send("q");
    assert!(session.ended_as_found().success());
    colours
}

#[test]
fn reported_background_selects_colours() {
    let unknown = colours_on(None);
    let dark = colours_on(Some("rgb:0000/2b2b/3636"));
    let light = colours_on(Some("rgb:fdfd/f6f6/e3e3"));
    for (one, other) in [(&unknown, &dark), (&unknown, &light), (&dark, &light)] {
        assert!(one.len() > 3 && one != other, "{one:?} {other:?}");
    }
    // The same background by another name.
    assert_eq!(colours_on(Some("rgb:00/00/00")), dark);
}

/// The foot of the walking leg leaves a trail, which moves along with it.
#[test]
fn moving_point_has_trail() {
    let mut session = Setup::krank(&["jansen-leg"])
        .env("COLORFGBG", "15;0")
        .size(120, 40)
        .start();
    let trail = |session: &Session| -> HashSet<(u16, u16)> {
        let inks = inks(session).into_iter();
        let of_trail = inks.filter(|(.., colour)| colour == TRAIL);
        of_trail.map(|(row, col, _)| (row, col)).collect()
    };
    session.wait_for(" ok ").settle();
    let before = trail(&session);
    assert!(before.len() >= 3, "{before:?}");
    for _ in 0..6 {
        session.send(".");
    }
    session.settle();
    let after = trail(&session);
    assert!(
        after.len() >= 3 && !after.is_subset(&before),
        "{before:?} {after:?}"
    );
    session.send("q");
    assert!(session.ended_as_found().success());
}
