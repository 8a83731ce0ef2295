//! Computes the layout of a plot in cells.

use super::frame::length;
use super::path::CellBlock;
use super::ticks::{TickStyle, Ticks, steps};
use super::{Axis, Plot, PlotStyle};
use crate::Vec2;
use std::ops::Range;

/// Rows of the horizontal axis and its labels, below the last panel.
const FOOT: i32 = 2;
/// Rows of the legend above each panel, and minimum rows of a panel.
const LEGEND: i32 = 1;
const MIN_BODY: i32 = 4;
/// Minimum size of a readable plot.
const MIN_ROWS: i32 = FOOT + LEGEND + 2;
const MIN_COLS: i32 = 16;
/// The distance from the edge of the first and the last cell to its middle.
const INSET: f64 = 0.5;
/// Maximum relative lengthening of an axis, which moves its ticks to the middle of rows.
const MAX_STRETCH: f64 = 0.4;
/// Maximum relative lengthening beyond the shortest axis in exchange for more ticks.
const LONGER: f64 = 0.15;
/// Number of round steps to try, from the first that fits.
const STEP_TRIALS: usize = 3;
/// Relative tolerances. A range smaller than `FLAT` times its values has no ticks. An end that
/// misses a value by less than `ROUNDED` of the range misses it by a rounding error.
const FLAT: f64 = 1e-12;
const ROUNDED: f64 = 1e-9;
/// Minimum rows from one label to the next, and maximum number of labels of an axis.
const LABEL_ROWS: i32 = 2;
const MAX_LABELS: usize = 9;
/// Blanks between two labels of the horizontal axis.
const LABEL_GAP: i32 = 2;
/// Blanks between the unit and the label after it.
const UNIT_GAP: i32 = 2;
/// A limit above any number of units.
const MAX_PANELS: i32 = 1000;
/// Height in rows above which a panel's legend may take two rows.
const TALL: i32 = 7;

/// The positions of a plot's parts, in cells.
#[derive(Debug)]
pub(super) struct PlotLayout {
    /// The column of the vertical axes, to the right of their labels.
    pub(super) axis: i32,
    /// The row of the horizontal axis; its labels are below.
    pub(super) foot: i32,
    /// The column after the last one.
    pub(super) end: i32,
    pub(super) x: CellScale,
    pub(super) x_ticks: Ticks,
    /// The visible panels, with their numbers.
    pub(super) panels: Vec<(usize, PanelArea)>,
}

/// The position of a panel.
#[derive(Debug)]
pub(super) struct PanelArea {
    /// The row of its legend.
    pub(super) legend: i32,
    /// The number of rows of its legend.
    pub(super) legend_rows: i32,
    pub(super) block: CellBlock,
    pub(super) y: CellScale,
    pub(super) ticks: Ticks,
    /// The number format of its curves' values.
    pub(super) style: TickStyle,
}

/// A linear scale from values to cells. With an inset of 0.5 the ends lie in the middle of the
/// first and the last cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CellScale {
    low: f64,
    high: f64,
    /// The place of the low end, and the signed distance from there to the high end, in cells.
    start: f64,
    length: f64,
}

impl CellScale {
    pub(super) fn along(low: f64, high: f64, from: i32, cells: i32, inset: f64) -> CellScale {
        CellScale {
            low,
            high,
            start: f64::from(from) + inset,
            length: f64::from(cells) - 2.0 * inset,
        }
    }

    pub(super) fn perpendicular_up(
        low: f64,
        high: f64,
        top: i32,
        cells: i32,
        inset: f64,
    ) -> CellScale {
        let length = f64::from(cells) - 2.0 * inset;
        CellScale {
            low,
            high,
            start: f64::from(top) + inset + length,
            length: -length,
        }
    }

    /// Creates a scale between two places in any unit.
    pub(super) fn between(low: f64, high: f64, from: f64, to: f64) -> CellScale {
        CellScale {
            low,
            high,
            start: from,
            length: to - from,
        }
    }

    /// Returns the values at both ends.
    pub(super) fn ends(&self) -> (f64, f64) {
        (self.low, self.high)
    }

    /// Returns the place of a value, in cell coordinates.
    pub(super) fn place(&self, value: f64) -> f64 {
        self.start + (value - self.low) / (self.high - self.low) * self.length
    }

    /// Returns the value at a place in cell coordinates; `None` beyond the ends.
    fn value(&self, place: f64) -> Option<f64> {
        let value = self.low + (place - self.start) / self.length * (self.high - self.low);
        Some(value).filter(|value| self.holds(*value))
    }

    pub(super) fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }

    /// Returns the cell of a value; `None` beyond the ends.
    pub(super) fn cell(&self, value: f64) -> Option<i32> {
        self.holds(value).then(|| self.place(value).floor() as i32)
    }

    /// Returns `true` if a value lies strictly between the ends.
    pub(super) fn crosses(&self, value: f64) -> bool {
        self.low < value && value < self.high
    }
}

/// Returns how many of `panels` panels fit into `rows` rows; at least one.
fn shown(panels: usize, rows: i32) -> usize {
    let space = (rows - FOOT) / (LEGEND + MIN_BODY);
    panels.min(usize::try_from(space).unwrap_or(0).max(1))
}

impl Plot {
    /// Returns how many panels are visible in `rows` rows. [`PlotStyle::first`] selects which.
    #[must_use]
    pub fn panels_in(&self, rows: u16) -> usize {
        shown(self.panels.len(), i32::from(rows))
    }

    /// Returns the number of rows in which all panels are visible.
    #[must_use]
    pub fn min_rows(&self) -> u16 {
        let panels = i32::try_from(self.panels.len())
            .unwrap_or(0)
            .min(MAX_PANELS);
        let rows = FOOT + panels * (LEGEND + MIN_BODY);
        u16::try_from(rows).unwrap_or(u16::MAX)
    }

    /// Returns `true` if the plot fits into the cells.
    #[must_use]
    pub fn fits(&self, style: &PlotStyle) -> bool {
        self.layout(style).is_some()
    }

    /// Returns the x value in the middle of a column; `None` outside the curves.
    #[must_use]
    pub fn along(&self, style: &PlotStyle, column: u16) -> Option<f64> {
        self.layout(style)?.x.value(f64::from(column) + 0.5)
    }

    /// Computes the layout; `None` if the cells do not suffice.
    pub(super) fn layout(&self, style: &PlotStyle) -> Option<PlotLayout> {
        let (cols, rows) = (i32::from(style.cols), i32::from(style.rows));
        if self.panels.is_empty() || rows < MIN_ROWS || cols < MIN_COLS {
            return None;
        }
        let count = shown(self.panels.len(), rows);
        let first = style.first.min(self.panels.len() - count);
        // Ticks and marks keep their cells for every set of glyphs.
        let inset = Vec2::new(INSET, INSET);
        let body = rows - FOOT;
        let shares = i32::try_from(count).unwrap_or(1);
        let mut frames = Vec::with_capacity(count);
        let mut top = 0;
        for (k, number) in (0..shares).zip(first..) {
            let height = (body - top) / (shares - k);
            let crowd = self.panels[number].curves.len() > 2;
            let legend_rows = LEGEND + i32::from(crowd && height > TALL);
            frames.push((number, top, legend_rows, height - legend_rows));
            top += height;
        }
        let mut panels: Vec<(usize, PanelArea)> = frames
            .into_iter()
            .map(|(number, top, legend_rows, height)| {
                let y = &self.panels[number].y;
                let top_row = top + legend_rows;
                let block = CellBlock {
                    left: 0,
                    top: top_row,
                    width: 0,
                    height,
                };
                let (scale, ticks) = upright_axis(y, top_row, height);
                let frame = PanelArea {
                    legend: top,
                    legend_rows,
                    block,
                    y: scale,
                    ticks,
                    style: y.style(),
                };
                (number, frame)
            })
            .collect();
        let widest = panels.iter().map(|(_, frame)| frame.ticks.widest()).max();
        let axis = i32::try_from(widest.unwrap_or(0)).unwrap_or(cols);
        let (left, width) = (axis + 1, cols - axis - 1);
        if width < MIN_COLS / 2 {
            return None;
        }
        let (mut low, mut high) = (self.x.low, self.x.high);
        if let ([(number, frame)], true) = (&mut panels[..], self.is_true) {
            let y = &self.panels[*number].y;
            let height = frame.block.height;
            let cells = Vec2::new(f64::from(width), f64::from(height)) - inset * 2.0;
            let ends = true_ends((low, high), (y.low, y.high), cells, style.aspect);
            (low, high) = ends[0];
            frame.y =
                CellScale::perpendicular_up(ends[1].0, ends[1].1, frame.block.top, height, inset.y);
            let ticks = Ticks::between(ends[1].0, ends[1].1, y.is_angle, labels(height));
            let ticks = thinned(&frame.y, ticks);
            // The left margin was computed for the previous labels, so longer ones do not fit.
            if i32::try_from(ticks.widest()).is_ok_and(|widest| widest <= axis) {
                frame.ticks = ticks;
            }
        }
        for (_, frame) in &mut panels {
            (frame.block.left, frame.block.width) = (left, width);
        }
        let x = CellScale::along(low, high, left, width, inset.x);
        let x_ticks = level_ticks(&x, self.x.is_angle, &self.x.unit, left..cols);
        Some(PlotLayout {
            axis,
            foot: body,
            end: cols,
            x,
            x_ticks,
            panels,
        })
    }
}

/// Returns the scale and ticks of a vertical axis. Every tick lies in the middle of a row, at a
/// constant distance in rows; the axis may be longer than its data for that. Among the axes that
/// are not much longer than the shortest one, the one with the most ticks is chosen.
fn upright_axis(y: &Axis, top: i32, height: i32) -> (CellScale, Ticks) {
    let found = (LABEL_ROWS..height).flat_map(|every| aligned(y, height, every));
    let found: Vec<AlignedAxis> = found.filter(|axis| axis.longer <= MAX_STRETCH).collect();
    let shortest = found.iter().map(|axis| axis.longer).reduce(f64::min);
    let near =
        |axis: &&AlignedAxis| shortest.is_some_and(|minimum| axis.longer <= minimum + LONGER);
    let order = |a: &&AlignedAxis, b: &&AlignedAxis| {
        let shorter = b.longer.total_cmp(&a.longer);
        a.count.cmp(&b.count).then(shorter)
    };
    if let Some(best) = found.iter().filter(near).max_by(order) {
        let ticks = Ticks::multiples(best.step, best.first, best.count);
        // Rounding may place a tick of the lowest or highest row outside the axis.
        let values = || ticks.values.iter().copied();
        let low = values().fold(best.low.min(y.low), f64::min);
        let high = values().fold(best.high.max(y.high), f64::max);
        return (
            CellScale::perpendicular_up(low, high, top, height, INSET),
            ticks,
        );
    }
    let usual = Ticks::between(y.low, y.high, y.is_angle, labels(height));
    let scale = CellScale::perpendicular_up(y.low, y.high, top, height, INSET);
    (scale, thinned(&scale, usual))
}

/// An axis on which a round step is a whole number of rows.
#[derive(Clone, Copy)]
struct AlignedAxis {
    /// The values in the middle of the lowest and the highest row.
    low: f64,
    high: f64,
    step: f64,
    /// The first tick as a multiple of the step, and the number of ticks.
    first: i64,
    count: i64,
    /// The relative excess length over the data's range.
    longer: f64,
}

/// Returns the axes with a tick in every `every` rows that contain the data and have a permitted
/// number of labels.
fn aligned(y: &Axis, height: i32, every: i32) -> impl Iterator<Item = AlignedAxis> {
    let (size, gaps) = (y.high - y.low, f64::from(height - 1));
    let rows = f64::from(every);
    // The smallest step that fits, and a few larger ones.
    let minimum = size / gaps * rows;
    let is_some = size > y.low.abs().max(y.high.abs()) * FLAT && minimum.is_normal();
    let minimum = if is_some { minimum } else { 1.0 };
    let candidates = steps(minimum, y.is_angle).skip_while(move |&step| step < minimum);
    let axis = move |step: f64| {
        let row = step / rows;
        // Spare rows are split between both sides, but not below zero if zero is the end.
        let spare = (gaps - (y.high / row).ceil() + (y.low / row).floor()).max(0.0);
        let below = match (y.low == 0.0, y.high == 0.0) {
            (true, _) => 0.0,
            (_, true) => spare,
            _ => (spare / 2.0).floor(),
        };
        let bottom = (y.low / row).floor() - below;
        let (low, high) = (bottom * row, (bottom + gaps) * row);
        let first = (bottom / rows).ceil();
        let last = ((bottom + gaps) / rows).floor();
        AlignedAxis {
            low,
            high,
            step,
            first: first as i64,
            count: last as i64 - first as i64 + 1,
            longer: (high - low) / size - 1.0,
        }
    };
    let holds = move |axis: &AlignedAxis| {
        let slack = size * ROUNDED;
        axis.low <= y.low + slack && axis.high >= y.high - slack
    };
    let maximum = labels(height) as i64;
    let fits = move |axis: &AlignedAxis| (2..=maximum).contains(&axis.count) && holds(axis);
    let tried = candidates.take(if is_some { STEP_TRIALS } else { 0 });
    tried.map(axis).filter(fits)
}

/// Keeps the ticks inside the axis: all, or every second, every third and so on, until their rows
/// are evenly spaced.
fn thinned(scale: &CellScale, mut ticks: Ticks) -> Ticks {
    ticks.values.retain(|&value| scale.cell(value).is_some());
    let values = |every: usize| ticks.values.iter().copied().step_by(every).collect();
    let mut tried = (1..ticks.values.len()).map(|every| Ticks {
        values: values(every),
        style: ticks.style,
    });
    let found = tried.find(|ticks| are_spaced(&rows(scale, ticks)));
    found.unwrap_or(ticks)
}

/// Returns the rows of ticks, from the low end.
fn rows(scale: &CellScale, ticks: &Ticks) -> Vec<i32> {
    let rows = ticks.values.iter().filter_map(|&value| scale.cell(value));
    rows.collect()
}

/// Returns `true` if all rows are equally far apart.
fn are_spaced(rows: &[i32]) -> bool {
    rows.windows(3)
        .all(|three| three[0] - three[1] == three[1] - three[2])
}

/// Returns as many ticks as have space for their labels next to each other and for the unit, which
/// is between or after the last labels.
fn level_ticks(x: &CellScale, is_angle: bool, unit: &str, cells: Range<i32>) -> Ticks {
    let (low, high) = x.ends();
    let fits = |ticks: &Ticks| {
        let mut labels = level_labels(ticks, x, cells.end);
        let Some(last) = labels.pop() else {
            return false;
        };
        let (unit, _) = unit_place(&last, unit, cells.end);
        let taken = labels.iter().skip(1).map(|next| next.from).chain([unit]);
        let mut pairs = labels.iter().zip(taken);
        pairs.all(|(label, next)| label.end() + LABEL_GAP <= next)
    };
    let maximum = usize::try_from((cells.end - cells.start) / 4).unwrap_or(0);
    let tried = (2..=maximum.clamp(2, 25)).rev();
    let mut tried = tried.map(|maximum| Ticks::between(low, high, is_angle, maximum));
    let few = || Ticks::between(low, high, is_angle, 2);
    tried.find(fits).unwrap_or_else(few)
}

/// A label below the horizontal axis.
pub(super) struct LevelLabel {
    /// The column of its tick, and its first column.
    pub(super) tick: i32,
    pub(super) from: i32,
    pub(super) text: String,
}

impl LevelLabel {
    /// Returns the column after the last one.
    pub(super) fn end(&self) -> i32 {
        self.from + length(&self.text)
    }
}

/// Returns the labels of ticks, each centred below its tick, or moved left at the edge.
pub(super) fn level_labels(ticks: &Ticks, x: &CellScale, end: i32) -> Vec<LevelLabel> {
    let label = |(value, text): (f64, String)| {
        let tick = x.cell(value)?;
        let half = length(&text) / 2;
        let from = (tick - half).min(end - length(&text)).max(0);
        Some(LevelLabel { tick, from, text })
    };
    ticks.labels().filter_map(label).collect()
}

/// Returns the column up to which the labels before the last one may extend, and the first column
/// of the unit. The unit follows the last label, or precedes it if that is at the edge.
pub(super) fn unit_place(last: &LevelLabel, unit: &str, end: i32) -> (i32, i32) {
    let after = last.end() + 1;
    if after + length(unit) <= end {
        return (last.from, after);
    }
    let before = last.from - length(unit) - UNIT_GAP;
    (before, before)
}

/// Returns the maximum number of labels next to a vertical axis of `height` rows.
fn labels(height: i32) -> usize {
    let maximum = usize::try_from((height + 1) / LABEL_ROWS).unwrap_or(0);
    maximum.clamp(2, MAX_LABELS)
}

/// Returns the ranges along x and y, one of them enlarged so that lengths have the same scale along
/// both axes. The plot has `cells` cells, each `aspect` times as high as wide.
pub(super) fn true_ends(x: (f64, f64), y: (f64, f64), cells: Vec2, aspect: f64) -> [(f64, f64); 2] {
    let aspect = if aspect > 0.0 && aspect.is_finite() {
        aspect
    } else {
        2.0
    };
    // The length that one column's width shows.
    let scale = ((x.1 - x.0) / cells.x).max((y.1 - y.0) / (cells.y * aspect));
    [
        grown(x, scale * cells.x),
        grown(y, scale * cells.y * aspect),
    ]
}

/// Returns the range enlarged to `size` about its middle; a larger range is unchanged.
fn grown((low, high): (f64, f64), size: f64) -> (f64, f64) {
    let middle = low + (high - low) / 2.0;
    if size > high - low && size.is_finite() {
        (middle - size / 2.0, middle + size / 2.0)
    } else {
        (low, high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn axis(low: f64, high: f64) -> Axis {
        Axis {
            name: String::new(),
            unit: "N m".into(),
            is_angle: false,
            low,
            high,
        }
    }

    /// Regression: in the motor view 20, 10 and 0 were two rows apart, and 0 and -10 one row.
    #[test]
    fn vertical_ticks_of_motor_torque_are_evenly_spaced() {
        for height in 5..40 {
            let (scale, ticks) = upright_axis(&axis(-32.057, 28.719), 0, height);
            let found = rows(&scale, &ticks);
            assert!(found.len() > 1 && are_spaced(&found), "{height}: {found:?}");
        }
    }

    proptest! {
        #[test]
        fn vertical_ticks_are_evenly_spaced(low in -1e3..1e3, size in 1e-3..1e4, height in 4..60) {
            let y = axis(low, low + size);
            let (scale, ticks) = upright_axis(&y, 0, height);
            let found = rows(&scale, &ticks);
            prop_assert!(are_spaced(&found), "{found:?}");
            prop_assert_eq!(found.len(), ticks.values.len());
            // The axis covers all data and wastes little space.
            let (low, high) = scale.ends();
            prop_assert!(low <= y.low && high >= y.high && high - low <= 1.41 * size);
        }

        /// The unit follows the last label or is between the last two.
        #[test]
        fn unit_does_not_overlap_tick_labels(low in -500.0..500.0, size in 1.0..2e3, width in 40..160) {
            let scale = CellScale::along(low, low + size, 0, width, INSET);
            let ticks = level_ticks(&scale, true, "deg", 0..width);
            let mut labels = level_labels(&ticks, &scale, width);
            let count = labels.len();
            let mut last = labels.pop().unwrap();
            let (before, unit) = unit_place(&last, "deg", width);
            prop_assert!(unit >= last.end() && unit + 3 <= width || unit + 3 < last.from);
            // With room for at most two labels, the unit may replace the first.
            last.from = before;
            labels.push(last);
            let ends = labels.windows(2).map(|pair| pair[1].from - pair[0].end());
            prop_assert!(count <= 2 || ends.min() >= Some(LABEL_GAP));
        }
    }
}
