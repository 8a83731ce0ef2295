//! In which order a crank comes through its places.

use super::Sense;
use crate::angle::TURN;

/// How a crank comes through the places of a task.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Way {
    /// Its angle at every place, in degrees, counted on from the first.
    pub(super) at: Vec<f64>,
    /// The first place that it cannot reach without turning back.
    pub(super) turns_back: Option<usize>,
}

/// The way of a crank that turns fully: one way round where that passes all places within a turn, else the short way from
/// each to the next.
pub(super) fn turning(angles: &[f64], sense: Option<Sense>) -> Way {
    let ways =
        [Sense::CounterClockwise, Sense::Clockwise].map(|sense| (sense, one_way(angles, sense)));
    let within = |way: &&(Sense, Vec<f64>)| {
        let total = way
            .1
            .last()
            .zip(way.1.first())
            .map_or(0.0, |(l, f)| (l - f).abs());
        total <= TURN
    };
    let wished = ways.iter().filter(within).find(|way| Some(way.0) == sense);
    // The shorter of two; clockwise where both are as long, as nobody knows better.
    let length = |way: &Vec<f64>| {
        way.last()
            .zip(way.first())
            .map_or(0.0, |(l, f)| (l - f).abs())
    };
    let any = ways
        .iter()
        .filter(within)
        .min_by(|one, other| length(&one.1).total_cmp(&length(&other.1)));
    match wished.or(any) {
        Some((_, at)) => Way {
            at: at.clone(),
            turns_back: None,
        },
        None => {
            let at = shortest(angles);
            let turns_back = turns_back(&at);
            Way { at, turns_back }
        }
    }
}

/// The way of a crank between two limits; `None` stands where a place lies beyond them.
pub(super) fn swinging(angles: &[f64], (low, high): (f64, f64)) -> Vec<Option<f64>> {
    let mut before = angles.first().copied().unwrap_or(0.0);
    let mut at = Vec::with_capacity(angles.len());
    for &angle in angles {
        // A place at a limit may be beside it by rounding.
        let slack = 1e-9 * TURN;
        let first = ((low - slack - angle) / TURN).ceil();
        let last = ((high + slack - angle) / TURN).floor();
        let nearest = ((before - angle) / TURN)
            .round()
            .clamp(first.min(last), last.max(first));
        let found = (first <= last).then(|| (angle + TURN * nearest).clamp(low, high));
        before = found.unwrap_or(before);
        at.push(found);
    }
    at
}

/// The first place that is reached by turning back.
pub(super) fn turns_back(at: &[f64]) -> Option<usize> {
    let steps = at.windows(2).map(|two| two[1] - two[0]);
    let mut sense = 0.0_f64;
    for (place, step) in (1..).zip(steps) {
        if step * sense < 0.0 {
            return Some(place);
        }
        if step != 0.0 {
            sense = step;
        }
    }
    None
}

fn one_way(angles: &[f64], sense: Sense) -> Vec<f64> {
    let mut at: Vec<f64> = Vec::with_capacity(angles.len());
    for &angle in angles {
        let next = match at.last() {
            None => angle,
            Some(before) => match sense {
                Sense::CounterClockwise => before + (angle - before).rem_euclid(TURN),
                Sense::Clockwise => before - (before - angle).rem_euclid(TURN),
            },
        };
        at.push(next);
    }
    at
}

fn shortest(angles: &[f64]) -> Vec<f64> {
    let mut at: Vec<f64> = Vec::with_capacity(angles.len());
    for &angle in angles {
        at.push(
            at.last()
                .map_or(angle, |before| crate::angle::beside(*before, angle)),
        );
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crank_comes_round_one_way() {
        let way = turning(&[350.0, 10.0, 40.0], None);
        assert_eq!(way.at, [350.0, 370.0, 400.0]);
        assert_eq!(way.turns_back, None);
        let way = turning(&[10.0, 350.0, 300.0], None);
        assert_eq!(way.at, [10.0, -10.0, -60.0]);
        // Three places are always passed one way.
        assert_eq!(turning(&[0.0, 200.0, 100.0], None).turns_back, None);
        // Four need not be.
        assert_eq!(
            turning(&[0.0, 200.0, 100.0, 150.0], None).turns_back,
            Some(3)
        );
        let wished = turning(&[0.0, 10.0], Some(Sense::Clockwise));
        assert_eq!(wished.at, [0.0, -350.0]);
    }

    #[test]
    fn a_rocker_stays_between_its_limits() {
        let at = swinging(&[350.0, 10.0, 100.0], (-30.0, 60.0));
        assert_eq!(at, [Some(-10.0), Some(10.0), None]);
    }
}
