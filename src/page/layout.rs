//! Lays out a page line by line, at a given width.

use super::columns::ColumnLayout;
use super::line::{Line, Span, TextRole};
use super::table::{Cell, Rest, Row, Setting, Table, Units};
use super::terminal_text::shown;
use super::words::{MIN_WIDTH, broken, length, wrapped};
use super::{Block, Content, Facts, Page, TextStyle, formula, in_chunks};
use std::borrow::Cow;
use std::ops::Range;

/// A requested width of the names is limited to one part of the width in this many.
const NAME_SHARE: usize = 3;

impl Page {
    /// Returns the lines for a screen; a column that does not fit even alone is cut off.
    #[must_use]
    pub fn lines(&self, style: TextStyle) -> Vec<Line> {
        self.layout(style, Medium::Screen)
    }

    /// Returns the lines for a medium.
    pub(super) fn layout(&self, style: TextStyle, medium: Medium) -> Vec<Line> {
        let TextStyle { ascii, width } = style;
        let space = PageSize { width, medium };
        let names = self.is_aligned.then(|| self.shown(ascii).names(space));
        let lines = |blocks: &[Block]| -> Vec<Line> {
            let mut lines = Vec::new();
            for block in blocks {
                let below = block.content.lines(names, space, ascii);
                if block.is_apart && !below.is_empty() {
                    lines.push(Line::default());
                }
                lines.extend(below);
            }
            lines
        };
        in_chunks(&self.blocks, lines).concat()
    }

    /// Returns the common name column of all tables and facts.
    fn names(&self, space: PageSize) -> NameColumn {
        let contents = || self.blocks.iter().map(|block| &block.content);
        let tables = || {
            contents().filter_map(|content| match content {
                Content::Table(table) => Some(table),
                _ => None,
            })
        };
        let widest = |more: bool| {
            let widths = contents().map(|content| match content {
                Content::Table(table) => table.names(more, space),
                Content::Facts(facts) => facts.names(space.width).saturating_sub(1),
                _ => 0,
            });
            widths.max().unwrap_or(0)
        };
        let long = widest(true);
        let more = tables().all(|table| table.fits_beside_names(long, space));
        let names = if more { long } else { widest(false) };
        let spread = tables().map(|table| {
            let columns = table.columns(names, usize::MAX, space);
            columns.spread(&table.setting)
        });
        NameColumn {
            more,
            width: names,
            spread: spread.min().unwrap_or(0),
        }
    }
}

/// The medium that a page is laid out for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Medium {
    /// Paper: all text is kept, and a line may be too long.
    Paper,
    /// A screen: text that does not fit is cut off, or left out if a part of it would be
    /// misleading.
    Screen,
}

/// The available width and the medium.
#[derive(Clone, Copy, Debug)]
struct PageSize {
    width: usize,
    medium: Medium,
}

/// The width of the name column, whether long names are used, and the maximum additional spacing of
/// the columns.
#[derive(Clone, Copy, Debug)]
struct NameColumn {
    width: usize,
    more: bool,
    spread: usize,
}

impl Content {
    /// Returns the lines with every text as displayed.
    fn lines(&self, names: Option<NameColumn>, space: PageSize, ascii: bool) -> Vec<Line> {
        let width = space.width;
        // The texts of formulas are converted as they are written.
        let content = match self {
            Content::Equations(_) => Cow::Borrowed(self),
            _ => Cow::Owned(self.shown(ascii)),
        };
        let of = |role, text: &str| {
            let lines = broken(text, width).into_iter();
            lines.map(|line| Line::of(role, line)).collect()
        };
        match &*content {
            Content::Title(title) => of(TextRole::Title, title),
            Content::Heading(1, text) => of(TextRole::Part, text),
            Content::Heading(_, text) => of(TextRole::Section, text),
            Content::Text(text) => of(TextRole::Body, text),
            Content::Equations(equations) => {
                let shown = |text: &str| shown(text, ascii);
                let lines = equations.iter();
                let lines = lines.flat_map(|e| formula::lines(&e.sides, width, &shown));
                lines.map(|line| Line::of(TextRole::Body, line)).collect()
            }
            Content::Facts(facts) => facts.lines(names, width),
            Content::Table(table) => {
                let mut lines = table.lines(names, space);
                if space.medium == Medium::Screen {
                    lines
                        .iter_mut()
                        .for_each(|line| line.cut(width.max(MIN_WIDTH)));
                }
                lines
            }
            Content::Characters(lines) => {
                let lines = lines.iter().cloned();
                lines.map(|line| Line::of(TextRole::Body, line)).collect()
            }
            Content::Picture(picture) => {
                let caption = broken(picture.character_caption(), width).into_iter();
                let caption = caption.map(|line| Line::of(TextRole::Body, line));
                let drawn = picture.characters.iter();
                let drawn = drawn.map(|line| Line::of(TextRole::Body, line.as_str()));
                caption.chain(drawn).collect()
            }
        }
    }
}

/// Limits a requested width to a fixed share of the available width.
fn limited_width(requested: usize, width: usize) -> usize {
    requested.min(width / NAME_SHARE)
}

impl Facts {
    /// Returns the width of the names, with the blanks behind them.
    fn names(&self, width: usize) -> usize {
        let names = self.list.iter().map(|(name, _)| length(name) + 1);
        names
            .chain([limited_width(self.names, width)])
            .max()
            .unwrap_or(0)
    }

    fn lines(&self, names: Option<NameColumn>, width: usize) -> Vec<Line> {
        let names = names.map_or_else(|| self.names(width), |names| names.width + 1);
        let space = width.saturating_sub(names + self.hanging_indent);
        let mut lines = Vec::new();
        for (name, text) in &self.list {
            let mut name = name.as_str();
            for text in text {
                let words = wrapped(text, space.max(MIN_WIDTH));
                for (number, words) in words.into_iter().enumerate() {
                    let label = std::mem::take(&mut name);
                    let start = label.len() - label.trim_start_matches(' ').len();
                    let mut line = Line::default();
                    line.push(start, label.trim(), TextRole::Label);
                    let hanging = if number == 0 { 0 } else { self.hanging_indent };
                    line.push(names + hanging, words, TextRole::Body);
                    lines.push(line);
                }
            }
        }
        lines
    }
}

impl Table {
    /// Returns the longest mark. The title of the rows is aligned with the names behind it.
    fn mark(&self) -> &str {
        let marks = self.rows.iter().map(|row| row.label(false).0);
        marks.max_by_key(|mark| length(mark)).unwrap_or("")
    }

    /// Returns the width of the names.
    fn names(&self, more: bool, space: PageSize) -> usize {
        let rows = self.rows.iter().filter(|row| !matches!(row, Row::Part(_)));
        let names = rows.map(|row| {
            let (mark, name) = row.label(more);
            self.setting.with_mark(mark) + length(name)
        });
        let requested = limited_width(self.setting.names, space.width);
        let names = names.chain([
            requested,
            self.setting.with_mark(self.mark()) + length(&self.title),
        ]);
        let names = names.max().unwrap_or(0);
        match space.medium {
            Medium::Paper => names,
            Medium::Screen => names.min(self.max_name_width(space.width)),
        }
    }

    /// Returns the maximum width of the names that leaves enough space for the widest column.
    fn max_name_width(&self, width: usize) -> usize {
        let widest = self.widths().into_iter().max().unwrap_or(0);
        let column = self.setting.indent + self.setting.gap + widest;
        width.saturating_sub(column).max(width / NAME_SHARE)
    }

    /// Returns the width of each column.
    fn widths(&self) -> Vec<usize> {
        let minimum = &self.setting.least;
        let head = |column: usize| {
            let head = &self.heads[column];
            match self.setting.units {
                Units::Behind => length(&head.one_line()),
                Units::Below => length(&head.name).max(length(&head.unit)),
            }
        };
        let cells = |column: usize| {
            let rows = self.rows.iter().filter_map(move |row| match row {
                Row::Figures { cells, .. } => cells.get(column)?.as_ref(),
                Row::Part(_) | Row::Told { .. } => None,
            });
            rows.map(|cell| length(&cell.text)).max().unwrap_or(0)
        };
        let requested =
            |column: usize| minimum.get(column).or(minimum.last()).copied().unwrap_or(0);
        let columns = 0..self.heads.len();
        columns
            .map(|column| head(column).max(cells(column)).max(requested(column)))
            .collect()
    }

    fn columns(&self, names: usize, spread: usize, space: PageSize) -> ColumnLayout {
        let setting = Setting {
            spread: self.setting.spread.min(spread),
            // On paper, all columns fit below one another.
            rest: match space.medium {
                Medium::Paper => Rest::Below,
                Medium::Screen => self.setting.rest,
            },
            ..self.setting.clone()
        };
        ColumnLayout::fit(&setting, names, self.widths(), |_| true, space.width)
    }

    /// Returns `true` if all columns fit next to names of this width.
    fn fits_beside_names(&self, names: usize, space: PageSize) -> bool {
        self.columns(names, 0, space).fits_in_one_row(space.width)
    }

    fn lines(&self, names: Option<NameColumn>, space: PageSize) -> Vec<Line> {
        let names = names.unwrap_or_else(|| {
            let long = self.names(true, space);
            let more = self.fits_beside_names(long, space);
            NameColumn {
                width: if more { long } else { self.names(false, space) },
                more,
                spread: usize::MAX,
            }
        });
        let columns = self.columns(names.width, names.spread, space);
        let mut lines = Vec::new();
        for chunk in columns.ranges() {
            let rows = self.rows_of(&columns, chunk, names, space.width);
            if rows.is_empty() && !self.rows.is_empty() {
                continue;
            }
            if !lines.is_empty() {
                lines.push(Line::default());
            }
            lines.extend(self.head_of(&columns, chunk));
            lines.extend(rows);
        }
        lines
    }

    fn head_of(&self, columns: &ColumnLayout, chunk: &Range<usize>) -> Vec<Line> {
        let headers = &self.heads[chunk.clone()];
        let mark = " ".repeat(length(self.mark()));
        let line = |title: &str, texts: Vec<String>| {
            let cells: Vec<Cell> = texts.into_iter().map(Cell::proved).collect();
            let name = (mark.as_str(), title);
            columns.line(chunk, name, cells.iter().map(Some), [TextRole::Head; 2])
        };
        let title = self.title.as_str();
        match self.setting.units {
            Units::Behind => vec![line(
                title,
                headers.iter().map(super::Head::one_line).collect(),
            )],
            Units::Below => vec![
                line(
                    title,
                    headers.iter().map(|head| head.name.clone()).collect(),
                ),
                line("", headers.iter().map(|head| head.unit.clone()).collect()),
            ],
        }
    }

    /// Returns the rows with cells in a chunk; empty if there are only names.
    fn rows_of(
        &self,
        columns: &ColumnLayout,
        chunk: &Range<usize>,
        names: NameColumn,
        width: usize,
    ) -> Vec<Line> {
        let mut lines = Vec::new();
        let mut text = false;
        for row in &self.rows {
            let (mark, name) = row.label(names.more);
            match row {
                Row::Part(_) => {
                    let mut line = Line::default();
                    line.push(self.setting.indent, name, TextRole::Section);
                    lines.push(line);
                }
                Row::Told { words, .. } if chunk.start == 0 => {
                    let head = columns.line(
                        chunk,
                        (mark, name),
                        [],
                        [self.setting.called, TextRole::Body],
                    );
                    lines.extend(place_words(
                        head,
                        columns.names(),
                        words,
                        (mark, &self.setting),
                        width,
                    ));
                    text = true;
                }
                Row::Told { .. } => {}
                Row::Figures { cells, .. } => {
                    let cells = || cells.iter().take(chunk.end).skip(chunk.start);
                    if cells().any(Option::is_some) {
                        let cells = cells().map(Option::as_ref);
                        let roles = [self.setting.called, TextRole::Figure];
                        lines.push(columns.line(chunk, (mark, name), cells, roles));
                        text = true;
                    }
                }
            }
        }
        if text { lines } else { Vec::new() }
    }
}

/// Places words next to the name of a row or, if they do not fit, below it.
fn place_words(
    mut head: Line,
    names: usize,
    words: &str,
    (mark, setting): (&str, &Setting),
    width: usize,
) -> Vec<Line> {
    let start = names + setting.gap;
    let nearby = format!("- {words}");
    if start + length(&nearby) <= width {
        head.push(start, nearby, TextRole::Body);
        return vec![head];
    }
    let indent = setting.indent + setting.with_mark(mark);
    let below = wrapped(words, width.saturating_sub(indent).max(MIN_WIDTH));
    let below = below.into_iter().map(|words| {
        let mut line = Line::default();
        line.push(indent, words, TextRole::Aside);
        line
    });
    std::iter::once(head).chain(below).collect()
}

impl Line {
    /// Cuts the line off at this width. Values are left out, because a part of one would be a
    /// different value.
    fn cut(&mut self, maximum: usize) {
        let is_whole = |span: &Span| span.at + length(&span.text) <= maximum;
        self.spans
            .retain(|span| span.at < maximum && (span.role != TextRole::Figure || is_whole(span)));
        for span in &mut self.spans {
            let space = maximum - span.at;
            if length(&span.text) > space {
                span.text = span.text.chars().take(space).collect();
            }
        }
    }
}
