//! Change points on the way: which dyad is stretched to an extreme of its reach first, where exactly, and
//! on beyond it with all that is singular there.

use super::NearMiss;
use super::junction::{Junction, Standing};
use super::walk::Walker;
use crate::Double;
use crate::numeric::root;
use crate::solver::Order;
use crate::solver::elements::{Dyad, REACH_SLACK, StepOutcome, Stretching};
use crate::solver::plan::GroupId;
use crate::solver::state::Condition;

/// A measure this small is a gap of the size of the rounding, squared.
const GAP: f64 = 1e-28;
/// A change point is passed in one step from this much before it to this much beyond, in radians or
/// scaled lengths: far enough for the dyad to have digits on both sides.
const PASSING: f64 = 1e-3;
/// Where links turn too fast for that - an antiparallelogram that is almost a square turns its follower
/// hundreds of times as fast as its crank, and several of them in a row many times more - closer by.
const CLOSER: f64 = 0.1;
/// So often: closest by, the series alone tell where everything is.
const APPROACHES: i32 = 11;
/// How far beyond a place the other assembly is held against what was set aside, and what is no rounding
/// of a misfit there.
const LED: f64 = 1e-4;
const MIN_MISS: f64 = 1e-9;
/// An extreme of a dyad's stretch belongs to a limit if it is at most this close to it, in radians or scaled
/// lengths: it is sought from the first of these distances on, each wider than the last.
const EXTREMES: [f64; 4] = [1e-12, 1e-9, 1e-6, 1e-3];
/// A dyad whose measure is more than this at a limit is not what ends or passes there.
const LARGE: f64 = 1e-3;

/// A place ahead at which a dyad is stretched to an extreme of its reach.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReachExtreme {
    pub(super) step: usize,
    pub(super) at: Double,
}

/// Where two solutions of a coupled group cross.
#[derive(Clone, Debug)]
pub(super) struct Change {
    pub(super) step: usize,
    /// The driver's coordinate.
    pub(super) at: f64,
    /// z there, and the rates of z with which the motion comes.
    pub(super) z: Vec<f64>,
    pub(super) rate: Vec<f64>,
}

/// Distances at which a place is passed, closer and closer.
pub(super) fn approaches() -> impl Iterator<Item = f64> {
    (0..APPROACHES).map(|k| PASSING * CLOSER.powi(k))
}

impl Walker<'_> {
    /// Goes on beyond a limit, if it is a change point: the coordinate that was reached.
    pub(super) fn pass(&mut self, limit: f64) -> Option<f64> {
        self.anchors.forget_beyond(self.engine, limit, self.sense);
        self.unproved.clear();
        if let Some(extreme) = self.ahead.take().filter(|e| e.at.hi == limit) {
            return self.pass_extreme(extreme.step, extreme.at);
        }
        let stretched = self.stretched(limit);
        if stretched.is_empty() {
            return self.cross(limit);
        }
        // Those of the plan's first group are sure: what later ones do depends on the side it is on.
        stretched.into_iter().find_map(|(step, at)| {
            let at = self.exactly(step, at)?;
            self.pass_extreme(step, at)
        })
    }

    /// Goes on beyond a place at which a dyad's reach is extreme.
    fn pass_extreme(&mut self, step: usize, at: Double) -> Option<f64> {
        let junction = self.junction(at, None);
        let beyond = junction.and_then(|junction| self.pass_junction(&junction));
        if beyond.is_none()
            && let Some(Standing::Singular { .. }) = self.standing_at(step, at)
        {
            let group = self.engine.group_of(step);
            self.unproved.extend(group.map(GroupId::new));
        }
        beyond
    }

    fn pass_junction(&mut self, junction: &Junction) -> Option<f64> {
        if junction.is_miss() {
            self.step_over(junction)
        } else {
            self.pass_through(junction)
        }
    }

    /// Goes on past a near miss: on the side on which the motion came.
    fn step_over(&mut self, junction: &Junction) -> Option<f64> {
        let beyond = approaches().find_map(|by| self.step_across(junction, by))?;
        for missed in &junction.missed {
            let (group, sine, at) = (GroupId::new(missed.group), missed.sine, junction.at.hi);
            self.misses.push(NearMiss { group, sine, at });
        }
        self.seen.clear();
        self.note(beyond);
        Some(beyond)
    }

    /// Passes a place in one step, from as far before as it can be to the same beyond.
    pub(super) fn pass_through(&mut self, junction: &Junction) -> Option<f64> {
        let passages = self.passages(junction)?;
        let known = self.passages.len();
        self.passages.add(passages);
        let room = self.room_about(junction);
        let mut closer = approaches().filter(|&by| by < room);
        let Some(beyond) = closer.find_map(|by| self.pass_at(junction, by)) else {
            self.passages.truncate(known);
            return None;
        };
        let groups: Vec<usize> = self
            .passages
            .latest(known)
            .iter()
            .map(|p| p.group)
            .collect();
        let led: Vec<bool> = groups
            .into_iter()
            .map(|group| self.is_led(group, junction.at.hi))
            .collect();
        for (passage, is_led) in self.passages.latest(known).iter_mut().zip(led) {
            passage.is_led = is_led;
        }
        self.seen.clear();
        self.note(beyond);
        Some(beyond)
    }

    /// How far it is to the place that a singular group has passed before.
    fn room_about(&self, junction: &Junction) -> f64 {
        let groups = junction.groups();
        let away =
            groups.filter_map(|group| self.passages.distance(self.engine, group, junction.at.hi));
        away.fold(f64::INFINITY, f64::min)
    }

    /// Passes a place in one step from a distance before to the same beyond, if the series tell where
    /// everything is at both.
    fn pass_at(&mut self, junction: &Junction, by: f64) -> Option<f64> {
        let signs = self.state.signs.clone();
        let beyond = self.step_across(junction, by)?;
        let reached = self.state.clone();
        let proved = self.proves(junction, by, self.engine.program.steps.len());
        self.state = reached;
        if !proved {
            self.state.state.signs = signs;
        }
        proved.then_some(beyond)
    }

    /// Goes from a distance before a place to the same beyond; what is singular there goes on as it does.
    fn step_across(&mut self, junction: &Junction, by: f64) -> Option<f64> {
        let engine = self.engine;
        let at = junction.at.hi;
        let before = engine.moved(at, -self.sense * by);
        let beyond = engine.moved(at, self.sense * by);
        self.aim_at(before);
        if self.run(before, Order::Acceleration) != Condition::Ok {
            return None;
        }
        let saved = self.state.clone();
        for step in junction.turning() {
            self.flip(step);
        }
        if self.try_step(before, beyond, &saved) {
            return Some(beyond);
        }
        self.state = saved;
        None
    }

    /// Whether a constraint that was set aside parts from the other assembly of a group at once, beyond a
    /// place at which both meet: it leads the group through, and the whole is not singular there. The
    /// state is the one beyond.
    fn is_led(&mut self, group: usize, at: f64) -> bool {
        let engine = self.engine;
        if engine.program.watches.is_empty() || !engine.program.coupled.is_empty() {
            return false;
        }
        let saved = self.state.clone();
        let sign = &mut self.state.state.signs[group];
        *sign = -*sign;
        let mut other = |by: f64| {
            let beside = engine.moved(at, self.sense * by);
            let exists = engine.run(beside, Order::Position, &mut self.state) == Condition::Ok;
            let misses = engine.misses(&self.state).map(|(_, miss, _)| miss.abs());
            exists.then(|| misses.fold(0.0, f64::max))
        };
        let misses = (other(LED), other(2.0 * LED));
        self.state = saved;
        // In proportion to the distance; what only parts with its square is singular as well.
        matches!(misses, (Some(near), Some(far)) if near > MIN_MISS && far < 3.0 * near)
    }

    /// Changes the sign of the group of a step.
    pub(super) fn flip(&mut self, step: usize) {
        if let Some(group) = self.engine.group_of(step) {
            let sign = &mut self.state.state.signs[group];
            *sign = -*sign;
        }
    }

    /// The dyads that are stretched to an extreme of their reach close to a limit, and where.
    fn stretched(&mut self, limit: f64) -> Vec<(usize, f64)> {
        let flat = self.flat(limit);
        let found = flat
            .into_iter()
            .filter_map(|step| Some((step, self.extreme(step, limit)?)));
        found.collect()
    }

    /// The dyads that are all but in line at a limit, up to the first that is open there.
    fn flat(&mut self, limit: f64) -> Vec<usize> {
        let engine = self.engine;
        let mut flat = Vec::new();
        self.aim_at(limit);
        for (step, of) in engine.program.steps.iter().enumerate() {
            let condition = self.run_some(step..step + 1, limit, Order::Position);
            let is_flat = |group: usize| self.state.measures[group].abs() < LARGE;
            flat.extend(of.choice().filter(|&group| is_flat(group)).map(|_| step));
            if condition == Condition::NoAssembly {
                break;
            }
        }
        flat
    }

    /// Where a dyad's stretch is extreme close to a limit, if its arms are in line there.
    fn extreme(&mut self, step: usize, limit: f64) -> Option<f64> {
        let group = self.engine.program.steps[step].choice()?;
        let at = EXTREMES.into_iter().find_map(|by| {
            let a = self.engine.moved(limit, -by);
            let b = self.engine.moved(limit, by);
            let rates = (self.stretch_rate(step, a)?, self.stretch_rate(step, b)?);
            self.most_stretched(step, (a, rates.0), (b, rates.1))
        })?;
        self.stretch_rate(step, at)?;
        self.is_stretched(step, group, at).then_some(at)
    }

    /// Where a dyad's stretch is extreme between two places at which its rates differ in sign.
    pub(super) fn most_stretched(
        &mut self,
        step: usize,
        a: (f64, f64),
        b: (f64, f64),
    ) -> Option<f64> {
        let finest = self.engine.finest();
        let at = root(a, b, finest, |at| self.stretch_rate(step, at));
        at.ok()
    }

    /// Whether a dyad's arms may be in line, within the rounding of the given lengths and coordinates:
    /// whether they are is told later. The state must be that of its inputs.
    pub(super) fn is_stretched(&mut self, step: usize, group: usize, at: f64) -> bool {
        let engine = self.engine;
        let step = &engine.program.steps[step];
        let placed = engine.place_dyad(step, at, &mut self.state.state);
        // Equal arms whose pivots meet have no direction, but no gap either.
        let has_no_gap = self.state.measures[group].abs() <= GAP;
        let (q, _) = engine.coordinate(at);
        let slack = (REACH_SLACK * engine.frame.far).max(2.0 * self.slack());
        let is_rounding = |dyad: Dyad<'_>| dyad.reserve(q, &self.state).abs() <= slack;
        let is_rounding = step.dyad().is_some_and(is_rounding);
        placed == StepOutcome::Stretched || has_no_gap || is_rounding
    }

    /// The sign and size of a dyad's rate of stretch; 0 where nothing moves.
    pub(super) fn stretch_rate(&mut self, step: usize, at: f64) -> Option<f64> {
        Some(self.stretching(step, at)?.rate().unwrap_or(0.0))
    }

    /// How a dyad is being stretched, from its inputs: it may be open itself.
    pub(super) fn stretching(&mut self, step: usize, at: f64) -> Option<Stretching> {
        self.aim_at(at);
        let engine = self.engine;
        if self.run_some(0..step, at, Order::Acceleration) == Condition::NoAssembly {
            return None;
        }
        let (q, _) = engine.coordinate(at);
        engine.place_dyad(&engine.program.steps[step], at, &mut self.state.state);
        engine.program.steps[step]
            .dyad()?
            .stretching(q, &engine.carriers, &self.state)
    }
}
