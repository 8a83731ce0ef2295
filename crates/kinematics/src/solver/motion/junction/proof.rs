//! Proves series about a junction by solving the mechanism on both sides of it, in the same
//! arithmetic.

use super::Junction;
use crate::arithmetic::Series;
use crate::solver::change_point::Passage;
use crate::solver::elements::{Snap, root};
use crate::solver::exact::Exact;
use crate::solver::motion::walk::Walker;
use crate::{Double, Number, Vec2};

/// Maximum difference between series and motion in positions and directions, at a distance from the
/// junction.
const PROVEN: f64 = 1e-9;
/// Maximum difference between series and motion, relative to the distance of the other assembly.
const OTHER: f64 = 0.1;
/// Factor by which a zone shrinks if the series cannot be proved in it.
const ZONE: f64 = 0.1;
/// Minimum zone of a series about two change points, in units of their distance from its centre.
const WIDER: f64 = 2.5;
/// Maximum number of zones tried.
const ZONES: i32 = 8;

impl Walker<'_> {
    /// Returns the change point crossings of the singular groups, each with the zone in which its
    /// series is proved on both sides. Returns `None` if one cannot be proved.
    pub(in crate::solver::motion) fn passages(
        &mut self,
        junction: &Junction,
    ) -> Option<Vec<Passage>> {
        let engine = self.engine;
        let least = WIDER * junction.spread();
        let passages = junction.folds.iter().map(|fold| {
            let of = (fold.group, fold.turns.len() == 1);
            let mut passage =
                Passage::new(junction.at, of, engine.outputs(fold.step), &junction.series)?;
            // A series does not hold beyond a knot of an input table.
            passage.zone = passage.zone.min(engine.smooth(passage.at));
            let other = self.passages.distance(engine, fold.group, passage.at);
            passage.zone = other.map_or(passage.zone, |other| passage.zone.min(0.5 * other));
            passage.side = junction.side;
            passage.is_led = fold.is_missed;
            (passage.zone > least).then_some(passage)
        });
        let mut passages = passages.collect::<Option<Vec<Passage>>>()?;
        // A proof at a distance covers all groups before it: one per zone is enough.
        let mut zones: Vec<(f64, usize)> = Vec::new();
        for (passage, fold) in passages.iter().zip(&junction.folds) {
            let steps = fold.step + 1;
            match zones.iter_mut().find(|(zone, _)| *zone == passage.zone) {
                Some((_, most)) => *most = steps,
                None => zones.push((passage.zone, steps)),
            }
        }
        for (zone, steps) in zones {
            // Another change point may be closer.
            let narrower = (0..ZONES).map(|k| zone * ZONE.powi(k));
            let mut narrower = narrower.filter(|&zone| zone > least);
            let proved = narrower.find(|&zone| self.proves(junction, zone, steps))?;
            let alike = passages.iter_mut().filter(|passage| passage.zone == zone);
            alike.for_each(|passage| passage.zone = proved);
        }
        let mut places = Vec::new();
        for (passage, fold) in passages.into_iter().zip(&junction.folds) {
            if fold.turns.is_empty() {
                places.push(passage);
                continue;
            }
            let turns = fold.turns.iter();
            places.extend(turns.map(|&by| {
                let at = self.moved_exactly(junction.at, by);
                passage.turning_at(at, by.hi)
            }));
        }
        Some(places)
    }

    /// Returns `true` if the series agree with the first `steps` steps at a distance on both sides,
    /// and no other assembly is as close.
    pub(in crate::solver::motion) fn proves(
        &mut self,
        junction: &Junction,
        distance: f64,
        steps: usize,
    ) -> bool {
        let signs = self.state.signs.clone();
        let sides = [-distance, distance].into_iter();
        let proved = sides
            .filter(|dq| dq * junction.side >= 0.0)
            .all(|dq| self.tells(junction, dq, steps));
        self.state.state.signs = signs;
        proved
    }

    /// Checks the series as [`Walker::proves`] does, at a signed distance on one side.
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
            // At a distance, the pivots do not coincide.
            let snap = Snap { pair: None, ..snap };
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

/// Returns the distance of a position from that of a series, evaluated at a distance `dq`.
fn miss(told: Vec2<Series>, here: Vec2<Series>, dq: f64) -> f64 {
    let dq = Double::exactly(dq);
    let sum = |s: Series| {
        let known = s.c[..s.known].iter().rev();
        known.fold(Double::ZERO, |sum, &c| sum * dq + c)
    };
    let off = Vec2::new(sum(told.x) - here.x.c[0], sum(told.y) - here.y.c[0]);
    off.norm().hi
}
