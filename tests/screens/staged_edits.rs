//! Tests parameters and staged edits in the scene view, driven by key scripts.

use crate::scene::Values;
use crate::screen::{Session, four_bar, open, preset};
use krank::drawing::Glyphs;
use krank::tui::Origin;

const SCENE: &str = r#"name = "By parameters"
[ground]
A = [0, 0]
D = ["4 * a", 0]
[parameters]
a = 100
rod = "2 * a + 100"
[driver]
link = "r2"
angle = 60
speed = "a / 10 rad/s"
[links]
r2 = { from = "A", to = "B", length = "a" }
r3 = { from = "B", to = "C", length = "rod" }
r4 = { from = "C", to = "D", length = 250 }
[start]
C = [310, 230]
"#;

fn session(cols: u16, rows: u16) -> Session {
    let opened = open(SCENE, Origin::Preset("by-parameters".into()));
    Session::new(opened, Glyphs::Ascii, cols, rows)
}

/// Returns the row under the cursor, without the drawing next to it.
fn row(session: &mut Session) -> String {
    session.row().trim_end_matches(" |").to_owned()
}

#[test]
fn parameters_are_listed_first_and_update_dependent_values() {
    let mut session = session(100, 30);
    session.press("6");
    insta::assert_snapshot!("scene-parameters-100x30", session.painted_text());
    assert_eq!(row(&mut session), "> a 100");
    let followers =
        |session: &mut Session| ["D x", "r3 len", "driver sp"].map(|name| row(session.find(name)));
    assert_eq!(
        followers(&mut session),
        [
            "> D x 400 mm = 4 * a",
            "> r3 length 300 mm = rod",
            "> driver speed 10 rad/s = a / 10",
        ]
    );
    session
        .press("g g")
        .find("a")
        .press("Enter")
        .type_in("102,5")
        .press("Enter");
    assert_eq!(row(&mut session), ">*a 102.5 100");
    assert_eq!(
        followers(&mut session),
        [
            "> D x 410 mm = 4 * a",
            "> r3 length 305 mm = rod",
            "> driver speed 10.25 rad/s = a / 10",
        ]
    );
}

#[test]
fn formula_values_cannot_be_nudged_but_can_be_typed() {
    let mut session = session(120, 30);
    session.press("6").find("r3 len").press(">");
    let text = session.last_line();
    let output = "r3 length is given by rod: change rod, or press Enter to edit";
    assert!(text.contains(output), "{text}");
    assert_eq!(row(&mut session), "> r3 length 300 mm = rod");
    session
        .press("Enter")
        .type_in("3 * a + 1 cm")
        .press("Enter");
    assert_eq!(row(&mut session), ">*r3 length 310 mm rod");
    session.press("Enter").type_in("3 * b").press("Enter");
    let text = session.last_line();
    assert!(text.contains("unknown parameter `b`"), "{text}");
    session
        .press("Esc")
        .press("Enter")
        .type_in("301")
        .press("Enter");
    assert_eq!(row(&mut session), ">*r3 length 301 mm rod");
    session.press("u u");
    assert_eq!(row(&mut session), "> r3 length 300 mm = rod");
}

/// Each of the two edits alone does not close; both together do, and one undo reverts both.
#[test]
fn staged_edits_are_applied_and_undone_together() {
    let mut session = four_bar(80, 24);
    session.press("6");
    let before = session.painted_text();
    session
        .find("r3 len")
        .press("Enter")
        .type_in("1000")
        .press("Enter");
    assert!(session.last_line().contains("out of reach by"));
    session.press("Esc").press("b");
    assert!(session.painted_text().contains("edits are staged"));
    session.press("Enter").type_in("1000").press("Enter");
    assert_eq!(row(&mut session), ">+r3 length 1000 mm");
    session
        .find("D x")
        .press("Enter")
        .type_in("1099")
        .press("Enter")
        .press("}")
        .press(">");
    let waiting = row(&mut session);
    assert!(waiting.starts_with(">+D x 1104"), "{waiting}");
    assert!(session.painted_text().contains("2 staged"));
    // Staged edits change nothing, and other actions are blocked until they are applied or
    // discarded.
    for key in ["w", "u", "q", "o"] {
        let line = session.press(key).last_line();
        assert!(
            line.contains("staged edits: b applies them, Esc discards them"),
            "{line}"
        );
    }
    let line = session.press("b").last_line();
    assert!(line.contains("2 edits applied"), "{line}");
    assert_eq!(row(&mut session), ">*D x 1104 mm 400");
    assert_eq!(row(session.find("r3 len")), ">*r3 length 1000 mm 300");
    assert!(
        session
            .press("u")
            .last_line()
            .contains("r3 length, D x undone")
    );
    assert_eq!(row(&mut session), "> r3 length 300 mm");
    assert_eq!(session.find("A x").press("Esc {").painted_text(), before);
}

/// The row of a value shows its staged formula, not the present one.
#[test]
fn staged_formula_is_shown_with_keys_to_apply_it() {
    let mut session = session(120, 30);
    session.press("6").find("r3 len").press("b");
    session
        .press("Enter")
        .type_in("3 * a")
        .press("Enter")
        .press("Enter Esc");
    assert_eq!(row(&mut session), ">+r3 length mm = 3 * a");
    let keys = session.last_line();
    assert!(keys.contains("b apply  Esc drop"), "{keys}");
    session.press("Enter").type_in("301").press("Enter");
    assert_eq!(row(&mut session), ">+r3 length 301 mm");
    let keys = session.press("b u").last_line();
    assert!(!keys.contains("Esc drop"), "{keys}");
}

#[test]
fn staged_edits_that_do_not_close_stay_staged_until_discarded() {
    let mut session = four_bar(80, 24);
    session
        .press("6")
        .find("r3 len")
        .press("b")
        .press("Enter")
        .type_in("1000")
        .press("Enter");
    let line = session.press("b").last_line();
    assert!(line.contains("r3 length 1000: C out of reach by"), "{line}");
    assert_eq!(row(&mut session), ">+r3 length 1000 mm");
    assert!(session.press("Esc").last_line().contains("discarded"));
    assert_eq!(row(&mut session), "> r3 length 300 mm");
    assert!(
        session
            .press("b b")
            .last_line()
            .contains("edits apply immediately")
    );
    assert_eq!(row(session.press(">")), ">*r3 length 302 mm 300");
}

/// An Esc may be hit by mistake, or be split from an escape sequence by a slow line.
#[test]
fn undo_restores_discarded_staged_edits() {
    let mut session = session(120, 30);
    session.press("6").find("r3 len").press("b Enter");
    session.type_in("1000").press("Enter");
    session.find("D x").press("Enter").type_in("1099");
    session.press("Enter");
    let line = session.press("Esc").last_line();
    let output = "discarded the staged edits; u restores them";
    assert!(line.contains(output), "{line}");
    assert_eq!(row(&mut session), "> D x 400 mm = 4 * a");
    // Later edits are undone first.
    session.find("r4 len").press("> u");
    assert!(session.last_line().contains("r4 length undone"));
    let line = session.press("u").last_line();
    assert!(line.contains("staged edits: b applies them"), "{line}");
    assert_eq!(row(session.find("D x")), ">+D x 1099 mm");
    assert_eq!(row(session.find("r3 len")), ">+r3 length 1000 mm");
    let line = session.press("b u").last_line();
    assert!(line.contains("r3 length, D x undone"), "{line}");
    let line = session.press("u").last_line();
    assert!(line.contains("nothing to undo"), "{line}");
    // An empty set of staged edits leaves nothing to restore.
    let line = session.press("b Esc").last_line();
    assert!(line.contains("edits apply immediately"), "{line}");
}

/// Returns the example goals of the manual and of the commands' help.
fn goals_of_help() -> Vec<String> {
    let messages = include_str!("../../crates/model/src/wording/english.txt");
    let mut topics = messages.split("\n## ");
    let text = [
        include_str!("../../src/manual/english/views.md"),
        include_str!("../../src/manual/english/designs.md"),
        include_str!("../../src/manual/english/tutorial.md"),
        include_str!("../../src/manual/english/synthesis.md"),
        topics
            .find(|topic| topic.starts_with("Studies of many designs"))
            .unwrap(),
    ];
    let text = text.join("\n").replace('\n', " ");
    let of_commands = text
        .split("--goal ")
        .skip(1)
        .map(|rest| match rest.strip_prefix('\'') {
            Some(quoted) => quoted.split('\'').next().unwrap(),
            None => rest.split([' ', ',']).next().unwrap(),
        });
    let spans = text.split('`').skip(1).step_by(2);
    let of_views = spans.filter(|span| span.contains(" = ") && span.contains(['.', ';']));
    let goals = of_commands.chain(of_views).map(str::to_owned);
    goals.filter(|goal| goal.contains(['=', '>'])).collect()
}

/// Regression test: an input limit of 60 characters silently cut the manual's own example.
#[test]
fn every_documented_goal_can_be_typed() {
    let goals = goals_of_help();
    let longest = "r4.angle.swing = 60; transmission >= 40 by r2.length, r4.length=200..300";
    assert!(goals.iter().any(|goal| goal == longest), "{goals:?}");
    assert!(goals.len() > 6, "{goals:?}");
    for (cols, rows) in [(40, 12), (80, 24)] {
        let mut session = four_bar(cols, rows);
        session.press("6 @");
        for goal in goals.iter().chain([&goals.join("; ")]) {
            session.press("Ctrl-U").type_in(goal);
            // The end of the goal is visible, with the caret after it.
            let line = session.last_line();
            let end: String = goal.chars().rev().take(24).collect();
            let end: String = end.chars().rev().collect();
            assert!(line.contains(end.trim()), "{goal}\n{line}");
            assert!(!session.painted_text().contains("valid here"));
        }
        session.press("Ctrl-U").type_in(longest).press("Enter");
        let screen = session.painted_text();
        assert!(
            screen.contains("it") && !screen.contains("goal  r4"),
            "{screen}"
        );
    }
}

/// Rejected characters are reported, and a typographic minus is accepted as a minus.
#[test]
fn invalid_keys_are_reported_in_every_prompt() {
    let mut session = session(80, 24);
    session.press("6").find("r4 len").press("Enter");
    session.type_in("5\u{d7}50 \u{2212} 1").press("Enter");
    assert_eq!(row(&mut session), ">*r4 length 249 mm 250");
    let line = session.press("Enter \u{e4}").last_line();
    assert!(line.contains("(U+00E4) is not valid here"), "{line}");
    let line = session.press("1").last_line();
    assert!(!line.contains("is not valid"), "{line}");
    session.press("Esc");
    for keys in ["g", "2 /", "? /", "6 @"] {
        session.press(keys);
        let screen = session.press("\u{20ac}").painted_text();
        assert!(
            screen.contains("(U+20AC) is not valid here"),
            "{keys}\n{screen}"
        );
        session.press("Esc Esc");
    }
}

/// The stroke of an in-line slider-crank is twice its crank: the search finds the value under the
/// cursor, and one undo reverts it. A goal that no value meets reports the nearest result.
#[test]
fn goal_search_changes_value_under_cursor() {
    let mut session = Session::new(preset("slider-crank"), Glyphs::Ascii, 120, 30);
    session.press("6").find("r2 len").press("@");
    assert!(
        session
            .painted_text()
            .contains("C.x.stroke = 120 by r2.length")
    );
    session.type_in("r4.length.stroke = 13").press("Enter");
    assert!(session.painted_text().contains("r2 length 6.5 meets it"));
    assert_eq!(row(&mut session), ">*r2 length 6.5 cm 10");
    session.press("u").find("r2 len");
    assert_eq!(row(&mut session), "> r2 length 10 cm");
    session
        .press("@")
        .type_in("r4.length.stroke = 30 by r2.length=5..12")
        .press("Enter");
    assert!(
        session
            .painted_text()
            .contains("the nearest has r4.length.stroke 24")
    );
    session.press("Esc");
    assert_eq!(row(&mut session), "> r2 length 10 cm");
}

/// The offset of a slider-crank may lie on either side, so that two designs meet the goal. One is
/// taken, and one undo reverts both of its values. The goal can be edited again.
#[test]
fn several_designs_for_a_goal_can_be_browsed() {
    let mut session = Session::new(preset("offset-slider-crank"), Glyphs::Ascii, 160, 30);
    let goal = "r4.length.stroke = 120; r4.length.ratio = 1.1 by r2.length, r4.through.y";
    session.press("6").find("r2 len");
    let given = row(&mut session);
    session.press("@").type_in(goal).press("Enter");
    let first = session.painted_text();
    assert!(first.contains("1 of 2: r2 length "), "{first}");
    session.press("Right");
    let second = session.painted_text();
    assert!(second.contains("2 of 2: r2 length "), "{second}");
    session.press("Esc");
    assert!(session.painted_text().contains(goal));
    session.press("Enter").press("Right").press("Enter");
    assert!(session.painted_text().contains(" meets it"));
    assert_ne!(row(&mut session), given);
    session.press("u").find("r2 len");
    assert_eq!(row(&mut session), given);
}

/// Regression test: a goal that no nearby design has was reported without a reason.
#[test]
fn goal_on_undefined_value_explains_why() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 160, 30);
    session.press("6").find("r4 len").press("@");
    session.type_in("driver.angle.ratio = 2").press("Enter");
    let text = session.painted_text();
    assert!(text.contains("it turns fully"), "{text}");
}
