//! Runs steps in double-double with error bounds, from the typed decimals, coupled groups included.

use crate::arithmetic::Sharp;
use crate::solver::coupled::Views;
use crate::solver::elements::{ACCELERATION, POSITION, Step, StepOutcome};
use crate::solver::engine::Engine;
use crate::solver::exact::Exact;
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, PointState, State};
use crate::solver::workspace::Workspace;
use crate::{Ball, Number, Vec2};

/// The memory of such a run, and its result.
pub(in crate::solver) struct ProvedRun<'e> {
    pub(in crate::solver) engine: &'e Engine,
    pub(in crate::solver) sharp: Workspace<Sharp>,
    pub(in crate::solver) balls: Workspace<Ball>,
}

impl<'e> ProvedRun<'e> {
    pub(in crate::solver) fn new(exact: &'e Exact, slides: usize) -> ProvedRun<'e> {
        let engine = &exact.engine;
        let mut balls: Workspace<Ball> = engine.state(slides);
        let work = engine.program.coupled.iter().map(|group| group.work());
        balls.scratch.work = vec![0.0; work.max().unwrap_or(0)];
        ProvedRun {
            engine,
            sharp: engine.state(slides),
            balls,
        }
    }

    /// Runs the first `steps` steps, with derivatives if `has_rates`. Returns `true` if all could
    /// be proved. `state` contains the solution in doubles, near the coordinate.
    pub(in crate::solver) fn run(
        &mut self,
        steps: usize,
        at: Sharp,
        has_rates: bool,
        state: &State,
    ) -> bool {
        for (sign, &of) in self.sharp.state.signs.iter_mut().zip(&state.signs) {
            *sign = Sharp::exactly(of);
        }
        let (q, direction) = self.engine.coordinate(at);
        (0..steps).all(|step| {
            let proved = self.step(step, (q, direction), has_rates, state);
            proved && self.widen(step)
        })
    }

    /// Returns a dyad's measure at a coordinate, from its inputs. The dyad itself may be open.
    pub(in crate::solver) fn measure(&mut self, step: usize, group: usize, at: Sharp) -> Sharp {
        let (q, direction) = self.engine.coordinate(at);
        let step = &self.engine.program.steps[step];
        let _ = step.run_to(POSITION, (q, direction), &mut self.sharp.state);
        self.sharp.state.measures[group]
    }

    fn step(
        &mut self,
        step: usize,
        (q, direction): (Sharp, Vec2<Sharp>),
        has_rates: bool,
        state: &State,
    ) -> bool {
        let program = &self.engine.program;
        let step: &Step = &program.steps[step];
        let sharp = &mut self.sharp;
        let outcome = match step.coupled() {
            Some(index) => {
                let order = if has_rates { ACCELERATION } else { POSITION };
                let mut views = Views {
                    balls: (&self.balls.state, &mut self.balls.scratch),
                    sharp: (&mut sharp.state, &mut sharp.scratch),
                };
                let q = (Ball::from(q), q);
                return program.coupled[index].enclose(q, order, state, &mut views);
            }
            None => {
                let order = if has_rates { ACCELERATION } else { POSITION };
                step.run_to(order, (q, direction), &mut sharp.state)
            }
        };
        outcome == StepOutcome::Done
    }

    /// Copies the results of a step to the balls.
    fn widen(&mut self, step: usize) -> bool {
        let (from, to) = (&self.sharp.state, &mut self.balls.state);
        let vector = |v: Vec2<Sharp>| v.map(Ball::from);
        let program = &self.engine.program;
        program.steps[step].outputs(&program.coupled, &mut |part| match part {
            PlacedPart::Point(point) => {
                let PointState { p, v, a } = from.points[point.index()];
                let [p, v, a] = [p, v, a].map(vector);
                to.points[point.index()] = PointState { p, v, a };
            }
            PlacedPart::Link(link) => {
                let LinkState { d, w, a } = from.links[link.index()];
                let [w, a] = [w, a].map(Ball::from);
                to.links[link.index()] = LinkState { d: vector(d), w, a };
            }
            PlacedPart::Slide(_) => {}
        });
        true
    }
}
