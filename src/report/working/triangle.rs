//! A dyad of two angles: the triangle of both arms and the line between their pivots, as in the lecture.

use super::figures::{Figures, Sum};
use super::page::Page;
use super::polygon::Term;
use super::solution::{Arm, Solution, degrees, turn};

/// A distance of pivots below this part of the arms is none.
const MEETING: f64 = 1e-12;

impl Solution<'_> {
    /// The cosine theorem in the triangle of both arms and m, as in the lecture.
    pub(super) fn triangle(&self, page: &mut Page, a: &[Term], b: &[Term]) {
        let f = self.figures;
        let [first, second] = self.in_order(a, b);
        let [p, x, q] = self.joints(&first, &second);
        let (one, two) = (self.arm(&first), self.arm(&second));
        page.document.text(format!(
            "With m from {p} to {q}, and {x} where the two arms meet:"
        ));
        let m = self.write_components(page, ["mx", "my"]);
        let (size, b, c) = (m.norm(), one.value, two.value);
        page.document.equation([
            "m".to_owned(),
            "sqrt(mx^2 + my^2)".into(),
            format!("{} {}", f.number(size), f.unit),
        ]);
        if !self.context.has_positions() {
            return reach(page, f, size, [&one, &two]);
        }
        if size <= MEETING * b.max(c) {
            return self.coincident(page, [p, q], [&one, &two]);
        }
        let alpha = (-m.y).atan2(m.x).to_degrees();
        page.document
            .equation(["α".to_owned(), "atan2(-my, mx)".into(), degrees(f, alpha)]);
        let corner = |near: &Arm<'_>, far: &Arm<'_>| {
            let cosine = (size * size + near.value * near.value - far.value * far.value)
                / (2.0 * size * near.value);
            // At a dead point rounding may carry it beyond 1.
            cosine.clamp(-1.0, 1.0).acos().to_degrees()
        };
        let (beta, gamma) = (corner(&one, &two), corner(&two, &one));
        for (name, near, far, value) in [("β", &one, &two, beta), ("γ", &two, &one, gamma)] {
            let [n, o] = [near, far].map(|arm| arm.figure(f));
            let m = f.number(size);
            page.document.equation([
                name.to_owned(),
                format!(
                    "acos((m^2 + {0}^2 - {1}^2)/(2 m {0}))",
                    near.length, far.length
                ),
                format!("acos(({m}^2 + {n}^2 - {o}^2)/(2·{m}·{n}))"),
                degrees(f, value),
            ]);
        }
        let left = m.cross(one.direction()) >= 0.0;
        let side = if left { "left" } else { "right" };
        page.document.text(format!(
            "{x} lies on the {side} of {p} → {q}, by the assembly:"
        ));
        let sign = if left { 1.0 } else { -1.0 };
        // What the cosine loses near a stretched dyad: its rounding over the sine.
        let loss = |corner: f64| {
            1.0 + (b.max(c).max(size) / b.min(c).min(size))
                / corner.to_radians().sin().abs().max(1e-8)
        };
        self.write_angle(page, &one, [-alpha, sign * beta], ["-α", "β"], loss(beta));
        self.write_angle(
            page,
            &two,
            [-alpha, -sign * gamma],
            ["-α", "γ"],
            loss(gamma),
        );
    }

    /// Where the pivots of a dyad lie on each other no triangle tells its angles.
    fn coincident(&self, page: &mut Page, [p, q]: [&str; 2], arms: [&Arm<'_>; 2]) {
        page.document.text(format!(
            "{p} and {q} lie on each other: there is no triangle, and the angles are the limits along the motion:"
        ));
        for arm in arms {
            page.document
                .equation([arm.theta.clone(), turn(self.figures, arm.solved)]);
        }
    }

    /// `theta = -alpha + beta + 180 = ...`.
    pub(super) fn write_angle(
        &self,
        page: &mut Page,
        arm: &Arm<'_>,
        parts: [f64; 2],
        names: [&str; 2],
        loss: f64,
    ) {
        let f = self.figures;
        let ahead = -arm.ahead;
        let (mut symbols, mut numbers) = (Sum::default(), Sum::default());
        for (value, name) in parts.into_iter().zip(names) {
            let name = name.trim_start_matches('-');
            // The first part is minus the symbol, the second goes by its sign.
            let negative = if name == "α" { true } else { value < 0.0 };
            symbols.push(negative, name);
            numbers.push_figure(&f.number(value));
        }
        if arm.ahead != 0.0 {
            symbols.push_figure(&f.angle(ahead));
            numbers.push_figure(&f.angle(ahead));
        }
        let worked = parts[0] + parts[1] + ahead;
        page.agree_angle(&arm.theta, worked, arm.solved, loss);
        page.document.equation([
            arm.theta.clone(),
            symbols.text(),
            numbers.text(),
            turn(f, worked),
        ]);
        if let Some(side) = arm.side {
            self.write_link_angle(page, side, worked, loss);
        }
    }
}

/// Why two arms do not meet, or that they would.
fn reach(page: &mut Page, figures: Figures, size: f64, [one, two]: [&Arm<'_>; 2]) {
    let (sum, difference) = (one.value + two.value, (one.value - two.value).abs());
    // Just outside the range the difference stands behind the digits that are shown elsewhere.
    let nearest = if size > sum { sum } else { difference };
    let gap = ((size - nearest) / nearest).abs().max(f64::EPSILON);
    let needed = (-gap.log10()).clamp(0.0, 16.0).ceil();
    let digits = figures.digits.max(needed as usize + 2).min(17);
    let precise = |value: f64| Figures { digits, ..figures }.number(value);
    let text = if size > sum {
        format!(
            "m = {} is longer than {} + {} = {} {}: the arms do not reach each other.",
            precise(size),
            one.length,
            two.length,
            precise(sum),
            figures.unit
        )
    } else if size < difference {
        format!(
            "m = {} is shorter than |{} - {}| = {} {}: the arms cannot close the triangle.",
            precise(size),
            one.length,
            two.length,
            precise(difference),
            figures.unit
        )
    } else {
        "This triangle would close, but the motion that starts at the scene's assembly does not come here.".into()
    };
    page.document.text(text);
}
