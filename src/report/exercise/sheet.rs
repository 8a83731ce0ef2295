//! The sheet that is handed out: the drawing, what is given, and tables to fill.

use crate::page::{Content, Facts, Page, Table};
use crate::report::number::concise;
use crate::report::paper::{Report, ReportedState};
use crate::scene::Scene;
use crate::solver::{Order, Solver, State};
use crate::study::AnswerKey;
use crate::wording::words;
use crate::{Body, Input, LinkId, SlideId, Slider, Vec2};

/// Stands for what is to be found.
const SOUGHT: &str = "?";
/// Digits of given figures that are no shorter: of a frame's length, say.
const DIGITS: usize = 9;

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
        page.add(Content::Facts(given(scene, state)));
        page.part(words().asked_part());
        page.text(words().what_is_asked());
        if reported.has_loops() {
            for order in [Order::Position, Order::Velocity, Order::Acceleration] {
                reported.asked(order, &mut page);
            }
        }
        points(key, &mut page);
        page.text(words().where_answers_belong(answers));
        Report { page }
    }
}

/// The points that are asked for, with their velocities and accelerations.
fn points(key: &AnswerKey, page: &mut Page) {
    let mut names: Vec<&str> = Vec::new();
    for figure in &key.figures {
        let name = figure.quantity.name.as_str();
        let point = [".v", ".a"].iter().find_map(|end| name.strip_suffix(end));
        names.extend(point.filter(|point| !names.contains(point)));
    }
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
fn given(scene: &Scene, state: &State) -> Facts {
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
        facts.tell(scene.slide_name(slide), [slide_told(scene, slide)]);
    }
    let figure = |value: f64| concise(value, usize::MAX);
    let (name, units) = match mechanism.driver().input {
        Input::Turn(link) => (
            scene.link_name(link),
            ["deg", "rad/s", "rad/s^2"].map(str::to_owned),
        ),
        Input::Push(slide) => (
            scene.slide_name(slide),
            ["", "/s", "/s^2"].map(|per| format!("{unit}{per}")),
        ),
    };
    let [at, speed, acceleration] = units;
    let told = words().driver_stands(
        name,
        &format!("{} {at}", figure(state.at())),
        &format!("{} {speed}", figure(state.driver_speed())),
        &format!("{} {acceleration}", figure(state.driver_acceleration())),
    );
    facts.tell(words().driver(), [told]);
    facts
}

/// A place by its coordinates.
fn place(at: Vec2) -> String {
    let figure = |value: f64| concise(value, usize::MAX);
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
        let length = concise(local.norm(), usize::MAX);
        told.push(words().link_from_to(name(from), name(to), &length, unit));
    }
    for member in &of.members {
        let is_end = of.ends.is_some_and(|(a, b)| [a, b].contains(&member.point));
        let name = name(member.point);
        if !is_end && !name.is_empty() {
            told.push(words().point_on_link(name, &place(member.local), unit));
        }
    }
    told
}

/// A slide: what moves along what.
fn slide_told(scene: &Scene, slide: SlideId) -> String {
    let of = scene.mechanism.slide(slide);
    let what = match of.slider {
        Slider::Pin(point) => scene.point_name(point).unwrap_or_default(),
        Slider::Link { link, .. } => scene.link_name(link),
    };
    let on = match of.on {
        Body::Ground => words().the_frame(),
        Body::Link(link) => scene.link_name(link),
    };
    let at = concise(of.angle, usize::MAX);
    words().slides_along(what, on, &place(of.through), scene.unit.symbol(), &at)
}
