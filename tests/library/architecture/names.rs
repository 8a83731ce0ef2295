//! The name of a type is one thing's: whoever reads it knows which one is meant.

use super::sources;
use std::collections::BTreeMap;
use std::fs;

/// Each is built for one kind of machine or another, or with a feature or without it, and never both.
const TWINS: [&str; 6] = [
    "Canvas",
    "LockOutcome",
    "Output",
    "Pixels",
    "Progress",
    "Watch",
];

/// The type that a line of source begins to tell of, if it does; what belongs to another one stands further in.
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

/// The reader of lines on samples.
#[test]
fn types_are_told_from_what_belongs_to_them() {
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
