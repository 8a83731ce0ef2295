//! Evaluates a proposal by driving it through its task.

use super::defects::{GivenMotion, TaskDefect, crank_motion};
use super::functions::FunctionRun;
use super::machine::Machine;
use super::output_misses::OutputMisses;
use super::{PathTask, PinConstraint, PoseTask, Preferences, Proposal, Sense, Task, TaskKind};
use kinematics::Vec2;
use kinematics::angle::{TURN, degrees, unit, unwrap_near};
use kinematics::solver::{Condition, Order, Range};

/// Tolerance between the solver's pin and the proposal's pin, relative to the linkage's size. Also
/// the tolerance of a pose that must be met exactly: relative to the size for its position, in
/// radians for its angle.
const EQUALITY_TOLERANCE: f64 = 1e-7;
/// Maximum distance between a path's led point and a wanted point, relative to the path's size.
/// Beyond it, the linkage follows another path.
const MAX_RELATIVE_MISS: f64 = 0.05;
/// Linkages that differ by less than this fraction of their size count as one.
const ONE: f64 = 1e-6;

/// A linkage and how well it does its task.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// The linkage, with the driven crank on A.
    pub proposal: Proposal,
    /// The crank's angle at every point, in degrees, counted continuously in the order of the task.
    pub at: Vec<f64>,
    /// The reasons why the linkage does not do its task; empty if it does.
    pub defects: Vec<TaskDefect>,
    /// The preferences that the linkage does not meet.
    pub missed: Vec<UnmetPreference>,
    /// Further values of the linkage.
    pub figures: CandidateFigures,
}

/// Values of a candidate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CandidateFigures {
    /// Whether the crank turns fully.
    pub full_turn: bool,
    /// The minimum transmission angle over the task, in degrees: from the first point to the last,
    /// over the whole range of a formula, or over a whole turn for a closed path.
    pub transmission: f64,
    /// The minimum transmission angle of the whole motion, in degrees: over a whole turn, or from
    /// stop to stop. It is 0 if the crank only swings, from dead point to dead point.
    pub min_transmission: f64,
    /// The ratio of the longest length to the shortest, including the ground's length.
    pub ratio: f64,
    /// The maximum miss of the led point, or of the output, over the reached points; for a formula,
    /// over its whole range.
    pub miss: f64,
    /// The root mean square of the misses, with the weights of the points.
    pub rms: f64,
    /// The maximum miss of the body's angle, in degrees; 0 except for poses.
    pub angle_miss: f64,
}

/// A preference that a candidate does not meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnmetPreference {
    /// The crank does not turn fully.
    FullTurn,
    /// The transmission angle is below the wanted minimum.
    Transmission,
    /// A pivot lies outside the given box.
    Inside,
    /// The ratio of the lengths exceeds the wanted maximum.
    Ratio,
    /// The crank turns in the opposite sense.
    Sense,
}

impl Candidate {
    /// Drives a proposal through the task, both as proposed and at its other pivot, and returns the
    /// better candidate.
    #[must_use]
    pub fn evaluate(task: &Task, proposal: &Proposal) -> Candidate {
        let own = Candidate::driven(task, proposal.clone());
        // A task that gives the crank's angles also determines which link is the crank.
        let is_given = match &task.kind {
            TaskKind::Function(_) => true,
            TaskKind::Path(path) => path.turns.is_some(),
            TaskKind::Poses(_) => false,
        };
        match proposal.swapped() {
            Some(swapped) if !is_given => {
                let other = Candidate::driven(task, swapped);
                match other.sort_key() < own.sort_key() {
                    true => other,
                    false => own,
                }
            }
            _ => own,
        }
    }

    fn driven(task: &Task, proposal: Proposal) -> Candidate {
        let opened = match proposal.places.len() == task.points() {
            true => Machine::open(task, &proposal),
            false => None,
        };
        let Some(machine) = opened else {
            return Candidate {
                at: Vec::new(),
                defects: vec![TaskDefect::Unopened],
                missed: Vec::new(),
                figures: CandidateFigures::default(),
                proposal,
            };
        };
        let range = machine.solver.motion().range;
        let run = match &task.kind {
            TaskKind::Function(function) => FunctionRun::of(function, &proposal),
            TaskKind::Poses(_) | TaskKind::Path(_) => None,
        };
        let way = given_way(task, &proposal, run.as_ref());
        let (at, mut defects) = crank_motion(&proposal, range, &task.preferences, &way);
        let mut figures = CandidateFigures {
            full_turn: matches!(range, Range::Full { .. }),
            transmission: min_transmission(&proposal, way_ends(task, &at, run.as_ref(), range)),
            min_transmission: min_transmission(
                &proposal,
                match range {
                    Range::Full { .. } => (0.0, TURN),
                    Range::Limited { low, high } => (low, high),
                },
            ),
            ratio: proposal.ratio(),
            ..CandidateFigures::default()
        };
        // Points in another assembly already have a defect.
        let reach = defects.iter().filter_map(TaskDefect::place).min();
        let points = reach.unwrap_or(at.len());
        let drive = TaskDrive {
            task,
            proposal: &proposal,
            machine: &machine,
        };
        match drive.measure(&at[..points], &mut figures) {
            Err(point) => defects.push(TaskDefect::Missed { point }),
            Ok(Some(point)) if defects.is_empty() => defects.push(TaskDefect::Far { point }),
            Ok(_) => {}
        }
        if let TaskKind::Function(function) = &task.kind {
            match run.and_then(|run| OutputMisses::of(function, &run)) {
                Some(misses) => {
                    (figures.miss, figures.rms) = (misses.worst, misses.rms);
                    // On another branch, the miss follows from the branch defect.
                    if defects.is_empty() && !misses.follows() {
                        defects.push(TaskDefect::StructuralError);
                    }
                }
                None if defects.is_empty() => defects.push(TaskDefect::Short),
                None => {}
            }
        }
        let missed = missed(&task.preferences, &proposal, &at, &figures);
        Candidate {
            proposal,
            at,
            defects,
            missed,
            figures,
        }
    }

    /// Returns `true` if the linkage does its task.
    #[must_use]
    pub fn meets_task(&self) -> bool {
        self.defects.is_empty()
    }

    /// Returns the sorting key, lower is better: the numbers of defects and of unmet preferences,
    /// whether the crank only swings, and the negative transmission angle.
    fn sort_key(&self) -> (usize, usize, bool, f64) {
        let CandidateFigures {
            full_turn,
            transmission,
            ..
        } = self.figures;
        (
            self.defects.len(),
            self.missed.len(),
            !full_turn,
            -transmission,
        )
    }

    /// Returns `true` if both candidates are the same linkage up to rounding.
    #[must_use]
    pub fn is_same(&self, other: &Candidate) -> bool {
        let same = |a: &Proposal, b: &Proposal| {
            let slack = ONE * a.longest().max(b.longest());
            let near = |a: Vec2, b: Vec2| (a - b).norm() <= slack;
            let held = match (a.partner, b.partner) {
                (PinConstraint::Rocker(a), PinConstraint::Rocker(b)) => near(a, b),
                (PinConstraint::Slide(a), PinConstraint::Slide(b)) => {
                    (unit(a).cross(unit(b))).abs() <= ONE
                }
                (PinConstraint::Rocker(_), PinConstraint::Slide(_))
                | (PinConstraint::Slide(_), PinConstraint::Rocker(_)) => false,
            };
            let first = a.places.first().zip(b.places.first());
            held && near(a.pivot, b.pivot)
                && first.is_some_and(|(a, b)| near(a[0], b[0]) && near(a[1], b[1]))
        };
        same(&self.proposal, &other.proposal)
            || other
                .proposal
                .swapped()
                .is_some_and(|other| same(&self.proposal, &other))
    }
}

impl TaskDefect {
    /// Returns the first point that the linkage does not reach.
    #[must_use]
    pub fn place(&self) -> Option<usize> {
        match self {
            TaskDefect::Unopened => Some(0),
            // In a closed path, the change may be between the last point and the first.
            TaskDefect::Branch { from, to } | TaskDefect::Circuit { from, to } => {
                (from < to).then_some(*to)
            }
            TaskDefect::Missed { point } => Some(*point),
            TaskDefect::Order { .. }
            | TaskDefect::Short
            | TaskDefect::StructuralError
            | TaskDefect::Far { .. } => None,
        }
    }
}

/// A linkage driven through a task.
struct TaskDrive<'a> {
    task: &'a Task,
    proposal: &'a Proposal,
    machine: &'a Machine,
}

impl TaskDrive<'_> {
    /// Measures the misses at all points by the solver's values alone, and writes them to
    /// `figures`.
    ///
    /// Returns the point of a path with the largest weighted miss if that miss exceeds `MAX_RELATIVE_MISS`
    /// times the path's size.
    ///
    /// # Errors
    /// The point at which the solver does not find the linkage where it was proposed, or the body
    /// in its pose.
    fn measure(&self, at: &[f64], figures: &mut CandidateFigures) -> Result<Option<usize>, usize> {
        let Machine {
            solver,
            c,
            tracer,
            coupler,
            ..
        } = self.machine;
        let mut state = solver.state();
        let size = self.proposal.longest();
        let mut turned_from = 0.0;
        let mut squares = 0.0;
        let mut weights = 0.0;
        // A miss counts by the root of its weight, as in the mean square.
        let mut farthest = (None, MAX_RELATIVE_MISS * self.task.size());
        for (point, &at) in at.iter().enumerate() {
            if solver.solve(at, Order::Position, &mut state) == Condition::NoAssembly {
                return Err(point);
            }
            let c = state.position(*c).ok_or(point)?;
            let guided = || tracer.and_then(|id| state.position(id)).ok_or(point);
            if !((c - self.proposal.places[point][1]).norm() <= EQUALITY_TOLERANCE * size) {
                return Err(point);
            }
            let angle = state.angle(*coupler).ok_or(point)?;
            if point == 0 {
                turned_from = angle;
            }
            let (miss, angle_miss, weight) = match &self.task.kind {
                TaskKind::Poses(PoseTask { poses, .. }) => {
                    let target = poses[point].angle - poses[0].angle;
                    let off = unwrap_near(0.0, angle - turned_from - target).abs();
                    let p = guided()?;
                    let miss = (p - poses[point].at).norm();
                    let met = EQUALITY_TOLERANCE * size.max(self.task.size());
                    if !(miss <= met && off <= EQUALITY_TOLERANCE.to_degrees()) {
                        return Err(point);
                    }
                    (miss, off, 1.0)
                }
                TaskKind::Path(PathTask {
                    points, weights, ..
                }) => {
                    let p = guided()?;
                    let weight = weights.get(point).copied().unwrap_or(1.0);
                    let maximum = weights.iter().copied().fold(weight, f64::max);
                    let counts = (weight / maximum).sqrt() * (p - points[point]).norm();
                    if counts > farthest.1 {
                        farthest = (Some(point), counts);
                    }
                    ((p - points[point]).norm(), 0.0, weight)
                }
                // Measured over the whole range by the caller.
                TaskKind::Function(_) => (0.0, 0.0, 1.0),
            };
            figures.miss = figures.miss.max(miss);
            figures.angle_miss = figures.angle_miss.max(angle_miss);
            squares += weight * miss * miss;
            weights += weight;
        }
        figures.rms = if weights > 0.0 {
            (squares / weights).sqrt()
        } else {
            0.0
        };
        Ok(farthest.0)
    }
}

/// Returns the crank's motion as far as the task gives it.
fn given_way(task: &Task, proposal: &Proposal, run: Option<&FunctionRun>) -> GivenMotion {
    let first = proposal.places.first();
    let start = first.map_or(0.0, |[b, _]| degrees(*b - proposal.pivot));
    match &task.kind {
        TaskKind::Poses(_) => GivenMotion::default(),
        TaskKind::Function(task) => GivenMotion {
            turned: run.map(|run| task.pairs.iter().map(|[x, _]| run.crank(*x)).collect()),
            closed: false,
        },
        TaskKind::Path(task) => GivenMotion {
            turned: task
                .turns
                .as_ref()
                .map(|turns| turns.iter().map(|turn| start + turn).collect()),
            closed: task.closed,
        },
    }
}

/// Returns the crank's minimum and maximum angle over the task, in degrees.
fn way_ends(task: &Task, at: &[f64], run: Option<&FunctionRun>, range: Range) -> (f64, f64) {
    let way: Vec<f64> = match (&task.kind, run, range) {
        // Only the run's own count applies: `at` may count from another turn.
        (TaskKind::Function(task), Some(run), _) => {
            let pairs = task.pairs.iter().chain(&task.between);
            pairs.map(|[x, _]| run.crank(*x)).collect()
        }
        (TaskKind::Path(PathTask { closed: true, .. }), _, Range::Full { .. }) => {
            let again = at.first().map(|first| first + TURN);
            at.iter().copied().chain(again).collect()
        }
        _ => at.to_vec(),
    };
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    way.into_iter()
        .fold(ends, |(low, high), angle| (low.min(angle), high.max(angle)))
}

/// Returns the minimum angle between coupler and rocker, or between coupler and the guide's normal,
/// in degrees, over a range of crank angles.
///
/// Its extrema are at the range's ends, and where the crank lies on the line of the pivots or is
/// perpendicular to the guide.
fn min_transmission(proposal: &Proposal, (low, high): (f64, f64)) -> f64 {
    let Some((crank, coupler, rocker)) = proposal.lengths() else {
        return 0.0;
    };
    let line = match proposal.partner {
        PinConstraint::Rocker(d) => degrees(d - proposal.pivot),
        PinConstraint::Slide(angle) => angle + TURN / 4.0,
    };
    let turns = (0..2).flat_map(|half| {
        let first = ((low - line) / TURN * 2.0).ceil();
        let place = line + (first + f64::from(half)) * TURN / 2.0;
        (place <= high).then_some(place)
    });
    let angle = |at: f64| {
        let b = proposal.pivot + unit(at) * crank;
        let cosine = match (proposal.partner, rocker) {
            (PinConstraint::Rocker(d), Some(rocker)) => {
                let across = (d - b).norm2();
                (coupler * coupler + rocker * rocker - across) / (2.0 * coupler * rocker)
            }
            (PinConstraint::Slide(angle), _) => {
                let c = proposal.places.first().map_or(b, |place| place[1]);
                (c - b).cross(unit(angle)) / coupler
            }
            (PinConstraint::Rocker(_), None) => 1.0,
        };
        cosine.abs().min(1.0).acos().to_degrees()
    };
    turns.chain([low, high]).map(angle).fold(90.0, f64::min)
}

fn missed(
    preferences: &Preferences,
    proposal: &Proposal,
    at: &[f64],
    figures: &CandidateFigures,
) -> Vec<UnmetPreference> {
    let mut missed = Vec::new();
    let mut preference = |kept: bool, preference: UnmetPreference| {
        if !kept {
            missed.push(preference);
        }
    };
    preference(
        !preferences.full_turn || figures.full_turn,
        UnmetPreference::FullTurn,
    );
    let minimum = preferences.transmission.unwrap_or(0.0);
    preference(
        figures.transmission >= minimum,
        UnmetPreference::Transmission,
    );
    if let Some(corners) = preferences.inside {
        let within = |p: Vec2| is_inside(corners, p);
        let is_inside = within(proposal.pivot) && proposal.partner.pivot().is_none_or(within);
        preference(is_inside, UnmetPreference::Inside);
    }
    let maximum = preferences.ratio.unwrap_or(f64::INFINITY);
    preference(figures.ratio <= maximum, UnmetPreference::Ratio);
    // If the points have no order, the crank may reach each from either side.
    let sense = preferences.sense.filter(|_| preferences.ordered);
    if let (Some(sense), Some(first), Some(last)) = (sense, at.first(), at.last()) {
        let is_rotary = match sense {
            Sense::CounterClockwise => last >= first,
            Sense::Clockwise => last <= first,
        };
        preference(is_rotary, UnmetPreference::Sense);
    }
    missed
}

/// Returns `true` if a point lies in the box of two opposite corners.
#[must_use]
pub fn is_inside([one, other]: [Vec2; 2], p: Vec2) -> bool {
    let between = |v: f64, a: f64, b: f64| a.min(b) <= v && v <= a.max(b);
    between(p.x, one.x, other.x) && between(p.y, one.y, other.y)
}
