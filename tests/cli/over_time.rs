//! Tests of values over time: the driver's motion law with its speed and acceleration.

use super::{folder, json, krank, refused, rows, run_ok};
use std::f64::consts::PI;
use std::fs;

/// A slider-crank of 100 and 300 mm that turns 120 deg forward and back, with a slider of 2 kg.
const INDEXED: &str = r#"
unit = "mm"
[ground]
A = [0, 0]
[driver]
link = "r2"
angle = 0
motion = [
  { law = "cycloidal", to = 120, time = 0.5 },
  { dwell = 0.2 },
  { law = "harmonic", to = 0, time = 0.4 },
]
[links]
r2 = { from = "A", to = "B", length = 100 }
r3 = { from = "B", to = "C", length = 300 }
ram = { points = { C = [0, 0] }, com = [0, 0], mass = 2 }
[slides]
r4 = { link = "ram", on = "ground", through = "A", angle = 0, turn = 0 }
[start]
C = [400, 0]
"#;

fn scene(name: &str, text: &str) -> String {
    let path = folder("over-time").join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Returns angle, speed and acceleration of the crank in radians, by the laws in handbooks.
fn crank(time: f64) -> [f64; 3] {
    let h = 120_f64.to_radians();
    if time < 0.5 {
        let (s, t) = (time / 0.5, 0.5);
        let round = 2.0 * PI * s;
        let way = s - round.sin() / (2.0 * PI);
        let acceleration = 2.0 * PI * h / (t * t) * round.sin();
        [h * way, h / t * (1.0 - round.cos()), acceleration]
    } else if time < 0.7 {
        [h, 0.0, 0.0]
    } else {
        let (s, t) = ((time - 0.7) / 0.4, 0.4);
        let (sin, cos) = (PI * s).sin_cos();
        let acceleration = PI * PI * h / (2.0 * t * t) * cos;
        [
            h * (1.0 + cos) / 2.0,
            -PI * h / (2.0 * t) * sin,
            -acceleration,
        ]
    }
}

/// Returns the position in mm of a slider with crank 100 and rod 300, and its derivatives by the
/// angle: x = r c + w, w^2 = l^2 - r^2 s^2.
fn slider(angle: f64) -> [f64; 3] {
    let (r, l) = (100.0, 300.0);
    let (s, c) = angle.sin_cos();
    let w = (l * l - r * r * s * s).sqrt();
    let w1 = -r * r * s * c / w;
    let w2 = -(r * r * (c * c - s * s) + w1 * w1) / w;
    [r * c + w, -r * s + w1, -r * c + w2]
}

fn near(found: f64, exact: f64, size: f64) {
    assert!((found - exact).abs() < 1e-9 * size, "{found} for {exact}");
}

#[test]
fn rows_over_time_follow_the_motion_law() {
    let path = scene("rows.toml", INDEXED);
    let args = ["sweep", &path, "--time", "--step", "0.01", "--columns"];
    let csv = run_ok(
        &[
            &args[..],
            &["r2.omega,r2.alpha,C.x,C.vx,C.ax,driver.torque"],
        ]
        .concat(),
    );
    let head = "time [s],driver.angle [deg],r2.omega [rad/s],r2.alpha [rad/s^2],C.x [mm],C.vx [mm/s],C.ax [mm/s^2],driver.torque [N m],state";
    assert_eq!(csv.lines().next().unwrap(), head);
    let rows = rows(&csv);
    assert_eq!(rows.len(), 111);
    for row in &rows {
        let at = |i: usize| row[i].parse::<f64>().unwrap();
        // At the end of a step, the row shows the following step. The last row is the end and the start of the period.
        let time = if at(0) >= 1.1 { 0.0 } else { at(0) };
        // Decimals such as 0.7 differ slightly from the sum of the times.
        if [0.5, 0.7].iter().any(|joint| (time - joint).abs() < 1e-9) {
            continue;
        }
        let [angle, speed, acceleration] = crank(time);
        let [x, x1, x2] = slider(angle);
        let (v, a) = (x1 * speed, x2 * speed * speed + x1 * acceleration);
        near(at(1), angle.to_degrees(), 120.0);
        near(at(2), speed, 10.0);
        near(at(3), acceleration, 100.0);
        near(at(4), x, 400.0);
        near(at(5), v, 1e3);
        near(at(6), a, 1e4);
        // By virtual work: M w = m a v, in m.
        near(at(7), 2.0 * a * x1 * 1e-6, 10.0);
    }
}

#[test]
fn table_at_a_time_follows_the_law_and_accepts_bounds() {
    let path = scene("table.toml", INDEXED);
    let requested = ["table", &path, "--time", "0.2", "--columns", "C.vx,C.ax"];
    let found = json(&run_ok(
        &[&requested[..], &["--bounds", "--format", "json"]].concat(),
    ));
    let [angle, speed, acceleration] = crank(0.2);
    let [_, x1, x2] = slider(angle);
    let exact = x2 * speed * speed + x1 * acceleration;
    near(
        found["driver"]["angle"].as_f64().unwrap(),
        angle.to_degrees(),
        120.0,
    );
    near(found["driver"]["omega"].as_f64().unwrap(), speed, 10.0);
    let [value, bound] = ["C.ax", "C.ax.bound"].map(|key| found["figures"][key].as_f64().unwrap());
    near(value, exact, exact.abs());
    assert!(bound > 0.0 && bound < 1e-9 * exact.abs(), "{bound:e}");
}

/// Reference at 0.2 s to 50 digits: each nearest double and its remainder. The bounds cover the
/// rounding of the law, also for the driver's own values, and are no wider than a few roundings.
#[test]
fn rounding_errors_of_the_law_are_within_bounds() {
    let path = scene("bounds.toml", INDEXED);
    let found = json(&run_ok(&[
        "table", &path, "--time", "0.2", "--bounds", "--format", "json",
    ]));
    let crank = &found["vectors"][0];
    assert_eq!(crank["name"], "r2");
    for (name, near, rest) in [
        ("angle", 36.774_128_594_536_33, 2.839_057_259_884_229e-15),
        ("omega", 7.577_592_666_329_897, 3.865_263_075_025_263e-16),
        ("alpha", 30.939_775_535_579_795, 1.573_761_225_389_635_5e-15),
    ] {
        let value = crank[name].as_f64().unwrap();
        let bound = crank[format!("{name}.bound")].as_f64().unwrap();
        let miss = ((value - near) - rest).abs();
        assert!(miss <= bound, "{name}: {miss:e} above {bound:e}");
        assert!(
            bound > 0.0 && bound < 32.0 * f64::EPSILON * value,
            "{name}: {bound:e}"
        );
    }
}

#[test]
fn table_at_a_coordinate_notes_that_motion_is_ignored() {
    let path = scene("coordinate.toml", INDEXED);
    let run = krank(&["table", &path, "--at", "30"]);
    assert_eq!(run.code, 0);
    assert!(run.err.contains("--time"), "{}", run.err);
    let message = refused(2, &["table", &path, "--at", "30", "--time", "0.2"]);
    assert!(message.contains("--time"), "{message}");
}

/// A constant step of a whole turn gives the same values as a constant speed.
#[test]
fn constant_law_equals_constant_speed() {
    let motion = "motion = [{ law = \"constant\", to = 360, time = 2 }]";
    let head = INDEXED.split("motion").next().unwrap();
    let tail = INDEXED.split("]\n[links]").nth(1).unwrap();
    let law = scene("law.toml", &format!("{head}{motion}\n[links]{tail}"));
    let speed = scene(
        "speed.toml",
        &format!("{head}speed = \"180 deg/s\"\n[links]{tail}"),
    );
    let swept = |path: &str| {
        rows(&run_ok(&[
            "sweep", path, "--time", "--to", "2", "--step", "0.125",
        ]))
    };
    for (one, two) in swept(&law).iter().zip(&swept(&speed)) {
        for (one, two) in one.iter().zip(two) {
            match (one.parse::<f64>(), two.parse::<f64>()) {
                (Ok(one), Ok(two)) => near(one, two, 1e4),
                _ => assert_eq!(one, two),
            }
        }
    }
}

#[test]
fn plots_over_time_follow_the_law() {
    let path = scene("plot.toml", INDEXED);
    let requested = ["plot", &path, "--columns", "r2.omega", "--against", "time"];
    // Peak speed of the cycloid 2 h / T, and of the return pi h / (2 T).
    let text = run_ok(&requested);
    assert!(text.contains("8.377") && text.contains("-8.224"), "{text}");
}

/// The slider of 2 kg follows the crank's law. The extremes match a fine sampling, and energy in
/// equals energy out, since nothing dissipates.
#[test]
fn motor_covers_the_period_of_the_motion() {
    let path = scene("motor.toml", INDEXED);
    let found = json(&run_ok(&[
        "motor", &path, "--rated", "1", "--format", "json",
    ]));
    let figure = |keys: [&str; 2]| found[keys[0]][keys[1]].as_f64().unwrap();
    let torque = |time: f64| {
        let [angle, speed, acceleration] = crank(time);
        let [_, x1, x2] = slider(angle);
        2e-6 * (x2 * speed * speed + x1 * acceleration) * x1
    };
    let count = 220_000;
    let all = || (0..count).map(|k| torque(1.1 * (f64::from(k) + 0.5) / f64::from(count)));
    let maximum = all().fold(0.0, f64::max);
    let largest = found["torque"]["largest"]["value"].as_f64().unwrap();
    assert!(
        (largest - maximum).abs() < 1e-4 * maximum,
        "{largest} {maximum}"
    );
    let square: f64 = all().map(|torque| torque * torque).sum();
    let rms = (square / f64::from(count)).sqrt();
    assert!((figure(["torque", "rms"]) - rms).abs() < 1e-6 * rms);
    near(
        figure(["energy", "put_in"]),
        figure(["energy", "given_back"]),
        1.0,
    );
    near(found["period"].as_f64().unwrap(), 1.1, 1.0);
    let text = run_ok(&["motor", &path, "--rated", "1"]);
    assert!(
        text.contains("over one period of the motion, 1.1 s"),
        "{text}"
    );
    assert!(refused(2, &["motor", &path, "--from", "0", "--to", "9"]).contains("--from"));
    // CSV has the steps: torque, its inertia part and the cumulative work.
    let csv = run_ok(&["motor", &path, "--format", "csv"]);
    assert_eq!(
        csv.lines().next().unwrap(),
        "time [s],driver.angle [deg],driver.speed [rad/s],driver.torque [N m],driver.torque.load [N m],\
         driver.torque.gravity [N m],driver.torque.inertia [N m],driver.power [W],driver.work [J],ground.fx [N],\
         ground.fy [N],ground.moment [N m],state"
    );
    let steps = rows(&csv);
    assert_eq!(steps.len(), 361);
    let number = |row: &[String], i: usize| row[i].parse::<f64>().unwrap();
    for row in &steps[..360] {
        let exact = torque(number(row, 0));
        assert!((number(row, 3) - exact).abs() < 1e-9 * maximum, "{row:?}");
        assert!((number(row, 6) - exact).abs() < 1e-9 * maximum, "{row:?}");
    }
    // The work over a whole period is zero.
    let put_in = figure(["energy", "put_in"]);
    assert!(number(&steps[360], 8).abs() < 1e-9 * put_in);
    let still = scene(
        "still.toml",
        &INDEXED.replace(", com = [0, 0], mass = 2", ""),
    );
    refused(1, &["motor", &still]);
}

/// A rod extends from a crank by a table: with the spline p, dp/dt = p' q' and d2p/dt2 = p' q'' + p'' q'^2. The table
/// is one cubic at rest at both ends, p = 200 + 90 s^2 (3 - 2 s) mm, where s is the fraction of 120 deg.
#[test]
fn input_table_follows_the_law_of_its_driver() {
    let text = r#"
unit = "mm"
[ground]
A = [0, 0]
[driver]
link = "r2"
angle = 0
motion = [
  { law = "cycloidal", to = 120, time = 0.5 },
  { dwell = 0.2 },
  { law = "harmonic", to = 0, time = 0.4 },
]
[inputs]
rod = { over = [[0, 200], [120, 290]] }
[links]
r2 = { points = { A = [0, 0] } }
[slides]
rod = { point = "T", on = "r2", through = "A", angle = 0 }
"#;
    let scene = scene("telescope.toml", text);
    let columns = "rod.length,rod.rate,rod.accel";
    let swept = run_ok(&[
        "sweep",
        &scene,
        "--time",
        "--step",
        "0.05",
        "--columns",
        columns,
    ]);
    let mut count = 0;
    for row in rows(&swept) {
        let number = |cell: &String| cell.parse::<f64>().unwrap();
        let [angle, speed, acceleration] = crank(number(&row[0]));
        let width = 120_f64.to_radians();
        let s = angle / width;
        let (first, second) = (
            540.0 * s * (1.0 - s) / width,
            (540.0 - 1080.0 * s) / (width * width),
        );
        let expected = [
            200.0 + 90.0 * s * s * (3.0 - 2.0 * s),
            first * speed,
            first * acceleration + second * speed * speed,
        ];
        let first = row.len() - 4;
        for (cell, expected) in row[first..first + 3].iter().zip(expected) {
            let off = (number(cell) - expected).abs();
            assert!(off < 1e-9 * (1.0 + expected.abs()), "{row:?}: {expected}");
        }
        count += 1;
    }
    assert_eq!(count, 23);
}

/// The cycloid over 120 deg in 0.5 s has the higher speed, 2 h / T. The harmonic return in 0.4 s
/// has the higher acceleration, pi^2 h / (2 T^2).
#[test]
fn check_summarizes_the_motion() {
    let path = scene("told.toml", INDEXED);
    let h = 120_f64.to_radians();
    let output = run_ok(&["check", &path]);
    let line = "motion     cycloidal, harmonic, in 1.1 s, of which 0.2 s at rest; at most 8.378 rad/s and 64.60 rad/s^2";
    assert!(
        output
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
            .contains(&line.split_whitespace().collect::<Vec<_>>().join(" ")),
        "{output}"
    );
    assert!(output.contains("link r2, opens at 0 deg\n"), "{output}");
    let facts = json(&run_ok(&["check", &path, "--format", "json"]));
    let motion = &facts["motion"];
    near(motion["speed"].as_f64().unwrap(), 2.0 * h / 0.5, 1.0);
    near(
        motion["acceleration"].as_f64().unwrap(),
        PI * PI * h / (2.0 * 0.16),
        1.0,
    );
    assert_eq!(
        (motion["steps"][1]["law"].as_str(), motion["rest"].as_f64()),
        (Some("dwell"), Some(0.2))
    );
    assert!(motion["jump"].is_null());
}
