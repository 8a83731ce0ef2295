//! Writes the forces: loads, every link and pin in turn, and the driver.

use super::free_body::{free_body, largest};
use crate::page::Formula;
use crate::quantity::Aspect;
use crate::report::forces::effort_unit;
use crate::report::working::context::{Context, Draft};
use crate::report::working::expression::Expression;
use crate::report::working::reactions;
use crate::solver::{Condition, LoadAction};
use crate::wording::words;
use crate::{Input, Load, PointId, Vec2};

/// Writes all parts on forces; nothing for a mechanism without loads.
pub(crate) fn forces(context: &Context<'_>, draft: &mut Draft) {
    if !context.solver.has_forces() {
        return;
    }
    draft.part(words().forces_part());
    let Some(torque) = context.state.drive() else {
        let withheld = crate::report::forces::withheld(context.scene, &context.state);
        let absent = || absent(context.state.condition()).to_owned();
        draft.text(withheld.unwrap_or_else(absent));
        return;
    };
    if !context.scene.mechanism.timed().is_empty() {
        draft.text(words().forces_of_inputs_in_tables());
        return;
    }
    let acted = context.solver.acted(&context.state);
    loads(context, draft, &acted);
    super::loads::laws(context, draft, &acted);
    if context.state.residual().is_none() {
        draft.text(words().reactions_need_not_exist());
    } else {
        reactions::reactions(context, draft, &acted);
        let links = context.scene.mechanism.link_ids();
        let open: Vec<&str> = links
            .filter(|&link| !free_body(context, draft, link, &acted))
            .map(|link| context.scene.link_name(link))
            .collect();
        if !open.is_empty() {
            draft.text(words().reactions_open(&open.join(", ")));
        }
        super::pins::pins(context, draft, &acted);
    }
    driver(context, draft, torque, &acted);
}

/// Returns the reason why there are no forces.
fn absent(condition: Condition) -> &'static str {
    match condition {
        Condition::DeadPoint => words().no_balance_at_dead_point(),
        Condition::NoAssembly => words().no_forces_without_assembly(),
        Condition::Ok | Condition::ChangePoint => words().no_forces_here(),
    }
}

/// Writes the loads in this state.
fn loads(context: &Context<'_>, draft: &mut Draft, acted: &[LoadAction]) {
    let mechanism = &context.scene.mechanism;
    let mut rows = Vec::new();
    for (load, acted) in mechanism.loads().iter().zip(acted) {
        let what = kind(load);
        for (point, force) in &acted.forces {
            let [x, y] = components(context, *force);
            rows.push([
                words().acts_at(what, point_name(context, *point)),
                x,
                y,
                "-".into(),
            ]);
        }
        for &(link, couple) in &acted.couples {
            let name = words().acts_on(what, context.scene.link_name(link));
            rows.push([name, "-".into(), "-".into(), context.figures.number(couple)]);
        }
    }
    if !rows.is_empty() {
        draft.text(words().loads_here());
        let torque = format!("{} [N m]", words().torque());
        draft.table([words().column_load(), "fx [N]", "fy [N]", &torque], rows);
    }
}

/// Returns the name of a kind of load.
pub(crate) fn kind(load: &Load) -> &'static str {
    match load {
        Load::Force { .. } => words().force(),
        Load::Torque { .. } => words().torque(),
        Load::Press { .. } => words().kind_press(),
        Load::Spring { .. } | Load::GasSpring { .. } | Load::TorsionSpring { .. } => {
            words().kind_spring()
        }
    }
}

pub(crate) fn components(context: &Context<'_>, force: Vec2) -> [String; 2] {
    let size = force.norm();
    [force.x, force.y].map(|v| context.figures.format_or_zero(v, size))
}

pub(crate) fn point_name<'a>(context: &'a Context<'_>, point: PointId) -> &'a str {
    context.scene.point_name(point).unwrap_or(words().a_point())
}

/// Writes the driver's effort, and its parts.
fn driver(context: &Context<'_>, draft: &mut Draft, drive: f64, acted: &[LoadAction]) {
    let (f, state) = (context.figures, context.state);
    let mechanism = &context.scene.mechanism;
    let aspect = Aspect::effort_of(mechanism.driver().input);
    let (is_rotary, what, unit) = (
        mechanism.driver().turns(),
        aspect.name(),
        effort_unit(aspect),
    );
    draft.section(match is_rotary {
        true => words().torque_of_driver(),
        false => words().force_of_driver(),
    });
    if let Some(parts) = state.drive_parts() {
        let size = parts
            .iter()
            .fold(0.0_f64, |maximum, v| maximum.max(v.abs()));
        let figures = parts.map(|v| Expression::figure(f.format_or_zero(v, size), v));
        let size_on_the_way = size.max(largest(context, acted));
        let computed = parts.iter().sum();
        draft.agree(format!("driver.{what}"), computed, drive, size_on_the_way);
        let effort = Formula::measured(f.format_or_zero(drive, size), unit);
        draft.text(match (state.residual(), is_rotary) {
            (Some(_), true) => words().torque_checked_by_work(&effort),
            (Some(_), false) => words().force_checked_by_work(&effort),
            (None, _) => words().effort_by_work().to_owned(),
        });
        super::loads::shares(context, draft, acted, parts);
        draft.equation([
            Formula::words(&format!("driver.{what}")),
            Expression::sum(super::loads::share_names().map(Expression::symbol)).symbols(),
            Expression::sum(figures).numbers(),
            effort,
        ]);
    }
    if let Some(power) = state.power() {
        let speed = speed_in_si(context);
        let [drive, speed] = [(f.number(drive), drive), (f.given(speed), speed)]
            .map(|(figure, value)| Expression::figure(figure, value));
        let name = Formula::words("driver.power");
        let computed = draft.write_numbers(name, &(drive * speed), |power| {
            Formula::measured(f.number(power), "W")
        });
        draft.agree("driver.power", computed, power, power.abs());
    }
}

/// Returns the driver's speed in rad/s or m/s.
pub(super) fn speed_in_si(context: &Context<'_>) -> f64 {
    let (mechanism, speed) = (&context.scene.mechanism, context.state.driver_speed());
    match mechanism.driver().input {
        Input::Turn(_) => speed,
        Input::Push(_) => speed * mechanism.metres(),
    }
}

/// Writes the two independent checks: power, and the equilibrium of the whole mechanism.
pub(crate) fn check(context: &Context<'_>, draft: &mut Draft) {
    let state = context.state;
    let (Some(left), Some(force), Some(moment)) =
        (state.residual(), state.frame_force(), state.frame_moment())
    else {
        return;
    };
    let f = context.figures;
    let [x, y] = components(context, force);
    draft.text(words().frame_feels(&x, &y, &f.number(moment)));
    let unit = effort_unit(Aspect::effort_of(context.scene.mechanism.driver().input));
    let small = |v: f64| {
        if v == 0.0 {
            "0".to_owned()
        } else {
            format!("{v:.1e}")
        }
    };
    let forces_in = |axis: &str| Formula::message(|[axis]| words().forces_in(axis), [axis.into()]);
    for (name, value, unit) in [
        (Formula::words(words().virtual_work()), left.drive, unit),
        (forces_in("x"), left.force.x, "N"),
        (forces_in("y"), left.force.y, "N"),
        (Formula::words(words().moments()), left.moment, "N m"),
    ] {
        draft.equation([name, Formula::measured(small(value), unit)]);
    }
}
