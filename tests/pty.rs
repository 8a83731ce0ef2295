//! The real binary on a pseudo-terminal, with an emulated screen at the other end: opening, moving,
//! resizing, stopping, leaving and losing the line. What is asked most often: is the terminal as it was?
#![cfg(all(feature = "tui", target_os = "linux"))]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use portable_pty::{
    Child, CommandBuilder, ExitStatus, MasterPty, PtySize, SlavePty, native_pty_system,
};
use rustix::process::{Pid, Signal, kill_process};
use std::io::{Read, Write};
use std::num::NonZeroU16;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// On a machine with much else to do everything takes its time.
const PATIENCE: Duration = Duration::from_secs(20);
const QUESTION: &[u8] = b"\x1b[5n";
const ANSWER: &[u8] = b"\x1b[0n";

/// What has come from the program.
struct Seen {
    terminal: vt100::Parser,
    bytes: Vec<u8>,
}

/// A program on a terminal of its own.
struct Session {
    seen: Arc<Mutex<Seen>>,
    keys: Arc<Mutex<Box<dyn Write + Send>>>,
    child: Box<dyn Child + Send + Sync>,
    /// `None` once the line was cut.
    master: Option<Box<dyn MasterPty + Send>>,
    /// Tells the reader to close its end at the next byte.
    cut: Arc<AtomicBool>,
    /// Kept open: the modes are asked for after the program has left.
    _slave: Box<dyn SlavePty + Send>,
    found: String,
}

/// How the terminal at the other end behaves.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Manner {
    Answers,
    Mute,
    /// Answers, and takes 960 bytes a second, as a line of 9,600 baud.
    Slow,
    /// Takes nothing at all, as a line that hangs.
    Stalled,
}

impl Session {
    fn krank(arguments: &[&str]) -> Session {
        let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_krank"));
        command.args(arguments);
        Session::start(command, Manner::Answers)
    }

    fn start(mut command: CommandBuilder, manner: Manner) -> Session {
        for (name, value) in [("TERM", "xterm-256color"), ("LC_ALL", "C.UTF-8")] {
            if command.get_env(name).is_none_or(|given| given != "dumb") {
                command.env(name, value);
            }
        }
        command.env_remove("NO_COLOR");
        // Neither the configuration nor the first start of whoever runs this matters.
        for name in ["XDG_CONFIG_HOME", "XDG_STATE_HOME"] {
            if command
                .get_env(name)
                .is_none_or(|given| !given.to_string_lossy().contains("pty-"))
            {
                command.env(name, "/nowhere");
            }
        }
        // A backtrace would push what is told off the screen.
        command.env_remove("RUST_BACKTRACE");
        let pair = native_pty_system().openpty(size(80, 24)).unwrap();
        let found = modes(&*pair.master);
        let child = pair.slave.spawn_command(command).unwrap();
        let seen = Arc::new(Mutex::new(Seen {
            terminal: emulator(80, 24),
            bytes: Vec::new(),
        }));
        let keys = Arc::new(Mutex::new(pair.master.take_writer().unwrap()));
        let reader = pair.master.try_clone_reader().unwrap();
        let (screen, answers) = (Arc::clone(&seen), Arc::clone(&keys));
        let cut = Arc::new(AtomicBool::new(false));
        let ends = Arc::clone(&cut);
        thread::spawn(move || watch(reader, &screen, &answers, manner, &ends));
        Session {
            seen,
            keys,
            child,
            master: Some(pair.master),
            cut,
            _slave: pair.slave,
            found,
        }
    }

    fn send(&self, keys: &str) {
        self.keys
            .lock()
            .unwrap()
            .write_all(keys.as_bytes())
            .unwrap();
    }

    fn screen(&self) -> String {
        let seen = self.seen.lock().unwrap();
        seen.terminal.screen().contents()
    }

    fn bytes(&self) -> usize {
        self.seen.lock().unwrap().bytes.len()
    }

    /// Waits until the screen shows `text`.
    fn wait_for(&self, text: &str) -> &Self {
        self.wait_until(text, |seen| {
            seen.terminal.screen().contents().contains(text)
        });
        self
    }

    fn wait_until(&self, what: &str, holds: impl Fn(&Seen) -> bool) {
        let end = Instant::now() + PATIENCE;
        while !holds(&self.seen.lock().unwrap()) {
            assert!(Instant::now() < end, "no {what} on\n{}", self.screen());
            thread::sleep(Duration::from_millis(5));
        }
    }

    /// Waits until nothing has come for a while.
    fn settle(&self) {
        let mut last = self.bytes();
        loop {
            thread::sleep(Duration::from_millis(150));
            let now = self.bytes();
            if now == last {
                return;
            }
            last = now;
        }
    }

    fn signal(&self, signal: Signal) {
        let pid = i32::try_from(self.child.process_id().unwrap()).unwrap();
        kill_process(Pid::from_raw(pid).unwrap(), signal).unwrap();
    }

    fn resize(&self, cols: u16, rows: u16) {
        let size = size(cols, rows);
        self.master.as_ref().unwrap().resize(size).unwrap();
        if cols > 0 && rows > 0 {
            self.seen.lock().unwrap().terminal = emulator(cols, rows);
        }
    }

    /// Closes every descriptor of the other end.
    fn hang_up(&mut self) {
        self.cut.store(true, Ordering::SeqCst);
        *self.keys.lock().unwrap() = Box::new(std::io::sink());
        self.master = None;
    }

    fn ended(&mut self) -> ExitStatus {
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status;
            }
            assert!(
                Instant::now() < end,
                "still running with\n{}",
                self.screen()
            );
            thread::sleep(Duration::from_millis(5));
        }
    }

    /// Waits for the end, and sees to it that nothing was left behind.
    fn ended_as_found(&mut self) -> ExitStatus {
        let status = self.ended();
        self.settle();
        self.as_found();
        status
    }

    fn as_found(&self) {
        assert_eq!(modes(self.master.as_deref().unwrap()), self.found);
        let seen = self.seen.lock().unwrap();
        let screen = seen.terminal.screen();
        assert!(!screen.alternate_screen(), "left on the alternate screen");
        assert!(!screen.hide_cursor(), "the cursor stays hidden");
        assert!(!screen.bracketed_paste(), "pastes stay marked");
        assert_eq!(screen.fgcolor(), vt100::Color::Default);
        assert!(!screen.bold() && !screen.inverse());
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        let _ = self.child.kill();
    }
}

fn watch(
    mut reader: Box<dyn Read + Send>,
    seen: &Mutex<Seen>,
    keys: &Mutex<Box<dyn Write + Send>>,
    manner: Manner,
    cut: &AtomicBool,
) {
    let mut whole = [0; 4096];
    let buffer = match manner {
        Manner::Slow => &mut whole[..32],
        Manner::Answers | Manner::Mute | Manner::Stalled => &mut whole[..],
    };
    while manner == Manner::Stalled && !cut.load(Ordering::SeqCst) {
        thread::sleep(Duration::from_millis(5));
    }
    while let Ok(n @ 1..) = reader.read(buffer) {
        if cut.load(Ordering::SeqCst) {
            return;
        }
        let mut seen = seen.lock().unwrap();
        let from = seen.bytes.len().saturating_sub(QUESTION.len() - 1);
        seen.bytes.extend_from_slice(&buffer[..n]);
        seen.terminal.process(&buffer[..n]);
        let new = seen.bytes[from..].windows(QUESTION.len());
        let questions = new.filter(|bytes| *bytes == QUESTION).count();
        drop(seen);
        if manner == Manner::Slow {
            thread::sleep(Duration::from_secs_f64(n as f64 / 960.0));
        }
        if matches!(manner, Manner::Answers | Manner::Slow) && questions > 0 {
            let _ = keys.lock().unwrap().write_all(&ANSWER.repeat(questions));
        }
    }
}

fn size(cols: u16, rows: u16) -> PtySize {
    PtySize {
        rows,
        cols,
        pixel_width: 0,
        pixel_height: 0,
    }
}

fn emulator(cols: u16, rows: u16) -> vt100::Parser {
    let [rows, cols] = [rows, cols].map(|n| NonZeroU16::new(n).unwrap());
    vt100::Parser::new(rows, cols, 0)
}

fn modes(master: &dyn MasterPty) -> String {
    format!("{:?}", master.get_termios().unwrap())
}

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
fn a_scene_from_standard_input_leaves_the_keys_to_the_terminal() {
    let krank = env!("CARGO_BIN_EXE_krank");
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/presets/slider-crank.toml");
    let mut command = CommandBuilder::new("/bin/sh");
    command.args(["-c", &format!("exec {krank} - --at 45 < '{scene}'")]);
    let mut session = Session::start(command, Manner::Answers);
    session.wait_for("stdin").wait_for("45.00 deg").send(".");
    session.wait_for("50.00 deg").send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn nothing_is_written_while_paused() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg");
    session.settle();
    let before = session.bytes();
    thread::sleep(Duration::from_millis(600));
    assert_eq!(session.bytes(), before);
    session.send("\x03");
    assert!(session.ended_as_found().success());
}

#[test]
fn follows_the_size_of_its_window() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg");
    session.resize(40, 12);
    session.wait_for("60.00 deg ok");
    session.resize(20, 5);
    session.wait_for("krank needs 40 x 12");
    for n in 0..50 {
        session.resize(n * 5, n % 30);
    }
    session.resize(0, 0);
    session.resize(120, 40);
    session.wait_for("? help").send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn a_signal_ends_it_with_the_terminal_as_found() {
    for (signal, number) in [(Signal::TERM, 15), (Signal::INT, 2), (Signal::HUP, 1)] {
        let mut session = Session::krank(&["four-bar"]);
        session.wait_for("60.00 deg").send(" ");
        session.wait_for("pause");
        session.signal(signal);
        let status = session.ended_as_found();
        assert!(!status.success(), "whoever waits learns of signal {number}");
    }
}

#[test]
fn a_lost_line_ends_it() {
    let krank = env!("CARGO_BIN_EXE_krank");
    // The second as under `nohup`: no signal tells it.
    for script in ["exec", "trap '' HUP; exec"] {
        let mut command = CommandBuilder::new("/bin/sh");
        command.args(["-c", &format!("{script} {krank} four-bar")]);
        let mut session = Session::start(command, Manner::Mute);
        session.wait_for("60.00 deg").send(" ");
        session.wait_for("pause");
        session.hang_up();
        session.ended();
    }
}

#[test]
fn stopped_from_outside_it_paints_all_again_when_it_goes_on() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg");
    session.settle();
    session.signal(Signal::STOP);
    let anew = emulator(80, 24);
    session.seen.lock().unwrap().terminal = anew;
    session.signal(Signal::CONT);
    session.wait_for("60.00 deg").wait_for("-3.9164").send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn on_a_slow_line_keys_still_show_soon() {
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_krank"));
    command.arg("four-bar");
    let mut session = Session::start(command, Manner::Slow);
    session.wait_for("? help").send(" ");
    // Long enough for 90 frames of 300 bytes, of which the line takes a tenth.
    thread::sleep(Duration::from_secs(3));
    let asked = Instant::now();
    session.send("?");
    session.wait_for("Help");
    let waited = asked.elapsed();
    assert!(waited < Duration::from_secs(2), "{waited:?}");
    session.send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn a_line_that_hangs_does_not_keep_it() {
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_krank"));
    command.arg("four-bar");
    let mut session = Session::start(command, Manner::Stalled);
    session.resize(240, 80);
    // Whole screens until the kernel takes no more.
    for _ in 0..12 {
        thread::sleep(Duration::from_millis(250));
        session.send("2\x0c1\x0c");
    }
    session.signal(Signal::TERM);
    assert!(!session.ended().success());
    assert_eq!(modes(session.master.as_deref().unwrap()), session.found);
    session.cut.store(true, Ordering::SeqCst);
}

/// A shell with job control, as a person has.
fn shell() -> Session {
    let mut command = CommandBuilder::new("/bin/sh");
    command.arg("-i");
    command.env("PS1", "ready> ");
    let session = Session::start(command, Manner::Answers);
    session.wait_for("ready>");
    session
}

#[test]
fn the_shell_gets_its_terminal_while_it_is_stopped() {
    let session = shell();
    let krank = env!("CARGO_BIN_EXE_krank");
    let run = |keys: &str| session.send(keys);
    run(&format!("{krank} four-bar\r"));
    session.wait_for("60.00 deg").send(" ");
    session.wait_for("pause").send("\x1a");
    session.wait_until("main screen", |seen| {
        !seen.terminal.screen().alternate_screen()
    });
    run("echo back$((1 + 1))\r");
    session.wait_for("back2");
    assert!(!session.seen.lock().unwrap().terminal.screen().hide_cursor());
    run("fg\r");
    session.wait_for("pause").send(" ");
    session.wait_for("play").send("q");
    session.wait_until("main screen", |seen| {
        !seen.terminal.screen().alternate_screen()
    });
    run("echo gone$((2 + 2)); exit\r");
    session.wait_for("gone4");
}

#[test]
fn without_a_shell_it_does_not_stop_for_ever() {
    let mut session = Session::krank(&["four-bar"]);
    session.wait_for("60.00 deg").send("\x1a.");
    session.wait_for("65.00 deg").send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn a_panic_is_told_after_the_terminal_was_put_back() {
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_krank"));
    command.arg("four-bar");
    command.env("KRANK_FAULT", "panic");
    // A backtrace would push the message off the screen.
    command.env("RUST_BACKTRACE", "0");
    let mut session = Session::start(command, Manner::Answers);
    assert!(!session.ended_as_found().success());
    session.wait_for("krank is broken: KRANK_FAULT=panic");
}

#[test]
fn a_terminal_that_answers_nothing_is_not_waited_for() {
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_krank"));
    command.arg("four-bar");
    let mut session = Session::start(command, Manner::Mute);
    session.wait_for("60.00 deg").send(".");
    session.wait_for("65.00 deg").send("..");
    session.wait_for("75.00 deg").send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn noise_from_the_line_does_not_make_deaf() {
    let mut session = Session::krank(&["four-bar"]);
    session
        .wait_for("60.00 deg")
        .send("\x1b]\x1b[200~qqq\x1bP\x1b[");
    // A paste without an end is given up after a second of silence.
    thread::sleep(Duration::from_millis(1300));
    session.send("g90\r");
    session.wait_for("90.00 deg").send("q");
    assert!(session.ended_as_found().success());
}

#[test]
fn a_terminal_that_cannot_show_it_is_refused_kindly() {
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_krank"));
    command.arg("four-bar");
    command.env("TERM", "dumb");
    let mut session = Session::start(command, Manner::Mute);
    assert_eq!(session.ended_as_found().exit_code(), 2);
    session.wait_for("krank table");
}

#[test]
fn output_that_is_no_terminal_is_refused_kindly() {
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_krank"))
        .arg("four-bar")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("krank table"), "{told}");
}

/// The first start without a scene begins with the tour; the second does not, nor does one of a scene.
#[test]
fn the_first_start_shows_the_tour_once() {
    let home = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("pty-first-start");
    let _ = std::fs::remove_dir_all(&home);
    let start = |args: &[&str], config: &str| {
        let folder = home.join("config").join("krank");
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("config.toml"), config).unwrap();
        let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_krank"));
        command.args(args);
        command.env("XDG_CONFIG_HOME", home.join("config"));
        command.env("XDG_STATE_HOME", home.join("state"));
        Session::start(command, Manner::Answers)
    };
    let mut quiet = |args: &[&str], config: &str| {
        let mut session = start(args, config);
        session.wait_for("? help");
        assert!(!session.screen().contains("Tour"), "{args:?} {config}");
        session.send("q");
        assert!(session.ended_as_found().success());
    };
    quiet(&["four-bar"], "");
    quiet(&["--at", "30"], "");
    quiet(&[], "tour = false");
    let mut first = start(&[], "");
    first.wait_for("Tour 1/5").send("\r");
    first.wait_for("Tour 2/5").send(".");
    first.wait_for("65.00 deg").send("\x1b");
    first.wait_for("? help").send("q");
    assert!(first.ended_as_found().success());
    quiet(&[], "");
    // A key of the configuration is a key of the program.
    let mut other = start(&["four-bar"], "[keys]\nquit = 'Q'");
    other.wait_for("Q quit").send("q.");
    other.wait_for("65.00 deg").send("Q");
    assert!(other.ended_as_found().success());
}
