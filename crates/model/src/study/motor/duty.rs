//! The driving torque of a mechanism over a cycle.

use super::cycle::{Cycle, CycleShaking, DriveEffort};
use super::cycle_travel::CyclePath;
use super::flywheel::MotorFit;
use super::source::{CycleSource, Step};
use super::{DriverUnits, marks};
use crate::quantity::Hidden;
use crate::scene::Motor;
use crate::solver::{Range, Solver};
use crate::{Input, Link, LinkId, Mechanism, angle};

/// The reason why a cycle has no results.
#[derive(Clone, Debug, PartialEq)]
pub enum DutyError {
    /// The scene has no loads, springs or masses.
    NothingActs,
    /// Forces of the cycle are not shown; this is the first state concerned.
    WithheldReason(Hidden),
}

/// The driving torque of a mechanism over a cycle, with its singularities.
#[derive(Clone, Debug)]
pub struct Duty {
    /// The results.
    pub cycle: Cycle,
    /// Dead points at the ends of the travel, where the torque may be unbounded.
    pub dead_points: Vec<f64>,
    /// Change points in one period, where the joint forces need not exist.
    pub change_points: Vec<f64>,
    /// `true` if accelerations grow without bound towards a dead point: a driver of constant speed
    /// cannot reach it, and the work of inertia forces has no integral.
    pub reaches_dead_point: bool,
    /// `true` if the loads repeat only after too many turns: the cycle is that of the motion alone.
    pub is_cut_short: bool,
    /// The loads, by number from 1, whose factor over the driver's coordinate is not periodic
    /// although the driver turns fully; the cycle is the first one.
    pub unrepeated: Vec<usize>,
    /// `true` if the driver's speed is constant; if not, some of its work stays in the masses.
    pub is_steady: bool,
    /// The unit of the driver's speed in metres or radians.
    unit: f64,
    source: CycleSource,
}

impl Duty {
    /// Analyses a cycle: the period of the motion and of the loads, or the range to and fro. With
    /// `between`, it is the part of the motion between two coordinates to and fro.
    ///
    /// # Errors
    /// Returns an error if the scene has no loads, springs or masses, or if forces are not shown in
    /// a state.
    pub fn new(
        mechanism: &Mechanism,
        solver: &Solver,
        between: Option<(f64, f64)>,
    ) -> Result<Duty, DutyError> {
        if !solver.has_forces() {
            return Err(DutyError::NothingActs);
        }
        let driver = mechanism.driver();
        let motion = solver.motion();
        let repeats = marks::repeats(mechanism, motion.range);
        let falls = driver.speed < 0.0;
        let course = match between {
            Some((low, high)) => CyclePath::between(low, high, falls, &motion.dead_points),
            None => CyclePath::new(
                motion.range,
                repeats.unwrap_or(1),
                falls,
                &motion.dead_points,
            ),
        };
        let metres = mechanism.metres();
        let reach = mechanism.reach() * metres;
        let (unit, joule, arm) = match driver.input {
            Input::Turn(_) => (1.0, angle::radians(1.0), reach),
            Input::Push(_) => (metres, metres, 1.0),
        };
        let measure = DriverUnits {
            joule,
            speed: driver.speed * unit,
            arm,
            reach,
        };
        let runs_dead = course.ends_at_dead_point && has_inertia(mechanism) && driver.speed != 0.0;
        let source = CycleSource::new(mechanism, solver);
        let (mut states, mut has_no_ground) = (source.states(), false);
        let mut withheld = None;
        let marks = marks::marks(mechanism, solver, &course);
        let mut cycle = Cycle::new(course, &marks, measure, &mut |at, back| {
            let step = source.step(at, back, &mut states);
            has_no_ground |= step.ground.is_none();
            if withheld.is_none() {
                withheld = Hidden::of_forces(&states[usize::from(back)]);
            }
            step.effort(runs_dead)
        });
        if let Some(hidden) = withheld {
            return Err(DutyError::WithheldReason(hidden));
        }
        if runs_dead {
            (cycle.all, cycle.parts[2]) = (DriveEffort::default(), DriveEffort::default());
        }
        if has_no_ground {
            cycle.shaking = CycleShaking::default();
        }
        let ends = [course.low, course.high];
        let dead_points = motion.dead_points.iter().filter(|at| ends.contains(at));
        Ok(Duty {
            cycle,
            dead_points: dead_points.copied().collect(),
            change_points: motion.change_points.clone(),
            reaches_dead_point: runs_dead,
            is_cut_short: repeats.is_none(),
            is_steady: driver.acceleration == 0.0,
            unit,
            unrepeated: match motion.range {
                Range::Full { .. } if between.is_none() => marks::unrepeated(mechanism),
                Range::Full { .. } | Range::Limited { .. } => Vec::new(),
            },
            source,
        })
    }

    /// Returns the driving torque at a coordinate, in the direction of the given speed.
    #[must_use]
    pub fn step(&self, at: f64) -> Step {
        self.source.step(at, false, &mut self.source.states())
    }

    /// Returns the cycle in equal steps of the travel; each with its travel and the solved step.
    pub fn steps(&self, count: u32) -> impl Iterator<Item = (f64, Step)> {
        self.source.steps(self.cycle.course, count)
    }

    /// Returns the driver's work in J from the beginning to this travel; `None` if the work of
    /// inertia forces has no integral.
    #[must_use]
    pub fn work(&self, travel: f64) -> Option<f64> {
        self.cycle.work(travel).filter(|_| !self.reaches_dead_point)
    }

    /// Returns the torque over the driver's coordinate in at least `points` points: pairs of
    /// coordinate and torque, split at jumps.
    #[must_use]
    pub fn curve(&self, points: u32) -> Vec<Vec<[f64; 2]>> {
        if !self.reaches_dead_point {
            return self.cycle.curve(points);
        }
        // The sums have no inertia here, so the states are solved instead.
        let once = 0.5 * self.cycle.course.length();
        let mut parts = vec![Vec::new()];
        for (travel, step) in self.steps(2 * points) {
            if let (Some(torque), Some(part)) = (step.torque, parts.last_mut()) {
                part.push([step.at, torque]);
            }
            if step.torque.is_none() || travel == once {
                parts.push(Vec::new());
            }
        }
        parts.retain(|part| !part.is_empty());
        parts
    }

    /// Compares a motor with the cycle.
    #[must_use]
    pub fn fit(&self, motor: &Motor) -> MotorFit {
        let speed = motor.speed.map(|speed| speed * self.unit);
        MotorFit::new(&self.cycle, motor.rated, motor.peak, speed)
    }

    /// Returns the number of the driver's full turns in a cycle; 1 for a motion to and fro.
    #[must_use]
    pub fn turns(&self) -> f64 {
        let course = &self.cycle.course;
        if course.is_periodic {
            course.length() / angle::TURN
        } else {
            1.0
        }
    }

    /// Returns the duration of a cycle in s; `None` if the driver's speed is zero.
    #[must_use]
    pub fn seconds(&self) -> Option<f64> {
        let cycle = &self.cycle;
        let travel = cycle.course.length() * cycle.joule();
        let seconds = travel / cycle.speed;
        seconds.is_finite().then_some(seconds)
    }
}

/// Returns `true` if a link other than the driven one, whose speed is constant, has mass or
/// inertia.
fn has_inertia(mechanism: &Mechanism) -> bool {
    let driven = |id: LinkId| mechanism.is_directed(id);
    let has_mass = |link: &Link| link.mass > 0.0 || link.inertia > 0.0;
    let mut links = mechanism.link_ids();
    links.any(|id| !driven(id) && has_mass(mechanism.link(id)))
}

/// Returns `true` if the range of a motion contains both coordinates, and the first is below the
/// second.
#[must_use]
pub fn is_within(range: Range, low: f64, high: f64) -> bool {
    match range {
        Range::Full { .. } => low < high,
        Range::Limited {
            low: minimum,
            high: maximum,
        } => minimum <= low && low < high && high <= maximum,
    }
}

#[cfg(test)]
#[path = "duty_tests.rs"]
mod tests;
