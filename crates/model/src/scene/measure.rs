//! What the numbers of a scene measure, and the units in which they may be typed.

use super::Unit;
use super::rate::{Degree, RateKind};
use crate::expression::Dimension;

/// What a value measures, and what it may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// A distance, positive, in the scene's unit; the length of a spring without a force may be 0, and
    /// so may a misfit.
    Length,
    /// A coordinate or a slide's position, in the scene's unit.
    Coordinate,
    /// A rough coordinate of `[start]`, in the scene's unit: it chooses the assembly.
    Start,
    /// How far a length may be off, or a pin is loose, in the scene's unit; not negative.
    Deviation,
    /// In degrees, counter-clockwise.
    Angle,
    /// How fast the driver turns, with a unit of its own.
    TurnSpeed,
    /// How its speed changes.
    TurnAcceleration,
    /// How fast the driver is pushed, with a unit of its own.
    PushSpeed,
    /// How its speed changes.
    PushAcceleration,
    /// In kg, not negative.
    Mass,
    /// In kg m^2, not negative.
    Inertia,
    /// In N.
    Force,
    /// In N m.
    Torque,
    /// In m/s^2.
    Gravity,
    /// In N/m, not negative.
    Stiffness,
    /// In N s/m, not negative.
    Damping,
    /// In N m/rad, not negative.
    TurnStiffness,
    /// In N m s/rad, not negative.
    TurnDamping,
    /// In s.
    Time,
    /// A plain number: the part of a load that acts, or of a speed by which it fluctuates.
    Factor,
    /// A number with a name: what it measures is what it is used for.
    Parameter,
}

/// The units of a measure.
#[derive(Clone, Copy)]
pub(super) enum MeasureUnits {
    /// Every unit of length; the file has the scene's.
    Length,
    /// Degrees, which the file has, and radians.
    Angle,
    /// A rate brings its unit along.
    Rate(RateKind, Degree),
    /// The first one is the file's; a plain number has none.
    Scales(&'static [UnitScale]),
}

/// A unit that may be typed; it is worth so many, divided by so many, of the one in the file.
pub(super) type UnitScale = (&'static str, u32, u32);

impl Measure {
    /// What the same number of a torsion spring measures: of torques over angles.
    pub(super) fn of_torsion(self) -> Measure {
        match self {
            Measure::Stiffness => Measure::TurnStiffness,
            Measure::Damping => Measure::TurnDamping,
            Measure::Force => Measure::Torque,
            other => other,
        }
    }

    /// What a rate of the driver measures, which is turned or pushed.
    pub(super) fn of_rate(degree: Degree, turns: bool) -> Measure {
        match (degree, turns) {
            (Degree::Speed, true) => Measure::TurnSpeed,
            (Degree::Speed, false) => Measure::PushSpeed,
            (Degree::Acceleration, true) => Measure::TurnAcceleration,
            (Degree::Acceleration, false) => Measure::PushAcceleration,
        }
    }

    /// Whether it is a speed or an acceleration of the driver.
    pub(crate) fn is_rate(self) -> bool {
        matches!(
            self,
            Measure::TurnSpeed
                | Measure::TurnAcceleration
                | Measure::PushSpeed
                | Measure::PushAcceleration
        )
    }

    /// Its units in a scene with this unit of length.
    pub(super) fn units(self, scene: Unit) -> MeasureUnits {
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

    /// What a formula that has units must measure; a rate and a parameter may be anything.
    pub(super) fn dimension(self) -> Option<Dimension> {
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

    /// The unit in which the file has it; a rate brings its own.
    pub(super) fn unit(self, scene: Unit) -> &'static str {
        match self.units(scene) {
            MeasureUnits::Length => scene.symbol(),
            MeasureUnits::Angle => "deg",
            MeasureUnits::Rate(..) => "",
            MeasureUnits::Scales(scales) => scales[0].0,
        }
    }
}
