//! What tolerances do to figures: the worst case, the root of the sum of squares, samples, and who contributes what.
//!
//! A length L that is off by t at the most does `dF/dL t` to a figure F at the first order. The root of the sum of
//! squares of these and their shares are of first order, from exact derivatives. The worst case is that of the
//! mechanism itself, solved at every corner of the box of lengths, or enclosed; samples are solved, too.
//!
//! A pin of clearance c lies anywhere within c of the middle of its hole: two lengths, of which the first order takes
//! the worst direction.

mod band;
mod box_grid;
mod contributions;
mod corners;
mod edge;
mod machines;
mod place;
mod samples;
mod search;
#[cfg(test)]
mod tests;
mod tolerance_box;
mod whole;
mod worst;

pub use band::{BandKind, Offsets};
pub use contributions::{Contribution, ToleranceOf};
pub use samples::{Distribution, Percentiles, SampleOrder, Samples};
pub use whole::WholeTolerance;
pub use worst::{WorstCase, WorstKind};

use crate::Tolerances;
use crate::quantity::{Quantity, Sensitivity, demand};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::wording::words;
use contributions::Slopes;
use place::MachinesAtPlace;
use thiserror::Error;
use tolerance_box::ToleranceBox;

/// Why there is nothing to say.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum NoTolerance {
    /// Every length is exact.
    #[error("{}", words().no_tolerances())]
    Exact,
    /// A redundant linkage jams when a length is off.
    #[error("{}", words().redundant_jams())]
    Redundant,
    /// Forces are not among the figures that it can tell of.
    #[error("{}", words().no_tolerances_of_forces())]
    Forces,
}

/// What tolerances do to a figure at one coordinate of the driver.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceFigure {
    /// The figure with the lengths as they were given.
    pub nominal: f64,
    /// The least and the greatest that it can be.
    pub worst: WorstCase,
    /// The root of the sum of squares, where derivatives exist.
    pub root_sum_square: Option<f64>,
    /// Who contributes, the greatest first; none where derivatives do not exist.
    pub contributions: Vec<Contribution>,
}

impl ToleranceFigure {
    /// The same with what samples tell: machines within the tolerances widen the worst case where they go further.
    pub(crate) fn with_samples(&mut self, order: SampleOrder, found: &Percentiles) {
        match order.distribution {
            Distribution::Even => self.worst = self.worst.widened(found.ends),
            // Some lie beyond the tolerances.
            Distribution::Normal => {}
        }
    }
}

/// Figures of a mechanism whose lengths are off.
#[derive(Clone, Debug)]
pub struct ToleranceStudy {
    machines: MachinesAtPlace,
    slopes: Sensitivity,
    off: ToleranceBox,
}

impl ToleranceStudy {
    /// Of these figures of a scene.
    ///
    /// # Errors
    /// Where there is nothing to say, see [`NoTolerance`].
    pub fn new(
        scene: &Scene,
        solver: &Solver,
        tolerances: &Tolerances,
        figures: &[Quantity],
    ) -> Result<ToleranceStudy, NoTolerance> {
        let off = ToleranceBox::new(tolerances).ok_or(NoTolerance::Exact)?;
        let (demand, order) = demand(figures);
        if demand.forces {
            return Err(NoTolerance::Forces);
        }
        let varied = solver
            .varied(&off.given, &demand)
            .ok_or(NoTolerance::Redundant)?;
        Ok(ToleranceStudy {
            machines: MachinesAtPlace::new(figures.to_vec(), order, varied),
            slopes: Sensitivity::by(scene, solver, figures, off.given.clone()),
            off,
        })
    }

    /// The figures that are asked about.
    #[must_use]
    pub fn figures(&self) -> &[Quantity] {
        &self.machines.figures
    }

    /// The figures that are not the same for all machines at a coordinate, at the first order.
    pub fn moved(&mut self, at: f64) -> Vec<Quantity> {
        let slopes = self.slopes_at(at);
        let moves = |i: usize| {
            let slopes = slopes.as_ref().and_then(|slopes| slopes.of(i));
            slopes.is_none_or(|slopes| self.off.root_sum_square(slopes) > 0.0)
        };
        let all = self.figures().iter().enumerate();
        let moved = all.filter(|&(i, _)| moves(i));
        moved.map(|(_, figure)| figure.clone()).collect()
    }

    /// What tolerances do to every figure at a coordinate; `None` for one that does not exist there.
    pub fn at(&mut self, at: f64) -> Vec<Option<ToleranceFigure>> {
        let nominal = self.machines.go(at);
        let slopes = self.slopes_at(at);
        let worst = self.worst(at, &nominal, slopes.as_ref(), corners::THOROUGH);
        machines::told(&self.off, &nominal, worst, |i| slopes.as_ref()?.of(i))
    }

    /// Makes machines by chance, and reads every figure of each at a coordinate of the driver.
    pub fn sampled(&mut self, at: f64, order: SampleOrder) -> Samples {
        let nominal = self.machines.go(at);
        let kind = self.machines.varied.kind();
        Samples::of(&mut self.machines, &self.off, nominal.len(), kind, order)
    }

    /// Of every figure the root of the sum of squares and who contributes, the greatest first; `None` where derivatives
    /// do not exist. Nothing but the first order is worked out.
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

    /// The derivatives by everything that is off.
    fn slopes_at(&mut self, at: f64) -> Option<Slopes> {
        self.slopes.at(at)
    }
}
