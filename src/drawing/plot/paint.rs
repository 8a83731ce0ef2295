//! Draws a plot in cells.

use super::frame::{FrameGlyphs, length, write};
use super::layout::{PanelArea, PlotLayout, level_labels, unit_place};
use super::path::{PLACE, Pen};
use super::{CurveTurn, Panel, Plot, PlotStyle};
use crate::Vec2;
use crate::drawing::cells::blocks::settle;
use crate::drawing::cells::labels::free_places;
use crate::drawing::cells::raster::Raster;
use crate::drawing::cells::render::Glyphs;
use crate::drawing::figure::Role;
use crate::quantity::StateValues;
use crate::wording::words;

/// Symbols of curves, in their order in a panel; they repeat after the last.
const SYMBOLS: [char; 12] = ['*', 'x', '#', '+', '%', '@', '&', '=', '$', 'a', 'b', 'c'];
/// The glyph where the cursor meets a curve.
const CURSOR: char = 'O';
const PEAK: char = '^';
const DIP: char = 'v';
/// Columns of a legend's parts: a symbol and the blank after it, the blanks after an entry, and the
/// count of entries that do not fit.
const ENTRY: i32 = 2;
const GAP: i32 = 3;
const MORE: i32 = 4;
/// Distance of symbols on a line, as a divisor of the panel's width, and its minimum in cells.
const APART: i32 = 5;
const MIN_DISTANCE: i32 = 8;
/// Maximum distance of a text from its extremum, in rows, inside the arch.
const MAX_DEPTH: i32 = 2;
/// Maximum number of columns, to each side of an extremum, in which the curve stays in its row, for
/// a text written after it.
const FLATTEST: i32 = 10;

/// A plot in cells without the cursor, which is added to a copy in each frame.
#[derive(Debug)]
pub struct PlotCanvas {
    style: PlotStyle,
    /// `None` if the cells do not suffice.
    layout: Option<PlotLayout>,
    raster: Raster,
    /// Whether a cell shows nothing but an axis, so that the line of the cursor is drawn there.
    is_open: Vec<bool>,
}

impl PlotCanvas {
    /// Returns the style.
    #[must_use]
    pub fn style(&self) -> &PlotStyle {
        &self.style
    }
}

impl Plot {
    /// Renders the plot in cells, with the cursor in a state; empty if the cells do not suffice.
    #[must_use]
    pub fn render(&self, style: &PlotStyle, here: Option<&StateValues>) -> Raster {
        self.with_cursor(&self.canvas(style), here)
    }

    /// Renders everything but the cursor and the legends, which show its values.
    #[must_use]
    pub fn canvas(&self, style: &PlotStyle) -> PlotCanvas {
        let mut canvas = PlotCanvas {
            style: *style,
            layout: self.layout(style),
            raster: Raster::new(),
            is_open: Vec::new(),
        };
        canvas.raster.reset(style.cols, style.rows);
        if let Some(layout) = &canvas.layout {
            let painter = self.painter(style, layout, None);
            let seats = style
                .glyphs
                .is_dotted()
                .then(|| self.plain_seats(style, layout));
            let mut axes = canvas.raster.clone();
            painter.axes(&mut axes);
            painter.paint(&mut canvas.raster, seats.as_deref());
            let cells = axes.lines().flatten().zip(canvas.raster.lines().flatten());
            canvas.is_open = cells.map(|(axis, cell)| axis == cell).collect();
        }
        settle(&mut canvas.raster, style.glyphs);
        canvas
    }

    /// Returns a copy of this plot's canvas with the cursor in a state.
    #[must_use]
    pub fn with_cursor(&self, canvas: &PlotCanvas, here: Option<&StateValues>) -> Raster {
        let mut raster = canvas.raster.clone();
        if let Some(layout) = &canvas.layout {
            let painter = self.painter(&canvas.style, layout, here);
            painter.cursor(&canvas.is_open, &mut raster);
        }
        raster
    }

    fn painter<'p>(
        &'p self,
        style: &'p PlotStyle,
        layout: &'p PlotLayout,
        here: Option<&'p StateValues>,
    ) -> PlotPainter<'p> {
        PlotPainter {
            plot: self,
            look: style,
            here,
            strokes: FrameGlyphs::of(style.glyphs),
            layout,
        }
    }

    /// Returns the texts of extrema placed as in plain characters. A curve of dots touches a few
    /// more cells, which would leave fewer places.
    fn plain_seats(&self, style: &PlotStyle, layout: &PlotLayout) -> Vec<WrittenTurn> {
        let style = &PlotStyle {
            glyphs: Glyphs::Ascii,
            ..*style
        };
        let mut raster = Raster::new();
        raster.reset(style.cols, style.rows);
        let painter = PlotPainter {
            look: style,
            ..self.painter(style, layout, None)
        };
        painter.paint(&mut raster, None)
    }
}

/// A text at an extremum of a curve, with its position.
struct WrittenTurn {
    panel: usize,
    at: (i32, i32),
    text: String,
}

struct PlotPainter<'a> {
    plot: &'a Plot,
    look: &'a PlotStyle,
    here: Option<&'a StateValues>,
    strokes: FrameGlyphs,
    layout: &'a PlotLayout,
}

impl PlotPainter<'_> {
    /// Paints the axes.
    fn axes(&self, raster: &mut Raster) {
        self.level_axis(raster);
        for (_, frame) in &self.layout.panels {
            self.upright_axis(frame, raster);
        }
    }

    /// Paints everything but the cursor and the legends. Texts of extrema are placed as `given`, or
    /// else wherever there is space; the new ones are returned.
    fn paint(&self, raster: &mut Raster, given: Option<&[WrittenTurn]>) -> Vec<WrittenTurn> {
        let mut written = Vec::new();
        self.axes(raster);
        for (number, frame) in &self.layout.panels {
            let panel = &self.plot.panels[*number];
            self.curves(panel, frame, raster);
            if self.look.extrema {
                self.mark_turns(panel, frame, raster);
                match given {
                    Some(given) => {
                        for turn in given.iter().filter(|turn| turn.panel == *number) {
                            let (col, row) = turn.at;
                            write(raster, col, row, &turn.text, Role::Label);
                        }
                    }
                    None => self.write_turns((*number, panel), frame, raster, &mut written),
                }
            }
        }
        written
    }

    /// Paints the cursor, and the legends with its values.
    fn cursor(&self, is_open: &[bool], raster: &mut Raster) {
        let title = self.cursor_title(raster);
        let along = self.here.and_then(|here| here.along);
        let col = along.and_then(|x| self.layout.x.cell(x));
        for (k, (number, frame)) in self.layout.panels.iter().enumerate() {
            let panel = &self.plot.panels[*number];
            let right = if k == 0 { title } else { self.layout.end };
            self.legend(panel, frame, right, raster);
            let Some(col) = col else { continue };
            for row in frame.block.top..frame.block.top + frame.block.height {
                let index = raster.index(col, row);
                if index.is_some_and(|index| is_open.get(index) == Some(&true)) {
                    raster.set_cell(col, row, self.strokes.cursor, Role::Ghost);
                }
            }
            self.meeting_points(panel, frame, col, raster);
        }
    }

    fn level_axis(&self, raster: &mut Raster) {
        let PlotLayout {
            axis, foot, end, ..
        } = *self.layout;
        self.strokes.draw_level(axis..end, foot, raster);
        let mut labels = level_labels(&self.layout.x_ticks, &self.layout.x, end);
        for label in &labels {
            raster.set_cell(label.tick, foot, self.strokes.tick, Role::Axis);
        }
        let Some(last) = labels.pop() else { return };
        let unit = &self.plot.x.unit;
        let (mut taken, place) = unit_place(&last, unit, end);
        write(raster, last.from, foot + 1, &last.text, Role::Axis);
        write(raster, place, foot + 1, unit, Role::Axis);
        for label in labels.iter().rev() {
            if label.end() < taken {
                write(raster, label.from, foot + 1, &label.text, Role::Axis);
                taken = label.from;
            }
        }
    }

    /// Writes the name of x and the cursor's value at the right end of the first legend, as far as
    /// the curves' entries leave space. Returns the column at which it begins.
    fn cursor_title(&self, raster: &mut Raster) -> i32 {
        let end = self.layout.end;
        let Some((number, frame)) = self.layout.panels.first() else {
            return end;
        };
        let panel = &self.plot.panels[*number];
        let entries = (0..panel.curves.len()).map(|i| self.entry(panel, frame, i, true));
        let wanted: i32 = entries.map(|entry| length(&entry) + ENTRY + GAP).sum();
        let space = (end - self.legend_start(panel) - wanted).max(0);
        let x = &self.plot.x;
        let here = self.here.and_then(|here| here.along);
        let here = here.map(|along| format!("{} {}", x.text(Some(along), x.style()), x.unit));
        let name = words().over(&x.name);
        let long = here.as_ref().map(|here| format!("{name} {here}"));
        let titles = [long, Some(name), here];
        let title = titles
            .into_iter()
            .flatten()
            .find(|title| length(title) <= space);
        let Some(title) = title else {
            return end;
        };
        let from = end - length(&title);
        write(raster, from, frame.legend, &title, Role::Axis);
        from - 1
    }

    /// Returns the column of a legend's first curve, after the unit.
    fn legend_start(&self, panel: &Panel) -> i32 {
        (self.layout.axis + 1).max(length(&panel.y.unit) + 1)
    }

    /// Returns a curve's entry in the legend: its name, and its value at the cursor.
    fn entry(&self, panel: &Panel, frame: &PanelArea, i: usize, with_value: bool) -> String {
        let line = &panel.curves[i];
        let along = self.here.and_then(|here| here.along).filter(|_| with_value);
        if let Some(off) = along.and_then(|x| line.band.as_ref()?.text(x)) {
            return format!("{} {off}", line.name);
        }
        let figure = line.figure.filter(|_| with_value);
        let value = figure.and_then(|figure| self.here?.values.get(figure).copied());
        let Some(value) = value else {
            return line.name.clone();
        };
        format!("{} {}", line.name, panel.y.text(value, frame.style))
    }

    fn upright_axis(&self, frame: &PanelArea, raster: &mut Raster) {
        let axis = self.layout.axis;
        let block = frame.block;
        let rows = block.top..block.top + block.height;
        let mut free = rows.end;
        self.strokes.draw_upright(axis, rows, raster);
        for (value, label) in frame.ticks.labels() {
            let Some(row) = frame.y.cell(value).filter(|&row| row < free) else {
                continue;
            };
            self.strokes.draw_label((axis, row), &label, raster);
            free = row;
        }
        if let Some(row) = frame.y.cell(0.0).filter(|_| frame.y.crosses(0.0)) {
            for col in (block.left..block.left + block.width).step_by(2) {
                raster.set_cell(col, row, self.strokes.nought, Role::Ghost);
            }
        }
    }

    /// Draws the unit, and each curve with its symbol, name and value at the cursor, then the
    /// number of curves that do not fit.
    fn legend(&self, panel: &Panel, frame: &PanelArea, right: i32, raster: &mut Raster) {
        let start = self.legend_start(panel);
        write(raster, 0, frame.legend, &panel.y.unit, Role::Axis);
        let (mut col, mut row) = (start, frame.legend);
        let last = frame.legend + frame.legend_rows - 1;
        let count = panel.curves.len();
        let end = |row| {
            if row == frame.legend {
                right
            } else {
                self.layout.end
            }
        };
        for i in 0..count {
            let more = if i + 1 < count && row == last {
                MORE
            } else {
                0
            };
            let fits = |text: &str, col, row| col + ENTRY + length(text) + more <= end(row);
            let mut text = self.entry(panel, frame, i, true);
            if !fits(&text, col, row) && col > start && row < last {
                (col, row) = (start, row + 1);
            }
            if !fits(&text, col, row) && col > start {
                write(raster, col, row, &format!("+{}", count - i), Role::Axis);
                break;
            }
            // A value that does not fit is left out, never cut.
            if !fits(&text, col, row) {
                text = self.entry(panel, frame, i, false);
            }
            raster.set_cell(col, row, self.symbol(panel, i), panel.role(i));
            let space = usize::try_from(end(row) - col - ENTRY).unwrap_or(0);
            let text: String = text.chars().take(space).collect();
            write(raster, col + ENTRY, row, &text, Role::Label);
            col += ENTRY + length(&text) + GAP;
        }
    }

    /// Returns the symbol of a curve in the legend and on the curve.
    fn symbol(&self, panel: &Panel, i: usize) -> char {
        if panel.curves[i].is_places() {
            return PLACE;
        }
        if panel.curves[i].is_dotted {
            return if self.look.glyphs == Glyphs::Ascii {
                '.'
            } else {
                '\u{b7}'
            };
        }
        let alone = panel.curves.iter().filter(|line| !line.is_dotted).count() == 1;
        if alone && self.look.glyphs != Glyphs::Ascii {
            return self.strokes.sample;
        }
        SYMBOLS[i % SYMBOLS.len()]
    }

    fn curves(&self, panel: &Panel, frame: &PanelArea, raster: &mut Raster) {
        let count = i32::try_from(panel.curves.len()).unwrap_or(1);
        let every = (frame.block.width / APART).max(MIN_DISTANCE);
        let alone = panel.curves.iter().filter(|line| !line.is_dotted).count() == 1;
        let pens = (0..).zip(&panel.curves).map(|(i, line)| {
            let number = usize::try_from(i).unwrap_or(0);
            let first = every / 2 + every * i / count;
            let marks = (!alone && !line.is_dotted)
                .then(|| (every.unsigned_abs() as usize, first.unsigned_abs() as usize));
            let pen = Pen {
                glyphs: self.look.glyphs,
                symbol: SYMBOLS[number % SYMBOLS.len()],
                role: panel.role(number),
                dotted: line.is_dotted,
                marks,
            };
            let cells = |piece: &Vec<Vec2>| -> Vec<Vec2> {
                piece.iter().map(|&p| self.place(frame, p)).collect()
            };
            let pieces: Vec<Vec<Vec2>> = line.pieces.iter().map(cells).collect();
            (pen, pieces)
        });
        let pens: Vec<(Pen, Vec<Vec<Vec2>>)> = pens.collect();
        for (pen, pieces) in &pens {
            for piece in pieces {
                pen.draw(piece, &frame.block, raster);
            }
        }
        for (pen, pieces) in &pens {
            for piece in pieces {
                pen.mark(piece, &frame.block, raster);
            }
        }
    }

    fn place(&self, frame: &PanelArea, p: Vec2) -> Vec2 {
        Vec2::new(self.layout.x.place(p.x), frame.y.place(p.y))
    }

    /// Returns the extrema of the curves, with their roles and cells.
    fn turns<'p>(
        &self,
        panel: &'p Panel,
        frame: &PanelArea,
    ) -> Vec<(&'p CurveTurn, Role, (i32, i32))> {
        let lines = panel.curves.iter().enumerate();
        let lines = lines.map(|(i, line)| (line, panel.role(i)));
        let turns = lines.flat_map(|(line, role)| line.turns.iter().map(move |turn| (turn, role)));
        let cell =
            |turn: &CurveTurn| Some((self.layout.x.cell(turn.at.x)?, frame.y.cell(turn.at.y)?));
        let placed = turns.filter_map(|(turn, role)| Some((turn, role, cell(turn)?)));
        placed.collect()
    }

    fn mark_turns(&self, panel: &Panel, frame: &PanelArea, raster: &mut Raster) {
        for (turn, _, (col, row)) in self.turns(panel, frame) {
            let glyph = if turn.is_peak { PEAK } else { DIP };
            raster.set_cell(col, row, glyph, Role::Front);
        }
    }

    /// Writes the values of extrema as far as there is space, the global ones first.
    fn write_turns(
        &self,
        (number, panel): (usize, &Panel),
        frame: &PanelArea,
        raster: &mut Raster,
        written: &mut Vec<WrittenTurn>,
    ) {
        let mut placed = self.turns(panel, frame);
        placed.sort_by_key(|(turn, ..)| !turn.is_extreme);
        let x = self.plot.x.style();
        for (turn, role, point) in placed {
            let (value, along) = (frame.style.text(turn.at.y), x.text(turn.at.x));
            let text = words().extremum(&value, &along);
            let inside = |&(col, row): &(i32, i32)| {
                let last = col + length(&text) - 1;
                frame.block.contains((col, row)) && frame.block.contains((last, row))
            };
            let inwards = if turn.is_peak { 1 } else { -1 };
            let place = seats(raster, point, inwards, role, &text).find(inside);
            if let Some(at) = place {
                write(raster, at.0, at.1, &text, Role::Label);
                written.push(WrittenTurn {
                    panel: number,
                    at,
                    text,
                });
            }
        }
    }

    /// Marks the points where the cursor meets the curves.
    fn meeting_points(&self, panel: &Panel, frame: &PanelArea, col: i32, raster: &mut Raster) {
        let Some(here) = self.here else { return };
        let figures = panel.curves.iter().filter_map(|line| line.figure);
        for value in figures.filter_map(|index| here.values.get(index).copied().flatten()) {
            if let Some(row) = frame.y.cell(value) {
                raster.set_cell(col, row, CURSOR, Role::Front);
            }
        }
    }
}

/// Returns the places where the text of an extremum hides nothing. Places close to it come first.
/// Then come places in its row after the flat part of the curve. The last ones are inside the arch,
/// up to `MAX_DEPTH` rows `inwards`.
fn seats<'r>(
    raster: &'r Raster,
    (col, row): (i32, i32),
    inwards: i32,
    role: Role,
    text: &'r str,
) -> impl Iterator<Item = (i32, i32)> + use<'r> {
    let close = free_places(raster, (col, row), text).into_iter();
    let is_flat = move |to: i32| {
        let between = (col.min(to)..=col.max(to)).filter(move |&c| c != col);
        let mut roles = between.filter_map(move |c| Some(raster.cell(c, row)?.role));
        roles.all(|r| r == role || matches!(r, Role::Empty | Role::Ghost))
    };
    let aside = (1..=FLATTEST).flat_map(|k| [k, -k]).map(move |k| col + k);
    let aside = aside.filter(move |&to| is_flat(to)).flat_map(move |to| {
        let places = free_places(raster, (to, row), text);
        places.into_iter().filter(move |place| place.1 == row)
    });
    let inside = (1..=MAX_DEPTH)
        .flat_map(move |depth| free_places(raster, (col, row + inwards * depth), text));
    close.chain(aside).chain(inside)
}
