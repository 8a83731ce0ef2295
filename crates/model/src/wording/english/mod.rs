//! English messages, grouped by topic.

mod acting;
mod actions;
mod checking;
mod commands;
mod configuration;
mod courses;
mod cycles;
mod designs;
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
mod helping;
mod hints;
mod imports;
mod manual;
mod methods;
mod motion;
mod motors;
mod offering;
mod options;
mod parts;
mod picking;
mod plots;
mod reactions;
mod reading;
mod reporting;
mod scene_keys;
mod tasks;
mod terminals;
mod tolerances;
mod tour;
mod views;
mod working;

pub(super) use acting::ActingWords;
pub(super) use actions::ActionsWords;
pub(super) use checking::CheckingWords;
pub(super) use commands::CommandsWords;
pub(super) use configuration::ConfigurationWords;
pub(super) use courses::CoursesWords;
pub(super) use cycles::CyclesWords;
pub(super) use designs::DesignsWords;
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
pub(super) use helping::HelpingWords;
pub(super) use hints::HintsWords;
pub(super) use imports::ImportsWords;
pub(super) use manual::ManualWords;
pub(super) use methods::MethodsWords;
pub(super) use motion::MotionWords;
pub(super) use motors::MotorsWords;
pub(super) use offering::OfferingWords;
pub(super) use options::OptionsWords;
pub(super) use parts::PartsWords;
pub(super) use picking::PickingWords;
pub(super) use plots::PlotsWords;
pub(super) use reactions::ReactionsWords;
pub(super) use reading::ReadingWords;
pub(super) use reporting::ReportingWords;
pub(super) use scene_keys::SceneKeysWords;
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
