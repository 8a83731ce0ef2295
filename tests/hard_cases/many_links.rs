//! Many links: redundant constraints, parallel slides, a long chain.

use crate::exact::{DoubleDouble, PI};
use crate::rig::{U, assert_near, exact, note, push, solved, turn};
use krank::quantity::{self, Aspect, Subject};
use krank::solver::{Condition, Fault, GroupKind, Order, Solver};
use krank::{Body, Driver, ElementId, Input, LinkId, Mechanism, PointId, Vec2, angle};

struct ThreeCranks {
    mechanism: Mechanism,
    platform: LinkId,
    last: LinkId,
    end: PointId,
}

/// Creates cranks of length 1 at 0, 3 and 5, and a platform along all of them.
fn three_cranks(third: f64) -> ThreeCranks {
    let mut builder = Mechanism::builder();
    let [a, d, h] = [0.0, 3.0, 5.0].map(|x| builder.ground_point(x, 0.0));
    let [b, c, k] = [(); 3].map(|()| builder.moving_point());
    let crank = builder.link(a, b, 1.0);
    let platform = builder.link(b, c, 3.0);
    builder.carry(platform, k, Vec2::new(5.0, 0.0));
    builder.link(d, c, 1.0);
    let last = builder.link(h, k, third);
    builder.driver(Driver {
        input: Input::Turn(crank),
        start: 60.0,
        speed: 2.0,
        acceleration: 0.0,
    });
    builder.start(c, Vec2::new(3.5, 0.8));
    builder.start(k, Vec2::new(5.5, 0.8));
    ThreeCranks {
        mechanism: builder.build().expect("every element is sound"),
        platform,
        last,
        end: k,
    }
}

#[test]
fn h17_three_parallel_cranks_move_accurately() {
    const HALF_ROOT_3: &str = "0.8660254037844386467637231707529361835";
    let of = three_cranks(1.0);
    let solver = Solver::new(&of.mechanism).expect("the third crank agrees");
    assert_eq!(solver.plan().redundant.len(), 1);
    // Change points at 0 and 180 degrees are in between: the sine of the transmission angle is that
    // of the driver.
    for (at, x, y) in [
        (60.0, "5.5", HALF_ROOT_3),
        (90.0, "5", "1"),
        (120.0, "4.5", HALF_ROOT_3),
        (150.0, "4.1339745962155613532362768292470638165", "0.5"),
        (30.0, "5.8660254037844386467637231707529361835", "0.5"),
    ] {
        let state = solved(&solver, at);
        let sin_mu = angle::unit(at).y;
        let slack = 3.6 * U * 5.0 / sin_mu;
        assert_near("K.x", state.position(of.end).unwrap().x, x, slack);
        assert_near("K.y", state.position(of.end).unwrap().y, y, slack);
        let omega = state.omega(of.platform).unwrap().abs();
        assert!(
            omega <= 7.0 * U * 2.0 * 5.0 / (sin_mu * sin_mu),
            "{omega:e} at {at}"
        );
    }
}

#[test]
fn h17_third_crank_a_billionth_longer_is_rejected() {
    let of = three_cranks(1.0 + 1e-9);
    match Solver::new(&of.mechanism) {
        Err(Fault::OverConstrained {
            element, misfit, ..
        }) => {
            assert_eq!(element, ElementId::Link(of.last));
            assert!((0.5e-9..2e-9).contains(&misfit), "{misfit:e}");
        }
        other => panic!("{other:?}"),
    }
}

/// Opens a ram along y, and a pin in a slot of the ram and in a slot along x: the pin is where two
/// lines meet.
fn ram_and_slots(slope: f64) -> Result<(Solver, PointId), Fault> {
    let mut builder = Mechanism::builder();
    let (ram, pin) = (builder.free_link(), builder.moving_point());
    let along_y = builder.sliding_link(ram, -90.0, Body::Ground, Vec2::ZERO, 90.0);
    builder.pin_in_slot(pin, Body::Link(ram), Vec2::ZERO, slope);
    builder.pin_in_slot(pin, Body::Ground, Vec2::ZERO, 0.0);
    builder.driver(push(along_y, 1.0));
    let mechanism = builder.build().expect("every element is sound");
    Solver::new(&mechanism).map(|solver| (solver, pin))
}

/// Opens a yoke along x with a slot for the pin of a crank of length 1: RPP.
fn crank_and_yoke(slope: f64) -> Result<(Solver, PointId), Fault> {
    let mut builder = Mechanism::builder();
    let (origin, pin) = (builder.ground_point(0.0, 0.0), builder.moving_point());
    let crank = builder.link(origin, pin, 1.0);
    let (yoke, point) = (builder.free_link(), builder.moving_point());
    builder.carry(yoke, point, Vec2::ZERO);
    builder.sliding_link(yoke, 0.0, Body::Ground, Vec2::ZERO, 0.0);
    builder.pin_in_slot(pin, Body::Link(yoke), Vec2::ZERO, slope);
    builder.driver(turn(crank, 60.0));
    let mechanism = builder.build().expect("every element is sound");
    Solver::new(&mechanism).map(|solver| (solver, point))
}

#[test]
fn h26_parallel_slides_are_rejected() {
    for slope in [0.0, 180.0, -180.0, 360.0] {
        for fault in [ram_and_slots(slope).err(), crank_and_yoke(slope).err()] {
            assert!(
                matches!(fault, Some(Fault::Singular { .. })),
                "{slope}: {fault:?}"
            );
        }
    }
}

#[test]
fn h26_nearly_parallel_slides_meet_far_away() {
    // The direction (1, 2^-40): to 24 digits the angle equals its tangent.
    let radian = PI / DoubleDouble::from(180.0);
    let slope = (DoubleDouble::from(2.0_f64.powi(-40)) / radian).hi;
    let tangent = DoubleDouble::from(slope) * radian;

    let (solver, pin) = ram_and_slots(slope).expect("they meet");
    assert_eq!(
        solver.plan().groups.last().expect("a group").kind,
        GroupKind::Prp
    );
    for y in [1.0, -0.5, 3.0] {
        let far = DoubleDouble::from(-y) / tangent;
        let state = solved(&solver, y);
        let relative = far.minus(state.position(pin).unwrap().x).abs() / far.hi.abs();
        assert!(relative <= 4.0 * U, "x at {y}: {} u", relative / U);
        assert_eq!(state.position(pin).unwrap().y, 0.0);
        let rate = state.velocity(pin).unwrap().x + 1.0 / tangent.hi;
        assert!(rate.abs() <= 4.0 * U / tangent.hi, "rate at {y}: {rate:e}");
    }

    let (solver, yoke) = crank_and_yoke(slope).expect("they meet");
    assert_eq!(
        solver.plan().groups.last().expect("a group").kind,
        GroupKind::Rpp
    );
    let sine = exact("0.8660254037844386467637231707529361835");
    for (at, x, y) in [(60.0, 0.5, sine), (90.0, 0.0, DoubleDouble::from(1.0))] {
        let far = DoubleDouble::from(x) - y / tangent;
        let state = solved(&solver, at);
        let relative = far.minus(state.position(yoke).unwrap().x).abs() / far.hi.abs();
        assert!(relative <= 4.0 * U, "x at {at}: {} u", relative / U);
    }
}

const STAGES: usize = 50;

/// Crossed pairs of bars of length 2, stacked on each other; the joints on the left and right from
/// the ground up, and the middles.
struct Scissor {
    solver: Solver,
    left: Vec<PointId>,
    right: Vec<PointId>,
    middle: Vec<PointId>,
}

fn scissor(stages: usize, start: f64) -> Scissor {
    let mut builder = Mechanism::builder();
    let unit = angle::unit(start);
    let mut left = vec![builder.ground_point(0.0, 0.0)];
    let mut right = vec![builder.moving_point()];
    let mut middle = Vec::new();
    builder.pin_in_slot(right[0], Body::Ground, Vec2::ZERO, 0.0);
    builder.start(right[0], Vec2::new(2.0 * unit.x, 0.0));
    for k in 0..stages {
        let [l, r, m] = [(); 3].map(|()| builder.moving_point());
        let rising = builder.link(left[k], r, 2.0);
        let falling = builder.link(right[k], l, 2.0);
        builder.carry(rising, m, Vec2::new(1.0, 0.0));
        builder.carry(falling, m, Vec2::new(1.0, 0.0));
        if k == 0 {
            builder.driver(turn(rising, start));
        }
        builder.start(m, Vec2::new(unit.x, (2 * k + 1) as f64 * unit.y));
        builder.start(l, Vec2::new(0.0, (2 * k + 2) as f64 * unit.y));
        builder.start(r, Vec2::new(2.0 * unit.x, (2 * k + 2) as f64 * unit.y));
        left.push(l);
        right.push(r);
        middle.push(m);
    }
    let mechanism = builder.build().expect("every element is sound");
    Scissor {
        solver: Solver::new(&mechanism).expect("it closes"),
        left,
        right,
        middle,
    }
}

#[test]
fn h30_scissor_of_fifty_stages_is_accurate() {
    let of = scissor(STAGES, 40.0);
    for (at, cond) in [(40.0, 7.5e3), (10.0, 3.8e4), (70.0, 7.5e3)] {
        let state = solved(&of.solver, at);
        let unit = angle::unit(at);
        let slack = cond * 10.0 * U * 2.0;
        let mut worst = 0.0_f64;
        for k in 0..=STAGES {
            let y = 2.0 * k as f64 * unit.y;
            let mut places = vec![
                (of.left[k], Vec2::new(0.0, y)),
                (of.right[k], Vec2::new(2.0 * unit.x, y)),
            ];
            if k > 0 {
                places.push((of.middle[k - 1], Vec2::new(unit.x, y - unit.y)));
            }
            for (point, position) in places {
                let off = state.position(point).unwrap() - position;
                worst = worst.max(off.x.abs()).max(off.y.abs());
            }
        }
        note(&format!(
            "H30: {} u of a bar at {at}, allowed {}",
            worst / (2.0 * U),
            slack / (2.0 * U)
        ));
        assert!(worst <= slack, "{worst:e} at {at}");
    }
    let mut state = of.solver.state();
    let at_40 = of.solver.solve(40.0, Order::Acceleration, &mut state);
    assert_eq!(at_40, Condition::Ok);
    let top = of.right[STAGES];
    // A hundred dyads solved one after the other would have no bound; solved together they have
    // one.
    let mut enclosure = of.solver.enclosure();
    let order = Order::Acceleration;
    of.solver.enclose(&mut state, order, &mut enclosure);
    for (aspect, value) in [
        (Aspect::Y, "64.27876096865393263226"),
        (Aspect::Ay, "-64.27876096865393263226"),
    ] {
        let top = Subject::Point(top);
        let found = quantity::value(top, aspect, &state).expect("a value");
        let bound = quantity::bound(top, aspect, &state, &enclosure).expect("a bound");
        let off = exact(value).minus(found).abs();
        note(&format!("H30: {aspect:?} off by {off:e}, bound {bound:e}"));
        assert!(
            off <= bound && bound < 1e-3,
            "{aspect:?}: {off:e} {bound:e}"
        );
    }
    let slack = 7.5e3 * 10.0 * U * 2.0;
    assert_near(
        "R50.y",
        state.position(top).unwrap().y,
        "64.27876096865393263226",
        slack,
    );
    // Accelerations lose the condition number once more.
    let ay = state.acceleration(top).unwrap().y;
    let off = exact("-64.27876096865393263226").minus(ay).abs();
    note(&format!(
        "H30: R50 ay off by {:e}, {} u",
        off,
        off / (64.3 * U)
    ));
    assert!(off <= 7.5e3 * slack, "ay {ay}: {off:e}");
}

/// Each parallelogram in a row takes the last coefficient of its series from those behind it,
/// unless its coupler is known to keep its direction.
#[test]
fn long_row_of_parallelograms_turns_fully() {
    const ROW: usize = 120;
    let mut builder = Mechanism::builder();
    let mut ground = builder.ground_point(0.0, 0.0);
    let mut pin = builder.moving_point();
    let crank = builder.link(ground, pin, 40.0);
    for k in 1..=ROW {
        let x = 100.0 * k as f64;
        ground = builder.ground_point(x, 0.0);
        let next = builder.moving_point();
        builder.link(pin, next, 100.0);
        builder.link(ground, next, 40.0);
        builder.start(next, Vec2::new(x + 20.0, 34.6));
        pin = next;
    }
    builder.driver(turn(crank, 60.0));
    let mechanism = builder.build().expect("every element is sound");
    let solver = Solver::new(&mechanism).expect("it closes");
    let motion = solver.motion();
    assert_eq!(motion.range, krank::solver::Range::Full { period: 360.0 });
    assert_eq!(motion.change_points, [0.0, 180.0]);
    for at in [0.1, 120.0, 180.0, 181.0, 300.0] {
        let mut state = solver.state();
        let condition = solver.solve(at, Order::Position, &mut state);
        assert_ne!(condition, Condition::NoAssembly, "{at}");
        let found = state.position(pin).unwrap();
        let right = Vec2::new(100.0 * ROW as f64, 0.0) + angle::unit(at) * 40.0;
        assert!((found - right).norm() < 1e-9, "{at} {found:?}");
    }
}
