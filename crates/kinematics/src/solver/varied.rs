//! Changes lengths of a mechanism in place and keeps its groups and assemblies, without rebuilding.
//!
//! Each place in a program (the end of an arm, a riding point) is a sum of given lengths with
//! constant factors. The factors are found once, by building the program together with the
//! derivative by each length. Other lengths then take only some products and sums. Values derived
//! from a place (an arm's length, its square) are recomputed by the element that stores them.
//! Tolerances and studies run on this, a million times.

use super::Range;
use super::chain;
use super::classify::{DrivenLoop, LoopKind, classify};
use super::elements::{ACCELERATION, POSITION, Step, VELOCITY};
use super::engine::Engine;
use super::plan::Program;
use super::plan::network::Network;
use super::state::PointState;
use super::{Condition, Demand, Order, Solver, State, Workspace};
use crate::angle::TURN;
use crate::{Ball, Constant, Dual, LANES, Lanes, Length, Mechanism, Number, Vec2};

/// The number of places at which a motion is checked for a group that comes near its limits.
const DEGREES: u16 = 360;
/// The minimum of the squared sine at these places. At a spacing of 1 degree it could reach zero in
/// between if it were below some thousandths.
const MIN_MEASURE: f64 = 0.04;
/// The maximum ratio of an input's rate to that of the driver, in radians or scaled lengths, at which
/// these places show its motion.
const MAX_SHOWN_RATIO: f64 = 10.0;
/// The maximum change of the squared sine from one place to the next.
const MAX_MEASURE_CHANGE: f64 = 0.1;

/// A mechanism whose lengths are changed in place, created by [`Solver::varied`].
#[derive(Clone, Debug)]
pub struct Varied {
    nominal: Solver,
    engine: Engine,
    workspace: Workspace,
    lanes: Workspace<Lanes>,
    /// Every place of the program, with its given value.
    places: Vec<VariedPlace>,
    /// The parts that depend on a length.
    parts: Vec<VariedPart>,
    /// The change of every length in the program; not a number before the first change.
    changed: Vec<f64>,
}

/// A part of the program that depends on lengths, and is computed again only if one of them
/// changes.
#[derive(Clone, Debug)]
struct VariedPart {
    kind: VariedKind,
    /// The places of the part.
    places: std::ops::Range<usize>,
    /// The lengths on which they depend.
    lengths: Vec<usize>,
}

#[derive(Clone, Copy, Debug)]
enum VariedKind {
    /// A constant point. States contain it, and it is written there.
    Point(usize),
    Step(usize),
}

/// A place, with each length on which it depends and its derivative by that length.
#[derive(Clone, Debug)]
struct VariedPlace {
    given: Vec2<Constant>,
    follows: Vec<(usize, Vec2)>,
}

impl VariedPlace {
    /// Returns the place for lengths changed by `by`, in the scene's unit.
    fn with(&self, by: &[f64]) -> Vec2<Constant> {
        let moved = self
            .follows
            .iter()
            .map(|&(length, slope)| slope * by[length]);
        let moved = moved.fold(Vec2::ZERO, |sum, way| sum + way);
        Vec2::new(
            Constant::given(self.given.x.hi + moved.x),
            Constant::given(self.given.y.hi + moved.y),
        )
    }

    /// Returns an enclosure of the place for length errors up to `limits`.
    fn within(&self, limits: &[f64]) -> Vec2<Constant> {
        let ways = self
            .follows
            .iter()
            .map(|&(length, slope)| slope.map(f64::abs) * limits[length]);
        let off = ways.fold(Vec2::ZERO, |sum, way| sum + way);
        let Vec2 { x, y } = self.given;
        Vec2::new(x.widened(off.x), y.widened(off.y))
    }

    /// Returns the same enclosure with its derivative by a length.
    fn sloped_within(&self, limits: &[f64], by: usize) -> Vec2<Constant> {
        let mut slopes = self.follows.iter().filter(|(length, _)| *length == by);
        let slope = slopes.next().map_or(Vec2::ZERO, |&(_, slope)| slope);
        let Vec2 { x, y } = self.within(limits);
        Vec2::new(x.with_slope(slope.x), y.with_slope(slope.y))
    }
}

impl Solver {
    /// Prepares lengths for changes in place, for the values read by `demand`. `None` for a
    /// redundant mechanism: with other lengths it jams, or moves by the equations that were set
    /// aside.
    #[must_use]
    pub fn varied(&self, lengths: &[Length], demand: &Demand) -> Option<Varied> {
        let program = |network: Network<'_>| {
            let built = chain::build(&network, &self.ordering, chain::Dyads::Closed);
            built.ok().map(|(_, program)| program)
        };
        let network = || Network::new(&self.mechanism, self.engine.frame).varied();
        let complete = program(network())?;
        if !complete.watches.is_empty() {
            return None;
        }
        let ready = |program: Program| {
            Engine::new(&self.mechanism, self.engine.frame, program).only(demand, self.slides)
        };
        let mut engine = ready(complete);
        engine.signs.clone_from(&self.engine.signs);
        let mut places = places(&mut engine);
        for (i, &length) in lengths.iter().enumerate() {
            let mut followed = ready(program(network().by_length(length))?);
            followed.follow(i, &mut places)?;
        }
        let sides = self
            .engine
            .program
            .coupled
            .iter()
            .map(|group| (group.group, group.side));
        for (group, side) in sides {
            let same = engine
                .program
                .coupled
                .iter_mut()
                .filter(|c| c.group == group);
            same.for_each(|coupled| coupled.side = side);
        }
        Some(Varied {
            workspace: engine.state(self.slides),
            lanes: engine.state(self.slides),
            nominal: self.clone(),
            parts: parts(&mut engine.program, &places),
            engine,
            places,
            changed: vec![f64::NAN; lengths.len()],
        })
    }
}

/// Returns the places of a program with their given values.
fn places(engine: &mut Engine) -> Vec<VariedPlace> {
    let mut places = Vec::new();
    engine.program.vary(&mut |place| {
        places.push(VariedPlace {
            given: *place,
            follows: Vec::new(),
        });
    });
    places
}

/// Returns the parts of a program that depend on lengths.
fn parts(program: &mut Program, places: &[VariedPlace]) -> Vec<VariedPart> {
    let mut first = 0;
    let mut part = |kind: VariedKind, count: usize| {
        let range = first..first + count;
        first = range.end;
        let follows = places[range.clone()]
            .iter()
            .flat_map(|place| &place.follows);
        let mut lengths: Vec<usize> = follows.map(|&(length, _)| length).collect();
        lengths.sort_unstable();
        lengths.dedup();
        (!lengths.is_empty()).then_some(VariedPart {
            kind,
            places: range,
            lengths,
        })
    };
    let points = (0..program.points.len()).map(|point| (VariedKind::Point(point), 1));
    let points: Vec<_> = points.collect();
    let steps = program.steps.iter_mut().enumerate().map(|(i, step)| {
        let mut count = 0;
        step.vary(&mut program.coupled, &mut |_| count += 1);
        (VariedKind::Step(i), count)
    });
    let all = points.into_iter().chain(steps);
    all.filter_map(|(kind, count)| part(kind, count)).collect()
}

impl Engine {
    /// Records how each place depends on the length with which this engine was built; `None` if
    /// building it with the length gave another program.
    fn follow(&mut self, length: usize, places: &mut [VariedPlace]) -> Option<()> {
        let mut all = places.iter_mut();
        let mut is_same = true;
        self.program.vary(&mut |place| match all.next() {
            None => is_same = false,
            Some(_) if place.x.slope == 0.0 && place.y.slope == 0.0 => {}
            Some(known) => {
                let slope = Vec2::new(place.x.slope, place.y.slope);
                known.follows.push((length, slope));
            }
        });
        (is_same && all.next().is_none()).then_some(())
    }
}

impl Varied {
    /// Returns the number of variable lengths.
    #[must_use]
    pub fn lengths(&self) -> usize {
        self.changed.len()
    }

    /// Returns the steps of the program.
    pub(super) fn steps(&self) -> &[Step] {
        &self.engine.program.steps
    }

    /// Returns the solver with the given lengths.
    #[must_use]
    pub fn nominal(&self) -> &Solver {
        &self.nominal
    }

    /// Changes every length by the given amount in the scene's unit, relative to its given value.
    /// The order is that of the lengths passed to [`Solver::varied`]. Computes only what depends on
    /// a length whose change differs from the last one. Allocates nothing.
    pub fn change(&mut self, by: &[f64]) {
        debug_assert_eq!(by.len(), self.lengths());
        let program = &mut self.engine.program;
        for part in &self.parts {
            // Nothing equals the initial NaN.
            if part.lengths.iter().all(|&i| by[i] == self.changed[i]) {
                continue;
            }
            let mut places = self.places[part.places.clone()].iter();
            match part.kind {
                VariedKind::Point(point) => {
                    for known in places {
                        let position = known.with(by);
                        program.points[point] = position;
                        self.workspace.state.points[point] = PointState::fixed(Vec2::of(position));
                        self.lanes.state.points[point] = PointState::fixed(Vec2::of(position));
                    }
                }
                VariedKind::Step(step) => {
                    program.steps[step].vary(&mut program.coupled, &mut |position| {
                        if let Some(known) = places.next().filter(|known| !known.follows.is_empty())
                        {
                            *position = known.with(by);
                        }
                    });
                }
            }
        }
        self.changed.copy_from_slice(by);
    }

    /// Solves at the driver's coordinate, in the assembly that the given lengths have there.
    /// Outside their motion, each group has the sign of the motion's nearer end. Returns
    /// [`Condition::NoAssembly`] if a group does not close. Change points and their series belong
    /// to the given lengths, not to the changed ones. Allocates nothing.
    pub fn solve(&mut self, at: f64, order: Order) -> Condition {
        self.nominal
            .predict_varied(&self.engine, at, &mut self.workspace);
        self.workspace.state.measures.fill(1.0);
        self.engine.run(at, order, &mut self.workspace)
    }

    /// Creates a solver for the current lengths, where `mechanism` has these lengths. This is
    /// possible only in the simple case: the driver turns fully, and there are no stops, change
    /// points, near misses or coupled groups. In addition, no group may come near its limits at any
    /// degree. `None` in all other cases: create a solver from scratch instead.
    ///
    /// The result solves and is read like any other solver, but has no bounds and no assemblies.
    pub fn plain(&mut self, mechanism: &Mechanism) -> Option<Solver> {
        let motion = &self.nominal.motion;
        // Other lengths may meet stops that the given lengths do not reach.
        let is_plain = motion.range == Range::Full { period: TURN }
            && mechanism.limits().is_empty()
            && motion.crossings.is_empty()
            && motion.near_misses.is_empty()
            && self.engine.program.coupled.is_empty()
            && self.engine.input_faster_than(MAX_SHOWN_RATIO).is_none();
        if !is_plain || !self.keeps_clear() {
            return None;
        }
        let engine = self.engine.at_speed_of(mechanism);
        Some(Solver {
            mechanism: mechanism.clone(),
            exact: None,
            balance: None,
            ..self.nominal.with_engine(engine)
        })
    }

    /// Returns `true` if every group closes at every degree, away from its limits, and changes
    /// little between neighbouring degrees.
    fn keeps_clear(&mut self) -> bool {
        let groups = self.lanes.state.measures.len();
        let mut before: Vec<Option<f64>> = vec![None; groups];
        for first in (0..DEGREES).step_by(LANES) {
            let at = std::array::from_fn(|lane| f64::from(first) + lane as f64);
            let Some(lanes) = self.solve_lanes(at, Order::Position) else {
                return false;
            };
            for (measures, before) in lanes.state.measures.iter().zip(&mut before) {
                for measure in measures.0 {
                    let last = before.replace(measure).unwrap_or(measure);
                    // Written so that NaN is not clear.
                    if !(measure > MIN_MEASURE && (measure - last).abs() < MAX_MEASURE_CHANGE) {
                        return false;
                    }
                }
            }
        }
        true
    }

    /// Returns `true` if any value read depends on the length.
    #[must_use]
    pub fn follows(&self, length: usize) -> bool {
        let mut all = self.parts.iter().flat_map(|part| &part.lengths);
        all.any(|&of| of == length)
    }

    /// Computes an enclosure of all states with length errors up to `limits`: a ball around each
    /// number of the state. It uses natural ball arithmetic, so it contains all states but is wider
    /// than necessary. `None` if that fails, and for every mechanism with a coupled group.
    #[must_use]
    pub fn enclose(&self, limits: &[f64], at: f64, order: Order) -> Option<State<Ball>> {
        self.run_with(|place| place.within(limits), at, order)
    }

    /// Computes an enclosure of all states as [`Varied::enclose`] does, and of their derivatives by
    /// a length, per unit of the scene.
    #[must_use]
    pub fn enclose_slopes(
        &self,
        length: usize,
        limits: &[f64],
        at: f64,
        order: Order,
    ) -> Option<State<Dual<Ball>>> {
        self.run_with(|place| place.sloped_within(limits, length), at, order)
    }

    /// Solves with other places. `None` if that fails, and for every mechanism with a coupled
    /// group.
    fn run_with<T: Number>(
        &self,
        placed: impl Fn(&VariedPlace) -> Vec2<Constant>,
        at: f64,
        order: Order,
    ) -> Option<State<T>> {
        if !self.engine.program.coupled.is_empty() {
            return None;
        }
        let mut engine = self.engine.clone();
        let mut places = self.places.iter();
        engine.program.vary(&mut |place| {
            if let Some(known) = places.next() {
                *place = placed(known);
            }
        });
        let mut workspace = engine.state::<T>(self.nominal.slides);
        self.nominal.choose_exactly(at, &mut workspace.state);
        let at = T::exactly(at);
        workspace.state.start(at, order);
        let is_solved = match order {
            Order::Position => engine.run_in::<T, POSITION>(at, &mut workspace, |_, _, _, _| false),
            Order::Velocity => engine.run_in::<T, VELOCITY>(at, &mut workspace, |_, _, _, _| false),
            Order::Acceleration | Order::Force => {
                engine.run_in::<T, ACCELERATION>(at, &mut workspace, |_, _, _, _| false)
            }
        };
        workspace.state.condition = Condition::Ok;
        is_solved.then(|| workspace.into_state())
    }

    /// Returns the class of the loop that the driver closes, with the current lengths; `None` if
    /// there is no such loop, or none of it is read.
    #[must_use]
    pub fn kind(&self) -> Option<LoopKind> {
        let found = classify(&self.engine, &self.nominal.mechanism);
        found.map(DrivenLoop::kind)
    }

    /// Returns how far each group of the last [`Varied::solve`] is from its assembly limit: for a
    /// dyad the square of the sine of its transmission angle. It is not positive for a dyad that
    /// does not close. It is 1 for the groups after that dyad, and for a coupled group that does
    /// not close.
    pub fn measures(&mut self, at: f64) -> &[f64] {
        let is_closed = self.workspace.state.condition != Condition::NoAssembly;
        if is_closed && !self.engine.program.coupled.is_empty() {
            self.engine.measure_coupled(at, &mut self.workspace);
        }
        &self.workspace.state.measures
    }

    /// Returns the result of the last [`Varied::solve`].
    #[must_use]
    pub fn state(&self) -> &Workspace {
        &self.workspace
    }

    /// Solves at several coordinates at once. `None` if one of them is not an ordinary one, and for
    /// every mechanism with a coupled group: solve those one by one. Allocates nothing.
    pub fn solve_lanes(&mut self, at: [f64; LANES], order: Order) -> Option<&Workspace<Lanes>> {
        if !self.engine.program.coupled.is_empty() {
            return None;
        }
        self.nominal.choose_in_lanes(at, &mut self.lanes.state);
        let solved = self
            .engine
            .run_lanes(Lanes(at), order, &mut self.lanes.state);
        self.lanes.state.condition = if solved {
            Condition::Ok
        } else {
            Condition::NoAssembly
        };
        solved.then_some(&self.lanes)
    }
}

impl Solver {
    /// Sets the signs of all groups at a coordinate.
    fn choose_exactly<T: Number>(&self, at: f64, state: &mut State<T>) {
        for (sign, &start) in state.signs.iter_mut().zip(&self.engine.signs) {
            *sign = T::exactly(start);
        }
        for group in self.motion.crossings.changed(at) {
            state.signs[group] = -state.signs[group];
        }
    }

    /// Writes the motion's data for a coordinate to a workspace for other lengths.
    fn predict_varied(&self, engine: &Engine, at: f64, workspace: &mut Workspace) {
        self.motion.anchors.predict(engine, at, workspace);
        let crossings = &self.motion.crossings;
        if !crossings.is_empty() {
            crossings.choose(engine, at, &mut workspace.state.signs);
        }
    }
}
