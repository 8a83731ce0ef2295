//! A program on its own pseudo-terminal, with an emulated screen at the other end.

use portable_pty::{
    Child, CommandBuilder, ExitStatus, MasterPty, PtySize, SlavePty, native_pty_system,
};
use rustix::fs::{Mode, OFlags};
use rustix::process::{Pid, Signal, kill_process};
use std::io::{Read, Write};
use std::num::NonZeroU16;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// A wait longer than this means that the program hangs, even on a busy machine.
pub(crate) const PATIENCE: Duration = Duration::from_secs(120);
/// Keys without an effect are sent again after this time.
const AGAIN: Duration = Duration::from_secs(2);
pub(crate) const QUESTION: &[u8] = b"\x1b[5n";
const ANSWER: &[u8] = b"\x1b[0n";

/// Bytes per second of a line with 9,600 baud.
const SLOW_LINE_RATE: usize = 960;

/// The output received from the program.
pub(crate) struct Seen {
    pub(crate) terminal: vt100::Parser,
    pub(crate) bytes: Vec<u8>,
}

impl Seen {
    pub(crate) fn new(cols: u16, rows: u16) -> Self {
        Seen {
            terminal: emulator(cols, rows),
            bytes: Vec::new(),
        }
    }

    /// Returns `true` if the last frame has arrived completely.
    pub(crate) fn is_between_frames(&self) -> bool {
        let last = |sequence: &[u8]| {
            let mut all = self.bytes.windows(sequence.len());
            all.rposition(|bytes| bytes == sequence)
        };
        last(b"\x1b[?2026h") < last(b"\x1b[?2026l")
    }

    pub(crate) fn take(&mut self, bytes: &[u8]) {
        self.bytes.extend_from_slice(bytes);
        self.terminal.process(bytes);
    }

    pub(crate) fn rows(&self) -> Vec<String> {
        let screen = self.terminal.screen();
        screen.rows(0, screen.size().1.get()).collect()
    }

    /// Returns the number of occurrences of a byte sequence.
    pub(crate) fn count(&self, sequence: &[u8]) -> usize {
        let windows = self.bytes.windows(sequence.len());
        windows.filter(|bytes| *bytes == sequence).count()
    }
}

/// A program on its own terminal.
pub(crate) struct Session {
    pub(crate) seen: Arc<Mutex<Seen>>,
    keys: Arc<Mutex<Box<dyn Write + Send>>>,
    pub(crate) child: Box<dyn Child + Send + Sync>,
    /// `None` after the line was cut.
    master: Option<Box<dyn MasterPty + Send>>,
    switches: Arc<Switches>,
    /// Kept open, since its modes are read after the program has ended.
    _slave: Box<dyn SlavePty + Send>,
    found: String,
}

/// Switches that control the reader at the other end.
#[derive(Default)]
struct Switches {
    /// Close the line at the next byte.
    cut: AtomicBool,
    /// Read everything without delay.
    hurry: AtomicBool,
    /// Stop answering.
    silent: AtomicBool,
}

/// The behaviour of the terminal at the other end.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum TerminalBehaviour {
    Answers,
    Mute,
    /// Answers and reads 960 bytes per second, like a line with 9,600 baud.
    Slow,
    /// Reads nothing, like a stalled line.
    Stalled,
}

/// The configuration of a session.
pub(crate) struct Setup {
    command: CommandBuilder,
    manner: TerminalBehaviour,
    size: PtySize,
}

impl Setup {
    /// Runs krank with these arguments on an emulator of 80 x 24 that answers.
    pub(crate) fn krank(arguments: &[&str]) -> Self {
        Setup::program(env!("CARGO_BIN_EXE_krank"), arguments)
    }

    /// Runs a script with /bin/sh.
    pub(crate) fn script(script: &str) -> Self {
        Setup::program("/bin/sh", &["-c", script])
    }

    pub(crate) fn program(program: &str, arguments: &[&str]) -> Self {
        let mut command = CommandBuilder::new(program);
        command.args(arguments);
        let usual = [
            ("TERM", "xterm-256color"),
            ("LC_ALL", "C.UTF-8"),
            // There is no configuration, no state of earlier runs, and no place to write state.
            ("XDG_CONFIG_HOME", "/nowhere/configuration"),
            ("XDG_STATE_HOME", "/dev/null/state"),
        ];
        for (name, value) in usual {
            command.env(name, value);
        }
        // A backtrace would push the message off the screen.
        for name in ["NO_COLOR", "COLORTERM", "RUST_BACKTRACE", "KRANK_FAULT"] {
            command.env_remove(name);
        }
        Setup {
            command,
            manner: TerminalBehaviour::Answers,
            size: size(80, 24),
        }
    }

    pub(crate) fn manner(mut self, manner: TerminalBehaviour) -> Self {
        self.manner = manner;
        self
    }

    pub(crate) fn env(mut self, name: &str, value: &str) -> Self {
        self.command.env(name, value);
        self
    }

    pub(crate) fn without(mut self, name: &str) -> Self {
        self.command.env_remove(name);
        self
    }

    pub(crate) fn size(mut self, cols: u16, rows: u16) -> Self {
        self.size = size(cols, rows);
        self
    }

    pub(crate) fn start(self) -> Session {
        let pair = native_pty_system().openpty(self.size).unwrap();
        let found = modes(&*pair.master);
        let child = pair.slave.spawn_command(self.command).unwrap();
        let (cols, rows) = (self.size.cols.max(1), self.size.rows.max(1));
        let seen = Arc::new(Mutex::new(Seen::new(cols, rows)));
        let keys = Arc::new(Mutex::new(pair.master.take_writer().unwrap()));
        let reader = pair.master.try_clone_reader().unwrap();
        let (screen, answers) = (Arc::clone(&seen), Arc::clone(&keys));
        let switches = Arc::new(Switches::default());
        let (manner, output) = (self.manner, Arc::clone(&switches));
        thread::spawn(move || watch(reader, &screen, &answers, manner, &output));
        Session {
            seen,
            keys,
            child,
            master: Some(pair.master),
            switches,
            _slave: pair.slave,
            found,
        }
    }
}

impl Session {
    pub(crate) fn krank(arguments: &[&str]) -> Session {
        Setup::krank(arguments).start()
    }

    pub(crate) fn send(&self, keys: &str) {
        self.send_bytes(keys.as_bytes());
    }

    pub(crate) fn send_bytes(&self, bytes: &[u8]) {
        self.keys.lock().unwrap().write_all(bytes).unwrap();
    }

    /// Sends bytes to a program that may have ended.
    pub(crate) fn send_if_there(&self, bytes: &[u8]) {
        let _ = self.keys.lock().unwrap().write_all(bytes);
    }

    /// Makes the terminal stop answering.
    pub(crate) fn stop_answering(&self) {
        self.switches.silent.store(true, Ordering::SeqCst);
    }

    pub(crate) fn screen(&self) -> String {
        let seen = self.seen.lock().unwrap();
        seen.terminal.screen().contents()
    }

    pub(crate) fn bytes(&self) -> usize {
        self.seen.lock().unwrap().bytes.len()
    }

    /// Waits until the screen shows `text`.
    pub(crate) fn wait_for(&self, text: &str) -> &Self {
        self.wait_until(text, |seen| {
            seen.terminal.screen().contents().contains(text)
        });
        self
    }

    pub(crate) fn wait_until(&self, what: &str, holds: impl Fn(&Seen) -> bool) {
        let end = Instant::now() + PATIENCE;
        while !holds(&self.seen.lock().unwrap()) {
            assert!(Instant::now() < end, "no {what} on\n{}", self.screen());
            thread::sleep(Duration::from_millis(5));
        }
    }

    /// Sends keys until a condition holds, and again if they had no effect for a while: a program
    /// that has not yet read the previous input may take them for a part of it.
    pub(crate) fn send_until(&self, keys: &str, what: &str, holds: impl Fn(&Seen) -> bool) {
        let end = Instant::now() + PATIENCE;
        while Instant::now() < end {
            self.send(keys);
            let next = Instant::now() + AGAIN;
            while Instant::now() < next {
                if holds(&self.seen.lock().unwrap()) {
                    return;
                }
                thread::sleep(Duration::from_millis(5));
            }
        }
        panic!("no {what} on\n{}", self.screen());
    }

    /// Waits until no output has arrived for a while: a shorter time if the program sleeps. A
    /// program that measures in the background never sleeps.
    pub(crate) fn settle(&self) {
        let (mut last, mut quiet) = (self.bytes(), 0);
        while quiet < 3 || (quiet < 40 && !self.sleeps()) {
            thread::sleep(Duration::from_millis(50));
            let now = self.bytes();
            quiet = if now == last { quiet + 1 } else { 0 };
            last = now;
        }
    }

    /// Returns `true` if no thread of the program runs or waits for a processor.
    fn sleeps(&self) -> bool {
        let tasks = format!("/proc/{}/task", self.pid().as_raw_nonzero());
        let Ok(tasks) = std::fs::read_dir(tasks) else {
            return true;
        };
        let stats = tasks.filter_map(|task| {
            let stat = std::fs::read_to_string(task.ok()?.path().join("stat")).ok()?;
            stat.rsplit(')').next()?.trim_start().chars().next()
        });
        stats.into_iter().all(|state| state != 'R')
    }

    /// Waits until all output has arrived, by writing a mark after it.
    fn drain(&self) {
        const MARK: &[u8] = b"\x1b]9999;end\x07";
        let name = self.master.as_ref().and_then(|master| master.tty_name());
        let flags = OFlags::WRONLY | OFlags::NOCTTY;
        let line = rustix::fs::open(name.unwrap(), flags, Mode::empty()).unwrap();
        self.read_without_delay();
        rustix::io::write(&line, MARK).unwrap();
        // After the program's end, the line echoes an answer that came too late, also behind the mark.
        let end = |seen: &Seen| seen.bytes.windows(MARK.len()).rposition(|b| b == MARK);
        self.wait_until("end", |seen| end(seen).is_some());
        let mut seen = self.seen.lock().unwrap();
        let length = end(&seen).unwrap();
        seen.bytes.truncate(length);
    }

    pub(crate) fn pid(&self) -> Pid {
        let pid = i32::try_from(self.child.process_id().unwrap()).unwrap();
        Pid::from_raw(pid).unwrap()
    }

    pub(crate) fn signal(&self, signal: Signal) {
        kill_process(self.pid(), signal).unwrap();
    }

    /// Sets the size that the program sees, independently of the screen's size.
    pub(crate) fn set_reported_size(&self, cols: u16, rows: u16) {
        let size = size(cols, rows);
        self.master.as_ref().unwrap().resize(size).unwrap();
    }

    pub(crate) fn resize(&self, cols: u16, rows: u16) {
        // The old screen must not receive what is drawn for the new size.
        let mut seen = self.seen.lock().unwrap();
        self.set_reported_size(cols, rows);
        if cols > 0 && rows > 0 {
            seen.terminal = emulator(cols, rows);
        }
    }

    /// Replaces the screen by an empty one.
    pub(crate) fn wipe(&self) {
        self.seen.lock().unwrap().terminal = emulator(80, 24);
    }

    /// Closes all descriptors of the terminal's end.
    pub(crate) fn hang_up(&mut self) {
        self.switches.cut.store(true, Ordering::SeqCst);
        self.interrupt_reader();
        *self.keys.lock().unwrap() = Box::new(std::io::sink());
        self.master = None;
    }

    /// Sends one byte to the reader thread: it owns a copy of the line, and closes it only after a read.
    fn interrupt_reader(&self) {
        let line = self.master.as_deref().and_then(MasterPty::tty_name);
        let flags = OFlags::WRONLY | OFlags::NOCTTY | OFlags::NONBLOCK;
        let line = rustix::fs::open(line.unwrap(), flags, Mode::empty()).unwrap();
        // A full line wakes the reader as well.
        let _ = rustix::io::write(line, b"\0");
    }

    /// Releases a stalled reader.
    pub(crate) fn release(&self) {
        self.switches.cut.store(true, Ordering::SeqCst);
    }

    /// Makes a slow terminal read everything without delay.
    pub(crate) fn read_without_delay(&self) {
        self.switches.hurry.store(true, Ordering::SeqCst);
    }

    /// Sends Ctrl-C until the program has ended.
    pub(crate) fn ended_by_ctrl_c(&mut self) -> ExitStatus {
        let end = Instant::now() + PATIENCE;
        loop {
            self.send_if_there(b"\x03");
            let next = Instant::now() + AGAIN;
            while Instant::now() < next {
                if let Some(status) = self.child.try_wait().unwrap() {
                    self.drain();
                    self.as_found();
                    return status;
                }
                thread::sleep(Duration::from_millis(5));
            }
            assert!(Instant::now() < end, "it never hears\n{}", self.screen());
        }
    }

    pub(crate) fn ended(&mut self) -> ExitStatus {
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

    /// Waits for the end of the program and checks that the terminal is restored.
    pub(crate) fn ended_as_found(&mut self) -> ExitStatus {
        let status = self.ended();
        self.drain();
        self.as_found();
        status
    }

    /// Checks that the line has its original modes.
    pub(crate) fn line_as_found(&self) {
        assert_eq!(modes(self.master.as_deref().unwrap()), self.found);
    }

    pub(crate) fn as_found(&self) {
        self.line_as_found();
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
    manner: TerminalBehaviour,
    switches: &Switches,
) {
    let mut complete = [0; 4096];
    let buffer = match manner {
        TerminalBehaviour::Slow => &mut complete[..32],
        TerminalBehaviour::Answers | TerminalBehaviour::Mute | TerminalBehaviour::Stalled => {
            &mut complete[..]
        }
    };
    while manner == TerminalBehaviour::Stalled && !switches.cut.load(Ordering::SeqCst) {
        thread::sleep(Duration::from_millis(5));
    }
    while let Ok(n @ 1..) = reader.read(buffer) {
        if switches.cut.load(Ordering::SeqCst) {
            return;
        }
        let hurry = switches.hurry.load(Ordering::SeqCst);
        if manner == TerminalBehaviour::Slow && !hurry {
            thread::sleep(Duration::from_secs_f64(n as f64 / SLOW_LINE_RATE as f64));
        }
        let mut seen = seen.lock().unwrap();
        let from = seen.bytes.len().saturating_sub(QUESTION.len() - 1);
        seen.take(&buffer[..n]);
        let new = seen.bytes[from..].windows(QUESTION.len());
        let questions = new.filter(|bytes| *bytes == QUESTION).count();
        drop(seen);
        let answers = matches!(manner, TerminalBehaviour::Answers | TerminalBehaviour::Slow);
        if answers && questions > 0 && !switches.silent.load(Ordering::SeqCst) {
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
