//! Records unsaved edits in the user's state folder until they are saved or discarded, so that they
//! survive any end of the program.
//!
//! Every session keeps its own locked file. A file without a lock was left by a session that has
//! ended. A session without edits has a file too, so that others see it.

mod record;
mod scene_id;

pub(crate) use record::SessionRun;

use crate::files::{DraftFile, create_private_folder, is_held, limited, open_to_read};
use crate::scene::MAX_FILE_SIZE;
use crate::tui::Origin;
use crate::tui::document::staged_edits::StagedEdits;
use crate::wording::words;
use record::{MAX_HEADER_LEN, Record, sum};
use scene_id::RecoverySubject;
use std::fs::{self, File};
use std::io::{self, Write};
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::SystemTime;

/// Maximum number of files read.
const MAX_FILES: usize = 1000;
/// Maximum number of attempts to read a file that its session keeps replacing. Such a session is
/// running.
const MAX_READS: usize = 10;
/// The extension of recorded edits.
const ENDS: &str = "edits";

/// The unsaved edits of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct UnsavedEdits {
    /// The edited text.
    pub(crate) text: String,
    /// The staged edits.
    pub(crate) waiting: StagedEdits,
}

/// Edits left by an earlier session.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Generation {
    pub(crate) edits: UnsavedEdits,
    /// The time of the edits: `2026-11-21 14:03 UTC`.
    pub(crate) time: String,
    /// `true` if they are based on a text that differs from the file's current one.
    pub(crate) is_stale: bool,
    /// `true` if the file was written after the edits.
    pub(crate) is_older: bool,
    /// The file that records them.
    pub(crate) file: PathBuf,
    created: u64,
}

/// Another running session on the same scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct OtherSession {
    pub(crate) process: u32,
    pub(crate) host: String,
    /// The time when it opened the scene or edited it last.
    pub(crate) time: String,
}

/// The records of other sessions on a scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct OtherSessions {
    pub(crate) alive: Vec<OtherSession>,
    /// Edits of ended sessions, the latest first.
    pub(crate) left: Vec<Generation>,
}

impl UnsavedEdits {
    /// Creates edits without staged ones.
    #[cfg(test)]
    pub(crate) fn of(text: &str) -> UnsavedEdits {
        UnsavedEdits {
            text: text.to_owned(),
            waiting: StagedEdits::default(),
        }
    }

    /// Returns `true` if there is any change from `present`.
    fn change(&self, present: &str) -> bool {
        self.text != present || !self.waiting.is_empty()
    }
}

/// The record of one scene's edits in this session.
#[derive(Debug)]
pub(crate) struct Recovery {
    folder: PathBuf,
    session: SessionRun,
    subject: RecoverySubject,
    /// The number of the scene among those opened in this session.
    number: u32,
    /// The session's file, locked while it is open.
    held: Option<File>,
    /// `true` if the file holds edits.
    kept: bool,
    /// `true` if a failure to record edits was reported.
    failure_reported: bool,
    /// Restored edits of earlier sessions.
    taken: Vec<RestoredEdits>,
}

/// Restored edits. Their file is deleted with those of this session, unless they were undone.
#[derive(Debug)]
struct RestoredEdits {
    file: PathBuf,
    text: String,
    /// `true` if the current text includes these edits.
    is_in: bool,
}

impl Recovery {
    /// Creates the record for a scene opened with this text. A scene from a file is announced to
    /// other sessions.
    pub(crate) fn new(
        folder: &Path,
        session: &SessionRun,
        origin: &Origin,
        text: &str,
    ) -> Recovery {
        static OPENED: AtomicU32 = AtomicU32::new(1);
        let mut recovery = Recovery {
            number: OPENED.fetch_add(1, Ordering::Relaxed),
            folder: folder.to_owned(),
            session: session.clone(),
            subject: RecoverySubject::of(origin, text),
            held: None,
            kept: false,
            failure_reported: false,
            taken: Vec::new(),
        };
        recovery.announce();
        recovery
    }

    /// Returns the records of other sessions on this scene, whose text is `present`.
    pub(crate) fn others(&self, present: &str) -> OtherSessions {
        let mut others = OtherSessions::default();
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        for entry in entries.take(MAX_FILES) {
            let path = entry.path();
            if path.extension().is_some_and(|end| end == ENDS) {
                self.classify_record(path, present, &mut others);
            }
        }
        others
            .left
            .sort_by(|a, b| b.created.cmp(&a.created).then(b.file.cmp(&a.file)));
        others
    }

    fn classify_record(&self, path: PathBuf, present: &str, others: &mut OtherSessions) {
        let Some((record, held)) = read_record(&path) else {
            return;
        };
        if record.session == self.session {
            return;
        }
        let is_alive = held.unwrap_or_else(|| !record.session.has_ended());
        match record.edits {
            _ if is_alive => {
                // Scenes without a file are private to each session.
                if self.subject.is_file() && self.subject.is(&record.subject) {
                    others.alive.push(OtherSession {
                        process: record.session.process,
                        host: record.session.host,
                        time: record::stamp(record.time),
                    });
                }
            }
            // The session had no edits.
            None => drop(fs::remove_file(path)),
            Some(edits) if self.subject.is(&record.subject) && edits.change(present) => {
                others.left.push(Generation {
                    edits,
                    time: record::stamp(record.time),
                    is_stale: record.base != sum(present.as_bytes()),
                    is_older: self.subject.written.is_some_and(|at| at > record.time),
                    file: path,
                    created: record.time,
                });
            }
            Some(_) => {}
        }
    }

    /// Records edits. Returns a message on the first failure only.
    pub(crate) fn keep(
        &mut self,
        edits: UnsavedEdits,
        saved: &str,
        now: SystemTime,
    ) -> Option<String> {
        for taken in &mut self.taken {
            taken.is_in |= taken.text == edits.text;
        }
        match self.write(Some(edits), saved, now) {
            Ok(()) => {
                self.kept = true;
                None
            }
            Err(_) if std::mem::replace(&mut self.failure_reported, true) => None,
            Err(error) => Some(words().edits_not_kept(&self.folder.display(), &error)),
        }
    }

    /// Replaces the session's file atomically.
    fn write(
        &mut self,
        edits: Option<UnsavedEdits>,
        saved: &str,
        now: SystemTime,
    ) -> io::Result<()> {
        create_private_folder(&self.folder)?;
        let record = Record {
            subject: self.subject.clone(),
            session: self.session.clone(),
            base: sum(saved.as_bytes()),
            time: record::seconds(now),
            edits,
        };
        let mut draft = DraftFile::private(&self.folder)?;
        draft.file.write_all(&record.bytes())?;
        self.held = Some(draft.replace(&self.file())?);
        Ok(())
    }

    fn file(&self) -> PathBuf {
        let (session, number) = (self.session.name(), self.number);
        self.folder.join(format!("{session}-{number}.{ENDS}"))
    }

    /// Announces the open file to other sessions, without edits. A scene without a file is not
    /// announced.
    fn announce(&mut self) {
        if self.subject.is_file() {
            // A failure is reported with the first edit.
            let _ = self.write(None, "", SystemTime::now());
        } else if self.held.take().is_some() {
            delete(&self.file());
        }
    }

    /// Adopts the edits of an earlier session.
    pub(crate) fn take(&mut self, file: PathBuf, text: String) {
        self.taken.push(RestoredEdits {
            file,
            text,
            is_in: true,
        });
    }

    /// Notes that this session has no unsaved edits. Restored edits were undone, so their files
    /// stay.
    pub(crate) fn rest(&mut self) {
        for taken in &mut self.taken {
            taken.is_in = false;
        }
        if std::mem::take(&mut self.kept) {
            self.announce();
        }
    }

    /// Notes that all edits were saved or discarded, including restored ones. Other records stay.
    pub(crate) fn release(&mut self) {
        self.drop_taken();
        self.rest();
    }

    /// Deletes the files of restored edits that are in the current text. This session's record
    /// stays.
    pub(crate) fn drop_taken(&mut self) {
        for taken in self.taken.extract_if(.., |taken| taken.is_in) {
            delete(&taken.file);
        }
    }
}

impl Drop for Recovery {
    /// Keeps recorded edits, to be offered again; deletes an announcement.
    fn drop(&mut self) {
        if !self.kept && self.held.is_some() {
            delete(&self.file());
        }
    }
}

/// Reads a record, and whether its session holds the lock (`None` if unknown). A session replaces
/// its file with every edit and unlocks the old one. A file without a directory entry is therefore
/// read again, not taken for that of an ended session.
fn read_record(path: &Path) -> Option<(Record, Option<bool>)> {
    for _ in 0..MAX_READS {
        let file = open_to_read(path).ok()?;
        let held = is_held(&file);
        if file.metadata().ok()?.nlink() > 0 {
            let bytes = limited(&file, MAX_FILE_SIZE + MAX_HEADER_LEN).ok()?;
            return Some((Record::read(&bytes)?, held));
        }
    }
    None
}

/// Deletes unwanted edits. If that fails, they are offered again.
pub(crate) fn delete(file: &Path) {
    let _ = fs::remove_file(file);
}

#[cfg(test)]
mod tests;
