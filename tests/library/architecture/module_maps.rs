//! Checks the maps at the top of modules: they list exactly the modules below.

use super::sources;
use std::collections::BTreeSet;
use std::fs;

/// Returns the names that the first lines of a file list: `//! name, name  text` or
/// `//! | `name`, `name` | text |`.
fn listed(text: &str) -> Vec<String> {
    let head = text.lines().map_while(|line| line.strip_prefix("//!"));
    let names = |line: &str| {
        let line = line.strip_prefix(' ')?.trim_start_matches("  -> ");
        match line.strip_prefix("| `") {
            Some(row) => row.split_once("` |").map(|(names, _)| names.to_owned()),
            None => line.split_once("  ").map(|(names, _)| names.to_owned()),
        }
    };
    let lists = head.filter_map(names).filter(|names| {
        let allowed = |c: char| c.is_ascii_lowercase() || "_, `".contains(c);
        !names.is_empty() && names.chars().all(allowed)
    });
    let lists: Vec<String> = lists.collect();
    let names = lists.iter().flat_map(|names| names.split(", "));
    names
        .map(|name| name.trim_matches('`').to_owned())
        .collect()
}

/// Returns the modules that a file declares, except tests.
fn declared(text: &str) -> BTreeSet<String> {
    let module = |line: &str| {
        let (_, name) = line.strip_suffix(';')?.rsplit_once("mod ")?;
        let is_name = name.chars().all(|c| c.is_ascii_lowercase() || c == '_');
        (is_name && !line.starts_with(' ') && !name.contains("test")).then(|| name.to_owned())
    };
    text.lines().filter_map(module).collect()
}

/// Returns the difference of a map and the modules of its file; `None` without a map. A list with
/// less than two modules is about something else.
fn faults(text: &str) -> Option<Vec<String>> {
    let (listed, declared) = (listed(text), declared(text));
    if listed
        .iter()
        .filter(|name| declared.contains(*name))
        .count()
        < 2
    {
        return None;
    }
    let unknown = listed.iter().filter(|name| !declared.contains(*name));
    let missing = declared.iter().filter(|name| !listed.contains(name));
    let unknown = unknown.map(|name| format!("no module `{name}`"));
    Some(
        unknown
            .chain(missing.map(|name| format!("`{name}` is not listed")))
            .collect(),
    )
}

#[test]
fn module_maps_list_exactly_the_modules() {
    let mut maps = 0;
    let mut all = Vec::new();
    for (file, inner) in sources() {
        // The first page of a crate shows its data flow, not its files.
        if inner.ends_with("lib.rs") {
            continue;
        }
        let Some(found) = faults(&fs::read_to_string(&file).unwrap()) else {
            continue;
        };
        maps += 1;
        all.extend(
            found
                .iter()
                .map(|fault| format!("{}: {fault}", inner.display())),
        );
    }
    assert!(maps >= 9, "{maps}");
    assert!(all.is_empty(), "\n{}\n", all.join("\n"));
}

#[test]
fn wrong_maps_are_found() {
    let modules = "mod one;\npub(crate) mod two;\nmod three;\n#[cfg(test)]\nmod tests;\n";
    let found = |map: &str| faults(&format!("{map}\n\n{modules}"));
    assert_eq!(
        found("//! one, two  text\n//! three     text"),
        Some(vec![])
    );
    assert_eq!(
        found("//! | `one`, `two` | text |\n//! | `three` | text |"),
        Some(vec![])
    );
    assert_eq!(found("//! Text of two  sentences."), None);
    let wrong = found("//! one   text\n//! two   text\n//! four  text").unwrap();
    assert_eq!(wrong, ["no module `four`", "`three` is not listed"]);
}
