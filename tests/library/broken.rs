//! Checks that every file in `tests/broken` and `tests/broken_tasks` is rejected with the phrases
//! and positions named in its header: `# expect: a phrase of the message` and `# at: LINE:COLUMN`,
//! each any number of times.

use krank::quantity::check_figures;
use krank::scene::{Diagnostics, Scene};
use krank::solver::Solver;
use krank::synthesis::{Synthesis, SynthesisSettings};
use krank::task_file::{ExampleTask, TaskFile};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn broken() -> Vec<PathBuf> {
    files_of("tests/broken")
}

fn files_of(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = std::fs::read_dir(&folder).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

/// Returns the errors of a scene file; as in every command, reading comes before solving.
fn faults(bytes: &[u8], origin: &str) -> Option<Diagnostics> {
    match Scene::read(bytes, origin) {
        Err(faults) => Some(faults),
        Ok(scene) => {
            let fault = Solver::new(&scene.mechanism).err();
            let wrong = check_figures(&scene).err();
            wrong.or_else(|| Some(scene.explain(&fault?)))
        }
    }
}

fn after<'t>(head: &'t str, text: &'t str) -> Vec<&'t str> {
    text.lines()
        .filter_map(|line| line.strip_prefix(head))
        .map(str::trim)
        .collect()
}

/// Returns the errors of a task file.
fn task_faults(bytes: &[u8], origin: &str) -> Option<Diagnostics> {
    TaskFile::read(bytes, origin).err()
}

/// Returns the deviations from a file's header, empty if the file is rejected as its header says.
fn check(path: &Path, faults: impl Fn(&[u8], &str) -> Option<Diagnostics>) -> Vec<String> {
    let bytes = std::fs::read(path).unwrap();
    let text = String::from_utf8_lossy(&bytes);
    let origin = path.file_name().unwrap().to_string_lossy();
    let Some(faults) = faults(&bytes, &origin) else {
        return vec!["it is accepted".to_owned()];
    };
    let rendered = faults.render(true, false);
    let mut complaints = Vec::new();
    let phrases = after("# expect:", &text);
    if phrases.is_empty() {
        complaints.push("it has no `# expect:`".to_owned());
    }
    for phrase in phrases {
        if !rendered.contains(phrase) {
            complaints.push(format!("nothing says: {phrase}"));
        }
    }
    let found: BTreeSet<String> = faults
        .items
        .iter()
        .filter_map(|item| faults.position(item))
        .map(|(line, column)| format!("{line}:{column}"))
        .collect();
    let expected: BTreeSet<String> = after("# at:", &text)
        .into_iter()
        .map(String::from)
        .collect();
    if !expected.is_empty() && found != expected {
        complaints.push(format!("faults at {found:?}, not at {expected:?}"));
    }
    for place in found {
        if !rendered.contains(&format!(" --> {origin}:{place}\n")) {
            complaints.push(format!("the place {place} is not shown"));
        }
    }
    if !rendered
        .bytes()
        .all(|b| b == b'\n' || (b' '..=b'~').contains(&b))
    {
        complaints.push("it shows more than printable ASCII".to_owned());
    }
    if !complaints.is_empty() {
        complaints.push(rendered);
    }
    complaints
}

#[test]
fn broken_scenes_are_rejected_with_expected_message_and_place() {
    let mut report = String::new();
    let files = broken();
    assert!(files.len() >= 40, "only {} broken scenes", files.len());
    for path in &files {
        for complaint in check(path, faults) {
            report += &format!("{}: {complaint}\n", path.display());
        }
    }
    assert!(report.is_empty(), "{report}");
}

#[test]
fn broken_tasks_are_rejected_with_expected_message_and_place() {
    let mut report = String::new();
    let files = files_of("tests/broken_tasks");
    assert!(files.len() >= 40, "only {} broken tasks", files.len());
    for path in &files {
        for complaint in check(path, task_faults) {
            report += &format!("{}: {complaint}\n", path.display());
        }
    }
    assert!(report.is_empty(), "{report}");
}

/// Long lists are read, or rejected with few messages.
#[test]
fn long_task_lists_are_read_or_rejected_briefly() {
    let rows = |count: usize| -> String {
        let rows: Vec<String> = (0..count).map(|k| format!("[{k}, {}]", k % 7)).collect();
        rows.join(", ")
    };
    let path = |count| format!("kind = \"path\"\npoints = [{}]\n", rows(count));
    assert!(TaskFile::parse(&path(1000), "long").is_ok());
    let faults = TaskFile::parse(&path(20_000), "long").unwrap_err();
    assert!(
        faults.first_words().contains("not 20000"),
        "{}",
        faults.first_words()
    );
    let pairs = format!("kind = \"function\"\npairs = [{}]\n", rows(1001));
    assert!(TaskFile::parse(&pairs, "long").is_err());
    let empty = "[],".repeat(20_000);
    let faults = TaskFile::parse(&format!("kind = \"path\"\npoints = [{empty}]\n"), "long");
    assert!(faults.unwrap_err().items.len() < 100);
}

/// A task with a few changed bytes is read or rejected with a reason, without a panic.
#[test]
fn mutated_tasks_are_read_or_rejected_with_a_reason() {
    let parts = [
        "1e300", "-", "nan", "[", "]", "\"x\"", "0", "1e-300", ",", "=", "\u{0}", "true", "{",
        "inf",
    ];
    let mut rng = 88_172_645_463_325_252_u64;
    let mut next = |below: usize| {
        rng ^= rng << 13;
        rng ^= rng >> 7;
        rng ^= rng << 17;
        (rng % below as u64) as usize
    };
    let mut read = 0;
    for example in ExampleTask::all() {
        for _ in 0..400 {
            let mut text = example.text.to_owned();
            for _ in 0..=next(2) {
                let places: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
                let from = next(places.len());
                let to = (from + next(4)).min(places.len() - 1);
                text.replace_range(places[from]..places[to], parts[next(parts.len())]);
            }
            match TaskFile::read(text.as_bytes(), "changed") {
                Ok(_) => read += 1,
                Err(faults) => {
                    assert!(!faults.items.is_empty(), "{text}");
                    assert!(!faults.render(true, false).is_empty());
                }
            }
        }
    }
    assert!(read > 50, "{read}");
}

/// Numbers at the limits of the accepted range do not break a method.
#[test]
fn extreme_numbers_in_tasks_give_finite_results() {
    for size in ["1e300", "1e-300", "0"] {
        for text in [
            format!("kind = \"poses\"\nposes = [[0, 0, 0], [{size}, 1, 10], [2, {size}, 20]]\n"),
            format!(
                "kind = \"poses\"\nposes = [[0, 0, 0], [{size}, 1, 10], [2, {size}, 20], [3, 4, {size}], [1, 7, 3]]\n"
            ),
            format!("kind = \"function\"\npairs = [[0, 0], [1, {size}], [2, 5]]\n"),
            format!(
                "kind = \"function\"\npairs = [[0, 0], [1, 3], [2, 5]]\ncrank = {{ swing = {size} }}\n"
            ),
        ] {
            if let Ok(file) = TaskFile::parse(&text, "size") {
                let order = SynthesisSettings {
                    seed: 1,
                    threads: 2,
                };
                let found = Synthesis::run(&file.task, order, &mut |_| true);
                for candidate in &found.good {
                    let figures = candidate.figures;
                    let output = [
                        figures.miss,
                        figures.rms,
                        figures.transmission,
                        figures.ratio,
                    ];
                    assert!(
                        output.iter().all(|value| value.is_finite()),
                        "{text}{figures:?}"
                    );
                }
            }
        }
    }
}

/// Unicode output must be as harmless as ASCII output.
#[test]
fn error_messages_contain_no_control_characters() {
    for path in broken() {
        let bytes = std::fs::read(&path).unwrap();
        let Some(faults) = faults(&bytes, "evil\u{1b}[2J\u{202e}.toml") else {
            continue;
        };
        let rendered = faults.render(false, false);
        let harmful = |c: char| c != '\n' && krank::scene::is_harmful(c);
        assert!(
            !rendered.contains(harmful),
            "{}: {rendered:?}",
            path.display()
        );
    }
}
