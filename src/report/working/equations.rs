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

use super::figures::{Figures, WrittenSum, factor};
use super::loops::sides::{Side, SideReading, Turns};
use super::symbols::{self, WorkingNotation};
use crate::Vec2;
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
    pub symbol: String,
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
    /// The term without its sign: in symbols, and with numbers for known values.
    pub symbols: String,
    pub numbers: String,
    /// The value, or the factor of the unknown, including the sign.
    pub value: f64,
    /// The maximum absolute value at any angle, which determines its rounding error.
    pub size: f64,
    /// The unknown in it.
    pub unknown: Option<String>,
    /// The factors of the unknown, without the sign: in symbols, and with numbers; 1 if there are
    /// none.
    factors: [String; 2],
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
    fn function(&self, turning: bool, theta: &str, heading: &str) -> (bool, String) {
        match (self, turning) {
            (Multiplier::X, false) => (false, format!("cos({theta})")),
            (Multiplier::X, true) => (true, format!("sin({theta})")),
            (Multiplier::Y, false) => (false, format!("sin({theta})")),
            (Multiplier::Y, true) => (false, format!("cos({theta})")),
            (Multiplier::Along(_), false) | (Multiplier::Across(_), true) => {
                (false, format!("cos({theta} - {heading})"))
            }
            (Multiplier::Along(_), true) => (false, format!("sin({heading} - {theta})")),
            (Multiplier::Across(_), false) => (false, format!("sin({theta} - {heading})")),
        }
    }

    /// Returns the name of the unit vector.
    pub(super) fn name(&self, notation: WorkingNotation) -> String {
        match self {
            Multiplier::X => "x".into(),
            Multiplier::Y => "y".into(),
            Multiplier::Along(h) => notation.along(&h.symbol),
            Multiplier::Across(h) => notation.across(&h.symbol),
        }
    }

    fn heading(&self) -> Option<&Heading> {
        match self {
            Multiplier::X | Multiplier::Y => None,
            Multiplier::Along(h) | Multiplier::Across(h) => Some(h),
        }
    }

    /// Returns `true` if u, or n, of a side is perpendicular to the axis by its symbol alone.
    fn removes(&self, turning: bool, theta: &str) -> bool {
        match self {
            Multiplier::X | Multiplier::Y => false,
            Multiplier::Along(h) => turning && h.symbol == theta,
            Multiplier::Across(h) => !turning && h.symbol == theta,
        }
    }

    /// Returns `true` if u, or n, of a side is parallel to the axis by its symbol alone.
    fn keeps(&self, turning: bool, theta: &str) -> bool {
        match self {
            Multiplier::X | Multiplier::Y => false,
            Multiplier::Along(h) => !turning && h.symbol == theta,
            Multiplier::Across(h) => turning && h.symbol == theta,
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

struct Factor {
    symbol: String,
    value: f64,
    square: bool,
    sought: bool,
    given: bool,
}

impl<'a> LoopSide<'a> {
    /// Returns the terms that the side adds to an equation of this order.
    pub(super) fn pieces(
        &self,
        order: Order,
        axis: &Multiplier,
        figures: Figures,
    ) -> Vec<EquationTerm> {
        let products = match order {
            Order::Position => vec![self.product(false, 1.0, false, vec![self.length()])],
            Order::Velocity => self.velocity(),
            // Forces need no further terms of a loop.
            Order::Acceleration | Order::Force => self.acceleration(),
        };
        let theta = self.side.theta();
        let left = products
            .into_iter()
            .filter(|p| !axis.removes(p.turning, &theta));
        left.map(|product| self.piece(&product, order, axis, figures))
            .collect()
    }

    fn velocity(&self) -> Vec<FactorProduct> {
        let mut products = Vec::new();
        if self.side.stretches() {
            products.push(self.product(false, 1.0, false, vec![self.rate(true)]));
        }
        if self.turns() {
            let factors = vec![self.length_known(), self.omega(true, false)];
            products.push(self.product(false, 1.0, true, factors));
        }
        products
    }

    fn acceleration(&self) -> Vec<FactorProduct> {
        let mut products = Vec::new();
        if self.side.stretches() {
            products.push(self.product(false, 1.0, false, vec![self.accel()]));
        }
        if self.side.stretches() && self.turns() {
            let factors = vec![self.rate(false), self.omega(false, false)];
            products.push(self.product(false, 2.0, true, factors));
        }
        if self.turns() {
            let turning = vec![self.length_known(), self.alpha()];
            products.push(self.product(false, 1.0, true, turning));
            let centripetal = vec![self.length_known(), self.omega(false, true)];
            products.push(self.product(true, 1.0, false, centripetal));
        }
        products
    }

    fn turns(&self) -> bool {
        self.side.turns != Turns::Never
    }

    fn product(
        &self,
        negative: bool,
        count: f64,
        turning: bool,
        factors: Vec<Factor>,
    ) -> FactorProduct {
        FactorProduct {
            negative: negative != self.reversed,
            count,
            factors,
            turning,
        }
    }

    fn length(&self) -> Factor {
        Factor {
            symbol: self.side.name.clone(),
            value: self.reading.r,
            square: false,
            sought: self.sought[0],
            given: !self.side.stretches(),
        }
    }

    /// Returns the length as a known factor, for rates.
    fn length_known(&self) -> Factor {
        Factor {
            sought: false,
            ..self.length()
        }
    }

    fn rate(&self, unknown: bool) -> Factor {
        Factor {
            symbol: symbols::rate(&self.side.name),
            value: self.reading.rate,
            square: false,
            sought: unknown && self.sought[0],
            given: self.driven,
        }
    }

    fn accel(&self) -> Factor {
        Factor {
            symbol: symbols::accel(&self.side.name),
            value: self.reading.accel,
            square: false,
            sought: self.sought[0],
            given: self.driven,
        }
    }

    fn omega(&self, unknown: bool, square: bool) -> Factor {
        Factor {
            symbol: symbols::omega(self.turner),
            value: self.reading.omega,
            square,
            sought: unknown && self.sought[1],
            given: self.driven,
        }
    }

    fn alpha(&self) -> Factor {
        Factor {
            symbol: symbols::alpha(self.turner),
            value: self.reading.alpha,
            square: false,
            sought: self.sought[1],
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
        let angle = if open_angle {
            theta.clone()
        } else {
            figures.direction(self.reading.theta)
        };
        let heading = axis.heading();
        let is_open = is_position && heading.is_some_and(|h| h.open);
        let (symbol, degrees) = heading.map_or_else(Default::default, |h| {
            let figure = if is_open {
                h.symbol.clone()
            } else {
                figures.direction(h.degrees)
            };
            (h.symbol.clone(), figure)
        });
        let keeps = axis.keeps(product.turning, &theta);
        let (minus, function) = axis.function(product.turning, &theta, &symbol);
        let (_, with_numbers) = axis.function(product.turning, &angle, &degrees);
        let [along_u, along_n] = axis.parts(self.reading.u);
        let part = if product.turning { along_n } else { along_u };
        let mut size = product.count;
        let mut unknown = None;
        let (mut symbols, mut numbers) = (Vec::new(), Vec::new());
        let mut extra: [Vec<String>; 2] = [Vec::new(), Vec::new()];
        if product.count != 1.0 {
            symbols.push(figures.given(product.count));
            numbers.push(figures.given(product.count));
        }
        for f in &product.factors {
            let square = if f.square { "^2" } else { "" };
            symbols.push(format!("{}{square}", f.symbol));
            if f.sought {
                numbers.push(f.symbol.clone());
                unknown = Some(f.symbol.clone());
            } else {
                let figure = if f.given {
                    figures.given(f.value)
                } else {
                    figures.number(f.value)
                };
                numbers.push(format!("{}{square}", factor(&figure)));
                size *= if f.square { f.value * f.value } else { f.value };
            }
        }
        if !keeps {
            symbols.push(function);
            numbers.push(with_numbers);
        }
        if let Some(unknown) = &unknown {
            extra = [&symbols, &numbers].map(|all| {
                let others = all.iter().filter(|text| *text != unknown);
                others.cloned().collect()
            });
        }
        let negative = product.negative != (minus && !keeps);
        EquationTerm {
            negative,
            symbols: symbols.join(" "),
            numbers: numbers.join("·"),
            // `part` already contains the sign of the function.
            value: size * if product.negative { -part } else { part },
            size: size.abs(),
            unknown: unknown.or((open_angle || is_open).then_some(theta)),
            given: self.side.turns == Turns::Never
                && product.factors.iter().all(|f| f.given || f.sought),
            factors: [(0, " "), (1, "·")].map(|(form, between)| match extra[form].as_slice() {
                [] => "1".to_owned(),
                factors => factors.join(between),
            }),
            linear: !open_angle && !is_open,
        }
    }
}

/// Writes the sum in symbols.
pub(super) fn in_symbols(pieces: &[EquationTerm]) -> String {
    let mut sum = WrittenSum::default();
    pieces.iter().for_each(|p| sum.push(p.negative, &p.symbols));
    sum.text()
}

/// Writes the sum with numbers for known values.
pub(super) fn in_numbers(pieces: &[EquationTerm]) -> String {
    let mut sum = WrittenSum::default();
    pieces.iter().for_each(|p| sum.push(p.negative, &p.numbers));
    sum.text()
}

/// Writes the sum with every known term evaluated: `-1299.04 - 147.173 ω3`. Terms of positions with
/// an unknown angle stay unchanged.
pub(super) fn in_figures(pieces: &[EquationTerm], figures: Figures) -> String {
    let size = pieces
        .iter()
        .fold(0.0_f64, |maximum, p| maximum.max(p.size));
    let mut sum = WrittenSum::default();
    for piece in pieces {
        let figure = if piece.given && piece.value.abs() > 1e-15 * size {
            figures.given(piece.value)
        } else {
            figures.format_or_zero(piece.value, size)
        };
        match &piece.unknown {
            Some(_) if !piece.linear => sum.push(piece.negative, &piece.numbers),
            // Zero terms are omitted.
            _ if figure == "0" => {}
            Some(symbol) => sum.push_figure(&times(&figure, symbol)),
            None => sum.push_figure(&figure),
        }
    }
    sum.text()
}

/// Solves the equation for a rate that is a factor in it: `-r2 ω2 sin(θ4 - θ2)/(r3 sin(θ4 - θ3))`,
/// in symbols and with numbers.
pub(super) fn solved_for(pieces: &[EquationTerm], symbol: &str) -> [String; 2] {
    let is_own = |piece: &&EquationTerm| piece.unknown.as_deref() == Some(symbol);
    let above: Vec<&EquationTerm> = pieces.iter().filter(|p| !is_own(p)).collect();
    let below: Vec<&EquationTerm> = pieces.iter().filter(is_own).collect();
    // The minus sign of a single divisor moves to the front.
    let is_turned = matches!(below[..], [one] if one.negative);
    let sum = |of: &[&EquationTerm], turned: bool, text: &dyn Fn(&EquationTerm) -> String| {
        let mut sum = WrittenSum::default();
        of.iter()
            .for_each(|p| sum.push(p.negative != turned, &text(p)));
        sum.text()
    };
    [0, 1].map(|form| {
        let complete = |p: &EquationTerm| match form {
            0 => p.symbols.clone(),
            _ => p.numbers.clone(),
        };
        let (above, is_sum) = match above[..] {
            [] => ("0".to_owned(), false),
            [_] => (sum(&above, !is_turned, &complete), false),
            _ => (sum(&above, false, &complete), true),
        };
        let divisor = sum(&below, is_turned, &|p| p.factors[form].clone());
        let above = match (is_sum, is_turned, divisor.as_str()) {
            (false, ..) | (true, true, "1") => above,
            (true, true, _) => format!("({above})"),
            (true, false, _) => format!("-({above})"),
        };
        let is_product = divisor.contains([' ', '·']);
        match divisor.as_str() {
            "1" => above,
            _ if is_product => format!("{above}/({divisor})"),
            _ => format!("{above}/{divisor}"),
        }
    })
}

/// Writes a value times a symbol, without a factor of 1.
fn times(figure: &str, symbol: &str) -> String {
    match figure {
        "1" => symbol.to_owned(),
        "-1" => format!("-{symbol}"),
        _ => format!("{figure} {symbol}"),
    }
}

/// Returns the sum of the known terms.
pub(super) fn known(pieces: &[EquationTerm]) -> f64 {
    let known = pieces.iter().filter(|p| p.unknown.is_none());
    known.map(|p| p.value).sum()
}

/// Returns the factor of an unknown.
pub(super) fn coefficient(pieces: &[EquationTerm], symbol: &str) -> f64 {
    let of_it = pieces
        .iter()
        .filter(|p| p.unknown.as_deref() == Some(symbol));
    of_it.map(|p| p.value).sum()
}
