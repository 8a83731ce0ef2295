//! Evaluates the numbers of a scene that are formulas of its parameters.

use crate::document::{Diagnostic, NamedNumbers};
use crate::expression::{
    self, Dimension, ExpressionTree, FormulaError, LengthScale, MeasuredNumber, evaluate,
};
use crate::nearest::did_you_mean;
use crate::scene::numbers::figures::FormulaPlace;
use crate::scene::numbers::reader::{ByteSpan, Name, Reader, bare_number};
use crate::scene::{Scene, Value};
use crate::wording::words;

/// Maximum number of names in a hint.
const MAX_LISTED: usize = 12;

impl Reader<'_> {
    /// Evaluates a formula given as a number; reports faults.
    pub fn worked_out(
        &mut self,
        what: &str,
        text: &str,
        span: &ByteSpan,
    ) -> Option<MeasuredNumber> {
        let formula = Name {
            text,
            span: span.clone(),
        };
        let tree = match expression::parse(text) {
            Ok(tree) => tree,
            Err(fault) => {
                let help = fault.help.clone().or_else(|| self.named.product(text));
                let help = help.or_else(|| bare_number(text));
                let place = FormulaPlace::of(self, &formula);
                self.report(place.fault(what, &FormulaError { help, ..fault }));
                return None;
            }
        };
        self.evaluate_formula(what, &formula, &tree)
    }

    /// Evaluates a parsed formula; reports faults.
    pub(crate) fn evaluate_formula(
        &mut self,
        what: &str,
        formula: &Name<'_>,
        tree: &ExpressionTree,
    ) -> Option<MeasuredNumber> {
        // The fault of the parameter was reported at its definition.
        if self.named.names_unknown_parameter(tree) {
            return None;
        }
        match self.named.evaluate_tree(formula.text, tree) {
            Ok(found) => {
                self.worked.insert(formula.span.start, found.nearest());
                Some(found)
            }
            Err(fault) => {
                let place = FormulaPlace::of(self, formula);
                self.report(place.fault(what, &fault));
                None
            }
        }
    }
}

impl NamedNumbers {
    /// Returns `true` if a formula names a parameter without a known value.
    fn names_unknown_parameter(&self, tree: &ExpressionTree) -> bool {
        let mut missing = false;
        tree.each_name(&mut |name| missing |= matches!(self.worth.get(name), Some(None)));
        missing
    }

    /// Evaluates a parsed formula.
    pub(in crate::scene) fn evaluate_tree(
        &self,
        text: &str,
        tree: &ExpressionTree,
    ) -> Result<MeasuredNumber, FormulaError> {
        let (symbol, tenths_of_mm) = self.length;
        let length = LengthScale {
            symbol,
            tenths_of_mm,
        };
        evaluate(text, tree, length, &|name| {
            let found = self.worth.get(name).cloned().flatten();
            found.ok_or_else(|| self.suggest_fix(name))
        })
    }

    /// Parses and evaluates a formula.
    pub(crate) fn evaluate_text(&self, text: &str) -> Result<MeasuredNumber, FormulaError> {
        self.evaluate_tree(text, &expression::parse(text)?)
    }

    /// Lists the parameters with units in a value's formula, each with its own unit; `None` if
    /// there are none.
    fn units_in(&self, value: &Value, wanted: &str) -> Option<String> {
        let text = value.follows_from().into_iter().filter_map(|name| {
            let dimension = self.worth.get(&name)?.as_ref()?.dimension?;
            Some((name, dimension.symbol(self.length.0)))
        });
        let text: Vec<_> = text.take(MAX_LISTED).collect();
        (!text.is_empty()).then(|| words().parameters_measured_in(&text, wanted))
    }

    /// Suggests a product sign between a number and a name; returns `None` for other texts.
    pub(crate) fn product(&self, text: &str) -> Option<String> {
        let (number, name) = text.trim().split_once(' ')?;
        let name = name.trim();
        let is_number = number.parse::<f64>().is_ok();
        (is_number && self.worth.contains_key(name))
            .then(|| words().product_has_a_sign(number, name))
    }

    /// Suggests a fix for an unknown name.
    fn suggest_fix(&self, name: &str) -> Option<String> {
        if let Some((number, unit)) = expression::glued(name) {
            return Some(words().blank_before_unit(number, unit));
        }
        if expression::is_difference(name, |part| self.worth.contains_key(part)) {
            return Some(words().minus_between_blanks().to_owned());
        }
        let mut names: Vec<&str> = self.worth.keys().map(String::as_str).collect();
        names.sort_unstable();
        if let Some(intended) = did_you_mean(name, names.iter().copied()) {
            return Some(intended);
        }
        let help = match names.len() {
            _ if name.contains('-') => words().minus_between_blanks().to_owned(),
            0 => words().scene_has_no_parameters().to_owned(),
            1..=MAX_LISTED => words().parameters_are(&format!("`{}`", names.join("`, `"))),
            _ => return None,
        };
        Some(help)
    }
}

/// Checks that formulas with units have the required dimensions. Reports those that do not, and
/// returns `false`.
pub(crate) fn measures_fit(reader: &mut Reader<'_>, scene: &Scene) -> bool {
    if reader.worked.is_empty() {
        return true;
    }
    let before = reader.found.len();
    for value in scene.values() {
        let (Some(found), Some(wanted)) = (value.dimension, value.measure.dimension()) else {
            continue;
        };
        if !fits(found, wanted) {
            let found = found.symbol(scene.unit.symbol());
            let wanted = match value.unit {
                "" => "1",
                unit => unit,
            };
            let message = words().value_measures_other(&described(scene, &value), &found, wanted);
            let fault = Diagnostic::new(message).at(value.place.clone(), "");
            let units = || words().unit_does_not_fit(&found, &value.units().join(", "));
            reader.report(fault.help(value.named.units_in(&value, wanted).unwrap_or_else(units)));
        }
    }
    reader.found.len() == before
}

/// Returns the name of a value in messages: a key of a link is named as in all other messages on it.
fn described(scene: &Scene, value: &Value) -> String {
    let links = scene.mechanism.link_ids().map(|id| scene.link_name(id));
    let mut keys = links.filter_map(|link| {
        let key = value.name.strip_prefix(link)?.strip_prefix(' ')?;
        Some(words().key_of(key, &words().link_called(&format!("`{link}`"))))
    });
    keys.next().unwrap_or_else(|| value.name.clone())
}

fn fits(found: Dimension, wanted: Dimension) -> bool {
    found.adds_to(wanted)
}
