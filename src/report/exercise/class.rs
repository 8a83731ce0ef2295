//! Formats the results of a class: a row for each student.

use super::answer_file::InvalidCell;
use super::graded::{GradedAnswers, GradedFigure};
use crate::page::{Page, Table};
use crate::report::text::csv_dialect::{CsvDialect, CsvSheet};
use crate::scene::sanitized;
use crate::study::FigureVerdict;
use crate::wording::words;
use std::io::{self, Write};

type ClassColumn = (&'static str, fn(&GradedAnswers) -> String);

/// The columns: name, number of values by verdict, the first value that is not right, and the first
/// without a point, each with its verdict. The names must stay stable.
const COLUMNS: [ClassColumn; 24] = [
    ("student", |one| one.student.clone()),
    ("sheet", |one| one.sheet.clone()),
    ("figures", |one| one.figures.len().to_string()),
    ("points", |one| one.points().to_string()),
    ("right", |one| count(one, "right")),
    ("rounded", |one| count(one, "rounded")),
    ("followed", |one| count(one, "followed")),
    ("sign", |one| count(one, "sign")),
    ("unit", |one| count(one, "unit")),
    ("assembly", |one| count(one, "assembly")),
    ("wrong", |one| count(one, "wrong")),
    ("empty", |one| count(one, "empty")),
    ("first", |one| name(one.first())),
    ("verdict", |one| verdict(one.first())),
    ("mistake", |one| name(one.mistake())),
    ("why", |one| verdict(one.mistake())),
    ("answer", |one| {
        let written = one.mistake().map(|figure| figure.written.clone());
        written.unwrap_or_default()
    }),
    ("file", |one| one.file.clone()),
    ("unknown_units", |one| in_cell(&one.remarks.strange_units)),
    ("no_numbers", |one| in_cell(&one.remarks.unreadable)),
    ("repeated", |one| in_cell(&one.remarks.repeated)),
    ("unknown_rows", |one| in_cell(&one.remarks.unknown_names)),
    ("encoding", |one| one.remarks.encoding.name().to_owned()),
    ("misread", |one| {
        let misread = one.misread.as_ref();
        let read = misread.map(|of| format!("{} = {} {}", of.value.name, of.number, of.value.unit));
        read.unwrap_or_default()
    }),
];

/// Writes a row for each student.
///
/// # Errors
/// Returns the errors of the output.
pub fn class_csv(
    class: &[GradedAnswers],
    dialect: CsvDialect,
    to: &mut dyn Write,
) -> io::Result<()> {
    let mut rows = CsvSheet::new(dialect, to);
    rows.record(COLUMNS.map(|(name, _)| name))?;
    for one in class {
        rows.record(COLUMNS.map(|(_, cell)| harmless(&cell(one))))?;
    }
    rows.finish()
}

fn count(one: &GradedAnswers, verdict: &str) -> String {
    let figures = one.figures.iter();
    let counted = figures.filter(|figure| code(figure.verdict) == verdict);
    counted.count().to_string()
}

fn name(figure: Option<&GradedFigure>) -> String {
    figure.map_or_else(String::new, |figure| figure.quantity.name.clone())
}

fn verdict(figure: Option<&GradedFigure>) -> String {
    figure.map_or("", |figure| code(figure.verdict)).to_owned()
}

/// Lists cells of an answer file in one cell, as `line figure: text` separated by semicolons.
fn in_cell(cells: &[InvalidCell]) -> String {
    let listed = cells
        .iter()
        .map(|cell| format!("{} {}: {}", cell.line, cell.figure, cell.text));
    listed.collect::<Vec<_>>().join("; ")
}

/// Formats the class results as a page.
#[must_use]
pub fn class_page(class: &[GradedAnswers]) -> Page {
    let mut page = Page::default();
    let headers = [
        words().points_head(),
        words().figures_head(),
        words().first_mistake_head(),
        words().judged(),
        words().file_head(),
    ];
    let mut table = Table::new(words().student(), headers);
    for one in class {
        let points = one.points().to_string();
        let mistake = one.mistake();
        let [name, verdict] = match mistake {
            Some(figure) => [figure.quantity.name.clone(), one.describe_verdict(figure)],
            None => ["-".to_owned(), "-".to_owned()],
        };
        let figures = one.figures.len().to_string();
        let file = one.file.clone();
        table.row(one.student.clone(), [points, figures, name, verdict, file]);
    }
    page.table(table);
    for one in class {
        for remark in one.remarks.sentences() {
            page.text(format!("{}: {remark}", one.file));
        }
    }
    page
}

/// Returns the students with several files, and their files: one of these may be outdated, or have
/// a wrong name.
#[must_use]
pub fn named_again(class: &[GradedAnswers]) -> Vec<(&str, Vec<&str>)> {
    let mut all: Vec<(&str, Vec<&str>)> = Vec::new();
    for one in class {
        match all.iter_mut().find(|(student, _)| *student == one.student) {
            Some((_, files)) => files.push(&one.file),
            None => all.push((&one.student, vec![&one.file])),
        }
    }
    all.retain(|(_, files)| files.len() > 1);
    all
}

/// Returns the name of a verdict's column.
fn code(verdict: FigureVerdict) -> &'static str {
    match verdict {
        FigureVerdict::Right => "right",
        FigureVerdict::Rounded(_) => "rounded",
        FigureVerdict::Followed(_) => "followed",
        FigureVerdict::Sign | FigureVerdict::Opposite => "sign",
        FigureVerdict::OtherUnit(_) => "unit",
        FigureVerdict::OtherAssembly => "assembly",
        FigureVerdict::Wrong | FigureVerdict::Unreadable => "wrong",
        FigureVerdict::Empty => "empty",
    }
}

/// Makes a cell safe for spreadsheets and terminals: it is neither a formula nor contains control
/// characters. Students may write anything into their files.
fn harmless(cell: &str) -> String {
    let is_number = cell.replace(',', ".").parse::<f64>().is_ok();
    let cell = sanitized(cell, false);
    match cell.starts_with(['=', '+', '-', '@']) && !is_number {
        true => format!("'{cell}"),
        false => cell,
    }
}
