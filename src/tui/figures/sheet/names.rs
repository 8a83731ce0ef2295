//! Shortens the names of rows for small screens.

use std::collections::HashMap;

/// Maximum length of a name; longer ones would push the values off a small screen.
const MAX_NAME_LEN: usize = 9;
/// The mark in place of cut characters.
const CUT: char = '~';

/// Shortens names to the maximum length and keeps different ones different. A name is cut behind
/// its beginning; if that is not unique, around its first part that occurs in no other name.
pub(super) fn short_names(names: &[&str]) -> Vec<String> {
    const HEAD: usize = MAX_NAME_LEN - 1;
    const INNER: usize = MAX_NAME_LEN - 2;
    let mut headers = HashMap::new();
    let mut parts = HashMap::new();
    for name in names {
        *headers.entry(name.get(..HEAD)).or_insert(0) += 1;
        for at in 0..name.len() {
            *parts.entry(name.get(at..at + INNER)).or_insert(0) += 1;
        }
    }
    let short = |name: &&str| -> String {
        // Names in scenes are ASCII, so a byte is a character.
        if name.len() <= MAX_NAME_LEN || !name.is_ascii() {
            return name.chars().take(MAX_NAME_LEN).collect();
        }
        let last = name.len() - INNER;
        if headers[&name.get(..HEAD)] == 1 {
            return format!("{}{CUT}", &name[..HEAD]);
        }
        let different = |at: &usize| parts[&name.get(*at..at + INNER)] == 1;
        // Whole words are easiest to recognize.
        let words = (1..=last).filter(|&at| !name.as_bytes()[at - 1].is_ascii_alphanumeric());
        match words.chain(1..=last).find(different) {
            Some(at) if at < last => format!("{CUT}{}{CUT}", &name[at..at + INNER]),
            _ => format!("{CUT}{}", &name[name.len() - HEAD..]),
        }
    };
    names.iter().map(short).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shortened_names_stay_distinct() {
        let short = short_names(&[
            "r2",
            "upper_rod",
            "connecting_rod",
            "crank_pin_upper",
            "crank_pin_lower",
            "driving_crank_of_the_press",
            "driving_rod_of_the_press",
        ]);
        let expected = [
            "r2",
            "upper_rod",
            "connecti~",
            "~pin_upp~",
            "~pin_low~",
            "~crank_o~",
            "~rod_of_~",
        ];
        assert_eq!(short, expected);
        // A name that is a prefix of another cannot be distinguished by its own letters; the longer
        // one is.
        let nested = short_names(&["crank_pin_upper", "crank_pin_upper_2"]);
        assert_eq!(nested, ["~in_upper", "~_upper_2"]);
    }
}
