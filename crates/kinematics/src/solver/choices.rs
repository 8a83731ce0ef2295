//! The assemblies beside the one that is followed: of a group, and of the whole mechanism.

use super::assemble::{Assembler, Placement, Request, handedness};
use super::coupled::{SAME, distance};
use super::elements::Step;
use super::engine::Engine;
use super::fault::Fault;
use super::network::Network;
use super::plan::{Group, GroupId, Pick};
use super::state::{Condition, State};
use super::{Order, Solver, Workspace};
use crate::{ElementId, Mechanism, PointId, Vec2};

/// Whole assemblies are listed as long as there are no more.
pub const MOST_ASSEMBLIES: usize = 64;

/// Ways tried in the search for whole assemblies, at the most: where later groups close with few of the
/// ways of earlier ones, their number grows with every group though hardly any closes.
const MOST_TRIED: usize = 10_000;
/// Beyond a change point by this much, in radians or scaled lengths, and before the next one.
const BEYOND: f64 = 1e-6;

/// One of the assemblies of a group.
#[derive(Clone, Debug)]
pub struct Choice {
    /// What picks it.
    pub pick: Pick,
    /// Whether it is the one that the solver follows.
    pub is_current: bool,
    /// Whether the groups behind close with it, each in its own present assembly or near it.
    pub closes: bool,
    /// Positions with this choice: of everything where it closes, else up to the group itself.
    pub state: State,
}

/// The whole assemblies of a mechanism at a coordinate.
#[derive(Clone, Debug, Default)]
pub struct Assemblies {
    /// For each the picks of its groups, in the plan's order.
    pub list: Vec<Vec<(GroupId, Pick)>>,
    /// Which of them the solver follows.
    pub current: Option<usize>,
    /// Whether the list was not cut at [`MOST_ASSEMBLIES`]. A coupled group may have assemblies that the search has
    /// missed.
    pub is_complete: bool,
}

impl Solver {
    /// The choices of a group of the plan at a coordinate of the driver, those of a dyad `+` and `-`. Empty
    /// where the group has none, where the motion does not come, and in a solver with something left out.
    #[must_use]
    pub fn choices(&self, at: f64, group: GroupId) -> Vec<Choice> {
        let Some(present) = self
            .plan
            .group(group)
            .filter(|g| g.has_choices())
            .and_then(|_| self.present(at))
        else {
            return Vec::new();
        };
        let group = group.index();
        let network = Network::new(&self.mechanism, self.engine.frame);
        let request = present.request(at);
        let assembler = Assembler {
            network: &network,
            plan: &self.plan,
            request: &request,
            exact: None,
            order: Order::Position,
        };
        let (mut engine, mut state) = (self.engine.clone(), present.state.clone());
        engine.signs.clone_from(&present.signs);
        state.state.signs.clone_from(&present.signs);
        state.state.begin(at, Order::Position);
        let ways = assembler.ways(group, &engine, &mut state);
        let numbered = ways.iter().enumerate();
        numbered
            .map(|(i, way)| {
                let is_current = present.is_in(self, group, &ways, i);
                let mut state = present.state.clone();
                state.state.signs.clone_from(&present.signs);
                let taken = assembler.take(group, way, &mut engine, &mut state);
                let closes = taken != Condition::NoAssembly
                    && assembler.settle_from(group + 1, &mut engine, &mut state)
                    && engine.misfit(&state).is_none();
                state.state.condition = Condition::Ok;
                Choice {
                    pick: self.pick_of(group, way, i),
                    is_current,
                    closes,
                    state: state.into_state(),
                }
            })
            .collect()
    }

    /// The whole assemblies at a coordinate of the driver, as far as they are few.
    #[must_use]
    pub fn assemblies(&self, at: f64) -> Assemblies {
        let mut found = Assemblies::default();
        let Some(present) = self.present(at) else {
            return found;
        };
        let network = Network::new(&self.mechanism, self.engine.frame);
        let request = present.request(at);
        let assembler = Assembler {
            network: &network,
            plan: &self.plan,
            request: &request,
            exact: None,
            order: Order::Position,
        };
        let (mut engine, mut state) = (self.engine.clone(), present.state.clone());
        state.state.begin(at, Order::Position);
        // The ways of each group so far, and which of them is taken: an odometer.
        let mut taken: Vec<(Vec<Placement>, usize)> = Vec::new();
        let mut tried = 0;
        loop {
            let number = taken.len();
            if number < self.plan.groups.len() {
                let ways = assembler.ways(number, &engine, &mut state);
                taken.push((ways, 0));
            } else {
                if engine.misfit(&state).is_none() {
                    if found.list.len() == MOST_ASSEMBLIES {
                        return found;
                    }
                    self.note(&taken, &present, &mut found);
                }
                step(&mut taken);
            }
            // Take what is next; where nothing is left of a group, go on with the one before it.
            loop {
                let Some((ways, next)) = taken.last() else {
                    found.is_complete = true;
                    return found;
                };
                tried += 1;
                if tried > MOST_TRIED {
                    return found;
                }
                let number = taken.len() - 1;
                let placed = ways.get(*next).map(|way| {
                    assembler.take(number, way, &mut engine, &mut state) != Condition::NoAssembly
                });
                match placed {
                    Some(true) => break,
                    Some(false) => step(&mut taken),
                    None => {
                        taken.pop();
                        step(&mut taken);
                    }
                }
            }
        }
    }

    /// The same mechanism with another assembly of one group, picked at a coordinate of the driver; the
    /// other groups stay as they are there, or near it. Its motion is its own.
    ///
    /// # Errors
    /// See [`Fault`]: mostly that later groups do not close with it.
    pub fn switched(&self, at: f64, group: GroupId, pick: Pick) -> Result<Solver, Fault> {
        let nothing = || Fault::NoChoice {
            group: self
                .plan
                .group(group)
                .and_then(Group::name)
                .unwrap_or(ElementId::Driver),
            found: 0,
        };
        if !self.plan.group(group).is_some_and(Group::has_choices) {
            return Err(nothing());
        }
        let present = self.present(at).ok_or_else(nothing)?;
        let mut picks: Vec<(ElementId, Pick)> = Vec::new();
        for (number, of) in self.plan.numbered() {
            let own = if number == group {
                Some(pick)
            } else {
                present.picks[number.index()]
            };
            picks.extend(of.name().zip(own));
        }
        Solver::open(&self.mechanism, at, &present.near, &picks)
    }

    /// The same mechanism with other dimensions, opened where it says in the assembly that this one is in at
    /// `at`: dyads keep their side, coupled groups the solution nearest to where they are.
    ///
    /// # Errors
    /// See [`Fault`]: mostly that it does not close so.
    pub fn carried_over(&self, at: f64, changed: &Mechanism) -> Result<Solver, Fault> {
        let Some(present) = self.present(at) else {
            return Solver::new(changed);
        };
        let named = self.plan.groups.iter().zip(&present.picks);
        let picks: Vec<(ElementId, Pick)> = named
            .filter_map(|(group, pick)| group.name().zip(*pick))
            .collect();
        Solver::open(changed, changed.driver().start, &present.near, &picks)
    }

    /// The same mechanism with other dimensions in the assembly that this one is in at `at`: as it opens by itself
    /// where that is this assembly, else carried over, and then true beside it.
    ///
    /// # Errors
    /// As those of [`Solver::carried_over`].
    pub fn kept(&self, at: f64, changed: &Mechanism) -> Result<(Solver, bool), Fault> {
        match Solver::new(changed) {
            Ok(plain) if self.has_sides_of(at, &plain) => Ok((plain, false)),
            _ => Ok((self.carried_over(at, changed)?, true)),
        }
    }

    /// Whether every dyad is at `at` on the side on which it is in another solver, of the same mechanism with
    /// other dimensions, where that opens. False too where a group is coupled and no side tells it.
    #[must_use]
    pub fn has_sides_of(&self, at: f64, other: &Solver) -> bool {
        let own = self.present(at).map(|p| p.picks);
        let others = other.present(other.mechanism.driver().start);
        let (Some(own), Some(others)) = (own, others.map(|p| p.picks)) else {
            return false;
        };
        let mut groups = self.plan.groups.iter().zip(&own);
        own == others && groups.all(|(group, pick)| pick.is_some() || !group.has_choices())
    }

    /// What picks one of the ways of a group, the i-th of them.
    fn pick_of(&self, group: usize, way: &Placement, i: usize) -> Pick {
        match way {
            Placement::Side(sign) => self.side_pick(group, *sign).unwrap_or(Pick::Plus),
            Placement::Root(_) | Placement::Only => Pick::Number(i + 1),
        }
    }

    /// What picks a dyad with this sign.
    fn side_pick(&self, group: usize, sign: f64) -> Option<Pick> {
        // One more sign is kept than there are groups.
        self.plan.groups.get(group)?;
        let steps = &self.engine.program.steps[super::assemble::steps_of(&self.engine, group)];
        let key = steps.iter().find(|s| s.choice().is_some())?;
        Some(if sign * handedness(&self.mechanism, key) > 0.0 {
            Pick::Plus
        } else {
            Pick::Minus
        })
    }

    /// Keeps a whole assembly.
    fn note(&self, taken: &[(Vec<Placement>, usize)], present: &Present, found: &mut Assemblies) {
        let chosen = || {
            taken
                .iter()
                .enumerate()
                .map(|(n, (ways, i))| (n, &ways[*i], *i))
        };
        let mut all = taken.iter().enumerate();
        if all.all(|(n, (ways, i))| present.is_in(self, n, ways, *i)) {
            found.current = Some(found.list.len());
        }
        let picks = chosen().filter(|&(n, _, _)| self.plan.groups[n].has_choices());
        let picks = picks.map(|(n, way, i)| (GroupId::new(n), self.pick_of(n, way, i)));
        found.list.push(picks.collect());
    }

    /// The assembly at a coordinate; `None` where there is nothing to choose from.
    fn present(&self, at: f64) -> Option<Present> {
        let whole =
            self.engine.program.group_starts.last() == Some(&self.engine.program.steps.len());
        if !whole {
            return None;
        }
        let mut state = self.state();
        if self.solve(at, Order::Position, &mut state) == Condition::NoAssembly {
            return None;
        }
        let mut signs = self.engine.signs.clone();
        // At a change point itself, what counts is the way on.
        let beyond = self.engine.moved(at, BEYOND);
        let place = if state.condition == Condition::ChangePoint {
            beyond
        } else {
            at
        };
        self.motion.passages.choose(&self.engine, place, &mut signs);
        let points = self.mechanism.point_ids();
        let near = points.map(|p| (p, state.place(p)));
        let numbered = signs.iter().enumerate();
        let picks = numbered.map(|(n, &sign)| self.side_pick(n, sign));
        Some(Present {
            near: near.collect(),
            picks: picks.take(self.plan.groups.len()).collect(),
            signs,
            state,
        })
    }
}

/// The next way of the last group.
fn step(taken: &mut [(Vec<Placement>, usize)]) {
    if let Some((_, next)) = taken.last_mut() {
        *next += 1;
    }
}

/// The assembly that a solver follows, at one coordinate.
struct Present {
    state: Workspace,
    /// The sign of every group there.
    signs: Vec<f64>,
    /// What picks it, of the dyads.
    picks: Vec<Option<Pick>>,
    /// Where every point is, in the scene's frame.
    near: Vec<(PointId, Vec2)>,
}

impl Present {
    /// Asks for the same again.
    fn request(&self, at: f64) -> Request<'_> {
        Request {
            at,
            near: &self.near,
            picks: self.picks.clone(),
        }
    }

    /// Whether a group is in the i-th of its ways: of solutions in the nearest one, if it is near.
    fn is_in(&self, solver: &Solver, group: usize, ways: &[Placement], i: usize) -> bool {
        match &ways[i] {
            Placement::Only => true,
            Placement::Side(sign) => sign * self.signs[group] > 0.0,
            Placement::Root(_) => {
                let away = |way| self.distance(&solver.engine, group, way);
                let own = away(&ways[i]);
                let mut others = ways.iter().map(away);
                own < SAME && others.all(|other| own <= other)
            }
        }
    }

    /// How far a group is from one of its solutions.
    fn distance(&self, engine: &Engine, group: usize, way: &Placement) -> f64 {
        let steps = &engine.program.steps[super::assemble::steps_of(engine, group)];
        let index = steps.iter().find_map(Step::coupled);
        match (index.map(|i| &engine.program.coupled[i]), way) {
            (Some(own), Placement::Root(z)) => {
                let numbers = &self.state.scratch.numbers[own.offset..own.offset + own.width()];
                distance(numbers, z)
            }
            (None, _) | (_, Placement::Side(_) | Placement::Only) => f64::INFINITY,
        }
    }
}
