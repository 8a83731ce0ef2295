//! What keys go to.

use super::Unsaved;
use crate::tui::commands::line::EditLine;
use crate::tui::document::writing::{Prompt, Question};
use crate::tui::figures::search::NameSearch;
use crate::tui::views::help::text::Help;
use crate::tui::views::offer::list::Offer;
use crate::tui::views::palette::list::CommandList;
use crate::tui::views::picker::list::Picker;
use crate::tui::views::plots::list::PlotList;

/// What keys go to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    /// The view.
    Normal,
    /// The help overlay.
    Help(Help),
    /// This screen of the tour.
    Tour(usize),
    /// The line in which a coordinate is typed.
    GoTo(EditLine),
    /// The line in which is typed where a method begins.
    Guess(EditLine),
    /// The line in the scene view in which is typed what is to be met.
    Goal(EditLine),
    /// The designs that meet it, being looked for and gone through.
    GoalRun,
    /// The list of all commands.
    Palette(CommandList),
    /// The list of assemblies, with the cursor on this one.
    Assemblies(usize),
    /// The list in which is chosen what is plotted.
    PlotList(PlotList),
    /// The line in which the name of a file is typed.
    FileName(Prompt),
    /// The question whether to write to a file.
    Confirm(Question),
    /// The list of presets and files.
    Pick(Box<Picker>),
    /// The linkages for a task.
    Candidates,
    /// The line in which a name is typed that is sought.
    Search(NameSearch),
    /// The question how much of the tables is copied.
    Copy,
    /// The line in the scene view in which a value is typed.
    Value(EditLine),
    /// A question about unsaved edits.
    Unsaved(Unsaved),
    /// The offer of edits that earlier sessions have left.
    Recovery(Box<Offer>),
}

impl Mode {
    /// The line that is typed in, if there is one.
    pub(super) fn line(&mut self) -> Option<&mut EditLine> {
        match self {
            Mode::GoTo(line) | Mode::Guess(line) | Mode::Goal(line) | Mode::Value(line) => {
                Some(line)
            }
            Mode::Palette(palette) => Some(palette.line()),
            Mode::FileName(prompt) => Some(&mut prompt.name),
            Mode::Help(help) => help.typed(),
            Mode::PlotList(list) => list.typed(),
            Mode::Search(search) => Some(&mut search.name),
            Mode::Normal
            | Mode::Tour(_)
            | Mode::GoalRun
            | Mode::Assemblies(_)
            | Mode::Confirm(_)
            | Mode::Unsaved(_)
            | Mode::Recovery(_)
            | Mode::Pick(_)
            | Mode::Candidates
            | Mode::Copy => None,
        }
    }
}
