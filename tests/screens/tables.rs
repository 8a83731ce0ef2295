//! The tables with their cursor, and taking things out: the clipboard, files, and the printed screen.

use crate::screen::{SWINGING, Session, folder, open, preset};
use krank::drawing::Glyphs;
use krank::tui::{Colours, Origin, Workbench};
use std::collections::HashMap;
use std::process::{Command, Stdio};

/// Further steps than there is way.
const TO_THE_DEAD_POINT: &str = "] ] ] ] ] .";

fn four_bar(cols: u16, rows: u16) -> Session {
    Session::new(preset("four-bar"), Glyphs::Ascii, cols, rows)
}

/// What the program prints, and its exit code.
fn krank(args: &[&str]) -> (String, Option<i32>) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_krank"));
    command.env_clear().env("LC_ALL", "C").args(args);
    let output = command.stdin(Stdio::null()).output().unwrap();
    (
        String::from_utf8(output.stdout).unwrap(),
        output.status.code(),
    )
}

/// The row of the screen that bears the mark of the cursor.
fn under_cursor(session: &mut Session) -> String {
    let screen = session.look();
    let mut marked = screen.lines().filter(|line| line.starts_with('>'));
    let line = marked.next().unwrap_or_else(|| panic!("{screen}"));
    assert_eq!(marked.next(), None, "{screen}");
    assert_eq!(line.matches('[').count(), 1, "{screen}");
    line.to_owned()
}

/// The cells that are reversed, but for the mode.
fn reversed(session: &mut Session) -> String {
    let screen = session.look();
    let cell = |row: usize, col: usize| {
        let [row, col] = [row, col].map(|n| u16::try_from(n).unwrap());
        let cell = session.terminal.screen().cell(row, col).unwrap();
        cell.inverse().then(|| cell.contents().to_owned())
    };
    let rows = 0..screen.lines().count() - 1;
    let cells = rows.flat_map(|row| (0..80).filter_map(move |col| cell(row, col)));
    cells.collect()
}

#[test]
fn a_cursor_is_on_a_row_and_a_figure() {
    let mut session = four_bar(80, 24);
    assert!(under_cursor(session.press("2")).starts_with("> r2        [100.000] "));
    assert_eq!(reversed(&mut session), "100.000");
    let row = under_cursor(session.press("Down j L"));
    assert!(row.starts_with("> r4         250.000  [290.753*]"), "{row}");
    // Over what lies between, to the points, as many figures from the left.
    let row = under_cursor(session.press("Down Down"));
    assert!(row.starts_with("> A           0.000     [0.000] "), "{row}");
    assert!(under_cursor(session.press("k Up Up H")).starts_with("> r3        [300.000]"));
    assert!(under_cursor(session.press("Up Up Up Up")).starts_with("> r2        [100.000]"));
    assert!(under_cursor(session.press("PgDn")).starts_with("> r4.com"));
    // Through the columns of all chunks, and no further.
    session.press("PgUp Down Down Down Down Down Down Down L L L L L L L L L L L L L");
    let row = under_cursor(&mut session);
    assert!(row.contains("[206.466]"), "{row}");
    insta::assert_snapshot!("tables-cursor-ascii-80x24", bounds_masked(&session.look()));
    // The figures change below the cursor, and it stays.
    let row = under_cursor(session.press("."));
    assert!(row.starts_with("> C ") && !row.contains("206.466"), "{row}");
}

/// The bound in the last line, whose digits a formula may change.
fn bounds_masked(screen: &str) -> String {
    let Some((before, behind)) = screen.split_once("+-") else {
        return screen.to_owned();
    };
    let behind = behind.split_once(' ').map_or("", |(_, behind)| behind);
    format!("{before}+-... {behind}")
}

#[test]
fn the_view_scrolls_after_the_cursor_and_keeps_the_names_of_columns() {
    let mut session = Session::new(preset("jansen-leg"), Glyphs::Ascii, 40, 12);
    session.press("2");
    let mut last = String::new();
    for _ in 0..200 {
        let row = under_cursor(session.press("Down"));
        let screen = session.look();
        let heading = screen.lines().nth(1).unwrap();
        assert!(!row.is_empty() && !heading.is_empty(), "{screen}");
        let above = screen.lines().take_while(|line| !line.starts_with('>'));
        let names = |line: &&str| line.starts_with("  vector ") || line.starts_with("  point ");
        assert!(above.filter(names).count() >= 1, "{screen}");
        last = row;
    }
    // At the end it stays, and comes back the same way.
    assert_eq!(under_cursor(session.press("Down")), last);
    insta::assert_snapshot!("tables-end-ascii-40x12", bounds_masked(&session.look()));
    for _ in 0..200 {
        session.press("Up");
    }
    assert_eq!(
        session.look().lines().nth(2).unwrap().chars().next(),
        Some('>')
    );
    // A size that is too small for anything loses nothing, and another width keeps the figure.
    session.press("PgDn PgDn PgDn");
    let figure = |row: &str| row.split(['[', ']']).nth(1).unwrap().to_owned();
    let before = figure(&under_cursor(&mut session));
    for (cols, rows) in [(20, 5), (120, 40), (40, 12)] {
        session.workbench.resize(cols, rows);
        session = Session::on(session.workbench, cols, rows);
        session.workbench.forget();
        if cols > 20 {
            assert_eq!(figure(&under_cursor(&mut session)).trim(), before.trim());
        }
    }
}

#[test]
fn rows_are_found_by_name() {
    let mut session = four_bar(80, 24);
    let line = session.press("2 /").last_line();
    assert_eq!(line, " search  name:     Enter keep  Esc back");
    assert!(under_cursor(session.press("C")).starts_with("> C "));
    assert!(under_cursor(session.press("O")).starts_with("> r2.com "));
    assert!(under_cursor(session.press("Enter")).starts_with("> r2.com "));
    // The next ones, and round.
    for name in ["r3.com", "r4.com", "r2.com"] {
        let row = under_cursor(session.press("/ Enter"));
        assert!(row.starts_with(&format!("> {name} ")), "{row}");
    }
    // Given up, the cursor is where it was.
    assert!(under_cursor(session.press("/ r 4 .")).starts_with("> r4.com "));
    assert!(under_cursor(session.press("Esc")).starts_with("> r2.com "));
    // A name that is none is said, and can be mended.
    let line = session.press("/ r 4 z").last_line();
    assert_eq!(line, " search  name: r4z    no row is named r4z");
    assert!(under_cursor(&mut session).starts_with("> r2.com "));
    assert!(
        session
            .press("Enter")
            .last_line()
            .contains("no row is named")
    );
    let line = session.press("Backspace Enter").last_line();
    assert!(line.starts_with(" tables "), "{line}");
    assert!(under_cursor(&mut session).starts_with("> r4 "));
    let mut tiny = four_bar(40, 12);
    let line = tiny.press("2 /").type_in("nothing").last_line();
    assert_eq!(line, " search  name: n no row is named nothing");
    let line = four_bar(80, 24).press("1 /").last_line();
    assert!(line.contains("there is nothing to search here"), "{line}");
}

#[test]
fn points_are_chosen_for_the_motion_view() {
    let mut session = four_bar(80, 24);
    let line = session.press("2 / C Enter x").last_line();
    assert!(line.ends_with("C chosen for the motion view"), "{line}");
    assert!(under_cursor(&mut session).starts_with(">+C "));
    // A vector stands for those of its ends that move.
    let line = session.press("/ r 3 Enter x").last_line();
    assert!(
        line.ends_with("B and C chosen for the motion view"),
        "{line}"
    );
    let marked = |screen: &str| screen.lines().filter(|line| line.starts_with(" +")).count();
    assert_eq!(marked(&session.look()), 4, "B and C, each twice");
    let line = session.press("x").last_line();
    assert!(line.ends_with("B and C no longer chosen"), "{line}");
    assert_eq!(marked(&session.look()), 0);
    for name in ["A", "r 1"] {
        let line = session.press(&format!("/ {name} Enter x")).last_line();
        assert!(line.contains("never moves: nothing to follow"), "{line}");
    }
    // Another scene has other points.
    session.press("/ C Enter x n p");
    assert_eq!(marked(&session.look()), 0);
}

/// What OSC 52 has put on the clipboard, of one sequence and nothing else.
fn on_clipboard(sent: &[u8]) -> String {
    let text = std::str::from_utf8(sent).unwrap();
    let text = text.strip_prefix("\x1b]52;c;").unwrap();
    let text = text.strip_suffix("\x1b\\").unwrap();
    String::from_utf8(base64(text)).unwrap()
}

fn base64(text: &str) -> Vec<u8> {
    const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    assert_eq!(text.len() % 4, 0);
    let digits = text.trim_end_matches('=').chars();
    let (mut bits, mut count, mut bytes) = (0_u32, 0, Vec::new());
    for digit in digits {
        bits = (bits << 6) | u32::try_from(DIGITS.find(digit).unwrap()).unwrap();
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push(u8::try_from((bits >> count) & 0xff).unwrap());
        }
    }
    bytes
}

/// `name -> value` as `krank table --format csv` has them.
fn values_of_table(scene: &str, at: &str) -> HashMap<String, String> {
    let (csv, _) = krank(&["table", scene, "--at", at, "--format", "csv"]);
    let rows = csv.lines().skip(1).map(|row| {
        let mut cells = row.split(',');
        let name = cells.next().unwrap().to_owned();
        (name, cells.next().unwrap().to_owned())
    });
    rows.collect()
}

/// Every cell of copied rows, by the name that a column of a sweep has: `C.vx`.
fn cells_of(copied: &str) -> Vec<(String, String)> {
    let mut lines = copied.lines();
    let heading: Vec<&str> = lines.next().unwrap().split('\t').skip(1).collect();
    let rows = lines.flat_map(|line| {
        let mut cells = line.split('\t');
        let row = cells.next().unwrap();
        let named = heading.iter().zip(cells).map(move |(heading, cell)| {
            let figure = heading.split(' ').next().unwrap();
            (format!("{row}.{figure}"), cell.to_owned())
        });
        named.collect::<Vec<_>>()
    });
    rows.collect()
}

#[test]
fn a_value_a_row_and_a_table_are_copied_with_all_their_digits() {
    let mut session = four_bar(80, 24);
    let line = session.press("2 / C Enter L L y").last_line();
    assert_eq!(line, " copy  v value  r row  t table  Esc back");
    assert_eq!(session.workbench.take_sent(), b"");
    let values = values_of_table("four-bar", "60");
    let line = session.press("v").last_line();
    let sent = session.workbench.take_sent();
    let value = on_clipboard(&sent);
    assert_eq!(value, values["C.vx"]);
    assert!(value.len() > 15, "{value}");
    let told = format!("sent to the terminal's clipboard: {} B", value.len());
    assert!(line.ends_with(&told), "{line}");
    session.press("y r");
    let row = on_clipboard(&session.workbench.take_sent());
    assert!(
        row.starts_with("point\tx [mm]\ty [mm]\tvx [mm/s]\t"),
        "{row}"
    );
    let cells = cells_of(&row);
    assert_eq!(cells.len(), 10);
    for (name, cell) in cells {
        assert_eq!(cell, values[&name], "{name}");
    }
    session.press("y t");
    let table = on_clipboard(&session.workbench.take_sent());
    assert_eq!(table.lines().count(), 8, "{table}");
    session.press("Esc 1 y");
    let both = on_clipboard(&session.workbench.take_sent());
    let (vectors, points) = both.split_once("\n\n").unwrap();
    assert_eq!(points, table);
    assert_eq!(session.workbench.take_sent(), b"", "once");
    let mut compared = 0;
    for (name, cell) in cells_of(vectors).into_iter().chain(cells_of(points)) {
        assert_eq!(cell, values[&name], "{name}");
        compared += 1;
    }
    assert_eq!(compared, 4 * 6 + 7 * 10);
}

#[test]
fn the_question_how_much_is_copied_is_given_up_without_harm() {
    let mut session = four_bar(40, 12);
    let line = session.press("2 y").last_line();
    assert_eq!(line, " copy  v value  r row  t table  Esc back");
    // Keys that answer nothing do nothing: an Esc that a slow line splits must not either.
    assert_eq!(session.press("[ A q").last_line(), line);
    assert!(session.press("Esc").last_line().starts_with(" tables "));
    let line = session.press("y t").last_line();
    assert!(
        line.contains("sent to the terminal's clipboard: "),
        "{line}"
    );
    assert!(!session.workbench.take_sent().is_empty());
    // In the scene it is the value under the cursor; views without one say so.
    let sent = session.press("6 y").workbench.take_sent();
    assert_eq!(on_clipboard(&sent).trim().parse(), Ok(0.0), "A x");
    let line = session.press("e y").last_line();
    assert!(line.contains("nothing to copy here"), "{line}");
    assert_eq!(session.workbench.take_sent(), b"");
}

#[test]
fn what_does_not_exist_is_an_empty_cell() {
    let opened = open(SWINGING, Origin::Stdin);
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    session
        .press(TO_THE_DEAD_POINT)
        .press("2 / r 4 Enter L L L");
    assert!(
        under_cursor(&mut session).contains("[     -*]")
            || under_cursor(&mut session).contains("- ]"),
        "{}",
        session.look()
    );
    let line = session.press("y v").last_line();
    assert!(line.ends_with("there is no value to copy"), "{line}");
    assert_eq!(session.workbench.take_sent(), b"");
    session.press("y r");
    let row = on_clipboard(&session.workbench.take_sent());
    let cells: HashMap<_, _> = cells_of(&row).into_iter().collect();
    assert_eq!(cells["r4.omega"], "");
    assert!(!cells["r4.angle"].is_empty());
    // And so in a file: the very row of a sweep.
    let here = folder("dead-point");
    let (scene, file) = (here.join("swinging.toml"), here.join("row.csv"));
    std::fs::write(&scene, SWINGING).unwrap();
    session
        .press("Y Ctrl-U")
        .type_in(file.to_str().unwrap())
        .press("Enter");
    let written = std::fs::read_to_string(&file).unwrap();
    let at = written.lines().nth(1).unwrap().split(',').next().unwrap();
    let args = ["sweep", scene.to_str().unwrap(), "--from", at, "--to", at];
    assert_eq!(krank(&args), (written.clone(), Some(0)));
    assert!(
        written.contains(",,") && written.ends_with(",dead-point\n"),
        "{written}"
    );
}

#[test]
fn the_figures_are_written_as_a_sweep_of_one_row() {
    let here = folder("figures");
    let file = here.join("row.csv");
    let path = file.to_str().unwrap();
    // The last of them is pushed, and stands where the scene says.
    for (name, keys, at) in [
        ("four-bar", "", Some("60")),
        ("press", "g 4 2 4 . 2 5 Enter", Some("424.25")),
        ("press-ram", "", None),
    ] {
        let mut session = Session::new(preset(name), Glyphs::Ascii, 80, 24);
        let line = session.press(keys).press("2 Y").last_line();
        let proposal = format!(" write  write to: {name}-{}", at.unwrap_or_default());
        assert!(line.starts_with(&proposal), "{line}");
        session
            .press("Ctrl-U")
            .type_in(path)
            .press("Enter")
            .pass(1.0)
            .press("Enter");
        let written = std::fs::read_to_string(&file).unwrap();
        let row = written.lines().nth(1).unwrap();
        let first = row.split(',').next().unwrap();
        assert_eq!(at.unwrap_or(first), first);
        let sweep = krank(&["sweep", name, "--from", first, "--to", first]);
        assert_eq!(sweep, (written.clone(), Some(0)));
    }
    assert_eq!(std::fs::read_dir(&here).unwrap().count(), 1);
}

#[test]
fn no_file_is_written_over_unasked() {
    let here = folder("unasked");
    let file = here.join("kept.csv");
    std::fs::write(&file, "kept").unwrap();
    let mut session = four_bar(80, 24);
    let line = session.press("2 Y").last_line();
    assert_eq!(
        line,
        " write  write to: four-bar-60.csv    Enter write  Esc cancel"
    );
    session.press("Ctrl-U").type_in(file.to_str().unwrap());
    let line = session.press("Enter").last_line();
    assert!(
        line.contains("write over kept.csv?  Enter write  Esc cancel"),
        "{line}"
    );
    session.press("Esc");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "kept");
    session.press("Y Ctrl-U").type_in(file.to_str().unwrap());
    let line = session.press("Enter").pass(1.0).press("Enter").last_line();
    assert!(line.contains("the figures written to"), "{line}");
    assert!(std::fs::read_to_string(&file).unwrap().ends_with(",ok\n"));
    // A folder is no file.
    session.press("Y Ctrl-U").type_in(here.to_str().unwrap());
    let line = session.press("Enter").last_line();
    assert!(line.ends_with(" that is a folder: add a name"), "{line}");
    assert_eq!(std::fs::read_dir(&here).unwrap().count(), 1);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_said_and_another_name_can_be_typed() {
    let mut session = four_bar(80, 24);
    session.press("Y Ctrl-U").type_in("/dev/full");
    let line = session.press("Enter").pass(1.0).press("Enter").last_line();
    assert_eq!(
        line,
        " write  write to: /dev/full    not written: it is a device, not a file"
    );
    // What was asked for is still there.
    let file = folder("full").join("row.csv");
    session.press("Ctrl-U").type_in(file.to_str().unwrap());
    session.press("Enter");
    assert!(
        std::fs::read_to_string(&file)
            .unwrap()
            .starts_with("driver.angle [deg],")
    );
    let nowhere = "/nowhere/row.csv";
    let line = session
        .press("Y Ctrl-U")
        .type_in(nowhere)
        .press("Enter")
        .last_line();
    assert!(
        line.ends_with("/nowhere/row.csv    not written: no such folder"),
        "{line}"
    );
}

#[test]
fn the_screen_and_the_drawing_are_written_as_they_are_seen() {
    let here = folder("pictures");
    let file = here.join("screen.txt");
    for keys in ["1", "2 j j L", "4 Esc", "e"] {
        let mut session = Session::new(preset("press"), Glyphs::Braille, 80, 24);
        let seen = session.press(keys).look();
        let line = session.press("P").last_line();
        assert!(line.contains("write to: press-60.txt"), "{line}");
        session.press("Ctrl-U").type_in(file.to_str().unwrap());
        session.press("Enter").pass(1.0).press("Enter");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), seen);
    }
    let mut session = four_bar(80, 24);
    let line = session.press("S").last_line();
    assert!(line.contains("write to: four-bar-60.svg"), "{line}");
    let file = here.join("drawing.svg");
    session.press("Ctrl-U").type_in(file.to_str().unwrap());
    let line = session.press("Enter").last_line();
    assert!(line.contains("the drawing written to"), "{line}");
    let svg = std::fs::read_to_string(&file).unwrap();
    assert!(
        svg.starts_with("<svg ") && svg.ends_with("</svg>\n"),
        "{svg}"
    );
    let line = session.press("2 S").last_line();
    assert!(line.contains("there is no drawing in this view"), "{line}");
}

/// Of the plots the values at the cursor are copied, and all of them are written.
#[test]
fn what_is_plotted_is_taken_out() {
    let here = folder("plots");
    let mut session = four_bar(80, 24);
    session.press("3 y");
    let copied = on_clipboard(&session.workbench.take_sent());
    let values = values_of_table("four-bar", "60");
    let row = format!("60\t{}\t{}\n", values["r4.omega"], values["r4.alpha"]);
    let heading = "driver.angle [deg]\tr4.omega [rad/s]\tr4.alpha [rad/s^2]\n";
    assert_eq!(copied, format!("{heading}{row}"));
    for (key, ending, begins) in [
        ("Y", "csv", "driver.angle [deg],r4.omega"),
        ("S", "svg", "<svg "),
    ] {
        let line = session.press(key).last_line();
        assert!(
            line.contains(&format!("write to: four-bar-plot.{ending}")),
            "{line}"
        );
        let file = here.join(format!("plot.{ending}"));
        session
            .press("Ctrl-U")
            .type_in(file.to_str().unwrap())
            .press("Enter");
        assert!(std::fs::read_to_string(&file).unwrap().starts_with(begins));
    }
    // Where nothing is plotted, that is said.
    for key in ["y", "Y", "S"] {
        let line = session.press("3 x c x").press(key).last_line();
        assert!(line.contains("nothing"), "{line}");
    }
}

/// Of two scenes the differences are copied, and bear that name.
#[test]
fn differences_are_copied_as_such() {
    let mut session = four_bar(80, 24);
    session.press("2 D d o u b l e Enter");
    let screen = session.look();
    assert!(screen.contains("difference: this - "), "{screen}");
    session.press("y r");
    let row = on_clipboard(&session.workbench.take_sent());
    assert!(row.starts_with("vector, difference\tlength [mm]"), "{row}");
}

/// More than a terminal takes for its clipboard is refused, with what to do instead.
#[test]
fn too_much_for_a_clipboard_is_refused() {
    let bar = |i: usize| format!("p{i} = [\"A\", \"C\"]\n");
    let bars: String = (0..1200).map(bar).collect();
    let scene = format!("{SWINGING}[vectors]\n{bars}");
    let mut session = Session::new(open(&scene, Origin::Stdin), Glyphs::Ascii, 40, 12);
    let line = session.press("2 y t").last_line();
    assert!(line.starts_with(" table too much to copy, "), "{line}");
    assert!(line.ends_with(" B: use Y"), "{line}");
    assert_eq!(session.workbench.take_sent(), b"");
}

/// The printed screen is the one that opens, needs no terminal and no environment.
#[test]
fn the_first_screen_is_printed() {
    let opened =
        |name, cols, rows| Workbench::new(preset(name), Glyphs::Ascii, Colours::None, cols, rows);
    let printed = krank(&["four-bar", "--print"]);
    assert_eq!(printed, (opened("four-bar", 80, 24).text(), Some(0)));
    let mut tables = opened("press", 40, 12);
    tables.press("g 9 0 Enter 2");
    let args = [
        "press", "--print", "--at", "90", "--view", "tables", "--size", "40x12",
    ];
    assert_eq!(krank(&args), (tables.text(), Some(0)));
    let (tiny, code) = krank(&["press", "--print", "--size", "20x3"]);
    assert_eq!(
        (tiny.as_str(), code),
        ("krank needs 40 x 12\n\n\n", Some(0))
    );
    for args in [
        &["--print", "--size", "80"][..],
        &["--print", "--size", "0x24"],
        &["--size", "80x24"],
    ] {
        assert_eq!(krank(args), (String::new(), Some(2)), "{args:?}");
    }
}
