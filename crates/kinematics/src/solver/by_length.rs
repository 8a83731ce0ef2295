#![doc = include_str!("../guide/derivatives.md")]

use super::elements::{ACCELERATION, POSITION, VELOCITY};
use super::engine::Engine;
use super::forces::Balance;
use super::plan::network::Network;
use super::state::{Condition, State};
use super::{Demand, Order, Solver, Workspace, chain};
use crate::{Dual, Length, Link, Number, SlideId, Vec2};
use std::sync::Arc;

/// Maximum derivative of a redundant constraint's miss by a length, in units of the constraint's
/// distance from the origin: rounding error.
const MAX_REDUNDANT_DERIVATIVE: f64 = 1e-9;
/// Maximum derivative of a place by a length, and of a link's direction times its reach. Beyond it
/// a group is nearly singular. At a sine of s the derivatives are 1/s, and doubles lose u/s^2 of
/// them: 8e-6.
const MAX_DERIVATIVE: f64 = 262_144.0;

/// A mechanism with its derivatives by one of its lengths, created by [`Solver::by_length`].
#[derive(Clone, Debug)]
pub struct ByLength {
    engine: Engine,
    slides: usize,
    /// The reach of each link in the solver's unit: the lever arm of its rotation.
    reach: Vec<f64>,
    /// Whether the scene allows redundant constraints only rounding errors, so that a length can
    /// jam them.
    is_strict: bool,
    balance: Option<Arc<Balance>>,
}

impl Solver {
    /// Prepares the derivatives by a length, for the values read by `demand`; `None` if the
    /// mechanism cannot be divided into groups.
    #[must_use]
    pub fn by_length(&self, length: Length, demand: &Demand) -> Option<ByLength> {
        let network = Network::new(&self.mechanism, self.engine.frame).by_length(length);
        let (_, program) = chain::build(&network, &self.ordering, chain::Dyads::Closed).ok()?;
        let mut found = ByLength {
            engine: Engine::new(&self.mechanism, self.engine.frame, program),
            slides: self.slides,
            reach: self.reaches(),
            is_strict: self.mechanism.misfit() == 0.0,
            balance: None,
        };
        let follow = |slide, at| self.follow(slide, at, &found);
        let balance = self.balance.as_ref();
        let balance = balance.and_then(|b| b.by_length(&network, &found.engine, follow));
        // Watched constraints are read too.
        if found.engine.program.watches.is_empty() {
            found.engine = found.engine.only(demand, self.slides);
        }
        found.balance = balance;
        Some(found)
    }

    /// Returns the derivative of a slide's position by a length at a coordinate; NaN if it does not
    /// exist.
    fn follow(&self, slide: SlideId, at: f64, by_length: &ByLength) -> f64 {
        let (mut state, mut dual) = (self.state(), by_length.state());
        let _ = self.solve(at, Order::Position, &mut state);
        if by_length.solve(&state, Order::Position, &mut dual) {
            dual.sliding(slide).position.slope
        } else {
            f64::NAN
        }
    }

    /// Returns how far links reach from their first point. Links with only one point carry a guide,
    /// and count as long as the longest length.
    fn reaches(&self) -> Vec<f64> {
        let reach = |link: &Link| {
            let from = link.members.first().map_or(Vec2::ZERO, |m| m.local);
            let places = link.members.iter().map(|m| (m.local - from).norm());
            let extreme = places.fold(0.0, f64::max);
            if extreme > 0.0 {
                self.engine.frame.length(extreme)
            } else {
                self.engine.frame.longest
            }
        };
        self.mechanism.links().iter().map(reach).collect()
    }

    /// Returns a power of two, at most the mechanism's longest length and more than half of it, in
    /// the scene's unit.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.engine.frame.scale
    }
}

impl ByLength {
    /// Creates a workspace for a state with its derivatives. Every number has its slope, in its own
    /// unit per unit of the scene's length.
    #[must_use]
    pub fn state(&self) -> Workspace<Dual> {
        let mut workspace = self.engine.state(self.slides);
        let balance = self.balance.as_ref();
        workspace.state.forces = balance.map(|b| b.force_state(&self.engine));
        workspace
    }

    /// Solves `state` again with the derivatives. Returns `true` if they exist. They do not exist
    /// where the motion ends or branches, or nearly so, and where the length would jam a redundant
    /// linkage. If they do not exist, nothing in `work` may be read. Allocates nothing.
    pub fn solve(&self, state: &State, order: Order, workspace: &mut Workspace<Dual>) -> bool {
        workspace.state.start(Dual::exactly(state.at), order);
        let exists = state.condition == Condition::Ok && self.solved(state, order, workspace);
        if exists {
            Balance::follow(self.balance.as_deref(), &self.engine, order, workspace);
        } else {
            workspace.state.condition = Condition::NoAssembly;
            workspace.state.forget_forces();
        }
        exists
    }

    fn solved(&self, state: &State, order: Order, workspace: &mut Workspace<Dual>) -> bool {
        let dual = &mut workspace.state;
        dual.condition = state.condition;
        for (sign, &of) in dual.signs.iter_mut().zip(&state.signs) {
            *sign = Dual::exactly(of);
        }
        let solved = match order {
            Order::Position => self.run::<POSITION>(state, workspace),
            Order::Velocity => self.run::<VELOCITY>(state, workspace),
            Order::Acceleration | Order::Force => self.run::<ACCELERATION>(state, workspace),
        };
        solved && !self.is_steep(&workspace.state) && !self.is_jammed(&workspace.state)
    }

    fn run<const ORDER: u8>(&self, state: &State, workspace: &mut Workspace<Dual>) -> bool {
        let at = workspace.state.at;
        let engine = &self.engine;
        engine.run_in::<Dual, ORDER>(at, workspace, |group, q, dual, scratch| {
            group.by_length(q, ORDER, state, dual, scratch)
        })
    }

    /// Returns `true` if a derivative is so large that none can be trusted.
    fn is_steep(&self, dual: &State<Dual>) -> bool {
        let steepest = MAX_DERIVATIVE / self.engine.frame.scale;
        // Written so that NaN is steep.
        let is_gentle = |v: Vec2<Dual>, reach: f64| {
            let slope = v.x.slope.abs().max(v.y.slope.abs());
            v.x.is_finite() && v.y.is_finite() && slope * reach <= steepest
        };
        let mut points = dual.points.iter();
        let mut links = dual.links.iter().zip(&self.reach);
        !(points.all(|point| is_gentle(point.p, 1.0))
            && links.all(|(link, &reach)| is_gentle(link.d, reach)))
    }

    /// Returns `true` if a redundant constraint would no longer hold.
    fn is_jammed(&self, dual: &State<Dual>) -> bool {
        let scale = self.engine.frame.scale;
        let mut misses = self.engine.misses(dual);
        // Written so that NaN jams.
        let holds =
            |miss: Dual, reach: f64| (miss.slope * scale).abs() <= MAX_REDUNDANT_DERIVATIVE * reach;
        self.is_strict && misses.any(|(_, miss, reach)| !holds(miss, reach))
    }
}
