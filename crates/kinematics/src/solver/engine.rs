//! Runs a program at one coordinate of the driver.

use super::change_point::ChangePointCrossings;
use super::coupled::{Coupled, Scratch};
use super::elements::{ACCELERATION, POSITION, Step, StepOutcome, VELOCITY};
use super::frame::Frame;
use super::further_inputs::{Following, InputMotion};
use super::motion::Folded;
use super::plan::pruning::{Marks, PlacedPart, prune};
use super::plan::{Gauge, Program, WatchedConstraint};
use super::state::{Condition, LinkState, PointState, Rates, State, TravelState};
use super::workspace::Workspace;
use super::{Demand, Order};
use crate::{
    Constant, Input, LinkId, Mechanism, Number, PointId, TimedInput, Vec2, angle, vectorized,
};
use std::sync::Arc;

/// Tolerance of a watched constraint, in units of about the longest link. It covers the rounding
/// error that accumulates in a long chain of groups, and no more.
const MISFIT: f64 = 1e-11;

/// Number of parts of a step, at whose ends the rate of a table is read.
const RATES: u8 = 4;

/// A program and its inputs: computes a state from the driver's coordinate.
#[derive(Clone, Debug)]
pub(super) struct Engine {
    pub program: Program,
    pub frame: Frame,
    pub is_rotary: bool,
    /// Whether steps read the angle itself, not only its direction.
    reads_angle: bool,
    /// The further inputs, needed to find when they return to their start.
    timed: Vec<TimedInput>,
    /// The laws of the further inputs.
    laws: Vec<Following>,
    /// The inputs that follow a table.
    tables: Vec<Following>,
    /// The sign of each group's assembly at the start.
    pub signs: Vec<f64>,
    /// The elements left out because no value of theirs is read.
    left_out: Option<Arc<Marks>>,
    driven: Option<LinkId>,
    /// For each point a link placed before it that carries it, if any. Joints have none.
    pub carriers: Vec<Option<LinkId>>,
    /// The misfit that the scene accepts for watched constraints, in the solver's unit.
    accepted: f64,
    /// The driver's speed and acceleration, in radians or scaled lengths.
    driver_rates: [Constant; 2],
}

impl Engine {
    pub(super) fn new(mechanism: &Mechanism, frame: Frame, program: Program) -> Engine {
        let driver = mechanism.driver();
        let driven = match driver.input {
            Input::Turn(link) => mechanism.is_crank(link).then_some(link),
            Input::Push(_) => None,
        };
        let driver_rates = driver_rates(mechanism, &frame);
        let laws = Following::all(mechanism, &frame);
        let mut engine = Engine {
            signs: vec![1.0; program.group_starts.len()],
            left_out: None,
            carriers: carriers(mechanism, &program),
            program,
            frame,
            is_rotary: driver.turns(),
            reads_angle: !mechanism.timed().is_empty() || mechanism.elbows().next().is_some(),
            timed: mechanism.timed().to_vec(),
            tables: laws.iter().filter(|law| law.is_table()).cloned().collect(),
            laws,
            driven,
            accepted: frame.length(mechanism.misfit()),
            driver_rates,
        };
        let starts = engine.program.group_starts.clone();
        for (i, step) in engine.program.steps.iter().enumerate() {
            if let Some(index) = step.coupled() {
                let group = starts.partition_point(|&start| start <= i) - 1;
                engine.program.coupled[index].group = group;
            }
        }
        let mut offset = 0;
        for group in &mut engine.program.coupled {
            group.offset = offset;
            offset += group.scratch_len();
        }
        engine
    }

    /// Returns a copy of the engine with the driver speed and acceleration of `mechanism`.
    pub(super) fn at_speed_of(&self, mechanism: &Mechanism) -> Engine {
        let mut engine = self.clone();
        engine.driver_rates = driver_rates(mechanism, &self.frame);
        engine
    }

    /// Returns the engine of a program in which every input moves by itself: its parameter is time.
    pub(super) fn free(self) -> Engine {
        Engine {
            driven: None,
            timed: Vec::new(),
            tables: Vec::new(),
            laws: Vec::new(),
            driver_rates: [Constant::exactly(1.0), Constant::default()],
            ..self
        }
    }

    /// Returns the driver's speed and acceleration, in radians or scaled lengths.
    pub(super) fn driver_rates(&self) -> [Constant; 2] {
        self.driver_rates
    }

    /// Creates a workspace with an empty state that contains the constants.
    pub(super) fn state<T: Number>(&self, slides: usize) -> Workspace<T> {
        let fixed_point = |&p: &_| PointState::fixed(Vec2::of(p));
        let fixed_link = |&d: &_| LinkState::fixed(Vec2::of(d));
        let [speed, acceleration] = self.driver_rates;
        let rates = Rates::new(speed, acceleration);
        let state = State {
            condition: Condition::NoAssembly,
            order: Order::Position,
            at: T::default(),
            points: self.program.points.iter().map(fixed_point).collect(),
            links: self.program.links.iter().map(fixed_link).collect(),
            travels: vec![TravelState::default(); slides],
            measures: vec![T::exactly(1.0); self.program.group_starts.len()],
            is_thin: false,
            signs: self.signs.iter().map(|&s| T::exactly(s)).collect(),
            forces: None,
            frame: self.frame,
            left_out: self.left_out.clone(),
            rates,
            length_rates: rates.times(self.frame.scale),
            free: None,
            driven: self.driven,
            is_turned: self.is_rotary,
            driver_scale: if self.is_rotary {
                1.0
            } else {
                self.frame.scale
            },
        };
        Workspace::new(state, self.scratch())
    }

    /// Creates the scratch memory of the coupled groups.
    pub(super) fn scratch<T: Number>(&self) -> Scratch<T> {
        let coupled = &self.program.coupled;
        Scratch {
            numbers: vec![T::default(); coupled.iter().map(|c| c.scratch_len()).sum()],
            pivots: vec![0; coupled.iter().map(|c| c.unknowns()).max().unwrap_or(0)],
            first: vec![0.0; coupled.len()],
            max_first: vec![f64::INFINITY; coupled.len()],
            work: Vec::new(),
        }
    }

    /// Returns the link whose direction is the driver's coordinate, if there is one.
    pub(super) fn driven(&self) -> Option<LinkId> {
        self.driven
    }

    /// Returns a difference of the driver's coordinate in the unit of the derivatives.
    pub(super) fn difference(&self, from: f64, to: f64) -> f64 {
        if self.is_rotary {
            angle::radians(to - from)
        } else {
            self.frame.length(to - from)
        }
    }

    /// Returns the coordinate at a difference from another one, in the unit of
    /// [`Engine::difference`].
    pub(super) fn moved(&self, from: f64, by: f64) -> f64 {
        from + if self.is_rotary {
            by.to_degrees()
        } else {
            by * self.frame.scale
        }
    }

    /// Returns the finest resolution of the driver's coordinate, which also applies near zero.
    pub(super) fn finest(&self) -> f64 {
        f64::EPSILON
            * if self.is_rotary {
                1.0
            } else {
                self.frame.scale
            }
    }

    /// Runs every step. A coupled group starts from the z in the scratch memory.
    #[inline(always)]
    pub(super) fn run(&self, at: f64, order: Order, workspace: &mut Workspace) -> Condition {
        workspace.state.start(at, order);
        workspace.state.condition = self.run_all(&self.program.steps, at, order, workspace);
        workspace.condition
    }

    #[inline(never)]
    pub(super) fn run_steps(
        &self,
        steps: std::ops::Range<usize>,
        at: f64,
        order: Order,
        workspace: &mut Workspace,
    ) -> Condition {
        self.run_all(&self.program.steps[steps], at, order, workspace)
    }

    #[inline(always)]
    fn run_all(
        &self,
        steps: &[Step],
        at: f64,
        order: Order,
        workspace: &mut Workspace,
    ) -> Condition {
        match order {
            Order::Position => self.run_to::<POSITION>(steps, at, workspace),
            Order::Velocity => self.run_to::<VELOCITY>(steps, at, workspace),
            Order::Acceleration | Order::Force => self.run_to::<ACCELERATION>(steps, at, workspace),
        }
    }

    /// Runs the steps with the machine's vector instructions.
    #[inline(always)]
    fn run_to<const ORDER: u8>(
        &self,
        steps: &[Step],
        at: f64,
        workspace: &mut Workspace,
    ) -> Condition {
        vectorized(
            #[inline(always)]
            || self.run_here::<ORDER>(steps, at, workspace),
        )
    }

    #[inline(always)]
    fn run_here<const ORDER: u8>(
        &self,
        steps: &[Step],
        at: f64,
        workspace: &mut Workspace,
    ) -> Condition {
        let Workspace { state, scratch, .. } = workspace;
        let (q, direction) = self.coordinate_with_angle(at);
        let mut condition = Condition::Ok;
        let mut steps = steps.iter();
        // The driver's own steps come first: they are placed before any code spills its direction
        // from registers.
        while let Some(first @ (Step::Crank(_) | Step::Spin(_))) = steps.as_slice().first() {
            let _ = run_step::<ORDER>(first, q, direction, state);
            steps.next();
        }
        for step in steps {
            let outcome = match step {
                Step::Coupled { index } => self.run_coupled(*index, q, ORDER, state, scratch),
                _ => run_step::<ORDER>(step, q, direction, state),
            };
            match outcome {
                StepOutcome::Done => {}
                StepOutcome::Stretched => condition = Condition::DeadPoint,
                StepOutcome::Open | StepOutcome::Unclear => return Condition::NoAssembly,
            }
        }
        condition
    }

    /// Runs every step in any arithmetic, without a closer look where rounding decides. `place`
    /// places the coupled groups. Returns `true` if everything was placed.
    pub(super) fn run_in<T: Number, const ORDER: u8>(
        &self,
        at: T,
        workspace: &mut Workspace<T>,
        mut place: impl FnMut(&Coupled, T, &mut State<T>, &mut Scratch<T>) -> bool,
    ) -> bool {
        let Workspace { state, scratch, .. } = workspace;
        let (q, direction) = self.coordinate(at);
        self.program.steps.iter().all(|step| match step.coupled() {
            Some(index) => place(&self.program.coupled[index], q, state, scratch),
            None => step.run::<T, ORDER>(q, direction, state) == StepOutcome::Done,
        })
    }

    /// Runs steps close to a change point. As [`Engine::run_steps`], but the series of a change
    /// point replaces the group that crosses it.
    #[inline(never)]
    pub(super) fn run_near(
        &self,
        steps: std::ops::Range<usize>,
        at: f64,
        order: Order,
        crossings: &ChangePointCrossings,
        workspace: &mut Workspace,
    ) -> Condition {
        workspace.state.start(at, order);
        workspace.state.condition = Condition::Ok;
        for i in steps {
            let condition = self.run_steps(i..i + 1, at, order, workspace);
            let Workspace { state, scratch, .. } = &mut *workspace;
            let near = self
                .group_of(i)
                .and_then(|group| crossings.near(self, at, group));
            if let Some((crossing, dq)) = near {
                crossing.write(dq, state);
                self.read_coupled(&self.program.steps[i], state, scratch);
                if dq == 0.0 && !crossing.is_led_through && state.condition == Condition::Ok {
                    state.condition = Condition::ChangePoint;
                }
            } else if condition != Condition::Ok {
                state.condition = condition;
            }
            if state.condition == Condition::NoAssembly {
                break;
            }
        }
        workspace.condition
    }

    /// Copies the placed values of a coupled group to its scratch memory, where the bounds read
    /// them.
    fn read_coupled(&self, step: &Step, state: &State, scratch: &mut Scratch) {
        if let Some(index) = step.coupled() {
            let group = &self.program.coupled[index];
            group.read(state, group.open(scratch).z);
        }
    }

    /// Computes positions at a limit where a coupled group folds. The group takes the stored
    /// solution.
    pub(super) fn run_folded(&self, fold: &Folded, workspace: &mut Workspace) -> Condition {
        let (q, _) = self.coordinate(fold.at);
        workspace.state.start(fold.at, Order::Position);
        workspace.state.condition = Condition::DeadPoint;
        for (i, step) in self.program.steps.iter().enumerate() {
            if step.coupled() == Some(fold.index) {
                let group = &self.program.coupled[fold.index];
                let Workspace { state, scratch, .. } = &mut *workspace;
                group.open(scratch).z.copy_from_slice(&fold.z);
                group.finish(q, POSITION, state, scratch);
            } else if self.run_steps(i..i + 1, fold.at, Order::Position, workspace)
                == Condition::NoAssembly
            {
                workspace.state.condition = Condition::NoAssembly;
                break;
            }
        }
        workspace.condition
    }

    /// Returns the travel of the fastest further input between two coordinates, in radians or scaled
    /// lengths. The rate of a table is read at some places.
    pub(super) fn largest_travel(&self, from: f64, to: f64) -> f64 {
        let unit = if self.is_rotary {
            1.0
        } else {
            1.0 / self.frame.scale
        };
        let places = (0..=RATES).map(|k| from + (to - from) * (f64::from(k) / f64::from(RATES)));
        let rates = places.flat_map(|at| self.laws.iter().map(move |law| law.at(at * unit).w));
        let fastest = rates.fold(0.0, |fastest: f64, rate: f64| rate.abs().max(fastest));
        fastest * self.difference(from, to).abs()
    }

    /// Returns the number of the first further input that moves faster than `ratio` times the driver,
    /// in radians or scaled lengths.
    pub(super) fn input_faster_than(&self, ratio: f64) -> Option<usize> {
        let is_fast = |law: &&Following| law.ratio().is_some_and(|own| own.abs() > ratio);
        self.laws.iter().find(is_fast).map(|law| law.number)
    }

    /// Returns `true` if all further inputs return to their start after `turns` turns.
    pub(super) fn repeats_after(&self, turns: usize) -> bool {
        self.timed.iter().all(|timed| timed.repeats_after(turns))
    }

    /// Returns `true` if any input follows a table.
    pub(super) fn has_tables(&self) -> bool {
        !self.tables.is_empty()
    }

    /// Returns how far around a coordinate every input is a single smooth function of it, so that a
    /// series can represent it: in radians or scaled lengths.
    ///
    /// At an end of an open table, only the side inside the table counts.
    pub(super) fn smooth(&self, at: f64) -> f64 {
        let (q, unit) = match self.is_rotary {
            true => (at, 1_f64.to_radians()),
            false => (at / self.frame.scale, 1.0),
        };
        let is_end = self.inwards(at) != 0.0;
        let tables = self
            .tables
            .iter()
            .map(|table| table.smooth(q, is_end) * unit);
        tables.fold(f64::INFINITY, f64::min)
    }

    /// Returns the direction into an open table that begins or ends at a coordinate: 1 or -1.
    /// Returns 0 at other coordinates.
    pub(super) fn inwards(&self, at: f64) -> f64 {
        let sides = [1.0, -1.0].into_iter().cycle();
        let mut ends = self.table_ends().zip(sides);
        ends.find(|&(end, _)| end == at)
            .map_or(0.0, |(_, side)| side)
    }

    /// Returns where the open tables begin and end, in turn.
    pub(super) fn table_ends(&self) -> impl Iterator<Item = f64> {
        let unit = if self.is_rotary {
            1.0
        } else {
            self.frame.scale
        };
        let ends = self.tables.iter().filter_map(Following::open_ends);
        ends.flatten().map(move |end| end * unit)
    }

    /// Returns `true` if a coordinate lies outside an open table. There the table's input rests, and
    /// the range ends before.
    pub(super) fn is_beyond_table(&self, at: f64) -> bool {
        let unit = if self.is_rotary {
            1.0
        } else {
            self.frame.scale
        };
        let mut tables = self.tables.iter().filter_map(Following::open_ends);
        tables.any(|[first, last]| at < first * unit || at > last * unit)
    }

    /// Returns the first end of an open table strictly between two coordinates, counted from
    /// `from`.
    pub(super) fn table_end(&self, from: f64, to: f64) -> Option<f64> {
        let between = self
            .table_ends()
            .filter(|end| (end - from) * (to - end) > 0.0);
        between.min_by(|a, b| (a - from).abs().total_cmp(&(b - from).abs()))
    }

    /// Returns the driver's coordinate for the steps: a length, or a direction and the angle if any
    /// step reads it.
    #[inline(always)]
    pub(super) fn coordinate<T: Number>(&self, at: T) -> (T, Vec2<T>) {
        if self.is_rotary {
            let q = if self.reads_angle { at } else { T::default() };
            (q, T::unit(at))
        } else {
            (at / T::exactly(self.frame.scale), Vec2::X.exactly())
        }
    }

    /// Returns the driver's coordinate as [`Engine::coordinate`] does, but always with the angle: a
    /// test whether any step reads it would take longer.
    #[inline(always)]
    pub(super) fn coordinate_with_angle<T: Number>(&self, at: T) -> (T, Vec2<T>) {
        if self.is_rotary {
            (at, T::unit(at))
        } else {
            self.coordinate(at)
        }
    }

    /// Returns the steps of the coupled groups, each with the number of its group.
    pub(super) fn coupled_steps(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let steps = self.program.steps.iter().enumerate();
        steps.filter_map(|(step, of)| Some((step, of.coupled()?)))
    }

    /// Returns the group whose sign a step has, if any.
    pub(super) fn group_of(&self, step: usize) -> Option<usize> {
        let step = &self.program.steps[step];
        let coupled = step
            .coupled()
            .map(|index| self.program.coupled[index].group);
        coupled.or_else(|| step.choice())
    }

    /// Returns the points and links placed by a step with a sign.
    pub(super) fn outputs(&self, step: usize) -> (Vec<PointId>, Vec<LinkId>) {
        let (mut points, mut links) = (Vec::new(), Vec::new());
        self.program.steps[step].outputs(&self.program.coupled, &mut |part| match part {
            PlacedPart::Point(point) => points.push(point),
            PlacedPart::Link(link) => links.push(link),
            PlacedPart::Slide(_) => {}
        });
        (points, links)
    }

    /// Computes the measures of the coupled groups at a solved state, positive on the side of the
    /// motion. Solving itself does not need them.
    pub(super) fn measure_coupled(&self, at: f64, workspace: &mut Workspace) {
        let (q, _) = self.coordinate(at);
        let Workspace { state, scratch, .. } = workspace;
        for group in &self.program.coupled {
            let measure = group.measure(q, state, scratch);
            state.measures[group.group] = measure * group.side * state.signs[group.group];
        }
    }

    /// Places the elements of one dyad.
    pub(super) fn place_dyad(&self, step: &Step, at: f64, state: &mut State) -> StepOutcome {
        let (q, direction) = self.coordinate(at);
        run_step::<POSITION>(step, q, direction, state)
    }

    fn run_coupled(
        &self,
        index: usize,
        q: f64,
        order: u8,
        state: &mut State,
        scratch: &mut Scratch,
    ) -> StepOutcome {
        let group = &self.program.coupled[index];
        let corrected = group.correct_within(scratch.max_first[index], q, state, scratch);
        scratch.first[index] = corrected.first;
        let kept = corrected.side * group.side * state.signs[group.group] >= 0.0;
        let solved = corrected.settled && kept && group.finish(q, order, state, scratch);
        if solved {
            StepOutcome::Done
        } else {
            StepOutcome::Open
        }
    }

    /// Returns each watched constraint with its miss and its distance from the origin: rounding
    /// errors grow with the distance.
    pub(super) fn misses<T: Number>(
        &self,
        state: &State<T>,
    ) -> impl Iterator<Item = (&WatchedConstraint, T, f64)> {
        let watches = self.program.watches.iter();
        watches.map(|watch| {
            let (miss, reach) = watch.gauge.misfit(state);
            (watch, miss, reach)
        })
    }

    /// Returns the first watched constraint that misses by more than rounding and the accepted
    /// misfit, with its miss in the solver's unit.
    pub(super) fn misfit(&self, state: &State) -> Option<(&WatchedConstraint, f64)> {
        // Written so that NaN counts as a misfit.
        let fits = |miss: f64, reach: f64| miss.abs() <= (MISFIT * reach).max(self.accepted);
        let mut misses = self.misses(state);
        let found = misses.find(|&(_, miss, reach)| !fits(miss, reach));
        found.map(|(watch, miss, _)| (watch, miss))
    }

    /// Returns a copy of the engine without the steps that `demand` does not need.
    pub(super) fn only(&self, demand: &Demand, slides: usize) -> Engine {
        let mut engine = self.clone();
        let mut left_out = match &self.left_out {
            Some(marks) => (**marks).clone(),
            None => Marks::none(&self.program, slides),
        };
        prune(&mut engine.program, demand, &mut left_out);
        if engine.program.steps.len() < self.program.steps.len() {
            engine.left_out = Some(Arc::new(left_out));
        }
        engine
    }
}

/// Runs a step of a single state. The most frequent kinds are inlined, so that the others take no
/// registers from them.
#[inline(always)]
fn run_step<const ORDER: u8>(
    step: &Step,
    q: f64,
    direction: Vec2,
    state: &mut State,
) -> StepOutcome {
    match step.run_frequent::<f64, ORDER>(q, direction, state) {
        Some(StepOutcome::Unclear) => place_closely(step, q, state),
        Some(outcome) => outcome,
        None => run_seldom::<ORDER>(step, q, direction, state),
    }
}

#[inline(never)]
fn run_seldom<const ORDER: u8>(
    step: &Step,
    q: f64,
    direction: Vec2,
    state: &mut State,
) -> StepOutcome {
    match step.run::<f64, ORDER>(q, direction, state) {
        StepOutcome::Unclear => place_closely(step, q, state),
        outcome => outcome,
    }
}

/// Places a dyad with a closer evaluation where rounding decides.
#[cold]
fn place_closely(step: &Step, q: f64, state: &mut State) -> StepOutcome {
    let dyad = step.dyad();
    dyad.map_or(StepOutcome::Open, |dyad| dyad.stretch(q, state))
}

/// Returns the driver's speed and acceleration in the solver's units.
fn driver_rates(mechanism: &Mechanism, frame: &Frame) -> [Constant; 2] {
    let driver = mechanism.driver();
    let unit = match driver.input {
        Input::Turn(_) => 1.0,
        Input::Push(_) => frame.scale,
    };
    let given = [driver.speed, driver.acceleration];
    match mechanism.typed_rates() {
        Some(typed) => [0, 1].map(|i| Constant::stored(given[i], typed[i]).scaled(1.0 / unit)),
        None => rates(given, unit, mechanism.has_converted_rates()),
    }
}

/// Converts a speed and an acceleration to a unit of the given size. `are_converted` means that
/// they were given in other units.
pub(super) fn rates(given: [f64; 2], unit: f64, are_converted: bool) -> [Constant; 2] {
    let given = given.map(|rate| Constant::given_in(rate, unit));
    if are_converted {
        given.map(Constant::converted)
    } else {
        given
    }
}

impl Gauge {
    /// Returns the miss of the constraint, and its distance from the origin (at least 1): rounding
    /// errors grow with the distance.
    fn misfit<T: Number>(&self, state: &State<T>) -> (T, f64) {
        let at = |p: crate::PointId| state.points[p.index()].p;
        let turned = |link: LinkId, along: Vec2<Constant>| {
            Vec2::of(along).turned(state.links[link.index()].d)
        };
        let (miss, position) = match *self {
            Gauge::Distance { from, to, length } => {
                ((at(to) - at(from)).norm() - T::of(length), at(to))
            }
            Gauge::Direction {
                from,
                to,
                link,
                along,
            } if along.nearest().is_finite() => {
                (turned(link, along).cross(at(to) - at(from)), at(to))
            }
            Gauge::Direction { .. } => (T::default(), Vec2::default()),
            Gauge::OnLine { point, line } => {
                let t = turned(line.link, line.along);
                (t.cross(at(point) - at(line.through)), at(point))
            }
            Gauge::Pushed {
                point,
                line,
                ref following,
            } => {
                let t = turned(line.link, line.along);
                let travel = t.dot(at(point) - at(line.through));
                let pushed = InputMotion::of(following.as_ref(), state.coordinate());
                (travel - pushed.p, at(point))
            }
            Gauge::Turned {
                link,
                from,
                ref following,
            } => {
                let d = |link: LinkId| state.links[link.index()].d;
                let turned = InputMotion::of(following.as_ref(), state.coordinate());
                let wanted = d(from).turned(T::unit(turned.p));
                (wanted.cross(d(link)), Vec2::default())
            }
        };
        (miss, position.nearest().norm().max(1.0))
    }
}

/// Finds for each point the first link placed before it that carries it.
fn carriers(mechanism: &Mechanism, program: &Program) -> Vec<Option<LinkId>> {
    let mut placed: Vec<Option<usize>> = vec![None; program.links.len()];
    let mut carriers = vec![None; program.points.len()];
    for (number, step) in program.steps.iter().enumerate() {
        let mut links = Vec::new();
        step.outputs(&program.coupled, &mut |part| match part {
            PlacedPart::Point(point) => {
                // The program has further points of its own.
                let given = mechanism.points().get(point.index());
                let carrying = given
                    .into_iter()
                    .flat_map(|point| point.links.iter().copied());
                let before = carrying.filter_map(|l| Some((placed[l.index()]?, l)));
                carriers[point.index()] = before.min_by_key(|(at, _)| *at).map(|(_, l)| l);
            }
            PlacedPart::Link(link) => links.push(link),
            PlacedPart::Slide(_) => {}
        });
        for link in links {
            placed[link.index()].get_or_insert(number);
        }
    }
    carriers
}
