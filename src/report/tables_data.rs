//! The tables for other programs: CSV, a line per figure, and JSON.

use super::answers::Answers;
use super::csv_dialect::{CsvDialect, CsvSheet};
use super::entry::Entry;
use super::forces::Forces;
use super::number::shortest;
use super::tables::{ORDERS, PointRow, Tables, VectorColumn};
use super::tables_page::{TableStyle, index};
use crate::quantity::{Aspect, state_word};
use crate::solver::Order;
use serde_json::{Map, Value, json};
use std::io::{self, Write};

/// The names and aspects of a point's figures: both components, magnitude and direction.
fn point_aspects(order: Order) -> [(&'static str, Aspect); 4] {
    match order {
        Order::Position => [
            ("x", Aspect::X),
            ("y", Aspect::Y),
            ("r", Aspect::X),
            ("r.angle", Aspect::Angle),
        ],
        Order::Velocity => [
            ("vx", Aspect::Vx),
            ("vy", Aspect::Vy),
            ("v", Aspect::Vx),
            ("v.angle", Aspect::Angle),
        ],
        Order::Acceleration | Order::Force => [
            ("ax", Aspect::Ax),
            ("ay", Aspect::Ay),
            ("a", Aspect::Ax),
            ("a.angle", Aspect::Angle),
        ],
    }
}

fn point_entries(point: &PointRow, order: Order) -> [Entry; 4] {
    let plane = point.motion[index(order)];
    let none = Entry {
        given: point.fixed,
        ..Entry::NONE
    };
    plane.map_or([none; 4], |plane| plane.entries(point.fixed))
}

/// A vector's figures in the order of the catalogue's columns.
fn vector_figures(vector: &VectorColumn) -> impl Iterator<Item = (Aspect, Entry)> {
    let lengths = vector.length.into_iter().flatten();
    let lengths = Aspect::STRETCHING.into_iter().zip(lengths);
    lengths.chain(Aspect::TURNING.into_iter().zip(vector.direction))
}

impl Tables {
    /// One line per figure: `name,value,unit,entry`, where `entry` tells given from found. Behind them,
    /// where that was asked for, the `bound` of its error, and the `sensitivity`, the length that matters
    /// `most` and the derivative `by` it.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_csv(
        &self,
        style: TableStyle,
        dialect: CsvDialect,
        to: impl Write,
    ) -> io::Result<()> {
        let mut lines = TableCsv {
            csv: CsvSheet::new(dialect, to),
            style,
            answers: self.answers.as_ref(),
        };
        let answer = ["sensitivity", "most", "by"];
        lines.record(["name", "value", "unit", "entry"], "bound", answer)?;
        for (name, value, unit) in self.driver_figures() {
            lines.figure(&name, &unit, Entry::given(value))?;
        }
        for vector in &self.vectors {
            for (aspect, entry) in vector_figures(vector) {
                let name = format!("{}.{}", vector.name, aspect.name());
                lines.figure(&name, &aspect.unit(self.unit), entry)?;
            }
        }
        for point in &self.points {
            for order in ORDERS {
                let figures = point_aspects(order).into_iter();
                for ((figure, aspect), entry) in figures.zip(point_entries(point, order)) {
                    let name = format!("{}.{figure}", point.name);
                    lines.figure(&name, &aspect.unit(self.unit), entry)?;
                }
            }
        }
        for (name, unit, entry) in self.forces.iter().flat_map(Forces::figures) {
            lines.figure(&name, unit, entry)?;
        }
        let state = ["state", state_word(self.condition), "", ""];
        lines.record(state, "", [""; 3])?;
        lines.csv.finish()
    }

    fn driver_figures(&self) -> [(String, f64, String); 3] {
        let aspects = self.driver.aspects();
        std::array::from_fn(|i| {
            let figure = match aspects[i] {
                Aspect::Length => "position",
                aspect => aspect.name(),
            };
            let unit = aspects[i].unit(self.unit);
            (format!("driver.{figure}"), self.driver.values[i], unit)
        })
    }

    /// One object: the driver, the vectors and the points, keyed as the columns of a sweep are
    /// named, bounds among them where they were asked for; a value that does not exist is `null`.
    #[must_use]
    pub fn to_json(&self, style: TableStyle) -> Value {
        let mut object = Map::new();
        object.insert("scene".into(), self.scene.as_str().into());
        if style.units {
            object.insert("units".into(), self.units());
        }
        object.insert("driver".into(), self.driver_json());
        object.insert("state".into(), state_word(self.condition).into());
        let vectors = self.vectors.iter().map(|v| vector_json(v, style.bounds));
        object.insert("vectors".into(), vectors.collect());
        let points = self.points.iter().map(|p| point_json(p, style.bounds));
        object.insert("points".into(), points.collect());
        if let Some(forces) = &self.forces {
            object.insert("forces".into(), forces.to_json(style.bounds));
        }
        if let Some(answers) = &self.answers {
            object.insert("sensitivity".into(), answers.to_json(style.units));
        }
        Value::Object(object)
    }

    /// What is driven, and its coordinate with both rates.
    pub(super) fn driver_json(&self) -> Value {
        let mut driver = Map::new();
        driver.insert("name".into(), self.driver.name.as_str().into());
        if let Some(from) = &self.driver.from {
            driver.insert("from".into(), from.as_str().into());
        }
        for (name, value, _) in self.driver_figures() {
            let key = name.trim_start_matches("driver.").to_owned();
            driver.insert(key, number(Some(value)));
        }
        Value::Object(driver)
    }

    fn units(&self) -> Value {
        let unit = |aspect: Aspect| aspect.unit(self.unit);
        let mut units = json!({
            "length": unit(Aspect::Length),
            "velocity": unit(Aspect::Rate),
            "acceleration": unit(Aspect::Accel),
            "angle": unit(Aspect::Angle),
            "omega": unit(Aspect::Omega),
            "alpha": unit(Aspect::Alpha),
        });
        if let (Some(units), Some(_)) = (units.as_object_mut(), &self.forces) {
            units.insert("force".into(), unit(Aspect::Force).into());
            units.insert("torque".into(), unit(Aspect::Torque).into());
            units.insert("power".into(), unit(Aspect::Power).into());
        }
        units
    }
}

/// A double as JSON, a negative zero without its sign.
pub(super) fn number(value: Option<f64>) -> Value {
    value.map_or(Value::Null, |value| (value + 0.0).into())
}

fn vector_json(vector: &VectorColumn, bounds: bool) -> Value {
    let mut object = Map::new();
    object.insert("name".into(), vector.name.as_str().into());
    let mut given = Vec::new();
    for (aspect, entry) in vector_figures(vector) {
        insert(&mut object, aspect.name(), &entry, bounds);
        if entry.given {
            given.push(Value::from(aspect.name()));
        }
    }
    object.insert("given".into(), given.into());
    Value::Object(object)
}

fn point_json(point: &PointRow, bounds: bool) -> Value {
    let mut object = Map::new();
    object.insert("name".into(), point.name.as_str().into());
    object.insert("fixed".into(), point.fixed.into());
    for order in ORDERS {
        let entries = point_entries(point, order);
        for ((name, _), entry) in point_aspects(order).into_iter().zip(&entries) {
            insert(&mut object, name, entry, bounds);
        }
    }
    Value::Object(object)
}

/// A figure, and behind it what its error does not exceed.
fn insert(object: &mut Map<String, Value>, name: &str, entry: &Entry, bounds: bool) {
    object.insert(name.into(), number(entry.value));
    if bounds {
        object.insert(format!("{name}.bound"), number(entry.proved()));
    }
}

struct TableCsv<'a, W: Write> {
    csv: CsvSheet<W>,
    style: TableStyle,
    answers: Option<&'a Answers>,
}

impl<W: Write> TableCsv<'_, W> {
    /// What is always there, the bound, and what the lengths do.
    fn record(&mut self, cells: [&str; 4], bound: &str, answer: [&str; 3]) -> io::Result<()> {
        let [name, value, unit, entry] = cells;
        let unit = self.style.units.then_some(unit);
        let bound = self.style.bounds.then_some(bound);
        let answer = self.answers.map(|_| answer);
        let cells = [name, value].into_iter().chain(unit).chain([entry]);
        let cells = cells.chain(bound).chain(answer.into_iter().flatten());
        self.csv.record(cells)
    }

    fn figure(&mut self, name: &str, unit: &str, figure: Entry) -> io::Result<()> {
        let entry = if figure.given { "given" } else { "found" };
        let answer = self.answers.and_then(|answers| answers.of(name));
        let most = answer.and_then(|answer| answer.most.as_ref());
        let length = most.map_or("", |(length, _)| length);
        let value = cell(figure.value);
        let bound = cell(figure.proved());
        let worst = cell(answer.map(|answer| answer.worst));
        let by = cell(most.map(|(_, derivative)| *derivative));
        let cells = [name, &value, unit, entry];
        self.record(cells, &bound, [&worst, length, &by])
    }
}

/// The shortest form of a value; nothing where none exists.
pub(super) fn cell(value: Option<f64>) -> String {
    let mut text = String::new();
    if let Some(value) = value {
        shortest(value, &mut text);
    }
    text
}
