//! All messages of krank, in a catalogue with a file for each language.
//!
//! A message is a function whose arguments are the variable names and values. Arguments are passed
//! in their final form: values are formatted by `report::number`, and units are separate words.
//! Grammar (plural forms, word order) is handled by each language. Names of configurable actions,
//! of columns and of keys are part of the interface and are never translated.
//!
//! `english.txt` and `turkish.txt` have the texts. The build script writes the trait [`Words`] and its
//! implementations from them, and the type [`Language`]. A further language is a copy of
//! `turkish.txt` and a line in `build.rs`. A missing message is a compile error.

#[cfg(test)]
mod catalogue;
mod english;
mod language;
mod messages;
mod turkish;

pub use messages::{Language, Words};

/// A reference to a message, for tables such as that of the actions.
pub type Wording = fn(&'static dyn Words) -> &'static str;

/// Returns the messages in the current language.
pub fn words() -> &'static dyn Words {
    Language::current_language().words()
}

/// Returns the messages for files that other programs read. They are always English: names and
/// reasons in CSV and JSON must not change.
pub fn english_words() -> &'static dyn Words {
    Language::English.words()
}

#[cfg(test)]
mod tests;
