//! The same mechanism with other lengths, in place: the same groups, each on its assembly, nothing built anew.
//!
//! Every place that a program is made of (where an arm ends, where a point rides) is a sum of given lengths with fixed
//! factors. These factors are found once, by building the program with the derivative by each length beside its
//! places; then other lengths are some products and sums, and what follows from a place (an arm's length, its square)
//! is made again by the element that keeps it. It is what tolerances and studies run on, a million times.

use super::Range;
use super::chain;
use super::classify::{DrivenLoop, LoopKind, classify};
use super::elements::{ACCELERATION, POSITION, VELOCITY};
use super::engine::Engine;
use super::network::Network;
use super::plan::Program;
use super::state::PointState;
use super::{Condition, Demand, Order, Solver, State, Workspace};
use crate::angle::TURN;
use crate::{Ball, Constant, LANES, Lanes, Length, Mechanism, Number, Vec2};

/// The places at which a motion is looked at for a group that comes near to its limits,
const DEGREES: u16 = 360;
/// what the square of a sine is there at the least: at 1 degree between places it could be nought in between below
/// some thousandths,
const LEAST_MEASURE: f64 = 0.04;
/// and by how much it changes from place to place at the most.
const STEEPEST_MEASURE: f64 = 0.1;

/// A mechanism whose lengths are changed in place: made by [`Solver::varied`].
#[derive(Clone, Debug)]
pub struct Varied {
    nominal: Solver,
    engine: Engine,
    work: Workspace,
    lanes: Workspace<Lanes>,
    /// Every place of the program, as it was given.
    places: Vec<VariedPlace>,
    /// The constant points that follow a length: they lie in the states, and are written there.
    moved: Vec<usize>,
    lengths: usize,
}

/// A place, and what follows which length by how much.
#[derive(Clone, Debug)]
struct VariedPlace {
    given: Vec2<Constant>,
    follows: Vec<(usize, Vec2)>,
}

impl VariedPlace {
    /// Where it is with lengths changed by so much.
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

    /// Where it can be with lengths off by no more than so much each.
    fn within(&self, limits: &[f64]) -> Vec2<Constant> {
        let ways = self
            .follows
            .iter()
            .map(|&(length, slope)| slope * limits[length]);
        let off = ways.fold(Vec2::ZERO, |sum, way| {
            sum + Vec2::new(way.x.abs(), way.y.abs())
        });
        Vec2::new(
            Constant {
                radius: self.given.x.radius + off.x,
                ..self.given.x
            },
            Constant {
                radius: self.given.y.radius + off.y,
                ..self.given.y
            },
        )
    }
}

impl Solver {
    /// Makes some lengths ready to be changed in place, of what `demand` reads. `None` of a redundant mechanism: with
    /// other lengths it jams, or moves by what was set aside.
    #[must_use]
    pub fn varied(&self, lengths: &[Length], demand: &Demand) -> Option<Varied> {
        let program = |network: Network<'_>| {
            let built = chain::build(&network, &self.ordering, chain::Dyads::Closed);
            built.ok().map(|(_, program)| program)
        };
        let network = || Network::new(&self.mechanism, self.engine.frame).varied();
        let whole = program(network())?;
        if !whole.watches.is_empty() {
            return None;
        }
        let ready = |program: Program| {
            Engine::new(&self.mechanism, self.engine.frame, program).only(demand, self.slides)
        };
        let mut engine = ready(whole);
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
        let points = engine.program.points.len();
        let follows = |&point: &usize| !places[point].follows.is_empty();
        Some(Varied {
            work: engine.state(self.slides),
            lanes: engine.state(self.slides),
            moved: (0..points).filter(follows).collect(),
            nominal: self.clone(),
            engine,
            places,
            lengths: lengths.len(),
        })
    }
}

/// The places of a program, as they are.
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

impl Engine {
    /// Notes at every place of a program how it follows the length with which this one was built; `None` where that
    /// has made another program of it.
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
    /// How many lengths it changes.
    #[must_use]
    pub fn lengths(&self) -> usize {
        self.lengths
    }

    /// The solver of the lengths as they were given.
    #[must_use]
    pub fn nominal(&self) -> &Solver {
        &self.nominal
    }

    /// Makes every length longer by so much, in the scene's unit, than it was given: in the order in which they were
    /// asked for, those that are left out as given. Allocates nothing.
    pub fn change(&mut self, by: &[f64]) {
        debug_assert_eq!(by.len(), self.lengths);
        let mut places = self.places.iter();
        self.engine.program.vary(&mut |place| {
            if let Some(known) = places.next().filter(|known| !known.follows.is_empty()) {
                *place = known.with(by);
            }
        });
        for &point in &self.moved {
            let place = self.engine.program.points[point];
            self.work.state.points[point] = PointState::fixed(Vec2::of(place));
            self.lanes.state.points[point] = PointState::fixed(Vec2::of(place));
        }
    }

    /// Solves at the driver's coordinate, on the assembly that the given lengths have there. Where they have none the
    /// sign of each group is that of the motion's nearer end. [`Condition::NoAssembly`] where it does not close;
    /// change points and series beside them are those of exact lengths, and not of these. Allocates nothing.
    pub fn solve(&mut self, at: f64, order: Order) -> Condition {
        self.nominal.aim_varied(&self.engine, at, &mut self.work);
        self.work.state.measures.fill(1.0);
        self.engine.run(at, order, &mut self.work)
    }

    /// A solver of the lengths as they are now, of a mechanism that has them, where all is plain: the driver turns
    /// fully, nothing has stops, the motion has no change point and comes near to none, nothing is coupled, and from
    /// degree to degree no group comes near to its limits. Otherwise `None`: then a solver is to be made.
    ///
    /// It solves and reads as any other; bounds and assemblies it does not know.
    pub fn plain(&mut self, mechanism: &Mechanism) -> Option<Solver> {
        let motion = &self.nominal.motion;
        // Stops that the given lengths stay between may be met by others.
        let is_plain = motion.range == Range::Full { period: TURN }
            && mechanism.limits().is_empty()
            && motion.passages.is_empty()
            && motion.near_misses.is_empty()
            && self.engine.program.coupled.is_empty();
        if !is_plain || !self.keeps_clear() {
            return None;
        }
        Some(Solver {
            mechanism: mechanism.clone(),
            engine: self.engine.at_speed_of(mechanism),
            exact: None,
            balance: None,
            ..self.nominal.clone()
        })
    }

    /// Whether every group closes at every degree, away from its limits, and changes little from one to the next.
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
                    if !(measure > LEAST_MEASURE && (measure - last).abs() < STEEPEST_MEASURE) {
                        return false;
                    }
                }
            }
        }
        true
    }

    /// Whether anything that is read follows a length.
    #[must_use]
    pub fn follows(&self, length: usize) -> bool {
        let mut all = self.places.iter().flat_map(|place| &place.follows);
        all.any(|&(of, _)| of == length)
    }

    /// All states at once of lengths that are off by no more than so much each: a ball around each number of the
    /// state, in natural ball arithmetic, so that it holds them all and is wider than they need. `None` where that
    /// cannot be told, and of every mechanism with a coupled group.
    #[must_use]
    pub fn enclose(&self, limits: &[f64], at: f64, order: Order) -> Option<State<Ball>> {
        if !self.engine.program.coupled.is_empty() {
            return None;
        }
        let mut engine = self.engine.clone();
        let mut places = self.places.iter();
        engine.program.vary(&mut |place| {
            if let Some(known) = places.next() {
                *place = known.within(limits);
            }
        });
        let mut work = engine.state::<Ball>(self.nominal.slides);
        self.nominal.choose_exactly(at, &mut work.state);
        let at = Ball::exactly(at);
        work.state.begin(at, order);
        let placed = match order {
            Order::Position => engine.run_in::<Ball, POSITION>(at, &mut work, |_, _, _, _| false),
            Order::Velocity => engine.run_in::<Ball, VELOCITY>(at, &mut work, |_, _, _, _| false),
            Order::Acceleration | Order::Force => {
                engine.run_in::<Ball, ACCELERATION>(at, &mut work, |_, _, _, _| false)
            }
        };
        work.state.condition = Condition::Ok;
        placed.then(|| work.into_state())
    }

    /// The class of the loop that the driver closes, with the lengths as they are now; `None` where there is no such
    /// loop, or nothing of it is read.
    #[must_use]
    pub fn kind(&self) -> Option<LoopKind> {
        let found = classify(&self.engine, &self.nominal.mechanism);
        found.map(DrivenLoop::kind)
    }

    /// Of what [`Varied::solve`] found last, how far each group is from the edge of assembly: of a dyad the square of
    /// the sine of its transmission angle. Not positive for the group that is open, if one is; that of a group behind
    /// it, and of a coupled group that is open, is 1.
    pub fn measures(&mut self, at: f64) -> &[f64] {
        let is_closed = self.work.state.condition != Condition::NoAssembly;
        if is_closed && !self.engine.program.coupled.is_empty() {
            self.engine.measure_coupled(at, &mut self.work);
        }
        &self.work.state.measures
    }

    /// What [`Varied::solve`] found last.
    #[must_use]
    pub fn state(&self) -> &Workspace {
        &self.work
    }

    /// Solves at several coordinates at once; `None` where one of them is none at which all closes plainly, and of
    /// every mechanism with a coupled group: then they want to be solved one by one. Allocates nothing.
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
    /// The signs of all groups at a coordinate, in any arithmetic.
    fn choose_exactly(&self, at: f64, state: &mut State<Ball>) {
        for (sign, &start) in state.signs.iter_mut().zip(&self.engine.signs) {
            *sign = Ball::exactly(start);
        }
        for group in self.motion.passages.changed(at) {
            state.signs[group] = -state.signs[group];
        }
    }

    /// Puts into the room of other lengths what the motion tells of a coordinate.
    fn aim_varied(&self, engine: &Engine, at: f64, work: &mut Workspace) {
        self.motion.anchors.aim(engine, at, work);
        let passages = &self.motion.passages;
        if !passages.is_empty() {
            passages.choose(engine, at, &mut work.state.signs);
        }
    }
}
