//! Bounds near an end of the motion, where the formulas in doubles say nothing: those of the same steps
//! in twice the digits, from the numbers that are meant.

use super::Errors;
use super::errors::{LinkError, PointError};
use crate::arithmetic::Sharp;
use crate::solver::demand::PlacedPart;
use crate::solver::state::{Condition, State};
use crate::solver::{Order, Solver, Workspace};
use crate::{Ball, Double};

impl Solver {
    /// Runs the steps of a mechanism of dyads in twice the digits; whether that proves where they are.
    #[cold]
    pub(super) fn look_at_edge(
        &self,
        order: Order,
        state: &State,
        work: &mut Workspace<Ball>,
    ) -> bool {
        let is_dyads = self.engine.program.coupled.is_empty();
        // At a dead point there is nothing to prove rates by, and near a change point a series tells.
        if !is_dyads || state.condition != Condition::Ok || self.is_passing(state.at) {
            return false;
        }
        let asked = work.errors.asked::<false>(state.at, false).most();
        let (Some(exact), Some(edge)) = (&self.exact, &mut work.errors.edge) else {
            return false;
        };
        let at = Sharp::new(Double::exactly(state.at), asked);
        let how = (&state.signs[..], None);
        // What coordinates were rounded by is in the bounds of doubles alone.
        exact.tells(exact.closed) && exact.run(exact.closed, at, order, how, edge) == Condition::Ok
    }
}

impl Errors {
    /// What was found in twice the digits. Its influence on what stands on it is in what was found there.
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
                self.put_point(point, &error, state, enclosure);
            }
            PlacedPart::Link(link) => {
                let i = link.index();
                let error = LinkError::of_sharp(&edge.links[i], &state.links[i]);
                self.put_link(link, &error, state, enclosure);
            }
            PlacedPart::Slide(_) => {}
        }
    }
}
