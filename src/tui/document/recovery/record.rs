//! The file format of recorded edits.
//!
//! ```text
//! krank-edits 2                    format version; 3 with `waits` lines
//! scene file 2f686f6d65...         kind, and name in hexadecimal digits
//! file 2049 131 1795269780000      device, inode, creation time; omitted if there is no file
//! base 8b1a9953c4611296            hash of the text before the edits
//! session 4711 1795269780123 host  process, start in ms, host
//! time 1795269780                  time of the edits, in seconds since 1970
//! waits 7233206c656e677468 333031  staged edit: value and text in hexadecimal digits; any number
//! edits                            or `none`
//!
//! text
//! ```

use super::UnsavedEdits;
use super::scene_id::{Identity, RecoverySubject};
use crate::tui::document::staged_edits::StagedEdits;
use rustix::system::uname;
use std::fmt::Write;
use std::fs;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

const MAGIC: &str = "krank-edits 2";
/// Version with staged edits. Older programs do not recognize such a record and leave the file
/// alone.
const MAGIC_WAITING: &str = "krank-edits 3";
/// Maximum length of the header, in bytes.
pub(super) const MAX_HEADER_LEN: usize = 16 << 10;
/// Maximum length of the host name in a file's name.
const MAX_HOST_LEN: usize = 64;

/// Returns this machine's name with all characters but ASCII letters and digits replaced, for use
/// in a file name.
fn this_host() -> String {
    let uname = uname();
    let host = uname.nodename().to_string_lossy();
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
    host.chars().map(plain).take(MAX_HOST_LEN).collect()
}

/// A run of the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SessionRun {
    pub(super) process: u32,
    /// The start in milliseconds since 1970, because process numbers are reused.
    start: u64,
    pub(super) host: String,
}

impl SessionRun {
    /// Creates the record of this process, started at `now`.
    pub(crate) fn started_at(now: SystemTime) -> SessionRun {
        let start = now.duration_since(UNIX_EPOCH).unwrap_or(Duration::ZERO);
        SessionRun {
            process: std::process::id(),
            start: u64::try_from(start.as_millis()).unwrap_or(u64::MAX),
            host: this_host(),
        }
    }

    /// Returns the name of the session's file, without its number and extension.
    pub(super) fn name(&self) -> String {
        format!("{}-{}-{}", self.host, self.process, self.start)
    }

    /// Returns `true` if the process is known to have ended, for systems where locks are
    /// unavailable.
    pub(super) fn has_ended(&self) -> bool {
        this_host() == self.host && !fs::exists(format!("/proc/{}", self.process)).unwrap_or(true)
    }
}

/// The recorded edits of a session.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Record {
    pub(super) subject: RecoverySubject,
    pub(super) session: SessionRun,
    pub(super) base: u64,
    /// The time of the edits, in seconds since 1970.
    pub(super) time: u64,
    /// The edits; `None` if there are none.
    pub(super) edits: Option<UnsavedEdits>,
}

impl Record {
    pub(super) fn bytes(&self) -> Vec<u8> {
        let SessionRun {
            process,
            start,
            host,
        } = &self.session;
        let waiting = self.edits.as_ref().map(|edits| edits.waiting.list());
        let waiting = waiting.unwrap_or_default();
        let magic = if waiting.is_empty() {
            MAGIC
        } else {
            MAGIC_WAITING
        };
        let (sort, name) = (&self.subject.sort, digits(&self.subject.name));
        let mut head = format!("{magic}\nscene {sort} {name}");
        if let Some([device, number, made]) = self.subject.file {
            let _ = write!(head, "\nfile {device} {number} {made}");
        }
        let _ = write!(
            head,
            "\nbase {:016x}\nsession {process} {start} {host}\ntime {}\n",
            self.base, self.time
        );
        for (name, text) in waiting {
            let [name, text] = [name, text].map(|text| digits(text.as_bytes()));
            let _ = writeln!(head, "waits {name} {text}");
        }
        head += match self.edits {
            Some(_) => "edits\n\n",
            None => "none\n\n",
        };
        [
            head.as_bytes(),
            self.edits
                .as_ref()
                .map_or("", |edits| &edits.text)
                .as_bytes(),
        ]
        .concat()
    }

    /// Parses a record. Returns `None` for any other contents.
    pub(super) fn read(bytes: &[u8]) -> Option<Record> {
        let (head, text) = std::str::from_utf8(bytes).ok()?.split_once("\n\n")?;
        let mut lines = head.lines();
        [MAGIC, MAGIC_WAITING]
            .contains(&lines.next()?)
            .then_some(())?;
        let mut line = |key: &str| {
            let rest = lines.clone().next()?.strip_prefix(key)?.strip_prefix(' ')?;
            lines.next();
            Some(rest)
        };
        let (sort, name) = line("scene")?.split_once(' ')?;
        let file = line("file").and_then(identity);
        let base = u64::from_str_radix(line("base")?, 16).ok()?;
        let mut session = line("session")?.splitn(3, ' ');
        let session = SessionRun {
            process: session.next()?.parse().ok()?,
            start: session.next()?.parse().ok()?,
            host: session.next()?.to_owned(),
        };
        let time = line("time")?.parse().ok()?;
        let mut waiting = StagedEdits::default();
        while let Some(waits) = line("waits") {
            let (name, text) = waits.split_once(' ')?;
            let text_of = |digits| String::from_utf8(of_digits(digits)?).ok();
            waiting.stage(&text_of(name)?, text_of(text)?, "");
        }
        let edits = || UnsavedEdits {
            text: text.to_owned(),
            waiting,
        };
        let subject = RecoverySubject {
            sort: sort.into(),
            name: of_digits(name)?,
            file,
            written: None,
        };
        Some(Record {
            subject,
            session,
            base,
            time,
            edits: (lines.next()? == "edits").then(edits),
        })
    }
}

fn identity(text: &str) -> Option<Identity> {
    let numbers: Option<Vec<u64>> = text.split(' ').map(|number| number.parse().ok()).collect();
    numbers?.try_into().ok()
}

fn digits(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut digits, byte| {
        let _ = write!(digits, "{byte:02x}");
        digits
    })
}

fn of_digits(digits: &str) -> Option<Vec<u8>> {
    let pairs = digits.as_bytes().chunks(2);
    pairs
        .map(|pair| u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok())
        .collect()
}

/// Computes the FNV-1a hash, which is equal on every machine and in every version.
pub(super) fn sum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, byte| {
        (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Returns the seconds since 1970.
pub(super) fn seconds(time: SystemTime) -> u64 {
    let since = time.duration_since(UNIX_EPOCH);
    since.unwrap_or(Duration::ZERO).as_secs()
}

/// Formats a time in UTC: `2026-11-21 14:03 UTC`.
pub(super) fn stamp(seconds: u64) -> String {
    let minutes = seconds / 60;
    let (year, month, day) = date(minutes / (24 * 60));
    let (hour, minute) = (minutes / 60 % 24, minutes % 60);
    format!("{year:04}-{month:02}-{day:02} {hour:02}:{minute:02} UTC")
}

/// Computes the Gregorian date a number of days after 1 January 1970. Internally, years begin in
/// March, so that a leap day is the last of its year.
fn date(days: u64) -> (u64, u64, u64) {
    // Days since 1 March of the year 0; 400 years have 146,097 days.
    let days = days.saturating_add(719_468);
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

    #[test]
    fn timestamps_follow_calendar() {
        for (seconds, text) in [
            (0, "1970-01-01 00:00 UTC"),
            (951_782_399, "2000-02-28 23:59 UTC"),
            (951_782_400, "2000-02-29 00:00 UTC"),
            (1_795_269_780, "2026-11-21 14:03 UTC"),
            (4_107_542_400, "2100-03-01 00:00 UTC"),
        ] {
            assert_eq!(stamp(seconds), text);
        }
    }

    #[test]
    fn records_round_trip() {
        let edits = |text: &str, waiting: &[(&str, &str)]| {
            let mut edits = UnsavedEdits::of(text);
            for (name, text) in waiting {
                edits.waiting.stage(name, (*text).to_owned(), "");
            }
            Some(edits)
        };
        for (file, edits) in [
            (None, None),
            (Some([1, 2, 3]), edits("a\n\nb", &[])),
            (Some([u64::MAX, 0, 0]), edits("", &[("r3 length", "2 * a")])),
            (None, edits("a", &[("\u{e4} x", "1\n\n2"), ("b", "3")])),
        ] {
            let record = Record {
                subject: RecoverySubject {
                    sort: "file".into(),
                    name: b"/a \xff\n".to_vec(),
                    file,
                    written: None,
                },
                session: SessionRun::started_at(SystemTime::now()),
                base: 7,
                time: 99,
                edits,
            };
            assert_eq!(Record::read(&record.bytes()).unwrap(), record);
        }
        for broken in ["", "krank-edits 2\n\n", "krank-edits 2\nscene file zz\n\n"] {
            assert_eq!(Record::read(broken.as_bytes()), None);
        }
    }
}
