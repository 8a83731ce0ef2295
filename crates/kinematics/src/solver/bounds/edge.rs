//! Bounds states near an end of the motion, where formulas in doubles fail, by running the steps in
//! double-double with typed decimals.

use super::Errors;
use super::errors::{LinkError, PointError};
use crate::arithmetic::Sharp;
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{Condition, State};
use crate::solver::{Order, Solver, Workspace};
use crate::{Ball, Double};

impl Solver {
    /// Runs the steps of a mechanism of dyads in double-double. Returns `true` if that proves their
    /// results.
    #[cold]
    pub(super) fn solve_edge_closely(
        &self,
        order: Order,
        state: &State,
        workspace: &mut Workspace<Ball>,
    ) -> bool {
        let is_dyads = self.engine.program.coupled.is_empty();
        // Rates at a dead point cannot be proved, and near a change point a series is used.
        if !is_dyads || state.condition != Condition::Ok || self.is_passing(state.at) {
            return false;
        }
        let requested = workspace
            .errors
            .intended::<false>(state.at, false)
            .max_distance();
        let (Some(exact), Some(edge)) = (&self.exact, &mut workspace.errors.edge) else {
            return false;
        };
        let at = Sharp::new(Double::exactly(state.at), requested);
        let how = (&state.signs[..], None);
        // Only the bounds of doubles include the rounding of coordinates.
        exact.decides_more(exact.closed)
            && exact.run(exact.closed, at, order, how, edge) == Condition::Ok
    }
}

impl Errors {
    /// Stores the double-double results. They already contain their influence on later parts.
    pub(super) fn take_edge(
        &mut self,
        part: PlacedPart,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let Some(edge) = &self.edge else {
            return;
        };
        match part {
            PlacedPart::Point(point) => {
                let i = point.index();
                let error = PointError::of_sharp(&edge.points[i], &state.points[i]);
                self.store_point(point, &error, state, enclosure);
            }
            PlacedPart::Link(link) => {
                let i = link.index();
                let error = LinkError::of_sharp(&edge.links[i], &state.links[i]);
                self.store_link(link, &error, state, enclosure);
            }
            PlacedPart::Slide(_) => {}
        }
    }
}
