//! The tables as columns that fit a width: which figures stand side by side, and in which form.

use super::figures::Format;
use crate::drawing::Glyphs;
use crate::quantity::Aspect;
use crate::report::{Entry, PointRow, Tables, VectorColumn};
use std::ops::Range;

/// The two parts of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// The vectors of the loop equations.
    Vectors,
    /// Joints, centres of mass and other points.
    Points,
}

/// What a column shows, of the order 0 (position), 1 (velocity) or 2 (acceleration).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Figure {
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
struct Column {
    figure: Figure,
    unit: String,
    format: Format,
    /// Whether a chunk may begin with it: what belongs together is kept together.
    opens: bool,
}

/// A line of the tables at some width.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Line {
    /// Between two chunks of columns.
    Blank,
    /// The names of columns.
    Names(Part, Range<usize>),
    /// Their units.
    Units(Part, Range<usize>),
    /// The figures of the row with this number.
    Row(Part, usize, Range<usize>),
}

/// A cell as it is shown, right-aligned in its width.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shown {
    pub(crate) text: String,
    pub(crate) width: usize,
    /// Whether the scene gives the figure; otherwise it was found.
    pub(crate) given: bool,
}

/// The columns of a scene's tables.
#[derive(Clone, Debug)]
pub(crate) struct Sheet {
    vectors: Vec<Column>,
    points: Vec<Column>,
    rows: [usize; 2],
    /// The width of the names.
    names: usize,
}

/// Longer names are cut: they would push the figures from a small screen.
const LONGEST_NAME: usize = 8;

const VECTOR_FIGURES: [(Figure, bool); 6] = [
    (Figure::Length(0), true),
    (Figure::Turning(0), false),
    (Figure::Length(1), true),
    (Figure::Turning(1), false),
    (Figure::Length(2), true),
    (Figure::Turning(2), false),
];

const POINT_FIGURES: [(Figure, bool); 10] = [
    (Figure::AlongX(0), true),
    (Figure::AlongY(0), false),
    (Figure::AlongX(1), true),
    (Figure::AlongY(1), false),
    (Figure::Size(1), false),
    (Figure::Bearing(1), false),
    (Figure::AlongX(2), true),
    (Figure::AlongY(2), false),
    (Figure::Size(2), false),
    (Figure::Bearing(2), false),
];

impl Sheet {
    /// Columns for tables that look like these over the motion.
    pub(crate) fn new(samples: &[Tables]) -> Self {
        let first = samples.first();
        let unit = first.map_or("", |t| t.unit);
        let vector_names = first
            .into_iter()
            .flat_map(|t| t.vectors.iter().map(|v| &v.name));
        let point_names = first
            .into_iter()
            .flat_map(|t| t.points.iter().map(|p| &p.name));
        let names = vector_names.chain(point_names).map(|n| n.chars().count());
        let names = names.max().unwrap_or(0);
        let column = |part, (figure, opens): (Figure, bool)| Column {
            figure,
            unit: figure.unit(unit),
            format: figure.format(samples, part),
            opens,
        };
        Sheet {
            vectors: VECTOR_FIGURES.map(|f| column(Part::Vectors, f)).into(),
            points: POINT_FIGURES.map(|f| column(Part::Points, f)).into(),
            rows: first.map_or([0, 0], |t| [t.vectors.len(), t.points.len()]),
            names: names.clamp(Part::Vectors.title().len(), LONGEST_NAME),
        }
    }

    /// The lines of both parts at this width.
    pub(crate) fn lines(&self, width: usize, glyphs: Glyphs) -> Vec<Line> {
        let mut lines = self.part(Part::Vectors, width, glyphs);
        let points = self.part(Part::Points, width, glyphs);
        if !lines.is_empty() && !points.is_empty() {
            lines.push(Line::Blank);
        }
        lines.extend(points);
        lines
    }

    /// The lines of one part: chunk by chunk of the columns that fit side by side.
    fn part(&self, part: Part, width: usize, glyphs: Glyphs) -> Vec<Line> {
        let rows = self.rows[part as usize];
        let mut lines = Vec::new();
        if rows == 0 {
            return lines;
        }
        for chunk in self.chunks(part, width, glyphs) {
            if !lines.is_empty() {
                lines.push(Line::Blank);
            }
            lines.push(Line::Names(part, chunk.clone()));
            lines.push(Line::Units(part, chunk.clone()));
            lines.extend((0..rows).map(|row| Line::Row(part, row, chunk.clone())));
        }
        lines
    }

    /// How many lines the vectors take at this width.
    pub(crate) fn vector_lines(&self, width: usize, glyphs: Glyphs) -> usize {
        self.part(Part::Vectors, width, glyphs).len()
    }

    /// The narrowest width at which what belongs together stands side by side, two by two, and the
    /// width at which all figures of a vector do.
    pub(crate) fn widths(&self, glyphs: Glyphs) -> (usize, usize) {
        let pairs = |part| {
            let count = self.columns(part).len() / 2;
            (0..count).map(move |i| (part, 2 * i..2 * i + 2))
        };
        let pairs = pairs(Part::Vectors).chain(pairs(Part::Points));
        let narrow = pairs
            .map(|(part, pair)| self.needed(part, pair, glyphs))
            .max();
        let wide = self.needed(Part::Vectors, 0..self.vectors.len(), glyphs);
        (narrow.unwrap_or(0), wide)
    }

    /// Columns that fit side by side, cut where a new order begins if that is possible.
    fn chunks(&self, part: Part, width: usize, glyphs: Glyphs) -> Vec<Range<usize>> {
        let columns = self.columns(part);
        let mut chunks = Vec::new();
        let mut start = 0;
        while start < columns.len() {
            let fits = |end: &usize| self.needed(part, start..*end, glyphs) <= width;
            let longest = (start + 1..=columns.len()).take_while(fits).last();
            // One column is shown even where it does not fit.
            let longest = longest.unwrap_or(start + 1);
            let at_order = (start + 1..=longest)
                .rev()
                .find(|&end| columns.get(end).is_none_or(|c| c.opens));
            let end = at_order.unwrap_or(longest);
            chunks.push(start..end);
            start = end;
        }
        chunks
    }

    fn columns(&self, part: Part) -> &[Column] {
        match part {
            Part::Vectors => &self.vectors,
            Part::Points => &self.points,
        }
    }

    /// The width that the names and these columns need.
    fn needed(&self, part: Part, chunk: Range<usize>, glyphs: Glyphs) -> usize {
        let columns = self.columns(part)[chunk].iter();
        self.names + columns.map(|c| 1 + c.width(glyphs)).sum::<usize>()
    }

    /// What a line shows: the name, and the cells behind it.
    pub(crate) fn show(
        &self,
        line: &Line,
        tables: &Tables,
        width: usize,
        glyphs: Glyphs,
    ) -> (Shown, Vec<Shown>) {
        let (part, chunk) = match line {
            Line::Blank => return (self.name(""), Vec::new()),
            Line::Names(part, chunk) | Line::Units(part, chunk) | Line::Row(part, _, chunk) => {
                (*part, chunk.clone())
            }
        };
        let needed = self.needed(part, chunk.clone(), glyphs);
        // Room to spare widens the gaps between columns, but not so far that rows fall apart.
        let gap = 1 + (width.saturating_sub(needed) / chunk.len().max(1)).min(WIDEST_GAP);
        let cells = self.columns(part)[chunk].iter().map(|column| {
            let (text, given) = match line {
                Line::Row(_, row, _) => column.cell(tables, part, *row),
                Line::Units(..) => (column.unit(glyphs), false),
                Line::Names(..) | Line::Blank => (column.figure.symbol(glyphs).into(), false),
            };
            let width = gap + column.width(glyphs);
            Shown { text, width, given }
        });
        let name = match line {
            Line::Row(Part::Vectors, row, _) => tables.vectors.get(*row).map(|v| v.name.as_str()),
            Line::Row(Part::Points, row, _) => tables.points.get(*row).map(|p| p.name.as_str()),
            Line::Names(part, _) => Some(part.title()),
            Line::Units(..) | Line::Blank => None,
        };
        (self.name(name.unwrap_or_default()), cells.collect())
    }

    fn name(&self, name: &str) -> Shown {
        Shown {
            text: name.chars().take(self.names).collect(),
            width: self.names,
            given: false,
        }
    }
}

/// Beyond one column, and beyond this, room to spare stays at the right.
const WIDEST_GAP: usize = 4;

impl Part {
    fn title(self) -> &'static str {
        match self {
            Part::Vectors => "vector",
            Part::Points => "point",
        }
    }
}

impl Column {
    fn unit(&self, glyphs: Glyphs) -> String {
        match glyphs {
            Glyphs::Ascii | Glyphs::Line => self.unit.clone(),
            Glyphs::Braille => self.unit.replace("^2", "\u{b2}"),
        }
    }

    fn width(&self, glyphs: Glyphs) -> usize {
        let symbol = self.figure.symbol(glyphs).chars().count();
        let unit = self.unit(glyphs).chars().count();
        symbol.max(unit).max(self.format.width())
    }

    fn cell(&self, tables: &Tables, part: Part, row: usize) -> (String, bool) {
        let Some(entry) = self.figure.entry(tables, part, row) else {
            return (String::new(), false);
        };
        let text = match self.figure {
            Figure::Turning(0) | Figure::Bearing(_) => self.format.write_angle(entry.value),
            _ => self.format.write(entry.value),
        };
        (text, entry.given)
    }
}

impl Figure {
    fn symbol(self, glyphs: Glyphs) -> &'static str {
        let greek = glyphs == Glyphs::Braille;
        match self {
            Figure::Length(order) => ["r", "r'", "r''"][order],
            Figure::Turning(order) if greek => ["\u{3b8}", "\u{3c9}", "\u{3b1}"][order],
            Figure::Turning(order) => ["theta", "omega", "alpha"][order],
            Figure::AlongX(order) => ["x", "vx", "ax"][order],
            Figure::AlongY(order) => ["y", "vy", "ay"][order],
            Figure::Size(order) => ["r", "v", "a"][order],
            Figure::Bearing(order) => ["dir r", "dir v", "dir a"][order],
        }
    }

    fn unit(self, length: &str) -> String {
        let aspect = match self {
            Figure::Length(order)
            | Figure::AlongX(order)
            | Figure::AlongY(order)
            | Figure::Size(order) => [Aspect::Length, Aspect::Rate, Aspect::Accel][order],
            Figure::Turning(order) => [Aspect::Angle, Aspect::Omega, Aspect::Alpha][order],
            Figure::Bearing(_) => Aspect::Angle,
        };
        aspect.unit(length)
    }

    /// The decimals and the width that this figure needs in all rows over the motion. Components and
    /// size of one order share theirs, so that they can be compared by eye.
    fn format(self, samples: &[Tables], part: Part) -> Format {
        let figure = match self {
            Figure::Turning(0) | Figure::Bearing(_) => return Format::ANGLE,
            Figure::AlongX(order) | Figure::AlongY(order) => Figure::Size(order),
            other => other,
        };
        let of_sample = |tables: &Tables| {
            let rows = match part {
                Part::Vectors => tables.vectors.len(),
                Part::Points => tables.points.len(),
            };
            let entries = (0..rows).filter_map(|row| figure.entry(tables, part, row));
            entries
                .filter_map(|e| e.value)
                .map(f64::abs)
                .collect::<Vec<_>>()
        };
        // What never moves says nothing about the size of what does.
        let sizes = samples.iter().flat_map(of_sample).filter(|s| *s > 0.0);
        Format::of_sizes(sizes.collect())
    }

    fn entry(self, tables: &Tables, part: Part, row: usize) -> Option<Entry> {
        match part {
            Part::Vectors => self.vector_entry(tables.vectors.get(row)?),
            Part::Points => Some(self.point_entry(tables.points.get(row)?)),
        }
    }

    /// `None` where the vector has no such figure at all.
    fn vector_entry(self, vector: &VectorColumn) -> Option<Entry> {
        match self {
            Figure::Length(order) => vector.length.map(|length| length[order]),
            Figure::Turning(order) => Some(vector.direction[order]),
            _ => None,
        }
    }

    fn point_entry(self, point: &PointRow) -> Entry {
        let value = match self {
            Figure::AlongX(order) => point.motion[order].map(|p| p.components.x),
            Figure::AlongY(order) => point.motion[order].map(|p| p.components.y),
            Figure::Size(order) => point.motion[order].map(|p| p.magnitude),
            Figure::Bearing(order) => point.motion[order].and_then(|p| p.direction),
            Figure::Length(_) | Figure::Turning(_) => None,
        };
        let given = point.fixed;
        Entry { value, given }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, presets};
    use crate::solver::{Order, Solver};

    /// Every preset's tables at its opening.
    fn tables() -> Vec<Tables> {
        let all = presets::all().iter().map(|preset| {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap();
            let mut state = solver.state();
            let start = scene.mechanism.driver().start;
            solver.solve(start, Order::Acceleration, &mut state);
            Tables::new(&scene, &state)
        });
        all.collect()
    }

    #[test]
    fn every_figure_is_shown_once_and_fits() {
        for tables in tables() {
            let sheet = Sheet::new(std::slice::from_ref(&tables));
            for glyphs in [Glyphs::Ascii, Glyphs::Braille] {
                let (narrow, wide) = sheet.widths(glyphs);
                assert!(narrow <= 36, "{}: {narrow}", tables.scene);
                for width in narrow..=wide + 20 {
                    let lines = sheet.lines(width, glyphs);
                    let figures = |row: &Line| sheet.show(row, &tables, width, glyphs).1.len();
                    let rows = lines.iter().filter(|l| matches!(l, Line::Row(..)));
                    let shown: usize = rows.map(figures).sum();
                    let (vectors, points) = (tables.vectors.len(), tables.points.len());
                    assert_eq!(shown, 6 * vectors + 10 * points);
                    for line in &lines {
                        let (name, cells) = sheet.show(line, &tables, width, glyphs);
                        let needed = name.width + cells.iter().map(|c| c.width).sum::<usize>();
                        assert!(needed <= width, "{}: {needed} of {width}", tables.scene);
                        for cell in cells {
                            let columns = cell.text.chars().count();
                            assert!(columns < cell.width, "{}: {}", tables.scene, cell.text);
                        }
                    }
                }
            }
        }
    }
}
