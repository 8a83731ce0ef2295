//! Tests of `study`: rows against closed forms, identical bytes for any number of threads and
//! parts, resumed files, and charts.

use super::{Run, folder, json, krank, refused, rows, run_ok};
use std::fs;

const CRANK: &str = "offset-slider-crank";
const COLUMNS: &str = "r4.length.stroke,r4.length.ratio";

fn study<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&["study", CRANK, "--columns", COLUMNS], more].concat()
}

/// Returns stroke and time ratio. At the dead centres, crank and rod are in line: the sines of the
/// crank's angles are e / (l + r) and, beyond the pivot, e / (l - r).
fn closed(r: f64, l: f64, e: f64) -> [f64; 2] {
    let far = ((l + r).powi(2) - e * e).sqrt();
    let near = ((l - r).powi(2) - e * e).sqrt();
    let between = ((e / (l - r)).asin() - (e / (l + r)).asin())
        .abs()
        .to_degrees();
    [far - near, (180.0 + between) / (180.0 - between)]
}

fn number(cell: &str) -> f64 {
    cell.parse().unwrap()
}

#[test]
fn rows_match_the_closed_forms() {
    let csv = run_ok(&study(&[
        "--vary",
        "r2.length=30..50/3,r3.length=110..150/5,r4.through.y=-20..-10/2",
    ]));
    let head = "r2.length [mm],r3.length [mm],r4.through.y [mm],r4.length.stroke [mm],r4.length.ratio,state,reason";
    assert_eq!(csv.lines().next(), Some(head));
    let rows = rows(&csv);
    assert_eq!(rows.len(), 30);
    let mut k = 0;
    for r in [30.0, 40.0, 50.0] {
        for l in [110.0, 120.0, 130.0, 140.0, 150.0] {
            for e in [-20.0, -10.0] {
                let row = &rows[k];
                assert_eq!(
                    [number(&row[0]), number(&row[1]), number(&row[2])],
                    [r, l, e]
                );
                let [stroke, ratio] = closed(r, l, e);
                assert!(
                    (number(&row[3]) - stroke).abs() < 1e-9 * stroke,
                    "{row:?}: {stroke}"
                );
                assert!(
                    (number(&row[4]) - ratio).abs() < 1e-9 * ratio,
                    "{row:?}: {ratio}"
                );
                assert_eq!(row[5..], ["ok", ""]);
                k += 1;
            }
        }
    }
}

/// Rows are identical for any number of threads, and for parts put together.
#[test]
fn rows_do_not_depend_on_threads_or_parts() {
    let vary = ["--vary", "r2.length=30..50/14,r3.length=85..150/5"];
    let alone = krank(&study(&[&vary[..], &["--threads", "1"]].concat()));
    assert_eq!(alone.code, 0, "{}", alone.err);
    assert_eq!(alone.out.lines().count(), 71);
    for threads in ["2", "3"] {
        let run = krank(&study(&[&vary[..], &["--threads", threads]].concat()));
        assert_eq!(run.out, alone.out, "{threads}");
    }
    let head = alone.out.lines().next().unwrap().to_owned() + "\n";
    let mut text = head.clone();
    for part in ["1/4", "2/4", "3/4", "4/4"] {
        let run = krank(&study(&[&vary[..], &["--part", part]].concat()));
        text += run.out.strip_prefix(&head).unwrap();
    }
    assert_eq!(text, alone.out);
}

/// A file truncated anywhere is completed; a file of another study is not changed.
#[test]
fn resume_completes_truncated_files_and_rejects_others() {
    let path = folder("study").join("designs.csv");
    let file = path.to_str().unwrap();
    let args = study(&[
        "--vary",
        "r2.length=30..50/4,r3.length=85..150/10",
        "-o",
        file,
    ]);
    let resume = [&args[..], &["--resume"]].concat();
    let started = krank(&args);
    assert_eq!((started.code, started.out.as_str()), (0, ""));
    let text = fs::read_to_string(&path).unwrap();
    for cut in [0, 7, 200, text.len() / 2, text.len() - 1, text.len()] {
        fs::write(&path, &text[..cut]).unwrap();
        let run = krank(&resume);
        assert_eq!(run.code, 0, "{cut}: {}", run.err);
        assert_eq!(fs::read_to_string(&path).unwrap(), text, "{cut}");
    }
    let done = krank(&resume);
    assert!(
        done.err.contains("already has 40 of 40 designs"),
        "{}",
        done.err
    );

    let other = study(&[
        "--vary",
        "r2.length=30..51/4,r3.length=85..150/10",
        "-o",
        file,
        "--resume",
    ]);
    // The last row has another crank length.
    assert!(refused(2, &other).contains("belongs to another study: line 41 "));
    let other = study(&["--vary", "r2.length=30..50/4", "-o", file, "--resume"]);
    assert!(refused(2, &other).contains("belongs to another study: line 1 "));
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
    for wrong in [
        &["--resume"][..],
        &["--resume", "-o", "-"],
        &["--resume", "-o", file, "--format", "json"],
    ] {
        refused(
            2,
            &study(&[&["--vary", "r2.length=30..50/4"], wrong].concat()),
        );
    }
}

/// Regression: a disk that filled after the first rows cost the older file. A limit on the size of
/// files fails in the same way.
#[test]
fn study_restores_the_older_file_if_a_write_fails() {
    let folder = folder("study-full");
    let file = folder.join("out.csv");
    fs::write(&file, "old").unwrap();
    let vary = "--vary r2.length=30..40/20000 --threads 1";
    let study = format!("study {CRANK} --columns {COLUMNS} {vary}");
    let script = format!("trap '' XFSZ; ulimit -f 64; exec \"$0\" {study} -o \"$1\"");
    let run = std::process::Command::new("/bin/sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_krank")])
        .arg(&file)
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap();
    let shown = String::from_utf8(run.stderr).unwrap();
    assert_eq!(run.status.code(), Some(1), "{shown}");
    assert!(shown.contains("out.csv"), "{shown}");
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
}

/// A changed row in the middle is detected, and the file is not changed.
#[test]
fn resume_rejects_a_file_in_which_a_row_was_changed() {
    let path = folder("study-changed").join("designs.csv");
    let file = path.to_str().unwrap();
    let args = study(&[
        "--vary",
        "r2.length=30..50/4,r3.length=85..150/10",
        "-o",
        file,
    ]);
    assert_eq!(krank(&args).code, 0);
    let text = fs::read_to_string(&path).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let cells = &mut lines[21];
    let digit = cells.rfind(|c: char| ('1'..='8').contains(&c)).unwrap();
    cells.replace_range(digit..=digit, "9");
    let changed = lines[..35].join("\n") + "\n";
    fs::write(&path, &changed).unwrap();
    let resume = [&args[..], &["--resume"]].concat();
    assert!(refused(1, &resume).contains("line 22 of "));
    assert_eq!(fs::read_to_string(&path).unwrap(), changed);
}

/// With the crank at 60 deg, the rod must reach 40 sin 60 deg + 50 = 84.6 mm down to the guide.
#[test]
fn failed_designs_are_rows_with_a_reason() {
    let vary = "r3.length=80..100/2";
    let Run { code, out, err } = krank(&study(&["--vary", vary]));
    assert_eq!(code, 0);
    assert!(
        err.contains(
            "1 of 2 designs cannot be assembled like the scene, and 0 are not valid scenes"
        ),
        "{err}"
    );
    let found = rows(&out);
    assert_eq!(found[0][..4], ["80", "", "", "no-assembly"]);
    assert!(!found[0][4].is_empty());
    assert_eq!(found[1][3], "ok");

    let Run { code, out, .. } = krank(&study(&["--vary", "r2.length=0..40/2"]));
    assert_eq!(code, 0);
    let found = rows(&out);
    assert_eq!(found[0][..4], ["0", "", "", "unreadable"]);
    assert!(found[0][4].contains("length"), "{}", found[0][4]);

    // Only one value is missing: the rod of a slider-crank has a swing, but the crank turns fully.
    let args = [
        "study",
        CRANK,
        "--vary",
        "r2.length=30..40/2",
        "--columns",
        "r2.angle.swing,r3.angle.swing",
    ];
    let found = rows(&run_ok(&args));
    assert_eq!(found[0][1], "");
    assert_eq!(found[0][3], "ok");
    assert!(
        found[0][4].starts_with("r2.angle.swing: "),
        "{:?}",
        found[0]
    );
    let swing = (80.0_f64 / 120.0).asin() - (20.0_f64 / 120.0).asin();
    assert!(
        (number(&found[0][2]) - swing.to_degrees()).abs() < 1e-9,
        "{:?}",
        found[0]
    );

    assert!(
        refused_with_rows(&study(&["--vary", "r3.length=10..20/2"]))
            .contains("none of the values exists")
    );
}

/// Runs a study that exits with 1 but still prints rows, and returns the message.
fn refused_with_rows(args: &[&str]) -> String {
    let run = krank(args);
    assert_eq!(run.code, 1, "{}", run.err);
    assert_eq!(rows(&run.out).len(), 2);
    run.err
}

#[test]
fn latin_hypercube_is_determined_by_its_seed() {
    let latin = |seed| {
        run_ok(&study(&[
            "--vary",
            "r2.length=30..40,r3.length=110..150",
            "--latin",
            "20",
            "--seed",
            seed,
        ]))
    };
    let one = latin("7");
    assert_eq!(one, latin("7"));
    assert_ne!(one, latin("8"));
    let mut seen: Vec<f64> = rows(&one).iter().map(|row| number(&row[1])).collect();
    seen.sort_by(f64::total_cmp);
    let known: Vec<f64> = (0..20).map(|k| 111.0 + 2.0 * f64::from(k)).collect();
    assert_eq!(seen, known);
}

#[test]
fn invalid_variations_are_rejected() {
    for (vary, message) in [
        ("r3.lenght=1..2/2", "r3.length"),
        ("r3.length", "has no limits: write r3.length=280..320"),
        ("r3.length=1..2/2,r3.length=3..4/2", "is given twice"),
        ("r3.length=1..2/0", "is not a valid range"),
        (
            "r3.length=1..2/4000000000,r2.length=1..2/10",
            "more than 10^9 designs",
        ),
    ] {
        let err = refused(2, &study(&["--vary", vary]));
        assert!(err.contains("--vary") || err.contains("10^9"), "{err}");
        assert!(err.contains(message), "{vary}: {err}");
    }
    let err = refused(
        2,
        &study(&["--vary", "r3.length=110..120/3", "--latin", "5"]),
    );
    assert!(err.contains("--latin"), "{err}");
    let err = refused(
        2,
        &[
            "study",
            CRANK,
            "--vary",
            "r3.length=110..120",
            "--columns",
            "r4.lenth.stroke",
        ],
    );
    assert!(err.contains("r4.length.stroke"), "{err}");
    refused(
        2,
        &study(&["--vary", "r3.length=110..120", "--part", "5/4"]),
    );
}

#[test]
fn json_and_text_contain_the_same_values() {
    let vary = ["--vary", "r2.length=30..40/2", "--format"];
    let found = json(&run_ok(&study(&[&vary[..], &["json"]].concat())));
    assert_eq!(found["units"]["r4.length.stroke"], "mm");
    assert_eq!(found["designs"][1]["r2.length"], 40.0);
    let [stroke, ratio] = closed(40.0, 120.0, 50.0);
    let near = |value: &serde_json::Value, known: f64| {
        (value.as_f64().unwrap() - known).abs() < 1e-9 * known
    };
    assert!(near(&found["designs"][1]["r4.length.stroke"], stroke));
    assert!(near(&found["designs"][1]["r4.length.ratio"], ratio));
    assert_eq!(found["designs"][1]["state"], "ok");
    let Run { code, out, err } = krank(&study(&[&vary[..], &["text"]].concat()));
    assert_eq!(code, 0);
    assert_eq!(out.lines().count(), 3);
    let output = format!("maximum {stroke:.4} mm at r2.length = 40.0000 mm");
    assert!(err.contains(&output), "{output}: {err}");
}

#[test]
fn one_variable_gives_a_curve_and_two_give_a_map() {
    let one = [
        "--vary",
        "r2.length=30..60/7",
        "--size",
        "60x16",
        "--format",
    ];
    let chart = krank(&study(&[&one[..], &["chart"]].concat()));
    assert_eq!(chart.code, 0, "{}", chart.err);
    assert!(
        chart.out.contains("r4.length.stroke") && chart.out.contains('*'),
        "{}",
        chart.out
    );
    assert!(chart.out.lines().all(|line| line.len() <= 60));
    let svg = krank(&study(&[&one[..], &["svg"]].concat())).out;
    assert!(
        svg.starts_with("<svg") && svg.contains("r4.length.ratio"),
        "{svg}"
    );

    let two = [
        "--vary",
        "r2.length=30..60/7,r3.length=80..150/8",
        "--size",
        "60x20",
        "--format",
    ];
    let chart = krank(&study(&[&two[..], &["chart"]].concat()));
    assert!(chart.out.is_ascii());
    assert!(
        chart.out.contains("\n  . ") && chart.out.contains("blank: no value"),
        "{}",
        chart.out
    );
    assert!(
        chart.out.lines().all(|line| line.len() <= 60),
        "{}",
        chart.out
    );
    let svg = krank(&study(&[&two[..], &["svg"]].concat())).out;
    assert!(
        svg.contains("up: r3.length [mm]; along: r2.length [mm]"),
        "{svg}"
    );

    let three = [
        "--vary",
        "r2.length=30..40/2,r3.length=110..120/2,r4.through.y=-20..20/2",
    ];
    assert!(
        refused(2, &study(&[&three[..], &["--format", "chart"]].concat()))
            .contains("one or two values")
    );
}
