//! A circle and a line in series: RRP.

use super::{Height, Snap};
use crate::arithmetic::{Series, TERMS};
use crate::solver::state::State;
use crate::solver::step::{CircleLine, CircleRail, POSITION};
use crate::{Constant, Double, Number, Vec2};

/// A circle and a line, as they meet in series: the distance h0 of the line from the circle's centre, and
/// how far along the line that is from its own point.
pub(super) struct Cut {
    b: Series,
    h0: Series,
    /// The size of h0.
    size: Series,
    along: Series,
}

impl Cut {
    fn new(b: Constant, from: Vec2<Series>, t: Vec2<Series>, shift: Double) -> Cut {
        Cut {
            b: Series::of(b),
            h0: t.perp().dot(from) + Series::constant(shift),
            size: (t.perp().map(Series::majorant)).dot(from.map(Series::majorant)),
            along: t.dot(from),
        }
    }

    pub(super) fn reach(&self) -> [Series; 2] {
        [self.h0, self.size]
    }

    /// h^2 = (b - h0)(b + h0).
    pub(super) fn square(&self) -> Series {
        (self.b - self.h0) * (self.b + self.h0)
    }

    pub(super) fn height(&self) -> Height {
        let reach = self.b + self.size;
        let twice = self.h0.scaled(2.0);
        Height {
            square: self.square(),
            size: reach * reach,
            slopes: [-twice, twice * self.along],
        }
    }
}

/// A direction, turned by a snap.
fn turned(along: Vec2<Constant>, snap: Snap) -> Vec2<Constant> {
    let by = Vec2::new(Double::ONE, snap.by.y);
    let turned = along.map(Constant::value).turned(by) / by.norm2().sqrt();
    turned.map(|v| Constant {
        hi: v.hi,
        lo: v.lo,
        ..Constant::default()
    })
}

impl CircleRail {
    pub(super) fn cut(
        &self,
        snap: Snap,
        terms: usize,
        state: &State<Series>,
    ) -> (Vec2<Series>, Cut) {
        let t = Vec2::of(turned(self.along, snap));
        let from = state.points[self.arm.pivot.index()].p - Vec2::of(self.through);
        let from = from.map(|v| v.cut(terms));
        (t, Cut::new(self.arm.length, from, t, snap.by.x))
    }

    pub(super) fn run_through(&self, snap: Snap, root: Series, state: &mut State<Series>) {
        let (t, cut) = self.cut(snap, TERMS, state);
        let n = t.perp();
        let e = t * root - n * cut.h0;
        let s = cut.along + root;
        self.place::<Series, POSITION>(s, self.arm.direction(e), [cut.h0, root], state);
        let pivot = state.points[self.arm.pivot.index()].p;
        state.points[self.point.index()].p = pivot + e;
    }
}

impl CircleLine {
    pub(super) fn cut(
        &self,
        snap: Snap,
        terms: usize,
        state: &State<Series>,
    ) -> (Vec2<Series>, Cut) {
        let mut line = self.line;
        line.along = turned(line.along, snap);
        let guide = line.at(state);
        let from = state.points[self.arm.pivot.index()].p - guide.q.p;
        let from = from.map(|v| v.cut(terms));
        (guide.t, Cut::new(self.arm.length, from, guide.t, snap.by.x))
    }

    pub(super) fn run_through(&self, snap: Snap, root: Series, state: &mut State<Series>) {
        let (t, cut) = self.cut(snap, TERMS, state);
        let e = t * root - t.perp() * cut.h0;
        let guide = self.line.at(state);
        self.place::<Series, POSITION>(&guide, cut.along + root, e, [cut.h0, root], state);
        let pivot = state.points[self.arm.pivot.index()].p;
        state.points[self.point.index()].p = pivot + e;
    }
}
