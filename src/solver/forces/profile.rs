//! Values over a coordinate, in any arithmetic: also where rounding leaves open on which side of a knot
//! the coordinate is.

use crate::angle::TURN;
use crate::{Number, Profile};

/// The value at `x`: straight lines between knots, constant beyond the ends.
pub(super) fn value<T: Number>(profile: &Profile, x: T) -> T {
    let knots = profile.knots();
    let Some(k) = nearest(knots, x.nearest()) else {
        return T::exactly(1.0);
    };
    let is_clear = |other: usize| {
        let is_there = |knot: &[f64; 2]| {
            let at = T::exactly(knot[0]);
            !(x.exceeds(at) || at.exceeds(x))
        };
        !knots.get(other).is_some_and(is_there)
    };
    if is_clear(k.wrapping_sub(1)) && is_clear(k + 1) {
        beside(knots, k, x)
    } else {
        // So little is known of the coordinate that it could lie at several knots.
        let all = (0..knots.len()).map(|k| beside(knots, k, x));
        all.reduce(T::either).unwrap_or(x)
    }
}

/// The knot nearest to a coordinate.
fn nearest(knots: &[[f64; 2]], x: f64) -> Option<usize> {
    let behind = knots.partition_point(|knot| knot[0] < x);
    let candidates = behind.saturating_sub(1)..(behind + 1).min(knots.len());
    let distance = |k: &usize| (knots[*k][0] - x).abs();
    candidates.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// The value at `x` on the lines that meet at the knot k.
fn beside<T: Number>(knots: &[[f64; 2]], k: usize, x: T) -> T {
    let [at, value] = knots[k].map(T::exactly);
    let line = |a: usize, b: usize| match (knots.get(a), knots.get(b)) {
        (Some(a), Some(b)) => {
            let [run, rise] = [0, 1].map(|i| T::exactly(b[i]) - T::exactly(a[i]));
            value + rise / run * (x - at)
        }
        _ => value,
    };
    if x.exceeds(at) {
        line(k, k + 1)
    } else if at.exceeds(x) {
        line(k.wrapping_sub(1), k)
    } else {
        line(k.wrapping_sub(1), k).either(line(k, k + 1))
    }
}

/// The value at the driver's coordinate: that of a turned driver repeats where the knots span whole
/// turns.
pub(super) fn repeated<T: Number>(profile: &Profile, at: T, turns: bool) -> T {
    value(
        profile,
        at - T::exactly(shift(profile, at.nearest(), turns)),
    )
}

/// The whole periods between a coordinate and the knots.
fn shift(profile: &Profile, at: f64, turns: bool) -> f64 {
    let (Some(first), Some(last)) = (profile.knots().first(), profile.knots().last()) else {
        return 0.0;
    };
    let span = last[0] - first[0];
    if !turns || span == 0.0 || span % TURN != 0.0 {
        return 0.0;
    }
    ((at - first[0]) / span).floor() * span
}

/// The force of a press at a distance from the end of its stroke, `towards` positive while it closes:
/// nothing beyond the last knot, nothing on the way back.
pub(super) fn press<T: Number>(curve: &Profile, distance: T, towards: T) -> T {
    let zero = T::default();
    let Some(last) = curve.knots().last() else {
        return zero;
    };
    let last = T::exactly(last[0]);
    if distance.exceeds(last) || zero.exceeds(towards) {
        return zero;
    }
    let force = value(curve, distance);
    if last.exceeds(distance) && towards.exceeds(zero) {
        force
    } else {
        // On the last knot, or at the end of the stroke: rounding decides.
        force.either(zero)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Ball;

    fn profile() -> Profile {
        Profile::new(vec![[0.0, 1.0], [10.0, 3.0], [20.0, 0.0]]).unwrap()
    }

    #[test]
    fn lines_between_knots_and_constants_beyond() {
        for (x, y) in [
            (-5.0, 1.0),
            (0.0, 1.0),
            (5.0, 2.0),
            (10.0, 3.0),
            (15.0, 1.5),
            (99.0, 0.0),
        ] {
            assert_eq!(value(&profile(), x), y, "{x}");
        }
    }

    #[test]
    fn a_ball_over_a_knot_holds_both_lines() {
        let ball = value(&profile(), Ball::new(10.0, 0.5));
        for x in [9.5, 9.75, 10.0, 10.25, 10.5] {
            let y: f64 = value(&profile(), x);
            assert!((y - ball.mid).abs() <= ball.radius, "{x}: {y} {ball:?}");
        }
    }

    #[test]
    fn whole_turns_repeat_and_others_do_not() {
        let turn = Profile::new(vec![[0.0, 0.0], [90.0, 9.0], [360.0, 0.0]]).unwrap();
        assert_eq!(repeated(&turn, 720.0 + 45.0, true), 4.5);
        assert_eq!(repeated(&turn, -360.0 + 45.0, true), 4.5);
        assert_eq!(repeated(&turn, 720.0 + 45.0, false), 0.0);
        assert_eq!(repeated(&profile(), 380.0, true), 0.0);
    }

    #[test]
    fn a_press_works_only_towards_its_end() {
        let curve = Profile::new(vec![[0.0, 200.0], [4.0, 100.0]]).unwrap();
        assert_eq!(press(&curve, 2.0, 1.0), 150.0);
        assert_eq!(press(&curve, 2.0, -1.0), 0.0);
        assert_eq!(press(&curve, 4.5, 1.0), 0.0);
        assert_eq!(press(&curve, 0.0, 0.0), 200.0);
        let end = press(&curve, Ball::new(0.0, 1e-12), Ball::new(0.0, 1e-12));
        assert!(
            end.radius >= 200.0 - end.mid && end.mid - end.radius <= 0.0,
            "{end:?}"
        );
    }
}
