//! Step sizes of the driver: a sequence of round numbers.

/// Step sizes of an angle, in degrees.
const DEGREES: [f64; 11] = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0];
/// Index of the initial step of a turning driver: 5 deg.
const OPENING_DEGREES: usize = 5;
/// Number of step sizes of a length, and index of the one that is about a hundredth of the travel.
const LENGTHS: i32 = 9;
const OPENING_LENGTH: usize = 4;

/// The available step sizes and the current one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StepLadder {
    ladder: Vec<f64>,
    rung: usize,
}

impl StepLadder {
    /// Creates the step sizes for a turning link.
    pub(crate) fn of_angle() -> Self {
        StepLadder {
            ladder: DEGREES.to_vec(),
            rung: OPENING_DEGREES,
        }
    }

    /// Creates the step sizes for a slide with travel `span`: 1, 2, 5, 10 and so on around a
    /// hundredth of it.
    pub(crate) fn of_length(span: f64) -> Self {
        // Three sizes per power of ten: 1, 2, 5.
        let hundredth = (span / 100.0).log10() * 3.0;
        let middle = if hundredth.is_finite() {
            hundredth.clamp(-900.0, 900.0).floor()
        } else {
            0.0
        };
        #[expect(clippy::cast_possible_truncation, reason = "clamped to +-900")]
        let first = middle as i32 - 4;
        StepLadder {
            ladder: (first..first + LENGTHS).map(one_two_five).collect(),
            rung: OPENING_LENGTH,
        }
    }

    /// Returns the current step, in degrees or in the scene's length unit.
    pub(crate) fn size(&self) -> f64 {
        self.ladder[self.rung]
    }

    /// Selects the next larger step, if there is one.
    pub(crate) fn larger(&mut self) {
        self.rung = (self.rung + 1).min(self.ladder.len() - 1);
    }

    /// Selects the next smaller step, if there is one.
    pub(crate) fn smaller(&mut self) {
        self.rung = self.rung.saturating_sub(1);
    }
}

/// Returns 1, 2, 5, 10, 20, 50 and so on for 0, 1, 2, 3, 4, 5; negative arguments continue the
/// sequence downwards.
fn one_two_five(rung: i32) -> f64 {
    let digit = [1.0, 2.0, 5.0][usize::try_from(rung.rem_euclid(3)).unwrap_or(0)];
    let power = rung.div_euclid(3);
    // Dividing by a power of ten keeps 0.2 the double nearest to 0.2; multiplying by 0.1 does not.
    if power < 0 {
        digit / 10.0_f64.powi(-power)
    } else {
        digit * 10.0_f64.powi(power)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn length_steps_are_round_and_start_near_one_percent() {
        let steps = StepLadder::of_length(120.0);
        assert_eq!(
            steps.ladder,
            [0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0]
        );
        assert_eq!(steps.size(), 1.0);
        assert_eq!(StepLadder::of_length(0.03).size(), 0.0002);
        assert_eq!(StepLadder::of_length(0.0).size(), 1.0);
        assert_eq!(StepLadder::of_length(f64::INFINITY).size(), 1.0);
    }

    #[test]
    fn steps_stop_at_ends_of_ladder() {
        let mut steps = StepLadder::of_angle();
        assert_eq!(steps.size(), 5.0);
        for _ in 0..20 {
            steps.smaller();
        }
        assert_eq!(steps.size(), 0.1);
        for _ in 0..20 {
            steps.larger();
        }
        assert_eq!(steps.size(), 90.0);
    }
}
