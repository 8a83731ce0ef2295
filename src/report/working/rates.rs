//! Writes velocities and accelerations: the differentiated loop equations, multiplied by the unit
//! vector that eliminates one unknown, and solved with numbers.

use super::context::{Context, Draft};
use super::equations::{
    Heading, LoopSide, Multiplier, coefficient, in_figures, known, longest, pieces, solved_for, sum,
};
use super::expression::Expression;
use super::loops::group_unknowns::{LoopUnknown, ProblemForm, Stage};
use super::loops::sides::{SideShape, Turns};
use super::methods::kind;
use super::positions::loop_heading;
use super::symbols;
use crate::page::{Formula, Symbol};
use crate::report::Entry;
use crate::solver::{Condition, Order};
use crate::study::UnknownKind;
use crate::wording::words;
use crate::{Input, LinkId, Vec2, angle};

/// Writes velocities or accelerations.
pub(super) fn rates(context: &Context<'_>, draft: &mut Draft, order: Order) {
    draft.part(match order {
        Order::Velocity => words().velocities_part(),
        _ => words().accelerations_part(),
    });
    if let Some(text) = opening_text(context, order) {
        draft.text(text);
    }
    for stage in context.stages {
        for &number in &stage.loops {
            let of = &context.polygon.loops[number];
            loop_heading(context, draft, number, of);
            let members = context.members(of, stage);
            components(context, draft, &members, order);
        }
        if !stage.loops.is_empty() && context.has_rates() {
            solve(context, draft, stage, order);
        }
    }
    if context.has_rates() {
        table(context, draft, order);
    }
}

fn opening_text(context: &Context<'_>, order: Order) -> Option<&'static str> {
    let is_first = order == Order::Velocity;
    match context.state.condition() {
        Condition::Ok if is_first => Some(words().differentiated()),
        Condition::Ok => Some(words().differentiated_again()),
        Condition::ChangePoint => Some(words().rates_are_limits()),
        Condition::DeadPoint if is_first => Some(words().no_rates_at_dead_point()),
        Condition::DeadPoint => Some(words().do_not_exist_either()),
        Condition::NoAssembly if is_first => Some(words().none_without_assembly()),
        Condition::NoAssembly => Some(words().differentiated_again()),
    }
}

/// Writes both components, in symbols and evaluated.
pub(super) fn components(
    context: &Context<'_>,
    draft: &mut Draft,
    members: &[LoopSide<'_>],
    order: Order,
) {
    let f = context.figures;
    let both = [Multiplier::X, Multiplier::Y].map(|axis| pieces(members, order, &axis, f));
    for pieces in &both {
        draft.write_zero(sum(pieces).symbols());
    }
    if order == Order::Position || context.has_rates() {
        for pieces in &both {
            draft.write_zero(in_figures(pieces, f));
        }
    }
}

fn solve(context: &Context<'_>, draft: &mut Draft, stage: &Stage, order: Order) {
    match stage.form {
        ProblemForm::Nothing => draft.text(words().nothing_sought_in_it()),
        ProblemForm::System => together(context, draft, stage, order),
        ProblemForm::Triangle(..)
        | ProblemForm::Quadratic(..)
        | ProblemForm::Swing(..)
        | ProblemForm::Guides(..)
        | ProblemForm::Sum(_) => {
            if let [first, second] = stage.unknowns[..] {
                removed(context, draft, stage, order, first, second);
                removed(context, draft, stage, order, second, first);
            }
        }
    }
}

/// Solves for one unknown, with the other one eliminated.
fn removed(
    context: &Context<'_>,
    draft: &mut Draft,
    stage: &Stage,
    order: Order,
    unknowns: LoopUnknown,
    other: LoopUnknown,
) {
    let Some(&number) = stage.loops.first() else {
        return;
    };
    let of = &context.polygon.loops[number];
    let members = context.members(of, stage);
    let symbol = context.symbol(unknowns, order);
    let other_symbol = context.symbol(other, order);
    let Some(axis) = removing(&members, other) else {
        return;
    };
    let mut pieces = pieces(&members, order, &axis, context.figures);
    // The vector of several sides that rotate together is parallel to the axis only as a sum.
    pieces.retain(|piece| piece.unknown.as_ref() != Some(&other_symbol));
    let (known, factor) = (known(&pieces), coefficient(&pieces, &symbol));
    let solved = rate_value(context, unknowns, order);
    let unit = context.figures.rate_unit(kind(unknowns), order);
    let f = context.figures;
    draft.text(words().multiplied_by(&axis.name(context.notation), &other_symbol));
    draft.write_zero(sum(&pieces).symbols());
    let computed = -known / factor;
    let size = pieces.iter().fold(0.0_f64, |maximum, p| match p.unknown {
        Some(_) => maximum,
        None => maximum.max(p.size),
    });
    let longest = longest(&members);
    // At a singular position, the quotient of two rounding errors has no meaning.
    let sine = match unknowns {
        LoopUnknown::Angle(_) | LoopUnknown::Direction(_) => factor.abs() / longest,
        LoopUnknown::Travel(_) | LoopUnknown::Length(_) => factor.abs(),
    };
    if context.state.condition() == Condition::ChangePoint || sine < SINGULAR {
        draft.write_zero(sum(&pieces).numbers());
        draft.write_zero(in_figures(&pieces, f));
        draft.text(words().factor_vanishes(&symbol));
        draft.equation([symbol.into(), Formula::measured(f.number(solved), &unit)]);
        return;
    }
    draft.write_zero(in_figures(&pieces, f));
    draft.agree(
        &symbol,
        computed,
        solved,
        size / factor.abs() * (1.0 + 1.0 / sine),
    );
    let shown = f.format_or_zero(computed, size / factor.abs());
    let quotient = solved_for(&pieces, &symbol);
    draft.equation([
        symbol.into(),
        quotient.symbols(),
        quotient.numbers(),
        Formula::measured(shown, &unit),
    ]);
}

/// Minimum sine of the angle between both directions. Below it, the printed quotient loses half its
/// digits.
const SINGULAR: f64 = 1e-7;

/// Returns the multiplier that eliminates an unknown's rate from the equation.
fn removing(members: &[LoopSide<'_>], unknown: LoopUnknown) -> Option<Multiplier> {
    let is_of = |member: &&LoopSide<'_>| match unknown {
        LoopUnknown::Angle(link) => member.side.turns_with() == Some(link),
        LoopUnknown::Travel(slide) => member.side.shape == SideShape::Slide(slide),
        LoopUnknown::Length(_) | LoopUnknown::Direction(_) => member.side.turns == Turns::Freely,
    };
    let own: Vec<&LoopSide<'_>> = members.iter().filter(is_of).collect();
    match unknown {
        LoopUnknown::Travel(_) | LoopUnknown::Length(_) => {
            own.first().map(|m| Multiplier::Across(Heading::of(m)))
        }
        LoopUnknown::Angle(_) | LoopUnknown::Direction(_) => match own[..] {
            [one] => Some(Multiplier::Along(Heading::of(one))),
            _ => Some(Multiplier::Along(together_heading(&own)?)),
        },
    }
}

/// Returns the direction of the sum of sides that rotate together; `None` if the sum is zero.
fn together_heading(own: &[&LoopSide<'_>]) -> Option<Heading> {
    let sum = own.iter().fold(Vec2::ZERO, |sum, m| sum + m.vector());
    let size = sum.norm();
    if !(size > 0.0) {
        return None;
    }
    let name: Vec<&str> = own.iter().map(|m| m.side.name.as_str()).collect();
    Some(Heading {
        symbol: Symbol::separate("θ", name.join("_")),
        degrees: angle::degrees(sum),
        u: sum / size,
        open: false,
    })
}

/// Writes the solution of several coupled loops: the equations above are solved together.
fn together(context: &Context<'_>, draft: &mut Draft, stage: &Stage, order: Order) {
    let count = stage.unknowns.len();
    let elbows = stage.elbows(&context.scene.mechanism, context.polygon);
    let equations = 2 * stage.loops.len() + elbows.len();
    draft.text(words().equations_for_unknowns(equations, count));
    self::elbows(context, draft, stage, order);
    for &unknown in &stage.unknowns {
        let symbol = context.symbol(unknown, order);
        let value = rate_value(context, unknown, order);
        let unit = context.figures.rate_unit(kind(unknown), order);
        let value = Formula::measured(context.figures.number(value), &unit);
        draft.equation([symbol.into(), value]);
    }
}

/// Writes the equations of inputs between links with unknown angles: the difference of the angles
/// is given.
pub(super) fn elbows(context: &Context<'_>, draft: &mut Draft, stage: &Stage, order: Order) {
    let mechanism = &context.scene.mechanism;
    let driver = mechanism.driver();
    for [link, from] in stage.elbows(mechanism, context.polygon) {
        let symbol =
            |link: LinkId| Expression::symbol(symbols::angle(context.scene.link_name(link), order));
        let timed = mechanism.timed_input(Input::Turn(link));
        let at = context.state.at();
        let [first, second] = timed.map_or([1.0, 0.0], |timed| timed.rates(at, driver.input));
        let speed = context.state.driver_speed();
        let given = match order {
            Order::Position => timed.map_or(at, |timed| timed.coordinate(at)),
            Order::Velocity => speed * first,
            _ => context.state.driver_acceleration() * first + speed * speed * second,
        };
        let unit = context.figures.rate_unit(UnknownKind::Angle, order);
        let difference = symbol(link) - symbol(from);
        let given = Formula::measured(context.figures.given(given), &unit);
        draft.equation([difference.symbols(), given]);
    }
}

fn rate_value(context: &Context<'_>, unknown: LoopUnknown, order: Order) -> f64 {
    let first = order == Order::Velocity;
    let state = context.state;
    match unknown {
        LoopUnknown::Angle(link) if first => state.omega(link),
        LoopUnknown::Angle(link) => state.alpha(link),
        LoopUnknown::Travel(slide) if first => state.travel(slide).rate,
        LoopUnknown::Travel(slide) => state.travel(slide).accel,
        LoopUnknown::Length(side) => context.readings[side].length(order),
        LoopUnknown::Direction(side) => context.readings[side].angle(order),
    }
}

/// Writes the table of velocities or accelerations; the latter also says which rates increase in
/// magnitude.
fn table(context: &Context<'_>, draft: &mut Draft, order: Order) {
    let f = context.figures;
    let first = order == Order::Velocity;
    let mut rows = Vec::new();
    for (side, r) in context.polygon.sides.iter().zip(&context.readings) {
        let length = (r.length(order), r.rate);
        let turning = (r.angle(order), r.omega);
        let sliding = word_of(length, context, order);
        let [_, r, turning_text, word] =
            table_row(context, &side.name, Some(length), turning, order);
        let own = |is: bool, value: f64, text| if is { f.given(value) } else { text };
        let r = own(context.schedule.is_pushed(side), length.0, r);
        let turning_text = own(context.schedule.is_driven(side), turning.0, turning_text);
        rows.push(([side.name.clone(), r, turning_text, word], sliding));
    }
    let mechanism = &context.scene.mechanism;
    let without_ends = |link: &LinkId| mechanism.link(*link).ends.is_none();
    for link in mechanism.link_ids().filter(without_ends) {
        let (omega, alpha) = (context.state.omega(link), context.state.alpha(link));
        let turning = (if first { omega } else { alpha }, omega);
        let name = context.scene.link_name(link);
        let row = table_row(context, name, None, turning, order);
        rows.push((row, ""));
    }
    let length = f.rate_unit(UnknownKind::Length, order);
    if first {
        let rows = rows
            .into_iter()
            .map(|([name, length, turning, _], _)| [name, length, turning]);
        let length = format!("dr/dt [{length}]");
        draft.table([words().vector(), &length, "ω [rad/s]"], rows.collect());
        return;
    }
    let length = format!("d2r/dt2 [{length}]");
    if rows.iter().all(|(_, sliding)| sliding.is_empty()) {
        let rows = rows.into_iter().map(|(row, _)| row).collect();
        let vector = words().vector();
        draft.table([vector, &length, "α [rad/s^2]", words().turning()], rows);
        return;
    }
    let rows = rows
        .into_iter()
        .map(|([name, r, alpha, turning], sliding)| [name, r, sliding.to_owned(), alpha, turning]);
    draft.table(
        [
            words().vector(),
            &length,
            words().sliding(),
            "α [rad/s^2]",
            words().turning(),
        ],
        rows.collect(),
    );
}

fn table_row(
    context: &Context<'_>,
    name: &str,
    length: Option<(f64, f64)>,
    (value, rate): (f64, f64),
    order: Order,
) -> [String; 4] {
    let length = length.map_or_else(|| "-".into(), |(value, _)| format_value(context, value));
    let turning = word_of((value, rate), context, order);
    let value = format_value(context, value);
    [name.to_owned(), length, value, turning.to_owned()]
}

/// Formats a value of a table: rounding errors become 0, as in the other tables.
fn format_value(context: &Context<'_>, value: f64) -> String {
    let entry = Entry {
        value: Some(value),
        given: false,
        bound: None,
    };
    context.figures.number(entry.display_value().unwrap_or(0.0))
}

/// Returns the word for whether a rate increases or decreases in magnitude, from its derivative and
/// its value.
fn word_of((value, rate): (f64, f64), context: &Context<'_>, order: Order) -> &'static str {
    let is_zero = |value| format_value(context, value) == "0";
    if order == Order::Velocity || is_zero(rate) || is_zero(value) {
        ""
    } else if (value < 0.0) == (rate < 0.0) {
        words().speeds_up()
    } else {
        words().slows_down()
    }
}
