//! Checks that no result depends on the order of the lines of a scene: every command, for every
//! preset, through the library.

use krank::scene::presets;
use serde_json::Value;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// Sections whose lines are identified by their names.
const SECTIONS: [&str; 5] = ["ground", "links", "slides", "start", "vectors"];
/// Maximum relative difference of numbers: rounding, and at a dead point its square root, the
/// accuracy of positions there.
const ROUNDING: f64 = 1e-9;
const ROUNDING_AT_END: f64 = 1e-6;

/// The commands compared, as JSON, with options that make them quick.
const COMMANDS: [&[&str]; 7] = [
    &["check"],
    &["table", "--bounds"],
    &["sweep", "--step", "30", "--bounds"],
    &["cycle"],
    &["tolerance", "--samples", "20", "--at"],
    &["tolerance", "--samples", "3", "--columns", "range"],
    &["motor"],
];

/// Reverses the lines of each section of a scene.
fn reversed(text: &str) -> String {
    let mut out = Vec::new();
    let mut section: Option<Vec<&str>> = None;
    for line in text.lines().chain(["["]) {
        if line.starts_with('[') {
            out.extend(section.take().into_iter().flatten().rev());
            let name = line.trim_matches(['[', ']']);
            section = SECTIONS.contains(&name).then(Vec::new);
            out.push(line);
        } else {
            match &mut section {
                // Comments are dropped, since the line they describe moves.
                Some(lines) if line.contains('=') && !line.starts_with('#') => lines.push(line),
                Some(_) => {}
                None => out.push(line),
            }
        }
    }
    out.pop();
    out.join("\n")
}

/// Returns the coordinate at which a scene opens, as its driver gives it.
fn opening(text: &str) -> Option<&str> {
    let driver = &text[text.find("[driver]")?..];
    let line = driver
        .lines()
        .find(|line| line.starts_with("angle") || line.starts_with("position"))?;
    Some(
        line.split('=')
            .nth(1)?
            .split('#')
            .next()?
            .trim()
            .trim_matches('"'),
    )
}

/// Scenes whose tolerances over the whole motion are quick to compute: every machine is tracked
/// again.
const FOLLOWED: [&str; 4] = ["four-bar", "slotted-lever", "excavator-boom", "press-ram"];

/// Returns the result of a command as JSON; `None` if it fails.
fn result(scene: &Path, command: &[&str], at: Option<&str>) -> Option<Value> {
    let out = scene.with_extension("json");
    let _ = std::fs::remove_file(&out);
    let mut arguments: Vec<OsString> = vec!["krank".into(), command[0].into(), scene.into()];
    arguments.extend(command[1..].iter().map(OsString::from));
    if command.last() == Some(&"--at") {
        arguments.push(at?.into());
    }
    arguments.extend(["--format", "json", "-o"].map(OsString::from));
    arguments.push(out.clone().into());
    let _ = krank::cli::run(arguments);
    serde_json::from_slice(&std::fs::read(&out).ok()?).ok()
}

/// Returns a sort key for items of lists, insensitive to rounding.
fn key(value: &Value) -> String {
    match value {
        Value::Number(number) => {
            let number = number.as_f64().unwrap();
            // Noise around zero has no significant digits.
            if number.abs() < 1e-7 {
                "0".into()
            } else {
                format!("{number:.4e}")
            }
        }
        Value::Array(items) => {
            let mut keys: Vec<String> = items.iter().map(key).collect();
            keys.sort_unstable();
            keys.join(",")
        }
        Value::Object(items) => {
            let mut keys: Vec<String> = items
                .iter()
                .map(|(name, item)| format!("{name}:{}", key(item)))
                .collect();
            keys.sort_unstable();
            keys.join(";")
        }
        Value::String(text) => sorted_words(text).0.join(" "),
        Value::Bool(_) | Value::Null => value.to_string(),
    }
}

/// Returns the words and the numbers of a text, each sorted: lists of names keep the order of the
/// file.
fn sorted_words(text: &str) -> (Vec<String>, Vec<f64>) {
    let is_part = |c: char| c.is_alphanumeric() || "._'+-".contains(c);
    let all = text.split(|c| !is_part(c)).filter(|word| !word.is_empty());
    let (mut words, mut numbers) = (Vec::new(), Vec::new());
    for word in all {
        match word.trim_end_matches('.').parse() {
            Ok(number) => numbers.push(number),
            Err(_) => words.push(word.to_owned()),
        }
    }
    words.sort_unstable();
    numbers.sort_by(f64::total_cmp);
    (words, numbers)
}

/// Records the differences of two values. Bounds are skipped, because other roundings give other
/// bounds.
fn compare(a: &Value, b: &Value, rounding: f64, place: &str, differences: &mut Vec<String>) {
    let mut differ = || differences.push(format!("{place}: {a} and {b}"));
    match (a, b) {
        (Value::Object(of), Value::Object(with)) => {
            if !of.keys().all(|name| with.contains_key(name)) || of.len() != with.len() {
                differ();
                return;
            }
            for (name, item) in of {
                // An index into a list that has the order of the file.
                let listed = |of: &Value, item: &Value| of.get(item.as_u64()? as usize).cloned();
                if let (Some(list), "current") = (of.get("list"), name.as_str()) {
                    let [a, b] = [listed(list, item), listed(&with["list"], &with[name])];
                    compare(
                        &a.into(),
                        &b.into(),
                        rounding,
                        &format!("{place}.{name}"),
                        differences,
                    );
                    continue;
                }
                if !name.ends_with("bound") {
                    compare(
                        item,
                        &with[name],
                        rounding,
                        &format!("{place}.{name}"),
                        differences,
                    );
                }
            }
        }
        (Value::Array(of), Value::Array(with)) if of.len() == with.len() => {
            let sorted = |items: &[Value]| {
                let mut items = items.to_vec();
                // Pairs of numbers keep their order.
                if !items.iter().all(Value::is_number) {
                    items.sort_by_cached_key(key);
                }
                items
            };
            for (i, (a, b)) in sorted(of).iter().zip(&sorted(with)).enumerate() {
                compare(a, b, rounding, &format!("{place}[{i}]"), differences);
            }
        }
        (Value::Number(of), Value::Number(with)) => {
            let [of, with] = [of, with].map(|number| number.as_f64().unwrap());
            let size = of.abs().max(with.abs()).max(1.0);
            if (of - with).abs() > rounding * size {
                differ();
            }
        }
        (Value::String(of), Value::String(with)) => {
            let ((of, numbers), (with, others)) = (sorted_words(of), sorted_words(with));
            let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-5 * a.abs().max(1.0);
            if of != with || !numbers.iter().zip(&others).all(close) {
                differ();
            }
        }
        _ if a == b => {}
        _ => differ(),
    }
}

/// Creates a folder for scenes read by commands.
fn folder() -> PathBuf {
    let folder = std::env::temp_dir().join(format!("krank-line-order-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Compares the results of all commands for some scenes and their reversed copies.
fn compare_all(scenes: impl Iterator<Item = (String, String)>, what: &str) {
    let folder = folder();
    let mut differences = Vec::new();
    let mut compared = 0;
    for (name, text) in scenes {
        let files = [("a", text.clone()), ("b", reversed(&text))].map(|(order, text)| {
            // The name of the file is part of the output.
            let folder = folder.join(format!("{what}-{order}"));
            std::fs::create_dir_all(&folder).unwrap();
            let file = folder.join(format!("{name}.toml"));
            std::fs::write(&file, text).unwrap();
            file
        });
        let mut rounding = ROUNDING;
        let is_quick =
            |command: &&&[&str]| !command.contains(&"range") || FOLLOWED.contains(&&*name);
        for &command in COMMANDS.iter().filter(is_quick) {
            let [a, b] = files
                .each_ref()
                .map(|file| result(file, command, opening(&text)));
            let place = format!("{name} {}", command.join(" "));
            compared += usize::from(a.is_some());
            let dead_points = a.as_ref().and_then(|a| a.get("dead_points")?.as_array());
            if dead_points.is_some_and(|list| !list.is_empty()) {
                rounding = ROUNDING_AT_END;
            }
            compare(&a.into(), &b.into(), rounding, &place, &mut differences);
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(
        compared > 0 && differences.is_empty(),
        "{} of {compared}: {differences:#?}",
        differences.len()
    );
}

#[test]
fn results_do_not_depend_on_line_order() {
    let scenes = presets::all().iter().map(|preset| {
        // Tolerances in the scene give every command something to report.
        let text = format!("tolerance = 0.0002\nclearance = 0.0001\n{}", preset.text);
        (preset.name.to_owned(), text)
    });
    compare_all(scenes, "presets");
}

/// The clearance of the sliding link's pin acts in the rod: it changes s.length and nothing else.
#[test]
fn clearance_of_a_sliding_links_pin_belongs_to_the_rod() {
    let text = "unit = \"mm\"\n[ground]\nA = [0, 0]\n[driver]\nlink = \"crank\"\nangle = 0\n[links]\n\
        crank = { from = \"A\", to = \"B\", length = 100 }\nrod = { from = \"B\", to = \"C\", length = 300 }\n\
        ram = { points = { C = [0, 0], T = [50, 0] } }\n[slides]\n\
        s = { link = \"ram\", on = \"ground\", through = \"A\", angle = 0, turn = 0 }\n[start]\nC = [400, 0]\n\
        [clearances]\nC = 0.5\n";
    for text in [text.to_owned(), reversed(text)] {
        let scene = krank::scene::Scene::parse(&text, "play.toml").unwrap();
        let solver = krank::solver::Solver::new(&scene.mechanism).unwrap();
        let catalogue = krank::quantity::Catalogue::new(&scene);
        let requested = ["s.length", "T.x", "T.y"].map(|name| catalogue.find(name).unwrap());
        let study =
            krank::study::ToleranceStudy::new(&scene, &solver, scene.tolerances(), &requested);
        let found = study.unwrap().at(0.0);
        for (figure, off) in found.into_iter().zip([0.5, 0.5, 0.0]) {
            let figure = figure.unwrap();
            let [low, high] = figure.worst.reached;
            assert!((high - figure.nominal - off).abs() < 1e-9, "{figure:?}");
            assert!((figure.nominal - low - off).abs() < 1e-9, "{figure:?}");
            // Within the clearance, derivatives change by a part of 0.5/300.
            let largest = off * 1.01 + 1e-9;
            let worst = figure.worst;
            assert!(worst.high - figure.nominal < largest, "{figure:?}");
            assert!(figure.nominal - worst.low < largest, "{figure:?}");
        }
    }
}
