//! Tests the screen as a whole: tabs, panes, the dispatch of keys to panes, and the list of
//! commands.

use crate::claims::{assert_shown, figures};
use crate::screen::{SIX, Session, four_bar, open, preset};
use krank::drawing::Glyphs;
use krank::scene::presets;
use krank::tui::{Colours, Config, Origin, Workbench};
use std::time::Duration;

fn tabs(session: &mut Session) -> String {
    session.painted_text().lines().next().unwrap().to_owned()
}

/// Opens a workbench with a configuration.
fn configured(text: &str, cols: u16, rows: u16) -> Session {
    let config = Config::parse(text, "config.toml").unwrap();
    let workbench = Workbench::new(preset("four-bar"), Glyphs::Ascii, Colours::None, cols, rows);
    Session::on(workbench.configured(&config), cols, rows)
}

#[test]
fn tabs_name_views_and_mark_the_active_one() {
    let mut wide = four_bar(130, 40);
    let line = "[1 Motion] 2 Tables  3 Plots  4 Accuracy  5 Forces  6 Scene  7 Working  8 Motor  9 Lengths  0 Polygons";
    assert!(tabs(&mut wide).starts_with(line));
    assert!(tabs(&mut wide).ends_with("? help  : commands"));
    let mut middle = four_bar(120, 40);
    let line = "[1 Motion]2 Tables 3 Plots 4 Accuracy 5 Forces 6 Scene 7 Working 8 Motor 9 Lengths 0 Polygons ";
    assert!(tabs(&mut middle).starts_with(line));
    assert!(tabs(&mut middle).ends_with("? help  : commands"));
    let mut usual = four_bar(80, 24);
    let line = " 1 Motion 2 Tables[3 Plots]4 Accu. 5 Forces 6 Scene 7 Working 8 Motor 9 Lengths";
    assert_eq!(tabs(usual.press("3")), line);
    assert!(tabs(usual.press("0")).starts_with(" 1 2 3 4 5 6 7 8 9[0 Polygons]  "));
    let mut small = four_bar(40, 12);
    assert_eq!(tabs(small.press("3")), " 1 2[3 Plots]4 5 6 7 8 9 0");
    assert_eq!(tabs(small.press("9")), " 1 2 3 4 5 6 7 8[9 Lengths]0");
    assert_eq!(tabs(small.press("1 e")), " 1 2 3 4 5 6 7 8[9 Lengths]0");
}

#[test]
fn tab_cycles_through_views_and_shift_tab_goes_back() {
    for (cols, rows) in [(80, 24), (120, 40), (200, 60)] {
        let mut session = four_bar(cols, rows);
        let mut seen = Vec::new();
        for _ in 0..10 {
            seen.push(tabs(&mut session));
            session.press("Tab");
        }
        assert_eq!(tabs(&mut session), seen[0]);
        for before in seen.iter().rev() {
            assert_eq!(&tabs(session.press("Shift-Tab")), before);
        }
    }
}

#[test]
fn tab_of_empty_view_is_dim_and_view_explains_why() {
    let mut session = four_bar(80, 24);
    session.painted_text();
    let dims = |session: &Session| -> String {
        let cells = (0..80).map(|col| session.terminal.screen().cell(0, col).unwrap());
        // Dim blanks are invisible.
        let dim = cells.filter(|cell| cell.dim() && cell.contents().trim() != "");
        dim.map(|cell| cell.contents().to_owned()).collect()
    };
    assert_eq!(dims(&session), "5Forces8Motor");
    for key in ["5", "8"] {
        let line = session.press(key).last_line();
        assert!(line.contains("no forces here: no loads"), "{line}");
        assert!(session.press("Esc").last_line().contains("? help"));
    }
    let mut loaded = Session::new(preset("four-bar-load"), Glyphs::Ascii, 80, 24);
    loaded.painted_text();
    assert_eq!(dims(&loaded), "");
}

/// A large screen shows drawing, tables and plot, a wider one also the scene; smaller screens show
/// what fits.
#[test]
fn pane_layout_follows_screen_size() {
    for name in SIX {
        let opened = || {
            open(
                presets::find(name).unwrap().text,
                Origin::Preset(name.into()),
            )
        };
        let shown = |cols, rows| Session::new(opened(), Glyphs::Ascii, cols, rows).painted_text();
        let screen = shown(120, 40);
        let titles = screen.lines().nth(1).unwrap();
        assert!(titles.contains("+- tables --"), "{screen}");
        assert!(screen.contains("\n- plots ---"), "{screen}");
        assert!(
            screen.contains("| vector ") || screen.contains("|  vector "),
            "{screen}"
        );
        let screen = shown(200, 60);
        let titles = screen.lines().nth(1).unwrap();
        assert!(
            titles.contains("+- tables --") && screen.contains("+- scene --"),
            "{screen}"
        );
        assert!(screen.contains("driver speed"), "{screen}");
        for (cols, rows) in [(80, 24), (40, 12)] {
            let screen = shown(cols, rows);
            assert!(!screen.contains("- plots"), "{screen}");
            assert!(
                screen.contains("vector") && screen.contains('o'),
                "{screen}"
            );
        }
        // The orientation is the same at all sizes in between.
        for (cols, rows) in [(110, 34), (140, 50), (160, 60), (189, 90)] {
            let screen = shown(cols, rows);
            assert!(
                screen.lines().nth(1).unwrap().contains("+- tables --"),
                "{screen}"
            );
        }
    }
}

/// A larger screen shows no fewer numbers than a smaller one.
#[test]
fn larger_screens_show_no_fewer_values() {
    for name in SIX {
        let mut before = 0;
        for (cols, rows) in [(40, 12), (80, 24), (120, 40), (200, 60)] {
            let screen = Session::new(preset(name), Glyphs::Ascii, cols, rows).painted_text();
            let count = figures(&screen).len();
            assert!(
                count >= before,
                "{name} at {cols} x {rows}: {count}, {before}\n{screen}"
            );
            before = count;
        }
    }
}

#[test]
fn view_without_pane_opens_next_to_drawing() {
    let mut session = Session::new(preset("press-ram"), Glyphs::Ascii, 120, 40);
    let screen = session.press("5").painted_text();
    assert!(
        screen.contains("+=[forces]==") && screen.contains("- plots ---"),
        "{screen}"
    );
    assert!(screen.contains("force on"), "{screen}");
    // It stays while another pane is active, and its values follow.
    let screen = session.press(";").painted_text();
    assert!(
        screen.contains("+- forces --") && screen.contains("=[plots]=="),
        "{screen}"
    );
    let moved = session.press(".").painted_text();
    let torque = |screen: &str| -> String {
        let row = screen.lines().find(|line| line.contains("| r2  ")).unwrap();
        row.split('|').nth(1).unwrap().to_owned()
    };
    assert_ne!(torque(&moved), torque(&screen));
    assert!(session.press("2").painted_text().contains("+=[tables]=="));
    assert!(session.last_line().contains("; pane  O alone"));
    // The tables return to their place, and no forces remain.
    assert!(!session.painted_text().contains("force on"));
}

#[test]
fn pane_can_be_maximized_and_restored() {
    let mut session = four_bar(120, 40);
    let all = session.press("2").painted_text();
    let alone = session.press("O").painted_text();
    assert!(
        !alone.contains("plots ---") && alone.contains("15.0000                 0"),
        "{alone}"
    );
    assert_eq!(session.press("O").painted_text(), all);
    assert_eq!(session.press("O Esc").painted_text(), all);
    // The drawing alone has no tables next to it.
    let drawing = session.press("1 O").painted_text();
    assert!(
        drawing.contains("=[Four-bar crank-rocker]==") && !drawing.contains("vector"),
        "{drawing}"
    );
    session.press("O");
    let mut session = four_bar(80, 24);
    let with_tables = session.painted_text();
    let drawing = session.press("O").painted_text();
    assert!(drawing.contains("=[Four-bar crank-rocker]=="), "{drawing}");
    assert!(!drawing.contains("vector"), "{drawing}");
    assert_eq!(session.press("O").painted_text(), with_tables);
    assert_eq!(session.press("O Esc").painted_text(), with_tables);
    for keys in ["2 O", ";"] {
        let line = four_bar(80, 24).press(keys).last_line();
        assert!(line.contains("there is no other pane"), "{keys}: {line}");
    }
}

#[test]
fn split_between_panes_can_be_moved() {
    let bar = |session: &mut Session| {
        let screen = session.painted_text();
        screen.lines().nth(1).unwrap().find(['|', '+']).unwrap()
    };
    for (cols, rows) in [(80, 24), (120, 40), (200, 60)] {
        let mut session = four_bar(cols, rows);
        let before = bar(&mut session);
        assert_eq!(bar(session.press("(")), before - 4);
        assert_eq!(bar(session.press(") )")), before + 4);
        assert_eq!(bar(session.press("(")), before);
        let line = session.press(&"( ".repeat(30)).last_line();
        assert!(line.contains("there is no split to move"), "{line}");
    }
}

#[test]
fn layouts_are_set_by_name_and_cycled_by_key() {
    let mut session = configured("layout = \"lecture\"", 120, 40);
    let screen = session.painted_text();
    assert!(
        screen.contains("+- working --") && screen.contains("\n- tables --"),
        "{screen}"
    );
    assert!(screen.contains("Vector polygons"), "{screen}");
    let line = session.press("|").last_line();
    assert!(line.contains("layout: design"), "{line}");
    assert!(session.painted_text().contains("+- scene --"));
    assert!(session.press("|").last_line().contains("layout: auto"));
    assert!(session.painted_text().contains("+- tables --"));
    let alone = configured("layout = \"one\"", 120, 40)
        .press("2")
        .painted_text();
    assert!(!alone.contains("plots ---"), "{alone}");
    let two = configured("layout = \"two\"", 80, 24)
        .press("7")
        .painted_text();
    assert!(
        two.contains("+=[working]==") && two.contains(" o "),
        "{two}"
    );
    let wrong = Config::parse("layout = \"thre\"", "config.toml");
    assert!(wrong.unwrap_err().to_string().contains("three"));
}

/// Regression test: Left, Right, h, l and Home turned the crank inside lists.
#[test]
fn list_keys_do_not_move_the_crank() {
    for (cols, rows) in [(80, 24), (120, 40)] {
        for view in ["2", "3", "4", "5", "6", "7", "8", "9"] {
            let mut session = Session::new(preset("press-ram"), Glyphs::Ascii, cols, rows);
            session.press(view);
            for key in [
                "Left", "Right", "h", "l", "Home", "End", "Ctrl-D", "Ctrl-U", "G", "g g", "k", "j",
            ] {
                session.press(key);
                // While a study runs, its progress replaces the angle.
                let line = session.press("1").last_line();
                assert!(line.contains(" 60.00 deg"), "{view} {key}: {line}");
                session.press(view);
            }
            assert!(
                session.press(". 1").last_line().contains("65.00 deg"),
                "{view}"
            );
        }
    }
    let mut drawing = four_bar(80, 24);
    assert!(drawing.press("Right l").last_line().contains("70.00 deg"));
    assert!(drawing.press("Home").last_line().contains("60.00 deg"));
}

#[test]
fn lists_scroll_to_their_ends_and_can_be_searched() {
    for view in ["2", "6", "7", "9"] {
        let mut session = four_bar(80, 24);
        let top = session.press(view).body();
        let end = session.press("End").body();
        assert_ne!(end, top, "{view}");
        assert_eq!(session.press("Home").body(), top, "{view}");
        assert_eq!(session.press("G").body(), end, "{view}");
        assert_eq!(session.press("g g").body(), top, "{view}");
        let half = session.press("Ctrl-D").body();
        assert!(half != top && half != end, "{view}");
        assert_eq!(session.press("Ctrl-U").body(), top, "{view}");
    }
    let mut working = four_bar(80, 24);
    let found = working.press("7 /").type_in("check").press("Enter").body();
    assert!(found.contains("Check"), "{found}");
    let line = working.press("/").type_in("nowhere").last_line();
    assert!(line.contains("no row is named nowhere"), "{line}");
}

#[test]
fn unhandled_keys_go_to_the_visible_drawing() {
    let mut session = four_bar(120, 40);
    let line = session.press("2 v").last_line();
    assert!(line.contains("velocity arrows on"), "{line}");
    // In a maximized pane, no drawing can handle it, and a message reports that.
    let line = session.press("O v").last_line();
    assert!(
        line.contains("v does nothing here; ? lists the keys"),
        "{line}"
    );
}

#[test]
fn commands_are_listed_and_fuzzily_searched() {
    for (cols, rows) in [(40, 12), (80, 24), (120, 40)] {
        let mut session = four_bar(cols, rows);
        let before = session.body();
        assert_shown(
            &session.press(":").painted_text(),
            &["> play or pause space"],
        );
        let screen = session.type_in("zmin").painted_text();
        assert_shown(&screen, &["> zoom in z"]);
        assert_eq!(session.press("Esc").body(), before);
        session.press(":").type_in("velocit").press("Enter");
        let line = session.last_line();
        assert!(line.contains("velocity arrows on"), "{line}");
        // A command of another view opens that view.
        session.press(":").type_in("choose plots").press("Enter");
        assert!(session.painted_text().contains("plot what?"));
        session.press("Esc :").type_in("zzzz");
        assert!(session.painted_text().contains("no such command"));
        assert!(
            !session
                .press("Esc")
                .press(":")
                .type_in("quit")
                .workbench
                .press("Enter")
        );
    }
}

/// Limits the median size of a frame while playing, in true colours: one view at 80 x 24, and panes
/// on larger screens.
#[test]
fn median_frame_with_panes_costs_few_bytes() {
    for (cols, rows, maximum) in [(80, 24, 500), (120, 40, 1200), (200, 60, 2000)] {
        let opened = preset("four-bar");
        let mut workbench = Workbench::new(opened, Glyphs::Braille, Colours::True, cols, rows);
        workbench.paint();
        assert!(workbench.paint().is_empty());
        workbench.press("space");
        let mut costs: Vec<usize> = (0..120)
            .map(|_| {
                workbench.pass(Duration::from_secs_f64(4.0 / 120.0));
                workbench.paint().len()
            })
            .collect();
        costs.sort_unstable();
        assert!(
            costs[60] <= maximum,
            "{cols} x {rows}: median {}",
            costs[60]
        );
    }
}

/// Regression test: Left and Right turned pages only over the drawing, and Home and Ctrl-D did
/// nothing there.
#[test]
fn help_keys_work_over_every_view() {
    for view in ["1", "2", "5", "6"] {
        let mut session = four_bar(80, 24);
        let first = session.press(view).press("?").body();
        let second = session.press("Right").body();
        assert_ne!(first, second, "{view}");
        assert_eq!(session.press("Left").body(), first, "{view}");
        let end = session.press("End").body();
        assert_ne!(end, first, "{view}");
        assert_eq!(session.press("Home").body(), first, "{view}");
        assert_ne!(session.press("Ctrl-D").body(), first, "{view}");
    }
}

/// Regression test: a repeated search found hits on the last screen again and again.
#[test]
fn repeated_search_advances_and_marks_hits() {
    let mut session = four_bar(80, 24);
    session.press("7 /").type_in("r4").press("Enter");
    let mut met = Vec::new();
    for _ in 0..80 {
        let body = session.body();
        let marked: Vec<&str> = body.lines().filter(|l| l.starts_with('>')).collect();
        let [line] = marked[..] else {
            panic!("one line is marked:\n{body}");
        };
        assert!(line.contains("r4"), "{line}");
        met.push(line.to_owned());
        session.press("/ Enter");
    }
    let first = met.iter().skip(1).position(|line| *line == met[0]);
    let round = 1 + first.expect("it begins again");
    assert!(round > 5, "{met:?}");
    assert_eq!(met[..round], met[round..2 * round]);
    session.press("1 7");
    assert!(!session.body().contains('>'));
}

/// Regression test: sideways keys did nothing without a message in all lists but the tables.
#[test]
fn sideways_key_without_columns_reports_it() {
    let mut session = four_bar(120, 40);
    for key in ["Left", "h", "l", "Right"] {
        let line = session.press("1 7").press(key).last_line();
        assert!(line.contains("no other column here"), "{key}: {line}");
        assert!(line.contains("60.00 deg"), "{line}");
    }
}

#[test]
fn layout_change_keeps_the_active_view() {
    let mut session = four_bar(120, 40);
    session.press("5 | |").press(";");
    assert!(
        session.painted_text().contains("forces"),
        "{}",
        session.painted_text()
    );
    session.press("; ;");
    assert!(
        session.painted_text().contains("forces"),
        "{}",
        session.painted_text()
    );
}

/// Even on the smallest screen, a question about possible loss of edits is readable.
#[test]
fn prompts_are_readable_on_tiny_screens() {
    let mut session = four_bar(80, 24);
    session.press("6 Down >").resize(30, 8).press("q");
    let screen = session.painted_text();
    for output in ["unsaved edits", "w save", "Esc stay"] {
        assert!(screen.contains(output), "{screen}");
    }
    session.press("Esc g");
    session.type_in("75");
    assert!(
        session.painted_text().contains("75"),
        "{}",
        session.painted_text()
    );
}
