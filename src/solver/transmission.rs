//! The transmission angles of the dyads over the whole motion.
//!
//! At the inner joint of a dyad two lines meet that hold it: of a link, the line from the pin that is
//! known to the joint; of a slide, the normal of its guide, along which it pushes. The transmission
//! angle mu lies between them. Two links make any angle from 0 to 180 degrees, and 90 is best: an
//! engineer asks that neither the smallest is below some 40 nor the largest above some 140. A normal
//! has no sense of its own, and with one of them mu is at most 90.
//!
//! mu does not depend on the path, so it is read off states at the coordinates of the walk, and an
//! extreme between two of them is the zero of its rate: (cos mu)' = -sin mu (w2 - w1), with w1 and w2
//! the turning of the two lines. Change points and limits are looked at themselves.

use super::motion::positive_remainder;
use super::plan::GroupId;
use super::state::{Condition, State};
use super::step::Step;
use super::workspace::Workspace;
use super::{Order, Range, Solver};
use crate::numeric::{few_decimals, root};
use crate::{LinkId, PointId, Vec2};

/// Cosines that differ by no more are equal as far as parabolas between samples tell: brackets as
/// good as the best one by this much are looked into.
const LIKELY: f64 = 1e-4;
/// Angles in rad that differ by less are one: then the extreme that comes first is named.
const SAME: f64 = 1e-12;
/// An extreme is flat: its rate, a difference of two turnings, is rounding for so many units in the last
/// place around it, and of these the one with few decimals is named: 0 rather than -6e-15 degrees.
const BLUR: f64 = 1024.0;
/// A limit has no rates; it is looked at from this far inside, as a part of the range.
const INSIDE: f64 = 1e-9;

/// The transmission angle of a group over the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transmission {
    /// The group.
    pub group: GroupId,
    /// Where mu is smallest.
    pub smallest: Extreme,
    /// Where mu is largest.
    pub largest: Extreme,
}

/// An extreme of a transmission angle: of several equal ones, the one at the smallest coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The angle at the inner joint in degrees: from 0 to 180 between two links, to 90 where one of
    /// the two lines is the normal of a guide.
    pub angle: f64,
    /// The driver's coordinate, in degrees or the scene's length unit.
    pub at: f64,
}

impl Transmission {
    /// The largest deviation from the best angle, 90 degrees, in degrees.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        (90.0 - self.smallest.angle).max(self.largest.angle - 90.0)
    }
}

/// One of the two lines at an inner joint: its direction, of any length, and its turning.
struct Ray {
    d: Vec2,
    w: f64,
}

/// The lines of a dyad in one state: the angle from the first to the second.
#[derive(Clone, Copy)]
struct Look {
    at: f64,
    sine: f64,
    cosine: f64,
    /// The rate of the cosine, where there are rates.
    rate: Option<f64>,
}

/// What has its zero at an extreme: for lines without a sense mu is 90 degrees at the most, where the
/// cosine changes its sign.
#[derive(Clone, Copy)]
enum Reading {
    Rate,
    Cosine,
}

/// A place that may be an extreme: a coordinate, or one between two of them.
#[derive(Clone, Copy)]
enum Place {
    At(Look),
    Between(Look, Look, Reading),
}

/// A place and its cosine there, as far as that is known yet.
struct Candidate {
    cosine: f64,
    place: Place,
}

/// The inner joint of a dyad.
struct Joint<'s> {
    solver: &'s Solver,
    step: &'s Step,
    group: usize,
}

impl Solver {
    /// The smallest and the largest transmission angle of every dyad, with where they occur, in the
    /// order of the plan. Coupled groups have none.
    ///
    /// Takes a few times as long as opening: the whole motion is looked at once more.
    #[must_use]
    pub fn transmission(&self) -> Vec<Transmission> {
        let steps = self.engine.program.steps.iter();
        let joints: Vec<Joint<'_>> = steps.filter_map(|step| Joint::of(self, step)).collect();
        let mut looks: Vec<Vec<Look>> = joints.iter().map(|_| Vec::new()).collect();
        let mut state = self.state();
        for at in self.looked_at() {
            let condition = self.solve(at, Order::Velocity, &mut state);
            for (joint, looks) in joints.iter().zip(&mut looks) {
                looks.extend(joint.look(condition, &state));
            }
        }
        let found = joints.iter().zip(&looks);
        found
            .filter_map(|(joint, looks)| joint.extremes(looks, &mut state))
            .collect()
    }

    /// Where the motion is looked at, ascending: where the walk has been, at change points and at the
    /// ends.
    fn looked_at(&self) -> Vec<f64> {
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

impl<'s> Joint<'s> {
    fn of(solver: &'s Solver, step: &'s Step) -> Option<Joint<'s>> {
        let group = match step {
            Step::Lines { group, .. } => Some(*group),
            step => step.choice(),
        }?;
        Some(Joint {
            solver,
            step,
            group,
        })
    }

    fn look(&self, condition: Condition, state: &State) -> Option<Look> {
        if condition == Condition::NoAssembly {
            return None;
        }
        let [e, f] = rays(self.step, state)?;
        let size = e.d.norm() * f.d.norm();
        let (sine, cosine) = (e.d.cross(f.d) / size, e.d.dot(f.d) / size);
        let rate = -sine * (f.w - e.w);
        let has_rates = condition != Condition::DeadPoint && rate.is_finite();
        cosine.is_finite().then_some(Look {
            at: state.at(),
            sine,
            cosine,
            rate: has_rates.then_some(rate),
        })
    }

    /// The cosine of mu.
    fn folded(&self, cosine: f64) -> f64 {
        match self.step {
            Step::Circles(_) | Step::Cylinder(_) => cosine,
            _ => cosine.abs(),
        }
    }

    fn extremes(&self, looks: &[Look], state: &mut Workspace) -> Option<Transmission> {
        let known = looks.iter().map(|&look| Candidate {
            cosine: look.cosine,
            place: Place::At(look),
        });
        let between = looks.windows(2).flat_map(|pair| self.between(pair));
        let mut candidates: Vec<Candidate> = known.chain(between).collect();
        candidates.sort_by(|a, b| a.place.start().total_cmp(&b.place.start()));
        Some(Transmission {
            group: GroupId::new(self.group),
            smallest: self.extreme(&candidates, -1.0, state)?,
            largest: self.extreme(&candidates, 1.0, state)?,
        })
    }

    /// The places between two neighbours where mu turns back.
    fn between(&self, pair: &[Look]) -> Vec<Candidate> {
        let &[a, b] = pair else { return Vec::new() };
        let mut found = Vec::new();
        if let (Some(rate_a), Some(rate_b)) = (a.rate, b.rate)
            && rate_a * rate_b < 0.0
        {
            // The vertex of a parabola.
            let share = rate_a / (rate_a - rate_b);
            let away = self.solver.engine.difference(a.at, b.at);
            found.push(Candidate {
                cosine: a.cosine + 0.5 * share * away * rate_a,
                place: Place::Between(a, b, Reading::Rate),
            });
        }
        if self.folded(-1.0) > 0.0 && a.cosine * b.cosine < 0.0 {
            found.push(Candidate {
                cosine: 0.0,
                place: Place::Between(a, b, Reading::Cosine),
            });
        }
        found
    }

    /// The smallest (`sense` -1) or largest (1) mu among all places.
    fn extreme(&self, places: &[Candidate], sense: f64, state: &mut Workspace) -> Option<Extreme> {
        // Small angles have large cosines.
        let rank = |c: &Candidate| -sense * self.folded(c.cosine);
        let best = places.iter().map(rank).fold(f64::NEG_INFINITY, f64::max);
        let likely = places.iter().filter(|c| rank(c) >= best - LIKELY);
        let mut found: Option<(f64, f64)> = None;
        for candidate in likely {
            let Some(look) = self.settled(candidate.place, state) else {
                continue;
            };
            let mu = look.sine.abs().atan2(self.folded(look.cosine));
            if found.is_none_or(|(best, _)| sense * (mu - best) > SAME) {
                found = Some((mu, look.at));
            }
        }
        found.map(|(mu, at)| Extreme {
            angle: mu.to_degrees(),
            at,
        })
    }

    fn settled(&self, place: Place, state: &mut Workspace) -> Option<Look> {
        let (a, b, reading) = match place {
            Place::At(look) => return Some(look),
            Place::Between(a, b, reading) => (a, b, reading),
        };
        let read = |look: &Look| match reading {
            Reading::Rate => look.rate,
            Reading::Cosine => Some(look.cosine),
        };
        let mut solved = |at: f64| {
            let condition = self.solver.solve(at, Order::Velocity, state);
            self.look(condition, state)
        };
        let finest = self.solver.engine.finest();
        let ends = [(a.at, read(&a)?), (b.at, read(&b)?)];
        let at = root(ends[0], ends[1], finest, |at| read(&solved(at)?)).ok()?;
        let round = few_decimals(at);
        let is_blurred = (round - at).abs() <= BLUR * finest.max(f64::EPSILON * at.abs());
        solved(if is_blurred { round } else { at })
    }
}

impl Place {
    fn start(&self) -> f64 {
        match self {
            Place::At(look) | Place::Between(look, _, _) => look.at,
        }
    }
}

/// The two lines at the inner joint of a dyad: between links, these; beside a guide, its normal.
fn rays(step: &Step, state: &State) -> Option<[Ray; 2]> {
    let from = |from: PointId, to: PointId| {
        let (a, b) = (state.points[from.index()], state.points[to.index()]);
        let d = b.p - a.p;
        Ray {
            d,
            w: d.cross(b.v - a.v) / d.norm2(),
        }
    };
    let on = |link: LinkId, along: Vec2| {
        let link = state.links[link.index()];
        Ray {
            d: along.turned(link.d),
            w: link.w,
        }
    };
    match step {
        Step::Circles(c) => Some([from(c.near.pivot, c.point), from(c.far.pivot, c.point)]),
        Step::Cylinder(c) => Some([from(c.pivot, c.point), from(c.far.pivot, c.point)]),
        Step::CircleLine(c) => Some([
            from(c.arm.pivot, c.point),
            on(c.line.link, c.line.along.nearest().perp()),
        ]),
        Step::CircleRail(c) => {
            let normal = Ray {
                d: c.along.nearest().perp(),
                w: 0.0,
            };
            Some([from(c.arm.pivot, c.point), normal])
        }
        Step::Swing(s) => Some([from(s.pivot, s.pin), on(s.link, s.along.nearest().perp())]),
        Step::Lines { first, second, .. } => Some([
            on(first.link, first.along.nearest()),
            on(second.link, second.along.nearest()),
        ]),
        Step::Crank { .. }
        | Step::Spin { .. }
        | Step::Ride { .. }
        | Step::Push { .. }
        | Step::Aim { .. }
        | Step::Lock { .. }
        | Step::Coupled { .. }
        | Step::Travel { .. } => None,
    }
}
