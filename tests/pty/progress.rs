//! Tests of the progress line on a pseudo-terminal: when it is shown, and that it is removed completely.

use crate::session::PATIENCE;
use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};
use std::io::{Read, Write};
use std::num::NonZeroU16;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// A shell command on its own terminal.
struct Terminal {
    screen: Arc<Mutex<vt100::Parser>>,
    bytes: Arc<Mutex<Vec<u8>>>,
    child: Box<dyn Child + Send + Sync>,
    /// Kept open, since dropping it sends an end of input.
    keys: Box<dyn Write + Send>,
    _master: Box<dyn MasterPty + Send>,
}

impl Terminal {
    fn run(script: &str, term: &str, cols: u16) -> Terminal {
        let rows = 10;
        let size = PtySize {
            rows,
            cols,
            pixel_width: 0,
            pixel_height: 0,
        };
        let pair = native_pty_system().openpty(size).unwrap();
        let mut command = CommandBuilder::new("/bin/sh");
        command.args(["-c", script]);
        command.env("KRANK", env!("CARGO_BIN_EXE_krank"));
        command.env("TERM", term);
        command.env("LC_ALL", "C.UTF-8");
        let child = pair.slave.spawn_command(command).unwrap();
        let [rows, cols] = [rows, cols].map(|n| NonZeroU16::new(n).unwrap());
        let screen = Arc::new(Mutex::new(vt100::Parser::new(rows, cols, 0)));
        let bytes = Arc::new(Mutex::new(Vec::new()));
        let mut reader = pair.master.try_clone_reader().unwrap();
        let (to_screen, to_bytes) = (Arc::clone(&screen), Arc::clone(&bytes));
        thread::spawn(move || {
            let mut buffer = [0; 4096];
            while let Ok(n @ 1..) = reader.read(&mut buffer) {
                to_screen.lock().unwrap().process(&buffer[..n]);
                to_bytes.lock().unwrap().extend_from_slice(&buffer[..n]);
            }
        });
        Terminal {
            screen,
            bytes,
            child,
            keys: pair.master.take_writer().unwrap(),
            _master: pair.master,
        }
    }

    fn contents(&self) -> String {
        self.screen.lock().unwrap().screen().contents()
    }

    fn wait_until(&self, what: &str, holds: impl Fn(&str) -> bool) {
        let end = Instant::now() + PATIENCE;
        while !holds(&self.contents()) {
            assert!(Instant::now() < end, "no {what} on\n{}", self.contents());
            thread::sleep(Duration::from_millis(5));
        }
    }

    fn wait_for(&self, text: &str) {
        self.wait_until(text, |screen| screen.contains(text));
    }

    fn type_in(&mut self, keys: &str) {
        self.keys.write_all(keys.as_bytes()).unwrap();
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        let _ = self.child.kill();
    }
}

/// Runs far longer than any test; a key ends it.
const LONG_SWEEP: &str = "$KRANK sweep four-bar --step 1e-6";

#[test]
fn progress_is_shown_and_ctrl_c_clears_its_line() {
    let script = format!("trap : INT; {LONG_SWEEP} -o /dev/null; echo code $?");
    for (term, cols, bar) in [
        ("xterm", 100, "\u{2500}"),
        ("linux", 60, "[..."),
        ("xterm", 30, "\u{2500}"),
    ] {
        let mut terminal = Terminal::run(&script, term, cols);
        terminal.wait_for(if cols > 30 { " left" } else { " %" });
        assert!(terminal.contents().contains(bar), "{}", terminal.contents());
        if cols == 100 {
            assert!(terminal.contents().contains(" of 360,000,001 rows  "));
        }
        assert_eq!(terminal.contents().lines().count(), 1);
        terminal.type_in("\x03");
        terminal.wait_for("code 130");
        let left: Vec<String> = terminal.contents().lines().map(str::to_owned).collect();
        // The terminal echoes the key, before or after the line is cleared.
        assert!(
            ["code 130", "^Ccode 130"].contains(&left.concat().as_str()),
            "{left:?}"
        );
    }
}

/// The sweep is blocked in a write, with its progress line on the terminal.
#[test]
fn ctrl_c_ends_a_command_blocked_on_a_full_pipe() {
    let mark = concat!(env!("CARGO_TARGET_TMPDIR"), "/progress-stuck");
    let _ = std::fs::remove_file(mark);
    let reader = format!("{{ timeout 2 cat > /dev/null; echo > {mark}; sleep 1000; }}");
    let script = format!("trap : INT; {LONG_SWEEP} | {reader}; echo code $?");
    let mut terminal = Terminal::run(&script, "xterm", 80);
    terminal.wait_for(" left");
    terminal.wait_until("reader that has stopped", |_| {
        std::fs::exists(mark).unwrap()
    });
    thread::sleep(Duration::from_millis(200));
    terminal.type_in("\x03");
    terminal.wait_for("code 130");
    assert!(
        !terminal.contents().contains('%'),
        "{}",
        terminal.contents()
    );
}

/// A slow reader keeps the sweep going until its progress was seen.
#[test]
fn progress_is_removed_when_the_sweep_ends() {
    let mark = concat!(env!("CARGO_TARGET_TMPDIR"), "/progress-seen");
    let _ = std::fs::remove_file(mark);
    let read = "dd bs=4096 count=1 2>/dev/null; sleep 0.02";
    let reader = format!("{{ until [ -e {mark} ]; do {read}; done; cat; }} > /dev/null");
    let sweep = format!("$KRANK sweep four-bar --step 0.01 | {reader}; echo done");
    let terminal = Terminal::run(&sweep, "xterm", 80);
    terminal.wait_for(" left");
    std::fs::write(mark, "").unwrap();
    terminal.wait_for("done");
    assert_eq!(terminal.contents().trim_end(), "done");
}

#[test]
fn progress_is_hidden_if_it_would_disturb_the_output() {
    // Results on the same terminal; a terminal without cursor movement; messages to a file.
    for (redirected, term) in [
        ("--columns C.x", "xterm"),
        ("-o /dev/null", "dumb"),
        ("-o /dev/null 2>/dev/null", "xterm"),
    ] {
        // Four times as long as the delay of the progress, and in the foreground, where it is shown.
        let sweep = format!("timeout --foreground 2 {LONG_SWEEP} {redirected}");
        let terminal = Terminal::run(&format!("{sweep}; echo done"), term, 80);
        terminal.wait_for("done");
        let bytes = terminal.bytes.lock().unwrap();
        assert!(!bytes.contains(&b'\x1b'), "{sweep}");
        assert!(!bytes.windows(2).any(|two| two == b" %"), "{sweep}");
    }
}

/// `accuracy` shows the same line; Ctrl-C removes it and prints no partial results.
#[test]
fn accuracy_shows_progress_and_ctrl_c_clears_its_line() {
    let script = "trap : INT; $KRANK accuracy scissor-lift; echo code $?";
    let mut terminal = Terminal::run(script, "linux", 80);
    terminal.wait_for(" of 1,000 parts  ");
    terminal.type_in("\x03");
    terminal.wait_for("code 130");
    let left: Vec<String> = terminal.contents().lines().map(str::to_owned).collect();
    assert!(
        ["code 130", "^Ccode 130"].contains(&left.concat().as_str()),
        "{left:?}"
    );
}

/// Returns a task with so many points that the search takes long.
fn long_task() -> String {
    let points = (0..1000).map(|k| {
        let at = f64::from(k) * std::f64::consts::TAU / 1000.0;
        let wave = 10.0 * (5.0 * at).sin();
        format!("[{:.3}, {:.3}]", 100.0 * at.cos() + wave, 60.0 * at.sin())
    });
    let points: Vec<String> = points.collect();
    let points = points.join(", ");
    format!("kind = \"path\"\nunit = \"mm\"\nclosed = true\npoints = [{points}]\n")
}

#[test]
fn ctrl_c_stops_synthesis_and_prints_results_so_far() {
    let file = concat!(env!("CARGO_TARGET_TMPDIR"), "/long-path.toml");
    std::fs::write(file, long_task()).unwrap();
    let script = format!("trap : INT; $KRANK synthesize {file} > {file}.txt; echo code $?");
    let mut terminal = Terminal::run(&script, "xterm", 80);
    terminal.wait_for(" %");
    terminal.type_in("\x03");
    terminal.wait_for("code ");
    let left = terminal.contents();
    // The exit code is 0 or 1, as after a complete search, depending on whether a linkage was found.
    assert!(left.contains("stopped: the results so far"), "{left}");
    let code = left.rsplit("code ").next().unwrap_or_default().trim();
    assert!(["0", "1"].contains(&code), "{left}");
    let output = std::fs::read_to_string(format!("{file}.txt")).unwrap();
    assert!(output.contains("long-path"), "{output}");
}

/// A search that takes much longer than until its first progress line.
const LONG_SOLVE: &str = "$KRANK solve jansen-leg --minimize T.x.stroke --keep 'T.y.stroke>=20' \
    --generations 100000 --vary m.length=10..16,j.length=40..55,bde.length=35..50,\
    k.length=55..70,c.length=35..45,f.length=35..45,ghi.length=30..45";

/// Regression test: the best design so far was lost, later only after SIGTERM and SIGHUP. The two
/// may arrive twice: from `timeout`, and from the shell of a closed terminal.
#[test]
fn first_signal_stops_solve_and_writes_the_best_so_far() {
    use rustix::process::{Pid, Signal, kill_process};
    let file = concat!(env!("CARGO_TARGET_TMPDIR"), "/stopped-solve");
    for signal in [Signal::INT, Signal::TERM, Signal::HUP] {
        let _ = std::fs::remove_file(format!("{file}.toml"));
        let solve = LONG_SOLVE.replacen("$KRANK", "exec $KRANK", 1);
        let solve = format!("echo $$ > {file}.pid; {solve} -o {file}.toml > {file}.txt");
        let script = format!("trap : INT TERM HUP; ( trap - TERM HUP; {solve} ); echo code $?");
        let script = script.replace("echo $$", "sh -c 'echo $PPID'");
        let mut terminal = Terminal::run(&script, "xterm", 100);
        terminal.wait_for("  best ");
        assert!(!terminal.contents().contains("limits not met"));
        if signal == Signal::INT {
            terminal.type_in("\x03");
        } else {
            let pid = std::fs::read_to_string(format!("{file}.pid")).unwrap();
            let pid = Pid::from_raw(pid.trim().parse().unwrap()).unwrap();
            kill_process(pid, signal).unwrap();
            // The program may have ended.
            let _ = kill_process(pid, Signal::HUP);
        }
        terminal.wait_for("code ");
        let left = terminal.contents();
        assert!(left.contains("stopped: the results so far"), "{left}");
        assert!(left.contains("code 0"), "{signal:?}: {left}");
        let output = std::fs::read_to_string(format!("{file}.txt")).unwrap();
        assert!(output.contains("m.length"), "{output}");
        let scene = std::fs::read_to_string(format!("{file}.toml")).unwrap();
        assert!(scene.contains("[links]"), "{scene}");
    }
}

/// A closed terminal accepts no output, like a full disk; the design is saved nevertheless.
#[test]
fn solve_saves_its_design_if_it_cannot_be_printed() {
    let file = concat!(env!("CARGO_TARGET_TMPDIR"), "/unprinted-solve.toml");
    let goals = [
        vec!["--goal", "r4.angle.swing=45"],
        vec!["--minimize", "r4.angle.swing", "--generations", "2"],
    ];
    for goal in goals {
        let _ = std::fs::remove_file(file);
        let vary = ["solve", "four-bar", "--vary", "r2.length=90..110"];
        let status = std::process::Command::new(env!("CARGO_BIN_EXE_krank"))
            .args(vary)
            .args(&goal)
            .args(["-o", file])
            .stdout(std::fs::File::create("/dev/full").unwrap())
            .stderr(std::process::Stdio::null())
            .status()
            .unwrap();
        assert_eq!(status.code(), Some(1), "{goal:?}");
        let scene = std::fs::read_to_string(file).unwrap();
        assert!(scene.contains("[links]"), "{scene}");
    }
}

/// The stroke cannot reach the limit: the progress line says so, the exit code is 1, and no scene is written.
#[test]
fn progress_of_solve_says_that_limits_are_not_met() {
    let file = concat!(env!("CARGO_TARGET_TMPDIR"), "/unmet-solve.toml");
    let _ = std::fs::remove_file(file);
    let solve = LONG_SOLVE.replace("T.y.stroke>=20", "T.y.stroke>=2000");
    assert_ne!(solve, LONG_SOLVE);
    let script = format!("trap : INT; {solve} -o {file} > {file}.txt; echo code $?");
    let mut terminal = Terminal::run(&script, "xterm", 120);
    terminal.wait_for(" cm, limits not met");
    terminal.type_in("\x03");
    terminal.wait_for("code ");
    let left = terminal.contents();
    assert!(left.contains("no design meets all limits"), "{left}");
    assert!(left.contains("code 1"), "{left}");
    assert!(!std::fs::exists(file).unwrap());
}

/// Messages go to a file, and there is no progress line.
#[test]
fn interrupt_stops_solve_without_a_terminal() {
    let file = concat!(env!("CARGO_TARGET_TMPDIR"), "/unseen-solve");
    let script = format!("exec {LONG_SOLVE} > {file}.txt 2> {file}.err");
    let mut child = std::process::Command::new("/bin/sh")
        .args(["-c", &script])
        .env("KRANK", env!("CARGO_BIN_EXE_krank"))
        .env("LC_ALL", "C")
        .spawn()
        .unwrap();
    let pid = rustix::process::Pid::from_child(&child);
    let is_caught = || {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
        assert!(!status.contains("zombie"), "it ended");
        // The shell has its own handlers until it is replaced by the program.
        if !status.starts_with("Name:\tkrank\n") {
            return false;
        }
        let mask = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
        let mask = mask.map(|mask| u64::from_str_radix(mask.trim(), 16).unwrap());
        mask.is_some_and(|mask| mask & 2 != 0)
    };
    while !is_caught() {
        thread::yield_now();
    }
    rustix::process::kill_process(pid, rustix::process::Signal::INT).unwrap();
    let status = child.wait().unwrap();
    // The program exits by itself instead of being killed by the signal.
    assert!(status.code().is_some(), "{status:?}");
    let output = std::fs::read_to_string(format!("{file}.err")).unwrap();
    assert!(output.contains("stopped: the results so far"), "{output}");
}
