//! Passes two crossings of a coupled group close to each other, between which its input reverses.
//!
//! The opening of the group's equations has a double zero at each crossing and an extreme at the
//! reversal between them, like the square of a dyad's height (see [`super::pair`]). One series about
//! the reversal represents the motion through both (see [`crate::solver::coupled`]).

use super::pair::{SPREAD, paired_opening};
use super::{Junction, MORE, Missed, Refusal, SingularGroup};
use crate::Double;
use crate::arithmetic::{Series, TERMS};
use crate::solver::Order;
use crate::solver::coupled::{Opening, OpeningSeries};
use crate::solver::elements::SingularShift;
use crate::solver::motion::tracking::Walker;
use crate::solver::state::{Condition, State};
use crate::solver::workspace::Workspace;
use std::f64::consts::TAU;

/// Distances before a reversal, in radians or scaled lengths, from which both crossings are passed.
const BEFORE: [f64; 5] = [0.07, 0.03, 0.01, 3e-3, 1e-3];
/// Number of terms with which both crossings are searched.
const FEW_TERMS: usize = 14;
/// Maximum number of moves of the centre.
const MOVES: usize = 5;
/// Maximum distance of the centre from the reversal, relative to the distance of the crossings.
const CENTRED: f64 = 1e-3;
/// Maximum distance of the centre from the limit at which a pair is searched.
const HERE: f64 = 2.0 * SPREAD;
/// Maximum difference between series and motion, relative to the distance of the other branch.
const OTHER: f64 = 0.1;
/// Half the minimum displacement between branches, relative to the distance from their crossing.
const MIN_HEIGHT: f64 = 5e-3;

/// Two crossings of a coupled group close to each other.
struct ChangePair {
    /// The group's step.
    step: usize,
    /// The coordinate of the reversal, the centre of the series.
    centre: Double,
    /// The maximum distance of the crossings from the centre.
    spread: f64,
    /// The coordinates of both crossings, in increasing order; none if the branches miss each other.
    places: Vec<f64>,
    opening: Opening,
}

/// The branch of a coupled group that passes two close crossings, or one at which several loops are in line.
pub(in crate::solver::motion) struct CoupledPair {
    pub(super) step: usize,
    /// Half the displacement between the branches, or less.
    height: Series,
    /// The maximum distance from the centre at which the series holds.
    pub(super) within: f64,
}

impl CoupledPair {
    /// Creates the branch of a group that passes one crossing. The other branches are about as far away as
    /// the crossing.
    pub(super) fn apart(step: usize, within: f64) -> CoupledPair {
        let height = Series::line(Double::ZERO, Double::exactly(MIN_HEIGHT));
        CoupledPair {
            step,
            height,
            within,
        }
    }

    /// Returns the maximum difference of a state on this branch at a distance from the centre.
    fn tolerance(&self, by: f64) -> f64 {
        OTHER * 2.0 * self.height.value(Double::exactly(by)).abs().hi
    }
}

impl Walker<'_> {
    /// Crosses two change points of a coupled group close to a limit. Returns the coordinate reached beyond
    /// both.
    ///
    /// After the first of them alone, the group moves so little up to the second one that doubles do not
    /// follow it.
    pub(in crate::solver::motion) fn cross_twice(&mut self, limit: f64) -> Option<f64> {
        let engine = self.engine;
        let (anchors, saved) = (self.anchors.clone(), self.state.clone());
        for (step, _) in engine.coupled_steps() {
            self.predict_nearest(limit);
            let pair = self.change_pair(step, limit);
            self.state.clone_from(&saved);
            let Some(pair) = pair.filter(|pair| !self.starts_within(pair)) else {
                continue;
            };
            for by in BEFORE {
                let passed = self.cross_pair(&pair, by);
                if passed.is_some() {
                    return passed;
                }
                self.anchors.clone_from(&anchors);
                self.state.clone_from(&saved);
            }
            let passed = self.cross_both(&pair);
            if passed.is_some() {
                return passed;
            }
            self.anchors.clone_from(&anchors);
            self.state.clone_from(&saved);
        }
        None
    }

    /// Crosses both change points of a pair one after the other, where no series holds about both. A walk
    /// from the first one could step over the second.
    fn cross_both(&mut self, pair: &ChangePair) -> Option<f64> {
        let &[low, high] = &pair.places[..] else {
            return None;
        };
        let [first, second] = if self.sense > 0.0 {
            [low, high]
        } else {
            [high, low]
        };
        let known = self.crossings.len();
        let walked = (
            self.samples.len(),
            self.seen.clone(),
            self.misses.clone(),
            self.peaks.clone(),
        );
        let reached = self.cross(first)?;
        let is_between = (second - reached) * self.sense > 0.0;
        let passed = is_between.then(|| self.cross(second)).flatten();
        if passed.is_none() {
            self.crossings.truncate(known);
            self.samples.truncate(walked.0);
            (_, self.seen, self.misses, self.peaks) = walked;
        }
        passed
    }

    /// Returns `true` if the motion starts between both crossings of a pair, or whole turns away. One of
    /// them then lies behind the start, and a turn closes between them.
    fn starts_within(&self, pair: &ChangePair) -> bool {
        let away = self.engine.difference(pair.centre.hi, self.start);
        let away = match self.engine.is_rotary {
            true => away - (away / TAU).round() * TAU,
            false => away,
        };
        away.abs() < pair.spread
    }

    /// Returns `true` if a coupled group has two change points, or almost, close to a coordinate.
    pub(in crate::solver::motion) fn has_pair(&mut self, step: usize, at: f64) -> bool {
        self.predict_nearest(at);
        self.change_pair(step, at).is_some()
    }

    /// Crosses both change points of a pair, beginning at a distance `by` before the reversal.
    fn cross_pair(&mut self, pair: &ChangePair, by: f64) -> Option<f64> {
        let engine = self.engine;
        let before = engine.moved(pair.centre.hi, -self.sense * by);
        self.anchors.forget_beyond(engine, before, self.sense);
        if !self.store_approach(pair.centre.hi, before) {
            return None;
        }
        let junction = self.junction_of_pair(pair)?;
        self.pass_through(&junction)
    }

    /// Returns the two crossings of a coupled group close to a limit, from the z in the scratch.
    fn change_pair(&mut self, step: usize, limit: f64) -> Option<ChangePair> {
        let slack = self.opening_slack(step);
        let mut centre = Double::exactly(limit);
        for _ in 0..MOVES {
            let opening = self.opening(step, centre.hi)?;
            let (found, _) = self.opening_series(step, centre, &opening, FEW_TERMS)?;
            let mut paired = paired_opening(found.by, slack);
            if paired.is_none() && mean_of_extremes(found.by)?.abs().hi <= CENTRED * SPREAD {
                // Directly between two crossings, few terms may miss their heights by more than the slack.
                let (found, _) = self.opening_series(step, centre, &opening, TERMS)?;
                paired = paired_opening(found.by, slack);
            }
            let by = match paired {
                Some(paired) if paired.middle.abs().hi <= CENTRED * paired.spread => {
                    let spread = paired.spread;
                    let places = paired.turns.iter();
                    let places = places
                        .map(|&by| self.moved_exactly(centre, by).hi)
                        .collect();
                    let is_here = self.engine.difference(limit, centre.hi).abs() <= HERE;
                    return is_here.then_some(ChangePair {
                        step,
                        centre,
                        spread,
                        places,
                        opening,
                    });
                }
                Some(paired) => paired.middle,
                None => mean_of_extremes(found.by)?,
            };
            centre = self.moved_exactly(centre, by);
        }
        None
    }

    /// Solves a group's opened equations at a coordinate, from the z in the scratch.
    fn opening(&mut self, step: usize, at: f64) -> Option<Opening> {
        let engine = self.engine;
        let order = Order::Acceleration;
        if engine.run_steps(0..step, at, order, &mut self.state) == Condition::NoAssembly {
            return None;
        }
        let exact = self.exact?;
        let group = &exact.engine.program.coupled[exact.engine.program.steps[step].coupled()?];
        let (q, _) = engine.coordinate(at);
        group.opening(q, &mut self.state)
    }

    /// Returns the solution of a group's opened equations as series about a coordinate, with the
    /// group's inputs.
    fn opening_series(
        &mut self,
        step: usize,
        at: Double,
        opening: &Opening,
        terms: usize,
    ) -> Option<(OpeningSeries, Workspace<Series>)> {
        let exact = self.exact?;
        let group = &exact.engine.program.coupled[exact.engine.program.steps[step].coupled()?];
        let (q, direction) = self.coordinate_of(at, terms);
        let mut series = exact.engine.state(self.state.travels.len());
        self.place_in_series(0..step, at.hi, q, direction, &mut series)?;
        self.take_places(&series, Double::ZERO);
        let found = group.opening_series(q, opening, &mut self.state, &mut series)?;
        Some((found, series))
    }

    /// Returns the maximum opening of a group's equations that counts as zero. An error of a length
    /// shifts an equation by at most twice that error.
    pub(super) fn opening_slack(&self, step: usize) -> f64 {
        let index = self.engine.program.steps[step].coupled();
        let unknowns = index.map_or(0, |index| self.engine.program.coupled[index].unknowns());
        let slack = self.exact.map_or(0.0, |exact| exact.typed_slack());
        2.0 * unknowns as f64 * slack
    }

    /// Expands the mechanism in series about the reversal between two crossings. The state must be
    /// one before them.
    fn junction_of_pair(&mut self, pair: &ChangePair) -> Option<Junction> {
        let arrived = self.state.clone();
        (self.terms..=TERMS).step_by(MORE).find_map(|terms| {
            self.state.clone_from(&arrived);
            self.junction_of_pair_with(pair, terms).ok()
        })
    }

    fn junction_of_pair_with(
        &mut self,
        pair: &ChangePair,
        terms: usize,
    ) -> Result<Junction, Refusal> {
        let exact = self.exact.ok_or(Refusal::End)?;
        let &ChangePair { step, centre, .. } = pair;
        let arrived = self.state.clone();
        let away = self.engine.difference(centre.hi, arrived.at);
        let index = exact.engine.program.steps[step].coupled();
        let group = &exact.engine.program.coupled[index.ok_or(Refusal::End)?];
        let found = self.opening_series(step, centre, &pair.opening, terms);
        let (found, mut series) = found.ok_or(Refusal::End)?;
        let paired = paired_opening(found.by, self.opening_slack(step)).ok_or(Refusal::Terms)?;
        let (q, _) = self.coordinate_of(centre, terms);
        let displacement = group.displacement(&found, away, arrived);
        let side = displacement * paired.pair.value(Double::exactly(away)).hi;
        let height = group
            .follow_pair(q, (&found, paired.pair), side, &mut series)
            .ok_or(Refusal::End)?;
        let mut junction = Junction {
            pair: Some(CoupledPair {
                step,
                height,
                within: f64::INFINITY,
            }),
            ..Junction::about(centre, series, &self.state.signs)
        };
        let fold = SingularGroup {
            step,
            group: group.group,
            snap: SingularShift::default(),
            is_missed: paired.turns.is_empty(),
            turns: paired.turns,
            spread: paired.spread,
            pair: true,
        };
        if fold.is_missed {
            let sine = self.sine_at(&junction, step);
            junction.missed.push(Missed {
                group: fold.group,
                sine,
            });
        }
        junction.fold(fold, self.sense);
        let steps = step + 1..exact.engine.program.steps.len();
        let coordinate = self.coordinate_of(centre, terms);
        self.expand(steps, coordinate, &[], &mut junction)?;
        junction.with_enough_terms(terms)
    }

    /// Returns the sine that measures a coupled group's distance from a change point, at the centre of
    /// a junction.
    fn sine_at(&mut self, junction: &Junction, step: usize) -> f64 {
        self.take_places(&junction.series, Double::ZERO);
        self.take_series(junction, step, 0.0);
        let at = junction.at.hi;
        self.engine.measure_coupled(at, &mut self.state);
        let group = self.engine.group_of(step);
        group.map_or(0.0, |group| self.state.measures[group].abs().sqrt())
    }

    /// Steps across two crossings of a coupled group: from a state before them, which must agree
    /// with the series, to the solution at a coordinate beyond them that agrees with it.
    pub(in crate::solver::motion) fn step_by_series(
        &mut self,
        junction: &Junction,
        (pair, by): (&CoupledPair, f64),
        beyond: f64,
    ) -> bool {
        let arrives = self.agrees_with_series(junction, pair, -self.sense * by);
        if !arrives {
            return false;
        }
        self.take_series(junction, pair.step, self.sense * by);
        self.run(beyond, Order::Acceleration) == Condition::Ok
            && self.agrees_with_series(junction, pair, self.sense * by)
    }

    /// Returns `true` if the group of a pair agrees with the series at a distance from the centre,
    /// and the other branch does not.
    fn agrees_with_series(&self, junction: &Junction, pair: &CoupledPair, by: f64) -> bool {
        let maximum = pair.tolerance(by);
        let at = Double::exactly(by);
        let (points, links) = self.engine.outputs(pair.step);
        let text = &junction.series;
        let here: &State = &self.state;
        points.iter().all(|p| {
            let place = text.points[p.index()].p.map(|s| s.value(at).hi);
            (place - here.points[p.index()].p).norm() <= maximum
        }) && links.iter().all(|l| {
            let direction = text.links[l.index()].d.map(|s| s.value(at).hi);
            (direction - here.links[l.index()].d).norm() <= maximum
        })
    }

    /// Copies a coupled group's values at a distance from a junction to the state and to the
    /// scratch.
    pub(super) fn take_series(&mut self, junction: &Junction, step: usize, by: f64) {
        let at = Double::exactly(by);
        let (points, links) = self.engine.outputs(step);
        let here = &mut self.state.state;
        for p in points {
            here.points[p.index()].p = junction.series.points[p.index()].p.map(|s| s.value(at).hi);
        }
        for l in links {
            here.links[l.index()].d = junction.series.links[l.index()].d.map(|s| s.value(at).hi);
        }
        if let Some(index) = self.engine.program.steps[step].coupled() {
            let group = &self.engine.program.coupled[index];
            let Workspace { state, scratch, .. } = &mut self.state;
            group.read(state, group.open(scratch).z);
        }
    }

    /// Solves the group of a pair in series at a distance from the centre. Returns `true` if the
    /// solution lies on the branch of the junction.
    pub(super) fn stays_on_branch(
        &mut self,
        (junction, by): (&Junction, f64),
        pair: &CoupledPair,
        q: Series,
        here: &mut Workspace<Series>,
    ) -> bool {
        let Some(exact) = self.exact else {
            return false;
        };
        let Some(index) = exact.engine.program.steps[pair.step].coupled() else {
            return false;
        };
        self.take_places(here, Double::ZERO);
        self.take_series(junction, pair.step, by);
        let group = &exact.engine.program.coupled[index];
        if !group.follow(q, &mut self.state, None, here) {
            return false;
        }
        let maximum = pair.tolerance(by);
        let at = Double::exactly(by);
        let (points, links) = self.engine.outputs(pair.step);
        let text = &junction.series;
        points.iter().all(|p| {
            let off = text.points[p.index()].p.map(|s| s.value(at))
                - here.points[p.index()].p.map(|s| s.c[0]);
            off.norm().hi <= maximum
        }) && links.iter().all(|l| {
            let off = text.links[l.index()].d.map(|s| s.value(at))
                - here.links[l.index()].d.map(|s| s.c[0]);
            off.norm().hi <= maximum
        })
    }
}

/// Returns the displacement from the centre of an opening's series to the mean of the three extremes, or
/// `None` if it is too far away.
fn mean_of_extremes(opening: Series) -> Option<Double> {
    let mean = -opening.c[3].hi / (4.0 * opening.c[4].hi);
    (mean.abs() <= HERE).then_some(Double::exactly(mean))
}
