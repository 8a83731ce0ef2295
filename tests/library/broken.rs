//! Every file of `tests/broken` is refused, with the phrases and at the places that its head names:
//! `# expect: a phrase of the message` and `# at: LINE:COLUMN`, each as often as wanted.

use krank::quantity::check_figures;
use krank::scene::{Diagnostics, Scene};
use krank::solver::Solver;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn broken() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/broken");
    let entries = std::fs::read_dir(&folder).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

/// What is wrong with a file; reading comes before solving, as for every command.
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

/// The complaints about one file, empty if it is refused as its head says.
fn check(path: &Path) -> Vec<String> {
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
fn every_broken_scene_is_refused_with_its_phrase_and_place() {
    let mut report = String::new();
    let files = broken();
    assert!(files.len() >= 40, "only {} broken scenes", files.len());
    for path in &files {
        for complaint in check(path) {
            report += &format!("{}: {complaint}\n", path.display());
        }
    }
    assert!(report.is_empty(), "{report}");
}

/// What is shown in Unicode and in colour must be as harmless as the plain form.
#[test]
fn no_control_character_of_a_file_reaches_the_terminal() {
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
