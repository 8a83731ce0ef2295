//! Computes the driver coordinates of an animation: one period, or there and back between the
//! limits.

use super::DrawnScene;
use crate::angle::TURN;
use crate::solver::Range;
use std::f64::consts::TAU;

/// Frames per second: enough for a smooth motion, and few enough for a file.
pub(super) const RATE: u16 = 15;
/// Duration of a turn, in seconds.
const SECONDS: u16 = 6;

/// Returns the driver coordinate of each frame, starting and ending at the drawn one. The pace is
/// slow, because the mechanism's own speed may be too fast to follow.
pub(super) fn places(drawn: &DrawnScene<'_>) -> Vec<f64> {
    let pictures = u32::from(drawn.args.seconds.unwrap_or(SECONDS)) * u32::from(RATE);
    places_over(drawn.solver.motion().range, drawn.state.at(), pictures)
}

fn places_over(range: Range, from: f64, pictures: u32) -> Vec<f64> {
    let mut coordinates: Vec<f64> = match range {
        Range::Full { period } => {
            // A turn has the same duration whether or not the motion repeats after one.
            let turns = (period / TURN).round().max(1.0);
            let along = |share| from + share * period;
            shares(turns * f64::from(pictures)).map(along).collect()
        }
        Range::Limited { low, high } => {
            // Harmonic, as if driven by a crank: slow near the limits, where it reverses.
            let half = (high - low) / 2.0;
            let started = ((low + half - from) / half).clamp(-1.0, 1.0).acos();
            let started = if started.is_finite() { started } else { 0.0 };
            let along = |share: f64| low + half - half * (started + TAU * share).cos();
            let along = |share| along(share).clamp(low, high);
            shares(f64::from(pictures)).map(along).collect()
        }
    };
    coordinates[0] = from;
    coordinates.push(from);
    coordinates
}

/// Returns the fractions `k / count` from 0, below 1.
fn shares(count: f64) -> impl Iterator<Item = f64> {
    let numbers = (0..u32::MAX).map(f64::from);
    numbers
        .map(move |k| k / count)
        .take_while(|share| *share < 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An animation that loops must not jump at its start.
    #[test]
    fn a_turn_ends_where_it_began_and_never_jumps() {
        for (range, from, count, step) in [
            (Range::Full { period: 360.0 }, 60.0, 91, 4.0),
            (Range::Full { period: 720.0 }, 60.0, 181, 4.0),
            (Range::Full { period: 1080.0 }, 60.0, 271, 4.0),
            (
                Range::Limited {
                    low: -30.0,
                    high: 50.0,
                },
                10.0,
                91,
                2.8,
            ),
            (
                Range::Limited {
                    low: -30.0,
                    high: 50.0,
                },
                50.0,
                91,
                2.8,
            ),
        ] {
            let coordinates = places_over(range, from, 90);
            assert_eq!(coordinates.len(), count);
            assert_eq!([coordinates[0], coordinates[count - 1]], [from, from]);
            if let Range::Limited { low, high } = range {
                assert!(coordinates.iter().all(|at| (low..=high).contains(at)));
                let minimum = coordinates.iter().copied().fold(f64::INFINITY, f64::min);
                let maximum = coordinates
                    .iter()
                    .copied()
                    .fold(f64::NEG_INFINITY, f64::max);
                assert!(
                    minimum < low + 0.1 && maximum > high - 0.1,
                    "{minimum} to {maximum}"
                );
            }
            let distance = |pair: &[f64]| (pair[1] - pair[0]).abs();
            let mut steps = coordinates[..count - 1].windows(2);
            assert!(
                steps.all(|pair| distance(pair) <= step + 1e-9),
                "{coordinates:?}"
            );
        }
    }
}
