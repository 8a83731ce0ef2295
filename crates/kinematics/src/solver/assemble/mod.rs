//! Assembles a mechanism at one coordinate, group by group, in the placement picked for each group
//! or in the one nearest to approximate positions.
//!
//! Dyads have two placements, coupled groups several, all others one. If a dyad is stretched, its
//! two placements coincide and positions cannot distinguish them. The motion is then started next
//! to that coordinate.

mod beside;
pub(super) mod choices;
mod double_double_placement;
mod open;
mod request;
mod roots;

pub(super) use request::Request;

use super::Order;
use super::elements::{Step, StepOutcome};
use super::engine::Engine;
use super::exact::Exact;
use super::fault::Fault;
use super::plan::network::Network;
use super::plan::pruning::PlacedPart;
use super::plan::{AssemblyChoice, Group, Plan};
use super::state::{Condition, State};
use super::workspace::Workspace;
use crate::{Mechanism, PointId, Vec2};

/// Relative difference of the distances from the approximate positions below which two placements
/// are not distinguished.
const TIE: f64 = 1e-6;
/// Distance of the starting coordinate from one at which a dyad is stretched, in radians or scaled
/// lengths. It is larger than one step across a change point, and small enough that all other
/// groups stay near.
const START_OFFSET: f64 = 5e-3;

/// A placement of a group.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Placement {
    /// The only placement.
    Only,
    /// The side of a dyad, by its sign.
    Side(f64),
    /// A solution of a coupled group, by its unknowns.
    Root(Vec<f64>),
}

/// The reason why a mechanism was not assembled.
#[derive(Debug)]
pub(super) enum AssemblyFailure {
    Fault(Fault),
    /// The dyad with this number is stretched, where only positions exist.
    Stretched(usize),
    /// The solution of the coupled group with this number is almost singular.
    Beside(usize, Vec<f64>),
}

impl From<Fault> for AssemblyFailure {
    fn from(fault: Fault) -> AssemblyFailure {
        AssemblyFailure::Fault(fault)
    }
}

/// The coordinate from which a motion is followed.
#[derive(Debug)]
pub(super) struct TrackingStart {
    /// The requested coordinate, or one close to it.
    pub at: f64,
    /// For a start next to the requested coordinate: the fault if the motion does not reach that
    /// coordinate, or reaches it with other positions than expected.
    pub stuck: Option<Fault>,
    /// The expected positions at the requested coordinate, if known.
    pub expected: Option<ExpectedPositions>,
}

/// Positions that a motion must reach.
#[derive(Debug)]
pub(super) struct ExpectedPositions {
    /// The positions of all points, in the solver's frame.
    positions: Vec<Vec2>,
    /// Maximum distance from them, in units of about the longest link.
    tolerance: f64,
}

impl ExpectedPositions {
    /// Returns `true` if a state has the positions.
    pub(super) fn are_in(&self, state: &State) -> bool {
        let mut pairs = self.positions.iter().zip(&state.points);
        pairs.all(|(expected, point)| (point.p - *expected).norm() <= self.tolerance)
    }
}

/// Determines the signs of all dyads and a solution of every coupled group, and leaves in `state`
/// the start of the motion.
///
/// # Errors
/// Returns the fault of the first group that cannot be placed, or whose placements cannot be
/// distinguished.
pub(super) fn assemble(
    engine: &mut Engine,
    network: &Network<'_>,
    plan: &Plan,
    request: &Request<'_>,
    exact: Option<&Exact>,
    state: &mut Workspace,
) -> Result<TrackingStart, Fault> {
    let assembler = Assembler {
        network,
        plan,
        request,
        exact,
        order: Order::Acceleration,
        follows_branches: true,
    };
    assembler.start(engine, state)
}

/// The data for assembling groups.
pub(super) struct Assembler<'a> {
    pub network: &'a Network<'a>,
    pub plan: &'a Plan,
    pub request: &'a Request<'a>,
    /// For a closer look where doubles do not suffice.
    pub exact: Option<&'a Exact>,
    /// With [`Order::Position`] a stretched dyad is treated like any other.
    pub order: Order,
    /// Whether a coupled group beside a singularity is followed from a coordinate close by.
    pub follows_branches: bool,
}

impl Assembler<'_> {
    /// Determines where the motion is followed from, and its assembly there.
    fn start(&self, engine: &mut Engine, state: &mut Workspace) -> Result<TrackingStart, Fault> {
        match self.place_all_groups(engine, state) {
            Ok(()) => Ok(TrackingStart {
                at: self.request.at,
                stuck: None,
                expected: None,
            }),
            Err(AssemblyFailure::Fault(fault)) => Err(fault),
            Err(AssemblyFailure::Stretched(group)) => self.start_near(group, engine, state),
            Err(AssemblyFailure::Beside(group, z)) => {
                match self.start_beside(group, &z, engine, state)? {
                    Some(start) => Ok(start),
                    None => Assembler {
                        follows_branches: false,
                        ..*self
                    }
                    .start(engine, state),
                }
            }
        }
    }

    pub(super) fn place_all_groups(
        &self,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> Result<(), AssemblyFailure> {
        self.place_remaining_groups(0, engine, state)?;
        if engine.run(self.request.at, self.order, state) != Condition::Ok {
            let steps = engine.program.steps.len();
            let _ = self.place_closely(steps, state);
        }
        Ok(())
    }

    /// Places the groups starting at `first`, as far as the positions choose their assemblies.
    pub(super) fn place_remaining_groups(
        &self,
        first: usize,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> Result<(), AssemblyFailure> {
        for number in first..self.plan.groups.len() {
            if let Err(halt) = self.place_group(number, engine, state) {
                return Err(self.all_open(number, halt, engine, state));
            }
        }
        Ok(())
    }

    /// Places the groups starting at `first`. Returns `true` if all could be placed.
    pub(super) fn place_groups_from(
        &self,
        first: usize,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> bool {
        (first..self.plan.groups.len()).all(|n| self.place_group(n, engine, state).is_ok())
    }

    /// Places a group in the intended placement. The groups before it are already placed.
    pub(super) fn place_group(
        &self,
        number: usize,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> Result<(), AssemblyFailure> {
        self.run_before_placements(number, engine, state);
        let way = if self.key(number, engine).is_some() {
            self.intended_side(number, engine, state)?
        } else if self.coupled(number, engine).is_some() {
            self.intended_root(number, engine, state)?
        } else {
            Placement::Only
        };
        if let (Placement::Root(z), true, Some(group)) =
            (&way, self.follows_branches, self.coupled_of(number, engine))
        {
            let Workspace { state, scratch, .. } = &mut *state;
            if self.is_beside(group, z, engine, state, scratch) {
                return Err(AssemblyFailure::Beside(number, z.clone()));
            }
        }
        match self.take(number, &way, engine, state) {
            Condition::NoAssembly => Err(self.singular(number).into()),
            Condition::Ok | Condition::DeadPoint | Condition::ChangePoint => Ok(()),
        }
    }

    /// Returns all placements of a group. The groups before it are already placed.
    pub(super) fn ways(
        &self,
        number: usize,
        engine: &Engine,
        state: &mut Workspace,
    ) -> Vec<Placement> {
        self.run_before_placements(number, engine, state);
        if let Some(key) = self.key(number, engine) {
            let closing = match self.closing(key, engine, state) {
                StepOutcome::Stretched => StepOutcome::Stretched,
                in_doubles => self.closing_closely(key, in_doubles, state),
            };
            return match closing {
                StepOutcome::Open | StepOutcome::Unclear => Vec::new(),
                StepOutcome::Done | StepOutcome::Stretched => {
                    let plus = side_of(self.network.mechanism, engine, key, AssemblyChoice::Plus)
                        .unwrap_or(1.0);
                    vec![Placement::Side(plus), Placement::Side(-plus)]
                }
            };
        }
        if self.coupled(number, engine).is_some() {
            let roots = self.all_roots(number, engine, state);
            return roots.into_iter().map(Placement::Root).collect();
        }
        vec![Placement::Only]
    }

    /// Places a group in one of its placements. The groups before it are already placed.
    pub(super) fn take(
        &self,
        number: usize,
        way: &Placement,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> Condition {
        match way {
            Placement::Only => {}
            Placement::Side(sign) => {
                state.state.signs[number] = *sign;
                engine.signs[number] = *sign;
            }
            Placement::Root(z) => self.take_root(number, z, engine, state),
        }
        self.place(number, engine, state)
    }

    /// Places a group according to the signs and unknowns in the state.
    fn place(&self, number: usize, engine: &Engine, state: &mut Workspace) -> Condition {
        let steps = steps_of(engine, number);
        let end = steps.end;
        match engine.run_steps(steps, self.request.at, self.order, state) {
            Condition::Ok => Condition::Ok,
            stretched @ (Condition::DeadPoint | Condition::ChangePoint)
                if self.order == Order::Position =>
            {
                stretched
            }
            unclear => self.place_closely(end, state).unwrap_or(unclear),
        }
    }

    // ---- the steps of a group

    /// Runs the steps of a group before its placements differ.
    fn run_before_placements(&self, number: usize, engine: &Engine, state: &mut Workspace) {
        let steps = steps_of(engine, number);
        let parting = self
            .key(number, engine)
            .or_else(|| Some(self.coupled(number, engine)?.0));
        if let Some(parting) = parting {
            let _ = engine.run_steps(steps.start..parting, self.request.at, self.order, state);
        }
    }

    /// Returns the step of a group that has two placements.
    fn key(&self, number: usize, engine: &Engine) -> Option<usize> {
        steps_of(engine, number).find(|&i| engine.program.steps[i].choice().is_some())
    }

    /// Returns the step of a coupled group, and its index among the coupled groups.
    fn coupled(&self, number: usize, engine: &Engine) -> Option<(usize, usize)> {
        let coupled = |i: usize| engine.program.steps[i].coupled();
        steps_of(engine, number).find_map(|i| Some((i, coupled(i)?)))
    }

    fn group(&self, number: usize) -> &Group {
        &self.plan.groups[number]
    }

    fn singular(&self, number: usize) -> Fault {
        let group = self.group(number);
        let links = group.links.iter().map(|&l| crate::ElementId::Link(l));
        let elements = links.chain(group.point.map(crate::ElementId::Point));
        Fault::Singular {
            elements: elements.collect(),
            is_here_only: false,
        }
    }

    // ---- dyads

    fn closing(&self, key: usize, engine: &Engine, state: &mut Workspace) -> StepOutcome {
        let step = &engine.program.steps[key];
        engine.place_dyad(step, self.request.at, &mut state.state)
    }

    /// Returns the picked side, or the one nearer to the approximate positions.
    fn intended_side(
        &self,
        number: usize,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> Result<Placement, AssemblyFailure> {
        let Some(key) = self.key(number, engine) else {
            return Ok(Placement::Only);
        };
        let picked = self.request.picks[number];
        let mechanism = self.network.mechanism;
        let picked = picked.map(|choice| side_of(mechanism, engine, key, choice).ok_or(choice));
        let in_doubles = self.closing(key, engine, state);
        // A coordinate named as an end may be up to half an ulp beyond it, or before it.
        let may_end = in_doubles == StepOutcome::Stretched && self.order != Order::Position;
        match self.closing_closely(key, in_doubles, state) {
            StepOutcome::Open | StepOutcome::Unclear | StepOutcome::Stretched if may_end => {
                return Err(AssemblyFailure::Stretched(number));
            }
            StepOutcome::Open | StepOutcome::Unclear => {
                return Err(self.open(number, key, engine, state).into());
            }
            StepOutcome::Done | StepOutcome::Stretched => {}
        }
        match picked {
            Some(Ok(sign)) => Ok(Placement::Side(sign)),
            Some(Err(_)) => Err(self.no_choice(number, 2).into()),
            None => match self.nearer_side(number, key, engine, state) {
                Err(AssemblyFailure::Fault(Fault::Vague { .. })) if may_end => {
                    Err(AssemblyFailure::Stretched(number))
                }
                side => side,
            },
        }
    }

    /// Places a dyad on both sides and returns the side nearer to the approximate positions.
    fn nearer_side(
        &self,
        number: usize,
        key: usize,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> Result<Placement, AssemblyFailure> {
        let wanted = self.wanted(number, engine);
        let subject = self.subject(number, engine, key);
        let mut found = [(0.0, Vec2::ZERO); 2];
        for (found, sign) in found.iter_mut().zip([1.0, -1.0]) {
            state.state.signs[number] = sign;
            let _ = self.place(number, engine, state);
            *found = (miss(&wanted, state), state.points[subject.index()].p);
        }
        let [(plus, p_plus), (minus, p_minus)] = found;
        let undecided = wanted.is_empty() || (plus - minus).abs() <= TIE * (plus + minus);
        // If only positions are requested, either side will do where both coincide.
        let indifferent = self.order == Order::Position || self.is_symmetric(number, engine, key);
        if undecided && !indifferent {
            let choices = [p_plus, p_minus].map(|p| engine.frame.place(p)).to_vec();
            return Err(Fault::vague(subject, choices).into());
        }
        let sign = if undecided || plus < minus { 1.0 } else { -1.0 };
        Ok(Placement::Side(sign))
    }

    /// Returns `true` for an arm without a point of its own. It has no start that chooses a side,
    /// so it runs along its guide's positive direction.
    fn is_symmetric(&self, number: usize, engine: &Engine, key: usize) -> bool {
        let Step::Swing(swing) = engine.program.steps[key] else {
            return false;
        };
        let named = |p: &&PointId| {
            **p != swing.pin && self.network.mechanism.points().get(p.index()).is_some()
        };
        self.group(number).points.iter().find(named).is_none()
    }

    /// Returns the point whose position distinguishes the placements.
    fn subject(&self, number: usize, engine: &Engine, key: usize) -> PointId {
        let group = self.group(number);
        let Step::Swing(swing) = engine.program.steps[key] else {
            return group.point.unwrap_or(PointId::new(0));
        };
        let mut points = group.points.iter().copied();
        points.find(|&p| p != swing.pin).unwrap_or(swing.pin)
    }

    fn open(&self, number: usize, key: usize, engine: &Engine, state: &State) -> Fault {
        let (q, _) = engine.coordinate::<f64>(self.request.at);
        let in_doubles = || {
            let dyad = engine.program.steps[key].dyad();
            dyad.map_or(0.0, |d| d.gap(q, state))
        };
        let gap = self.gap_closely(key, state).unwrap_or_else(in_doubles);
        if !(gap > 0.0) {
            // It closes, in any direction.
            return self.singular(number);
        }
        let group = self.group(number);
        Fault::Open {
            point: group.point.unwrap_or(PointId::new(0)),
            links: group.links.clone(),
            gap: gap * engine.frame.scale,
        }
    }

    fn no_choice(&self, number: usize, found: usize) -> Fault {
        match self.group(number).name() {
            Some(group) => Fault::NoChoice { group, found },
            None => self.singular(number),
        }
    }

    // ---- starting where a dyad is stretched

    /// Starts on the side of the coordinate on which the mechanism exists. At a change point it
    /// exists on both sides, and the start is past it, in the picked placement.
    fn start_near(
        &self,
        stretched: usize,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> Result<TrackingStart, Fault> {
        let looking = Assembler {
            order: Order::Position,
            exact: None,
            follows_branches: false,
            ..*self
        };
        let fault = |halt: AssemblyFailure| match halt {
            AssemblyFailure::Fault(fault) => fault,
            AssemblyFailure::Stretched(number) | AssemblyFailure::Beside(number, _) => {
                self.singular(number)
            }
        };
        looking.place_all_groups(engine, state).map_err(fault)?;
        let here = PointId::new;
        let points = self.network.mechanism.points().len();
        let near: Vec<_> = (0..points)
            .map(|i| (here(i), state.place(here(i))))
            .collect();
        let picked = self.request.picks[stretched];
        let mut assembly_choices = self.request.picks.clone();
        for (number, choice) in assembly_choices.iter_mut().enumerate() {
            let key = self.key(number, engine);
            let ends = key.map(|key| looking.closing(key, engine, state));
            if ends == Some(StepOutcome::Stretched) {
                let hinted = key.and_then(|key| self.hinted(number, key, engine, state));
                *choice = choice.or(hinted).or(Some(AssemblyChoice::Plus));
            }
        }
        let at = |side: f64| engine.moved(self.request.at, side * START_OFFSET);
        let ends = [at(1.0), at(-1.0)].map(|at| {
            let request = Request {
                at,
                near: &near,
                picks: assembly_choices.clone(),
            };
            let nearby = Assembler {
                request: &request,
                ..*self
            };
            let (mut engine, mut state) = (engine.clone(), state.clone());
            nearby.place_all_groups(&mut engine, &mut state).ok()?;
            Some((at, engine, state))
        });
        let passes = ends.iter().all(Option::is_some);
        // Stretched everywhere on the motion, or only here.
        let point = self.group(stretched).point.unwrap_or(here(0));
        let choices = vec![state.place(point); 2];
        let is_open = |key: &usize| {
            let found = self.place_closely(key + 1, state);
            found == Some(Condition::NoAssembly)
        };
        let stuck = match self.key(stretched, engine).filter(is_open) {
            Some(key) => self.open(stretched, key, engine, state),
            None => Fault::vague(point, choices),
        };
        let Some((at, there, found)) = ends.into_iter().flatten().next() else {
            return Err(stuck);
        };
        if let (true, None, Some(group)) = (passes, picked, self.group(stretched).name()) {
            return Err(Fault::ChangePoint {
                group,
                has_sides: true,
            });
        }
        (*engine, *state) = (there, found);
        Ok(TrackingStart {
            at,
            stuck: Some(stuck),
            expected: None,
        })
    }

    // ---- approximate positions

    /// Returns the approximate positions of points placed by a group, in the solver's frame.
    fn wanted(&self, number: usize, engine: &Engine) -> Vec<(PointId, Vec2)> {
        self.places(number, self.request.near, engine)
    }

    /// Selects from approximate positions those of points placed by a group, in the solver's frame.
    fn places(
        &self,
        number: usize,
        near: &[(PointId, Vec2)],
        engine: &Engine,
    ) -> Vec<(PointId, Vec2)> {
        let points = &self.group(number).points;
        let ours = near.iter().filter(|(p, _)| points.contains(p));
        ours.map(|&(point, near)| (point, engine.frame.inner(near).nearest()))
            .collect()
    }
}

/// Returns the sum of the squared distances of the state's points from the approximate positions.
fn miss(wanted: &[(PointId, Vec2)], state: &State) -> f64 {
    let miss = |&(p, near): &(PointId, Vec2)| (state.points[p.index()].p - near).norm2();
    wanted.iter().map(miss).sum()
}

pub(super) fn steps_of(engine: &Engine, number: usize) -> std::ops::Range<usize> {
    let starts = &engine.program.group_starts;
    starts[number]..starts[number + 1]
}

/// Returns the sign of a pick in the solver, `None` if a dyad has no such pick.
fn side_of(
    mechanism: &Mechanism,
    engine: &Engine,
    key: usize,
    choice: AssemblyChoice,
) -> Option<f64> {
    let own = handedness(mechanism, &engine.program.steps[key]);
    match choice {
        AssemblyChoice::Plus => Some(own),
        AssemblyChoice::Minus => Some(-own),
        AssemblyChoice::Number(_) => None,
    }
}

/// Returns the factor between a dyad's pick and its sign in the solver. The solver orients a
/// triangle from its shorter arm, a scene from its link of lower rank.
pub(super) fn handedness(mechanism: &Mechanism, step: &Step) -> f64 {
    let mut links = Vec::new();
    if step.choice().is_some() {
        step.outputs(&[], &mut |part| {
            if let PlacedPart::Link(link) = part {
                links.push(link);
            }
        });
    }
    match links[..] {
        [a, b] if mechanism.link_rank(b) < mechanism.link_rank(a) => -1.0,
        _ => 1.0,
    }
}
