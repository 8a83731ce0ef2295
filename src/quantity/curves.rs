//! Quantities over the motion: samples to draw, the gaps between them, and where they turn.

use super::clock::{Clock, Pace, paced};
use super::extrema::{Extremum, lowest, turns};
use super::{Aspect, Catalogue, Quantity, Subject, demand};
use crate::angle::TURN;
use crate::scene::Scene;
use crate::solver::{Condition, Order, Range, Solver, State};
use crate::{LANES, Lanes};
use thiserror::Error;

/// What stands along x.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Abscissa {
    /// The driver's coordinate.
    #[default]
    Driver,
    /// Time in seconds, 0 where the scene opens: see [`Clock`].
    Time,
    /// Another quantity.
    Figure(Quantity),
}

/// Why nothing can be drawn over time.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum NoTime {
    /// The driver stands still.
    #[error("the scene gives its driver no speed, so no time passes: give the driver a speed")]
    StandsStill,
    /// The driver turns back before it comes to a coordinate that was asked for.
    #[error("the driver turns back before it comes to {0}")]
    TurnsBack(f64),
}

/// Samples of some quantities over the motion, or over a part of it.
#[derive(Clone, Debug)]
pub struct Curves {
    /// What stands along x.
    pub abscissa: Abscissa,
    /// Its name and unit: `driver.angle`, `deg`; `time`, `s`.
    pub title: [String; 2],
    /// The quantity that is the driver's coordinate.
    pub driver: Quantity,
    /// The driver's coordinate of each sample, in degrees or in the scene's length unit.
    pub at: Vec<f64>,
    /// What stands along x at each sample.
    pub along: Vec<Option<f64>>,
    /// What each state is.
    pub conditions: Vec<Condition>,
    /// The quantities, in the order in which they were asked for.
    pub curves: Vec<Curve>,
    /// Between which samples what stands along x jumps.
    breaks: Vec<bool>,
    clock: Option<Clock>,
    /// The period after which the samples repeat.
    period: Option<f64>,
}

/// The samples of a quantity.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What was sampled.
    pub quantity: Quantity,
    /// Its value at each sample; `None` where none exists.
    pub values: Vec<Option<f64>>,
    /// Where it turns.
    pub extrema: Vec<Extremum>,
    /// Between which samples it jumps, as a direction does from 360 to 0 deg: behind the first of the
    /// two.
    breaks: Vec<bool>,
    /// It does not change by more than what its own error may be.
    is_level: bool,
}

/// The quantities in one state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Here {
    /// What stands along x; `None` outside of what was sampled.
    pub along: Option<f64>,
    /// The value of each curve.
    pub values: Vec<Option<f64>>,
}

/// Samples of the usual scene over its motion, and of one with so many points and links that this
/// would be seen as a delay.
const SAMPLES: usize = 720;
const FEWEST_SAMPLES: usize = 180;
/// Points and links of all samples together.
const MOST_ROWS: usize = 400_000;

/// Of its range, a curve that goes through more than this from one sample to the next is looked at
/// more closely: it may jump.
const STEEP: f64 = 0.2;
/// Halvings by which a jump is told from a steep slope: a millionth of the way between two samples.
const HALVINGS: u32 = 20;
/// A turn counts where the curve goes away from it by this part of its range.
const LEAST_TURN: f64 = 2e-3;
/// A change that is less than this part of the values is the rounding of what they come from.
const ROUNDING: f64 = 1e-11;
/// A change is one where it is more than so many times what an error may be.
const DOUBT: f64 = 4.0;

impl Curves {
    /// Solves for the quantities over the whole motion, or over a window of the driver's coordinate.
    ///
    /// # Errors
    /// Over time, where there is none.
    pub fn new(
        scene: &Scene,
        solver: &Solver,
        quantities: &[Quantity],
        abscissa: Abscissa,
        window: Option<(f64, f64)>,
    ) -> Result<Curves, NoTime> {
        let clock = match abscissa {
            Abscissa::Time => {
                Some(Clock::new(scene.mechanism.driver()).ok_or(NoTime::StandsStill)?)
            }
            Abscissa::Driver | Abscissa::Figure(_) => None,
        };
        let range = solver.motion().range;
        let (from, to) = stretch(range, clock.as_ref(), window)?;
        let driver = Catalogue::new(scene).driver().clone();
        let mut columns = quantities.to_vec();
        let title = match &abscissa {
            Abscissa::Driver => [driver.name.clone(), driver.unit.clone()],
            Abscissa::Time => ["time".into(), "s".into()],
            Abscissa::Figure(figure) => {
                columns.push(figure.clone());
                [figure.name.clone(), figure.unit.clone()]
            }
        };
        let mut probe = Probe::new(solver, &columns, range, clock);
        let mechanism = &scene.mechanism;
        let rows = mechanism.points().len() + mechanism.links().len();
        let count = (MOST_ROWS / rows.max(1)).clamp(FEWEST_SAMPLES, SAMPLES);
        let share = |k: usize| k as f64 / count as f64;
        let places: Vec<f64> = (0..=count)
            .map(|k| {
                if k == count {
                    to
                } else {
                    from + (to - from) * share(k)
                }
            })
            .collect();
        let (mut values, conditions) = probe.sample(&places);
        let at: Vec<f64> = places.iter().map(|&p| probe.coordinate(p)).collect();
        let mut along_breaks = vec![false; count];
        let along = match &abscissa {
            Abscissa::Driver => at.iter().copied().map(Some).collect(),
            Abscissa::Time => places.iter().copied().map(Some).collect(),
            Abscissa::Figure(_) => {
                let along = values.pop().unwrap_or_default();
                along_breaks = probe.breaks(quantities.len(), &places, &along);
                along
            }
        };
        let period = period(range, clock.as_ref(), window);
        let ends = match range {
            Range::Limited { .. } => window.is_none(),
            Range::Full { .. } => false,
        };
        let mut curves = Vec::with_capacity(quantities.len());
        for (i, (quantity, values)) in quantities.iter().zip(values).enumerate() {
            let breaks = probe.breaks(i, &places, &values);
            let is_level = probe.is_level(i, &places, &values);
            let mut curve = Curve {
                quantity: quantity.clone(),
                values,
                breaks,
                extrema: Vec::new(),
                is_level,
            };
            let goes_round = period.is_some();
            curve.extrema = probe.extrema(i, &curve, &places, goes_round, ends);
            curves.push(curve);
        }
        let mut all = Curves {
            abscissa,
            title,
            driver,
            at,
            along,
            conditions,
            curves,
            breaks: along_breaks,
            clock,
            period,
        };
        all.place_extrema(&mut probe);
        Ok(all)
    }

    /// Finds what stands along x at each extremum; one that lies beyond an end is one period before.
    fn place_extrema(&mut self, probe: &mut Probe) {
        let (first, last) = (self.places(0), self.places(usize::MAX));
        let figure = self.curves.len();
        for curve in &mut self.curves {
            for extremum in &mut curve.extrema {
                // Until here, the place is that of the probe.
                let mut place = extremum.at;
                if let Some(period) = self.period {
                    if place < first {
                        place += period;
                    } else if place > last {
                        place -= period;
                    }
                }
                extremum.at = probe.coordinate(place);
                extremum.along = match self.abscissa {
                    Abscissa::Driver => extremum.at,
                    Abscissa::Time => place,
                    Abscissa::Figure(_) => probe.value(figure, place).unwrap_or(f64::NAN),
                };
            }
            curve.extrema.retain(|e| e.along.is_finite());
        }
    }

    /// The coordinate or the time of a sample; of the last one for any number beyond.
    fn places(&self, sample: usize) -> f64 {
        let sample = sample.min(self.at.len().saturating_sub(1));
        let place = match self.abscissa {
            Abscissa::Time => self.along.get(sample).copied().flatten(),
            Abscissa::Driver | Abscissa::Figure(_) => self.at.get(sample).copied(),
        };
        place.unwrap_or(0.0)
    }

    /// The parts of a curve that hang together: places of what stands along x and the value. Parts of
    /// one sample are possible, parts of none are not.
    #[must_use]
    pub fn pieces(&self, curve: usize) -> Vec<Vec<[f64; 2]>> {
        let Some(curve) = self.curves.get(curve) else {
            return Vec::new();
        };
        let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
        let mut hangs_on = false;
        for (i, (x, y)) in self.along.iter().zip(&curve.values).enumerate() {
            let (Some(x), Some(y)) = (*x, *y) else {
                hangs_on = false;
                continue;
            };
            match pieces.last_mut() {
                Some(piece) if hangs_on => piece.push([x, y]),
                _ => pieces.push(vec![[x, y]]),
            }
            let breaks = [&self.breaks, &curve.breaks];
            hangs_on = !breaks.iter().any(|b| b.get(i).copied().unwrap_or(false));
        }
        pieces
    }

    /// From where to where x goes; of nothing at all, nothing.
    #[must_use]
    pub fn span(&self) -> Option<(f64, f64)> {
        shown(&self.along, &self.breaks)
    }

    /// What stands along x, and every curve, in a state of the whole solver.
    #[must_use]
    pub fn here(&self, state: &State) -> Here {
        let place = self.place_of(state.at());
        let pace = place.and_then(|time| self.clock.as_ref()?.pace(time));
        let along = match &self.abscissa {
            Abscissa::Driver | Abscissa::Time => place,
            Abscissa::Figure(figure) => place.and_then(|_| figure.value(state)),
        };
        let value = |curve: &Curve| paced(&curve.quantity, state, pace);
        Here {
            along,
            values: self.curves.iter().map(value).collect(),
        }
    }

    /// Where among the samples the driver's coordinate lies, as a coordinate or a time.
    fn place_of(&self, at: f64) -> Option<f64> {
        let (first, last) = (self.places(0), self.places(usize::MAX));
        let (low, high) = (first.min(last), first.max(last));
        let place = match &self.clock {
            None => at,
            Some(clock) => clock.time(at)?,
        };
        let place = match self.period {
            Some(_) if (low..=high).contains(&place) => place,
            Some(period) => low + (place - low).rem_euclid(period),
            None => place,
        };
        (low..=high).contains(&place).then_some(place)
    }
}

impl Curve {
    /// The range of values that is worth showing: all of them, but next to a gap, where a figure may
    /// grow beyond all bounds, not much more than where most of them are. `None` where there is none.
    #[must_use]
    pub fn range(&self) -> Option<(f64, f64)> {
        let (low, high) = shown(&self.values, &self.breaks)?;
        // A curve turns between samples, and a little farther out.
        let near = NEAR * (high - low);
        let turns = self.extrema.iter().map(|e| e.value);
        let turns = turns.filter(|&v| low - near <= v && v <= high + near);
        Some(turns.fold((low, high), |(low, high), v| (low.min(v), high.max(v))))
    }

    /// Whether it does not change by more than its own error may be.
    #[must_use]
    pub fn is_level(&self) -> bool {
        self.is_level
    }
}

/// From where to where, as coordinates or times.
fn stretch(
    range: Range,
    clock: Option<&Clock>,
    window: Option<(f64, f64)>,
) -> Result<(f64, f64), NoTime> {
    match (clock, window) {
        (None, Some((from, to))) => Ok((from.min(to), from.max(to))),
        (None, None) => Ok(match range {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        }),
        (Some(clock), None) => Ok(clock.span(range)),
        (Some(clock), Some((from, to))) => {
            let time = |at| clock.time(at).ok_or(NoTime::TurnsBack(at));
            let (from, to) = (time(from)?, time(to)?);
            Ok((from.min(to), from.max(to)))
        }
    }
}

/// After what the samples repeat, where they cover just that: in degrees or seconds.
fn period(range: Range, clock: Option<&Clock>, window: Option<(f64, f64)>) -> Option<f64> {
    let Range::Full { period } = range else {
        return None;
    };
    let covers = window.is_none_or(|(from, to)| (to - from).abs() == period);
    match clock {
        _ if !covers => None,
        None => Some(period),
        Some(clock) => clock.is_even().then(|| (period / clock.speed()).abs()),
    }
}

/// Parts of the samples between which most of them are.
const USUAL: (f64, f64) = (0.02, 0.98);
/// A range that is so many times that of most samples is not shown whole next to a gap, but this much
/// beyond them.
const UNUSUAL: f64 = 3.0;
const BEYOND: f64 = 0.5;
/// So much farther out than the samples a curve may turn between them, as a part of the range.
const NEAR: f64 = 0.05;

fn shown(values: &[Option<f64>], breaks: &[bool]) -> Option<(f64, f64)> {
    let (low, high) = ends(values)?;
    let is_whole = values.iter().all(Option::is_some) && !breaks.contains(&true);
    let (usual_low, usual_high) = usual(values)?;
    let size = usual_high - usual_low;
    if is_whole || size <= 0.0 || high - low <= UNUSUAL * size {
        return Some((low, high));
    }
    let beyond = BEYOND * size;
    Some((low.max(usual_low - beyond), high.min(usual_high + beyond)))
}

fn ends(values: &[Option<f64>]) -> Option<(f64, f64)> {
    let mut values = values.iter().copied().flatten();
    let first = values.next()?;
    Some(values.fold((first, first), |(low, high), v| (low.min(v), high.max(v))))
}

/// Between which values most samples are.
fn usual(values: &[Option<f64>]) -> Option<(f64, f64)> {
    let mut sorted: Vec<f64> = values.iter().copied().flatten().collect();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a part of an index"
    )]
    let at = |part: f64| sorted[((last as f64 * part).round() as usize).min(last)];
    Some((at(USUAL.0), at(USUAL.1)))
}

/// Reads the quantities anywhere on the way, by coordinate or by time.
struct Probe {
    solver: Solver,
    order: Order,
    columns: Vec<Quantity>,
    range: Range,
    clock: Option<Clock>,
    state: State,
    lanes: State<Lanes>,
}

impl Probe {
    fn new(solver: &Solver, columns: &[Quantity], range: Range, clock: Option<Clock>) -> Self {
        let (wanted, order) = demand(columns);
        let solver = solver.only(&wanted);
        Probe {
            order,
            columns: columns.to_vec(),
            range,
            clock,
            state: solver.state(),
            lanes: solver.lanes(),
            solver,
        }
    }

    /// The driver's coordinate at a place; rounding leads out of no limit.
    fn coordinate(&self, place: f64) -> f64 {
        let Some(clock) = &self.clock else {
            return place;
        };
        let at = clock.coordinate(place);
        match self.range {
            Range::Limited { low, high } => at.max(low).min(high),
            Range::Full { .. } => at,
        }
    }

    fn pace(&self, place: f64) -> Option<Pace> {
        self.clock.as_ref()?.pace(place)
    }

    fn solve(&mut self, place: f64) -> Condition {
        let at = self.coordinate(place);
        self.solver.solve(at, self.order, &mut self.state)
    }

    fn value(&mut self, column: usize, place: f64) -> Option<f64> {
        self.solve(place);
        paced(&self.columns[column], &self.state, self.pace(place))
    }

    /// Every column at these places, and what the states are.
    fn sample(&mut self, places: &[f64]) -> (Vec<Vec<Option<f64>>>, Vec<Condition>) {
        let mut columns = vec![Vec::with_capacity(places.len()); self.columns.len()];
        let mut conditions = Vec::with_capacity(places.len());
        for block in places.chunks(LANES) {
            if self.sample_at_once(block, &mut columns) {
                conditions.extend(block.iter().map(|_| Condition::Ok));
                continue;
            }
            for &place in block {
                conditions.push(self.solve(place));
                let pace = self.pace(place);
                for (quantity, values) in self.columns.iter().zip(&mut columns) {
                    values.push(paced(quantity, &self.state, pace));
                }
            }
        }
        (columns, conditions)
    }

    /// Whether all places could be solved at once; then they are in the columns.
    fn sample_at_once(&mut self, block: &[f64], columns: &mut [Vec<Option<f64>>]) -> bool {
        let Some(&last) = block.last().filter(|&&p| self.pace(p).is_none()) else {
            return false;
        };
        let mut at = [self.coordinate(last); LANES];
        for (at, &place) in at.iter_mut().zip(block) {
            *at = self.coordinate(place);
        }
        if !self.solver.solve_lanes(at, self.order, &mut self.lanes) {
            return false;
        }
        for (quantity, values) in self.columns.iter().zip(columns) {
            let lanes = quantity.value(&self.lanes);
            let lane = |i: usize| lanes.map(|lanes| lanes.0[i]).filter(|v| v.is_finite());
            values.extend((0..block.len()).map(lane));
        }
        true
    }

    /// Between which samples a column jumps.
    fn breaks(&mut self, column: usize, places: &[f64], values: &[Option<f64>]) -> Vec<bool> {
        let wraps = self.columns[column].aspect == Aspect::Angle
            && self.columns[column].subject != Subject::Driver;
        let size = usual(values).map_or(0.0, |(low, high)| high - low);
        let pairs = values.windows(2).zip(places.windows(2));
        pairs
            .map(|(pair, ends)| {
                let [Some(a), Some(b)] = [pair[0], pair[1]] else {
                    return false;
                };
                let change = (b - a).abs();
                (wraps && change > TURN / 2.0)
                    || (change > STEEP * size && self.jumps(column, [ends[0], ends[1]], [a, b]))
            })
            .collect()
    }

    /// Whether the change between two places does not become less however close they are.
    fn jumps(&mut self, column: usize, mut places: [f64; 2], mut values: [f64; 2]) -> bool {
        let whole = (values[1] - values[0]).abs();
        for _ in 0..HALVINGS {
            let middle = 0.5 * (places[0] + places[1]);
            let Some(value) = self.value(column, middle) else {
                return true;
            };
            let end = usize::from((value - values[0]).abs() > (values[1] - value).abs());
            (places[end], values[end]) = (middle, value);
            if (values[1] - values[0]).abs() < 0.5 * whole {
                return false;
            }
        }
        // What is left changes nothing between two doubles that a steep slope could tell from a jump.
        whole > ROUNDING * values[0].abs().max(values[1].abs())
    }

    /// Whether a column changes by no more than its own error may be.
    fn is_level(&mut self, column: usize, places: &[f64], values: &[Option<f64>]) -> bool {
        let Some((low, high)) = ends(values) else {
            return true;
        };
        let size = low.abs().max(high.abs());
        if high - low <= ROUNDING * size {
            return true;
        }
        let largest = values
            .iter()
            .position(|v| v.is_some_and(|v| v.abs() == size));
        let Some(place) = largest.and_then(|i| places.get(i)) else {
            return false;
        };
        self.solve(*place);
        let mut enclosure = self.solver.enclosure();
        self.solver.enclose(&self.state, self.order, &mut enclosure);
        let bound = self.columns[column].bound(&self.state, &enclosure);
        bound.is_some_and(|bound| high - low <= DOUBT * bound)
    }

    /// Where a curve turns. `at` of each is still the place, and `along` is not yet known.
    fn extrema(
        &mut self,
        column: usize,
        curve: &Curve,
        places: &[f64],
        goes_round: bool,
        ends_are_limits: bool,
    ) -> Vec<Extremum> {
        let size = curve.range().map_or(0.0, |(low, high)| high - low);
        if curve.is_level || size <= 0.0 {
            return Vec::new();
        }
        let mut found = Vec::new();
        for piece in runs(&curve.values, &curve.breaks) {
            let values: Vec<f64> = curve.values[piece.clone()]
                .iter()
                .copied()
                .flatten()
                .collect();
            let goes_round = goes_round && values.len() == places.len();
            for turn in turns(&values, LEAST_TURN * size, goes_round) {
                let sample = piece.start + turn.sample;
                let is_limit = ends_are_limits && (sample == 0 || sample + 1 == places.len());
                if turn.is_end && !is_limit {
                    continue;
                }
                let (at, value) = if turn.is_end {
                    (places[sample], values[turn.sample])
                } else {
                    self.refined(column, sample, turn.is_peak, values[turn.sample], places)
                };
                found.push(Extremum {
                    is_peak: turn.is_peak,
                    at,
                    along: f64::NAN,
                    value,
                    is_extreme: false,
                });
            }
        }
        mark_extremes(&mut found);
        found
    }

    /// The place and the value of a turn near a sample.
    fn refined(
        &mut self,
        column: usize,
        sample: usize,
        is_peak: bool,
        value: f64,
        places: &[f64],
    ) -> (f64, f64) {
        let step = (places[places.len() - 1] - places[0]) / (places.len() - 1) as f64;
        let here = places[sample];
        let sense = if is_peak { -1.0 } else { 1.0 };
        let f = |place| Some(sense * self.value(column, place)?);
        let (place, value) = lowest(f, [here - step, here + step], (here, sense * value));
        (place, sense * value)
    }
}

/// The samples that hang together.
fn runs(values: &[Option<f64>], breaks: &[bool]) -> Vec<std::ops::Range<usize>> {
    let mut runs = Vec::new();
    let mut start = None;
    for (i, value) in values.iter().enumerate() {
        if value.is_some() {
            start = start.or(Some(i));
        }
        let ends = value.is_none() || breaks.get(i).copied().unwrap_or(true);
        if ends && let Some(start) = start.take() {
            runs.push(start..i + usize::from(value.is_some()));
        }
    }
    runs
}

/// Marks the largest of the maxima and the smallest of the minima.
fn mark_extremes(extrema: &mut [Extremum]) {
    for is_peak in [true, false] {
        let sense = if is_peak { 1.0 } else { -1.0 };
        let all = extrema.iter_mut().filter(|e| e.is_peak == is_peak);
        // Of equals the first.
        let most = all.reduce(|best, e| {
            if sense * e.value > sense * best.value {
                e
            } else {
                best
            }
        });
        if let Some(most) = most {
            most.is_extreme = true;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    fn opened(text: &str) -> (Scene, Solver) {
        let scene = Scene::parse(text, "test").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        (scene, solver)
    }

    fn preset(name: &str) -> (Scene, Solver) {
        opened(presets::find(name).unwrap().text)
    }

    fn sampled((scene, solver): &(Scene, Solver), columns: &[&str], abscissa: Abscissa) -> Curves {
        let figures = Catalogue::new(scene).select(columns).unwrap();
        Curves::new(scene, solver, &figures, abscissa, None).unwrap()
    }

    fn turns(curve: &Curve) -> Vec<(f64, f64)> {
        let mut all: Vec<_> = curve.extrema.iter().map(|e| (e.at, e.value)).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all
    }

    /// What is promised: the value to rounding, the place to 1e-5 deg.
    fn close(found: &[(f64, f64)], wanted: &[(f64, f64)]) {
        assert_eq!(found.len(), wanted.len(), "{found:?}");
        for (f, w) in found.iter().zip(wanted) {
            let apart = (f.0 - w.0).rem_euclid(TURN);
            assert!(apart.min(TURN - apart) < 1e-5, "{f:?} {w:?}");
            assert!((f.1 - w.1).abs() <= 1e-13 * w.1.abs(), "{f:?} {w:?}");
        }
    }

    /// At the dead centres crank r and rod l are in line: x^2 + e^2 = (l +- r)^2, and the crank points
    /// along the rod, or against it.
    #[test]
    fn strokes_end_at_the_dead_centres() {
        let curves = sampled(&preset("slider-crank"), &["C.x"], Abscissa::Driver);
        close(&turns(&curves.curves[0]), &[(0.0, 30.0), (180.0, 10.0)]);
        let text = presets::find("slider-crank").unwrap().text;
        let offset = text.replace("through = \"A\", angle = 0", "through = [0, -4], angle = 0");
        assert_ne!(offset, text);
        let offset = offset.replace("C = [28, 0]", "C = [28, -4]");
        let curves = sampled(&opened(&offset), &["C.x"], Abscissa::Driver);
        let (far, near) = ((900.0_f64 - 16.0).sqrt(), (100.0_f64 - 16.0).sqrt());
        let angle = |x: f64| (-4.0_f64).atan2(x).to_degrees();
        let wanted = [(angle(near) + 180.0, near), (angle(far) + 360.0, far)];
        close(&turns(&curves.curves[0]), &wanted);
    }

    /// The rocker of a crank-rocker turns back where crank and coupler are in line: the law of cosines.
    #[test]
    fn a_rocker_turns_back_where_crank_and_coupler_are_in_line() {
        let curves = sampled(&preset("four-bar"), &["r4.angle"], Abscissa::Driver);
        let rocker = |reach: f64| {
            let cosine =
                (400.0_f64.powi(2) + 250.0_f64.powi(2) - reach * reach) / (2.0 * 400.0 * 250.0);
            360.0 - cosine.acos().to_degrees()
        };
        let values: Vec<f64> = curves.curves[0].extrema.iter().map(|e| e.value).collect();
        assert_eq!(values.len(), 2);
        for wanted in [rocker(400.0), rocker(200.0)] {
            assert!(
                values.iter().any(|v| (v - wanted).abs() < 1e-11),
                "{values:?} {wanted}"
            );
        }
    }

    #[test]
    fn samples_are_the_states_themselves() {
        for name in ["four-bar", "stephenson-six-bar", "double-rocker", "kite"] {
            let (scene, solver) = preset(name);
            let figures = Catalogue::new(&scene).figures();
            let curves = Curves::new(&scene, &solver, &figures, Abscissa::Driver, None).unwrap();
            let mut state = solver.state();
            for (k, &at) in curves.at.iter().enumerate().step_by(7) {
                let condition = solver.solve(at, Order::Acceleration, &mut state);
                assert_eq!(condition, curves.conditions[k], "{name} {at}");
                let here = curves.here(&state);
                for (curve, value) in curves.curves.iter().zip(here.values) {
                    let bits = |v: Option<f64>| v.map(f64::to_bits);
                    assert_eq!(
                        bits(curve.values[k]),
                        bits(value),
                        "{name} {} {at}",
                        curve.quantity.name
                    );
                }
                let along = here.along.unwrap();
                assert!((along - at).rem_euclid(curves.period.unwrap_or(f64::MAX)) < 1e-9);
            }
        }
    }

    #[test]
    fn a_period_of_two_turns_and_limits_are_covered_whole() {
        let curves = sampled(&preset("kite"), &["C.x"], Abscissa::Driver);
        assert_eq!(curves.span(), Some((0.0, 720.0)));
        let (scene, solver) = preset("double-rocker");
        let curves = sampled(&(scene, solver.clone()), &["C.x", "C.vx"], Abscissa::Driver);
        let Range::Limited { low, high } = solver.motion().range else {
            panic!("it is limited");
        };
        assert_eq!(curves.span(), Some((low, high)));
        // Places exist at the limits, rates do not, and grow beyond all bounds before.
        let [place, rate] = &curves.curves[..] else {
            panic!()
        };
        assert!(place.values[0].is_some() && rate.values[0].is_none());
        let (low, high) = ends(&rate.values).unwrap();
        let shown = rate.range().unwrap();
        assert!(
            shown.1 - shown.0 < 0.6 * (high - low),
            "{shown:?} of {low} to {high}"
        );
        assert_eq!(curves.pieces(1).len(), 1);
    }

    #[test]
    fn directions_jump_at_360_deg_and_nothing_else_does() {
        let (scene, solver) = preset("drag-link");
        let figures = Catalogue::new(&scene).figures();
        let curves = Curves::new(&scene, &solver, &figures, Abscissa::Driver, None).unwrap();
        for (i, curve) in curves.curves.iter().enumerate() {
            for piece in curves.pieces(i) {
                let steps = piece.windows(2).map(|p| (p[1][1] - p[0][1]).abs());
                let most = steps.fold(0.0, f64::max);
                if curve.quantity.aspect == Aspect::Angle {
                    assert!(most < 180.0, "{} {most}", curve.quantity.name);
                }
            }
            if curve.quantity.aspect != Aspect::Angle {
                assert_eq!(curves.pieces(i).len(), 1, "{}", curve.quantity.name);
            }
        }
    }

    #[test]
    fn a_pole_is_a_gap_and_a_steep_slope_is_none() {
        let (scene, solver) = preset("four-bar");
        let figures = Catalogue::new(&scene).select(&["C.x"]).unwrap();
        let mut probe = Probe::new(&solver, &figures, solver.motion().range, None);
        // C.x itself, from one end of its stroke to the other: steep, but no jump.
        let values = [0.0, 180.0].map(|at| probe.value(0, at).unwrap());
        assert!(!probe.jumps(0, [0.0, 180.0], values));
        // Values that are not those of the curve stand for a jump behind the first sample.
        assert!(probe.jumps(0, [0.0, 180.0], [1e6, values[1]]));
    }

    /// With an acceleration, too, the slope of a place over time is the velocity beside it, and the slope
    /// of that the acceleration.
    #[test]
    fn over_time_rates_are_the_slopes_of_what_stands_beside_them() {
        let text = presets::find("four-bar").unwrap().text;
        for speed in [
            "speed = \"15 rad/s\"",
            "speed = \"15 rad/s\"\nacceleration = \"40 rad/s^2\"",
            "speed = \"-3 rad/s\"\nacceleration = \"2 rad/s^2\"",
        ] {
            let scene = opened(&text.replace("speed = \"15 rad/s\"", speed));
            for names in [
                ["C.x", "C.vx", "C.ax"],
                ["r4.angle", "r4.omega", "r4.alpha"],
            ] {
                let curves = sampled(&scene, &names, Abscissa::Time);
                let unit = if names[0] == "C.x" {
                    1.0
                } else {
                    1.0_f64.to_radians()
                };
                for (of, slope, scale) in [(0, 1, unit), (1, 2, 1.0)] {
                    let size = curves.curves[slope].range().unwrap();
                    let size = size.0.abs().max(size.1.abs());
                    for k in (1..curves.at.len() - 1).step_by(11) {
                        let t = |k: usize| curves.along[k].unwrap();
                        let v = |k: usize| curves.curves[of].values[k].unwrap() * scale;
                        let found = (v(k + 1) - v(k - 1)) / (t(k + 1) - t(k - 1));
                        let wanted = curves.curves[slope].values[k].unwrap();
                        assert!(
                            (found - wanted).abs() < 2e-3 * size,
                            "{speed} {names:?} {found} {wanted}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn without_a_speed_there_is_no_time() {
        let text = presets::find("four-bar")
            .unwrap()
            .text
            .replace("15 rad/s", "0 rad/s");
        let (scene, solver) = opened(&text);
        let figures = Catalogue::new(&scene).select(&["C.x"]).unwrap();
        let none = Curves::new(&scene, &solver, &figures, Abscissa::Time, None);
        assert!(matches!(none, Err(NoTime::StandsStill)));
    }

    #[test]
    fn what_is_all_rounding_is_level() {
        let curves = sampled(
            &preset("slider-crank"),
            &["C.y", "C.vy", "C.x", "r2.omega"],
            Abscissa::Driver,
        );
        let level: Vec<bool> = curves.curves.iter().map(Curve::is_level).collect();
        assert_eq!(level, [true, true, false, true]);
    }
}
