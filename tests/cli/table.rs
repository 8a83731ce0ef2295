//! `table`: the lectures' tables, and the figures that the lectures print.

use super::{PARALLEL_CRANKS, command, done, json, krank, refused, rows, run};
use std::collections::BTreeMap;

#[test]
fn the_tables_of_the_four_bar_are_laid_out_as_in_the_lectures() {
    let text = done(&["table", "four-bar", "--at", "60"]);
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

* found; entries without a star are given

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

/// A line per figure that some length changes: at the worst, and by the length that matters most.
#[test]
fn sensitivity_stands_apart_from_the_figures() {
    let args = ["table", "four-bar", "--sensitivity"];
    let text = done(&args);
    let (tables, lengths) = text.split_once("\nchange for 1 mm").unwrap();
    assert_eq!(format!("{tables}\n"), done(&args[..2]) + "\n");
    assert!(
        lengths.contains("\nC.x [mm]                       4.18    0.946  r3.length\n"),
        "{text}"
    );
    assert!(!lengths.contains("A.x [mm]"), "{text}");

    let csv = done(&[&args[..], &["--format", "csv"]].concat());
    let header = csv.lines().next().unwrap();
    assert_eq!(header, "name,value,unit,entry,sensitivity,most,by");
    let by_name: BTreeMap<String, Vec<String>> = rows(&csv)
        .into_iter()
        .map(|row| (row[0].clone(), row))
        .collect();
    assert_eq!(by_name["C.x"][5], "r3.length");
    assert_eq!(by_name["r2.length"][4], "");
    assert_eq!(by_name["r2.angle"][4..], ["0", "", ""]);

    let object = json(&done(&[&args[..], &["--format", "json"]].concat()));
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

/// A figure that turns over within rounding keeps its value: its sensitivity is missing, and a note says so.
#[test]
fn a_figure_without_a_sensitivity_is_counted() {
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
        let heard = krank(args);
        assert_eq!(heard.code, 0, "{}", heard.err);
        let counts = match args[0] {
            "table" => "note: 1 of 2 values",
            _ => "note: 11 of 22 values",
        };
        assert!(heard.err.starts_with(counts), "{}", heard.err);
        assert!(heard.err.contains("have no derivatives"), "{}", heard.err);
    }
    let heard = krank(&["table", "four-bar", "--columns", "C.*", "--sensitivity"]);
    assert_eq!(heard.err, "");
}

/// A comma is what stands between figures; a number that has one is mended, and one that has a point is not touched.
#[test]
fn a_comma_in_a_formula_is_told() {
    for columns in ["a = 1,5 mm", "C.x,a = C.x + 1,5 mm", "a = (1,5 mm)"] {
        let told = refused(2, &["table", "four-bar", "--columns", columns]);
        assert!(told.contains("`1.5`"), "{told}");
    }
    let told = refused(2, &["table", "four-bar", "--columns", "a = C.x,5 mm"]);
    assert!(told.contains("5 mm") && !told.contains(".5"), "{told}");
}

/// With other lengths three parallel cranks would jam: nothing is made up, and it is said why.
#[test]
fn where_there_is_no_sensitivity_it_is_said() {
    let mut command = command(&["table", "-", "--sensitivity", "--format", "json"]);
    let heard = run(command.write_stdin(PARALLEL_CRANKS));
    assert_eq!(heard.code, 0);
    assert!(json(&heard.out)["sensitivity"].is_null(), "{}", heard.out);
    assert!(
        heard.err.starts_with("note: no derivatives by the lengths"),
        "{}",
        heard.err
    );
    let text = krank(&["table", "triple-parallelogram", "--sensitivity"]).out;
    assert!(text.contains("change for 1 mm: no derivatives"), "{text}");
    assert!(text.lines().all(|line| line.len() <= 80), "{text}");
}

/// A line below the figures, two digits and never too small; in CSV and JSON beside each figure.
#[test]
fn bounds_stand_below_the_figures() {
    let args = ["table", "four-bar", "--bounds"];
    let text = done(&args);
    let without: Vec<&str> = text
        .lines()
        .filter(|line| !line.starts_with("  +-") && !line.starts_with("+-"))
        .collect();
    assert_eq!(without.join("\n") + "\n", done(&args[..2]));

    let csv = done(&[&args[..], &["--format", "csv"]].concat());
    assert!(csv.starts_with("name,value,unit,entry,bound\n"), "{csv}");
    let object = json(&done(&[&args[..], &["--format", "json"]].concat()));
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

/// At a change point nothing is proved of rates that are limits, and that is said.
#[test]
fn where_no_bound_is_proved_it_is_said() {
    let args = ["table", "parallelogram", "--at", "0", "--bounds"];
    let heard = krank(&args);
    assert_eq!(heard.code, 0);
    assert!(
        heard.err.contains(" values have no error bound: "),
        "{}",
        heard.err
    );
    let rates = heard.out.split("\nomega").nth(1).unwrap();
    let bounds = rates.lines().nth(1).unwrap();
    assert_eq!(
        bounds.split_whitespace().collect::<Vec<_>>(),
        ["+-", "0", "?", "?", "0"]
    );
    let heard = krank(&[&args[..], &["--format", "csv"]].concat());
    let row = rows(&heard.out)
        .into_iter()
        .find(|row| row[0] == "r4.omega");
    assert_eq!(row.unwrap()[2..], ["rad/s", "found", ""]);
}

/// What rounding leaves of a zero is shown as zero, and as it is where all digits are asked for.
#[test]
fn zero_is_shown_where_the_bound_says_so() {
    // The cell draws a straight line: P moves along y alone.
    let args = ["table", "peaucellier", "--at", "45"];
    let velocities = |text: &str| {
        let behind = text.split("velocity of points").nth(1).unwrap().to_owned();
        let row = behind
            .lines()
            .find(|line| line.starts_with("P "))
            .unwrap()
            .to_owned();
        row.split_whitespace().nth(1).unwrap().to_owned()
    };
    assert_eq!(velocities(&done(&args)), "0");
    let vx = figures("peaucellier", "45")["P.vx"];
    assert!(vx != 0.0 && vx.abs() < 1e-13, "{vx}");
}

/// All figures of a table by name.
fn figures(scene: &str, at: &str) -> BTreeMap<String, f64> {
    let csv = done(&["table", scene, "--at", at, "--format", "csv"]);
    let number = |row: Vec<String>| Some((row[0].clone(), row[1].parse().ok()?));
    rows(&csv).into_iter().filter_map(number).collect()
}

/// What the lectures print, the exact value, and by how much the printed one may be off: where that
/// is more than half a unit of its last digit, the notes rounded on the way.
#[test]
fn the_printed_figures_of_the_four_bar() {
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
fn the_printed_figures_of_the_slider_crank() {
    let found = figures("slider-crank", "30");
    for (name, printed, exact, off) in [
        ("r4.length", 28.0, 28.025_170_768_881_472, 0.026),
        ("r3.angle", 345.5, 345.522_487_814_070_1, 0.023),
        // The notes went on with theta3 = -14.47 and two decimals of r4.
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
fn given_entries_are_told_from_found_ones() {
    let table = json(&done(&["table", "slider-crank", "--format", "json"]));
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

    let csv = rows(&done(&["table", "slider-crank", "--format", "csv"]));
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

/// A vector between two points of one body keeps its length and turns as the body does.
#[test]
fn vectors_between_points_are_given_as_far_as_their_body_is() {
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
fn a_link_that_cannot_turn_has_its_direction_given() {
    let table = json(&done(&["table", "press-ram", "--format", "json"]));
    let vectors = table["vectors"].as_array().unwrap();
    let find = |name: &str| vectors.iter().find(|v| v["name"] == name).unwrap();
    let turning = serde_json::json!(["angle", "omega", "alpha"]);
    // The guide points up, and the vector runs back along it.
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
fn a_driven_slide_is_given_and_what_it_turns_is_found() {
    let table = json(&done(&["table", "excavator-boom", "--format", "json"]));
    let name = table["driver"]["name"].as_str().unwrap();
    let vectors = table["vectors"].as_array().unwrap();
    let rod = vectors.iter().find(|v| v["name"] == name).unwrap();
    assert_eq!(rod["given"], serde_json::json!(["length", "rate", "accel"]));
    assert_eq!(rod["length"], table["driver"]["position"]);
    assert_eq!(rod["rate"], table["driver"]["rate"]);
}

/// The forms say the same, and a sweep says it too.
#[test]
fn table_and_sweep_agree_to_the_bit() {
    let table = json(&done(&[
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
    let sweep = json(&done(&args));
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
fn digits_and_units_are_as_asked() {
    let text = done(&["table", "four-bar", "--digits", "10", "--no-units"]);
    assert!(
        text.contains("\ntheta               60.00000000    29.37944778*"),
        "{text}"
    );
    assert!(text.contains("\nomega"), "{text}");
    let one = done(&["table", "four-bar", "--digits", "1"]);
    assert!(one.contains(" 3e1*"), "{one}");
    let bare = done(&["table", "four-bar", "--format", "csv", "--no-units"]);
    assert!(
        bare.starts_with("name,value,entry\ndriver.angle,60,given\n"),
        "{bare}"
    );
}

#[test]
fn a_scene_opens_where_it_says() {
    let text = done(&["table", "slider-crank"]);
    assert!(text.contains("\ndriver r2 at 30 deg, 200 rad/s"), "{text}");
}

#[test]
fn wide_scenes_wrap_to_a_plain_terminal() {
    for scene in ["jansen-leg", "scissor-lift", "press"] {
        let text = done(&["table", scene]);
        assert!(text.lines().all(|line| line.len() <= 80), "{text}");
    }
}

#[test]
fn at_a_dead_point_positions_are_shown_and_rates_are_not() {
    let facts = json(&done(&["check", "double-rocker", "--format", "json"]));
    let limit = facts["range"][0].to_string();
    let text = done(&["table", "double-rocker", "--at", &limit]);
    assert!(text.contains("\nstate dead-point\n"), "{text}");
    let table = json(&done(&[
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
fn outside_the_motion_there_is_no_table() {
    let message = refused(1, &["table", "double-rocker", "--at", "5"]);
    assert!(
        message.starts_with(
            "error: the mechanism cannot be assembled at 5 deg: the driver covers 36.8698976458"
        ),
        "{message}"
    );
}

#[test]
fn a_wide_bound_hides_no_figure() {
    // Bounds grow close to a change point; C moves as B does, and nothing of it is zero.
    let text = done(&["table", "parallelogram", "--at", "0.01"]);
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
fn limits_in_a_message_do_not_read_like_what_was_asked_for() {
    // A digit less than `check` prints is outside by a little.
    let message = refused(1, &["table", "double-rocker", "--at", "36.8698976458"]);
    assert!(
        message.contains("at 36.8698976458 deg: the driver covers 36.86989764584402 to"),
        "{message}"
    );
    let message = refused(1, &["table", "scissor-lift", "--at=-1"]);
    assert!(!message.contains("covers 0."), "{message}");
}

/// A double rocker that opens a turn on: what a person types is taken the one place that is meant.
#[test]
fn a_place_that_is_some_turns_away_is_meant_and_a_sweep_is_literal() {
    let preset = krank::scene::presets::find("double-rocker").unwrap();
    let scene = preset.text.replace("angle = 60", "angle = 420");
    let table = |at: &str| run(command(&["table", "-", "--at", at]).write_stdin(scene.clone()));
    for at in ["60", "-300", "780"] {
        let heard = table(at);
        assert!(heard.out.contains("driver r2 at 420 deg"), "{}", heard.out);
        let note =
            format!("note: using 420 deg instead of {at} deg: the driver covers 396.8698976458");
        assert!(heard.err.contains(&note), "{}", heard.err);
    }
    assert!(!table("420").err.contains("taken as"));
    let refused = table("180");
    assert!(
        refused.err.contains("cannot be assembled at 180 deg"),
        "{}",
        refused.err
    );
    // 36.869897645844 is what `check` prints of 36.86989764584402.
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

/// Figures by name, pattern and formula, in the order in which they were named.
#[test]
fn figures_that_are_named_stand_line_by_line() {
    let columns = "C.x,C.a.t,r3.*,swing = r4.angle - r3.angle";
    let args = ["table", "four-bar", "--at", "60", "--columns", columns];
    let text = done(&args);
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

    let csv = done(&[&args[..], &["--bounds", "--format", "csv"]].concat());
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

    // The same doubles as in a row of a sweep, under the same names.
    let list = json(&done(
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
    let sweep = json(&done(
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

/// What does not exist is no zero, and what is misspelt is told as in a sweep.
#[test]
fn named_figures_that_do_not_exist_are_empty() {
    let args = ["table", "four-bar", "--columns", "A.v.angle,A.v"];
    let text = done(&args);
    let row = text
        .lines()
        .find(|line| line.starts_with("A.v.angle"))
        .unwrap();
    assert!(row.ends_with(" -"), "{text}");
    let csv = done(&[&args[..], &["--format", "csv", "--no-units"]].concat());
    assert_eq!(csv, "name,value\nA.v.angle,\nA.v,0\nstate,ok\n");
    let told = refused(2, &["table", "four-bar", "--columns", "C.z"]);
    let same = refused(2, &["sweep", "four-bar", "--columns", "C.z"]);
    assert_eq!(told, same);
}

/// What the lengths do to a formula that was named.
#[test]
fn named_figures_have_their_sensitivity() {
    let columns = "swing = r4.angle - r3.angle";
    let args = ["table", "four-bar", "--columns", columns, "--sensitivity"];
    let csv = done(&[&args[..], &["--format", "csv"]].concat());
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "name,value,unit,sensitivity,most,by");
    assert!(lines[1].starts_with("swing,-98."), "{csv}");
    let worst: f64 = lines[1].split(',').nth(3).unwrap().parse().unwrap();
    assert!(worst > 0.1, "{csv}");
    assert!(done(&args).contains("swing [deg]"));
}
