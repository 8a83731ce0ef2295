//! Passes crossings of a coupled group at which several of its loops are in line at once.
//!
//! No single null vector tells the branches apart there. But every branch is analytic: its series about a
//! regular place before the crossing also holds beyond it. From one coefficient to the next, a rounding
//! error grows by up to the inverse of the distance. At the same distance beyond the crossing, the n-th
//! coefficient then contributes 2^n roundings of double-double. The residuals of the series decide
//! whether the branches really cross.

use super::coupled_pair::CoupledPair;
use super::pair::bound;
use super::{Junction, Refusal, SingularGroup};
use crate::Double;
use crate::arithmetic::Series;
use crate::numeric::root;
use crate::solver::elements::SingularShift;
use crate::solver::motion::crossing::MAX_END_DISTANCE;
use crate::solver::motion::tracking::Walker;
use crate::solver::state::State;

/// Distances before a limit, in radians or scaled lengths, of the regular places.
const BEFORE: [f64; 8] = [0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5];
/// Number of terms about the regular place.
const ABOUT_REGULAR: usize = 28;
/// Number of terms about the crossing. The others only serve to compute these.
const KEPT: usize = 16;
/// Maximum distance from the crossing at which the terms hold, relative to that of the regular place. Up to
/// there, the growth of rounding errors is compensated.
const HELD: f64 = 0.125;
/// Range of the ratio of singularities at half the distance from a crossing and at all of it. It is 0.7 before
/// a fold.
const PROPORTIONAL: std::ops::Range<f64> = 0.35..0.62;
/// Maximum measure at a singular place, relative to that at the regular one.
const SINGULAR: f64 = 1e-12;

impl Walker<'_> {
    /// Crosses a limit at which several loops of a coupled group may be in line at once. Returns the
    /// coordinate reached beyond it.
    pub(in crate::solver::motion) fn cross_by_continuation(&mut self, limit: f64) -> Option<f64> {
        let engine = self.engine;
        let (anchors, saved) = (self.anchors.clone(), self.state.clone());
        for (step, _) in engine.coupled_steps() {
            for by in BEFORE {
                let before = engine.moved(limit, -self.sense * by);
                self.anchors.forget_beyond(engine, before, self.sense);
                let junction = (self.leads_to_crossing(step, (limit, by))
                    && self.store_approach(limit, before))
                .then(|| self.continuation(step, (before, by)).ok())
                .flatten();
                let causes_end = |junction: &Junction| {
                    engine.difference(limit, junction.at.hi).abs() <= MAX_END_DISTANCE
                };
                let passed = junction
                    .filter(causes_end)
                    .and_then(|junction| self.pass_through(&junction));
                if passed.is_some() {
                    return passed;
                }
                self.anchors.clone_from(&anchors);
                self.state.clone_from(&saved);
            }
        }
        None
    }

    /// Returns `true` if a coupled group becomes singular in proportion to the distance from a limit, from
    /// `by` before it on. Before a fold, it is in proportion to the root.
    fn leads_to_crossing(&mut self, step: usize, (limit, by): (f64, f64)) -> bool {
        let engine = self.engine;
        let Some(index) = engine.program.steps[step].coupled() else {
            return false;
        };
        let mut singularity = |by: f64| {
            let at = engine.moved(limit, -self.sense * by);
            let (q, _) = engine.coordinate(at);
            let group = &engine.program.coupled[index];
            self.step_to(at)
                .then(|| group.distance_and_measure(q, &mut self.state).0)
        };
        let (Some(far), Some(near)) = (singularity(by), singularity(0.5 * by)) else {
            return false;
        };
        PROPORTIONAL.contains(&(near / far))
    }

    /// Expands the mechanism about a crossing of a coupled group, which lies about `by` ahead of the
    /// coordinate `before` of the state.
    fn continuation(&mut self, step: usize, (before, by): (f64, f64)) -> Result<Junction, Refusal> {
        let exact = self.exact.ok_or(Refusal::End)?;
        let index = exact.engine.program.steps[step].coupled();
        let group = &exact.engine.program.coupled[index.ok_or(Refusal::End)?];
        let near = Double::exactly(before);
        let (q, direction) = self.coordinate_of(near, ABOUT_REGULAR);
        let mut series = exact.engine.state::<Series>(self.state.travels.len());
        self.place_in_series(0..step + 1, before, q, direction, &mut series)
            .ok_or(Refusal::End)?;
        let beyond = 2.0 * self.sense * by;
        let (away, turns) = self
            .singular_place(step, (near, beyond), &series)
            .ok_or(Refusal::End)?;
        for point in &mut series.state.points {
            point.p = point.p.map(|s| s.shifted(away).cut(KEPT));
        }
        for link in &mut series.state.links {
            link.d = link.d.map(|s| s.shifted(away).cut(KEPT));
        }
        let at = self.moved_exactly(near, away);
        let coordinate = self.coordinate_of(at, KEPT);
        let within = HELD * away.abs().hi;
        let misfit = group.misfit(coordinate.0, &mut series).iter();
        let misfit = misfit.map(|r| bound(&r.c[..r.known], within));
        let largest = misfit.fold(0.0, f64::max);
        // Negated so that NaN is rejected.
        if !(largest <= self.opening_slack(step)) {
            return Err(Refusal::End);
        }
        let mut junction = Junction {
            pair: Some(CoupledPair::apart(step, within)),
            ..Junction::about(at, series, &self.state.signs)
        };
        let of = (step, group.group);
        let order = if turns { 2 } else { 4 };
        let fold = SingularGroup::tolerances_at(of, SingularShift::default(), order);
        junction.fold(fold, self.sense);
        let steps = step + 1..exact.engine.program.steps.len();
        self.expand(steps, coordinate, &[], &mut junction)?;
        junction.with_enough_terms(KEPT)
    }

    /// Returns the distance from a regular place to one up to `beyond` ahead at which a coupled group is
    /// singular, and whether the sign of its determinant changes there. `series` holds the motion about
    /// the regular place.
    fn singular_place(
        &mut self,
        step: usize,
        (near, beyond): (Double, f64),
        series: &State<Series>,
    ) -> Option<(Double, bool)> {
        let engine = self.engine;
        let group = &engine.program.coupled[engine.program.steps[step].coupled()?];
        let mut here = |away: f64| {
            let (q, _) = engine.coordinate(engine.moved(near.hi, away));
            self.take_places(series, Double::exactly(away));
            group.distance_and_measure(q, &mut self.state)
        };
        let first = here(0.0);
        let ends = ((0.0, first.0), (beyond, here(beyond).0));
        let away = root(ends.0, ends.1, 0.0, |away| Some(here(away).0)).ok()?;
        // The function also changes its sign at a pole.
        let is_singular = here(away).1.abs() <= SINGULAR * first.1.abs();
        let turns = first.1 * here(2.0 * away).1 < 0.0;
        is_singular.then_some((Double::exactly(away), turns))
    }
}
