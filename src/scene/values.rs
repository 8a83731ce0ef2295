//! Every number of a scene that a person may change, with its place in the text.
//!
//! A value is changed in the text, and the text is read again: what may stand there is said in one
//! place, by the reader of scenes, and comments, order and blanks stay as they are.

use super::rate::{self, Degree, Kind, number_length};
use super::reader::{Value as Item, number_of};
use super::rewrite::Edits;
use super::{Scene, Unit};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// What a value measures, and what it may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// A distance, positive, in the scene's unit.
    Length,
    /// A coordinate or a slide's position, in the scene's unit.
    Coordinate,
    /// A rough coordinate of `[start]`, in the scene's unit: it chooses the assembly.
    Start,
    /// In degrees, counter-clockwise.
    Angle,
    /// How fast the driver turns, with a unit of its own.
    TurnSpeed,
    /// How its speed changes.
    TurnAcceleration,
    /// How fast the driver is pushed, with a unit of its own.
    PushSpeed,
    /// How its speed changes.
    PushAcceleration,
    /// In kg, not negative.
    Mass,
    /// In kg m^2, not negative.
    Inertia,
    /// In N.
    Force,
    /// In N m.
    Torque,
    /// In m/s^2.
    Gravity,
}

impl Measure {
    /// What kind of rate it is, of the driver's speed and acceleration.
    pub(super) fn rate(self, unit: Unit) -> Option<(Kind, Degree)> {
        match self {
            Measure::TurnSpeed => Some((Kind::Turn, Degree::Speed)),
            Measure::TurnAcceleration => Some((Kind::Turn, Degree::Acceleration)),
            Measure::PushSpeed => Some((Kind::Push(unit), Degree::Speed)),
            Measure::PushAcceleration => Some((Kind::Push(unit), Degree::Acceleration)),
            Measure::Length
            | Measure::Coordinate
            | Measure::Start
            | Measure::Angle
            | Measure::Mass
            | Measure::Inertia
            | Measure::Force
            | Measure::Torque
            | Measure::Gravity => None,
        }
    }

    /// The unit in which the file has it; a rate brings its own.
    fn unit(self, scene: Unit) -> &'static str {
        match self {
            Measure::Length | Measure::Coordinate | Measure::Start => scene.symbol(),
            Measure::Angle => "deg",
            Measure::Mass => "kg",
            Measure::Inertia => "kg m^2",
            Measure::Force => "N",
            Measure::Torque => "N m",
            Measure::Gravity => "m/s^2",
            Measure::TurnSpeed
            | Measure::TurnAcceleration
            | Measure::PushSpeed
            | Measure::PushAcceleration => "",
        }
    }
}

/// A number of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// For people: `A x`, `r2 length`, `driver speed`. No two values of a scene have the same.
    pub name: String,
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
        match self.measure.rate(self.scene) {
            Some(_) => format!("{literal} {}", self.unit),
            None => literal.to_owned(),
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
            found: Vec::new(),
        };
        for (key, value) in root.get_ref() {
            collector.section(key.get_ref(), value);
        }
        let mut found = collector.found;
        found.sort_by_key(|value| value.place.start);
        tell_apart(&mut found);
        found
    }

    /// The text with another text for one of its [`Scene::values`], every other byte as it was. Whether
    /// that is a scene is for [`Scene::parse`] to say.
    #[must_use]
    pub fn with_value(&self, value: &Value, text: &str) -> String {
        let text = if value.quotes {
            format!("\"{text}\"")
        } else {
            text.to_owned()
        };
        let mut edits = Edits::default();
        edits.replace(value.place.clone(), text);
        edits.made_in(self.text())
    }
}

/// Several loads may act on the same point: the second is `C force x (2)`.
fn tell_apart(values: &mut [Value]) {
    let mut met = std::collections::HashMap::<String, usize>::new();
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
    found: Vec<Value>,
}

impl Collector<'_> {
    fn section(&mut self, key: &str, value: &Item<'_>) {
        match key {
            "ground" => self.places(value, "", Measure::Coordinate),
            "start" => self.places(value, " start", Measure::Start),
            "gravity" => self.pair("gravity".into(), Measure::Gravity, value),
            "driver" => self.driver(value),
            "links" => each(value, |name, link| self.link(name, link)),
            "slides" => each(value, |name, slide| self.slide(name, slide)),
            "loads" => {
                let loads = value.get_ref().as_array();
                let loads = loads.into_iter().flat_map(|loads| loads.iter());
                loads
                    .filter_map(|l| l.get_ref().as_table())
                    .for_each(|l| self.load(l));
            }
            // Names and texts.
            _ => {}
        }
    }

    fn places(&mut self, section: &Item<'_>, what: &str, measure: Measure) {
        each(section, |name, at| {
            self.pair(format!("{name}{what}"), measure, at);
        });
    }

    fn driver(&mut self, section: &Item<'_>) {
        let Some(table) = section.get_ref().as_table() else {
            return;
        };
        let turns = table.contains_key("link");
        each(section, |key, value| match (key, turns) {
            ("angle", _) => self.number("driver angle".into(), Measure::Angle, value),
            ("position", _) => {
                self.number("driver position".into(), Measure::Coordinate, value);
            }
            ("speed", true) => self.rate("driver speed", Measure::TurnSpeed, value),
            ("speed", false) => self.rate("driver speed", Measure::PushSpeed, value),
            ("acceleration", true) => {
                self.rate("driver acceleration", Measure::TurnAcceleration, value);
            }
            ("acceleration", false) => {
                self.rate("driver acceleration", Measure::PushAcceleration, value);
            }
            _ => {}
        });
    }

    fn link(&mut self, link: &str, value: &Item<'_>) {
        each(value, |key, value| {
            let name = format!("{link} {key}");
            match key {
                "length" => self.number(name, Measure::Length, value),
                "mass" => self.number(name, Measure::Mass, value),
                "inertia" => self.number(name, Measure::Inertia, value),
                "com" => self.pair(name, Measure::Coordinate, value),
                "points" => each(value, |point, at| {
                    self.pair(format!("{link} {point}"), Measure::Coordinate, at);
                }),
                _ => {}
            }
        });
    }

    fn slide(&mut self, slide: &str, value: &Item<'_>) {
        each(value, |key, value| {
            let name = format!("{slide} {key}");
            match key {
                "angle" | "turn" => self.number(name, Measure::Angle, value),
                // A point by its name has no coordinates here.
                "through" => self.pair(name, Measure::Coordinate, value),
                _ => {}
            }
        });
    }

    fn load(&mut self, load: &DeTable<'_>) {
        let on = |key| load.get(key).and_then(|name| name.get_ref().as_str());
        if let (Some(point), Some(force)) = (on("point"), load.get("force")) {
            self.pair(format!("{point} force"), Measure::Force, force);
        }
        if let (Some(link), Some(torque)) = (on("link"), load.get("torque")) {
            self.number(format!("{link} torque"), Measure::Torque, torque);
        }
    }

    fn pair(&mut self, name: String, measure: Measure, value: &Item<'_>) {
        let Some(items) = value.get_ref().as_array() else {
            return;
        };
        for (axis, item) in ["x", "y"].into_iter().zip(items.iter()) {
            self.number(format!("{name} {axis}"), measure, item);
        }
    }

    fn number(&mut self, name: String, measure: Measure, value: &Item<'_>) {
        let Some(number) = number_of(value.get_ref()) else {
            return;
        };
        let place = value.span();
        self.found.push(Value {
            name,
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
    fn rate(&mut self, name: &str, measure: Measure, value: &Item<'_>) {
        let (Some(text), Some((kind, degree))) =
            (value.get_ref().as_str(), measure.rate(self.unit))
        else {
            return;
        };
        let whole = value.span();
        let inner = whole.start + 1..whole.end.saturating_sub(1);
        let quotes = self.text.get(inner.clone()) != Some(text);
        let text = text.trim();
        let (number, unit) = text.split_at(number_length(text));
        let mut units = rate::units(kind, degree).iter();
        let unit = units.find(|known| **known == unit.trim());
        let (Ok(parsed), Some(unit)) = (number.parse(), unit) else {
            return;
        };
        self.found.push(Value {
            name: name.to_owned(),
            measure,
            number: parsed,
            literal: number.to_owned(),
            unit,
            place: if quotes { whole } else { inner },
            scene: self.unit,
            quotes,
        });
    }
}

/// The entries of a table, if it is one.
fn each<'v>(value: &'v Item<'v>, mut take: impl FnMut(&str, &'v Item<'v>)) {
    if let DeValue::Table(table) = value.get_ref() {
        for (key, value) in table {
            take(key.get_ref(), value);
        }
    }
}

#[cfg(test)]
mod tests;
