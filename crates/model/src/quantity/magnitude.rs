//! Computes magnitudes and directions of vectors: `C.v`, `C.v.angle`, `C.a.t`, `r3.B.f`.

use super::derived::{Derived, Leaf, number};
use super::{Aspect, Quantity, QuantitySource};
use crate::expression::{Code, Dimension, Kind, Op, Part, Revolution};
use std::sync::Arc;

/// A quantity computed from the components of a vector.
struct Magnitude {
    /// The last part of the column name, following that of the subject.
    name: &'static str,
    of: &'static [Aspect],
    ops: &'static [Op],
    is_direction: bool,
}

use Aspect::{Ax, Ay, Fx, Fy, Vx, Vy};
use Op::{Abs, Add, Atan2, Divide, Hypot, Multiply, Subtract};

const X: Op = Op::Leaf(0);
const Y: Op = Op::Leaf(1);
const SIZE: &[Op] = &[X, Y, Hypot];
const DIRECTION: &[Op] = &[Y, X, Atan2];
const RATE_X: Op = Op::Leaf(2);
const RATE_Y: Op = Op::Leaf(3);
const RATE_SIZE: &[Op] = &[RATE_X, RATE_Y, Hypot];
const RATE_DIRECTION: &[Op] = &[RATE_Y, RATE_X, Atan2];
/// The rate of the magnitude: v.a / |v|, positive for increasing speed.
const ALONG: &[Op] = &[
    X, RATE_X, Multiply, Y, RATE_Y, Multiply, Add, X, Y, Hypot, Divide,
];
/// |v x a| / |v|.
const ACROSS: &[Op] = &[
    X, RATE_Y, Multiply, Y, RATE_X, Multiply, Subtract, Abs, X, Y, Hypot, Divide,
];

/// The components of a point's motion, in the order of the catalogue.
const MOTION: &[Aspect] = &[Vx, Vy, Ax, Ay];
const VELOCITY: &[Aspect] = &[Vx, Vy];
const FORCE: &[Aspect] = &[Fx, Fy];

const ALL: [Magnitude; 8] = [
    magnitude("v", VELOCITY, SIZE, false),
    magnitude("v.angle", VELOCITY, DIRECTION, true),
    magnitude("a", MOTION, RATE_SIZE, false),
    magnitude("a.angle", MOTION, RATE_DIRECTION, true),
    magnitude("a.t", MOTION, ALONG, false),
    magnitude("a.n", MOTION, ACROSS, false),
    magnitude("f", FORCE, SIZE, false),
    magnitude("f.angle", FORCE, DIRECTION, true),
];

const fn magnitude(
    name: &'static str,
    of: &'static [Aspect],
    ops: &'static [Op],
    is_direction: bool,
) -> Magnitude {
    Magnitude {
        name,
        of,
        ops,
        is_direction,
    }
}

impl Magnitude {
    /// Creates the quantity from the components at the beginning of the list, if they are there.
    fn at(&self, quantities: &[Quantity]) -> Option<Quantity> {
        let first = quantities.first()?;
        let QuantitySource::Solved(subject, first_aspect) = first.source else {
            return None;
        };
        let base = first.name.strip_suffix(first_aspect.name())?;
        let components = quantities.get(..self.of.len())?;
        let fits = |(quantity, aspect): (&Quantity, &Aspect)| {
            quantity.source == QuantitySource::Solved(subject, *aspect)
        };
        if !components.iter().zip(self.of).all(fits) {
            return None;
        }
        let mut leaves: Vec<Leaf> = Vec::new();
        for (quantity, &aspect) in components.iter().zip(self.of) {
            let name = quantity.name.clone();
            number(
                &mut leaves,
                &Leaf {
                    subject,
                    aspect,
                    name,
                },
            );
        }
        let last = components.last()?;
        let (unit, kind) = match self.is_direction {
            true => (
                Dimension::DEGREES.symbol(""),
                Kind::direction(Revolution::Wrapped),
            ),
            false => (last.unit.clone(), Kind::plain(self.of.last()?.dimension())),
        };
        let code = Code::new(self.ops.to_vec()).ok()?;
        let derived = Derived::new(leaves, code, kind).ok()?;
        Some(Quantity {
            name: format!("{base}{}", self.name),
            unit,
            source: QuantitySource::Derived(Arc::new(derived)),
        })
    }
}

/// Returns all quantities whose components are consecutive in the list.
pub(super) fn all(quantities: &[Quantity]) -> impl Iterator<Item = Quantity> {
    (0..quantities.len())
        .flat_map(move |from| ALL.iter().filter_map(move |m| m.at(&quantities[from..])))
}

/// Returns the quantity with this name.
pub(super) fn find(quantities: &[Quantity], name: &str) -> Option<Quantity> {
    ALL.iter().find_map(|magnitude| {
        let base = name.strip_suffix(magnitude.name)?;
        let first = format!("{base}{}", magnitude.of.first()?.name());
        let from = quantities
            .iter()
            .position(|quantity| quantity.name == first)?;
        magnitude.at(&quantities[from..])
    })
}

/// Returns the steps of a quantity as a part of a formula.
pub(super) fn part(quantity: &Quantity, leaves: &mut Vec<Leaf>) -> Part {
    match &quantity.source {
        QuantitySource::Derived(derived) => derived.part(leaves),
        QuantitySource::Solved(subject, aspect) => {
            let leaf = Leaf {
                subject: *subject,
                aspect: *aspect,
                name: quantity.name.clone(),
            };
            Part {
                ops: vec![Op::Leaf(number(leaves, &leaf))],
                kind: aspect.kind(*subject),
            }
        }
    }
}
