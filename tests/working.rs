//! The working shown: it can be followed line by line, is complete, and says what the solver says.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use krank::report::{Block, LineKind, TextStyle, Worked, Working};
use krank::scene::{Scene, presets};
use krank::solver::{Condition, Order, Range, Solver, State};

const PLAIN: TextStyle = TextStyle {
    ascii: true,
    width: 80,
};

/// A scene with its solver, its working and a state.
struct Bench {
    scene: Scene,
    solver: Solver,
    working: Working,
    state: State,
}

impl Bench {
    fn of(name: &str) -> Bench {
        let preset = presets::find(name).unwrap();
        Bench::parsed(preset.text, name)
    }

    fn parsed(text: &str, name: &str) -> Bench {
        let scene = Scene::parse(text, name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        Bench {
            working: Working::new(&scene, &solver),
            state: solver.state(),
            scene,
            solver,
        }
    }

    fn at(&mut self, at: f64, digits: usize) -> Worked {
        self.solver.solve(at, Order::Force, &mut self.state);
        self.working
            .of(&self.scene, &self.solver, &self.state, digits)
    }

    /// Coordinates all over the motion, its ends and what lies beyond among them.
    fn places(&self) -> Vec<f64> {
        let (low, high) = match self.solver.motion().range {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        };
        let step = (high - low) / 24.0;
        let mut places: Vec<f64> = (0..=24).map(|k| low + step * f64::from(k)).collect();
        let motion = self.solver.motion();
        places.extend(motion.change_points.iter().chain(&motion.dead_points));
        places.extend([low - step, high + step, self.scene.mechanism.driver().start]);
        places
    }
}

fn text(worked: &Worked) -> String {
    worked.document.to_text(PLAIN)
}

// ---- the solver's figures

/// What the printed formulas lose: a few roundings of their terms.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

#[test]
fn every_figure_that_is_worked_out_is_the_solvers() {
    for preset in presets::all() {
        let mut bench = Bench::of(preset.name);
        for at in bench.places() {
            let worked = bench.at(at, 6);
            for agreement in &worked.agreements {
                assert!(
                    agreement.part() <= ROUNDING,
                    "{} at {at} ({:?}): {agreement:?} off by {:e}",
                    preset.name,
                    bench.state.condition(),
                    agreement.part()
                );
            }
            let rates = bench.state.condition() == Condition::Ok;
            assert!(
                !rates || !worked.agreements.is_empty(),
                "{} at {at}",
                preset.name
            );
        }
    }
}

// ---- complete, finite, plain

#[test]
fn every_presets_working_names_everything_and_is_plain() {
    for preset in presets::all() {
        let mut bench = Bench::of(preset.name);
        for at in bench.places() {
            let worked = bench.at(at, 6);
            let text = text(&worked);
            let context = format!("{} at {at}:\n{text}", preset.name);
            assert!(text.is_ascii(), "{context}");
            let mut words = text.split(|c: char| !c.is_alphanumeric());
            assert!(
                !words.any(|word| matches!(word, "NaN" | "inf")),
                "{context}"
            );
            let rows: Vec<&str> = text.lines().map(str::trim_start).collect();
            let has_row = |name: &str| rows.iter().any(|row| row.split(' ').next() == Some(name));
            for vector in &bench.scene.vectors {
                assert!(has_row(&vector.name), "{}: {context}", vector.name);
            }
            for link in bench.scene.mechanism.link_ids() {
                let name = bench.scene.link_name(link);
                assert!(has_row(name), "{name}: {context}");
            }
            for number in 1..=bench.solver.plan().groups.len() {
                assert!(text.contains(&format!("Group {number}, ")), "{context}");
            }
            let markdown = worked.document.to_markdown(true);
            assert!(
                markdown.is_ascii() && markdown.starts_with("# "),
                "{markdown}"
            );
        }
    }
}

#[test]
fn lines_keep_within_their_width() {
    for preset in presets::all() {
        let mut bench = Bench::of(preset.name);
        let start = bench.scene.mechanism.driver().start;
        let worked = bench.at(start, 6);
        for width in [20, 38, 78, 118] {
            for ascii in [false, true] {
                let style = TextStyle { ascii, width };
                for (kind, line) in worked.document.lines(style) {
                    let columns = line.chars().count();
                    let name = preset.name;
                    assert!(
                        columns <= width,
                        "{name}: {columns} of {width}: {kind:?} {line}"
                    );
                    assert_eq!(line, line.trim_end(), "{name}");
                }
            }
        }
    }
}

/// Nothing of a formula is lost where it is broken into lines.
#[test]
fn broken_lines_hold_every_word() {
    let words = |lines: Vec<(LineKind, String)>| -> String {
        let all = lines.into_iter().map(|(_, line)| line);
        all.flat_map(|line| {
            line.chars()
                .filter(|c| !c.is_whitespace())
                .collect::<Vec<_>>()
        })
        .collect()
    };
    let mut bench = Bench::of("four-bar");
    let mut worked = bench.at(60.0, 9);
    // Tables repeat their first column.
    worked
        .document
        .blocks
        .retain(|block| !matches!(block, Block::Table(_)));
    let style = |width| TextStyle {
        ascii: false,
        width,
    };
    let whole = words(worked.document.lines(style(10_000)));
    for width in [12, 20, 38, 60, 80] {
        assert_eq!(words(worked.document.lines(style(width))), whole, "{width}");
    }
}

// ---- the loops

fn loops(name: &str) -> Vec<String> {
    let mut bench = Bench::of(name);
    let start = bench.scene.mechanism.driver().start;
    let text = text(&bench.at(start, 6));
    let part = text.split("2 Position table").next().unwrap();
    let lines = part.lines().filter(|line| line.ends_with(" = 0"));
    lines.map(|line| line.trim().to_owned()).collect()
}

#[test]
fn the_loops_are_those_of_the_lectures() {
    assert_eq!(loops("four-bar"), ["r1 + r2 + r3 + r4 = 0"]);
    assert_eq!(loops("slider-crank"), ["r2 + r3 + r4 = 0"]);
    assert_eq!(loops("slotted-lever"), ["r2 + r3 - r1 = 0"]);
    // Two loops, the second from the ternary link to the ram, whose guide runs through Q.
    assert_eq!(
        loops("press-ram"),
        ["r1 + r2 + r3 - r4 = 0", "QD + r4e + r5 + r6 = 0"]
    );
    assert_eq!(loops("excavator-boom"), ["r2 + rod - r1 = 0"]);
    assert_eq!(loops("jansen-leg").len(), 3);
    assert_eq!(loops("stephenson-six-bar").len(), 2);
}

/// As many independent loops as the structure has: joints less moving links.
#[test]
fn a_scene_has_as_many_loops_as_its_structure() {
    for (name, count) in [
        ("watt-six-bar", 2),
        ("klann-leg", 2),
        // Two of them tell further vectors, OB and OP.
        ("peaucellier", 5),
        ("triple-parallelogram", 2),
        ("kite", 1),
    ] {
        assert_eq!(loops(name).len(), count, "{name}: {:?}", loops(name));
    }
}
