//! Change points of dyads on the way: which dyads are stretched to an extreme of their reach, where
//! exactly, and on beyond it.

use super::walk::Walker;
use crate::arithmetic::Series;
use crate::solver::Order;
use crate::solver::passage::Passage;
use crate::solver::state::{Condition, State};
use crate::solver::step::{Dyad, Outcome, POSITION, REACH_SLACK, Step};
use crate::solver::workspace::Workspace;
use crate::solver::zero::zero;
use crate::{Double, Number};

/// A measure this small is a gap of the size of the rounding, squared.
const GAP: f64 = 1e-28;
/// A change point is passed in one step from this much before it to this much beyond, in radians or
/// scaled lengths: far enough for the dyad to have digits on both sides.
pub(super) const PASSING: f64 = 1e-3;
/// Where links turn too fast for that - an antiparallelogram that is almost a square turns its follower
/// hundreds of times as fast as its crank - closer by.
const CLOSER: [f64; 3] = [PASSING, 0.1 * PASSING, 0.01 * PASSING];
/// An extreme of a dyad's stretch belongs to a limit if it is this close to it.
const EXTREME: f64 = 1e-3;
/// Change points of several groups that are this close to each other are one, in radians or scaled
/// lengths: a mechanism drawn with lengths from one formula has them a few roundings apart.
const TOGETHER: f64 = 1e-12;

/// A group that passes through a change point.
#[derive(Clone, Debug)]
pub(super) struct Change {
    pub(super) step: usize,
    /// The driver's coordinate.
    pub(super) at: f64,
    /// Of a coupled group: z there, and the rates of z with which the motion comes.
    pub(super) meeting: Option<[Vec<f64>; 2]>,
}

impl Walker<'_> {
    /// Goes on beyond a limit, if it is a change point: the coordinate that was reached.
    pub(super) fn pass(&mut self, limit: f64) -> Option<f64> {
        self.anchors.forget_beyond(self.engine, limit, self.sense);
        let changes = self.changes(limit);
        if changes.is_empty() {
            return self.cross(limit);
        }
        let ahead = changes.iter().map(|c| (self.ahead(c.at), c.at));
        let (first, last) = ahead.fold(None, |ends, here| match ends {
            None => Some((here, here)),
            Some((first, last)) => Some((
                if here.0 < first.0 { here } else { first },
                if here.0 > last.0 { here } else { last },
            )),
        })?;
        CLOSER
            .into_iter()
            .find_map(|by| self.pass_between([first.1, last.1], by, &changes))
    }

    /// Passes change points in one step from a distance before the first of them to the same beyond the
    /// last.
    fn pass_between(&mut self, ends: [f64; 2], by: f64, changes: &[Change]) -> Option<f64> {
        let engine = self.engine;
        let before = engine.moved(ends[0], -self.sense * by);
        let beyond = engine.moved(ends[1], self.sense * by);
        self.aim_at(before);
        if engine.run(before, Order::Acceleration, &mut self.state) != Condition::Ok {
            return None;
        }
        let saved = self.state.clone();
        for change in changes {
            self.flip(change.step);
        }
        // A passage that could not be kept would leave the states beyond it with the wrong signs.
        let reached = self
            .try_step(before, beyond, &saved)
            .then(|| self.state.clone());
        let kept = reached.filter(|reached| self.record(changes, &saved, reached).is_some());
        let Some(reached) = kept else {
            self.state = saved;
            return None;
        };
        self.state = reached;
        self.seen.clear();
        self.note(beyond);
        Some(beyond)
    }

    /// Changes the sign of the group of a step.
    pub(super) fn flip(&mut self, step: usize) {
        if let Some(group) = self.engine.group_of(step) {
            let sign = &mut self.state.state.signs[group];
            *sign = -*sign;
        }
    }

    /// The dyads that are stretched to an extreme of their reach at a limit, and where exactly.
    fn changes(&mut self, limit: f64) -> Vec<Change> {
        let choices = (0..self.engine.program.steps.len())
            .filter(|&i| self.engine.program.steps[i].choice().is_some());
        let choices: Vec<usize> = choices.collect();
        choices
            .into_iter()
            .filter_map(|step| {
                let at = self.extreme(step, limit)?;
                Some(Change {
                    step,
                    at,
                    meeting: None,
                })
            })
            .collect()
    }

    /// Where a dyad's stretch is extreme close to a limit, if its arms are in line there.
    fn extreme(&mut self, step: usize, limit: f64) -> Option<f64> {
        let group = self.engine.program.steps[step].choice()?;
        let (a, b) = (
            self.engine.moved(limit, -EXTREME),
            self.engine.moved(limit, EXTREME),
        );
        let rates = (self.stretch_rate(step, a)?, self.stretch_rate(step, b)?);
        let finest = self.engine.finest();
        let at = zero((a, rates.0), (b, rates.1), finest, |at| {
            self.stretch_rate(step, at)
        })?;
        self.stretch_rate(step, at)?;
        self.is_stretched(step, group, at).then_some(at)
    }

    /// Whether a dyad's arms are in line, within the rounding of the given lengths and coordinates. The
    /// state must be that of its inputs.
    pub(super) fn is_stretched(&mut self, step: usize, group: usize, at: f64) -> bool {
        let engine = self.engine;
        let step = &engine.program.steps[step];
        let placed = engine.place_dyad(step, at, &mut self.state.state);
        // Equal arms whose pivots meet have no direction, but no gap either.
        let has_no_gap = self.state.measures[group].abs() <= GAP;
        let (q, _) = engine.coordinate(at);
        let slack = REACH_SLACK * engine.frame.far;
        let is_rounding = |dyad: Dyad<'_>| dyad.reserve(q, &self.state).abs() <= slack;
        let is_rounding = step.dyad().is_some_and(is_rounding);
        placed == Outcome::Stretched || has_no_gap || is_rounding
    }

    /// A dyad's rate of stretch, from its inputs: it may be open itself.
    pub(super) fn stretch_rate(&mut self, step: usize, at: f64) -> Option<f64> {
        self.aim_at(at);
        let inputs = self
            .engine
            .run_steps(0..step, at, Order::Velocity, &mut self.state);
        if inputs == Condition::NoAssembly {
            return None;
        }
        let engine = self.engine;
        engine.place_dyad(&engine.program.steps[step], at, &mut self.state.state);
        engine.program.steps[step].dyad()?.stretch_rate(&self.state)
    }

    /// Keeps the passages of the groups through their change points. None of them where one has no
    /// series.
    pub(super) fn record(
        &mut self,
        changes: &[Change],
        before: &State,
        beyond: &State,
    ) -> Option<()> {
        let kept = self.passages.len();
        for change in changes {
            let group = self.engine.group_of(change.step)?;
            let is_kept = |p: &Passage| p.group == group && p.at == change.at;
            if self.passages.iter().any(is_kept) {
                continue;
            }
            let Some(passage) = self.passage(change, changes, before, beyond) else {
                self.passages.truncate(kept);
                return None;
            };
            self.passages.push(passage);
        }
        Some(())
    }

    fn passage(
        &mut self,
        change: &Change,
        changes: &[Change],
        before: &State,
        beyond: &State,
    ) -> Option<Passage> {
        let (engine, sense, step) = (self.engine, self.sense, change.step);
        let group = engine.group_of(step)?;
        let series = self.in_series(change, changes, before, beyond)?;
        let solved = |dq: f64| {
            let there = engine.moved(change.at, dq);
            self.aim_at(there);
            let side = if dq * sense < 0.0 { before } else { beyond };
            self.state.state.signs.copy_from_slice(&side.signs);
            let steps = 0..step + 1;
            let condition = engine.run_steps(steps, there, Order::Position, &mut self.state);
            (condition == Condition::Ok).then(|| self.state.state.clone())
        };
        Passage::through(change.at, group, engine.outputs(step), &series, solved)
    }

    /// The motion about a change point in series, as far as the group that passes through it.
    fn in_series(
        &mut self,
        change: &Change,
        changes: &[Change],
        before: &State,
        beyond: &State,
    ) -> Option<Workspace<Series>> {
        let engine = self.engine;
        let up = if self.sense > 0.0 { beyond } else { before };
        let mut series = engine.state::<Series>(self.state.travels.len());
        series.state.signs = up.signs.iter().map(|&s| Series::exactly(s)).collect();
        let place = if engine.turns {
            Series::angle(change.at)
        } else {
            Series::line(change.at, Double::exactly(engine.frame.scale))
        };
        let (q, direction) = engine.coordinate(place);
        self.aim_at(change.at);
        for (i, step) in engine.program.steps[..=change.step].iter().enumerate() {
            let is_here =
                |c: &&Change| c.step == i && engine.difference(c.at, change.at).abs() <= TOGETHER;
            let passes = changes.iter().find(is_here);
            let done = match (step, passes) {
                (Step::Coupled { index }, passes) => {
                    let group = &engine.program.coupled[*index];
                    // Its inputs are read in doubles, too.
                    self.take_places(&series);
                    let meeting = passes.and_then(|c| c.meeting.as_ref());
                    let toward = meeting.map(|[z, rate]| {
                        let room = group.open(&mut self.state.scratch);
                        room.z.copy_from_slice(z);
                        &rate[..]
                    });
                    if toward.is_none() {
                        let _ =
                            engine.run_steps(i..i + 1, change.at, Order::Position, &mut self.state);
                    }
                    group.follow(q, &mut self.state, toward, &mut series)
                }
                (_, Some(_)) => {
                    let dyad = step.dyad()?;
                    let side = up.signs[dyad.group()];
                    dyad.run_through(q, side, &mut series.state) == Outcome::Done
                }
                (_, None) => {
                    step.run::<Series, POSITION>(q, direction, &mut series.state) == Outcome::Done
                }
            };
            if !done {
                return None;
            }
        }
        Some(series)
    }

    /// Takes places and directions from the beginning of series.
    fn take_places(&mut self, series: &State<Series>) {
        let here = &mut self.state.state;
        for (point, from) in here.points.iter_mut().zip(&series.points) {
            point.p = from.p.nearest();
        }
        for (link, from) in here.links.iter_mut().zip(&series.links) {
            link.d = from.d.nearest();
        }
    }
}
