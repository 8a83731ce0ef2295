//! Finds the reactions that the equilibrium leaves undetermined: those of redundant constraints.
//!
//! The steps are built on as many constraints as there are unknowns. An additional constraint may
//! press with any force, and everything that reacts to it is indeterminate. Therefore each
//! constraint applies a unit force, which the steps propagate backwards. Every reaction that
//! remains is undetermined. The action of the constraint itself is included: if the steps are built
//! on it, both cancel.

use super::{Balance, Extent, ForceState, Slots};
use crate::solver::plan::network::Network;
use crate::solver::plan::{Gauge, WatchedConstraint};
use crate::solver::state::{Condition, State};
use crate::solver::workspace::Workspace;
use crate::solver::{Order, Solver};
use crate::{Body, LinkId, Mechanism, PointId, SlideId, Slider, Vec2};

/// The fraction of a unit force below which a reaction is rounding error.
pub(super) const MIN_REACTION: f64 = 1e-9;
/// Fractions of the motion at which constraints are tried, in addition to the opening coordinate.
/// An undetermined reaction may vanish at a single place, and scenes open at special ones.
const PLACES: [f64; 4] = [0.137, 0.382, 0.618, 0.861];

/// The undetermined reactions.
#[derive(Clone, Debug)]
pub(super) struct Open {
    /// By slot.
    pub joints: Vec<bool>,
    /// By slide.
    pub normals: Vec<bool>,
    pub moments: Vec<bool>,
}

/// A reaction that a redundant linkage leaves undetermined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Indeterminate {
    /// The force on a link at a joint.
    Joint(LinkId, PointId),
    /// The normal force of a slide.
    Normal(SlideId),
    /// The moment of a slide.
    Moment(SlideId),
}

impl Open {
    pub(super) fn none(mechanism: &Mechanism, slots: &Slots) -> Open {
        let slides = mechanism.slides().len();
        Open {
            joints: vec![false; slots.nowhere() + 1],
            normals: vec![false; slides],
            moments: vec![false; slides],
        }
    }

    /// Tries every constraint at ordinary states of the motion.
    pub(super) fn find(
        balance: &Balance,
        network: &Network<'_>,
        solver: &Solver,
        workspace: &mut Workspace,
    ) -> Open {
        let mut open = Open::none(network.mechanism, &balance.slots);
        if solver.engine.program.watches.is_empty() && network.repeated_locks.is_empty() {
            return open;
        }
        let (low, high) = solver.motion.range.ends();
        let places = PLACES.map(|part| low + part * (high - low));
        for at in places.into_iter().chain([solver.opening]) {
            if solver.solve(at, Order::Position, workspace) == Condition::Ok {
                probes(balance, network, solver, workspace, |forces, felt| {
                    open.mark(forces, felt)
                });
            }
        }
        open
    }

    fn mark(&mut self, forces: &ForceState<f64>, felt: &DirectAction) {
        let joints = forces.joints.iter().zip(&felt.joints);
        for (open, (&a, &b)) in self.joints.iter_mut().zip(joints) {
            *open |= exceeds_rounding((a + b).norm());
        }
        let normals = forces.normals.iter().zip(&felt.normals);
        for (open, (a, b)) in self.normals.iter_mut().zip(normals) {
            *open |= exceeds_rounding((a + b).abs());
        }
        let moments = forces.moments.iter().zip(&felt.moments);
        for (open, (a, b)) in self.moments.iter_mut().zip(moments) {
            *open |= exceeds_rounding((a + b).abs());
        }
    }

    /// Returns the undetermined reactions, in the mechanism's order.
    pub(super) fn list(&self, mechanism: &Mechanism, slots: &Slots) -> Vec<Indeterminate> {
        let mut list = Vec::new();
        for link in mechanism.link_ids() {
            for point in mechanism.pins(link) {
                if self.joints[slots.of(link, point)] {
                    list.push(Indeterminate::Joint(link, point));
                }
            }
        }
        for slide in mechanism.slide_ids() {
            if self.normals[slide.index()] {
                list.push(Indeterminate::Normal(slide));
            }
            if self.moments[slide.index()] {
                list.push(Indeterminate::Moment(slide));
            }
        }
        list
    }
}

/// Applies the unit force of every watched constraint and of every repeated lock at a state. Calls
/// `tell` with the reactions of the steps, and with the direct action of the constraint.
pub(super) fn probes(
    balance: &Balance,
    network: &Network<'_>,
    solver: &Solver,
    workspace: &mut Workspace,
    mut tell: impl FnMut(&ForceState<f64>, &DirectAction),
) {
    for watch in &solver.engine.program.watches {
        probe(
            balance,
            solver,
            workspace,
            &mut tell,
            |state, forces, felt| {
                press(watch, &balance.slots, network, state, forces, felt);
            },
        );
    }
    for &slide in &network.repeated_locks {
        let given = network.mechanism.slide(slide);
        let Slider::Link { link, .. } = given.slider else {
            continue;
        };
        let on = network.body(given.on);
        probe(balance, solver, workspace, &mut tell, |_, forces, felt| {
            forces.links[link.index()] += 1.0;
            forces.links[on.index()] += -1.0;
            felt.moments[slide.index()] = 1.0;
        });
    }
}

/// Applies a force, propagates it backwards and reports the reactions.
fn probe(
    balance: &Balance,
    solver: &Solver,
    workspace: &mut Workspace,
    tell: &mut impl FnMut(&ForceState<f64>, &DirectAction),
    press: impl Fn(&State, &mut ForceState<f64>, &mut DirectAction),
) {
    let Workspace { state, scratch, .. } = workspace;
    let Some(mut forces) = state.forces.take() else {
        return;
    };
    forces.clear();
    let mut felt = DirectAction::new(&balance.open);
    press(state, &mut forces, &mut felt);
    if balance.run_back(&solver.engine, state, scratch, &mut forces) {
        balance.locked.finish(&mut forces);
        balance.frame.free_origins(state, &mut forces);
        tell(&forces, &felt);
    }
    forces.extent = Extent::Nothing;
    state.forces = Some(forces);
}

/// Returns `true` if a reaction is larger than rounding. NaN counts as a reaction.
fn exceeds_rounding(size: f64) -> bool {
    !(size <= MIN_REACTION)
}

/// The direct action of a loaded constraint on links and slides, initially zero.
pub(super) struct DirectAction {
    pub(super) joints: Vec<Vec2>,
    pub(super) normals: Vec<f64>,
    pub(super) moments: Vec<f64>,
}

impl DirectAction {
    pub(super) fn new(open: &Open) -> DirectAction {
        DirectAction {
            joints: vec![Vec2::ZERO; open.joints.len()],
            normals: vec![0.0; open.normals.len()],
            moments: vec![0.0; open.moments.len()],
        }
    }
}

/// Applies a unit force to a watched constraint.
fn press(
    watch: &WatchedConstraint,
    slots: &Slots,
    network: &Network<'_>,
    state: &State,
    forces: &mut ForceState<f64>,
    felt: &mut DirectAction,
) {
    let at = |p: PointId| state.points[p.index()].p;
    let mut pair = |from: PointId, to: PointId, force: Vec2, forces: &mut ForceState<f64>| {
        forces.points[to.index()] += force;
        forces.points[from.index()] += -force;
        if let crate::ElementId::Link(link) = watch.element {
            felt.joints[slots.of(link, to)] += -force;
            felt.joints[slots.of(link, from)] += force;
        }
    };
    match watch.gauge {
        Gauge::Distance { from, to, .. } => {
            let e = at(to) - at(from);
            pair(from, to, e / e.norm(), forces);
        }
        Gauge::Direction { from, to, link, .. } => {
            let e = at(to) - at(from);
            pair(from, to, e.perp() / e.norm(), forces);
            forces.links[link.index()] += -e.norm();
        }
        Gauge::OnLine { point, line } => {
            let guide = line.at(state);
            forces.points[point.index()] += guide.n;
            forces.points[line.through.index()] += -guide.n;
            let s = guide.t.dot(at(point) - guide.q.p);
            forces.links[line.link.index()] += -s;
            if let crate::ElementId::Slide(slide) = watch.element {
                felt.normals[slide.index()] += 1.0;
                let given = network.mechanism.slide(slide);
                // On the link itself, not through its pin.
                if let Slider::Link { link, origin, .. } = given.slider {
                    felt.joints[slots.of(link, origin)] += -guide.n;
                }
                if let Body::Link(on) = given.on {
                    felt.joints[slots.of(on, line.through)] += guide.n;
                }
            }
        }
        // The driver's own constraints are never redundant.
        Gauge::Pushed { .. } | Gauge::Turned { .. } => {}
    }
}
