//! Finds the placements of a coupled group: its solutions.

use super::{Assembler, AssemblyFailure, Placement, miss};
use crate::solver::coupled::Coupled;
use crate::solver::engine::Engine;
use crate::solver::fault::Fault;
use crate::solver::plan::AssemblyChoice;
use crate::solver::state::State;
use crate::solver::workspace::Workspace;
use crate::{PointId, Vec2};

/// The resolutions for ordering solutions, in units of about the longest link and in degrees. The
/// finer one orders solutions that are equal at the coarser one.
const ORDER_RESOLUTIONS: [f64; 2] = [1e-6, 1e-9];
/// Number of directions tried for a link of a coupled group with insufficient data.
const DIRECTION_TRIALS: usize = 12;
/// Maximum number of combinations of such directions.
const MAX_TRIALS: usize = 1728;
/// A lower limit for large groups: a trial costs up to the cube of the number of unknowns. All
/// trials together take at most about half a second.
const TRIAL_WORK: usize = 5_000_000;

/// Maximum error of a start for each of its points, in units of about the longest link. Beyond it
/// all solutions are searched.
const MAX_START_ERROR: f64 = 0.05;
/// Maximum number of trials with the slower method.
const MAX_CAREFUL_TRIALS: usize = 32;

/// Number of combinations of directions if curve tracing finds the other solutions.
const SPARSE: usize = 48;

/// Returns the stride through `count` combinations. It is coprime to the 12 directions of each
/// link.
fn stride(count: usize) -> usize {
    let at_least = count.div_ceil(SPARSE);
    let mut strides = at_least..;
    let free = |s: &usize| *s == 1 || (!s.is_multiple_of(2) && !s.is_multiple_of(3));
    strides.find(free).unwrap_or(at_least)
}

/// The method for approaching solutions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SearchEffort {
    Newton,
    /// A few of the combinations, spread over all. The other solutions are found from these.
    Sparse,
    /// For groups in which Newton's method found no solution.
    TrustRegion,
}

impl Assembler<'_> {
    pub(super) fn coupled_of<'e>(&self, number: usize, engine: &'e Engine) -> Option<&'e Coupled> {
        let (_, index) = self.coupled(number, engine)?;
        Some(&engine.program.coupled[index])
    }

    /// Writes a solution to the state, and stores on which side of a singularity it is.
    pub(super) fn take_root(
        &self,
        number: usize,
        z: &[f64],
        engine: &mut Engine,
        workspace: &mut Workspace,
    ) {
        let Some((_, index)) = self.coupled(number, engine) else {
            return;
        };
        let (q, _) = engine.coordinate::<f64>(self.request.at);
        let Workspace { state, scratch, .. } = workspace;
        let group = &mut engine.program.coupled[index];
        group.open(scratch).z.copy_from_slice(z);
        group.side = group.correct(q, state, scratch).side;
    }

    /// Returns the picked solution, or the one nearest to the approximate positions.
    pub(super) fn intended_root(
        &self,
        number: usize,
        engine: &Engine,
        workspace: &mut Workspace,
    ) -> Result<Placement, AssemblyFailure> {
        match self.request.picks[number] {
            Some(AssemblyChoice::Number(n)) => {
                let roots = self.all_roots(number, engine, workspace);
                let found = roots.len();
                let root = roots.into_iter().nth(n.wrapping_sub(1));
                let root = root.ok_or_else(|| self.no_choice(number, found))?;
                Ok(Placement::Root(root))
            }
            Some(AssemblyChoice::Plus | AssemblyChoice::Minus) => {
                let found = self.all_roots(number, engine, workspace).len();
                Err(self.no_choice(number, found).into())
            }
            None => self.nearest_root(number, engine, workspace),
        }
    }

    /// Finds the solution nearest to the approximate positions by Newton's method. Missing
    /// directions are taken from a fan.
    fn nearest_root(
        &self,
        number: usize,
        engine: &Engine,
        workspace: &mut Workspace,
    ) -> Result<Placement, AssemblyFailure> {
        let Some(group) = self.coupled_of(number, engine) else {
            return Ok(Placement::Only);
        };
        let wanted = self.wanted(number, engine);
        // Newton's method may not find a given solution that is almost singular.
        if let Some(z) = self.solution_beside_singularity(number, &wanted, engine, workspace) {
            return Ok(Placement::Root(z));
        }
        let near = |care, workspace: &mut Workspace| {
            self.roots_near(number, &wanted, care, engine, workspace)
        };
        let mut roots = near(SearchEffort::Newton, workspace);
        if roots.is_empty() {
            roots = near(SearchEffort::TrustRegion, workspace);
        }
        // From far away, Newton's method may converge to a solution other than the nearest one.
        let allowed = MAX_START_ERROR * MAX_START_ERROR * wanted.len() as f64;
        let is_near = roots.iter().any(|root| {
            self.show_root(group, root, engine, workspace);
            miss(&wanted, workspace) <= allowed
        });
        if !is_near && !wanted.is_empty() {
            for root in self.all_roots(number, engine, workspace) {
                self.keep(number, root, &mut roots, engine, workspace);
            }
        }
        let subject = self.group(number).point.unwrap_or(PointId::new(0));
        let mut found = Vec::new();
        for root in roots {
            self.show_root(group, &root, engine, workspace);
            let position = workspace.points[subject.index()].p;
            found.push((miss(&wanted, workspace), root, position));
        }
        if wanted.is_empty() && found.len() > 1 {
            let choices = found.iter().map(|f| engine.frame.place(f.2)).collect();
            return Err(Fault::vague(subject, choices).into());
        }
        let best = found.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, root, _)) = best else {
            let (q, _) = engine.coordinate::<f64>(self.request.at);
            return Err(Fault::NotAssembled {
                points: self.group(number).points.clone(),
                gap: group.gap(q, &workspace.state, &mut workspace.scratch) * engine.frame.scale,
            }
            .into());
        };
        Ok(Placement::Root(root))
    }

    /// Returns all solutions found by a search, in an order that depends only on the solutions. The
    /// search starts from the approximate positions, from those of the scene, and without any.
    pub(super) fn all_roots(
        &self,
        number: usize,
        engine: &Engine,
        workspace: &mut Workspace,
    ) -> Vec<Vec<f64>> {
        let mut roots = self.roots_near(number, &[], SearchEffort::Sparse, engine, workspace);
        let Some(group) = self.coupled_of(number, engine) else {
            return roots;
        };
        let starts = [self.request.near, self.network.mechanism.start()];
        let is_told_twice = starts[0] == starts[1];
        for near in starts.into_iter().skip(usize::from(is_told_twice)) {
            let wanted = self.places(number, near, engine);
            if wanted.is_empty() {
                continue;
            }
            let given = self.solution_beside_singularity(number, &wanted, engine, workspace);
            let near = self.roots_near(number, &wanted, SearchEffort::Newton, engine, workspace);
            for root in given.into_iter().chain(near) {
                self.keep(number, root, &mut roots, engine, workspace);
            }
        }
        let (q, _) = engine.coordinate::<f64>(self.request.at);
        let Workspace { state, scratch, .. } = workspace;
        let mut roots = group.relatives(q, roots, state, scratch);
        roots.sort_by_key(|z| rank(group, z));
        roots
    }

    /// Adds a solution to a list unless the list contains it.
    fn keep(
        &self,
        number: usize,
        root: Vec<f64>,
        roots: &mut Vec<Vec<f64>>,
        engine: &Engine,
        workspace: &mut Workspace,
    ) {
        let (q, _) = engine.coordinate::<f64>(self.request.at);
        let Workspace { state, scratch, .. } = workspace;
        let is_known = self.coupled_of(number, engine).is_some_and(|group| {
            let mut known = roots.iter();
            known.any(|other| group.is_one(q, [other, &root], state, scratch))
        });
        if !is_known {
            roots.push(root);
        }
    }

    /// Returns the solutions to which Newton's method converges from approximate positions.
    fn roots_near(
        &self,
        number: usize,
        wanted: &[(PointId, Vec2)],
        care: SearchEffort,
        engine: &Engine,
        workspace: &mut Workspace,
    ) -> Vec<Vec<f64>> {
        let Some(group) = self.coupled_of(number, engine) else {
            return Vec::new();
        };
        let (q, _) = engine.coordinate::<f64>(self.request.at);
        let mut roots: Vec<Vec<f64>> = Vec::new();
        let middles = self.middles(group, workspace, wanted);
        let guesses = self.guesses(number, group, wanted, workspace);
        let (maximum, stride) = match care {
            SearchEffort::Newton => (usize::MAX, 1),
            SearchEffort::Sparse => (usize::MAX, stride(guesses.len())),
            SearchEffort::TrustRegion => (MAX_CAREFUL_TRIALS, 1),
        };
        for directions in guesses.iter().step_by(stride).take(maximum) {
            for &middle in &middles {
                let Workspace { state, scratch, .. } = &mut *workspace;
                let near = |p: PointId| wanted.iter().find(|w| w.0 == p).map_or(middle, |w| w.1);
                group.set_guess(group.open(scratch).z, near, directions);
                let settled = match care {
                    SearchEffort::Newton | SearchEffort::Sparse => {
                        group.correct(q, state, scratch).settled
                    }
                    SearchEffort::TrustRegion => group.approach(q, state, scratch),
                };
                let settled =
                    settled && group.finish(q, crate::solver::elements::POSITION, state, scratch);
                let z = group.open(scratch).z.to_vec();
                if settled {
                    self.keep(number, z, &mut roots, engine, workspace);
                }
            }
        }
        roots
    }

    /// Writes the points of a solution to the state.
    pub(super) fn show_root(
        &self,
        group: &Coupled,
        z: &[f64],
        engine: &Engine,
        workspace: &mut Workspace,
    ) {
        let (q, _) = engine.coordinate::<f64>(self.request.at);
        let Workspace { state, scratch, .. } = workspace;
        group.open(scratch).z.copy_from_slice(z);
        group.finish(q, crate::solver::elements::POSITION, state, scratch);
    }

    /// Returns starting positions for joints without a start: the centroid of the known points, and
    /// a ring around it.
    fn middles(&self, group: &Coupled, state: &State, wanted: &[(PointId, Vec2)]) -> Vec<Vec2> {
        let grounds = self
            .network
            .mechanism
            .point_ids()
            .filter(|&p| self.network.is_ground(p));
        let positions: Vec<Vec2> = wanted
            .iter()
            .map(|w| w.1)
            .chain(grounds.map(|p| state.points[p.index()].p))
            .collect();
        let middle =
            positions.iter().fold(Vec2::ZERO, |sum, &p| sum + p) / positions.len().max(1) as f64;
        // An irregular ring: exact symmetry would make the first matrix singular.
        let around = (0..5).map(|i| middle + crate::angle::unit(13.0 + 72.0 * f64::from(i)));
        let near = middle + Vec2::new(0.01, 0.017);
        let mut guessed = group.guessed_joints();
        if guessed.all(|point| wanted.iter().any(|w| w.0 == point)) {
            vec![near]
        } else {
            std::iter::once(near).chain(around).collect()
        }
    }

    /// Returns the directions to try. A link with two approximate positions has the direction
    /// between them. A link with a slot between two of them has one of two directions first.
    fn guesses(
        &self,
        number: usize,
        group: &Coupled,
        wanted: &[(PointId, Vec2)],
        state: &State,
    ) -> Vec<Vec<Vec2>> {
        let maximum = (TRIAL_WORK / group.unknowns().pow(3)).min(MAX_TRIALS);
        let mut guesses = vec![Vec::new()];
        for &link in group.turning() {
            let options = match self.read_direction(number, link, wanted, state) {
                Some(direction) => vec![direction],
                None => {
                    let fan =
                        (0..DIRECTION_TRIALS).map(|i| crate::angle::unit(7.0 + 30.0 * i as f64));
                    let slots = self.slot_directions(number, link, wanted, state);
                    slots.into_iter().chain(fan).collect()
                }
            };
            if guesses.len() * options.len() > maximum {
                guesses.iter_mut().for_each(|g| g.push(options[0]));
                continue;
            }
            guesses = extended(&guesses, &options);
        }
        guesses
    }

    /// Returns the direction of a link's class, from two of its points with known or given
    /// positions.
    pub(super) fn read_direction(
        &self,
        number: usize,
        link: crate::LinkId,
        wanted: &[(PointId, Vec2)],
        state: &State,
    ) -> Option<Vec2> {
        let ours = &self.group(number).points;
        let placed: Vec<(Vec2, Vec2)> = self
            .network
            .joints(link)
            .filter_map(|m| {
                let given = wanted.iter().find(|w| w.0 == m.point).map(|w| w.1);
                let known = !ours.contains(&m.point);
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

/// Returns each list of directions extended by each option.
pub(super) fn extended(lists: &[Vec<Vec2>], options: &[Vec2]) -> Vec<Vec<Vec2>> {
    let with_each = |list: &'_ Vec<Vec2>| -> Vec<Vec<Vec2>> {
        let longer = options
            .iter()
            .map(|&option| [&list[..], &[option]].concat());
        longer.collect()
    };
    lists.iter().flat_map(with_each).collect()
}

/// Returns the sort key of a solution: the directions of its links, from +x counter-clockwise, then
/// its joints. It depends only on the solution.
fn rank(group: &Coupled, z: &[f64]) -> Vec<i64> {
    let (joints, directions) = z.split_at(z.len() - 2 * group.turning().len());
    let angles = directions.chunks_exact(2);
    let angles = angles.map(|d| crate::angle::degrees(Vec2::new(d[0], d[1])));
    let sizes: Vec<f64> = angles.chain(joints.iter().copied()).collect();
    #[expect(
        clippy::cast_possible_truncation,
        reason = "saturates far outside any linkage"
    )]
    let places = |grain: f64| sizes.iter().map(move |v| (v / grain).round() as i64);
    ORDER_RESOLUTIONS.into_iter().flat_map(places).collect()
}
