//! Exports values, drawings, screens and reports.

use super::super::views::{self, Copied};
use crate::capability::{Detected, PictureProtocol};
use crate::quantity::{Catalogue, Clock};
use crate::report::{
    Columns, LeadSweep, MadeExercise, Report, RowFormat, Steps, Sweep, SweepOutcome, WrittenDecimal,
};
use crate::solver::{Order, PointLeader};
use crate::study::ExerciseMaker;
use crate::tui::Origin;
use crate::tui::app::{App, Effect, Mode};
use crate::tui::commands::action::Action;
use crate::tui::commands::key::Key;
use crate::tui::document::writing::{SavedContent, Text};
use crate::tui::figures::copying::ShownTables;
use crate::tui::figures::format::coordinate;
use crate::tui::player::led_motion::LedMotion;
use crate::tui::player::solution_cache::{DIGITS, Explained};
use crate::tui::terminal::clipboard;
use crate::wording::words;
use std::io;

impl App {
    pub(in crate::tui::app) fn take_out(&mut self, action: Action) -> Effect {
        match action {
            Action::Copy => return self.copy(),
            Action::Picture => return Effect::Picture,
            Action::Still => return self.request_image(),
            Action::Svg => self.prompt_for_svg(),
            Action::Report => self.prompt_for_report(),
            _ => self.prompt_for_csv(),
        }
        Effect::Show
    }

    /// Pauses playback and requests a pixel image, or reports why the terminal cannot show one.
    fn request_image(&mut self) -> Effect {
        match &self.shell.pictures.value {
            Some(_) => {
                self.player.playback.pause();
                Effect::Still
            }
            None => {
                self.set_message(self.shell.pictures.why.clone());
                Effect::Show
            }
        }
    }

    /// Returns the terminal's image protocol, if it has one.
    pub(crate) fn pictures(&self) -> Option<PictureProtocol> {
        self.shell.pictures.value
    }

    /// Sets the terminal's image protocol.
    pub(crate) fn send_pictures(&mut self, pictures: Detected<Option<PictureProtocol>>) {
        self.shell.pictures = pictures;
    }

    /// Reports the outcome of sending an image.
    pub(crate) fn report_image(&mut self, message: String) {
        self.set_message(message);
    }

    /// Copies what the view shows; in the tables, first asks how much of them to copy.
    fn copy(&mut self) -> Effect {
        if !self.shell.capability.modern {
            self.set_message(self.with_alternative(words().no_clipboard().into()));
            return Effect::Show;
        }
        match self.shell.view.pane_in(self).copy(self) {
            Copied::Text(text) => return self.send(&text),
            Copied::Lines => {
                let lines = views::current_view_lines(self);
                return self.send(&lines.join("\n"));
            }
            Copied::Asked => self.shell.mode = Mode::Copy,
            Copied::Nothing => {
                self.set_message(words().nothing_to_copy());
            }
        }
        Effect::Show
    }

    /// Handles the keys that choose how much of the tables to copy. Returns `None` for keys with
    /// the same meaning everywhere.
    pub(in crate::tui::app) fn copy_key(&mut self, key: Key) -> Option<Effect> {
        let text = match key {
            Key::Char('v') => self.shown().value(self.views.cursor),
            Key::Char('r') => Some(self.shown().row(self.views.cursor)),
            Key::Char('t') => Some(self.shown().table(self.views.cursor.part)),
            Key::Ctrl(_) | Key::Escape => return None,
            _ => return Some(Effect::Show),
        };
        self.shell.mode = Mode::Normal;
        if let Some(text) = text {
            return Some(self.send(&text));
        }
        self.set_message(words().no_value_to_copy());
        Some(Effect::Show)
    }

    /// Returns the tables as shown: values or differences.
    pub(crate) fn shown(&self) -> ShownTables<'_> {
        ShownTables {
            sheet: self.sheet(),
            tables: self.tables(),
            differences: self.compared().is_some(),
        }
    }

    /// Sends a text to the clipboard. The terminal does not confirm its arrival.
    fn send(&mut self, text: &str) -> Effect {
        match clipboard::sequence(text) {
            Ok(bytes) => {
                self.set_message(words().sent_to_clipboard(text.len()));
                Effect::Send(bytes)
            }
            Err(too_large) => {
                self.set_message(self.with_alternative(too_large.to_string()));
                Effect::Show
            }
        }
    }

    /// Appends the alternative to a message that copying is impossible: `: use Y`, which writes a
    /// file.
    fn with_alternative(&self, why: String) -> String {
        match self.shell.keymap.key(Action::Csv) {
            Some(key) => words().use_instead(&why, &key),
            None => why,
        }
    }

    /// Asks for a file for the current values or the plotted curves; in a view of text lines, for
    /// all its lines.
    fn prompt_for_csv(&mut self) {
        if let Some((what, page)) = self.shell.view.pane_in(self).page(self) {
            let text = Text::of_page(what, page, self.row_of_sweep().ok());
            let proposal = self.proposal("txt");
            return self.prompt_for_file(SavedContent::Text(text), &proposal);
        }
        let text = self.shell.view.pane_in(self).csv(self);
        self.offer_file(text, words().the_figures(), "csv");
    }

    /// Asks for the name of a text file, or reports why there is no text.
    fn offer_file(&mut self, text: Result<String, String>, what: &str, ending: &str) {
        match text {
            Ok(text) => {
                let proposal = self.proposal(ending);
                let what = what.into();
                let text = Text::new(what, text);
                self.prompt_for_file(SavedContent::Text(text), &proposal);
            }
            Err(why) => self.set_message(why),
        }
    }

    /// Formats all values at the current position as a sweep of one row.
    pub(crate) fn row_of_sweep(&self) -> Result<String, String> {
        let open_scene = &self.player.open_scene;
        if let Some(led) = open_scene.led() {
            return self.row_of_lead(led);
        }
        let scene = open_scene.scene();
        // Over time, the row is identified by its time instead of the coordinate.
        let time = open_scene
            .time()
            .and_then(|time| Some((time, Clock::of(scene)?)));
        let at = time.as_ref().map_or(open_scene.at(), |(time, _)| *time);
        let catalogue = Catalogue::new(scene);
        let broken = || words().no_figures_to_write().to_owned();
        let here = WrittenDecimal::of(at).ok_or_else(broken)?;
        let step = WrittenDecimal::of(1.0).ok_or_else(broken)?;
        let columns = Columns::new(catalogue.driver(), catalogue.all(), true);
        let columns = match time {
            Some(_) => columns.over_time(),
            None => columns,
        };
        let sweep = Sweep {
            scene,
            solver: open_scene.solver(),
            columns: &columns,
            steps: &Steps::new(here, here, step).map_err(|e| e.to_string())?,
            clock: time.as_ref().map(|(_, clock)| clock),
            format: RowFormat::Csv(self.csv_dialect()),
        };
        text_of(|text| sweep.write(text, &mut |_| {}))
    }

    /// Formats all values at the present time of a leading point as a sweep of one row.
    fn row_of_lead(&self, led: &LedMotion) -> Result<String, String> {
        let open_scene = &self.player.open_scene;
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        let catalogue = Catalogue::new(scene);
        let broken = || words().no_figures_to_write().to_owned();
        let leader = PointLeader::new(solver, led.lead().lead()).ok_or_else(broken)?;
        let here = WrittenDecimal::of(led.time()).ok_or_else(broken)?;
        let step = WrittenDecimal::of(1.0).ok_or_else(broken)?;
        let sweep = LeadSweep {
            scene,
            leader: &leader,
            lead: led.lead(),
            columns: &Columns::new(catalogue.driver(), catalogue.all(), true).over_time(),
            steps: &Steps::new(here, here, step).map_err(|e| e.to_string())?,
            format: RowFormat::Csv(self.csv_dialect()),
        };
        text_of(|text| sweep.write(text, &mut |_| {}))
    }

    /// Asks for a file for the screen as it was when the key was pressed.
    pub(crate) fn prompt_for_picture(&mut self, text: String) {
        self.offer_file(Ok(text), words().the_screen(), "txt");
    }

    /// Asks for an SVG file of the drawing or plot as shown.
    fn prompt_for_svg(&mut self) {
        match self.shell.view.pane_in(self).svg(self) {
            Ok((what, text)) => self.offer_file(Ok(text), what, "svg"),
            Err(why) => self.set_message(why),
        }
    }

    /// Asks for a file for a report on the linkage at its current position. The file name's
    /// extension selects the format.
    fn prompt_for_report(&mut self) {
        let open_scene = &self.player.open_scene;
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        if open_scene.led().is_some() {
            return self.set_message(words().shows_the_driver_only());
        }
        if !Explained::is_possible(scene) {
            return self.set_message(words().too_many_links_to_report());
        }
        let mut state = solver.state();
        let _ = open_scene
            .driver_state()
            .solve(solver, Order::Force, &mut state);
        solver.enclose(&mut state, Order::Force, &mut solver.enclosure());
        let report = Report::new(scene, solver, &state, DIGITS);
        let text = Text::of_report(words().the_report(), &report);
        let proposal = self.proposal("html");
        self.prompt_for_file(SavedContent::Text(text), &proposal);
    }

    /// Asks for a file for the sheet of an exercise that is made from the scene. The command line
    /// writes it with answers and solution.
    pub(in crate::tui::app) fn prompt_for_exercise(&mut self, seed: u64) {
        let open_scene = &self.player.open_scene;
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        if scene.lead.is_some() {
            return self.set_message(words().shows_the_driver_only());
        }
        if self.is_unsaved() {
            return self.set_message(words().exercise_of_saved_scene());
        }
        let typed = match open_scene.origin() {
            Origin::File(path) => path.display().to_string(),
            Origin::Preset(_) | Origin::New(_) | Origin::Stdin => self.stem(),
        };
        let maker = ExerciseMaker::new(scene, solver);
        match MadeExercise::new(&maker, scene, &typed, seed) {
            Ok(made) => {
                let name = format!("{}-{seed}", self.stem());
                let text = Text::of_report(words().the_exercise(), &made.sheet(&name));
                self.prompt_for_file(SavedContent::Text(text), &format!("{name}.html"));
            }
            Err(why) => self.set_message(why),
        }
    }

    /// Returns the name of the scene for names of files.
    fn stem(&self) -> String {
        let stem = match self.player.open_scene.origin() {
            Origin::Preset(name) | Origin::New(name) => Some(name.clone()),
            Origin::File(path) => path.file_stem().map(|s| s.to_string_lossy().into_owned()),
            Origin::Stdin => None,
        };
        stem.unwrap_or_else(|| "scene".into())
    }

    /// Proposes a file name, such as `four-bar-60.csv`, or `four-bar-plot.csv` for the whole
    /// motion.
    fn proposal(&self, ending: &str) -> String {
        let complete = self
            .shell
            .view
            .pane_in(self)
            .file_part()
            .filter(|_| !matches!(ending, "txt" | "html"));
        let open_scene = &self.player.open_scene;
        let place = || match open_scene.led() {
            Some(led) => format!("{}s", led.text(led.time())),
            None => coordinate(open_scene.at(), 0),
        };
        let place = complete.map_or_else(place, str::to_owned);
        format!("{}-{place}.{ending}", self.stem())
    }
}

/// Returns the text that a sweep writes, or the reason why it writes none.
fn text_of(write: impl FnOnce(&mut Vec<u8>) -> io::Result<SweepOutcome>) -> Result<String, String> {
    let mut text = Vec::new();
    write(&mut text).map_err(|e| e.to_string())?;
    String::from_utf8(text).map_err(|e| e.to_string())
}
