//! Tests of `table` with loads: driver torque, forces at joints and guides, and equilibrium checks.

use super::{PARALLEL_CRANKS, command, json, rows, run, run_ok};
use std::collections::BTreeMap;

/// Returns the tables of a scene given on standard input.
fn table(scene: &str, args: &[&str]) -> String {
    let mut command = command(&[&["table", "-"], args].concat());
    let output = run(command.write_stdin(scene));
    assert_eq!(output.code, 0, "{}", output.err);
    output.out
}

/// Returns the part of the output after the kinematics.
fn forces(text: &str) -> &str {
    let at = text.find("\ndriver ").map(|first| first + 1).unwrap();
    let at = text[at + 1..].find("\ndriver ").map(|next| at + 2 + next);
    at.map_or("", |at| &text[at..])
}

#[test]
fn table_prints_forces_below_kinematics() {
    let text = run_ok(&["table", "four-bar-load", "--at", "60"]);
    let expected = "\
driver r2             total      loads     gravity    inertia
torque [N m]       -6.44714   -7.30178   0.0577280   0.796909
power [W]          -96.7071

force at joints           fx [N]    fy [N]     f [N]  direction [deg]
r2 at A, by ground       110.758   87.4215   141.103          38.2840
r2 at B, by r3          -110.758  -62.8965   127.371          209.591
r3 at C, by r4          -122.378  -66.6450   139.348          208.572
r4 at D, by ground      -128.715   435.988   454.591          106.448

on the frame          fx [N]    fy [N]     f [N]  direction [deg]  moment [N m]
shaking              17.9560  -523.410   523.718          271.965      -167.948

checks miss by      torque [N m]    fx [N]    fy [N]  moment [N m]
";
    assert!(forces(&text).starts_with(expected), "{text}");
    assert!(text.lines().all(|line| line.len() <= 80), "{text}");
}

/// Without the gravity of the links, the only power is that of the falling load: the driver's
/// torque is this power divided by the driver's speed.
#[test]
fn driver_power_equals_load_power() {
    let scene = include_str!("../../presets/four-bar-load.toml");
    let scene = scene.replace("gravity = [0, -9.81]\n", "");
    let scene: String = scene
        .lines()
        .map(|line| line.split(", mass").next().unwrap().to_owned())
        .map(|line| {
            let opens = line.contains('{') && !line.contains('}');
            line + if opens { " }\n" } else { "\n" }
        })
        .collect();
    let scene = scene.replace("com = [125, 0] }", "points = { E = [50, 0] } }");
    let found = figures(&table(&scene, &["--at", "60", "--format", "csv"]));
    let speed = 15.0;
    let power = 500.0 * found["E.vy"] / 1000.0;
    assert!((found["driver.torque"] * speed - power).abs() < 1e-12 * power.abs());
    let rest = found["driver.torque"] - found["driver.torque.load"];
    assert!(rest.abs() < 1e-13, "{rest}");
    // The load is the only force on the frame.
    assert!(found["ground.fx"].abs() < 1e-12, "{}", found["ground.fx"]);
    assert!((found["ground.fy"] + 500.0).abs() < 1e-10);
}

/// Maps the names of a CSV table to their values.
fn figures(csv: &str) -> BTreeMap<String, f64> {
    let values = rows(csv).into_iter();
    values
        .filter_map(|row| Some((row[0].clone(), row[1].parse().ok()?)))
        .collect()
}

#[test]
fn table_and_sweep_agree_to_the_bit() {
    for preset in [
        "four-bar-load",
        "engine",
        "press-ram",
        "toggle-press",
        "excavator-boom",
    ] {
        let csv = run_ok(&["table", preset, "--format", "csv"]);
        let found = figures(&csv);
        let at = found.get("driver.angle").or(found.get("driver.position"));
        let at = at.unwrap().to_string();
        let columns = "*";
        let sweep = [
            "sweep",
            preset,
            "--from",
            &at,
            "--to",
            &at,
            "--no-units",
            "--columns",
        ];
        let sweep = run_ok(&[&sweep[..], &[columns]].concat());
        let header: Vec<&str> = sweep.lines().next().unwrap().split(',').collect();
        let row = rows(&sweep).remove(0);
        let json = json(&run_ok(&["table", preset, "--format", "json"]));
        let forces = json["forces"].as_object().unwrap();
        let mut agreed = 0;
        for (name, value) in header.iter().zip(&row) {
            if forces.contains_key(*name) {
                let (found, value) = (&found[*name], value.parse::<f64>().unwrap());
                assert_eq!(*found, value, "{preset}: {name}");
                agreed += 1;
            }
        }
        assert!(agreed >= 19, "{preset}: {agreed} of {header:?}");
        for (name, value) in forces {
            let value = value.as_f64();
            assert_eq!(value, found.get(name).copied(), "{preset}: {name}");
        }
        assert_eq!(json["units"]["force"], "N");
    }
}

#[test]
fn scene_without_loads_and_masses_shows_no_forces() {
    for format in ["text", "csv", "json"] {
        let shown = run_ok(&["table", "four-bar", "--format", format]);
        for word in ["N m", "torque", "force", "fx"] {
            assert!(!shown.contains(word), "{word} in {shown}");
        }
    }
}

/// Unless a load acts on the pin itself, the forces on its two links are opposite.
#[test]
fn joint_forces_on_both_links_are_opposite() {
    let found = figures(&run_ok(&[
        "table",
        "press-ram",
        "--at",
        "20",
        "--format",
        "csv",
    ]));
    for (one, other) in [
        ("r2.B", "r3.B"),
        ("r3.C", "r4.C"),
        ("r4.E", "r5.E"),
        ("r5.F", "ram.F"),
    ] {
        for axis in ["fx", "fy"] {
            let [a, b] = [one, other].map(|name| found[&format!("{name}.{axis}")]);
            assert!((a + b).abs() <= 1e-12 * a.abs(), "{one} {a}, {other} {b}");
        }
    }
    // The gas acts on the piston instead of its pin, and the die acts on the ram.
    let text = run_ok(&["table", "engine"]);
    assert!(
        text.contains("r3 at C, by piston") && !text.contains("piston at C"),
        "{text}"
    );
    let text = run_ok(&["table", "press-ram", "--at", "20"]);
    assert!(
        text.contains("r5 at F, by ram") && !text.contains("ram at F"),
        "{text}"
    );
    assert!(text.contains("r2 at B, by r3"), "{text}");
    assert!(!text.contains("r3 at B"), "{text}");
}

/// With an off-axis force, the guide's moment is that of its normal force at the printed position.
#[test]
fn guide_reports_its_line_of_action() {
    let scene = include_str!("../../presets/engine.toml");
    let scene = scene.replace("crown = [30, 0]", "crown = [30, 7]");
    let found = figures(&table(&scene, &["--format", "csv"]));
    // 7 mm off the pin, against +x: counter-clockwise, so the guide's moment is clockwise.
    let gas = 32e3 * (0.664 + (0.466 - 0.664) * 0.5);
    assert!((found["r4.moment"] + 0.007 * gas).abs() < 1e-9 * gas);
    let by_hand = found["r4.moment"] / found["r4.normal"] * 1000.0;
    assert!((found["r4.at"] - by_hand).abs() < 1e-9 * by_hand.abs());
    let text = table(&scene, &["--bounds"]);
    assert!(text.contains("r4 on piston"), "{text}");
}

#[test]
fn dead_point_has_no_driver_force() {
    let end = json(&run_ok(&["check", "excavator-boom", "--format", "json"]));
    let end = end["range"][1].as_f64().unwrap().to_string();
    let args = ["table", "excavator-boom", "--at", &end];
    let text = run_ok(&args);
    assert!(
        text.contains("\nNo force of the driver exists here"),
        "{text}"
    );
    assert!(!text.contains("N m"), "{text}");
    let json = json(&run_ok(&[&args[..], &["--format", "json"]].concat()));
    let forces = json["forces"].as_object().unwrap();
    assert!(forces["driver.force"].is_null() && forces["boom.Q.fx"].is_null());
    let csv = run_ok(&[&args[..], &["--format", "csv"]].concat());
    assert!(csv.contains("\ndriver.force,,N,found\n"), "{csv}");
}

#[test]
fn change_point_shows_only_the_driver_torque() {
    let scene = include_str!("../../presets/parallelogram.toml");
    let scene = format!("{scene}\n[[loads]]\npoint = \"C\"\nforce = [0, -10]\n");
    let text = table(&scene, &["--at", "0"]);
    assert!(text.contains("state change-point"), "{text}");
    let shown = forces(&text);
    assert!(
        shown.contains("torque [N m]") && !shown.contains("fx [N]"),
        "{shown}"
    );
    assert!(
        shown.contains("only the driver's torque has a value"),
        "{shown}"
    );
}

#[test]
fn indeterminate_forces_are_listed() {
    let scene = format!("{PARALLEL_CRANKS}\n[[loads]]\npoint = \"C\"\nforce = [0, -10]\n");
    let text = table(&scene, &[]);
    let text: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("Indeterminate: a.A, "), "{text}");
    let found = table(&scene, &["--format", "json"]);
    let found = &json(&found)["forces"];
    assert!(found["c.D.fx"].is_null(), "{found}");
    assert!(found["indeterminate"].as_array().unwrap().len() > 4);
    // The load falls as the cranks turn: 10 N at an arm of cos(60 deg) times 1 m.
    let torque = found["driver.torque"].as_f64().unwrap();
    assert!((torque - 5.0).abs() < 1e-12, "{torque}");
}

#[test]
fn check_lists_loads_and_masses() {
    let text = run_ok(&["check", "press-ram"]);
    let line = "\nforces     1 press, 5 links with a mass, gravity\n";
    assert!(text.contains(line), "{text}");
    let engine = json(&run_ok(&["check", "engine", "--format", "json"]));
    assert_eq!(engine["acting"]["forces"], 1);
    assert_eq!(engine["acting"]["masses"], 3);
    let plain = run_ok(&["check", "four-bar"]);
    assert!(!plain.contains("\nforces"), "{plain}");
}

/// The loads of a four-stroke engine repeat after two turns of the crank; its motion after one.
#[test]
fn sweep_of_forces_covers_the_period_of_the_loads() {
    let rows = |columns: &str| {
        run_ok(&["sweep", "engine", "--columns", columns])
            .lines()
            .count()
    };
    assert_eq!(rows("driver.torque"), 1 + 721);
    assert_eq!(rows("C.x"), 1 + 361);
    let text = run_ok(&["check", "engine"]);
    assert!(text.contains("repeated after 720 deg"), "{text}");
}
