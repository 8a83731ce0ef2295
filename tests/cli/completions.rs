//! Completion scripts have the names that can be typed.

use super::{presets, run_ok};

const SHELLS: [&str; 6] = ["bash", "elvish", "fish", "nushell", "powershell", "zsh"];

#[test]
fn every_shell_has_commands_presets_tasks_and_topics() {
    for shell in SHELLS {
        let script = run_ok(&["completions", shell]);
        assert!(script.contains("sweep"), "{shell}");
        // The generators for these two list the values of options alone.
        if !["elvish", "powershell"].contains(&shell) {
            let mut names = presets();
            names.extend(["stirrer", "tutorial"].map(str::to_owned));
            for name in names {
                assert!(script.contains(&name), "{shell}: {name}");
            }
        }
    }
    let names = presets().join(" ");
    let script = run_ok(&["completions", "zsh"]);
    assert!(script.contains(&format!(":{{compadd {names}; _files}}'")));
    // A command is the first word, not the second.
    assert!(script.contains("case $line[1] in") && !script.contains("$line[2]"));
    assert!(script.contains(&format!("    compadd {names}\n    _files\n")));
    let script = run_ok(&["completions", "fish"]);
    let line = |command: &str, names: &str| {
        format!("complete -c krank -n \"__fish_krank_using_subcommand {command}\" -a \"{names}\"\n")
    };
    assert!(script.contains(&line("export", &names)));
    assert!(script.contains(&line(
        "synthesize",
        "wiper hatch logarithm straight-line stirrer"
    )));
    assert!(!script.contains(&line("list", &names)));
}

/// Columns: `--columns` of five commands, and `--against` of plots. Values of the whole motion:
/// `--columns` of studies, and four options of `solve`.
#[test]
fn options_with_names_of_the_scene_look_them_up() {
    for (shell, call) in [
        ("bash", "                    _krank_NAMES\n"),
        ("fish", " -a \"(__fish_complete_list , __krank_NAMES)\"\n"),
        ("nushell", "    NAMES-of $context\n"),
        ("zsh", ":_krank_NAMES' \\\n"),
    ] {
        let script = run_ok(&["completions", shell]);
        assert!(!script.contains("KRANK-"), "{shell}");
        for (names, options) in [("columns", 6), ("figures", 5)] {
            let calls = script.matches(&call.replace("NAMES", names)).count();
            assert_eq!(calls, options, "{shell} {names}");
        }
        let look_up = script.matches("--columns '*' --format csv").count();
        assert_eq!(look_up, 1, "{shell}");
    }
}

/// Returns what bash lists after these words.
#[cfg(target_os = "linux")]
fn listed(words: &[&str]) -> Vec<String> {
    let program = std::path::Path::new(env!("CARGO_BIN_EXE_krank"));
    let path = std::env::var_os("PATH").unwrap();
    let folders = std::env::split_paths(&path);
    let folders = [program.parent().unwrap().to_owned()]
        .into_iter()
        .chain(folders);
    let script = r#"source <(krank completions bash)
        COMP_WORDS=(krank "$@") COMP_CWORD=$#
        _krank krank "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD-1]}"
        printf '%s\n' "${COMPREPLY[@]}""#;
    let mut bash = std::process::Command::new("bash");
    bash.args(["--norc", "-c", script, "bash"]).args(words);
    let output = bash
        .env("PATH", std::env::join_paths(folders).unwrap())
        .output();
    let output = output.unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines().map(str::to_owned).collect()
}

#[cfg(target_os = "linux")]
#[test]
fn bash_lists_the_columns_of_the_scene() {
    let listed_columns = listed(&["table", "four-bar", "--columns", "C.v"]);
    assert_eq!(listed_columns, ["C.vx", "C.vy"]);
    // Numbers of options are no scenes, and a list continues after its comma.
    let words = [
        "sweep",
        "--from",
        "0",
        "slider-crank",
        "--columns",
        "C.x,C.a",
    ];
    assert_eq!(listed(&words), ["C.x,C.ax", "C.x,C.ay"]);
    assert_eq!(listed(&["plot", "four-bar", "--against", "driver.p"]), [""]);
    assert_eq!(listed(&["table", "no-scene", "--columns", "C"]), [""]);
    assert!(listed(&["table", "jans"]).contains(&"jansen-leg".to_owned()));
}

#[cfg(target_os = "linux")]
#[test]
fn bash_lists_values_of_the_whole_motion() {
    let study = ["study", "four-bar", "--vary", "r2.length=90..110/3"];
    let with = |words: &[&'static str]| listed(&[&study[..], words].concat());
    let minima = with(&["--columns", "range.low,C.x.le"]);
    assert_eq!(minima, ["range.low,C.x.least.at", "range.low,C.x.least"]);
    assert_eq!(with(&["--columns", "trans"]), ["transmission"]);
    // Properties follow a complete column only.
    assert_eq!(with(&["--columns", "C.vx"]), ["C.vx"]);
    let goal = ["solve", "four-bar", "--goal", "r4.angle.sw"];
    assert_eq!(listed(&goal), ["r4.angle.swing"]);
}
