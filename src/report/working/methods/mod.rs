//! Solutions by a chosen method: the closed form, or by hand as in a lecture, with every iteration.

mod bisection;
mod construction;
mod drawing_scale;
mod initial_values;
mod newton;
mod problem;
mod reduced;

pub use initial_values::{Guess, GuessError};
pub(super) use problem::kind;

use super::context::{Context, Draft};
use super::loops::group_unknowns::{ProblemForm, Stage};
use super::{Working, WorkingNotation, introduction};
use crate::page::Page;
use crate::scene::Scene;
use crate::solver::{Solver, State};
use crate::study::ErrorCurve;
use crate::wording::words;
use initial_values::Guesses;

/// A method for positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PositionMethod {
    /// The cosine theorem, or the quadratic of a guide.
    Closed,
    /// The Newton-Raphson method on the loop equations.
    Newton,
    /// Bisection of an interval of one unknown.
    Bisection,
    /// Construction with compass and ruler.
    Graphical,
}

/// A solution by a method.
#[derive(Clone, Debug)]
pub struct WorkedMethod {
    /// The page.
    pub page: Page,
    /// The errors of every iterated group.
    pub curves: Vec<ErrorCurve>,
}

impl Working {
    /// Writes the solution of a state by a method, starting from the guesses.
    ///
    /// # Errors
    /// Returns a message for a guess that does not fit the scene.
    pub fn by(
        &self,
        method: PositionMethod,
        (scene, solver, state): (&Scene, &Solver, &State),
        guesses: &[Guess],
        digits: usize,
        notation: WorkingNotation,
    ) -> Result<WorkedMethod, String> {
        let mut context = self.context(scene, solver, state, digits);
        context.notation = notation;
        let guesses = Guesses::new(&context, method, guesses)?;
        if method == PositionMethod::Closed {
            let page = self.written(scene, solver, state, digits, notation).page;
            return Ok(WorkedMethod::of(page));
        }
        let mut draft = Draft::default();
        introduction::heading(&context, &mut draft);
        introduction::polygons(&context, &mut draft);
        draft.part(method.title());
        draft.text(method.how());
        Ok(method.work(&context, draft, &guesses))
    }

    /// Writes only the steps of a method at a state, starting from the guesses.
    ///
    /// # Errors
    /// Returns a message for a guess that does not fit the scene.
    pub fn watched(
        &self,
        method: PositionMethod,
        (scene, solver, state): (&Scene, &Solver, &State),
        guesses: &[Guess],
        digits: usize,
    ) -> Result<WorkedMethod, String> {
        let context = self.context(scene, solver, state, digits);
        let guesses = Guesses::new(&context, method, guesses)?;
        let mut draft = Draft::default();
        draft.part(method.title());
        Ok(method.work(&context, draft, &guesses))
    }
}

impl WorkedMethod {
    fn of(page: Page) -> WorkedMethod {
        let curves = Vec::new();
        WorkedMethod { page, curves }
    }
}

impl PositionMethod {
    /// Returns `true` for a method that starts from a guess.
    #[must_use]
    pub fn takes_guess(self) -> bool {
        matches!(self, PositionMethod::Newton | PositionMethod::Bisection)
    }

    /// The methods shown in turn in the workbench; the closed form has a view of its own.
    pub const WATCHED: [PositionMethod; 3] = [
        PositionMethod::Newton,
        PositionMethod::Bisection,
        PositionMethod::Graphical,
    ];

    /// Returns the title.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            PositionMethod::Closed => words().closed_form(),
            PositionMethod::Newton => words().newton_raphson(),
            PositionMethod::Bisection => words().bisection_title(),
            PositionMethod::Graphical => words().by_drawing(),
        }
    }

    fn how(self) -> &'static str {
        match self {
            PositionMethod::Closed => words().closed_form_is(),
            PositionMethod::Newton => words().newton_how(),
            PositionMethod::Bisection => words().bisection_how(),
            PositionMethod::Graphical => words().drawing_how(),
        }
    }

    /// Applies the method group by group.
    fn work(self, context: &Context<'_>, mut draft: Draft, guesses: &Guesses) -> WorkedMethod {
        if self == PositionMethod::Graphical {
            construction::construct(context, &mut draft);
            return WorkedMethod::of(draft.page);
        }
        let mut curves = Vec::new();
        for stage in groups_with_unknowns(context) {
            draft.section(heading(context, stage));
            let errors = match self {
                PositionMethod::Bisection => bisection::halve(context, &mut draft, stage, guesses),
                _ => newton::iterate(context, &mut draft, stage, guesses),
            };
            let mark = mark(context, stage);
            curves.extend(errors.map(|errors| ErrorCurve { mark, errors }));
        }
        if groups_with_unknowns(context).next().is_none() {
            draft.text(words().nothing_sought());
        }
        let page = draft.page;
        WorkedMethod { page, curves }
    }
}

/// Returns the groups with unknowns, in solution order.
fn groups_with_unknowns<'a>(context: &Context<'a>) -> impl Iterator<Item = &'a Stage> + use<'a> {
    let is_sought = |stage: &&Stage| {
        stage.group.is_some()
            && !matches!(stage.form, ProblemForm::Nothing)
            && !stage.unknowns.is_empty()
    };
    context.stages.iter().filter(is_sought)
}

fn heading(context: &Context<'_>, stage: &Stage) -> String {
    stage
        .group
        .map_or_else(String::new, |group| context.group_text(group))
}

/// Returns the mark of a group's errors in a chart: its number, or a star if there is only one
/// group.
fn mark(context: &Context<'_>, stage: &Stage) -> char {
    if groups_with_unknowns(context).count() == 1 {
        return '*';
    }
    let number = stage.group.map_or(0, |group| group + 1);
    let digit = u32::try_from(number)
        .ok()
        .and_then(|n| char::from_digit(n, 36));
    digit.unwrap_or('#')
}
