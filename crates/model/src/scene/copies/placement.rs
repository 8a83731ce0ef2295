//! The placement of a copy: a mirror image, a rotation and a shift.

use crate::arithmetic::Decimal;
use crate::scene::elements::drawn::typed;
use crate::{Double, Number, Vec2};

/// A computed coordinate below this fraction of its terms is a rounding error.
const ROUNDING: f64 = 1e-28;
/// A point that moves by less than this fraction of its coordinates stays where it is.
const AT_REST: f64 = 1e-20;

/// A rigid placement: the mirror image at the x axis, if any, then a rotation about the origin, and
/// then a shift.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    pub(super) is_mirrored: bool,
    /// The rotation in degrees.
    turn: Double,
    shift: Vec2<Double>,
}

impl Placement {
    /// The placement of the original.
    pub(super) const IDENTITY: Placement = Placement {
        is_mirrored: false,
        turn: Double::ZERO,
        shift: Vec2::new(Double::ZERO, Double::ZERO),
    };

    /// Creates the placement that mirrors and turns about `centre`, and then moves by `shift`.
    pub(super) fn new(is_mirrored: bool, turn: Double, centre: Vec2, shift: Vec2) -> Placement {
        let about_origin = Placement {
            is_mirrored,
            turn,
            ..Placement::IDENTITY
        };
        let centre = typed(centre);
        Placement {
            shift: centre + typed(shift) - about_origin.turned(centre),
            ..about_origin
        }
    }

    /// Returns the placement that applies this one and then `next`.
    pub(super) fn then(self, next: Placement) -> Placement {
        Placement {
            is_mirrored: self.is_mirrored != next.is_mirrored,
            turn: next.direction(self.turn),
            shift: next.turned(self.shift) + next.shift,
        }
    }

    /// Mirrors and turns a vector about the origin.
    fn turned(&self, vector: Vec2<Double>) -> Vec2<Double> {
        let mirrored = match self.is_mirrored {
            true => vector.conj(),
            false => vector,
        };
        mirrored.turned(Number::unit(self.turn))
    }

    /// Returns a position in the frame of a copied link: mirrored if the copy is.
    pub(super) fn reflected(&self, local: Vec2) -> Vec2 {
        match self.is_mirrored {
            // Zero keeps its sign.
            true => Vec2::new(local.x, 0.0 - local.y),
            false => local,
        }
    }

    /// Returns an angle in the frame of a copied link, in degrees.
    pub(super) fn local_angle(&self, angle: f64) -> f64 {
        match self.is_mirrored {
            true => 0.0 - angle,
            false => angle,
        }
    }

    /// Returns the position of a copied point.
    pub(super) fn position(&self, of: Vec2) -> Vec2<Double> {
        let turned = self.turned(typed(of));
        let place = turned + self.shift;
        let size = largest(turned).max(largest(self.shift));
        place.map(|v| match v.abs().hi <= ROUNDING * size {
            true => Double::ZERO,
            false => v,
        })
    }

    /// Returns a copied direction in degrees.
    pub(super) fn direction(&self, of: Double) -> Double {
        match self.is_mirrored {
            true => self.turn - of,
            false => self.turn + of,
        }
    }

    /// Returns `true` if a point stays where it is.
    pub(super) fn keeps(&self, point: Vec2) -> bool {
        let away = self.position(point) - typed(point);
        largest(away) <= AT_REST * largest(typed(point)).max(largest(self.shift))
    }

    /// Returns the number of the first of `count` copies that lies on the original: the placement is
    /// applied once for each copy, and the phase, in degrees, is added.
    pub(super) fn first_in_place(self, phase: f64, count: usize) -> Option<usize> {
        let mut placement = Placement::IDENTITY;
        let mut size = 0.0_f64;
        (1..=count).find(|&number| {
            placement = placement.then(self);
            size = size.max(largest(placement.shift));
            let turns = [placement.turn, times(phase, number)];
            !placement.is_mirrored
                && turns.map(Number::wrapped) == [Double::ZERO; 2]
                && largest(placement.shift) <= AT_REST * size
        })
    }
}

fn largest(vector: Vec2<Double>) -> f64 {
    vector.x.abs().hi.max(vector.y.abs().hi)
}

/// Returns the typed decimal of an angle, times the number of the copy.
pub(super) fn times(angle: f64, number: usize) -> Double {
    #[expect(clippy::cast_precision_loss, reason = "at most a thousand")]
    let number = number as f64;
    Decimal::of(angle).value * Double::exactly(number)
}

/// Returns the equivalent angle of less than a turn, rounded to a double; keeps the sign.
pub(super) fn within_a_turn(angle: Double) -> Double {
    let turns = (angle.hi / crate::angle::TURN).trunc();
    angle - Double::exactly(turns * crate::angle::TURN)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(placement: Placement, x: f64, y: f64) -> Vec2 {
        placement.position(Vec2::new(x, y)).nearest()
    }

    /// A quarter turn about (10, 0) takes (12, 0) to (10, 2); twice to (8, 0), three times to
    /// (10, -2).
    #[test]
    fn placements_follow_each_other() {
        let quarter = Double::exactly(90.0);
        let one = Placement::new(false, quarter, Vec2::new(10.0, 0.0), Vec2::ZERO);
        let two = one.then(one);
        assert_eq!(at(one, 12.0, 0.0), Vec2::new(10.0, 2.0));
        assert_eq!(at(two, 12.0, 0.0), Vec2::new(8.0, 0.0));
        assert_eq!(at(two.then(one), 12.0, 0.0), Vec2::new(10.0, -2.0));
        assert!(two.keeps(Vec2::new(10.0, 0.0)));
        assert!(!two.keeps(Vec2::new(10.0, 1e-9)));
        assert_eq!(one.first_in_place(0.0, 9), Some(4));
        assert_eq!(one.first_in_place(0.0, 3), None);
        assert_eq!(one.first_in_place(120.0, 20), Some(12));
    }

    /// The mirror image at the x axis, turned by 180 degrees, is the one at the y axis. A mirror
    /// image of a mirror image is the original, whatever the rotation.
    #[test]
    fn mirror_images_are_turned_after_mirroring() {
        let half = Double::exactly(180.0);
        let upright = Placement::new(true, half, Vec2::ZERO, Vec2::new(0.0, 5.0));
        assert_eq!(at(upright, 3.0, 4.0), Vec2::new(-3.0, 9.0));
        assert_eq!(upright.direction(Double::exactly(30.0)).hi, 150.0);
        let tilted = Placement::new(true, Double::exactly(70.0), Vec2::ZERO, Vec2::ZERO);
        assert_eq!(tilted.first_in_place(0.0, 2), Some(2));
        assert_eq!(Placement::IDENTITY.first_in_place(-360.0, 1), Some(1));
    }

    #[test]
    fn angles_stay_below_a_turn() {
        for (angle, within) in [(378.0, 18.0), (-370.0, -10.0), (360.0, 0.0), (306.0, 306.0)] {
            assert_eq!(within_a_turn(Double::exactly(angle)).hi, within);
        }
    }
}
