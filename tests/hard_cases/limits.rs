//! Ends of the motion: dead points of a dyad, of a slide and of a coupled group.

use crate::exact::{DoubleDouble, PI};
use crate::rig::{U, assert_near, condition, exact, note, push, solved, turn};
use krank::scene::Scene;
use krank::solver::{Condition, Order, Range, Solver, State};
use krank::{Body, LinkId, Mechanism, PointId, SlideId, Vec2};

fn limits(solver: &Solver) -> (f64, f64) {
    match solver.motion().range {
        Range::Limited { low, high } => (low, high),
        full @ Range::Full { .. } => panic!("{full:?}"),
    }
}

/// The lecture's four-bar driven at its rocker, from D to C; the crank AB follows.
struct BackwardPass {
    solver: Solver,
    crank: LinkId,
    coupler: LinkId,
}

impl BackwardPass {
    /// Opens at 120 degrees with B near the given position.
    fn open(near: Vec2) -> BackwardPass {
        let mut builder = Mechanism::builder();
        let (a, d) = (
            builder.ground_point(0.0, 0.0),
            builder.ground_point(400.0, 0.0),
        );
        let (b, c) = (builder.moving_point(), builder.moving_point());
        let crank = builder.link(a, b, 100.0);
        let coupler = builder.link(b, c, 300.0);
        let rocker = builder.link(d, c, 250.0);
        builder.driver(turn(rocker, 120.0));
        builder.start(b, near);
        let mechanism = builder.build().expect("every element is sound");
        let solver = Solver::new(&mechanism).expect("it closes");
        BackwardPass {
            solver,
            crank,
            coupler,
        }
    }

    fn sin_mu(&self, state: &State) -> f64 {
        state
            .direction(self.crank)
            .unwrap()
            .cross(state.direction(self.coupler).unwrap())
    }
}

/// Rocker angles at which A, B and C are collinear, in degrees.
const LIMITS: [&str; 2] = ["108.2099568642830112137", "155.853152003497613375"];

/// The two assemblies: the crank is before or after its dead point.
const BEFORE: Vec2 = Vec2::new(100.0, -20.0);
const AFTER: Vec2 = Vec2::new(-20.0, 90.0);

#[test]
fn h04_driven_rocker_stops_at_exact_dead_points() {
    for near in [BEFORE, AFTER] {
        let solver = BackwardPass::open(near).solver;
        let (low, high) = limits(&solver);
        for (found, decimal) in [(low, LIMITS[0]), (high, LIMITS[1])] {
            let off = exact(decimal).minus(found).abs();
            note(&format!("H04: limit {found} off by {off:e} deg"));
            // The double nearest to the limit.
            assert_near("limit", found, decimal, 0.5 * (found.next_up() - found));
        }
        for beyond in [low - 1e-11, high + 1e-11, 0.0, 480.0, -240.0] {
            assert_eq!(
                condition(&solver, beyond),
                Condition::NoAssembly,
                "{beyond}"
            );
        }
        for (at, expected) in [
            (low.next_down(), Condition::NoAssembly),
            (low, Condition::DeadPoint),
            (low.next_up(), Condition::Ok),
            (high.next_down(), Condition::Ok),
            (high, Condition::DeadPoint),
            (high.next_up(), Condition::NoAssembly),
        ] {
            assert_eq!(condition(&solver, at), expected, "{at}");
        }
    }
}

#[test]
fn h04_all_states_keep_their_branch() {
    for near in [BEFORE, AFTER] {
        let backwards = BackwardPass::open(near);
        let (low, high) = limits(&backwards.solver);
        let start = solved(&backwards.solver, 120.0);
        let side = backwards.sin_mu(&start).signum();
        for k in 1..1000 {
            let at = low + (high - low) * f64::from(k) / 1000.0;
            let state = solved(&backwards.solver, at);
            assert!(side * backwards.sin_mu(&state) > 0.0, "at {at}");
            assert!(state.omega(backwards.crank).unwrap().is_finite());
        }
    }
}

/// Near its dead point, the crank moves with the square root of the rocker's displacement.
#[test]
fn h04_crank_leaves_dead_point_as_square_root() {
    let backwards = BackwardPass::open(BEFORE);
    let radian = PI / DoubleDouble::from(180.0);
    let limit = exact(LIMITS[0]) * radian;
    let dead = exact("36.41991372856602242746") * radian;
    // K = (theta2 - theta2*) / sqrt(theta4 - limit) at a distance in rad; the distances 1e-20 and
    // 1e-28 of the case are finer than doubles of degrees.
    for (distance, k) in [
        (1e-2, "-1.873976249806765060702"),
        (1e-6, "-1.887182188972389759146"),
        (1e-12, "-1.887376714182622062243"),
    ] {
        let at = ((limit + DoubleDouble::from(distance)) / radian).hi;
        let way = (DoubleDouble::from(at) * radian - limit).minus(0.0);
        let state = solved(&backwards.solver, at);
        // The double nearest to the distance differs from it: K changes by 0.2 sqrt(way).
        let nearby = 0.2 * (way.sqrt() - distance.sqrt()).abs();
        let theta2 = dead.minus(state.direction(backwards.crank).unwrap().angle());
        let slack = 3.6 * U * 4.0 / backwards.sin_mu(&state).abs() + 2.0 * U;
        let off = (exact(k).minus(-theta2 / way.sqrt())).abs();
        note(&format!("H04: K at {distance:e} off by {off:e}"));
        assert!(
            off <= slack / way.sqrt() + nearby,
            "K at {distance:e}: {off:e}"
        );
    }
}

/// Two links of length 1 from the origin to a ram that moves along y.
struct Toggle {
    crank: LinkId,
    knuckle: PointId,
    ram: PointId,
    slide: SlideId,
    builder: krank::Builder,
}

impl Toggle {
    fn new() -> Toggle {
        let mut builder = Mechanism::builder();
        let origin = builder.ground_point(0.0, 0.0);
        let (knuckle, ram) = (builder.moving_point(), builder.moving_point());
        let crank = builder.link(origin, knuckle, 1.0);
        builder.link(knuckle, ram, 1.0);
        let slide = builder.pin_in_slot(ram, Body::Ground, Vec2::ZERO, 90.0);
        Toggle {
            crank,
            knuckle,
            ram,
            slide,
            builder,
        }
    }

    fn open(self) -> Solver {
        let mechanism = self.builder.build().expect("every element is sound");
        Solver::new(&mechanism).expect("it closes")
    }

    /// Opens a toggle driven at the ram, which starts at `y` with the knuckle on one side.
    fn pushed(y: f64, side: f64) -> (Solver, LinkId, PointId) {
        let mut toggle = Toggle::new();
        let (crank, knuckle) = (toggle.crank, toggle.knuckle);
        toggle.builder.driver(push(toggle.slide, y));
        toggle.builder.start(knuckle, Vec2::new(side, 0.5 * y));
        (toggle.open(), crank, knuckle)
    }
}

#[test]
fn h06_toggle_press_at_full_extension_has_exact_rates() {
    let mut toggle = Toggle::new();
    // The angle p of the case counts clockwise from y.
    toggle.builder.driver(turn(toggle.crank, 100.0));
    toggle.builder.start(toggle.ram, Vec2::new(0.0, 2.0));
    let (knuckle, slide) = (toggle.knuckle, toggle.slide);
    let solver = toggle.open();
    let top = solved(&solver, 90.0);
    let travel = top.travel(slide).unwrap();
    assert_eq!(
        (travel.position, travel.rate, travel.accel),
        (2.0, Some(0.0), Some(-2.0))
    );
    assert_eq!(top.position(knuckle).unwrap(), Vec2::new(0.0, 1.0));
    for p in -10..=10_i32 {
        let state = solved(&solver, f64::from(90 - p));
        let y = state.travel(slide).unwrap().position;
        let arm = state.position(knuckle).unwrap();
        assert!((y - 2.0 * arm.y).abs() <= 4.0 * U * 2.0, "y at {p}: {y}");
        assert_eq!(arm.x.partial_cmp(&0.0), p.partial_cmp(&0), "knuckle at {p}");
    }
}

#[test]
fn h06_toggle_press_driven_by_ram_is_accurate_near_limit() {
    // At 2 - 2^-51, doubles cannot distinguish it from the limit; double-double numbers can.
    for (power, p) in [
        (-4, "0.2506556623361307937491"),
        (-20, "0.0009765625388051114389819"),
        (-49, "4.214684851089403490646241e-8"),
        (-51, "2.107342425544701628342e-8"),
    ] {
        for side in [1.0, -1.0] {
            let (solver, crank, _) = Toggle::pushed(1.5, side);
            let state = solved(&solver, 2.0 - 2.0_f64.powi(power));
            let direction = state.direction(crank).unwrap();
            let found = side * direction.x.atan2(direction.y);
            assert_near("p", found, p, 4.0 * U * exact(p).hi);
        }
    }
}

#[test]
fn h06_toggle_press_ends_where_links_are_straight() {
    for start in [1.5, 1.3, 0.7, 1.999] {
        let (solver, _, knuckle) = Toggle::pushed(start, 1.0);
        let high = limits(&solver).1;
        note(&format!(
            "H06: limit from {start} off by {} u",
            (high - 2.0) / U
        ));
        assert_eq!(high, 2.0);
        for beyond in [2.0 + 1e-11, 3.0] {
            assert_eq!(
                condition(&solver, beyond),
                Condition::NoAssembly,
                "{beyond}"
            );
        }
        let mut state = solver.state();
        assert_eq!(
            solver.solve(2.0, Order::Position, &mut state),
            Condition::DeadPoint
        );
        assert_eq!(state.position(knuckle).unwrap(), Vec2::new(0.0, 1.0));
        for beyond in [high.next_up(), 2.0 + 8.0 * f64::EPSILON] {
            assert_eq!(condition(&solver, beyond), Condition::NoAssembly);
        }
    }
}

/// The printed value of a limit in `check` means the limit itself.
#[test]
fn limit_typed_with_twelve_decimals_means_limit() {
    let typed = |limit: f64| -> [f64; 2] {
        let read = |text: String| text.parse::<f64>().expect("a number");
        let printed = read(format!("{limit:.12}"));
        // A user may also truncate the value.
        let outwards = if printed < limit { -5e-13 } else { 5e-13 };
        [printed, limit + outwards]
    };
    let scene = Scene::parse(STEPHENSON, "stephenson").expect("a sound scene");
    let coupled = Solver::new(&scene.mechanism).expect("it closes");
    let pushed = Toggle::pushed(1.5, 1.0).0;
    for solver in [BackwardPass::open(BEFORE).solver, coupled, pushed] {
        for &limit in &solver.motion().dead_points {
            let is_low = limit == limits(&solver).0;
            for at in typed(limit) {
                let is_beyond = (at < limit) == is_low;
                let range = solver.motion().range;
                match range.equivalent_in_range(at, true) {
                    Some(intended) => assert!(
                        is_beyond && intended == limit,
                        "{limit} as {at}: {intended}"
                    ),
                    None => assert!(!is_beyond || at == limit, "{limit} as {at}"),
                }
            }
        }
    }
}

#[test]
fn coordinate_outside_range_is_shifted_by_whole_turns() {
    let range = Range::Limited {
        low: 414.8,
        high: 642.8,
    };
    for (at, intended) in [
        (100.0, Some(460.0)),
        (-620.0, Some(460.0)),
        (282.0, Some(642.0)),
        (500.0, None),
        (300.0, None),
        (f64::NAN, None),
        (1e300, None),
    ] {
        assert_eq!(range.equivalent_in_range(at, true), intended, "{at}");
        assert_eq!(range.equivalent_in_range(at, false), None, "{at}");
    }
    // Two such coordinates are ambiguous.
    let (low, high) = (0.0, 500.0);
    let longer = Range::Limited { low, high };
    assert_eq!(longer.equivalent_in_range(-300.0, true), None);
    assert_eq!(longer.equivalent_in_range(-200.0, true), Some(160.0));
    assert_eq!(
        Range::Full { period: 720.0 }.equivalent_in_range(1000.0, true),
        None
    );
}

/// Stephenson III driven where its loops are coupled, with a crank that does not turn fully.
const STEPHENSON: &str = r#"
unit = "mm"

[ground]
A = [0, 0]
D = [300, 0]
G = [280, 300]

[driver]
link = "2"
angle = 60
speed = "10 rad/s"

[links]
2 = { from = "G", to = "F", length = 90 }
3 = { from = "F", to = "E", length = 230 }
4 = { from = "B", to = "C", length = 200, points = { E = [90, 100] } }
5 = { from = "A", to = "B", length = 150 }
6 = { from = "D", to = "C", length = 180 }

[start]
B = [20, 150]
C = [230, 170]
E = [120, 260]
"#;

#[test]
fn h18_coupled_triad_stops_at_dead_points() {
    let scene = Scene::parse(STEPHENSON, "stephenson").expect("a sound scene");
    let solver = Solver::new(&scene.mechanism).expect("it closes");
    let mut points = scene.mechanism.point_ids();
    let e = points
        .find(|&p| scene.point_name(p) == Some("E"))
        .expect("E");
    for (at, x, y, cond) in [
        (
            60.0,
            "133.0158062345832856161",
            "251.2849954164567418503",
            38.66,
        ),
        (
            90.0,
            "95.93144581870992019686",
            "252.0914529058859300778",
            19.64,
        ),
    ] {
        let state = solved(&solver, at);
        // As measured for the triad of the references: 4.1 u of the longest link at a condition
        // number of 23.5.
        let slack = 4.1 * cond / 23.5 * U * 300.0;
        assert_near("E.x", state.position(e).unwrap().x, x, slack);
        assert_near("E.y", state.position(e).unwrap().y, y, slack);
    }
    let (low, high) = limits(&solver);
    for (name, found, decimal) in [
        ("lower", low, "47.937702396774274189"),
        ("upper", high, "322.49726942233316812"),
    ] {
        let off = -exact(decimal).minus(found);
        note(&format!("H18: {name} limit {found} off by {off:e} deg"));
        // The nearest double, or its neighbour.
        assert!(
            off.abs() <= found.next_up() - found,
            "{name} limit {found}: {off:e}"
        );
        let mut state = solver.state();
        let condition = solver.solve(found, Order::Acceleration, &mut state);
        assert_eq!(condition, Condition::DeadPoint);
        // Positions there have all their digits, although a Newton correction near a fold has only
        // half of them.
        for link in scene.mechanism.link_ids() {
            let members = &scene.mechanism.link(link).members;
            let [p, q] =
                [&members[0], &members[1]].map(|m| (state.position(m.point).unwrap(), m.local));
            let off = (q.0 - p.0).norm() - (q.1 - p.1).norm();
            assert!(off.abs() <= 16.0 * U * 300.0, "{name} limit: {off:e}");
        }
    }
    for beyond in [low - 1e-9, high + 1e-9] {
        assert_eq!(
            condition(&solver, beyond),
            Condition::NoAssembly,
            "{beyond}"
        );
    }
}

/// In a file, the decimals count: 0.1 + 0.4 equals 0.2 + 0.3, which fails for their nearest
/// doubles.
#[test]
fn lengths_in_file_are_compared_as_typed() {
    let text = "unit = \"m\"\n[ground]\nA = [1000000, 0]\nD = [1000000.4, 0]\n\
        [driver]\nlink = \"r2\"\nangle = 60\nspeed = \"1 rad/s\"\n[links]\n\
        r2 = { from = \"A\", to = \"B\", length = 0.1 }\n\
        r3 = { from = \"B\", to = \"C\", length = 0.2 }\n\
        r4 = { from = \"C\", to = \"D\", length = 0.3 }\n\
        [start]\nC = [1000000.2, 0.2]\n";
    let scene = Scene::parse(text, "equal.toml").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    assert_eq!(solver.motion().change_points, [180.0, 540.0]);
    assert_eq!(solver.motion().tolerance, 0.0);
}

/// Opens a crank of 1 whose pin turns a slotted lever, pivoted below at a typed distance.
fn slotted_lever(distance: &str) -> (Scene, Solver) {
    let text = format!(
        "[ground]\nA = [0, 0]\nO = [0, -{distance}]\n\
         [driver]\nlink = \"r2\"\nangle = 90\n\
         [links]\nr2 = {{ from = \"A\", to = \"B\", length = 1 }}\n\
         r4 = {{ from = \"O\", to = \"T\", length = 2 }}\n\
         [slides]\ns4 = {{ point = \"B\", on = \"r4\", through = \"O\", angle = 0 }}\n\
         [start]\nT = [0, 1]\n"
    );
    let scene = Scene::parse(&text, "lever").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

/// The pin passes the lever's pivot at decreasing distances: a gap of 1.6e-7 used to count as a
/// dead point.
#[test]
fn pin_passing_close_to_pivot_keeps_moving() {
    for k in 1..=12_u32 {
        let gap = 10.0_f64.powi(-(k as i32));
        let nines = "9".repeat(k as usize);
        let zeros = "0".repeat(k as usize - 1);
        for (distance, sign) in [(format!("0.{nines}"), 1.0), (format!("1.{zeros}1"), -1.0)] {
            let (scene, solver) = slotted_lever(&distance);
            let motion = solver.motion();
            assert_eq!(motion.range, Range::Full { period: 360.0 }, "{distance}");
            let is_seen = motion
                .near_misses
                .iter()
                .any(|miss| (miss.at - 270.0).abs() < 1e-6);
            assert_eq!(is_seen, gap < 0.03, "{distance}: {:?}", motion.near_misses);
            let lever = scene.mechanism.link_ids().nth(1).unwrap();
            let mut workspace = solver.state();
            assert_eq!(
                solver.solve(270.0, Order::Velocity, &mut workspace),
                Condition::Ok
            );
            // The distance has an error of half an ulp, whose ratio to the gap grows as the gap
            // shrinks.
            let omega = workspace.state().omega(lever).unwrap();
            let off = (omega * gap * sign - 1.0).abs();
            assert!(
                off <= 4.0 * U / gap,
                "{distance}: {omega:e} is off by {off:e}"
            );
        }
    }
}

#[test]
fn lever_has_exact_rates_beyond_closest_approach() {
    let (scene, solver) = slotted_lever("0.9999999");
    let lever = scene.mechanism.link_ids().nth(1).unwrap();
    let mut workspace = solver.state();
    assert_eq!(
        solver.solve(271.0, Order::Velocity, &mut workspace),
        Condition::Ok
    );
    let direction = workspace.state().direction(lever).unwrap();
    let angle = krank::angle::degrees(direction);
    assert_near("angle", angle, "0.49967172768196444333", 1e-12);
    let omega = workspace.state().omega(lever).unwrap();
    assert_near("omega", omega, "0.50032828898486510587", 1e-12);
}
