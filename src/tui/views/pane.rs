//! The interface of a view: all that the rest of the workbench knows about it.
//!
//! A view reads the workbench and changes nothing while it is drawn. Its results are kept in
//! [`super::state::ViewStates`], which computes them only while the view is visible. [`Listing`]
//! declares the kind of its lines. A view is drawn in a given area and knows only the size of that
//! area; [`super::layout`] alone selects and places the views. ARCHITECTURE.md lists the steps to add
//! a view.

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
    /// Returns the view itself, by which scroll offsets are stored.
    fn view(&self) -> View;

    /// Returns the reason why it shows nothing of this scene, if it does not.
    fn nothing(&self, _app: &App) -> Option<&'static str> {
        None
    }

    /// Returns the title among other panes, `room` columns wide: the left and the right part.
    fn heading(&self, _app: &App, _room: u16) -> (String, String) {
        let name = (entry_of(Action::Look(self.view())).hint)(words());
        (name.into(), String::new())
    }

    /// Returns the kind of its lines.
    fn list(&self) -> Listing {
        Listing::Lines
    }

    /// Updates the sketch for the next frame.
    fn prepare(&self, _app: &App, _sketch: &mut Sketch, _body: Rect) {}

    /// Returns the lines for an area; empty for a view with more than lines.
    fn lines(&self, _app: &App, _area: Rect) -> Vec<Line> {
        Vec::new()
    }

    /// Returns the lines for scrolling and searching, and their area.
    fn listed(&self, app: &App, body: Rect) -> (Vec<Line>, Rect) {
        let area = inset(body);
        (self.lines(app, area), area)
    }

    /// Renders the body of the view.
    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let (lines, area) = self.listed(app, body);
        page::render(app, self.view(), &lines, area, buffer);
    }

    /// Returns the number of its lines and the number of visible ones.
    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let (lines, area) = self.listed(app, body);
        (lines.len(), area.height.into())
    }

    /// Returns the subject of its selected row, which the drawing next to it highlights.
    fn subject(&self, _app: &App) -> Option<Subject> {
        None
    }

    /// Returns the spot at a cell of the screen, if the mouse can act there; the sketch handles the
    /// drawing itself.
    fn under(&self, _app: &App, _body: Rect, _at: Position) -> Option<PaneSpot> {
        None
    }

    /// Returns the actions whose keys are offered, the most important first; the last ones are
    /// dropped if they do not fit.
    fn hints(&self, _app: &App) -> &'static [Action] {
        &USUAL_HINTS
    }

    /// Returns a mark that the key hints explain, and its meaning.
    fn legend(&self) -> Option<(char, &'static str)> {
        None
    }

    /// Returns the error bound of its values in at most `room` columns; `None` if it shows none.
    fn trust(&self, _app: &App, _room: u16) -> Option<String> {
        None
    }

    /// Returns `true` if its rates are those of the scene's motion over time, if the scene has one.
    fn is_timed(&self, _app: &App) -> bool {
        true
    }

    /// Returns the progress of its work, if it is of more interest than the driver.
    fn progress(&self, _app: &App) -> Option<String> {
        None
    }

    /// Returns the content for the clipboard.
    fn copy(&self, _app: &App) -> Copied {
        Copied::Nothing
    }

    /// Returns the CSV text; by default one row with all values at the driver's current position.
    ///
    /// # Errors
    /// Returns the reason why nothing can be written.
    fn csv(&self, app: &App) -> Result<String, String> {
        app.row_of_sweep()
    }

    /// Returns the page written to a file and its description, if its lines contain more than its
    /// values.
    fn page<'a>(&self, _app: &'a App) -> Option<(&'static str, &'a Page)> {
        None
    }

    /// Returns the description and the text of its SVG document.
    ///
    /// # Errors
    /// Returns the reason why nothing can be drawn.
    fn svg(&self, _app: &App) -> Result<(&'static str, String), String> {
        Err(words().no_drawing_here().into())
    }

    /// Returns the part added to the names of its files, if it shows more than one position of the
    /// motion.
    fn file_part(&self) -> Option<&'static str> {
        None
    }
}

/// The actions whose keys most views offer.
pub(super) const USUAL_HINTS: [Action; 6] = [
    Action::Help,
    Action::MOTION,
    Action::LineDown,
    Action::Quit,
    Action::Play,
    Action::StepForward,
];

/// The kind of a view's lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Listing {
    /// Lines of text, which can be scrolled.
    Lines,
    /// Rows of the tables, with a cursor on one of their values.
    Figures,
    /// Values of the scene, with the editor's cursor on one of them.
    Values,
}

/// A spot in a pane that the mouse can act on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum PaneSpot {
    /// A row of the tables.
    Figure(SheetPart, usize),
    /// A value of the scene.
    Value(usize),
    /// A driver coordinate along a plot.
    PlotAxis(f64),
    /// A time along a plot, in s.
    Time(f64),
}

/// The content copied from a view.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Copied {
    /// The given text.
    Text(String),
    /// The view's lines as shown.
    Lines,
    /// A choice of the tables, for which the user is asked.
    Asked,
    Nothing,
}
