//! Checks that control, bidirectional and invisible characters in names, titles, notes and file
//! names never reach a terminal, wherever a scene, a folder, a configuration or an error is shown.

use krank::scene::is_harmful;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Clears the screen, sets the title, reverses the writing direction, and contains invisible
/// characters.
const CONTROL_TEXT: &str = "a\u{1b}[2J\u{1b}]0;b\u{7}\u{9b}31mc\u{202e}d\u{200b}e\u{2066}f\u{feff}";

/// [`CONTROL_TEXT`] in TOML: raw where TOML allows it, escaped elsewhere.
const CONTROL_SCENE: &str =
    "a\\u001b[2J\\u001b]0;b\\u0007\\u009b31mc\u{202e}d\u{200b}e\\u2066f\u{feff}\\u007f";

fn hostile() -> String {
    format!(
        "# {bare}\nname = \"{CONTROL_SCENE}\"\nsource = \"{CONTROL_SCENE}\"\nnote = \"{CONTROL_SCENE}\"\n\
         [ground]\nA = [0, 0]\nD = [400, 0] # {bare}\n[driver]\nlink = \"r2\"\nangle = 60\nspeed = \"15 rad/s\"\n\
         [links]\nr2 = {{ from = \"A\", to = \"B\", length = 100 }}\n\
         r3 = {{ from = \"B\", to = \"C\", length = 300, com = [150, 0] }}\n\
         r4 = {{ from = \"C\", to = \"D\", length = 250 }}\n[start] # {bare}\nC = [310, 230]\n",
        bare = "a\u{202e}d\u{200b}e\u{2066}f\u{feff}",
    )
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Asserts that a text has no harmful characters except line feeds and, if `ascii`, only ASCII.
fn assert_harmless(text: &str, ascii: bool, what: &str) {
    let bad = |c: char| c != '\n' && (is_harmful(c) || ascii && !c.is_ascii());
    assert!(!text.contains(bad), "{what}: {text:?}");
}

/// Runs the program in an ASCII locale and in a UTF-8 locale.
fn run_in_both_locales(here: &Path, args: &[&str]) -> [(bool, Output); 2] {
    ["C", "C.UTF-8"].map(|locale| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_krank"));
        command.env_clear().env("TERM", "xterm-256color");
        command.env("LC_ALL", locale).current_dir(here).args(args);
        (locale == "C", command.output().unwrap())
    })
}

fn assert_harmless_output(here: &Path, args: &[&str], code: i32) {
    for (ascii, output) in run_in_both_locales(here, args) {
        let printed = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{args:?}: {printed}");
        assert_harmless(&printed, ascii, &format!("{args:?}"));
        let out = String::from_utf8(output.stdout).unwrap();
        // SVG and JSON are always UTF-8.
        let ascii = ascii && !args.contains(&"svg") && !args.contains(&"json");
        assert_harmless(&out, ascii, &format!("{args:?}"));
    }
}

#[test]
fn commands_print_no_control_characters_of_a_scene() {
    let here = folder("harmless-scene");
    let file = format!("{CONTROL_TEXT}.toml").replace('/', "");
    std::fs::write(here.join(&file), hostile()).unwrap();
    let file = file.as_str();
    for args in [
        &["check", file][..],
        &["check", file, "--format", "json"],
        &["table", file],
        &["table", file, "--bounds", "--sensitivity"],
        &["table", file, "--format", "csv"],
        &["table", file, "--format", "json"],
        &["sweep", file, "--step", "90"],
        &["sweep", file, "--step", "90", "--format", "text"],
        &["sweep", file, "--step", "90", "--format", "json"],
        &["draw", file],
        &["draw", file, "--format", "svg"],
        &["plot", file, "--columns", "C.x"],
        &["plot", file, "--columns", "C.x", "--format", "svg"],
        &["accuracy", file, "--positions", "1", "--format", "json"],
    ] {
        assert_harmless_output(&here, args, 0);
    }
    // `start` prints the file itself, byte for byte, since it is not meant for a terminal.
    let [_, (_, output)] = run_in_both_locales(&here, &["start", file]);
    assert!(
        String::from_utf8(output.stdout)
            .unwrap()
            .contains('\u{202e}')
    );
}

#[test]
fn error_messages_contain_no_control_characters() {
    let here = folder("harmless-faults");
    let file = format!("{CONTROL_TEXT}.toml").replace('/', "");
    let broken = hostile()
        .replace("length = 300", &format!("lenght = \"{CONTROL_SCENE}\""))
        .replace("r4 = {", &format!("\"{CONTROL_SCENE}\" = {{"));
    std::fs::write(here.join(&file), broken).unwrap();
    let raw = format!("{file}-raw.toml");
    std::fs::write(
        here.join(&raw),
        format!("name = \"{CONTROL_TEXT}\"\n{CONTROL_TEXT} = 1\n"),
    )
    .unwrap();
    for file in [
        file.as_str(),
        raw.as_str(),
        "no\u{1b}[2J\u{202e}file.toml",
        CONTROL_TEXT,
    ] {
        for command in ["check", "table", "sweep", "draw", "start", "accuracy"] {
            assert_harmless_output(&here, &[command, file], 2);
        }
        assert_harmless_output(&here, &[file], 2);
    }
    for args in [
        &["check", "four-bar", CONTROL_TEXT][..],
        &[CONTROL_TEXT, "four-bar"],
        &["man", CONTROL_TEXT],
        &["completions", CONTROL_TEXT],
        &["table", "four-bar", "--at", CONTROL_TEXT],
        &["check", "four-bar", "--assembly", CONTROL_TEXT],
        &["sweep", "four-bar", "--columns", CONTROL_TEXT],
        &["plot", "four-bar", "--columns", CONTROL_TEXT],
        &[
            "plot",
            "four-bar",
            "--columns",
            "C.x",
            "--against",
            CONTROL_TEXT,
        ],
    ] {
        assert_harmless_output(&here, args, 2);
    }
    let lost = format!("nowhere/{CONTROL_TEXT}");
    assert_harmless_output(&here, &["table", "four-bar", "-o", &lost], 1);
}

#[cfg(feature = "tui")]
mod workbench {
    use super::{CONTROL_SCENE, CONTROL_TEXT, assert_harmless_output, folder, hostile};
    use krank::drawing::Glyphs;
    use krank::scene::{Scene, is_harmful};
    use krank::solver::Solver;
    use krank::tui::{Colours, OpenedScene, Origin, Workbench};

    #[test]
    fn printed_views_and_configuration_errors_are_harmless() {
        let here = folder("harmless-print");
        let file = format!("{CONTROL_TEXT}.toml").replace('/', "");
        std::fs::write(here.join(&file), hostile()).unwrap();
        for view in [
            "motion", "tables", "plots", "forces", "scene", "lengths", "working",
        ] {
            assert_harmless_output(&here, &["--print", "--view", view, &file], 0);
        }
        let config = format!("{CONTROL_TEXT}-config.toml").replace('/', "");
        for text in [
            format!("\"{CONTROL_SCENE}\" = 1\n"),
            format!("glyphs = \"{CONTROL_SCENE}\"\n"),
            format!("[keys]\n\"{CONTROL_SCENE}\" = \"x\"\nplay = \"{CONTROL_SCENE}\"\n"),
            CONTROL_TEXT.to_owned(),
        ] {
            std::fs::write(here.join(&config), text).unwrap();
            assert_harmless_output(&here, &["--config", &config], 2);
        }
        assert_harmless_output(&here, &["--config", "no\u{1b}\u{202e}file"], 2);
    }

    /// Covers every view, overlay, prompt and message, in every set of glyphs.
    #[test]
    fn frames_contain_no_control_characters_of_a_scene() {
        let here = folder("harmless-frames");
        let file = here.join(format!("{CONTROL_TEXT}.toml").replace('/', ""));
        std::fs::write(&file, hostile()).unwrap();
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            for (cols, rows) in [(80, 24), (40, 12), (160, 50)] {
                let scene = Scene::parse(&hostile(), &file.display().to_string()).unwrap();
                let solver = Solver::new(&scene.mechanism).unwrap();
                let origin = Origin::File(file.clone());
                let opened = OpenedScene {
                    scene,
                    solver,
                    origin,
                };
                let mut workbench = Workbench::new(opened, glyphs, Colours::None, cols, rows);
                workbench.paint();
                for key in [
                    "i", "v", "T", "2", "3", "4", "Esc", "5", "6", "e", "1", "?", "/", "Esc",
                    "Esc", "I", "Esc", "a", "Esc", "w", "Esc", "W", "Esc", "o", "Down", "Up",
                    "Esc", "D", "Down", "Esc", "R", "Esc", "6", "Enter", "x", "Enter", "Esc", "u",
                    "P", "Esc", "S", "Esc", "2", "Y", "Esc",
                ] {
                    workbench.press(key);
                    let frame = String::from_utf8(workbench.paint().to_vec()).unwrap();
                    let shown = without_sequences(&frame);
                    // The painter moves the cursor with these. The scene contains none of them.
                    let moves = ['\r', '\n', '\u{8}'];
                    let bad = |c: char| !moves.contains(&c) && is_harmful(c);
                    assert!(!shown.contains(bad), "{glyphs:?} {key}: {shown:?}");
                    assert!(
                        glyphs != Glyphs::Ascii || shown.is_ascii(),
                        "{key}: {shown:?}"
                    );
                }
            }
        }
    }

    /// Removes the sequences that the painter writes: cursor, styles, erasing, modes.
    fn without_sequences(frame: &str) -> String {
        let mut pieces = frame.split("\u{1b}[");
        let mut shown = pieces.next().unwrap_or_default().to_owned();
        for piece in pieces {
            let end = piece.find(|c: char| c.is_ascii_alphabetic()).unwrap();
            let ours = matches!(
                &piece[end..=end],
                "H" | "m" | "K" | "J" | "h" | "l" | "A" | "B" | "C" | "D" | "G" | "d" | "X"
            );
            assert!(ours, "an unknown sequence: {piece:?}");
            // The scene's own sequence must not appear.
            assert_ne!(&piece[..=end], "31m");
            shown.push_str(&piece[end + 1..]);
        }
        shown
    }
}
