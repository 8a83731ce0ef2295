//! Numerical methods for demonstration: the loop equations solved as by hand, with every iteration
//! recorded.
//!
//! The solver does not use these methods. They have no damping and no retries, so that the effects
//! of a bad guess are visible. The unknowns have neither names nor units here and are identified by
//! index.

mod bisection;
mod newton;

pub use bisection::{Bisection, Halving};
pub use newton::{NewtonIteration, NewtonOutcome, NewtonTrace};

use crate::Vec2;
use std::f64::consts::{PI, TAU};

/// The kind of an unknown in a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnknownKind {
    /// An angle, in rad.
    Angle,
    /// A length along a guide, in the scene's unit.
    Length,
}

/// The length or the angle of a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VectorPart {
    /// A known value.
    Known(f64),
    /// The unknown with this index, plus an offset.
    Sought(usize, f64),
}

/// A vector of a loop with at least one unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnknownVector {
    /// 1, or -1 if the loop traverses the vector backwards.
    pub sign: f64,
    /// The length.
    pub length: VectorPart,
    /// The angle, in rad.
    pub angle: VectorPart,
}

/// A loop: the sum of its known vectors, and the other vectors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoopSum {
    /// The sum of the known vectors.
    pub known: Vec2,
    /// The other vectors.
    pub sought: Vec<UnknownVector>,
}

/// The equations of one or more loops: each sum is zero, in x and in y.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopSystem {
    /// The loops.
    pub loops: Vec<LoopSum>,
    /// The kinds of the unknowns.
    pub kinds: Vec<UnknownKind>,
    /// The longest length; errors of lengths are relative to it.
    pub longest: f64,
}

/// The errors of one method for one group, iteration by iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorCurve {
    /// The mark in a chart.
    pub mark: char,
    /// The errors: angles in rad, lengths relative to the longest.
    pub errors: Vec<f64>,
}

impl VectorPart {
    fn at(self, values: &[f64]) -> f64 {
        match self {
            VectorPart::Known(value) => value,
            VectorPart::Sought(index, more) => values.get(index).map_or(f64::NAN, |v| v + more),
        }
    }
}

impl LoopSystem {
    /// Returns `true` if there are as many equations as unknowns, and at least one.
    #[must_use]
    pub fn is_square(&self) -> bool {
        !self.kinds.is_empty() && self.kinds.len() == 2 * self.loops.len()
    }

    /// Returns the residuals of the equations, x and y of each loop in turn.
    #[must_use]
    pub fn residuals(&self, values: &[f64]) -> Vec<f64> {
        let left = |of: &LoopSum| {
            let along = |v: &UnknownVector| direction(v, values) * (v.sign * v.length.at(values));
            let sum = of.sought.iter().map(along).fold(of.known, |sum, v| sum + v);
            [sum.x, sum.y]
        };
        self.loops.iter().flat_map(left).collect()
    }

    /// Returns the derivatives of the equations by the unknowns, row by row.
    #[must_use]
    pub fn jacobian(&self, values: &[f64]) -> Vec<f64> {
        let n = self.kinds.len();
        let mut matrix = vec![0.0; 2 * self.loops.len() * n];
        for (row, of) in self.loops.iter().enumerate() {
            for v in &of.sought {
                let u = direction(v, values) * v.sign;
                let mut add = |part: VectorPart, by: Vec2| {
                    if let VectorPart::Sought(index, _) = part {
                        matrix[2 * row * n + index] += by.x;
                        matrix[(2 * row + 1) * n + index] += by.y;
                    }
                };
                add(v.length, u);
                add(v.angle, Vec2::new(-u.y, u.x) * v.length.at(values));
            }
        }
        matrix
    }

    /// Returns the absolute difference of an unknown: in rad, or relative to the longest length.
    fn part(&self, index: usize, difference: f64) -> f64 {
        match self.kinds.get(index) {
            Some(UnknownKind::Length) => difference.abs() / self.longest,
            Some(UnknownKind::Angle) | None => difference.abs(),
        }
    }

    /// Returns the maximum of the absolute differences of all unknowns.
    #[must_use]
    pub fn largest(&self, differences: &[f64]) -> f64 {
        let parts = differences.iter().enumerate();
        parts.fold(0.0, |maximum, (i, &d)| nan_or_max(maximum, self.part(i, d)))
    }

    /// Returns the error of values against the right ones, with angles compared modulo a turn.
    #[must_use]
    pub fn error(&self, values: &[f64], right: &[f64]) -> f64 {
        let distance = |(i, (v, r)): (usize, (&f64, &f64))| match self.kinds.get(i) {
            Some(UnknownKind::Angle) => half_turn(v - r),
            Some(UnknownKind::Length) | None => v - r,
        };
        let pairs = values.iter().zip(right).enumerate();
        self.largest(&pairs.map(distance).collect::<Vec<_>>())
    }
}

fn direction(of: &UnknownVector, values: &[f64]) -> Vec2 {
    let (sin, cos) = of.angle.at(values).sin_cos();
    Vec2::new(cos, sin)
}

/// Returns the maximum; NaN if an argument is NaN.
fn nan_or_max(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else {
        a.max(b)
    }
}

/// Reduces an angle in rad to [-pi, pi).
#[must_use]
pub fn half_turn(radians: f64) -> f64 {
    (radians + PI).rem_euclid(TAU) - PI
}

#[cfg(test)]
mod tests;
