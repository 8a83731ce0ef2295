//! Breaks formulas into lines.

use super::math::{Formula, MathPiece};
use super::words::{fill, length};

/// Indentation of a formula.
const INDENT: usize = 2;
/// Maximum width of a left side for which further sides are aligned at its equals sign.
const SHORT_SIDE: usize = 16;

/// Breaks a chain of sides: on one line if it fits, or else side below side.
pub(super) fn lines(sides: &[Formula], width: usize) -> Vec<String> {
    let Some((first, others)) = sides.split_first() else {
        return Vec::new();
    };
    let equation = others.iter().cloned().fold(first.clone(), Formula::equals);
    let indent = " ".repeat(INDENT);
    let text = format!("{indent}{equation}");
    if length(&text) <= width {
        return vec![text];
    }
    let first = first.to_string();
    let left = length(&first);
    if left > SHORT_SIDE || left + 2 * INDENT > width / 2 {
        return fill(&terms(&equation), width, [INDENT, 2 * INDENT]);
    }
    // Each line takes as many sides as fit, with the equals signs aligned.
    let start = INDENT + left + " = ".len();
    let space = width.saturating_sub(start);
    let mut rows: Vec<Formula> = Vec::new();
    for side in others {
        let longer = |row: &Formula| row.clone().equals(side.clone());
        let fits = |row: &&mut Formula| length(&longer(row).to_string()) <= space;
        match rows.last_mut().filter(fits) {
            Some(row) => *row = longer(row),
            None => rows.push(side.clone()),
        }
    }
    let blank = " ".repeat(start);
    let mut lines = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let name = if i == 0 { &first } else { "" };
        for (j, line) in fill(&terms(row), space, [0, 2]).iter().enumerate() {
            lines.push(match j {
                0 => format!("{indent}{name:left$} = {line}"),
                _ => format!("{blank}{line}"),
            });
        }
    }
    lines
}

/// Splits a formula into terms, each with the sign before it; brackets are not split.
fn terms(formula: &Formula) -> Vec<String> {
    let mut terms = vec![String::new()];
    let mut depth = 0_usize;
    for (k, piece) in formula.0.iter().enumerate() {
        let around = [k.wrapping_sub(1), k + 1].map(|k| formula.0.get(k));
        let is_between = around == [Some(&MathPiece::Blank); 2];
        match piece {
            MathPiece::Sign('(') => depth += 1,
            MathPiece::Sign(')') => depth = depth.saturating_sub(1),
            MathPiece::Sign('+' | '-' | '=' | '±') if is_between && depth == 0 => {
                terms.push(String::new());
            }
            _ => {}
        }
        if let Some(term) = terms.last_mut() {
            term.push_str(&piece.to_string());
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
