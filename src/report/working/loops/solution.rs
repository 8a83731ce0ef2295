//! A loop prepared for solving: the sum of its known sides, and its arms.

use super::group_unknowns::{ProblemForm, Stage};
use super::polygon::{Loop, Term};
use super::sides::{Side, SideShape, Turns};
use crate::page::{Formula, Symbol};
use crate::report::working::context::{Context, Draft};
use crate::report::working::equations::{
    EquationTerm, LoopSide, Multiplier, in_figures, known, longest, pieces, sum,
};
use crate::report::working::expression::Expression;
use crate::report::working::figures::Figures;
use crate::report::working::positions::single;
use crate::report::working::symbols;
use crate::solver::Order;
use crate::{Vec2, angle};

/// A loop prepared for solving, with its known sides summed.
pub(crate) struct Solution<'a> {
    pub(crate) context: &'a Context<'a>,
    pub(crate) stage: &'a Stage,
    pub(crate) of: &'a Loop,
    pub(crate) members: Vec<LoopSide<'a>>,
    pub(crate) figures: Figures,
    /// The sum of the known sides.
    pub(crate) known: Vec2,
}

impl<'a> Solution<'a> {
    pub(crate) fn new(context: &'a Context<'a>, stage: &'a Stage) -> Option<Self> {
        let (&[number], false) = (&stage.loops[..], matches!(stage.form, ProblemForm::Nothing))
        else {
            return None;
        };
        let of = &context.polygon.loops[number];
        let members = context.members(of, stage);
        let sum =
            |axis: &Multiplier| known(&pieces(&members, Order::Position, axis, context.figures));
        let known = Vec2::new(sum(&Multiplier::X), sum(&Multiplier::Y));
        Some(Solution {
            context,
            stage,
            of,
            figures: context.figures,
            known,
            members,
        })
    }

    /// Returns `true` if only the group's unknowns are missing, so that the solution can be tried
    /// without an assembly.
    pub(crate) fn is_known(&self) -> bool {
        let own = |term: &Term| match &self.stage.form {
            ProblemForm::Triangle(a, b) => a.contains(term) || b.contains(term),
            ProblemForm::Quadratic(arm, slide) => arm.contains(term) || term == slide,
            ProblemForm::Nothing
            | ProblemForm::Swing(..)
            | ProblemForm::Guides(..)
            | ProblemForm::Sum(_)
            | ProblemForm::System => false,
        };
        let tries = matches!(
            self.stage.form,
            ProblemForm::Triangle(..) | ProblemForm::Quadratic(..)
        );
        let mut pairs = self.of.terms.iter().zip(&self.members);
        tries && pairs.all(|(term, member)| own(term) || member.sought == [false, false])
    }

    pub(crate) fn member(&self, term: Term) -> LoopSide<'_> {
        self.context.member(term, self.stage)
    }

    /// Returns the known sides along an axis, in symbols and evaluated.
    pub(crate) fn known_text(&self, axis: &Multiplier) -> [Formula; 2] {
        let pieces = pieces(&self.members, Order::Position, axis, self.figures).into_iter();
        let known: Vec<EquationTerm> = pieces.filter(|p| p.unknown.is_none()).collect();
        [sum(&known).symbols(), in_figures(&known, self.figures)]
    }

    /// Returns the letter of the vector that the unknown sides add up to: the lecture's m, or
    /// another one if the scene uses m as the name of a vector or a link.
    pub(crate) fn diagonal(&self) -> &'static str {
        self.context.polygon.diagonal
    }

    /// Writes the components of the required sum of the unknown sides, m = -(known sides).
    pub(crate) fn write_m(&self, draft: &mut Draft) -> [Expression; 2] {
        let f = self.figures;
        let m = -self.known;
        let size = longest(&self.members);
        let letter = self.diagonal();
        let [x, y] = ["x", "y"].map(|axis| Symbol::indexed(letter, axis));
        [(Multiplier::X, x, m.x), (Multiplier::Y, y, m.y)].map(|(axis, name, value)| {
            let [symbols, figures] = self.known_text(&axis);
            draft.equation([
                name.clone().into(),
                Formula::sign('-').then(symbols.in_brackets()),
                Formula::sign('-').then(figures.in_brackets()),
                f.length_or_zero(value, size),
            ]);
            f.rounded(name, value, size)
        })
    }

    /// Writes the length of a vector from its components, under a name, and returns it.
    pub(crate) fn write_length(
        &self,
        draft: &mut Draft,
        name: &str,
        [x, y]: [&Expression; 2],
    ) -> f64 {
        let square = x.clone().squared() + y.clone().squared();
        draft.found(name, &square.sqrt(), |size| self.figures.length(size))
    }

    /// Returns an arm: its length, and the angle by which its direction leads the angle named after
    /// it.
    pub(crate) fn arm(&self, arm: &[Term]) -> DyadArm<'a> {
        match single(arm) {
            Some(term) => {
                let member = self.member(term);
                DyadArm {
                    side: self.context.polygon.sides.get(term.side),
                    length: member.side.name.as_str().into(),
                    value: member.reading.r,
                    given: !member.side.stretches(),
                    theta: member.side.theta(),
                    ahead: if term.reversed {
                        angle::TURN / 2.0
                    } else {
                        0.0
                    },
                    solved: member.reading.theta,
                }
            }
            None => self.composed(arm),
        }
    }

    /// Combines several sides that rotate together into one arm.
    fn composed(&self, arm: &[Term]) -> DyadArm<'a> {
        let members: Vec<LoopSide<'_>> = arm.iter().map(|&term| self.member(term)).collect();
        let sum = members.iter().fold(Vec2::ZERO, |sum, m| sum + m.vector());
        let link = members.iter().find_map(|m| m.side.turns_with());
        let own = link.map_or(0.0, |link| self.context.state.angle(link));
        let sides = members.iter();
        let sides = sides.map(|m| Expression::symbol(m.side.name.as_str()).minus_if(m.reversed));
        let name = link.map_or("", |link| self.context.scene.link_name(link));
        DyadArm {
            side: None,
            length: Expression::sum(sides).symbols().between(['|', '|']),
            value: sum.norm(),
            given: false,
            theta: symbols::theta(name),
            ahead: angle::wrapped(angle::degrees(sum) - own),
            solved: own,
        }
    }

    /// Returns the names of the start, the common joint and the end of a dyad's arms.
    pub(crate) fn joints(&self, first: &[Term], second: &[Term]) -> [&str; 3] {
        let ends = |term: &Term| self.context.polygon.ends(*term);
        let name = |end: Option<&'a str>| end.unwrap_or("");
        let p = first.first().map(|t| self.context.polygon.ends(*t).0);
        let x = first.last().map(|t| self.context.polygon.ends(*t).1);
        let q = second.last().map(|t| ends(t).1);
        [name(p), name(x), q.unwrap_or("")]
    }

    /// Returns the arms in the order in which the loop traverses them.
    pub(crate) fn in_order<'t>(&self, a: &'t [Term], b: &'t [Term]) -> [Vec<Term>; 2] {
        let count = self.of.terms.len();
        let is_arm = |term: &Term| a.contains(term) || b.contains(term);
        let starts = (0..count).find(|&i| {
            let before = (i + count - 1) % count;
            is_arm(&self.of.terms[i]) && !is_arm(&self.of.terms[before])
        });
        let at = starts.unwrap_or(0);
        let rotated: Vec<Term> = (0..count)
            .map(|i| self.of.terms[(at + i) % count])
            .collect();
        let of = |arm: &[Term]| {
            rotated
                .iter()
                .copied()
                .filter(|t| arm.contains(t))
                .collect()
        };
        if rotated.first().is_some_and(|t| a.contains(t)) {
            [of(a), of(b)]
        } else {
            [of(b), of(a)]
        }
    }

    /// Writes the angle of the link with which a side rotates, if that is not the side's own.
    pub(crate) fn write_link_angle(&self, draft: &mut Draft, side: &Side, theta: f64, loss: f64) {
        let (Turns::With(link, ahead), f) = (side.turns, self.figures) else {
            return;
        };
        if side.shape == SideShape::Link(link) {
            return;
        }
        let symbol = self.context.theta(link);
        let computed = theta - ahead;
        draft.agree_angle(&symbol, computed, self.context.state.angle(link), loss);
        let difference =
            Expression::symbol(side.theta()) - Expression::figure(f.direction(ahead), ahead);
        draft.equation([symbol.into(), difference.symbols(), turn(f, computed)]);
    }
}

/// One arm of a dyad.
pub(crate) struct DyadArm<'a> {
    /// The side, if it is a single one.
    pub(crate) side: Option<&'a Side>,
    /// The symbol of its length.
    pub(crate) length: Formula,
    pub(crate) value: f64,
    pub(crate) given: bool,
    /// The symbol of the unknown angle.
    pub(crate) theta: Symbol,
    /// The angle, in degrees, by which the arm's direction along the loop leads the unknown angle.
    pub(crate) ahead: f64,
    /// The solver's angle.
    pub(crate) solved: f64,
}

impl DyadArm<'_> {
    /// Returns the length.
    pub(crate) fn expression(&self, figures: Figures) -> Expression {
        let figure = match self.given {
            true => figures.given(self.value),
            false => figures.number(self.value),
        };
        Expression::known(self.length.clone(), figure, self.value)
    }

    /// Returns the unknown angle from the direction along the loop.
    pub(crate) fn angle_of(&self, direction: Expression, figures: Figures) -> Expression {
        match self.ahead {
            0.0 => direction,
            ahead => direction - Expression::figure(figures.angle(ahead), ahead),
        }
    }

    /// Returns the direction along the loop, in the solver's state.
    pub(crate) fn direction(&self) -> Vec2 {
        angle::unit(self.solved + self.ahead)
    }
}

pub(crate) fn degrees(figures: Figures, value: f64) -> Formula {
    Formula::measured(figures.number(value), "deg")
}

/// Formats a sum of angles as calculated, and from 0 to below 360 if that differs.
pub(crate) fn angle_sum(figures: Figures, value: f64) -> Formula {
    let is_direction = (0.0..angle::TURN).contains(&value);
    both_angles(figures, value, (!is_direction).then_some(value))
}

/// Formats an angle as calculated, and from 0 to below 360 if that differs.
pub(crate) fn turn(figures: Figures, value: f64) -> Formula {
    let half = angle::TURN / 2.0;
    let signed = angle::wrapped(value + half) - half;
    both_angles(figures, value, (signed < 0.0).then_some(signed))
}

/// Formats an angle from 0 to below 360, after the one calculated if that differs.
fn both_angles(figures: Figures, value: f64, calculated: Option<f64>) -> Formula {
    let direction = Formula::measured(figures.direction(value), "deg");
    match calculated {
        None => direction,
        Some(value) => Formula::measured(figures.angle(value), "deg").equals(direction),
    }
}
