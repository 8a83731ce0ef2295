//! The manual: its topics, a topic as lines of a terminal, and all topics as a web site.
//!
//! A topic is a text in Markdown that is compiled in. `krank help TOPIC` and the workbench show the same; what
//! stands elsewhere too, as the keys of a scene and the notation, is included from there.

#[cfg(feature = "tui")]
mod fold;
mod layout;
mod markdown;
mod search;
mod table;
mod web;

use crate::document::with_ascii_letters;
use crate::wording::{Language, Wording, Words, words};
#[cfg(feature = "tui")]
pub(crate) use fold::{folded, joined};
pub(crate) use layout::{LineKind, lines};
#[cfg(feature = "tui")]
pub(crate) use layout::{ManualLine, plain};
pub(crate) use search::{FoundTopic, SearchWords};
pub(crate) use web::site;

/// Something to read.
#[derive(Debug)]
pub(crate) struct Topic {
    /// In one word, as it is asked for in every language.
    pub(crate) name: &'static str,
    /// The same in Turkish, as it may be asked for too.
    turkish: &'static str,
    /// In a line, what it tells.
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

/// The chapter of this name in the folders of the languages; the English of some stands elsewhere too.
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

/// The line in whose place the table of the workbench's keys stands.
const KEYS: &str = "{keys}\n";
/// The same for the keys of a scene.
const SCENE_KEYS: &str = "{keys of a scene}\n";

impl Topic {
    /// The text in Markdown, in the language that is spoken; `keys` makes the rows of the workbench's keys, where they
    /// are shown.
    pub(crate) fn text(&self, keys: impl FnOnce() -> String) -> String {
        let language = Language::spoken();
        let text: String = self.parts.iter().map(|part| part.of(language)).collect();
        let text = filled(text, KEYS, keys);
        filled(text, SCENE_KEYS, crate::scene::reference)
    }
}

impl Topic {
    /// As the list of the topics tells it: in Turkish with the name that it has there.
    pub(crate) fn told(&self) -> String {
        words().topic_told((self.about)(words()), self.turkish)
    }

    /// Its name in the language that is spoken.
    pub(crate) fn called(&self) -> &'static str {
        match Language::spoken() {
            Language::English => self.name,
            Language::Turkish => self.turkish,
        }
    }

    /// Whether it is asked for by this word.
    fn is_called(&self, word: &str) -> bool {
        word == self.name || spelled(word) == spelled(self.turkish)
    }
}

/// A word as it is typed where the keyboard has no Turkish letters.
fn spelled(word: &str) -> String {
    with_ascii_letters(word).to_ascii_lowercase()
}

/// The text with what is to stand in the place of a line.
fn filled(text: String, line: &str, what: impl FnOnce() -> String) -> String {
    match text.split_once(line) {
        Some((before, behind)) => before.to_owned() + &what() + behind,
        None => text,
    }
}

/// All topics, in the order in which one would read them; without the workbench those about it are left out.
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

/// The topic of this name, in English or in Turkish.
pub(crate) fn find(name: &str) -> Option<&'static Topic> {
    TOPICS.iter().find(|topic| topic.is_called(name))
}

/// The names of the topics in the language that is spoken, where they have others there.
pub(crate) fn names_of_language() -> impl Iterator<Item = &'static str> {
    let is_turkish = Language::spoken() == Language::Turkish;
    let topics = TOPICS.iter().filter(move |_| is_turkish);
    topics.map(|topic| topic.turkish)
}

#[cfg(test)]
mod tests;
