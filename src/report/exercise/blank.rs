//! The file that a student answers in: a row for each figure, written empty and read filled.

use crate::report::cells::ReadCells;
use crate::report::csv_dialect::{CsvDialect, CsvSheet};
use crate::study::{AnswerKey, GivenAnswer, WrittenFigure};
use std::io::{self, Write};

/// The heads of the columns, and the rows that are no figures: promises.
const HEADS: [&str; 3] = ["figure", "unit", "answer"];
const SHEET: &str = "sheet";
const STUDENT: &str = "student";
/// Rows that are read.
const MOST_ROWS: usize = 10_000;

/// Writes an empty file of answers to a sheet of this name.
///
/// # Errors
/// What the output says.
pub fn blank_answers(
    key: &AnswerKey,
    sheet: &str,
    dialect: CsvDialect,
    to: &mut dyn Write,
) -> io::Result<()> {
    let mut rows = CsvSheet::new(dialect, to);
    rows.record(HEADS)?;
    rows.record([SHEET, "", sheet])?;
    rows.record([STUDENT, "", ""])?;
    for figure in &key.figures {
        rows.record([figure.quantity.name.as_str(), &figure.quantity.unit, ""])?;
    }
    rows.finish()
}

/// Whether a file holds no more than an empty file of answers to this sheet does, in any dialect: no row of it is
/// another than those that were handed out.
#[must_use]
pub fn is_blank(bytes: &[u8], key: &AnswerKey, sheet: &str) -> bool {
    let is_asked = |name: &str, unit: &str| {
        let mut figures = key.figures.iter();
        figures.any(|of| of.quantity.name == name && of.quantity.unit == unit)
    };
    // Rows come without the empty cells at their end.
    let is_ours = |row: &[&str]| match row {
        [] | [STUDENT] => true,
        [SHEET, "", name] => *name == sheet,
        [figure] => is_asked(figure, ""),
        [figure, unit] => is_asked(figure, unit),
        row => *row == HEADS,
    };
    // What has too many rows to be read is not ours either.
    ReadCells::read(bytes, MOST_ROWS).is_some_and(|read| {
        read.rows.iter().all(|row| {
            let cells: Vec<&str> = row.iter().map(String::as_str).collect();
            let last = cells.iter().rposition(|cell| !cell.is_empty());
            is_ours(&cells[..last.map_or(0, |last| last + 1)])
        })
    })
}

/// A file of answers as it was read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AnswerFile {
    /// The name of the sheet that is answered.
    pub sheet: Option<String>,
    /// Who answers.
    pub student: Option<String>,
    /// The names of figures, and what stands beside them.
    pub answers: Vec<(String, String)>,
}

/// Why a file is no file of answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoAnswers {
    /// It has no row of a figure.
    NoFigure,
    /// It has too many rows.
    TooLong,
}

impl AnswerFile {
    /// Reads a file of answers: cells between commas, semicolons or tabs, in any order of rows.
    ///
    /// # Errors
    /// Where it holds no figure at all, or too many rows.
    pub fn read(bytes: &[u8]) -> Result<AnswerFile, NoAnswers> {
        let ReadCells { rows, separator } =
            ReadCells::read(bytes, MOST_ROWS).ok_or(NoAnswers::TooLong)?;
        let mut file = AnswerFile::default();
        for row in &rows {
            let cells: Vec<&str> = row.iter().map(String::as_str).collect();
            file.take(&cells, separator);
        }
        match file.answers.is_empty() {
            true => Err(NoAnswers::NoFigure),
            false => Ok(file),
        }
    }

    fn take(&mut self, cells: &[&str], separator: char) {
        let Some(&name) = cells.first().filter(|name| !name.is_empty()) else {
            return;
        };
        let answer = answer(cells, separator);
        let told = || Some(answer.clone()).filter(|text| !text.is_empty());
        match name {
            SHEET => self.sheet = told(),
            STUDENT => self.student = told(),
            // Names of figures have a point.
            name if name.contains('.') => self.answers.push((name.to_owned(), answer)),
            _ => {}
        }
    }

    /// The names of all figures.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.answers.iter().map(|(name, _)| name.clone()).collect()
    }

    /// The answers to what is asked for, in its order; of a figure that stands there twice the last.
    #[must_use]
    pub fn given(&self, key: &AnswerKey) -> Vec<(String, GivenAnswer)> {
        let of = |name: &str| {
            let mut all = self.answers.iter().rev();
            all.find(|(own, _)| own == name)
                .map_or("", |(_, text)| text)
        };
        let figures = key.figures.iter();
        let given = figures.map(|figure| {
            let text = of(&figure.quantity.name);
            let answer = match WrittenFigure::read(text, &figure.quantity.unit) {
                _ if text.is_empty() => GivenAnswer::Empty,
                Some(written) => GivenAnswer::Figure(written),
                None => GivenAnswer::Unreadable,
            };
            (text.to_owned(), answer)
        });
        given.collect()
    }
}

/// The cell of the answer. Where cells stand between commas, a decimal comma has parted it.
fn answer(cells: &[&str], separator: char) -> String {
    let answer = cells.get(2).copied().unwrap_or_default();
    let decimals = cells.get(3).copied().unwrap_or_default();
    let are_digits = !decimals.is_empty() && decimals.chars().all(|c| c.is_ascii_digit());
    if separator == ',' && are_digits && !answer.is_empty() {
        format!("{answer},{decimals}")
    } else {
        answer.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(text: &str) -> AnswerFile {
        AnswerFile::read(text.as_bytes()).unwrap()
    }

    #[test]
    fn spreadsheets_write_as_they_like() {
        let expected = AnswerFile {
            sheet: Some("a.toml".into()),
            student: Some("Ayşe Öz".into()),
            answers: vec![
                ("r3.angle".into(), "29,38".into()),
                ("C.v".into(), "".into()),
            ],
        };
        for text in [
            "figure,unit,answer\nsheet,,a.toml\nstudent,,Ayşe Öz\nr3.angle,deg,\"29,38\"\nC.v,mm/s,\n",
            "\u{feff}figure;unit;answer\r\nsheet;;a.toml\r\nstudent;;Ayşe Öz\r\nr3.angle;deg;29,38\r\nC.v;mm/s;\r\n",
            "figure\tunit\tanswer\nsheet\t\ta.toml\nstudent\t\tAyşe Öz\nr3.angle\tdeg\t 29,38\nC.v\n",
            "student,,Ayşe Öz\nr3.angle,deg,29,38\nC.v,mm/s,,\nsheet,,a.toml",
        ] {
            assert_eq!(read(text), expected, "{text}");
        }
        let old = AnswerFile::read(b"student;;Ay\xfee\nr3.angle;deg;1\n").unwrap();
        assert_eq!(old.student.as_deref(), Some("Ay\u{fffd}e"));
    }

    #[test]
    fn what_holds_no_figure_is_no_file_of_answers() {
        for text in ["", "a,b,c\n", "<html></html>", "figure,unit,answer\n"] {
            let read = AnswerFile::read(text.as_bytes());
            assert_eq!(read, Err(NoAnswers::NoFigure), "{text}");
        }
        let long = "a.b,,1\n".repeat(MOST_ROWS + 1);
        assert_eq!(AnswerFile::read(long.as_bytes()), Err(NoAnswers::TooLong));
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
            let _ = AnswerFile::read(&bytes);
        }
    }
}
