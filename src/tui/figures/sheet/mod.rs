//! The tables as columns that fit a width: which figures stand side by side, and in which form.

mod column;
mod names;

use crate::drawing::Glyphs;
use crate::report::{Entry, Tables};
use crate::tui::figures::format::{Unsure, Written};
use column::{Column, Heading, POINT_FIGURES, VECTOR_FIGURES};
use names::short_names;
use std::ops::Range;

pub(crate) use column::FOUND;

/// The two parts of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// The vectors of the loop equations.
    Vectors,
    /// Joints, centres of mass and other points.
    Points,
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

impl Sheet {
    /// Columns for tables that look like these over the motion.
    pub(crate) fn new(samples: &[Tables]) -> Self {
        let first = samples.first();
        let vectors = first.map_or(&[][..], |t| &t.vectors);
        let points = first.map_or(&[][..], |t| &t.points);
        let rows = [
            short_names(&vectors.iter().map(|v| v.name.as_str()).collect::<Vec<_>>()),
            short_names(&points.iter().map(|p| p.name.as_str()).collect::<Vec<_>>()),
        ];
        let names = rows.iter().flatten().map(|name| name.chars().count());
        let names = names.chain([Part::Vectors.title().len()]).max();
        let column = |part, figure| Column::new(samples, part, figure);
        Sheet {
            vectors: VECTOR_FIGURES.map(|f| column(Part::Vectors, f)).into(),
            points: POINT_FIGURES.map(|f| column(Part::Points, f)).into(),
            rows,
            fixed: points.iter().map(|point| point.fixed).collect(),
            names: names.unwrap_or(0),
        }
    }

    /// How many rows a part has.
    pub(crate) fn row_count(&self, part: Part) -> usize {
        self.rows[part as usize].len()
    }

    /// The names of all figures of a part, with their units: `vx [mm/s]`.
    pub(crate) fn headers(&self, part: Part) -> impl Iterator<Item = String> {
        self.columns(part).iter().map(Column::header)
    }

    /// The unit of a figure.
    pub(crate) fn unit(&self, part: Part, column: usize) -> Option<&str> {
        self.columns(part).get(column).map(Column::plain_unit)
    }

    /// All figures of a row; `None` for those that it does not have at all.
    pub(crate) fn entries(&self, tables: &Tables, part: Part, row: usize) -> Vec<Option<Entry>> {
        let columns = self.columns(part).iter();
        columns
            .map(|column| column.entry(tables, part, row))
            .collect()
    }

    /// Columns for differences that look like these over the motion: angles have a sign.
    pub(crate) fn of_differences(samples: &[Tables]) -> Self {
        let mut sheet = Sheet::new(samples);
        let columns = sheet.vectors.iter_mut().chain(&mut sheet.points);
        columns.for_each(Column::give_sign);
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

/// Beyond one column, and beyond this, room to spare stays at the right.
const WIDEST_GAP: usize = 4;

impl Part {
    pub(crate) fn title(self) -> &'static str {
        match self {
            Part::Vectors => "vector",
            Part::Points => "point",
        }
    }

    /// The whole name of a row; nothing where there is no such row.
    pub(crate) fn name(self, tables: &Tables, row: usize) -> &str {
        let name = match self {
            Part::Vectors => tables.vectors.get(row).map(|vector| &vector.name),
            Part::Points => tables.points.get(row).map(|point| &point.name),
        };
        name.map_or("", String::as_str)
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
            let _ = solver.solve(start, Order::Acceleration, &mut state);
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
