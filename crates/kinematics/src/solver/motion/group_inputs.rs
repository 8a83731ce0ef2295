//! The inputs of a coupled group at coordinates close to a crossing.

use super::tracking::Walker;
use crate::arithmetic::Series;
use crate::solver::Order;
use crate::solver::exact::Exact;
use crate::solver::state::{Condition, LinkState, PointState, State};
use crate::solver::workspace::Workspace;
use crate::{Double, Vec2};

/// The source of a coupled group's inputs.
#[derive(Clone, Copy)]
pub(super) enum GroupInputs<'a> {
    /// The steps before the group.
    Steps,
    /// Series of the steps about a coordinate at which one of them is singular and has no rates.
    Series {
        about: Double,
        series: &'a State<Series>,
    },
}

impl Walker<'_> {
    /// Writes the inputs of a step at a coordinate into the state. Returns `false` if they do not
    /// exist.
    pub(super) fn place_inputs(&mut self, step: usize, at: f64, inputs: GroupInputs<'_>) -> bool {
        let engine = self.engine;
        match inputs {
            GroupInputs::Steps => {
                let order = Order::Acceleration;
                engine.run_steps(0..step, at, order, &mut self.state) != Condition::NoAssembly
            }
            GroupInputs::Series { about, series } => {
                let by = Double::exactly(engine.difference(about.hi, at));
                let State { points, links, .. } = &mut self.state.state;
                for (point, series) in points.iter_mut().zip(&series.points) {
                    let PointState { p, v, a } = point_at(series, by);
                    let [p, v, a] = [p, v, a].map(Vec2::nearest);
                    *point = PointState { v, p, a };
                }
                for (link, series) in links.iter_mut().zip(&series.links) {
                    let LinkState { d, w, a } = link_at(series, by);
                    *link = LinkState {
                        d: d.nearest(),
                        w: w.hi,
                        a: a.hi,
                    };
                }
                true
            }
        }
    }

    /// Writes the inputs of a step at a coordinate into a workspace in double-double. Returns `false`
    /// if they do not exist.
    pub(super) fn place_inputs_exactly(
        &self,
        exact: &Exact,
        (step, at): (usize, Double),
        inputs: GroupInputs<'_>,
        twice: &mut Workspace<Double>,
    ) -> bool {
        match inputs {
            GroupInputs::Steps => exact.run_twice(step, at, &self.state, twice),
            GroupInputs::Series { about, series } => {
                let by = self.distance_exactly(about, at);
                let State { points, links, .. } = &mut twice.state;
                for (point, series) in points.iter_mut().zip(&series.points) {
                    *point = point_at(series, by);
                }
                for (link, series) in links.iter_mut().zip(&series.links) {
                    *link = link_at(series, by);
                }
                true
            }
        }
    }
}

/// Returns a point of a series at a distance from its coordinate.
fn point_at(series: &PointState<Series>, by: Double) -> PointState<Double> {
    let [p, v, a] = derivatives(series.p, by);
    PointState { v, p, a }
}

/// Returns a link of a series at a distance from its coordinate. Uses d' = w k x d.
fn link_at(series: &LinkState<Series>, by: Double) -> LinkState<Double> {
    let [d, first, second] = derivatives(series.d, by);
    LinkState {
        d,
        w: d.cross(first),
        a: d.cross(second),
    }
}

/// Returns the value of a series and its first two derivatives.
fn derivatives(series: Vec2<Series>, by: Double) -> [Vec2<Double>; 3] {
    let first = series.map(Series::derivative);
    let second = first.map(Series::derivative);
    [series, first, second].map(|series| series.map(|s| s.value(by)))
}
