//! Measures the difference between a state and the reference.

use crate::solver::Solver;
use crate::solver::state::State;
use crate::{Ball, Double, LinkId, Mechanism, Number, PointId, Vec2};

/// Magnitudes of positions, velocities and accelerations, or of their differences. Derivatives are
/// by the driver's coordinate; lengths are relative to the longest one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// The position, relative to the longest length.
    pub position: f64,
    /// The first derivative by the driver's coordinate.
    pub velocity: f64,
    /// The second derivative by the driver's coordinate.
    pub acceleration: f64,
}

impl Deviation {
    /// Returns the component-wise maximum.
    pub fn max(self, other: Deviation) -> Deviation {
        Deviation {
            position: self.position.max(other.position),
            velocity: self.velocity.max(other.velocity),
            acceleration: self.acceleration.max(other.acceleration),
        }
    }

    /// Returns `true` if no value is infinite or NaN.
    pub fn is_finite(self) -> bool {
        // A sum of magnitudes is finite only if each is.
        (self.position + self.velocity + self.acceleration).is_finite()
    }
}

/// The compared points and links of a state.
pub(super) struct Subjects {
    /// The scene's moving points.
    points: Vec<PointId>,
    /// The links with a single point, whose rotation no point shows. They count as if they carried
    /// another point at the longest length.
    links: Vec<LinkId>,
    /// The longest length in the solver's unit.
    pub(super) longest: f64,
}

impl Subjects {
    pub(super) fn new(mechanism: &Mechanism, solver: &Solver) -> Subjects {
        let is_moving = |p: &PointId| mechanism.point(*p).ground.is_none();
        let is_lonely = |l: &LinkId| mechanism.link(*l).members.len() == 1;
        Subjects {
            points: mechanism.point_ids().filter(is_moving).collect(),
            links: mechanism.link_ids().filter(is_lonely).collect(),
            longest: solver.engine.frame.longest,
        }
    }

    /// Returns the maximum differences of a state from the reference; not finite if the state is
    /// not.
    pub(super) fn deviation<T: Number>(
        &self,
        state: &State<T>,
        reference: &State<Double>,
    ) -> Deviation {
        self.gather(
            |p| {
                let (p, q) = (&state.points[p.index()], &reference.points[p.index()]);
                [distance(p.p, q.p), distance(p.v, q.v), distance(p.a, q.a)]
            },
            |l| {
                let (l, m) = (&state.links[l.index()], &reference.links[l.index()]);
                let far = |a: T, b: Double| (Double::exactly(a.nearest()) - b).nearest().abs();
                [distance(l.d, m.d), far(l.w, m.w), far(l.a, m.a)]
            },
        )
    }

    /// Returns the maximum velocity and acceleration of a state.
    pub(super) fn sizes(&self, state: &State<Double>) -> Deviation {
        self.gather(
            |p| {
                let p = &state.points[p.index()];
                [0.0, p.v.nearest().norm(), p.a.nearest().norm()]
            },
            |l| {
                let l = &state.links[l.index()];
                [0.0, l.w.nearest().abs(), l.a.nearest().abs()]
            },
        )
    }

    /// Returns `true` if every ball is bounded and contains the value of the reference.
    pub(super) fn hold(&self, enclosure: &State<Ball>, reference: &State<Double>) -> bool {
        let holds = |ball: Vec2<Ball>, value: Vec2<Double>| {
            let inside = |ball: Ball, value: Double| {
                let off = (value - Double::exactly(ball.mid)).nearest().abs();
                off <= ball.radius && ball.radius.is_finite()
            };
            inside(ball.x, value.x) && inside(ball.y, value.y)
        };
        self.points.iter().all(|p| {
            let (ball, value) = (&enclosure.points[p.index()], &reference.points[p.index()]);
            holds(ball.p, value.p) && holds(ball.v, value.v) && holds(ball.a, value.a)
        })
    }

    fn gather(
        &self,
        of_point: impl Fn(&PointId) -> [f64; 3],
        of_link: impl Fn(&LinkId) -> [f64; 3],
    ) -> Deviation {
        let points = self
            .points
            .iter()
            .map(|p| of_point(p).map(|v| v / self.longest));
        let links = self.links.iter().map(of_link);
        // Negated so that NaN persists.
        let larger = |a: f64, b: f64| if b <= a { a } else { b };
        let [position, velocity, acceleration] =
            points.chain(links).fold([0.0; 3], |maximum, here| {
                std::array::from_fn(|i| larger(maximum[i], here[i]))
            });
        Deviation {
            position,
            velocity,
            acceleration,
        }
    }
}

/// Returns the distance of two vectors.
fn distance<T: Number>(one: Vec2<T>, two: Vec2<Double>) -> f64 {
    let one: Vec2<Double> = one.nearest().exactly();
    (one - two).nearest().norm()
}
