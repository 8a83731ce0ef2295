//! Verifies the rows of a file that a study resumes: computes rows again and compares their bytes.

use super::ReadyStudy;
use crate::cli::failure::Failure;
use crate::report::DesignTable;
use crate::wording::words;
use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::ops::Range;
use std::path::Path;

/// Maximum number of rows to compute again. A longer file is checked in evenly distributed
/// blocks.
const CHECKED: u64 = 10_000;
const BLOCK: u64 = 100;

/// The reason why rows are rejected.
enum Rejected {
    /// The row with this number differs from the study's.
    Changed(u64),
    /// The file cannot be read.
    Unreadable(io::Error),
}

/// Verifies the rows of a file whose first row is that of the design `first`.
///
/// # Errors
/// Returns an error if a row differs from the study's or the file cannot be read.
pub(super) fn verify(
    ready: &ReadyStudy,
    table: &DesignTable,
    first: u64,
    path: &Path,
    rows: u64,
) -> Result<(), Failure> {
    let shown = path.display().to_string();
    checked(ready, table, first, path, rows).map_err(|why| match why {
        Rejected::Changed(row) => Failure::Cannot(words().row_was_changed(&shown, row + 2)),
        Rejected::Unreadable(error) => Failure::Output(Some(path.to_owned()), error),
    })
}

fn checked(
    ready: &ReadyStudy,
    table: &DesignTable,
    first: u64,
    path: &Path,
    rows: u64,
) -> Result<(), Rejected> {
    let file = File::open(path).map_err(Rejected::Unreadable)?;
    let mut lines = BufReader::new(file);
    let mut line = String::new();
    let mut next = |line: &mut String| {
        line.clear();
        lines.read_line(line).map_err(Rejected::Unreadable)
    };
    next(&mut line)?;
    let mut number = 0;
    for block in blocks(rows) {
        while number < block.start {
            next(&mut line)?;
            number += 1;
        }
        let run = ready.run(first + block.start..first + block.end);
        run.each(&mut |some| {
            for row in some {
                next(&mut line)?;
                if table.line(&row, false) != line {
                    return Err(Rejected::Changed(number));
                }
                number += 1;
            }
            Ok(())
        })?;
    }
    Ok(())
}

/// Returns the ranges of rows to compute again.
fn blocks(rows: u64) -> Vec<Range<u64>> {
    if rows <= CHECKED {
        return std::iter::once(0..rows).collect();
    }
    let count = CHECKED / BLOCK;
    let start = |i: u64| i * (rows - BLOCK) / (count - 1);
    (0..count).map(|i| start(i)..start(i) + BLOCK).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_cover_few_rows_and_are_spread_over_many() {
        assert_eq!(
            blocks(CHECKED),
            std::iter::once(0..CHECKED).collect::<Vec<_>>()
        );
        let found = blocks(1_000_000);
        assert_eq!((found[0].start, found[found.len() - 1].end), (0, 1_000_000));
        assert!(found.windows(2).all(|pair| pair[0].end <= pair[1].start));
        assert_eq!(
            found
                .iter()
                .map(|block| block.end - block.start)
                .sum::<u64>(),
            CHECKED
        );
    }
}
