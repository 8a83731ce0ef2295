//! Tests copies and mirror images of groups of links.

use krank::quantity::Catalogue;
use krank::scene::{Precision, Scene, presets};
use krank::solver::{Condition, Order, Solver, State};
use krank::study::{CycleFigure, DesignFigures, DesignRow, DesignSpace, DesignState};
use krank::{LinkId, PointId, Vec2};

fn parsed(text: &str) -> Scene {
    match Scene::parse(text, "test") {
        Ok(scene) => scene,
        Err(faults) => panic!("{faults}"),
    }
}

fn preset(name: &str) -> Scene {
    parsed(presets::find(name).unwrap().text)
}

fn point(scene: &Scene, name: &str) -> PointId {
    let mut points = scene.mechanism.point_ids();
    let found = points.find(|&point| scene.point_name(point) == Some(name));
    found.unwrap_or_else(|| panic!("no point {name}"))
}

fn link(scene: &Scene, name: &str) -> LinkId {
    let mut links = scene.mechanism.link_ids();
    links.find(|&link| scene.link_name(link) == name).unwrap()
}

/// Returns the distance of a link's ends.
fn length(scene: &Scene, name: &str) -> f64 {
    let link = scene.mechanism.link(link(scene, name));
    let (_, to) = link.ends.unwrap();
    link.local(to).unwrap().x
}

fn solved(scene: &Scene, at: f64) -> State {
    let solver = Solver::new(&scene.mechanism).unwrap();
    let mut state = solver.state();
    assert_eq!(
        solver.solve(at, Order::Acceleration, &mut state),
        Condition::Ok
    );
    state.into_state()
}

fn position(scene: &Scene, state: &State, name: &str) -> Vec2 {
    state.position(point(scene, name)).unwrap()
}

/// Asserts that two scenes have the same names, and the same positions at these coordinates.
#[track_caller]
fn assert_equal(copied: &Scene, typed: &Scene, coordinates: &[f64]) {
    let names = |scene: &Scene| -> Vec<String> {
        let mut names: Vec<String> = scene.listed_points().map(|(_, n)| n.to_owned()).collect();
        names.extend(
            scene
                .mechanism
                .link_ids()
                .map(|id| scene.link_name(id).to_owned()),
        );
        names.extend(
            scene
                .mechanism
                .slide_ids()
                .map(|id| scene.slide_name(id).to_owned()),
        );
        names.sort();
        names
    };
    assert_eq!(names(copied), names(typed));
    for &at in coordinates {
        let [found, expected] = [copied, typed].map(|scene| solved(scene, at));
        for (_, name) in typed.listed_points() {
            let found = position(copied, &found, name);
            let expected = position(typed, &expected, name);
            let size = expected.norm().max(1.0);
            assert!(
                (found - expected).norm() <= 1e-14 * size,
                "{name} at {at}: {found:?}, {expected:?}"
            );
        }
    }
}

/// The five cylinders as typed before krank had copies.
const RADIAL: &str = r#"
unit = "mm"
[ground]
A = [0, 0]
[driver]
link  = "r2"
angle = 60
[links]
r2     = { from = "A", to = "B", length = 70 }
master = { from = "B", to = "P1", length = 250, points = { K2 = { length = 50, angle = 72 }, K3 = { length = 50, angle = 144 }, K4 = { length = 50, angle = -144 }, K5 = { length = 50, angle = -72 } } }
l2 = { from = "K2", to = "P2", length = 200 }
l3 = { from = "K3", to = "P3", length = 200 }
l4 = { from = "K4", to = "P4", length = 200 }
l5 = { from = "K5", to = "P5", length = 200 }
[slides]
s1 = { point = "P1", on = "ground", through = "A", angle = 90 }
s2 = { point = "P2", on = "ground", through = "A", angle = 162 }
s3 = { point = "P3", on = "ground", through = "A", angle = 234 }
s4 = { point = "P4", on = "ground", through = "A", angle = 306 }
s5 = { point = "P5", on = "ground", through = "A", angle = 18 }
[start]
P1 = [0, 310]
P2 = [-214, 70]
P3 = [-106, -146]
P4 = [122, -168]
P5 = [280, 91]
"#;

#[test]
fn turned_copies_with_a_phase_equal_typed_cylinders() {
    let coordinates = [0.0, 60.0, 133.0, 250.0];
    assert_equal(&preset("radial-engine"), &parsed(RADIAL), &coordinates);
}

/// Each further stage of a lift stands on the one before. The platform of ten stages is 20 m times
/// the sine of the angle high: the bars are 2 m long, and the right foot is at their cosine.
#[test]
fn joined_copies_equal_typed_stages() {
    let typed = r#"
unit = "m"
[ground]
O = [0, 0]
[driver]
slide    = "floor"
position = 1.7
[links]
a1 = { from = "O",  to = "R1", length = 2, points = { M1 = [1, 0] } }
b1 = { from = "R0", to = "L1", length = 2, points = { M1 = [1, 0] } }
a2 = { from = "L1", to = "R2", length = 2, points = { M2 = [1, 0] } }
b2 = { from = "R1", to = "L2", length = 2, points = { M2 = [1, 0] } }
a3 = { from = "L2", to = "R3", length = 2, points = { M3 = [1, 0] } }
b3 = { from = "R2", to = "L3", length = 2, points = { M3 = [1, 0] } }
[slides]
floor = { point = "R0", on = "ground", through = "O", angle = 0 }
[start]
M1 = [0.85, 0.53]
M2 = [0.85, 1.58]
M3 = [0.85, 2.63]
"#;
    let lift = presets::find("scissor-lift").unwrap().text;
    let short = lift
        .replace("count = 9", "count = 2")
        .replace("\"L10\", \"R10\"", "\"L3\", \"R3\"");
    assert_equal(&parsed(&short), &parsed(typed), &[0.3, 1.2, 1.7]);
    let scene = preset("scissor-lift");
    let state = solved(&scene, 1.2);
    let top = position(&scene, &state, "L10");
    assert!((top - Vec2::new(0.0, 16.0)).norm() < 1e-12, "{top:?}");
}

/// Jansen's leg with a second one on the same crank. It opens near the reflection of the leg at
/// `crank` minus the driver's angle of 60 degrees.
fn two_legs(placement: &str, crank: f64) -> Scene {
    let leg = presets::find("jansen-leg").unwrap().text;
    let (scene, mut start) = (parsed(leg), String::from("[start]\n"));
    let reflected = solved(&scene, crank - 60.0);
    for name in ["X", "Y", "V"] {
        let at = position(&scene, &reflected, name);
        start += &format!("{name}_left = [{:.0}, {:.0}]\n", -at.x, at.y);
    }
    let leg = leg.replace("[start]\n", &start);
    parsed(&format!(
        "{leg}\n[copies]\nleft = {{ of = [\"j\", \"bde\", \"k\", \"c\", \"f\", \"ghi\"], {placement} }}\n"
    ))
}

/// The mirror image of the leg sees the crank at 180 degrees minus its angle; with a phase of 180
/// degrees at minus the angle.
#[test]
fn mirror_image_of_a_leg_moves_as_its_reflection() {
    for (phase, crank) in [(0.0, 180.0), (180.0, 0.0), (90.0, 90.0)] {
        let scene = two_legs(&format!("mirror = \"y\", phase = {phase:?}"), crank);
        assert_eq!(scene.original_of("j_left"), Some("j"));
        assert_eq!(scene.original_of("j"), None);
        for at in [0.0, 60.0, 200.0] {
            let (state, reflected) = (solved(&scene, at), solved(&scene, crank - at));
            for name in ["X", "Y", "V", "W", "T"] {
                let found = position(&scene, &state, &format!("{name}_left"));
                let original = position(&scene, &reflected, name);
                let expected = Vec2::new(-original.x, original.y);
                assert!(
                    (found - expected).norm() < 1e-12,
                    "{name}: {found:?}, {expected:?}"
                );
            }
        }
    }
    // The pivot is mirrored, the centre of the crank stays, and without a phase so does its pin.
    let scene = two_legs("mirror = \"y\"", 180.0);
    let names: Vec<&str> = scene.listed_points().map(|(_, name)| name).collect();
    assert!(names.contains(&"P_left"), "{names:?}");
    assert!(
        !names.contains(&"O_left") && !names.contains(&"M_left"),
        "{names:?}"
    );
    let pivot = scene.mechanism.point(point(&scene, "P_left")).ground;
    assert_eq!(pivot, Some(Vec2::new(38.0, -7.8)));
    // The local y axis of a mirror image points the other way.
    let corner = |link_name: &str, name: &str| {
        let link = scene.mechanism.link(link(&scene, link_name));
        link.local(point(&scene, name)).unwrap()
    };
    let (original, copy) = (corner("bde", "W"), corner("bde_left", "W_left"));
    assert_eq!(copy, Vec2::new(original.x, -original.y));
}

const FOUR_BAR: &str = r#"
[ground]
A = [0, 0]
D = [400, 0]
[driver]
link  = "r2"
angle = 60
speed = "1 rad/s"
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300, points = { E = [150, 80] } }
r4 = { from = "C", to = "D", length = 250 }
[start]
C = [311, 233]
E = [80, 190]
"#;

/// A copied crank follows the driver: as a mirror image in the other direction.
#[test]
fn copy_of_the_driven_link_follows_the_driver() {
    let all = "of = [\"r2\", \"r3\", \"r4\"]";
    for (placement, start, angle, speed) in [
        ("move = [0, 900]", "", 60.0_f64, 1.0),
        (
            "turn = 30, about = \"D\", phase = 20",
            "C_b = [192, 139]\n",
            110.0,
            1.0,
        ),
        ("mirror = \"x\", about = [0, 300]", "", -60.0, -1.0),
        (
            "mirror = \"y\", about = [700, 0], phase = 5",
            "C_b = [1085, 235]\n",
            125.0,
            -1.0,
        ),
    ] {
        let scene = parsed(&format!(
            "{FOUR_BAR}{start}[copies]\nb = {{ {all}, {placement} }}\n"
        ));
        let crank = link(&scene, "r2_b");
        let state = solved(&scene, 60.0);
        let direction = state.direction(crank).unwrap();
        let expected = Vec2::new(angle.to_radians().cos(), angle.to_radians().sin());
        assert!(
            (direction - expected).norm() < 1e-14,
            "{placement}: {direction:?}"
        );
        let found = state.omega(crank).unwrap();
        assert!((found - speed).abs() < 1e-14, "{placement}: {found}");
    }
    // An input in the file takes precedence.
    let held = "C_b = [322, 1137]\n[inputs]\nr2_b = { at = 40 }\n";
    let scene = parsed(&format!(
        "{FOUR_BAR}{held}[copies]\nb = {{ {all}, move = [0, 900] }}\n"
    ));
    let state = solved(&scene, 60.0);
    assert_eq!(state.omega(link(&scene, "r2_b")), Some(0.0));
}

/// A change of the original changes its copies, which have no values of their own.
#[test]
fn values_of_copies_are_those_of_their_originals() {
    let scene = two_legs("mirror = \"y\", phase = 180", 0.0);
    let value = scene.value_named("j.length").unwrap();
    let changed = parsed(&scene.with_value(&value, "51"));
    for name in ["j", "j_left"] {
        assert_eq!(length(&changed, name), 51.0, "{name}");
    }
    let refused = scene.value_named("j_left.length").unwrap_err();
    assert_eq!(refused, "j_left is a copy; change j instead");
    let refused = scene.value_named("P_left.x").unwrap_err();
    assert_eq!(refused, "P_left is a copy; change P instead");
    let phase = scene.value_named("left.phase").unwrap();
    assert_eq!((phase.number, phase.unit), (180.0, "deg"));
    let turned = parsed(&scene.with_value(&phase, "120"));
    let state = solved(&turned, 60.0);
    let pin = position(&turned, &state, "M_left");
    assert!((pin - Vec2::new(-15.0, 0.0)).norm() < 1e-13, "{pin:?}");
}

/// Regression: the position of the original, which has another crank angle, chose the other assembly
/// of the copy. Positions of a copy in the file choose it, such as those of a saved assembly.
#[test]
fn copies_with_a_phase_need_their_own_positions() {
    let text = format!("{FOUR_BAR}[copies]\nb = {{ of = [\"r3\", \"r4\"], phase = 90 }}\n");
    let scene = parsed(&text);
    assert_eq!(scene.mechanism.start().len(), 2);
    assert!(Solver::new(&scene.mechanism).is_err());
    let start = [(point(&scene, "C_b"), Vec2::new(250.0, -200.0))];
    let saved = scene.rewritten(&start, None, Precision::Rough).unwrap();
    assert!(saved.ends_with("E = [80, 190]\nC_b = [250, -200]\n[copies]\nb = { of = [\"r3\", \"r4\"], phase = 90 }\n"), "{saved}");
    let again = parsed(&saved);
    let start: Vec<Vec2> = {
        let all = again.mechanism.start().iter();
        let own = all.filter(|(id, _)| again.point_name(*id) == Some("C_b"));
        own.map(|(_, at)| *at).collect()
    };
    assert_eq!(start, [Vec2::new(250.0, -200.0)]);
    let state = solved(&again, 60.0);
    assert!(position(&again, &state, "C_b").y < 0.0);
}

/// The shape of a copy is that of the original, even where its positions in `[start]` differ.
#[test]
fn copies_of_drawn_links_keep_their_shape() {
    let scene = parsed(
        r#"
[ground]
A = [0, 0]
D = [4, 0]
[driver]
link = "r2"
[links]
r2 = { points = ["A", "B"] }
r3 = { points = ["B", "C", "P"] }
r4 = { points = ["C", "D"] }
[copies]
b = { of = ["r3", "r4"], turn = 50, phase = 50 }
[start]
B = [0.6, 0.8]
C = [3.6, 4.8]
P = [2.5, 1.4]
P_b = [2, 2]
"#,
    );
    for (original, copy) in [("r3", "r3_b"), ("r4", "r4_b")] {
        assert_eq!(length(&scene, original), length(&scene, copy));
    }
    let shape = |link_name: &str, name: &str| {
        let link = scene.mechanism.link(link(&scene, link_name));
        link.local(point(&scene, name)).unwrap()
    };
    assert_eq!(shape("r3", "P"), Vec2::new(1.62, -1.16));
    assert_eq!(shape("r3_b", "P_b"), Vec2::new(1.62, -1.16));
}

/// Returns the rows of the designs of a four-bar's copy in which one value has these numbers.
fn designs(copy: &str, value: &str, numbers: &[f64], figures: &[&str]) -> Vec<DesignRow> {
    let start = "C_b = [246, 271]\n";
    let scene = parsed(&format!("{FOUR_BAR}{start}[copies]\nb = {{ {copy} }}\n"));
    let solver = Solver::new(&scene.mechanism).unwrap();
    let values = vec![scene.value_named(value).unwrap()];
    let space = DesignSpace::new(&scene, &solver, values);
    let catalogue = Catalogue::new(&scene);
    let figures = figures
        .iter()
        .map(|name| CycleFigure::parse(name, &catalogue).unwrap());
    let mut figures = DesignFigures::new(&space, figures.collect(), None);
    let rows = numbers
        .iter()
        .map(|&number| DesignRow::of(vec![number], &mut figures));
    rows.collect()
}

/// A design whose number changes the elements of the copies has no figures: without `turn` the copy
/// shares D, with it the copy has D_b. The figures of other designs are those of a typed scene.
#[test]
fn designs_with_other_elements_have_no_figures() {
    let of = "of = [\"r3\", \"r4\"], about = \"A\", phase = 30";
    let strokes = ["C_b.x.stroke", "C_b.x@60"];
    let turned = |turn: &str| format!("{of}, turn = {turn}");
    for (given, numbers) in [("0", [5.0, 10.0]), ("10", [0.0, 360.0])] {
        for row in designs(&turned(given), "b.turn", &numbers, &strokes) {
            assert_eq!(row.state, DesignState::NoAssembly, "{given}: {row:?}");
            assert!(row.reason.contains("[copies]"), "{row:?}");
            assert!(row.figures.is_empty(), "{row:?}");
        }
    }
    let rows = designs(&turned("10"), "b.turn", &[5.0, 20.0], &strokes);
    for (row, turn) in rows.iter().zip(["5", "20"]) {
        let typed = &designs(&turned(turn), "b.turn", &[turn.parse().unwrap()], &strokes)[0];
        assert_eq!(row.state, DesignState::Ok, "{row:?}");
        for i in 0..strokes.len() {
            let (found, expected) = (row.figure(i).unwrap(), typed.figure(i).unwrap());
            assert!(
                (found - expected).abs() < 1e-9 * expected.abs(),
                "{found} {expected}"
            );
        }
    }
    let copies = "of = [\"r2\", \"r3\", \"r4\"], move = [0, 900], count = 3";
    let rows = designs(copies, "b.count", &[1.0, 2.0, 3.0], &["C_b.x.stroke"]);
    let states: Vec<DesignState> = rows.iter().map(|row| row.state).collect();
    let other = DesignState::NoAssembly;
    assert_eq!(states, [other, other, DesignState::Ok]);
}

/// A point named in `of` keeps its name, but with `phase` it is on the crank.
#[test]
fn elements_differ_if_a_point_is_on_another_link() {
    let with = |phase: &str| {
        let of = "of = [\"r3\", \"r4\", \"B\"], move = [9, 0]";
        let copies = format!("[copies]\nb = {{ {of}, phase = {phase} }}\n");
        parsed(&format!("{FOUR_BAR}{copies}"))
    };
    assert!(with("30").has_elements_of(&with("40")));
    assert!(!with("30").has_elements_of(&with("0")));
}

/// A key that is no part of a name is reported once, not for each copied element.
#[test]
fn invalid_key_is_reported_once() {
    let copies = "[copies]\n\"a b\" = { of = [\"r3\", \"r4\"], phase = 90 }\n";
    let faults = Scene::parse(&format!("{FOUR_BAR}{copies}"), "test").unwrap_err();
    assert_eq!(
        faults.to_string().matches("contains ` `").count(),
        1,
        "{faults}"
    );
}

/// Copies by `phase` around a full turn are accepted up to the original.
#[test]
fn copies_around_a_turn_end_before_the_original() {
    let copies = |count: usize| {
        let of = "of = [\"r3\", \"r4\"], phase = 72";
        Scene::parse(
            &format!("{FOUR_BAR}[copies]\nb = {{ {of}, count = {count} }}\n"),
            "test",
        )
    };
    assert!(copies(4).is_ok());
    let refused = copies(5).unwrap_err().to_string();
    assert!(
        refused.contains("copy number 5 lies on the original"),
        "{refused}"
    );
}
