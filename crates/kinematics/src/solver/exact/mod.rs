//! Evaluates a mechanism with its typed decimals instead of the doubles next to them.
//!
//! This engine decides in double-double where doubles cannot: whether lengths are equal, on which
//! side of an end a coordinate lies, and how far a dyad is from its limit.

pub(super) mod double_double_reference;
pub(super) mod edge;
pub(super) mod proved_run;

use super::elements::{ACCELERATION, POSITION, Step, StepOutcome, VELOCITY};
use super::engine::Engine;
use super::plan::network::Network;
use super::plan::order::Ordering;
use super::state::{Condition, State};
use super::{Demand, Order, chain};
use crate::{Double, Number};

/// The uncertainty of an equality in double-double, in units of about the longest link.
const FLOOR: f64 = 1e-25;

/// The mechanism with its typed decimals.
#[derive(Clone, Debug)]
pub(super) struct Exact {
    pub(super) engine: Engine,
    /// By how much equal lengths can differ because the coordinates of two places on the ground or
    /// on a link were rounded, in the solver's unit. Numbers of 15 digits or more count as rounded.
    pub(super) rounding: f64,
    /// The same limit for any number of the mechanism, including lengths and guides on links.
    typed: f64,
    /// The number of steps before the first coupled group. These have a closed form.
    pub(super) closed: usize,
}

impl Exact {
    /// Creates the exact engine of a mechanism; `None` if its typed decimals lead to other groups.
    pub(super) fn new(
        engine: &Engine,
        network: &Network<'_>,
        ordering: &Ordering,
    ) -> Option<Exact> {
        let mechanism = network.mechanism;
        let frame = engine.frame.with_typed_decimals(mechanism);
        let network = Network::new(mechanism, frame);
        let (_, program) = chain::build(&network, ordering, chain::Dyads::Closed).ok()?;
        let rounding = frame.rounding(mechanism);
        let mut exact = Engine::new(mechanism, frame, program);
        let steps = &mut exact.program.steps;
        if steps.len() != engine.program.steps.len() {
            return None;
        }
        for (step, of) in steps.iter_mut().zip(&engine.program.steps) {
            // If two arms are equal except for rounding, both engines must choose the same one as
            // the nearer.
            if let (Step::Circles(circles), Step::Circles(of)) = (step, of) {
                circles.measure_from(of.near.pivot);
            }
        }
        Some(Exact {
            rounding,
            typed: frame.typed_rounding(mechanism).max(rounding),
            closed: closed(&exact),
            engine: exact,
        })
    }

    /// Returns the maximum difference of lengths that count as equal.
    pub(super) fn slack(&self) -> f64 {
        self.rounding + FLOOR
    }

    /// Returns the maximum error of any number of the mechanism: those of 15 digits or more are
    /// rounded.
    pub(super) fn typed_slack(&self) -> f64 {
        self.typed + FLOOR
    }

    /// Returns `true` if double-double decides more about the first steps than doubles do. If
    /// lengths count as equal within the rounding of coordinates, more digits do not help.
    pub(super) fn decides_more(&self, steps: usize) -> bool {
        steps <= self.closed && self.rounding == 0.0
    }

    /// Creates a state in any arithmetic.
    pub(super) fn state<T: Number>(&self, slides: usize) -> State<T> {
        self.engine.state(slides).into_state()
    }

    /// Runs the first `steps` steps with these signs. The dyad of the group `ending` is placed at
    /// its limit. So is a dyad for which this arithmetic cannot decide on which side of its limit
    /// it is.
    pub(super) fn run<T: Number>(
        &self,
        steps: usize,
        at: T,
        order: Order,
        (signs, ending): (&[f64], Option<usize>),
        state: &mut State<T>,
    ) -> Condition {
        for (sign, &of) in state.signs.iter_mut().zip(signs) {
            *sign = T::exactly(of);
        }
        let order = match order {
            Order::Position => POSITION,
            Order::Velocity => VELOCITY,
            Order::Acceleration | Order::Force => ACCELERATION,
        };
        let (q, direction) = self.engine.coordinate(at);
        let mut condition = Condition::Ok;
        for step in &self.engine.program.steps[..steps] {
            let mut outcome = step.run_to(order, (q, direction), state);
            if let Some(dyad) = step.dyad() {
                if ending == Some(dyad.group()) {
                    dyad.align(q, state);
                    outcome = StepOutcome::Stretched;
                } else if outcome == StepOutcome::Unclear {
                    outcome = dyad.stretch(q, state);
                }
            }
            match outcome {
                StepOutcome::Done => {}
                StepOutcome::Stretched => condition = Condition::DeadPoint,
                StepOutcome::Open | StepOutcome::Unclear => return Condition::NoAssembly,
            }
        }
        condition
    }

    /// Returns the first closed step that cannot be done at a coordinate, in double-double.
    pub(super) fn stops(&self, at: f64, state: &mut State<Double>) -> Option<usize> {
        let (q, direction) = self.engine.coordinate(Double::exactly(at));
        let mut steps = self.engine.program.steps[..self.closed].iter();
        steps.position(|step| step.run_to(POSITION, (q, direction), state) != StepOutcome::Done)
    }

    /// Returns a copy without the steps that `demand` does not need.
    pub(super) fn only(&self, demand: &Demand, slides: usize) -> Exact {
        let engine = self.engine.only(demand, slides);
        Exact {
            closed: closed(&engine),
            engine,
            ..*self
        }
    }
}

/// Returns the number of steps before the first coupled group.
fn closed(engine: &Engine) -> usize {
    let mut steps = engine.program.steps.iter();
    let first = steps.position(|step| step.coupled().is_some());
    first.unwrap_or(engine.program.steps.len())
}
