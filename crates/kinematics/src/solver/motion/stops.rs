//! Limits a motion by stops.
//!
//! The data about the whole motion remain: how the groups are solved, and at which coordinates.
//! Only the range becomes shorter, and results beyond it are not shown.

use super::{Motion, Range};
use crate::{LimitId, StrokeEnd};

/// A stop at which the motion ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndStop {
    /// The limit that the motion meets.
    pub limit: LimitId,
    /// The end of the limit that is met.
    pub end: StrokeEnd,
    /// The driver's coordinate at the stop, in degrees or in the scene's length unit.
    pub at: f64,
    /// The maximum error of the coordinate, in the same unit; `None` if it is not proved.
    pub bound: Option<f64>,
}

impl Motion {
    /// Limits the range to the given stops below and above `opening`, the coordinate at which the
    /// scene opens.
    pub(in crate::solver) fn stop(&mut self, [down, up]: [Option<EndStop>; 2], opening: f64) {
        if down.is_none() && up.is_none() {
            return;
        }
        let (first, last) = match self.whole {
            Range::Full { period } => (opening - period, opening + period),
            Range::Limited { low, high } => (low, high),
        };
        let low = down.map_or(first, |stop| stop.at);
        let high = up.map_or(last, |stop| stop.at);
        self.range = Range::Limited { low, high };
        for (bound, stop) in self.range_bounds.iter_mut().zip([down, up]) {
            *bound = stop.map_or(*bound, |stop| stop.bound);
        }
        self.stops = [down, up].into_iter().flatten().collect();
        self.dead_points.retain(|&at| at == low || at == high);
        self.meeting_assemblies
            .retain(|end| end.at == low || end.at == high);
        // A stop does not make the mechanism harder to solve.
        let [from, to] = self.clear;
        self.clear = [from.max(low.next_down()), to.min(high.next_up())];
        // One period of samples is enough if the range has several.
        let once = match self.whole {
            Range::Full { period } => high.min(low + period),
            Range::Limited { .. } => high,
        };
        self.samples = self.between(&self.samples, low, once);
        self.change_points = self.within(&self.change_points);
        let misses = std::mem::take(&mut self.near_misses);
        for miss in misses {
            let places = self.within(&[miss.at]).into_iter();
            self.near_misses
                .extend(places.map(|at| super::NearMiss { at, ..miss }));
        }
        self.near_misses.sort_by(|a, b| a.at.total_cmp(&b.at));
    }

    /// Returns the end of the range without stops, with its error bound, if a coordinate lies
    /// within some roundings of it.
    pub(in crate::solver) fn own_end(&self, at: f64, roundings: f64) -> Option<(f64, Option<f64>)> {
        let Range::Limited { low, high } = self.whole else {
            return None;
        };
        let buffers = roundings * self.finest.max(f64::EPSILON * at.abs());
        let mut ends = [low, high].into_iter().zip(self.range_bounds);
        ends.find(|(end, _)| (at - end).abs() <= buffers)
    }

    /// Returns the coordinates in the range that correspond to the given ones, repeated in every
    /// period.
    fn within(&self, coordinates: &[f64]) -> Vec<f64> {
        let (low, high) = self.range.ends();
        self.between(coordinates, low, high)
    }

    /// Returns the coordinates from `low` to `high` that correspond to the given ones, repeated in
    /// every period, sorted and without duplicates.
    fn between(&self, coordinates: &[f64], low: f64, high: f64) -> Vec<f64> {
        let mut found = Vec::new();
        for &at in coordinates {
            let (first, period) = match self.whole {
                Range::Full { period } => (at - period * ((at - low) / period).floor(), period),
                Range::Limited { .. } => (at, f64::INFINITY),
            };
            let mut place = first;
            while place <= high {
                // The quotient is rounded: the first may lie before the range.
                found.extend((low <= place).then_some(place));
                place += period;
            }
        }
        found.sort_by(f64::total_cmp);
        found.dedup();
        found
    }
}
