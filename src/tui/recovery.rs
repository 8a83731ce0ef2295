//! Unsaved edits, kept in a file beside the person's other state until they are saved or dropped: whatever
//! ends the program, they are there when it is started again.

use super::Origin;
use crate::replace::replace_unsynced;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// What the first line begins with.
const HEAD: &str = "# krank: unsaved edits of ";
/// What stands before the sum of the text that was edited.
const BASE: &str = ", text ";
/// What stands before the time.
const TIME: &str = ", at ";

/// Edits that were found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Found {
    pub(crate) text: String,
    /// When they were made: `2026-11-21 14:03 UTC`.
    pub(crate) time: String,
    /// Whether they were made on another text than the file has now.
    pub(crate) stale: bool,
}

/// Where the edits of one scene are kept.
#[derive(Clone, Debug)]
pub(crate) struct Recovery {
    file: PathBuf,
    /// What the edits belong to, for the first line.
    origin: String,
    /// Whether the file holds edits of this session.
    kept: bool,
    /// Whether it was said that they cannot be kept.
    told: bool,
}

impl Recovery {
    /// The place in a folder for the scene that was opened with this text.
    pub(crate) fn new(folder: &Path, origin: &Origin, text: &str) -> Recovery {
        let (origin, named) = match origin {
            Origin::Preset(name) => (format!("preset {name}"), name.clone().into_bytes()),
            Origin::File(path) => {
                let path = std::path::absolute(path).unwrap_or_else(|_| path.clone());
                let name = path.to_string_lossy().into_owned();
                (name, path.into_os_string().into_encoded_bytes())
            }
            Origin::Stdin => ("standard input".into(), text.as_bytes().to_vec()),
        };
        let sort = origin.split(' ').next().unwrap_or_default().as_bytes();
        let sum = sum([sort, &named].concat().as_slice());
        Recovery {
            file: folder.join(format!("{sum:016x}.toml")),
            origin,
            kept: false,
            told: false,
        }
    }

    /// What an earlier session has left, if that is another text than `present`.
    pub(crate) fn found(&self, present: &str) -> Option<Found> {
        let whole = fs::read_to_string(&self.file).ok()?;
        let (head, text) = whole.split_once('\n')?;
        let (origin, rest) = head.strip_prefix(HEAD)?.rsplit_once(BASE)?;
        let (base, time) = rest.split_once(TIME)?;
        // Two names may have the same sum.
        let found = origin == shown(&self.origin) && text != present;
        found.then(|| Found {
            text: text.to_owned(),
            time: time.to_owned(),
            stale: base != format!("{:016x}", sum(present.as_bytes())),
        })
    }

    /// Keeps the edited text; in words why it cannot, once.
    pub(crate) fn keep(&mut self, text: &str, saved: &str, now: SystemTime) -> Option<String> {
        match self.write(text, saved, now) {
            Ok(()) => {
                self.kept = true;
                None
            }
            Err(_) if std::mem::replace(&mut self.told, true) => None,
            Err(error) => {
                let folder = self.file.parent().unwrap_or(&self.file).display();
                Some(format!(
                    "edits are not kept for recovery: {folder}: {error}"
                ))
            }
        }
    }

    fn write(&mut self, text: &str, saved: &str, now: SystemTime) -> io::Result<()> {
        if let Some(folder) = self.file.parent() {
            make_private(folder)?;
        }
        if !self.kept && self.file.exists() {
            // Edits that were left where they are: they stay beside those of now.
            fs::rename(&self.file, self.file.with_extension("toml~"))?;
        }
        let (origin, base, time) = (shown(&self.origin), sum(saved.as_bytes()), stamp(now));
        let whole = format!("{HEAD}{origin}{BASE}{base:016x}{TIME}{time}\n{text}");
        replace_unsynced(&self.file, whole.as_bytes())
    }

    /// The edits that were found are this session's now.
    pub(crate) fn take(&mut self) {
        self.kept = true;
    }

    /// There is nothing unsaved any more. What another session has left stays.
    pub(crate) fn drop_kept(&mut self) {
        if std::mem::take(&mut self.kept) {
            self.delete();
        }
    }

    /// Deletes what was found.
    pub(crate) fn delete(&mut self) {
        // What is not there needs no deleting, and what cannot be deleted is offered again.
        let _ = fs::remove_file(&self.file);
        self.kept = false;
    }
}

/// Makes a folder that others cannot look into.
fn make_private(folder: &Path) -> io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder)
}

/// A name in one line.
fn shown(origin: &str) -> String {
    crate::scene::harmless(origin, false)
}

/// FNV-1a: the same on every machine and in every version.
fn sum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, byte| {
        (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// The time as people write it, in Greenwich: `2026-11-21 14:03 UTC`.
fn stamp(now: SystemTime) -> String {
    let since = now.duration_since(UNIX_EPOCH).unwrap_or(Duration::ZERO);
    let minutes = since.as_secs() / 60;
    let (year, month, day) = date(minutes / (24 * 60));
    let (hour, minute) = (minutes / 60 % 24, minutes % 60);
    format!("{year:04}-{month:02}-{day:02} {hour:02}:{minute:02} UTC")
}

/// The date so many days after 1 January 1970, in the Gregorian calendar. Years begin in March here, so that
/// the day that leap years have more is their last.
fn date(days: u64) -> (u64, u64, u64) {
    // From 1 March of the year 0; 400 years have 146,097 days.
    let days = days + 719_468;
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let date = day - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    (400 * era + year + u64::from(month <= 2), month, date)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("krank-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        folder
    }

    #[test]
    fn times_are_those_of_the_calendar() {
        for (seconds, text) in [
            (0, "1970-01-01 00:00 UTC"),
            (951_782_399, "2000-02-28 23:59 UTC"),
            (951_782_400, "2000-02-29 00:00 UTC"),
            (1_795_269_780, "2026-11-21 14:03 UTC"),
            (4_107_542_400, "2100-03-01 00:00 UTC"),
        ] {
            assert_eq!(stamp(UNIX_EPOCH + Duration::from_secs(seconds)), text);
        }
    }

    #[test]
    fn edits_are_found_by_the_same_scene_alone() {
        let folder = folder("recovery").join("deep").join("er");
        let four_bar = Origin::Preset("four-bar".into());
        let mut one = Recovery::new(&folder, &four_bar, "old");
        assert_eq!(one.found("old"), None);
        let time = UNIX_EPOCH + Duration::from_secs(1_795_269_780);
        assert_eq!(one.keep("new\nlines\n", "old", time), None);
        let found = |origin: &Origin, present| Recovery::new(&folder, origin, "old").found(present);
        let edits = found(&four_bar, "old").unwrap();
        assert_eq!(edits.text, "new\nlines\n");
        assert_eq!(edits.time, "2026-11-21 14:03 UTC");
        assert!(!edits.stale);
        assert!(found(&four_bar, "other").unwrap().stale);
        assert_eq!(found(&four_bar, "new\nlines\n"), None, "nothing to offer");
        assert_eq!(found(&Origin::File("four-bar".into()), "old"), None);
        assert_eq!(found(&Origin::Stdin, "old"), None);
        one.drop_kept();
        assert_eq!(found(&four_bar, "old"), None);
        fs::remove_dir_all(folder.parent().unwrap().parent().unwrap()).unwrap();
    }

    #[test]
    fn edits_that_were_not_taken_are_not_written_over() {
        let folder = folder("recovery-left");
        let four_bar = Origin::Preset("four-bar".into());
        let now = SystemTime::now();
        assert_eq!(
            Recovery::new(&folder, &four_bar, "").keep("first", "old", now),
            None
        );
        let mut next = Recovery::new(&folder, &four_bar, "");
        assert_eq!(next.keep("second", "old", now), None);
        assert_eq!(next.keep("third", "old", now), None);
        let mut kept: Vec<String> = fs::read_dir(&folder)
            .unwrap()
            .map(|entry| fs::read_to_string(entry.unwrap().path()).unwrap())
            .collect();
        kept.sort_by_key(|text| text.lines().last().unwrap().to_owned());
        assert_eq!(kept.len(), 2);
        assert!(kept[0].ends_with("\nfirst") && kept[1].ends_with("\nthird"));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_folder_that_cannot_be_written_is_said_once() {
        let folder = folder("recovery-none");
        fs::write(&folder, "a file").unwrap();
        let mut recovery = Recovery::new(&folder, &Origin::Stdin, "");
        let now = SystemTime::now();
        let said = recovery.keep("text", "old", now).unwrap();
        assert!(
            said.starts_with("edits are not kept for recovery: "),
            "{said}"
        );
        assert_eq!(recovery.keep("text", "old", now), None);
        fs::remove_file(folder).unwrap();
    }
}
