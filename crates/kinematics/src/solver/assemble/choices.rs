//! Lists the alternative assemblies of a group and of the whole mechanism.

use crate::solver::assemble::{Assembler, Placement, Request, handedness};
use crate::solver::coupled::{EQUALITY_TOLERANCE, distance};
use crate::solver::elements::Step;
use crate::solver::engine::Engine;
use crate::solver::fault::Fault;
use crate::solver::plan::network::Network;
use crate::solver::plan::{AssemblyChoice, Group, GroupId};
use crate::solver::state::{Condition, State};
use crate::solver::{Order, Solver, Workspace};
use crate::{ElementId, Mechanism, PointId, Vec2};

/// The maximum number of whole assemblies listed.
pub const MAX_ASSEMBLIES: usize = 64;

/// The maximum number of placements tried in the search for whole assemblies. If later groups close
/// with few placements of earlier ones, the number of combinations grows with every group though
/// hardly any closes.
const MAX_TRIED: usize = 10_000;
/// A distance past a change point, in radians or scaled lengths, small enough to stay before the
/// next one.
const STEP_PAST_CHANGE_POINT: f64 = 1e-6;

/// An assembly of a group.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The pick that selects it.
    pub pick: AssemblyChoice,
    /// Whether the solver follows this assembly.
    pub is_current: bool,
    /// `true` if the later groups close with this choice, each in its current assembly or close to it.
    pub closes: bool,
    /// The positions with this choice: of all groups if they close, or else up to the group itself.
    pub state: State,
}

/// The whole assemblies of a mechanism at a coordinate.
#[derive(Clone, Debug, Default)]
pub struct Assemblies {
    /// For each assembly the picks of its groups, in plan order.
    pub list: Vec<Vec<(GroupId, AssemblyChoice)>>,
    /// The index of the assembly that the solver follows.
    pub current: Option<usize>,
    /// Whether the list was not cut at [`MAX_ASSEMBLIES`]. The search may still miss assemblies of
    /// a coupled group.
    pub is_complete: bool,
}

impl Solver {
    /// Returns the choices of a group at a coordinate of the driver; those of a dyad are `+` and
    /// `-`. Empty if the group has no choices, if the motion does not reach the coordinate, and in
    /// a solver made by [`Solver::only`] that leaves out steps.
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
        let assembler = self.assembler(&network, &request);
        let (mut engine, mut state) = (self.engine.clone(), present.state.clone());
        engine.signs.clone_from(&present.signs);
        state.state.signs.clone_from(&present.signs);
        state.state.start(at, Order::Position);
        let placements = assembler.ways(group, &engine, &mut state);
        let numbered = placements.iter().enumerate();
        numbered
            .map(|(i, way)| {
                let is_current = present.is_in(self, group, &placements, i);
                let mut state = present.state.clone();
                state.state.signs.clone_from(&present.signs);
                let taken = assembler.take(group, way, &mut engine, &mut state);
                let closes = taken != Condition::NoAssembly
                    && assembler.place_groups_from(group + 1, &mut engine, &mut state)
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

    /// Returns the whole assemblies at a coordinate of the driver, up to [`MAX_ASSEMBLIES`].
    #[must_use]
    pub fn assemblies(&self, at: f64) -> Assemblies {
        let mut found = Assemblies::default();
        let Some(present) = self.present(at) else {
            return found;
        };
        let network = Network::new(&self.mechanism, self.engine.frame);
        let request = present.request(at);
        let assembler = self.assembler(&network, &request);
        let (mut engine, mut state) = (self.engine.clone(), present.state.clone());
        state.state.start(at, Order::Position);
        // The placements of each group so far, and the index of the current one: an odometer.
        let mut taken: Vec<(Vec<Placement>, usize)> = Vec::new();
        let mut tried = 0;
        loop {
            let number = taken.len();
            if number < self.plan.groups.len() {
                let placements = assembler.ways(number, &engine, &mut state);
                taken.push((placements, 0));
            } else {
                if engine.misfit(&state).is_none() {
                    if found.list.len() == MAX_ASSEMBLIES {
                        return found;
                    }
                    self.note(&taken, &present, &mut found);
                }
                step(&mut taken);
            }
            // Try the next placement; if a group has none left, continue with the group before it.
            loop {
                let Some((placements, next)) = taken.last() else {
                    found.is_complete = true;
                    return found;
                };
                tried += 1;
                if tried > MAX_TRIED {
                    return found;
                }
                let number = taken.len() - 1;
                let placed = placements.get(*next).map(|way| {
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

    /// Returns a solver with another assembly of one group, picked at a coordinate of the driver.
    /// All other groups keep their assemblies there, or stay near them. The motion is followed
    /// again.
    ///
    /// # Errors
    /// See [`Fault`]. The usual reason is that later groups do not close with it.
    pub fn switched(
        &self,
        at: f64,
        group: GroupId,
        choice: AssemblyChoice,
    ) -> Result<Solver, Fault> {
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
        let mut choices: Vec<(ElementId, AssemblyChoice)> = Vec::new();
        for (number, of) in self.plan.numbered() {
            let own = if number == group {
                Some(choice)
            } else {
                present.picks[number.index()]
            };
            choices.extend(of.name().zip(own));
        }
        Solver::open(&self.mechanism, at, &present.near, &choices)
    }

    /// Returns a solver for changed dimensions, in the assembly of this solver at `at`. It opens at
    /// the start of `changed`: dyads keep their side, coupled groups take the solution nearest to
    /// their current one.
    ///
    /// # Errors
    /// See [`Fault`]. The usual reason is that the mechanism does not close in this assembly.
    pub fn with_dimensions_in_assembly(
        &self,
        at: f64,
        changed: &Mechanism,
    ) -> Result<Solver, Fault> {
        let Some(present) = self.present(at) else {
            return Solver::new(changed);
        };
        let named = self.plan.groups.iter().zip(&present.picks);
        let choices: Vec<(ElementId, AssemblyChoice)> = named
            .filter_map(|(group, choice)| group.name().zip(*choice))
            .collect();
        Solver::open(changed, changed.driver().start, &present.near, &choices)
    }

    /// Returns a solver for changed dimensions in the assembly of this solver at `at`. If `changed`
    /// opens in this assembly by itself, the flag is `false`. If not, the assembly is carried over
    /// and the flag is `true`.
    ///
    /// # Errors
    /// See [`Solver::with_dimensions_in_assembly`].
    pub fn with_dimensions(&self, at: f64, changed: &Mechanism) -> Result<(Solver, bool), Fault> {
        match Solver::new(changed) {
            Ok(plain) if self.has_sides_of(at, &plain) => Ok((plain, false)),
            _ => Ok((self.with_dimensions_in_assembly(at, changed)?, true)),
        }
    }

    /// Returns `true` if every dyad is at `at` on the side that it has in `other` where that solver
    /// opens; `other` has the same mechanism with other dimensions. Returns `false` if a group is
    /// coupled, since it has no side to compare.
    #[must_use]
    pub fn has_sides_of(&self, at: f64, other: &Solver) -> bool {
        let own = self.present(at).map(|p| p.picks);
        let others = other.present(other.mechanism.driver().start);
        let (Some(own), Some(others)) = (own, others.map(|p| p.picks)) else {
            return false;
        };
        let mut groups = self.plan.groups.iter().zip(&own);
        own == others && groups.all(|(group, choice)| choice.is_some() || !group.has_choices())
    }

    /// Returns an assembler of positions for a request.
    fn assembler<'a>(
        &'a self,
        network: &'a Network<'a>,
        request: &'a Request<'a>,
    ) -> Assembler<'a> {
        Assembler {
            network,
            plan: &self.plan,
            request,
            exact: self.exact.as_deref(),
            order: Order::Position,
            follows_branches: false,
        }
    }

    /// Returns the pick of the `i`-th placement of a group.
    fn pick_of(&self, group: usize, way: &Placement, i: usize) -> AssemblyChoice {
        match way {
            Placement::Side(sign) => self.side_pick(group, *sign).unwrap_or(AssemblyChoice::Plus),
            Placement::Root(_) | Placement::Only => AssemblyChoice::Number(i + 1),
        }
    }

    /// Returns the pick of a dyad with this sign.
    fn side_pick(&self, group: usize, sign: f64) -> Option<AssemblyChoice> {
        // `signs` has one entry more than there are groups.
        self.plan.groups.get(group)?;
        let steps =
            &self.engine.program.steps[crate::solver::assemble::steps_of(&self.engine, group)];
        let key = steps.iter().find(|s| s.choice().is_some())?;
        Some(if sign * handedness(&self.mechanism, key) > 0.0 {
            AssemblyChoice::Plus
        } else {
            AssemblyChoice::Minus
        })
    }

    /// Adds a whole assembly to the list.
    fn note(&self, taken: &[(Vec<Placement>, usize)], present: &Present, found: &mut Assemblies) {
        let chosen = || {
            taken
                .iter()
                .enumerate()
                .map(|(n, (placements, i))| (n, &placements[*i], *i))
        };
        let mut all = taken.iter().enumerate();
        if all.all(|(n, (placements, i))| present.is_in(self, n, placements, *i)) {
            found.current = Some(found.list.len());
        }
        let picks = chosen().filter(|&(n, _, _)| self.plan.groups[n].has_choices());
        let picks = picks.map(|(n, way, i)| (GroupId::new(n), self.pick_of(n, way, i)));
        found.list.push(picks.collect());
    }

    /// Returns the sign of every group at a coordinate, and the positions there; `None` if steps are
    /// left out or there is no assembly.
    pub(in crate::solver) fn assembly_at(&self, at: f64) -> Option<(Vec<f64>, State)> {
        let present = self.present(at)?;
        Some((present.signs, present.state.into_state()))
    }

    /// Returns the assembly at a coordinate; `None` if steps are left out or there is no assembly.
    fn present(&self, at: f64) -> Option<Present> {
        let is_whole =
            self.engine.program.group_starts.last() == Some(&self.engine.program.steps.len());
        if !is_whole {
            return None;
        }
        let mut state = self.state();
        if self.solve(at, Order::Position, &mut state) == Condition::NoAssembly {
            return None;
        }
        let mut signs = self.engine.signs.clone();
        // At a change point itself, the assembly just past it counts.
        let beyond = self.engine.moved(at, STEP_PAST_CHANGE_POINT);
        let place = if state.condition == Condition::ChangePoint {
            beyond
        } else {
            at
        };
        self.motion
            .crossings
            .choose(&self.engine, place, &mut signs);
        let points = self.mechanism.point_ids();
        let near = points.map(|p| (p, state.place(p)));
        let numbered = signs.iter().enumerate();
        let choices = numbered.map(|(n, &sign)| self.side_pick(n, sign));
        Some(Present {
            near: near.collect(),
            picks: choices.take(self.plan.groups.len()).collect(),
            signs,
            state,
        })
    }
}

/// Selects the next placement of the last group.
fn step(taken: &mut [(Vec<Placement>, usize)]) {
    if let Some((_, next)) = taken.last_mut() {
        *next += 1;
    }
}

/// The assembly that a solver follows, at one coordinate.
struct Present {
    state: Workspace,
    /// The sign of every group.
    signs: Vec<f64>,
    /// The picks that select this assembly, for dyads.
    picks: Vec<Option<AssemblyChoice>>,
    /// The position of every point, in the scene's frame.
    near: Vec<(PointId, Vec2)>,
}

impl Present {
    /// Creates a request for this assembly.
    fn request(&self, at: f64) -> Request<'_> {
        Request {
            at,
            near: &self.near,
            picks: self.picks.clone(),
        }
    }

    /// Returns `true` if a group is in its `i`-th placement. For a solution of a coupled group: if
    /// it is the nearest one, and near.
    fn is_in(&self, solver: &Solver, group: usize, placements: &[Placement], i: usize) -> bool {
        match &placements[i] {
            Placement::Only => true,
            Placement::Side(sign) => sign * self.signs[group] > 0.0,
            Placement::Root(_) => {
                let away = |way| self.distance(&solver.engine, group, way);
                let own = away(&placements[i]);
                let mut others = placements.iter().map(away);
                own < EQUALITY_TOLERANCE && others.all(|other| own <= other)
            }
        }
    }

    /// Returns the distance of a group from one of its solutions.
    fn distance(&self, engine: &Engine, group: usize, way: &Placement) -> f64 {
        let steps = &engine.program.steps[crate::solver::assemble::steps_of(engine, group)];
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
