//! Passages through change points.
//!
//! Where the arms of a dyad come into line at the extreme of their reach, exactly, its two
//! assemblies meet and the motion goes on smoothly: from then on on the other side, so that the sign
//! which names the assembly changes. At the point itself and close to it the dyad's equations lose
//! their digits - the second derivatives as the inverse cube of the distance - though the motion is
//! smooth; there the dyad is placed by a short Taylor series, whose coefficients come from the motion
//! around.

use super::engine::Engine;
use super::motion::positive_remainder;
use super::state::{LinkState, PointState, State};
use super::step::Step;
use crate::{LinkId, PointId, Vec2};

/// Within this of a change point, in radians or scaled lengths, the series takes the dyad's place.
/// Its error is the cube of it; closer, the dyad itself has fewer digits than that.
const ZONE: f64 = 1e-5;
/// A coordinate that differs from a change point by less than this part of it is the change point.
const SAME: f64 = 4.0 * f64::EPSILON;
/// The motion is looked at as far as this around a change point, in radians or scaled lengths,
const REACH: f64 = 0.25;
/// at this many places: Chebyshev's, so that the polynomial through them is right to rounding
/// unless the next singularity is closer than the reach itself.
const PLACES: usize = 20;
/// So often the reach is halved before a change point is given up as a limit.
const REACHES: i32 = 7;
/// A series is held against the motion at this distance,
const PROOF: f64 = 1e-3;
/// where it may miss by the third order, its cube with room for a quick dyad: another assembly, or a
/// polynomial across a change point, misses by far more.
const PROVEN: f64 = 1e-6;

/// A dyad's way through one of its change points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage {
    /// The driver's coordinate, reduced to one period if there is one.
    pub at: f64,
    /// The dyad.
    pub group: usize,
    point: Option<(PointId, PointState)>,
    links: [Option<(LinkId, LinkState)>; 2],
}

/// All passages of a motion.
#[derive(Clone, Debug, Default)]
pub(super) struct Passages {
    list: Vec<Passage>,
    start: f64,
    /// 0 where coordinates are not reduced.
    period: f64,
}

impl Passages {
    pub(super) fn new(mut list: Vec<Passage>, start: f64, period: f64) -> Passages {
        for passage in &mut list {
            passage.at = reduced(passage.at, period);
        }
        list.sort_by(|a, b| a.at.total_cmp(&b.at));
        let start = reduced(start, period);
        Passages {
            list,
            start,
            period,
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The driver's coordinates of the change points, each once.
    pub(super) fn coordinates(&self) -> Vec<f64> {
        let mut at: Vec<f64> = self.list.iter().map(|p| p.at).collect();
        at.dedup();
        at
    }

    /// Gives every dyad the sign that it has at a coordinate: that of the start, changed by every
    /// passage in between.
    pub(super) fn choose(&self, engine: &Engine, at: f64, signs: &mut [f64]) {
        let here = reduced(at, self.period);
        signs.copy_from_slice(&engine.signs);
        for passage in &self.list {
            if (passage.at < here) != (passage.at < self.start) {
                signs[passage.group] = -signs[passage.group];
            }
        }
    }

    /// The passage of a dyad that a coordinate lies close to, and how far from it.
    pub(super) fn near(&self, engine: &Engine, at: f64, group: usize) -> Option<(&Passage, f64)> {
        let here = reduced(at, self.period);
        let ours = self.list.iter().filter(|p| p.group == group);
        ours.map(|p| (p, self.away(engine, p, here)))
            .find(|(_, dq)| dq.abs() < ZONE)
    }

    /// Whether the series stands in for any dyad at a coordinate.
    pub(super) fn is_near(&self, engine: &Engine, at: f64) -> bool {
        let here = reduced(at, self.period);
        self.list
            .iter()
            .any(|p| self.away(engine, p, here).abs() < ZONE)
    }

    /// From a passage to a coordinate, across the end of the period where that is shorter.
    fn away(&self, engine: &Engine, passage: &Passage, here: f64) -> f64 {
        let straight = here - passage.at;
        let around = straight - self.period * straight.signum();
        let shorter = if around.abs() < straight.abs() {
            around
        } else {
            straight
        };
        if shorter.abs() <= SAME * passage.at.abs() {
            return 0.0;
        }
        engine.difference(0.0, shorter)
    }
}

fn reduced(at: f64, period: f64) -> f64 {
    if period > 0.0 {
        positive_remainder(at, period)
    } else {
        at
    }
}

/// The motion of what a dyad places, in one state.
#[derive(Clone, Copy, Default)]
struct Sample {
    point: PointState,
    links: [LinkState; 2],
}

impl Passage {
    /// Reads a dyad's series off the motion around: `solved` gives the state at a distance from the
    /// change point, in radians or scaled lengths, if there is one. Where the motion does not reach as
    /// far, or passes another change point on the way, it is looked at closer by; the series must
    /// foretell the motion on both sides.
    pub(super) fn through(
        at: f64,
        step: &Step,
        group: usize,
        mut solved: impl FnMut(f64) -> Option<State>,
    ) -> Option<Passage> {
        let reaches = (0..REACHES).map(|k| REACH * 0.5_f64.powi(k));
        let mut series = reaches.filter_map(|reach| {
            let passage = Passage::seen_from(reach, at, step, group, &mut solved)?;
            let foretells = |dq: f64, state: State| passage.foretells(dq, &state);
            let holds = foretells(-PROOF, solved(-PROOF)?) && foretells(PROOF, solved(PROOF)?);
            holds.then_some(passage)
        });
        series.next()
    }

    fn seen_from(
        reach: f64,
        at: f64,
        step: &Step,
        group: usize,
        solved: &mut impl FnMut(f64) -> Option<State>,
    ) -> Option<Passage> {
        let (point, links) = step.outputs();
        let read = |state: &State| Sample {
            point: point.map_or(PointState::default(), |p| state.points[p.index()]),
            links: links.map(|l| l.map_or(LinkState::default(), |l| state.links[l.index()])),
        };
        let (mut sum, mut weights) = (Sample::default(), 0.0);
        for k in 0..PLACES {
            // Half angles of Chebyshev's places in degrees, exact.
            let node = crate::angle::unit(180.0 * (k as f64 + 0.5) / PLACES as f64);
            let sample = read(&solved(reach * node.x)?);
            let alternating = if k % 2 == 0 { 1.0 } else { -1.0 };
            let weight = alternating * node.y / node.x;
            sum = sum.plus(&sample, weight);
            weights += weight;
        }
        let limit = Sample::default().plus(&sum, 1.0 / weights);
        let unit = |link: LinkState| LinkState {
            d: link.d / link.d.norm(),
            ..link
        };
        Some(Passage {
            at,
            group,
            point: point.map(|p| (p, limit.point)),
            links: [0, 1].map(|i| links[i].map(|l| (l, unit(limit.links[i])))),
        })
    }

    /// Whether the series places the dyad where it is in a state at a distance.
    fn foretells(&self, dq: f64, state: &State) -> bool {
        let mut told = state.clone();
        self.write(dq, &mut told);
        let near = |a: Vec2, b: Vec2| (a - b).norm() <= PROVEN;
        let point = self
            .point
            .is_none_or(|(p, _)| near(told.points[p.index()].p, state.points[p.index()].p));
        let mut links = self.links.iter().flatten();
        point && links.all(|(l, _)| near(told.links[l.index()].d, state.links[l.index()].d))
    }

    /// Takes positions from a state at the change point itself, where it has any.
    pub(super) fn take_positions(&mut self, state: &State) {
        if let Some((point, limit)) = &mut self.point {
            limit.p = state.points[point.index()].p;
        }
        for (link, limit) in self.links.iter_mut().flatten() {
            limit.d = state.links[link.index()].d;
        }
    }

    /// Places what the dyad places, at a distance from the change point.
    pub(super) fn write(&self, dq: f64, state: &mut State) {
        if let Some((point, PointState { p, v, a })) = self.point {
            state.points[point.index()] = PointState {
                p: p + v * dq + a * (0.5 * dq * dq),
                v: v + a * dq,
                a,
            };
        }
        for (link, LinkState { d, w, a }) in self.links.into_iter().flatten() {
            let turned = dq * (w + 0.5 * a * dq);
            let turn = Vec2::new(1.0 - 0.5 * turned * turned, turned);
            state.links[link.index()] = LinkState {
                d: d.turned(turn),
                w: w + a * dq,
                a,
            };
        }
    }
}

impl Sample {
    fn plus(&self, other: &Sample, weight: f64) -> Sample {
        let link = |i: usize| {
            let (a, b) = (self.links[i], other.links[i]);
            LinkState {
                d: a.d + b.d * weight,
                w: a.w + b.w * weight,
                a: a.a + b.a * weight,
            }
        };
        let (a, b) = (self.point, other.point);
        Sample {
            point: PointState {
                p: a.p + b.p * weight,
                v: a.v + b.v * weight,
                a: a.a + b.a * weight,
            },
            links: [link(0), link(1)],
        }
    }
}
