//! Tests of the scene's file and of unsaved edits, with the real binary on a pseudo-terminal.

use crate::session::PATIENCE;
use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};
use std::fs;
use std::io::{Read, Write};
use std::num::NonZeroU16;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// A program on its own terminal.
struct Session {
    terminal: Arc<Mutex<vt100::Parser>>,
    keys: Box<dyn Write + Send>,
    child: Box<dyn Child + Send + Sync>,
    _master: Box<dyn MasterPty + Send>,
}

impl Session {
    /// Runs a shell line in which `$KRANK` is the program, with its state in the folder.
    fn run(folder: &Path, line: &str) -> Session {
        let mut command = CommandBuilder::new("/bin/sh");
        command.args(["-c", line]);
        command.env("KRANK", env!("CARGO_BIN_EXE_krank"));
        command.env("HOME", folder);
        command.env("XDG_STATE_HOME", folder.join("state"));
        command.env("XDG_CONFIG_HOME", folder.join("config"));
        command.env("TERM", "xterm-256color");
        command.env("LC_ALL", "C.UTF-8");
        command.cwd(folder);
        let size = PtySize {
            rows: 24,
            cols: 80,
            pixel_width: 0,
            pixel_height: 0,
        };
        let pair = native_pty_system().openpty(size).unwrap();
        let child = pair.slave.spawn_command(command).unwrap();
        let [rows, cols] = [24, 80].map(|n| NonZeroU16::new(n).unwrap());
        let terminal = Arc::new(Mutex::new(vt100::Parser::new(rows, cols, 0)));
        let mut reader = pair.master.try_clone_reader().unwrap();
        let seen = Arc::clone(&terminal);
        thread::spawn(move || {
            let mut buffer = [0; 4096];
            while let Ok(n @ 1..) = reader.read(&mut buffer) {
                seen.lock().unwrap().process(&buffer[..n]);
            }
        });
        Session {
            terminal,
            keys: pair.master.take_writer().unwrap(),
            child,
            _master: pair.master,
        }
    }

    fn send(&mut self, keys: &str) -> &mut Self {
        self.keys.write_all(keys.as_bytes()).unwrap();
        self
    }

    fn screen(&self) -> String {
        self.terminal.lock().unwrap().screen().contents()
    }

    fn wait_for(&mut self, text: &str) -> &mut Self {
        let end = Instant::now() + PATIENCE;
        while !self.screen().contains(text) {
            assert!(Instant::now() < end, "no {text} on\n{}", self.screen());
            thread::sleep(Duration::from_millis(5));
        }
        self
    }

    /// Answers a question. Keys typed before a user can have read it are ignored.
    fn answer(&mut self, key: &str, question: &str) -> &mut Self {
        self.wait_for(question);
        thread::sleep(Duration::from_millis(500));
        let end = Instant::now() + PATIENCE;
        while self.screen().contains(question) {
            assert!(Instant::now() < end, "still asks\n{}", self.screen());
            self.send(key);
            let next = Instant::now() + Duration::from_secs(2);
            while Instant::now() < next && self.screen().contains(question) {
                thread::sleep(Duration::from_millis(5));
            }
        }
        self
    }

    fn ended(&mut self) -> bool {
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.success();
            }
            assert!(Instant::now() < end, "still there with\n{}", self.screen());
            thread::sleep(Duration::from_millis(5));
        }
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        let _ = self.child.kill();
    }
}

/// Creates a folder with a scene, and returns both paths.
fn folder(name: &str) -> (PathBuf, PathBuf) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("pty-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("mine.toml");
    fs::write(&file, four_bar()).unwrap();
    (folder, file)
}

fn four_bar() -> &'static str {
    krank::scene::presets::find("four-bar").unwrap().text
}

/// Selects the crank's length and changes it to 101.
const EDIT: &str = "6/r2 len\r>";
const EDITED: &str = "*r2 length     101     mm";

#[test]
fn unsaved_edits_survive_any_signal() {
    let (folder, file) = folder("killed");
    for signal in [9, 15, 1] {
        let mut session = Session::run(&folder, "exec $KRANK mine.toml");
        session.wait_for("60.00 deg").send(EDIT).wait_for(EDITED);
        let pid = session.child.process_id().unwrap();
        let killed = std::process::Command::new("kill")
            .args([format!("-{signal}"), pid.to_string()])
            .status();
        assert!(killed.unwrap().success());
        assert!(!session.ended());
        assert_eq!(fs::read_to_string(&file).unwrap(), four_bar());
        // Started again from another folder: it is the same file.
        let mut session = Session::run(&folder, "cd / && exec $KRANK \"$HOME/mine.toml\"");
        session.answer("t", "t take");
        session.send("6/r2 len\r").wait_for(EDITED);
        session
            .send("u")
            .wait_for("r2 length     100     mm")
            .send("q");
        assert!(session.ended(), "nothing is unsaved");
        // The edits were undone, but not discarded.
        let mut session = Session::run(&folder, "exec $KRANK mine.toml");
        session.answer("dd", "t take");
        session.wait_for("edits deleted").send("q");
        assert!(session.ended());
    }
    // There are no more edits to offer.
    let mut session = Session::run(&folder, "exec $KRANK mine.toml");
    session.wait_for("? help").send("q");
    assert!(session.ended());
}

#[test]
fn change_on_disk_is_shown_without_a_key() {
    let (folder, file) = folder("changed");
    let mut session = Session::run(&folder, "exec $KRANK mine.toml");
    session
        .wait_for("60.00 deg")
        .send("6/r2 len\r")
        .wait_for("nudge by 1 mm");
    let text = |length: &str| four_bar().replace("length = 100", &format!("length = {length}"));
    fs::write(&file, text("123")).unwrap();
    session.wait_for("r2 length     123     mm");
    // Like most editors, replaces the file by another one.
    let other = folder.join("other.toml");
    fs::write(&other, text("124")).unwrap();
    fs::rename(&other, &file).unwrap();
    session.wait_for("r2 length     124     mm");
    session.send(">").wait_for("*r2 length     125     mm");
    fs::write(&file, text("126")).unwrap();
    session.wait_for("has changed on disk");
    assert!(session.screen().contains("*r2 length     125     mm"));
    session.send("R").wait_for("unsaved edits?").send("\r");
    session.wait_for("r2 length     126     mm").send("q");
    assert!(session.ended());
}

/// The limit on the file size is 0 blocks, as on a full disk.
#[test]
fn full_disk_keeps_file_and_edits() {
    let (folder, file) = folder("full");
    let line = "trap '' XFSZ; ulimit -f 0; exec $KRANK mine.toml";
    let mut session = Session::run(&folder, line);
    session.wait_for("60.00 deg").send(EDIT).wait_for(EDITED);
    session.wait_for("edits are not kept for recovery");
    session.send("w").wait_for("not written, ");
    assert!(session.screen().contains(EDITED));
    assert_eq!(fs::read_to_string(&file).unwrap(), four_bar());
    session.send("q").wait_for("unsaved edits").send("q");
    assert!(session.ended());
    let left: Vec<_> = fs::read_dir(&folder).unwrap().collect();
    assert_eq!(
        left.len(),
        2,
        "nothing but the scene and the state: {left:?}"
    );
}

/// Regression test: without a home, edits were lost without a warning.
#[test]
fn missing_home_warns_that_edits_are_not_kept() {
    for home in ["HOME=", "HOME=relative"] {
        let (folder, _) = folder("homeless");
        let line = format!("export {home}; unset XDG_STATE_HOME; exec $KRANK mine.toml");
        let mut session = Session::run(&folder, &line);
        session.wait_for("60.00 deg").send(EDIT).wait_for(EDITED);
        session.wait_for("edits are not kept for recovery: set HOME");
        session.send("q").wait_for("unsaved edits").send("q");
        assert!(session.ended());
    }
}

#[test]
fn quitting_asks_to_save_unsaved_edits() {
    let (folder, file) = folder("asked");
    let mut session = Session::run(&folder, "exec $KRANK mine.toml");
    session.wait_for("60.00 deg").send(EDIT).wait_for(EDITED);
    session.send("q").wait_for("unsaved edits").send("w");
    assert!(session.ended());
    let expected = four_bar().replace("length = 100", "length = 101");
    assert_eq!(fs::read_to_string(&file).unwrap(), expected);
    let kept = folder.join("state/krank/recovery");
    assert_eq!(fs::read_dir(kept).unwrap().count(), 0);
}
