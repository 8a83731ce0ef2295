//! Solves dyads with a guide, and vectors that close a loop alone: the quadratic of an angle and a
//! position, the arm that slides through a pin, two guides, and a sum.

use super::context::Draft;
use super::equations::{Heading, Multiplier, known};
use super::expression::{Expression, Function};
use super::figures::Figures;
use super::loops::polygon::Term;
use super::loops::solution::{DyadArm, Solution, turn};
use super::positions::pieces;
use crate::Vec2;
use crate::page::UNIT;
use crate::wording::words;

impl Solution<'_> {
    // ---- an angle and a position

    /// Solves |K + r u|^2 = arm^2, with K the sum of the known sides, as a quadratic in r.
    pub(super) fn quadratic(&self, draft: &mut Draft, arm: &[Term], slide: Term) {
        let f = self.figures;
        let arm = self.arm(arm);
        let member = self.member(slide);
        let name = member.side.name.clone();
        let plus = if slide.reversed { "-" } else { "+" };
        let unit_vector = self.context.notation.along(&member.side.theta());
        let sum = format!("K {plus} {name} {unit_vector}");
        draft
            .page
            .text(words().quadratic_in(&arm.length, &sum, &name));
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
        draft.page.equation([
            name.clone(),
            "-p +- sqrt(p^2 - q)".into(),
            format!(
                "{} +- {}",
                f.format_or_zero(-p, size),
                f.format_or_zero(root, size)
            ),
            words().either_or(&one, &format!("{two} {UNIT}{}", f.unit)),
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
        draft.page.text(words().by_the_assembly());
        let found = format!("{} {UNIT}{}", f.format_or_zero(computed, size), f.unit);
        draft.page.equation([name.clone(), found]);
        // The arm closes the loop.
        let sign = if slide.reversed { -1.0 } else { 1.0 };
        let along = -(self.known + member.reading.u * (sign * computed));
        self.write_direction(draft, &arm, (along, &sum), size, loss);
    }

    /// Writes the components of the sum of the known sides.
    pub(super) fn write_known(&self, draft: &mut Draft, size: f64) {
        let f = self.figures;
        let k = self.known;
        for (axis, label, value) in [(Multiplier::X, "Kx", k.x), (Multiplier::Y, "Ky", k.y)] {
            let [symbols, figures] = self.known_text(&axis);
            let found = f.format_or_zero(value, size);
            let mut sides = vec![label.to_owned(), symbols, figures];
            // A single term equals its value.
            sides.retain(|side| *side != found);
            sides.push(format!("{found} {UNIT}{}", f.unit));
            draft.page.equation(sides);
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
        draft
            .page
            .equation([format!("{name}^2 + 2 p {name} + q"), "0".into()]);
        let [kx, ky] = [("Kx", k.x), ("Ky", k.y)]
            .map(|(symbol, v)| Expression::known(symbol, f.format_or_zero(v, size), v));
        let theta = Expression::known(member.side.theta(), f.direction(at), at);
        let [cos, sin] = [Function::Cos, Function::Sin]
            .map(|function| Expression::of(function, [theta.clone()]));
        let along = kx.clone() * cos + ky.clone() * sin;
        let p = along.minus_if(slide.reversed);
        let p = draft.worked("p", &p, |p| {
            format!("{} {UNIT}{}", f.format_or_zero(p, size), f.unit)
        });
        let arm = Expression::known(arm.length.as_str(), arm.figure(f), arm.value);
        let q = kx.squared() + ky.squared() - arm.squared();
        let q = draft.worked("q", &q, |q| {
            format!("{} {UNIT}{}^2", f.format_or_zero(q, size * size), f.unit)
        });
        [p, q]
    }

    /// Writes `theta = atan2(y, x) = ...` for an arm opposite to another vector, which `what`
    /// describes.
    fn write_direction(
        &self,
        draft: &mut Draft,
        arm: &DyadArm<'_>,
        (along, what): (Vec2, &str),
        size: f64,
        loss: f64,
    ) {
        let f = self.figures;
        let [y, x] = [along.y, along.x].map(|v| Expression::figure(f.format_or_zero(v, size), v));
        let direction = Expression::of(Function::Atan2, [y, x]);
        let text = Expression::known(
            words().angle_of_minus(what),
            direction.numbers(),
            direction.value(),
        );
        let theta = match arm.ahead {
            0.0 => text,
            ahead => text - Expression::figure(f.angle(ahead), ahead),
        };
        let computed = draft.worked(&arm.theta, &theta, |computed| turn(f, computed));
        draft.agree_angle(&arm.theta, computed, arm.solved, loss);
        if let Some(side) = arm.side {
            self.write_link_angle(draft, side, computed, loss);
        }
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
        let known =
            |symbol, value: f64| Expression::known(symbol, f.format_or_zero(value, size), value);
        let m = || Expression::known(diagonal, f.number(size), size);
        let w = match has_rest {
            true => (m().squared() - known("e", e).squared())
                .sqrt()
                .minus_if(is_back),
            false => m().minus_if(is_back),
        };
        let w = if has_rest {
            let name = &member.side.name;
            let [t, e] = [t0, e].map(|v| f.format_or_zero(v, size));
            draft.page.text(words().others_turn_with(name, &t, &e));
            draft.worked("w", &w, |w| f.format_or_zero(w, size))
        } else {
            w.value()
        };
        let travel = match has_rest {
            true => (known("w", w) - known("t", t0)).minus_if(slide.reversed),
            false => m().minus_if(is_back != slide.reversed),
        };
        let loss = 1.0 + size / w.abs().max(1e-8 * size);
        let computed = draft.found(&name, &travel, |r| {
            format!("{} {UNIT}{}", f.format_or_zero(r, size), f.unit)
        });
        draft.agree(&name, computed, member.reading.r, size * loss);
        let theta = member.side.theta();
        let angle = Expression::of(Function::Atan2, [my, mx]);
        let angle = match has_rest || is_back {
            true => angle - Expression::of(Function::Atan2, [known("e", e), known("w", w)]),
            false => angle,
        };
        let value = draft.write_numbers(&theta, &angle, |value| turn(f, value));
        draft.agree_angle(&theta, value, member.reading.theta, loss);
        self.write_link_angle(draft, member.side, value, loss);
    }

    /// Returns the constant components of an arm's other sides, along the vector of its guide and
    /// to the left of it.
    pub(super) fn side_components(&self, arm: &[Term], slide: Term, size: f64) -> [f64; 2] {
        let u = self.member(slide).reading.u;
        let others = arm.iter().filter(|t| **t != slide).map(|&t| self.member(t));
        let rest = others.fold(Vec2::ZERO, |sum, o| {
            let r = o.reading.vector();
            sum + if o.reversed { -r } else { r }
        });
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
            let pieces = pieces(&self.members, &axis, f);
            let sum = known(&pieces);
            let factor_of = other.reading.u.cross(own.reading.u);
            let factor_of = if own.reversed { -factor_of } else { factor_of };
            let sum = Expression::figure(f.format_or_zero(sum, size), sum);
            let divisor = Expression::figure(f.format_or_zero(factor_of, 1.0), factor_of);
            let quotient = -(sum / divisor);
            let computed = draft.write_numbers(&own.side.name, &quotient, |computed| {
                format!("{} {UNIT}{}", f.format_or_zero(computed, size), f.unit)
            });
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
        draft.agree(&name, size, member.reading.r, self.longest());
        let theta = member.side.theta();
        let angle = Expression::of(Function::Atan2, [my, mx]);
        let computed = draft.found(&theta, &angle, |computed| turn(f, computed));
        draft.agree_angle(
            &theta,
            computed,
            member.reading.theta,
            self.longest() / size,
        );
    }
}

/// Explains why a quadratic has no root, or that it has one.
fn no_root(draft: &mut Draft, figures: Figures, under: f64, arm: &DyadArm<'_>) {
    draft
        .page
        .equation(["p^2 - q".to_owned(), figures.number(under)]);
    let text = if under < 0.0 {
        words().does_not_reach_guide(&arm.length)
    } else {
        words().root_would_close().into()
    };
    draft.page.text(text);
}
