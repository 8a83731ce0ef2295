//! Tests the plots view, its list, and its empty states.

use crate::claims::assert_shown;
use crate::screen::{Session, open, preset};
use krank::drawing::Glyphs;
use krank::quantity::Catalogue;
use krank::scene::{Scene, presets};
use krank::tui::{Colours, Origin, Workbench};
use proptest::prelude::*;
use std::time::{Duration, Instant};

/// A driver without speed: no time passes, and every rate is 0.
const SPEEDLESS: &str = r#"
name = "Still"
unit = "mm"
[ground]
A = [0, 0]
D = [100, 0]
[driver]
link = "r2"
angle = 60
speed = "0 rad/s"
[links]
r2 = { from = "A", to = "B", length = 20 }
r3 = { from = "B", to = "C", length = 100 }
r4 = { from = "C", to = "D", length = 50 }
[start]
C = [90, 50]
"#;

#[test]
fn default_plot_shows_output_motion() {
    let shown = |glyphs, cols, rows| {
        let mut session = Session::new(preset("four-bar"), glyphs, cols, rows);
        session.press("3").body()
    };
    insta::assert_snapshot!("plots-braille-80x24", shown(Glyphs::Braille, 80, 24));
    insta::assert_snapshot!("plots-line-40x12", shown(Glyphs::Line, 40, 12));
    // The default is the output's rate or position, for a slider and for a rocker.
    let first = |name| {
        let mut session = Session::new(preset(name), Glyphs::Ascii, 80, 24);
        session.press("3").body()
    };
    assert!(first("slider-crank").contains("* r4.length"));
    assert!(first("four-bar").contains("* r4.omega"));
}

#[test]
fn list_selects_plotted_columns() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 80, 24);
    session.press("3 x c /").type_in("C. mm/s");
    session.press("Enter");
    let listed = session.painted_text();
    assert!(listed.contains("[ ] C.vx"), "{listed}");
    assert!(!listed.contains("[ ] B.vx"), "{listed}");
    session.press("Enter Down space");
    insta::assert_snapshot!("plots-list-ascii-80x24", session.painted_text());
    // Esc closes the search, then the list; the selection stays.
    session.press("Esc");
    assert!(session.painted_text().contains("[ ] B.vx"));
    session.press("Esc");
    let plotted = session.painted_text();
    assert!(
        plotted.contains("* C.vx") && plotted.contains("x C.vy"),
        "{plotted}"
    );
    // On a small screen the list fills the screen.
    let mut small = Session::new(preset("four-bar"), Glyphs::Ascii, 40, 13);
    let lines = [
        "plot what? 2 of 63",
        "[ ] r3.omega rad/s ^",
        "[x] r4.omega rad/s",
        "> [x] r4.alpha rad/s^2",
        "[ ] B.vy mm/s v",
        "choose 60.00 deg Enter plot Esc done",
    ];
    assert_shown(&small.press("3 Enter Down").painted_text(), &lines);
    small.press("/").type_in("nothing");
    assert!(small.painted_text().contains("no column matches"));
}

/// A key in the list opens the analysis of the selected value over the whole motion, on a small
/// screen too. Esc returns to the list.
#[test]
fn list_opens_cycle_analysis_of_a_column() {
    for (cols, rows) in [(80, 24), (40, 12)] {
        let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, cols, rows);
        session.press("3 x / r 4 . a n g l e Enter o");
        let mut read = session.painted_text();
        assert!(read.contains("Esc back"), "{read}");
        for _ in 0..40 {
            read.push_str(&session.press("Down").painted_text());
        }
        for output in [
            "r4.angle [deg]",
            "swing",
            "47.64319",
            "1.06500633",
            "hardest",
        ] {
            assert!(read.contains(output), "{output}: {read}");
        }
        let last = session.painted_text();
        assert!(last.contains("hardest"), "{last}");
        let listed = session.press("Esc").painted_text();
        assert!(listed.contains("] r4.angle"), "{listed}");
    }
}

/// The scene defines the steering error as an expression.
#[test]
fn expressions_of_the_scene_are_plotted_first() {
    let mut session = Session::new(preset("ackermann"), Glyphs::Ascii, 80, 24);
    let shown = session.press("3").painted_text();
    assert!(shown.contains("* error"), "{shown}");
}

#[test]
fn cursor_and_its_values_follow_driver() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 100, 24);
    let before = session.press("3").painted_text();
    assert!(before.contains("over driver.angle  60.00 deg"), "{before}");
    assert!(
        before.contains("r4.omega  -3.09") || before.contains("r4.omega  3.09"),
        "{before}"
    );
    let after = session.press(".").painted_text();
    assert!(after.contains("over driver.angle  65.00 deg"), "{after}");
    assert_ne!(before, after);
    // One turn later the cursor is at the same place.
    session.press("g").type_in("425");
    let turned = session.press("Enter").painted_text();
    assert!(turned.contains("over driver.angle  65.00 deg"), "{turned}");
}

#[test]
fn x_axis_key_cycles_driver_time_and_plotted_columns() {
    let mut session = Session::new(preset("hoecken"), Glyphs::Ascii, 80, 24);
    session.press("3 x c /").type_in("P.");
    session.press("Enter Enter Down Enter Esc Esc");
    assert!(session.painted_text().contains("over driver.angle"));
    let time = session.press("X").painted_text();
    assert!(
        time.contains("over time: 0 s is where the scene opens"),
        "{time}"
    );
    assert!(session.press(".").painted_text().contains("over time"));
    let against = session.press("X").painted_text();
    assert!(
        against.contains("over P.x") && against.contains("* P.y"),
        "{against}"
    );
    assert!(!against.contains("* P.x"), "{against}");
    insta::assert_snapshot!("plots-coupler-curve-ascii-80x24", session.press("m").body());
    let other = session.press("X").painted_text();
    assert!(other.contains("over P.y"), "{other}");
    assert!(
        session
            .press("X")
            .painted_text()
            .contains("over driver.angle")
    );
    // Without a speed no time passes, so that the time axis is skipped.
    let still = open(SPEEDLESS, Origin::Stdin);
    let mut still = Session::new(still, Glyphs::Ascii, 80, 24);
    assert!(still.press("3 X").painted_text().contains("over r4.omega"));
}

#[test]
fn empty_plot_explains_how_to_add_columns() {
    for (cols, rows) in [(80, 24), (40, 12)] {
        let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, cols, rows);
        let nothing = session.press("3 x c Esc").painted_text();
        assert!(nothing.contains("nothing is plotted yet"), "{nothing}");
        assert!(nothing.contains("x  choose what to plot"), "{nothing}");
        // The offered key works.
        assert!(
            session
                .press("x Enter Esc")
                .painted_text()
                .contains("* r2.")
        );
    }
}

#[test]
fn panels_that_do_not_fit_are_reached_by_scrolling() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 40, 12);
    let first = session.press("3").painted_text();
    assert!(
        first.contains("r4.omega") && !first.contains("r4.alpha"),
        "{first}"
    );
    let second = session.press("Down").painted_text();
    assert!(
        !second.contains("r4.omega") && second.contains("r4.alpha"),
        "{second}"
    );
    assert_eq!(session.press("Down").painted_text(), second);
}

#[test]
fn selection_survives_assembly_change_but_not_scene_change() {
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 80, 24);
    session.press("3 x c /").type_in("C.x");
    session.press("Enter Enter Esc Esc");
    assert!(session.painted_text().contains("* C.x"));
    session.press("a Down Enter 3");
    assert!(
        session.painted_text().contains("* C.x"),
        "{}",
        session.painted_text()
    );
    // A change of assembly is an edit, so that leaving the scene asks.
    assert!(!session.press("n d").painted_text().contains("* C.x"));
}

#[test]
fn curves_are_written_as_csv_and_as_svg() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("screens_plots");
    std::fs::create_dir_all(&folder).unwrap();
    let mut session = Session::new(preset("four-bar"), Glyphs::Ascii, 120, 24);
    session.press("3 X");
    for (key, ending) in [("Y", "csv"), ("S", "svg")] {
        let file = folder.join(format!("curves.{ending}"));
        drop(std::fs::remove_file(&file));
        session.press(key).press("Ctrl-U");
        session.type_in(file.to_str().unwrap()).press("Enter");
        let text = std::fs::read_to_string(&file).unwrap();
        if ending == "csv" {
            let header = "driver.angle [deg],time [s],r4.omega [rad/s],r4.alpha [rad/s^2],state";
            assert_eq!(text.lines().next(), Some(header));
            assert_eq!(text.lines().count(), 722);
            assert!(
                text.lines().nth(1).unwrap().starts_with("60.0,0.0,")
                    || text.lines().nth(1).unwrap().starts_with("60,0,"),
                "{text}"
            );
        } else {
            assert!(
                text.contains(">r4.omega") && text.contains("time"),
                "{text}"
            );
        }
    }
    // Without a plot there is nothing to write.
    session.press("x c Esc Y");
    assert!(session.painted_text().contains("there is no plot to write"));
}

/// Plots the values of every preset at three sizes. One test takes each third value.
fn plot_every_third_value(glyphs: Glyphs, first: usize) {
    for entry in presets::all() {
        let scene = Scene::parse(entry.text, entry.name).unwrap();
        let quantities = Catalogue::new(&scene).figures();
        let mut bench = Workbench::new(preset(entry.name), glyphs, Colours::Sixteen, 80, 24);
        // Plots show the motion of the driver, so that a leading point gives way to it.
        bench.press(if scene.lead.is_some() { "U 3" } else { "3" });
        let mut named = 0;
        for (k, quantity) in quantities.iter().skip(first).step_by(3).enumerate() {
            // Alternates between a single curve and a second one, and sometimes changes the x axis.
            bench.press(if k % 2 == 0 { "x c /" } else { "x /" });
            quantity.name.chars().for_each(|c| {
                bench.press(&c.to_string());
            });
            bench.press("Enter Enter Esc Esc");
            if k % 7 == 0 {
                bench.press("X");
            }
            for (cols, rows) in [(80, 24), (40, 12), (120, 40)] {
                bench.resize(cols, rows);
                let frame = String::from_utf8(bench.paint().to_vec()).unwrap();
                let bad = frame.contains("NaN") || frame.contains("inf");
                assert!(!bad, "{}: {}", entry.name, quantity.name);
                named += usize::from(frame.contains(&quantity.name));
            }
        }
        assert!(named > 0, "{}: nothing was plotted", entry.name);
    }
}

#[test]
fn every_third_value_of_every_preset_is_plotted_in_ascii() {
    plot_every_third_value(Glyphs::Ascii, 0);
}

#[test]
fn every_third_value_of_every_preset_is_plotted_in_lines() {
    plot_every_third_value(Glyphs::Line, 1);
}

#[test]
fn every_third_value_of_every_preset_is_plotted_in_braille() {
    plot_every_third_value(Glyphs::Braille, 2);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    #[test]
    fn random_keys_and_sizes_do_not_panic(
        keys in prop::collection::vec(prop::sample::select(vec![
            "x", "X", "m", "c", "space", "Enter", "Esc", "Up", "Down", "PgDn", "/", "v", ".", "g", "n", "a", "t", "1", "3", "?",
            "Backspace", "Home", "r",
        ]), 0..60),
        which in 0_usize..23,
        sizes in prop::collection::vec((0_u16..150, 0_u16..50), 1..4),
    ) {
        let all = presets::all();
        let name = all[which % all.len()].name;
        let mut bench = Workbench::new(preset(name), Glyphs::Braille, Colours::Sixteen, 80, 24);
        bench.press("3");
        for (k, key) in keys.iter().enumerate() {
            bench.press(key);
            if k % 9 == 0 {
                let (cols, rows) = sizes[k % sizes.len()];
                bench.resize(cols, rows);
            }
            bench.pass(Duration::from_millis(40));
            bench.paint();
        }
    }
}

/// Returns a chain of this many dyads: a four-bar whose rocker drives another one, and so on.
fn chain(dyads: usize) -> String {
    let mut text = String::from(
        "name = \"Chain\"\nunit = \"mm\"\n[driver]\nlink = \"crank\"\nangle = 60\nspeed = \"15 rad/s\"\n",
    );
    let mut parts = [
        "[ground]\nA = [0, 0]\n".to_owned(),
        "[links]\ncrank = { from = \"A\", to = \"C0\", length = 100 }\n".to_owned(),
        "[start]\n".to_owned(),
    ];
    for k in 1..=dyads {
        let (x, before) = (400 * k, k - 1);
        let length = if k == 1 { 300 } else { 400 };
        parts[0] += &format!("D{k} = [{x}, 0]\n");
        parts[1] +=
            &format!("r{k} = {{ from = \"C{before}\", to = \"C{k}\", length = {length} }}\n");
        parts[1] += &format!("s{k} = {{ from = \"C{k}\", to = \"D{k}\", length = 250 }}\n");
        parts[2] += &format!("C{k} = [{}, 234]\n", x - 89);
    }
    parts.iter().for_each(|part| text += part);
    text
}

/// The default plot shows the last rocker, which depends on all other links.
#[test]
fn chain_of_dyads_is_plotted() {
    let mut session = Session::new(open(&chain(40), Origin::Stdin), Glyphs::Ascii, 80, 24);
    let text = session.press("3").painted_text();
    assert!(text.contains("* s40.omega"), "{text}");
    assert!(text.contains("driver.angle"), "{text}");
}

/// Measures the time to open the view of a chain of 1,000 dyads, and to step in it. Run in release,
/// with `--ignored --nocapture`.
#[test]
#[ignore = "a measurement, not a test"]
#[allow(clippy::print_stdout, reason = "the figures are to be read")]
fn measure_plots_of_a_long_chain() {
    let opened = open(&chain(1000), Origin::Stdin);
    let mut bench = Workbench::new(opened, Glyphs::Braille, Colours::Sixteen, 200, 60);
    bench.paint();
    for key in ["3", ".", "X", "x"] {
        let started = Instant::now();
        bench.press(key);
        bench.paint();
        println!("key {key}: {:?}", started.elapsed());
    }
}

/// Measures the time of a frame at 200 x 60 while playing. Run in release, with `--ignored
/// --nocapture`.
#[test]
#[ignore = "a measurement, not a test"]
#[allow(clippy::print_stdout, reason = "the figures are to be read")]
fn measure_frame_with_plots() {
    for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
        let mut bench = Workbench::new(preset("four-bar"), glyphs, Colours::Sixteen, 200, 60);
        bench.press("3 x c /");
        // Six curves of C in three panels, and six of r3's centre of mass.
        for key in ["C", ".", "Enter"] {
            bench.press(key);
        }
        for _ in 0..12 {
            bench.press("Enter Down");
        }
        bench.press("Esc Esc space");
        bench.paint();
        let mut times: Vec<Duration> = (0..1000)
            .map(|_| {
                let started = Instant::now();
                bench.pass(Duration::from_millis(34));
                bench.paint();
                started.elapsed()
            })
            .collect();
        times.sort();
        println!(
            "{glyphs:?}: median {:?}, worst {:?}",
            times[500], times[999]
        );
    }
}

/// The mark in the list, the curve and the link in the drawing have the same hue.
#[test]
fn curve_and_list_mark_have_hue_of_their_link() {
    let workbench = Workbench::new(preset("four-bar"), Glyphs::Ascii, Colours::Indexed, 120, 40);
    let mut session = Session::on(workbench, 120, 40);
    session.press("3 x / r 4 . o m e g a Enter");
    let screen = session.painted_text();
    let hues_of = |session: &Session, wanted: &dyn Fn(&str) -> bool| {
        let screen = session.terminal.screen();
        let cells = (0..40).flat_map(|row| (0..120).filter_map(move |col| screen.cell(row, col)));
        let wanted = cells.filter(|cell| wanted(cell.contents()));
        wanted
            .map(|cell| format!("{:?}", cell.fgcolor()))
            .collect::<Vec<_>>()
    };
    let rows = screen.lines().enumerate();
    let (row, at) = rows
        .filter_map(|(row, line)| Some((row, line.find("[x]")? + 1)))
        .next()
        .unwrap();
    let mark = session
        .terminal
        .screen()
        .cell(row as u16, at as u16)
        .unwrap();
    let mark = format!("{:?}", mark.fgcolor());
    assert!(mark.contains("Idx"), "{mark}\n{screen}");
    let curve = hues_of(&session, &|text| text == "*");
    assert!(
        curve.iter().filter(|hue| **hue == mark).count() > 20,
        "{curve:?}\n{screen}"
    );
    session.press("x 1");
    let bars = hues_of(&session, &|text| ["\\", "/", "|"].contains(&text));
    assert!(
        bars.iter().filter(|hue| **hue == mark).count() > 5,
        "{bars:?}"
    );
}
