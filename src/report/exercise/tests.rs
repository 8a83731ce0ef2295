//! Tests grading with values printed in lecture notes, and with answers that have one kind of
//! mistake each.

use super::*;
use crate::report::{Report, ReportFormat};
use crate::scene::{Scene, presets};
use crate::solver::{Order, Solver};
use crate::study::{AnswerKey, Exercise, ExerciseMaker, ExerciseTitles};
use crate::study::{FigureVerdict, RoundedEarly, SheetScene};
use proptest::prelude::*;
use std::path::Path;
use std::sync::LazyLock;

fn key(name: &str, more: &[String]) -> AnswerKey {
    key_at(name, None, more)
}

fn key_at(name: &str, at: Option<f64>, more: &[String]) -> AnswerKey {
    let (scene, solver) = opened(preset(name));
    key_of(
        &scene,
        &solver,
        at.unwrap_or(scene.mechanism.driver().start),
        more,
    )
}

fn preset(name: &str) -> &'static str {
    presets::find(name).unwrap().text
}

fn opened(text: &str) -> (Scene, Solver) {
    let scene = Scene::parse(text, "sheet").unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    (scene, solver)
}

fn key_of(scene: &Scene, solver: &Solver, at: f64, more: &[String]) -> AnswerKey {
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    let _ = solver.solve(at, Order::Force, &mut state);
    solver.enclose(&mut state, Order::Force, &mut enclosure);
    answer_key(scene, solver, state.state(), enclosure.state(), more)
}

/// Grades answers given as lines of `name answer`.
fn graded(name: &str, answers: &str) -> GradedAnswers {
    let rows = answers.lines().map(|line| {
        let (figure, answer) = line.trim().split_once(' ').unwrap();
        format!("{figure};;{answer}\n")
    });
    graded_rows(name, None, &rows.collect::<String>())
}

/// Grades the rows of an answer file.
fn graded_rows(name: &str, at: Option<f64>, rows: &str) -> GradedAnswers {
    graded_file(preset(name), at, rows.as_bytes())
}

/// Grades the bytes of an answer file to a scene.
fn graded_file(scene: &str, at: Option<f64>, bytes: &[u8]) -> GradedAnswers {
    let opened = opened(scene);
    let at = at.unwrap_or(opened.0.mechanism.driver().start);
    graded_by(&opened, at, bytes)
}

/// Grades the bytes of an answer file to an open scene.
fn graded_by((scene, solver): &(Scene, Solver), at: f64, bytes: &[u8]) -> GradedAnswers {
    let file = AnswerFile::read(bytes).unwrap().of_scene(scene);
    let key = key_of(scene, solver, at, &file.names());
    let sheet = SheetScene { scene, solver, at };
    GradedAnswers::new(&key, &file, Path::new("notes.csv"), ("sheet.toml", sheet))
}

/// Returns the answers with their verdicts as text.
fn verdict_lines(name: &str, answers: &str) -> Vec<String> {
    verdict_texts(&graded(name, answers))
}

fn verdict_texts(graded: &GradedAnswers) -> Vec<String> {
    let all = graded.figures.iter().chain(&graded.besides);
    let answered = all.filter(|figure| figure.verdict != FigureVerdict::Empty);
    answered
        .map(|figure| {
            let name = &figure.quantity.name;
            format!(
                "{name} {}: {}",
                figure.written,
                graded.describe_verdict(figure)
            )
        })
        .collect()
}

#[test]
fn week_4_deviations_follow_from_rounded_angle() {
    let notes = "r4.length 28,0
        r3.angle 345,5
        r3.omega -89,45
        r4.rate -1447,93
        r3.alpha 8259
        r4.accel -459977,6";
    assert_eq!(
        verdict_lines("slider-crank", notes),
        [
            "r3.angle 345,5: right",
            "r4.length 28,0: right",
            "r3.omega -89,45: rounded early: r3.angle as 345,5",
            "r4.rate -1447,93: rounded early: r3.angle as 345,5",
            "r3.alpha 8259: rounded early: r3.angle as 345,5",
            "r4.accel -459977,6: rounded early: r3.angle as 345,5",
        ]
    );
}

#[test]
fn week_4_wrong_sign_is_recognized() {
    let notes = "r4.length -28\nr3.angle -14.47";
    assert_eq!(
        verdict_lines("slider-crank", notes),
        [
            "r3.angle -14.47: cut off, not rounded",
            "r4.length -28: wrong sign",
        ]
    );
    // The other root, with its own angle.
    let other = "r3.angle 194.4775\nr4.length -10.7047\nr4.rate 0";
    let graded = graded("slider-crank", other);
    let verdicts: Vec<_> = graded.figures.iter().map(|f| f.verdict).collect();
    assert_eq!(verdicts[..2], [FigureVerdict::OtherAssembly; 2]);
}

#[test]
fn weeks_3_and_7_are_right_except_known_deviations() {
    let notes = "r3.angle 29.38
        r4.angle 290.75
        r3.omega -3.916
        r4.omega 3.091
        r3.alpha 42.27
        r4.alpha 95.5
        B.a 22500
        B.a.angle 240
        C.a 23994.18
        C.a.angle 206.47
        C.a.t 22495
        r3.com.a 22260
        r3.com.a.angle 222.68
        r4.com.a 11997.09
        r4.com.a.angle 206.47";
    let lines = verdict_lines("four-bar", notes);
    let rounded = [
        "C.a 23994.18: rounded early: r4.alpha as 95.5",
        "r4.com.a 11997.09: rounded early: r4.alpha as 95.5",
        "C.a.t 22495: wrong",
    ];
    for line in &lines {
        assert!(
            line.ends_with(": right") || rounded.contains(&line.as_str()),
            "{line}"
        );
    }
    for line in rounded {
        assert!(lines.contains(&line.to_owned()), "{line}: {lines:#?}");
    }
    let drawn = "r3.angle 29.3795\nr4.angle 290.7520";
    let drawn = self::verdict_lines("four-bar", drawn);
    let expected = [
        "r3.angle 29.3795: rounded early",
        "r4.angle 290.7520: rounded early",
    ];
    assert_eq!(drawn, expected);
}

#[test]
fn each_kind_of_mistake_has_its_verdict() {
    for (answer, verdict) in [
        ("r3.angle 0.5128", "in rad"),
        ("r3.angle 29,379 deg", "right"),
        ("r3.angle 389.379", "right"),
        ("r3.angle 209.379", "opposite direction"),
        ("r3.angle -29.379", "wrong sign"),
        ("r3.angle 35", "wrong"),
        ("r3.angle 29", "too few digits"),
        ("r3.angle no", "not a number"),
        ("r3.omega -37.40", "in rpm"),
        ("r3.omega -224.4", "in deg/s"),
        ("r3.omega 3.916", "wrong sign"),
        ("r3.omega -4", "wrong"),
        ("r3.omega -3.9", "too few digits"),
        ("r3.omega -37.4 rpm", "right"),
        ("r3.omega -3.9164 rd/s", "right"),
        ("r3.omega -3.9164 mm", "not a number"),
        ("r3.alpha 2421.7", "in deg/s^2"),
        ("C.v 0.77277", "in m/s"),
        ("C.v 77.277", "in cm/s"),
        ("C.a 23995.1", "right"),
        ("C.a 2.40e4", "right"),
        ("C.a 24000", "right"),
        ("C.a 24,000", "right"),
        ("C.a 23.995", "right"),
        ("C.a 24.0 m/s²", "right"),
        ("C.a 2e4", "wrong"),
        ("C.a 23990", "rounded early"),
    ] {
        let lines = verdict_lines("four-bar", answer);
        let (written, _) = answer.split_once(' ').unwrap();
        assert!(
            lines[0].ends_with(&format!(": {verdict}")),
            "{answer}: {lines:?}"
        );
        assert!(
            lines[0].starts_with(written) && lines.len() == 1,
            "{lines:?}"
        );
    }
}

/// The angle of r3 is 10 degrees off, and later values follow from it: one mistake, and the rest is
/// right given that mistake.
#[test]
fn consequences_of_a_mistake_are_right() {
    let answers = "r3.angle 39.379
        r4.angle 290.7525
        r3.omega -4.1155
        r4.omega 2.1476";
    let graded = graded("four-bar", answers);
    let mistake = graded.mistake().unwrap();
    assert_eq!(mistake.quantity.name, "r3.angle");
    let verdict = |name: &str| {
        let mut figures = graded.figures.iter();
        figures.find(|f| f.quantity.name == name).unwrap().verdict
    };
    assert_eq!(verdict("r3.angle"), FigureVerdict::Wrong);
    // By hand: the scalar product of the velocity equation with the unit vector along r4, then with
    // that along r3.
    let (w2, t2, t3, t4) = (15.0, 60_f64, 39.379_f64, 290.7525_f64);
    let sin = |degrees: f64| degrees.to_radians().sin();
    let w3 = -100.0 * w2 * sin(t2 - t4) / (300.0 * sin(t3 - t4));
    let w4 = -100.0 * w2 * sin(t2 - t3) / (250.0 * sin(t4 - t3));
    let again = format!("r3.angle 39.379\nr4.angle 290.7525\nr3.omega {w3:.4}\nr4.omega {w4:.4}");
    let again = verdict_lines("four-bar", &again);
    assert_eq!(again[2], format!("r3.omega {w3:.4}: right given r3.angle"));
    assert_eq!(again[3], format!("r4.omega {w4:.4}: right given r3.angle"));
    assert!(matches!(
        verdict("r4.angle"),
        FigureVerdict::Right | FigureVerdict::Rounded(RoundedEarly::Near)
    ));
}

/// A student who continues with all digits of a wrong value, but writes down only four, has used
/// more digits than the grader can read.
#[test]
fn unrounded_consequences_of_a_mistake_are_right() {
    let (w2, t2, t3, t4) = (15.0, 60_f64, 39.375_123_f64, 290.752_506_f64);
    let sin = |degrees: f64| degrees.to_radians().sin();
    let w3 = -100.0 * w2 * sin(t2 - t4) / (300.0 * sin(t3 - t4));
    let w4 = -100.0 * w2 * sin(t2 - t3) / (250.0 * sin(t4 - t3));
    let answers = format!("r3.angle 39.38\nr4.angle 290.75\nr3.omega {w3:.5}\nr4.omega {w4:.5}");
    let lines = verdict_lines("four-bar", &answers);
    for line in &lines[2..] {
        assert!(line.ends_with(": right given r3.angle"), "{lines:#?}");
    }
}

/// A last digit worth several degrees is no information: an answer larger than any direction is not
/// right for a direction.
#[test]
fn nonsense_values_earn_no_points() {
    let key = key("press", &[]);
    for nonsense in ["1.00e5", "0e9", "1e9", "-7e12", "1", "-1", "5e3"] {
        let rows = key.figures.iter();
        let rows: String = rows
            .map(|f| format!("{};;{nonsense}\n", f.quantity.name))
            .collect();
        let graded = graded_rows("press", None, &rows);
        let value = graded.figures.iter().filter(|f| f.verdict.earns_point());
        let value: Vec<_> = value
            .map(|f| (&f.quantity.name, f.exact, f.verdict))
            .collect();
        assert!(value.is_empty(), "{nonsense}: {value:?}");
    }
}

/// Only asked values earn points; other answers are graded without points.
#[test]
fn unasked_answers_earn_no_points() {
    let graded = graded(
        "four-bar",
        "A.x 0\nr2.omega 15\nC.a.t 22495\nr3.angle 29.38",
    );
    assert_eq!((graded.figures.len(), graded.points()), (22, 1));
    assert_eq!(graded.besides.len(), 3);
    assert_eq!(
        verdict_texts(&graded),
        [
            "r3.angle 29.38: right",
            "A.x 0: right",
            "r2.omega 15: right",
            "C.a.t 22495: wrong"
        ]
    );
    let page = graded.page().to_text(crate::page::TextStyle::plain(true));
    let (requested, besides) = page.split_once("not asked").unwrap();
    assert!(
        requested.contains("1 points of 22") && !requested.contains("A.x"),
        "{page}"
    );
    assert!(
        besides.contains("A.x [mm]") && besides.contains("C.a.t"),
        "{page}"
    );
}

/// The unit's cell is read.
#[test]
fn unit_column_applies_to_answer() {
    for (row, verdict) in [
        ("C.v;m/s;0,77277", "right"),
        ("C.v;m/s;772,77", "in mm/s"),
        ("C.v;mm/s;0,77277", "in m/s"),
        ("C.v;mm/s;0,77277 m/s", "right"),
        ("C.v;furlong/s;772,77", "right"),
        ("r3.angle;rad;0,51277", "right"),
        ("r3.angle;rad;29,379", "in deg"),
        ("r3.omega;rpm;-37,40", "right"),
        ("C.v;m/s;5", "wrong"),
    ] {
        let graded = graded_rows("four-bar", None, row);
        let lines = verdict_texts(&graded);
        assert!(
            lines[0].ends_with(&format!(": {verdict}")),
            "{row}: {lines:?}"
        );
        // The table shows the unit of an answer next to the exact value in another unit.
        let written = graded
            .figures
            .iter()
            .find(|figure| !figure.written.is_empty());
        let written = &written.unwrap().written;
        let unit = match row {
            "C.v;mm/s;0,77277" | "C.v;furlong/s;772,77" => "",
            "C.v;mm/s;0,77277 m/s" => " m/s",
            _ => row.split(';').nth(1).unwrap(),
        };
        assert!(written.ends_with(unit.trim_start()), "{written}");
        assert_eq!(written.contains(' '), !unit.is_empty(), "{written}");
        let strange: Vec<_> = graded
            .remarks
            .strange_units
            .iter()
            .map(|cell| &cell.text)
            .collect();
        let is_strange = row.contains("furlong");
        assert_eq!(strange, vec!["furlong/s"; usize::from(is_strange)], "{row}");
        let page = graded.page().to_text(crate::page::TextStyle::plain(true));
        assert_eq!(
            page.contains("C.v [furlong/s] in line 1"),
            is_strange,
            "{page}"
        );
    }
}

/// Near 0, the wrong sign, radians and rounding are all close: the verdict that fits exactly has
/// priority.
#[test]
fn small_direction_prefers_exact_sign_and_unit() {
    let at = Some(0.04);
    let key = key_at("slider-crank", at, &[]);
    let small = key.figures[0].exact - 360.0;
    assert!(small.abs() < 0.03, "{small}");
    for (answer, verdict) in [
        (format!("{small:.6}"), "right"),
        (format!("{:.6}", -small), "wrong sign"),
        (format!("{:.8}", small.to_radians()), "in rad"),
        (format!("{:.6}", 1.4 * small), "rounded early"),
    ] {
        let lines = verdict_texts(&graded_rows(
            "slider-crank",
            at,
            &format!("r3.angle;;{answer}\n"),
        ));
        assert_eq!(lines, [format!("r3.angle {answer}: {verdict}")]);
    }
}

/// The lecture notes separate thousands with a comma.
#[test]
fn comma_may_separate_thousands() {
    for written in ["8,259", "8.259", "8259"] {
        let lines = verdict_lines(
            "slider-crank",
            &format!("r3.angle 345,5\nr3.alpha {written}"),
        );
        let expected = format!("r3.alpha {written}: rounded early: r3.angle as 345,5");
        assert_eq!(lines[1..], [expected]);
    }
}

/// Values that differ from 0 only by rounding are 0 in the key.
#[test]
fn key_has_zero_instead_of_rounding_errors() {
    for preset in presets::all() {
        for at in 1..9 {
            let at = Some(f64::from(at) * 40.0);
            for figure in key_at(preset.name, at, &[]).figures {
                let size = figure.exact.abs();
                let is_rounding = !figure.quantity.is_direction() && size > 0.0 && size < 1e-12;
                assert!(!is_rounding, "{} {at:?}: {figure:?}", preset.name);
            }
        }
    }
}

/// A value depends only on its own loop and the preceding ones.
#[test]
fn values_depend_only_on_preceding_loops() {
    let hangs_on = |name: &str, figure: &str| {
        let key = key(name, &[]);
        let requested = key.figures.iter().find(|f| f.quantity.name == figure);
        let chain = key.chain.unwrap();
        chain.variables_of(&requested.unwrap().quantity).len()
    };
    // The crank, r3 and r4; the ram depends on its own loop, too.
    assert_eq!(hangs_on("press", "r3.angle"), 3);
    assert_eq!(hangs_on("press", "F.a"), 5);
}

#[test]
fn other_assembly_of_four_bar_is_recognized() {
    let preset = presets::find("four-bar").unwrap();
    let scene = Scene::parse(preset.text, preset.name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let group = solver.plan().numbered().nth(1).unwrap().0;
    let choices = solver.choices(60.0, group);
    let other = choices.iter().find(|choice| !choice.is_current).unwrap();
    let r3 = scene.mechanism.link_ids().nth(1).unwrap();
    let angle = other.state.angle(r3).unwrap();
    let lines = verdict_lines("four-bar", &format!("r3.angle {angle:.3}"));
    assert_eq!(lines, [format!("r3.angle {angle:.3}: other assembly")]);
}

/// The exact values of every preset, rounded to six digits, are right, and none is asked twice.
#[test]
fn exact_values_are_right_in_every_preset() {
    for preset in presets::all() {
        let key = key(preset.name, &[]);
        assert!(!key.figures.is_empty(), "{}", preset.name);
        let rows = key.figures.iter().map(|f| {
            let name = &f.quantity.name;
            format!("{name};;{:.5e}\n", f.exact)
        });
        let rows = rows.collect::<String>();
        let file = AnswerFile::read(rows.as_bytes()).unwrap();
        let graded = graded_rows(preset.name, None, &rows);
        assert!(graded.remarks.unknown_names.is_empty(), "{}", preset.name);
        for (figure, requested) in graded.figures.iter().zip(&key.figures) {
            // Six digits leave at least three decimals of an angle.
            assert_eq!(
                figure.verdict,
                FigureVerdict::Right,
                "{} {requested:?}",
                preset.name
            );
        }
        let mut names = file.names();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), key.figures.len(), "{}", preset.name);
    }
}

/// In the lectures' scenes, the key asks for every starred value of their tables and for the
/// points.
#[test]
fn key_asks_for_starred_values() {
    let names = |scene: &str| -> Vec<String> {
        let figures = key(scene, &[]).figures.into_iter();
        figures.map(|f| f.quantity.name).collect()
    };
    let slider = [
        "r3.angle",
        "r4.length",
        "r3.omega",
        "r4.rate",
        "r3.alpha",
        "r4.accel",
        "B.v",
        "B.v.angle",
        "C.v",
        "C.v.angle",
        "r3.com.v",
        "r3.com.v.angle",
        "B.a",
        "B.a.angle",
        "C.a",
        "C.a.angle",
        "r3.com.a",
        "r3.com.a.angle",
    ];
    assert_eq!(names("slider-crank"), slider);
    let press = names("press");
    for name in [
        "r3.angle",
        "r4.angle",
        "r5.omega",
        "r6.alpha",
        "r4e.angle",
        "F.a",
    ] {
        assert!(press.contains(&name.to_owned()), "{name}: {press:?}");
    }
    let lever = names("slotted-lever");
    assert!(
        lever.contains(&"r3.angle".into()) && !lever.contains(&"r3.omega".into()),
        "{lever:?}"
    );
    // The link rotates with r4, so its angular velocity is not asked twice.
    assert!(!press.contains(&"r4e.omega".to_owned()));
}

/// The sheet shows the given values, asks for the rest, and reveals no value of the solution.
#[test]
fn sheet_does_not_reveal_answers() {
    for name in [
        "four-bar",
        "slider-crank",
        "press",
        "excavator-boom",
        "stephenson-six-bar",
        "slotted-lever",
    ] {
        let preset = presets::find(name).unwrap();
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
        let _ = solver.solve(scene.mechanism.driver().start, Order::Force, &mut state);
        solver.enclose(&mut state, Order::Force, &mut enclosure);
        let key = answer_key(&scene, &solver, state.state(), enclosure.state(), &[]);
        let sheet = Report::sheet(&scene, &solver, state.state(), &key, "answers.csv");
        let text = sheet.written(ReportFormat::Text, true);
        assert!(text.is_ascii(), "{text}");
        let long: Vec<&str> = text.lines().filter(|line| line.len() > 80).collect();
        assert!(long.is_empty(), "{name}: {long:#?}");
        for piece in ["= ?", "answers.csv", "1 Given", "2 Asked"] {
            assert!(text.contains(piece), "{name}: {piece}\n{text}");
        }
        let (_, shown_text) = text.split_once("1 Given").unwrap();
        let given = scene.values();
        for figure in &key.figures {
            let exact = format!("{:.3e}", figure.exact.abs());
            let (digits, _) = exact.split_once('e').unwrap();
            let digits = digits.replace('.', "");
            let is_given = given
                .iter()
                .any(|v| format!("{:.3e}", v.number.abs()).starts_with(&exact[..5]));
            let words = shown_text.split(|c: char| !(c.is_ascii_digit() || c == '.'));
            let mut plain = words.map(|word| word.replace('.', ""));
            let is_shown = plain.any(|word| word.trim_start_matches('0').starts_with(&digits));
            assert!(
                is_given || !is_shown,
                "{name}: {} is told\n{text}",
                figure.quantity.name
            );
        }
        for format in ReportFormat::ALL {
            assert!(sheet.written(format, false).len() > 1000);
        }
    }
}

/// Returns the sheet of a scene at its opening on one line, because line breaks depend on the
/// medium.
fn sheet_of(scene: &Scene) -> String {
    let solver = Solver::new(&scene.mechanism).unwrap();
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    let _ = solver.solve(scene.mechanism.driver().start, Order::Force, &mut state);
    solver.enclose(&mut state, Order::Force, &mut enclosure);
    let key = answer_key(scene, &solver, state.state(), enclosure.state(), &[]);
    let sheet = Report::sheet(scene, &solver, state.state(), &key, "answers.csv");
    let text = sheet.written(ReportFormat::Text, false);
    let (_, shown_text) = text.split_once("1 Given").unwrap();
    shown_text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The sheet shows given values in the form of the scene, in full and without digits that nobody
/// typed.
#[test]
fn sheet_shows_given_values_in_their_own_form() {
    let text = r#"
        [ground]
        A = [0, 0]
        [driver]
        link = "r2"
        angle = 40
        speed = "35 rpm"
        [links]
        r2 = { from = "A", to = "B", length = 100 }
        r3 = { from = "B", to = "C", length = 300, com = { length = 150, angle = 4 }, points = { E = { from = "C", length = 200, angle = 72 }, F = [30, 40.5] } }
        ram = { points = { C = [0, 0], T = [-20, 0] } }
        [slides]
        r4 = { link = "ram", turn = 90, on = "ground", through = [0, 20], angle = 0 }
        [start]
        C = [380, 20]
    "#;
    let scene = Scene::parse(text, "test").unwrap();
    let sheet = sheet_of(&scene);
    for piece in [
        "r2 is at 40 deg, with 35 rpm (3.66519 rad/s) and 0 rad/s^2",
        "E 200 mm from C, at 72 deg to the axis of the link",
        "r3.com 150 mm from B, at 4 deg to the axis of the link",
        "F at (30, 40.5) mm in its frame",
        "ram slides on the frame through Q (0, 20) mm, at 0 deg",
        "the axis of ram stays at 90 deg to the guide",
        "Positions, with a question mark",
        "Velocities, with a question mark",
        "Accelerations, with a question mark",
    ] {
        assert!(sheet.contains(piece), "{piece}: {sheet}");
    }
    assert!(longest_number(&sheet) <= 12, "{sheet}");
}

/// Returns the number of significant digits of the longest number.
fn longest_number(text: &str) -> usize {
    let numbers = text.split(|c: char| !(c.is_ascii_digit() || c == '.'));
    let digits = numbers.map(|n| n.trim_start_matches(['0', '.']));
    let digits = digits.map(|n| n.chars().filter(char::is_ascii_digit).count());
    digits.max().unwrap_or(0)
}

/// Tables may use other names than the answer file. The sheet contains both, and every reference
/// point of a slide.
#[test]
fn sheet_names_every_asked_value() {
    for preset in presets::all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let sheet = sheet_of(&scene);
        let words: Vec<&str> = sheet
            .split(' ')
            .map(|word| word.trim_end_matches(['.', ',']))
            .collect();
        for figure in key(preset.name, &[]).figures {
            let name = figure.quantity.name.as_str();
            // Points have their own table, and one sentence explains the names of all.
            let ends = [".v", ".a", ".v.angle", ".a.angle"];
            let mut points = ends.iter().filter_map(|end| name.strip_suffix(end));
            let is_in_table = sheet.contains("For each point it contains")
                && points.any(|point| sheet.contains(&format!(" {point} ? ")));
            assert!(
                is_in_table || words.contains(&name),
                "{}: {name}\n{sheet}",
                preset.name
            );
        }
        assert!(longest_number(&sheet) <= 12, "{}: {sheet}", preset.name);
        let (given, requested) = sheet.split_once("2 Asked").unwrap();
        // A point of the scene may have such a name, too; then it is not invented.
        let own: Vec<&str> = scene
            .mechanism
            .point_ids()
            .filter_map(|point| scene.point_name(point))
            .collect();
        for made_up in ["Q", "Q1", "Q2"]
            .into_iter()
            .filter(|name| !own.contains(name))
        {
            let ends = |word: &&str| word.ends_with(made_up) || word.starts_with(made_up);
            let is_used = requested.split(' ').any(|word| ends(&word));
            let is_given = given.contains(&format!("through {made_up} ("));
            assert!(is_given || !is_used, "{}: {made_up}\n{sheet}", preset.name);
        }
    }
}

/// Reads a file in `tests/answers`.
fn answers(name: &str) -> Vec<u8> {
    std::fs::read(Path::new("tests/answers").join(name)).unwrap()
}

fn sheet_in_tests(name: &str) -> String {
    String::from_utf8(answers(name)).unwrap()
}

/// Returns the names of values without a point.
fn lost(graded: &GradedAnswers) -> Vec<&str> {
    let figures = graded.figures.iter();
    let lost = figures.filter(|f| !f.verdict.earns_point());
    lost.map(|f| f.quantity.name.as_str()).collect()
}

fn verdict_of(graded: &GradedAnswers, name: &str) -> FigureVerdict {
    let mut all = graded.figures.iter().chain(&graded.besides);
    all.find(|f| f.quantity.name == name).unwrap().verdict
}

fn cells(cells: &[InvalidCell]) -> Vec<(u64, &str, &str)> {
    let cells = cells.iter();
    cells
        .map(|c| (c.line, c.figure.as_str(), c.text.as_str()))
        .collect()
}

/// Returns the name of the value from which a verdict follows.
fn cause<'a>(graded: &'a GradedAnswers, name: &str) -> Option<&'a str> {
    match verdict_of(graded, name) {
        FigureVerdict::Followed(by) => Some(&graded.figures[by].quantity.name),
        _ => None,
    }
}

#[test]
fn turkish_units_are_read() {
    let graded = graded_file(preset("four-bar"), None, &answers("derece.csv"));
    for name in ["r3.angle", "r4.angle", "r3.omega", "r4.omega", "B.a"] {
        assert_eq!(verdict_of(&graded, name), FigureVerdict::Right, "{name}");
    }
    assert!(graded.remarks.sentences().is_empty());
    for row in [
        "r3.angle;;29,38 der",
        "r3.angle;;29,38 °",
        "r3.angle;;29,38º",
        "r3.angle;;29.38 [derece]",
        "r3.angle;radyan;0,51277",
        "r3.omega;d/dk;-37,40",
        "r3.omega;;-37,40 dev/dk",
        "r3.omega;;-3,9164 rd/s",
        "r3.omega;;-3,9164 rad/sn",
        "r3.omega;;-224,39 derece/sn",
        "C.v;;772,77 mm/sn",
        "C.v;;0,77277 m/sn",
        "r3.alpha;;42,267 rd/sn²",
    ] {
        let graded = graded_rows("four-bar", None, row);
        let name = row.split(';').next().unwrap();
        assert_eq!(verdict_of(&graded, name), FigureVerdict::Right, "{row}");
        assert!(graded.remarks.strange_units.is_empty(), "{row}");
    }
}

/// An unknown unit costs no point and is reported with its cell. A unit of another quantity is
/// reported and costs the point.
#[test]
fn every_unknown_unit_is_reported() {
    let rows =
        "r3.angle;;29,38 derce\nr4.angle;grad;290,75\nr3.omega;;-3,9164 mm\nr4.omega;;three\n";
    let graded = graded_rows("four-bar", None, rows);
    assert_eq!(verdict_of(&graded, "r3.angle"), FigureVerdict::Right);
    assert_eq!(verdict_of(&graded, "r4.angle"), FigureVerdict::Right);
    assert_eq!(verdict_of(&graded, "r3.omega"), FigureVerdict::Unreadable);
    let units = [
        (1, "r3.angle", "derce"),
        (2, "r4.angle", "grad"),
        (3, "r3.omega", "mm"),
    ];
    assert_eq!(cells(&graded.remarks.strange_units), units);
    let unread = [(4, "r4.omega", "three")];
    assert_eq!(cells(&graded.remarks.unreadable), unread);
    let page = graded.page().to_text(crate::page::TextStyle::plain(true));
    let mut csv = Vec::new();
    class_csv(&[graded], Default::default(), &mut csv).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    for piece in ["derce", "grad", "mm", "three"] {
        assert!(page.contains(&format!("[{piece}]")), "{page}");
        assert!(csv.contains(&format!(": {piece}")), "{csv}");
    }
}

#[test]
fn symbols_from_notes_name_rows() {
    let sheet = sheet_in_tests("four-bar-7.toml");
    let graded = graded_file(&sheet, None, &answers("names.csv"));
    for name in ["r3.angle", "r4.angle", "r3.omega"] {
        assert_eq!(verdict_of(&graded, name), FigureVerdict::Right, "{name}");
    }
    assert_eq!(cells(&graded.remarks.unknown_names), [(3, "foo", "3")]);
    let repeated = [(4, "r4.angle", "277.17")];
    assert_eq!(cells(&graded.remarks.repeated), repeated);
}

/// The last answer counts, and a later empty row does not remove it.
#[test]
fn last_answer_counts() {
    let rows = "θ3;deg;35\nr3.angle;deg;29,38\nr4.angle;deg;290,75\nθ4;deg;\n;deg;5\n";
    let graded = graded_rows("four-bar", None, rows);
    assert_eq!(verdict_of(&graded, "r3.angle"), FigureVerdict::Right);
    assert_eq!(verdict_of(&graded, "r4.angle"), FigureVerdict::Right);
    assert_eq!(cells(&graded.remarks.repeated), [(1, "r3.angle", "35")]);
    assert_eq!(cells(&graded.remarks.unknown_names), [(5, "", "5")]);
}

#[test]
fn windows_1254_is_decoded_and_reported() {
    let sheet = sheet_in_tests("four-bar-7.toml");
    let graded = graded_file(&sheet, None, &answers("cp1254.csv"));
    assert_eq!(graded.student, "Şükrü İğneci");
    assert_eq!(graded.points(), 22);
    assert_eq!(graded.remarks.encoding.name(), "windows-1254");
    assert_eq!(graded.remarks.sentences().len(), 1);
}

/// The acceleration of the centre of mass is half of the pin's, even if the latter is wrong.
#[test]
fn centre_of_mass_follows_by_proportion() {
    let graded = graded_file(preset("four-bar"), None, &answers("prop.csv"));
    assert_eq!(verdict_of(&graded, "C.a"), FigureVerdict::Wrong);
    assert_eq!(cause(&graded, "r4.com.a"), Some("C.a"));
    assert_eq!(verdict_of(&graded, "r4.com.a.angle"), FigureVerdict::Right);
}

#[test]
fn missing_normal_component_costs_only_its_own_points() {
    let sheet = sheet_in_tests("four-bar-7.toml");
    let graded = graded_file(&sheet, None, &answers("no_normal.csv"));
    assert_eq!(lost(&graded), ["C.a", "C.a.angle"]);
    for name in ["r3.com.a", "r3.com.a.angle", "r4.com.a", "r4.com.a.angle"] {
        let cause = cause(&graded, name).unwrap();
        assert!(["C.a", "C.a.angle"].contains(&cause), "{name} by {cause}");
    }
}

#[test]
fn misread_speed_costs_one_point() {
    let sheet = sheet_in_tests("four-bar-7.toml");
    let graded = graded_file(&sheet, None, &answers("rpm.csv"));
    assert_eq!(lost(&graded), ["r3.omega"]);
    let misread = graded.misread.as_ref().unwrap();
    assert_eq!(misread.value.name, "driver speed");
    let rpm = 12.0 * std::f64::consts::TAU / 60.0;
    assert!((misread.number / rpm - 1.0).abs() < 1e-5, "{misread:?}");
}

/// Returns the answers of a student who solved another scene, with so many digits.
fn answered(key: &AnswerKey, by: &AnswerKey, digits: usize) -> String {
    let value = |name: &str| {
        let mut figures = by.figures.iter();
        figures.find(|f| f.quantity.name == name).map(|f| f.exact)
    };
    let rows = key.figures.iter().map(|f| {
        let name = &f.quantity.name;
        let value = value(name).unwrap_or(0.0);
        format!("{name};;{value:.*e}\n", digits - 1)
    });
    rows.collect()
}

/// Any misread value costs the first answer that shows it, and no later one.
#[test]
fn every_misread_value_costs_one_point() {
    let sheet = sheet_in_tests("four-bar-7.toml");
    let (scene, solver) = opened(&sheet);
    let start = scene.mechanism.driver().start;
    let key = key_of(&scene, &solver, start, &[]);
    for (name, number) in [
        ("driver speed", 21.0),
        ("driver speed", -12.0),
        ("driver angle", 305.0),
        ("r2 length", 57.0),
        ("r3 length", 301.0),
        ("r4 length", 186.0),
        ("D x", 304.0),
    ] {
        let value = scene.values().into_iter().find(|v| v.name == name).unwrap();
        let other = scene.with_value(&value, &value.with_number(number));
        let (other, _) = opened(&other);
        let solver = solver
            .with_dimensions_in_assembly(start, &other.mechanism)
            .unwrap();
        let at = other.mechanism.driver().start;
        let by = key_of(&other, &solver, at, &[]);
        for digits in [4, 6] {
            let graded = graded_file(&sheet, None, answered(&key, &by, digits).as_bytes());
            assert_eq!(
                lost(&graded).len(),
                1,
                "{name} {digits}: {:?}",
                lost(&graded)
            );
            let misread = graded.misread.unwrap();
            assert_eq!(misread.value.name, name);
            let off = (misread.number - number).abs() / number.abs();
            assert!(off < 10_f64.powi(2 - digits as i32), "{misread:?}");
        }
    }
}

/// Wrong answers without a common cause have no explanation.
#[test]
fn unrelated_mistakes_are_not_a_misread_value() {
    let opened = opened(preset("four-bar"));
    let start = opened.0.mechanism.driver().start;
    let key = key_of(&opened.0, &opened.1, start, &[]);
    let mut rng = crate::numeric::SeededRng::new(5);
    let mut points = 0;
    for _ in 0..20 {
        let rows = key.figures.iter().map(|f| {
            let factor = f64::from(rng.between(600, 900)) / 1000.0;
            format!("{};;{:.3e}\n", f.quantity.name, f.exact * factor)
        });
        let rows: String = rows.collect();
        let graded = graded_by(&opened, start, rows.as_bytes());
        assert_eq!(graded.misread, None, "{rows}");
        points += graded.points();
    }
    // Of 440 answers a few are close by chance.
    assert!(points <= 8, "{points}");
}

/// Of two independent mistakes, neither is explained by a misread value that causes the other.
#[test]
fn two_unrelated_mistakes_are_rarely_a_misread_value() {
    let opened = opened(preset("four-bar"));
    let start = opened.0.mechanism.driver().start;
    let key = key_of(&opened.0, &opened.1, start, &[]);
    let last = u32::try_from(key.figures.len() - 1).unwrap();
    let mut rng = crate::numeric::SeededRng::new(7);
    let mut explained = 0;
    for _ in 0..100 {
        let wrong = [rng.between(0, last), rng.between(0, last)];
        let rows = (0..).zip(&key.figures).map(|(number, f)| {
            let factor = match wrong.contains(&number) {
                true => f64::from(rng.between(600, 900)) / 1000.0,
                false => 1.0,
            };
            format!("{};;{:.3e}\n", f.quantity.name, f.exact * factor)
        });
        let rows: String = rows.collect();
        let graded = graded_by(&opened, start, rows.as_bytes());
        explained += usize::from(graded.misread.is_some());
    }
    assert!(explained <= 2, "{explained}");
}

/// The expected value is 0, and so is the answer.
#[test]
fn zero_answer_earns_a_point() {
    let sheet = sheet_in_tests("slider-crank-3.toml");
    let graded = graded_file(&sheet, None, &answers("om0.csv"));
    assert_eq!(verdict_of(&graded, "r3.omega"), FigureVerdict::Right);
    assert!(graded.besides.is_empty());
    assert_eq!(graded.points(), 3);
}

/// Returns the symbols of the unknowns on a sheet.
fn requested_symbols(sheet: &str) -> Vec<&str> {
    let words: Vec<&str> = sheet.split_whitespace().collect();
    let requested = words.windows(3).filter(|three| three[1..] == ["=", "?"]);
    requested.map(|three| three[0]).collect()
}

/// The sheet and the answer file ask for the same values, for every seed.
#[test]
fn sheet_and_answer_file_ask_for_same_values() {
    let titles = ExerciseTitles {
        name: "Exercise".into(),
        source: "here".into(),
        note: "so".into(),
    };
    for preset in presets::all() {
        let (scene, solver) = opened(preset.text);
        let maker = ExerciseMaker::new(&scene, &solver);
        let is_lecture = ["four-bar", "slider-crank", "press"].contains(&preset.name);
        for seed in 1..=if is_lecture { 120 } else { 4 } {
            let made = maker.exercise(seed, &titles).unwrap();
            assert_same_questions(&made, &format!("{} {seed}", preset.name));
        }
    }
}

fn assert_same_questions(made: &Exercise, name: &str) {
    let Exercise { scene, solver } = made;
    let at = scene.mechanism.driver().start;
    let key = key_of(scene, solver, at, &[]);
    let (mut state, mut enclosure) = (solver.state(), solver.enclosure());
    let _ = solver.solve(at, Order::Force, &mut state);
    solver.enclose(&mut state, Order::Force, &mut enclosure);
    let sheet = Report::sheet(scene, solver, state.state(), &key, "answers.csv");
    let sheet = sheet.written(ReportFormat::Text, false);
    let mut blank = Vec::new();
    blank_answers(&key, "x.toml", Default::default(), &mut blank).unwrap();
    let blank = String::from_utf8(blank).unwrap();
    let rows = blank
        .lines()
        .skip(3)
        .filter_map(|row| row.split(',').next());
    let rows: Vec<&str> = rows.filter(|row| !is_of_vector(row)).collect();
    let working = crate::report::working::Working::new(scene, solver);
    let loops = working.loop_vectors(scene, solver, state.state(), 6);
    let vectors = loops.iter().flat_map(|of| &of.vectors);
    let cells: Vec<_> = vectors.flat_map(|v| v.figures.iter().flatten()).collect();
    let mut requested = Vec::new();
    for symbol in requested_symbols(&sheet) {
        let cell = cells.iter().find(|cell| cell.symbol.to_string() == symbol);
        let cell = cell.unwrap_or_else(|| panic!("{name}: {symbol}"));
        requested.push(cell.column.as_str());
        assert!(
            rows.contains(&cell.column.as_str()),
            "{name}: {symbol}\n{sheet}"
        );
    }
    for row in rows {
        assert!(
            loops.is_empty() || requested.contains(&row),
            "{name}: {row}\n{sheet}"
        );
    }
}

/// Returns `true` if a row requests the magnitude or the direction of a point's velocity or
/// acceleration.
fn is_of_vector(row: &str) -> bool {
    let row = row.strip_suffix(".angle").unwrap_or(row);
    row.ends_with(".v") || row.ends_with(".a")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    /// For any contents of an answer file, every value has a verdict.
    #[test]
    fn grading_never_panics(
        answers in prop::collection::vec((0_usize..40, "[-+]?[0-9]{0,5}[.,]?[0-9]{0,4}(e-?[0-9]{1,3})?|.{0,12}"), 1..30),
    ) {
        static OPENED: LazyLock<(Scene, Solver)> = LazyLock::new(|| opened(preset("slider-crank")));
        let (scene, solver) = &*OPENED;
        let start = scene.mechanism.driver().start;
        let key = key_of(scene, solver, start, &[]);
        let rows = answers.iter().map(|(number, answer)| {
            let figure = key.figures.get(*number).map_or("x.y", |f| f.quantity.name.as_str());
            format!("{figure};;{answer}\n")
        });
        let rows = rows.collect::<String>();
        if AnswerFile::read(rows.as_bytes()).is_ok() {
            let graded = graded_by(&OPENED, start, rows.as_bytes());
            prop_assert_eq!(graded.figures.len(), key.figures.len());
            let _ = graded.page();
            let mut text = Vec::new();
            class_csv(&[graded], Default::default(), &mut text).unwrap();
        }
    }
}
