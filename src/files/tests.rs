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

fn write(to: &Path, bytes: &[u8], records: Option<&Path>) -> Result<(), Trouble> {
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
fn a_file_is_replaced_or_made_and_nothing_is_left_beside_it() {
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
fn mode_attributes_and_links_stay() {
    let folder = folder("linked");
    let (file, link) = (folder.join("scene.toml"), folder.join("link.toml"));
    fs::write(&file, "old").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    let name = c"user.krank-test";
    // Some disks have no attributes.
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
    // A link that leads nowhere yet makes what it leads to.
    let dangling = folder.join("dangling.toml");
    symlink("made.toml", &dangling).unwrap();
    write(&dangling, b"made", None).unwrap();
    assert_eq!(
        fs::read_to_string(folder.join("made.toml")).unwrap(),
        "made"
    );
    assert!(fs::symlink_metadata(&dangling).unwrap().is_symlink());
    // And one that leads to itself makes nothing.
    symlink("circle", folder.join("circle")).unwrap();
    assert!(write(&folder.join("circle"), b"x", None).is_err());
    fs::remove_dir_all(folder).unwrap();
}

/// Whoever owns a file goes on owning it, also where root saves it.
#[test]
fn the_owner_stays() {
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
fn a_file_of_two_names_keeps_both() {
    let folder = folder("hard");
    let (one, two) = (folder.join("one"), folder.join("two"));
    let records = folder.join("deep/records");
    fs::write(&one, "old, and longer").unwrap();
    fs::hard_link(&one, &two).unwrap();
    assert!(matches!(write(&one, b"new", None), Err(Trouble::NoJournal)));
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

/// A record as a kill leaves it, and the file at any point of being written.
#[test]
fn what_a_kill_has_cut_off_is_completed_and_nothing_else() {
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
            let mended = mend(&records);
            let now = fs::read_to_string(&file).unwrap();
            let was_whole = present == old || present == new;
            assert_eq!(now, if was_whole { present.as_str() } else { new });
            assert_eq!(mended.len(), usize::from(!was_whole));
            assert!(names(&records).is_empty());
        }
        // Somebody else has written since: that counts.
        fs::write(&file, "something else altogether").unwrap();
        fs::write(records.join("krank-1-1.writing"), &record).unwrap();
        assert!(mend(&records).is_empty());
        assert_eq!(
            fs::read_to_string(&file).unwrap(),
            "something else altogether"
        );
    }
    // What is no record is no record of ours.
    for foreign in [
        "",
        "krank-writing 1 1 1 zz\nab",
        "krank-writing 1 9 9 2f\nab",
    ] {
        fs::write(records.join("odd.writing"), foreign).unwrap();
        assert!(mend(&records).is_empty());
        assert_eq!(names(&records), ["odd.writing"]);
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn what_was_left_is_swept_and_what_is_in_use_or_foreign_stays() {
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

/// The name that the next draft would have: it is another file's, and stays so.
#[test]
fn a_foreign_file_in_the_way_of_a_draft_stays() {
    let folder = folder("foreign");
    let pid = std::process::id();
    // Locked, as if somebody were at work on them: sweeping does not take them away.
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
fn what_cannot_be_written_leaves_nothing() {
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

/// A private scene used to lie open to everybody after a kill.
#[test]
fn a_draft_has_its_last_rights_before_its_first_byte() {
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
            though_read_only: false,
            most: 1 << 20,
        }
    }

    #[test]
    fn a_read_only_file_is_written_where_that_is_meant() {
        let folder = folder("read-only");
        let file = folder.join("scene.toml");
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).unwrap();
        let refused = save(to(&file), |_| Ok(b"new".to_vec()));
        assert!(matches!(refused, Err(Trouble::ReadOnly)), "{refused:?}");
        assert!(matches!(Output::to(&file, None), Err(Trouble::ReadOnly)));
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        let meant = Saving {
            though_read_only: true,
            ..to(&file)
        };
        save(meant, |_| Ok(b"new".to_vec())).unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
        assert_eq!(fs::metadata(&file).unwrap().mode() & 0o777, 0o444);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn pipes_and_devices_are_refused_at_once() {
        let folder = folder("pipe");
        let pipe = folder.join("pipe");
        let mode = rustix::fs::Mode::from_raw_mode(0o600);
        rustix::fs::mknodat(rustix::fs::CWD, &pipe, rustix::fs::FileType::Fifo, mode, 0).unwrap();
        symlink("/dev/zero", folder.join("zero")).unwrap();
        for name in [&pipe, &folder.join("zero"), Path::new("/dev/full")] {
            assert!(read_file(name, 1 << 20).is_err());
            let refused = save(to(name), |_| Ok(b"new".to_vec()));
            assert!(matches!(refused, Err(Trouble::NoFile(_))), "{refused:?}");
        }
        fs::remove_dir_all(folder).unwrap();
    }

    /// Each adds a byte to what it finds: none is lost, so nobody came in between.
    #[test]
    fn who_saves_at_once_saves_one_after_the_other() {
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
    fn home_is_expanded_where_it_is_meant() {
        let env = |name: &str| (name == "HOME").then(|| PathBuf::from("/home/me"));
        let path = |typed| from_home(typed, env);
        assert_eq!(path("~/a.toml"), Path::new("/home/me/a.toml"));
        assert_eq!(path("~"), Path::new("/home/me"));
        assert_eq!(path("~other/a"), Path::new("~other/a"));
        assert_eq!(path("a~"), Path::new("a~"));
        assert_eq!(from_home("~/a", |_| None), Path::new("~/a"));
    }
}

/// Editors know no lock of ours: what one of them writes while we do is not written over.
#[cfg(feature = "tui")]
#[test]
fn what_somebody_else_writes_meanwhile_stays() {
    let folder = folder("meanwhile");
    let file = folder.join("scene.toml");
    fs::write(&file, "old").unwrap();
    let saving = Saving {
        to: &file,
        records: None,
        though_read_only: false,
        most: 100,
    };
    let foreign = |_| {
        fs::write(&file, "foreign").unwrap();
        Ok(b"new".to_vec())
    };
    assert!(matches!(save(saving, foreign), Err(Trouble::Changed)));
    assert_eq!(fs::read_to_string(&file).unwrap(), "foreign");
    assert_eq!(names(&folder), ["scene.toml"]);
    save(saving, |_| Ok(b"new".to_vec())).unwrap();
    assert_eq!(fs::read_to_string(&file).unwrap(), "new");
    fs::remove_dir_all(folder).unwrap();
}

/// What a kill leaves: a draft without a name goes with its process.
#[cfg(target_os = "linux")]
#[test]
fn draft_has_no_name_before_it_is_whole() {
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

/// Two commands used to write one file, and the later one won without a word.
#[test]
fn file_that_another_writes_is_left_alone() {
    let folder = folder("locked");
    let (file, link) = (folder.join("out.csv"), folder.join("link.csv"));
    fs::write(&file, "old").unwrap();
    symlink("out.csv", &link).unwrap();
    let held = Output::to(&file, None).unwrap();
    for name in [&file, &link] {
        assert!(matches!(Output::to(name, None), Err(Trouble::Busy)));
        let growing = GrowingFile::begin(name, "head\n", None);
        assert!(matches!(growing, Err(Trouble::Busy)));
        assert!(matches!(GrownFile::open(name, "ol"), Err(Trouble::Busy)));
    }
    drop(held);
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    // A new file that somebody else has made meanwhile stays.
    let mut late = Output::to(&folder.join("new.csv"), None).unwrap();
    late.write_all(b"late").unwrap();
    write(&folder.join("new.csv"), b"early", None).unwrap();
    assert!(matches!(late.commit(None), Err(Trouble::Exists)));
    // And so does one that somebody else has written who knows no lock.
    let mut late = Output::to(&file, None).unwrap();
    late.write_all(b"late").unwrap();
    fs::write(&file, "foreign").unwrap();
    assert!(matches!(late.commit(None), Err(Trouble::Changed)));
    assert_eq!(fs::read_to_string(&file).unwrap(), "foreign");
    assert_eq!(fs::read_to_string(folder.join("new.csv")).unwrap(), "early");
    fs::remove_dir_all(folder).unwrap();
}

/// Only what is called like a draft is swept.
#[test]
fn a_file_that_is_called_nearly_like_a_draft_stays() {
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
