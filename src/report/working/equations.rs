//! Writes the loop equations and their derivatives, term by term: in symbols, with numbers, and
//! with the known factors of each unknown evaluated.
//!
//! With u at theta and n = k x u, a side r u has the derivatives
//!
//! ```text
//! d/dt     r' u + r omega n
//! d2/dt2   (r'' - r omega^2) u + (r alpha + 2 r' omega) n
//! ```
//!
//! Multiplied by the unit vector u_j or n_j of another side, u gives cos(theta - theta_j) or
//! sin(theta - theta_j), and n gives sin(theta_j - theta) or cos(theta - theta_j).

use super::expression::{Expression, Function};
use super::figures::Figures;
use super::loops::sides::{Side, SideReading, Turns};
use super::symbols::{self, WorkingNotation};
use crate::Vec2;
use crate::page::{Formula, Symbol};
use crate::solver::Order;

/// The vector by which a loop equation is multiplied.
#[derive(Clone, Debug)]
pub(super) enum Multiplier {
    /// The unit vector along x.
    X,
    /// The unit vector along y.
    Y,
    /// The unit vector at this angle: it eliminates rotation about it from the rates.
    Along(Heading),
    /// The unit vector perpendicular to it: it eliminates changes of length along it.
    Across(Heading),
}

/// A direction with its symbol.
#[derive(Clone, Debug)]
pub(super) struct Heading {
    pub symbol: Symbol,
    pub degrees: f64,
    pub u: Vec2,
    /// Whether the angle itself is unknown, and represented by its symbol.
    pub open: bool,
}

/// A side of a loop in a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoopSide<'a> {
    pub side: &'a Side,
    pub reversed: bool,
    pub reading: SideReading,
    /// The name of its angular velocity.
    pub turner: &'a str,
    /// Whether its length and its angle are unknown.
    pub sought: [bool; 2],
    /// Whether its rates are the driver's.
    pub driven: bool,
}

/// A term of an equation.
#[derive(Clone, Debug)]
pub(super) struct EquationTerm {
    pub negative: bool,
    /// The term without its sign; the unknown in it has no number.
    pub formula: Expression,
    /// The value, or the factor of the unknown, including the sign.
    pub value: f64,
    /// The maximum absolute value at any angle, which determines its rounding error.
    pub size: f64,
    /// The unknown in it.
    pub unknown: Option<Symbol>,
    /// The factors of the unknown, without the sign; `None` if there are none.
    factor: Option<Expression>,
    /// Whether the unknown is a factor rather than an angle.
    linear: bool,
    /// Whether the term is given, so that it needs no more than its own digits.
    given: bool,
}

impl Heading {
    pub(super) fn of(member: &LoopSide<'_>) -> Heading {
        Heading {
            symbol: member.side.theta(),
            degrees: member.reading.theta,
            u: member.reading.u,
            open: member.sought[1],
        }
    }
}

impl Multiplier {
    /// Returns the components of u and of n = k x u along the axis.
    fn parts(&self, u: Vec2) -> [f64; 2] {
        match self {
            Multiplier::X => [u.x, -u.y],
            Multiplier::Y => [u.y, u.x],
            Multiplier::Along(h) => [h.u.dot(u), u.cross(h.u)],
            Multiplier::Across(h) => [h.u.cross(u), h.u.dot(u)],
        }
    }

    /// Returns the function in the component of u, or of n, and whether it is negative.
    fn function(
        &self,
        turning: bool,
        theta: Expression,
        heading: Expression,
    ) -> (bool, Expression) {
        let (negative, function, angle) = match (self, turning) {
            (Multiplier::X, false) => (false, Function::Cos, theta),
            (Multiplier::X, true) => (true, Function::Sin, theta),
            (Multiplier::Y, false) => (false, Function::Sin, theta),
            (Multiplier::Y, true) => (false, Function::Cos, theta),
            (Multiplier::Along(_), false) | (Multiplier::Across(_), true) => {
                (false, Function::Cos, theta - heading)
            }
            (Multiplier::Along(_), true) => (false, Function::Sin, heading - theta),
            (Multiplier::Across(_), false) => (false, Function::Sin, theta - heading),
        };
        (negative, Expression::of(function, [angle]))
    }

    /// Returns the name of the unit vector.
    pub(super) fn name(&self, notation: WorkingNotation) -> Formula {
        match self {
            Multiplier::X => "x".into(),
            Multiplier::Y => "y".into(),
            Multiplier::Along(h) => notation.along(h.symbol.clone()),
            Multiplier::Across(h) => notation.across(h.symbol.clone()),
        }
    }

    fn heading(&self) -> Option<&Heading> {
        match self {
            Multiplier::X | Multiplier::Y => None,
            Multiplier::Along(h) | Multiplier::Across(h) => Some(h),
        }
    }

    /// Returns `true` if u, or n, of a side is perpendicular to the axis by its symbol alone.
    fn removes(&self, turning: bool, theta: &Symbol) -> bool {
        match self {
            Multiplier::X | Multiplier::Y => false,
            Multiplier::Along(h) => turning && h.symbol == *theta,
            Multiplier::Across(h) => !turning && h.symbol == *theta,
        }
    }

    /// Returns `true` if u, or n, of a side is parallel to the axis by its symbol alone.
    fn keeps(&self, turning: bool, theta: &Symbol) -> bool {
        match self {
            Multiplier::X | Multiplier::Y => false,
            Multiplier::Along(h) => !turning && h.symbol == *theta,
            Multiplier::Across(h) => turning && h.symbol == *theta,
        }
    }
}

/// A product of named factors, some of them unknown, times a function of the angle.
struct FactorProduct {
    negative: bool,
    /// The numeric factor: 2 for the Coriolis term, or 1.
    count: f64,
    factors: Vec<Factor>,
    turning: bool,
}

#[derive(Clone)]
struct Factor {
    symbol: Symbol,
    value: f64,
    square: bool,
    sought: bool,
    given: bool,
}

impl<'a> LoopSide<'a> {
    /// Returns the terms that the side adds to an equation of this order.
    fn pieces(&self, order: Order, axis: &Multiplier, figures: Figures) -> Vec<EquationTerm> {
        let (stretches, turns) = (self.side.stretches(), self.side.turns != Turns::Never);
        let length = || self.length(Order::Position, false);
        let mut products = Vec::new();
        let mut add = |exists: bool, count: f64, turning: bool, factors: Vec<Factor>| {
            products.extend(exists.then_some(FactorProduct {
                negative: self.reversed != (count < 0.0),
                count: count.abs(),
                factors,
                turning,
            }));
        };
        match order {
            Order::Position => add(true, 1.0, false, vec![self.length(order, true)]),
            Order::Velocity => {
                add(stretches, 1.0, false, vec![self.length(order, true)]);
                add(turns, 1.0, true, vec![length(), self.angle(order, true)]);
            }
            // Forces need no further terms of a loop.
            Order::Acceleration | Order::Force => {
                let [rate, omega] = [
                    self.length(Order::Velocity, false),
                    self.angle(Order::Velocity, false),
                ];
                let square = Factor {
                    square: true,
                    ..omega.clone()
                };
                add(stretches, 1.0, false, vec![self.length(order, true)]);
                add(stretches && turns, 2.0, true, vec![rate, omega]);
                add(turns, 1.0, true, vec![length(), self.angle(order, true)]);
                add(turns, -1.0, false, vec![length(), square]);
            }
        }
        let theta = self.side.theta();
        let left = products
            .into_iter()
            .filter(|p| !axis.removes(p.turning, &theta));
        left.map(|product| self.piece(&product, order, axis, figures))
            .collect()
    }

    /// Returns the vector from the start of the side to its end, as the loop traverses it.
    pub(super) fn vector(&self) -> Vec2 {
        let vector = self.reading.vector();
        if self.reversed { -vector } else { vector }
    }

    /// Returns the length or its rate, which is unknown only in the equation of its own order.
    fn length(&self, order: Order, is_own: bool) -> Factor {
        Factor {
            symbol: symbols::length(&self.side.name, order),
            value: self.reading.length(order),
            square: false,
            sought: is_own && self.sought[0],
            given: match order {
                Order::Position => !self.side.stretches(),
                _ => self.driven,
            },
        }
    }

    /// Returns the rate of the angle.
    fn angle(&self, order: Order, is_own: bool) -> Factor {
        Factor {
            symbol: symbols::angle(self.turner, order),
            value: self.reading.angle(order),
            square: false,
            sought: is_own && self.sought[1],
            given: self.driven,
        }
    }

    fn piece(
        &self,
        product: &FactorProduct,
        order: Order,
        axis: &Multiplier,
        figures: Figures,
    ) -> EquationTerm {
        let theta = self.side.theta();
        let is_position = order == Order::Position;
        // In a position, an unknown angle stays inside its function.
        let open_angle = is_position && self.sought[1];
        let angle = |symbol: &Symbol, degrees: f64, is_open: bool| match is_open {
            true => Expression::unknown(symbol.clone(), degrees),
            false => figures.directed(symbol.clone(), degrees),
        };
        let own = angle(&theta, self.reading.theta, open_angle);
        let heading = axis.heading();
        let is_open = is_position && heading.is_some_and(|h| h.open);
        let other = heading.map(|h| angle(&h.symbol, h.degrees, is_open));
        let keeps = axis.keeps(product.turning, &theta);
        let (minus, function) = axis.function(
            product.turning,
            own,
            other.unwrap_or(Expression::Number(0.0)),
        );
        let [along_u, along_n] = axis.parts(self.reading.u);
        let part = if product.turning { along_n } else { along_u };
        let mut size = product.count;
        let mut unknown = None;
        let mut factors = Vec::new();
        if product.count != 1.0 {
            factors.push(Expression::Number(product.count));
        }
        for f in &product.factors {
            if f.sought {
                unknown = Some((f.symbol.clone(), factors.len()));
            } else {
                size *= if f.square { f.value * f.value } else { f.value };
            }
            factors.push(f.expression(figures));
        }
        if !keeps {
            factors.push(function);
        }
        let others = |at: usize| factors[..at].iter().chain(&factors[at + 1..]).cloned();
        EquationTerm {
            negative: product.negative != (minus && !keeps),
            // `part` already contains the sign of the function.
            value: size * if product.negative { -part } else { part },
            size: size.abs(),
            given: self.side.turns == Turns::Never
                && product.factors.iter().all(|f| f.given || f.sought),
            factor: unknown
                .as_ref()
                .and_then(|(_, at)| Expression::product(others(*at))),
            unknown: match unknown {
                Some((symbol, _)) => Some(symbol),
                None => (open_angle || is_open).then_some(theta),
            },
            formula: Expression::product(factors).unwrap_or(Expression::Number(1.0)),
            linear: !open_angle && !is_open,
        }
    }
}

impl Factor {
    fn expression(&self, figures: Figures) -> Expression {
        if self.sought {
            return Expression::symbol(self.symbol.clone());
        }
        let figure = match self.given {
            true => figures.given(self.value),
            false => figures.number(self.value),
        };
        let number = Formula::number(&figure);
        let known = Expression::Known {
            symbol: self.symbol.clone().into(),
            // Also in brackets without another factor.
            figure: match number.without_minus() {
                Some(_) => number.in_brackets(),
                None => number,
            },
            value: self.value,
        };
        if self.square { known.squared() } else { known }
    }
}

/// Returns the sum of the terms.
pub(super) fn sum(pieces: &[EquationTerm]) -> Expression {
    Expression::sum(pieces.iter().map(EquationTerm::signed))
}

impl EquationTerm {
    fn signed(&self) -> Expression {
        self.formula.clone().minus_if(self.negative)
    }
}

/// Writes the sum with every known term evaluated: `-1299.04 - 147.173 ω3`. Terms of positions with
/// an unknown angle stay unchanged.
pub(super) fn in_figures(pieces: &[EquationTerm], figures: Figures) -> Formula {
    let size = pieces
        .iter()
        .fold(0.0_f64, |maximum, p| maximum.max(p.size));
    let terms = pieces.iter().filter_map(|piece| {
        if piece.unknown.is_some() && !piece.linear {
            let numbers = Expression::symbol(piece.formula.numbers());
            return Some(numbers.minus_if(piece.negative));
        }
        let figure = if piece.given && piece.value.abs() > 1e-15 * size {
            figures.given(piece.value)
        } else {
            figures.format_or_zero(piece.value, size)
        };
        let unknown = piece.unknown.clone();
        Expression::term(figure, unknown.map(Expression::symbol))
    });
    Expression::sum(terms).symbols()
}

/// Solves the equation for a rate that is a factor in it: `-r2 ω2 sin(θ4 - θ2)/(r3 sin(θ4 - θ3))`.
pub(super) fn solved_for(pieces: &[EquationTerm], symbol: &Symbol) -> Expression {
    let (below, above): (Vec<EquationTerm>, Vec<EquationTerm>) =
        (pieces.iter().cloned()).partition(|p| p.unknown.as_ref() == Some(symbol));
    // The minus sign of a single divisor moves to the front.
    let is_turned = matches!(below[..], [ref one] if one.negative);
    let (above, negative) = match &above[..] {
        [] => (Expression::Number(0.0), false),
        [one] => (one.formula.clone(), one.negative == is_turned),
        _ => (sum(&above), !is_turned),
    };
    let divisors = below.into_iter().map(|p| {
        match p.factor {
            // The difference of angles in a function would look like one of the whole divisor.
            Some(function @ Expression::Function(..)) => function.in_brackets(),
            factor => factor.unwrap_or(Expression::Number(1.0)),
        }
        .minus_if(p.negative != is_turned)
    });
    let quotient = match Expression::sum(divisors) {
        Expression::Number(1.0) => above,
        divisor => above / divisor,
    };
    quotient.minus_if(negative)
}

/// Returns the terms that the sides add to an equation of this order.
pub(super) fn pieces(
    members: &[LoopSide<'_>],
    order: Order,
    axis: &Multiplier,
    figures: Figures,
) -> Vec<EquationTerm> {
    let of = |member: &LoopSide<'_>| member.pieces(order, axis, figures);
    members.iter().flat_map(of).collect()
}

/// Returns the length of the longest side.
pub(super) fn longest(members: &[LoopSide<'_>]) -> f64 {
    let lengths = members.iter().map(|member| member.reading.r.abs());
    lengths.fold(0.0, f64::max)
}

/// Returns the sum of the known terms.
pub(super) fn known(pieces: &[EquationTerm]) -> f64 {
    let known = pieces.iter().filter(|p| p.unknown.is_none());
    known.map(|p| p.value).sum()
}

/// Returns the factor of an unknown.
pub(super) fn coefficient(pieces: &[EquationTerm], symbol: &Symbol) -> f64 {
    let of_it = pieces.iter().filter(|p| p.unknown.as_ref() == Some(symbol));
    of_it.map(|p| p.value).sum()
}
