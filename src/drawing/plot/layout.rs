//! Where the parts of a plot are, in cells.

use super::path::CellBlock;
use super::ticks::{TickStyle, Ticks};
use super::{Axis, Plot, PlotStyle};
use crate::Vec2;

/// The axis and its labels, below the last panel.
const FOOT: i32 = 2;
/// The legend above each panel, and the least rows of a panel.
const LEGEND: i32 = 1;
const LEAST_BODY: i32 = 4;
/// Smaller than this nothing can be read from a plot.
const LEAST_ROWS: i32 = FOOT + LEGEND + 2;
const LEAST_COLS: i32 = 16;
/// From the edge of the first and the last cell to its middle.
const INSET: f64 = 0.5;
/// By how many percent an axis may be longer, so that its ticks are evenly spaced.
const MOST_LONGER: u8 = 20;
/// Rows from one label to the next, at the least, and the most labels of an axis.
const LABEL_ROWS: i32 = 2;
const MOST_LABELS: usize = 9;
/// Blanks between two labels of the level axis.
const LABEL_GAP: i32 = 2;
/// Blanks between the unit and the label behind it.
pub(super) const UNIT_GAP: i32 = 2;
/// There are not so many units.
const MOST_PANELS: i32 = 1000;
/// A panel higher than this has room for a legend of two rows.
const TALL: i32 = 7;

/// The parts of a plot.
pub(super) struct PlotLayout {
    /// The column of the upright axes, behind their labels.
    pub(super) axis: i32,
    /// The row of the level axis; its labels are below it.
    pub(super) foot: i32,
    /// Behind the last column.
    pub(super) end: i32,
    pub(super) x: CellScale,
    pub(super) x_ticks: Ticks,
    /// The panels that are shown, by their number.
    pub(super) panels: Vec<(usize, PanelArea)>,
}

/// Where a panel is.
pub(super) struct PanelArea {
    /// The row of its legend.
    pub(super) legend: i32,
    /// Rows that the legend may take.
    pub(super) legend_rows: i32,
    pub(super) block: CellBlock,
    pub(super) y: CellScale,
    pub(super) ticks: Ticks,
    /// How the figures of its curves are written.
    pub(super) style: TickStyle,
}

/// From values to cells: the ends lie on the middle of the first and the last cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CellScale {
    low: f64,
    high: f64,
    /// Where the low end lies, and from there to the high end, in cells.
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

    pub(super) fn upwards(low: f64, high: f64, top: i32, cells: i32, inset: f64) -> CellScale {
        let length = f64::from(cells) - 2.0 * inset;
        CellScale {
            low,
            high,
            start: f64::from(top) + inset + length,
            length: -length,
        }
    }

    /// From a place to another, whatever they count.
    pub(super) fn between(low: f64, high: f64, from: f64, to: f64) -> CellScale {
        CellScale {
            low,
            high,
            start: from,
            length: to - from,
        }
    }

    /// The values at its ends.
    pub(super) fn ends(&self) -> (f64, f64) {
        (self.low, self.high)
    }

    /// Where a value lies, in cell coordinates.
    pub(super) fn place(&self, value: f64) -> f64 {
        self.start + (value - self.low) / (self.high - self.low) * self.length
    }

    /// The value at a place in cell coordinates; nothing beyond the ends.
    fn value(&self, place: f64) -> Option<f64> {
        let value = self.low + (place - self.start) / self.length * (self.high - self.low);
        Some(value).filter(|value| self.holds(*value))
    }

    pub(super) fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }

    /// The cell of a value that it holds.
    pub(super) fn cell(&self, value: f64) -> Option<i32> {
        self.holds(value).then(|| self.place(value).floor() as i32)
    }

    /// Whether a value lies between the ends.
    pub(super) fn crosses(&self, value: f64) -> bool {
        self.low < value && value < self.high
    }
}

/// How many panels of so many have room in some rows.
fn shown(panels: usize, rows: i32) -> usize {
    let room = (rows - FOOT) / (LEGEND + LEAST_BODY);
    panels.min(usize::try_from(room).unwrap_or(0).max(1))
}

impl Plot {
    /// How many panels are shown in so many rows; the others are reached by another first one.
    #[must_use]
    pub fn panels_in(&self, rows: u16) -> usize {
        shown(self.panels.len(), i32::from(rows))
    }

    /// The rows in which all panels are shown.
    #[must_use]
    pub fn least_rows(&self) -> u16 {
        let panels = i32::try_from(self.panels.len())
            .unwrap_or(0)
            .min(MOST_PANELS);
        let rows = FOOT + panels * (LEGEND + LEAST_BODY);
        u16::try_from(rows).unwrap_or(u16::MAX)
    }

    /// Whether there is room for anything.
    #[must_use]
    pub fn fits(&self, look: &PlotStyle) -> bool {
        self.layout(look).is_some()
    }

    /// What stands along x in the middle of a column; nothing beside the curves.
    #[must_use]
    pub fn along(&self, look: &PlotStyle, column: u16) -> Option<f64> {
        self.layout(look)?.x.value(f64::from(column) + 0.5)
    }

    /// `None` where there is no room.
    pub(super) fn layout(&self, look: &PlotStyle) -> Option<PlotLayout> {
        let (cols, rows) = (i32::from(look.cols), i32::from(look.rows));
        if self.panels.is_empty() || rows < LEAST_ROWS || cols < LEAST_COLS {
            return None;
        }
        let count = shown(self.panels.len(), rows);
        let first = look.first.min(self.panels.len() - count);
        // Ticks and marks stand in the same cells whatever a curve is drawn with.
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
                    style: TickStyle::of_range(y.low, y.high),
                };
                (number, frame)
            })
            .collect();
        let widest = panels.iter().map(|(_, frame)| frame.ticks.widest()).max();
        let axis = i32::try_from(widest.unwrap_or(0)).unwrap_or(cols);
        let (left, width) = (axis + 1, cols - axis - 1);
        if width < LEAST_COLS / 2 {
            return None;
        }
        let (mut low, mut high) = (self.x.low, self.x.high);
        if let ([(number, frame)], true) = (&mut panels[..], self.is_true) {
            let y = &self.panels[*number].y;
            let height = frame.block.height;
            let cells = Vec2::new(f64::from(width), f64::from(height)) - inset * 2.0;
            let ends = true_ends((low, high), (y.low, y.high), cells, look.aspect);
            (low, high) = ends[0];
            frame.y = CellScale::upwards(ends[1].0, ends[1].1, frame.block.top, height, inset.y);
            let ticks = even_ticks(&frame.y, y.is_angle, height, 2);
            let ticks = ticks.unwrap_or_else(|| {
                Ticks::between(ends[1].0, ends[1].1, y.is_angle, labels(height))
            });
            // There is room for labels no longer than those that were foreseen.
            if i32::try_from(ticks.widest()).is_ok_and(|widest| widest <= axis) {
                frame.ticks = ticks;
            }
        }
        for (_, frame) in &mut panels {
            (frame.block.left, frame.block.width) = (left, width);
        }
        Some(PlotLayout {
            axis,
            foot: body,
            end: cols,
            x: CellScale::along(low, high, left, width, inset.x),
            x_ticks: level_ticks((low, high), self.x.is_angle, &self.x.unit, width),
            panels,
        })
    }
}

/// Scale and ticks of an upright axis: the rows of its ticks are evenly spaced, for which the axis may be longer than
/// what is drawn on it.
fn upright_axis(y: &Axis, top: i32, height: i32) -> (CellScale, Ticks) {
    let size = y.high - y.low;
    let ends = |percent: u8| {
        let more = size * f64::from(percent) / 100.0;
        match (y.low == 0.0, y.high == 0.0) {
            (true, _) => (y.low, y.high + more),
            (_, true) => (y.low - more, y.high),
            _ => grown((y.low, y.high), size + more),
        }
    };
    let scale = |percent| {
        let (low, high) = ends(percent);
        CellScale::upwards(low, high, top, height, INSET)
    };
    let usual = Ticks::between(y.low, y.high, y.is_angle, labels(height));
    let mut best: Option<(CellScale, Ticks)> = None;
    for percent in (0..=MOST_LONGER).step_by(2) {
        let scale = scale(percent);
        let count = best.as_ref().map_or(1, |(_, ticks)| ticks.values.len());
        if let Some(ticks) = even_ticks(&scale, y.is_angle, height, count + 1) {
            best = Some((scale, ticks));
        }
        let count = best.as_ref().map_or(0, |(_, ticks)| ticks.values.len());
        if count >= usual.values.len() {
            break;
        }
    }
    best.unwrap_or_else(|| (scale(0), thinned(&scale(0), usual)))
}

/// Every second tick, every third or fewer, until their rows are evenly spaced.
fn thinned(scale: &CellScale, ticks: Ticks) -> Ticks {
    let values = |every: usize| ticks.values.iter().copied().step_by(every).collect();
    let mut tried = (1..ticks.values.len()).map(|every| Ticks {
        values: values(every),
        style: ticks.style,
    });
    let found = tried.find(|ticks| are_spaced(&rows(scale, ticks)));
    found.unwrap_or(ticks)
}

/// The rows of ticks, from the low end.
fn rows(scale: &CellScale, ticks: &Ticks) -> Vec<i32> {
    let rows = ticks.values.iter().filter_map(|&value| scale.cell(value));
    rows.collect()
}

/// Returns `true` if all rows are equally far apart.
fn are_spaced(rows: &[i32]) -> bool {
    rows.windows(3)
        .all(|three| three[0] - three[1] == three[1] - three[2])
}

/// The most ticks of a scale whose rows are evenly spaced, if there are at least so many.
fn even_ticks(scale: &CellScale, is_angle: bool, height: i32, least: usize) -> Option<Ticks> {
    let (low, high) = scale.ends();
    let mut most = labels(height);
    while most >= least {
        let ticks = Ticks::between(low, high, is_angle, most);
        if ticks.values.len() < least {
            return None;
        }
        if is_even(scale, &ticks) {
            return Some(ticks);
        }
        most = ticks.values.len() - 1;
    }
    None
}

/// Returns `true` if the cells of all ticks are equally far apart, and no closer than labels may be.
fn is_even(scale: &CellScale, ticks: &Ticks) -> bool {
    let rows = rows(scale, ticks);
    let is_apart = matches!(rows[..], [first, second, ..] if first - second >= LABEL_ROWS);
    is_apart && are_spaced(&rows)
}

/// The most ticks whose labels have room beside each other, and the unit between or behind the last ones.
fn level_ticks((low, high): (f64, f64), is_angle: bool, unit: &str, width: i32) -> Ticks {
    let fits = |ticks: &Ticks| {
        let gaps = ticks.values.len().saturating_sub(1).max(1);
        let first = ticks.values.first().copied().unwrap_or(low);
        let last = ticks.values.last().copied().unwrap_or(high);
        let to_cells = |part: f64| f64::from(width) * part / (high - low);
        let apart = to_cells(last - first) / gaps as f64;
        let label = ticks.widest() as f64;
        let unit = unit.chars().count() as f64 + f64::from(UNIT_GAP);
        // At the edge the last label stands before its tick.
        let is_behind = to_cells(high - last) >= label / 2.0 + unit;
        let room = match is_behind || ticks.values.len() < 2 {
            true => 0.0,
            false => label / 2.0 + unit,
        };
        apart >= label + f64::from(LABEL_GAP) && apart >= label + room + 3.0
    };
    let most = usize::try_from(width / 4).unwrap_or(0).clamp(2, 25);
    let tried = (2..=most)
        .rev()
        .map(|most| Ticks::between(low, high, is_angle, most));
    let few = || Ticks::between(low, high, is_angle, 2);
    tried.into_iter().find(fits).unwrap_or_else(few)
}

/// The most labels beside an upright axis of so many rows.
fn labels(height: i32) -> usize {
    let most = usize::try_from((height + 1) / LABEL_ROWS).unwrap_or(0);
    most.clamp(2, MOST_LABELS)
}

/// The ranges along x and upwards, one of them larger than it need be, so that a length is as long
/// upwards as along x on so many cells, of which each is `aspect` times as high as wide.
pub(super) fn true_ends(x: (f64, f64), y: (f64, f64), cells: Vec2, aspect: f64) -> [(f64, f64); 2] {
    let aspect = if aspect > 0.0 && aspect.is_finite() {
        aspect
    } else {
        2.0
    };
    // The length of a column's width.
    let scale = ((x.1 - x.0) / cells.x).max((y.1 - y.0) / (cells.y * aspect));
    [
        grown(x, scale * cells.x),
        grown(y, scale * cells.y * aspect),
    ]
}

/// The range about the same middle, of another size.
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

    /// The motor view had 20, 10 and 0 two rows apart, and 0 and -10 one row.
    #[test]
    fn ticks_of_the_motor_view_are_evenly_spaced() {
        for height in 5..40 {
            let (scale, ticks) = upright_axis(&axis(-32.057, 28.719), 0, height);
            let found = rows(&scale, &ticks);
            assert!(found.len() > 1 && are_spaced(&found), "{height}: {found:?}");
        }
    }

    proptest! {
        #[test]
        fn ticks_are_evenly_spaced_in_rows(low in -1e3..1e3, size in 1e-3..1e4, height in 4..60) {
            let y = axis(low, low + size);
            let (scale, ticks) = upright_axis(&y, 0, height);
            let found = rows(&scale, &ticks);
            prop_assert!(are_spaced(&found), "{found:?}");
            prop_assert_eq!(found.len(), ticks.values.len());
            // Everything is drawn, and most of the room is used.
            let (low, high) = scale.ends();
            prop_assert!(low <= y.low && high >= y.high && high - low <= 1.21 * size);
        }

        /// The unit stands behind the last label or between the last two.
        #[test]
        fn the_unit_leaves_every_label_its_place(low in -500.0..500.0, size in 1.0..2e3, width in 40..160) {
            let ticks = level_ticks((low, low + size), true, "deg", width);
            let scale = CellScale::along(low, low + size, 0, width, INSET);
            let mut free = -1;
            let labels: Vec<(i32, i32)> = ticks.labels().filter_map(|(value, label)| {
                let length = i32::try_from(label.len()).ok()?;
                let from = (scale.cell(value)? - length / 2).min(width - length).max(0);
                Some((from, from + length))
            }).collect();
            for &(from, end) in &labels {
                prop_assert!(from > free, "{labels:?}");
                free = end;
            }
            if let [.., (_, before), (last, end)] = labels[..] {
                let is_behind = end + 1 + 3 <= width;
                prop_assert!(is_behind || last - UNIT_GAP - 3 > before, "{labels:?} of {width}");
            }
        }
    }
}
