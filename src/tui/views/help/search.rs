//! Finds words in the laid-out manual, for any width of the screen.

use super::keys::rows_of;
use super::page::lines_of;
use crate::manual::{ManualLine, SearchWords, TOPICS, joined, plain};
use crate::tui::commands::keymap::Keymap;

/// Returns the page and line of the next passage with these words.
///
/// Searches from a line of a page, then the following pages, and after the last topic from the first one up to the page
/// itself. Pages are counted from 1, lines from 0. Returns `None` if no topic has the words.
pub(super) fn next(
    wanted: &SearchWords,
    (page, line): (usize, usize),
    columns: u16,
    keymap: &Keymap,
) -> Option<(usize, usize)> {
    (0..=TOPICS.len()).find_map(|step| {
        let topic = (page - 1 + step) % TOPICS.len();
        let text = plain(&TOPICS[topic].text(|| rows_of(keymap)));
        // This test is faster than the layout.
        if !wanted.are_in(&[&text]) {
            return None;
        }
        let lines = lines_of(&TOPICS[topic], columns, keymap);
        let from = if step == 0 { line } else { 0 };
        let found = (from..lines.len()).find(|&line| starts_passage(wanted, &lines[line..]));
        found.map(|line| (topic + 1, line))
    })
}

/// Returns `true` if a passage with all words begins in the first of these lines, and not only in a later one.
fn starts_passage(wanted: &SearchWords, lines: &[ManualLine]) -> bool {
    let going_on = lines.iter().skip(1).take_while(|line| line.continues);
    let has_all = |lines: &[ManualLine]| wanted.are_in(&[&joined(lines)]);
    let passages = (1..=going_on.count() + 1).map(|length| &lines[..length]);
    let shortest = passages.into_iter().find(|passage| has_all(passage));
    shortest.is_some_and(|passage| !has_all(&passage[1..]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manual::{folded, lines};
    use crate::tui::commands::line::EditLine;
    use crate::wording::Language;

    /// Returns every line at which a passage with the words begins.
    fn found(wanted: &str, text: &str, width: usize) -> Vec<usize> {
        let wanted = SearchWords::new(wanted);
        let lines = lines(text, width).into_iter();
        let lines: Vec<_> = lines.flat_map(|line| folded(line, width)).collect();
        (0..lines.len())
            .filter(|&line| starts_passage(&wanted, &lines[line..]))
            .collect()
    }

    /// Regression: the search matched single lines, so results depended on the line breaks.
    #[test]
    fn search_matches_words_across_lines_of_paragraph() {
        let text = "one two three four five six seven eight\nnine ten one\n\neleven\n";
        assert_eq!(found("six seven", text, 30), [0]);
        assert_eq!(found("seven six", text, 30), [0]);
        assert_eq!(found("one", text, 30), [0, 1]);
        assert_eq!(found("one nine", text, 30), [1]);
        assert!(found("ten eleven", text, 30).is_empty());
    }

    #[test]
    fn search_matches_folded_words_in_code() {
        let long = format!("```\n{}.needle{}\n```\n", "a".repeat(26), "b".repeat(20));
        assert_eq!(found("needle", &long, 30), [0]);
        let blank = format!("```\n{} needle\n```\n", "a".repeat(27));
        assert_eq!(found("needle", &blank, 30), [1]);
        assert!(found("aneedle", &blank, 30).is_empty());
    }

    /// Words of Turkish topics are found with or without diacritics. Regression: the input line
    /// dropped Turkish letters.
    #[test]
    fn search_folds_turkish_letters() {
        Language::Turkish.speak();
        let keymap = Keymap::default();
        for typed in ["ölü konum", "olu konum", "Ölü KONUM"] {
            let mut line = EditLine::for_words();
            typed.chars().for_each(|c| line.push(c));
            let query = SearchWords::new(line.text());
            assert!(next(&query, (1, 0), 80, &keymap).is_some(), "{typed}");
        }
        let query = SearchWords::new("pipe ends quietly");
        assert_eq!(next(&query, (1, 0), 80, &keymap), None);
        Language::English.speak();
        assert!(next(&query, (1, 0), 80, &keymap).is_some());
    }

    /// Words within a paragraph are found at every width, in the same topic.
    #[test]
    fn search_result_does_not_depend_on_width() {
        let keymap = Keymap::default();
        for words in ["structure alone decides", "closed pipe ends quietly"] {
            let query = SearchWords::new(words);
            let topic = |columns| next(&query, (1, 0), columns, &keymap).map(|(page, _)| page);
            assert!(topic(200).is_some(), "{words}");
            for columns in 40..110 {
                assert_eq!(topic(columns), topic(200), "{words} at {columns}");
            }
        }
    }
}
