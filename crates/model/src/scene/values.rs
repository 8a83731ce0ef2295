//! Every number of a scene that a person may change, with its place in the text.
//!
//! A value is changed in the text, and the text is read again: what may stand there is said in one
//! place, by the reader of scenes, and comments, order and blanks stay as they are.

mod collector;

use super::measure::{Measure, MeasureUnits};
use super::rewrite::Edits;
use super::{Scene, Unit};
use crate::document::NamedNumbers;
use crate::expression::{self, Dimension};
use crate::nearest::did_you_mean;
use crate::wording::words;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

/// What a number of the scene belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ValueOwner {
    /// The scene as a whole, as gravity does.
    Scene,
    /// The driver.
    Driver,
    /// The point, link or slide of this name; what acts on one belongs to it.
    Element(String),
    /// The line from one point to another, as of a spring.
    Between(String, String),
    /// The parameter of this name.
    Parameter(String),
}

/// A number of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// For people: `A x`, `r2 length`, `driver speed`. No two values of a scene have the same.
    pub name: String,
    /// What it belongs to.
    pub owner: ValueOwner,
    /// The formula that it follows from, where it is no plain number.
    pub formula: Option<String>,
    /// What it measures.
    pub measure: Measure,
    /// The number, in `unit`.
    pub number: f64,
    /// The number as the file writes it, or the formula.
    pub literal: String,
    /// The unit in which the file has it.
    pub unit: &'static str,
    /// The bytes of the text that [`Scene::with_value`] replaces.
    pub place: Range<usize>,
    /// The scene's unit of length.
    pub(super) scene: Unit,
    /// Whether what is put there needs quotes of its own.
    quotes: bool,
    /// What its formula measures, where a unit tells.
    pub(super) dimension: Option<Dimension>,
    /// What formulas may name.
    pub(super) named: Arc<NamedNumbers>,
}

impl Value {
    /// What is typed beside a scene, and stands nowhere in it.
    pub(super) fn beside(scene: &Scene, measure: Measure) -> Value {
        Value {
            name: String::new(),
            owner: ValueOwner::Scene,
            formula: None,
            measure,
            number: 0.0,
            literal: String::new(),
            unit: measure.unit(scene.unit),
            place: 0..0,
            scene: scene.unit,
            quotes: false,
            dimension: None,
            named: Arc::clone(&scene.named),
        }
    }

    /// Its name as columns and the command line have it: `r2.length`.
    #[must_use]
    pub fn dotted(&self) -> String {
        dotted(&self.name)
    }

    /// The unit of its number as tables have it: that of the file, and of a parameter what its formula measures.
    #[must_use]
    pub fn shown_unit(&self) -> String {
        let measured = self
            .dimension
            .filter(|_| self.measure == Measure::Parameter);
        measured.map_or_else(
            || self.unit.to_owned(),
            |unit| unit.written(self.scene.symbol()).to_string(),
        )
    }

    /// The text that stands in the file for this value: a number, of a rate with its unit.
    #[must_use]
    pub fn text(&self) -> String {
        match (&self.formula, self.measure.units(self.scene)) {
            (None, _) | (_, MeasureUnits::Rate(..)) => self.written(&self.literal),
            (Some(formula), _) => quoted(formula),
        }
    }

    /// The value as it is where this text stands in its place; its number stays where that is a formula.
    pub fn with_text(&self, text: &str) -> Value {
        let literal = text.split(' ').next().unwrap_or(text);
        match literal.parse() {
            Ok(number) => Value {
                number,
                literal: literal.to_owned(),
                formula: None,
                ..self.clone()
            },
            Err(_) => Value {
                literal: text.trim_matches('"').to_owned(),
                formula: Some(text.trim_matches('"').to_owned()),
                ..self.clone()
            },
        }
    }

    /// Whether it is a number, with its unit or without: nothing is worked out there.
    pub(crate) fn is_number(&self) -> bool {
        let tree = self.formula.as_deref().map(expression::parse);
        tree.is_none_or(|tree| tree.is_ok_and(|tree| tree.is_number()))
    }

    /// The parameters that its formula names.
    #[must_use]
    pub fn follows_from(&self) -> Vec<String> {
        let tree = self.formula.as_deref().map(expression::parse);
        let mut names = Vec::new();
        if let Some(Ok(tree)) = tree {
            tree.each_name(&mut |name| {
                if self.named.worth.contains_key(name) && names.iter().all(|n| n != name) {
                    names.push(name.to_owned());
                }
            });
        }
        names
    }

    /// The text that [`Scene::with_value`] puts there for another number in the same unit.
    #[must_use]
    pub fn with_number(&self, number: f64) -> String {
        self.written(&number.to_string())
    }

    /// The text for another number in the same unit.
    pub(crate) fn written(&self, literal: &str) -> String {
        match self.measure.units(self.scene) {
            MeasureUnits::Rate(..) => format!("{literal} {}", self.unit),
            MeasureUnits::Length | MeasureUnits::Angle | MeasureUnits::Scales(_) => {
                // A parameter keeps its unit: formulas count on it.
                let kept = self
                    .dimension
                    .filter(|_| self.measure == Measure::Parameter);
                kept.map_or_else(
                    || literal.to_owned(),
                    |unit| quoted(&format!("{literal} {}", unit.written(self.scene.symbol()))),
                )
            }
        }
    }
}

impl Scene {
    /// Every number that may be changed: parameters first, then all others in the order of the file. What the file
    /// leaves out is not among them.
    #[must_use]
    pub fn values(&self) -> Vec<Value> {
        let mut found = collector::values(self);
        found.sort_by_key(|value| (value.measure != Measure::Parameter, value.place.start));
        tell_apart(&mut found);
        found
    }

    /// The value of a name, with a dot or a blank between its words: `a`, `r3.length`, `driver speed`.
    ///
    /// # Errors
    /// In words: there is none, and which was probably meant.
    pub fn value_named(&self, name: &str) -> Result<Value, String> {
        let sought = dotted(name.trim());
        let mut values = self.values();
        let names: Vec<String> = values.iter().map(Value::dotted).collect();
        match names.iter().position(|name| *name == sought) {
            Some(found) => Ok(values.swap_remove(found)),
            None => {
                let meant = did_you_mean(&sought, names.iter().map(String::as_str));
                Err(words().no_value_named(&sought, meant.as_deref()))
            }
        }
    }

    /// The text with another text for one of its [`Scene::values`], every other byte as it was. Whether
    /// that is a scene is for [`Scene::parse`] to say.
    #[must_use]
    pub fn with_value(&self, value: &Value, text: &str) -> String {
        self.with_values(&[(value.clone(), text.to_owned())])
    }

    /// The same for some values of this scene at once.
    #[must_use]
    pub fn with_values(&self, texts: &[(Value, String)]) -> String {
        let mut edits = Edits::default();
        for (value, text) in texts {
            let text = if value.quotes {
                format!("\"{text}\"")
            } else {
                text.clone()
            };
            edits.replace(value.place.clone(), text);
        }
        edits.made_in(self.text())
    }
}

fn dotted(name: &str) -> String {
    name.replace(' ', ".")
}

/// A formula as a text of TOML: what one may hold needs no escapes.
pub(super) fn quoted(formula: &str) -> String {
    format!("\"{formula}\"")
}

/// Elements are named freely: `motor torque` may be the motor's, and what acts on a link `motor`.
fn tell_apart(values: &mut [Value]) {
    let mut met = HashMap::<String, usize>::new();
    for value in values {
        let times = met.entry(value.name.clone()).or_default();
        *times += 1;
        if *times > 1 {
            value.name = format!("{} ({times})", value.name);
        }
    }
}

#[cfg(test)]
mod tests;
