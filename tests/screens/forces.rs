//! Tests the forces view.

use crate::claims::{assert_shown, collapse_blanks};
use crate::screen::{Session, open, preset, text};
use krank::drawing::Glyphs;
use krank::report::Forces;
use krank::solver::Order;
use krank::tui::{Colours, Origin, Workbench};

fn session(name: &str, cols: u16, rows: u16) -> Session {
    Session::new(preset(name), Glyphs::Ascii, cols, rows)
}

/// Opens the forces view of a preset with additional text in its file.
fn with(name: &str, more: &str, cols: u16, rows: u16) -> Session {
    let text = format!("{}\n{more}", text(name));
    let mut session = Session::new(open(&text, Origin::Stdin), Glyphs::Ascii, cols, rows);
    session.press("5");
    session
}

const PULL: &str = "[[loads]]\npoint = \"C\"\nforce = [0, -10]\n";

/// Masks the residuals of checks and the bounds, which depend only on rounding.
fn masked(screen: &str) -> String {
    let line = |line: &str| match line.split_once("+-") {
        Some((before, _)) => format!("{before}+-(bound)\n"),
        None if line.starts_with(" off by") => " off by  (rounding)\n".to_owned(),
        None => format!("{line}\n"),
    };
    screen.lines().map(line).collect()
}

#[test]
fn forces_are_listed_in_blocks_of_equal_width() {
    let mut large = Session::new(preset("press-ram"), Glyphs::Braille, 120, 40);
    let screen = large.press("5 O").painted_text();
    insta::assert_snapshot!("forces-press-ram-braille-120x40", masked(&screen));
    let mut small = session("press-ram", 40, 12);
    let screen = small.press("5").painted_text();
    insta::assert_snapshot!("forces-press-ram-ascii-40x12", masked(&screen));
    let screen = small.press("PgDn PgDn PgDn PgDn PgDn PgDn").painted_text();
    let lines = [
        "r6 0.000",
        "check torque fx",
        "N m N",
        "off by",
        "check fy moment",
        "N N m",
        "off by",
        "forces press-ram 60.00 deg ok ? help",
    ];
    assert_shown(&screen, &lines);
}

/// A sliding driver has a force in its own unit and column width.
#[test]
fn sliding_driver_has_force_instead_of_torque() {
    let screen = session("excavator-boom", 80, 24).press("5").painted_text();
    let lines = [
        "driver force loads gravity inertia power",
        "N N N N W",
        "rod 220072 152736 67983 -647 33010.8",
        "force on fx fy f dir f moment",
        "N N N deg N m",
        "barrel at O by ground 172759 138178 221221 38.654",
        "boom at Q by ground -172958 -101841 200713 210.490",
        "boom at P 172763 136326 220072 38.277",
        "ground by all 198 -36337 36338 270.313 -143373",
        "guide normal at moment",
        "N m N m",
        "rod on P -580",
        "check force fx fy moment",
        "off by",
        "forces excavator-boom 2.0000 m ok force",
    ];
    assert_shown(&screen, &lines);
}

#[test]
fn manual_screen_of_forces_matches_program() {
    let views = include_str!("../../src/manual/english/views.md");
    let mut workbench = Workbench::new(
        preset("four-bar-load"),
        Glyphs::Ascii,
        Colours::None,
        80,
        17,
    );
    workbench.press("5");
    let screen = workbench.text();
    let block = format!("```txt\n{}\n```", screen.trim_end());
    assert!(
        masked(views).contains(&masked(&block)),
        "the manual should show\n{screen}"
    );
}

#[test]
fn scrolling_shows_every_force_untruncated_at_every_size() {
    for (cols, rows) in [(40, 12), (57, 20), (80, 24), (120, 40), (200, 60)] {
        let mut session = session("press-ram", cols, rows);
        let mut all = session.press("5").body();
        for _ in 0..40 {
            all += &session.press("Down").body();
        }
        for what in [
            "r2 at B", "r5 at F", "ground", "r6", "off by", "dir f", "moment", "power",
        ] {
            assert!(all.contains(what), "{what} at {cols} x {rows}: {all}");
        }
        for line in all.lines() {
            assert!(!line.contains(".. "), "{line}");
        }
    }
}

/// Returns the numbers in the row that begins with this name.
fn row(screen: &str, name: &str) -> Vec<f64> {
    let line = screen.lines().find(|line| line.starts_with(name));
    let line = line.unwrap_or_else(|| panic!("no {name}: {screen}"));
    let cells = line[name.len()..].split_whitespace();
    cells.filter_map(|cell| cell.parse().ok()).collect()
}

/// The driver is listed once; held inputs have forces of their own.
#[test]
fn every_input_has_its_effort() {
    let opened = preset("excavator");
    let mut state = opened.solver.state();
    let at = opened.scene.mechanism.driver().start;
    let _ = opened.solver.solve(at, Order::Force, &mut state);
    let forces = Forces::new(&opened.scene, &opened.solver, &state, None).unwrap();
    let screen = session("excavator", 120, 40).press("5 O").painted_text();
    for (name, _, effort) in &forces.drive.own {
        let shown = row(&screen, &format!(" {name} "))[0];
        let value = effort.value.unwrap();
        assert!(
            (shown - value).abs() <= 1e-3 * value.abs(),
            "{name}: {shown}, {value}"
        );
    }
    assert_eq!(forces.drive.own.len(), 3);
    let driver = screen.split("force on").next().unwrap();
    assert_eq!(driver.matches("boom-rod").count(), 1, "{screen}");
}

#[test]
fn values_equal_solved_state() {
    let opened = preset("press-ram");
    let mut state = opened.solver.state();
    let _ = opened.solver.solve(20.0, Order::Force, &mut state);
    let forces = Forces::new(&opened.scene, &opened.solver, &state, None).unwrap();
    let mut session = session("press-ram", 120, 40);
    session.press("5 O g").type_in("20").press("Enter");
    let screen = session.painted_text();
    let near = |shown: f64, value: Option<f64>| {
        let value = value.unwrap();
        assert!(
            (shown - value).abs() <= 1e-3 * value.abs().max(0.1),
            "{shown} for {value}"
        );
    };
    let drive = row(&screen, " r2 ");
    near(drive[0], forces.drive.total.value);
    for (shown, part) in drive[1..4].iter().zip(forces.drive.parts) {
        near(*shown, part.value);
    }
    near(drive[4], forces.drive.power.value);
    let joint = forces
        .joints
        .iter()
        .find(|j| (j.link.as_str(), j.point.as_str()) == ("r5", "F"));
    let joint = joint.unwrap();
    let plane = joint.force.unwrap();
    let shown = row(&screen, " r5 at F by ram");
    near(shown[0], Some(plane.components.x));
    near(shown[1], Some(plane.components.y));
    near(shown[2], Some(plane.magnitude));
    near(shown[3], plane.direction);
    let ground = row(&screen, " ground by all");
    near(ground[4], forces.frame.moment.value);
    near(row(&screen, " r6 on ram")[0], forces.guides[0].normal.value);
}

#[test]
fn forces_are_copied_to_clipboard() {
    let mut session = session("press-ram", 80, 24);
    let line = session.press("5 y").last_line();
    assert!(
        line.contains("sent to the terminal's clipboard: "),
        "{line}"
    );
    assert!(session.workbench.take_sent().len() > 1000);
    let line = Session::new(preset("four-bar"), Glyphs::Ascii, 80, 24)
        .press("5 y")
        .last_line();
    assert!(line.contains("nothing to copy here"), "{line}");
}

/// The last digits of a column stay aligned at every driver coordinate.
#[test]
fn columns_stay_aligned_as_driver_moves() {
    let ends = |screen: &str| -> Vec<Vec<usize>> {
        let rows = screen
            .lines()
            .filter(|line| line.starts_with(" r") && line.contains(" at "));
        rows.map(|line| {
            let line = format!("{line} ").into_bytes();
            let ends = line.windows(2).enumerate();
            let ends = ends.filter(|(_, pair)| pair[0].is_ascii_digit() && pair[1] == b' ');
            ends.map(|(at, _)| at).filter(|at| *at > 24).collect()
        })
        .collect()
    };
    let mut session = session("press-ram", 80, 24);
    let first = ends(&session.press("5").painted_text());
    assert_eq!(first.len(), 6);
    for _ in 0..24 {
        let screen = session.press(". . .").painted_text();
        assert_eq!(ends(&screen), first, "{screen}");
    }
}

#[test]
fn scene_without_loads_explains_how_to_add_them() {
    const MEND: &str = " Give a link its mass and com, or add [[loads]] or [[springs]] to the file. \
                        This view then shows the driver's torque or force and the force at every joint.";
    let shown = session("four-bar", 80, 24).press("5").body();
    let nothing = "No forces act on this linkage: the scene has no loads, springs or masses.";
    assert_eq!(collapse_blanks(&shown), nothing.to_owned() + MEND);
    let text = format!("gravity = [0, -9.81]\n{}", text("four-bar"));
    let mut session = Session::new(open(&text, Origin::Stdin), Glyphs::Ascii, 40, 12);
    let nothing = "No forces act on this linkage: the scene has gravity, but no link has a mass.";
    // The next key clears the message in the last line.
    assert_eq!(
        collapse_blanks(&session.press("5 [").body()),
        nothing.to_owned() + MEND
    );
}

#[test]
fn dead_point_shows_no_force_values() {
    let mut session = session("excavator-boom", 80, 24);
    // More steps than the motion has.
    let shown = session.press("5 ] ] ] ] ] . . . . . . . .").body();
    let none = "No force of the driver exists here: at a dead point the driver cannot move the mechanism, and \
                the forces grow without bound.";
    assert_eq!(collapse_blanks(&shown), none);
    let line = " forces  3.0382305285 m  dead point: no rates  the motion ends here";
    assert_eq!(session.last_line(), line);
    let screen = session.press("[ ,").painted_text();
    assert!(screen.contains("off by"), "{screen}");
}

#[test]
fn change_point_shows_only_driver_torque() {
    let mut session = with("parallelogram", PULL, 80, 24);
    let shown = session.press("g").type_in("0").press("Enter").body();
    let all = "driver torque loads gravity inertia power N m N m N m N m W \
               r2 1.000000 1.000000 0.000000 0.000000 1.000000 \
               Of the forces only the driver's torque has a value here: at a change point, the links can \
               carry internal forces of any size.";
    assert_eq!(collapse_blanks(&shown), all);
    let line = session.last_line();
    assert!(
        line.starts_with(" forces  stdin    0.00 deg  change point  "),
        "{line}"
    );
}

#[test]
fn indeterminate_reactions_are_named() {
    let mut session = with("triple-parallelogram", PULL, 80, 24);
    insta::assert_snapshot!(
        "forces-indeterminate-ascii-80x24",
        masked(&session.painted_text())
    );
    let below = session.press("PgDn").painted_text();
    for text in ["Indeterminate: r2.A", "Of least norm: "] {
        assert!(below.contains(text), "{below}");
    }
}

#[test]
fn forces_follow_driver_and_scene() {
    let mut session = session("four-bar-load", 80, 24);
    let before = row(&session.press("5").painted_text(), " r2 ");
    let other = row(&session.press(".").painted_text(), " r2 ");
    assert_ne!(before, other);
    // The next scene is the engine; the one after it has no loads.
    let screen = session.press("n").painted_text();
    assert!(
        screen.contains("r3 at C by piston") && !screen.contains("piston at C"),
        "{screen}"
    );
    let screen = session.press("n").painted_text();
    assert!(screen.contains("No forces act on this linkage"), "{screen}");
}

/// While its layer is on, the drawing shows the magnitudes of the forces view. A scene without
/// loads reports that.
#[test]
fn drawing_shows_loads_and_forces_with_their_magnitudes() {
    let mut session = session("four-bar-load", 120, 40);
    let plain = session.painted_text();
    assert!(!plain.contains(" N "), "{plain}");
    let screen = session.press("N").painted_text();
    for output in ["500 N", "6.45 N m", "F 200 N = ", "loads and forces on"] {
        assert!(screen.contains(output), "{output}\n{screen}");
    }
    let figures = session.press("5 O").painted_text();
    let numbers = figures
        .split_whitespace()
        .filter_map(|word| word.parse().ok());
    let numbers: Vec<f64> = numbers.collect();
    for size in [127.0, 139.0, 141.0, 455.0] {
        let is_shown = numbers.iter().any(|number| (number - size).abs() <= 0.5);
        assert!(is_shown, "{size}\n{figures}");
        assert!(screen.contains(&format!("{size} N")), "{size}\n{screen}");
    }
    // The layer follows the driver in every view.
    assert_ne!(session.press("O 1 .").painted_text(), screen);
    let off = session.press("N").painted_text();
    assert!(!off.contains("500 N"), "{off}");
    let mut nothing = Session::new(preset("four-bar"), Glyphs::Ascii, 120, 40);
    let screen = nothing.press("N").painted_text();
    assert_shown(&screen, &["no forces here: no loads, springs or masses"]);
    assert!(!screen.contains("stands still"), "{screen}");
}
