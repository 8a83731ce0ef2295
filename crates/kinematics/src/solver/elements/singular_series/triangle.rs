//! Intersects two circles in series: RRR, with arms of fixed length or one pushed by a cylinder.

use super::{Height, InSeries, Pair, quotient, squared};
use crate::arithmetic::Series;
use crate::{Number, Vec2};

/// Two circles in series.
pub(in crate::solver::elements) struct SeriesTriangle {
    /// The vector from pivot to pivot.
    pub(in crate::solver::elements) u: Vec2<Series>,
    /// The square of the distance of the pivots.
    pub(in crate::solver::elements) d2: Series,
    /// The squares of the difference and of the sum of the arms, and the difference of their
    /// squares.
    pub(in crate::solver::elements) least: Series,
    pub(in crate::solver::elements) most: Series,
    pub(in crate::solver::elements) squares: Series,
    /// The two close places at which the pivots coincide, if they do so twice.
    pub(in crate::solver::elements) pair: Option<Pair>,
}

impl SeriesTriangle {
    /// Returns the vector from the near pivot to the point, for e x f = `height`.
    pub(in crate::solver::elements) fn arm(&self, height: Series) -> Vec2<Series> {
        let x = (self.d2 + self.squares).scaled(0.5);
        quotient(
            self.u * x + self.u.perp() * height,
            self.u,
            self.d2,
            self.pair,
        )
    }
}

impl InSeries for SeriesTriangle {
    /// Returns h^2 = (d^2 - least)(most - d^2) / 4.
    fn square(&self) -> Series {
        ((self.d2 - self.least) * (self.most - self.d2)).scaled(0.25)
    }

    fn height(&self) -> Height {
        let [d2, size] = squared(self.u);
        let [minimum, maximum] = [self.least, self.most];
        let slope = (maximum + minimum - d2 - d2).scaled(0.5);
        Height {
            square: self.square(),
            size: ((size + minimum.majorant()) * (size + maximum.majorant())).scaled(0.25),
            slopes: [slope * self.u.x, slope * self.u.y],
        }
    }
}
