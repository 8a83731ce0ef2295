//! The sheet that is handed out: the drawing, what is given, and tables to fill.

use crate::page::{Content, Facts, Page, Table};
use crate::report::check::DriverKind;
use crate::report::input_facts::InputFacts;
use crate::report::number::{concise, without_noughts};
use crate::report::paper::{Report, ReportedState};
use crate::scene::{Measure, Scene, Value, ValueOwner};
use crate::solver::{Order, Solver, State};
use crate::study::AnswerKey;
use crate::wording::words;
use crate::{Body, Input, LinkId, SlideId, Slider, Vec2};

/// Stands for what is to be found.
const SOUGHT: &str = "?";
/// Digits of given figures that are no shorter: of a frame's length, say.
const DIGITS: usize = 9;
/// Digits of what is given by more of them than anybody types: it was computed from what was typed.
const MOST_DIGITS: usize = 12;
/// How the names of what is asked of a point end.
const POINT_ENDS: [&str; 4] = [".v", ".a", ".v.angle", ".a.angle"];
/// Digits of a speed in the unit of the tables, behind the one in which it is given.
const SPEED_DIGITS: usize = 6;

impl Report {
    /// The sheet of an exercise on a state that was solved with all rates; answers belong into a file of this name.
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
            for (order, told) in [
                (Order::Position, words().positions_asked()),
                (Order::Velocity, words().velocities_asked()),
                (Order::Acceleration, words().accelerations_asked()),
            ] {
                page.text(told);
                reported.asked_tables(order, key, &mut page);
            }
        }
        points(key, &mut page);
        page.text(words().where_answers_belong(answers));
        names_in_answers(key, &mut page);
        Report { page }
    }
}

/// The points that are asked for.
fn asked_points(key: &AnswerKey) -> Vec<&str> {
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

/// How the file of answers calls what the tables ask for: the points, whose names stand in their table, by an example.
fn names_in_answers(key: &AnswerKey, page: &mut Page) {
    let points = asked_points(key);
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

/// The points that are asked for, with their velocities and accelerations.
fn points(key: &AnswerKey, page: &mut Page) {
    let names = asked_points(key);
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
            if is_asked { SOUGHT } else { "-" }.to_owned()
        });
        table.row(name, cells);
    }
    page.text(words().points_are_asked());
    page.table(table);
}

/// All dimensions, and how the driver moves.
fn given(scene: &Scene, solver: &Solver, state: &State, reported: &ReportedState<'_>) -> Facts {
    let mechanism = &scene.mechanism;
    let mut facts = Facts::default();
    let unit = scene.unit.symbol();
    for point in mechanism.point_ids() {
        if let (Some(name), Some(at)) = (scene.point_name(point), mechanism.point(point).ground) {
            facts.tell(name, [words().fixed_at(&place(at), unit)]);
        }
    }
    for link in mechanism.link_ids() {
        facts.tell(scene.link_name(link), link_told(scene, link));
    }
    for slide in mechanism.slide_ids() {
        facts.tell(scene.slide_name(slide), slide_told(scene, slide, reported));
    }
    let (kind, _) = DriverKind::of(scene, mechanism.driver().input);
    let inputs = InputFacts::of(scene, solver.motion().range);
    let inputs = inputs.iter().map(|input| input.given(kind, unit));
    facts.tell(
        words().driver(),
        [driver_told(scene, state)].into_iter().chain(inputs),
    );
    facts
}

/// Where the driver stands, and how fast it is.
fn driver_told(scene: &Scene, state: &State) -> String {
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
        &rate_told(scene, rates, state.driver_speed(), &speed),
        &rate_told(scene, second, state.driver_acceleration(), &acceleration),
    )
}

/// A rate of the driver as it is given, and in the unit of the tables where that is another one.
fn rate_told(scene: &Scene, measures: [Measure; 2], value: f64, unit: &str) -> String {
    let is_it = |v: &Value| v.owner == ValueOwner::Driver && measures.contains(&v.measure);
    match scene.values().into_iter().find(is_it) {
        Some(given) if given.unit != unit => {
            let told = match given.formula {
                Some(_) => format!("{} {}", figure(given.number), given.unit),
                None => given.text(),
            };
            format!("{told} ({} {unit})", concise(value, SPEED_DIGITS))
        }
        _ => format!("{} {unit}", figure(value)),
    }
}

/// A given figure, with all digits that anybody has typed.
fn figure(value: f64) -> String {
    without_noughts(concise(value, MOST_DIGITS))
}

/// A place by its coordinates.
fn place(at: Vec2) -> String {
    format!("({}, {})", figure(at.x), figure(at.y))
}

/// A link: its ends and its length, then its further points.
fn link_told(scene: &Scene, link: LinkId) -> Vec<String> {
    let of = scene.mechanism.link(link);
    let unit = scene.unit.symbol();
    let name = |point| scene.point_name(point).unwrap_or_default();
    let mut told = Vec::new();
    if let Some((from, to)) = of.ends
        && let Some(local) = of.local(to)
    {
        let length = figure(local.norm());
        told.push(words().link_from_to(name(from), name(to), &length, unit));
    }
    for member in &of.members {
        let is_end = of.ends.is_some_and(|(a, b)| [a, b].contains(&member.point));
        let its = name(member.point);
        if is_end || its.is_empty() {
            continue;
        }
        told.push(match member.polar {
            Some(polar) => {
                let base = polar.from.or(of.ends.map(|(from, _)| from)).map(name);
                let base = base.unwrap_or_else(|| words().the_origin());
                let [length, angle] = [polar.length, polar.angle].map(figure);
                words().point_seen_from(its, base, &length, unit, &angle)
            }
            None => words().point_on_link(its, &place(member.local), unit),
        });
    }
    told
}

/// A slide: what moves along what, and how a link that does not turn on its guide lies to it.
fn slide_told(scene: &Scene, slide: SlideId, reported: &ReportedState<'_>) -> Vec<String> {
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
    let mut told = vec![words().slides_along(what, on, through.trim_start(), &figure(of.angle))];
    if turn != 0.0 {
        told.push(words().lies_to_guide(what, &figure(turn)));
    }
    told
}
