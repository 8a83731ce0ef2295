//! Tests that every way to end the program restores the terminal and leaves no process.

use crate::session::{Session, Setup, TerminalBehaviour};
use rustix::process::Signal;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

#[test]
fn signal_ends_the_program_and_restores_the_terminal() {
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
fn hangup_ends_the_program() {
    let krank = env!("CARGO_BIN_EXE_krank");
    // The second script ignores SIGHUP, as under `nohup`.
    for script in ["exec", "trap '' HUP; exec"] {
        for manner in [TerminalBehaviour::Answers, TerminalBehaviour::Mute] {
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
fn signal_ends_the_program_on_a_stalled_line() {
    for signal in [Signal::TERM, Signal::HUP] {
        let setup = Setup::krank(&["four-bar"]).manner(TerminalBehaviour::Stalled);
        let mut session = setup.start();
        session.resize(240, 80);
        // Sends whole screens until the kernel's buffer is full.
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

/// Release builds ignore `KRANK_FAULT`.
#[cfg(debug_assertions)]
#[test]
fn panic_message_is_printed_after_restoring_the_terminal() {
    let setup = Setup::krank(&["four-bar"]).env("KRANK_FAULT", "panic");
    // A backtrace would push the message off the screen.
    let mut session = setup.env("RUST_BACKTRACE", "0").start();
    assert!(!session.ended_as_found().success());
    session.wait_for("internal error: KRANK_FAULT=panic");
}

/// While the main thread computes, another thread handles keys and signals that end the program.
#[cfg(debug_assertions)]
#[test]
fn busy_program_ends_and_restores_the_terminal() {
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
fn output_without_terminal_exits_with_2() {
    let output = Command::new(env!("CARGO_BIN_EXE_krank"))
        .arg("four-bar")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    let printed = String::from_utf8(output.stderr).unwrap();
    assert!(printed.contains("krank table"), "{printed}");
}

/// Like `krank | head -c 0`: the pipe has no reader.
#[test]
fn broken_output_pipe_exits_with_2_without_panic() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_krank"))
        .arg("four-bar")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    let printed = String::from_utf8(output.stderr).unwrap();
    assert!(!printed.contains("panicked"), "{printed}");
}

/// If the disk is full while a scene is saved, an error is shown, the file stays unchanged, and no
/// temporary file remains.
#[test]
fn full_disk_keeps_the_saved_file() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("full-disk");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let scene = folder.join("scene.toml");
    let preset = concat!(env!("CARGO_MANIFEST_DIR"), "/presets/four-bar.toml");
    std::fs::copy(preset, &scene).unwrap();
    let before = std::fs::read(&scene).unwrap();
    let krank = env!("CARGO_BIN_EXE_krank");
    // The limit on the file size is 0 blocks; with the signal ignored, writes fail with an error.
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
