//! Tests of file operations on the disk: preserved metadata, rejected files, and leftovers.

use super::*;
use std::fs;
use std::io::Write;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("krank-files-{name}-{}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder.canonicalize().unwrap()
}

fn write(to: &Path, bytes: &[u8], records: Option<&Path>) -> Result<(), WriteError> {
    let mut output = Output::to(to, records)?;
    output.write_all(bytes)?;
    output.commit(records).map(drop)
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Returns the metadata of files that this process has open in a folder, with or without a name.
fn opened_in(folder: &Path) -> Vec<fs::Metadata> {
    let all = fs::read_dir("/proc/self/fd")
        .into_iter()
        .flatten()
        .flatten();
    let inside = all.filter(|fd| fs::read_link(fd.path()).is_ok_and(|to| to.starts_with(folder)));
    inside
        .filter_map(|fd| fs::metadata(fd.path()).ok().filter(fs::Metadata::is_file))
        .collect()
}

#[test]
fn write_creates_or_replaces_file_and_leaves_nothing_else() {
    let folder = folder("replaced");
    let long = "x".repeat(255);
    for name in ["scene.toml", &long] {
        let file = folder.join(name);
        for text in ["one", "two, longer", ""] {
            write(&file, text.as_bytes(), None).unwrap();
            assert_eq!(fs::read_to_string(&file).unwrap(), text);
        }
    }
    assert_eq!(names(&folder), ["scene.toml", &long]);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn write_keeps_mode_attributes_and_symlinks() {
    let folder = folder("linked");
    let (file, link) = (folder.join("scene.toml"), folder.join("link.toml"));
    fs::write(&file, "old").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    let name = c"user.krank-test";
    // Some file systems have no extended attributes.
    let flags = rustix::fs::XattrFlags::empty();
    let has_attributes = rustix::fs::setxattr(&file, name, b"kept", flags).is_ok();
    symlink("scene.toml", &link).unwrap();
    write(&link, b"new", None).unwrap();
    assert_eq!(fs::read_to_string(&file).unwrap(), "new");
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(fs::metadata(&file).unwrap().mode() & 0o7777, 0o640);
    if has_attributes {
        let mut value = [0; 16];
        let length = rustix::fs::getxattr(&file, name, &mut value[..]).unwrap();
        assert_eq!(&value[..length], b"kept");
    }
    // Writing through a dangling link creates its target.
    let dangling = folder.join("dangling.toml");
    symlink("made.toml", &dangling).unwrap();
    write(&dangling, b"made", None).unwrap();
    assert_eq!(
        fs::read_to_string(folder.join("made.toml")).unwrap(),
        "made"
    );
    assert!(fs::symlink_metadata(&dangling).unwrap().is_symlink());
    // A link to itself is an error.
    symlink("circle", folder.join("circle")).unwrap();
    assert!(write(&folder.join("circle"), b"x", None).is_err());
    fs::remove_dir_all(folder).unwrap();
}

/// A file keeps its owner even if root saves it.
#[test]
fn write_keeps_owner() {
    let folder = folder("owned");
    let file = folder.join("scene.toml");
    fs::write(&file, "old").unwrap();
    if std::os::unix::fs::chown(&file, Some(12_345), Some(54_321)).is_err() {
        eprintln!("skipped: only root may give files away");
        return;
    }
    write(&file, b"new", None).unwrap();
    let found = fs::metadata(&file).unwrap();
    assert_eq!((found.uid(), found.gid()), (12_345, 54_321));
    assert_eq!(fs::read_to_string(&file).unwrap(), "new");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn write_keeps_hard_links() {
    let folder = folder("hard");
    let (one, two) = (folder.join("one"), folder.join("two"));
    let records = folder.join("deep/records");
    fs::write(&one, "old, and longer").unwrap();
    fs::hard_link(&one, &two).unwrap();
    assert!(matches!(
        write(&one, b"new", None),
        Err(WriteError::NoJournal)
    ));
    assert_eq!(fs::read_to_string(&one).unwrap(), "old, and longer");
    for text in ["new", "new, and longer than it was"] {
        write(&one, text.as_bytes(), Some(&records)).unwrap();
        assert_eq!(fs::read_to_string(&two).unwrap(), text);
    }
    assert_eq!(fs::metadata(&two).unwrap().nlink(), 2);
    assert!(names(&records).is_empty());
    assert_eq!(fs::metadata(&records).unwrap().mode() & 0o777, 0o700);
    fs::remove_dir_all(folder).unwrap();
}

/// Writes the record that a kill leaves, with the file at any point of the write.
#[test]
fn recovery_completes_only_interrupted_writes() {
    let folder = folder("mended");
    let (file, records) = (folder.join("scene\n.toml"), folder.join("records"));
    fs::create_dir_all(&records).unwrap();
    let digits: String = file
        .as_os_str()
        .as_encoded_bytes()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    let texts = ["the old text, long as it is", "the NEW text"];
    for [old, new] in [texts, [texts[1], texts[0]], ["", texts[0]], [texts[0], ""]] {
        let record = format!(
            "krank-writing 1 {} {} {digits}\n{old}{new}",
            old.len(),
            new.len()
        );
        let torn = |cut: usize| {
            let rest = old.get(cut..).unwrap_or_default();
            format!("{}{rest}", &new[..cut])
        };
        let all: Vec<String> = (0..=new.len()).map(torn).chain([new.to_owned()]).collect();
        for present in all {
            fs::write(&file, &present).unwrap();
            fs::write(records.join("krank-1-1.writing"), &record).unwrap();
            let mended = recover_all(&records);
            let now = fs::read_to_string(&file).unwrap();
            let was_whole = present == old || present == new;
            assert_eq!(now, if was_whole { present.as_str() } else { new });
            assert_eq!(mended.len(), usize::from(!was_whole));
            assert!(names(&records).is_empty());
        }
        // A later write by another program is kept.
        fs::write(&file, "something else altogether").unwrap();
        fs::write(records.join("krank-1-1.writing"), &record).unwrap();
        assert!(recover_all(&records).is_empty());
        assert_eq!(
            fs::read_to_string(&file).unwrap(),
            "something else altogether"
        );
    }
    // Invalid records are ignored.
    for foreign in [
        "",
        "krank-writing 1 1 1 zz\nab",
        "krank-writing 1 9 9 2f\nab",
    ] {
        fs::write(records.join("odd.writing"), foreign).unwrap();
        assert!(recover_all(&records).is_empty());
        assert_eq!(names(&records), ["odd.writing"]);
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn stale_temp_files_are_removed_but_not_locked_or_foreign_ones() {
    let folder = folder("swept");
    let file = folder.join("scene.toml");
    fs::write(folder.join(".krank-1-1.part"), "left by a kill").unwrap();
    fs::write(folder.join(".scene.toml.1"), "foreign").unwrap();
    symlink("/nowhere", folder.join(".krank-2-2.part")).unwrap();
    let in_use = fs::File::create(folder.join(".krank-3-3.part")).unwrap();
    in_use.lock().unwrap();
    write(&file, b"text", None).unwrap();
    let left = [
        ".krank-2-2.part",
        ".krank-3-3.part",
        ".scene.toml.1",
        "scene.toml",
    ];
    assert_eq!(names(&folder), left);
    drop(in_use);
    write(&file, b"more", None).unwrap();
    assert_eq!(names(&folder), [left[0], left[2], left[3]]);
    fs::remove_dir_all(folder).unwrap();
}

/// The next temporary file would have the name of a foreign file, which stays unchanged.
#[test]
fn foreign_file_with_temp_name_stays() {
    let folder = folder("foreign");
    let pid = std::process::id();
    // Locked as if in use, so that the cleanup does not remove them.
    let foreign: Vec<fs::File> = (0..400)
        .map(|n| {
            let file = fs::File::create(folder.join(format!(".krank-{pid}-{n}.part"))).unwrap();
            file.lock().unwrap();
            file
        })
        .collect();
    write(&folder.join("scene.toml"), b"text", None).unwrap();
    assert_eq!(names(&folder).len(), foreign.len() + 1);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn failed_write_leaves_nothing() {
    let folder = folder("missing");
    assert!(write(&folder.join("nowhere/scene.toml"), b"text", None).is_err());
    assert!(write(&folder.join(".."), b"text", None).is_err());
    assert!(write(&folder, b"text", None).is_err());
    assert!(write(&folder.join("new/"), b"text", None).is_err());
    let file = folder.join("scene.toml");
    fs::write(&file, "old").unwrap();
    drop(Output::to(&file, None).unwrap());
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    assert_eq!(names(&folder), ["scene.toml"]);
    fs::remove_dir_all(folder).unwrap();
}

/// Regression: after a kill, a private scene was readable by everybody.
#[test]
fn temp_file_gets_final_mode_before_first_write() {
    let folder = folder("private");
    let file = folder.join("scene.toml");
    for mode in [0o600, 0o640, 0o664] {
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(mode)).unwrap();
        let output = Output::to(&file, None).unwrap();
        let modes: Vec<u32> = opened_in(&folder).iter().map(MetadataExt::mode).collect();
        assert!(!modes.is_empty());
        assert!(modes.iter().all(|of| of & 0o777 == mode), "{modes:?}");
        drop(output);
    }
    fs::remove_dir_all(folder).unwrap();
}

#[cfg(feature = "tui")]
mod saving {
    use super::*;

    fn to(file: &Path) -> Saving<'_> {
        Saving {
            to: file,
            records: None,
            overwrites_read_only: false,
            most: 1 << 20,
        }
    }

    #[test]
    fn read_only_file_is_written_only_on_request() {
        let folder = folder("read-only");
        let file = folder.join("scene.toml");
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).unwrap();
        let refused = save(to(&file), |_| Ok(b"new".to_vec()));
        assert!(matches!(refused, Err(WriteError::ReadOnly)), "{refused:?}");
        assert!(matches!(Output::to(&file, None), Err(WriteError::ReadOnly)));
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        let intended = Saving {
            overwrites_read_only: true,
            ..to(&file)
        };
        save(intended, |_| Ok(b"new".to_vec())).unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        assert_eq!(fs::metadata(&file).unwrap().mode() & 0o777, 0o444);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn pipes_and_devices_are_rejected_without_blocking() {
        let folder = folder("pipe");
        let pipe = folder.join("pipe");
        let mode = rustix::fs::Mode::from_raw_mode(0o600);
        rustix::fs::mknodat(rustix::fs::CWD, &pipe, rustix::fs::FileType::Fifo, mode, 0).unwrap();
        symlink("/dev/zero", folder.join("zero")).unwrap();
        for name in [&pipe, &folder.join("zero"), Path::new("/dev/full")] {
            assert!(read_file(name, 1 << 20).is_err());
            let refused = save(to(name), |_| Ok(b"new".to_vec()));
            assert!(matches!(refused, Err(WriteError::NoFile(_))), "{refused:?}");
        }
        fs::remove_dir_all(folder).unwrap();
    }

    /// Each thread appends a byte to the present contents; none is lost, so the saves did not
    /// interleave.
    #[test]
    fn concurrent_saves_are_serialized() {
        let folder = folder("at-once");
        let file = folder.join("scene.toml");
        fs::write(&file, "").unwrap();
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    for _ in 0..10 {
                        let longer =
                            |old: Option<Vec<u8>>| Ok([old.unwrap(), b"x".to_vec()].concat());
                        save(to(&file), longer).unwrap();
                    }
                });
            }
        });
        assert_eq!(fs::read(&file).unwrap(), [b'x'; 40]);
        assert_eq!(names(&folder), ["scene.toml"]);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn leading_tilde_expands_to_home() {
        let env = |name: &str| (name == "HOME").then(|| PathBuf::from("/home/me"));
        let path = |typed| from_home(typed, env);
        assert_eq!(path("~/a.toml"), Path::new("/home/me/a.toml"));
        assert_eq!(path("~"), Path::new("/home/me"));
        assert_eq!(path("~other/a"), Path::new("~other/a"));
        assert_eq!(path("a~"), Path::new("a~"));
        assert_eq!(from_home("~/a", |_| None), Path::new("~/a"));
    }
}

/// Editors ignore our lock: their write during a save is not overwritten.
#[cfg(feature = "tui")]
#[test]
fn foreign_write_during_save_is_kept() {
    let folder = folder("meanwhile");
    let file = folder.join("scene.toml");
    fs::write(&file, "old").unwrap();
    let saving = Saving {
        to: &file,
        records: None,
        overwrites_read_only: false,
        most: 100,
    };
    let foreign = |_| {
        fs::write(&file, "foreign").unwrap();
        Ok(b"new".to_vec())
    };
    assert!(matches!(save(saving, foreign), Err(WriteError::Changed)));
    assert_eq!(fs::read_to_string(&file).unwrap(), "foreign");
    assert_eq!(names(&folder), ["scene.toml"]);
    save(saving, |_| Ok(b"new".to_vec())).unwrap();
    assert_eq!(fs::read_to_string(&file).unwrap(), "new");
    fs::remove_dir_all(folder).unwrap();
}

/// An unnamed temporary file disappears with its process after a kill.
#[cfg(target_os = "linux")]
#[test]
fn temp_file_is_unnamed_until_complete() {
    let folder = folder("unnamed");
    let file = folder.join("out.csv");
    for old in [None, Some("old")] {
        if let Some(old) = old {
            fs::write(&file, old).unwrap();
        }
        let mut output = Output::to(&file, None).unwrap();
        output.write_all(b"rows").unwrap();
        if opened_in(&folder).iter().any(|found| found.nlink() == 0) {
            assert_eq!(names(&folder).len(), usize::from(old.is_some()));
        } else {
            eprintln!("skipped: this disk has no files without a name");
        }
        output.commit(None).unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "rows");
        fs::remove_file(&file).unwrap();
    }
    fs::remove_dir_all(folder).unwrap();
}

/// Regression: two commands wrote one file, and the later one won silently.
#[test]
fn file_being_written_by_another_is_rejected() {
    let folder = folder("locked");
    let (file, link) = (folder.join("out.csv"), folder.join("link.csv"));
    fs::write(&file, "old").unwrap();
    symlink("out.csv", &link).unwrap();
    let held = Output::to(&file, None).unwrap();
    for name in [&file, &link] {
        assert!(matches!(Output::to(name, None), Err(WriteError::Busy)));
        let growing = AppendFile::create(name, "head\n", None);
        assert!(matches!(growing, Err(WriteError::Busy)));
        assert!(matches!(
            ResumableFile::open(name, "ol"),
            Err(WriteError::Busy)
        ));
    }
    drop(held);
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    // A file created by another writer in the meantime is kept.
    let mut late = Output::to(&folder.join("new.csv"), None).unwrap();
    late.write_all(b"late").unwrap();
    write(&folder.join("new.csv"), b"early", None).unwrap();
    let refused = late.commit(None).unwrap_err();
    assert!(refused.to_string().contains("another program has created"));
    // A file changed by a writer without locks is kept, too.
    let mut late = Output::to(&file, None).unwrap();
    late.write_all(b"late").unwrap();
    fs::write(&file, "foreign").unwrap();
    assert!(matches!(late.commit(None), Err(WriteError::Changed)));
    assert_eq!(fs::read_to_string(&file).unwrap(), "foreign");
    assert_eq!(fs::read_to_string(folder.join("new.csv")).unwrap(), "early");
    fs::remove_dir_all(folder).unwrap();
}

/// Only files with exactly the name pattern of temporary files are removed.
#[test]
fn files_with_similar_names_to_temp_files_stay() {
    let folder = folder("nearly");
    for name in [
        ".krank-notes.part",
        ".krank-1.part",
        ".krank-1-2-3.part",
        ".krank-4711-0.part",
    ] {
        fs::write(folder.join(name), "mine").unwrap();
    }
    write(&folder.join("x"), b"text", None).unwrap();
    let left = [
        ".krank-1-2-3.part",
        ".krank-1.part",
        ".krank-notes.part",
        "x",
    ];
    assert_eq!(names(&folder), left);
    fs::remove_dir_all(folder).unwrap();
}
