//! What every view says of itself: all that the rest of the workbench knows of one.
//!
//! A view reads the workbench and changes nothing. What it needs to have found is told by [`Need`], and what
//! its lines are by [`Listing`]; the workbench does the rest. It is drawn where it is put and knows the size of that
//! place alone: which others stand beside it, and where, is the affair of [`super::layout`]. A new view is a file with an `impl Pane`, a row in
//! `View::pane`, its name in `View`, and its key in the table of actions.

use super::{Sketch, inset, page};
use crate::page::{Line, Page};
use crate::quantity::Subject;
use crate::tui::app::{App, View};
use crate::tui::commands::action::{Action, entry_of};
use crate::tui::figures::sheet::SheetPart;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// A view.
pub(crate) trait Pane {
    /// In one word: in the last line, and on the command line.
    fn name(&self) -> &'static str;

    /// What it shows, in the help of the command line.
    fn about(&self) -> &'static str;

    /// Above the keys in the help that it alone has.
    fn help_title(&self) -> &'static str;

    /// Itself: what is scrolled is kept by view.
    fn view(&self) -> View;

    /// Why it has nothing to show of this scene.
    fn nothing(&self, _app: &App) -> Option<&'static str> {
        None
    }

    /// What stands above it among other panes, in so many columns: at the left, and at the right.
    fn heading(&self, _app: &App, _room: u16) -> (String, String) {
        let name = (entry_of(Action::Look(self.view())).hint)(words());
        (name.into(), String::new())
    }

    /// What is to be found while it stands, and only then.
    fn needs(&self) -> Need {
        Need::Nothing
    }

    /// What its lines are.
    fn list(&self) -> Listing {
        Listing::Lines
    }

    /// Brings what the screen remembers of its last frame up to date.
    fn prepare(&self, _app: &App, _sketch: &mut Sketch, _body: Rect) {}

    /// Its lines in an area; of a view that is more than lines none.
    fn lines(&self, _app: &App, _area: Rect) -> Vec<Line> {
        Vec::new()
    }

    /// The lines that are scrolled and searched, and where they stand.
    fn listed(&self, app: &App, body: Rect) -> (Vec<Line>, Rect) {
        let area = inset(body);
        (self.lines(app, area), area)
    }

    /// What stands between the title and the last line.
    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let (lines, area) = self.listed(app, body);
        page::render(app, self.view(), &lines, area, buffer);
    }

    /// How many lines it has, and how many of them are seen.
    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let (lines, area) = self.listed(app, body);
        (lines.len(), area.height.into())
    }

    /// What the row under its cursor is about: the drawing beside it lights that up.
    fn subject(&self, _app: &App) -> Option<Subject> {
        None
    }

    /// What of it stands at a cell, where that can be pointed at; the drawing itself is told by its sketch.
    fn under(&self, _app: &App, _body: Rect, _at: Position) -> Option<PaneSpot> {
        None
    }

    /// The keys to offer, the most important first: the last ones are dropped where there is no room.
    fn hints(&self, _app: &App) -> &'static [Action] {
        &[
            Action::Help,
            Action::MOTION,
            Action::LineDown,
            Action::Quit,
            Action::Play,
            Action::StepForward,
        ]
    }

    /// A mark that is told beside the keys, and what it means.
    fn legend(&self) -> Option<(char, &'static str)> {
        None
    }

    /// How far its figures can be from the truth, in so many columns; `None` where it shows none.
    fn trust(&self, _app: &App, _room: u16) -> Option<String> {
        None
    }

    /// Whether its rates are those of the scene's motion over time, if that has one.
    fn is_timed(&self, _app: &App) -> bool {
        true
    }

    /// How far its work has come, where that is of more interest than the driver.
    fn progress(&self, _app: &App) -> Option<String> {
        None
    }

    /// What is copied.
    fn copy(&self, _app: &App) -> Copied {
        Copied::Nothing
    }

    /// What is written as CSV, or why it cannot be: all figures here, unless it shows a whole motion.
    fn csv(&self, app: &App) -> Result<String, String> {
        app.row_of_sweep()
    }

    /// All of its lines as they are written to a file, and what they are: where these say more than its figures.
    fn page<'a>(&self, _app: &'a App) -> Option<(&'static str, &'a Page)> {
        None
    }

    /// What is written as SVG and what that is, or why it cannot be.
    fn svg(&self, _app: &App) -> Result<(&'static str, String), String> {
        Err(words().no_drawing_here().into())
    }

    /// What stands in the names of its files, where it shows more than one place of the motion.
    fn file_part(&self) -> Option<&'static str> {
        None
    }
}

/// What a view needs to have found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Need {
    /// The state alone, as everywhere.
    Nothing,
    /// What the given lengths do to the figures.
    Lengths,
    /// What the driver must do, and what joints and guides bear.
    Forces,
    /// How the figures come about.
    Working,
    /// The values of the scene.
    Values,
    /// Speed against error, piece by piece.
    Study,
    /// Figures over the motion.
    Curves,
    /// The motor over a cycle.
    Motor,
}

/// What the lines of a view are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Listing {
    /// They are read, and scrolled.
    Lines,
    /// Rows of the tables, with the cursor on one figure of them.
    Figures,
    /// Values of the scene, with the editor's cursor on one of them.
    Values,
}

/// What can be pointed at in a pane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum PaneSpot {
    /// A row of the tables.
    Figure(SheetPart, usize),
    /// A value of the scene.
    Value(usize),
    /// A coordinate of the driver along a plot.
    Along(f64),
    /// A time of its motion along a plot, in s.
    Time(f64),
}

/// What there is to copy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Copied {
    /// This text.
    Text(String),
    /// Its lines, as they stand there.
    Lines,
    /// As much of the tables as a person answers.
    Asked,
    Nothing,
}
