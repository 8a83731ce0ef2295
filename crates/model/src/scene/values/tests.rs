use super::*;
use crate::scene::presets;
use proptest::prelude::*;

/// A scene with every notation, a byte order mark, and CRLF line breaks.
const ALL: &str = "\u{feff}# mine\r\nunit = \"cm\"\r\ngravity = [ 0, -9.81 ] # down\r\n\
    [ground]\r\nA = [0, 0.0]\r\nD = [4_0, 0] # right\r\n\
    driver = 1\r\n";

fn names(text: &str) -> Vec<String> {
    let values = Scene::parse(text, "test").unwrap().values();
    let shown = |v: &Value| format!("{} = {} {}", v.name, v.literal, v.unit);
    values.iter().map(shown).collect()
}

#[test]
fn values_list_every_number_with_unit_in_file_order() {
    let four_bar = presets::find("four-bar").unwrap();
    assert_eq!(
        names(four_bar.text),
        [
            "A x = 0 mm",
            "A y = 0 mm",
            "D x = 400 mm",
            "D y = 0 mm",
            "driver angle = 60 deg",
            "driver speed = 15 rad/s",
            "r2 length = 100 mm",
            "r2 com x = 0 mm",
            "r2 com y = 0 mm",
            "r3 length = 300 mm",
            "r3 com x = 150 mm",
            "r3 com y = 0 mm",
            "r4 length = 250 mm",
            "r4 com x = 125 mm",
            "r4 com y = 0 mm",
            "C start x = 310 mm",
            "C start y = 230 mm",
        ]
    );
}

/// Dotted keys, inline tables, several loads, escapes in strings and a byte order mark: only the
/// number changes.
#[test]
fn with_value_replaces_number_in_every_notation() {
    let text = ALL.replace(
        "driver = 1\r\n",
        "[driver]\r\nlink = \"r2\"\r\nangle = +6e1\r\nspeed = \"1\\u0035 rad/s\" # fast\r\nacceleration = ' 2 deg/s^2'\r\n\
        [links]\r\nr2.from = \"A\"\r\nr2.to = \"B\"\r\nr2.length = 10 # crank\r\nr2.com = [5, 0]\r\nr2.mass = 1.50\r\n\
        r3 = { from = \"B\", to = \"C\", length = 30, points = { P = [15, 8] } }\r\n\
        [links.r4]\r\nfrom = \"C\"\r\nto = \"D\"\r\nlength = 25\r\n\
        [start]\r\nC = [31, 23]\r\n\
        [[loads]]\r\npoint = \"P\"\r\nforce = [1, 2]\r\n[[loads]]\r\npoint = \"P\"\r\nforce = [3, 4]\r\n\
        [[loads]]\r\nlink = \"r4\"\r\ntorque = 1_000.5\r\n",
    );
    let scene = Scene::parse(&text, "test").unwrap();
    let changed = |name: &str, by: &str| {
        let values = scene.values();
        let value = values.iter().find(|v| v.name == name).unwrap();
        scene.with_value(value, by)
    };
    let without_mark = text.strip_prefix('\u{feff}').unwrap();
    for (name, by, from, to) in [
        ("gravity y", "-1", "-9.81 ]", "-1 ]"),
        ("D x", "41", "4_0,", "41,"),
        ("driver angle", "7", "+6e1", "7"),
        ("driver speed", "3 rpm", "\"1\\u0035 rad/s\"", "\"3 rpm\""),
        (
            "driver acceleration",
            "0 rad/s^2",
            "' 2 deg/s^2'",
            "'0 rad/s^2'",
        ),
        ("r2 length", "11", "10 #", "11 #"),
        ("r2 mass", "2", "1.50", "2"),
        ("r3 P y", "9.5", "[15, 8]", "[15, 9.5]"),
        ("r4 length", "26", "length = 25", "length = 26"),
        ("C start x", "32", "[31,", "[32,"),
        ("P force x (2)", "5", "[3,", "[5,"),
        ("r4 torque", "7", "1_000.5", "7"),
    ] {
        let expected = without_mark.replacen(from, to, 1);
        assert_ne!(expected, without_mark);
        assert_eq!(changed(name, by), expected, "{name}");
        assert!(Scene::parse(&expected, "test").is_ok(), "{name}");
    }
}

/// A scene with repeated loads, knots, springs and a motor; its link is called `motor`.
const LOADED: &str = "[ground]\nA = [0, 0]\n[driver]\nlink = \"motor\"\nangle = 0\n\
    [links]\nmotor = { from = \"A\", to = \"B\", length = 1, com = [0, 0] }\n\
    rod = { from = \"B\", to = \"C\", length = 3 }\n\
    [slides]\nram = { point = \"C\", on = \"ground\", through = [0, 0] }\n[start]\nC = [4, 0]\n\
    [[loads]]\npoint = \"C\"\nforce = [1, 2]\n\
    [[loads]]\npoint = \"C\"\nforce = [3, 4]\nframe = \"rod\"\nover = [[0, 5], [90, 6]]\n\
    [[loads]]\nlink = \"motor\"\ntorque = 7\nover = [[0, 8], [90, 9]]\n\
    [[loads]]\nslide = \"ram\"\nend = \"least\"\npress = [[2, 0], [0.0, 10]]\n\
    [[springs]]\nfrom = \"A\"\nto = \"C\"\nstiffness = 11\n\
    [[springs]]\nfrom = \"A\"\nto = \"C\"\nlength = 0\ndamping = 12\n\
    [[springs]]\nfrom = \"A\"\nto = \"C\"\npreload = 19\n\
    [[springs]]\nfrom = \"A\"\nto = \"C\"\nforce = [[20, 21], [20, 22]]\n\
    [[springs]]\nlink = \"rod\"\nstiffness = 23\ndamping = 24\n\
    [[springs]]\nlink = \"rod\"\nto = \"motor\"\nangle = 25\npreload = 26\n\
    [motor]\ntorque = 13\npeak = 14\nspeed = '15 rpm'\nflywheel = 16\nfluctuation = 0.17\ntolerance = 18\n";

/// Numeric tolerances are named after their owner. A class is text and not listed.
#[test]
fn values_list_numeric_tolerances_and_clearances() {
    let text = "tolerance = 1\nclearance = 2\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r\"\nangle = 0\n\
        [links]\nr = { from = \"A\", to = \"B\", length = 10, tolerance = 3 }\n\
        s = { from = \"B\", to = \"C\", length = 30, tolerance = \"ISO 2768-m\" }\n\
        [slides]\nram = { point = \"C\", on = \"ground\", through = [0, 0], tolerance = 4 }\n\
        [start]\nC = [40, 0]\n[tolerances]\nA = 5\n[clearances]\nB = 0.5\n";
    let found = names(text);
    let is_off = |name: &&String| name.contains("tolerance") || name.contains("clearance");
    let found: Vec<&String> = found.iter().filter(is_off).collect();
    let expected = [
        "tolerance = 1 mm",
        "clearance = 2 mm",
        "r tolerance = 3 mm",
        "ram tolerance = 4 mm",
        "A tolerance = 5 mm",
        "B clearance = 0.5 mm",
    ];
    assert_eq!(found, expected);
}

#[test]
fn values_list_loads_springs_and_motor() {
    let found = names(LOADED);
    let first = found.iter().position(|n| n == "C force x = 1 N").unwrap();
    assert_eq!(
        found[first..],
        [
            "C force x = 1 N",
            "C force y = 2 N",
            "C force x (2) = 3 N",
            "C force y (2) = 4 N",
            "C force knot 1 at (2) = 0 deg",
            "C force knot 1 factor (2) = 5 ",
            "C force knot 2 at (2) = 90 deg",
            "C force knot 2 factor (2) = 6 ",
            "motor torque = 7 N m",
            "motor torque knot 1 at = 0 deg",
            "motor torque knot 1 factor = 8 ",
            "motor torque knot 2 at = 90 deg",
            "motor torque knot 2 factor = 9 ",
            "ram press knot 1 at = 2 mm",
            "ram press knot 1 size = 0 N",
            "ram press knot 2 at = 0.0 mm",
            "ram press knot 2 size = 10 N",
            "spring A-C stiffness = 11 N/m",
            "spring A-C length (2) = 0 mm",
            "spring A-C damping (2) = 12 N s/m",
            "spring A-C preload (3) = 19 N",
            "spring A-C force knot 1 at (4) = 20 mm",
            "spring A-C force knot 1 size (4) = 21 N",
            "spring A-C force knot 2 at (4) = 20 mm",
            "spring A-C force knot 2 size (4) = 22 N",
            "spring rod-ground stiffness = 23 N m/rad",
            "spring rod-ground damping = 24 N m s/rad",
            "spring rod-motor angle = 25 deg",
            "spring rod-motor preload = 26 N m",
            // A link has the same name.
            "motor torque (2) = 13 N m",
            "motor peak = 14 N m",
            "motor speed = 15 rpm",
            "motor flywheel = 16 kg m^2",
            "motor fluctuation = 0.17 ",
            "motor tolerance = 18 mm",
        ]
    );
}

#[test]
fn with_value_changes_loads_springs_and_motor_in_place() {
    let scene = Scene::parse(LOADED, "test").unwrap();
    let mut read_again = 0;
    for value in scene.values() {
        assert_eq!(
            scene.with_value(&value, &value.text()),
            LOADED,
            "{}",
            value.name
        );
        let other = value.moved(1.0, 0.25);
        let changed = scene.with_value(&value, &other);
        let Ok(again) = Scene::parse(&changed, "test") else {
            // Two knots at the same coordinate, or a point off its guide.
            continue;
        };
        let found = again.values().into_iter().find(|v| v.name == value.name);
        assert_eq!(found.unwrap().text(), other);
        read_again += 1;
    }
    assert!(read_again >= 26, "{read_again}");
    let pushed = LOADED
        .replace(
            "link = \"motor\"\nangle = 0\n",
            "slide = \"ram\"\nposition = 3\n",
        )
        .replace("torque = 13", "force = 13")
        .replace("15 rpm", "15 mm/s")
        .replace("flywheel = 16\nfluctuation = 0.17\n", "");
    let found = names(&pushed);
    for line in [
        "C force knot 2 at (2) = 90 mm",
        "motor force = 13 N",
        "motor peak = 14 N",
        "motor speed = 15 mm/s",
    ] {
        assert!(found.iter().any(|n| n == line), "{line} in {found:?}");
    }
}

/// A changed scene keeps its notation.
#[test]
fn polar_places_are_changed_in_polar_form() {
    let seen = "points = { E = { from = \"C\", length = 180.0, angle = 72 } }, com = { length = 15, angle = 5 }";
    let text = presets::find("four-bar").unwrap().text;
    let text = text.replace("com = [150, 0]", seen);
    let found = names(&text);
    for line in [
        "r3 E length = 180.0 mm",
        "r3 E angle = 72 deg",
        "r3 com length = 15 mm",
        "r3 com angle = 5 deg",
    ] {
        assert!(found.iter().any(|n| n == line), "{line} in {found:?}");
    }
    assert!(!found.iter().any(|n| n.starts_with("r3 E x")), "{found:?}");
    let scene = Scene::parse(&text, "test").unwrap();
    let values = scene.values();
    let value = |name: &str| values.iter().find(|v| v.name == name).unwrap();
    let turned = value("r3 E angle").typed("1.2 rad").unwrap();
    let longer = value("r3 E length").moved(1.0, 0.5);
    let changed = scene.with_values(&[
        (value("r3 E angle").clone(), turned),
        (value("r3 E length").clone(), longer),
    ]);
    let expected = text.replace(
        "length = 180.0, angle = 72",
        "length = 180.5, angle = 68.75493541569878",
    );
    assert_eq!(changed, expected);
    assert_eq!(value("r3 E angle").owner, ValueOwner::Element("E".into()));
}

#[test]
fn values_list_slides_and_driver_position() {
    let text = presets::find("slider-crank").unwrap().text;
    assert!(
        names(text).iter().any(|n| n.starts_with("r4 angle = ")),
        "{:?}",
        names(text)
    );
    let boom = presets::find("excavator-boom").unwrap().text;
    assert!(names(boom).contains(&"driver position = 2.0 m".to_owned()));
    assert!(names(boom).contains(&"driver speed = 0.15 m/s".to_owned()));
    assert!(names(boom).contains(&"boom T x = 5.6 m".to_owned()));
}

#[test]
fn preset_values_replaced_by_own_text_change_nothing() {
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let values = scene.values();
        let mut places: Vec<_> = values.iter().map(|v| v.place.clone()).collect();
        places.dedup_by(|later, earlier| later.start < earlier.end);
        assert_eq!(
            places.len(),
            values.len(),
            "places of {} overlap",
            preset.name
        );
        for value in &values {
            assert_eq!(
                scene.with_value(value, &value.text()),
                scene.text(),
                "{}",
                value.name
            );
            let typed = value.typed(&value.literal).unwrap();
            let again = scene.with_value(value, &typed);
            let again = Scene::parse(&again, preset.name).unwrap();
            let found = again.values().into_iter().find(|v| v.name == value.name);
            assert_eq!(found.unwrap().number, value.number);
        }
    }
}

proptest! {
    /// Replacing a value by any text changes no byte around it.
    #[test]
    fn with_value_keeps_all_other_bytes(preset in 0..presets::all().len(), at in 0_usize..1000, text in "\\PC{0,12}") {
        let preset = &presets::all()[preset];
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let values = scene.values();
        let value = &values[at % values.len()];
        let changed = scene.with_value(value, &text);
        prop_assert_eq!(&changed[..value.place.start], &scene.text()[..value.place.start]);
        prop_assert!(changed.ends_with(&scene.text()[value.place.end..]));
        // Neither parsing nor typing it panics.
        let _ = Scene::parse(&changed, preset.name);
        let _ = value.typed(&text);
    }

    /// A step and the opposite step restore the number.
    #[test]
    fn step_and_opposite_step_restore_number(number in -1e6_f64..1e6, exponent in -6_i32..3) {
        let text = presets::find("four-bar").unwrap().text;
        let number = (number * 1e3).round() / 1e3;
        let scene = Scene::parse(&text.replace("A = [0, 0]", &format!("A = [{number:?}, 0]")), "t").unwrap();
        let value = &scene.values()[0];
        let step: f64 = format!("2e{exponent}").parse().unwrap();
        let there = Value { number: value.moved(1.0, step).parse().unwrap(), ..value.clone() };
        prop_assert_eq!(there.moved(-1.0, step).parse::<f64>().unwrap(), number);
    }
}

/// A scene with a formula for every number, and the equivalent scene with numbers.
const BY_FORMULAS: &str = r#"unit = "mm"
gravity = [0, "-g"]
[parameters]
rod = "2 * a + crank"
a = 100
crank = "0.1 * a + 0.2 * a + 70"
g = 9.81
n = 30
[ground]
A = [0, "a - 100"]
D = ["4 * a", "sin(0)"]
[driver]
link = "r2"
angle = "atan2(3, 3) + 15 deg"
speed = "2 * n rpm"
acceleration = "(n / 10) rad/s^2"
[links]
r2 = { from = "A", to = "B", length = "crank" }
r3 = { from = "B", to = "C", length = "rod", com = ["rod / 2", 0], mass = "a / 50", inertia = "0.1 * 0.1" }
r4 = { from = "C", to = "D", length = "10 in - 4 mm", points = { P = { length = "a", angle = "acos(0.5)" } } }
[start]
C = ["3 * a + 10", 230]
[[loads]]
point = "C"
force = ["-5 * a", "hypot(3, 4)"]
over = [["0", 1], ["n * 6", 0.5], ["360 deg", "1"]]
[[loads]]
link = "r4"
torque = "a / 8"
[[springs]]
from = "A"
to = "C"
stiffness = "1 N/m * a * 10"
length = "sqrt(a) + 1 cm"
damping = "a"
[motor]
torque = "n"
peak = "3 * n"
speed = "100 * n / 2 rpm"
"#;

const BY_NUMBERS: &str = r#"unit = "mm"
gravity = [0, -9.81]
[ground]
A = [0, 0]
D = [400, 0]
[driver]
link = "r2"
angle = 60
speed = "60 rpm"
acceleration = "3 rad/s^2"
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300, com = [150, 0], mass = 2, inertia = 0.01 }
r4 = { from = "C", to = "D", length = 250, points = { P = { length = 100, angle = 60 } } }
[start]
C = [310, 230]
[[loads]]
point = "C"
force = [-500, 5]
over = [[0, 1], [180, 0.5], [360, 1]]
[[loads]]
link = "r4"
torque = 12.5
[[springs]]
from = "A"
to = "C"
stiffness = 1000
length = 20
damping = 100
[motor]
torque = 30
peak = 90
speed = "1500 rpm"
"#;

/// Formats a mechanism with enough digits to identify every double.
fn to_the_bit(scene: &Scene) -> String {
    format!("{:?}", scene.mechanism)
}

#[test]
fn formulas_are_accepted_wherever_numbers_are() {
    let [formulas, numbers] = [BY_FORMULAS, BY_NUMBERS].map(|text| {
        let scene = Scene::parse(text, "test");
        scene.unwrap_or_else(|faults| panic!("{}", faults.render(true, false)))
    });
    assert_eq!(to_the_bit(&formulas), to_the_bit(&numbers));
    assert_eq!(formulas.motor, numbers.motor);
    let values = |scene: &Scene| -> Vec<(String, f64)> {
        let values = scene.values().into_iter();
        let own = values.filter(|value| value.measure != Measure::Parameter);
        own.map(|value| (value.name, value.number)).collect()
    };
    assert_eq!(values(&formulas), values(&numbers));
    let parameters = formulas.parameters.iter();
    let parameters: Vec<_> = parameters.map(|p| (&*p.name, p.number)).collect();
    let result = [
        ("rod", 300.0),
        ("a", 100.0),
        ("crank", 100.0),
        ("g", 9.81),
        ("n", 30.0),
    ];
    assert_eq!(parameters, result);
    // Parameters come first in the list, wherever they are in the file.
    let first: Vec<String> = formulas
        .values()
        .into_iter()
        .map(|v| v.name)
        .take(6)
        .collect();
    assert_eq!(first, ["rod", "a", "crank", "g", "n", "gravity x"]);
}

#[test]
fn formula_is_shown_and_replaced_without_other_changes() {
    let scene = Scene::parse(BY_FORMULAS, "test").unwrap();
    let named = |name: &str| scene.value_named(name).unwrap();
    let rod = named("r3.length");
    assert_eq!(rod.formula.as_deref(), Some("rod"));
    assert_eq!(
        (rod.number, &*rod.text(), rod.follows_from()),
        (300.0, "\"rod\"", vec!["rod".to_owned()])
    );
    assert_eq!(named("driver speed").text(), "2 * n rpm");
    assert_eq!(named("crank").owner, ValueOwner::Parameter("crank".into()));
    for value in scene.values() {
        assert_eq!(
            scene.with_value(&value, &value.text()),
            BY_FORMULAS,
            "{}",
            value.name
        );
    }
    for (name, typed, before, after) in [
        ("r3.length", "310", "length = \"rod\"", "length = 310"),
        ("r3 length", "rod + 1,5 mm", "", ""),
        (
            "r3 length",
            "3 * a - 1.5 mm",
            "length = \"rod\"",
            "length = \"3 * a - 1.5 mm\"",
        ),
        ("a", "4 in", "a = 100\n", "a = \"4 in\"\n"),
        ("a", "101", "a = 100\n", "a = 101\n"),
        ("a", "n * 3", "a = 100\n", "a = \"n * 3\"\n"),
        ("driver.speed", "n / 2 rad/s", "2 * n rpm", "n / 2 rad/s"),
        ("driver.speed", "3 * n", "2 * n rpm", "3 * n rpm"),
        ("driver.speed", "90deg/s", "2 * n rpm", "90 deg/s"),
        ("A.y", "12 in", "\"a - 100\"", "304.8"),
    ] {
        let value = named(name);
        let Ok(text) = value.typed(typed) else {
            assert!(
                before.is_empty(),
                "{typed}: {}",
                value.typed(typed).unwrap_err()
            );
            continue;
        };
        let expected = BY_FORMULAS.replacen(before, after, 1);
        assert_eq!(scene.with_value(&value, &text), expected, "{typed}");
    }
    let refused = |name: &str, typed: &str| named(name).typed(typed).unwrap_err().to_string();
    assert_eq!(
        refused("a", "2 * cranck"),
        "unknown parameter `cranck`; did you mean `crank`?"
    );
    assert_eq!(
        refused("a", "1 / (n - 30)"),
        "`(n - 30)` is 0: division by zero"
    );
    assert_eq!(
        refused("r3 length", "12 kg"),
        "kg does not fit here: mm, cm, m, in"
    );
    let no_value = scene.value_named("r3.lenght").unwrap_err();
    assert_eq!(
        no_value,
        "the scene has no value `r3.lenght`; did you mean `r3.length`?"
    );
}

/// The unit used to be lost: `a = "10 kg"` was accepted as a length. A new number of a parameter
/// had no unit, so that the units of its formulas no longer matched.
#[test]
fn parameter_keeps_its_unit() {
    let with = |parameters: &str, length: &str| {
        let parameters = format!("[parameters]\n{parameters}\n[ground]");
        BY_NUMBERS.replacen("[ground]", &parameters, 1).replacen(
            "length = 300",
            &format!("length = \"{length}\""),
            1,
        )
    };
    for (parameters, length, fits) in [
        ("a = \"30 cm\"", "a", true),
        ("a = \"30 cm\"", "a + 1 in", true),
        ("a = \"30 cm\"\nb = \"a / 2 mm\"", "2 * b", true),
        ("a = \"30 cm\"\nb = \"a - 2 mm\"", "b", true),
        ("a = 300", "a", true),
        ("a = \"300 kg\"", "a", false),
        ("a = \"300 kg\"\nb = \"2 * a\"", "b", false),
        ("a = \"300 deg\"", "a", false),
        ("a = \"30 cm\"", "a * a", false),
        ("a = \"30 cm\"", "a + 2 kg", false),
    ] {
        let read = Scene::parse(&with(parameters, length), "test");
        assert_eq!(read.is_ok(), fits, "{parameters}: {length}");
    }
    let scene = with(
        "a = \"30 cm\"\nb = \"a / 2 mm\"\nk = \"5 N/mm\"\nl = \"1 rad\"",
        "2 * b",
    );
    let scene = Scene::parse(&scene, "test").unwrap();
    for (name, text) in [
        ("a", "\"310.5 mm\""),
        ("b", "310.5"),
        ("k", "\"310.5 N/m\""),
        ("l", "\"310.5 deg\""),
    ] {
        let value = scene.value_named(name).unwrap();
        assert_eq!(value.with_number(310.5), text);
        let changed = scene.reparse(&scene.with_value(&value, text)).unwrap();
        assert_eq!(changed.value_named(name).unwrap().number, 310.5, "{name}");
    }
}

#[test]
fn long_chains_of_parameters_are_evaluated_in_any_order() {
    let count = 20_000;
    let mut text = String::from("[parameters]\n");
    for i in (1..count).rev() {
        text += &format!("p{i} = \"p{} + 1\"\n", i - 1);
    }
    text += "p0 = 5\n";
    let scene = BY_NUMBERS.replacen("[ground]", &(text.clone() + "[ground]"), 1);
    let scene = Scene::parse(&scene, "test").unwrap();
    assert_eq!(scene.value_named("p19999").unwrap().number, 20_004.0);
    // A cycle is rejected, with a single diagnostic.
    let circle = text.replace("p0 = 5", "p0 = \"p19999\"");
    let circle = BY_NUMBERS.replacen("[ground]", &(circle + "[ground]"), 1);
    assert_eq!(Scene::parse(&circle, "test").unwrap_err().items.len(), 1);
}

proptest! {
    /// A decimal written as a sum and product gives the same scene, bit by bit.
    #[test]
    fn formulas_of_decimals_equal_written_out_decimals(
        integer in 1_u64..100_000, cents in 0_u64..100, times in 1_u64..50,
    ) {
        // The exact number of hundredths.
        let hundredths = (integer * 100 + cents) * times;
        let written = format!("{}.{:02}", hundredths / 100, hundredths % 100);
        let parameters = format!(
            "[parameters]\na = \"{integer} + {} / 100\"\nb = \"c + a * {times} - c\"\nc = 0.3\n[ground]",
            cents,
        );
        let formulas = BY_NUMBERS
            .replacen("[ground]", &parameters, 1)
            .replacen("length = 300", "length = \"b\"", 1);
        let numbers = BY_NUMBERS.replacen("length = 300", &format!("length = {written}"), 1);
        let [formulas, numbers] = [formulas, numbers].map(|text| Scene::parse(&text, "test").unwrap());
        prop_assert_eq!(to_the_bit(&formulas), to_the_bit(&numbers));
    }
}

#[test]
fn retold_and_rewritten_scenes_keep_formulas() {
    let scene = Scene::parse(BY_FORMULAS, "test").unwrap();
    let shown_text = scene.with_header("n", "s", "t");
    assert!(shown_text.ends_with(BY_FORMULAS), "{shown_text}");
    // A new start position replaces the old one and nothing else.
    let point = scene
        .mechanism
        .point_ids()
        .find(|&p| scene.point_name(p) == Some("C"));
    let start = [(point.unwrap(), crate::Vec2::new(58.25, -123.5))];
    let text = scene.rewritten(&start, None, crate::scene::Precision::Rough);
    let expected = BY_FORMULAS.replacen("[\"3 * a + 10\", 230]", "[58.25, -123.5]", 1);
    assert_eq!(text, Some(expected));
}
