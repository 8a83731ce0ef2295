//! The range of the driver for playback and stepping.

use crate::angle::TURN;
use crate::scene::Scene;
use crate::solver::{Range, Solver};
use crate::tui::figures::format::{MAX_COORDINATE_DECIMALS, rounded};
use crate::tui::player::playback::Track;
use crate::{Driver, Input};

/// The range of the driver coordinate, in degrees or in the scene's length unit.
#[derive(Clone, Debug)]
pub(crate) struct DriverRange {
    range: Range,
    is_rotary: bool,
    /// The scene's initial coordinate.
    opening: f64,
    /// The magnitude of the scene's driver speed, per second.
    speed: f64,
    /// The length of one sweep: a full turn, or the travel of a slide.
    span: f64,
    /// The number of decimals to which coordinates are rounded during playback, so that the
    /// displayed coordinate is the solved one.
    decimals: usize,
}

/// The error for a coordinate outside the driver's range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OutOfRange {
    /// The lower limit.
    pub(crate) low: f64,
    /// The upper limit.
    pub(crate) high: f64,
}

impl DriverRange {
    pub(crate) fn new(scene: &Scene, solver: &Solver) -> Self {
        let driver = *scene.mechanism.driver();
        let is_rotary = matches!(driver.input, Input::Turn(_));
        let range = solver.motion().range;
        let span = match (is_rotary, range) {
            (true, _) => TURN,
            (false, Range::Limited { low, high }) if high > low => high - low,
            (false, _) => 1.0,
        };
        let decimals = if is_rotary {
            2
        } else {
            let digits = span.log10().floor().clamp(-9.0, 9.0);
            // Four digits of the span and one more, because a sweep has thousands of positions.
            (0..=MAX_COORDINATE_DECIMALS)
                .find(|&d| d as f64 + digits >= 4.0)
                .unwrap_or(MAX_COORDINATE_DECIMALS)
        };
        DriverRange {
            range,
            is_rotary,
            opening: driver.start,
            speed: speed(&driver, is_rotary),
            span,
            decimals,
        }
    }

    /// Returns `true` if the driver is a turning link, `false` if it is a slide.
    pub(crate) fn turns(&self) -> bool {
        self.is_rotary
    }

    /// Returns the scene's initial coordinate.
    pub(crate) fn opening(&self) -> f64 {
        self.opening
    }

    /// Returns the length of one sweep: a full turn, or the travel of a slide.
    pub(crate) fn span(&self) -> f64 {
        self.span
    }

    /// Returns the number of decimals of the coordinate during playback.
    pub(crate) fn decimals(&self) -> usize {
        self.decimals
    }

    /// Returns the playback track of a driver with constant speed.
    pub(crate) fn track(&self) -> Track {
        Track {
            span: self.span,
            oscillation: self.shuttle(),
            speed: self.speed,
        }
    }

    /// Returns the limits between which playback oscillates; `None` if the driver turns without
    /// limits.
    pub(crate) fn shuttle(&self) -> Option<(f64, f64)> {
        match self.range {
            Range::Limited { low, high } => Some((low, high)),
            Range::Full { .. } => None,
        }
    }

    /// Returns the coordinate meant by `at`: itself, or its equivalent from [`Range::equivalent_in_range`].
    pub(crate) fn reach(&self, at: f64) -> Result<f64, OutOfRange> {
        let Range::Limited { low, high } = self.range else {
            return Ok(at);
        };
        if (low..=high).contains(&at) {
            return Ok(at);
        }
        let intended = self.range.equivalent_in_range(at, self.is_rotary);
        intended.ok_or(OutOfRange { low, high })
    }

    /// Returns the nearest coordinate in the driver's range.
    pub(crate) fn clamp(&self, at: f64) -> f64 {
        match self.range {
            // The solver orders the limits. Unlike `clamp`, `max` and `min` would not panic if it
            // did not.
            Range::Limited { low, high } => at.max(low).min(high),
            Range::Full { .. } => at,
        }
    }

    /// Rounds `at` to [`DriverRange::decimals`] as in playback, and limits it to the range.
    pub(crate) fn on_grid(&self, at: f64) -> f64 {
        self.clamp(rounded(at, self.decimals))
    }
}

fn speed(driver: &Driver, is_rotary: bool) -> f64 {
    let speed = driver.speed.abs();
    if is_rotary { speed.to_degrees() } else { speed }
}
