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
    /// The name in one word, accepted in every language.
    pub(crate) name: &'static str,
    /// The Turkish name, accepted in every language too.
    turkish: &'static str,
    /// The description, in one line.
    pub(crate) about: Wording,
    parts: &'static [ManualPart],
}

/// A chapter or a part of one, in each language.
#[derive(Debug)]
struct ManualPart {
    english: &'static str,
    turkish: &'static str,
}

impl ManualPart {
    fn of(&self, language: Language) -> &'static str {
        match language {
            Language::English => self.english,
            Language::Turkish => self.turkish,
        }
    }
}

/// Includes the chapter with this file name in each language; its English text may come from another source.
macro_rules! chapter {
    ($name:literal) => {
        chapter!($name, include_str!(concat!("english/", $name)))
    };
    ($name:literal, $english:expr) => {
        ManualPart {
            english: $english,
            turkish: include_str!(concat!("turkish/", $name)),
        }
    };
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
        let text: String = self.parts.iter().map(|part| part.of(language)).collect();
        let text = filled(text, KEYS, keys);
        filled(text, SCENE_KEYS, crate::scene::reference)
    }
}

impl Topic {
    /// Returns the description for the list of topics; in Turkish it includes the Turkish name.
    pub(crate) fn description(&self) -> String {
        words().topic_told((self.about)(words()), self.turkish)
    }

    /// Returns the name in the current language.
    pub(crate) fn called(&self) -> &'static str {
        match Language::current_language() {
            Language::English => self.name,
            Language::Turkish => self.turkish,
        }
    }

    /// Returns `true` if this word is the topic's name, in English or in Turkish.
    fn has_name(&self, word: &str) -> bool {
        word == self.name || spelled(word) == spelled(self.turkish)
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
        turkish: "giriş",
        about: <dyn Words>::about_tutorial,
        parts: &[chapter!("tutorial.md"), chapter!("commands.md")],
    },
    Topic {
        name: "how",
        turkish: "nasıl",
        about: <dyn Words>::about_how,
        parts: &[chapter!("how.md")],
    },
    Topic {
        name: "scene",
        turkish: "sahne",
        about: <dyn Words>::about_scene,
        parts: &[
            chapter!("scene.md"),
            chapter!("rules.md", crate::scene::RULES),
            chapter!("faults.md"),
        ],
    },
    Topic {
        name: "imports",
        turkish: "aktarma",
        about: <dyn Words>::about_import,
        parts: &[chapter!("imports.md")],
    },
    #[cfg(feature = "tui")]
    Topic {
        name: "views",
        turkish: "görünümler",
        about: <dyn Words>::about_views,
        parts: &[chapter!("views.md")],
    },
    #[cfg(feature = "tui")]
    Topic {
        name: "keys",
        turkish: "tuşlar",
        about: <dyn Words>::about_keys,
        parts: &[chapter!("keys.md")],
    },
    Topic {
        name: "columns",
        turkish: "sütunlar",
        about: <dyn Words>::about_columns,
        parts: &[
            chapter!("columns.md"),
            chapter!("notation.md", kinematics::NOTATION),
        ],
    },
    Topic {
        name: "designs",
        turkish: "tasarımlar",
        about: <dyn Words>::about_designs,
        parts: &[chapter!("designs.md")],
    },
    Topic {
        name: "synthesis",
        turkish: "sentez",
        about: <dyn Words>::about_synthesis,
        parts: &[chapter!("synthesis.md")],
    },
    Topic {
        name: "forces",
        turkish: "kuvvetler",
        about: <dyn Words>::about_forces,
        parts: &[chapter!("forces.md")],
    },
    Topic {
        name: "tolerances",
        turkish: "toleranslar",
        about: <dyn Words>::about_tolerances,
        parts: &[chapter!("tolerances.md")],
    },
    Topic {
        name: "drawings",
        turkish: "çizimler",
        about: <dyn Words>::about_drawings,
        parts: &[chapter!("drawings.md")],
    },
    Topic {
        name: "files",
        turkish: "dosyalar",
        about: <dyn Words>::about_files,
        parts: &[chapter!("files.md"), chapter!("exercises.md")],
    },
    Topic {
        name: "trust",
        turkish: "güven",
        about: <dyn Words>::about_trust,
        parts: &[chapter!("trust.md")],
    },
    #[cfg(feature = "tui")]
    Topic {
        name: "terminals",
        turkish: "terminaller",
        about: <dyn Words>::about_terminals,
        parts: &[chapter!("terminals.md")],
    },
    Topic {
        name: "limits",
        turkish: "sınırlar",
        about: <dyn Words>::about_limits,
        parts: &[chapter!("limits.md")],
    },
    Topic {
        name: "glossary",
        turkish: "sözlük",
        about: <dyn Words>::about_glossary,
        parts: &[chapter!("glossary.md")],
    },
];

/// Returns the topic with this name, in English or in Turkish; `None` if there is none.
pub(crate) fn find(name: &str) -> Option<&'static Topic> {
    TOPICS.iter().find(|topic| topic.has_name(name))
}

/// Returns the translated names of the topics in the current language; none in English.
pub(crate) fn names_of_language() -> impl Iterator<Item = &'static str> {
    let is_turkish = Language::current_language() == Language::Turkish;
    let topics = TOPICS.iter().filter(move |_| is_turkish);
    topics.map(|topic| topic.turkish)
}

#[cfg(test)]
mod tests;
