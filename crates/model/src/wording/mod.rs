//! What krank says, by what it means: one catalogue, and what each language makes of it.
//!
//! A sentence is a function: of nothing where it is always the same, of the names and figures in it where it is
//! not. They come as they are to be read, figures written by `report::number`, units as words of their own; what
//! grammar asks for (a plural, an order of words) is the affair of the language. Names of actions in a
//! configuration, of columns and of keys are promises, and no wording.
//!
//! A second language is a folder beside `english` with `catalogue! { impl .. }` for each of its parts, and a name
//! in [`Language`]; while a sentence is missing in it, it does not build.

#[macro_use]
mod catalogue;
mod english;
mod language;
mod turkish;

pub use language::Language;

use english::*;
use turkish::Turkish;

/// Every sentence, in one language.
pub trait Words:
    ActingWords
    + ActionsWords
    + CheckingWords
    + CommandsWords
    + ConfigurationWords
    + CoursesWords
    + CyclesWords
    + DesignsWords
    + EditingWords
    + ErrorsWords
    + ExamplesWords
    + ExercisesWords
    + ExportsWords
    + FaultsWords
    + FiguresWords
    + FilesWords
    + ForcesWords
    + FormulasWords
    + HelpingWords
    + HintsWords
    + ManualWords
    + MethodsWords
    + MotionWords
    + MotorsWords
    + OfferingWords
    + OptionsWords
    + PartsWords
    + PickingWords
    + PlotsWords
    + ReactionsWords
    + ReadingWords
    + ReportingWords
    + SceneKeysWords
    + TasksWords
    + TerminalsWords
    + TolerancesWords
    + TourWords
    + ViewsWords
    + WorkingWords
{
}

impl Words for English {}
impl Words for Turkish {}

/// A sentence that is chosen where nothing is said yet, as in a table of actions.
pub type Wording = fn(&'static dyn Words) -> &'static str;

/// The sentences in the language that is spoken.
pub fn words() -> &'static dyn Words {
    Language::spoken().words()
}

/// The sentences as files for other programs have them, whatever is spoken: names and reasons in CSV and JSON are
/// promises.
pub fn for_programs() -> &'static dyn Words {
    &English
}

#[cfg(test)]
mod tests;
