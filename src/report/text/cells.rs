//! Parses tables of cells written by a spreadsheet or another program.

use crate::report::text::encoding::{TextEncoding, decoded};

/// Rows of cells, with the separator and the encoding of the file.
pub(in crate::report) struct ReadCells {
    pub(in crate::report) rows: Vec<Vec<String>>,
    /// The line of the file on which each row begins, from 1.
    pub(in crate::report) lines: Vec<u64>,
    pub(in crate::report) separator: char,
    pub(in crate::report) encoding: TextEncoding,
}

/// Maximum number of cells.
const MAX_CELLS: usize = 2_000_000;

impl ReadCells {
    /// Parses the rows of a table with cells separated by commas, semicolons or tabs; blanks around
    /// cells are removed. Returns `None` if there are more than `most_rows` rows. Malformed rows
    /// are skipped, and UTF-16 is recognized by its byte order mark.
    pub(in crate::report) fn read(bytes: &[u8], most_rows: usize) -> Option<ReadCells> {
        let (text, encoding) = decoded(bytes);
        let text = text.trim_start_matches('\u{feff}');
        let separator = separator(text);
        let (rows, lines) = rows(text, separator, most_rows)?;
        let is_unbalanced = rows.iter().flatten().any(|cell| cell.contains('\n'));
        // A surplus quote would swallow the following lines; then each line is parsed separately.
        let (rows, lines) = match is_unbalanced {
            false => (rows, lines),
            true => {
                let (mut all, mut lines) = (Vec::new(), Vec::new());
                for (line, number) in text.lines().zip(1..) {
                    let (rows, _) = self::rows(line, separator, 1)?;
                    lines.extend(rows.iter().map(|_| number));
                    all.extend(rows);
                }
                (all.len() <= most_rows).then_some((all, lines))?
            }
        };
        Some(ReadCells {
            rows,
            lines,
            separator,
            encoding,
        })
    }
}

/// Parses rows of cells, with the line on which each begins; returns `None` for more than `maximum`
/// rows, or too many cells.
fn rows(text: &str, separator: char, maximum: usize) -> Option<(Vec<Vec<String>>, Vec<u64>)> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(separator as u8)
        .from_reader(text.as_bytes());
    let (mut rows, mut lines) = (Vec::new(), Vec::new());
    let mut cells = 0;
    for row in reader.records() {
        let Ok(row) = row else { continue };
        cells += row.len();
        if rows.len() >= maximum || cells > MAX_CELLS {
            return None;
        }
        lines.push(row.position().map_or(0, |start| line_of(text, start)));
        rows.push(row.iter().map(|cell| cell.trim().to_owned()).collect());
    }
    Some((rows, lines))
}

/// Returns the line of a row. The csv reader counts preceding empty lines as part of a row.
fn line_of(text: &str, start: &csv::Position) -> u64 {
    let from = usize::try_from(start.byte()).ok();
    let rest = from.and_then(|from| text.get(from..)).unwrap_or("");
    let empty = rest.chars().take_while(|c| matches!(c, '\r' | '\n'));
    (start.line()..)
        .zip(empty.filter(|c| *c == '\n'))
        .last()
        .map_or(start.line(), |(line, _)| line + 1)
}

/// Returns the separator: the most frequent of the marks in the first line that has any.
fn separator(text: &str) -> char {
    let first = text.lines().find(|line| line.contains([',', ';', '\t']));
    let count = |mark: char| first.map_or(0, |line| line.matches(mark).count());
    let marks = [',', ';', '\t'].map(|mark| (count(mark), mark));
    let maximum = marks
        .into_iter()
        .max_by_key(|(count, mark)| (*count, *mark != ','));
    match maximum {
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
    fn unmatched_quote_does_not_swallow_lines() {
        let rows = read(b"a,b,\"c\nd,e,\"1,5\"\ng,h,i\n");
        assert_eq!(rows, [["a", "b", "c"], ["d", "e", "1,5"], ["g", "h", "i"]]);
        for text in ["a,b\n\n\n\"c\",d\ne,f\n", "a,b\r\n\r\n\r\nc,d\r\ne,f"] {
            let lines = ReadCells::read(text.as_bytes(), 10).unwrap().lines;
            assert_eq!(lines, [1, 4, 5], "{text:?}");
        }
        assert!(ReadCells::read(b"a,\"b\nc\nd\n", 2).is_none());
    }

    #[test]
    fn utf16_is_decoded() {
        let text = "\u{feff}student;Ay\u{15f}e\r\nr3.angle;1,5\r\n";
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        for bytes in [&little[..], &big[..], &little[..little.len() - 1]] {
            let rows = read(bytes);
            assert_eq!(rows, [["student", "Ay\u{15f}e"], ["r3.angle", "1,5"]]);
        }
    }
}
