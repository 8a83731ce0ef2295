//! Computes the ends of a range in double-double from the typed decimals, each with an error bound.
//!
//! A function of the driver's coordinate changes its sign where a dyad reaches its limit, or where
//! a coordinate reaches its stop. The bound is the smallest distance at which the signs on both
//! sides of the end are proved to differ. The fold of a coupled group is bounded by its own
//! equations.

use super::tracking::Walker;
use crate::arithmetic::{Sharp, half_ulp};
use crate::numeric::root;
use crate::solver::Order;
use crate::solver::coupled::{Correction, ExactFold, Fold, FoldResiduals};
use crate::solver::engine::Engine;
use crate::solver::exact::proved_run::ProvedRun;
use crate::solver::state::Condition;
use crate::solver::workspace::Workspace;
use crate::{Ball, Double};

/// Number of doublings of half an ulp within which the signs on both sides of an end are compared.
const DOUBLINGS: i32 = 64;
/// Distance, in half ulps, of the values that give the slope of a function at its root.
const NEAR: f64 = 16.0;
/// Maximum number of corrections of a fold. Each gains about the digits of a double.
const CORRECTIONS: usize = 12;
/// Size of a correction that ends the iteration, in units of about the longest link.
const MAX_LAST_CORRECTION: f64 = 1e-27;

/// An end of the range with an error bound.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct BoundedEnd {
    /// The driver's coordinate.
    pub(in crate::solver) at: f64,
    /// The maximum error of the coordinate; `None` if it is not proved.
    pub(in crate::solver) bound: Option<f64>,
}

impl BoundedEnd {
    /// Creates an end that is exact by definition.
    pub(super) fn exact(at: f64) -> BoundedEnd {
        BoundedEnd {
            at,
            bound: Some(0.0),
        }
    }

    /// Creates an end known in doubles only, without a bound.
    pub(super) fn unproved(at: f64) -> BoundedEnd {
        BoundedEnd { at, bound: None }
    }

    /// Rounds `place`, whose own error is at most `off`, to the nearest double, or to zero if its
    /// enclosure contains zero.
    fn nearest(place: Double, off: Option<f64>) -> BoundedEnd {
        let is_zero = off.is_some_and(|off| place.hi.abs() <= off);
        let at = if is_zero { 0.0 } else { place.hi };
        let rest = (place - Double::exactly(at)).abs().hi;
        BoundedEnd {
            at,
            bound: off.map(|off| (off + rest).next_up()),
        }
    }
}

/// A quantity that is zero at the end of a dyad's reach.
#[derive(Clone, Copy)]
enum EndQuantity {
    /// The dyad's measure.
    Measure,
    /// The dyad's rate of stretch, for a dyad that only touches its limit, times this sign.
    StretchRate(f64),
}

impl Walker<'_> {
    /// Returns the coordinate near a limit where a dyad reaches the end of its reach, with its
    /// error bound.
    pub(super) fn exact_reach(
        &mut self,
        step: usize,
        group: usize,
        limit: f64,
    ) -> Option<BoundedEnd> {
        let all = [
            EndQuantity::Measure,
            EndQuantity::StretchRate(1.0),
            EndQuantity::StretchRate(-1.0),
        ];
        let exact = self.exact?;
        let mut run = ProvedRun::new(exact, self.state.travels.len());
        all.into_iter().find_map(|vanishing| {
            let at = self.zero_near(&mut run, (step, group), vanishing, limit)?;
            let bound = self.reach_bound(&mut run, (step, group), vanishing, at);
            Some(BoundedEnd { at, bound })
        })
    }

    /// Bounds the error of the end of a dyad's reach.
    pub(super) fn bound_of_reach(&mut self, step: usize, group: usize, at: f64) -> Option<f64> {
        let exact = self.exact?;
        let mut run = ProvedRun::new(exact, self.state.travels.len());
        let all = [EndQuantity::Measure, EndQuantity::StretchRate(1.0)];
        all.into_iter()
            .find_map(|vanishing| self.reach_bound(&mut run, (step, group), vanishing, at))
    }

    /// Returns the smallest distance from `at` at which the quantity's signs are proved to differ.
    fn reach_bound(
        &mut self,
        run: &mut ProvedRun<'_>,
        of: (usize, usize),
        vanishing: EndQuantity,
        at: f64,
    ) -> Option<f64> {
        let engine = self.engine;
        sign_change(engine, at, |place| {
            self.vanishing(run, of, vanishing, place)
        })
    }

    /// Returns a zero of a quantity near a limit. The quantity is positive on the inner side.
    fn zero_near(
        &mut self,
        run: &mut ProvedRun<'_>,
        of: (usize, usize),
        vanishing: EndQuantity,
        limit: f64,
    ) -> Option<f64> {
        let sense = self.sense;
        let mut back = self.distances(limit).map(|by| limit - sense * by);
        let mut on = self.distances(limit).map(|by| limit + sense * by);
        let finest = self.engine.finest();
        let mut value = |at: f64| {
            let place = Sharp::new(Double::exactly(at), 0.0);
            self.vanishing(run, of, vanishing, place)
        };
        let inside = back.find_map(|at| {
            let here = value(at)?;
            (here.mid.hi > here.radius).then_some((at, here.mid.hi))
        })?;
        let outside = on.find_map(|at| {
            let here = value(at)?;
            (-here.mid.hi > here.radius).then_some((at, here.mid.hi))
        })?;
        let at = root(inside, outside, 0.0, |at| Some(value(at)?.mid.hi)).ok()?;
        // One Newton step removes the remaining error of the root, which is some ulps.
        let by = NEAR * half_ulp(at).max(f64::EPSILON * finest);
        let [before, here, beyond] = [-by, 0.0, by].map(|by| Some(value(at + by)?.mid.hi));
        let correction = -2.0 * by * here? / (beyond? - before?);
        let at = match correction.abs() <= by {
            true => at + correction,
            false => at,
        };
        let is_zero = at.abs() < f64::EPSILON * finest;
        Some(if is_zero { 0.0 } else { at })
    }

    /// Evaluates the quantity at a coordinate; `None` if the dyad's inputs cannot be assembled.
    fn vanishing(
        &mut self,
        run: &mut ProvedRun<'_>,
        (step, group): (usize, usize),
        vanishing: EndQuantity,
        place: Sharp,
    ) -> Option<Sharp> {
        let has_rates = matches!(vanishing, EndQuantity::StretchRate(_));
        if !self.run_inputs(run, step, place, has_rates) {
            return None;
        }
        match vanishing {
            EndQuantity::Measure => Some(run.measure(step, group, place)),
            EndQuantity::StretchRate(sign) => {
                let dyad = run.engine.program.steps[step].dyad()?;
                let rate = dyad.stretch_rate(&run.sharp.state)?;
                Some(rate * Sharp::new(Double::exactly(sign), 0.0))
            }
        }
    }

    /// Runs the steps before a step. Coupled groups start from their states in doubles. Returns
    /// `false` if a step cannot be assembled.
    fn run_inputs(
        &mut self,
        run: &mut ProvedRun<'_>,
        step: usize,
        place: Sharp,
        has_rates: bool,
    ) -> bool {
        if self.exact.is_some_and(|exact| step > exact.closed) {
            let at = place.mid.hi;
            self.predict_nearest(at);
            let order = if has_rates {
                Order::Acceleration
            } else {
                Order::Position
            };
            // Far from the origin, the typed decimals have other solutions than the nearby doubles.
            let found = run.engine.run_steps(0..step, at, order, &mut self.state);
            if found == Condition::NoAssembly {
                return false;
            }
        }
        run.run(step, place, has_rates, &self.state)
    }

    /// Corrects the fold of a coupled group. Returns its coordinate with an error bound, and the
    /// unknowns of the group there.
    pub(in crate::solver::motion) fn exact_fold(
        &mut self,
        of: (usize, usize),
        fold: Fold,
        at: f64,
    ) -> Option<(BoundedEnd, Vec<f64>)> {
        let exact = self.exact?;
        let group = exact.engine.program.coupled.get(of.1)?;
        let mut run = ProvedRun::new(exact, self.state.travels.len());
        let mut fold = group.exact_fold(fold, &mut self.state.scratch);
        let mut place = Double::exactly(at);
        let mut last = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let residuals = self.fold_residuals(&mut run, of, &fold, place)?;
            let Correction { size, dq } = group.correct_fold(&mut fold, &residuals);
            place = self.moved_exactly(place, Double::exactly(dq));
            // This form of the condition also stops at NaN.
            if !(size < 0.5 * last && size > MAX_LAST_CORRECTION) {
                break;
            }
            last = size;
        }
        let bound = self.fold_bound(&mut run, of, &fold, place);
        let bound = bound.map(|bound| self.engine.moved(0.0, bound));
        let is_known = place.hi.is_finite() && last < f64::INFINITY;
        is_known.then(|| (BoundedEnd::nearest(place, bound), fold.unknowns()))
    }

    /// Returns the residuals of a fold's equations at a coordinate, in double-double.
    fn fold_residuals(
        &mut self,
        run: &mut ProvedRun<'_>,
        (step, index): (usize, usize),
        fold: &ExactFold,
        place: Double,
    ) -> Option<FoldResiduals> {
        let place = Sharp::new(place, 0.0);
        if !self.run_inputs(run, step, place, true) {
            return None;
        }
        let engine = run.engine;
        let (q, _) = engine.coordinate(place);
        let Workspace { state, scratch, .. } = &mut run.sharp;
        engine.program.coupled[index].fold_residuals(fold, q, state, scratch)
    }

    /// Bounds the error of a fold's coordinate, in radians or scaled lengths.
    fn fold_bound(
        &mut self,
        run: &mut ProvedRun<'_>,
        (step, index): (usize, usize),
        fold: &ExactFold,
        place: Double,
    ) -> Option<f64> {
        let residuals = self.fold_residuals(run, (step, index), fold, place)?;
        let place = Sharp::new(place, self.engine.moved(0.0, residuals.radius()));
        if !self.run_inputs(run, step, place, true) {
            return None;
        }
        let engine = run.engine;
        let (q, _) = engine.coordinate(place);
        let Workspace { state, scratch, .. } = &mut run.balls;
        engine.program.coupled[index].fold_bound(fold, &residuals, Ball::from(q), state, scratch)
    }
}

/// Returns the smallest distance on both sides of a coordinate at which the signs of a function are
/// proved to differ.
pub(in crate::solver) fn sign_change(
    engine: &Engine,
    at: f64,
    mut f: impl FnMut(Sharp) -> Option<Sharp>,
) -> Option<f64> {
    let minimum = half_ulp(at).max(f64::EPSILON * f64::EPSILON * engine.finest());
    let mut distances = (0..DOUBLINGS).map(|k| minimum * f64::from(k).exp2());
    distances.find(|&by| {
        let mut sign = |by: f64| {
            let value = f(Sharp::new(Double::sum(at, by), 0.0))?;
            (value.mid.hi.abs() > value.radius).then_some(value.mid.hi.signum())
        };
        sign(-by).zip(sign(by)).is_some_and(|(a, b)| a != b)
    })
}
