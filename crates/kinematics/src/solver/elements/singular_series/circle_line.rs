//! Intersects a circle and a line in series: RRP.

use super::{Height, InSeries, SingularShift, size};
use crate::arithmetic::Series;
use crate::{Constant, Double, Number, Vec2};

/// A circle and a line in series: the distance h0 of the line from the circle's centre, and the
/// coordinate of the centre along the line from the line's own point.
pub(in crate::solver::elements) struct Cut {
    /// The direction of the line.
    t: Vec2<Series>,
    b: Series,
    pub(in crate::solver::elements) h0: Series,
    /// The size of h0.
    size: Series,
    pub(in crate::solver::elements) along: Series,
}

impl Cut {
    pub(in crate::solver::elements) fn new(
        b: Constant,
        from: Vec2<Series>,
        t: Vec2<Series>,
        shift: Double,
    ) -> Cut {
        Cut {
            t,
            b: Series::of(b),
            h0: t.perp().dot(from) + Series::constant(shift),
            size: size(t) * size(from),
            along: t.dot(from),
        }
    }

    /// Returns the vector from the circle's centre to the point, for this height.
    pub(in crate::solver::elements) fn arm(&self, height: Series) -> Vec2<Series> {
        self.t * height - self.t.perp() * self.h0
    }

    pub(in crate::solver::elements) fn reach(&self) -> [Series; 2] {
        [self.h0, self.size]
    }
}

impl InSeries for Cut {
    /// Returns h^2 = (b - h0)(b + h0).
    fn square(&self) -> Series {
        (self.b - self.h0) * (self.b + self.h0)
    }

    fn height(&self) -> Height {
        let reach = self.b + self.size;
        let twice = self.h0.scaled(2.0);
        Height {
            square: self.square(),
            size: reach * reach,
            slopes: [-twice, twice * self.along],
        }
    }
}

/// Returns a direction turned by a snap.
pub(in crate::solver::elements) fn turned(
    along: Vec2<Constant>,
    snap: SingularShift,
) -> Vec2<Constant> {
    let by = Vec2::new(Double::ONE, snap.by.y);
    let turned = along.map(Constant::value).turned(by) / by.norm2().sqrt();
    turned.map(|v| Constant {
        hi: v.hi,
        lo: v.lo,
        ..Constant::default()
    })
}
