//! A coupled group: its unknowns, and what the last step of Newton's method had before it.

use super::draft::{Context, Draft};
use super::stages::Stage;
use super::symbols;
use crate::PointId;
use crate::solver::{Newton, NewtonRow, NewtonUnknown};
use crate::wording::words;

/// More unknowns than this make a matrix that nobody reads.
const MOST_COLUMNS: usize = 12;

/// Positions of a group that is solved at once.
pub(super) fn position(context: &Context<'_>, draft: &mut Draft, stage: &Stage) {
    let newton = context.solver.newton(&context.state);
    let own = newton
        .into_iter()
        .find(|newton| Some(newton.group.index()) == stage.group);
    match own {
        Some(newton) => last_step(context, draft, &newton),
        None if context.has_positions() => solved(context, draft, stage),
        None => draft.page.text(words().solved_at_once()),
    }
}

/// What is sought, where it stands and what is left of every equation, then the matrix.
fn last_step(context: &Context<'_>, draft: &mut Draft, newton: &Newton) {
    let f = context.figures;
    draft.page.text(words().no_part_alone());
    let names: Vec<String> = newton
        .unknowns
        .iter()
        .map(|&u| unknown_name(context, u))
        .collect();
    for ((unknown, name), value) in newton.unknowns.iter().zip(&names).zip(&newton.values) {
        let figure = f.number(*value);
        draft.page.equation([
            name.clone(),
            match unknown {
                NewtonUnknown::X(_) | NewtonUnknown::Y(_) => format!("{figure} {}", f.unit),
                NewtonUnknown::Angle(_) => {
                    format!("{figure} rad = {} deg", f.direction(value.to_degrees()))
                }
            },
        ]);
    }
    draft.page.text(words().equations_left());
    for (i, (row, left)) in newton.rows.iter().zip(&newton.residuals).enumerate() {
        let (text, unit) = row_text(context, row);
        let left = if *left == 0.0 {
            "0".into()
        } else {
            format!("{left:.1e}")
        };
        draft
            .page
            .equation([format!("f{}", i + 1), text, format!("{left} {unit}")]);
    }
    matrix(context, draft, newton, &names);
}

fn matrix(context: &Context<'_>, draft: &mut Draft, newton: &Newton, names: &[String]) {
    let n = names.len();
    if n > MOST_COLUMNS {
        draft.page.text(words().jacobian_too_large(n));
        return;
    }
    draft.page.text(words().jacobian_rows());
    let head = std::iter::once("J".to_owned()).chain(names.iter().cloned());
    let rows = newton
        .jacobian
        .chunks(n.max(1))
        .enumerate()
        .map(|(i, row)| {
            let largest = row.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
            let cells = row.iter().map(|&v| context.figures.beside(v, largest));
            std::iter::once(format!("f{}", i + 1))
                .chain(cells)
                .collect()
        });
    draft.wide_table(head.collect(), rows.collect());
}

fn unknown_name(context: &Context<'_>, unknown: NewtonUnknown) -> String {
    match unknown {
        NewtonUnknown::X(point) => format!("x({})", point_name(context, Some(point))),
        NewtonUnknown::Y(point) => format!("y({})", point_name(context, Some(point))),
        NewtonUnknown::Angle(link) => symbols::theta(context.scene.link_name(link)),
    }
}

/// A joint's name; points that are not the scene's have none.
fn point_name<'a>(context: &'a Context<'_>, point: Option<PointId>) -> &'a str {
    let named = |point: &PointId| point.index() < context.scene.mechanism.points().len();
    let name = point
        .filter(named)
        .and_then(|point| context.scene.point_name(point));
    name.unwrap_or(words().joint())
}

/// An equation, and the unit in which it is off.
fn row_text(context: &Context<'_>, row: &NewtonRow) -> (String, String) {
    let unit = context.figures.unit;
    match *row {
        NewtonRow::Distance(ends, length) => {
            let [a, b] = ends.map(|end| point_name(context, end));
            let length = context.figures.given(length);
            (
                format!("(|{a} - {b}|^2 - {length}^2)/2"),
                format!("{unit}^2"),
            )
        }
        NewtonRow::MeetingX(point) => (
            words().two_ways("x", point_name(context, point)),
            unit.into(),
        ),
        NewtonRow::MeetingY(point) => (
            words().two_ways("y", point_name(context, point)),
            unit.into(),
        ),
        NewtonRow::Guide(point) => (
            words().distance_from_guide(point_name(context, point)),
            unit.into(),
        ),
    }
}

/// A form without a name that is no coupled group: what was found.
fn solved(context: &Context<'_>, draft: &mut Draft, stage: &Stage) {
    draft.page.text(words().found_together());
    let terms = stage
        .loops
        .iter()
        .flat_map(|&l| &context.polygon.loops[l].terms);
    let mut seen = Vec::new();
    for term in terms.filter(|term| {
        let is_new = !seen.contains(&term.side);
        seen.push(term.side);
        is_new
    }) {
        let member = context.member(*term, stage);
        let f = context.figures;
        if member.sought[0] {
            let r = f.number(member.reading.r);
            draft
                .page
                .equation([member.side.name.clone(), format!("{r} {}", f.unit)]);
        }
        if member.sought[1] {
            let theta = f.direction(member.reading.theta);
            draft
                .page
                .equation([member.side.theta(), format!("{theta} deg")]);
        }
    }
}
