//! Grades the answers of one student.

use super::answer_file::{AnswerFile, InvalidCell};
use crate::page::{Page, Setting, Table};
use crate::quantity::Quantity;
use crate::report::text::encoding::TextEncoding;
use crate::report::text::number::{direction, significant};
use crate::study::{AnswerKey, FigureVerdict, MisreadValue, RoundedEarly, SheetScene};
use crate::wording::words;
use std::path::Path;

/// The answers of one student with their verdicts.
#[derive(Clone, Debug)]
pub struct GradedAnswers {
    /// The student's name from the file, or the file's name.
    pub student: String,
    /// The answered sheet.
    pub sheet: String,
    /// The file with the answers, as named by the user.
    pub file: String,
    /// The requested values in the order of their solution.
    pub figures: Vec<GradedFigure>,
    /// Other answered values, which are graded without points.
    pub besides: Vec<GradedFigure>,
    /// Problems of the file.
    pub remarks: FileRemarks,
    /// The misread given value, if that explains the answers.
    pub misread: Option<MisreadValue>,
}

/// Parts of an answer file that could not be interpreted as written.
#[derive(Clone, Debug, Default)]
pub struct FileRemarks {
    /// Rows whose name is not a value of the scene.
    pub unknown_names: Vec<InvalidCell>,
    /// Unknown or unsuitable units.
    pub strange_units: Vec<InvalidCell>,
    /// Answers that are not numbers.
    pub unreadable: Vec<InvalidCell>,
    /// Answers superseded by a later row.
    pub repeated: Vec<InvalidCell>,
    /// The encoding of the file.
    pub encoding: TextEncoding,
}

/// A value with its verdict.
#[derive(Clone, Debug)]
pub struct GradedFigure {
    /// The quantity.
    pub quantity: Quantity,
    /// The exact value.
    pub exact: f64,
    /// The answer as written.
    pub written: String,
    /// The verdict.
    pub verdict: FigureVerdict,
}

impl FileRemarks {
    fn new(key: &AnswerKey, file: &AnswerFile) -> FileRemarks {
        FileRemarks {
            unknown_names: file.strangers(key),
            strange_units: file.strange_units(key),
            unreadable: file.unreadable(key),
            repeated: file.repeated(),
            encoding: file.encoding,
        }
    }

    /// Returns the problems as sentences, one for each kind.
    pub(super) fn sentences(&self) -> Vec<String> {
        let listed = |cells: &[InvalidCell]| {
            let cells: Vec<String> = cells.iter().map(in_words).collect();
            cells.join(", ")
        };
        let of_encoding = (self.encoding == TextEncoding::Windows1254)
            .then(|| words().decoded_as(self.encoding.name()));
        let kinds: [(&[InvalidCell], CellMessage); 4] = [
            (&self.strange_units, |units| words().strange_units(units)),
            (&self.unreadable, |answers| words().answers_unread(answers)),
            (&self.repeated, |answers| words().answered_again(answers)),
            (&self.unknown_names, |rows| {
                words().no_figures_of_scene(rows)
            }),
        ];
        let kinds = kinds.into_iter().filter(|(cells, _)| !cells.is_empty());
        let of_cells = kinds.map(|(cells, wording)| wording(&listed(cells)));
        of_encoding.into_iter().chain(of_cells).collect()
    }
}

type CellMessage = fn(&str) -> String;

fn in_words(cell: &InvalidCell) -> String {
    let InvalidCell { line, figure, text } = cell;
    words().cell_of_line(*line, &shortened(figure), &shortened(text))
}

/// Significant digits of exact values, and maximum length of an answer in a sentence.
const DIGITS: usize = 6;
const MAX_LEN: usize = 24;

impl GradedAnswers {
    /// Grades the answers from the file of this path. Without a student's name in the file, the
    /// file's stem is used.
    #[must_use]
    pub fn new(
        key: &AnswerKey,
        file: &AnswerFile,
        path: &Path,
        (sheet, opened): (&str, SheetScene<'_>),
    ) -> GradedAnswers {
        let own_name = || {
            path.file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into()
        };
        let given = file.given(key);
        let answers: Vec<_> = given.iter().map(|(_, answer)| *answer).collect();
        let mut verdicts = key.graded(&answers);
        let misread = key.misread(&answers, &mut verdicts, opened);
        let figures = key.figures.iter().zip(given).zip(verdicts);
        let mut figures: Vec<GradedFigure> = figures
            .map(|((figure, (written, _)), verdict)| GradedFigure {
                quantity: figure.quantity.clone(),
                exact: figure.exact,
                written,
                verdict,
            })
            .collect();
        let besides = figures.split_off(key.required.min(figures.len()));
        GradedAnswers {
            student: file.student.clone().unwrap_or_else(own_name),
            sheet: sheet.to_owned(),
            file: path.display().to_string(),
            figures,
            besides,
            remarks: FileRemarks::new(key, file),
            misread,
        }
    }

    /// Returns the first value that is not right, if any.
    #[must_use]
    pub fn first(&self) -> Option<&GradedFigure> {
        let mut figures = self.figures.iter();
        figures.find(|figure| figure.verdict != FigureVerdict::Right)
    }

    /// Returns the first value without a point, if any; consequences of earlier mistakes have one.
    #[must_use]
    pub fn mistake(&self) -> Option<&GradedFigure> {
        let mut figures = self.figures.iter();
        figures.find(|figure| !figure.verdict.earns_point())
    }

    /// Returns the number of values worth a point: right, apart from rounding and from earlier
    /// mistakes.
    pub(super) fn points(&self) -> usize {
        let verdicts = self.figures.iter().map(|figure| figure.verdict);
        verdicts.filter(|verdict| verdict.earns_point()).count()
    }

    /// Formats all answers in a table, with remarks on the whole.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut page = Page::default();
        page.title(&self.student);
        page.text(words().answers_to(&self.sheet));
        page.table(self.table(&self.figures));
        let points = self.points();
        let verdicts = self.figures.iter().map(|figure| figure.verdict);
        let right = verdicts
            .filter(|verdict| *verdict == FigureVerdict::Right)
            .count();
        page.text(words().points_of(points, self.figures.len(), right, points - right));
        for (figure, wording) in [(self.first(), FIRST), (self.mistake(), MISTAKE)] {
            if let Some(figure) = figure {
                page.text_below(wording(
                    &figure.quantity.name,
                    &self.describe_verdict(figure),
                ));
            }
        }
        if let Some(misread) = &self.misread {
            let MisreadValue { value, number, .. } = misread;
            let given = value.text();
            let read = format!("{} {}", significant(*number, DIGITS), value.unit);
            page.text(words().value_misread(&value.name, &given, read.trim_end()));
        }
        if !self.besides.is_empty() {
            page.text(words().judged_besides());
            page.table(self.table(&self.besides));
        }
        for remark in self.remarks.sentences() {
            page.text(remark);
        }
        page
    }

    fn table(&self, figures: &[GradedFigure]) -> Table {
        let headers = [words().answer(), words().exact_figure(), words().judged()];
        let mut table = Table::new(words().figure(), headers).set(Setting::default());
        for figure in figures {
            let written = match figure.written.as_str() {
                "" => "-".to_owned(),
                text => shortened(text),
            };
            let name = format!("{} [{}]", figure.quantity.name, figure.quantity.unit);
            table.row(
                name,
                [written, figure.exact_text(), self.describe_verdict(figure)],
            );
        }
        table
    }

    /// Describes a verdict.
    pub(super) fn describe_verdict(&self, figure: &GradedFigure) -> String {
        let name = |number: usize| {
            let of = self.figures.iter().chain(&self.besides).nth(number);
            of.map_or_else(Default::default, |f| {
                (f.quantity.name.clone(), shortened(&f.written))
            })
        };
        match figure.verdict {
            FigureVerdict::Right => words().is_right().into(),
            FigureVerdict::Rounded(RoundedEarly::By(number)) => {
                let (name, written) = name(number);
                words().rounded_by(&name, &written)
            }
            FigureVerdict::Rounded(RoundedEarly::Cut) => words().cut_off().into(),
            FigureVerdict::Rounded(RoundedEarly::Coarse) => words().too_few_digits().into(),
            FigureVerdict::Rounded(RoundedEarly::Near) => words().rounded_somewhere().into(),
            FigureVerdict::Followed(number) => words().right_by_own(&name(number).0),
            FigureVerdict::Sign => words().wrong_in_sign().into(),
            FigureVerdict::Opposite => words().other_way_round().into(),
            FigureVerdict::OtherUnit(unit) => words().in_other_unit(unit),
            FigureVerdict::OtherAssembly => words().of_other_assembly().into(),
            FigureVerdict::Wrong => words().is_wrong().into(),
            FigureVerdict::Empty => words().is_unanswered().into(),
            FigureVerdict::Unreadable => words().is_no_figure().into(),
        }
    }
}

type FigureMessage = fn(&str, &str) -> String;
const FIRST: FigureMessage = |name, verdict| words().first_that_differs(name, verdict);
const MISTAKE: FigureMessage = |name, verdict| words().first_mistake(name, verdict);

impl GradedFigure {
    fn exact_text(&self) -> String {
        match self.quantity.is_direction() {
            true => direction(self.exact, DIGITS),
            false => significant(self.exact, DIGITS),
        }
    }
}

/// Returns the text of a cell, sanitized and truncated for display.
fn shortened(text: &str) -> String {
    let clean = crate::scene::sanitized(text, false);
    match clean.char_indices().nth(MAX_LEN) {
        Some((end, _)) => clean[..end].to_owned() + "...",
        None => clean,
    }
}
