//! The editable numbers of a scene, with their places in the text.
//!
//! Editing a value changes the text, which is then parsed again. So the parser alone decides which
//! texts are valid, and comments, order and blanks stay unchanged.

mod collector;

use super::numbers::measure::{Measure, MeasureUnits};
use super::rewrite::Edits;
use super::{Scene, Unit};
use crate::document::NamedNumbers;
use crate::expression::{self, Dimension};
use crate::nearest::did_you_mean;
use crate::wording::words;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

/// The owner of a number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ValueOwner {
    /// The scene as a whole, as for gravity.
    Scene,
    /// The driver.
    Driver,
    /// The point, link or slide of this name; loads on an element belong to it.
    Element(String),
    /// The line from one point to another, as for a spring.
    Between(String, String),
    /// The parameter of this name.
    Parameter(String),
}

/// A number of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// The display name, unique in the scene: `A x`, `r2 length`, `driver speed`.
    pub name: String,
    /// The element that the number belongs to.
    pub owner: ValueOwner,
    /// The formula that it is computed from; `None` for a plain number.
    pub formula: Option<String>,
    /// The measured quantity.
    pub measure: Measure,
    /// The number, in `unit`.
    pub number: f64,
    /// The number or formula as written in the file.
    pub literal: String,
    /// The unit used in the file.
    pub unit: &'static str,
    /// The bytes of the text that [`Scene::with_value`] replaces.
    pub place: Range<usize>,
    /// The scene's unit of length.
    pub(crate) scene: Unit,
    /// Whether a replacement text needs quotes.
    quotes: bool,
    /// The dimension of its formula, if a unit determines it.
    pub(crate) dimension: Option<Dimension>,
    /// The names available to formulas.
    pub(crate) named: Arc<NamedNumbers>,
}

impl Value {
    /// Creates a value typed outside the scene, without a place in the text.
    pub(crate) fn outside_text(scene: &Scene, measure: Measure) -> Value {
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

    /// Returns the name used in columns and on the command line: `r2.length`.
    #[must_use]
    pub fn dotted(&self) -> String {
        dotted(&self.name)
    }

    /// Returns the unit shown in tables: that of the file, or of a parameter's formula.
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

    /// Returns the text of this value in the file; for a rate it includes the unit.
    #[must_use]
    pub fn text(&self) -> String {
        match (&self.formula, self.measure.units(self.scene)) {
            (None, _) | (_, MeasureUnits::Rate(..)) => self.written(&self.literal),
            (Some(formula), _) => quoted(formula),
        }
    }

    /// Returns the value after replacing its text. If the text is a formula, the number stays
    /// unchanged.
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

    /// Returns `true` if it is a literal number, with or without a unit.
    pub(crate) fn is_number(&self) -> bool {
        let tree = self.formula.as_deref().map(expression::parse);
        tree.is_none_or(|tree| tree.is_ok_and(|tree| tree.is_number()))
    }

    /// Returns the parameters named in its formula.
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

    /// Returns the text for [`Scene::with_value`] that represents another number in the same unit.
    #[must_use]
    pub fn with_number(&self, number: f64) -> String {
        self.written(&number.to_string())
    }

    /// Returns the text of another number in the same unit.
    pub(crate) fn written(&self, literal: &str) -> String {
        match self.measure.units(self.scene) {
            MeasureUnits::Rate(..) => format!("{literal} {}", self.unit),
            MeasureUnits::Length | MeasureUnits::Angle | MeasureUnits::Scales(_) => {
                // A parameter keeps its unit, because formulas depend on it.
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
    /// Returns every editable number: parameters first, then all others in the order of the file.
    /// Defaults not written in the file are excluded.
    #[must_use]
    pub fn values(&self) -> Vec<Value> {
        let mut found = collector::values(self);
        found.sort_by_key(|value| (value.measure != Measure::Parameter, value.place.start));
        make_names_unique(&mut found);
        found
    }

    /// Returns the value of a name with dots or blanks between its words: `a`, `r3.length`,
    /// `driver speed`.
    ///
    /// # Errors
    /// Returns a message for an unknown name, with a suggestion.
    pub fn value_named(&self, name: &str) -> Result<Value, String> {
        let sought = dotted(name.trim());
        let mut values = self.values();
        let names: Vec<String> = values.iter().map(Value::dotted).collect();
        match names.iter().position(|name| *name == sought) {
            Some(found) => Ok(values.swap_remove(found)),
            None => {
                let copied = |word| Some((word, self.original_of(word)?));
                if let Some((copy, original)) = sought.split('.').find_map(copied) {
                    return Err(words().edit_the_original(copy, original));
                }
                let intended = did_you_mean(&sought, names.iter().map(String::as_str));
                Err(words().no_value_named(&sought, intended.as_deref()))
            }
        }
    }

    /// Returns the text with one of its [`Scene::values`] replaced, and every other byte unchanged.
    /// [`Scene::parse`] decides whether the result is a scene.
    #[must_use]
    pub fn with_value(&self, value: &Value, text: &str) -> String {
        self.with_values(&[(value.clone(), text.to_owned())])
    }

    /// Returns the text with several values of this scene replaced.
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
        edits.rewritten_in(self.text())
    }
}

fn dotted(name: &str) -> String {
    name.replace(' ', ".")
}

/// Quotes a formula as TOML text; characters of a formula need no escapes.
pub(crate) fn quoted(formula: &str) -> String {
    format!("\"{formula}\"")
}

/// Makes display names unique. Elements may have any name: `motor torque` may belong to the motor,
/// or be the load on a link called `motor`.
fn make_names_unique(values: &mut [Value]) {
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
