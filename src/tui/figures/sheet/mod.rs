//! Lays out the tables for a width: the columns side by side and their formats.

mod column;
mod names;

use crate::drawing::Glyphs;
use crate::page::{Cell, ColumnLayout, Line, Rest, Setting, TextRole, Units};
use crate::report::{Entry, Tables};
use column::{Column, POINT_FIGURES, VECTOR_FIGURES};
use names::short_names;
use std::ops::Range;

use crate::wording::words;
pub(crate) use column::COMPUTED_MARK;

/// The two parts of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SheetPart {
    /// The vectors of the loop equations.
    Vectors,
    /// Joints, centres of mass and other points.
    Points,
}

/// A line of the tables at some width.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum TableLine {
    /// A blank line between two chunks of columns.
    Blank,
    /// The names of columns, with their units if all of them fit into one line.
    Names(SheetPart, Range<usize>),
    /// The units of columns.
    Units(SheetPart, Range<usize>),
    /// The values of the row with this index.
    Row(SheetPart, usize, Range<usize>),
}

/// The columns of a scene's tables.
#[derive(Clone, Debug)]
pub(crate) struct Sheet {
    vectors: Vec<Column>,
    points: Vec<Column>,
    /// The names of the rows, shortened as shown.
    rows: [Vec<String>; 2],
    /// `true` for each fixed point, whose rates need no row.
    fixed: Vec<bool>,
    /// Maximum width of the rows' names.
    widest: usize,
}

impl Sheet {
    /// Creates columns for tables with these samples over the motion.
    pub(crate) fn new(samples: &[Tables]) -> Self {
        let first = samples.first();
        let vectors = first.map_or(&[][..], |t| &t.vectors);
        let points = first.map_or(&[][..], |t| &t.points);
        let rows = [
            short_names(&vectors.iter().map(|v| v.name.as_str()).collect::<Vec<_>>()),
            short_names(&points.iter().map(|p| p.name.as_str()).collect::<Vec<_>>()),
        ];
        let widths = rows.iter().flatten().map(|name| name.chars().count());
        let widest = widths.max().unwrap_or(0);
        let column = |part, figure| Column::new(samples, part, figure);
        Sheet {
            vectors: VECTOR_FIGURES.map(|f| column(SheetPart::Vectors, f)).into(),
            points: POINT_FIGURES.map(|f| column(SheetPart::Points, f)).into(),
            rows,
            fixed: points.iter().map(|point| point.fixed).collect(),
            widest,
        }
    }

    /// Returns the width of the names and of their heading in the current language.
    fn names(&self) -> usize {
        self.widest.max(SheetPart::Vectors.title().chars().count())
    }

    /// Returns the number of rows of a part.
    pub(crate) fn row_count(&self, part: SheetPart) -> usize {
        self.rows[part as usize].len()
    }

    /// Yields the names of all columns of a part with their units, such as `vx [mm/s]`.
    pub(crate) fn headers(&self, part: SheetPart) -> impl Iterator<Item = String> {
        self.columns(part).iter().map(Column::header)
    }

    /// Returns the unit of a column.
    pub(crate) fn unit(&self, part: SheetPart, column: usize) -> Option<&str> {
        self.columns(part).get(column).map(Column::plain_unit)
    }

    /// Returns all values of a row; `None` for quantities that it does not have.
    pub(crate) fn entries(
        &self,
        tables: &Tables,
        part: SheetPart,
        row: usize,
    ) -> Vec<Option<Entry>> {
        let columns = self.columns(part).iter();
        columns
            .map(|column| column.entry(tables, part, row))
            .collect()
    }

    /// Creates columns for tables of differences, in which angles are signed.
    pub(crate) fn of_differences(samples: &[Tables]) -> Self {
        let mut sheet = Sheet::new(samples);
        let columns = sheet.vectors.iter_mut().chain(&mut sheet.points);
        columns.for_each(Column::give_sign);
        sheet
    }

    /// Lays out the tables for a width.
    pub(crate) fn placed(&self, width: usize, glyphs: Glyphs) -> Placed<'_> {
        let place = |part| {
            let (columns, units) = self.place(part, width, glyphs);
            let units = columns.ranges().map(|_| units).collect();
            (columns, units)
        };
        Placed {
            sheet: self,
            glyphs,
            parts: [SheetPart::Vectors, SheetPart::Points].map(place),
            is_dense: false,
        }
    }

    /// Lays out the tables for an area. If they do not fit otherwise but would without some of their
    /// lines of units and blank lines, these are left out.
    pub(crate) fn placed_in(&self, width: usize, height: usize, glyphs: Glyphs) -> Placed<'_> {
        let usual = self.placed(width, glyphs);
        if usual.line_count() <= height {
            return usual;
        }
        let dense = self.dense(width, glyphs);
        let with_blanks = Placed {
            is_dense: false,
            ..dense.clone()
        };
        match [with_blanks, dense].map(|placed| (placed.line_count() <= height, placed)) {
            [(true, placed), _] | [_, (true, placed)] => placed,
            _ => usual,
        }
    }

    /// Lays out the tables in as few lines as possible.
    pub(crate) fn dense(&self, width: usize, glyphs: Glyphs) -> Placed<'_> {
        Placed {
            sheet: self,
            glyphs,
            parts: [SheetPart::Vectors, SheetPart::Points]
                .map(|part| self.place_densely(part, width, glyphs)),
            is_dense: true,
        }
    }

    /// Lays out the columns of a part such that as many as possible are side by side. The units
    /// follow the names on one line wherever they fit.
    fn place_densely(
        &self,
        part: SheetPart,
        width: usize,
        glyphs: Glyphs,
    ) -> (ColumnLayout, Vec<Units>) {
        let columns = self.columns(part);
        let opens = |c: usize| columns.get(c).is_none_or(|column| column.opens);
        let fit = |widths| ColumnLayout::fit(&SETTING, self.names(), widths, opens, width);
        let widths = |units| move |column: &Column| column.width(glyphs, units);
        let below = fit(columns.iter().map(widths(Units::Below)).collect());
        let mut fitted = Vec::new();
        let mut units = Vec::new();
        for chunk in below.ranges() {
            let behind = columns[chunk.clone()].iter().map(widths(Units::Behind));
            let behind: Vec<usize> = behind.collect();
            let needed = self.names() + behind.iter().map(|w| SETTING.gap + w).sum::<usize>();
            if needed <= width {
                fitted.extend(behind);
                units.push(Units::Behind);
            } else {
                fitted.extend(columns[chunk.clone()].iter().map(widths(Units::Below)));
                units.push(Units::Below);
            }
        }
        (fit(fitted), units)
    }

    /// Lays out the columns of a part. The units follow the names on one line if that does not
    /// reduce the number of columns side by side.
    fn place(&self, part: SheetPart, width: usize, glyphs: Glyphs) -> (ColumnLayout, Units) {
        let columns = self.columns(part);
        let fit = |units: Units| {
            let widths = columns.iter().map(|column| column.width(glyphs, units));
            let opens = |c: usize| columns.get(c).is_none_or(|column| column.opens);
            ColumnLayout::fit(&SETTING, self.names(), widths.collect(), opens, width)
        };
        let [after, below] = [Units::Behind, Units::Below].map(fit);
        let is_same = after.ranges().eq(below.ranges());
        if is_same && after.fits(width) {
            (after, Units::Behind)
        } else {
            (below, Units::Below)
        }
    }

    /// Returns the rows with values in these columns; fixed points have only positions.
    fn rows_of(&self, part: SheetPart, chunk: &Range<usize>) -> Vec<usize> {
        let rows = 0..self.rows[part as usize].len();
        let positions = chunk.start == 0;
        rows.filter(|&row| part == SheetPart::Vectors || positions || !self.fixed[row])
            .collect()
    }

    /// Returns the number of rows with values in these columns.
    fn row_count_of(&self, part: SheetPart, chunk: &Range<usize>) -> usize {
        match part {
            SheetPart::Points if chunk.start > 0 => {
                self.fixed.iter().filter(|is_fixed| !**is_fixed).count()
            }
            _ => self.row_count(part),
        }
    }

    /// Returns the minimum width for pairs of related columns, and the width at which all columns
    /// of a vector fit side by side.
    pub(crate) fn widths(&self, glyphs: Glyphs) -> (usize, usize) {
        let needed = |columns: &[Column]| {
            let widths = columns
                .iter()
                .map(|c| SETTING.gap + c.width(glyphs, Units::Below));
            self.names() + widths.sum::<usize>()
        };
        let pairs = self
            .vectors
            .chunks_exact(2)
            .chain(self.points.chunks_exact(2));
        let narrow = pairs.map(needed).max();
        (narrow.unwrap_or(0), needed(&self.vectors))
    }

    fn columns(&self, part: SheetPart) -> &[Column] {
        match part {
            SheetPart::Vectors => &self.vectors,
            SheetPart::Points => &self.points,
        }
    }
}

/// The tables laid out for a width.
#[derive(Clone, Debug)]
pub(crate) struct Placed<'s> {
    sheet: &'s Sheet,
    glyphs: Glyphs,
    /// The layout of each part's columns, and the place of the units of each chunk.
    parts: [(ColumnLayout, Vec<Units>); 2],
    /// `true` if no blank lines separate the chunks of a part.
    is_dense: bool,
}

impl Placed<'_> {
    /// Returns the lines of both parts.
    pub(crate) fn lines(&self) -> Vec<TableLine> {
        let mut lines = self.part(SheetPart::Vectors);
        let points = self.part(SheetPart::Points);
        if !lines.is_empty() && !points.is_empty() {
            lines.push(TableLine::Blank);
        }
        lines.extend(points);
        lines
    }

    /// Returns the number of lines of both parts.
    pub(crate) fn line_count(&self) -> usize {
        let [vectors, points] = [SheetPart::Vectors, SheetPart::Points].map(|part| {
            let (columns, units) = &self.parts[part as usize];
            let chunks = columns.ranges().zip(units);
            let heights = chunks.filter_map(|(chunk, units)| {
                let rows = self.sheet.row_count_of(part, chunk);
                (rows > 0).then_some(rows + 1 + usize::from(*units == Units::Below))
            });
            let blank = usize::from(!self.is_dense);
            let all = heights.fold(0, |all, height| all + blank + height);
            all.saturating_sub(blank)
        });
        vectors + points + usize::from(vectors > 0 && points > 0)
    }

    /// Returns the number of lines of the vectors.
    pub(crate) fn vector_lines(&self) -> usize {
        self.part(SheetPart::Vectors).len()
    }

    /// Returns the lines of one part: chunk by chunk of the columns that fit side by side.
    fn part(&self, part: SheetPart) -> Vec<TableLine> {
        let mut lines = Vec::new();
        let (columns, units) = &self.parts[part as usize];
        for (chunk, units) in columns.ranges().zip(units) {
            let rows = self.sheet.rows_of(part, chunk);
            if rows.is_empty() {
                continue;
            }
            if !lines.is_empty() && !self.is_dense {
                lines.push(TableLine::Blank);
            }
            lines.push(TableLine::Names(part, chunk.clone()));
            if *units == Units::Below {
                lines.push(TableLine::Units(part, chunk.clone()));
            }
            let row = |row| TableLine::Row(part, row, chunk.clone());
            lines.extend(rows.into_iter().map(row));
        }
        lines
    }

    /// Returns the content of a line: the name and the cells behind it.
    pub(crate) fn show(&self, line: &TableLine, tables: &Tables) -> Line {
        let (part, chunk) = match line {
            TableLine::Blank => return Line::default(),
            TableLine::Names(part, chunk)
            | TableLine::Units(part, chunk)
            | TableLine::Row(part, _, chunk) => (*part, chunk),
        };
        let (columns, units) = &self.parts[part as usize];
        let place = columns.ranges().position(|range| range == chunk);
        let units = place.and_then(|place| units.get(place));
        let shown = self.sheet.columns(part).get(chunk.clone());
        let cells = shown.unwrap_or_default().iter().map(|column| match line {
            TableLine::Row(_, row, _) => column.cell(tables, part, *row),
            TableLine::Units(..) => column.plain(column.unit(self.glyphs)),
            TableLine::Names(..) | TableLine::Blank => {
                column.plain(column.title(self.glyphs, units.copied().unwrap_or(Units::Below)))
            }
        });
        let cells: Vec<Cell> = cells.collect();
        let (name, roles) = match line {
            TableLine::Row(part, row, _) => {
                let name = self.sheet.rows[*part as usize].get(*row);
                (
                    name.map_or("", String::as_str),
                    [TextRole::Name, TextRole::Figure],
                )
            }
            TableLine::Names(part, _) => (part.title(), [TextRole::Head; 2]),
            TableLine::Units(..) | TableLine::Blank => ("", [TextRole::Head; 2]),
        };
        columns.line(chunk, ("", name), cells.iter().map(Some), roles)
    }

    /// Returns the line of a row with text in place of values.
    pub(crate) fn text_line(&self, row: (SheetPart, usize), words: &str) -> Line {
        let (part, row) = row;
        let name = self.sheet.rows[part as usize].get(row);
        let mut line = Line::of(TextRole::Name, name.map_or("", String::as_str));
        line.push(self.sheet.names() + SETTING.gap, words, TextRole::Aside);
        line
    }
}

/// The layout's settings: free columns widen the gaps, but only so far that rows stay readable.
const SETTING: Setting = Setting {
    indent: 0,
    names: 0,
    least: Vec::new(),
    gap: 1,
    spread: 4,
    units: Units::Below,
    rest: Rest::Below,
    called: TextRole::Name,
};

impl SheetPart {
    pub(crate) fn title(self) -> &'static str {
        match self {
            SheetPart::Vectors => words().vector(),
            SheetPart::Points => words().point(),
        }
    }

    /// Returns the full name of a row; empty if there is no such row.
    pub(crate) fn name(self, tables: &Tables, row: usize) -> &str {
        let name = match self {
            SheetPart::Vectors => tables.vectors.get(row).map(|vector| &vector.name),
            SheetPart::Points => tables.points.get(row).map(|point| &point.name),
        };
        name.map_or("", String::as_str)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, presets};
    use crate::solver::{Order, Solver};

    /// Returns every preset's tables at its start position.
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
    fn sheet_shows_each_value_once_within_width() {
        for tables in tables() {
            let sheet = Sheet::new(std::slice::from_ref(&tables));
            for glyphs in [Glyphs::Ascii, Glyphs::Braille] {
                let (narrow, wide) = sheet.widths(glyphs);
                assert!(narrow <= 36, "{}: {narrow}", tables.scene);
                let layouts = (narrow..=wide + 20).flat_map(|width| {
                    let both = [sheet.placed(width, glyphs), sheet.dense(width, glyphs)];
                    both.map(|placed| (width, placed))
                });
                for (width, placed) in layouts {
                    let lines = placed.lines();
                    assert_eq!(
                        lines.len(),
                        placed.line_count(),
                        "{}: {width}",
                        tables.scene
                    );
                    let figures = |row: &TableLine| placed.show(row, &tables).spans.len() - 1;
                    let rows = lines.iter().filter(|l| matches!(l, TableLine::Row(..)));
                    let shown: usize = rows.map(figures).sum();
                    let (vectors, points) = (tables.vectors.len(), tables.points.len());
                    let fixed = tables.points.iter().filter(|p| p.fixed).count();
                    // Fixed points may be omitted from blocks that contain only rates.
                    let all = 6 * vectors + 10 * points;
                    assert!((all - 8 * fixed..=all).contains(&shown), "{}", tables.scene);
                    for line in &lines {
                        let line = placed.show(line, &tables);
                        let mut end = 0;
                        for span in &line.spans {
                            // Every value follows a blank.
                            let start = span.at + usize::from(end == 0);
                            assert!(start > end, "{}: {}", tables.scene, span.text);
                            end = span.at + span.text.chars().count();
                        }
                        assert!(end <= width, "{}: {end} of {width}", tables.scene);
                    }
                }
            }
        }
    }
}
