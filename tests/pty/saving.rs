//! Saving, with kills at any time, several sessions at once, and files that are none.

use crate::session::{Session, Setup};
use rustix::fs::{FlockOperation, flock};
use rustix::process::Signal;
use std::fs::{self, File};
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

/// Kills of an ordinary run; `KRANK_KILLS=400 cargo test` for more.
const KILLS: u64 = 16;
/// Goes to the crank's length.
const TO_CRANK: &str = "6/r2 len\r";

fn four_bar() -> &'static str {
    krank::scene::presets::find("four-bar").unwrap().text
}

fn with_crank(length: u32) -> String {
    four_bar().replace("length = 100", &format!("length = {length}"))
}

/// A folder with a scene in it.
fn folder(name: &str) -> (PathBuf, PathBuf) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("saving-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("mine.toml");
    fs::write(&file, four_bar()).unwrap();
    (folder, file)
}

/// krank in a folder, with its state there.
fn begin(folder: &Path, scene: &str) -> Session {
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

/// Any other command completes what was cut off.
fn next_start(folder: &Path) {
    let done = Command::new(env!("CARGO_BIN_EXE_krank"))
        .arg("list")
        .env("XDG_STATE_HOME", folder.join("state"))
        .output()
        .unwrap();
    assert!(done.status.success());
}

/// Owner, group, mode and names stay; the text is one of the two.
fn killed_while_saving(name: &str, is_linked: bool, kills: u64) {
    let (folder, file) = folder(name);
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    // Only root may give files away.
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
        // Without the offer of what earlier rounds have left.
        let _ = fs::remove_dir_all(folder.join("state"));
        let old = fs::read_to_string(&file).unwrap();
        let key = if old == four_bar() { ">" } else { "<" };
        let mut session = begin(&folder, "mine.toml");
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
    // What was left goes with the next who saves.
    let _ = fs::remove_dir_all(folder.join("state"));
    let mut session = begin(&folder, "mine.toml");
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
fn kills_while_saving_tear_nothing() {
    let kills = std::env::var("KRANK_KILLS")
        .ok()
        .and_then(|n| n.parse().ok());
    let kills = kills.unwrap_or(KILLS) / 2;
    thread::scope(|scope| {
        scope.spawn(|| killed_while_saving("killed", false, kills));
        scope.spawn(|| killed_while_saving("killed-linked", true, kills));
    });
}

/// Opens the scene where others have it open, and goes on.
fn join(folder: &Path) -> Session {
    let session = begin(folder, "mine.toml");
    session.wait_for("Open elsewhere");
    // What is typed before a person can have read it answers nothing.
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

/// On a disk that is busy edits are on the screen before they are kept.
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

/// Three sessions on one scene, killed in every order: each leaves its edits, and none those of another.
#[test]
fn sessions_that_are_killed_in_any_order_leave_all_their_edits() {
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
                let first = begin(&folder, "mine.toml");
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
                let mut next = begin(&folder, "./mine.toml");
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

/// Who saves second is told, whatever is done to the first one meanwhile; nobody's edits go.
#[test]
fn of_two_sessions_that_save_at_once_the_later_is_asked() {
    for (name, kills_first) in [("two", false), ("two-killed", true)] {
        later_is_asked(name, kills_first);
    }
}

/// The later one is killed while it is asked: its edits are offered, with a word on why they do not fit. Which
/// word it is hangs on whether they were made in the same second as the file.
#[test]
fn what_the_later_of_two_sessions_held_is_offered() {
    for (name, kills_first) in [("later", false), ("later-killed", true)] {
        let folder = later_is_asked(name, kills_first);
        let mut next = begin(&folder, "mine.toml");
        next.wait_until("edits that do not fit", |seen| {
            let screen = seen.terminal.screen().contents();
            screen.contains("Unsaved edits of this scene")
                && (screen.contains("file has changed") || screen.contains("older than the file"))
        });
        next.send("\x03");
        assert!(next.ended().success());
    }
}

fn later_is_asked(name: &str, kills_first: bool) -> PathBuf {
    let (folder, file) = folder(name);
    let mut one = begin(&folder, "mine.toml");
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

/// `w` on a pipe used to hang, beyond SIGTERM; an endless device ate the memory.
#[test]
fn what_is_no_file_is_refused_and_nothing_hangs() {
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
    let mut session = begin(&folder, "pipe");
    feeding.join().unwrap().unwrap();
    session.wait_for("? help");
    edit(&session, 1);
    // What came through a pipe is saved elsewhere.
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
    // A scene that becomes a pipe while it is open.
    let mut session = begin(&folder, "mine.toml");
    session.wait_for("? help");
    fs::remove_file(&file).unwrap();
    fs::rename(&pipe, &file).unwrap();
    session.wait_for("it is a pipe, not a file").send("R");
    session.wait_for("it is a pipe, not a file").send("q");
    assert!(session.ended_as_found().success());
}

/// A disk that hangs, as far as a test can have one: somebody keeps the lock under which is saved. Keys are
/// heard meanwhile, and so is the end.
#[test]
fn saving_that_takes_long_keeps_no_key_waiting() {
    let (folder, file) = folder("hangs");
    let lock = File::open(&folder).unwrap();
    flock(&lock, FlockOperation::LockExclusive).unwrap();
    let mut session = begin(&folder, "mine.toml");
    session.wait_for("? help");
    edit(&session, 1);
    session.send("w");
    session.wait_for("writing mine.toml").send("1.");
    session.wait_for("65.00 deg");
    // It gives up, and nothing is lost.
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

/// What was asked for of one scene is nothing to the next.
#[test]
fn a_scene_that_is_shown_meanwhile_is_not_taken_for_the_one_that_was_saved() {
    let (folder, _) = folder("meanwhile");
    let lock = File::open(&folder).unwrap();
    flock(&lock, FlockOperation::LockExclusive).unwrap();
    let mut session = begin(&folder, "four-bar");
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
    // The other one has no file.
    session.send("w");
    session.wait_for("write to: ").send("\x1b");
    session.wait_for("? help").send("q");
    assert!(session.ended_as_found().success());
    assert_eq!(
        fs::read_to_string(folder.join("mine-too.toml")).unwrap(),
        four_bar()
    );
}

/// A home is meant by `~`, and a name may have 255 bytes and letters of any language.
#[test]
fn names_are_taken_as_they_are_typed() {
    let (folder, _) = folder("names");
    let krank = env!("CARGO_BIN_EXE_krank");
    let line = format!("cd '{}' && exec {krank} mine.toml", folder.display());
    let home = folder.to_str().unwrap();
    let mut session = Setup::script(&line).env("HOME", home).start();
    session.wait_for("? help");
    let long = format!("{}.toml", "x".repeat(250));
    for (typed, name) in [
        ("~/copy.toml", "copy.toml"),
        ("K\u{fc}rbel.toml", "K\u{fc}rbel.toml"),
        (&long, &long),
    ] {
        session.send(&format!("W\x15{typed}\r"));
        let end = Instant::now() + crate::session::PATIENCE;
        while fs::read_to_string(folder.join(name)).is_err() {
            assert!(Instant::now() < end, "{}", session.screen());
            thread::sleep(Duration::from_millis(5));
        }
        session.wait_for("written to");
        session.settle();
    }
    session.send("q");
    assert!(session.ended_as_found().success());
}
