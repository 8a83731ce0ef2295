//! Finds the extrema of a sampled function, ignoring noise.

/// A sample at which a function has an extremum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turn {
    pub sample: usize,
    pub is_peak: bool,
    /// `true` at an end of the samples, beyond which the function is unknown.
    pub is_end: bool,
}

/// Finds the extrema of `values`, alternating peaks and dips, that differ by more than `least`.
/// With `goes_round`, the samples are periodic: the last one repeats the first.
pub fn turns(values: &[f64], minimum: f64, is_periodic: bool) -> Vec<Turn> {
    let last = values.len().saturating_sub(1);
    if last < 2 {
        return Vec::new();
    }
    if !is_periodic {
        let (mut turns, pending) = walk(values.iter().copied().enumerate(), minimum);
        for turn in &mut turns {
            turn.is_end = turn.sample == 0;
        }
        turns.extend(pending.filter(|turn| turn.sample == last).map(|turn| Turn {
            is_end: true,
            ..turn
        }));
        return turns;
    }
    // Walks from the highest sample round to it again: it is the first extremum, and not repeated
    // at the end.
    let highest = (0..last)
        .max_by(|&i, &j| values[i].total_cmp(&values[j]))
        .unwrap_or(0);
    let round = (highest..last).chain(0..=highest);
    walk(round.map(|i| (i, values[i])), minimum).0
}

/// Tracks the highest and lowest value since the last extremum. A value more than `minimum` away from
/// one confirms it as an extremum. Also returns the last, unconfirmed extremum.
fn walk(values: impl Iterator<Item = (usize, f64)>, minimum: f64) -> (Vec<Turn>, Option<Turn>) {
    let mut turns: Vec<Turn> = Vec::new();
    let (mut high, mut low) = ((0, f64::NEG_INFINITY), (0, f64::INFINITY));
    let turn = |sample, is_peak| Turn {
        sample,
        is_peak,
        is_end: false,
    };
    for (i, value) in values {
        if value > high.1 {
            high = (i, value);
        }
        if value < low.1 {
            low = (i, value);
        }
        let seeks_peak = turns.last().is_none_or(|turn| !turn.is_peak);
        let seeks_dip = turns.last().is_none_or(|turn| turn.is_peak);
        if seeks_peak && high.1 - value > minimum {
            turns.push(turn(high.0, true));
            low = (i, value);
        } else if seeks_dip && value - low.1 > minimum {
            turns.push(turn(low.0, false));
            high = (i, value);
        }
    }
    let pending = turns.last().map(|last| {
        if last.is_peak {
            turn(low.0, false)
        } else {
            turn(high.0, true)
        }
    });
    (turns, pending)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(values: &[f64], is_periodic: bool) -> Vec<(usize, bool, bool)> {
        let turns = turns(values, 0.1, is_periodic);
        turns
            .iter()
            .map(|t| (t.sample, t.is_peak, t.is_end))
            .collect()
    }

    #[test]
    fn turns_are_distinguished_from_ends_and_noise() {
        let values = [0.0, 1.0, 0.95, 1.01, 0.0, 0.5];
        assert_eq!(
            found(&values, false),
            [
                (0, false, true),
                (3, true, false),
                (4, false, false),
                (5, true, true)
            ]
        );
        assert_eq!(found(&[1.0, 1.05, 1.0, 1.02], false), []);
        assert_eq!(found(&[2.0, 1.0], false), []);
    }

    #[test]
    fn difference_of_exactly_the_minimum_is_noise() {
        assert_eq!(turns(&[0.0, 0.5, 0.0], 0.5, false), []);
        assert_eq!(turns(&[0.0, 0.5, 0.0], 0.4375, false).len(), 3);
    }

    #[test]
    fn periodic_values_have_no_ends() {
        let round = |k: i32| (f64::from(k) * std::f64::consts::TAU / 12.0).cos();
        let values: Vec<f64> = (0..=12).map(round).collect();
        assert_eq!(found(&values, true), [(0, true, false), (6, false, false)]);
        let shifted: Vec<f64> = (3..=15).map(round).collect();
        assert_eq!(found(&shifted, true), [(9, true, false), (3, false, false)]);
    }

    #[test]
    fn three_samples_have_an_extremum_and_a_plateau_begins_one() {
        assert_eq!(
            found(&[0.0, 1.0, 0.0], false),
            [(0, false, true), (1, true, false), (2, false, true)]
        );
        let plateau = found(&[0.0, 1.0, 1.0, 0.0, 0.0, 1.0], false);
        let inner: Vec<usize> = plateau.iter().filter(|t| !t.2).map(|t| t.0).collect();
        assert_eq!(inner, [1, 3]);
    }
}
