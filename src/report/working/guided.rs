//! Dyads with a guide, and vectors that close a loop alone: the quadratic of an angle and a position, the
//! arm that slides through a pin, two guides, a sum.

use super::equations::{Axis, Heading, known};
use super::figures::{Figures, factor};
use super::page::Page;
use super::place::pieces;
use super::polygon::Term;
use super::solution::{Arm, Solution, turn};
use crate::Vec2;

impl Solution<'_> {
    // ---- an angle and a position

    /// |K + r u|^2 = arm^2, K the sum of the known sides: a quadratic in r.
    pub(super) fn quadratic(&self, page: &mut Page, arm: &[Term], slide: Term) {
        let f = self.figures;
        let arm = self.arm(arm);
        let member = self.member(slide);
        let name = member.side.name.clone();
        let plus = if slide.reversed { "-" } else { "+" };
        page.document.text(format!(
            "With K the sum of the known sides, {} = |K {plus} {name} u|, u at {}: a quadratic in {name}.",
            arm.length,
            member.side.theta()
        ));
        let size = self.known.norm().max(arm.value);
        self.write_known(page, size);
        let [p, q] = self.write_coefficients(page, &arm, slide, size);
        let under = p * p - q;
        if !self.context.has_positions() {
            return no_root(page, f, under, &arm);
        }
        let root = under.max(0.0).sqrt();
        let roots = [-p + root, -p - root];
        let [one, two] = roots.map(|r| f.beside(r, size));
        page.document.equation([
            name.clone(),
            "-p +- sqrt(p^2 - q)".into(),
            format!("{} +- {}", f.beside(-p, size), f.beside(root, size)),
            format!("{one} or {two} {}", f.unit),
        ]);
        let away = roots.map(|r| (r - member.reading.r).abs());
        let worked = if away[0] <= away[1] {
            roots[0]
        } else {
            roots[1]
        };
        // Near a dead point the root of a difference loses half its digits.
        let loss = 1.0 + size / root.max(1e-8 * size);
        page.agree(&name, worked, member.reading.r, size * loss);
        page.document.text("By the assembly:");
        let found = format!("{} {}", f.beside(worked, size), f.unit);
        page.document.equation([name.clone(), found]);
        // What closes the loop is the arm.
        let sign = if slide.reversed { -1.0 } else { 1.0 };
        let along = -(self.known + member.reading.u * (sign * worked));
        let what = format!("K {plus} {name} u");
        self.write_direction(page, &arm, (along, &what), size, loss);
    }

    /// The components of the sum of the known sides.
    fn write_known(&self, page: &mut Page, size: f64) {
        let f = self.figures;
        let k = self.known;
        for (axis, label, value) in [(Axis::X, "Kx", k.x), (Axis::Y, "Ky", k.y)] {
            let [symbols, figures] = self.known_text(&axis);
            let found = f.beside(value, size);
            let mut sides = vec![label.to_owned(), symbols, figures];
            // A single term is a figure already.
            sides.retain(|side| *side != found);
            sides.push(format!("{found} {}", f.unit));
            page.document.equation(sides);
        }
    }

    /// p and q of r^2 + 2 p r + q = 0.
    fn write_coefficients(
        &self,
        page: &mut Page,
        arm: &Arm<'_>,
        slide: Term,
        size: f64,
    ) -> [f64; 2] {
        let f = self.figures;
        let (member, k) = (self.member(slide), self.known);
        let (name, theta) = (&member.side.name, member.side.theta());
        let along = k.dot(member.reading.u);
        let p = if slide.reversed { -along } else { along };
        let q = k.norm2() - arm.value * arm.value;
        page.document
            .equation([format!("{name}^2 + 2 p {name} + q"), "0".into()]);
        let [x, y] = [k.x, k.y].map(|v| factor(&f.beside(v, size)));
        let at = f.direction(member.reading.theta);
        let sums = [
            format!("Kx cos({theta}) + Ky sin({theta})"),
            format!("{x}·cos({at}) + {y}·sin({at})"),
        ];
        let [symbols, numbers] = sums.map(|sum| match slide.reversed {
            true => format!("-({sum})"),
            false => sum,
        });
        page.document
            .equation(["p".to_owned(), symbols, numbers, f.beside(p, size)]);
        page.document.equation([
            "q".to_owned(),
            format!("Kx^2 + Ky^2 - {}^2", arm.length),
            f.beside(q, size * size),
        ]);
        [p, q]
    }

    /// `theta = atan2(y, x) = ...` of an arm that is minus another vector, told in words.
    fn write_direction(
        &self,
        page: &mut Page,
        arm: &Arm<'_>,
        (along, what): (Vec2, &str),
        size: f64,
        loss: f64,
    ) {
        let f = self.figures;
        let worked = along.angle().to_degrees() - arm.ahead;
        page.agree_angle(&arm.theta, worked, arm.solved, loss);
        let [y, x] = [along.y, along.x].map(|v| f.beside(v, size));
        let back = |text: String| match arm.ahead == 0.0 {
            true => text,
            false => format!("{text} - {}", f.angle(arm.ahead)),
        };
        page.document.equation([
            arm.theta.clone(),
            back(format!("angle of -({what})")),
            back(format!("atan2({y}, {x})")),
            turn(f, worked),
        ]);
        if let Some(side) = arm.side {
            self.write_link_angle(page, side, worked, loss);
        }
    }

    /// The sides that turn with the guide, among them the one along it, must be minus the known ones.
    pub(super) fn swing(&self, page: &mut Page, arm: &[Term], slide: Term) {
        let f = self.figures;
        let member = self.member(slide);
        let (name, u) = (member.side.name.clone(), member.reading.u);
        let m = self.write_components(page, ["mx", "my"]);
        let size = m.norm();
        page.document.equation([
            "m".to_owned(),
            "sqrt(mx^2 + my^2)".into(),
            format!("{} {}", f.number(size), f.unit),
        ]);
        // The other sides of the arm, along the guide's vector and across it: they never change.
        let others = arm.iter().filter(|t| **t != slide).map(|&t| self.member(t));
        let rest = others.fold(Vec2::ZERO, |sum, o| {
            let r = o.reading.vector();
            sum + if o.reversed { -r } else { r }
        });
        let sign = if slide.reversed { -1.0 } else { 1.0 };
        let (t0, e) = (u.dot(rest), u.cross(rest));
        let has_rest = rest.norm() > 1e-12 * size.max(member.reading.r.abs());
        let (t0, e) = if has_rest { (t0, e) } else { (0.0, 0.0) };
        let square = (size - e.abs()) * (size + e.abs());
        let w = square
            .max(0.0)
            .sqrt()
            .copysign(t0 + sign * member.reading.r);
        let worked = sign * (w - t0);
        let loss = 1.0 + size / w.abs().max(1e-8 * size);
        page.agree(&name, worked, member.reading.r, size * loss);
        if has_rest {
            self.write_offset(page, slide, [size, t0, e, w, worked]);
        } else {
            let minus = if sign * w < 0.0 { "-" } else { "" };
            let found = format!("{} {}", f.beside(worked, size), f.unit);
            page.document.equation([name, format!("{minus}m"), found]);
        }
        let ahead = e.atan2(w).to_degrees();
        let angle_of_m = m.angle().to_degrees();
        let theta = member.side.theta();
        let value = angle_of_m - ahead;
        page.agree_angle(&theta, value, member.reading.theta, loss);
        let atan = format!("atan2({}, {})", f.beside(m.y, size), f.beside(m.x, size));
        let second = if has_rest || ahead != 0.0 {
            let e = f.beside(e, size);
            format!("{atan} - atan2({e}, {})", f.beside(w, size))
        } else {
            atan
        };
        page.document.equation([theta, second, turn(f, value)]);
        self.write_link_angle(page, member.side, value, loss);
    }

    /// The position where the guide passes the pivot at a distance e.
    fn write_offset(&self, page: &mut Page, slide: Term, [m, t, e, w, found]: [f64; 5]) {
        let f = self.figures;
        let name = &self.member(slide).side.name;
        let [t, e] = [t, e].map(|v| f.beside(v, m));
        page.document.text(format!(
            "The other sides that turn with {name} lie t = {t} along it and e = {e} to its left:"
        ));
        let minus = if w < 0.0 { "-" } else { "" };
        page.document.equation([
            "w".to_owned(),
            format!("{minus}sqrt(m^2 - e^2)"),
            format!("{minus}sqrt({}^2 - {}^2)", f.number(m), factor(&e)),
            f.beside(w, m),
        ]);
        let minus = if slide.reversed { "-" } else { "" };
        page.document.equation([
            name.clone(),
            format!("{minus}(w - t)"),
            format!("{} {}", f.beside(found, m), f.unit),
        ]);
    }

    // ---- two positions

    /// Each removed by the normal of its guide.
    pub(super) fn guides(&self, page: &mut Page, a: Term, b: Term) {
        let f = self.figures;
        let size = self.known.norm().max(self.member(a).reading.r.abs());
        for (own, other) in [(a, b), (b, a)] {
            let (own, other) = (self.member(own), self.member(other));
            let axis = Axis::Across(Heading::of(&other));
            let pieces = pieces(&self.members, &axis, f);
            let sum = known(&pieces);
            let factor_of = other.reading.u.cross(own.reading.u);
            let factor_of = if own.reversed { -factor_of } else { factor_of };
            let worked = -sum / factor_of;
            page.agree(
                &own.side.name,
                worked,
                own.reading.r,
                size / factor_of.abs(),
            );
            let divisor = factor(&f.beside(factor_of, 1.0));
            page.document.equation([
                own.side.name.clone(),
                format!("-{}/{divisor}", factor(&f.beside(sum, size))),
                format!("{} {}", f.beside(worked, size), f.unit),
            ]);
        }
    }

    /// A vector that closes its loop alone.
    pub(super) fn sum(&self, page: &mut Page, term: Term) {
        let f = self.figures;
        let member = self.member(term);
        let m = self.write_components(page, ["mx", "my"]);
        let size = m.norm();
        let name = member.side.name.clone();
        page.agree(&name, size, member.reading.r, self.longest());
        page.document.equation([
            name,
            "sqrt(mx^2 + my^2)".into(),
            format!("{} {}", f.number(size), f.unit),
        ]);
        let worked = m.angle().to_degrees();
        let theta = member.side.theta();
        page.agree_angle(&theta, worked, member.reading.theta, self.longest() / size);
        page.document
            .equation([theta, "atan2(my, mx)".into(), turn(f, worked)]);
    }
}

/// Why a quadratic has no root, or that it would have.
fn no_root(page: &mut Page, figures: Figures, under: f64, arm: &Arm<'_>) {
    page.document
        .equation(["p^2 - q".to_owned(), figures.number(under)]);
    let text = if under < 0.0 {
        format!("It is negative: {} does not reach the guide.", arm.length)
    } else {
        "It would close, but the motion that starts at the scene's assembly does not come here."
            .into()
    };
    page.document.text(text);
}
