//! Tests texts in little space: short last lines, prompts after errors, and labels of axes.

use crate::scene::Values;
use crate::screen::{Session, four_bar, open, preset};
use krank::drawing::Glyphs;
use krank::scene::presets;
use krank::tui::Origin;

/// Creates a folder for a test.
fn folder(name: &str) -> std::path::PathBuf {
    let folder = std::env::temp_dir().join(format!("krank-words-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// A truncated number would be another number: it is shown in full or not at all.
#[test]
fn messages_never_truncate_the_angle() {
    let mut session = four_bar(40, 12);
    let line = session.press("i").last_line();
    assert_eq!(line, " motion  names of points and links");
    let line = session.press("i").last_line();
    assert_eq!(line, " motion   60.00 deg  no names");
    // The reason for missing values takes precedence over the requested message.
    let mut rocker = Session::new(preset("double-rocker"), Glyphs::Ascii, 40, 12);
    rocker.press("g 3 9 Enter").press("[").press(", ,");
    let line = rocker.press(", , ,").last_line();
    assert_eq!(line, " motion  36.86989765 deg dead point");
}

/// A message that does not fit in the last line is shown above it in full, and covers no typed
/// text.
#[test]
fn long_messages_are_shown_in_full() {
    for (cols, rows) in [(40, 12), (80, 24), (120, 40)] {
        let mut session = four_bar(cols, rows);
        session.press("6").find("r3 len").press("@");
        let typed = "nowhere.at.all.is.this = 12";
        session.type_in(typed).press("Enter");
        let screen = session.painted_text();
        let words: Vec<&str> = screen.split_whitespace().collect();
        let output = words.join(" ");
        assert!(session.last_line().contains(typed), "{screen}");
        assert!(
            output.contains("nowhere") && !output.contains(".."),
            "{screen}"
        );
        // The next key clears it.
        session.press("Backspace");
        assert_ne!(session.painted_text(), screen);
        let verdict = screen.lines().nth(rows as usize - 2).unwrap().to_owned();
        let after = session.painted_text();
        let after = after.lines().nth(rows as usize - 2).unwrap();
        if cols < 120 {
            assert_ne!(after, verdict);
        }
    }
}

#[test]
fn plot_list_shows_its_keys_on_a_small_screen() {
    let line = four_bar(40, 12).press("3 x").last_line();
    assert_eq!(line, " choose   60.00 deg Enter plot  Esc done");
}

/// `/` searches in every view.
#[test]
fn search_has_same_label_in_every_view() {
    for view in ["2", "6"] {
        let line = four_bar(80, 24).press(view).press("/ r 4").last_line();
        assert_eq!(line, " search  name: r4    Enter keep  Esc back");
    }
    assert!(
        four_bar(80, 24)
            .press("o")
            .painted_text()
            .contains("search: ")
    );
}

#[test]
fn fit_key_is_shown_after_zooming() {
    let mut session = four_bar(80, 24);
    assert!(!session.last_line().contains("f fit"));
    assert!(session.press("z").last_line().contains("? help  f fit  "));
    assert!(!session.press("f").last_line().contains("f fit"));
}

/// The number at the end of the axis is below its own tick, not below the previous one.
#[test]
fn axis_numbers_are_below_their_ticks() {
    for (cols, rows) in [(40, 12), (80, 24), (120, 40)] {
        for keys in ["3", "3 X", "3 X X"] {
            let mut session = Session::new(preset("jansen-leg"), Glyphs::Ascii, cols, rows);
            let screen = session.press(keys).painted_text();
            let lines: Vec<&str> = screen.lines().collect();
            let [ticks, labels] = [lines[lines.len() - 4], lines[lines.len() - 3]];
            let ticks = format!("{ticks:121}");
            let mut end = 0;
            for label in labels.split_whitespace() {
                let from = end + labels[end..].find(label).unwrap();
                end = from + label.len();
                let near = &ticks[from - 1..=end];
                let is_number = label.parse::<f64>().is_ok();
                assert!(!is_number || near.contains('+'), "{label}:\n{screen}");
            }
        }
    }
}

/// The error names the missing folder, and the typed name can be corrected.
#[test]
fn missing_folder_is_named_and_can_be_corrected() {
    let mut session = four_bar(120, 40);
    session.press("W Ctrl-U").type_in("/nowhere/a.toml");
    let line = session.press("Enter").last_line();
    let text = " save  write to: /nowhere/a.toml    not written, no such folder: /nowhere";
    assert_eq!(line, text);
    let file = folder("mended").join("a.toml");
    session.press("Ctrl-U").type_in(file.to_str().unwrap());
    let line = session.press("Enter").last_line();
    assert!(line.contains("written to "), "{line}");
    std::fs::remove_dir_all(file.parent().unwrap()).unwrap();
}

/// A deleted file cannot be reloaded over unsaved edits.
#[test]
fn deleted_file_is_not_offered_for_reload() {
    let file = folder("gone-words").join("a.toml");
    let text = presets::find("four-bar").unwrap().text;
    std::fs::write(&file, text).unwrap();
    let mut session = Session::new(
        open(text, Origin::File(file.clone())),
        Glyphs::Ascii,
        80,
        24,
    );
    let screen = session.press("6 > R").painted_text();
    assert!(screen.contains("reload over unsaved edits?"), "{screen}");
    session.press("Esc");
    std::fs::remove_dir_all(file.parent().unwrap()).unwrap();
    let line = session.press("R").last_line();
    assert!(line.contains("a.toml deleted: w saves it again"), "{line}");
}
