//! Summarizes many designs: their number, and the minimum and maximum of each value.

use crate::report::designs::table::DesignTable;
use crate::report::text::rows::RowColumn;
use crate::study::{DesignRow, DesignState};
use crate::wording::words;

/// The summary, accumulated row by row.
#[derive(Clone, Debug)]
pub struct DesignSummary {
    /// The number of all designs.
    pub rows: u64,
    /// The number of designs with at least one value.
    pub valued: u64,
    /// The number of designs that do not assemble as the scene does.
    pub open: u64,
    /// The number of designs whose numbers do not form a valid scene.
    pub unreadable: u64,
    extremes: Vec<Option<DesignExtremes>>,
}

/// The minimum and maximum of a value, each with the numbers of its design.
#[derive(Clone, Debug)]
struct DesignExtremes {
    least: (f64, Vec<f64>),
    greatest: (f64, Vec<f64>),
}

impl DesignSummary {
    /// Creates an empty summary for so many values.
    #[must_use]
    pub fn new(count: usize) -> DesignSummary {
        DesignSummary {
            rows: 0,
            valued: 0,
            open: 0,
            unreadable: 0,
            extremes: vec![None; count],
        }
    }

    /// Adds a row.
    pub fn note(&mut self, row: &DesignRow) {
        self.rows += 1;
        self.valued += u64::from(row.figures.iter().any(Result::is_ok));
        self.open += u64::from(row.state == DesignState::NoAssembly);
        self.unreadable += u64::from(row.state == DesignState::Unreadable);
        for (index, known) in self.extremes.iter_mut().enumerate() {
            if let Some(value) = row.figure(index) {
                DesignExtremes::note(known, value, &row.numbers);
            }
        }
    }

    /// Formats the minimum and maximum of each value in a line; the first of equal designs is
    /// shown.
    #[must_use]
    pub fn lines(&self, table: &DesignTable, digits: usize) -> Vec<String> {
        let (numbers, figures) = table.columns();
        let text = figures.iter().zip(&self.extremes);
        let line = |(figure, found): (&RowColumn, &Option<DesignExtremes>)| {
            let Some(found) = found else {
                return words().has_no_value_in_designs(&figure.name);
            };
            let end = |(value, at): &(f64, Vec<f64>)| {
                let at = numbers.iter().zip(at);
                let at = at.map(|(c, &v)| format!("{} = {}", c.name, c.text(v, digits)));
                let at: Vec<String> = at.collect();
                (figure.text(*value, digits), at.join(", "))
            };
            let ((minimum, low), (maximum, high)) = (end(&found.least), end(&found.greatest));
            words().designs_from_to(&figure.name, [&minimum, &low], [&maximum, &high])
        };
        text.map(line).collect()
    }
}

impl DesignExtremes {
    fn note(known: &mut Option<DesignExtremes>, value: f64, numbers: &[f64]) {
        let here = || (value, numbers.to_vec());
        match known {
            None => {
                *known = Some(DesignExtremes {
                    least: here(),
                    greatest: here(),
                });
            }
            Some(known) if value < known.least.0 => known.least = here(),
            Some(known) if value > known.greatest.0 => known.greatest = here(),
            Some(_) => {}
        }
    }
}
