//! Choosing a scene: the files of a folder and the presets as one list, which narrows as one types.

use crate::scene::presets::{self, Preset};
use crate::scene::{Scene, is_harmful, sanitized};
use crate::tui::Origin;
use crate::tui::views::picker::folder::{Folder, name_of};
use crate::wording::words;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// What a scene is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// To be opened in place of the open one.
    Open,
    /// To be held against the open one.
    Compare,
}

/// What can be chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum PickerTarget {
    /// The open scene, as it was when it was opened.
    Original,
    /// The linkages for the task that was looked at last.
    Candidates,
    /// A folder to look into.
    Folder(PathBuf),
    /// A file.
    File(PathBuf),
    /// A preset.
    Preset(&'static str),
}

impl PickerTarget {
    /// Where an open scene comes from.
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
    /// As it is listed: the name of a file with its ending, of a folder with a stroke behind it.
    pub(crate) name: String,
    /// The title of a preset; of a file nothing is known until it is looked at.
    pub(crate) title: String,
    /// Name and title in small letters, for the search.
    key: String,
}

/// A line of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PickerRow<'p> {
    /// The folder whose files follow.
    Folder(&'p Path),
    /// The presets follow.
    Presets,
    /// Something to know, where entries could be expected.
    Note(&'p str),
    /// An entry, and whether it is under the cursor.
    Item(&'p PickerItem, bool),
}

/// The list, what was typed to narrow it, and the cursor in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Picker {
    purpose: Purpose,
    /// What stands before folders and files.
    first: Option<PickerItem>,
    /// The open scene, which is not compared with itself.
    here: Option<PickerTarget>,
    folder: PathBuf,
    /// What is to be said about the folder.
    note: Option<String>,
    items: Vec<PickerItem>,
    search: String,
    /// The numbers of the entries that match the search.
    matches: Vec<usize>,
    /// Which of the matches the cursor is on.
    cursor: usize,
}

/// Longer searches find nothing that shorter ones do not.
const LONGEST_SEARCH: usize = 40;
/// Leads out of a folder.
const ABOVE: &str = "..";

/// A folder, and what was found in it, or in words why nothing was.
#[derive(Debug)]
pub(crate) struct FolderReading {
    folder: PathBuf,
    found: Result<Folder, String>,
}

impl FolderReading {
    /// Reads a folder, which may take long. A task is nothing to be compared with.
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
    /// None so far.
    fn default() -> Self {
        FolderReading {
            folder: PathBuf::new(),
            found: Err(words().folder_being_read().into()),
        }
    }
}

impl Picker {
    /// The presets; a folder is listed once it was read.
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

    /// How many entries match, of how many.
    pub(crate) fn count(&self) -> (usize, usize) {
        (self.matches.len(), self.items.len())
    }

    /// The entry under the cursor; `None` where nothing matches.
    pub(crate) fn chosen(&self) -> Option<&PickerItem> {
        let number = self.matches.get(self.cursor)?;
        self.items.get(*number)
    }

    /// Lists another folder, with nothing typed, and the cursor on `at` where that is in it.
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
            let title = words().told_of_scene(title);
            PickerItem::new(PickerTarget::Preset(p.name), p.name, &title)
        }));
        self.items
            .retain(|item| Some(&item.place) != self.here.as_ref());
        self.narrow();
        let known = |place: &PickerTarget| self.items.iter().position(|item| item.place == *place);
        self.cursor = at.and_then(known).unwrap_or_else(|| self.first_scene());
    }

    /// Lists what was found in the folder; what is to be said about it.
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

    /// Whether a folder is the one that holds the folder that is listed.
    pub(crate) fn is_above(&self, folder: &Path) -> bool {
        self.folder.parent() == Some(folder)
    }

    /// The folder that holds the one that is listed, and this one as a place in it.
    pub(crate) fn above(&self) -> Option<(PathBuf, PickerTarget)> {
        let above = self.folder.parent()?.to_owned();
        Some((above, PickerTarget::Folder(self.folder.clone())))
    }

    /// Types into the search; what could act on a terminal is left out, and so is a blank in front.
    pub(crate) fn push(&mut self, c: char) {
        let fits = self.search.chars().count() < LONGEST_SEARCH;
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

    /// Moves the cursor by so many entries, as far as there are any.
    pub(crate) fn move_by(&mut self, entries: isize) {
        let most = self.matches.len().saturating_sub(1);
        self.cursor = self.cursor.saturating_add_signed(entries).min(most);
    }

    /// The lines of the list: what matches, under the headings of its parts.
    pub(crate) fn rows(&self) -> Vec<PickerRow<'_>> {
        let items = self.matches.iter().enumerate();
        let items = items.filter_map(|(i, &n)| Some((i == self.cursor, self.items.get(n)?)));
        let mut rows = Vec::with_capacity(self.matches.len() + 3);
        let (mut in_folder, mut in_presets) = (false, false);
        // What is to be said about the folder is said where nothing is searched for.
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

    /// What was typed has changed: the cursor goes to what begins that way, or to the first scene.
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

    /// Need the entries that have every word of the search in their name or title. The way out of the
    /// folder is nothing that is searched for.
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

    /// Where the cursor is best when nothing says more: folders come first, but are not looked for.
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
            // Who has no Turkish letters types those that stand for them.
            key: format!("{name} {title} {plain}").to_lowercase(),
        }
    }
}

/// The titles of the presets as their files have them, in their order.
static TITLES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let title = |preset: &Preset| Scene::parse(preset.text, preset.name).map(|scene| scene.name);
    let titles = presets::all().iter().map(title);
    titles.map(Result::unwrap_or_default).collect()
});

/// The path of a folder that can be walked out of: with `..` in its middle it could not. As it is where
/// it leads nowhere.
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
    fn a_title_is_found_without_its_letters() {
        let place = PickerTarget::Original;
        let item = PickerItem::new(place, "hoecken", "Hoecken'in do\u{11f}ru \u{e7}izen");
        for typed in ["dogru", "do\u{11f}ru", "cizen", "hoecken"] {
            assert!(item.key.contains(typed), "{typed}: {}", item.key);
        }
        assert!(!item.key.contains("kite"));
    }
}
