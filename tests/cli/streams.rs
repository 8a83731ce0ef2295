//! Pipes, files and memory.

use super::{Run, command, done, folder, krank, refused};
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

fn spawned(args: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_krank"))
        .args(args)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

const LONG: [&str; 6] = ["sweep", "four-bar", "--step", "0.001", "--columns", "C.x"];

#[test]
fn a_closed_pipe_ends_quietly() {
    for format in ["csv", "json", "text"] {
        let mut child = spawned(&[&LONG[..], &["--format", format]].concat());
        let mut first = String::new();
        let mut out = BufReader::new(child.stdout.take().unwrap());
        out.read_line(&mut first).unwrap();
        drop(out);
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{format}");
        assert_eq!(output.stderr, b"", "{format}");
    }
}

/// Also where nothing could be written at all, and for what clap itself prints.
#[test]
fn a_pipe_closed_from_the_start_ends_quietly() {
    for args in [&["list"][..], &["--help"], &["table", "press"], &["man"]] {
        let mut child = spawned(args);
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{args:?}");
        assert_eq!(output.stderr, b"", "{args:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_long_sweep_takes_no_more_memory_than_a_short_one() {
    let peak = |child: &Child| {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
        let line = status.lines().find(|l| l.starts_with("VmHWM")).unwrap();
        let kilobytes = line.split_whitespace().nth(1).unwrap();
        kilobytes.parse::<u64>().unwrap()
    };
    let mut child = spawned(&LONG);
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    lines.nth(1000).unwrap().unwrap();
    let early = peak(&child);
    // The pipe holds a few thousand rows back, so that the program still runs.
    lines.nth(330_000).unwrap().unwrap();
    let late = peak(&child);
    assert!(late < early + 1024, "{early} kB grew to {late} kB");
    assert_eq!(lines.count(), 360_002 - 1001 - 330_001);
    assert!(child.wait().unwrap().success());
}

#[test]
fn results_go_to_a_file_if_asked() {
    let file = folder("to-a-file").join("out.csv");
    let path = file.to_str().unwrap();
    for args in [
        &["sweep", "four-bar"][..],
        &["table", "four-bar"],
        &["check", "four-bar"],
    ] {
        let on_stdout = done(args);
        assert_eq!(done(&[args, &["-o", path]].concat()), "");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), on_stdout);
    }
    assert_eq!(
        done(&["table", "press", "-o", "-"]),
        done(&["table", "press"])
    );
}

#[test]
fn a_file_that_cannot_be_written_ends_with_1() {
    let message = refused(1, &["sweep", "four-bar", "-o", "/no/such/folder/x.csv"]);
    assert!(
        message.contains("cannot write `/no/such/folder/x.csv`: No such file"),
        "{message}"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_ends_with_1() {
    for command in ["table", "sweep", "check"] {
        let message = refused(1, &[command, "four-bar", "-o", "/dev/full"]);
        assert!(
            message.contains("cannot write `/dev/full`: No space"),
            "{message}"
        );
    }
}

/// What clap itself prints used to be lost without a word.
#[cfg(target_os = "linux")]
#[test]
fn help_and_version_are_not_lost_in_silence() {
    for argument in ["--help", "--version", "list", "help", "man", "config"] {
        let full = std::fs::OpenOptions::new()
            .write(true)
            .open("/dev/full")
            .unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_krank"))
            .arg(argument)
            .env("LC_ALL", "C")
            .stdout(full)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(1), "{argument}");
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(
            told.contains("cannot write the results: No space"),
            "{argument}: {told}"
        );
    }
}

#[test]
fn a_refused_command_leaves_an_older_file_alone() {
    let file = folder("kept").join("kept.csv");
    std::fs::write(&file, "kept").unwrap();
    let path = file.to_str().unwrap();
    refused(2, &["sweep", "four-bar", "--step", "0", "-o", path]);
    refused(1, &["table", "double-rocker", "--at", "5", "-o", path]);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "kept");
}

#[test]
fn messages_are_ascii_where_the_locale_is_and_never_act_on_the_terminal() {
    let Run { code, err, .. } = krank(&["check", "k\u{fc}rbel\u{3b8}\u{1b}[2J.toml"]);
    assert_eq!(code, 2);
    // A letter becomes that which it looks like; what looks like none, or acts, is marked.
    assert!(err.contains("`kurbel??[2J.toml`"), "{err}");
    let mut utf8 = command(&["check", "k\u{fc}rbel\u{1b}.toml"]);
    let heard = super::run(utf8.env("LC_ALL", "C.UTF-8").env("TERM", "xterm"));
    assert!(
        heard.err.contains("`k\u{fc}rbel\u{fffd}.toml`"),
        "{}",
        heard.err
    );
}
