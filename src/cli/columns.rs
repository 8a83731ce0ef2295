//! Parses the columns that options name.

use super::failure::Failure;
use crate::quantity::{Catalogue, Quantity, UnknownColumn};
use crate::wording::words;
use std::collections::HashSet;

/// Returns the quantities that the patterns name or define. Without patterns, returns all of them
/// except those of marks. The driver and the state may be named, although they have columns anyway.
pub(super) fn figures(
    catalogue: &mut Catalogue,
    patterns: &[String],
) -> Result<Vec<Quantity>, Failure> {
    if patterns.is_empty() {
        return Ok(catalogue.usual());
    }
    let mut quantities = Vec::new();
    // Few quantities share a name, so few are compared with all others.
    let mut names = HashSet::new();
    let patterns = patterns.iter().flat_map(|list| entries(list));
    let patterns: Vec<&str> = patterns.map(str::trim).collect();
    for (number, pattern) in patterns.iter().enumerate() {
        if *pattern == "state" {
            continue;
        }
        let found = named(catalogue, "--columns", pattern);
        let around = patterns.get(number.saturating_sub(1)..).unwrap_or_default();
        let fix = || around.windows(2).take(2).find_map(cut_number);
        for quantity in found.map_err(|fault| fix().unwrap_or(fault))? {
            if names.insert(quantity.name.clone()) || !quantities.contains(&quantity) {
                quantities.push(quantity);
            }
        }
    }
    Ok(quantities)
}

/// Returns the error for a formula that a decimal comma cut into two entries.
fn cut_number(pair: &[&str]) -> Option<Failure> {
    let &[before, pattern] = pair else {
        return None;
    };
    let is_digit = |c: char| c.is_ascii_digit();
    let is_cut =
        before.contains('=') && before.ends_with(is_digit) && pattern.starts_with(is_digit);
    let head = before.rsplit(|c| !is_digit(c)).next()?;
    let tail = pattern.split(|c| !is_digit(c)).next()?;
    is_cut.then(|| {
        Failure::Usage(words().of_option("--columns", &words().number_with_comma(head, tail)))
    })
}

/// Returns the quantities of a pattern. `name = formula` defines a new quantity.
pub(super) fn named(
    catalogue: &mut Catalogue,
    option: &str,
    pattern: &str,
) -> Result<Vec<Quantity>, Failure> {
    if pattern.contains('=') {
        let defined = catalogue.define(pattern);
        let wrong = |why: String| Failure::Usage(words().of_option(option, &why));
        return Ok(vec![defined.map_err(wrong)?]);
    }
    let unknown = |e: UnknownColumn| Failure::Usage(words().of_option(option, &e));
    catalogue.select(&[pattern]).map_err(unknown)
}

/// Splits a list at commas, except within the parentheses of a formula.
pub(super) fn entries(list: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0_usize;
    list.split(move |c| {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        c == ',' && depth == 0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_in_brackets_belong_to_a_formula() {
        let found: Vec<&str> = entries("C.x,d = hypot(C.x, min(C.y, D.y)),,*").collect();
        assert_eq!(found, ["C.x", "d = hypot(C.x, min(C.y, D.y))", "", "*"]);
        assert_eq!(entries("),a").collect::<Vec<_>>(), [")", "a"]);
    }
}
