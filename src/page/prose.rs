//! Splits paragraphs into pieces, for writers that typeset code, rates, powers and names
//! differently.

use super::math::UNIT;

/// A piece of a paragraph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ProsePiece<'t> {
    /// Words with their blanks.
    Words(&'t str),
    /// Text between backticks.
    Typed(&'t str),
    /// A rate, a term with a power, or a symbol.
    Formula(&'t str),
    /// A unit with a power.
    Unit(&'t str),
}

/// Returns `true` if a text contains a rate or a power, which formulas typeset differently.
pub(super) fn is_spelled(text: &str) -> bool {
    text.contains("/dt") || text.contains('^')
}

/// Marks the unit in the brackets behind the name of a row or column.
pub(super) fn with_marked_unit(text: &str) -> String {
    match text.rsplit_once(" [") {
        Some((name, unit)) if unit.ends_with(']') => format!("{name} [{UNIT}{unit}"),
        _ => text.to_owned(),
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
pub(super) fn is_symbol(word: &str, symbols: &[String]) -> bool {
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
        let is_measured = std::mem::replace(&mut is_behind_number, is_number(word));
        let is_unit = word.starts_with(UNIT) || is_measured && is_unit(word);
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
        let around = [&part[..opened], &part[end..]].map(ProsePiece::Words);
        let [before, after] = around;
        let set = match is_unit {
            true => ProsePiece::Unit(word),
            false => ProsePiece::Formula(word),
        };
        let shown_text = [before, set, after].into_iter();
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
            ProsePiece::Formula("dr4/dt"),
            ProsePiece::Words(": "),
            ProsePiece::Words("d"),
        ];
        assert_eq!(taken, expected);
        assert_eq!(pieces("a ` b", &[]).len(), 3);
    }

    #[test]
    fn names_are_symbols_but_articles_are_words() {
        let names = ["s", "r2", "a"].map(str::to_owned);
        let symbols = |text: &'static str| -> Vec<&str> {
            let of = |piece| match piece {
                ProsePiece::Formula(word) => Some(word),
                ProsePiece::Words(_) | ProsePiece::Typed(_) | ProsePiece::Unit(_) => None,
            };
            pieces(text, &names).into_iter().filter_map(of).collect()
        };
        assert_eq!(
            symbols("a loop: r2 + s (θ3, s), `s`, is μ(θ)."),
            ["r2", "s", "θ3", "s", "μ(θ)"]
        );
        // After a number, `s` is the unit second.
        assert_eq!(symbols("after 2 s, 9.81 m/s^2, s is"), ["s"]);
        assert_eq!(symbols("r2'nin boyu, s'dir"), ["r2", "s"]);
    }
}
