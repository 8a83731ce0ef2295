//! Writes a group with coupled reactions: the equations of all its links together, with numbers.

use super::super::context::{Context, Draft};
use super::super::expression::Expression;
use super::super::figures::Figures;
use super::super::free_bodies::forces::point_name;
use super::super::free_bodies::free_body::{BodyForce, BodyJoint};
use super::body::{BalanceKind, GroupBody, known};
use crate::page::{Formula, Symbol};
use crate::wording::words;
use crate::{PointId, Slider, Vec2};

/// Maximum number of links for which the equations are shown.
const MAX_LINKS: usize = 8;

/// An unknown: its value times unit forces on the links.
struct UnknownForce {
    symbol: Symbol,
    description: String,
    value: f64,
    unit: &'static str,
    joint: BodyJoint,
    /// The unit force or couple on each link, by the link's index in the group.
    acts: Vec<(usize, BodyForce)>,
}

/// Writes the unknowns, and every equation.
pub(super) fn write(context: &Context<'_>, draft: &mut Draft, bodies: &[GroupBody]) {
    if bodies.len() > MAX_LINKS {
        draft.text(words().reactions_too_many(bodies.len()));
        return;
    }
    let f = context.figures;
    let unknowns = unknown_forces(context, bodies);
    draft.text(words().reactions_at_once(unknowns.len()));
    let rows = unknowns.iter().map(|one| {
        let value = format!("{} {}", f.number(one.value), one.unit);
        [one.symbol.to_string(), one.description.clone(), value]
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
    let mut equations = Vec::new();
    for (k, body) in bodies.iter().enumerate() {
        let Some(about) = centre(context, body) else {
            continue;
        };
        let name = context.scene.link_name(body.link);
        let at = point_name(context, about);
        draft.text(words().sums_of_link(name, at));
        for (reckoning, what) in [
            (BalanceKind::Along(Vec2::new(1.0, 0.0)), "x"),
            (BalanceKind::Along(Vec2::new(0.0, 1.0)), "y"),
            (BalanceKind::About(context.state.position(about)), "M"),
        ] {
            let equation = SumOfLink::of(context, (k, body), &unknowns, reckoning);
            equation.write(context, draft, &unknowns);
            let link = context.scene.link_name(body.link);
            let left = equation.left(&unknowns);
            draft.agree(words().sum_on(what, link), left, 0.0, equation.size);
            equations.push(equation);
        }
    }
    one_by_one(context, draft, &unknowns, &equations);
}

/// Returns the reference point of moments: preferably a pin with an unknown reaction, which then
/// has no moment.
fn centre(context: &Context<'_>, body: &GroupBody) -> Option<PointId> {
    let pins = body.sought.iter().filter_map(|row| match row.joint {
        Some(BodyJoint::Pin(point)) => Some(point),
        _ => None,
    });
    let members = &context.scene.mechanism.link(body.link).members;
    pins.chain(members.iter().map(|member| member.point)).next()
}

/// A sum over all forces on a link, which is 0.
struct SumOfLink {
    /// The indices of unknowns, with their coefficients.
    shares: Vec<(usize, f64)>,
    known: f64,
    /// The sum of the magnitudes of all terms.
    size: f64,
}

impl SumOfLink {
    fn of(
        context: &Context<'_>,
        (index, body): (usize, &GroupBody),
        unknowns: &[UnknownForce],
        reckoning: BalanceKind,
    ) -> SumOfLink {
        let known = known(context, &body.given, reckoning);
        let mut sum = SumOfLink {
            shares: Vec::new(),
            known: known.value,
            size: known.size,
        };
        for (number, one) in unknowns.iter().enumerate() {
            for (_, unit) in one.acts.iter().filter(|(k, _)| *k == index) {
                let share = reckoning.of(context, unit);
                sum.size += reckoning.max_contribution(context, unit) * one.value.abs();
                // Smaller coefficients are rounding errors of a unit force's arm or direction.
                if context.figures.format_or_zero(share, 1.0) != "0" {
                    sum.shares.push((number, share));
                }
            }
        }
        sum
    }

    /// Returns the residual of the sum.
    fn left(&self, unknowns: &[UnknownForce]) -> f64 {
        let terms = self
            .shares
            .iter()
            .map(|(k, share)| share * unknowns[*k].value);
        self.known + terms.sum::<f64>()
    }

    /// Writes the equation: `0.5·F1x - 0.2·F1y + 3.1 = 0`.
    fn write(&self, context: &Context<'_>, draft: &mut Draft, unknowns: &[UnknownForce]) {
        let f = context.figures;
        let terms = self.shares.iter().filter_map(|&(number, share)| {
            let symbol = Expression::symbol(unknowns[number].symbol.clone());
            Expression::term(share_text(f, share), Some(symbol))
        });
        let rest = Expression::term(f.format_or_zero(self.known, self.size), None);
        if let Some(sum) = Expression::total(terms.chain(rest)) {
            draft.write_zero(sum.numbers());
        }
    }
}

/// Solves sums with a single unknown repeatedly; lists the unknowns that remain.
fn one_by_one(
    context: &Context<'_>,
    draft: &mut Draft,
    unknowns: &[UnknownForce],
    equations: &[SumOfLink],
) {
    let mut found = vec![false; unknowns.len()];
    let mut is_begun = false;
    loop {
        let next = equations.iter().find_map(|equation| {
            let mut open = equation.shares.iter().filter(|(k, _)| !found[*k]);
            match (open.next(), open.next()) {
                (Some(&(k, share)), None) => Some((equation, k, share)),
                _ => None,
            }
        });
        let Some((equation, number, share)) = next else {
            break;
        };
        if !is_begun {
            draft.text(words().solved_one_by_one());
            is_begun = true;
        }
        found[number] = true;
        write_single_unknown(context, draft, unknowns, (equation, number, share));
    }
    let rest = unknowns.iter().zip(&found).filter(|(_, found)| !**found);
    let rest: Vec<String> = rest.map(|(one, _)| one.symbol.to_string()).collect();
    if !rest.is_empty() {
        draft.text(words().others_at_once(&rest.join(", ")));
    }
}

/// Writes the solution of one unknown: `N = -(0.5·3.2 - 7.1)/2 = 2.75 N`.
fn write_single_unknown(
    context: &Context<'_>,
    draft: &mut Draft,
    unknowns: &[UnknownForce],
    (equation, number, share): (&SumOfLink, usize, f64),
) {
    let f = context.figures;
    let one = &unknowns[number];
    let mut terms = Vec::new();
    let mut rest = equation.known;
    for &(k, share) in equation.shares.iter().filter(|(k, _)| *k != number) {
        let value = unknowns[k].value;
        rest += share * value;
        let figure = f.format_or_zero(value, equation.size);
        if figure != "0" {
            let value = Expression::figure(figure, value);
            terms.extend(Expression::term(share_text(f, share), Some(value)));
        }
    }
    let known = f.format_or_zero(equation.known, equation.size);
    terms.extend(Expression::term(known, None));
    let sum = Expression::sum(terms);
    let computed = -rest / share;
    let size = equation.size / share.abs();
    draft.agree(&one.symbol, computed, one.value, size);
    let formula = match share {
        1.0 => -sum.in_brackets(),
        -1.0 => sum,
        _ => -(sum.in_brackets() / Expression::figure(f.number(share), share)),
    };
    let value = Formula::measured(f.format_or_zero(computed, size), one.unit);
    let symbol = one.symbol.clone().into();
    draft.equation([symbol, formula.numbers(), value]);
}

/// Formats a coefficient; that of a whole force is 1 without decimals.
fn share_text(f: Figures, share: f64) -> String {
    match share.abs() {
        1.0 => f.given(share),
        _ => f.number(share),
    }
}

/// Returns all unknowns, each once: the reaction of a pin between two links of the group acts on
/// both.
fn unknown_forces(context: &Context<'_>, bodies: &[GroupBody]) -> Vec<UnknownForce> {
    let mut all: Vec<UnknownForce> = Vec::new();
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
            // If the pin itself has a load, or joins more than two links, each link has its own
            // reaction.
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

/// Adds the components of a reaction on a link, and the opposite ones on another link.
fn components(
    context: &Context<'_>,
    (index, row): (usize, &BodyForce),
    opposite: Option<usize>,
    all: &mut Vec<UnknownForce>,
) {
    let number = all
        .iter()
        .filter(|one| matches!(one.joint, BodyJoint::Pin(_)))
        .count()
        / 2
        + 1;
    let unit = |force: Vec2, couple: f64| BodyForce {
        couple,
        ..BodyForce::load("", force, row.at)
    };
    let Some(joint) = row.joint else { return };
    let mut add = |symbol: Symbol, description: String, value: f64, unit_force: (Vec2, f64)| {
        let (force, couple) = unit_force;
        let mut acts = vec![(index, unit(force, couple))];
        acts.extend(opposite.map(|j| (j, unit(-force, -couple))));
        all.push(UnknownForce {
            symbol,
            description,
            value,
            unit: if couple == 0.0 { "N" } else { "N m" },
            joint,
            acts,
        });
    };
    match joint {
        BodyJoint::Pin(_) => {
            for (axis, unit) in [("x", Vec2::new(1.0, 0.0)), ("y", Vec2::new(0.0, 1.0))] {
                let symbol = Symbol::indexed("F", format!("{number}{axis}"));
                let text = format!("{} {axis}", row.name);
                add(symbol, text, unit.dot(row.force), (unit, 0.0));
            }
        }
        BodyJoint::Guide(slide) => {
            let name = context.scene.slide_name(slide);
            let n = context.state.travel(slide).guide.perp();
            let text = words().across(&row.name);
            let normal = Symbol::separate("N", name);
            add(normal, text, n.dot(row.force), (n, 0.0));
            if context.scene.mechanism.is_pushed(slide) {
                let t = context.state.travel(slide).guide;
                let text = words().along(&row.name);
                add(
                    Symbol::separate("D", name),
                    text,
                    t.dot(row.force),
                    (t, 0.0),
                );
            }
            if let Slider::Link { .. } = context.scene.mechanism.slide(slide).slider {
                let text = words().moment_of(&row.name);
                add(
                    Symbol::separate("M", name),
                    text,
                    row.couple,
                    (Vec2::ZERO, 1.0),
                );
            }
        }
        BodyJoint::Driver => {
            let text = words().driver().into();
            add("M".into(), text, row.couple, (Vec2::ZERO, 1.0));
        }
    }
}
