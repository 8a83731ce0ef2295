//! One student's answers, graded.

use super::blank::AnswerFile;
use crate::page::{Page, Setting, Table};
use crate::quantity::Quantity;
use crate::report::number::{direction, significant};
use crate::study::{AnswerKey, FigureVerdict, RoundedEarly};
use crate::wording::words;
use std::path::Path;

/// The answers of one student with their verdicts.
#[derive(Clone, Debug)]
pub struct GradedAnswers {
    /// Who answered: by the file's own word, or the file's name.
    pub student: String,
    /// The sheet that was answered.
    pub sheet: String,
    /// The file in which the answers stand, as it was named.
    pub file: String,
    /// What was asked for, in the order in which it is found.
    pub figures: Vec<GradedFigure>,
    /// What was not asked for and is judged all the same, without points.
    pub besides: Vec<GradedFigure>,
    /// Names in the file that are no figures of the scene.
    pub strangers: Vec<String>,
    /// Figures whose unit in the file is none of theirs, and that unit.
    pub strange_units: Vec<(String, String)>,
}

/// A figure with its verdict.
#[derive(Clone, Debug)]
pub struct GradedFigure {
    /// Which.
    pub quantity: Quantity,
    /// Its value.
    pub exact: f64,
    /// What was answered, as it was written.
    pub written: String,
    /// What is to be said of that.
    pub verdict: FigureVerdict,
}

/// How often each verdict was given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct VerdictCounts {
    pub(super) right: usize,
    pub(super) rounded: usize,
    pub(super) followed: usize,
    pub(super) sign: usize,
    pub(super) unit: usize,
    pub(super) assembly: usize,
    pub(super) wrong: usize,
    pub(super) empty: usize,
}

impl VerdictCounts {
    /// Figures that are worth a point: right, but for rounding and for what was wrong before.
    pub(super) fn points(self) -> usize {
        self.right + self.rounded + self.followed
    }
}

/// Digits of exact figures, and of answers that stand in a sentence at the most.
const DIGITS: usize = 6;
const LONGEST: usize = 24;

impl GradedAnswers {
    /// Grades answers that were read from the file of this path; where they do not say whose they are, they are those of
    /// the file's name without folder and ending.
    #[must_use]
    pub fn new(key: &AnswerKey, file: &AnswerFile, path: &Path, sheet: &str) -> GradedAnswers {
        let own_name = || {
            path.file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into()
        };
        let given = file.given(key);
        let answers: Vec<_> = given.iter().map(|(_, answer)| *answer).collect();
        let verdicts = key.graded(&answers);
        let figures = key.figures.iter().zip(given).zip(verdicts);
        let is_known = |name: &String| key.figures.iter().any(|f| f.quantity.name == *name);
        let mut figures: Vec<GradedFigure> = figures
            .map(|((figure, (written, _)), verdict)| GradedFigure {
                quantity: figure.quantity.clone(),
                exact: figure.exact,
                written,
                verdict,
            })
            .collect();
        let besides = figures.split_off(key.asked.min(figures.len()));
        GradedAnswers {
            student: file.student.clone().unwrap_or_else(own_name),
            sheet: sheet.to_owned(),
            file: path.display().to_string(),
            figures,
            besides,
            strangers: file.names().into_iter().filter(|n| !is_known(n)).collect(),
            strange_units: file.strange_units(key),
        }
    }

    /// The first figure that is not right.
    #[must_use]
    pub fn first(&self) -> Option<&GradedFigure> {
        let mut figures = self.figures.iter();
        figures.find(|figure| figure.verdict != FigureVerdict::Right)
    }

    /// The first figure that is worth no point: what went wrong before is not counted against it.
    #[must_use]
    pub fn mistake(&self) -> Option<&GradedFigure> {
        let mut figures = self.figures.iter();
        figures.find(|figure| !figure.verdict.is_worth_a_point())
    }

    pub(super) fn counts(&self) -> VerdictCounts {
        let mut counts = VerdictCounts::default();
        for figure in &self.figures {
            let count = match figure.verdict {
                FigureVerdict::Right => &mut counts.right,
                FigureVerdict::Rounded(_) => &mut counts.rounded,
                FigureVerdict::Followed(_) => &mut counts.followed,
                FigureVerdict::Sign | FigureVerdict::Opposite => &mut counts.sign,
                FigureVerdict::OtherUnit(_) => &mut counts.unit,
                FigureVerdict::OtherAssembly => &mut counts.assembly,
                FigureVerdict::Wrong | FigureVerdict::Unreadable => &mut counts.wrong,
                FigureVerdict::Empty => &mut counts.empty,
            };
            *count += 1;
        }
        counts
    }

    /// All answers, one below the other, and what there is to say of them as a whole.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut page = Page::default();
        page.title(&self.student);
        page.text(words().answers_to(&self.sheet));
        page.table(self.table(&self.figures));
        let counts = self.counts();
        let points = counts.points();
        page.text(words().points_of(
            points,
            self.figures.len(),
            counts.right,
            points - counts.right,
        ));
        for (figure, say) in [(self.first(), FIRST), (self.mistake(), MISTAKE)] {
            if let Some(figure) = figure {
                page.text_below(say(&figure.quantity.name, &self.told(figure)));
            }
        }
        if !self.besides.is_empty() {
            page.text(words().judged_besides());
            page.table(self.table(&self.besides));
        }
        if !self.strange_units.is_empty() {
            let units = self.strange_units.iter();
            let units = units.map(|(name, unit)| format!("{name} [{}]", shortened(unit)));
            let units: Vec<String> = units.collect();
            page.text(words().strange_units(&units.join(", ")));
        }
        if !self.strangers.is_empty() {
            page.text(words().no_figures_of_scene(&self.strangers.join(", ")));
        }
        page
    }

    fn table(&self, figures: &[GradedFigure]) -> Table {
        let heads = [words().answer(), words().exact_figure(), words().judged()];
        let mut table = Table::new(words().figure(), heads).set(Setting::default());
        for figure in figures {
            let written = match figure.written.as_str() {
                "" => "-".to_owned(),
                text => shortened(text),
            };
            let name = format!("{} [{}]", figure.quantity.name, figure.quantity.unit);
            table.row(name, [written, figure.exact_text(), self.told(figure)]);
        }
        table
    }

    /// A verdict in words.
    pub(super) fn told(&self, figure: &GradedFigure) -> String {
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

type SayOfFigure = fn(&str, &str) -> String;
const FIRST: SayOfFigure = |name, verdict| words().first_that_differs(name, verdict);
const MISTAKE: SayOfFigure = |name, verdict| words().first_mistake(name, verdict);

impl GradedFigure {
    fn exact_text(&self) -> String {
        match self.quantity.is_direction() {
            true => direction(self.exact, DIGITS),
            false => significant(self.exact, DIGITS),
        }
    }
}

/// What somebody wrote into a cell, as far as it is shown.
fn shortened(text: &str) -> String {
    let clean = crate::scene::sanitized(text, false);
    match clean.char_indices().nth(LONGEST) {
        Some((end, _)) => clean[..end].to_owned() + "...",
        None => clean,
    }
}
