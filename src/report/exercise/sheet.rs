//! Writes the exercise sheet for students: the drawing, the given values, and tables to complete.

use crate::page::{Content, Facts, Page, Table};
use crate::report::check::{CheckedScene, inputs_given};
use crate::report::document::{Report, ReportedState};
use crate::report::text::number::{concise, without_noughts};
use crate::scene::{Measure, Scene, Value, ValueOwner};
use crate::solver::{Order, Solver, State};
use crate::study::AnswerKey;
use crate::wording::words;
use crate::{Body, Input, LinkId, SlideId, Slider, Vec2};

/// Mark of an unknown value.
const UNKNOWN_MARK: &str = "?";
/// Digits of computed given values, such as the length of the frame.
const DIGITS: usize = 9;
/// Maximum number of digits of a typed value; longer ones were computed from typed values.
const MAX_DIGITS: usize = 12;
/// Suffixes of the requested values of a point.
const POINT_ENDS: [&str; 4] = [".v", ".a", ".v.angle", ".a.angle"];
/// Digits of a speed in the unit of the tables, shown after the given one.
const SPEED_DIGITS: usize = 6;

impl Report {
    /// Creates the sheet of an exercise on a state solved with all rates; answers belong in a file
    /// of this name.
    #[must_use]
    pub fn sheet(
        scene: &Scene,
        solver: &Solver,
        state: &State,
        key: &AnswerKey,
        answers: &str,
    ) -> Report {
        let reported = ReportedState::new(scene, solver, state, DIGITS);
        let mut page = Page::default();
        page.title(&scene.name);
        page.text(words().name_and_number());
        reported.drawing(&mut page);
        page.part(words().given_part());
        page.add(Content::Facts(given(scene, solver, state, &reported)));
        page.part(words().asked_part());
        page.text(words().what_is_asked());
        if reported.has_loops() {
            for (order, text) in [
                (Order::Position, words().positions_asked()),
                (Order::Velocity, words().velocities_asked()),
                (Order::Acceleration, words().accelerations_asked()),
            ] {
                page.text(text);
                reported.question_tables(order, key, &mut page);
            }
        }
        points(key, &mut page);
        page.text(words().where_answers_belong(answers));
        names_in_answers(key, &mut page);
        Report { page }
    }
}

/// Returns the names of the requested points.
fn requested_points(key: &AnswerKey) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for figure in &key.figures {
        let name = figure.quantity.name.as_str();
        let point = POINT_ENDS[..2]
            .iter()
            .find_map(|end| name.strip_suffix(end));
        names.extend(point.filter(|point| !names.contains(point)));
    }
    names
}

/// Explains the names in the answer file. Those of points follow from their table, so one example
/// is given.
fn names_in_answers(key: &AnswerKey, page: &mut Page) {
    let points = requested_points(key);
    let is_of_point = |name: &str| {
        let mut all = POINT_ENDS.iter().filter_map(|end| name.strip_suffix(end));
        all.any(|point| points.contains(&point))
    };
    let names = key.figures.iter().map(|f| f.quantity.name.as_str());
    let others: Vec<&str> = names.filter(|name| !is_of_point(name)).collect();
    if !others.is_empty() {
        page.text(words().names_in_answers(&others.join(", ")));
    }
    if let Some(point) = points.first() {
        let names = POINT_ENDS.map(|end| format!("{point}{end}"));
        page.text(words().names_of_a_point(point, &names.join(", ")));
    }
}

/// Adds the table of requested points, with their velocities and accelerations.
fn points(key: &AnswerKey, page: &mut Page) {
    let names = requested_points(key);
    if names.is_empty() {
        return;
    }
    let unit = |name: String| {
        let mut figures = key.figures.iter();
        let figure = figures.find(|figure| figure.quantity.name == name);
        figure.map(|figure| figure.quantity.unit.clone())
    };
    let [v, a] = ["v", "a"].map(|end| {
        let of = names.iter().find_map(|name| unit(format!("{name}.{end}")));
        format!("{end} [{}]", of.unwrap_or_default())
    });
    let direction = words().direction_in_degrees();
    let mut table = Table::new(words().point(), [&v, direction, &a, direction]);
    for name in names {
        let cells = ["v", "v.angle", "a", "a.angle"].map(|end| {
            let is_asked = unit(format!("{name}.{end}")).is_some();
            if is_asked { UNKNOWN_MARK } else { "-" }.to_owned()
        });
        table.row(name, cells);
    }
    page.text(words().points_are_asked());
    page.table(table);
}

/// Returns all dimensions, and the motion of the driver.
fn given(scene: &Scene, solver: &Solver, state: &State, reported: &ReportedState<'_>) -> Facts {
    let mechanism = &scene.mechanism;
    let mut facts = Facts::default();
    let unit = scene.unit.symbol();
    for point in mechanism.point_ids() {
        if let (Some(name), Some(at)) = (scene.point_name(point), mechanism.point(point).ground) {
            facts.add(name, [words().fixed_at(&place(at), unit)]);
        }
    }
    for link in mechanism.link_ids() {
        facts.add(scene.link_name(link), describe_link(scene, link));
    }
    for slide in mechanism.slide_ids() {
        facts.add(
            scene.slide_name(slide),
            describe_slide(scene, slide, reported),
        );
    }
    let inputs = inputs_given(&CheckedScene::new(scene, solver));
    facts.add(
        words().driver(),
        [describe_driver(scene, state)].into_iter().chain(inputs),
    );
    facts
}

/// Describes the position and the speed of the driver.
fn describe_driver(scene: &Scene, state: &State) -> String {
    let unit = scene.unit.symbol();
    let (name, [at, speed, acceleration]) = match scene.mechanism.driver().input {
        input @ Input::Turn(_) => (
            scene.driven_name(input),
            ["deg", "rad/s", "rad/s^2"].map(str::to_owned),
        ),
        input @ Input::Push(_) => (
            scene.driven_name(input),
            ["", "/s", "/s^2"].map(|per| format!("{unit}{per}")),
        ),
    };
    let rates = [Measure::TurnSpeed, Measure::PushSpeed];
    let second = [Measure::TurnAcceleration, Measure::PushAcceleration];
    words().driver_stands(
        &name,
        &format!("{} {at}", figure(state.at())),
        &describe_rate(scene, rates, state.driver_speed(), &speed),
        &describe_rate(scene, second, state.driver_acceleration(), &acceleration),
    )
}

/// Formats a rate of the driver as given, and in the unit of the tables if that differs.
fn describe_rate(scene: &Scene, measures: [Measure; 2], value: f64, unit: &str) -> String {
    let is_it = |v: &Value| v.owner == ValueOwner::Driver && measures.contains(&v.measure);
    match scene.values().into_iter().find(is_it) {
        Some(given) if given.unit != unit => {
            let text = match given.formula {
                Some(_) => format!("{} {}", figure(given.number), given.unit),
                None => given.text(),
            };
            format!("{text} ({} {unit})", concise(value, SPEED_DIGITS))
        }
        _ => format!("{} {unit}", figure(value)),
    }
}

/// Formats a given value with all typed digits.
fn figure(value: f64) -> String {
    without_noughts(concise(value, MAX_DIGITS))
}

/// Formats a point by its coordinates.
fn place(at: Vec2) -> String {
    format!("({}, {})", figure(at.x), figure(at.y))
}

/// Describes a link: its ends and its length, then its further points.
fn describe_link(scene: &Scene, link: LinkId) -> Vec<String> {
    let of = scene.mechanism.link(link);
    let unit = scene.unit.symbol();
    let name = |point| scene.point_name(point).unwrap_or_default();
    let mut lines = Vec::new();
    if let Some((from, to)) = of.ends
        && let Some(local) = of.local(to)
    {
        let length = figure(local.norm());
        lines.push(words().link_from_to(name(from), name(to), &length, unit));
    }
    for member in &of.members {
        let is_end = of.ends.is_some_and(|(a, b)| [a, b].contains(&member.point));
        let its = name(member.point);
        if is_end || its.is_empty() {
            continue;
        }
        lines.push(match member.polar {
            Some(polar) => {
                let base = polar.from.or(of.ends.map(|(from, _)| from)).map(name);
                let base = base.unwrap_or_else(|| words().the_origin());
                let [length, angle] = [polar.length, polar.angle].map(figure);
                words().point_seen_from(its, base, &length, unit, &angle)
            }
            None => words().point_on_link(its, &place(member.local), unit),
        });
    }
    lines
}

/// Describes a slide: slider, guide, and the angle between a sliding link and its guide.
fn describe_slide(scene: &Scene, slide: SlideId, reported: &ReportedState<'_>) -> Vec<String> {
    let of = scene.mechanism.slide(slide);
    let (what, turn) = match of.slider {
        Slider::Pin(point) => (scene.point_name(point).unwrap_or_default(), 0.0),
        Slider::Link { link, turn, .. } => (scene.link_name(link), turn),
    };
    let on = match of.on {
        Body::Ground => words().the_frame(),
        Body::Link(link) => scene.link_name(link),
    };
    let point = reported.guide_point(slide).unwrap_or_default();
    let through = match of.named {
        Some(_) => point.to_owned(),
        None => format!("{point} {} {}", place(of.through), scene.unit.symbol()),
    };
    let mut lines = vec![words().slides_along(what, on, through.trim_start(), &figure(of.angle))];
    if turn != 0.0 {
        lines.push(words().lies_to_guide(what, &figure(turn)));
    }
    lines
}
