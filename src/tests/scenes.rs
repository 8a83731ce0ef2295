//! Fuzzes the loader of scenes: any input yields a scene that can be solved, or messages that can
//! be shown.

use super::fuzz::{Fuzz, shape};
use crate::quantity::check_figures;
use crate::report::{Forces, Working};
use crate::scene::{Diagnostics, Scene, is_harmful};
use crate::solver::{Condition, Order, Solver};
use std::hash::{DefaultHasher, Hash, Hasher};

/// Maximum number of links: larger scenes are slow and find nothing more.
const MAX_LINKS: usize = 40;

const WORDS: &[&str] = &[
    "[ground]\n",
    "[driver]\n",
    "[links]\n",
    "[slides]\n",
    "[start]\n",
    "[vectors]\n",
    "[[loads]]\n",
    "[links.r2]\n",
    "[figures]\n",
    "swing = \"r4.angle - r3.angle\"\n",
    "A",
    "B",
    "C",
    "D",
    "E",
    "r2",
    "r3",
    "r4",
    "\"B'\"",
    "\"r3.com\"",
    "\"ground\"",
    "driver",
    "com",
    "state",
    " = ",
    "{ ",
    " }",
    "[0, 0]",
    "[100, 50]",
    "link = \"r2\"\n",
    "slide = \"r4\"\n",
    "angle = 60\n",
    "position = 1\n",
    "speed = \"15 rad/s\"\n",
    "acceleration = \"1 rad/s^2\"\n",
    "from = \"A\", ",
    "to = \"B\", ",
    "length = 100",
    "points = { P = [1, 2] }",
    "mass = 1",
    "inertia = 1",
    "point = \"C\", ",
    "on = \"ground\", ",
    "on = \"r3\", ",
    "through = \"A\", ",
    "through = [0, 0]",
    "turn = 90",
    "unit = \"in\"\n",
    "gravity = [0, -9.81]\n",
    "force = [1, 0]",
    "torque = 1",
    "[[springs]]\n",
    "[motor]\n",
    "frame = \"r3\"\n",
    "over = [[0, 1], [90, -2], [360, 1]]\n",
    "press = [[12, 0], [4, 200e3], [0, 350e3]]\n",
    "end = \"least\"\n",
    "stiffness = 1200\n",
    "damping = 5\n",
    "preload = -3\n",
    "peak = 60\n",
    "flywheel = 0.5\n",
    "[[loads]]\npoint = \"C\"\nforce = [10, -500]\n",
    "[[loads]]\nlink = \"r3\"\ntorque = 1\nover = [[0, 1], [180, 0]]\n",
    "[[loads]]\nslide = \"r4\"\npress = [[12, 0], [0, 350e3]]\nend = \"greatest\"\n",
    "[[springs]]\nfrom = \"A\"\nto = \"C\"\nstiffness = 1200\nlength = 80\ndamping = 5\n",
    "[[springs]]\nfrom = \"A\"\nto = \"C\"\nforce = [[200, 900], [200, 800], [300, 700]]\n",
    "[[springs]]\nlink = \"r4\"\nto = \"r3\"\nstiffness = 12\nangle = 30\npreload = -2\n",
    ", ",
    "\n",
    "\r\n",
    "\t",
    "# ",
    "\"\"\"",
    "'",
    "\"",
    "\\u202e",
    "\u{202e}",
    "\u{1b}",
    "\u{e9}",
    "\u{feff}",
    ".",
    "true",
    "x = { from = \"C\", to = \"E\", length = 100 }\n",
    "y = { point = \"E\", on = \"ground\", through = [0, 0] }\n",
];

#[test]
fn fuzz_scene_loader() {
    let fuzz = Fuzz {
        name: "scenes",
        seeds: &["presets", "tests/broken", "tests/reference"],
        words: WORDS,
        runs: 1000,
    };
    fuzz.run(|bytes| {
        let mut outcome = DefaultHasher::new();
        match Scene::read(bytes, "fuzz.toml") {
            Ok(scene) => opened(&scene, &mut outcome),
            Err(faults) => refused(&faults, &mut outcome),
        }
        outcome.finish()
    });
}

fn opened(scene: &Scene, outcome: &mut DefaultHasher) {
    let mechanism = &scene.mechanism;
    if mechanism.links().len() > MAX_LINKS {
        return;
    }
    let solver = match Solver::new(mechanism) {
        Ok(solver) => solver,
        Err(fault) => return refused(&scene.explain(&fault), outcome),
    };
    if let Err(faults) = check_figures(scene) {
        return refused(&faults, outcome);
    }
    let (links, points) = (mechanism.links().len(), mechanism.points().len());
    (links.min(8), points.min(12), solver.plan().groups.len()).hash(outcome);
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    let working = Working::new(scene, &solver);
    let start = mechanism.driver().start;
    for at in [start, start + 1.0, -1e3, 0.1] {
        let condition = solver.solve(at, Order::Force, &mut state);
        std::mem::discriminant(&condition).hash(outcome);
        if condition == Condition::NoAssembly {
            continue;
        }
        let computed = working.of(scene, &solver, &state, 6);
        assert!(!computed.page.to_markdown(true).contains("NaN"), "at {at}");
        for point in mechanism.point_ids() {
            let position = state.position(point).unwrap();
            assert!(
                position.x.is_finite() && position.y.is_finite(),
                "{position:?} at {at}"
            );
        }
        solver.enclose(&mut state, Order::Force, &mut enclosure);
        let forces = Forces::new(scene, &solver, &state, Some(&enclosure));
        let figures = forces.iter().flat_map(Forces::figures);
        for (name, _, entry) in figures {
            let mut numbers = entry.value.into_iter().chain(entry.bound);
            assert!(numbers.all(f64::is_finite), "{name}: {entry:?} at {at}");
        }
    }
    if let Some(text) = scene.with_start_of(&solver, start) {
        Scene::parse(&text, "saved.toml").expect("what is saved can be read");
    }
}

fn refused(faults: &Diagnostics, outcome: &mut DefaultHasher) {
    assert!(!faults.items.is_empty(), "refused without a reason");
    for item in &faults.items {
        shape(&item.message).hash(outcome);
        for label in item.primary.iter().chain(&item.others) {
            assert!(faults.text.get(label.span.clone()).is_some(), "{label:?}");
        }
    }
    for (ascii, colour) in [(true, false), (false, true)] {
        let shown = faults.render(ascii, colour);
        let escape = |c: char| c == '\n' || (colour && c == '\u{1b}');
        assert!(
            !shown.contains(|c| is_harmful(c) && !escape(c)),
            "{shown:?}"
        );
        assert!(!ascii || shown.is_ascii(), "{shown:?}");
    }
}
