//! Writes the laws of loads (the factor over the driver, the curve of a press), and the part of the
//! driver's effort against each load.

use super::forces::{kind, point_name, speed_in_si};
use super::knots::{line_at, on_line};
use crate::page::Formula;
use crate::quantity::Aspect;
use crate::report::forces::effort_unit;
use crate::report::working::context::{Context, Draft};
use crate::report::working::expression::Expression;
use crate::solver::{LoadAction, PressStroke};
use crate::wording::words;
use crate::{Body, Load, PointId, Profile, SlideId, StrokeEnd, Vec2};

/// Writes the laws of loads that are not constant.
pub(crate) fn laws(context: &Context<'_>, draft: &mut Draft, acted: &[LoadAction]) {
    let mechanism = &context.scene.mechanism;
    for (load, acted) in mechanism.loads().iter().zip(acted) {
        match *load {
            Load::Force {
                point,
                force,
                frame,
                ref over,
            } if !over.is_one() && force != Vec2::ZERO => {
                let complete = match frame {
                    Body::Ground => force,
                    Body::Link(link) => force.turned(context.state.direction(link)),
                };
                let now = acted.forces.first().map_or(Vec2::ZERO, |a| a.1);
                let part = complete.dot(now) / complete.dot(complete);
                let name = words().acts_at(words().force(), point_name(context, point));
                let sizes = [part, force.norm(), now.norm().copysign(part)];
                scaled(context, draft, name, sizes, "N");
            }
            Load::Torque {
                link,
                torque,
                ref over,
            } if !over.is_one() && torque != 0.0 => {
                let now = acted.couples.first().map_or(0.0, |couple| couple.1);
                let name = words().acts_on(words().torque(), context.scene.link_name(link));
                scaled(context, draft, name, [now / torque, torque, now], "N m");
            }
            Load::Spring { .. } | Load::GasSpring { .. } | Load::TorsionSpring { .. } => {
                super::springs::law(context, draft, load, acted);
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

/// Writes the distance of a press from the end of its stroke, and the line of its curve there.
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
    draft.text(words().distance_of_press(name));
    let here = f.computed(name, position);
    let bottom = f.computed("r0", stroke.bottom);
    let distance = match end {
        StrokeEnd::Minimum => here - bottom,
        StrokeEnd::Maximum => bottom - here,
    };
    let d = draft.worked("d", &distance, |d| f.length_or_zero(d, size));
    draft.agree("d", d, stroke.distance, size);
    match (stroke.closes, line_at(curve, stroke.distance)) {
        (false, _) => draft.text(words().press_opens()),
        (true, Some(line)) if force > 0.0 => {
            draft.text(words().press_by_line());
            let (computed, reach) = on_line(context, draft, "d", (d, size), line);
            draft.agree("p", computed, force, reach);
        }
        (true, _) => {
            let first = curve.knots().last().map_or(0.0, |knot| knot[0]);
            let reach = format!("{} {}", f.given(first), f.unit);
            draft.text(words().press_has_not_begun(&reach));
        }
    }
}

/// Writes a load with its factor at this coordinate: `0.565*32000 = 18080 N`.
fn scaled(
    context: &Context<'_>,
    draft: &mut Draft,
    name: String,
    [part, complete, now]: [f64; 3],
    unit: &str,
) {
    let f = context.figures;
    let product = f.computed(Formula::words(words().factor()), part)
        * Expression::figure(f.given(complete), complete);
    let computed = draft.worked(Formula::words(&name), &product, |now| {
        Formula::measured(f.number(now), unit)
    });
    draft.agree(&name, computed, now, complete.abs());
}

/// Returns the names of the parts of the driver's effort in a formula.
pub(crate) fn share_names() -> [Formula; 3] {
    [words().column_load(), words().gravity(), words().inertia()].map(Formula::words)
}

/// Writes the power of every load, and the part of the driver's effort that balances it.
pub(crate) fn shares(
    context: &Context<'_>,
    draft: &mut Draft,
    acted: &[LoadAction],
    parts: [f64; 3],
) {
    let (f, state) = (context.figures, context.state);
    let mechanism = &context.scene.mechanism;
    let metres = mechanism.metres();
    let speed = speed_in_si(context);
    if speed == 0.0 {
        return;
    }
    // A power, and its value for a velocity along the force, which determines its rounding error.
    let power = |force: Vec2, at: PointId| {
        let v = state.velocity(at);
        [force.dot(v), force.norm() * v.norm()].map(|power| power * metres)
    };
    let (mut powers, mut sizes) = ([0.0; 3], [0.0; 3]);
    let mut rows = Vec::new();
    let mut add = |share: usize, name: String, formula: &str, [value, size]: [f64; 2]| {
        powers[share] += value;
        sizes[share] += size;
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
        for &(link, couple) in &acted.couples {
            let name = words().acts_on(what, context.scene.link_name(link));
            let power = couple * state.omega(link);
            add(0, name, "M ω", [power, power.abs()]);
        }
    }
    for id in mechanism.link_ids() {
        let (link, name) = (mechanism.link(id), context.scene.link_name(id));
        let turning = link.inertia * state.alpha(id) * state.omega(id);
        let Some(com) = link.com else {
            let power = [-turning, turning.abs()];
            add(2, words().inertia_of(name), "-I α ω", power);
            continue;
        };
        let weight = mechanism.gravity() * link.mass;
        add(1, words().weight_of(name), "m g v", power(weight, com));
        let [moving, size] = power(state.acceleration(com) * (link.mass * metres), com);
        let (name, size) = (words().inertia_of(name), size + turning.abs());
        add(2, name, "-m a v - I α ω", [-moving - turning, size]);
    }
    if !rows.is_empty() {
        let power = format!("{} [W]", words().power());
        draft.table(
            [words().column_of(), words().column_formula(), &power],
            rows,
        );
    }
    let unit = effort_unit(Aspect::effort_of(mechanism.driver().input));
    let size = parts
        .iter()
        .fold(0.0_f64, |maximum, v| maximum.max(v.abs()));
    let names = share_names();
    let shares = powers.into_iter().zip(sizes).zip(parts);
    for (name, ((power, of_terms), part)) in names.into_iter().zip(shares) {
        let figure = f.format_or_zero(power, size * speed.abs());
        if figure == "0" {
            draft.equation([name, Formula::measured("0", unit)]);
            continue;
        }
        let share = Expression::figure(figure, power) / Expression::figure(f.given(speed), speed);
        let computed = draft.write_numbers(name.clone(), &-share, |share| {
            Formula::measured(f.format_or_zero(share, size), unit)
        });
        draft.agree(name, computed, part, size.max(of_terms / speed.abs()));
    }
}
