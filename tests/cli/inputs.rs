//! Tests of scenes with several inputs: `--by`, and `--path` of a sweep.

use super::{folder, krank, refused, run_ok};
use std::fs;

/// Returns the numbers of a row, and its state.
fn row(line: &str) -> (Vec<f64>, &str) {
    let (numbers, state) = line.rsplit_once(',').unwrap();
    let numbers = numbers
        .split(',')
        .map(|cell| cell.parse().unwrap_or(f64::NAN));
    (numbers.collect(), state)
}

#[track_caller]
fn assert_row(line: &str, expected: &[f64]) {
    let (found, state) = row(line);
    assert_eq!(state, "ok");
    let pairs = found.iter().zip(expected);
    let is_near = pairs.clone().all(|(a, b)| (a - b).abs() < 1e-12);
    assert!(
        is_near && pairs.len() == expected.len(),
        "{line}, not {expected:?}"
    );
}

/// The places of P are intersections of two circles of 140 about the elbows, by complex numbers.
#[test]
fn another_input_than_the_driver_moves() {
    let sweep = [
        "sweep", "five-bar", "--by", "r5", "--from", "45", "--to", "60", "--step", "15",
    ];
    let output = krank(&[&sweep[..], &["--columns", "P.x,P.y"]].concat());
    assert_eq!((output.code, output.err.as_str()), (0, ""));
    let lines: Vec<&str> = output.out.lines().collect();
    assert_row(
        lines[1],
        &[45.0, 15.037_466_530_647_28, 149.575_804_257_627_3],
    );
    assert_row(lines[2], &[60.0, 0.0, 173.205_080_756_888]);
    // The driver moves anyway.
    let own = krank(&["sweep", "five-bar", "--by", "r2", "--columns", "P.x"]);
    assert_eq!((own.code, own.err.as_str()), (0, ""));
    assert_eq!(own.out, run_ok(&["sweep", "five-bar", "--columns", "P.x"]));
    let check = run_ok(&["check", "excavator"]);
    assert!(check.contains("arm-rod is held at 2.55 m"), "{check}");
    let message = refused(2, &["table", "five-bar", "--by", "r3"]);
    assert!(
        message.contains("no input `r3`; its inputs: r2, r5"),
        "{message}"
    );
}

/// Every input has a column; a row out of reach has no values, and the next one has again.
#[test]
fn path_moves_all_inputs() {
    let file = folder("path").join("poses.csv");
    let file = file.to_str().unwrap();
    fs::write(file, "r5,r2\n60,120\n90,90\n60,180\n60,120\n").unwrap();
    let sweep = [
        "sweep",
        "five-bar",
        "--path",
        file,
        "--columns",
        "r5.angle,P.x,P.y",
    ];
    let output = krank(&sweep);
    assert_eq!(output.code, 0, "{}", output.err);
    assert_eq!(
        output.err,
        "note: 1 of 4 rows cannot be reached by the inputs\n"
    );
    let lines: Vec<&str> = output.out.lines().collect();
    assert_eq!(
        lines[0],
        "driver.angle [deg],r5.angle [deg],P.x [mm],P.y [mm],state"
    );
    assert_row(lines[1], &[120.0, 60.0, 0.0, 173.205_080_756_888]);
    assert_row(lines[2], &[90.0, 90.0, 0.0, 226.491_106_406_735]);
    assert_eq!(lines[3], "180,,,,no-assembly");
    assert_row(lines[4], &[120.0, 60.0, 0.0, 173.205_080_756_888]);
    // Rates need times.
    let rates = refused(
        2,
        &["sweep", "five-bar", "--path", file, "--columns", "P.vx"],
    );
    assert!(rates.contains("`P.vx` needs a speed"), "{rates}");
}

#[test]
fn faults_of_a_path_name_their_line() {
    let file = folder("path-faults").join("poses.csv");
    let file = file.to_str().unwrap();
    for (text, message) in [
        ("r2,r4\n1,2\n", "no input `r4`"),
        ("r2,r2\n1,2\n", "two columns are called `r2`"),
        ("r2,r5\n1,2\n3\n", "line 3 has 1 cells, and the first one 2"),
        ("r2,r5\n1,2\n3,4 rad\n", "line 3: `4 rad` below `r5`"),
        ("r2,r5\n", "no row of numbers"),
        ("", "no row of numbers"),
    ] {
        fs::write(file, text).unwrap();
        let found = refused(2, &["sweep", "five-bar", "--path", file]);
        assert!(found.contains(message), "{found}");
    }
}
