//! What the given lengths do to the figures: a view of its own, since it is another kind of error than
//! that of the tables.
//!
//! ```text
//!  change for 1 mm               in every length     in one  in which
//!  r3.angle [deg]                          0.843      0.193  r4.length
//! ```

use super::pane::{Need, Pane};
use super::{Sketch, cut, first_seen, inset, print, print_right};
use crate::report::{Answer, Answers, NO_ANSWER};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, Part};
use crate::tui::figures::format::short;
use crate::tui::player::open_scene::shown;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Columns of a number, and blanks before and behind it.
const NUMBER: u16 = 9;
const GAP: u16 = 2;
/// The name of a length has at least so many columns, and no more than this share of the width.
const NAME: u16 = 9;
const SHARE: u16 = 4;
/// The name of a figure needs so many columns to be told from others: `r4.com.vx`.
const FIGURE: u16 = 14;
/// Narrower views leave out the units.
const ROOM_FOR_UNITS: u16 = 56;
/// The names of the columns.
const HEAD: u16 = 1;

/// What each length does.
pub(super) struct LengthsView;

impl Pane for LengthsView {
    fn name(&self) -> &'static str {
        "lengths"
    }

    fn about(&self) -> &'static str {
        "What each length does"
    }

    fn help_title(&self) -> &'static str {
        "In the lengths view"
    }

    fn needs(&self) -> Need {
        Need::Lengths
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let area = inset(body);
        let columns = Columns::of(area);
        let Some(answers) = app.open_scene().answers() else {
            let text = "too many lengths: krank table --sensitivity tells what they do";
            print_text(text, area, buffer);
            return;
        };
        columns.head(answers, area.y, buffer);
        let Some(list) = &answers.list else {
            print_text(NO_ANSWER, below_head(area), buffer);
            return;
        };
        let body = below_head(area);
        let first = first_seen(app, list.len(), body, buffer);
        for (y, answer) in (body.top()..body.bottom()).zip(list.iter().skip(first)) {
            columns.row(app, answer, y, buffer);
        }
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let area = inset(body);
        let list = app.open_scene().answers().and_then(|a| a.list.as_ref());
        (list.map_or(0, Vec::len), below_head(area).height.into())
    }
}

fn below_head(area: Rect) -> Rect {
    Rect {
        y: area.y + HEAD,
        height: area.height.saturating_sub(HEAD),
        ..area
    }
}

/// Text over as many lines as it needs.
fn print_text(text: &str, area: Rect, buffer: &mut Buffer) {
    let lines = crate::report::wrapped(text, area.width.into());
    for (y, line) in (area.top()..area.bottom()).zip(lines) {
        print(
            buffer,
            area.x,
            y,
            area.width,
            &line,
            theme::part(Part::Text),
        );
    }
}

/// Where the columns are: the figure, the numbers by their right ends, the length.
struct Columns {
    figure: u16,
    width: u16,
    worst: u16,
    /// Narrow views keep the figures' names whole, and leave this number out.
    most: Option<u16>,
    length: u16,
    name: u16,
    units: bool,
}

impl Columns {
    fn of(area: Rect) -> Columns {
        let name = (area.width / SHARE).max(NAME);
        let beside = |numbers: u16| area.width.saturating_sub(numbers * (NUMBER + GAP) + name);
        let both = beside(2) >= FIGURE;
        let width = if both { beside(2) } else { beside(1) };
        let worst = area.x + width + NUMBER;
        let most = both.then_some(worst + GAP + NUMBER);
        Columns {
            figure: area.x,
            width,
            worst,
            most,
            length: most.unwrap_or(worst) + GAP,
            name,
            units: area.width >= ROOM_FOR_UNITS,
        }
    }

    fn head(&self, answers: &Answers, y: u16, buffer: &mut Buffer) {
        let style = theme::part(Part::Quiet);
        let step = match self.units {
            true => format!("change for 1 {}", answers.unit),
            false => format!("1 {}", answers.unit),
        };
        print(buffer, self.figure, y, self.width, &step, style);
        let room = usize::from(self.width + NUMBER - GAP).saturating_sub(step.len());
        let all = "in every length";
        let all = if all.len() <= room { all } else { "in all" };
        print_right(buffer, self.worst, y, all, style);
        let which = match self.most {
            Some(right) => {
                print_right(buffer, right, y, "in one", style);
                "in which"
            }
            None => "most in",
        };
        print(buffer, self.length, y, self.name, which, style);
    }

    fn row(&self, app: &App, answer: &Answer, y: u16, buffer: &mut Buffer) {
        let unit = if self.units {
            format!(" [{}]", answer.unit)
        } else {
            String::new()
        };
        let name = shown(&format!("{}{unit}", answer.name), app.glyphs());
        let name = cut(&name, self.width.into());
        print(
            buffer,
            self.figure,
            y,
            self.width,
            &name,
            theme::part(Part::Name),
        );
        let (length, most) = match &answer.most {
            Some((length, most)) => (length.as_str(), *most),
            None => ("-", 0.0),
        };
        let numbers = [Some((self.worst, answer.worst)), self.most.zip(Some(most))];
        for (right, number) in numbers.into_iter().flatten() {
            let text = short(number, NUMBER.into());
            print_right(buffer, right, y, &text, theme::part(Part::Text));
        }
        let length = cut(&shown(length, app.glyphs()), self.name.into());
        print(
            buffer,
            self.length,
            y,
            self.name,
            &length,
            theme::part(Part::Text),
        );
    }
}
