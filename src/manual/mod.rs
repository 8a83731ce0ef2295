//! Provides the manual: as Markdown topics, as lines for a terminal, and as a web site.
//!
//! The topics are compiled in. `krank help TOPIC` and the workbench show the same text. Parts with another source are
//! included from there, such as the keys of a scene and the notation.

mod layout;
#[cfg(feature = "tui")]
mod line_folding;
mod markdown;
mod search;
mod table;
mod website;

use crate::document::with_ascii_letters;
use crate::wording::{Language, Wording, Words, words};
pub(crate) use layout::{LineKind, lines};
#[cfg(feature = "tui")]
pub(crate) use layout::{ManualLine, plain};
#[cfg(feature = "tui")]
pub(crate) use line_folding::{folded, joined};
pub(crate) use search::{FoundTopic, SearchWords};
pub(crate) use website::site;

/// A topic of the manual.
#[derive(Debug)]
pub(crate) struct Topic {
    /// The English name in one word.
    pub(crate) name: &'static str,
    /// The description, in one line.
    pub(crate) about: Wording,
    /// The names of its pages.
    pages: &'static [&'static str],
}

/// The pages of a language, with their names.
type Book = &'static [(&'static str, &'static str)];

/// Includes the pages in a folder. Two of them may come from another source.
macro_rules! book {
    ($folder:literal) => {
        book!(
            $folder,
            include_str!(concat!($folder, "/rules.md")),
            include_str!(concat!($folder, "/notation.md"))
        )
    };
    ($folder:literal, $rules:expr, $notation:expr) => {
        book!(
            @ $folder, [("rules", $rules), ("notation", $notation)],
            "columns" "commands" "designs" "drawings" "exercises" "faults" "files" "forces"
            "glossary" "how" "imports" "keys" "limits" "scene" "synthesis" "terminals"
            "tolerances" "trust" "tutorial" "views"
        )
    };
    (@ $folder:literal, [$($given:expr),*], $($page:literal)*) => {
        &[$($given,)* $(($page, include_str!(concat!($folder, "/", $page, ".md")))),*]
    };
}

/// The pages of each language, in the order of [`Language::ALL`].
const BOOKS: [Book; Language::ALL.len()] = [
    book!("english", crate::scene::RULES, kinematics::NOTATION),
    book!("turkish"),
];

/// Returns a page in a language; every language has all pages.
fn page(language: Language, name: &str) -> &'static str {
    let mut pages = BOOKS[language as usize].iter();
    pages
        .find(|(own, _)| *own == name)
        .map_or("", |(_, text)| text)
}

/// Placeholder line for the table of the workbench's keys.
const KEYS: &str = "{keys}\n";
/// Placeholder line for the reference of the scene file's keys.
const SCENE_KEYS: &str = "{keys of a scene}\n";

impl Topic {
    /// Returns the Markdown text in the current language. `keys` writes the table rows of the workbench's keys; it is
    /// called only if the topic has this table.
    pub(crate) fn text(&self, keys: impl FnOnce() -> String) -> String {
        let language = Language::current_language();
        let text: String = self.pages.iter().map(|name| page(language, name)).collect();
        let text = filled(text, KEYS, keys);
        filled(text, SCENE_KEYS, crate::scene::reference)
    }

    /// Returns the description for the list of topics; in Turkish it includes the name.
    pub(crate) fn description(&self) -> String {
        words().topic_told((self.about)(words()), self.called())
    }

    /// Returns the name in the current language.
    pub(crate) fn called(&self) -> &'static str {
        self.name_in(Language::current_language())
    }

    fn name_in(&self, language: Language) -> &'static str {
        let names = |language: Language| language.words().names_of_topics().split(' ');
        let mut pairs = names(Language::English).zip(names(language));
        pairs
            .find(|(name, _)| *name == self.name)
            .map_or(self.name, |(_, own)| own)
    }

    /// Returns `true` if this word is the topic's name in any language.
    fn has_name(&self, word: &str) -> bool {
        let names = Language::ALL.map(|language| self.name_in(language));
        let mut translated = names.into_iter().filter(|name| *name != self.name);
        word == self.name || translated.any(|name| spelled(word) == spelled(name))
    }
}

/// Converts a word to lower case and ASCII letters, as typed on a keyboard without Turkish letters.
fn spelled(word: &str) -> String {
    with_ascii_letters(word).to_ascii_lowercase()
}

/// Replaces the first occurrence of a line by the text that `what` returns.
fn filled(text: String, line: &str, what: impl FnOnce() -> String) -> String {
    match text.split_once(line) {
        Some((before, after)) => before.to_owned() + &what() + after,
        None => text,
    }
}

/// All topics in reading order. Topics about the workbench need the feature `tui`.
pub(crate) const TOPICS: &[Topic] = &[
    Topic {
        name: "tutorial",
        about: <dyn Words>::about_tutorial,
        pages: &["tutorial", "commands"],
    },
    Topic {
        name: "how",
        about: <dyn Words>::about_how,
        pages: &["how"],
    },
    Topic {
        name: "scene",
        about: <dyn Words>::about_scene,
        pages: &["scene", "rules", "faults"],
    },
    Topic {
        name: "imports",
        about: <dyn Words>::about_import,
        pages: &["imports"],
    },
    #[cfg(feature = "tui")]
    Topic {
        name: "views",
        about: <dyn Words>::about_views,
        pages: &["views"],
    },
    #[cfg(feature = "tui")]
    Topic {
        name: "keys",
        about: <dyn Words>::about_keys,
        pages: &["keys"],
    },
    Topic {
        name: "columns",
        about: <dyn Words>::about_columns,
        pages: &["columns", "notation"],
    },
    Topic {
        name: "designs",
        about: <dyn Words>::about_designs,
        pages: &["designs"],
    },
    Topic {
        name: "synthesis",
        about: <dyn Words>::about_synthesis,
        pages: &["synthesis"],
    },
    Topic {
        name: "forces",
        about: <dyn Words>::about_forces,
        pages: &["forces"],
    },
    Topic {
        name: "tolerances",
        about: <dyn Words>::about_tolerances,
        pages: &["tolerances"],
    },
    Topic {
        name: "drawings",
        about: <dyn Words>::about_drawings,
        pages: &["drawings"],
    },
    Topic {
        name: "files",
        about: <dyn Words>::about_files,
        pages: &["files", "exercises"],
    },
    Topic {
        name: "trust",
        about: <dyn Words>::about_trust,
        pages: &["trust"],
    },
    #[cfg(feature = "tui")]
    Topic {
        name: "terminals",
        about: <dyn Words>::about_terminals,
        pages: &["terminals"],
    },
    Topic {
        name: "limits",
        about: <dyn Words>::about_limits,
        pages: &["limits"],
    },
    Topic {
        name: "glossary",
        about: <dyn Words>::about_glossary,
        pages: &["glossary"],
    },
];

/// Returns the topic with this name in any language; `None` if there is none.
pub(crate) fn find(name: &str) -> Option<&'static Topic> {
    TOPICS.iter().find(|topic| topic.has_name(name))
}

/// Returns the translated names of the topics in the current language; none in English.
pub(crate) fn names_of_language() -> impl Iterator<Item = &'static str> {
    let is_translated = |topic: &&Topic| topic.called() != topic.name;
    TOPICS.iter().filter(is_translated).map(Topic::called)
}

#[cfg(test)]
mod tests;
