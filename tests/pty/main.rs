//! Tests of the real binary on a pseudo-terminal with an emulated screen: opening, stepping,
//! resizing, stopping, quitting and losing the line. Most of them check that the terminal is
//! restored.
#![cfg(all(feature = "tui", target_os = "linux"))]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod colour;
mod ending;
mod environment;
mod first_start;
mod input;
mod line;
mod manual;
mod pixels;
mod progress;
mod saving;
mod scene;
mod session;
mod slow;
mod ssh;
mod stopping;
mod taking;

use rustix::process::Signal;
use session::{PATIENCE, Session, Setup, TerminalBehaviour};
use std::thread;
use std::time::{Duration, Instant};

#[test]
fn opens_steps_plays_and_quits() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").wait_for("-3.9164").send(".");
    session.wait_for("65.00 deg").send("\x1b[D\x1b[D");
    session.wait_for("55.00 deg").send(" ");
    session.wait_until("another angle", |seen| {
        !seen.terminal.screen().contents().contains("55.00 deg")
    });
    session.send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn scene_from_standard_input_reads_keys_from_the_terminal() {
    let krank = env!("CARGO_BIN_EXE_krank");
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/presets/slider-crank.toml");
    let mut session = Setup::script(&format!("exec {krank} - --at 45 < '{scene}'")).start();
    session.wait_for("stdin").wait_for("45.00 deg").send(".");
    session.wait_for("50.00 deg").send("q");
    assert!(session.ended_as_found().success());
}

/// Returns the number of context switches and the clock ticks of all threads: both stay constant
/// while a program is idle.
fn activity(session: &Session) -> (u64, u64) {
    let pid = session.pid().as_raw_nonzero();
    let status = std::fs::read_to_string(format!("/proc/{pid}/status")).unwrap();
    let switches = status.lines().filter(|line| line.contains("ctxt_switches"));
    let numbers = switches.map(|line| line.split_whitespace().last().unwrap().parse::<u64>());
    let stat = std::fs::read_to_string(format!("/proc/{pid}/stat")).unwrap();
    let fields: Vec<_> = stat
        .rsplit(')')
        .next()
        .unwrap()
        .split_whitespace()
        .collect();
    let ticks = [11, 12].map(|i| fields[i].parse::<u64>().unwrap());
    (numbers.map(Result::unwrap).sum(), ticks.iter().sum())
}

#[test]
fn paused_program_writes_nothing_and_does_not_wake() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").send(" ");
    session.wait_for("pause").send(" ");
    session.wait_for("play");
    // On a busy machine, the program may become idle late.
    let end = Instant::now() + PATIENCE;
    loop {
        let before = (session.bytes(), activity(&session));
        thread::sleep(Duration::from_millis(1500));
        let after = (session.bytes(), activity(&session));
        if after == before {
            break;
        }
        assert!(Instant::now() < end, "{before:?} {after:?}");
    }
    session.send("\x03");
    assert!(session.ended_as_found().success());
}

#[test]
fn screen_follows_the_window_size() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg");
    session.resize(40, 12);
    session.wait_for("60.00 deg ok");
    session.resize(20, 5);
    session.wait_for("krank needs 20 x 6");
    for n in 0..50 {
        session.resize(n * 5, n % 30);
    }
    session.resize(0, 0);
    session.resize(120, 40);
    session.wait_for("? help").send("q");
    assert!(session.ended_as_found().success());
}

/// After many unusual sizes during playback, nothing is drawn beyond the screen, and the last size applies.
#[test]
fn last_of_many_resizes_is_drawn() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").send(" ");
    let mut seed: u32 = 1;
    for _ in 0..300 {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let [cols, rows] = [seed >> 8, seed >> 20].map(|n| u16::try_from(n % 300).unwrap());
        session.resize(cols, rows);
    }
    session.set_reported_size(u16::MAX, u16::MAX);
    session.resize(100, 30);
    session.wait_for("pause").send(" ");
    session.wait_for("play");
    session.wait_until("last row", |seen| {
        let last = seen.rows().pop().unwrap_or_default();
        last.starts_with(" motion  four-bar")
    });
    session.send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn starts_at_any_size_and_grows() {
    for (cols, rows) in [(0, 0), (1, 1), (20, 5), (40, 12)] {
        let mut session = Setup::krank(&["four-bar"]).size(cols, rows).start();
        session.wait_until("a byte", |seen| !seen.bytes.is_empty());
        session.resize(100, 30);
        session.signal(Signal::WINCH);
        session.wait_for("? help").send("q");
        assert!(session.ended_as_found().success());
    }
}

#[test]
fn mute_terminal_is_not_waited_for() {
    let mut session = Setup::krank(&["four-bar"])
        .manner(TerminalBehaviour::Mute)
        .start();
    session.wait_for("60.00 deg").wait_for("-3.9164").send(".");
    session.wait_for("65.00 deg").send("..");
    session.wait_for("75.00 deg").send("q");
    assert!(session.ended_as_found().success());
}
