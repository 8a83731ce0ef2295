//! Compares columns over the driver's coordinate: the maximum difference of each, and its place.

use super::DIGITS;
use super::external_table::ForeignCurves;
use super::list::{is_rounding, value_difference};
use crate::page::{Page, Setting, Table};
use crate::quantity::Quantity;
use crate::report::text::number::significant;
use crate::solver::{Condition, Order, Solver};
use crate::wording::words;

/// The comparison of a column.
#[derive(Clone, Copy, Default)]
struct ColumnComparison {
    rows: usize,
    at: f64,
    off: f64,
    /// The root of the sum of the squares of all differences. It is accumulated by `hypot`, because
    /// the sum itself could overflow.
    root: f64,
    /// The maximum absolute value of krank in the column.
    most: f64,
    /// The number of differences that exceed the rounding of the other value.
    exceeding: usize,
}

pub(super) fn add_to(page: &mut Page, file: &str, course: &ForeignCurves, solver: &Solver) {
    page.part(&words().beside_file(file));
    add_table(page, file, course, solver);
}

/// Adds the comparison without its title.
pub(super) fn add_table(page: &mut Page, file: &str, course: &ForeignCurves, solver: &Solver) {
    page.text(words().beside_course(file, course.rows.len()));
    let extreme = furthest(course, solver);
    let at = format!("{} [{}]", words().at_driver(), course.driver.unit);
    let headers = [
        words().rows_compared(),
        words().root_mean_square(),
        words().largest_difference(),
        &at,
        words().of_largest(),
        words().beyond_rounding(),
    ];
    let mut table = Table::new(words().figure(), headers).set(Setting::default());
    for (quantity, one) in course.columns.iter().zip(&extreme) {
        let name = format!("{} [{}]", quantity.name, quantity.unit);
        table.row(name, one.cells(quantity));
    }
    if !(course.columns.is_empty() || course.rows.is_empty()) {
        page.table(table);
    }
    if !course.unknown_names.is_empty() {
        page.text(words().not_compared(&course.unknown_names.join(", ")));
    }
    if let Some(left_out) = course.left_out() {
        page.text(left_out);
    }
}

impl ColumnComparison {
    fn cells(&self, quantity: &Quantity) -> [String; 6] {
        let part = match self.off != 0.0 && self.most > 0.0 && !quantity.is_direction() {
            true => format!("{:.1e}", self.off.abs() / self.most),
            false => "-".into(),
        };
        let (off, at) = match self.off == 0.0 {
            true => ("0".into(), "-".into()),
            false => (significant(self.off, DIGITS), significant(self.at, 6)),
        };
        let mean = match self.rows {
            0 => "-".into(),
            rows => significant(self.root / (rows as f64).sqrt(), DIGITS),
        };
        [
            self.rows.to_string(),
            mean,
            off,
            at,
            part,
            self.exceeding.to_string(),
        ]
    }
}

/// Compares each column.
fn furthest(course: &ForeignCurves, solver: &Solver) -> Vec<ColumnComparison> {
    let orders = course.columns.iter().map(|quantity| quantity.order());
    let order = orders.max().unwrap_or(Order::Position);
    let mut extreme = vec![ColumnComparison::default(); course.columns.len()];
    let mut state = solver.state();
    for (at, values) in &course.rows {
        if solver.solve(*at, order, &mut state) == Condition::NoAssembly {
            continue;
        }
        for ((quantity, value), one) in course.columns.iter().zip(values).zip(&mut extreme) {
            let (Some(foreign), Some(own)) = (value, quantity.value(&state)) else {
                continue;
            };
            let foreign = foreign.nearer(|value| value_difference(quantity, value, own));
            let off = value_difference(quantity, foreign.value, own);
            one.rows += 1;
            one.root = one.root.hypot(off);
            one.most = one.most.max(own.abs());
            one.exceeding += usize::from(!is_rounding(foreign, (own, off)));
            if off.abs() > one.off.abs() {
                (one.off, one.at) = (off, *at);
            }
        }
    }
    extreme
}
