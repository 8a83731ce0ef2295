//! Solves a dyad of two angles: the triangle of both arms and the line between their pivots, as in
//! the lecture.

use super::context::Draft;
use super::expression::{Expression, Function};
use super::figures::Figures;
use super::loops::polygon::Term;
use super::loops::solution::{DyadArm, Solution, degrees, turn};
use crate::wording::words;

/// Relative distance of pivots below which they coincide.
const MEETING: f64 = 1e-12;

/// Maximum sine of the angle between arms and m at which they count as aligned.
const IN_LINE: f64 = 1e-6;

impl Solution<'_> {
    /// Writes the solution by the cosine theorem in the triangle of both arms and m, as in the
    /// lecture.
    pub(super) fn triangle(&self, draft: &mut Draft, a: &[Term], b: &[Term]) {
        let f = self.figures;
        let [first, second] = self.in_order(a, b);
        let [p, x, q] = self.joints(&first, &second);
        let (one, two) = (self.arm(&first), self.arm(&second));
        draft.text(words().with_m_between(self.diagonal(), p, q, x));
        let [mx, my] = self.write_m(draft);
        let m = self.diagonal();
        let size = self.write_length(draft, m, [&mx, &my]);
        let (b, c) = (one.value, two.value);
        if !self.context.has_positions() {
            return reach(draft, f, (m, size), [&one, &two]);
        }
        if size <= MEETING * b.max(c) {
            return self.coincident(draft, [p, q], [&one, &two]);
        }
        let alpha = Expression::atan2(-my, mx);
        let alpha = draft.found("α", &alpha, |alpha| degrees(f, alpha));
        let m_known = || f.computed(m, size);
        // The cosine theorem.
        let corner = |near: &DyadArm<'_>, far: &DyadArm<'_>| {
            let [near, far] = [near, far].map(|arm| arm.expression(f));
            let sum = m_known().squared() + near.clone().squared() - far.squared();
            let cosine = sum / (Expression::Number(2.0) * m_known() * near);
            Expression::of(Function::Acos, [cosine])
        };
        let [beta, gamma] = [("β", &one, &two), ("γ", &two, &one)].map(|(symbol, near, far)| {
            draft.worked(symbol, &corner(near, far), |angle| degrees(f, angle))
        });
        let left = (-self.known).cross(one.direction()) >= 0.0;
        let across = (-self.known).cross(one.direction()).abs();
        draft.text(match left {
            _ if across <= IN_LINE * size => words().lies_on_the_line(x, p, q),
            true => words().lies_to_the_left(x, p, q),
            false => words().lies_to_the_right(x, p, q),
        });
        let sign = if left { 1.0 } else { -1.0 };
        // The error of the cosine near a stretched dyad: its rounding error over the sine.
        let loss = |corner: f64| {
            1.0 + (b.max(c).max(size) / b.min(c).min(size))
                / corner.to_radians().sin().abs().max(1e-8)
        };
        let angle = |symbol, value: f64| f.computed(symbol, value);
        for (arm, symbol, corner, sign) in [(&one, "β", beta, sign), (&two, "γ", gamma, -sign)] {
            let theta = -angle("α", alpha) + angle(symbol, corner).minus_if(sign < 0.0);
            self.write_angle(draft, arm, theta, loss(corner));
        }
    }

    /// Writes the angles of a dyad with coinciding pivots, which no triangle determines.
    fn coincident(&self, draft: &mut Draft, [p, q]: [&str; 2], arms: [&DyadArm<'_>; 2]) {
        draft.text(words().pivots_coincide(p, q));
        for arm in arms {
            draft.equation([arm.theta.clone().into(), turn(self.figures, arm.solved)]);
        }
    }

    /// Writes the unknown angle of an arm from its direction: `theta = -alpha + beta + 180 = ...`.
    pub(super) fn write_angle(
        &self,
        draft: &mut Draft,
        arm: &DyadArm<'_>,
        direction: Expression,
        loss: f64,
    ) {
        let f = self.figures;
        let theta = arm.angle_of(direction, f);
        let computed = draft.worked(arm.theta.clone(), &theta, |computed| turn(f, computed));
        draft.agree_angle(&arm.theta, computed, arm.solved, loss);
        if let Some(side) = arm.side {
            self.write_link_angle(draft, side, computed, loss);
        }
    }
}

/// Explains why two arms do not meet, or that they would.
fn reach(
    draft: &mut Draft,
    figures: Figures,
    (m, size): (&str, f64),
    [one, two]: [&DyadArm<'_>; 2],
) {
    let (sum, difference) = (one.value + two.value, (one.value - two.value).abs());
    // Just outside the range, the difference needs more digits than shown elsewhere.
    let nearest = if size > sum { sum } else { difference };
    let gap = ((size - nearest) / nearest).abs().max(f64::EPSILON);
    let needed = (-gap.log10()).clamp(0.0, 16.0).ceil();
    let digits = figures.digits.max(needed as usize + 2).min(17);
    let precise = |value: f64| Figures { digits, ..figures }.number(value);
    let equals = |size: f64| format!("{m} = {}", precise(size));
    let text = if size > sum {
        let sum = format!("{} {}", precise(sum), figures.unit);
        words().arms_too_short(&equals(size), &one.length, &two.length, &sum)
    } else if size < difference {
        let difference = format!("{} {}", precise(difference), figures.unit);
        words().arms_too_unlike(&equals(size), &one.length, &two.length, &difference)
    } else {
        words().triangle_would_close().into()
    };
    draft.text(text);
}
