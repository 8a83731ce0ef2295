//! All messages of krank, in a catalogue with an implementation for each language.
//!
//! A message is a function whose arguments are the variable names and values. Arguments are passed
//! in their final form: values are formatted by `report::number`, and units are separate words.
//! Grammar (plural forms, word order) is handled by each language. Names of configurable actions,
//! of columns and of keys are part of the interface and are never translated.
//!
//! A second language is a folder next to `english` with `catalogue! { impl .. }` for each of its
//! parts, and a variant of [`Language`]. A missing message is a compile error.

#[macro_use]
mod catalogue;
mod english;
mod language;
mod turkish;

pub use language::Language;

use english::*;
use turkish::Turkish;

/// All messages in one language.
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
    + ImportsWords
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

/// A reference to a message, for tables such as that of the actions.
pub type Wording = fn(&'static dyn Words) -> &'static str;

/// Returns the messages in the current language.
pub fn words() -> &'static dyn Words {
    Language::current_language().words()
}

/// Returns the messages for files that other programs read. They are always English: names and
/// reasons in CSV and JSON must not change.
pub fn english_words() -> &'static dyn Words {
    &English
}

#[cfg(test)]
mod tests;
