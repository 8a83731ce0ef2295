//! The tables as columns that fit a width: which figures stand side by side, and in which form.

use super::figures::{Format, Unsure, Written};
use crate::drawing::Glyphs;
use crate::quantity::Aspect;
use crate::report::{Entry, PointRow, Tables, VectorColumn};
use std::collections::HashMap;
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
    /// Whether some of its figures are found and others given: found ones then have a star behind
    /// them, in a place of its own.
    starred: bool,
}

/// A line of the tables at some width.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Line {
    /// Between two chunks of columns.
    Blank,
    /// The names of columns, with their units where all of them fit into one line.
    Names(Part, Range<usize>),
    /// Their units.
    Units(Part, Range<usize>),
    /// The figures of the row with this number.
    Row(Part, usize, Range<usize>),
}

/// A cell as it is shown: right-aligned in its width, with room for a star behind the figures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shown {
    pub(crate) text: String,
    pub(crate) width: usize,
    /// The digits that nothing proves, by their places in the text.
    pub(crate) unsure: Unsure,
}

/// Stands behind a figure that was found; the others are given by the scene.
pub(crate) const FOUND: char = '*';

/// The columns of a scene's tables.
#[derive(Clone, Debug)]
pub(crate) struct Sheet {
    vectors: Vec<Column>,
    points: Vec<Column>,
    /// The names of the rows, as short as they are shown.
    rows: [Vec<String>; 2],
    /// Which points never move: their rates are not worth a row.
    fixed: Vec<bool>,
    /// The width of the names.
    names: usize,
}

/// Longer names are cut: they would push the figures from a small screen.
const LONGEST_NAME: usize = 9;
/// Stands where a name was cut.
const CUT: char = '~';

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
        let vectors = first.map_or(&[][..], |t| &t.vectors);
        let points = first.map_or(&[][..], |t| &t.points);
        let rows = [
            short_names(&vectors.iter().map(|v| v.name.as_str()).collect::<Vec<_>>()),
            short_names(&points.iter().map(|p| p.name.as_str()).collect::<Vec<_>>()),
        ];
        let names = rows.iter().flatten().map(|name| name.chars().count());
        let names = names.chain([Part::Vectors.title().len()]).max();
        let column = |part, (figure, opens): (Figure, bool)| Column {
            figure,
            unit: figure.unit(unit),
            format: figure.format(samples, part),
            opens,
            starred: part == Part::Vectors
                && first.is_some_and(|t| figure.entries(t, part).any(|entry| !entry.given)),
        };
        Sheet {
            vectors: VECTOR_FIGURES.map(|f| column(Part::Vectors, f)).into(),
            points: POINT_FIGURES.map(|f| column(Part::Points, f)).into(),
            rows,
            fixed: points.iter().map(|point| point.fixed).collect(),
            names: names.unwrap_or(0),
        }
    }

    /// Columns for differences that look like these over the motion: angles have a sign.
    pub(crate) fn of_differences(samples: &[Tables]) -> Self {
        let mut sheet = Sheet::new(samples);
        for column in sheet.vectors.iter_mut().chain(&mut sheet.points) {
            if column.format == Format::ANGLE {
                column.format = Format::SIGNED_ANGLE;
            }
        }
        sheet
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
        let mut lines = Vec::new();
        let heading = self.heading(part, width, glyphs);
        for chunk in self.chunks(part, width, glyphs) {
            let rows = self.rows_of(part, &chunk);
            if rows.is_empty() {
                continue;
            }
            if !lines.is_empty() {
                lines.push(Line::Blank);
            }
            lines.push(Line::Names(part, chunk.clone()));
            if heading == Heading::Two {
                lines.push(Line::Units(part, chunk.clone()));
            }
            lines.extend(
                rows.into_iter()
                    .map(|row| Line::Row(part, row, chunk.clone())),
            );
        }
        lines
    }

    /// The rows that these columns have something to say about: what never moves has positions alone.
    fn rows_of(&self, part: Part, chunk: &Range<usize>) -> Vec<usize> {
        let rows = 0..self.rows[part as usize].len();
        let positions = chunk.start == 0;
        rows.filter(|&row| part == Part::Vectors || positions || !self.fixed[row])
            .collect()
    }

    /// Whether all columns of a part have their units behind their names or below them.
    fn heading(&self, part: Part, width: usize, glyphs: Glyphs) -> Heading {
        let mut chunks = self.chunks(part, width, glyphs).into_iter();
        if chunks.all(|chunk| self.needed(part, chunk, glyphs, Heading::One) <= width) {
            Heading::One
        } else {
            Heading::Two
        }
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
            .map(|(part, pair)| self.needed(part, pair, glyphs, Heading::Two))
            .max();
        let all = 0..self.vectors.len();
        let wide = self.needed(Part::Vectors, all, glyphs, Heading::Two);
        (narrow.unwrap_or(0), wide)
    }

    /// Columns that fit side by side, cut where a new order begins if that is possible.
    fn chunks(&self, part: Part, width: usize, glyphs: Glyphs) -> Vec<Range<usize>> {
        let columns = self.columns(part);
        let mut chunks = Vec::new();
        let mut start = 0;
        while start < columns.len() {
            let fits = |end: &usize| self.needed(part, start..*end, glyphs, Heading::Two) <= width;
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
    fn needed(&self, part: Part, chunk: Range<usize>, glyphs: Glyphs, heading: Heading) -> usize {
        let columns = self.columns(part)[chunk].iter();
        self.names + columns.map(|c| 1 + c.width(glyphs, heading)).sum::<usize>()
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
        let heading = self.heading(part, width, glyphs);
        let needed = self.needed(part, chunk.clone(), glyphs, heading);
        // Room to spare widens the gaps between columns, but not so far that rows fall apart.
        let gap = 1 + (width.saturating_sub(needed) / chunk.len().max(1)).min(WIDEST_GAP);
        let cells = self.columns(part)[chunk].iter().map(|column| {
            let (Written { text, unsure }, mark) = match line {
                Line::Row(_, row, _) => column.cell(tables, part, *row),
                Line::Units(..) => (Written::sure(column.unit(glyphs)), None),
                Line::Names(..) | Line::Blank => {
                    (Written::sure(column.title(glyphs, heading)), None)
                }
            };
            let mark = column.starred.then_some(mark.unwrap_or(' '));
            Shown {
                text: text.chars().chain(mark).collect(),
                width: gap + column.width(glyphs, heading),
                unsure,
            }
        });
        let name = match line {
            Line::Row(part, row, _) => self.rows[*part as usize].get(*row).map(String::as_str),
            Line::Names(part, _) => Some(part.title()),
            Line::Units(..) | Line::Blank => None,
        };
        (self.name(name.unwrap_or_default()), cells.collect())
    }

    fn name(&self, name: &str) -> Shown {
        Shown {
            text: name.to_owned(),
            width: self.names,
            unsure: Unsure::Nothing,
        }
    }
}

/// Where the units of columns stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Heading {
    /// Behind the names: `r [mm]`.
    One,
    /// In a line of their own.
    Two,
}

/// The names, none longer than may be, and those that differ still different: a name is cut behind its
/// beginning, or where others begin alike, around the first part that it shares with no other.
fn short_names(names: &[&str]) -> Vec<String> {
    const HEAD: usize = LONGEST_NAME - 1;
    const INNER: usize = LONGEST_NAME - 2;
    let mut heads = HashMap::new();
    let mut parts = HashMap::new();
    for name in names {
        *heads.entry(name.get(..HEAD)).or_insert(0) += 1;
        for at in 0..name.len() {
            *parts.entry(name.get(at..at + INNER)).or_insert(0) += 1;
        }
    }
    let short = |name: &&str| -> String {
        // Names of scenes are ASCII: a byte is a character.
        if name.len() <= LONGEST_NAME || !name.is_ascii() {
            return name.chars().take(LONGEST_NAME).collect();
        }
        let last = name.len() - INNER;
        if heads[&name.get(..HEAD)] == 1 {
            return format!("{}{CUT}", &name[..HEAD]);
        }
        let different = |at: &usize| parts[&name.get(*at..at + INNER)] == 1;
        // Whole words are known again most easily.
        let words = (1..=last).filter(|&at| !name.as_bytes()[at - 1].is_ascii_alphanumeric());
        match words.chain(1..=last).find(different) {
            Some(at) if at < last => format!("{CUT}{}{CUT}", &name[at..at + INNER]),
            _ => format!("{CUT}{}", &name[name.len() - HEAD..]),
        }
    };
    names.iter().map(short).collect()
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

    fn title(&self, glyphs: Glyphs, heading: Heading) -> String {
        let symbol = self.figure.symbol(glyphs);
        match heading {
            Heading::One => format!("{symbol} [{}]", self.unit(glyphs)),
            Heading::Two => symbol.to_owned(),
        }
    }

    fn width(&self, glyphs: Glyphs, heading: Heading) -> usize {
        // Asked for many times a frame: counted without writing anything.
        let symbol = self.figure.symbol(glyphs).chars().count();
        let unit = match glyphs {
            Glyphs::Ascii | Glyphs::Line => self.unit.len(),
            Glyphs::Braille => self.unit.len() - self.unit.matches("^2").count(),
        };
        let title = match heading {
            Heading::One => symbol + unit + " []".len(),
            Heading::Two => symbol.max(unit),
        };
        title.max(self.format.width()) + usize::from(self.starred)
    }

    /// The figure, and the mark of one that was found.
    fn cell(&self, tables: &Tables, part: Part, row: usize) -> (Written, Option<char>) {
        let Some(entry) = self.figure.entry(tables, part, row) else {
            return (Written::sure(String::new()), None);
        };
        let text = match self.figure {
            Figure::Turning(0) | Figure::Bearing(_) => self.format.write_angle(&entry),
            _ => self.format.write(&entry),
        };
        let found = entry.value.is_some() && !entry.given;
        (text, found.then_some(FOUND))
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
    fn entries(self, tables: &Tables, part: Part) -> impl Iterator<Item = Entry> {
        let rows = match part {
            Part::Vectors => tables.vectors.len(),
            Part::Points => tables.points.len(),
        };
        (0..rows).filter_map(move |row| self.entry(tables, part, row))
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
        let (order, figure) = match self {
            Figure::AlongX(order) => (order, 0),
            Figure::AlongY(order) => (order, 1),
            Figure::Size(order) => (order, 2),
            Figure::Bearing(order) => (order, 3),
            Figure::Length(_) | Figure::Turning(_) => return Entry::NONE,
        };
        let plane = point.motion[order].as_ref();
        plane.map_or(Entry::NONE, |plane| plane.entries(point.fixed)[figure])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, presets};
    use crate::solver::{Order, Solver};

    #[test]
    fn names_are_cut_so_that_they_still_differ() {
        let short = short_names(&[
            "r2",
            "upper_rod",
            "connecting_rod",
            "crank_pin_upper",
            "crank_pin_lower",
            "driving_crank_of_the_press",
            "driving_rod_of_the_press",
        ]);
        let expected = [
            "r2",
            "upper_rod",
            "connecti~",
            "~pin_upp~",
            "~pin_low~",
            "~crank_o~",
            "~rod_of_~",
        ];
        assert_eq!(short, expected);
        // Nothing tells a name from a longer one that begins with it; the longer one is told apart.
        let nested = short_names(&["crank_pin_upper", "crank_pin_upper_2"]);
        assert_eq!(nested, ["~in_upper", "~_upper_2"]);
    }

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
                    let fixed = tables.points.iter().filter(|p| p.fixed).count();
                    // What never moves may be left out where there are rates alone.
                    let all = 6 * vectors + 10 * points;
                    assert!((all - 8 * fixed..=all).contains(&shown), "{}", tables.scene);
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
