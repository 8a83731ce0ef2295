//! Reference values for directions and for places in a cyclic motion. They are equal modulo full
//! turns, and should change continuously between similar mechanisms.

use super::{CycleFigure, CycleFigures, NoFigure};
use crate::angle::{TURN, unwrap_within};
use crate::solver::{Range, Solver};

/// For each cyclic figure its reference value and its period.
#[derive(Clone, Debug)]
pub(crate) struct FigureSeams(Vec<Option<(f64, f64)>>);

impl FigureSeams {
    /// Takes the reference values from the figures of a reference mechanism.
    pub(crate) fn of(figures: &CycleFigures, solver: &Solver) -> FigureSeams {
        let range = solver.motion().range;
        let periods = figures.figures().iter().map(|figure| figure.period(range));
        let periods: Vec<Option<f64>> = periods.collect();
        if periods.iter().all(Option::is_none) {
            return FigureSeams(periods.iter().map(|_| None).collect());
        }
        let found = figures.of(solver);
        let seams = found.iter().zip(periods);
        FigureSeams(
            seams
                .map(|(from, period)| Some(((*from).ok()?, period?)))
                .collect(),
        )
    }

    /// Shifts each cyclic value by whole periods to the one nearest to its reference.
    pub(crate) fn count(&self, found: &mut [Result<f64, NoFigure>]) {
        for (value, seam) in found.iter_mut().zip(&self.0) {
            if let (Ok(value), Some((from, period))) = (value, seam) {
                *value = unwrap_within(*period, *from, *value);
            }
        }
    }
}

impl CycleFigure {
    /// Returns the period of a figure: a turn for a direction or a sum of directions, and the
    /// period of the motion for a place in it.
    fn period(&self, range: Range) -> Option<f64> {
        match range {
            _ if self.is_periodic_value() => Some(TURN),
            Range::Full { period } if self.is_place() => Some(period),
            Range::Full { .. } | Range::Limited { .. } => None,
        }
    }
}
