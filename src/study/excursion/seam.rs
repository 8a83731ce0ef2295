//! From where directions, and places in a motion that comes round, are counted: whole turns away they are the same, and
//! those of like mechanisms are to go on from one to the next without a jump.

use super::{CycleFigure, CycleFigures, NoFigure};
use crate::angle::{TURN, beside_within};
use crate::solver::{Range, Solver};

/// For each figure that comes round what it is counted from, and after how much it comes round.
#[derive(Clone, Debug)]
pub(crate) struct FigureSeams(Vec<Option<(f64, f64)>>);

impl FigureSeams {
    /// Of the figures of the mechanism that the others are like.
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

    /// Values of the figures, each as near as can be to what it is counted from.
    pub(crate) fn count(&self, found: &mut [Result<f64, NoFigure>]) {
        for (value, seam) in found.iter_mut().zip(&self.0) {
            if let (Ok(value), Some((from, period))) = (value, seam) {
                *value = beside_within(*period, *from, *value);
            }
        }
    }
}

impl CycleFigure {
    /// After how much it is the same again: a direction, and a sum of such, after a turn, a place in a motion that comes round after that.
    fn period(&self, range: Range) -> Option<f64> {
        match range {
            _ if self.comes_round() => Some(TURN),
            Range::Full { period } if self.is_place() => Some(period),
            Range::Full { .. } | Range::Limited { .. } => None,
        }
    }
}
