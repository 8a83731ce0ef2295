//! Writes the beginning of the working: the driver, the state, the vector polygons and the position
//! table.

use super::context::{Context, Draft};
use super::expression::Expression;
use super::loops::polygon::Loop;
use super::loops::sides::{Side, Turns};
use crate::page::{Formula, Symbol};
use crate::quantity::{Catalogue, state_word};
use crate::report::text::number::concise;
use crate::report::text::places::limits_text;
use crate::solver::{Condition, Order};
use crate::study::UnknownKind;
use crate::wording::words;
use crate::{Body, Input, InputLaw};

/// Writes the title, and the driver's coordinate.
pub(super) fn heading(context: &Context<'_>, draft: &mut Draft) {
    let Context {
        scene,
        state,
        figures,
        ..
    } = context;
    draft.page.title(&scene.title());
    let name = &scene.driven_name(scene.mechanism.driver().input);
    let kind = match scene.mechanism.driver().input {
        Input::Turn(_) => UnknownKind::Angle,
        Input::Push(_) => UnknownKind::Length,
    };
    let orders = [Order::Position, Order::Velocity, Order::Acceleration];
    let units = orders.map(|order| figures.rate_unit(kind, order));
    let condition = &words().condition_called(state_word(state.condition()));
    let [at, speed, acceleration] = units;
    let at = format!("{} {at}", concise(state.at(), usize::MAX));
    let speed = format!("{} {speed}", figures.given(state.driver_speed()));
    let given = figures.given(state.driver_acceleration());
    let acceleration = format!("{given} {acceleration}");
    draft.text(match kind {
        UnknownKind::Angle => words().driver_turns(condition, name, &at, &speed, &acceleration),
        UnknownKind::Length => words().driver_slides(condition, name, &at, &speed, &acceleration),
    });
    if let Some(text) = condition_text(context) {
        draft.text(text);
    }
    inputs(context, draft);
}

/// Writes how the other inputs follow the driver, with their coordinates.
fn inputs(context: &Context<'_>, draft: &mut Draft) {
    let mechanism = &context.scene.mechanism;
    let symbol = |input| match input {
        Input::Turn(link) => {
            let name = |link| Expression::symbol(context.theta(link));
            match mechanism.turned_from(link) {
                Body::Ground => name(link),
                Body::Link(from) => name(link) - name(from),
            }
        }
        Input::Push(slide) => Expression::symbol(context.scene.slide_name(slide)),
    };
    if !mechanism.timed().is_empty() {
        draft.text(words().inputs_are_given());
    }
    for timed in mechanism.timed() {
        let at = timed.coordinate(context.state.at());
        let [at, unit] = match timed.input {
            Input::Turn(_) => [context.figures.direction(at), "deg".to_owned()],
            Input::Push(_) => [context.figures.given(at), context.figures.length_unit(0)],
        };
        let (name, at) = (symbol(timed.input), Formula::measured(at, &unit));
        match timed.law {
            InputLaw::Ratio { ratio, phase } => {
                let number = |v| Expression::figure(concise(v, usize::MAX), v);
                let turned = number(ratio.abs()) * symbol(mechanism.driver().input);
                let law = turned.minus_if(ratio < 0.0) + number(phase);
                draft.equation([name.symbols(), law.symbols(), at]);
            }
            InputLaw::Table(_) => {
                let name = name.symbols();
                draft.text(words().inputs_have_tables(&name));
                draft.equation([name.clone(), at]);
                let driver = mechanism.driver().input;
                let by = symbol(driver).symbols();
                let derivative = |before: &str| {
                    let above = Formula::words(before).then(name.clone());
                    let below = Formula::words("d").then(by.clone());
                    above.with_sign('/').then(below)
                };
                let names = [derivative("d"), derivative("d²").with_sign('²')];
                let rates = timed.rates(context.state.at(), driver);
                let unit = |input| context.scene.input_rate_unit(input);
                let [own, per] = [unit(timed.input), unit(driver)];
                let units = match own == per {
                    true => [String::new(), format!("1/{per}")],
                    false => [format!("{own}/{per}"), format!("{own}/{per}^2")],
                };
                for ((name, rate), unit) in names.into_iter().zip(rates).zip(units) {
                    let rate = Formula::measured(context.figures.given(rate), &unit);
                    draft.equation([name, rate]);
                }
            }
        }
    }
}

/// Writes the unit vectors by which equations are multiplied, as the lecture defines them.
pub(super) fn unit_vectors(context: &Context<'_>, draft: &mut Draft) {
    if context.polygon.loops.is_empty() {
        return;
    }
    let notation = context.notation;
    let (along, across) = (notation.along("θ"), notation.across("θ"));
    draft.text(words().unit_vectors_are(&along, &across));
    let [u, n] = notation.names();
    let symbol = |name: &str| Expression::symbol(name);
    let [cos, sin] = symbol("θ").cos_and_sin();
    let [x, y] = [cos.clone(), sin.clone()];
    let turning = |vector: &Formula| symbol("ω") * Expression::symbol(vector.clone());
    for (vector, sum) in [
        (along.clone(), x * symbol("i") + y * symbol("j")),
        (across.clone(), -(sin * symbol("i")) + cos * symbol("j")),
        (u.clone().derivative(1).into(), turning(&across)),
        (n.clone().derivative(1).into(), -turning(&along)),
    ] {
        draft.equation([vector, sum.symbols()]);
    }
    let product = |one: &Symbol, other: &Symbol| {
        let of = |vector: &Symbol, angle: &str| {
            Formula::from(vector).then(Formula::from(angle).in_brackets())
        };
        of(one, "a").with_sign('·').then(of(other, "b"))
    };
    let [cos, sin] = (symbol("a") - symbol("b")).cos_and_sin();
    draft.equation([product(&u, &u), product(&n, &n), cos.symbols()]);
    draft.equation([product(&u, &n), sin.symbols()]);
}

/// Explains the consequences of the state's condition; returns `None` for an ordinary state.
fn condition_text(context: &Context<'_>) -> Option<String> {
    match context.state.condition() {
        Condition::Ok => None,
        Condition::DeadPoint => Some(words().dead_point_explained().into()),
        Condition::ChangePoint => Some(words().change_point_explained().into()),
        Condition::NoAssembly => {
            let catalogue = Catalogue::new(context.scene);
            let limits = limits_text(context.solver.motion().range, catalogue.driver());
            Some(words().no_assembly_explained(&limits))
        }
    }
}

/// Writes the closed loops, and the vectors outside them.
pub(super) fn polygons(context: &Context<'_>, draft: &mut Draft) {
    let polygon = context.polygon;
    draft.part(words().vector_polygons());
    for (number, of) in polygon.loops.iter().enumerate() {
        draft.write_zero(sum_text(context, of));
        let walk = solved(context, of);
        draft.text(match polygon.loops.len() {
            1 => walk,
            _ => words().loop_is(number + 1, &walk),
        });
    }
    if polygon.loops.is_empty() {
        draft.text(words().no_closed_loop());
    }
    let between: Vec<String> = polygon
        .sides
        .iter()
        .filter(|side| !side.named)
        .map(|side| words().vector_on(&side.name, &side.tail, &side.head, place(context, side)))
        .collect();
    if !between.is_empty() {
        let between = between.join("; ");
        draft.text(words().beside_vectors_of_scene(&between));
    }
    let riders: Vec<&str> = polygon.riders().map(|side| side.name.as_str()).collect();
    if !riders.is_empty() {
        draft.text(words().in_no_loop(&riders.join(", ")));
    }
}

/// Returns the loop as a sum of vectors.
pub(super) fn sum_text(context: &Context<'_>, of: &Loop) -> Formula {
    let sides = context
        .polygon
        .terms(of)
        .map(|(side, reversed)| Expression::symbol(side.name.as_str()).minus_if(reversed));
    Expression::sum(sides).symbols()
}

/// Returns the points of a loop in order, and the group that solves it.
fn solved(context: &Context<'_>, of: &Loop) -> String {
    let walk = context.polygon.walk(of);
    match of.group {
        None => words().tells_further_vector(&walk),
        Some(_) if context.polygon.loops.len() == 1 => walk,
        Some(group) => words().solved_by_group(&walk, group + 1),
    }
}

/// Returns the name of the body that carries a vector.
fn place<'c>(context: &Context<'c>, side: &Side) -> &'c str {
    use super::loops::sides::SideShape;
    match side.shape {
        SideShape::Rigid(crate::Body::Link(link), _) => context.scene.link_name(link),
        SideShape::Rigid(crate::Body::Ground, _)
        | SideShape::Link(_)
        | SideShape::Slide(_)
        | SideShape::Free(..) => words().the_ground(),
    }
}

/// Writes length and angle of every vector, marked as given, driven or unknown.
pub(super) fn position_table(context: &Context<'_>, draft: &mut Draft) {
    draft.part(words().position_table());
    let figures = context.figures;
    let mut rows = Vec::new();
    for (side, reading) in context.polygon.sides.iter().zip(&context.readings) {
        let unknowns = [
            context.schedule.length_group(side),
            context.schedule.angle_group(side),
        ];
        let exists = unknowns.map(|group| group.is_none() || context.has_positions());
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
    let (vector, ends) = (words().vector(), words().column_ends());
    let [r_is, theta_is] = ["r", "θ"].map(|symbol| words().column_is(symbol));
    draft.table([vector, ends, &r, &r_is, "θ [deg]", &theta_is], rows);
    super::loops::by_coordinates::vectors(context, draft);
}

fn length_mark(context: &Context<'_>, side: &Side) -> &'static str {
    match context.schedule.length_group(side) {
        Some(_) => words().is_sought(),
        None if context.schedule.is_pushed(side) => input_mark(context, side),
        None => words().given(),
    }
}

/// Returns the mark of an input's coordinate: driver, or given if it follows the driver.
fn input_mark(context: &Context<'_>, side: &Side) -> &'static str {
    let driver = context.scene.mechanism.driver().input;
    match context.schedule.input(side) == Some(driver) {
        true => words().driver(),
        false => words().given(),
    }
}

fn angle_mark(context: &Context<'_>, side: &Side) -> String {
    let Some(link) = side.turns_with() else {
        let unknowns = context.schedule.angle_group(side).is_some();
        return match unknowns {
            true => words().is_sought().into(),
            false => words().given().into(),
        };
    };
    let Turns::With(_, offset) = side.turns else {
        return String::new();
    };
    let is_own = matches!(side.shape, super::loops::sides::SideShape::Link(own) if own == link);
    match (is_own, context.schedule.is_driven(side)) {
        (true, true) => input_mark(context, side).into(),
        (true, false) => words().is_sought().into(),
        (false, _) => context.leading_angle(link, offset).to_string(),
    }
}

/// Returns rows for links that are not vectors: they only have an angle.
fn bodies_without_ends(context: &Context<'_>) -> Vec<[String; 6]> {
    let mechanism = &context.scene.mechanism;
    let links = mechanism.link_ids();
    let links = links.filter(|&link| mechanism.link(link).ends.is_none());
    links
        .map(|link| {
            let turns = context.polygon.locks.turns(crate::Body::Link(link), 0.0);
            let driven = mechanism.is_crank(link);
            let mark = match turns {
                Turns::Never => words().given().into(),
                _ if mechanism.is_directed(link) && !driven => words().given().into(),
                _ if driven => words().driver().into(),
                Turns::With(root, _) if root == link => words().is_sought().into(),
                Turns::With(root, offset) => context.leading_angle(root, offset).to_string(),
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
