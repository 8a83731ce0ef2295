//! The list of the scene picker: a folder's files and the presets, filtered by typing.

use crate::scene::presets::{self, Preset};
use crate::scene::{Scene, is_harmful, sanitized};
use crate::tui::Origin;
use crate::tui::views::picker::folder::{Folder, name_of};
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
                let folder = whole(path.parent()?);
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
    items: Vec<PickerItem>,
    search: String,
    /// Indices of the entries that match the search.
    matches: Vec<usize>,
    /// Index into the matches.
    cursor: usize,
}

/// Maximum length of a search, in characters; a longer one would not find more.
const MAX_SEARCH_LEN: usize = 40;
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
        let folder = whole(folder);
        let mut found = Folder::read(&folder).map_err(|why| words().cannot_be_read(&why));
        if let (Ok(found), Purpose::Compare) = (&mut found, purpose) {
            found.leave_out_tasks();
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
            items: Vec::new(),
            search: String::new(),
            matches: Vec::new(),
            cursor: 0,
        };
        picker.list(FolderReading::default(), None);
        picker
    }

    pub(crate) fn purpose(&self) -> Purpose {
        self.purpose
    }

    pub(crate) fn search(&self) -> &str {
        &self.search
    }

    /// Returns the number of matching entries and the number of all entries.
    pub(crate) fn count(&self) -> (usize, usize) {
        (self.matches.len(), self.items.len())
    }

    /// Returns the selected entry; `None` if there are no matches.
    pub(crate) fn chosen(&self) -> Option<&PickerItem> {
        let number = self.matches.get(self.cursor)?;
        self.items.get(*number)
    }

    /// Lists a folder with an empty search; the cursor is on `at` if it is listed.
    pub(crate) fn list(&mut self, read: FolderReading, at: Option<&PickerTarget>) {
        self.folder = read.folder;
        self.search.clear();
        self.items.clear();
        self.items.extend(self.first.clone());
        let above = self.folder.parent().map(Path::to_owned);
        let above = above.map(|above| PickerItem::new(PickerTarget::Folder(above), ABOVE, ""));
        self.items.extend(above);
        self.note = match read.found {
            Ok(found) => self.take(found),
            Err(why) => Some(why),
        };
        let presets = presets::all().iter().zip(TITLES.iter());
        self.items.extend(presets.map(|(p, title)| {
            let title = words().translated_scene_text(title);
            PickerItem::new(PickerTarget::Preset(p.name), p.name, &title)
        }));
        self.items
            .retain(|item| Some(&item.place) != self.here.as_ref());
        self.narrow();
        let known = |place: &PickerTarget| self.items.iter().position(|item| item.place == *place);
        self.cursor = at.and_then(known).unwrap_or_else(|| self.first_scene());
    }

    /// Adds the entries of the folder and returns the note about it.
    fn take(&mut self, found: Folder) -> Option<String> {
        let note = match (found.is_cut, found.scenes.is_empty()) {
            (true, _) => Some(words().more_than_can_be_listed()),
            (false, true) => Some(words().no_scene_file_here()),
            (false, false) => None,
        };
        for path in found.folders {
            let name = format!("{}/", name_of(&path));
            self.items
                .push(PickerItem::new(PickerTarget::Folder(path), &name, ""));
        }
        for path in found.scenes {
            let name = name_of(&path);
            self.items
                .push(PickerItem::new(PickerTarget::File(path), &name, ""));
        }
        note.map(str::to_owned)
    }

    /// Returns `true` if a folder is the parent of the listed one.
    pub(crate) fn is_above(&self, folder: &Path) -> bool {
        self.folder.parent() == Some(folder)
    }

    /// Returns the parent of the listed folder, and the listed folder as an entry of it.
    pub(crate) fn above(&self) -> Option<(PathBuf, PickerTarget)> {
        let above = self.folder.parent()?.to_owned();
        Some((above, PickerTarget::Folder(self.folder.clone())))
    }

    /// Appends a character to the search. Rejects control characters that could affect the
    /// terminal, and a leading blank.
    pub(crate) fn push(&mut self, c: char) {
        let fits = self.search.chars().count() < MAX_SEARCH_LEN;
        if fits && !is_harmful(c) && !(c == ' ' && self.search.is_empty()) {
            self.search.push(c);
            self.search_again();
        }
    }

    pub(crate) fn erase(&mut self) {
        if self.search.pop().is_some() {
            self.search_again();
        }
    }

    pub(crate) fn clear(&mut self) {
        self.search.clear();
        self.search_again();
    }

    /// Moves the cursor by `entries` within the matches.
    pub(crate) fn move_by(&mut self, entries: isize) {
        let most = self.matches.len().saturating_sub(1);
        self.cursor = self.cursor.saturating_add_signed(entries).min(most);
    }

    /// Returns the lines of the list: the matches under the headings of their parts.
    pub(crate) fn rows(&self) -> Vec<PickerRow<'_>> {
        let items = self.matches.iter().enumerate();
        let items = items.filter_map(|(i, &n)| Some((i == self.cursor, self.items.get(n)?)));
        let mut rows = Vec::with_capacity(self.matches.len() + 3);
        let (mut in_folder, mut in_presets) = (false, false);
        // The note about the folder is shown only without a search.
        let note = self.note.as_deref().filter(|_| self.search.is_empty());
        for (under_cursor, item) in items {
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
            rows.push(PickerRow::Item(item, under_cursor));
        }
        rows
    }

    /// Filters again after a change of the search. The cursor goes to the first match that begins
    /// with the search, or else to the first scene.
    fn search_again(&mut self) {
        self.narrow();
        let typed = self.search.to_lowercase();
        let begins = |n: &usize| self.items[*n].key.starts_with(&typed);
        let begun = self.matches.iter().position(begins);
        self.cursor = match begun.filter(|_| !typed.is_empty()) {
            Some(cursor) => cursor,
            None => self.first_scene(),
        };
    }

    /// Selects the entries whose name or title contains every word of the search. The entry of the
    /// parent folder is not searched.
    fn narrow(&mut self) {
        let typed = self.search.to_lowercase();
        let words: Vec<&str> = typed.split_whitespace().collect();
        let matches = |item: &PickerItem| {
            words.is_empty()
                || (item.name != ABOVE && words.iter().all(|word| item.key.contains(word)))
        };
        let numbered = self.items.iter().enumerate();
        let found = numbered.filter(|(_, item)| matches(item));
        self.matches = found.map(|(n, _)| n).collect();
    }

    /// Returns the default cursor: the first scene, because folders come first but are rarely
    /// meant.
    fn first_scene(&self) -> usize {
        let is_scene = |n: &usize| !matches!(self.items[*n].place, PickerTarget::Folder(_));
        self.matches.iter().position(is_scene).unwrap_or(0)
    }
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
fn whole(folder: &Path) -> PathBuf {
    let folder = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    let whole = folder.canonicalize();
    whole.unwrap_or_else(|_| std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned()))
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
