//! A slide on its guide, wherever the driver is: between which dead centres it goes, and how it passes.
//!
//! Position s, derivative s' and second derivative s'' by the driver's coordinate q come from the solver
//! at a speed of 1.

use crate::angle::radians;
use crate::solver::{Condition, DeadCentre, Demand, Order, Range, Solver, Workspace};
use crate::{Input, Mechanism, SlideId};

/// Within this part of the stroke per radian, or per range of a driven slide, the ram does not move.
const STILL: f64 = 1e-12;

/// A ram where it passes a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passing {
    /// The driver's coordinate.
    pub at: f64,
    /// The position along the guide.
    pub position: f64,
    /// Its velocity along the guide, in the scene's length unit per s.
    pub velocity: f64,
    /// Its acceleration along the guide.
    pub acceleration: f64,
    /// |dq/ds| in rad/m, or without a unit where a slide is driven: what a torque or force of the driver
    /// is multiplied by for the force of the ram that holds it in balance. Infinite at a dead centre.
    pub leverage: f64,
}

/// A stretch of the driver's coordinate on which a slide goes one way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MonotoneStretch {
    pub(super) from: DeadCentre,
    pub(super) to: DeadCentre,
}

/// Solves for a slide wherever the driver is.
#[derive(Clone, Debug)]
pub(super) struct SlideFinder {
    solver: Solver,
    state: Workspace,
    slide: SlideId,
    pub(super) range: Range,
    /// The driver's speed and acceleration in the units of its derivatives.
    rates: [f64; 2],
    turns: bool,
    /// Lengths of the scene in m.
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
            turns: matches!(driver.input, Input::Turn(_)),
            metres: mechanism.metres(),
        }
    }

    /// Position, and where they exist the first and second derivative by the driver's coordinate in
    /// radians or in the scene's length unit.
    pub(super) fn look(&mut self, at: f64) -> Option<(f64, Option<[f64; 2]>)> {
        match self.solver.solve(at, Order::Acceleration, &mut self.state) {
            Condition::NoAssembly => None,
            Condition::Ok | Condition::ChangePoint | Condition::DeadPoint => {
                let travel = self.state.travel(self.slide)?;
                let rates = travel.rate.zip(travel.accel);
                Some((travel.position, rates.map(<[f64; 2]>::from)))
            }
        }
    }

    /// Whether the driver's coordinate becomes less.
    pub(super) fn backwards(&self) -> bool {
        self.rates[0] < 0.0
    }

    /// How long the driver takes for a way, in s.
    pub(super) fn seconds(&self, way: f64) -> Option<f64> {
        let way = if self.turns { radians(way) } else { way };
        let seconds = way / self.rates[0].abs();
        seconds.is_finite().then_some(seconds)
    }

    /// A coordinate within the first period.
    pub(super) fn wrapped(&self, at: f64) -> f64 {
        match self.range {
            Range::Full { period } => at.rem_euclid(period),
            Range::Limited { .. } => at,
        }
    }

    /// A dead centre within the first period.
    pub(super) fn reduced(&self, centre: DeadCentre) -> DeadCentre {
        DeadCentre {
            at: self.wrapped(centre.at),
            ..centre
        }
    }

    /// The stretches between its dead centres, over one period or over the range.
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

    /// The slide at a coordinate, with the driver's speed or on the way back.
    pub(super) fn passing(&mut self, at: f64, back: bool, stroke: f64) -> Option<Passing> {
        let (position, rates) = self.look(at)?;
        let [slope, second] = rates?;
        let span = match self.range {
            Range::Limited { low, high } if !self.turns => high - low,
            Range::Limited { .. } | Range::Full { .. } => 1.0,
        };
        // A dead centre is known to the last digit of the coordinate, and there the slope is 0.
        let still = STILL * (stroke / span).max(second.abs() * span);
        let first = if slope.abs() <= still { 0.0 } else { slope };
        let [speed, acceleration] = self.rates;
        let speed = if back { -speed } else { speed };
        Some(Passing {
            at: self.wrapped(at),
            position,
            velocity: first * speed + 0.0,
            acceleration: second * speed * speed + first * acceleration,
            leverage: match self.turns {
                true => 1.0 / (first * self.metres).abs(),
                false => 1.0 / first.abs(),
            },
        })
    }
}
