//! Finds the places in a cycle where a load has a kink or jumps, and the number of turns after
//! which all loads repeat.

use super::cycle_travel::CyclePath;
use super::ram::{Ram, RamEnd};
use super::spring_kinks::SpringBends;
use crate::angle::TURN;
use crate::solver::{Range, Solver};
use crate::{Input, Load, Mechanism, Profile};

/// Maximum number of turns of a cycle.
const MAX_TURNS: u64 = 64;

/// Returns the period, in turns, of a profile over the driver's coordinate; `None` if its knots do
/// not span whole turns.
fn turns_of(profile: &Profile) -> Option<u64> {
    let (first, last) = (profile.knots().first()?, profile.knots().last()?);
    let turns = (last[0] - first[0]) / TURN;
    let is_whole = turns >= 1.0 && turns.fract() == 0.0 && turns <= MAX_TURNS as f64;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few turns"
    )]
    is_whole.then_some(turns as u64)
}

/// Returns the factor of a load over the driver's coordinate.
fn factor(load: &Load) -> Option<&Profile> {
    match load {
        Load::Force { over, .. } | Load::Torque { over, .. } => Some(over),
        Load::Press { .. }
        | Load::Spring { .. }
        | Load::GasSpring { .. }
        | Load::TorsionSpring { .. } => None,
    }
}

fn profiles(mechanism: &Mechanism) -> impl Iterator<Item = &Profile> {
    mechanism.loads().iter().filter_map(factor)
}

/// Returns the loads, by number from 1, whose factor over the driver's coordinate changes and is
/// not periodic.
pub(super) fn unrepeated(mechanism: &Mechanism) -> Vec<usize> {
    let changes = |over: &Profile| over.knots().windows(2).any(|pair| pair[0][1] != pair[1][1]);
    let once = |over: &Profile| changes(over) && turns_of(over).is_none();
    let loads = mechanism.loads().iter().zip(1..);
    let found = loads.filter(|(load, _)| factor(load).is_some_and(once));
    found.map(|(_, number)| number).collect()
}

/// Returns the number of the motion's periods until the loads repeat too; `None` if it is too
/// large.
#[must_use]
pub fn repeats(mechanism: &Mechanism, range: Range) -> Option<u32> {
    let Range::Full { period } = range else {
        return Some(1);
    };
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few turns"
    )]
    let motion = (period / TURN).round().max(1.0) as u64;
    let mut all = motion;
    for turns in profiles(mechanism).filter_map(turns_of) {
        all = all / common(all, turns) * turns;
        if all > MAX_TURNS {
            return None;
        }
    }
    u32::try_from(all / motion).ok()
}

fn common(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { common(b, a % b) }
}

/// A driver coordinate at which a load has a kink or jumps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mark {
    at: f64,
    /// The period with which it recurs; 0 if it does not.
    every: f64,
}

impl Mark {
    /// Returns the occurrences between two coordinates.
    pub(super) fn between(self, low: f64, high: f64) -> impl Iterator<Item = f64> {
        let Mark { at, every } = self;
        let first = match every > 0.0 {
            true => low + (at - low).rem_euclid(every),
            false => at,
        };
        let times = match every > 0.0 {
            true => ((high - first) / every).floor(),
            false => 0.0,
        };
        let all = std::iter::successors(Some(0.0), move |k| Some(k + 1.0));
        let all = all.take_while(move |k| *k <= times);
        let all = all.map(move |k| first + k * every);
        all.filter(move |at| (low..=high).contains(at))
    }
}

/// Returns the coordinates at which a load has a kink or jumps, in no particular order. These are
/// knots over the driver's coordinate, and the begin, kinks and end of a press load. They include
/// kinks of springs, and change points, where joint forces have no limit.
pub(super) fn bends(mechanism: &Mechanism, solver: &Solver) -> Vec<Mark> {
    let mut marks = Vec::new();
    let motion = solver.motion();
    let period = match motion.range {
        Range::Full { period } => period,
        Range::Limited { .. } => 0.0,
    };
    let is_rotary = matches!(mechanism.driver().input, Input::Turn(_));
    for profile in profiles(mechanism) {
        let every = match turns_of(profile) {
            Some(integer) if is_rotary => TURN * integer as f64,
            Some(_) | None => 0.0,
        };
        let knots = profile.knots().iter();
        marks.extend(knots.map(|&[at, _]| Mark { at, every }));
    }
    let mut at = motion.change_points.clone();
    let bends = SpringBends::over(solver);
    mechanism
        .loads()
        .iter()
        .for_each(|load| bends.of(load, &mut at));
    for load in mechanism.loads() {
        let Load::Press { slide, end, curve } = load else {
            continue;
        };
        let end = RamEnd {
            end: *end,
            is_known: true,
        };
        let Ok(mut ram) = Ram::new(mechanism, solver, *slide, end) else {
            continue;
        };
        ram.turns(&mut at);
        for knot in curve.knots() {
            ram.coordinates(knot[0], &mut at);
        }
    }
    let every = period;
    marks.extend(at.into_iter().map(|at| Mark { at, every }));
    marks
}

/// Returns the travels in a cycle at which a load has a kink or jumps, in no particular order.
pub(super) fn marks(mechanism: &Mechanism, solver: &Solver, course: &CyclePath) -> Vec<f64> {
    let mut travels = Vec::new();
    for Mark { at, every } in bends(mechanism, solver) {
        course.ways(at, every, &mut travels);
    }
    if restarts(mechanism) {
        travels.push(0.0);
    }
    travels
}

/// Returns `true` if a load over the driver's coordinate is not periodic: it restarts with the
/// cycle, where it may jump.
fn restarts(mechanism: &Mechanism) -> bool {
    let is_rotary = matches!(mechanism.driver().input, Input::Turn(_));
    let comes_again = |profile: &Profile| is_rotary && turns_of(profile).is_some();
    profiles(mechanism).any(|profile| !comes_again(profile) && !profile.is_one())
}

/// Returns the driver's coordinates within a range at which a load has a kink or jumps. The range
/// is that of the motion, or as many periods as the loads need to repeat.
pub(in crate::study) fn bends_within(solver: &Solver, range: Range) -> Vec<f64> {
    let mechanism = solver.mechanism();
    let (low, high) = range.ends();
    let bends = bends(mechanism, solver).into_iter();
    let start = restarts(mechanism).then_some(low);
    bends
        .flat_map(|mark| mark.between(low, high))
        .chain(start)
        .collect()
}
