//! Derives vectors between two points of one body from their coordinates: length, and angle to the
//! body.

use super::group_unknowns::{ProblemForm, Stage};
use super::sides::{Side, SideReading, SideShape};
use super::solution::angle_sum;
use crate::report::working::context::{Context, Draft};
use crate::report::working::expression::Expression;
use crate::wording::words;
use crate::{Body, LinkId, Member, Vec2};

/// Writes length and angle of every vector for which neither the scene nor the coordinates show
/// them.
pub(crate) fn vectors(context: &Context<'_>, draft: &mut Draft) {
    let sides = context.polygon.sides.iter().zip(&context.readings);
    let mut is_shown = false;
    for (side, reading) in sides {
        let SideShape::Rigid(body, local) = side.shape else {
            continue;
        };
        // Along an axis both are obvious.
        if local.x == 0.0 || local.y == 0.0 || is_given(context, body, side) {
            continue;
        }
        if !is_shown {
            draft.text(words().vectors_by_coordinates());
            is_shown = true;
        }
        vector(context, draft, (side, reading), body, local);
    }
}

/// Returns `true` if the scene gives the vector itself, by its length and its angle to the link.
fn is_given(context: &Context<'_>, body: Body, side: &Side) -> bool {
    let Body::Link(link) = body else {
        return false;
    };
    let members = &context.scene.mechanism.link(link).members;
    let is_origin = |m: &&Member| m.polar.is_none() && m.local == Vec2::ZERO;
    let origin = members.iter().find(is_origin).map(|m| m.point);
    let name = |point| context.scene.point_name(point);
    members.iter().any(|member| {
        let Some(from) = member.polar.and_then(|polar| polar.from.or(origin)) else {
            return false;
        };
        let ends = [name(from), name(member.point)];
        let [tail, head] = [Some(&*side.tail), Some(&*side.head)];
        ends == [tail, head] || ends == [head, tail]
    })
}

fn vector(
    context: &Context<'_>,
    draft: &mut Draft,
    (side, reading): (&Side, &SideReading),
    body: Body,
    local: Vec2,
) {
    let f = context.figures;
    let parts = || [local.x, local.y].map(|v| Expression::figure(f.given(v), v));
    let [x, y] = parts();
    let length = (x.squared() + y.squared()).sqrt();
    let computed = draft.write_numbers(side.name.as_str(), &length, |r| f.length(r));
    draft.agree(&side.name, computed, reading.r, reading.r);
    let [x, y] = parts();
    let own = Expression::atan2(y, x);
    let is_given = context.schedule.angle_group(side).is_none();
    match body {
        Body::Ground => {
            let computed = draft.write_numbers(side.theta(), &own, |degrees| angle_sum(f, degrees));
            draft.agree_angle(side.theta(), computed, reading.theta, 1.0);
        }
        Body::Link(link) if is_given && context.has_positions() => {
            turned(context, draft, (side, reading), link, own);
        }
        // The angle of its link is unknown, so its value must not appear yet.
        Body::Link(link) => {
            let ahead = Expression::figure(f.angle(own.value()), own.value());
            let theta = context.theta(link);
            let theta = |ahead| Expression::symbol(theta.clone()) + ahead;
            let sides = [theta(own), theta(ahead)].map(|sum| sum.symbols());
            draft.equation(std::iter::once(side.theta().into()).chain(sides));
        }
    }
}

/// Writes `θ_r4e = θ4 + ... = value` for a known angle of the link.
fn turned(
    context: &Context<'_>,
    draft: &mut Draft,
    (side, reading): (&Side, &SideReading),
    link: LinkId,
    ahead: Expression,
) {
    let f = context.figures;
    let degrees = context.state.angle(link);
    let name = context.theta(link);
    let theta = f.directed(name, degrees) + ahead;
    let symbol = side.theta();
    let computed = draft.worked(symbol.clone(), &theta, |degrees| angle_sum(f, degrees));
    draft.agree_angle(&symbol, computed, reading.theta, 1.0);
}

/// Writes the angles of the vectors that rotate with links found by a group, except those in its
/// own loops.
pub(crate) fn found(context: &Context<'_>, draft: &mut Draft, stage: &Stage) {
    let is_own = |number: usize| {
        let loops = stage
            .loops
            .iter()
            .filter_map(|&l| context.polygon.loops.get(l));
        let is_alone = !matches!(stage.form, ProblemForm::System);
        is_alone
            && loops
                .flat_map(|of| &of.terms)
                .any(|term| term.side == number)
    };
    let sides = context.polygon.sides.iter().zip(&context.readings);
    for (number, (side, reading)) in sides.enumerate() {
        let SideShape::Rigid(Body::Link(link), local) = side.shape else {
            continue;
        };
        let is_found = stage.group.is_some() && context.schedule.angle_group(side) == stage.group;
        if !is_found || is_own(number) || local.x == 0.0 || local.y == 0.0 {
            continue;
        }
        let ahead = crate::angle::degrees(local);
        let figure = Expression::figure(context.figures.angle(ahead), ahead);
        turned(context, draft, (side, reading), link, figure);
    }
}
