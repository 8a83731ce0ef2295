//! Methods to be watched: the loop equations solved as a student does it by hand, every iteration kept.
//!
//! The solver itself does nothing of the kind: these are plain methods without damping, without a second try,
//! so that what becomes of a bad guess can be seen. Nothing here has a name or a unit; what is sought is known
//! by its place.

mod bisection;
mod newton;

pub use bisection::{Bisection, Halving};
pub use newton::{NewtonIteration, NewtonOutcome, NewtonTrace};

use crate::Vec2;
use std::f64::consts::{PI, TAU};

/// What is sought in a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SoughtKind {
    /// An angle, in rad.
    Angle,
    /// A length along a guide, in the scene's unit.
    Length,
}

/// The length or the angle of a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VectorPart {
    /// It is this.
    Known(f64),
    /// It is what is sought at this place, and so much more.
    Sought(usize, f64),
}

/// A vector of a loop of which something is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoughtVector {
    /// 1, or -1 where the loop goes against it.
    pub sign: f64,
    /// Its length.
    pub length: VectorPart,
    /// Its angle, in rad.
    pub angle: VectorPart,
}

/// A loop: what is known of it added up, and the vectors that are not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoopSum {
    /// The sum of the known vectors.
    pub known: Vec2,
    /// The others.
    pub sought: Vec<SoughtVector>,
}

/// The equations of one or more loops: each sum is nought, in x and in y.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopSystem {
    /// The loops.
    pub loops: Vec<LoopSum>,
    /// What is sought.
    pub kinds: Vec<SoughtKind>,
    /// The longest length: errors of lengths are parts of it.
    pub longest: f64,
}

/// The errors of one method on one group, iteration by iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorCurve {
    /// What marks it in a chart.
    pub mark: char,
    /// Angles in rad, lengths in parts of the longest.
    pub errors: Vec<f64>,
}

impl VectorPart {
    fn at(self, values: &[f64]) -> f64 {
        match self {
            VectorPart::Known(value) => value,
            VectorPart::Sought(place, more) => values.get(place).map_or(f64::NAN, |v| v + more),
        }
    }
}

impl LoopSystem {
    /// Whether there are as many equations as unknowns, and any.
    #[must_use]
    pub fn is_square(&self) -> bool {
        !self.kinds.is_empty() && self.kinds.len() == 2 * self.loops.len()
    }

    /// What is left of every equation: of each loop its x and its y.
    #[must_use]
    pub fn residuals(&self, values: &[f64]) -> Vec<f64> {
        let left = |of: &LoopSum| {
            let along = |v: &SoughtVector| direction(v, values) * (v.sign * v.length.at(values));
            let sum = of.sought.iter().map(along).fold(of.known, |sum, v| sum + v);
            [sum.x, sum.y]
        };
        self.loops.iter().flat_map(left).collect()
    }

    /// The derivatives of the equations by what is sought, row by row.
    #[must_use]
    pub fn jacobian(&self, values: &[f64]) -> Vec<f64> {
        let n = self.kinds.len();
        let mut matrix = vec![0.0; 2 * self.loops.len() * n];
        for (row, of) in self.loops.iter().enumerate() {
            for v in &of.sought {
                let u = direction(v, values) * v.sign;
                let mut add = |part: VectorPart, by: Vec2| {
                    if let VectorPart::Sought(place, _) = part {
                        matrix[2 * row * n + place] += by.x;
                        matrix[(2 * row + 1) * n + place] += by.y;
                    }
                };
                add(v.length, u);
                add(v.angle, Vec2::new(-u.y, u.x) * v.length.at(values));
            }
        }
        matrix
    }

    /// A difference of what is sought at a place: in rad, or in parts of the longest length.
    fn part(&self, place: usize, difference: f64) -> f64 {
        match self.kinds.get(place) {
            Some(SoughtKind::Length) => difference.abs() / self.longest,
            Some(SoughtKind::Angle) | None => difference.abs(),
        }
    }

    /// The largest of many differences.
    #[must_use]
    pub fn largest(&self, differences: &[f64]) -> f64 {
        let parts = differences.iter().enumerate();
        parts.fold(0.0, |most, (i, &d)| nan_or_max(most, self.part(i, d)))
    }

    /// How far values are from others, angles counted within a turn.
    #[must_use]
    pub fn error(&self, values: &[f64], right: &[f64]) -> f64 {
        let apart = |(i, (v, r)): (usize, (&f64, &f64))| match self.kinds.get(i) {
            Some(SoughtKind::Angle) => half_turn(v - r),
            Some(SoughtKind::Length) | None => v - r,
        };
        let pairs = values.iter().zip(right).enumerate();
        self.largest(&pairs.map(apart).collect::<Vec<_>>())
    }
}

fn direction(of: &SoughtVector, values: &[f64]) -> Vec2 {
    let (sin, cos) = of.angle.at(values).sin_cos();
    Vec2::new(cos, sin)
}

/// NaN stays: it is larger than anything.
fn nan_or_max(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else {
        a.max(b)
    }
}

/// An angle in rad, from -pi to below pi.
#[must_use]
pub fn half_turn(radians: f64) -> f64 {
    (radians + PI).rem_euclid(TAU) - PI
}

#[cfg(test)]
mod tests;
