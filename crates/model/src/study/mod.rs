//! Compares speed and accuracy of every method that can solve a mechanism.
//!
//! A [`Study`] proceeds in small pieces, so that its caller can show progress, react to keys or
//! stop; the results so far are available at any time. First, all methods are compared with a
//! reference of twice the precision, position by position. Then they are timed in rounds, so that
//! other load on the machine affects all of them equally. The integrations run last.
//!
//! This module solves nothing itself: the methods are the solver's, on the same equations. The
//! caller supplies the clock, and the results contain no text.

mod cycle;
mod design;
mod excursion;
mod exercise;
mod findings;
mod grading;
mod iterations;
mod method_cost;
pub mod motor;
mod pareto_front;
mod rk4;
mod spread;
mod tolerance;

pub use crate::solver::{Method, Start, Unsuitable};
pub use design::{
    BestDesign, Design, DesignFigures, DesignPlan, DesignRow, DesignRun, DesignSpace, DesignState,
    FoundDesign, Goal, GoalSearch, GoalSense, MistypedAxis, MistypedGoal, NoDesign, OptimiseOrder,
    OptimiseState, PlanAxis, SearchOutcome,
};
pub use excursion::{
    CycleFigure, CycleFigures, DEFAULT_DWELL, DwellStretch, Excursion, ExcursionOptions,
    ExtremumPlace, FigurePlace, NoFigure, TimeRatio, UnknownCycleFigure, changing,
};
pub use exercise::{Exercise, ExerciseMaker, ExerciseTitles};
pub use findings::{
    Finding, Findings, IterationCounts, MethodErrors, MethodFigures, MethodVerdict,
};
pub use grading::{
    AnswerKey, ChainGroup, ChainSlot, ChainValues, FigureVerdict, GivenAnswer, LinkPoints,
    MisreadValue, RequiredValue, RoundedEarly, SheetScene, SolutionChain, WrittenFigure,
};
pub use iterations::{
    Bisection, ErrorCurve, Halving, LoopSum, LoopSystem, NewtonIteration, NewtonOutcome,
    NewtonTrace, UnknownKind, UnknownVector, VectorPart, half_turn,
};
pub use spread::Spread;
pub use tolerance::{
    BandKind, Contribution, Distribution, MotionTolerance, Offsets, Percentiles, SampleOrder,
    Samples, ToleranceError, ToleranceFigure, ToleranceOf, ToleranceStudy, WorstCase, WorstKind,
};

use crate::solver::{Deviation, Methods, Range, Runner, Solver};
use cycle::IntegrationCycle;
use method_cost::{Stopwatch, Tally};
use std::hint::black_box;
use std::time::Duration;

/// Default number of positions, per 360 degrees or over the range.
pub const DEFAULT_POSITIONS: u32 = 3600;

/// Number of time samples per method.
const SAMPLES: usize = 21;

/// Tolerances of Newton's method.
const TOLERANCES: [f64; 5] = [1e-3, 1e-6, 1e-9, 1e-12, 1e-14];
/// Steps of an integration per 360 degrees.
const STEPS: [u16; 3] = [36, 360, 3600];
/// The number of cycles of an integration, by the maximum number of unknowns. The error is measured
/// in the last cycle. Each step has a cost per unknown, and a study should take some seconds.
const CYCLES: [(usize, u16); 2] = [(10, DEFAULT_CYCLES), (20, 100)];
const MIN_CYCLES: u16 = 10;
/// The number of cycles of a mechanism with few unknowns.
pub const DEFAULT_CYCLES: u16 = 1000;

/// The progress when the errors are known, and when the times are known too, as measured on the
/// four-bar of the lectures.
const ERRORS_PROGRESS: f64 = 0.1;
const TIMES_PROGRESS: f64 = 0.25;

/// Returns all methods in the order of their letters; the integrations run through one cycle and
/// through `cycles`.
#[must_use]
pub fn all_methods(cycles: u16) -> Vec<Method> {
    let newton = |start| TOLERANCES.map(|tolerance| Method::Newton { tolerance, start });
    let integration = |steps| [1, cycles].map(|turns| Method::Integration { steps, turns });
    let closed = [
        Method::ClosedForm,
        Method::Anchored,
        Method::Bounded,
        Method::Polished,
        Method::Single,
    ];
    let mut methods = closed.to_vec();
    methods.extend([Start::Warm, Start::Cold].into_iter().flat_map(newton));
    methods.push(Method::Bisection);
    methods.extend(STEPS.into_iter().flat_map(integration));
    methods
}

/// A method and its measurements.
struct Contender {
    method: Method,
    work: StudyWork,
    tally: Tally,
    watch: Stopwatch,
}

enum StudyWork {
    Unsuitable(Unsuitable),
    /// Solves positions; `next` is the next one to time.
    Solves {
        runner: Box<Runner>,
        next: usize,
    },
    /// Integrates through cycles; `None` before its beginning, and if it cannot begin.
    Integrates(Option<Box<IntegrationCycle>>),
}

/// The next piece of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum StudyStage {
    Errors { place: usize },
    Times { round: usize, contender: usize },
    Cycles { contender: usize },
    Done,
}

/// A study of the methods that can solve a mechanism.
pub struct Study {
    methods: Methods,
    contenders: Vec<Contender>,
    /// The positions in the order of visit.
    coordinates: Vec<f64>,
    /// The positions at which the reference exists.
    sound: Vec<f64>,
    /// `true` if methods that start from the previous position must be reset.
    anew: bool,
    /// The largest velocity and acceleration.
    sizes: Deviation,
    stage: StudyStage,
}

impl Study {
    /// Creates a study of all methods at `positions` positions per 360 degrees, or over the range;
    /// the number is rounded up to a multiple of 360.
    #[must_use]
    pub fn new(solver: &Solver, positions: u32) -> Study {
        let methods = Methods::new(solver);
        let unknowns = methods.unknowns();
        let kind = CYCLES.into_iter().find(|&(maximum, _)| unknowns <= maximum);
        let cycles = kind.map_or(MIN_CYCLES, |(_, cycles)| cycles);
        Study::with(&all_methods(cycles), methods, positions)
    }

    /// Creates a study of some methods.
    #[must_use]
    pub fn of(list: &[Method], solver: &Solver, positions: u32) -> Study {
        Study::with(list, Methods::new(solver), positions)
    }

    fn with(list: &[Method], methods: Methods, positions: u32) -> Study {
        let contender = |&method: &Method| Contender {
            method,
            work: match (methods.usable(method), methods.runner(method)) {
                (Err(unfit), _) => StudyWork::Unsuitable(unfit),
                (Ok(()), Some(runner)) => StudyWork::Solves {
                    runner: Box::new(runner),
                    next: 0,
                },
                (Ok(()), None) => StudyWork::Integrates(None),
            },
            tally: Tally::default(),
            watch: Stopwatch::default(),
        };
        Study {
            contenders: list.iter().map(contender).collect(),
            coordinates: places(methods.range(), positions),
            methods,
            sound: Vec::new(),
            anew: true,
            sizes: Deviation::default(),
            stage: StudyStage::Errors { place: 0 },
        }
    }

    /// Works for about `budget`, by a monotonic clock; returns `true` if there is more to do. A
    /// piece of work takes about a millisecond.
    pub fn advance(&mut self, clock: &mut dyn FnMut() -> Duration, budget: Duration) -> bool {
        let end = clock() + budget;
        while self.stage != StudyStage::Done {
            self.piece(clock);
            if clock() >= end {
                break;
            }
        }
        self.stage != StudyStage::Done
    }

    /// Returns the progress, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let part = |done: usize, all: usize| done as f64 / all.max(1) as f64;
        match self.stage {
            StudyStage::Errors { place: index } => {
                ERRORS_PROGRESS * part(index, self.coordinates.len())
            }
            StudyStage::Times { round, .. } => {
                ERRORS_PROGRESS + (TIMES_PROGRESS - ERRORS_PROGRESS) * part(round, SAMPLES)
            }
            StudyStage::Cycles { .. } => {
                TIMES_PROGRESS + (1.0 - TIMES_PROGRESS) * self.integrated()
            }
            StudyStage::Done => 1.0,
        }
    }

    /// Returns the method being measured, if it is a single one.
    #[must_use]
    pub fn current(&self) -> Option<Method> {
        match self.stage {
            StudyStage::Cycles { contender } => self.contenders.get(contender).map(|c| c.method),
            StudyStage::Errors { .. } | StudyStage::Times { .. } | StudyStage::Done => None,
        }
    }

    /// Returns the results so far.
    #[must_use]
    pub fn findings(&self) -> Findings {
        let found = |(key, contender): (char, &Contender)| Finding {
            key,
            method: contender.method,
            verdict: self.verdict(contender),
            best: false,
        };
        let mut methods: Vec<_> = ('a'..).zip(&self.contenders).map(found).collect();
        findings::mark_best(&mut methods);
        Findings {
            methods,
            longest: self.methods.longest(),
            positions: self.sound.len(),
            finished: self.stage == StudyStage::Done,
        }
    }

    fn verdict(&self, contender: &Contender) -> MethodVerdict {
        let Contender { tally, watch, .. } = contender;
        match &contender.work {
            StudyWork::Unsuitable(unfit) => MethodVerdict::Unsuitable(*unfit),
            _ if tally.tried == 0 => MethodVerdict::Pending,
            StudyWork::Solves { .. } | StudyWork::Integrates(_) => {
                MethodVerdict::Measured(MethodFigures {
                    time: Spread::of(watch.samples()),
                    errors: tally.errors(self.sizes),
                    tried: tally.tried,
                    failures: tally.failures,
                    iterations: tally.iterations(),
                })
            }
        }
    }

    // ---- pieces of work

    fn piece(&mut self, clock: &mut dyn FnMut() -> Duration) {
        self.stage = match self.stage {
            StudyStage::Errors { place: index } => match self.coordinates.get(index) {
                Some(&at) => {
                    self.compare(at);
                    StudyStage::Errors { place: index + 1 }
                }
                None => StudyStage::Times {
                    round: 0,
                    contender: 0,
                },
            },
            StudyStage::Times { round, .. } if round == SAMPLES || self.sound.is_empty() => {
                StudyStage::Cycles { contender: 0 }
            }
            StudyStage::Times { round, contender } if contender == self.contenders.len() => {
                StudyStage::Times {
                    round: round + 1,
                    contender: 0,
                }
            }
            StudyStage::Times { round, contender } => {
                let taken = self.time(contender, clock);
                let contender = contender + usize::from(taken);
                StudyStage::Times { round, contender }
            }
            StudyStage::Cycles { contender } if contender == self.contenders.len() => {
                StudyStage::Done
            }
            StudyStage::Cycles { contender } => {
                let done = self.integrate(contender, clock);
                let contender = contender + usize::from(done);
                StudyStage::Cycles { contender }
            }
            StudyStage::Done => StudyStage::Done,
        };
    }

    /// Compares every method that solves positions with the reference.
    fn compare(&mut self, at: f64) {
        let methods = &mut self.methods;
        if !methods.compute_reference(at) {
            self.anew = true;
            return;
        }
        self.sound.push(at);
        self.sizes = self.sizes.max(methods.sizes());
        for Contender { work, tally, .. } in &mut self.contenders {
            let StudyWork::Solves { runner, .. } = work else {
                continue;
            };
            if self.anew {
                runner.start(methods);
            }
            let found = runner.solve(methods, at);
            let deviation = found.then(|| runner.deviation(methods)).flatten();
            let met = tally.note(deviation);
            if met {
                tally.count(runner.iterations());
            } else {
                runner.start(methods);
            }
        }
        self.anew = false;
    }

    /// Takes one sample of a method's time; returns `false` if it was too short to count, and the
    /// next one will be longer.
    fn time(&mut self, contender: usize, clock: &mut dyn FnMut() -> Duration) -> bool {
        let (methods, valid) = (&mut self.methods, &self.sound);
        let Contender { work, watch, .. } = &mut self.contenders[contender];
        let StudyWork::Solves { runner, next } = work else {
            return true;
        };
        watch.take(clock, usize::MAX, |count| {
            for _ in 0..count {
                let at = valid[*next % valid.len()];
                *next += 1;
                if !black_box(runner.solve(methods, black_box(at))) {
                    methods.guide_to(at);
                    runner.start(methods);
                }
            }
        })
    }

    /// Continues an integration; returns `true` if it is finished.
    fn integrate(&mut self, contender: usize, clock: &mut dyn FnMut() -> Duration) -> bool {
        let (methods, valid) = (&mut self.methods, &self.sound);
        let Contender {
            method,
            work,
            tally,
            watch,
        } = &mut self.contenders[contender];
        let (StudyWork::Integrates(cycle), &mut Method::Integration { steps, turns }) =
            (work, method)
        else {
            return true;
        };
        match cycle {
            Some(cycle) => cycle.run_step(methods, tally, watch, clock),
            None => {
                let start = valid.first().copied().unwrap_or_default();
                *cycle = IntegrationCycle::start(methods, start, steps, turns).map(Box::new);
                if cycle.is_none() {
                    tally.note(None);
                }
                cycle.is_none()
            }
        }
    }

    /// Returns the completed fraction of all integrations.
    fn integrated(&self) -> f64 {
        let (mut done, mut all) = (0.0, 0.0);
        for (i, contender) in self.contenders.iter().enumerate() {
            if let (StudyWork::Integrates(cycle), Method::Integration { steps, turns }) =
                (&contender.work, contender.method)
            {
                let share = f64::from(steps) * f64::from(turns);
                let is_past =
                    matches!(self.stage, StudyStage::Cycles { contender } if i < contender);
                let own = cycle.as_ref().map_or(0.0, |cycle| cycle.progress());
                done += share * if is_past { 1.0 } else { own };
                all += share;
            }
        }
        if all > 0.0 { done / all } else { 1.0 }
    }
}

/// Prints the stage only; the other fields are long and uninformative.
impl std::fmt::Debug for Study {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Study")
            .field("stage", &self.stage)
            .finish_non_exhaustive()
    }
}

/// Steps of one pass. Newton's method, started at the previous position, has a degree to cover.
const PASS: u32 = 360;

/// Returns the positions in the order of visit. There are several passes in steps of a degree, or
/// of a 360th of the range, each slightly offset from the previous one. Between limits the passes
/// alternate in direction.
fn places(range: Range, positions: u32) -> Vec<f64> {
    let passes = positions.div_ceil(PASS).max(1);
    let share = |k: u32, pass: u32, offset: f64| {
        f64::from(k) + (f64::from(pass) + offset) / f64::from(passes)
    };
    match range {
        Range::Full { period } => {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a few turns"
            )]
            let degrees = period as u32;
            let pass = |pass| (0..degrees).map(move |k| share(k, pass, 0.0));
            (0..passes).flat_map(pass).collect()
        }
        Range::Limited { low, high } => {
            // The ends are left out, because rates do not exist there.
            let at = |k, pass| low + (high - low) * (share(k, pass, 0.5) / f64::from(PASS));
            let pass = |pass: u32| {
                let on = (0..PASS).map(move |k| {
                    if pass.is_multiple_of(2) {
                        k
                    } else {
                        PASS - 1 - k
                    }
                });
                on.map(move |k| at(k, pass))
            };
            (0..passes).flat_map(pass).collect()
        }
    }
}
