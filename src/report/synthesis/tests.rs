//! Tests reports on poses without a linkage, and on the curves of four poses.

use super::SynthesisReport;
use crate::synthesis::{Synthesis, SynthesisSettings};
use crate::task_file::TaskFile;
use crate::wording::Language;
use serde_json::Value;

const ORDER: SynthesisSettings = SynthesisSettings {
    seed: 1,
    threads: 2,
};

/// Returns the text and the JSON of a task with these poses.
fn text_and_json(poses: &str) -> (String, Value) {
    let text = format!("kind = \"poses\"\nunit = \"mm\"\nposes = {poses}\n");
    let file = TaskFile::parse(&text, "task").unwrap();
    let found = Synthesis::run(&file.task, ORDER, &mut |_| true);
    let report = SynthesisReport {
        file: &file,
        found: &found,
        top: 5,
    };
    (
        report.verdict() + " / " + &report.nothing(),
        report.to_json(),
    )
}

#[test]
fn poses_without_a_linkage_have_a_reason() {
    Language::English.speak();
    let turn = "[[30, 0, 0], [0, 30, 90], [-30, 0, 180], [0, -30, 270]]";
    let shift = "[[0, 0, 5], [10, 2, 5], [20, 10, 5], [25, -10, 5]]";
    let large = "[[1e300, 0, 0], [0, 1e300, 30], [1e300, 1e300, 60]]";
    let small = "[[1e-200, 0, 0], [0, 1e-200, 30], [1e-200, 1e-200, 60]]";
    for (poses, reason, words) in [
        (turn, "turn", "rotations about one point, (0, 0)"),
        (shift, "shift", "the body does not rotate"),
        (large, "range", "too large or too small"),
        (small, "range", "too large or too small"),
    ] {
        let (text, json) = text_and_json(poses);
        assert_eq!(json["reason"], reason, "{text}");
        assert_eq!(text.matches(words).count(), 2, "{text}");
        assert_eq!(json["turned_about"].is_array(), reason == "turn");
    }
}

/// Every point of the curves is a pivot with its pin, or a guide. Three poses have no curves.
#[test]
fn json_contains_curves_of_four_poses() {
    let (_, json) = text_and_json("[[0, 0, 0], [10, 3, 25], [17, 12, 60], [15, 25, 95]]");
    let pieces = json["curves"].as_array().unwrap();
    let spots: Vec<&Value> = pieces.iter().flat_map(|p| p.as_array().unwrap()).collect();
    assert!(spots.len() > 100, "{}", spots.len());
    let pair = |at: &Value| at.as_array().is_some_and(|at| at.len() == 2);
    for spot in spots {
        assert!(pair(&spot["pin"]) && (pair(&spot["pivot"]) || spot["guide"].is_number()));
    }
    assert_eq!(json["reason"], Value::Null);
    let (_, json) = text_and_json("[[0, 0, 0], [10, 3, 25], [17, 12, 60]]");
    assert_eq!(json["curves"].as_array().unwrap().len(), 0);
}
