//! Changes the speed of the driver without solving the geometry again.

use super::engine::rates;
use super::state::{Rates, State};
use super::{Solver, Workspace};
use crate::{Constant, DriverMoment, Input, Number};

/// A degree in radians, rounded up.
const RADIAN: f64 = 0.017_453_292_519_943_3;

impl Solver {
    /// Returns a copy of the solver with another speed and acceleration of its driver, in rad/s and
    /// rad/s^2, or in the scene's length unit per s and s^2. The geometry is not solved again. With
    /// a speed of 1 and no acceleration the rates are derivatives by the driver's coordinate. With
    /// the opposite speed they are those of the reverse motion.
    #[must_use]
    pub fn at_speed(&self, speed: f64, acceleration: f64) -> Solver {
        let mechanism = self.mechanism.at_speed(speed, acceleration);
        let engine = self.engine.at_speed_of(&mechanism);
        Solver {
            mechanism,
            ..self.with_engine(engine)
        }
    }

    /// Sets the driver's speed and acceleration to those of a moment of its motion over time,
    /// starting with the next solution. An enclosure needs the same call for its own workspace.
    /// Allocates nothing.
    pub fn drive<T: Number>(&self, workspace: &mut Workspace<T>, moment: &DriverMoment) {
        let given = [moment.speed, moment.acceleration];
        let [at, off @ ..] = moment.off;
        let (rates, off) = match self.mechanism.driver().input {
            Input::Turn(_) => (
                rates(given.map(f64::to_radians), 1.0, true),
                off.map(|off| off * RADIAN),
            ),
            Input::Push(_) => {
                let scale = self.engine.frame.scale;
                (rates(given, scale, true), off.map(|off| off / scale))
            }
        };
        let rates = [rates[0].widened(off[0]), rates[1].widened(off[1])];
        workspace.errors.driven = at;
        workspace.state.pass(rates);
        // The states that the bounds are computed from need the same rates.
        if let Some(sharp) = &mut workspace.errors.sharp {
            sharp.state.pass(rates);
        }
        if let Some(edge) = &mut workspace.errors.edge {
            edge.pass(rates);
        }
        if let Some(close) = &mut workspace.close {
            close.pass(rates);
        }
    }
}

impl<T: Number> State<T> {
    /// Sets the driver's speed and acceleration, in the solver's units.
    pub(super) fn pass(&mut self, [speed, acceleration]: [Constant; 2]) {
        self.rates = Rates::new(speed, acceleration);
        self.length_rates = self.rates.times(self.frame.scale);
    }
}
