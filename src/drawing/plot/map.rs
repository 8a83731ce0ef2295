//! Maps of a value over two variables: as shades of characters, and as contour lines.
//!
//! ```text
//! C.x.stroke [mm]
//! r3.length [mm]
//!   320 |....::::----
//!       |:::----====
//!   280 |---====++++
//!       +------------
//!        90       110  r2.length [mm]
//!
//!   . < 180   : 180 .. 190   - 190 .. 200   = > 200
//! ```

use super::ticks::{TickStyle, Ticks};
use super::{Axis, Panel, Plot, PlotCurve};
use crate::Vec2;
use crate::page::with_unit;
use crate::wording::words;
use std::collections::HashMap;

/// The shades from low to high; a missing value is blank.
const SHADES: [char; 9] = ['.', ':', '-', '=', '+', '*', '#', '%', '@'];
/// Columns of the text next to the map in addition to its labels: the axis, and space at the edge.
const COLUMNS_AROUND_MAP: usize = 4;
/// Rows of the text above and below the map: names, the axis and its labels, the legend.
const ROWS_AROUND_MAP: usize = 8;
/// Minimum columns and rows of a map.
const MIN_SIDE: usize = 4;

/// A value on a grid of two variables.
#[derive(Clone, Debug, PartialEq)]
pub struct GridMap {
    /// The value's name and unit.
    title: [String; 2],
    along: GridAxis,
    up: GridAxis,
    /// The values, row by row from below; `None` where the value does not exist.
    heights: Vec<Option<f64>>,
}

/// The places of a variable on a grid, ascending.
#[derive(Clone, Debug, PartialEq)]
struct GridAxis {
    axis: Axis,
    coordinates: Vec<f64>,
}

/// An edge of the grid that a line crosses: from the node of this column and row, to the right if
/// `true`, or else up.
type GridEdge = (usize, usize, bool);

impl GridMap {
    /// Creates a map from the values at `along` times `up` places, with `up` varying fastest. The
    /// places may be in any order; at least two must differ on each axis.
    #[must_use]
    pub fn new(
        title: [&str; 2],
        along: ([&str; 2], Vec<f64>),
        up: ([&str; 2], Vec<f64>),
        heights: &[Option<f64>],
    ) -> GridMap {
        let order = |coordinates: &[f64]| {
            let mut order: Vec<usize> = (0..coordinates.len()).collect();
            order.sort_by(|&a, &b| coordinates[a].total_cmp(&coordinates[b]));
            order
        };
        let (columns, rows) = (order(&along.1), order(&up.1));
        let height = |row: usize, column: usize| heights.get(column * up.1.len() + row).copied();
        let all = rows.iter().flat_map(|&row| {
            columns
                .iter()
                .map(move |&column| height(row, column).flatten())
        });
        let axis = |([name, unit], coordinates): &([&str; 2], Vec<f64>), order: &[usize]| {
            let coordinates: Vec<f64> = order.iter().map(|&k| coordinates[k]).collect();
            let low = coordinates.first().copied().unwrap_or(0.0);
            let high = coordinates.last().copied().unwrap_or(low);
            let axis = Axis::new(name, unit, (low, high));
            GridAxis { axis, coordinates }
        };
        GridMap {
            title: title.map(str::to_owned),
            heights: all.collect(),
            along: axis(&along, &columns),
            up: axis(&up, &rows),
        }
    }

    fn height(&self, column: usize, row: usize) -> Option<f64> {
        self.heights
            .get(row * self.along.coordinates.len() + column)
            .copied()
            .flatten()
    }

    /// Returns round levels between the minimum and the maximum.
    fn levels(&self) -> Ticks {
        let all = || self.heights.iter().copied().flatten();
        let (low, high) = (
            all().fold(f64::INFINITY, f64::min),
            all().fold(f64::NEG_INFINITY, f64::max),
        );
        Ticks::between(low, high, self.title[1] == "deg", SHADES.len() - 1)
    }

    /// Returns the map in characters, at most `cols` wide and, except for its legend, at most
    /// `rows` high.
    #[must_use]
    pub fn text(&self, cols: u16, rows: u16) -> String {
        let levels = self.levels();
        let ends = self.up.axis.end_labels(self.up.axis.style());
        let labels = ends.iter().map(String::len).max().unwrap_or(0) + 2;
        let width = usize::from(cols)
            .saturating_sub(labels + COLUMNS_AROUND_MAP)
            .max(MIN_SIDE);
        let height = usize::from(rows)
            .saturating_sub(ROWS_AROUND_MAP)
            .max(MIN_SIDE);
        let mut text = format!("{}\n{}\n", self.titled(), self.up.axis.title());
        for line in 0..height {
            let row = self.up.nearest(height - 1 - line, height);
            let label = match line {
                0 => &ends[1],
                _ if line == height - 1 => &ends[0],
                _ => "",
            };
            let cells: String = (0..width)
                .map(|column| self.shade(self.along.nearest(column, width), row, &levels))
                .collect();
            text += format!("{label:>labels$} |{cells}").trim_end();
            text.push('\n');
        }
        text += &format!("{:labels$} +{}\n", "", "-".repeat(width));
        text += &self.foot(labels, width);
        text + &self.legend(&levels, usize::from(cols))
    }

    /// Returns the ends of the horizontal axis, with its name between them if there is space.
    fn foot(&self, labels: usize, width: usize) -> String {
        let [low, high] = self.along.axis.end_labels(self.along.axis.style());
        let title = self.along.axis.title();
        let between = width.saturating_sub(low.len() + high.len());
        match title.chars().count() + 2 <= between {
            true => format!("{:labels$}  {low}{title:^between$}{high}\n", ""),
            false => format!(
                "{:labels$}  {low}{:between$}{high}\n{:labels$}  {title}\n",
                "", "", ""
            ),
        }
    }

    fn shade(&self, column: usize, row: usize, levels: &Ticks) -> char {
        match self.height(column, row) {
            None => ' ',
            Some(height) => SHADES[band(height, levels)],
        }
    }

    /// Returns the legend of the shades that occur.
    fn legend(&self, levels: &Ticks, cols: usize) -> String {
        let bounds: Vec<String> = levels.labels().map(|(_, label)| label).collect();
        let seen = |k: usize| self.heights.iter().flatten().any(|&h| band(h, levels) == k);
        let entry = |k: usize| match (k.checked_sub(1).and_then(|k| bounds.get(k)), bounds.get(k)) {
            (Some(low), Some(high)) => format!("{} {low} .. {high}", SHADES[k]),
            (None, Some(high)) => format!("{} < {high}", SHADES[k]),
            (Some(low), None) => format!("{} > {low}", SHADES[k]),
            (None, None) => {
                let known = self.heights.iter().flatten().next().copied().unwrap_or(0.0);
                format!(
                    "{} {}",
                    SHADES[k],
                    TickStyle::of_range(known, known).text(known)
                )
            }
        };
        let mut entries: Vec<String> = (0..=bounds.len()).filter(|&k| seen(k)).map(entry).collect();
        if self.heights.contains(&None) {
            entries.push(words().blank_is_no_design().to_owned());
        }
        let mut text = String::new();
        let mut line = String::new();
        for entry in entries {
            if !line.is_empty() && line.chars().count() + entry.chars().count() + 5 > cols {
                text += &format!("\n{line}");
                line.clear();
            }
            line += &format!("{}{entry}", if line.is_empty() { "  " } else { "   " });
        }
        text + "\n" + &line + "\n"
    }

    /// Returns the contour lines of maps over the same variables, one panel per map; `None` without
    /// maps.
    #[must_use]
    pub fn contours(maps: &[GridMap]) -> Option<Plot> {
        let first = maps.first()?;
        let axis = |of: &GridAxis, name: String| Axis {
            name,
            ..of.axis.clone()
        };
        let panel = |map: &GridMap| Panel {
            y: axis(&map.up, String::new()),
            curves: map.curves(),
        };
        let x = words().axes_of_map(&first.up.axis.title(), &first.along.axis.name);
        Some(Plot {
            x: axis(&first.along, x),
            panels: maps.iter().map(panel).collect(),
            is_true: false,
        })
    }

    fn curves(&self) -> Vec<PlotCurve> {
        let levels = self.levels();
        let curve = |(k, (level, label)): (usize, (f64, String))| PlotCurve {
            name: match k {
                0 => format!("{}: {label}", self.titled()),
                _ => label,
            },
            pieces: self.line_at(level),
            ..PlotCurve::default()
        };
        levels.labels().enumerate().map(curve).collect()
    }

    /// Returns the contour line of a level as connected pieces (marching squares). At a saddle, the
    /// mean of the four corners decides which corners are connected.
    fn line_at(&self, level: f64) -> Vec<Vec<Vec2>> {
        let mut paths: HashMap<GridEdge, Vec<GridEdge>> = HashMap::new();
        let mut order = Vec::new();
        for row in 1..self.up.coordinates.len() {
            for column in 1..self.along.coordinates.len() {
                for [a, b] in self.segments(column - 1, row - 1, level) {
                    order.extend([a, b]);
                    paths.entry(a).or_default().push(b);
                    paths.entry(b).or_default().push(a);
                }
            }
        }
        // Lines that end at an edge of the grid come first; the others are closed.
        let is_end = |edge: &GridEdge, paths: &HashMap<GridEdge, Vec<GridEdge>>| {
            paths.get(edge).is_some_and(|to| to.len() == 1)
        };
        let ends: Vec<GridEdge> = order
            .iter()
            .copied()
            .filter(|e| is_end(e, &paths))
            .collect();
        let starts = ends.into_iter().chain(order);
        let pieces = starts.map(|start| walk(start, &mut paths));
        let pieces = pieces.filter(|piece| piece.len() > 1);
        pieces
            .map(|piece| {
                piece
                    .into_iter()
                    .filter_map(|edge| self.crossing(edge, level))
                    .collect()
            })
            .collect()
    }

    /// Returns the pieces of the line within one square; empty if a corner has no value.
    fn segments(&self, column: usize, row: usize, level: f64) -> Vec<[GridEdge; 2]> {
        let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
        let heights = corners.map(|(right, up)| self.height(column + right, row + up));
        let [Some(a), Some(b), Some(c), Some(d)] = heights else {
            return Vec::new();
        };
        let above = [a, b, c, d].map(|height| height >= level);
        let edges = [
            (column, row, true),
            (column + 1, row, false),
            (column, row + 1, true),
            (column, row, false),
        ];
        let crossed: Vec<usize> = (0..4).filter(|&k| above[k] != above[(k + 1) % 4]).collect();
        match crossed[..] {
            [one, two] => vec![[edges[one], edges[two]]],
            // A saddle: the corners on the same side of the level as the mean are connected.
            [_, _, _, _] => {
                let middle = (a + b + c + d) / 4.0 >= level;
                match middle == above[0] {
                    true => vec![[edges[0], edges[1]], [edges[2], edges[3]]],
                    false => vec![[edges[3], edges[0]], [edges[1], edges[2]]],
                }
            }
            _ => Vec::new(),
        }
    }

    /// Returns the point where the line crosses an edge, interpolated linearly.
    fn crossing(&self, (column, row, along): GridEdge, level: f64) -> Option<Vec2> {
        let (right, above) = if along {
            (column + 1, row)
        } else {
            (column, row + 1)
        };
        let (from, to) = (self.height(column, row)?, self.height(right, above)?);
        let part = (level - from) / (to - from);
        let node = |column: usize, row: usize| {
            Vec2::new(self.along.coordinates[column], self.up.coordinates[row])
        };
        let (a, b) = (node(column, row), node(right, above));
        Some(a + (b - a) * part)
    }
}

impl GridMap {
    fn titled(&self) -> String {
        let [name, unit] = &self.title;
        with_unit(name, unit)
    }
}

impl GridAxis {
    /// Returns the index of the place nearest to the middle of a cell, with `cells` cells between
    /// the ends.
    fn nearest(&self, cell: usize, cells: usize) -> usize {
        let Axis { low, high, .. } = self.axis;
        let at = low + (high - low) * (cell as f64 / (cells - 1).max(1) as f64);
        let off = |k: &usize| (self.coordinates[*k] - at).abs();
        let nearest = (0..self.coordinates.len()).min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.unwrap_or(0)
    }
}

/// Returns the index of the band between levels that contains a height.
fn band(height: f64, levels: &Ticks) -> usize {
    let below = levels.values.iter().filter(|&&level| level <= height);
    below.count().min(SHADES.len() - 1)
}

/// Follows a line from one of its edges to its end, and removes the visited parts.
fn walk(start: GridEdge, paths: &mut HashMap<GridEdge, Vec<GridEdge>>) -> Vec<GridEdge> {
    let mut line = vec![start];
    let mut here = start;
    while let Some(next) = paths.get_mut(&here).and_then(Vec::pop) {
        if let Some(back) = paths.get_mut(&next)
            && let Some(path) = back.iter().position(|edge| *edge == here)
        {
            back.remove(path);
        }
        line.push(next);
        here = next;
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the map of x + y for x in 0, 1, 2 and y in 0, 1.
    fn plane() -> GridMap {
        let heights = [0.0, 1.0, 1.0, 2.0, 2.0, 3.0].map(Some);
        let (along, up) = (vec![0.0, 1.0, 2.0], vec![0.0, 1.0]);
        GridMap::new(["h", "mm"], (["a", "mm"], along), (["b", ""], up), &heights)
    }

    #[test]
    fn shades_increase_with_height() {
        let text = plane().text(24, 12);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "h [mm]");
        assert_eq!(lines[1], "b");
        let shades = |line: &str| -> Vec<usize> {
            let cells = line.split_once('|').unwrap().1.chars();
            cells
                .map(|c| SHADES.iter().position(|s| *s == c).unwrap())
                .collect()
        };
        let (top, bottom) = (shades(lines[2]), shades(lines[5]));
        assert!(top.is_sorted() && bottom.is_sorted());
        assert!(top.iter().zip(&bottom).all(|(t, b)| t > b), "{text}");
        assert!(text.is_ascii());
    }

    /// A contour line of a plane is straight, and goes from edge to edge in one piece.
    #[test]
    fn contour_of_plane_is_straight() {
        let pieces = plane().line_at(1.5);
        assert_eq!(pieces.len(), 1, "{pieces:?}");
        assert_eq!(pieces[0].len(), 3);
        for position in &pieces[0] {
            assert!(
                (position.x + position.y - 1.5).abs() < 1e-12,
                "{position:?}"
            );
        }
        assert!(plane().line_at(9.0).is_empty());
    }

    /// A contour line around a hill is closed, and absent at a missing value.
    #[test]
    fn contour_around_hill_is_closed() {
        let side: Vec<f64> = (-5..=5).map(f64::from).collect();
        let mut heights = Vec::new();
        for x in &side {
            heights.extend(side.iter().map(|y| Some(100.0 - x * x - y * y)));
        }
        let axis = |name| ([name, "mm"], side.clone());
        let map = GridMap::new(["h", ""], axis("x"), axis("y"), &heights);
        let pieces = map.line_at(91.0);
        assert_eq!(pieces.len(), 1, "{pieces:?}");
        assert_eq!(pieces[0].first(), pieces[0].last());
        heights[60] = None;
        let map = GridMap::new(["h", ""], axis("x"), axis("y"), &heights);
        assert!(map.line_at(99.5).is_empty());
        assert!(map.text(40, 20).contains(words().blank_is_no_design()));
    }
}
