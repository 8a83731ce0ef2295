//! Moves every input of a mechanism by itself, without opening the solver again.

pub(super) mod point_lead;

use super::chain;
use super::engine::Engine;
use super::forces::Balance;
use super::further_inputs::InputMotion;
use super::plan::network::Network;
use super::plan::{GroupId, Plan};
use super::state::{Condition, State};
use super::stops::turns_between;
use super::{Order, Solver, Workspace};
use crate::angle::{self, TURN};
use crate::{Body, Constant, Input, LimitOf, Mechanism, Number, Vec2};
use std::sync::Arc;

/// Maximum change of an input between two positions of a coupled group, which is solved from the
/// last one: an angle in degrees, or a length relative to the longest one.
const MAX_TURN: f64 = 2.0;
const MAX_PUSH: f64 = 0.02;
/// Maximum number of pieces into which a move is divided for a coupled group.
const MAX_PIECES: f64 = 4000.0;
/// Tolerance of a stop, relative to its size: rounding errors.
const STOP_OVERSHOOT: f64 = 1e-13;

/// The coordinate of an input with its first and second derivative by time, in degrees or in the
/// scene's length unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InputMoment {
    /// The coordinate.
    pub at: f64,
    /// The first derivative of the coordinate, per s.
    pub speed: f64,
    /// The second derivative of the coordinate, per s^2.
    pub acceleration: f64,
}

impl InputMoment {
    /// Returns the moment of an input at rest.
    #[must_use]
    pub fn at_rest(at: f64) -> InputMoment {
        InputMoment {
            at,
            ..InputMoment::default()
        }
    }
}

/// A mechanism in which every input moves by itself, created by [`Solver::free_inputs`].
///
/// Its states are those of a [`Solver`], with rates of all inputs. They have no error bounds. Dyads
/// keep their assembly; a coupled group takes the solution that continues the last kept one.
#[derive(Clone, Debug)]
pub struct FreeInputs {
    mechanism: Arc<Mechanism>,
    engine: Engine,
    plan: Arc<Plan>,
    balance: Option<Arc<Balance>>,
    workspace: Workspace,
    /// The last kept position: its inputs, and its state, from which coupled groups are solved.
    kept: (Vec<f64>, State),
}

impl Solver {
    /// Returns the mechanism with inputs that move by themselves, in the assembly of this solver
    /// where the scene opens. `None` if it has no assembly there, or in a solver made by
    /// [`Solver::only`] that leaves out steps.
    #[must_use]
    pub fn free_inputs(&self) -> Option<FreeInputs> {
        let mechanism = &self.mechanism;
        let start = mechanism.driver().start;
        let (signs, state) = self.assembly_at(start)?;
        let network = Network::new(mechanism, self.engine.frame).free();
        let (_, program) = chain::build(&network, &self.ordering, chain::Dyads::Closed).ok()?;
        let mut engine = Engine::new(mechanism, self.engine.frame, program).free();
        engine.signs = signs;
        let own = &self.engine.program.coupled;
        for (group, own) in engine.program.coupled.iter_mut().zip(own) {
            group.side = own.side;
        }
        let balance = self.balance.as_deref();
        let balance = balance.and_then(|balance| balance.free(&network, &engine));
        let mut workspace = engine.state(self.slides);
        workspace.state.driven = self.engine.driven();
        workspace.state.forces = balance.as_ref().map(|b| b.force_state(&engine));
        let inputs = mechanism.inputs();
        let inputs = inputs.map(|input| mechanism.input_coordinate(input, start));
        Some(FreeInputs {
            mechanism: Arc::new(mechanism.clone()),
            plan: Arc::clone(&self.plan),
            kept: (inputs.collect::<Option<Vec<f64>>>()?, state),
            engine,
            balance: balance.map(Arc::new),
            workspace,
        })
    }
}

impl FreeInputs {
    /// Returns the state of the last solution.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.workspace.state
    }

    /// Returns the mechanism.
    #[must_use]
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// Returns the coordinates of all inputs at the last kept position, the driver's first.
    #[must_use]
    pub fn kept(&self) -> &[f64] {
        &self.kept.0
    }

    /// Solves with these moments of all inputs, the driver's first, near the last kept position.
    /// Returns [`Condition::NoAssembly`] beyond a stop too.
    pub fn solve(&mut self, inputs: &[InputMoment], order: Order) -> Condition {
        let FreeInputs {
            mechanism,
            engine,
            balance,
            workspace,
            kept,
            ..
        } = self;
        let scale = engine.frame.scale;
        let motions = mechanism.inputs().zip(inputs).map(|(input, moment)| {
            let InputMoment {
                at,
                speed,
                acceleration,
            } = *moment;
            let of = |p: f64, w: f64, a: f64| {
                let [p, w, a] = [p, w, a].map(Constant::exactly);
                InputMotion { p, w, a }
            };
            match input {
                Input::Turn(_) => of(at, speed.to_radians(), acceleration.to_radians()),
                Input::Push(_) => of(at / scale, speed / scale, acceleration / scale),
            }
        });
        let motions: Vec<InputMotion<Constant>> = motions.collect();
        engine.program.change_laws(&mut |law| {
            if let Some(&motion) = motions.get(law.number) {
                law.set(motion);
            }
        });
        let unit = match mechanism.driver().input {
            Input::Turn(_) => 1.0,
            Input::Push(_) => scale,
        };
        workspace.state.free = motions
            .first()
            .map(|driver| [driver.w.hi * unit, driver.a.hi * unit]);
        let at = inputs.first().map_or(0.0, |driver| driver.at);
        for group in &engine.program.coupled {
            group.read(&kept.1, group.open(&mut workspace.scratch).z);
        }
        workspace.state.measures.fill(1.0);
        let _ = engine.run(at, order, workspace);
        if let Some(balance) = balance {
            let speeds = motions.iter().map(|motion| motion.w.hi);
            balance.follow_free(engine, order, speeds, workspace);
        }
        if !self.is_between_stops() {
            self.workspace.state.condition = Condition::NoAssembly;
        }
        self.workspace.condition
    }

    /// Moves all inputs to these coordinates and solves there, without keeping the position. With a
    /// coupled group, the way there is divided.
    pub fn moved(&mut self, inputs: &[f64], order: Order) -> Condition {
        if !self.engine.program.coupled.is_empty() {
            let pieces = self.pieces(inputs);
            let from = self.kept.0.clone();
            for piece in 1..pieces {
                let part = f64::from(piece) / f64::from(pieces);
                let between = from.iter().zip(inputs);
                let between = between.map(|(from, to)| from + (to - from) * part);
                let between: Vec<f64> = between.collect();
                if self.solve_at_rest(&between, Order::Position) == Condition::NoAssembly {
                    break;
                }
                self.keep(&between);
            }
        }
        self.solve_at_rest(inputs, order)
    }

    /// Solves positions where the rates of the inputs do not exist.
    pub(super) fn without_rates(&mut self, inputs: &[InputMoment]) -> Condition {
        let condition = self.solve(inputs, Order::Position);
        if condition == Condition::Ok {
            self.workspace.state.condition = Condition::DeadPoint;
        }
        self.workspace.condition
    }

    fn solve_at_rest(&mut self, inputs: &[f64], order: Order) -> Condition {
        let moments: Vec<InputMoment> = inputs.iter().map(|&at| InputMoment::at_rest(at)).collect();
        self.solve(&moments, order)
    }

    /// Returns the number of pieces of a way on which coupled groups can be solved one from the
    /// other.
    fn pieces(&self, inputs: &[f64]) -> u16 {
        let moves = self.mechanism.inputs().zip(self.kept.0.iter().zip(inputs));
        let parts = moves.map(|(input, (from, to))| match input {
            Input::Turn(_) => (to - from).abs() / MAX_TURN,
            Input::Push(_) => (to - from).abs() / (MAX_PUSH * self.engine.frame.scale),
        });
        // The conversion saturates; NaN gives 0.
        parts.fold(1.0, f64::max).min(MAX_PIECES).ceil() as u16
    }

    /// Keeps the position of the last solution, at these coordinates of the inputs: coupled groups
    /// continue from it.
    pub fn keep(&mut self, inputs: &[f64]) {
        self.kept.0.clear();
        self.kept.0.extend(inputs);
        self.kept.1.clone_from(&self.workspace.state);
    }

    /// Returns the group that is nearest to the limit of its assembly in the last solution, with the
    /// square of the sine of its transmission angle, or an equivalent measure. `None` without such a
    /// group.
    pub fn nearest_limit(&mut self) -> Option<(GroupId, f64)> {
        if !self.engine.program.coupled.is_empty() {
            let at = self.workspace.state.at;
            self.engine.measure_coupled(at, &mut self.workspace);
        }
        let groups = self
            .plan
            .numbered()
            .filter(|(_, group)| group.has_choices());
        let measured = groups.filter_map(|(id, _)| {
            let measure = self.workspace.state.measures.get(id.index())?;
            Some((id, *measure))
        });
        measured.min_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    /// Returns `true` if the last solution lies between the stops of the mechanism.
    fn is_between_stops(&self) -> bool {
        let state = self.state();
        self.mechanism.limits().iter().all(|limit| {
            let slack = STOP_OVERSHOOT * limit.low.abs().max(limit.high.abs()).max(1.0);
            let is_within = |at: f64| limit.low - slack <= at && at <= limit.high + slack;
            let is_turned_within = |at: f64| {
                let beyond = (at - limit.low + slack).rem_euclid(TURN);
                beyond <= limit.high - limit.low + 2.0 * slack
            };
            match limit.of {
                LimitOf::Driver => match self.mechanism.driver().input {
                    Input::Turn(_) if limit.high - limit.low < TURN => is_turned_within(state.at()),
                    Input::Turn(_) => {
                        let start = self.mechanism.driver().start;
                        let turns = turns_between(start, [limit.low, limit.high], TURN);
                        is_within(state.at() - TURN * turns)
                    }
                    Input::Push(_) => is_within(state.at()),
                },
                // An input that moves by itself does not follow its table.
                LimitOf::Table(_) => true,
                LimitOf::Slide(slide) => {
                    let travel = state.travel(slide);
                    travel.is_none_or(|travel| is_within(travel.position))
                }
                LimitOf::Angle { link, from } => {
                    let seat = match from {
                        Body::Ground => Some(Vec2::X),
                        Body::Link(from) => state.direction(from),
                    };
                    let directions = state.direction(link).zip(seat);
                    directions.is_none_or(|(link, seat)| {
                        is_turned_within(angle::degrees(link.turned(seat.conj())))
                    })
                }
            }
        })
    }
}
