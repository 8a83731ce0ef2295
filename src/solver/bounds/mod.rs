//! How far a state can be from the truth.
//!
//! The figures of a state come from formulas that are fast; here each group is looked at once more,
//! from the outside. The residuals of its constraints at the computed position, to twice the
//! precision, go through the inverse of its own matrix; Krawczyk's operator proves that a solution
//! lies within what comes out, and how near (Rump, Verification methods, Acta Numerica 19, 2010,
//! section 13). What follows from positions - riders, rates, later groups - is computed in balls.
//! The bound of a figure is its distance from the farthest point of its ball: it does not matter how
//! the figure was come by.
//!
//! Group by group a bound grows by what each makes of the sizes, not of the signs, of the errors before it.
//! A long chain of groups is therefore enclosed at once, as one list of rows.
//!
//! The bounds are for the scene as it is given: a number such as 39.3 is meant as it was typed, and
//! stored to half an ulp. They are for the assembly that the figure is near to. They trust the platform's square root to be
//! rounded correctly and its arctangent to an ulp.

mod arm;
mod pairs;
mod stretched;

use super::chain;
use super::engine::Engine;
use super::forces::Balance;
use super::frame::Frame;
use super::network::Network;
use super::order::Ordering;
use super::plan::Plan;
use super::state::{Condition, State};
use super::step::{ACCELERATION, Dyad, Outcome, POSITION, Step, VELOCITY};
use super::{Order, Solver, Workspace};
use crate::arithmetic::typed_radius;
use crate::{Ball, LinkId, Number, PointId, Vec2};
use std::sync::Arc;

/// Nothing is known.
const UNKNOWN: Ball = Ball {
    mid: 0.0,
    radius: f64::INFINITY,
};

/// So many groups in series widen what they are given to where little is left: by about ten from
/// stage to stage of a scissor lift. Then all are enclosed at once,
const LONG: usize = 8;
/// unless there are more unknowns than this: the inverse of the matrix costs the cube of them.
const MOST_AT_ONCE: usize = 256;

/// The whole mechanism as one list of rows, if that is how its bounds are to be found.
pub(super) fn at_once(
    network: &Network<'_>,
    ordering: &Ordering,
    plan: &Plan,
) -> Option<Arc<Engine>> {
    if plan.groups.len() <= LONG {
        return None;
    }
    let unknowns = ordering
        .blocks
        .iter()
        .map(|b| b.unknowns.len())
        .sum::<usize>();
    if unknowns > MOST_AT_ONCE {
        return None;
    }
    let frame = Frame::of(network.mechanism);
    let (_, program) = chain::build(network, frame, ordering, chain::Dyads::AtOnce).ok()?;
    Some(Arc::new(Engine::new(network.mechanism, frame, program)))
}

impl Solver {
    /// Room for a state with bounds.
    #[must_use]
    pub fn enclosure(&self) -> Workspace<Ball> {
        let mut enclosure = self.with_forces(self.engine.enclosure(self.slides));
        let at_once = self.at_once.as_ref();
        enclosure.at_once = at_once.map(|engine| Box::new(engine.enclosure(self.slides)));
        enclosure
    }

    /// Encloses what the solver has just put into `state`: every figure that is read from
    /// `enclosure` is a ball that holds the true one, with an infinite radius where that cannot be
    /// proved. It goes as far as `order`, and as the state was solved. Allocates nothing.
    ///
    /// Where forces are among them, the bounds of what their checks miss by decide whether rounding
    /// explains it: `state` withholds its forces where they do not.
    pub fn enclose(&self, state: &mut State, order: Order, enclosure: &mut Workspace<Ball>) {
        // Within rounding beyond a limit the figures are those of the limit: there is no other truth.
        let at = self.motion.within(state.at);
        let order = order.min(state.order);
        if let (Some(engine), Some(whole)) = (&self.at_once, &mut enclosure.at_once)
            && engine.enclose_to(at, order, state, whole)
        {
            enclosure.state.take_over(whole, engine);
            self.engine.enclose_helpers(&mut enclosure.state);
            self.enclose_forces(order, state, enclosure);
            return;
        }
        self.engine.enclose_to(at, order, state, enclosure);
        self.enclose_forces(order, state, enclosure);
    }

    fn enclose_forces(&self, order: Order, state: &mut State, enclosure: &mut Workspace<Ball>) {
        Balance::enclose(
            self.balance.as_deref(),
            &self.engine,
            order,
            state,
            enclosure,
        );
    }
}

impl State<Ball> {
    /// Takes what belongs to the mechanism from a state of another program of it.
    fn take_over(&mut self, from: &State<Ball>, engine: &Engine) {
        self.begin(from.at, from.order);
        self.condition = from.condition;
        let named = engine.named_points;
        self.points[..named].copy_from_slice(&from.points[..named]);
        self.links.copy_from_slice(&from.links);
        self.travels.copy_from_slice(&from.travels);
    }
}

impl Dyad<'_> {
    /// Positions alone, where the assemblies are too close to be told apart.
    #[cold]
    fn enclose_stretched(self, enclosure: &mut State<Ball>) -> bool {
        match self {
            Dyad::Circles(c) => c.enclose_stretched(enclosure),
            Dyad::CircleLine(c) => c.enclose_stretched(enclosure),
            Dyad::CircleRail(c) => c.enclose_stretched(enclosure),
            Dyad::Swing(s) => s.enclose_stretched(enclosure),
            Dyad::Cylinder(_) => false,
        }
    }
}

impl Engine {
    fn enclosure(&self, slides: usize) -> Workspace<Ball> {
        let mut enclosure: Workspace<Ball> = self.state(slides);
        let groups = self.program.coupled.iter();
        let work = groups.map(|g| g.work()).max().unwrap_or(0);
        enclosure.scratch.work = vec![0.0; work];
        enclosure
    }

    /// The points of the program's own that ride on links: what was proved of the mechanism carries them.
    fn enclose_helpers(&self, enclosure: &mut State<Ball>) {
        let (q, direction) = self.coordinate(enclosure.at);
        for step in &self.program.steps {
            if matches!(step, Step::Ride { point, .. } if point.index() >= self.named_points) {
                step.run::<Ball, ACCELERATION>(q, direction, enclosure);
            }
        }
    }

    /// Encloses a state; whether every step was proved, with its rates.
    fn enclose_to(&self, at: f64, order: Order, state: &State, work: &mut Workspace<Ball>) -> bool {
        let enclosure = &mut work.state;
        enclosure.begin(Ball::new(at, typed_radius(at)), order);
        enclosure.condition = state.condition;
        if state.condition == Condition::NoAssembly {
            return false;
        }
        for (ball, &sign) in enclosure.signs.iter_mut().zip(&state.signs) {
            *ball = Ball::exactly(sign);
        }
        match order {
            Order::Position => self.enclose::<POSITION>(state, work),
            Order::Velocity => self.enclose::<VELOCITY>(state, work),
            Order::Acceleration | Order::Force => self.enclose::<ACCELERATION>(state, work),
        }
    }

    fn enclose<const ORDER: u8>(&self, state: &State, work: &mut Workspace<Ball>) -> bool {
        let Workspace {
            state: enclosure,
            scratch,
            ..
        } = work;
        let (q, direction) = self.coordinate(enclosure.at);
        let mut all = true;
        for step in &self.program.steps {
            let proved = match step {
                Step::Circles(c) => c.enclose::<ORDER>(state, enclosure),
                Step::CircleLine(c) => c.enclose::<ORDER>(state, enclosure),
                Step::CircleRail(c) => c.enclose::<ORDER>(state, enclosure),
                Step::Cylinder(c) => c.enclose::<ORDER>(q, state, enclosure),
                Step::Swing(s) => s.enclose::<ORDER>(state, enclosure),
                Step::Coupled { index } => {
                    self.program.coupled[*index].enclose(q, ORDER, state, enclosure, scratch)
                }
                Step::Crank { .. }
                | Step::Spin { .. }
                | Step::Ride { .. }
                | Step::Push { .. }
                | Step::Aim { .. }
                | Step::Lock { .. }
                | Step::Lines { .. }
                | Step::Travel { .. } => {
                    step.run::<Ball, ORDER>(q, direction, enclosure) == Outcome::Done
                }
            };
            all &= proved;
            let stretched = |dyad: Dyad<'_>| dyad.enclose_stretched(enclosure);
            if !proved && !step.dyad().is_some_and(stretched) {
                self.forget(step, enclosure);
            }
        }
        all
    }

    /// Nothing is known of what a step places.
    #[cold]
    fn forget(&self, step: &Step, enclosure: &mut State<Ball>) {
        let point = |p: PointId, enclosure: &mut State<Ball>| {
            let nowhere = Vec2::new(UNKNOWN, UNKNOWN);
            let place = &mut enclosure.points[p.index()];
            (place.p, place.v, place.a) = (nowhere, nowhere, nowhere);
        };
        let link = |l: LinkId, enclosure: &mut State<Ball>| {
            let link = &mut enclosure.links[l.index()];
            (link.d, link.w, link.a) = (Vec2::new(UNKNOWN, UNKNOWN), UNKNOWN, UNKNOWN);
        };
        let outputs = step.dyad().map(Dyad::outputs);
        let (placed, turned) = outputs.unwrap_or_default();
        placed.into_iter().for_each(|p| point(p, enclosure));
        turned
            .into_iter()
            .flatten()
            .for_each(|l| link(l, enclosure));
        match step {
            Step::Lines { point: p, .. } => point(*p, enclosure),
            Step::Coupled { index } => {
                let group = &self.program.coupled[*index];
                group.joints().for_each(|p| point(p, enclosure));
                group.turning().iter().for_each(|&l| link(l, enclosure));
            }
            Step::Circles(_)
            | Step::CircleLine(_)
            | Step::CircleRail(_)
            | Step::Cylinder(_)
            | Step::Swing(_)
            | Step::Crank { .. }
            | Step::Spin { .. }
            | Step::Ride { .. }
            | Step::Push { .. }
            | Step::Aim { .. }
            | Step::Lock { .. }
            | Step::Travel { .. } => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Double;
    use crate::scene::{Scene, presets};

    /// The balls come from the residuals of whatever is in the state: where that is far off, they
    /// must hold the truth all the same, and not by being wide.
    #[test]
    fn a_state_that_is_off_is_brought_back_to_the_truth() {
        const OFF: f64 = 1e-8;
        for preset in presets::all() {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap();
            let (mut state, mut balls) = (solver.state(), solver.enclosure());
            let mut truth = solver.twice();
            let at = scene.mechanism.driver().start;
            let _ = solver.solve(at, Order::Position, &mut state);
            assert!(solver.solve_twice(&state, Order::Position, &mut truth));
            let off = |k: usize| OFF * (1.0 + k as f64).sin();
            for (k, point) in state.state.points.iter_mut().enumerate() {
                point.p += Vec2::new(off(2 * k), off(2 * k + 1));
            }
            for (k, link) in state.state.links.iter_mut().enumerate() {
                link.d = link.d.turned(crate::angle::unit(off(3 * k).to_degrees()));
            }
            for group in &solver.engine.program.coupled {
                // Its joints; its directions must stay unit vectors.
                for k in 0..group.width() - 2 * group.turning().len() {
                    state.scratch.numbers[group.offset + k] += off(k);
                }
            }
            solver.enclose(&mut state, Order::Position, &mut balls);
            let check = |ball: Ball, truth: Double, of: &str| {
                let miss = (truth - Double::exactly(ball.mid)).abs().hi;
                assert!(
                    miss <= ball.radius,
                    "{} {of}: {miss:e} {ball:?}",
                    preset.name
                );
                // Of the second order of what it was off by, but for a chain of many dyads, each of
                // which widens what it is given.
                let is_long = solver.plan.groups.len() > 8;
                assert!(
                    is_long || ball.radius < 0.1 * OFF,
                    "{} {of}: {ball:?}",
                    preset.name
                );
            };
            for point in scene.mechanism.point_ids() {
                let (ball, truth) = (&balls.points[point.index()], &truth.points[point.index()]);
                check(ball.p.x, truth.p.x, "x");
                check(ball.p.y, truth.p.y, "y");
            }
            for link in scene.mechanism.link_ids() {
                let (ball, truth) = (&balls.links[link.index()], &truth.links[link.index()]);
                check(ball.d.x, truth.d.x, "cos");
                check(ball.d.y, truth.d.y, "sin");
            }
        }
    }
}
