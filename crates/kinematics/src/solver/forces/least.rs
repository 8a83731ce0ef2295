//! The reactions of least norm, where a redundant linkage leaves some open.
//!
//! Whatever constraints that repeat others press with, the linkage is in equilibrium: with r the reactions
//! as the steps find them, which let these press with nothing, and d_k those to the unit force of each, all
//! r + sum c_k d_k are. Of these the one with the least sum of squares, of all forces at pins and guides
//! and of moments over the longest length, is what pins and guides would bear that give way alike.

use super::open::{FELT, Felt, probes};
use super::{Balance, ForceState, Indeterminate};
use crate::solver::network::Network;
use crate::solver::workspace::Workspace;
use crate::solver::{Condition, Order, Solver};
use crate::{LinkId, PointId, SlideId, Vec2};
use nalgebra::DVector;

/// What is left of a unit force beside others below this part of it is rounding: it is felt as they are.
const ALIKE: f64 = 1e-9;

/// Reactions of least norm of one state: only those are its own that the equilibrium leaves open.
#[derive(Clone, Debug, PartialEq)]
pub struct LeastNorm {
    joints: Vec<(LinkId, PointId, Vec2)>,
    normals: Vec<(SlideId, f64)>,
    moments: Vec<(SlideId, f64)>,
}

impl LeastNorm {
    /// The force on a link at one of its joints, in N, in the ground's frame.
    #[must_use]
    pub fn joint_force(&self, link: LinkId, point: PointId) -> Option<Vec2> {
        let mut joints = self.joints.iter();
        let found = joints.find(|&&(of, at, _)| (of, at) == (link, point))?;
        Some(found.2)
    }

    /// The force of a guide on what slides along it, in N, as [`State::normal`](crate::solver::State::normal).
    #[must_use]
    pub fn normal(&self, slide: SlideId) -> Option<f64> {
        let found = self.normals.iter().find(|&&(of, _)| of == slide)?;
        Some(found.1)
    }

    /// The moment of a guide, in N m, as [`State::moment`](crate::solver::State::moment).
    #[must_use]
    pub fn moment(&self, slide: SlideId) -> Option<f64> {
        let found = self.moments.iter().find(|&&(of, _)| of == slide)?;
        Some(found.1)
    }
}

/// All reactions, one after the other.
fn listed(forces: &ForceState<f64>, felt: &Felt, members: usize) -> DVector<f64> {
    let joints = forces.joints.iter().zip(&felt.joints).take(members);
    let joints = joints.flat_map(|(&a, &b)| [(a + b).x, (a + b).y]);
    let normals = forces.normals.iter().zip(&felt.normals);
    let moments = forces.moments.iter().zip(&felt.moments);
    let guides = normals.chain(moments).map(|(a, b)| a + b);
    DVector::from_vec(joints.chain(guides).collect())
}

impl Solver {
    /// The reactions of least norm at a coordinate of the driver, for those that the equilibrium leaves open
    /// ([`Solver::indeterminate`]): what pins and guides would bear that give way alike. `None` where none is
    /// open, or where there are no reactions.
    #[must_use]
    pub fn least_norm(&self, at: f64) -> Option<LeastNorm> {
        let balance = self.balance.as_deref()?;
        if balance.indeterminate.is_empty() {
            return None;
        }
        let mut work = self.state();
        let is_ok = self.solve(at, Order::Force, &mut work) == Condition::Ok;
        if !is_ok || work.withholds() {
            return None;
        }
        let network = Network::new(&self.mechanism, self.engine.frame);
        least(balance, &network, self, &mut work)
    }
}

fn least(
    balance: &Balance,
    network: &Network<'_>,
    solver: &Solver,
    work: &mut Workspace,
) -> Option<LeastNorm> {
    let members = balance.slots.members.len();
    let slides = balance.open.normals.len();
    let found = work.state.forces.as_deref()?;
    let mut reactions = listed(found, &Felt::new(&balance.open), members);
    // Moments count by what they are at the end of the longest length.
    let moments = 2 * members + slides..reactions.len();
    let weigh = |all: &mut DVector<f64>, by: f64| {
        for row in moments.clone() {
            all[row] *= by;
        }
    };
    let longest = solver.engine.frame.longest;
    weigh(&mut reactions, 1.0 / longest);
    // Gram and Schmidt, twice: the decompositions at hand lose digits of directions that are alike in size.
    let mut units: Vec<DVector<f64>> = Vec::new();
    probes(balance, network, solver, work, |forces, felt| {
        let mut unit = listed(forces, felt, members);
        weigh(&mut unit, 1.0 / longest);
        let size = unit.norm();
        without(&mut unit, &units);
        let left = unit.norm();
        if left > FELT.max(ALIKE * size) {
            units.push(unit / left);
        }
    });
    without(&mut reactions, &units);
    weigh(&mut reactions, longest);
    reactions
        .iter()
        .all(|r| r.is_finite())
        .then(|| told(balance, solver, &reactions))
}

/// Takes all that lies along directions, which stand on each other at right angles, out of a vector.
fn without(vector: &mut DVector<f64>, directions: &[DVector<f64>]) {
    for _ in 0..2 {
        for direction in directions {
            let along = direction.dot(vector);
            vector.axpy(-along, direction, 1.0);
        }
    }
}

/// Those that are open.
fn told(balance: &Balance, solver: &Solver, reactions: &DVector<f64>) -> LeastNorm {
    let members = balance.slots.members.len();
    let slides = balance.open.normals.len();
    let metres = solver.mechanism.metres() * solver.engine.frame.scale;
    let mut told = LeastNorm {
        joints: Vec::new(),
        normals: Vec::new(),
        moments: Vec::new(),
    };
    for open in &balance.indeterminate {
        match *open {
            Indeterminate::Joint(link, point) => {
                let slot = 2 * balance.slots.of(link, point);
                let force = Vec2::new(reactions[slot], reactions[slot + 1]);
                told.joints.push((link, point, force));
            }
            Indeterminate::Normal(slide) => {
                let normal = reactions[2 * members + slide.index()];
                told.normals.push((slide, normal));
            }
            Indeterminate::Moment(slide) => {
                let moment = reactions[2 * members + slides + slide.index()];
                told.moments.push((slide, moment * metres));
            }
        }
    }
    told
}
