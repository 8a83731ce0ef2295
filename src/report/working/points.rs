//! Velocities and accelerations of joints, centres of mass and further points: about a pivot, or about
//! another joint of the link, by their tangential and normal parts; on a guide along it.

use super::figures::factor;
use super::page::{Context, Page};
use super::sides::Turns;
use super::symbols::{self, of_point};
use crate::solver::State;
use crate::{Body, Input, LinkId, Mechanism, PointId, SlideId, Vec2, angle};

/// What a point's motion is told from.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Seat {
    /// A link, and another point of it.
    Link(LinkId, PointId),
    /// A guide.
    Guide(SlideId),
}

/// Every point that moves.
pub(super) fn points(context: &Context<'_>, page: &mut Page) {
    page.document.part("Points");
    let mechanism = &context.scene.mechanism;
    let moving = mechanism
        .point_ids()
        .filter(|&p| mechanism.point(p).ground.is_none());
    let seats: Vec<(PointId, Seat)> = moving
        .filter_map(|point| Some((point, seat(context, point)?)))
        .collect();
    if !context.has_rates() {
        page.document
            .text("Their velocities and accelerations do not exist here.");
        return;
    }
    for (point, seat) in seats {
        let Some(name) = context.scene.point_name(point) else {
            continue;
        };
        match seat {
            Seat::Link(link, base) => on_link(context, page, (point, name), link, base),
            Seat::Guide(slide) => on_guide(context, page, (point, name), slide),
        }
    }
}

/// A ground pivot if there is one, then a guide on the ground, then a joint that was placed earlier.
fn seat(context: &Context<'_>, point: PointId) -> Option<Seat> {
    let mechanism = &context.scene.mechanism;
    let links = &mechanism.point(point).links;
    let pivot = links.iter().find_map(|&link| {
        let mut members = mechanism.link(link).members.iter();
        let pivot = members.find(|m| mechanism.point(m.point).ground.is_some())?;
        Some(Seat::Link(link, pivot.point))
    });
    let slides = || {
        mechanism
            .slide_ids()
            .filter(|&s| mechanism.slide(s).slider.point() == point)
    };
    let on_ground = slides().find(|&s| mechanism.slide(s).on == Body::Ground);
    let ridden = || {
        let base = |link| Some(Seat::Link(link, earliest(context, link, point)?));
        links.iter().find_map(|&link| base(link))
    };
    pivot
        .or(on_ground.map(Seat::Guide))
        .or_else(ridden)
        .or_else(|| slides().next().map(Seat::Guide))
}

/// The point of a link that was placed first, if that is before this one.
fn earliest(context: &Context<'_>, link: LinkId, point: PointId) -> Option<PointId> {
    let mechanism = &context.scene.mechanism;
    let groups = &context.solver.plan().groups;
    let place = |point: PointId| {
        let places = groups.iter().enumerate().flat_map(|(g, group)| {
            group
                .points
                .iter()
                .enumerate()
                .map(move |(i, &p)| (p, (g, i)))
        });
        places
            .filter(|(p, _)| *p == point)
            .map(|(_, place)| place)
            .min()
    };
    let own = place(point);
    let members = mechanism.link(link).members.iter().map(|m| m.point);
    let earlier = members.filter(|&m| m != point).map(|m| (place(m), m));
    let (first, base) = earlier.min_by_key(|(place, _)| *place)?;
    (first < own).then_some(base)
}

/// A vector with its symbol, by size and direction.
fn polar(context: &Context<'_>, symbol: String, v: Vec2, order: usize, size: f64) -> [String; 2] {
    let f = context.figures;
    let unit = f.length_unit(order);
    let length = f.beside(v.norm(), size);
    if length == "0" {
        return [symbol, format!("0 {unit}")];
    }
    [
        symbol,
        format!("{length} {unit} at {} deg", f.direction(angle::degrees(v))),
    ]
}

fn on_link(
    context: &Context<'_>,
    page: &mut Page,
    (point, name): (PointId, &str),
    link: LinkId,
    base: PointId,
) {
    let (f, state) = (context.figures, context.state);
    let mechanism = &context.scene.mechanism;
    let Some(arm) = arm(mechanism, link, base, point) else {
        return;
    };
    let e = arm.turned(state.direction(link));
    let link_name = context.scene.link_name(link);
    let base_name = context.scene.point_name(base).unwrap_or("a point");
    let is_pivot = mechanism.point(base).ground.is_some();
    let r = arm.norm();
    page.document
        .section(format!("{name} on {link_name} about {base_name}"));
    let unit = f.unit;
    if r == 0.0 {
        page.document
            .text(format!("It lies on {base_name} and moves as that does."));
        return;
    }
    if context.polygon.locks.turns(Body::Link(link), 0.0) == Turns::Never {
        page.document.text(format!(
            "{link_name} does not turn: all of it moves as {base_name} does."
        ));
        return;
    }
    page.document.equation([
        "r".to_owned(),
        format!(
            "{} {unit} at {} deg",
            f.given(r),
            f.direction(angle::degrees(e))
        ),
    ]);
    let (w, a) = (state.omega(link), state.alpha(link));
    let (omega, alpha) = (symbols::omega(link_name), symbols::alpha(link_name));
    // ---- velocity
    // The driver's rates have no more digits than the scene gives them.
    let rate = |value: f64| match mechanism.driver().input == Input::Turn(link) {
        true => f.given(value),
        false => f.number(value),
    };
    let turning = e.perp() * w;
    let (v, base_v) = (state.velocity(point), state.velocity(base));
    let size = v.norm().max(turning.norm()).max(base_v.norm());
    let part = format!("{}·{}", factor(&rate(w)), f.given(r));
    write_part(
        context,
        page,
        &symbols_of("v", name, is_pivot, "t"),
        &format!("{omega} r"),
        &part,
        turning,
        1,
        size,
    );
    agree(page, &of_point("v", name), base_v + turning, v, size);
    if !is_pivot {
        page.document
            .equation(polar(context, of_point("v", base_name), base_v, 1, size));
        whole(context, page, "v", name, base_v + turning, 1, size, None);
    }
    // ---- acceleration
    let (tangential, normal) = (e.perp() * a, -e * (w * w));
    let (all, base_a) = (state.acceleration(point), state.acceleration(base));
    let size = all
        .norm()
        .max(tangential.norm())
        .max(normal.norm())
        .max(base_a.norm());
    let part = format!("{}·{}", factor(&rate(a)), f.given(r));
    write_part(
        context,
        page,
        &symbols_of("a", name, false, "t"),
        &format!("{alpha} r"),
        &part,
        tangential,
        2,
        size,
    );
    let part = format!("{}^2·{}", factor(&rate(w)), f.given(r));
    write_part(
        context,
        page,
        &symbols_of("a", name, false, "n"),
        &format!("{omega}^2 r"),
        &part,
        normal,
        2,
        size,
    );
    agree(
        page,
        &of_point("a", name),
        base_a + tangential + normal,
        all,
        size,
    );
    if !is_pivot {
        page.document
            .equation(polar(context, of_point("a", base_name), base_a, 2, size));
    }
    let parts = is_pivot.then_some((tangential.norm(), normal.norm()));
    whole(
        context,
        page,
        "a",
        name,
        base_a + tangential + normal,
        2,
        size,
        parts,
    );
    if let Some((t, n)) = parts.filter(|(t, n)| *t > 1e-15 * size && *n > 0.0) {
        let beta = t.atan2(n).to_degrees();
        page.document.equation([
            "β".to_owned(),
            format!("atan({}/{})", f.number(t), f.number(n)),
            format!(
                "{} deg, between {} and its normal part",
                f.number(beta),
                of_point("a", name)
            ),
        ]);
    }
}

/// The arm from one point of a link to another, in the link's frame.
fn arm(mechanism: &Mechanism, link: LinkId, from: PointId, to: PointId) -> Option<Vec2> {
    let link = mechanism.link(link);
    Some(link.local(to)? - link.local(from)?)
}

/// `aCt`, or the symbol of the whole where it has one part alone.
fn symbols_of(figure: &str, name: &str, is_whole: bool, part: &str) -> String {
    let symbol = of_point(figure, name);
    match (is_whole, name.len() <= 2) {
        (true, _) => symbol,
        (false, true) => format!("{symbol}{part}"),
        (false, false) => format!("{symbol}_{part}"),
    }
}

#[allow(
    clippy::too_many_arguments,
    reason = "a line of one formula: all of it is shown"
)]
fn write_part(
    context: &Context<'_>,
    page: &mut Page,
    symbol: &str,
    formula: &str,
    numbers: &str,
    value: Vec2,
    order: usize,
    size: f64,
) {
    let [symbol, figure] = polar(context, symbol.to_owned(), value, order, size);
    page.document
        .equation([symbol, formula.to_owned(), numbers.to_owned(), figure]);
}

/// The sum of the parts: by its components, and as size and direction.
#[allow(
    clippy::too_many_arguments,
    reason = "a line of one formula: all of it is shown"
)]
fn whole(
    context: &Context<'_>,
    page: &mut Page,
    figure: &str,
    name: &str,
    sum: Vec2,
    order: usize,
    size: f64,
    parts: Option<(f64, f64)>,
) {
    let f = context.figures;
    let [symbol, text] = polar(context, of_point(figure, name), sum, order, size);
    let [x, y] = match parts {
        Some((t, n)) => [t, n],
        None => [sum.x, sum.y],
    }
    .map(|v| factor(&f.beside(v, size)));
    page.document
        .equation([symbol, format!("sqrt({x}^2 + {y}^2)"), text]);
}

/// What slides along a guide: along it, and with a guide that turns across it, too.
fn on_guide(
    context: &Context<'_>,
    page: &mut Page,
    (point, name): (PointId, &str),
    slide: SlideId,
) {
    let state = context.state;
    let given = context.scene.mechanism.slide(slide);
    let slide_name = context.scene.slide_name(slide);
    let travel = state.travel(slide);
    let t = travel.guide;
    let on = match given.on {
        Body::Ground => None,
        Body::Link(link) => Some(link),
    };
    let body = on.map_or("the ground", |link| context.scene.link_name(link));
    page.document
        .section(format!("{name} along the guide of {slide_name} on {body}"));
    let (v, a) = (state.velocity(point), state.acceleration(point));
    let (rate, accel) = (symbols::rate(slide_name), symbols::accel(slide_name));
    let Some(link) = on else {
        let (along, second) = (t * travel.rate, t * travel.accel);
        let size = [v.norm(), a.norm()];
        agree(page, &of_point("v", name), along, v, size[0]);
        agree(page, &of_point("a", name), second, a, size[1]);
        for (figure, symbol, value, order) in [("v", rate, along, 1), ("a", accel, second, 2)] {
            let [whole, text] = polar(
                context,
                of_point(figure, name),
                value,
                order,
                size[order - 1],
            );
            page.document.equation([whole, symbol, text]);
        }
        return;
    };
    // The guide's own point under the pin, and what the pin does along it.
    let guide = Carried::under(state, point, slide, link);
    let coriolis = t.perp() * (2.0 * travel.omega * travel.rate);
    let size = v.norm().max(guide.v.norm());
    for line in [
        polar(
            context,
            format!("v of {body} under {name}"),
            guide.v,
            1,
            size,
        ),
        polar(context, rate, t * travel.rate, 1, size),
        polar(
            context,
            of_point("v", name),
            guide.v + t * travel.rate,
            1,
            size,
        ),
    ] {
        page.document.equation(line);
    }
    agree(
        page,
        &of_point("v", name),
        guide.v + t * travel.rate,
        v,
        size,
    );
    let all = guide.a + coriolis + t * travel.accel;
    let size = a.norm().max(guide.a.norm()).max(coriolis.norm());
    let twice = format!("2 {} {}", symbols::omega(body), symbols::rate(slide_name));
    for line in [
        polar(
            context,
            format!("a of {body} under {name}"),
            guide.a,
            2,
            size,
        ),
        polar(context, format!("Coriolis, {twice}"), coriolis, 2, size),
        polar(context, accel, t * travel.accel, 2, size),
        polar(context, of_point("a", name), all, 2, size),
    ] {
        page.document.equation(line);
    }
    agree(page, &of_point("a", name), all, a, size);
}

/// Velocity and acceleration of the place of a link where a point is now.
struct Carried {
    v: Vec2,
    a: Vec2,
}

impl Carried {
    fn under(state: &State, point: PointId, slide: SlideId, link: LinkId) -> Carried {
        // From the point itself: what it does beside the guide is taken away.
        let travel = state.travel(slide);
        let t = travel.guide;
        let _ = link;
        let coriolis = t.perp() * (2.0 * travel.omega * travel.rate);
        Carried {
            v: state.velocity(point) - t * travel.rate,
            a: state.acceleration(point) - t * travel.accel - coriolis,
        }
    }
}

/// Notes how far a sum of parts is from the solver's vector.
fn agree(page: &mut Page, symbol: &str, worked: Vec2, solved: Vec2, size: f64) {
    page.agree(symbol, (worked - solved).norm(), 0.0, size);
}
