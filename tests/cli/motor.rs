//! Tests of `krank motor`: values in three formats, rejected arguments, and scenes without loads.

use super::{json, krank, presets, refused, rows, run_ok};
use std::f64::consts::PI;

fn near(value: &serde_json::Value, exact: f64, maximum: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - exact).abs() <= maximum, "{value} for {exact}");
}

#[test]
fn text_fits_80_columns_and_has_all_sections() {
    let text = run_ok(&["motor", "four-bar-load"]);
    assert!(
        text.is_ascii() && text.lines().all(|line| line.len() <= 80),
        "{text}"
    );
    for phrase in [
        "over a turn at 15 rad/s (143.239 rpm), r2 needs ",
        "the\nworst instant",
        "torque [N m]               all       loads     gravity     inertia\n",
        "\nmotor: ",
        "\nevenness\n",
        "kg m^2",
        "\non the frame, loads included\n",
        "trapezoidal rule at ",
    ] {
        assert!(text.contains(phrase), "{phrase}\n{text}");
    }
}

#[test]
fn every_preset_is_evaluated_or_reports_missing_loads() {
    for preset in presets() {
        let output = krank(&["motor", &preset]);
        assert!(output.out.is_ascii(), "{}", output.out);
        assert!(
            output.out.lines().all(|line| line.len() <= 80),
            "{}",
            output.out
        );
        for bad in ["NaN", "inf", "nan"] {
            assert!(!output.out.contains(bad), "{preset}: {}", output.out);
        }
        match output.code {
            0 => assert!(
                output.out.contains("energy [J]")
                    || output.err.contains("no loads, springs or masses"),
                "{preset}"
            ),
            1 => assert!(
                output.err.contains("no loads, springs or masses"),
                "{preset}: {}",
                output.err
            ),
            code => panic!("{preset}: {code}"),
        }
    }
}

#[test]
fn json_energies_balance() {
    for preset in ["four-bar-load", "engine", "press-ram", "toggle-press"] {
        let found = json(&run_ok(&["motor", preset, "--format", "json"]));
        let torque = &found["torque"];
        let of = |part: &serde_json::Value, key: &str| part[key].as_f64().unwrap();
        let size = of(torque, "put_in") + of(torque, "given_back");
        let turns = found["cycle"]["turns"].as_f64().unwrap();
        near(
            &torque["work"],
            of(torque, "mean") * 2.0 * PI * turns,
            1e-10 * size,
        );
        let parts = ["load", "gravity", "inertia"].map(|part| of(&torque[part], "work"));
        near(&torque["work"], parts.iter().sum(), 1e-10 * size);
        assert_eq!(found["cycle"]["converged"], true, "{preset}");
        assert!(
            found["cycle"]["error"].as_f64().unwrap() < 1e-10,
            "{preset}"
        );
        let requested = &found["evenness"]["wished"];
        let speed = found["driver"]["speed"].as_f64().unwrap();
        let energy = of(requested, "inertia") * speed * speed * of(requested, "fluctuation");
        near(&found["evenness"]["energy"], energy, 1e-9 * size);
    }
}

/// The work of a press is the area under its force curve, and its motor must supply it.
#[test]
fn press_work_equals_area_under_its_curve() {
    let found = json(&run_ok(&["motor", "press-ram", "--format", "json"]));
    let knots = [
        [40.0, 0.0],
        [38.0, 18e3],
        [5.0, 26e3],
        [1.0, 28e3],
        [0.0, 60e3],
    ];
    let area = knots
        .windows(2)
        .map(|k| (k[0][0] - k[1][0]) * (k[0][1] + k[1][1]) / 2.0);
    let area: f64 = area.sum::<f64>() / 1000.0;
    near(&found["torque"]["load"]["work"], area, 1e-8 * area);
    near(&found["torque"]["work"], area, 1e-8 * area);
}

#[test]
fn csv_lists_the_cycle_step_by_step() {
    let csv = run_ok(&["motor", "engine", "--format", "csv"]);
    let header = csv.lines().next().unwrap();
    assert_eq!(
        header,
        "driver.angle [deg],driver.torque [N m],driver.torque.load [N m],\
         driver.torque.gravity [N m],driver.torque.inertia [N m],driver.power [W],driver.work [J],\
         ground.fx [N],ground.fy [N],ground.moment [N m],state"
    );
    let rows = rows(&csv);
    assert_eq!(rows.len(), 721);
    let number = |row: &[String], i: usize| row[i].parse::<f64>().unwrap();
    for row in &rows {
        let parts: f64 = (2..5).map(|i| number(row, i)).sum();
        assert!((number(row, 1) - parts).abs() < 1e-9, "{row:?}");
    }
    let found = json(&run_ok(&["motor", "engine", "--format", "json"]));
    near(&found["torque"]["work"], number(&rows[720], 6), 1e-9);
}

#[test]
fn options_override_values_of_the_scene() {
    let with = |more: &[&str]| {
        json(&run_ok(
            &[&["motor", "four-bar-load", "--format", "json"], more].concat(),
        ))
    };
    let weak = with(&["--rated", "1", "--peak", "2", "--speed", "300 rpm"]);
    assert_eq!(weak["motor"]["enough"], false);
    assert_eq!(weak["motor"]["rated"]["has"], 1.0);
    near(&weak["motor"]["gear"]["ratio"], 10.0 * PI / 15.0, 1e-12);
    let strong = with(&["--rated", "1000", "--peak", "3000", "--fluctuation", "0.5"]);
    assert_eq!(strong["motor"]["enough"], true);
    near(&strong["evenness"]["wished"]["fluctuation"], 0.5, 0.0);
    // The load is lifted and lowered: with a flywheel, the mean torque of the motor is zero.
    let even = with(&["--rated", "20", "--peak", "60", "--flywheel", "5"]);
    assert_eq!(even["motor"]["with_flywheel"]["asked"], 0.0);
    let uneven = with(&["--rated", "20", "--peak", "60", "--flywheel", "0.1"]);
    assert!(uneven["motor"]["with_flywheel"].is_null());
    // Over a part of the motion, there and back, gravity returns all the work it takes.
    let part = with(&["--from", "30", "--to", "90"]);
    assert_eq!(
        (&part["cycle"]["from"], &part["cycle"]["goes_round"]),
        (&30.0.into(), &false.into())
    );
    near(&part["torque"]["gravity"]["work"], 0.0, 1e-12);
    // A range of a rotating driver continues past the full turn.
    let part = with(&["--from", "300", "--to", "60"]);
    near(&part["cycle"]["from"], 300.0, 0.0);
    near(&part["cycle"]["to"], 420.0, 0.0);
}

/// The headline must agree with the details below it. A flywheel within the allowed fluctuation reduces the demand to
/// the mean torque, for the peak too. A flywheel with an impossible fluctuation does not.
#[test]
fn flywheel_headline_agrees_with_the_details() {
    let with = |more: &[&str]| {
        let output = run_ok(&[&["motor", "toggle-press"], more].concat());
        let args = [&["motor", "toggle-press", "--format", "json"], more].concat();
        (output, json(&run_ok(&args)))
    };
    let (output, found) = with(&["--rated", "150", "--peak", "300", "--flywheel", "5000"]);
    assert!(
        output.contains("motor: enough, with the flywheel"),
        "{output}"
    );
    assert_eq!(found["motor"]["enough"], true);
    assert_eq!(found["motor"]["even_enough"], true);
    // A motor below the mean torque is not enough with any flywheel.
    let (output, found) = with(&["--rated", "10", "--peak", "300", "--flywheel", "5000"]);
    assert!(output.contains("motor: not enough"), "{output}");
    assert_eq!(found["motor"]["enough"], false);
    // If the requested fluctuation is exceeded, the motor itself must supply the peak.
    let uneven = ["--rated", "150", "--peak", "300", "--flywheel", "5000"];
    let (output, found) = with(&[&uneven[..], &["--fluctuation", "0.01"]].concat());
    assert!(output.contains("motor: not enough"), "{output}");
    assert_eq!(found["motor"]["enough"], false);
    assert_eq!(found["motor"]["even_enough"], false);
    let (output, found) = with(&["--rated", "450", "--flywheel", "1"]);
    assert!(
        output.contains("motor: enough, but the flywheel is too small"),
        "{output}"
    );
    assert!(output.contains("impossible"), "{output}");
    assert_eq!(found["motor"]["even_enough"], false);
}

#[test]
fn ram_is_measured_without_loads() {
    let args = [
        "motor",
        "offset-slider-crank",
        "--height",
        "10",
        "--torque",
        "20",
        "--tolerance",
        "0.5",
    ];
    let output = krank(&args);
    assert_eq!(output.code, 0, "a ram is something to tell");
    assert!(
        output
            .err
            .contains("the scene has no loads, springs or masses"),
        "{}",
        output.err
    );
    for phrase in [
        "stroke           89.53",
        "time ratio       1.25",
        "closing     opening",
        "dwells",
    ] {
        assert!(output.out.contains(phrase), "{phrase}\n{}", output.out);
    }
    let json = json(&krank(&[&args[..], &["--format", "json"]].concat()).out);
    assert!(json["torque"].is_null() && json["cycle"].is_null());
    let stroke = (160.0_f64.powi(2) - 2500.0).sqrt() - (80.0_f64.powi(2) - 2500.0).sqrt();
    near(&json["ram"]["stroke"], stroke, 1e-11);
    // At the bottom itself, the force has no bound, so the cells are empty.
    let bottom = krank(&[
        "motor",
        "offset-slider-crank",
        "--height",
        "0",
        "--torque",
        "20",
    ]);
    let row = |label: &str| {
        let line = bottom
            .out
            .lines()
            .find(|line| line.trim().starts_with(label));
        let words: Vec<String> = line
            .unwrap()
            .split_whitespace()
            .map(str::to_owned)
            .collect();
        words[words.len() - 2..].to_vec()
    };
    assert_eq!(row("v ["), ["0", "0"]);
    assert_eq!(row("force [N]"), ["-", "-"]);
    assert!(
        bottom.out.contains("the force has no bound"),
        "{}",
        bottom.out
    );
    let high = krank(&["motor", "offset-slider-crank", "--height", "100"]);
    assert!(
        high.out.contains("the ram never reaches it"),
        "{}",
        high.out
    );
}

#[test]
fn dead_points_are_named_and_have_empty_cells() {
    let boom = run_ok(&["motor", "excavator-boom"]);
    assert!(boom.contains("dead points at "), "{boom}");
    assert!(
        boom.contains("motor: not compared: the maximum force does not exist"),
        "{boom}"
    );
    // Values exist in every state except at the dead points.
    let csv = rows(&run_ok(&["motor", "excavator-boom", "--format", "csv"]));
    for (k, row) in csv.iter().enumerate() {
        let is_dead = k % 180 == 0;
        assert_eq!(row[10], if is_dead { "dead-point" } else { "ok" });
        for cell in [1, 2, 3, 4, 5, 7, 8, 9] {
            assert_eq!(row[cell].is_empty(), is_dead, "{row:?}");
        }
        assert_ne!(row[4], "0", "{row:?}");
    }
    let found = json(&run_ok(&["motor", "excavator-boom", "--format", "json"]));
    assert!(found["motor"]["enough"].is_null());
    let part = run_ok(&["motor", "excavator-boom", "--from", "1.8", "--to", "2.8"]);
    assert!(
        !part.contains("dead points") && part.contains("from 1.8 to 2.8 m and back"),
        "{part}"
    );
}

#[test]
fn invalid_motor_arguments_are_rejected() {
    for (code, args, phrase) in [
        (
            2,
            &["motor", "four-bar-load", "--rated", "-3"][..],
            "not negative",
        ),
        (2, &["motor", "four-bar-load", "--peak", "nan"], "finite"),
        (
            2,
            &["motor", "four-bar-load", "--fluctuation", "0"],
            "greater than 0",
        ),
        (
            2,
            &["motor", "four-bar-load", "--speed", "15"],
            "rad/s, deg/s, rpm",
        ),
        (
            2,
            &["motor", "four-bar-load", "--speed", "-15 rpm"],
            "greater than 0",
        ),
        (2, &["motor", "four-bar-load", "--from", "10"], "--to"),
        (
            2,
            &["motor", "four-bar-load", "--from", "10", "--to", "10"],
            "differ",
        ),
        (
            2,
            &["motor", "press-ram", "--ram", "r7"],
            "did you mean `r6`?",
        ),
        (2, &["motor", "slotted-lever", "--ram", "r4"], "--ram"),
        (
            1,
            &["motor", "excavator-boom", "--from", "1", "--to", "2"],
            "the driver covers",
        ),
        (
            2,
            &["motor", "four-bar-load", "--fluctuation", "3"],
            "impossible",
        ),
        (
            2,
            &["motor", "four-bar-load", "--fluctuation", "1.5"],
            "above 1",
        ),
        (
            2,
            &["motor", "four-bar-load", "--peak", "10", "--rated", "20"],
            "less than the rated",
        ),
        (1, &["motor", "four-bar"], "no loads, springs or masses"),
        (
            1,
            &["motor", "four-bar", "--format", "csv"],
            "no loads, springs or masses",
        ),
    ] {
        let message = refused(code, args);
        assert!(message.contains(phrase), "{args:?}: {message}");
    }
}
