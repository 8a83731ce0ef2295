//! Represents dimensions and units of values.

use std::fmt::Write as _;

/// The unit of a value, as powers of a few base units. Forces keep their newton and moments their
/// metre independently of the length unit, so that no unnecessary conversion takes place.
///
/// Radians count as numbers next to lengths, forces or masses: `omega * r` is in mm/s. Degrees
/// occur alone, because products use radians.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dimension {
    pub(super) newton: i8,
    pub(super) kilogram: i8,
    pub(super) metre: i8,
    /// The power of the length unit.
    pub(super) length: i8,
    pub(super) second: i8,
    pub(super) radian: i8,
    /// Whether a plain angle is in degrees.
    pub(super) degrees: bool,
}

/// The length unit of a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthScale {
    /// The unit's symbol.
    pub(crate) symbol: &'static str,
    /// The size of the unit in tenths of a millimetre, an integer.
    pub(crate) tenths_of_mm: f64,
}

/// Tenths of a millimetre in a metre.
pub(super) const METRE: f64 = 10_000.0;

/// Maximum power of a unit; no quantity of a linkage exceeds it.
pub(super) const MAX_POWER: i8 = 24;

impl Dimension {
    pub const NUMBER: Dimension = Dimension {
        newton: 0,
        kilogram: 0,
        metre: 0,
        length: 0,
        second: 0,
        radian: 0,
        degrees: false,
    };
    pub const DEGREES: Dimension = Dimension {
        degrees: true,
        ..Dimension::RADIANS
    };
    pub(crate) const RADIANS: Dimension = Dimension {
        radian: 1,
        ..Dimension::NUMBER
    };
    pub const LENGTH: Dimension = Dimension {
        length: 1,
        ..Dimension::NUMBER
    };
    pub(crate) const FORCE: Dimension = Dimension {
        newton: 1,
        ..Dimension::NUMBER
    };
    /// N m.
    pub(crate) const MOMENT: Dimension = Dimension {
        metre: 1,
        ..Dimension::FORCE
    };
    /// m/s^2.
    pub(crate) const FREE_FALL: Dimension = Dimension {
        metre: 1,
        second: -2,
        ..Dimension::NUMBER
    };
    /// kg m^2.
    pub(crate) const INERTIA: Dimension = Dimension {
        metre: 2,
        ..Dimension::KILOGRAM
    };
    /// N/m.
    pub(crate) const STIFFNESS: Dimension = Dimension {
        metre: -1,
        ..Dimension::FORCE
    };
    /// N s/m.
    pub(crate) const DAMPING: Dimension = Dimension {
        second: 1,
        ..Dimension::STIFFNESS
    };
    /// N m/rad.
    pub(crate) const TURN_STIFFNESS: Dimension = Dimension {
        radian: -1,
        ..Dimension::MOMENT
    };
    /// N m s/rad.
    pub(crate) const TURN_DAMPING: Dimension = Dimension {
        second: 1,
        ..Dimension::TURN_STIFFNESS
    };
    pub(crate) const SECOND: Dimension = Dimension {
        second: 1,
        ..Dimension::NUMBER
    };
    pub(crate) const KILOGRAM: Dimension = Dimension {
        kilogram: 1,
        ..Dimension::NUMBER
    };

    /// Returns the dimension of the time derivative; that of degrees is rad/s, as everywhere in
    /// krank.
    pub(crate) fn rate(self) -> Dimension {
        let second = self.second.saturating_sub(1);
        Dimension {
            second,
            degrees: false,
            ..self
        }
    }

    /// Returns the dimension with every length in metres.
    pub(super) fn in_metres(self) -> Dimension {
        Dimension {
            metre: self.metre + self.length,
            length: 0,
            ..self
        }
    }

    fn powers(self) -> [i8; 6] {
        [
            self.newton,
            self.kilogram,
            self.metre,
            self.length,
            self.second,
            self.radian,
        ]
    }

    /// Combines the powers of two dimensions; `None` if one exceeds the maximum.
    fn joined(self, other: Dimension, join: impl Fn(i8, i8) -> Option<i8>) -> Option<Dimension> {
        let mut powers = self.powers();
        for (power, other) in powers.iter_mut().zip(other.powers()) {
            *power = join(*power, other).filter(|p| p.abs() <= MAX_POWER)?;
        }
        let [newton, kilogram, metre, length, second, radian] = powers;
        let is_angular = [newton, kilogram, metre, length] == [0; 4];
        Some(Dimension {
            newton,
            kilogram,
            metre,
            length,
            second,
            radian: if is_angular { radian } else { 0 },
            degrees: false,
        })
    }

    pub(super) fn times(self, other: Dimension) -> Option<Dimension> {
        self.joined(other, i8::checked_add)
    }

    pub(super) fn over(self, other: Dimension) -> Option<Dimension> {
        self.joined(other, i8::checked_sub)
    }

    pub(super) fn power(self, exponent: i8) -> Option<Dimension> {
        self.joined(self, |power, _| power.checked_mul(exponent))
    }

    /// Returns the dimension of the square root; `None` if a power is odd.
    pub(super) fn root(self) -> Option<Dimension> {
        self.joined(self, |power, _| (power % 2 == 0).then_some(power / 2))
    }

    pub(super) fn is_number(self) -> bool {
        self == Dimension::NUMBER
    }

    /// Returns `true` for a plain angle, in degrees or radians.
    pub(super) fn is_angle(self) -> bool {
        self == Dimension::DEGREES || self == Dimension::RADIANS
    }

    /// Returns `true` if values of both can be added: they have the same physical dimension.
    /// Radians are ignored in values that involve time or force.
    pub fn adds_to(self, other: Dimension) -> bool {
        let physical = |d: Dimension| {
            [
                d.newton + d.metre + d.length,
                d.newton + d.kilogram,
                d.second - 2 * d.newton,
            ]
        };
        let is_soft = self.second != 0 || self.newton != 0;
        physical(self) == physical(other) && (is_soft || self.radian == other.radian)
    }

    /// Returns the power of the length unit in metres that converts a value of the other dimension
    /// to this one.
    pub(super) fn lengths_beyond(self, other: Dimension) -> i8 {
        other.length - self.length
    }

    /// Returns the unit as in columns; `1` for a plain number.
    pub fn symbol(self, length: &str) -> String {
        let is_power = Dimension {
            second: -1,
            ..Dimension::MOMENT
        };
        match self == is_power {
            true => "W".into(),
            false => self.written(length),
        }
    }

    /// Returns the unit as in a formula, following a number.
    pub(crate) fn written(self, length: &str) -> String {
        if self.degrees {
            return "deg".into();
        }
        let names = ["N", "kg", "m", length, "s", "rad"];
        let order = [0, 1, 2, 3, 5, 4];
        let powers = order.map(|i| (names[i], self.powers()[i]));
        let written = |(name, power): (&str, i8)| match power.abs() {
            1 => name.to_owned(),
            power => format!("{name}^{power}"),
        };
        let above = powers.into_iter().filter(|(_, power)| *power > 0);
        let above: Vec<String> = above.map(written).collect();
        let mut text = match above.is_empty() {
            true => "1".to_owned(),
            false => above.join(" "),
        };
        for below in powers.into_iter().filter(|(_, power)| *power < 0) {
            let _ = write!(text, "/{}", written(below));
        }
        text
    }
}
