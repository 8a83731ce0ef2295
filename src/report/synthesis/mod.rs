//! Reports the result of a task: linkages that do it, and defective ones with the reasons.

#[cfg(feature = "tui")]
pub(in crate::report) mod candidate_row;
pub(in crate::report) mod csv;
pub(in crate::report) mod structural_error;

#[cfg(test)]
mod tests;

use crate::page::{Cell, Content, Facts, Head, Page, Table, TextStyle};
use crate::report::text::number::significant;
use crate::synthesis::{
    Candidate, OpenReason, Output, PinConstraint, PosedDyad, SceneGoals, SceneTitles, Synthesis,
    Task, TaskDefect, TaskKind, UnmetPreference,
};
use crate::task_file::TaskFile;
use crate::wording::words;
use csv::{defect_words, family};
use serde_json::{Value, json};
use structural_error::StructuralError;

/// Significant digits of lengths, and of errors and angles.
const DIGITS: usize = 6;
pub(in crate::report) const FEW: usize = 3;
/// Number of goals in a line of a scene's comment: those of one pose.
const GOALS_PER_LINE: usize = 3;
/// Maximum number of defective candidates listed.
const MAX_DEFECTIVE: usize = 10;

/// The result of a task.
#[derive(Clone, Copy, Debug)]
pub struct SynthesisReport<'a> {
    /// The task.
    pub file: &'a TaskFile,
    /// The result.
    pub found: &'a Synthesis,
    /// Maximum number of candidates listed.
    pub top: usize,
}

impl SynthesisReport<'_> {
    /// Returns the candidates to list: the best of those that do the task.
    #[must_use]
    pub fn listed_candidates(&self) -> &[Candidate] {
        &self.found.good[..self.found.good.len().min(self.top)]
    }

    /// Returns the titles and comments of a candidate's scene; candidates are numbered from 1.
    #[must_use]
    pub fn titles(
        &self,
        number: usize,
        candidate: &Candidate,
        tolerance: Option<f64>,
    ) -> SceneTitles {
        SceneTitles {
            name: words().candidate_called(&self.file.title(), number),
            source: words().candidate_made_by(&self.file.title()),
            comments: self.comments(candidate),
            unit: self.file.unit.symbol().to_owned(),
            tolerance,
        }
    }

    /// Returns comments for its scene: the meaning of its numbers, and how to change them so that
    /// the task is still done.
    fn comments(&self, candidate: &Candidate) -> Vec<String> {
        let few = |value: f64| significant(value, FEW);
        let figures = &candidate.figures;
        let mut comments = vec![words().driven_as_written(&few(figures.miss), self.miss_unit())];
        comments.push(
            words().transmission_as_written(
                &few(figures.transmission),
                &few(figures.min_transmission),
            ),
        );
        if let Some(goals) = SceneGoals::of(&self.file.task, candidate) {
            comments.push(words().kept_by_goals().to_owned());
            comments.push(words().solved_with_goals(&goals.vary.join(",")));
            let rows = goals.keep.chunks(GOALS_PER_LINE).map(|goals| {
                let goals: Vec<String> = goals
                    .iter()
                    .map(|goal| format!("--keep '{goal}'"))
                    .collect();
                format!("    {} \\", goals.join(" "))
            });
            comments.extend(rows);
            comments.push("    --goal ... -o better.toml".to_owned());
        }
        comments
    }

    /// Formats the report as text.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// Returns the task and the result as a page.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut page = Page::aligned();
        page.title(&self.file.title());
        let mut facts = Facts::default();
        facts.add(words().wanted_motion(), [wanted(&self.file.task)]);
        facts.add(words().designs_found(), [self.verdict()]);
        page.add(Content::Facts(facts));
        if !self.listed_candidates().is_empty() {
            page.table(self.table());
        }
        if let Some(plot) = self.error_of_best() {
            page.add(Content::Characters(plot));
        }
        let reasons = self.found.defective.iter().take(MAX_DEFECTIVE);
        if reasons.len() > 0 {
            let mut facts = Facts::default();
            let rest = self.found.defective.len().saturating_sub(MAX_DEFECTIVE);
            let lines = reasons
                .map(|candidate| format!("{}: {}", self.brief(candidate), self.reasons(candidate)));
            let rest = (rest > 0).then(|| words().and_more(rest));
            facts.add(words().defective_ones(), lines.chain(rest));
            page.add(Content::Facts(facts));
        }
        page
    }

    /// Plots the structural error of the first candidate over its whole range, if it has one.
    fn error_of_best(&self) -> Option<Vec<String>> {
        let error = StructuralError::of(&self.file.task, self.listed_candidates().first()?)?;
        error.plot(self.miss_unit())
    }

    /// Describes how many candidates were found, and whether there may be others.
    pub(crate) fn verdict(&self) -> String {
        let found = self.found;
        words().candidates_found(
            found.good.len(),
            self.listed_candidates().len(),
            found.defective.len(),
            found.is_complete,
            &self.reason(),
        )
    }

    /// Explains that no linkage does the task, with the reason if known.
    pub(crate) fn nothing(&self) -> String {
        let reason = match self.found.defective.is_empty() {
            true => self.reason(),
            false => String::new(),
        };
        words().nothing_does_the_task(&reason)
    }

    /// Returns the reason why there are none, or why there may be others; empty if a search has no
    /// reason to give.
    fn reason(&self) -> String {
        let Some(reason) = self.found.reason else {
            return String::new();
        };
        match reason {
            OpenReason::Range => words().poses_out_of_range().into(),
            OpenReason::Turn(at) => {
                let [x, y] = [at.x, at.y].map(|v| significant(v, DIGITS));
                words().poses_turn_about(&x, &y)
            }
            OpenReason::Shift => words().poses_only_shift().into(),
            OpenReason::GivenNumber => words().given_leads_nowhere().into(),
            OpenReason::NoPair => words().no_pair_of_dyads().into(),
            OpenReason::Far => words().dyads_out_of_reach().into(),
            OpenReason::Rounding => words().poses_nearly_repeat().into(),
        }
    }

    /// Returns the unit of the deviation from the task.
    pub(crate) fn miss_unit(&self) -> &'static str {
        match &self.file.task.kind {
            TaskKind::Function(task) if task.output == Output::Angle => "deg",
            _ => self.file.unit.symbol(),
        }
    }

    fn table(&self) -> Table {
        let length = self.file.unit.symbol();
        // A slide is not a link, so its column would be empty.
        let links = ["r2", "r3", "r4", "r1"].into_iter().enumerate();
        let has = |link: usize| {
            self.listed_candidates()
                .iter()
                .any(|c| c.proposal.all_lengths()[link].is_some())
        };
        let links: Vec<(usize, &str)> = links.filter(|(link, _)| has(*link)).collect();
        let missing = self
            .listed_candidates()
            .iter()
            .any(|c| !c.missed.is_empty());
        let mut headers: Vec<Head> = links
            .iter()
            .map(|(_, name)| Head::of(name, length))
            .collect();
        headers.extend([
            Head::of(words().head_transmission(), "deg"),
            Head::of(words().head_miss(), self.miss_unit()),
            Head::of(words().head_turns(), ""),
        ]);
        headers.extend(missing.then(|| Head::of(words().head_lacks(), "")));
        let mut table = Table::new("", headers.iter().map(Head::one_line));
        for (number, candidate) in (1..).zip(self.listed_candidates()) {
            let figures = &candidate.figures;
            let own = candidate.proposal.all_lengths();
            let length = |link: usize| match own[link] {
                Some(length) => significant(length, DIGITS),
                None => "-".to_owned(),
            };
            let mut cells: Vec<String> = links.iter().map(|(link, _)| length(*link)).collect();
            cells.extend([
                significant(figures.transmission, FEW),
                significant(figures.miss, FEW),
                turns(candidate).to_owned(),
            ]);
            cells.extend(missing.then(|| unmet_text(&candidate.missed)));
            table.row(number.to_string(), cells.into_iter().map(Cell::proved));
        }
        table
    }

    /// Formats a candidate by its lengths.
    fn brief(&self, candidate: &Candidate) -> String {
        let lengths = candidate.proposal.all_lengths().into_iter().flatten();
        let lengths: Vec<String> = lengths.map(|length| significant(length, 4)).collect();
        lengths.join(", ")
    }

    pub(in crate::report) fn reasons(&self, candidate: &Candidate) -> String {
        let reasons = candidate.defects.iter().map(reason);
        reasons.collect::<Vec<_>>().join("; ")
    }

    /// Returns the whole result for programs.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let candidate = |candidate: &Candidate| {
            let pivot = candidate.proposal.pivot;
            let held = match candidate.proposal.partner {
                PinConstraint::Rocker(d) => json!({ "D": [d.x, d.y] }),
                PinConstraint::Slide(angle) => json!({ "guide": angle }),
            };
            let [crank, coupler, rocker, ground] = candidate.proposal.all_lengths();
            let defect = |defect: &TaskDefect| {
                let (state, [from, to]) = defect_words(defect);
                json!({ "state": state, "from": from, "to": to })
            };
            let figures = &candidate.figures;
            // A candidate that could not be opened has no values.
            let text = |value: f64| is_driven(candidate).then_some(value);
            let first = candidate.proposal.places.first();
            json!({
                "family": family(candidate),
                "A": [pivot.x, pivot.y],
                "partner": held,
                "B": first.map(|position| [position[0].x, position[0].y]),
                "C": first.map(|position| [position[1].x, position[1].y]),
                "P": candidate.proposal.tracer.map(|p| [p.x, p.y]),
                "r2": crank,
                "r3": coupler,
                "r4": rocker,
                "r1": ground,
                "driver": candidate.at,
                "full_turn": is_driven(candidate).then_some(figures.full_turn),
                "transmission": text(figures.transmission),
                "transmission_throughout": text(figures.min_transmission),
                "ratio": text(figures.ratio),
                "miss": text(figures.miss),
                "rms": text(figures.rms),
                "angle_miss": text(figures.angle_miss),
                "structural_error": StructuralError::of(&self.file.task, candidate)
                    .map(|error| error.pairs()),
                "wishes_missed": candidate.missed.iter().map(preference_name).collect::<Vec<_>>(),
                "defects": candidate.defects.iter().map(defect).collect::<Vec<_>>(),
            })
        };
        // A point of the curves of four poses: a pivot with its pin at the first pose, or the guide
        // of a slide with the pin.
        let spot = |dyad: &PosedDyad| {
            let pin = [dyad.pin.x, dyad.pin.y];
            match dyad.held {
                PinConstraint::Rocker(at) => json!({ "pivot": [at.x, at.y], "pin": pin }),
                PinConstraint::Slide(angle) => json!({ "guide": angle, "pin": pin }),
            }
        };
        let piece = |piece: &Vec<PosedDyad>| piece.iter().map(spot).collect::<Vec<_>>();
        let about = if let Some(OpenReason::Turn(at)) = self.found.reason {
            Some([at.x, at.y])
        } else {
            None
        };
        json!({
            "task": self.file.name,
            "unit": self.file.unit.symbol(),
            "miss_unit": self.miss_unit(),
            "complete": self.found.is_complete,
            "reason": self.found.reason.map(reason_name),
            "turned_about": about,
            "candidates": self.listed_candidates().iter().map(candidate).collect::<Vec<_>>(),
            "defective": self.found.defective.iter().map(candidate).collect::<Vec<_>>(),
            "curves": self.found.curves.iter().map(piece).collect::<Vec<_>>(),
        })
    }
}

/// Describes the task in a few words.
pub(crate) fn wanted(task: &Task) -> String {
    match &task.kind {
        TaskKind::Poses(task) => words().poses_wanted(task.poses.len()),
        TaskKind::Function(task) => words().pairs_wanted(task.pairs.len()),
        TaskKind::Path(task) => words().points_wanted(task.points.len(), task.closed),
    }
}

/// Returns `true` if the solver could open the candidate at the first point.
pub(in crate::report) fn is_driven(candidate: &Candidate) -> bool {
    !candidate.defects.contains(&TaskDefect::Unopened)
}

/// Returns a word that says whether the crank turns fully.
pub(in crate::report) fn turns(candidate: &Candidate) -> &'static str {
    match candidate.figures.full_turn {
        true => words().turns_fully_shortly(),
        false => words().swings_shortly(),
    }
}

/// Describes a defect; points are numbered from 1.
fn reason(defect: &TaskDefect) -> String {
    match *defect {
        TaskDefect::Unopened => words().stands_in_dead_point().into(),
        TaskDefect::Branch { from, to } => words().branch_between(from + 1, to + 1),
        TaskDefect::Circuit { from, to } => words().circuit_between(from + 1, to + 1),
        TaskDefect::Order { from, to } => words().order_between(from + 1, to + 1),
        TaskDefect::Short => words().short_of_range().into(),
        TaskDefect::StructuralError => words().misses_its_function().into(),
        TaskDefect::Missed { point } => words().point_missed(point + 1),
        TaskDefect::Far { point } => words().point_far_off(point + 1),
    }
}

pub(in crate::report) fn unmet_text(missed: &[UnmetPreference]) -> String {
    let names: Vec<&str> = missed.iter().map(preference_name).collect();
    match names.is_empty() {
        true => "-".into(),
        false => names.join(", "),
    }
}

/// Returns the name, for programs, of the reason why there are none or why there may be others.
fn reason_name(reason: OpenReason) -> &'static str {
    match reason {
        OpenReason::Range => "range",
        OpenReason::Turn(_) => "turn",
        OpenReason::Shift => "shift",
        OpenReason::GivenNumber => "given",
        OpenReason::NoPair => "pair",
        OpenReason::Far => "far",
        OpenReason::Rounding => "rounding",
    }
}

/// Returns the name of a preference in task files.
pub(in crate::report) fn preference_name(options: &UnmetPreference) -> &'static str {
    match options {
        UnmetPreference::FullTurn => "full-turn",
        UnmetPreference::Transmission => "transmission",
        UnmetPreference::Inside => "inside",
        UnmetPreference::Ratio => "ratio",
        UnmetPreference::Sense => "direction",
    }
}
