use super::*;
use crate::scene::presets;
use crate::solver::Range;

fn titles() -> ExerciseTitles {
    ExerciseTitles {
        name: "Exercise".into(),
        source: "here".into(),
        note: "so".into(),
    }
}

fn open(name: &str) -> (Scene, Solver) {
    let preset = presets::find(name).unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

/// Returns `true` if the scene assembles at every fifteenth degree of the motion.
fn assembles_everywhere(solver: &Solver) -> bool {
    let mut state = solver.state();
    let (low, high) = match solver.motion().range {
        Range::Full { period } => (0.0, period),
        Range::Limited { .. } => return false,
    };
    let steps = ((high - low) / 15.0) as u32;
    (0..=steps).all(|n| {
        let at = low + 15.0 * f64::from(n);
        solver.solve(at, Order::Position, &mut state) == Condition::Ok
    })
}

fn thousand(name: &str) {
    let (scene, solver) = open(name);
    let maker = ExerciseMaker::new(&scene, &solver);
    let mut texts = std::collections::HashSet::new();
    for seed in 0..1000 {
        let made = maker.exercise(seed, &titles());
        let made = made.unwrap_or_else(|| panic!("{name}, seed {seed}: none"));
        assert!(assembles_everywhere(&made.solver), "{name}, seed {seed}");
        let at = made.scene.mechanism.driver().start;
        assert_eq!(at % 5.0, 0.0, "{name}, seed {seed}");
        let mut workspace = made.solver.state();
        let margins = made.solver.margins(at, &mut workspace).unwrap();
        let minimum = margins.iter().copied().fold(1.0, f64::min);
        // 30 degrees from a dead point; the press itself attains less.
        assert!(
            minimum >= maker.required && minimum > 0.2,
            "{name}, seed {seed}: {minimum}"
        );
        // Over the whole motion, by the extreme transmission angles, as accurately as samples every 5 degrees show
        // them.
        if seed % 10 == 0 {
            for of in made.solver.transmission() {
                let worst = of.deviation().to_radians().cos();
                let minimum = 0.9 * maker.worst;
                assert!(worst * worst > minimum, "{name}, seed {seed}: {worst}");
            }
        }
        texts.insert(made.scene.text().to_owned());
    }
    assert!(texts.len() > 990, "{name}: {} of them differ", texts.len());
}

#[test]
fn thousand_four_bar_exercises_turn_fully() {
    thousand("four-bar");
}

#[test]
fn thousand_slider_crank_exercises_turn_fully() {
    thousand("slider-crank");
}

#[test]
fn thousand_press_exercises_turn_fully() {
    thousand("press");
}

/// Every preset has exercises that move as the preset does and are equal for equal seeds.
#[test]
fn every_preset_has_reproducible_exercises() {
    for preset in presets::all() {
        let (scene, solver) = open(preset.name);
        let maker = ExerciseMaker::new(&scene, &solver);
        for seed in [1, 2] {
            let made = maker.exercise(seed, &titles());
            let made = made.unwrap_or_else(|| panic!("{}, seed {seed}: none", preset.name));
            assert_eq!(MotionKind::of(&made.solver), maker.kind, "{}", preset.name);
            let again = maker.exercise(seed, &titles()).unwrap();
            assert_eq!(again.scene.text(), made.scene.text(), "{}", preset.name);
        }
    }
}

/// The exercise of a seed never changes, so that sheets already handed out stay valid.
#[test]
fn seed_7_gives_known_four_bar_exercise() {
    let (scene, solver) = open("four-bar");
    let made = ExerciseMaker::new(&scene, &solver)
        .exercise(7, &titles())
        .unwrap();
    let values = made.scene.values().into_iter();
    let values: Vec<String> = values.map(|v| format!("{} {}", v.name, v.text())).collect();
    let known = [
        "A x 0",
        "A y 0",
        "D x 340",
        "D y 0",
        "driver angle 350",
        "driver speed 12 rad/s",
        "r2 length 75",
        "r2 com x 0",
        "r2 com y 0",
        "r3 length 310",
        "r3 com x 155",
        "r3 com y 0",
        "r4 length 180",
        "r4 com x 90",
        "r4 com y 0",
        "C start x 317.546",
        "C start y 178.594",
    ];
    assert_eq!(values, known);
}

#[test]
fn scene_without_lengths_has_no_exercises() {
    let text = "[ground]\nA = [0, 0]\n[driver]\nlink = \"r\"\nangle = 1\n\
        [links]\nr = { points = { A = [0, 0] } }\n";
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let maker = ExerciseMaker::new(&scene, &solver);
    assert!(maker.exercise(1, &titles()).is_none());
}

/// Values keep their formulas; the parameter is drawn instead.
#[test]
fn exercises_keep_formulas() {
    let text = presets::find("four-bar").unwrap().text;
    let text = text.replacen("[ground]", "[parameters]\na = 100\n[ground]", 1);
    let text = text.replacen("length = 100", "length = \"a\"", 1);
    let scene = Scene::parse(&text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let made = ExerciseMaker::new(&scene, &solver).exercise(3, &titles());
    let made = made.unwrap().scene;
    let crank = made.value_named("r2.length").unwrap();
    let a = made.value_named("a").unwrap().number;
    assert_ne!(a, 100.0);
    assert_eq!((crank.formula.as_deref(), crank.number), (Some("a"), a));
    assert_ne!(made.value_named("r3.length").unwrap().number, 300.0);
}
