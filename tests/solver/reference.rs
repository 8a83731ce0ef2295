//! Compares the solver with values to 25 digits: every row of every file of `tests/reference/`.
//!
//! `cargo test --test solver reference -- --nocapture` prints the largest errors found.

use crate::exact::{DoubleDouble, PI};
use krank::quantity::{self, Aspect};
use krank::scene::Scene;
use krank::solver::{Condition, Order, Solver, State};
use krank::{Ball, LinkId, Mechanism, PointId, SlideId, Vec2, angle};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::PathBuf;

/// Half an ulp of 1: the unit of rounding.
const U: f64 = f64::EPSILON / 2.0;
/// Positions within 20 u of the longest link, angles within 20 u rad.
const POSITION_LIMIT: f64 = 20.0;
/// Rates within 200 u of the largest value of their kind in the file.
const RATE_LIMIT: f64 = 200.0;

/// One reference file.
struct Case {
    name: &'static str,
    /// Factor on the limits above.
    slack: f64,
    /// Links of the file without a body in the scene: the blocks of its pins in slots.
    absent: &'static [&'static str],
}

const CASES: [Case; 11] = [
    case("b1_fourbar", 1.0, &[]),
    case("b2_slidercrank", 1.0, &["4"]),
    case("b3a_press_two_fourbars", 1.0, &[]),
    case("b3b_press_slider", 1.0, &[]),
    case("b4a_slotted_lever", 1.0, &["3"]),
    case("b4b_whitworth", 1.0, &["6"]),
    case("b4c_scotch_yoke", 1.0, &["3"]),
    case("b4d_watt2", 1.0, &[]),
    case("b4e_stephenson3_triad", 1.0, &[]),
    // Eight links in series, at a condition number of 92.
    case("b4f_jansen", 10.0, &[]),
    case("b5_cylinder_boom", 1.0, &[]),
];

const fn case(name: &'static str, slack: f64, absent: &'static [&'static str]) -> Case {
    Case {
        name,
        slack,
        absent,
    }
}

/// The kind of a column: it determines scale and unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Position,
    Velocity,
    Acceleration,
    Angle,
    Omega,
    Alpha,
}

impl Kind {
    const ALL: [Kind; 6] = [
        Kind::Position,
        Kind::Velocity,
        Kind::Acceleration,
        Kind::Angle,
        Kind::Omega,
        Kind::Alpha,
    ];

    fn of(aspect: &str) -> Option<Kind> {
        Some(match aspect {
            "x" | "y" => Kind::Position,
            "vx" | "vy" => Kind::Velocity,
            "ax" | "ay" => Kind::Acceleration,
            "theta" => Kind::Angle,
            "omega" => Kind::Omega,
            "alpha" => Kind::Alpha,
            _ => return None,
        })
    }

    fn limit(self) -> f64 {
        match self {
            Kind::Position | Kind::Angle => POSITION_LIMIT,
            Kind::Velocity | Kind::Acceleration | Kind::Omega | Kind::Alpha => RATE_LIMIT,
        }
    }
}

/// The element whose value a column has.
#[derive(Clone, Copy, Debug)]
enum Subject {
    Point(PointId),
    Link(LinkId),
}

#[derive(Debug)]
struct Column {
    name: String,
    kind: Kind,
    subject: Subject,
    index: usize,
}

impl Column {
    /// Returns the error of the state in this column, in the column's own unit.
    fn error(&self, exact: DoubleDouble, state: &State) -> f64 {
        match self.subject {
            Subject::Point(point) => {
                let vector = match self.kind {
                    Kind::Position => state.position(point).unwrap(),
                    Kind::Velocity => state.velocity(point).unwrap(),
                    _ => state.acceleration(point).unwrap(),
                };
                let along_x = self.name.ends_with('x');
                exact.minus(if along_x { vector.x } else { vector.y })
            }
            Subject::Link(link) => match self.kind {
                Kind::Angle => angle_error(exact, state.angle(link).unwrap()),
                Kind::Omega => exact.minus(state.omega(link).unwrap()),
                _ => exact.minus(state.alpha(link).unwrap()),
            },
        }
    }
}

impl Column {
    /// Returns krank's bound for the error of [`Column::error`], in the same unit.
    fn bound(&self, state: &State, enclosure: &State<Ball>) -> Option<f64> {
        let along_x = self.name.ends_with('x');
        let aspect = match (self.kind, along_x) {
            (Kind::Position, true) => Aspect::X,
            (Kind::Position, false) => Aspect::Y,
            (Kind::Velocity, true) => Aspect::Vx,
            (Kind::Velocity, false) => Aspect::Vy,
            (Kind::Acceleration, true) => Aspect::Ax,
            (Kind::Acceleration, false) => Aspect::Ay,
            (Kind::Angle, _) => Aspect::Angle,
            (Kind::Omega, _) => Aspect::Omega,
            (Kind::Alpha, _) => Aspect::Alpha,
        };
        let subject = match self.subject {
            Subject::Point(point) => quantity::Subject::Point(point),
            Subject::Link(link) => quantity::Subject::Link(link),
        };
        let bound = quantity::bound(subject, aspect, state, enclosure)?;
        Some(match self.kind {
            Kind::Angle => bound.to_radians(),
            _ => bound,
        })
    }
}

/// Returns the difference between a reference angle in rad, which counts full turns, and a shown
/// angle in degrees.
fn angle_error(exact: DoubleDouble, shown: f64) -> f64 {
    let shown = DoubleDouble::from(shown) * PI / DoubleDouble::from(180.0);
    let turn = PI * DoubleDouble::from(2.0);
    let difference = exact - shown;
    let turns = (difference.hi / turn.hi).round();
    (difference - turn * DoubleDouble::from(turns)).minus(0.0)
}

fn data(file: &str) -> String {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "tests", "reference", file]
        .iter()
        .collect();
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn open(name: &str) -> (Scene, Solver) {
    let scene = Scene::parse(&data(&format!("{name}.toml")), name)
        .unwrap_or_else(|e| panic!("{name}: {e:?}"));
    let solver = Solver::new(&scene.mechanism).unwrap_or_else(|e| panic!("{name}: {e}"));
    (scene, solver)
}

fn point(scene: &Scene, name: &str) -> Option<PointId> {
    let mut ids = scene.mechanism.point_ids();
    ids.find(|&id| scene.point_name(id) == Some(name))
}

fn link(scene: &Scene, name: &str) -> Option<LinkId> {
    let mut ids = scene.mechanism.link_ids();
    ids.find(|&id| scene.link_name(id) == name)
}

/// Returns the length of the longest link: the largest distance between two points of one.
fn longest_link(mechanism: &Mechanism) -> f64 {
    let distances = mechanism.link_ids().flat_map(|id| {
        let members = &mechanism.link(id).members;
        let pairs = members
            .iter()
            .flat_map(move |a| members.iter().map(move |b| (a.local - b.local).norm()));
        pairs.collect::<Vec<_>>()
    });
    distances.fold(0.0, f64::max)
}

/// A reference file in memory.
struct Table {
    columns: Vec<Column>,
    rows: Vec<Vec<DoubleDouble>>,
    /// The largest value of each kind.
    largest: BTreeMap<Kind, f64>,
}

impl Table {
    fn read(case: &Case, scene: &Scene) -> Table {
        let text = data(&format!("{}.csv", case.name));
        let mut lines = text.lines();
        let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
        let rows: Vec<Vec<DoubleDouble>> = lines
            .map(|line| {
                line.split(',')
                    .map(|cell| DoubleDouble::parse(cell).unwrap_or_else(|| panic!("{cell}")))
                    .collect()
            })
            .collect();
        let mut largest = BTreeMap::new();
        let mut columns = Vec::new();
        for (index, name) in header.iter().enumerate() {
            let Some((subject, kind)) = name
                .split_once('.')
                .and_then(|(subject, aspect)| Some((subject, Kind::of(aspect)?)))
            else {
                let known = ["driver", "cond", "sigma_min", "residual"];
                assert!(known.contains(name), "{}: what is {name}?", case.name);
                continue;
            };
            let peak = rows.iter().map(|r| r[index].hi.abs()).fold(0.0, f64::max);
            let of_kind: &mut f64 = largest.entry(kind).or_default();
            *of_kind = of_kind.max(peak);
            if case.absent.contains(&subject) {
                continue;
            }
            let found = match kind {
                Kind::Position | Kind::Velocity | Kind::Acceleration => {
                    point(scene, subject).map(Subject::Point)
                }
                Kind::Angle | Kind::Omega | Kind::Alpha => link(scene, subject).map(Subject::Link),
            };
            columns.push(Column {
                name: (*name).into(),
                kind,
                subject: found.unwrap_or_else(|| panic!("{}: no {subject}", case.name)),
                index,
            });
        }
        Table {
            columns,
            rows,
            largest,
        }
    }
}

/// The largest error of one kind.
#[derive(Clone, Debug, Default)]
struct Worst {
    /// The error in units of rounding, relative to the kind's scale.
    error: f64,
    place: String,
}

fn measure(case: &Case) -> BTreeMap<Kind, Worst> {
    let (scene, solver) = open(case.name);
    let table = Table::read(case, &scene);
    let length = longest_link(&scene.mechanism);
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    let mut worst: BTreeMap<Kind, Worst> = BTreeMap::new();
    for row in &table.rows {
        let at = row[0].hi;
        let condition = solver.solve(at, Order::Acceleration, &mut state);
        assert_eq!(condition, Condition::Ok, "{} at {at}", case.name);
        solver.enclose(&mut state, Order::Acceleration, &mut enclosure);
        for column in &table.columns {
            let scale = match column.kind {
                Kind::Position => length,
                Kind::Angle => 1.0,
                kind => table.largest[&kind],
            };
            let error = column.error(row[column.index], &state).abs();
            let place = format!("{}: {} at {at}", case.name, column.name);
            let bound = column.bound(&state, &enclosure).expect(&place);
            // The references themselves are correct to 25 digits.
            let known = bound + 1e-24 * row[column.index].hi.abs().max(1.0);
            assert!(error <= known, "{place}: off by {error:e}, bound {bound:e}");
            let error = if error == 0.0 {
                0.0
            } else {
                error / (U * scale)
            };
            let so_far = worst.entry(column.kind).or_default();
            // NaN counts as the largest error.
            if error.is_nan() || error > so_far.error {
                so_far.error = error;
                so_far.place = format!("{} at {at}", column.name);
            }
        }
    }
    worst
}

#[test]
#[expect(clippy::print_stdout, reason = "the measured maxima are to be read")]
fn every_row_of_every_reference_file_is_reproduced() {
    let mut report = String::new();
    let _ = writeln!(
        report,
        "\nlargest errors, in units u = 2^-53 of the longest link, of 1 rad, or of the largest value of the kind\n\
         {:<24}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}   of the limit",
        "", "position", "velocity", "accel", "angle", "omega", "alpha"
    );
    let mut misses = Vec::new();
    for case in &CASES {
        let worst = measure(case);
        let _ = write!(report, "{:<24}", case.name);
        let mut share: f64 = 0.0;
        for kind in Kind::ALL {
            let limit = kind.limit() * case.slack;
            let Worst { error, place } = worst.get(&kind).cloned().unwrap_or_default();
            let _ = write!(report, "{error:>10.2}");
            share = share.max(error / limit);
            if error.is_nan() || error > limit {
                misses.push(format!(
                    "{}: {place}: {error:.1} u, the limit is {limit} u",
                    case.name
                ));
            }
        }
        let _ = writeln!(report, "{:>12.0} %", share * 100.0);
    }
    println!("{report}");
    assert!(misses.is_empty(), "{}", misses.join("\n"));
}

#[test]
fn decimals_are_parsed_to_double_double() {
    // 1/3 to 25 digits less the double 1/3 is 1.85e-17.
    let third = DoubleDouble::parse("0.3333333333333333333333333").expect("a decimal");
    let rest = third.minus(1.0 / 3.0);
    assert!((rest - 1.850_371_707_708_594e-17).abs() < 1e-25, "{rest:e}");
    let scaled = DoubleDouble::parse("-2.500000e+01").expect("a decimal");
    assert_eq!((scaled.hi, scaled.lo), (-25.0, 0.0));
    let pi = DoubleDouble::parse("3.141592653589793238462643").expect("a decimal");
    assert!((pi - PI).minus(0.0).abs() < 1e-24);
}

/// A value of the lectures: its key there, krank's value, and its scale.
struct Check<'a> {
    key: &'a str,
    found: f64,
    unit: f64,
}

/// Compares with `lecture_values.json`; `path` leads to the object with the keys.
fn check_lecture(path: &[&str], checks: &[Check<'_>]) {
    let json: serde_json::Value = serde_json::from_str(&data("lecture_values.json")).expect("JSON");
    let object = path.iter().fold(&json, |value, key| &value[*key]);
    for check in checks {
        let text = object[check.key].as_str().expect("a decimal in a string");
        let exact = DoubleDouble::parse(text).expect("a decimal");
        let error = exact.minus(check.found).abs();
        assert!(
            error <= check.unit * U,
            "{path:?} {}: {} instead of {text}, {:.1} u off",
            check.key,
            check.found,
            error / U
        );
    }
}

/// Returns the checks of a point's motion, with their scales: length, speed and acceleration.
fn point_checks(state: &State, point: PointId, units: [f64; 3]) -> Vec<Check<'static>> {
    let (p, v, a) = (
        state.position(point).unwrap(),
        state.velocity(point).unwrap(),
        state.acceleration(point).unwrap(),
    );
    let [length, speed, acceleration] = [
        units[0] * POSITION_LIMIT,
        units[1] * RATE_LIMIT,
        units[2] * RATE_LIMIT,
    ];
    let check = |key, found, unit| Check { key, found, unit };
    vec![
        check("x", p.x, length),
        check("y", p.y, length),
        check("vx", v.x, speed),
        check("vy", v.y, speed),
        check("v", v.norm(), speed),
        check("ax", a.x, acceleration),
        check("ay", a.y, acceleration),
        check("a", a.norm(), acceleration),
    ]
}

/// Returns the checks of `theta3_rad`, `omega3` and `alpha3` of a link, with `omega` and `alpha` as
/// scales of the rates.
fn link_checks(
    state: &State,
    link: LinkId,
    keys: [&'static str; 3],
    rates: [f64; 2],
) -> Vec<Check<'static>> {
    let check = |key, found, unit| Check { key, found, unit };
    vec![
        check(
            keys[0],
            state.direction(link).unwrap().angle(),
            POSITION_LIMIT,
        ),
        check(keys[1], state.omega(link).unwrap(), rates[0] * RATE_LIMIT),
        check(keys[2], state.alpha(link).unwrap(), rates[1] * RATE_LIMIT),
    ]
}

#[test]
fn lecture_values_of_four_bar_are_reproduced() {
    let (scene, solver) = open("b1_fourbar");
    let mut state = solver.state();
    let _ = solver.solve(60.0, Order::Acceleration, &mut state);
    let by_name = |name| link(&scene, name).expect("a link");
    let rates = [15.0, 95.0];
    let third = link_checks(
        &state,
        by_name("3"),
        ["theta3_rad", "omega3", "alpha3"],
        rates,
    );
    let fourth = link_checks(
        &state,
        by_name("4"),
        ["theta4_rad", "omega4", "alpha4"],
        rates,
    );
    check_lecture(&["B1"], &third);
    check_lecture(&["B1"], &fourth);
    for name in ["B", "C", "G3", "G4"] {
        let point = point(&scene, name).expect("a point");
        let units = [300.0, 1500.0, 24_000.0];
        check_lecture(&["B1", name], &point_checks(&state, point, units));
    }
}

#[test]
fn lecture_values_of_slider_crank_are_reproduced() {
    let (scene, solver) = open("b2_slidercrank");
    let mut state = solver.state();
    let _ = solver.solve(30.0, Order::Acceleration, &mut state);
    let third = link(&scene, "3").expect("a link");
    let checks = link_checks(
        &state,
        third,
        ["theta3_rad", "omega3", "alpha3"],
        [200.0, 8262.0],
    );
    check_lecture(&["B2"], &checks);
    let units = [20.0, 2000.0, 460_000.0];
    let slide: SlideId = scene.mechanism.slide_ids().next().expect("a slide");
    let travel = state.travel(slide).unwrap();
    let check = |key, found, unit| Check { key, found, unit };
    let along = [
        check("r4", travel.position, units[0] * POSITION_LIMIT),
        check("v4", travel.rate.unwrap(), units[1] * RATE_LIMIT),
        check("a4", travel.accel.unwrap(), units[2] * RATE_LIMIT),
    ];
    check_lecture(&["B2"], &along);
    for name in ["B", "G", "C"] {
        let point = point(&scene, name).expect("a point");
        check_lecture(&["B2", name], &point_checks(&state, point, units));
    }
}

/// Hard case H17: three parallel cranks have one redundant constraint, which is consistent.
#[test]
fn h17_three_parallel_cranks_move() {
    let (scene, solver) = open("c_triple_parallelogram");
    assert_eq!(solver.plan().mobility, 1);
    assert!(!solver.plan().redundant.is_empty(), "one row is redundant");
    let (longest, omega) = (5.0, 2.0);
    let platform = link(&scene, "3").expect("a link");
    let mut state = solver.state();
    for at in [60.0, 90.0, 120.0, 150.0] {
        assert_eq!(
            solver.solve(at, Order::Acceleration, &mut state),
            Condition::Ok
        );
        let arm = angle::unit(at);
        for (name, pivot) in [("B", 0.0), ("C", 3.0), ("K", 5.0)] {
            let joint = point(&scene, name).expect("a point");
            let [position, velocity, acceleration] = [
                state.position(joint).unwrap() - (Vec2::new(pivot, 0.0) + arm),
                state.velocity(joint).unwrap() - arm.perp() * omega,
                state.acceleration(joint).unwrap() + arm * (omega * omega),
            ];
            let limit = POSITION_LIMIT * U * longest;
            assert!(position.norm() <= limit, "{name} at {at}: {position:?}");
            let limit = RATE_LIMIT * U * omega;
            assert!(velocity.norm() <= limit, "{name} at {at}: {velocity:?}");
            let limit = limit * omega;
            assert!(
                acceleration.norm() <= limit,
                "{name} at {at}: {acceleration:?}"
            );
        }
        assert!(state.omega(platform).unwrap().abs() <= RATE_LIMIT * U * omega);
        assert!(state.alpha(platform).unwrap().abs() <= RATE_LIMIT * U * omega * omega);
    }
}
