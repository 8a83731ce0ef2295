//! Tests of the tutorial: every step is a scene with the described properties.

use super::language::spoken;
use super::readme::blocks;
use super::{Run, folder};

/// The tutorial in each language, with output of `check` for its scenes.
const TUTORIALS: [(&str, &str, [&str; 8]); 2] = [
    (
        "en",
        include_str!("../../src/manual/english/tutorial.md"),
        [
            "1 link and the ground",
            "turns fully",
            "four-bar, crank-rocker: Grashof",
            "5 links and the ground, 7 pin joints",
            "dyad RRR at C",
            "dyad RRR at F",
            "transmission angle at F",
            "turns fully",
        ],
    ),
    (
        "tr",
        include_str!("../../src/manual/turkish/tutorial.md"),
        [
            "1 uzuv ve şase",
            "tam döner",
            "dört çubuk, krank-sarkaç: Grashof",
            "5 uzuv ve şase, 7 döner mafsal",
            "ikili grup RRR, C noktasında",
            "ikili grup RRR, F noktasında",
            "bağlama açısı, F",
            "tam döner",
        ],
    ),
];
const FILE: &str = "six-bar.toml";

#[test]
fn every_tutorial_step_checks_as_described() {
    for (language, tutorial, text) in TUTORIALS {
        let here = folder(&format!("tutorial-{language}"));
        let run = |args: &[&str]| spoken(language, &here, args);
        let check = |scene: &str| -> Run {
            std::fs::write(here.join(FILE), scene).unwrap();
            run(&["check", FILE])
        };
        let [crank, ambiguous, four_bar, six_bar] = blocks(tutorial, "toml")[..] else {
            panic!("the tutorial has other steps than this test knows");
        };
        let [of_crank, of_four_bar @ .., _, _, _, _, _] = text;
        let output = check(crank);
        assert_eq!(output.code, 0, "{}", output.err);
        assert!(output.out.contains(of_crank), "{}", output.out);
        let output = check(ambiguous);
        let printed = blocks(tutorial, "text")[0];
        assert_eq!((output.code, output.err.as_str()), (2, printed));
        let output = check(four_bar);
        assert_eq!(output.code, 0, "{}", output.err);
        for text in of_four_bar {
            let is_true = output.out.contains(text) && tutorial.contains(text);
            assert!(is_true, "{text}: {}", output.out);
        }
        // The step in between adds a third point on the coupler.
        let curve = four_bar.replace(
            "length = 120 }",
            "length = 120, points = { E = [60, 50] } }",
        );
        assert_ne!(curve, four_bar);
        assert_eq!(check(&curve).code, 0);
        let drawn = run(&["draw", FILE, "--traces", "E"]);
        assert_eq!(drawn.code, 0, "{}", drawn.err);
        let output = check(six_bar);
        assert_eq!(output.code, 0, "{}", output.err);
        for text in &text[3..] {
            assert!(output.out.contains(text), "{text}: {}", output.out);
        }
    }
}

/// The Turkish tutorial has the same commands; another test compares them.
#[test]
fn tutorial_commands_run() {
    let here = folder("tutorial-commands");
    let (language, tutorial, _) = TUTORIALS[0];
    std::fs::write(here.join(FILE), blocks(tutorial, "toml").last().unwrap()).unwrap();
    let shown = tutorial
        .lines()
        .filter_map(|line| line.strip_prefix("    krank "));
    let mut ran = 0;
    for line in shown {
        let args: Vec<&str> = line.split(' ').map(|arg| arg.trim_matches('\'')).collect();
        let output = spoken(language, &here, &args);
        assert_eq!((output.code, output.err.as_str()), (0, ""), "{line}");
        // The numbers that the text quotes from the results.
        if args[0] == "solve" {
            for number in ["36.341", "82.276", "60.00000", "1.200000"] {
                assert!(output.out.contains(number), "{}", output.out);
            }
        }
        ran += 1;
    }
    assert_eq!(ran, 7);
}

/// `help` prints each scene of the text unchanged.
#[test]
fn help_shows_tutorial_scenes_unchanged() {
    for (language, tutorial, _) in TUTORIALS {
        let here = folder("tutorial-shown");
        let shown = spoken(language, &here, &["help", "tutorial"]).out;
        for block in blocks(tutorial, "toml") {
            let lines = block.lines().map(|line| format!("    {line}"));
            let lines: Vec<String> = lines.map(|line| line.trim_end().to_owned()).collect();
            assert!(shown.contains(&lines.join("\n")), "{shown}");
        }
    }
}
