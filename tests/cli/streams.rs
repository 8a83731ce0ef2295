//! Tests of pipes, output files and memory use.

use super::{Run, command, folder, krank, refused, run_ok};
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
fn closed_pipe_exits_with_0_and_no_message() {
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

/// The pipe is closed before the first byte; also tests output printed by clap itself.
#[test]
fn pipe_closed_before_output_exits_with_0_and_no_message() {
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
fn long_sweep_uses_constant_memory() {
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
    // The pipe buffers a few thousand rows, so the program is still running.
    lines.nth(330_000).unwrap().unwrap();
    let late = peak(&child);
    assert!(late < early + 1024, "{early} kB grew to {late} kB");
    assert_eq!(lines.count(), 360_002 - 1001 - 330_001);
    assert!(child.wait().unwrap().success());
}

#[test]
fn output_option_writes_results_to_a_file() {
    let folder = folder("to-a-file");
    // The extensions of the formats that a pipe gets.
    for (args, name) in [
        (&["sweep", "four-bar"][..], "out.csv"),
        (&["table", "four-bar"], "out.txt"),
        (&["check", "four-bar"], "out.txt"),
    ] {
        let file = folder.join(name);
        let path = file.to_str().unwrap();
        let on_stdout = run_ok(args);
        assert_eq!(run_ok(&[args, &["-o", path]].concat()), "");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), on_stdout);
    }
    assert_eq!(
        run_ok(&["table", "press", "-o", "-"]),
        run_ok(&["table", "press"])
    );
}

#[test]
fn unwritable_output_file_exits_with_1() {
    let message = refused(1, &["sweep", "four-bar", "-o", "/no/such/folder/x.csv"]);
    assert!(
        message.contains("cannot write `/no/such/folder/x.csv`: No such file"),
        "{message}"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn full_disk_exits_with_1() {
    for command in ["table", "sweep", "check"] {
        let message = refused(1, &[command, "four-bar", "-o", "/dev/full"]);
        assert!(
            message.contains("cannot write `/dev/full`: No space"),
            "{message}"
        );
    }
}

/// Regression test: failed writes of clap's own output were ignored.
#[cfg(target_os = "linux")]
#[test]
fn failed_write_of_help_or_version_is_reported() {
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
        let printed = String::from_utf8(output.stderr).unwrap();
        assert!(
            printed.contains("cannot write the results: No space"),
            "{argument}: {printed}"
        );
    }
}

#[test]
fn rejected_command_keeps_existing_output_file() {
    let file = folder("kept").join("kept.csv");
    std::fs::write(&file, "kept").unwrap();
    let path = file.to_str().unwrap();
    refused(2, &["sweep", "four-bar", "--step", "0", "-o", path]);
    refused(1, &["table", "double-rocker", "--at", "5", "-o", path]);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "kept");
}

#[test]
fn messages_replace_characters_unsafe_for_the_terminal() {
    let Run { code, err, .. } = krank(&["check", "k\u{fc}rbel\u{3b8}\u{1b}[2J.toml"]);
    assert_eq!(code, 2);
    // Letters are replaced by similar ASCII letters; other and control characters become `?`.
    assert!(err.contains("`kurbel??[2J.toml`"), "{err}");
    let mut utf8 = command(&["check", "k\u{fc}rbel\u{1b}.toml"]);
    let output = super::run(utf8.env("LC_ALL", "C.UTF-8").env("TERM", "xterm"));
    assert!(
        output.err.contains("`k\u{fc}rbel\u{fffd}.toml`"),
        "{}",
        output.err
    );
}
