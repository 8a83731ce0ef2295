//! Writes candidates as CSV, with names and words independent of the language.

use crate::Vec2;
use crate::report::synthesis::{SynthesisReport, is_driven, preference_name};
use crate::report::text::csv_dialect::CsvDialect;
use crate::report::text::rows::{RowCell, RowColumn, RowTable, RowWriter};
use crate::synthesis::{Candidate, PinConstraint, TaskDefect};
use std::io;

/// The unit of a column.
#[derive(Clone, Copy)]
enum ColumnMeasure {
    Plain,
    Degrees,
    /// The task's unit.
    Length,
    /// Degrees for a function of angles, or else lengths.
    Miss,
}

type CandidateColumn = (
    &'static str,
    ColumnMeasure,
    fn(&Candidate) -> RowCell<'static>,
);

/// All columns after the number of the candidate.
const COLUMNS: [CandidateColumn; 27] = {
    use ColumnMeasure::{Degrees, Length, Miss, Plain};
    use RowCell::Number;
    [
        ("family", Plain, |c| RowCell::word(family(c))),
        ("A.x", Length, |c| Number(Some(c.proposal.pivot.x))),
        ("A.y", Length, |c| Number(Some(c.proposal.pivot.y))),
        ("D.x", Length, |c| Number(far_pivot(c).map(|d| d.x))),
        ("D.y", Length, |c| Number(far_pivot(c).map(|d| d.y))),
        ("guide", Degrees, |c| Number(guide(c))),
        ("B.x", Length, |c| Number(pin(c, 0).map(|b| b.x))),
        ("B.y", Length, |c| Number(pin(c, 0).map(|b| b.y))),
        ("C.x", Length, |c| Number(pin(c, 1).map(|at| at.x))),
        ("C.y", Length, |c| Number(pin(c, 1).map(|at| at.y))),
        ("P.x", Length, |c| Number(c.proposal.tracer.map(|p| p.x))),
        ("P.y", Length, |c| Number(c.proposal.tracer.map(|p| p.y))),
        ("r2", Length, |c| Number(c.proposal.all_lengths()[0])),
        ("r3", Length, |c| Number(c.proposal.all_lengths()[1])),
        ("r4", Length, |c| Number(c.proposal.all_lengths()[2])),
        ("r1", Length, |c| Number(c.proposal.all_lengths()[3])),
        ("transmission", Degrees, |c| {
            Number(opened_value(c, c.figures.transmission))
        }),
        ("transmission_throughout", Degrees, |c| {
            Number(opened_value(c, c.figures.min_transmission))
        }),
        ("ratio", Plain, |c| Number(opened_value(c, c.figures.ratio))),
        ("miss", Miss, |c| Number(opened_value(c, c.figures.miss))),
        ("rms", Miss, |c| Number(opened_value(c, c.figures.rms))),
        ("angle_miss", Degrees, |c| {
            Number(opened_value(c, c.figures.angle_miss))
        }),
        ("full_turn", Plain, |c| {
            Number(opened_value(c, f64::from(u8::from(c.figures.full_turn))))
        }),
        ("wishes_missed", Plain, |c| {
            RowCell::word(
                c.missed
                    .iter()
                    .map(preference_name)
                    .collect::<Vec<_>>()
                    .join(" "),
            )
        }),
        ("state", Plain, |c| RowCell::word(first_defect(c).0)),
        ("from", Plain, |c| Number(counted(first_defect(c).1[0]))),
        ("to", Plain, |c| Number(counted(first_defect(c).1[1]))),
    ]
};

impl SynthesisReport<'_> {
    /// Writes a row for each candidate, defective ones last. `state` is `ok` or the first defect,
    /// `from` and `to` are the points between which it lies; JSON has all defects.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write_csv(&self, dialect: CsvDialect, to: &mut dyn io::Write) -> io::Result<()> {
        let column = |(name, measure, _): &CandidateColumn| {
            let unit = match measure {
                ColumnMeasure::Plain => "",
                ColumnMeasure::Degrees => "deg",
                ColumnMeasure::Length => self.file.unit.symbol(),
                ColumnMeasure::Miss => self.miss_unit(),
            };
            RowColumn::new(*name, unit, true)
        };
        let number = RowColumn::new("candidate", "", true);
        let columns = [number].into_iter().chain(COLUMNS.iter().map(column));
        let table = RowTable::csv(columns.collect(), dialect);
        let head = table.head("", "", true);
        let mut rows = RowWriter::new(table, &head, to)?;
        // Defective candidates have no number.
        let good = self
            .listed_candidates()
            .iter()
            .zip((1..).map(|number| Some(f64::from(number))));
        let defective = self
            .found
            .defective
            .iter()
            .map(|candidate| (candidate, None));
        for (candidate, number) in good.chain(defective) {
            let cells = COLUMNS.iter().map(|(_, _, cell)| cell(candidate));
            rows.row([RowCell::Number(number)].into_iter().chain(cells))?;
        }
        rows.finish()
    }
}

/// Returns the kind of linkage, as named in `linkages` of a task.
pub(in crate::report) fn family(candidate: &Candidate) -> &'static str {
    match candidate.proposal.partner {
        PinConstraint::Rocker(_) => "four-bar",
        PinConstraint::Slide(_) => "slider-crank",
    }
}

/// Returns a language-independent word for a defect, and its points, numbered from 1.
pub(in crate::report) fn defect_words(defect: &TaskDefect) -> (&'static str, [Option<usize>; 2]) {
    let between = |from: &usize, to: &usize| [Some(from + 1), Some(to + 1)];
    let at = |point: &usize| [Some(point + 1); 2];
    match defect {
        TaskDefect::Unopened => ("unopened", [None; 2]),
        TaskDefect::Branch { from, to } => ("branch", between(from, to)),
        TaskDefect::Circuit { from, to } => ("circuit", between(from, to)),
        TaskDefect::Order { from, to } => ("order", between(from, to)),
        TaskDefect::Short => ("short", [None; 2]),
        TaskDefect::Missed { point } => ("missed", at(point)),
        TaskDefect::Far { point } => ("far", at(point)),
        TaskDefect::StructuralError => ("far", [None; 2]),
    }
}

fn first_defect(candidate: &Candidate) -> (&'static str, [Option<usize>; 2]) {
    let first = candidate.defects.first();
    first.map_or(("ok", [None; 2]), defect_words)
}

fn counted(point: Option<usize>) -> Option<f64> {
    point.map(|point| point as f64)
}

fn far_pivot(candidate: &Candidate) -> Option<Vec2> {
    candidate.proposal.partner.pivot()
}

fn guide(candidate: &Candidate) -> Option<f64> {
    match candidate.proposal.partner {
        PinConstraint::Rocker(_) => None,
        PinConstraint::Slide(angle) => Some(angle),
    }
}

/// Returns B or C where the scene opens.
fn pin(candidate: &Candidate, which: usize) -> Option<Vec2> {
    let first = candidate.proposal.places.first();
    first.map(|pins| pins[which])
}

/// Returns the value, unless the candidate could not be opened.
fn opened_value(candidate: &Candidate, value: f64) -> Option<f64> {
    is_driven(candidate).then_some(value)
}
