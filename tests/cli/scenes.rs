//! Tests of `check` and of the sources of scenes.

use super::{PARALLEL_CRANKS, command, folder, json, refused, run, run_ok};
use krank::scene::presets;

/// A four-bar with a control character in its name.
const MINE: &str = r#"
name = "Mine \u001b[2J"
unit = "cm"
[ground]
A = [0, 0]
D = [4, 0]
[driver]
link = "a"
angle = 90
speed = "60 rpm"
[links]
a = { from = "A", to = "B", length = 1 }
b = { from = "B", to = "C", length = 3 }
c = { from = "C", to = "D", length = 2.5 }
[start]
C = [3, 2]
"#;

/// Lecture notes write a slider-crank's r4 at theta 180, which is a guide at angle 0: a scene with
/// angle 180 gets an explanation.
#[test]
fn negative_slide_coordinate_is_explained() {
    let text = presets::find("slider-crank").unwrap().text;
    let turned = text.replace("\"A\", angle = 0 }", "\"A\", angle = 180 }");
    assert_ne!(text, turned);
    let output = "r4 is negative where the scene opens, -28.0252 cm: it is measured from `through` along `angle = 180`, and \
                its vector points back; set `angle = 0` to make it positive, at theta 180 deg, as in lecture notes";
    // The table normalizes any notation of the direction to 0 up to 360.
    let down = text.replace("\"A\", angle = 0 }", "\"A\", angle = -180 }");
    let over = text.replace("\"A\", angle = 0 }", "\"A\", angle = 540 }");
    for (text, angle) in [(down, "-180"), (over, "540")] {
        let file = folder("backwards").join("scene.toml");
        std::fs::write(&file, text).unwrap();
        let shown = run_ok(&["check", file.to_str().unwrap()]);
        let words: Vec<_> = shown.split_whitespace().collect();
        let output = output.replace("`angle = 180`", &format!("`angle = {angle}`"));
        assert!(words.join(" ").contains(&output), "{shown}");
    }
    for (text, expected) in [(text, false), (&*turned, true)] {
        let file = folder("backwards").join("scene.toml");
        std::fs::write(&file, text).unwrap();
        let shown = run_ok(&["check", file.to_str().unwrap()]);
        let words: Vec<_> = shown.split_whitespace().collect();
        assert_eq!(words.join(" ").contains(output), expected, "{shown}");
    }
}

#[test]
fn check_summarizes_the_scene() {
    let text = run_ok(&["check", "four-bar"]);
    for line in [
        "Four-bar crank-rocker",
        "unit       mm",
        "parts      3 links and the ground, 4 pin joints, no slide",
        "driver     link r2, opens at 60 deg, 15 rad/s, 0 rad/s^2",
        "           C: r3, r4",
        "mobility   1",
        "groups     1. driver: link r2",
        "           2. dyad RRR at C: links r3, r4 (closed form)",
        "range      turns fully; the motion repeats after 360 deg",
    ] {
        assert!(text.lines().any(|l| l == line), "{line}\n{text}");
    }
}

/// Limits have the digits that they need and no trailing zeros.
#[test]
fn limits_of_driven_slide_have_no_trailing_zeros() {
    let scene = r#"
unit = "mm"
[ground]
A = [0, 0]
D = [100, 0]
[driver]
slide = "s"
position = -60
[links]
a = { from = "A", to = "C", length = 60 }
b = { points = { D = [0, 0] } }
[slides]
s = { point = "C", on = "b", through = "D", angle = 0 }
[start]
C = [40, 20]
"#;
    let output = run(command(&["check", "-"]).write_stdin(scene));
    assert_eq!(output.code, 0, "{}", output.err);
    let range = output.out.lines().find(|l| l.starts_with("range")).unwrap();
    assert_eq!(range, "range      -160 to -40 mm");
}

#[test]
fn check_names_slides_and_coupled_groups() {
    let slider_crank = run_ok(&["check", "slider-crank"]);
    assert!(
        slider_crank.contains("r4: pin C in a slot of ground"),
        "{slider_crank}"
    );
    assert!(slider_crank.contains("dyad RRP at C"), "{slider_crank}");
    let six_bar = run_ok(&["check", "stephenson-six-bar"]);
    assert!(six_bar.contains("unknowns: links"), "{six_bar}");
    assert!(six_bar.contains("(by Newton)"), "{six_bar}");
}

#[test]
fn check_reports_redundant_constraints_and_driven_slides() {
    let output = run(command(&["check", "-"]).write_stdin(PARALLEL_CRANKS));
    let line = "mobility   1, not counting 1 redundant constraint: ";
    assert!(output.out.contains(line), "{}", output.out);
    let boom = run_ok(&["check", "excavator-boom"]);
    assert!(boom.contains("groups     1. driver: slide rod\n"), "{boom}");
    assert!(
        boom.contains("driver     slide rod, opens at 2 m, 0.15 m/s"),
        "{boom}"
    );
}

#[test]
fn check_reports_redundancies_and_their_misfit() {
    let text = run_ok(&["check", "triple-parallelogram"]);
    let line = "redundant  r5 repeats r2, r3, r4; they differ by at most ";
    assert!(text.contains(line), "{text}");
    let facts = json(&run_ok(&[
        "check",
        "triple-parallelogram",
        "--format",
        "json",
    ]));
    assert_eq!(facts["redundant"], serde_json::json!(["r5"]));
    let found = &facts["redundancies"][0];
    assert_eq!(found["element"], "r5");
    assert_eq!(found["constraints"], 1);
    assert_eq!(found["repeats"], serde_json::json!(["r2", "r3", "r4"]));
    assert!(
        (0.0..1e-9).contains(&found["misfit"].as_f64().unwrap()),
        "{found}"
    );
    assert_eq!(facts["mobility_is_unclear"], false);
    assert_eq!(facts["opens_at_change_point"], false);
}

/// The third crank is a little longer: the message proposes the line that makes the scene valid.
#[test]
fn misfit_within_the_limit_of_the_scene_is_accepted() {
    let drawn = PARALLEL_CRANKS.replace(
        "e = { from = \"G\", to = \"F\", length = 1 }",
        "e = { from = \"G\", to = \"F\", length = 1.00001 }",
    );
    let output = run(command(&["check", "-"]).write_stdin(drawn.clone()));
    assert_eq!(output.code, 2);
    assert!(
        output.err.contains("misses the others by 1e-5 m"),
        "{}",
        output.err
    );
    let proposed = "[redundant]\n           misfit = 1e-4\n";
    assert!(output.err.contains(proposed), "{}", output.err);
    let accepted = drawn + "[redundant]\nmisfit = 1e-4\n";
    let output = run(command(&["check", "-", "--format", "json"]).write_stdin(accepted));
    assert_eq!((output.code, output.err.as_str()), (0, ""));
    let misfit = json(&output.out)["redundancies"][0]["misfit"]
        .as_f64()
        .unwrap();
    assert!((misfit - 1e-5).abs() < 1e-9, "{misfit:e}");
}

/// Regression test: the message proposed a name that was then rejected.
#[test]
fn proposed_start_of_centre_of_mass_works() {
    let lever = "[ground]\nA = [0, 0]\nO = [0, -100]\n[driver]\nlink = \"crank\"\nangle = 30\n\
        [links]\ncrank = { from = \"A\", to = \"B\", length = 50 }\n\
        table = { points = { O = [0, 0] }, com = [80, 0], mass = 1 }\n\
        [slides]\nslot = { point = \"B\", on = \"table\", through = [0, 0] }\n";
    let output = run(command(&["check", "-"]).write_stdin(lever));
    assert_eq!(output.code, 2);
    let lines: Vec<&str> = output.err.lines().map(str::trim).collect();
    let lines: Vec<&str> = lines.into_iter().filter(|l| l.starts_with('"')).collect();
    assert_eq!(lines.len(), 2, "{}", output.err);
    for line in lines {
        let started = format!("{lever}[start]\n{line}\n");
        let output = run(command(&["table", "-", "--format", "csv"]).write_stdin(started));
        assert_eq!(output.code, 0, "{line}: {}", output.err);
    }
    // A saved start can be read again.
    let started = format!("{lever}[start]\n\"table.com\" = [26, -24]\n");
    let saved = run(command(&["start", "-", "--assembly", "table=-"]).write_stdin(started));
    assert!(
        saved.out.contains("\"table.com\" = ["),
        "{}{}",
        saved.out,
        saved.err
    );
    let again = run(command(&["check", "-"]).write_stdin(saved.out));
    assert_eq!(again.code, 0, "{}", again.err);
}

#[test]
fn check_prints_range_as_doubles_and_with_12_decimals() {
    let full = json(&run_ok(&["check", "four-bar", "--format", "json"]));
    assert_eq!(full["range"], serde_json::json!([0.0, 360.0]));
    assert_eq!(full["period"], 360.0);
    let limited = json(&run_ok(&["check", "double-rocker", "--format", "json"]));
    let (low, high) = (&limited["range"][0], &limited["range"][1]);
    assert!(limited["period"].is_null());
    let (low, high) = (low.as_f64().unwrap(), high.as_f64().unwrap());
    assert!(0.0 < low && low < high && high < 180.0);
    let text = run_ok(&["check", "double-rocker"]);
    let line = format!("range      {low:.12} to {high:.12} deg");
    assert!(text.contains(&line), "{text}");
}

#[test]
fn check_reports_extremes_of_transmission_angle() {
    let text = run_ok(&["check", "slider-crank"]);
    let output = "angle      transmission angle at C: smallest 60.0000 deg, at 90 deg; largest\n\
                \x20            90.0000 deg, at 0 deg\n";
    assert!(text.contains(output), "{text}");
    let facts = json(&run_ok(&["check", "scotch-yoke", "--format", "json"]));
    let angle = |which: &str| facts["transmission"][0][which]["angle"].as_f64();
    assert_eq!(
        (angle("smallest"), angle("largest")),
        (Some(90.0), Some(90.0))
    );
    assert_eq!(facts["near_misses"], serde_json::json!([]));
    let six_bar = json(&run_ok(&["check", "watt-six-bar", "--format", "json"]));
    assert_eq!(six_bar["transmission"].as_array().map(Vec::len), Some(2));
    assert_eq!(
        six_bar["transmission"][0]["group"],
        six_bar["groups"][1]["point"]
    );
}

/// The state of a near miss is ok, so only the note reports it.
#[test]
fn near_miss_of_change_point_is_noted() {
    let scene = MINE
        .replace("length = 2.5", "length = 1.0000001")
        .replace("c = [4, 0]", "");
    let scene = scene
        .replace("D = [4, 0]", "D = [3, 0]")
        .replace("C = [3, 2]", "C = [3, 1]");
    for args in [&["table", "-"][..], &["sweep", "-", "--to", "5"]] {
        let output = run(command(args).write_stdin(scene.as_str()));
        assert_eq!(output.code, 0, "{}", output.err);
        let note = "note: almost a change point or dead point at 0 deg: the sine of the \
                    transmission angle at C is 0.000365; the motion keeps its assembly\n";
        assert!(output.err.starts_with(note), "{}", output.err);
        assert_eq!(
            output.err.lines().count(),
            2,
            "at 0 and 180: {}",
            output.err
        );
    }
    let output = run(command(&["check", "-"]).write_stdin(scene.as_str()));
    assert_eq!(output.err, "");
    assert!(
        output.out.contains("\nnear miss  almost a change"),
        "{}",
        output.out
    );
}

#[test]
fn check_json_names_every_part() {
    let facts = json(&run_ok(&["check", "slider-crank", "--format", "json"]));
    assert_eq!(facts["unit"], "cm");
    assert_eq!(facts["driver"]["kind"], "link");
    assert_eq!(facts["driver"]["speed"], 200.0);
    assert_eq!(facts["links"], serde_json::json!(["r2", "r3"]));
    assert_eq!(facts["slides"][0]["slider"], "C");
    assert_eq!(facts["groups"][1]["kind"], "RRP");
    assert_eq!(facts["mobility"], 1);
}

#[test]
fn scene_can_come_from_standard_input() {
    let mut on_stdin = command(&["check", "-"]);
    let output = run(on_stdin.write_stdin(MINE));
    assert_eq!((output.code, output.err.as_str()), (0, ""));
    assert!(
        output
            .out
            .contains("opens at 90 deg, 6.28319 rad/s, 0 rad/s^2"),
        "{}",
        output.out
    );
    let mut exact = command(&["check", "-", "--format", "json"]);
    let facts = json(&run(exact.write_stdin(MINE)).out);
    assert_eq!(facts["driver"]["speed"], std::f64::consts::TAU);
    assert!(
        output.out.starts_with("Mine ?[2J\n"),
        "a control character: {}",
        output.out
    );

    let mut broken = command(&["check", "-"]);
    let output = run(broken.write_stdin(MINE.replace("2.5", "-2.5")));
    assert_eq!((output.code, output.out.as_str()), (2, ""));
    assert!(output.err.contains("stdin:14:"), "{}", output.err);
    assert!(output.err.is_ascii());
}

#[test]
fn file_takes_precedence_over_preset_only_by_path() {
    let here = folder("by-path");
    std::fs::write(here.join("four-bar"), MINE).unwrap();
    std::fs::write(here.join("mine"), MINE).unwrap();
    std::fs::write(here.join("mine.toml"), MINE).unwrap();
    let unit = |name: &str| {
        let mut command = command(&["check", name, "--format", "json"]);
        json(&run(command.current_dir(&here)).out)["unit"].clone()
    };
    assert_eq!(unit("four-bar"), "mm");
    assert_eq!(unit("./four-bar"), "cm");
    assert_eq!(unit("mine"), "cm");
    assert_eq!(unit("mine.toml"), "cm");
}

#[test]
fn unreadable_scenes_are_rejected() {
    for (name, phrase) in [
        ("four-bra", "did you mean the preset `four-bar`?"),
        ("tabel", "did you mean the command `table`?"),
        ("qqqqqqqqqq", "list the presets with `krank list`"),
        (
            "no/such/file.toml",
            "cannot read `no/such/file.toml`: No such file",
        ),
        ("/", "cannot read `/`: Is a directory"),
    ] {
        let message = refused(2, &["check", name]);
        assert!(message.contains(phrase), "{message}");
    }
    let endless = refused(2, &["check", "/dev/zero"]);
    assert!(endless.contains("1 MiB"), "{endless}");
}

/// Every command reports an impossible scene with its line.
#[test]
fn impossible_scene_exits_with_2_and_names_the_line() {
    let file = folder("impossible").join("open.toml");
    std::fs::write(&file, MINE.replace("length = 3", "length = 9")).unwrap();
    let file = file.to_str().unwrap();
    for command in ["check", "table", "sweep"] {
        let message = refused(2, &[command, file]);
        assert!(message.contains("open.toml:1"), "{message}");
    }
}

#[test]
fn check_prints_zero_without_rounding_error() {
    let text = run_ok(&["check", "toggle-press"]);
    assert!(
        text.contains("S: + at (0, 0), - at (0, -440.744) now"),
        "{text}"
    );
    let text = run_ok(&["check", "scissor-lift"]);
    assert!(text.contains("smallest 0.0000 deg, at 0 m;"), "{text}");
}

#[test]
fn check_classifies_double_cranks() {
    for preset in ["parallelogram", "antiparallelogram", "kite"] {
        let text = run_ok(&["check", preset]);
        let class = "four-bar, double crank: change point, s + l = p + q";
        assert!(text.contains(class), "{text}");
    }
    let text = run_ok(&["check", "drag-link"]);
    assert!(text.contains("double crank (drag link): Grashof"), "{text}");
}

#[test]
fn check_lists_parameters_with_their_values() {
    let text = MINE.replacen(
        "[ground]",
        "[parameters]\nrod = \"2 * crank + 0.1 + 0.2\"\ncrank = 1.35\n[ground]",
        1,
    );
    let text = text.replacen("length = 3 }", "length = \"rod\" }", 1);
    let file = folder("parameters").join("scene.toml");
    std::fs::write(&file, text).unwrap();
    let name = file.to_str().unwrap();
    let shown = run_ok(&["check", name]);
    let output = "parameters rod = 2 * crank + 0.1 + 0.2 = 3\n           crank = 1.35\n";
    assert!(shown.contains(output), "{shown}");
    let found = json(&run_ok(&["check", name, "--format", "json"]));
    let expected = serde_json::json!([
        { "name": "rod", "value": 3.0, "formula": "2 * crank + 0.1 + 0.2" },
        { "name": "crank", "value": 1.35 },
    ]);
    assert_eq!(found["parameters"], expected);
    // A scene without parameters has no such line.
    assert!(!run_ok(&["check", "four-bar"]).contains("parameters"));
}

#[test]
fn check_reports_unreachable_knots() {
    let text = presets::find("double-rocker").unwrap().text;
    let load = "[[loads]]\npoint = \"P\"\nforce = [10, 0]\n\
                over = [[0, 1], [20, 2], [50, 3], [101, 4], [110, 5], [400, 6]]\n[vectors]";
    let file = folder("dead-knots").join("scene.toml");
    std::fs::write(&file, text.replacen("[vectors]", load, 1)).unwrap();
    let name = file.to_str().unwrap();
    let shown = run_ok(&["check", name]);
    let output = "`over` of P: the motion never reaches the knots at 0 deg, 400 deg";
    assert!(shown.contains(output), "{shown}");
    let found = json(&run_ok(&["check", name, "--format", "json"]));
    let dead = serde_json::json!([{ "on": "P", "at": [0.0, 400.0] }]);
    assert_eq!(found["dead_knots"], dead);
    assert!(!run_ok(&["check", "drag-link-press"]).contains("never reaches"));
}

/// A figure can combine columns and parameters, with or without units.
#[test]
fn figures_can_use_parameters() {
    let text = MINE.replacen(
        "[ground]",
        "[parameters]\ncrank = 1.35\n[figures]\npast = \"C.x - 2 * crank * 1 cm\"\n[ground]",
        1,
    );
    let file = folder("figure-of-parameters").join("scene.toml");
    std::fs::write(&file, &text).unwrap();
    let name = file.to_str().unwrap();
    let table = run_ok(&[
        "sweep",
        name,
        "--from",
        "90",
        "--to",
        "90",
        "--columns",
        "C.x,past",
        "--no-units",
    ]);
    let row: Vec<f64> = (table.lines().nth(1).unwrap().split(','))
        .filter_map(|cell| cell.parse().ok())
        .collect();
    assert!((row[1] - 2.7 - row[2]).abs() < 1e-12, "{table}");
    // A length needs a unit.
    std::fs::write(&file, text.replace(" * 1 cm", "")).unwrap();
    let message = refused(2, &["check", name]);
    assert!(
        message.contains("`2 * crank` is a plain number"),
        "{message}"
    );
    // The parameter itself can have the unit.
    let text = text
        .replace(" * 1 cm", "")
        .replace("crank = 1.35", "crank = \"13.5 mm\"");
    std::fs::write(&file, text).unwrap();
    let output = "parameters crank = 13.5 mm = 1.35 cm\n";
    assert!(run_ok(&["check", name]).contains(output));
}

/// The slide is drawn at 0 and is computed 2.5e-15 mm below, which is within its bound.
#[test]
fn slide_within_its_bound_of_zero_is_not_negative() {
    let scene = |through: &str| {
        format!(
            r#"
unit = "mm"
[ground]
A = [0, 0]
D = [35.98828125, 0]
S = [69.111328125, 0.30078125]
[driver]
link = "P"
angle = 0
[links]
P = {{ points = {{ A = [0, 0], B = [16.2890625, 28.3984375] }} }}
M = {{ points = {{ B = [16.2890625, 28.3984375], C = [35.986328125, 35.234375] }} }}
Kk = {{ points = {{ C = [35.986328125, 35.234375], D = [35.98828125, 0] }} }}
L = {{ points = {{ Q = [53.783203125, 27.779296875], S = [69.111328125, 0.30078125] }} }}
[slides]
s4 = {{ point = "Q", on = "Kk", through = [{through}], angle = 45 }}
[start]
B = [16.2890625, 28.3984375]
C = [35.986328125, 35.234375]
Q = [53.783203125, 27.779296875]
"#
        )
    };
    let file = folder("negative_zero").join("scene.toml");
    for (through, expected) in [
        ("53.783203125, 27.779296875", false),
        ("53.783203126, 27.779296876", true),
    ] {
        std::fs::write(&file, scene(through)).unwrap();
        let shown = run_ok(&["check", file.to_str().unwrap()]);
        assert_eq!(shown.contains("s4 is negative"), expected, "{shown}");
    }
}

/// Each end of a limited range has its own error; here the coupler is too short for a full turn.
#[test]
fn check_reports_error_of_each_range_end() {
    let text = MINE.replace("length = 3 }", "length = 1.7 }");
    let file = folder("end_errors").join("scene.toml");
    std::fs::write(&file, text.replace("C = [3, 2]", "C = [1.7, 0.7]")).unwrap();
    let file = file.to_str().unwrap();
    let facts = json(&run_ok(&["check", file, "--format", "json"]));
    assert!(facts["period"].is_null(), "{facts}");
    let [ends, bounds] = ["range", "range_bounds"].map(|key| {
        let list = facts[key].as_array().unwrap();
        [0, 1].map(|k| list[k].as_f64().unwrap())
    });
    for (end, bound) in ends.into_iter().zip(bounds) {
        let half_ulp = 0.5 * (end.abs().next_up() - end.abs());
        assert!(0.0 < bound && bound <= half_ulp, "{end} {bound}");
    }
    let shown = run_ok(&["check", file]);
    assert!(shown.contains("error of the lower end at most "), "{shown}");
    let full = json(&run_ok(&["check", "four-bar", "--format", "json"]));
    assert_eq!(full["range_bounds"], serde_json::json!([0.0, 0.0]));
}

/// The hint contains the number that was meant.
#[test]
fn typing_slips_in_numbers_have_a_hint_with_the_number() {
    let frame = |line: &str| format!("[ground]\nA = [0, 0]\n{line}\n");
    let link = |value: &str| format!("[links]\nr2 = {{ from = \"A\", to = \"B\", {value} }}\n");
    for (text, hint) in [
        (frame("D = [400,5, 0]"), "decimals with a point: 400.5"),
        (frame("D = [0, -12,25]"), "decimals with a point: -12.25"),
        (frame("D = [1,5, 2,5]"), "decimals with a point: 1.5"),
        (frame("D = [1,5,2,5]"), "decimals with a point: 0.5"),
        (link("length = 3.5\""), "remove the quote: 3.5; or"),
        (link("length = 3.5\""), "in quotes: \"3.5 in\""),
        (frame("D = [3\", 0]"), "remove the quote: 3; or"),
        ("[driver]\nangle = 60\"\n".into(), "the number alone: 60"),
    ] {
        let file = folder("slips").join("slip.toml");
        std::fs::write(&file, &text).unwrap();
        let shown = refused(2, &["check", file.to_str().unwrap()]);
        assert!(shown.contains(hint), "{hint:?} is not in:\n{shown}");
    }
}
