//! Writes the check: the residuals of the loops, and the differences between the solution and the
//! solver's state.

use super::context::{Context, Draft};
use super::equations::{LoopSide, Multiplier, pieces};
use super::expression::Expression;
use crate::page::Formula;
use crate::solver::Order;
use crate::wording::words;

/// Writes every loop with all numbers substituted, and the largest difference between the solution
/// and the state.
pub(super) fn check(context: &Context<'_>, draft: &mut Draft) {
    draft.part(words().check_part());
    if !context.has_positions() {
        draft.text(words().nothing_to_check());
        return;
    }
    closure(context, draft);
    super::free_bodies::forces::check(context, draft);
    if let Some(worst) = draft
        .agreements
        .iter()
        .max_by(|a, b| a.part().total_cmp(&b.part()))
    {
        let (part, symbol) = (worst.part(), &worst.symbol);
        // Less than half an epsilon is the rounding error of a value that should be 0.
        let text = if part < f64::EPSILON / 2.0 {
            words().figures_do_not_differ().to_owned()
        } else {
            let part = crate::report::text::number::perpendicular_up(part, 2);
            words().figures_differ(&part, symbol)
        };
        draft.text(text);
    }
}

fn closure(context: &Context<'_>, draft: &mut Draft) {
    let f = context.figures;
    if context.polygon.loops.is_empty() {
        return;
    }
    draft.text(words().left_of_loops());
    for stage in context.stages {
        for &number in &stage.loops {
            let of = &context.polygon.loops[number];
            let is_one = context.polygon.loops.len() == 1;
            for (axis, label) in [(Multiplier::X, "x"), (Multiplier::Y, "y")] {
                let members = of.terms.iter().map(|&term| LoopSide {
                    sought: [false; 2],
                    ..context.member(term, stage)
                });
                let members: Vec<LoopSide<'_>> = members.collect();
                let pieces = pieces(&members, Order::Position, &axis, f);
                let size = pieces
                    .iter()
                    .fold(0.0_f64, |maximum, p| maximum.max(p.value.abs()));
                let sum = Expression::sum(
                    (pieces.iter())
                        .map(|p| Expression::figure(f.format_or_zero(p.value, size), p.value)),
                );
                let left: f64 = pieces.iter().map(|p| p.value).sum();
                draft.equation([
                    match is_one {
                        true => label.into(),
                        false => {
                            let message =
                                |[axis]: [&str; 1]| words().loop_component(number + 1, &axis);
                            Formula::message(message, [label.into()])
                        }
                    },
                    sum.numbers(),
                    match left {
                        0.0 => Formula::zero(),
                        _ => Formula::measured(format!("{left:.1e}"), f.unit),
                    },
                ]);
            }
        }
    }
}
