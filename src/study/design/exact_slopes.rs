//! Derivatives of figures of the cycle without differences.
//!
//! A stroke is the figure at one place less that at another. To first order these places may stay where they are while
//! lengths change: there the figure turns, so that moving along does nothing (the envelope theorem). So its derivative is
//! that of the figure at these places, which the solver's own formulas give in dual numbers.

use super::DesignFigures;
use crate::quantity::Sensitivity;

impl DesignFigures {
    /// Figure by figure the derivatives by the numbers that vary. `None` where not every figure has them: where a design
    /// is not changed in place, or where one is no difference of a column at some places, as a time ratio or a
    /// transmission angle.
    pub(super) fn exact_slopes(&mut self, numbers: &[f64]) -> Option<Vec<Vec<f64>>> {
        let (solver, lengths) = self.in_place(numbers)?;
        let figures = self.cycle_figures();
        let places = figures.places(&solver)?;
        let columns: Vec<_> = places.iter().map(|placed| placed.column.clone()).collect();
        let scene = self.space().scene();
        let mut sensitivity = Sensitivity::by(scene, &solver, &columns, lengths);
        let mut slopes = Vec::with_capacity(places.len());
        for (i, placed) in places.iter().enumerate() {
            let mut slope = vec![0.0; numbers.len()];
            for &(at, sign) in &placed.places {
                let found = sensitivity.at(at)?;
                for (all, by) in slope.iter_mut().zip(found.of(i)?) {
                    *all += sign * by;
                }
            }
            slopes.push(slope);
        }
        Some(slopes)
    }
}
