//! The same mechanism with slightly other lengths: the same groups and the same assembly, without a look
//! at its motion.

use super::engine::Engine;
use super::forces::Balance;
use super::network::Network;
use super::plan::Program;
use super::step::Step;
use super::{Condition, Order, Solver, State, Workspace, chain};
use crate::Mechanism;
use std::sync::Arc;

/// A solver beside another one: for a mechanism of the same structure, with other lengths.
#[derive(Clone, Debug)]
pub struct Perturbed {
    engine: Engine,
    slides: usize,
    /// For every group 1, or -1 where the same assembly has the other sign here.
    turned: Vec<f64>,
    balance: Option<Arc<Balance>>,
}

impl Solver {
    /// Makes a mechanism ready that differs from this solver's in its lengths alone; `None` where it
    /// falls into other groups.
    #[must_use]
    pub fn perturbed(&self, mechanism: &Mechanism) -> Option<Perturbed> {
        let network = Network::new(mechanism);
        let (_, program) = {
            let dyads = chain::Dyads::Closed;
            chain::build(&network, self.engine.frame, &self.ordering, dyads).ok()?
        };
        let mut engine = Engine::new(mechanism, self.engine.frame, program);
        let (ours, theirs) = (&self.engine.program, &mut engine.program);
        let same_groups = ours.group_starts.len() == theirs.group_starts.len()
            && ours.coupled.len() == theirs.coupled.len();
        let mut pairs = ours.coupled.iter().zip(&mut theirs.coupled);
        let alike = same_groups
            && pairs.all(|(ours, theirs)| {
                theirs.side = ours.side;
                ours.unknowns() == theirs.unknowns() && ours.width() == theirs.width()
            });
        let turned = turned(&self.engine.program, &engine.program);
        let balance = self.balance.as_ref();
        alike.then(|| Perturbed {
            balance: balance.and_then(|b| b.beside(&network, &engine)),
            engine,
            slides: self.slides,
            turned,
        })
    }

    /// A power of two, not above the mechanism's longest length and more than half of it, in the
    /// scene's unit.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.engine.frame.scale
    }
}

/// Which groups see the same assembly from the other side: two circles are taken from the shorter arm,
/// and of two equal arms either may be the shorter one with other lengths.
fn turned(ours: &Program, theirs: &Program) -> Vec<f64> {
    let nearer = |program: &Program| {
        let mut pivots = vec![None; program.group_starts.len()];
        for step in &program.steps {
            if let Step::Circles(circles) = step {
                pivots[circles.group] = Some(circles.near.pivot);
            }
        }
        pivots
    };
    let pairs = nearer(ours).into_iter().zip(nearer(theirs));
    pairs
        .map(|(ours, theirs)| if ours == theirs { 1.0 } else { -1.0 })
        .collect()
}

impl Perturbed {
    /// Room for a state: all that solving needs.
    #[must_use]
    pub fn state(&self) -> Workspace {
        let mut state = self.engine.state(self.slides);
        let balance = self.balance.as_ref();
        state.state.forces = balance.map(|b| b.room(&self.engine));
        state
    }

    /// Solves where the state `beside` of the other solver is, on the same assembly.
    pub fn solve(&self, beside: &State, order: Order, work: &mut Workspace) -> Condition {
        let signs = beside.signs.iter().zip(&self.turned);
        for (sign, (beside, turned)) in work.state.signs.iter_mut().zip(signs) {
            *sign = beside * turned;
        }
        for group in &self.engine.program.coupled {
            group.read(beside, group.open(&mut work.scratch).z);
        }
        let condition = self.engine.run(beside.at, order, work);
        if condition == Condition::Ok && self.engine.misfit(work).is_some() {
            work.state.condition = Condition::NoAssembly;
        }
        Balance::follow(self.balance.as_deref(), &self.engine, order, work);
        work.condition
    }
}
