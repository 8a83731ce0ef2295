//! Writes a coupled group: its unknowns, and the data of the last Newton step.

use super::context::{Context, Draft};
use super::expression::{Expression, Function};
use super::loops::group_unknowns::Stage;
use super::loops::sides::{Side, SideShape};
use super::loops::solution::turn;
use super::symbols;
use crate::page::{Formula, Symbol};
use crate::solver::{Newton, NewtonRow, NewtonUnknown};
use crate::wording::words;
use crate::{Body, PointId};

/// Maximum number of unknowns for which the matrix is shown.
const MAX_COLUMNS: usize = 12;

/// Writes the positions of a group solved simultaneously.
pub(super) fn position(context: &Context<'_>, draft: &mut Draft, stage: &Stage) {
    let newton = context.solver.newton(&context.state);
    let own = newton
        .into_iter()
        .find(|newton| Some(newton.group.index()) == stage.group);
    match own {
        Some(newton) => last_step(context, draft, &newton),
        None if context.has_positions() => solved(context, draft, stage),
        None => draft.text(words().solved_at_once()),
    }
}

/// Writes the unknowns, their values and the residual of every equation, then the matrix.
fn last_step(context: &Context<'_>, draft: &mut Draft, newton: &Newton) {
    let f = context.figures;
    draft.text(words().no_part_alone());
    let names: Vec<Symbol> = newton
        .unknowns
        .iter()
        .map(|&u| unknown_name(context, u))
        .collect();
    for ((unknown, name), value) in newton.unknowns.iter().zip(&names).zip(&newton.values) {
        draft.equation([
            name.clone().into(),
            match unknown {
                NewtonUnknown::X(_) | NewtonUnknown::Y(_) => f.length(*value),
                NewtonUnknown::Angle(_) => {
                    let degrees = f.direction(value.to_degrees());
                    let degrees = Formula::measured(degrees, "deg");
                    Formula::measured(f.number(*value), "rad").equals(degrees)
                }
            },
        ]);
    }
    draft.text(words().equations_left());
    for (i, (row, left)) in newton.rows.iter().zip(&newton.residuals).enumerate() {
        let (formula, unit) = equation_of(context, row);
        let left = match *left {
            0.0 => "0".into(),
            left => format!("{left:.1e}"),
        };
        let function = Symbol::indexed("f", (i + 1).to_string());
        draft.equation([function.into(), formula, Formula::measured(left, &unit)]);
    }
    matrix(context, draft, newton, &names);
    sides(context, draft, newton);
}

/// Writes length and angle of every unknown side, from the joints found now.
fn sides(context: &Context<'_>, draft: &mut Draft, newton: &Newton) {
    let (polygon, schedule, f) = (context.polygon, context.schedule, context.figures);
    let own = Some(newton.group.index());
    let loops = polygon.loops.iter().filter(|of| of.group == own);
    let terms: Vec<_> = loops.flat_map(|of| &of.terms).collect();
    let readings = polygon.sides.iter().zip(&context.readings).enumerate();
    let mut is_begun = false;
    for (number, (side, reading)) in readings {
        let is_unknown = |link| newton.unknowns.contains(&NewtonUnknown::Angle(link));
        let is_shown = match side.shape {
            // The direction of a vector on a link follows from the link's angle.
            SideShape::Rigid(Body::Link(link), _) => {
                context.scene.mechanism.link(link).ends.is_some() || is_unknown(link)
            }
            _ => side.turns_with().is_some_and(is_unknown),
        };
        let unknowns = [schedule.length_group(side), schedule.angle_group(side)]
            .map(|group| group.is_some() && group == own);
        let (Some(between), true) = (
            between(context, side),
            terms.iter().any(|term| term.side == number) && unknowns.contains(&true),
        ) else {
            continue;
        };
        if !std::mem::replace(&mut is_begun, true) {
            draft.text(words().sides_by_joints());
        }
        let theta = side.theta();
        let [x, y] = between;
        // Two joints of a moving guide may coincide, and then define no direction.
        if unknowns[1]
            && !is_shown
            && matches!(side.shape, SideShape::Link(_) | SideShape::Rigid(..))
        {
            let angle = Expression::atan2(y.clone(), x.clone());
            let computed = draft.worked(theta.clone(), &angle, |computed| turn(f, computed));
            let loss = context.longest / reading.r.abs();
            draft.agree_angle(&theta, computed, reading.theta, loss);
        }
        if unknowns[0] {
            let angle = f.directed(theta, reading.theta);
            let [cos, sin] = angle.cos_and_sin();
            let along = x * cos + y * sin;
            let computed = draft.worked(side.name.as_str(), &along, |r| f.length(r));
            draft.agree(&side.name, computed, reading.r, context.longest);
        }
    }
}

/// Returns `xB - xA` and `yB - yA` of a side with named ends.
fn between(context: &Context<'_>, side: &Side) -> Option<[Expression; 2]> {
    let (scene, f) = (context.scene, context.figures);
    let place = |name: &str| {
        let mut points = scene.mechanism.point_ids();
        let point = points.find(|&point| scene.point_name(point) == Some(name))?;
        let at = context.state.position(point);
        let size = context.longest;
        let coordinate =
            |axis: &str, value: f64| f.rounded(symbols::of_point(axis, name), value, size);
        Some([coordinate("x", at.x), coordinate("y", at.y)])
    };
    let ([x0, y0], [x1, y1]) = (place(&side.tail)?, place(&side.head)?);
    Some([x1 - x0, y1 - y0])
}

fn matrix(context: &Context<'_>, draft: &mut Draft, newton: &Newton, names: &[Symbol]) {
    let n = names.len();
    if n > MAX_COLUMNS {
        draft.text(words().jacobian_too_large(n));
        return;
    }
    draft.text(words().jacobian_rows());
    let headers = newton.unknowns.iter().zip(names).map(|(unknown, name)| {
        let unit = match unknown {
            NewtonUnknown::X(_) | NewtonUnknown::Y(_) => context.figures.unit,
            NewtonUnknown::Angle(_) => "rad",
        };
        format!("{name} [{unit}]")
    });
    let head = std::iter::once("J".to_owned()).chain(headers);
    let rows = newton
        .jacobian
        .chunks(n.max(1))
        .enumerate()
        .map(|(i, row)| {
            let largest = row.iter().fold(0.0_f64, |maximum, v| maximum.max(v.abs()));
            let cells = row
                .iter()
                .map(|&v| context.figures.format_or_zero(v, largest));
            let unit = newton.rows.get(i).map(|row| equation_of(context, row).1);
            let unit = unit.unwrap_or_default();
            std::iter::once(format!("f{} [{unit}]", i + 1))
                .chain(cells)
                .collect()
        });
    draft.wide_table(head.collect(), rows.collect());
}

fn unknown_name(context: &Context<'_>, unknown: NewtonUnknown) -> Symbol {
    match unknown {
        NewtonUnknown::X(point) => symbols::of_point("x", point_name(context, Some(point))),
        NewtonUnknown::Y(point) => symbols::of_point("y", point_name(context, Some(point))),
        NewtonUnknown::Angle(link) => context.theta(link),
    }
}

/// Returns a joint's name; points that the solver added have none.
fn point_name<'a>(context: &'a Context<'_>, point: Option<PointId>) -> &'a str {
    let named = |point: &PointId| point.index() < context.scene.mechanism.points().len();
    let name = point
        .filter(named)
        .and_then(|point| context.scene.point_name(point));
    name.unwrap_or(words().joint())
}

/// Returns an equation, and the unit of its residual.
fn equation_of(context: &Context<'_>, row: &NewtonRow) -> (Formula, String) {
    let unit = context.figures.unit;
    let name = |point| Formula::from(point_name(context, point));
    let two_ways = |axis: &str, point| {
        let arguments = [axis.into(), name(point)];
        Formula::message(|[axis, point]| words().two_ways(axis, point), arguments)
    };
    let two = || Expression::Number(2.0);
    match *row {
        NewtonRow::Distance(ends, length) => {
            let [a, b] = ends.map(|end| Expression::symbol(point_name(context, end)));
            let distance = Expression::symbol((a - b).symbols().between(['|', '|']));
            let length = Expression::figure(context.figures.given(length), length);
            let left = (distance.squared() - length.squared()) / two();
            (left.symbols(), format!("{unit}^2"))
        }
        NewtonRow::MeetingX(point) => (two_ways("x", point), unit.into()),
        NewtonRow::MeetingY(point) => (two_ways("y", point), unit.into()),
        NewtonRow::Guide(point) => {
            let distance = |[point]: [&str; 1]| words().distance_from_guide(point);
            (Formula::message(distance, [name(point)]), unit.into())
        }
        NewtonRow::Elbow(links) => {
            let [link, from] = links.map(|link| Expression::symbol(context.theta(link)));
            let half = (link - from - Expression::symbol("q")) / two();
            let left = two() * Expression::of(Function::Tan, [half]);
            (left.symbols(), "rad".into())
        }
    }
}

/// Writes the results of a group that has no special form and is not coupled.
fn solved(context: &Context<'_>, draft: &mut Draft, stage: &Stage) {
    draft.text(words().found_together());
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
            let r = f.length(member.reading.r);
            draft.equation([member.side.name.as_str().into(), r]);
        }
        if member.sought[1] {
            let theta = Formula::measured(f.direction(member.reading.theta), "deg");
            draft.equation([member.side.theta().into(), theta]);
        }
    }
}
