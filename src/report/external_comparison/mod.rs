//! Compares krank's values with those of lecture notes or of another program, given as a table.

mod external_table;
mod list;
mod measurements;
mod motion_difference;

pub use external_table::{ForeignFigures, NoFigures};
pub use measurements::Measured;

use crate::page::Page;
use crate::quantity::Catalogue;
use crate::scene::Scene;
use crate::solver::{Solver, State};
use external_table::ForeignTable;

/// Significant digits of a difference.
const DIGITS: usize = 3;

impl ForeignFigures {
    /// Adds the comparison to a page. A list is compared with a state solved with forces; for a
    /// table over the driver the maximum difference of each column is shown.
    pub(super) fn add_to(
        &self,
        page: &mut Page,
        (scene, solver, state): (&Scene, &Solver, &State),
        digits: usize,
    ) {
        let catalogue = Catalogue::new(scene);
        match self.table(&catalogue) {
            ForeignTable::List(rows) => list::add_to(page, self.name(), &rows, state, digits),
            ForeignTable::CyclePath(course) => {
                motion_difference::add_to(page, self.name(), &course, solver)
            }
        }
    }
}
