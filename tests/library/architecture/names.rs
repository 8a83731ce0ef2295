//! Checks that type names are unique across krank.

use super::sources;
use std::collections::BTreeMap;
use std::fs;

/// Types with two definitions for different platforms or features, only one of which is compiled.
const TWINS: [&str; 6] = [
    "Canvas",
    "LockOutcome",
    "Output",
    "Pixels",
    "Progress",
    "Watch",
];

/// Returns the name of the top-level type that a source line declares. Indented lines, such as
/// associated types, do not count.
fn type_of(line: &str) -> Option<&str> {
    let line = match line.strip_prefix("pub(") {
        Some(inside) => inside.split_once(") ")?.1,
        None => line.strip_prefix("pub ").unwrap_or(line),
    };
    let (kind, rest) = line.split_once(' ')?;
    let name = rest.split(|c: char| !c.is_alphanumeric()).next()?;
    ["struct", "enum", "trait", "type"]
        .contains(&kind)
        .then_some(name)
}

#[test]
fn no_two_types_share_a_name() {
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (file, place) in sources() {
        let text = fs::read_to_string(&file).unwrap();
        for name in text.lines().filter_map(type_of) {
            places
                .entry(name.to_owned())
                .or_default()
                .push(place.display().to_string());
        }
    }
    assert!(
        places.contains_key("Mechanism") && places.len() > 500,
        "{}",
        places.len()
    );
    places.retain(|name, places| places.len() > 1 && !TWINS.contains(&name.as_str()));
    assert!(places.is_empty(), "{places:#?}");
}

/// Tests the line parser on samples.
#[test]
fn type_of_finds_only_top_level_types() {
    assert_eq!(
        type_of("pub(in crate::solver) struct Arm<T = f64> {"),
        Some("Arm")
    );
    assert_eq!(type_of("pub enum Element {"), Some("Element"));
    assert_eq!(type_of("type Row = (u8, String);"), Some("Row"));
    assert_eq!(type_of("    type Output = Self;"), None);
    assert_eq!(type_of("/// struct Arm"), None);
    assert_eq!(type_of("impl Display for Arm {"), None);
}
