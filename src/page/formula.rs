//! Breaks formulas into lines.

use super::math::{Formula, MathPiece};
use super::words::{fill, length};
use std::ops::Range;

/// The sign between two sides.
const EQUALS: &str = " = ";
/// Indentation of a formula.
const INDENT: usize = 2;
/// Maximum width of a left side for which further sides are aligned at its equals sign.
const SHORT_SIDE: usize = 16;

/// Breaks a chain of sides: on one line if it fits, or else side below side. `shown` returns a text
/// as displayed.
pub(super) fn lines(
    sides: &[Formula],
    width: usize,
    shown: &impl Fn(&str) -> String,
) -> Vec<String> {
    let Some((_, others)) = sides.split_first() else {
        return Vec::new();
    };
    let indent = " ".repeat(INDENT);
    let texts: Vec<String> = sides.iter().map(|side| shown(&side.to_string())).collect();
    let text = format!("{indent}{}", texts.join(EQUALS));
    if length(&text) <= width {
        return vec![text];
    }
    let first = &texts[0];
    let left = length(first);
    if left > SHORT_SIDE || left + 2 * INDENT > width / 2 {
        return fill(&terms(sides, shown), width, [INDENT, 2 * INDENT]);
    }
    // Each line takes as many sides as fit, with the equals signs aligned.
    let start = INDENT + left + EQUALS.len();
    let space = width.saturating_sub(start);
    let mut rows: Vec<Range<usize>> = Vec::new();
    let mut used = 0;
    for (i, text) in texts[1..].iter().enumerate() {
        used += EQUALS.len() + length(text);
        match rows.last_mut().filter(|_| used <= space) {
            Some(row) => row.end += 1,
            None => {
                used = length(text);
                rows.push(i..i + 1);
            }
        }
    }
    let blank = " ".repeat(start);
    let mut lines = Vec::new();
    for (i, row) in rows.into_iter().enumerate() {
        let name = if i == 0 { first.as_str() } else { "" };
        let parts = fill(&terms(&others[row], shown), space, [0, 2]);
        for (j, line) in parts.iter().enumerate() {
            lines.push(match j {
                0 => format!("{indent}{name:left$}{EQUALS}{line}"),
                _ => format!("{blank}{line}"),
            });
        }
    }
    lines
}

/// Splits a chain of sides into terms, each with the sign before it; brackets are not split.
fn terms(sides: &[Formula], shown: &impl Fn(&str) -> String) -> Vec<String> {
    const BETWEEN: [MathPiece; 3] = [MathPiece::Blank, MathPiece::Sign('='), MathPiece::Blank];
    let mut pieces: Vec<&MathPiece> = Vec::new();
    for (i, side) in sides.iter().enumerate() {
        let before = if i == 0 { &[][..] } else { &BETWEEN };
        pieces.extend(before.iter().chain(&side.0));
    }
    let mut terms = vec![String::new()];
    let mut depth = 0_usize;
    for (k, piece) in pieces.iter().enumerate() {
        let around = [k.wrapping_sub(1), k + 1].map(|k| pieces.get(k));
        let is_between = around == [Some(&&MathPiece::Blank); 2];
        match piece {
            MathPiece::Sign('(') => depth += 1,
            MathPiece::Sign(')') => depth = depth.saturating_sub(1),
            MathPiece::Sign('+' | '-' | '=' | '±') if is_between && depth == 0 => {
                terms.push(String::new());
            }
            _ => {}
        }
        if let Some(term) = terms.last_mut() {
            term.push_str(&shown(&piece.to_string()));
        }
    }
    // `= 0` at the end of a sum does not get a line of its own.
    if let [.., last, end] = &mut terms[..]
        && end == "= 0"
    {
        last.push_str("= 0");
        terms.pop();
    }
    let terms = terms.iter().map(|term| term.trim().to_owned());
    terms.collect()
}
