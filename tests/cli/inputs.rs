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

/// An input without a column follows the driver: one at a ratio turns with it, a held one stays.
#[test]
fn inputs_without_a_column_follow_the_driver_of_a_path() {
    let folder = folder("path-followers");
    let (scene, file) = (folder.join("scene.toml"), folder.join("poses.csv"));
    let [scene_file, file] = [&scene, &file].map(|path| path.to_str().unwrap());
    let text = fs::read_to_string("presets/five-bar.toml").unwrap();
    let sweep = ["sweep", scene_file, "--path", file, "--columns", "r5.angle"];
    fs::write(file, "r2\n120\n100\n").unwrap();
    for (law, expected) in [
        ("{ at = 60 }", [60.0, 60.0]),
        ("{ ratio = -1, phase = 180 }", [60.0, 80.0]),
    ] {
        let text = text.replace("{ at = 60 }", law);
        assert!(text.contains(&format!("r5 = {law}")), "{text}");
        fs::write(&scene, text).unwrap();
        let output = run_ok(&sweep);
        let lines: Vec<&str> = output.lines().collect();
        assert_row(lines[1], &[120.0, expected[0]]);
        assert_row(lines[2], &[100.0, expected[1]]);
    }
}

/// The rows of a sweep move the inputs again: its headers are names of columns with units.
#[test]
fn path_takes_the_headers_of_a_sweep() {
    let file = folder("path-headers").join("poses.csv");
    let file = file.to_str().unwrap();
    fs::write(
        file,
        "driver.angle [deg];r5.angle [deg]\n120;60,0\n90;90,0\n",
    )
    .unwrap();
    let output = run_ok(&["sweep", "five-bar", "--path", file, "--columns", "P.y"]);
    let lines: Vec<&str> = output.lines().collect();
    assert_row(lines[1], &[120.0, 173.205_080_756_888]);
    assert_row(lines[2], &[90.0, 226.491_106_406_735]);
}

/// Returns the angles of the motors that place P, with the elbows outwards: by the law of cosines in
/// the triangles of 100 and 140 at both motors.
fn five_bar_inputs(x: f64, y: f64) -> [f64; 2] {
    let motor = |base: f64, side: f64| {
        let (dx, distance) = (x - base, (x - base).hypot(y));
        let cos = (100.0_f64.powi(2) + distance.powi(2) - 140.0_f64.powi(2)) / (200.0 * distance);
        (y.atan2(dx) + side * cos.acos()).to_degrees()
    };
    [motor(-60.0, 1.0), motor(60.0, -1.0)]
}

/// A point leads, and both inputs follow. A row beyond the arms has no values; the next one is
/// reached again from the last position.
#[test]
fn inputs_follow_a_leading_point() {
    let file = folder("path-lead").join("points.csv");
    let file = file.to_str().unwrap();
    let points = [
        [0.0, 173.205_080_756_888],
        [0.0, 226.491_106_406_735],
        [20.0, 220.0],
        [0.0, 240.0],
        [10.0, 200.0],
    ];
    let rows = points.map(|[x, y]| format!("{x:?},{y:?}\n"));
    fs::write(file, format!("P.x [mm],P.y [mm]\n{}", rows.concat())).unwrap();
    let sweep = ["sweep", "five-bar", "--path", file, "--columns"];
    let output = krank(&[&sweep[..], &["r5.angle,P.x,P.y"]].concat());
    let note = "note: 1 of 5 rows cannot be reached by the inputs\n";
    assert_eq!((output.code, &*output.err), (0, note));
    let lines: Vec<&str> = output.out.lines().skip(1).collect();
    for (line, [x, y]) in lines.iter().zip(points) {
        if y == 240.0 {
            assert_eq!(*line, ",,,,no-assembly");
            continue;
        }
        let [left, right] = five_bar_inputs(x, y);
        let expected = [left, right, x, y];
        let (found, state) = row(line);
        assert_eq!(state, "ok");
        let is_near = found
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(is_near, "{line}, not {expected:?}");
    }
    // The reference values of the five-bar.
    for (line, angle) in lines.iter().zip([120.0, 90.0]) {
        assert!((row(line).0[0] - angle).abs() < 1e-9, "{line}");
    }
}

/// At the edge of the workspace both arms are straight: 240 from each motor. One coordinate can lead
/// one input, while the file gives the other one.
#[test]
fn edge_of_the_workspace_is_reported() {
    let file = folder("path-edge").join("points.csv");
    let file = file.to_str().unwrap();
    let sweep = ["sweep", "five-bar", "--path", file, "--columns", "P.x,P.y"];
    fs::write(file, "P.x,P.y\n0,200\n0,232.379000772445\n").unwrap();
    let output = krank(&sweep);
    let note = "note: 1 of 2 rows are singular: row 2: edge of the workspace, where the point does not follow r2, r5\n";
    assert_eq!((output.code, &*output.err), (0, note));
    let edge = row(output.out.lines().nth(2).unwrap()).0;
    // The next row continues from the last one before the edge.
    fs::write(file, "P.x,P.y\n0,200\n0,232.379000772445\n0,200\n").unwrap();
    let again = krank(&sweep).out;
    let lines: Vec<&str> = again.lines().skip(1).collect();
    let pairs = row(lines[0]).0.into_iter().zip(row(lines[2]).0);
    for (first, third) in pairs {
        assert!((first - third).abs() < 1e-9, "{again}");
    }
    let height = (240.0_f64.powi(2) - 60.0_f64.powi(2)).sqrt();
    assert!((edge[2] - height).abs() < 1e-9, "{edge:?}");
    let angle = (height / 60.0).atan().to_degrees();
    assert!((edge[0] - angle).abs() < 1e-3, "{edge:?}");
    fs::write(file, "P.x,r5\n15.0374665306473,45\n").unwrap();
    let one = run_ok(&sweep);
    assert!(
        (row(one.lines().nth(1).unwrap()).0[0] - 120.0).abs() < 1e-9,
        "{one}"
    );
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
        ("r2,r5\n1,2\n3,\n", "line 3: `` below `r5`"),
        ("r2,r5\n1,inf\n", "line 2: `inf` below `r5`"),
        ("r2;r5\n1;1,500\n", "line 2: `1,500` below `r5`"),
        (
            "r2,r5.angle [rad]\n1,2\n",
            "the column `r5.angle` is in rad; write its numbers in deg",
        ),
        (
            "r2,driver.angle\n1,2\n",
            "two columns are called `driver.angle`",
        ),
        ("r2,r5\n", "no row of numbers"),
        ("", "no row of numbers"),
        (
            "P.x\n1\n",
            "has 1 coordinates of points, and 2 inputs without a column (r2, r5)",
        ),
        (
            "P.x,P.y,r2\n1,2,3\n",
            "has 2 coordinates of points, and 1 inputs without a column (r5)",
        ),
        ("A.x,P.y\n1,2\n", "no input `A.x`"),
        (
            "P.x [cm],P.y\n1,2\n",
            "the column `P.x` is in cm; write its numbers in mm",
        ),
    ] {
        fs::write(file, text).unwrap();
        let found = refused(2, &["sweep", "five-bar", "--path", file]);
        assert!(found.contains(message), "{found}");
    }
}

/// Writes the five-bar with a leading point to a file, and returns its name.
fn five_bar_led(name: &str, lead: &str) -> String {
    let file = folder(name).join("scene.toml");
    let text = fs::read_to_string("presets/five-bar.toml").unwrap();
    fs::write(&file, format!("{text}\n[lead]\n{lead}\n")).unwrap();
    file.to_str().unwrap().to_owned()
}

/// The rows of a sweep are times, and the rates are those of the path: 3/2 of the mean speed in the
/// middle of a line, and none at its ends.
#[test]
fn sweep_of_a_leading_point_goes_over_time() {
    let scene = five_bar_led(
        "lead-sweep",
        "P = { over = [[0, 0, 173.205080756888], [2, 0, 226.491106406735]] }",
    );
    let columns = "r5.angle,r5.omega,P.y,P.vy,P.ay";
    let sweep = ["sweep", &scene, "--step", "1", "--columns", columns];
    let output = run_ok(&sweep);
    let lines: Vec<&str> = output.lines().collect();
    assert_eq!(
        lines[0],
        "time [s],driver.angle [deg],r5.angle [deg],r5.omega [rad/s],P.y [mm],P.vy [mm/s],P.ay [mm/s^2],state"
    );
    let way: f64 = 226.491_106_406_735 - 173.205_080_756_888;
    let ends = [(1, 0.0, [120.0, 60.0]), (3, 2.0, [90.0, 90.0])];
    for (line, time, [left, right]) in ends {
        let (found, state) = row(lines[line]);
        assert_eq!(state, "ok");
        let acceleration = way * (1.5 - 1.5 * time);
        let y = 173.205_080_756_888 + way * time / 2.0;
        for (found, expected) in found
            .iter()
            .zip([time, left, right, 0.0, y, 0.0, acceleration])
        {
            assert!((found - expected).abs() < 1e-8, "{}", lines[line]);
        }
    }
    let middle = row(lines[2]).0;
    assert!((middle[5] - 0.75 * way).abs() < 1e-9, "{middle:?}");
    // `--time` says the same, and the table has the same values.
    assert_eq!(run_ok(&[&sweep[..], &["--time"]].concat()), output);
    let table = [
        "table",
        &scene,
        "--time",
        "1",
        "--columns",
        "r5.angle,r5.omega",
        "--format",
        "json",
    ];
    let found: serde_json::Value = serde_json::from_str(&run_ok(&table)).unwrap();
    let text = found.to_string();
    assert!(
        text.contains(&middle[2].to_string()),
        "{text}, not {}",
        middle[2]
    );
    assert!(
        text.contains(&middle[3].to_string()),
        "{text}, not {}",
        middle[3]
    );
}

/// Rows beyond the edge have no values, and `check` names the edge, its time and its inputs.
#[test]
fn check_tells_how_far_a_leading_point_is_followed() {
    let scene = five_bar_led("lead-check", "P = { over = [[0, 0, 173], [1, 0, 260]] }");
    let output = krank(&["sweep", &scene, "--step", "0.5", "--columns", "P.y"]);
    assert_eq!(output.code, 0, "{}", output.err);
    assert_eq!(
        output.err,
        "note: 1 of 3 rows cannot be reached by the inputs\n"
    );
    assert_eq!(output.out.lines().nth(3), Some("1,,,no-assembly"));
    let check = run_ok(&["check", &scene]);
    for text in [
        "P leads from 0 to 1 s; inputs that follow: r2, r5",
        "the inputs follow it only up to 0.",
        "at [0, 232.379001]",
        "edge of the workspace, where the point does not",
    ] {
        assert!(check.contains(text), "{check}");
    }
    let json: serde_json::Value =
        serde_json::from_str(&run_ok(&["check", &scene, "--format", "json"])).unwrap();
    let lead = &json["lead"];
    assert_eq!(
        (&lead["point"], &lead["complete"]),
        (&"P".into(), &false.into())
    );
    assert_eq!(lead["singular"][0]["kind"], "serial");
    assert_eq!(
        lead["singular"][0]["inputs"],
        serde_json::json!(["r2", "r5"])
    );
    let beyond = refused(1, &["table", &scene, "--time", "1"]);
    assert!(
        beyond.contains("the inputs cannot follow the point up to 1 s"),
        "{beyond}"
    );
    // Followed to its end.
    let scene = five_bar_led(
        "lead-circle",
        "P = { centre = [0, 180], radius = 20, speed = \"60 deg/s\" }",
    );
    let check = run_ok(&["check", &scene]);
    assert!(check.contains("P leads from 0 to 6 s"), "{check}");
    assert!(
        check.contains("follow it to the end, and the assembly is kept"),
        "{check}"
    );
    let turkish = run_ok(&["check", &scene, "--language", "tr"]);
    assert!(
        turkish.contains("girisler onu sonuna kadar izler"),
        "{turkish}"
    );
    // Without proved bounds none are shown.
    let bounds = refused(2, &["sweep", &scene, "--bounds"]);
    assert!(bounds.contains("have no error bounds"), "{bounds}");
}

/// The inputs hold the load at P: their torques are in equilibrium with it, at every moment and on
/// either arm. With d from the elbow to P, a motor has the torque of the rod's force along d.
#[test]
fn torques_of_a_leading_point_hold_its_load() {
    let file = folder("lead-torque").join("scene.toml");
    let text = fs::read_to_string("presets/five-bar.toml").unwrap();
    let load = "[[loads]]\npoint = \"P\"\nforce = [30, -80]\n";
    let lead = "[lead]\nP = { over = [[0, 10, 180], [1, 40, 200]] }\n";
    fs::write(&file, format!("{text}\n{load}\n{lead}")).unwrap();
    let file = file.to_str().unwrap();
    let columns = "P.x,P.y,r2.torque,r5.torque,driver.torque";
    let output = run_ok(&["sweep", file, "--step", "0.25", "--columns", columns]);
    for line in output.lines().skip(1) {
        let found = row(line).0;
        let [x, y, left, right, driver] = found[2..7] else {
            panic!("{line}");
        };
        assert_eq!(left, driver);
        // Forces of both rods along their directions balance the load.
        let angles = five_bar_inputs(x, y).map(f64::to_radians);
        let elbows = [(-60.0, angles[0]), (60.0, angles[1])];
        let elbows = elbows.map(|(base, a): (f64, f64)| [base + 100.0 * a.cos(), 100.0 * a.sin()]);
        let [d, e] = elbows.map(|[bx, by]| [(x - bx) / 140.0, (y - by) / 140.0]);
        let (fx, fy) = (30.0, -80.0);
        let det = d[0] * e[1] - d[1] * e[0];
        // The rods push P with forces f d and g e, whose sum is the opposite of the load.
        let f = (-fx * e[1] + fy * e[0]) / det;
        let g = (-fy * d[0] + fx * d[1]) / det;
        for ((torque, size), (base, [bx, by], way)) in [(left, f), (right, g)]
            .into_iter()
            .zip([(-60.0, elbows[0], d), (60.0, elbows[1], e)])
        {
            let expected = ((bx - base) * way[1] - by * way[0]) * size / 1000.0;
            assert!((torque - expected).abs() < 1e-10, "{line}: {expected}");
        }
    }
}
