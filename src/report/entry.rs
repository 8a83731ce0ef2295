//! A figure of the tables, with what is proved of it: alone, and of a plane vector.

use crate::{Vec2, angle};
use std::f64::consts::FRAC_PI_2;

/// One entry of a vector's column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Its value; `None` where none exists.
    pub value: Option<f64>,
    /// Whether the scene gives it; otherwise it was found.
    pub given: bool,
    /// What its error does not exceed, in its own unit; `None` where nothing was proved. What the scene
    /// gives is taken as it is.
    pub bound: Option<f64>,
}

impl Entry {
    /// A figure that does not exist.
    pub(crate) const NONE: Entry = Entry {
        value: None,
        given: false,
        bound: None,
    };

    /// A figure that the scene gives.
    pub(super) const fn given(value: f64) -> Entry {
        Entry {
            value: Some(value),
            given: true,
            bound: Some(0.0),
        }
    }

    /// What is proved of a figure that exists.
    pub(super) fn proved(&self) -> Option<f64> {
        self.value.and(self.bound)
    }

    /// The value as a reader sees it: zero where it is small and its error may be all that it is.
    #[must_use]
    pub fn seen(&self) -> Option<f64> {
        self.value.map(|value| seen(value, self.bound))
    }

    /// What the error of the value does not exceed as a reader sees it: a zero is off by what it hides, too.
    #[must_use]
    pub fn seen_bound(&self) -> Option<f64> {
        seen_bound(self.value?, self.bound)
    }
}

/// Larger figures are shown even where the bound does not tell them from zero. Close to a change point
/// bounds are wide and the figures good: a zero in place of one would be the only error seen.
pub(super) const NOISE: f64 = 1e-6;
/// Where nothing is proved, only so small a figure is taken for zero.
const NOTHING: f64 = 1e-15;

/// A value as a reader sees it: zero only where it is small and its error may be all that it is.
pub(super) fn seen(value: f64, bound: Option<f64>) -> f64 {
    let nought = value.abs() <= bound.map_or(NOTHING, |bound| bound.min(NOISE));
    if nought { 0.0 } else { value }
}

/// What the error of a value does not exceed as a reader sees it.
pub(super) fn seen_bound(value: f64, bound: Option<f64>) -> Option<f64> {
    let hidden = (value - seen(value, bound)).abs();
    bound.map(|bound| match hidden {
        0.0 => bound,
        hidden => (bound + hidden).next_up(),
    })
}

/// A plane vector in the ground frame, by components and by magnitude and direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneVector {
    /// Both components, in the scene's unit (per s, per s^2), or in N.
    pub components: Vec2,
    /// Its length.
    pub magnitude: f64,
    /// Its direction in degrees from 0 to below 360; the null vector has none.
    pub direction: Option<f64>,
    /// What the errors of x, y, magnitude and direction do not exceed; `None` where nothing was proved.
    pub bounds: [Option<f64>; 4],
}

impl PlaneVector {
    pub(super) fn new(components: Vec2, bounds: [Option<f64>; 2]) -> PlaneVector {
        let magnitude = components.norm();
        let [x, y] = bounds;
        let error = x.zip(y).map(|(x, y)| Vec2::new(x, y).norm());
        // The rounding of a norm, of an arc tangent, and of what is said about them.
        let rounded = |value: f64, bound: f64| (bound + 2.0 * f64::EPSILON * value) * ROUNDED_UP;
        // A vector that is off by a part s of itself is turned by asin(s) at the most, which is no more
        // than pi/2 s.
        let turned = |error: f64| {
            let share = error / magnitude * ROUNDED_UP;
            let turned = (share * FRAC_PI_2).to_degrees();
            (share < 1.0).then(|| rounded(angle::TURN, turned))
        };
        // What may be the null vector has no direction.
        let is_null = magnitude <= error.unwrap_or(0.0);
        let direction = (!is_null).then(|| angle::degrees(components));
        PlaneVector {
            components,
            magnitude,
            direction,
            bounds: [
                x,
                y,
                error.map(|e| rounded(magnitude, e)),
                error.and_then(turned),
            ],
        }
    }

    /// x, y, magnitude and direction, each as an entry.
    pub(crate) fn entries(&self, given: bool) -> [Entry; 4] {
        let Vec2 { x, y } = self.components;
        let values = [Some(x), Some(y), Some(self.magnitude), self.direction];
        std::array::from_fn(|i| Entry {
            value: values[i],
            given,
            bound: self.bounds[i],
        })
    }
}

/// More than a few roundings of a bound that is itself computed.
pub(super) const ROUNDED_UP: f64 = 1.0 + 8.0 * f64::EPSILON;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zero_is_off_by_what_it_hides() {
        let entry = Entry {
            value: Some(3e-17),
            given: false,
            bound: Some(4e-17),
        };
        assert_eq!(entry.seen(), Some(0.0));
        assert!(entry.seen_bound() >= Some(7e-17));
        let entry = Entry {
            value: Some(5e-17),
            ..entry
        };
        assert_eq!(entry.seen_bound(), entry.bound);
    }
}
