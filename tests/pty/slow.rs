//! A line of 960 bytes a second. Its reader is the clock: how many bytes it has taken since a key was
//! pressed says when something shows, however busy the machine is.

use crate::session::{Manner, QUESTION, SLOW, Seen, Session, Setup};
use std::thread;
use std::time::{Duration, Instant};

fn slow(arguments: &[&str]) -> Session {
    Setup::krank(arguments).manner(Manner::Slow).start()
}

/// Plays until the line has taken so many bytes more.
fn play(session: &Session, bytes: usize) {
    session.send(" ");
    let begun = session.bytes();
    session.wait_until("frames", |seen| seen.bytes.len() >= begun + bytes);
}

/// Bytes that the line takes from pressing keys to when something shows.
fn bytes_until(session: &Session, keys: &str, what: &str, holds: impl Fn(&Seen) -> bool) -> usize {
    let before = session.bytes();
    session.send(keys);
    session.wait_until(what, &holds);
    // Replayed, so that it does not matter when this was noticed.
    let bytes = session.seen.lock().unwrap().bytes.clone();
    let mut replayed = Seen::new(80, 24);
    replayed.take(&bytes[..before]);
    for piece in bytes[before..].chunks(8) {
        replayed.take(piece);
        if holds(&replayed) {
            break;
        }
    }
    replayed.bytes.len() - before
}

/// Half a second of the line, and what the reader has in its hands.
const HALF_A_SECOND: usize = SLOW / 2 + 32;

fn last_row(seen: &Seen) -> String {
    seen.rows().pop().unwrap_or_default()
}

#[test]
fn the_first_line_that_answers_a_key_shows_within_half_a_second() {
    let session = slow(&["four-bar"]);
    session.wait_for("? help").wait_for("-3.9164");
    session.settle();
    let step = bytes_until(&session, ".", "the step", |seen| {
        last_row(seen).contains("65.00 deg")
    });
    assert!(step <= HALF_A_SECOND, "{step} bytes");
    play(&session, 2500);
    for (keys, mode) in [
        ("?", " help "),
        ("\x1b", " motion "),
        ("2", " tables "),
        ("1", " motion "),
    ] {
        let bytes = bytes_until(&session, keys, mode, |seen| {
            last_row(seen).starts_with(mode)
        });
        assert!(bytes <= HALF_A_SECOND, "{mode}: {bytes} bytes");
        thread::sleep(Duration::from_millis(300));
    }
}

/// The rows between the borders of the help, as a line that is not slow shows them.
fn help() -> Vec<String> {
    let session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").send("?");
    session.wait_for("Help");
    session.settle();
    let rows = session.seen.lock().unwrap().rows();
    let inner = |row: &String| {
        let (from, to) = (row.find('\u{2502}')?, row.rfind('\u{2502}')?);
        (from < to).then(|| row[from..to].to_owned())
    };
    let rows: Vec<_> = rows.iter().filter_map(inner).collect();
    assert!(rows.len() > 10, "{rows:?}");
    rows
}

#[test]
#[ignore = "counts bytes by the wall clock; run it alone on an idle machine"]
fn a_whole_help_overlay_shows_within_two_seconds() {
    let help = help();
    let session = slow(&["four-bar"]);
    session.wait_for("? help").wait_for("-3.9164");
    play(&session, 2500);
    let bytes = bytes_until(&session, "?", "the help", |seen| {
        // A box is drawn with ASCII lines at first.
        let rows = seen.rows();
        let rows: Vec<_> = rows
            .iter()
            .map(|row| row.replace('|', "\u{2502}"))
            .collect();
        help.iter()
            .all(|line| rows.iter().any(|row| row.contains(line)))
    });
    assert!(bytes <= 2 * SLOW, "{bytes} bytes");
}

#[test]
fn no_more_than_half_a_second_is_queued() {
    // Each on a line of its own: what is taken away at once to be counted looks like a fast line.
    let queued = |keys: Option<&str>| {
        let session = slow(&["four-bar"]);
        session.wait_until("a byte", |seen| !seen.bytes.is_empty());
        if let Some(keys) = keys {
            session.wait_for("? help").wait_for("-3.9164");
            play(&session, 1500);
            session.send(keys);
            thread::sleep(Duration::from_millis(400));
        }
        let queued = session.queued();
        assert!(queued <= HALF_A_SECOND, "{queued} bytes after {keys:?}");
    };
    // At the start nothing is known of the line.
    let all = [
        None,
        Some(""),
        Some("?"),
        Some("2"),
        Some("1+\x0c"),
        Some("2\x0c1\x0c"),
    ];
    thread::scope(|scope| {
        for keys in all {
            scope.spawn(move || queued(keys));
        }
    });
}

#[test]
fn the_first_frame_tells_a_slow_line_from_a_fast_one() {
    let session = slow(&["four-bar"]);
    session.wait_until("a question", |seen| seen.count(QUESTION) > 0);
    let seen = session.seen.lock().unwrap();
    let mut windows = seen.bytes.windows(QUESTION.len());
    let first = windows.position(|bytes| bytes == QUESTION).unwrap();
    assert!(first <= 240, "{first} bytes before anything is known");
    assert!(last_row(&seen).contains("60.00 deg"), "{}", last_row(&seen));
}

fn angle(seen: &Seen) -> Option<f64> {
    let row = last_row(seen);
    let words: Vec<_> = row.split_whitespace().collect();
    let deg = words.iter().position(|word| *word == "deg")?;
    let within: f64 = words.get(deg.checked_sub(1)?)?.parse().ok()?;
    let turns = match words.get(deg + 2) {
        Some(word) if word.starts_with("turn") => words[deg + 1].parse().ok()?,
        _ => 0.0,
    };
    Some(within + 360.0 * turns)
}

/// Frames are dropped, the motion is not: it does a turn in 4 s, as on any line.
#[test]
fn the_motion_keeps_the_wall_clock() {
    let session = slow(&["four-bar"]);
    session.wait_for("? help").wait_for("-3.9164");
    session.settle();
    session.send(" ");
    let begun = Instant::now();
    let mut last = 60.0;
    while begun.elapsed() < Duration::from_secs(8) {
        thread::sleep(Duration::from_millis(50));
        last = angle(&session.seen.lock().unwrap()).unwrap_or(last);
    }
    let wanted = 60.0 + 90.0 * begun.elapsed().as_secs_f64();
    // A second late at the most, and half a second for a machine that is busy.
    assert!(
        last <= wanted && wanted - last <= 135.0,
        "{last} of {wanted} deg"
    );
}

#[test]
fn a_key_held_down_shows_all_rows_in_the_end() {
    let session = slow(&["four-bar"]);
    session.wait_for("? help").wait_for("-3.9164");
    for _ in 0..40 {
        session.send(".");
        thread::sleep(Duration::from_millis(30));
    }
    session.settle();
    session.wait_for("260.00 deg");
    let shown = session.screen();
    let fast = Session::krank(&["four-bar", "--at", "260"]);
    fast.wait_for("260.00 deg").wait_for("r1");
    fast.settle();
    let wanted = fast.screen();
    let tables = |screen: &str| {
        let rows = screen
            .lines()
            .take(23)
            .map(|row| row.rsplit('\u{2502}').next().unwrap_or("").to_owned());
        rows.collect::<Vec<_>>()
    };
    assert_eq!(tables(&shown), tables(&wanted));
}
