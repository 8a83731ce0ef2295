//! Compares a flywheel and a motor with a cycle.

use super::Cycle;

/// Returns the moment of inertia in kg m^2 on the driver's shaft for a coefficient of fluctuation C
/// = (w_max - w_min) / w_mean. The driver's work fluctuates by `energy` (J) at the speed w (rad/s):
/// delta E = I w^2 C. The inertia of the mechanism itself is neglected. Returns `None` if the
/// result is not finite.
///
/// For a pushed slide, the result is a mass in kg, with the speed in m/s.
#[must_use]
pub fn flywheel_for(energy: f64, speed: f64, fluctuation: f64) -> Option<f64> {
    let inertia = energy / (speed * speed * fluctuation);
    inertia.is_finite().then_some(inertia)
}

/// Returns the coefficient of fluctuation with a flywheel; `None` if it is not finite.
#[must_use]
pub fn fluctuation_with(energy: f64, speed: f64, flywheel: f64) -> Option<f64> {
    let fluctuation = energy / (speed * speed * flywheel);
    fluctuation.is_finite().then_some(fluctuation)
}

/// The coefficient above which the fluctuation is a rough estimate: changes of energy and speed are
/// proportional only for small fluctuations.
pub const SMALL_FLUCTUATION: f64 = 0.2;

/// The largest possible fluctuation: (max - min) / mean is 2 if the minimum is 0 and the driver
/// stops.
pub const MAX_FLUCTUATION: f64 = 2.0;

/// A requirement of a cycle and the motor's capacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorDemand {
    /// The requirement of the cycle.
    pub required: f64,
    /// The capacity of the motor.
    pub capacity: f64,
}

/// The comparison of a motor with a cycle; `None` for values that one of both lacks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotorFit {
    /// The root mean square against the rated torque, with equal heating of the motor.
    pub rated: Option<MotorDemand>,
    /// The largest absolute torque against the peak torque.
    pub peak: Option<MotorDemand>,
    /// The driver's speed against the motor's.
    pub speed: Option<MotorDemand>,
    /// The gear that the motor's excess speed allows, without losses; `None` if the motor is not
    /// faster than the driver, or if its torques are unknown.
    pub geared: Option<Geared>,
    /// `true` if the torque is unbounded, so that no motor can be assessed.
    pub is_unbounded: bool,
}

/// A motor with a gear that reduces its speed to the driver's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geared {
    /// Turns of the motor per turn of the driver.
    pub ratio: f64,
    /// `true` if the geared motor suffices.
    pub is_enough: bool,
}

impl MotorDemand {
    /// Compares a demand with a capacity, if both are known.
    pub(super) fn of(required: Option<f64>, capacity: Option<f64>) -> Option<MotorDemand> {
        let (required, capacity) = (required?, capacity?);
        Some(MotorDemand { required, capacity })
    }

    /// Returns `true` if the capacity suffices.
    #[must_use]
    pub fn is_enough(&self) -> bool {
        self.required <= self.capacity
    }

    /// Returns the deficit; negative for a surplus.
    #[must_use]
    pub fn deficit(&self) -> f64 {
        self.required - self.capacity
    }
}

impl MotorFit {
    /// Compares a motor on the driver's shaft with a cycle: its rated and peak torque in N m or N,
    /// and its speed in rad/s or m/s. Unknown values are not compared.
    #[must_use]
    pub fn new(
        cycle: &Cycle,
        rated: Option<f64>,
        peak: Option<f64>,
        speed: Option<f64>,
    ) -> MotorFit {
        let fit = MotorFit {
            rated: MotorDemand::of(cycle.all.rms, rated),
            peak: MotorDemand::of(cycle.all.worst().map(|peak| peak.value.abs()), peak),
            speed: MotorDemand::of(Some(cycle.speed), speed),
            geared: None,
            is_unbounded: cycle.all.worst().is_none(),
        };
        MotorFit {
            geared: fit.geared(speed.map_or(0.0, |speed| speed / cycle.speed)),
            ..fit
        }
    }

    /// Returns the motor with a gear, if the motor is faster and a torque is known.
    fn geared(&self, ratio: f64) -> Option<Geared> {
        let torques = [self.rated, self.peak].into_iter().flatten();
        let enough = torques.map(|a| a.required <= a.capacity * ratio);
        let is_enough = enough.reduce(|a, b| a && b)?;
        let is_faster = ratio > 1.0 && ratio.is_finite();
        is_faster.then_some(Geared { ratio, is_enough })
    }

    /// Returns `true` if the motor on the driver's shaft suffices in all known respects; `None` if
    /// none are known, or if the torque is unbounded.
    #[must_use]
    pub fn is_enough(&self) -> Option<bool> {
        if self.is_unbounded {
            return None;
        }
        let known = [self.rated, self.peak, self.speed].into_iter().flatten();
        known
            .map(|requested| requested.is_enough())
            .reduce(|a, b| a && b)
    }
}
