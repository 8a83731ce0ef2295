//! Tests of `sweep`: columns, rows and numbers.

use super::{Run, command, folder, json, krank, refused, rows, run, run_ok};

fn header(csv: &str) -> &str {
    csv.lines().next().unwrap()
}

/// Returns the first column as text.
fn driver(csv: &str) -> Vec<String> {
    rows(csv).into_iter().map(|row| row[0].clone()).collect()
}

#[test]
fn columns_have_units_and_lie_between_driver_and_state() {
    let args = ["sweep", "four-bar", "--to", "0", "--columns"];
    let sweep = |columns| run_ok(&[&args[..], &[columns]].concat());
    assert_eq!(
        header(&sweep("C.x,C.vx,r4.omega")),
        "driver.angle [deg],C.x [mm],C.vx [mm/s],r4.omega [rad/s],state"
    );
    assert_eq!(
        header(&sweep("r3.com.a*, r3.alpha")),
        "driver.angle [deg],r3.com.ax [mm/s^2],r3.com.ay [mm/s^2],r3.alpha [rad/s^2],state"
    );
    assert_eq!(
        header(&sweep("*.omega")),
        "driver.angle [deg],r2.omega [rad/s],r3.omega [rad/s],r4.omega [rad/s],r1.omega [rad/s],state"
    );
    assert_eq!(
        header(&sweep("state,C.x,driver.angle,C.x")),
        "driver.angle [deg],C.x [mm],state"
    );
    let plain = run_ok(&[
        "sweep",
        "four-bar",
        "--to",
        "0",
        "--columns",
        "C.*",
        "--no-units",
    ]);
    assert_eq!(
        header(&plain),
        "driver.angle,C.x,C.y,C.vx,C.vy,C.ax,C.ay,state"
    );
}

#[test]
fn default_columns_are_all_vectors_and_points() {
    let csv = run_ok(&["sweep", "slider-crank", "--to", "0"]);
    let names: Vec<_> = header(&csv).split(',').collect();
    assert_eq!(names.len(), 1 + 2 * 3 + 6 + 4 * 6 + 1, "{names:?}");
    for name in [
        "r3.angle [deg]",
        "r4.length [cm]",
        "r3.com.ay [cm/s^2]",
        "A.x [cm]",
    ] {
        assert!(names.contains(&name), "{name}");
    }
}

#[test]
fn driven_slide_writes_driver_position() {
    let csv = run_ok(&["sweep", "excavator-boom"]);
    assert!(header(&csv).starts_with("driver.position [m],"), "{csv}");
    let rows = rows(&csv);
    assert!((100..=252).contains(&rows.len()), "{} rows", rows.len());
}

#[test]
fn driver_values_are_the_nearest_doubles() {
    let csv = run_ok(&["sweep", "four-bar", "--step", "0.1", "--columns", "C.x"]);
    let written = driver(&csv);
    assert_eq!(written.len(), 3601);
    for (k, cell) in written.iter().enumerate() {
        let exact = format!("{}.{}", k / 10, k % 10);
        assert_eq!(cell.parse::<f64>(), exact.parse(), "row {k}");
    }
}

#[test]
fn range_and_step_signs_give_expected_rows() {
    let at = |args: &[&str]| {
        let all = [&["sweep", "four-bar", "--columns", "C.x"], args].concat();
        driver(&run_ok(&all))
    };
    assert_eq!(at(&["--from", "60", "--to", "60"]), ["60"]);
    assert_eq!(
        at(&["--from", "-10", "--to", "10", "--step", "10"]),
        ["-10", "0", "10"]
    );
    assert_eq!(
        at(&["--from", "1", "--to", "0", "--step", "-.5"]),
        ["1", "0.5", "0"]
    );
    assert_eq!(
        at(&["--from", "0", "--to", "1", "--step", "0.4"]),
        ["0", "0.4", "0.8"]
    );
    assert_eq!(at(&["--step", "100"]), ["0", "100", "200", "300", "360"]);
    assert_eq!(at(&["--step", "-180"]), ["360", "180", "0"]);
    assert_eq!(at(&["--from", "30", "--step", "200"]), ["30", "230", "390"]);
    assert_eq!(at(&["--from=-1e0", "--to=+1E0"]), ["-1", "0", "1"]);
}

/// A default sweep starts and ends exactly at the limits, where positions exist but rates do not.
#[test]
fn default_range_ends_at_limits_with_positions_but_no_rates() {
    let facts = json(&run_ok(&["check", "double-rocker", "--format", "json"]));
    let csv = run_ok(&["sweep", "double-rocker", "--columns", "C.x,C.vx,C.ax"]);
    let rows = rows(&csv);
    for (row, limit) in [(&rows[0], 0), (&rows[rows.len() - 1], 1)] {
        assert_eq!(row[0].parse(), Ok(facts["range"][limit].as_f64().unwrap()));
        assert_eq!(row[4], "dead-point");
        assert!(row[1].parse::<f64>().is_ok());
        assert_eq!(row[2..4], ["", ""]);
    }
    let inside = &rows[1..rows.len() - 1];
    assert!(
        inside
            .iter()
            .all(|row| row[4] == "ok" && row.iter().all(|c| !c.is_empty()))
    );
}

#[test]
fn rows_outside_motion_are_empty_and_counted() {
    let args = [
        "sweep",
        "double-rocker",
        "--from",
        "0",
        "--to",
        "90",
        "--step",
        "45",
    ];
    let Run { code, out, err } = krank(&[&args[..], &["--columns", "C.*"]].concat());
    assert_eq!(code, 0, "{err}");
    let rows = rows(&out);
    assert_eq!(rows[0], ["0", "", "", "", "", "", "", "no-assembly"]);
    assert_eq!(rows[1][7], "ok");
    assert!(
        err.starts_with("note: 1 of 3 rows are outside the motion"),
        "{err}"
    );
    assert!(err.contains("36.8698976458"), "{err}");

    let json_rows = krank(&[&args[..], &["--columns", "C.x", "--format", "json"]].concat());
    let first = &json(&json_rows.out)["rows"][0];
    assert_eq!(
        first,
        &serde_json::json!({"driver.angle": 0, "C.x": null, "state": "no-assembly"})
    );
}

#[test]
fn sweep_entirely_outside_motion_exits_with_1() {
    let run = krank(&["sweep", "double-rocker", "--from", "0", "--to", "10"]);
    assert_eq!(run.code, 1);
    assert!(
        run.err
            .starts_with("error: no row of the sweep is within the motion"),
        "{}",
        run.err
    );
    assert_eq!(rows(&run.out).len(), 11);
}

#[test]
fn sweep_rejects_invalid_ranges_and_columns() {
    for (args, phrase) in [
        (&["--step", "0"][..], "the step must not be 0"),
        (
            &["--step", "nan"],
            "'--step <STEP>': must be a finite number",
        ),
        (
            &["--from", "-inf"],
            "'--from <COORDINATE>': must be a finite number",
        ),
        (
            &["--to", "1e999"],
            "'--to <COORDINATE>': must be a finite number",
        ),
        (&["--to", "x"], "'--to <COORDINATE>': must be a number"),
        (&["--step", "1e-8"], "more than 10^9 rows"),
        (
            &["--from", "9", "--to", "1"],
            "does not lead from 9 to 1: use -1",
        ),
        (
            &["--columns", "C.q"],
            "--columns: no quantity is named `C.q`",
        ),
        (&["--columns", "C.x,E.*"], "`E.*`"),
        (
            &["--columns", "C.x.bound"],
            "`C.x.bound`; name `C.x`: --bounds adds `C.x.bound`",
        ),
        (&["--columns", ""], "no quantity is named"),
    ] {
        let message = refused(2, &[&["sweep", "four-bar"], args].concat());
        assert!(message.contains(phrase), "{args:?}: {message}");
    }
}

/// CSV, JSON and text agree; CSV and JSON to the last bit.
#[test]
fn formats_agree() {
    let args = ["sweep", "press-ram", "--step", "7.3", "--format"];
    let csv = rows(&run_ok(&[&args[..], &["csv"]].concat()));
    let parsed = json(&run_ok(&[&args[..], &["json"]].concat()));
    let text = run_ok(&[&args[..], &["text", "--digits", "4"]].concat());
    let names = parsed["units"].as_object().unwrap();
    assert_eq!(parsed["rows"].as_array().unwrap().len(), csv.len());
    assert_eq!(text.lines().count(), csv.len() + 1);
    for ((row, object), line) in csv
        .iter()
        .zip(parsed["rows"].as_array().unwrap())
        .zip(text.lines().skip(1))
    {
        let shown: Vec<_> = line.split_whitespace().collect();
        for (i, name) in names.keys().enumerate() {
            let exact: f64 = row[i].parse().unwrap();
            assert_eq!(object[name].as_f64().unwrap().to_bits(), exact.to_bits());
            let rounded: f64 = shown[i].parse().unwrap();
            let slack = 1e-3 * exact.abs();
            let turned = name.ends_with(".angle") && rounded == 0.0 && exact > 359.0;
            // Text shows zero if the value may be nothing but rounding error.
            let zero = rounded == 0.0 && exact.abs() < 1e-9;
            assert!(
                (rounded - exact).abs() <= slack || turned || zero,
                "{name}: {line}"
            );
        }
        assert_eq!(row.last().unwrap(), object["state"].as_str().unwrap());
    }
}

#[test]
fn text_columns_line_up() {
    let text = run_ok(&["sweep", "four-bar", "--columns", "C.*", "--format", "text"]);
    let ends = |line: &str| line.find("state").or_else(|| line.find("ok"));
    let first = ends(text.lines().next().unwrap()).unwrap();
    assert!(text.lines().all(|line| ends(line) == Some(first)), "{text}");
}

#[test]
fn angles_are_normalized_but_driver_counts_turns() {
    let csv = run_ok(&[
        "sweep",
        "four-bar",
        "--from",
        "-720",
        "--to",
        "720",
        "--columns",
        "*.angle",
    ]);
    for row in rows(&csv) {
        for cell in &row[1..row.len() - 1] {
            assert!(
                (0.0..360.0).contains(&cell.parse::<f64>().unwrap()),
                "{cell}"
            );
        }
    }
    assert_eq!(driver(&csv).first().unwrap(), "-720");
}

/// Values after whole turns are the same to the last bit.
#[test]
fn rows_are_identical_after_ten_million_turns() {
    let values = |from: &str, to: &str| {
        let csv = run_ok(&[
            "sweep",
            "jansen-leg",
            "--from",
            from,
            "--to",
            to,
            "--step",
            "7",
        ]);
        let rows = rows(&csv).into_iter();
        rows.map(|row| row[1..].to_vec()).collect::<Vec<_>>()
    };
    assert_eq!(values("0", "360"), values("3600000000", "3600000360"));
}

/// Bound and sensitivity follow their value, each in its own column.
#[test]
fn bound_and_sensitivity_follow_their_column() {
    let args = [
        "sweep",
        "four-bar",
        "--columns",
        "C.x,r4.omega",
        "--step",
        "60",
    ];
    let plain = run_ok(&args);
    let both = run_ok(&[&args[..], &["--bounds", "--sensitivity"]].concat());
    let header = "driver.angle [deg],C.x [mm],C.x.bound [mm],C.x.sensitivity [mm per mm],\
        r4.omega [rad/s],r4.omega.bound [rad/s],r4.omega.sensitivity [rad/s per mm],state";
    assert_eq!(both.lines().next().unwrap(), header);
    for (row, plain) in rows(&both).iter().zip(rows(&plain)) {
        let figures = [&row[0], &row[1], &row[4], &row[7]];
        assert!(figures.iter().zip(&plain).all(|(a, b)| *a == b), "{row:?}");
        let cell = |i: usize| row[i].parse::<f64>().unwrap();
        // At 180 deg C.x is 177.5, exactly.
        assert!(cell(2) > 0.0 && cell(2) < 1e-11, "{row:?}");
        assert!(cell(5) > 0.0 && cell(5) < 1e-12, "{row:?}");
        assert!(
            (0.5..20.0).contains(&cell(3)) && (0.01..1.0).contains(&cell(6)),
            "{row:?}"
        );
    }
    let names = [&args[..], &["--bounds", "--no-units"]].concat();
    assert!(
        run_ok(&names).starts_with("driver.angle,C.x,C.x.bound,r4.omega,r4.omega.bound,state\n")
    );
    // JSON has the same bounds, to the bit.
    let object = json(&run_ok(
        &[&args[..], &["--bounds", "--format", "json"]].concat(),
    ));
    assert_eq!(object["units"]["C.x.bound"], "mm");
    let first = rows(&both)[0][2].parse::<f64>().unwrap();
    assert_eq!(object["rows"][0]["C.x.bound"].as_f64().unwrap(), first);
    let text = run_ok(&[&args[..], &["--bounds", "--format", "text"]].concat());
    assert_eq!(text.matches(" +-").count(), 2 * 7, "{text}");
}

/// Unknown bounds and sensitivities are empty cells, and a note counts them.
#[test]
fn unknown_errors_are_empty_and_counted() {
    let output = krank(&[
        "sweep",
        "parallelogram",
        "--columns",
        "C.vx",
        "--step",
        "90",
        "--bounds",
        "--sensitivity",
    ]);
    assert_eq!(output.code, 0);
    let empty: Vec<bool> = rows(&output.out)
        .iter()
        .map(|row| row[2].is_empty())
        .collect();
    // Change points at 0, 180 and 360 deg are limits, where nothing can be proved.
    assert_eq!(empty, [true, false, true, false, true]);
    assert!(
        rows(&output.out)
            .iter()
            .all(|row| row[2].is_empty() == row[3].is_empty())
    );
    assert!(
        output
            .err
            .starts_with("note: 3 of 5 values have no error bound: "),
        "{}",
        output.err
    );
    assert!(
        output
            .err
            .contains("note: in 3 of 5 rows no derivatives by the lengths exist"),
        "{}",
        output.err
    );
}

/// Regression test: this ran practically forever. Too many derivatives are now rejected at once.
#[test]
fn sensitivity_rejects_too_many_derivatives() {
    let mut text = "[ground]\nA = [0, 0]\n".to_owned();
    let (mut links, mut start) = (String::new(), String::new());
    for i in 0..400 {
        let (x, next) = (4 * i + 4, i + 1);
        text += &format!("D{i} = [{x}, 0]\n");
        links += &format!("a{i} = {{ from = \"P{i}\", to = \"P{next}\", length = 4 }}\n");
        links += &format!("b{i} = {{ from = \"D{i}\", to = \"P{next}\", length = 2.5 }}\n");
        start += &format!("P{next} = [{x}, 2.4]\n");
    }
    let crank = "c = { from = \"A\", to = \"P0\", length = 1 }";
    text +=
        &format!("[driver]\nlink = \"c\"\nangle = 60\n[links]\n{crank}\n{links}[start]\n{start}");
    for args in [
        &["table", "-"][..],
        &["sweep", "-", "--from", "60", "--to", "60"],
    ] {
        let mut command = command(&[args, &["--sensitivity"]].concat());
        let output = run(command.write_stdin(text.as_str()));
        assert_eq!(output.code, 2, "{}", output.err);
        assert!(output.err.contains("are too many"), "{}", output.err);
    }
}

/// Patterns do not match derived columns; these appear only by name.
#[test]
fn derived_columns_appear_only_when_named() {
    let all = run_ok(&["sweep", "four-bar-load", "--to", "0", "--no-units"]);
    let starred = [
        "sweep",
        "four-bar-load",
        "--to",
        "0",
        "--no-units",
        "--columns",
        "*",
    ];
    assert_eq!(header(&run_ok(&starred)), header(&all));
    for column in ["C.v", "C.a.t", "ground.f", "r3.com.a.angle"] {
        assert!(!header(&all).split(',').any(|name| name == column));
        let args = [
            "sweep",
            "four-bar-load",
            "--to",
            "0",
            "--no-units",
            "--columns",
        ];
        let csv = run_ok(&[&args[..], &[column]].concat());
        assert_eq!(header(&csv), format!("driver.angle,{column},state"));
    }
    let sweep = ["sweep", "four-bar", "--to", "0", "--columns"];
    assert!(refused(2, &[&sweep[..], &["C.u.angle"]].concat()).contains("C.v.angle"));
    let message = refused(2, &[&sweep[..], &["ground.f"]].concat());
    assert!(message.contains("no loads, springs or masses"), "{message}");
}

/// A formula gives what a spreadsheet would compute from the cells of its row.
#[test]
fn formula_equals_arithmetic_of_its_cells() {
    let csv = run_ok(&[
        "sweep",
        "four-bar",
        "--step",
        "7",
        "--columns",
        "r3.angle,r4.angle,C.x,C.vx,C.vy,swing = r3.angle - r4.angle,v = hypot(C.vx, C.vy),C.v",
        "--columns",
        "time-of-way = (C.x - 1 cm) / v",
    ]);
    assert!(header(&csv).ends_with("swing [deg],v [mm/s],C.v [mm/s],time-of-way [s],state"));
    let mut turns = 0;
    for row in rows(&csv) {
        let cell = |i: usize| row[i].parse::<f64>().unwrap();
        let [three, four, x, vx, vy] = [1, 2, 3, 4, 5].map(cell);
        let distance = three - four;
        let way = distance - 360.0 * ((distance - 180.0) / 360.0).ceil();
        turns += usize::from(way != distance);
        assert_eq!(cell(6), way);
        assert_eq!(cell(7), vx.hypot(vy));
        assert_eq!(cell(8), cell(7));
        assert_eq!(cell(9), (x - 10.0) / vx.hypot(vy));
    }
    assert!(turns > 5, "{turns}");
}

/// Rows solved together, eight at a time, equal the rows solved alone, even if they diverge. If
/// only one argument of `min` or `max` exists, the result does not exist.
#[test]
fn rows_solved_together_equal_rows_solved_alone() {
    for formula in [
        "x = max(0 deg, driver.angle - r4.angle)",
        "x = min(driver.angle - r4.angle, 200 deg)",
        "x = max(0, 1 / sin(driver.angle))",
        "x = abs(driver.angle - r4.angle)",
    ] {
        let sweep = |more: &[&str]| {
            let all = ["sweep", "four-bar", "--no-units", "--columns", formula];
            run_ok(&[&all[..], more].concat())
        };
        let together = sweep(&["--step", "15"]);
        for row in rows(&together) {
            let alone = sweep(&["--from", &row[0], "--to", &row[0]]);
            assert_eq!(rows(&alone)[0], row, "{formula}");
        }
    }
    let columns = "a = max(0 mm, C.x / (A.x / (1 mm))),b = min(sqrt(-1 mm * (1 mm)), C.x)";
    let csv = run_ok(&[
        "sweep",
        "four-bar",
        "--to",
        "0",
        "--no-units",
        "--bounds",
        "--columns",
        columns,
    ]);
    assert_eq!(rows(&csv)[0][1..5], ["", "", "", ""], "{csv}");
}

/// If a product underflows, no bound could cover the loss, so there is no value.
#[test]
fn underflow_in_products_gives_no_value() {
    let columns = "u = 1e-200 * 1e-200 * 1e300 * 1e90,v = 1e-200 * C.x * 1e-200 * 1e300,w = 0 * C.x,z = 1e-150 / 1e150";
    let csv = run_ok(&[
        "sweep",
        "four-bar",
        "--to",
        "0",
        "--no-units",
        "--bounds",
        "--columns",
        columns,
    ]);
    assert_eq!(
        rows(&csv)[0][1..9],
        ["", "", "", "", "0", "0", "", ""],
        "{csv}"
    );
}

/// Underflow also gives no value if it happens in a literal, in a conversion to radians or in the
/// sine of a tiny angle. A tiny length is right, and its bound covers its error.
#[test]
fn underflow_in_intermediate_results_gives_no_value() {
    let columns = "a = 1e-310 * 1e300,b = sin(1e-305 deg * 1e-4) * 1e300,c = atan2(1e-309 * C.x, C.x) / 1e-300 deg,\
                   d = hypot(3e-160, 4e-160) * 1e160,e = hypot(3e-170 mm, 4e-170 mm) / 1e-170 mm,f = sin(180 deg),\
                   g = sin(0 deg) * 1e300,h = hypot(0, 4e-160) * 1e160";
    let csv = run_ok(&[
        "sweep",
        "four-bar",
        "--to",
        "0",
        "--no-units",
        "--bounds",
        "--columns",
        columns,
    ]);
    let row = &rows(&csv)[0];
    assert_eq!(row[1..7], [""; 6], "{csv}");
    for (at, truth) in [(7, 5.0), (9, 5.0), (15, 4.0)] {
        let [value, bound] = [at, at + 1].map(|i: usize| row[i].parse::<f64>().unwrap());
        let off = (value - truth).abs();
        assert!(off <= bound && bound < 1e-14, "{off:e} of {bound:e}: {csv}");
        assert!(bound > 0.0, "{csv}");
    }
    assert_eq!([&row[11], &row[13]], ["0"; 2], "{csv}");
    for at in [12, 14] {
        assert!(row[at].parse::<f64>().unwrap() < 1e-30, "{csv}");
    }
}

/// A large column must not change the scale of another column's sensitivity.
#[test]
fn sensitivity_of_a_column_ignores_other_columns() {
    let sweep = |columns| {
        let all = [
            "sweep",
            "four-bar",
            "--to",
            "0",
            "--sensitivity",
            "--no-units",
            "--columns",
        ];
        run_ok(&[&all[..], &[columns]].concat())
    };
    let [both, alone] = ["a = 1e15 * C.x,C.x", "C.x"].map(sweep);
    assert_eq!(rows(&both)[0][3..5], rows(&alone)[0][1..3]);
}

#[test]
fn invalid_formulas_report_the_cause() {
    let sweep = |columns| refused(2, &["sweep", "four-bar", "--to", "0", "--columns", columns]);
    for (columns, phrase) in [
        ("x = C.x + C.vx", "`C.x` is in mm and `C.vx` is in mm/s"),
        ("x = r4.angle + 90", "write a unit after the number"),
        ("x = C.x-C.y", "put blanks around `-`"),
        ("x = r4.omgea * 2", "did you mean `r4.omega`?"),
        ("C = C.x", "is already in use"),
        ("x = C.ax,x.rate", "the rate of C.ax is not known"),
        ("= C.x", "a name and `=`"),
        (
            "pi = C.x",
            "the name `pi` is reserved; columns use `driver`,",
        ),
        ("time = C.x", "`time`, `pi` with a special meaning"),
    ] {
        let output = sweep(columns);
        assert!(
            output.contains(phrase) && output.contains("--columns"),
            "{columns}: {output}"
        );
    }
}

#[test]
fn scene_figures_are_columns_of_sweep_and_plot() {
    let scene = include_str!("../../presets/four-bar.toml");
    let figures = "\n[figures]\nfast = \"2 * swing.rate\"\nswing = \"r4.angle - r3.angle\"\n";
    let path = folder("figures").join("scene.toml");
    std::fs::write(&path, [scene, figures].concat()).unwrap();
    let path = path.to_str().unwrap();
    let csv = run_ok(&[
        "sweep",
        path,
        "--from",
        "60",
        "--to",
        "60",
        "--columns",
        "swing,fast,swing.accel",
        "--bounds",
    ]);
    assert_eq!(
        header(&csv),
        "driver.angle [deg],swing [deg],swing.bound [deg],fast [rad/s],fast.bound [rad/s],swing.accel [rad/s^2],\
         swing.accel.bound [rad/s^2],state"
    );
    let row = &rows(&csv)[0];
    assert!(row.iter().all(|cell| !cell.is_empty()), "{row:?}");
    let all = run_ok(&["sweep", path, "--to", "0"]);
    assert!(!header(&all).contains("swing"));
    let plot = run_ok(&[
        "plot",
        path,
        "--columns",
        "swing",
        "--against",
        "fast",
        "--size",
        "60x20",
    ]);
    assert!(
        plot.contains("swing") && plot.contains("over fast"),
        "{plot}"
    );
    let wrong = "[figures]\nswing = \"r4.angle - r5.angle\"\n";
    std::fs::write(path, [scene, wrong].concat()).unwrap();
    let output = refused(2, &["check", path]);
    assert!(
        output.contains("no quantity is named `r5.angle`") && output.contains("scene.toml"),
        "{output}"
    );
}

/// A slot of 250 to 380 mm limits a slider-crank of 100 and 300: cos(theta) = (r2^2 + s^2 - r3^2) / (2 r2 s).
#[test]
fn default_sweep_ends_at_stops_with_all_rates() {
    let file = folder("stops").join("slot.toml");
    std::fs::write(
        &file,
        "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r2\"\nangle = 60\n[links]\n\
         r2 = { from = \"A\", to = \"B\", length = 100 }\nr3 = { from = \"B\", to = \"C\", length = 300 }\n[slides]\n\
         rod = { point = \"C\", on = \"ground\", through = \"A\", angle = 0 }\n[start]\nC = [350, 0]\n[limits]\n\
         rod = [250, 380]\n",
    )
    .unwrap();
    let scene = file.to_str().unwrap();
    let sweep = run_ok(&["sweep", scene, "--step", "30", "--columns", "C.x,C.vx"]);
    let swept = rows(&sweep);
    let (first, last) = (&swept[0], &swept[swept.len() - 1]);
    assert_eq!([&first[0], &first[1]], ["32.07341239210894", "380"]);
    assert_eq!([&last[0], &last[1]], ["110.48731511472266", "250"]);
    assert!(swept.iter().all(|row| row[3] == "ok" && !row[2].is_empty()));
    let past = refused(1, &["table", scene, "--at", "120"]);
    assert!(
        past.contains("the stop of rod ends the motion before 120 deg"),
        "{past}"
    );
}
