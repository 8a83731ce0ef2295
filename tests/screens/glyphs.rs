//! Checks that all kinds of glyphs show the same content: they only change the look of lines and
//! letters.

use crate::claims::{cells, figures, places, spelled};
use crate::screen::{Session, preset};
use krank::drawing::Glyphs;
use krank::scene::presets;

const SIZES: [(u16, u16); 3] = [(40, 12), (80, 24), (120, 40)];

/// A screen of line glyphs equals an ASCII screen, cell by cell. Plots are excepted, because their
/// curves have corners.
#[test]
fn line_screens_match_ascii_screens_cell_by_cell() {
    for found in presets::all() {
        // At these sizes no plot pane fits next to the view.
        for (cols, rows) in [(40, 12), (80, 24), (100, 40)] {
            let [mut plain, mut lines] = [Glyphs::Ascii, Glyphs::Line]
                .map(|glyphs| Session::new(preset(found.name), glyphs, cols, rows));
            for keys in [
                "1",
                "v A T c i",
                "v A T c i",
                "2",
                "5",
                "6",
                "7",
                "e",
                "1 a",
            ] {
                let (plain, lines) = (
                    plain.press(keys).painted_text(),
                    lines.press(keys).painted_text(),
                );
                assert_eq!(spelled(&lines), plain, "{} {keys}", found.name);
            }
        }
    }
}

/// Removes the labels below the horizontal axes of charts, up to the border of the next pane. Panes share
/// the screen by need, and the units of ASCII are wider, so that a chart can be narrower and have other ticks.
fn without_ticks(screen: &str) -> String {
    let mut is_label = false;
    let mut kept = String::new();
    for line in screen.lines() {
        let from = if is_label {
            line.rfind(['|', '│']).unwrap_or(line.len())
        } else {
            0
        };
        kept += &line[from..];
        kept.push('\n');
        is_label = ["++-", "└+─"].iter().any(|axis| line.contains(axis));
    }
    kept
}

/// A Braille screen with Greek letters misses no number of an ASCII screen.
#[test]
fn braille_screens_show_every_ascii_value() {
    for found in presets::all() {
        for (cols, rows) in SIZES {
            let [mut plain, mut dotted] = [Glyphs::Ascii, Glyphs::Braille]
                .map(|glyphs| Session::new(preset(found.name), glyphs, cols, rows));
            for view in ["1", "2", "3", "5", "6", "7", "e", "8"] {
                let (plain, dotted) = (
                    plain.press(view).painted_text(),
                    dotted.press(view).painted_text(),
                );
                let output = figures(&without_ticks(&dotted));
                let missing = figures(&without_ticks(&plain))
                    .into_iter()
                    .find(|figure| !output.contains(figure));
                assert_eq!(missing, None, "{} {view}\n{plain}{dotted}", found.name);
            }
        }
    }
}

/// A plot shows the same numbers in all glyphs, and its marks for the crank and the extrema lie
/// within one cell.
#[test]
fn plot_marks_agree_within_one_cell_in_all_glyphs() {
    let shown = |glyphs, cols, rows| {
        let mut session = Session::new(preset("four-bar"), glyphs, cols, rows);
        session.press("3").body()
    };
    for (cols, rows) in [(80, 24), (40, 12)] {
        let plain = shown(Glyphs::Ascii, cols, rows);
        assert!(plain.contains("6.3847 at 120.35"), "{plain}");
        let marks = |screen: &str| places(&cells(screen), &['O', '^', 'v']);
        for glyphs in [Glyphs::Line, Glyphs::Braille] {
            let fine = shown(glyphs, cols, rows);
            assert_eq!(figures(&fine), figures(&plain), "{fine}{plain}");
            let (fine_marks, plain_marks) = (marks(&fine), marks(&plain));
            assert_eq!(fine_marks.len(), plain_marks.len(), "{fine}{plain}");
            for (fine_mark, mark) in fine_marks.iter().zip(&plain_marks) {
                let off = (fine_mark.0.abs_diff(mark.0), fine_mark.1.abs_diff(mark.1));
                assert!(off.0 <= 1 && off.1 <= 1, "{mark:?}:\n{fine}{plain}");
            }
        }
    }
}
