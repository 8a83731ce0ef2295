//! Tests that each topic is plain text, complete and equal in all languages.

mod languages;

use super::*;

/// Widths of the workbench's narrowest screen, of a usual terminal and of a wide one.
const WIDTHS: [usize; 3] = [40, 80, 100];

/// Returns the name and text of each topic in each language.
fn texts() -> Vec<(String, String)> {
    let texts = Language::ALL.into_iter().flat_map(|language| {
        language.speak();
        let named = |topic: &Topic| format!("{} in {language:?}", topic.name);
        let texts = TOPICS
            .iter()
            .map(|topic| (named(topic), topic.text(String::new)));
        texts.collect::<Vec<_>>()
    });
    texts.collect()
}

#[test]
fn every_language_has_all_pages_and_names() {
    for language in Language::ALL {
        for topic in TOPICS {
            let is_there = |name: &&str| !page(language, name).is_empty();
            assert!(topic.pages.iter().all(is_there), "{language:?}: {topic:?}");
            assert!(!topic.name_in(language).is_empty(), "{topic:?}");
        }
        let count = |language: Language| language.words().names_of_topics().split(' ').count();
        assert_eq!(count(language), count(Language::English), "{language:?}");
    }
    let english = Language::English.words().names_of_topics();
    let is_listed = |topic: &Topic| english.split(' ').any(|name| name == topic.name);
    assert!(TOPICS.iter().all(is_listed));
}

/// Topics are read where the locale has nothing else, and their Markdown is what is understood here.
#[test]
fn topics_are_plain() {
    for (name, text) in texts() {
        assert!(with_ascii_letters(&text).is_ascii(), "{name}");
        assert!(text.starts_with("# "), "{name}");
        let is_filled = !text.contains(KEYS) && !text.contains(SCENE_KEYS);
        assert!(is_filled, "{name}");
        for foreign in ["](", "<br", "\t", "\n1. "] {
            assert!(!text.contains(foreign), "{name}: {foreign}");
        }
    }
}

/// Returns the words of a text, sorted because tables change their order. Rules of tables, fences and
/// marks of headings do not count as words.
fn words(text: &str) -> Vec<String> {
    let pieces = text.split(|c: char| c.is_whitespace() || c == '|');
    let plain = pieces.map(|word| word.replace("**", "").trim_matches(['#', ':']).to_owned());
    let is_word = |word: &String| !word.chars().all(|c| c == '-') && !word.starts_with("```");
    let mut words: Vec<String> = plain.filter(is_word).collect();
    words.sort();
    words
}

/// Returns the words in the heads of tables.
fn heads(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let headers = lines.windows(2).filter(|pair| pair[1].starts_with("|---"));
    headers.flat_map(|pair| words(pair[0])).collect()
}

/// What a formula may call is told of where formulas are, all of it.
#[test]
fn every_function_is_told_of() {
    for language in Language::ALL {
        language.speak();
        let text = find("scene").unwrap().text(String::new);
        let words: Vec<&str> = text.split(|c: char| !c.is_ascii_alphanumeric()).collect();
        for function in crate::expression::functions() {
            assert!(words.contains(&function), "{function} in {language:?}");
        }
    }
}

/// The topics that the last column of the questions names.
#[cfg(feature = "tui")]
#[test]
fn questions_lead_to_topics() {
    for language in Language::ALL {
        language.speak();
        let text = find("how").unwrap().text(String::new);
        let rows = text.lines().filter(|line| line.contains("? | "));
        let mut questions = 0;
        for row in rows {
            let cell = row.trim_end_matches(" |").rsplit("| ").next().unwrap();
            let topic = cell.trim_matches('`');
            assert!(find(topic).is_some(), "{row}");
            questions += 1;
        }
        assert!(questions >= 30, "{language:?}: {questions}");
    }
}

/// Every word of a topic is shown at every width.
#[test]
fn no_word_is_lost() {
    for (name, text) in texts() {
        for width in WIDTHS {
            let shown: Vec<String> = lines(&text, width).into_iter().map(|l| l.text).collect();
            let mut shown = words(&shown.join("\n"));
            // The head of a column may be repeated at each of its cells, or omitted.
            let headers = heads(&text);
            let mut lost = words(&text);
            lost.retain(|word| match shown.binary_search(word) {
                Ok(i) => {
                    shown.remove(i);
                    false
                }
                Err(_) => true,
            });
            lost.retain(|word| !headers.contains(word));
            assert!(lost.is_empty(), "{name} at {width}: {lost:?}");
        }
    }
}

/// Only what is written as it stands, a screen or a file, may be wider than the terminal.
#[test]
fn lines_keep_to_the_width() {
    for (name, text) in texts() {
        for width in WIDTHS {
            for line in lines(&text, width) {
                let length = line.text.chars().count();
                let fits = length <= width || line.kind == LineKind::Code;
                assert!(fits, "{name} at {width}: {}", line.text);
            }
        }
    }
}
