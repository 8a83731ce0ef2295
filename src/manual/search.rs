//! Searches the topics for words.

use super::layout::{ManualLine, lines};
use super::{TOPICS, Topic, spelled};
use std::cmp::Reverse;

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
    /// such place. Topics with more places come first.
    pub(crate) fn in_topics(&self, width: usize) -> Vec<(&'static Topic, Vec<String>)> {
        let found = TOPICS.iter().map(|topic| (topic, self.found(topic, width)));
        let mut found: Vec<_> = found.filter(|(_, lines)| !lines.is_empty()).collect();
        found.sort_by_key(|(_, lines)| Reverse(lines.len()));
        found
    }

    fn found(&self, topic: &Topic, width: usize) -> Vec<String> {
        let lines = lines(&topic.text(String::new), width);
        let places = lines.chunk_by(|_, next| next.goes_on);
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

/// Returns `true` if a word of the text starts with these letters; both are spelled in ASCII.
fn has_word(text: &str, start: &str) -> bool {
    let mut places = text.match_indices(start);
    places.any(|(at, _)| !text[..at].ends_with(char::is_alphanumeric))
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
    }

    #[test]
    fn each_place_is_found_once_and_across_line_breaks() {
        let line = |text: &str, goes_on| ManualLine {
            kind: crate::manual::LineKind::Words,
            text: text.to_owned(),
            goes_on,
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
