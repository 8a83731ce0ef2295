//! The vectors of each loop with their given or computed values, for tables with a column per
//! vector and for drawn polygons.

use super::polygon::{Loop, Term};
use super::sides::{Side, SideReading, SideShape};
use crate::page::{Cell, Formula, Symbol};
use crate::report::working::Working;
use crate::report::working::context::Context;
use crate::report::working::introduction::sum_text;
use crate::report::working::symbols;
use crate::scene::Scene;
use crate::solver::{Order, Solver, State};
use crate::wording::words;
use crate::{Body, SlideId, Vec2};

/// A loop of vectors.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopVectors {
    /// The sum: `r1 + r2 + r3 + r4`.
    pub sum: String,
    /// The vectors in the order in which the loop traverses them.
    pub vectors: Vec<LoopVector>,
}

/// A vector of a loop.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopVector {
    /// The name of the vector.
    pub name: String,
    /// The vector from its tail to its head, if the loop has an assembly.
    pub vector: Option<Vec2>,
    /// `true` if the loop traverses the vector from head to tail.
    pub is_reversed: bool,
    /// `true` if an input moves the vector.
    pub is_driven: bool,
    /// The direction in degrees, and its symbol.
    pub theta: (f64, String),
    /// Length and angle, for each order of derivative.
    pub figures: [[VectorFigure; 2]; 3],
    /// The motion of its head relative to its tail.
    pub motion: RelativeMotion,
}

/// The motion of a vector's head relative to its tail, split along and across the vector.
#[derive(Clone, Debug, PartialEq)]
pub struct RelativeMotion {
    /// The name of the head; if only the tail moves, that of the tail, to which the components then
    /// belong.
    pub of: String,
    /// The suffix of the symbol, such as `/B`; empty if the other end is fixed.
    pub about: String,
    /// `true` if only the tail moves.
    pub is_of_tail: bool,
    /// The velocity along the vector and across it; `None` if there are no rates.
    pub velocity: Option<[Vec2; 2]>,
    /// The acceleration: the centripetal one, the tangential one, Coriolis's, and that along the
    /// vector.
    pub acceleration: Option<[Vec2; 4]>,
}

/// A value of a vector.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VectorFigure {
    /// The symbol of the value.
    pub symbol: Symbol,
    /// The column of the value; for a vector without one, that of the link with which it rotates.
    pub column: String,
    /// The formatted value; `None` if it does not exist here.
    pub value: Option<String>,
    /// `true` if the value is an unknown, `false` if it is given.
    pub is_sought: bool,
    /// The number of the earlier loop that finds it, from 1; `None` if it is given, or found by
    /// this loop.
    pub found_by: Option<usize>,
}

impl VectorFigure {
    /// Returns the cell before the solution: a given value, `θ3 = ?`, or `from loop 1` for an
    /// unknown of another loop.
    #[must_use]
    pub fn before(&self) -> Cell {
        match (&self.value, self.is_sought, self.found_by) {
            (Some(value), false, _) => Cell::proved(value),
            (_, true, Some(number)) => Cell::proved(words().found_by_loop(number)),
            _ => self.unknown(),
        }
    }

    /// Returns the cell of an unknown: `θ3 = ?`.
    #[must_use]
    pub fn unknown(&self) -> Cell {
        self.equal_to(Formula::sign('?'))
    }

    /// Returns the cell after the solution: a given value, or `θ3 = 29.3794`.
    #[must_use]
    pub fn after(&self) -> Cell {
        match (&self.value, self.is_sought) {
            (Some(value), true) => self.equal_to(Formula::number(value)),
            (None, true) => self.unknown(),
            (_, false) => self.before(),
        }
    }

    fn equal_to(&self, value: Formula) -> Cell {
        Cell::equation(Formula::from(&self.symbol).equals(value))
    }
}

impl Working {
    /// Returns the name of the point from which a slide's position is measured: the scene's, or an
    /// invented one.
    #[must_use]
    pub fn guide_point(&self, slide: SlideId) -> Option<&str> {
        let mut sides = self.polygon.sides.iter();
        let side = sides.find(|side| side.shape == SideShape::Slide(slide));
        side.map(|side| side.head.as_str())
    }

    /// Returns the vectors of every loop in a state.
    #[must_use]
    pub fn loop_vectors(
        &self,
        scene: &Scene,
        solver: &Solver,
        state: &State,
        digits: usize,
    ) -> Vec<LoopVectors> {
        let context = self.context(scene, solver, state, digits);
        let loops = self.polygon.loops.iter();
        let of = loops.map(|of| LoopVectors {
            sum: sum_text(&context, of).to_string(),
            vectors: of
                .terms
                .iter()
                .map(|&term| vector(&context, of, term))
                .collect(),
        });
        of.collect()
    }
}

fn vector(context: &Context<'_>, of: &Loop, term: Term) -> LoopVector {
    let side = &context.polygon.sides[term.side];
    let reading = &context.readings[term.side];
    LoopVector {
        name: side.name.clone(),
        vector: context.has_positions().then(|| reading.vector()),
        is_reversed: term.reversed,
        is_driven: context.schedule.is_driven(side) || context.schedule.is_pushed(side),
        theta: (reading.theta, side.theta().to_string()),
        figures: [Order::Position, Order::Velocity, Order::Acceleration]
            .map(|order| figures(context, of, (side, reading), order)),
        motion: relative_motion(context, side, reading),
    }
}

fn relative_motion(context: &Context<'_>, side: &Side, reading: &SideReading) -> RelativeMotion {
    let [is_tail_fixed, is_head_fixed] = [&side.tail, &side.head].map(|name| {
        let mechanism = &context.scene.mechanism;
        let mut points = mechanism.point_ids();
        match points.find(|&point| context.scene.point_name(point) == Some(name.as_str())) {
            Some(point) => mechanism.point(point).ground.is_some(),
            // An invented point of a guide.
            None => match side.shape {
                SideShape::Slide(slide) => mechanism.slide(slide).on == Body::Ground,
                _ => false,
            },
        }
    });
    let is_of_tail = is_head_fixed && !is_tail_fixed;
    let of = if is_of_tail { &side.tail } else { &side.head };
    let about = match is_tail_fixed || is_head_fixed {
        true => String::new(),
        false => format!("/{}", side.tail),
    };
    let sign = if is_of_tail { -1.0 } else { 1.0 };
    let SideReading {
        r,
        rate,
        accel,
        omega,
        alpha,
        u,
        ..
    } = *reading;
    let (along, across) = (u * sign, u.perp() * sign);
    let exists = context.has_rates();
    RelativeMotion {
        of: of.clone(),
        about,
        is_of_tail,
        velocity: exists.then(|| [along * rate, across * (r * omega)]),
        acceleration: exists.then(|| {
            [
                along * (-r * omega * omega),
                across * (r * alpha),
                across * (2.0 * rate * omega),
                along * accel,
            ]
        }),
    }
}

/// Returns the number of the loop that finds a group's unknowns, from 1; `None` if that is this
/// loop or one solved with it, or if there is no such group.
fn found_by(context: &Context<'_>, of: &Loop, group: Option<usize>) -> Option<usize> {
    let group = group.filter(|group| Some(*group) != of.group)?;
    let finds = |other: &Loop| other.group == Some(group);
    let index = context.polygon.loops.iter().position(finds)?;
    Some(index + 1)
}

/// Returns the columns of length and angle of a side, or of their rates. A side without a name in
/// the scene uses those of the link with which it rotates.
fn columns(side: &Side, turner: &str, order: Order) -> [String; 2] {
    let own = if side.named {
        side.name.as_str()
    } else {
        turner
    };
    let (length, angle) = match order {
        Order::Position => ("length", format!("{own}.angle")),
        Order::Velocity => ("rate", format!("{turner}.omega")),
        Order::Acceleration | Order::Force => ("accel", format!("{turner}.alpha")),
    };
    [format!("{}.{length}", side.name), angle]
}

/// Returns length and angle of a side, or their rates of an order.
fn figures(
    context: &Context<'_>,
    of: &Loop,
    (side, reading): (&Side, &SideReading),
    order: Order,
) -> [VectorFigure; 2] {
    let groups = [
        context.schedule.length_group(side),
        context.schedule.angle_group(side),
    ];
    let unknowns = groups.map(|group| group.is_some());
    let turner = side.turner(context.scene);
    let (owner, exists) = match order {
        Order::Position => (side.name.as_str(), context.has_positions()),
        _ => (turner, context.has_rates()),
    };
    let symbols = [
        symbols::length(&side.name, order),
        symbols::angle(owner, order),
    ];
    let values = [reading.length(order), reading.angle(order)];
    let f = context.figures;
    let is_direction = [false, order == Order::Position];
    let [length, angle] = symbols;
    let columns = columns(side, turner, order);
    let figure = |k: usize, symbol: Symbol| {
        let value = match (is_direction[k], unknowns[k]) {
            (true, _) => f.direction(values[k]),
            (false, true) => f.number(values[k]),
            (false, false) => f.given(values[k]),
        };
        VectorFigure {
            symbol,
            column: columns[k].clone(),
            value: (exists || !unknowns[k]).then_some(value),
            is_sought: unknowns[k],
            found_by: found_by(context, of, groups[k]),
        }
    };
    [figure(0, length), figure(1, angle)]
}
