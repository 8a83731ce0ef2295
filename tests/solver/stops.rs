//! Stops, compared with the law of cosines and checked over whole motions.

use krank::scene::{Scene, presets};
use krank::solver::{Condition, Fault, Order, Range, Solver, State};
use krank::{
    Body, Defect, Double, Driver, Input, Limit, LimitOf, LinkId, Mechanism, SlideId, Vec2,
};
use proptest::prelude::*;

/// Crank 100, rod 300, no offset; the slide is named `rod`.
const SLIDER_CRANK: &str = r#"
unit = "mm"
[ground]
A = [0, 0]
[driver]
link = "r2"
angle = 60
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300 }
[slides]
rod = { point = "C", on = "ground", through = "A", angle = 0 }
[start]
C = [350, 0]
"#;

/// A crank-rocker, opened at 60 deg.
const FOUR_BAR: &str = r#"
unit = "mm"
[ground]
A = [0, 0]
D = [400, 0]
[driver]
link = "r2"
angle = 60
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300 }
r4 = { from = "C", to = "D", length = 250 }
[start]
C = [310, 230]
"#;

fn preset(name: &str) -> &'static str {
    presets::find(name).unwrap().text
}

fn open(text: &str) -> Result<Solver, Fault> {
    let scene = Scene::parse(text, "test").unwrap();
    Solver::new(&scene.mechanism)
}

/// Opens a scene with stops.
fn stopped(text: &str, limits: &str) -> Solver {
    open(&format!("{text}\n[limits]\n{limits}\n")).unwrap()
}

fn ends(solver: &Solver) -> (f64, f64) {
    let Range::Limited { low, high } = solver.motion().range else {
        panic!("it turns fully");
    };
    (low, high)
}

fn stops_at(solver: &Solver) -> Vec<f64> {
    solver.motion().stops.iter().map(|stop| stop.at).collect()
}

fn condition(solver: &Solver, at: f64) -> Condition {
    let mut state = solver.state();
    solver.solve(at, Order::Acceleration, &mut state)
}

/// Returns the values of the limits in a state, angles shifted by whole turns to be nearest to the
/// limit.
fn values(mechanism: &Mechanism, state: &State) -> Vec<f64> {
    let near = |value: f64, limit: &Limit| {
        let middle = 0.5 * (limit.low + limit.high);
        value + 360.0 * ((middle - value) / 360.0).round()
    };
    let value = |limit: &Limit| match limit.of {
        LimitOf::Driver | LimitOf::Table(_) => state.at(),
        LimitOf::Slide(slide) => state.travel(slide).unwrap().position,
        LimitOf::Angle { link, from } => {
            let from = match from {
                Body::Ground => 0.0,
                Body::Link(from) => state.angle(from).unwrap(),
            };
            near(state.angle(link).unwrap() - from, limit)
        }
    };
    mechanism.limits().iter().map(value).collect()
}

/// Checks that every limit holds inside the range. At a stop, its own limit must hold with equality
/// and rates must exist; next to it outside, there must be no assembly.
fn assert_holds(solver: &Solver, slack: f64) {
    let mechanism = solver.mechanism();
    let (low, high) = ends(solver);
    let mut state = solver.state();
    for k in 0..=2000 {
        let at = (low + (high - low) * f64::from(k) / 2000.0).min(high);
        let found = solver.solve(at, Order::Acceleration, &mut state);
        assert_ne!(found, Condition::NoAssembly, "at {at}");
        for (value, limit) in values(mechanism, &state).iter().zip(mechanism.limits()) {
            let size = slack * limit.low.abs().max(limit.high.abs()).max(1.0);
            let holds = limit.low - size <= *value && *value <= limit.high + size;
            assert!(holds, "{value} of {limit:?} at {at}");
        }
    }
    for stop in &solver.motion().stops {
        let found = solver.solve(stop.at, Order::Acceleration, &mut state);
        if !solver.motion().dead_points.contains(&stop.at) {
            assert_eq!(found, Condition::Ok, "at {stop:?}");
        }
        let limit = mechanism.limit(stop.limit);
        let value = values(mechanism, &state)[stop.limit.index()];
        let off = (value - limit.low).abs().min((value - limit.high).abs());
        let size = slack * limit.low.abs().max(limit.high.abs()).max(1.0);
        let is_driver = limit.of == LimitOf::Driver;
        assert!(is_driver || off <= size, "{value} at {stop:?}");
        let outside = match stop.at == low {
            true => stop.at.next_down(),
            false => stop.at.next_up(),
        };
        assert_eq!(condition(solver, outside), Condition::NoAssembly);
    }
}

// ---- single stops, by formulas

/// cos(theta) = (r2^2 + s^2 - r3^2) / (2 r2 s), to 40 digits and rounded once.
#[test]
fn slide_limit_stops_crank_at_nearest_double() {
    let solver = stopped(SLIDER_CRANK, "rod = [250, 380]");
    assert_eq!(ends(&solver), (32.07341239210894, 110.48731511472266));
    assert_eq!(stops_at(&solver), [32.07341239210894, 110.48731511472266]);
    assert!(solver.motion().dead_points.is_empty());
    assert_holds(&solver, 1e-14);
}

/// The diagonal BD follows from the angle between coupler and rocker, and the crank from the
/// diagonal.
#[test]
fn angle_between_two_links_ends_motion() {
    let limit = "elbow = { link = \"r4\", from = \"r3\", angle = [-110, -60] }";
    let solver = stopped(FOUR_BAR, limit);
    assert_eq!(ends(&solver), (30.679176173374955, 135.95137432591568));
    assert_holds(&solver, 1e-14);
    // Measured from the other link, the angle has the opposite sign; shifted by a whole turn, it is
    // equivalent.
    for limit in [
        "elbow = { link = \"r3\", from = \"r4\", angle = [60, 110] }",
        "elbow = { link = \"r4\", from = \"r3\", angle = [250, 300] }",
        "elbow = { link = \"r4\", from = \"r3\", angle = [-470, -420] }",
    ] {
        assert_eq!(ends(&stopped(FOUR_BAR, limit)), ends(&solver), "{limit}");
    }
}

/// The cylinder's length from its pin on the machine to its eye, with the boom at 0 and at 45 deg.
#[test]
fn boom_limit_stops_cylinder() {
    let solver = stopped(preset("excavator-boom"), "boom = [0, 45]");
    let place = |degrees: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let (x, y) = (2.3 * cosine - 0.45 * sine, 2.3 * sine + 0.45 * cosine);
        (x - 0.6).hypot(y + 0.35)
    };
    let (low, high) = ends(&solver);
    assert!((low - place(0.0)).abs() < 1e-15 && (high - place(45.0)).abs() < 1e-15);
    assert_holds(&solver, 1e-14);
    let own = stopped(preset("excavator-boom"), "rod = [1.7, 2.5]");
    assert_eq!(ends(&own), (1.7, 2.5));
    assert!(own.motion().dead_points.is_empty());
}

/// The first of several stops counts, in any order of the limits.
#[test]
fn first_stop_ends_motion() {
    let text = SLIDER_CRANK.replace("angle = 60\n", "angle = 60\nrange = [40, 200]\n");
    let solver = stopped(&text, "rod = [250, 380]\nr3 = [300, 400]");
    assert_eq!(ends(&solver), (40.0, 110.48731511472266));
    let names: Vec<usize> = solver
        .motion()
        .stops
        .iter()
        .map(|s| s.limit.index())
        .collect();
    assert_eq!(names, [0, 1]);
}

#[test]
fn driver_range_limits_motion() {
    let with = |angle: &str, range: &str| {
        let text = FOUR_BAR.replace("angle = 60", &format!("angle = {angle}\nrange = {range}"));
        ends(&open(&text).unwrap())
    };
    assert_eq!(with("60", "[10, 200]"), (10.0, 200.0));
    assert_eq!(with("400", "[10, 200]"), (370.0, 560.0));
    assert_eq!(with("-300", "[10, 200]"), (-350.0, -160.0));
    assert_eq!(with("60", "[-360, 720]"), (-360.0, 720.0));
    // A limit named after the driven link applies to the driver.
    assert_eq!(ends(&stopped(FOUR_BAR, "r2 = [0.1, 150.3]")), (0.1, 150.3));
}

/// A crank that swings between dead points at -82.8 and 82.8 deg.
#[test]
fn dead_point_before_stop_remains_end() {
    let text = FOUR_BAR
        .replace("D = [400, 0]", "D = [100, 0]")
        .replace("length = 100", "length = 60")
        .replace("length = 300", "length = 50")
        .replace("length = 250", "length = 60")
        .replace("C = [310, 230]", "C = [75, 55]");
    let complete = open(&text).unwrap();
    let (low, high) = ends(&complete);
    let wider = text.replace("angle = 60", "angle = 60\nrange = [-100, 100]");
    let wider = open(&wider).unwrap();
    assert_eq!((ends(&wider), stops_at(&wider)), ((low, high), vec![]));
    assert_eq!(wider.motion().dead_points, [low, high]);
    let half = text.replace("angle = 60", "angle = 60\nrange = [-100, 80]");
    let half = open(&half).unwrap();
    assert_eq!((ends(&half), stops_at(&half)), ((low, 80.0), vec![80.0]));
    assert_eq!(half.motion().dead_points, [low]);
    assert_eq!(condition(&half, low), Condition::DeadPoint);
    assert_eq!(condition(&half, 80.0), Condition::Ok);
    // A stop at the dead point itself is both.
    let both = text.replace("angle = 60", &format!("angle = 60\nrange = [-100, {high}]"));
    let both = open(&both).unwrap();
    assert_eq!((ends(&both), stops_at(&both)), ((low, high), vec![high]));
    assert_eq!(condition(&both, high), Condition::DeadPoint);
}

#[test]
fn touched_limit_is_no_stop_but_narrow_violation_is() {
    // Rod and crank are collinear: 400.
    let touched = stopped(SLIDER_CRANK, "rod = [200, 400]");
    assert_eq!(touched.motion().range, Range::Full { period: 360.0 });
    assert!(touched.motion().stops.is_empty());
    // 0.014 deg wide, between two samples of the tracking.
    let text = SLIDER_CRANK.replace("angle = 60", "angle = 60.5");
    let solver = stopped(&text, "rod = [100, 399.999999]");
    let (low, high) = ends(&solver);
    // Near zero, doubles of the coordinate are this fine.
    assert!((low - 0.007_017_271_218_412_742).abs() < 1e-17, "{low}");
    assert!(
        (high - (360.0 - 0.007_017_271_218_412_742)).abs() < 1e-13,
        "{high}"
    );
    assert_holds(&solver, 1e-14);
}

/// 30, 40, 50: the slide is exactly at 40 where the crank is upright.
#[test]
fn scene_can_open_at_its_stop() {
    let text = SLIDER_CRANK
        .replace("angle = 60", "angle = 90")
        .replace("length = 100", "length = 30")
        .replace("length = 300", "length = 50")
        .replace("[350, 0]", "[40, 0]");
    let solver = stopped(&text, "rod = [40, 90]");
    assert_eq!(ends(&solver), (-90.0, 90.0));
    assert_holds(&solver, 1e-14);
    let range = text.replace("angle = 90", "angle = 90\nrange = [90, 120]");
    assert_eq!(ends(&open(&range).unwrap()), (90.0, 120.0));
}

#[test]
fn scene_beyond_its_stop_does_not_open() {
    let opened = |text: &str, limits: &str| open(&format!("{text}\n[limits]\n{limits}\n"));
    let Err(Fault::BeyondStop { limit, value }) = opened(SLIDER_CRANK, "rod = [100, 300]") else {
        panic!("it opens");
    };
    // 50 + sqrt(300^2 - (100 sin 60)^2).
    let expected = 50.0 + (90_000.0_f64 - 7_500.0).sqrt();
    assert!(
        limit.index() == 0 && (value - expected).abs() < 1e-12,
        "{value}"
    );
    let range = FOUR_BAR.replace("angle = 60", "angle = 60\nrange = [70, 200]");
    let fault = open(&range).unwrap_err();
    assert!(
        matches!(fault, Fault::BeyondStop { value: 60.0, .. }),
        "{fault:?}"
    );
    // The other assembly is on the other side of the stop.
    let scene = Scene::parse(&format!("{FOUR_BAR}\n[limits]\nr4 = [230, 300]\n"), "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let group = solver.plan().numbered().map(|(id, _)| id).nth(1).unwrap();
    let other = solver.switched(60.0, group, krank::solver::AssemblyChoice::Minus);
    assert!(matches!(other, Err(Fault::BeyondStop { .. })), "{other:?}");
}

// ---- along periods and change points

/// The follower of a drag link turns fully: a limit that spans most of a turn stops it in the same
/// turn.
#[test]
fn fully_turning_link_is_stopped_within_its_turn() {
    let text = FOUR_BAR
        .replace("D = [400, 0]", "D = [100, 0]")
        .replace("length = 100", "length = 200")
        .replace("[310, 230]", "[-50, 150]");
    let complete = open(&text).unwrap();
    assert_eq!(complete.motion().range, Range::Full { period: 360.0 });
    let solver = stopped(&text, "r4 = [190, 540]");
    let (low, high) = ends(&solver);
    assert!(high - low > 180.0 && high - low < 360.0, "{low} {high}");
    assert_holds(&solver, 1e-13);
}

/// The kite repeats after two turns; its change points are at 0 and 360.
#[test]
fn range_of_kite_has_its_change_points() {
    let text = preset("kite");
    let complete = open(text).unwrap();
    let with = |range: &str| {
        open(&text.replace("angle = 90", &format!("angle = 90\nrange = {range}"))).unwrap()
    };
    assert!(with("[10, 350]").motion().change_points.is_empty());
    assert_eq!(with("[10, 500]").motion().change_points, [360.0]);
    assert_eq!(
        with("[-900, 500]").motion().change_points,
        [-720.0, -360.0, 0.0, 360.0]
    );
    // On any turn, the states equal those without stops bit for bit.
    let solver = with("[-900, 500]");
    let (mut own, mut other) = (solver.state(), complete.state());
    for at in [
        -900.0, -360.0, -359.9, 0.0, 1e-9, 123.4, 360.0, 371.0, 500.0,
    ] {
        let found = solver.solve(at, Order::Acceleration, &mut own);
        assert_eq!(
            found,
            complete.solve(at, Order::Acceleration, &mut other),
            "{at}"
        );
        assert_eq!(*own, *other, "{at}");
    }
    assert_eq!(condition(&solver, 500.000_000_1), Condition::NoAssembly);
    // A stop beyond a change point, on the second turn.
    let solver = stopped(text, "r3 = [-60, 200]");
    assert_holds(&solver, 1e-12);
}

/// States next to stops do not depend on the order in which they are solved either.
#[test]
fn states_near_stops_do_not_depend_on_order() {
    for (text, limits) in [
        (SLIDER_CRANK, "rod = [250, 380]"),
        (preset("kite"), "r3 = [-60, 200]"),
        (preset("stephenson-six-bar"), "r4 = [-5, 8]"),
    ] {
        let solver = stopped(text, limits);
        let (low, high) = ends(&solver);
        let coordinates: Vec<f64> = (0..=60)
            .map(|k| (low + (high - low) * f64::from(k) / 60.0).min(high))
            .collect();
        let fresh = |at: f64| {
            let mut state = solver.state();
            let _ = solver.solve(at, Order::Acceleration, &mut state);
            state.into_state()
        };
        let mut state = solver.state();
        for k in 0..coordinates.len() {
            let at = coordinates[(k * 37 + 11) % coordinates.len()];
            let _ = solver.solve(at, Order::Acceleration, &mut state);
            assert_eq!(*state, fresh(at), "{at}");
        }
        assert_eq!(ends(&stopped(text, limits)), (low, high));
    }
}

// ---- every kind of group

#[test]
fn every_kind_of_group_respects_its_stops() {
    for (name, limits, slack) in [
        ("stephenson-six-bar", "r4 = [-5, 8]", 1e-12),
        (
            "stephenson-six-bar",
            "knee = { link = \"r5\", from = \"r4\", angle = [62, 100] }",
            1e-12,
        ),
        ("excavator-boom", "boom = [-10, 40]", 1e-13),
        ("slider-crank", "r4 = [15, 29]", 1e-13),
        ("slotted-lever", "r3 = [100, 166]", 1e-13),
        ("slotted-lever", "r4 = [70, 100]", 1e-13),
        ("scotch-yoke", "r4 = [-20, 40]", 1e-13),
        ("whitworth", "r6 = [-230, -150]", 1e-13),
        ("peaucellier", "r4 = [-20, 40]", 1e-12),
    ] {
        let solver = stopped(preset(name), limits);
        assert_holds(&solver, slack);
    }
}

/// In double-double, the end of the limit is between the neighbouring doubles of a stop, and the
/// stop is the nearest double.
#[test]
fn stop_behind_coupled_group_is_nearest_double() {
    let plain = open(preset("stephenson-six-bar")).unwrap();
    for limit in [[-5.0, 8.0], [-4.3, 7.7], [-3.7, 7.9], [-2.2, 7.6]] {
        let [low, high] = limit;
        let solver = stopped(
            preset("stephenson-six-bar"),
            &format!("r4 = [{low:?}, {high:?}]"),
        );
        assert_eq!(solver.motion().stops.len(), 2);
        let of = solver.mechanism().limits()[0].of;
        let LimitOf::Angle { link, .. } = of else {
            panic!("it is an angle");
        };
        let (mut state, mut twice) = (plain.state(), plain.twice());
        for stop in &solver.motion().stops {
            // The typed decimal in double-double.
            let tenths = |end: f64| Double::exactly((10.0 * end).round()) / Double::exactly(10.0);
            let off = |at: f64| {
                let _ = plain.solve(at, Order::Position, &mut state);
                assert!(plain.solve_twice(&state, Order::Position, &mut twice));
                let angle = twice.angle(link).unwrap();
                let ends = [low, high].map(|end| {
                    let off = angle - tenths(end);
                    let turns = Double::exactly(360.0 * (off.hi / 360.0).round());
                    (off - turns).hi
                });
                if ends[0].abs() < ends[1].abs() {
                    ends[0]
                } else {
                    ends[1]
                }
            };
            let [before, here, after] = [stop.at.next_down(), stop.at, stop.at.next_up()].map(off);
            assert!(before * after < 0.0, "{before:e} {here:e} {after:e}");
            assert!(
                here.abs() <= before.abs().min(after.abs()),
                "{before:e} {here:e} {after:e}"
            );
        }
    }
}

// ---- through the library

#[test]
fn invalid_limits_are_rejected() {
    let built = |of: fn(LinkId, SlideId) -> LimitOf, low: f64, high: f64| {
        let mut builder = Mechanism::builder();
        let a = builder.ground_point(0.0, 0.0);
        let [b, c] = [builder.moving_point(), builder.moving_point()];
        let crank = builder.link(a, b, 1.0);
        builder.link(b, c, 3.0);
        let slide = builder.pin_in_slot(c, Body::Ground, Vec2::ZERO, 0.0);
        builder.start(c, Vec2::new(3.0, 0.0));
        builder.driver(Driver {
            input: Input::Turn(crank),
            start: 30.0,
            speed: 1.0,
            acceleration: 0.0,
        });
        let limit = builder.limit(Limit {
            of: of(crank, slide),
            low,
            high,
        });
        let defects = builder.build().err();
        defects.map(|found| found.list() == [Defect::Limit { limit }])
    };
    let slide = |_, slide| LimitOf::Slide(slide);
    assert_eq!(built(slide, 2.0, 3.9), None);
    for (low, high) in [
        (2.0, 2.0),
        (3.0, 2.0),
        (f64::NAN, 3.0),
        (2.0, f64::INFINITY),
    ] {
        assert_eq!(built(slide, low, high), Some(true), "{low} {high}");
    }
    let angle = |link, _| LimitOf::Angle {
        link,
        from: Body::Ground,
    };
    assert_eq!(built(angle, 0.0, 359.0), None);
    assert_eq!(built(angle, 0.0, 360.0), Some(true));
    let itself = |link, _| LimitOf::Angle {
        link,
        from: Body::Link(link),
    };
    assert_eq!(built(itself, -1.0, 1.0), Some(true));
    let driver = |_, _| LimitOf::Driver;
    assert_eq!(built(driver, 0.0, 3600.0), None);
    assert_eq!(built(driver, 0.0, 1e9), Some(true));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Random four-bars that open at right angles or better, with random stops of coupler and
    /// rocker.
    #[test]
    fn random_four_bars_respect_their_stops(
        crank in 30.0..180.0_f64,
        coupler in 200.0..400.0_f64,
        rocker in 200.0..400.0_f64,
        below in 2.0..80.0_f64,
        above in 2.0..80.0_f64,
        is_rocker in any::<bool>(),
    ) {
        let text = FOUR_BAR
            .replace("length = 100 }", &format!("length = {crank} }}"))
            .replace("length = 300 }", &format!("length = {coupler} }}"))
            .replace("length = 250 }", &format!("length = {rocker} }}"));
        let Ok(complete) = open(&text) else { return Ok(()) };
        let scene = Scene::parse(&text, "test").unwrap();
        let link = scene.mechanism.link_ids().nth(if is_rocker { 2 } else { 1 }).unwrap();
        let mut state = complete.state();
        let _ = complete.solve(60.0, Order::Position, &mut state);
        let angle = state.angle(link).unwrap();
        let name = if is_rocker { "r4" } else { "r3" };
        let limit = format!("{name} = [{}, {}]", angle - below, angle + above);
        let solver = stopped(&text, &limit);
        if matches!(solver.motion().range, Range::Limited { .. }) {
            assert_holds(&solver, 1e-9);
        } else {
            prop_assert_eq!(solver.motion().range, complete.motion().range);
        }
        // The range between the stops is complete: beyond them the whole motion violates the limit.
        let (mut inside, mut k) = (true, 0);
        let (low, high) = solver.motion().range.ends();
        while inside && k < 3600 {
            k += 1;
            let at = 60.0 + 0.1 * f64::from(k);
            if complete.solve(at, Order::Position, &mut state) == Condition::NoAssembly {
                break;
            }
            let value = values(solver.mechanism(), &state)[0];
            inside = angle - below <= value && value <= angle + above;
            prop_assert!(!inside || solver.motion().stops.is_empty() || at <= high + 1e-9 || at < low);
        }
    }
}
