//! Writes the laws of springs with numbers.

use super::forces::point_name;
use super::knots::{line_at, on_line};
use crate::angle::{TURN, radians};
use crate::page::{Formula, Symbol};
use crate::report::working::context::{Context, Draft};
use crate::report::working::expression::Expression;
use crate::report::working::symbols;
use crate::solver::{LoadAction, Order};
use crate::wording::words;
use crate::{Body, LinkId, Load, PointId, Profile};

/// Writes the law of a spring; does nothing for other loads.
pub(crate) fn law(context: &Context<'_>, draft: &mut Draft, load: &Load, acted: &LoadAction) {
    match *load {
        Load::Spring {
            from,
            to,
            stiffness,
            length,
            preload,
            damping,
        } => {
            let numbers = [stiffness, length, preload, damping];
            pull(context, draft, [from, to], numbers);
        }
        Load::GasSpring {
            from,
            to,
            ref force,
            damping,
        } => push(context, draft, [from, to], (force, damping)),
        Load::TorsionSpring {
            link,
            to,
            stiffness,
            angle,
            preload,
            damping,
        } => {
            let numbers = [stiffness, angle, preload, damping];
            let found = acted.couples.first().map_or(0.0, |couple| couple.1);
            turn_back(context, draft, (link, to, numbers), found);
        }
        Load::Force { .. } | Load::Torque { .. } | Load::Press { .. } => {}
    }
}

/// Writes the law of [`Load::Spring`] in its symbols.
fn pull(
    context: &Context<'_>,
    draft: &mut Draft,
    ends: [PointId; 2],
    [stiffness, length, preload, damping]: [f64; 4],
) {
    let f = context.figures;
    draft.text(words().pull_of_spring());
    let spring = SpringNow::written(context, draft, ends);
    let metres = context.scene.mechanism.metres();
    let [l, l0] = [spring.length, length].map(|v| v * metres);
    let l = f.computed("L", l);
    let l0 = f.as_given("L0", l0);
    let k = f.as_given("k", stiffness);
    let straight = k * (l - l0);
    let stiff = match preload {
        0.0 => straight,
        _ => f.as_given("F0", preload) + straight,
    };
    let pull = stiff + spring.damped(context, damping);
    let name = Formula::words(words().pull());
    draft.worked(name, &pull, |pull| Formula::measured(f.number(pull), "N"));
}

/// Writes the law of [`Load::GasSpring`], with the push p from the line between two knots.
fn push(
    context: &Context<'_>,
    draft: &mut Draft,
    ends: [PointId; 2],
    (force, damping): (&Profile, f64),
) {
    let f = context.figures;
    draft.text(words().pull_of_gas_spring());
    let spring = SpringNow::written(context, draft, ends);
    let push = match line_at(force, spring.length) {
        Some(line) => {
            draft.text(words().push_by_line());
            on_line(context, draft, "L", (spring.length, spring.length), line).0
        }
        None => {
            draft.text(words().push_beyond_knots());
            let [first, last] = [force.knots().first(), force.knots().last()];
            let is_short = first.is_some_and(|knot| spring.length < knot[0]);
            let push = if is_short { first } else { last }.map_or(0.0, |knot| knot[1]);
            let p = Formula::measured(f.given(push), "N");
            draft.equation(["p".into(), p]);
            push
        }
    };
    let p = f.computed("p", push);
    let pull = -p + spring.damped(context, damping);
    let name = Formula::words(words().pull());
    draft.worked(name, &pull, |pull| Formula::measured(f.number(pull), "N"));
}

/// Writes the law of [`Load::TorsionSpring`]: the torque on its link, with θ measured from the free
/// angle.
fn turn_back(
    context: &Context<'_>,
    draft: &mut Draft,
    (link, to, [stiffness, free, preload, damping]): (LinkId, Body, [f64; 4]),
    found: f64,
) {
    let (f, scene, state) = (context.figures, context.scene, context.state);
    let angle = |name: Symbol, value: f64| f.directed(name, value);
    let (name, own) = (scene.link_name(link), state.angle(link));
    let (other, turning) = match to {
        Body::Ground => (0.0, state.omega(link)),
        Body::Link(to) => (state.angle(to), state.omega(link) - state.omega(to)),
    };
    draft.text(words().torque_of_torsion_spring(name));
    let plain = own - other - free;
    let turns = TURN * -(plain / TURN).round();
    let mut phi = angle(symbols::theta(name), own);
    if let Body::Link(to) = to {
        phi = phi - angle(symbols::theta(scene.link_name(to)), other);
    }
    phi = phi - f.as_given("θ0", free);
    if turns != 0.0 {
        phi = phi + Expression::figure(f.given(turns), turns);
    }
    let phi = draft.worked("θ", &phi, |phi| {
        Formula::measured(f.format_or_zero(phi, TURN), "deg")
    });
    let phi = radians(phi);
    let written = f.format_or_zero(phi, radians(TURN));
    draft.equation(["θ".into(), Formula::measured(&written, "rad")]);
    let size = stiffness * radians(TURN) + preload.abs();
    let turn = f.as_given("M0", preload)
        - f.as_given("k", stiffness) * Expression::known("θ", written, phi)
        - f.as_given("c", damping) * f.computed("ω", turning);
    let computed = draft.worked("M", &turn, |turn| Formula::measured(f.number(turn), "N m"));
    draft.agree("M", computed, found, size.max(found.abs()));
}

/// The current length of a spring, and the rate of it, in the scene's unit.
struct SpringNow {
    length: f64,
    rate: f64,
}

impl SpringNow {
    /// Writes a spring's length and the rate of it.
    fn written(context: &Context<'_>, draft: &mut Draft, ends: [PointId; 2]) -> SpringNow {
        let f = context.figures;
        let spring = SpringNow::of(context, ends);
        let [from, to] = ends.map(|point| Formula::from(point_name(context, point)));
        let message = |[length, from, to]: [&str; 3]| words().spring_between(length, from, to);
        let name = Formula::message(message, ["L".into(), from, to]);
        let rate = f.format_or_zero(spring.rate, context.fastest[0]);
        let rate = Formula::measured(rate, &f.length_unit(1));
        draft.equation([name, f.length(spring.length)]);
        draft.equation([symbols::length("L", Order::Velocity).into(), rate]);
        spring
    }

    /// Returns the damping term `c*dL/dt`, with the rate in m/s.
    fn damped(&self, context: &Context<'_>, damping: f64) -> Expression {
        let f = context.figures;
        let metres = context.scene.mechanism.metres();
        let rate = self.rate * metres;
        let figure = f.format_or_zero(rate, context.fastest[0] * metres);
        f.as_given("c", damping)
            * Expression::known(symbols::length("L", Order::Velocity), figure, rate)
    }

    fn of(context: &Context<'_>, [from, to]: [PointId; 2]) -> SpringNow {
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
