//! Checks of equilibrium, link by link, and forces that are false on purpose.

use super::{ForceState, Pass};
use crate::solver::{Condition, Order, Solver, State};
use crate::{Body, Input, LinkId, Mechanism, PointId, SlideId, Slider, Vec2};
use std::cell::Cell;

thread_local!(static IS_FALSIFIED: Cell<bool> = const { Cell::new(false) });

/// Runs `f`; every solver made meanwhile on this thread finds false forces.
pub fn falsified<T>(is_so: bool, f: impl FnOnce() -> T) -> T {
    let before = IS_FALSIFIED.replace(is_so);
    let done = f();
    IS_FALSIFIED.set(before);
    done
}

/// Repeats the pass of the last group if the current thread falsifies forces.
pub(super) fn falsify_if_requested(mut passes: Vec<Pass>) -> Vec<Pass> {
    let is_group = |pass: &Pass| !matches!(pass, Pass::Spin(_) | Pass::Ride(_) | Pass::Lock(_));
    let last = passes.iter().rposition(is_group);
    if let Some(last) = last.filter(|_| IS_FALSIFIED.get()) {
        passes.insert(last, passes[last].clone());
    }
    passes
}

/// The forces and loads of a state.
struct RecordedForces {
    forces: ForceState<f64>,
    /// The loads on points, and as couples on links.
    points: Vec<Vec2>,
    couples: Vec<f64>,
    /// The loads on a link at a point that do not act on the pin there.
    pressed: Vec<(LinkId, PointId, Vec2)>,
}

fn noted(solver: &Solver, state: &State) -> RecordedForces {
    let balance = solver.balance.as_ref().expect("loads act");
    let mut acting = *balance.force_state(&solver.engine);
    balance.acting.apply_loads(state, &mut acting);
    let mut points = acting.points;
    let mut pressed = Vec::new();
    for acted in solver.acted(state) {
        for &(point, force) in acted.forces.iter().filter(|_| acted.on.is_some()) {
            points[point.index()] += -force;
            pressed.extend(acted.on.map(|link| (link, point, force)));
        }
    }
    RecordedForces {
        forces: (**state.forces.as_ref().expect("forces were solved")).clone(),
        points,
        couples: acting.links,
        pressed,
    }
}

/// A sum of forces and moments, and the size of the largest term.
#[derive(Default)]
struct ForceSum {
    force: Vec2,
    moment: f64,
    size: f64,
}

impl ForceSum {
    fn add(&mut self, at: Vec2, force: Vec2) {
        self.force += force;
        self.twist(at.cross(force));
        self.size = self.size.max(force.norm());
    }

    fn twist(&mut self, couple: f64) {
        self.moment += couple;
        self.size = self.size.max(couple.abs());
    }

    fn miss(&self) -> f64 {
        self.force.norm().max(self.moment.abs()) / self.size.max(1.0)
    }
}

/// Returns the force accumulated on the own coordinate of an input, which its motor resists; zero
/// for an input that the mechanism does not have.
fn effort(mechanism: &Mechanism, input: Input, of: &RecordedForces) -> f64 {
    let number = mechanism.inputs().position(|other| other == input);
    number.map_or(0.0, |number| of.forces.efforts[number])
}

/// Returns the sliding point of a slide, and the force of the guide on it.
fn guided(
    mechanism: &Mechanism,
    slide: SlideId,
    state: &State,
    of: &RecordedForces,
) -> (PointId, Vec2) {
    let t = state.travels[slide.index()].guide.d;
    let along = effort(mechanism, Input::Push(slide), of);
    let force = t.perp() * of.forces.normals[slide.index()] - t * along;
    (mechanism.slide(slide).slider.point(), force)
}

fn link_miss(mechanism: &Mechanism, link: LinkId, state: &State, of: &RecordedForces) -> f64 {
    let at = |p: PointId| state.points[p.index()].p;
    let mut sum = ForceSum::default();
    for member in &mechanism.link(link).members {
        let slot = of.forces.slots.of(link, member.point);
        sum.add(at(member.point), of.forces.joints[slot]);
    }
    sum.twist(of.couples[link.index()]);
    for &(_, point, force) in of.pressed.iter().filter(|(on, ..)| *on == link) {
        sum.add(at(point), force);
    }
    sum.twist(-effort(mechanism, Input::Turn(link), of));
    // A motor on another link acts on that link with the opposite moment.
    for (turned, _) in mechanism.elbows().filter(|&(_, from)| from == link) {
        sum.twist(effort(mechanism, Input::Turn(turned), of));
    }
    for slide in mechanism.slide_ids() {
        let (point, force) = guided(mechanism, slide, state, of);
        let given = mechanism.slide(slide);
        let moment = of.forces.moments[slide.index()];
        if matches!(given.slider, Slider::Link { link: slider, .. } if slider == link) {
            sum.add(at(point), force);
            sum.twist(moment);
        }
        if given.on == Body::Link(link) {
            sum.add(at(point), -force);
            sum.twist(-moment);
        }
    }
    sum.miss()
}

fn pin_miss(mechanism: &Mechanism, point: PointId, state: &State, of: &RecordedForces) -> f64 {
    let mut sum = ForceSum::default();
    sum.add(Vec2::ZERO, of.points[point.index()]);
    for &link in &mechanism.point(point).links {
        let slot = of.forces.slots.of(link, point);
        sum.add(Vec2::ZERO, -of.forces.joints[slot]);
    }
    for slide in mechanism.slide_ids() {
        let (at, force) = guided(mechanism, slide, state, of);
        match mechanism.slide(slide).slider {
            Slider::Pin(pin) if pin == point => sum.add(Vec2::ZERO, force),
            // The guide's force on a link has been subtracted from its origin's pin.
            Slider::Link { .. } if at == point => sum.size = sum.size.max(force.norm()),
            Slider::Pin(_) | Slider::Link { .. } => {}
        }
    }
    sum.miss()
}

/// Checks that every link and every pin is in equilibrium at some coordinates, and returns how many
/// of the states are ordinary.
///
/// # Panics
/// If a sum of forces or moments is beyond rounding.
pub fn check_equilibrium(solver: &Solver, coordinates: impl Iterator<Item = f64>) -> u32 {
    let mechanism = solver.mechanism();
    let mut state = solver.state();
    let mut checked = 0;
    for at in coordinates {
        if solver.solve(at, Order::Force, &mut state) != Condition::Ok {
            continue;
        }
        // Near a singularity all forces are large, and so are their rounding errors.
        if state.measures.iter().any(|m| m.abs() < 1e-3) {
            continue;
        }
        checked += 1;
        let of = noted(solver, &state);
        for link in mechanism.link_ids() {
            let miss = link_miss(mechanism, link, &state, &of);
            assert!(miss < 1e-11, "at {at}: {link:?} misses by {miss:e}");
        }
        for point in mechanism.point_ids() {
            if mechanism.point(point).ground.is_none() {
                let miss = pin_miss(mechanism, point, &state, &of);
                assert!(miss < 1e-11, "at {at}: {point:?} misses by {miss:e}");
            }
        }
        let residual = state.residual().expect("forces were solved");
        let size = of.points.iter().map(|f| f.norm()).fold(1.0, f64::max);
        let drive = state.drive().expect("forces were solved").abs().max(size);
        assert!(
            residual.drive.abs() < 1e-11 * drive,
            "at {at}: {residual:?} of {drive}"
        );
        assert!(
            residual.force.norm() < 1e-11 * size,
            "at {at}: {residual:?}"
        );
    }
    checked
}
