//! Inputs that follow the driver by a table.
//!
//! The tests compute the curve through the knots independently, from the slopes at the knots with
//! Hermite's cubics and a full matrix. They compare positions with closed forms, forces with the
//! virtual work of position differences, and bounds with double-double values.

use super::inputs::{Build, MACHINES, five_bar, growing_crank};
use super::states::{at, solver};
use krank::solver::{Condition, Fault, Order, Range, Solver, State};
use krank::{
    Body, Input, InputLaw, InputTable, LANES, LinkId, Load, Profile, TimedInput, Vec2, angle,
};
use std::f64::consts::PI;

/// A cubic spline given by its slopes: 1/h0 m0 + 2 (1/h0 + 1/h1) m1 + 1/h1 m2 = 3 (d0/h0 + d1/h1).
struct Curve {
    knots: Vec<[f64; 2]>,
    slopes: Vec<f64>,
}

impl Curve {
    fn new(knots: &[[f64; 2]], closes: bool) -> Curve {
        let n = knots.len();
        let h = |k: usize| knots[k + 1][0] - knots[k][0];
        let d = |k: usize| (knots[k + 1][1] - knots[k][1]) / h(k);
        let mut rows = vec![vec![0.0; n + 1]; n];
        for (k, row) in rows.iter_mut().enumerate() {
            let (before, after) = match (k, closes) {
                (0, false) => (None, None),
                (k, false) if k == n - 1 => (None, None),
                (0, true) => (Some((n - 2, n - 2)), Some((0, 1))),
                (k, true) if k == n - 1 => (None, None),
                (k, _) => (Some((k - 1, k - 1)), Some((k, k + 1))),
            };
            let (Some((cell0, left)), Some((cell1, right))) = (before, after) else {
                row[k] = 1.0;
                if closes {
                    row[0] -= 1.0;
                }
                continue;
            };
            row[left] += 1.0 / h(cell0);
            row[k] += 2.0 / h(cell0) + 2.0 / h(cell1);
            row[right] += 1.0 / h(cell1);
            row[n] = 3.0 * (d(cell0) / h(cell0) + d(cell1) / h(cell1));
        }
        Curve {
            knots: knots.to_vec(),
            slopes: solved(rows),
        }
    }

    /// Returns the value at a coordinate of the table, and its first two derivatives.
    fn at(&self, q: f64) -> [f64; 3] {
        let k = self.knots.iter().rposition(|knot| knot[0] <= q).unwrap();
        let k = k.min(self.knots.len() - 2);
        let [[x0, y0], [x1, y1]] = [self.knots[k], self.knots[k + 1]];
        let [m0, m1] = [self.slopes[k], self.slopes[k + 1]];
        let h = x1 - x0;
        let t = (q - x0) / h;
        [
            (2.0 * t.powi(3) - 3.0 * t * t + 1.0) * y0
                + (t.powi(3) - 2.0 * t * t + t) * h * m0
                + (3.0 * t * t - 2.0 * t.powi(3)) * y1
                + (t.powi(3) - t * t) * h * m1,
            6.0 * (t * t - t) * (y0 - y1) / h
                + (3.0 * t * t - 4.0 * t + 1.0) * m0
                + (3.0 * t * t - 2.0 * t) * m1,
            (12.0 * t - 6.0) * (y0 - y1) / (h * h)
                + ((6.0 * t - 4.0) * m0 + (6.0 * t - 2.0) * m1) / h,
        ]
    }
}

/// Solves by Gaussian elimination, with the largest pivot of each column.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()));
        rows.swap(k, pivot.unwrap());
        for i in (0..n).filter(|&i| i != k) {
            let part = rows[i][k] / rows[k][k];
            let above = rows[k].clone();
            for (value, above) in rows[i].iter_mut().zip(above) {
                *value -= part * above;
            }
        }
    }
    (0..n).map(|k| rows[k][n] / rows[k][k]).collect()
}

/// Pseudo-random numbers from 0 to 1.
struct SplitMix(u64);

impl SplitMix {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Returns knots around a line, over a part of its motion, rounded to five decimals in the driver's
/// coordinate.
fn about_line(build: Build, [ratio, phase]: [f64; 2], rng: &mut SplitMix) -> Vec<[f64; 2]> {
    let (m, line) = solver(build(InputLaw::Ratio { ratio, phase }).0);
    let start = m.driver().start;
    let (low, high) = match line.motion().range {
        Range::Full { .. } => (start - 70.0, start + 90.0),
        Range::Limited { low, high } => (
            start - (start - low).min(70.0) * 0.6,
            start + (high - start).min(90.0) * 0.6,
        ),
    };
    let count = 4 + (rng.next() * 5.0) as usize;
    let round = |x: f64| (x * 1e5).round() / 1e5;
    let step = (high - low) / (count - 1) as f64;
    (0..count)
        .map(|k| {
            let q = round(
                low + step
                    * (k as f64
                        + if k == 0 || k == count - 1 {
                            0.0
                        } else {
                            0.4 * rng.next() - 0.2
                        }),
            );
            [
                q,
                round(ratio * q + phase + 0.02 * ratio * (high - low) * (rng.next() - 0.5)),
            ]
        })
        .collect()
}

/// Returns every machine with a table around its line.
fn machines() -> Vec<(Build, Vec<[f64; 2]>)> {
    let mut rng = SplitMix(7);
    let with = |(build, ratio, phase, _): (Build, f64, f64, _)| {
        (build, about_line(build, [ratio, phase], &mut rng))
    };
    MACHINES.into_iter().map(with).collect()
}

fn open(knots: &[[f64; 2]]) -> InputLaw {
    InputLaw::Table(InputTable::open(knots.to_vec()).unwrap())
}

fn closed(knots: &[[f64; 2]]) -> InputLaw {
    InputLaw::Table(InputTable::closed(knots.to_vec()).unwrap())
}

/// Returns coordinates in a table, including knots and ends.
fn places(knots: &[[f64; 2]]) -> Vec<f64> {
    let mut coordinates: Vec<f64> = knots.iter().map(|knot| knot[0]).collect();
    let [low, high] = [coordinates[0], coordinates[coordinates.len() - 1]];
    coordinates.extend((0..20).map(|k| low + (high - low) * (f64::from(k) + 0.31) / 20.0));
    coordinates
}

/// Returns the size of a radian, or of a length, in the unit of a coordinate.
fn unit(input: Input) -> f64 {
    match input {
        Input::Turn(_) => 180.0 / PI,
        _ => 1.0,
    }
}

/// Returns the coordinate of the further input in its unit, and its first and second time
/// derivatives in radians or lengths.
fn motion(state: &State, input: Input, near: f64) -> [f64; 3] {
    match input {
        Input::Turn(link) => {
            let off = state.direction(link).unwrap().cross(angle::unit(near));
            [
                near - off.to_degrees(),
                state.omega(link).unwrap(),
                state.alpha(link).unwrap(),
            ]
        }
        Input::Push(slide) => {
            let travel = state.travel(slide).unwrap();
            [travel.position, travel.rate.unwrap(), travel.accel.unwrap()]
        }
    }
}

/// dp/dt = p' q', d2p/dt2 = p' q'' + p'' q'^2.
#[test]
fn input_follows_its_table_with_exact_derivatives() {
    for (build, knots) in machines() {
        let curve = Curve::new(&knots, false);
        let (m, s) = solver(build(open(&knots)).0);
        let (driver, input) = (*m.driver(), m.timed()[0].input);
        let (own, per) = (unit(input), unit(driver.input));
        for q in places(&knots) {
            let [p, first, second] = curve.at(q);
            let (first, second) = (first * per / own, second * per * per / own);
            let expected = [
                p,
                first * driver.speed,
                first * driver.acceleration + second * driver.speed * driver.speed,
            ];
            let size = [
                1.0,
                driver.speed.abs(),
                driver.speed * driver.speed + driver.acceleration.abs(),
            ];
            let steep = 1.0 + first.abs() + second.abs();
            let state = at(&s, q);
            for ((seen, expected), size) in
                motion(&state, input, p).into_iter().zip(expected).zip(size)
            {
                let slack = 1e-12 * (expected.abs() + size * steep);
                assert!(
                    (seen - expected).abs() < slack,
                    "{seen} {expected} at {q}: {knots:?}"
                );
            }
            let output = m.timed()[0].rates(q, driver.input);
            for (output, expected) in output.into_iter().zip([first, second]) {
                assert!(
                    (output - expected).abs() < 1e-11 * steep,
                    "{output} {expected} at {q}"
                );
            }
        }
    }
}

/// A rod extending from a crank: its tip is at (0.2, 0.1) + p (cos 15, sin 15) in the frame of the
/// turning crank.
#[test]
fn polar_arm_matches_closed_form() {
    let knots = [[20.0, 0.4], [47.3, 0.61], [95.0, 0.32], [130.0, 0.37]];
    let curve = Curve::new(&knots, false);
    let (builder, _) = growing_crank(open(&knots));
    let (m, s) = solver(builder);
    let tip = m.point_ids().nth(3).unwrap();
    let (w, alpha) = (m.driver().speed, m.driver().acceleration);
    for q in places(&knots) {
        let [p, first, second] = curve.at(q);
        let (first, second) = (first * 180.0 / PI, second * (180.0 / PI).powi(2));
        let (dp, ddp) = (first * w, first * alpha + second * w * w);
        let turned = |degrees: f64| {
            let (y, x) = degrees.to_radians().sin_cos();
            Vec2::new(x, y)
        };
        let along = turned(q + 15.0);
        let r = turned(q) * 0.2 + turned(q).perp() * 0.1 + along * p;
        let expected = [
            r,
            r.perp() * w + along * dp,
            r.perp() * alpha - r * (w * w) + along.perp() * (2.0 * w * dp) + along * ddp,
        ];
        let state = at(&s, q);
        let seen = [
            state.position(tip),
            state.velocity(tip),
            state.acceleration(tip),
        ];
        for (seen, expected) in seen.into_iter().zip(expected) {
            let off = (seen.unwrap() - expected).norm();
            assert!(off < 1e-12 * (1.0 + expected.norm()), "{off:e} at {q}");
        }
    }
}

/// The law of cosines of `inputs`, with the second crank driven by a closed table over two turns.
#[test]
fn five_bar_with_closed_table_repeats_smoothly() {
    let knots = [
        [-30.5, 110.25],
        [120.0, 60.0],
        [300.0, -10.0],
        [410.7, -130.0],
        [689.5, -249.75],
    ];
    let curve = Curve::new(&knots, true);
    let (builder, c) = five_bar(closed(&knots));
    let (_, s) = solver(builder);
    assert_eq!(s.motion().range, Range::Full { period: 720.0 });
    assert!(s.motion().stops.is_empty());
    let place = |q: f64| {
        let turned = |degrees: f64| degrees.to_radians().sin_cos();
        let within = (q + 30.5).rem_euclid(720.0) - 30.5;
        let (one, two) = (turned(q), turned(curve.at(within)[0]));
        let (dx, dy) = (3.0 + 0.8 * two.1 - one.1, 0.8 * two.0 - one.0);
        let d = (dx * dx + dy * dy).sqrt();
        let x = (d * d + 2.6 * 2.6 - 2.4 * 2.4) / (2.0 * d);
        let y = (2.6 * 2.6 - x * x).sqrt();
        Vec2::new(one.1 + (x * dx - y * dy) / d, one.0 + (x * dy + y * dx) / d)
    };
    for q in places(&knots)
        .into_iter()
        .flat_map(|q| [q, q + 720.0, q - 1440.0])
    {
        let state = at(&s, q);
        let off = (state.position(c).unwrap() - place(q)).norm();
        assert!(off < 1e-12, "{off:e} at {q}");
        // From both sides: the curve is smooth where the table repeats.
        let h = 1e-3;
        let [before, here, after] = [-h, 0.0, h].map(|by| place(q + by));
        let (w, alpha) = (3.0, 7.0);
        let v = (after - before) * (w / (2.0 * h.to_radians()));
        let bend = (after + before - here * 2.0) / (h.to_radians() * h.to_radians());
        let a = bend * (w * w) + v * (alpha / w);
        let slack = 3e-4 * (1.0 + a.norm());
        assert!((state.velocity(c).unwrap() - v).norm() < slack, "at {q}");
        assert!(
            (state.acceleration(c).unwrap() - a).norm() < slack,
            "at {q}: {a:?}"
        );
    }
}

#[test]
fn motion_ends_where_open_table_ends() {
    let knots = [[20.0, 100.0], [60.0, 80.0], [150.5, 110.0]];
    let (m, s) = solver(five_bar(open(&knots)).0);
    assert_eq!(
        s.motion().range,
        Range::Limited {
            low: 20.0,
            high: 150.5
        }
    );
    assert_eq!(s.motion().stops.len(), 2);
    for q in [20.0, 150.5] {
        let state = at(&s, q);
        let Input::Turn(other) = m.timed()[0].input else {
            panic!()
        };
        assert!(state.omega(other).unwrap().abs() < 1e-14);
        assert!(state.alpha(other).unwrap().abs() > 0.1);
    }
    let mut workspace = s.state();
    for q in [19.999, 150.501] {
        assert_eq!(
            s.solve(q, Order::Position, &mut workspace),
            Condition::NoAssembly
        );
    }
    // The scene opens at 50, and a table is not periodic: one turn away is outside.
    for knots in [
        [[60.0, 100.0], [150.0, 80.0]],
        [[380.0, 100.0], [500.0, 80.0]],
    ] {
        let m = five_bar(open(&knots)).0.build().unwrap();
        let fault = Solver::new(&m).err().unwrap();
        assert!(
            matches!(fault, Fault::BeyondStop { value: 50.0, .. }),
            "{fault:?}"
        );
    }
    // A closed table whose end values differ is rejected.
    let distance = [[0.0, 100.0], [360.0, 80.0]];
    assert!(five_bar(closed(&distance)).0.build().is_err());
}

#[test]
fn bounds_contain_double_double_values_of_tables() {
    for (build, knots) in machines() {
        let (m, s) = solver(build(open(&knots)).0);
        let (mut workspace, mut balls, mut truth) = (s.state(), s.enclosure(), s.twice());
        for q in places(&knots) {
            assert_eq!(
                s.solve(q, Order::Acceleration, &mut workspace),
                Condition::Ok
            );
            s.enclose(&mut workspace, Order::Acceleration, &mut balls);
            assert!(s.solve_twice(&workspace, Order::Acceleration, &mut truth));
            for p in m.point_ids() {
                let figures = [
                    (
                        balls.position(p).unwrap().x,
                        truth.position(p).unwrap().x,
                        workspace.position(p).unwrap().x,
                    ),
                    (
                        balls.velocity(p).unwrap().y,
                        truth.velocity(p).unwrap().y,
                        workspace.velocity(p).unwrap().y,
                    ),
                    (
                        balls.acceleration(p).unwrap().x,
                        truth.acceleration(p).unwrap().x,
                        workspace.acceleration(p).unwrap().x,
                    ),
                ];
                for (ball, truth, seen) in figures {
                    let miss = ((truth.hi - ball.mid) + truth.lo).abs();
                    assert!(miss <= ball.radius, "{miss:e} {ball:?} at {q}");
                    assert!(ball.radius < 1e-9 * (1.0 + ball.mid.abs()), "{ball:?}");
                    let off = ((truth.hi - seen) + truth.lo).abs();
                    assert!(off <= ball.bound(seen).unwrap(), "{off:e} {ball:?} {seen}");
                }
            }
        }
    }
}

/// As in `inputs`: an input's effort is -F . dx/dp, by differences with its table shifted as a
/// whole. The driver's own effort is the rest, with p' of the table.
#[test]
fn table_input_efforts_match_virtual_work() {
    const FORCE: Vec2 = Vec2::new(30.0, -170.0);
    for (build, knots) in machines() {
        let curve = Curve::new(&knots, false);
        let (mut builder, point) = build(open(&knots));
        builder.load(Load::Force {
            point,
            force: FORCE,
            frame: Body::Ground,
            over: Profile::default(),
        });
        let (m, s) = solver(builder);
        let (driver, input) = (m.driver().input, m.timed()[0].input);
        let place = |by: f64, q: f64| {
            let lifted: Vec<[f64; 2]> = knots.iter().map(|&[at, value]| [at, value + by]).collect();
            at(&solver(build(open(&lifted)).0).1, q)
                .position(point)
                .unwrap()
        };
        let mut workspace = s.state();
        let [low, high] = [knots[0][0], knots[knots.len() - 1][0]];
        for k in [0.31, 0.52, 0.77] {
            let q = low + (high - low) * k;
            assert_eq!(s.solve(q, Order::Force, &mut workspace), Condition::Ok);
            assert_eq!(workspace.withheld(), None);
            let (dq, dp) = (1e-5 * unit(driver), 1e-5 * unit(input));
            let complete = -FORCE.dot(place(0.0, q + dq) - place(0.0, q - dq)) / 2e-5;
            let own = -FORCE.dot(place(dp, q) - place(-dp, q)) / 2e-5;
            let rate = curve.at(q)[1] * unit(driver) / unit(input);
            let slack = 1e-5 * (complete.abs() + own.abs() + 10.0);
            for (seen, expected) in [
                (workspace.drive(), complete),
                (workspace.effort(input), own),
                (workspace.effort(driver), complete - rate * own),
            ] {
                let seen = seen.unwrap();
                assert!((seen - expected).abs() < slack, "{seen} {expected} at {q}");
            }
        }
    }
}

/// With masses: forces would be withheld if moments and forces on the frame were not in balance.
/// Their bounds hold.
#[test]
fn table_driven_machines_balance_frame_forces() {
    for (build, knots) in machines() {
        let mut b = build(open(&knots)).0;
        b.gravity(Vec2::new(0.0, -9.81));
        let links: Vec<LinkId> = b.clone().build().unwrap().link_ids().collect();
        for link in links {
            b.centre_of_mass(link, Vec2::new(0.2, 0.05));
            b.mass(link, 2.0, 0.03);
        }
        let (_, s) = solver(b);
        let mut workspace = s.state();
        for q in places(&knots) {
            assert_eq!(s.solve(q, Order::Force, &mut workspace), Condition::Ok);
            assert_eq!(workspace.withheld(), None, "at {q}");
            assert!(workspace.drive().is_some());
        }
    }
}

/// Lanes would be in different parts of a table, so that states are solved one by one.
#[test]
fn lanes_reject_tables() {
    let knots = [[20.0, 100.0], [60.0, 80.0], [150.5, 110.0]];
    let (_, s) = solver(five_bar(open(&knots)).0);
    let mut lanes = s.lanes();
    assert!(!s.solve_lanes([50.0; LANES], Order::Position, &mut lanes));
}

/// Tables are equal if their knots are equal.
#[test]
fn tables_are_compared_by_their_knots() {
    let (m, _) = solver(five_bar(open(&[[0.0, 110.0], [90.0, 80.0]])).0);
    let input = m.timed()[0].input;
    let input = |value: f64| TimedInput {
        input,
        law: open(&[[0.0, 1.0], [1.0, value]]),
    };
    assert_eq!(input(2.0), input(2.0));
    assert_ne!(input(2.0), input(2.5));
}
