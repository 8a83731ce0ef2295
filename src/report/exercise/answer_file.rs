//! Writes empty answer files for students, with a row for each value, and reads the completed
//! files.

use super::row_names::{column_named, parted};
use crate::quantity::{Catalogue, known_unit, unit_factor};
use crate::report::text::cells::ReadCells;
use crate::report::text::csv_dialect::{CsvDialect, CsvSheet};
use crate::report::text::encoding::TextEncoding;
use crate::scene::Scene;
use crate::study::{AnswerKey, GivenAnswer, WrittenFigure};
use std::io::{self, Write};

/// The column headers, and the names of special rows. These must stay stable.
const HEADS: [&str; 3] = ["figure", "unit", "answer"];
const SHEET: &str = "sheet";
const STUDENT: &str = "student";
/// Maximum number of rows.
const MAX_ROWS: usize = 10_000;

/// Writes an empty answer file for a sheet of this name.
///
/// # Errors
/// Returns the errors of the output.
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
    for figure in key.figures.iter().take(key.required) {
        rows.record([figure.quantity.name.as_str(), &figure.quantity.unit, ""])?;
    }
    rows.finish()
}

/// Returns `true` if a file contains only rows of the empty answer file for this sheet, in any
/// dialect.
#[must_use]
pub fn is_blank(bytes: &[u8], key: &AnswerKey, sheet: &str) -> bool {
    let is_asked = |name: &str, unit: &str| {
        let mut figures = key.figures.iter();
        figures.any(|of| of.quantity.name == name && of.quantity.unit == unit)
    };
    // Compared without the empty cells at the end of a row.
    let is_ours = |row: &[&str]| match row {
        [] | [STUDENT] => true,
        [SHEET, "", name] => *name == sheet,
        [figure] => is_asked(figure, ""),
        [figure, unit] => is_asked(figure, unit),
        row => *row == HEADS,
    };
    // A file with too many rows is not an empty answer file.
    ReadCells::read(bytes, MAX_ROWS).is_some_and(|read| {
        read.rows.iter().all(|row| {
            let cells: Vec<&str> = row.iter().map(String::as_str).collect();
            let last = cells.iter().rposition(|cell| !cell.is_empty());
            is_ours(&cells[..last.map_or(0, |last| last + 1)])
        })
    })
}

/// A parsed answer file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AnswerFile {
    /// The name of the answered sheet.
    pub sheet: Option<String>,
    /// The name of the student.
    pub student: Option<String>,
    /// The rows with values and answers.
    pub answers: Vec<AnsweredRow>,
    /// The encoding of the text.
    pub encoding: TextEncoding,
}

/// A row of an answer file, as written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AnsweredRow {
    /// The line of the file, from 1.
    pub line: u64,
    /// The name of the value.
    pub figure: String,
    /// The unit of the answer.
    pub unit: String,
    /// The answer.
    pub answer: String,
}

/// A cell of the file that could not be interpreted, or a row whose name the scene does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InvalidCell {
    /// The line of the file, from 1.
    pub line: u64,
    /// The name in the row.
    pub figure: String,
    /// The text of the cell: a unit or an answer.
    pub text: String,
}

/// The positions of the cells to read in a row.
struct RowPlaces {
    figure: usize,
    unit: Option<usize>,
    answer: usize,
    /// The number of cells in the header row.
    width: usize,
    /// Whether cells are separated by commas, so that a decimal comma splits a number.
    is_parted: bool,
}

/// The reason why a file is not an answer file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoAnswers {
    /// The file has no row with a value.
    NoFigure,
    /// The file has too many rows.
    TooLong,
}

impl AnswerFile {
    /// Parses an answer file with cells separated by commas, semicolons or tabs, and rows in any
    /// order.
    ///
    /// # Errors
    /// Returns an error if it has no values, or too many rows.
    pub fn read(bytes: &[u8]) -> Result<AnswerFile, NoAnswers> {
        let ReadCells {
            rows,
            lines,
            separator,
            encoding,
        } = ReadCells::read(bytes, MAX_ROWS).ok_or(NoAnswers::TooLong)?;
        let mut file = AnswerFile {
            encoding,
            ..AnswerFile::default()
        };
        let places = RowPlaces::of(&rows, separator);
        for (row, line) in rows.iter().zip(lines) {
            file.take(row, line, &places);
        }
        match file.answers.iter().any(AnsweredRow::is_likely) {
            true => Ok(file),
            false => Err(NoAnswers::NoFigure),
        }
    }

    /// Replaces the names in the rows by the scene's column names, where known.
    #[must_use]
    pub fn of_scene(mut self, scene: &Scene) -> AnswerFile {
        let catalogue = Catalogue::new(scene);
        for row in &mut self.answers {
            if let Some(column) = column_named(&row.figure, &catalogue) {
                let (_, unit) = parted(&row.figure);
                if row.unit.is_empty() {
                    unit.clone_into(&mut row.unit);
                }
                row.figure = column;
            }
        }
        self
    }

    fn take(&mut self, cells: &[String], line: u64, places: &RowPlaces) {
        let cell = |index: usize| cells.get(index).map_or("", String::as_str);
        let name = cell(places.figure);
        let answer = places.answer_in(cells);
        let shown_text = || Some(answer.clone()).filter(|text| !text.is_empty());
        let is = |head: &str| name.eq_ignore_ascii_case(head);
        if is(SHEET) {
            self.sheet = shown_text();
        } else if is(STUDENT) {
            self.student = shown_text();
        } else if !(is(HEADS[0]) || name.is_empty() && answer.is_empty()) {
            self.answers.push(AnsweredRow {
                line,
                figure: name.to_owned(),
                unit: places.unit.map_or("", cell).to_owned(),
                answer,
            });
        }
    }

    /// Returns the names of all values.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let rows = self.answers.iter();
        rows.map(|row| row.figure.clone()).collect()
    }

    /// Returns the answers to the requested values, in their order; the last one of repeated
    /// answers counts.
    #[must_use]
    pub fn given(&self, key: &AnswerKey) -> Vec<(String, GivenAnswer)> {
        let quantities = key.figures.iter().map(|figure| &figure.quantity);
        let given = quantities.map(|quantity| match self.row(&quantity.name) {
            Some(row) => {
                let given = row.given(&quantity.unit);
                (row.written(&given), given)
            }
            None => (String::new(), GivenAnswer::Empty),
        });
        given.collect()
    }

    /// Returns unknown or unsuitable units, in their own cells or after the numbers.
    #[must_use]
    pub fn strange_units(&self, key: &AnswerKey) -> Vec<InvalidCell> {
        let quantities = key.figures.iter().map(|figure| &figure.quantity);
        let strange = quantities.filter_map(|quantity| {
            let row = self.row(&quantity.name)?;
            let unit = row.strange_unit(&quantity.unit)?;
            Some(row.strange(unit))
        });
        strange.collect()
    }

    /// Returns rows whose name is not a value of the key.
    #[must_use]
    pub fn strangers(&self, key: &AnswerKey) -> Vec<InvalidCell> {
        let is_known = |name: &str| key.figures.iter().any(|f| f.quantity.name == name);
        let strange = self.answers.iter().filter(|row| !is_known(&row.figure));
        strange.map(|row| row.strange(row.answer.clone())).collect()
    }

    /// Returns answers superseded by a later answer to the same value.
    #[must_use]
    pub fn repeated(&self) -> Vec<InvalidCell> {
        let answered = || self.answers.iter().filter(|row| !row.answer.is_empty());
        let is_repeated = |(number, row): &(usize, &AnsweredRow)| {
            let mut later = answered().skip(number + 1);
            later.any(|other| other.figure == row.figure)
        };
        let repeated = answered().enumerate().filter(is_repeated);
        repeated
            .map(|(_, row)| row.strange(row.answer.clone()))
            .collect()
    }

    /// Returns answers that are not numbers.
    #[must_use]
    pub fn unreadable(&self, key: &AnswerKey) -> Vec<InvalidCell> {
        let rows = key
            .figures
            .iter()
            .filter_map(|figure| self.row(&figure.quantity.name));
        let rows = rows.filter(|row| !row.answer.is_empty());
        let unreadable = rows.filter(|row| WrittenFigure::read(&row.answer).is_none());
        unreadable
            .map(|row| row.strange(row.answer.clone()))
            .collect()
    }

    /// Returns the row that counts for a value: the last one with an answer, or else the last one.
    fn row(&self, name: &str) -> Option<&AnsweredRow> {
        let rows = || self.answers.iter().rev().filter(|row| row.figure == name);
        rows().find(|row| !row.answer.is_empty()).or(rows().next())
    }
}

impl AnsweredRow {
    /// Returns `true` if the row may be that of a value: its name has a dot, or its answer a digit.
    fn is_likely(&self) -> bool {
        self.figure.contains('.') || self.answer.contains(|c: char| c.is_ascii_digit())
    }

    fn strange(&self, text: String) -> InvalidCell {
        InvalidCell {
            line: self.line,
            figure: self.figure.clone(),
            text,
        }
    }

    /// Returns the unit after the number or in its cell, if it is unknown or unsuitable.
    fn strange_unit(&self, unit: &str) -> Option<String> {
        let (_, after) = WrittenFigure::read(&self.answer)?;
        let written = [after, self.unit.clone()];
        let mut strange = written.into_iter().filter(|own| !own.is_empty());
        strange.find(|own| unit_factor(own, unit).is_none())
    }

    /// Returns the answer as written, with the unit of its cell if that is not the requested one.
    fn written(&self, given: &GivenAnswer) -> String {
        let has_unit =
            || WrittenFigure::read(&self.answer).is_some_and(|(_, after)| !after.is_empty());
        match given {
            GivenAnswer::Converted { .. } if !has_unit() => {
                format!("{} {}", self.answer, self.unit)
            }
            _ => self.answer.clone(),
        }
    }

    /// Returns the answer in the requested unit. A unit after the number takes precedence over the
    /// one in its cell. An unknown unit is ignored.
    fn given(&self, unit: &str) -> GivenAnswer {
        if self.answer.is_empty() {
            return GivenAnswer::Empty;
        }
        let Some((face, after)) = WrittenFigure::read(&self.answer) else {
            return GivenAnswer::Unreadable;
        };
        let factor = match unit_factor(&after, unit) {
            Some(factor) if !after.is_empty() => factor,
            // A known unit of another quantity makes the answer invalid.
            None if known_unit(&after).is_some() => return GivenAnswer::Unreadable,
            _ => unit_factor(&self.unit, unit).unwrap_or(1.0),
        };
        if factor == 1.0 {
            return GivenAnswer::Figure(face);
        }
        GivenAnswer::Converted {
            figure: face.times(factor),
            face,
        }
    }
}

impl RowPlaces {
    /// Finds the columns by the header row; without one, the third cell is the answer.
    fn of(rows: &[Vec<String>], separator: char) -> RowPlaces {
        let place = |row: &[String], head: &str| {
            let mut cells = row.iter();
            cells.position(|cell| cell.eq_ignore_ascii_case(head))
        };
        let [figure, unit, answer] = HEADS;
        let found = rows.iter().find_map(|row| {
            let (figure, answer) = (place(row, figure)?, place(row, answer)?);
            Some((figure, place(row, unit), answer, row.len()))
        });
        let usual = (0, Some(1), 2, HEADS.len());
        let (figure, unit, answer, width) = found.unwrap_or(usual);
        RowPlaces {
            figure,
            unit,
            answer,
            width,
            is_parted: separator == ',',
        }
    }

    /// Returns the answer. A decimal comma may have split it into two cells, so that the row has
    /// one cell more than the header.
    fn answer_in(&self, cells: &[String]) -> String {
        let cell = |index: usize| cells.get(index).map_or("", String::as_str);
        let (whole, decimals) = (cell(self.answer), cell(self.answer + 1));
        let are_digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        let sign = |c: char| matches!(c, '-' | '+' | '\u{2212}');
        let (fraction, power) = match decimals.split_once(['e', 'E']) {
            Some((fraction, power)) => (fraction, power.trim_start_matches(['-', '+'])),
            None => (decimals, "0"),
        };
        let is_parted = self.is_parted
            && cells.len() == self.width + 1
            && are_digits(whole.strip_prefix(sign).unwrap_or(whole))
            && are_digits(fraction)
            && are_digits(power);
        match is_parted {
            true => format!("{whole},{decimals}"),
            false => whole.to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(text: &str) -> AnswerFile {
        AnswerFile::read(text.as_bytes()).unwrap()
    }

    fn row(line: u64, figure: &str, unit: &str, answer: &str) -> AnsweredRow {
        AnsweredRow {
            line,
            figure: figure.into(),
            unit: unit.into(),
            answer: answer.into(),
        }
    }

    #[test]
    fn answer_files_of_any_spreadsheet_dialect_are_read() {
        let expected = AnswerFile {
            sheet: Some("a.toml".into()),
            student: Some("Ayşe Öz".into()),
            answers: vec![
                row(4, "r3.angle", "deg", "29,38"),
                row(5, "C.v", "mm/s", ""),
            ],
            encoding: TextEncoding::Utf8,
        };
        for text in [
            "figure,unit,answer\nsheet,,a.toml\nstudent,,Ayşe Öz\nr3.angle,deg,\"29,38\"\nC.v,mm/s,\n",
            "\u{feff}figure;unit;answer\r\nsheet;;a.toml\r\nstudent;;Ayşe Öz\r\nr3.angle;deg;29,38\r\nC.v;mm/s;\r\n",
            "figure\tunit\tanswer\nsheet\t\ta.toml\nstudent\t\tAyşe Öz\nr3.angle\tdeg\t 29,38\nC.v\tmm/s\n",
            "student,,Ayşe Öz\nsheet,,a.toml\n\nr3.angle,deg,29,38\nC.v,mm/s,,",
        ] {
            assert_eq!(read(text), expected, "{text}");
        }
        let old = AnswerFile::read(b"student;;Ay\xfee\nr3.angle;deg;1\n").unwrap();
        assert_eq!(old.student.as_deref(), Some("Ayşe"));
        assert_eq!(old.encoding, TextEncoding::Windows1254);
    }

    /// Cells are joined only if a decimal comma has split them.
    #[test]
    fn extra_column_is_not_joined_as_decimals() {
        let answer = |text: &str| read(text).answers[0].answer.clone();
        for (head, line, expected) in [
            ("figure,unit,answer,points", "r3.angle,deg,38.18,1", "38.18"),
            ("figure,unit,answer,points", "r3.angle,deg,38,1", "38"),
            ("figure,unit,answer,points", "r3.angle,deg,38,18,1", "38,18"),
            ("figure,unit,answer", "r3.angle,deg,38.18,1", "38.18"),
            ("figure,unit,answer", "r3.angle,deg,3e1,1", "3e1"),
            ("figure,unit,answer", "r3.angle,deg,38,1x", "38"),
            ("figure,unit,answer", "r3.angle,deg,-3,8e+1", "-3,8e+1"),
            ("figure,unit,answer", "r3.angle,deg,38,18,1", "38"),
        ] {
            assert_eq!(answer(&format!("{head}\n{line}\n")), expected, "{line}");
        }
    }

    /// The header row gives the column of the answers.
    #[test]
    fn columns_may_be_missing_or_reordered() {
        for (text, unit) in [
            ("figure,answer\nstudent,Ali\nr3.angle,29.38\n", ""),
            (
                "Answer,Figure,Unit\nAli,student,\n29.38,r3.angle,deg\n",
                "deg",
            ),
        ] {
            let file = read(text);
            assert_eq!(file.answers, [row(3, "r3.angle", unit, "29.38")], "{text}");
            assert_eq!(file.student.as_deref(), Some("Ali"));
        }
    }

    #[test]
    fn file_without_values_is_rejected() {
        for text in ["", "a,b,c\n", "<html></html>", "figure,unit,answer\n"] {
            let read = AnswerFile::read(text.as_bytes());
            assert_eq!(read, Err(NoAnswers::NoFigure), "{text}");
        }
        let long = "a.b,,1\n".repeat(MAX_ROWS + 1);
        assert_eq!(AnswerFile::read(long.as_bytes()), Err(NoAnswers::TooLong));
    }

    proptest! {
        #[test]
        fn reading_never_panics(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
            let _ = AnswerFile::read(&bytes);
        }
    }
}
