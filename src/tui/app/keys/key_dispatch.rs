//! Dispatches keys and pasted text according to the mode.

use crate::tui::app::{App, Effect, Mode, View};
use crate::tui::commands::action::Action;
use crate::tui::commands::key::Key;
use crate::tui::commands::line::EditLine;
use crate::tui::views::tour::screens;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Handles a key and returns its effect on the terminal.
    pub(crate) fn key(&mut self, key: Key, now: Duration) -> Effect {
        if let Some(before) = &mut self.shell.before {
            before.is_past = true;
        }
        let effect = self
            .mode_key(key, now)
            .unwrap_or_else(|| match self.bound_action(key) {
                Some(action) => self.update(action, now),
                None => self.report_unbound_key(key),
            });
        self.report_rejected();
        self.shell.before.take_if(|before| before.is_past);
        self.check_file(now, false);
        let effect = match self.attend(now) {
            Effect::Show => effect,
            leaving => leaving,
        };
        self.refresh();
        // Another view, scene or list may have fewer lines than the previous scroll position.
        self.scroll_by(0);
        effect
    }

    /// Returns the action bound to a key: in the current view, globally, or else in a visible
    /// drawing next to it.
    fn bound_action(&self, key: Key) -> Option<Action> {
        let keymap = &self.shell.keymap;
        if let Mode::Help(_) | Mode::Assemblies(_) | Mode::Candidates | Mode::GoalRun(_) =
            self.shell.mode
        {
            return keymap.action_in_list(key);
        }
        let own = keymap.action(key, self.shell.view);
        let has_drawing = || self.visible_views().contains(&View::Motion);
        own.or_else(|| keymap.action(key, View::Motion).filter(|_| has_drawing()))
    }

    /// Reports a key without meaning in normal mode.
    fn report_unbound_key(&mut self, key: Key) -> Effect {
        if self.shell.mode.is_normal() {
            let help = self.shell.keymap.key_label(Action::Help);
            self.set_message(words().means_nothing_here(&key, &help));
        }
        Effect::Show
    }

    /// Reports input that the current line rejected.
    fn report_rejected(&mut self) {
        let line = self.shell.mode.line();
        if let Some(why) = line.and_then(EditLine::take_refusal) {
            self.set_message(why);
        }
    }

    /// Types pasted text into the current line; ignores it if there is no line.
    pub(crate) fn paste(&mut self, text: &str) {
        if let Mode::AssemblyChoice(picker) = &mut self.shell.mode {
            for c in text.chars() {
                picker.edit(Key::Char(c));
            }
        } else if let Some(line) = self.shell.mode.line() {
            for c in text.chars() {
                line.edit(Key::Char(c));
            }
            self.find();
        }
        match &mut self.shell.mode {
            Mode::PlotList(list) => list.narrow(),
            Mode::Palette(palette) => palette.narrow(),
            Mode::Help(help) if help.is_typing() => {
                help.seek(false, self.shell.size.width, &self.shell.keymap);
            }
            _ => {}
        }
        self.report_rejected();
        // The new matches may have fewer lines.
        self.scroll_by(0);
    }

    /// Handles a key of the current mode. Returns `None` for keys with the same meaning everywhere.
    fn mode_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        match self.shell.mode {
            Mode::Normal => self.repeat_search(key),
            Mode::Help(_) => self.handle_search_key(key),
            Mode::Tour(_) => self.turn_page(key),
            Mode::GoTo(_) | Mode::Guess(_) | Mode::Goal(_) | Mode::Value(_) | Mode::FileName(_) => {
                self.line_key(key, now)
            }
            Mode::Assemblies(_) => (key == Key::Enter).then(|| {
                self.take_assembly(now);
                Effect::Show
            }),
            Mode::PlotList(_) => self.list_key(key),
            Mode::Palette(_) => self.palette_key(key, now),
            Mode::Confirm(_) => self.confirm_key(key, now),
            Mode::AssemblyChoice(_) => self.pick_key(key, now),
            Mode::Candidates => self.candidates_key(key, now),
            Mode::GoalRun(_) => self.goal_run_key(key, now),
            Mode::Search(_) => self.search_key(key),
            Mode::Copy => self.copy_key(key),
            Mode::Unsaved(_) => self.answer(key, now),
            Mode::Recovery(_) => self.handle_offer_key(key, now),
        }
    }

    /// Handles a key of an input line that takes effect only on Enter.
    fn line_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        let is_going = matches!(self.shell.mode, Mode::GoTo(_));
        let line = self.shell.mode.line()?;
        match key {
            Key::Enter => {
                self.shell.message = None;
                self.accept_line(now);
                return Some(Effect::Show);
            }
            Key::Escape => self.shell.mode = Mode::Normal,
            // `gg` scrolls to the top, as in vi.
            Key::Char('g') if is_going && line.text().is_empty() => {
                self.shell.mode = Mode::Normal;
                self.scroll_by(isize::MIN);
            }
            _ if line.edit(key) => {}
            Key::Ctrl(_) => return None,
            _ => {}
        }
        self.shell.message = None;
        Some(Effect::Show)
    }

    /// Applies the completed line.
    fn accept_line(&mut self, now: Duration) {
        match &self.shell.mode {
            Mode::GoTo(line) => self.accept_coordinate(&line.clone(), now),
            Mode::Guess(line) => self.accept_guess(line.clone().text()),
            Mode::Goal(line) => self.take_goal(line.clone().text()),
            Mode::Value(line) => self.take_value(line.clone().text(), now),
            Mode::FileName(prompt) => self.accept_file(prompt.clone()),
            _ => {}
        }
    }

    /// Returns `true` if the mode permits an action that is not its own.
    pub(in crate::tui::app) fn takes(&self, action: Action) -> bool {
        match self.shell.mode {
            Mode::Tour(_) => screens::allows(action),
            _ => self.shell.mode.is_normal(),
        }
    }

    /// Returns what Esc ends in the current view: only what the view shows.
    pub(crate) fn back_target(&self) -> BackTarget {
        let view = self.shell.view;
        let study = self.views.lengths.get();
        if view == View::Scene && self.document.editor.staged.is_some() {
            BackTarget::StagedEdits
        } else if view == View::Lengths && study.is_some_and(|study| study.told.is_some()) {
            BackTarget::Tolerance
        } else if self.is_watching() {
            BackTarget::Method
        } else if view == View::Accuracy && self.is_working() {
            BackTarget::Study
        } else if self.shell.composition.is_alone(view, self.shell.size) {
            BackTarget::Pane
        } else if self.compared().is_some() {
            BackTarget::Comparison
        } else {
            BackTarget::Search
        }
    }

    /// Goes one level back: closes a mode, or ends what [`App::back_target`] says.
    pub(in crate::tui::app) fn back(&mut self) {
        if let Mode::Help(help) = &mut self.shell.mode
            && help.show_all()
        {
            return;
        }
        if !self.shell.mode.is_normal() {
            self.shell.mode = self.below();
            return;
        }
        match self.back_target() {
            BackTarget::StagedEdits => self.drop_staged(),
            BackTarget::Tolerance => self.close_tolerance(),
            BackTarget::Method => self.watch_method(None),
            BackTarget::Study => self.views.study_run.stop(),
            BackTarget::Pane => {
                self.shell.composition.restore_panes();
                self.rearrange();
            }
            BackTarget::Comparison => self.compare(),
            BackTarget::Search => self.views.searched = None,
        }
    }
}

/// The mode, search or pane that Esc ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BackTarget {
    StagedEdits,
    Tolerance,
    Method,
    Study,
    Pane,
    Comparison,
    Search,
}
