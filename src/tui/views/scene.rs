//! Scene view: all values of the scene for editing, with the linkage next to them if the screen is
//! wide enough.
//!
//! ```text
//!    nudge by 1 mm         1 changed      file |
//!    driver angle          60     deg          |
//!  > r2 length            105     mm  *    100 |      drawing
//!    r2 com x               0     mm           |
//! ```

use super::motion::rule;
use super::pane::{Copied, Listing, Pane, PaneSpot};
use super::{
    Sketch, columns, cut, first_row, inset, list_rows, print, print_right, show, split,
    split_columns,
};
use crate::quantity::Subject;
use crate::scene::{Value, figure};
use crate::tui::app::{App, Mode, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{Action, SceneAction};
use crate::tui::document::editor::{Editor, part_of};
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Modifier;

/// Minimum and maximum width of a name; longer names are cut.
const MIN_NAME_LEN: u16 = 12;
const MAX_NAME_LEN: u16 = 24;
/// Minimum and maximum columns before the decimal point and from it on.
const WHOLE: (u16, u16) = (4, 10);
const FRACTION: (u16, u16) = (4, 8);
/// Minimum and maximum width of the value in the file or of the formula.
const FILE_VALUE_WIDTH: (u16, u16) = (10, 22);
/// Columns before a name: the cursor and the mark of a change.
const CURSOR: u16 = 2;
/// Height of the line above the list.
const HEAD: u16 = 1;
/// Minimum width of a drawing.
const MIN_DRAWING_WIDTH: u16 = 26;

/// The areas of the list and of the drawing.
struct SceneAreas {
    list: Rect,
    /// The separator and the drawing, if they fit and the drawing is not shown elsewhere.
    beside: Option<(Rect, Rect)>,
}

fn arrange(app: &App, body: Rect) -> SceneAreas {
    let list = ColumnWidths::of(app.editor()).width() + 1 + super::MARGIN;
    let has_drawing = app.visible_views().contains(&View::Motion);
    match body.width.checked_sub(list + 1).filter(|_| !has_drawing) {
        Some(width) if width >= MIN_DRAWING_WIDTH => {
            let (list, side) = split_columns(body, list);
            SceneAreas {
                list: inset(list),
                beside: Some(split_columns(side, 1)),
            }
        }
        Some(_) | None => SceneAreas {
            list: inset(body),
            beside: None,
        },
    }
}

/// Returns the area of the values and the first visible value.
fn rows(editor: &Editor, list: Rect) -> (Rect, usize) {
    let rows = split(list, HEAD).1;
    let first = first_row(editor.cursor(), editor.values().len(), rows.height.into());
    (rows, first)
}

/// Widths of the columns: those of the longest entries, so that columns keep their places while
/// values change.
struct ColumnWidths {
    name: u16,
    whole: u16,
    fraction: u16,
    unit: u16,
    file_width: u16,
}

/// The scene view: all values of the scene.
pub(super) struct SceneView;

impl Pane for SceneView {
    fn view(&self) -> View {
        View::Scene
    }

    fn list(&self) -> Listing {
        Listing::Values
    }

    fn prepare(&self, app: &App, sketch: &mut Sketch, body: Rect) {
        if let Some((_, drawing)) = arrange(app, body).beside {
            sketch.draw_in(app, drawing);
        }
    }

    fn render(&self, app: &App, sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let SceneAreas { list, beside: side } = arrange(app, body);
        if let Some((line, drawing)) = side {
            rule(app.glyphs(), line, buffer);
            show(sketch.raster(), drawing, buffer);
        }
        let editor = app.editor();
        let columns = ColumnWidths::of(editor);
        columns.head(editor, list, buffer);
        let (rows, _) = rows(editor, list);
        let (values, cursor) = (editor.values(), editor.cursor());
        for (number, row) in list_rows(cursor, values.len(), rows, buffer) {
            let value = &values[number];
            // The name of an element is emphasized only in the first row of its values.
            let before = number.checked_sub(1).filter(|_| row.y > rows.y);
            let continues = before.is_some_and(|before| part_of(&values[before]) == part_of(value));
            columns.row(app, value, number == cursor, row, buffer);
            if continues && number != cursor {
                let name = split_columns(row, CURSOR).1;
                let part = columns_of_part(value).min(columns.name);
                let style = theme::part(ScreenPart::Quiet).remove_modifier(Modifier::BOLD);
                buffer.set_style(split_columns(name, part).0, style);
            }
        }
    }

    fn subject(&self, app: &App) -> Option<Subject> {
        Subject::of_value(app.open_scene().scene(), app.editor().value()?)
    }

    fn under(&self, app: &App, body: Rect, at: Position) -> Option<PaneSpot> {
        let (rows, first) = rows(app.editor(), arrange(app, body).list);
        let row = first + usize::from(at.y.checked_sub(rows.y)?);
        let is_there = rows.contains(at) && row < app.editor().values().len();
        is_there.then_some(PaneSpot::Value(row))
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let height = arrange(app, body).list.height;
        (
            app.editor().values().len(),
            height.saturating_sub(HEAD).into(),
        )
    }

    fn hints(&self, app: &App) -> &'static [Action] {
        if app.editor().staged.is_some() {
            return &[
                Action::Scene(SceneAction::Gather),
                Action::Back,
                Action::Scene(SceneAction::Edit),
                Action::Scene(SceneAction::NudgeDown),
                Action::Scene(SceneAction::NudgeUp),
                Action::Help,
            ];
        }
        &[
            Action::Help,
            Action::Scene(SceneAction::Edit),
            Action::Scene(SceneAction::NudgeDown),
            Action::Scene(SceneAction::NudgeUp),
            Action::Save,
            Action::Undo,
            Action::MOTION,
            Action::Quit,
        ]
    }

    fn copy(&self, app: &App) -> Copied {
        let value = app.editor().value();
        value.map_or(Copied::Nothing, |value| Copied::Text(value.text()))
    }
}

impl ColumnWidths {
    fn of(editor: &Editor) -> ColumnWidths {
        let widest = |width: &dyn Fn(&Value) -> u16| editor.values().iter().map(width).max();
        let widest = |width: &dyn Fn(&Value) -> u16| widest(width).unwrap_or(0);
        let part = |which: usize| {
            widest(&|value| {
                let number = number_of(value);
                let (text, fraction) = halves(&number);
                columns([text, fraction][which])
            })
        };
        ColumnWidths {
            name: widest(&|v| columns(&v.name)).clamp(MIN_NAME_LEN, MAX_NAME_LEN),
            whole: part(0).clamp(WHOLE.0, WHOLE.1),
            fraction: part(1).clamp(FRACTION.0, FRACTION.1),
            unit: widest(&|v| columns(v.unit)),
            file_width: widest(&|v| formula_of(v).map_or(0, |formula| columns(&formula)))
                .clamp(FILE_VALUE_WIDTH.0, FILE_VALUE_WIDTH.1),
        }
    }

    /// Returns the columns from the cursor to the unit.
    fn values(&self) -> u16 {
        CURSOR + self.name + 1 + self.whole + self.fraction + 1 + self.unit
    }

    /// Returns the width of all columns.
    fn width(&self) -> u16 {
        self.values() + 2 + self.file_width
    }

    fn head(&self, editor: &Editor, area: Rect, buffer: &mut Buffer) {
        let style = theme::part(ScreenPart::Quiet);
        let Some(value) = editor.value() else {
            let text = words().no_numbers();
            print(buffer, area.x, area.y, area.width, text, style);
            return;
        };
        let nudge = match (&editor.staged, formula_of(value)) {
            (Some(gathered), _) => words().gathering(gathered.len()),
            // A value with a formula depends on others, so it cannot be nudged.
            (None, Some(formula)) => formula,
            (None, None) => words().nudge_by(&editor.notch().to_string(), value.unit),
        };
        print(buffer, area.x + CURSOR, area.y, area.width, &nudge, style);
        // A narrow list has no column for the value in the file.
        let is_wide = area.width >= self.width();
        let filed = editor.in_file(value).filter(|_| !is_wide);
        let message = match (editor.changes(), filed) {
            (0, _) => String::new(),
            (_, Some(filed)) => words().value_in_file(&filed.literal),
            (_, None) if is_wide => words().in_the_file().into(),
            (n, None) => words().values_changed(n),
        };
        let width = if is_wide { self.width() } else { self.values() };
        let right = area.x + width.min(area.width);
        print_right(buffer, right, area.y, &message, style);
    }

    fn row(&self, app: &App, value: &Value, under_cursor: bool, area: Rect, buffer: &mut Buffer) {
        let part = |other| theme::part(if under_cursor { ScreenPart::Key } else { other });
        let editor = app.editor();
        let filed = editor.in_file(value);
        let waiting = editor.staged.as_ref();
        let waiting = waiting.and_then(|gathered| gathered.text(&value.name));
        let waiting = waiting.map(|text| value.with_text(text));
        let is_changed = filed.is_some() || editor.is_new(value);
        let mark = match (&waiting, is_changed) {
            (Some(_), _) => "+",
            (None, true) => "*",
            (None, false) => " ",
        };
        let cursor = if under_cursor { ">" } else { " " };
        let (y, right) = (area.y, area.right());
        let mut put = |x: u16, text: &str, style| {
            print(buffer, x, y, right.saturating_sub(x), text, style);
        };
        put(area.x, cursor, part(ScreenPart::Key));
        put(area.x + 1, mark, theme::part(ScreenPart::Warning));
        let name = cut(&shown(&value.name, app.glyphs()), self.name.into());
        let at = area.x + CURSOR;
        put(at, &name, part(ScreenPart::Name));
        let point = at + self.name + 1 + self.whole;
        let unit = point + self.fraction + 1;
        let typed = match app.mode() {
            Mode::Value(line) if under_cursor => Some(line.text()),
            _ => None,
        };
        if let Some(typed) = typed {
            // A typed text may be longer than the column; its end is visible.
            let from = at + self.name + 1;
            let space = usize::from(right.saturating_sub(from + 1));
            let skipped = typed.len().saturating_sub(space);
            let seen = typed.get(skipped..).unwrap_or_default();
            put(from, seen, theme::part(ScreenPart::Text));
            put(from + columns(seen), " ", theme::part(ScreenPart::Caret));
            return;
        }
        put(unit, value.unit, part(ScreenPart::Quiet));
        let style = match waiting {
            Some(_) => theme::part(ScreenPart::Warning),
            None => part(ScreenPart::Text),
        };
        let is_wide = area.width >= self.width();
        let shown = waiting.as_ref().unwrap_or(value);
        let number = match &waiting {
            // The result of a staged formula is unknown; the formula itself is shown next to it on
            // a wide list.
            Some(waiting) if waiting.formula.is_some() && is_wide => String::new(),
            Some(waiting) => waiting.literal.clone(),
            None => number_of(value),
        };
        self.number(&number, point, y, style, buffer);
        let side = match filed {
            _ if waiting.is_some() && shown.formula.is_some() => formula_of(shown),
            Some(filed) if filed.unit == value.unit => Some(filed.literal.clone()),
            Some(filed) => Some(filed.text()),
            None => formula_of(shown),
        };
        if let Some(text) = side
            && is_wide
        {
            let text = cut(&text, self.file_width.into());
            print_right(
                buffer,
                area.x + self.width(),
                y,
                &text,
                match waiting {
                    Some(waiting) if waiting.formula.is_some() => style,
                    _ => theme::part(ScreenPart::Quiet),
                },
            );
        }
    }

    /// Prints a number with its decimal point at column `point`.
    fn number(
        &self,
        literal: &str,
        point: u16,
        y: u16,
        style: ratatui::style::Style,
        buffer: &mut Buffer,
    ) {
        let (whole, fraction) = halves(literal);
        if columns(whole) > self.whole || columns(fraction) > self.fraction {
            let text = cut(literal, usize::from(self.whole + self.fraction));
            print_right(buffer, point + self.fraction, y, &text, style);
            return;
        }
        print_right(buffer, point, y, whole, style);
        print(buffer, point, y, self.fraction, fraction, style);
    }
}

/// Returns the number of a value as written in the file, or the short result of its formula.
fn number_of(value: &Value) -> String {
    match value.formula {
        Some(_) => figure(value.number),
        None => value.literal.clone(),
    }
}

/// Returns the formula of a value as shown next to its number.
fn formula_of(value: &Value) -> Option<String> {
    value.formula.as_ref().map(|formula| format!("= {formula}"))
}

/// Returns the width of the element's name at the start of the value's name.
fn columns_of_part(value: &Value) -> u16 {
    columns(part_of(value))
}

/// Splits a number before its decimal point or exponent.
fn halves(literal: &str) -> (&str, &str) {
    let at = literal.find(['.', 'e', 'E']).unwrap_or(literal.len());
    literal.split_at(at)
}
