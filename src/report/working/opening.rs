//! How the working begins: the driver, the state, the vector polygons and the position table.

use super::draft::{Context, Draft};
use super::figures::Sum;
use super::polygon::Loop;
use super::sides::{Side, Turns};
use super::symbols;
use crate::quantity::{Catalogue, state_word};
use crate::report::check::limits_text;
use crate::solver::Condition;
use crate::{Input, LinkId};

/// The title, and where the driver is.
pub(super) fn heading(context: &Context<'_>, draft: &mut Draft) {
    let Context {
        scene,
        state,
        figures,
        ..
    } = context;
    draft.page.title(&scene.name);
    let (name, kind, units) = match scene.mechanism.driver().input {
        Input::Turn(link) => (
            scene.link_name(link),
            "turns",
            ["deg", "rad/s", "rad/s^2"].map(str::to_owned),
        ),
        Input::Push(slide) => {
            let units = [0, 1, 2].map(|order| figures.length_unit(order));
            (scene.slide_name(slide), "slides", units)
        }
    };
    let [at, speed, acceleration] = units;
    draft.page.text(format!(
        "State: {}. The driver {name} {kind}: at {} {at}, with {} {speed} and {} {acceleration}.",
        state_word(state.condition()),
        crate::report::number::concise(state.at(), usize::MAX),
        figures.given(state.driver_speed()),
        figures.given(state.driver_acceleration()),
    ));
    if let Some(text) = condition_text(context) {
        draft.page.text(text);
    }
}

/// What a state that is not ordinary means for what follows.
fn condition_text(context: &Context<'_>) -> Option<String> {
    match context.state.condition() {
        Condition::Ok => None,
        Condition::DeadPoint => Some(
            "A dead point: the motion ends here. Positions exist; velocities and accelerations do not, since \
             their equations would be divided by a sine that is 0."
                .into(),
        ),
        Condition::ChangePoint => Some(
            "A change point: two assemblies meet here. The equations of the rates are singular at this one \
             place; the velocities and accelerations given are the limits along the motion."
                .into(),
        ),
        Condition::NoAssembly => {
            let catalogue = Catalogue::new(context.scene);
            let limits = limits_text(context.solver.motion().range, catalogue.driver());
            Some(format!(
                "The mechanism cannot be assembled here: the driver covers {limits}. What follows is what the \
                 scene and the driver give."
            ))
        }
    }
}

/// The closed loops, and what no loop goes along.
pub(super) fn polygons(context: &Context<'_>, draft: &mut Draft) {
    let polygon = context.polygon;
    draft.page.part("Vector polygons");
    for (number, of) in polygon.loops.iter().enumerate() {
        draft.page.equation([sum_text(context, of), "0".into()]);
        let name = if polygon.loops.len() == 1 {
            String::new()
        } else {
            format!("Loop {}: ", number + 1)
        };
        draft
            .page
            .text(format!("{name}{}{}", polygon.walk(of), closer(context, of)));
    }
    if polygon.loops.is_empty() {
        draft
            .page
            .text("There is no closed loop: the driver alone places everything.");
    }
    let between: Vec<String> = polygon
        .sides
        .iter()
        .filter(|side| !side.named)
        .map(|side| {
            format!(
                "{} from {} to {} {}",
                side.name,
                side.tail,
                side.head,
                place(context, side)
            )
        })
        .collect();
    if !between.is_empty() {
        draft.page.text(format!(
            "Beside the scene's vectors: {}.",
            between.join("; ")
        ));
    }
    let riders: Vec<&str> = polygon.riders().map(|side| side.name.as_str()).collect();
    if !riders.is_empty() {
        draft
            .page
            .text(format!("In no loop: {}.", riders.join(", ")));
    }
}

/// The loop as a sum of vectors.
pub(super) fn sum_text(context: &Context<'_>, of: &Loop) -> String {
    let mut sum = Sum::default();
    for (side, reversed) in context.polygon.terms(of) {
        sum.push(reversed, &side.name);
    }
    sum.text()
}

/// Which group solves a loop.
fn closer(context: &Context<'_>, of: &Loop) -> String {
    match of.group {
        None => " (tells a further vector)".into(),
        Some(_) if context.polygon.loops.len() == 1 => String::new(),
        Some(group) => format!(" (group {})", group + 1),
    }
}

fn place(context: &Context<'_>, side: &Side) -> String {
    use super::sides::Shape;
    match side.shape {
        Shape::Rigid(crate::Body::Link(link), _) => {
            format!("on {}", context.scene.link_name(link))
        }
        Shape::Rigid(crate::Body::Ground, _)
        | Shape::Link(_)
        | Shape::Slide(_)
        | Shape::Free(..) => "on the ground".into(),
    }
}

/// Length and angle of every vector; what is given, what goes with the driver, what is sought.
pub(super) fn position_table(context: &Context<'_>, draft: &mut Draft) {
    draft.page.part("Position table");
    let figures = context.figures;
    let mut rows = Vec::new();
    for (side, reading) in context.polygon.sides.iter().zip(&context.readings) {
        let sought = [
            context.schedule.length_group(side),
            context.schedule.angle_group(side),
        ];
        let exists = sought.map(|group| group.is_none() || context.has_positions());
        let length = match (exists[0], side.stretches()) {
            (false, _) => "?".into(),
            (true, true) => figures.number(reading.r),
            (true, false) => figures.given(reading.r),
        };
        let angle = if exists[1] {
            figures.direction(reading.theta)
        } else {
            "?".into()
        };
        rows.push([
            side.name.clone(),
            format!("{} → {}", side.tail, side.head),
            length,
            length_mark(context, side).into(),
            angle,
            angle_mark(context, side),
        ]);
    }
    rows.extend(bodies_without_ends(context));
    let r = format!("r [{}]", figures.unit);
    draft.table(["vector", "from, to", &r, "r is", "θ [deg]", "θ is"], rows);
}

fn length_mark(context: &Context<'_>, side: &Side) -> &'static str {
    match context.schedule.length_group(side) {
        Some(_) => "sought",
        None if context.schedule.is_pushed(side) => "driver",
        None => "given",
    }
}

fn angle_mark(context: &Context<'_>, side: &Side) -> String {
    let Some(link) = side.turns_with() else {
        let sought = context.schedule.angle_group(side).is_some();
        return if sought { "sought" } else { "given" }.into();
    };
    let Turns::With(_, offset) = side.turns else {
        return String::new();
    };
    let is_own = matches!(side.shape, super::sides::Shape::Link(own) if own == link);
    match (is_own, context.schedule.is_driven(side)) {
        (true, true) => "driver".into(),
        (true, false) => "sought".into(),
        (false, _) => with_offset(context, link, offset),
    }
}

/// The angle of a link, and how far another lies ahead of it.
fn with_offset(context: &Context<'_>, link: LinkId, offset: f64) -> String {
    let theta = symbols::theta(context.scene.link_name(link));
    let by = context.figures.direction(offset);
    if by == "0" {
        theta
    } else {
        format!("{theta} + {by}")
    }
}

/// Links that are no vectors: they have an angle alone.
fn bodies_without_ends(context: &Context<'_>) -> Vec<[String; 6]> {
    let mechanism = &context.scene.mechanism;
    let links = mechanism.link_ids();
    let links = links.filter(|&link| mechanism.link(link).ends.is_none());
    links
        .map(|link| {
            let turns = context.polygon.locks.turns(crate::Body::Link(link), 0.0);
            let driven = mechanism.driver().input == Input::Turn(link);
            let mark = match turns {
                Turns::Never => "given".into(),
                _ if driven => "driver".into(),
                Turns::With(root, _) if root == link => "sought".into(),
                Turns::With(root, offset) => with_offset(context, root, offset),
                Turns::Freely => String::new(),
            };
            let angle = if context.has_positions() {
                context.figures.direction(context.state.angle(link))
            } else {
                "?".into()
            };
            let name = context.scene.link_name(link).to_owned();
            [name, "-".into(), "-".into(), "-".into(), angle, mark]
        })
        .collect()
}
