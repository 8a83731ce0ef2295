//! Tests recovery with sessions that start and end, each in its own folder.

use super::*;
use std::time::{Duration, UNIX_EPOCH};

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("krank-{name}-{}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    folder
}

fn at(seconds: u64) -> SystemTime {
    UNIX_EPOCH + Duration::from_secs(seconds)
}

fn four_bar() -> Origin {
    Origin::Preset("four-bar".into())
}

/// Creates the record of a session that started at `started`, on a scene.
fn session(folder: &Path, started: u64, origin: &Origin) -> Recovery {
    Recovery::new(folder, &SessionRun::started_at(at(started)), origin, "old")
}

#[test]
fn edits_are_offered_only_to_their_scene() {
    let folder = folder("recovery");
    let mut one = session(&folder.join("deep/er"), 1, &four_bar());
    let folder = folder.join("deep/er");
    assert_eq!(one.others("old"), OtherSessions::default());
    assert_eq!(
        one.keep(UnsavedEdits::of("new\nlines\n"), "old", at(1_795_269_780)),
        None
    );
    let found = |origin: &Origin, present: &str| session(&folder, 9, origin).others(present);
    let alive = found(&four_bar(), "old");
    assert_eq!(alive.left, [], "it is another's, who is at work on them");
    assert_eq!(alive.alive, [], "nobody else's preset is changed by that");
    drop(one);
    let edits = found(&four_bar(), "old");
    assert_eq!(edits.alive, []);
    assert_eq!(edits.left[0].edits.text, "new\nlines\n");
    assert_eq!(edits.left[0].time, "2026-11-21 14:03 UTC");
    assert!(!edits.left[0].is_stale && !edits.left[0].is_older);
    assert!(found(&four_bar(), "other").left[0].is_stale);
    assert_eq!(found(&four_bar(), "new\nlines\n"), OtherSessions::default());
    assert_eq!(
        found(&Origin::File("four-bar".into()), "old"),
        OtherSessions::default()
    );
    assert_eq!(found(&Origin::Stdin, "old"), OtherSessions::default());
    fs::remove_dir_all(folder.parent().unwrap().parent().unwrap()).unwrap();
}

#[test]
fn edits_are_found_by_any_path_of_a_file() {
    let folder = folder("recovery-names");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("scene.toml");
    fs::write(&file, "old").unwrap();
    fs::hard_link(&file, folder.join("hard.toml")).unwrap();
    std::os::unix::fs::symlink("scene.toml", folder.join("soft.toml")).unwrap();
    let of = |path: PathBuf| Origin::File(path);
    drop({
        let mut one = session(&folder, 1, &of(file.clone()));
        one.keep(UnsavedEdits::of("new"), "old", at(5));
        one
    });
    let names = ["hard.toml", "soft.toml", "../x/../scene.toml"];
    fs::create_dir_all(folder.parent().unwrap().join("x")).unwrap();
    for name in names {
        let name = match name.strip_prefix("../x/../") {
            Some(name) => folder.join(".").join(name),
            None => folder.join(name),
        };
        let left = session(&folder, 9, &of(name.clone())).others("old").left;
        assert_eq!(left.len(), 1, "{name:?}");
        assert!(left[0].is_older, "the file was written long after 1970");
    }
    // Other editors save by replacing the file.
    fs::write(folder.join("new"), "old").unwrap();
    fs::rename(folder.join("new"), &file).unwrap();
    assert_eq!(session(&folder, 9, &of(file)).others("old").left.len(), 1);
    fs::write(folder.join("other.toml"), "old").unwrap();
    let other = session(&folder, 9, &of(folder.join("other.toml")));
    assert_eq!(other.others("old"), OtherSessions::default());
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn crashed_sessions_are_kept_until_dropped_or_saved() {
    let folder = folder("recovery-three");
    for n in 1..=3 {
        session(&folder, n, &four_bar()).keep(
            UnsavedEdits::of(&format!("edit {n}")),
            "old",
            at(n * 60),
        );
    }
    let mut next = session(&folder, 9, &four_bar());
    let texts = |recovery: &Recovery| -> Vec<String> {
        let left = recovery.others("old").left;
        left.into_iter()
            .map(|generation| generation.edits.text)
            .collect()
    };
    assert_eq!(texts(&next), ["edit 3", "edit 2", "edit 1"]);
    // Restored and undone edits stay; saved ones are removed.
    let newest = next.others("old").left.remove(0);
    next.keep(UnsavedEdits::of(&newest.edits.text), "old", at(999));
    next.take(newest.file, newest.edits.text);
    next.rest();
    assert_eq!(texts(&next), ["edit 3", "edit 2", "edit 1"]);
    // Editing and saving another text removes none of them.
    next.keep(UnsavedEdits::of("another"), "old", at(999));
    next.release();
    assert_eq!(texts(&next), ["edit 3", "edit 2", "edit 1"]);
    // Redone edits are removed with the save.
    next.keep(UnsavedEdits::of("edit 3"), "old", at(999));
    next.release();
    assert_eq!(texts(&next), ["edit 2", "edit 1"], "others' edits stay");
    delete(&next.others("old").left[0].file);
    assert_eq!(texts(&next), ["edit 1"]);
    fs::remove_dir_all(folder).unwrap();
}

/// Edits made during a save are kept at every moment.
#[test]
fn edits_during_save_are_kept_and_restored_ones_dropped() {
    let folder = folder("recovery-meanwhile");
    session(&folder, 1, &four_bar()).keep(UnsavedEdits::of("left"), "old", at(60));
    let mut next = session(&folder, 9, &four_bar());
    let left = next.others("old").left.remove(0);
    next.keep(UnsavedEdits::of(&left.edits.text), "old", at(99));
    next.take(left.file, left.edits.text);
    next.keep(UnsavedEdits::of("newer"), "left", at(100));
    next.drop_taken();
    drop(next);
    let found = session(&folder, 10, &four_bar()).others("left").left;
    let texts: Vec<&str> = found.iter().map(|found| &found.edits.text[..]).collect();
    assert_eq!(texts, ["newer"]);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn open_sessions_are_listed_and_leave_no_record() {
    let folder = folder("recovery-open");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("scene.toml");
    fs::write(&file, "old").unwrap();
    let origin = Origin::File(file);
    let kept = folder.join("kept");
    let one = session(&kept, 1, &origin);
    let two = session(&kept, 2, &origin);
    assert_eq!(one.others("old").alive.len(), 1);
    drop(two);
    assert_eq!(one.others("old"), OtherSessions::default());
    drop(one);
    assert_eq!(fs::read_dir(&kept).unwrap().count(), 0);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn unwritable_folder_is_reported_once() {
    let folder = folder("recovery-none");
    fs::write(&folder, "a file").unwrap();
    let mut recovery = session(&folder, 1, &Origin::Stdin);
    let text = recovery
        .keep(UnsavedEdits::of("text"), "old", at(0))
        .unwrap();
    assert!(
        text.starts_with("edits are not kept for recovery: "),
        "{text}"
    );
    assert_eq!(recovery.keep(UnsavedEdits::of("text"), "old", at(0)), None);
    fs::remove_file(folder).unwrap();
}

/// A lookup while a session replaces its record sees a live session, and removes nothing.
#[test]
fn concurrent_lookup_removes_no_edits() {
    let folder = folder("recovery-busy");
    let scene = folder.join("scene.toml");
    fs::create_dir_all(&folder).unwrap();
    fs::write(&scene, "old").unwrap();
    let origin = Origin::File(scene);
    let mut busy = session(&folder, 1, &origin);
    let other = session(&folder, 2, &origin);
    std::thread::scope(|scope| {
        let busy = scope.spawn(|| {
            for round in 0..500 {
                assert_eq!(busy.keep(UnsavedEdits::of("new"), "old", at(round)), None);
                assert!(busy.file().exists(), "in round {round}");
                busy.rest();
            }
            busy.keep(UnsavedEdits::of("new"), "old", at(500))
        });
        while !busy.is_finished() {
            assert_eq!(other.others("old").left, []);
        }
        assert_eq!(busy.join().unwrap(), None);
    });
    drop(busy);
    assert_eq!(other.others("old").left.len(), 1);
    drop(other);
    fs::remove_dir_all(&folder).unwrap();
}
