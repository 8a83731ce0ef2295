//! A group whose reactions depend on one another: the equations of all its links at once, with numbers.

use super::super::draft::{Context, Draft};
use super::super::figures::WrittenSum;
use super::super::free_body::{BodyForce, BodyJoint};
use super::body::{GroupBody, Reckoning, known};
use crate::wording::words;
use crate::{Input, Slider, Vec2};

/// More equations than this nobody reads.
const MOST_LINKS: usize = 8;

/// Something sought: what of it acts on which link is its value times a unit force there.
struct SoughtForce {
    symbol: String,
    told: String,
    value: f64,
    unit: &'static str,
    /// On these links, by their place in the group: a force of this direction at a place, or a couple.
    acts: Vec<(usize, BodyForce)>,
}

/// Writes what is sought, and every equation.
pub(super) fn write(context: &Context<'_>, draft: &mut Draft, bodies: &[GroupBody]) {
    if bodies.len() > MOST_LINKS {
        draft.page.text(words().reactions_too_many(bodies.len()));
        return;
    }
    let f = context.figures;
    let sought = sought(context, bodies);
    draft.page.text(words().reactions_at_once(sought.len()));
    let rows = sought.iter().map(|one| {
        let value = format!("{} {}", f.number(one.value), one.unit);
        [one.symbol.clone(), one.told.clone(), value]
    });
    let rows: Vec<[String; 3]> = rows.collect();
    draft.table(
        [
            words().sought_reaction(),
            words().what_it_is(),
            words().value(),
        ],
        rows,
    );
    for (k, body) in bodies.iter().enumerate() {
        let name = context.scene.link_name(body.link);
        draft.page.text(words().sums_of_link(name));
        let about = body.sought.iter().chain(&body.given).find_map(|row| row.at);
        let about = about.unwrap_or(Vec2::ZERO);
        for (reckoning, what) in [
            (Reckoning::Along(Vec2::new(1.0, 0.0)), "x"),
            (Reckoning::Along(Vec2::new(0.0, 1.0)), "y"),
            (Reckoning::About(about), "M"),
        ] {
            equation(context, draft, (k, body), &sought, (reckoning, what));
        }
    }
}

/// `0.5 F1x - 0.2 F1y + 3.1 = 0`.
fn equation(
    context: &Context<'_>,
    draft: &mut Draft,
    (place, body): (usize, &GroupBody),
    sought: &[SoughtForce],
    (reckoning, what): (Reckoning, &str),
) {
    let f = context.figures;
    let mut written = WrittenSum::default();
    let known = known(context, &body.given, reckoning);
    let (mut sum, mut size) = (known.value, known.size);
    for one in sought {
        for (_, unit) in one.acts.iter().filter(|(k, _)| *k == place) {
            let share = reckoning.of(context, unit);
            let figure = f.beside(share, 1.0);
            sum += share * one.value;
            size += reckoning.most(context, unit) * one.value.abs();
            match figure.as_str() {
                "0" => {}
                _ if share == 1.0 => written.push(false, &one.symbol),
                _ if share == -1.0 => written.push(true, &one.symbol),
                figure => written.push_figure(&format!("{figure}·{}", one.symbol)),
            }
        }
    }
    let rest = f.beside(known.value, size);
    if rest != "0" {
        written.push_figure(&rest);
    }
    let link = context.scene.link_name(body.link);
    draft.agree(&words().sum_on(what, link), sum, 0.0, size);
    let text = written.text();
    if text != "0" {
        draft.page.equation([text, "0".to_owned()]);
    }
}

/// All that is sought, each once: what a pin between two links of the group bears acts on both.
fn sought(context: &Context<'_>, bodies: &[GroupBody]) -> Vec<SoughtForce> {
    let mut all: Vec<SoughtForce> = Vec::new();
    let mut done: Vec<BodyJoint> = Vec::new();
    for (k, body) in bodies.iter().enumerate() {
        for row in &body.sought {
            let Some(joint) = row.joint else { continue };
            let other = bodies
                .iter()
                .enumerate()
                .skip(k + 1)
                .find_map(|(j, other)| {
                    let row = other.sought.iter().find(|row| row.joint == Some(joint))?;
                    Some((j, row))
                });
            if done.contains(&joint) {
                continue;
            }
            // Where the pin itself is loaded, or more than two meet in it, each link has its own.
            let opposite = other.filter(|(_, other)| {
                let left = (row.force + other.force).norm();
                left <= 1e-9 * row.force.norm() && is_shared_by_two(bodies, joint)
            });
            if opposite.is_some() {
                done.push(joint);
            }
            components(context, (k, row), opposite.map(|(j, _)| j), &mut all);
        }
    }
    all
}

fn is_shared_by_two(bodies: &[GroupBody], joint: BodyJoint) -> bool {
    let with = bodies
        .iter()
        .filter(|body| body.sought.iter().any(|row| row.joint == Some(joint)));
    with.count() == 2
}

/// The parts of a reaction on a link, and with the other sign on another.
fn components(
    context: &Context<'_>,
    (place, row): (usize, &BodyForce),
    opposite: Option<usize>,
    all: &mut Vec<SoughtForce>,
) {
    let number = all.iter().filter(|one| one.symbol.starts_with('F')).count() / 2 + 1;
    let unit = |force: Vec2, couple: f64| BodyForce {
        name: String::new(),
        force,
        at: row.at,
        couple,
        joint: None,
    };
    let mut add = |symbol: String, told: String, value: f64, unit_force: (Vec2, f64)| {
        let (force, couple) = unit_force;
        let mut acts = vec![(place, unit(force, couple))];
        acts.extend(opposite.map(|j| (j, unit(-force, -couple))));
        all.push(SoughtForce {
            symbol,
            told,
            value,
            unit: if couple == 0.0 { "N" } else { "N m" },
            acts,
        });
    };
    match row.joint {
        Some(BodyJoint::Pin(_)) => {
            for (axis, unit) in [("x", Vec2::new(1.0, 0.0)), ("y", Vec2::new(0.0, 1.0))] {
                let told = format!("{} {axis}", row.name);
                add(
                    format!("F{number}{axis}"),
                    told,
                    unit.dot(row.force),
                    (unit, 0.0),
                );
            }
        }
        Some(BodyJoint::Guide(slide)) => {
            let name = context.scene.slide_name(slide);
            let n = context.state.travel(slide).guide.perp();
            let told = words().across(&row.name);
            add(format!("N_{name}"), told, n.dot(row.force), (n, 0.0));
            if context.scene.mechanism.driver().input == Input::Push(slide) {
                let t = context.state.travel(slide).guide;
                let told = words().along(&row.name);
                add(format!("D_{name}"), told, t.dot(row.force), (t, 0.0));
            }
            if let Slider::Link { .. } = context.scene.mechanism.slide(slide).slider {
                let told = words().moment_of(&row.name);
                add(format!("M_{name}"), told, row.couple, (Vec2::ZERO, 1.0));
            }
        }
        Some(BodyJoint::Driver) => {
            add(
                "M".into(),
                words().driver().into(),
                row.couple,
                (Vec2::ZERO, 1.0),
            );
        }
        None => {}
    }
}
