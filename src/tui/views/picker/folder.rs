//! What a folder holds for somebody who looks for a scene: other folders, and files that end in
//! `.toml`.

use crate::files::read_file;
use crate::scene::LARGEST_FILE;
use crate::task_file::TaskFile;
use std::ffi::OsStr;
use std::fs::{self, DirEntry};
use std::io;
use std::path::{Path, PathBuf};

/// The ending of scene files.
const ENDING: &str = "toml";
/// More than this nobody looks through, and reading them all would keep the keys waiting.
const MOST_ENTRIES: usize = 50_000;

/// To know what more files hold than this takes too long.
const MOST_READ: usize = 1000;

/// What a folder holds, each part in the order of its names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Folder {
    /// The folders in it.
    pub(crate) folders: Vec<PathBuf>,
    /// Whatever is called like a scene file: whether it is one shows when it is opened.
    pub(crate) scenes: Vec<PathBuf>,
    /// Whether there is so much in it that the rest was left unread.
    pub(crate) is_cut: bool,
}

impl Folder {
    /// Reads a folder. Hidden entries, and those that vanish meanwhile, are left out.
    ///
    /// # Errors
    /// What the system says where it cannot be read.
    pub(crate) fn read(path: &Path) -> io::Result<Folder> {
        let mut folder = Folder::default();
        for (seen, entry) in fs::read_dir(path)?.enumerate() {
            if seen == MOST_ENTRIES {
                folder.is_cut = true;
                break;
            }
            if let Ok(entry) = entry {
                folder.take(&entry);
            }
        }
        folder.folders.sort_by_cached_key(|path| sorting(path));
        folder.scenes.sort_by_cached_key(|path| sorting(path));
        Ok(folder)
    }

    /// Leaves out files that hold tasks. Of many files none is read: what they are shows when they are opened.
    pub(super) fn leave_out_tasks(&mut self) {
        if self.scenes.len() <= MOST_READ {
            self.scenes.retain(|path| !is_task(path));
        }
    }

    fn take(&mut self, entry: &DirEntry) {
        if entry.file_name().as_encoded_bytes().starts_with(b".") {
            return;
        }
        let path = entry.path();
        if is_folder(entry, &path) {
            self.folders.push(path);
        } else if path.extension() == Some(OsStr::new(ENDING)) {
            self.scenes.push(path);
        }
    }
}

/// Whether it is a folder, or a link to one.
fn is_folder(entry: &DirEntry, path: &Path) -> bool {
    entry.file_type().is_ok_and(|kind| {
        kind.is_dir() || (kind.is_symlink() && fs::metadata(path).is_ok_and(|m| m.is_dir()))
    })
}

/// Whether a file that can be read holds a task.
fn is_task(path: &Path) -> bool {
    read_file(path, LARGEST_FILE).is_ok_and(|bytes| TaskFile::is_meant(&bytes))
}

/// Capitals beside their small letters; what differs by them alone keeps one order.
fn sorting(path: &Path) -> (String, String) {
    let name = name_of(path);
    (name.to_lowercase(), name)
}

/// The last part of a path, as far as it is text.
pub(crate) fn name_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}
