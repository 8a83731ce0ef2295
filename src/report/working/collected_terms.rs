//! Collects the loop equations: expanded in sines and cosines, with all known factors in
//! coefficients, so that the unknowns are isolated and a program can be written from them.

use super::context::{Context, Draft};
use super::equations::{
    EquationTerm, Heading, LoopSide, Multiplier, in_figures, known, longest, pieces, sum,
};
use super::expression::{Expression, Function};
use super::figures::Figures;
use super::loops::group_unknowns::{ProblemForm, Stage};
use super::loops::polygon::Term;
use super::loops::sides::{SideShape, Turns};
use crate::page::{Formula, Symbol};
use crate::solver::Order;
use crate::wording::words;

/// The equations of a loop with their coefficients.
#[derive(Default)]
pub(super) struct Collection {
    coefficients: Vec<Coefficient>,
    equations: Vec<Vec<CollectedTerm>>,
}

/// A known coefficient, named by a letter.
struct Coefficient {
    /// The formula, in symbols and with numbers.
    formulas: [Formula; 2],
    figure: String,
    value: f64,
    /// The magnitude of the formula's terms, which determines its rounding error.
    size: f64,
    /// The power of a length in its dimension.
    power: usize,
}

/// A coefficient, by its index, times unknown factors.
struct CollectedTerm {
    negative: bool,
    coefficient: Option<usize>,
    factors: Option<Expression>,
}

impl CollectedTerm {
    fn new<const N: usize>(
        negative: bool,
        coefficient: Option<usize>,
        factors: [Expression; N],
    ) -> Self {
        CollectedTerm {
            negative,
            coefficient,
            factors: Expression::product(factors),
        }
    }

    /// Returns a term with a coefficient, if that exists.
    fn known<const N: usize>(
        negative: bool,
        coefficient: Option<usize>,
        factors: [Expression; N],
    ) -> Option<Self> {
        coefficient.map(|_| CollectedTerm::new(negative, coefficient, factors))
    }

    /// Returns the term of an unknown length.
    fn length(member: &LoopSide<'_>) -> Option<Self> {
        let length = [unknown_length(member)];
        Some(CollectedTerm::new(member.reversed, None, length))
    }
}

/// Sides that rotate by an unknown angle: components along its direction and to the left.
struct CollectedArm {
    theta: Symbol,
    degrees: f64,
    along: Expression,
    left: Option<Expression>,
}

impl CollectedArm {
    fn turning(&self, function: Function) -> Expression {
        let theta = Expression::unknown(self.theta.clone(), self.degrees);
        Expression::of(function, [theta])
    }

    fn sin(&self) -> Expression {
        self.turning(Function::Sin)
    }

    fn cos(&self) -> Expression {
        self.turning(Function::Cos)
    }
}

/// Returns the unknown length of a side.
fn unknown_length(member: &LoopSide<'_>) -> Expression {
    Expression::unknown(member.side.name.as_str(), member.reading.r)
}

/// Returns the letter of a coefficient: A to Z, then A26.
fn letter(number: usize) -> Symbol {
    match u8::try_from(number) {
        Ok(n) if n < 26 => Symbol::indexed(char::from(b'A' + n).to_string(), ""),
        _ => Symbol::indexed("A", number.to_string()),
    }
}

/// The letters of the coefficients in the single equation that follows from a pair.
const SQUARED: [&str; 3] = ["P", "Q", "R"];

/// Writes the collected equations of a loop in which only the unknowns of its group are unknown.
pub(super) fn collected(context: &Context<'_>, draft: &mut Draft, number: usize, stage: &Stage) {
    if !context.has_positions() || stage.form == ProblemForm::Nothing {
        return;
    }
    let of = &context.polygon.loops[number];
    let members = context.members(of, stage);
    let loop_of = LoopCollector {
        context,
        stage,
        members,
        terms: &of.terms,
    };
    let (collection, multipliers) = match &stage.form {
        ProblemForm::Triangle(a, b) => loop_of.triangle(a, b),
        ProblemForm::Quadratic(arm, slide) => loop_of.quadratic(arm, *slide),
        ProblemForm::Swing(arm, slide) => loop_of.along(*slide, arm),
        ProblemForm::Sum(term) => loop_of.along(*term, &[]),
        ProblemForm::Guides(a, b) => loop_of.guides(*a, *b),
        ProblemForm::System | ProblemForm::Nothing => (loop_of.components(), Vec::new()),
    };
    collection.write(context, draft, number, &multipliers);
    if let ProblemForm::Triangle(a, b) = &stage.form {
        loop_of.of_one_unknown(draft, number, &collection, [a, b]);
    }
}

struct LoopCollector<'a> {
    context: &'a Context<'a>,
    stage: &'a Stage,
    members: Vec<LoopSide<'a>>,
    terms: &'a [Term],
}

impl LoopCollector<'_> {
    fn figures(&self) -> Figures {
        self.context.figures
    }

    fn member(&self, term: Term) -> LoopSide<'_> {
        self.context.member(term, self.stage)
    }

    /// Adds the known terms along an axis, optionally negated, as a coefficient; returns `None` if
    /// there are none.
    fn known(&self, into: &mut Collection, axis: &Multiplier, minus: bool) -> Option<usize> {
        let all = pieces(&self.members, Order::Position, axis, self.figures());
        let mut of: Vec<EquationTerm> = all.into_iter().filter(|p| p.unknown.is_none()).collect();
        if of.is_empty() {
            return None;
        }
        for piece in of.iter_mut().filter(|_| minus) {
            piece.negative = !piece.negative;
            piece.value = -piece.value;
        }
        let formulas = [sum(&of).symbols(), in_figures(&of, self.figures())];
        let value = known(&of);
        let size = of.iter().map(|piece| piece.size).sum();
        Some(into.coefficient(Coefficient {
            figure: self.figures().format_or_zero(value, longest(&self.members)),
            formulas,
            value,
            size,
            power: 1,
        }))
    }

    /// Adds a coefficient given by a formula.
    fn formula(&self, into: &mut Collection, formula: &Expression, power: usize) -> usize {
        let value = formula.value();
        let size = if power == 0 {
            1.0
        } else {
            longest(&self.members)
        };
        let numbers = formula.numbers();
        let figure = match (formula, power) {
            // A length alone is written as given.
            (Expression::Known { .. }, _) => numbers.to_string(),
            (Expression::Minus(of), _) if matches!(**of, Expression::Known { .. }) => {
                numbers.to_string()
            }
            (_, 0) => self.figures().given(value),
            _ => self.figures().format_or_zero(value, size),
        };
        into.coefficient(Coefficient {
            formulas: [formula.symbols(), numbers],
            figure,
            value,
            size,
            power,
        })
    }

    /// Returns the length of a side, with its sign.
    fn length(&self, member: &LoopSide<'_>) -> Expression {
        let f = self.figures();
        let r = member.reading.r;
        let figure = match member.side.stretches() {
            true => f.number(r),
            false => f.given(r),
        };
        Expression::known(member.side.name.as_str(), figure, r).minus_if(member.reversed)
    }

    /// Returns the known direction of a side.
    fn theta(&self, member: &LoopSide<'_>) -> Expression {
        let degrees = member.reading.theta;
        self.figures().directed(member.side.theta(), degrees)
    }

    /// Returns the components of one side, or of several that rotate together.
    fn arm(&self, arm: &[Term]) -> CollectedArm {
        let members: Vec<LoopSide<'_>> = arm.iter().map(|&term| self.member(term)).collect();
        if let [one] = &members[..] {
            return CollectedArm {
                theta: one.side.theta(),
                degrees: one.reading.theta,
                along: self.length(one),
                left: None,
            };
        }
        let link = members.iter().find_map(|m| m.side.turns_with());
        let theta = link.map_or_else(Symbol::default, |link| self.context.theta(link));
        let [along, left] = self.turning_sum(&members, &theta, Some(0.0));
        CollectedArm {
            along: along.unwrap_or(Expression::Number(0.0)),
            left,
            theta,
            degrees: link.map_or(0.0, |link| self.context.state.angle(link)),
        }
    }

    /// Returns the components of sides along a direction and to its left, if they exist. The angle
    /// of the direction to the link with which all of them rotate is constant.
    fn turning_sum(
        &self,
        members: &[LoopSide<'_>],
        theta: &Symbol,
        offset: Option<f64>,
    ) -> [Option<Expression>; 2] {
        [Function::Cos, Function::Sin].map(|function| {
            let terms = members.iter().filter_map(|m| {
                let ahead = match (m.side.turns, offset) {
                    (Turns::With(_, own), Some(offset)) => crate::angle::wrapped(own - offset),
                    _ => 0.0,
                };
                self.turned(m, theta, ahead, function)
            });
            Expression::total(terms)
        })
    }

    /// Returns a side's component along a direction or to its left; `ahead` is the constant angle
    /// from that direction to the side. Returns `None` for a component that is 0 because `ahead`
    /// is.
    fn turned(
        &self,
        member: &LoopSide<'_>,
        theta: &Symbol,
        ahead: f64,
        function: Function,
    ) -> Option<Expression> {
        let length = self.length(member);
        if ahead == 0.0 {
            return (function == Function::Cos).then_some(length);
        }
        let difference =
            Expression::symbol(member.side.theta()) - Expression::symbol(theta.clone());
        let angle = self.figures().directed(difference.symbols(), ahead);
        Some(length * Expression::of(function, [angle]))
    }

    /// Collects a loop with two unknown angles: each equation eliminates the length of one arm's
    /// own side.
    fn triangle(&self, a: &[Term], b: &[Term]) -> (Collection, Vec<Formula>) {
        let mut into = Collection::default();
        let [a, b] = [a, b].map(|arm| self.arm(arm));
        let minus_x = self.known(&mut into, &Multiplier::X, true);
        let y = self.known(&mut into, &Multiplier::Y, false);
        let mut along = [None; 2];
        let mut left = [None; 2];
        for (k, arm) in [&a, &b].into_iter().enumerate() {
            along[k] = Some(self.formula(&mut into, &arm.along, 1));
            left[k] = arm
                .left
                .as_ref()
                .map(|left| self.formula(&mut into, left, 1));
        }
        for ((own, other), k) in [(&b, &a), (&a, &b)].into_iter().zip([0, 1]) {
            let terms = [
                CollectedTerm::known(false, minus_x, [own.sin()]),
                CollectedTerm::known(false, y, [own.cos()]),
                CollectedTerm::known(false, along[k], [other.sin(), own.cos()]),
                CollectedTerm::known(true, along[k], [other.cos(), own.sin()]),
                CollectedTerm::known(false, left[k], [other.cos(), own.cos()]),
                CollectedTerm::known(false, left[k], [other.sin(), own.sin()]),
                CollectedTerm::known(false, left[1 - k], []),
            ];
            into.add(terms);
        }
        let notation = self.context.notation;
        let multipliers = [&b, &a].map(|arm| notation.across(arm.theta.clone()));
        (into, multipliers.into())
    }

    /// Collects a loop with an unknown angle, and a position along a guide of known direction; the
    /// first equation contains only the angle.
    fn quadratic(&self, arm: &[Term], slide: Term) -> (Collection, Vec<Formula>) {
        let mut into = Collection::default();
        let arm = self.arm(arm);
        let slide = self.member(slide);
        let heading = || Heading::of(&slide);
        let [cos, sin] = self.theta(&slide).cos_and_sin();
        let [mut a, mut b] = [
            arm.along.clone() * cos.clone(),
            -(arm.along.clone() * sin.clone()),
        ];
        if let Some(left) = &arm.left {
            a = a + left.clone() * sin;
            b = b + left.clone() * cos;
        }
        let a = Some(self.formula(&mut into, &a, 1));
        let b = Some(self.formula(&mut into, &b, 1));
        let across = self.known(&mut into, &Multiplier::Across(heading()), false);
        let along = self.known(&mut into, &Multiplier::Along(heading()), false);
        into.add([
            CollectedTerm::known(false, a, [arm.sin()]),
            CollectedTerm::known(false, b, [arm.cos()]),
            CollectedTerm::known(false, across, []),
        ]);
        into.add([
            CollectedTerm::length(&slide),
            CollectedTerm::known(false, a, [arm.cos()]),
            CollectedTerm::known(true, b, [arm.sin()]),
            CollectedTerm::known(false, along, []),
        ]);
        (into, self.both_of(&slide))
    }

    /// Returns the names of both unit vectors of a side.
    fn both_of(&self, member: &LoopSide<'_>) -> Vec<Formula> {
        let (notation, theta) = (self.context.notation, member.side.theta());
        vec![notation.across(theta.clone()), notation.along(theta)]
    }

    /// Collects a loop with unknown length and angle of one vector, and sides that rotate with it.
    fn along(&self, own: Term, arm: &[Term]) -> (Collection, Vec<Formula>) {
        let mut into = Collection::default();
        let member = self.member(own);
        let theta = member.side.theta();
        let turning = CollectedArm {
            theta: theta.clone(),
            degrees: member.reading.theta,
            along: self.length(&member),
            left: None,
        };
        let others = arm.iter().filter(|term| **term != own);
        let others: Vec<LoopSide<'_>> = others.map(|&term| self.member(term)).collect();
        let offset = match member.side.turns {
            Turns::With(_, offset) => Some(offset),
            Turns::Never | Turns::Freely => None,
        };
        let minus_x = self.known(&mut into, &Multiplier::X, true);
        let y = self.known(&mut into, &Multiplier::Y, false);
        let [along, across] = self.turning_sum(&others, &theta, offset);
        let [across, along] =
            [across, along].map(|rest| rest.map(|rest| self.formula(&mut into, &rest, 1)));
        into.add([
            CollectedTerm::known(false, minus_x, [turning.sin()]),
            CollectedTerm::known(false, y, [turning.cos()]),
            CollectedTerm::known(false, across, []),
        ]);
        into.add([
            CollectedTerm::length(&member),
            CollectedTerm::known(true, minus_x, [turning.cos()]),
            CollectedTerm::known(false, y, [turning.sin()]),
            CollectedTerm::known(false, along, []),
        ]);
        (into, self.both_of(&member))
    }

    /// Collects a loop with two positions along guides of known directions: an equation for each.
    fn guides(&self, a: Term, b: Term) -> (Collection, Vec<Formula>) {
        let mut into = Collection::default();
        let mut multipliers = Vec::new();
        for (own, other) in [(a, b), (b, a)] {
            let (own, other) = (self.member(own), self.member(other));
            let between = Expression::of(Function::Sin, [self.theta(&own) - self.theta(&other)]);
            let factor = self.formula(&mut into, &between.minus_if(own.reversed), 0);
            let axis = Multiplier::Across(Heading::of(&other));
            let rest = self.known(&mut into, &axis, false);
            into.add([
                CollectedTerm::known(false, Some(factor), [unknown_length(&own)]),
                CollectedTerm::known(false, rest, []),
            ]);
            multipliers.push(axis.name(self.context.notation));
        }
        (into, multipliers)
    }

    /// Collects a loop of a coupled group: both components, with a coefficient for every side.
    fn components(&self) -> Collection {
        let mut into = Collection::default();
        let mut lengths = vec![None; self.terms.len()];
        for (axis, function) in [
            (Multiplier::X, Function::Cos),
            (Multiplier::Y, Function::Sin),
        ] {
            let mut terms: Vec<CollectedTerm> = Vec::new();
            let rest = self.known(&mut into, &axis, false);
            terms.extend(CollectedTerm::known(false, rest, []));
            for (member, length) in self.members.iter().zip(&mut lengths) {
                let turning = Expression::of(function, [self.argument(member)]);
                let stretching = unknown_length(member);
                terms.extend(match member.sought {
                    [false, false] => None,
                    [false, true] => {
                        let own = *length.get_or_insert_with(|| {
                            self.formula(&mut into, &self.length(member), 1)
                        });
                        CollectedTerm::known(false, Some(own), [turning])
                    }
                    [true, true] => {
                        let factors = [stretching, turning];
                        Some(CollectedTerm::new(member.reversed, None, factors))
                    }
                    [true, false] => {
                        let part = Expression::of(function, [self.theta(member)]);
                        let own = self.formula(&mut into, &part.minus_if(member.reversed), 0);
                        CollectedTerm::known(false, Some(own), [stretching])
                    }
                });
            }
            into.equations.push(terms);
        }
        into
    }

    /// Returns the angle of a side, expressed by that of the link with which it rotates.
    fn argument(&self, member: &LoopSide<'_>) -> Expression {
        let angle = match member.side.turns {
            Turns::With(link, ahead) if member.side.shape != SideShape::Link(link) => {
                self.context.leading_angle(link, ahead)
            }
            _ => member.side.theta().into(),
        };
        Expression::unknown(angle, member.reading.theta)
    }

    /// Writes one equation in one angle: squaring and adding both components eliminates the other
    /// angle.
    fn of_one_unknown(
        &self,
        draft: &mut Draft,
        number: usize,
        pair: &Collection,
        arms: [&Vec<Term>; 2],
    ) {
        let [lost, kept] = arms.map(|arm| self.arm(arm));
        // For arms of several sides, the squares would contain those of their components.
        if lost.left.is_some() || kept.left.is_some() || pair.coefficients.len() != 4 {
            return;
        }
        let f = self.figures();
        let coefficient = |k: usize| {
            let of = pair.coefficients.get(k);
            let (figure, value) = of.map_or((String::new(), f64::NAN), |of| {
                (of.figure.clone(), of.value)
            });
            Expression::known(letter(k), figure, value)
        };
        let [a, b] = [coefficient(0), coefficient(1)];
        let [c, d] = [coefficient(2), coefficient(3)];
        let two = || Expression::Number(2.0);
        let squares = [&a, &b, &d].map(|of| of.clone().squared());
        let lengths: f64 = squares.iter().map(Expression::value).sum();
        let formulas = [
            two() * b.clone() * d.clone(),
            -(two() * a.clone() * d.clone()),
            a.squared() + b.squared() + d.squared() - c.clone().squared(),
        ];
        let size = lengths + c.value() * c.value();
        let alone = lost.along.symbols();
        let arm = alone.without_minus().unwrap_or(alone);
        draft.text(words().squared_and_added(&arm, &lost.theta, &kept.theta));
        let factors = || [Some(kept.sin()), Some(kept.cos()), None];
        let terms = SQUARED.map(Expression::symbol).into_iter().zip(factors());
        let terms = terms.map(|(letter, factor)| match factor {
            Some(factor) => letter * factor,
            None => letter,
        });
        draft.write_zero(Expression::sum(terms).symbols());
        let values = [0, 1, 2].map(|k| {
            draft.worked(SQUARED[k], &formulas[k], |value| {
                f.area_or_zero(value, size)
            })
        });
        let terms = values.into_iter().zip(factors());
        let terms = terms
            .filter_map(|(value, factor)| Expression::term(f.format_or_zero(value, size), factor));
        draft.write_zero(Expression::sum(terms).numbers());
        let left = values[0] * kept.sin().value() + values[1] * kept.cos().value() + values[2];
        draft.agree(words().collected_equation(number + 1), left, 0.0, size);
    }
}

impl Collection {
    /// Adds the equation of the terms that exist.
    fn add<const N: usize>(&mut self, terms: [Option<CollectedTerm>; N]) {
        self.equations.push(terms.into_iter().flatten().collect());
    }

    fn coefficient(&mut self, coefficient: Coefficient) -> usize {
        self.coefficients.push(coefficient);
        self.coefficients.len() - 1
    }

    /// Writes the equations with letters, the meanings of the letters, and the equations with
    /// numbers.
    fn write(
        &self,
        context: &Context<'_>,
        draft: &mut Draft,
        number: usize,
        multipliers: &[Formula],
    ) {
        let f = context.figures;
        draft.text(match multipliers {
            [one, other] => words().collected_by(one, other),
            _ => words().collected_with_letters().to_owned(),
        });
        for terms in &self.equations {
            let terms = terms.iter().filter_map(|term| {
                let letter = term.coefficient.map(|k| Expression::symbol(letter(k)));
                let product = Expression::product(letter.into_iter().chain(term.factors.clone()));
                Some(product?.minus_if(term.negative))
            });
            draft.write_zero(Expression::sum(terms).symbols());
        }
        for (k, coefficient) in self.coefficients.iter().enumerate() {
            let unit = match coefficient.power {
                0 => "",
                _ => f.unit,
            };
            let found = Formula::number(&coefficient.figure);
            let mut sides = vec![letter(k).into()];
            for side in &coefficient.formulas {
                // A single term equals its value.
                if *side != found && sides.last() != Some(side) {
                    sides.push(side.clone());
                }
            }
            sides.push(Formula::measured(&coefficient.figure, unit));
            draft.equation(sides);
        }
        draft.text(words().collected_with_numbers());
        for terms in &self.equations {
            let (mut left, mut size) = (0.0, 0.0);
            let mut written = Vec::new();
            for term in terms {
                let of = term.coefficient.and_then(|k| self.coefficients.get(k));
                let value = of.map_or(1.0, |of| of.value);
                let sign = if term.negative { -1.0 } else { 1.0 };
                let factors = term.factors.as_ref();
                left += sign * value * factors.map_or(1.0, Expression::value);
                size += of.map_or(1.0, |of| of.size) * factors.map_or(1.0, Expression::maximum);
                let figure = of.map_or_else(|| "1".to_owned(), |of| of.figure.clone());
                let term_of = Expression::term(figure, term.factors.clone());
                written.extend(term_of.map(|one| one.minus_if(term.negative)));
            }
            draft.write_zero(Expression::sum(written).numbers());
            draft.agree(words().collected_equation(number + 1), left, 0.0, size);
        }
    }
}
