//! Tests of `krank accuracy`. A scene whose driver has limits skips the long integrations. No test
//! here depends on running times: `tests/library/accuracy.rs` tests timing with a simulated clock.

use super::{folder, json, refused, rows, run_ok};

const LIMITED: [&str; 4] = ["accuracy", "double-rocker", "--positions", "360"];

fn with(more: &[&str]) -> String {
    run_ok(&[&LIMITED[..], more].concat())
}

#[test]
fn text_contains_table_and_chart() {
    let text = with(&[]);
    assert!(text.is_ascii(), "{text}");
    assert!(text.lines().all(|line| line.len() <= 80), "{text}");
    let mut parts = text.split("\n\n");
    assert!(
        parts
            .next()
            .unwrap()
            .starts_with("Chebyshev's double rocker\n360 positions"),
        "{text}"
    );
    let table = parts.next().unwrap();
    assert_eq!(table.lines().count(), 1 + 22, "{table}");
    assert!(table.contains("\na* closed form"), "{table}");
    assert!(
        table.contains("- not needed: every group has a closed form\n"),
        "{table}"
    );
    assert!(
        table.contains(" - the driver has limits and cannot turn fully"),
        "{table}"
    );
    let chart = parts.next().unwrap();
    for letter in ["a", "error", "time", "1e-14+"] {
        assert!(chart.contains(letter), "{chart}");
    }
    let units = [" ns", " us", " ms", " s"];
    assert!(units.iter().any(|unit| chart.contains(unit)), "{chart}");
}

#[test]
fn csv_has_a_row_for_every_method() {
    let csv = with(&["--format", "csv"]);
    let header = csv.lines().next().unwrap();
    assert_eq!(
        header,
        "key,method,time [ns],time.low [ns],time.high [ns],position,velocity,acceleration,\
         tried,failures,best,reason,iterations.median,iterations.most"
    );
    let rows = rows(&csv);
    assert_eq!(rows.len(), 22);
    for row in &rows {
        let is_measured = row[11].is_empty();
        for (i, cell) in row[2..10].iter().enumerate() {
            assert_eq!(cell.is_empty(), !is_measured, "{row:?}");
            let number = cell.parse::<f64>();
            assert!(
                !is_measured || number.is_ok_and(|n| n >= 0.0),
                "{i}: {row:?}"
            );
        }
        assert!(!is_measured || row[3].len() > 1, "{row:?}");
        assert!(["true", "false"].contains(&row[10].as_str()), "{row:?}");
    }
    // Bisection halves half a turn down to adjacent doubles: about as many steps as a double has bits.
    let counts = rows[15][12..]
        .iter()
        .map(|cell| cell.parse::<u32>().unwrap());
    let counts: Vec<u32> = counts.collect();
    assert!(
        40 <= counts[0] && counts[0] <= counts[1] && counts[1] <= 60,
        "{counts:?}"
    );
    assert_eq!(rows[0][12..], ["", ""]);
    assert_eq!(rows[0][..2], ["a", "closed form"]);
    assert_eq!(rows[21][..2], ["v", "RK4 3600 x 1000"]);
}

#[test]
fn json_has_times_and_errors_of_every_method() {
    let json = json(&with(&["--format", "json"]));
    assert_eq!(json["scene"], "Chebyshev's double rocker");
    assert_eq!(
        (&json["unit"], &json["finished"]),
        (&"mm".into(), &true.into())
    );
    assert_eq!(json["positions"], 360);
    let methods = json["methods"].as_array().unwrap();
    assert_eq!(methods.len(), 22);
    let closed = &methods[0];
    assert_eq!(closed["key"], "a");
    // On a busy machine, another method may be the fastest.
    assert!(closed["best"].is_boolean());
    let time = |part: &str| closed[part].as_f64().unwrap();
    assert!(time("time.low [ns]") <= time("time [ns]"));
    assert!(time("time [ns]") <= time("time.high [ns]"));
    assert!(closed["position"].as_f64().unwrap() < 1e-13);
    assert_eq!(closed["reason"], serde_json::Value::Null);
    let unfit = &methods[21];
    assert!(unfit["position"].is_null() && unfit["reason"].is_string());
}

#[test]
fn results_are_written_to_a_file() {
    let file = folder("accuracy").join("methods.csv");
    assert_eq!(with(&["--format", "csv", "-o", file.to_str().unwrap()]), "");
    let written = std::fs::read_to_string(file).unwrap();
    assert!(written.starts_with("key,method,"), "{written}");
}

#[test]
fn unknown_scene_is_rejected() {
    assert!(refused(2, &["accuracy", "forbar"]).contains("did you mean the preset `four-bar`?"));
}
