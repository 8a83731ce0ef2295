//! The file that a student answers in: a row for each figure, written empty and read filled.

use crate::quantity::unit_factor;
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
    for figure in key.figures.iter().take(key.asked) {
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
    /// The figures, and what stands beside them.
    pub answers: Vec<AnsweredRow>,
}

/// A row of a file of answers, as it was written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AnsweredRow {
    /// The name of a figure.
    pub figure: String,
    /// Its unit.
    pub unit: String,
    /// The answer.
    pub answer: String,
}

/// Which cells of a row are read.
struct RowPlaces {
    figure: usize,
    unit: Option<usize>,
    answer: usize,
    /// The cells of the head row.
    width: usize,
    /// Where cells stand between commas, a decimal comma parts a number.
    is_parted: bool,
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
        let ReadCells {
            rows, separator, ..
        } = ReadCells::read(bytes, MOST_ROWS).ok_or(NoAnswers::TooLong)?;
        let mut file = AnswerFile::default();
        let places = RowPlaces::of(&rows, separator);
        for row in &rows {
            file.take(row, &places);
        }
        match file.answers.is_empty() {
            true => Err(NoAnswers::NoFigure),
            false => Ok(file),
        }
    }

    fn take(&mut self, cells: &[String], places: &RowPlaces) {
        let cell = |place: usize| cells.get(place).map_or("", String::as_str);
        let name = cell(places.figure);
        let answer = places.answer_in(cells);
        let told = || Some(answer.clone()).filter(|text| !text.is_empty());
        match name {
            SHEET => self.sheet = told(),
            STUDENT => self.student = told(),
            // Names of figures have a point.
            name if name.contains('.') => self.answers.push(AnsweredRow {
                figure: name.to_owned(),
                unit: places.unit.map_or("", cell).to_owned(),
                answer,
            }),
            _ => {}
        }
    }

    /// The names of all figures.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let rows = self.answers.iter();
        rows.map(|row| row.figure.clone()).collect()
    }

    /// The answers to what is asked for, in its order; of a figure that stands there twice the last.
    #[must_use]
    pub fn given(&self, key: &AnswerKey) -> Vec<(String, GivenAnswer)> {
        let figures = key.figures.iter().map(|figure| &figure.quantity);
        let given = figures.map(|quantity| match self.row(&quantity.name) {
            Some(row) => (row.answer.clone(), row.given(&quantity.unit)),
            None => (String::new(), GivenAnswer::Empty),
        });
        given.collect()
    }

    /// Figures whose row says a unit that is not known, or measures something else, and that unit.
    #[must_use]
    pub fn strange_units(&self, key: &AnswerKey) -> Vec<(String, String)> {
        let figures = key.figures.iter().map(|figure| &figure.quantity);
        let strange = figures.filter_map(|quantity| {
            let row = self.row(&quantity.name)?;
            let is_strange =
                !row.answer.is_empty() && unit_factor(&row.unit, &quantity.unit).is_none();
            is_strange.then(|| (row.figure.clone(), row.unit.clone()))
        });
        strange.collect()
    }

    fn row(&self, name: &str) -> Option<&AnsweredRow> {
        self.answers.iter().rev().find(|row| row.figure == name)
    }
}

impl AnsweredRow {
    /// The answer in the unit that is asked for. A unit behind the number is meant; else the one in its cell, where
    /// that is known.
    fn given(&self, unit: &str) -> GivenAnswer {
        if self.answer.is_empty() {
            return GivenAnswer::Empty;
        }
        let Some((face, behind)) = WrittenFigure::read(&self.answer) else {
            return GivenAnswer::Unreadable;
        };
        let factor = match behind.as_str() {
            "" => unit_factor(&self.unit, unit).unwrap_or(1.0),
            behind => match unit_factor(behind, unit) {
                Some(factor) => factor,
                None => return GivenAnswer::Unreadable,
            },
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
    /// Where the head row says so; else the third cell is the answer.
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

    /// The answer, whose decimals may stand in a cell of their own, one more than there are heads.
    fn answer_in(&self, cells: &[String]) -> String {
        let cell = |place: usize| cells.get(place).map_or("", String::as_str);
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

    fn row(figure: &str, unit: &str, answer: &str) -> AnsweredRow {
        AnsweredRow {
            figure: figure.into(),
            unit: unit.into(),
            answer: answer.into(),
        }
    }

    #[test]
    fn spreadsheets_write_as_they_like() {
        let expected = AnswerFile {
            sheet: Some("a.toml".into()),
            student: Some("Ayşe Öz".into()),
            answers: vec![row("r3.angle", "deg", "29,38"), row("C.v", "mm/s", "")],
        };
        for text in [
            "figure,unit,answer\nsheet,,a.toml\nstudent,,Ayşe Öz\nr3.angle,deg,\"29,38\"\nC.v,mm/s,\n",
            "\u{feff}figure;unit;answer\r\nsheet;;a.toml\r\nstudent;;Ayşe Öz\r\nr3.angle;deg;29,38\r\nC.v;mm/s;\r\n",
            "figure\tunit\tanswer\nsheet\t\ta.toml\nstudent\t\tAyşe Öz\nr3.angle\tdeg\t 29,38\nC.v\tmm/s\n",
            "student,,Ayşe Öz\nr3.angle,deg,29,38\nC.v,mm/s,,\nsheet,,a.toml",
        ] {
            assert_eq!(read(text), expected, "{text}");
        }
        let old = AnswerFile::read(b"student;;Ay\xfee\nr3.angle;deg;1\n").unwrap();
        assert_eq!(old.student.as_deref(), Some("Ay\u{fffd}e"));
    }

    /// Cells are joined only where a decimal comma has parted them.
    #[test]
    fn a_column_more_is_no_decimals() {
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

    /// The head row says where the answers stand.
    #[test]
    fn columns_may_be_gone_or_moved() {
        for (text, unit) in [
            ("figure,answer\nstudent,Ali\nr3.angle,29.38\n", ""),
            (
                "Answer,Figure,Unit\nAli,student,\n29.38,r3.angle,deg\n",
                "deg",
            ),
        ] {
            let file = read(text);
            assert_eq!(file.answers, [row("r3.angle", unit, "29.38")], "{text}");
            assert_eq!(file.student.as_deref(), Some("Ali"));
        }
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
