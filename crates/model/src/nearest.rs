//! Which known word a mistyped one was probably meant to be.

use crate::wording::words;

/// Characters of a text beyond which it is no slip of the pen: comparing costs the product of the
/// lengths.
const LONGEST: usize = 64;

/// The known word nearest to a text, if it is near enough to have been meant; one that differs only
/// in case is as near as can be.
pub fn nearest<'k>(text: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    if text.len() > LONGEST {
        return None;
    }
    let allowed = 1 + text.chars().count() / 4;
    let distance = |word: &str| {
        if word.eq_ignore_ascii_case(text) {
            0
        } else {
            strsim::osa_distance(text, word)
        }
    };
    known
        .into_iter()
        .filter(|word| word.len().abs_diff(text.len()) <= allowed)
        .map(|word| (distance(word), word))
        // In a name of one letter every other letter is one slip away.
        .filter(|&(d, word)| d <= allowed && d < text.len().max(word.len()))
        .min_by_key(|&(d, _)| d)
        .map(|(_, word)| word)
}

/// "did you mean ...?", if something is near.
pub fn did_you_mean<'k>(text: &str, known: impl IntoIterator<Item = &'k str>) -> Option<String> {
    nearest(text, known).map(|word| words().did_you_mean(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_found_and_another_word_is_not() {
        let known = ["A.x", "C.x", "r3.omega"];
        assert_eq!(nearest("r3.omgea", known), Some("r3.omega"));
        assert_eq!(nearest("r3.alpha", known), None);
        assert_eq!(nearest("", known), None);
        assert_eq!(nearest("Q", ["A"]), None);
        assert_eq!(nearest(&"r".repeat(1000), known), None);
    }

    #[test]
    fn a_word_in_another_case_is_the_nearest() {
        assert_eq!(nearest("c.x", ["A.x", "C.x"]), Some("C.x"));
    }
}
