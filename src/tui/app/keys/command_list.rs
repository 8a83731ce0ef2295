//! Lists all commands, filters the list and runs one.

use crate::files::{directories, from_home};
use crate::scene::presets::{self, Preset};
use crate::task_file::ExampleTask;
use crate::tui::app::files::quitting::Pending;
use crate::tui::app::{App, Effect, Mode};
use crate::tui::commands::action::{Action, KeyContext, entry_of};
use crate::tui::commands::key::Key;
use crate::tui::document::opening::{self, OpenedFile};
use crate::tui::document::saving::Leave;
use crate::tui::document::writing::SavedContent;
use crate::tui::views::help::text::Help;
use crate::tui::views::palette::list::{CommandList, ListEntry};
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Opens the list of commands.
    pub(in crate::tui::app) fn list_commands(&mut self) {
        self.shell.mode = Mode::Palette(CommandList::new());
    }

    /// Handles a key of the list. Returns `None` for keys with the same meaning everywhere.
    pub(in crate::tui::app) fn palette_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        let page = self.page();
        let Mode::Palette(palette) = &mut self.shell.mode else {
            return None;
        };
        match key {
            Key::Enter => return Some(self.command(now)),
            Key::Backspace if palette.line.text().is_empty() => self.shell.mode = Mode::Normal,
            Key::Escape => self.shell.mode = Mode::Normal,
            _ if let Some(rows) = key.rows(page) => palette.list.move_by(rows),
            _ => match palette.line.change(key) {
                Some(true) => palette.narrow(),
                None if matches!(key, Key::Ctrl(_)) => return None,
                Some(false) | None => {}
            },
        }
        self.shell.message = None;
        Some(Effect::Show)
    }

    /// Runs the command under the cursor in its own view, or opens the topic under the cursor.
    fn command(&mut self, now: Duration) -> Effect {
        let Mode::Palette(palette) = std::mem::take(&mut self.shell.mode) else {
            return Effect::Show;
        };
        let (typed, argument) = (palette.line.text(), palette.argument());
        match palette.list.chosen() {
            Some(ListEntry::Command(action)) => {
                if let KeyContext::In(view) = entry_of(*action).place {
                    self.select_view(view);
                }
                return self.update(*action, now);
            }
            Some(ListEntry::Topic(at)) => {
                let columns = self.shell.size.width;
                let help = Help::telling(*at, typed, columns, &self.shell.keymap);
                self.shell.mode = Mode::Help(help);
            }
            Some(ListEntry::GoTo) => {
                self.player.playback.pause();
                self.accept_coordinate(&palette.line, now);
            }
            Some(ListEntry::Steps(count)) => self.step_selected((*count).into(), now),
            Some(ListEntry::Theme(theme)) => {
                self.shell.theme = *theme;
                self.set_message(words().theme_is(theme.shown_name(), theme.name()));
            }
            Some(ListEntry::Exercise(seed)) => self.prompt_for_exercise(*seed),
            Some(ListEntry::SaveAndQuit) if !self.is_blocked_by_staging(Action::Save) => {
                self.save_own();
                self.pending = Some(Pending::Quit);
            }
            Some(ListEntry::SaveTo) if !self.is_blocked_by_staging(Action::SaveAs) => {
                let to = from_home(argument, directories::environment);
                self.store(SavedContent::Scene, to, Leave::default());
            }
            Some(ListEntry::OpenFile) if !self.is_blocked_by_staging(Action::Open) => {
                self.open_named(argument)
            }
            Some(ListEntry::Preset(at)) if !self.is_blocked_by_staging(Action::Open) => {
                let preset = &presets::all()[*at];
                self.open_with(move || preset_of(preset));
            }
            Some(ListEntry::Task(at)) if !self.is_blocked_by_staging(Action::Open) => {
                let task = &ExampleTask::all()[*at];
                match opening::task(task) {
                    Ok(order) => self.synthesize(order),
                    Err(why) => self.set_message(why),
                }
            }
            Some(
                ListEntry::SaveAndQuit
                | ListEntry::SaveTo
                | ListEntry::OpenFile
                | ListEntry::Preset(_)
                | ListEntry::Task(_),
            )
            | None => {}
        }
        Effect::Show
    }

    /// Opens a file, or the preset of this name if there is no such file.
    fn open_named(&mut self, name: &str) {
        self.set_message(words().reading(name));
        let (name, path) = (name.to_owned(), from_home(name, directories::environment));
        self.open_with(
            move || match presets::find(&name).filter(|_| !path.exists()) {
                Some(preset) => preset_of(preset),
                None => opening::file(&path).map_err(|error| error.naming(&name)),
            },
        );
    }

    /// Opens a file in the background.
    fn open_with(&mut self, open: impl FnOnce() -> Result<OpenedFile, String> + Send + 'static) {
        self.clerk.submit(move || {
            let opened = open();
            Box::new(move |app, _| app.show_opened(opened))
        });
    }

    /// Shows the opened scene or starts the opened task, unless the user does something else.
    fn show_opened(&mut self, opened: Result<OpenedFile, String>) {
        self.shell.message = None;
        match opened {
            _ if !self.shell.mode.is_normal() => {}
            Ok(OpenedFile::Scene(opened)) => self.show(*opened),
            Ok(OpenedFile::Task(order)) => self.synthesize(*order),
            Err(why) => self.set_message(why),
        }
    }
}

fn preset_of(preset: &Preset) -> Result<OpenedFile, String> {
    opening::preset(preset).map(|opened| OpenedFile::Scene(Box::new(opened)))
}
