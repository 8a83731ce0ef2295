#![doc = include_str!("../../guide/transmission.md")]

mod interval_extrema;

#[cfg(any(test, feature = "testing"))]
pub use interval_extrema::testing::compare_extremes;

use super::elements::Step;
use super::engine::Engine;
use super::motion::positive_remainder;
use super::plan::GroupId;
use super::state::{Condition, State};
use super::{Order, Range, Solver, Varied, Workspace};
use crate::{LinkId, PointId, Vec2};
use interval_extrema::{Bracket, ExtremeFunction};

/// Tolerance for cosines estimated by parabolas between samples: brackets worse than the best
/// sample by no more than this are examined.
const COSINE_TOLERANCE: f64 = 1e-4;
/// Angles that differ by less than this, in rad, are equal: then the first extremum is reported.
const EQUALITY_TOLERANCE: f64 = 1e-12;
/// Distance from a limit, as a fraction of the range, at which the state next to it is sampled,
/// because a limit has no rates.
const INSIDE: f64 = 1e-9;

/// The transmission angle of a group over the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transmission {
    /// The group.
    pub group: GroupId,
    /// The minimum of mu.
    pub smallest: Extreme,
    /// The maximum of mu.
    pub largest: Extreme,
}

/// An extremum of a transmission angle; the one at the smallest coordinate if several are equal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The angle at the inner joint, in degrees: from 0 to 180 between two links, or to 90 if one
    /// of the two lines is the normal of a guide.
    pub angle: f64,
    /// The driver's coordinate, in degrees or the scene's length unit.
    pub at: f64,
}

impl Transmission {
    /// Returns the maximum deviation from the best angle, 90 degrees, in degrees.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        (90.0 - self.smallest.angle).max(self.largest.angle - 90.0)
    }
}

/// One of the two lines at an inner joint: its direction, not normalized, and its angular velocity.
pub(super) struct Ray {
    d: Vec2,
    w: f64,
}

impl Ray {
    /// Creates the line from point to point.
    pub(super) fn between(from: PointId, to: PointId, state: &State) -> Ray {
        let (a, b) = (state.points[from.index()], state.points[to.index()]);
        let d = b.p - a.p;
        Ray {
            d,
            w: d.cross(b.v - a.v) / d.norm2(),
        }
    }

    /// Creates a line along a direction of a link's frame.
    pub(super) fn on(link: LinkId, along: Vec2, state: &State) -> Ray {
        let link = state.links[link.index()];
        Ray {
            d: along.turned(link.d),
            w: link.w,
        }
    }

    /// Creates a line fixed in the ground.
    pub(super) fn fixed(d: Vec2) -> Ray {
        Ray { d, w: 0.0 }
    }
}

/// The inner joint of a dyad.
#[derive(Clone, Copy, Debug)]
pub(super) struct InnerJoint {
    group: usize,
    /// Whether one of the two lines is a guide's normal, which is undirected.
    has_normal: bool,
}

impl InnerJoint {
    /// Creates the inner joint between two links.
    pub(super) fn of_links(group: usize) -> InnerJoint {
        InnerJoint {
            group,
            has_normal: false,
        }
    }

    /// Creates the inner joint between a line and the normal of a guide.
    pub(super) fn line_and_normal(group: usize) -> InnerJoint {
        InnerJoint {
            group,
            has_normal: true,
        }
    }
}

/// The angle from the first to the second line of a dyad, in one state.
#[derive(Clone, Copy)]
struct DyadLines {
    at: f64,
    sine: f64,
    cosine: f64,
    /// The rate of the cosine, if it exists.
    rate: Option<f64>,
}

/// An inner joint and its step.
struct Joint<'s> {
    step: &'s Step,
    of: InnerJoint,
}

/// The minimum or maximum mu so far.
#[derive(Clone, Copy)]
struct BestAngle {
    /// -1 for the minimum, 1 for the maximum.
    sense: f64,
    /// The rank of the cosine; larger is better.
    rank: f64,
    mu: f64,
    at: f64,
}

/// A joint with the extrema and brackets found so far.
struct ObservedJoint<'s> {
    joint: Joint<'s>,
    last: Option<DyadLines>,
    best: [BestAngle; 2],
    brackets: Vec<Bracket>,
}

impl Solver {
    /// Returns the minimum and maximum transmission angle of every dyad with their positions, in
    /// the order of the plan. Coupled groups have none.
    ///
    /// Takes a few times as long as opening, because it solves the whole motion once more.
    #[must_use]
    pub fn transmission(&self) -> Vec<Transmission> {
        let mut workspace = self.state();
        let mut seen = self.observe_joints(&mut workspace);
        self.find_extrema_between(&mut seen, &mut workspace);
        seen.iter().filter_map(ObservedJoint::found).collect()
    }

    /// Returns all joints, observed over the whole motion.
    fn observe_joints(&self, workspace: &mut Workspace) -> Vec<ObservedJoint<'_>> {
        let steps = self.engine.program.steps.iter();
        let mut seen: Vec<ObservedJoint<'_>> = steps
            .filter_map(Joint::of)
            .map(ObservedJoint::new)
            .collect();
        for at in self.observed_coordinates() {
            let condition = self.solve(at, Order::Velocity, workspace);
            for seen in &mut seen {
                seen.note(&self.engine, condition, workspace);
            }
        }
        seen
    }

    /// Returns the coordinates at which the motion is observed, ascending: the samples of the
    /// tracked motion, the change points and the ends.
    fn observed_coordinates(&self) -> Vec<f64> {
        let mut at = self.motion.samples.clone();
        at.extend(&self.motion.change_points);
        match self.motion.range {
            Range::Full { period } => {
                let reduce = |at: &mut f64| *at = positive_remainder(*at, period);
                at.iter_mut().for_each(reduce);
                at.extend([0.0, period]);
            }
            Range::Limited { low, high } => {
                let inside = INSIDE * (high - low);
                at.retain(|&at| low + inside < at && at < high - inside);
                at.extend([low, low + inside, high - inside, high]);
            }
        }
        at.sort_by(f64::total_cmp);
        at.dedup();
        at
    }
}

impl Varied {
    /// Returns the transmission angle of a dyad in the last state of [`Varied::solve`], in degrees.
    /// Returns `None` without an assembly, and for a group without a transmission angle.
    #[must_use]
    pub fn transmission_angle(&self, group: GroupId) -> Option<f64> {
        let mut joints = self.steps().iter().filter_map(Joint::of);
        let joint = joints.find(|joint| GroupId::new(joint.of.group) == group)?;
        let lines = joint.lines_at(self.state().condition(), self.state())?;
        let mu = lines.sine.abs().atan2(joint.folded(lines.cosine));
        Some(mu.to_degrees())
    }
}

impl<'s> Joint<'s> {
    fn of(step: &'s Step) -> Option<Joint<'s>> {
        let of = step.inner_joint()?;
        Some(Joint { step, of })
    }

    fn lines_at(&self, condition: Condition, state: &State) -> Option<DyadLines> {
        if condition == Condition::NoAssembly {
            return None;
        }
        let [e, f] = self.step.rays(state)?;
        let size = e.d.norm() * f.d.norm();
        let (sine, cosine) = (e.d.cross(f.d) / size, e.d.dot(f.d) / size);
        let rate = -sine * (f.w - e.w);
        let has_rates = condition != Condition::DeadPoint && rate.is_finite();
        cosine.is_finite().then_some(DyadLines {
            at: state.at(),
            sine,
            cosine,
            rate: has_rates.then_some(rate),
        })
    }

    /// Returns the cosine of mu.
    fn folded(&self, cosine: f64) -> f64 {
        if self.of.has_normal {
            cosine.abs()
        } else {
            cosine
        }
    }

    /// Returns the brackets between two neighbouring states where mu has an extremum.
    fn between(&self, engine: &Engine, ends: [DyadLines; 2]) -> impl Iterator<Item = Bracket> {
        let [a, b] = ends;
        let vertex = match (a.rate, b.rate) {
            (Some(rate_a), Some(rate_b)) if rate_a * rate_b < 0.0 => {
                // The vertex of a parabola. If mu is constant, its gain may be rounding error.
                let share = rate_a / (rate_a - rate_b);
                let gain = 0.5 * share * engine.difference(a.at, b.at) * rate_a;
                (gain.abs() > 0.5 * EQUALITY_TOLERANCE * a.sine.abs()).then_some(a.cosine + gain)
            }
            _ => None,
        };
        let upright = (self.folded(-1.0) > 0.0 && a.cosine * b.cosine < 0.0).then_some(0.0);
        let bracket = move |reading| {
            move |cosine| Bracket {
                ends,
                reading,
                cosine,
            }
        };
        let vertex = vertex.map(bracket(ExtremeFunction::Rate));
        vertex
            .into_iter()
            .chain(upright.map(bracket(ExtremeFunction::Cosine)))
    }
}

impl BestAngle {
    fn new(sense: f64) -> BestAngle {
        BestAngle {
            sense,
            rank: f64::NEG_INFINITY,
            mu: f64::NAN,
            at: f64::NAN,
        }
    }

    /// Returns the rank of a cosine: small angles have large cosines.
    fn rank(&self, folded: f64) -> f64 {
        -self.sense * folded
    }

    /// Takes another mu if it is better, or equal and earlier.
    fn consider(&mut self, look: &DyadLines, folded: f64) {
        let rank = self.rank(folded);
        let mu = look.sine.abs().atan2(folded);
        let gain = self.sense * (mu - self.mu);
        let comes_first = gain >= -EQUALITY_TOLERANCE && look.at < self.at;
        if self.mu.is_nan() || gain > EQUALITY_TOLERANCE || comes_first {
            (self.rank, self.mu, self.at) = (rank, mu, look.at);
        }
    }

    fn extreme(&self) -> Option<Extreme> {
        let angle = self.mu.to_degrees();
        angle.is_finite().then_some(Extreme { angle, at: self.at })
    }
}

impl<'s> ObservedJoint<'s> {
    fn new(joint: Joint<'s>) -> ObservedJoint<'s> {
        ObservedJoint {
            joint,
            last: None,
            best: [BestAngle::new(-1.0), BestAngle::new(1.0)],
            brackets: Vec::new(),
        }
    }

    /// Observes the next state.
    fn note(&mut self, engine: &Engine, condition: Condition, state: &State) {
        let Some(look) = self.joint.lines_at(condition, state) else {
            return;
        };
        let folded = self.joint.folded(look.cosine);
        for best in &mut self.best {
            // Comparing cosines first avoids an arctangent at most positions.
            if best.rank(folded) > best.rank {
                best.consider(&look, folded);
            }
        }
        if let Some(last) = self.last.replace(look) {
            let between = self.joint.between(engine, [last, look]);
            self.brackets.extend(between);
        }
    }

    /// Removes all brackets and returns those that may contain a smaller or larger mu than found so
    /// far.
    fn take_likely(&mut self) -> impl Iterator<Item = Bracket> {
        let (joint, best) = (&self.joint, &self.best);
        self.brackets.drain(..).filter(|bracket| {
            let folded = joint.folded(bracket.cosine);
            best.iter()
                .any(|best| best.rank(folded) >= best.rank - COSINE_TOLERANCE)
        })
    }

    /// Takes account of an extremum found between two states.
    fn consider(&mut self, look: &DyadLines) {
        let folded = self.joint.folded(look.cosine);
        self.best
            .iter_mut()
            .for_each(|best| best.consider(look, folded));
    }

    fn found(&self) -> Option<Transmission> {
        let [smallest, largest] = self.best;
        Some(Transmission {
            group: GroupId::new(self.joint.of.group),
            smallest: smallest.extreme()?,
            largest: largest.extreme()?,
        })
    }
}
