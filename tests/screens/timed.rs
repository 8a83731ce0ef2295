//! Tests a scene with a motion law over time: playback, steps and plots.

use crate::screen::{Session, krank, open};
use krank::drawing::Glyphs;
use krank::tui::Origin;

/// A slider-crank of 100 and 300 mm that turns by 120 deg in 0.5 s, dwells for 0.2 s, and returns
/// in 0.4 s.
const INDEXED: &str = r#"
name = "Indexed press"
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

fn indexed(cols: u16, rows: u16) -> Session {
    Session::new(open(INDEXED, Origin::Stdin), Glyphs::Ascii, cols, rows)
}

fn scene(keys: &str, seconds: f64, cols: u16, rows: u16) -> Session {
    let mut session = indexed(cols, rows);
    session.press(keys);
    if seconds > 0.0 {
        session.pass(seconds);
    }
    session
}

/// Playback takes 4 s for the period of 1.1 s. After a quarter of its time, the cycloid is at 120
/// (1/4 - 1/(2 pi)) deg; after its end, the driver dwells.
#[test]
fn playback_follows_motion_law_and_dwells() {
    let line = |seconds| scene("space", seconds, 80, 24).last_line();
    assert!(line(0.125 * 4.0 / 1.1).contains("   10.90 deg  t 0.125 s  ok"));
    for seconds in [0.5, 0.6, 0.699] {
        let rests = line(seconds * 4.0 / 1.1);
        assert!(rests.contains("  120.00 deg  t 0."), "{rests}");
    }
    // The driver returns, and then the period repeats.
    assert!(line(0.9 * 4.0 / 1.1).contains("   60.00 deg  t 0.900 s  ok"));
    assert!(line(1.225 * 4.0 / 1.1).contains("   10.90 deg  t 0.125 s  ok"));
    // Reversed playback runs backwards from the beginning of the period.
    let back = scene("r space", 0.2 * 4.0 / 1.1, 80, 24).last_line();
    assert!(back.contains("   60.00 deg  t 0.900 s  ok"), "{back}");
    let heading = scene("", 0.0, 160, 40).painted_text();
    assert!(
        heading.contains("the motion in 4 s   1/3.6 of real time"),
        "{heading}"
    );
}

/// Rates, forces and working equal those of the command line at the same time.
#[test]
fn rates_and_forces_follow_motion_law_at_that_time() {
    let mut session = scene("space", 0.275 * 4.0 / 1.1, 80, 24);
    let tables = session.press("space 2").painted_text();
    // 120 deg in 0.5 s: (120 deg / 0.5 s) (1 - cos 198 deg) and 2 pi (120 deg / 0.25 s^2) sin 198 deg.
    assert!(
        tables.contains("t 0.275 s") && tables.contains("8.17257") && tables.contains("-16.2660"),
        "{tables}"
    );
    let forces = session.press("5").painted_text();
    let file = crate::screen::folder("timed").join("indexed.toml");
    std::fs::write(&file, INDEXED).unwrap();
    let args = [
        "table",
        file.to_str().unwrap(),
        "--time",
        "0.275",
        "--columns",
        "driver.torque",
    ];
    let (output, _) = krank(&args);
    let torque = output.split_whitespace().next_back();
    assert!(
        torque.is_some_and(|torque| forces.contains(&torque[..7])),
        "{output}{forces}"
    );
    let working = session.press("7").painted_text();
    assert!(
        working.contains("with 8.17257 rad/s\n and -16.2660 rad/s^2"),
        "{working}"
    );
}

/// A step changes the coordinate and moves the time to the next moment with that coordinate. At
/// coordinates that the motion never reaches, the driver has a plain speed.
#[test]
fn steps_follow_the_timed_motion() {
    let mut session = indexed(80, 24);
    assert!(
        session
            .press(". .")
            .last_line()
            .contains("   10.00 deg  t 0.121 s  ok")
    );
    session.press("space").pass(0.6 * 4.0 / 1.1);
    let back = session.press("space ,").last_line();
    assert!(back.contains("t 0.8") || back.contains("t 0.7"), "{back}");
    let beyond = session.press("g 1 5 0 Enter").last_line();
    assert!(beyond.contains("  150.00 deg  at 1 rad/s  ok"), "{beyond}");
    let starts = session.press("Home").last_line();
    assert!(starts.contains("    0.00 deg  t 0.000 s  ok"), "{starts}");
    // The lengths view has no time: it evaluates at a coordinate.
    assert!(session.press("e").last_line().contains("at 1 rad/s"));
}

/// The default x axis is time, and the coordinate is selectable; the cursor lies on the curve with
/// either.
#[test]
fn plots_use_time_as_default_x_axis() {
    let mut session = scene("3 space", 0.25 * 4.0 / 1.1, 80, 24);
    let plot = session.press("space").painted_text();
    assert!(
        plot.contains("over time 0.2500 s") && plot.contains("r4.rate -851.82"),
        "{plot}"
    );
    let plot = session.press("X X X").painted_text();
    assert!(
        plot.contains("over driver.angle  60.00 deg") && plot.contains("r4.rate -101."),
        "{plot}"
    );
    assert!(plot.contains("at 1 rad/s") || session.press("Esc").last_line().contains("at 1 rad/s"));
    let motor = session.press("8").painted_text();
    assert!(motor.contains("over time 0.2500 s"), "{motor}");
}

#[test]
fn timed_motion_fits_small_screens() {
    let mut session = scene("space", 0.275 * 4.0 / 1.1, 40, 12);
    insta::assert_snapshot!("timed-40x12", session.painted_text());
    insta::assert_snapshot!("timed-plot-40x12", session.press("3").painted_text());
}
