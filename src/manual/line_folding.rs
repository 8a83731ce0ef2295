//! Folds code lines for narrow screens, and joins broken lines to one text again.

use super::layout::{LineKind, ManualLine};

/// Blanks before a continuation line of code.
const INDENT: usize = 2;

/// Splits a line of code into pieces of at most `width` characters; other lines are returned unchanged.
///
/// A piece ends after its last blank if that blank is in its second half. Pieces keep their trailing blanks, so that
/// the pieces without their indentation concatenate to the line.
pub(crate) fn folded(line: ManualLine, width: usize) -> Vec<ManualLine> {
    if line.kind != LineKind::Code {
        return vec![line];
    }
    let mut rest: Vec<char> = line.text.chars().collect();
    let mut pieces = Vec::new();
    let mut indent = 0;
    let space = |indent| width.saturating_sub(indent).max(1);
    while rest.len() > space(indent) {
        let space = space(indent);
        let blank = rest[..space].iter().rposition(|c| *c == ' ');
        let end = blank.map_or(space, |blank| blank + 1);
        let end = if end > space / 2 { end } else { space };
        let after = rest.split_off(end);
        pieces.push(piece(&rest, indent));
        rest = after;
        indent = INDENT;
    }
    pieces.push(piece(&rest, indent));
    pieces
}

/// Joins the lines of a paragraph: words with a blank before each line, folded code without its indentation.
pub(crate) fn joined(lines: &[ManualLine]) -> String {
    let mut text = String::new();
    for line in lines {
        match line.kind {
            LineKind::Code if line.continues => text += line.text.get(INDENT..).unwrap_or_default(),
            LineKind::Code => text += &line.text,
            LineKind::Title | LineKind::Words => {
                text.push(' ');
                text += line.text.trim_start();
            }
        }
    }
    text
}

/// Returns a piece of code. An indented piece continues the line before it.
fn piece(text: &[char], indent: usize) -> ManualLine {
    let text: String = text.iter().collect();
    ManualLine {
        kind: LineKind::Code,
        text: format!("{:indent$}{text}", ""),
        continues: indent > 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manual::{TOPICS, lines};

    #[test]
    fn code_that_is_too_wide_is_folded_and_nothing_lost() {
        let mut folds = 0;
        for topic in TOPICS {
            for line in lines(&topic.text(String::new), 40) {
                let pieces = folded(line.clone(), 40);
                folds += pieces.len() - 1;
                assert!(pieces.iter().all(|piece| piece.text.chars().count() <= 40));
                assert!(pieces.iter().skip(1).all(|piece| piece.continues));
                assert_eq!(joined(&pieces).trim_start(), line.text.trim_start());
            }
        }
        assert!(folds > 10, "{folds}");
    }

    #[test]
    fn no_width_is_too_small() {
        let line = piece(&['a', ' ', 'b'], 0);
        assert_eq!(folded(line.clone(), 0).len(), 3);
        assert_eq!(folded(line.clone(), 3), [line]);
    }
}
