//! Splits sentences and labels into pieces, for writers that typeset code, rates, powers and names
//! differently.

use super::math::{Formula, Symbol};

/// A piece of a paragraph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum ProsePiece<'t> {
    /// Words with their blanks.
    Words(&'t str),
    /// Text between backticks.
    Typed(&'t str),
    /// A rate, a symbol, or a number or unit with a power.
    Formula(Formula),
}

/// Returns `true` if a text contains a rate or a power, which formulas typeset differently.
fn is_spelled(text: &str) -> bool {
    text.contains("/dt") || text.contains('^')
}

/// Returns the name of a row or column, with the unit behind it, as a formula, if it is a symbol or
/// a rate.
pub(super) fn label(text: &str, symbols: &[String]) -> Option<Formula> {
    if !is_spelled(text) && !is_symbol(text, symbols) {
        return None;
    }
    Some(match text.rsplit_once(" [") {
        Some((name, unit)) if unit.ends_with(']') => {
            let unit = Formula::words(unit.trim_end_matches(']')).between(['[', ']']);
            words(name).blank().then(unit)
        }
        _ => words(text),
    })
}

/// Returns words as a formula.
fn words(text: &str) -> Formula {
    let words = text
        .split(' ')
        .map(word)
        .reduce(|text, word| text.blank().then(word));
    words.unwrap_or_default()
}

/// Returns a word of a sentence as a formula: `r3`, `dr3/dt`, `μ(θ3)`, `100^2`.
fn word(text: &str) -> Formula {
    let rate = |before, after| text.strip_prefix(before)?.strip_suffix(after);
    if let Some((base, exponent)) = text.rsplit_once('^') {
        return word(base).power(exponent);
    }
    if let Some((function, (of, rest))) = text
        .split_once('(')
        .and_then(|(function, rest)| Some((function, rest.split_once(')')?)))
    {
        return word(function)
            .then(word(of).in_brackets())
            .then(Formula::words(rest));
    }
    match (rate("d2", "/dt2"), rate("d", "/dt")) {
        (Some(name), _) => Symbol::named(name).derivative(2).into(),
        (_, Some(name)) => Symbol::named(name).derivative(1).into(),
        _ if is_number(text) => Formula::number(text),
        _ => text.into(),
    }
}

/// The units that can follow a number in a sentence.
const UNITS: [&str; 13] = [
    "mm", "cm", "m", "in", "s", "rad", "deg", "N", "kg", "W", "J", "rpm", "min",
];

/// Words of both languages that can also be names; within a sentence they count as words.
const WORDS: [&str; 4] = ["a", "A", "I", "o"];

/// Returns `true` if a word of a sentence is a symbol: one of these names, or a word that begins
/// with a Greek letter.
fn is_symbol(word: &str, symbols: &[String]) -> bool {
    let is_greek = word.starts_with(['θ', 'ω', 'α', 'β', 'γ', 'μ', 'ν']);
    is_greek || symbols.iter().any(|name| name == word) && !WORDS.contains(&word)
}

/// Splits a paragraph into pieces, with these names as symbols. An unpaired backtick stays a
/// backtick.
pub(super) fn pieces<'t>(text: &'t str, symbols: &[String]) -> Vec<ProsePiece<'t>> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some((before, typed, after)) = between_backticks(rest) {
        push_words(before, symbols, &mut pieces);
        pieces.push(ProsePiece::Typed(typed));
        rest = after;
    }
    push_words(rest, symbols, &mut pieces);
    pieces
}

fn between_backticks(text: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = text.split_once('`')?;
    let (typed, after) = rest.split_once('`')?;
    Some((before, typed, after))
}

fn is_number(word: &str) -> bool {
    word.trim_start_matches(['-', '+'])
        .starts_with(|c: char| c.is_ascii_digit())
}

/// Returns `true` if a word consists of units only: `mm`, `rad/s^2`.
fn is_unit(word: &str) -> bool {
    let mut parts = word
        .split(['/', '^', '2', '3'])
        .filter(|part| !part.is_empty());
    parts.all(|part| UNITS.contains(&part))
}

fn push_words<'t>(text: &'t str, symbols: &[String], pieces: &mut Vec<ProsePiece<'t>>) {
    let mut is_behind_number = false;
    for part in text.split_inclusive(' ') {
        let opened = part.len() - part.trim_start_matches('(').len();
        let word = part[opened..].trim_end_matches([' ', ',', ';', ':', '.']);
        let word = match word.contains('(') {
            true => word,
            false => word.trim_end_matches(')'),
        };
        let is_unit = is_unit(word) && (is_behind_number || word.contains('/'));
        // A further unit can follow a unit: `N m`.
        let is_followed = part[opened + word.len()..] == *" ";
        is_behind_number = is_number(word) || is_unit && is_followed;
        // A Turkish suffix follows an apostrophe.
        let stem = match word.rsplit_once('\'') {
            Some((stem, end)) if !end.is_empty() && is_symbol(stem, symbols) => stem,
            _ => word,
        };
        if !is_spelled(word) && (is_unit || !is_symbol(stem, symbols)) {
            pieces.push(ProsePiece::Words(part));
            continue;
        }
        let word = if is_spelled(word) { word } else { stem };
        let end = opened + word.len();
        let [before, after] = [&part[..opened], &part[end..]].map(ProsePiece::Words);
        let formula = match is_unit {
            true => Formula::words(word),
            false => self::word(word),
        };
        let shown_text = [before, ProsePiece::Formula(formula), after].into_iter();
        pieces.extend(shown_text.filter(|piece| *piece != ProsePiece::Words("")));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prose_splits_into_words_formulas_and_literals() {
        let taken = pieces("a `b c` dr4/dt: d", &[]);
        let expected = [
            ProsePiece::Words("a "),
            ProsePiece::Typed("b c"),
            ProsePiece::Words(" "),
            ProsePiece::Formula(Symbol::named("r4").derivative(1).into()),
            ProsePiece::Words(": "),
            ProsePiece::Words("d"),
        ];
        assert_eq!(taken, expected);
        assert_eq!(pieces("a ` b", &[]).len(), 3);
    }

    #[test]
    fn names_are_symbols_but_articles_are_words() {
        let names = ["s", "r2", "a"].map(str::to_owned);
        let symbols = |text: &'static str| -> Vec<String> {
            let of = |piece| match piece {
                ProsePiece::Formula(word) => Some(word.to_string()),
                ProsePiece::Words(_) | ProsePiece::Typed(_) => None,
            };
            pieces(text, &names).into_iter().filter_map(of).collect()
        };
        assert_eq!(
            symbols("a loop: r2 + s (θ3, s), `s`, is μ(θ)."),
            ["r2", "s", "θ3", "s", "μ(θ)"]
        );
        // After a number, `s` is the unit second.
        assert_eq!(symbols("after 2 s, 9.81 m/s^2, s is"), ["m/s^2", "s"]);
        assert_eq!(symbols("r2'nin boyu, s'dir"), ["r2", "s"]);
    }
}
