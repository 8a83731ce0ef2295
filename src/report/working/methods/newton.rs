//! Writes the table of Newton-Raphson iterations.

use super::super::context::{Context, Draft};
use super::super::equations::{Multiplier, in_figures, pieces, sum};
use super::super::loops::group_unknowns::Stage;
use super::initial_values::{Guesses, format_unknowns};
use super::problem::{LoopProblem, kind};
use crate::page::{Head, Symbol};
use crate::report::error_text;
use crate::solver::{Condition, Order};
use crate::study::{NewtonIteration, NewtonOutcome, NewtonTrace, UnknownKind};
use crate::wording::words;

/// Maximum number of unknowns with a full table; beyond it, only magnitudes of residuals, steps and
/// matrix are shown.
const MAX_FULL_TABLE: usize = 2;
/// Maximum number of unknowns for which a matrix is shown.
const MAX_COLUMNS: usize = 6;

/// Minimum number of steps in which quadratic convergence is visible.
const MIN_STEPS: usize = 3;

/// Iterates a group, and returns the errors if there is an assembly.
pub(super) fn iterate(
    context: &Context<'_>,
    draft: &mut Draft,
    stage: &Stage,
    guesses: &Guesses,
) -> Option<Vec<f64>> {
    let Some(problem) = LoopProblem::of(context, stage) else {
        draft.text(words().not_without_groups_before());
        return None;
    };
    if !problem.system.is_square() {
        let (equations, unknowns) = (2 * problem.system.loops.len(), problem.names.len());
        draft.text(words().not_square(equations, unknowns));
        return None;
    }
    let start = stage.unknowns.iter().map(|&u| (u, guesses.one(context, u)));
    let start: Vec<_> = start.collect();
    let guess: Vec<f64> = start.iter().map(|&(u, v)| inside(kind(u), v)).collect();
    let trace = problem.system.newton(&guess, problem.right.as_deref());
    let is_said = stage
        .unknowns
        .iter()
        .any(|&u| guesses.given_values(u).is_some());
    draft.text(match is_said {
        true => words().begins_at_guess(&format_unknowns(context, &start)),
        false => words().begins_at_start(&format_unknowns(context, &start)),
    });
    let table = IterationTable {
        context,
        problem: &problem,
        trace: &trace,
    };
    table.equations(draft, stage);
    if problem.names.len() <= MAX_FULL_TABLE {
        table.write_coupled_steps(draft);
        table.matrices(draft);
    } else {
        table.sizes(draft);
        table.first_matrix(draft);
    }
    draft.text(table.ends());
    let errors = trace.iterations.iter().filter_map(|i| i.error);
    let errors: Vec<f64> = errors.collect();
    (!errors.is_empty()).then_some(errors)
}

/// Converts degrees to radians for the method; lengths stay unchanged.
pub(super) fn inside(kind: UnknownKind, value: f64) -> f64 {
    match kind {
        UnknownKind::Angle => value.to_radians(),
        UnknownKind::Length => value,
    }
}

/// Converts radians to degrees for display; lengths stay unchanged.
fn outside(kind: UnknownKind, value: f64) -> f64 {
    match kind {
        UnknownKind::Angle => value.to_degrees(),
        UnknownKind::Length => value,
    }
}

struct IterationTable<'a> {
    context: &'a Context<'a>,
    problem: &'a LoopProblem,
    trace: &'a NewtonTrace,
}

impl IterationTable<'_> {
    fn unit(&self, index: usize) -> &'static str {
        self.context
            .figures
            .unit_of(self.problem.system.kinds[index])
    }

    /// Returns the names of the functions: `fx` and `fy`, or `f1x`, `f1y`, `f2x` with several
    /// loops.
    fn functions(&self) -> Vec<Symbol> {
        let loops = self.problem.system.loops.len();
        let of = |number: usize| {
            let number = if loops == 1 {
                String::new()
            } else {
                (number + 1).to_string()
            };
            ["x", "y"].map(|axis| Symbol::indexed("f", format!("{number}{axis}")))
        };
        (0..loops).flat_map(of).collect()
    }

    fn equations(&self, draft: &mut Draft, stage: &Stage) {
        let mut functions = self.functions().into_iter();
        for &number in &stage.loops {
            let members = self
                .context
                .members(&self.context.polygon.loops[number], stage);
            for axis in [Multiplier::X, Multiplier::Y] {
                let pieces = pieces(&members, Order::Position, &axis, self.context.figures);
                let symbols = sum(&pieces).symbols();
                let figures = in_figures(&pieces, self.context.figures);
                draft.equation([
                    functions.next().unwrap_or_default().into(),
                    symbols,
                    figures,
                ]);
            }
        }
    }

    fn values(&self, of: &[f64]) -> Vec<String> {
        let kinds = self.problem.system.kinds.iter();
        let f = self.context.figures;
        let values = kinds.zip(of).map(|(&kind, &v)| f.number(outside(kind, v)));
        values.collect()
    }

    /// Formats a residual; 0 within the rounding error of the longest length.
    fn residual(&self, value: f64) -> String {
        small(value, self.problem.system.longest)
    }

    fn steps(&self, of: &NewtonIteration) -> Vec<String> {
        let kinds = self.problem.system.kinds.iter();
        match &of.step {
            None => kinds.map(|_| "-".to_owned()).collect(),
            Some(step) => kinds
                .zip(step)
                .map(|(&kind, &d)| small(outside(kind, d), 0.0))
                .collect(),
        }
    }

    fn write_coupled_steps(&self, draft: &mut Draft) {
        let head = |name: String, unit: &str| Head {
            name,
            unit: unit.to_owned(),
        };
        let names = || self.problem.names.iter().enumerate();
        let unit = self.context.figures.unit;
        let values = names().map(|(i, name)| head(name.to_string(), self.unit(i)));
        let mut headers: Vec<Head> = values.collect();
        headers.extend(
            self.functions()
                .into_iter()
                .map(|f| head(f.to_string(), unit)),
        );
        headers.extend(names().map(|(i, name)| head(format!("d{name}"), self.unit(i))));
        headers.push(head(words().error_of_iteration().into(), ""));
        let row = |(k, i): (usize, &NewtonIteration)| {
            let mut row = vec![k.to_string()];
            row.extend(self.values(&i.values));
            row.extend(i.residuals.iter().map(|&f| self.residual(f)));
            row.extend(self.steps(i));
            row.push(i.error.map_or_else(|| "-".into(), error_text));
            row
        };
        let rows = self.trace.iterations.iter().enumerate().map(row);
        draft.table_of_units("k", headers, rows.collect());
    }

    /// Writes the matrix of every iteration in one line, in the scene's unit and per rad.
    fn matrices(&self, draft: &mut Draft) {
        draft.text(words().jacobians(self.context.figures.unit));
        let mut head = vec!["k".to_owned()];
        for function in self.functions() {
            let names = self.problem.names.iter();
            head.extend(names.map(|name| format!("d{function}/d{name}")));
        }
        head.push("det J".into());
        let row = |(k, i): (usize, &NewtonIteration)| {
            let size = i
                .jacobian
                .iter()
                .fold(0.0_f64, |maximum, v| maximum.max(v.abs()));
            let f = self.context.figures;
            let mut row = vec![k.to_string()];
            row.extend(i.jacobian.iter().map(|&v| f.format_or_zero(v, size)));
            row.push(f.format_or_zero(i.determinant, size * size));
            row
        };
        let rows = self.trace.iterations.iter().enumerate().map(row);
        draft.wide_table(head, rows.collect());
    }

    /// Writes the iterations for many unknowns: their values, and the magnitudes of the rest.
    fn sizes(&self, draft: &mut Draft) {
        let unit = self.context.figures.unit;
        let mut head = vec!["k".to_owned()];
        head.extend([format!("|f| [{unit}]"), words().largest_step().into()]);
        head.push(words().error_of_iteration().into());
        let names = self.problem.names.iter().enumerate();
        head.extend(names.map(|(i, name)| format!("{name} [{}]", self.unit(i))));
        let row = |(k, i): (usize, &NewtonIteration)| {
            let largest = i
                .residuals
                .iter()
                .fold(0.0_f64, |maximum, f| maximum.max(f.abs()));
            let step = i
                .step
                .as_deref()
                .map(|step| self.problem.system.largest(step));
            let mut row = vec![k.to_string(), self.residual(largest)];
            row.extend([step, i.error].map(|v| v.map_or_else(|| "-".into(), error_text)));
            row.extend(self.values(&i.values));
            row
        };
        let rows = self.trace.iterations.iter().enumerate().map(row);
        draft.wide_table(head, rows.collect());
    }

    fn first_matrix(&self, draft: &mut Draft) {
        let (n, f) = (self.problem.names.len(), self.context.figures);
        if n > MAX_COLUMNS {
            draft.text(words().jacobian_too_large(n));
            return;
        }
        let Some(first) = self.trace.iterations.first() else {
            return;
        };
        draft.text(words().first_jacobian(f.unit));
        let head =
            std::iter::once("J".to_owned()).chain(self.problem.names.iter().map(Symbol::to_string));
        let rows = first
            .jacobian
            .chunks(n)
            .zip(self.functions())
            .map(|(row, name)| {
                let size = row.iter().fold(0.0_f64, |maximum, v| maximum.max(v.abs()));
                let cells = row.iter().map(|&v| f.format_or_zero(v, size));
                std::iter::once(name.to_string()).chain(cells).collect()
            });
        draft.wide_table(head.collect(), rows.collect());
    }

    /// Returns the sentence on the outcome of the iteration.
    fn ends(&self) -> String {
        let steps = self.trace.iterations.len().saturating_sub(1);
        let condition = self.context.state.condition();
        let is_dead = condition == Condition::DeadPoint;
        match self.trace.outcome {
            NewtonOutcome::Found | NewtonOutcome::MinimumError if is_dead => {
                words().newton_at_dead_point(steps)
            }
            // At a change point errors are halved rather than squared.
            NewtonOutcome::Found if steps < MIN_STEPS || condition != Condition::Ok => {
                words().newton_found(steps)
            }
            NewtonOutcome::Found => {
                let found = words().newton_found(steps);
                format!("{found} {}", words().errors_are_squared())
            }
            NewtonOutcome::OtherAssembly if self.problem.right.is_none() => {
                words().newton_closes(steps)
            }
            NewtonOutcome::OtherAssembly => words().newton_other(steps),
            NewtonOutcome::Diverged => words().newton_diverged(steps),
            NewtonOutcome::Singular(_) => words().newton_singular(steps),
            NewtonOutcome::MinimumError => words().newton_unsettled(steps),
        }
    }
}

/// Formats a value that converges to zero: two digits and an exponent are more readable than many
/// zeros.
fn small(value: f64, size: f64) -> String {
    let is_nothing = value.abs() <= 4.0 * f64::EPSILON * size;
    match value.abs() {
        _ if is_nothing || value == 0.0 => "0".into(),
        0.1..1e5 => format!("{value:.4}"),
        _ => format!("{value:.1e}"),
    }
}
