//! Evaluates a slide on its guide at any driver coordinate: its motion between dead centres, and
//! its velocity and leverage.
//!
//! Position s, derivative s' and second derivative s'' by the driver's coordinate q come from the
//! solver at a speed of 1.

use crate::angle::radians;
use crate::solver::{Condition, DeadCentre, Demand, Order, Range, Solver, Workspace};
use crate::{Input, Mechanism, SlideId};

/// The slope below which the slide does not move, relative to the stroke per radian, or per range
/// of a driven slide.
const ZERO_SLOPE: f64 = 1e-12;

/// A slide passing a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlidePassing {
    /// The driver's coordinate.
    pub at: f64,
    /// The position along the guide.
    pub position: f64,
    /// The velocity along the guide, in the scene's length unit per s.
    pub velocity: f64,
    /// The acceleration along the guide.
    pub acceleration: f64,
    /// The factor |dq/ds| in rad/m, or without unit if a slide is driven. The slide's force in
    /// equilibrium is the driver's torque or force times this factor. Infinite at a dead centre.
    pub leverage: f64,
}

/// A stretch of the driver's coordinate on which the slide's motion is monotonic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MonotoneStretch {
    pub(super) from: DeadCentre,
    pub(super) to: DeadCentre,
}

/// Evaluates a slide at any driver coordinate.
#[derive(Clone, Debug)]
pub(super) struct SlideFinder {
    solver: Solver,
    state: Workspace,
    slide: SlideId,
    pub(super) range: Range,
    /// The driver's speed and acceleration in the units of its derivatives.
    rates: [f64; 2],
    is_rotary: bool,
    /// The scene's length unit in m.
    metres: f64,
}

impl SlideFinder {
    pub(super) fn new(mechanism: &Mechanism, solver: &Solver, slide: SlideId) -> SlideFinder {
        let demand = Demand {
            slides: vec![slide],
            ..Demand::default()
        };
        let solver = solver.only(&demand).at_speed(1.0, 0.0);
        let driver = mechanism.driver();
        SlideFinder {
            state: solver.state(),
            range: solver.motion().range,
            solver,
            slide,
            rates: [driver.speed, driver.acceleration],
            is_rotary: matches!(driver.input, Input::Turn(_)),
            metres: mechanism.metres(),
        }
    }

    /// Returns the position and, if they exist, its first and second derivative by the driver's
    /// coordinate in radians or in the scene's length unit.
    pub(super) fn slide_at(&mut self, at: f64) -> Option<(f64, Option<[f64; 2]>)> {
        match self.solver.solve(at, Order::Acceleration, &mut self.state) {
            Condition::NoAssembly => None,
            Condition::Ok | Condition::ChangePoint | Condition::DeadPoint => {
                let travel = self.state.travel(self.slide)?;
                let rates = travel.rate.zip(travel.accel);
                Some((travel.position, rates.map(<[f64; 2]>::from)))
            }
        }
    }

    /// Returns `true` if the driver's coordinate decreases.
    pub(super) fn backwards(&self) -> bool {
        self.rates[0] < 0.0
    }

    /// Returns the driver's time for a travel, in s; `None` if its speed is zero.
    pub(super) fn seconds(&self, travel: f64) -> Option<f64> {
        let travel = if self.is_rotary {
            radians(travel)
        } else {
            travel
        };
        let seconds = travel / self.rates[0].abs();
        seconds.is_finite().then_some(seconds)
    }

    /// Reduces a coordinate to the first period.
    pub(super) fn wrapped(&self, at: f64) -> f64 {
        match self.range {
            Range::Full { period } => at.rem_euclid(period),
            Range::Limited { .. } => at,
        }
    }

    /// Reduces a dead centre to the first period.
    pub(super) fn reduced(&self, centre: DeadCentre) -> DeadCentre {
        DeadCentre {
            at: self.wrapped(centre.at),
            ..centre
        }
    }

    /// Returns the stretches between the dead centres, over one period or over the range.
    pub(super) fn legs(&self) -> Vec<MonotoneStretch> {
        let mut centres = self.solver.dead_centres(self.slide);
        if let (Range::Full { period }, Some(&first)) = (self.range, centres.first()) {
            centres.push(DeadCentre {
                at: first.at + period,
                ..first
            });
        }
        let legs = centres.windows(2).map(|pair| MonotoneStretch {
            from: pair[0],
            to: pair[1],
        });
        legs.collect()
    }

    /// Returns the state of the slide at a coordinate, with the driver's speed or its opposite.
    pub(super) fn passing(&mut self, at: f64, back: bool, stroke: f64) -> Option<SlidePassing> {
        let (position, rates) = self.slide_at(at)?;
        let [slope, second] = rates?;
        let span = match self.range {
            Range::Limited { low, high } if !self.is_rotary => high - low,
            Range::Limited { .. } | Range::Full { .. } => 1.0,
        };
        // A dead centre is accurate to the last digit of the coordinate; its slope counts as 0.
        let still = ZERO_SLOPE * (stroke / span).max(second.abs() * span);
        let first = if slope.abs() <= still { 0.0 } else { slope };
        let [speed, acceleration] = self.rates;
        let speed = if back { -speed } else { speed };
        Some(SlidePassing {
            at: self.wrapped(at),
            position,
            velocity: first * speed + 0.0,
            acceleration: second * speed * speed + first * acceleration,
            leverage: match self.is_rotary {
                true => 1.0 / (first * self.metres).abs(),
                false => 1.0 / first.abs(),
            },
        })
    }
}
