//! Tests designs against closed formulas, which are written out here.

use super::*;
use crate::quantity::Catalogue;
use crate::scene::presets;
use crate::study::CycleFigure;

fn opened(name: &str) -> (Scene, Solver) {
    let preset = presets::find(name).unwrap();
    let scene = Scene::parse(preset.text, name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

pub(super) fn space(name: &str, values: &[&str]) -> DesignSpace {
    space_of(presets::find(name).unwrap().text, values)
}

pub(super) fn space_of(text: &str, values: &[&str]) -> DesignSpace {
    let scene = Scene::parse(text, "design.toml").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let all = scene.values();
    let value = |name: &&str| {
        all.iter()
            .find(|value| value.name == *name)
            .unwrap()
            .clone()
    };
    let values = values.iter().map(value).collect();
    DesignSpace::new(&scene, &solver, values)
}

pub(super) fn figures(space: &DesignSpace, names: &[&str]) -> DesignFigures {
    let catalogue = Catalogue::new(space.scene());
    let figures = names
        .iter()
        .map(|name| CycleFigure::parse(name, &catalogue).unwrap());
    DesignFigures::new(space, figures.collect(), None)
}

pub(super) fn goals(space: &DesignSpace, texts: &[&str]) -> Vec<Goal> {
    let catalogue = Catalogue::new(space.scene());
    texts
        .iter()
        .map(|text| Goal::parse(text, &catalogue).unwrap())
        .collect()
}

pub(super) fn axes(texts: &[&str]) -> Vec<PlanAxis> {
    texts.iter().map(|text| text.parse().unwrap()).collect()
}

/// A goal accepts any unit of its measure.
#[test]
fn goals_are_converted_to_unit_of_their_value() {
    let preset = crate::scene::presets::find("slider-crank").unwrap();
    let scene = crate::scene::Scene::parse(preset.text, "test").unwrap();
    let catalogue = Catalogue::new(&scene);
    let number = |text: &str| Goal::parse(text, &catalogue).map(|goal| goal.number);
    assert_eq!(number("C.x.stroke = 3,5"), Ok(3.5));
    assert_eq!(number("C.x@60,5 <= -0,25 in"), Ok(-0.635));
    let named = Goal::parse("C.x@60,5 = 1", &catalogue).unwrap().figure;
    assert_eq!(named.name(), "C.x@60.5");
    let unclear = number("C.x.stroke = 1,500").unwrap_err().to_string();
    assert!(unclear.starts_with("1,500: leave out"), "{unclear}");
    // The scene is in cm.
    for (text, expected) in [
        ("r4.length.stroke = 120 mm", 12.0),
        ("r4.length.stroke = 5 in", 12.7),
        ("r4.length.stroke = 5in", 12.7),
        ("r4.length.stroke = 13 cm", 13.0),
        ("r4.length.stroke = 13", 13.0),
        ("r3.angle.swing <= 1.2 rad", 68.754_935_415_698_78),
    ] {
        assert_eq!(number(text).unwrap(), expected, "{text}");
    }
    for (text, shown_text) in [
        ("r4.length.stroke = 5 kg", "has the unit cm, not kg"),
        ("r4.length.ratio = 5 mm", "has no unit, not mm"),
        ("r4.length.stroke = long", "is not a goal"),
    ] {
        let why = number(text).unwrap_err().to_string();
        assert!(why.contains(shown_text), "{why}");
    }
}

/// Returns the stroke of an offset slider-crank between its dead centres: sqrt((l + r)^2 - e^2) -
/// sqrt((l - r)^2 - e^2).
pub(super) fn stroke(r: f64, l: f64, e: f64) -> f64 {
    ((l + r).powi(2) - e * e).sqrt() - ((l - r).powi(2) - e * e).sqrt()
}

/// Every design of a grid has the stroke of the closed formula, evaluated in place and opened. Some
/// cranks do not turn fully.
#[test]
fn design_strokes_match_closed_formula() {
    let space = space(
        "offset-slider-crank",
        &["r2 length", "r3 length", "r4 through y"],
    );
    let mut found = figures(&space, &["r4.length.stroke"]);
    let axes = axes(&["r2=60..140/5", "r3=200..340/5", "e=-40..40/3"]);
    let plan = DesignPlan::grid(&axes, &space.given());
    assert_eq!(plan.count(), 75);
    let mut quick = 0;
    for k in 0..plan.count() {
        let numbers = plan.numbers(k);
        let [r, l, e] = numbers[..] else { panic!() };
        quick += usize::from(found.in_place(&numbers).is_some());
        let value = found.of(&numbers).unwrap()[0].unwrap();
        let known = stroke(r, l, e);
        assert!(
            (value - known).abs() < 1e-9 * known,
            "{numbers:?}: {value} {known}"
        );
        let opened = found.of_design(&space.open(&numbers).unwrap())[0].unwrap();
        assert!(
            (opened - known).abs() < 1e-9 * known,
            "{numbers:?}: {opened} {known}"
        );
    }
    assert!(quick > 40, "only {quick} of 75 in place");
}

/// A five-bar whose second crank follows the first at a ratio.
const TIMED: &str = r#"
unit = "mm"
[ground]
A = [0, 0]
E = [400, 0]
[driver]
link = "r2"
angle = 60
speed = "1 rad/s"
[inputs]
r5 = { ratio = 2, phase = 30 }
[links]
r2 = { from = "A", to = "B", length = 50 }
r3 = { from = "B", to = "C", length = 300 }
r4 = { from = "D", to = "C", length = 320 }
r5 = { from = "E", to = "D", length = 40 }
[start]
C = [250, 200]
"#;

/// The relative and absolute difference that rounding errors cause between two computations.
const ROUNDING_TOLERANCE: f64 = 1e-9;

/// Returns how many of 40 designs around the given one are evaluated in place; checks that all have
/// the figures of the opened scene.
fn held_in_place(space: &DesignSpace, names: &[&str], part: f64) -> u32 {
    let mut found = figures(space, names);
    let given = space.given();
    let around = |v: &f64| PlanAxis {
        name: String::new(),
        ends: Some([(1.0 - part) * v, (1.0 + part) * v]),
        count: None,
    };
    let axes: Vec<PlanAxis> = given.iter().map(around).collect();
    let plan = DesignPlan::latin(&axes, &given, 40, 7);
    let mut quick = 0;
    for k in 0..plan.count() {
        let numbers = plan.numbers(k);
        if found.in_place(&numbers).is_none() {
            continue;
        }
        let one = found.of(&numbers).unwrap();
        let other = found.of_design(&space.open(&numbers).unwrap());
        for (one, other) in one.iter().zip(&other) {
            let (one, other) = (one.unwrap(), other.unwrap());
            let name = &space.scene().name;
            assert!(
                (one - other).abs() <= ROUNDING_TOLERANCE * other.abs().max(1.0),
                "{name} {numbers:?}: {one} {other}"
            );
        }
        quick += 1;
    }
    quick
}

/// Values computed in place equal those of the scene opened with the same numbers. Checks random
/// designs of several mechanisms, also with further inputs.
#[test]
fn designs_in_place_match_opened_scenes() {
    for (name, names) in [
        (
            "four-bar",
            vec!["C.x.stroke", "r4.angle.swing", "C.x@60", "transmission"],
        ),
        ("press", vec!["r6.angle.swing", "range"]),
        ("hoecken", vec!["P.x.stroke", "P.y.least"]),
        ("whitworth", vec!["r6.length.stroke", "r6.length.ratio"]),
    ] {
        let (scene, _) = opened(name);
        let all: Vec<String> = scene.values().into_iter().map(|value| value.name).collect();
        let values = all.iter().map(String::as_str);
        let values: Vec<&str> = values
            .filter(|name| name.ends_with(" length"))
            .take(4)
            .collect();
        let quick = held_in_place(&space(name, &values), &names, 0.03);
        assert!(quick > 10, "{name}: only {quick} in place");
    }
    // A second crank: its length changes in place, its ratio and its phase do not.
    let figures = ["C.x@60", "C.y.greatest"];
    let quick = held_in_place(&space_of(TIMED, &["r5 length"]), &figures, 0.03);
    assert!(quick > 10, "only {quick} with a second crank");
    for values in [["r5 length", "r5 phase"], ["r5 length", "r5 ratio"]] {
        let quick = held_in_place(&space_of(TIMED, &values), &figures, 0.03);
        assert_eq!(quick, 0, "{values:?}");
    }
}

/// A four-bar with lengths and a coordinate computed from two parameters.
const PARAMETERS: &str = r#"
unit = "mm"
[parameters]
a = 100
wide = "far + 2 * a"
far = "20 cm"
[ground]
A = [0, 0]
D = ["wide", 0]
[driver]
link = "r2"
angle = 60
speed = "a / 10 rad/s"
[links]
r2 = { from = "A", to = "B", length = "a", mass = 2, com = ["a / 2", 0] }
r3 = { from = "B", to = "C", length = "far + a", points = { P = ["far / 2", "a"] } }
r4 = { from = "D", to = "C", length = 250 }
[start]
C = ["a + far", 200]
"#;

/// Values computed from parameters change in place, like values of plain lengths. A speed does not:
/// then the text is parsed.
#[test]
fn computed_lengths_in_place_match_opened_scenes() {
    let names = ["P.x.stroke", "r4.angle.swing", "transmission", "C.x@60"];
    let steady = PARAMETERS.replace("a / 10 rad/s", "1 rad/s");
    for (text, values, is_plain) in [
        (&steady[..], vec!["a", "far"], true),
        (&steady, vec!["far", "r4 length"], true),
        (&steady, vec!["wide", "a", "r3 length"], true),
        (PARAMETERS, vec!["a", "far"], false),
    ] {
        let space = space_of(text, &values);
        let mut found = figures(&space, &names);
        let given = space.given();
        for k in 0..20 {
            let part = 1.0 + 0.002 * f64::from(k);
            let numbers: Vec<f64> = given.iter().map(|v| v * part).collect();
            assert_eq!(found.mechanism(&numbers).is_some(), is_plain, "{values:?}");
            let one = found.of(&numbers).unwrap();
            let other = found.of_design(&space.open(&numbers).unwrap());
            for (one, other) in one.into_iter().zip(other) {
                let (one, other) = (one.unwrap(), other.unwrap());
                let off = (one - other).abs();
                assert!(
                    off <= ROUNDING_TOLERANCE * other.abs().max(1.0),
                    "{numbers:?}: {one} {other}"
                );
            }
        }
    }
}

/// The given rocker stays between its stops; with other lengths it reaches one. Then the range ends
/// there, both in place and opened.
#[test]
fn design_in_place_respects_stops() {
    let preset = presets::find("four-bar").unwrap().text;
    let (low, high) = {
        let space = space_of(preset, &["r2 length"]);
        let swing = figures(&space, &["r4.angle.least", "r4.angle.greatest"]).of(&[100.0]);
        let swing = swing.unwrap();
        (swing[0].unwrap(), swing[1].unwrap())
    };
    let text = format!("{preset}\n[limits]\nr4 = [{}, {}]\n", low - 2.0, high + 2.0);
    let space = space_of(&text, &["r2 length"]);
    let mut found = figures(&space, &["range"]);
    assert_eq!(found.of(&[100.0]).unwrap(), [Ok(360.0)]);
    let opened = space.open(&[115.0]).unwrap();
    let known = found.of_design(&opened)[0].unwrap();
    assert!(known < 330.0, "{known}");
    assert_eq!(found.of(&[115.0]).unwrap(), [Ok(known)]);
    held_in_place(&space, &["range"], 0.15);
}

/// A design that cannot assemble is an error with a reason, and never another assembly.
#[test]
fn design_that_cannot_assemble_reports_reason() {
    let space = space("four-bar", &["r3 length"]);
    let mut found = figures(&space, &["C.x@60"]);
    let reason = found.of(&[20.0]).unwrap_err().reason();
    assert!(
        reason.contains("assemble") || reason.contains("close"),
        "{reason}"
    );
}

#[test]
fn grid_and_latin_hypercube_have_expected_points() {
    let axes = axes(&["a=90..110/3", "b=0.1..0.3/3"]);
    let plan = DesignPlan::grid(&axes, &[100.0, 0.2]);
    let all: Vec<Vec<f64>> = (0..plan.count()).map(|k| plan.numbers(k)).collect();
    assert_eq!(all[0], [90.0, 0.1]);
    assert_eq!(all[1], [90.0, 0.2]);
    assert_eq!(all[8], [110.0, 0.3]);
    let plan = DesignPlan::latin(&axes, &[100.0, 0.2], 10, 5);
    let mut firsts: Vec<f64> = (0..10).map(|k| plan.numbers(k)[0]).collect();
    firsts.sort_by(f64::total_cmp);
    let known: Vec<f64> = (0..10).map(|k| 91.0 + 2.0 * f64::from(k)).collect();
    assert_eq!(firsts, known);
    for text in ["", "=1..2", "a=1", "a=1..x", "a=1..2/0", "a=1..2/x"] {
        assert!(text.parse::<PlanAxis>().is_err(), "{text}");
    }
    let listed = PlanAxis::listed("a=0,5..1,25/4, b").unwrap();
    assert_eq!(listed[0].ends, Some([0.5, 1.25]));
    assert_eq!((listed[0].count, listed.len()), (Some(4), 2));
    let unclear = PlanAxis::listed("a=1,500..2").unwrap_err().to_string();
    assert!(unclear.starts_with("1,500: leave out"), "{unclear}");
}

/// Changing a parameter changes every value whose formula uses it. A scene scaled by s has its
/// stroke scaled by s.
#[test]
fn dependent_values_change_with_their_parameter() {
    let text = "unit = \"mm\"\n[parameters]\na = 10\n[ground]\nA = [0, 0]\n[driver]\nlink = \"r2\"\nangle = 60\n\
                speed = \"1 rad/s\"\n[links]\nr2 = { from = \"A\", to = \"B\", length = \"a\" }\n\
                r3 = { from = \"B\", to = \"C\", length = \"4 * a\" }\n[slides]\n\
                r4 = { point = \"C\", on = \"ground\", through = [0, 0], angle = 0 }\n[start]\nC = [40, 0]\n";
    let scene = Scene::parse(text, "test").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let value = scene.value_named("a").unwrap();
    let space = DesignSpace::new(&scene, &solver, vec![value]);
    let mut found = figures(&space, &["r4.length.stroke", "transmission"]);
    for a in [7.0, 10.0, 25.0] {
        let figures = found.of(&[a]).unwrap();
        let [stroke, angle] = [figures[0].unwrap(), figures[1].unwrap()];
        assert!((stroke - 2.0 * a).abs() < 1e-9 * a, "{a}: {stroke}");
        // The angle between rod and guide is largest where its sine is r / l.
        let known = 0.25_f64.acos().to_degrees();
        assert!((angle - known).abs() < 1e-9, "{angle} {known}");
    }
}

/// Rows arrive in the order of the plan, and the receiver can stop the run.
#[test]
fn rows_arrive_in_plan_order_until_stopped() {
    let space = space("slider-crank", &["r2 length"]);
    let figures = figures(&space, &["r4.length.stroke"]);
    let plan = DesignPlan::grid(&axes(&["r2=5..10/501"]), &space.given());
    let run = DesignRun {
        figures: &figures,
        plan: &plan,
        designs: 7..501,
        threads: 3,
    };
    let mut next = 7;
    let complete = run.each(&mut |rows| {
        for row in rows {
            assert_eq!(row.numbers, plan.numbers(next));
            let stroke = row.figure(0).unwrap();
            assert!((stroke - 2.0 * row.numbers[0]).abs() < 1e-9, "{row:?}");
            next += 1;
        }
        Ok::<(), ()>(())
    });
    assert_eq!((complete, next), (Ok(()), 501));
    let mut taken = 0;
    let enough = run.each(&mut |rows| {
        taken += rows.len();
        if taken > 100 { Err("enough") } else { Ok(()) }
    });
    assert_eq!(enough, Err("enough"));
    assert!(taken < 200);
}

/// Rows of a study do not jump where a direction passes a full turn. The given coupler is just
/// below it; with other lengths it is on both sides.
#[test]
fn directions_of_study_do_not_jump_at_full_turn() {
    let space = space("four-bar", &["r2 length"]);
    // With r3 level, C is at (350, 50 sqrt 3), and D on the ground at a distance of 250.
    let level = 350.0 + (250.0_f64.powi(2) - 7_500.0).sqrt() - 1e-3;
    let text = space
        .scene()
        .text()
        .replace("D = [400, 0]", &format!("D = [{level}, 0]"));
    let space = space_of(&text, &["r2 length"]);
    let names = ["r3.angle@60", "C.y.least.at"];
    let figures = figures(&space, &names);
    let plan = DesignPlan::grid(&axes(&["r2=99..101/21"]), &space.given());
    let run = DesignRun {
        figures: &figures,
        plan: &plan,
        designs: 0..21,
        threads: 2,
    };
    let mut rows = Vec::new();
    let _ = run.each(&mut |some| {
        rows.extend(some);
        Ok::<(), ()>(())
    });
    assert_eq!(rows.len(), 21);
    for (index, name) in names.iter().enumerate() {
        let values: Vec<f64> = rows.iter().map(|row| row.figure(index).unwrap()).collect();
        let steps = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        assert!(steps.fold(0.0, f64::max) < 1.0, "{name}: {values:?}");
    }
    let shown_text: Vec<f64> = rows.iter().map(|row| row.figure(0).unwrap()).collect();
    let sides = [0.0, 360.0].map(|turn| {
        shown_text.iter().any(|value| *value < turn) && shown_text.iter().any(|value| *value > turn)
    });
    assert!(sides.contains(&true), "{shown_text:?}");
}

/// Only equality goals take the shorter way around. A direction with a bound is compared as shown.
#[test]
fn direction_bound_is_compared_without_wrapping() {
    let space = space("four-bar", &["D x"]);
    let all = goals(
        &space,
        &[
            "r4.angle@60 = 10",
            "r4.angle@60 >= 10",
            "r4.angle@60 <= 350",
        ],
    );
    let missed = |value: f64| [0, 1, 2].map(|i: usize| all[i].miss(value));
    assert_eq!(missed(300.0), [-70.0, 0.0, 0.0]);
    assert_eq!(missed(355.0), [-15.0, 0.0, 5.0]);
    assert_eq!(missed(5.0), [-5.0, -5.0, 0.0]);
}
