//! Two circles in series: RRR, with arms of fixed length or one that a cylinder pushes.

use super::{Height, Snap, between, quotient, shifted, squared};
use crate::arithmetic::Series;
use crate::solver::state::State;
use crate::solver::step::{Circles, Cylinder};
use crate::{Number, Vec2};

/// Two circles, as they meet in series.
pub(super) struct Triangle {
    /// From pivot to pivot.
    pub(super) u: Vec2<Series>,
    /// The square of that.
    d2: Series,
    /// The squares of the difference and of the sum of the arms, and the difference of their squares.
    least: Series,
    most: Series,
    squares: Series,
}

impl Triangle {
    /// h^2 = (d^2 - least)(most - d^2) / 4.
    pub(super) fn square(&self) -> Series {
        ((self.d2 - self.least) * (self.most - self.d2)).scaled(0.25)
    }

    pub(super) fn height(&self) -> Height {
        let [d2, size] = squared(self.u);
        let [least, most] = [self.least, self.most];
        let slope = (most + least - d2 - d2).scaled(0.5);
        Height {
            square: self.square(),
            size: ((size + least.majorant()) * (size + most.majorant())).scaled(0.25),
            slopes: [slope * self.u.x, slope * self.u.y],
        }
    }

    /// From the nearer pivot to the point, for e x f = `height`.
    pub(super) fn arm(&self, height: Series) -> Vec2<Series> {
        let x = (self.d2 + self.squares).scaled(0.5);
        quotient(self.u * x + self.u.perp() * height, self.u, self.d2)
    }
}

impl Circles {
    pub(super) fn triangle(&self, snap: Snap, terms: usize, state: &State<Series>) -> Triangle {
        let u = shifted(between(self.near.pivot, self.far.pivot, state), snap, terms);
        let (b, c) = (self.near.length, self.far.length);
        let c = if snap.equal_arms { b } else { c };
        let [least, most, squares] =
            [(c - b) * (c - b), (c + b) * (c + b), (b - c) * (b + c)].map(Series::of);
        Triangle {
            u,
            d2: u.norm2(),
            least,
            most,
            squares,
        }
    }
}

impl Cylinder {
    pub(super) fn triangle_of(
        &self,
        q: Series,
        snap: Snap,
        terms: usize,
        state: &State<Series>,
    ) -> Triangle {
        let u = shifted(between(self.pivot, self.far.pivot, state), snap, terms);
        let rho2 = self.arm_square(q);
        let (b, c) = (rho2.sqrt(), Series::of(self.far.length));
        Triangle {
            u,
            d2: u.norm2(),
            least: (c - b) * (c - b),
            most: (c + b) * (c + b),
            squares: rho2 - c * c,
        }
    }
}
