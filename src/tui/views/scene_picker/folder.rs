//! Reads a folder for the scene picker: its folders, and its files that end in `.toml`.

use crate::files::read_file;
use crate::scene::MAX_FILE_SIZE;
use crate::task_file::TaskFile;
use std::ffi::OsStr;
use std::fs::{self, DirEntry};
use std::io;
use std::path::{Path, PathBuf};

/// File name extension of scenes.
const SCENE_EXTENSION: &str = "toml";
/// Maximum number of entries read. A longer list is of no use, and reading it would delay the keys.
const MAX_ENTRIES: usize = 50_000;

/// Maximum number of files whose contents are read to detect tasks; more would take too long.
const MAX_FILES_READ: usize = 1000;

/// The entries of a folder, each list sorted by name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Folder {
    /// The subfolders.
    pub(crate) folders: Vec<PathBuf>,
    /// All files named like a scene; their contents are checked when they are opened.
    pub(crate) scenes: Vec<PathBuf>,
    /// `true` if the folder has more entries than were read.
    pub(crate) is_cut: bool,
}

impl Folder {
    /// Reads a folder, without hidden entries and those that vanish meanwhile.
    ///
    /// # Errors
    /// Returns the system's error if the folder cannot be read.
    pub(crate) fn read(path: &Path) -> io::Result<Folder> {
        let mut folder = Folder::default();
        for (seen, entry) in fs::read_dir(path)?.enumerate() {
            if seen == MAX_ENTRIES {
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

    /// Removes the files that contain tasks. If there are many files, they are kept unread and
    /// checked when opened.
    pub(super) fn remove_tasks(&mut self) {
        if self.scenes.len() <= MAX_FILES_READ {
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
        } else if path.extension() == Some(OsStr::new(SCENE_EXTENSION)) {
            self.scenes.push(path);
        }
    }
}

/// Returns `true` for a folder or a symbolic link to one.
fn is_folder(entry: &DirEntry, path: &Path) -> bool {
    entry.file_type().is_ok_and(|kind| {
        kind.is_dir() || (kind.is_symlink() && fs::metadata(path).is_ok_and(|m| m.is_dir()))
    })
}

/// Returns `true` if a file is readable and contains a task.
fn is_task(path: &Path) -> bool {
    read_file(path, MAX_FILE_SIZE).is_ok_and(|bytes| TaskFile::is_task(&bytes))
}

/// Returns a sort key that ignores case first and then distinguishes it, so that the order is
/// fixed.
fn sorting(path: &Path) -> (String, String) {
    let name = name_of(path);
    (name.to_lowercase(), name)
}

/// Returns the last part of a path, with invalid characters replaced.
pub(crate) fn name_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}
