//! Lets the user pick a preset or a file.

use super::super::Origin;
use crate::scene::presets;
use crate::tui::app::{App, Effect, Mode};
use crate::tui::commands::key::Key;
use crate::tui::document::opening::{self, OpenFileError, OpenedFile};
use crate::tui::views::scene_picker::list::{
    FolderReading, Picker, PickerItem, PickerTarget, Purpose,
};
use crate::tui::views::scene_picker::preview::Preview;
use crate::wording::words;
use std::env;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

impl App {
    /// Lists the scenes that can be opened, starting in the folder of the open file.
    pub(in crate::tui::app) fn pick(&mut self) {
        self.list(Purpose::Open, None);
    }

    /// Opens the list with the cursor on `at`, or on the open scene.
    pub(in crate::tui::app) fn list(&mut self, purpose: Purpose, at: Option<PickerTarget>) {
        let folder = match self.player.open_scene.origin() {
            Origin::File(path) => path.parent().map(Path::to_owned),
            Origin::Preset(_) | Origin::New(_) | Origin::Stdin => None,
        };
        let here = PickerTarget::of(self.player.open_scene.origin());
        let first = self.first_listed(purpose);
        let folder = folder.unwrap_or_default();
        self.previews.forget();
        self.shell.mode = Mode::AssemblyChoice(Box::new(Picker::new(purpose, first, here)));
        self.list_folder(folder, at, true);
    }

    /// Returns the first item of the list: the unedited scene for a comparison, or the last task's
    /// linkages for opening.
    fn first_listed(&self, purpose: Purpose) -> Option<PickerItem> {
        match purpose {
            Purpose::Compare => self
                .is_edited()
                .then(|| PickerItem::new(PickerTarget::Original, words().as_opened(), "")),
            Purpose::Open => self.candidates.as_ref().map(|list| {
                let name = words().linkages_for(&list.order().name);
                PickerItem::new(PickerTarget::Candidates, &name, "")
            }),
        }
    }

    /// Lists a folder once it is read, with the cursor on an entry of it, or on the open scene.
    fn list_folder(&mut self, folder: PathBuf, at: Option<PickerTarget>, or_here: bool) {
        let origin = self.player.open_scene.origin().clone();
        let Mode::AssemblyChoice(picker) = &self.shell.mode else {
            return;
        };
        let purpose = picker.purpose();
        self.clerk.submit(move || {
            let read = FolderReading::of(&folder, purpose);
            let at = at.or_else(|| or_here.then(|| PickerTarget::of(&origin)).flatten());
            Box::new(move |app, _| {
                if let Mode::AssemblyChoice(picker) = &mut app.shell.mode {
                    picker.list(read, at.as_ref());
                }
            })
        });
    }

    /// Returns `true` if the scene's text differs from the opened text.
    pub(in crate::tui::app) fn is_edited(&self) -> bool {
        self.player.open_scene.scene().text() != &*self.document.original
    }

    /// Updates everything that a frame shows besides the state. Runs once per frame, after any
    /// number of keys.
    pub(crate) fn update_before_frame(&mut self) {
        self.refresh();
        self.follow();
        if let (Mode::Candidates, Some(list)) = (&self.shell.mode, &mut self.candidates) {
            list.draw();
        }
        let Mode::AssemblyChoice(picker) = &self.shell.mode else {
            return;
        };
        let chosen = picker.chosen().map(|item| item.place.clone());
        if let Some(place) = chosen.filter(|place| self.previews.expect(place)) {
            let original = Arc::clone(&self.document.original);
            self.clerk.submit(move || {
                let preview = Preview::of(&place, &original);
                Box::new(move |app, _| app.previews.put(&place, preview))
            });
            self.drain_results(self.now);
        }
    }

    /// Returns the preview of the entry under the cursor.
    pub(crate) fn preview(&self) -> Option<&Preview> {
        let Mode::AssemblyChoice(picker) = &self.shell.mode else {
            return None;
        };
        self.previews.of(&picker.chosen()?.place)
    }

    /// Handles a key of the list; letters narrow the search. Returns `None` for keys with the same
    /// meaning everywhere.
    pub(in crate::tui::app) fn pick_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        let page = self.page();
        let Mode::AssemblyChoice(picker) = &mut self.shell.mode else {
            return None;
        };
        match key {
            _ if picker.edit(key) => {}
            _ if let Some(rows) = key.rows(page) => picker.list.move_by(rows),
            Key::Ctrl('p') => picker.list.move_by(-1),
            Key::Ctrl('n') => picker.list.move_by(1),
            Key::Left => {
                if let Some((above, here)) = picker.parent_entry() {
                    self.list_folder(above, Some(here), false);
                }
            }
            Key::Right => self.list_chosen_folder(),
            Key::Enter => self.accept_pick(),
            Key::Escape => self.close_list(now),
            Key::Ctrl(_) => return None,
            _ => {}
        }
        self.shell.message = self.shell.message.take().filter(|_| key == Key::Enter);
        Some(Effect::Show)
    }

    /// Returns to the open scene and resumes its playback.
    fn close_list(&mut self, now: Duration) {
        self.shell.mode = Mode::Normal;
        self.previews.forget();
        self.player.resume(now);
    }

    fn list_chosen_folder(&mut self) {
        let Mode::AssemblyChoice(picker) = &self.shell.mode else {
            return;
        };
        if let Some(PickerTarget::Folder(path)) = picker.chosen().map(|item| item.place.clone()) {
            let above = picker.parent_entry().filter(|_| picker.is_above(&path));
            self.list_folder(path, above.map(|(_, here)| here), false);
        }
    }

    /// Opens the entry under the cursor, or lists it if it is a folder.
    fn accept_pick(&mut self) {
        self.shell.message = None;
        let Mode::AssemblyChoice(picker) = &mut self.shell.mode else {
            return;
        };
        let Some(place) = picker.chosen().map(|item| item.place.clone()) else {
            return;
        };
        let purpose = picker.purpose();
        match place {
            PickerTarget::Folder(_) => return self.list_chosen_folder(),
            PickerTarget::Candidates => return self.list_candidates(),
            PickerTarget::Original | PickerTarget::File(_) | PickerTarget::Preset(_) => {}
        }
        let name = picker
            .chosen()
            .map_or(String::new(), |item| item.name.clone());
        let (original, origin) = (
            Arc::clone(&self.document.original),
            self.player.open_scene.origin().clone(),
        );
        self.set_message(words().reading(&name));
        self.clerk.submit(move || {
            let opened = opened(&place, &original, origin);
            Box::new(move |app, now| app.picked(purpose, place, name, opened, now))
        });
    }

    /// Shows or compares the opened scene, or reports why it did not open.
    fn picked(
        &mut self,
        purpose: Purpose,
        place: PickerTarget,
        name: String,
        opened: Result<OpenedFile, String>,
        now: Duration,
    ) {
        self.shell.message = None;
        // The user may have closed the list before the file was read.
        if !matches!(self.shell.mode, Mode::AssemblyChoice(_)) {
            return;
        }
        let done = opened.and_then(|opened| match (purpose, opened) {
            (Purpose::Open, OpenedFile::Scene(opened)) => {
                self.close_list(now);
                self.show(*opened);
                Ok(())
            }
            (Purpose::Open, OpenedFile::Task(order)) => {
                self.previews.forget();
                self.synthesize(*order);
                Ok(())
            }
            (Purpose::Compare, OpenedFile::Task(_)) => Err(words().task_is_no_scene().to_owned()),
            (Purpose::Compare, OpenedFile::Scene(opened)) => {
                self.compare_with(place, name, *opened)?;
                self.close_list(now);
                Ok(())
            }
        });
        if let Err(why) = done {
            self.set_message(why);
        }
    }
}

/// Opens a scene or task of the list. Returns a message if that fails.
fn opened(place: &PickerTarget, original: &str, origin: Origin) -> Result<OpenedFile, String> {
    let scene = |opened| OpenedFile::Scene(Box::new(opened));
    match place {
        PickerTarget::Folder(path) => Err(words().is_folder(&path.display())),
        // The cursor already shows the file's name.
        PickerTarget::File(path) => opening::file(&near(path)).map_err(OpenFileError::first_words),
        PickerTarget::Preset(name) => match presets::find(name) {
            Some(preset) => opening::preset(preset).map(scene),
            None => Err(words().no_preset(name)),
        },
        PickerTarget::Original => opening::text(original, origin)
            .map(scene)
            .map_err(|d| d.first_words().to_owned()),
        // Candidates are listed, not opened.
        PickerTarget::Candidates => Err(words().found_before().to_owned()),
    }
}

/// Returns a path below the working directory in relative form, which is shorter.
fn near(path: &Path) -> PathBuf {
    let below = env::current_dir().and_then(|here| here.canonicalize());
    let below = below.ok().and_then(|here| path.strip_prefix(here).ok());
    below.unwrap_or(path).to_owned()
}
