//! Breaks formulas into lines.

use super::Equation;
use super::words::{fill, length};

/// Indentation of a formula.
const INDENT: usize = 2;
/// Maximum width of a left side for which further sides are aligned at its equals sign.
const SHORT_SIDE: usize = 16;

/// Breaks a chain of sides: on one line if it fits, or else side below side.
pub(super) fn lines(equation: &Equation, width: usize) -> Vec<String> {
    let sides = &equation.sides;
    let indent = " ".repeat(INDENT);
    let text = format!("{indent}{}", sides.join(" = "));
    let Some((first, others)) = sides.split_first().map(|(f, o)| (f.as_str(), o)) else {
        return Vec::new();
    };
    if length(&text) <= width {
        return vec![text];
    }
    let left = length(first);
    if left > SHORT_SIDE || left + 2 * INDENT > width / 2 {
        return terms(&text, width, 2 * INDENT);
    }
    // Each line takes as many sides as fit, with the equals signs aligned.
    let mut rows: Vec<String> = Vec::new();
    let start = INDENT + left + " = ".len();
    for side in others {
        let fits = |row: &&mut String| start + length(row) + 3 + length(side) <= width;
        match rows.last_mut().filter(fits) {
            Some(row) => row.push_str(&format!(" = {side}")),
            None => rows.push(side.clone()),
        }
    }
    let space = width.saturating_sub(start);
    let blank = " ".repeat(start);
    let mut lines = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let name = if i == 0 { first } else { "" };
        for (j, line) in terms(row, space, 2).into_iter().enumerate() {
            let before = match j {
                0 => format!("{indent}{name:left$} = "),
                _ => blank.clone(),
            };
            lines.push(before + &line);
        }
    }
    lines
}

/// Breaks a formula into lines of at most `width` columns, before the signs between its terms.
fn terms(formula: &str, width: usize, indent: usize) -> Vec<String> {
    let own = formula.len() - formula.trim_start().len();
    fill(&parts(formula), width, [own, indent])
}

/// Splits a formula into terms, each with the sign before it; brackets are not split.
fn parts(formula: &str) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    let mut depth = 0_usize;
    for word in formula.split_whitespace() {
        let starts = depth == 0 && matches!(word, "+" | "-" | "=" | "+-");
        match parts.last_mut().filter(|_| !starts) {
            Some(part) => part.push_str(&format!(" {word}")),
            None => parts.push(word.to_owned()),
        }
        let open = word.matches('(').count();
        depth = (depth + open).saturating_sub(word.matches(')').count());
    }
    // `= 0` at the end of a sum does not get a line of its own.
    if let [.., last, end] = &mut parts[..]
        && end == "= 0"
    {
        last.push_str(" = 0");
        parts.pop();
    }
    parts
}
