//! The workbench's state, and how actions change it. Views only read it.

mod assembly_choice;
mod clock;
mod driving;
mod editing;
mod files;
mod goal_run;
mod goals;
mod inputs;
mod keys;
mod motion_view;
mod pane_layout;
mod plotting;
mod row_search;
mod shell;
mod staging;
mod synthesizing;
mod tolerance_effect;

use super::config::Config;
use super::{OpenedScene, Origin};
use crate::capability::{Capability, Colours};
use crate::document::Diagnostics;
use crate::drawing::Glyphs;
use crate::report::{CsvDialect, Verdict};
use crate::solver::Condition;
use crate::tui::appearance::palette::{Ground, Palette, Theme, is_weak_text};
use crate::tui::commands::action::{Action, TablesAction};
use crate::tui::commands::keymap::Keymap;
use crate::tui::commands::line::EditLine;
pub(crate) use crate::tui::commands::view::View;
use crate::tui::document::Document;
use crate::tui::document::editor::Editor;
use crate::tui::document::io_thread::JobRunner;
use crate::tui::player::Player;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::playback::{Playback, Track};
use crate::tui::player::steps::StepLadder;
use crate::tui::terminal::TerminalColour;
use crate::tui::views;
use crate::tui::views::candidates::list::CandidateList;
use crate::tui::views::layout::Composition;
use crate::tui::views::motor::study::MotorStudy;
use crate::tui::views::scene_picker::preview::Previews;
use crate::tui::views::state::ViewStates;
use crate::wording::{Language, words};
use files::comparing::Comparison;
use files::quitting::Pending;
pub(crate) use files::quitting::Unsaved;
pub(crate) use goal_run::GoalRun;
pub(crate) use keys::key_dispatch::BackTarget;
pub(crate) use keys::mode::Mode;
use ratatui::layout::Size;
use shell::Shell;
use std::os::fd::BorrowedFd;
use std::time::Duration;

/// The effect of an action on the terminal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    /// Draw a frame with the changes.
    Show,
    /// Write these bytes, which belong to no frame, then draw a frame with the changes.
    Send(Vec<u8>),
    /// Send the drawing as a pixel image.
    Still,
    /// Leave the screen unchanged, for [`App::prompt_for_picture`].
    Picture,
    /// Repaint the whole screen.
    Redraw,
    /// Suspend the process until the shell continues it.
    Suspend,
    /// Quit the program.
    Quit,
}

/// The workbench without its terminal.
#[derive(Debug)]
pub(crate) struct App {
    /// The open scene, its driver coordinate and its playback.
    player: Player,
    /// The scene as editable text.
    document: Document,
    /// The input mode, the current view and the screen.
    shell: Shell,

    /// The cursors, settings and results of the views.
    pub(crate) views: ViewStates,
    /// Cached previews of the scenes in the list of presets and files.
    previews: Previews,
    /// The candidate linkages of the last synthesis task.
    candidates: Option<CandidateList>,
    /// The comparison with another scene.
    comparison: Comparison,

    /// Runs file operations.
    clerk: JobRunner<App>,
    /// The dialect of written CSV files.
    csv: CsvDialect,
    /// The action to run once all edits are saved or discarded.
    pending: Option<Pending>,
    /// The number of scenes shown so far. A background result applies only if this number is
    /// unchanged.
    scenes: usize,
    /// The time of the last tick.
    now: Duration,
}

impl App {
    /// Creates a workbench with an open scene, paused at the scene's own coordinate or at `at`.
    pub(crate) fn new(
        opened: OpenedScene,
        at: Option<f64>,
        capability: Capability,
        size: Size,
    ) -> Self {
        let document = Document::new(&opened.scene);
        let mut app = App {
            player: Player::new(opened),
            document,
            shell: Shell::new(capability, size),
            views: ViewStates::new(clock::wall_clock),
            previews: Previews::default(),
            candidates: None,
            comparison: Comparison::default(),
            clerk: JobRunner::default(),
            csv: CsvDialect::default(),
            pending: None,
            scenes: 1,
            now: Duration::ZERO,
        };
        match at {
            Some(at) => {
                app.jump(at, Duration::ZERO);
            }
            None => app.report_lead(),
        }
        app.update_needs();
        app.meet();
        app.attend(Duration::ZERO);
        app
    }

    /// Moves file operations to background threads, if the system allows threads.
    pub(crate) fn use_background_threads(&mut self) {
        self.clerk = JobRunner::with_file_thread().unwrap_or_default();
    }

    /// Returns a file descriptor that becomes readable when a file operation ends.
    pub(crate) fn bell(&self) -> Option<BorrowedFd<'_>> {
        self.clerk.bell()
    }

    /// Clears the signal that a file operation has ended.
    pub(crate) fn clear_signal(&self) {
        self.clerk.clear_signal();
    }

    /// Reports the ignored parts of a configuration.
    pub(crate) fn warn_of_config(&mut self, warnings: &Diagnostics) {
        let more = warnings.items.len().saturating_sub(1);
        let first = warnings.first_words();
        self.set_message(words().ignored(first, more));
    }

    /// Applies the user's configuration.
    pub(crate) fn configure(&mut self, config: &Config) {
        self.shell.keymap = config.keymap.clone();
        self.shell.has_mouse = config.mouse;
        self.csv = config.csv;
        self.shell.composition = Composition::of(config.layout);
        self.update_needs();
    }

    /// Switches to the next language and rebuilds all cached text.
    fn next_language(&mut self) {
        Language::current_language().next().speak();
        self.views.motor = MotorStudy::default();
        self.views.working.forget();
        self.views.polygons.forget();
        self.previews.forget();
        self.player.open_scene.rebuild_texts();
        if let Some(list) = &mut self.candidates {
            list.rebuild_texts();
        }
        self.update_needs();
        self.set_message(words().language_is());
    }

    /// Returns the dialect of written CSV files.
    pub(crate) fn csv_dialect(&self) -> CsvDialect {
        self.csv
    }

    pub(crate) fn open_scene(&self) -> &OpenScene {
        &self.player.open_scene
    }

    pub(crate) fn steps(&self) -> &StepLadder {
        &self.player.steps
    }

    /// Returns the sequence of positions along which the scene is played.
    pub(crate) fn track(&self) -> Track {
        self.player.track()
    }

    pub(crate) fn playback(&self) -> &Playback {
        &self.player.playback
    }

    /// Returns the key bindings.
    pub(crate) fn keymap(&self) -> &Keymap {
        &self.shell.keymap
    }

    /// Returns the editor of the open scene.
    pub(crate) fn editor(&self) -> &Editor {
        &self.document.editor
    }

    /// Returns `true` if the scene differs from its file.
    pub(crate) fn is_changed(&self) -> bool {
        self.document
            .editor
            .is_changed(self.player.open_scene.scene())
    }

    /// Returns `true` if no file holds the scene as shown.
    pub(crate) fn is_unsaved(&self) -> bool {
        let is_new = matches!(self.player.open_scene.origin(), Origin::New(_));
        is_new || self.is_changed()
    }

    pub(crate) fn view(&self) -> View {
        self.shell.view
    }

    pub(crate) fn mode(&self) -> &Mode {
        &self.shell.mode
    }

    /// Returns the arrangement of the panes.
    pub(crate) fn composition(&self) -> &Composition {
        &self.shell.composition
    }

    /// Returns the views on the screen, including the current one.
    pub(crate) fn visible_views(&self) -> Vec<View> {
        if !views::fits_views(self.shell.size) {
            return vec![self.shell.view];
        }
        self.shell
            .composition
            .visible_views(self.shell.view, self.shell.size)
    }

    pub(crate) fn glyphs(&self) -> Glyphs {
        self.shell.capability.glyphs
    }

    pub(crate) fn size(&self) -> Size {
        self.shell.size
    }

    pub(crate) fn aspect(&self) -> f64 {
        self.shell.aspect
    }

    /// Returns the colour depth; the plain theme has no colours.
    pub(crate) fn colours(&self) -> Colours {
        match self.theme() {
            Theme::Plain => Colours::None,
            Theme::Auto | Theme::Light | Theme::Dark => self.shell.capability.colours,
        }
    }

    /// Returns the theme in force: the automatic one follows a known background.
    fn theme(&self) -> Theme {
        match self.shell.theme {
            Theme::Auto => self.shell.ground.map_or(Theme::Auto, Ground::theme),
            theme => theme,
        }
    }

    /// Returns the palette: the colour depth and the theme.
    pub(crate) fn palette(&self) -> Palette {
        let theme = self.theme();
        let colours = self.shell.text_colour.zip(self.shell.ground_colour);
        let is_weak = |(text, ground): ([u8; 3], [u8; 3])| {
            theme == Ground::of(ground).theme() && is_weak_text(text, ground)
        };
        Palette {
            colours: self.colours(),
            theme,
            has_weak_text: colours.is_some_and(is_weak),
        }
    }

    /// Sets a colour that the terminal reports.
    pub(crate) fn set_colour(&mut self, colour: TerminalColour) {
        match colour {
            TerminalColour::Text(colour) => self.shell.text_colour = Some(colour),
            TerminalColour::Ground(colour) => {
                self.shell.ground_colour = Some(colour);
                self.set_ground(Ground::of(colour));
            }
        }
    }

    /// Sets the background of the terminal, for the automatic theme.
    pub(crate) fn set_ground(&mut self, ground: Ground) {
        self.shell.ground = Some(ground);
    }

    /// Sets the theme, which maps colour names to colours.
    pub(crate) fn set_theme(&mut self, theme: Theme) {
        self.shell.theme = theme;
    }

    /// Returns the scene as it was before the last edit; `None` after the next key.
    pub(crate) fn scene_before(&self) -> Option<&OpenScene> {
        self.shell.before.as_ref().map(|before| &before.open_scene)
    }

    /// Returns the verdict on the linkage before the last edit, if the edit changed it.
    pub(crate) fn verdict_before(&self) -> Option<&Verdict> {
        let before = self.scene_before()?.verdict();
        (before != self.player.open_scene.verdict()).then_some(before)
    }

    fn set_message(&mut self, message: impl Into<String>) {
        self.shell.set_message(message);
    }

    pub(crate) fn message(&self) -> Option<&str> {
        self.shell.message.as_deref()
    }

    /// Executes an action and returns its effect on the terminal.
    pub(crate) fn update(&mut self, action: Action, now: Duration) -> Effect {
        self.shell.message = None;
        if self.is_blocked_by_staging(action) {
            return Effect::Show;
        }
        match action {
            // In a list or the help, it closes that first.
            Action::Quit if !self.shell.mode.is_normal() => self.back(),
            Action::Quit => return self.quit(),
            Action::Leave => return Effect::Quit,
            Action::Suspend => return Effect::Suspend,
            Action::Redraw => return Effect::Redraw,
            Action::Back => self.back(),
            Action::Help => self.toggle_help(),
            Action::LineUp
            | Action::LineDown
            | Action::PageUp
            | Action::PageDown
            | Action::HalfUp
            | Action::HalfDown
            | Action::Top
            | Action::End => self.scroll_by(action.rows(self.page()).unwrap_or(0)),
            Action::Save if matches!(self.shell.mode, Mode::Normal | Mode::Assemblies(_)) => {
                self.save_own()
            }
            Action::Search if let Mode::Help(help) = &mut self.shell.mode => help.search(),
            Action::NextView | Action::StepForward | Action::Tables(TablesAction::Right)
                if let Mode::Help(help) = &mut self.shell.mode =>
            {
                help.turn(false);
            }
            Action::PreviousView | Action::StepBack | Action::Tables(TablesAction::Left)
                if let Mode::Help(help) = &mut self.shell.mode =>
            {
                help.turn(true);
            }
            Action::Assemblies if matches!(self.shell.mode, Mode::Assemblies(_)) => {
                self.shell.mode = Mode::Normal;
            }
            // `gg` moves to the top of a list, as in vi.
            Action::GoTo if matches!(self.shell.mode, Mode::Help(_) | Mode::Assemblies(_)) => {
                self.scroll_by(isize::MIN);
            }
            _ if !self.takes(action) => {}
            Action::Save => {}
            Action::Assemblies => self.list_assemblies(),
            Action::Play => self.player.toggle(now),
            Action::Slower => self.player.slower(now),
            Action::Faster => self.player.faster(now),
            Action::Reverse => self.player.reverse(now),
            Action::StepBack => self.step_selected(-1.0, now),
            Action::StepForward => self.step_selected(1.0, now),
            Action::NextInput => self.select_next_input(),
            Action::SmallerStep => self.player.steps.smaller(),
            Action::LargerStep => self.player.steps.larger(),
            Action::Palette => self.list_commands(),
            Action::GoTo => {
                self.player.playback.pause();
                self.shell.mode = Mode::GoTo(EditLine::for_coordinate());
            }
            Action::Opening => self.player.go_to_opening(now),
            Action::NextPreset => self.open(1),
            Action::PreviousPreset => self.open(-1),
            Action::Compare => self.compare(),
            Action::Open => self.pick(),
            Action::NextPart => self.go_to_part(true),
            Action::PreviousPart => self.go_to_part(false),
            Action::Search => self.search(),
            Action::Copy
            | Action::Csv
            | Action::Picture
            | Action::Still
            | Action::Svg
            | Action::Report => return self.take_out(action),
            Action::SaveAs => self.prompt_for_name(),
            Action::Reload => self.reload(false),
            Action::Undo | Action::Redo => self.edit_history(action, now),
            Action::Motion(action) => self.move_viewport(action),
            Action::Tables(action) => self.browse(action),
            Action::Plots(action) => self.plot(action),
            Action::Method => self.watch_next(),
            Action::Guess => self.prompt_for_guess(),
            Action::Tolerance => self.show_tolerance(),
            Action::Scene(action) => self.edit(action, now),
            Action::Tour => self.tour(),
            Action::Glyphs => {
                self.shell.next_glyphs();
                self.clamp_positions();
            }
            Action::Colours => self.shell.next_colours(),
            Action::Mouse => self.toggle_mouse(),
            Action::Language => self.next_language(),
            Action::NextView => self.turn_view(1),
            Action::PreviousView => self.turn_view(View::ALL.len() - 1),
            Action::NextPane => self.next_pane(),
            Action::Alone => self.toggle_alone(),
            Action::SplitLeft => self.move_split(-1),
            Action::SplitRight => self.move_split(1),
            Action::NextLayout => self.next_layout(),
            Action::Look(view) => self.select_view_by_key(view),
        }
        Effect::Show
    }

    /// Returns the condition of the solution: why values are missing, if they are.
    pub(crate) fn condition(&self) -> Condition {
        self.player.open_scene.condition()
    }
}
