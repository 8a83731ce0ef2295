//! Derived quantities: magnitudes, directions and formulas, compared with the lecture's values and
//! with double-double arithmetic.

use krank::Double;
use krank::quantity::{Catalogue, Quantity, Sensitivity};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Range, Solver};
use proptest::prelude::*;

/// Formulas for any scene with links `r2`, `r3` and points `B`, `C`.
const FORMULAS: [&str; 7] = [
    "swing = r3.angle - r2.angle",
    "turned = atan2(C.vy, C.vx) + 30 deg",
    "share = hypot(C.ax, C.ay) / (B.a + 1 mm/s^2)",
    "arc = abs(r3.angle) * (C.x - 12.3 mm) ^ 2",
    "wave = sin(r3.angle) * cos(2 * r2.angle) / (2 + C.y / (100 mm))",
    "most = max(C.x, B.x, C.y) - min(B.y, 3 cm)",
    "lag = acos((B.x - A.x) / (1000 mm)) - asin(B.y / (1 m))",
];

struct Bench {
    solver: Solver,
    catalogue: Catalogue,
}

impl Bench {
    fn of(scene: &Scene) -> Bench {
        Bench {
            solver: Solver::new(&scene.mechanism).unwrap(),
            catalogue: Catalogue::new(scene),
        }
    }

    fn preset(name: &str) -> Bench {
        let preset = presets::find(name).unwrap();
        Bench::of(&Scene::parse(preset.text, preset.name).unwrap())
    }

    fn with_formulas(mut self) -> Bench {
        for formula in FORMULAS {
            self.catalogue.define(formula).unwrap();
        }
        self
    }

    fn named(&self, name: &str) -> Quantity {
        let found = self.catalogue.find(name);
        found.unwrap_or_else(|| panic!("no {name}"))
    }

    fn at(&self, at: f64, name: &str) -> Option<f64> {
        let mut state = self.solver.state();
        let _ = self.solver.solve(at, Order::Force, &mut state);
        self.named(name).value(&state)
    }

    /// Compares every bound at a coordinate with the true error. Returns how many quantities have a
    /// bound, and how many do not.
    fn check(&self, at: f64) -> [usize; 2] {
        let order = Order::Acceleration;
        let mut state = self.solver.state();
        let (mut twice, mut enclosure) = (self.solver.twice(), self.solver.enclosure());
        if self.solver.solve(at, order, &mut state) != Condition::Ok
            || !self.solver.solve_twice(&state, order, &mut twice)
        {
            return [0; 2];
        }
        self.solver.enclose(&mut state, order, &mut enclosure);
        let mut counts = [0; 2];
        let rates = ["swing.rate", "swing.accel", "wave.rate", "wave.accel"];
        let rates = rates.iter().filter_map(|name| self.catalogue.find(name));
        for quantity in self.catalogue.unlisted().into_iter().chain(rates) {
            let (Some(value), Some(truth)) = (quantity.value(&state), quantity.value(&twice))
            else {
                continue;
            };
            let Some(bound) = quantity.bound(&state, &enclosure) else {
                counts[1] += 1;
                continue;
            };
            counts[0] += 1;
            let off = (truth - Double::exactly(value)).abs();
            let is_turn = quantity.is_direction() && off.hi > 180.0;
            let turn = Double::exactly(if is_turn { 360.0 } else { 0.0 });
            let error = (off - turn).hi.abs();
            assert!(
                error <= bound,
                "{} at {at}: {value:?} is {truth:?}, bound {bound:e}",
                quantity.name
            );
        }
        counts
    }
}

#[test]
fn named_quantities_match_lecture_values() {
    let json = include_str!("../reference/lecture_values.json");
    let json: serde_json::Value = serde_json::from_str(json).unwrap();
    for (preset, at, part, points) in [
        (
            "four-bar",
            60.0,
            "B1",
            &[("B", "B"), ("C", "C"), ("G3", "r3.com"), ("G4", "r4.com")][..],
        ),
        (
            "slider-crank",
            30.0,
            "B2",
            &[("B", "B"), ("C", "C"), ("G", "r3.com")],
        ),
    ] {
        let bench = Bench::preset(preset);
        for (key, name) in points {
            let exact = |of: &str| -> f64 {
                let text = &json[part][*key][of];
                text.as_str().unwrap().parse().unwrap()
            };
            for (figure, value) in [
                ("v", exact("v")),
                ("a", exact("a")),
                ("a.angle", exact("a_dir_deg").rem_euclid(360.0)),
            ] {
                let found = bench.at(at, &format!("{name}.{figure}")).unwrap();
                let off = (found - value).abs() / value;
                assert!(
                    off < 1e-14,
                    "{preset} {name}.{figure}: {found}, not {value}"
                );
            }
        }
    }
    // The notes' printed values, to their digits.
    let bench = Bench::preset("four-bar");
    for (name, printed, rounding) in [
        ("B.a", 22500.0, 0.5),
        ("B.a.angle", 240.0, 0.005),
        ("C.a", 23994.18, 1.0),
        ("C.a.angle", 206.47, 0.005),
        ("C.a.t", 23875.0, 1.0),
        ("C.a.n", 2388.57, 0.2),
        ("r3.com.a", 22260.0, 0.5),
        ("r3.com.a.angle", 222.68, 0.005),
        ("r4.com.a", 11997.09, 0.5),
        ("r4.com.a.angle", 206.47, 0.005),
    ] {
        let found = bench.at(60.0, name).unwrap();
        assert!((found - printed).abs() < rounding, "{name}: {found}");
    }
}

/// The tangential part is the rate of the speed, and the normal part the rest; at zero speed there
/// are no parts.
#[test]
fn acceleration_splits_into_tangential_and_normal() {
    let mut bench = Bench::preset("four-bar");
    bench.catalogue.define("speed = hypot(C.vx, C.vy)").unwrap();
    for at in [0.0, 33.3, 60.0, 123.4, 300.0] {
        let [a, t, n, rate, direction] = ["C.a", "C.a.t", "C.a.n", "speed.rate", "C.v.angle"]
            .map(|name| bench.at(at, name).unwrap());
        assert!((t.hypot(n) - a).abs() < 1e-9 * a, "{at}");
        assert!((t - rate).abs() < 1e-9 * a, "{at}: {t} {rate}");
        let [vx, vy] = ["C.vx", "C.vy"].map(|name| bench.at(at, name).unwrap());
        let turned = vy.atan2(vx).to_degrees().rem_euclid(360.0);
        assert!(
            (direction - turned).abs() < 1e-9,
            "{at}: {direction} {turned}"
        );
    }
    assert_eq!(bench.at(60.0, "D.v"), Some(0.0));
    for name in ["D.v.angle", "D.a.angle", "D.a.t", "D.a.n"] {
        assert_eq!(bench.at(60.0, name), None, "{name}");
    }
}

#[test]
fn forces_have_magnitudes_and_directions() {
    let bench = Bench::preset("four-bar-load");
    for base in ["r3.B", "ground"] {
        let [x, y, size, direction] = ["fx", "fy", "f", "f.angle"]
            .map(|end| bench.at(77.0, &format!("{base}.{end}")).unwrap());
        assert_eq!(size, x.hypot(y), "{base}");
        let turned = y.atan2(x).to_degrees().rem_euclid(360.0);
        assert!((direction - turned).abs() < 1e-12, "{base}");
    }
    assert_eq!(bench.named("ground.f").unit, "N");
}

/// Rates of quantities in degrees are in rad/s, as for every direction; they equal the rates of the
/// operands.
#[test]
fn rates_of_formulas_are_exact() {
    let bench = Bench::preset("four-bar").with_formulas();
    for at in [10.0, 60.0, 200.0] {
        let of = |name: &str| bench.at(at, name).unwrap();
        assert_eq!(of("swing.rate"), of("r3.omega") - of("r2.omega"));
        assert_eq!(of("swing.accel"), of("r3.alpha") - of("r2.alpha"));
    }
    let unit = |name: &str| bench.named(name).unit;
    assert_eq!(
        [unit("swing"), unit("swing.rate"), unit("swing.accel")],
        ["deg", "rad/s", "rad/s^2"]
    );
    assert_eq!([unit("arc"), unit("arc.rate")], ["mm^2", "mm^2/s"]);
    assert_eq!(unit("share"), "1");
    // Compared with differences over time.
    let speed = 15.0_f64.to_degrees();
    for name in ["arc", "wave", "most", "lag"] {
        let (at, h) = (60.0, 1e-4);
        let turned = |v: f64| if name == "lag" { v.to_radians() } else { v };
        let read = |by: f64, of: &str| bench.at(at + by, of).unwrap();
        let rate = read(0.0, &format!("{name}.rate"));
        let secant = (turned(read(h, name)) - turned(read(-h, name))) * speed / (2.0 * h);
        assert!(
            (rate - secant).abs() < 1e-6 * (1.0 + rate.abs()),
            "{name}: {rate} {secant}"
        );
        let accel = read(0.0, &format!("{name}.accel"));
        let of = format!("{name}.rate");
        let secant = (read(h, &of) - read(-h, &of)) * speed / (2.0 * h);
        assert!(
            (accel - secant).abs() < 1e-6 * (1.0 + accel.abs()),
            "{name}: {accel} {secant}"
        );
    }
    // Accelerations have no rate in any state.
    assert!(bench.catalogue.find("share.rate").is_none());
    let output = bench
        .catalogue
        .select(&["share.rate"])
        .unwrap_err()
        .to_string();
    assert!(output.contains("the rate of C.ax is not known"), "{output}");
}

#[test]
fn every_unlisted_quantity_is_within_its_bound() {
    let mut unproved = 0;
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let bench = Bench::of(&scene);
        let (low, high) = match bench.solver.motion().range {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        };
        let mut counts = [0; 2];
        for k in 0..=60 {
            let [proved, open] = bench.check(low + (high - low) * f64::from(k) / 60.0);
            counts = [counts[0] + proved, counts[1] + open];
        }
        assert!(counts[0] > 500, "{}: {counts:?}", preset.name);
        unproved += counts[1];
    }
    // The direction is undefined where something is momentarily at rest.
    assert!(unproved < 300, "{unproved}");
}

/// Where a slider reverses, its speed is 0 up to rounding, within its bound.
#[test]
fn zero_speed_has_bound() {
    let bench = Bench::preset("slider-crank");
    for at in [0.0, 180.0, 180.000_000_1] {
        let (mut state, mut enclosure) = (bench.solver.state(), bench.solver.enclosure());
        let _ = bench.solver.solve(at, Order::Acceleration, &mut state);
        bench
            .solver
            .enclose(&mut state, Order::Acceleration, &mut enclosure);
        let speed = bench.named("C.v");
        let value = speed.value(&state).unwrap();
        let bound = speed.bound(&state, &enclosure).unwrap();
        assert!(bound < 1e-9 && value < 1e-3, "{at}: {value:e} +- {bound:e}");
        assert!(at > 180.0 || value <= bound, "{at}: {value:e} +- {bound:e}");
    }
}

/// The derivatives of a magnitude and a direction follow from those of the components.
#[test]
fn length_derivatives_of_magnitudes_follow_from_components() {
    let preset = presets::find("stephenson-six-bar").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let mut bench = Bench::of(&scene);
    let names: Vec<&str> = scene
        .mechanism
        .point_ids()
        .filter_map(|p| scene.point_name(p))
        .collect();
    let mut checked = 0;
    for name in names {
        let of = |end: &str| bench.named(&format!("{name}.{end}"));
        let mut quantities = ["vx", "vy", "v", "v.angle"].map(of).to_vec();
        bench.catalogue = Catalogue::new(&scene);
        let double = format!("twice = 2 * {name}.v");
        quantities.push(bench.catalogue.define(&double).unwrap());
        let at = scene.mechanism.driver().start;
        let mut sensitivity = Sensitivity::new(&scene, &bench.solver, &quantities);
        let found = sensitivity.at(at).unwrap();
        let mut state = bench.solver.state();
        let _ = bench.solver.solve(at, Order::Velocity, &mut state);
        let [x, y, size] = [0, 1, 2].map(|i: usize| quantities[i].value(&state).unwrap());
        if size == 0.0 {
            assert_eq!(found.of(2), None, "{name} stands still");
            continue;
        }
        let [dx, dy, dv, da, twice] = [0, 1, 2, 3, 4].map(|i| found.of(i).unwrap());
        let maximum = |all: &[f64]| all.iter().fold(0.0_f64, |maximum, d| maximum.max(d.abs()));
        for i in 0..dx.len() {
            let along = (x * dx[i] + y * dy[i]) / size;
            let turned = ((x * dy[i] - y * dx[i]) / size / size).to_degrees();
            assert!(
                (dv[i] - along).abs() <= 1e-11 * maximum(dv),
                "{name} by {i}"
            );
            assert!(
                (da[i] - turned).abs() <= 1e-11 * maximum(da),
                "{name} by {i}"
            );
            assert!(
                (twice[i] - 2.0 * dv[i]).abs() <= 1e-11 * maximum(twice),
                "{name} by {i}"
            );
            checked += 1;
        }
    }
    assert!(checked > 20, "{checked}");
}

fn four_bar([a, b, c, d]: [f64; 4]) -> String {
    format!(
        "[ground]\nA = [0, 0]\nD = [{d}, 0]\n[driver]\nlink = \"r2\"\nangle = 60\nspeed = \"15 rad/s\"\n[links]\n\
         r2 = {{ from = \"A\", to = \"B\", length = {a} }}\nr3 = {{ from = \"B\", to = \"C\", length = {b} }}\n\
         r4 = {{ from = \"D\", to = \"C\", length = {c} }}\n[start]\nC = [{d}, {c}]\n"
    )
}

proptest! {
    #[test]
    fn random_four_bar_quantities_are_within_their_bound(
        sizes in [20.0..120.0_f64, 150.0..400.0, 150.0..400.0, 150.0..400.0],
        coordinates in prop::collection::vec(-400.0..400.0_f64, 8),
    ) {
        let scene = Scene::parse(&four_bar(sizes), "random").unwrap();
        if Solver::new(&scene.mechanism).is_ok() {
            let bench = Bench::of(&scene).with_formulas();
            for at in coordinates {
                bench.check(at);
            }
        }
    }
}
