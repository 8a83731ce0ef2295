//! The line under the drawing: the position in the cycle, with dead points, limits and change
//! points.
//!
//! ```text
//! |------------o-------:---|  135 of 360 deg   dead point 203.6
//! ```

use super::super::{columns, print};
use crate::drawing::Glyphs;
use crate::report;
use crate::solver::Range;
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::figures::format::rounded;
use crate::tui::player::led_motion::LedMotion;
use crate::tui::player::next_singularity::{SingularityKind, singularities};
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Minimum length of the bar; the text beside it is dropped part by part to reach it.
const MIN_BAR: u16 = 16;
const GAP: u16 = 2;
/// Decimals of an angle of a singularity.
const DECIMALS: usize = 1;
/// Number of digits to which a length or a time is shown: finer than the bar's cells, and coarse
/// enough that few change per frame.
const DIGITS: f64 = 3.0;

/// The contents of the line. The bar's ends are the ends of the motion.
#[derive(Debug, PartialEq)]
struct CycleLine {
    /// How much of the motion lies before the driver, from 0 to 1.
    share: f64,
    /// The same for each singularity between the ends.
    marks: Vec<f64>,
    /// `true` if the motion ends where it begins.
    is_closed: bool,
    /// The driver's coordinate or time, and the whole.
    position: String,
    /// The next singularity, padded to the width of the longest one.
    next: String,
}

impl CycleLine {
    fn of(app: &App) -> CycleLine {
        let open_scene = app.open_scene();
        if let Some(led) = open_scene.led() {
            return CycleLine::led(led);
        }
        if let (Some(timetable), Some(time)) = (open_scene.timetable(), open_scene.time()) {
            let period = timetable.period();
            let since = time.rem_euclid(period);
            return CycleLine {
                share: since / period,
                marks: Vec::new(),
                is_closed: true,
                position: within(since, period, decimals(period), "s"),
                next: String::new(),
            };
        }
        let (at, unit) = (open_scene.at(), open_scene.unit());
        let (range, motion) = (open_scene.driver_range(), open_scene.solver().motion());
        let all = singularities(range, motion);
        let (start, span, is_closed) = match motion.range {
            Range::Full { period } => (0.0, period, true),
            Range::Limited { low, high } => (low, high - low, false),
        };
        let share = |at: f64| match is_closed {
            true => (at / span).rem_euclid(1.0),
            false if span > 0.0 => ((at - start) / span).clamp(0.0, 1.0),
            false => 0.0,
        };
        let place = match (is_closed, range.turns()) {
            (true, _) => within(at.rem_euclid(span), span, 0, unit),
            (false, true) => between(at, start, start + span, 0, unit),
            (false, false) => between(at, start, start + span, decimals(span), unit),
        };
        let fine = match range.turns() {
            true => DECIMALS,
            false => decimals(span) + 1,
        };
        let name = |&(kind, at): &(SingularityKind, f64)| {
            format!("{} {}", kind.name(open_scene.scene()), fixed(at, fine))
        };
        let width = all.iter().map(|one| name(one).chars().count()).max();
        // How far each lies ahead in the direction of playback, within one cycle.
        let sense = if app.playback().is_backwards() {
            -1.0
        } else {
            1.0
        };
        let ahead = |to: f64| match is_closed {
            true => ((to - at) * sense).rem_euclid(span),
            false if (to - at) * sense >= 0.0 => (to - at) * sense,
            // Behind the driver, which meets it after the next end.
            false => 2.0 * span - (to - at) * sense,
        };
        let next = all.iter().min_by(|a, b| ahead(a.1).total_cmp(&ahead(b.1)));
        let next = next.map(name).unwrap_or_default();
        let marks = all.iter().map(|(_, at)| share(*at));
        CycleLine {
            share: share(at),
            marks: marks
                .filter(|share| is_closed || (*share > 0.0 && *share < 1.0))
                .collect(),
            is_closed,
            position: place,
            next: format!("{next:<width$}", width = width.unwrap_or(0)),
        }
    }

    /// Returns the line of a leading point: its time, its singular positions, and the end of the
    /// motion if the inputs cannot follow the whole path.
    fn led(led: &LedMotion) -> CycleLine {
        let [first, end] = led.span();
        let (span, is_closed) = (end - first, led.is_closed());
        let inside = led.singular().iter().map(|(time, _)| led.share(*time));
        let limit = || format!("{} {}", words().limit(), led.text(end));
        CycleLine {
            share: led.share(led.time()),
            marks: inside
                .filter(|share| *share > 0.0 && *share < 1.0)
                .collect(),
            is_closed,
            position: match is_closed && first == 0.0 {
                true => within(led.time(), span, decimals(span), "s"),
                false => between(led.time(), first, end, decimals(span), "s"),
            },
            next: if led.is_complete() {
                String::new()
            } else {
                limit()
            },
        }
    }

    /// Returns the bar's characters.
    fn bar(&self, glyphs: Glyphs, length: u16) -> Vec<char> {
        let (end, line) = match glyphs {
            Glyphs::Ascii => ('|', '-'),
            Glyphs::Line | Glyphs::Braille | Glyphs::Blocks(_) => ('\u{2502}', '\u{2500}'),
        };
        let length = usize::from(length.max(2));
        let mut bar = vec![line; length];
        (bar[0], bar[length - 1]) = (end, end);
        for share in &self.marks {
            bar[self.cell(*share, length)] = ':';
        }
        bar
    }

    /// Returns the cell of a share of the motion. Only a motion between limits reaches the ends.
    fn cell(&self, share: f64, length: usize) -> usize {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the length"
        )]
        let cell = |cells: f64| cells as usize;
        let last = length - 1;
        match self.is_closed {
            true => (1 + cell(share * (length - 2) as f64)).min(last),
            false => cell((share * last as f64).round()).min(last),
        }
    }
}

/// Returns the number of decimals of a length or a time with this range.
fn decimals(span: f64) -> usize {
    let digits = span.log10().floor();
    (0..9)
        .find(|&d| d as f64 + digits >= DIGITS - 1.0)
        .unwrap_or(9)
}

/// Formats a number rounded to so many decimals.
fn fixed(number: f64, decimals: usize) -> String {
    report::fixed(rounded(number, decimals), decimals)
}

/// Formats a position within a cycle; its width is that of the whole.
fn within(at: f64, complete: f64, decimals: usize, unit: &str) -> String {
    let complete = fixed(complete, decimals);
    let at = fixed(at, decimals);
    // A position that rounds to the whole cycle begins the next one.
    let at = if at == complete {
        fixed(0.0, decimals)
    } else {
        at
    };
    let width = complete.chars().count();
    words().place_in_cycle(&format!("{at:>width$}"), &complete, unit)
}

/// Formats a position between two limits; its width is that of the longer one.
fn between(at: f64, low: f64, high: f64, decimals: usize, unit: &str) -> String {
    let [at, low, high] = [at, low, high].map(|number| fixed(number, decimals));
    let width = low.chars().count().max(high.chars().count());
    words().place_in_range(&format!("{at:>width$}"), &low, &high, unit)
}

/// Renders the line into a row; a simple one without numbers.
pub(super) fn render(app: &App, is_simple: bool, area: Rect, buffer: &mut Buffer) {
    if area.height == 0 || area.width < MIN_BAR {
        return;
    }
    let line = CycleLine::of(app);
    let mut texts = vec![line.position.as_str()];
    if !line.next.is_empty() {
        texts.push(&line.next);
    }
    let used = |texts: &[&str]| texts.iter().map(|text| columns(text) + GAP).sum::<u16>();
    while used(&texts) + MIN_BAR > area.width {
        texts.pop();
    }
    let glyphs = match is_simple {
        true => Glyphs::Ascii,
        false => app.glyphs(),
    };
    let bar = line.bar(glyphs, area.width - used(&texts));
    let quiet = theme::part(ScreenPart::Quiet);
    let here = line.cell(line.share, bar.len());
    let mut x = area.x;
    for (cell, glyph) in bar.into_iter().enumerate() {
        let (glyph, style) = match cell == here {
            true => ('o', theme::part(ScreenPart::Name)),
            false => (glyph, quiet),
        };
        buffer[(x, area.y)].set_char(glyph).set_style(style);
        x += 1;
    }
    for text in texts.into_iter().filter(|_| !is_simple) {
        x += GAP;
        let space = area.right().saturating_sub(x);
        x = print(buffer, x, area.y, space, text, quiet);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_width() {
        assert_eq!(within(5.4, 360.0, 0, "deg"), "  5 of 360 deg");
        assert_eq!(within(359.7, 360.0, 0, "deg"), "  0 of 360 deg");
        assert_eq!(within(0.42, 1.2, decimals(1.2), "s"), "0.42 of 1.20 s");
        assert_eq!(between(-7.0, -82.82, 82.82, 0, "deg"), " -7 in -83..83 deg");
    }

    #[test]
    fn bar_marks_singularities_and_has_one_cell_per_share() {
        let line = |share, is_closed| CycleLine {
            share,
            marks: vec![0.5],
            is_closed,
            position: String::new(),
            next: String::new(),
        };
        let bar: String = line(0.0, true).bar(Glyphs::Ascii, 11).iter().collect();
        assert_eq!(bar, "|----:----|");
        for (share, closed, open) in [(0.0, 1, 0), (0.5, 5, 5), (0.999, 9, 10), (1.0, 10, 10)] {
            assert_eq!(line(share, true).cell(share, 11), closed, "{share}");
            assert_eq!(line(share, false).cell(share, 11), open, "{share}");
        }
    }
}
