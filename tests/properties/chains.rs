//! Tests chains of loops with a known exact motion: parallelograms, antiparallelograms and kites in
//! any order and of any size, all folded into one line at the same time, anywhere in the plane and
//! at any angle.
//!
//! The rocker of each loop is the crank of the next. A chain either follows its exact motion or its
//! range ends earlier: it must never follow another motion. `KRANK_CHAINS` is the number of chains.

use crate::plant::unit;
use krank::solver::{Condition, Order, Range, Solver};
use krank::{Builder, Double, Driver, Input, PointId, Vec2};

/// Number of positions over a chain's range at which it is compared with its exact motion.
const STATES: u32 = 64;
/// Maximum distance from the exact position, relative to the chain's size.
const MAX_DISTANCE: f64 = 1e-9;

/// Pseudo-random numbers (xorshift).
struct TestRng(u64);

impl TestRng {
    fn new(seed: u64) -> TestRng {
        let mut rng = TestRng(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        for _ in 0..8 {
            rng.next();
        }
        rng
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, maximum: usize) -> usize {
        (self.next() >> 20) as usize % maximum
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Parallelogram,
    Antiparallelogram,
    Kite,
}

/// A loop of a chain: its driving crank, frame, coupler and rocker.
#[derive(Clone, Copy, Debug)]
struct Loop {
    kind: Kind,
    crank: f64,
    frame: f64,
    coupler: f64,
    rocker: f64,
}

impl Loop {
    fn drawn(kind: Kind, crank: f64, rng: &mut TestRng) -> Loop {
        match kind {
            Kind::Parallelogram | Kind::Antiparallelogram => {
                let ratio = rng.within(1.3, 3.5);
                let frame = if rng.below(2) == 0 {
                    crank * ratio
                } else {
                    crank / ratio
                };
                Loop {
                    kind,
                    crank,
                    frame,
                    coupler: frame,
                    rocker: crank,
                }
            }
            Kind::Kite => {
                let long = crank * rng.within(1.1, 1.6);
                Loop {
                    kind,
                    crank,
                    frame: crank,
                    coupler: long,
                    rocker: long,
                }
            }
        }
    }

    /// Returns the rocker's angle for a crank angle, both in radians from the line of the pivots,
    /// continued smoothly.
    fn rocker_at(&self, crank: f64) -> f64 {
        let (a, g) = (self.crank, self.frame);
        match self.kind {
            Kind::Parallelogram => crank,
            // Mirrored in the line from the rocker's pivot to the crank's pin.
            Kind::Antiparallelogram => {
                let (sin, cos) = crank.sin_cos();
                if a < g {
                    -2.0 * (a * sin).atan2(g - a * cos) - crank
                } else {
                    2.0 * (g * sin).atan2(a - g * cos) + crank
                }
            }
            // The apex lies on the line that halves the angle between crank and frame.
            Kind::Kite => {
                let half = 0.5 * crank;
                half + (g / self.rocker * half.sin()).asin()
            }
        }
    }

    /// Returns the maximum ratio of the rocker's speed to the crank's.
    fn quickest(&self) -> f64 {
        let (a, g) = (self.crank, self.frame);
        match self.kind {
            Kind::Parallelogram | Kind::Kite => 1.0,
            Kind::Antiparallelogram => (g + a) / (g - a).abs(),
        }
    }
}

/// A chain of loops with its first pivot at `place` and its line at `turn` degrees.
#[derive(Clone, Debug)]
struct Chain {
    loops: Vec<Loop>,
    position: Vec2,
    turn: f64,
    start: f64,
}

/// The result for a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Verdict {
    Right,
    /// The range ends although the motion continues.
    Refused,
    Wrong,
}

impl Chain {
    fn drawn(seed: u64) -> Chain {
        let mut rng = TestRng::new(seed);
        let count = 1 + rng.below(15);
        let mut crank = rng.within(0.5, 2.0);
        let mut loops = Vec::new();
        for _ in 0..count {
            let kind = [Kind::Parallelogram, Kind::Antiparallelogram, Kind::Kite][rng.below(3)];
            let new = Loop::drawn(kind, crank, &mut rng);
            crank = new.rocker;
            loops.push(new);
        }
        let position = match rng.below(2) {
            0 => Vec2::ZERO,
            _ => Vec2::new(rng.within(-50.0, 50.0), rng.within(-50.0, 50.0)),
        };
        let turn = [0.0, 90.0, rng.within(0.0, 360.0), rng.within(0.0, 360.0)][rng.below(4)];
        let start = rng.within(30.0, 150.0);
        Chain {
            loops,
            position,
            turn,
            start,
        }
    }

    /// Returns the positions of the pins with the first crank at an angle in degrees from the
    /// chain's line.
    fn pins(&self, crank: f64) -> Vec<Vec2> {
        let along = unit(self.turn);
        let mut pivot = self.position;
        let mut angle = crank.to_radians();
        let pins = self.loops.iter().map(|l| {
            pivot += along * l.frame;
            angle = l.rocker_at(angle);
            pivot + along.turned(unit(angle.to_degrees())) * l.rocker
        });
        pins.collect()
    }

    fn period(&self) -> f64 {
        let kites = self.loops.iter().filter(|l| l.kind == Kind::Kite).count();
        360.0 * f64::from(kites as u32).exp2()
    }

    /// Returns the product of the loops' maximum speed ratios.
    fn gearing(&self) -> f64 {
        self.loops.iter().map(Loop::quickest).product()
    }

    fn open(&self) -> (Solver, Vec<PointId>) {
        let mut m = Builder::default();
        // Pivots are in line in double-double arithmetic, then rounded.
        let along = Double::unit(self.turn);
        let mut so_far = Double::ZERO;
        let pivot = m.ground_point(self.position.x, self.position.y);
        let mut pin = m.moving_point();
        let first = self.loops[0].crank;
        let crank = m.link(pivot, pin, first);
        m.driver(Driver {
            input: Input::Turn(crank),
            start: self.start + self.turn,
            speed: 1.0,
            acceleration: 0.0,
        });
        let mut pins = Vec::new();
        for (l, start) in self.loops.iter().zip(self.pins(self.start)) {
            so_far += Double::exactly(l.frame);
            let at = self.position.exactly() + along * so_far;
            let pivot = m.ground_point(at.x.hi, at.y.hi);
            let joint = m.moving_point();
            m.link(pin, joint, l.coupler);
            m.link(pivot, joint, l.rocker);
            m.start(joint, start);
            pins.push(joint);
            pin = joint;
        }
        (Solver::new(&m.build().unwrap()).unwrap(), pins)
    }

    /// Compares the chain with its exact motion over its whole range.
    fn check_motion(&self) -> Verdict {
        let (solver, pins) = self.open();
        let range = solver.motion().range;
        let (low, high) = range.ends();
        let size: f64 = self.loops.iter().map(|l| l.frame + l.rocker).sum();
        // The rounding error of the exact motion in doubles.
        let own = 1e-15 * size * self.gearing();
        let mut state = solver.state();
        let mut enclosure = solver.enclosure();
        for k in 0..STATES {
            let at = low + (high - low) * (f64::from(k) + 0.37) / f64::from(STATES);
            if solver.solve(at, Order::Position, &mut state) != Condition::Ok {
                return Verdict::Wrong;
            }
            solver.enclose(&mut state, Order::Position, &mut enclosure);
            for (&pin, expected) in pins.iter().zip(self.pins(at - self.turn)) {
                let (position, ball) = (
                    state.position(pin).unwrap(),
                    enclosure.position(pin).unwrap(),
                );
                let off = (position - expected).norm();
                let bound = ball.x.bound(position.x).zip(ball.y.bound(position.y));
                let is_bounded = bound.is_none_or(|(x, y)| off <= x.hypot(y) + own);
                if !(off <= MAX_DISTANCE * size && is_bounded) {
                    return Verdict::Wrong;
                }
            }
        }
        let is_whole = match range {
            Range::Full { period } => period == self.period(),
            // Tracking stops after this many turns in any case.
            Range::Limited { low, high } => high - low > 360.0 * 16.0,
        };
        if is_whole {
            Verdict::Right
        } else {
            Verdict::Refused
        }
    }
}

#[test]
fn chains_follow_their_exact_motion_or_end() {
    let number = |name: &str, otherwise: u64| {
        let given = std::env::var(name).ok().and_then(|n| n.parse().ok());
        given.unwrap_or(otherwise)
    };
    let (cases, from) = (number("KRANK_CHAINS", 40), number("KRANK_CHAINS_FROM", 1));
    let mut counts = [0; 3];
    for seed in from..from + cases {
        let chain = Chain::drawn(seed);
        let verdict = chain.check_motion();
        if verdict != Verdict::Right {
            eprintln!("{seed}: {verdict:?}: {chain:?}");
        }
        counts[verdict as usize] += 1;
    }
    let [right, refused, wrong] = counts;
    eprintln!("of {cases} chains {right} are right, {refused} end early, {wrong} are wrong");
    assert_eq!(wrong, 0);
    assert!(50 * refused <= cases, "{refused} of {cases} end early");
}

/// Chains of kites in which rounding separates change points that coincide: the second one was passed twice.
#[test]
fn chains_of_kites_follow_their_exact_motion() {
    for seed in [104, 106, 171] {
        assert_eq!(
            Chain::drawn(seed).check_motion(),
            Verdict::Right,
            "seed {seed}"
        );
    }
}

/// Regression test with cranks of 1 and pivots 1.5 apart: the second pin followed a mixture of
/// parallelogram and antiparallelogram.
#[test]
fn two_equal_parallelograms_in_series_only_translate() {
    let equal = Loop {
        kind: Kind::Parallelogram,
        crank: 1.0,
        frame: 1.5,
        coupler: 1.5,
        rocker: 1.0,
    };
    let chain = Chain {
        loops: vec![equal; 2],
        position: Vec2::ZERO,
        turn: 0.0,
        start: 60.0,
    };
    let (solver, pins) = chain.open();
    assert_eq!(solver.motion().range, Range::Full { period: 360.0 });
    assert_eq!(solver.motion().change_points, [0.0, 180.0]);
    let mut state = solver.state();
    for at in [-300.0, -1e-3, 0.0, 1e-9, 90.0, 180.0, 300.0] {
        let condition = solver.solve(at, Order::Acceleration, &mut state);
        assert_ne!(condition, Condition::NoAssembly, "at {at}");
        let crank = krank::angle::unit(at);
        for (&pin, along) in pins.iter().zip([1.5, 3.0]) {
            let off = state.position(pin).unwrap() - (crank + Vec2::new(along, 0.0));
            assert!(off.norm() < 1e-14, "{off:?} at {at}");
            let off = state.velocity(pin).unwrap() - crank.perp();
            assert!(off.norm() < 1e-13, "{off:?} at {at}");
            let off = state.acceleration(pin).unwrap() + crank;
            assert!(off.norm() < 1e-11, "{off:?} at {at}");
        }
    }
}
