//! The argument `--language`.

use crate::wording::{Language, words};
use clap::ValueEnum;

/// The language that is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum LanguageChoice {
    #[value(help = words().language_auto())]
    #[default]
    Auto,
    #[value(help = words().language_turkish())]
    Tr,
    #[value(help = words().language_english())]
    En,
}

impl LanguageChoice {
    /// Returns the requested language; `None` for `auto`.
    pub(in crate::cli) fn asked(self) -> Option<Language> {
        match self {
            LanguageChoice::Auto => None,
            LanguageChoice::Tr => Some(Language::Turkish),
            LanguageChoice::En => Some(Language::English),
        }
    }
}
