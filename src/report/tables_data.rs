//! The tables for other programs: CSV, a line per figure, and JSON.

use super::number::shortest;
use super::rows::plain;
use super::tables::{Entry, ORDERS, Plane, PointRow, Tables, VectorColumn};
use super::tables_text::index;
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
        Order::Acceleration => [
            ("ax", Aspect::Ax),
            ("ay", Aspect::Ay),
            ("a", Aspect::Ax),
            ("a.angle", Aspect::Angle),
        ],
    }
}

fn point_values(point: &PointRow, order: Order) -> [Option<f64>; 4] {
    match point.motion[index(order)] {
        None => [None; 4],
        Some(Plane {
            components,
            magnitude,
            direction,
        }) => [
            Some(components.x),
            Some(components.y),
            Some(magnitude),
            direction,
        ],
    }
}

/// A vector's figures in the order of the catalogue's columns.
fn vector_figures(vector: &VectorColumn) -> impl Iterator<Item = (Aspect, Entry)> {
    let lengths = vector.length.into_iter().flatten();
    let lengths = Aspect::STRETCHING.into_iter().zip(lengths);
    lengths.chain(Aspect::TURNING.into_iter().zip(vector.direction))
}

impl Tables {
    /// One line per figure: `name,value,unit,entry`, where `entry` tells given from found.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_csv(&self, units: bool, to: impl Write) -> io::Result<()> {
        let mut lines = Lines {
            csv: csv::Writer::from_writer(to),
            units,
        };
        lines.record(["name", "value", "unit", "entry"])?;
        for (name, value, unit) in self.driver_figures() {
            lines.figure(&name, Some(value), &unit, true)?;
        }
        for vector in &self.vectors {
            for (aspect, entry) in vector_figures(vector) {
                let name = format!("{}.{}", vector.name, aspect.name());
                lines.figure(&name, entry.value, &aspect.unit(self.unit), entry.given)?;
            }
        }
        for point in &self.points {
            for order in ORDERS {
                let figures = point_aspects(order).into_iter();
                for ((figure, aspect), value) in figures.zip(point_values(point, order)) {
                    let name = format!("{}.{figure}", point.name);
                    lines.figure(&name, value, &aspect.unit(self.unit), point.fixed)?;
                }
            }
        }
        lines.record(["state", state_word(self.condition), "", ""])?;
        lines.csv.flush()
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
    /// named; a value that does not exist is `null`.
    #[must_use]
    pub fn to_json(&self, units: bool) -> Value {
        let mut object = Map::new();
        object.insert("scene".into(), self.scene.as_str().into());
        if units {
            object.insert("units".into(), self.units());
        }
        let mut driver = Map::new();
        driver.insert("name".into(), self.driver.name.as_str().into());
        for (name, value, _) in self.driver_figures() {
            let key = name.trim_start_matches("driver.").to_owned();
            driver.insert(key, number(Some(value)));
        }
        object.insert("driver".into(), Value::Object(driver));
        object.insert("state".into(), state_word(self.condition).into());
        let vectors = self.vectors.iter().map(vector_json);
        object.insert("vectors".into(), vectors.collect());
        let points = self.points.iter().map(point_json);
        object.insert("points".into(), points.collect());
        Value::Object(object)
    }

    fn units(&self) -> Value {
        let unit = |aspect: Aspect| aspect.unit(self.unit);
        json!({
            "length": unit(Aspect::Length),
            "velocity": unit(Aspect::Rate),
            "acceleration": unit(Aspect::Accel),
            "angle": unit(Aspect::Angle),
            "omega": unit(Aspect::Omega),
            "alpha": unit(Aspect::Alpha),
        })
    }
}

/// A double as JSON, a negative zero without its sign.
pub(super) fn number(value: Option<f64>) -> Value {
    value.map_or(Value::Null, |value| (value + 0.0).into())
}

fn vector_json(vector: &VectorColumn) -> Value {
    let mut object = Map::new();
    object.insert("name".into(), vector.name.as_str().into());
    let mut given = Vec::new();
    for (aspect, entry) in vector_figures(vector) {
        object.insert(aspect.name().into(), number(entry.value));
        if entry.given {
            given.push(Value::from(aspect.name()));
        }
    }
    object.insert("given".into(), given.into());
    Value::Object(object)
}

fn point_json(point: &PointRow) -> Value {
    let mut object = Map::new();
    object.insert("name".into(), point.name.as_str().into());
    object.insert("fixed".into(), point.fixed.into());
    for order in ORDERS {
        for ((name, _), value) in point_aspects(order)
            .into_iter()
            .zip(point_values(point, order))
        {
            object.insert(name.into(), number(value));
        }
    }
    Value::Object(object)
}

struct Lines<W: Write> {
    csv: csv::Writer<W>,
    units: bool,
}

impl<W: Write> Lines<W> {
    fn record(&mut self, cells: [&str; 4]) -> io::Result<()> {
        let [name, value, unit, entry] = cells;
        if self.units {
            self.csv.write_record([name, value, unit, entry])
        } else {
            self.csv.write_record([name, value, entry])
        }
        .map_err(plain)
    }

    fn figure(
        &mut self,
        name: &str,
        value: Option<f64>,
        unit: &str,
        given: bool,
    ) -> io::Result<()> {
        let mut text = String::new();
        if let Some(value) = value {
            shortest(value, &mut text);
        }
        let entry = if given { "given" } else { "found" };
        self.record([name, &text, unit, entry])
    }
}
