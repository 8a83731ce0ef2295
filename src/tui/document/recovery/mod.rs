//! Unsaved edits, kept in a file beside the person's other state until they are saved or dropped: whatever
//! ends the program, they are there when it is started again.
//!
//! Every session has a file of its own, which it keeps locked: one without a lock is what a session has left
//! that is no more. A session that has edited nothing has one too, for others to know that it is there.

mod record;
mod subject;

pub(crate) use record::SessionRun;

use crate::files::{DraftFile, is_held, limited, make_private, open_to_read};
use crate::scene::LARGEST_FILE;
use crate::tui::Origin;
use crate::tui::document::gathered::GatheredEdits;
use crate::wording::words;
use record::{LONGEST_HEAD, Record, sum};
use std::fs::{self, File};
use std::io::{self, Write};
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::SystemTime;
use subject::RecoverySubject;

/// More files than this nobody leaves; the rest is not read.
const MOST_FILES: usize = 1000;
/// Who puts another file there each time that we look is alive.
const MOST_READS: usize = 10;
/// What the names of edits end with.
const ENDS: &str = "edits";

/// What is unsaved of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct KeptEdits {
    /// The edited text.
    pub(crate) text: String,
    /// What waits to be made of it.
    pub(crate) waiting: GatheredEdits,
}

/// Edits that an earlier session has left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Generation {
    pub(crate) edits: KeptEdits,
    /// When they were made: `2026-11-21 14:03 UTC`.
    pub(crate) time: String,
    /// Whether they were made on another text than the file has now.
    pub(crate) is_stale: bool,
    /// Whether the file was written after they were made.
    pub(crate) is_older: bool,
    /// Where they are kept.
    pub(crate) file: PathBuf,
    made: u64,
}

/// Another session on the same scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Alive {
    pub(crate) process: u32,
    pub(crate) host: String,
    /// When it opened the scene, or edited it last.
    pub(crate) time: String,
}

/// What others have kept of a scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Others {
    pub(crate) alive: Vec<Alive>,
    /// The latest first.
    pub(crate) left: Vec<Generation>,
}

impl KeptEdits {
    /// An edited text of which nothing waits.
    #[cfg(test)]
    pub(crate) fn of(text: &str) -> KeptEdits {
        KeptEdits {
            text: text.to_owned(),
            waiting: GatheredEdits::default(),
        }
    }

    /// Whether they are any, beside this text.
    fn change(&self, present: &str) -> bool {
        self.text != present || !self.waiting.is_empty()
    }
}

/// Where the edits of one scene are kept in this session.
#[derive(Debug)]
pub(crate) struct Recovery {
    folder: PathBuf,
    session: SessionRun,
    subject: RecoverySubject,
    /// Which of the scenes that were opened in this session it is.
    number: u32,
    /// The file of this session, which is locked as long as it is open.
    held: Option<File>,
    /// Whether it holds edits.
    kept: bool,
    /// Whether it was said that they cannot be kept.
    told: bool,
    /// Edits of earlier sessions that were taken up.
    taken: Vec<Taken>,
}

/// Edits that were taken up. They go with those of this session, unless they were taken back.
#[derive(Debug)]
struct Taken {
    file: PathBuf,
    text: String,
    /// Whether what is edited now stands on them.
    is_in: bool,
}

impl Recovery {
    /// For the scene that was opened with this text. Others are told that a file is open here.
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
            told: false,
            taken: Vec::new(),
        };
        recovery.announce();
        recovery
    }

    /// What others have kept of this scene, whose text is `present`.
    pub(crate) fn others(&self, present: &str) -> Others {
        let mut others = Others::default();
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        for entry in entries.take(MOST_FILES) {
            let path = entry.path();
            if path.extension().is_some_and(|end| end == ENDS) {
                self.judge(path, present, &mut others);
            }
        }
        others
            .left
            .sort_by(|a, b| b.made.cmp(&a.made).then(b.file.cmp(&a.file)));
        others
    }

    fn judge(&self, path: PathBuf, present: &str, others: &mut Others) {
        let Some((record, held)) = read_record(&path) else {
            return;
        };
        if record.session == self.session {
            return;
        }
        let is_alive = held.unwrap_or_else(|| !record.session.is_gone());
        match record.edits {
            _ if is_alive => {
                // Of what no file holds everybody has their own.
                if self.subject.is_file() && self.subject.is(&record.subject) {
                    others.alive.push(Alive {
                        process: record.session.process,
                        host: record.session.host,
                        time: record::stamp(record.time),
                    });
                }
            }
            // It had nothing to lose.
            None => drop(fs::remove_file(path)),
            Some(edits) if self.subject.is(&record.subject) && edits.change(present) => {
                others.left.push(Generation {
                    edits,
                    time: record::stamp(record.time),
                    is_stale: record.base != sum(present.as_bytes()),
                    is_older: self.subject.written.is_some_and(|at| at > record.time),
                    file: path,
                    made: record.time,
                });
            }
            Some(_) => {}
        }
    }

    /// Keeps edits; in words why it cannot, once.
    pub(crate) fn keep(
        &mut self,
        edits: KeptEdits,
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
            Err(_) if std::mem::replace(&mut self.told, true) => None,
            Err(error) => Some(words().edits_not_kept(&self.folder.display(), &error)),
        }
    }

    /// Puts the file of this session in the place of the one before.
    fn write(&mut self, edits: Option<KeptEdits>, saved: &str, now: SystemTime) -> io::Result<()> {
        make_private(&self.folder)?;
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

    /// Tells others that a file is open here, without edits. What is no file is nobody else's business.
    fn announce(&mut self) {
        if self.subject.is_file() {
            // What cannot be kept is said with the first edit.
            let _ = self.write(None, "", SystemTime::now());
        } else if self.held.take().is_some() {
            delete(&self.file());
        }
    }

    /// These edits of an earlier session are this one's now.
    pub(crate) fn take(&mut self, file: PathBuf, text: String) {
        self.taken.push(Taken {
            file,
            text,
            is_in: true,
        });
    }

    /// Nothing of this session is unsaved any more: what was taken up was taken back, and stays.
    pub(crate) fn rest(&mut self) {
        for taken in &mut self.taken {
            taken.is_in = false;
        }
        if std::mem::take(&mut self.kept) {
            self.announce();
        }
    }

    /// All was saved, or dropped: what was taken up too. What other sessions have left stays.
    pub(crate) fn release(&mut self) {
        self.drop_taken();
        self.rest();
    }

    /// What was taken up is saved, or dropped; what is kept of this session stays.
    pub(crate) fn drop_taken(&mut self) {
        for taken in self.taken.extract_if(.., |taken| taken.is_in) {
            delete(&taken.file);
        }
    }
}

impl Drop for Recovery {
    /// Edits stay, and are offered again.
    fn drop(&mut self) {
        if !self.kept && self.held.is_some() {
            delete(&self.file());
        }
    }
}

/// What lies there, and whether its session holds it. A session that puts its next edits there lets go of the
/// file that held those before: that one is no file of a session that is no more.
fn read_record(path: &Path) -> Option<(Record, Option<bool>)> {
    for _ in 0..MOST_READS {
        let file = open_to_read(path).ok()?;
        let held = is_held(&file);
        if file.metadata().ok()?.nlink() > 0 {
            let bytes = limited(&file, LARGEST_FILE + LONGEST_HEAD).ok()?;
            return Some((Record::read(&bytes)?, held));
        }
    }
    None
}

/// Deletes edits that a person has no use for. What cannot be deleted is offered again.
pub(crate) fn delete(file: &Path) {
    let _ = fs::remove_file(file);
}

#[cfg(test)]
mod tests;
