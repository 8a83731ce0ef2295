//! Tests of Turkish: selection of the language, translations, unchanged machine formats and decimal commas.

use super::{Run, command, folder, presets, refused, rows, run, run_ok};
use assert_cmd::Command;
use std::path::Path;

const UTF8: [(&str, &str); 2] = [("LC_ALL", "C.UTF-8"), ("TERM", "xterm-256color")];

/// Runs krank with exactly these environment variables.
fn krank_in(env: &[(&str, &str)], args: &[&str]) -> Run {
    let mut krank = Command::new(env!("CARGO_BIN_EXE_krank"));
    let home = ("HOME", "/dev/null/home");
    run(krank
        .env_clear()
        .envs([home])
        .envs(env.iter().copied())
        .args(args))
}

/// Returns the output in Turkish in a UTF-8 locale.
fn turkish(args: &[&str]) -> String {
    let args = [args, &["--language", "tr"]].concat();
    let Run { code, out, err } = krank_in(&UTF8, &args);
    assert_eq!(code, 0, "{err}");
    out
}

/// Runs krank with a language in this folder, in a UTF-8 locale.
pub(super) fn spoken(language: &str, here: &Path, args: &[&str]) -> Run {
    let mut krank = Command::new(env!("CARGO_BIN_EXE_krank"));
    let krank = krank.env_clear().envs(UTF8).current_dir(here);
    run(krank.args(args).args(["--language", language]))
}

/// English words that must not occur on a Turkish screen. Names of columns and units are not among them.
const ENGLISH: [&str; 12] = [
    "velocity", "position", "vector", "point", "step", "turn", "play", "quit", "help", "Motion",
    "Tables", "found",
];

fn is_turkish(screen: &str) {
    for word in ENGLISH {
        let mut words = screen.split(|c: char| !c.is_alphanumeric());
        assert!(!words.any(|it| it == word), "{word}\n{screen}");
    }
}

#[test]
fn turkish_tables_use_the_terms_of_the_lecture_notes() {
    let table = turkish(&["table", "four-bar", "--at", "60"]);
    for message in [
        "\nKonum ",
        "\nHız ",
        "\nİvme ",
        "mafsal noktaları",
        "bulunan",
        "tahrik r2",
    ] {
        assert!(table.contains(message), "{message}\n{table}");
    }
    is_turkish(&table);
    // Terms that are keys in scenes and columns are translated in prose.
    for (args, gone) in [
        (
            &["table", "four-bar-load"][..],
            &["torque", "ground", "ok"][..],
        ),
        (&["check", "engine"], &["ground", "stroke"]),
        (&["explain", "four-bar"], &["ok"]),
        (&["list"], &["load", "press", "leg", "Kite"]),
    ] {
        let output = turkish(args);
        // Names of presets are typed by the user and stay English.
        let output = output.lines().map(|line| match args {
            ["list"] => line.split_once("  ").map_or(line, |(_, title)| title),
            _ => line,
        });
        let output: Vec<&str> = output.collect();
        for word in gone {
            let mut words = output
                .iter()
                .flat_map(|it| it.split(|c: char| !c.is_alphanumeric()));
            assert!(!words.any(|it| it == *word), "{args:?}: {word}");
        }
    }
    // The values are the same.
    let figures = |text: &str| -> Vec<String> {
        let words = text
            .split_whitespace()
            .map(|word| word.trim_end_matches('*'));
        words
            .filter(|w| w.parse::<f64>().is_ok())
            .map(str::to_owned)
            .collect()
    };
    assert_eq!(
        figures(&table),
        figures(&run_ok(&["table", "four-bar", "--at", "60"]))
    );
}

#[test]
fn language_comes_from_option_then_configuration_then_locale() {
    let spoken = |env: &[(&str, &str)], args: &[&str]| -> &str {
        let Run { out, .. } = krank_in(env, &[&["check", "four-bar"], args].concat());
        match out.contains("serbestlik") {
            true => "tr",
            false if out.contains("mobility") => "en",
            false => "neither",
        }
    };
    assert_eq!(spoken(&[], &[]), "en");
    assert_eq!(spoken(&[("LANG", "tr_TR.UTF-8")], &[]), "tr");
    assert_eq!(spoken(&[("LANG", "C")], &[]), "en");
    let lang = ("LANG", "tr_TR.UTF-8");
    assert_eq!(spoken(&[lang, ("LC_ALL", "POSIX")], &[]), "en");
    assert_eq!(spoken(&[lang, ("LC_MESSAGES", "C")], &[]), "en");
    assert_eq!(spoken(&[lang, ("LC_CTYPE", "C")], &[]), "tr");
    assert_eq!(spoken(&[lang], &["--language", "en"]), "en");
    assert_eq!(spoken(&[], &["--language=tr"]), "tr");
    assert_eq!(spoken(&[lang], &["--language", "auto"]), "tr");

    let home = folder("language-configured");
    std::fs::create_dir_all(home.join("krank")).unwrap();
    std::fs::write(home.join("krank/config.toml"), "language = \"tr\"\n").unwrap();
    let configured = ("XDG_CONFIG_HOME", home.to_str().unwrap());
    assert_eq!(spoken(&[configured, ("LANG", "en_GB.UTF-8")], &[]), "tr");
    assert_eq!(spoken(&[configured], &["--language", "en"]), "en");
    // With an option first, the name of the command must not be taken for a scene.
    let first = krank_in(&[], &["--language", "tr", "check", "four-bar"]);
    assert!(first.out.contains("serbestlik"), "{}", first.err);
}

#[test]
fn columns_keys_and_exit_codes_do_not_depend_on_language() {
    for scene in ["four-bar-load", "press-ram", "jansen-leg"] {
        for args in [
            &["table", scene, "--format", "csv"][..],
            &["table", scene, "--format", "json", "--bounds"],
            &["check", scene, "--format", "json"],
            &["sweep", scene, "--step", "45", "--bounds"],
            &["sweep", scene, "--step", "45", "--format", "json"],
            &["motor", scene, "--format", "json"],
            &["motor", scene, "--format", "csv"],
        ] {
            let english = krank_in(&UTF8, args);
            let both = krank_in(&UTF8, &[args, &["--language", "tr"]].concat());
            assert_eq!(english.code, both.code, "{args:?}");
            assert!(english.out == both.out, "{args:?}");
        }
    }
    for (code, args) in [
        (1, &["table", "double-rocker", "--at", "5"][..]),
        (2, &["table", "four-bra"]),
        (2, &["sweep", "four-bar", "--step", "0"]),
    ] {
        let run_output = krank_in(&UTF8, &[args, &["--language", "tr"]].concat());
        assert_eq!(run_output.code, code, "{}", run_output.err);
        assert!(run_output.err.starts_with("hata: "), "{}", run_output.err);
    }
}

#[test]
fn turkish_is_transliterated_in_ascii_locale() {
    for preset in presets() {
        for args in [
            &["table", &preset][..],
            &["check", &preset],
            &["explain", &preset],
        ] {
            let args = [args, &["--language", "tr"]].concat();
            let Run { out, err, .. } = run(&mut command(&args));
            assert!(out.is_ascii() && err.is_ascii(), "{args:?}");
            // An unknown in the working is `?` in both languages.
            let english = run_ok(&args[..2]);
            assert_eq!(
                out.matches('?').count(),
                english.matches('?').count(),
                "{args:?}\n{out}"
            );
        }
    }
    for args in [
        &["--help"][..],
        &["sweep", "--help"],
        &["config"],
        &["man"],
        &["help"],
        &["help", "scene"],
        &["help", "columns"],
        &["help", "trust"],
        &["help", "limits"],
    ] {
        let args = [args, &["--language", "tr"]].concat();
        assert!(run_ok(&args).is_ascii(), "{args:?}");
        let all = krank_in(&UTF8, &args);
        assert!(all.out.contains('ı'), "{args:?}");
        let letters = |text: &str| text.chars().count();
        assert_eq!(letters(&all.out), letters(&run_ok(&args)), "{args:?}");
    }
}

/// Contents list the topics by their Turkish names; both names show the topic.
#[test]
fn manual_is_turkish_and_topics_have_names_in_both_languages() {
    let contents = turkish(&["help"]);
    let listed = contents.lines().filter_map(|line| {
        let (about, name) = line.strip_suffix(')')?.rsplit_once(" (")?;
        Some((about.split_whitespace().next()?.to_owned(), name.to_owned()))
    });
    let listed: Vec<(String, String)> = listed.collect();
    assert!(listed.len() >= 8, "{contents}");
    for (name, in_turkish) in &listed {
        let text = turkish(&["help", name]);
        assert_eq!(text, turkish(&["help", in_turkish]), "{name}");
        assert_ne!(
            text,
            run_ok(&["help", in_turkish]),
            "{name} is told in English"
        );
        assert_eq!(run_ok(&["help", in_turkish]), run_ok(&["help", name]));
        assert!(text.contains('ı'), "{text}");
    }
    assert!(turkish(&["help", "sahne"]).contains("\n`name`"));
    assert!(turkish(&["help", "SUTUNLAR"]).starts_with("Sütunlar ve adları\n"));
    // A word that occurs in only one language shows the results of that language.
    let found = turkish(&["help", "mafsal"]);
    assert!(found.contains("\nKonular: krank help TOPIC\n"), "{found}");
    let english = krank_in(&UTF8, &["help", "mafsal"]);
    assert_eq!((english.code, english.out), (0, found));
    let found = turkish(&["help", "gravity"]);
    assert!(found.contains("\nKonular: "), "{found}");
    let found = turkish(&["help", "OLU KONUM"]).to_lowercase();
    assert!(found.contains("ölü konum"), "{found}");
    // A misspelled topic gets a suggestion.
    let near = krank_in(&UTF8, &["help", "sahna", "--language", "tr"]);
    assert!(
        near.code == 2 && near.err.contains("`sahne`"),
        "{}",
        near.err
    );
}

#[cfg(feature = "tui")]
#[test]
fn four_bar_screen_is_turkish_in_utf8_and_ascii() {
    let large = turkish(&["four-bar", "--print", "--size", "80x24"]);
    insta::assert_snapshot!("turkish-80x24", large);
    is_turkish(&large);
    let args = ["four-bar", "--print", "--size", "40x12", "--language", "tr"];
    let small = run_ok(&args);
    insta::assert_snapshot!("turkish-40x12", small);
    is_turkish(&small);
    assert!(small.is_ascii());
    assert_eq!(
        small.matches('?').count(),
        1,
        "the key of the help alone\n{small}"
    );
    let console = [("LANG", "tr_TR.UTF-8"), ("TERM", "linux")];
    let console = krank_in(&console, &["four-bar", "--print", "--size", "80x24"]).out;
    assert!(
        console.contains("Cozum") && console.contains('\u{2502}'),
        "{console}"
    );
}

#[cfg(feature = "tui")]
#[test]
fn every_view_is_turkish() {
    for view in [
        "motion", "tables", "plots", "forces", "scene", "working", "motor", "lengths",
    ] {
        for size in ["80x24", "120x40", "40x12"] {
            let args = ["four-bar-load", "--view", view, "--print", "--size", size];
            let screen = turkish(&args);
            is_turkish(&screen);
            // The current tab and the last tab are not cut off.
            let tabs = screen.lines().next().unwrap();
            assert!(
                tabs.matches('[').count() == tabs.matches(']').count(),
                "{tabs}"
            );
        }
    }
}

#[test]
fn csv_with_decimal_comma_has_the_same_values() {
    let plain = [
        "sweep",
        "four-bar",
        "--step",
        "30",
        "--columns",
        "C.x,r4.omega",
    ];
    let comma = [&plain[..], &["--decimal", "comma"]].concat();
    let text = run_ok(&comma);
    assert!(
        text.starts_with("driver.angle [deg];C.x [mm];r4.omega [rad/s];state\n"),
        "{text}"
    );
    let read = |separator: u8, text: &str| -> Vec<Vec<String>> {
        let mut reader = csv::ReaderBuilder::new();
        let mut reader = reader.delimiter(separator).from_reader(text.as_bytes());
        let cells = |row: csv::StringRecord| row.iter().map(|c| c.replace(',', ".")).collect();
        reader.records().map(|row| cells(row.unwrap())).collect()
    };
    assert!(text.contains("5,561364134655267"), "{text}");
    assert_eq!(read(b';', &text), rows(&run_ok(&plain)));
    let tabs = run_ok(&[&comma[..], &["--separator", "tab"]].concat());
    assert_eq!(read(b'\t', &tabs), rows(&run_ok(&plain)));
    let semicolons = run_ok(&[&plain[..], &["--separator", "semicolon"]].concat());
    assert_eq!(semicolons, run_ok(&plain).replace(',', ";"));
    for command in ["table", "motor"] {
        let args = [command, "four-bar-load", "--format", "csv"];
        let text = run_ok(&[&args[..], &["--decimal", "comma"]].concat());
        assert_eq!(read(b';', &text), rows(&run_ok(&args)), "{command}");
    }
}

#[test]
fn conflicting_decimal_and_separator_are_rejected() {
    let both = [
        "sweep",
        "four-bar",
        "--decimal",
        "comma",
        "--separator",
        "comma",
    ];
    let message = refused(2, &both);
    assert!(message.contains("--separator semicolon"), "{message}");
    let message = refused(2, &["table", "four-bar", "--decimal", "comma"]);
    assert!(message.contains("--format csv"), "{message}");
}

#[test]
fn speed_accepts_decimal_comma() {
    let scene = run_ok(&["start", "four-bar"]);
    assert!(scene.contains("speed = \"15 rad/s\""), "{scene}");
    let file = folder("decimal-comma").join("comma.toml");
    let path = file.to_str().unwrap();
    let table = |speed: &str| {
        std::fs::write(&file, scene.replace("15 rad/s", speed)).unwrap();
        run(&mut command(&["table", path]))
    };
    let [comma, point] = ["15,5 rad/s", "15.5 rad/s"].map(table);
    assert_eq!(comma.code, 0, "{}", comma.err);
    assert_eq!(comma.out, point.out);
    assert!(comma.out.contains("15.5 rad/s"), "{}", comma.out);
    let ambiguous = table("1,234.5 rad/s");
    assert_eq!(ambiguous.code, 2);
    assert!(ambiguous.err.contains("1234,5"), "{}", ambiguous.err);
}

/// English words in scene errors. None is a Turkish word, a key of a scene or a name in the files.
const OF_FAULTS: [&str; 27] = [
    "the", "of", "and", "with", "is", "are", "has", "have", "must", "cannot", "neither", "both",
    "only", "which", "this", "that", "these", "give", "write", "take", "name", "found", "known",
    "unknown", "reserved", "negative", "expected",
];

/// Returns the prose of a report: without source lines, places and TOML examples.
fn prose_of(report: &str) -> Vec<String> {
    let mut message = Vec::new();
    for line in report.lines() {
        let (number, rest) = line.split_once(" |").unwrap_or(("x", line));
        let is_source = number.trim().parse::<u32>().is_ok();
        let is_place = line.trim_start().starts_with("-->");
        let text = rest.trim_start_matches(|c: char| " |=".contains(c));
        let marks = text.trim_start_matches(|c: char| " ^-|_".contains(c));
        let key = marks.split_once(" = ").map(|(key, _)| key);
        let is_code = marks.starts_with('[') || key.is_some_and(|key| !key.contains(' '));
        let levels = ["error: ", "hata: ", "help: ", "yardim: ", "note: ", "not: "];
        let level = levels.iter().find_map(|level| marks.strip_prefix(level));
        let marks = level.unwrap_or(marks);
        if !is_source && !is_place && !is_code {
            let plain = marks.split('`').step_by(2).collect::<Vec<_>>().join(" ");
            message.push(plain.split('"').step_by(2).collect::<Vec<_>>().join(" "));
        }
    }
    message
}

/// Returns the words of at least two letters.
fn words_of(text: &str) -> Vec<&str> {
    let words = text.split(|c: char| !c.is_alphabetic());
    words.filter(|word| word.len() > 1).collect()
}

#[test]
fn every_scene_error_is_translated() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/broken");
    let mut faults = Vec::new();
    let mut files = 0;
    for file in std::fs::read_dir(&folder).unwrap() {
        let path = file.unwrap().path();
        let name = path.to_str().unwrap();
        let english = refused(2, &["check", name]);
        let turkish = refused(2, &["check", name, "--language", "tr"]);
        files += 1;
        // Both languages report the same places in the file.
        let kept = |report: &str| -> Vec<String> {
            let lines = report.lines().filter(|line| line.contains("-->"));
            lines.map(|line| line.trim().to_owned()).collect()
        };
        assert_eq!(kept(&english), kept(&turkish));
        let english = prose_of(&english);
        for line in prose_of(&turkish) {
            let words = words_of(&line);
            let word = words.iter().find(|word| OF_FAULTS.contains(word));
            let shared = words.len() > 1 && english.contains(&line);
            if shared || word.is_some() {
                faults.push(format!("{name}: {line}"));
            }
        }
    }
    assert!(files > 150, "{files}");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn prose_of_a_report_excludes_code_and_places() {
    let report = "hata: kotu\n --> a.toml:3:1\n  |\n3 | the = 1\n  |  ^^ is bad `the`\n  = yardim: the rule\n";
    assert_eq!(prose_of(report), ["kotu", "", "is bad  ", "the rule"]);
    assert_eq!(words_of("is bad, 3 `x"), ["is", "bad"]);
}

/// Many locales write decimal commas; options, the workbench and scenes accept them.
#[test]
fn coordinates_accept_decimal_comma() {
    let alike = |args: &[&str]| {
        let typed: Vec<String> = args.iter().map(|it| (*it).to_owned()).collect();
        let point: Vec<String> = args.iter().map(|it| it.replace(',', ".")).collect();
        let output = |args: &[String]| run_ok(&args.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(output(&typed), output(&point), "{args:?}");
    };
    alike(&["table", "four-bar", "--at", "15,5"]);
    alike(&["draw", "four-bar", "--at", "-0,5"]);
    alike(&["explain", "four-bar", "--at", "1,25e1"]);
    alike(&[
        "sweep", "four-bar", "--from", "0,5", "--to", "2,5", "--step", "0,1",
    ]);
    alike(&[
        "plot",
        "four-bar",
        "--columns",
        "C.x",
        "--from",
        "0,5",
        "--to",
        "90,5",
    ]);
    alike(&["motor", "excavator-boom", "--from", "1,8", "--to", "2,8"]);
    alike(&["motor", "press-ram", "--height", "6,5"]);
    #[cfg(feature = "tui")]
    alike(&["four-bar", "--at", "15,5", "--print"]);
    for (args, option) in [
        (&["table", "four-bar", "--at", "1,500"][..], "--at"),
        (&["sweep", "four-bar", "--step", "1.234,5"], "--step"),
        (&["motor", "press-ram", "--height", "1,000"], "--height"),
    ] {
        let message = refused(2, args);
        let groups = "write digits without groups: 1234.5 or 1234,5";
        assert!(
            message.contains(option) && message.contains(groups),
            "{message}"
        );
    }
}
