//! Places steps in series about a coordinate, one after another.

use super::Junction;
use crate::arithmetic::Series;
use crate::solver::Order;
use crate::solver::conditioning::condition;
use crate::solver::coupled::Branch;
use crate::solver::elements::{POSITION, SingularShift, StepOutcome, root};
use crate::solver::motion::change::Change;
use crate::solver::motion::tracking::{MAX_SINGULAR_CONDITION, Walker};
use crate::solver::state::State;
use crate::solver::workspace::Workspace;
use crate::{Double, Number, Vec2};

impl Walker<'_> {
    /// Returns the driver's coordinate and its direction as series about `at`, with the given
    /// number of terms.
    pub(super) fn coordinate_of(&self, at: Double, terms: usize) -> (Series, Vec2<Series>) {
        let engine = self.engine;
        let place = if engine.is_rotary {
            Series::angle(at)
        } else {
            Series::line(at, Double::exactly(engine.frame.scale))
        };
        let (q, direction) = engine.coordinate(place.cut(terms));
        // Where no equation reads the coordinate, it is a constant of all terms.
        (q.cut(terms), direction)
    }

    /// Places steps in series, with the signs of the state. Returns `None` if one is singular or
    /// open.
    pub(super) fn place_in_series(
        &mut self,
        steps: std::ops::Range<usize>,
        at: f64,
        q: Series,
        direction: Vec2<Series>,
        series: &mut Workspace<Series>,
    ) -> Option<()> {
        let engine = &self.exact?.engine;
        for i in steps {
            let step = &engine.program.steps[i];
            let done = if let Some(dyad) = step.dyad() {
                let plain = SingularShift::default();
                let square = dyad.square(q, plain, series);
                let is_open = !(square.nearest() > 0.0);
                let height = root(square, 0, self.state.signs[dyad.group()]);
                dyad.run_through(q, plain, height, &mut series.state);
                !is_open
            } else if step.coupled().is_some() {
                self.follow(i, at, q, None, series)
            } else {
                step.run::<Series, POSITION>(q, direction, &mut series.state) == StepOutcome::Done
            };
            if !done {
                return None;
            }
        }
        Some(())
    }

    /// Returns the driver's coordinate at a distance `by` from another, in radians or scaled
    /// lengths.
    pub(in crate::solver::motion) fn moved_exactly(&self, from: Double, by: Double) -> Double {
        let unit = if self.engine.is_rotary {
            Double::DEGREES
        } else {
            Double::exactly(self.engine.frame.scale)
        };
        from + by * unit
    }

    /// Returns the distance between two coordinates, in radians or scaled lengths.
    pub(in crate::solver::motion) fn distance_exactly(&self, from: Double, to: Double) -> Double {
        let unit = if self.engine.is_rotary {
            Double::RADIAN
        } else {
            Double::exactly(1.0 / self.engine.frame.scale)
        };
        (to - from) * unit
    }

    /// Returns `true` if a coupled group is singular at a junction, within the rounding of doubles.
    pub(super) fn is_singular_at(&mut self, junction: &Junction, step: usize) -> bool {
        let engine = self.engine;
        let Some(index) = engine.program.steps[step].coupled() else {
            return false;
        };
        self.take_places(&junction.series, Double::ZERO);
        self.take_series(junction, step, 0.0);
        let (q, _) = engine.coordinate(junction.at.hi);
        let Workspace { state, scratch, .. } = &mut self.state;
        let condition = condition(&engine.program.coupled[index], q, state, scratch);
        condition.is_none_or(|condition| condition < MAX_SINGULAR_CONDITION)
    }

    /// Places a coupled group in series, along the branch of `crossing` if given. Returns `false`
    /// if it cannot be followed.
    pub(super) fn follow(
        &mut self,
        step: usize,
        at: f64,
        q: Series,
        crossing: Option<&Change>,
        series: &mut Workspace<Series>,
    ) -> bool {
        let engine = self.engine;
        let (Some(index), Some(exact)) = (engine.program.steps[step].coupled(), self.exact) else {
            return false;
        };
        let group = &exact.engine.program.coupled[index];
        // The group's inputs are also read in doubles.
        self.predict_nearest(at);
        self.take_places(series, Double::ZERO);
        let branch = crossing.map(|Change { z, rate, .. }| Branch { z, rate });
        if branch.is_none() {
            let _ = engine.run_steps(step..step + 1, at, Order::Position, &mut self.state);
        }
        group.follow(q, &mut self.state, branch.as_ref(), series)
    }

    /// Copies the series at a distance from their centre, as positions and directions, to the state in
    /// doubles.
    pub(super) fn take_places(&mut self, series: &State<Series>, by: Double) {
        let here = &mut self.state.state;
        for (point, from) in here.points.iter_mut().zip(&series.points) {
            point.p = from.p.map(|s| s.value(by).hi);
        }
        for (link, from) in here.links.iter_mut().zip(&series.links) {
            link.d = from.d.map(|s| s.value(by).hi);
        }
    }
}
