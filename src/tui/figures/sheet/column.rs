//! A column of the tables: its quantity, its rows and its number format.

use super::SheetPart;
use crate::drawing::Glyphs;
use crate::page::{Cell, Units};
use crate::quantity::Aspect;
use crate::report::{Entry, PointRow, Tables, VectorColumn};
use crate::tui::figures::format::Format;
use crate::wording::words;

/// The quantity of a column, with its order: 0 (position), 1 (velocity) or 2 (acceleration).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ColumnFigure {
    /// The length of a vector, or its rates.
    Length(usize),
    /// The direction of a vector, or its rates.
    Turning(usize),
    /// A point's component along x.
    AlongX(usize),
    /// A point's component along y.
    AlongY(usize),
    /// The magnitude of a point's position, velocity or acceleration.
    Size(usize),
    /// The direction of a point's position, velocity or acceleration.
    Bearing(usize),
}

/// A column: its quantity, unit and format.
#[derive(Clone, Debug)]
pub(super) struct Column {
    figure: ColumnFigure,
    unit: String,
    format: Format,
    /// Whether a chunk may begin with it. Related columns are kept together.
    pub(super) opens: bool,
    /// Whether it contains computed values. Each of these is followed by a star, for which the
    /// column has an extra place.
    pub(super) starred: bool,
}

/// The mark behind a computed value; all others are given by the scene.
pub(crate) const COMPUTED_MARK: char = '*';

pub(super) const VECTOR_FIGURES: [(ColumnFigure, bool); 6] = [
    (ColumnFigure::Length(0), true),
    (ColumnFigure::Turning(0), false),
    (ColumnFigure::Length(1), true),
    (ColumnFigure::Turning(1), false),
    (ColumnFigure::Length(2), true),
    (ColumnFigure::Turning(2), false),
];

pub(super) const POINT_FIGURES: [(ColumnFigure, bool); 10] = [
    (ColumnFigure::AlongX(0), true),
    (ColumnFigure::AlongY(0), false),
    (ColumnFigure::AlongX(1), true),
    (ColumnFigure::AlongY(1), false),
    (ColumnFigure::Size(1), false),
    (ColumnFigure::Bearing(1), false),
    (ColumnFigure::AlongX(2), true),
    (ColumnFigure::AlongY(2), false),
    (ColumnFigure::Size(2), false),
    (ColumnFigure::Bearing(2), false),
];

impl Column {
    /// Creates a column with a format that fits the samples over the motion; a chunk may begin with
    /// it if `opens`.
    pub(super) fn new(
        samples: &[Tables],
        part: SheetPart,
        (column, opens): (ColumnFigure, bool),
    ) -> Column {
        let first = samples.first();
        let found = |t: &Tables| column.entries(t, part).any(|entry| !entry.given);
        Column {
            figure: column,
            unit: column.unit(first.map_or("", |t| t.unit)),
            format: column.format(samples, part),
            opens,
            starred: part == SheetPart::Vectors && first.is_some_and(found),
        }
    }

    /// Switches an angle column to the format of signed differences.
    pub(super) fn give_sign(&mut self) {
        if self.format == Format::ANGLE {
            self.format = Format::SIGNED_ANGLE;
        }
    }

    /// Returns the name with its unit as in a sweep, without the element's name: `vx [mm/s]`.
    pub(super) fn header(&self) -> String {
        format!("{} [{}]", self.figure.name(), self.unit)
    }

    /// Returns the value of a row; `None` if the row has no such quantity.
    pub(super) fn entry(&self, tables: &Tables, part: SheetPart, row: usize) -> Option<Entry> {
        self.figure.entry(tables, part, row)
    }

    /// Returns the unit in ASCII.
    pub(super) fn plain_unit(&self) -> &str {
        &self.unit
    }

    pub(super) fn unit(&self, glyphs: Glyphs) -> String {
        match glyphs {
            Glyphs::Ascii | Glyphs::Line => self.unit.clone(),
            Glyphs::Braille | Glyphs::Blocks(_) => self.unit.replace("^2", "\u{b2}"),
        }
    }

    pub(super) fn title(&self, glyphs: Glyphs, units: Units) -> String {
        let symbol = self.figure.symbol(glyphs);
        match units {
            Units::Behind => format!("{symbol} [{}]", self.unit(glyphs)),
            Units::Below => symbol.to_owned(),
        }
    }

    pub(super) fn width(&self, glyphs: Glyphs, units: Units) -> usize {
        // Called many times per frame, so it counts without allocating.
        let symbol = self.figure.symbol(glyphs).chars().count();
        let unit = match glyphs {
            Glyphs::Ascii | Glyphs::Line => self.unit.len(),
            Glyphs::Braille | Glyphs::Blocks(_) => {
                self.unit.len() - self.unit.matches("^2").count()
            }
        };
        let title = match units {
            Units::Behind => symbol + unit + " []".len(),
            Units::Below => symbol.max(unit),
        };
        title.max(self.format.width()) + usize::from(self.starred)
    }

    /// Returns the formatted value, with the star of a computed one in a starred column.
    pub(super) fn cell(&self, tables: &Tables, part: SheetPart, row: usize) -> Cell {
        let Some(entry) = self.figure.entry(tables, part, row) else {
            return self.plain(String::new());
        };
        let mut cell = match self.figure {
            ColumnFigure::Turning(0) | ColumnFigure::Bearing(_) => self.format.write_angle(&entry),
            _ => self.format.write(&entry),
        };
        let found = entry.value.is_some() && !entry.given;
        if self.starred {
            cell.text.push(if found { COMPUTED_MARK } else { ' ' });
        }
        cell
    }

    /// Returns a cell with text in place of a value.
    pub(super) fn plain(&self, mut text: String) -> Cell {
        if self.starred {
            text.push(' ');
        }
        Cell::proved(text)
    }
}

impl ColumnFigure {
    fn symbol(self, glyphs: Glyphs) -> &'static str {
        let greek = glyphs.is_dotted();
        match self {
            ColumnFigure::Length(order) => ["r", "r'", "r''"][order],
            ColumnFigure::Turning(order) if greek => ["\u{3b8}", "\u{3c9}", "\u{3b1}"][order],
            ColumnFigure::Turning(order) => ["theta", "omega", "alpha"][order],
            ColumnFigure::AlongX(order) => ["x", "vx", "ax"][order],
            ColumnFigure::AlongY(order) => ["y", "vy", "ay"][order],
            ColumnFigure::Size(order) => ["r", "v", "a"][order],
            ColumnFigure::Bearing(order) => {
                let wording = words();
                [
                    wording.direction_r(),
                    wording.direction_v(),
                    wording.direction_a(),
                ][order]
            }
        }
    }

    /// Returns the name as in a quantity's name, behind the dot.
    fn name(self) -> &'static str {
        match self {
            ColumnFigure::Length(order) => ["length", "rate", "accel"][order],
            ColumnFigure::Turning(order) => ["angle", "omega", "alpha"][order],
            ColumnFigure::AlongX(order) => ["x", "vx", "ax"][order],
            ColumnFigure::AlongY(order) => ["y", "vy", "ay"][order],
            ColumnFigure::Size(order) => ["r", "v", "a"][order],
            ColumnFigure::Bearing(order) => ["r.angle", "v.angle", "a.angle"][order],
        }
    }

    fn unit(self, length: &str) -> String {
        let aspect = match self {
            ColumnFigure::Length(order)
            | ColumnFigure::AlongX(order)
            | ColumnFigure::AlongY(order)
            | ColumnFigure::Size(order) => [Aspect::Length, Aspect::Rate, Aspect::Accel][order],
            ColumnFigure::Turning(order) => [Aspect::Angle, Aspect::Omega, Aspect::Alpha][order],
            ColumnFigure::Bearing(_) => Aspect::Angle,
        };
        aspect.unit(length)
    }

    /// Returns the format for this quantity in all rows over the motion. The components and
    /// magnitude of one order share a format, so that they can be compared by eye.
    fn format(self, samples: &[Tables], part: SheetPart) -> Format {
        let column = match self {
            ColumnFigure::Turning(0) | ColumnFigure::Bearing(_) => return Format::ANGLE,
            ColumnFigure::AlongX(order) | ColumnFigure::AlongY(order) => ColumnFigure::Size(order),
            other => other,
        };
        let of_sample = |tables: &Tables| {
            let entries = column.entries(tables, part);
            entries
                .filter_map(|e| e.value)
                .map(f64::abs)
                .collect::<Vec<_>>()
        };
        // Zeros are ignored: fixed points say nothing about the magnitude of the other values.
        let sizes = samples.iter().flat_map(of_sample).filter(|s| *s > 0.0);
        Format::of_sizes(sizes.collect())
    }

    /// Yields the entries of all rows that have such a quantity.
    fn entries(self, tables: &Tables, part: SheetPart) -> impl Iterator<Item = Entry> {
        let rows = match part {
            SheetPart::Vectors => tables.vectors.len(),
            SheetPart::Points => tables.points.len(),
        };
        (0..rows).filter_map(move |row| self.entry(tables, part, row))
    }

    fn entry(self, tables: &Tables, part: SheetPart, row: usize) -> Option<Entry> {
        match part {
            SheetPart::Vectors => self.vector_entry(tables.vectors.get(row)?),
            SheetPart::Points => Some(self.point_entry(tables.points.get(row)?)),
        }
    }

    /// Returns the entry of a vector; `None` if it has no such quantity.
    fn vector_entry(self, vector: &VectorColumn) -> Option<Entry> {
        match self {
            ColumnFigure::Length(order) => vector.length.map(|length| length[order]),
            ColumnFigure::Turning(order) => Some(vector.direction[order]),
            _ => None,
        }
    }

    fn point_entry(self, point: &PointRow) -> Entry {
        let (order, index) = match self {
            ColumnFigure::AlongX(order) => (order, 0),
            ColumnFigure::AlongY(order) => (order, 1),
            ColumnFigure::Size(order) => (order, 2),
            ColumnFigure::Bearing(order) => (order, 3),
            ColumnFigure::Length(_) | ColumnFigure::Turning(_) => return Entry::NONE,
        };
        let plane = point.motion[order].as_ref();
        plane.map_or(Entry::NONE, |plane| plane.entries(point.fixed)[index])
    }
}
