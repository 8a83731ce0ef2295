//! The keys of task files.

use crate::scene::KeyKind::{Flag, Number, Rows, Series, Table, Text};
use crate::scene::NumberMeasure::{Driver, Of};
use crate::scene::NumberRule::{Acute, Any, AtLeastOne, PositiveNumber};
use crate::scene::{Measure, SceneKey};

/// The keys of a task, each with the kinds of tasks that have it; no kind means all.
pub(super) const TASK: &[SceneKey] = &[
    SceneKey::new("kind", Text, &[]),
    SceneKey::new("name", Text, &[]),
    SceneKey::new("source", Text, &[]),
    SceneKey::new("note", Text, &[]),
    SceneKey::new("unit", Text, &[]),
    SceneKey::new("linkages", Text, &[]),
    SceneKey::new("poses", Rows, &["poses"]),
    SceneKey::new("points", Rows, &["path"]),
    SceneKey::new("pairs", Rows, &["function"]),
    SceneKey::new("pivots", Rows, &["poses", "path"]),
    SceneKey::new("pins", Rows, &["poses"]),
    SceneKey::new("closed", Flag, &["path"]),
    SceneKey::new("turns", Series(Of(Measure::Angle)), &["path"]),
    SceneKey::new("weights", Series(Of(Measure::Factor)), &["path"]),
    SceneKey::new("function", Table(FUNCTION), &["function"]),
    SceneKey::new("crank", Table(SIDE), &["function"]),
    SceneKey::new("output", Table(SIDE), &["function"]),
    SceneKey::new(
        "size",
        Number(Of(Measure::Length), PositiveNumber),
        &["function"],
    ),
    SceneKey::new("wishes", Table(WISHES), &[]),
];

pub(super) const FUNCTION: &[SceneKey] = &[
    SceneKey::new("y", Text, &[]),
    SceneKey::new("from", Number(Of(Measure::Parameter), Any), &[]),
    SceneKey::new("to", Number(Of(Measure::Parameter), Any), &[]),
    SceneKey::new("points", Number(Of(Measure::Parameter), Any), &[]),
];

/// The keys of the crank, and of the output, which turns or slides.
pub(super) const SIDE: &[SceneKey] = &[
    SceneKey::new("start", Number(Driver, Any), &[]),
    SceneKey::new("swing", Number(Driver, Any), &[]),
    SceneKey::new("scale", Number(Of(Measure::Parameter), Any), &[]),
];

pub(super) const WISHES: &[SceneKey] = &[
    SceneKey::new("full-turn", Flag, &[]),
    SceneKey::new("transmission", Number(Of(Measure::Angle), Acute), &[]),
    SceneKey::new("inside", Rows, &[]),
    SceneKey::new("ratio", Number(Of(Measure::Factor), AtLeastOne), &[]),
    SceneKey::new("order", Flag, &[]),
    SceneKey::new("direction", Text, &[]),
];

/// Returns the keys that only some kinds of tasks have, this one among them.
pub(super) fn of_kind(kind: &str) -> Vec<&'static str> {
    let own = TASK.iter().filter(|key| key.is_of(kind));
    own.map(|key| key.name).collect()
}
