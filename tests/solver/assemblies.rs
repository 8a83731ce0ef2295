//! The choices of groups, whole assemblies, and switching between them.

#![allow(clippy::excessive_precision, reason = "the digits of the hard cases")]

use krank::scene::{Scene, presets};
use krank::solver::{AssemblyChoice, Condition, Fault, GroupId, Order, Range, Solver, State};
use krank::{ElementId, PointId, Vec2};

fn scene(text: &str) -> Scene {
    Scene::parse(text, "test").unwrap()
}

fn preset(name: &str) -> Scene {
    scene(presets::find(name).unwrap().text)
}

/// Creates a four-bar with A = (0, 0), D = (d, 0), crank a, coupler b and follower c.
fn four_bar([a, b, c, d]: [f64; 4], angle: f64, start: &str) -> Scene {
    scene(&format!(
        "[ground]\nA = [0, 0]\nD = [{d}, 0]\n[driver]\nlink = \"a\"\nangle = {angle}\n\
         [links]\na = {{ from = \"A\", to = \"B\", length = {a} }}\n\
         b = {{ from = \"B\", to = \"C\", length = {b} }}\n\
         c = {{ from = \"D\", to = \"C\", length = {c} }}\n{start}"
    ))
}

fn point(scene: &Scene, name: &str) -> PointId {
    let mut ids = scene.mechanism.point_ids();
    ids.find(|&p| scene.point_name(p) == Some(name)).unwrap()
}

fn picked(scene: &Scene, name: &str, choice: AssemblyChoice) -> Result<Solver, Fault> {
    let element = ElementId::Point(point(scene, name));
    Solver::with_assembly(&scene.mechanism, &[(element, choice)])
}

fn at(solver: &Solver, angle: f64) -> State {
    let mut state = solver.state();
    let condition = solver.solve(angle, Order::Acceleration, &mut state);
    assert_ne!(condition, Condition::NoAssembly, "at {angle}");
    state.into_state()
}

/// Returns the group after the driver's.
fn second(solver: &Solver) -> GroupId {
    solver.plan().numbered().nth(1).unwrap().0
}

#[track_caller]
fn near(seen: Vec2, expected: [f64; 2]) {
    let off = (seen - Vec2::new(expected[0], expected[1])).norm();
    assert!(off < 1e-12 * seen.norm(), "{seen:?} is not {expected:?}");
}

/// The lectures' four-bar: `+` is the lectures' assembly, with C on the left of B -> D.
#[test]
fn h29_both_assemblies_have_exact_values() {
    let scene = preset("four-bar");
    let c = point(&scene, "C");
    let plus = picked(&scene, "C", AssemblyChoice::Plus).unwrap();
    near(
        at(&plus, 240.0).position(c).unwrap(),
        [175.8975078189799874691, 110.8064664099341458066],
    );
    let minus = picked(&scene, "C", AssemblyChoice::Minus).unwrap();
    near(
        at(&minus, 240.0).position(c).unwrap(),
        [233.0310636095914411023, -186.0681979292960758229],
    );
    // Full turns later, and after switching at any angle, the values agree bit for bit.
    let position = at(&minus, 240.0).position(c).unwrap();
    assert_eq!(at(&minus, 240.0 + 360.0).position(c).unwrap(), position);
    for from in [0.0, 60.0, 240.0, 301.5] {
        let switched = plus
            .switched(from, second(&plus), AssemblyChoice::Minus)
            .unwrap();
        assert_eq!(
            at(&switched, 240.0).position(c).unwrap(),
            position,
            "from {from}"
        );
        let back = switched
            .switched(from, second(&switched), AssemblyChoice::Plus)
            .unwrap();
        assert_eq!(
            at(&back, 240.0).position(c).unwrap(),
            at(&plus, 240.0).position(c).unwrap()
        );
    }
}

#[test]
fn h21_both_sides_of_near_miss_can_be_picked() {
    let scene = four_bar([1.0, 3.0, 1.0 + 1e-9, 3.0], 60.0, "");
    let c = point(&scene, "C");
    for (choice, at_60, at_350) in [
        (
            AssemblyChoice::Plus,
            [3.499999999999999999778, 0.8660254049391392806192],
            [3.940584982472821363256, 0.3395583789963111709332],
        ),
        (
            AssemblyChoice::Minus,
            [2.857142856428571369336, -0.9897433195180518084789],
            [3.98480775301220805384, -0.1736481834257012472138],
        ),
    ] {
        let solver = picked(&scene, "C", choice).unwrap();
        near(at(&solver, 60.0).position(c).unwrap(), at_60);
        // In typed lengths, the sides of the near miss are 1e-5 apart.
        near(at(&solver, -10.0).position(c).unwrap(), at_350);
    }
}

/// Each mode of a coupled group has its own motion, closed over a turn or with its own limits, and
/// can be selected from any of its angles.
#[test]
fn coupled_group_modes_are_separate_motions() {
    let text = presets::find("stephenson-six-bar").unwrap().text;
    for text in [
        text.to_owned(),
        // Hard case H18: the crank no longer turns fully.
        text.replace("length = 30 }", "length = 90 }")
            .replace("length = 190 }", "length = 230 }"),
    ] {
        let scene = scene(&text);
        let e = point(&scene, "E");
        let first = Solver::new(&scene.mechanism).unwrap();
        let choices = first.choices(60.0, second(&first));
        assert!(choices.len() >= 2);
        for choice in &choices {
            let solver = picked(&scene, "E", choice.pick).unwrap();
            let position = at(&solver, 60.0).position(e).unwrap();
            assert!((position - choice.state.position(e).unwrap()).norm() < 1e-9);
            let range = match solver.motion().range {
                Range::Full { period } => {
                    assert_eq!(at(&solver, 60.0 + period).position(e).unwrap(), position);
                    (0.0, period)
                }
                Range::Limited { low, high } => (low, high),
            };
            // In steps or directly, the motion is the same.
            let mut before = position;
            for k in 0..=400 {
                let angle = 60.0 + (range.1 - 60.0) * f64::from(k) / 400.0;
                let now = at(&solver, angle).position(e).unwrap();
                assert!((now - before).norm() < 20.0, "a jump at {angle}");
                before = now;
            }
            // Switching elsewhere to another mode, and back.
            let angle = 60.0 + 0.5 * (range.1 - 60.0);
            let there = solver.choices(angle, second(&solver));
            let own = there.iter().find(|c| c.is_current).unwrap().pick;
            for other in there.iter().filter(|c| !c.is_current) {
                let switched = solver.switched(angle, second(&solver), other.pick).unwrap();
                let seen = at(&switched, angle).position(e).unwrap();
                assert!((seen - other.state.position(e).unwrap()).norm() < 1e-9);
                let back = switched.switched(angle, second(&switched), own).unwrap();
                assert!((at(&back, 60.0).position(e).unwrap() - position).norm() < 1e-9);
            }
        }
    }
}

#[test]
fn choices_mark_current_assembly() {
    let scene = preset("four-bar");
    let c = point(&scene, "C");
    let solver = Solver::new(&scene.mechanism).unwrap();
    for angle in [60.0, 240.0, 1000.0] {
        let choices = solver.choices(angle, second(&solver));
        let seen: Vec<_> = choices
            .iter()
            .map(|c| (c.pick, c.is_current, c.closes))
            .collect();
        let both = [
            (AssemblyChoice::Plus, true, true),
            (AssemblyChoice::Minus, false, true),
        ];
        assert_eq!(seen, both);
        for choice in &choices {
            let solver = picked(&scene, "C", choice.pick).unwrap();
            let off = at(&solver, angle).position(c).unwrap() - choice.state.position(c).unwrap();
            assert!(off.norm() < 1e-12 * 400.0);
        }
    }
    let (driver, _) = solver.plan().numbered().next().unwrap();
    assert!(
        solver.choices(60.0, driver).is_empty(),
        "the driver has none"
    );
    let longer = Solver::new(&preset("jansen-leg").mechanism).unwrap();
    let (foreign, _) = longer.plan().numbered().last().unwrap();
    assert!(solver.choices(60.0, foreign).is_empty());
    assert!(
        solver
            .switched(60.0, foreign, AssemblyChoice::Plus)
            .is_err()
    );
    let part = solver.only(&krank::solver::Demand::default());
    assert!(part.choices(60.0, second(&part)).is_empty());
}

/// Two dyads in a row: exactly the listed assemblies open, and each reports itself as the current
/// one.
#[test]
fn listed_assemblies_match_those_that_open() {
    let mut counts = Vec::new();
    for name in ["press", "watt-six-bar", "klann-leg", "press-ram"] {
        let scene = preset(name);
        let start = scene.mechanism.driver().start;
        let solver = Solver::new(&scene.mechanism).unwrap();
        let groups = &solver.plan().groups;
        let groups: Vec<_> = groups.iter().filter(|g| g.has_choices()).collect();
        let mut opened = Vec::new();
        for combination in 0..1 << groups.len() {
            let sides = groups.iter().enumerate().map(|(i, group)| {
                let minus = combination >> (groups.len() - 1 - i) & 1 == 1;
                let side = if minus {
                    AssemblyChoice::Minus
                } else {
                    AssemblyChoice::Plus
                };
                (group.name().unwrap(), side)
            });
            let choices: Vec<_> = sides.collect();
            if let Ok(other) = Solver::with_assembly(&scene.mechanism, &choices) {
                let sides: Vec<_> = choices.iter().map(|p| p.1).collect();
                opened.push((sides, other));
            }
        }
        let sides = |choices: &[(GroupId, AssemblyChoice)]| -> Vec<AssemblyChoice> {
            choices.iter().map(|p| p.1).collect()
        };
        let all = solver.assemblies(start);
        assert!(all.is_complete);
        let listed: Vec<_> = all.list.iter().map(|choices| sides(choices)).collect();
        let tried: Vec<_> = opened.iter().map(|(sides, _)| sides.clone()).collect();
        assert_eq!(listed, tried, "{name}");
        for (i, (_, other)) in opened.iter().enumerate() {
            let again = other.assemblies(start);
            assert_eq!((again.list, again.current), (all.list.clone(), Some(i)));
        }
        counts.push(listed.len());
    }
    assert_eq!(counts, [2, 4, 2, 4]);
}

#[test]
fn assembly_list_has_at_most_64_entries() {
    let scene = preset("scissor-lift");
    let solver = Solver::new(&scene.mechanism).unwrap();
    let all = solver.assemblies(scene.mechanism.driver().start);
    assert!(all.list.len() <= 64);
    assert_eq!(all.is_complete, all.list.len() < 64);
    let jansen = preset("jansen-leg");
    let solver = Solver::new(&jansen.mechanism).unwrap();
    let all = solver.assemblies(jansen.mechanism.driver().start);
    assert!(all.list.len() > 1 && all.current.is_some());
}

/// A redundant constraint closes with only one choice.
#[test]
fn choice_breaking_redundant_constraint_does_not_close() {
    let scene = preset("triple-parallelogram");
    let solver = Solver::new(&scene.mechanism).unwrap();
    let start = scene.mechanism.driver().start;
    let groups = solver.plan().numbered();
    let choices: Vec<_> = groups.flat_map(|(g, _)| solver.choices(start, g)).collect();
    assert_eq!(choices.len(), 2);
    assert_eq!(choices.iter().filter(|c| c.closes).count(), 1);
    let all = solver.assemblies(start);
    assert_eq!((all.list.len(), all.current), (1, Some(0)));
}

/// The dead points of the range are those of the selected assembly.
#[test]
fn scene_can_open_at_dead_point() {
    let limit = {
        let scene = four_bar([60.0, 50.0, 60.0, 100.0], 60.0, "[start]\nC = [75, 55]\n");
        let solver = Solver::new(&scene.mechanism).unwrap();
        let Range::Limited { high, .. } = solver.motion().range else {
            panic!("the crank cannot turn fully");
        };
        high
    };
    let scene = four_bar([60.0, 50.0, 60.0, 100.0], limit, "");
    let c = point(&scene, "C");
    for choice in [AssemblyChoice::Plus, AssemblyChoice::Minus] {
        let solver = picked(&scene, "C", choice).unwrap();
        assert_eq!(solver.motion().dead_points.len(), 2);
        assert!(solver.motion().dead_points.contains(&limit));
        let mut state = solver.state();
        assert_eq!(
            solver.solve(limit, Order::Velocity, &mut state),
            Condition::DeadPoint
        );
        let choices = solver.choices(limit, second(&solver));
        let current: Vec<_> = choices
            .iter()
            .filter(|c| c.is_current)
            .map(|c| c.pick)
            .collect();
        assert_eq!(current, [choice]);
        assert!(
            (choices[0].state.position(c).unwrap() - choices[1].state.position(c).unwrap()).norm()
                < 1e-6
        );
    }
    // Both assemblies coincide there, so that no selection is needed.
    assert!(Solver::new(&scene.mechanism).is_ok());
}

/// At a change point two motions continue. One must be selected, and is then followed value for
/// value.
#[test]
fn h01_h02_scene_opened_at_change_point_follows_pick() {
    for (opening, anti_at_0) in [(0.0, -2.0), (180.0, -0.5)] {
        let scene = four_bar([1.0, 3.0, 1.0, 3.0], opening, "");
        let group = ElementId::Point(point(&scene, "C"));
        assert_eq!(
            Solver::new(&scene.mechanism).unwrap_err(),
            Fault::ChangePoint {
                group,
                has_sides: true
            }
        );
        let follower = scene.mechanism.link_ids().nth(2).unwrap();
        let mut rates: Vec<f64> = [AssemblyChoice::Plus, AssemblyChoice::Minus]
            .map(|choice| {
                let solver = picked(&scene, "C", choice).unwrap();
                let state = at(&solver, opening);
                let range = Range::Full { period: 360.0 };
                assert_eq!(solver.motion().range, range);
                let mut points = solver.motion().change_points.clone();
                points.sort_by(f64::total_cmp);
                assert_eq!(points, [0.0, 180.0]);
                assert_eq!(state.condition(), Condition::ChangePoint);
                let choices = solver.choices(opening, second(&solver));
                assert!(choices.iter().all(|c| c.is_current == (c.pick == choice)));
                // The other continuation, switched at the change point itself.
                let other = if choice == AssemblyChoice::Plus {
                    AssemblyChoice::Minus
                } else {
                    AssemblyChoice::Plus
                };
                let switched = solver.switched(opening, second(&solver), other).unwrap();
                let there = at(&switched, opening);
                assert!(
                    (there.omega(follower).unwrap() - state.omega(follower).unwrap()).abs() > 0.5
                );
                state.omega(follower).unwrap()
            })
            .into();
        rates.sort_by(f64::total_cmp);
        assert!((rates[0] - anti_at_0).abs() < 1e-9, "{rates:?}");
        assert!((rates[1] - 1.0).abs() < 1e-9, "{rates:?}");
    }
}

#[test]
fn invalid_pick_is_rejected_with_number_of_choices() {
    let scene = preset("four-bar");
    let group = ElementId::Point(point(&scene, "C"));
    let refused = |name, choice| picked(&scene, name, choice).unwrap_err();
    assert_eq!(
        refused("C", AssemblyChoice::Number(2)),
        Fault::NoChoice { group, found: 2 }
    );
    let group = ElementId::Point(point(&scene, "B"));
    assert_eq!(
        refused("B", AssemblyChoice::Plus),
        Fault::NoChoice { group, found: 0 }
    );
}
