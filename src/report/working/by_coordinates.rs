//! Vectors between two points of a body that follow from where these lie on it: how long they are, and how they lie to
//! the body.

use super::draft::{Context, Draft};
use super::expression::{Expression, Function};
use super::sides::{Side, SideReading, SideShape};
use super::solution::angle_sum;
use super::symbols;
use crate::wording::words;
use crate::{Body, Member, Vec2};

/// Length and angle of every vector where neither the scene nor its coordinates show them.
pub(super) fn vectors(context: &Context<'_>, draft: &mut Draft) {
    let sides = context.polygon.sides.iter().zip(&context.readings);
    let mut is_told = false;
    for (side, reading) in sides {
        let SideShape::Rigid(body, local) = side.shape else {
            continue;
        };
        // Along an axis both can be seen.
        if local.x == 0.0 || local.y == 0.0 || is_given(context, body, side) {
            continue;
        }
        if !is_told {
            draft.page.text(words().vectors_by_coordinates());
            is_told = true;
        }
        vector(context, draft, (side, reading), body, local);
    }
}

/// Whether the scene gives a vector itself, by its length and its angle to the link.
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
    let worked = draft.reckoned(&side.name, &length, |r| {
        format!("{} {}", f.number(r), f.unit)
    });
    draft.agree(&side.name, worked, reading.r, reading.r);
    let [x, y] = parts();
    let own = Expression::of(Function::Atan2, [y, x]);
    let theta = match body {
        Body::Ground => own,
        Body::Link(_) if !context.has_positions() => return,
        Body::Link(link) => {
            let degrees = context.state.angle(link);
            let name = symbols::theta(context.scene.link_name(link));
            Expression::known(name, f.direction(degrees), degrees) + own
        }
    };
    let figure = |degrees| angle_sum(f, degrees);
    let symbol = side.theta();
    let worked = match body {
        Body::Ground => draft.reckoned(&symbol, &theta, figure),
        Body::Link(_) => draft.worked(&symbol, &theta, figure),
    };
    draft.agree_angle(&symbol, worked, reading.theta, 1.0);
}
