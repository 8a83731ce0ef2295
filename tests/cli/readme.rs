//! What the README shows is what krank does.

use super::{command, done, folder, run};

const README: &str = include_str!("../../README.md");

/// The blocks of the README in this language.
fn blocks(language: &str) -> Vec<&'static str> {
    let opening = format!("```{language}\n");
    let behind = README.split(opening.as_str()).skip(1);
    behind
        .map(|text| text.split("```").next().unwrap())
        .collect()
}

#[test]
fn the_scene_of_the_readme_opens() {
    let mut check = command(&["check", "-"]);
    let heard = run(check.write_stdin(blocks("toml")[0]));
    assert_eq!((heard.code, heard.err.as_str()), (0, ""));
    assert!(
        heard.out.starts_with("Four-bar crank-rocker\n"),
        "{}",
        heard.out
    );
}

#[test]
fn what_is_shown_is_what_is_printed() {
    let [table, check, fault, ..] = blocks("text")[..] else {
        panic!("the README has other blocks of output than this test knows");
    };
    assert!(done(&["table", "four-bar"]).starts_with(table));
    assert_eq!(done(&["check", "stephenson-six-bar"]), check);

    let here = folder("readme");
    let broken = blocks("toml")[0].replace("\"D\", length", "\"D\", lenght");
    std::fs::write(here.join("my.toml"), broken).unwrap();
    let mut command = command(&["check", "my.toml"]);
    assert_eq!(run(command.current_dir(&here)).err, fault);
}

/// Every option of a sweep and of a table that adds columns is told, with what the columns are called.
#[test]
fn columns_of_errors_are_told() {
    let header = done(&[
        "sweep",
        "four-bar",
        "--columns",
        "C.x,r4.omega",
        "--bounds",
        "--sensitivity",
    ]);
    let header = header.lines().next().unwrap();
    for (option, column, unit) in [
        ("--bounds", "C.x.bound", "[mm]"),
        ("--sensitivity", "C.x.sensitivity", "[mm per mm]"),
        ("--sensitivity", "r4.omega.sensitivity", "[rad/s per mm]"),
    ] {
        assert!(header.contains(&format!("{column} {unit}")), "{header}");
        assert!(
            done(&["sweep", "--help"]).contains(option)
                && done(&["table", "--help"]).contains(option)
        );
        assert!(README.contains(&format!("`{option}`")), "{option}");
        assert!(
            !unit.contains("per") || README.contains(&format!("`{unit}`")),
            "{unit}"
        );
    }
    assert!(README.contains("`C.x.bound`") && README.contains("`C.x.sensitivity`"));
}

/// The table of keys stands in the documentation of the scene file, and here again.
#[test]
fn every_key_of_a_scene_is_told() {
    let documentation = include_str!("../../src/scene/mod.rs");
    let rows = documentation
        .lines()
        .filter_map(|line| line.strip_prefix("//! |"));
    let mut found = 0;
    for row in rows {
        assert!(
            README.contains(&format!("|{row}\n")),
            "the README lacks |{row}"
        );
        found += 1;
    }
    assert!(found > 30, "{found}");
}

/// The commands stand indented by four, each with a word about it.
#[test]
fn the_commands_of_the_readme_run() {
    let here = folder("readme-commands");
    let six_bar = super::tutorial::blocks("toml").pop().unwrap();
    std::fs::write(here.join("six-bar.toml"), six_bar).unwrap();
    let shown = README
        .lines()
        .filter_map(|line| line.strip_prefix("    krank "));
    let mut ran = 0;
    for line in shown {
        let line = line.split("   ").next().unwrap().trim();
        let args: Vec<_> = line.split(' ').map(|arg| arg.trim_matches('\'')).collect();
        if [
            "list", "check", "table", "explain", "draw", "sweep", "start",
        ]
        .contains(&args[0])
        {
            let heard = run(command(&args).current_dir(&here));
            assert_eq!((heard.code, heard.err.as_str()), (0, ""), "{line}");
            ran += 1;
        }
    }
    assert_eq!(ran, 13);
}
