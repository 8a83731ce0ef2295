//! However it ends, the terminal is as it was, and no process stays.

use crate::session::{Manner, Session, Setup};
use rustix::process::Signal;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

#[test]
fn a_signal_ends_it_with_the_terminal_as_found() {
    for signal in [Signal::TERM, Signal::INT, Signal::HUP, Signal::QUIT] {
        let mut session = Session::krank(&["four-bar"]);
        session.wait_for("60.00 deg").send(" ");
        session.wait_for("pause");
        session.signal(signal);
        let status = session.ended_as_found();
        assert!(!status.success(), "whoever waits learns of {signal:?}");
    }
}

#[test]
fn a_lost_line_ends_it() {
    let krank = env!("CARGO_BIN_EXE_krank");
    // The second as under `nohup`: no signal tells it.
    for script in ["exec", "trap '' HUP; exec"] {
        for manner in [Manner::Answers, Manner::Mute] {
            let setup = Setup::script(&format!("{script} {krank} four-bar")).manner(manner);
            let mut session = setup.start();
            session.wait_for("60.00 deg").send(" ");
            session.wait_for("pause");
            session.hang_up();
            session.ended();
        }
    }
}

#[test]
fn a_line_that_hangs_does_not_keep_it() {
    for signal in [Signal::TERM, Signal::HUP] {
        let setup = Setup::krank(&["four-bar"]).manner(Manner::Stalled);
        let mut session = setup.start();
        session.resize(240, 80);
        // Whole screens, until the kernel takes no more.
        for _ in 0..12 {
            thread::sleep(Duration::from_millis(150));
            session.send("2\x0c1\x0c");
        }
        session.signal(signal);
        assert!(!session.ended().success());
        session.line_as_found();
        session.release();
    }
}

/// A release build knows no switch for it.
#[cfg(debug_assertions)]
#[test]
fn a_panic_is_told_after_the_terminal_was_put_back() {
    let setup = Setup::krank(&["four-bar"]).env("KRANK_FAULT", "panic");
    // A backtrace would push the message off the screen.
    let mut session = setup.env("RUST_BACKTRACE", "0").start();
    assert!(!session.ended_as_found().success());
    session.wait_for("internal error: KRANK_FAULT=panic");
}

/// While the main thread computes, another one hears what ends the program.
#[cfg(debug_assertions)]
#[test]
fn a_busy_program_ends_with_the_terminal_as_found() {
    let busy = || {
        Setup::krank(&["four-bar"])
            .env("KRANK_FAULT", "busy")
            .start()
    };
    for keys in ["\x03", "...\x03", "\x1b[200~x\x1b[201~\x03", "M\x1b[99;5u"] {
        let mut session = busy();
        session.wait_until("a frame", |seen| !seen.bytes.is_empty());
        session.send(keys);
        assert!(session.ended_as_found().success(), "{keys:?}");
    }
    for signal in [Signal::TERM, Signal::INT, Signal::HUP, Signal::QUIT] {
        let mut session = busy();
        session.wait_until("a frame", |seen| !seen.bytes.is_empty());
        session.signal(signal);
        assert!(!session.ended_as_found().success(), "{signal:?}");
    }
    let mut session = busy();
    session.wait_until("a frame", |seen| !seen.bytes.is_empty());
    session.hang_up();
    session.ended();
}

#[test]
fn output_that_is_no_terminal_is_refused_kindly() {
    let output = Command::new(env!("CARGO_BIN_EXE_krank"))
        .arg("four-bar")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("krank table"), "{told}");
}

/// As `krank | head -c 0`: nobody reads any more, and nothing is written.
#[test]
fn a_broken_pipe_as_output_is_refused_kindly() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_krank"))
        .arg("four-bar")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(!told.contains("panicked"), "{told}");
}

/// A disk on which nothing can be written any more, while a scene is saved: it is told, the file is
/// what it was, and nothing is left beside it.
#[test]
fn a_full_disk_leaves_the_file_as_it_was() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("full-disk");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let scene = folder.join("scene.toml");
    let preset = concat!(env!("CARGO_MANIFEST_DIR"), "/presets/four-bar.toml");
    std::fs::copy(preset, &scene).unwrap();
    let before = std::fs::read(&scene).unwrap();
    let krank = env!("CARGO_BIN_EXE_krank");
    // No file may grow beyond 0 blocks; ignored, the signal becomes an error of the writer.
    let limits = "trap '' XFSZ; ulimit -f 0; exec";
    let script = format!("{limits} {krank} '{}'", scene.display());
    let mut session = Setup::script(&script).size(120, 30).start();
    session.wait_for("60.00 deg").send("6");
    session.wait_for("Enter edit").send(">");
    session.wait_for("edits are not kept").send("w");
    session
        .wait_for("not written, the file is too large")
        .send("\x03");
    session.ended_as_found();
    assert_eq!(std::fs::read(&scene).unwrap(), before);
    let files: Vec<_> = std::fs::read_dir(&folder).unwrap().collect();
    assert_eq!(files.len(), 1, "{files:?}");
}
