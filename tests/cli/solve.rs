//! Tests of `krank solve`: designs that meet goals, against closed forms; written scenes and rejected arguments.

use super::{Run, folder, json, krank, run_ok};

/// Returns the stroke of an offset slider-crank: sqrt((l + r)^2 - e^2) - sqrt((l - r)^2 - e^2).
fn stroke(r: f64, l: f64, e: f64) -> f64 {
    ((l + r).powi(2) - e * e).sqrt() - ((l - r).powi(2) - e * e).sqrt()
}

#[test]
fn report_lists_found_designs_next_to_the_given_one() {
    let text = run_ok(&[
        "solve",
        "slider-crank",
        "--vary",
        "r2.length",
        "--goal",
        "r4.length.stroke = 13",
        "--starts",
        "3",
    ]);
    assert!(
        text.is_ascii() && text.lines().all(|line| line.len() <= 80),
        "{text}"
    );
    let row = text
        .lines()
        .find(|line| line.starts_with("r2.length [cm]"))
        .unwrap();
    let cells: Vec<&str> = row.split_whitespace().collect();
    assert_eq!(cells[2], "10");
    let found: f64 = cells[3].parse().unwrap();
    assert!((found - 6.5).abs() < 1e-9, "{text}");
}

/// The written scene opens like any other and has the requested stroke.
#[test]
fn written_scene_meets_the_goal() {
    let file = folder("solve").join("found.toml");
    let file = file.to_str().unwrap();
    let found = json(&run_ok(&[
        "solve",
        "offset-slider-crank",
        "--vary",
        "r2.length,r4.through.y",
        "--goal",
        "r4.length.stroke = 120 mm",
        "--keep",
        "transmission >= 40",
        "--starts",
        "2",
        "--format",
        "json",
        "-o",
        file,
    ]));
    let values = &found["solutions"][0]["values"];
    let [r, e] = ["r2.length", "r4.through.y"].map(|name| values[name].as_f64().unwrap());
    let l = 120.0;
    assert!((stroke(r, l, e) - 120.0).abs() < 1e-6, "{r} {e}");
    let text = std::fs::read_to_string(file).unwrap();
    let preset = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/presets/offset-slider-crank.toml"
    );
    let given = std::fs::read_to_string(preset).unwrap();
    let same = text
        .lines()
        .zip(given.lines())
        .filter(|(one, other)| one == other);
    assert_eq!(same.count() + 2, given.lines().count(), "{text}");
    let again = run_ok(&[
        "solve",
        file,
        "--vary",
        "r2.length",
        "--goal",
        "r4.length.stroke = 120",
        "--starts",
        "0",
    ]);
    assert!(again.contains("one design"), "{again}");
}

/// If no design meets the goal, the nearest one is printed, but not as a solution.
#[test]
fn unreachable_goal_exits_with_1_and_prints_nearest_design() {
    let output = krank(&[
        "solve",
        "slider-crank",
        "--vary",
        "r2.length=5..12",
        "--goal",
        "r4.length.stroke = 30",
        "--starts",
        "2",
    ]);
    assert_eq!(output.code, 1, "{}", output.err);
    assert!(
        output.out.contains("nearest") && output.out.contains("12"),
        "{}",
        output.out
    );
    assert!(output.err.contains("no design"), "{}", output.err);
}

#[test]
fn optimum_lies_on_the_transmission_limit() {
    // Without offset, the transmission angle has its minimum when the crank is across: cos = r / l.
    let found = json(&run_ok(&[
        "solve",
        "slider-crank",
        "--vary",
        "r2.length=2..19",
        "--maximize",
        "r4.length.stroke",
        "--keep",
        "transmission >= 60",
        "--generations",
        "80",
        "--format",
        "json",
    ]));
    let r = found["values"]["r2.length"].as_f64().unwrap();
    assert!((r - 10.0).abs() < 1e-3, "{found}");
    assert_eq!(found["missed"], 0.0);
}

#[test]
fn invalid_searches_are_rejected_with_a_fix() {
    for (args, words) in [
        (vec!["--vary", "r2.length"], "--goal"),
        (
            vec!["--vary", "r2.lenght", "--goal", "range = 360"],
            "r2.length",
        ),
        (
            vec!["--vary", "r2.length,r2.length", "--goal", "range = 360"],
            "twice",
        ),
        (
            vec!["--vary", "r2.length=1", "--goal", "range = 360"],
            "280..320",
        ),
        (
            vec!["--vary", "r2.length", "--goal", "r4.length.strok = 3"],
            "r4.length.stroke",
        ),
        (
            vec!["--vary", "r2.length", "--goal", "r4.length.stroke 3"],
            "quantity, a sign",
        ),
        (
            vec!["--vary", "r2.length", "--goal", "r4.length.stroke = 3 deg"],
            "cm",
        ),
        (
            vec!["--vary", "r2.length", "--maximize", "r4.length.stroke"],
            "r2.length=LOW..HIGH",
        ),
        (
            vec![
                "--vary",
                "r2.length=1..2",
                "--goal",
                "range = 360",
                "--minimize",
                "range",
            ],
            "--keep",
        ),
    ] {
        let mut all = vec!["solve", "slider-crank"];
        all.extend(&args);
        let output = krank(&all);
        assert_eq!(output.code, 2, "{args:?}: {}", output.err);
        assert!(output.err.contains(words), "{args:?}: {}", output.err);
    }
}

/// Regression test: the column was empty, without any reason.
#[test]
fn missing_goal_value_is_reported_with_the_reason() {
    let goal = [
        "solve",
        "four-bar",
        "--vary",
        "r4.length",
        "--starts",
        "0",
        "--goal",
    ];
    let requested = |figure: &str, more: &[&str]| {
        let done = krank(&[&goal[..], &[figure], more].concat());
        assert_eq!(done.code, 1);
        done.out
    };
    let text = requested("driver.angle.ratio = 40", &[]);
    assert!(
        text.contains("driver.angle.ratio: it turns fully"),
        "{text}"
    );
    // The table has no column for a nearest design.
    let headers = text
        .lines()
        .find(|line| line.trim_start().starts_with("given  ") || line.trim() == "given");
    assert!(
        headers.is_some_and(|headers| !headers.contains("nearest")),
        "{text}"
    );
    let found = json(&requested("driver.angle.ratio = 40", &["--format", "json"]));
    assert_eq!(found["lacks"]["driver.angle.ratio"], "it turns fully");
    let best = krank(&[
        "solve",
        "four-bar",
        "--vary",
        "r4.length=200..300",
        "--maximize",
        "driver.angle.ratio",
        "--generations",
        "1",
    ]);
    assert!(
        best.err.contains("driver.angle.ratio: it turns fully"),
        "{}",
        best.err
    );
}

/// A resumed search is never worse than the design in the file, even if it has a single generation. The file must come
/// from the same scene.
#[test]
fn resumed_search_starts_from_the_written_design() {
    let file = folder("solve-resume").join("best.toml");
    let file = file.to_str().unwrap();
    let search = |scene: &str, more: &[&str]| {
        let mut all = vec!["solve", scene, "--vary", "r2.length=2..19"];
        all.extend([
            "--maximize",
            "r4.length.stroke",
            "--keep",
            "transmission >= 60",
        ]);
        all.extend(["--format", "json", "-o", file, "--resume"]);
        all.extend(more);
        krank(&all)
    };
    let value = |done: &Run| json(&done.out)["value"].as_f64().unwrap();
    // Without the file, the search begins anew.
    let first = search("slider-crank", &["--generations", "60"]);
    assert_eq!(first.code, 0, "{}", first.err);
    let again = search("slider-crank", &["--generations", "1", "--seed", "9"]);
    assert_eq!(again.code, 0, "{}", again.err);
    assert!(
        value(&again) >= value(&first),
        "{} {}",
        first.out,
        again.out
    );
    let other = search("offset-slider-crank", &[]);
    assert_eq!(other.code, 2, "{}", other.err);
    assert!(other.err.contains("differs"), "{}", other.err);
    for (args, words) in [
        (["--maximize", "range"], "-o"),
        (["--goal", "range = 360"], "--maximize"),
    ] {
        let mut all = vec![
            "solve",
            "slider-crank",
            "--vary",
            "r2.length=2..19",
            "--resume",
        ];
        all.extend(args);
        let output = krank(&all);
        assert_eq!(output.code, 2, "{}", output.err);
        assert!(output.err.contains(words), "{}", output.err);
    }
}

/// Numbers on the command line have a point or a comma, also within lists.
#[test]
fn decimal_commas_are_numbers_in_goals_and_ranges() {
    let found = |vary: &str, goal: &str| {
        let range = ["solve", "slider-crank", "--vary", vary, "--starts", "1"];
        json(&run_ok(
            &[&range[..], &["--format", "json", "--goal", goal]].concat(),
        ))
    };
    let comma = found(
        "r2.length=5,5..7,5,r3.length=20,5..30",
        "r4.length.stroke = 12,5",
    );
    let point = found(
        "r2.length=5.5..7.5,r3.length=20.5..30",
        "r4.length.stroke = 12.5",
    );
    assert_eq!(comma["solutions"], point["solutions"]);
    assert!(comma["solutions"][0]["values"]["r2.length"].is_number());
    let study = |vary: &str, columns: &str| {
        run_ok(&[
            "study",
            "slider-crank",
            "--vary",
            vary,
            "--columns",
            columns,
        ])
    };
    let comma = study("r2.length=1,5..2,5/3", "C.x@60,5,C.x.stroke");
    assert_eq!(comma, study("r2.length=1.5..2.5/3", "C.x@60.5,C.x.stroke"));
    assert_eq!(comma.lines().count(), 4, "{comma}");
    let run = krank(&[
        "solve",
        "slider-crank",
        "--vary",
        "r2.length=1,500..2",
        "--goal",
        "C.x.stroke = 2",
    ]);
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("1,500: leave out the thousands separator"),
        "{}",
        run.err
    );
}
