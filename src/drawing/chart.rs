//! Charts of marked points against two axes that count decades.
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
//! Every point is a letter, so that a list beside the chart says what it is. The best front - the
//! points that no other one beats in both directions - is joined by dotted steps.

use super::figure::Role;
use super::raster::Raster;
use super::render::Glyphs;

/// A point of a chart; both coordinates positive and finite, others are left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Datum {
    /// Along the level axis.
    pub x: f64,
    /// Along the upright axis.
    pub y: f64,
    /// What stands there.
    pub letter: char,
    /// Whether it is of the best front.
    pub best: bool,
}

/// An axis: what it counts, and what stands at each power of ten.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What it counts.
    pub title: String,
    /// The text at ten to this power.
    pub label: fn(i32) -> String,
}

/// Points against two logarithmic axes; small is good on both.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The level axis.
    pub x: Axis,
    /// The upright axis.
    pub y: Axis,
    /// The points; of two in one cell the best, and then the first, keeps it.
    pub data: Vec<Datum>,
}

/// The glyphs of a chart.
struct Strokes {
    upright: char,
    level: char,
    corner: char,
    tick: char,
    along: char,
    down: char,
}

impl Strokes {
    fn of(glyphs: Glyphs) -> Strokes {
        let [upright, level, corner, tick, along, down] = match glyphs {
            Glyphs::Ascii => ['|', '-', '+', '+', '.', ':'],
            // Every console font has these; the half-crossings not all.
            Glyphs::Line => ['\u{2502}', '\u{2500}', '\u{2514}', '+', '\u{b7}', '\u{b7}'],
            Glyphs::Braille => [
                '\u{2502}', '\u{2500}', '\u{2514}', '+', '\u{2824}', '\u{2847}',
            ],
        };
        Strokes {
            upright,
            level,
            corner,
            tick,
            along,
            down,
        }
    }
}

/// Whole decades along a number of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Scale {
    /// The power of ten at the first cell.
    low: i32,
    decades: i32,
    cells: i32,
}

impl Scale {
    /// The decades that hold all values; one that is a power of ten itself needs no further one.
    fn around(values: impl Iterator<Item = f64>, cells: i32) -> Scale {
        let (mut low, mut high) = (i32::MAX, i32::MIN);
        for value in values {
            let power = value.log10();
            low = low.min(power.floor() as i32);
            high = high.max(power.ceil() as i32);
        }
        if low > high {
            (low, high) = (0, 1);
        }
        Scale {
            low,
            decades: (high - low).max(1),
            cells,
        }
    }

    /// The cell of ten to this power, counted from the low end.
    fn cell(self, power: f64) -> i32 {
        let share = (power - f64::from(self.low)) / f64::from(self.decades);
        (share * f64::from(self.cells - 1)).round() as i32
    }

    /// The powers of ten to be labelled, and their cells: as many as leave `room` cells to each.
    fn ticks(self, room: i32) -> impl Iterator<Item = (i32, i32)> {
        let fits = |every: &i32| {
            let labels = self.decades / every;
            labels < 1 || (self.cells - 1) * every / self.decades >= room
        };
        let every = (1..=self.decades).find(fits).unwrap_or(self.decades);
        let powers = self.low..=self.low + self.decades;
        powers
            .filter(move |power| power.rem_euclid(every) == 0)
            .map(move |power| (power, self.cell(f64::from(power))))
    }
}

/// Rows of a chart beside its points: the title above, the axis and its labels below.
const FRAME_ROWS: i32 = 3;
/// Fewer cells than this are no chart.
const LEAST: i32 = 2;

impl Chart {
    /// The chart in `cols` x `rows` cells; empty where there is no room for it.
    #[must_use]
    pub fn render(&self, cols: u16, rows: u16, glyphs: Glyphs) -> Raster {
        let mut raster = Raster::new();
        raster.reset(cols, rows);
        let mut data = self.data.clone();
        data.retain(|d| [d.x, d.y].iter().all(|&v| v > 0.0 && v.is_finite()));
        // The best are placed first and keep their cells.
        data.sort_by_key(|d| !d.best);
        let height = i32::from(rows) - FRAME_ROWS;
        let upright = Scale::around(data.iter().map(|d| d.y), height);
        let labels = upright.ticks(1).map(|(power, _)| (self.y.label)(power));
        let margin = labels.map(|label| length(&label)).max().unwrap_or(0);
        let width = i32::from(cols) - margin - 1;
        if height < LEAST || width < LEAST {
            return raster;
        }
        let plot = Plot {
            left: margin + 1,
            foot: height,
            level: Scale::around(data.iter().map(|d| d.x), width),
            upright,
        };
        plot.frame(self, &Strokes::of(glyphs), &mut raster);
        plot.front(&data, &Strokes::of(glyphs), &mut raster);
        plot.letters(&data, &mut raster);
        raster
    }
}

/// Where the points of a chart are.
struct Plot {
    /// The first column behind the upright axis.
    left: i32,
    /// The last row above the level axis.
    foot: i32,
    level: Scale,
    upright: Scale,
}

impl Plot {
    fn frame(&self, chart: &Chart, strokes: &Strokes, raster: &mut Raster) {
        let axis = self.left - 1;
        let base = self.foot + 1;
        for row in 1..base {
            raster.put(axis, row, strokes.upright, Role::Axis);
        }
        for col in self.left..self.left + self.level.cells {
            raster.put(col, base, strokes.level, Role::Axis);
        }
        raster.put(axis, base, strokes.corner, Role::Axis);
        write(raster, 0, 0, &chart.y.title);
        for (power, cell) in self.upright.ticks(2) {
            let label = (chart.y.label)(power);
            let row = self.foot - cell;
            write(raster, axis - length(&label), row, &label);
            raster.put(axis, row, strokes.tick, Role::Axis);
        }
        self.level_labels(chart, strokes, raster);
    }

    /// Labels of the level axis, centred below their ticks, and its title at the right end or above.
    fn level_labels(&self, chart: &Chart, strokes: &Strokes, raster: &mut Raster) {
        let base = self.foot + 1;
        let end = self.left + self.level.cells;
        let powers = self.level.low..=self.level.low + self.level.decades;
        let widest = powers.map(|power| length(&(chart.x.label)(power))).max();
        let title = length(&chart.x.title);
        let mut free = 0;
        for (power, cell) in self.level.ticks(widest.unwrap_or(0) + 2) {
            let label = (chart.x.label)(power);
            let col = self.left + cell;
            raster.put(col, base, strokes.tick, Role::Axis);
            let from = (col - length(&label) / 2).min(end - length(&label));
            if from >= free {
                write(raster, from, base + 1, &label);
                free = from + length(&label) + 2;
            }
        }
        // Where the labels leave no room, the title above names both.
        if free <= end - title {
            write(raster, end - title, base + 1, &chart.x.title);
        } else {
            let over = format!(" over {}", chart.x.title);
            let from = length(&chart.y.title);
            if from + length(&over) <= end {
                write(raster, from, 0, &over);
            }
        }
    }

    fn cell(&self, datum: &Datum) -> (i32, i32) {
        let col = self.left + self.level.cell(datum.x.log10());
        (col, self.foot - self.upright.cell(datum.y.log10()))
    }

    /// Steps from each point of the front to the next one: on at the same error, then down.
    fn front(&self, data: &[Datum], strokes: &Strokes, raster: &mut Raster) {
        let mut best: Vec<_> = data.iter().filter(|d| d.best).collect();
        best.sort_by(|a, b| a.x.total_cmp(&b.x));
        let cells: Vec<_> = best.into_iter().map(|d| self.cell(d)).collect();
        for pair in cells.windows(2) {
            let [(col, row), (next_col, next_row)] = [pair[0], pair[1]];
            for row in row.min(next_row)..=row.max(next_row) {
                raster.put(next_col, row, strokes.down, Role::Front);
            }
            for col in col..=next_col {
                raster.put(col, row, strokes.along, Role::Front);
            }
        }
    }

    /// The letters; one whose cell is taken stands beside it, or is left out where there is no room.
    fn letters(&self, data: &[Datum], raster: &mut Raster) {
        const NEAR: [(i32, i32); 7] = [(0, 0), (1, 0), (-1, 0), (0, -1), (0, 1), (2, 0), (-2, 0)];
        let mut taken: Vec<(i32, i32)> = Vec::new();
        for datum in data {
            let (col, row) = self.cell(datum);
            let mut places = NEAR.iter().map(|(right, down)| (col + right, row + down));
            let inside = |&(col, row): &(i32, i32)| {
                (self.left..self.left + self.level.cells).contains(&col)
                    && (1..=self.foot).contains(&row)
            };
            let Some(place) = places.find(|place| inside(place) && !taken.contains(place)) else {
                continue;
            };
            taken.push(place);
            let role = if datum.best { Role::Front } else { Role::Datum };
            raster.put(place.0, place.1, datum.letter, role);
        }
    }
}

fn length(text: &str) -> i32 {
    i32::try_from(text.chars().count()).unwrap_or(i32::MAX)
}

fn write(raster: &mut Raster, col: i32, row: i32, text: &str) {
    for (col, glyph) in (col..).zip(text.chars()) {
        raster.put(col, row, glyph, Role::Axis);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn chart(data: Vec<Datum>) -> Chart {
        Chart {
            x: Axis {
                title: "time".into(),
                label: |power| format!("{} ns", 10_u64.pow(power.clamp(0, 9).unsigned_abs())),
            },
            y: Axis {
                title: "error".into(),
                label: |power| format!("1e{power}"),
            },
            data,
        }
    }

    /// The figures that were measured for the four-bar of the lectures in section 8 of the notes on
    /// numerics.
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
    fn a_chart_of_fixed_data() {
        let text = measured().render(60, 16, Glyphs::Ascii).text();
        insta::assert_snapshot!("chart-ascii-60x16", text);
        let text = measured().render(40, 10, Glyphs::Ascii).text();
        insta::assert_snapshot!("chart-ascii-40x10", text);
        let text = measured().render(60, 16, Glyphs::Braille).text();
        insta::assert_snapshot!("chart-braille-60x16", text);
    }

    #[test]
    fn a_letter_whose_cell_is_taken_stands_beside_it() {
        let text = measured().render(60, 16, Glyphs::Ascii).text();
        let near = |line: &str| line.contains("gh") || line.contains("hg");
        assert!(text.lines().any(near), "{text}");
    }

    /// As far apart as doubles can be, on hardly any room.
    #[test]
    fn the_ends_of_the_doubles_fit_the_smallest_chart() {
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
        fn any_data_fit_any_size(
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
        fn every_lonely_point_has_a_letter(x in 1e-3..1e9_f64, y in 1e-17..1.0_f64) {
            let one = Datum { x, y, letter: 'x', best: true };
            let text = chart(vec![one]).render(60, 16, Glyphs::Ascii).text();
            prop_assert_eq!(text.matches('x').count(), 1, "{}", text);
        }
    }
}
