//! Reports the result of a search for goals, or for the best design.

use crate::page::{Cell, Content, Facts, Page, Table, TextStyle, with_unit};
use crate::quantity::Catalogue;
use crate::report::check::stops_json;
use crate::report::cycle::figure_reason;
use crate::report::text::number::{concise, significant, trimmed};
use crate::report::verdict::motion_text;
use crate::solver::Range;
use crate::study::{
    BestDesign, CycleFigure, Design, DesignSpace, FoundDesign, Goal, NoDesign, NoFigure,
    SearchOutcome,
};
use crate::wording::{Words, english_words, words};
use serde_json::{Map, Value, json};

/// Significant digits of values, and of numbers that must reproduce a goal.
const DIGITS: usize = 7;
const FINE: usize = 12;
/// Maximum number of designs shown next to the given one.
const MAX_SHOWN: usize = 4;

/// The designs that meet goals.
#[derive(Clone, Debug)]
pub struct GoalReport<'a> {
    /// The searched designs.
    pub space: &'a DesignSpace,
    /// The goals.
    pub goals: &'a [Goal],
    /// The values of the given design, goal by goal; `None` if it cannot be opened.
    pub given: Option<Vec<Result<f64, NoFigure>>>,
    /// The result of the search.
    pub outcome: &'a SearchOutcome,
}

impl GoalReport<'_> {
    /// Returns the designs to list: those that meet the goals, or the closest one that does not.
    fn listed_designs(&self) -> impl Iterator<Item = &FoundDesign> {
        self.outcome.solutions.iter().chain(&self.outcome.nearest)
    }

    /// Formats the report as text.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// Returns the goals and the result as a page.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut page = Page::aligned();
        page.title(&self.space.scene().title());
        let mut facts = Facts::default();
        let preferences = self.goals.iter().map(written);
        facts.add(words().to_be_met(), preferences);
        let family = self.outcome.freedoms();
        let family = (family > 0).then(|| words().family_of_designs(family));
        facts.add(
            words().designs_found(),
            std::iter::once(self.verdict()).chain(family),
        );
        facts.add(words().given_lacks(), self.reasons());
        facts.add(words().kind_of_motion(), self.other_motions());
        page.add(Content::Facts(facts));
        page.table(self.table());
        page
    }

    /// Describes the motion of every listed design that differs from that of the given one, and the
    /// given motion.
    fn other_motions(&self) -> Vec<String> {
        let shown = self.listed_designs().take(MAX_SHOWN).zip(self.heads());
        let others = shown.filter(|(found, _)| !found.is_same_motion_kind);
        let others = others.map(|(found, head)| (head, &found.design));
        other_motions(self.space, others)
    }

    /// Returns the reasons why the given design cannot be opened, and why values are missing in it.
    #[must_use]
    pub fn reasons(&self) -> Vec<String> {
        let missing = self.missing_values(words()).into_iter();
        let missing = missing.map(|(name, why)| format!("{name}: {why}"));
        let unopened = self.outcome.open_error.as_ref().map(NoDesign::reason);
        unopened.into_iter().chain(missing).collect()
    }

    /// Returns the missing values of the given design, each with the reason.
    fn missing_values(&self, wording: &dyn Words) -> Vec<(String, String)> {
        let requested = self.goals.iter().map(|goal| &goal.figure);
        missing_values(self.space, requested, self.given.as_deref(), wording)
    }

    fn verdict(&self) -> String {
        let outcome = self.outcome;
        match outcome.solutions.len() {
            0 if outcome.nearest.is_some() => words().none_meets_goals(outcome.starts),
            0 => words().no_design_opens(outcome.starts),
            1 => words().one_design_meets(outcome.starts),
            count => words().designs_meet(count, MAX_SHOWN, outcome.starts),
        }
    }

    /// Returns the column headers of the listed designs.
    fn heads(&self) -> Vec<String> {
        match self.outcome.solutions.is_empty() {
            true => (self.outcome.nearest.iter())
                .map(|_| words().nearest_design().to_owned())
                .collect(),
            false => (1..=self.outcome.solutions.len().min(MAX_SHOWN))
                .map(|n| n.to_string())
                .collect(),
        }
    }

    fn table(&self) -> Table {
        let headers = self.heads();
        let headers = headers.iter().map(String::as_str);
        let designs = self.listed_designs().take(MAX_SHOWN);
        let designs = designs.map(|found| (&*found.numbers, &*found.figures));
        let requested = self.goals.iter().map(|goal| &goal.figure);
        table(
            self.space,
            self.given.as_deref(),
            requested,
            headers.zip(designs),
        )
    }

    /// Returns the whole result for programs.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let design = |found: &FoundDesign| {
            json!({
                "values": named(self.space, &found.numbers),
                "figures": self.figures(&found.figures),
                "distance": found.distance,
                "freedoms": found.freedoms,
                "motion": motion(&found.design, found.is_same_motion_kind),
            })
        };
        json!({
            "scene": self.space.scene().name,
            "goals": self.goals.iter().map(written).collect::<Vec<_>>(),
            "given": named(self.space, &self.space.given()),
            "lacks": Value::Object(
                (self.missing_values(english_words()).into_iter())
                    .map(|(name, why)| (name, json!(why)))
                    .collect()
            ),
            "starts": self.outcome.starts,
            "solutions": self.outcome.solutions.iter().map(design).collect::<Vec<_>>(),
            "nearest": self.outcome.nearest.as_ref().map(design),
        })
    }

    fn figures(&self, found: &[Result<f64, NoFigure>]) -> Value {
        let pairs = self.goals.iter().zip(found);
        let pairs =
            pairs.map(|(goal, value)| (goal.figure.name().to_owned(), json!(value.as_ref().ok())));
        Value::Object(pairs.collect::<Map<_, _>>())
    }
}

/// Returns the missing values of a design, each with the reason.
fn missing_values<'f>(
    space: &DesignSpace,
    requested: impl Iterator<Item = &'f CycleFigure>,
    found: Option<&[Result<f64, NoFigure>]>,
    wording: &dyn Words,
) -> Vec<(String, String)> {
    let driver = Catalogue::new(space.scene()).driver().unit.clone();
    let found = found.unwrap_or_default().iter();
    let missing = requested.zip(found).filter_map(|(figure, value)| {
        let why = value.err()?;
        Some((
            figure.name().to_owned(),
            figure_reason(why, &driver, wording),
        ))
    });
    missing.collect()
}

/// The varied numbers of a design, and the requested values.
type ShownDesign<'d> = (&'d [f64], &'d [Result<f64, NoFigure>]);

/// Returns a table with the given design and others: the varied numbers, then the requested values.
fn table<'d>(
    space: &DesignSpace,
    given: Option<&[Result<f64, NoFigure>]>,
    requested: impl Iterator<Item = &'d CycleFigure>,
    others: impl IntoIterator<Item = (&'d str, ShownDesign<'d>)>,
) -> Table {
    let (headers, designs): (Vec<&str>, Vec<ShownDesign<'_>>) = others.into_iter().unzip();
    let mut table = Table::new("", [words().given_design()].into_iter().chain(headers));
    for (i, value) in space.values().iter().enumerate() {
        let numbers = designs.iter().map(|(numbers, _)| trimmed(numbers[i], FINE));
        let cells = [concise(value.number, FINE)].into_iter().chain(numbers);
        let name = with_unit(&value.dotted(), &value.shown_unit());
        table.row(name, cells.map(Cell::proved));
    }
    for (i, requested) in requested.enumerate() {
        let figures = designs.iter().map(|(_, figures)| figures.get(i));
        let figures = [given.and_then(|given| given.get(i))]
            .into_iter()
            .chain(figures);
        let name = with_unit(requested.name(), requested.unit());
        table.row(name, figures.map(|found| Cell::proved(figure(found))));
    }
    table
}

/// Describes the motions of designs that move differently from the given one, after that of the
/// given one; empty if there are none.
fn other_motions<'d>(
    space: &DesignSpace,
    others: impl Iterator<Item = (String, &'d Design)>,
) -> Vec<String> {
    let text =
        |head: &str, scene, solver| words().motion_of_design(head, &motion_text(scene, solver));
    let mut lines: Vec<String> = others
        .map(|(head, design)| text(&head, &design.scene, &design.solver))
        .collect();
    if !lines.is_empty() {
        let given = text(words().given_design(), space.scene(), space.solver());
        lines.insert(0, given);
    }
    lines
}

/// Returns the range of a design and its stops, for programs.
fn motion(design: &Design, as_given: bool) -> Value {
    let (range, period) = match design.solver.motion().range {
        Range::Full { period } => ([0.0, period], Some(period)),
        Range::Limited { low, high } => ([low, high], None),
    };
    json!({
        "range": range,
        "period": period,
        "stops": stops_json(&design.scene, &design.solver),
        "as_given": as_given,
    })
}

/// Returns the reason why there is no best design: the missing values of the given one.
#[must_use]
pub fn no_best(
    space: &DesignSpace,
    figures: &[CycleFigure],
    given: Option<&[Result<f64, NoFigure>]>,
) -> String {
    let missing = missing_values(space, figures.iter(), given, words()).into_iter();
    let missing = missing.map(|(name, why)| format!("; {name}: {why}"));
    words().keeps_nothing().to_owned() + &missing.collect::<String>()
}

/// The best design.
#[derive(Clone, Debug)]
pub struct BestReport<'a> {
    /// The searched designs.
    pub space: &'a DesignSpace,
    /// The value to optimize.
    pub figure: &'a CycleFigure,
    /// Whether the value was maximized; if not, it was minimized.
    pub greatest: bool,
    /// The constraints.
    pub constraints: &'a [Goal],
    /// The optimized value, then those of the constraints, for the given design; `None` if it
    /// cannot be opened.
    pub given: Option<Vec<Result<f64, NoFigure>>>,
    /// The result of the search.
    pub best: &'a BestDesign,
    /// The optimized value, then those of the constraints, for the best design.
    pub figures: Vec<Result<f64, NoFigure>>,
    /// The best design, opened.
    pub design: &'a Design,
}

impl BestReport<'_> {
    /// Formats the report as text.
    #[must_use]
    pub fn to_text(&self, ascii: bool) -> String {
        self.page().to_text(TextStyle::plain(ascii))
    }

    /// Returns the objective and the result as a page.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut page = Page::aligned();
        page.title(&self.space.scene().title());
        let mut facts = Facts::default();
        let options = match self.greatest {
            true => words().greatest_wished(self.figure.name()),
            false => words().least_wished(self.figure.name()),
        };
        facts.add(words().to_be_best(), [options]);
        facts.add(words().to_be_kept(), self.constraints.iter().map(written));
        let settled = words().generations_made(self.best.generations, self.best.settled);
        let polished = words().polished_best(self.best.stationary);
        facts.add(words().designs_found(), [settled, polished]);
        let head = words().best_design().to_owned();
        let other = (!self.moves_as_given()).then_some((head, self.design));
        let motions = other_motions(self.space, other.into_iter());
        facts.add(words().kind_of_motion(), motions);
        page.add(Content::Facts(facts));
        page.table(self.table());
        page
    }

    fn moves_as_given(&self) -> bool {
        self.design.moves_like(self.space.solver())
    }

    fn table(&self) -> Table {
        let requested = self.constraints.iter().map(|goal| &goal.figure);
        let requested = std::iter::once(self.figure).chain(requested);
        let best = (words().best_design(), (&*self.best.numbers, &*self.figures));
        table(self.space, self.given.as_deref(), requested, [best])
    }

    /// Returns the whole result for programs.
    #[must_use]
    pub fn to_json(&self) -> Value {
        json!({
            "scene": self.space.scene().name,
            "figure": self.figure.name(),
            "sense": if self.greatest { "greatest" } else { "least" },
            "constraints": self.constraints.iter().map(written).collect::<Vec<_>>(),
            "given": named(self.space, &self.space.given()),
            "values": named(self.space, &self.best.numbers),
            "value": self.best.value,
            "missed": self.best.missed,
            "generations": self.best.generations,
            "settled": self.best.settled,
            "stationary": self.best.stationary,
            "motion": motion(self.design, self.moves_as_given()),
        })
    }
}

fn named(space: &DesignSpace, numbers: &[f64]) -> Value {
    let pairs = space.values().iter().zip(numbers);
    let pairs = pairs.map(|(value, number)| (value.dotted(), json!(number)));
    Value::Object(pairs.collect::<Map<_, _>>())
}

/// Formats a goal as typed on the command line.
fn written(goal: &Goal) -> String {
    let number = concise(goal.number, FINE);
    let text = format!("{} {} {number}", goal.figure.name(), goal.sense.sign());
    match goal.figure.unit() {
        "" => text,
        unit => format!("{text} {unit}"),
    }
}

fn figure(found: Option<&Result<f64, NoFigure>>) -> String {
    match found {
        Some(Ok(value)) => significant(*value, DIGITS),
        Some(Err(_)) | None => "-".into(),
    }
}
