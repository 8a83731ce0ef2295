//! Tests the export of the workbench: to the clipboard and to files.

use crate::claims::{assert_shown, collapse_blanks};
use crate::screen::{SWINGING, Session, folder, four_bar, krank, open, preset};
use crate::tables::under_cursor;
use krank::drawing::Glyphs;
use krank::tui::Origin;
use std::collections::HashMap;

/// More steps than the motion has, so that it ends at the dead point.
const TO_THE_DEAD_POINT: &str = "] ] ] ] ] .";

/// Decodes the clipboard text of a single OSC 52 sequence.
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

/// Returns the values of `krank table --format csv` by name.
fn values_of_table(scene: &str, at: &str) -> HashMap<String, String> {
    let (csv, _) = krank(&["table", scene, "--at", at, "--format", "csv"]);
    let rows = csv.lines().skip(1).map(|row| {
        let mut cells = row.split(',');
        let name = cells.next().unwrap().to_owned();
        (name, cells.next().unwrap().to_owned())
    });
    rows.collect()
}

/// Returns the cells of copied rows with the column names of a sweep, such as `C.vx`.
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
fn value_row_and_table_are_copied_with_full_precision() {
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
    let output = format!("sent to the terminal's clipboard: {} B", value.len());
    assert!(line.ends_with(&output), "{line}");
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
fn copy_prompt_ignores_other_keys_and_closes_on_esc() {
    let mut session = four_bar(40, 12);
    let line = session.press("2 y").last_line();
    assert_eq!(line, " copy  v value  r row  t table  Esc back");
    // Other keys are ignored, because a slow line may split an escape sequence into an Esc and
    // other keys.
    assert_eq!(session.press("[ A q").last_line(), line);
    assert!(session.press("Esc").last_line().starts_with(" tables "));
    let screen = session.press("y t").painted_text();
    assert!(
        collapse_blanks(&screen).contains("sent to the terminal's clipboard: "),
        "{screen}"
    );
    assert!(!session.workbench.take_sent().is_empty());
    // The scene view copies the value under the cursor; views without one report that.
    let sent = session.press("6 y").workbench.take_sent();
    assert_eq!(on_clipboard(&sent).trim().parse(), Ok(0.0), "A x");
    let screen = session.press("5 y").painted_text();
    assert!(
        collapse_blanks(&screen).contains("nothing to copy here"),
        "{screen}"
    );
    assert_eq!(session.workbench.take_sent(), b"");
    // Text views are copied in full.
    for (key, text) in [
        ("e", "r2.com.x"),
        ("7", "Vector polygons"),
        ("4", "closed form"),
    ] {
        let sent = session.press(key).press("y").workbench.take_sent();
        assert!(on_clipboard(&sent).contains(text), "{key}");
    }
}

#[test]
fn missing_values_are_empty_cells() {
    let opened = open(SWINGING, Origin::Stdin);
    let mut session = Session::new(opened, Glyphs::Ascii, 80, 24);
    session
        .press(TO_THE_DEAD_POINT)
        .press("2 / r 4 Enter L L L");
    assert!(
        under_cursor(&mut session).contains("[     -*]")
            || under_cursor(&mut session).contains("- ]"),
        "{}",
        session.painted_text()
    );
    let line = session.press("y v").last_line();
    assert!(line.ends_with("no value to copy"), "{line}");
    assert_eq!(session.workbench.take_sent(), b"");
    session.press("y r");
    let row = on_clipboard(&session.workbench.take_sent());
    let cells: HashMap<_, _> = cells_of(&row).into_iter().collect();
    assert_eq!(cells["r4.omega"], "");
    assert!(!cells["r4.angle"].is_empty());
    // A file gets the same row as `krank sweep`.
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
fn values_are_written_as_one_row_sweep() {
    let here = folder("figures");
    let file = here.join("row.csv");
    let path = file.to_str().unwrap();
    // The last scene is driven by a slide, at the position that the scene gives.
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
fn existing_file_is_overwritten_only_after_confirmation() {
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
    let requested = ["overwrite kept.csv?", "Enter write Esc cancel"];
    assert_shown(&session.press("Enter").painted_text(), &requested);
    session.press("Esc");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "kept");
    session.press("Y Ctrl-U").type_in(file.to_str().unwrap());
    let line = session.press("Enter").pass(1.0).press("Enter").last_line();
    assert!(line.contains("the values written to"), "{line}");
    assert!(std::fs::read_to_string(&file).unwrap().ends_with(",ok\n"));
    // A folder is not a file.
    session.press("Y Ctrl-U").type_in(here.to_str().unwrap());
    let screen = session.press("Enter").painted_text();
    let output = " that is a folder: add a name";
    assert!(collapse_blanks(&screen).contains(output), "{screen}");
    // The rejected name stays visible.
    assert!(session.last_line().contains("write to: "), "{screen}");
    assert_eq!(std::fs::read_dir(&here).unwrap().count(), 1);
}

#[cfg(target_os = "linux")]
#[test]
fn unwritable_path_is_reported_and_can_be_retyped() {
    let mut session = four_bar(80, 24);
    session.press("Y Ctrl-U").type_in("/dev/full");
    let line = session.press("Enter").pass(1.0).press("Enter").last_line();
    assert_eq!(
        line,
        " write  write to: /dev/full    not written: it is a device, not a file"
    );
    // The prompt is still open.
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
fn extension_of_another_program_is_rejected_and_can_be_retyped() {
    let file = folder("foreign").join("report.pdf");
    let mut session = four_bar(80, 24);
    session.press("E Ctrl-U").type_in(file.to_str().unwrap());
    let screen = collapse_blanks(&session.press("Enter").painted_text());
    assert!(screen.contains("not .pdf: type another name"), "{screen}");
    assert!(!file.exists());
    for _ in 0..3 {
        session.press("Backspace");
    }
    session.type_in("md").press("Enter");
    assert!(file.with_extension("md").exists());
}

#[test]
fn screen_and_drawing_are_written_to_files() {
    let here = folder("pictures");
    let file = here.join("screen.txt");
    for keys in ["1", "2 j j L", "4 Esc", "e"] {
        let mut session = Session::new(preset("press"), Glyphs::Braille, 80, 24);
        let seen = session.press(keys).painted_text();
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
    let screen = session.press("Enter").painted_text();
    assert!(
        collapse_blanks(&screen).contains("the drawing written to"),
        "{screen}"
    );
    let svg = std::fs::read_to_string(&file).unwrap();
    assert!(
        svg.starts_with("<svg ") && svg.ends_with("</svg>\n"),
        "{svg}"
    );
    let line = session.press("2 S").last_line();
    assert!(line.contains("this view has no drawing"), "{line}");
}

/// The extension of the typed name selects the report's format.
#[test]
fn report_format_follows_file_extension() {
    let here = folder("reports");
    let mut session = four_bar(80, 24);
    for (name, starts) in [
        ("a.html", "<!DOCTYPE html>"),
        ("a.tex", "\\documentclass"),
        ("a.md", "# Four-bar"),
        ("a.out", "<!DOCTYPE html>"),
    ] {
        let line = session.press("E").last_line();
        assert!(line.contains("write to: four-bar-60.html"), "{line}");
        let file = here.join(name);
        session.press("Ctrl-U").type_in(file.to_str().unwrap());
        let line = session.press("Enter").last_line();
        assert!(line.contains("the report written to"), "{line}");
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(text.starts_with(starts), "{name}: {text}");
        session.pass(20.0);
    }
    // In the plots view, too, the report describes the linkage at its present position.
    let line = session.press("3 E").last_line();
    assert!(line.contains("write to: four-bar-60.html"), "{line}");
}

/// In the plots view, y copies the values at the cursor, and Y and S write the whole curves.
#[test]
fn plots_are_copied_at_cursor_and_written_in_full() {
    let here = folder("plots");
    let mut session = four_bar(80, 24);
    session.press("3 y");
    let copied = on_clipboard(&session.workbench.take_sent());
    let values = values_of_table("four-bar", "60");
    let row = format!("60\t{}\t{}\n", values["r4.omega"], values["r4.alpha"]);
    let heading = "driver.angle [deg]\tr4.omega [rad/s]\tr4.alpha [rad/s^2]\n";
    assert_eq!(copied, format!("{heading}{row}"));
    for (key, ending, starts) in [
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
        assert!(std::fs::read_to_string(&file).unwrap().starts_with(starts));
    }
    // Without a plot, each key reports that.
    for key in ["y", "Y", "S"] {
        let line = session.press("3 x c x").press(key).last_line();
        let is_said = line.contains("no plot") || line.contains("nothing to copy");
        assert!(is_said, "{line}");
    }
}

/// The working is exported in full, whatever part is visible; the file's extension selects the
/// format.
#[test]
fn working_is_copied_and_written_in_full() {
    let here = folder("working");
    let mut session = four_bar(80, 24);
    let line = session.press("7 J J y").last_line();
    assert!(line.contains("clipboard"), "{line}");
    let copied = on_clipboard(&session.workbench.take_sent());
    for part in ["1 Vector polygons", "3 Loop equations", "Check"] {
        assert!(copied.contains(part), "{part}: {copied}");
    }
    for (ending, starts, has) in [
        ("txt", "Four-bar crank-rocker\n", "at 60 deg, with 15 rad/s"),
        ("md", "# Four-bar crank-rocker\n", "\n## 3 Loop equations"),
        ("csv", "driver.angle [deg],", "\n60,"),
    ] {
        let line = session.press("Y").last_line();
        assert!(line.contains("write to: four-bar-60.txt"), "{line}");
        let file = here.join(format!("four-bar.{ending}"));
        session
            .press("Ctrl-U")
            .type_in(file.to_str().unwrap())
            .press("Enter");
        let written = std::fs::read_to_string(&file).unwrap();
        assert!(written.starts_with(starts), "{written}");
        assert!(written.contains(has), "{written}");
    }
    // Other views write the values.
    assert!(session.press("2 Y").last_line().contains("four-bar-60.csv"));
}

/// While two scenes are compared, y copies the differences, and the heading says so.
#[test]
fn copied_differences_are_labelled_as_such() {
    let mut session = four_bar(80, 24);
    session.press("2 D d o u b l e Enter");
    let screen = session.painted_text();
    assert!(
        screen.contains("this - double-rocker; driven at "),
        "{screen}"
    );
    session.press("y r");
    let row = on_clipboard(&session.workbench.take_sent());
    assert!(row.starts_with("vector, difference\tlength [mm]"), "{row}");
}

/// A text too large for the terminal's clipboard is rejected, with the advice to write a file.
#[test]
fn oversized_copy_is_rejected() {
    let bar = |i: usize| format!("p{i} = [\"A\", \"C\"]\n");
    let bars: String = (0..1200).map(bar).collect();
    let scene = format!("{SWINGING}[vectors]\n{bars}");
    let mut session = Session::new(open(&scene, Origin::Stdin), Glyphs::Ascii, 40, 12);
    let screen = collapse_blanks(&session.press("2 y t").painted_text());
    assert!(screen.contains("too much to copy, "), "{screen}");
    assert!(screen.contains(" B: use Y"), "{screen}");
    assert_eq!(session.workbench.take_sent(), b"");
}

/// The sheet is the one that the command line writes.
#[test]
fn exercise_is_written_as_by_the_command_line() {
    let folder = folder("exercise");
    let mut session = four_bar(80, 24);
    session.press(":").type_in("exercise 7").press("Enter");
    assert!(session.last_line().contains("four-bar-7.html"));
    for (ending, format) in [("html", "html"), ("tex", "latex")] {
        let file = folder.join(format!("sheet.{ending}"));
        session.press("Esc :").type_in("exercise 7").press("Enter");
        session.type_in(&file.display().to_string()).press("Enter");
        let (sheet, _) = krank(&["exercise", "four-bar", "--seed", "7", "--format", format]);
        let written = std::fs::read_to_string(file).unwrap();
        let differs = |(a, b): &(&str, &str)| a != b;
        let different = written.lines().zip(sheet.lines()).find(differs);
        assert_eq!(different, None);
        assert_eq!(written.lines().count(), sheet.lines().count());
    }
    // The command line reads the file, so it would make another exercise.
    session.press("6 Down >");
    let refused = session.press(":").type_in("exercise 7").press("Enter");
    assert!(refused.painted_text().contains("save the scene first"));
}
