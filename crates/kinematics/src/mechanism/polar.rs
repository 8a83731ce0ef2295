//! Computes the coordinates of points given by a length and an angle, as drawings dimension them.
//!
//! The typed values define the point. The coordinates follow from them in double-double, with an
//! error bound that follows from the precision of the length and the angle.

use super::{Link, Member, PointId};
use crate::{Constant, Vec2};

/// The place of a point in a link, in polar form relative to another point of the link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolarPosition {
    /// The reference point; `None` is the origin of the link's frame.
    pub from: Option<PointId>,
    /// The index of the reference point among the link's members; `None` if no earlier member is
    /// that point.
    base: Option<usize>,
    /// The distance from the reference point, in the scene's length unit.
    pub length: f64,
    /// The direction in degrees from the link's x axis, counter-clockwise.
    pub angle: f64,
    /// The resulting coordinates: from the stored doubles (`given`) and from the numbers as meant
    /// (`meant`).
    pub(super) given: Vec2<Constant>,
    pub(super) intended: Vec2<Constant>,
    /// A bound on the rounding of its long numbers, as a distance.
    pub(super) rounding: f64,
}

impl PolarPosition {
    /// Creates the place of a further point of a link that has these members. The coordinates are
    /// computed later.
    pub(super) fn new(
        from: Option<PointId>,
        length: f64,
        angle: f64,
        members: &[Member],
    ) -> PolarPosition {
        let base = from.and_then(|from| members.iter().position(|m| m.point == from));
        PolarPosition {
            from,
            base,
            length,
            angle,
            given: Vec2::default(),
            intended: Vec2::default(),
            rounding: 0.0,
        }
    }

    /// Computes the coordinates, given the reference member with its own coordinates known.
    fn compute_polar_points(&mut self, base: Option<&Member>, is_decimal: bool) {
        let origin = Vec2::ZERO.map(Constant::given);
        let given = base.map_or(origin, Member::given);
        let intended = base.map_or(origin, |base| base.intended_coordinates(is_decimal));
        self.given = polar_position(given, self.length, self.angle);
        self.intended = intended + Constant::intended_arm(self.length, self.angle, is_decimal);
        let off = |v: f64| Constant::compared(Vec2::new(v, 0.0), is_decimal).x.radius;
        let before = base.map_or(0.0, |base| base.rounding(is_decimal));
        self.rounding = before + off(self.length) + self.length * off(self.angle).to_radians();
    }
}

/// Returns the position at a length and an angle in degrees from `base`, each number with its error
/// bound as given.
pub fn polar_position(base: Vec2<Constant>, length: f64, angle: f64) -> Vec2<Constant> {
    base + Constant::given_arm(length, angle)
}

impl Member {
    /// Returns the coordinates from the stored doubles, with a bound on how far the meant numbers
    /// can be from them.
    pub(crate) fn given(&self) -> Vec2<Constant> {
        self.polar
            .map_or_else(|| self.local.map(Constant::given), |polar| polar.given)
    }

    /// Returns the coordinates as meant.
    pub(crate) fn intended_coordinates(&self, is_decimal: bool) -> Vec2<Constant> {
        let typed = || Constant::intended_position(self.local, is_decimal);
        self.polar.map_or_else(typed, |polar| polar.intended)
    }

    /// Returns a bound on the rounding of the long numbers that define the place, as a distance.
    pub(crate) fn rounding(&self, is_decimal: bool) -> f64 {
        let typed = || {
            let position = Constant::compared(self.local, is_decimal);
            position.map(|v| v.radius).norm()
        };
        self.polar.map_or_else(typed, |polar| polar.rounding)
    }
}

impl Link {
    /// Computes the coordinates of every polar point; reference points precede the points measured
    /// from them. Returns the polar points with their displacements.
    pub(super) fn compute_polar_points(&mut self, is_decimal: bool) -> Vec<(PointId, Vec2)> {
        let mut moved = Vec::new();
        for i in 0..self.members.len() {
            let (before, rest) = self.members.split_at_mut(i);
            let Some(member) = rest.first_mut() else {
                continue;
            };
            let Some(polar) = &mut member.polar else {
                continue;
            };
            let base = polar.base.and_then(|base| before.get(base));
            if polar.from.is_some() && base.is_none() {
                // A missing reference point gives NaN, which the builder rejects.
                member.local = Vec2::new(f64::NAN, f64::NAN);
                continue;
            }
            polar.compute_polar_points(base, is_decimal);
            let position = polar.given.map(|v| v.hi);
            moved.push((member.point, position - member.local));
            member.local = position;
        }
        moved
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Double;

    /// Returns a polar point whose reference point is the end of its link.
    fn polar(length: f64, angle: f64) -> Member {
        let mut link = Link {
            members: Vec::new(),
            ends: None,
            com: None,
            mass: 0.0,
            inertia: 0.0,
        };
        let [end, point] = [0, 1].map(PointId::new);
        link.members.push(Member {
            point: end,
            local: Vec2::new(300.0, 0.0),
            polar: None,
        });
        link.members.push(Member {
            point,
            local: Vec2::ZERO,
            polar: Some(PolarPosition::new(Some(end), length, angle, &link.members)),
        });
        let moved = link.compute_polar_points(true);
        assert_eq!(moved.len(), 1);
        link.members[1]
    }

    /// Exactly representable values have no error; half an ulp of 90.1 deg at the end of 180 mm is
    /// 2.2e-14 mm.
    #[test]
    fn position_error_follows_from_length_and_angle() {
        let exact = polar(180.0, 90.0);
        assert_eq!(exact.local, Vec2::new(300.0, 180.0));
        assert_eq!(exact.given().map(Constant::off).x, 1e-31 * 300.0);
        let turned = polar(180.0, 90.1).given();
        assert!((2.2e-14..2.3e-14).contains(&turned.x.radius), "{turned:?}");
        assert!(turned.y.radius < 1e-16, "{turned:?}");
        let long = polar(180.1, 90.0).given();
        assert!(long.x.radius < 1e-27, "{long:?}");
        assert!((1.4e-14..1.5e-14).contains(&long.y.radius), "{long:?}");
    }

    /// The stored value differs from the typed one, and the difference is within its bound.
    #[test]
    fn typed_position_is_within_error_of_given_one() {
        for (length, angle) in [(180.1, 72.3), (0.7, -40.1), (12.3, 33.0), (1e-3, 359.9)] {
            let seen = polar(length, angle);
            let (given, intended) = (seen.given(), seen.intended_coordinates(true));
            for (given, intended) in [(given.x, intended.x), (given.y, intended.y)] {
                let distance = (given.value() - intended.value()).abs();
                assert!(
                    distance.hi <= given.radius,
                    "{length} {angle}: {distance:?}"
                );
                assert!(intended.radius < 1e-26, "{intended:?}");
            }
            assert!(seen.rounding(true) == 0.0, "few digits are no rounding");
        }
        assert!(polar(180.123_456_789_012_34, 72.0).rounding(true) > 0.0);
        let (x, y) = (
            polar(2.0, 45.0).intended_coordinates(true).x,
            Double::exactly(2.0).sqrt(),
        );
        assert!(((x.value() - Double::exactly(300.0)) - y).abs().hi < 1e-29);
    }
}
