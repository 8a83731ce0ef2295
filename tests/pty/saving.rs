//! Tests of saving: kills at any time, several concurrent sessions, and special files.

use crate::session::{Session, Setup};
use rustix::fs::{FlockOperation, flock};
use rustix::process::Signal;
use std::fs::{self, File};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

/// The number of kills in an ordinary run; `KRANK_KILLS=400 cargo test` runs more.
const KILL_COUNT: u64 = 16;
/// Selects the crank's length.
const TO_CRANK: &str = "6/r2 len\r";

fn four_bar() -> &'static str {
    krank::scene::presets::find("four-bar").unwrap().text
}

fn with_crank(length: u32) -> String {
    four_bar().replace("length = 100", &format!("length = {length}"))
}

/// Creates a folder with a scene, and returns both paths.
fn folder(name: &str) -> (PathBuf, PathBuf) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("saving-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("mine.toml");
    fs::write(&file, four_bar()).unwrap();
    (folder, file)
}

/// Starts krank in a folder that also has its state.
fn start_krank(folder: &Path, scene: &str) -> Session {
    let krank = env!("CARGO_BIN_EXE_krank");
    let line = format!("cd '{}' && exec {krank} {scene}", folder.display());
    let state = folder.join("state");
    Setup::script(&line)
        .env("XDG_STATE_HOME", state.to_str().unwrap())
        .start()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let name = |entry: fs::DirEntry| entry.file_name().into_string().unwrap();
    let mut names: Vec<String> = entries.map(|entry| name(entry.unwrap())).collect();
    names.sort();
    names
}

/// Runs another command, which completes interrupted writes.
fn next_start(folder: &Path) {
    let done = Command::new(env!("CARGO_BIN_EXE_krank"))
        .arg("list")
        .env("XDG_STATE_HOME", folder.join("state"))
        .output()
        .unwrap();
    assert!(done.status.success());
}

/// Kills krank while it saves, and checks that owner, group, mode and names stay, and that the text
/// is the old or the new one.
fn killed_while_saving(name: &str, is_linked: bool, kills: u64) {
    let (folder, file) = folder(name);
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    // Only root can change the owner of files.
    let _ = std::os::unix::fs::chown(&file, Some(4321), Some(1234));
    if is_linked {
        fs::hard_link(&file, folder.join("second")).unwrap();
    }
    let rights = |file: &Path| {
        let found = fs::metadata(file).unwrap();
        (found.uid(), found.gid(), found.mode(), found.nlink())
    };
    let before = rights(&file);
    let mut saved = 0;
    for kill in 0..kills {
        // Removes the edits of earlier rounds, so that they are not offered.
        let _ = fs::remove_dir_all(folder.join("state"));
        let old = fs::read_to_string(&file).unwrap();
        let key = if old == four_bar() { ">" } else { "<" };
        let mut session = start_krank(&folder, "mine.toml");
        session.wait_for("60.00 deg").send(TO_CRANK);
        session.wait_for("nudge by 1 mm").send(&format!("{key}w"));
        thread::sleep(Duration::from_micros(kill * 1_777 % 40_000));
        session.signal(Signal::KILL);
        session.ended();
        next_start(&folder);
        let now = fs::read_to_string(&file).unwrap();
        assert!(now == four_bar() || now == with_crank(101), "torn:\n{now}");
        assert_eq!(rights(&file), before, "after {kill}");
        saved += usize::from(now != old);
    }
    eprintln!("{kills} kills, {saved} of them after the file was written");
    // The next save removes all temporary files.
    let _ = fs::remove_dir_all(folder.join("state"));
    let mut session = start_krank(&folder, "mine.toml");
    session.wait_for("60.00 deg").send(TO_CRANK);
    session.wait_for("nudge by 1 mm").send("{>w");
    session.wait_for("written to").send("q");
    assert!(session.ended().success());
    let left = names(&folder);
    let expected: &[&str] = match is_linked {
        true => &["mine.toml", "second", "state"],
        false => &["mine.toml", "state"],
    };
    assert_eq!(left, expected);
}

#[test]
fn kills_while_saving_leave_the_old_or_new_file() {
    let kills = std::env::var("KRANK_KILLS")
        .ok()
        .and_then(|n| n.parse().ok());
    let kills = kills.unwrap_or(KILL_COUNT) / 2;
    thread::scope(|scope| {
        scope.spawn(|| killed_while_saving("killed", false, kills));
        scope.spawn(|| killed_while_saving("killed-linked", true, kills));
    });
}

/// Opens a scene that other sessions have open, and dismisses the warning.
fn join(folder: &Path) -> Session {
    let session = start_krank(folder, "mine.toml");
    session.wait_for("Open elsewhere");
    // Keys typed before a user can have read the question are ignored.
    thread::sleep(Duration::from_millis(500));
    session.send_until("\r", "help", |seen| {
        seen.terminal.screen().contents().contains("? help")
    });
    session
}

fn edit(session: &Session, nudges: usize) {
    session.send(TO_CRANK);
    session.wait_for("nudge by 1 mm").send(&">".repeat(nudges));
    session.wait_for(&format!("*r2 length     {}", 100 + nudges));
}

/// Waits until the edits are stored: on a busy disk, they are on the screen earlier.
fn wait_for_edits(folder: &Path, sessions: usize) {
    let kept = folder.join("state/krank/recovery");
    let end = Instant::now() + crate::session::PATIENCE;
    let is_kept = |n: usize| {
        names(&kept).iter().any(|name| {
            let text = fs::read_to_string(kept.join(name)).unwrap_or_default();
            text.contains(&format!("length = {}", 100 + n))
        })
    };
    while !(1..=sessions).all(is_kept) {
        assert!(Instant::now() < end, "{:?}", names(&kept));
        thread::sleep(Duration::from_millis(5));
    }
}

/// Three sessions on one scene are killed in every order: each keeps its edits and those of the others.
#[test]
fn sessions_killed_in_any_order_keep_all_their_edits() {
    let orders = [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ];
    thread::scope(|scope| {
        for order in orders {
            scope.spawn(move || {
                let (folder, _) = folder(&format!("three-{}{}{}", order[0], order[1], order[2]));
                let first = start_krank(&folder, "mine.toml");
                first.wait_for("? help");
                let mut all = [first, join(&folder), join(&folder)];
                for (n, session) in all.iter().enumerate() {
                    edit(session, n + 1);
                }
                wait_for_edits(&folder, 3);
                for killed in order {
                    all[killed].signal(Signal::KILL);
                    all[killed].ended();
                }
                let mut next = start_krank(&folder, "./mine.toml");
                next.wait_for("Unsaved edits of this scene");
                next.wait_until("three generations", |seen| {
                    let screen = seen.terminal.screen().contents();
                    screen.matches("UTC").count() == 3
                });
                next.send("\x03");
                assert!(next.ended().success());
                let kept = names(&folder.join("state/krank/recovery"));
                assert_eq!(kept.len(), 3, "{kept:?}");
            });
        }
    });
}

/// The session that saves second must confirm, even if the first one is killed; no edits are lost.
#[test]
fn second_of_two_saving_sessions_must_confirm() {
    for (name, kills_first) in [("two", false), ("two-killed", true)] {
        start_with_later_save(name, kills_first);
    }
}

/// The second session is killed while it asks. Its edits are offered with the reason why they do
/// not fit. The reason depends on whether they were made in the same second as the file.
#[test]
fn edits_of_a_killed_second_session_are_offered() {
    for (name, kills_first) in [("later", false), ("later-killed", true)] {
        let folder = start_with_later_save(name, kills_first);
        let mut next = start_krank(&folder, "mine.toml");
        next.wait_until("edits that do not fit", |seen| {
            let screen = seen.terminal.screen().contents();
            screen.contains("Unsaved edits of this scene")
                && (screen.contains("file has changed") || screen.contains("older than the file"))
        });
        next.send("\x03");
        assert!(next.ended().success());
    }
}

fn start_with_later_save(name: &str, kills_first: bool) -> PathBuf {
    let (folder, file) = folder(name);
    let mut one = start_krank(&folder, "mine.toml");
    one.wait_for("? help");
    let mut two = join(&folder);
    edit(&one, 1);
    edit(&two, 2);
    one.send("w");
    two.send("w");
    let end = Instant::now() + crate::session::PATIENCE;
    let is_asked = |session: &Session| session.screen().contains("has changed on disk");
    while !is_asked(&one) && !is_asked(&two) {
        assert!(Instant::now() < end, "{}\n{}", one.screen(), two.screen());
        thread::sleep(Duration::from_millis(5));
    }
    let now = fs::read_to_string(&file).unwrap();
    let (first, second) = match now == with_crank(101) {
        true => (&mut one, &mut two),
        false => (&mut two, &mut one),
    };
    assert!(now == with_crank(101) || now == with_crank(102));
    first.wait_for("written to");
    assert!(is_asked(second), "{}", second.screen());
    if kills_first {
        first.signal(Signal::KILL);
        first.ended();
    }
    second.signal(Signal::KILL);
    second.ended();
    assert_eq!(fs::read_to_string(&file).unwrap(), now);
    folder
}

/// Regression test: `w` on a pipe hung even on SIGTERM, and an endless device exhausted the memory.
#[test]
fn special_files_are_rejected_without_hanging() {
    let (folder, file) = folder("kinds");
    let pipe = folder.join("pipe");
    assert!(
        Command::new("mkfifo")
            .arg(&pipe)
            .status()
            .unwrap()
            .success()
    );
    std::os::unix::fs::symlink("/dev/zero", folder.join("zero")).unwrap();
    let text = fs::read(&file).unwrap();
    let to = pipe.clone();
    let feeding = thread::spawn(move || fs::write(to, text));
    let mut session = start_krank(&folder, "pipe");
    feeding.join().unwrap().unwrap();
    session.wait_for("? help");
    edit(&session, 1);
    // A scene read from a pipe is saved to another file.
    session.send("w");
    session.wait_for("write to: scene.toml").send("\x1b");
    session.wait_for("? help");
    for name in ["zero", "pipe", "/dev/full", "/dev/tty"] {
        session.send(&format!("W\x15{name}\r"));
        session.wait_for("not a file").send("\x1b");
        session.wait_for("? help");
    }
    session.signal(Signal::TERM);
    assert!(!session.ended_as_found().success());
    // The file of a scene becomes a pipe while it is open.
    let mut session = start_krank(&folder, "mine.toml");
    session.wait_for("? help");
    fs::remove_file(&file).unwrap();
    fs::rename(&pipe, &file).unwrap();
    session.wait_for("it is a pipe, not a file").send("R");
    session.wait_for("it is a pipe, not a file").send("q");
    assert!(session.ended_as_found().success());
}

/// Simulates a hanging disk: the test holds the lock needed for saving. Keys and signals are still handled.
#[test]
fn slow_save_does_not_block_keys() {
    let (folder, file) = folder("hangs");
    let lock = File::open(&folder).unwrap();
    flock(&lock, FlockOperation::LockExclusive).unwrap();
    let mut session = start_krank(&folder, "mine.toml");
    session.wait_for("? help");
    edit(&session, 1);
    session.send("w");
    session.wait_for("writing mine.toml").send("1.");
    session.wait_for("65.00 deg");
    // The save fails, and no edits are lost.
    session.wait_for("another program is writing to it");
    session.send("w");
    session.wait_for("writing mine.toml");
    flock(&lock, FlockOperation::Unlock).unwrap();
    session.wait_for("written to mine.toml");
    assert_eq!(fs::read_to_string(&file).unwrap(), with_crank(101));
    flock(&lock, FlockOperation::LockExclusive).unwrap();
    session.send(TO_CRANK);
    session.wait_for("nudge by 1 mm").send(">");
    session.wait_for("*r2 length     102").send("w");
    session.wait_for("writing mine.toml");
    session.signal(Signal::TERM);
    assert!(!session.ended_as_found().success());
}

/// The end of a save must not affect a scene opened in the meantime.
#[test]
fn scene_opened_during_a_save_does_not_get_its_file() {
    let (folder, _) = folder("meanwhile");
    let lock = File::open(&folder).unwrap();
    flock(&lock, FlockOperation::LockExclusive).unwrap();
    let mut session = start_krank(&folder, "four-bar");
    session.wait_for("? help").send("W\x15mine-too.toml\r");
    session.wait_for("writing mine-too.toml").send("n");
    session.wait_until("another preset", |seen| {
        !seen
            .terminal
            .screen()
            .contents()
            .contains("Four-bar crank-rocker")
    });
    flock(&lock, FlockOperation::Unlock).unwrap();
    session.wait_for("written to mine-too.toml");
    assert_eq!(
        fs::read_to_string(folder.join("mine-too.toml")).unwrap(),
        four_bar()
    );
    // The other scene has no file.
    session.send("w");
    session.wait_for("write to: ").send("\x1b");
    session.wait_for("? help").send("q");
    assert!(session.ended_as_found().success());
    assert_eq!(
        fs::read_to_string(folder.join("mine-too.toml")).unwrap(),
        four_bar()
    );
}

/// `~` is the home folder, and a name can have 255 bytes and letters of any language.
#[test]
fn file_names_accept_tilde_unicode_and_255_bytes() {
    let (folder, _) = folder("names");
    let krank = env!("CARGO_BIN_EXE_krank");
    let line = format!("cd '{}' && exec {krank} mine.toml", folder.display());
    let home = folder.to_str().unwrap();
    let mut session = Setup::script(&line).env("HOME", home).start();
    session.wait_for("? help");
    let long = format!("{}.toml", "x".repeat(250));
    // The file appears before it is complete, and the message of the one before may still be shown.
    for (typed, name, shown) in [
        ("~/copy.toml", "copy.toml", "written to /"),
        ("K\u{fc}rbel.toml", "K\u{fc}rbel.toml", "written to K"),
        (&long, &long, "motion  xxxx"),
    ] {
        session.send(&format!("W\x15{typed}\r"));
        let end = Instant::now() + crate::session::PATIENCE;
        while fs::read_to_string(folder.join(name)).is_err() {
            assert!(Instant::now() < end, "{}", session.screen());
            thread::sleep(Duration::from_millis(5));
        }
        session.wait_for(shown);
        session.settle();
    }
    session.send("q");
    assert!(session.ended_as_found().success());
}
