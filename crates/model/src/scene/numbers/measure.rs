//! The quantities that numbers of a scene measure, and the units in which they may be typed.

use crate::expression::Dimension;
use crate::scene::Unit;
use crate::scene::numbers::rate::{Degree, RateKind};

/// The quantity that a value measures, with its permitted range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// A distance, positive, in the scene's unit. A spring's length at zero force and a misfit may
    /// also be 0.
    Length,
    /// A coordinate or a slide's position, in the scene's unit.
    Coordinate,
    /// A rough coordinate of `[start]`, in the scene's unit; it chooses the assembly.
    Start,
    /// A tolerance or a clearance, in the scene's unit; not negative.
    Deviation,
    /// An angle in degrees, counter-clockwise.
    Angle,
    /// The speed of a turned driver, with its own unit.
    TurnSpeed,
    /// The acceleration of a turned driver, with its own unit.
    TurnAcceleration,
    /// The speed of a pushed driver, with its own unit.
    PushSpeed,
    /// The acceleration of a pushed driver, with its own unit.
    PushAcceleration,
    /// A mass in kg, not negative.
    Mass,
    /// A moment of inertia in kg m^2, not negative.
    Inertia,
    /// A force in N.
    Force,
    /// A torque in N m.
    Torque,
    /// An acceleration in m/s^2.
    Gravity,
    /// A stiffness in N/m, not negative.
    Stiffness,
    /// A damping constant in N s/m, not negative.
    Damping,
    /// A torsional stiffness in N m/rad, not negative.
    TurnStiffness,
    /// A torsional damping constant in N m s/rad, not negative.
    TurnDamping,
    /// A time in s.
    Time,
    /// A plain number: the factor of a load, or the relative fluctuation of a speed.
    Factor,
    /// A named number, whose use determines the measured quantity.
    Parameter,
}

/// The units of a measure.
#[derive(Clone, Copy)]
pub(crate) enum MeasureUnits {
    /// Every unit of length; the file uses the scene's.
    Length,
    /// Degrees, which the file uses, and radians.
    Angle,
    /// The units of a rate, which always has its own.
    Rate(RateKind, Degree),
    /// Units by scale, the file's first; a plain number has the symbol "".
    Scales(&'static [UnitScale]),
}

/// The symbol of a unit, and its size in the file's unit as numerator and denominator.
pub(crate) type UnitScale = (&'static str, u32, u32);

impl Measure {
    /// Returns the measure of the corresponding number of a torsion spring, with torques and
    /// angles.
    pub(crate) fn of_torsion(self) -> Measure {
        match self {
            Measure::Stiffness => Measure::TurnStiffness,
            Measure::Damping => Measure::TurnDamping,
            Measure::Force => Measure::Torque,
            other => other,
        }
    }

    /// Returns the measure of a rate of the driver; `turns` is `true` for a link, `false` for a
    /// slide.
    pub(crate) fn of_rate(degree: Degree, is_rotary: bool) -> Measure {
        match (degree, is_rotary) {
            (Degree::Speed, true) => Measure::TurnSpeed,
            (Degree::Speed, false) => Measure::PushSpeed,
            (Degree::Acceleration, true) => Measure::TurnAcceleration,
            (Degree::Acceleration, false) => Measure::PushAcceleration,
        }
    }

    /// Returns `true` for a speed or an acceleration of the driver.
    pub(crate) fn is_rate(self) -> bool {
        matches!(self.units(Unit::default()), MeasureUnits::Rate(..))
    }

    /// Returns the permitted units in a scene with this unit of length.
    pub(crate) fn units(self, scene: Unit) -> MeasureUnits {
        let push = RateKind::Push(scene);
        let scales: &'static [UnitScale] = match self {
            Measure::Length | Measure::Coordinate | Measure::Start | Measure::Deviation => {
                return MeasureUnits::Length;
            }
            Measure::Angle => return MeasureUnits::Angle,
            Measure::TurnSpeed => return MeasureUnits::Rate(RateKind::Turn, Degree::Speed),
            Measure::TurnAcceleration => {
                return MeasureUnits::Rate(RateKind::Turn, Degree::Acceleration);
            }
            Measure::PushSpeed => return MeasureUnits::Rate(push, Degree::Speed),
            Measure::PushAcceleration => return MeasureUnits::Rate(push, Degree::Acceleration),
            Measure::Mass => &[("kg", 1, 1), ("g", 1, 1000)],
            Measure::Inertia => &[
                ("kg m^2", 1, 1),
                ("kg cm^2", 1, 10_000),
                ("kg mm^2", 1, 1_000_000),
            ],
            Measure::Force => &[("N", 1, 1), ("kN", 1000, 1)],
            Measure::Torque => &[
                ("N m", 1, 1),
                ("N cm", 1, 100),
                ("N mm", 1, 1000),
                ("kN m", 1000, 1),
            ],
            Measure::Gravity => &[("m/s^2", 1, 1), ("mm/s^2", 1, 1000)],
            Measure::Stiffness => &[("N/m", 1, 1), ("N/mm", 1000, 1), ("kN/m", 1000, 1)],
            Measure::Damping => &[("N s/m", 1, 1), ("N s/mm", 1000, 1)],
            Measure::TurnStiffness => &[("N m/rad", 1, 1), ("N mm/rad", 1, 1000)],
            Measure::TurnDamping => &[("N m s/rad", 1, 1), ("N mm s/rad", 1, 1000)],
            Measure::Time => &[("s", 1, 1), ("ms", 1, 1000)],
            Measure::Factor => &[("", 1, 1), ("%", 1, 100)],
            Measure::Parameter => &[("", 1, 1)],
        };
        MeasureUnits::Scales(scales)
    }

    /// Returns the dimension required of a formula with units; `None` for rates and parameters,
    /// which may have any.
    pub(crate) fn dimension(self) -> Option<Dimension> {
        Some(match self {
            Measure::Length | Measure::Coordinate | Measure::Start | Measure::Deviation => {
                Dimension::LENGTH
            }
            Measure::Angle => Dimension::DEGREES,
            Measure::Mass => Dimension::KILOGRAM,
            Measure::Inertia => Dimension::INERTIA,
            Measure::Force => Dimension::FORCE,
            Measure::Torque => Dimension::MOMENT,
            Measure::Gravity => Dimension::FREE_FALL,
            Measure::Stiffness => Dimension::STIFFNESS,
            Measure::Damping => Dimension::DAMPING,
            Measure::TurnStiffness => Dimension::TURN_STIFFNESS,
            Measure::TurnDamping => Dimension::TURN_DAMPING,
            Measure::Time => Dimension::SECOND,
            Measure::Factor => Dimension::NUMBER,
            Measure::TurnSpeed
            | Measure::TurnAcceleration
            | Measure::PushSpeed
            | Measure::PushAcceleration
            | Measure::Parameter => return None,
        })
    }

    /// Returns the unit used in the file; empty for a rate, which has its own.
    pub(crate) fn unit(self, scene: Unit) -> &'static str {
        match self.units(scene) {
            MeasureUnits::Length => scene.symbol(),
            MeasureUnits::Angle => "deg",
            MeasureUnits::Rate(..) => "",
            MeasureUnits::Scales(scales) => scales[0].0,
        }
    }
}
