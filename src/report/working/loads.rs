//! How the loads come about: the factor of a load over the driver, the law of a spring; and what share of
//! the driver's effort each of them has.

use super::draft::{Context, Draft};
use super::expression::Expression;
use super::forces::{kind, point_name};
use crate::solver::{Acted, PressStroke};
use crate::wording::words;
use crate::{Body, Input, Load, PointId, Profile, SlideId, StrokeEnd, Vec2};

/// The laws of loads that are not constant.
pub(super) fn laws(context: &Context<'_>, draft: &mut Draft, acted: &[Acted]) {
    let (f, mechanism) = (context.figures, &context.scene.mechanism);
    for (load, acted) in mechanism.loads().iter().zip(acted) {
        match *load {
            Load::Force {
                point,
                force,
                frame,
                ref over,
            } if !over.is_one() && force != Vec2::ZERO => {
                let whole = match frame {
                    Body::Ground => force,
                    Body::Link(link) => force.turned(context.state.direction(link)),
                };
                let now = acted.forces.first().map_or(Vec2::ZERO, |a| a.1);
                let part = whole.dot(now) / whole.dot(whole);
                let name = words().acts_at(words().force(), point_name(context, point));
                let sizes = [part, force.norm(), now.norm().copysign(part)];
                scaled(context, draft, name, sizes, "N");
            }
            Load::Torque {
                link,
                torque,
                ref over,
            } if !over.is_one() && torque != 0.0 => {
                let now = acted.couple.map_or(0.0, |couple| couple.1);
                let name = words().acts_on(words().torque(), context.scene.link_name(link));
                scaled(context, draft, name, [now / torque, torque, now], "N m");
            }
            Load::Spring {
                from,
                to,
                stiffness,
                length,
                damping,
            } => {
                let spring = SpringNow::of(context, from, to);
                let metres = mechanism.metres();
                let [from, to] = [from, to].map(|point| point_name(context, point));
                let name = words().spring_between(from, to);
                let l = f.number(spring.length);
                let rate = f.beside(spring.rate, context.fastest[0]);
                draft.page.text(words().pull_of_spring());
                draft.page.equation([name, format!("{l} {}", f.unit)]);
                draft
                    .page
                    .equation(["dL/dt".to_owned(), format!("{rate} {}", f.length_unit(1))]);
                let [l, l0] = [spring.length, length].map(|v| v * metres);
                let l = Expression::known("L", f.number(l), l);
                let l0 = Expression::known("L0", f.given(l0), l0);
                let k = Expression::known("k", f.given(stiffness), stiffness);
                let c = Expression::known("c", f.given(damping), damping);
                let rate = spring.rate * metres;
                let figure = f.beside(rate, context.fastest[0] * metres);
                let rate = Expression::known("dL/dt", figure, rate);
                let pull = k * (l - l0) + c * rate;
                draft.worked(words().pull(), &pull, |pull| {
                    format!("{} N", f.number(pull))
                });
            }
            Load::Press {
                slide,
                end,
                ref curve,
            } => {
                if let Some(stroke) = acted.stroke {
                    let force = acted.forces.first().map_or(0.0, |(_, force)| force.norm());
                    press(context, draft, (slide, end, curve), (stroke, force));
                }
            }
            Load::Force { .. } | Load::Torque { .. } => {}
        }
    }
}

/// How far a press is from the end of its stroke, and on which line of its curve that lies.
fn press(
    context: &Context<'_>,
    draft: &mut Draft,
    (slide, end, curve): (SlideId, StrokeEnd, &Profile),
    (stroke, force): (PressStroke, f64),
) {
    let f = context.figures;
    let name = context.scene.slide_name(slide);
    let position = context.state.travel(slide).position;
    let size = position.abs().max(stroke.bottom.abs());
    draft.page.text(words().distance_of_press(name));
    let here = Expression::known(name, f.number(position), position);
    let bottom = Expression::known("r0", f.number(stroke.bottom), stroke.bottom);
    let distance = match end {
        StrokeEnd::Least => here - bottom,
        StrokeEnd::Greatest => bottom - here,
    };
    let d = draft.worked("d", &distance, |d| {
        format!("{} {}", f.beside(d, size), f.unit)
    });
    draft.agree("d", d, stroke.distance, size);
    let knots = curve.knots();
    let is_on = |pair: &&[[f64; 2]]| pair[0][0] <= stroke.distance && stroke.distance <= pair[1][0];
    let line = knots.windows(2).find(is_on);
    match (stroke.closes, line) {
        (false, _) => draft.page.text(words().press_opens()),
        (true, Some(&[[d1, p1], [d2, p2]])) if force > 0.0 => {
            draft.page.text(words().press_by_line());
            let given = |symbol: &str, value: f64| Expression::known(symbol, f.given(value), value);
            let slope = (given("p2", p2) - given("p1", p1)) / (given("d2", d2) - given("d1", d1));
            let d = Expression::known("d", f.beside(d, size), d);
            let law = given("p1", p1) + slope * (d - given("d1", d1));
            let worked = draft.worked("p", &law, |p| format!("{} N", f.number(p)));
            let steep = (p2 - p1).abs() / (d2 - d1) * size;
            draft.agree("p", worked, force, p1.abs().max(p2.abs()) + steep);
        }
        (true, _) => {
            let first = knots.last().map_or(0.0, |knot| knot[0]);
            let reach = format!("{} {}", f.given(first), f.unit);
            draft.page.text(words().press_has_not_begun(&reach));
        }
    }
}

/// `0.565*32000 = 18080 N`: a load by its factor at this coordinate.
fn scaled(
    context: &Context<'_>,
    draft: &mut Draft,
    name: String,
    [part, whole, now]: [f64; 3],
    unit: &str,
) {
    let f = context.figures;
    let product = Expression::known(words().factor(), f.number(part), part)
        * Expression::figure(f.given(whole), whole);
    let worked = draft.worked(&name, &product, |now| format!("{} {unit}", f.number(now)));
    draft.agree(&name, worked, now, whole.abs());
}

/// The present length of a spring, and its rate, in the scene's unit.
struct SpringNow {
    length: f64,
    rate: f64,
}

impl SpringNow {
    fn of(context: &Context<'_>, from: PointId, to: PointId) -> SpringNow {
        let state = context.state;
        let along = state.position(to) - state.position(from);
        let length = along.norm();
        let relative = state.velocity(to) - state.velocity(from);
        let rate = if length > 0.0 {
            along.dot(relative) / length
        } else {
            0.0
        };
        SpringNow { length, rate }
    }
}

/// What the shares of the driver's effort are called in a formula.
pub(super) fn share_names() -> [&'static str; 3] {
    [words().column_load(), words().gravity(), words().inertia()]
}

/// The power of everything that acts, and the share of the driver's effort that is against it.
pub(super) fn shares(context: &Context<'_>, draft: &mut Draft, acted: &[Acted], parts: [f64; 3]) {
    let (f, state) = (context.figures, context.state);
    let mechanism = &context.scene.mechanism;
    let metres = mechanism.metres();
    let speed = match mechanism.driver().input {
        Input::Turn(_) => state.driver_speed(),
        Input::Push(_) => state.driver_speed() * metres,
    };
    if speed == 0.0 {
        return;
    }
    let power = |force: Vec2, at: PointId| force.dot(state.velocity(at)) * metres;
    let mut powers = [0.0; 3];
    let mut rows = Vec::new();
    let mut add = |share: usize, name: String, formula: &str, value: f64| {
        powers[share] += value;
        if value != 0.0 {
            rows.push([name, formula.to_owned(), f.number(value)]);
        }
    };
    for (load, acted) in mechanism.loads().iter().zip(acted) {
        let what = kind(load);
        for &(point, force) in &acted.forces {
            let name = words().acts_at(what, point_name(context, point));
            add(0, name, "F v", power(force, point));
        }
        if let Some((link, couple)) = acted.couple {
            let name = words().acts_on(what, context.scene.link_name(link));
            add(0, name, "M ω", couple * state.omega(link));
        }
    }
    for id in mechanism.link_ids() {
        let (link, name) = (mechanism.link(id), context.scene.link_name(id));
        let turning = link.inertia * state.alpha(id) * state.omega(id);
        let Some(com) = link.com else {
            add(2, words().inertia_of(name), "-I α ω", -turning);
            continue;
        };
        let weight = mechanism.gravity() * link.mass;
        add(1, words().weight_of(name), "m g v", power(weight, com));
        let moving = power(state.acceleration(com) * (link.mass * metres), com);
        let name = words().inertia_of(name);
        add(2, name, "-m a v - I α ω", -moving - turning);
    }
    if !rows.is_empty() {
        let power = format!("{} [W]", words().power());
        draft.table(
            [words().column_of(), words().column_formula(), &power],
            rows,
        );
    }
    let unit = match mechanism.driver().input {
        Input::Turn(_) => "N m",
        Input::Push(_) => "N",
    };
    let size = parts.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let names = share_names();
    for ((name, power), part) in names.into_iter().zip(powers).zip(parts) {
        let figure = f.beside(power, size * speed.abs());
        if figure == "0" {
            draft.page.equation([name.to_owned(), format!("0 {unit}")]);
            continue;
        }
        let share = Expression::figure(figure, power) / Expression::figure(f.given(speed), speed);
        let worked = draft.reckoned(name, &-share, |share| {
            format!("{} {unit}", f.beside(share, size))
        });
        draft.agree(name, worked, part, size);
    }
}
