//! Finds the plateaus of a quantity at its extrema.

use super::extrema::ExtremaSet;
use super::sampler::{MotionSampler, SampledFigure};
use super::{ExtremumPlace, FigurePlace};
use crate::solver::Range;

/// The relative difference below which two values are equal. The larger one applies without slopes:
/// forces depend on many quantities.
const EQUALITY_TOLERANCE: f64 = 8.0 * f64::EPSILON;
const FORCE_TOLERANCE: f64 = 1e-12;
/// The minimum length of a plateau, relative to the sampling step; shorter ones are smooth extrema.
const MIN_LEN: f64 = 0.1;
/// Bisections to find the end of a plateau.
const HALVINGS: u32 = 48;

impl ExtremaSet {
    /// Finds the plateau of every extremum, and moves the extremum to its beginning.
    pub(super) fn find_plateaus(
        &mut self,
        sampler: &mut MotionSampler,
        column: usize,
        sampled: &SampledFigure,
    ) {
        let same = match sampler.has_slope(column) {
            true => EQUALITY_TOLERANCE,
            false => FORCE_TOLERANCE,
        };
        let level = same * self.greatest.value.abs().max(self.least.value.abs());
        let shortest = MIN_LEN * sampled.step();
        let first = sampled.at[0];
        for turning in &mut self.places {
            let place = turning.place;
            // A longer plateau extends at least half of that to one side.
            let nearby = [-0.5, 0.5].map(|part| place.at + part * shortest);
            let mut stays_at = |at| {
                let value = sampler.value_near(column, at, place.value);
                (value - place.value).abs() <= level
            };
            if !nearby.into_iter().any(&mut stays_at) {
                continue;
            }
            let mut end = |forwards| stays(sampler, column, sampled, (place, forwards), level);
            let [back, on] = [end(false), end(true)];
            if on - back <= shortest {
                continue;
            }
            let from = match sampler.range() {
                Range::Full { period } if back < first => back + period,
                Range::Full { .. } | Range::Limited { .. } => back,
            };
            turning.place.at = from;
            turning.until = Some(from + (on - back));
            let extreme = match turning.is_peak {
                true => &mut self.greatest,
                false => &mut self.least,
            };
            if (extreme.value - place.value).abs() <= level {
                extreme.at = from;
            }
        }
        let by_place = |a: &ExtremumPlace, b: &ExtremumPlace| a.place.at.total_cmp(&b.place.at);
        self.places.sort_by(by_place);
    }
}

/// Returns the coordinate up to which a quantity stays at its value, forwards or backwards from a
/// place.
fn stays(
    sampler: &mut MotionSampler,
    column: usize,
    sampled: &SampledFigure,
    (place, forwards): (FigurePlace, bool),
    level: f64,
) -> f64 {
    let last = sampled.at.len() - 1;
    let period = match sampler.range() {
        Range::Full { period } => Some(period),
        Range::Limited { .. } => None,
    };
    let is_there = |value: f64| (value - place.value).abs() <= level;
    // The samples on this side in order; if the motion repeats, over one further period.
    let after = |k: &usize| match forwards {
        true => sampled.at[*k] > place.at,
        false => sampled.at[*k] < place.at,
    };
    let near = (0..=last).filter(after).map(|k| (k, 0.0));
    let travel = period.unwrap_or(0.0) * if forwards { 1.0 } else { -1.0 };
    let round = (0..=last).filter(|_| period.is_some()).map(|k| (k, travel));
    let mut samples: Vec<(usize, f64)> = near.collect();
    match forwards {
        true => samples.extend(round),
        false => {
            samples.reverse();
            let mut round: Vec<(usize, f64)> = round.collect();
            round.reverse();
            samples.extend(round);
        }
    }
    let mut inside = place.at;
    for (k, travel) in samples {
        let at = sampled.at[k] + travel;
        if is_there(sampled.by_degree[0][k]) {
            inside = at;
            continue;
        }
        let mut outside = at;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + outside);
            let value = sampler.value_near(column, middle, place.value);
            match is_there(value) {
                true => inside = middle,
                false => outside = middle,
            }
        }
        return inside;
    }
    inside
}
