//! Tests task files and their diagnostics.

use super::*;
use crate::synthesis::{GivenNumber, Sense};
use crate::wording::Language;

fn read(text: &str) -> TaskFile {
    TaskFile::parse(text, "test").unwrap_or_else(|faults| panic!("{}", faults.first_words()))
}

fn fault(text: &str) -> (String, String) {
    let faults = TaskFile::parse(text, "test").unwrap_err();
    let first = &faults.items[0];
    let span = first
        .primary
        .as_ref()
        .map_or(0..0, |label| label.span.clone());
    (first.message.clone(), text[span].to_owned())
}

const POSES: &str = "kind = \"poses\"\nposes = [[0, 0, 0], [120, 40, 35], [180, 130, 80]]\n";

#[test]
fn pose_task_has_pivots_and_preferences() {
    let file = read(&format!(
        "name = \"lid\"\nunit = \"cm\"\n{POSES}pivots = [[0, -100], [\"10 in\", -100]]\n\
         [wishes]\ntransmission = 40\nfull-turn = true\ndirection = \"clockwise\"\n"
    ));
    assert_eq!((file.name.as_str(), file.unit), ("lid", Unit::Centimetre));
    assert!(file.task.four_bars && !file.task.slider_cranks);
    let preferences = file.task.preferences;
    assert!(preferences.full_turn && preferences.ordered);
    assert_eq!(
        (preferences.transmission, preferences.sense),
        (Some(40.0), Some(Sense::Clockwise))
    );
    let TaskKind::Poses(task) = file.task.kind else {
        panic!()
    };
    assert_eq!(task.poses[1].angle, 35.0);
    assert_eq!(task.pivots[1], Vec2::new(25.4, -100.0));
}

#[test]
fn function_task_samples_formula_over_range() {
    let file = read(
        "kind = \"function\"\nfunction = { y = \"log10(x)\", from = 1, to = 2, points = 3 }\n\
         crank = { swing = 60, start = 45 }\noutput = { swing = 60 }\nsize = 50\n",
    );
    let TaskKind::Function(task) = file.task.kind else {
        panic!()
    };
    assert_eq!(task.pairs.len(), 3);
    assert!((task.pairs[1][1] - 1.5_f64.log10()).abs() < 1e-15);
    assert_eq!(task.between.len(), 181);
    // 60 degrees from x = 1 to x = 2, with 45 degrees at x = 1.
    assert_eq!(task.crank_scale, GivenNumber::Value(60.0));
    assert_eq!(task.crank_datum, GivenNumber::Value(-15.0));
    assert_eq!(task.output_datum, GivenNumber::Free);
    let GivenNumber::Value(scale) = task.output_scale else {
        panic!()
    };
    assert!((scale - 60.0 / 2.0_f64.log10()).abs() < 1e-12);
}

/// `start` belongs to the minimum x, where a decreasing function has its maximum y.
#[test]
fn decreasing_function_starts_at_minimum_x() {
    for function in [
        "function = { y = \"1 / x\", from = 1, to = 2 }",
        "pairs = [[1, 1], [1.5, 0.7], [2, 0.5]]",
    ] {
        let file = read(&format!(
            "kind = \"function\"\n{function}\ncrank = {{ swing = 60, start = 45 }}\n\
             output = {{ swing = 60, start = 90 }}\n"
        ));
        let TaskKind::Function(task) = file.task.kind else {
            panic!()
        };
        let at = |datum: GivenNumber, scale: GivenNumber, value: f64| match (datum, scale) {
            (GivenNumber::Value(datum), GivenNumber::Value(scale)) => datum + scale * value,
            _ => panic!("both are given"),
        };
        for (x, y, crank, output) in [(1.0, 1.0, 45.0, 90.0), (2.0, 0.5, 105.0, 30.0)] {
            assert!((at(task.crank_datum, task.crank_scale, x) - crank).abs() < 1e-12);
            assert!((at(task.output_datum, task.output_scale, y) - output).abs() < 1e-12);
        }
    }
}

#[test]
fn path_task_has_points_turns_and_weights() {
    let file = read(
        "kind = \"path\"\nlinkages = [\"four-bar\", \"slider-crank\"]\nclosed = true\n\
         points = [[0, 0], [10, 0], [10, 10]]\nturns = [0, 120, 240]\nweights = [1, 2, 1]\n",
    );
    assert!(file.task.four_bars && file.task.slider_cranks);
    let TaskKind::Path(task) = file.task.kind else {
        panic!()
    };
    assert!(task.closed);
    assert_eq!(task.turns, Some(vec![0.0, 120.0, 240.0]));
    assert_eq!(task.weights, [1.0, 2.0, 1.0]);
}

#[test]
fn faults_point_at_their_place() {
    let path = "kind = \"path\"\n";
    let function = "kind = \"function\"\n";
    for (text, message, place) in [
        (
            "poses = [[0, 0, 0]]\n".to_owned(),
            "the task has no `kind`",
            "",
        ),
        (
            "kind = \"pose\"\n".into(),
            "`pose` is not a kind of task",
            "\"pose\"",
        ),
        ("kind = \"poses\"\n".into(), "`poses` lacks `poses`", ""),
        (
            "kind = \"poses\"\nposes = [[0, 0, 0], [1, 1, 0]]\n".into(),
            "a task of poses has 3 to 5 of them, not 2",
            "[[0, 0, 0], [1, 1, 0]]",
        ),
        (
            "kind = \"poses\"\nposes = [[0, 0, 0], [1, 1, 0], [0, 0, 360]]\n".into(),
            "number 3 repeats number 1",
            "[0, 0, 360]",
        ),
        (
            "kind = \"poses\"\nposes = [[0, 0, 0], [1, 1], [0, 0, 5]]\n".into(),
            "number 2 of `poses` must be [x, y, angle], not a list of 2",
            "[1, 1]",
        ),
        (
            format!("{POSES}pivots = [[0, 0], [1, 0], [2, 0]]\n"),
            "3 poses do not allow 3 given pivots and pins",
            "[2, 0]",
        ),
        (
            format!("{POSES}closed = true\n"),
            "`closed` does not belong to a task of the kind `poses`",
            "closed",
        ),
        (
            format!("{POSES}[wishes]\ntransmission = 95\n"),
            "`transmission` must be at least 0 and below 90, not `95`",
            "95",
        ),
        (
            format!("{POSES}[wishes]\nratio = 0.5\n"),
            "`ratio` must be at least 1, not `0.5`",
            "0.5",
        ),
        (
            format!("{POSES}pivots = [[0, 0]]\n[wishes]\ninside = [[10, 10], [20, 20]]\n"),
            "a given pivot lies outside the box for pivots",
            "[0, 0]",
        ),
        (
            format!("{path}points = [[1, 2]]\n"),
            "a path has 2 to 1000 points, not 1",
            "[[1, 2]]",
        ),
        (
            format!("{path}points = [[1, 2], [1, 2], [3, 4]]\n"),
            "number 2 repeats number 1",
            "[1, 2]",
        ),
        (
            format!("{path}points = [[1, 2], [3, 4]]\nturns = [0, 30, 60]\n"),
            "`turns` has 3 numbers for 2 points",
            "[0, 30, 60]",
        ),
        (
            format!("{function}pairs = [[0, 0], [30, 1], [30, 2]]\n"),
            "the x of pair 3 is not larger than that of the pair before it",
            "[30, 2]",
        ),
        (
            format!("{function}pairs = [[0, 0], [30, 1], [40, 2]]\nlinkages = [\"six-bar\"]\n"),
            "`six-bar` is not a supported linkage",
            "\"six-bar\"",
        ),
    ] {
        assert_eq!(
            fault(&text),
            (message.to_owned(), place.to_owned()),
            "{text}"
        );
    }
}

#[test]
fn titles_of_built_in_tasks_are_translated() {
    for task in ExampleTask::all() {
        let file = read(task.text);
        Language::English.speak();
        assert_eq!(file.title(), file.name);
        Language::Turkish.speak();
        assert_ne!(file.title(), file.name, "{}", task.name);
    }
    Language::English.speak();
}
