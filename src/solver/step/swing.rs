//! The dyad RPR: an arm that turns about a pivot and slides through a pin.

use super::{ACCELERATION, Outcome, REACH_SLACK, VELOCITY};
use crate::solver::state::{LinkState, State};
use crate::{Constant, LinkId, Number, PointId, Vec2};

/// An arm that turns about a pivot and slides through a pin, RPR. The sign is that of
/// t.(pin - pivot).
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Swing {
    pub pivot: PointId,
    pub pin: PointId,
    pub link: LinkId,
    /// The guide's direction in the link's frame: a unit vector.
    pub along: Vec2<Constant>,
    /// n.(pin - pivot): how far the guide passes the pivot.
    pub offset: Constant,
    pub group: usize,
}

impl Swing {
    /// From the pivot to the pin, the distance and its square, and its rounding.
    #[inline(always)]
    fn reach<T: Number>(&self, state: &State<T>) -> (Vec2<T>, T, T, T) {
        let pin = state.points[self.pin.index()].p;
        let w = pin - state.points[self.pivot.index()].p;
        let d2 = w.norm2();
        let d = d2.sqrt();
        let size = d + T::of(self.offset.abs()) + pin.x.abs() + pin.y.abs();
        (w, d, d2, size.scaled(REACH_SLACK * T::GRAIN))
    }

    /// w = B - O = s t + e n, hence s = +-sqrt((D - e)(D + e)) and t = w (s - i e) / D^2.
    #[inline(always)]
    pub(super) fn run<T: Number, const ORDER: u8>(&self, state: &mut State<T>) -> Outcome {
        let (w, d, d2, slack) = self.reach(state);
        let e = T::of(self.offset);
        let inner = d - e.abs();
        let product = inner * (d + e.abs());
        state.measures[self.group] = product;
        if !inner.exceeds(slack) {
            return Outcome::Unclear;
        }
        let s = state.signs[self.group] * product.sqrt();
        let t = w.turned(Vec2::new(s, -e)) * (T::exactly(1.0) / d2);
        self.place::<T, ORDER>(t, s, state);
        Outcome::Done
    }

    /// Writes the arm with its guide along t, the pin at s along it.
    #[inline(always)]
    pub(in crate::solver) fn place<T: Number, const ORDER: u8>(
        &self,
        t: Vec2<T>,
        s: T,
        state: &mut State<T>,
    ) {
        let mut link = LinkState::fixed(t.turned(Vec2::of(self.along.conj())));
        if ORDER >= VELOCITY {
            let o = state.points[self.pivot.index()];
            let b = state.points[self.pin.index()];
            let e = T::of(self.offset);
            let n = t.perp();
            let scale = T::exactly(1.0) / s;
            let dv = b.v - o.v;
            link.w = n.dot(dv) * scale;
            if ORDER >= ACCELERATION {
                let rate = t.dot(dv) + e * link.w;
                let da = b.a - o.a;
                link.a = (n.dot(da) - (rate * link.w).scaled(2.0) + e * link.w * link.w) * scale;
            }
        }
        state.links[self.link.index()] = link;
    }

    /// Whether within rounding the guide reaches the line from pivot to pin, and that has a direction.
    pub(super) fn is_in_reach<T: Number>(&self, state: &State<T>) -> bool {
        let (_, d, d2, slack) = self.reach(state);
        let reach = d - T::of(self.offset).abs();
        d.is_finite() && d2.exceeds(T::default()) && !(-slack).exceeds(reach)
    }

    /// The guide across the line from pivot to pin: positions alone.
    pub(super) fn align<T: Number>(&self, state: &mut State<T>) {
        let (w, _, d2, _) = self.reach(state);
        let across = Vec2::new(T::default(), -T::of(self.offset));
        let t = w.turned(across) * (T::exactly(1.0) / d2);
        self.place::<T, { super::POSITION }>(t, T::default(), state);
    }
}
