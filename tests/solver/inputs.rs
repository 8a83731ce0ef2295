//! Inputs that follow the driver: machines with two timed cranks or two cylinders.
//!
//! Positions are compared with the mechanism itself and rates with differences, as in `states`.
//! Input coordinates are compared with p = ratio q + phase, and forces with the virtual work of
//! position differences.

use super::states::{at, check, kinds, push, solver, turn};
use krank::solver::{Condition, Demand, Fault, GroupKind, Order, Plan, Range, Solver};
use krank::{
    Body, Builder, Input, InputLaw, LANES, LinkId, Load, Mechanism, PointId, Profile, TimedInput,
    Vec2, angle,
};

const GROUND: Body = Body::Ground;

/// A function that builds a mechanism whose further input follows a law, and returns the loaded
/// point.
pub(super) type Build = fn(InputLaw) -> (Builder, PointId);

fn line(ratio: f64, phase: f64) -> InputLaw {
    InputLaw::Ratio { ratio, phase }
}

fn follow(b: &mut Builder, input: Input, law: InputLaw) {
    b.timed(TimedInput { input, law });
}

/// Creates two cranks of lengths 1 and 0.8, with pivots 3 apart, and a dyad of 2.6 and 2.4 between
/// their pins.
pub(super) fn five_bar(law: InputLaw) -> (Builder, PointId) {
    let mut b = Builder::default();
    let [a, e] = [(0.0, 0.0), (3.0, 0.0)].map(|(x, y)| b.ground_point(x, y));
    let [one, two, c] = [(); 3].map(|()| b.moving_point());
    let driven = b.link(a, one, 1.0);
    b.driver(turn(driven, 50.0));
    let other = b.link(e, two, 0.8);
    follow(&mut b, Input::Turn(other), law);
    b.link(one, c, 2.6);
    b.link(two, c, 2.4);
    b.start(c, Vec2::new(1.5, 2.5));
    (b, c)
}

/// Creates a boom lifted by one cylinder, with an arm that another cylinder swings.
fn excavator(law: InputLaw) -> (Builder, PointId) {
    let mut b = Builder::default();
    let [o, g] = [(0.0, 0.0), (0.2, -0.1)].map(|(x, y)| b.ground_point(x, y));
    let [p, q, j, r, tip] = [(); 5].map(|()| b.moving_point());
    let boom = b.free_link();
    for (point, x, y) in [(o, 0.0, 0.0), (p, 0.4, 0.15), (q, 0.5, 0.2), (j, 0.9, 0.0)] {
        b.carry(boom, point, Vec2::new(x, y));
    }
    let arm = b.free_link();
    for (point, x, y) in [(j, 0.0, 0.0), (r, -0.15, 0.06), (tip, 0.6, 0.0)] {
        b.carry(arm, point, Vec2::new(x, y));
    }
    let barrels = [g, q].map(|pivot| {
        let barrel = b.free_link();
        b.carry(barrel, pivot, Vec2::ZERO);
        barrel
    });
    // The second rod is offset from its pivot.
    let lift = b.pin_in_slot(p, Body::Link(barrels[0]), Vec2::ZERO, 0.0);
    let swing = b.pin_in_slot(r, Body::Link(barrels[1]), Vec2::new(0.0, 0.02), 0.0);
    b.driver(push(lift, 0.5));
    follow(&mut b, Input::Push(swing), law);
    b.start(p, Vec2::new(0.3, 0.3));
    b.start(j, Vec2::new(0.8, 0.3));
    b.start(r, Vec2::new(0.7, 0.4));
    (b, tip)
}

/// Creates a crank, and a block on the ground pushed as the crank turns.
fn crank_and_block(law: InputLaw) -> (Builder, PointId) {
    let mut b = Builder::default();
    let o = b.ground_point(0.0, 0.0);
    let [one, two, c] = [(); 3].map(|()| b.moving_point());
    let crank = b.link(o, one, 1.0);
    b.driver(turn(crank, 50.0));
    let block = b.pin_in_slot(two, GROUND, Vec2::new(2.0, -0.5), 20.0);
    follow(&mut b, Input::Push(block), law);
    b.link(one, c, 2.6);
    b.link(two, c, 2.4);
    b.start(c, Vec2::new(1.5, 2.5));
    (b, c)
}

/// Creates a pushed block, and a crank that turns with it.
fn block_and_crank(law: InputLaw) -> (Builder, PointId) {
    let mut b = Builder::default();
    let o = b.ground_point(0.0, 0.0);
    let [one, two, c] = [(); 3].map(|()| b.moving_point());
    let crank = b.link(o, one, 1.0);
    let block = b.pin_in_slot(two, GROUND, Vec2::new(2.0, -0.5), 20.0);
    b.driver(push(block, 0.3));
    follow(&mut b, Input::Turn(crank), law);
    b.link(one, c, 2.6);
    b.link(two, c, 2.4);
    b.start(c, Vec2::new(1.5, 2.5));
    (b, c)
}

/// Creates a crank with a rod that extends as the crank turns.
pub(super) fn growing_crank(law: InputLaw) -> (Builder, PointId) {
    let mut b = Builder::default();
    let [o, e] = [(0.0, 0.0), (3.0, 0.0)].map(|(x, y)| b.ground_point(x, y));
    let [pin, tip, c] = [(); 3].map(|()| b.moving_point());
    let crank = b.link(o, pin, 0.5);
    b.driver(turn(crank, 50.0));
    let rod = b.pin_in_slot(tip, Body::Link(crank), Vec2::new(0.2, 0.1), 15.0);
    follow(&mut b, Input::Push(rod), law);
    b.link(tip, c, 2.6);
    b.link(e, c, 2.4);
    b.start(c, Vec2::new(1.5, 2.0));
    (b, c)
}

/// Creates a triangle on three bars, from two timed cranks and from the ground: four links in one
/// group.
fn triad(law: InputLaw) -> (Builder, PointId) {
    let mut b = Builder::default();
    let [a, e, g] = [(0.0, 0.0), (4.0, 0.0), (2.0, 5.0)].map(|(x, y)| b.ground_point(x, y));
    let [one, two, p, q, r] = [(); 5].map(|()| b.moving_point());
    let driven = b.link(a, one, 0.5);
    b.driver(turn(driven, 50.0));
    let other = b.link(e, two, 0.4);
    follow(&mut b, Input::Turn(other), law);
    let plate = b.free_link();
    for (point, x, y) in [(p, 0.0, 0.0), (q, 1.4, 0.0), (r, 0.7, 1.1)] {
        b.carry(plate, point, Vec2::new(x, y));
    }
    b.link(one, p, 2.2);
    b.link(two, q, 2.3);
    b.link(g, r, 2.4);
    b.start(p, Vec2::new(1.3, 1.9));
    b.start(q, Vec2::new(2.7, 1.9));
    b.start(r, Vec2::new(2.0, 3.0));
    (b, r)
}

/// Creates five bars, one of them turned, with a cylinder inside the loop.
fn strutted(law: InputLaw) -> (Builder, PointId) {
    let mut b = Builder::default();
    let [a, e] = [(0.0, 0.0), (3.0, 0.0)].map(|(x, y)| b.ground_point(x, y));
    let [one, two, c, p, q] = [(); 5].map(|()| b.moving_point());
    let driven = b.link(a, one, 0.4);
    b.driver(turn(driven, 50.0));
    let left = b.link(one, c, 2.6);
    let right = b.link(c, two, 1.9);
    b.link(two, e, 1.5);
    b.carry(left, p, Vec2::new(1.3, -0.2));
    b.carry(right, q, Vec2::new(1.0, 0.1));
    let barrel = b.free_link();
    b.carry(barrel, p, Vec2::ZERO);
    let rod = b.pin_in_slot(q, Body::Link(barrel), Vec2::new(0.0, 0.05), 0.0);
    follow(&mut b, Input::Push(rod), law);
    b.start(c, Vec2::new(1.5, 2.2));
    b.start(two, Vec2::new(2.8, 1.4));
    b.start(p, Vec2::new(1.0, 1.0));
    b.start(q, Vec2::new(2.2, 1.7));
    (b, c)
}

/// Machines with a ratio, a phase, and the kinds of the groups after the driver's.
pub(super) const MACHINES: [(Build, f64, f64, &[GroupKind]); 8] = [
    (five_bar, 1.0, 30.0, &[GroupKind::Rrr]),
    (five_bar, -2.0, 110.0, &[GroupKind::Rrr]),
    (excavator, -0.4, 0.62, &[GroupKind::Rrr, GroupKind::Rrr]),
    (crank_and_block, 0.004, 0.2, &[GroupKind::Rrr]),
    (block_and_crank, 70.0, 40.0, &[GroupKind::Rrr]),
    (growing_crank, 0.002, 0.4, &[GroupKind::Rrr]),
    (triad, -1.0, 140.0, &[GroupKind::Coupled { unknowns: 3 }]),
    (strutted, 0.0005, 1.1, &[GroupKind::Coupled { unknowns: 0 }]),
];

pub(super) fn range(solver: &Solver) -> (f64, f64) {
    match solver.motion().range {
        Range::Full { period } => (0.0, period),
        // A sufficient part of the range.
        Range::Limited { low, high } => (low.max(-400.0), high.min(400.0)),
    }
}

pub(super) fn places(solver: &Solver) -> Vec<f64> {
    let (low, high) = range(solver);
    let place = |k: u8| low + (high - low) * (f64::from(k) + 0.37) / 32.0;
    (1..31).map(place).collect()
}

#[test]
fn groups_behind_timed_inputs_have_exact_rates() {
    for (number, (build, ratio, phase, expected)) in MACHINES.into_iter().enumerate() {
        let (m, s) = solver(build(line(ratio, phase)).0);
        let is_same = |(seen, expected): (&GroupKind, &GroupKind)| match expected {
            GroupKind::Coupled { .. } => matches!(seen, GroupKind::Coupled { .. }),
            other => seen == other,
        };
        let found = kinds(&s);
        assert_eq!(found.len(), expected.len() + 1, "{number}: {found:?}");
        assert!(found[1..].iter().zip(expected).all(is_same), "{found:?}");
        assert_eq!(s.plan().mobility, 2);
        check(&m, &s);
    }
}

/// p = ratio q + phase, p' = ratio q' and p'' = ratio q'', each in its own unit.
#[test]
fn timed_input_follows_ratio_and_phase() {
    for (build, ratio, phase, _) in MACHINES {
        let (m, s) = solver(build(line(ratio, phase)).0);
        let driver = *m.driver();
        let timed = &m.timed()[0];
        for q in places(&s) {
            let state = at(&s, q);
            let p = ratio * q + phase;
            let is_rotary = matches!(driver.input, Input::Turn(_));
            let per = |own: bool| match (is_rotary, own) {
                (true, false) => 180.0 / std::f64::consts::PI,
                (false, true) => std::f64::consts::PI / 180.0,
                _ => 1.0,
            };
            let (seen, rates) = match timed.input {
                Input::Turn(link) => {
                    let off = state.direction(link).unwrap() - angle::unit(p);
                    let rates = [state.omega(link).unwrap(), state.alpha(link).unwrap()];
                    (off.norm(), rates)
                }
                Input::Push(slide) => {
                    let travel = state.travel(slide).unwrap();
                    let rates = [travel.rate.unwrap(), travel.accel.unwrap()];
                    ((travel.position - p).abs(), rates)
                }
            };
            assert!(seen < 1e-12, "{seen:e} at {q}");
            let own = matches!(timed.input, Input::Turn(_));
            let expected = [driver.speed, driver.acceleration].map(|v| v * ratio * per(own));
            for (rate, expected) in rates.into_iter().zip(expected) {
                let off = (rate - expected).abs();
                assert!(off < 1e-11 * (1.0 + expected.abs()), "{rate} {expected}");
            }
        }
    }
}

/// The five-bar by the law of cosines: with d from pin to pin, C is x = (d^2 + 2.6^2 - 2.4^2) / 2 d
/// along it and sqrt(2.6^2 - x^2) to its left.
#[test]
fn five_bar_with_two_timed_cranks_matches_law_of_cosines() {
    let (builder, c) = five_bar(line(-2.0, 110.0));
    let (_, s) = solver(builder);
    for q in places(&s) {
        let turned = |degrees: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            (cos, sin)
        };
        let (one, two) = (turned(q), turned(110.0 - 2.0 * q));
        let (dx, dy) = (3.0 + 0.8 * two.0 - one.0, 0.8 * two.1 - one.1);
        let d = (dx * dx + dy * dy).sqrt();
        let x = (d * d + 2.6 * 2.6 - 2.4 * 2.4) / (2.0 * d);
        let y = (2.6 * 2.6 - x * x).sqrt();
        let expected = Vec2::new(one.0 + (x * dx - y * dy) / d, one.1 + (x * dy + y * dx) / d);
        let off = (at(&s, q).position(c).unwrap() - expected).norm();
        assert!(off < 1e-13, "{off:e} at {q}");
    }
}

/// The motion repeats when every crank has its initial position.
#[test]
fn period_is_common_period_of_all_cranks() {
    let period = |ratio: f64| match solver(five_bar(line(ratio, 30.0)).0).1.motion().range {
        Range::Full { period } => period,
        Range::Limited { low, high } => low - high,
    };
    for (ratio, expected) in [
        (1.0, 360.0),
        (-3.0, 360.0),
        (0.5, 720.0),
        (-1.5, 720.0),
        (1.0 / 3.0, 1080.0),
        (0.3, 3600.0),
    ] {
        assert_eq!(period(ratio), expected, "{ratio}");
    }
    // Within the followed part, the motion does not end.
    let (_, s) = solver(five_bar(line(0.712_345, 30.0)).0);
    let Range::Limited { low, high } = s.motion().range else {
        panic!("{:?}", s.motion().range);
    };
    assert!(high - low > 1e4, "{low} to {high}");
    assert!(s.motion().dead_points.is_empty());
}

#[test]
fn states_do_not_depend_on_history_and_match_lanes() {
    for (build, ratio, phase, _) in MACHINES {
        let (m, s) = solver(build(line(ratio, phase)).0);
        let coordinates = places(&s);
        let points = || m.point_ids();
        let mut shuffled = s.state();
        for &q in coordinates
            .iter()
            .rev()
            .step_by(7)
            .chain(coordinates.iter().step_by(3))
        {
            assert_eq!(
                s.solve(q, Order::Acceleration, &mut shuffled),
                Condition::Ok
            );
            let alone = at(&s, q);
            for p in points() {
                let close = (shuffled.position(p).unwrap() - alone.position(p).unwrap()).norm();
                assert!(close < 1e-13, "{close:e}");
                assert!(
                    (shuffled.acceleration(p).unwrap() - alone.acceleration(p).unwrap()).norm()
                        < 1e-9 * (1.0 + alone.acceleration(p).unwrap().norm())
                );
            }
        }
        let mut lanes = s.lanes();
        for at_once in coordinates.as_chunks::<LANES>().0 {
            if !s.solve_lanes(*at_once, Order::Acceleration, &mut lanes) {
                continue;
            }
            for (lane, &q) in at_once.iter().enumerate() {
                let alone = at(&s, q);
                for p in points() {
                    let (x, a) = (lanes.position(p).unwrap(), lanes.acceleration(p).unwrap());
                    assert_eq!(
                        x.x.0[lane].to_bits(),
                        alone.position(p).unwrap().x.to_bits()
                    );
                    let expected = alone.acceleration(p).unwrap().y;
                    assert_eq!(a.y.0[lane].to_bits(), expected.to_bits());
                }
            }
        }
    }
}

#[test]
fn bounds_contain_double_double_values() {
    for (build, ratio, phase, _) in MACHINES {
        let (m, s) = solver(build(line(ratio, phase)).0);
        let (mut workspace, mut balls, mut truth) = (s.state(), s.enclosure(), s.twice());
        for q in places(&s) {
            assert_eq!(
                s.solve(q, Order::Acceleration, &mut workspace),
                Condition::Ok
            );
            s.enclose(&mut workspace, Order::Acceleration, &mut balls);
            assert!(s.solve_twice(&workspace, Order::Acceleration, &mut truth));
            for p in m.point_ids() {
                let figures = [
                    (balls.position(p).unwrap().x, truth.position(p).unwrap().x),
                    (balls.velocity(p).unwrap().y, truth.velocity(p).unwrap().y),
                    (
                        balls.acceleration(p).unwrap().x,
                        truth.acceleration(p).unwrap().x,
                    ),
                ];
                for (ball, truth) in figures {
                    let miss = ((truth.hi - ball.mid) + truth.lo).abs();
                    assert!(miss <= ball.radius, "{miss:e} {ball:?} at {q}");
                    assert!(ball.radius < 1e-9 * (1.0 + ball.mid.abs()), "{ball:?}");
                }
            }
        }
    }
}

/// Compares the derivatives of the loaded point by a length with the same mechanism with that
/// length slightly longer and shorter.
#[test]
fn length_derivatives_match_difference_quotients() {
    const BY: f64 = 1e-6;
    for (build, ratio, phase, _) in MACHINES {
        let (builder, point) = build(line(ratio, phase));
        let (m, s) = solver(builder);
        let demand = Demand {
            points: vec![point],
            ..Demand::default()
        };
        let q = places(&s)[11];
        for length in m.lengths().into_iter().step_by(3) {
            let by_length = s.by_length(length, &demand).unwrap();
            let (mut workspace, mut dual) = (s.state(), by_length.state());
            assert_eq!(s.solve(q, Order::Velocity, &mut workspace), Condition::Ok);
            assert!(
                by_length.solve(&workspace, Order::Velocity, &mut dual),
                "{length:?}"
            );
            let [more, less] = [BY, -BY].map(|by| {
                let other = Solver::new(&m.changed(length, by)).unwrap();
                let state = at(&other, q);
                (
                    state.position(point).unwrap(),
                    state.velocity(point).unwrap(),
                )
            });
            let slopes = [
                (dual.position(point).unwrap().x, more.0.x - less.0.x),
                (dual.velocity(point).unwrap().y, more.1.y - less.1.y),
            ];
            for (dual, difference) in slopes {
                let expected = difference / (2.0 * BY);
                let off = (dual.slope - expected).abs();
                assert!(off < 1e-5 * (1.0 + expected.abs()), "{dual:?} {expected}");
            }
        }
    }
}

/// Returns the position of the loaded point at a coordinate, with the further input advanced by
/// `ahead`.
fn place(build: Build, (ratio, phase): (f64, f64), ahead: f64, q: f64) -> Vec2 {
    let (builder, point) = build(line(ratio, phase + ahead));
    let (_, s) = solver(builder);
    at(&s, q).position(point).unwrap()
}

/// The effort of an input is -F . dx/dp, with p its own coordinate in radians or lengths, by
/// differences. The driver's own effort is the rest: -F . dx/dq less p' times that.
#[test]
fn input_efforts_match_virtual_work() {
    const FORCE: Vec2 = Vec2::new(30.0, -170.0);
    for (build, ratio, phase, _) in MACHINES {
        let (mut builder, point) = build(line(ratio, phase));
        builder.load(Load::Force {
            point,
            force: FORCE,
            frame: GROUND,
            over: Profile::default(),
        });
        let (m, s) = solver(builder);
        let (driver, timed) = (*m.driver(), &m.timed()[0]);
        let unit = |input: Input| match input {
            Input::Turn(_) => 180.0 / std::f64::consts::PI,
            _ => 1.0,
        };
        let mut workspace = s.state();
        let (low, high) = range(&s);
        for k in [0.31, 0.52, 0.77] {
            let q = low + (high - low) * k;
            assert_eq!(s.solve(q, Order::Force, &mut workspace), Condition::Ok);
            assert_eq!(workspace.withheld(), None);
            // An equally small step of each coordinate.
            let (dq, dp) = (1e-5 * unit(driver.input), 1e-5 * unit(timed.input));
            let along = |by: f64, dq: f64| place(build, (ratio, phase), by, q + dq);
            let complete = -FORCE.dot(along(0.0, dq) - along(0.0, -dq)) / 2e-5;
            let own = -FORCE.dot(along(dp, 0.0) - along(-dp, 0.0)) / 2e-5;
            let rate = ratio * unit(driver.input) / unit(timed.input);
            let slack = 1e-5 * (complete.abs() + own.abs() + 10.0);
            let near = |seen: Option<f64>, expected: f64, what: &str| {
                let seen = seen.unwrap();
                assert!((seen - expected).abs() < slack, "{what}: {seen} {expected}");
            };
            near(workspace.drive(), complete, "all");
            near(workspace.effort(timed.input), own, "its own");
            near(
                workspace.effort(driver.input),
                complete - rate * own,
                "the driver's",
            );
        }
    }
}

/// With masses as well: moments and forces on the frame are in balance, or the forces would be
/// withheld.
#[test]
fn timed_input_machines_balance_frame_forces() {
    for (build, ratio, phase, _) in MACHINES {
        let (mut b, point) = build(line(ratio, phase));
        b.gravity(Vec2::new(0.0, -9.81));
        let links: Vec<LinkId> = b.clone().build().unwrap().link_ids().collect();
        for link in links {
            b.centre_of_mass(link, Vec2::new(0.2, 0.05));
            b.mass(link, 2.0, 0.03);
        }
        b.load(Load::Force {
            point,
            force: Vec2::new(1.0, 2.0),
            frame: GROUND,
            over: Profile::default(),
        });
        let (_, s) = solver(b);
        let (mut workspace, mut balls) = (s.state(), s.enclosure());
        for q in places(&s) {
            assert_eq!(s.solve(q, Order::Force, &mut workspace), Condition::Ok);
            s.enclose(&mut workspace, Order::Force, &mut balls);
            assert_eq!(workspace.withheld(), None, "at {q}");
            assert!(workspace.drive().is_some());
        }
    }
}

fn refused(m: &Mechanism) -> Fault {
    Solver::new(m).err().unwrap()
}

#[test]
fn number_of_inputs_must_match_mobility() {
    // A five-bar with both of its inputs has mobility 2.
    let (with, _) = five_bar(line(1.0, 30.0));
    assert_eq!(Plan::of(&with.build().unwrap()).unwrap().mobility, 2);
    // A four-bar whose rocker is driven as well.
    let mut b = Builder::default();
    let [a, d] = [(0.0, 0.0), (3.0, 0.0)].map(|(x, y)| b.ground_point(x, y));
    let [one, two] = [(); 2].map(|()| b.moving_point());
    let crank = b.link(a, one, 1.0);
    b.link(one, two, 2.5);
    let rocker = b.link(d, two, 2.0);
    b.driver(turn(crank, 50.0));
    follow(&mut b, Input::Turn(rocker), line(1.0, 30.0));
    let fault = refused(&b.build().unwrap());
    assert!(matches!(fault, Fault::OverConstrained { .. }), "{fault:?}");
    // A second law for the driver, or for the other input.
    let (b, _) = crank_and_block(line(0.004, 0.2));
    let driven: Vec<Input> = b.clone().build().unwrap().inputs().collect();
    assert_eq!(driven.len(), 2);
    for input in driven {
        let mut b = b.clone();
        follow(&mut b, input, line(1.0, 0.0));
        assert!(b.build().is_err(), "{input:?}");
    }
}
