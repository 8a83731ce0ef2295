//! Tests of the command line program: every command, every exit code, and the output on each
//! stream.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod accuracy;
mod assembly;
mod completions;
#[cfg(feature = "tui")]
mod config;
mod cycle;
mod draw;
mod exercise;
mod explain;
mod exports;
#[cfg(target_os = "linux")]
mod files;
mod forces;
mod help;
mod import;
mod inputs;
mod language;
mod manual;
mod marks;
mod methods;
mod motor;
mod over_time;
#[cfg(feature = "pictures")]
mod pixels;
mod plot;
mod readme;
mod report;
mod scenes;
mod solve;
mod streams;
mod study;
mod sweep;
mod synthesize;
mod table;
mod tolerance;
mod turns;
mod tutorial;
mod website;

use assert_cmd::Command;
use std::path::{Path, PathBuf};

/// Three parallel cranks: a mobile linkage with one redundant constraint.
const PARALLEL_CRANKS: &str = r#"
name = "Three parallel cranks"
unit = "m"
[ground]
A = [0, 0]
D = [3, 0]
G = [1, 0]
[driver]
link = "a"
angle = 60
speed = "1 rad/s"
[links]
a = { from = "A", to = "B", length = 1 }
c = { from = "D", to = "C", length = 1 }
e = { from = "G", to = "F", length = 1 }
b = { from = "B", to = "C", length = 3, points = { F = [1, 0] } }
[start]
C = [3.5, 0.866]
[vectors]
on_coupler = ["B", "F"]
across = ["A", "C"]
on_crank = ["A", "B"]
on_ground = ["A", "G"]
"#;

/// The exit code and the output of a run.
struct Run {
    code: i32,
    out: String,
    err: String,
}

/// Runs krank in a minimal environment without locale and terminal.
fn krank(args: &[&str]) -> Run {
    run(&mut command(args))
}

fn command(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_krank"));
    command.env_clear().env("LC_ALL", "C").args(args);
    // There is no configuration to read, and no place to write state.
    command.env("HOME", "/dev/null/home");
    command
}

fn run(command: &mut Command) -> Run {
    let output = command.output().unwrap();
    Run {
        code: output
            .status
            .code()
            .expect("the program must not be killed"),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs krank, checks that it succeeds with an empty standard error, and returns its output.
fn run_ok(args: &[&str]) -> String {
    let Run { code, out, err } = krank(args);
    assert_eq!((code, err.as_str()), (0, ""), "krank {args:?}");
    out
}

/// Runs krank, checks the exit code and the empty standard output, and returns the ASCII message.
fn refused(code: i32, args: &[&str]) -> String {
    let run = krank(args);
    assert_eq!(run.code, code, "krank {args:?}: {}", run.err);
    assert_eq!(run.out, "", "krank {args:?}");
    assert!(run.err.is_ascii(), "{}", run.err);
    run.err
}

fn json(text: &str) -> serde_json::Value {
    serde_json::from_str(text).unwrap()
}

/// Creates a folder for the files of a test and returns its path.
fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn presets() -> Vec<String> {
    let first = |line: &str| line.split_whitespace().next().unwrap().to_owned();
    run_ok(&["list"]).lines().map(first).collect()
}

/// Returns the cells of a CSV text without its header.
fn rows(csv: &str) -> Vec<Vec<String>> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let cells = |row: csv::StringRecord| row.iter().map(str::to_owned).collect();
    reader.records().map(|row| cells(row.unwrap())).collect()
}

#[test]
fn help_has_an_example_for_each_command() {
    for command in [
        "",
        "list",
        "check",
        "table",
        "exercise",
        "grade",
        "draw",
        "plot",
        "study",
        "sweep",
        "start",
        "accuracy",
        "motor",
        "cycle",
        "tolerance",
        "export",
        "import",
        "solve",
        "config",
        "help",
        "completions",
        "man",
    ] {
        // `config` exists only in builds with the workbench.
        if command == "config" && cfg!(not(feature = "tui")) {
            continue;
        }
        let args = [command, "--help"];
        let out = run_ok(&args[usize::from(command.is_empty())..]);
        let example = format!("\n  krank {command}");
        assert!(out.contains("Example"), "{out}");
        assert!(out.contains(example.trim_end()), "{out}");
        assert!(out.is_ascii(), "{out}");
    }
}

#[test]
fn version_matches_the_package() {
    assert_eq!(
        run_ok(&["--version"]),
        concat!("krank ", env!("CARGO_PKG_VERSION"), "\n")
    );
}

#[test]
fn long_version_lists_features_target_profile_and_licence() {
    for args in [
        &["--version", "--long"][..],
        &["--long", "--version"],
        &["-V", "--long"],
    ] {
        let long = run_ok(args);
        assert!(long.starts_with(&run_ok(&["--version"])), "{long}");
        let rows: Vec<_> = long.lines().skip(1).collect();
        let names = rows.iter().map(|row| row.split_once("  ").unwrap().0);
        assert!(
            names.eq(["features", "target", "profile", "licence"]),
            "{long}"
        );
        assert_eq!(rows[0].contains("tui"), cfg!(feature = "tui"));
        assert_eq!(rows[0].contains("pictures"), cfg!(feature = "pictures"));
        assert!(rows[1].contains(std::env::consts::ARCH), "{long}");
        assert!(long.ends_with("MIT OR Apache-2.0\n"), "{long}");
    }
    let turkish = run_ok(&["--version", "--long", "--language", "tr"]);
    assert!(turkish.contains("\nlisans "), "{turkish}");
    assert!(refused(2, &["--long"]).contains("--version"));
}

#[test]
fn every_preset_checks_prints_and_sweeps() {
    let presets = presets();
    assert!(presets.len() >= 19, "{presets:?}");
    for preset in &presets {
        let inputs = match preset.as_str() {
            "excavator" => 3,
            "five-bar" | "robot-arm" | "plotter" => 2,
            _ => 1,
        };
        let mobility = format!("\nmobility   {inputs}");
        let check = run_ok(&["check", preset]);
        assert!(check.contains(&mobility), "{preset}");
        assert!(
            run_ok(&["table", preset]).contains("\nstate ok\n"),
            "{preset}"
        );
        let csv = run_ok(&["sweep", preset]);
        // A suspension moves through 30 degrees between its stops.
        assert!(rows(&csv).len() > 30, "{preset}");
        for cell in csv.split([',', '\n']) {
            let bad = ["nan", "inf", "-0"].contains(&cell.to_lowercase().as_str());
            assert!(!bad, "{preset}: {cell}");
        }
    }
}

#[test]
fn unknown_options_and_values_are_rejected() {
    for (args, phrase) in [
        (&["sweep"][..], "<SCENE>"),
        (&["check", "four-bar", "--format", "csv"], "--format"),
        (&["table", "four-bar", "--digits", "0"], "--digits"),
        (&["table", "four-bar", "--at", "sixty"], "--at"),
        (&["list", "four-bar"], "four-bar"),
        (&["accuracy", "--positions", "0"], "--positions"),
        (&["four-bar", "--glyphs", "crayon"], "--glyphs"),
        (&["completions", "tcsh"], "tcsh"),
        (&["man", "gearbox"], "gearbox"),
    ] {
        let message = refused(2, args);
        assert!(message.contains(phrase), "{args:?}: {message}");
    }
}

/// Regression test: `krank chek four-bar` is parsed as two scenes, and the message named the wrong
/// word.
#[test]
fn mistyped_command_and_extra_argument_give_different_errors() {
    for (args, message) in [
        (
            &["chek", "four-bar"][..],
            "error: unknown command `chek`; did you mean the command `check`?\n",
        ),
        (
            &["four-bar", "table"],
            "error: put the command first: `krank table SCENE`\n",
        ),
        (
            &["four-bar", "press"],
            "error: unexpected argument `press`: krank opens one scene at a time; list the commands with `krank --help`\n",
        ),
    ] {
        assert_eq!(refused(2, args), message);
    }
    let message = refused(2, &["check", "four-bar", "--at", "3"]);
    assert!(!message.contains("as a value"), "{message}");
}

#[test]
fn help_command_equals_help_option() {
    assert_eq!(run_ok(&["help", "sweep"]), run_ok(&["sweep", "--help"]));
}

#[test]
fn man_pages_are_printed() {
    assert!(run_ok(&["man"]).contains(".TH krank 1"));
    assert!(run_ok(&["man", "sweep"]).contains(".TH krank-sweep 1"));
}

/// The message names a command that works without a terminal.
#[test]
fn workbench_without_terminal_fails_with_one_line() {
    for args in [&[][..], &["slider-crank"]] {
        let message = refused(2, args);
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.contains("krank table"), "{message}");
    }
}
