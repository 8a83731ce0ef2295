//! Defines the input modes.

use crate::tui::app::Unsaved;
use crate::tui::app::goal_run::GoalRun;
use crate::tui::commands::line::EditLine;
use crate::tui::document::writing::{Prompt, Question};
use crate::tui::figures::search::NameSearch;
use crate::tui::player::assembly_list::AssemblyList;
use crate::tui::views::help::text::Help;
use crate::tui::views::palette::list::CommandList;
use crate::tui::views::plots::list::PlotList;
use crate::tui::views::recovery_offer::list::Offer;
use crate::tui::views::scene_picker::list::Picker;
use crate::tui::views::tour::screens::TourPage;

/// The input mode, which receives the keys.
#[derive(Debug, Default)]
pub(crate) enum Mode {
    /// The current view.
    #[default]
    Normal,
    /// The help overlay.
    Help(Help),
    /// A page of the tour.
    Tour(TourPage),
    /// The input line for a driver coordinate.
    GoTo(EditLine),
    /// The input line for the initial guess of a method.
    Guess(EditLine),
    /// The input line for goals, in the scene view.
    Goal(EditLine),
    /// The designs that meet a goal, while they are searched or browsed.
    GoalRun(Box<GoalRun>),
    /// The list of all commands.
    Palette(CommandList),
    /// The list of assemblies at the driver's coordinate.
    Assemblies(Box<AssemblyList>),
    /// The list of plottable columns.
    PlotList(PlotList),
    /// The input line for a file name.
    FileName(Prompt),
    /// The prompt before writing to a file.
    Confirm(Question),
    /// The list of presets and files.
    AssemblyChoice(Box<Picker>),
    /// The candidate linkages for a synthesis task.
    Candidates,
    /// The input line of a search by name.
    Search(NameSearch),
    /// The prompt for how much of the tables to copy.
    Copy,
    /// The input line for a value, in the scene view.
    Value(EditLine),
    /// A prompt about unsaved edits.
    Unsaved(Unsaved),
    /// The offer to restore edits of earlier sessions.
    Recovery(Box<Offer>),
}

impl Mode {
    /// Returns `true` if keys go to the current view.
    pub(crate) fn is_normal(&self) -> bool {
        matches!(self, Mode::Normal)
    }

    /// Returns the input line of this mode, if it has one.
    pub(in crate::tui::app) fn line(&mut self) -> Option<&mut EditLine> {
        match self {
            Mode::GoTo(line) | Mode::Guess(line) | Mode::Goal(line) | Mode::Value(line) => {
                Some(line)
            }
            Mode::Palette(palette) => Some(&mut palette.line),
            Mode::FileName(prompt) => Some(&mut prompt.name),
            Mode::Help(help) => help.typed(),
            Mode::PlotList(list) => list.typed(),
            Mode::Search(search) => Some(&mut search.name),
            Mode::Normal
            | Mode::Tour(_)
            | Mode::GoalRun(_)
            | Mode::Assemblies(_)
            | Mode::Confirm(_)
            | Mode::Unsaved(_)
            | Mode::Recovery(_)
            | Mode::AssemblyChoice(_)
            | Mode::Candidates
            | Mode::Copy => None,
        }
    }
}
