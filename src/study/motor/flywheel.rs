//! A flywheel and a motor against a cycle.

use super::Cycle;

/// The moment of inertia in kg m^2 on the driver's shaft that keeps the coefficient of fluctuation
/// C = (w_max - w_min) / w_mean, where the work of the driver goes `energy` (J) up and down at the speed
/// w (rad/s): delta E = I w^2 C. What turns already is left out of account. `None` where nothing turns.
///
/// Of a pushed slide it is the mass in kg, with the speed in m/s.
#[must_use]
pub fn flywheel_for(energy: f64, speed: f64, fluctuation: f64) -> Option<f64> {
    let inertia = energy / (speed * speed * fluctuation);
    inertia.is_finite().then_some(inertia)
}

/// The coefficient of fluctuation with a flywheel.
#[must_use]
pub fn fluctuation_with(energy: f64, speed: f64, flywheel: f64) -> Option<f64> {
    let fluctuation = energy / (speed * speed * flywheel);
    fluctuation.is_finite().then_some(fluctuation)
}

/// Above this the fluctuation of a flywheel is a rough figure: energy and speed change in proportion for
/// small ones only.
pub const SMALL_FLUCTUATION: f64 = 0.2;

/// No fluctuation is larger: (greatest - least) by their mean is 2 where the least is 0, and the driver stands still.
pub const LARGEST_FLUCTUATION: f64 = 2.0;

/// What is asked of a motor, and what it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorDemand {
    /// What the cycle asks for.
    pub asked: f64,
    /// What the motor has.
    pub has: f64,
}

/// A motor against a cycle; what one of both does not say is `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotorFit {
    /// The root of the mean square against the rated torque: they heat the motor alike.
    pub rated: Option<MotorDemand>,
    /// The largest torque in size against the peak torque.
    pub peak: Option<MotorDemand>,
    /// The driver's speed against the motor's.
    pub speed: Option<MotorDemand>,
    /// The transmission that the motor's surplus of speed allows, and what it makes of both torques
    /// without losses; where the motor is faster than the driver.
    pub geared: Option<Geared>,
    /// Whether no largest torque exists: no motor can be judged.
    pub is_unbounded: bool,
}

/// A motor behind a gear that brings it down to the driver's speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geared {
    /// Turns of the motor to one of the driver.
    pub ratio: f64,
    /// Whether it would be enough.
    pub is_enough: bool,
}

impl MotorDemand {
    /// Whether there is enough.
    #[must_use]
    pub fn is_enough(&self) -> bool {
        self.asked <= self.has
    }

    /// What is wanting; negative where something is left.
    #[must_use]
    pub fn lacks(&self) -> f64 {
        self.asked - self.has
    }
}

impl MotorFit {
    /// A motor on the driver's shaft against a cycle: what it can keep up, in N m or N, the most that it
    /// can do for an instant, and its speed in rad/s or m/s; what is not known of it is not asked.
    #[must_use]
    pub fn new(
        cycle: &Cycle,
        rated: Option<f64>,
        peak: Option<f64>,
        speed: Option<f64>,
    ) -> MotorFit {
        let both = |asked: Option<f64>, has: Option<f64>| {
            let (asked, has) = (asked?, has?);
            Some(MotorDemand { asked, has })
        };
        let fit = MotorFit {
            rated: both(cycle.all.rms, rated),
            peak: both(cycle.all.worst().map(|peak| peak.value.abs()), peak),
            speed: both(Some(cycle.speed), speed),
            geared: None,
            is_unbounded: cycle.all.worst().is_none(),
        };
        MotorFit {
            geared: fit.geared(speed.map_or(0.0, |speed| speed / cycle.speed)),
            ..fit
        }
    }

    /// What becomes of it behind a gear, where the motor is the faster one and its torques are known.
    fn geared(&self, ratio: f64) -> Option<Geared> {
        let torques = [self.rated, self.peak].into_iter().flatten();
        let enough = torques.map(|a| a.asked <= a.has * ratio);
        let is_enough = enough.reduce(|a, b| a && b)?;
        let is_faster = ratio > 1.0 && ratio.is_finite();
        is_faster.then_some(Geared { ratio, is_enough })
    }

    /// Whether the motor on the driver's shaft is enough in everything that is known; `None` where
    /// nothing is, or no largest torque exists.
    #[must_use]
    pub fn is_enough(&self) -> Option<bool> {
        if self.is_unbounded {
            return None;
        }
        let known = [self.rated, self.peak, self.speed].into_iter().flatten();
        known.map(|asked| asked.is_enough()).reduce(|a, b| a && b)
    }
}
