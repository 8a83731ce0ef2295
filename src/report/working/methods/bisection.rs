//! Writes the table of a bisection.

use super::super::context::{Context, Draft};
use super::super::loops::group_unknowns::{ProblemForm, Stage};
use super::super::loops::solution::Solution;
use super::initial_values::Guesses;
use super::reduced::{ReducedLoop, figure, function_of};
use crate::page::Formula;
use crate::report::error_text;
use crate::study::{Bisection, UnknownKind};
use crate::wording::words;

/// Bisects an interval of one unknown of a group, and returns the errors of the midpoints; `None`
/// without a bisection or an assembly.
pub(super) fn halve(
    context: &Context<'_>,
    draft: &mut Draft,
    stage: &Stage,
    guesses: &Guesses,
) -> Option<Vec<f64>> {
    let solution = Solution::new(context, stage).filter(|_| has_form(stage));
    let Some(solution) = solution else {
        draft.text(reason_against(stage));
        return None;
    };
    if !context.has_positions() && !solution.is_known() {
        draft.text(words().not_without_groups_before());
        return None;
    }
    let reduced = solution.reduced(draft, stage)?;
    let f = context.figures;
    let others = stage.unknowns.iter();
    let mut others = others.filter(|unknown| **unknown != reduced.unknown);
    if others.any(|unknown| guesses.given_values(*unknown).is_some()) {
        draft.text(words().guess_of_removed(&reduced.symbol));
    }
    let [a, b] = start_interval(&reduced, guesses);
    let size = match reduced.kind {
        UnknownKind::Angle => 180.0,
        UnknownKind::Length => reduced.reach,
    };
    let places = i32::try_from(f.digits).unwrap_or(i32::MAX);
    let finest = size * 10.0_f64.powi(-places);
    let halved = Bisection::of(a, b, finest, |x| reduced.value(x));
    let unit = f.unit_of(reduced.kind);
    let [from, to] = [a, b].map(|v| Formula::measured(f.angle(v), unit));
    let largest = context.longest.powi(2);
    let [low, high] = halved.ends.map(|v| f.area_or_zero(v, largest));
    let is_said = guesses.given_values(reduced.unknown).is_some();
    if !is_said {
        draft.text(describe_minimum(context, &reduced));
    }
    draft.text(words().between_ends(&reduced.symbol, &from, &to));
    draft.equation([function_of(from), low]);
    draft.equation([function_of(to), high]);
    if let (Some(right), false) = (reduced.right, is_said)
        && reduced.are_one(right)
    {
        write_end_root(context, draft, &reduced, [a, b]);
        return None;
    }
    if halved.root().is_none() {
        draft.text(words().no_change_of_sign());
        return None;
    }
    let finest = f.angle(finest);
    // A bound is not a computed value, so it has no trailing zeros.
    let finest = match finest.contains('e') || !finest.contains('.') {
        true => finest.as_str(),
        false => finest.trim_end_matches('0'),
    };
    let finest = format!("{finest} {unit}");
    draft.text(words().halved_until(&finest));
    table(draft, context, &reduced, &halved, unit);
    conclude(context, draft, &reduced, &halved);
    let longest = context.longest;
    let errors = halved
        .halvings
        .iter()
        .map(|h| reduced.error(h.middle, longest));
    errors.collect()
}

/// Describes the minimum of f, with a root on either side.
fn describe_minimum(context: &Context<'_>, reduced: &ReducedLoop) -> String {
    let [middle, _] = reduced.interval(None);
    let (f, symbol) = (context.figures, &reduced.symbol);
    match reduced.along {
        Some(m) => words().least_along(m, symbol, &format!("{} deg", f.angle(middle))),
        None => words().least_at(symbol, &figure(f, reduced.kind, middle)),
    }
}

/// Writes the result for an interval that begins or ends at the only root.
fn write_end_root(
    context: &Context<'_>,
    draft: &mut Draft,
    reduced: &ReducedLoop,
    [a, b]: [f64; 2],
) {
    let (root, name) = match reduced.value(a).abs() <= reduced.value(b).abs() {
        true => (a, "a"),
        false => (b, "b"),
    };
    draft.text(words().root_at_an_end(name));
    write_root(context, draft, reduced, root);
    draft.text(words().assemblies_are_one());
}

fn write_root(context: &Context<'_>, draft: &mut Draft, reduced: &ReducedLoop, root: f64) {
    let f = context.figures;
    draft.equation([reduced.symbol.clone().into(), figure(f, reduced.kind, root)]);
    let (symbol, formula) = &reduced.other;
    let follows = figure(f, UnknownKind::Angle, reduced.follows(root));
    draft.equation([symbol.into(), formula.symbols(), follows]);
}

fn has_form(stage: &Stage) -> bool {
    matches!(
        stage.form,
        ProblemForm::Triangle(..) | ProblemForm::Quadratic(..) | ProblemForm::Swing(..)
    )
}

fn reason_against(stage: &Stage) -> String {
    match stage.form {
        ProblemForm::Guides(..) => words().two_guides_are_linear().into(),
        _ => words().nothing_to_halve(stage.unknowns.len()),
    }
}

/// Returns the given interval, the one around a given value, or the one that contains the assembly.
fn start_interval(reduced: &ReducedLoop, guesses: &Guesses) -> [f64; 2] {
    match guesses.given_values(reduced.unknown) {
        None => reduced.interval(reduced.right),
        Some([from, to]) if from == to => {
            let (at, half) = (from + reduced.ahead, reduced.reach / 2.0);
            [at - half, at + half]
        }
        Some(between) => between.map(|v| v + reduced.ahead),
    }
}

fn table(
    draft: &mut Draft,
    context: &Context<'_>,
    reduced: &ReducedLoop,
    halved: &Bisection,
    unit: &str,
) {
    let f = context.figures;
    let head = ["a", "b"].map(|end| format!("{end} [{unit}]"));
    let middle = format!("{} [{unit}]", words().middle_of_interval());
    let value = format!("f [{}^2]", f.unit);
    let error = words().error_of_iteration();
    let rows = (0_usize..).zip(&halved.halvings).map(|(k, h)| {
        let [a, b, middle] = [h.a, h.b, h.middle].map(|v| f.number(v));
        let error = reduced.error(h.middle, context.longest);
        let error = error.map_or_else(|| "-".into(), error_text);
        [k.to_string(), a, b, middle, f.number(h.value), error]
    });
    let [a, b] = head;
    draft.table(["k", &a, &b, &middle, &value, error], rows.collect());
}

/// Writes the root, the other unknown that follows from it, and the assembly.
fn conclude(context: &Context<'_>, draft: &mut Draft, reduced: &ReducedLoop, halved: &Bisection) {
    let (f, Some(root)) = (context.figures, halved.root()) else {
        return;
    };
    draft.text(words().halved(halved.halvings.len().saturating_sub(1)));
    write_root(context, draft, reduced, root);
    let Some(right) = reduced.right else {
        return;
    };
    if reduced.are_one(right) {
        draft.text(words().assemblies_are_one());
        return;
    }
    let is_right = reduced.is_same_side(root, right);
    let [from, to] = reduced.interval(Some(2.0 * reduced.middle - root));
    let [from, to] = [from, to].map(|v| figure(f, reduced.kind, v));
    draft.text(match is_right {
        true => words().holds_the_assembly(&from, &to),
        false => words().holds_the_other(&from, &to),
    });
}
