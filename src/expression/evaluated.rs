//! A figure with account of what it may have lost on the way.
//!
//! It is worked out in twice the digits, from the decimals as they are written. What comes within what may be lost of
//! nothing is nothing, and what comes within that of a decimal of up to 15 digits is that decimal: `0.1 + 0.2 - 0.3` is
//! 0, and a third of 0.3 is 0.1.

use super::Dimension;
use crate::arithmetic::Decimal;
use crate::{Double, Vec2};

/// What exponentials and logarithms are off by, with room to spare: 2^-90.
const POWERS: f64 = 8.077_935_669_463_161e-28;
/// What an operation rounds by, with room to spare: sums and products are right to 2^-104.
const ROUNDING: f64 = 7.888_609_052_210_118e-31;

/// A number, and what it measures, if a unit tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MeasuredNumber {
    /// To twice the digits: lengths in the formula's unit, angles in degrees, all else in that of metres.
    pub(crate) value: Double,
    pub(crate) dimension: Option<Dimension>,
}

/// A figure, and by how much it may be off.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Evaluated {
    pub(crate) value: Double,
    pub(super) error: f64,
    /// What it measures, if a unit tells: plain numbers may stand for anything.
    pub(crate) dimension: Option<Dimension>,
}

impl Evaluated {
    /// Without what it may be off by.
    pub(crate) fn measured(self) -> MeasuredNumber {
        MeasuredNumber {
            value: self.value,
            dimension: self.dimension,
        }
    }

    pub(super) fn exactly(value: f64) -> Evaluated {
        Evaluated::of(Double::exactly(value), 0.0)
    }

    /// A figure of an operation, which is off by what it was made of and its own rounding.
    pub(super) fn of(value: Double, error: f64) -> Evaluated {
        let figure = Evaluated {
            value,
            error,
            dimension: None,
        };
        match value.hi.abs() <= error {
            true => Evaluated {
                value: Double::ZERO,
                ..figure
            },
            false => figure,
        }
    }

    /// The same with what an operation rounds by.
    pub(super) fn rounded(value: Double, error: f64) -> Evaluated {
        Evaluated::of(value, error + ROUNDING * value.hi.abs())
    }

    pub(super) fn measuring(self, dimension: Option<Dimension>) -> Evaluated {
        Evaluated { dimension, ..self }
    }

    pub(super) fn size(&self) -> f64 {
        self.value.hi.abs()
    }

    /// The decimal of up to 15 digits that is meant, where one comes so near.
    pub(super) fn settled(self) -> Evaluated {
        let short = format!("{:.14e}", self.value.hi).parse();
        let decimal = Decimal::of(short.unwrap_or(self.value.hi)).value;
        let is_meant = (decimal - self.value).hi.abs() <= self.error;
        match is_meant {
            true => Evaluated {
                value: decimal,
                ..self
            },
            false => self,
        }
    }

    pub(super) fn negative(self) -> Evaluated {
        Evaluated {
            value: -self.value,
            ..self
        }
    }

    pub(super) fn plus(self, other: Evaluated) -> Evaluated {
        Evaluated::rounded(self.value + other.value, self.error + other.error)
    }

    pub(super) fn times(self, other: Evaluated) -> Evaluated {
        let error = self.size() * other.error + (other.size() + other.error) * self.error;
        Evaluated::rounded(self.value * other.value, error)
    }

    /// Over what is not nothing.
    pub(super) fn over(self, other: Evaluated) -> Evaluated {
        let quotient = self.value / other.value;
        let error = (self.error + quotient.hi.abs() * other.error) / other.size();
        Evaluated::rounded(quotient, error)
    }

    /// Of what is not negative.
    pub(super) fn root(self) -> Evaluated {
        let root = self.value.sqrt();
        match root.hi == 0.0 {
            true => Evaluated::of(root, self.error.sqrt()),
            false => Evaluated::rounded(root, 0.5 * self.error / root.hi),
        }
    }

    /// e to this power; `None` where that is beyond any number.
    pub(super) fn exponential(self) -> Option<Evaluated> {
        let power = self.value.exp();
        let error = (self.error + POWERS) * power.hi;
        error.is_finite().then(|| Evaluated::rounded(power, error))
    }

    /// A logarithm to a base of at least e; `None` of what may be nothing or less.
    pub(super) fn logarithm(self, of: impl Fn(Double) -> Double) -> Option<Evaluated> {
        let least = self.value.hi - self.error;
        (least > 0.0).then(|| Evaluated::rounded(of(self.value), self.error / least + POWERS))
    }

    /// The root of both squares, without overflow on the way.
    pub(super) fn hypotenuse(self, other: Evaluated) -> Evaluated {
        let (large, small) = match self.size() < other.size() {
            true => (other, self),
            false => (self, other),
        };
        if large.size() == 0.0 {
            return large;
        }
        let part = small.over(large);
        let root = part.times(part).plus(Evaluated::exactly(1.0)).root();
        let length = large.times(root);
        match length.value.hi < 0.0 {
            true => length.negative(),
            false => length,
        }
    }

    /// Cosine and sine of an angle in degrees.
    pub(super) fn unit(self) -> [Evaluated; 2] {
        let near = Double::unit(self.value.hi);
        // The rest is so small that it is its own sine.
        let rest = Double::exactly(self.value.lo) * Double::RADIAN;
        let error = ROUNDING + self.error * Double::RADIAN.hi;
        let part = |value| Evaluated::rounded(value, error);
        [part(near.x - near.y * rest), part(near.y + near.x * rest)]
    }

    /// The direction of a place that is not the origin, in degrees.
    pub(super) fn direction(x: Evaluated, y: Evaluated) -> Evaluated {
        let size = x.size().max(y.size());
        let [along, across] = [x, y].map(|part| part.value / Double::exactly(size));
        let error = (x.error + y.error) / size + ROUNDING;
        let angle = Double::degrees(Vec2::new(along, across));
        Evaluated::of(angle, 180.0 * error)
    }

    /// Whether one is less than another.
    pub(super) fn is_below(one: Evaluated, other: Evaluated) -> bool {
        (one.value - other.value).hi < 0.0
    }
}
