//! Compares a list of values of one state.

use super::DIGITS;
use super::external_table::{ForeignRow, ForeignValue};
use crate::angle;
use crate::page::{Page, Setting, Table};
use crate::quantity::Quantity;
use crate::report::text::number::{direction, significant};
use crate::solver::State;
use crate::wording::words;

pub(super) fn add_to(
    page: &mut Page,
    file: &str,
    rows: &[ForeignRow],
    state: &State,
    digits: usize,
) {
    page.part(&words().beside_file(file));
    page.text(words().beside_list(file));
    let headers = [
        "krank",
        file,
        words().foreign_difference(),
        words().part_of_it(),
    ];
    let mut table = Table::new(words().figure(), headers).set(Setting::default());
    let mut strangers = Vec::new();
    let mut is_any = false;
    for row in rows {
        let found = row.figure.as_ref();
        let found =
            found.and_then(|(quantity, value)| Some((quantity, value, quantity.value(state)?)));
        let Some((quantity, foreign, own)) = found else {
            strangers.push(row.name.as_str());
            continue;
        };
        is_any = true;
        let foreign = foreign.nearer(|value| value_difference(quantity, value, own));
        let own_text = match quantity.is_direction() {
            true => direction(own, digits),
            false => significant(own, digits),
        };
        let off = value_difference(quantity, foreign.value, own);
        let [difference, part] = format_difference(quantity, foreign, (own, off));
        let name = format!("{} [{}]", row.name, quantity.unit);
        table.row(name, [own_text, row.written.clone(), difference, part]);
    }
    if is_any {
        page.table(table);
    }
    if !strangers.is_empty() {
        page.text(words().not_compared(&strangers.join(", ")));
    }
}

/// Returns the difference of two values; for directions, the shorter way around.
pub(super) fn value_difference(quantity: &Quantity, foreign: f64, own: f64) -> f64 {
    let half = angle::TURN / 2.0;
    match quantity.is_direction() {
        true => angle::wrapped(foreign - own + half) - half,
        false => foreign - own,
    }
}

/// Returns `true` if the difference is within the rounding of the other value.
pub(super) fn is_rounding(foreign: ForeignValue, (own, off): (f64, f64)) -> bool {
    // The decimal rounding may be off by the rounding of doubles.
    off.abs() <= foreign.rounding * (1.0 + 1e-9) + 4.0 * f64::EPSILON * own.abs()
}

/// Formats the difference, absolute and relative; says that the values agree if it is within
/// rounding.
fn format_difference(
    quantity: &Quantity,
    foreign: ForeignValue,
    (own, off): (f64, f64),
) -> [String; 2] {
    if is_rounding(foreign, (own, off)) {
        return [words().agrees().to_owned(), "-".into()];
    }
    let part = match quantity.is_direction() || own == 0.0 {
        true => "-".into(),
        false => format!("{:.1e}", off / own),
    };
    [significant(off, DIGITS), part]
}
