//! Searches the topics for words.

use super::layout::{ManualLine, lines, plain};
use super::{TOPICS, Topic, spelled};
use std::cmp::Reverse;

/// Maximum number of topics that the workbench names.
#[cfg(feature = "tui")]
const MAX_BEST: usize = 3;

/// A topic that has the words of a search.
#[derive(Debug)]
pub(crate) struct FoundTopic {
    pub(crate) topic: &'static Topic,
    /// One line for each place with the words.
    pub(crate) lines: Vec<String>,
}

/// Words to search for. Case does not matter, and Turkish letters match the ASCII letters that they look like.
#[derive(Debug)]
pub(crate) struct SearchWords(Vec<String>);

impl SearchWords {
    /// Splits a text into its words.
    pub(crate) fn new(text: &str) -> SearchWords {
        let text = spelled(text);
        SearchWords(text.split_whitespace().map(str::to_owned).collect())
    }

    /// Returns `true` if each of the words starts a word of one of the texts.
    pub(crate) fn are_in(&self, texts: &[&str]) -> bool {
        let texts: Vec<String> = texts.iter().map(|text| spelled(text)).collect();
        let is_in = |word: &String| texts.iter().any(|text| has_word(text, word));
        !self.0.is_empty() && self.0.iter().all(is_in)
    }

    /// Returns the topics that have the words in one paragraph, table row or line of code, each with a line of every
    /// such place. A topic whose name has the words comes first, then topics with more places.
    pub(crate) fn in_topics(&self, width: usize) -> Vec<FoundTopic> {
        let found = TOPICS.iter().map(|topic| FoundTopic {
            topic,
            lines: self.lines_in(topic, width),
        });
        let mut found: Vec<FoundTopic> = found.filter(|found| !found.lines.is_empty()).collect();
        found.sort_by_key(|FoundTopic { topic, lines }| {
            (!self.are_in(&[topic.called()]), Reverse(lines.len()))
        });
        found
    }

    /// Returns the indices in [`TOPICS`] of the best topics, at most [`MAX_BEST`].
    #[cfg(feature = "tui")]
    pub(crate) fn best_topics(&self) -> Vec<usize> {
        let found = self.in_topics(usize::MAX).into_iter().take(MAX_BEST);
        let place = |name: &str| TOPICS.iter().position(|topic| topic.name == name);
        found.filter_map(|it| place(it.topic.name)).collect()
    }

    fn lines_in(&self, topic: &Topic, width: usize) -> Vec<String> {
        let text = topic.text(String::new);
        // This test is faster than the layout.
        if !self.are_in(&[&plain(&text)]) {
            return Vec::new();
        }
        let lines = lines(&text, width);
        let places = lines.chunk_by(|_, next| next.continues);
        places.filter_map(|place| self.line_of(place)).collect()
    }

    /// Returns the line of a place that has the first of the words, if the place has all of them.
    fn line_of(&self, place: &[ManualLine]) -> Option<String> {
        let texts: Vec<&str> = place.iter().map(|line| line.text.trim()).collect();
        if !self.are_in(&[&texts.join(" ")]) {
            return None;
        }
        let first = self.0.first()?;
        let line = texts.iter().find(|text| has_word(&spelled(text), first));
        line.or(texts.first()).map(|text| (*text).to_owned())
    }
}

/// Returns `true` if a word of the text starts with these characters, or if they start with a sign such as `+` and
/// occur anywhere. Both are spelled in ASCII.
fn has_word(text: &str, start: &str) -> bool {
    let is_sign = !start.starts_with(char::is_alphanumeric);
    let mut places = text.match_indices(start);
    places.any(|(at, _)| is_sign || !text[..at].ends_with(char::is_alphanumeric))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_match_at_their_start_in_any_case_and_spelling() {
        let has = |words: &str, text: &str| SearchWords::new(words).are_in(&[text]);
        assert!(has("stroke", "the Strokes of `C.x.stroke`"));
        assert!(has("DÖNGÜ", "iki döngü") && has("dongu", "iki döngü"));
        assert!(has("ratio time", "the time ratio") && !has("ratio angle", "the time ratio"));
        assert!(has("bounds", "`--bounds`") && has("--bounds", "`--bounds`"));
        assert!(!has("ram", "parameters and programs") && !has(" ", "a text"));
        assert!(has("+s", "Ctrl+S") && !has("s", "keys"));
    }

    /// `krank help WORD`, the list of commands and the overlay name the same topics.
    #[test]
    fn a_topic_named_by_the_words_comes_first() {
        for (typed, name) in [
            ("limit", "limits"),
            ("toler", "tolerances"),
            ("synth", "synthesis"),
        ] {
            let found = SearchWords::new(typed).in_topics(80);
            assert_eq!(found[0].topic.name, name);
            let others = found[1..].windows(2);
            assert!(
                others
                    .into_iter()
                    .all(|pair| pair[0].lines.len() >= pair[1].lines.len())
            );
        }
    }

    #[test]
    fn each_place_is_found_once_and_across_line_breaks() {
        let line = |text: &str, continues| ManualLine {
            kind: crate::manual::LineKind::Words,
            text: text.to_owned(),
            continues,
        };
        let place = [
            line("slow", false),
            line("  a time", true),
            line("ratio time", true),
        ];
        let found = |words: &str| SearchWords::new(words).line_of(&place);
        assert_eq!(found("time ratio").as_deref(), Some("a time"));
        assert_eq!(found("time dwell"), None);
    }
}
