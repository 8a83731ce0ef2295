//! Motions through exact change points, where the two assemblies of a group meet, and close to
//! them.

use crate::rig::note;
use krank::solver::{Condition, Order, Range, Solver, State};
use krank::{Body, Builder, Driver, Input, LinkId, PointId, Vec2};

struct FourBar {
    solver: Solver,
    joint: PointId,
    coupler: LinkId,
    follower: LinkId,
}

/// Opens a four-bar with A = (0, 0) and D = (d, 0), driven at 1 rad/s; the follower runs from D to
/// C.
fn four_bar([a, b, c, d]: [f64; 4], start: f64, near: Vec2) -> FourBar {
    let mut m = Builder::default();
    let (pivot, far) = (m.ground_point(0.0, 0.0), m.ground_point(d, 0.0));
    let (pin, joint) = (m.moving_point(), m.moving_point());
    let crank = m.link(pivot, pin, a);
    let (coupler, follower) = (m.link(pin, joint, b), m.link(far, joint, c));
    m.driver(Driver {
        input: Input::Turn(crank),
        start,
        speed: 1.0,
        acceleration: 0.0,
    });
    m.start(joint, near);
    let solver = Solver::new(&m.build().unwrap()).unwrap();
    FourBar {
        solver,
        joint,
        coupler,
        follower,
    }
}

impl FourBar {
    fn at(&self, angle: f64) -> State {
        let mut state = self.solver.state();
        let condition = self.solver.solve(angle, Order::Acceleration, &mut state);
        assert!(
            matches!(condition, Condition::Ok | Condition::ChangePoint),
            "{condition:?} at {angle}"
        );
        state.into_state()
    }

    fn place(&self, angle: f64) -> Vec2 {
        self.at(angle).position(self.joint).unwrap()
    }
}

fn close(seen: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (seen - expected).abs() < tolerance,
        "{what}: {seen:e} is not {expected:e}"
    );
}

/// A turn closes wherever it begins, also in the part of the motion that a passage through a change
/// point covers.
#[test]
fn turn_that_begins_beside_change_point_closes() {
    for offset in [1e-9, 1e-6, 1e-3, 0.01, 0.057, 0.06] {
        for start in [offset, -offset, 180.0 + offset, 180.0 - offset] {
            let pin = krank::angle::unit(start) + Vec2::new(3.0, 0.0);
            let m = four_bar([1.0, 3.0, 1.0, 3.0], start, pin);
            let motion = m.solver.motion();
            assert_eq!(motion.range, Range::Full { period: 360.0 }, "{start}");
            assert_eq!(motion.change_points.len(), 2, "{start}");
            let there = m.place(start + 400.0);
            let expected = krank::angle::unit(start + 400.0) + Vec2::new(3.0, 0.0);
            assert!((there - expected).norm() < 1e-12, "{start}: {there:?}");
        }
    }
}

#[test]
fn h01_parallelogram_keeps_shape_through_change_points() {
    let bar = four_bar([1.0, 3.0, 1.0, 3.0], 60.0, Vec2::new(3.5, 0.87));
    assert_eq!(bar.solver.motion().range, Range::Full { period: 360.0 });
    assert_eq!(bar.solver.motion().change_points, [0.0, 180.0]);
    for k in -720..=720 {
        let angle = 0.5 * f64::from(k);
        let state = bar.at(angle);
        let b = krank::angle::unit(angle);
        // The unavoidable rounding errors close to a change point, where the sine of the
        // transmission angle is that of the crank's angle: h = sqrt(sine^2 + u), hence u / sine in
        // positions, u / sine^2 in velocities and u / sine^3 in accelerations. The factors 3.6, 7
        // and 40 are those known for dyads; 3 is the ratio of the lengths.
        let u = 0.5 * f64::EPSILON;
        let sine = b.y.abs().max(0.008);
        let slack = 3.6 * 3.0 * u / sine + 2.0 * f64::EPSILON;
        let c = state.position(bar.joint).unwrap();
        close(c.x, b.x + 3.0, slack, "C.x");
        close(c.y, b.y, slack, "C.y");
        let first = 7.0 * 3.0 * u / (sine * sine);
        close(state.omega(bar.coupler).unwrap(), 0.0, first, "omega3");
        close(state.omega(bar.follower).unwrap(), 1.0, first, "omega4");
        let second = 40.0 * 9.0 * u / (sine * sine * sine);
        close(state.alpha(bar.coupler).unwrap(), 0.0, second, "alpha3");
        close(state.alpha(bar.follower).unwrap(), 0.0, second, "alpha4");
    }
}

#[test]
fn h01_values_at_change_points_are_limits() {
    let bar = four_bar([1.0, 3.0, 1.0, 3.0], 60.0, Vec2::new(3.5, 0.87));
    for (angle, x) in [(0.0, 4.0), (180.0, 2.0), (360.0, 4.0), (-180.0, 2.0)] {
        let state = bar.at(angle);
        assert_eq!(state.condition(), Condition::ChangePoint);
        assert_eq!(state.position(bar.joint).unwrap(), Vec2::new(x, 0.0));
        close(state.omega(bar.coupler).unwrap(), 0.0, 1e-15, "omega3");
        close(state.omega(bar.follower).unwrap(), 1.0, 1e-15, "omega4");
        close(state.alpha(bar.coupler).unwrap(), 0.0, 1e-15, "alpha3");
        close(state.alpha(bar.follower).unwrap(), 0.0, 1e-15, "alpha4");
    }
}

/// Close to its change point, a dyad loses digits with the inverse of the distance in positions,
/// its square in velocities and its cube in accelerations: at 1e-4 deg, accelerations used to have
/// no correct digit. The series used there does not depend on the distance.
#[test]
fn h01_parallelogram_keeps_digits_near_change_points() {
    let bar = four_bar([1.0, 3.0, 1.0, 3.0], 60.0, Vec2::new(3.5, 0.87));
    for decade in -15..1_i32 {
        let mut worst = [0.0_f64; 3];
        for (at, k) in [0.0, 180.0]
            .into_iter()
            .flat_map(|at| (0..400).map(move |k| (at, k)))
        {
            let away = 10.0_f64.powf(f64::from(decade) + f64::from(k) / 400.0);
            for angle in [at - away, at + away] {
                let state = bar.at(angle);
                let expected = krank::angle::unit(angle) + Vec2::new(3.0, 0.0);
                let off = |link, omega: f64| {
                    [
                        (state.omega(link).unwrap() - omega).abs(),
                        state.alpha(link).unwrap().abs(),
                    ]
                };
                let [coupler, follower] = [off(bar.coupler, 0.0), off(bar.follower, 1.0)];
                let now = [
                    (state.position(bar.joint).unwrap() - expected).norm(),
                    coupler[0].max(follower[0]),
                    coupler[1].max(follower[1]),
                ];
                worst = [0, 1, 2].map(|i| worst[i].max(now[i]));
            }
        }
        note(&format!("H01: 1e{decade} deg away, off by {worst:?}"));
        // Beyond 1 degree, in the last decade, the dyad itself applies: 3.6, 7 and 40 rounding
        // errors of lengths 3, divided by the powers of a sine of 0.017.
        let allowed = if decade < 0 {
            [4e-15, 1e-15, 1e-15]
        } else {
            [1e-13, 1e-11, 1e-8]
        };
        for (worst, allowed) in worst.iter().zip(allowed) {
            assert!(
                *worst <= allowed,
                "1e{decade} deg: {worst:e} of {allowed:e}"
            );
        }
    }
}

#[test]
fn h02_antiparallelogram_stays_crossed() {
    let bar = four_bar([1.0, 3.0, 1.0, 3.0], 90.0, Vec2::new(2.4, -0.8));
    assert_eq!(bar.solver.motion().range, Range::Full { period: 360.0 });
    let state = bar.at(90.0);
    close(state.position(bar.joint).unwrap().x, 2.4, 4e-15, "C.x");
    close(state.omega(bar.follower).unwrap(), -0.8, 1e-14, "omega4");
    for (angle, omega) in [(0.0, -2.0), (180.0, -0.5)] {
        let state = bar.at(angle);
        assert_eq!(state.condition(), Condition::ChangePoint);
        close(state.omega(bar.follower).unwrap(), omega, 1e-15, "omega4");
    }
    // theta4 = 2 atan(-2 tan(theta2 / 2)) over the whole turn.
    for k in 1..720 {
        let angle = 0.5 * f64::from(k);
        let half = (-2.0 * (angle.to_radians() / 2.0).tan()).atan();
        let expected = Vec2::new((2.0 * half).cos(), (2.0 * half).sin());
        let seen = bar.at(angle).direction(bar.follower).unwrap();
        assert!(
            (seen - expected).norm() < 1e-12,
            "at {angle}: {seen:?} {expected:?}"
        );
    }
}

/// The follower turns hundreds of times as fast as the crank where both lie along the frame; the
/// motion used to end there.
#[test]
fn nearly_square_antiparallelogram_turns_fully() {
    for frame in [1.9, 1.99, 1.995, 2.01, 2.1] {
        let angle = 60.0_f64.to_radians();
        // The mirror image of the parallelogram's corner in the line through B and D.
        let (b, d) = (
            Vec2::new(2.0 * angle.cos(), 2.0 * angle.sin()),
            Vec2::new(frame, 0.0),
        );
        let across = (d - b).perp();
        let away = across.dot(d) / across.norm2();
        let crossed = b + d - across * (2.0 * away);
        let linkage = four_bar([2.0, frame, 2.0, frame], 60.0, crossed);
        let motion = linkage.solver.motion();
        assert_eq!(motion.range, Range::Full { period: 360.0 }, "{frame}");
        assert_eq!(motion.change_points, [0.0, 180.0], "{frame}");
        for (angle, expected) in [
            (0.0, -(frame + 2.0) / (frame - 2.0)),
            (180.0, -(frame - 2.0) / (frame + 2.0)),
        ] {
            let omega = linkage.at(angle).omega(linkage.follower).unwrap();
            close(omega / expected, 1.0, 1e-9, "omega of the follower");
        }
        for k in -2000..2000 {
            linkage.at(f64::from(k) * 0.001);
        }
    }
}

#[test]
fn h03_kite_repeats_after_two_turns() {
    let root = 7.0_f64.sqrt();
    let far = Vec2::new((1.0 + root) / 2.0, (1.0 + root) / 2.0);
    let bar = four_bar([1.0, 2.0, 2.0, 1.0], 90.0, far);
    assert_eq!(bar.solver.motion().range, Range::Full { period: 720.0 });
    for k in 0..1440 {
        let angle = 0.5 * f64::from(k);
        let half = krank::angle::unit(angle / 2.0);
        let rho = half.x + (4.0 - half.y * half.y).sqrt();
        let expected = Vec2::new(rho * half.x, rho * half.y);
        let seen = bar.place(angle);
        assert!(
            (seen - expected).norm() < 1e-12,
            "at {angle}: {seen:?} {expected:?}"
        );
    }
    let at_start = bar.at(0.0);
    assert_eq!(at_start.condition(), Condition::ChangePoint);
    close(at_start.omega(bar.follower).unwrap(), 0.75, 1e-15, "omega4");
    close(
        at_start.velocity(bar.joint).unwrap().y,
        1.5,
        1e-15,
        "dC/dtheta",
    );
    close(
        bar.place(359.0).x,
        -0.999_980_961_078_998_8,
        1e-13,
        "C.x(359)",
    );
    close(
        bar.place(450.0).y,
        -0.822_875_655_532_295_3,
        1e-14,
        "C.y(450)",
    );
    assert_eq!(bar.place(90.0), bar.place(90.0 + 720.0));
}

#[test]
fn h13_equal_rod_and_crank_pass_change_points() {
    let mut m = Builder::default();
    let (pivot, pin, slider) = (m.ground_point(0.0, 0.0), m.moving_point(), m.moving_point());
    let crank = m.link(pivot, pin, 1.0);
    m.link(pin, slider, 1.0);
    m.pin_in_slot(slider, Body::Ground, Vec2::ZERO, 0.0);
    m.driver(Driver {
        input: Input::Turn(crank),
        start: 30.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    m.start(slider, Vec2::new(1.7, 0.0));
    let solver = Solver::new(&m.build().unwrap()).unwrap();
    assert_eq!(solver.motion().change_points, [90.0, 270.0]);
    let mut state = solver.state();
    for k in 0..1440 {
        let angle = 0.25 * f64::from(k);
        let _ = solver.solve(angle, Order::Acceleration, &mut state);
        let b = krank::angle::unit(angle);
        let slack = 1e-14 / b.x.abs().max(0.004);
        close(state.position(slider).unwrap().x, 2.0 * b.x, slack, "x");
        close(
            state.velocity(slider).unwrap().x,
            -2.0 * b.y,
            10.0 * slack / b.x.abs().max(0.004),
            "v",
        );
    }
    let _ = solver.solve(90.0, Order::Acceleration, &mut state);
    assert_eq!(state.condition(), Condition::ChangePoint);
    assert_eq!(state.position(slider).unwrap(), Vec2::ZERO);
    close(state.velocity(slider).unwrap().x, -2.0, 1e-15, "v");
    close(state.acceleration(slider).unwrap().x, 0.0, 1e-15, "a");
}

#[test]
fn h21_near_miss_keeps_assembly_sign() {
    let bar = four_bar([1.0, 3.0, 1.0 + 1e-9, 3.0], 60.0, Vec2::new(3.5, 0.87));
    assert_eq!(bar.solver.motion().range, Range::Full { period: 360.0 });
    assert!(bar.solver.motion().change_points.is_empty());
    // Beyond 0 deg the exact motion continues in the crossed shape.
    let c = bar.place(-10.0);
    close(c.x, 3.940_584_982_472_821, 1e-12, "C.x");
    close(c.y, 0.339_558_378_996_311_1, 1e-12, "C.y");
    let other = four_bar([1.0, 3.0, 1.0 + 1e-9, 3.0], 60.0, Vec2::new(2.86, -0.99));
    for (bar, at, x, y) in [
        (&bar, 60.0, 3.5, 0.866_025_404_939_139_3),
        (
            &other,
            60.0,
            2.857_142_856_428_571_4,
            -0.989_743_319_518_051_8,
        ),
        (
            &other,
            -10.0,
            3.984_807_753_012_208,
            -0.173_648_183_425_701_25,
        ),
    ] {
        let c = bar.place(at);
        close(c.x, x, 4e-15, "C.x");
        close(c.y, y, 4e-15, "C.y");
    }
}

/// Without the near miss, a reader would consider the crossed shape beyond 0 degrees an error.
#[test]
fn h21_near_miss_is_reported() {
    let bar = four_bar([1.0, 3.0, 1.0 + 1e-9, 3.0], 60.0, Vec2::new(3.5, 0.87));
    let [first, second] = bar.solver.motion().near_misses[..] else {
        panic!("{:?}", bar.solver.motion().near_misses);
    };
    // The relative error of the sine equals that of the gap of 1e-9, which comes from the rounding
    // of c: 1e-16 relative to c.
    assert_eq!((first.group.index(), first.at), (1, 0.0));
    close(first.sine, 0.000_036_514_838_648_729_05, 1e-11, "|sin mu|");
    assert_eq!((second.group.index(), second.at), (1, 180.0));
    let [mu] = bar.solver.transmission()[..] else {
        panic!()
    };
    assert_eq!(mu.smallest.at, 0.0);
    // The state itself is computed in double-double.
    let sine = mu.smallest.angle.to_radians().sin();
    close(sine, 0.000_036_514_838_648_729_05, 1e-18, "mu");
    // The lecture's four-bar has no near miss: its smallest angle is 65 degrees.
    let bar = four_bar([100.0, 300.0, 250.0, 400.0], 60.0, Vec2::new(310.0, 230.0));
    assert!(bar.solver.motion().near_misses.is_empty());
}

#[test]
fn rotated_distant_parallelogram_is_recognised() {
    let turn = krank::angle::unit(23.456);
    let mut m = Builder::default();
    let (a, d) = (Vec2::new(12.3, -7.1), Vec2::new(12.3, -7.1) + turn * 3.7);
    let (pivot, far) = (m.ground_point(a.x, a.y), m.ground_point(d.x, d.y));
    let (pin, joint) = (m.moving_point(), m.moving_point());
    let crank = m.link(pivot, pin, 1.3);
    m.link(pin, joint, 3.7);
    let follower = m.link(far, joint, 1.3);
    m.driver(Driver {
        input: Input::Turn(crank),
        start: 90.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    m.start(joint, d + Vec2::new(0.0, 1.3));
    let solver = Solver::new(&m.build().unwrap()).unwrap();
    let motion = solver.motion();
    assert_eq!(motion.range, Range::Full { period: 360.0 });
    assert_eq!(motion.change_points.len(), 2, "{:?}", motion.change_points);
    close(motion.change_points[0], 23.456, 1e-7, "first change point");
    let mut state = solver.state();
    for k in 0..360 {
        let _ = solver.solve(f64::from(k), Order::Acceleration, &mut state);
        close(state.omega(follower).unwrap(), 1.0, 1e-9, "omega4");
    }
}

#[test]
fn second_loop_is_smooth_through_change_points() {
    let mut m = Builder::default();
    let (a, d, g) = (
        m.ground_point(0.0, 0.0),
        m.ground_point(3.0, 0.0),
        m.ground_point(7.0, 0.5),
    );
    let [b, c, e] = [(); 3].map(|()| m.moving_point());
    let crank = m.link(a, b, 1.0);
    m.link(b, c, 3.0);
    m.link(d, c, 1.0);
    m.link(c, e, 3.5);
    let last = m.link(g, e, 2.5);
    m.driver(Driver {
        input: Input::Turn(crank),
        start: 60.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    m.start(c, Vec2::new(3.5, 0.87));
    m.start(e, Vec2::new(6.5, 3.0));
    let solver = Solver::new(&m.build().unwrap()).unwrap();
    assert_eq!(solver.motion().range, Range::Full { period: 360.0 });
    let mut omega = |angle: f64| {
        let mut state = solver.state();
        let _ = solver.solve(angle, Order::Acceleration, &mut state);
        (state.omega(last).unwrap(), state.alpha(last).unwrap())
    };
    // Smooth across the change points: the value there is the mean of its neighbours.
    for at in [0.0, 180.0] {
        let [(w0, a0), (w, a), (w1, a1)] = [at - 0.01, at, at + 0.01].map(&mut omega);
        close(w, 0.5 * (w0 + w1), 1e-6, "omega");
        close(a, 0.5 * (a0 + a1), 1e-5, "alpha");
    }
}

/// The series at a change point is fitted to the motion around it. A limit close by used to
/// suppress the change point, and states beyond it were on the opposite side.
#[test]
fn change_point_near_limit_keeps_assembly() {
    let mut m = Builder::default();
    let (a, d) = (m.ground_point(0.0, 0.0), m.ground_point(3.0, 0.0));
    let g = m.ground_point(4.0, 10.0);
    let [b, c, e] = [(); 3].map(|()| m.moving_point());
    let crank = m.link(a, b, 1.0);
    m.link(b, c, 3.0);
    let follower = m.link(d, c, 1.0);
    // Stretched where C is 5 degrees beyond the line of the pivots.
    m.link(c, e, 5.0);
    m.link(g, e, 5.0872);
    m.driver(Driver {
        input: Input::Turn(crank),
        start: 60.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    m.start(c, Vec2::new(3.5, 0.87));
    m.start(e, Vec2::new(5.0, 5.0));
    let solver = Solver::new(&m.build().unwrap()).unwrap();
    let Range::Limited { low, high } = solver.motion().range else {
        panic!()
    };
    assert!((-6.0..-4.0).contains(&low) && (150.0..180.0).contains(&high));
    let mut state = solver.state();
    for angle in [-4.0, -2.0, -0.5, 0.0, 0.5, 90.0, 150.0] {
        let condition = solver.solve(angle, Order::Acceleration, &mut state);
        assert_ne!(condition, Condition::NoAssembly, "at {angle}");
        let expected = krank::angle::unit(angle) + Vec2::new(3.0, 0.0);
        assert!(
            (state.position(c).unwrap() - expected).norm() < 1e-12,
            "at {angle}"
        );
        close(state.omega(follower).unwrap(), 1.0, 1e-9, "omega4");
    }
}

/// Two parallelograms in a row whose change points are 8 degrees apart. Each series must be fitted
/// to the motion on its own side of the other change point.
#[test]
fn neighbouring_change_points_are_distinguished() {
    let (turn, offset) = (krank::angle::unit(8.0), Vec2::new(3.0, 0.0));
    let mut m = Builder::default();
    let (a, d) = (m.ground_point(0.0, 0.0), m.ground_point(3.0, 0.0));
    let far = offset + turn * 2.0;
    let h = m.ground_point(far.x, far.y);
    let [b, c, k] = [(); 3].map(|()| m.moving_point());
    let crank = m.link(a, b, 1.0);
    m.link(b, c, 3.0);
    m.link(d, c, 1.0);
    m.link(c, k, 2.0);
    let last = m.link(h, k, 1.0);
    m.driver(Driver {
        input: Input::Turn(crank),
        start: 60.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    let at_start = krank::angle::unit(60.0);
    m.start(c, offset + at_start);
    m.start(k, far + at_start);
    let solver = Solver::new(&m.build().unwrap()).unwrap();
    let motion = solver.motion();
    assert_eq!(motion.range, Range::Full { period: 360.0 });
    assert_eq!(motion.change_points.len(), 4, "{:?}", motion.change_points);
    let mut state = solver.state();
    for angle in (0..720).map(|k| 0.5 * f64::from(k)) {
        let _ = solver.solve(angle, Order::Acceleration, &mut state);
        let expected = krank::angle::unit(angle) + far;
        assert!(
            (state.position(k).unwrap() - expected).norm() < 1e-11,
            "at {angle}"
        );
        close(state.omega(last).unwrap(), 1.0, 1e-7, "omega");
    }
}

/// Peaucellier's cell with OQ = QB = 5, arms 10 and a rhombus of 4. Its rhombus collapses at OB =
/// sqrt(84), where D may stay on B. A continuation of 60 digits took that branch.
#[test]
fn h20_peaucellier_cell_crosses_inversion_circle() {
    let mut m = Builder::default();
    let (o, q) = (m.ground_point(0.0, 0.0), m.ground_point(5.0, 0.0));
    let [b, e, f, d] = [(); 4].map(|()| m.moving_point());
    let crank = m.link(q, b, 5.0);
    for (from, to, length) in [
        (o, e, 10.0),
        (o, f, 10.0),
        (b, e, 4.0),
        (b, f, 4.0),
        (e, d, 4.0),
        (f, d, 4.0),
    ] {
        m.link(from, to, length);
    }
    m.driver(Driver {
        input: Input::Turn(crank),
        start: 60.0,
        speed: 1.0,
        acceleration: 0.0,
    });
    // At 60 degrees B is 8.66 from O on the line at 30 degrees, and D is 9.70 from O.
    let (along, across) = (krank::angle::unit(30.0), krank::angle::unit(30.0).perp());
    m.start(e, along * 9.18 + across * 3.96);
    m.start(f, along * 9.18 - across * 3.96);
    m.start(d, along * 9.7);
    let solver = Solver::new(&m.build().unwrap()).unwrap();
    let motion = solver.motion();
    let phi0 = 47.156_356_956_403_66;
    let [below, above] = motion.change_points[..] else {
        panic!("{:?}", motion.change_points);
    };
    close(below, -phi0, 1e-14, "phi0");
    close(above, phi0, 1e-14, "phi0");
    // The rhombus folds at OB = 10 - 4.
    let Range::Limited { low, high } = motion.range else {
        panic!("{:?}", motion.range)
    };
    let fold = 2.0 * 0.6_f64.acos().to_degrees();
    close(low, -fold, 3e-14, "lower limit");
    close(high, fold, 3e-14, "upper limit");
    let mut state = solver.state();
    for k in -1060..=1060 {
        let at = 0.1 * f64::from(k);
        assert_eq!(
            solver.solve(at, Order::Acceleration, &mut state),
            Condition::Ok
        );
        let slack =
            1e-13 / (at.abs() - phi0).to_radians().abs().max(0.02) / (fold - at.abs()).min(1.0);
        close(state.position(d).unwrap().x, 8.4, slack, "D.x");
    }
    let _ = solver.solve(90.0, Order::Acceleration, &mut state);
    assert!((state.position(d).unwrap() - Vec2::new(8.4, 8.4)).norm() < 4e-15);
    let _ = solver.solve(above, Order::Acceleration, &mut state);
    assert_eq!(state.condition(), Condition::ChangePoint);
    // D = 8.4 (1, tan(phi / 2)): D.y' = 8.4 (1 + tan^2) / 2, D.y'' = D.y' tan.
    let tan = (above.to_radians() / 2.0).tan();
    let rate = 4.2 * (1.0 + tan * tan);
    close(state.position(d).unwrap().x, 8.4, 4e-15, "D.x");
    close(state.velocity(d).unwrap().x, 0.0, 1e-14, "D.x'");
    close(state.velocity(d).unwrap().y, rate, 1e-14, "D.y'");
    close(state.acceleration(d).unwrap().x, 0.0, 1e-13, "D.x''");
    close(state.acceleration(d).unwrap().y, rate * tan, 1e-13, "D.y''");
}

/// A coupled group that contains a parallelogram: the driver moves the platform of the
/// parallelogram ABCD, whose point E follows a circle of the cranks' radius. G, F, E and that
/// circle's centre form a drag link.
struct Inside {
    solver: Solver,
    platform: LinkId,
    crank: LinkId,
    e: PointId,
    centre: Vec2,
}

/// Lengths of the drag link: driver, rod, frame; the parallelogram's cranks have length 1.
const DRAG: [f64; 3] = [1.2, 1.1, 0.5];

/// Opens the group with one of the cranks longer by `longer`.
fn inside(turn: f64, shift: Vec2, start: f64, longer: f64) -> Inside {
    let mut m = Builder::default();
    let put = |x: f64, y: f64| Vec2::new(x, y).turned(krank::angle::unit(turn)) + shift;
    let [driver, rod, frame] = DRAG;
    let (a_at, d_at, g_at) = (put(0.0, 0.0), put(3.0, 0.0), put(1.5 + frame, 0.0));
    let [a, d, g] = [a_at, d_at, g_at].map(|p| m.ground_point(p.x, p.y));
    let [b, c, e, f] = [(); 4].map(|()| m.moving_point());
    let driven = m.link(g, f, driver);
    m.link(f, e, rod);
    let platform = m.link(b, c, 3.0);
    m.carry(platform, e, Vec2::new(1.5, 0.0));
    let crank = m.link(a, b, 1.0);
    m.link(d, c, 1.0 + longer);
    let to_e = drag(start).0;
    m.driver(Driver {
        input: Input::Turn(driven),
        start: start + turn,
        speed: 1.0,
        acceleration: 0.0,
    });
    m.start(b, put(to_e.x, to_e.y));
    m.start(c, put(3.0 + to_e.x, to_e.y));
    m.start(e, put(1.5 + to_e.x, to_e.y));
    let solver = Solver::new(&m.build().unwrap()).unwrap();
    Inside {
        solver,
        platform,
        crank,
        e,
        centre: put(1.5, 0.0),
    }
}

/// Computes the drag link on a frame along x: the direction of the follower, with its rate.
fn drag(angle: f64) -> (Vec2, f64) {
    let [driver, rod, frame] = DRAG;
    let unit = krank::angle::unit(angle);
    let pin = unit * driver + Vec2::new(frame, 0.0);
    let d2 = pin.norm2();
    let along = 0.5 * (d2 + 1.0 - rod * rod);
    let across = (d2 - along * along).sqrt();
    let to = (pin * along - pin.perp() * across) / d2;
    // f.(w k x to) = f.v of the pin, with f the rod.
    let f = pin - to;
    (to, f.dot(unit.perp() * driver) / f.dot(to.perp()))
}

/// Lengths count as equal only if they are equal as given. If a crank is longer by less than
/// doubles can resolve, the solutions of the group still miss each other, and no change point is
/// passed.
#[test]
fn nearly_equal_cranks_in_coupled_group_have_no_change_point() {
    for longer in [5e-14, 3e-14] {
        let of = inside(0.0, Vec2::ZERO, 60.0, longer);
        let motion = of.solver.motion();
        assert_eq!(motion.change_points, [0.0; 0], "{longer:e}");
    }
}

#[test]
fn parallelogram_in_coupled_group_keeps_shape() {
    for (turn, shift, start) in [
        (0.0, Vec2::ZERO, 60.0),
        (23.456, Vec2::new(12.3, -7.1), 100.0),
        (0.0, Vec2::new(1e5, -3e5), 250.0),
    ] {
        let of = inside(turn, shift, start, 0.0);
        let motion = of.solver.motion();
        assert_eq!(motion.range, Range::Full { period: 360.0 });
        let [first, second] = motion.change_points[..] else {
            panic!("{:?}", motion.change_points);
        };
        let size = 1.0 + shift.norm() * 0.1;
        for at in [first, second] {
            let follower = drag(at - turn).0;
            close(
                follower.y,
                0.0,
                1e-14 * size,
                "the cranks lie along the frame",
            );
            let mut state = of.solver.state();
            let condition = of.solver.solve(at, Order::Acceleration, &mut state);
            assert_eq!(condition, Condition::ChangePoint);
            close(
                state.omega(of.platform).unwrap(),
                0.0,
                1e-12 * size,
                "omega",
            );
            close(
                state.alpha(of.platform).unwrap(),
                0.0,
                1e-11 * size,
                "alpha",
            );
        }
        let mut state = of.solver.state();
        for k in 0..1440 {
            let at = 0.25 * f64::from(k) + 0.01;
            let condition = of.solver.solve(at, Order::Acceleration, &mut state);
            assert_eq!(condition, Condition::Ok, "at {at}");
            let (to, rate) = drag(at - turn);
            let slack = 1e-13 * size / to.y.abs().max(0.02);
            let position = to.turned(krank::angle::unit(turn)) + of.centre;
            assert!(
                (state.position(of.e).unwrap() - position).norm() < 10.0 * slack,
                "E at {at}"
            );
            close(
                state.omega(of.platform).unwrap(),
                0.0,
                100.0 * slack,
                "omega",
            );
            close(
                state.omega(of.crank).unwrap(),
                rate,
                100.0 * slack,
                "omega of the crank",
            );
        }
    }
}
