//! Rows over time while inputs follow a point.

use super::{Columns, REPORTED, SweepOutcome};
use crate::quantity::demand;
use crate::report::sweep::steps::Steps;
use crate::report::text::rows::{RowFormat, RowWriter};
use crate::scene::{LeadingPoint, Scene};
use crate::solver::{Condition, LeadSingularity, PointLeader, Solver};
use crate::wording::words;
use std::io::{self, Write};

/// Maximum number of singular rows whose singularities are kept.
const LISTED: usize = 5;

/// The rows of a sweep over time in which the inputs of a scene follow its leading point.
#[derive(Clone, Copy, Debug)]
pub struct LeadSweep<'a> {
    /// The scene, whose name JSON contains.
    pub scene: &'a Scene,
    /// The inputs, where the scene opens.
    pub leader: &'a PointLeader,
    /// The leading point of the scene.
    pub lead: &'a LeadingPoint,
    /// The values of each row, after its time ([`Columns::over_time`]).
    pub columns: &'a Columns,
    /// The time of each row.
    pub steps: &'a Steps,
    /// The output format.
    pub format: RowFormat,
}

impl LeadSweep<'_> {
    /// Solves and writes all rows; calls `watch` regularly with their number. A row that the inputs
    /// cannot reach has no values.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write(&self, to: impl Write, watch: &mut dyn FnMut(u64)) -> io::Result<SweepOutcome> {
        let table = self.columns.table(self.format);
        let head = table.head(&self.scene.name, "rows", self.columns.units);
        let mut rows = RowWriter::new(table, &head, to)?;
        let (_, order) = demand(&self.columns.quantities);
        let mut outcome = SweepOutcome::default();
        let mut leader = self.leader.clone();
        for time in self.steps.iter() {
            outcome.rows += 1;
            let mut cells = vec![None; self.columns.quantities.len()];
            let mut condition = Condition::NoAssembly;
            if let Some(pose) = leader.follow(&self.lead.path, time, order) {
                condition = pose.condition;
                let state = leader.state();
                cells = self
                    .columns
                    .quantities
                    .iter()
                    .map(|q| q.value(state))
                    .collect();
                outcome.valued += u64::from(condition != Condition::NoAssembly);
                outcome.note_singular(pose.singularity);
            }
            if let Some(first) = cells.first_mut() {
                *first = Some(time);
            }
            rows.state_row(&cells, condition)?;
            if outcome.rows % REPORTED == 0 {
                watch(outcome.rows);
            }
        }
        rows.finish()?;
        Ok(outcome)
    }
}

impl SweepOutcome {
    /// Counts the present row if it is singular.
    pub(super) fn note_singular(&mut self, singularity: Option<LeadSingularity>) {
        let Some(singularity) = singularity else {
            return;
        };
        self.singular += 1;
        if self.first_singular.len() < LISTED {
            self.first_singular.push((self.rows, singularity));
        }
    }

    /// Describes the singular rows; `None` if there are none.
    #[must_use]
    pub fn singular_text(&self, scene: &Scene, solver: &Solver) -> Option<String> {
        let rows = self.first_singular.iter();
        let texts = rows.map(|(row, singularity)| {
            words().singular_row(*row, &singularity_text(scene, solver, singularity))
        });
        let mut list = texts.collect::<Vec<String>>().join("; ");
        let unlisted = self.singular - self.first_singular.len() as u64;
        if unlisted > 0 {
            list = words().some_and_more(&list, usize::try_from(unlisted).unwrap_or(usize::MAX));
        }
        (self.singular > 0).then(|| words().rows_are_singular(self.singular, self.rows, &list))
    }
}

/// Describes a singular position with the names of its inputs or its group.
#[must_use]
pub fn singularity_text(scene: &Scene, solver: &Solver, singularity: &LeadSingularity) -> String {
    match singularity {
        LeadSingularity::Serial(inputs) => {
            let all: Vec<&str> = (scene.mechanism.inputs())
                .map(|input| scene.input_name(input))
                .collect();
            let names = inputs.iter().filter_map(|&index| all.get(index).copied());
            words().edge_of_workspace(&names.collect::<Vec<_>>().join(", "))
        }
        LeadSingularity::Parallel(group) => {
            let group = solver.plan().group(*group);
            words().parallel_singularity(group.map_or("", |group| scene.group_name(group)))
        }
    }
}
