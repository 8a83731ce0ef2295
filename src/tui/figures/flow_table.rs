//! Blocks of figures below one another, all columns of one width: what does not fit beside stands below.

use crate::tui::figures::format::Written;

/// A block of rows under one heading.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    /// What the rows are.
    pub(crate) title: &'static str,
    /// The columns: what they show, and its unit.
    pub(crate) heads: Vec<(&'static str, String)>,
    pub(crate) rows: Vec<Row>,
}

/// A row of a block.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// What it is about.
    pub(crate) name: String,
    /// The same with more to say, where there is room.
    pub(crate) more: String,
    /// Figures; `None` where the row has no such figure at all.
    pub(crate) cells: Vec<Option<Written>>,
}

/// A line as it is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Line {
    Blank,
    /// Names of columns, or their units.
    Head(String, Vec<Written>),
    /// A row's name and its figures.
    Row(String, Vec<Written>),
    /// A line of a sentence.
    Words(String),
}

/// Where the columns of all blocks stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Columns {
    /// Characters of the names.
    pub(crate) names: usize,
    /// Characters of a column, its gap included.
    pub(crate) figure: usize,
    /// Columns side by side.
    count: usize,
    /// Whether names say more.
    more: bool,
}

/// Room to spare widens columns, but not so far that rows fall apart.
const WIDEST_GAP: usize = 4;

impl Columns {
    /// For blocks with figures of this width, in so many characters.
    pub(crate) fn fitting(blocks: &[Block], figure: usize, width: usize) -> Columns {
        let heads = blocks.iter().flat_map(|block| &block.heads);
        let heads = heads.map(|(name, unit)| name.len().max(unit.chars().count()));
        let least = 1 + heads.fold(figure, usize::max);
        let most = blocks.iter().map(|block| block.heads.len()).max();
        let most = most.unwrap_or(0).max(1);
        let [short, long] = [false, true].map(|more| names_width(blocks, more));
        let more = long + most * least <= width;
        let names = if more { long } else { short };
        let count = (width.saturating_sub(names) / least).clamp(1, most);
        let spare = width.saturating_sub(names + count * least) / count;
        Columns {
            names,
            figure: least + spare.min(WIDEST_GAP - 1),
            count,
            more,
        }
    }

    /// The lines of all blocks.
    pub(crate) fn lines(&self, blocks: &[Block]) -> Vec<Line> {
        let mut lines = Vec::new();
        for block in blocks {
            let chunks = (0..block.heads.len()).step_by(self.count);
            for first in chunks {
                let chunk = self.chunk(block, first);
                if !lines.is_empty() && !chunk.is_empty() {
                    lines.push(Line::Blank);
                }
                lines.extend(chunk);
            }
        }
        lines
    }

    /// The columns from this one on that stand side by side; rows without any of their figures are left
    /// out.
    fn chunk(&self, block: &Block, first: usize) -> Vec<Line> {
        let last = (first + self.count).min(block.heads.len());
        let heads = &block.heads[first..last];
        let names = heads
            .iter()
            .map(|(name, _)| Written::sure((*name).to_owned()));
        let units = heads.iter().map(|(_, unit)| Written::sure(unit.clone()));
        let mut lines = vec![
            Line::Head(block.title.to_owned(), names.collect()),
            Line::Head(String::new(), units.collect()),
        ];
        let above = lines.len();
        for row in &block.rows {
            let cells = row.cells.iter().skip(first).take(last - first);
            if cells.clone().all(Option::is_none) {
                continue;
            }
            let nothing = || Written::sure(String::new());
            let cells = cells.map(|cell| cell.clone().unwrap_or_else(nothing));
            let name = if self.more { &row.more } else { &row.name };
            lines.push(Line::Row(name.clone(), cells.collect()));
        }
        if lines.len() == above {
            lines.clear();
        }
        lines
    }
}

fn names_width(blocks: &[Block], more: bool) -> usize {
    let name = |row: &Row| {
        if more {
            row.more.chars().count()
        } else {
            row.name.chars().count()
        }
    };
    let rows = blocks.iter().flat_map(|block| block.rows.iter().map(name));
    let titles = blocks.iter().map(|block| block.title.len());
    rows.chain(titles).max().unwrap_or(0)
}
