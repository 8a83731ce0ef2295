//! The derivatives of quantities by the given lengths, compared with closed forms derived here.

use krank::quantity::{Catalogue, Derivatives, Quantity, Sensitivity};
use krank::scene::{Scene, presets};
use krank::solver::{Order, Range, Solver};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::PI;

struct Probe {
    sensitivity: Sensitivity,
    names: Vec<String>,
}

impl Probe {
    fn of(text: &str) -> Probe {
        let scene = Scene::parse(text, "test").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let catalogue = Catalogue::new(&scene);
        let quantities = catalogue.select(&["*"]).unwrap();
        Probe {
            sensitivity: Sensitivity::new(&scene, &solver, &quantities),
            names: quantities.iter().map(|f| f.name.clone()).collect(),
        }
    }

    fn preset(name: &str) -> Probe {
        Probe::of(presets::find(name).unwrap().text)
    }

    /// Returns d(figure)/d(length).
    fn derivative(&self, found: &Derivatives, figure: &str, length: &str) -> f64 {
        let figure = self.names.iter().position(|n| n == figure).unwrap();
        let lengths = self.sensitivity.lengths();
        let length = lengths.iter().position(|l| l == length);
        found.of(figure).unwrap()[length.unwrap_or_else(|| panic!("no such length: {lengths:?}"))]
    }
}

#[expect(clippy::print_stdout, reason = "the measured figures are to be read")]
fn note(text: &str) {
    println!("{text}");
}

fn four_bar([a, b, c, d]: [f64; 4], at: f64, near: [f64; 2]) -> String {
    format!(
        r#"
[ground]
A = [0, 0]
D = [{d:?}, 0]
[driver]
link = "r2"
angle = {at:?}
speed = "3 rad/s"
[links]
r2 = {{ from = "A", to = "B", length = {a:?} }}
r3 = {{ from = "B", to = "C", length = {b:?}, points = {{ P = [0.25, 0.5] }} }}
r4 = {{ from = "D", to = "C", length = {c:?} }}
[start]
C = [{:?}, {:?}]
"#,
        near[0], near[1]
    )
}

/// A pose with its lengths: angles are drawn, and the lengths follow.
#[derive(Clone, Copy, Debug)]
struct Pose {
    lengths: [f64; 4],
    /// The angles of crank, coupler and rocker, in radians.
    angles: [f64; 3],
}

impl Pose {
    fn four_bar(&self) -> String {
        let [_, _, c, d] = self.lengths;
        let [_, _, t4] = self.angles;
        let near = [d + c * t4.cos(), c * t4.sin()];
        four_bar(self.lengths, self.angles[0].to_degrees(), near)
    }

    fn sine(&self) -> f64 {
        (self.angles[1] - self.angles[2]).sin()
    }
}

/// Draws crank, coupler and rocker by their angles and lengths, with a preference for poses where
/// coupler and rocker are nearly collinear.
fn poses() -> impl Strategy<Value = Pose> {
    let lean = prop_oneof![3 => Just(1.0), 1 => Just(1e-2), 1 => Just(1e-3), 1 => Just(1e-4)];
    let angles = (0.3..2.8, -3.0..3.0, 0.2..1.5, lean, any::<bool>());
    (0.2..1.0, 0.5..2.0, 0.5..2.0, angles).prop_map(|(a, b, c, (t2, t3, mu, lean, left))| {
        let t4: f64 = t3 + mu * lean * if left { 1.0 } else { -1.0 };
        // D is at the end of the chain, rotated such that A and D are level.
        let at = |t: f64, r: f64| (r * t.cos(), r * t.sin());
        let ((ax, ay), (bx, by), (cx, cy)) = (at(t2, a), at(t3, b), at(t4, c));
        let (dx, dy) = (ax + bx - cx, ay + by - cy);
        let turn = dy.atan2(dx);
        Pose {
            lengths: [a, b, c, dx.hypot(dy)],
            angles: [t2 - turn, t3 - turn, t4 - turn],
        }
    })
}

/// Computes the derivatives from the loop r2 + r3 = r1 + r4 at a fixed crank angle. With e the
/// links' directions,
/// ```text
/// d(theta4) = (dr3 + dr2 e2.e3 - dr4 e4.e3 - dr1 e1.e3) / (r4 sin(theta3 - theta4))
/// d(theta3) = (dr4 - dr2 e2.e4 - dr3 e3.e4 + dr1 e1.e4) / (r3 sin(theta4 - theta3))
/// omega4 = omega2 r2 sin(theta3 - theta2) / (r4 sin(theta3 - theta4))   and so its differential
/// ```
/// where r4 sin(theta3 - theta4) is c sin(mu): mu is the transmission angle.
fn exact([a, b, c, _]: [f64; 4], [t2, t3, t4]: [f64; 3], by: usize) -> [f64; 2] {
    let [dr2, dr3, dr4, dr1] = [0, 1, 2, 3].map(|i| f64::from(u8::from(i == by)));
    let sine = (t3 - t4).sin();
    let d4 = (dr3 + dr2 * (t2 - t3).cos() - dr4 * (t4 - t3).cos() - dr1 * t3.cos()) / (c * sine);
    let d3 = (dr4 - dr2 * (t2 - t4).cos() - dr3 * (t3 - t4).cos() + dr1 * t4.cos()) / (-b * sine);
    let omega4 = 3.0 * a * (t3 - t2).sin() / (c * sine);
    // d(sin(t3 - t2)) is not divided by the sine, which may be zero.
    let along = 3.0 * a * (t3 - t2).cos() * d3 / (c * sine);
    let rest = dr2 / a - dr4 / c - (d3 - d4) * (t3 - t4).cos() / sine;
    [d4.to_degrees(), along + omega4 * rest]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// Over random and near-singular poses, every derivative is correct to rounding: to 64 u /
    /// sin^2(mu) of the largest of its kind, including the rounding of the angles in this closed
    /// form.
    #[test]
    fn four_bar_derivatives_match_closed_form(pose in poses()) {
        prop_assume!(pose.lengths[3] > 0.1);
        let Ok(scene) = Scene::parse(&pose.four_bar(), "test") else { return Ok(()) };
        // Within rounding of a change point, a pose may not open.
        prop_assume!(Solver::new(&scene.mechanism).is_ok());
        let mut probe = Probe::of(&pose.four_bar());
        let found = probe.sensitivity.at(pose.angles[0].to_degrees());
        prop_assert!(found.is_some(), "sin(mu) = {}", pose.sine());
        let found = found.unwrap();
        let names = ["r2.length", "r3.length", "r4.length", "D.x"];
        let wanted = [0, 1, 2, 3].map(|i| exact(pose.lengths, pose.angles, i));
        for (i, figure) in ["r4.angle", "r4.omega"].into_iter().enumerate() {
            let largest = wanted.iter().map(|w| w[i].abs()).fold(0.0, f64::max);
            for (wanted, name) in wanted.iter().zip(names) {
                let error = (probe.derivative(&found, figure, name) - wanted[i]).abs();
                let rounded = 64.0 * f64::EPSILON / pose.sine().powi(2);
                prop_assert!(error <= rounded * largest, "{figure} by {name}: off by {error:e} of {largest}");
            }
        }
    }
}

/// x = r cos(phi) + s with s = sqrt(l^2 - r^2 sin^2(phi)); s' = -r^2 sin cos / s and s'' = -(r^2
/// cos(2 phi) + s'^2) / s by phi, and once more by l.
#[test]
fn slider_crank_derivatives_match_closed_form() {
    let mut probe = Probe::preset("slider-crank");
    let (r, l, omega) = (10.0_f64, 20.0_f64, 200.0);
    let mut worst = [0.0_f64; 3];
    for degrees in (0..360).step_by(5).map(f64::from) {
        let found = probe.sensitivity.at(degrees).unwrap();
        let (sin, cos) = (degrees * PI / 180.0).sin_cos();
        let s = (l * l - (r * sin).powi(2)).sqrt();
        let s1 = -r * r * sin * cos / s;
        let inner = r * r * (cos * cos - sin * sin) + s1 * s1;
        let by_l = l / s;
        let s1_by_l = -s1 * l / (s * s);
        let s2_by_l = inner * l / s.powi(3) - 2.0 * s1 * s1_by_l / s;
        let wanted = [by_l, omega * s1_by_l, omega * omega * s2_by_l];
        let largest = [1.0, omega, omega * omega].map(|k| k / l);
        for (i, figure) in ["r4.length", "r4.rate", "r4.accel"].into_iter().enumerate() {
            let error = (probe.derivative(&found, figure, "r3.length") - wanted[i]).abs();
            worst[i] = worst[i].max(error / largest[i]);
        }
    }
    note(&format!(
        "slider-crank, largest errors of x, x', x'' by l: {worst:?}"
    ));
    assert!(worst.iter().all(|w| *w < 1e-13), "{worst:?}");
}

#[test]
fn simple_length_derivatives_are_exact() {
    let mut yoke = Probe::preset("scotch-yoke");
    let found = yoke.sensitivity.at(60.0).unwrap();
    // x = r cos(60 deg), at 10 rad/s.
    assert!((yoke.derivative(&found, "r4.length", "r2.length") - 0.5).abs() < 1e-12);
    assert!((yoke.derivative(&found, "r4.accel", "r2.length") + 50.0).abs() < 1e-9);
    assert_eq!(yoke.derivative(&found, "yoke.omega", "r2.length"), 0.0);
    // The guide passes through A by name: the yoke moves with A, and r counts from A.
    assert!((yoke.derivative(&found, "Y.x", "A.x") - 1.0).abs() < 1e-12);
    assert_eq!(yoke.derivative(&found, "r4.length", "A.x"), 0.0);

    let mut bar = Probe::preset("four-bar");
    let found = bar.sensitivity.at(60.0).unwrap();
    let near = |figure, length, wanted: f64| {
        let d = bar.derivative(&found, figure, length);
        assert!((d - wanted).abs() < 1e-10, "{figure} by {length}: {d}");
    };
    // A centre of mass moves with its coordinate; other points do not.
    let [cos, sin] = ["r4.com.x", "r4.com.y"].map(|l| bar.derivative(&found, "r4.com.x", l));
    assert!((cos * cos + sin * sin - 1.0).abs() < 1e-11);
    assert!((sin.atan2(cos).to_degrees() - (360.0 - 290.753)).abs() < 1e-3);
    assert_eq!(bar.derivative(&found, "C.x", "r4.com.x"), 0.0);
    near("B.x", "r2.length", 0.5);
    near("r1.length", "D.x", 1.0);
    // A translation of the whole ground moves every point and turns no link.
    let both =
        |figure| bar.derivative(&found, figure, "A.x") + bar.derivative(&found, figure, "D.x");
    assert!((both("C.x") - 1.0).abs() < 1e-10 && both("r4.omega").abs() < 1e-10);
}

/// At an end, at a change point, and where a length would jam, there are no derivatives.
#[test]
fn no_derivatives_at_singularities_or_limits() {
    // A change point is at 0 deg; a parallelogram with other lengths does not reach it.
    let mut parallelogram = Probe::preset("parallelogram");
    assert!(parallelogram.sensitivity.at(0.0).is_none());
    assert!(parallelogram.sensitivity.at(60.0).is_some());
    // Three parallel cranks turn only with their exact lengths.
    let mut parallel = Probe::preset("triple-parallelogram");
    assert!(parallel.sensitivity.at(60.0).is_none());
    // Before, at and behind the limit of a crank that cannot turn fully.
    let limit = 82.819_244_218_541_7;
    let pose = four_bar([60.0, 50.0, 60.0, 100.0], 60.0, [75.0, 55.0]);
    let mut swinging = Probe::of(&pose);
    for (at, exists) in [(limit - 1e-4, true), (limit, false), (90.0, false)] {
        assert_eq!(swinging.sensitivity.at(at).is_some(), exists, "{at}");
    }
}

/// Every preset has derivatives at its start, unless a redundant part would jam.
#[test]
fn presets_have_derivatives() {
    for preset in presets::all() {
        let mut probe = Probe::preset(preset.name);
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let found = probe.sensitivity.at(scene.mechanism.driver().start);
        let solver = Solver::new(&scene.mechanism).unwrap();
        let redundant = solver.plan().redundant.len();
        assert_eq!(
            found.is_some(),
            redundant == 0,
            "{}: {redundant}",
            preset.name
        );
        let Some(found) = found else { continue };
        let figures = 0..probe.names.len();
        let worst = figures.filter_map(|i| found.worst(i));
        assert!(worst.fold(0.0, f64::max) > 0.4, "{}", preset.name);
    }
}

/// Compares every quantity of every preset, including forces, with secants of reopened scenes. Each
/// of these has its own assembly and its own whole motion: dyads of every kind, coupled groups and
/// their forces.
#[test]
fn preset_derivatives_match_secants_of_reopened_scenes() {
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        if solver.plan().redundant.is_empty() {
            let worst = against_secants(&scene, &solver, scene.mechanism.driver().start);
            note(&format!("{}: {worst:.1e} of the largest", preset.name));
            assert!(worst <= 2e-8, "{}: {worst:e}", preset.name);
        }
    }
}

/// Returns the largest difference of a derivative from (4 D(h/2) - D(h)) / 3 with D(h) = (f(l + h)
/// - f(l - h)) / 2h and h a part of the longest length.
///
/// The difference is relative to the largest derivative of the quantity plus its value per unit of
/// size. A secant's error is h^4 if a length is short compared with the longest, and rounding / h
/// if forces cancel. A smaller step decides if the larger one does not.
fn against_secants(scene: &Scene, solver: &Solver, at: f64) -> f64 {
    let mut worst = f64::INFINITY;
    for part in [1024.0, 4096.0] {
        if worst > 2e-8 {
            let quantities = Catalogue::new(scene).select(&["*"]).unwrap();
            worst = worst.min(figures_against_secants(
                quantities,
                scene,
                solver,
                at,
                (part, 1e-4),
            ));
        }
    }
    worst
}

fn figures_against_secants(
    mut quantities: Vec<Quantity>,
    scene: &Scene,
    solver: &Solver,
    at: f64,
    (part, share): (f64, f64),
) -> f64 {
    // A residual is a rounding error and does not depend on lengths.
    quantities.retain(|quantity| !quantity.name.contains("residual"));
    let mut sensitivity = Sensitivity::new(scene, solver, &quantities);
    let found = sensitivity.at(at).unwrap();
    let h = solver.scale() / part;
    let mut misses = vec![0.0_f64; quantities.len()];
    for (number, &length) in scene.mechanism.lengths().iter().enumerate() {
        let read = |by: f64| {
            let solver = Solver::new(&scene.mechanism.changed(length, by)).unwrap();
            let mut state = solver.state();
            let _ = solver.solve(at, Order::Force, &mut state);
            let quantities = quantities.iter();
            quantities
                .map(|f| f.value(&state).unwrap_or(f64::NAN))
                .collect::<Vec<_>>()
        };
        let [a, b, c, d] = [h, -h, h / 2.0, -h / 2.0].map(read);
        for (k, quantity) in quantities.iter().enumerate() {
            let distance = |over: f64, under: f64| match quantity.is_direction() {
                true => (over - under + 540.0).rem_euclid(360.0) - 180.0,
                false => over - under,
            };
            let (wide, narrow) = (distance(a[k], b[k]) / (2.0 * h), distance(c[k], d[k]) / h);
            let secant = narrow + (narrow - wide) / 3.0;
            // An element at rest has no direction, which other tests cover.
            let Some(slopes) = found.of(k) else { continue };
            misses[k] = misses[k].max((slopes[number] - secant).abs());
        }
    }
    let mut state = solver.state();
    let _ = solver.solve(at, Order::Force, &mut state);
    let parts = quantities.iter().zip(misses).enumerate();
    let parts = parts.map(|(k, (quantity, miss))| {
        let value = quantity.value(&state).unwrap_or(f64::NAN).abs();
        // A quantity independent of all lengths may differ by the secant's rounding, and one that
        // results from cancellation by the rounding of others of its unit.
        let alike = quantities
            .iter()
            .filter(|other| other.unit == quantity.unit);
        let sizes = alike.filter_map(|other| other.value(&state)).map(f64::abs);
        let floor = (share * sizes.fold(0.0, f64::max) / solver.scale()).max(1e-3);
        miss / (found.worst(k).unwrap_or(0.0) + value / solver.scale()).max(floor)
    });
    parts.fold(0.0, f64::max)
}

/// Magnitudes, directions, tangential and normal parts of motions and forces are listed only on
/// request. They agree with secants in every preset that has them.
#[test]
fn unlisted_derivatives_match_secants_of_reopened_scenes() {
    let mut ends = BTreeMap::<&str, usize>::new();
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        if !solver.plan().redundant.is_empty() {
            continue;
        }
        // A position where no moving element is nearly at rest, since a secant's step would pass
        // that point.
        let at = match solver.motion().range {
            Range::Full { period } => 0.41 * period,
            Range::Limited { low, high } => low + 0.41 * (high - low),
        };
        let quantities = Catalogue::new(&scene).unlisted();
        let found = Sensitivity::new(&scene, &solver, &quantities)
            .at(at)
            .unwrap();
        for (k, quantity) in quantities.iter().enumerate() {
            let end = [
                ".a.t", ".a.n", ".v.angle", ".a.angle", ".f.angle", ".v", ".a", ".f",
            ];
            let end = end.into_iter().find(|end| quantity.name.ends_with(end));
            *ends.entry(end.unwrap_or("of its own")).or_default() +=
                usize::from(found.of(k).is_some());
        }
        let worst = figures_against_secants(quantities, &scene, &solver, at, (8192.0, 1e-4));
        note(&format!("{}: {worst:.1e} of the largest", preset.name));
        assert!(worst <= 1e-7, "{}: {worst:e}", preset.name);
    }
    note(&format!("{ends:?}"));
    for end in [".a.t", ".a.n", ".f", ".f.angle", ".v"] {
        assert!(ends[end] > 20, "{ends:?}");
    }
}

/// If the two sides of a kink have different derivatives there is none; if they agree there is one.
#[test]
fn kinks_have_no_derivative() {
    let scene = Scene::parse(presets::find("four-bar").unwrap().text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let on = "hypot(C.x - D.x, C.y - D.y)";
    let off = &format!("{on} - 250 mm");
    // At 0 deg B is on the x axis, level with A and D.
    for (formula, at_0, at_60) in [
        ("abs(B.y)", false, true),
        ("abs(A.y - D.y)", false, false),
        ("abs(B.y - B.y)", true, true),
        ("min(B.y, D.y)", false, true),
        ("max(B.y, D.y)", false, true),
        ("max(B.x, B.x)", true, true),
        ("min(B.x, 2 * B.x - B.x)", true, true),
        ("sqrt(B.y / 1 mm)", false, true),
        ("hypot(B.y, B.y)", false, true),
        ("abs(C.y)", true, true),
        // Zero up to rounding.
        ("abs(hypot(C.x - D.x, C.y - D.y) - 250 mm)", false, false),
        (&format!("max({off}, -({off}))"), false, false),
        (&format!("sqrt(({off})^2)"), false, false),
        (&format!("hypot({off}, 0 mm)"), false, false),
        (&format!("min({on}, 250 mm)"), false, false),
        (&format!("hypot({off}, 2 * ({off}))"), false, false),
        (&format!("acos({on} / 250 mm)"), false, false),
        (&format!("atan2({off}, {off})"), false, false),
        // Both sides have equal derivatives.
        (&format!("max({on}, 2 * {on} - {on})"), true, true),
        (&format!("C.x + abs({off} - ({off}))"), true, true),
        (&format!("hypot({on}, {off})"), true, true),
        (&format!("max({off}, 0 mm)"), false, false),
    ] {
        let mut catalogue = Catalogue::new(&scene);
        let quantity = catalogue.define(&format!("k = {formula}")).unwrap();
        let mut sensitivity = Sensitivity::new(&scene, &solver, &[quantity]);
        for (at, exists) in [(0.0, at_0), (60.0, at_60)] {
            let found = sensitivity.at(at).unwrap();
            assert_eq!(found.of(0).is_some(), exists, "{formula} at {at}");
        }
    }
}

/// A slider on a straight guide has no normal acceleration for any lengths: this is not a kink.
#[test]
fn zero_on_both_sides_has_derivative() {
    let scene = Scene::parse(presets::find("slider-crank").unwrap().text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let quantities = Catalogue::new(&scene).select(&["C.a.n", "C.a.t"]).unwrap();
    let found = Sensitivity::new(&scene, &solver, &quantities)
        .at(30.0)
        .unwrap();
    assert!(found.of(0).unwrap().iter().all(|d| *d == 0.0));
    assert!(found.of(1).unwrap().iter().any(|d| *d != 0.0));
    // Peaucellier's point moves along a line only for these lengths, and any change of a length
    // bends its path either way.
    let scene = Scene::parse(presets::find("peaucellier").unwrap().text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let quantities = Catalogue::new(&scene).select(&["P.a.n", "P.a.t"]).unwrap();
    let at = scene.mechanism.driver().start;
    let found = Sensitivity::new(&scene, &solver, &quantities)
        .at(at)
        .unwrap();
    assert!(found.of(0).is_none() && found.of(1).is_some());
}

/// Lengths and angles of points have derivatives like coordinates, and points relative to them move
/// with them.
#[test]
fn polar_point_derivatives_match_secants() {
    let scene = Scene::parse(crate::polar::SIGHTED, "sighted").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let worst = against_secants(&scene, &solver, 60.0);
    assert!(worst <= 2e-8, "{worst:e}");
    let mut probe = Probe::of(crate::polar::SIGHTED);
    let names = [
        "F.length",
        "F.across",
        "E.length",
        "E.across",
        "com.length",
        "com.across",
    ];
    for name in names.map(|name| format!("r3.{name}")) {
        assert!(probe.sensitivity.lengths().contains(&name), "{name}");
    }
    let found = probe.sensitivity.at(60.0).unwrap();
    // E moves outwards by 1 mm at 72.3 deg from a link at theta3, and F moves with it.
    let theta = 29.379_380_f64 + 72.3;
    for name in ["E.x", "F.x", "r3.com.x"] {
        let d = probe.derivative(&found, name, "r3.E.length");
        assert!((d - theta.to_radians().cos()).abs() < 1e-5, "{name}: {d}");
        let d = probe.derivative(&found, name, "r3.E.across");
        assert!((d + theta.to_radians().sin()).abs() < 1e-5, "{name}: {d}");
    }
}

/// A press load acts over the last part of its stroke, whose end also depends on the lengths.
#[test]
fn press_torque_derivatives_follow_end_of_stroke() {
    let preset = presets::find("press-ram").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let torque = |at: f64| {
        let mut state = solver.state();
        let _ = solver.solve(at, Order::Force, &mut state);
        state.drive().unwrap().abs()
    };
    // The press load acts at both.
    for at in [20.0, 350.0] {
        assert!(torque(at) > 2.0 * torque(90.0), "{at}");
        let worst = against_secants(&scene, &solver, at);
        assert!(worst < 1e-4, "{at}: {worst:e}");
    }
}

const TWICE_GUIDED: &str = r#"
[ground]
A = [0, 0]
[driver]
link = "r2"
angle = 40
[links]
r2 = { from = "A", to = "B", length = 10 }
r3 = { from = "B", to = "C", length = 20 }
[slides]
r4 = { point = "C", on = "ground", through = "A", angle = 0 }
r5 = { point = "C", on = "ground", through = [5, 0], angle = 0 }
[start]
C = [26, 0]
"#;

/// Detecting that a length jams a redundant linkage does not depend on the requested quantities.
#[test]
fn jamming_is_detected_for_any_columns() {
    let scene = Scene::parse(TWICE_GUIDED, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    for columns in [&["*"][..], &["C.x"], &["B.x"], &["r3.angle"]] {
        let quantities = Catalogue::new(&scene).select(columns).unwrap();
        let mut sensitivity = Sensitivity::new(&scene, &solver, &quantities);
        // r5 runs through its own point next to A: if that moves up, C cannot satisfy both guides.
        assert!(sensitivity.at(40.0).is_none(), "{columns:?}");
    }
}

/// A link a millionth as long as the others turns a million times as far, but is not singular.
#[test]
fn short_link_is_not_singular() {
    let (tiny, angles) = (4e-6, [PI / 3.0, 0.3, 1.1]);
    let at = |t: f64, r: f64| [r * t.cos(), r * t.sin()];
    let ([ax, ay], [bx, by]) = (at(angles[0], 1.0), at(angles[1], 2.0));
    let [cx, cy] = at(angles[2], tiny);
    let text = format!(
        "[ground]\nA = [0, 0]\nD = [{:?}, {:?}]\n[driver]\nlink = \"r2\"\nangle = 60\n[links]\n\
         r2 = {{ from = \"A\", to = \"B\", length = 1 }}\nr3 = {{ from = \"B\", to = \"C\", length = 2 }}\n\
         r4 = {{ from = \"D\", to = \"C\", length = {tiny:?} }}\n[start]\nC = [{:?}, {:?}]\n",
        ax + bx - cx,
        ay + by - cy,
        ax + bx,
        ay + by
    );
    let mut probe = Probe::of(&text);
    let found = probe.sensitivity.at(60.0).unwrap();
    // As in `exact`: d(theta4) = dr3 / (r4 sin(theta3 - theta4)).
    let d = probe
        .derivative(&found, "r4.angle", "r3.length")
        .to_radians();
    let wanted = 1.0 / (tiny * (angles[1] - angles[2]).sin());
    assert!((d / wanted - 1.0).abs() < 1e-8, "{d} {wanted}");
}
