//! Checks that every preset opens, covers the range that its geometry gives, closes everywhere, and
//! has rates that agree with differences of its positions.

use crate::support::{U, closure_error, longest_link};
use krank::Input;
use krank::scene::{Scene, presets};
use krank::solver::{Condition, GroupKind, Order, Range, Solver, State};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// The range of motion that a preset's geometry gives.
enum Reach {
    /// Full turns; the motion repeats after one turn.
    Turn,
    /// Full turns; the motion repeats after two turns.
    TurnTwice,
    /// From a lower to an upper limit, in degrees or the scene's length unit.
    Within(f64, f64),
}

struct Expected {
    name: &'static str,
    reach: Reach,
    /// The groups that solve it, without the driver; repeated groups are listed once each.
    groups: &'static [GroupKind],
}

const fn turning(name: &'static str, groups: &'static [GroupKind]) -> Expected {
    let reach = Reach::Turn;
    Expected {
        name,
        reach,
        groups,
    }
}

const fn turning_twice(name: &'static str, groups: &'static [GroupKind]) -> Expected {
    let reach = Reach::TurnTwice;
    Expected {
        name,
        reach,
        groups,
    }
}

const fn within(name: &'static str, low: f64, high: f64, groups: &'static [GroupKind]) -> Expected {
    let reach = Reach::Within(low, high);
    Expected {
        name,
        reach,
        groups,
    }
}

use GroupKind::{Coupled, Rpp, Rpr, Rrp, Rrr};

const EXPECTED: [Expected; 39] = [
    turning("four-bar", &[Rrr]),
    turning("slider-crank", &[Rrp]),
    turning("press", &[Rrr, Rrr]),
    turning("press-ram", &[Rrr, Rrp]),
    turning("four-bar-load", &[Rrr]),
    turning("engine", &[Rrp]),
    turning("offset-slider-crank", &[Rrp]),
    turning("slotted-lever", &[Rpr]),
    turning("whitworth", &[Rpr, Rrp]),
    turning("scotch-yoke", &[Rpp]),
    // Coupler and driven rocker in line: acos(4/5) and acos(-1/5).
    within(
        "double-rocker",
        36.869_897_645_844_02,
        101.536_959_032_815_49,
        &[Rrr],
    ),
    turning("drag-link", &[Rrr]),
    turning("watt-six-bar", &[Rrr, Rrr]),
    turning("stephenson-six-bar", &[Coupled { unknowns: 0 }]),
    turning("jansen-leg", &[Rrr, Rrr, Rrr]),
    turning("klann-leg", &[Rrr, Rrr]),
    // OB = 80 cos(angle / 2) down to 100 - 40: twice acos(3/4).
    within(
        "peaucellier",
        -82.819_244_218_541_73,
        82.819_244_218_541_73,
        &[Rrr, Rrr, Rrr],
    ),
    turning("hoecken", &[Rrr]),
    turning("toggle-press", &[Rrr, Rrp]),
    // Upright, where joints coincide, and flat.
    within("scissor-lift", 0.0, 2.0, &[Rrr; 10]),
    // |QP| - |QO| and |QP| + |QO|.
    within(
        "excavator-boom",
        1.648_986_129_579_103,
        3.038_230_528_524_083,
        &[Rrr],
    ),
    turning("parallelogram", &[Rrr]),
    turning("antiparallelogram", &[Rrr]),
    turning_twice("kite", &[Rrr]),
    turning("triple-parallelogram", &[Rrr]),
    turning("shaper", &[Rpr, Rrp]),
    turning("knuckle-press", &[Rrr, Rrp]),
    turning("drag-link-press", &[Rrr, Rrp]),
    turning("v-twin", &[Rrp, Rrp]),
    turning("radial-engine", &[Rrp; 5]),
    turning("wiper", &[Rrr, Rrr]),
    // The upright and the upper arm in line: acos((360^2 + AD^2 - 505^2) / 720 AD) about the
    // direction of AD.
    within("double-wishbone", -47.728_843_679_365_4, 180.0, &[Rrr]),
    // Rod and right arm in line: |BD| = 1260 + |DC|, by the law of cosines, minus the direction of
    // B on its arm.
    within(
        "ackermann",
        -33.008_615_022_460_404,
        169.405_796_049_756_8,
        &[Rrr],
    ),
    // |OP| from |OQ| - 0.4 to |OQ| + 0.4.
    within(
        "backhoe",
        0.959_448_417_557_650_4,
        1.759_448_417_557_650_5,
        &[Rrr, Rrr],
    ),
    // The arms folded, 500 - 300, and both upright, 500 + 300.
    within("lift-table", 200.0, 800.0, &[Coupled { unknowns: 0 }, Rpr]),
    // |AD|^2 = 36400. The two rods in line, |BD| = 280, at acos(-32000 / 200 |AD|) about the direction of D.
    within("five-bar", -120.0, 173.991_016_802_233_84, &[Rrr]),
    turning("robot-arm", &[]),
    // As the five-bar.
    within("plotter", -120.0, 173.991_016_802_233_84, &[Rrr]),
    // As the excavator's boom: |QP| - |QO| and |QP| + |QO|.
    within(
        "excavator",
        1.648_986_129_579_103,
        3.038_230_528_524_083,
        &[Rrr; 4],
    ),
];

/// Stops of presets, within their geometric range: the stroke of a cylinder, the travel of a wheel.
const STOPS: [(&str, f64, f64); 5] = [
    ("double-wishbone", -15.0, 15.0),
    ("ackermann", -32.0, 32.0),
    ("backhoe", 1.0, 1.65),
    ("lift-table", 250.0, 620.0),
    ("excavator", 1.7, 2.7),
];

/// Number of coordinates over the range; none of them is a limit or a multiple of 90 degrees.
const PLACES: u32 = 360;

fn folder() -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "presets"].iter().collect()
}

fn text(name: &str) -> String {
    let path = folder().join(format!("{name}.toml"));
    std::fs::read_to_string(&path).expect("a preset's file")
}

fn parsed(text: &str, name: &str) -> Scene {
    Scene::parse(text, name).unwrap_or_else(|e| panic!("{name}: {e:?}"))
}

fn open(name: &str) -> Scene {
    parsed(&text(name), name)
}

/// Opens a preset without the stops of its driver.
fn freed(name: &str) -> Scene {
    let text = text(name);
    let lines = text.lines().filter(|line| !line.starts_with("range"));
    parsed(&lines.collect::<Vec<_>>().join("\n"), name)
}

fn solver(scene: &Scene) -> Solver {
    Solver::new(&scene.mechanism).unwrap_or_else(|e| panic!("{}: {e}", scene.name))
}

/// Returns the coordinates at which a preset is checked.
fn places(range: Range) -> Vec<f64> {
    let (low, high) = match range {
        Range::Full { period } => (0.0, period),
        Range::Limited { low, high } => (low, high),
    };
    let place = |k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(PLACES);
    (0..PLACES).map(place).collect()
}

#[test]
fn folder_program_and_expectations_list_the_same_presets() {
    let files: BTreeSet<String> = std::fs::read_dir(folder())
        .expect("the folder")
        .map(|entry| entry.expect("an entry").path())
        // The folder of tasks is next to the scenes.
        .filter(|path| path.is_file())
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into())
        .collect();
    let built_in: BTreeSet<String> = presets::all().iter().map(|p| p.name.into()).collect();
    let expected: BTreeSet<String> = EXPECTED.iter().map(|e| e.name.into()).collect();
    assert_eq!(files, expected);
    assert_eq!(built_in, expected);
}

#[test]
fn every_preset_has_a_source_a_note_and_a_title() {
    for Expected { name, .. } in &EXPECTED {
        let scene = open(name);
        let message = |text: &Option<String>| text.as_ref().is_some_and(|t| t.len() > 20);
        assert!(message(&scene.source), "{name} has no source");
        assert!(message(&scene.note), "{name} has no note");
        assert!(scene.name != *name, "{name} has no title");
        let ascii = [&scene.source, &scene.note].into_iter().flatten();
        assert!(
            ascii.chain([&scene.name]).all(|text| text.is_ascii()),
            "{name} must read well on any terminal"
        );
    }
}

#[test]
fn every_preset_covers_its_geometric_range() {
    for Expected { name, reach, .. } in &EXPECTED {
        let scene = freed(name);
        match (reach, solver(&scene).motion().range) {
            (Reach::Turn, Range::Full { period }) => assert_eq!(period, 360.0, "{name}"),
            (Reach::TurnTwice, Range::Full { period }) => assert_eq!(period, 720.0, "{name}"),
            (Reach::Within(low, high), Range::Limited { low: l, high: h }) => {
                let near = |a: f64, b: f64| (a - b).abs() <= 1e-13 * high.abs();
                assert!(near(*low, l) && near(*high, h), "{name}: {l} to {h}");
            }
            (_, other) => panic!("{name}: {other:?}"),
        }
    }
}

#[test]
fn stops_limit_presets_within_their_geometric_range() {
    for Expected { name, .. } in &EXPECTED {
        let free = solver(&freed(name)).motion().range;
        let stops = STOPS.iter().find(|stops| stops.0 == *name);
        let kept = stops.map_or(free, |&(_, low, high)| Range::Limited { low, high });
        assert_eq!(solver(&open(name)).motion().range, kept, "{name}");
        let ((low, high), (minimum, maximum)) = (kept.ends(), free.ends());
        assert!(stops.is_none() || minimum < low && high < maximum, "{name}");
    }
}

#[test]
fn every_preset_is_solved_by_expected_groups() {
    for Expected { name, groups, .. } in &EXPECTED {
        let scene = open(name);
        let solver = solver(&scene);
        let mut found: Vec<GroupKind> = solver.plan().groups.iter().map(|g| g.kind).collect();
        found.retain(|kind| *kind != GroupKind::Driver);
        let coupled = |kind: &GroupKind| matches!(kind, Coupled { .. });
        let same = |(a, b): (&GroupKind, &GroupKind)| a == b || coupled(a) && coupled(b);
        assert!(
            found.len() == groups.len() && found.iter().zip(groups.iter()).all(same),
            "{name}: {found:?}"
        );
    }
}

#[test]
fn every_preset_closes_over_its_whole_range() {
    for Expected { name, .. } in &EXPECTED {
        let scene = open(name);
        let solver = solver(&scene);
        let mut state = solver.state();
        let limit = 50.0 * U * longest_link(&scene.mechanism);
        for at in places(solver.motion().range) {
            let condition = solver.solve(at, Order::Position, &mut state);
            assert_eq!(condition, Condition::Ok, "{name} at {at}");
            let error = closure_error(&scene.mechanism, &state);
            assert!(error <= limit, "{name} at {at}: {error:e} > {limit:e}");
        }
    }
}

/// Every preset opens close to the positions of its `[start]`, not merely nearer to them than
/// another assembly.
#[test]
fn every_preset_opens_near_its_start_positions() {
    for Expected { name, .. } in &EXPECTED {
        let scene = open(name);
        let solver = solver(&scene);
        let mut state = solver.state();
        let _ = solver.solve(scene.mechanism.driver().start, Order::Position, &mut state);
        let near = 0.06 * longest_link(&scene.mechanism);
        for &(point, place) in scene.mechanism.start() {
            let off = (state.position(point).unwrap() - place).norm();
            assert!(
                off < near,
                "{name}: {:?} is {off} off",
                scene.point_name(point)
            );
        }
    }
}

/// Returns all values of a state with their first and second rates.
fn figures(scene: &Scene, state: &State) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let (mut values, mut rates, mut accelerations) = (Vec::new(), Vec::new(), Vec::new());
    for point in scene.mechanism.point_ids() {
        let (p, v, a) = (
            state.position(point).unwrap(),
            state.velocity(point).unwrap(),
            state.acceleration(point).unwrap(),
        );
        values.extend([p.x, p.y]);
        rates.extend([v.x, v.y]);
        accelerations.extend([a.x, a.y]);
    }
    let length = longest_link(&scene.mechanism);
    for link in scene.mechanism.link_ids() {
        // A direction d turns as d' = w k x d, d'' = alpha k x d - w^2 d.
        let (d, w, alpha) = (
            state.direction(link).unwrap(),
            state.omega(link).unwrap(),
            state.alpha(link).unwrap(),
        );
        let (first, second) = (d.perp() * w, d.perp() * alpha - d * (w * w));
        values.extend([d.x * length, d.y * length]);
        rates.extend([first.x * length, first.y * length]);
        accelerations.extend([second.x * length, second.y * length]);
    }
    for slide in scene.mechanism.slide_ids() {
        let travel = state.travel(slide).unwrap();
        values.push(travel.position);
        rates.push(travel.rate.unwrap());
        accelerations.push(travel.accel.unwrap());
    }
    (values, rates, accelerations)
}

/// Returns the largest difference between rates and central differences, relative to the largest
/// rate.
fn disagreement(low: &[f64], high: &[f64], span: f64, rates: &[f64]) -> f64 {
    let largest = rates.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
    let differences = low.iter().zip(high).map(|(l, h)| (h - l) / span);
    let off = differences.zip(rates).map(|(d, r)| (d - r).abs());
    off.fold(0.0, f64::max) / largest
}

#[test]
fn rates_of_every_preset_agree_with_central_differences() {
    for Expected { name, .. } in &EXPECTED {
        let scene = open(name);
        let solver = solver(&scene);
        let driver = scene.mechanism.driver();
        assert_eq!(driver.acceleration, 0.0, "differences take an even speed");
        let mut state = solver.state();
        let range = solver.motion().range;
        let places = places(range);
        // Near a limit the rates grow so fast that differences are inaccurate.
        let shy = match range {
            Range::Full { .. } => 0,
            Range::Limited { .. } => 3,
        };
        let step = 1e-3 * (places[1] - places[0]);
        let span = match driver.input {
            Input::Turn(_) => (2.0 * step).to_radians() / driver.speed,
            Input::Push(_) => 2.0 * step / driver.speed,
        };
        let mut at_place = |at: f64| {
            let condition = solver.solve(at, Order::Acceleration, &mut state);
            assert_eq!(condition, Condition::Ok, "{name} at {at}");
            figures(&scene, &state)
        };
        for &at in &places[shy..places.len() - shy] {
            let (low, here, high) = (at_place(at - step), at_place(at), at_place(at + step));
            let first = disagreement(&low.0, &high.0, span, &here.1);
            let second = disagreement(&low.1, &high.1, span, &here.2);
            assert!(
                first < 1e-6,
                "{name} at {at}: velocities differ by {first:e}"
            );
            assert!(
                second < 1e-6,
                "{name} at {at}: accelerations differ by {second:e}"
            );
        }
    }
}

/// Regression test: the rates of Peaucellier's cell at its limit were shown as if they existed, as
/// 1e22 mm/s^2.
#[test]
fn dead_points_of_every_preset_are_the_limits_of_its_geometry() {
    for Expected { name, .. } in &EXPECTED {
        let solver = solver(&freed(name));
        let motion = solver.motion();
        let limits = match motion.range {
            Range::Full { .. } => vec![],
            Range::Limited { low, high } => vec![low, high],
        };
        assert_eq!(motion.dead_points, limits, "{name}");
        let mut state = solver.state();
        let mut is_dead_point =
            |at: f64| solver.solve(at, Order::Acceleration, &mut state) == Condition::DeadPoint;
        for at in limits {
            assert!(is_dead_point(at), "{name} at {at}");
        }
        for at in places(motion.range) {
            assert!(!is_dead_point(at), "{name} at {at}");
        }
    }
    for (name, ..) in STOPS {
        let stopped = solver(&open(name)).motion().dead_points.clone();
        assert!(stopped.is_empty(), "{name}: {stopped:?}");
    }
}
