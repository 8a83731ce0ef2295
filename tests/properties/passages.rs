//! Tests change points at known positions: parallelograms, kites and slider-cranks with rod =
//! crank, rotated and translated. The exact motion is known without a solver.

use crate::plant::*;
use krank::solver::{Condition, Order, Range, Solver, State};
use krank::{Body, Builder, Driver, Input, LinkId, PointId, Vec2};
use proptest::prelude::*;

/// Position and orientation of a mechanism in the plane.
#[derive(Clone, Copy, Debug)]
struct Place {
    turn: f64,
    shift: Vec2,
}

fn place() -> impl Strategy<Value = Place> {
    let shift = [-1e3..1e3_f64, -1e3..1e3_f64];
    let turn = prop_oneof![angle(), Just(0.0), Just(90.0), Just(23.456)];
    (turn, shift).prop_map(|(turn, [x, y])| Place {
        turn,
        shift: Vec2::new(x, y),
    })
}

impl Place {
    fn put(self, at: Vec2) -> Vec2 {
        at.turned(unit(self.turn)) + self.shift
    }
}

fn turning(link: LinkId, start: f64) -> Driver {
    Driver {
        input: Input::Turn(link),
        start,
        speed: 1.0,
        acceleration: 0.0,
    }
}

/// Creates a four-bar whose frame lies along x before it is placed, with its joint and the links
/// that meet there.
fn four_bar(
    of: Place,
    [a, b, c, d]: [f64; 4],
    start: f64,
    near: Vec2,
) -> (Solver, PointId, [LinkId; 2]) {
    let mut m = Builder::default();
    let [pivot, far] = [Vec2::ZERO, Vec2::new(d, 0.0)].map(|p| {
        let p = of.put(p);
        m.ground_point(p.x, p.y)
    });
    let (pin, joint) = (m.moving_point(), m.moving_point());
    let crank = m.link(pivot, pin, a);
    let links = [m.link(pin, joint, b), m.link(far, joint, c)];
    m.driver(turning(crank, start + of.turn));
    m.start(joint, of.put(near));
    (Solver::new(&m.build().unwrap()).unwrap(), joint, links)
}

fn solved(solver: &Solver, at: f64) -> State {
    let mut state = solver.state();
    let condition = solver.solve(at, Order::Acceleration, &mut state);
    assert!(
        matches!(condition, Condition::Ok | Condition::ChangePoint),
        "{condition:?} at {at}"
    );
    state.into_state()
}

/// Returns angles far from a change point, close to it, and at it.
fn angles(motion: &krank::solver::Motion, period: f64) -> Vec<f64> {
    let far = (0..48).map(|k| 0.3 + period * f64::from(k) / 48.0);
    let near = motion.change_points.iter().flat_map(|&at| {
        [-1.0, 0.0, 1.0]
            .into_iter()
            .flat_map(move |side| (0..7).map(move |k| at + side * 10.0_f64.powi(-2 * k)))
    });
    far.chain(near).collect()
}

/// Returns the distance of an angle from the nearest change point, as a sine, and at least the zone
/// of the series.
fn sine(motion: &krank::solver::Motion, at: f64) -> f64 {
    let off = |p: &f64| ((at - p) / 2.0).to_radians().sin().abs() * 2.0;
    motion
        .change_points
        .iter()
        .map(off)
        .fold(1.0, f64::min)
        .max(0.01)
}

proptest! {
    #[test]
    fn parallelogram_stays_a_parallelogram_at_change_points(of in place(), crank in length(), frame in length(), start in 20.0..160.0_f64) {
        prop_assume!((crank / frame - 1.0).abs() > 0.05);
        let near = unit(start) * crank + Vec2::new(frame, 0.0);
        let (solver, joint, [coupler, follower]) = four_bar(of, [crank, frame, crank, frame], start, near);
        let motion = solver.motion();
        prop_assert_eq!(motion.range, Range::Full { period: 360.0 });
        prop_assert_eq!(motion.change_points.len(), 2, "{:?}", motion.change_points);
        // The frame's direction has the rounding of its coordinates.
        let rounding = 1e-15 * (1.0 + of.shift.norm() / frame) * (crank + frame) / crank.min(frame);
        for at in angles(motion, 360.0) {
            let (state, s) = (solved(&solver, at), sine(motion, at));
            let expected = unit(at) * crank + of.put(Vec2::new(frame, 0.0));
            let off = (state.position(joint).unwrap() - expected).norm();
            prop_assert!(off <= 30.0 * rounding * (crank + frame) / s, "{off:e} at {at}");
            let off = state.omega(coupler).unwrap().abs().max((state.omega(follower).unwrap() - 1.0).abs());
            prop_assert!(off <= 100.0 * rounding / (s * s), "omega {off:e} at {at}");
            let off = state.alpha(coupler).unwrap().abs().max(state.alpha(follower).unwrap().abs());
            prop_assert!(off <= 1000.0 * rounding / (s * s * s), "alpha {off:e} at {at}");
        }
    }

    /// C = rho (cos, sin)(theta / 2) with rho = a cos(theta / 2) + sqrt(b^2 - a^2 sin^2(theta / 2)).
    #[test]
    fn kite_follows_its_two_turn_motion(of in place(), short in length(), more in 1.1..8.0_f64, start in 30.0..330.0_f64) {
        let long = short * more;
        let joint_at = |at: f64| {
            let half = unit(at / 2.0);
            half * (short * half.x + (long * long - short * short * half.y * half.y).sqrt())
        };
        let (solver, joint, _) = four_bar(of, [short, long, long, short], start, joint_at(start));
        let motion = solver.motion();
        prop_assert_eq!(motion.range, Range::Full { period: 720.0 });
        prop_assert_eq!(motion.change_points.len(), 2, "{:?}", motion.change_points);
        let rounding = 1e-15 * (1.0 + of.shift.norm() / short) * more;
        for at in angles(motion, 720.0) {
            let (state, s) = (solved(&solver, at), sine(motion, at));
            let off = (state.position(joint).unwrap() - of.put(joint_at(at - of.turn))).norm();
            prop_assert!(off <= 30.0 * rounding * long / s, "{off:e} at {at}");
        }
    }

    /// Rod = crank, in line: the slider keeps x = 2 r cos and passes the crank's pivot.
    #[test]
    fn slider_with_equal_rod_and_crank_passes_the_pivot(of in place(), crank in length(), start in -70.0..70.0_f64) {
        let mut m = Builder::default();
        let pivot = m.ground_point(of.shift.x, of.shift.y);
        let (pin, slider) = (m.moving_point(), m.moving_point());
        let driven = m.link(pivot, pin, crank);
        let rod = m.link(pin, slider, crank);
        let slide = m.pin_in_slot(slider, Body::Ground, of.shift, of.turn);
        m.driver(turning(driven, start + of.turn));
        m.start(slider, of.put(Vec2::new(2.0 * crank * start.to_radians().cos(), 0.0)));
        let solver = Solver::new(&m.build().unwrap()).unwrap();
        let motion = solver.motion();
        prop_assert_eq!(motion.range, Range::Full { period: 360.0 });
        prop_assert_eq!(motion.change_points.len(), 2, "{:?}", motion.change_points);
        let rounding = 1e-15 * (1.0 + of.shift.norm() / crank);
        for at in angles(motion, 360.0) {
            let (state, s) = (solved(&solver, at), sine(motion, at));
            let expected = unit(at - of.turn) * (2.0 * crank);
            let travel = state.travel(slide).unwrap();
            prop_assert!((travel.position - expected.x).abs() <= 30.0 * rounding * crank / s, "at {at}");
            prop_assert!((travel.rate.unwrap() + expected.y).abs() <= 100.0 * rounding * crank / (s * s), "at {at}");
            prop_assert!((travel.accel.unwrap() + expected.x).abs() <= 1000.0 * rounding * crank / (s * s * s), "at {at}");
            prop_assert!((state.omega(rod).unwrap() + 1.0).abs() <= 100.0 * rounding / (s * s), "at {at}");
        }
    }

    /// A limit does not depend on the opening angle, and is the double closest to the zero of the
    /// dyad's reach, whose cosine is rational in the lengths.
    #[test]
    fn rocker_limits_agree_with_law_of_cosines(
        of in place(),
        lengths in [length(), length(), length(), length()],
        side in sign(),
        share in 0.1..0.9_f64,
    ) {
        // The driven link connects D and C; A, B and C are in line at its limits.
        let [driven, a, b, d] = lengths;
        let of = Place { shift: Vec2::ZERO, ..of };
        let angle_at = |reach: f64| {
            let cosine = (driven * driven + d * d - reach * reach) / (2.0 * driven * d);
            (cosine.abs() < 0.999).then(|| cosine.acos())
        };
        let (Some(low), Some(high)) = (angle_at((a - b).abs()), angle_at(a + b)) else { return Ok(()) };
        prop_assume!(high - low > 0.1 && (a - b).abs() > 0.05 * (a + b));
        let start = (low + share * (high - low)).to_degrees();
        let mut m = Builder::default();
        let [pivot, far] = [Vec2::ZERO, Vec2::new(d, 0.0).turned(unit(of.turn))].map(|p| m.ground_point(p.x, p.y));
        let (pin, joint) = (m.moving_point(), m.moving_point());
        let crank = m.link(pivot, pin, driven);
        m.link(pin, joint, b);
        m.link(far, joint, a);
        m.driver(turning(crank, start + of.turn));
        let (from, to) = (unit(start) * driven, Vec2::new(d, 0.0));
        m.start(joint, ((from + to) * 0.5 + (to - from).perp() * (side * 0.6)).turned(unit(of.turn)));
        let Ok(solver) = Solver::new(&m.build().unwrap()) else { return Ok(()) };
        let Range::Limited { low: found_low, high: found_high } = solver.motion().range else {
            panic!("{:?}", solver.motion().range)
        };
        for (found, expected, reach) in [(found_low, low, (a - b).abs()), (found_high, high, a + b)] {
            // d(angle) = reach d(reach) / (driven d sin): the test's own rounding error.
            let slack = 16.0 * f64::EPSILON * (reach * (a + b) + driven * driven + d * d) / (driven * d * expected.sin());
            let off = (found - of.turn).to_radians() - expected;
            prop_assert!(off.abs() <= slack + 4e-15, "{found} {expected} {off:e} {slack:e}");
            let mut state = solver.state();
            prop_assert_eq!(solver.solve(found, Order::Acceleration, &mut state), Condition::DeadPoint);
        }
    }
}

/// A parallelogram with cranks of 1 and a frame of 3, driven where its loop is coupled with
/// another: point E of its platform moves on a circle of radius 1, and G, F, E and the circle's
/// centre form a drag link.
#[derive(Clone, Copy, Debug)]
struct Inside {
    of: Place,
    driver: f64,
    rod: f64,
    frame: f64,
    /// The position of E on the platform.
    on: Vec2,
    start: f64,
}

fn inside() -> impl Strategy<Value = Inside> {
    let lengths = (0.9..1.6_f64, 0.7..1.5_f64, 0.2..0.6_f64);
    let on = [0.2..2.8_f64, -1.0..1.5_f64];
    (place(), lengths, on, angle())
        .prop_map(|(of, (driver, rod, frame), [x, y], start)| Inside {
            of,
            driver,
            rod,
            frame,
            on: Vec2::new(x, y),
            start,
        })
        .prop_filter("both cranks turn, and not by a hair", |i| {
            let mut sorted = [i.driver, i.rod, i.frame, 1.0];
            sorted.sort_by(f64::total_cmp);
            let [s, p, q, l] = sorted;
            s == i.frame && p + q - (s + l) > 0.05 && (i.driver - 1.0).abs() < i.rod
        })
}

impl Inside {
    /// Returns the direction of the parallelogram's cranks at an angle of the driver.
    fn follower(&self, at: f64) -> Vec2 {
        let pin = unit(at) * self.driver + Vec2::new(self.frame, 0.0);
        let d2 = pin.norm2();
        let along = 0.5 * (d2 + 1.0 - self.rod * self.rod);
        let across = (d2 - along * along).sqrt();
        (pin * along - pin.perp() * across) / d2
    }

    fn open(&self) -> (Solver, LinkId, PointId) {
        let mut m = Builder::default();
        let centre = self.on;
        let positions = [
            Vec2::ZERO,
            Vec2::new(3.0, 0.0),
            centre + Vec2::new(self.frame, 0.0),
        ];
        let [a, d, g] = positions.map(|p| {
            let p = self.of.put(p);
            m.ground_point(p.x, p.y)
        });
        let [b, c, e, f] = [(); 4].map(|()| m.moving_point());
        let driven = m.link(g, f, self.driver);
        m.link(f, e, self.rod);
        let platform = m.link(b, c, 3.0);
        m.carry(platform, e, self.on);
        m.link(a, b, 1.0);
        m.link(d, c, 1.0);
        m.driver(turning(driven, self.start + self.of.turn));
        let to = self.follower(self.start);
        m.start(b, self.of.put(to));
        m.start(c, self.of.put(to + Vec2::new(3.0, 0.0)));
        m.start(e, self.of.put(to + centre));
        (Solver::new(&m.build().unwrap()).unwrap(), platform, e)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn parallelogram_in_a_coupled_group_stays_a_parallelogram(inside in inside()) {
        // Away from its change points it opens as a parallelogram.
        prop_assume!(inside.follower(inside.start).y.abs() > 0.2);
        let (solver, platform, e) = inside.open();
        let motion = solver.motion();
        prop_assert_eq!(motion.range, Range::Full { period: 360.0 });
        prop_assert_eq!(motion.change_points.len(), 2, "{:?}", motion.change_points);
        let size = 1.0 + inside.of.shift.norm();
        for &at in &motion.change_points {
            let across = inside.follower(at - inside.of.turn).y;
            prop_assert!(across.abs() < 1e-13 * size, "{across:e} at {at}");
        }
        for at in angles(motion, 360.0) {
            let state = solved(&solver, at);
            let to = inside.follower(at - inside.of.turn);
            let s = to.y.abs().max(0.01);
            let off = (state.position(e).unwrap() - inside.of.put(to + inside.on)).norm();
            prop_assert!(off < 1e-13 * size / s, "{off:e} at {at}");
            prop_assert!(state.omega(platform).unwrap().abs() < 1e-12 * size / (s * s), "at {at}");
            prop_assert!(state.alpha(platform).unwrap().abs() < 1e-11 * size / (s * s * s), "at {at}");
        }
    }
}
