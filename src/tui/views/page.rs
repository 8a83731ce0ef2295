//! Renders the lines of a page on the screen.

use super::table::doubt;
use super::{columns, first_visible_line, print};
use crate::capability::Colours;
use crate::drawing::Glyphs;
use crate::page::{Line, Page, TextRole, TextStyle, UnprovedDigits, wrapped};
use crate::tui::app::{App, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use std::cell::RefCell;
use std::collections::VecDeque;

/// The lines of the last pages. A frame needs those of a page several times: to know whether the
/// view scrolls, for its keys, and to render it.
#[derive(Debug, Default)]
pub(crate) struct LineCache(RefCell<VecDeque<PageLines>>);

/// A page and its lines in a style.
#[derive(Debug)]
struct PageLines {
    page: Page,
    style: TextStyle,
    lines: Vec<Line>,
}

/// Number of pages whose lines are kept: one for each pane of a large screen.
const MAX_CACHED: usize = 4;

impl LineCache {
    fn lines(&self, page: &Page, style: TextStyle) -> Vec<Line> {
        let mut cached = self.0.borrow_mut();
        let known = cached
            .iter()
            .find(|known| known.style == style && known.page == *page);
        if let Some(known) = known {
            return known.lines.clone();
        }
        let lines = page.lines(style);
        cached.truncate(MAX_CACHED - 1);
        cached.push_front(PageLines {
            page: page.clone(),
            style,
            lines: lines.clone(),
        });
        lines
    }
}

/// Returns the lines of a page for an area, without its title, which every view shows already.
pub(super) fn lines(app: &App, page: &Page, area: Rect) -> Vec<Line> {
    let style = TextStyle {
        // Console fonts lack Greek letters.
        ascii: !app.glyphs().is_dotted(),
        width: area.width.into(),
    };
    let lines = app.views.page_lines.lines(page, style).into_iter();
    let below = lines.skip_while(|line| line.role() == TextRole::Title);
    below.skip_while(|line| line.spans.is_empty()).collect()
}

/// Returns a text as wrapped lines.
pub(super) fn words(text: &str, area: Rect) -> Vec<Line> {
    let lines = wrapped(text, area.width.into()).into_iter();
    lines.map(|line| Line::of(TextRole::Body, line)).collect()
}

/// Renders lines with the view's scroll offset, and marks the current search hit.
pub(super) fn render(app: &App, view: View, lines: &[Line], area: Rect, buffer: &mut Buffer) {
    let first = first_visible_line(app.views.scroll[view as usize], lines.len(), area, buffer);
    let found = app.views.found.as_ref().filter(|_| view == app.view());
    for (y, (n, line)) in (area.top()..area.bottom()).zip(lines.iter().enumerate().skip(first)) {
        let is_found = found.is_some_and(|found| found.line == n && found.is_in(&line.text()));
        if is_found && area.x > 0 {
            print(buffer, area.x - 1, y, 1, ">", theme::part(ScreenPart::Key));
        }
        render_line(
            (app.glyphs(), app.colours()),
            line,
            Rect { y, ..area },
            buffer,
        );
    }
}

/// Renders a line at the top of an area.
pub(super) fn render_line(
    (glyphs, colours): (Glyphs, Colours),
    line: &Line,
    area: Rect,
    buffer: &mut Buffer,
) {
    for span in &line.spans {
        let at = u16::try_from(span.at).unwrap_or(u16::MAX);
        let x = area.x.saturating_add(at);
        let space = area.right().saturating_sub(x);
        let text = shown(&span.text, glyphs);
        // A truncated number would be a different one.
        if span.role == TextRole::Figure && space < columns(&text) {
            continue;
        }
        print(
            buffer,
            x,
            area.y,
            space,
            &text,
            theme::part(role_style(span.role)),
        );
        if span.unproved != UnprovedDigits::Nothing {
            doubt(colours, span, x, area, buffer);
        }
    }
}

fn role_style(role: TextRole) -> ScreenPart {
    match role {
        TextRole::Title | TextRole::Part => ScreenPart::Title,
        TextRole::Section | TextRole::Name => ScreenPart::Name,
        TextRole::Head | TextRole::Label | TextRole::Aside => ScreenPart::Quiet,
        TextRole::Mark => ScreenPart::Key,
        TextRole::Body | TextRole::Figure => ScreenPart::Text,
    }
}
