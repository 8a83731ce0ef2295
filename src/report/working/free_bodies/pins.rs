//! Writes the equilibrium of pins with a load: how the adjacent links share it.

use super::forces::{components, kind, point_name};
use super::free_body::{BodyForce, guided, is_joint, pin_name};
use crate::page::Formula;
use crate::report::working::context::{Context, Draft};
use crate::solver::LoadAction;
use crate::wording::words;
use crate::{PointId, Slider, Vec2};

/// Writes the equilibrium of every moving pin that joins several bodies and has a load or a spring.
pub(crate) fn pins(context: &Context<'_>, draft: &mut Draft, acted: &[LoadAction]) {
    let mechanism = &context.scene.mechanism;
    // A load on a ground pin goes directly into the ground.
    let moving = mechanism
        .point_ids()
        .filter(|&p| mechanism.point(p).ground.is_none() && is_joint(mechanism, p));
    for point in moving {
        let loads = mechanism.loads().iter().zip(acted);
        let on_pins = loads.filter(|(_, a)| a.on.is_none());
        let forces = on_pins.flat_map(|(load, a)| a.forces.iter().map(move |f| (kind(load), f)));
        let loads: Vec<(String, Vec2)> = forces
            .filter(|(_, (at, _))| *at == point)
            .map(|(what, (_, force))| (what.to_owned(), *force))
            .collect();
        if !loads.is_empty()
            && let Some(rows) = rows(context, point, loads)
        {
            draft.section(words().pin_part(point_name(context, point)));
            balance(context, draft, point, &rows);
        }
    }
}

/// Returns the forces on a pin, its loads first; `None` if one is indeterminate.
fn rows(
    context: &Context<'_>,
    point: PointId,
    mut rows: Vec<(String, Vec2)>,
) -> Option<Vec<(String, Vec2)>> {
    let mechanism = &context.scene.mechanism;
    for &link in &mechanism.point(point).links {
        let force = context.state.joint_force(link, point)?;
        let name = format!("-({})", pin_name(context, link, point));
        rows.push((name, -force));
    }
    let in_slot = |s: &_| mechanism.slide(*s).slider == Slider::Pin(point);
    for slide in mechanism.slide_ids().filter(in_slot) {
        let BodyForce { name, force, .. } = guided(context, slide, 1.0)?;
        rows.push((name, force));
    }
    Some(rows)
}

fn balance(context: &Context<'_>, draft: &mut Draft, point: PointId, rows: &[(String, Vec2)]) {
    let f = context.figures;
    let cells = rows.iter().map(|(name, force)| {
        let [x, y] = components(context, *force);
        [name.clone(), x, y]
    });
    draft.table([words().on_it(), "fx [N]", "fy [N]"], cells.collect());
    draft.text(words().load_at_pin());
    let size = rows
        .iter()
        .fold(0.0_f64, |maximum, row| maximum.max(row.1.norm()));
    for (axis, pick) in [("x", (|v| v.x) as fn(Vec2) -> f64), ("y", |v| v.y)] {
        let sum = f.sum(rows.iter().map(|(_, force)| pick(*force)), size);
        let left = rows.iter().map(|(_, force)| pick(*force)).sum();
        let name = words().forces_along(axis, point_name(context, point));
        draft.agree(&name, left, 0.0, size);
        draft.equation([sum.numbers(), Formula::measured("0", "N")]);
    }
}
