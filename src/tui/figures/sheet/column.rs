//! A column of the tables: what it shows, of which rows, and in which form.

use super::SheetPart;
use crate::drawing::Glyphs;
use crate::page::{Cell, Units};
use crate::quantity::Aspect;
use crate::report::{Entry, PointRow, Tables, VectorColumn};
use crate::tui::figures::format::Format;
use crate::wording::words;

/// What a column shows, of the order 0 (position), 1 (velocity) or 2 (acceleration).
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
    /// The size of a point's velocity or acceleration.
    Size(usize),
    /// The direction of a point's velocity or acceleration.
    Bearing(usize),
}

/// A column: what it shows, and how.
#[derive(Clone, Debug)]
pub(super) struct Column {
    figure: ColumnFigure,
    unit: String,
    format: Format,
    /// Whether a chunk may begin with it: what belongs together is kept together.
    pub(super) opens: bool,
    /// Whether some of its figures are found and others given: found ones then have a star behind
    /// them, in a place of its own.
    pub(super) starred: bool,
}

/// Stands behind a figure that was found; the others are given by the scene.
pub(crate) const FOUND: char = '*';

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
    /// A figure in the form that fits it over the motion; `opens` where a chunk may begin with it.
    pub(super) fn new(
        samples: &[Tables],
        part: SheetPart,
        (figure, opens): (ColumnFigure, bool),
    ) -> Column {
        let first = samples.first();
        let found = |t: &Tables| figure.entries(t, part).any(|entry| !entry.given);
        Column {
            figure,
            unit: figure.unit(first.map_or("", |t| t.unit)),
            format: figure.format(samples, part),
            opens,
            starred: part == SheetPart::Vectors && first.is_some_and(found),
        }
    }

    /// A difference of directions has a sign.
    pub(super) fn give_sign(&mut self) {
        if self.format == Format::ANGLE {
            self.format = Format::SIGNED_ANGLE;
        }
    }

    /// The name with its unit, as a sweep names its columns behind the dot: `vx [mm/s]`.
    pub(super) fn header(&self) -> String {
        format!("{} [{}]", self.figure.name(), self.unit)
    }

    /// The figure with all that is known of it; `None` where the row has no such figure at all.
    pub(super) fn entry(&self, tables: &Tables, part: SheetPart, row: usize) -> Option<Entry> {
        self.figure.entry(tables, part, row)
    }

    /// The unit in characters that every terminal has.
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
        // Asked for many times a frame: counted without writing anything.
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

    /// The figure, with the mark of one that was found where there are such marks.
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
            cell.text.push(if found { FOUND } else { ' ' });
        }
        cell
    }

    /// Words in the place of a figure.
    pub(super) fn plain(&self, mut text: String) -> Cell {
        if self.starred {
            text.push(' ');
        }
        Cell::sure(text)
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
                let say = words();
                [say.direction_r(), say.direction_v(), say.direction_a()][order]
            }
        }
    }

    /// As in the name of a column, behind the dot.
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

    /// The decimals and the width that this figure needs in all rows over the motion. Components and
    /// size of one order share theirs, so that they can be compared by eye.
    fn format(self, samples: &[Tables], part: SheetPart) -> Format {
        let figure = match self {
            ColumnFigure::Turning(0) | ColumnFigure::Bearing(_) => return Format::ANGLE,
            ColumnFigure::AlongX(order) | ColumnFigure::AlongY(order) => ColumnFigure::Size(order),
            other => other,
        };
        let of_sample = |tables: &Tables| {
            let entries = figure.entries(tables, part);
            entries
                .filter_map(|e| e.value)
                .map(f64::abs)
                .collect::<Vec<_>>()
        };
        // What never moves says nothing about the size of what does.
        let sizes = samples.iter().flat_map(of_sample).filter(|s| *s > 0.0);
        Format::of_sizes(sizes.collect())
    }

    /// The entries of all rows that have such a figure.
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

    /// `None` where the vector has no such figure at all.
    fn vector_entry(self, vector: &VectorColumn) -> Option<Entry> {
        match self {
            ColumnFigure::Length(order) => vector.length.map(|length| length[order]),
            ColumnFigure::Turning(order) => Some(vector.direction[order]),
            _ => None,
        }
    }

    fn point_entry(self, point: &PointRow) -> Entry {
        let (order, figure) = match self {
            ColumnFigure::AlongX(order) => (order, 0),
            ColumnFigure::AlongY(order) => (order, 1),
            ColumnFigure::Size(order) => (order, 2),
            ColumnFigure::Bearing(order) => (order, 3),
            ColumnFigure::Length(_) | ColumnFigure::Turning(_) => return Entry::NONE,
        };
        let plane = point.motion[order].as_ref();
        plane.map_or(Entry::NONE, |plane| plane.entries(point.fixed)[figure])
    }
}
