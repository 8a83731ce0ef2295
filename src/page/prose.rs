//! Paragraphs taken apart, for writers that set what is typed, and rates and powers, as such.

/// A piece of a paragraph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ProsePiece<'t> {
    /// Words with their blanks.
    Words(&'t str),
    /// What stood between backticks.
    Typed(&'t str),
    /// A rate, or something with a power.
    Formula(&'t str),
}

/// Whether a text has what is spelled in another way where formulas are set.
pub(super) fn is_spelled(text: &str) -> bool {
    text.contains("/dt") || text.contains('^')
}

/// The pieces of a paragraph; a backtick without its other is one.
pub(super) fn pieces(text: &str) -> Vec<ProsePiece<'_>> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some((before, typed, behind)) = between_backticks(rest) {
        push_words(before, &mut pieces);
        pieces.push(ProsePiece::Typed(typed));
        rest = behind;
    }
    push_words(rest, &mut pieces);
    pieces
}

fn between_backticks(text: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = text.split_once('`')?;
    let (typed, behind) = rest.split_once('`')?;
    Some((before, typed, behind))
}

fn push_words<'t>(text: &'t str, pieces: &mut Vec<ProsePiece<'t>>) {
    for part in text.split_inclusive(' ') {
        let word = part.trim_end_matches([' ', ',', ';', ':', '.']);
        match is_spelled(word) {
            true => {
                pieces.push(ProsePiece::Formula(word));
                pieces.push(ProsePiece::Words(&part[word.len()..]));
            }
            false => pieces.push(ProsePiece::Words(part)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_and_what_is_typed_stand_apart() {
        let taken = pieces("a `b c` dr4/dt: d");
        let expected = [
            ProsePiece::Words("a "),
            ProsePiece::Typed("b c"),
            ProsePiece::Words(" "),
            ProsePiece::Formula("dr4/dt"),
            ProsePiece::Words(": "),
            ProsePiece::Words("d"),
        ];
        assert_eq!(taken, expected);
        assert_eq!(pieces("a ` b").len(), 3);
    }
}
