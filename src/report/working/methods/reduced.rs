//! Reduces a loop of two unknowns to one equation in one unknown: the squared length of an arm
//! eliminates the other.

use super::super::context::{Context, Draft};
use super::super::expression::Expression;
use super::super::figures::Figures;
use super::super::loops::group_unknowns::{LoopUnknown, ProblemForm, Stage};
use super::super::loops::polygon::Term;
use super::super::loops::sides::{SideShape, Turns};
use super::super::loops::solution::{DyadArm, Solution};
use crate::page::{Formula, Symbol};
use crate::study::{UnknownKind, half_turn};
use crate::wording::words;
use crate::{Vec2, angle};

/// Maximum distance of two roots, relative to half a turn or to the reach, that counts as one
/// double root split by rounding errors.
const IN_LINE: f64 = 1e-6;

/// An equation f(x) = 0 with a root on either side of x = `middle`, at most `reach` away; x is in
/// degrees, or in the scene's unit.
pub(super) struct ReducedLoop<'a> {
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
    /// The formula of the other unknown, in terms of x.
    pub(super) formula: Formula,
    reduction: ReductionKind<'a>,
}

/// Factor of the interval's width. An arm along the guide itself has its root at its full length,
/// so the interval must extend farther.
const INTERVAL_FACTOR: f64 = 1.5;

enum ReductionKind<'a> {
    /// |m - a u(x)|^2 - b^2, with the angle of b.
    Turn {
        m: Vec2,
        a: DyadArm<'a>,
        b: DyadArm<'a>,
    },
    /// |K + x u|^2 - a^2 along a guide of known direction, with the angle of a.
    Along {
        known: Vec2,
        u: Vec2,
        arm: DyadArm<'a>,
    },
    /// (x + t)^2 + e^2 - m^2 along a guide that rotates with x, with its angle.
    Reach {
        m: Vec2,
        sign: f64,
        t: f64,
        e: f64,
        theta: Symbol,
    },
}

impl ReducedLoop<'_> {
    /// Returns f(x).
    pub(super) fn value(&self, x: f64) -> f64 {
        match &self.reduction {
            ReductionKind::Turn { m, a, b } => {
                (*m - angle::unit(x + a.ahead) * a.value).norm2() - b.value * b.value
            }
            ReductionKind::Along { known, u, arm } => {
                (*known + *u * x).norm2() - arm.value * arm.value
            }
            ReductionKind::Reach { m, sign, t, e, .. } => {
                (sign * x + t) * (sign * x + t) + e * e - m.norm2()
            }
        }
    }

    /// Returns the other unknown for a given x: the symbol of an angle, and its value in degrees.
    pub(super) fn follows(&self, x: f64) -> (&Symbol, f64) {
        match &self.reduction {
            ReductionKind::Turn { m, a, b } => {
                let rest = *m - angle::unit(x + a.ahead) * a.value;
                (&b.theta, angle::wrapped(angle::degrees(rest) - b.ahead))
            }
            ReductionKind::Along { known, u, arm } => {
                let rest = -(*known + *u * x);
                (&arm.theta, angle::wrapped(angle::degrees(rest) - arm.ahead))
            }
            ReductionKind::Reach {
                m,
                sign,
                t,
                e,
                theta,
            } => {
                let own = Vec2::new(sign * x + t, *e);
                (
                    theta,
                    angle::wrapped(angle::degrees(*m) - angle::degrees(own)),
                )
            }
        }
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

impl<'a> Solution<'a> {
    /// Writes the loop as one equation and returns it; `None` if it has no such form.
    pub(super) fn reduced(&self, draft: &mut Draft, stage: &Stage) -> Option<ReducedLoop<'a>> {
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

    fn reduced_turn(&self, draft: &mut Draft, a: &[Term], b: &[Term]) -> Option<ReducedLoop<'a>> {
        let f = self.figures;
        let [first, second] = self.in_order(a, b);
        let [p, x, q] = self.joints(&first, &second);
        let (link, ahead) = turning(self.context, &first)?;
        let (one, two) = (self.arm(&first), self.arm(&second));
        draft.text(words().with_m_between(self.diagonal(), p, q, x));
        let _ = self.write_m(draft);
        let symbol = |name: &Symbol| Expression::symbol(name.clone());
        let at = match one.ahead {
            0.0 => symbol(&one.theta),
            more => symbol(&one.theta) + Expression::figure(f.angle(more), more),
        };
        let m = self.diagonal();
        let arm = Expression::symbol(one.length.clone());
        let [cos, sin] = at.cos_and_sin();
        let x = symbol(&Symbol::indexed(m, "x")) - arm.clone() * cos;
        let y = symbol(&Symbol::indexed(m, "y")) - arm * sin;
        write_function(draft, symbol(&one.theta), [&x, &y], &two);
        let formula = Expression::atan2(y, x);
        let along = Some(m);
        let m = -self.known;
        Some(ReducedLoop {
            along,
            formula: two.angle_of(formula, f).symbols(),
            symbol: one.theta.clone(),
            unknown: LoopUnknown::Angle(link),
            kind: UnknownKind::Angle,
            ahead: if first.len() == 1 { ahead } else { 0.0 },
            middle: angle::wrapped(angle::degrees(m) - one.ahead),
            reach: angle::TURN / 2.0,
            right: self.context.has_positions().then_some(one.solved),
            reduction: ReductionKind::Turn { m, a: one, b: two },
        })
    }

    fn reduced_along(
        &self,
        draft: &mut Draft,
        arm: &[Term],
        slide: Term,
    ) -> Option<ReducedLoop<'a>> {
        let member = self.member(slide);
        let SideShape::Slide(id) = member.side.shape else {
            return None;
        };
        let arm = self.arm(arm);
        let name = &member.side.name;
        let theta = member.side.theta();
        let size = self.known.norm().max(arm.value);
        draft.text(words().known_sides_are_k());
        self.write_known(draft, size);
        let r = || Expression::symbol(name.as_str());
        let [cos, sin] = Expression::symbol(theta).cos_and_sin();
        let [x, y] = [("x", cos), ("y", sin)].map(|(axis, part)| {
            let along = (r() * part).minus_if(slide.reversed);
            Expression::symbol(Symbol::indexed("K", axis)) + along
        });
        write_function(draft, r(), [&x, &y], &arm);
        let u = member.reading.u * if slide.reversed { -1.0 } else { 1.0 };
        let formula = Expression::atan2(-y, -x);
        Some(ReducedLoop {
            along: None,
            formula: arm.angle_of(formula, self.figures).symbols(),
            symbol: name.as_str().into(),
            unknown: LoopUnknown::Travel(id),
            kind: UnknownKind::Length,
            ahead: 0.0,
            middle: -self.known.dot(u),
            reach: INTERVAL_FACTOR * arm.value,
            right: self.context.has_positions().then_some(member.reading.r),
            reduction: ReductionKind::Along {
                known: self.known,
                u,
                arm,
            },
        })
    }

    fn reduced_reach(
        &self,
        draft: &mut Draft,
        arm: &[Term],
        slide: Term,
    ) -> Option<ReducedLoop<'a>> {
        let (f, member) = (self.figures, self.member(slide));
        let SideShape::Slide(id) = member.side.shape else {
            return None;
        };
        let [mx, my] = self.write_m(draft);
        let size = self.write_length(draft, self.diagonal(), [&mx, &my]);
        let [t, e] = self.side_components(arm, slide, size);
        let sign = if slide.reversed { -1.0 } else { 1.0 };
        let name = &member.side.name;
        let written = |symbol, v: f64| f.rounded(symbol, v, size);
        let mut along = Expression::symbol(name.as_str()).minus_if(slide.reversed);
        if t != 0.0 || e != 0.0 {
            let [t, e] = [t, e].map(|v| f.format_or_zero(v, size));
            draft.text(words().others_turn_with(name, &t, &e));
            along = along + written("t", 0.0);
        }
        let square = along.squared();
        let square = match e {
            0.0 => square,
            e => square + written("e", e).squared(),
        };
        let complete = square - written(self.diagonal(), size).squared();
        draft.equation([function_of(name.as_str()), complete.symbols()]);
        let r = Expression::symbol(name.as_str());
        let t_of = Expression::symbol("t");
        let [left, ahead] = match (t == 0.0 && e == 0.0, slide.reversed) {
            (true, is_reversed) => [Expression::Number(0.0), r.minus_if(is_reversed)],
            (false, false) => [Expression::symbol("e"), r + t_of],
            (false, true) => [Expression::symbol("e"), t_of - r],
        };
        let formula = Expression::atan2(my, mx) - Expression::atan2(left, ahead);
        Some(ReducedLoop {
            along: None,
            formula: formula.symbols(),
            symbol: name.as_str().into(),
            unknown: LoopUnknown::Travel(id),
            kind: UnknownKind::Length,
            ahead: 0.0,
            middle: -sign * t,
            reach: INTERVAL_FACTOR * size,
            right: self.context.has_positions().then_some(member.reading.r),
            reduction: ReductionKind::Reach {
                m: -self.known,
                sign,
                t,
                e,
                theta: member.side.theta(),
            },
        })
    }
}

/// Writes f, the difference of the squared distance of these components and an arm.
fn write_function(draft: &mut Draft, of: Expression, [x, y]: [&Expression; 2], arm: &DyadArm<'_>) {
    let length = Expression::symbol(arm.length.clone());
    let formula = x.clone().squared() + y.clone().squared() - length.squared();
    draft.equation([function_of(of.symbols()), formula.symbols()]);
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
