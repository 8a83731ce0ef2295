//! Suggests the known word closest to a mistyped one.

use crate::wording::words;

/// Maximum length of a text to compare. A longer one is not a typing error, and the cost is the
/// product of the lengths.
const MAX_LEN: usize = 64;

/// Returns the known word closest to a text, if it is similar enough. A difference in case or in a
/// plural `s` counts as distance zero: `load` means `loads`, not `lead`.
pub fn nearest<'k>(text: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    if text.len() > MAX_LEN {
        return None;
    }
    let allowed = 1 + text.chars().count() / 4;
    let distance = |word: &str| {
        if singular(word).eq_ignore_ascii_case(singular(text)) {
            0
        } else {
            strsim::osa_distance(text, word)
        }
    };
    known
        .into_iter()
        .filter(|word| word.len().abs_diff(text.len()) <= allowed)
        .map(|word| (distance(word), word))
        // For a name of one letter, every other letter is one edit away.
        .filter(|&(d, word)| d <= allowed && d < text.len().max(word.len()))
        .min_by_key(|&(d, _)| d)
        .map(|(_, word)| word)
}

fn singular(word: &str) -> &str {
    match word.strip_suffix('s') {
        Some(stem) if stem.len() > 2 => stem,
        _ => word,
    }
}

/// Returns "did you mean ...?" if a known word is similar enough.
pub fn did_you_mean<'k>(text: &str, known: impl IntoIterator<Item = &'k str>) -> Option<String> {
    nearest(text, known).map(|word| words().did_you_mean(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_finds_typos_but_not_other_words() {
        let known = ["A.x", "C.x", "r3.omega"];
        assert_eq!(nearest("r3.omgea", known), Some("r3.omega"));
        assert_eq!(nearest("r3.alpha", known), None);
        assert_eq!(nearest("", known), None);
        assert_eq!(nearest("Q", ["A"]), None);
        assert_eq!(nearest(&"r".repeat(1000), known), None);
    }

    #[test]
    fn nearest_prefers_word_differing_only_in_case_or_number() {
        assert_eq!(nearest("c.x", ["A.x", "C.x"]), Some("C.x"));
        assert_eq!(nearest("load", ["lead", "loads"]), Some("loads"));
    }
}
