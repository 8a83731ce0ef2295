//! Reduces a loop of two unknowns to one equation in one unknown: the squared length of an arm
//! eliminates the other.

use super::super::context::{Context, Draft};
use super::super::expression::Expression;
use super::super::figures::Figures;
use super::super::loops::group_unknowns::{LoopUnknown, ProblemForm, Stage};
use super::super::loops::polygon::Term;
use super::super::loops::sides::{SideShape, Turns};
use super::super::loops::solution::{DyadArm, Solution};
use crate::angle;
use crate::page::{Formula, Symbol};
use crate::study::{UnknownKind, half_turn};
use crate::wording::words;

/// Maximum distance of two roots, relative to half a turn or to the reach, that counts as one
/// double root split by rounding errors.
const IN_LINE: f64 = 1e-6;

/// An equation f(x) = 0 with a root on either side of x = `middle`, at most `reach` away; x is in
/// degrees, or in the scene's unit.
pub(super) struct ReducedLoop {
    pub(super) symbol: Symbol,
    pub(super) unknown: LoopUnknown,
    pub(super) kind: UnknownKind,
    /// The value of x at which the unknown is 0.
    pub(super) ahead: f64,
    /// The minimum of f.
    pub(super) middle: f64,
    pub(super) reach: f64,
    /// The value of x in the assembly, if there is one.
    pub(super) right: Option<f64>,
    /// The vector along which the arm lies at the middle, if x is an angle.
    pub(super) along: Option<&'static str>,
    /// The other unknown, an angle, and its formula in terms of x.
    pub(super) other: (Symbol, Expression),
    /// f in terms of x.
    function: Expression,
}

/// Factor of the interval's width. An arm along the guide itself has its root at its full length,
/// so the interval must extend farther.
const INTERVAL_FACTOR: f64 = 1.5;

impl ReducedLoop {
    /// Returns f(x).
    pub(super) fn value(&self, x: f64) -> f64 {
        self.function.at(x)
    }

    /// Returns the other unknown for a given x, in degrees.
    pub(super) fn follows(&self, x: f64) -> f64 {
        angle::wrapped(self.other.1.at(x))
    }

    /// Returns `true` if x and `other` are on the same side of the middle.
    pub(super) fn is_same_side(&self, x: f64, other: f64) -> bool {
        self.off(x) * self.off(other) > 0.0
    }

    /// Returns `true` if both assemblies coincide up to rounding errors: the arms are aligned,
    /// extended or folded.
    pub(super) fn are_one(&self, right: f64) -> bool {
        let off = self.off(right).abs();
        match self.kind {
            UnknownKind::Angle => off.min(180.0 - off) <= IN_LINE * 180.0,
            UnknownKind::Length => off <= IN_LINE * self.reach,
        }
    }

    /// Returns the distance of x from the assembly: in rad, or relative to the longest length.
    /// Returns `None` without an assembly.
    pub(super) fn error(&self, x: f64, longest: f64) -> Option<f64> {
        let off = x - self.right?;
        Some(match self.kind {
            UnknownKind::Angle => half_turn(off.to_radians()).abs(),
            UnknownKind::Length => off.abs() / longest,
        })
    }

    /// Returns the offset of x from the middle; an angle within half a turn.
    fn off(&self, x: f64) -> f64 {
        match self.kind {
            UnknownKind::Angle => half_turn((x - self.middle).to_radians()).to_degrees(),
            UnknownKind::Length => x - self.middle,
        }
    }

    /// Returns the interval on the side of another value, or by default the one above the middle.
    pub(super) fn interval(&self, extra: Option<f64>) -> [f64; 2] {
        let from = match self.kind {
            // Signed, so that the interval of half a turn below it stays below 360.
            UnknownKind::Angle => half_turn(self.middle.to_radians()).to_degrees(),
            UnknownKind::Length => self.middle,
        };
        if extra.is_some_and(|x| self.off(x) < 0.0) {
            [from - self.reach, from]
        } else {
            [from, from + self.reach]
        }
    }
}

impl Solution<'_> {
    /// Writes the loop as one equation and returns it; `None` if it has no such form.
    pub(super) fn reduced(&self, draft: &mut Draft, stage: &Stage) -> Option<ReducedLoop> {
        match &stage.form {
            ProblemForm::Triangle(a, b) => self.reduced_turn(draft, a, b),
            ProblemForm::Quadratic(arm, slide) => self.reduced_along(draft, arm, *slide),
            ProblemForm::Swing(arm, slide) => self.reduced_reach(draft, arm, *slide),
            ProblemForm::Nothing
            | ProblemForm::Guides(..)
            | ProblemForm::Sum(_)
            | ProblemForm::System => None,
        }
    }

    fn reduced_turn(&self, draft: &mut Draft, a: &[Term], b: &[Term]) -> Option<ReducedLoop> {
        let f = self.figures;
        let [first, second] = self.in_order(a, b);
        let [p, x, q] = self.joints(&first, &second);
        let (link, ahead) = turning(self.context, &first)?;
        let (one, two) = (self.arm(&first), self.arm(&second));
        draft.text(words().with_m_between(self.diagonal(), p, q, x));
        let [mx, my] = self.write_m(draft);
        let theta = || Expression::symbol(one.theta.clone());
        let at = match one.ahead {
            0.0 => theta(),
            more => theta() + Expression::figure(f.angle(more), more),
        };
        let arm = Expression::unknown(one.length.clone(), one.value);
        let [cos, sin] = at.cos_and_sin();
        let (x, y) = (mx - arm.clone() * cos, my - arm * sin);
        let function = write_function(draft, theta(), [&x, &y], &two);
        let m = -self.known;
        Some(ReducedLoop {
            along: Some(self.diagonal()),
            other: (two.theta.clone(), two.angle_of(Expression::atan2(y, x), f)),
            function,
            symbol: one.theta.clone(),
            unknown: LoopUnknown::Angle(link),
            kind: UnknownKind::Angle,
            ahead: if first.len() == 1 { ahead } else { 0.0 },
            middle: angle::wrapped(angle::degrees(m) - one.ahead),
            reach: angle::TURN / 2.0,
            right: self.context.has_positions().then_some(one.solved),
        })
    }

    fn reduced_along(&self, draft: &mut Draft, arm: &[Term], slide: Term) -> Option<ReducedLoop> {
        let member = self.member(slide);
        let SideShape::Slide(id) = member.side.shape else {
            return None;
        };
        let arm = self.arm(arm);
        let name = &member.side.name;
        let theta = Expression::symbol(member.side.theta());
        let size = self.known.norm().max(arm.value);
        draft.text(words().known_sides_are_k());
        self.write_known(draft, size);
        let r = || Expression::symbol(name.as_str());
        let [cos, sin] = theta.cos_and_sin();
        let (k, u) = (self.known, member.reading.u);
        let parts = [("x", k.x, cos, u.x), ("y", k.y, sin, u.y)];
        let [x, y] = parts.map(|(axis, k, part, value)| {
            let along = r() * Expression::unknown(part.symbols(), value);
            Expression::unknown(Symbol::indexed("K", axis), k) + along.minus_if(slide.reversed)
        });
        let function = write_function(draft, r(), [&x, &y], &arm);
        let formula = Expression::atan2(-y, -x);
        Some(ReducedLoop {
            along: None,
            other: (arm.theta.clone(), arm.angle_of(formula, self.figures)),
            function,
            symbol: name.as_str().into(),
            unknown: LoopUnknown::Travel(id),
            kind: UnknownKind::Length,
            ahead: 0.0,
            middle: if slide.reversed { k.dot(u) } else { -k.dot(u) },
            reach: INTERVAL_FACTOR * arm.value,
            right: self.context.has_positions().then_some(member.reading.r),
        })
    }

    fn reduced_reach(&self, draft: &mut Draft, arm: &[Term], slide: Term) -> Option<ReducedLoop> {
        let (f, member) = (self.figures, self.member(slide));
        let SideShape::Slide(id) = member.side.shape else {
            return None;
        };
        let [mx, my] = self.write_m(draft);
        let size = self.write_length(draft, self.diagonal(), [&mx, &my]);
        let [t, e] = self.side_components(arm, slide, size);
        let sign = if slide.reversed { -1.0 } else { 1.0 };
        let name = &member.side.name;
        let t_of = Expression::unknown("t", t);
        let e_of = Expression::unknown("e", e);
        let mut along = Expression::symbol(name.as_str()).minus_if(slide.reversed);
        if t != 0.0 || e != 0.0 {
            let [t, e] = [t, e].map(|v| f.format_or_zero(v, size));
            draft.text(words().others_turn_with(name, &t, &e));
            along = along + t_of.clone();
        }
        let square = along.squared();
        let square = match e {
            0.0 => square,
            _ => square + e_of.clone().squared(),
        };
        let m = Formula::from(self.diagonal()).power("2");
        let function = square - Expression::unknown(m, self.known.norm2());
        draft.equation([function_of(name.as_str()), function.symbols()]);
        let r = Expression::symbol(name.as_str());
        let [left, ahead] = match (t == 0.0 && e == 0.0, slide.reversed) {
            (true, is_reversed) => [Expression::Number(0.0), r.minus_if(is_reversed)],
            (false, false) => [e_of, r + t_of],
            (false, true) => [e_of, t_of - r],
        };
        let formula = Expression::atan2(my, mx) - Expression::atan2(left, ahead);
        Some(ReducedLoop {
            along: None,
            other: (member.side.theta(), formula),
            function,
            symbol: name.as_str().into(),
            unknown: LoopUnknown::Travel(id),
            kind: UnknownKind::Length,
            ahead: 0.0,
            middle: -sign * t,
            reach: INTERVAL_FACTOR * size,
            right: self.context.has_positions().then_some(member.reading.r),
        })
    }
}

/// Writes f, the difference of the squared distance of these components and an arm.
fn write_function(
    draft: &mut Draft,
    of: Expression,
    [x, y]: [&Expression; 2],
    arm: &DyadArm<'_>,
) -> Expression {
    let length = Expression::unknown(arm.length.clone(), arm.value);
    let function = x.clone().squared() + y.clone().squared() - length.squared();
    draft.equation([function_of(of.symbols()), function.symbols()]);
    function
}

/// Returns the function f of a formula.
pub(super) fn function_of(of: impl Into<Formula>) -> Formula {
    Formula::from("f").then(of.into().in_brackets())
}

/// Returns the link with which the sides of an arm rotate, and the angle by which the first side
/// leads it; `None` for a direction that does not depend on a single link.
fn turning(context: &Context<'_>, arm: &[Term]) -> Option<(crate::LinkId, f64)> {
    match context.polygon.sides.get(arm.first()?.side)?.turns {
        Turns::With(link, ahead) => Some((link, ahead)),
        Turns::Never | Turns::Freely => None,
    }
}

/// Formats a value: an angle within a turn, or a length.
pub(super) fn figure(figures: Figures, kind: UnknownKind, value: f64) -> Formula {
    match kind {
        UnknownKind::Angle => Formula::measured(figures.direction(value), "deg"),
        UnknownKind::Length => figures.length(value),
    }
}
