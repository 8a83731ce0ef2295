//! Tolerance analysis: the worst case, the root of the sum of squares, samples, and contributions.
//!
//! A length L with a tolerance t changes a value F by `dF/dL t` to first order. The root of the sum
//! of squares of these terms and their shares are of first order, with exact derivatives. The worst
//! case is that of the mechanism itself, solved at every corner of the tolerance box, or enclosed;
//! samples are solved, too.
//!
//! A pin with clearance c lies anywhere within c of its hole's centre. It has two lengths, and the
//! first order takes the worst direction.

mod band;
mod box_grid;
mod contributions;
mod corners;
mod cycle_tolerance;
mod driver_place;
mod edge;
mod machines;
mod samples;
mod search;
#[cfg(test)]
mod tests;
mod tolerance_box;
mod worst_case;

pub use band::{BandKind, Offsets};
pub use contributions::{Contribution, ToleranceOf};
pub use cycle_tolerance::MotionTolerance;
pub use samples::{Distribution, Percentiles, SampleOrder, Samples};
pub use worst_case::{WorstCase, WorstKind};

use crate::Tolerances;
use crate::quantity::{Quantity, Sensitivity, demand};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::wording::words;
use contributions::Slopes;
use driver_place::MachinesAtPlace;
use thiserror::Error;
use tolerance_box::ToleranceBox;

/// The reason why an analysis is impossible.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ToleranceError {
    /// All lengths are exact.
    #[error("{}", words().no_tolerances())]
    Exact,
    /// A redundant linkage jams when a length deviates.
    #[error("{}", words().redundant_jams())]
    Redundant,
    /// Forces are not supported.
    #[error("{}", words().no_tolerances_of_forces())]
    Forces,
}

/// The effect of tolerances on a value at one coordinate of the driver.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceFigure {
    /// The value with the nominal lengths.
    pub nominal: f64,
    /// The minimum and maximum of the value.
    pub worst: WorstCase,
    /// The root of the sum of squares; `None` if derivatives do not exist.
    pub root_sum_square: Option<f64>,
    /// The contributions, the largest first; empty if derivatives do not exist.
    pub contributions: Vec<Contribution>,
}

impl ToleranceFigure {
    /// Widens the worst case by samples within the tolerances that exceed it.
    pub fn with_samples(&mut self, order: SampleOrder, found: &Percentiles) {
        match order.distribution {
            Distribution::Even => self.worst = self.worst.widened(found.ends),
            // Some samples lie beyond the tolerances.
            Distribution::Normal => {}
        }
    }
}

/// Values of a mechanism with deviating lengths.
#[derive(Clone, Debug)]
pub struct ToleranceStudy {
    machines: MachinesAtPlace,
    slopes: Sensitivity,
    off: ToleranceBox,
}

impl ToleranceStudy {
    /// Creates an analysis of values of a scene.
    ///
    /// # Errors
    /// Returns an error if an analysis is impossible, see [`ToleranceError`].
    pub fn new(
        scene: &Scene,
        solver: &Solver,
        tolerances: &Tolerances,
        quantities: &[Quantity],
    ) -> Result<ToleranceStudy, ToleranceError> {
        let off = ToleranceBox::new(tolerances).ok_or(ToleranceError::Exact)?;
        let (demand, order) = demand(quantities);
        if demand.forces {
            return Err(ToleranceError::Forces);
        }
        let varied = solver
            .varied(&off.given, &demand)
            .ok_or(ToleranceError::Redundant)?;
        Ok(ToleranceStudy {
            machines: MachinesAtPlace::new(quantities.to_vec(), order, varied),
            slopes: Sensitivity::by(scene, solver, quantities, off.given.clone()),
            off,
        })
    }

    /// Returns the analysed values.
    #[must_use]
    pub fn figures(&self) -> &[Quantity] {
        &self.machines.figures
    }

    /// Returns the values that differ between machines at a coordinate, to first order.
    pub fn moved(&mut self, at: f64) -> Vec<Quantity> {
        let slopes = self.slopes_at(at);
        let moves = |i: usize| {
            let slopes = slopes.as_ref().and_then(|slopes| slopes.of(i));
            slopes.is_none_or(|slopes| self.off.root_sum_square(slopes) > 0.0)
        };
        let all = self.figures().iter().enumerate();
        let moved = all.filter(|&(i, _)| moves(i));
        moved.map(|(_, quantity)| quantity.clone()).collect()
    }

    /// Analyses every value at a coordinate; `None` for one that does not exist there.
    pub fn at(&mut self, at: f64) -> Vec<Option<ToleranceFigure>> {
        let nominal = self.machines.go(at);
        let slopes = self.slopes_at(at);
        let worst = self.worst(at, &nominal, slopes.as_ref(), corners::THOROUGH);
        machines::tolerance_effects(&self.off, &nominal, worst, |i| slopes.as_ref()?.of(i))
    }

    /// Builds random machines, and evaluates every value of each at a coordinate of the driver.
    pub fn sampled(&mut self, at: f64, order: SampleOrder) -> Samples {
        let nominal = self.machines.go(at);
        let kind = self.machines.varied.kind();
        Samples::of(&mut self.machines, &self.off, nominal.len(), kind, order)
    }

    /// Returns for every value the root of the sum of squares and the contributions, the largest
    /// first; `None` if derivatives do not exist. Computes the first order only.
    pub fn first_order(&mut self, at: f64) -> Vec<Option<(f64, Vec<Contribution>)>> {
        let slopes = self.slopes_at(at);
        let figure = |i| {
            let slopes = slopes.as_ref()?.of(i)?;
            Some((
                self.off.root_sum_square(slopes),
                self.off.contributions(slopes),
            ))
        };
        (0..self.figures().len()).map(figure).collect()
    }

    /// Returns the derivatives by all deviations.
    fn slopes_at(&mut self, at: f64) -> Option<Slopes> {
        self.slopes.at(at)
    }
}
