//! Explains the motion of a point by the answers for other points of its link.

use super::comparison::{FigureVerdict, MAX_COUNT, MIN_COUNT, Truth};
use super::{AnswerKey, AnsweredVector, MAX_WRONG_ANSWERS, RequiredValue, WrittenFigure, blamed};
use crate::quantity::{Aspect, Quantity, Subject};
use crate::{PointId, Vec2};

/// The points of a link with their places on it.
pub type LinkPoints = Vec<(PointId, Vec2)>;

/// A part of a vector: the magnitude or the direction of a point's velocity or acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct VectorSlot {
    point: PointId,
    /// 1 for the velocity, 2 for the acceleration.
    order: usize,
    is_direction: bool,
}

/// The suffixes of names, with the order, and `true` for directions.
const ENDS: [(&str, usize, bool); 4] = [
    (".v", 1, false),
    (".v.angle", 1, true),
    (".a", 2, false),
    (".a.angle", 2, true),
];

impl VectorSlot {
    /// Returns the slot of a quantity; `None` if it is not the magnitude or direction of a point's
    /// velocity or acceleration.
    pub(super) fn of(quantity: &Quantity) -> Option<VectorSlot> {
        let Some(Subject::Point(point)) = quantity.subject() else {
            return None;
        };
        let mut ends = ENDS.iter();
        let found = ends.find(|(end, ..)| quantity.name.ends_with(end));
        found.map(|&(_, order, is_direction)| VectorSlot {
            point,
            order,
            is_direction,
        })
    }

    fn part_of(self, vector: Vec2) -> f64 {
        match self.is_direction {
            true => crate::angle::degrees(vector),
            false => vector.norm(),
        }
    }
}

/// An answer that replaces the exact value, changed by the number.
type UsedFace<'a> = (&'a AnsweredVector, f64);

impl AnswerKey {
    /// Explains a value by the answers for other points of the link: by the proportion of their
    /// distances, or by the link's rotation.
    pub(super) fn follows_from_points(
        &self,
        figure: &RequiredValue,
        written: WrittenFigure,
        faced: &[AnsweredVector],
    ) -> Option<FigureVerdict> {
        let slot = VectorSlot::of(&figure.quantity)?;
        let of_order = |face: &&AnsweredVector| face.slot.order == slot.order;
        let faced: Vec<&AnsweredVector> = faced.iter().filter(of_order).collect();
        let bodies = self.bodies.iter();
        let bodies = bodies.filter_map(|body| Some((body, place_on(body, slot.point)?)));
        for (body, position) in bodies {
            for (number, &(first, from)) in body.iter().enumerate() {
                let others = body[number + 1..].iter();
                for &(second, to) in others {
                    if [first, second].contains(&slot.point) || from == to {
                        continue;
                    }
                    let ratio = over(position - from, to - from);
                    let made = |[first, second]: [Vec2; 2]| first + times(ratio, second - first);
                    let of = [first, second];
                    let explained = self.explained_by((slot, of), figure, written, (&faced, &made));
                    if explained.is_some() {
                        return explained;
                    }
                }
                let Some(distance) = self.exact_difference(slot, first) else {
                    continue;
                };
                if first != slot.point {
                    let made = |[first, _]: [Vec2; 2]| first + distance;
                    let of = [first; 2];
                    let explained = self.explained_by((slot, of), figure, written, (&faced, &made));
                    if explained.is_some() {
                        return explained;
                    }
                }
            }
        }
        None
    }

    /// Returns the exact vector of a slot's point minus that of another point.
    fn exact_difference(&self, slot: VectorSlot, other: PointId) -> Option<Vec2> {
        let chain = self.chain.as_ref()?;
        let (x, y) = match slot.order {
            1 => (Aspect::Vx, Aspect::Vy),
            _ => (Aspect::Ax, Aspect::Ay),
        };
        let vector = |point| {
            let part = |aspect| chain.value(Subject::Point(point), aspect, &chain.exact);
            Some(Vec2::new(part(x)?, part(y)?))
        };
        Some(vector(slot.point)? - vector(other)?)
    }

    /// Explains a value by the vectors of two points; `None` if the written value is different.
    fn explained_by(
        &self,
        (slot, of): (VectorSlot, [PointId; 2]),
        figure: &RequiredValue,
        written: WrittenFigure,
        (faced, made): (&[&AnsweredVector], &dyn Fn([Vec2; 2]) -> Vec2),
    ) -> Option<FigureVerdict> {
        let used: Vec<UsedFace<'_>> = faced
            .iter()
            .filter(|face| of.contains(&face.slot.point))
            .map(|face| (*face, 0.0))
            .collect();
        let truth = Truth::of(figure);
        let with = |faces: &[UsedFace<'_>]| {
            let vectors = of.map(|point| self.vector(point, slot.order, faces));
            slot.part_of(made(vectors))
        };
        let followed = truth.with(with(&used));
        let distance = followed.difference_from(written.value).abs();
        if !(distance <= 0.5 * truth.difference_from(written.value).abs()) {
            return None;
        }
        let unit = written.unit_of(MIN_COUNT, MAX_COUNT);
        let carried = |number: usize| {
            let mut more = used.clone();
            more[number].1 = more[number].0.half;
            followed.difference_from(with(&more)).abs()
        };
        // With many wrong answers a close value may be a coincidence.
        let wrong = used.iter().filter(|(face, _)| !face.is_sound).count();
        let carried: f64 = match wrong <= MAX_WRONG_ANSWERS {
            true => (0..used.len()).map(carried).sum(),
            false => 0.0,
        };
        if !(distance <= unit + carried.min(followed.carried())) {
            return None;
        }
        let effect = |face: &AnsweredVector| truth.difference_from(with(&[(face, 0.0)])).abs();
        let effects = used.iter().map(|(face, _)| (effect(face), *face));
        let effects: Vec<(f64, &AnsweredVector)> = effects.collect();
        // A number that is written everywhere is not a consequence of earlier answers.
        let is_copied = |(face, _): &UsedFace<'_>| {
            !face.is_sound && face.number == written.value && !self.is_shared(face, figure, written)
        };
        blamed(&effects, unit, |_| used.iter().any(is_copied))
    }

    /// Returns `true` if both exact values are equal, and the answer has enough digits to show it.
    fn is_shared(
        &self,
        face: &AnsweredVector,
        figure: &RequiredValue,
        written: WrittenFigure,
    ) -> bool {
        let exact = self.figures.get(face.figure).map(|other| other.exact);
        let is_same = exact.is_some_and(|exact| Truth::of(figure).is_near(exact));
        is_same && written.digits >= MIN_COUNT
    }

    /// Returns the vector of a point from its answers, and from exact values for missing parts;
    /// zero if a part is not a graded value.
    fn vector(&self, point: PointId, order: usize, faces: &[UsedFace<'_>]) -> Vec2 {
        let part = |is_direction: bool| {
            let slot = VectorSlot {
                point,
                order,
                is_direction,
            };
            let face = faces.iter().find(|(face, _)| face.slot == slot);
            let mut figures = self.figures.iter();
            face.map(|(face, more)| face.value + more).or_else(|| {
                let exact = figures.find(|f| VectorSlot::of(&f.quantity) == Some(slot))?;
                Some(exact.exact)
            })
        };
        match (part(false), part(true)) {
            (Some(size), Some(direction)) => crate::angle::unit(direction) * size,
            _ => Vec2::ZERO,
        }
    }
}

fn place_on(body: &LinkPoints, point: PointId) -> Option<Vec2> {
    let mut points = body.iter();
    let found = points.find(|(own, _)| *own == point);
    found.map(|(_, position)| *position)
}

/// Returns the quotient of two vectors as complex numbers: the rotation and scaling from `other` to
/// `one`.
fn over(one: Vec2, other: Vec2) -> Vec2 {
    Vec2::new(other.dot(one), other.cross(one)) / other.dot(other)
}

/// Returns the product of two vectors as complex numbers.
fn times(ratio: Vec2, of: Vec2) -> Vec2 {
    of * ratio.x + of.perp() * ratio.y
}
