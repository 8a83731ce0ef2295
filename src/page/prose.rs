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

/// Returns a word of a sentence as a formula: `r3`, `dr3/dt`, `μ(θ3)`, `100^2`, `1/r3^2`.
fn word(text: &str) -> Formula {
    let mut formula = Formula::default();
    let mut rest = text;
    let mut is_raised = false;
    while let Some(c) = rest.chars().next() {
        let (piece, size) = if let Some((rate, size)) = rate(rest) {
            (rate.into(), size)
        } else if c.is_ascii_digit() {
            let size = number_size(rest);
            (Formula::number(&rest[..size]), size)
        } else if c.is_alphabetic() {
            let size = name_size(rest);
            (rest[..size].into(), size)
        } else if let Some(exponent) = rest
            .strip_prefix('^')
            .filter(|_| !is_raised)
            .and_then(exponent)
        {
            (Formula::default().power(exponent), 1 + exponent.len())
        } else if is_suffix(rest) {
            let end = rest[1..].find(|c: char| !c.is_alphabetic());
            let size = end.map_or(rest.len(), |end| 1 + end);
            (Formula::words(&rest[..size]), size)
        } else if rest.starts_with("+-") {
            (Formula::sign('±'), 2)
        } else {
            (Formula::sign(c), c.len_utf8())
        };
        // An exponent has no exponent.
        is_raised = c == '^' && size > 1;
        formula = formula.then(piece);
        rest = &rest[size..];
    }
    formula
}

/// Returns the rate at the beginning of a text, `dr3/dt` or `d2r3/dt2`, with its length.
fn rate(text: &str) -> Option<(Symbol, usize)> {
    let size = name_size(text);
    let (name, rest) = text.split_at(size);
    let of = |order, before, after: &str| {
        let name = name.strip_prefix(before)?;
        let end = rest.strip_prefix(after)?;
        let is_rate = !name.is_empty() && !end.starts_with(char::is_alphanumeric);
        is_rate.then(|| (Symbol::named(name).derivative(order), size + after.len()))
    };
    of(2, "d2", "/dt2").or_else(|| of(1, "d", "/dt"))
}

/// Returns the length of the name at the beginning of a text. A `-` between letters or digits
/// belongs to it.
fn name_size(text: &str) -> usize {
    let mut before = None;
    for (at, c) in text.char_indices() {
        let rest = &text[at..];
        let is_joined = || rest[1..].starts_with(char::is_alphanumeric);
        let is_part = match c {
            '_' => true,
            '\'' => !(is_suffix(rest) && before.is_some_and(|c: char| c.is_ascii_digit())),
            '.' | '-' => is_joined(),
            c => c.is_alphanumeric(),
        };
        if !is_part {
            return at;
        }
        before = Some(c);
    }
    text.len()
}

/// Returns the length of the number at the beginning of a text: of `5.7e-14`.
fn number_size(text: &str) -> usize {
    let end =
        |text: &str, is_part: fn(char) -> bool| text.find(|c| !is_part(c)).unwrap_or(text.len());
    let size = end(text, |c| c.is_ascii_digit() || c == '.');
    match text[size..].strip_prefix('e').and_then(exponent) {
        Some(power) => size + 1 + power.len(),
        None => size,
    }
}

/// Returns the exponent at the beginning of a text: a minus sign, if any, and digits.
fn exponent(text: &str) -> Option<&str> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let end = digits.find(|c: char| !c.is_ascii_digit());
    let count = end.unwrap_or(digits.len());
    (count > 0).then(|| &text[..text.len() - digits.len() + count])
}

/// Returns `true` if a text begins with an apostrophe and a Turkish suffix.
fn is_suffix(text: &str) -> bool {
    let suffix = text.strip_prefix('\'');
    suffix.is_some_and(|suffix| suffix.starts_with(char::is_alphabetic))
}

/// The units that can follow a number in a sentence.
const UNITS: [&str; 13] = [
    "mm", "cm", "m", "in", "s", "rad", "deg", "N", "kg", "W", "J", "rpm", "min",
];

/// Words of both languages that can also be names; within a sentence they count as words.
const WORDS: [&str; 4] = ["a", "A", "I", "o"];

/// Returns `true` if a word of a sentence is a symbol: one of these sorted names, or a word that
/// begins with a Greek letter.
fn is_symbol(word: &str, symbols: &[String]) -> bool {
    let is_greek = word.starts_with(['θ', 'ω', 'α', 'β', 'γ', 'μ', 'ν']);
    let is_name = || {
        symbols
            .binary_search_by(|name| name.as_str().cmp(word))
            .is_ok()
    };
    is_greek || !WORDS.contains(&word) && is_name()
}

/// Splits a paragraph into pieces, with these sorted names as symbols. An unpaired backtick stays a
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
        let names = ["a", "r2", "s"].map(str::to_owned);
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

    /// Texts of a scene can contain any characters.
    #[test]
    fn words_split_at_signs_exponents_and_suffixes() {
        let symbol = |name: &str| Formula::from(name);
        let rate = |order| Formula::from(Symbol::named("r4").derivative(order));
        let two = || symbol("a").power("2");
        for (text, expected) in [
            ("a^2+b^2", two().with_sign('+').then(symbol("b").power("2"))),
            (
                "f(x^2)",
                symbol("f").then(symbol("x").power("2").in_brackets()),
            ),
            (
                "10^9'dan",
                Formula::number("10")
                    .power("9")
                    .then(Formula::words("'dan")),
            ),
            ("10^-3", Formula::number("10").power("-3")),
            ("a^2^3", two().with_sign('^').then(Formula::number("3"))),
            ("a^", symbol("a").with_sign('^')),
            (
                "r2·ω2^2",
                symbol("r2").with_sign('·').then(symbol("ω2").power("2")),
            ),
            (
                "1/r3^2",
                Formula::number("1")
                    .with_sign('/')
                    .then(symbol("r3").power("2")),
            ),
            ("dr4/dt'yi", rate(1).then(Formula::words("'yi"))),
            (
                "d2r4/dt2=-5",
                rate(2).with_sign('=').then(Formula::number("-5")),
            ),
            ("r4'/dta", symbol("r4'").with_sign('/').then(symbol("dta"))),
            ("θ_a-b", symbol("θ_a-b")),
            ("5.7e-14", Formula::number("5.7e-14")),
        ] {
            assert_eq!(word(text), expected, "{text}");
        }
        let sum = symbol("θ3").blank().with_sign('+').blank();
        assert_eq!(label("θ3 + 30", &[]), Some(sum.then(Formula::number("30"))));
    }
}
