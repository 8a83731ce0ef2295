//! Checks whole frames at every size for six kinds of scenes, in Braille and true colours: tabs,
//! panes, values, the size of the drawing, the hue of every link in its rows, the verdict and the
//! state.

use crate::claims::figures;
use crate::screen::{SIX, Session, preset};
use krank::Input;
use krank::drawing::Glyphs;
use krank::tui::{Colours, Theme, Workbench};
use std::collections::{BTreeMap, BTreeSet};

const SIZES: [(u16, u16); 4] = [(80, 24), (120, 40), (200, 60), (40, 12)];

/// Minimum share of its pane's width or height that a linkage fills over a turn. Half a pin may lie
/// beyond the middle of the outermost cell on either side.
const FILL: f64 = 0.6;

/// The driver's hue on a dark background.
const RED: vt100::Color = vt100::Color::Rgb(255, 172, 164);

fn frame(name: &str, cols: u16, rows: u16) -> Session {
    let workbench = Workbench::new(preset(name), Glyphs::Braille, Colours::True, cols, rows);
    let mut session = Session::on(workbench.themed(Theme::Dark), cols, rows);
    session.paint();
    session
}

/// Calls `check` for the frames of all six scenes at every size, with the scene, the size, the
/// session, and a description for messages.
fn every_frame(check: impl Fn(&str, (u16, u16), &mut Session, &str)) {
    for name in SIX {
        for (cols, rows) in SIZES {
            let mut session = frame(name, cols, rows);
            let place = format!("{name} at {cols} x {rows}\n{}", session.painted_text());
            check(name, (cols, rows), &mut session, &place);
        }
    }
}

/// The pane of the drawing: left of the first vertical line below its title, and above the next
/// title.
struct DrawingPane {
    cols: u16,
    rows: std::ops::Range<u16>,
}

impl DrawingPane {
    fn of(session: &Session) -> DrawingPane {
        let (rows, cols) = session.terminal.screen().size();
        let (rows, cols) = (rows.get(), cols.get());
        let is = |row: u16, col: u16, glyphs: &[&str]| {
            let cell = session.terminal.screen().cell(row, col);
            glyphs.contains(&cell.map_or("", |cell| cell.contents()))
        };
        let body = 1..rows - 2;
        let bar = (20..cols).find(|col| {
            body.clone()
                .all(|row| is(row, *col, &["│", "┬", "┤", "├", "┼"]))
        });
        let end = bar.unwrap_or(cols);
        // On a narrow screen without panes, the tables lie below, under a rule or their own titles.
        let below = |row: &u16| {
            let line: String = (0..end)
                .map(|col| {
                    session
                        .terminal
                        .screen()
                        .cell(*row, col)
                        .map_or(" ", |c| c.contents())
                })
                .collect();
            line.starts_with("─ plots") || line.trim_start().starts_with("vector")
        };
        let last = (2..body.end).find(below).unwrap_or(body.end);
        DrawingPane {
            cols: end,
            rows: 1..last,
        }
    }

    /// Returns the cells with a part of the linkage (dots and pins) and their colours.
    fn inked(&self, session: &Session) -> Vec<(u16, u16, vt100::Color)> {
        let cells = self
            .rows
            .clone()
            .flat_map(|row| (0..self.cols).map(move |col| (row, col)));
        let inked = cells.filter_map(|(row, col)| {
            let cell = session.terminal.screen().cell(row, col)?;
            let glyph = cell.contents().chars().next()?;
            let is_dotted = ('\u{2801}'..='\u{28ff}').contains(&glyph);
            // The title row has letters that look like pins.
            let is_pin = matches!(glyph, 'o' | '@') && row > self.rows.start;
            (is_dotted || is_pin).then(|| (row, col, cell.fgcolor()))
        });
        inked.collect()
    }
}

/// Returns the colours of the vector names in the tables, by name.
fn hues_of_rows(session: &Session, name: &str) -> BTreeMap<String, vt100::Color> {
    let scene = preset(name).scene;
    let (rows, cols) = session.terminal.screen().size();
    let mut found = BTreeMap::new();
    for vector in &scene.vectors {
        let wanted = vector.name.as_str();
        for row in 1..rows.get() - 2 {
            let cells: Vec<_> = (0..cols.get())
                .filter_map(|col| session.terminal.screen().cell(row, col))
                .collect();
            let text: Vec<char> = cells
                .iter()
                .map(|cell| cell.contents().chars().next().unwrap_or(' '))
                .collect();
            let length = wanted.chars().count();
            let at = (0..text.len().saturating_sub(length + 4)).find(|at| {
                // A length follows the name.
                let here: String = text[*at..at + length].iter().collect();
                let parted = *at == 0 || matches!(text[at - 1], ' ' | '>');
                let after = &text[at + length..];
                let blanks = after.iter().take_while(|c| **c == ' ').count();
                let figure = after
                    .get(blanks)
                    .is_some_and(|c| c.is_ascii_digit() || *c == '-');
                here == wanted && parted && blanks > 1 && figure
            });
            if let Some(at) = at {
                found.insert(wanted.to_owned(), cells[at].fgcolor());
                break;
            }
        }
    }
    found
}

#[test]
fn every_frame_has_tabs_panes_values_and_state() {
    every_frame(|_, (cols, rows), session, place| {
        let screen = session.painted_text();
        let lines: Vec<&str> = screen.lines().collect();
        // All tabs appear by their numbers, and the active one is marked.
        assert!(lines[0].contains("[1 Motion]"), "{place}");
        for tab in 2..=9 {
            assert!(lines[0].contains(&format!("{tab}")), "{tab}: {place}");
        }
        // The verdict and the state.
        let verdict = lines[lines.len() - 2];
        assert!(
            verdict.contains("turns fully") || verdict.contains(".."),
            "{place}"
        );
        let last = lines[lines.len() - 1];
        assert!(last.contains("ok") && last.contains(" motion "), "{place}");
        // Panes.
        let titles = lines[1];
        let panes = [("tables", titles), ("scene", &screen)]
            .map(|(pane, text)| text.contains(&format!("─ {pane} ─")));
        let plots = screen.contains("\n─ plots ─");
        let expected = match (cols, rows) {
            (200, _) => ([true, true], true),
            (120, _) => ([true, false], true),
            _ => ([false, false], false),
        };
        assert_eq!((panes, plots), expected, "{place}");
        // The smallest screen shows the values of the first vectors.
        let minimum = match (cols, rows) {
            (200, _) => 42,
            (120, _) => 28,
            (80, _) => 12,
            _ => 4,
        };
        assert!(
            figures(&screen).len() >= minimum,
            "{} figures: {place}",
            figures(&screen).len()
        );
    });
}

#[test]
fn drawing_gets_its_share_of_screen_and_fills_its_pane() {
    every_frame(|_, (cols, rows), session, place| {
        let pane = DrawingPane::of(session);
        let height = f64::from(pane.rows.end - pane.rows.start);
        let share = match cols {
            // Three panes, with their titles and lines.
            120.. => 0.4,
            80 => 0.5,
            // Tables below a drawing on the smallest screen.
            _ => 0.3,
        };
        let cells = f64::from(pane.cols + 1) * height;
        let complete = f64::from(cols) * f64::from(rows);
        assert!(
            cells >= share * complete,
            "{} of {complete}: {place}",
            cells / complete
        );
        // The window shows the whole motion, which the linkage fills over a turn.
        let mut dots = pane.inked(session);
        session.press("space");
        for _ in 0..20 {
            session.pass(0.2).paint();
            dots.extend(pane.inked(session));
        }
        let span = |of: fn(&(u16, u16, vt100::Color)) -> u16| {
            let all = || dots.iter().map(of);
            f64::from(all().max().unwrap() - all().min().unwrap() + 1)
        };
        let (across, down) = (span(|d| d.1) / f64::from(pane.cols), span(|d| d.0) / height);
        assert!(across.max(down) >= FILL, "{across:.2} {down:.2}: {place}");
    });
}

/// A table row has the hue of its link in the drawing, the driver's hue appears wherever there are
/// tables, and different links do not all have the same hue.
#[test]
fn table_rows_have_hues_of_their_links() {
    every_frame(|name, (_, rows), session, place| {
        if name == "scissor-lift" {
            // Folded, its ten stages are only visible in a window that follows it.
            session.press("f").paint();
        }
        let dots = DrawingPane::of(session).inked(session);
        let drawn: BTreeSet<String> = dots
            .iter()
            .map(|(.., colour)| format!("{colour:?}"))
            .collect();
        let rows_of = hues_of_rows(session, name);
        assert!(!rows_of.is_empty(), "{place}");
        let hued = rows_of.values().map(|colour| format!("{colour:?}"));
        let hued: BTreeSet<String> = hued.filter(|hue| hue != "Default").collect();
        let driver = preset(name).scene.mechanism.driver().input;
        let is_driven_by_a_link = matches!(driver, Input::Turn(_));
        assert!(
            hued.len() >= if is_driven_by_a_link { 2 } else { 1 },
            "{rows_of:?}: {place}"
        );
        assert!(drawn.contains(&format!("{RED:?}")), "no driver: {place}");
        // On the smallest screen, links of one row are hidden by the pins at their ends.
        if rows == 12 {
            return;
        }
        for hue in &hued {
            assert!(
                drawn.contains(hue),
                "{hue} of {rows_of:?} is not drawn: {place}"
            );
        }
    });
}
