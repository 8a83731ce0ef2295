//! Evaluates the formulas of a scene for other numbers, without parsing its text again.

use crate::document::NamedNumbers;
use crate::expression::{self, ExpressionTree, MeasuredNumber};
use crate::scene::{Scene, Value, ValueOwner};

/// Maximum number of formulas that are evaluated without parsing the text.
const MAX_FORMULAS: usize = 64;

/// Some values of a scene, and all values that are computed from them.
#[derive(Clone, Debug)]
pub(crate) struct DependentValues {
    varied: Vec<Value>,
    /// `true` for each varied value that a formula needs.
    is_read: Vec<bool>,
    /// The computed values, each after all those that it is computed from.
    computed: Vec<ComputedValue>,
    named: NamedNumbers,
}

#[derive(Clone, Debug)]
struct ComputedValue {
    value: Value,
    formula: String,
    tree: ExpressionTree,
    /// The parameters in its formula.
    parts: Vec<String>,
    /// The index of the varied value that the formula consists of.
    copied: Option<usize>,
}

impl DependentValues {
    /// Finds all values computed from `varied`. Returns `None` if there are more than
    /// `MAX_FORMULAS`.
    pub(crate) fn of(scene: &Scene, varied: &[Value]) -> Option<DependentValues> {
        let is_varied = |value: &Value| varied.iter().any(|other| other.name == value.name);
        let values = scene.values().into_iter();
        let mut others: Vec<ComputedValue> = values
            .filter(|value| !is_varied(value))
            .filter_map(ComputedValue::of)
            .collect();
        let names = varied.iter().filter_map(parameter);
        let mut names: Vec<String> = names.map(str::to_owned).collect();
        let (mut computed, mut next) = (Vec::new(), 0);
        while let Some(name) = names.get(next) {
            let (found, rest): (Vec<_>, Vec<_>) = others
                .into_iter()
                .partition(|other| other.parts.contains(name));
            next += 1;
            let new = found.iter().filter_map(|other| parameter(&other.value));
            names.extend(new.map(str::to_owned));
            computed.extend(found);
            others = rest;
            if computed.len() > MAX_FORMULAS {
                return None;
            }
        }
        let mut computed = in_order(computed);
        for one in &mut computed {
            one.copied = varied.iter().position(|value| one.is_copy_of(value));
        }
        let mut found = DependentValues {
            varied: varied.to_vec(),
            is_read: Vec::new(),
            computed,
            named: (*scene.named).clone(),
        };
        found.mark_read_values();
        Some(found)
    }

    /// Leaves out computed values that are not needed; `is_needed` has one entry for each. Those that
    /// others are computed from stay.
    pub(crate) fn keep(&mut self, is_needed: &[bool]) -> Vec<usize> {
        let mut kept: Vec<usize> = Vec::new();
        let mut parts: Vec<String> = Vec::new();
        for (i, one) in self.computed.iter().enumerate().rev() {
            let is_part = parameter(&one.value).is_some_and(|name| parts.iter().any(|p| p == name));
            if is_part || is_needed.get(i) == Some(&true) {
                parts.extend(one.parts.iter().cloned());
                kept.push(i);
            }
        }
        kept.reverse();
        let all = std::mem::take(&mut self.computed);
        let all = all.into_iter().enumerate();
        self.computed = all
            .filter(|(i, _)| kept.contains(i))
            .map(|(_, one)| one)
            .collect();
        self.mark_read_values();
        kept
    }

    fn mark_read_values(&mut self) {
        let evaluated = || self.computed.iter().filter(|one| one.copied.is_none());
        let is_read = |value: &Value| {
            let name = parameter(value);
            name.is_some_and(|name| evaluated().any(|one| one.parts.iter().any(|p| p == name)))
        };
        self.is_read = self.varied.iter().map(is_read).collect();
    }

    /// Returns the computed values.
    pub(crate) fn computed(&self) -> impl Iterator<Item = &Value> {
        self.computed.iter().map(|one| &one.value)
    }

    /// Returns the numbers of the computed values for other numbers of the varied ones. Returns
    /// `None` if a formula has no value, or another dimension than in the scene.
    pub(crate) fn numbers(&mut self, varied: &[f64]) -> Option<Vec<f64>> {
        for ((value, number), is_read) in self.varied.iter().zip(varied).zip(&self.is_read) {
            if let Some(name) = parameter(value).filter(|_| *is_read) {
                let text = value.with_number(*number);
                let result = self.named.evaluate_text(text.trim_matches('"')).ok()?;
                self.named.worth.insert(name.to_owned(), Some(result));
            }
        }
        let mut numbers = Vec::with_capacity(self.computed.len());
        for one in &self.computed {
            if let Some(copied) = one.copied {
                numbers.push(varied[copied]);
                continue;
            }
            let result: MeasuredNumber = self.named.evaluate_tree(&one.formula, &one.tree).ok()?;
            if result.dimension != one.value.dimension {
                return None;
            }
            numbers.push(result.nearest());
            if let Some(name) = parameter(&one.value) {
                self.named.worth.insert(name.to_owned(), Some(result));
            }
        }
        Some(numbers)
    }
}

impl ComputedValue {
    /// Returns `None` for a plain number.
    fn of(value: Value) -> Option<ComputedValue> {
        let formula = value.formula.clone()?;
        Some(ComputedValue {
            tree: expression::parse(&formula).ok()?,
            parts: value.follows_from(),
            formula,
            value,
            copied: None,
        })
    }

    /// Returns `true` if the formula is the name of a parameter that is a plain number. Its number is
    /// then that of the parameter, without any rounding.
    fn is_copy_of(&self, value: &Value) -> bool {
        let is_plain = value.literal.trim_matches('"').parse::<f64>().is_ok();
        let is_name = parameter(value) == Some(self.formula.trim());
        // Other values are computed from the number that a parameter's name stands for.
        let is_parameter = parameter(&self.value).is_some();
        let is_same = value.number == self.value.number && value.number != 0.0;
        is_plain && is_name && is_same && !is_parameter
    }
}

/// Returns the name of a parameter; `None` for other values.
fn parameter(value: &Value) -> Option<&str> {
    match &value.owner {
        ValueOwner::Parameter(name) => Some(name),
        ValueOwner::Scene
        | ValueOwner::Driver
        | ValueOwner::Element(_)
        | ValueOwner::Between(..) => None,
    }
}

/// Sorts values so that each is behind the parameters in its formula. The formulas of a scene have
/// no cycles.
fn in_order(mut waiting: Vec<ComputedValue>) -> Vec<ComputedValue> {
    let mut ordered = Vec::with_capacity(waiting.len());
    while !waiting.is_empty() {
        let names = waiting.iter().filter_map(|other| parameter(&other.value));
        let names: Vec<String> = names.map(str::to_owned).collect();
        let waits = |one: &ComputedValue| one.parts.iter().any(|part| names.contains(part));
        let (later, ready): (Vec<_>, Vec<_>) = waiting.into_iter().partition(waits);
        if ready.is_empty() {
            break;
        }
        ordered.extend(ready);
        waiting = later;
    }
    ordered
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"
unit = "mm"
[parameters]
c = "a + b"
b = "2 * a"
a = 50
turn = 60
[ground]
A = [0, 0]
D = ["c + 250", 0]
[driver]
link = "r2"
angle = "turn"
speed = "1 rad/s"
[links]
r2 = { from = "A", to = "B", length = "a" }
r3 = { from = "B", to = "C", length = "6 * a" }
r4 = { from = "D", to = "C", length = 320 }
[start]
C = [250, 200]
"#;

    /// Parameters in any order are computed as the parser computes them.
    #[test]
    fn computed_values_match_parsed_text() {
        let scene = Scene::parse(TEXT, "test").unwrap();
        let varied = vec![scene.value_named("a").unwrap()];
        let mut values = DependentValues::of(&scene, &varied).unwrap();
        for number in [50.0, 53.1, 0.1 + 0.2, 1e-3] {
            let numbers = values.numbers(&[number]).unwrap();
            let text = scene.with_value(&varied[0], &varied[0].with_number(number));
            let other = scene.reparse(&text).unwrap();
            let names: Vec<String> = values.computed().map(Value::dotted).collect();
            assert_eq!(names.len(), 5, "{names:?}");
            for (name, number) in names.iter().zip(numbers) {
                assert_eq!(other.value_named(name).unwrap().number, number, "{name}");
            }
        }
        assert_eq!(values.numbers(&[f64::MAX]), None, "6 * a is not a number");
    }
}
