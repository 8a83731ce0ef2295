//! Evaluates quantities at any place of the motion: samples, slopes and jumps between samples.

use super::super::clock::Clock;
use super::super::{Hidden, Quantity, demand};
use super::span::usual;
use crate::angle::{self, TURN, unwrap_near};
use crate::solver::{Condition, Order, Range, Solver, Workspace};
use crate::{DriverMoment, Input, LANES, Lanes};
use std::collections::HashMap;

/// Maximum change between two samples without an examination for a jump, relative to the curve's
/// range.
const MAX_SMOOTH_CHANGE: f64 = 0.2;
/// Number of bisections that distinguish a jump from a steep slope: down to a millionth of the
/// distance of two samples.
const HALVINGS: u32 = 20;
/// A relative change of the values below this is rounding error of their inputs.
const ROUNDING: f64 = 1e-11;
/// Factor of the error bound above which a change counts as real.
const MIN_REAL_CHANGE: f64 = 4.0;
/// Number of places at which error bounds are computed to decide this.
const BOUND_SAMPLES: usize = 16;

/// Evaluates quantities at any place of the motion, given as a coordinate or a time.
pub(super) struct Probe {
    solver: Solver,
    order: Order,
    columns: Vec<Quantity>,
    range: Range,
    clock: Option<Clock>,
    state: Workspace,
    lanes: Workspace<Lanes>,
    /// A solver for slopes over the place: with a speed of 1 for a coordinate, with the scene's for
    /// a time.
    slopes: (Solver, Workspace),
    /// The reason why values are not shown, at the first sample where some are not.
    pub(super) hidden: Option<Hidden>,
    /// The error bounds of all columns at a place, by the bits of its number.
    bounds: HashMap<u64, Vec<Option<f64>>>,
}

impl Probe {
    pub(super) fn new(
        solver: &Solver,
        columns: &[Quantity],
        range: Range,
        clock: Option<Clock>,
    ) -> Self {
        let (wanted, order) = demand(columns);
        let solver = solver.only(&wanted);
        let slopes = match clock {
            Some(_) => solver.clone(),
            None => solver.at_speed(1.0, 0.0),
        };
        Probe {
            order,
            columns: columns.to_vec(),
            range,
            clock,
            state: solver.state(),
            lanes: solver.lanes(),
            slopes: (slopes.clone(), slopes.state()),
            hidden: None,
            bounds: HashMap::new(),
            solver,
        }
    }

    /// Returns a probe for some of the columns, which solves only what they depend on.
    pub(super) fn of_columns(&self, columns: std::ops::Range<usize>) -> Probe {
        let columns = &self.columns[columns];
        Probe::new(&self.solver, columns, self.range, self.clock.clone())
    }

    /// Returns the driver's coordinate at a place. Rounding moves it neither beyond a limit nor
    /// slightly inside it.
    pub(super) fn coordinate(&self, place: f64) -> f64 {
        match &self.clock {
            None => place,
            Some(clock) => clock.moment(place, self.range).at,
        }
    }

    /// Returns the moment of a driver of varying speed.
    fn moment(&self, place: f64) -> Option<DriverMoment> {
        let uneven = self.clock.as_ref().filter(|clock| !clock.is_even())?;
        Some(uneven.moment(place, self.range))
    }

    fn solve(&mut self, place: f64) -> Condition {
        let at = self.coordinate(place);
        if let Some(moment) = self.moment(place) {
            self.solver.drive(&mut self.state, &moment);
        }
        self.solver.solve(at, self.order, &mut self.state)
    }

    pub(super) fn value(&mut self, column: usize, place: f64) -> Option<f64> {
        let _ = self.solve(place);
        self.columns[column].value(&self.state)
    }

    /// Returns the slope of a column over the place, up to a constant factor; `None` if it does not
    /// exist or no rate is known.
    pub(super) fn slope(&mut self, column: usize, place: f64) -> Option<f64> {
        let rate = self.columns[column].rate()?;
        let (at, moment) = (self.coordinate(place), self.moment(place));
        let (solver, state) = &mut self.slopes;
        if let Some(moment) = moment {
            solver.drive(state, &moment);
        }
        let _ = solver.solve(at, rate.order(), state);
        rate.value(state)
    }

    /// Evaluates every column at these places, with the conditions of the states.
    pub(super) fn sample(
        &mut self,
        coordinates: &[f64],
    ) -> (Vec<Vec<Option<f64>>>, Vec<Condition>) {
        let mut columns = vec![Vec::with_capacity(coordinates.len()); self.columns.len()];
        let mut conditions = Vec::with_capacity(coordinates.len());
        for block in coordinates.chunks(LANES) {
            if self.sample_at_once(block, &mut columns) {
                conditions.extend(block.iter().map(|_| Condition::Ok));
                continue;
            }
            for &place in block {
                conditions.push(self.solve(place));
                if self.hidden.is_none() {
                    self.hidden = Hidden::of(&self.columns, &self.state);
                }
                for (quantity, values) in self.columns.iter().zip(&mut columns) {
                    values.push(quantity.value(&self.state));
                }
            }
        }
        (columns, conditions)
    }

    /// Evaluates all places at once in lanes. Returns `false`, without adding values, if that is
    /// impossible.
    fn sample_at_once(&mut self, block: &[f64], columns: &mut [Vec<Option<f64>>]) -> bool {
        let Some(&last) = block.last().filter(|&&p| self.moment(p).is_none()) else {
            return false;
        };
        let mut at = [self.coordinate(last); LANES];
        for (at, &place) in at.iter_mut().zip(block) {
            *at = self.coordinate(place);
        }
        if !self.solver.solve_lanes(at, self.order, &mut self.lanes) {
            return false;
        }
        // If one lane has no value, the lanes have none: then each place is evaluated separately.
        let read = |quantity: &Quantity| quantity.value(&self.lanes);
        let Some(read) = self.columns.iter().map(read).collect::<Option<Vec<_>>>() else {
            return false;
        };
        for (lanes, values) in read.into_iter().zip(columns) {
            values.extend(lanes.0[..block.len()].iter().map(|&v| Some(v)));
        }
        true
    }

    /// Returns whether a column jumps behind each sample.
    pub(super) fn breaks(
        &mut self,
        column: usize,
        coordinates: &[f64],
        values: &[Option<f64>],
    ) -> Vec<bool> {
        let wraps = self.columns[column].is_direction();
        let size = usual(values).map_or(0.0, |(low, high)| high - low);
        let pairs = values.windows(2).zip(coordinates.windows(2));
        pairs
            .map(|(pair, ends)| {
                let [Some(a), Some(b)] = [pair[0], pair[1]] else {
                    return false;
                };
                let change = (b - a).abs();
                let ends = [ends[0], ends[1]];
                (wraps && change > TURN / 2.0)
                    || ((change > MAX_SMOOTH_CHANGE * size || self.is_jump_of_load(column, ends))
                        && self.jumps(column, ends, [a, b]))
            })
            .collect()
    }

    /// Returns `true` if a load jumps between two places and the column depends on forces.
    fn is_jump_of_load(&self, column: usize, ends: [f64; 2]) -> bool {
        if self.columns[column].order() != Order::Force {
            return false;
        }
        let mechanism = self.solver.mechanism();
        let is_rotary = matches!(mechanism.driver().input, Input::Turn(_));
        let [a, b] = ends.map(|place| self.coordinate(place));
        let mut profiles = mechanism.loads().iter().filter_map(|load| load.over());
        profiles.any(|over| over.jumps_between(a.min(b), a.max(b), is_rotary))
    }

    /// Returns `true` if the change between two places does not decrease as they approach each
    /// other.
    pub(super) fn jumps(
        &mut self,
        column: usize,
        mut places: [f64; 2],
        mut values: [f64; 2],
    ) -> bool {
        let complete = (values[1] - values[0]).abs();
        for _ in 0..HALVINGS {
            let middle = 0.5 * (places[0] + places[1]);
            let Some(value) = self.value(column, middle) else {
                return true;
            };
            let end = usize::from((value - values[0]).abs() > (values[1] - value).abs());
            (places[end], values[end]) = (middle, value);
            if (values[1] - values[0]).abs() < 0.5 * complete {
                return false;
            }
        }
        // A smaller change may be rounding error.
        complete > ROUNDING * values[0].abs().max(values[1].abs())
    }

    /// Returns the constant value of a column, if it changes by no more than its own error bound,
    /// so that one value is within all bounds. A value that may be 0 becomes 0.
    pub(super) fn level(
        &mut self,
        column: usize,
        coordinates: &[f64],
        values: &[Option<f64>],
        conditions: &[Condition],
    ) -> Option<f64> {
        // At a dead point, a value is accurate only to the square root of a rounding error.
        let reliable = values.iter().zip(conditions).enumerate();
        let reliable = reliable.filter(|(_, (_, condition))| **condition != Condition::DeadPoint);
        let mut reliable: Vec<(usize, f64)> = reliable
            .filter_map(|(i, (v, _))| Some((i, (*v)?)))
            .collect();
        let mut level = reliable.first()?.1;
        if self.columns[column].is_direction() {
            level = unwrap_near(0.0, level);
            reliable
                .iter_mut()
                .for_each(|(_, v)| *v = unwrap_near(level, *v));
        }
        let by_value = |a: &&(usize, f64), b: &&(usize, f64)| a.1.total_cmp(&b.1);
        let ends = [
            reliable.iter().min_by(by_value)?,
            reliable.iter().max_by(by_value)?,
        ];
        let size = ends[0].1.abs().max(ends[1].1.abs());
        let (mut minimum, mut maximum, mut proved) = (f64::NEG_INFINITY, f64::INFINITY, 0);
        if ends[1].1 - ends[0].1 > ROUNDING * size {
            // These places first: the columns share them, and they suffice for most.
            let spread = reliable
                .iter()
                .step_by(reliable.len().div_ceil(BOUND_SAMPLES));
            for &(sample, value) in spread.chain(ends) {
                let Some(bound) = self.bound(column, coordinates[sample]) else {
                    continue;
                };
                minimum = minimum.max(value - MIN_REAL_CHANGE * bound);
                maximum = maximum.min(value + MIN_REAL_CHANGE * bound);
                if minimum > maximum {
                    return None;
                }
                proved += 1;
            }
            if proved < BOUND_SAMPLES / 2 {
                return None;
            }
            if (minimum..=maximum).contains(&0.0) {
                level = 0.0;
            }
        }
        Some(if self.columns[column].is_direction() {
            angle::wrapped(level)
        } else {
            level
        })
    }

    /// Returns a bound on the error of a column at a place, if one can be proved.
    fn bound(&mut self, column: usize, place: f64) -> Option<f64> {
        if let Some(bounds) = self.bounds.get(&place.to_bits()) {
            return bounds[column];
        }
        let _ = self.solve(place);
        let mut enclosure = self.solver.enclosure();
        if let Some(moment) = self.moment(place) {
            self.solver.drive(&mut enclosure, &moment);
        }
        self.solver
            .enclose(&mut self.state, self.order, &mut enclosure);
        let columns = self.columns.iter();
        let bounds = columns.map(|column| column.bound(&self.state, &enclosure));
        self.bounds
            .entry(place.to_bits())
            .or_insert(bounds.collect())[column]
    }
}
