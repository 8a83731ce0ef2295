//! Tests of bad lines: noise, lost or late answers, and unrequested strings. After each of them,
//! the next key is handled and its effect shown.

use crate::session::{PATIENCE, Session, Setup, TerminalBehaviour};
use std::thread;
use std::time::{Duration, Instant};

/// Unfinished sequences are dropped after this silence: longer than every timeout except that of a paste.
const SILENCE: Duration = Duration::from_millis(350);

/// Returns unfinished and foreign sequences that a terminal may send.
fn hostile() -> Vec<Vec<u8>> {
    let mut all: Vec<Vec<u8>> = [
        &b"\xe9"[..],
        b"\xf0\x9f\x98",
        b"\x80\x9c\xff",
        b"\x1b[",
        b"\x1b[1;5",
        b"\x1b[[",
        b"\x1b[M",
        b"\x1bO",
        b"\x9b",
        b"\x90q",
        b"\x1b]",
        b"\x1b]11;rgb:0000/0000/0000",
        b"\x1bP1+r",
        b"\x1b_G",
        b"\x1b[5n",
        b"\x1b[0n\x1b[0n\x1b[0n",
        b"\x1b[0",
        b"\x1b[200~q\x1b[201~",
        b"\x1b[200~a\x1b[0nq\x03w\x1b[201~",
        b"\x1b[?62;1;6;9;15;22c",
        b"\x1b[24;80R",
        b"\x1b[I\x1b[O",
        b"\x1b[<0;10;10M",
    ]
    .map(<[u8]>::to_vec)
    .to_vec();
    // Replies longer than any key. Regression test: bytes after the first 256 were read as keys, and `q` quits.
    for (starts, ends) in [
        ("\x1b]52;c;", "\x07"),
        ("\x1bP1+r", "\x1b\\"),
        ("\x1b_G", "\x1b\\"),
    ] {
        all.push(format!("{starts}{}{ends}", "q".repeat(3000)).into_bytes());
    }
    all.push(format!("\x1b[{}q", "1;".repeat(3000)).into_bytes());
    all
}

/// Steps the driver and waits until the screen shows it.
fn step(session: &Session, from: u32) -> u32 {
    let to = format!("{}.00 deg", (from + 5) % 360);
    session.send_until(".", &to, |seen| {
        seen.terminal.screen().contents().contains(&to)
    });
    (from + 5) % 360
}

/// Sends noise to a new session, whole or byte by byte, and checks a key after each piece.
fn assert_key_after_noise(manner: TerminalBehaviour, by_bytes: bool) {
    let mut session = Setup::krank(&["four-bar"]).manner(manner).start();
    session.wait_for("60.00 deg").wait_for("-3.9164");
    let mut at = 60;
    for noise in hostile() {
        // A frame is being sent, so that its answer follows the noise. Within the bytes of a reply,
        // a terminal sends no answers.
        session.send(".");
        at = (at + 5) % 360;
        if by_bytes {
            session.wait_for(&format!("{at}.00 deg"));
            session.settle();
        }
        match by_bytes {
            false => session.send_bytes(&noise),
            // A single ESC is a key after 25 ms, which may pass between two bytes on a busy machine.
            true => noise
                .chunk_by(|byte, _| *byte == 0x1b)
                .take(64)
                .for_each(|piece| {
                    session.send_bytes(piece);
                    thread::sleep(Duration::from_micros(500));
                }),
        }
        thread::sleep(SILENCE);
        session.wait_for(&format!("{at}.00 deg"));
        at = step(&session, at);
    }
    assert!(session.ended_by_ctrl_c().success());
}

#[test]
fn next_key_after_noise_is_handled_and_shown() {
    thread::scope(|scope| {
        for manner in [TerminalBehaviour::Answers, TerminalBehaviour::Mute] {
            for by_bytes in [false, true] {
                scope.spawn(move || assert_key_after_noise(manner, by_bytes));
            }
        }
    });
}

/// The terminal stops answering. The delay of the next frame is tested with a simulated clock.
#[test]
fn lost_answer_does_not_stop_the_screen() {
    let session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").wait_for("-3.9164");
    session.settle();
    session.stop_answering();
    let mut at = 60;
    for _ in 0..8 {
        at = step(&session, at);
    }
}

#[test]
fn ctrl_c_quits_during_an_endless_paste() {
    // After a moment, as a user would press it.
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").send("\x1b[200~some text");
    thread::sleep(Duration::from_millis(120));
    assert!(session.ended_by_ctrl_c().success());
    // And while the paste continues.
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").send("\x1b[200~");
    let end = Instant::now() + PATIENCE;
    while session.child.try_wait().unwrap().is_none() {
        assert!(Instant::now() < end, "it never hears");
        session.send_if_there(b"text and \x03 more text\r");
        thread::sleep(Duration::from_millis(5));
    }
    assert!(session.ended().success());
}

/// Ctrl-C quits even within an unfinished sequence.
#[test]
fn ctrl_c_quits_after_any_noise() {
    // A few sessions at a time: most of the time they wait.
    for some in hostile().chunks(9) {
        thread::scope(|scope| {
            for noise in some {
                scope.spawn(move || ctrl_c_quits_after(noise));
            }
        });
    }
}

fn ctrl_c_quits_after(noise: &[u8]) {
    let is_pasted = noise.starts_with(b"\x1b[200~");
    let noise: Vec<u8> = noise.iter().copied().filter(|byte| *byte != 3).collect();
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").send_bytes(&noise);
    if is_pasted {
        thread::sleep(SILENCE);
    }
    assert!(session.ended_by_ctrl_c().success(), "{noise:?}");
}
