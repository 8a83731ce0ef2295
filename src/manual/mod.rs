//! The manual: its topics, and a topic as lines of a terminal.
//!
//! A topic is a text in Markdown that is compiled in. `krank help TOPIC` and the workbench show the same; what
//! stands elsewhere too, as the keys of a scene and the notation, is included from there.

#[cfg(feature = "tui")]
mod fold;
mod layout;
mod markdown;
mod table;

use crate::wording::{Wording, Words};
#[cfg(feature = "tui")]
pub(crate) use fold::{folded, joined};
#[cfg(feature = "tui")]
pub(crate) use layout::ManualLine;
pub(crate) use layout::{LineKind, lines};

/// Something to read.
#[derive(Debug)]
pub(crate) struct Topic {
    /// In one word, as it is asked for.
    pub(crate) name: &'static str,
    /// In a line, what it tells.
    pub(crate) about: Wording,
    parts: &'static [&'static str],
}

/// The line in whose place the table of the workbench's keys stands.
const KEYS: &str = "{keys}\n";
/// The same for the keys of a scene.
const SCENE_KEYS: &str = "{keys of a scene}\n";

impl Topic {
    /// The text in Markdown; `keys` makes the rows of the workbench's keys, where they are shown.
    pub(crate) fn text(&self, keys: impl FnOnce() -> String) -> String {
        let text = self.parts.concat();
        let text = filled(text, KEYS, keys);
        filled(text, SCENE_KEYS, crate::scene::reference)
    }
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
        about: <dyn Words>::about_tutorial,
        parts: &[include_str!("tutorial.md")],
    },
    Topic {
        name: "scene",
        about: <dyn Words>::about_scene,
        parts: &[
            include_str!("scene.md"),
            include_str!("../scene/rules.md"),
            include_str!("faults.md"),
        ],
    },
    #[cfg(feature = "tui")]
    Topic {
        name: "views",
        about: <dyn Words>::about_views,
        parts: &[include_str!("views.md")],
    },
    #[cfg(feature = "tui")]
    Topic {
        name: "keys",
        about: <dyn Words>::about_keys,
        parts: &[include_str!("keys.md")],
    },
    Topic {
        name: "columns",
        about: <dyn Words>::about_columns,
        parts: &[include_str!("columns.md"), include_str!("../notation.md")],
    },
    Topic {
        name: "forces",
        about: <dyn Words>::about_forces,
        parts: &[include_str!("forces.md")],
    },
    Topic {
        name: "drawings",
        about: <dyn Words>::about_drawings,
        parts: &[include_str!("drawings.md")],
    },
    Topic {
        name: "files",
        about: <dyn Words>::about_files,
        parts: &[include_str!("files.md"), include_str!("exercises.md")],
    },
    Topic {
        name: "trust",
        about: <dyn Words>::about_trust,
        parts: &[include_str!("trust.md")],
    },
    #[cfg(feature = "tui")]
    Topic {
        name: "terminals",
        about: <dyn Words>::about_terminals,
        parts: &[include_str!("terminals.md")],
    },
    Topic {
        name: "limits",
        about: <dyn Words>::about_limits,
        parts: &[include_str!("limits.md")],
    },
];

/// The topic of this name.
pub(crate) fn find(name: &str) -> Option<&'static Topic> {
    TOPICS.iter().find(|topic| topic.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The narrowest screen of the workbench, a terminal, and a wide one.
    const WIDTHS: [usize; 3] = [40, 80, 100];

    /// Topics are read where the locale has nothing else, and their Markdown is what is understood here.
    #[test]
    fn topics_are_plain() {
        for topic in TOPICS {
            let text = topic.text(String::new);
            assert!(text.is_ascii(), "{}", topic.name);
            assert!(text.starts_with("# "), "{}", topic.name);
            assert!(
                !text.contains(KEYS) && !text.contains(SCENE_KEYS),
                "{}",
                topic.name
            );
            for foreign in ["](", "<br", "\t", "\n1. "] {
                assert!(!text.contains(foreign), "{}: {foreign}", topic.name);
            }
        }
    }

    /// The words of a text, sorted: tables change the order of theirs. Rules of tables, fences and marks of
    /// headings are none.
    fn words(text: &str) -> Vec<String> {
        let pieces = text.split(|c: char| c.is_whitespace() || c == '|');
        let bare = pieces.map(|word| word.replace("**", "").trim_matches(['#', ':']).to_owned());
        let is_word = |word: &String| !word.chars().all(|c| c == '-') && !word.starts_with("```");
        let mut words: Vec<String> = bare.filter(is_word).collect();
        words.sort();
        words
    }

    /// The words in the heads of tables.
    fn heads(text: &str) -> Vec<String> {
        let lines: Vec<&str> = text.lines().collect();
        let heads = lines.windows(2).filter(|pair| pair[1].starts_with("|---"));
        heads.flat_map(|pair| words(pair[0])).collect()
    }

    /// Every word of a topic is shown at every width.
    #[test]
    fn no_word_is_lost() {
        for topic in TOPICS {
            let text = topic.text(String::new);
            for width in WIDTHS {
                let shown: Vec<String> = lines(&text, width).into_iter().map(|l| l.text).collect();
                let mut shown = words(&shown.join("\n"));
                // The head of a column may be told at each of its cells, or not at all.
                let heads = heads(&text);
                let mut lost = words(&text);
                lost.retain(|word| match shown.binary_search(word) {
                    Ok(i) => {
                        shown.remove(i);
                        false
                    }
                    Err(_) => true,
                });
                lost.retain(|word| !heads.contains(word));
                assert!(lost.is_empty(), "{} at {width}: {lost:?}", topic.name);
            }
        }
    }

    /// Only what is written as it stands, a screen or a file, may be wider than the terminal.
    #[test]
    fn lines_keep_to_the_width() {
        for topic in TOPICS {
            for width in WIDTHS {
                for line in lines(&topic.text(String::new), width) {
                    let length = line.text.chars().count();
                    let fits = length <= width || line.kind == LineKind::Code;
                    assert!(fits, "{} at {width}: {}", topic.name, line.text);
                }
            }
        }
    }
}
