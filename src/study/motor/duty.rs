//! A mechanism and its solver over the cycle.

use super::course::Course;
use super::cycle::{Cycle, CycleShaking, DriveEffort};
use super::flywheel::MotorFit;
use super::source::{CycleSource, Step};
use super::{DriverUnits, marks};
use crate::quantity::Hidden;
use crate::scene::Motor;
use crate::solver::{Range, Solver};
use crate::{Input, Link, LinkId, Mechanism, angle};

/// Why there is nothing to tell of a cycle.
#[derive(Clone, Debug, PartialEq)]
pub enum NoDuty {
    /// Nothing acts on the mechanism.
    NothingActs,
    /// Forces that the cycle is made of are withheld; this is the first state of which they are.
    Withheld(Hidden),
}

/// What a mechanism asks of its driver over a cycle, and where it is singular.
#[derive(Clone, Debug)]
pub struct Duty {
    /// The figures.
    pub cycle: Cycle,
    /// Dead points at the ends of the way: there the torque may be beyond all bounds.
    pub dead_points: Vec<f64>,
    /// Change points on the way, as coordinates of one period: there the joints' forces need not exist.
    pub change_points: Vec<f64>,
    /// Whether accelerations grow beyond all bounds towards a dead point: a driver that keeps its speed
    /// cannot come there, and what inertia asks for has no integral.
    pub runs_dead: bool,
    /// Whether the loads repeat after more turns than are gone through: the cycle is the motion's alone.
    pub is_cut_short: bool,
    /// The loads whose factor over the driver's coordinate does not come again though the driver goes
    /// round, by their number from 1: the cycle is the first one.
    pub unrepeated: Vec<usize>,
    /// Whether the driver keeps its speed; one that does not leaves some of its work in the masses.
    pub is_steady: bool,
    /// Metres, or radians, of the unit in which the driver's speed is given.
    unit: f64,
    source: CycleSource,
}

impl Duty {
    /// Goes through a cycle: the period of the motion and of the loads, or the range there and back, or
    /// the part of the motion between two coordinates there and back.
    ///
    /// # Errors
    /// Where nothing acts, or where what does is withheld somewhere.
    pub fn new(
        mechanism: &Mechanism,
        solver: &Solver,
        between: Option<(f64, f64)>,
    ) -> Result<Duty, NoDuty> {
        if !solver.has_forces() {
            return Err(NoDuty::NothingActs);
        }
        let driver = mechanism.driver();
        let motion = solver.motion();
        let repeats = marks::repeats(mechanism, motion.range);
        let falls = driver.speed < 0.0;
        let course = match between {
            Some((low, high)) => Course::between(low, high, falls, &motion.dead_points),
            None => Course::new(
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
        let runs_dead = course.ends_dead && has_inertia(mechanism) && driver.speed != 0.0;
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
            return Err(NoDuty::Withheld(hidden));
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
            runs_dead,
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

    /// What the driver must do at a coordinate, as it goes there for the first time.
    #[must_use]
    pub fn step(&self, at: f64) -> Step {
        self.source.step(at, false, &mut self.source.states())
    }

    /// The cycle in equal steps of the way: each with the way gone and what was solved for there.
    pub fn steps(&self, count: u32) -> impl Iterator<Item = (f64, Step)> {
        self.source.steps(self.cycle.course, count)
    }

    /// The work of the driver in J since the beginning, after this way; `None` where what inertia asks
    /// for has no integral.
    #[must_use]
    pub fn work(&self, way: f64) -> Option<f64> {
        self.cycle.work(way).filter(|_| !self.runs_dead)
    }

    /// What the driver must do over its coordinate, in at least so many points: pairs of coordinate and
    /// torque, hanging together as far as nothing jumps.
    #[must_use]
    pub fn curve(&self, points: u32) -> Vec<Vec<[f64; 2]>> {
        if !self.runs_dead {
            return self.cycle.curve(points);
        }
        // The sums know nothing of inertia here: the states do.
        let once = 0.5 * self.cycle.course.length();
        let mut parts = vec![Vec::new()];
        for (way, step) in self.steps(2 * points) {
            if let (Some(torque), Some(part)) = (step.torque, parts.last_mut()) {
                part.push([step.at, torque]);
            }
            if step.torque.is_none() || way == once {
                parts.push(Vec::new());
            }
        }
        parts.retain(|part| !part.is_empty());
        parts
    }

    /// A motor against the cycle.
    #[must_use]
    pub fn fit(&self, motor: &Motor) -> MotorFit {
        let speed = motor.speed.map(|speed| speed * self.unit);
        MotorFit::new(&self.cycle, motor.rated, motor.peak, speed)
    }

    /// The whole turns, or ways there and back, of the driver in a cycle.
    #[must_use]
    pub fn turns(&self) -> f64 {
        let course = &self.cycle.course;
        if course.goes_round {
            course.length() / angle::TURN
        } else {
            1.0
        }
    }

    /// How long a cycle takes in s; `None` where the driver stands still.
    #[must_use]
    pub fn seconds(&self) -> Option<f64> {
        let cycle = &self.cycle;
        let way = cycle.course.length() * cycle.joule();
        let seconds = way / cycle.speed;
        seconds.is_finite().then_some(seconds)
    }
}

/// Whether anything but a driven link, which keeps its speed, resists being accelerated.
fn has_inertia(mechanism: &Mechanism) -> bool {
    let driven = |id: LinkId| mechanism.is_directed(id);
    let has_mass = |link: &Link| link.mass > 0.0 || link.inertia > 0.0;
    let mut links = mechanism.link_ids();
    links.any(|id| !driven(id) && has_mass(mechanism.link(id)))
}

/// The range of a motion holds both coordinates, and the first is below the second.
#[must_use]
pub fn is_within(range: Range, low: f64, high: f64) -> bool {
    match range {
        Range::Full { .. } => low < high,
        Range::Limited {
            low: least,
            high: most,
        } => least <= low && low < high && high <= most,
    }
}

#[cfg(test)]
#[path = "duty_tests.rs"]
mod tests;
