//! Finds the stops of a mechanism: the coordinates at which the motion meets the end of a limit.
//!
//! The motion is first followed without stops. A limit of the driver's own coordinate then cuts the
//! range directly. Any other limited coordinate is followed from the opening coordinate in both
//! directions. The first place at which it leaves its limit is found to the last digit of the
//! driver's coordinate.
//!
//! The tracked motion has samples a degree of a crank apart, or less. Between two of them the
//! clearance of a coordinate x from a stop is at least the smaller clearance at the ends minus M
//! h^2 / 8. Here h is the driver's displacement and M a bound of the second derivative. M is taken
//! as twice the largest value observed at the ends. If that does not decide, the interval is
//! halved, down to neighbouring doubles. A violation is therefore missed only if x bends there and
//! back more than twice as much as at both ends.

use super::exact::Exact;
use super::exact::proved_run::ProvedRun;
use super::motion::{EndStop, sign_change};
use super::state::{Condition, State};
use super::{Demand, Fault, Order, Range, Solver, Workspace};
use crate::arithmetic::{half_ulp, typed_radius};
use crate::numeric::root;
use crate::{Body, Double, Input, LimitId, LimitOf, Number, StrokeEnd, Vec2, angle};
use std::f64::consts::TAU;

/// The amount by which a coordinate may pass its stop and count as touching it: rounding error,
/// relative to its size, in radians or scaled lengths.
const STOP_OVERSHOOT: f64 = 1e-13;
/// Factor by which the second derivative inside an interval may exceed its values at both ends.
const SECOND_DERIVATIVE_FACTOR: f64 = 2.0;
/// Number of halvings from a degree down to neighbouring doubles, with a margin.
const MAX_HALVINGS: u32 = 80;
/// Number of doublings of an ulp within which double-double searches for a stop found in doubles.
const DOUBLINGS: i32 = 40;
/// Maximum distance of a stop from an end of the motion, in roundings of the coordinate, at which
/// the two count as the same end.
const STOP_TOLERANCE: f64 = 4.0;

/// The stops that end the motion: downwards, and upwards.
pub(super) type EndStops = [Option<EndStop>; 2];

impl Solver {
    /// Restricts the motion to the range between the stops of the mechanism.
    ///
    /// # Errors
    /// If the scene opens beyond a stop, or if two stops leave no motion.
    pub(super) fn between_stops(mut self) -> Result<Solver, Fault> {
        let mut stops: EndStops = [None, None];
        for id in self.mechanism.limit_ids() {
            let of = self.mechanism.limit(id).of;
            let found = if self.is_driven(of) {
                self.driver_stops(id)?
            } else {
                LimitWatch::new(&self, id, of).stops()?
            };
            for ((stop, found), sense) in stops.iter_mut().zip(found).zip([-1.0, 1.0]) {
                let is_first =
                    |found: &EndStop| stop.is_none_or(|stop| (found.at - stop.at) * sense < 0.0);
                *stop = found.filter(is_first).or(*stop);
            }
        }
        if let [Some(down), Some(up)] = stops
            && down.at >= up.at
        {
            let [down, up] = [down.limit, up.limit];
            return Err(Fault::HeldByStops { down, up });
        }
        self.motion.stop(stops, self.opening);
        Ok(self)
    }

    /// Returns `true` if a limit applies to the driver's own coordinate, under any of its names.
    fn is_driven(&self, of: LimitOf) -> bool {
        match (of, self.mechanism.driver().input) {
            (LimitOf::Driver | LimitOf::Table(_), _) => true,
            (LimitOf::Slide(slide), Input::Push(driven)) => slide == driven,
            (LimitOf::Angle { link, from }, Input::Turn(driven)) => {
                link == driven && from == self.mechanism.turned_from(driven)
            }
            (LimitOf::Slide(_), Input::Turn(_)) | (LimitOf::Angle { .. }, Input::Push(_)) => false,
        }
    }

    /// Returns the ends of a limit of the driver's own coordinate, if the motion reaches them.
    fn driver_stops(&self, id: LimitId) -> Result<EndStops, Fault> {
        let limit = self.mechanism.limit(id);
        let at = self.opening;
        // A table's limits are not moved by whole turns.
        let is_table = matches!(limit.of, LimitOf::Table(_));
        let by = match self.engine.is_rotary && !is_table {
            true => angle::TURN * turns_between(at, [limit.low, limit.high], angle::TURN),
            false => 0.0,
        };
        let [low, high] = [limit.low, limit.high].map(|end| end + by);
        if !(low <= at && at <= high) {
            return Err(Fault::BeyondStop {
                limit: id,
                value: at,
            });
        }
        let is_met = |end: f64| match self.motion.range {
            Range::Full { .. } => true,
            Range::Limited { low, high } => low <= end && end <= high,
        };
        let turned = |at: f64| if by == 0.0 { 0.0 } else { half_ulp(at) };
        let stop = |at: f64, typed: f64, end| {
            let bound = Some(typed_radius(typed) + turned(at));
            is_met(at).then_some(EndStop {
                limit: id,
                end,
                at,
                bound,
            })
        };
        Ok([
            stop(low, limit.low, StrokeEnd::Minimum),
            stop(high, limit.high, StrokeEnd::Maximum),
        ])
    }

    /// Returns the samples of the motion from the opening coordinate to the end of the motion or of
    /// the period, in the direction `sense`.
    fn way(&self, sense: f64) -> Vec<f64> {
        let start = self.opening;
        let (end, shift) = match self.motion.range {
            Range::Full { period } => (start + sense * period, (1.0 - sense) / 2.0 * period),
            Range::Limited { low, high } => (if sense > 0.0 { high } else { low }, 0.0),
        };
        let on_the_way = |&at: &f64| (at - start) * sense > 0.0 && (end - at) * sense > 0.0;
        let samples = self.motion.samples.iter().map(|at| at - shift);
        let mut way: Vec<f64> = samples.filter(on_the_way).collect();
        way.sort_by(|a, b| (a * sense).total_cmp(&(b * sense)));
        way.push(end);
        way
    }
}

/// Returns the smallest number of whole turns by which to move both ends, so that a value lies
/// between them. If that is impossible, returns the number that brings the ends nearest.
pub(super) fn turns_between(value: f64, [low, high]: [f64; 2], turn: f64) -> f64 {
    let minimum = ((value - high) / turn).ceil();
    let maximum = ((value - low) / turn).floor();
    if minimum <= maximum {
        0.0_f64.max(minimum).min(maximum)
    } else {
        ((value - 0.5 * (low + high)) / turn).round()
    }
}

/// A coordinate at one place, in radians or scaled lengths, and its derivatives by the driver's
/// coordinate if they exist.
#[derive(Clone, Copy, Debug)]
struct CoordinateSample {
    at: f64,
    value: f64,
    rates: Option<[f64; 2]>,
}

/// A state in double-double.
enum CloseState {
    /// A state computed by the formulas of dyads.
    Dyads(Box<State<Double>>),
    /// A state computed by corrections to the solution in doubles.
    Coupled(Box<Workspace<Double>>),
}

/// Follows the coordinate of a limit along the motion.
struct LimitWatch<'s> {
    whole: &'s Solver,
    solver: Solver,
    id: LimitId,
    of: LimitOf,
    workspace: Workspace,
    /// The ends, in radians or scaled lengths.
    ends: [f64; 2],
    touched: f64,
}

impl<'s> LimitWatch<'s> {
    fn new(complete: &'s Solver, id: LimitId, of: LimitOf) -> LimitWatch<'s> {
        let mut demand = Demand::default();
        let limit = complete.mechanism.limit(id);
        let mut ends = [limit.low, limit.high];
        match of {
            LimitOf::Driver | LimitOf::Table(_) => {}
            LimitOf::Slide(slide) => {
                demand.slides.push(slide);
                ends = ends.map(|end| complete.engine.frame.length(end));
            }
            LimitOf::Angle { link, from } => {
                demand.links.push(link);
                demand.links.extend(match from {
                    Body::Ground => None,
                    Body::Link(from) => Some(from),
                });
                ends = ends.map(angle::radians);
            }
        }
        let solver = complete.only(&demand);
        let size = ends.iter().fold(1.0_f64, |size, end| size.max(end.abs()));
        LimitWatch {
            workspace: solver.state(),
            touched: STOP_OVERSHOOT * size,
            whole: complete,
            solver,
            id,
            of,
            ends,
        }
    }

    /// Returns the stops at which the coordinate ends the motion in both directions.
    fn stops(&mut self) -> Result<EndStops, Fault> {
        let opening = self.whole.opening;
        let Some(mut start) = self.coordinate_at(opening, 0.0) else {
            return Ok([None, None]);
        };
        if let LimitOf::Angle { .. } = self.of {
            start.value -= TAU * turns_between(start.value, self.ends, TAU);
        }
        let is_beyond = |end| self.clearance(end, start.value) < -self.touched;
        if [StrokeEnd::Minimum, StrokeEnd::Maximum]
            .into_iter()
            .any(is_beyond)
        {
            let value = match self.of {
                LimitOf::Angle { .. } => start.value.to_degrees(),
                LimitOf::Driver | LimitOf::Table(_) | LimitOf::Slide(_) => {
                    start.value * self.solver.engine.frame.scale
                }
            };
            return Err(Fault::BeyondStop {
                limit: self.id,
                value,
            });
        }
        let up = self.first_stop(start, 1.0);
        let is_periodic = matches!(self.whole.motion.range, Range::Full { .. });
        let down = match up.is_none() && is_periodic {
            true => None,
            false => self.first_stop(start, -1.0),
        };
        Ok([down, up])
    }

    /// Returns the first stop upwards or downwards.
    fn first_stop(&mut self, start: CoordinateSample, sense: f64) -> Option<EndStop> {
        let mut from = start;
        for at in self.whole.way(sense) {
            let to = self.coordinate_at(at, from.value)?;
            let ends = [StrokeEnd::Minimum, StrokeEnd::Maximum];
            let found = ends.map(|end| Some((end, self.passed(end, from, to, MAX_HALVINGS)?)));
            let found = found.into_iter().flatten();
            let first =
                found.min_by(|(_, a), (_, b)| (a[0].at * sense).total_cmp(&(b[0].at * sense)));
            if let Some((end, [inside, outside])) = first {
                let at = self.end_between(end, inside, outside);
                let own = self.whole.motion.own_end(at, STOP_TOLERANCE);
                let (at, bound) = own.unwrap_or_else(|| (at, self.bound(end, at)));
                let limit = self.id;
                return Some(EndStop {
                    limit,
                    end,
                    at,
                    bound,
                });
            }
            from = to;
        }
        None
    }

    /// Returns two neighbouring places between which the coordinate first passes an end.
    fn passed(
        &mut self,
        end: StrokeEnd,
        from: CoordinateSample,
        to: CoordinateSample,
        halvings: u32,
    ) -> Option<[CoordinateSample; 2]> {
        let [a, b] = [from, to].map(|s| self.clearance(end, s.value));
        let h = self.solver.engine.difference(from.at, to.at).abs();
        if let (Some(first), Some(last)) = (from.rates, to.rates) {
            let bend = (last[0] - first[0]).abs() / h;
            let bend = SECOND_DERIVATIVE_FACTOR * bend.max(first[1].abs()).max(last[1].abs());
            if a.min(b) - bend * h * h / 8.0 >= -self.touched {
                return None;
            }
            // If the coordinate is monotonic, its value at the end decides.
            let goes_one_way =
                first[0].abs().min(last[0].abs()) > bend * h && first[0] * last[0] > 0.0;
            if goes_one_way && a.min(b) >= -self.touched {
                return None;
            }
            if goes_one_way && a >= -self.touched {
                return Some([from, to]);
            }
        }
        let at = from.at + 0.5 * (to.at - from.at);
        if halvings == 0 || at == from.at || at == to.at {
            return (b < -self.touched).then_some([from, to]);
        }
        let middle = self.coordinate_at(at, from.value)?;
        let first = self.passed(end, from, middle, halvings - 1);
        first.or_else(|| self.passed(end, middle, to, halvings - 1))
    }

    /// Returns how far inside an end a coordinate is.
    fn clearance(&self, end: StrokeEnd, value: f64) -> f64 {
        match end {
            StrokeEnd::Minimum => value - self.ends[0],
            StrokeEnd::Maximum => self.ends[1] - value,
        }
    }

    /// Evaluates the coordinate at a place. An angle is taken on the turn nearest to `near`.
    fn coordinate_at(&mut self, at: f64, near: f64) -> Option<CoordinateSample> {
        let condition = self
            .solver
            .solve(at, Order::Acceleration, &mut self.workspace);
        if condition == Condition::NoAssembly {
            return None;
        }
        let (value, rates) = match self.of {
            LimitOf::Driver | LimitOf::Table(_) => return None,
            LimitOf::Slide(slide) => {
                let travel = &self.workspace.travels[slide.index()];
                (travel.s, [travel.v, travel.a])
            }
            LimitOf::Angle { link, from } => {
                let (direction, rates) = relative_direction(&self.workspace, link, from);
                let value = direction.y.atan2(direction.x);
                (value + TAU * ((near - value) / TAU).round(), rates)
            }
        };
        let has_rates = condition != Condition::DeadPoint && rates.iter().all(|r| r.is_finite());
        let rates = has_rates.then_some(rates);
        Some(CoordinateSample { at, value, rates })
    }

    /// Returns the driver's coordinate at which an end is met, between two places close to each
    /// other.
    fn end_between(
        &mut self,
        end: StrokeEnd,
        inside: CoordinateSample,
        outside: CoordinateSample,
    ) -> f64 {
        let [a, b] = [inside, outside].map(|s| self.clearance(end, s.value));
        if a <= 0.0 {
            return inside.at;
        }
        let finest = self.solver.engine.finest();
        let found = root((inside.at, a), (outside.at, b), finest, |at| {
            let sighting = self.coordinate_at(at, inside.value)?;
            Some(self.clearance(end, sighting.value))
        });
        let found = found.unwrap_or(inside.at);
        self.sharpened(end, found, [inside.at, outside.at])
            .unwrap_or(found)
    }

    /// Returns the double nearest to the coordinate at which an end is met, by double-double
    /// evaluation of the typed decimals; `None` if a series contributes to it.
    fn sharpened(
        &mut self,
        end: StrokeEnd,
        found: f64,
        [inside, outside]: [f64; 2],
    ) -> Option<f64> {
        let exact = self.solver.exact.clone()?;
        if self.solver.is_passing(found) {
            return None;
        }
        let mut close = match exact.closed == exact.engine.program.steps.len() {
            true => CloseState::Dyads(Box::new(exact.state(self.solver.slides))),
            false => CloseState::Coupled(Box::new(self.solver.twice())),
        };
        let ulp = self.solver.engine.finest().max(f64::EPSILON * found.abs());
        let sense = (outside - inside).signum();
        let (low, high) = (inside.min(outside), inside.max(outside));
        let mut clearance = |at: f64| self.exactly(&exact, end, at, &mut close);
        let mut distance = |sense: f64, wanted: fn(Double) -> bool| {
            let places = (0..DOUBLINGS).map(|k| found + sense * ulp * (f64::from(k).exp2() - 1.0));
            let places = places.map(|at| at.clamp(low, high));
            let mut text = places.map(|at| Some((at, clearance(at)?)));
            text.find_map(|text| text.filter(|(_, c)| wanted(*c)))
        };
        let mut good = distance(-sense, |c| c.hi >= 0.0)?;
        let mut bad = distance(sense, |c| c.hi < 0.0)?;
        loop {
            let at = good.0 + 0.5 * (bad.0 - good.0);
            if at == good.0 || at == bad.0 || (bad.0 - good.0).abs() < f64::EPSILON * ulp {
                break;
            }
            let here = (at, clearance(at)?);
            *(if here.1.hi < 0.0 { &mut bad } else { &mut good }) = here;
        }
        let nearest = if good.1.hi <= -bad.1.hi {
            good.0
        } else {
            bad.0
        };
        Some(if nearest.abs() < f64::EPSILON * ulp {
            0.0
        } else {
            nearest
        })
    }

    /// Computes in double-double how far inside an end the coordinate is; for an angle the sine of
    /// that.
    fn exactly(
        &mut self,
        exact: &Exact,
        end: StrokeEnd,
        at: f64,
        close: &mut CloseState,
    ) -> Option<Double> {
        let order = Order::Position;
        let close: &State<Double> = match close {
            CloseState::Dyads(close) => {
                self.solver.aim(at, &mut self.workspace);
                let how = (
                    &self.workspace.state.signs[..],
                    self.solver.motion.stretched_at(at),
                );
                let requested = Double::exactly(at);
                let condition = exact.run(exact.closed, requested, order, how, close);
                (condition != Condition::NoAssembly).then_some(&**close)
            }
            CloseState::Coupled(close) => {
                let _ = self.solver.solve(at, order, &mut self.workspace);
                let is_solved = self.solver.solve_twice(&self.workspace.state, order, close);
                is_solved.then_some(&close.state)
            }
        }?;
        self.inside(exact, end, close)
    }

    /// Computes how far inside an end the coordinate is in a state; for an angle the sine of that.
    fn inside<T: Number>(&self, exact: &Exact, end: StrokeEnd, state: &State<T>) -> Option<T> {
        let limit = self.whole.mechanism.limit(self.id);
        let (value, sign) = match end {
            StrokeEnd::Minimum => (limit.low, 1.0),
            StrokeEnd::Maximum => (limit.high, -1.0),
        };
        let frame = &exact.engine.frame;
        let inside = match self.of {
            LimitOf::Driver | LimitOf::Table(_) => return None,
            LimitOf::Slide(slide) => {
                let end = T::of(frame.local(Vec2::new(value, 0.0)).x);
                state.travels[slide.index()].s - end
            }
            LimitOf::Angle { link, from } => {
                let end = Vec2::<T>::of(frame.unit(value));
                end.cross(relative_direction(state, link, from).0)
            }
        };
        Some(T::exactly(sign) * inside)
    }

    /// Bounds the error of the driver's coordinate at which an end is met.
    fn bound(&mut self, end: StrokeEnd, at: f64) -> Option<f64> {
        let exact = self.solver.exact.clone()?;
        if self.solver.is_passing(at) {
            return None;
        }
        let _ = self.solver.solve(at, Order::Position, &mut self.workspace);
        self.solver.aim(at, &mut self.workspace);
        let steps = exact.engine.program.steps.len();
        // Far from the origin, typed decimals and the doubles next to them have different
        // solutions.
        let order = Order::Position;
        let _ = exact
            .engine
            .run_steps(0..steps, at, order, &mut self.workspace);
        let mut run = ProvedRun::new(&exact, self.solver.slides);
        sign_change(&self.solver.engine, at, |place| {
            let is_proved = run.run(steps, place, false, &self.workspace.state);
            is_proved.then(|| self.inside(&exact, end, &run.sharp.state))?
        })
    }
}

/// Returns the direction of a link relative to a body, and the derivatives of its angle.
fn relative_direction<T: Number>(
    state: &State<T>,
    link: crate::LinkId,
    from: Body,
) -> (Vec2<T>, [T; 2]) {
    let link = &state.links[link.index()];
    match from {
        Body::Ground => (link.d, [link.w, link.a]),
        Body::Link(from) => {
            let from = &state.links[from.index()];
            (
                link.d.turned(from.d.conj()),
                [link.w - from.w, link.a - from.a],
            )
        }
    }
}
