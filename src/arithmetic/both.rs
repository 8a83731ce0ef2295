//! Two doubles side by side: those of the two arms of a dyad, which go through the same formulas.

use super::angle;
use crate::{Constant, Number, Vec2};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A double for each of two. Every operation is done on each by itself, in one instruction where the machine has
/// one; what asks about both says so.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Both(pub(crate) [f64; 2]);

impl Both {
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Both {
        Both([f(self.0[0]), f(self.0[1])])
    }

    #[inline(always)]
    fn with(self, o: Both, f: impl Fn(f64, f64) -> f64) -> Both {
        Both([f(self.0[0], o.0[0]), f(self.0[1], o.0[1])])
    }

    /// The sum of both.
    #[inline(always)]
    pub(crate) fn sum(self) -> f64 {
        self.0[0] + self.0[1]
    }

    /// The other one first.
    #[inline(always)]
    pub(crate) fn swapped(self) -> Both {
        Both([self.0[1], self.0[0]])
    }
}

impl Vec2<Both> {
    /// Of two vectors.
    #[inline(always)]
    pub(crate) fn both(one: Vec2, two: Vec2) -> Vec2<Both> {
        Vec2::new(Both([one.x, two.x]), Both([one.y, two.y]))
    }

    /// One of the two vectors.
    #[inline(always)]
    pub(crate) fn one(self, which: usize) -> Vec2 {
        Vec2::new(self.x.0[which], self.y.0[which])
    }
}

impl Add for Both {
    type Output = Both;
    #[inline(always)]
    fn add(self, o: Both) -> Both {
        self.with(o, |a, b| a + b)
    }
}

impl AddAssign for Both {
    #[inline(always)]
    fn add_assign(&mut self, o: Both) {
        *self = *self + o;
    }
}

impl Sub for Both {
    type Output = Both;
    #[inline(always)]
    fn sub(self, o: Both) -> Both {
        self.with(o, |a, b| a - b)
    }
}

impl Mul for Both {
    type Output = Both;
    #[inline(always)]
    fn mul(self, o: Both) -> Both {
        self.with(o, |a, b| a * b)
    }
}

impl Div for Both {
    type Output = Both;
    #[inline(always)]
    fn div(self, o: Both) -> Both {
        self.with(o, |a, b| a / b)
    }
}

impl Neg for Both {
    type Output = Both;
    #[inline(always)]
    fn neg(self) -> Both {
        self.each(|a| -a)
    }
}

impl Number for Both {
    #[inline(always)]
    fn of(constant: Constant) -> Both {
        Both([constant.hi; 2])
    }

    #[inline(always)]
    fn exactly(value: f64) -> Both {
        Both([value; 2])
    }

    /// The first one.
    #[inline(always)]
    fn nearest(self) -> f64 {
        self.0[0]
    }

    /// Both.
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0[0].is_finite() & self.0[1].is_finite()
    }

    #[inline(always)]
    fn scaled(self, power_of_two: f64) -> Both {
        self.each(|a| a * power_of_two)
    }

    #[inline(always)]
    fn fused(self, factor: Both, term: Both) -> Both {
        let at = |i: usize| self.0[i].mul_add(factor.0[i], term.0[i]);
        Both([at(0), at(1)])
    }

    #[inline(always)]
    fn sqrt(self) -> Both {
        self.each(f64::sqrt)
    }

    #[inline(always)]
    fn abs(self) -> Both {
        self.each(f64::abs)
    }

    #[inline(always)]
    fn min(self, other: Both) -> Both {
        self.with(other, f64::min)
    }

    /// Both.
    #[inline(always)]
    fn exceeds(self, other: Both) -> bool {
        (self.0[0] > other.0[0]) & (self.0[1] > other.0[1])
    }

    fn unit(degrees: Both) -> Vec2<Both> {
        let [one, two] = degrees.0;
        Vec2::both(angle::unit(one), angle::unit(two))
    }

    fn degrees(direction: Vec2<Both>) -> Both {
        Both([0, 1].map(|i| angle::degrees(direction.one(i))))
    }
}
