//! Describes guides as lines: a known point, a known direction and the chord of a circle.

use super::REACH_SLACK;
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{PointState, State};
use crate::{Constant, LinkId, Number, PointId, Vec2};

/// A line fixed in a body: through a point, along a direction of a link's frame.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct GuideLine {
    pub through: PointId,
    pub link: LinkId,
    /// The direction in the link's frame: a unit vector.
    pub along: Vec2<Constant>,
}

/// A line in one state: its point, direction, normal, angular velocity and angular acceleration.
#[derive(Clone, Copy)]
pub(in crate::solver) struct GuideAt<T = f64> {
    pub(in crate::solver) q: PointState<T>,
    pub(in crate::solver) t: Vec2<T>,
    pub(in crate::solver) n: Vec2<T>,
    pub(in crate::solver) w: T,
    pub(in crate::solver) a: T,
}

impl GuideLine {
    /// Returns the point and the link that the line follows.
    pub(super) fn inputs(&self) -> [PlacedPart; 2] {
        [PlacedPart::Point(self.through), PlacedPart::Link(self.link)]
    }

    #[inline(always)]
    pub(in crate::solver) fn at<T: Number>(&self, state: &State<T>) -> GuideAt<T> {
        let link = state.links[self.link.index()];
        let t = Vec2::of(self.along).turned(link.d);
        GuideAt {
            q: state.points[self.through.index()],
            t,
            n: t.perp(),
            w: link.w,
            a: link.a,
        }
    }
}

impl<T: Number> GuideAt<T> {
    /// Returns the point at s along the guide, with its rate and second rate.
    #[inline(always)]
    pub(super) fn point(&self, s: T, rate: T, second: T) -> PointState<T> {
        PointState {
            p: self.q.p + self.t * s,
            v: self.velocity(s) + self.t * rate,
            a: self.acceleration(s, rate) + self.t * second,
        }
    }

    /// Returns the velocity of the guide's own material at s.
    #[inline(always)]
    pub(super) fn velocity(&self, s: T) -> Vec2<T> {
        self.q.v + self.n * (self.w * s)
    }

    /// Returns the acceleration, Coriolis term included, of a point that slides at a constant rate
    /// at s.
    #[inline(always)]
    pub(super) fn acceleration(&self, s: T, rate: T) -> Vec2<T> {
        let turning = self.a * s + (self.w * rate).scaled(2.0);
        self.q.a + self.n * turning - self.t * (self.w * self.w * s)
    }
}

/// The chord of a circle on a line at distance h0 from its centre: half the chord is the square
/// root of (b - h0)(b + h0).
pub(super) struct Chord<T> {
    pub(super) product: T,
    /// The distances of the line from being tangent on either side, and their rounding tolerance.
    reaches: [T; 2],
    slack: T,
}

impl<T: Number> Chord<T> {
    #[inline(always)]
    pub(super) fn new(length: T, h0: T, from: Vec2<T>) -> Chord<T> {
        let (left, right) = (length - h0, length + h0);
        Chord {
            product: left * right,
            reaches: [left, right],
            slack: (length + from.x.abs() + from.y.abs())
                .scaled(REACH_SLACK * T::RELATIVE_ROUNDING),
        }
    }

    #[inline(always)]
    pub(super) fn is_clear(&self) -> bool {
        let [left, right] = self.reaches;
        left.exceeds(self.slack) && right.exceeds(self.slack)
    }

    /// Returns `true` if the line touches the circle within rounding.
    pub(super) fn touches(&self) -> bool {
        let touches = |reach: T| reach.is_finite() && !(-self.slack).exceeds(reach);
        self.reaches.into_iter().all(touches)
    }
}
