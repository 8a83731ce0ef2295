//! The list of assemblies, shown in place of the tables: each group's possible choices and the
//! current one.
//!
//! ```text
//!   C + (311.4, 233.8)  now
//! > C - (212.6, -165.5)
//! ```

use super::{columns, cut, list_rows, print};
use crate::assembly::pick_text;
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::assembly_list::{AssemblyList, AssemblyRow};
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Maximum width of a group's name; longer names are cut.
const MAX_NAME_LEN: usize = 9;
/// Columns between two parts of a row.
const GAP: u16 = 1;

pub(super) fn render(app: &App, assemblies: &AssemblyList, area: Rect, buffer: &mut Buffer) {
    let rows: Vec<&AssemblyRow> = assemblies.list.listed().collect();
    let (widths, cursor) = (Widths::of(&rows), assemblies.list.cursor());
    for (at, line) in list_rows(cursor, rows.len(), area, buffer) {
        render_row(app, rows[at], at == cursor, &widths, line, buffer);
    }
}

/// Widths of the parts of a row, in columns.
struct Widths {
    name: u16,
    pick: u16,
    place: u16,
}

impl Widths {
    fn of(rows: &[&AssemblyRow]) -> Widths {
        let widest = |text: &dyn Fn(&AssemblyRow) -> u16| {
            let widths = rows.iter().map(|row| text(row));
            widths.max().unwrap_or(0)
        };
        Widths {
            name: widest(&|row| columns(&name(row))),
            pick: widest(&|row| columns(&pick_text(row.choice.pick))),
            place: widest(&|row| columns(&row.place)),
        }
    }
}

fn name(row: &AssemblyRow) -> String {
    cut(&row.name, MAX_NAME_LEN)
}

fn render_row(
    app: &App,
    row: &AssemblyRow,
    under_cursor: bool,
    widths: &Widths,
    area: Rect,
    buffer: &mut Buffer,
) {
    let part = |other| theme::part(if under_cursor { ScreenPart::Key } else { other });
    let mut x = area.x;
    let right = area.right();
    let mut put = |text: &str, width: u16, style| {
        let space = right.saturating_sub(x);
        print(buffer, x, area.y, space, text, style);
        x = x.saturating_add(width + GAP);
    };
    put(
        if under_cursor { ">" } else { " " },
        1,
        part(ScreenPart::Key),
    );
    put(
        &shown(&name(row), app.glyphs()),
        widths.name,
        part(ScreenPart::Name),
    );
    put(
        &pick_text(row.choice.pick),
        widths.pick,
        part(ScreenPart::Text),
    );
    put(&row.place, widths.place, part(ScreenPart::Text));
    let message = match (row.choice.is_current, row.choice.closes) {
        (true, _) => words().shown_now(),
        (false, true) => "",
        (false, false) => words().does_not_close(),
    };
    put(message, 0, part(ScreenPart::Quiet));
}
