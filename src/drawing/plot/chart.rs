//! Charts of marked points against two logarithmic axes.
//!
//! ```text
//! error
//! 1e-3 |  e......
//!      |        :     f
//! 1e-15|        :...a
//!      +---+---------+-----
//!        10 ns    100 ns   time
//! ```
//!
//! Every point is a letter, which a list next to the chart explains. The best front contains the
//! points that no other point beats in both directions; dotted steps join them.

use super::frame::{FrameGlyphs, length, write};
use super::layout::CellScale;
use crate::drawing::cells::raster::Raster;
use crate::drawing::cells::render::Glyphs;
use crate::drawing::figure::Role;
use crate::wording::words;

/// A point of a chart. Both coordinates must be positive and finite; other points are left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Datum {
    /// The coordinate along the horizontal axis.
    pub x: f64,
    /// The coordinate along the vertical axis.
    pub y: f64,
    /// The letter that marks the point.
    pub letter: char,
    /// `true` if the point is on the best front.
    pub best: bool,
}

/// A logarithmic axis: its title and the labels of the powers of ten.
#[derive(Clone, Debug)]
pub struct DecadeAxis {
    /// The title.
    pub title: String,
    /// Returns the label of ten to this power.
    pub label: fn(i32) -> String,
}

/// The error at which smaller errors and zeros are plotted: below the rounding error of a double.
const MIN_ERROR: f64 = 1e-17;

/// Points against two logarithmic axes; small values are better on both.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The horizontal axis.
    pub x: DecadeAxis,
    /// The vertical axis.
    pub y: DecadeAxis,
    /// The points. If two are in one cell, the best one, and then the first one, keeps it.
    pub data: Vec<Datum>,
}

impl Chart {
    /// Creates a chart of errors; the vertical coordinates of its points may be 0.
    pub(super) fn of_errors(x: DecadeAxis, data: impl Iterator<Item = Datum>) -> Chart {
        let datum = |datum: Datum| Datum {
            y: datum.y.max(MIN_ERROR),
            ..datum
        };
        let y = DecadeAxis {
            title: words().error_of_iteration().into(),
            label: |power| format!("1e{power}"),
        };
        let data = data.map(datum).collect();
        Chart { x, y, data }
    }
}

/// Returns the glyphs of the front's steps: along a row, and down a column.
fn steps(glyphs: Glyphs) -> [char; 2] {
    match glyphs {
        Glyphs::Ascii => ['.', ':'],
        Glyphs::Line => ['\u{b7}', '\u{b7}'],
        Glyphs::Braille => ['\u{2824}', '\u{2847}'],
        Glyphs::Blocks(_) => ['\u{2584}', '\u{258c}'],
    }
}

/// A range of whole decades.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Decades {
    /// The exponent of ten at the low end.
    low: i32,
    count: i32,
}

impl Decades {
    /// Returns the smallest range of decades that contains all values.
    fn around(values: impl Iterator<Item = f64>) -> Decades {
        let (mut low, mut high) = (i32::MAX, i32::MIN);
        for value in values {
            let power = value.log10();
            low = low.min(power.floor() as i32);
            high = high.max(power.ceil() as i32);
        }
        if low > high {
            (low, high) = (0, 1);
        }
        let count = (high - low).max(1);
        Decades { low, count }
    }

    /// Returns the exponents of ten at both ends.
    fn ends(self) -> [f64; 2] {
        [self.low, self.low + self.count].map(f64::from)
    }

    /// Returns the largest number of rows, up to `rows`, on which the labelled powers are evenly
    /// spaced.
    fn even_rows(self, rows: i32) -> i32 {
        let powers: Vec<i32> = self.ticks(rows, LABEL_ROWS).collect();
        let [low, high] = self.ends();
        let is_even = |rows: &i32| {
            let scale = CellScale::perpendicular_up(low, high, 0, *rows, 0.5);
            let rows = powers
                .windows(2)
                .map(|pair| cell(&scale, f64::from(pair[0])) - cell(&scale, f64::from(pair[1])));
            let rows: Vec<i32> = rows.collect();
            rows.windows(2).all(|pair| pair[0] == pair[1])
        };
        (MIN_VALUE..=rows).rev().find(is_even).unwrap_or(rows)
    }

    /// Returns the exponents to label along `cells` cells: as many as leave `space` cells to each.
    fn ticks(self, cells: i32, space: i32) -> impl Iterator<Item = i32> {
        let fits = |every: &i32| {
            let labels = self.count / every;
            labels < 1 || (cells - 1) * every / self.count >= space
        };
        let every = (1..=self.count).find(fits).unwrap_or(self.count);
        let powers = self.low..=self.low + self.count;
        powers.filter(move |power| power.rem_euclid(every) == 0)
    }
}

/// Number of rows in addition to those of the points: the title above, the axis and its labels
/// below.
const FRAME_ROWS: i32 = 3;
/// Minimum number of rows and of columns of a chart's points.
const MIN_VALUE: i32 = 2;
/// Minimum distance of labels of the vertical axis, in rows.
const LABEL_ROWS: i32 = 2;

impl Chart {
    /// Renders the chart in `cols` x `rows` cells; empty if that is too small.
    #[must_use]
    pub fn render(&self, cols: u16, rows: u16, glyphs: Glyphs) -> Raster {
        let mut raster = Raster::new();
        raster.reset(cols, rows);
        let mut data = self.data.clone();
        data.retain(|d| [d.x, d.y].iter().all(|&v| v > 0.0 && v.is_finite()));
        // The best points are placed first and keep their cells.
        data.sort_by_key(|d| !d.best);
        let height = i32::from(rows) - FRAME_ROWS;
        let upright = Decades::around(data.iter().map(|d| d.y));
        let labels = upright.ticks(height, 1).map(self.y.label);
        let margin = labels.map(|label| length(&label)).max().unwrap_or(0);
        let width = i32::from(cols) - margin - 1;
        if height < MIN_VALUE || width < MIN_VALUE {
            return raster;
        }
        let level = Decades::around(data.iter().map(|d| d.x));
        let ([left, right], [low, high]) = (level.ends(), upright.ends());
        let shown = upright.even_rows(height);
        let painter = ChartPainter {
            chart: self,
            axis: margin,
            end: margin + 1 + width,
            foot: height + 1,
            decades: [level, upright],
            x: CellScale::along(left, right, margin + 1, width, 0.5),
            y: CellScale::perpendicular_up(low, high, 1 + height - shown, shown, 0.5),
            strokes: FrameGlyphs::of(glyphs),
        };
        painter.frame(&mut raster);
        painter.front(&data, steps(glyphs), &mut raster);
        painter.letters(&data, &mut raster);
        raster
    }
}

/// The positions of a chart's parts.
struct ChartPainter<'a> {
    chart: &'a Chart,
    /// The column of the vertical axis, to the right of its labels.
    axis: i32,
    /// The column after the last one.
    end: i32,
    /// The row of the horizontal axis.
    foot: i32,
    /// The decades of the horizontal and of the vertical axis.
    decades: [Decades; 2],
    /// The scale from exponents of ten to columns.
    x: CellScale,
    /// The scale from exponents of ten to rows.
    y: CellScale,
    strokes: FrameGlyphs,
}

impl ChartPainter<'_> {
    fn frame(&self, raster: &mut Raster) {
        let y = &self.chart.y;
        self.strokes.draw_upright(self.axis, 1..self.foot, raster);
        self.strokes
            .draw_level(self.axis..self.end, self.foot, raster);
        write(raster, 0, 0, &y.title, Role::Axis);
        for power in self.decades[1].ticks(self.foot - 1, LABEL_ROWS) {
            let row = cell(&self.y, f64::from(power));
            self.strokes
                .draw_label((self.axis, row), &(y.label)(power), raster);
        }
        self.level_labels(raster);
    }

    /// Draws the labels of the horizontal axis, centred below their ticks, and its title at the
    /// right end or above.
    fn level_labels(&self, raster: &mut Raster) {
        let Chart { x, y, .. } = self.chart;
        let (decades, end) = (self.decades[0], self.end);
        let powers = decades.low..=decades.low + decades.count;
        let widest = powers.map(|power| length(&(x.label)(power))).max();
        let ticks = decades.ticks(end - self.axis - 1, widest.unwrap_or(0) + 2);
        let mut free = 0;
        for power in ticks {
            let label = (x.label)(power);
            let col = cell(&self.x, f64::from(power));
            raster.set_cell(col, self.foot, self.strokes.tick, Role::Axis);
            let from = (col - length(&label) / 2).min(end - length(&label));
            if from >= free {
                write(raster, from, self.foot + 1, &label, Role::Axis);
                free = from + length(&label) + 2;
            }
        }
        // If the labels leave no space, the title above names both axes.
        let at_end = end - length(&x.title);
        if free <= at_end {
            write(raster, at_end, self.foot + 1, &x.title, Role::Axis);
        } else {
            let over = format!(" {}", words().over(&x.title));
            let from = length(&y.title);
            if from + length(&over) <= end {
                write(raster, from, 0, &over, Role::Axis);
            }
        }
    }

    fn place(&self, datum: &Datum) -> (i32, i32) {
        (
            cell(&self.x, datum.x.log10()),
            cell(&self.y, datum.y.log10()),
        )
    }

    /// Draws the steps from each point of the front to the next: first along x at equal y, then
    /// down.
    fn front(&self, data: &[Datum], [along, down]: [char; 2], raster: &mut Raster) {
        let mut best: Vec<_> = data.iter().filter(|d| d.best).collect();
        best.sort_by(|a, b| a.x.total_cmp(&b.x));
        let cells: Vec<_> = best.into_iter().map(|d| self.place(d)).collect();
        for pair in cells.windows(2) {
            let [(col, row), (next_col, next_row)] = [pair[0], pair[1]];
            for row in row.min(next_row)..=row.max(next_row) {
                raster.set_cell(next_col, row, down, Role::Front);
            }
            for col in col..=next_col {
                raster.set_cell(col, row, along, Role::Front);
            }
        }
    }

    /// Draws the letters. A letter whose cell is occupied is moved to a free neighbour, or left out
    /// if there is none.
    fn letters(&self, data: &[Datum], raster: &mut Raster) {
        const NEAR: [(i32, i32); 7] = [(0, 0), (1, 0), (-1, 0), (0, -1), (0, 1), (2, 0), (-2, 0)];
        let mut taken: Vec<(i32, i32)> = Vec::new();
        for datum in data {
            let (col, row) = self.place(datum);
            let mut places = NEAR.iter().map(|(right, down)| (col + right, row + down));
            let inside = |&(col, row): &(i32, i32)| {
                (self.axis + 1..self.end).contains(&col) && (1..self.foot).contains(&row)
            };
            let Some(place) = places.find(|place| inside(place) && !taken.contains(place)) else {
                continue;
            };
            taken.push(place);
            let role = if datum.best { Role::Front } else { Role::Datum };
            raster.set_cell(place.0, place.1, datum.letter, role);
        }
    }
}

/// Returns the cell of a power of ten.
fn cell(scale: &CellScale, power: f64) -> i32 {
    scale.place(power).floor() as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn chart(data: Vec<Datum>) -> Chart {
        Chart {
            x: DecadeAxis {
                title: "time".into(),
                label: |power| format!("{} ns", 10_u64.pow(power.clamp(0, 9).unsigned_abs())),
            },
            y: DecadeAxis {
                title: "error".into(),
                label: |power| format!("1e{power}"),
            },
            data,
        }
    }

    /// Returns the chart of the values measured for the lectures' four-bar, from section 8 of the
    /// notes on numerics.
    fn measured() -> Chart {
        let data = [
            ('a', 57.0, 3.0e-16, true),
            ('b', 97.0, 1.0e-16, true),
            ('e', 25.0, 1.7e-7, true),
            ('f', 264.0, 2.3e-10, false),
            ('g', 157.0, 3.4e-16, false),
            ('h', 157.0, 3.4e-16, false),
            ('i', 200.0, 2.3e-16, false),
            ('p', 5869.0, 6.9e-16, false),
            ('q', 346.0, 6e-8, false),
            ('r', 346.0, 6e-5, false),
        ];
        let datum = |(letter, x, y, best)| Datum { x, y, letter, best };
        chart(data.map(datum).to_vec())
    }

    #[test]
    fn chart_matches_snapshots() {
        let text = measured().render(60, 16, Glyphs::Ascii).text();
        insta::assert_snapshot!("chart-ascii-60x16", text);
        let text = measured().render(40, 10, Glyphs::Ascii).text();
        insta::assert_snapshot!("chart-ascii-40x10", text);
        let text = measured().render(60, 16, Glyphs::Braille).text();
        insta::assert_snapshot!("chart-braille-60x16", text);
    }

    #[test]
    fn letter_moves_next_to_occupied_cell() {
        let text = measured().render(60, 16, Glyphs::Ascii).text();
        let near = |line: &str| line.contains("gh") || line.contains("hg");
        assert!(text.lines().any(near), "{text}");
    }

    /// Values near the ends of the range of `f64`, in a very small chart.
    #[test]
    fn extreme_doubles_fit_smallest_chart() {
        let datum = Datum {
            x: 4.179_692_941_387_758e177,
            y: 2.473_731_844_8e-310,
            letter: 'x',
            best: false,
        };
        let raster = chart(vec![datum]).render(9, 5, Glyphs::Ascii);
        assert_eq!((raster.cols(), raster.rows()), (9, 5));
    }

    proptest! {
        #[test]
        fn any_data_render_at_any_size(
            data in prop::collection::vec((any::<f64>(), any::<f64>(), any::<bool>()), 0..30),
            (cols, rows) in (0_u16..100, 0_u16..40),
        ) {
            let datum = |(x, y, best)| Datum { x, y, letter: 'x', best };
            let chart = chart(data.into_iter().map(datum).collect());
            for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
                let raster = chart.render(cols, rows, glyphs);
                prop_assert_eq!((raster.cols(), raster.rows()), (cols, rows));
                prop_assert!(glyphs != Glyphs::Ascii || raster.text().is_ascii());
            }
        }

        #[test]
        fn single_point_has_a_letter(x in 1e-3..1e9_f64, y in 1e-17..1.0_f64) {
            let one = Datum { x, y, letter: 'x', best: true };
            let text = chart(vec![one]).render(60, 16, Glyphs::Ascii).text();
            prop_assert_eq!(text.matches('x').count(), 1, "{}", text);
        }
    }
}
