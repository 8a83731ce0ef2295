//! Tests on a real line of 960 bytes per second. `src/tui/tests/slow_line.rs` tests the time until
//! something is shown, with a simulated clock.

use crate::session::{QUESTION, Seen, Session, Setup, TerminalBehaviour};

fn slow(arguments: &[&str]) -> Session {
    Setup::krank(arguments)
        .manner(TerminalBehaviour::Slow)
        .start()
}

fn last_row(seen: &Seen) -> String {
    seen.rows().pop().unwrap_or_default()
}

#[test]
fn first_frame_asks_the_terminal_within_240_bytes() {
    let session = slow(&["four-bar"]);
    session.wait_until("a question", |seen| seen.count(QUESTION) > 0);
    let seen = session.seen.lock().unwrap();
    let mut windows = seen.bytes.windows(QUESTION.len());
    let first = windows.position(|bytes| bytes == QUESTION).unwrap();
    assert!(first <= 240, "{first} bytes before anything is known");
    assert!(last_row(&seen).contains("60.00 deg"), "{}", last_row(&seen));
}

#[test]
fn repeated_key_on_slow_line_ends_with_complete_tables() {
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
