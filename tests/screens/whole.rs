//! What holds for the workbench as a whole: opening, moving, helping, editing lengths, and every size.

use crate::screen::{SWINGING, Session, emulator, made_up, masked, open, preset};
use krank::drawing::Glyphs;
use krank::scene::presets;
use krank::tui::{Colours, Opened, Origin, Workbench};
use proptest::prelude::*;
use std::time::Duration;

const README: &str = include_str!("../../README.md");

/// What the program prints.
fn printed(arguments: &[&str]) -> String {
    let mut program = std::process::Command::new(env!("CARGO_BIN_EXE_krank"));
    let output = program.args(arguments).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

/// The keys of the workbench are the same wherever they are written down.
#[test]
fn manual_and_command_line_name_the_keys() {
    let manual = printed(&["help", "keys"]);
    let mut lines = manual.lines();
    let mut group = "";
    for (title, keys, help) in krank::tui::key_list() {
        if title != group {
            assert!(lines.any(|line| line == title), "{title}:\n{manual}");
            group = title;
        }
        let keys: Vec<_> = keys.split(' ').map(|key| format!("`{key}`")).collect();
        let line = lines.next().unwrap();
        let row = line.strip_prefix(&keys.join(" ")).map(str::trim);
        assert_eq!(row, Some(help), "{line}");
    }
    let help = printed(&["--help"]);
    let keys = help.split("Keys of the workbench:").nth(1).unwrap();
    let keys = keys.split("Examples:").next().unwrap();
    let known: Vec<_> = krank::tui::key_list().collect();
    let named = ["space", ".", ",", "r", "g", "2", "n", "t", "?", "q"];
    for key in named {
        assert!(keys.split_whitespace().any(|word| word == key), "{keys}");
        let mut all = known.iter().flat_map(|(_, keys, _)| keys.split(' '));
        assert!(all.any(|known| known == key), "{key}");
    }
}

/// The picture at the top of the README is the screen that opens.
#[test]
fn the_frame_of_the_readme_is_the_one_that_opens() {
    let screen = four_bar(Glyphs::Ascii, 80, 24).look();
    assert!(
        masked(README).contains(&format!("```txt\n{}```", masked(&screen))),
        "the README should show\n{screen}"
    );
}

/// A session whose studies take the time that is made up.
fn shown(opened: Opened, glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    let workbench = Workbench::new(opened, glyphs, Colours::Sixteen, cols, rows);
    Session::on(workbench.timed_by(made_up), cols, rows)
}

fn four_bar(glyphs: Glyphs, cols: u16, rows: u16) -> Session {
    shown(preset("four-bar"), glyphs, cols, rows)
}

#[test]
fn opens_on_the_lectures_four_bar() {
    for (name, glyphs) in [("ascii", Glyphs::Ascii), ("braille", Glyphs::Braille)] {
        for (cols, rows) in [(80, 24), (40, 12)] {
            let screen = four_bar(glyphs, cols, rows).look();
            insta::assert_snapshot!(format!("four-bar-{name}-{cols}x{rows}"), masked(&screen));
        }
    }
}

#[test]
fn shows_a_slider_crank_above_its_tables() {
    let mut session = shown(preset("slider-crank"), Glyphs::Line, 80, 24);
    insta::assert_snapshot!("slider-crank-line-80x24", masked(&session.look()));
}

#[test]
fn shows_all_tables() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    insta::assert_snapshot!("tables-ascii-80x24", masked(&session.press("2").look()));
    let mut tiny = four_bar(Glyphs::Ascii, 40, 12);
    let scrolled = tiny.press("Tab Down Down").look();
    insta::assert_snapshot!("tables-ascii-40x12-scrolled", masked(&scrolled));
}

/// What a length that is off does to the figures: a view of its own, which follows the driver.
#[test]
fn shows_what_the_lengths_do() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    insta::assert_snapshot!("lengths-ascii-80x24", masked(&session.press("e").look()));
    let elsewhere = session.press(".").look();
    assert!(elsewhere.contains("65.00 deg"), "{elsewhere}");
    assert_ne!(elsewhere, session.press(".").look());
    let mut tiny = four_bar(Glyphs::Ascii, 40, 12);
    insta::assert_snapshot!("lengths-ascii-40x12", masked(&tiny.press("e PgDn").look()));
    // A redundant linkage jams where a length is off, and the view says so.
    let mut jammed = shown(preset("triple-parallelogram"), Glyphs::Ascii, 80, 24);
    let screen = jammed.press("e").look();
    assert!(screen.contains("no derivatives by the lengths"), "{screen}");
    // Another scene is asked the same.
    let screen = jammed.press("n").look();
    assert!(screen.contains("C.x [mm]"), "{screen}");
}

/// The screen with the digits of errors masked: rounding may change with a formula.
fn without_errors(screen: &str) -> String {
    let mut masked = String::new();
    let mut rest = screen;
    while let Some(at) = rest.find("e-1") {
        let (before, behind) = rest.split_at(at);
        let kept = before.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
        let digits = before.len() - kept.len();
        masked.push_str(kept);
        // Labels of the axis have a single digit.
        masked.push_str(if digits == 3 {
            "#.#"
        } else {
            &before[kept.len()..]
        });
        masked.push_str(&behind[..3]);
        rest = &behind[3..];
    }
    masked + rest
}

/// The list of methods without the chart beside it.
fn list_of_methods(screen: &str) -> String {
    let lines = screen.lines().skip(1).take(22);
    let list = lines.map(|line| line.chars().skip(40).collect::<String>());
    without_errors(&list.collect::<Vec<_>>().join("\n"))
}

#[test]
fn measures_speed_against_error_while_keys_stay_live() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    let line = session.press("4").last_line();
    assert!(
        line.starts_with(" accuracy  four-bar  measuring  0 %"),
        "{line}"
    );
    assert!(line.contains("Esc stop"), "{line}");
    // A study is no reason to wait: everything else goes on.
    assert!(session.press("1").last_line().contains("60.00 deg  ok"));
    assert!(session.press(".").last_line().contains("65.00 deg  ok"));
    session.press("4");
    for _ in 0..2000 {
        session.workbench.pass(Duration::from_millis(40));
        if session.last_line().contains("measuring 25 %") {
            break;
        }
    }
    let line = session.press("Esc").last_line();
    assert!(
        line.contains("stopped at 25 %    ? help  4 go on"),
        "{line}"
    );
    let before = session.workbench.frames();
    session.pass(10.0).paint();
    assert_eq!(session.workbench.frames(), before, "stopped is stopped");
    let screen = session.look();
    insta::assert_snapshot!("accuracy-list-ascii-80x24", list_of_methods(&screen));
    for axis in ["error over time", "1e-16+"] {
        assert!(screen.contains(axis), "{screen}");
    }
    assert!(session.press("4").last_line().contains("measuring 25 %"));
}

#[test]
fn another_scene_is_measured_anew_and_the_smallest_screen_scrolls() {
    let mut session = shown(preset("stephenson-six-bar"), Glyphs::Ascii, 40, 12);
    session.press("4");
    for _ in 0..1200 {
        session.workbench.pass(Duration::from_millis(40));
    }
    let screen = session.press("Down").look();
    assert!(
        screen.contains("\n   the group at E has no closed form"),
        "{screen}"
    );
    assert!(
        screen.lines().all(|line| line.chars().count() <= 40),
        "{screen}"
    );
    let end = session.press(&"PgDn ".repeat(20)).look();
    assert!(end.contains("v RK4 3600 x 1000"), "{end}");
    let line = session.press("n").last_line();
    assert!(line.contains("measuring  0 %"), "{line}");
}

#[test]
fn shows_the_keys() {
    let mut session = four_bar(Glyphs::Braille, 80, 24);
    insta::assert_snapshot!("help-braille-80x24", masked(&session.press("?").look()));
    let mut tiny = four_bar(Glyphs::Ascii, 40, 12);
    insta::assert_snapshot!("help-ascii-40x12", masked(&tiny.press("F1 PgDn").look()));
    assert!(!tiny.press("Esc").look().contains("Help"));
}

#[test]
fn says_what_is_missing_at_a_dead_point() {
    let opened = open(SWINGING, Origin::File("bench/swinging.toml".into()));
    let mut session = shown(opened, Glyphs::Ascii, 80, 24);
    session.press("] ] ] ] ] .");
    let screen = session.look();
    insta::assert_snapshot!("dead-point-ascii-80x24", masked(&screen));
    let line = session.press(".").last_line();
    assert!(line.contains("the motion ends here"), "{line}");
    assert!(line.contains("dead point: no rates"), "{line}");
    session.workbench.resize(40, 12);
    session.terminal = emulator(40, 12);
    let line = session.press(".").last_line();
    assert!(line.ends_with("82.81924422 deg  dead point"), "{line}");
}

/// Within 5e-13 deg of the dead point of [`SWINGING`], where rates have four digits at the most.
const ALMOST_DEAD: &str = "g 8 2 . 8 1 9 2 4 4 2 1 8 5 4 1 Enter";

/// Digits that nothing proves are dim; without colours points stand in their place.
#[test]
fn digits_that_nothing_proves_are_told() {
    for (name, cols, rows) in [("80x24", 80, 24), ("40x12", 40, 12)] {
        let opened = open(SWINGING, Origin::Stdin);
        let mut session = shown(opened, Glyphs::Ascii, cols, rows);
        session.workbench = Workbench::new(
            open(SWINGING, Origin::Stdin),
            Glyphs::Ascii,
            Colours::None,
            cols,
            rows,
        );
        let screen = session.press(ALMOST_DEAD).look();
        insta::assert_snapshot!(format!("unsure-no-colour-{name}"), masked(&screen));
    }
    let mut session = shown(open(SWINGING, Origin::Stdin), Glyphs::Ascii, 80, 24);
    let screen = session.press(ALMOST_DEAD).look();
    // A rate of r4, and which of its characters are dim.
    let row = screen
        .lines()
        .position(|line| line.contains("| r4            0  "))
        .unwrap();
    let line = screen.lines().nth(row).unwrap();
    let from = line.find("  4.").unwrap() + 2;
    let dim: String = (from..line.len())
        .map(|col| {
            let at = |n: usize| u16::try_from(n).unwrap();
            let cell = session.terminal.screen().cell(at(row), at(col)).unwrap();
            if cell.dim() { '~' } else { ' ' }
        })
        .collect();
    assert_eq!(&dim[..1], " ", "{line}\n{dim}");
    assert!(dim.contains("~~~"), "{line}\n{dim}");
    assert!(
        dim.trim_start().trim_end().len() < line[from..].len(),
        "{line}\n{dim}"
    );
    // Where all is well, nothing is dim but what is quiet anyway.
    let line = session.press("Home").last_line();
    assert!(line.contains("ok  +-"), "{line}");
}

/// The last line tells the largest bound of a place, or that there is none; not where figures are not
/// what is looked at.
#[test]
fn the_largest_bound_stands_in_the_last_line() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    let line = session.last_line();
    let bound = line
        .split("ok  +-")
        .nth(1)
        .unwrap()
        .split(' ')
        .next()
        .unwrap();
    assert!(
        (1e-14..1e-12).contains(&bound.parse::<f64>().unwrap()),
        "{line}"
    );
    assert!(line.contains(" mm  ? help"), "{line}");
    assert!(!session.press("e").last_line().contains("+-"));
    assert!(!session.press("1 ?").last_line().contains("+-"));
    // On a short line the key that leads on comes first.
    let mut narrow = four_bar(Glyphs::Ascii, 40, 12);
    let line = narrow.last_line();
    assert!(line.contains("? help") && !line.contains("+-"), "{line}");
}

/// Whoever does not know the keys finds the one that shows them, on every screen.
#[test]
fn the_key_of_the_help_is_always_named() {
    for preset in presets::all() {
        for (cols, rows) in [(40, 12), (60, 16), (80, 24)] {
            let opened = open(preset.text, Origin::Preset(preset.name.into()));
            let mut session = shown(opened, Glyphs::Ascii, cols, rows);
            for view in ["1", "2", "3", "4", "5", "6"] {
                let line = session.press(view).last_line();
                assert!(line.contains("? help"), "{}: {line}", preset.name);
            }
            let line = session.press("?").last_line();
            assert!(line.contains("Esc back"), "{}: {line}", preset.name);
        }
    }
}

#[test]
fn what_is_cut_shows_that_it_is() {
    let mut session = shown(preset("stephenson-six-bar"), Glyphs::Ascii, 80, 24);
    let screen = session.look();
    let title = screen.lines().next().unwrap();
    assert!(
        title.starts_with(" Stephenson's six-bar, driv.. "),
        "{title}"
    );
    let mut narrow = shown(preset("offset-slider-crank"), Glyphs::Ascii, 40, 12);
    let line = narrow.last_line();
    assert!(
        line.starts_with(" motion  offset-..  60.00 deg ok"),
        "{line}"
    );
}

/// A mechanism that is wide and low leaves its room to the tables.
#[test]
fn a_flat_drawing_leaves_room_for_the_points() {
    let mut session = shown(preset("slider-crank"), Glyphs::Ascii, 80, 40);
    let screen = session.look();
    for row in [" r3.com ", " C "] {
        assert!(screen.lines().any(|line| line.starts_with(row)), "{screen}");
    }
}

#[test]
fn goes_where_it_is_told_and_says_where_it_cannot() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    let typed = session.press("g 1 2 3 . 5").last_line();
    assert_eq!(typed, " go to  angle [deg]: 123.5    Enter go  Esc cancel");
    assert!(
        session
            .press("Enter")
            .last_line()
            .contains("123.50 deg  ok")
    );
    assert!(
        session
            .press("g x Enter")
            .last_line()
            .contains("not a number of deg: x")
    );
    assert!(session.press("Esc").last_line().contains("123.50 deg"));

    let far = session.press("g Ctrl-U 1 e 3 0 0 Enter").last_line();
    assert!(
        far.contains("turns  ok  ") && far.contains("? help"),
        "{far}"
    );

    let opened = open(SWINGING, Origin::Stdin);
    let mut session = shown(opened, Glyphs::Ascii, 80, 24);
    let refused = session.press("g 1 8 0 Enter").last_line();
    assert!(
        refused.ends_with("out of reach: -82.81 to 82.81 deg"),
        "{refused}"
    );
    // The same direction a turn away is meant.
    let reached = session.press("Ctrl-U 4 2 0 Enter").last_line();
    assert!(
        reached.ends_with("60.00 deg  taken as 60.00 deg"),
        "{reached}"
    );
}

#[test]
fn steps_are_exact_decimals() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    session.press("[ [ [ [ [ [");
    for _ in 0..7 {
        session.press(".");
    }
    assert!(session.last_line().contains("   60.70 deg  ok"));
    session.press("] ] ] ] ] ] ] ] ] ] ] , , ,");
    assert!(session.last_line().contains("  150.70 deg -1 turn  ok"));
    assert!(
        session
            .press("Home")
            .last_line()
            .contains("   60.00 deg  ok")
    );
}

#[test]
fn plays_a_turn_in_four_seconds_and_pauses_without_a_byte() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    session.press("space").pass(1.0);
    assert!(session.last_line().contains("  150.00 deg  ok"));
    // A line that hangs for a turn and more drops frames, not truth.
    assert!(
        session
            .pass(5.0)
            .last_line()
            .contains("  240.00 deg +1 turn  ok")
    );
    session.press("r").pass(1.0);
    assert!(session.last_line().contains("  150.00 deg +1 turn  ok"));
    session.press("+").pass(0.5);
    assert!(session.last_line().contains("   60.00 deg +1 turn  ok"));
    session.press("space");
    let before = session.workbench.frames();
    session.pass(10.0).paint();
    assert_eq!(session.workbench.frames(), before);
}

#[test]
fn a_crank_that_cannot_turn_goes_to_and_fro() {
    let opened = open(SWINGING, Origin::Stdin);
    let mut session = shown(opened, Glyphs::Ascii, 80, 24);
    session.press("space");
    let mut angles = Vec::new();
    for _ in 0..200 {
        let line = session.pass(0.05).last_line();
        let words: Vec<&str> = line.split_whitespace().collect();
        let at = words.iter().position(|w| *w == "deg").unwrap();
        angles.push(words[at - 1].parse::<f64>().unwrap());
        assert!(!line.contains("no assembly"), "{line}");
    }
    let turns = angles
        .windows(3)
        .filter(|a| (a[1] - a[0]) * (a[2] - a[1]) < 0.0);
    assert!(turns.count() >= 4, "{angles:?}");
}

#[test]
fn presets_follow_each_other_in_a_ring() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    for preset in presets::all().iter().skip(1).chain(presets::all().first()) {
        let line = session.press("n").last_line();
        assert!(line.contains(preset.name), "{line}");
    }
    let last = presets::all().last().unwrap().name;
    assert!(session.press("p").last_line().contains(last));
}

#[test]
fn every_preset_is_shown_at_every_size_while_it_plays() {
    let sizes = [
        (40, 12),
        (80, 24),
        (200, 60),
        (41, 30),
        (300, 12),
        (10, 3),
        (1, 1),
    ];
    for preset in presets::all() {
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            let opened = open(preset.text, Origin::Preset(preset.name.into()));
            let workbench = Workbench::new(opened, glyphs, Colours::None, 80, 24);
            let mut workbench = workbench.timed_by(made_up);
            workbench.press("space");
            for (cols, rows) in sizes {
                workbench.resize(cols, rows);
                for view in ["1", "2", "e", "3", "4", "5", "6", "?", "PgDn", "Esc"] {
                    workbench.press(view);
                    workbench.pass(Duration::from_millis(130));
                    let frame = workbench.paint();
                    let seven_bits = frame.iter().all(|byte| *byte < 0x80);
                    assert!(glyphs != Glyphs::Ascii || seven_bits, "{}", preset.name);
                }
            }
        }
    }
}

#[test]
fn the_smallest_screens_say_what_is_needed() {
    let mut session = four_bar(Glyphs::Ascii, 39, 12);
    assert_eq!(session.look().trim(), "krank needs 40 x 12 characters");
    four_bar(Glyphs::Ascii, 1, 1).look();
}

#[test]
fn titles_from_a_file_reach_the_terminal_harmless() {
    let hostile = SWINGING.replace("Swinging crank", "A\\u001B[2J\\u202Eb\\u4E2D\\u00E9");
    let title = |glyphs| {
        let opened = open(&hostile, Origin::File("\u{1b}[2J.toml".into()));
        let screen = shown(opened, glyphs, 80, 24).look();
        let line = screen.lines().next().unwrap().to_owned();
        line.split_whitespace().next().unwrap().to_owned()
    };
    assert_eq!(title(Glyphs::Ascii), "A?[2J?b??");
    assert_eq!(title(Glyphs::Line), "A?[2J?b?\u{e9}");
    assert_eq!(title(Glyphs::Braille), "A?[2J?b?\u{e9}");
}

#[test]
fn a_frame_costs_few_bytes_and_none_where_nothing_changes() {
    for (colours, most) in [(Colours::Sixteen, 900), (Colours::None, 700)] {
        let mut workbench = Workbench::new(preset("four-bar"), Glyphs::Braille, colours, 80, 24);
        workbench.paint();
        assert!(workbench.paint().is_empty());
        workbench.press("space");
        let mut costs = Vec::new();
        for _ in 0..120 {
            workbench.pass(Duration::from_secs_f64(4.0 / 120.0));
            costs.push(workbench.paint().len());
        }
        costs.sort_unstable();
        assert!(costs[60] <= most, "{colours:?}: median {} bytes", costs[60]);
    }
}

/// What a person, or a cat, may do.
#[derive(Clone, Debug)]
enum Deed {
    Press(&'static str),
    Pass(u16),
    Resize(u16, u16),
}

fn deeds() -> impl Strategy<Value = Vec<Deed>> {
    let keys = [
        "space",
        ",",
        ".",
        "[",
        "]",
        "-",
        "+",
        "r",
        "g",
        "Home",
        "n",
        "p",
        "t",
        "Tab",
        "1",
        "2",
        "4",
        "e",
        "Up",
        "Down",
        "PgUp",
        "PgDn",
        "?",
        "Esc",
        "3",
        "0",
        "9",
        "e",
        "Enter",
        "a",
        "Backspace",
        "Ctrl-U",
    ];
    let deed = prop_oneof![
        8 => prop::sample::select(keys.to_vec()).prop_map(Deed::Press),
        2 => (0_u16..9000).prop_map(Deed::Pass),
        1 => (1_u16..140, 1_u16..50).prop_map(|(cols, rows)| Deed::Resize(cols, rows)),
    ];
    prop::collection::vec(deed, 1..60)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Whatever is done, the workbench lives, and what frames add up to is what one frame shows.
    #[test]
    fn frames_add_up_to_the_screen_whatever_is_done(deeds in deeds(), preset in 0_usize..19) {
        let preset = &presets::all()[preset % presets::all().len()];
        let opened = open(preset.text, Origin::Preset(preset.name.into()));
        let mut session = shown(opened, Glyphs::Ascii, 80, 24);
        for deed in deeds {
            match deed {
                Deed::Press(key) => {
                    session.workbench.press(key);
                }
                Deed::Pass(ms) => session.workbench.pass(Duration::from_millis(ms.into())),
                Deed::Resize(cols, rows) => {
                    session.workbench.resize(cols, rows);
                    session.terminal = emulator(cols, rows);
                }
            }
            session.paint();
        }
        let shown = session.look();
        session.workbench.forget();
        let size = session.terminal.screen().size();
        session.terminal = emulator(size.1.get(), size.0.get());
        prop_assert_eq!(shown, session.look());
    }
}

/// A window that became smaller and larger again at once: the terminal has lost what it showed.
#[test]
fn a_size_that_is_what_it_was_paints_all_again() {
    for (cols, rows) in [(80, 24), (11, 1)] {
        let mut session = four_bar(Glyphs::Ascii, cols, rows);
        let shown = session.look();
        session.workbench.resize(cols, rows);
        session.terminal = emulator(cols, rows);
        assert_eq!(session.look(), shown);
    }
}

/// The other assemblies: listed in the place of the tables, and drawn in points.
#[test]
fn shows_the_other_assemblies_as_ghosts() {
    for (name, glyphs) in [
        ("ascii", Glyphs::Ascii),
        ("line", Glyphs::Line),
        ("braille", Glyphs::Braille),
    ] {
        let screen = four_bar(glyphs, 80, 24).press("a").look();
        insta::assert_snapshot!(format!("assemblies-{name}-80x24"), screen);
    }
    let screen = four_bar(Glyphs::Ascii, 40, 12).press("a").look();
    insta::assert_snapshot!("assemblies-ascii-40x12", screen);
    let mut coupled = shown(preset("stephenson-six-bar"), Glyphs::Ascii, 80, 24);
    insta::assert_snapshot!("assemblies-coupled-80x24", coupled.press("a Up").look());
}

#[test]
fn an_assembly_is_taken_and_stays() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    let before = session.look();
    let closed = session.press("a Esc").look();
    assert_eq!(closed, before, "a look changes nothing");
    let line = session.press("a Enter").last_line();
    assert!(line.contains("C=- now; w saves it"), "{line}");
    let crossed = session.look();
    // The coupler's direction at 60 deg, now and a full turn later.
    assert!(crossed.contains("302.825"), "{crossed}");
    session.press("space").pass(4.0).press("space g 6 0 Enter");
    let later = session.look();
    assert!(later.contains("302.825"), "{later}");
    // The list now has the cursor on the other one: back again.
    let again = session.press("a Enter").look();
    assert!(again.contains("29.379"), "{again}");
}

#[test]
fn what_does_not_close_is_not_taken() {
    let mut session = shown(preset("press"), Glyphs::Ascii, 80, 24);
    let screen = session.press("a Up Up Up").look();
    let row = screen.lines().find(|l| l.contains(" C - ")).unwrap();
    assert!(row.trim_end().ends_with("open"), "{row}");
    let line = session.press("Down Enter").last_line();
    assert!(line.contains("the rest does not close with C=-"), "{line}");
    let mut yoke = shown(preset("scotch-yoke"), Glyphs::Ascii, 80, 24);
    let line = yoke.press("a").last_line();
    assert!(line.contains("there is no other assembly here"), "{line}");
}

#[test]
fn an_assembly_is_saved() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("saving");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("mine.toml");
    let text = presets::find("four-bar").unwrap().text;
    let text = text.replace("[start]", "# rough\n[start]");
    std::fs::write(&file, &text).unwrap();
    let opened = open(&text, Origin::File(file.clone()));
    let mut session = shown(opened, Glyphs::Ascii, 80, 24);
    session.press("a Enter");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text, "not unasked");
    let line = session.press("w").last_line();
    assert!(line.contains("written to "), "{line}");
    let saved = std::fs::read_to_string(&file).unwrap();
    assert!(
        saved.contains("# rough\n[start]\nC = [212.622, -165.497]"),
        "{saved}"
    );
    // Once more, with what is in the file now; and not where somebody has changed it meanwhile.
    let line = session.press("a Enter w").last_line();
    assert!(line.contains("written to "), "{line}");
    std::fs::write(&file, text.replace("15 rad/s", "16 rad/s")).unwrap();
    let line = session.press("a Enter w").last_line();
    assert!(line.contains("has changed on disk"), "{line}");
    assert!(std::fs::read_to_string(&file).unwrap().contains("16 rad/s"));
}

#[test]
fn a_preset_is_saved_under_a_name_that_is_typed() {
    let mut session = four_bar(Glyphs::Ascii, 80, 24);
    let line = session.press("w").last_line();
    assert!(line.contains("write to: four-bar.toml"), "{line}");
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("saving-as");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("new.toml");
    let keys: Vec<String> = file.to_str().unwrap().chars().map(String::from).collect();
    session.press("Ctrl-U").press(&keys.join(" "));
    let line = session.press("Enter").last_line();
    assert!(line.contains("written to "), "{line}");
    assert!(std::fs::read_to_string(&file).unwrap().contains("[start]"));
    // It is the scene's own file now.
    let line = session.press("w").last_line();
    assert!(line.contains("nothing has changed"), "{line}");
    // Another scene does not write over it unasked.
    let mut other = shown(preset("press"), Glyphs::Ascii, 40, 12);
    other.press("w Ctrl-U").press(&keys.join(" "));
    let line = other.press("Enter").last_line();
    assert!(line.contains("write over new.toml?"), "{line}");
    other.press("Esc");
    assert!(
        !std::fs::read_to_string(&file)
            .unwrap()
            .contains("[links]\nr5")
    );
}
