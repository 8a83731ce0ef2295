//! Plots: curves against a shared horizontal axis, with one panel per unit.
//!
//! ```text
//! mm/s     * C.vx -722.6   x C.vy  -273.8          over driver.angle  60.00 deg
//!  1000 |          :   **^***  1083 at 149.26
//!     0 |......****:..x.......xxx.....
//! -1000 |*xx***    :                  *****
//! rad/s    * r4.omega  3.094
//!     2 |   ...
//!       +---+---+---+---+---+---+---+---+
//!       0   45  90  135 180 225 270 315 360 deg
//! ```
//!
//! A [`Plot`] is made from [`Curves`] once; [`Plot::render`] then draws it at any size, with the
//! cursor at the driver's coordinate. Curves connect only samples that have a value: places without
//! a value and jumps are gaps. This module does not depend on a terminal.

mod band;
mod chart;
pub(super) mod convergence;
pub(super) mod effort_plot;
mod frame;
mod layout;
mod map;
mod paint;
mod path;
mod svg_plot;
#[cfg(test)]
mod tests;
mod ticks;
pub(super) mod trade_off;

pub use band::PlotBand;
pub use chart::{Chart, Datum, DecadeAxis};
pub use map::GridMap;
pub use paint::PlotCanvas;

use crate::Mechanism;
use crate::Vec2;
use crate::drawing::Glyphs;
use crate::drawing::figure::Role;
use crate::drawing::roles::{link_of, link_roles};
use crate::page::with_unit;
use crate::quantity::{Abscissa, Aspect, Curves, Quantity, QuantitySource, Subject};
use ticks::TickStyle;

/// Curves against an axis, in panels.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// The horizontal axis.
    pub x: Axis,
    /// The panels from the top, one per unit.
    pub panels: Vec<Panel>,
    /// `true` if lengths have the same scale along both axes, as for a coupler curve; applies to a
    /// single panel.
    pub is_true: bool,
}

/// An axis: its name, unit and range.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The name, such as `driver.angle`; empty for a vertical axis, because its curves have names.
    pub name: String,
    /// The unit.
    pub unit: String,
    /// `true` for degrees, which have round steps of their own.
    pub is_angle: bool,
    /// The low end.
    pub low: f64,
    /// The high end; never below the low end.
    pub high: f64,
}

/// Curves of one unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// The vertical axis.
    pub y: Axis,
    /// The curves.
    pub curves: Vec<PlotCurve>,
}

/// A curve.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlotCurve {
    /// The name in the legend.
    pub name: String,
    /// The index of the quantity in [`Curves`]; `None` if the cursor has no value of it, as for a
    /// curve of another scene.
    pub figure: Option<usize>,
    /// The connected parts, in the units of the axes; all finite.
    pub pieces: Vec<Vec<Vec2>>,
    /// The local extrema.
    pub turns: Vec<CurveTurn>,
    /// `true` to draw points only, as for the curve of another scene.
    pub is_dotted: bool,
    /// The role of a link, or of a band's curve; `None` for the default role at this place in the
    /// panel.
    pub link: Option<Role>,
    /// The offsets of the band, if the curve is the two edges of one.
    pub band: Option<PlotBand>,
}

impl PlotCurve {
    /// Returns `true` if the curve consists of single points, such as measurements.
    fn is_places(&self) -> bool {
        self.is_dotted && !self.pieces.is_empty() && self.pieces.iter().all(|p| is_place(p))
    }
}

/// Returns `true` if a piece is a single point, stored twice.
fn is_place(piece: &[Vec2]) -> bool {
    matches!(piece, [from, to] if from == to)
}

/// A local extremum of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveTurn {
    /// The place, in the units of the axes.
    pub at: Vec2,
    /// `true` for a maximum, `false` for a minimum.
    pub is_peak: bool,
    /// `true` for the largest maximum or the smallest minimum.
    pub is_extreme: bool,
}

/// The style of a plot in cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlotStyle {
    /// The number of columns.
    pub cols: u16,
    /// The number of rows.
    pub rows: u16,
    /// The set of glyphs.
    pub glyphs: Glyphs,
    /// The height of a cell divided by its width.
    pub aspect: f64,
    /// `true` to mark the extrema of curves.
    pub extrema: bool,
    /// The first visible panel, if not all fit.
    pub first: usize,
}

/// The margin around a constant value, relative to the value; for zero the margin is 1.
const ROOM: f64 = 0.5;
/// Maximum relative growth of an axis for a band, which grows without bound near a dead point.
const MAX_BAND_GROWTH: f64 = 0.25;

impl Plot {
    /// Creates the plot of sampled curves, with one panel per unit, in the order of first
    /// occurrence.
    #[must_use]
    pub fn of(curves: &Curves) -> Plot {
        let [name, unit] = &curves.title;
        let drawn = curves.curves.iter().enumerate();
        let drawn = drawn.map(|(index, curve)| {
            let unit = curve.quantity.unit.as_str();
            (unit, line(curves, index), curve.range())
        });
        Plot {
            x: Axis::new(name, unit, spread(curves.span())),
            panels: Panel::by_unit(drawn),
            is_true: is_true(curves),
        }
    }

    /// Creates the plot of values over a variable. Each entry of `figures` has a name, a unit and
    /// the value at every place.
    #[must_use]
    pub fn over(
        [name, unit]: [&str; 2],
        coordinates: &[f64],
        figures: &[([&str; 2], Vec<Option<f64>>)],
    ) -> Plot {
        let range = |values: &mut dyn Iterator<Item = f64>| {
            let values = values.map(|v| Some((v, v)));
            values.fold(None, union)
        };
        let drawn = figures.iter().enumerate();
        let drawn = drawn.map(|(number, ([name, unit], values))| {
            let curve = PlotCurve {
                name: (*name).to_owned(),
                figure: Some(number),
                pieces: pieces(coordinates, values),
                ..PlotCurve::default()
            };
            let points = curve.pieces.iter().flatten();
            let range = range(&mut points.map(|p| p.y));
            (*unit, curve, range)
        });
        let x = spread(range(&mut coordinates.iter().copied()));
        Plot {
            x: Axis::new(name, unit, x),
            panels: Panel::by_unit(drawn),
            is_true: false,
        }
    }

    /// Adds the curves of another scene, dotted, to the panels of their units, and enlarges the
    /// axes as needed. A curve has the hue of the one with the same name. Curves without a panel of their unit are left out, as there is nothing to
    /// compare them with.
    pub fn compare(&mut self, other: &Plot, name: &str) {
        self.x.include([other.x.low, other.x.high]);
        for panel in &mut self.panels {
            let unit = panel.y.unit.clone();
            let same = other.panels.iter().filter(|o| o.y.unit == unit);
            for from in same {
                panel.y.include([from.y.low, from.y.high]);
                let added = from.curves.iter().map(|line| {
                    let own = panel.curves.iter().position(|own| own.name == line.name);
                    PlotCurve {
                        name: format!("{} {name}", line.name),
                        is_dotted: true,
                        pieces: line.pieces.clone(),
                        link: own.map(|own| panel.role(own)),
                        ..PlotCurve::default()
                    }
                });
                let added: Vec<PlotCurve> = added.collect();
                panel.curves.extend(added);
            }
        }
    }

    /// Adds single points, such as measurements, to the panel of their unit, and enlarges the axes
    /// as needed.
    pub fn mark(&mut self, unit: &str, name: &str, places: &[(f64, f64)]) {
        let Some(panel) = self.panels.iter_mut().find(|panel| panel.y.unit == unit) else {
            return;
        };
        let places = places.iter().map(|&(x, y)| Vec2::new(x, y));
        let places: Vec<Vec2> = places.filter(|position| position.is_finite()).collect();
        for position in &places {
            self.x.include([position.x]);
            panel.y.include([position.y]);
        }
        panel.curves.push(PlotCurve {
            name: name.to_owned(),
            is_dotted: true,
            // A line from a point to itself is a single point.
            pieces: places
                .into_iter()
                .map(|position| vec![position, position])
                .collect(),
            ..PlotCurve::default()
        });
    }

    /// Adds the error band of a value's curve: both edges, dotted. `offsets` are the offsets below
    /// and above at each sample. The axis grows as needed, up to a limit.
    pub fn add_band(
        &mut self,
        curves: &Curves,
        index: usize,
        offsets: &[Option<[f64; 2]>],
        name: String,
    ) {
        let is_of = |line: &PlotCurve| line.figure == Some(index);
        let mut panels = self.panels.iter_mut();
        let Some((panel, at)) = panels.find_map(|panel| {
            let at = panel.curves.iter().position(is_of)?;
            Some((panel, at))
        }) else {
            return;
        };
        let edge = |side: usize| {
            curves.shifted_pieces(index, |i| {
                offsets.get(i).copied().flatten().map(|o| o[side])
            })
        };
        let places = |piece: Vec<[f64; 2]>| piece.into_iter().map(|[x, y]| Vec2::new(x, y));
        let pieces = edge(0).into_iter().chain(edge(1));
        let pieces = pieces.map(|piece| places(piece).filter(|p| p.is_finite()).collect());
        let (low, high) = (panel.y.low, panel.y.high);
        let maximum = MAX_BAND_GROWTH * (high - low);
        let values = curves.curves[index].values.iter().zip(offsets);
        for (value, offset) in values {
            // Only where the curve itself is visible.
            let shown = value.filter(|value| (low..=high).contains(value));
            if let (Some(value), Some([below, above])) = (shown, offset) {
                let ends = [
                    (value + below).max(low - maximum),
                    (value + above).min(high + maximum),
                ];
                panel.y.include(ends);
            }
        }
        let role = panel.role(at);
        panel.curves.push(PlotCurve {
            name,
            pieces: pieces.collect(),
            is_dotted: true,
            link: Some(role),
            band: Some(PlotBand::new(&curves.along, offsets)),
            ..PlotCurve::default()
        });
    }

    /// Converts lengths and their rates to another unit; `scale` is the size of one `unit` in
    /// `other` units.
    #[must_use]
    pub fn in_unit(mut self, unit: &str, other: &str, scale: f64) -> Plot {
        let along = self.x.convert(unit, other, scale);
        for panel in &mut self.panels {
            let up = panel.y.convert(unit, other, scale);
            let convert = |at: &mut Vec2| *at = Vec2::new(at.x * along, at.y * up);
            for line in &mut panel.curves {
                line.pieces.iter_mut().flatten().for_each(convert);
                line.turns
                    .iter_mut()
                    .map(|turn| &mut turn.at)
                    .for_each(convert);
            }
        }
        self
    }

    /// Gives the curves of each panel the hues of their links, if every curve belongs to a link and
    /// no link occurs twice.
    #[must_use]
    pub fn in_hues_of(mut self, mechanism: &Mechanism, curves: &Curves) -> Plot {
        let links = link_roles(mechanism);
        let role = |line: &PlotCurve| {
            let curve = curves.curves.get(line.figure?)?;
            let link = link_of(mechanism, curve.quantity.subject()?)?;
            Some(links[link.index()])
        };
        for panel in &mut self.panels {
            let roles: Option<Vec<Role>> = panel.curves.iter().map(role).collect();
            let Some(roles) = roles else { continue };
            let is_alone = |(k, role): (usize, &Role)| !roles[..k].contains(role);
            if roles.iter().enumerate().all(is_alone) {
                for (line, &role) in panel.curves.iter_mut().zip(&roles) {
                    line.link = Some(role);
                }
            }
        }
        self
    }

    /// Returns the role of the curve with this name; `None` if no curve has it.
    #[must_use]
    pub fn role_of(&self, name: &str) -> Option<Role> {
        let found = |panel: &Panel| {
            let at = panel.curves.iter().position(|line| line.name == name)?;
            Some(panel.role(at))
        };
        self.panels.iter().find_map(found)
    }

    /// Returns `true` if any curve has a value.
    #[must_use]
    pub fn has_values(&self) -> bool {
        let mut lines = self.panels.iter().flat_map(|panel| &panel.curves);
        lines.any(|line| !line.pieces.is_empty())
    }
}

/// The roles of curves without a link's hue, in their order in a panel.
const ROLES: [Role; 3] = [Role::Datum, Role::Second, Role::Third];

impl Panel {
    /// Returns the role of a curve.
    fn role(&self, curve: usize) -> Role {
        let link = self.curves.get(curve).and_then(|line| line.link);
        link.unwrap_or(ROLES[curve % ROLES.len()])
    }

    /// Returns one panel per unit, in the order of first occurrence, of curves with their units and
    /// ranges.
    fn by_unit<'u>(
        drawn: impl Iterator<Item = (&'u str, PlotCurve, Option<(f64, f64)>)>,
    ) -> Vec<Panel> {
        let mut panels: Vec<(Panel, Option<(f64, f64)>)> = Vec::new();
        for (unit, curve, range) in drawn {
            let known = panels.iter_mut().find(|(panel, _)| panel.y.unit == unit);
            if let Some((panel, all)) = known {
                panel.curves.push(curve);
                *all = union(*all, range);
            } else {
                let (y, curves) = (Axis::new("", unit, (0.0, 1.0)), vec![curve]);
                panels.push((Panel { y, curves }, range));
            }
        }
        let panels = panels.into_iter().map(|(mut panel, range)| {
            (panel.y.low, panel.y.high) = spread(range);
            panel
        });
        panels.collect()
    }
}

impl Axis {
    pub(super) fn new(name: &str, unit: &str, (low, high): (f64, f64)) -> Axis {
        Axis {
            name: name.to_owned(),
            unit: unit.to_owned(),
            is_angle: unit == "deg",
            low,
            high,
        }
    }

    /// Enlarges the range to include values.
    fn include<const N: usize>(&mut self, values: [f64; N]) {
        for value in values {
            (self.low, self.high) = (self.low.min(value), self.high.max(value));
        }
    }

    /// Returns the number format of its values.
    fn style(&self) -> TickStyle {
        TickStyle::of_range(self.low, self.high)
    }

    /// Returns the name with its unit.
    fn title(&self) -> String {
        with_unit(&self.name, &self.unit)
    }

    /// Returns both ends as text.
    fn end_labels(&self, style: TickStyle) -> [String; 2] {
        [self.low, self.high].map(|end| style.text(end))
    }

    /// Formats a value, or a dash if there is none, aligned to the width of the ends.
    fn text(&self, value: Option<f64>, style: TickStyle) -> String {
        let [low, high] = self.end_labels(style).map(|label| label.len());
        let text = value.map_or_else(|| "-".into(), |value| style.text(value));
        let width = low.max(high);
        format!("{text:>width$}")
    }

    /// Converts the axis of a length, or of its rate, to another unit. Returns the factor for its
    /// values, 1 for other quantities.
    fn convert(&mut self, unit: &str, other: &str, scale: f64) -> f64 {
        match self.unit.strip_prefix(unit) {
            Some(per) if per.is_empty() || per.starts_with('/') => {
                self.unit = format!("{other}{per}");
                self.low *= scale;
                self.high *= scale;
                scale
            }
            _ => 1.0,
        }
    }
}

fn line(curves: &Curves, index: usize) -> PlotCurve {
    let curve = &curves.curves[index];
    let place = |[x, y]: [f64; 2]| Vec2::new(x, y);
    let pieces = curves.pieces(index).into_iter();
    let finite = |piece: Vec<[f64; 2]>| -> Vec<Vec2> {
        let places = piece.into_iter().map(place);
        places.filter(|p| p.is_finite()).collect()
    };
    let turns = curve.extrema.iter().map(|extremum| CurveTurn {
        at: Vec2::new(extremum.along, extremum.value),
        is_peak: extremum.is_peak,
        is_extreme: extremum.is_extreme,
    });
    PlotCurve {
        name: curve.quantity.name.clone(),
        figure: Some(index),
        pieces: pieces
            .map(finite)
            .filter(|piece| !piece.is_empty())
            .collect(),
        turns: turns.filter(|turn| turn.at.is_finite()).collect(),
        ..PlotCurve::default()
    }
}

/// Returns the connected parts of a curve between places without a value.
fn pieces(coordinates: &[f64], values: &[Option<f64>]) -> Vec<Vec<Vec2>> {
    let mut pieces = vec![Vec::new()];
    for (&x, value) in coordinates.iter().zip(values) {
        match (value, pieces.last_mut()) {
            (Some(y), Some(piece)) => piece.push(Vec2::new(x, *y)),
            _ => pieces.push(Vec::new()),
        }
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

/// Returns `true` if both axes are coordinates of points.
fn is_true(curves: &Curves) -> bool {
    let is_place = |quantity: &Quantity| {
        matches!(
            quantity.source,
            QuantitySource::Solved(Subject::Point(_), Aspect::X | Aspect::Y)
        )
    };
    match &curves.abscissa {
        Abscissa::Figure(along) => {
            is_place(along) && curves.curves.iter().all(|curve| is_place(&curve.quantity))
        }
        Abscissa::Driver | Abscissa::Time => false,
    }
}

fn union(a: Option<(f64, f64)>, b: Option<(f64, f64)>) -> Option<(f64, f64)> {
    match (a, b) {
        (Some(a), Some(b)) => Some((a.0.min(b.0), a.1.max(b.1))),
        (a, b) => a.or(b),
    }
}

/// Returns a non-empty range for an axis, even if the values do not differ.
fn spread(range: Option<(f64, f64)>) -> (f64, f64) {
    let Some((low, high)) = range.filter(|(low, high)| low.is_finite() && high.is_finite()) else {
        return (0.0, 1.0);
    };
    let size = low.abs().max(high.abs());
    if high - low > size * 1e-12 && (high - low).is_finite() {
        return (low, high);
    }
    let space = if size > 0.0 { size * ROOM } else { 1.0 };
    (low - space, high + space)
}
