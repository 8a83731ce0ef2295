//! Every number of a scene that a person may change, with its place in the text.
//!
//! A value is changed in the text, and the text is read again: what may stand there is said in one
//! place, by the reader of scenes, and comments, order and blanks stay as they are.

use super::keys::{self, KeyKind, NumberMeasure, SceneKey};
use super::measure::{Measure, MeasureUnits};
use super::rate::{self, Degree, WrittenRate};
use super::reader::number_of;
use super::rewrite::Edits;
use super::{Scene, Unit};
use crate::Input;
use crate::document::{Lenient, Misplaced, NamedNumbers};
use crate::expression::{self, Dimension};
use crate::nearest::did_you_mean;
use crate::wording::words;
use serde::Deserialize;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue, ValueDeserializer};

type SpannedValue<'t> = Spanned<DeValue<'t>>;

/// What a number of the scene belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
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
    /// The text that stands in the file for this value: a number, of a rate with its unit.
    #[must_use]
    pub fn text(&self) -> String {
        match (&self.formula, self.measure.units(self.scene)) {
            (None, _) | (_, MeasureUnits::Rate(..)) => self.written(&self.literal),
            (Some(formula), _) => quoted(formula),
        }
    }

    /// The value as it is where this text stands in its place; its number stays where that is a formula.
    #[cfg(feature = "tui")]
    pub(crate) fn with_text(&self, text: &str) -> Value {
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
        let Ok(root) = DeTable::parse(self.text()) else {
            // It was read once before.
            return Vec::new();
        };
        let mut collector = Collector {
            text: self.text(),
            unit: self.unit,
            slides: &self.slide_names,
            turns: matches!(self.mechanism.driver().input, Input::Turn(_)),
            is_torsion: false,
            owner: ValueOwner::Scene,
            met: HashMap::new(),
            found: Vec::new(),
            named: &self.named,
        };
        collector.table(keys::SCENE, "", root.get_ref(), "");
        let mut found = collector.found;
        found.sort_by_key(|value| (value.measure != Measure::Parameter, value.place.start));
        tell_apart(&mut found);
        found
    }

    /// The value of a name, with a dot or a blank between its words: `a`, `r3.length`, `driver speed`.
    ///
    /// # Errors
    /// In words: there is none, and which was probably meant.
    pub fn value_named(&self, name: &str) -> Result<Value, String> {
        let dotted = |name: &str| name.trim().replace(' ', ".");
        let sought = dotted(name);
        let mut values = self.values();
        let names: Vec<String> = values.iter().map(|value| dotted(&value.name)).collect();
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

/// Walks through a scene that was read before: what does not fit is passed over.
struct Collector<'t> {
    text: &'t str,
    unit: Unit,
    slides: &'t [String],
    /// Whether a link is driven, and no slide.
    turns: bool,
    /// Whether the table at hand is that of a torsion spring.
    is_torsion: bool,
    /// What the values that are found now belong to.
    owner: ValueOwner,
    /// How often each load and each spring was met.
    met: HashMap<String, usize>,
    found: Vec<Value>,
    /// What formulas may name.
    named: &'t Arc<NamedNumbers>,
}

impl Collector<'_> {
    /// The values of a table that is called `of`.
    fn table(&mut self, keys: &'static [SceneKey], of: &str, table: &DeTable<'_>, again: &str) {
        for (key, value) in table {
            if let Some(key) = keys::find(keys, key.get_ref()) {
                self.value(key, (of, key.name), value, again);
            }
        }
    }

    /// The values of a key: of what, and how they are called; `again` stands behind their names.
    fn value(
        &mut self,
        key: &SceneKey,
        (of, name): (&str, &str),
        value: &SpannedValue<'_>,
        again: &str,
    ) {
        let name = join(of, name);
        match key.kind {
            KeyKind::Text | KeyKind::Vectors | KeyKind::Formulas => {}
            KeyKind::Number(size) => self.number(name + again, size, value),
            KeyKind::Parameters => each(value, |parameter, at| {
                let size = NumberMeasure::Of(Measure::Parameter);
                self.of(ValueOwner::Parameter(parameter.to_owned()), |its| {
                    its.number(parameter.to_owned(), size, at);
                });
            }),
            KeyKind::Ends(size) => self.ends(&name, again, size, value),
            KeyKind::Limits(keys) => each(value, |name, value| self.limit(keys, name, value)),
            // A point by its name has no coordinates here.
            KeyKind::Pair(size) => self.pair(&name, again, size, value),
            KeyKind::Rate(degree) => self.rate(&name, degree, value),
            KeyKind::Place => self.place(&name, again, value),
            KeyKind::Places => each(value, |point, at| {
                let name = join(of, point);
                self.of(ValueOwner::Element(point.to_owned()), |its| {
                    its.place(&name, again, at);
                });
            }),
            KeyKind::Steps(keys) => {
                for (number, step) in items(value).enumerate() {
                    let called = format!("{of} step {}", number + 1);
                    self.inner(keys, &called, step);
                }
            }
            KeyKind::Knots(sizes, called) => self.knots(&name, again, (sizes, called), value),
            KeyKind::Numbers(size) => {
                // `[tolerances]` has a tolerance for each point.
                let called = key.name.trim_end_matches('s');
                each(value, |point, number| {
                    let name = join(point, called);
                    self.of(ValueOwner::Element(point.to_owned()), |its| {
                        its.number(name, size, number);
                    });
                });
            }
            KeyKind::Points(size) => {
                // Where a point starts is not where it is.
                let start = if key.name == "start" { " start" } else { "" };
                each(value, |point, at| {
                    let name = join(of, point) + start;
                    self.of(ValueOwner::Element(point.to_owned()), |its| {
                        its.pair(&name, "", size, at);
                    });
                });
            }
            KeyKind::Table(keys) => {
                let owner = match key.name {
                    "driver" => ValueOwner::Driver,
                    _ => ValueOwner::Scene,
                };
                self.of(owner, |its| its.inner(keys, key.name, value));
            }
            KeyKind::Each(keys) => each(value, |name, value| {
                let turns = self.turns;
                if key.name == "inputs" {
                    self.turns = !self.slides.iter().any(|slide| slide == name);
                }
                self.of(ValueOwner::Element(name.to_owned()), |its| {
                    its.inner(keys, name, value);
                });
                self.turns = turns;
            }),
            KeyKind::List(keys) => {
                let tables = items(value).filter_map(|item| item.get_ref().as_table());
                tables.for_each(|table| self.acting(keys, table));
            }
        }
    }

    /// A limit of a slide or a link that it is named after, or of the angle of a link.
    fn limit(&mut self, keys: &'static [SceneKey], name: &str, value: &SpannedValue<'_>) {
        let called = format!("{name} limit");
        if let Some(table) = value.get_ref().as_table() {
            let link = table.get("link").and_then(|link| link.get_ref().as_str());
            let owner = ValueOwner::Element(link.unwrap_or(name).to_owned());
            return self.of(owner, |its| its.table(keys, &called, table, ""));
        }
        let measure = match self.slides.iter().any(|slide| slide == name) {
            true => Measure::Coordinate,
            false => Measure::Angle,
        };
        self.of(ValueOwner::Element(name.to_owned()), |its| {
            its.ends(&called, "", NumberMeasure::Of(measure), value);
        });
    }

    fn ends(&mut self, name: &str, behind: &str, size: NumberMeasure, value: &SpannedValue<'_>) {
        for (end, item) in ["low", "high"].into_iter().zip(items(value)) {
            self.number(format!("{name} {end}{behind}"), size, item);
        }
    }

    /// What is found meanwhile belongs to this.
    fn of(&mut self, owner: ValueOwner, find: impl FnOnce(&mut Self)) {
        let before = std::mem::replace(&mut self.owner, owner);
        find(self);
        self.owner = before;
    }

    fn inner(&mut self, keys: &'static [SceneKey], name: &str, value: &SpannedValue<'_>) {
        if let Some(table) = value.get_ref().as_table() {
            self.table(keys, name, table, "");
        }
    }

    /// The values of a spring or a load: it has no name, but what it acts on has.
    fn acting(&mut self, keys: &'static [SceneKey], table: &DeTable<'_>) {
        let name = |key| table.get(key)?.get_ref().as_str();
        if let (Some(from), Some(to)) = (name("from"), name("to")) {
            let of = format!("spring {from}-{to}");
            let again = self.again(&of);
            let owner = ValueOwner::Between(from.to_owned(), to.to_owned());
            return self.of(owner, |its| its.table(keys, &of, table, &again));
        }
        if let (Some(link), false) = (name("link"), table.contains_key("torque")) {
            let of = format!("spring {link}-{}", name("to").unwrap_or("ground"));
            let again = self.again(&of);
            let owner = ValueOwner::Element(link.to_owned());
            self.is_torsion = true;
            self.of(owner, |its| its.table(keys, &of, table, &again));
            self.is_torsion = false;
            return;
        }
        let on = ["point", "link", "slide"].into_iter().find_map(name);
        let mut sizes = ["force", "torque", "press"].into_iter();
        let (Some(on), Some(size)) = (on, sizes.find(|size| table.contains_key(*size))) else {
            return;
        };
        let what = join(on, size);
        let again = self.again(&what);
        self.of(ValueOwner::Element(on.to_owned()), |its| {
            for (key, value) in table {
                if let Some(key) = keys::find(keys, key.get_ref()) {
                    // The factors of a load are called by its size.
                    let called = if key.name == "over" { size } else { key.name };
                    its.value(key, (on, called), value, &again);
                }
            }
        });
    }

    /// Knots, counted from 1: where each lies, and what is there.
    fn knots(
        &mut self,
        what: &str,
        again: &str,
        (sizes, called): ([NumberMeasure; 2], &str),
        list: &SpannedValue<'_>,
    ) {
        for (i, knot) in items(list).enumerate() {
            let parts = items(knot).zip(["at", called]).zip(sizes);
            for ((item, part), size) in parts {
                let name = format!("{what} knot {} {part}{again}", i + 1);
                self.number(name, size, item);
            }
        }
    }

    /// Several loads may act on the same point: every number of the second ends with ` (2)`.
    fn again(&mut self, what: &str) -> String {
        let times = self.met.entry(what.to_owned()).or_default();
        *times += 1;
        match *times {
            1 => String::new(),
            times => format!(" ({times})"),
        }
    }

    fn pair(&mut self, name: &str, behind: &str, size: NumberMeasure, value: &SpannedValue<'_>) {
        for (axis, item) in ["x", "y"].into_iter().zip(items(value)) {
            self.number(format!("{name} {axis}{behind}"), size, item);
        }
    }

    /// A place on a link: coordinates, or a length and an angle.
    fn place(&mut self, name: &str, again: &str, value: &SpannedValue<'_>) {
        match value.get_ref().as_table() {
            Some(table) => self.table(keys::PLACE, name, table, again),
            None => self.pair(name, again, NumberMeasure::Of(Measure::Coordinate), value),
        }
    }

    fn number(&mut self, name: String, size: NumberMeasure, value: &SpannedValue<'_>) {
        let Ok(read) = Lenient::deserialize(ValueDeserializer::from(value.clone())) else {
            return;
        };
        let place = value.span();
        let (number, formula, dimension) = match number_of(self.text, &read) {
            Ok(number) => (number, None, None),
            Err(Misplaced::Text(text)) => {
                let Ok(found) = self.named.worth_of_text(text) else {
                    return;
                };
                let number = found.value.hi + 0.0;
                (number, Some(text.clone()), found.dimension)
            }
            Err(_) => return,
        };
        let measure = match (size.measure(self.turns), self.is_torsion) {
            (measure, true) => measure.of_torsion(),
            (measure, false) => measure,
        };
        let written = || self.text[place.clone()].to_owned();
        self.found.push(Value {
            name,
            owner: self.owner.clone(),
            measure,
            number,
            literal: formula.clone().unwrap_or_else(written),
            formula,
            unit: measure.unit(self.unit),
            place,
            scene: self.unit,
            quotes: false,
            dimension,
            named: Arc::clone(self.named),
        });
    }

    /// A number and a unit in quotes. The quotes stay as they are, unless what is between them is
    /// written with escapes.
    fn rate(&mut self, name: &str, degree: Degree, value: &SpannedValue<'_>) {
        let measure = Measure::of_rate(degree, self.turns);
        let (Some(text), MeasureUnits::Rate(kind, degree)) =
            (value.get_ref().as_str(), measure.units(self.unit))
        else {
            return;
        };
        let whole = value.span();
        let inner = whole.start + 1..whole.end.saturating_sub(1);
        let quotes = self.text.get(inner.clone()) != Some(text);
        let WrittenRate { number, unit } = WrittenRate::of(text);
        let mut units = rate::units(kind, degree).iter();
        let unit = units.find(|known| **known == unit);
        let (parsed, literal, formula, unit) = match (number.parse(), unit) {
            (Ok(parsed), Some(unit)) => (parsed, number.into_owned(), None, *unit),
            _ => {
                let Some((formula, unit)) = rate::formula(text, kind, degree) else {
                    return;
                };
                let Ok(found) = self.named.worth_of_text(formula) else {
                    return;
                };
                let formula = formula.to_owned();
                (found.value.hi + 0.0, formula.clone(), Some(formula), unit)
            }
        };
        self.found.push(Value {
            name: name.to_owned(),
            owner: self.owner.clone(),
            measure,
            number: parsed,
            literal,
            formula,
            unit,
            place: if quotes { whole } else { inner },
            scene: self.unit,
            quotes,
            dimension: None,
            named: Arc::clone(self.named),
        });
    }
}

/// The items of a list, if it is one.
fn items<'v>(value: &'v SpannedValue<'v>) -> impl Iterator<Item = &'v SpannedValue<'v>> {
    let items = value.get_ref().as_array();
    items.into_iter().flat_map(|items| items.iter())
}

/// The name of what belongs to something, which itself may have none.
fn join(of: &str, name: &str) -> String {
    if of.is_empty() {
        name.to_owned()
    } else {
        format!("{of} {name}")
    }
}

/// The entries of a table, if it is one.
fn each<'v>(value: &'v SpannedValue<'v>, mut take: impl FnMut(&str, &'v SpannedValue<'v>)) {
    if let DeValue::Table(table) = value.get_ref() {
        for (key, value) in table {
            take(key.get_ref(), value);
        }
    }
}

#[cfg(test)]
mod tests;
