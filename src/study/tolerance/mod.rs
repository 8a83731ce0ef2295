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
mod samples;
#[cfg(test)]
mod tests;
mod tolerance_box;
mod whole;

pub use band::{BandKind, Offsets};
pub use contributions::{Contribution, ToleranceOf};
pub use corners::{WorstCase, WorstKind};
pub use samples::{Distribution, Percentiles, SampleOrder, Samples};
pub use whole::WholeTolerance;

use crate::Tolerances;
use crate::quantity::{Quantity, Sensitivity, demand};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, Varied};
use crate::wording::words;
use contributions::Slopes;
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

/// Figures of a mechanism whose lengths are off.
#[derive(Clone, Debug)]
pub struct ToleranceStudy {
    figures: Vec<Quantity>,
    order: Order,
    varied: Varied,
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
            figures: figures.to_vec(),
            order,
            varied,
            slopes: Sensitivity::by(scene, solver, figures, off.given.clone()),
            off,
        })
    }

    /// The figures that are asked about.
    #[must_use]
    pub fn figures(&self) -> &[Quantity] {
        &self.figures
    }

    /// The figures that are not the same for all machines at a coordinate, at the first order.
    pub fn moved(&mut self, at: f64) -> Vec<Quantity> {
        let slopes = self.slopes_at(at);
        let moves = |i: usize| {
            let slopes = slopes.as_ref().and_then(|slopes| slopes.of(i));
            slopes.is_none_or(|slopes| self.off.root_sum_square(slopes) > 0.0)
        };
        let all = self.figures.iter().enumerate();
        let moved = all.filter(|&(i, _)| moves(i));
        moved.map(|(_, figure)| figure.clone()).collect()
    }

    /// What tolerances do to every figure at a coordinate; `None` for one that does not exist there.
    pub fn at(&mut self, at: f64) -> Vec<Option<ToleranceFigure>> {
        let nominal = self.nominal(at);
        let slopes = self.slopes_at(at);
        let worst = self.corners(at, &nominal, &slopes);
        let figures = nominal.iter().zip(worst).enumerate();
        let figure = figures.map(|(i, (&nominal, worst))| {
            let slopes = slopes.as_ref().and_then(|slopes| slopes.of(i));
            let contributions = slopes.map(|slopes| self.off.contributions(slopes));
            Some(ToleranceFigure {
                nominal: nominal?,
                worst: worst?,
                root_sum_square: slopes.map(|slopes| self.off.root_sum_square(slopes)),
                contributions: contributions.unwrap_or_default(),
            })
        });
        figure.collect()
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
        (0..self.figures.len()).map(figure).collect()
    }

    /// The derivatives by everything that is off.
    fn slopes_at(&mut self, at: f64) -> Option<Slopes> {
        self.slopes.at(at)
    }

    /// The figures with the lengths as they were given.
    fn nominal(&mut self, at: f64) -> Vec<Option<f64>> {
        let exact = self.off.nothing();
        let mut values = vec![None; self.figures.len()];
        self.varied.change(&exact);
        if self.is_solved(at) {
            self.read(&mut values, None);
        }
        values
    }

    /// Whether it closes with the lengths as they are now.
    fn is_solved(&mut self, at: f64) -> bool {
        match self.varied.solve(at, self.order) {
            Condition::Ok | Condition::ChangePoint => true,
            Condition::DeadPoint => self.order == Order::Position,
            Condition::NoAssembly => false,
        }
    }

    /// The figures of the state that was found, directions as near as can be to others.
    fn read(&self, values: &mut [Option<f64>], beside: Option<&[Option<f64>]>) {
        for (i, (figure, value)) in self.figures.iter().zip(values).enumerate() {
            *value = figure.value(self.varied.state().state());
            let near = beside
                .and_then(|near| near[i])
                .filter(|_| figure.is_direction());
            if let (Some(value), Some(near)) = (value, near) {
                *value = crate::angle::beside(near, *value);
            }
        }
    }
}
