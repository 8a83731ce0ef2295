//! Tests of `table`: the layout of the lectures' tables, and the values printed in the lectures.

use super::{PARALLEL_CRANKS, command, json, krank, refused, rows, run, run_ok};
use std::collections::BTreeMap;

#[test]
fn four_bar_tables_have_the_lecture_layout() {
    let text = run_ok(&["table", "four-bar", "--at", "60"]);
    let expected = "\
Four-bar crank-rocker
driver r2 at 60 deg, 15 rad/s, 0 rad/s^2
state ok

position                 r2         r3         r4         r1
r [mm]              100.000    300.000    250.000    400.000
theta [deg]         60.0000    29.3794*   290.753*   180.000

velocity                 r2         r3         r4         r1
dr/dt [mm/s]              0          0          0          0
omega [rad/s]       15.0000   -3.91641*   3.09107*         0

acceleration             r2         r3         r4         r1
d2r/dt2 [mm/s^2]          0          0          0          0
alpha [rad/s^2]           0    42.2670*   95.5036*         0

* computed; entries without a star are given

position of points        x [mm]    y [mm]    r [mm]  direction [deg]
A                              0         0         0                -
D                        400.000         0   400.000                0
B                        50.0000   86.6025   100.000          60.0000
C                        311.417   233.780   389.402          36.8955
r2.com                         0         0         0                -
r3.com                   180.708   160.191   241.489          41.5558
r4.com                   355.708   116.890   374.422          18.1911
";
    assert!(text.starts_with(expected), "{text}");
}

/// Each value that depends on a length has a line with its worst-case change and the most important length.
#[test]
fn sensitivity_is_a_separate_table() {
    let args = ["table", "four-bar", "--sensitivity"];
    let text = run_ok(&args);
    let (tables, lengths) = text.split_once("\nchange for 1 mm").unwrap();
    assert_eq!(format!("{tables}\n"), run_ok(&args[..2]) + "\n");
    assert!(
        lengths.contains("\nC.x [mm]                       4.18    0.946  r3.length\n"),
        "{text}"
    );
    assert!(!lengths.contains("A.x [mm]"), "{text}");

    let csv = run_ok(&[&args[..], &["--format", "csv"]].concat());
    let header = csv.lines().next().unwrap();
    assert_eq!(header, "name,value,unit,entry,sensitivity,most,by");
    let by_name: BTreeMap<String, Vec<String>> = rows(&csv)
        .into_iter()
        .map(|row| (row[0].clone(), row))
        .collect();
    assert_eq!(by_name["C.x"][5], "r3.length");
    assert_eq!(by_name["r2.length"][4], "");
    assert_eq!(by_name["r2.angle"][4..], ["0", "", ""]);

    let object = json(&run_ok(&[&args[..], &["--format", "json"]].concat()));
    let figure = &object["sensitivity"]["C.x"];
    assert_eq!(figure["unit"], "mm per mm");
    let by = figure["by"].as_object().unwrap();
    let sum: f64 = by.values().map(|d| d.as_f64().unwrap().abs()).sum();
    let worst: f64 = by_name["C.x"][4].parse().unwrap();
    assert!((sum - worst).abs() < 1e-12, "{sum}, {worst}");
    assert_eq!(figure["sum"].as_f64().unwrap(), worst);
    assert!(
        by.contains_key("D.x") && !by.contains_key("r2.com.x"),
        "{by:?}"
    );
}

/// A value with a kink within rounding error is shown without a sensitivity, and a note counts it.
#[test]
fn values_without_sensitivity_are_counted() {
    let columns = "turn = abs(hypot(C.x - D.x, C.y - D.y) - 250 mm),C.x";
    for args in [
        &["table", "four-bar", "--columns", columns, "--sensitivity"][..],
        &[
            "sweep",
            "four-bar",
            "--columns",
            columns,
            "--sensitivity",
            "--to",
            "10",
        ],
    ] {
        let output = krank(args);
        assert_eq!(output.code, 0, "{}", output.err);
        let counts = match args[0] {
            "table" => "note: 1 of 2 values",
            _ => "note: 11 of 22 values",
        };
        assert!(output.err.starts_with(counts), "{}", output.err);
        assert!(output.err.contains("have no derivatives"), "{}", output.err);
    }
    let output = krank(&["table", "four-bar", "--columns", "C.*", "--sensitivity"]);
    assert_eq!(output.err, "");
}

/// A comma separates columns. A number with a comma gets a suggestion; a number with a point does not.
#[test]
fn decimal_comma_in_formula_gets_a_hint() {
    for columns in ["a = 1,5 mm", "C.x,a = C.x + 1,5 mm", "a = (1,5 mm)"] {
        let output = refused(2, &["table", "four-bar", "--columns", columns]);
        assert!(output.contains("`1.5`"), "{output}");
    }
    let output = refused(2, &["table", "four-bar", "--columns", "a = C.x,5 mm"]);
    assert!(
        output.contains("5 mm") && !output.contains(".5"),
        "{output}"
    );
}

/// With other lengths, three parallel cranks would jam: there is no sensitivity, and a note gives the reason.
#[test]
fn missing_sensitivity_is_explained() {
    let mut command = command(&["table", "-", "--sensitivity", "--format", "json"]);
    let output = run(command.write_stdin(PARALLEL_CRANKS));
    assert_eq!(output.code, 0);
    assert!(json(&output.out)["sensitivity"].is_null(), "{}", output.out);
    assert!(
        output
            .err
            .starts_with("note: no derivatives by the lengths"),
        "{}",
        output.err
    );
    let text = krank(&["table", "triple-parallelogram", "--sensitivity"]).out;
    assert!(text.contains("change for 1 mm: no derivatives"), "{text}");
    assert!(text.lines().all(|line| line.len() <= 80), "{text}");
}

/// Text prints bounds in a line below the values, with two digits and rounded up. CSV and JSON have
/// a bound for each value.
#[test]
fn bounds_are_printed_below_the_values() {
    let args = ["table", "four-bar", "--bounds"];
    let text = run_ok(&args);
    let without: Vec<&str> = text
        .lines()
        .filter(|line| !line.starts_with("  +-") && !line.starts_with("+-"))
        .collect();
    assert_eq!(without.join("\n") + "\n", run_ok(&args[..2]));

    let csv = run_ok(&[&args[..], &["--format", "csv"]].concat());
    assert!(csv.starts_with("name,value,unit,entry,bound\n"), "{csv}");
    let object = json(&run_ok(&[&args[..], &["--format", "json"]].concat()));
    let rocker = &object["vectors"][2];
    let bound = rocker["angle.bound"].as_f64().unwrap();
    assert!((0.0..1e-12).contains(&bound), "{bound}");
    let (exact, found) = (290.752_521_225_055_83, rocker["angle"].as_f64().unwrap());
    assert!((exact - found).abs() <= bound + 1e-14, "{found}");
    let row = rows(&csv)
        .into_iter()
        .find(|row| row[0] == "r4.angle")
        .unwrap();
    assert_eq!(row[4].parse::<f64>().unwrap(), bound);
    let line = text
        .lines()
        .skip_while(|l| !l.starts_with("theta"))
        .nth(1)
        .unwrap();
    let shown: f64 = line.split_whitespace().nth(3).unwrap().parse().unwrap();
    assert!((bound..bound * 1.11).contains(&shown), "{line}");
}

/// At a change point, rates are limits without proved bounds, and a note says so.
#[test]
fn values_without_proved_bound_are_counted() {
    let args = ["table", "parallelogram", "--at", "0", "--bounds"];
    let output = krank(&args);
    assert_eq!(output.code, 0);
    assert!(
        output.err.contains(" values have no error bound: "),
        "{}",
        output.err
    );
    let rates = output.out.split("\nomega").nth(1).unwrap();
    let bounds = rates.lines().nth(1).unwrap();
    assert_eq!(
        bounds.split_whitespace().collect::<Vec<_>>(),
        ["+-", "0", "?", "?", "0"]
    );
    let output = krank(&[&args[..], &["--format", "csv"]].concat());
    let row = rows(&output.out)
        .into_iter()
        .find(|row| row[0] == "r4.omega");
    assert_eq!(row.unwrap()[2..], ["rad/s", "found", ""]);
}

/// A zero with rounding error prints as zero in text, but with all digits in CSV.
#[test]
fn value_within_its_bound_of_zero_prints_as_zero() {
    // The cell draws a straight line: P moves only along y.
    let args = ["table", "peaucellier", "--at", "45"];
    let velocities = |text: &str| {
        let after = text.split("velocity of points").nth(1).unwrap().to_owned();
        let row = after
            .lines()
            .find(|line| line.starts_with("P "))
            .unwrap()
            .to_owned();
        row.split_whitespace().nth(1).unwrap().to_owned()
    };
    assert_eq!(velocities(&run_ok(&args)), "0");
    let vx = figures("peaucellier", "45")["P.vx"];
    assert!(vx != 0.0 && vx.abs() < 1e-13, "{vx}");
}

/// Returns all values of a table by name.
fn figures(scene: &str, at: &str) -> BTreeMap<String, f64> {
    let csv = run_ok(&["table", scene, "--at", at, "--format", "csv"]);
    let number = |row: Vec<String>| Some((row[0].clone(), row[1].parse().ok()?));
    rows(&csv).into_iter().filter_map(number).collect()
}

/// Columns: the value printed in the lectures, the exact value, and the allowed difference of the printed one. Where
/// that is more than half a unit of its last digit, the notes rounded intermediate results.
#[test]
fn four_bar_matches_values_printed_in_lectures() {
    let found = figures("four-bar", "60");
    for (name, printed, exact, off) in [
        ("r3.angle", 29.3795, 29.379_447_783_733_734, 5.3e-5),
        ("r4.angle", 290.7520, 290.752_521_225_055_83, 5.3e-4),
        ("r3.omega", -3.916, -3.916_412_730_164_438_5, 4.2e-4),
        ("r4.omega", 3.091, 3.091_073_219_520_966_5, 7.4e-5),
        ("r3.alpha", 42.27, 42.267_018_333_886_15, 3.0e-3),
        ("r4.alpha", 95.5, 95.503_608_391_121_4, 3.7e-3),
        ("B.a", 22500.0, 22500.0, 1e-9),
        ("B.a.angle", 240.0, 240.0, 1e-9),
        ("C.a", 23994.18, 23_995.093_444_829_12, 0.92),
        ("C.a.angle", 206.47, 206.465_711_769_812_02, 4.3e-3),
        ("r3.com.a", 22260.0, 22_260.223_855_620_69, 0.23),
        ("r3.com.a.angle", 222.68, 222.677_772_617_160_04, 2.3e-3),
        ("r4.com.a", 11997.09, 11_997.546_722_414_56, 0.46),
        ("r4.com.a.angle", 206.47, 206.465_711_769_812_02, 4.3e-3),
    ] {
        let ours = found[name];
        assert!(
            (ours - exact).abs() <= 1e-13 * exact.abs(),
            "{name}: {ours}"
        );
        assert!(
            (ours - printed).abs() <= off,
            "{name}: {ours}, printed {printed}"
        );
    }
}

#[test]
fn slider_crank_matches_values_printed_in_lectures() {
    let found = figures("slider-crank", "30");
    for (name, printed, exact, off) in [
        ("r4.length", 28.0, 28.025_170_768_881_472, 0.026),
        ("r3.angle", 345.5, 345.522_487_814_070_1, 0.023),
        // The notes continued with theta3 = -14.47 and two decimals of r4.
        ("r3.omega", -89.45, -89.442_719_099_991_59, 0.0073),
        ("r4.rate", -1447.93, -1_447.213_595_499_957_9, 0.72),
        ("r3.alpha", 8259.0, 8_262.364_471_909_156, 3.4),
        ("r4.accel", -459_977.6, -460_017.673_002_526_35, 40.1),
    ] {
        let ours = found[name];
        assert!(
            (ours - exact).abs() <= 1e-13 * exact.abs(),
            "{name}: {ours}"
        );
        assert!(
            (ours - printed).abs() <= off,
            "{name}: {ours}, printed {printed}"
        );
    }
    assert_eq!(found["r4.angle"], 180.0);
}

#[test]
fn given_and_found_entries_are_distinguished() {
    let table = json(&run_ok(&["table", "slider-crank", "--format", "json"]));
    let vectors = table["vectors"].as_array().unwrap();
    let given = |name: &str| {
        let vector = vectors.iter().find(|v| v["name"] == name).unwrap();
        vector["given"].clone()
    };
    let rigid = serde_json::json!(["length", "rate", "accel"]);
    let turning = serde_json::json!(["angle", "omega", "alpha"]);
    assert_eq!(given("r2").as_array().unwrap().len(), 6);
    assert_eq!(given("r3"), rigid);
    assert_eq!(given("r4"), turning);

    let csv = rows(&run_ok(&["table", "slider-crank", "--format", "csv"]));
    let entry = |name: &str| csv.iter().find(|row| row[0] == name).unwrap()[3].clone();
    assert_eq!(
        (entry("r3.omega"), entry("r2.omega")),
        ("found".into(), "given".into())
    );
    assert_eq!(
        (entry("A.x"), entry("C.x")),
        ("given".into(), "found".into())
    );
}

/// A vector between two points of one body has constant length and turns with the body.
#[test]
fn vectors_between_points_have_the_given_entries_of_their_body() {
    let mut command = command(&["table", "-", "--format", "json"]);
    let table = json(&run(command.write_stdin(PARALLEL_CRANKS)).out);
    let vectors = table["vectors"].as_array().unwrap();
    let given = |name: &str| {
        let vector = vectors.iter().find(|v| v["name"] == name).unwrap();
        let length = vector["length"].as_f64().unwrap();
        (length, vector["given"].as_array().unwrap().len())
    };
    assert_eq!(given("on_coupler"), (1.0, 3));
    assert_eq!(given("on_crank"), (1.0, 6));
    assert_eq!(given("on_ground"), (1.0, 6));
    let (length, entries) = given("across");
    assert!((length - 13.0_f64.sqrt()).abs() < 1e-15 * 20.0 && entries == 0);
}

#[test]
fn direction_of_non_rotating_link_is_given() {
    let table = json(&run_ok(&["table", "press-ram", "--format", "json"]));
    let vectors = table["vectors"].as_array().unwrap();
    let find = |name: &str| vectors.iter().find(|v| v["name"] == name).unwrap();
    let turning = serde_json::json!(["angle", "omega", "alpha"]);
    // The guide points up, and the vector points back along it.
    assert_eq!(
        (&find("r6")["given"], &find("r6")["angle"]),
        (&turning, &270.0.into())
    );
    assert_eq!(
        (&find("ram")["given"], &find("ram")["angle"]),
        (&turning, &90.0.into())
    );
    assert!(
        find("ram").get("length").is_none(),
        "a link without ends has no length"
    );
}

#[test]
fn driven_slide_length_is_given_but_its_angle_is_found() {
    let table = json(&run_ok(&["table", "excavator-boom", "--format", "json"]));
    let name = table["driver"]["name"].as_str().unwrap();
    let vectors = table["vectors"].as_array().unwrap();
    let rod = vectors.iter().find(|v| v["name"] == name).unwrap();
    assert_eq!(rod["given"], serde_json::json!(["length", "rate", "accel"]));
    assert_eq!(rod["length"], table["driver"]["position"]);
    assert_eq!(rod["rate"], table["driver"]["rate"]);
}

/// JSON, CSV and a sweep contain the same doubles.
#[test]
fn table_and_sweep_agree_to_the_bit() {
    let table = json(&run_ok(&[
        "table",
        "press-ram",
        "--at",
        "77.7",
        "--format",
        "json",
    ]));
    let csv = figures("press-ram", "77.7");
    let args = [
        "sweep",
        "press-ram",
        "--from",
        "77.7",
        "--to",
        "77.7",
        "--format",
        "json",
    ];
    let sweep = json(&run_ok(&args));
    for point in table["points"].as_array().unwrap() {
        let name = point["name"].as_str().unwrap();
        for figure in ["x", "y", "vx", "vy", "ax", "ay"] {
            let column = format!("{name}.{figure}");
            let value = point[figure].as_f64().unwrap();
            assert_eq!(sweep["rows"][0][&column].as_f64(), Some(value), "{column}");
            assert_eq!(csv[&column].to_bits(), value.to_bits(), "{column}");
        }
    }
}

#[test]
fn options_set_digits_and_units() {
    let text = run_ok(&["table", "four-bar", "--digits", "10", "--no-units"]);
    assert!(
        text.contains("\ntheta               60.00000000    29.37944778*"),
        "{text}"
    );
    assert!(text.contains("\nomega"), "{text}");
    let one = run_ok(&["table", "four-bar", "--digits", "1"]);
    assert!(one.contains(" 3e1*"), "{one}");
    let plain = run_ok(&["table", "four-bar", "--format", "csv", "--no-units"]);
    assert!(
        plain.starts_with("name,value,entry\ndriver.angle,60,given\n"),
        "{plain}"
    );
}

#[test]
fn default_position_is_that_of_the_scene() {
    let text = run_ok(&["table", "slider-crank"]);
    assert!(text.contains("\ndriver r2 at 30 deg, 200 rad/s"), "{text}");
}

#[test]
fn wide_tables_wrap_at_80_columns() {
    for scene in ["jansen-leg", "scissor-lift", "press"] {
        let text = run_ok(&["table", scene]);
        assert!(text.lines().all(|line| line.len() <= 80), "{text}");
    }
}

#[test]
fn dead_point_shows_positions_but_no_rates() {
    let facts = json(&run_ok(&["check", "double-rocker", "--format", "json"]));
    let limit = facts["range"][0].to_string();
    let text = run_ok(&["table", "double-rocker", "--at", &limit]);
    assert!(text.contains("\nstate dead-point\n"), "{text}");
    let table = json(&run_ok(&[
        "table",
        "double-rocker",
        "--at",
        &limit,
        "--format",
        "json",
    ]));
    let c = table["points"].as_array().unwrap();
    let c = c.iter().find(|point| point["name"] == "C").unwrap();
    assert!(
        c["x"].is_number() && c["vx"].is_null() && c["a"].is_null(),
        "{c}"
    );
    assert_eq!(table["state"], "dead-point");
}

#[test]
fn position_outside_motion_exits_with_1() {
    let message = refused(1, &["table", "double-rocker", "--at", "5"]);
    assert!(
        message.starts_with(
            "error: the mechanism cannot be assembled at 5 deg: the driver covers 36.8698976458"
        ),
        "{message}"
    );
}

#[test]
fn wide_bound_does_not_hide_the_value() {
    // Bounds grow near a change point; C moves like B, and no value is zero.
    let text = run_ok(&["table", "parallelogram", "--at", "0.01"]);
    let accelerations = text.split("acceleration of points").nth(1).unwrap();
    let row = |point: &str| {
        let mut lines = accelerations.lines();
        let line = lines.find(|line| line.starts_with(point)).unwrap();
        line[1..].to_owned()
    };
    assert!(row("B").contains(" -0.0174533 "), "{text}");
    assert_eq!(row("B"), row("C"));
}

#[test]
fn limits_in_messages_have_enough_digits() {
    // With one digit less than `check` prints, the position is slightly outside.
    let message = refused(1, &["table", "double-rocker", "--at", "36.8698976458"]);
    assert!(
        message.contains("at 36.8698976458 deg: the driver covers 36.86989764584402 to"),
        "{message}"
    );
    let message = refused(1, &["table", "scissor-lift", "--at=-1"]);
    assert!(!message.contains("covers 0."), "{message}");
}

/// The double rocker starts one turn later: an equivalent angle typed by the user is converted.
#[test]
fn table_accepts_equivalent_angle_but_sweep_is_literal() {
    let preset = krank::scene::presets::find("double-rocker").unwrap();
    let scene = preset.text.replace("angle = 60", "angle = 420");
    let table = |at: &str| run(command(&["table", "-", "--at", at]).write_stdin(scene.clone()));
    for at in ["60", "-300", "780"] {
        let output = table(at);
        assert!(
            output.out.contains("driver r2 at 420 deg"),
            "{}",
            output.out
        );
        let note =
            format!("note: using 420 deg instead of {at} deg: the driver covers 396.8698976458");
        assert!(output.err.contains(&note), "{}", output.err);
    }
    assert!(!table("420").err.contains("note: using"));
    let refused = table("180");
    assert!(
        refused.err.contains("cannot be assembled at 180 deg"),
        "{}",
        refused.err
    );
    // `check` prints 36.86989764584402 as 36.869897645844.
    let at_limit = krank(&["table", "double-rocker", "--at", "36.869897645844"]);
    assert!(
        at_limit.out.contains("state dead-point"),
        "{}",
        at_limit.out
    );
    let sweep = [
        "sweep",
        "-",
        "--from",
        "60",
        "--to",
        "60",
        "--step",
        "1",
        "--columns",
        "C.x",
    ];
    let literal = run(command(&sweep).write_stdin(scene));
    assert!(literal.out.contains("60,,no-assembly"), "{}", literal.out);
}

/// Columns by name, pattern and formula are listed in the order given.
#[test]
fn named_columns_are_listed_in_order() {
    let columns = "C.x,C.a.t,r3.*,swing = r4.angle - r3.angle";
    let args = ["table", "four-bar", "--at", "60", "--columns", columns];
    let text = run_ok(&args);
    let expected = "\
Four-bar crank-rocker
driver r2 at 60 deg, 15 rad/s, 0 rad/s^2
state ok

figure                     value
C.x [mm]                 311.417
C.a.t [mm/s^2]           23875.9
r3.angle [deg]           29.3794
r3.omega [rad/s]        -3.91641
";
    assert!(text.starts_with(expected), "{text}");
    assert!(
        text.contains("\nswing [deg]             -98.6269\n"),
        "{text}"
    );
    let rows: Vec<&str> = text.lines().skip(5).collect();
    assert!(
        rows.iter().any(|row| row.starts_with("r3.com.ax [mm/s^2]")),
        "{text}"
    );
    assert!(!text.contains("C.y"), "{text}");

    let csv = run_ok(&[&args[..], &["--bounds", "--format", "csv"]].concat());
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "name,value,unit,bound");
    let cells: Vec<&str> = lines[1].split(',').collect();
    assert_eq!((cells[0], cells[2]), ("C.x", "mm"));
    let [value, bound] = [cells[1], cells[3]].map(|cell| cell.parse::<f64>().unwrap());
    assert!(
        (value - 311.416_953).abs() < 1e-5 && bound > 0.0 && bound < 1e-12,
        "{csv}"
    );
    assert_eq!(*lines.last().unwrap(), "state,ok,,");

    // The doubles and names are those of a row of a sweep.
    let list = json(&run_ok(
        &[&args[..], &["--bounds", "--format", "json"]].concat(),
    ));
    let sweep = [
        "sweep",
        "four-bar",
        "--from",
        "60",
        "--to",
        "60",
        "--columns",
        columns,
    ];
    let sweep = json(&run_ok(
        &[&sweep[..], &["--bounds", "--format", "json"]].concat(),
    ));
    let row = sweep["rows"][0].as_object().unwrap();
    let figures = list["figures"].as_object().unwrap();
    let named = |name: &&String| *name != "state" && *name != "driver.angle";
    assert!(figures.keys().eq(row.keys().filter(named)), "{list}");
    for (name, value) in figures {
        assert_eq!(*value, row[name], "{name}");
    }
    assert_eq!(list["units"]["swing"], "deg");
    assert_eq!(list["driver"]["angle"], 60.0);
    assert_eq!(list["state"], "ok");
}

/// A value that does not exist is not printed as zero. A misspelled name gives the same message as in a sweep.
#[test]
fn named_values_that_do_not_exist_are_empty() {
    let args = ["table", "four-bar", "--columns", "A.v.angle,A.v"];
    let text = run_ok(&args);
    let row = text
        .lines()
        .find(|line| line.starts_with("A.v.angle"))
        .unwrap();
    assert!(row.ends_with(" -"), "{text}");
    let csv = run_ok(&[&args[..], &["--format", "csv", "--no-units"]].concat());
    assert_eq!(csv, "name,value\nA.v.angle,\nA.v,0\nstate,ok\n");
    let output = refused(2, &["table", "four-bar", "--columns", "C.z"]);
    let same = refused(2, &["sweep", "four-bar", "--columns", "C.z"]);
    assert_eq!(output, same);
}

/// The sensitivity of a named formula to the lengths.
#[test]
fn named_formula_has_a_sensitivity() {
    let columns = "swing = r4.angle - r3.angle";
    let args = ["table", "four-bar", "--columns", columns, "--sensitivity"];
    let csv = run_ok(&[&args[..], &["--format", "csv"]].concat());
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "name,value,unit,sensitivity,most,by");
    assert!(lines[1].starts_with("swing,-98."), "{csv}");
    let worst: f64 = lines[1].split(',').nth(3).unwrap().parse().unwrap();
    assert!(worst > 0.1, "{csv}");
    assert!(run_ok(&args).contains("swing [deg]"));
}

/// A printed screen never shows another coordinate than the typed one.
#[cfg(feature = "tui")]
#[test]
fn printed_screen_refuses_coordinate_outside_the_range() {
    let table = refused(1, &["table", "excavator-boom", "--at", "99"]);
    assert_eq!(
        refused(1, &["excavator-boom", "--print", "--at", "99"]),
        table
    );
    let screen = run_ok(&["excavator-boom", "--print", "--at", "2,1"]);
    assert!(screen.contains("2.1"), "{screen}");
}
