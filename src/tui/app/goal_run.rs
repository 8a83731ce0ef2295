//! Searches designs for a goal and browses the results.

use crate::report::GoalReport;
use crate::scene::Value;
use crate::study::{
    DesignFigures, DesignSpace, FoundDesign, Goal, GoalSearch, PlanAxis, SearchOutcome,
};
use crate::tui::commands::list::moved;
use crate::tui::document::job::{BackgroundJob, JobProgress};
use crate::tui::figures::format::coordinate;
use crate::wording::words;

/// Number of random starting points in addition to the given design, and their seed, as in
/// `krank solve`.
const STARTS: u32 = 24;
const SEED: u64 = 1;
/// Significant digits of a found value, and decimals in messages.
const DIGITS: i32 = 12;
const DECIMALS: usize = 3;

/// A parsed request for designs that meet goals, with its typed text.
#[derive(Clone, Debug)]
pub(crate) struct GoalRequest {
    pub(super) typed: String,
    pub(super) goals: Vec<Goal>,
    pub(super) axes: Vec<PlanAxis>,
    pub(super) space: DesignSpace,
}

/// The result of a search.
#[derive(Debug)]
pub(super) struct GoalOutcome {
    outcome: SearchOutcome,
    /// Messages on why values are missing for the given design.
    missing_reasons: Vec<String>,
}

/// A search for designs and its result.
#[derive(Debug)]
pub(crate) struct GoalRun {
    pub(super) request: GoalRequest,
    pub(super) job: BackgroundJob<GoalOutcome>,
    /// The index of the selected design.
    cursor: usize,
}

impl GoalRequest {
    /// Searches designs on a number of threads. This may take long.
    pub(super) fn search(&self, threads: usize, progress: &JobProgress) -> GoalOutcome {
        let figures = self.goals.iter().map(|goal| goal.figure.clone());
        let mut figures = DesignFigures::new(&self.space, figures.collect(), None);
        let given = figures.of(&self.space.given()).ok();
        let search = GoalSearch::new(figures, self.goals.clone(), &self.axes);
        let outcome = search.run(STARTS, SEED, threads, &mut |part| progress.report(part));
        let report = GoalReport {
            space: &self.space,
            goals: &self.goals,
            given,
            outcome: &outcome,
        };
        let missing = report.reasons();
        GoalOutcome {
            outcome,
            missing_reasons: missing,
        }
    }
}

impl GoalRun {
    /// Creates a run whose search has just started.
    pub(super) fn new(request: GoalRequest, job: BackgroundJob<GoalOutcome>) -> GoalRun {
        let cursor = 0;
        GoalRun {
            request,
            job,
            cursor,
        }
    }

    /// Returns the progress of the search in percent; `None` once it has finished.
    pub(crate) fn percent(&self) -> Option<u32> {
        self.job.percent()
    }

    /// Returns the number of designs that meet the goal.
    pub(super) fn count(&self) -> usize {
        let found = self.job.result.as_ref();
        found.map_or(0, |found| found.outcome.solutions.len())
    }

    /// Selects the next or previous design, if there is one.
    pub(super) fn step(&mut self, forward: bool) {
        self.cursor = moved(self.cursor, if forward { 1 } else { -1 }, self.count());
    }

    fn chosen(&self) -> Option<&FoundDesign> {
        self.job.result.as_ref()?.outcome.solutions.get(self.cursor)
    }

    /// Returns the scene's values, each with its text in the selected design.
    pub(super) fn texts(&self) -> Option<Vec<(Value, String)>> {
        Some(texts(self.request.space.values(), self.chosen()?))
    }

    /// Describes the selected design in a line: its number, its values, and its motion if that
    /// differs in kind from the given design's.
    pub(crate) fn line(&self) -> Option<String> {
        let text = words().design_of(
            self.cursor + 1,
            self.count(),
            &format_values(&self.texts()?),
        );
        let outcome = &self.job.result.as_ref()?.outcome;
        let family = Some(outcome.freedoms()).filter(|freedoms| *freedoms > 0);
        let family = family.map(|freedoms| words().family_of_designs(freedoms));
        let text = [Some(text), self.motion(), family];
        Some(text.into_iter().flatten().collect::<Vec<_>>().join(" - "))
    }

    /// Describes the motion of the selected design, if its kind differs from the given design's.
    fn motion(&self) -> Option<String> {
        let found = self.chosen().filter(|found| !found.is_same_motion_kind)?;
        let motion = crate::report::motion_text(&found.design.scene, &found.design.solver);
        Some(words().moves_otherwise_as(&motion))
    }

    /// Returns a message that the selected design meets the goal.
    pub(super) fn is_met(&self) -> Option<String> {
        let text = words().goal_is_met(&format_values(&self.texts()?));
        Some(text + &self.motion().map_or(String::new(), |m| format!(" - {m}")))
    }

    /// Returns a message on why there is no design, with the nearest miss.
    pub(super) fn not_met(&self) -> String {
        let Some(found) = &self.job.result else {
            return String::new();
        };
        match &found.outcome.nearest {
            Some(nearest) => {
                let texts = texts(self.request.space.values(), nearest);
                let figures = format_targets(&self.request.goals, nearest);
                words().goal_not_met(&figures, &format_values(&texts))
            }
            None => words().goal_needs_opening(&found.missing_reasons.join("; ")),
        }
    }
}

/// Pairs the scene's values with their texts in a design.
fn texts(values: &[Value], design: &FoundDesign) -> Vec<(Value, String)> {
    let pairs = values.iter().zip(&design.numbers);
    let text =
        |(value, number): (&Value, &f64)| (value.clone(), value.with_number(to_digits(*number)));
    pairs.map(text).collect()
}

/// Formats values and their new texts as a list.
fn format_values(texts: &[(Value, String)]) -> String {
    let all = texts
        .iter()
        .map(|(value, text)| format!("{} {text}", value.name));
    all.collect::<Vec<_>>().join(", ")
}

/// Formats the target quantities of a design that misses its goals.
fn format_targets(goals: &[Goal], design: &FoundDesign) -> String {
    let pairs = goals.iter().zip(&design.figures);
    let figures = pairs.filter_map(|(goal, figure)| {
        let value = coordinate((*figure).ok()?, DECIMALS);
        let text = format!("{} {value} {}", goal.figure.name(), goal.figure.unit());
        Some(text.trim_end().to_owned())
    });
    figures.collect::<Vec<_>>().join(", ")
}

/// Rounds a number to the significant digits of a found value. Smaller changes do not affect a goal.
fn to_digits(number: f64) -> f64 {
    let places = usize::try_from(DIGITS - 1).unwrap_or(0);
    format!("{number:.places$e}").parse().unwrap_or(number)
}
