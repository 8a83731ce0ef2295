//! The solver on mechanisms of every kind, built in code.
//!
//! One checker compares each state with the mechanism itself - lengths, guides, locked angles - and
//! its rates with central differences, so that the tests share no formulas with the solver.

use krank::solver::{Condition, Demand, Fault, GroupKind, Order, Range, Solver, State};
use krank::{
    Body, Builder, Driver, ElementId, Input, LinkId, Mechanism, PointId, SlideId, Slider, Vec2,
};

const GROUND: Body = Body::Ground;

pub(super) fn turn(link: LinkId, start: f64) -> Driver {
    Driver {
        input: Input::Turn(link),
        start,
        speed: 3.0,
        acceleration: 7.0,
    }
}

pub(super) fn push(slide: SlideId, start: f64) -> Driver {
    Driver {
        input: Input::Push(slide),
        start,
        speed: 0.5,
        acceleration: -0.25,
    }
}

pub(super) fn solver(builder: Builder) -> (Mechanism, Solver) {
    let mechanism = builder.build().unwrap();
    let solver = Solver::new(&mechanism).unwrap();
    (mechanism, solver)
}

pub(super) fn kinds(solver: &Solver) -> Vec<GroupKind> {
    solver.plan().groups.iter().map(|g| g.kind).collect()
}

/// Returns the state at a coordinate, which must exist.
pub(super) fn at(solver: &Solver, q: f64) -> State {
    let mut state = solver.state();
    assert_eq!(
        solver.solve(q, Order::Acceleration, &mut state),
        Condition::Ok,
        "at {q}"
    );
    state.into_state()
}

/// Asserts the lengths of all links, the positions of all sliders on their guides, and the angles
/// of all locked links.
fn assert_assembled(mechanism: &Mechanism, state: &State, size: f64) {
    let tolerance = 1e-12 * size;
    for id in mechanism.link_ids() {
        let members = &mechanism.link(id).members;
        for m in members {
            let seen = state.position(m.point).unwrap() - state.position(members[0].point).unwrap();
            let expected = (m.local - members[0].local).turned(state.direction(id).unwrap());
            assert!(
                (seen - expected).norm() < tolerance,
                "{id:?} {seen:?} {expected:?}"
            );
        }
        assert!((state.direction(id).unwrap().norm() - 1.0).abs() < 1e-13);
    }
    for id in mechanism.slide_ids() {
        assert_on_guide(mechanism, state, id, tolerance);
    }
}

fn assert_on_guide(mechanism: &Mechanism, state: &State, id: SlideId, tolerance: f64) {
    let slide = mechanism.slide(id);
    let (origin, d) = match slide.on {
        Body::Ground => (Vec2::ZERO, Vec2::X),
        Body::Link(on) => {
            let m = mechanism.link(on).members[0];
            let d = state.direction(on).unwrap();
            (state.position(m.point).unwrap() - m.local.turned(d), d)
        }
    };
    let guide = slide.direction().turned(d);
    let expected = origin + slide.through.turned(d) + guide * state.travel(id).unwrap().position;
    let seen = state.position(slide.slider.point()).unwrap();
    assert!(
        (seen - expected).norm() < tolerance,
        "{id:?} {seen:?} {expected:?}"
    );
    if let Slider::Link { link, turn, .. } = slide.slider {
        assert!(
            krank::angle::unit(turn)
                .turned(guide)
                .cross(state.direction(link).unwrap())
                .abs()
                < 1e-13,
            "{id:?}"
        );
    }
}

/// Compares rates with central differences along the driver's own motion q(t) = q + q' t + q'' t^2
/// / 2.
fn assert_rates(mechanism: &Mechanism, solver: &Solver, q: f64, tolerance: f64) {
    let driver = mechanism.driver();
    let unit = match driver.input {
        Input::Turn(_) => 180.0 / std::f64::consts::PI,
        Input::Push(_) => 1.0,
    };
    let dt = 1e-4;
    let moved = |t: f64| q + unit * (driver.speed * t + 0.5 * driver.acceleration * t * t);
    let (before, now, after) = (at(solver, moved(-dt)), at(solver, q), at(solver, moved(dt)));
    // The driver accelerates, so that its speed differs between the three states.
    let speed = |t: f64| (driver.speed + driver.acceleration * t) / driver.speed;
    let slope = |before: f64, after: f64| (after - before) / (2.0 * dt);
    let agree = |seen: f64, expected: f64, scale: f64, what: &str| {
        let slack = tolerance * (1.0 + scale);
        assert!(
            (seen - expected).abs() < slack,
            "{what} at {q}: {seen} and {expected}"
        );
    };
    for p in mechanism.point_ids() {
        let (v, a) = (now.velocity(p).unwrap(), now.acceleration(p).unwrap());
        let place = |s: &State| s.position(p).unwrap();
        let rate = |s: &State, t: f64| s.velocity(p).unwrap() * speed(t);
        let scale = v.norm() + a.norm();
        agree(slope(place(&before).x, place(&after).x), v.x, scale, "vx");
        agree(slope(place(&before).y, place(&after).y), v.y, scale, "vy");
        agree(
            slope(rate(&before, -dt).x, rate(&after, dt).x),
            a.x,
            scale,
            "ax",
        );
        agree(
            slope(rate(&before, -dt).y, rate(&after, dt).y),
            a.y,
            scale,
            "ay",
        );
    }
    for l in mechanism.link_ids() {
        let turned = after
            .direction(l)
            .unwrap()
            .turned(before.direction(l).unwrap().conj())
            .angle();
        let scale = now.omega(l).unwrap().abs() + now.alpha(l).unwrap().abs();
        agree(turned / (2.0 * dt), now.omega(l).unwrap(), scale, "omega");
        let alpha = slope(
            before.omega(l).unwrap() * speed(-dt),
            after.omega(l).unwrap() * speed(dt),
        );
        agree(alpha, now.alpha(l).unwrap(), scale, "alpha");
    }
    for s in mechanism.slide_ids() {
        let (a, b, c) = (
            before.travel(s).unwrap(),
            now.travel(s).unwrap(),
            after.travel(s).unwrap(),
        );
        let [early, rate, late] = [a, b, c].map(|travel| travel.rate.unwrap());
        let accel = b.accel.unwrap();
        let scale = rate.abs() + accel.abs();
        agree(slope(a.position, c.position), rate, scale, "rate");
        agree(
            slope(early * speed(-dt), late * speed(dt)),
            accel,
            scale,
            "accel",
        );
    }
}

/// Checks states over the whole range, and their rates away from its ends.
pub(super) fn check(mechanism: &Mechanism, solver: &Solver) {
    let (low, high) = match solver.motion().range {
        Range::Full { period } => (0.0, period),
        Range::Limited { low, high } => (low, high),
    };
    for k in 1..40 {
        let q = low + (high - low) * f64::from(k) / 40.0;
        assert_assembled(mechanism, &at(solver, q), 4.0);
        if (4..37).contains(&k) {
            assert_rates(mechanism, solver, q, 2e-5);
        }
    }
}

/// Creates a crank of length 1 about the origin with its pin.
fn crank(b: &mut Builder, start: f64) -> (PointId, PointId, LinkId) {
    let (o, pin) = (b.ground_point(0.0, 0.0), b.moving_point());
    let link = b.link(o, pin, 1.0);
    b.driver(turn(link, start));
    (o, pin, link)
}

#[test]
fn rrp_with_pin_in_slot_and_with_sliding_link() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 40.0);
    let c = b.moving_point();
    b.link(pin, c, 3.0);
    b.pin_in_slot(c, GROUND, Vec2::new(0.5, 0.3), 10.0);
    b.start(c, Vec2::new(3.5, 0.5));
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Rrp]);
    check(&m, &s);

    // A ram instead: the pin is off the guide, and the ram at an angle.
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 40.0);
    let c = b.moving_point();
    b.link(pin, c, 3.0);
    let ram = b.free_link();
    b.carry(ram, c, Vec2::new(-0.4, 0.2));
    b.sliding_link(ram, 30.0, GROUND, Vec2::new(0.5, 0.3), 10.0);
    b.start(c, Vec2::new(3.5, 0.5));
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Rrp]);
    check(&m, &s);
}

#[test]
fn rrp_on_moving_guide() {
    let mut b = Builder::default();
    let (_, _, link) = crank(&mut b, 40.0);
    let (d, c) = (b.ground_point(2.5, 0.0), b.moving_point());
    b.link(d, c, 4.0);
    b.pin_in_slot(c, Body::Link(link), Vec2::new(0.2, 0.5), 75.0);
    b.start(c, Vec2::new(-1.0, 2.0));
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Rrp]);
    check(&m, &s);
}

#[test]
fn rpr_with_pin_in_arm_and_with_block() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 40.0);
    let (o, t) = (b.ground_point(0.3, -2.5), b.moving_point());
    let arm = b.link(o, t, 4.0);
    b.pin_in_slot(pin, Body::Link(arm), Vec2::new(0.0, 0.25), 5.0);
    b.start(t, Vec2::new(1.0, 1.5));
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Rpr]);
    check(&m, &s);

    // A block with its own offset, pinned to the crank.
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 40.0);
    let (o, t) = (b.ground_point(0.3, -2.5), b.moving_point());
    let arm = b.link(o, t, 4.0);
    let block = b.free_link();
    b.carry(block, pin, Vec2::new(0.1, -0.3));
    b.sliding_link(block, 20.0, Body::Link(arm), Vec2::new(0.0, 0.25), 5.0);
    b.start(t, Vec2::new(1.0, 1.5));
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Rpr]);
    check(&m, &s);
}

#[test]
fn arm_without_own_point_points_towards_its_pin() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 40.0);
    let o = b.ground_point(0.3, -2.5);
    let arm = b.free_link();
    b.carry(arm, o, Vec2::ZERO);
    let slide = b.pin_in_slot(pin, Body::Link(arm), Vec2::ZERO, 0.0);
    let (m, s) = solver(b);
    assert!(at(&s, 40.0).travel(slide).unwrap().position > 0.0);
    check(&m, &s);
}

#[test]
fn prp_of_two_slots_and_of_two_sliding_links() {
    let mut b = Builder::default();
    let (_, _, link) = crank(&mut b, 40.0);
    let c = b.moving_point();
    b.pin_in_slot(c, Body::Link(link), Vec2::new(0.3, 0.0), 90.0);
    b.pin_in_slot(c, GROUND, Vec2::new(0.0, 2.0), 10.0);
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Prp]);
    assert_assembled(&m, &at(&s, 50.0), 4.0);
    assert_rates(&m, &s, 50.0, 1e-5);

    // One on the crank and one on the ground, pinned to each other.
    let mut b = Builder::default();
    let (_, _, link) = crank(&mut b, 40.0);
    let c = b.moving_point();
    let (one, two) = (b.free_link(), b.free_link());
    b.carry(one, c, Vec2::new(0.3, 0.1));
    b.carry(two, c, Vec2::new(-0.2, 0.4));
    b.sliding_link(one, 15.0, Body::Link(link), Vec2::new(0.3, 0.0), 90.0);
    b.sliding_link(two, -20.0, GROUND, Vec2::new(0.0, 2.0), 10.0);
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Prp]);
    assert_assembled(&m, &at(&s, 50.0), 4.0);
    assert_rates(&m, &s, 50.0, 1e-5);
}

#[test]
fn rpp_yoke_on_inclined_guide() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 40.0);
    let (yoke, far) = (b.free_link(), b.moving_point());
    b.carry(yoke, far, Vec2::new(1.0, 0.5));
    b.sliding_link(yoke, 0.0, GROUND, Vec2::new(0.2, 0.1), 20.0);
    b.pin_in_slot(pin, Body::Link(yoke), Vec2::new(0.3, 0.0), 80.0);
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Rpp]);
    check(&m, &s);
}

#[test]
fn ternary_link_drives_next_dyad() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 60.0);
    let d = b.ground_point(4.0, 0.0);
    let [c, e, f] = [(); 3].map(|()| b.moving_point());
    b.link(pin, c, 3.0);
    let rocker = b.link(c, d, 2.5);
    b.carry(rocker, e, Vec2::new(1.0, 1.5));
    let g = b.ground_point(9.0, 0.6);
    b.link(e, f, 3.4);
    b.link(f, g, 4.0);
    b.start(c, Vec2::new(3.1, 2.3));
    b.start(f, Vec2::new(7.6, 3.3));
    let (m, s) = solver(b);
    assert_eq!(
        kinds(&s),
        [GroupKind::Driver, GroupKind::Rrr, GroupKind::Rrr]
    );
    check(&m, &s);
}

/// Creates Stephenson III, driven where its loops are coupled.
fn stephenson(with_start: bool) -> (Builder, [PointId; 3]) {
    let mut b = Builder::default();
    let (a, d, g) = (
        b.ground_point(0.0, 0.0),
        b.ground_point(3.0, 0.0),
        b.ground_point(2.8, 3.0),
    );
    let [bb, c, e, f] = [(); 4].map(|()| b.moving_point());
    let link = b.link(g, f, 0.3);
    b.driver(turn(link, 60.0));
    b.link(f, e, 1.9);
    let ternary = b.link(bb, c, 2.0);
    b.carry(ternary, e, Vec2::new(0.9, 1.0));
    b.link(a, bb, 1.5);
    b.link(d, c, 1.8);
    if with_start {
        b.start(bb, Vec2::new(0.2, 1.5));
        b.start(c, Vec2::new(2.3, 1.7));
        b.start(e, Vec2::new(1.2, 2.6));
    }
    (b, [bb, c, e])
}

#[test]
fn triad_has_three_unknowns_and_keeps_its_assembly() {
    let (m, s) = solver(stephenson(true).0);
    assert_eq!(
        kinds(&s),
        [GroupKind::Driver, GroupKind::Coupled { unknowns: 3 }]
    );
    assert_eq!(s.motion().range, Range::Full { period: 360.0 });
    check(&m, &s);
}

#[test]
fn triad_without_start_lists_its_assemblies() {
    let (b, [bb, ..]) = stephenson(false);
    match Solver::new(&b.build().unwrap()) {
        Err(Fault::Vague { point, choices, .. }) => {
            assert_eq!(point, bb);
            assert!(choices.len() >= 2, "{choices:?}");
        }
        other => panic!("{:?}", other.err()),
    }
}

#[test]
fn body_on_three_slots_is_coupled() {
    let mut b = Builder::default();
    let (_, _, link) = crank(&mut b, 40.0);
    let [p, q, r] = [(); 3].map(|()| b.moving_point());
    let body = b.free_link();
    b.carry(body, p, Vec2::ZERO);
    b.carry(body, q, Vec2::new(1.0, 0.1));
    b.carry(body, r, Vec2::new(0.3, 0.8));
    b.pin_in_slot(p, GROUND, Vec2::new(0.0, 1.6), 5.0);
    b.pin_in_slot(q, GROUND, Vec2::new(2.0, 0.0), 85.0);
    b.pin_in_slot(r, Body::Link(link), Vec2::new(0.2, 0.0), 20.0);
    b.start(p, Vec2::new(1.0, 1.7));
    b.start(q, Vec2::new(2.0, 1.6));
    b.start(r, Vec2::new(1.3, 2.5));
    let (m, s) = solver(b);
    assert!(
        matches!(kinds(&s)[1], GroupKind::Coupled { .. }),
        "{:?}",
        kinds(&s)
    );
    for q in [8.0, 20.0, 30.0] {
        assert_assembled(&m, &at(&s, q), 4.0);
        assert_rates(&m, &s, q, 1e-5);
    }
}

#[test]
fn ground_slide_drives_slider_crank() {
    let mut b = Builder::default();
    let (o, pin, c) = (b.ground_point(0.0, 0.0), b.moving_point(), b.moving_point());
    b.link(o, pin, 1.0);
    b.link(pin, c, 3.0);
    let slide = b.pin_in_slot(c, GROUND, Vec2::ZERO, 0.0);
    b.driver(push(slide, 3.2));
    b.start(pin, Vec2::new(0.7, 0.7));
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Rrr]);
    let Range::Limited { low, high } = s.motion().range else {
        panic!()
    };
    assert!(
        (low - 2.0).abs() < 1e-14 && (high - 4.0).abs() < 1e-14,
        "{low} {high}"
    );
    check(&m, &s);
}

#[test]
fn cylinder_is_solved_in_closed_form_or_coupled() {
    let mut b = Builder::default();
    let (o, q, p) = (
        b.ground_point(0.0, 0.0),
        b.ground_point(0.4, 0.9),
        b.moving_point(),
    );
    let (barrel, boom) = (b.free_link(), b.free_link());
    b.carry(barrel, o, Vec2::ZERO);
    b.carry(boom, q, Vec2::ZERO);
    b.carry(boom, p, Vec2::new(1.1, -0.2));
    let rod = b.pin_in_slot(p, Body::Link(barrel), Vec2::new(0.0, 0.05), 0.0);
    b.driver(push(rod, 1.0));
    b.start(p, Vec2::new(1.05, 0.2));
    let (m, s) = solver(b);
    assert_eq!(kinds(&s), [GroupKind::Driver, GroupKind::Rrr]);
    check(&m, &s);

    // The rod's pin in a ground slot: a circle of varying radius and a line, solved by Newton's
    // method.
    let mut b = Builder::default();
    let (o, p) = (b.ground_point(0.0, 0.0), b.moving_point());
    let barrel = b.free_link();
    b.carry(barrel, o, Vec2::ZERO);
    let rod = b.pin_in_slot(p, Body::Link(barrel), Vec2::new(0.0, 0.05), 0.0);
    b.pin_in_slot(p, GROUND, Vec2::new(0.0, 0.8), 3.0);
    b.driver(push(rod, 1.5));
    b.start(p, Vec2::new(1.2, 0.8));
    let (m, s) = solver(b);
    assert!(matches!(kinds(&s)[1], GroupKind::Coupled { .. }));
    for q in [1.2, 1.5, 2.5] {
        assert_assembled(&m, &at(&s, q), 4.0);
        assert_rates(&m, &s, q, 1e-5);
    }
}

#[test]
fn third_parallel_crank_is_redundant_or_over_constrained() {
    let parallel = |third: f64| {
        let mut b = Builder::default();
        let (_, pin, _) = crank(&mut b, 60.0);
        let (d, h) = (b.ground_point(3.0, 0.0), b.ground_point(5.0, 0.0));
        let (c, k) = (b.moving_point(), b.moving_point());
        let platform = b.link(pin, c, 3.0);
        b.carry(platform, k, Vec2::new(5.0, 0.0));
        b.link(d, c, 1.0);
        let last = b.link(h, k, third);
        b.start(c, Vec2::new(3.5, 0.8));
        (b.build().unwrap(), last)
    };
    let (mechanism, last) = parallel(1.0);
    let s = Solver::new(&mechanism).unwrap();
    assert_eq!(s.plan().redundant, [ElementId::Link(last)]);
    assert_assembled(&mechanism, &at(&s, 75.0), 4.0);

    let (mechanism, last) = parallel(1.0 + 1e-9);
    match Solver::new(&mechanism) {
        Err(Fault::OverConstrained {
            element, misfit, ..
        }) => {
            assert_eq!(element, ElementId::Link(last));
            assert!((0.5e-9..2e-9).contains(&misfit), "{misfit:e}");
        }
        other => panic!("{:?}", other.err()),
    }
}

#[test]
fn mobility_fault_names_floating_links() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 60.0);
    let (d, c, e) = (b.ground_point(4.0, 0.0), b.moving_point(), b.moving_point());
    let loose = [b.link(pin, c, 3.0), b.link(c, e, 2.0), b.link(e, d, 2.5)];
    match Solver::new(&b.build().unwrap()) {
        Err(Fault::Mobility {
            mobility,
            redundant,
            floating,
            ..
        }) => {
            assert_eq!((mobility, redundant), (2, 0));
            assert_eq!(floating, loose);
        }
        other => panic!("{:?}", other.err()),
    }
}

#[test]
fn truss_is_over_constrained() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 60.0);
    let d = b.ground_point(4.0, 0.0);
    b.link(pin, d, 3.6);
    let fault = Solver::new(&b.build().unwrap()).unwrap_err();
    assert!(matches!(fault, Fault::OverConstrained { .. }), "{fault:?}");
}

#[test]
fn open_loop_reports_gap() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 0.0);
    let (d, c) = (b.ground_point(7.0, 0.0), b.moving_point());
    b.link(pin, c, 3.0);
    b.link(c, d, 2.5);
    b.start(c, Vec2::new(3.0, 1.0));
    match Solver::new(&b.build().unwrap()) {
        Err(Fault::Open { point, gap, .. }) => {
            assert_eq!(point, c);
            assert!((gap - 0.5).abs() < 1e-14, "{gap}");
        }
        other => panic!("{:?}", other.err()),
    }
}

#[test]
fn dyad_without_start_lists_both_assemblies() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 90.0);
    let (d, c) = (b.ground_point(0.0, -3.0), b.moving_point());
    b.link(pin, c, 3.0);
    b.link(c, d, 3.0);
    match Solver::new(&b.build().unwrap()) {
        Err(Fault::Vague { point, choices, .. }) => {
            assert_eq!(point, c);
            let x = 5.0_f64.sqrt();
            for want in [Vec2::new(x, -1.0), Vec2::new(-x, -1.0)] {
                assert!(
                    choices.iter().any(|p| (*p - want).norm() < 1e-14),
                    "{choices:?}"
                );
            }
        }
        other => panic!("{:?}", other.err()),
    }
}

#[test]
fn parallel_guides_are_rejected() {
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 40.0);
    let yoke = b.free_link();
    b.sliding_link(yoke, 0.0, GROUND, Vec2::ZERO, 20.0);
    b.pin_in_slot(pin, Body::Link(yoke), Vec2::ZERO, 0.0);
    let fault = Solver::new(&b.build().unwrap()).unwrap_err();
    assert!(matches!(fault, Fault::Singular { .. }), "{fault:?}");
}

#[test]
fn conflicting_locks_are_rejected_and_equal_ones_redundant() {
    let yoke = |second: f64| {
        let mut b = Builder::default();
        let (_, pin, _) = crank(&mut b, 40.0);
        let yoke = b.free_link();
        b.sliding_link(yoke, 0.0, GROUND, Vec2::ZERO, 20.0);
        b.sliding_link(yoke, second, GROUND, Vec2::ZERO, 20.0);
        b.pin_in_slot(pin, Body::Link(yoke), Vec2::ZERO, 80.0);
        Solver::new(&b.build().unwrap())
    };
    assert!(matches!(yoke(1.0), Err(Fault::OverConstrained { .. })));
    assert!(!yoke(0.0).unwrap().plan().redundant.is_empty());
}

/// Creates a crank and dyads in a row, each driven by the one before.
fn long_chain(dyads: usize) -> Mechanism {
    let mut b = Builder::default();
    let (_, mut pin, _) = crank(&mut b, 60.0);
    for k in 0..dyads {
        let x = 4.0 * (k + 1) as f64;
        let (d, c, e) = (b.ground_point(x, 0.0), b.moving_point(), b.moving_point());
        b.link(pin, c, 3.0);
        let rocker = b.link(d, c, 2.5);
        // The rocker's point moves about as far as the crank's pin.
        b.carry(rocker, e, Vec2::new(0.8, 0.0));
        b.start(c, Vec2::new(x - 0.9, 2.3));
        pin = e;
    }
    b.build().unwrap()
}

#[test]
fn chain_of_thousand_dyads_is_planned_and_solved() {
    let mechanism = long_chain(1000);
    let s = Solver::new(&mechanism).unwrap();
    assert_eq!(s.plan().groups.len(), 1001);
    assert_assembled(&mechanism, &at(&s, 61.0), 4000.0);
}

#[test]
fn only_demanded_elements_are_solved() {
    let mechanism = long_chain(3);
    let complete = Solver::new(&mechanism).unwrap();
    let first = complete.plan().groups[1].point.unwrap();
    let some = complete.only(&Demand {
        points: vec![first],
        ..Demand::default()
    });
    let (full, part) = (at(&complete, 77.0), at(&some, 77.0));
    assert_eq!(
        full.acceleration(first).unwrap(),
        part.acceleration(first).unwrap()
    );
    // The points of the last dyad are not solved and have no values.
    let last = complete.plan().groups[3].point.unwrap();
    assert!(full.position(last).is_some() && full.velocity(last).is_some());
    assert_eq!((part.position(last), part.velocity(last)), (None, None));
    let link = complete.plan().groups[3].links[0];
    assert!(full.omega(link).is_some());
    assert_eq!((part.angle(link), part.omega(link)), (None, None));
    assert_ne!(full, part);
    // Elements excluded by either demand are excluded.
    let other = complete.plan().groups[2].point.unwrap();
    let less = complete
        .only(&Demand {
            points: vec![other],
            ..Demand::default()
        })
        .only(&Demand {
            points: vec![first],
            ..Demand::default()
        });
    let less = at(&less, 77.0);
    assert_eq!(less.position(first), part.position(first));
    assert_eq!((less.position(other), less.position(last)), (None, None));
}

/// A state solved only for positions used to read as one at rest.
#[test]
fn unsolved_values_are_none() {
    let (builder, points) = stephenson(true);
    let (mechanism, solver) = solver(builder);
    let link = mechanism.link_ids().last().unwrap();
    let mut workspace = solver.state();
    let read = |state: &State| {
        let point = points[0];
        [
            state.position(point).is_some() && state.angle(link).is_some(),
            state.velocity(point).is_some() && state.omega(link).is_some(),
            state.acceleration(point).is_some() && state.alpha(link).is_some(),
            state.drive().is_some(),
        ]
    };
    assert_eq!(read(&workspace), [false; 4], "before anything is solved");
    // In descending order, so that values of higher order remain from before.
    for (order, there) in [
        (Order::Force, [true, true, true, false]),
        (Order::Acceleration, [true, true, true, false]),
        (Order::Velocity, [true, true, false, false]),
        (Order::Position, [true, false, false, false]),
    ] {
        assert_eq!(solver.solve(211.5, order, &mut workspace), Condition::Ok);
        assert_eq!((workspace.order(), read(&workspace)), (order, there));
        // Bounds and double-double states have no more than the state itself.
        let (mut balls, mut twice) = (solver.enclosure(), solver.twice());
        solver.enclose(&mut workspace, Order::Force, &mut balls);
        assert!(solver.solve_twice(&workspace, Order::Force, &mut twice));
        let velocity = balls.velocity(points[0]).is_some();
        assert_eq!(
            [velocity, twice.velocity(points[0]).is_some()],
            [there[1]; 2]
        );
    }
    assert_eq!(
        solver.solve(f64::NAN, Order::Acceleration, &mut workspace),
        Condition::NoAssembly
    );
    assert_eq!(read(&workspace), [false; 4], "without an assembly");
}

/// At a dead point there are positions but no rates, and no bounds of rates.
#[test]
fn dead_point_has_no_rates() {
    let mut builder = Mechanism::builder();
    let (a, d) = (
        builder.ground_point(0.0, 0.0),
        builder.ground_point(4.0, 0.0),
    );
    let (b, c) = (builder.moving_point(), builder.moving_point());
    let crank = builder.link(a, b, 3.0);
    builder.link(b, c, 2.0);
    builder.link(c, d, 2.5);
    builder.driver(turn(crank, 60.0));
    builder.start(c, Vec2::new(3.0, 3.0));
    let (_, solver) = self::solver(builder);
    let dead = solver.motion().dead_points[0];
    let (mut workspace, mut balls) = (solver.state(), solver.enclosure());
    let condition = solver.solve(dead, Order::Acceleration, &mut workspace);
    assert_eq!(condition, Condition::DeadPoint);
    solver.enclose(&mut workspace, Order::Acceleration, &mut balls);
    assert!(workspace.position(c).is_some() && balls.position(c).is_some());
    assert_eq!(
        (workspace.velocity(c), workspace.acceleration(c)),
        (None, None)
    );
    assert_eq!(
        (workspace.omega(crank), workspace.alpha(crank)),
        (None, None)
    );
    assert_eq!((balls.velocity(c), balls.omega(crank)), (None, None));
}

/// A state is a value: a copy does not change, and states are equal if all their values are.
#[test]
fn states_can_be_cloned_and_compared() {
    let (builder, _) = stephenson(true);
    let (_, solver) = solver(builder);
    let mut workspace = solver.state();
    let mut solved = |at: f64, order: Order| {
        assert_eq!(solver.solve(at, order, &mut workspace), Condition::Ok);
        workspace.state().clone()
    };
    let here = solved(40.0, Order::Acceleration);
    let there = solved(41.0, Order::Acceleration);
    let places = solved(40.0, Order::Position);
    assert_ne!(here, there);
    assert_ne!(here, places, "an order is a part of what a state says");
    // Remains of the previous state are not part of a state.
    let again = at(&solver, 40.0);
    assert_eq!(here, again);
    let mut fresh = solver.state();
    assert_eq!(
        solver.solve(40.0, Order::Position, &mut fresh),
        Condition::Ok
    );
    assert_eq!(places, *fresh.state());
}

#[test]
fn state_depends_only_on_coordinate() {
    let (b, points) = stephenson(true);
    let (_, s) = solver(b);
    let fresh = at(&s, 211.5);
    let mut used = s.state();
    for q in [10.0, 350.0, -720.25, 211.5 + 360.0e6] {
        let _ = s.solve(q, Order::Acceleration, &mut used);
    }
    for p in points {
        assert_eq!(fresh.position(p).unwrap(), used.position(p).unwrap());
        assert_eq!(fresh.velocity(p).unwrap(), used.velocity(p).unwrap());
        assert_eq!(
            fresh.acceleration(p).unwrap(),
            used.acceleration(p).unwrap()
        );
    }
}

#[test]
fn solving_and_bounding_do_not_allocate() {
    let coupled = solver(stephenson(true).0).1;
    let dyads = Solver::new(&long_chain(12)).unwrap();
    let preset = krank::scene::presets::find("engine").unwrap();
    let loaded = krank::scene::Scene::parse(preset.text, preset.name).unwrap();
    let loaded = Solver::new(&loaded.mechanism).unwrap();
    assert!(loaded.has_forces());
    for s in [coupled, dyads, loaded] {
        let (mut state, order) = (s.state(), Order::Force);
        let (mut enclosure, mut twice) = (s.enclosure(), s.twice());
        let info = allocation_counter::measure(|| {
            for q in 0..100 {
                let _ = s.solve(60.0 + 0.1 * f64::from(q), order, &mut state);
                s.enclose(&mut state, order, &mut enclosure);
                s.solve_twice(&state, order, &mut twice);
            }
        });
        assert_eq!(info.count_total, 0);
    }
}

#[test]
fn driven_rocker_stops_at_dead_points() {
    let mut b = Builder::default();
    let (a, d) = (b.ground_point(0.0, 0.0), b.ground_point(400.0, 0.0));
    let (pin, c) = (b.moving_point(), b.moving_point());
    b.link(a, pin, 100.0);
    b.link(pin, c, 300.0);
    let rocker = b.link(d, c, 250.0);
    b.driver(turn(rocker, 120.0));
    b.start(pin, Vec2::new(50.0, 86.0));
    let (_, s) = solver(b);
    // A, B and C are collinear: AC = 400 and 200.
    let Range::Limited { low, high } = s.motion().range else {
        panic!()
    };
    assert!((low - 108.209_956_864_283_01).abs() < 1e-12, "{low}");
    assert!((high - 155.853_152_003_497_6).abs() < 1e-12, "{high}");
    let mut state = s.state();
    for q in [low - 1e-9, high + 1e-9, 120.0 + 360.0, f64::NAN] {
        assert_eq!(
            s.solve(q, Order::Position, &mut state),
            Condition::NoAssembly,
            "{q}"
        );
    }
}

/// Creates a crank AB about the origin, a coupler, and a rocker about (distance, 0).
fn four_bar(lengths: [f64; 4], start: f64, near: Vec2) -> Builder {
    let [a, b, c, d] = lengths;
    let mut builder = Builder::default();
    let (o, g) = (builder.ground_point(0.0, 0.0), builder.ground_point(d, 0.0));
    let (pin, joint) = (builder.moving_point(), builder.moving_point());
    let crank = builder.link(o, pin, a);
    builder.link(pin, joint, b);
    builder.link(joint, g, c);
    builder.driver(turn(crank, start));
    builder.start(joint, near);
    builder
}

#[test]
fn change_point_near_start_is_found() {
    // d - a = c - b: the links become collinear at 0 degrees. A start within one step of it used to
    // hide the minimum between the last sample and the first.
    for start in [60.0, 0.3, 359.6] {
        let (_, s) = solver(four_bar([2.0, 4.0, 7.0, 5.0], start, Vec2::new(2.0, 2.0)));
        assert_eq!(s.motion().change_points[0], 0.0, "from {start}");
        // It folds over once per turn, and repeats after two.
        assert_eq!(
            s.motion().range,
            Range::Full { period: 720.0 },
            "from {start}"
        );
    }
}

#[test]
fn small_angles_and_levers_are_not_limits() {
    // The coupler meets the rocker at 4e-9 rad throughout the turn, which is due to their shape.
    let (_, s) = solver(four_bar([1.0, 1e9, 1e9, 4.0], 60.0, Vec2::new(2.0, 1e9)));
    assert_eq!(s.motion().range, Range::Full { period: 360.0 });

    // A lever of 1e-8 next to a length of 1: its measure is a length, always small here.
    let mut b = Builder::default();
    let (o, q) = (b.ground_point(0.0, 0.0), b.ground_point(2e-8, 0.0));
    b.ground_point(1.0, 0.0);
    let pin = b.moving_point();
    let link = b.link(o, pin, 1e-8);
    let arm = b.free_link();
    b.carry(arm, q, Vec2::ZERO);
    b.pin_in_slot(pin, Body::Link(arm), Vec2::ZERO, 0.0);
    b.driver(turn(link, 60.0));
    let (_, s) = solver(b);
    assert_eq!(s.motion().range, Range::Full { period: 360.0 });
}

#[test]
fn folded_kite_is_singular_only_where_it_opens() {
    // A kite folded such that crank pin and ground pivot coincide: it used to open with NaN.
    let b = four_bar([1.0, 2.0, 2.0, 1.0], 0.0, Vec2::new(2.0, 2.0));
    let fault = Solver::new(&b.build().unwrap()).unwrap_err();
    // It is singular only here: elsewhere the arms have a direction, and the fault says so.
    let is_here_only = matches!(
        fault,
        Fault::Singular {
            is_here_only: true,
            ..
        }
    );
    assert!(is_here_only, "{fault:?}");
}

#[test]
fn guides_parallel_by_sum_of_angles_are_rejected() {
    // 33.1 - 33.1 degrees leave 1e-17, by which the point used to be placed at 1e16.
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 60.0);
    let yoke = b.free_link();
    b.sliding_link(yoke, 33.1, GROUND, Vec2::ZERO, 12.7);
    b.pin_in_slot(pin, Body::Link(yoke), Vec2::ZERO, -33.1);
    let fault = Solver::new(&b.build().unwrap()).unwrap_err();
    assert!(matches!(fault, Fault::Singular { .. }), "{fault:?}");
}

#[test]
fn very_large_start_angle_opens() {
    // start + 1 = start: there is no sample before the first.
    for start in [1e17, 1e300] {
        let b = four_bar([1.0, 3.0, 2.5, 4.0], start, Vec2::new(2.0, 2.0));
        assert!(Solver::new(&b.build().unwrap()).is_ok());
    }
}

#[test]
fn crank_pinned_to_ground_twice_is_over_constrained() {
    // Both equations of the second pin are set aside, and the one perpendicular to the crank
    // decides.
    let mut b = Builder::default();
    let (_, _, link) = crank(&mut b, 60.0);
    let h = b.ground_point(0.5, 0.0);
    b.carry(link, h, Vec2::new(0.25, -0.75_f64.sqrt() / 2.0));
    let fault = Solver::new(&b.build().unwrap()).unwrap_err();
    assert!(matches!(fault, Fault::OverConstrained { .. }), "{fault:?}");
}

#[test]
fn body_of_coupled_group_can_carry_sliding_link() {
    // The slide locks both directions together. The sliding link's own position is solved later,
    // and used to count among the group's unknowns.
    let (mut b, [_, _, e]) = stephenson(true);
    let ternary = *b.clone().build().unwrap().point(e).links.last().unwrap();
    let (block, q) = (b.free_link(), b.moving_point());
    b.carry(block, q, Vec2::new(0.2, 0.1));
    b.sliding_link(block, 25.0, Body::Link(ternary), Vec2::new(0.4, 0.2), 10.0);
    let g = b.ground_point(0.5, 4.0);
    b.link(g, q, 2.6);
    b.start(q, Vec2::new(1.0, 1.6));
    let (m, s) = solver(b);
    assert!(kinds(&s).contains(&GroupKind::Coupled { unknowns: 3 }));
    check(&m, &s);
}

#[test]
fn strut_inside_link_of_coupled_group_is_redundant() {
    // By counting alone, any bar around the ternary link could be redundant, and the last one drawn
    // used to be. Only the strut between two points of that link is.
    let mut b = Builder::default();
    let (_, pin, _) = crank(&mut b, 60.0);
    let [p, q, r] = [(); 3].map(|()| b.moving_point());
    let ternary = b.free_link();
    let corners = [Vec2::ZERO, Vec2::new(2.0, 0.0), Vec2::new(1.0, 1.0)];
    for (point, local) in [p, q, r].into_iter().zip(corners) {
        b.carry(ternary, point, local);
    }
    let strut = b.link(q, r, 2.0_f64.sqrt());
    let (d, g) = (b.ground_point(3.0, -2.0), b.ground_point(6.0, -1.0));
    b.link(pin, p, 2.5);
    b.link(d, q, 3.0);
    b.link(g, r, 4.0);
    b.start(p, Vec2::new(2.5, 1.8));
    b.start(q, Vec2::new(4.2, 0.8));
    b.start(r, Vec2::new(3.9, 2.2));
    let (m, s) = solver(b);
    assert_eq!(s.plan().redundant, [ElementId::Link(strut)]);
    check(&m, &s);
}

#[test]
fn coupled_group_needs_no_ground_point() {
    // A triangle on a bar from a driven slider and on two ground slots, without a ground joint:
    // the guides used to lack a reference point.
    let mut b = Builder::default();
    let [p, q, r, s] = [(); 4].map(|()| b.moving_point());
    let body = b.free_link();
    b.carry(body, q, Vec2::ZERO);
    b.carry(body, r, Vec2::new(2.0, 0.0));
    b.carry(body, s, Vec2::new(1.0, 1.0));
    b.link(p, s, 1.5);
    let drive = b.pin_in_slot(p, GROUND, Vec2::new(0.0, 2.5), 0.0);
    b.pin_in_slot(q, GROUND, Vec2::ZERO, 90.0);
    b.pin_in_slot(r, GROUND, Vec2::ZERO, 10.0);
    b.driver(push(drive, 2.2));
    b.start(q, Vec2::new(0.0, 0.4));
    b.start(r, Vec2::new(2.0, 0.35));
    b.start(s, Vec2::new(1.0, 1.4));
    let (m, s) = solver(b);
    assert_eq!(
        kinds(&s),
        [GroupKind::Driver, GroupKind::Coupled { unknowns: 3 }]
    );
    check(&m, &s);
}

/// Opens Stephenson III with a longer crank, which stops at two dead points.
fn limited_triad(start: f64, positions: [Vec2; 3]) -> (Mechanism, Solver, [PointId; 3]) {
    let mut b = Builder::default();
    let (a, d, g) = (
        b.ground_point(0.0, 0.0),
        b.ground_point(3.0, 0.0),
        b.ground_point(2.8, 3.0),
    );
    let [bb, c, e, f] = [(); 4].map(|()| b.moving_point());
    let link = b.link(g, f, 0.9);
    b.driver(turn(link, start));
    b.link(f, e, 2.3);
    let ternary = b.link(bb, c, 2.0);
    b.carry(ternary, e, Vec2::new(0.9, 1.0));
    b.link(a, bb, 1.5);
    b.link(d, c, 1.8);
    for (point, position) in [bb, c, e].into_iter().zip(positions) {
        b.start(point, position);
    }
    let (m, s) = solver(b);
    (m, s, [bb, c, e])
}

/// Its positions at 60 degrees.
const TRIAD_AT_60: [Vec2; 3] = [
    Vec2::new(0.4, 1.45),
    Vec2::new(2.4, 1.7),
    Vec2::new(1.33, 2.513),
];

#[test]
fn triad_keeps_its_assembly_up_to_dead_points() {
    // The limits are those of two independent continuations with 60 digits. Within the last degree,
    // the nearest state in steps of a degree leads to the other assembly, so that the intermediate
    // states of the tracking must be kept.
    let (m, s, [.., e]) = limited_triad(60.0, TRIAD_AT_60);
    let Range::Limited { low, high } = s.motion().range else {
        panic!()
    };
    assert!((low - 47.937_702_396_774_27).abs() < 1e-9, "{low}");
    assert!((high - 322.497_269_422_333_17).abs() < 1e-9, "{high}");
    for end in [low, high] {
        // At a distance of x^2 from a dead point, a joint has moved by about x.
        let mut limit = s.state();
        let condition = s.solve(end, Order::Acceleration, &mut limit);
        assert_eq!(condition, Condition::DeadPoint, "at {end}");
        let mut last = limit.position(e).unwrap();
        for k in 1..400 {
            let x = f64::from(k) / 400.0;
            let state = at(&s, end - (end - 180.0).signum() * x * x);
            assert_assembled(&m, &state, 4.0);
            let moved = (state.position(e).unwrap() - last).norm();
            assert!(moved < 2e-3, "{moved} at {x} from {end}");
            last = state.position(e).unwrap();
        }
    }
}

#[test]
fn motion_opened_near_dead_point_does_not_cross_it() {
    // The motion bends so sharply there that one step used to end in the other assembly, whose
    // joints happened to be at the step's extrapolated positions.
    let (_, s, points) = limited_triad(60.0, TRIAD_AT_60);
    let Range::Limited { low, high } = s.motion().range else {
        panic!()
    };
    for start in (0..120).map(|k| low + 3.0 * 0.85_f64.powi(k)) {
        let state = at(&s, start);
        let (_, nearby, _) = limited_triad(start, points.map(|p| state.position(p).unwrap()));
        for q in [low + 0.5, low + 1.0, 60.0, 200.0, high - 0.1] {
            let (one, other) = (at(&s, q), at(&nearby, q));
            for p in points {
                let distance = (one.position(p).unwrap() - other.position(p).unwrap()).norm();
                assert!(distance < 1e-11, "{distance} at {q} from {start}");
            }
        }
    }
}
