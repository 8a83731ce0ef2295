//! The tutorial of the README: every step is a scene that does what is said of it.

use super::{command, folder, run};

const README: &str = include_str!("../../README.md");
const FILE: &str = "six-bar.toml";

/// The tutorial alone.
fn tutorial() -> &'static str {
    let (_, behind) = README
        .split_once("## From an empty file to a six-bar\n")
        .unwrap();
    behind.split("\n## ").next().unwrap()
}

/// Its blocks in this language.
pub(super) fn blocks(language: &str) -> Vec<&'static str> {
    let opening = format!("```{language}\n");
    let behind = tutorial().split(opening.as_str()).skip(1);
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
            heard.out.contains(said) && tutorial().contains(said),
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
    let shown = tutorial()
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
