//! Defines all spellings of units.
//!
//! Formulas, scenes, prompts and answer files all read units through this table.

use std::borrow::Cow;

/// The units that can follow numbers in formulas.
pub(crate) const UNITS: [&str; 9] = ["mm", "cm", "m", "in", "deg", "rad", "s", "kg", "N"];

/// Other spellings of these units, Turkish and English, each with the unit's name.
const SPELLINGS: [(&str, &str); 13] = [
    ("derece", "deg"),
    ("der", "deg"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("°", "deg"),
    ("º", "deg"),
    ("˚", "deg"),
    ("radyan", "rad"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("rd", "rad"),
    ("sn", "s"),
    ("saniye", "s"),
];

/// Revolutions per minute, not available in formulas.
const RPM: &str = "rpm";
const RPM_SPELLINGS: [&str; 9] = [
    "d/dk",
    "d/dak",
    "d/d",
    "dev/dk",
    "dev/dak",
    "devir/dk",
    "devir/dakika",
    "rev/min",
    "r/min",
];

/// Returns `true` if a character can occur in the name of a unit.
pub(super) fn is_of_unit(c: char) -> bool {
    c.is_alphabetic() || matches!(c, '°' | '˚')
}

/// Returns the name of the unit for a word of a formula.
pub(super) fn unit_named(word: &str) -> Option<&'static str> {
    let own = UNITS.into_iter().find(|unit| *unit == word);
    own.or_else(|| spelled(word))
}

/// Returns `true` if a word following a number is read as a unit.
pub(crate) fn is_unit(word: &str) -> bool {
    unit_named(word).is_some()
}

/// Returns the spelling of a unit that krank uses: `rad/s^2` for `rd/sn²`, `rpm` for `d/dk`.
/// Unknown words are returned unchanged.
pub fn plain_unit(text: &str) -> Cow<'_, str> {
    let text = text.trim();
    let lower = text.to_lowercase();
    let joined: String = lower.chars().filter(|c| !c.is_whitespace()).collect();
    if joined == RPM || RPM_SPELLINGS.contains(&joined.as_str()) {
        return RPM.into();
    }
    let mut plain = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = rest.find(|c| !is_of_unit(c)).unwrap_or(rest.len());
        let (word, after) = rest.split_at(length.max(first.len_utf8()));
        match (length, first) {
            (1.., _) => {
                let is_divisor = plain.trim_end().ends_with('/');
                plain.push_str(any_case(word, is_divisor));
                // `s2` means `s^2`.
                if after.starts_with(|c: char| c.is_ascii_digit()) {
                    plain.push('^');
                }
            }
            (_, '²') => plain.push_str("^2"),
            (_, '³') => plain.push_str("^3"),
            (_, '·') if !plain.is_empty() => plain.push(' '),
            _ => plain.push_str(word),
        }
        rest = after;
    }
    let parts: Vec<&str> = plain.split('/').map(str::trim).collect();
    parts.join("/").into()
}

/// Returns the name of the unit for a word, or the word itself if it is no unit. Case matters for
/// single letters, except in a divisor.
fn any_case(word: &str, is_divisor: bool) -> &str {
    let is_free = is_divisor || word.chars().count() > 1;
    let lower = || unit_named(&word.to_lowercase()).filter(|_| is_free);
    unit_named(word).or_else(lower).unwrap_or(word)
}

fn spelled(word: &str) -> Option<&'static str> {
    let mut spellings = SPELLINGS.iter();
    let found = spellings.find(|(spelling, _)| *spelling == word);
    found.map(|(_, unit)| *unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_unit_normalizes_spellings() {
        for (text, unit) in [
            ("derece", "deg"),
            ("Derece", "deg"),
            ("der", "deg"),
            ("°", "deg"),
            ("º", "deg"),
            ("radyan", "rad"),
            ("RAD/S", "rad/s"),
            ("rd/s", "rad/s"),
            ("rad/sn", "rad/s"),
            ("rad / saniye", "rad/s"),
            ("derece/sn", "deg/s"),
            ("°/s", "deg/s"),
            ("d/dk", "rpm"),
            ("dev/dk", "rpm"),
            ("Devir / dakika", "rpm"),
            ("RPM", "rpm"),
            ("mm/sn", "mm/s"),
            ("mm/sn2", "mm/s^2"),
            ("rd/sn²", "rad/s^2"),
            ("cm/s2", "cm/s^2"),
            ("mm/sn^2", "mm/s^2"),
            ("N·m", "N m"),
            ("kg m^2", "kg m^2"),
            ("N m/rad", "N m/rad"),
            ("furlong/s", "furlong/s"),
            ("%", "%"),
            ("*", "*"),
            ("·", "·"),
            ("MM/S²", "mm/s^2"),
            ("", ""),
        ] {
            assert_eq!(plain_unit(text), unit, "{text}");
        }
    }

    #[test]
    fn every_spelling_maps_to_a_known_unit() {
        assert_eq!(unit_named("°"), Some("deg"));
        assert_eq!(unit_named("N"), Some("N"));
        for other in ["n", "S", "rpm", "dk", "ds", "derecelik", ""] {
            assert_eq!(unit_named(other), None, "{other}");
        }
        for (spelling, unit) in SPELLINGS {
            assert!(UNITS.contains(&unit), "{spelling}");
            assert!(spelling.chars().all(is_of_unit), "{spelling}");
        }
    }
}
