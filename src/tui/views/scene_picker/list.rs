//! The list of the scene picker: a folder's files and the presets, filtered by typing.

use crate::scene::presets::{self, Preset};
use crate::scene::{Scene, sanitized};
use crate::tui::Origin;
use crate::tui::commands::key::Key;
use crate::tui::commands::line::EditLine;
use crate::tui::commands::list::List;
use crate::tui::views::scene_picker::folder::{Folder, name_of};
use crate::wording::words;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// The purpose for which a scene is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// To replace the open scene.
    Open,
    /// To be compared with the open scene.
    Compare,
}

/// An entry's target.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum PickerTarget {
    /// The open scene in its original version.
    Original,
    /// The candidates of the most recent task.
    Candidates,
    /// A folder to enter.
    Folder(PathBuf),
    /// A file.
    File(PathBuf),
    /// A preset.
    Preset(&'static str),
}

impl PickerTarget {
    /// Returns the target of an open scene's origin; `None` if it is neither a preset nor a file.
    pub(crate) fn of(origin: &Origin) -> Option<PickerTarget> {
        match origin {
            Origin::Preset(name) => {
                presets::find(name).map(|preset| PickerTarget::Preset(preset.name))
            }
            Origin::File(path) => {
                let folder = canonical_path(path.parent()?);
                Some(PickerTarget::File(folder.join(path.file_name()?)))
            }
            Origin::New(_) | Origin::Stdin => None,
        }
    }
}

/// An entry of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PickerItem {
    pub(crate) place: PickerTarget,
    /// The listed name: a file's name with its extension, or a folder's name with a trailing slash.
    pub(crate) name: String,
    /// The title of a preset; empty for a file, whose title is unknown until it is read.
    pub(crate) title: String,
    /// Name and title in lower case, for the search.
    key: String,
}

/// A line of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PickerRow<'p> {
    /// The heading of a folder's entries.
    Folder(&'p Path),
    /// The heading of the presets.
    Presets,
    /// A note in place of entries.
    Note(&'p str),
    /// An entry, and whether it is selected.
    Item(&'p PickerItem, bool),
}

/// The list, its search text and its cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Picker {
    purpose: Purpose,
    /// The entry above folders and files.
    first: Option<PickerItem>,
    /// The open scene, which is not compared with itself.
    here: Option<PickerTarget>,
    folder: PathBuf,
    /// The note about the folder.
    note: Option<String>,
    pub(crate) search: EditLine,
    /// The entries, of which those that match the search are listed.
    pub(crate) list: List<PickerItem>,
}

/// The entry that leads to the parent folder.
const ABOVE: &str = "..";

/// A folder with its contents, or the reason why it could not be read.
#[derive(Debug)]
pub(crate) struct FolderReading {
    folder: PathBuf,
    found: Result<Folder, String>,
}

impl FolderReading {
    /// Reads a folder, which may take long. Tasks are left out if a scene for a comparison is
    /// chosen.
    pub(crate) fn of(folder: &Path, purpose: Purpose) -> FolderReading {
        let folder = canonical_path(folder);
        let mut found = Folder::read(&folder).map_err(|why| words().cannot_be_read(&why));
        if let (Ok(found), Purpose::Compare) = (&mut found, purpose) {
            found.remove_tasks();
        }
        FolderReading { folder, found }
    }
}

impl Default for FolderReading {
    /// Creates the placeholder shown while a folder is read.
    fn default() -> Self {
        FolderReading {
            folder: PathBuf::new(),
            found: Err(words().folder_being_read().into()),
        }
    }
}

impl Picker {
    /// Creates a list with the presets; the folder's entries are added after it was read.
    pub(crate) fn new(
        purpose: Purpose,
        first: Option<PickerItem>,
        here: Option<PickerTarget>,
    ) -> Picker {
        let mut picker = Picker {
            purpose,
            first,
            here: here.filter(|_| purpose == Purpose::Compare),
            folder: PathBuf::new(),
            note: None,
            search: EditLine::for_scene(),
            list: List::new(Vec::new()),
        };
        picker.list(FolderReading::default(), None);
        picker
    }

    pub(crate) fn purpose(&self) -> Purpose {
        self.purpose
    }

    /// Returns the selected entry; `None` if there are no matches.
    pub(crate) fn chosen(&self) -> Option<&PickerItem> {
        self.list.chosen()
    }

    /// Lists a folder with an empty search; the cursor is on `at` if it is listed.
    pub(crate) fn list(&mut self, read: FolderReading, at: Option<&PickerTarget>) {
        self.folder = read.folder;
        self.search.clear();
        let above = self.folder.parent().map(Path::to_owned);
        let above = above.map(|above| PickerItem::new(PickerTarget::Folder(above), ABOVE, ""));
        let mut items: Vec<PickerItem> = self.first.clone().into_iter().chain(above).collect();
        self.note = match read.found {
            Ok(found) => take(found, &mut items),
            Err(why) => Some(why),
        };
        let presets = presets::all().iter().zip(TITLES.iter());
        items.extend(presets.map(|(p, title)| {
            let title = words().translated_scene_text(title);
            PickerItem::new(PickerTarget::Preset(p.name), p.name, &title)
        }));
        items.retain(|item| Some(&item.place) != self.here.as_ref());
        self.list = List::new(items);
        if !at.is_some_and(|at| self.list.go_to(|item| item.place == *at)) {
            self.go_to_scene();
        }
    }

    /// Returns `true` if a folder is the parent of the listed one.
    pub(crate) fn is_above(&self, folder: &Path) -> bool {
        self.folder.parent() == Some(folder)
    }

    /// Returns the parent of the listed folder, and the listed folder as an entry of it.
    pub(crate) fn parent_entry(&self) -> Option<(PathBuf, PickerTarget)> {
        let above = self.folder.parent()?.to_owned();
        Some((above, PickerTarget::Folder(self.folder.clone())))
    }

    /// Handles a key that edits the search. Returns `false` for all others.
    pub(crate) fn edit(&mut self, key: Key) -> bool {
        // A leading blank searches for nothing.
        let is_empty = self.search.text().is_empty();
        let changed = match key {
            Key::Char(' ') if is_empty => Some(false),
            _ => self.search.change(key),
        };
        if changed == Some(true) {
            self.search_again();
        }
        changed.is_some()
    }

    /// Returns the lines of the list: the matches under the headings of their parts.
    pub(crate) fn rows(&self) -> Vec<PickerRow<'_>> {
        let mut rows = Vec::with_capacity(self.list.count().0 + 3);
        let (mut in_folder, mut in_presets) = (false, false);
        // The note about the folder is shown only without a search.
        let is_whole = self.search.text().is_empty();
        let note = self.note.as_deref().filter(|_| is_whole);
        for (at, item) in self.list.listed().enumerate() {
            match item.place {
                PickerTarget::Original | PickerTarget::Candidates => {}
                PickerTarget::Folder(_) | PickerTarget::File(_) => {
                    if !in_folder {
                        rows.push(PickerRow::Folder(&self.folder));
                    }
                    in_folder = true;
                }
                PickerTarget::Preset(_) => {
                    if !in_presets {
                        rows.extend(note.map(PickerRow::Note));
                        rows.push(PickerRow::Presets);
                    }
                    in_presets = true;
                }
            }
            rows.push(PickerRow::Item(item, at == self.list.cursor()));
        }
        rows
    }

    /// Lists the entries whose name or title contains every word of the search. The cursor goes to
    /// the first match that begins with the search, or else to the first scene. The entry of the
    /// parent folder is not searched.
    fn search_again(&mut self) {
        let typed = self.search.text().to_lowercase();
        let words: Vec<&str> = typed.split_whitespace().collect();
        self.list.narrow(|item| {
            words.is_empty()
                || (item.name != ABOVE && words.iter().all(|word| item.key.contains(word)))
        });
        if typed.is_empty() || !self.list.go_to(|item| item.key.starts_with(&typed)) {
            self.go_to_scene();
        }
    }

    /// Moves the cursor to the first scene, because folders come first but are rarely meant.
    fn go_to_scene(&mut self) {
        self.list.move_by(isize::MIN);
        let is_scene = |item: &PickerItem| !matches!(item.place, PickerTarget::Folder(_));
        self.list.go_to(is_scene);
    }
}

/// Adds the entries of a folder and returns the note about it.
fn take(found: Folder, items: &mut Vec<PickerItem>) -> Option<String> {
    let note = match (found.is_cut, found.scenes.is_empty()) {
        (true, _) => Some(words().more_than_can_be_listed()),
        (false, true) => Some(words().no_scene_file_here()),
        (false, false) => None,
    };
    items.extend(found.folders.into_iter().map(|path| {
        let name = format!("{}/", name_of(&path));
        PickerItem::new(PickerTarget::Folder(path), &name, "")
    }));
    items.extend(found.scenes.into_iter().map(|path| {
        let name = name_of(&path);
        PickerItem::new(PickerTarget::File(path), &name, "")
    }));
    note.map(str::to_owned)
}

impl PickerItem {
    pub(crate) fn new(place: PickerTarget, name: &str, title: &str) -> PickerItem {
        let plain = sanitized(title, true);
        PickerItem {
            place,
            name: name.to_owned(),
            title: title.to_owned(),
            // A form without Turkish letters, for keyboards that lack them.
            key: format!("{name} {title} {plain}").to_lowercase(),
        }
    }
}

/// The titles of the presets from their files, in the order of the presets.
static TITLES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let title = |preset: &Preset| Scene::parse(preset.text, preset.name).map(|scene| scene.name);
    let titles = presets::all().iter().map(title);
    titles.map(Result::unwrap_or_default).collect()
});

/// Returns the canonical path of a folder, whose parents can be entered; a `..` in its middle would
/// prevent that. A path that does not exist is only made absolute.
fn canonical_path(folder: &Path) -> PathBuf {
    let folder = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    let complete = folder.canonicalize();
    complete.unwrap_or_else(|_| std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_match_without_diacritics() {
        let place = PickerTarget::Original;
        let item = PickerItem::new(place, "hoecken", "Hoecken'in do\u{11f}ru \u{e7}izen");
        for typed in ["dogru", "do\u{11f}ru", "cizen", "hoecken"] {
            assert!(item.key.contains(typed), "{typed}: {}", item.key);
        }
        assert!(!item.key.contains("kite"));
    }
}
