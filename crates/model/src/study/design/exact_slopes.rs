//! Derivatives of cycle figures without differences.
//!
//! A stroke is the difference of a quantity at two places. To first order these places may be kept
//! fixed while lengths change: the quantity is stationary there, so moving the place has no effect
//! (the envelope theorem). The derivative is therefore that of the quantity at fixed places, which
//! the solver's own formulas give in dual numbers.

use super::DesignFigures;
use super::evaluation::FigureSet;
use crate::quantity::Sensitivity;

impl DesignFigures {
    /// Returns the derivatives of each figure of a set by the variable numbers. Returns `None` if a design
    /// is not changed in place, or if a figure has another form than a difference of a column at
    /// some places. Examples are a time ratio and a transmission angle.
    pub(super) fn exact_slopes(
        &mut self,
        set: &FigureSet,
        numbers: &[f64],
    ) -> Option<Vec<Vec<f64>>> {
        let (solver, lengths) = self.in_place(numbers)?;
        let places = set.figures.places(&solver)?;
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
