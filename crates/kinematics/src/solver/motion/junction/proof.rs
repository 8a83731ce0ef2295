//! The proof of what series tell: the mechanism solved on both sides of the place, in the same numbers.

use super::Junction;
use crate::arithmetic::Series;
use crate::solver::change_point::Passage;
use crate::solver::elements::{Snap, root};
use crate::solver::exact::Exact;
use crate::solver::motion::walk::Walker;
use crate::{Double, Number, Vec2};

/// At a distance from the place series and motion may differ by this much in places and directions,
const PROVEN: f64 = 1e-9;
/// and by this part of how far the other assembly is.
const OTHER: f64 = 0.1;
/// A zone in which the series cannot be proved is narrowed down to this part, so often.
const ZONE: f64 = 0.1;
const ZONES: i32 = 8;

impl Walker<'_> {
    /// The passages of the groups that are singular at a place: each series tells where its group is on
    /// both sides, as far as it is used.
    pub(in crate::solver::motion) fn passages(
        &mut self,
        junction: &Junction,
    ) -> Option<Vec<Passage>> {
        let engine = self.engine;
        let passages = junction.folds.iter().map(|fold| {
            let of = (fold.group, fold.turns());
            let mut passage =
                Passage::new(junction.at, of, engine.outputs(fold.step), &junction.series)?;
            // A series tells nothing of what lies behind a knot.
            passage.zone = passage.zone.min(engine.smooth(passage.at));
            let other = self.passages.distance(engine, fold.group, passage.at);
            passage.zone = other.map_or(passage.zone, |other| passage.zone.min(0.5 * other));
            (passage.zone > 0.0).then_some(passage)
        });
        let mut passages = passages.collect::<Option<Vec<Passage>>>()?;
        // What is proved at a distance is proved of all groups before: once for all of one zone.
        let mut zones: Vec<(f64, usize)> = Vec::new();
        for (passage, fold) in passages.iter().zip(&junction.folds) {
            let steps = fold.step + 1;
            match zones.iter_mut().find(|(zone, _)| *zone == passage.zone) {
                Some((_, most)) => *most = steps,
                None => zones.push((passage.zone, steps)),
            }
        }
        for (zone, steps) in zones {
            // Another change point may be closer by.
            let mut narrower = (0..ZONES).map(|k| zone * ZONE.powi(k));
            let proved = narrower.find(|&zone| self.proves(junction, zone, steps))?;
            let alike = passages.iter_mut().filter(|passage| passage.zone == zone);
            alike.for_each(|passage| passage.zone = proved);
        }
        Some(passages)
    }

    /// Whether the series tells where the first steps are at a distance on both sides, and no other
    /// assembly is as near.
    pub(in crate::solver::motion) fn proves(
        &mut self,
        junction: &Junction,
        distance: f64,
        steps: usize,
    ) -> bool {
        let signs = self.state.signs.clone();
        let proved = [-distance, distance]
            .into_iter()
            .all(|dq| self.tells(junction, dq, steps));
        self.state.state.signs = signs;
        proved
    }

    fn tells(&mut self, junction: &Junction, dq: f64, steps: usize) -> bool {
        let Some(Exact { engine, .. }) = self.exact else {
            return false;
        };
        let signs = &junction.sides[usize::from(dq > 0.0)];
        self.state.state.signs.copy_from_slice(signs);
        let at = self.moved_exactly(junction.at, Double::exactly(dq));
        let (q, direction) = self.coordinate_of(at, 1);
        let mut here = engine.state::<Series>(self.state.travels.len());
        for i in 0..steps {
            let fold = junction.folds.binary_search_by_key(&i, |fold| fold.step);
            let Some(dyad) = engine.program.steps[i].dyad() else {
                if self.lay(i..i + 1, at.hi, q, direction, &mut here).is_none() {
                    return false;
                }
                continue;
            };
            let snap = fold.map_or_else(|_| Snap::default(), |k| junction.folds[k].snap);
            let square = dyad.square(q, snap, &here);
            if !(square.nearest() > 0.0) {
                return false;
            }
            let mut misses = [-1.0, 1.0]
                .map(|side| {
                    let height = root(square, 0, side * signs[dyad.group()]);
                    dyad.run_through(q, snap, height, &mut here.state);
                    let told = dyad.placed(&junction.series);
                    told.zip(dyad.placed(&here))
                        .map(|(told, here)| miss(told, here, dq))
                        .fold(0.0, f64::max)
                })
                .into_iter();
            let (other, this) = (misses.next(), misses.next());
            if !(this <= other.map(|other| OTHER * other)) {
                return false;
            }
        }
        let outputs = (0..steps).map(|i| engine.outputs(i));
        let (mut points, mut links) = (Vec::new(), Vec::new());
        outputs.for_each(|(p, l)| {
            points.extend(p);
            links.extend(l);
        });
        let told = &junction.series;
        let is_near = |told: Vec2<Series>, here: Vec2<Series>| miss(told, here, dq) <= PROVEN;
        points
            .iter()
            .map(|p| p.index())
            .all(|p| is_near(told.points[p].p, here.points[p].p))
            && links
                .iter()
                .map(|l| l.index())
                .all(|l| is_near(told.links[l].d, here.links[l].d))
    }
}

/// How far a place is from where a series tells it to be, at a distance.
fn miss(told: Vec2<Series>, here: Vec2<Series>, dq: f64) -> f64 {
    let dq = Double::exactly(dq);
    let sum = |s: Series| {
        let known = s.c[..s.known].iter().rev();
        known.fold(Double::ZERO, |sum, &c| sum * dq + c)
    };
    let off = Vec2::new(sum(told.x) - here.x.c[0], sum(told.y) - here.y.c[0]);
    off.norm().hi
}
