//! Tests that every command of the manual runs and every scene in it opens, in both languages.

use super::language::spoken;
use super::readme::QUICK;
use super::synthesize::arguments;
use super::{command, folder, run, run_ok};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Chapters whose indented commands have their own tests, since they need the files of the chapter.
const TESTED: [&str; 2] = ["synthesis.md", "tutorial.md"];

/// This command takes a minute in a debug build; `tolerances.md` has shorter ones.
const SLOW_COMMAND: &str = "tolerance SCENE --tolerance 0.1";

/// Arguments that replace placeholders of the manual.
const REPLACED: [(&str, &str); 8] = [
    ("SCENE", "four-bar-load"),
    ("TASK", "hatch"),
    ("FILE", "measured.csv"),
    ("--seed N", "--seed 3"),
    ("--count 100", "--count 8"),
    ("--count 30", "--count 3"),
    (" | head -n 1", ""),
    ("answered/*.csv", "answered/four-bar-7.csv"),
];

/// Returns name and text of each chapter in a language.
pub(super) fn chapters(language: &str) -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = fs::read_dir(root.join("src/manual").join(language)).unwrap();
    let mut chapters: Vec<(String, String)> = files
        .map(|file| {
            let file = file.unwrap();
            let name = file.file_name().into_string().unwrap();
            (name, fs::read_to_string(file.path()).unwrap())
        })
        .collect();
    chapters.sort();
    assert!(chapters.len() > 15, "{}", chapters.len());
    chapters
}

/// Returns the commands of a chapter in blocks, and those in sentences that name a scene or a task.
fn commands(name: &str, text: &str) -> Vec<String> {
    let lines = text.lines();
    let indented = lines.filter_map(|line| line.strip_prefix("    krank "));
    let indented = indented.filter(|_| !TESTED.contains(&name));
    let one_line = text.replace('\n', " ");
    let spans = one_line.split('`').skip(1).step_by(2);
    let spans = spans.filter_map(|span| span.strip_prefix("krank "));
    let in_sentences = spans.filter(|span| span.contains("SCENE") || span.contains("TASK"));
    let all = indented.chain(in_sentences);
    let all = all.filter(|line| {
        QUICK
            .iter()
            .any(|quick| line.split(' ').next() == Some(quick))
    });
    let in_pixels = |line: &str| line.ends_with(".png") || line.ends_with(".gif");
    let all = all.filter(|line| cfg!(feature = "pictures") || !in_pixels(line));
    all.filter(|line| *line != SLOW_COMMAND)
        .map(str::to_owned)
        .collect()
}

/// Creates a folder with the files that commands of the manual read.
fn prepared(name: &str) -> PathBuf {
    let here = folder(&format!("manual-{name}"));
    fs::remove_dir_all(&here).unwrap();
    fs::create_dir_all(here.join("answered")).unwrap();
    let press = include_str!("../../presets/press.toml");
    fs::write(here.join("press.toml"), format!("tolerance = 0.1\n{press}")).unwrap();
    let values = run_ok(&["sweep", "four-bar-load", "--columns", "C.x", "--step", "30"]);
    fs::write(here.join("measured.csv"), values).unwrap();
    fs::write(here.join("points.csv"), "P.x,P.y\n0,180\n10,190\n").unwrap();
    let drawing = include_str!("../import/fastened.linkage2");
    fs::write(here.join("leg.linkage2"), drawing).unwrap();
    let class = ["exercise", "four-bar", "--seed", "7", "-o", "class"];
    assert_eq!(run(command(&class).current_dir(&here)).code, 0);
    for answers in ["answers.csv", "answered/four-bar-7.csv"] {
        fs::copy(here.join("class/four-bar-7.csv"), here.join(answers)).unwrap();
    }
    here
}

/// Only the English chapters are run: a test of the manual compares the code of the Turkish ones.
#[test]
fn every_command_of_the_manual_runs() {
    let mut ran = 0;
    for (name, text) in chapters("english") {
        let commands = commands(&name, &text);
        if commands.is_empty() {
            continue;
        }
        let here = prepared(&name);
        for shown in commands {
            let replaced = REPLACED.iter();
            let line = replaced.fold(shown.clone(), |line, (word, with)| line.replace(word, with));
            let output = run(command(&arguments(&line)).current_dir(&here));
            assert_eq!(output.code, 0, "{name}: krank {shown}: {}", output.err);
            let is_note = |line: &str| line.starts_with("note: ");
            assert!(
                output.err.lines().all(is_note),
                "{name}: krank {shown}: {}",
                output.err
            );
            ran += 1;
        }
    }
    let in_pixels = if cfg!(feature = "pictures") { 2 } else { 0 };
    assert_eq!(ran, 60 + in_pixels);
}

/// Commands in sentences that open the workbench, lack an argument, or have a test of their own because they need the
/// files of the chapter or much time.
const NOT_RUN: [&str; 15] = [
    // The workbench.
    "my.toml",
    "my-press.toml",
    "four-bar",
    "slider-crank",
    "press",
    "six-bar.toml",
    "leg.linkage2",
    "synthesize wiper --view",
    "--language tr",
    // An argument is left out.
    "sweep --measured",
    // The tutorial and the exercises.
    "check six-bar.toml",
    "cycle six-bar.toml --columns output.angle",
    "draw six-bar.toml --traces E",
    "grade class *.csv",
    // Slow.
    SLOW_COMMAND,
];

/// Commands in sentences are run, except those that are listed. A name alone must be that of a command.
#[test]
fn every_command_in_a_sentence_runs() {
    let help = run_ok(&["--help"]);
    // `krank --help` does not list every command.
    let is_command = |word: &str| QUICK.contains(&word) || help.contains(&format!("\n  {word} "));
    let readme = include_str!("../../README.md").to_owned();
    let mut chapters = chapters("english");
    chapters.push(("README.md".to_owned(), readme));
    let (mut ran, mut left) = (0, BTreeSet::new());
    for (name, text) in chapters {
        // Fences are longer than the marks of a span.
        let prose: String = text.split("```").step_by(2).collect();
        let here = prepared(&format!("sentences-{name}"));
        let one_line = prose.split_whitespace().collect::<Vec<_>>().join(" ");
        let spans = one_line.split('`').skip(1).step_by(2);
        for shown in spans.filter_map(|span| span.strip_prefix("krank ")) {
            if let Some(listed) = NOT_RUN.iter().find(|listed| **listed == shown) {
                left.insert(*listed);
                continue;
            }
            let words = arguments(shown);
            if words.len() == 1 && !words[0].starts_with('-') && words[0] != "list" {
                assert!(is_command(words[0]), "{name}: krank {shown}");
                continue;
            }
            // Other tests run these.
            let is_generic = ["SCENE", "TASK"].iter().any(|word| shown.contains(word));
            let is_listed = name == "commands.md" && QUICK.contains(&words[0]);
            if is_generic || is_listed || words[0] == "help" {
                continue;
            }
            // A sentence may leave the scene out.
            let mut words = words;
            if is_command(words[0]) && words.get(1).is_some_and(|word| word.starts_with('-')) {
                words.insert(1, "four-bar");
            }
            let output = run(command(&words).current_dir(&here));
            assert_eq!(
                (output.code, output.err.as_str()),
                (0, ""),
                "{name}: krank {shown}"
            );
            ran += 1;
        }
    }
    assert_eq!(left, NOT_RUN.iter().copied().collect());
    assert!(ran > 5, "{ran}");
}

const GROUND: (&str, &str) = ("[ground]", "A = [0, 0]\nD = [400, 0]");
const DRIVER: (&str, &str) = ("[driver]", "link = 'r2'\nangle = 60\nspeed = '15 rad/s'");
const R2: (&str, &str) = ("[links]", "r2 = { from = 'A', to = 'B', length = 100 }");
const R3: (&str, &str) = (
    "[links]",
    "r3 = { from = 'B', to = 'C', length = 300, com = [150, 0] }",
);
const R4: (&str, &str) = ("[links]", "r4 = { from = 'D', to = 'C', length = 250 }");
const START: (&str, &str) = ("[start]", "C = [310, 230]");

/// A chapter, a piece of its part, and the lines that complete the part.
type Part = (
    &'static str,
    &'static str,
    &'static [(&'static str, &'static str)],
);

/// The partial scenes in the manual: the chapter, a piece that only this part contains, and the
/// lines that complete it, below their headings.
const PARTS: [Part; 12] = [
    ("scene.md", "[copies]", &[GROUND, DRIVER, R2, R3, R4, START]),
    (
        "scene.md",
        "slide    = \"path\"",
        &[
            ("[ground]", "A = [-60, 0]\nE = [60, 0]"),
            R2,
            ("[links]", "r3 = { from = 'B', to = 'P', length = 140 }"),
            ("[links]", "r4 = { from = 'D', to = 'P', length = 140 }"),
            ("[links]", "r5 = { from = 'E', to = 'D', length = 100 }"),
            ("[start]", "B = [-110, 87]\nD = [110, 87]"),
        ],
    ),
    (
        "scene.md",
        "[lead]",
        &[
            ("[ground]", "A = [-60, 0]\nE = [60, 0]"),
            ("[driver]", "link = 'r2'\nangle = 120"),
            ("[inputs]", "r5 = { at = 60 }"),
            R2,
            ("[links]", "r3 = { from = 'B', to = 'P', length = 140 }"),
            ("[links]", "r4 = { from = 'D', to = 'P', length = 140 }"),
            ("[links]", "r5 = { from = 'E', to = 'D', length = 100 }"),
            ("[start]", "P = [0, 173]"),
        ],
    ),
    (
        "scene.md",
        "link = \"ram\"",
        &[
            ("[ground]", "A = [0, 0]"),
            DRIVER,
            R2,
            R3,
            ("[links]", "rod = { from = 'C', to = 'E', length = 400 }"),
            ("[links]", "ram = { points = { E = [0, 0] } }"),
            ("[start]", "C = [350, 0]\nE = [560, 340]"),
        ],
    ),
    (
        "scene.md",
        "ratio = -1",
        &[
            (
                "[ground]",
                "A = [0, 0]\nG = [400, 0]\nH = [0, 600]\nJ = [300, 600]",
            ),
            DRIVER,
            ("[driver]", "range = [0, 360]"),
            R2,
            R3,
            ("[links]", "r5 = { from = 'F', to = 'C', length = 350 }"),
            ("[links]", "r7 = { from = 'G', to = 'F', length = 60 }"),
            ("[links]", "barrel = { points = { H = [0, 0] } }"),
            ("[links]", "boom = { from = 'J', to = 'P', length = 300 }"),
            (
                "[slides]",
                "rod = { point = 'P', on = 'barrel', through = 'H', angle = 0 }",
            ),
            ("[start]", "C = [200, 280]\nP = [150, 800]"),
        ],
    ),
    (
        "scene.md",
        "bucket = { over",
        &[
            (
                "[ground]",
                "O = [0, -0.5]\nQ = [0, 0]\nH = [1, 3]\nA = [3, 0]\nR = [1.9, 3]",
            ),
            (
                "[driver]",
                "slide = 'rod'\nposition = 1.1\nrange = [1.0, 1.3]",
            ),
            ("[links]", "barrel = { points = { O = [0, 0] } }"),
            ("[links]", "boom = { from = 'Q', to = 'P', length = 1 }"),
            ("[links]", "cylinder = { points = { H = [0, 0] } }"),
            ("[links]", "scoop = { from = 'R', to = 'S', length = 1 }"),
            ("[links]", "r7 = { from = 'A', to = 'B', length = 1 }"),
            (
                "[slides]",
                "rod = { point = 'P', on = 'barrel', through = 'O', angle = 0 }",
            ),
            (
                "[slides]",
                "bucket = { point = 'S', on = 'cylinder', through = 'H', angle = 0 }",
            ),
            ("[start]", "P = [0.9, 0.3]\nS = [1.1, 3.2]"),
        ],
    ),
    ("scene.md", "motion = [", &[GROUND, R2, R3, R4, START]),
    (
        "scene.md",
        "[limits]",
        &[
            GROUND,
            ("[ground]", "O = [-100, 0]"),
            DRIVER,
            R2,
            R3,
            R4,
            ("[links]", "barrel = { points = { O = [0, 0] } }"),
            (
                "[slides]",
                "rod = { point = 'B', on = 'barrel', through = 'O', angle = 0 }",
            ),
            START,
        ],
    ),
    (
        "scene.md",
        "[[springs]]",
        &[
            GROUND,
            DRIVER,
            R2,
            R3,
            R4,
            ("[links]", "r5 = { from = 'C', to = 'E', length = 400 }"),
            (
                "[slides]",
                "r6 = { point = 'E', on = 'ground', through = [560, 0], angle = 90 }",
            ),
            START,
            ("[start]", "E = [560, 540]"),
        ],
    ),
    (
        "scene.md",
        "[parameters]",
        &[
            ("[ground]", "A = [0, 0]\nD = [300, 0]"),
            ("[start]", "C = [200, 200]"),
        ],
    ),
    (
        "columns.md",
        "[figures]",
        &[
            GROUND,
            ("[driver]", "link = 'armR'\nangle = 60"),
            ("[links]", "armR = { from = 'A', to = 'B', length = 100 }"),
            R3,
            ("[links]", "armL = { from = 'C', to = 'D', length = 250 }"),
            START,
        ],
    ),
    (
        "tolerances.md",
        "[clearances]",
        &[GROUND, DRIVER, R2, R4, START],
    ),
];

/// Returns the TOML blocks in a chapter, including those within list items.
fn blocks(text: &str) -> Vec<String> {
    let mut blocks = Vec::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line.trim_start() == "```toml" {
            let indent = line.len() - line.trim_start().len();
            let block = lines.by_ref().map(|line| line.get(indent..).unwrap_or(""));
            let block = block.take_while(|line| *line != "```");
            blocks.push(block.fold(String::new(), |text, line| text + line + "\n"));
        }
    }
    blocks
}

/// Completes a part of a scene with each of these lines below its heading.
fn completed(part: &str, lines: &[(&str, &str)]) -> String {
    let mut scene = format!("\n{part}");
    for (heading, line) in lines {
        let starts = scene.find(&format!("\n{heading}"));
        let end = starts.and_then(|at| Some(at + 1 + scene[at + 1..].find('\n')?));
        match end {
            Some(end) => scene.insert_str(end, &format!("\n{line}")),
            None => scene += &format!("\n{heading}\n{line}\n"),
        }
    }
    scene
}

#[test]
fn every_scene_of_the_manual_opens() {
    let here = folder("manual-scenes");
    let opens = |language: &str, name: &str, scene: &str| {
        fs::write(here.join("my.toml"), scene).unwrap();
        let arguments = match scene.contains("\nposes = ") {
            true => &["synthesize", "my.toml", "--top", "1"][..],
            false => &["check", "my.toml"],
        };
        let output = spoken(language, &here, arguments);
        assert_eq!(output.code, 0, "{name}: {scene}\n{}", output.err);
    };
    for (folder, language) in [("english", "en"), ("turkish", "tr")] {
        let mut opened = 0;
        for (name, text) in chapters(folder) {
            // The tutorial's steps and the configuration have their own tests.
            if ["tutorial.md", "keys.md"].contains(&name.as_str()) {
                continue;
            }
            for block in blocks(&text) {
                let part = PARTS
                    .iter()
                    .find(|(chapter, piece, _)| *chapter == name && block.contains(piece));
                let lines = part.map_or(&[][..], |(_, _, lines)| lines);
                opens(language, &name, &completed(&block, lines));
                opened += 1;
            }
        }
        assert_eq!(opened, PARTS.len() + 3, "{folder}");
    }
}
