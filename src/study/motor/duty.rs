//! A mechanism and its solver over the cycle.

use super::course::Course;
use super::cycle::{Cycle, Effect, Shaking};
use super::fitting::Fit;
use super::{Effort, Measure, marks};
use crate::scene::Motor;
use crate::solver::{Order, Range, Solver, State};
use crate::{Input, Link, LinkId, Mechanism, Vec2, angle};

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
    /// Whether the driver keeps its speed; one that does not leaves some of its work in the masses.
    pub is_steady: bool,
    /// Metres, or radians, of the unit in which the driver's speed is given.
    unit: f64,
}

impl Duty {
    /// Goes through a cycle: the period of the motion and of the loads, or the range there and back, or
    /// the part of the motion between two coordinates there and back. `None` where nothing acts.
    #[must_use]
    pub fn new(
        mechanism: &Mechanism,
        solver: &Solver,
        between: Option<(f64, f64)>,
    ) -> Option<Duty> {
        if !solver.has_forces() {
            return None;
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
        let reach = reach(mechanism) * metres;
        let (unit, joule, arm) = match driver.input {
            Input::Turn(_) => (1.0, angle::radians(1.0), reach),
            Input::Push(_) => (metres, metres, 1.0),
        };
        let measure = Measure {
            joule,
            speed: driver.speed * unit,
            arm,
            reach,
        };
        let runs_dead = course.ends_dead && has_inertia(mechanism) && driver.speed != 0.0;
        let mut source = Source::new(mechanism, solver, runs_dead);
        let marks = marks::marks(mechanism, solver, &course);
        let mut cycle = Cycle::new(course, &marks, measure, &mut |at, back| {
            source.effort(at, back)
        });
        if runs_dead {
            (cycle.all, cycle.parts[2]) = (Effect::default(), Effect::default());
        }
        if source.has_no_ground {
            cycle.shaking = Shaking::default();
        }
        let ends = [course.low, course.high];
        let dead_points = motion.dead_points.iter().filter(|at| ends.contains(at));
        Some(Duty {
            cycle,
            dead_points: dead_points.copied().collect(),
            change_points: motion.change_points.clone(),
            runs_dead,
            is_cut_short: repeats.is_none(),
            is_steady: driver.acceleration == 0.0,
            unit,
        })
    }

    /// A motor against the cycle.
    #[must_use]
    pub fn fit(&self, motor: &Motor) -> Fit {
        let speed = motor.speed.map(|speed| speed * self.unit);
        Fit::new(&self.cycle, motor.rated, motor.peak, speed)
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
    let driven = |id: LinkId| mechanism.driver().input == Input::Turn(id);
    let has_mass = |link: &Link| link.mass > 0.0 || link.inertia > 0.0;
    let mut links = mechanism.link_ids();
    links.any(|id| !driven(id) && has_mass(mechanism.link(id)))
}

/// The longest length of a link, or between its points, in the scene's unit; 1 where there is none.
fn reach(mechanism: &Mechanism) -> f64 {
    let members = mechanism.links().iter().flat_map(|link| &link.members);
    let longest = members
        .map(|member| member.local.norm())
        .fold(0.0, f64::max);
    if longest > 0.0 { longest } else { 1.0 }
}

/// Solves for what the driver must do.
struct Source {
    there: Solver,
    /// With the opposite speed.
    back: Solver,
    states: [State; 2],
    /// Without what inertia asks for.
    is_slow: bool,
    /// Somewhere the ground's force did not exist.
    has_no_ground: bool,
}

impl Source {
    fn new(mechanism: &Mechanism, solver: &Solver, is_slow: bool) -> Source {
        let driver = mechanism.driver();
        let back = solver.at_speed(-driver.speed, -driver.acceleration);
        Source {
            states: [solver.state(), back.state()],
            there: solver.clone(),
            back,
            is_slow,
            has_no_ground: false,
        }
    }

    fn effort(&mut self, at: f64, back: bool) -> Option<Effort> {
        let solver = if back { &self.back } else { &self.there };
        let state = &mut self.states[usize::from(back)];
        solver.solve(at, Order::Force, state);
        let mut parts = state.drive_parts()?;
        let mut torque = state.drive()?;
        if self.is_slow {
            parts[2] = 0.0;
            torque = parts[0] + parts[1];
        }
        let ground = state.frame_force().zip(state.frame_moment());
        self.has_no_ground |= ground.is_none();
        let (force, moment) = ground
            .filter(|_| !self.is_slow)
            .unwrap_or((Vec2::ZERO, 0.0));
        Some(Effort {
            torque,
            parts,
            force,
            moment,
        })
    }
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
