//! Formats a candidate of a synthesis for a list.

use crate::Vec2;
use crate::report::synthesis::{FEW, SynthesisReport, turns, unmet_text};
use crate::report::text::number::significant;
use crate::synthesis::{Candidate, PinConstraint, PosedDyad};
use crate::wording::words;

/// Significant digits of lengths in a line.
const DIGITS: usize = 4;

/// A candidate in a list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct CandidateRow {
    /// The maximum deviation from the task, without its unit.
    pub(crate) miss: String,
    /// The minimum transmission angle during the motion, in degrees.
    pub(crate) transmission: String,
    /// A word that says whether the crank turns fully.
    pub(crate) turns: &'static str,
    /// The lengths, such as `r2 104.1, r3 302, r4 251.5, r1 400 mm`.
    pub(crate) lengths: String,
    /// The unmet preferences, as the task file names them; empty if all are met.
    pub(crate) unmet: String,
    /// The reasons why it does not do the task; empty if it does.
    pub(crate) reasons: String,
}

impl SynthesisReport<'_> {
    /// Formats a candidate for a list.
    pub(crate) fn row(&self, candidate: &Candidate) -> CandidateRow {
        let figures = &candidate.figures;
        let named = ["r2", "r3", "r4", "r1"]
            .into_iter()
            .zip(candidate.proposal.all_lengths());
        let named = named.filter_map(|(name, length)| {
            let length = significant(length?, DIGITS);
            Some(format!("{name} {length}"))
        });
        let named: Vec<String> = named.collect();
        CandidateRow {
            miss: significant(figures.miss, FEW),
            transmission: significant(figures.transmission, FEW),
            turns: turns(candidate),
            lengths: format!("{} {}", named.join(", "), self.file.unit.symbol()),
            unmet: match candidate.missed.is_empty() {
                true => String::new(),
                false => unmet_text(&candidate.missed),
            },
            reasons: self.reasons(candidate),
        }
    }

    /// Describes a pin and its partner: their positions, and the length of the link.
    pub(crate) fn dyad(&self, dyad: &PosedDyad) -> String {
        let place = |at: Vec2| [at.x, at.y].map(|v| significant(v, DIGITS)).join(", ");
        let unit = self.file.unit.symbol();
        match dyad.held {
            PinConstraint::Rocker(pivot) => {
                let link = significant((dyad.pin - pivot).norm(), DIGITS);
                words().pin_on_pivot(&place(pivot), &place(dyad.pin), &link, unit)
            }
            PinConstraint::Slide(angle) => {
                let angle = significant(angle, DIGITS);
                words().pin_on_slide(&angle, &place(dyad.pin), unit)
            }
        }
    }
}
