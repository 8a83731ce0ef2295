//! Searches the worst case if the tolerances reach an edge of assembly: a dead point of a machine
//! within them.
//!
//! At an edge the measure of a group is zero (for a dyad, the squared sine of its transmission
//! angle). Rates are proportional to its inverse square root there, and values have infinite
//! slopes, so steps along single lengths fail. A value is therefore followed on surfaces of
//! constant measure, closer and closer to the edge, where it is smooth. Each step moves to the best
//! machine according to the derivatives of value and measure, and then back to the surface.

use super::machines::Machines;
use super::tolerance_box::ToleranceBox;
use super::worst_case::{WorstCase, WorstKind};

/// The measures of the surfaces, relative to the nominal measure, which is limited to 1/100.
const LEVELS: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-8];
const MAX_BASE: f64 = 1e-2;
/// The relative measure of the last surface, where values without a pole are as accurate as at the
/// edge.
const AT_EDGE: f64 = 1e-13;
/// The growth of a value's steps from surface to surface that identifies a pole. The steps of a
/// pole grow at least tenfold; those of a term proportional to the root of the measure shrink
/// tenfold.
const GROWN: f64 = 4.0;
/// Number of steps on the first surface, and on the others, which start near their best machine.
const FIRST_STEPS: usize = 24;
const EXTRA_STEPS: usize = 8;
/// The shortest step, after which the best machine is found, and the factor that shortens steps.
const MIN_LEN: f64 = 1e-3;
const SHORTER: f64 = 0.3;
/// The relative change of a value below which there is no gain.
const MIN_GAIN: f64 = 1e-10;
/// The relative tolerance of a machine's measure on its surface, and the maximum number of machines
/// to reach it.
const ON_LEVEL: f64 = 1e-6;
const PLACEMENT_COUNT: usize = 60;
/// The factor by which a machine's measure may exceed the surface's if rounding errors dominate.
const ROUNDING_FACTOR: f64 = 4.0;
/// Bisections towards a machine without the value.
const HALVINGS: usize = 40;
/// Steps of differences, relative to a tolerance, and their maximum effect relative to the measure.
const DIFFERENCE: f64 = 1e-4;
const PART_OF_MEASURE: f64 = 0.02;
/// The factor within which derivatives at the nominal lengths predict the effect of a whole
/// tolerance.
const NONLINEAR: f64 = 3.0;

/// A machine with a group at its edge, or almost there.
#[derive(Clone, Debug)]
struct ReachedEdge {
    group: usize,
    /// The measure that the levels are relative to.
    base: f64,
    machine: Vec<f64>,
}

/// The result for a value in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct EdgeReach {
    furthest: f64,
    is_unbounded: bool,
}

/// Follows values of machines at one place of the driver.
pub(super) struct EdgeSearch<'a, M> {
    machines: &'a mut M,
    off: &'a ToleranceBox,
    /// The indices of all deviations with an effect.
    acting: Vec<usize>,
    values: Vec<Option<f64>>,
}

impl<'a, M: Machines> EdgeSearch<'a, M> {
    /// Prepares a search over these deviations of a box.
    pub(super) fn new(
        machines: &'a mut M,
        off: &'a ToleranceBox,
        acting: Vec<usize>,
        count: usize,
    ) -> EdgeSearch<'a, M> {
        EdgeSearch {
            machines,
            off,
            acting,
            values: vec![None; count],
        }
    }

    /// Widens the worst cases by the values at edges within the tolerances. Enclosed worst cases
    /// are proved already and stay.
    pub(super) fn widen(&mut self, nominal: &[Option<f64>], worst: &mut [Option<WorstCase>]) {
        let is_open = |worst: &Option<WorstCase>| {
            worst.is_some_and(|worst| worst.kind != WorstKind::Enclosed)
        };
        if !worst.iter().any(is_open) {
            return;
        }
        let fails = worst.iter().flatten().any(|worst| worst.fails);
        let edges = self.edges(fails);
        for (index, (worst, nominal)) in worst.iter_mut().zip(nominal).enumerate() {
            let (Some(found), Some(nominal)) = (worst.as_mut(), nominal) else {
                continue;
            };
            let is_inside = matches!(found.kind, WorstKind::Searched | WorstKind::AtEdge);
            if found.kind == WorstKind::Enclosed || (edges.is_empty() && !is_inside) {
                continue;
            }
            found.fails |= !edges.is_empty();
            let ends = [-1.0, 1.0].map(|sign| self.extreme_value(&edges, index, sign, *nominal));
            found.extend(
                ends.map(|end| end.furthest),
                ends.map(|end| end.is_unbounded),
            );
        }
    }

    /// Returns the extreme value in one direction, on all edges and away from them.
    fn extreme_value(
        &mut self,
        edges: &[ReachedEdge],
        index: usize,
        sign: f64,
        nominal: f64,
    ) -> EdgeReach {
        let inside = self.off.nothing();
        let mut reach = EdgeReach {
            furthest: nominal,
            is_unbounded: false,
        };
        let meet = |reach: &mut EdgeReach, value: f64| {
            if sign * (value - reach.furthest) > 0.0 {
                reach.furthest = value;
            }
        };
        let start = (inside.clone(), nominal);
        let (_, value) = self.climb(None, index, sign, start, FIRST_STEPS);
        meet(&mut reach, value);
        for edge in edges {
            let along = self.along_edge(edge, index, sign);
            let values: Vec<f64> = along.iter().map(|(_, value)| *value).collect();
            values.iter().for_each(|&value| meet(&mut reach, value));
            reach.is_unbounded |= is_pole(sign, &values);
            // The extreme machine away from the edge may lie in another corner than the one reached
            // from the nominal lengths.
            if let Some(first) = along.into_iter().next() {
                let (_, value) = self.climb(None, index, sign, first, FIRST_STEPS);
                meet(&mut reach, value);
            }
        }
        reach
    }

    /// Returns the extreme machine and its value on each surface towards an edge.
    fn along_edge(&mut self, edge: &ReachedEdge, index: usize, sign: f64) -> Vec<(Vec<f64>, f64)> {
        let mut found: Vec<(Vec<f64>, f64)> = Vec::new();
        let mut from = edge.machine.clone();
        let inside = self.off.nothing();
        for (i, level) in LEVELS.into_iter().chain([AT_EDGE]).enumerate() {
            let level = level * edge.base;
            let lower = match i {
                0 => edge.machine.clone(),
                _ => self.lower(edge, &from, level),
            };
            let Some(machine) = self.cross_level(edge.group, [&inside, &from], level, &lower)
            else {
                break;
            };
            let Some(value) = self.figure(&machine, index) else {
                break;
            };
            let steps = match i {
                0 => FIRST_STEPS,
                _ if i < LEVELS.len() => EXTRA_STEPS,
                _ => 0,
            };
            let best = self.climb(Some((edge, level)), index, sign, (machine, value), steps);
            from.clone_from(&best.0);
            found.push(best);
        }
        found
    }

    /// Moves from machine to machine while the value improves, on a surface or in the whole box.
    fn climb(
        &mut self,
        surface: Option<(&ReachedEdge, f64)>,
        index: usize,
        sign: f64,
        (mut machine, mut value): (Vec<f64>, f64),
        steps: usize,
    ) -> (Vec<f64>, f64) {
        let inside = self.off.nothing();
        let mut part = 1.0;
        for _ in 0..steps {
            let by = self.differences(surface.map(|(edge, _)| edge.group), &machine);
            let figure_slopes = self.slopes(&machine, &by, |search, machine| {
                search.figure(machine, index).map(|value| sign * value)
            });
            let surface_slopes = surface.map(|(edge, _)| {
                self.slopes(&machine, &by, |search, machine| {
                    search.measure(machine, edge.group)
                })
            });
            let aim = match &surface_slopes {
                Some(slopes) => self.off.extreme_at_level(&figure_slopes, slopes, &machine),
                None => self.off.extreme_machine(&figure_slopes, &machine),
            };
            let mut gained = false;
            while part > MIN_LEN {
                let trial = between(&machine, &aim, part);
                let trial = match surface {
                    Some((edge, level)) => {
                        self.cross_level(edge.group, [&inside, &trial], level, &edge.machine)
                    }
                    None => Some(trial),
                };
                let there = trial.and_then(|trial| Some((self.figure(&trial, index)?, trial)));
                match there {
                    Some((there, trial)) if sign * (there - value) > MIN_GAIN * value.abs() => {
                        (machine, value) = (trial, there);
                        part = (2.0 * part).min(1.0);
                        gained = true;
                        break;
                    }
                    Some(_) | None => part *= SHORTER,
                }
            }
            if !gained {
                break;
            }
        }
        (machine, value)
    }

    /// Finds the edges within the tolerances: for each group the nearest one, and one on the
    /// opposite side if there is one.
    fn edges(&mut self, fails: bool) -> Vec<ReachedEdge> {
        let nothing = self.off.nothing();
        self.machines.make(&nothing, &mut self.values);
        let given: Vec<f64> = self.machines.measures().to_vec();
        let mut edges = Vec::new();
        for (group, measure) in given.into_iter().enumerate() {
            // The negation also excludes NaN.
            if !(measure > 0.0) {
                continue;
            }
            let by = self.differences(Some(group), &nothing);
            let slopes = self.slopes(&nothing, &by, |search, by| search.measure(by, group));
            let aim = self.off.extreme_machine(&slopes, &nothing);
            let maximum: f64 = slopes.iter().zip(&aim).map(|(slope, by)| slope * by).sum();
            if !fails && measure > NONLINEAR * maximum {
                continue;
            }
            let base = measure.min(MAX_BASE);
            let starts = [nothing.clone(), aim];
            let found = starts.into_iter().filter_map(|start| {
                let machine = self.descend(group, base, start)?;
                Some(ReachedEdge {
                    group,
                    base,
                    machine,
                })
            });
            edges.extend(found.collect::<Vec<_>>());
        }
        edges
    }

    /// Descends along the derivatives of a group's measure to a machine at its edge; `None` if the
    /// measure stays away from zero.
    fn descend(&mut self, group: usize, base: f64, mut machine: Vec<f64>) -> Option<Vec<f64>> {
        let lowest = LEVELS[LEVELS.len() - 1] * base;
        let mut measure = self.measure(&machine, group)?;
        let mut part = 1.0;
        for _ in 0..FIRST_STEPS {
            if measure <= lowest {
                return Some(machine);
            }
            let by = self.differences(Some(group), &machine);
            let slopes = self.slopes(&machine, &by, |search, machine| {
                search.measure(machine, group).map(|measure| -measure)
            });
            let aim = self.off.extreme_machine(&slopes, &machine);
            while part > MIN_LEN {
                let trial = between(&machine, &aim, part);
                match self.measure(&trial, group) {
                    Some(there) if there < measure => {
                        (machine, measure) = (trial, there);
                        part = (2.0 * part).min(1.0);
                        break;
                    }
                    Some(_) => part *= SHORTER,
                    // Another group may be open there, or this group may be open without a measure.
                    None => {
                        let closes = self.last_that_closes(group, [&machine, &trial]);
                        return self
                            .measure(&closes, group)
                            .filter(|&m| m <= lowest)
                            .map(|_| closes);
                    }
                }
            }
            if part <= MIN_LEN {
                break;
            }
        }
        (measure <= lowest).then_some(machine)
    }

    /// Finds the last machine with a positive measure between one that has it and one that does
    /// not.
    fn last_that_closes(&mut self, group: usize, [from, to]: [&[f64]; 2]) -> Vec<f64> {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..PLACEMENT_COUNT {
            let middle = f64::midpoint(low, high);
            let measure = self.measure(&between(from, to, middle), group);
            match measure.is_some_and(|measure| measure > 0.0) {
                true => low = middle,
                false => high = middle,
            }
        }
        between(from, to, low)
    }

    /// Returns a machine below a surface: along the steepest descent from another one, or else the
    /// machine at the edge.
    fn lower(&mut self, edge: &ReachedEdge, machine: &[f64], level: f64) -> Vec<f64> {
        let by = self.differences(Some(edge.group), machine);
        let slopes = self.slopes(machine, &by, |search, machine| {
            search.measure(machine, edge.group).map(|measure| -measure)
        });
        let aim = self.off.extreme_machine(&slopes, machine);
        match self.measure(&aim, edge.group) {
            Some(measure) if measure >= level => edge.machine.clone(),
            Some(_) | None => aim,
        }
    }

    /// Returns the machine on a surface between two machines; if both lie above it, between the
    /// second one and `lower`.
    fn cross_level(
        &mut self,
        group: usize,
        [inside, outside]: [&[f64]; 2],
        level: f64,
        lower: &[f64],
    ) -> Option<Vec<f64>> {
        let measure = self.measure(outside, group);
        let (from, to) = match measure {
            Some(measure) if (measure - level).abs() <= ON_LEVEL * level => {
                return Some(outside.to_vec());
            }
            Some(measure) if measure > level => (outside, lower),
            Some(_) | None => (inside, outside),
        };
        let above = |measure: Option<f64>| measure.unwrap_or(-level) - level;
        let mut ends = [from, to].map(|machine| above(self.measure(machine, group)));
        let (mut low, mut high) = (0.0, 1.0);
        if !(ends[0] > 0.0 && ends[1] <= 0.0) {
            return None;
        }
        for round in 0..PLACEMENT_COUNT {
            let secant = ends[0] / (ends[0] - ends[1]);
            let part = if round % 3 == 2 { 0.5 } else { secant };
            let middle = low + (high - low) * part;
            let machine = between(from, to, middle);
            let there = above(self.measure(&machine, group));
            if there.abs() <= ON_LEVEL * level {
                return Some(machine);
            }
            match there > 0.0 {
                true => (low, ends[0]) = (middle, there),
                false => (high, ends[1]) = (middle, there),
            }
        }
        // This close to the edge the measure consists mostly of rounding errors.
        let machine = between(from, to, low);
        let measure = self.measure(&machine, group)?;
        (measure > 0.0 && measure < ROUNDING_FACTOR * level).then_some(machine)
    }

    /// Returns the measure of a group, not positive if it is open; `None` if another group is open.
    fn measure(&mut self, machine: &[f64], group: usize) -> Option<f64> {
        let closes = self.machines.make(machine, &mut self.values);
        let measure = self.machines.measures().get(group).copied()?;
        (closes || measure <= 0.0).then_some(measure)
    }

    fn figure(&mut self, machine: &[f64], index: usize) -> Option<f64> {
        self.machines.make(machine, &mut self.values);
        self.values[index].filter(|value| value.is_finite())
    }

    /// Returns the steps of differences: small compared to the tolerances, and in effect to the
    /// measure.
    fn differences(&mut self, group: Option<usize>, machine: &[f64]) -> Vec<f64> {
        let mut by: Vec<f64> = self.off.limits.iter().map(|by| DIFFERENCE * by).collect();
        let Some(group) = group else {
            return by;
        };
        let Some(measure) = self.measure(machine, group) else {
            return by;
        };
        let slopes = self.slopes(machine, &by, |search, by| search.measure(by, group));
        for (by, slope) in by.iter_mut().zip(slopes) {
            let maximum = PART_OF_MEASURE * measure.abs() / slope.abs();
            *by = maximum.clamp(1e-6 * *by, *by);
        }
        by
    }

    /// Returns the derivatives by all deviations, as two-sided differences, or one-sided ones if
    /// one value is missing.
    fn slopes(
        &mut self,
        machine: &[f64],
        by: &[f64],
        mut read: impl FnMut(&mut Self, &[f64]) -> Option<f64>,
    ) -> Vec<f64> {
        let mut slopes = self.off.nothing();
        let here = read(self, machine);
        let mut nearby = machine.to_vec();
        for i in 0..self.acting.len() {
            let number = self.acting[i];
            let mut side = |search: &mut Self, by: f64| {
                nearby[number] = machine[number] + by;
                let value = read(search, &nearby);
                nearby[number] = machine[number];
                value
            };
            let by = by[number];
            let (above, below) = (side(self, by), side(self, -by));
            slopes[number] = match (above, here, below) {
                (Some(above), _, Some(below)) => (above - below) / (2.0 * by),
                (Some(above), Some(here), None) => (above - here) / by,
                (None, Some(here), Some(below)) => (here - below) / by,
                _ => 0.0,
            };
        }
        slopes
    }
}

/// Follows a value from the nominal machine towards one that lacks it, up to the edge where it
/// ceases to exist. Returns its extreme values in both directions, and whether it grows without
/// bound. Returns `None` if it does not exist on the way.
pub(super) fn along_ray(
    machines: &mut impl Machines,
    index: usize,
    nominal: f64,
    to: &[f64],
) -> Option<([f64; 2], [bool; 2])> {
    let mut values = vec![None; index + 1];
    let given = vec![0.0; to.len()];
    let mut value = |part: f64| {
        machines.make(&between(&given, to, part), &mut values);
        values[index].filter(|value| value.is_finite())
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        match value(middle).is_some() {
            true => low = middle,
            false => high = middle,
        }
    }
    let found = LEVELS.into_iter().map(|level| value(low * (1.0 - level)));
    let found: Vec<f64> = found.collect::<Option<_>>()?;
    let minimum = found.iter().copied().fold(nominal, f64::min);
    let maximum = found.iter().copied().fold(nominal, f64::max);
    Some((
        [minimum, maximum],
        [-1.0, 1.0].map(|sign| is_pole(sign, &found)),
    ))
}

/// Returns `true` if values on successive surfaces grow without bound, by increasing steps.
fn is_pole(sign: f64, values: &[f64]) -> bool {
    let Some(values) = values.get(..LEVELS.len()) else {
        return false;
    };
    let steps: Vec<f64> = values
        .windows(2)
        .map(|pair| sign * (pair[1] - pair[0]))
        .collect();
    let [.., before, last] = steps[..] else {
        return false;
    };
    before > 0.0 && last > GROWN * before && last > MIN_GAIN.sqrt() * values[0].abs()
}

/// Returns the machine at a fraction of the way from one to another.
fn between(from: &[f64], to: &[f64], part: f64) -> Vec<f64> {
    let pairs = from.iter().zip(to);
    pairs.map(|(from, to)| from + part * (to - from)).collect()
}
