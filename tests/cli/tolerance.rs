//! Tests of `krank tolerance` and of bands in plots, against closed forms.

use super::{folder, json, krank, refused, rows, run_ok};
use std::fs;

const SLIDER_CRANK: &str = r#"
name = "In line"
unit = "mm"
[ground]
A = [0, 0]
[driver]
link = "crank"
angle = 40
speed = "1 rad/s"
[links]
crank = { from = "A", to = "B", length = 50, tolerance = 0.1 }
rod = { from = "B", to = "C", length = 150, tolerance = 0.1 }
[slides]
ram = { point = "C", on = "ground", through = "A", angle = 0 }
[start]
C = [190, 0]
"#;

/// Writes a scene to a file and returns its path.
fn scene(name: &str, text: &str) -> String {
    let path = folder("tolerance").join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

fn near(found: &serde_json::Value, expected: f64, within: f64) {
    let found = found.as_f64().unwrap();
    assert!((found - expected).abs() <= within, "{found} {expected}");
}

/// Crank and rod in line with 0.1 each: 0.2 in the worst case, 0.1414 by the root sum square, and
/// normally distributed samples with a variance of 2 (0.1 / 3)^2.
#[test]
fn dead_centre_adds_both_tolerances() {
    let scene = scene("in-line.toml", SLIDER_CRANK);
    let request = ["tolerance", &scene, "--columns", "ram.length", "--at", "0"];
    let found = json(&run_ok(&[&request[..], &["--format", "json"]].concat()));
    let ram = &found["figures"]["ram.length"];
    near(&ram["nominal"], 200.0, 0.0);
    near(&ram["worst"]["low"], 199.8, 1e-12);
    near(&ram["worst"]["high"], 200.2, 1e-12);
    assert_eq!(ram["worst"]["by"], "corners");
    near(&ram["rss"], 0.02_f64.sqrt(), 1e-12);
    let deviation = 0.1 / 3.0 * 2.0_f64.sqrt();
    near(&ram["samples"]["deviation"], deviation, 0.01 * deviation);
    near(
        &ram["samples"]["p99.865"],
        200.0 + 3.0 * deviation,
        0.1 * deviation,
    );
    near(&ram["contributions"][0]["share"], 0.5, 1e-12);
    assert_eq!(found["samples"]["open"], 0.0);
    let text = run_ok(&request);
    assert!(
        text.contains("199.800 to 200.200 (-0.2000, +0.2000)"),
        "{text}"
    );
    assert!(text.contains("+-0.1414"), "{text}");
    assert_eq!(
        text,
        run_ok(&request),
        "the same seed gives the same machines"
    );
    assert_ne!(text, run_ok(&[&request[..], &["--seed", "2"]].concat()));
    // The option applies to the ground too: A.x adds one more 0.1.
    let plain = SLIDER_CRANK.replace(", tolerance = 0.1", "");
    let plain = self::scene("bare.toml", &plain);
    let request = ["tolerance", &plain, "--columns", "C.x", "--at", "0"];
    let more = ["--tolerance", "0.1", "--format", "json"];
    let found = json(&run_ok(&[&request[..], &more].concat()));
    near(&found["figures"]["C.x"]["rss"], 0.03_f64.sqrt(), 1e-12);
}

/// Closed form x = r cos t + sqrt(l^2 - r^2 sin^2 t) at the four corners, every 5 deg.
#[test]
fn rows_match_the_closed_form() {
    let scene = scene("rows.toml", SLIDER_CRANK);
    let text = run_ok(&["tolerance", &scene, "--columns", "C.x", "--format", "csv"]);
    let header = "driver.angle [deg],C.x.nominal [mm],C.x.worst.low [mm],C.x.worst.high [mm],\
                  C.x.reached.low [mm],C.x.reached.high [mm],C.x.worst.by,C.x.closes,C.x.rss [mm],state\n";
    assert!(text.starts_with(header), "{text}");
    let rows = rows(&text);
    assert_eq!(rows.len(), 73);
    for row in rows {
        let number = |cell: usize| row[cell].parse::<f64>().unwrap();
        let (sin, cos) = number(0).to_radians().sin_cos();
        let x = |r: f64, l: f64| r * cos + (l * l - r * r * sin * sin).sqrt();
        let corners = [-0.1, 0.1].map(|r| [-0.1, 0.1].map(|l| x(50.0 + r, 150.0 + l)));
        let all = corners.as_flattened();
        let [low, high] = [f64::min, f64::max].map(|f| all.iter().copied().reduce(f).unwrap());
        for (cell, expected) in [
            (1, x(50.0, 150.0)),
            (2, low),
            (3, high),
            (4, low),
            (5, high),
        ] {
            assert!((number(cell) - expected).abs() < 1e-12, "{row:?}");
        }
        assert_eq!([&row[6], &row[7], &row[9]], ["corners", "yes", "ok"]);
    }
}

/// A rod hardly longer than the crank closes only for some designs: 50 and 50.05 close at 90 deg,
/// 50.1 and 49.95 do not.
#[test]
fn designs_that_cannot_close_are_counted() {
    let text = SLIDER_CRANK.replace("length = 150", "length = 50.05");
    let scene = scene("open.toml", &text.replace("[190, 0]", "[76, 0]"));
    let request = ["tolerance", &scene, "--columns", "C.x", "--at", "90"];
    let found = json(&run_ok(
        &[
            &request[..],
            &["--format", "json", "--distribution", "even"],
        ]
        .concat(),
    ));
    assert_eq!(found["figures"]["C.x"]["worst"]["closes"], "not-always");
    // For two uniform deviations within 0.1, the crank's exceeds the rod's by more than 0.05 with a
    // probability of (1 - 0.05 / 0.2)^2 / 2.
    near(&found["samples"]["open"], 0.75 * 0.75 / 2.0, 6e-3);
    let output = krank(&["tolerance", &scene, "--columns", "C.x"]);
    assert_eq!(output.code, 0);
    assert!(
        output
            .err
            .contains("not every machine within its tolerances closes"),
        "{}",
        output.err
    );
}

#[test]
fn invalid_tolerance_arguments_are_rejected() {
    let output = refused(1, &["tolerance", "four-bar"]);
    assert!(
        output.contains("every length of the scene is exact"),
        "{output}"
    );
    assert!(output.contains("--tolerance 0.1"), "{output}");
    let forces = [
        "tolerance",
        "four-bar-load",
        "--tolerance",
        "0.1",
        "--columns",
        "driver.torque",
    ];
    assert!(refused(1, &forces).contains("not to forces"));
    let request = ["tolerance", "four-bar", "--tolerance", "0.1"];
    refused(2, &[&request[..], &["--at", "60", "--step", "5"]].concat());
    refused(2, &[&request[..], &["--columns", "X.x"]].concat());
    refused(2, &["tolerance", "four-bar", "--tolerance", "0"]);
    let limited = [
        "tolerance",
        "excavator-boom",
        "--tolerance",
        "0.001",
        "--at",
        "1000",
    ];
    refused(1, &limited);
}

/// Columns that no tolerance changes are not default columns.
#[test]
fn default_columns_are_those_with_deviations() {
    let scene = scene("usual.toml", SLIDER_CRANK);
    let text = run_ok(&["tolerance", &scene, "--format", "csv", "--step", "90"]);
    let header = text.lines().next().unwrap();
    for name in ["rod.angle", "ram.length", "C.x"] {
        assert!(header.contains(&format!("{name}.nominal")), "{header}");
    }
    for name in ["crank.angle", "A.x", "C.y"] {
        assert!(!header.contains(&format!("{name}.nominal")), "{header}");
    }
}

#[test]
fn plots_can_draw_tolerance_bands() {
    let scene = scene("band.toml", &SLIDER_CRANK.replace("= 0.1", "= 10"));
    let request = ["plot", &scene, "--columns", "C.x"];
    assert!(!run_ok(&request).contains("worst"));
    let text = run_ok(&[&request[..], &["--band", "worst"]].concat());
    assert!(text.contains("C.x worst"), "{text}");
    let svg = run_ok(&[&request[..], &["--band", "rss", "--format", "svg"]].concat());
    // Both edges and the line in the legend.
    assert_eq!(svg.matches("class=\"dotted\"").count(), 3, "{svg}");
    refused(
        1,
        &["plot", "four-bar", "--columns", "C.x", "--band", "worst"],
    );
}

/// The old name of `rest` gives the same dwell of the ram.
#[test]
fn rest_option_and_key_accept_old_name_tolerance() {
    let text = |option| run_ok(&["motor", "press-ram", option, "0.7"]);
    assert_eq!(text("--rest"), text("--tolerance"));
    let preset = fs::read_to_string("presets/press-ram.toml").unwrap();
    assert!(preset.contains("rest        = 0.5"));
    let old = scene(
        "old.toml",
        &preset.replace("rest        = 0.5", "tolerance = 0.5"),
    );
    assert_eq!(run_ok(&["motor", &old]), run_ok(&["motor", "press-ram"]));
}
