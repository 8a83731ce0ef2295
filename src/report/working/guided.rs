//! Solves dyads with a guide, and vectors that close a loop alone: the quadratic of an angle and a
//! position, the arm that slides through a pin, two guides, and a sum.

use super::context::Draft;
use super::equations::{Heading, Multiplier, known, longest, pieces};
use super::expression::Expression;
use super::figures::Figures;
use super::loops::polygon::Term;
use super::loops::solution::{DyadArm, Solution, turn};
use crate::Vec2;
use crate::page::{Formula, Symbol};
use crate::solver::Order;
use crate::wording::words;

impl Solution<'_> {
    // ---- an angle and a position

    /// Solves |K + r u|^2 = arm^2, with K the sum of the known sides, as a quadratic in r.
    pub(super) fn quadratic(&self, draft: &mut Draft, arm: &[Term], slide: Term) {
        let f = self.figures;
        let arm = self.arm(arm);
        let member = self.member(slide);
        let name = member.side.name.clone();
        let unit_vector = self.context.notation.along(member.side.theta());
        let along = Expression::symbol(name.as_str()) * Expression::symbol(unit_vector);
        let sum = Expression::symbol("K") + along.minus_if(slide.reversed);
        let sum = sum.symbols();
        draft.text(words().quadratic_in(&arm.length, &sum, &name));
        let size = self.known.norm().max(arm.value);
        self.write_known(draft, size);
        let [p, q] = self.write_coefficients(draft, &arm, slide, size);
        let under = p * p - q;
        if !self.context.has_positions() {
            return no_root(draft, f, under, &arm);
        }
        let root = under.max(0.0).sqrt();
        let roots = [-p + root, -p - root];
        let [one, two] = roots.map(|r| f.format_or_zero(r, size));
        let either = [Formula::number(&one), Formula::measured(two, f.unit)];
        let symbol = |name: &str| Expression::symbol(name);
        let symbols = (symbol("p").squared() - symbol("q")).sqrt().symbols();
        let about = |middle: Formula, off: Formula| middle.blank().with_sign('±').blank().then(off);
        let number = |v: f64| Formula::number(&f.format_or_zero(v, size));
        draft.equation([
            name.as_str().into(),
            about((-symbol("p")).symbols(), symbols),
            about(number(-p), number(root)),
            Formula::message(|[one, other]| words().either_or(one, other), either),
        ]);
        let away = roots.map(|r| (r - member.reading.r).abs());
        let computed = if away[0] <= away[1] {
            roots[0]
        } else {
            roots[1]
        };
        // Near a dead point, the root of a difference loses half its digits.
        let loss = 1.0 + size / root.max(1e-8 * size);
        draft.agree(&name, computed, member.reading.r, size * loss);
        draft.text(words().by_the_assembly());
        let found = f.length_or_zero(computed, size);
        draft.equation([name.as_str().into(), found]);
        // The arm closes the loop.
        let sign = if slide.reversed { -1.0 } else { 1.0 };
        let along = -(self.known + member.reading.u * (sign * computed));
        self.write_direction(draft, &arm, (along, &sum), size, loss);
    }

    /// Writes the components of the sum of the known sides.
    pub(super) fn write_known(&self, draft: &mut Draft, size: f64) {
        let f = self.figures;
        let k = self.known;
        for (axis, label, value) in [(Multiplier::X, "x", k.x), (Multiplier::Y, "y", k.y)] {
            let [symbols, figures] = self.known_text(&axis);
            let found = Formula::number(&f.format_or_zero(value, size));
            let mut sides = vec![Symbol::indexed("K", label).into(), symbols, figures];
            // A single term equals its value.
            sides.retain(|side| *side != found);
            sides.push(f.length_or_zero(value, size));
            draft.equation(sides);
        }
    }

    /// Writes p and q of r^2 + 2 p r + q = 0.
    fn write_coefficients(
        &self,
        draft: &mut Draft,
        arm: &DyadArm<'_>,
        slide: Term,
        size: f64,
    ) -> [f64; 2] {
        let f = self.figures;
        let (member, k) = (self.member(slide), self.known);
        let (name, at) = (&member.side.name, member.reading.theta);
        let r = || Expression::symbol(name.as_str());
        let product = Expression::Number(2.0) * Expression::symbol("p") * r();
        let square = r().squared() + product + Expression::symbol("q");
        draft.write_zero(square.symbols());
        let [kx, ky] = [("x", k.x), ("y", k.y)]
            .map(|(axis, v)| f.rounded(Symbol::indexed("K", axis), v, size));
        let theta = f.directed(member.side.theta(), at);
        let [cos, sin] = theta.cos_and_sin();
        let along = kx.clone() * cos + ky.clone() * sin;
        let p = along.minus_if(slide.reversed);
        let p = draft.worked("p", &p, |p| f.length_or_zero(p, size));
        let arm = arm.expression(f);
        let q = kx.squared() + ky.squared() - arm.squared();
        let q = draft.worked("q", &q, |q| f.area_or_zero(q, size * size));
        [p, q]
    }

    /// Writes `theta = atan2(y, x) = ...` for an arm opposite to another vector, which `what`
    /// describes.
    fn write_direction(
        &self,
        draft: &mut Draft,
        arm: &DyadArm<'_>,
        (along, what): (Vec2, &Formula),
        size: f64,
        loss: f64,
    ) {
        let f = self.figures;
        let [y, x] = [along.y, along.x].map(|v| Expression::figure(f.format_or_zero(v, size), v));
        let direction = Expression::atan2(y, x);
        let text = Expression::Known {
            symbol: Formula::message(|[what]| words().angle_of_minus(what), [what.clone()]),
            figure: direction.numbers(),
            value: direction.value(),
        };
        self.write_angle(draft, arm, text, loss);
    }

    /// Solves for the sides that rotate with the guide, including the one along it: their sum must
    /// be minus that of the known sides.
    pub(super) fn swing(&self, draft: &mut Draft, arm: &[Term], slide: Term) {
        let f = self.figures;
        let member = self.member(slide);
        let name = member.side.name.clone();
        let [mx, my] = self.write_m(draft);
        let diagonal = self.diagonal();
        let size = self.write_length(draft, diagonal, [&mx, &my]);
        let sign = if slide.reversed { -1.0 } else { 1.0 };
        let [t0, e] = self.side_components(arm, slide, size.max(member.reading.r.abs()));
        let has_rest = [t0, e] != [0.0, 0.0];
        let is_back = t0 + sign * member.reading.r < 0.0;
        let known = |symbol, value: f64| f.rounded(symbol, value, size);
        let m = || f.computed(diagonal, size);
        let w = match has_rest {
            true => (m().squared() - known("e", e).squared())
                .sqrt()
                .minus_if(is_back),
            false => m().minus_if(is_back),
        };
        let w = if has_rest {
            let name = &member.side.name;
            let [t, e] = [t0, e].map(|v| f.format_or_zero(v, size));
            draft.text(words().others_turn_with(name, &t, &e));
            draft.worked("w", &w, |w| Formula::number(&f.format_or_zero(w, size)))
        } else {
            w.value()
        };
        let travel = match has_rest {
            true => (known("w", w) - known("t", t0)).minus_if(slide.reversed),
            false => m().minus_if(is_back != slide.reversed),
        };
        let loss = 1.0 + size / w.abs().max(1e-8 * size);
        let computed = draft.found(name.as_str(), &travel, |r| f.length_or_zero(r, size));
        draft.agree(&name, computed, member.reading.r, size * loss);
        let theta = member.side.theta();
        let angle = Expression::atan2(my, mx);
        let angle = match has_rest || is_back {
            true => angle - Expression::atan2(known("e", e), known("w", w)),
            false => angle,
        };
        let value = draft.write_numbers(theta.clone(), &angle, |value| turn(f, value));
        draft.agree_angle(&theta, value, member.reading.theta, loss);
        self.write_link_angle(draft, member.side, value, loss);
    }

    /// Returns the constant components of an arm's other sides, along the vector of its guide and
    /// to the left of it.
    pub(super) fn side_components(&self, arm: &[Term], slide: Term, size: f64) -> [f64; 2] {
        let u = self.member(slide).reading.u;
        let others = arm.iter().filter(|t| **t != slide).map(|&t| self.member(t));
        let rest = others.fold(Vec2::ZERO, |sum, other| sum + other.vector());
        match rest.norm() > 1e-12 * size {
            true => [u.dot(rest), u.cross(rest)],
            false => [0.0; 2],
        }
    }

    // ---- two positions

    /// Solves two positions, each eliminated by the normal of its guide.
    pub(super) fn guides(&self, draft: &mut Draft, a: Term, b: Term) {
        let f = self.figures;
        let size = self.known.norm().max(self.member(a).reading.r.abs());
        for (own, other) in [(a, b), (b, a)] {
            let (own, other) = (self.member(own), self.member(other));
            let axis = Multiplier::Across(Heading::of(&other));
            let pieces = pieces(&self.members, Order::Position, &axis, f);
            let sum = known(&pieces);
            let factor_of = other.reading.u.cross(own.reading.u);
            let factor_of = if own.reversed { -factor_of } else { factor_of };
            let sum = Expression::figure(f.format_or_zero(sum, size), sum);
            let divisor = Expression::figure(f.format_or_zero(factor_of, 1.0), factor_of);
            let quotient = -(sum / divisor);
            let length = |computed| f.length_or_zero(computed, size);
            let computed = draft.write_numbers(own.side.name.as_str(), &quotient, length);
            let loss = size / factor_of.abs();
            draft.agree(&own.side.name, computed, own.reading.r, loss);
        }
    }

    /// Solves a vector that closes its loop alone.
    pub(super) fn sum(&self, draft: &mut Draft, term: Term) {
        let f = self.figures;
        let member = self.member(term);
        let [mx, my] = self.write_m(draft);
        let name = member.side.name.clone();
        let size = self.write_length(draft, &name, [&mx, &my]);
        draft.agree(&name, size, member.reading.r, longest(&self.members));
        let theta = member.side.theta();
        let angle = Expression::atan2(my, mx);
        let computed = draft.found(theta.clone(), &angle, |computed| turn(f, computed));
        draft.agree_angle(
            &theta,
            computed,
            member.reading.theta,
            longest(&self.members) / size,
        );
    }
}

/// Explains why a quadratic has no root, or that it has one.
fn no_root(draft: &mut Draft, figures: Figures, under: f64, arm: &DyadArm<'_>) {
    let difference = Expression::symbol("p").squared() - Expression::symbol("q");
    draft.equation([
        difference.symbols(),
        Formula::number(&figures.number(under)),
    ]);
    let text = if under < 0.0 {
        words().does_not_reach_guide(&arm.length)
    } else {
        words().root_would_close().into()
    };
    draft.text(text);
}
