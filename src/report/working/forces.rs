//! Forces: what acts, every link and pin in turn, and the driver.

use super::draft::{Context, Draft};
use super::expression::Expression;
use super::figures::Sum;
use super::free_body::{free_body, largest};
use crate::solver::{Acted, Condition, GroupKind};
use crate::{Input, Load, PointId, Vec2};

/// Everything about forces; nothing where nothing acts.
pub(super) fn forces(context: &Context<'_>, draft: &mut Draft) {
    if !context.solver.has_forces() {
        return;
    }
    draft.page.part("Forces");
    let Some(torque) = context.state.drive() else {
        let withheld = crate::report::forces::withheld(context.scene, &context.state);
        let absent = || absent(context.state.condition()).to_owned();
        draft.page.text(withheld.unwrap_or_else(absent));
        return;
    };
    let acted = context.solver.acted(&context.state);
    loads(context, draft, &acted);
    super::loads::laws(context, draft, &acted);
    if context.state.residual().is_none() {
        draft.page.text(
            "The reactions need not exist at this place; the driver's torque follows from the virtual work.",
        );
    } else {
        order(context, draft);
        let links = context.scene.mechanism.link_ids();
        let open: Vec<&str> = links
            .filter(|&link| !free_body(context, draft, link, &acted))
            .map(|link| context.scene.link_name(link))
            .collect();
        if !open.is_empty() {
            draft.page.text(format!(
                "A redundant linkage leaves reactions open of {}: equilibrium alone does not tell them.",
                open.join(", ")
            ));
        }
        super::pins::pins(context, draft, &acted);
    }
    driver(context, draft, torque, &acted);
}

/// In which order the reactions are found.
fn order(context: &Context<'_>, draft: &mut Draft) {
    let count = context.solver.plan().groups.len();
    let groups: Vec<String> = (0..count).rev().map(|k| context.group_text(k)).collect();
    draft.page.text(format!(
        "The reactions are the unknowns in the equations of motion of the links below. They are found group by \
         group, the last first, since a group hands on what it bears to those before it: {}. The driver's own \
         comes last.",
        groups.join("; ")
    ));
    let groups = &context.solver.plan().groups;
    if groups.iter().any(|group| group.kind == GroupKind::Rrr) {
        draft.page.text(
            "In a dyad RRR the force F at the inner pin on the first link follows from the moments of each link \
             about its outer pivot: e x F + M1 = 0 and -f x F + M2 = 0, with e and f from the pivots to the inner \
             pin, and M1, M2 the moments of all else on each link, its inertia among it. A load on that pin goes with the second link.",
        );
    }
}

/// Why there are no forces.
fn absent(condition: Condition) -> &'static str {
    match condition {
        Condition::DeadPoint => {
            "At a dead point the mechanical advantage is infinite: no torque of the driver balances the loads, \
             and the reactions do not exist."
        }
        Condition::NoAssembly => "Without an assembly there are none.",
        Condition::Ok | Condition::ChangePoint => "They do not exist here.",
    }
}

/// What the loads are at this state.
fn loads(context: &Context<'_>, draft: &mut Draft, acted: &[Acted]) {
    let mechanism = &context.scene.mechanism;
    let mut rows = Vec::new();
    for (load, acted) in mechanism.loads().iter().zip(acted) {
        let what = kind(load);
        for (point, force) in &acted.forces {
            let [x, y] = components(context, *force);
            rows.push([
                format!("{what} at {}", point_name(context, *point)),
                x,
                y,
                "-".into(),
            ]);
        }
        if let Some((link, couple)) = acted.couple {
            let name = format!("{what} on {}", context.scene.link_name(link));
            rows.push([name, "-".into(), "-".into(), context.figures.number(couple)]);
        }
    }
    if !rows.is_empty() {
        draft.page.text("The loads here:");
        draft.table(["load", "fx [N]", "fy [N]", "torque [N m]"], rows);
    }
}

/// What a load is.
pub(super) fn kind(load: &Load) -> &'static str {
    match load {
        Load::Force { .. } => "force",
        Load::Torque { .. } => "torque",
        Load::Press { .. } => "press",
        Load::Spring { .. } => "spring",
    }
}

pub(super) fn components(context: &Context<'_>, force: Vec2) -> [String; 2] {
    let size = force.norm();
    [force.x, force.y].map(|v| context.figures.beside(v, size))
}

pub(super) fn point_name<'a>(context: &'a Context<'_>, point: PointId) -> &'a str {
    context.scene.point_name(point).unwrap_or("a point")
}

/// What the driver must do, and against what.
fn driver(context: &Context<'_>, draft: &mut Draft, drive: f64, acted: &[Acted]) {
    let (f, state) = (context.figures, context.state);
    let (what, unit) = match context.scene.mechanism.driver().input {
        Input::Turn(_) => ("torque", "N m"),
        Input::Push(_) => ("force", "N"),
    };
    draft.page.section(format!("The driver's {what}"));
    if let Some(parts) = state.drive_parts() {
        let size = parts.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        let mut sum = Sum::default();
        parts
            .iter()
            .for_each(|v| sum.push_figure(&f.beside(*v, size)));
        let size_on_the_way = size.max(largest(context, acted));
        let worked = parts.iter().sum();
        draft.agree(&format!("driver.{what}"), worked, drive, size_on_the_way);
        let check = format!(
            "The driver's {what} of {} {unit} follows from the balance of the links. The virtual work of the \
             loads, of gravity and of inertia must give the same, and is its check",
            f.beside(drive, size)
        );
        let way = match state.residual() {
            Some(_) => check,
            None => "By the virtual work of the loads, of gravity and of inertia".to_owned(),
        };
        draft.page.text(format!(
            "{way}. Each share is the power of its forces, with the other sign, divided by the driver's speed."
        ));
        super::loads::shares(context, draft, acted, parts);
        draft.page.equation([
            format!("driver.{what}"),
            "load + gravity + inertia".into(),
            sum.text(),
            format!("{} {unit}", f.beside(drive, size)),
        ]);
    }
    if let Some(power) = state.power() {
        let speed = match context.scene.mechanism.driver().input {
            Input::Turn(_) => state.driver_speed(),
            Input::Push(_) => state.driver_speed() * context.scene.mechanism.metres(),
        };
        let [drive, speed] = [(f.number(drive), drive), (f.given(speed), speed)]
            .map(|(figure, value)| Expression::figure(figure, value));
        let worked = draft.reckoned("driver.power", &(drive * speed), |power| {
            format!("{} W", f.number(power))
        });
        draft.agree("driver.power", worked, power, power.abs());
    }
}

/// The two independent checks: power, and the equilibrium of the whole.
pub(super) fn check(context: &Context<'_>, draft: &mut Draft) {
    let state = context.state;
    let (Some(left), Some(force), Some(moment)) =
        (state.residual(), state.frame_force(), state.frame_moment())
    else {
        return;
    };
    let f = context.figures;
    let [x, y] = components(context, force);
    draft.page.text(format!(
        "The frame feels {x} N along x, {y} N along y and a moment of {} N m about the origin. What is left of \
         the balance of power and of the equilibrium of the whole, each found by a way of its own:",
        f.number(moment)
    ));
    let unit = match context.scene.mechanism.driver().input {
        Input::Turn(_) => "N m",
        Input::Push(_) => "N",
    };
    let small = |v: f64| {
        if v == 0.0 {
            "0".to_owned()
        } else {
            format!("{v:.1e}")
        }
    };
    for (name, value, unit) in [
        ("virtual work", left.drive, unit),
        ("forces, x", left.force.x, "N"),
        ("forces, y", left.force.y, "N"),
        ("moments", left.moment, "N m"),
    ] {
        draft
            .page
            .equation([name.to_owned(), format!("{} {unit}", small(value))]);
    }
}
