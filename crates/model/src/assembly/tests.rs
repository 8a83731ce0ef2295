use super::*;
use crate::scene::presets;

fn preset(name: &str) -> Scene {
    Scene::parse(presets::find(name).unwrap().text, name).unwrap()
}

fn picks_or_message(scene: &str, requests: &[&str]) -> Result<Vec<AssemblyChoice>, String> {
    let scene = preset(scene);
    let plan = Plan::of(&scene.mechanism).unwrap();
    let requests: Vec<AssemblyRequest> = requests.iter().map(|w| w.parse().unwrap()).collect();
    let choices = scene.picks(&plan, &requests).map_err(|e| e.to_string())?;
    Ok(choices.iter().map(|p| p.1).collect())
}

#[test]
fn assembly_request_round_trips_through_text() {
    for text in ["C=+", "C=-", "E=2", "B'=+"] {
        assert_eq!(text.parse::<AssemblyRequest>().unwrap().to_string(), text);
    }
    for wrong in ["C", "C=", "=+", "C=0", "C=-1", "C=++", "C=1.5", ""] {
        assert_eq!(
            wrong.parse::<AssemblyRequest>(),
            Err(AssemblyError::Form),
            "{wrong:?}"
        );
    }
}

#[test]
fn picks_find_groups_by_name() {
    assert_eq!(
        picks_or_message("four-bar", &["C=-"]),
        Ok(vec![AssemblyChoice::Minus])
    );
    assert_eq!(
        picks_or_message("press", &["F=+", "C=-"]),
        Ok(vec![AssemblyChoice::Plus, AssemblyChoice::Minus])
    );
    assert_eq!(
        picks_or_message("slotted-lever", &["r4=-"]),
        Ok(vec![AssemblyChoice::Minus])
    );
    assert_eq!(
        picks_or_message("stephenson-six-bar", &["E=2"]),
        Ok(vec![AssemblyChoice::Number(2)])
    );
}

#[test]
fn invalid_picks_are_rejected_with_alternatives() {
    for (scene, requests, expected) in [
        (
            "four-bar",
            &["X=+"][..],
            "no group `X` has a choice of assemblies; the only one is `C`",
        ),
        (
            "four-bar",
            &["c=+"],
            "no group `c` has a choice of assemblies; did you mean `C`?",
        ),
        (
            "press",
            &["B=+"],
            "no group `B` has a choice of assemblies; there are `C`, `F`",
        ),
        (
            "scotch-yoke",
            &["B=+"],
            "no group `B` has a choice of assemblies; this scene has none",
        ),
        (
            "four-bar",
            &["C=1"],
            "`C` needs a sign, `C=+` or `C=-`: it is a dyad",
        ),
        (
            "stephenson-six-bar",
            &["E=+"],
            "`E` needs a number, such as `E=1`: it is a coupled group; list its assemblies with `krank check`",
        ),
        ("four-bar", &["C=+", "C=-"], "`C` is given twice"),
    ] {
        assert_eq!(picks_or_message(scene, requests), Err(expected.to_owned()));
    }
}

/// Saves and reopens up to eight complete assemblies of every preset. Only lines with positions
/// change.
#[test]
fn saved_assembly_reopens_with_its_change_points() {
    let mut saved = 0;
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let start = scene.mechanism.driver().start;
        let solver = Solver::new(&scene.mechanism).unwrap();
        for choices in solver.assemblies(start).list.iter().take(8) {
            let named = choices
                .iter()
                .filter_map(|&(g, p)| Some((solver.plan().group(g)?.name()?, p)));
            let named: Vec<_> = named.collect();
            let Ok(other) = Solver::with_assembly(&scene.mechanism, &named) else {
                continue;
            };
            let Some(text) = scene.with_start_of(&other, start) else {
                // Another `[start]` would change links as drawn.
                assert!(preset.text.contains("points = [\""), "{}", preset.name);
                continue;
            };
            let again = Scene::parse(&text, preset.name).unwrap();
            let again = Solver::new(&again.mechanism).unwrap();
            assert_eq!(again.motion().change_points, other.motion().change_points);
            let same = |line: &&str| preset.text.lines().any(|l| l == *line);
            let changed = text.lines().filter(|line| !same(line));
            assert!(
                changed
                    .clone()
                    .all(|line| line.contains(" = [") || line == "[start]"),
                "{text}"
            );
            saved += 1;
        }
    }
    assert!(saved > 40, "{saved}");
}

/// A parallelogram as drawn: its exact dimensions, which have change points, are never rounded to those of
/// another `[start]`.
#[test]
fn saved_assembly_keeps_dimensions_of_drawn_links() {
    let text = "[ground]\nA = [0, 0]\nD = [4, 0]\n[driver]\nlink = \"r2\"\n[links]\n\
        r2 = { points = [\"A\", \"B\"] }\nr3 = { points = [\"B\", \"C\"] }\n\
        r4 = { points = [\"C\", \"D\"] }\n[start]\nB = [0.6, 0.8]\nC = [4.6, 0.8]\n";
    let scene = Scene::parse(text, "drawn").unwrap();
    let start = scene.mechanism.driver().start;
    let solver = Solver::new(&scene.mechanism).unwrap();
    assert_eq!(scene.with_start_of(&solver, start).as_deref(), Some(text));
    let point = scene
        .mechanism
        .point_ids()
        .find(|&p| scene.point_name(p) == Some("C"));
    let choices = [(ElementId::Point(point.unwrap()), AssemblyChoice::Minus)];
    let crossed = Solver::with_assembly(&scene.mechanism, &choices).unwrap();
    assert_eq!(scene.with_start_of(&crossed, start), None);
}

/// A motion that does not reach the scene's driver coordinate is saved with another one.
#[test]
fn saved_assembly_moves_driver_start_when_needed() {
    let text = "[ground]\nA = [0, 0]\nD = [3, 0]\n[driver]\nlink = \"a\"\nangle = 0 # flat\n[links]\n\
        a = { from = \"A\", to = \"B\", length = 1 }\nb = { from = \"B\", to = \"C\", length = 3 }\n\
        c = { from = \"D\", to = \"C\", length = 1 }\n";
    let scene = Scene::parse(text, "flat").unwrap();
    let point = scene.mechanism.point_ids().nth(3).unwrap();
    for (choice, y) in [(AssemblyChoice::Plus, 1.0), (AssemblyChoice::Minus, -1.0)] {
        let choices = [(ElementId::Point(point), choice)];
        let solver = Solver::with_assembly(&scene.mechanism, &choices).unwrap();
        // At the change point itself, no position distinguishes the two branches.
        assert_eq!(scene.with_start_of(&solver, 0.0), None);
        let moved = scene.with_start_of(&solver, 90.0).unwrap();
        assert!(moved.contains("angle = 90.0 # flat\n"), "{moved}");
        let again = Scene::parse(&moved, "flat").unwrap();
        assert!(again.mechanism.start()[0].1.y * y > 0.0, "{moved}");
    }
}
