//! Formats the results of a class: a row for each student.

use super::blank::InvalidCell;
use super::graded::{GradedAnswers, GradedFigure, VerdictCounts};
use crate::page::{Page, Table};
use crate::report::text::csv_dialect::{CsvDialect, CsvSheet};
use crate::scene::sanitized;
use crate::study::FigureVerdict;
use crate::wording::words;
use std::io::{self, Write};

/// The columns. These must stay stable.
const HEADS: [&str; 24] = [
    "student",
    "sheet",
    "figures",
    "points",
    "right",
    "rounded",
    "followed",
    "sign",
    "unit",
    "assembly",
    "wrong",
    "empty",
    "first",
    "verdict",
    "mistake",
    "why",
    "answer",
    "file",
    "unknown_units",
    "no_numbers",
    "repeated",
    "unknown_rows",
    "encoding",
    "misread",
];

/// Writes a row for each student: name, number of values by verdict, the first value that is not
/// right, and the first without a point, each with its verdict.
///
/// # Errors
/// Returns the errors of the output.
pub fn class_csv(
    class: &[GradedAnswers],
    dialect: CsvDialect,
    to: &mut dyn Write,
) -> io::Result<()> {
    let mut rows = CsvSheet::new(dialect, to);
    rows.record(HEADS)?;
    for one in class {
        let mut cells = vec![one.student.clone(), one.sheet.clone()];
        cells.extend(numbers(one).map(|number| number.to_string()));
        let named = |figure: Option<&GradedFigure>| match figure {
            Some(figure) => [
                figure.quantity.name.clone(),
                code(figure.verdict).to_owned(),
            ],
            None => Default::default(),
        };
        cells.extend(named(one.first()));
        cells.extend(named(one.mistake()));
        cells.push(
            one.mistake()
                .map_or_else(String::new, |f| f.written.clone()),
        );
        cells.push(one.file.clone());
        let remarks = &one.remarks;
        let lists = [
            &remarks.strange_units,
            &remarks.unreadable,
            &remarks.repeated,
            &remarks.strangers,
        ];
        cells.extend(lists.map(|list| in_cell(list)));
        cells.push(remarks.encoding.name().to_owned());
        let misread = one.misread.as_ref();
        cells.push(misread.map_or_else(String::new, |of| {
            format!("{} = {} {}", of.value.name, of.number, of.value.unit)
        }));
        rows.record(cells.iter().map(|cell| harmless(cell)))?;
    }
    rows.finish()
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
    let heads = [
        words().points_head(),
        words().figures_head(),
        words().first_mistake_head(),
        words().judged(),
        words().file_head(),
    ];
    let mut table = Table::new(words().student(), heads);
    for one in class {
        let points = one.counts().points().to_string();
        let mistake = one.mistake();
        let [name, verdict] = match mistake {
            Some(figure) => [figure.quantity.name.clone(), one.told(figure)],
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

fn numbers(one: &GradedAnswers) -> [usize; 10] {
    let counts = one.counts();
    let VerdictCounts {
        right,
        rounded,
        followed,
        sign,
        unit,
        assembly,
        wrong,
        empty,
    } = counts;
    [
        one.figures.len(),
        counts.points(),
        right,
        rounded,
        followed,
        sign,
        unit,
        assembly,
        wrong,
        empty,
    ]
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
