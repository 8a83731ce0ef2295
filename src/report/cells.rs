//! Tables of cells that a spreadsheet or another program has written.

use std::borrow::Cow;

/// Rows of cells, and what stood between these.
pub(super) struct ReadCells {
    pub(super) rows: Vec<Vec<String>>,
    pub(super) separator: char,
}

/// Cells are not longer than this on average: a row of a thousand.
const MOST_CELLS: usize = 2_000_000;

impl ReadCells {
    /// Reads the rows of a table, cells between commas, semicolons or tabs, without the blanks around them; `None`
    /// where there are more rows than these. A row that is broken is left out, and UTF-16 is read where it says so.
    pub(super) fn read(bytes: &[u8], most_rows: usize) -> Option<ReadCells> {
        let text = decoded(bytes);
        let text = text.trim_start_matches('\u{feff}');
        let separator = separator(text);
        let rows = rows(text, separator, most_rows)?;
        let is_unbalanced = rows.iter().flatten().any(|cell| cell.contains('\n'));
        // One quote too many would swallow the lines behind it: then each line stands for itself.
        let rows = match is_unbalanced {
            false => rows,
            true => {
                let mut all = Vec::new();
                for line in text.lines() {
                    all.extend(self::rows(line, separator, 1)?);
                }
                (all.len() <= most_rows).then_some(all)?
            }
        };
        Some(ReadCells { rows, separator })
    }
}

/// The text of a file. Names of figures are ASCII in most scenes; a name of a student may be in any old encoding.
fn decoded(bytes: &[u8]) -> Cow<'_, str> {
    let unit: fn([u8; 2]) -> u16 = match bytes {
        [0xff, 0xfe, ..] => u16::from_le_bytes,
        [0xfe, 0xff, ..] => u16::from_be_bytes,
        _ => return String::from_utf8_lossy(bytes),
    };
    let (pairs, _) = bytes.as_chunks();
    let units: Vec<u16> = pairs.iter().map(|pair| unit(*pair)).collect();
    String::from_utf16_lossy(&units).into()
}

fn rows(text: &str, separator: char, most: usize) -> Option<Vec<Vec<String>>> {
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
        if rows.len() >= most || cells > MOST_CELLS {
            return None;
        }
        rows.push(row.iter().map(|cell| cell.trim().to_owned()).collect());
    }
    Some(rows)
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

#[cfg(test)]
mod tests {
    use super::*;

    fn read(bytes: &[u8]) -> Vec<Vec<String>> {
        ReadCells::read(bytes, 10).unwrap().rows
    }

    #[test]
    fn a_quote_too_many_swallows_no_line() {
        let rows = read(b"a,b,\"c\nd,e,\"1,5\"\ng,h,i\n");
        assert_eq!(rows, [["a", "b", "c"], ["d", "e", "1,5"], ["g", "h", "i"]]);
        assert!(ReadCells::read(b"a,\"b\nc\nd\n", 2).is_none());
    }

    #[test]
    fn utf_16_is_read() {
        let text = "\u{feff}student;Ay\u{15f}e\r\nr3.angle;1,5\r\n";
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        for bytes in [&little[..], &big[..], &little[..little.len() - 1]] {
            let rows = read(bytes);
            assert_eq!(rows, [["student", "Ay\u{15f}e"], ["r3.angle", "1,5"]]);
        }
    }
}
