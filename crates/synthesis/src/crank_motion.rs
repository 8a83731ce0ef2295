//! Determines the crank's motion through the points of a task.

use super::Sense;
use kinematics::angle::TURN;

/// The crank's motion through the points of a task.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Way {
    /// The crank's angle at every point, in degrees, counted continuously from the first.
    pub(super) at: Vec<f64>,
    /// The first point that the crank reaches only by turning back.
    pub(super) turns_back: Option<usize>,
}

/// Rotation in degrees up to which a difference is rounding.
const ROTATION_TOLERANCE: f64 = 1e-9;

/// Returns the angles of a crank that turns fully and reaches its points in any order, within the
/// smallest rotation.
pub(super) fn anyhow(angles: &[f64]) -> Vec<f64> {
    let Some(&first) = angles.first() else {
        return Vec::new();
    };
    let mut round: Vec<f64> = angles
        .iter()
        .map(|a| (a - first).rem_euclid(TURN))
        .collect();
    round.sort_by(f64::total_cmp);
    let next = round[1..].iter().copied().chain([TURN]);
    let gaps = round.iter().zip(next).map(|(from, to)| (to - from, to));
    // The range begins after the widest gap; the first point keeps its angle.
    let widest = gaps.max_by(|one, other| one.0.total_cmp(&other.0));
    let start = widest.map_or(TURN, |(_, to)| to);
    let place = |angle: &f64| {
        let on = (angle - first).rem_euclid(TURN);
        first + if on < start { on } else { on - TURN }
    };
    angles.iter().map(place).collect()
}

/// Returns the angles of a crank with given rotations; `None` for a point beyond the limits.
pub(super) fn given(turned: &[f64], limits: Option<(f64, f64)>) -> Vec<Option<f64>> {
    let Some((low, high)) = limits else {
        return turned.iter().copied().map(Some).collect();
    };
    // The given angles may count from another turn than the limits.
    let first = turned.first().copied().unwrap_or(0.0);
    let shift = swinging(&[first], (low, high))[0].map_or(0.0, |here| here - first);
    let slack = ROTATION_TOLERANCE * TURN;
    let place = |turned: &f64| {
        let at = turned + shift;
        (low - slack <= at && at <= high + slack).then(|| at.clamp(low, high))
    };
    turned.iter().map(place).collect()
}

/// Returns the motion of a crank that turns fully. It turns one way if this passes all points
/// within one turn; if not, it takes the shorter way from each point to the next.
pub(super) fn turning(angles: &[f64], sense: Option<Sense>) -> Way {
    let ways =
        [Sense::CounterClockwise, Sense::Clockwise].map(|sense| (sense, one_way(angles, sense)));
    let length = |(_, at): &(Sense, Vec<f64>)| {
        let ends = at.last().zip(at.first());
        ends.map_or(0.0, |(last, first)| (last - first).abs())
    };
    let within = |rotation: &&(Sense, Vec<f64>)| length(rotation) <= TURN;
    let requested = ways
        .iter()
        .filter(within)
        .find(|rotation| Some(rotation.0) == sense);
    // The shorter of two; counter-clockwise if both are equally long.
    let any = ways
        .iter()
        .filter(within)
        .min_by(|one, other| length(one).total_cmp(&length(other)));
    match requested.or(any) {
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

/// Returns the angles of a crank between two limits; `None` for a point beyond them.
pub(super) fn swinging(angles: &[f64], (low, high): (f64, f64)) -> Vec<Option<f64>> {
    let mut before = angles.first().copied().unwrap_or(0.0);
    let mut at = Vec::with_capacity(angles.len());
    for &angle in angles {
        // A point at a limit may lie outside it by rounding.
        let slack = ROTATION_TOLERANCE * TURN;
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

/// Returns the first point that the crank reaches by turning back.
pub(super) fn turns_back(at: &[f64]) -> Option<usize> {
    let steps = at.windows(2).map(|two| two[1] - two[0]);
    let mut sense = 0.0_f64;
    for (index, step) in (1..).zip(steps) {
        if step.abs() <= ROTATION_TOLERANCE {
            continue;
        }
        if step * sense < 0.0 {
            return Some(index);
        }
        sense = step;
    }
    None
}

fn one_way(angles: &[f64], sense: Sense) -> Vec<f64> {
    let mut at: Vec<f64> = Vec::with_capacity(angles.len());
    for &angle in angles {
        let next = match at.last() {
            None => angle,
            Some(before) => match sense {
                Sense::CounterClockwise => before + forward(angle - before),
                Sense::Clockwise => before - forward(before - angle),
            },
        };
        at.push(next);
    }
    at
}

/// Returns a forward rotation from 0 to less than a whole turn; a backward rotation by rounding
/// stays negative.
fn forward(turn: f64) -> f64 {
    let forward = turn.rem_euclid(TURN);
    match forward < TURN - ROTATION_TOLERANCE {
        true => forward,
        false => forward - TURN,
    }
}

fn shortest(angles: &[f64]) -> Vec<f64> {
    let mut at: Vec<f64> = Vec::with_capacity(angles.len());
    for &angle in angles {
        at.push(at.last().map_or(angle, |before| {
            kinematics::angle::unwrap_near(*before, angle)
        }));
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn full_turn_crank_prefers_one_direction() {
        let rotation = turning(&[350.0, 10.0, 40.0], None);
        assert_eq!(rotation.at, [350.0, 370.0, 400.0]);
        assert_eq!(rotation.turns_back, None);
        let rotation = turning(&[10.0, 350.0, 300.0], None);
        assert_eq!(rotation.at, [10.0, -10.0, -60.0]);
        // Three points can always be passed one way.
        assert_eq!(turning(&[0.0, 200.0, 100.0], None).turns_back, None);
        // Four points may require turning back.
        assert_eq!(
            turning(&[0.0, 200.0, 100.0, 150.0], None).turns_back,
            Some(3)
        );
        let requested = turning(&[0.0, 10.0], Some(Sense::Clockwise));
        assert_eq!(requested.at, [0.0, -350.0]);
    }

    #[test]
    fn unordered_points_take_smallest_rotation() {
        assert_eq!(
            anyhow(&[0.0, 200.0, 100.0, 150.0]),
            [0.0, 200.0, 100.0, 150.0]
        );
        assert_eq!(anyhow(&[10.0, 350.0, 20.0]), [10.0, -10.0, 20.0]);
        assert_eq!(anyhow(&[350.0, 10.0, 300.0]), [350.0, 370.0, 300.0]);
        assert_eq!(anyhow(&[40.0]), [40.0]);
        assert!(anyhow(&[]).is_empty());
    }

    #[test]
    fn rounding_is_not_turning_back() {
        let rotation = turning(&[10.0, 50.0, 50.0 - 1e-12, 90.0], None);
        assert_eq!(rotation.turns_back, None);
        assert!((rotation.at[3] - 90.0).abs() < 1e-9, "{rotation:?}");
        assert_eq!(turns_back(&[0.0, 1.0, 1.0 - 1e-12, 2.0]), None);
        assert_eq!(turns_back(&[0.0, 1.0, 0.9, 2.0]), Some(2));
    }

    #[test]
    fn given_rotations_are_kept() {
        assert_eq!(
            given(&[0.0, 250.0, 500.0], None)[1..],
            [Some(250.0), Some(500.0)]
        );
        let within = given(&[350.0, 370.0, 430.0], Some((-30.0, 60.0)));
        assert_eq!(within, [Some(-10.0), Some(10.0), None]);
    }

    #[test]
    fn swinging_crank_stays_between_limits() {
        let at = swinging(&[350.0, 10.0, 100.0], (-30.0, 60.0));
        assert_eq!(at, [Some(-10.0), Some(10.0), None]);
    }
}
