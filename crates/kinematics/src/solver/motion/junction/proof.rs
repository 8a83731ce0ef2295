//! Proves series about a junction by solving the mechanism on both sides of it, in the same
//! arithmetic.

use super::Junction;
use crate::arithmetic::Series;
use crate::solver::change_point::ChangePointCrossing;
use crate::solver::elements::{SingularShift, root};
use crate::solver::exact::Exact;
use crate::solver::motion::tracking::Walker;
use crate::{Double, Number, Vec2};

/// Maximum difference between series and motion in positions and directions, at a distance from the
/// junction.
pub(super) const PROOF_TOLERANCE: f64 = 1e-9;
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
    ) -> Option<Vec<ChangePointCrossing>> {
        let engine = self.engine;
        let minimum = WIDER * junction.spread();
        let crossings = junction.folds.iter().map(|fold| {
            let of = (fold.group, fold.turns.len() == 1);
            let mut crossing = ChangePointCrossing::new(
                (junction.at, fold.spread),
                of,
                engine.outputs(fold.step),
                &junction.series,
            )?;
            // A series does not hold beyond a knot of an input table.
            crossing.zone = crossing.zone.min(engine.smooth(crossing.at));
            let other = self.crossings.distance(engine, fold.group, crossing.at);
            crossing.zone = other.map_or(crossing.zone, |other| crossing.zone.min(0.5 * other));
            let within = junction.pair.as_ref().map(|pair| pair.within);
            crossing.zone = within.map_or(crossing.zone, |within| crossing.zone.min(within));
            crossing.side = junction.side;
            crossing.is_led_through = fold.is_missed;
            (crossing.zone > minimum).then_some(crossing)
        });
        let mut crossings = crossings.collect::<Option<Vec<ChangePointCrossing>>>()?;
        // A proof at a distance covers all groups before it: one per zone is enough.
        let mut zones: Vec<(f64, usize)> = Vec::new();
        for (crossing, fold) in crossings.iter().zip(&junction.folds) {
            let steps = fold.step + 1;
            match zones.iter_mut().find(|(zone, _)| *zone == crossing.zone) {
                Some((_, maximum)) => *maximum = steps,
                None => zones.push((crossing.zone, steps)),
            }
        }
        for (zone, steps) in zones {
            // Another change point may be closer.
            let narrower = (0..ZONES).map(|k| zone * ZONE.powi(k));
            let mut narrower = narrower.filter(|&zone| zone > minimum);
            let proved = narrower.find(|&zone| self.proves(junction, zone, steps))?;
            let alike = crossings
                .iter_mut()
                .filter(|crossing| crossing.zone == zone);
            alike.for_each(|crossing| crossing.zone = proved);
        }
        let mut places = Vec::new();
        for (crossing, fold) in crossings.into_iter().zip(&junction.folds) {
            if fold.turns.is_empty() {
                places.push(crossing);
                continue;
            }
            let turns = fold.turns.iter();
            places.extend(turns.map(|&by| {
                let at = self.moved_exactly(junction.at, by);
                crossing.turning_at(at, by.hi)
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
            .all(|dq| self.agrees_on_side(junction, dq, steps));
        self.state.state.signs = signs;
        proved
    }

    /// Checks the series as [`Walker::proves`] does, at a signed distance on one side.
    fn agrees_on_side(&mut self, junction: &Junction, dq: f64, steps: usize) -> bool {
        let Some(Exact { engine, .. }) = self.exact else {
            return false;
        };
        let signs = &junction.sides[usize::from(dq > 0.0)];
        self.state.state.signs.copy_from_slice(signs);
        let by = match &junction.curve {
            None => Double::exactly(dq),
            Some(curve) => curve.offset_at(dq),
        };
        let at = self.moved_exactly(junction.at, by);
        let (q, direction) = self.coordinate_of(at, 1);
        let mut here = engine.state::<Series>(self.state.travels.len());
        for i in 0..steps {
            if let Some(curve) = junction.curve.as_ref().filter(|curve| curve.step == i) {
                if !self.stays_on_curve(curve, (at, q), (junction, dq), &mut here) {
                    return false;
                }
                continue;
            }
            if let Some(pair) = junction.pair.as_ref().filter(|pair| pair.step == i) {
                if !self.stays_on_branch((junction, dq), pair, q, &mut here) {
                    return false;
                }
                continue;
            }
            let fold = junction.folds.binary_search_by_key(&i, |fold| fold.step);
            let Some(dyad) = engine.program.steps[i].dyad() else {
                if self
                    .place_in_series(i..i + 1, at.hi, q, direction, &mut here)
                    .is_none()
                {
                    return false;
                }
                continue;
            };
            let snap = fold.map_or_else(|_| SingularShift::default(), |k| junction.folds[k].snap);
            // At a distance, the pivots do not coincide.
            let snap = SingularShift { pair: None, ..snap };
            let square = dyad.square(q, snap, &here);
            if !(square.nearest() > 0.0) {
                return false;
            }
            let mut misses = [-1.0, 1.0]
                .map(|side| {
                    let height = root(square, 0, side * signs[dyad.group()]);
                    dyad.run_through(q, snap, height, &mut here.state);
                    let text = dyad.placed(&junction.series);
                    text.zip(dyad.placed(&here))
                        .map(|(text, here)| miss(text, here, dq))
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
        let text = &junction.series;
        let is_near =
            |text: Vec2<Series>, here: Vec2<Series>| miss(text, here, dq) <= PROOF_TOLERANCE;
        points
            .iter()
            .map(|p| p.index())
            .all(|p| is_near(text.points[p].p, here.points[p].p))
            && links
                .iter()
                .map(|l| l.index())
                .all(|l| is_near(text.links[l].d, here.links[l].d))
    }
}

/// Returns the distance of a position from that of a series, evaluated at a distance `dq`.
fn miss(text: Vec2<Series>, here: Vec2<Series>, dq: f64) -> f64 {
    let dq = Double::exactly(dq);
    let off = text.map(|s| s.value(dq)) - here.map(|s| s.c[0]);
    off.norm().hi
}
