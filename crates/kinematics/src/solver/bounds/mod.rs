//! Bounds the errors of a solved state.
//!
//! The values of a state come from fast formulas. Here each group is checked independently of them.
//! The residuals of its constraints and of their rates are evaluated at the computed state, in
//! double-double, and multiplied by the inverse of the group's own matrix. This gives the
//! first-order correction with its sign, which is passed on to the later groups. The remainder is
//! of second order, apart from uncertain typed digits, and is bounded by a few numbers for each
//! group. In long chains it is propagated by the influence of each constraint on its dependents, so
//! that it does not widen. Both take one pass in plan order. The existence of a solution there is
//! proved group by group. The bounds do not depend on how a value was computed.
//!
//! Rarer steps (some dyads with guides, driven slides, coupled groups) are run again in
//! double-double. So are the forces, which take one backward pass.
//!
//! The bounds hold for the scene as given: a number such as 39.3 means the typed decimal, stored to
//! half an ulp. The difference between the decimal and its double is known with its sign: residuals
//! are computed from the decimals. The bounds hold for the assembly near the computed value. They
//! rely on a correctly rounded square root and on an arctangent accurate to an ulp.

mod dependent_points;
mod driver;
mod dyads;
mod edge;
mod errors;
mod influence;
mod link_vector;
mod loaded_state;
mod meeting;
mod near_limit_dyad;
mod off;
mod rail;
mod shape;
mod two_point_link;

pub(super) use errors::Errors;

use super::coupled::{Scratch, Views};
use super::elements::{
    ACCELERATION, Aim, Crank, Dyad, Lock, POSITION, Ride, Spin, Step, StepOutcome, VELOCITY,
};
use super::engine::Engine;
use super::forces::Balance;
use super::plan::pruning::PlacedPart;
use super::state::{Condition, LinkState, PointState, State};
use super::{Order, Solver, Workspace};
use crate::arithmetic::plane::Simd;
use crate::arithmetic::{Fusing, Sharp, fused, plainly};
use crate::{Ball, Double, Number, Vec2};
use driver::CrankDirection;
pub(super) use driver::IntendedCoordinate;
use loaded_state::Bodies;
use off::LinkOff;

/// An unbounded ball, for unknown values.
const UNKNOWN: Ball = Ball {
    mid: 0.0,
    radius: f64::INFINITY,
};

impl Solver {
    /// Creates a workspace for a state with bounds.
    #[must_use]
    pub fn enclosure(&self) -> Workspace<Ball> {
        let engine = self.best_engine();
        let mut enclosure = self.workspace_for(engine);
        let groups = engine.program.coupled.iter();
        let work = groups.map(|g| g.work()).max().unwrap_or(0);
        enclosure.scratch.work = vec![0.0; work];
        enclosure.errors = Errors::new(&self.engine, engine, self.workspace_for(engine));
        enclosure.errors.edge = self.close_state().map(Box::new);
        enclosure.errors.is_decimal = self.mechanism.has_decimals();
        enclosure
    }

    /// Encloses the state that the solver has just computed in `work`. Every value read from
    /// `enclosure` is a ball that contains the true value; its radius is infinite if that cannot be
    /// proved. It goes up to `order`, or to the order of the state if lower. Allocates nothing.
    ///
    /// For forces, the bounds of the misfit of their checks decide whether rounding explains it. If
    /// it does not, the state in `work` withholds its forces.
    pub fn enclose(
        &self,
        workspace: &mut Workspace,
        order: Order,
        enclosure: &mut Workspace<Ball>,
    ) {
        let state = &mut workspace.state;
        let order = order.min(state.order);
        let engine = self.best_engine();
        let is_clear = self.motion.is_clear(state.at);
        let proved = is_clear && engine.enclose_to(Vicinity::Clear, order, state, enclosure);
        if !proved {
            if self.solve_edge_closely(order, state, enclosure) {
                engine.enclose_to(Vicinity::Edge, order, state, enclosure);
            } else if !is_clear {
                engine.enclose_to(Vicinity::NearEnd, order, state, enclosure);
            }
        }
        self.enclose_forces(order, state, enclosure);
    }

    /// Returns the engine with the most accurate numbers: typed decimals in double-double if
    /// available, so that the error of their doubles is known with its sign.
    fn best_engine(&self) -> &Engine {
        let exact = self.exact.as_ref().filter(|_| self.mechanism.is_typed());
        exact.map_or(&self.engine, |exact| &exact.engine)
    }

    /// Returns the intended coordinate. Close to an end of the motion it is the double itself.
    pub(super) fn intended_coordinate(&self, at: f64) -> Double {
        if self.mechanism.has_decimals() && self.motion.is_clear(at) {
            IntendedCoordinate::of::<false>(at).close(at)
        } else {
            Double::exactly(at)
        }
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

/// Computes the travel of a slide.
fn travel<T: Number>(step: &Step, order: u8, state: &mut State<T>) {
    let _ = step.run_to(order, (T::default(), Vec2::default()), state);
}

impl State<Sharp> {
    /// Copies an enclosed part from balls.
    fn sharpen(&mut self, part: PlacedPart, balls: &State<Ball>) {
        let vector = |v: Vec2<Ball>| v.map(Sharp::from);
        match part {
            PlacedPart::Point(point) => {
                let PointState { p, v, a } = balls.points[point.index()];
                let [p, v, a] = [p, v, a].map(vector);
                self.points[point.index()] = PointState { p, v, a };
            }
            PlacedPart::Link(link) => {
                let LinkState { d, w, a } = balls.links[link.index()];
                let (d, [w, a]) = (vector(d), [w, a].map(Sharp::from));
                self.links[link.index()] = LinkState { d, w, a };
            }
            PlacedPart::Slide(_) => {}
        }
    }
}

impl Dyad<'_> {
    /// Encloses positions only, where the two assemblies are too close to distinguish.
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

/// The position of a state within its motion.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Vicinity {
    /// Far from the ends of the range.
    Clear,
    /// Near an end of the range, or possibly near.
    NearEnd,
    /// Near an end, with all steps run in double-double.
    Edge,
}

/// The data for bounding one state.
struct Enclosing<'a> {
    engine: &'a Engine,
    how: (Vicinity, Order),
    state: &'a State,
    workspace: &'a mut Workspace<Ball>,
}

/// Passed by reference: a copy would reload recent small stores in larger pieces, which is slow.
impl Fusing for &mut Enclosing<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<S: Simd, const FUSED: bool>(self, simd: S) -> bool {
        let Enclosing {
            engine,
            how,
            state,
            workspace: work,
        } = self;
        engine.enclose_here::<S, FUSED>(simd, *how, state, work)
    }
}

impl Engine {
    /// Encloses a state; at the edge, by the double-double results of its steps. Returns `true` if
    /// everything was proved.
    fn enclose_to(
        &self,
        vicinity: Vicinity,
        order: Order,
        state: &State,
        workspace: &mut Workspace<Ball>,
    ) -> bool {
        workspace.state.condition = state.condition;
        if state.condition == Condition::NoAssembly {
            let requested = workspace.errors.intended::<false>(state.at, false);
            workspace
                .state
                .start(Ball::new(state.at, requested.max_distance()), order);
            return true;
        }
        // Runs with the machine's vectors and, if available, fused multiply-add; the bits are the
        // same. Long chains run separate plain code, so that their additional work does not slow
        // down short ones.
        let is_long = workspace.errors.influences.is_long();
        let mut enclosing = Enclosing {
            engine: self,
            how: (vicinity, order),
            state,
            workspace,
        };
        if is_long {
            plainly(&mut enclosing)
        } else {
            fused(&mut enclosing)
        }
    }

    #[inline(always)]
    fn enclose_here<S: Simd, const FUSED: bool>(
        &self,
        simd: S,
        (vicinity, order): (Vicinity, Order),
        state: &State,
        workspace: &mut Workspace<Ball>,
    ) -> bool {
        let enclosure = &mut workspace.state;
        let errors = &mut workspace.errors;
        let requested = errors.intended::<FUSED>(state.at, vicinity == Vicinity::Clear);
        enclosure.start(Ball::new(state.at, requested.max_distance()), order);
        errors.start(order == Order::Force);
        let order = match order {
            Order::Position => POSITION,
            Order::Velocity => VELOCITY,
            Order::Acceleration | Order::Force => ACCELERATION,
        };
        let heading = if self.is_rotary {
            CrankDirection::at::<FUSED>(
                state.at,
                requested,
                errors.influences.is_long_chain::<FUSED>(),
            )
        } else {
            CrankDirection::NONE
        };
        let mut all = true;
        for step in &self.program.steps {
            if vicinity == Vicinity::Edge && !matches!(step, Step::SlideReadout(_)) {
                step.outputs(&self.program.coupled, &mut |part| {
                    errors.take_edge(part, state, enclosure);
                });
                continue;
            }
            let proved = match *step {
                Step::Circles(ref c) => {
                    c.enclose::<_, FUSED>(simd, order, state, errors, enclosure)
                }
                Step::CircleRail(ref c) => {
                    c.enclose::<_, FUSED>(simd, order, state, errors, enclosure)
                }
                Step::Crank(Crank { link }) => {
                    let crank = &state.links[link.index()];
                    let error = LinkOff::of(simd, &heading.error_of(crank.d));
                    let enclosed = error.enclosed(&Bodies::of(simd, crank));
                    errors.set_link(link, &enclosed, state, enclosure);
                    true
                }
                Step::Spin(Spin { point, local, .. }) => {
                    let spun = (&heading, local);
                    errors.spin::<_, FUSED>(simd, point, spun, state, enclosure);
                    true
                }
                Step::Ride(Ride {
                    point,
                    base,
                    link,
                    local,
                }) => {
                    let points = [point, base];
                    let on = (link, local);
                    errors.ride::<_, FUSED>(simd, order, points, on, state, enclosure);
                    true
                }
                Step::Aim(Aim { ref arm, end }) => {
                    errors.aim_at::<_, FUSED>(simd, order, arm, end, state, enclosure)
                }
                Step::Lock(Lock { link, to, turn }) => {
                    errors.lock([link, to], turn, state, enclosure);
                    true
                }
                Step::SlideReadout(_) => {
                    travel(step, order, enclosure);
                    errors.travel(step, order);
                    true
                }
                // Steps without residuals of their own.
                _ => {
                    let scratch = &mut workspace.scratch;
                    self.enclose_closely(
                        (step, order, requested),
                        state,
                        enclosure,
                        errors,
                        scratch,
                    )
                }
            };
            if !proved {
                self.enclose_loosely(step, state, enclosure, errors);
            }
            all &= proved;
        }
        all
    }

    /// Runs a step in double-double. Returns `true` if that succeeded.
    fn enclose_closely(
        &self,
        (step, order, requested): (&Step, u8, IntendedCoordinate),
        state: &State,
        enclosure: &mut State<Ball>,
        errors: &mut Errors,
        scratch: &mut Scratch<Ball>,
    ) -> bool {
        let Some(mut sharp) = errors.sharp.take() else {
            return false;
        };
        let exact = Sharp::new(requested.close(state.at), requested.radius);
        let (q, _) = self.coordinate(exact);
        if let Some(group) = step.choice() {
            sharp.state.signs[group] = Sharp::exactly(state.signs[group]);
        }
        let proved = if let Some(index) = step.coupled() {
            let ball = Ball::new(q.mid.hi, q.radius + q.mid.lo.abs());
            let mut views = Views {
                balls: (enclosure, scratch),
                sharp: (&mut sharp.state, &mut sharp.scratch),
            };
            self.program.coupled[index].enclose((ball, q), order, state, &mut views)
        } else {
            let driven = self.driven().map(|link| sharp.state.links[link.index()].d);
            let direction = driven.unwrap_or(Vec2::X.exactly());
            step.run_to(order, (q, direction), &mut sharp.state) == StepOutcome::Done
        };
        if proved {
            step.outputs(&self.program.coupled, &mut |part| {
                errors.take(part, &sharp.state, state, enclosure);
            });
        }
        errors.sharp = Some(sharp);
        proved
    }

    /// Encloses the results of a step for which nothing could be proved: positions only, if it is a
    /// dyad at its limit.
    #[cold]
    fn enclose_loosely(
        &self,
        step: &Step,
        state: &State,
        enclosure: &mut State<Ball>,
        errors: &mut Errors,
    ) {
        let stretched = |dyad: Dyad<'_>| dyad.enclose_stretched(enclosure);
        if !step.dyad().is_some_and(stretched) {
            self.forget(step, enclosure);
        }
        let Some(mut sharp) = errors.sharp.take() else {
            return;
        };
        step.outputs(&self.program.coupled, &mut |part| {
            sharp.state.sharpen(part, enclosure);
            errors.take(part, &sharp.state, state, enclosure);
        });
        errors.sharp = Some(sharp);
    }

    /// Marks the results of a step as unknown.
    fn forget(&self, step: &Step, enclosure: &mut State<Ball>) {
        let nowhere = Vec2::new(UNKNOWN, UNKNOWN);
        step.outputs(&self.program.coupled, &mut |part| match part {
            PlacedPart::Point(point) => {
                let place = &mut enclosure.points[point.index()];
                (place.p, place.v, place.a) = (nowhere, nowhere, nowhere);
            }
            PlacedPart::Link(link) => {
                let link = &mut enclosure.links[link.index()];
                (link.d, link.w, link.a) = (nowhere, UNKNOWN, UNKNOWN);
            }
            PlacedPart::Slide(_) => {}
        });
    }
}

#[cfg(any(test, feature = "testing"))]
pub(super) mod testing;
