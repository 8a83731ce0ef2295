//! Derivatives of cycle figures at fixed places of the motion.
//!
//! A stroke is the difference of a quantity at two places. To first order these places may be kept
//! fixed while lengths change: the quantity is stationary there, so moving the place has no effect
//! (the envelope theorem). The derivative is therefore that of the quantity at fixed places. The
//! solver's own formulas give it in dual numbers if each number sets one length. Otherwise, for
//! numbers in formulas and for transmission angles, it is a difference of two states. Both need the
//! places once, instead of the whole motion of each neighbouring design.

use super::DesignFigures;
use crate::angle::{TURN, unwrap_near};
use crate::expression::DirectionCut;
use crate::quantity::{Quantity, Sensitivity};
use crate::solver::{Condition, Order, Varied};
use crate::study::excursion::{PlacedBound, PlacedFigure, PlacedValue};

/// Half a turn, in degrees.
const HALF_TURN: f64 = 180.0;
/// Distances of the parabolas that find an extremum, one after another, in degrees. The last one
/// leaves an error of the value that is rounding.
const DISTANCES: [f64; 3] = [1.0, 0.1, 0.01];
/// Maximum distance by which one parabola moves a place, in degrees.
const MAX_MOVE: f64 = 30.0;

impl DesignFigures {
    /// Returns the derivatives of figures with these places by the variable numbers, by the solver's
    /// own formulas. Returns `None` if a number sets more than one length, or if a figure is no
    /// column.
    pub(super) fn exact_slopes(
        &mut self,
        places: &[PlacedFigure],
        numbers: &[f64],
    ) -> Option<Vec<Vec<f64>>> {
        let columns: Option<Vec<Quantity>> = places.iter().map(PlacedFigure::column).collect();
        let columns = columns?;
        let (solver, lengths) = self.in_place(numbers)?;
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

    /// Returns the derivatives of figures with these places by the variable numbers, by differences
    /// from `ends[0]` to `ends[1]` of each number. Returns `None` if a value does not exist there.
    pub(super) fn placed_slopes(
        &mut self,
        places: &[PlacedFigure],
        numbers: &[f64],
        ends: &[[f64; 2]],
    ) -> Option<Vec<Vec<f64>>> {
        let mut slopes = vec![vec![0.0; numbers.len()]; places.len()];
        let mut changed = numbers.to_vec();
        for (i, &[low, high]) in ends.iter().enumerate() {
            if low == high {
                continue;
            }
            let mut values = |number: f64| {
                changed[i] = number;
                self.placed_values(places, &changed)
            };
            let (before, after) = (values(low)?, values(high)?);
            changed[i] = numbers[i];
            for (k, (before, after)) in before.into_iter().zip(after).enumerate() {
                let by = match places[k].is_direction() {
                    true => unwrap_near(0.0, after - before),
                    false => after - before,
                };
                slopes[k][i] = by / (high - low);
            }
        }
        Some(slopes)
    }

    /// Returns the figures of a design with fixed places. Returns `None` if a value does not exist.
    pub(super) fn placed_values(
        &mut self,
        places: &[PlacedFigure],
        numbers: &[f64],
    ) -> Option<Vec<f64>> {
        let varied = self.varied_to(numbers)?;
        let values = places.iter().map(|placed| placed.value_of(varied));
        values.collect()
    }

    /// Moves places to the nearest extrema of a design, and returns its figures there. Returns `None`
    /// if a value does not exist.
    pub(super) fn follow_places(
        &mut self,
        places: &mut [PlacedFigure],
        numbers: &[f64],
    ) -> Option<Vec<f64>> {
        let varied = self.varied_to(numbers)?;
        places
            .iter_mut()
            .map(|placed| placed.follow(varied))
            .collect()
    }
}

impl PlacedFigure {
    /// Moves the places to the nearest extrema, and returns the figure there.
    fn follow(&mut self, varied: &mut Varied) -> Option<f64> {
        if self.bound != PlacedBound::Exact {
            for k in 0..self.places.len() {
                let mut at = self.places[k].0;
                for distance in DISTANCES {
                    let near = [at - distance, at, at + distance];
                    let [before, here, after] = near.map(|at| self.value_at(varied, (at, 1.0)));
                    let [before, here, after] = [before?, here?, after?];
                    // The vertex of the parabola through the three values.
                    let bend = before - 2.0 * here + after;
                    let off = 0.5 * distance * (before - after) / bend;
                    if off.is_finite() {
                        at += off.clamp(-MAX_MOVE, MAX_MOVE);
                    }
                }
                self.places[k].0 = at;
            }
        }
        self.value_of(varied)
    }

    fn column(&self) -> Option<Quantity> {
        match &self.value {
            PlacedValue::Column(column) => Some(column.clone()),
            PlacedValue::Transmission(_) => None,
        }
    }

    fn is_direction(&self) -> bool {
        match &self.value {
            PlacedValue::Column(column) => column.cut() == DirectionCut::ByTurns,
            PlacedValue::Transmission(_) => false,
        }
    }

    /// Computes the figure with fixed places. Returns `None` if a value is missing.
    fn value_of(&self, varied: &mut Varied) -> Option<f64> {
        let values = self.places.iter();
        let mut values = values.map(|&place| self.value_at(varied, place));
        let sum = values.try_fold(0.0, |sum, value| Some(sum + value?))?;
        // A swing is between 0 and a turn.
        let is_swing = self.is_direction() && self.places.len() > 1;
        Some(if is_swing { sum.rem_euclid(TURN) } else { sum })
    }

    /// Computes the value at a place, with its sign.
    fn value_at(&self, varied: &mut Varied, (at, sign): (f64, f64)) -> Option<f64> {
        let order = match &self.value {
            PlacedValue::Column(column) => column.order(),
            PlacedValue::Transmission(_) => Order::Position,
        };
        if varied.solve(at, order) == Condition::NoAssembly {
            return None;
        }
        match &self.value {
            PlacedValue::Column(column) => Some(sign * column.value(varied.state())?),
            PlacedValue::Transmission(group) => {
                let angle = varied.transmission_angle(*group)?;
                // An angle above the best one counts from the other side.
                Some(if sign < 0.0 { HALF_TURN - angle } else { angle })
            }
        }
    }
}
