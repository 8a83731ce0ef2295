#![doc = include_str!("../guide/derivatives.md")]

use super::elements::{ACCELERATION, POSITION, VELOCITY};
use super::engine::Engine;
use super::forces::Balance;
use super::network::Network;
use super::state::{Condition, State};
use super::{Demand, Order, Solver, Workspace, chain};
use crate::{Dual, Length, Number};
use std::sync::Arc;

/// By how much a constraint that others repeat may follow a length, as a part of it and of how far out the
/// constraint is: rounding.
const JAMMED: f64 = 1e-9;
/// Where a place follows a length more than so many times, the group that makes it do so is as good as
/// singular. At a sine of s the places follow by 1/s, and what doubles lose of derivatives is u/s^2: 8e-6.
const STEEPEST: f64 = 262_144.0;

/// A mechanism that knows what one of its lengths does: made by [`Solver::by_length`].
#[derive(Clone, Debug)]
pub struct ByLength {
    engine: Engine,
    slides: usize,
    /// Whether the redundant constraints of the scene are held to rounding, so that a length can jam them.
    is_strict: bool,
    balance: Option<Arc<Balance>>,
}

impl Solver {
    /// Makes the derivatives by a length ready, of what `demand` reads; `None` where the mechanism cannot be
    /// put into groups.
    #[must_use]
    pub fn by_length(&self, length: Length, demand: &Demand) -> Option<ByLength> {
        let network = Network::new(&self.mechanism, self.engine.frame).by_length(length);
        let (_, program) = chain::build(&network, &self.ordering, chain::Dyads::Closed).ok()?;
        let engine = Engine::new(&self.mechanism, self.engine.frame, program);
        let balance = self.balance.as_ref();
        Some(ByLength {
            balance: balance.and_then(|b| b.beside(&network, &engine)),
            engine: engine.only(demand, self.slides),
            slides: self.slides,
            is_strict: self.mechanism.misfit() == 0.0,
        })
    }

    /// A power of two, not above the mechanism's longest length and more than half of it, in the
    /// scene's unit.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.engine.frame.scale
    }
}

impl ByLength {
    /// Room for a state with its derivatives.
    #[must_use]
    pub fn state(&self) -> Workspace<Dual> {
        let mut work = self.engine.state(self.slides);
        let balance = self.balance.as_ref();
        work.state.forces = balance.map(|b| b.room(&self.engine));
        work
    }

    /// Solves once more what is in `state`, with the derivatives; whether they exist. They do not where the
    /// motion ends or branches, or as good as does, and where the length would jam a redundant linkage. Allocates nothing.
    pub fn solve(&self, state: &State, order: Order, work: &mut Workspace<Dual>) -> bool {
        let dual = &mut work.state;
        dual.begin(Dual::exactly(state.at), order);
        dual.condition = state.condition;
        if state.condition != Condition::Ok {
            dual.forget_forces();
            return false;
        }
        for (sign, &of) in dual.signs.iter_mut().zip(&state.signs) {
            *sign = Dual::exactly(of);
        }
        let solved = match order {
            Order::Position => self.run::<POSITION>(state, work),
            Order::Velocity => self.run::<VELOCITY>(state, work),
            Order::Acceleration | Order::Force => self.run::<ACCELERATION>(state, work),
        };
        if !solved || self.is_steep(&work.state) || self.is_jammed(&work.state) {
            return false;
        }
        Balance::follow(self.balance.as_deref(), &self.engine, order, work);
        true
    }

    fn run<const ORDER: u8>(&self, state: &State, work: &mut Workspace<Dual>) -> bool {
        let at = work.state.at;
        let engine = &self.engine;
        engine.run_in::<Dual, ORDER>(at, work, |group, q, dual, scratch| {
            group.by_length(q, ORDER, state, dual, scratch)
        })
    }

    /// Whether anything follows the length so much that the derivatives are not to be trusted.
    fn is_steep(&self, dual: &State<Dual>) -> bool {
        let points = dual.points.iter().map(|point| point.p);
        let links = dual.links.iter().map(|link| link.d);
        let steepest = STEEPEST / self.engine.frame.scale;
        let mut places = points.chain(links);
        // Written so that NaN is steep.
        let is_gentle = |v: Dual| v.slope.abs() <= steepest;
        !places.all(|place| is_gentle(place.x) && is_gentle(place.y))
    }

    /// Whether a constraint that others repeat would no longer hold.
    fn is_jammed(&self, dual: &State<Dual>) -> bool {
        let scale = self.engine.frame.scale;
        let mut misses = self.engine.misses(dual);
        // Written so that NaN jams.
        let holds = |miss: Dual, reach: f64| (miss.slope * scale).abs() <= JAMMED * reach;
        self.is_strict && misses.any(|(_, miss, reach)| !holds(miss, reach))
    }
}
