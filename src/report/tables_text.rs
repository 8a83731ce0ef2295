//! The tables as text.

use super::number::{concise, direction, significant};
use super::tables::{Entry, ORDERS, Plane, PointRow, Tables, VectorColumn};
use super::text::Grid;
use crate::quantity::{Aspect, state_word};
use crate::scene::harmless;
use crate::solver::Order;

/// How text tables are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextStyle {
    /// Significant digits.
    pub digits: usize,
    /// Whether units stand behind the names.
    pub units: bool,
    /// Whether the scene's title must be shown in ASCII; everything else always is.
    pub ascii: bool,
}

impl Tables {
    /// The tables as text: a column per vector, then a line per point.
    #[must_use]
    pub fn to_text(&self, style: TextStyle) -> String {
        let writer = Writer {
            tables: self,
            style,
        };
        let mut parts = vec![writer.heading()];
        parts.extend(ORDERS.map(|order| writer.vector_table(order)));
        parts.push(writer.legend());
        parts.extend(ORDERS.map(|order| writer.point_table(order)));
        parts.extend(self.answers.iter().map(|answers| answers.to_text(style)));
        parts.retain(|part| !part.is_empty());
        parts.join("\n")
    }
}

/// Widths of the labels, so that the tables below one another line up.
const VECTOR_LABELS: usize = "alpha [rad/s^2]".len() + 2;
const POINT_LABELS: usize = "acceleration of points".len();

/// The title of a table.
fn title(order: Order) -> &'static str {
    match order {
        Order::Position => "position",
        Order::Velocity => "velocity",
        Order::Acceleration => "acceleration",
    }
}

struct Writer<'a> {
    tables: &'a Tables,
    style: TextStyle,
}

impl Writer<'_> {
    fn heading(&self) -> String {
        let driver = &self.tables.driver;
        let aspects = driver.aspects();
        // The coordinate as it was asked; rates may come from rpm or deg/s, with digits of no use.
        let digits = [usize::MAX, self.style.digits, self.style.digits];
        let [at, speed, acceleration]: [String; 3] = std::array::from_fn(|i| {
            let value = concise(driver.values[i], digits[i]);
            format!("{value} {}", aspects[i].unit(self.tables.unit))
        });
        format!(
            "{}\ndriver {} at {at}, {speed}, {acceleration}\nstate {}\n",
            harmless(&self.tables.scene, self.style.ascii),
            driver.name,
            state_word(self.tables.condition),
        )
    }

    /// `name [unit]`.
    fn label(&self, name: &str, aspect: Aspect) -> String {
        if self.style.units {
            format!("{name} [{}]", aspect.unit(self.tables.unit))
        } else {
            name.to_owned()
        }
    }

    fn vector_table(&self, order: Order) -> String {
        let [length, turning] = match order {
            Order::Position => [("r", Aspect::Length), ("theta", Aspect::Angle)],
            Order::Velocity => [("dr/dt", Aspect::Rate), ("omega", Aspect::Omega)],
            Order::Acceleration => [("d2r/dt2", Aspect::Accel), ("alpha", Aspect::Alpha)],
        };
        let vectors = &self.tables.vectors;
        // Sign, point and star beside the digits.
        let mut grid = Grid::new(VECTOR_LABELS, self.style.digits + 3);
        let mut row = |label: String, cell: &dyn Fn(&VectorColumn) -> String| {
            grid.row(std::iter::once(label).chain(vectors.iter().map(cell)));
        };
        row(title(order).into(), &|v| format!("{} ", v.name));
        row(self.label(length.0, length.1), &|v| {
            v.length
                .map_or_else(|| "- ".into(), |l| self.entry(l[index(order)], length.1))
        });
        row(self.label(turning.0, turning.1), &|v| {
            self.entry(v.direction[index(order)], turning.1)
        });
        grid.render()
    }

    /// A star marks what was found; a blank keeps the digits of given entries under one another.
    fn entry(&self, entry: Entry, aspect: Aspect) -> String {
        let mark = if entry.given { ' ' } else { '*' };
        match (entry.value, aspect) {
            (None, _) => "- ".into(),
            (Some(value), Aspect::Angle) => {
                format!("{}{mark}", direction(value, self.style.digits))
            }
            (Some(value), _) => format!("{}{mark}", significant(value, self.style.digits)),
        }
    }

    fn legend(&self) -> String {
        if self.tables.vectors.is_empty() {
            String::new()
        } else {
            "* found; entries without a star are given\n".into()
        }
    }

    fn point_table(&self, order: Order) -> String {
        if self.tables.points.is_empty() {
            return String::new();
        }
        let (names, aspect) = match order {
            Order::Position => (["x", "y", "r"], Aspect::X),
            Order::Velocity => (["vx", "vy", "v"], Aspect::Vx),
            Order::Acceleration => (["ax", "ay", "a"], Aspect::Ax),
        };
        let mut grid = Grid::new(POINT_LABELS, self.style.digits + 2);
        let headers = names.map(|name| self.label(name, aspect));
        let direction = self.label("direction", Aspect::Angle);
        let title = format!("{} of points", title(order));
        grid.row(std::iter::once(title).chain(headers).chain([direction]));
        for point in &self.tables.points {
            grid.row(self.point_cells(point, order));
        }
        grid.render()
    }

    fn point_cells(&self, point: &PointRow, order: Order) -> [String; 5] {
        let none = || "-".to_owned();
        let number = |value| significant(value, self.style.digits);
        let [x, y, magnitude, towards] = match point.motion[index(order)] {
            None => [none(), none(), none(), none()],
            Some(Plane {
                components,
                magnitude,
                direction: towards,
            }) => [
                number(components.x),
                number(components.y),
                number(magnitude),
                towards.map_or_else(none, |d| direction(d, self.style.digits)),
            ],
        };
        [point.name.clone(), x, y, magnitude, towards]
    }
}

/// Where an order stands in the entries.
pub(super) fn index(order: Order) -> usize {
    match order {
        Order::Position => 0,
        Order::Velocity => 1,
        Order::Acceleration => 2,
    }
}
