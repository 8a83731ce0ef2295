//! Samples quantities and their slopes by the driver's coordinate.

use crate::angle::{self, TURN, radians};
use crate::expression::DirectionCut;
use crate::quantity::{Quantity, demand};
use crate::solver::{Condition, Order, Range, Solver, Workspace};
use crate::study::motor::{load_bends, repeats};
use crate::{Driver, Input, LANES, Lanes, Mechanism};

/// Number of samples per turn, or over a limited range.
const PLACES: usize = 360;
/// Maximum number of samples of a motion that repeats after many turns.
const MAX_PLACES: usize = 36_000;
/// The distance from a limit at which rates are sampled, relative to the range. A limit may be a
/// dead point, which has no rates.
const INSIDE: f64 = 1e-9;
/// The distance from a possible jump of a load at which the quantity is sampled, relative to the
/// motion.
pub(super) const JUMP_DISTANCE: f64 = 1e-12;

/// The driver motion at which rates equal slopes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SlopeSource {
    /// Slopes of positions: rates at a speed of 1.
    Geometry,
    /// Slopes of velocities: rates at the scene's speed, without acceleration.
    Steady,
    /// Other quantities have no slopes.
    Nothing,
}

impl SlopeSource {
    pub(super) const ALL: [SlopeSource; 3] = [
        SlopeSource::Geometry,
        SlopeSource::Steady,
        SlopeSource::Nothing,
    ];

    pub(super) fn of(solver: &Solver, quantity: &Quantity) -> SlopeSource {
        match quantity.order() {
            Order::Position => SlopeSource::Geometry,
            Order::Velocity if solver.mechanism().driver().speed != 0.0 => SlopeSource::Steady,
            Order::Velocity | Order::Acceleration | Order::Force => SlopeSource::Nothing,
        }
    }
}

/// A quantity and its slope at one place; NaN if missing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FigureSample {
    pub(super) at: f64,
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// A quantity along the motion, and its slopes.
#[derive(Clone, Debug, Default)]
pub(super) struct SampledFigure {
    pub(super) at: Vec<f64>,
    /// By degree: the quantity, its slope and its second slope, as far as known; NaN if missing.
    pub(super) by_degree: Vec<Vec<f64>>,
}

/// A quantity and its rates.
#[derive(Clone)]
struct SlopedFigure {
    cut: DirectionCut,
    by_degree: Vec<Quantity>,
    /// The factors that convert each rate to a slope by the coordinate.
    factors: [f64; 3],
}

/// Evaluates quantities, one place at a time or in lanes.
pub(super) struct MotionSampler {
    solver: Solver,
    order: Order,
    columns: Vec<SlopedFigure>,
    state: Workspace,
    lanes: Workspace<Lanes>,
    /// The coordinate, order and condition of the state that was solved last.
    solved: Option<(f64, Order, Condition)>,
    source: SlopeSource,
    range: Range,
    /// Coordinates where a load has a kink or jumps, or where an input changes its relation to the
    /// driver.
    marks: Vec<f64>,
    /// The driver as in the scene.
    driver: Driver,
    reach: f64,
}

impl MotionSampler {
    pub(super) fn new<'q>(
        solver: &Solver,
        source: SlopeSource,
        quantities: impl Iterator<Item = &'q Quantity>,
        degree: usize,
    ) -> MotionSampler {
        let mechanism = solver.mechanism();
        let driver = mechanism.driver();
        let is_rotary = matches!(driver.input, Input::Turn(_));
        let speed = match source {
            SlopeSource::Geometry => 1.0,
            SlopeSource::Steady | SlopeSource::Nothing => driver.speed,
        };
        let pace = if is_rotary { speed.to_degrees() } else { speed };
        let highest = match source {
            SlopeSource::Geometry => degree,
            SlopeSource::Steady => degree.min(1),
            SlopeSource::Nothing => 0,
        };
        let columns = quantities.map(|quantity| SlopedFigure::new(quantity, highest, pace));
        let columns: Vec<SlopedFigure> = columns.collect();
        let (wanted, order) = demand(columns.iter().flat_map(|column| &column.by_degree));
        let (range, marks) = match order {
            Order::Force => loaded(solver),
            Order::Position | Order::Velocity | Order::Acceleration => {
                (solver.motion().range, Vec::new())
            }
        };
        let only = solver.only(&wanted);
        let solver = match source {
            SlopeSource::Geometry | SlopeSource::Steady => only.at_speed(speed, 0.0),
            SlopeSource::Nothing => only,
        };
        MotionSampler {
            order,
            columns,
            state: solver.state(),
            lanes: solver.lanes(),
            solved: None,
            source,
            marks: [marks, knots(mechanism, range)].concat(),
            range,
            driver: *driver,
            reach: mechanism.reach(),
            solver,
        }
    }

    /// Returns a sampler for some of the columns, which solves only what they depend on.
    pub(super) fn of_columns(&self, columns: std::ops::Range<usize>) -> MotionSampler {
        let columns = self.columns[columns].to_vec();
        let (wanted, _) = demand(columns.iter().flat_map(|column| &column.by_degree));
        let solver = self.solver.only(&wanted);
        MotionSampler {
            columns,
            state: solver.state(),
            lanes: solver.lanes(),
            solved: None,
            marks: self.marks.clone(),
            solver,
            ..*self
        }
    }

    /// Returns the range of the motion; for forces, as many periods of it as the loads need to
    /// repeat.
    pub(super) fn range(&self) -> Range {
        self.range
    }

    /// Returns the coordinate to solve for a place: a load that does not repeat restarts with the
    /// motion.
    fn coordinate(&self, at: f64) -> f64 {
        match (self.order, self.range) {
            (Order::Force, Range::Full { period }) => at.rem_euclid(period),
            _ => at,
        }
    }

    /// Returns the driver as in the scene.
    pub(super) fn driver(&self) -> &Driver {
        &self.driver
    }

    /// Returns the driver's time for a distance, in s; `None` if its speed is zero or not constant.
    pub(super) fn seconds(&self, travel: f64) -> Option<f64> {
        let driver = &self.driver;
        let travel = match driver.input {
            Input::Turn(_) => radians(travel),
            Input::Push(_) => travel,
        };
        let seconds = (travel / driver.speed).abs();
        (driver.acceleration == 0.0 && seconds.is_finite()).then_some(seconds)
    }

    /// Returns the coordinates where the motion passes close to a change point or a dead point.
    pub(super) fn near_misses(&self) -> Vec<f64> {
        let misses = self.solver.motion().near_misses.iter();
        misses.map(|miss| miss.at).collect()
    }

    pub(super) fn source(&self) -> SlopeSource {
        self.source
    }

    /// Returns the kind of jump of a quantity when a direction in it passes a full turn.
    pub(super) fn cut(&self, column: usize) -> DirectionCut {
        self.columns[column].cut
    }

    /// Returns the size of the values that a quantity is computed from, which scales its rounding
    /// error.
    pub(super) fn size(&self, column: usize) -> f64 {
        let quantity = &self.columns[column].by_degree[0];
        let size = match quantity.unit.as_str() {
            "deg" => TURN,
            unit if unit.starts_with("rad") => 1.0,
            _ => self.reach,
        };
        let speed = self.driver.speed.abs();
        match quantity.order() {
            Order::Position => size,
            Order::Velocity => size * speed,
            Order::Acceleration => size * speed * speed,
            Order::Force => 0.0,
        }
    }

    /// Returns the factor from a slope by the coordinate to the rate at a speed of 1.
    pub(super) fn unit_of_slope(&self, column: usize) -> f64 {
        let factor = self.columns[column].factors[1];
        let speed = match self.source {
            SlopeSource::Geometry => 1.0,
            SlopeSource::Steady | SlopeSource::Nothing => self.driver.speed,
        };
        1.0 / (factor * speed)
    }

    /// Returns the change of the coordinate in 1 s at a speed of 1.
    pub(super) fn coordinate_of_speed(&self) -> f64 {
        match self.driver.input {
            Input::Turn(_) => 1_f64.to_degrees(),
            Input::Push(_) => 1.0,
        }
    }

    /// Returns `true` if the slopes of a column are known.
    pub(super) fn has_slope(&self, column: usize) -> bool {
        self.columns[column].by_degree.len() > 1
    }

    /// Returns the value of a quantity.
    pub(super) fn value(&mut self, column: usize, at: f64) -> Option<f64> {
        self.degree(column, 0, at)
    }

    /// Returns a quantity (degree 0) or one of its slopes by the coordinate.
    pub(super) fn degree(&mut self, column: usize, degree: usize, at: f64) -> Option<f64> {
        let quantity = self.columns[column].by_degree.get(degree)?;
        let order = quantity.order();
        let condition = self.solve(at, order);
        let quantity = &self.columns[column].by_degree[degree];
        let exists = condition != Condition::NoAssembly;
        let value = exists.then(|| quantity.value(&self.state))??;
        Some(value * self.columns[column].factors[degree])
    }

    /// Solves at a place, unless the state is that of the place already.
    fn solve(&mut self, at: f64, order: Order) -> Condition {
        let at = self.coordinate(at);
        match self.solved {
            Some((known, up_to, condition))
                if known.to_bits() == at.to_bits() && order <= up_to =>
            {
                condition
            }
            _ => {
                let condition = self.solver.solve(at, order, &mut self.state);
                self.solved = Some((at, order, condition));
                condition
            }
        }
    }

    /// Returns a quantity with its slope; NaN if missing. A direction is unwrapped to the value
    /// nearest to a reference value.
    pub(super) fn sample(&mut self, column: usize, at: f64, nearby: f64) -> FigureSample {
        // The higher order first: its state serves both.
        let slope = self.degree(column, 1, at).unwrap_or(f64::NAN);
        let value = self.value_near(column, at, nearby);
        FigureSample { at, value, slope }
    }

    /// Returns a quantity as [`MotionSampler::sample`] does, without its slope.
    pub(super) fn value_near(&mut self, column: usize, at: f64, nearby: f64) -> f64 {
        let value = self.value(column, at).unwrap_or(f64::NAN);
        match self.cut(column) {
            DirectionCut::ByTurns => angle::unwrap_near(nearby, value),
            DirectionCut::Nowhere | DirectionCut::Otherwise => value,
        }
    }

    /// Returns `true` if the sampled values of a column differ by more than a part of their size, and
    /// `None` without values.
    pub(super) fn changes(
        &self,
        column: usize,
        sampled: &SampledFigure,
        part: f64,
    ) -> Option<bool> {
        let values = sampled.by_degree[0].iter().filter(|v| v.is_finite());
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        let [low, high] = values.fold(start, |[low, high], &v| [low.min(v), high.max(v)]);
        let size = self.size(column).max(low.abs()).max(high.abs());
        (high - low).is_finite().then_some(high - low > part * size)
    }

    /// Samples every column along the whole motion.
    pub(super) fn sample_motion(&mut self) -> Vec<SampledFigure> {
        self.along(&places(self.range, &self.marks))
    }

    /// Samples every column at a few places of the motion.
    pub(super) fn sample_few_places(&mut self) -> Vec<SampledFigure> {
        let coordinates = places(self.range, &self.marks);
        let distance = (coordinates.len() / LANES).max(1);
        let few: Vec<f64> = coordinates
            .into_iter()
            .step_by(distance)
            .take(LANES)
            .collect();
        self.along(&few)
    }

    /// Samples every column at some places in ascending order.
    fn along(&mut self, coordinates: &[f64]) -> Vec<SampledFigure> {
        let columns = self.columns.iter();
        let mut sampled: Vec<SampledFigure> = columns
            .map(|column| SampledFigure {
                at: coordinates.to_vec(),
                by_degree: vec![
                    Vec::with_capacity(coordinates.len() + LANES);
                    column.by_degree.len()
                ],
            })
            .collect();
        for block in coordinates.chunks(LANES) {
            if !self.block_in_lanes(block, &mut sampled) {
                block.iter().for_each(|&at| self.read(at, &mut sampled));
            }
        }
        for (column, sampled) in self.columns.iter().zip(&mut sampled) {
            if column.cut == DirectionCut::ByTurns {
                sampled.unwrap_turns();
            }
        }
        sampled
    }

    /// Samples all columns at one place.
    fn read(&mut self, at: f64, to: &mut [SampledFigure]) {
        let condition = self.solve(at, self.order);
        for (column, to) in self.columns.iter().zip(to) {
            let quantities = column.by_degree.iter().zip(column.factors);
            for ((quantity, factor), to) in quantities.zip(&mut to.by_degree) {
                let exists = condition != Condition::NoAssembly;
                let value = exists.then(|| quantity.value(&self.state)).flatten();
                to.push(value.map_or(f64::NAN, |value| value * factor));
            }
        }
    }

    /// Samples several places at once; returns `false` if that is impossible.
    fn block_in_lanes(&mut self, block: &[f64], to: &mut [SampledFigure]) -> bool {
        let Some(&last) = block.last() else {
            return true;
        };
        let mut at = [last; LANES];
        at[..block.len()].copy_from_slice(block);
        let at = at.map(|at| self.coordinate(at));
        if !self.solver.solve_lanes(at, self.order, &mut self.lanes) {
            return false;
        }
        let before = to.first().map_or(0, |to| to.by_degree[0].len());
        // A formula with a branch between the lanes has no value in all of them at once.
        let is_read = self.columns.iter().zip(&mut *to).all(|(column, to)| {
            let figures = column.by_degree.iter().zip(column.factors);
            figures
                .zip(&mut to.by_degree)
                .all(|((quantity, factor), to)| {
                    let lanes = quantity.value(&self.lanes);
                    let values = lanes.iter().flat_map(|lanes| &lanes.0[..block.len()]);
                    to.extend(values.map(|value| value * factor));
                    lanes.is_some()
                })
        });
        if !is_read {
            let all = to.iter_mut().flat_map(|to| &mut to.by_degree);
            all.for_each(|values| values.truncate(before));
        }
        is_read
    }
}

impl SlopedFigure {
    /// Creates the rates of a quantity; `pace` is the driver's speed in units of its coordinate at
    /// which the rates are read.
    fn new(quantity: &Quantity, highest: usize, pace: f64) -> SlopedFigure {
        let mut by_degree = vec![quantity.clone()];
        while by_degree.len() <= highest {
            let Some(rate) = by_degree.last().and_then(Quantity::rate) else {
                break;
            };
            by_degree.push(rate);
        }
        // Rates of degrees are in radians.
        let unit = if quantity.unit == "deg" {
            1_f64.to_degrees()
        } else {
            1.0
        };
        SlopedFigure {
            cut: quantity.cut(),
            by_degree,
            factors: [1.0, unit / pace, unit / (pace * pace)],
        }
    }
}

impl SampledFigure {
    /// Returns a sample with its slope.
    pub(super) fn sample(&self, k: usize) -> FigureSample {
        let slope = self.by_degree.get(1).map_or(f64::NAN, |slopes| slopes[k]);
        FigureSample {
            at: self.at[k],
            value: self.by_degree[0][k],
            slope,
        }
    }

    /// Unwraps a direction: removes its jumps by full turns.
    fn unwrap_turns(&mut self) {
        for k in 1..self.at.len() {
            let before = self.sample(k - 1);
            // The smaller slope: at a dead point the other one is unbounded.
            let slope = lesser(before.slope, self.sample(k).slope);
            let travel = slope * (self.at[k] - before.at);
            let expected = before.value + if travel.is_finite() { travel } else { 0.0 };
            let value = &mut self.by_degree[0][k];
            *value = angle::unwrap_near(expected, *value);
        }
    }

    /// Returns the number of full turns when the motion repeats; 0 for quantities that are not
    /// directions.
    pub(super) fn revolutions(&self, range: Range, cut: DirectionCut) -> f64 {
        let values = &self.by_degree[0];
        match (range, cut, values.first(), values.last()) {
            (Range::Full { .. }, DirectionCut::ByTurns, Some(first), Some(last)) => {
                ((last - first) / TURN).round() + 0.0
            }
            _ => 0.0,
        }
    }

    /// Returns the first place without a value, if there is one.
    pub(super) fn gap(&self) -> Option<f64> {
        let values = &self.by_degree[0];
        let missing = values.iter().position(|value| !value.is_finite())?;
        Some(self.at[missing])
    }

    /// Returns the largest absolute value.
    pub(super) fn max_abs(&self) -> f64 {
        let values = self.by_degree[0].iter().map(|value| value.abs());
        values.filter(|size| size.is_finite()).fold(0.0, f64::max)
    }

    /// Returns the mean distance between places.
    pub(super) fn step(&self) -> f64 {
        let last = self.at.len() - 1;
        (self.at[last] - self.at[0]) / last as f64
    }

    /// Returns the place before the first one of a periodic motion: the last but one, a period
    /// earlier.
    pub(super) fn before_first(&self) -> f64 {
        let last = self.at.len() - 1;
        self.at[0] - (self.at[last] - self.at[last - 1])
    }
}

/// Returns the argument with the smaller absolute value.
fn lesser(a: f64, b: f64) -> f64 {
    if a.abs() < b.abs() { a } else { b }
}

/// Returns the range after which the loads repeat too, and the coordinates where they have kinks or
/// jump, with both sides of each.
fn loaded(solver: &Solver) -> (Range, Vec<f64>) {
    let range = match solver.motion().range {
        Range::Full { period } => {
            let times = repeats(solver.mechanism(), Range::Full { period });
            Range::Full {
                period: period * f64::from(times.unwrap_or(1)),
            }
        }
        limited @ Range::Limited { .. } => limited,
    };
    let nearby = JUMP_DISTANCE * (range.ends().1 - range.ends().0);
    let bends = load_bends(solver, range);
    let sides = bends.iter().flat_map(|&at| [at - nearby, at, at + nearby]);
    (range, sides.collect())
}

/// Returns the knots of the tables by which inputs follow the driver.
fn knots(mechanism: &Mechanism, range: Range) -> Vec<f64> {
    let (low, high) = range.ends();
    let tables = mechanism.timed().iter().filter_map(|timed| timed.table());
    let knots = tables.flat_map(|table| {
        let period = table.period().unwrap_or(f64::INFINITY);
        let rounds = table.knots().iter().map(move |knot| (knot[0], period));
        rounds.flat_map(move |(at, period)| {
            let first = match period.is_finite() {
                true => at - period * ((at - low) / period).floor(),
                false => at,
            };
            let rounds = (0..u32::MAX)
                .map(move |k| first + if k == 0 { 0.0 } else { period * f64::from(k) });
            rounds.take_while(move |&at| at <= high)
        })
    });
    knots.collect()
}

/// Returns the places to sample, in ascending order: offset from round coordinates, where symmetry
/// puts extrema, plus the marks. The last place of a period is the first one of the next.
fn places(range: Range, marks: &[f64]) -> Vec<f64> {
    let mut coordinates: Vec<f64> = match range {
        Range::Full { period } => {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a number of turns, and not too many"
            )]
            let count = (PLACES * (period / TURN).round() as usize).clamp(PLACES, MAX_PLACES);
            let place = |k: usize| period * ((k as f64 + 0.5) / count as f64);
            let first = place(0);
            let marks = marks.iter().map(|at| match at.rem_euclid(period) {
                at if at < first => at + period,
                at => at,
            });
            (0..=count).map(place).chain(marks).collect()
        }
        Range::Limited { low, high } => {
            let inside = INSIDE * (high - low);
            let place = |k: usize| low + (high - low) * ((k as f64 + 0.5) / PLACES as f64);
            let between = (0..PLACES).map(place);
            let first = [low, low + inside].into_iter();
            let marks = marks.iter().copied().filter(|&at| low < at && at < high);
            let ends = [high - inside, high];
            first.chain(between).chain(ends).chain(marks).collect()
        }
    };
    coordinates.sort_by(f64::total_cmp);
    coordinates.dedup();
    coordinates
}
