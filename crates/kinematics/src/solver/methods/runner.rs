//! Runs a method: solves one position after another and keeps the data needed between them.

use super::{Deviation, Method, Methods, RowProgram, Start, follow, run};
use crate::solver::Workspace;
use crate::solver::elements::ACCELERATION;
use crate::solver::state::State;
use crate::solver::{Condition, Order};
use crate::{Ball, Double, Number};

/// A method with all its workspace: solving allocates nothing.
pub struct Runner {
    work: RunnerWork,
}

#[expect(
    clippy::large_enum_variant,
    reason = "there are a score of them, each made once"
)]
enum RunnerWork {
    /// The solver's own method.
    Solver(Workspace),
    Bounded {
        state: Workspace,
        enclosure: Workspace<Ball>,
    },
    Single {
        guide: Workspace,
        state: Workspace<f32>,
    },
    Polished {
        closed: Workspace,
        state: Workspace,
        exact: Workspace<Double>,
    },
    Newton {
        state: Workspace,
        tolerance: f64,
        start: Start,
        /// The steps of all groups at the last position.
        steps: u32,
    },
    Bisection {
        state: Workspace,
        /// The signs of the dyads in closed form, which show the side of a change point.
        signs: Vec<f64>,
        /// The bisection steps of all groups at the last position.
        halvings: u32,
    },
}

impl Methods {
    /// Creates a runner of a usable method that solves positions; returns `None` for any other.
    pub fn runner(&self, method: Method) -> Option<Runner> {
        self.usable(method).ok()?;
        let rows = || {
            self.rows
                .as_ref()
                .map(|rows| rows.engine.state(self.slides))
        };
        let work = match method {
            Method::ClosedForm | Method::Anchored => RunnerWork::Solver(self.solver.state()),
            Method::Bounded => RunnerWork::Bounded {
                state: self.solver.state(),
                enclosure: self.solver.enclosure(),
            },
            Method::Single => RunnerWork::Single {
                guide: self.solver.state(),
                state: self.solver.engine.state(self.slides),
            },
            Method::Polished => RunnerWork::Polished {
                closed: self.solver.state(),
                state: rows()?,
                exact: self.rows.as_ref()?.engine.state(self.slides),
            },
            Method::Newton { tolerance, start } => RunnerWork::Newton {
                state: rows()?,
                tolerance,
                start,
                steps: 0,
            },
            Method::Bisection => RunnerWork::Bisection {
                state: rows()?,
                signs: self.solver.engine.signs.clone(),
                halvings: 0,
            },
            Method::Integration { .. } => return None,
        };
        Some(Runner { work })
    }
}

impl Runner {
    /// Sets a method that continues from the previous position to the state looked up last.
    pub fn start(&mut self, methods: &Methods) {
        if let (RunnerWork::Newton { state, .. }, Some(rows)) = (&mut self.work, &methods.rows) {
            for group in &rows.engine.program.coupled {
                group.read(&methods.guide, group.open(&mut state.scratch).z);
            }
        }
    }

    /// Solves for the driver's coordinate. Returns `true` if the method found a solution.
    pub fn solve(&mut self, methods: &Methods, at: f64) -> bool {
        let Methods { solver, rows, .. } = methods;
        match (&mut self.work, rows) {
            (RunnerWork::Solver(state), _) => {
                solver.solve(at, Order::Acceleration, state) == Condition::Ok
            }
            (RunnerWork::Bounded { state, enclosure }, _) => {
                let solved = solver.solve(at, Order::Acceleration, state) == Condition::Ok;
                solver.enclose(state, Order::Acceleration, enclosure);
                solved
            }
            (RunnerWork::Single { guide, state }, _) => single(methods, at, guide, state),
            (
                RunnerWork::Polished {
                    closed,
                    state,
                    exact,
                },
                Some(rows),
            ) => {
                solver.solve(at, Order::Position, closed) == Condition::Ok
                    && polished(rows, at, closed, state, exact)
            }
            (
                RunnerWork::Newton {
                    state,
                    tolerance,
                    start,
                    steps,
                },
                Some(rows),
            ) => {
                *steps = 0;
                if *start == Start::Cold {
                    state.scratch.numbers.copy_from_slice(&rows.opening.numbers);
                }
                run::<_, ACCELERATION>(&rows.engine, at, state, |group, q, state, scratch| {
                    let own = group.newton(q, *tolerance, state, scratch);
                    *steps += own.unwrap_or(0);
                    own.is_some()
                })
            }
            (
                RunnerWork::Bisection {
                    state,
                    signs,
                    halvings,
                },
                Some(rows),
            ) => {
                *halvings = 0;
                solver.motion.crossings.choose(&solver.engine, at, signs);
                let mut closings = rows.closings.iter().enumerate();
                run::<_, ACCELERATION>(&rows.engine, at, state, |group, q, state, scratch| {
                    let own = closings.next().and_then(|(number, closing)| {
                        let side = group.side * rows.flip(number, solver, signs);
                        closing
                            .as_ref()
                            .and_then(|way| group.bisect(way, side, q, state, scratch))
                    });
                    *halvings += own.unwrap_or(0);
                    own.is_some()
                })
            }
            (
                RunnerWork::Polished { .. }
                | RunnerWork::Newton { .. }
                | RunnerWork::Bisection { .. },
                None,
            ) => false,
        }
    }

    /// Returns the deviation of the last result from the state looked up last. Returns `None` if it
    /// has another assembly, or if a required bound was not proved.
    pub fn deviation(&mut self, methods: &mut Methods) -> Option<Deviation> {
        if let RunnerWork::Newton { state, .. } | RunnerWork::Bisection { state, .. } =
            &mut self.work
            && !methods.is_same_assembly(state)
        {
            return None;
        }
        let (subjects, reference) = (&methods.subjects, &methods.reference);
        if let RunnerWork::Bounded { enclosure, .. } = &self.work
            && !subjects.hold(enclosure, reference)
        {
            return None;
        }
        Some(match &self.work {
            RunnerWork::Single { state, .. } => subjects.deviation(state, reference),
            RunnerWork::Solver(state)
            | RunnerWork::Bounded { state, .. }
            | RunnerWork::Polished { state, .. }
            | RunnerWork::Newton { state, .. }
            | RunnerWork::Bisection { state, .. } => subjects.deviation(state, reference),
        })
    }

    /// Returns the steps of all groups at the last position, for a method that counts them.
    pub fn iterations(&self) -> Option<u32> {
        match &self.work {
            RunnerWork::Newton { steps, .. } => Some(*steps),
            RunnerWork::Bisection { halvings, .. } => Some(*halvings),
            RunnerWork::Solver(_)
            | RunnerWork::Bounded { .. }
            | RunnerWork::Single { .. }
            | RunnerWork::Polished { .. } => None,
        }
    }
}

/// Solves the closed forms in single precision, coupled groups from the solver's anchors. The
/// assembly is that of the solver, which selects it without solving anything.
fn single(methods: &Methods, at: f64, guide: &mut Workspace, state: &mut Workspace<f32>) -> bool {
    /// Tolerance above the rounding errors of single precision, below which Newton steps no longer
    /// shrink.
    const TOLERANCE: f64 = 1e-5;
    let solver = &methods.solver;
    solver.motion.anchors.predict(&solver.engine, at, guide);
    solver
        .motion
        .crossings
        .choose(&solver.engine, at, &mut guide.state.signs);
    follow(guide, state);
    let at = f32::exactly(at);
    run::<_, ACCELERATION>(&solver.engine, at, state, |group, q, state, scratch| {
        group.newton(q, TOLERANCE, state, scratch).is_some()
    })
}

/// Corrects the closed form group by group, each from the corrected positions of the groups before.
fn polished(
    rows: &RowProgram,
    at: f64,
    closed: &State,
    state: &mut Workspace,
    exact: &mut Workspace<Double>,
) -> bool {
    let Workspace {
        state: exact,
        scratch: fine,
        ..
    } = exact;
    let mut inputs = rows.inputs.iter();
    run::<_, ACCELERATION>(&rows.engine, at, state, |group, q, state, scratch| {
        let (points, links) = inputs.next().map_or((&[][..], &[][..]), |(p, l)| (p, l));
        for point in points {
            exact.points[point.index()].p = state.points[point.index()].p.exactly();
        }
        for link in links {
            exact.links[link.index()].d = state.links[link.index()].d.exactly();
        }
        group.read(closed, group.open(scratch).z);
        group.polish(q, state, scratch, exact, fine)
    })
}
