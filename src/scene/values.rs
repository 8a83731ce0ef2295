//! Every number of a scene that a person may change, with its place in the text.
//!
//! A value is changed in the text, and the text is read again: what may stand there is said in one
//! place, by the reader of scenes, and comments, order and blanks stay as they are.

use super::rate::{self, Degree, Kind, number_length};
use super::reader::{Value as Item, number_of};
use super::rewrite::Edits;
use super::{Scene, Unit};
use crate::Input;
use std::collections::HashMap;
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// What a value measures, and what it may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// A distance, positive, in the scene's unit; the length of a spring without a force may be 0, and
    /// so may a misfit.
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
    /// In N/m, not negative.
    Stiffness,
    /// In N s/m, not negative.
    Damping,
    /// A plain number: the part of a load that acts, or of a speed by which it fluctuates.
    Factor,
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
            | Measure::Gravity
            | Measure::Stiffness
            | Measure::Damping
            | Measure::Factor => None,
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
            Measure::Stiffness => "N/m",
            Measure::Damping => "N s/m",
            Measure::Factor
            | Measure::TurnSpeed
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
            turns: matches!(self.mechanism.driver().input, Input::Turn(_)),
            met: HashMap::new(),
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
    /// How often each load and each spring was met.
    met: HashMap<String, usize>,
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
            "loads" => tables(value).for_each(|load| self.load(load)),
            "springs" => tables(value).for_each(|spring| self.spring(spring)),
            "motor" => self.motor(value),
            "redundant" => each(value, |key, value| {
                self.number(format!("redundant {key}"), Measure::Length, value);
            }),
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
        each(section, |key, value| match (key, self.turns) {
            ("angle", _) => self.number("driver angle".into(), Measure::Angle, value),
            ("position", _) => {
                self.number("driver position".into(), Measure::Coordinate, value);
            }
            ("speed", _) => self.rate("driver speed", self.speed(), value),
            ("acceleration", true) => {
                self.rate("driver acceleration", Measure::TurnAcceleration, value);
            }
            ("acceleration", false) => {
                self.rate("driver acceleration", Measure::PushAcceleration, value);
            }
            _ => {}
        });
    }

    /// What the speed of the driver, and of its motor, measures.
    fn speed(&self) -> Measure {
        if self.turns {
            Measure::TurnSpeed
        } else {
            Measure::PushSpeed
        }
    }

    fn motor(&mut self, section: &Item<'_>) {
        let effort = if self.turns {
            Measure::Torque
        } else {
            Measure::Force
        };
        each(section, |key, value| {
            let name = format!("motor {key}");
            match key {
                "torque" | "force" | "peak" => self.number(name, effort, value),
                "speed" => self.rate(&name, self.speed(), value),
                "flywheel" => self.number(name, Measure::Inertia, value),
                "fluctuation" => self.number(name, Measure::Factor, value),
                "tolerance" => self.number(name, Measure::Length, value),
                _ => {}
            }
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
        let on = ["point", "link", "slide"].map(|key| name_in(load, key));
        let Some(on) = on.into_iter().flatten().next() else {
            return;
        };
        let sizes = ["force", "torque", "press"].map(|key| Some((key, load.get(key)?)));
        let Some((size, value)) = sizes.into_iter().flatten().next() else {
            return;
        };
        let what = format!("{on} {size}");
        let again = self.again(&what);
        match size {
            "force" => {
                for (axis, item) in ["x", "y"].into_iter().zip(items(value)) {
                    self.number(format!("{what} {axis}{again}"), Measure::Force, item);
                }
            }
            "torque" => self.number(format!("{what}{again}"), Measure::Torque, value),
            _ => self.knots(&what, &again, (Measure::Coordinate, Measure::Force), value),
        }
        if let Some(over) = load.get("over") {
            let coordinate = if self.turns {
                Measure::Angle
            } else {
                Measure::Coordinate
            };
            self.knots(&what, &again, (coordinate, Measure::Factor), over);
        }
    }

    /// The knots of a load, counted from 1: where each lies, and what is there.
    fn knots(&mut self, what: &str, again: &str, measures: (Measure, Measure), list: &Item<'_>) {
        let value = if measures.1 == Measure::Factor {
            "factor"
        } else {
            "size"
        };
        for (i, knot) in items(list).enumerate() {
            let knots = items(knot).zip([("at", measures.0), (value, measures.1)]);
            for (item, (part, measure)) in knots {
                let name = format!("{what} knot {} {part}{again}", i + 1);
                self.number(name, measure, item);
            }
        }
    }

    fn spring(&mut self, spring: &DeTable<'_>) {
        let (Some(from), Some(to)) = (name_in(spring, "from"), name_in(spring, "to")) else {
            return;
        };
        let what = format!("spring {from}-{to}");
        let again = self.again(&what);
        for (key, value) in spring {
            let name = format!("{what} {}{again}", key.get_ref());
            match key.get_ref().as_ref() {
                "stiffness" => self.number(name, Measure::Stiffness, value),
                "length" => self.number(name, Measure::Length, value),
                "damping" => self.number(name, Measure::Damping, value),
                _ => {}
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

    fn pair(&mut self, name: String, measure: Measure, value: &Item<'_>) {
        for (axis, item) in ["x", "y"].into_iter().zip(items(value)) {
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

/// The items of a list, if it is one.
fn items<'v>(value: &'v Item<'v>) -> impl Iterator<Item = &'v Item<'v>> {
    let items = value.get_ref().as_array();
    items.into_iter().flat_map(|items| items.iter())
}

/// The tables of a list.
fn tables<'v>(value: &'v Item<'v>) -> impl Iterator<Item = &'v DeTable<'v>> {
    items(value).filter_map(|item| item.get_ref().as_table())
}

/// A name that a table gives.
fn name_in<'v>(table: &'v DeTable<'v>, key: &str) -> Option<&'v str> {
    table.get(key)?.get_ref().as_str()
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
