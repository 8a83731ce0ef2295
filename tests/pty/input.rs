//! Tests of terminal input other than keys: noise, pasted text and the mouse.

use crate::session::Session;
use std::thread;
use std::time::Duration;

#[test]
fn keys_work_after_noise_on_the_line() {
    let mut session = Session::krank(&["four-bar"]);
    session
        .wait_for("60.00 deg")
        .send("\x1b]\x1b[200~qqq\x1bP\x1b[");
    // An unterminated paste is dropped after a second of silence.
    thread::sleep(Duration::from_millis(1300));
    session.send_until("g90\r", "90.00 deg", |seen| {
        seen.terminal.screen().contents().contains("90.00 deg")
    });
    session.send("q");
    assert!(session.ended_as_found().success());
}

/// Pasted text with keys that quit, save, open, edit or end a line is not read as keys in any mode.
#[test]
fn paste_is_not_read_as_keys_in_any_mode() {
    // Each key opens a mode that Esc closes: views, help, go to, assemblies, files.
    let keys = ["1", "2", "3", "4", "5", "6", "e", "?", "g", "a", "w", "W"];
    thread::scope(|scope| {
        for keys in keys {
            scope.spawn(move || paste_is_not_read_after(keys));
        }
    });
}

fn paste_is_not_read_after(keys: &str) {
    let harmful = "\x1b[200~q\x03\x1a\rw\r\nWx\r\x1b[An.5\x7f\u{202e}\x00\r\r\x1b[201~";
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
    // An ESC counts as a key if nothing follows it.
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

/// Only a key enables the mouse, and only its buttons are reported. Every exit disables it.
#[test]
fn key_enables_the_mouse_and_exit_disables_it() {
    const MOUSE_ENABLED: &[u8] = b"\x1b[?1002h\x1b[?1006h";
    const MOUSE_DISABLED: &[u8] = b"\x1b[?1006l\x1b[?1002l";
    let count = |session: &Session, sequence: &[u8]| session.seen.lock().unwrap().count(sequence);
    for keys in ["q", "\x03"] {
        let mut session = Session::krank(&["four-bar"]);
        session.wait_for("60.00 deg").settle();
        assert_eq!(count(&session, MOUSE_ENABLED), 0, "not asked for");
        session.send("M");
        session.wait_until("the mouse", |seen| seen.count(MOUSE_ENABLED) == 1);
        // Presses and releases the tab of the tables.
        session.send("\x1b[<0;15;1M\x1b[<0;15;1m");
        session.wait_for(" tables ");
        session.send(keys);
        assert!(session.ended_as_found().success() || keys != "q");
        assert_eq!(count(&session, MOUSE_DISABLED), 1);
        assert_eq!(count(&session, b"\x1b[?1003h"), 0);
    }
}
