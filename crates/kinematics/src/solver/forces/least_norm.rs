//! Computes the reactions of least norm if a redundant linkage leaves some undetermined.
//!
//! The linkage is in equilibrium for any force of its redundant constraints. Let r be the reactions
//! found by the steps, in which these constraints have no force, and d_k the reactions to the unit
//! force of each. Then all r + sum c_k d_k are in equilibrium. The reactions of least norm minimise
//! the sum of squares over all forces at pins and guides, and over moments divided by the longest
//! length. They are the reactions for pins and guides of equal compliance.

use super::open::{DirectAction, MIN_REACTION, probes};
use super::{Balance, ForceState, Indeterminate};
use crate::solver::plan::network::Network;
use crate::solver::workspace::Workspace;
use crate::solver::{Condition, Order, Solver};
use crate::{LinkId, PointId, SlideId, Vec2};
use nalgebra::DVector;

/// The relative remainder of a unit force below which it is rounding error: its reactions depend on
/// those of the others.
const ROUNDING_REMAINDER: f64 = 1e-9;

/// The reactions of least norm of a state, for those that the equilibrium leaves undetermined.
#[derive(Clone, Debug, PartialEq)]
pub struct LeastNorm {
    joints: Vec<(LinkId, PointId, Vec2)>,
    normals: Vec<(SlideId, f64)>,
    moments: Vec<(SlideId, f64)>,
}

impl LeastNorm {
    /// Returns the force on a link at one of its joints, in N, in the ground's frame.
    #[must_use]
    pub fn joint_force(&self, link: LinkId, point: PointId) -> Option<Vec2> {
        let mut joints = self.joints.iter();
        let found = joints.find(|&&(of, at, _)| (of, at) == (link, point))?;
        Some(found.2)
    }

    /// Returns the force of a guide on its slider, in N, as
    /// [`State::normal`](crate::solver::State::normal).
    #[must_use]
    pub fn normal(&self, slide: SlideId) -> Option<f64> {
        let found = self.normals.iter().find(|&&(of, _)| of == slide)?;
        Some(found.1)
    }

    /// Returns the moment of a guide, in N m, as [`State::moment`](crate::solver::State::moment).
    #[must_use]
    pub fn moment(&self, slide: SlideId) -> Option<f64> {
        let found = self.moments.iter().find(|&&(of, _)| of == slide)?;
        Some(found.1)
    }
}

/// Returns all reactions as one vector.
fn listed(forces: &ForceState<f64>, felt: &DirectAction, members: usize) -> DVector<f64> {
    let joints = forces.joints.iter().zip(&felt.joints).take(members);
    let joints = joints.flat_map(|(&a, &b)| [(a + b).x, (a + b).y]);
    let normals = forces.normals.iter().zip(&felt.normals);
    let moments = forces.moments.iter().zip(&felt.moments);
    let guides = normals.chain(moments).map(|(a, b)| a + b);
    DVector::from_vec(joints.chain(guides).collect())
}

impl Solver {
    /// Computes the reactions of least norm at a coordinate of the driver, for those that the
    /// equilibrium leaves undetermined ([`Solver::indeterminate`]). They are the reactions for pins
    /// and guides of equal compliance. `None` if all are determined, or if there are no reactions.
    #[must_use]
    pub fn least_norm(&self, at: f64) -> Option<LeastNorm> {
        let balance = self.balance.as_deref()?;
        if balance.indeterminate.is_empty() {
            return None;
        }
        let mut workspace = self.state();
        let is_ok = self.solve(at, Order::Force, &mut workspace) == Condition::Ok;
        if !is_ok || workspace.withholds() {
            return None;
        }
        let network = Network::new(&self.mechanism, self.engine.frame);
        min_norm(balance, &network, self, &mut workspace)
    }
}

fn min_norm(
    balance: &Balance,
    network: &Network<'_>,
    solver: &Solver,
    workspace: &mut Workspace,
) -> Option<LeastNorm> {
    let members = balance.slots.members.len();
    let slides = balance.open.normals.len();
    let found = workspace.state.forces.as_deref()?;
    let mut reactions = listed(found, &DirectAction::new(&balance.open), members);
    // Moments are weighted by their force at the end of the longest length.
    let moments = 2 * members + slides..reactions.len();
    let weigh = |all: &mut DVector<f64>, by: f64| {
        for row in moments.clone() {
            all[row] *= by;
        }
    };
    let longest = solver.engine.frame.longest;
    weigh(&mut reactions, 1.0 / longest);
    // Gram-Schmidt, applied twice: the available decompositions lose digits for directions of
    // similar size.
    let mut units: Vec<DVector<f64>> = Vec::new();
    probes(balance, network, solver, workspace, |forces, felt| {
        let mut unit = listed(forces, felt, members);
        weigh(&mut unit, 1.0 / longest);
        let size = unit.norm();
        without(&mut unit, &units);
        let left = unit.norm();
        if left > MIN_REACTION.max(ROUNDING_REMAINDER * size) {
            units.push(unit / left);
        }
    });
    without(&mut reactions, &units);
    weigh(&mut reactions, longest);
    reactions
        .iter()
        .all(|r| r.is_finite())
        .then(|| from_reactions(balance, solver, &reactions))
}

/// Removes from a vector its components along orthogonal directions.
fn without(vector: &mut DVector<f64>, directions: &[DVector<f64>]) {
    for _ in 0..2 {
        for direction in directions {
            let along = direction.dot(vector);
            vector.axpy(-along, direction, 1.0);
        }
    }
}

/// Returns the undetermined reactions.
fn from_reactions(balance: &Balance, solver: &Solver, reactions: &DVector<f64>) -> LeastNorm {
    let members = balance.slots.members.len();
    let slides = balance.open.normals.len();
    let metres = solver.mechanism.metres() * solver.engine.frame.scale;
    let mut text = LeastNorm {
        joints: Vec::new(),
        normals: Vec::new(),
        moments: Vec::new(),
    };
    for open in &balance.indeterminate {
        match *open {
            Indeterminate::Joint(link, point) => {
                let slot = 2 * balance.slots.of(link, point);
                let force = Vec2::new(reactions[slot], reactions[slot + 1]);
                text.joints.push((link, point, force));
            }
            Indeterminate::Normal(slide) => {
                let normal = reactions[2 * members + slide.index()];
                text.normals.push((slide, normal));
            }
            Indeterminate::Moment(slide) => {
                let moment = reactions[2 * members + slides + slide.index()];
                text.moments.push((slide, moment * metres));
            }
        }
    }
    text
}
