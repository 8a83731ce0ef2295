//! The dyad RPR: an arm that turns about a pivot and slides through a pin.

use super::{ACCELERATION, Outcome, REACH_SLACK, VELOCITY};
use crate::solver::state::{LinkState, State};
use crate::{LinkId, PointId, Vec2};

/// An arm that turns about a pivot and slides through a pin, RPR. The sign is that of
/// t.(pin - pivot).
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Swing {
    pub pivot: PointId,
    pub pin: PointId,
    pub link: LinkId,
    /// The guide's direction in the link's frame: a unit vector.
    pub along: Vec2,
    /// n.(pin - pivot): how far the guide passes the pivot.
    pub offset: f64,
    pub group: usize,
}

impl Swing {
    /// w = B - O = s t + e n, hence s = +-sqrt((D - e)(D + e)) and t = w (s - i e) / D^2.
    #[inline]
    pub(super) fn run<const ORDER: u8>(&self, state: &mut State) -> Outcome {
        let o = state.points[self.pivot.index()];
        let b = state.points[self.pin.index()];
        let e = self.offset;
        let w = b.p - o.p;
        let d2 = w.norm2();
        let d = d2.sqrt();
        let inner = d - e.abs();
        state.measures[self.group] = inner * (d + e.abs());
        let slack = REACH_SLACK * (d + e.abs() + b.p.x.abs() + b.p.y.abs());
        if !(inner >= -slack) {
            return Outcome::Open;
        }
        let stretched = inner <= slack;
        let s = if stretched {
            0.0
        } else {
            state.signs[self.group] * (inner * (d + e.abs())).sqrt()
        };
        if d2 == 0.0 {
            // The pin stands on the pivot: no direction exists.
            return Outcome::Open;
        }
        let t = w.turned(Vec2::new(s, -e)) * (1.0 / d2);
        let mut link = LinkState {
            d: t.turned(self.along.conj()),
            ..LinkState::default()
        };
        if stretched {
            state.links[self.link.index()].d = link.d;
            return Outcome::Stretched;
        }
        if ORDER >= VELOCITY {
            let n = t.perp();
            let scale = 1.0 / s;
            let dv = b.v - o.v;
            link.w = n.dot(dv) * scale;
            if ORDER >= ACCELERATION {
                let rate = t.dot(dv) + e * link.w;
                let da = b.a - o.a;
                link.a = (n.dot(da) - 2.0 * rate * link.w + e * link.w * link.w) * scale;
            }
        }
        state.links[self.link.index()] = link;
        Outcome::Done
    }
}
