//! Tests of output from the workbench: bytes for the terminal's clipboard, and files.

use crate::session::{Setup, TerminalBehaviour};

/// Copied text arrives once and complete, between frames, even on a slow line.
#[test]
fn clipboard_sequence_is_sent_once_and_complete() {
    for manner in [
        TerminalBehaviour::Answers,
        TerminalBehaviour::Mute,
        TerminalBehaviour::Slow,
    ] {
        let mut session = Setup::krank(&["four-bar"]).manner(manner).start();
        session.wait_for("60.00 deg").send(" 2");
        session.wait_for("> r2").send("yt");
        session
            .wait_for("sent to the terminal's clipboard")
            .send(" q");
        assert!(session.ended_as_found().success());
        let seen = session.seen.lock().unwrap();
        let bytes = String::from_utf8_lossy(&seen.bytes);
        let sent: Vec<&str> = bytes.split("\x1b]52;c;").skip(1).collect();
        let [sent] = sent[..] else {
            panic!("{} sequences", sent.len());
        };
        let text = sent.split("\x1b\\").next().unwrap();
        // Starts with `vector\tlength [mm]`, and contains no byte of a frame.
        assert!(text.starts_with("dmVjdG9yCWxlbmd0aCBbbW1d"), "{text}");
        assert!(text.len() > 300 && text.len() % 4 == 0, "{text}");
        let digit = |b: u8| b.is_ascii_alphanumeric() || b"+/=".contains(&b);
        assert!(text.bytes().all(digit), "{text}");
    }
}

#[test]
fn console_without_clipboard_suggests_another_key() {
    let arguments = ["four-bar", "--view", "tables"];
    let mut session = Setup::krank(&arguments).env("TERM", "linux").start();
    session.wait_for("> r2").send("y");
    session
        .wait_for("this terminal has no clipboard: use Y")
        .send("q");
    assert!(session.ended_as_found().success());
    let seen = session.seen.lock().unwrap();
    assert!(!String::from_utf8_lossy(&seen.bytes).contains("\x1b]52"));
}

/// A limit on the file size acts like a disk that fills up during the write.
#[test]
fn failed_write_leaves_no_file() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("no-room");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let krank = env!("CARGO_BIN_EXE_krank");
    let script = format!(
        "cd '{}' && trap '' XFSZ && ulimit -f 1 && exec {krank} jansen-leg --view tables",
        folder.display()
    );
    let mut session = Setup::script(&script).start();
    session.wait_for("> ").send("Y\r");
    session.wait_for("not written: the file is too large");
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
    // The file name stays in the prompt, to be changed.
    session.wait_for("write to: jansen-leg-").send("\x1b");
    session.wait_for("? help").send("q");
    assert!(session.ended_as_found().success());
}
