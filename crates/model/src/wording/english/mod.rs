//! English messages, grouped by topic.

mod actions;
mod check;
mod commands;
mod configuration;
mod cycles;
mod designs;
mod driver_motion;
mod editing;
mod errors;
mod examples;
mod exercises;
mod exports;
mod faults;
mod figures;
mod files;
mod forces;
mod formulas;
mod help;
mod hints;
mod imports;
mod loads;
mod manual;
mod methods;
mod motion;
mod motors;
mod options;
mod parts;
mod plots;
mod reactions;
mod reading;
mod recovery;
mod reporting;
mod scene_keys;
mod scene_picker;
mod tasks;
mod terminals;
mod tolerances;
mod tour;
mod views;
mod working;

pub(super) use actions::ActionsWords;
pub(super) use check::CheckingWords;
pub(super) use commands::CommandsWords;
pub(super) use configuration::ConfigurationWords;
pub(super) use cycles::CyclesWords;
pub(super) use designs::DesignsWords;
pub(super) use driver_motion::CoursesWords;
pub(super) use editing::EditingWords;
pub(super) use errors::ErrorsWords;
pub(super) use examples::ExamplesWords;
pub(super) use exercises::ExercisesWords;
pub(super) use exports::ExportsWords;
pub(super) use faults::FaultsWords;
pub(super) use figures::FiguresWords;
pub(super) use files::FilesWords;
pub(super) use forces::ForcesWords;
pub(super) use formulas::FormulasWords;
pub(super) use help::HelpingWords;
pub(super) use hints::HintsWords;
pub(super) use imports::ImportsWords;
pub(super) use loads::ActingWords;
pub(super) use manual::ManualWords;
pub(super) use methods::MethodsWords;
pub(super) use motion::MotionWords;
pub(super) use motors::MotorsWords;
pub(super) use options::OptionsWords;
pub(super) use parts::PartsWords;
pub(super) use plots::PlotsWords;
pub(super) use reactions::ReactionsWords;
pub(super) use reading::ReadingWords;
pub(super) use recovery::OfferingWords;
pub(super) use reporting::ReportingWords;
pub(super) use scene_keys::SceneKeysWords;
pub(super) use scene_picker::PickingWords;
pub(super) use tasks::TasksWords;
pub(super) use terminals::TerminalsWords;
pub(super) use tolerances::TolerancesWords;
pub(super) use tour::TourWords;
pub(super) use views::ViewsWords;
pub(super) use working::WorkingWords;

/// English, the default language.
#[derive(Debug)]
pub(super) struct English;

/// Formats a count with its noun: `1 link`, `3 links`.
fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
