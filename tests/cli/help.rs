//! Tests of `krank help`: every topic exists, is readable plain text and agrees with the program.

use super::{command, presets, refused, run, run_ok};
use std::collections::BTreeSet;

const README: &str = include_str!("../../README.md");

/// Returns the names listed under a heading of the contents.
fn listed(heading: &str) -> Vec<String> {
    let contents = run_ok(&["help"]);
    let after = contents
        .lines()
        .skip_while(|line| !line.starts_with(heading));
    let rows = after.skip(2).take_while(|line| !line.is_empty());
    let first = |line: &str| line.split_whitespace().next().unwrap().to_owned();
    let named = rows.filter(|line| !line.starts_with(' '));
    named.map(first).collect()
}

fn topics() -> Vec<String> {
    let topics = listed("Topics");
    assert!(topics.len() >= 8, "{topics:?}");
    topics
}

/// Returns a topic as printed.
fn topic(name: &str) -> String {
    run_ok(&["help", name])
}

#[test]
fn contents_list_topics_and_commands() {
    let commands = listed("Commands");
    assert!(commands.contains(&"sweep".into()), "{commands:?}");
    for command in &commands {
        assert!(
            run_ok(&["help", command]).contains("Usage: krank"),
            "{command}"
        );
    }
    // A topic with the name of a command would hide the command's help.
    assert!(topics().iter().all(|topic| !commands.contains(topic)));
}

/// In a pipe, `help` prints ASCII without escapes and starts no pager.
#[test]
fn topics_are_plain_text_without_pager_in_a_pipe() {
    for name in topics() {
        let text = topic(&name);
        assert!(text.is_ascii() && !text.contains('\x1b'), "{name}");
        assert_eq!(text, run_ok(&["help", &name, "--no-pager"]));
        let mut with_pager = command(&["help", &name]);
        with_pager
            .env("PAGER", "false")
            .env("TERM", "xterm")
            .env("LC_ALL", "C.UTF-8");
        assert_eq!(run(&mut with_pager).out, text);
        assert!(text.lines().count() > 15, "{text}");
    }
}

#[test]
fn unknown_topic_lists_available_topics() {
    for (word, near) in [
        ("sceen", "did you mean `scene`?"),
        ("swep", "did you mean `sweep`?"),
        ("unicorns", "the topics are"),
        ("", "the topics are"),
        ("\x1b[2J", "the topics are"),
    ] {
        let message = refused(2, &["help", word]);
        assert!(message.contains(near), "{message}");
        assert!(!message.contains('\x1b'), "{message}");
        assert!(
            topics()
                .iter()
                .all(|topic| message.contains(topic.as_str()))
        );
    }
    refused(2, &["help", "scene", "keys"]);
}

#[test]
fn unknown_word_is_searched_in_all_topics() {
    let found = run_ok(&["help", "sensitivity"]);
    for part in [
        "no topic or command is named `sensitivity`; it occurs in:\n",
        "\nTopics: krank help TOPIC\n",
        "\ncolumns: ",
        "\n    - Sensitivity: `--sensitivity` adds `C.x.sensitivity` after each",
        "\nColumns: krank help columns\n\n`C.x.sensitivity`\n",
        "\nCommands: krank help COMMAND\n",
        "\nsweep `--sensitivity`",
    ] {
        assert!(found.contains(part), "{part:?}\n{found}");
    }
    assert!(run_ok(&["help", "time ratio"]).contains("\n    - Time ratio: the slow travel"));
    // The questions come first, as whole rows.
    let found = run_ok(&["help", "compare"]);
    let lines: Vec<&str> = found.lines().take(6).collect();
    assert_eq!(lines[2], "How do I ...?");
    assert!(
        lines[4].starts_with("compare two scenes?") && lines[4].contains("`D`"),
        "{found}"
    );
    // The obvious words of a newcomer's tasks find the question.
    for (word, question) in [
        ("drawing", "save a picture, a drawing"),
        ("save picture", "save a picture"),
        ("change length", "change a length"),
        ("dead points", "find the range, dead points"),
        ("own scene", "write my own scene"),
    ] {
        let found = run_ok(&["help", word]);
        let first = found.lines().nth(4).unwrap();
        assert!(first.starts_with(question), "{word}: {found}");
    }
    let found = run_ok(&["help", "dead points"]);
    let lines: Vec<&str> = found.lines().take(7).collect();
    assert_eq!(lines[6], "    `krank help trust`", "{found}");
    let near = run_ok(&["help", "column"]);
    assert!(near.contains("did you mean `columns`?"), "{near}");
    for word in [" ", "ensitivity"] {
        refused(2, &["help", word]);
    }
}

#[cfg(feature = "tui")]
#[test]
fn search_finds_keys_by_name_and_purpose() {
    for (word, row) in [("undo", "`u`"), ("revert", "`u`"), ("Ctrl-R", "`Ctrl-R`")] {
        let found = run_ok(&["help", word]);
        let (_, keys) = found.split_once("\nKeys of the workbench").unwrap();
        assert!(keys.lines().any(|line| line.starts_with(row)), "{found}");
    }
}

/// Every `krank help WORD` in the README and in the topics names an existing topic or command.
#[test]
fn every_mentioned_topic_exists() {
    let names = topics();
    let commands = listed("Commands");
    let mut texts = vec![README.to_owned(), run_ok(&["--help"])];
    texts.extend(names.iter().map(|name| topic(name)));
    let mut requested = BTreeSet::new();
    for text in &texts {
        let words: Vec<&str> = text.split_whitespace().collect();
        for three in words.windows(3) {
            let is_code = three[0].starts_with('`') && three[2].contains('`');
            if three[0].trim_matches('`') == "krank" && three[1] == "help" && is_code {
                let word = three[2].split('`').next().unwrap();
                requested.insert(word.to_owned());
            }
        }
    }
    assert!(requested.len() > 4, "{requested:?}");
    for word in requested {
        // Examples of words that are searched.
        let is_searched = ["compare", "transmission"].contains(&word.as_str());
        let is_there = is_searched || names.contains(&word) || commands.contains(&word);
        assert!(is_there, "{word}");
    }
    for name in names {
        let code = format!("`{name}`");
        assert!(README.contains(&code), "the README lacks {code}");
    }
}

/// The known keys come from the program's own messages about unknown keys.
#[test]
fn scene_topic_documents_every_key() {
    let shown = topic("scene");
    let group = |title: &str| -> Vec<&str> {
        let lines = shown.lines();
        let after = lines.skip_while(|line| !line.starts_with(title)).skip(1);
        after.take_while(|line| !line.is_empty()).collect()
    };
    let stub = "[ground]\nA = [0, 0]\nD = [4, 0]\n[driver]\nlink = \"r\"\nangle = 1\n[links]\nr = { from = \"A\", to = \"B\", length = 1 }\n";
    let mut printed = 0;
    for (title, scene) in [
        ("key ", format!("zzzzzzzz = 1\n{stub}")),
        ("`[driver]`", stub.replace("angle", "zzzzzzzz = 1\nangle")),
        ("`[links]`", stub.replace("length", "zzzzzzzz = 1, length")),
        (
            "`[slides]`",
            format!(
                "{stub}[slides]\ns = {{ point = \"B\", on = \"ground\", through = \"A\", zzzzzzzz = 1 }}\n"
            ),
        ),
        (
            "`[[loads]]`",
            format!("{stub}[[loads]]\npoint = \"B\"\nforce = [0, 1]\nzzzzzzzz = 1\n"),
        ),
        (
            "`[[loads]]`",
            format!("{stub}[[loads]]\nlink = \"r\"\ntorque = 1\nzzzzzzzz = 1\n"),
        ),
        (
            "`[[loads]]`",
            format!("{stub}[[loads]]\nslide = \"s\"\npress = [[1, 0], [0, 1]]\nzzzzzzzz = 1\n"),
        ),
        (
            "`[[springs]]`",
            format!("{stub}[[springs]]\nfrom = \"A\"\nto = \"B\"\nzzzzzzzz = 1\n"),
        ),
        ("`[motor]`", format!("{stub}[motor]\nzzzzzzzz = 1\n")),
        (
            "`[redundant]`",
            format!("{stub}[redundant]\nzzzzzzzz = 1\n"),
        ),
    ] {
        let output = run(command(&["check", "-"]).write_stdin(scene));
        assert_eq!(output.code, 2);
        let fault = output.err.split("unknown key `zzzzzzzz`").nth(1);
        let fault = fault.unwrap_or_else(|| panic!("{title}: {}", output.err));
        let (_, known) = fault.split_once("known keys: ").unwrap();
        let known = known.lines().next().unwrap();
        for key in known.split(", ") {
            // The tables of the scene have their own rows.
            let table = key.trim_matches('`');
            let rows = [format!("`[{table}]`"), format!("`[[{table}]]`")];
            let is_shown = group(title).iter().any(|line| line.contains(key))
                || shown
                    .lines()
                    .any(|line| rows.iter().any(|row| line.starts_with(row)));
            assert!(is_shown, "{title} lacks {key}:\n{:#?}", group(title));
            printed += 1;
        }
    }
    assert!(printed > 40, "{printed}");
}

/// Compares the last components of all preset column names with the topic.
#[test]
fn columns_topic_documents_every_preset_column() {
    let shown = topic("columns");
    let mut kinds = BTreeSet::new();
    for preset in presets() {
        let header = run_ok(&["sweep", &preset, "--no-units"]);
        let header = header.lines().next().unwrap().to_owned();
        for name in header.split(',') {
            let last = name.rsplit('.').next().unwrap();
            // Shares such as `load` are documented after their total.
            kinds.insert(last.to_owned());
        }
    }
    assert!(kinds.len() > 20, "{kinds:?}");
    for kind in kinds {
        let is_shown = shown.contains(&format!(".{kind}")) || shown.contains(&format!("`{kind}`"));
        assert!(is_shown, "{kind}");
    }
}

/// The topic names each option that adds columns, and how these columns are called.
#[test]
fn columns_topic_documents_error_columns() {
    let shown = topic("columns");
    let columns = ["--columns", "C.x,r4.omega", "--bounds", "--sensitivity"];
    let header = run_ok(&[&["sweep", "four-bar"], &columns[..]].concat());
    let header = header.lines().next().unwrap();
    for (option, column, unit) in [
        ("--bounds", "C.x.bound", "[mm]"),
        ("--sensitivity", "C.x.sensitivity", "[mm per mm]"),
        ("--sensitivity", "r4.omega.sensitivity", "[rad/s per mm]"),
    ] {
        assert!(header.contains(&format!("{column} {unit}")), "{header}");
        for command in ["sweep", "table"] {
            assert!(run_ok(&[command, "--help"]).contains(option));
        }
        assert!(shown.contains(&format!("`{option}`")), "{option}");
        let is_shown = !unit.contains("per") || shown.contains(&format!("`{unit}`"));
        assert!(is_shown, "{unit}");
    }
    assert!(shown.contains("`C.x.bound`") && shown.contains("`C.x.sensitivity`"));
}

/// Output quoted in the topics is what the program prints.
#[test]
fn scene_topic_shows_actual_check_output() {
    // Ignores indentation.
    let flush = |text: &str| -> String {
        let lines = text.lines().map(|line| line.trim().to_owned() + "\n");
        lines.collect()
    };
    let scene = topic("scene");
    let check = run_ok(&["check", "stephenson-six-bar"]);
    assert!(flush(&scene).contains(&flush(&check)), "{scene}");
}
