//! Solves dyads and the crank: one or two equations without their outer reactions, solved by
//! Cramer's rule.

use super::super::context::{Context, Draft};
use super::super::expression::Expression;
use super::super::figures::Figures;
use super::super::free_bodies::forces::point_name;
use super::super::free_bodies::free_body::{BodyForce, BodyJoint};
use super::body::{BalanceKind, GroupBody, KnownSum, write_known};
use crate::page::{Formula, Symbol};
use crate::wording::words;
use crate::{Body, PointId, Slider, Vec2};

/// Writes the solution; returns `false` if the group has none of these forms.
pub(super) fn write(context: &Context<'_>, draft: &mut Draft, bodies: &[GroupBody]) -> bool {
    match bodies {
        [body] => one_link(context, draft, body),
        [first, second] => two_links(context, draft, [first, second]),
        _ => false,
    }
}

/// An equation of a link without its outer reaction.
struct OuterFree {
    reckoning: BalanceKind,
    /// The name of the sum of known terms: `M1`, or `S1` along a guide.
    sum: Symbol,
    /// The header of the column of its terms.
    about: String,
    /// The description: moments about B, forces along the guide of r6.
    description: String,
    /// The description of its arm or unit vector.
    vector: String,
}

/// Returns the equation without an outer reaction; `None` if no single equation eliminates it.
fn free_of(context: &Context<'_>, outer: &BodyForce, number: usize, at: &str) -> Option<OuterFree> {
    match outer.joint? {
        BodyJoint::Pin(point) => {
            let name = point_name(context, point);
            Some(OuterFree {
                reckoning: BalanceKind::About(context.state.position(point)),
                sum: Symbol::indexed("M", number.to_string()),
                about: format!("{} [N m]", words().moment_about(name)),
                description: words().moments_about(name),
                vector: words().arm_from_to(name, at),
            })
        }
        BodyJoint::Guide(slide) => {
            let given = context.scene.mechanism.slide(slide);
            let is_rotary = matches!(given.slider, Slider::Pin(_));
            if is_rotary || context.scene.mechanism.is_pushed(slide) {
                return None;
            }
            let name = context.scene.slide_name(slide);
            let guide = context.state.travel(slide).guide;
            let at = context.figures.direction(crate::angle::degrees(guide));
            Some(OuterFree {
                reckoning: BalanceKind::Along(guide),
                sum: Symbol::indexed("S", number.to_string()),
                about: format!("{} [N]", words().force_along()),
                description: words().forces_along_guide(name, &at),
                vector: words().unit_vector_along(&at),
            })
        }
        BodyJoint::Driver => None,
    }
}

/// Returns the coefficients of a unit force's components in an equation, with sign, and their
/// values.
fn shares(
    f: Figures,
    reckoning: BalanceKind,
    at: Vec2,
    letter: &str,
    metres: f64,
) -> ([Expression; 2], Vec2) {
    let named = |axis: &str, value: f64, size: f64| {
        Expression::known(
            Symbol::indexed(letter, axis),
            component(f, value, size),
            value,
        )
    };
    match reckoning {
        BalanceKind::About(position) => {
            let e = (at - position) * metres;
            let size = e.norm();
            // e x F = ex Fy - ey Fx.
            ([-named("y", e.y, size), named("x", e.x, size)], e)
        }
        BalanceKind::Along(t) => ([named("x", t.x, 1.0), named("y", t.y, 1.0)], t),
    }
}

/// Formats a component in a formula; that of a unit vector along an axis is 1.
fn component(f: Figures, value: f64, size: f64) -> String {
    match value.abs() == 1.0 && size == 1.0 {
        true => f.given(value),
        false => f.format_or_zero(value, size),
    }
}

/// Writes the components of a vector: `e = B -> C: ex = 0.26, ey = 0.15 m`.
fn write_vector(context: &Context<'_>, draft: &mut Draft, letter: &str, v: Vec2, unit: &str) {
    for (axis, value) in [("x", v.x), ("y", v.y)] {
        let figure = component(context.figures, value, v.norm());
        let symbol = Symbol::indexed(letter, axis);
        draft.equation([symbol.into(), Formula::measured(figure, unit)]);
    }
}

/// Solves two links joined by a pin, each with an outer reaction that one equation eliminates.
/// Returns `false` for links of another form.
fn two_links(context: &Context<'_>, draft: &mut Draft, bodies: [&GroupBody; 2]) -> bool {
    let Some(InnerPin {
        point: inner,
        outer,
        load,
    }) = joined(context, bodies)
    else {
        return false;
    };
    let point = point_name(context, inner);
    let equations = [0, 1].map(|k| free_of(context, outer[k], k + 1, point));
    let [Some(first), Some(second)] = &equations else {
        return false;
    };
    let f = context.figures;
    let metres = context.scene.mechanism.metres();
    let at = context.state.position(inner);
    let link = context.scene.link_name(bodies[0].link);
    let lines = [first, second].map(|equation| equation.description.as_str());
    draft.text(words().dyad_by_two_sums(
        point,
        link,
        lines,
        context.scene.link_name(bodies[1].link),
    ));
    let mut sums = [KnownSum {
        value: 0.0,
        size: 0.0,
    }; 2];
    let mut rows = Vec::new();
    let letters = match (first.reckoning, second.reckoning) {
        (BalanceKind::Along(_), BalanceKind::Along(_)) => ["t", "s"],
        (BalanceKind::Along(_), BalanceKind::About(_)) => ["t", "e"],
        (BalanceKind::About(_), BalanceKind::Along(_)) => ["e", "t"],
        (BalanceKind::About(_), BalanceKind::About(_)) => ["e", "g"],
    };
    for (k, equation) in [first, second].into_iter().enumerate() {
        let name = (&equation.sum, equation.reckoning);
        let pin_load = load.iter().filter(|_| k == 1);
        let given: Vec<&BodyForce> = bodies[k].given.iter().chain(pin_load).collect();
        let link = bodies[k].link;
        draft.text(words().vector_is(letters[k], &equation.vector));
        sums[k] = write_known(context, draft, (link, &given), name, &equation.about);
        let (share, v) = shares(f, equation.reckoning, at, letters[k], metres);
        let unit = match equation.reckoning {
            BalanceKind::About(_) => "m",
            BalanceKind::Along(_) => "",
        };
        write_vector(context, draft, letters[k], v, unit);
        rows.push((share, v.norm()));
    }
    // Loads on the pin belong to the second link, on which -F acts.
    let right = [(first, true), (second, false)].map(|(equation, negative)| {
        let sum = sums[usize::from(!negative)];
        f.rounded(equation.sum.clone(), sum.value, sum.size)
            .minus_if(negative)
    });
    draft.text(words().so_that());
    for ((share, _), right) in rows.iter().zip(&right) {
        let unknowns = ["x", "y"].map(|axis| Expression::symbol(Symbol::indexed("F", axis)));
        let terms = || share.iter().zip(unknowns.clone());
        let symbols = terms().map(|(coefficient, unknown)| product(coefficient, &unknown));
        let numbers = terms().filter_map(|(coefficient, unknown)| {
            Expression::term(coefficient.numbers().to_string(), Some(unknown))
        });
        for (left, right) in [
            (Expression::sum(symbols).symbols(), right.symbols()),
            (Expression::sum(numbers).numbers(), right.numbers()),
        ] {
            draft.equation([left, right]);
        }
    }
    let reckonings = [first.reckoning, second.reckoning];
    let sums = TwoSums {
        shares: [&rows[0], &rows[1]],
        right: &right,
        sums,
        unit: unit_of_determinant(reckonings),
    };
    cramer(context, draft, &sums, (bodies[0], inner));
    outer_reaction(context, draft, bodies[0], outer[0]);
    outer_reaction(context, draft, bodies[1], outer[1]);
    true
}

/// The pin that joins the two links of a dyad.
struct InnerPin<'a> {
    point: PointId,
    /// The only other reaction of each link.
    outer: [&'a BodyForce; 2],
    /// The load on the pin itself.
    load: Option<BodyForce>,
}

/// Returns the pin that joins two links, if each has one further reaction.
fn joined<'a>(context: &Context<'_>, bodies: [&'a GroupBody; 2]) -> Option<InnerPin<'a>> {
    let mechanism = &context.scene.mechanism;
    let links = bodies.map(|body| body.link);
    let is_inner = |row: &&BodyForce| match row.joint {
        Some(BodyJoint::Pin(point)) => {
            let given = mechanism.point(point);
            let is_guided = mechanism
                .slides()
                .iter()
                .any(|s| s.slider == Slider::Pin(point));
            given.ground.is_none()
                && !is_guided
                && links.iter().all(|link| given.links.contains(link))
        }
        _ => false,
    };
    let [first, second] = bodies.map(|body| match &body.sought[..] {
        [a, b] if is_inner(&a) && !is_inner(&b) => Some((a, b)),
        [a, b] if is_inner(&b) && !is_inner(&a) => Some((b, a)),
        _ => None,
    });
    let ((inner, one), (other, two)) = (first?, second?);
    let (Some(BodyJoint::Pin(point)), true) = (inner.joint, inner.joint == other.joint) else {
        return None;
    };
    // A pin has no mass: loads on it, and reactions of later links, are assigned to the second
    // link.
    let is_alone = mechanism.partner(bodies[0].link, point).is_some();
    let load = (!is_alone).then(|| {
        let name = words().acts_at(words().column_load(), point_name(context, point));
        BodyForce::load(name, inner.force + other.force, inner.at)
    });
    Some(InnerPin {
        point,
        outer: [one, two],
        load,
    })
}

/// The symbol of the determinant of two equations.
const DETERMINANT: &str = "Δ";

/// Returns the unit of the determinant: an arm has a length, a unit vector has none.
fn unit_of_determinant(of: [BalanceKind; 2]) -> &'static str {
    let arms = of.iter().filter(|of| matches!(of, BalanceKind::About(_)));
    ["", "m", "m^2"][arms.count()]
}

/// Two sums with the force at the inner pin as the only unknown.
struct TwoSums<'a> {
    /// The coefficients of its components, and their maximum magnitude.
    shares: [&'a ([Expression; 2], f64); 2],
    right: &'a [Expression; 2],
    sums: [KnownSum; 2],
    /// The unit of the determinant.
    unit: &'static str,
}

/// Solves for the force at the inner pin.
fn cramer(
    context: &Context<'_>,
    draft: &mut Draft,
    equations: &TwoSums<'_>,
    (body, inner): (&GroupBody, PointId),
) {
    let &TwoSums {
        shares: [first, second],
        right,
        sums,
        unit,
    } = equations;
    let f = context.figures;
    let is_it = |row: &&BodyForce| row.joint == Some(BodyJoint::Pin(inner));
    let Some(solved) = body.sought.iter().find(is_it).map(|row| row.force) else {
        return;
    };
    let ([a, b], largest) = (first.0.clone(), first.1);
    let ([c, d], other) = (second.0.clone(), second.1);
    let [p, q] = right.clone();
    let determinant = product(&a, &d) - product(&c, &b);
    let value = draft.worked(DETERMINANT, &determinant, |v| {
        Formula::measured(f.number(v), unit)
    });
    if value == 0.0 {
        return;
    }
    let below = || f.computed(DETERMINANT, value);
    let x = (product(&p, &d) - product(&q, &b)) / below();
    let y = (product(&a, &q) - product(&c, &p)) / below();
    // The relative error grows by the cancellation in the determinant.
    let lost = largest * other / value.abs();
    let sizes = (sums[0].size * other + sums[1].size * largest) / value.abs() * (1.0 + lost);
    for (axis, formula, solved) in [("x", x, solved.x), ("y", y, solved.y)] {
        let name = Symbol::indexed("F", axis);
        let newtons = |v| Formula::measured(f.format_or_zero(v, sizes), "N");
        let computed = draft.worked(name.clone(), &formula, newtons);
        let link = context.scene.link_name(body.link);
        let symbol = words().part_at(&name.to_string(), link, point_name(context, inner));
        draft.agree(&symbol, computed, solved, sizes);
    }
}

/// Returns the product of two coefficients, with the sign in front.
fn product(a: &Expression, b: &Expression) -> Expression {
    let plain = |of: &Expression| match of {
        Expression::Minus(of) => (true, (**of).clone()),
        of => (false, of.clone()),
    };
    let ((one, a), (two, b)) = (plain(a), plain(b));
    (a * b).minus_if(one != two)
}

/// Writes the reaction of an outer joint or guide, from the sums of forces.
fn outer_reaction(context: &Context<'_>, draft: &mut Draft, body: &GroupBody, outer: &BodyForce) {
    let all = || {
        let unknowns = body.sought.iter().filter(|row| row.joint != outer.joint);
        body.given.iter().chain(unknowns)
    };
    match outer.joint {
        Some(BodyJoint::Pin(point)) => {
            let (link, point) = (
                context.scene.link_name(body.link),
                point_name(context, point),
            );
            for (axis, unit) in [("x", Vec2::new(1.0, 0.0)), ("y", Vec2::new(0.0, 1.0))] {
                let along = BalanceKind::Along(unit);
                let name = format!("{link}.{point}.f{axis}");
                balance(context, draft, all(), (along, &name), unit.dot(outer.force));
            }
        }
        Some(BodyJoint::Guide(slide)) => {
            let n = context.state.travel(slide).guide.perp();
            let given = context.scene.mechanism.slide(slide);
            // Values of a guide refer to its slider.
            let [normal, moment] = match given.on == Body::Link(body.link) {
                true => [words().across(&outer.name), words().moment_of(&outer.name)],
                false => ["normal", "moment"]
                    .map(|of| format!("{}.{of}", context.scene.slide_name(slide))),
            };
            balance(
                context,
                draft,
                all(),
                (BalanceKind::Along(n), &normal),
                n.dot(outer.force),
            );
            if let (Some(at), Slider::Link { .. }) = (outer.at, given.slider) {
                let about = BalanceKind::About(at);
                balance(context, draft, all(), (about, &moment), outer.couple);
            }
        }
        Some(BodyJoint::Driver) | None => {}
    }
}

/// Writes the value that makes a sum zero: `name = -(12.5 - 3.2) = -9.3 N`.
fn balance<'a>(
    context: &Context<'_>,
    draft: &mut Draft,
    rows: impl Iterator<Item = &'a BodyForce>,
    (reckoning, name): (BalanceKind, &str),
    solved: f64,
) {
    let f = context.figures;
    let both = |row| {
        (
            reckoning.of(context, row),
            reckoning.max_contribution(context, row),
        )
    };
    let (terms, maximum): (Vec<f64>, Vec<f64>) = rows.map(both).unzip();
    // Large forces across the guide contribute rounding errors even if their component along it is
    // small.
    let size = maximum.iter().sum::<f64>();
    let sum = f.sum(terms.iter().copied(), size);
    let computed = -terms.iter().sum::<f64>();
    draft.agree(name, computed, solved, size);
    let mut sides = vec![Formula::words(name)];
    if let Expression::Sum(_) = sum {
        sides.push((-sum).numbers());
    }
    sides.push(Formula::measured(
        f.format_or_zero(computed, size),
        reckoning.unit(),
    ));
    draft.equation(sides);
}

/// Returns the name of the pin in the slot, if its force is the unknown besides the outer reaction.
fn single_place<'a>(context: &'a Context<'_>, single: &BodyForce) -> &'a str {
    match single.joint {
        Some(BodyJoint::Guide(slide)) => {
            let slider = context.scene.mechanism.slide(slide).slider;
            point_name(context, slider.point())
        }
        _ => "",
    }
}

/// Solves a link with an outer reaction and one further unknown: the force of a slot, or the
/// driver's torque. Returns `false` for a link of another form.
fn one_link(context: &Context<'_>, draft: &mut Draft, body: &GroupBody) -> bool {
    let f = context.figures;
    let [a, b] = &body.sought[..] else {
        return false;
    };
    let is_single = |row: &BodyForce| match row.joint {
        Some(BodyJoint::Driver) => true,
        Some(BodyJoint::Guide(slide)) => {
            let mechanism = &context.scene.mechanism;
            let is_driven = mechanism.is_pushed(slide);
            matches!(mechanism.slide(slide).slider, Slider::Pin(_)) && !is_driven
        }
        _ => false,
    };
    let (single, outer) = match (is_single(a), is_single(b)) {
        (true, false) => (a, b),
        (false, true) => (b, a),
        _ => return false,
    };
    let place = single_place(context, single);
    let Some(equation) = free_of(context, outer, 1, place) else {
        return false;
    };
    let reaction = match outer.joint {
        Some(BodyJoint::Guide(slide)) => words().reaction_of_guide(context.scene.slide_name(slide)),
        Some(BodyJoint::Pin(point)) => words().reaction_at(point_name(context, point)),
        Some(BodyJoint::Driver) | None => return false,
    };
    draft.text(words().one_sum(&equation.description, &reaction));
    let name = (&equation.sum, equation.reckoning);
    let given: Vec<&BodyForce> = body.given.iter().collect();
    let sum = write_known(context, draft, (body.link, &given), name, &equation.about);
    let known = f.rounded(equation.sum.clone(), sum.value, sum.size);
    match single.joint {
        Some(BodyJoint::Guide(slide)) => {
            let n = context.state.travel(slide).guide.perp();
            // The carrier of the guide gets the opposite force.
            let given = context.scene.mechanism.slide(slide);
            let sign = if given.on == Body::Link(body.link) {
                -1.0
            } else {
                1.0
            };
            let n = n * sign;
            let Some(at) = single.at else {
                return false;
            };
            let across = context.figures.direction(crate::angle::degrees(n));
            draft.text(words().vector_is("n", &words().unit_vector_along(&across)));
            write_vector(context, draft, "n", n, "");
            let unit = |axis: &str, v: f64| f.rounded(Symbol::indexed("n", axis), v, 1.0);
            let metres = context.scene.mechanism.metres();
            let letter = match equation.reckoning {
                BalanceKind::About(_) => "e",
                BalanceKind::Along(_) => "t",
            };
            let (share, v) = shares(f, equation.reckoning, at, letter, metres);
            let unit_of_v = if letter == "e" { "m" } else { "" };
            draft.text(words().vector_is(letter, &equation.vector));
            write_vector(context, draft, letter, v, unit_of_v);
            let [x, y] = share;
            let below = product(&y, &unit("y", n.y)) + product(&x, &unit("x", n.x));
            let value = draft.worked(DETERMINANT, &below, |v| {
                Formula::measured(f.number(v), unit_of_v)
            });
            if value == 0.0 {
                return true;
            }
            let formula = -known / f.computed(DETERMINANT, value);
            let size = sum.size / value.abs() * (1.0 + v.norm() / value.abs());
            let newtons = |v| Formula::measured(f.format_or_zero(v, size), "N");
            let computed = draft.worked("N", &formula, newtons);
            let solved = n.dot(single.force);
            draft.agree(words().across(&single.name), computed, solved, size);
        }
        _ => {
            let formula = -known;
            let computed = draft.found("M", &formula, |v| {
                Formula::measured(f.format_or_zero(v, sum.size), "N m")
            });
            draft.agree("driver.torque", computed, single.couple, sum.size);
        }
    }
    outer_reaction(context, draft, body, outer);
    true
}
