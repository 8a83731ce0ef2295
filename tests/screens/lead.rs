//! Tests a scene whose inputs follow a leading point: playback, steps, times and views.

use crate::screen::{Session, folder, krank, open, preset, text};
use krank::drawing::Glyphs;
use krank::tui::Origin;

fn plotter(cols: u16, rows: u16) -> Session {
    Session::new(preset("plotter"), Glyphs::Ascii, cols, rows)
}

/// Opens the five-bar with a path for its point P.
fn five_bar(path: &str, cols: u16, rows: u16) -> Session {
    let text = format!("{}\n[lead]\nP = {path}\n", text("five-bar"));
    Session::new(open(&text, Origin::Stdin), Glyphs::Ascii, cols, rows)
}

/// A path of 1 s straight up to the edge of the workspace and beyond it: P is led from 173 to 260,
/// and both arms are straight at sqrt(240^2 - 60^2) = 232.379.
const BEYOND: &str = "{ over = [[0, 0, 173], [1, 0, 260]] }";

/// Returns the values that `krank table plotter` prints at a time.
fn table(time: &str, columns: &str) -> Vec<String> {
    let args = ["table", "plotter", "--time", time, "--columns", columns];
    let (output, code) = krank(&[&args[..], &["--digits", "12"]].concat());
    assert_eq!(code, Some(0), "{output}");
    let rows = output.lines().filter(|line| line.contains('['));
    let values = rows.filter_map(|line| line.split_whitespace().last());
    let values = values.map(|value| match value.parse::<f64>().unwrap() {
        // The format of the forces view.
        torque if torque.abs() < 2e-3 => format!("{torque:.6e}"),
        _ => value[..6].to_owned(),
    });
    values.collect()
}

#[track_caller]
fn assert_all(screen: &str, values: &[String]) {
    assert!(!values.is_empty());
    for value in values {
        assert!(screen.contains(value.as_str()), "no {value} in\n{screen}");
    }
}

/// The circle of 4 s is played in 4 s, and then repeats.
#[test]
fn playback_moves_the_point_along_its_path() {
    let mut session = plotter(100, 30);
    let line = session.last_line();
    assert!(line.contains("t 0.000 s  r2 126.00 deg"), "{line}");
    let line = session.press("space").pass(1.0).last_line();
    assert!(
        line.contains("t 1.000 s  r2 105.77 deg  r5 51.93 deg  ok"),
        "{line}"
    );
    let line = session.pass(4.5).last_line();
    assert!(line.contains("t 1.500 s"), "{line}");
    let line = session.press("space r space").pass(0.5).last_line();
    assert!(line.contains("t 1.000 s  r2 105.77 deg"), "{line}");
    let heading = plotter(160, 40).painted_text();
    assert!(heading.contains("step 0.02 s"), "{heading}");
}

/// Tables, forces and CSV agree with those of the command line at that time.
#[test]
fn values_are_those_of_the_command_line() {
    let mut session = plotter(120, 50);
    session.press("g 1 . 2 5 Enter");
    let columns = "P.vx,P.vy,P.ax,P.ay,r5.omega,r5.alpha,r3.omega";
    let tables = session.press("2").painted_text();
    assert_all(&tables, &table("1.25", columns));
    let forces = session.press("5").painted_text();
    assert_all(&forces, &table("1.25", "r2.torque,r5.torque,r2.B.fx"));
}

#[test]
fn steps_move_the_time() {
    let mut session = plotter(100, 30);
    let line = session.press(". . .").last_line();
    assert!(line.contains("t 0.060 s"), "{line}");
    // A closed motion continues before its begin.
    let line = session.press(", , , ,").last_line();
    assert!(line.contains("t 3.980 s"), "{line}");
    let line = session.press("Home").last_line();
    assert!(line.contains("t 0.000 s"), "{line}");
}

#[test]
fn times_are_typed() {
    let mut session = plotter(100, 30);
    let prompt = session.press("g").last_line();
    assert!(prompt.contains("time [s]:"), "{prompt}");
    let line = session.press("2 . 5 Enter").last_line();
    assert!(line.contains("t 2.500 s"), "{line}");
    // Of a closed motion, a time in its period.
    let line = session.press("g 5 Enter").last_line();
    assert!(line.contains("t 1.000 s"), "{line}");
    let line = session.press("g x Enter").last_line();
    assert!(line.contains("not a number in s: x"), "{line}");
}

/// An input taken by hand moves from where the scene opens, until a time is given or played.
#[test]
fn inputs_are_taken_by_hand_until_a_time_is_given() {
    let mut session = plotter(100, 30);
    session.press("g 1 Enter");
    let line = session.press("U").last_line();
    assert!(line.contains("the step keys move the driver, r2"), "{line}");
    let line = session.press(". .").last_line();
    assert!(line.contains("130.00 deg  ok"), "{line}");
    let line = session.press("U .").last_line();
    assert!(line.contains("r5 65 deg"), "{line}");
    let line = session.press("U").last_line();
    assert!(line.contains("the step keys move the time"), "{line}");
    let line = session.press(".").last_line();
    assert!(line.contains("t 0.020 s"), "{line}");
    let line = session.press("g r 2 space 9 0 Enter").last_line();
    assert!(line.contains(" 90.00 deg"), "{line}");
    let line = session.press(".").last_line();
    assert!(line.contains(" 95.00 deg"), "{line}");
    let line = session.press("g 1 Enter").last_line();
    assert!(line.contains("t 1.000 s"), "{line}");
    session.press("g r 2 space 9 0 Enter");
    let line = session.press("space").pass(0.5).last_line();
    assert!(line.contains("t 1.500 s"), "{line}");
}

/// An edit keeps the time, and the point leads on.
#[test]
fn edits_keep_the_time() {
    let mut session = plotter(100, 30);
    session.press("g 1 Enter : s e t");
    session.press("Esc");
    let line = session.press("6 + Esc u").last_line();
    assert!(line.contains("t 1.000 s"), "{line}");
}

/// The motion ends at the edge of the workspace; the workbench says so and stays usable.
#[test]
fn path_beyond_the_workspace_ends_at_its_edge() {
    let mut session = five_bar(BEYOND, 100, 30);
    let opened = session.painted_text();
    let until = "the inputs follow it only up to 0.624 s, at [0, 232.3";
    assert!(opened.contains(until), "{opened}");
    let line = session.press("g 0 . 8 Enter").painted_text();
    let out = "the inputs cannot follow the point up to 0.8 s";
    assert!(line.contains(out), "{line}");
    session.press("Esc");
    // Playback reverses at the end, as at any limit.
    let line = session.press("space").pass(5.0).last_line();
    assert!(line.contains("t 0.4"), "{line}");
    let screen = session.press("space g 0 . 6 2 4 Enter .").painted_text();
    assert!(screen.contains(until), "{screen}");
    let cycle = session.press("Esc").painted_text();
    assert!(cycle.contains("limit 0.624"), "{cycle}");
}

/// At the edge of the workspace, the status line names the inputs as `krank sweep` does.
#[test]
fn edge_of_the_workspace_is_named() {
    let edge = "{ over = [[0, 0, 173], [1, 0, 232.3790007724450]] }";
    let mut session = five_bar(edge, 120, 30);
    let screen = session.press("g 1 Enter").painted_text();
    let named = "at 1.000 s: edge of the workspace, where the point does not follow r2, r5";
    assert!(screen.contains(named), "{screen}");
    let line = session.press("Esc").last_line();
    assert!(line.contains("dead point: no rates"), "{line}");
    let tables = session.press("2").painted_text();
    assert!(tables.contains("232.379"), "{tables}");
}

#[test]
fn path_out_of_reach_leaves_the_driver() {
    let mut session = five_bar("{ over = [[0, 0, 300], [1, 0, 310]] }", 100, 30);
    let screen = session.painted_text();
    assert!(
        screen.contains("the inputs cannot reach its first position"),
        "{screen}"
    );
    let line = session.press(".").last_line();
    assert!(line.contains("125.00 deg"), "{line}");
}

/// A point of the driven link moves with one input only.
#[test]
fn point_that_the_inputs_do_not_move_independently_is_named() {
    let text =
        text("five-bar").to_owned() + "\n[lead]\nB = { over = [[0, -100, 90], [1, -90, 95]] }\n";
    let mut session = Session::new(open(&text, Origin::Stdin), Glyphs::Ascii, 100, 30);
    let screen = session.painted_text();
    let why = "the inputs do not move it independently where the scene opens";
    assert!(screen.contains(why), "{screen}");
    let file = folder("lead").join("dependent.toml");
    std::fs::write(&file, text).unwrap();
    let (check, _) = krank(&["check", file.to_str().unwrap()]);
    assert!(check.contains(why), "{check}");
}

/// Views of the driver's motion say that they do not show the leading point, and show the driver
/// once it is taken by hand.
#[test]
fn views_of_the_driver_say_so() {
    for view in ["3", "4", "7", "8", "e"] {
        let mut session = plotter(100, 30);
        let screen = session.press(view).painted_text();
        assert!(
            screen.contains("not of the leading point"),
            "{view}:\n{screen}"
        );
        let screen = session.press("U").painted_text();
        let screen = screen.lines().take(28).collect::<Vec<_>>().join("\n");
        assert!(
            !screen.contains("not of the leading point"),
            "{view}:\n{screen}"
        );
    }
}

#[test]
fn led_drawing_shows_path_and_time() {
    insta::assert_snapshot!(
        "lead-ascii-80x24",
        plotter(80, 24).press("g 1 Enter").painted_text()
    );
    insta::assert_snapshot!(
        "lead-ascii-40x12",
        plotter(40, 12).press("g 1 Enter").painted_text()
    );
    let mut session = five_bar(BEYOND, 80, 24);
    insta::assert_snapshot!(
        "lead-beyond-ascii-80x24",
        session.press("Esc").painted_text()
    );
}

/// The same values are written as one row by the workbench.
#[test]
fn row_is_written_at_the_time() {
    let mut session = plotter(100, 30);
    let file = folder("lead-row").join("row.csv");
    let _ = std::fs::remove_file(&file);
    session
        .press("g 1 Enter Y Ctrl-U")
        .type_in(file.to_str().unwrap())
        .press("Enter");
    let rows = std::fs::read_to_string(&file).unwrap();
    assert!(rows.starts_with("time [s],driver.angle [deg]"), "{rows}");
    assert!(rows.contains("\n1,105.769510603595"), "{rows}");
}
