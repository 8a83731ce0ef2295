//! Tests how every front end treats forces that do not balance. The present solver never produces
//! any, so the tests repeat the pass of the last group, as a fault in the order of passes would.

use crate::cli;
use crate::quantity::{Catalogue, Quantity, Share, Subject};
use crate::scene::{Scene, presets};
use crate::solver::testing::falsified;
use crate::solver::{Condition, Order, Solver, State};
use std::process::{Command, ExitCode, Output};

/// Returns the presets with forces.
fn acted() -> impl Iterator<Item = (&'static str, Scene)> {
    let scenes = presets::all().iter();
    let scenes = scenes.map(|p| (p.name, Scene::parse(p.text, p.name).unwrap()));
    scenes.filter(|(_, scene)| scene.mechanism.has_forces())
}

fn forces(scene: &Scene) -> Vec<Quantity> {
    let all = Catalogue::new(scene).all().to_vec();
    let is_force = |q: &Quantity| q.order() == Order::Force;
    all.into_iter().filter(is_force).collect()
}

fn is_residual(quantity: &Quantity) -> bool {
    matches!(
        quantity.subject(),
        Some(Subject::FrameResidual | Subject::Drive(Share::Residual))
    )
}

/// Returns regular positions of the motion.
fn places(solver: &Solver) -> Vec<f64> {
    let (low, high) = solver.motion().range.ends();
    let places = (1..100).map(|k| low + (high - low) * f64::from(k) / 100.3);
    places.collect()
}

fn shown(quantities: &[Quantity], state: &State, residuals: bool) -> usize {
    let quantities = quantities.iter().filter(|q| is_residual(q) == residuals);
    quantities.filter(|q| q.value(state).is_some()).count()
}

#[test]
fn only_balanced_forces_are_shown() {
    for (name, scene) in acted() {
        let quantities = forces(&scene);
        for falsify in [false, true] {
            let solver = falsified(falsify, || Solver::new(&scene.mechanism)).unwrap();
            let (mut state, mut lanes) = (solver.state(), solver.lanes());
            let mut enclosure = solver.enclosure();
            let mut hidden = 0;
            let coordinates = places(&solver);
            for &at in &coordinates {
                assert_eq!(solver.solve(at, Order::Force, &mut state), Condition::Ok);
                for by_bounds in [false, true] {
                    if by_bounds {
                        solver.enclose(&mut state, Order::Force, &mut enclosure);
                    }
                    let is_hidden = state.withheld().is_some();
                    assert!(falsify || !is_hidden, "{name} at {at}: {state:?}");
                    // The residuals stay visible for inspection.
                    assert_eq!(shown(&quantities, &state, true), 4, "{name} at {at}");
                    assert_eq!(
                        shown(&quantities, &state, false) == 0,
                        is_hidden,
                        "{name} at {at}"
                    );
                }
                hidden += usize::from(state.withheld().is_some());
                let all = [at; crate::LANES];
                let at_once = solver.solve_lanes(all, Order::Force, &mut lanes);
                assert!(!(at_once && state.withheld().is_some()), "{name} at {at}");
            }
            // At some positions the repeated pass may have no effect.
            let minimum = if falsify {
                coordinates.len() * 9 / 10
            } else {
                0
            };
            assert!(hidden >= minimum, "{name}: only {hidden} withheld");
        }
    }
}

/// The environment variable that marks the process with a falsified solver, and contains its
/// arguments.
const ARGUMENTS: &str = "KRANK_TEST_UNBALANCED";

/// Runs the program with a falsified solver in a separate process.
fn krank(arguments: &str) -> Output {
    let (_, module) = module_path!().split_once("::").unwrap();
    let test = format!("{module}::run_program_child");
    Command::new(std::env::current_exe().unwrap())
        .args(["--exact", &test, "--ignored", "--nocapture"])
        .env(ARGUMENTS, arguments)
        .output()
        .unwrap()
}

#[test]
#[ignore = "started by the test below"]
fn run_program_child() {
    let Ok(arguments) = std::env::var(ARGUMENTS) else {
        return;
    };
    let arguments = ["krank"].into_iter().chain(arguments.split(' '));
    let code = falsified(true, || cli::run(arguments.map(Into::into)));
    let is = |other: ExitCode| format!("{code:?}") == format!("{other:?}");
    std::process::exit(match () {
        () if is(ExitCode::SUCCESS) => 0,
        () if is(ExitCode::from(1)) => 1,
        () => 2,
    });
}

#[test]
fn commands_hide_and_report_unbalanced_forces_and_fail() {
    for (arguments, text, shown) in [
        (
            "sweep four-bar-load --columns driver.torque,driver.torque.residual,r3.B.fx,B.x --from 0 --to 20 --step 10",
            "3 of 3 rows have values that are not shown: the forces at 0 deg are not shown: driver.torque.residual is",
            "\n10,,",
        ),
        (
            "sweep four-bar-load --columns driver.power --bounds --from 10 --to 10",
            "1 of 1 rows have values that are not shown: the forces at 10 deg are not shown: driver.torque.residual is",
            "\n10,,,ok\n",
        ),
        (
            "table four-bar-load --at 60",
            "the forces at 60 deg are not shown: driver.torque.residual is",
            "checks miss by",
        ),
        (
            "table four-bar-load --at 60 --format json",
            "the forces at 60 deg are not shown",
            "\"driver.torque\": null",
        ),
        (
            "explain four-bar-load --at 60",
            "the forces at 60 deg are not shown",
            "The forces at 60 deg are not shown: driver.torque.residual is",
        ),
        (
            "plot four-bar-load --columns driver.torque,B.x",
            "the forces at 0 deg are not shown",
            "B.x",
        ),
        (
            "motor four-bar-load",
            "are not shown: driver.torque.residual is",
            "no values: the forces at",
        ),
        (
            "motor four-bar-load --format json",
            "are not shown: driver.torque.residual is",
            "\"cycle\": null",
        ),
        ("motor four-bar-load --format csv", "are not shown", ""),
    ] {
        let done = krank(arguments);
        let out = String::from_utf8(done.stdout).unwrap();
        let shown_text = String::from_utf8(done.stderr).unwrap();
        assert_eq!(
            done.status.code(),
            Some(1),
            "{arguments}: {out}{shown_text}"
        );
        assert!(shown_text.contains(text), "{arguments}: {shown_text}");
        assert!(out.contains(shown), "{arguments}: {out}");
        assert!(
            shown_text.contains("please report it"),
            "{arguments}: {shown_text}"
        );
    }
    // Commands without forces succeed.
    let done = krank("sweep four-bar-load --columns B.x --from 0 --to 20 --step 10");
    assert_eq!(done.status.code(), Some(0), "{done:?}");
}

#[cfg(feature = "tui")]
#[test]
fn force_views_report_unbalanced_forces() {
    use crate::capability::Colours;
    use crate::drawing::Glyphs;
    use crate::tui::{OpenedScene, Origin, Workbench};
    let text = presets::find("four-bar-load").unwrap().text;
    let scene = Scene::parse(text, "four-bar-load").unwrap();
    let opened = OpenedScene {
        solver: falsified(true, || Solver::new(&scene.mechanism)).unwrap(),
        scene,
        origin: Origin::Preset("four-bar-load".into()),
    };
    let mut workbench = Workbench::new(opened, Glyphs::Ascii, Colours::None, 100, 40);
    let mut look = |key: &str| {
        workbench.press(key);
        let words = workbench.text();
        words.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    for key in ["5", "8"] {
        let screen = look(key);
        assert!(
            screen.contains("are not shown: driver.torque.residual is"),
            "{key}: {screen}"
        );
        assert!(screen.contains("please report it"), "{key}: {screen}");
    }
    // Only the checks remain in the view of forces.
    let screen = look("5");
    assert!(
        screen.contains("off by") && !screen.contains("force on"),
        "{screen}"
    );
    // The working reports it further down.
    look("7");
    let found = (0..60).any(|_| look("PgDn").contains("are not shown: driver.torque.residual is"));
    assert!(found, "{}", look("7"));
}
