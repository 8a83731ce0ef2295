//! Defines the solver's own frame: a ground pivot as origin, lengths scaled by a power of two.
//!
//! Coordinates far from the scene's origin cost no digits, and products of four lengths neither
//! overflow nor underflow. A scene scaled by a power of two gives the same bits, because the
//! scaling itself is exact.

use crate::{Body, Constant, Input, Mechanism, Member, Number, Vec2};

/// The conversion from the scene's frame and unit to the solver's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    /// The origin as given. Its accuracy is determined once here, not again for every place read.
    origin: Vec2<Constant>,
    /// The solver's unit in the scene's length unit: a power of two.
    pub(super) scale: f64,
    /// The largest given coordinate on the ground, in the solver's unit. Lengths far from the
    /// origin are no more accurate than the rounding of this number.
    pub(super) far: f64,
    /// The longest length in the solver's unit: in [1, 2), or 0 if there is none.
    pub(super) longest: f64,
    reading: NumberReading,
}

/// How the numbers of a mechanism are interpreted.
#[derive(Clone, Copy, Debug, PartialEq)]
enum NumberReading {
    /// Numbers are doubles, known to half an ulp of the intended value. The difference of two
    /// places on the ground is rounded from the decimals, if they are decimals.
    Given { decimals: bool },
    /// Numbers are the typed decimals, see [`Constant::intended`].
    Meant { decimals: bool },
}

impl Frame {
    /// Creates the frame in which the mechanism's longest length lies in [1, 2).
    pub(super) fn of(mechanism: &Mechanism) -> Frame {
        let origin = origin(mechanism);
        let mut longest = 0.0_f64;
        for link in mechanism.links() {
            let Some(first) = link.members.first() else {
                continue;
            };
            for member in &link.members {
                longest = longest.max((member.local - first.local).norm());
            }
        }
        for point in mechanism.points() {
            if let Some(ground) = point.ground {
                longest = longest.max((ground - origin).norm());
            }
        }
        for slide in mechanism.slides() {
            let from = if slide.on == Body::Ground {
                origin
            } else {
                Vec2::ZERO
            };
            longest = longest.max((slide.through - from).norm());
        }
        let scale = power_of_two_below(longest);
        Frame {
            origin: if mechanism.is_typed() {
                Constant::intended_position(origin, true)
            } else {
                origin.map(Constant::given)
            },
            scale,
            far: max_coordinate(mechanism) / scale,
            longest: longest / scale,
            reading: NumberReading::Given {
                decimals: mechanism.has_decimals(),
            },
        }
    }

    /// Returns the same frame for the typed decimals.
    pub(super) fn with_typed_decimals(self, mechanism: &Mechanism) -> Frame {
        let decimals = mechanism.has_decimals();
        Frame {
            reading: NumberReading::Meant { decimals },
            ..self
        }
    }

    /// Returns the maximum rounding of the difference of two places on the ground or on a link: see
    /// [`Constant::compared`]. Places on a link's x or y axis are lengths, which are either equal
    /// or not.
    pub(super) fn rounding(&self, mechanism: &Mechanism) -> f64 {
        let decimals = mechanism.has_decimals();
        let radius = |position: Vec2<Constant>| position.map(|v| v.radius / self.scale);
        let is_long = |position| radius(Constant::compared(position, decimals)) != Vec2::ZERO;
        let has_long = grounded(mechanism).any(is_long);
        let off = |position: Vec2| {
            radius(if has_long {
                Constant::compared_among_long(position, decimals)
            } else {
                Constant::compared(position, decimals)
            })
        };
        let sizes =
            grounded(mechanism).map(|position| (off(position) + off(self.origin.nearest())).norm());
        let is_turned = |position: Vec2| position.x != 0.0 && position.y != 0.0;
        let members = mechanism.links().iter().flat_map(|link| &link.members);
        let members = members.filter(|member| is_turned(member.local));
        let members = members.map(|member| member.rounding(decimals) / self.scale);
        sizes.chain(members).fold(0.0, f64::max)
    }

    /// Returns the maximum rounding of any number on a link, or of a guide.
    pub(super) fn typed_rounding(&self, mechanism: &Mechanism) -> f64 {
        let decimals = mechanism.has_decimals();
        let off = |position: Vec2| Constant::compared(position, decimals).map(|v| v.radius);
        let members = mechanism.links().iter().flat_map(|link| &link.members);
        let members = members.map(|member| member.rounding(decimals));
        let guides = mechanism.slides().iter().filter_map(|slide| {
            // A guide through a point given by length and angle is as accurate as that point.
            let named = mechanism.polar_through(slide);
            named.is_none().then(|| off(slide.through).norm())
        });
        let lengths = members.chain(guides).map(|length| length / self.scale);
        let angles = mechanism.slides().iter().map(|slide| {
            let angle = off(Vec2::new(slide.angle, 0.0)).x;
            self.longest * angle.to_radians()
        });
        lengths.chain(angles).fold(0.0, f64::max)
    }

    /// Interprets a place of the scene.
    fn read(&self, position: Vec2) -> Vec2<Constant> {
        match self.reading {
            NumberReading::Given { .. } => position.map(Constant::given),
            NumberReading::Meant { decimals } => Constant::intended_position(position, decimals),
        }
    }

    /// Interprets a number of the scene that is not a place.
    pub(super) fn number(&self, value: f64) -> Constant {
        self.read(Vec2::new(value, 0.0)).x
    }

    /// Returns the size of the solver's unit of an input's coordinate: a power of two, 1 for
    /// degrees.
    pub(super) fn unit_of(&self, input: Input) -> f64 {
        match input {
            Input::Turn(_) => 1.0,
            Input::Push(_) => self.scale,
        }
    }

    /// Returns the solver's origin in the scene's frame.
    pub(super) fn origin(&self) -> Vec2<Constant> {
        self.origin
    }

    /// Returns the unit vector at an angle in degrees.
    pub(super) fn unit(&self, degrees: f64) -> Vec2<Constant> {
        match self.reading {
            NumberReading::Given { .. } => Constant::given_unit(degrees),
            NumberReading::Meant { decimals } => Constant::intended_unit_vector(degrees, decimals),
        }
    }

    /// Converts a length of the scene to the solver's unit; exact.
    pub(super) fn length(&self, length: f64) -> f64 {
        length / self.scale
    }

    /// Converts a vector in a link's frame to the solver's unit; exact.
    pub(super) fn local(&self, local: Vec2) -> Vec2<Constant> {
        match self.reading {
            // Scaled first: half an ulp of the smallest doubles is not representable.
            NumberReading::Given { .. } => local.map(|v| Constant::given_in(v, self.scale)),
            NumberReading::Meant { .. } => self.read(local).map(|v| self.inwards(v)),
        }
    }

    /// Returns a point of a link in the link's frame, in the solver's unit; exact.
    pub(super) fn member(&self, member: &Member) -> Vec2<Constant> {
        if member.polar.is_none() {
            return self.local(member.local);
        }
        let position = match self.reading {
            NumberReading::Given { .. } => member.given(),
            NumberReading::Meant { decimals } => member.intended_coordinates(decimals),
        };
        position.map(|v| self.inwards(v))
    }

    /// Converts a place of the scene to the solver's frame; exact.
    pub(super) fn inner(&self, position: Vec2) -> Vec2<Constant> {
        let origin = self.origin.nearest();
        let read = self.read(position) - self.read(origin);
        let away = match self.reading {
            NumberReading::Given { decimals: true } => {
                let intended = Constant::intended_position(position, true)
                    - Constant::intended_position(origin, true);
                // The typed value is as near to a double as the decimal is.
                let off = |intended: Constant, read: Constant| intended.widened(2.0 * read.radius);
                Vec2::new(off(intended.x, read.x), off(intended.y, read.y))
            }
            NumberReading::Given { decimals: false } | NumberReading::Meant { .. } => read,
        };
        away.map(|v| self.inwards(v))
    }

    /// Converts a length to the solver's unit; exact.
    fn inwards(&self, length: Constant) -> Constant {
        let inwards = |v: f64| v / self.scale;
        Constant {
            hi: inwards(length.hi),
            lo: inwards(length.lo),
            radius: inwards(length.radius),
            slope: inwards(length.slope),
        }
    }

    /// Converts a place in the solver's frame to the scene's frame.
    #[inline]
    pub(super) fn place<T: Number>(&self, inner: Vec2<T>) -> Vec2<T> {
        inner.scaled(self.scale).plus(self.origin)
    }
}

/// Returns the largest absolute coordinate of a place on the ground.
fn max_coordinate(mechanism: &Mechanism) -> f64 {
    let sizes = grounded(mechanism).map(|p| p.x.abs().max(p.y.abs()));
    sizes.fold(0.0, f64::max)
}

/// Returns the given places on the ground, of points and of guides.
fn grounded(mechanism: &Mechanism) -> impl Iterator<Item = Vec2> {
    let points = mechanism.points().iter().filter_map(|p| p.ground);
    let slides = mechanism.slides().iter();
    let guides = slides.filter(|s| s.on == Body::Ground).map(|s| s.through);
    points.chain(guides)
}

/// Returns the driven link's pivot, or else the first ground point.
fn origin(mechanism: &Mechanism) -> Vec2 {
    let ground = |id: crate::PointId| mechanism.point(id).ground;
    let pivot = match mechanism.driver().input {
        Input::Turn(link) => {
            let members = &mechanism.link(link).members;
            members.iter().find_map(|m| ground(m.point))
        }
        Input::Push(_) => None,
    };
    let first = || mechanism.points().iter().find_map(|p| p.ground);
    pivot.or_else(first).unwrap_or(Vec2::ZERO)
}

/// Returns the largest power of two not above `length`; 1 if the length is zero or not finite.
fn power_of_two_below(length: f64) -> f64 {
    if !(length.is_finite() && length > 0.0) {
        return 1.0;
    }
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    let bits = length.to_bits();
    if length.is_normal() {
        f64::from_bits(bits & EXPONENT)
    } else {
        f64::from_bits(1 << bits.ilog2())
    }
}

#[cfg(test)]
mod tests {
    use super::power_of_two_below;

    #[test]
    fn scale_is_largest_power_of_two_up_to_length() {
        for (length, expected) in [
            (400.0, 256.0),
            (1.0, 1.0),
            (0.7, 0.5),
            (2.0, 2.0),
            (0.0, 1.0),
            (11.0 * 5e-324, 8.0 * 5e-324),
        ] {
            assert_eq!(power_of_two_below(length), expected);
        }
        let huge = power_of_two_below(4e152);
        assert!((1.0..2.0).contains(&(4e152 / huge)));
    }
}
