//! What comes from the terminal and is no key: noise, and text that is pasted.

use crate::session::Session;
use std::thread;
use std::time::Duration;

#[test]
fn noise_from_the_line_does_not_make_deaf() {
    let mut session = Session::krank(&["four-bar"]);
    session
        .wait_for("60.00 deg")
        .send("\x1b]\x1b[200~qqq\x1bP\x1b[");
    // A paste without an end is given up after a second of silence.
    thread::sleep(Duration::from_millis(1300));
    session.send_until("g90\r", "90.00 deg", |seen| {
        seen.terminal.screen().contents().contains("90.00 deg")
    });
    session.send("q");
    assert!(session.ended_as_found().success());
}

/// Keys that leave, save, open and edit, and what would end a line: pasted, none of them is a key,
/// wherever it is pasted to.
#[test]
fn a_paste_is_no_key_in_any_mode() {
    let harmful = "\x1b[200~q\x03\x1a\rw\r\nWx\r\x1b[An.5\x7f\u{202e}\x00\r\r\x1b[201~";
    // Each leads to a mode of its own, and Esc back: the views, help, where to go, assemblies, files.
    for keys in ["1", "2", "3", "4", "5", "6", "e", "?", "g", "a", "w", "W"] {
        let mut session = Session::krank(&["four-bar"]);
        session.wait_for("60.00 deg").send(keys);
        session.settle();
        session.send(harmful);
        session.settle();
        let seen = session.screen();
        assert!(
            session.child.try_wait().unwrap().is_none(),
            "{keys}\n{seen}"
        );
        assert!(
            seen.chars().all(|c| c == '\n' || !c.is_control()),
            "{keys}\n{seen}"
        );
        // An ESC is a key of its own once nothing follows it.
        for _ in 0..2 {
            session.send("\x1b");
            thread::sleep(Duration::from_millis(80));
        }
        session.send_until("1", "the motion", |seen| {
            let screen = seen.terminal.screen().contents();
            screen.contains("four-bar   60.00 deg")
        });
        assert!(session.ended_by_ctrl_c().success(), "{keys}");
    }
}

/// The mouse is taken by a key alone, tells of its buttons and of nothing else, and is the terminal's again on every way
/// out.
#[test]
fn the_mouse_is_taken_by_a_key_and_given_back() {
    const TAKEN: &[u8] = b"\x1b[?1002h\x1b[?1006h";
    const GIVEN: &[u8] = b"\x1b[?1006l\x1b[?1002l";
    let count = |session: &Session, sequence: &[u8]| session.seen.lock().unwrap().count(sequence);
    for keys in ["q", "\x03"] {
        let mut session = Session::krank(&["four-bar"]);
        session.wait_for("60.00 deg").settle();
        assert_eq!(count(&session, TAKEN), 0, "not asked for");
        session.send("M");
        session.wait_until("the mouse", |seen| seen.count(TAKEN) == 1);
        // The tab of the tables, pressed and let go.
        session.send("\x1b[<0;15;1M\x1b[<0;15;1m");
        session.wait_for(" tables ");
        session.send(keys);
        assert!(session.ended_as_found().success() || keys != "q");
        assert_eq!(count(&session, GIVEN), 1);
        assert_eq!(count(&session, b"\x1b[?1003h"), 0);
    }
}
