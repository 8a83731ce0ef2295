//! krank's figures beside those of a lecture's notes or of another program, which come as a table of cells.

mod course;
mod foreign;
mod list;
mod measured;

pub use foreign::{ForeignFigures, NoFigures};
pub use measured::Measured;

use crate::page::Page;
use crate::quantity::Catalogue;
use crate::scene::Scene;
use crate::solver::{Solver, State};
use foreign::ForeignTable;

/// Significant digits of a difference.
const DIGITS: usize = 3;

impl ForeignFigures {
    /// The figures beside krank's: of a list those of a state, which was solved with forces; of a table over the
    /// driver the largest difference of each column.
    pub(super) fn add_to(
        &self,
        page: &mut Page,
        (scene, solver, state): (&Scene, &Solver, &State),
        digits: usize,
    ) {
        let catalogue = Catalogue::new(scene);
        match self.table(&catalogue) {
            ForeignTable::List(rows) => list::add_to(page, self.name(), &rows, state, digits),
            ForeignTable::Course(course) => course::add_to(page, self.name(), &course, solver),
        }
    }
}
