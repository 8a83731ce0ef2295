//! The tables as text.

use super::number::{concise, direction, significant, upwards};
use super::tables::{Entry, ORDERS, Tables, VectorColumn};
use super::text::Grid;
use crate::quantity::{Aspect, state_word};
use crate::scene::sanitized;
use crate::solver::Order;

/// How tables are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TableStyle {
    /// Significant digits of text; CSV and JSON carry all.
    pub digits: usize,
    /// Whether there are units.
    pub units: bool,
    /// Whether to say what the errors do not exceed: in text a line below the figures.
    pub bounds: bool,
    /// Whether text must show the scene's title in ASCII; everything else always is.
    pub ascii: bool,
}

impl Tables {
    /// The tables as text: a column per vector, then a line per point.
    #[must_use]
    pub fn to_text(&self, style: TableStyle) -> String {
        let writer = Writer {
            tables: self,
            style,
        };
        let mut parts = vec![writer.heading()];
        parts.extend(ORDERS.map(|order| writer.vector_table(order)));
        parts.push(writer.legend());
        parts.extend(ORDERS.map(|order| writer.point_table(order)));
        let forces = self.forces.iter();
        parts.extend(forces.flat_map(|forces| writer.force_parts(forces)));
        parts.extend(self.answers.iter().map(|answers| answers.to_text(style)));
        parts.retain(|part| !part.is_empty());
        parts.join("\n")
    }
}

/// Widths of the labels, so that the tables below one another line up.
pub(super) const VECTOR_LABELS: usize = "alpha [rad/s^2]".len() + 2;
pub(super) const POINT_LABELS: usize = "acceleration of points".len();

/// Stands in front of a line of bounds, each with so many digits.
pub(super) const BOUND: &str = "  +-";
const BOUND_DIGITS: usize = 2;

/// The title of a table.
fn title(order: Order) -> &'static str {
    match order {
        Order::Position => "position",
        Order::Velocity => "velocity",
        Order::Acceleration | Order::Force => "acceleration",
    }
}

pub(super) struct Writer<'a> {
    tables: &'a Tables,
    pub(super) style: TableStyle,
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
            sanitized(&self.tables.scene, self.style.ascii),
            driver.name,
            state_word(self.tables.condition),
        )
    }

    /// `name [unit]`.
    pub(super) fn label(&self, name: &str, aspect: Aspect) -> String {
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
            Order::Acceleration | Order::Force => {
                [("d2r/dt2", Aspect::Accel), ("alpha", Aspect::Alpha)]
            }
        };
        let vectors = &self.tables.vectors;
        // Sign, point and star beside the digits.
        let mut grid = Grid::new(VECTOR_LABELS, self.style.digits + 3);
        let mut row = |label: String, cell: &dyn Fn(&VectorColumn) -> String| {
            grid.row(std::iter::once(label).chain(vectors.iter().map(cell)));
        };
        row(title(order).into(), &|v| format!("{} ", v.name));
        let lengths = |v: &VectorColumn| v.length.map_or(Entry::NONE, |l| l[index(order)]);
        let turnings = |v: &VectorColumn| v.direction[index(order)];
        row(self.label(length.0, length.1), &|v| {
            self.entry(lengths(v), length.1)
        });
        if self.style.bounds {
            row(BOUND.into(), &|v| self.bound(lengths(v)) + " ");
        }
        row(self.label(turning.0, turning.1), &|v| {
            self.entry(turnings(v), turning.1)
        });
        if self.style.bounds {
            row(BOUND.into(), &|v| self.bound(turnings(v)) + " ");
        }
        grid.render()
    }

    /// A star marks what was found; a blank keeps the digits of given entries under one another.
    fn entry(&self, entry: Entry, aspect: Aspect) -> String {
        let mark = if entry.given || entry.value.is_none() {
            ' '
        } else {
            '*'
        };
        format!("{}{mark}", self.figure(entry, aspect))
    }

    pub(super) fn figure(&self, entry: Entry, aspect: Aspect) -> String {
        match (entry.seen(), aspect) {
            (None, _) => "-".into(),
            (Some(value), Aspect::Angle) => direction(value, self.style.digits),
            (Some(value), _) => significant(value, self.style.digits),
        }
    }

    /// What the error of a figure does not exceed; nothing of a figure that does not exist.
    pub(super) fn bound(&self, entry: Entry) -> String {
        match (entry.value, entry.bound) {
            (None, _) => String::new(),
            (Some(_), None) => "?".into(),
            (Some(_), Some(bound)) => upwards(bound, BOUND_DIGITS),
        }
    }

    fn legend(&self) -> String {
        let mut legend = String::new();
        if !self.tables.vectors.is_empty() {
            legend.push_str("* found; entries without a star are given\n");
        }
        if self.style.bounds {
            legend.push_str("+- what the error does not exceed; ? where nothing was proved\n");
        }
        legend
    }

    fn point_table(&self, order: Order) -> String {
        if self.tables.points.is_empty() {
            return String::new();
        }
        let (names, aspect) = match order {
            Order::Position => (["x", "y", "r"], Aspect::X),
            Order::Velocity => (["vx", "vy", "v"], Aspect::Vx),
            Order::Acceleration | Order::Force => (["ax", "ay", "a"], Aspect::Ax),
        };
        let mut grid = Grid::new(POINT_LABELS, self.style.digits + 2);
        let headers = names.map(|name| self.label(name, aspect));
        let direction = self.label("direction", Aspect::Angle);
        let title = format!("{} of points", title(order));
        grid.row(std::iter::once(title).chain(headers).chain([direction]));
        for point in &self.tables.points {
            let plane = point.motion[index(order)];
            let entries = plane.map_or([Entry::NONE; 4], |plane| plane.entries(point.fixed));
            let aspects = [aspect, aspect, aspect, Aspect::Angle];
            let cells = entries.into_iter().zip(aspects);
            let cells = cells.map(|(entry, aspect)| self.figure(entry, aspect));
            grid.row(std::iter::once(point.name.clone()).chain(cells));
            if self.style.bounds {
                let bounds = entries.map(|entry| self.bound(entry));
                grid.row(std::iter::once(BOUND.to_owned()).chain(bounds));
            }
        }
        grid.render()
    }
}

/// Where an order stands in the entries.
pub(super) fn index(order: Order) -> usize {
    match order {
        Order::Position => 0,
        Order::Velocity => 1,
        Order::Acceleration | Order::Force => 2,
    }
}
