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
use crate::document::Lenient;
use serde::Deserialize;
use std::collections::HashMap;
use std::ops::Range;
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
}

/// A number of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// For people: `A x`, `r2 length`, `driver speed`. No two values of a scene have the same.
    pub name: String,
    /// What it belongs to.
    pub owner: ValueOwner,
    /// What it measures.
    pub measure: Measure,
    /// The number, in `unit`.
    pub number: f64,
    /// The number as the file writes it.
    pub literal: String,
    /// The unit in which the file has it.
    pub unit: &'static str,
    /// The bytes of the text that [`Scene::with_value`] replaces.
    pub place: Range<usize>,
    /// The scene's unit of length.
    pub(super) scene: Unit,
    /// Whether what is put there needs quotes of its own.
    quotes: bool,
}

impl Value {
    /// The text that stands in the file for this value: a number, of a rate with its unit.
    #[must_use]
    pub fn text(&self) -> String {
        self.written(&self.literal)
    }

    /// The text for another number in the same unit.
    pub(super) fn written(&self, literal: &str) -> String {
        match self.measure.units(self.scene) {
            MeasureUnits::Rate(..) => format!("{literal} {}", self.unit),
            MeasureUnits::Length | MeasureUnits::Angle | MeasureUnits::Scales(_) => {
                literal.to_owned()
            }
        }
    }
}

impl Scene {
    /// Every number that may be changed, in the order of the file. What the file leaves out is not
    /// among them.
    #[must_use]
    pub fn values(&self) -> Vec<Value> {
        let Ok(root) = DeTable::parse(self.text()) else {
            // It was read once before.
            return Vec::new();
        };
        let mut collector = Collector {
            text: self.text(),
            unit: self.unit,
            turns: matches!(self.mechanism.driver().input, Input::Turn(_)),
            owner: ValueOwner::Scene,
            met: HashMap::new(),
            found: Vec::new(),
        };
        collector.table(keys::SCENE, "", root.get_ref(), "");
        let mut found = collector.found;
        found.sort_by_key(|value| value.place.start);
        tell_apart(&mut found);
        found
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
    /// Whether a link is driven, and no slide.
    turns: bool,
    /// What the values that are found now belong to.
    owner: ValueOwner,
    /// How often each load and each spring was met.
    met: HashMap<String, usize>,
    found: Vec<Value>,
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
            KeyKind::Knots(sizes, called) => self.knots(&name, again, (sizes, called), value),
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
                self.of(ValueOwner::Element(name.to_owned()), |its| {
                    its.inner(keys, name, value);
                });
            }),
            KeyKind::List(keys) => {
                let tables = items(value).filter_map(|item| item.get_ref().as_table());
                tables.for_each(|table| self.acting(keys, table));
            }
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
        let read = Lenient::deserialize(ValueDeserializer::from(value.clone()));
        let number = read.map(|value| number_of(self.text, &value).ok());
        let Ok(Some(number)) = number else { return };
        let measure = size.measure(self.turns);
        let place = value.span();
        self.found.push(Value {
            name,
            owner: self.owner.clone(),
            measure,
            number,
            literal: self.text[place.clone()].to_owned(),
            unit: measure.unit(self.unit),
            place,
            scene: self.unit,
            quotes: false,
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
        let (Ok(parsed), Some(unit)) = (number.parse(), unit) else {
            return;
        };
        self.found.push(Value {
            name: name.to_owned(),
            owner: self.owner.clone(),
            measure,
            number: parsed,
            literal: number.into_owned(),
            unit,
            place: if quotes { whole } else { inner },
            scene: self.unit,
            quotes,
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
