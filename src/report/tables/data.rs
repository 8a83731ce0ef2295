//! Writes the tables for other programs: CSV with a line per value, and JSON.

use crate::quantity::{Aspect, state_word};
use crate::report::forces::Forces;
use crate::report::tables::answers::Answers;
use crate::report::tables::entry::Entry;
use crate::report::tables::page::TableStyle;
use crate::report::tables::{ORDERS, PointRow, Tables, VectorColumn, point_aspects, point_entries};
use crate::report::text::csv_dialect::{CsvDialect, CsvSheet, cell};
use crate::solver::Condition;
use serde_json::{Map, Value, json};
use std::io::{self, Write};

/// Returns a vector's values in the order of the catalogue's columns.
fn vector_figures(vector: &VectorColumn) -> impl Iterator<Item = (Aspect, Entry)> {
    let lengths = vector.length.into_iter().flatten();
    let lengths = Aspect::STRETCHING.into_iter().zip(lengths);
    lengths.chain(Aspect::TURNING.into_iter().zip(vector.direction))
}

impl Tables {
    /// Writes one line per value: `name,value,unit,entry`, where `entry` distinguishes given values
    /// from computed ones. If requested, the error `bound` follows, and the `sensitivity`, the
    /// length with the largest derivative (`most`) and that derivative (`by`).
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write_csv(
        &self,
        style: TableStyle,
        dialect: CsvDialect,
        to: impl Write,
    ) -> io::Result<()> {
        let answers = self.answers.as_ref();
        let mut lines = ValueSheet::new(style, dialect, answers, true, to)?;
        for (name, value, unit) in self.driver_figures() {
            lines.value(&name, &unit, Entry::given(value))?;
        }
        for vector in &self.vectors {
            for (aspect, entry) in vector_figures(vector) {
                let name = format!("{}.{}", vector.name, aspect.name());
                lines.value(&name, &aspect.unit(self.unit), entry)?;
            }
        }
        for point in &self.points {
            for order in ORDERS {
                let figures = point_aspects(order).into_iter();
                for ((figure, aspect), entry) in figures.zip(point_entries(point, order)) {
                    let name = format!("{}.{figure}", point.name);
                    lines.value(&name, &aspect.unit(self.unit), entry)?;
                }
            }
        }
        for (name, unit, entry) in self.forces.iter().flat_map(Forces::figures) {
            lines.value(&name, unit, entry)?;
        }
        lines.finish(self.condition)
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

    /// Returns one object: the driver, the vectors and the points, keyed as the columns of a sweep,
    /// with bounds if requested; a missing value is `null`.
    #[must_use]
    pub fn to_json(&self, style: TableStyle) -> Value {
        let mut object = self.head_json(style.units.then(|| self.units()));
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

    /// Returns the members that precede the values: the scene, the units if requested, the driver
    /// and the state.
    pub(in crate::report) fn head_json(&self, units: Option<Value>) -> Map<String, Value> {
        let mut object = Map::new();
        object.insert("scene".into(), self.scene.as_str().into());
        if let Some(units) = units {
            object.insert("units".into(), units);
        }
        object.insert("driver".into(), self.driver_json());
        object.insert("state".into(), state_word(self.condition).into());
        object
    }

    /// Returns the driven element, and its coordinate with both rates.
    fn driver_json(&self) -> Value {
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

/// Converts a double to JSON, without the sign of a negative zero.
pub(in crate::report) fn number(value: Option<f64>) -> Value {
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

/// Inserts a value, followed by its error bound if requested.
pub(in crate::report) fn insert(
    object: &mut Map<String, Value>,
    name: &str,
    entry: &Entry,
    bounds: bool,
) {
    object.insert(name.into(), number(entry.value));
    if bounds {
        object.insert(format!("{name}.bound"), number(entry.proved()));
    }
}

/// Writes a line per value as CSV: `name,value,unit`, and further cells if requested.
pub(in crate::report) struct ValueSheet<'a, W: Write> {
    csv: CsvSheet<W>,
    style: TableStyle,
    answers: Option<&'a Answers>,
    /// Whether a cell distinguishes given values from computed ones.
    marks_given: bool,
}

impl<'a, W: Write> ValueSheet<'a, W> {
    /// Writes the header; `with_entry` adds a cell that distinguishes given values.
    pub(in crate::report) fn new(
        style: TableStyle,
        dialect: CsvDialect,
        answers: Option<&'a Answers>,
        with_entry: bool,
        to: W,
    ) -> io::Result<Self> {
        let mut sheet = ValueSheet {
            csv: CsvSheet::new(dialect, to),
            style,
            answers,
            marks_given: with_entry,
        };
        let answer = ["sensitivity", "most", "by"];
        sheet.record(["name", "value", "unit", "entry"], "bound", answer)?;
        Ok(sheet)
    }

    /// Writes the fixed cells, then the bound and the sensitivity if requested.
    fn record(&mut self, cells: [&str; 4], bound: &str, answer: [&str; 3]) -> io::Result<()> {
        let [name, value, unit, entry] = cells;
        let unit = self.style.units.then_some(unit);
        let entry = self.marks_given.then_some(entry);
        let bound = self.style.bounds.then_some(bound);
        let answer = self.answers.map(|_| answer).into_iter().flatten();
        let cells = [name, value].into_iter().chain(unit).chain(entry);
        self.csv.record(cells.chain(bound).chain(answer))
    }

    /// Writes a value.
    pub(in crate::report) fn value(
        &mut self,
        name: &str,
        unit: &str,
        value: Entry,
    ) -> io::Result<()> {
        let entry = if value.given { "given" } else { "found" };
        let answer = self.answers.and_then(|answers| answers.of(name));
        let maximum = answer.and_then(|answer| answer.most.as_ref());
        let length = maximum.map_or("", |(length, _)| length);
        let bound = cell(value.proved());
        let worst = cell(answer.map(|answer| answer.worst));
        let by = cell(maximum.map(|(_, derivative)| *derivative));
        let cells = [name, &cell(value.value), unit, entry];
        self.record(cells, &bound, [&worst, length, &by])
    }

    /// Writes the state as the last line.
    pub(in crate::report) fn finish(mut self, condition: Condition) -> io::Result<()> {
        self.record(["state", state_word(condition), "", ""], "", [""; 3])?;
        self.csv.finish()
    }
}
