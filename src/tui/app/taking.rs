//! Taking figures and pictures out of the workbench.

use super::super::action::Action;
use super::super::figures::coordinate;
use super::super::key::Key;
use super::super::writing::{Document, Text};
use super::super::{Origin, clipboard, copying};
use super::{App, Effect, Mode, View};
use crate::quantity::Catalogue;
use crate::report::{Columns, Decimal, RowFormat, Steps, Sweep};

/// Why there is nothing to take out of the plots.
const NOTHING_PLOTTED: &str = "nothing is plotted that could be written";

impl App {
    pub(super) fn take_out(&mut self, action: Action) -> Effect {
        match action {
            Action::Copy => return self.copy(),
            Action::Picture => return Effect::Picture,
            Action::Svg => self.ask_for_svg(),
            _ => self.ask_for_csv(),
        }
        Effect::Show
    }

    /// Copies what the view shows; of the tables it asks how much.
    fn copy(&mut self) -> Effect {
        if !self.capability.modern {
            self.message = Some(format!("this terminal has no clipboard{}", self.mend()));
            return Effect::Show;
        }
        match self.view {
            View::Tables => {
                self.mode = Mode::Copy;
                Effect::Show
            }
            View::Motion => {
                let text = copying::tables(self.sheet(), self.tables());
                self.send(&text)
            }
            View::Plots | View::Accuracy | View::Forces | View::Scene | View::Lengths => {
                self.message = Some("nothing to copy here; the tables have all".into());
                Effect::Show
            }
        }
    }

    /// Keys that answer how much of the tables is copied; `None` for those that mean the same everywhere.
    pub(super) fn copy_key(&mut self, key: Key) -> Option<Effect> {
        let (sheet, tables) = (self.sheet(), self.tables());
        let text = match key {
            Key::Char('v') => copying::value(sheet, tables, self.cursor),
            Key::Char('r') => Some(copying::row(sheet, tables, self.cursor)),
            Key::Char('t') => Some(copying::table(sheet, tables, self.cursor.part)),
            Key::Ctrl(_) | Key::Escape => return None,
            _ => return Some(Effect::Show),
        };
        self.mode = Mode::Normal;
        if let Some(text) = text {
            return Some(self.send(&text));
        }
        self.message = Some("there is no value to copy".into());
        Some(Effect::Show)
    }

    /// Sends a text to the clipboard. Nothing tells whether it arrived.
    fn send(&mut self, text: &str) -> Effect {
        match clipboard::sequence(text) {
            Ok(bytes) => {
                let count = text.len();
                self.message = Some(format!("sent to the terminal's clipboard: {count} B"));
                Effect::Send(bytes)
            }
            Err(too_large) => {
                self.message = Some(format!("{too_large}{}", self.mend()));
                Effect::Show
            }
        }
    }

    /// What to do where nothing can be copied: `; Y writes CSV`.
    fn mend(&self) -> String {
        let key = self.keymap.key(Action::Csv);
        key.map_or_else(String::new, |key| format!("; {key} writes CSV"))
    }

    /// Asks where to write the figures as they are now, or of the plots, what is plotted.
    fn ask_for_csv(&mut self) {
        let (figures, what) = match self.view {
            View::Plots => (self.plots.csv().ok_or(NOTHING_PLOTTED.into()), "the curves"),
            View::Motion
            | View::Tables
            | View::Accuracy
            | View::Forces
            | View::Scene
            | View::Lengths => (self.row_of_sweep(), "the figures"),
        };
        match figures {
            Ok(text) => {
                let proposal = self.proposal("csv");
                let what = what.into();
                self.ask_for_file(Document::Text(Text { what, text }), &proposal);
            }
            Err(why) => self.message = Some(why),
        }
    }

    /// All figures here, as a sweep of one row has them.
    fn row_of_sweep(&self) -> Result<String, String> {
        let (scene, at) = (self.stage.scene(), self.stage.at());
        let catalogue = Catalogue::new(scene);
        let broken = || "no figures can be written here".to_owned();
        let here = Decimal::of(at).ok_or_else(broken)?;
        let step = Decimal::of(1.0).ok_or_else(broken)?;
        let sweep = Sweep {
            scene,
            solver: self.stage.solver(),
            columns: &Columns::new(catalogue.driver(), catalogue.all(), true),
            steps: &Steps::new(here, here, step).map_err(|e| e.to_string())?,
            format: RowFormat::Csv,
        };
        let mut text = Vec::new();
        let written = sweep.write(&mut text, &mut |_| {});
        written.map_err(|e| e.to_string())?;
        String::from_utf8(text).map_err(|e| e.to_string())
    }

    /// Asks where to write the screen as it was when the key was pressed.
    pub(crate) fn ask_for_picture(&mut self, text: String) {
        let proposal = self.proposal("txt");
        let what = "the screen".into();
        self.ask_for_file(Document::Text(Text { what, text }), &proposal);
    }

    /// Asks where to write the drawing as it is seen.
    fn ask_for_svg(&mut self) {
        match self.view {
            View::Motion => {
                let text = self.lens.svg(&self.stage);
                let proposal = self.proposal("svg");
                let what = "the drawing".into();
                self.ask_for_file(Document::Text(Text { what, text }), &proposal);
            }
            View::Plots => match self.plots.svg(&self.stage) {
                Some(text) => {
                    let proposal = self.proposal("svg");
                    let what = "the plot".into();
                    self.ask_for_file(Document::Text(Text { what, text }), &proposal);
                }
                None => self.message = Some(NOTHING_PLOTTED.into()),
            },
            View::Tables | View::Accuracy | View::Forces | View::Scene | View::Lengths => {
                self.message = Some("there is no drawing in this view".into())
            }
        }
    }

    /// The name of a file for what is seen here: `four-bar-60.csv`.
    fn proposal(&self, ending: &str) -> String {
        let stem = match self.stage.origin() {
            Origin::Preset(name) => Some(name.clone()),
            Origin::File(path) => path.file_stem().map(|s| s.to_string_lossy().into_owned()),
            Origin::Stdin => None,
        };
        let stem = stem.unwrap_or_else(|| "scene".into());
        format!("{stem}-{}.{ending}", coordinate(self.stage.at(), 0))
    }
}
