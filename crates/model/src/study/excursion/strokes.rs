//! Computes time ratios and dwells from the extrema of a quantity.

use super::sampler::{JUMP_DISTANCE, MotionSampler, SampledFigure};
use super::{Excursion, ExtremumPlace, FigurePlace, NoFigure};
use crate::numeric::root;
use crate::quantity::Clock;
use crate::solver::Range;

/// The difference below which two extrema are equal, relative to the stroke.
const EQUALITY_TOLERANCE: f64 = 1e-9;

/// The distance of two extremes below which the quantity jumps, relative to the motion: both sides
/// of the jump were sampled.
const JUMP_SPACING: f64 = 4.0 * JUMP_DISTANCE;

/// The time ratio of both ways between the extremes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeRatio {
    /// The ratio of the slow to the quick way, at least 1.
    pub value: f64,
    /// The driver's travel during the slow and the quick way, in degrees or in the scene's length
    /// unit. These are times in s if the driver's speed is not constant.
    pub travels: [f64; 2],
    /// `true` if `ways` are times.
    pub are_times: bool,
    /// `true` if the slow way leads from the minimum to the maximum, in the driver's direction.
    pub rises_slowly: bool,
}

/// A stretch on which a quantity stays within a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DwellStretch {
    /// The extremum of the stretch, at one edge of the tolerance.
    pub about: ExtremumPlace,
    /// The driver's coordinate at its beginning.
    pub from: f64,
    /// The driver's coordinate at its end.
    pub to: f64,
    /// The driver's travel on the stretch; to and fro if it includes a limit.
    pub travel: f64,
    /// `true` if the stretch includes a limit, so that it counts twice.
    pub counts_twice: bool,
    /// The duration in s; `None` if the driver's speed is zero or not constant.
    pub seconds: Option<f64>,
}

/// The kind of an extreme.
#[derive(Clone, Copy, PartialEq)]
enum ExtremeEnd {
    Minimum,
    Maximum,
}

impl Excursion {
    /// Computes the time ratio; if an extreme is reached several times, the ways are summed.
    pub(super) fn time_ratio(&self, sampler: &MotionSampler) -> Result<TimeRatio, NoFigure> {
        let Range::Full { period } = sampler.range() else {
            return Err(NoFigure::ThereAndBack);
        };
        if self.revolutions != 0.0 {
            return Err(NoFigure::TurnsRound);
        }
        if self.rests() {
            return Err(NoFigure::Rests);
        }
        let extremes = self.extremes();
        let Some(&(first, _)) = extremes.first() else {
            return Err(NoFigure::NeverTurns);
        };
        let driver = sampler.driver();
        let forwards = driver.speed >= 0.0;
        let clock = match driver.acceleration != 0.0 {
            true => Clock::new(driver),
            false => None,
        };
        // In the driver's order from the scene's start, over one period.
        let ahead = |at: f64| match forwards {
            true => driver.start + (at - driver.start).rem_euclid(period),
            false => driver.start - (driver.start - at).rem_euclid(period),
        };
        let mut round: Vec<(f64, ExtremeEnd)> = Vec::new();
        round.extend(extremes.iter().map(|&(at, end)| (ahead(at), end)));
        round.sort_by(|a, b| a.0.total_cmp(&b.0));
        let turn = if forwards { period } else { -period };
        if !forwards {
            round.reverse();
        }
        let start = round.first().map_or((first, ExtremeEnd::Minimum), |&b| b);
        round.push((start.0 + turn, start.1));
        let is_leap = |pair: &[(f64, ExtremeEnd)]| {
            pair[0].1 != pair[1].1 && (pair[1].0 - pair[0].0).abs() <= JUMP_SPACING * period
        };
        if round.windows(2).any(is_leap) {
            return Err(NoFigure::Leaps);
        }
        let moment = |at: f64| match &clock {
            Some(clock) => clock.time(at).ok_or(NoFigure::DriverTurnsBack),
            None => Ok((at - start.0).abs()),
        };
        let (mut rising, mut falling) = (0.0, 0.0);
        for pair in round.windows(2) {
            let travel = moment(pair[1].0)? - moment(pair[0].0)?;
            *(match pair[0].1 {
                ExtremeEnd::Minimum => &mut rising,
                ExtremeEnd::Maximum => &mut falling,
            }) += travel;
        }
        let travels = [rising.max(falling), rising.min(falling)];
        let value = travels[0] / travels[1];
        // Without a way back there is no ratio.
        match value.is_finite() {
            true => Ok(TimeRatio {
                value,
                travels,
                are_times: clock.is_some(),
                rises_slowly: rising >= falling,
            }),
            false => Err(NoFigure::NeverTurns),
        }
    }

    /// Returns the coordinates of the minimum and the maximum values, in order.
    fn extremes(&self) -> Vec<(f64, ExtremeEnd)> {
        let end = |turning: &ExtremumPlace| Some((turning.place.at, self.end_at(turning)?));
        self.turnings.iter().filter_map(end).collect()
    }

    /// Returns `true` if the quantity has a plateau at its minimum or maximum.
    fn rests(&self) -> bool {
        let stays = |turning: &&ExtremumPlace| turning.until.is_some();
        let mut staying = self.turnings.iter().filter(stays);
        staying.any(|turning| self.end_at(turning).is_some())
    }

    /// Returns the kind of extreme at an extremum; `None` for a local one.
    fn end_at(&self, turning: &ExtremumPlace) -> Option<ExtremeEnd> {
        let near = EQUALITY_TOLERANCE * (self.greatest.value - self.least.value);
        let ends = [
            (self.least.value, ExtremeEnd::Minimum),
            (self.greatest.value, ExtremeEnd::Maximum),
        ];
        let mut ends = ends.into_iter();
        let is_at = ends.find(|(extreme, _)| (turning.place.value - extreme).abs() <= near);
        is_at.map(|(_, end)| end)
    }

    /// Returns the stretches on which the quantity stays within a tolerance of an extremum, on the
    /// side of its reversal. Stretches that lie more than half within a longer one are left out.
    pub(super) fn dwelling(
        &self,
        sampler: &mut MotionSampler,
        (column, sampled): (usize, &SampledFigure),
        tolerance: f64,
    ) -> Vec<DwellStretch> {
        let turnings = 0..self.turnings.len();
        let of = (column, sampled);
        let found = turnings.filter_map(|about| self.dwell_about(about, sampler, of, tolerance));
        let mut found: Vec<DwellStretch> = found.collect();
        let width = |dwell: &DwellStretch| dwell.to - dwell.from;
        found.sort_by(|a, b| width(b).total_cmp(&width(a)));
        let period = match sampler.range() {
            Range::Full { period } => Some(period),
            Range::Limited { .. } => None,
        };
        let mut text: Vec<DwellStretch> = Vec::new();
        for dwell in found {
            let is_new =
                |longer: &DwellStretch| 2.0 * shared(&dwell, longer, period) <= width(&dwell);
            if text.iter().all(is_new) {
                text.push(dwell);
            }
        }
        text.sort_by(|a, b| a.about.place.at.total_cmp(&b.about.place.at));
        text
    }

    fn dwell_about(
        &self,
        about: usize,
        sampler: &mut MotionSampler,
        of: (usize, &SampledFigure),
        tolerance: f64,
    ) -> Option<DwellStretch> {
        let turning = self.turnings[about];
        let [low, high] =
            [false, true].map(|forwards| self.stays_until(about, forwards, sampler, of, tolerance));
        let (low, high) = (low?, high?);
        let (mut travel, mut from, to) =
            (low + high, turning.place.at - low, turning.place.at + high);
        let there_and_back = match sampler.range() {
            Range::Full { period } => {
                travel = travel.min(period);
                from = from.max(to - period);
                false
            }
            // At a limit the driver reverses and passes the stretch again.
            Range::Limited { low, high } => from <= low || to >= high,
        };
        if there_and_back {
            travel *= 2.0;
        }
        Some(DwellStretch {
            about: turning,
            from,
            to,
            travel,
            counts_twice: there_and_back,
            seconds: sampler.seconds(travel),
        })
    }

    /// Returns how far from an extremum the quantity stays between its value and the other edge of
    /// the tolerance.
    fn stays_until(
        &self,
        about: usize,
        forwards: bool,
        sampler: &mut MotionSampler,
        of: (usize, &SampledFigure),
        tolerance: f64,
    ) -> Option<f64> {
        let count = self.turnings.len();
        let turning = self.turnings[about];
        let edge = match turning.is_peak {
            true => turning.place.value - tolerance,
            false => turning.place.value + tolerance,
        };
        let edges = [turning.place.value.min(edge), turning.place.value.max(edge)];
        let mut here = turning.place;
        for hop in 1..=count {
            let next = self.hop(about, hop, forwards, sampler.range());
            let Some(next) = next else {
                return Some((here.at - turning.place.at).abs());
            };
            if !(edges[0]..=edges[1]).contains(&next.value) {
                let edge = if next.value < edges[0] {
                    edges[0]
                } else {
                    edges[1]
                };
                let at = crossing([here, next], edge, sampler, of)?;
                return Some((at - turning.place.at).abs());
            }
            here = next;
        }
        Some((here.at - turning.place.at).abs())
    }

    /// Returns the extremum `hop` places after or before another, cyclic for a periodic motion.
    fn hop(&self, about: usize, hop: usize, forwards: bool, range: Range) -> Option<FigurePlace> {
        let count = self.turnings.len();
        let (index, rounds) = match forwards {
            true => ((about + hop) % count, ((about + hop) / count) as f64),
            false => {
                let back = (count + about - hop % count) % count;
                let rounds = if back + hop > about { 1.0 } else { 0.0 };
                (back, -rounds)
            }
        };
        let place = self.turnings[index].place;
        match range {
            Range::Full { period } => Some(FigurePlace {
                at: place.at + period * rounds,
                ..place
            }),
            Range::Limited { .. } => (rounds == 0.0).then_some(place),
        }
    }
}

/// Returns the driver's travel that two dwells share, the longer one last.
fn shared(dwell: &DwellStretch, longer: &DwellStretch, period: Option<f64>) -> f64 {
    let common =
        |shift: f64| (dwell.to + shift).min(longer.to) - (dwell.from + shift).max(longer.from);
    let Some(period) = period else {
        return common(0.0).max(0.0);
    };
    // In a periodic motion a dwell may overlap the longer one twice: from before its beginning, and
    // before its end.
    let near = period * ((longer.from - dwell.from) / period).floor();
    let shifts = [near, near + period];
    shifts.into_iter().map(|by| common(by).max(0.0)).sum()
}

/// Finds the coordinate where a quantity passes a value between two neighbouring extrema.
fn crossing(
    [a, b]: [FigurePlace; 2],
    value: f64,
    sampler: &mut MotionSampler,
    (column, sampled): (usize, &SampledFigure),
) -> Option<f64> {
    let nearby = 0.5 * (a.value + b.value);
    let finest = f64::EPSILON * (b.at - a.at).abs();
    let [a, b] = narrowed([a, b], value, sampler.range(), sampled);
    let off = |at| Some(sampler.value_near(column, at, nearby) - value);
    let ends = [a, b].map(|place| (place.at, place.value - value));
    root(ends[0], ends[1], finest, off).ok()
}

/// Narrows the part between two neighbouring extrema, in which a quantity passes a value, to about the
/// distance of two samples.
fn narrowed(
    [mut a, mut b]: [FigurePlace; 2],
    value: f64,
    range: Range,
    sampled: &SampledFigure,
) -> [FigurePlace; 2] {
    let first = sampled.at[0];
    loop {
        let middle = f64::midpoint(a.at, b.at);
        let rounds = match range {
            Range::Full { period } => period * ((middle - first) / period).floor(),
            Range::Limited { .. } => 0.0,
        };
        let next = sampled.at.partition_point(|at| at + rounds < middle);
        let Some(&at) = sampled.at.get(next) else {
            return [a, b];
        };
        let place = FigurePlace {
            at: at + rounds,
            value: sampled.by_degree[0][next],
        };
        let is_between = (place.at - a.at) * (place.at - b.at) < 0.0;
        if !is_between || !place.value.is_finite() {
            return [a, b];
        }
        if (place.value > value) == (a.value > value) {
            a = place;
        } else {
            b = place;
        }
    }
}
