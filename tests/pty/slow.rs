//! A real line of 960 bytes a second. How soon something shows on one is tested with a simulated clock, in
//! `src/tui/tests/slow_line.rs`.

use crate::session::{Manner, QUESTION, Seen, Session, Setup};

fn slow(arguments: &[&str]) -> Session {
    Setup::krank(arguments).manner(Manner::Slow).start()
}

fn last_row(seen: &Seen) -> String {
    seen.rows().pop().unwrap_or_default()
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

#[test]
fn a_key_held_down_shows_all_rows_in_the_end() {
    let session = slow(&["four-bar"]);
    session.wait_for("? help").wait_for("-3.9164");
    session.send(&".".repeat(40));
    session.wait_for("260.00 deg");
    let fast = Session::krank(&["four-bar", "--at", "260"]);
    fast.wait_for("260.00 deg").wait_for("r1");
    let tables = |seen: &Seen| {
        let rows = seen.rows();
        let rows = rows.iter().take(23);
        let rows = rows.map(|row| row.rsplit('\u{2502}').next().unwrap_or("").to_owned());
        rows.collect::<Vec<_>>()
    };
    session.wait_until("the same tables", |seen| {
        tables(seen) == tables(&fast.seen.lock().unwrap())
    });
}
