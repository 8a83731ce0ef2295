//! Tests that the chapters of all languages have the same commands, code, numbers and tables below each heading.

use super::*;
use crate::wording::words;
use std::collections::BTreeSet;

/// Texts of screens that are translated although chapters quote them as code: English and Turkish.
const SCREENS: [(&str, &str); 5] = [
    ("at", "yer"),
    (
        "four-bar, crank-rocker: Grashof",
        "dört çubuk, krank-sarkaç: Grashof",
    ),
    ("iter", "yin"),
    ("r3 at C by r4", "r3, C (r4)"),
    ("turns fully", "tam döner"),
];

/// Words of English sentences that never occur in Turkish ones.
const ENGLISH: [&str; 23] = [
    "and", "are", "be", "by", "each", "for", "from", "has", "have", "is", "its", "of", "or",
    "that", "the", "their", "these", "to", "what", "where", "which", "with", "without",
];

/// A heading with the content below it.
#[derive(Debug, Default)]
struct Section {
    heading: String,
    /// The number of paragraphs and list items.
    passages: usize,
    /// The number of table rows.
    rows: usize,
    /// Fenced code: its language and its lines.
    blocks: Vec<(String, Vec<String>)>,
    /// Commands on their own line.
    commands: Vec<String>,
    /// All other text, in one line.
    words: String,
}

impl Section {
    /// Returns the level of the heading; 0 before the first heading.
    fn level(&self) -> usize {
        self.heading.chars().take_while(|c| *c == '#').count()
    }

    /// Returns the inline code.
    fn code(&self) -> BTreeSet<&str> {
        self.words.split('`').skip(1).step_by(2).collect()
    }

    /// Returns the heading and sentences without their inline code.
    fn prose(&self) -> String {
        let pieces: Vec<&str> = self.words.split('`').step_by(2).collect();
        format!("{} {}", self.heading, pieces.join(" ` "))
    }

    /// Returns the numbers in the sentences, sorted.
    fn figures(&self) -> Vec<String> {
        let prose = self.prose();
        let words = prose.split(|c: char| c.is_whitespace() || "()/^|;:'".contains(c));
        let mut figures: Vec<String> = words.filter_map(figure).collect();
        figures.sort();
        figures
    }
}

/// Returns the number that a word begins with, without separators of thousands; `None` if it begins with none. Turkish
/// appends its case endings to numbers.
fn figure(word: &str) -> Option<String> {
    let word = word.trim_start_matches(['-', '<', '+']);
    word.chars().next().filter(char::is_ascii_digit)?;
    let of_figure = |c: char| c.is_ascii_digit() || ".,e-".contains(c);
    let end = word.find(|c| !of_figure(c)).unwrap_or(word.len());
    let figure = word[..end].trim_end_matches(['.', ',', 'e', '-']);
    // Two points separate thousands; a single one is a decimal point.
    let parted = if figure.matches('.').count() > 1 {
        &['.', ','][..]
    } else {
        &[',']
    };
    Some(figure.replace(parted, ""))
}

fn sections(text: &str) -> Vec<Section> {
    let mut sections = vec![Section::default()];
    let mut lines = text.lines();
    let mut is_apart = true;
    while let Some(line) = lines.next() {
        // A placeholder for included text.
        if line.starts_with('{') {
            continue;
        }
        if line.starts_with('#') {
            sections.push(Section {
                heading: line.to_owned(),
                ..Section::default()
            });
            is_apart = true;
            continue;
        }
        let section = sections.last_mut().unwrap();
        let inner = line.trim_start();
        if let Some(kind) = inner.strip_prefix("```") {
            let code = lines
                .by_ref()
                .take_while(|line| !line.trim_start().starts_with("```"));
            let code = code.map(|line| line.trim_end().to_owned()).collect();
            section.blocks.push((kind.to_owned(), code));
            is_apart = true;
        } else if line.starts_with("    ") {
            section.commands.push(inner.to_owned());
        } else if inner.starts_with('|') {
            section.rows += 1;
            section.words += &format!("{line} ");
        } else {
            let starts = is_apart || inner.starts_with("- ");
            section.passages += usize::from(starts && !inner.is_empty());
            section.words += &format!("{inner} ");
            is_apart = inner.is_empty();
        }
    }
    sections
}

/// Returns the lines of a TOML file without their comments.
fn uncommented(lines: &[String]) -> Vec<&str> {
    let plain = lines
        .iter()
        .map(|line| line.split('#').next().unwrap_or_default());
    plain.map(str::trim_end).collect()
}

fn parts() -> impl Iterator<Item = (&'static str, [Vec<Section>; 2])> {
    let parts = TOPICS
        .iter()
        .flat_map(|topic| topic.pages.iter().map(|part| (topic.name, part)));
    let languages = [Language::English, Language::Turkish];
    parts.map(move |(name, part)| (name, languages.map(|it| sections(page(it, part)))))
}

#[test]
fn headings_tables_and_code_are_the_same() {
    let mut seen = [0; 4];
    for (name, [english, turkish]) in parts() {
        let levels = |all: &[Section]| all.iter().map(Section::level).collect::<Vec<_>>();
        assert_eq!(levels(&english), levels(&turkish), "{name}");
        for (one, other) in english.iter().zip(&turkish) {
            let place = format!("{name}: {} / {}", one.heading, other.heading);
            assert_eq!(one.passages, other.passages, "{place}");
            assert_eq!(one.rows, other.rows, "{place}");
            assert_eq!(one.commands, other.commands, "{place}");
            assert_eq!(one.blocks.len(), other.blocks.len(), "{place}");
            for ((kind, code), (other_kind, other_code)) in one.blocks.iter().zip(&other.blocks) {
                assert_eq!(kind, other_kind, "{place}");
                // Other blocks are screens. Other tests compare them with the program's output.
                if kind == "toml" {
                    assert_eq!(uncommented(code), uncommented(other_code), "{place}");
                } else {
                    assert_ne!(code, other_code, "{place}");
                }
            }
            let counts = [one.passages, one.rows, one.commands.len(), one.blocks.len()];
            seen = std::array::from_fn(|k| seen[k] + counts[k]);
        }
    }
    assert!(seen.iter().all(|count| *count > 15), "{seen:?}");
}

#[test]
fn what_is_typed_and_every_figure_are_the_same() {
    let mut missing = Vec::new();
    for (name, [english, turkish]) in parts() {
        for (one, other) in english.iter().zip(&turkish) {
            let text = |code: &str| {
                // Elsewhere `at` is a key of scene files, which is the same in all languages.
                let is_key = code == "at" && name != "forces";
                let mut screens = SCREENS.iter().filter(|_| !is_key);
                let of_screen = screens.find(|(english, _)| *english == code);
                of_screen.map_or(code.to_owned(), |(_, turkish)| (*turkish).to_owned())
            };
            let wanted: BTreeSet<String> = one.code().into_iter().map(text).collect();
            let found: BTreeSet<String> = other.code().into_iter().map(str::to_owned).collect();
            let place = format!("{name}: {}", other.heading);
            let odd = wanted.symmetric_difference(&found);
            missing.extend(odd.map(|code| format!("{place}: `{code}`")));
            let (wanted, found) = (one.figures(), other.figures());
            if wanted != found {
                missing.push(format!("{place}:\n{wanted:?}\n{found:?}"));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

#[test]
fn no_english_is_left() {
    for (name, [_, turkish]) in parts() {
        for section in turkish {
            let prose = section.prose().to_lowercase();
            let mut words = prose.split(|c: char| !c.is_alphanumeric());
            let left = words.find(|word| ENGLISH.contains(word));
            assert_eq!(left, None, "{name}: {prose}");
        }
    }
}

/// Checks that the English chapters have the words in `ENGLISH`.
#[test]
fn english_would_be_found() {
    for (name, [english, _]) in parts() {
        let words: usize = english
            .iter()
            .map(|section| {
                let prose = section.prose().to_lowercase();
                let words = prose.split(|c: char| !c.is_alphanumeric());
                words.filter(|word| ENGLISH.contains(word)).count()
            })
            .sum();
        assert!(words > 3, "{name}: {words}");
    }
}

#[test]
fn figures_are_read_however_they_are_written() {
    for (word, read) in [
        ("1,465,129", Some("1465129")),
        ("1.465.129", Some("1465129")),
        ("2.3360e-6", Some("2.3360e-6")),
        ("60,", Some("60")),
        ("40.5deg", Some("40.5")),
        ("<0.01", Some("0.01")),
        ("r3", None),
    ] {
        assert_eq!(figure(word).as_deref(), read, "{word}");
    }
}

#[test]
fn topics_are_asked_for_in_both_languages() {
    for topic in TOPICS {
        let turkish = topic.name_in(Language::Turkish);
        let ascii = with_ascii_letters(turkish);
        for word in [topic.name, turkish, &ascii, &ascii.to_uppercase()] {
            // Both names are accepted in both languages.
            let found = find(word).map(|found| found.name);
            assert_eq!(found, Some(topic.name), "{word}");
        }
        Language::Turkish.speak();
        assert!(topic.description().ends_with(&format!(" ({turkish})")));
        assert_eq!(topic.called(), turkish);
        Language::English.speak();
        assert_eq!(topic.description(), (topic.about)(words()));
    }
    assert!(find("").is_none() && find("sahn").is_none());
}
