//! Tests of `krank cycle`: strokes, ratios and reasons in three formats, and rejected arguments.

use super::{json, krank, presets, refused, run_ok};

/// Every preset gives a page within 80 columns, without NaN or infinity.
#[test]
fn every_preset_prints_a_page_within_80_columns() {
    for preset in presets() {
        let output = krank(&["cycle", &preset]);
        let text = output.out;
        assert_eq!(output.code, 0, "{preset}: {}", output.err);
        assert!(
            text.is_ascii() && text.lines().all(|line| line.len() <= 80),
            "{text}"
        );
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    }
}

/// Closed form for an offset slider-crank with crank 40, rod 120 and offset 50: the stroke is sqrt(160^2 - 50^2) -
/// sqrt(80^2 - 50^2). At the dead centres, the angles between crank and guide are asin(50 / 160) and asin(50 / 80).
#[test]
fn text_csv_and_json_contain_the_same_values() {
    let stroke = (160.0_f64.powi(2) - 2500.0).sqrt() - (80.0_f64.powi(2) - 2500.0).sqrt();
    let distance = ((50.0_f64 / 80.0).asin() - (50.0_f64 / 160.0).asin()).to_degrees();
    let ratio = (180.0 + distance) / (180.0 - distance);
    let lines = ["cycle", "offset-slider-crank", "--columns", "C.x"];
    let with = |format| [&lines[..], &["--format", format]].concat();
    let found = json(&run_ok(&with("json")));
    let figure = &found["figures"][0];
    assert!((figure["stroke"].as_f64().unwrap() - stroke).abs() < 1e-10);
    assert!((figure["ratio"].as_f64().unwrap() - ratio).abs() < 1e-10);
    assert_eq!(figure["turns"].as_array().unwrap().len(), 2);
    let csv = run_ok(&with("csv"));
    assert!(
        csv.starts_with("figure,property,value,unit,at,reason\n"),
        "{csv}"
    );
    let line = csv
        .lines()
        .find(|line| line.starts_with("C.x,stroke,"))
        .unwrap();
    let value: f64 = line.split(',').nth(2).unwrap().parse().unwrap();
    assert!((value - stroke).abs() < 1e-10, "{line}");
    let text = run_ok(&lines);
    assert!(text.contains(&format!("{stroke:.7} mm")), "{text}");
    assert!(text.contains(&format!("{ratio:.5}")[..6]), "{text}");
}

#[test]
fn missing_values_have_a_reason() {
    let text = run_ok(&["cycle", "four-bar", "--columns", "r2.angle,r4.angle"]);
    assert!(text.contains("turns once per period"), "{text}");
    let csv = run_ok(&["cycle", "excavator-boom", "--format", "csv"]);
    assert!(
        csv.contains("the driver moves back and forth on the same path"),
        "{csv}"
    );
    refused(2, &["cycle", "four-bar", "--columns", "C.z"]);
    refused(2, &["cycle", "four-bar", "--dwell", "0"]);
}

/// The flywheel leaves little fluctuation. The mean torque is below the motor's rating, which is
/// below the root mean square. The headline must agree with the details below it.
#[test]
fn motor_verdict_depends_on_rating_and_flywheel() {
    let requested = |options: &[&str]| run_ok(&[&["motor", "toggle-press"], options].concat());
    // 738 J at pi rad/s: 738 / (9.87 * 600) = 0.125. The mean is 141.6 N m, the root of the mean square 400.3.
    let text = requested(&["--rated", "200", "--flywheel", "600"]);
    assert!(
        text.contains("\nmotor: enough, with the flywheel\n"),
        "{text}"
    );
    // The fluctuation exceeds the requested limit.
    let text = requested(&[
        "--rated",
        "200",
        "--flywheel",
        "600",
        "--fluctuation",
        "0.1",
    ]);
    assert!(
        text.contains("\nmotor: enough, but the flywheel is too small\n"),
        "{text}"
    );
    let text = requested(&["--rated", "100", "--flywheel", "600"]);
    assert!(text.contains("\nmotor: not enough\n"), "{text}");
    // 738 / (9.87 * 30) = 2.49.
    let text = requested(&["--flywheel", "30"]);
    assert!(text.contains("impossible"), "{text}");
    let message = refused(2, &["motor", "toggle-press", "--fluctuation", "2.5"]);
    assert!(message.contains("impossible"), "{message}");
}

/// Regression test: values at a dead point were printed with nine digits, although rounding of the
/// driver coordinate leaves only six or seven. Both ends of a symmetrical cell differed.
#[test]
fn dead_point_values_show_only_reliable_digits() {
    let text = run_ok(&["cycle", "peaucellier"]);
    // Undoes the wrapping of long lines.
    let flat = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut turns: Vec<&str> = flat.split(", where the driver reverses").collect();
    turns.pop();
    assert_eq!(turns.len(), 4, "{text}");
    // By the cell's closed form, the limit is acos(1/8), and the arms are at half of it.
    for turn in turns {
        let value: f64 = turn
            .split_whitespace()
            .nth_back(4)
            .unwrap()
            .parse()
            .unwrap();
        let digits = turn
            .split_whitespace()
            .nth_back(4)
            .unwrap()
            .trim_start_matches('-')
            .len()
            - 1;
        assert!((6..=7).contains(&digits), "{turn}");
        let half = 0.125_f64.acos().to_degrees() / 2.0;
        assert!((value.abs() - half).abs() < 1.1e-5, "{turn}");
    }
    assert!(
        text.contains("s there and back: -82.819 to -82.780"),
        "{text}"
    );
    assert!(text.contains("0.46840 s: 63.709 to 77.761"), "{text}");
}

/// Regression test: rounding error was printed as an acceleration of 2e-11 rad/s^2.
#[test]
fn evenly_turning_link_has_zero_acceleration() {
    let text = run_ok(&["cycle", "parallelogram"]);
    assert!(text.contains("fastest      1.00000 rad/s"), "{text}");
    assert!(text.contains("hardest      0 rad/s^2"), "{text}");
}

/// The steering rack is at 0 in the middle, except for rounding errors.
#[test]
fn rounding_errors_print_as_zero() {
    let text = run_ok(&["cycle", "ackermann"]);
    assert!(!text.contains("e-1"), "{text}");
    let bounds = run_ok(&["cycle", "ackermann", "--bounds"]);
    assert!(bounds.contains(" +- "), "{bounds}");
}

/// Every extremum has a bound, and the stroke's bound is at least their sum.
#[test]
fn each_extremum_and_stroke_has_its_bounds() {
    let lines = ["cycle", "four-bar", "--columns", "C.x", "--bounds"];
    let found = json(&run_ok(&[&lines[..], &["--format", "json"]].concat()));
    let figure = &found["figures"][0];
    let bound = |of: &serde_json::Value| of["bound"].as_f64().unwrap();
    let turns = figure["turns"].as_array().unwrap();
    assert!(
        turns
            .iter()
            .all(|turn| bound(turn) > 0.0 && bound(turn) < 1e-9)
    );
    let sum: f64 = turns.iter().map(bound).sum();
    assert!(figure["stroke.bound"].as_f64().unwrap() >= sum, "{figure}");
    let csv = run_ok(&[&lines[..], &["--format", "csv"]].concat());
    assert!(
        csv.starts_with("figure,property,value,unit,at,reason,bound\n"),
        "{csv}"
    );
    let text = run_ok(&lines);
    assert_eq!(text.matches(" +- ").count(), 3, "{text}");
}

/// Tables always contain the driver coordinate; here it must be named like other columns.
#[test]
fn driver_column_is_evaluated_when_named() {
    let text = run_ok(&["cycle", "four-bar", "--columns", "driver.angle"]);
    assert!(text.contains("driver.angle [deg]"), "{text}");
    assert!(text.contains("turns once per period"), "{text}");
    assert!(text.contains("15.0000 rad/s"), "{text}");
}

/// A quotient with a divisor that passes zero has a reason. A dwelling value shows where the dwell starts and ends.
#[test]
fn poles_and_dwells_are_reported() {
    let text = run_ok(&["cycle", "four-bar", "--columns", "MA = r2.omega / r4.omega"]);
    assert!(text.contains("none: it is unbounded near 36.4"), "{text}");
    let text = run_ok(&["cycle", "four-bar", "--columns", "f = max(B.y, 50 mm)"]);
    assert!(
        text.contains("minimum 50 mm from 150 deg to 30 deg"),
        "{text}"
    );
    assert!(text.contains("none: it dwells at an extreme"), "{text}");
}

#[test]
fn state_alone_has_no_cycle() {
    let why = refused(2, &["cycle", "four-bar", "--columns", "state"]);
    assert!(why.contains("`state` is a word"), "{why}");
    let text = run_ok(&["cycle", "four-bar", "--columns", "state,C.x"]);
    assert!(text.contains("C.x [mm]"), "{text}");
}
