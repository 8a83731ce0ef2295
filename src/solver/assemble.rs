//! Which of its assemblies each group takes: the one nearest to the start positions.

use super::Order;
use super::coupled::Coupled;
use super::engine::Engine;
use super::fault::Fault;
use super::network::Network;
use super::plan::{Group, Plan};
use super::state::{Condition, State};
use super::step::{Outcome, Step};
use crate::{PointId, Vec2};

/// Two assemblies whose distances from the start differ by less than this part are not told apart.
const TIE: f64 = 1e-6;
/// Two solutions of a coupled group nearer than this, in units of about the longest link, are one.
const SAME: f64 = 1e-6;
/// Directions tried for a link of a coupled group of which too little is known.
const TRIED_DIRECTIONS: usize = 12;
/// Combinations of such directions at the most.
const MOST_TRIALS: usize = 1728;
/// Less for large groups: a trial costs up to the cube of the unknowns, and all of them together no
/// more than about half a second.
const TRIAL_WORK: usize = 5_000_000;

/// Settles the signs of all dyads and a solution of every coupled group at the driver's start.
///
/// # Errors
/// [`Fault::Open`], [`Fault::Vague`] or [`Fault::NotAssembled`] for the first group concerned.
pub(super) fn assemble(
    engine: &mut Engine,
    network: &Network<'_>,
    plan: &Plan,
    state: &mut State,
) -> Result<(), Fault> {
    let at = network.mechanism.driver().start;
    for (number, group) in plan.groups.iter().enumerate() {
        let assembler = Assembler {
            network,
            group,
            at,
            number,
        };
        assembler.settle(engine, state)?;
    }
    engine.run(at, Order::Acceleration, state);
    Ok(())
}

struct Assembler<'a> {
    network: &'a Network<'a>,
    group: &'a Group,
    at: f64,
    number: usize,
}

impl Assembler<'_> {
    fn settle(&self, engine: &mut Engine, state: &mut State) -> Result<(), Fault> {
        let starts = &engine.program.group_starts;
        let steps = starts[self.number]..starts[self.number + 1];
        let key = steps
            .clone()
            .find(|&i| engine.program.steps[i].choice().is_some());
        let coupled = steps.clone().find_map(|i| match engine.program.steps[i] {
            Step::Coupled { index } => Some((i, index)),
            _ => None,
        });
        if let Some((i, index)) = coupled {
            engine.run_steps(steps.start..i, self.at, Order::Position, state);
            let group = engine.program.coupled[index].clone();
            self.settle_coupled(&group, engine, state)?;
            let (q, _) = engine.coordinate(self.at);
            let mut scratch = std::mem::take(&mut state.scratch);
            engine.program.coupled[index].side = group.correct(q, state, &mut scratch).side;
            state.scratch = scratch;
        }
        if let Some(key) = key {
            return self.choose_sign(key, steps, engine, state);
        }
        match engine.run_steps(steps.clone(), self.at, Order::Acceleration, state) {
            Condition::NoAssembly => Err(Fault::Singular {
                elements: self.elements(),
            }),
            Condition::Ok | Condition::DeadPoint | Condition::ChangePoint => Ok(()),
        }
    }

    fn elements(&self) -> Vec<crate::Element> {
        let links = self.group.links.iter().map(|&l| crate::Element::Link(l));
        links
            .chain(self.group.point.map(crate::Element::Point))
            .collect()
    }

    /// The start positions of points that this group places, in the solver's frame.
    fn wanted(&self, engine: &Engine) -> Vec<(PointId, Vec2)> {
        let given = self.network.mechanism.start().iter();
        let ours = given.filter(|(point, _)| self.group.points.contains(point));
        ours.map(|&(point, near)| (point, engine.frame.inner(near).nearest()))
            .collect()
    }

    /// Solves a dyad on both sides and keeps the one nearer to the start.
    fn choose_sign(
        &self,
        key: usize,
        steps: std::ops::Range<usize>,
        engine: &mut Engine,
        state: &mut State,
    ) -> Result<(), Fault> {
        engine.run_steps(steps.start..key, self.at, Order::Acceleration, state);
        let (q, _) = engine.coordinate::<f64>(self.at);
        let step = engine.program.steps[key];
        if engine.place_dyad(&step, self.at, state) == Outcome::Open {
            let gap = step.gap(q, state);
            return Err(if gap > 0.0 {
                self.open(engine, gap)
            } else {
                // It closes, in any direction.
                let elements = self.elements();
                Fault::Singular { elements }
            });
        }
        let wanted = self.wanted(engine);
        let subject = self.subject(engine, key);
        let mut found = [(0.0, Vec2::ZERO); 2];
        for (found, sign) in found.iter_mut().zip([1.0, -1.0]) {
            state.signs[self.number] = sign;
            engine.run_steps(steps.clone(), self.at, Order::Position, state);
            let miss = |&(p, near): &(PointId, Vec2)| (state.points[p.index()].p - near).norm2();
            *found = (
                wanted.iter().map(miss).sum(),
                state.points[subject.index()].p,
            );
        }
        let [(plus, p_plus), (minus, p_minus)] = found;
        let undecided = wanted.is_empty() || (plus - minus).abs() <= TIE * (plus + minus);
        if undecided && !self.is_symmetric(engine, key) {
            let choices = [p_plus, p_minus].map(|p| engine.frame.place(p)).to_vec();
            return Err(Fault::Vague {
                point: subject,
                choices,
            });
        }
        let sign = if undecided || plus < minus { 1.0 } else { -1.0 };
        state.signs[self.number] = sign;
        engine.signs[self.number] = sign;
        engine.run_steps(steps, self.at, Order::Acceleration, state);
        Ok(())
    }

    /// An arm without a point of its own has no start to choose by: it runs along its guide's
    /// positive direction.
    fn is_symmetric(&self, engine: &Engine, key: usize) -> bool {
        let Step::Swing(swing) = engine.program.steps[key] else {
            return false;
        };
        let named = |p: &&PointId| {
            **p != swing.pin && self.network.mechanism.points().get(p.index()).is_some()
        };
        self.group.points.iter().find(named).is_none()
    }

    /// The point whose position tells the assemblies apart.
    fn subject(&self, engine: &Engine, key: usize) -> PointId {
        let Step::Swing(swing) = engine.program.steps[key] else {
            return self.group.point.unwrap_or(PointId::new(0));
        };
        self.group
            .points
            .iter()
            .copied()
            .find(|&p| p != swing.pin)
            .unwrap_or(swing.pin)
    }

    fn open(&self, engine: &Engine, gap: f64) -> Fault {
        Fault::Open {
            point: self.group.point.unwrap_or(PointId::new(0)),
            links: self.group.links.clone(),
            gap: gap * engine.frame.scale,
        }
    }

    // ---- coupled groups

    /// Newton from the start positions; where they say too little, from a fan of directions.
    fn settle_coupled(
        &self,
        group: &Coupled,
        engine: &Engine,
        state: &mut State,
    ) -> Result<(), Fault> {
        let wanted = self.wanted(engine);
        let (q, _) = engine.coordinate(self.at);
        let mut solutions: Vec<(f64, Vec<f64>, Vec2)> = Vec::new();
        let subject = self.group.point.unwrap_or(PointId::new(0));
        let middles = self.middles(state, &wanted);
        let guesses = self.guesses(group, engine, state);
        for (directions, &middle) in guesses
            .iter()
            .flat_map(|g| middles.iter().map(move |m| (g, m)))
        {
            let mut scratch = std::mem::take(&mut state.scratch);
            let near = |p: PointId| wanted.iter().find(|w| w.0 == p).map_or(middle, |w| w.1);
            group.set_guess(group.open(&mut scratch).z, near, directions);
            let settled = group.correct(q, state, &mut scratch).settled
                && group.finish(q, super::step::POSITION, state, &mut scratch);
            let z = group.open(&mut scratch).z.to_vec();
            state.scratch = scratch;
            let known = solutions.iter().any(|(_, other, _)| is_same(other, &z));
            if settled && !known {
                let miss =
                    |&(p, near): &(PointId, Vec2)| (state.points[p.index()].p - near).norm2();
                solutions.push((
                    wanted.iter().map(miss).sum(),
                    z,
                    state.points[subject.index()].p,
                ));
            }
        }
        solutions.sort_by(|a, b| a.0.total_cmp(&b.0));
        if wanted.is_empty() && solutions.len() > 1 {
            let choices = solutions
                .iter()
                .map(|(_, _, p)| engine.frame.place(*p))
                .collect();
            return Err(Fault::Vague {
                point: subject,
                choices,
            });
        }
        let Some((_, best, _)) = solutions.first() else {
            let gap = group.gap(q, state) * engine.frame.scale;
            return Err(Fault::NotAssembled {
                points: self.group.points.clone(),
                gap,
            });
        };
        group.open(&mut state.scratch).z.copy_from_slice(best);
        Ok(())
    }

    /// Places to begin from for joints without a start: amid what is known, and around it.
    fn middles(&self, state: &State, wanted: &[(PointId, Vec2)]) -> Vec<Vec2> {
        let grounds = self
            .network
            .mechanism
            .point_ids()
            .filter(|&p| self.network.is_ground(p));
        let places: Vec<Vec2> = wanted
            .iter()
            .map(|w| w.1)
            .chain(grounds.map(|p| state.points[p.index()].p))
            .collect();
        let middle = places.iter().fold(Vec2::ZERO, |sum, &p| sum + p) / places.len().max(1) as f64;
        // A lopsided ring: exact symmetry would make the first matrix singular.
        let around = (0..5).map(|i| middle + crate::angle::unit(13.0 + 72.0 * f64::from(i)));
        let near = middle + Vec2::new(0.01, 0.017);
        let all_given = self
            .group
            .points
            .iter()
            .all(|p| wanted.iter().any(|w| w.0 == *p));
        if all_given {
            vec![near]
        } else {
            std::iter::once(near).chain(around).collect()
        }
    }

    /// The directions to try: read off two start positions of a link where there are two.
    fn guesses(&self, group: &Coupled, engine: &Engine, state: &State) -> Vec<Vec<Vec2>> {
        let wanted = self.wanted(engine);
        let most = (TRIAL_WORK / group.unknowns().pow(3)).min(MOST_TRIALS);
        let mut guesses = vec![Vec::new()];
        for &link in group.turning() {
            let read = self.read_direction(link, &wanted, state);
            let fan = (0..TRIED_DIRECTIONS).map(|i| crate::angle::unit(7.0 + 30.0 * i as f64));
            let options: Vec<Vec2> = read.map_or_else(|| fan.collect(), |d| vec![d]);
            if guesses.len() * options.len() > most {
                guesses.iter_mut().for_each(|g| g.push(options[0]));
                continue;
            }
            guesses = guesses
                .iter()
                .flat_map(|g| options.iter().map(move |&d| [&g[..], &[d]].concat()))
                .collect();
        }
        guesses
    }

    /// The direction of a link's class, from two of its points whose places are known or given.
    fn read_direction(
        &self,
        link: crate::LinkId,
        wanted: &[(PointId, Vec2)],
        state: &State,
    ) -> Option<Vec2> {
        let placed: Vec<(Vec2, Vec2)> = self
            .network
            .joints(link)
            .filter_map(|m| {
                let given = wanted.iter().find(|w| w.0 == m.point).map(|w| w.1);
                let known = !self.group.points.contains(&m.point);
                let at = given.or(known.then(|| state.points[m.point.index()].p))?;
                Some((m.local, at))
            })
            .collect();
        let [(local_a, a), (local_b, b), ..] = placed[..] else {
            return None;
        };
        let seen = (b - a).turned((local_b - local_a).conj());
        let own = seen / seen.norm();
        let class = own.turned(self.network.turn[link.index()].nearest().conj());
        class.is_finite().then_some(class)
    }
}

fn is_same(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < SAME)
}
