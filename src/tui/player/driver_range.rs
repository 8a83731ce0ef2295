//! Where the driver can go: its range as playing and stepping see it.

use crate::angle::TURN;
use crate::scene::Scene;
use crate::solver::{Range, Solver};
use crate::tui::figures::format::{FINEST, rounded};
use crate::tui::player::playback::Track;
use crate::{Driver, Input};

/// The driver's coordinate as the workbench moves it: in degrees, or in the scene's length unit.
#[derive(Clone, Debug)]
pub(crate) struct DriverRange {
    range: Range,
    turns: bool,
    /// Where the scene opens.
    opening: f64,
    /// How fast the scene drives, per second, without its sign.
    speed: f64,
    /// What is covered in one sweep: a turn, or the travel of a slide.
    span: f64,
    /// Decimals that the coordinate is rounded to while playing, so that what is shown is what was
    /// solved.
    decimals: usize,
}

/// A coordinate that the driver cannot reach.
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
        let turns = matches!(driver.input, Input::Turn(_));
        let range = solver.motion().range;
        let span = match (turns, range) {
            (true, _) => TURN,
            (false, Range::Limited { low, high }) if high > low => high - low,
            (false, _) => 1.0,
        };
        let decimals = if turns {
            2
        } else {
            let digits = span.log10().floor().clamp(-9.0, 9.0);
            // Four digits of the span, and one more: a sweep has thousands of places.
            (0..=FINEST)
                .find(|&d| d as f64 + digits >= 4.0)
                .unwrap_or(FINEST)
        };
        DriverRange {
            range,
            turns,
            opening: driver.start,
            speed: speed(&driver, turns),
            span,
            decimals,
        }
    }

    /// Whether the driver is a link that turns; otherwise it is a slide that is pushed.
    pub(crate) fn turns(&self) -> bool {
        self.turns
    }

    /// Where the scene opens.
    pub(crate) fn opening(&self) -> f64 {
        self.opening
    }

    /// What is covered in one sweep: a turn, or the travel of a slide.
    pub(crate) fn span(&self) -> f64 {
        self.span
    }

    /// Decimals of the coordinate while playing.
    pub(crate) fn decimals(&self) -> usize {
        self.decimals
    }

    /// What playing goes along, of a driver that runs by its speed.
    pub(crate) fn track(&self) -> Track {
        Track {
            span: self.span,
            shuttle: self.shuttle(),
            speed: self.speed,
        }
    }

    /// Between where and where playing goes to and fro; `None` if it goes round for ever.
    pub(crate) fn shuttle(&self) -> Option<(f64, f64)> {
        match self.range {
            Range::Limited { low, high } => Some((low, high)),
            Range::Full { .. } => None,
        }
    }

    /// The coordinate meant by `at`: itself, or what [`Range::meant`] takes it for.
    pub(crate) fn reach(&self, at: f64) -> Result<f64, OutOfRange> {
        let Range::Limited { low, high } = self.range else {
            return Ok(at);
        };
        if (low..=high).contains(&at) {
            return Ok(at);
        }
        let meant = self.range.meant(at, self.turns);
        meant.ok_or(OutOfRange { low, high })
    }

    /// The nearest coordinate that the driver can reach.
    pub(crate) fn clamp(&self, at: f64) -> f64 {
        match self.range {
            // The limits are ordered by the solver; max and min do not panic if they were not.
            Range::Limited { low, high } => at.max(low).min(high),
            Range::Full { .. } => at,
        }
    }

    /// `at` as playing shows it: on the grid of [[`DriverRange::decimals`]], within the range.
    pub(crate) fn on_grid(&self, at: f64) -> f64 {
        self.clamp(rounded(at, self.decimals))
    }
}

fn speed(driver: &Driver, turns: bool) -> f64 {
    let speed = driver.speed.abs();
    if turns { speed.to_degrees() } else { speed }
}
