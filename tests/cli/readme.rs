//! Tests that the README and the manual show the actual behaviour of krank.

use super::language::spoken;
use super::{command, folder, run, run_ok};

const README: &str = include_str!("../../README.md");
const SCENE: &str = include_str!("../../src/manual/english/scene.md");
const FAULTS: &str = include_str!("../../src/manual/english/faults.md");
const COMMANDS: &str = include_str!("../../src/manual/english/commands.md");

/// The Turkish versions of the chapters.
const SAHNE: &str = include_str!("../../src/manual/turkish/scene.md");
const YANLISLAR: &str = include_str!("../../src/manual/turkish/faults.md");

/// Returns the fenced blocks of a text in this language.
pub(super) fn blocks(text: &'static str, language: &str) -> Vec<&'static str> {
    let opening = format!("```{language}\n");
    let after = text.split(opening.as_str()).skip(1);
    after
        .map(|text| text.split("```").next().unwrap())
        .collect()
}

#[test]
fn readme_scene_opens() {
    let mut check = command(&["check", "-"]);
    let scene = blocks(README, "toml")[0];
    assert_eq!(scene, blocks(SCENE, "toml")[0], "the manual shows another");
    let output = run(check.write_stdin(scene));
    assert_eq!((output.code, output.err.as_str()), (0, ""));
    assert!(
        output.out.starts_with("Four-bar crank-rocker\n"),
        "{}",
        output.out
    );
}

#[test]
fn shown_output_matches_actual_output() {
    let texts = [README, SCENE, FAULTS].map(|text| blocks(text, "text"));
    let [[table], [check], [fault]] = texts.each_ref().map(Vec::as_slice) else {
        panic!("there are other blocks of output than this test knows");
    };
    assert!(run_ok(&["table", "four-bar"]).starts_with(table));
    assert_eq!(run_ok(&["check", "stephenson-six-bar"]), *check);

    let here = folder("readme");
    let broken = blocks(README, "toml")[0].replace("\"D\", length", "\"D\", lenght");
    std::fs::write(here.join("my.toml"), broken).unwrap();
    let mut command = command(&["check", "my.toml"]);
    assert_eq!(run(command.current_dir(&here)).err, *fault);

    // The Turkish chapters show the scene check and the error.
    let texts = [SAHNE, YANLISLAR].map(|text| blocks(text, "text"));
    let [[check], [fault]] = texts.each_ref().map(Vec::as_slice) else {
        panic!("there are other blocks of output than this test knows");
    };
    let printed = spoken("tr", &here, &["check", "stephenson-six-bar"]);
    assert_eq!((printed.code, printed.out.as_str()), (0, *check));
    assert_eq!(spoken("tr", &here, &["check", "my.toml"]).err, *fault);
}

/// The pictures are up to date. Their links are relative, so they work in a checkout.
#[test]
fn readme_pictures_match_draw_output() {
    let drawn = [
        ("four-bar", &["four-bar", "--traces", "--size", "58x26"][..]),
        (
            "jansen-leg",
            &["jansen-leg", "--traces", "T", "--size", "44x26"],
        ),
    ];
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, arguments) in drawn {
        let link = format!("src/manual/pictures/{name}.svg");
        assert!(README.contains(&format!("]({link})")), "{link}");
        let kept = std::fs::read_to_string(root.join(&link)).unwrap();
        let command = [&["draw"], arguments, &["--format", "svg"]].concat();
        assert!(
            kept == run_ok(&command),
            "another: krank {} -o {link}",
            command.join(" ")
        );
        assert!(kept.contains("prefers-color-scheme:dark"), "{link}");
    }
    assert_eq!(
        README.matches("![").count(),
        drawn.len(),
        "others are not compared"
    );
}

/// The blocks of a GIF are counted by their marks; what they show is tested with the feature `pictures`.
#[test]
fn readme_gifs_have_frames_and_a_link() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in ["four-bar", "four-bar-dark"] {
        let link = format!("src/manual/pictures/{name}.gif");
        assert!(README.contains(&format!("=\"{link}\">")), "{link}");
        let gif = std::fs::read(root.join(&link)).unwrap();
        assert!(gif.starts_with(b"GIF89a") && gif.ends_with(b";"), "{link}");
        assert!(gif.len() < 200_000, "{link}: {} bytes", gif.len());
        // A graphic control extension begins each frame.
        let frames = gif.windows(3).filter(|bytes| bytes == b"\x21\xf9\x04");
        assert!(frames.count() >= 60, "{link}");
    }
    assert!(README.contains(&format!("\n    krank {MOVING}\n")));
}

/// The command that wrote the moving picture.
pub(super) const MOVING: &str =
    "draw four-bar --traces --size 58x20 --width 400 --seconds 4 --format gif -o four-bar.gif";

/// Commands that end by themselves within a moment. The others open the workbench or measure times.
pub(super) const QUICK: [&str; 21] = [
    "list",
    "check",
    "table",
    "explain",
    "report",
    "draw",
    "plot",
    "sweep",
    "start",
    "motor",
    "help",
    "exercise",
    "grade",
    "cycle",
    "solve",
    "study",
    "tolerance",
    "export",
    "synthesize",
    "completions",
    "man",
];

/// Runs the quick commands among these lines in a new folder, and returns their number.
fn run_quick_commands<'a>(lines: impl Iterator<Item = &'a str>, name: &str) -> usize {
    // `krank exercise` does not overwrite the files of an earlier run.
    std::fs::remove_dir_all(folder(name)).unwrap();
    let here = folder(name);
    let mut ran = 0;
    for line in lines {
        let args: Vec<_> = line.split(' ').map(|arg| arg.trim_matches('\'')).collect();
        if QUICK.contains(&args[0]) {
            let output = run(command(&args).current_dir(&here));
            assert_eq!((output.code, output.err.as_str()), (0, ""), "{line}");
            ran += 1;
        }
    }
    ran
}

/// Commands in the README are indented by four columns, each with a comment.
#[test]
fn readme_commands_run() {
    let shown = README
        .lines()
        .filter_map(|line| line.strip_prefix("    krank "));
    let shown = shown.filter(|line| *line != MOVING);
    let shown = shown.map(|line| line.split("  ").next().unwrap().trim());
    assert_eq!(run_quick_commands(shown, "readme-commands"), 4);
    for code in [
        "cargo run --release",
        "cargo test",
        "cargo install --path .",
    ] {
        assert!(README.contains(&format!("\n    {code}")), "{code}");
    }
}

/// Each item of the chapter starts with a command. A test of the manual compares the Turkish
/// chapter's code with the English one.
#[test]
fn commands_chapter_of_the_manual_runs() {
    let shown = COMMANDS
        .lines()
        .filter_map(|line| line.strip_prefix("- `krank ")?.split('`').next());
    assert_eq!(run_quick_commands(shown, "manual-commands"), 29);
}

/// The chapter contains every command listed by `krank --help`.
#[test]
fn every_command_has_a_line_in_the_manual() {
    let help = run_ok(&["--help"]);
    let list = help.split("Commands:\n").nth(1).unwrap();
    let names = list.lines().take_while(|line| !line.is_empty());
    let names = names.filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    let names: Vec<&str> = names.filter(|name| !name.is_empty()).collect();
    assert!(names.len() > 15, "{names:?}");
    for name in names {
        assert!(COMMANDS.contains(&format!("- `krank {name}")), "{name}");
    }
}

#[test]
fn readme_and_its_sentences_are_short() {
    assert!(README.len() <= 11_000, "{} bytes", README.len());
    // Skips blocks, commands and tables.
    let pieces = README.split("```").step_by(2);
    let lines = pieces.flat_map(str::lines);
    let lines = lines.filter(|line| !line.starts_with("    ") && !line.starts_with('|'));
    // A list item or a paragraph starts a new sentence.
    let text: String = lines.fold(String::new(), |text, line| match line {
        "" => text + "\n",
        line if line.starts_with("- ") => text + "\n" + line + " ",
        line => text + line + " ",
    });
    let mut words = 0;
    for word in text.split_inclusive([' ', '\n']) {
        words += usize::from(!word.trim().is_empty());
        assert!(
            words <= 25,
            "a sentence of more than 25 words ends with {word:?}"
        );
        let end = word.trim_end().trim_end_matches([')', '*', '`']);
        if word.ends_with('\n') || end.ends_with(['.', ':', ';', '?', '!']) {
            words = 0;
        }
    }
}
