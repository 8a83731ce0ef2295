//! Finds the instant centre of every moving link: a pivot, the intersection of two lines by
//! Kennedy's theorem, or from the velocity of a point.

use crate::page::Symbol;
use crate::report::working::Working;
use crate::report::working::context::Context;
use crate::report::working::loops::sides::Turns;
use crate::report::working::symbols::of_point;
use crate::scene::Scene;
use crate::solver::{Solver, State};
use crate::{Body, LinkId, PointId, SlideId, Slider, Vec2, angle};

/// Minimum sine of the angle between two lines. Below it, the rounding of printed values is
/// magnified too much.
const CROSSING: f64 = 1e-3;
/// Minimum rotation of a link, relative to the fastest velocity over the longest vector, that
/// doubles can distinguish from translation.
const TURNING: f64 = 1e-12;
/// Maximum number of links of a joint whose centres yield lines. With all of them, the time would grow
/// with the square of their number.
const MAX_LINES: usize = 16;
/// The relative error of a quotient of two solved values: a few rounding errors.
const LOSS: f64 = 64.0 * f64::EPSILON;

/// The instant centre of a link relative to the frame, for drawings.
#[derive(Clone, Debug, PartialEq)]
pub struct InstantCentre {
    /// The symbol: `I_r3`.
    pub symbol: String,
    /// The position; `None` at infinity.
    pub at: Option<Vec2>,
    /// Points on the construction lines: two, if Kennedy's theorem applies.
    pub lines: Vec<Vec2>,
}

/// The position of an instant centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum CentrePlace {
    At(Vec2),
    /// At infinity in this direction and the opposite one.
    Far(Vec2),
    /// Undefined, because the link is at rest.
    Rest,
}

/// The construction of an instant centre.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum CentreBasis {
    /// A pivot on the ground.
    Pivot(PointId),
    /// The link cannot rotate.
    Guided,
    /// The intersection of two lines; the joint of the first is farther away.
    Lines([CentreLine; 2]),
    /// The velocity of a point.
    Velocity(PointId),
}

/// A line through a joint, perpendicular to its velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CentreLine {
    pub joint: PointId,
    /// The other link of the joint, and its centre. `None` if the joint slides along a guide of the
    /// ground, or if the other centre is at infinity.
    pub through: Option<(LinkId, Vec2)>,
    /// The unit vector along the line.
    pub u: Vec2,
}

/// The instant centre of a link.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LinkCentre {
    pub link: LinkId,
    pub place: CentrePlace,
    pub basis: CentreBasis,
    /// The relative error of a value divided by the angular velocity.
    pub loss: f64,
}

impl Working {
    /// Returns the instant centres of all moving links; empty if there are no rates, or if nothing
    /// moves.
    #[must_use]
    pub fn instant_centres(
        &self,
        scene: &Scene,
        solver: &Solver,
        state: &State,
    ) -> Vec<InstantCentre> {
        let context = self.context(scene, solver, state, 1);
        let drawn = |centre: LinkCentre| InstantCentre {
            symbol: symbol(&context, centre.link).to_string(),
            at: match centre.place {
                CentrePlace::At(at) => Some(at),
                CentrePlace::Far(_) | CentrePlace::Rest => None,
            },
            lines: match &centre.basis {
                CentreBasis::Lines(lines) => lines
                    .iter()
                    .map(|line| match line.through {
                        Some((_, from)) => from,
                        None => context.state.position(line.joint),
                    })
                    .collect(),
                CentreBasis::Pivot(_) | CentreBasis::Guided | CentreBasis::Velocity(_) => {
                    Vec::new()
                }
            },
        };
        centres(&context).into_iter().map(drawn).collect()
    }
}

/// Returns the symbol of a link's instant centre, such as `I_r3`.
pub(crate) fn symbol(context: &Context<'_>, link: LinkId) -> Symbol {
    Symbol::separate("I", context.scene.link_name(link))
}

/// Returns the symbol of a point's coordinate, such as `xB`.
pub(crate) fn coordinate(context: &Context<'_>, axis: &str, point: PointId) -> Symbol {
    of_point(axis, context.scene.point_name(point).unwrap_or_default())
}

/// Returns the centres of all links, in solution order.
pub(crate) fn centres(context: &Context<'_>) -> Vec<LinkCentre> {
    if !context.has_rates() || !(context.fastest[0] > 0.0) {
        return Vec::new();
    }
    let mut finder = CentreFinder::new(context);
    for group in &context.solver.plan().groups {
        finder.group(&group.links);
    }
    finder.found
}

/// The state of the search for instant centres.
struct CentreFinder<'a> {
    context: &'a Context<'a>,
    /// The position of every point in the solution order.
    places: Vec<usize>,
    /// The guides of the ground along which every point slides.
    guides: Vec<Vec<SlideId>>,
    found: Vec<LinkCentre>,
    /// The index of every link in `found`.
    numbers: Vec<Option<usize>>,
}

impl<'a> CentreFinder<'a> {
    fn new(context: &'a Context<'a>) -> CentreFinder<'a> {
        let mechanism = &context.scene.mechanism;
        let mut guides = vec![Vec::new(); mechanism.points().len()];
        for slide in mechanism.slide_ids() {
            let given = mechanism.slide(slide);
            if let (Body::Ground, Slider::Pin(pin)) = (given.on, &given.slider) {
                guides[pin.index()].push(slide);
            }
        }
        CentreFinder {
            context,
            places: super::points::places(context),
            guides,
            found: Vec::new(),
            numbers: vec![None; mechanism.links().len()],
        }
    }

    /// Finds the centres of a group's links. Pivots and guided links come first, because lines of
    /// other links pass through their centres. Then every link with two lines follows; if none has
    /// two, the first one is found by a velocity.
    fn group(&mut self, links: &[LinkId]) {
        let mut left: Vec<LinkId> = links.to_vec();
        left.retain(|link| self.numbers[link.index()].is_none());
        while !left.is_empty() {
            let all: Vec<LinkCentre> = left.iter().map(|&link| self.centre(link)).collect();
            let rank = |centre: &LinkCentre| match centre.basis {
                CentreBasis::Pivot(_) | CentreBasis::Guided => 0,
                CentreBasis::Lines(_) => 1,
                CentreBasis::Velocity(_) => 2,
            };
            let best = all.iter().map(rank).min();
            // If only velocities are left, use one of them; its centre may provide lines for the
            // others.
            let take = if best == Some(2) { 1 } else { usize::MAX };
            let chosen = all.into_iter().filter(|centre| Some(rank(centre)) == best);
            for centre in chosen.take(take) {
                left.retain(|link| *link != centre.link);
                self.numbers[centre.link.index()] = Some(self.found.len());
                self.found.push(centre);
            }
        }
    }

    fn centre(&self, link: LinkId) -> LinkCentre {
        let (context, state) = (self.context, self.context.state);
        let omega = state.omega(link);
        let turning = omega.abs() * self.context.longest / context.fastest[0];
        let of = |place, basis| LinkCentre {
            link,
            place,
            basis,
            loss: LOSS / turning.max(LOSS),
        };
        if let Some(pivot) = pivot(context, link) {
            let at = state.position(pivot);
            return of(CentrePlace::At(at), CentreBasis::Pivot(pivot));
        }
        // The point placed first in the solution order.
        let base = named(context, link).min_by_key(|point| self.places[point.index()]);
        let Some(base) = base else {
            return of(CentrePlace::Rest, CentreBasis::Guided);
        };
        let v = state.velocity(base);
        let far = match v.norm() > LOSS * context.fastest[0] {
            true => CentrePlace::Far(v.perp() / v.norm()),
            false => CentrePlace::Rest,
        };
        if context.polygon.locks.turns(Body::Link(link), 0.0) == Turns::Never {
            return of(far, CentreBasis::Guided);
        }
        if !(turning > TURNING) {
            return of(far, CentreBasis::Velocity(base));
        }
        let lines = self.lines(link);
        if let Some((at, pair)) = crossing(context, &lines) {
            return of(CentrePlace::At(at), CentreBasis::Lines(pair));
        }
        let at = state.position(base) + v.perp() / omega;
        of(CentrePlace::At(at), CentreBasis::Velocity(base))
    }

    /// Returns the lines through a link's centre: through its joints and the centres of adjacent
    /// links, and perpendicular to the guides of the ground along which its joints slide.
    fn lines(&self, link: LinkId) -> Vec<CentreLine> {
        let (mechanism, state) = (&self.context.scene.mechanism, self.context.state);
        let mut lines = Vec::new();
        for joint in named(self.context, link) {
            let along = |u| CentreLine {
                joint,
                through: None,
                u,
            };
            let guides = self.guides[joint.index()].iter();
            lines.extend(guides.map(|&slide| along(state.travel(slide).guide.perp())));
            let links = mechanism.point(joint).links.iter();
            let pinned = links.filter_map(|other| self.found.get(self.numbers[other.index()]?));
            for other in pinned.take(MAX_LINES) {
                let (through, u) = match other.place {
                    CentrePlace::At(from) => {
                        (Some((other.link, from)), state.position(joint) - from)
                    }
                    CentrePlace::Far(u) => (None, u),
                    CentrePlace::Rest => continue,
                };
                let distance = u.norm();
                if distance > LOSS * self.context.longest {
                    lines.push(CentreLine {
                        through,
                        ..along(u / distance)
                    });
                }
            }
        }
        lines
    }
}

/// Returns the point of the ground about which a link rotates, if it has one.
fn pivot(context: &Context<'_>, link: LinkId) -> Option<PointId> {
    let mechanism = &context.scene.mechanism;
    let mut points = mechanism.link(link).members.iter().map(|m| m.point);
    points.find(|&point| mechanism.point(point).ground.is_some())
}

/// Returns the named points of a link.
pub(crate) fn named<'c>(
    context: &'c Context<'_>,
    link: LinkId,
) -> impl Iterator<Item = PointId> + 'c {
    let members = context.scene.mechanism.link(link).members.iter();
    let points = members.map(|member| member.point);
    points.filter(|&point| context.scene.point_name(point).is_some())
}

/// Returns the intersection of the two lines with the largest angle between them, the farther joint
/// first; `None` if that angle is too small.
fn crossing<'l>(context: &Context<'_>, lines: &'l [CentreLine]) -> Option<(Vec2, [CentreLine; 2])> {
    // The lines of a joint follow one another.
    let by_joint = lines.chunk_by(|one, other| one.joint == other.joint);
    let by_joint: Vec<&[CentreLine]> = by_joint.collect();
    let pairs = by_joint.iter().zip(1..).flat_map(|(own, next)| {
        let others = by_joint[next..].iter().copied().flatten();
        own.iter().flat_map(move |one| {
            let pair = move |other: &'l CentreLine| (one.u.cross(other.u).abs(), [one, other]);
            others.clone().map(pair)
        })
    });
    let (sine, best) = pairs.max_by(|(a, _), (b, _)| a.total_cmp(b))?;
    if !(sine > CROSSING) {
        return None;
    }
    let [p, q] = best.map(|line| context.state.position(line.joint));
    let [one, other] = best.map(|line| line.u);
    let at = p + one * ((q - p).cross(other) / one.cross(other));
    let [first, second] = best.map(|line| *line);
    Some(match (at - p).norm() >= (at - q).norm() {
        true => (at, [first, second]),
        false => (at, [second, first]),
    })
}

impl CentreLine {
    /// Returns the direction in degrees.
    pub(crate) fn degrees(&self) -> f64 {
        angle::degrees(self.u)
    }
}
