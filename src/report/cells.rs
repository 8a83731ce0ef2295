//! Tables of cells that a spreadsheet or another program has written.

/// Rows of cells, and what stood between these.
pub(super) struct ReadCells {
    pub(super) rows: Vec<Vec<String>>,
    pub(super) separator: char,
}

/// Cells are not longer than this on average: a row of a thousand.
const MOST_CELLS: usize = 2_000_000;

impl ReadCells {
    /// Reads the rows of a table, cells between commas, semicolons or tabs, without the blanks around them; `None`
    /// where there are more rows than these. A row that is broken is left out.
    pub(super) fn read(bytes: &[u8], most_rows: usize) -> Option<ReadCells> {
        // Names of figures are ASCII in most scenes; a name of a student may be in any old encoding.
        let text = String::from_utf8_lossy(bytes);
        let text = text.trim_start_matches('\u{feff}');
        let separator = separator(text);
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(separator as u8)
            .from_reader(text.as_bytes());
        let mut rows = Vec::new();
        let mut cells = 0;
        for row in reader.records() {
            let Ok(row) = row else { continue };
            cells += row.len();
            if rows.len() >= most_rows || cells > MOST_CELLS {
                return None;
            }
            rows.push(row.iter().map(|cell| cell.trim().to_owned()).collect());
        }
        Some(ReadCells { rows, separator })
    }
}

/// What stands between the cells: what the first line that has any of them has most.
fn separator(text: &str) -> char {
    let first = text.lines().find(|line| line.contains([',', ';', '\t']));
    let count = |mark: char| first.map_or(0, |line| line.matches(mark).count());
    let marks = [',', ';', '\t'].map(|mark| (count(mark), mark));
    let most = marks
        .into_iter()
        .max_by_key(|(count, mark)| (*count, *mark != ','));
    match most {
        Some((1.., mark)) => mark,
        _ => ',',
    }
}
