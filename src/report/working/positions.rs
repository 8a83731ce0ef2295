//! Writes the positions: the loop equations in components and projected, and each group's solution
//! by the formula of its form, with all intermediate values.

use super::context::{Context, Draft};
use super::equations::{Heading, LoopSide, Multiplier, in_figures, pieces, sum};
use super::introduction::sum_text;
use super::loops::group_unknowns::{ProblemForm, Stage};
use super::loops::polygon::{Loop, Term};
use super::loops::solution::Solution;
use crate::solver::Order;
use crate::wording::words;

/// Writes the equations of every loop.
pub(super) fn equations(context: &Context<'_>, draft: &mut Draft) {
    if context.polygon.loops.is_empty() {
        return;
    }
    draft.part(words().loop_equations());
    for stage in context.stages {
        for &number in &stage.loops {
            let of = &context.polygon.loops[number];
            loop_heading(context, draft, number, of);
            let members = context.members(of, stage);
            super::rates::components(context, draft, &members, Order::Position);
            projected(context, draft, stage, &members);
            super::collected_terms::collected(context, draft, number, stage);
        }
        super::rates::elbows(context, draft, stage, Order::Position);
    }
}

pub(super) fn loop_heading(context: &Context<'_>, draft: &mut Draft, number: usize, of: &Loop) {
    let sum = sum_text(context, of);
    if context.polygon.loops.len() > 1 {
        let equation = format!("{sum} = 0");
        draft.section(words().loop_is(number + 1, &equation));
    }
}

/// Writes the equations multiplied by unit vectors that eliminate one side each.
fn projected(context: &Context<'_>, draft: &mut Draft, stage: &Stage, members: &[LoopSide<'_>]) {
    let removed: Vec<Term> = match &stage.form {
        ProblemForm::Triangle(a, b) => [a, b].into_iter().filter_map(|arm| single(arm)).collect(),
        ProblemForm::Quadratic(_, slide) => vec![*slide],
        ProblemForm::Guides(a, b) => vec![*a, *b],
        ProblemForm::Swing(..)
        | ProblemForm::Sum(_)
        | ProblemForm::Nothing
        | ProblemForm::System => Vec::new(),
    };
    for term in removed {
        let own = context.member(term, stage);
        let axis = Multiplier::Across(Heading::of(&own));
        let pieces = pieces(members, Order::Position, &axis, context.figures);
        let across = axis.name(context.notation);
        draft.text(words().multiplied_across(&across, &own.side.name));
        let figures = in_figures(&pieces, context.figures);
        draft.write_zero(sum(&pieces).symbols());
        draft.write_zero(figures);
    }
}

pub(super) fn single(arm: &[Term]) -> Option<Term> {
    match *arm {
        [term] => Some(term),
        _ => None,
    }
}

/// Writes the solution of every group, in the plan's order.
pub(super) fn solutions(context: &Context<'_>, draft: &mut Draft) {
    draft.part(words().positions_by_groups());
    for stage in context.stages {
        match stage.group {
            Some(number) => {
                let text = context.group_text(number);
                draft.section(text);
            }
            None => {
                let side = stage
                    .loops
                    .iter()
                    .filter_map(|&l| context.polygon.loops[l].terms.first());
                let names: Vec<&str> = side
                    .map(|t| context.polygon.sides[t.side].name.as_str())
                    .collect();
                draft.section(words().the_vector(&names.join(", ")));
            }
        }
        solve(context, draft, stage);
        if context.has_positions() {
            super::loops::by_coordinates::found(context, draft, stage);
        }
    }
}

fn solve(context: &Context<'_>, draft: &mut Draft, stage: &Stage) {
    let Some(solution) = Solution::new(context, stage) else {
        return without_loop(context, draft, stage);
    };
    let is_found = context.has_positions() || solution.is_known();
    if !is_found && !matches!(stage.form, ProblemForm::Nothing) {
        draft.text(words().not_without_groups_before());
        return;
    }
    match &stage.form {
        ProblemForm::Nothing => repeated(draft),
        ProblemForm::Triangle(a, b) => solution.triangle(draft, a, b),
        ProblemForm::Quadratic(arm, slide) => solution.quadratic(draft, arm, *slide),
        ProblemForm::Swing(arm, slide) => solution.swing(draft, arm, *slide),
        ProblemForm::Guides(a, b) => solution.guides(draft, *a, *b),
        ProblemForm::Sum(term) => solution.sum(draft, *term),
        ProblemForm::System => super::coupled::position(context, draft, stage),
    }
}

/// Writes that a group's loop has no unknowns.
fn repeated(draft: &mut Draft) {
    draft.text(words().loop_repeats_others());
}

/// Writes the driver's group, and groups without a loop.
fn without_loop(context: &Context<'_>, draft: &mut Draft, stage: &Stage) {
    if matches!(stage.form, ProblemForm::System) {
        return super::coupled::position(context, draft, stage);
    }
    let Some(group) = stage
        .group
        .and_then(|number| context.solver.plan().groups.get(number))
    else {
        return;
    };
    let mut rows = Vec::new();
    if context.has_positions() {
        for &point in &group.points {
            let Some(name) = context.scene.point_name(point) else {
                continue;
            };
            let at = context.state.position(point);
            let size = at.norm();
            let figure = |v: f64| context.figures.format_or_zero(v, size);
            rows.push([name.to_owned(), figure(at.x), figure(at.y)]);
        }
    }
    if stage.loops.is_empty() && rows.is_empty() {
        draft.text(words().nothing_sought());
    } else if stage.loops.is_empty() {
        draft.text(words().driver_places());
    } else {
        repeated(draft);
    }
    if !rows.is_empty() {
        let unit = context.figures.unit;
        draft.table(
            [
                words().point(),
                &format!("x [{unit}]"),
                &format!("y [{unit}]"),
            ],
            rows,
        );
    }
}
