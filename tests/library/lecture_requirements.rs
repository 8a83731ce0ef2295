//! Tests a lecturer's requirements on the working and reports: no value before it is found, given
//! values stay as given, and every letter has one meaning.

use krank::page::TextStyle;
use krank::report::{PositionMethod, Report, Working, WorkingNotation};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Solver, Workspace};

const WIDE: TextStyle = TextStyle {
    ascii: true,
    width: 400,
};

/// Solves a preset at a coordinate, by default where it opens.
fn solved(name: &str, at: Option<f64>) -> (Scene, Solver, Workspace) {
    let scene = Scene::parse(presets::find(name).unwrap().text, name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let mut state = solver.state();
    let at = at.unwrap_or(scene.mechanism.driver().start);
    let _ = solver.solve(at, Order::Force, &mut state);
    (scene, solver, state)
}

fn working(name: &str, at: Option<f64>) -> String {
    let (scene, solver, state) = solved(name, at);
    let working = Working::new(&scene, &solver);
    working.of(&scene, &solver, &state, 6).page.to_text(WIDE)
}

fn report(name: &str, at: Option<f64>) -> String {
    let (scene, solver, state) = solved(name, at);
    let notation = WorkingNotation::Lecture;
    let report = Report::in_notation(&scene, &solver, &state, 6, notation);
    report.page.to_text(WIDE)
}

/// Returns the text between two markers.
fn between<'t>(text: &'t str, from: &str, to: &str) -> &'t str {
    let rest = text.split_once(from).map_or("", |(_, rest)| rest);
    rest.split_once(to).map_or(rest, |(part, _)| part)
}

/// Returns the cells of the first line that begins with a name.
fn row<'t>(text: &'t str, name: &str) -> Vec<&'t str> {
    let line = text.lines().find(|line| line.trim().starts_with(name));
    let line = line.unwrap_or_else(|| panic!("no {name} in\n{text}"));
    let cells = line.trim().trim_start_matches(name).split("  ");
    cells
        .map(str::trim)
        .filter(|cell| !cell.is_empty())
        .collect()
}

#[test]
fn report_shows_driver_rates_without_other_rates() {
    let dead_point = solved("double-rocker", None).1.motion().range.ends().0;
    let beyond = dead_point - 10.0;
    for (name, at, head, condition, given) in [
        (
            "double-rocker",
            dead_point,
            "omega [rad/s]",
            Condition::DeadPoint,
            "0.523599",
        ),
        (
            "double-rocker",
            beyond,
            "omega [rad/s]",
            Condition::NoAssembly,
            "0.523599",
        ),
        (
            "excavator-boom",
            99.0,
            "dr/dt [m/s]",
            Condition::NoAssembly,
            "0.15",
        ),
    ] {
        assert_eq!(solved(name, Some(at)).2.condition(), condition, "{name}");
        let report = report(name, Some(at));
        let requested = between(&report, "Velocities\n", "Accelerations\n");
        let cells = row(requested, head);
        assert!(cells.contains(&given), "{name}: {cells:?}\n{requested}");
    }
}

#[test]
fn loop_tables_ask_only_for_their_own_unknowns() {
    let report = report("press-ram", None);
    let requested = between(&report, "Position table\n", "Loop equations\n");
    let second = between(requested, "loop 2", "Vectors between");
    assert_eq!(requested.matches("= ?").count(), 4, "{requested}");
    assert_eq!(second.matches("= ?").count(), 2, "{second}");
    assert!(second.contains("from loop 1"), "{second}");
    let rates = between(&report, "Velocities\n", "The time derivative");
    assert_eq!(rates.matches("= ?").count(), 4, "{rates}");
}

#[test]
fn angles_have_no_value_before_their_group() {
    for text in [working("press-ram", None), report("press-ram", None)] {
        let table = between(&text, "from the coordinates", "Loop equations\n");
        let line = table.lines().find(|line| line.contains("theta_r4e ="));
        let line = line.unwrap_or_else(|| panic!("{table}"));
        assert!(line.contains("theta4 +") && !line.contains("deg"), "{line}");
        let found = between(&text, "Positions, group by group", "Velocities\n");
        let place = |what: &str| {
            found
                .find(what)
                .unwrap_or_else(|| panic!("{what}: {found}"))
        };
        assert!(place("theta4 =") < place("theta_r4e ="));
        let line = &found[place("theta_r4e =")..];
        assert!(line.lines().next().unwrap().ends_with("deg"), "{line}");
    }
}

#[test]
fn unit_vectors_are_defined_once() {
    let text = working("four-bar", None);
    assert_eq!(text.matches("u(theta) = cos(theta) i").count(), 1, "{text}");
    assert!(
        text.find("u(theta) =") < text.find("Multiplied by"),
        "{text}"
    );
    let text = report("four-bar", None);
    assert_eq!(
        text.matches("mu(theta) = cos(theta) i").count(),
        1,
        "{text}"
    );
}

#[test]
fn coefficients_of_the_quadratic_have_units() {
    let text = working("slider-crank", None);
    let unit = |start: &str, unit: &str| {
        let line = text.lines().find(|line| line.trim().starts_with(start));
        let line = line.unwrap_or_else(|| panic!("{text}"));
        assert!(line.ends_with(unit), "{line}");
    };
    unit("p = ", " cm");
    unit("q = ", " cm^2");
}

#[test]
fn letters_are_not_reused_for_other_vectors() {
    let text = working("jansen-leg", None);
    assert!(text.contains("sx = "), "{text}");
    // m is the crank.
    assert!(
        !text.contains("mx = ") && !text.contains("m = sqrt"),
        "{text}"
    );
    assert!(text.contains("2·s") || text.contains("2 s"), "{text}");
    let text = working("four-bar", None);
    assert!(text.contains("m = sqrt(mx^2 + my^2)"), "{text}");
}

#[test]
fn coupled_group_lists_all_its_angles() {
    let text = working("stephenson-six-bar", None);
    let group = between(&text, "Group 2, coupled", "Velocities\n");
    for angle in ["theta3 = atan2(y", "theta5 = atan2(y", "theta6 = atan2(y"] {
        assert!(group.contains(angle), "{angle}: {group}");
    }
    for head in ["xB [mm]", "theta4 [rad]", "f1 [mm^2]"] {
        assert!(group.contains(head), "{head}: {group}");
    }
}

fn by(method: PositionMethod, name: &str, at: Option<f64>) -> String {
    let (scene, solver, state) = solved(name, at);
    let working = Working::new(&scene, &solver);
    let notation = WorkingNotation::Krank;
    let driver_state = (&scene, &solver, &*state);
    let computed = working.by(method, driver_state, &[], 6, notation).unwrap();
    computed.page.to_text(WIDE)
}

#[test]
fn bisection_states_its_interval_and_stopping_rule() {
    let text = by(PositionMethod::Bisection, "four-bar", None);
    for piece in [
        "f has its minimum where the arm lies along m, at theta3 = -13.8979 deg",
        "Halved until the interval is at most 0.00018 deg",
        "theta4 = atan2(my - r3 sin(theta3), mx - r3 cos(theta3)) = 290.753 deg",
    ] {
        assert!(text.contains(piece), "{piece}: {text}");
    }
    let text = by(PositionMethod::Bisection, "slider-crank", None);
    assert!(text.contains("f has its minimum at r4 = "), "{text}");
}

#[test]
fn bisection_skips_halving_if_an_end_is_the_root() {
    let dead_point = solved("double-rocker", None).1.motion().range.ends().0;
    for (name, at) in [("double-rocker", dead_point), ("parallelogram", 0.0)] {
        let text = by(PositionMethod::Bisection, name, Some(at));
        assert!(
            text.contains("is the root itself; f only touches 0"),
            "{name}: {text}"
        );
        assert!(!text.contains("Halved until"), "{name}: {text}");
    }
}

#[test]
fn tangent_circles_meet_in_one_point() {
    let dead_point = solved("double-rocker", None).1.motion().range.ends().0;
    let text = by(PositionMethod::Graphical, "double-rocker", Some(dead_point));
    assert!(
        text.contains("They touch in C; the drawing cannot show exactly where"),
        "{text}"
    );
    assert!(
        !text.contains("two points") && !text.contains("C'"),
        "{text}"
    );
    let text = working("double-rocker", Some(dead_point));
    assert!(text.contains("C lies on the line B -> D"), "{text}");
    assert!(!text.contains("to the left of B"), "{text}");
}

#[test]
fn captions_match_their_pictures() {
    let (scene, solver, state) = solved("press-ram", None);
    let report = Report::new(&scene, &solver, &state, 6);
    let (text, html) = (report.page.to_text(WIDE), report.page.to_html());
    assert!(!text.contains("vectors with unknowns"), "{text}");
    assert!(
        text.contains("r6 < 0: its arrow points against theta6."),
        "{text}"
    );
    assert!(html.contains("vectors with unknowns are dashed"));
    assert!(html.contains("r6 &lt; 0: its arrow points against"));
}
