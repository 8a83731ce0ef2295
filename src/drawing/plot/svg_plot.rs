//! Draws a plot as an SVG document. Curves differ in dashes, not in colour alone.

use super::layout::CellScale;
use super::ticks::{TickStyle, Ticks};
use super::{Panel, Plot, PlotCurve};
use crate::Vec2;
use crate::page::{Artwork, StyleSheet, SvgGround, TextAnchor};
use crate::quantity::StateValues;
use crate::wording::words;

/// The margins around the panels; the left one holds the labels of the vertical axes.
const LEFT: f64 = 72.0;
const RIGHT: f64 = 24.0;
const TOP: f64 = 12.0;
const FOOT: f64 = 48.0;
/// Heights of the legend above each panel and of the blank below it.
const LEGEND: f64 = 26.0;
const BELOW: f64 = 10.0;
/// Minimum distance between labels of an axis.
const LABEL_APART: Vec2 = Vec2 { x: 48.0, y: 28.0 };
const TICK: f64 = 5.0;
/// Length of a line in the legend, and average width of a character.
const SAMPLE: f64 = 26.0;
const CHARACTER: f64 = 7.5;
/// The radius of a mark.
const MARK: f64 = 3.0;
/// Distance from a text's middle down to its baseline.
const HALF_TEXT: f64 = 4.5;
/// The number of dash patterns; they repeat after as many curves.
const DASHES: usize = 5;

const SHEET: StyleSheet = StyleSheet {
    light: include_str!("light.css"),
    dark: include_str!("dark.css"),
};

impl Plot {
    /// Returns the plot as an SVG document. `size` is in user units; the cursor shows the state
    /// `here`.
    #[must_use]
    pub fn svg(
        &self,
        title: &str,
        size: Vec2,
        extrema: bool,
        here: Option<&StateValues>,
    ) -> String {
        let art = self.artwork(title, size, extrema, here);
        art.svg(SvgGround::Preferred)
    }

    /// Returns the plot as a picture for a page.
    #[must_use]
    pub fn artwork(
        &self,
        title: &str,
        size: Vec2,
        extrema: bool,
        here: Option<&StateValues>,
    ) -> Artwork {
        let mut sheet = PaperSheet {
            plot: self,
            art: Artwork::new(size, title, SHEET),
            extrema,
            here,
            x: CellScale::between(self.x.low, self.x.high, LEFT, size.x - RIGHT),
        };
        let foot = size.y - FOOT;
        let count = self.panels.len().max(1) as f64;
        let height = (foot - TOP) / count;
        for (k, panel) in self.panels.iter().enumerate() {
            let top = TOP + height * k as f64;
            sheet.panel(panel, top, top + height);
        }
        sheet.foot(foot);
        sheet.art
    }
}

struct PaperSheet<'a> {
    plot: &'a Plot,
    art: Artwork,
    extrema: bool,
    here: Option<&'a StateValues>,
    x: CellScale,
}

impl PaperSheet<'_> {
    fn right(&self) -> f64 {
        self.art.size().x - RIGHT
    }

    fn panel(&mut self, panel: &Panel, top: f64, bottom: f64) {
        let (top, bottom) = (top + LEGEND, bottom - BELOW);
        let axis = &panel.y;
        let mut y = CellScale::between(axis.low, axis.high, bottom, top);
        if self.plot.is_true && self.plot.panels.len() == 1 {
            y = self.true_scales(panel, top, bottom);
        }
        let digits = axis.style();
        let maximum = ((bottom - top) / LABEL_APART.y).clamp(2.0, 12.0) as usize;
        let (low, high) = y.ends();
        let ticks = Ticks::between(low, high, axis.is_angle, maximum);
        for (value, label) in ticks.labels() {
            let at = y.place(value);
            self.line(Vec2::new(LEFT, at), Vec2::new(self.right(), at), "grid");
            let position = Vec2::new(LEFT - TICK - 3.0, at + HALF_TEXT);
            self.art.text(position, TextAnchor::End, "label", &label);
        }
        let corner = Vec2::new(LEFT, bottom);
        let ends = [
            Vec2::new(LEFT, top),
            corner,
            Vec2::new(self.right(), bottom),
        ];
        self.art.polyline(ends, "axis");
        self.legend(panel, digits, top - 9.0);
        let along = self
            .here
            .and_then(|here| here.along)
            .filter(|&x| self.x.holds(x));
        if let Some(x) = along.map(|x| self.x.place(x)) {
            self.line(Vec2::new(x, top), Vec2::new(x, bottom), "cursor");
        }
        for (i, line) in panel.curves.iter().enumerate() {
            self.curve(line, i, &y);
            if self.extrema {
                self.turns(line, &y, digits);
            }
        }
    }

    /// Returns a vertical scale, and sets the horizontal one, so that lengths have the same scale
    /// along both.
    fn true_scales(&mut self, panel: &Panel, top: f64, bottom: f64) -> CellScale {
        let cells = Vec2::new(self.right() - LEFT, bottom - top);
        let (x, y) = (&self.plot.x, &panel.y);
        let ends = super::layout::true_ends((x.low, x.high), (y.low, y.high), cells, 1.0);
        self.x = CellScale::between(ends[0].0, ends[0].1, LEFT, self.right());
        CellScale::between(ends[1].0, ends[1].1, bottom, top)
    }

    fn line(&mut self, from: Vec2, to: Vec2, class: &str) {
        self.art.polyline([from, to], class);
    }

    fn legend(&mut self, panel: &Panel, digits: TickStyle, base: f64) {
        let unit = &panel.y.unit;
        let position = Vec2::new(LEFT - TICK - 3.0, base);
        self.art.text(position, TextAnchor::End, "label", unit);
        let mut x = LEFT + TICK;
        for (i, line) in panel.curves.iter().enumerate() {
            let middle = base - HALF_TEXT;
            let ends = [Vec2::new(x, middle), Vec2::new(x + SAMPLE, middle)];
            match line.is_places() {
                true => self.art.circle((ends[0] + ends[1]) * 0.5, MARK, "place"),
                false => self.line(ends[0], ends[1], &class(line, i)),
            }
            let value = line.figure.and_then(|i| self.here?.values.get(i).copied());
            let value = value.map(|v| v.map_or(" -".into(), |v| format!(" {}", digits.text(v))));
            let text = format!("{}{}", line.name, value.unwrap_or_default());
            let position = Vec2::new(x + SAMPLE + TICK, base);
            self.art.text(position, TextAnchor::Start, "label", &text);
            x += SAMPLE + TICK + CHARACTER * (text.chars().count() as f64 + 2.0);
        }
    }

    /// Draws a curve, clipped at the panel's top and bottom.
    fn curve(&mut self, line: &PlotCurve, i: usize, y: &CellScale) {
        let (low, high) = y.ends();
        for piece in &line.pieces {
            let inside = piece.iter().map(|p| {
                let position = Vec2::new(self.x.place(p.x), y.place(p.y));
                let seen = (low..=high).contains(&p.y);
                if seen {
                    position
                } else {
                    Vec2::new(f64::NAN, 0.0)
                }
            });
            let inside: Vec<Vec2> = inside.collect();
            if line.is_places() {
                let at = inside.first().copied();
                self.art
                    .circle(at.unwrap_or(Vec2::new(f64::NAN, 0.0)), MARK, "place");
                continue;
            }
            self.art.polyline(inside, &class(line, i));
        }
    }

    fn turns(&mut self, line: &PlotCurve, y: &CellScale, digits: TickStyle) {
        let along = self.plot.x.style();
        for turn in &line.turns {
            if !(self.x.holds(turn.at.x) && y.holds(turn.at.y)) {
                continue;
            }
            let position = Vec2::new(self.x.place(turn.at.x), y.place(turn.at.y));
            self.art.circle(position, MARK, "mark");
            let text = words().extremum(&digits.text(turn.at.y), &along.text(turn.at.x));
            let (value, x) = (turn.at.y, position.x);
            let space = CHARACTER * text.chars().count() as f64;
            let anchor = if x + space > self.right() {
                TextAnchor::End
            } else {
                TextAnchor::Start
            };
            let aside = if anchor == TextAnchor::End { -8.0 } else { 8.0 };
            let down = if turn.is_peak { 14.0 } else { -6.0 };
            debug_assert!(value.is_finite());
            self.art
                .text(position + Vec2::new(aside, down), anchor, "label", &text);
        }
    }

    fn foot(&mut self, foot: f64) {
        let axis = &self.plot.x;
        let maximum = ((self.right() - LEFT) / LABEL_APART.x).clamp(2.0, 25.0) as usize;
        let (low, high) = self.x.ends();
        let base = foot - BELOW;
        for (value, label) in Ticks::between(low, high, axis.is_angle, maximum).labels() {
            let x = self.x.place(value);
            self.line(Vec2::new(x, base), Vec2::new(x, base + TICK), "axis");
            let position = Vec2::new(x, base + TICK + 14.0);
            self.art.text(position, TextAnchor::Middle, "label", &label);
        }
        let here = self.here.and_then(|here| here.along);
        let digits = axis.style();
        let here = here.map_or(String::new(), |x| format!(" = {}", digits.text(x)));
        let title = format!("{}{here} [{}]", axis.name, axis.unit);
        let middle = Vec2::new((LEFT + self.right()) / 2.0, base + TICK + 34.0);
        self.art.text(middle, TextAnchor::Middle, "label", &title);
    }
}

fn class(line: &PlotCurve, i: usize) -> String {
    if line.is_dotted {
        "dotted".into()
    } else {
        format!("c{}", i % DASHES)
    }
}
