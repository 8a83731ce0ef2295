//! Linkages with a redundant constraint that leads them through a point which would be a change
//! point without it: the continuation is unique, and the linkage is not singular.

use krank::solver::{Condition, Order, Range, Solver, State};
use krank::{Body, Builder, Driver, Input, LinkId, Vec2};

fn turning(link: LinkId) -> Driver {
    Driver {
        input: Input::Turn(link),
        start: 60.0,
        speed: 1.0,
        acceleration: 0.0,
    }
}

/// Opens a mechanism, checks that it turns fully without a change point, and returns the states at
/// and near the given coordinates.
fn assert_full_turn(m: Builder, places: [f64; 2]) -> Vec<State> {
    let solver = Solver::new(&m.build().unwrap()).unwrap();
    let motion = solver.motion();
    assert_eq!(motion.range, Range::Full { period: 360.0 });
    assert!(
        motion.change_points.is_empty(),
        "{:?}",
        motion.change_points
    );
    let around = places.into_iter().flat_map(|at| [at - 1e-6, at, at + 1e-6]);
    let states = around.map(|at| {
        let mut state = solver.state();
        assert_eq!(
            solver.solve(at, Order::Acceleration, &mut state),
            Condition::Ok,
            "at {at}"
        );
        state.into_state()
    });
    states.collect()
}

/// A coupler on three cranks whose pivots are not collinear: two of the cranks alone could fold
/// over.
#[test]
fn third_crank_off_line_removes_change_points() {
    let mut m = Builder::default();
    let positions = [Vec2::ZERO, Vec2::new(3.0, 0.0), Vec2::new(1.0, 1.0)];
    let [a, d, e] = positions.map(|p| m.ground_point(p.x, p.y));
    let [b, c, f] = [(); 3].map(|()| m.moving_point());
    let crank = m.link(a, b, 1.0);
    let coupler = m.link(b, c, 3.0);
    m.carry(coupler, f, Vec2::new(1.0, 1.0));
    m.link(d, c, 1.0);
    m.link(e, f, 1.0);
    m.driver(turning(crank));
    let to = krank::angle::unit(60.0);
    m.start(c, positions[1] + to);
    m.start(f, positions[2] + to);
    for state in assert_full_turn(m, [0.0, 180.0]) {
        let expected = krank::angle::unit(state.at()) + positions[2];
        assert!((state.position(f).unwrap() - expected).norm() < 1e-13);
        assert!(state.omega(coupler).unwrap().abs() < 1e-12);
    }
}

/// Two wheels of a locomotive, coupled on both sides, with the cranks at right angles.
#[test]
fn quartered_cranks_have_no_change_points() {
    let mut m = Builder::default();
    let (a, d) = (m.ground_point(0.0, 0.0), m.ground_point(5.0, 0.0));
    let [b, b2, c, c2] = [(); 4].map(|()| m.moving_point());
    let quarter = Vec2::new(0.0, 1.0);
    let wheel = m.link(a, b, 1.0);
    m.carry(wheel, b2, quarter);
    let other = m.link(d, c, 1.0);
    m.carry(other, c2, quarter);
    m.link(b, c, 5.0);
    m.link(b2, c2, 5.0);
    m.driver(turning(wheel));
    let to = krank::angle::unit(60.0);
    m.start(c, Vec2::new(5.0, 0.0) + to);
    m.start(c2, Vec2::new(5.0, 0.0) + to.perp());
    for state in assert_full_turn(m, [0.0, 180.0]) {
        assert!((state.omega(other).unwrap() - 1.0).abs() < 1e-12);
        assert!(state.alpha(other).unwrap().abs() < 1e-11);
    }
}

/// A bar whose ends slide on two perpendicular lines, turned by a crank at its middle.
#[test]
fn trammel_with_both_slides_has_no_change_points() {
    let mut m = Builder::default();
    let o = m.ground_point(0.0, 0.0);
    let [p, q, middle] = [(); 3].map(|()| m.moving_point());
    let crank = m.link(o, middle, 1.0);
    let bar = m.link(p, q, 2.0);
    m.carry(bar, middle, Vec2::new(1.0, 0.0));
    m.pin_in_slot(p, Body::Ground, Vec2::ZERO, 0.0);
    m.pin_in_slot(q, Body::Ground, Vec2::ZERO, 90.0);
    m.driver(turning(crank));
    let to = krank::angle::unit(60.0) * 2.0;
    m.start(p, Vec2::new(to.x, 0.0));
    m.start(q, Vec2::new(0.0, to.y));
    for state in assert_full_turn(m, [90.0, 270.0]) {
        assert!((state.omega(bar).unwrap() + 1.0).abs() < 1e-12);
        let expected = 2.0 * krank::angle::unit(state.at()).x;
        assert!((state.position(p).unwrap().x - expected).abs() < 1e-13);
    }
}

/// Beside the end of a table, the change point and its mirror image beyond the end belong to one series. It
/// counted as led through or not by the state between both.
#[test]
fn redundant_crank_leads_through_beside_the_end_of_a_table() {
    let text = include_str!("scenes/led_before_table_end.toml");
    let in_line = text
        .replace("K = [31.9, 5]", "K = [31.9, 0]")
        .replace("28.52, -15.14", "25.52, -19.14");
    let in_line = in_line.replace("[-530.2796, -162.7383]", "[-526.6023, -159.3504]");
    for (text, expected) in [
        (text, &[][..]),
        (&in_line, &[0.851_511_265_279, 106.138_857_598_155]),
    ] {
        let scene = krank::scene::Scene::parse(text, "cranks").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let found = &solver.motion().change_points;
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9, "{found} is not {expected}");
        }
    }
}
