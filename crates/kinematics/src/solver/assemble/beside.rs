//! Starts beside a change point of a coupled group. There, Newton's method has few digits, and rates
//! have fewer: they would lead from one of the assemblies that meet to the other. The motion is
//! followed from a coordinate close by, on the branch that leads to the solution. A given solution
//! has all its digits and is taken as it is.

use super::roots::extended;
use super::{
    Assembler, AssemblyFailure, ExpectedPositions, Placement, Request, TrackingStart, side_of,
    steps_of,
};
use crate::mechanism::Body;
use crate::solver::Order;
use crate::solver::conditioning::condition;
use crate::solver::coupled::{Coupled, Scratch, distance};
use crate::solver::engine::Engine;
use crate::solver::fault::Fault;
use crate::solver::plan::AssemblyChoice;
use crate::solver::state::{Condition, State};
use crate::solver::workspace::Workspace;
use crate::{LinkId, PointId, Vec2};

/// Maximum residual of approximate positions that are a solution within rounding, in units of about
/// the longest link.
const MAX_RESIDUAL: f64 = 1e-13;
/// Condition of a group below which a solution is beside a change point or a limit. It is about the
/// distance from a change point.
const MAX_CONDITION: f64 = 1e-6;
/// Distance of the coordinate from which the motion is followed, in radians or scaled lengths. The
/// solutions there have most of their digits, and a series of second order leads back.
const OFFSET: f64 = 1e-4;
/// Maximum error of that series, in units of about the longest link. It includes the error of a
/// solution found by Newton's method.
const MAX_MISS: f64 = 1e-7;
/// Maximum error of the intended branch relative to that of the next one.
const MAX_MISS_RATIO: f64 = 0.1;
/// Minimum error of that next branch: below it, the errors of both series decide. Newton's method
/// leaves the solution itself free within about 1e-8.
const MIN_SEPARATION: f64 = 1e-9;
const MIN_SEPARATION_BY_NEWTON: f64 = 1e-7;
/// Minimum growth of the condition up to [`OFFSET`]. A group that is ill-conditioned everywhere is
/// not beside a singularity.
const MIN_CONDITION_RATIO: f64 = 10.0;
/// Measure of a dyad below which it may change its side within [`OFFSET`].
const IN_LINE: f64 = 1e-6;
/// Maximum distance of a solution at [`OFFSET`] that meets the given one.
const MAX_ROOT_DISTANCE: f64 = 0.05;

/// Maximum number of combinations of the directions of slots.
const MAX_DIRECTIONS: usize = 64;

/// A solution close to the given one.
struct Branch {
    /// The error with which it leads to the given solution.
    miss: f64,
    z: Vec<f64>,
}

/// The other groups at the coordinate of a solution.
struct GroupsAround {
    /// The pick of every dyad.
    picks: Vec<Option<AssemblyChoice>>,
    /// Whether a dyad is almost in line.
    is_any_in_line: bool,
}

impl Assembler<'_> {
    /// Returns the approximate positions as a solution of a coupled group, if they satisfy its
    /// equations within rounding and the group is almost singular there.
    pub(super) fn solution_beside_singularity(
        &self,
        number: usize,
        wanted: &[(PointId, Vec2)],
        engine: &Engine,
        workspace: &mut Workspace,
    ) -> Option<Vec<f64>> {
        let group = self.coupled_of(number, engine)?;
        let mut points = self.group(number).points.iter();
        if !points.all(|p| wanted.iter().any(|w| w.0 == *p)) {
            return None;
        }
        let (q, _) = engine.coordinate::<f64>(self.request.at);
        let given = |p: PointId| wanted.iter().find(|w| w.0 == p).map_or(Vec2::ZERO, |w| w.1);
        let guesses = self.read_directions(number, group, wanted, workspace);
        let Workspace { state, scratch, .. } = workspace;
        guesses.into_iter().find_map(|directions| {
            group.set_guess(group.open(scratch).z, given, &directions);
            let z = group.open(scratch).z.to_vec();
            let is_solved = group.gap(q, state, scratch) <= MAX_RESIDUAL;
            (is_solved && self.is_beside(group, &z, engine, state, scratch)).then_some(z)
        })
    }

    /// Returns `true` if a coupled group is almost singular in a solution.
    pub(super) fn is_beside(
        &self,
        group: &Coupled,
        z: &[f64],
        engine: &Engine,
        state: &State,
        scratch: &mut Scratch,
    ) -> bool {
        let (q, _) = engine.coordinate::<f64>(self.request.at);
        group.open(scratch).z.copy_from_slice(z);
        condition(group, q, state, scratch).is_none_or(|condition| condition < MAX_CONDITION)
    }

    /// Returns the directions of a coupled group's links that its points imply. A slot between two
    /// points may have either direction. Empty if the points do not imply all directions.
    fn read_directions(
        &self,
        number: usize,
        group: &Coupled,
        wanted: &[(PointId, Vec2)],
        state: &State,
    ) -> Vec<Vec<Vec2>> {
        let mut guesses = vec![Vec::new()];
        for &link in group.turning() {
            let options = match self.read_direction(number, link, wanted, state) {
                Some(direction) => vec![direction],
                None => self.slot_directions(number, link, wanted, state),
            };
            if guesses.len() * options.len() > MAX_DIRECTIONS {
                return Vec::new();
            }
            guesses = extended(&guesses, &options);
        }
        guesses
    }

    /// Returns both directions of a link's class for which a slot on the link leads from its named
    /// point to its pin. Empty if a position is neither given nor known.
    pub(super) fn slot_directions(
        &self,
        number: usize,
        link: LinkId,
        wanted: &[(PointId, Vec2)],
        state: &State,
    ) -> Vec<Vec2> {
        let ours = &self.group(number).points;
        let place = |point: PointId| {
            let given = wanted.iter().find(|w| w.0 == point).map(|w| w.1);
            let known = !ours.contains(&point);
            given.or(known.then(|| state.points[point.index()].p))
        };
        let mut slots = self.network.mechanism.slides().iter();
        let found = slots.find_map(|slide| {
            let end = slide.named.filter(|_| slide.on == Body::Link(link))?;
            Some((slide, place(slide.slider.point())? - place(end)?))
        });
        let Some((slide, along)) = found else {
            return Vec::new();
        };
        let turn = self.network.turn[link.index()].nearest();
        let class = (along / along.norm()).turned(slide.direction().conj());
        let class = class.turned(turn.conj());
        if class.is_finite() {
            vec![class, -class]
        } else {
            Vec::new()
        }
    }

    /// Starts at a coordinate close to that of a solution of a coupled group, on its branch. Returns
    /// `None` at a limit, where the motion exists on one side only, and for a group that is
    /// ill-conditioned everywhere.
    ///
    /// # Errors
    /// Returns a fault if the branches cannot be distinguished.
    pub(super) fn start_beside(
        &self,
        number: usize,
        z: &[f64],
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> Result<Option<TrackingStart>, Fault> {
        let fault = || match self.group(number).name() {
            Some(group) => Fault::ChangePoint {
                group,
                has_sides: false,
            },
            None => self.singular(number),
        };
        let Some((step, index)) = self.coupled(number, engine) else {
            return Ok(None);
        };
        let group = &engine.program.coupled[index];
        let wanted = self.wanted(number, engine);
        let given = self.solution_beside_singularity(number, &wanted, engine, state);
        let min_separation = match given {
            Some(_) => MIN_SEPARATION,
            None => MIN_SEPARATION_BY_NEWTON,
        };
        self.show_root(group, z, engine, state);
        let (q, _) = engine.coordinate::<f64>(self.request.at);
        let side = group.side_at(q, &state.state, &mut state.scratch);
        let here = condition(group, q, &state.state, &mut state.scratch).unwrap_or(0.0);
        // Points on the group's links, from which later groups are placed.
        let riding = step + 1..steps_of(engine, number).end;
        let _ = engine.run_steps(riding, self.request.at, Order::Position, state);
        let around = self.groups_around(number, engine, state);
        let around = around.map_err(|failure| match failure {
            AssemblyFailure::Fault(fault) => fault,
            AssemblyFailure::Stretched(_) | AssemblyFailure::Beside(..) => fault(),
        })?;
        let positions: Vec<Vec2> = state.points.iter().map(|point| point.p).collect();
        let points = self.network.mechanism.point_ids();
        let near: Vec<_> = points.map(|point| (point, state.place(point))).collect();
        let mut starts = Vec::new();
        let mut is_limit = false;
        for by in [OFFSET, -OFFSET] {
            let at = engine.moved(self.request.at, by);
            if engine.is_beyond_table(at) {
                continue;
            }
            let request = Request {
                at,
                near: &near,
                picks: around.picks.clone(),
            };
            let nearby = Assembler {
                request: &request,
                follows_branches: false,
                ..*self
            };
            let (mut engine, mut state) = (engine.clone(), state.clone());
            let branches = nearby.branches(number, z, self.request.at, &mut engine, &mut state);
            let Some(branches) = branches else {
                continue;
            };
            let [best, next, ..] = &branches[..] else {
                is_limit = true;
                continue;
            };
            let is_clear = best.miss <= MAX_MISS_RATIO * next.miss && next.miss >= min_separation;
            if best.miss > MAX_MISS || !is_clear {
                continue;
            }
            let placement = Placement::Root(best.z.clone());
            let is_placed = nearby.take(number, &placement, &mut engine, &mut state)
                != Condition::NoAssembly
                && nearby.place_groups_from(number + 1, &mut engine, &mut state)
                && engine.run(at, self.order, &mut state) == Condition::Ok;
            let Some(group) = nearby.coupled_of(number, &engine).filter(|_| is_placed) else {
                continue;
            };
            let is_same_side = group.side == side;
            // Other groups that are in line here change their sides, too.
            if !is_same_side && around.is_any_in_line {
                continue;
            }
            let (q, _) = engine.coordinate::<f64>(at);
            let there = condition(group, q, &state.state, &mut state.scratch).unwrap_or(0.0);
            if there < MIN_CONDITION_RATIO * here {
                return Ok(None);
            }
            starts.push((is_same_side, at, next.miss, engine, state));
        }
        // Without a change point in between, if there is such a side.
        starts.sort_by_key(|(is_same_side, ..)| !is_same_side);
        let Some((_, at, separation, there, found)) = starts.into_iter().next() else {
            return if is_limit { Ok(None) } else { Err(fault()) };
        };
        (*engine, *state) = (there, found);
        Ok(Some(TrackingStart {
            at,
            stuck: Some(fault()),
            expected: Some(ExpectedPositions {
                positions,
                tolerance: 0.5 * separation,
            }),
        }))
    }

    /// Places the groups after one at the requested coordinate, and returns the picks of all dyads
    /// there: the approximate positions belong to it.
    ///
    /// # Errors
    /// Returns the failure of a group that cannot be placed, or of another coupled group that is
    /// almost singular.
    fn groups_around(
        &self,
        number: usize,
        engine: &Engine,
        state: &mut Workspace,
    ) -> Result<GroupsAround, AssemblyFailure> {
        let mut engine = engine.clone();
        self.place_remaining_groups(number + 1, &mut engine, state)?;
        let mut around = GroupsAround {
            picks: self.request.picks.clone(),
            is_any_in_line: false,
        };
        for (other, pick) in around.picks.iter_mut().enumerate() {
            if let Some(key) = self.key(other, &engine) {
                let plus = side_of(self.network.mechanism, &engine, key, AssemblyChoice::Plus);
                *pick = plus.map(|plus| match plus * engine.signs[other] > 0.0 {
                    true => AssemblyChoice::Plus,
                    false => AssemblyChoice::Minus,
                });
                around.is_any_in_line |= state.measures[other].abs() < IN_LINE;
            }
        }
        Ok(around)
    }

    /// Returns the solutions near a given one at another coordinate, in the order of the errors with
    /// which they lead to it at `given_at`. Returns `None` if an earlier group cannot be placed.
    fn branches(
        &self,
        number: usize,
        given: &[f64],
        given_at: f64,
        engine: &mut Engine,
        state: &mut Workspace,
    ) -> Option<Vec<Branch>> {
        if !(0..number).all(|n| self.place_group(n, engine, state).is_ok()) {
            return None;
        }
        self.run_before_placements(number, engine, state);
        let (at, steps) = (self.request.at, steps_of(engine, number));
        let mut found = Vec::new();
        for z in self.all_roots(number, engine, state) {
            if distance(&z, given) > MAX_ROOT_DISTANCE {
                continue;
            }
            self.take_root(number, &z, engine, state);
            let order = Order::Acceleration;
            if engine.run_steps(steps.clone(), at, order, state) != Condition::Ok {
                continue;
            }
            let Some(group) = self.coupled_of(number, engine) else {
                continue;
            };
            let mut buffers = group.open(&mut state.scratch);
            group.predict(&mut buffers, engine.difference(at, given_at));
            let miss = distance(buffers.z, given);
            found.push(Branch { miss, z });
        }
        found.sort_by(|a, b| a.miss.total_cmp(&b.miss));
        Some(found)
    }
}
