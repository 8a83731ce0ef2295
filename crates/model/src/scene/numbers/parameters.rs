//! Reads `[parameters]`: named numbers in any order, which may be formulas of each other.

use crate::document::{Diagnostic, NamedNumbers, WrittenValue};
use crate::expression::{self, Dimension, ExpressionTree, MeasuredNumber, Wide};
use crate::scene::numbers::figures::FormulaPlace;
use crate::scene::numbers::reader::{Name, Reader};
use crate::wording::words;
use std::collections::HashMap;

/// A named number of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The name given by the scene.
    pub name: String,
    /// The value.
    pub number: f64,
    /// The formula that it is computed from; `None` for a plain number.
    pub formula: Option<String>,
    /// The dimension, if a unit determines it; a plain number may measure anything.
    pub dimension: Option<Dimension>,
}

/// A name with its formula.
#[derive(Debug)]
pub(crate) struct DraftParameter<'t> {
    pub(crate) name: Name<'t>,
    formula: Option<&'t str>,
}

const EXAMPLE: &str = "{ a = 100 }";

/// A formula that depends on others not evaluated yet.
struct WaitingParameter<'v> {
    name: Name<'v>,
    formula: Name<'v>,
    tree: ExpressionTree,
    /// The indices of the formulas that use it, and the number of formulas that it still waits for.
    followers: Vec<usize>,
    pending: usize,
}

/// Reads the section and makes its names known to all formulas.
pub(crate) fn read<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<DraftParameter<'v>> {
    let mut draft = Vec::new();
    let mut waiting = Vec::new();
    for (name, value) in reader.entries("[parameters]", EXAMPLE, value) {
        let formula = value.get_ref().as_str();
        let result = match formula {
            None => number(reader, &name, value),
            Some(text) => {
                let span = value.span();
                waiting.extend(parsed(reader, &name, Name { text, span }));
                None
            }
        };
        reader.named.worth.insert(name.text.to_owned(), result);
        draft.push(DraftParameter { name, formula });
    }
    in_order(reader, waiting);
    draft
}

/// Returns the parameters with their values.
pub(crate) fn with_values(named: &NamedNumbers, draft: Vec<DraftParameter<'_>>) -> Vec<Parameter> {
    let text = draft.into_iter().filter_map(|parameter| {
        let value = named.worth.get(parameter.name.text)?.as_ref()?;
        Some(Parameter {
            name: parameter.name.text.to_owned(),
            number: value.nearest(),
            formula: parameter.formula.map(str::to_owned),
            dimension: value.dimension,
        })
    });
    text.collect()
}

fn what(name: &Name<'_>) -> String {
    words().parameter_called(&name.to_string())
}

fn number(
    reader: &mut Reader<'_>,
    name: &Name<'_>,
    value: &WrittenValue<'_>,
) -> Option<MeasuredNumber> {
    let number = reader.number(&what(name), value)?;
    let digits = reader.text().get(value.span()).unwrap_or("");
    // Whole numbers in another base are doubles.
    let typed = Wide::decimal(&digits.replace('_', ""));
    let typed = typed.filter(|typed| typed.nearest() == number);
    Some(MeasuredNumber::plain(
        typed.unwrap_or_else(|| Wide::exactly(number)),
    ))
}

fn parsed<'v>(
    reader: &mut Reader<'_>,
    name: &Name<'v>,
    formula: Name<'v>,
) -> Option<WaitingParameter<'v>> {
    match expression::parse(formula.text) {
        Ok(tree) => Some(WaitingParameter {
            name: name.clone(),
            formula,
            tree,
            followers: Vec::new(),
            pending: 0,
        }),
        Err(fault) => {
            let place = FormulaPlace::of(reader, &formula);
            reader.report(place.fault(&what(name), &fault));
            None
        }
    }
}

/// Evaluates each parameter once all its inputs are known; reports cyclic dependencies.
fn in_order(reader: &mut Reader<'_>, mut waiting: Vec<WaitingParameter<'_>>) {
    let numbers = waiting.iter().enumerate();
    let numbers: HashMap<String, usize> = numbers
        .map(|(i, one)| (one.name.text.to_owned(), i))
        .collect();
    let parts: Vec<Vec<usize>> = waiting.iter().map(|one| uses(one, &numbers)).collect();
    for (i, parts) in parts.iter().enumerate() {
        waiting[i].pending = parts.len();
        for &part in parts {
            waiting[part].followers.push(i);
        }
    }
    let mut ready: Vec<usize> = (0..waiting.len())
        .filter(|&i| waiting[i].pending == 0)
        .collect();
    let mut next = 0;
    while let Some(&i) = ready.get(next) {
        next += 1;
        let WaitingParameter {
            name,
            formula,
            tree,
            ..
        } = &waiting[i];
        let value = reader.evaluate_formula(&what(name), formula, tree);
        reader.named.worth.insert(name.text.to_owned(), value);
        for follower in std::mem::take(&mut waiting[i].followers) {
            waiting[follower].pending -= 1;
            if waiting[follower].pending == 0 {
                ready.push(follower);
            }
        }
    }
    circles(reader, &waiting, &parts);
}

/// Returns the indices of the formulas named in one, without duplicates.
fn uses(one: &WaitingParameter<'_>, numbers: &HashMap<String, usize>) -> Vec<usize> {
    let mut parts = Vec::new();
    one.tree
        .each_name(&mut |name| parts.extend(numbers.get(name).copied()));
    parts.sort_unstable();
    parts.dedup();
    parts
}

/// Reports every cycle among the parameters that still wait.
fn circles(reader: &mut Reader<'_>, waiting: &[WaitingParameter<'_>], parts: &[Vec<usize>]) {
    // The index of the walk that first reached each parameter.
    let mut met = vec![usize::MAX; waiting.len()];
    for first in 0..waiting.len() {
        let mut walk = Vec::new();
        let mut at = first;
        while waiting[at].pending > 0 && met[at] == usize::MAX {
            met[at] = first;
            walk.push(at);
            // A waiting parameter always depends on another waiting one.
            let Some(&next) = parts[at].iter().find(|&&part| waiting[part].pending > 0) else {
                break;
            };
            at = next;
        }
        let is_circle = met[at] == first && !walk.is_empty();
        if let Some(start) = walk.iter().position(|&one| one == at && is_circle) {
            reader.report(circle(waiting, &walk[start..]));
        }
    }
}

/// Maximum number of names in a message.
const MAX_LISTED: usize = 8;

fn circle(waiting: &[WaitingParameter<'_>], round: &[usize]) -> Diagnostic {
    let first = &waiting[round[0]];
    let mut names: Vec<&str> = round.iter().map(|&one| waiting[one].name.text).collect();
    if names.len() > MAX_LISTED {
        names.truncate(MAX_LISTED);
        names.push("...");
    }
    names.push(first.name.text);
    let name = first.name.to_string();
    let message = words().parameters_in_a_circle(&name, &names.join(" <- "));
    Diagnostic::new(message)
        .at(first.formula.span.clone(), words().follows_from_itself())
        .help(words().give_one_a_number())
}
