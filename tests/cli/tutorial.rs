//! The tutorial: every step is a scene that does what is said of it.

use super::{command, done, folder, run};

const TUTORIAL: &str = include_str!("../../src/manual/tutorial.md");
const FILE: &str = "six-bar.toml";

/// Its blocks in this language.
pub(super) fn blocks(language: &str) -> Vec<&'static str> {
    let opening = format!("```{language}\n");
    let behind = TUTORIAL.split(opening.as_str()).skip(1);
    behind
        .map(|text| text.split("```").next().unwrap())
        .collect()
}

#[test]
fn every_step_is_a_scene() {
    let here = folder("tutorial");
    let check = |scene: &str| {
        std::fs::write(here.join(FILE), scene).unwrap();
        run(command(&["check", FILE]).current_dir(&here))
    };
    let [crank, ambiguous, four_bar, six_bar] = blocks("toml")[..] else {
        panic!("the tutorial has other steps than this test knows");
    };
    let heard = check(crank);
    assert_eq!(heard.code, 0, "{}", heard.err);
    assert!(heard.out.contains("1 link and the ground"), "{}", heard.out);
    let heard = check(ambiguous);
    assert_eq!((heard.code, heard.err.as_str()), (2, blocks("text")[0]));
    let heard = check(four_bar);
    assert_eq!(heard.code, 0, "{}", heard.err);
    for said in ["turns fully", "four-bar, crank-rocker: Grashof"] {
        assert!(
            heard.out.contains(said) && TUTORIAL.contains(said),
            "{}",
            heard.out
        );
    }
    // The step in between is this one with a third point on the coupler.
    let curve = four_bar.replace(
        "length = 120 }",
        "length = 120, points = { E = [60, 50] } }",
    );
    assert_ne!(curve, four_bar);
    assert_eq!(check(&curve).code, 0);
    let drawn = run(command(&["draw", FILE, "--traces", "E"]).current_dir(&here));
    assert_eq!(drawn.code, 0, "{}", drawn.err);
    let heard = check(six_bar);
    assert_eq!(heard.code, 0, "{}", heard.err);
    for said in [
        "5 links and the ground, 7 pin joints",
        "dyad RRR at C",
        "dyad RRR at F",
        "transmission angle at F",
        "turns fully",
    ] {
        assert!(heard.out.contains(said), "{said}: {}", heard.out);
    }
}

#[test]
fn its_commands_run() {
    let here = folder("tutorial-commands");
    std::fs::write(here.join(FILE), blocks("toml").last().unwrap()).unwrap();
    let shown = TUTORIAL
        .lines()
        .filter_map(|line| line.strip_prefix("    krank "));
    let mut ran = 0;
    for line in shown {
        let args: Vec<&str> = line.split(' ').collect();
        let heard = run(command(&args).current_dir(&here));
        assert_eq!((heard.code, heard.err.as_str()), (0, ""), "{line}");
        ran += 1;
    }
    assert_eq!(ran, 4);
}

/// What stands in the text is what is shown, scene by scene.
#[test]
fn its_scenes_are_shown_as_they_are() {
    let shown = done(&["help", "tutorial"]);
    for block in blocks("toml") {
        let lines = block.lines().map(|line| format!("    {line}"));
        let lines: Vec<String> = lines.map(|line| line.trim_end().to_owned()).collect();
        assert!(shown.contains(&lines.join("\n")), "{shown}");
    }
}
