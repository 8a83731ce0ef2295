//! Evaluates profiles over a coordinate in any arithmetic, even if rounding leaves open on which
//! side of a knot the coordinate is.

use crate::angle::TURN;
use crate::{Constant, Number, Profile};

/// A profile prepared for evaluation: its knots, the slope after each, and the period if it
/// repeats.
#[derive(Clone, Debug)]
pub(super) struct ReadyProfile {
    places: Vec<Constant>,
    values: Vec<Constant>,
    slopes: Vec<f64>,
    period: Option<f64>,
    /// Whether the coordinate is the driver's. A driver coordinate is a given double, so its side
    /// of a jump is known. A measured length is only known within rounding.
    is_named: bool,
    /// For equal parts of the whole length, the index of a knot not after any place of the part.
    /// `fineness` is the number of parts per unit of length.
    parts: Vec<usize>,
    fineness: f64,
}

/// The number of parts of a curve for each of its knots.
const PARTS: usize = 4;

impl ReadyProfile {
    /// Creates a profile over the driver's coordinate. `turns` means that the driver turns: then a
    /// curve whose knots span whole turns repeats.
    pub(super) fn over_driver(profile: &Profile, is_rotary: bool) -> ReadyProfile {
        ReadyProfile {
            is_named: true,
            ..ReadyProfile::new(profile, is_rotary)
        }
    }

    /// Creates a profile over a measured length.
    pub(super) fn over_length(profile: &Profile) -> ReadyProfile {
        ReadyProfile::new(profile, false)
    }

    fn new(profile: &Profile, is_rotary: bool) -> ReadyProfile {
        let knots = profile.knots();
        let (first, span) = match knots {
            [first, .., last] => (first[0], last[0] - first[0]),
            _ => (0.0, 0.0),
        };
        let slopes = knots.windows(2);
        let count = PARTS * knots.len();
        let fineness = if span > 0.0 { count as f64 / span } else { 0.0 };
        let starts = |part: usize| first + part as f64 / fineness;
        let before = |at: f64| {
            knots
                .partition_point(|knot| knot[0] <= at)
                .saturating_sub(1)
        };
        ReadyProfile {
            places: knots.iter().map(|knot| Constant::given(knot[0])).collect(),
            values: knots.iter().map(|knot| Constant::given(knot[1])).collect(),
            slopes: slopes
                .map(|k| (k[1][1] - k[0][1]) / (k[1][0] - k[0][0]))
                .collect(),
            period: (is_rotary && span > 0.0 && span % TURN == 0.0).then_some(span),
            // One part further back, so that rounding never starts after the place.
            parts: (0..count)
                .map(|part| before(starts(part.saturating_sub(1))))
                .collect(),
            is_named: false,
            fineness,
        }
    }

    /// Returns `true` if the profile is 1 everywhere.
    pub(super) fn is_one(&self) -> bool {
        self.places.is_empty()
    }

    /// Returns the value at `x`: linear between knots; beyond the ends constant, or repeated if
    /// periodic.
    pub(super) fn value<T: Number>(&self, x: T) -> T {
        let x = match (self.period, self.places.first()) {
            (Some(period), Some(first)) => {
                let from = x.nearest() - first.hi;
                if from >= 0.0 && from < period {
                    x
                } else {
                    x - T::exactly((from / period).floor() * period)
                }
            }
            _ => x,
        };
        if T::IS_CHEAP {
            self.quick(x)
        } else {
            self.around(x)
        }
    }

    /// Evaluates the line at the nearest double.
    fn quick<T: Number>(&self, x: T) -> T {
        let (Some(first), Some(&value)) = (self.places.first(), self.values.first()) else {
            return T::exactly(1.0);
        };
        let near = x.nearest();
        let from = near - first.hi;
        // Written so that NaN lies before all knots.
        if !(from >= 0.0) {
            return T::of(value);
        }
        // The cast saturates.
        let part = (from * self.fineness) as usize;
        let last = self.places.len() - 1;
        let mut k = self.parts.get(part).copied().unwrap_or(last);
        while self.places.get(k + 1).is_some_and(|place| place.hi <= near) {
            k += 1;
        }
        self.line(k, x)
    }

    /// Returns the value of the line after the knot k, or of the constant after the last knot.
    fn line<T: Number>(&self, k: usize, x: T) -> T {
        let value = T::of(self.values[k]);
        match self.slopes.get(k) {
            Some(&slope) if T::IS_CHEAP => value + T::exactly(slope) * (x - T::of(self.places[k])),
            Some(_) => {
                let distance = |v: &[Constant]| T::of(v[k + 1]) - T::of(v[k]);
                let slope = distance(&self.values) / distance(&self.places);
                value + slope * (x - T::of(self.places[k]))
            }
            None => value,
        }
    }

    /// Returns all values possible at `x` if it is unknown on which line it lies. If lines cannot
    /// be distinguished, the last one counts: the line after a jump.
    fn around<T: Number>(&self, x: T) -> T {
        let (from, to) = self.between_jumps(x.nearest());
        let is_behind = |k: usize| T::of(self.places[k]).exceeds(x);
        let is_before = |k: usize| self.places.get(k + 1).is_some_and(|&p| x.exceeds(T::of(p)));
        let is_there = |k: &usize| !is_behind(*k) && !is_before(*k) && !self.is_jump(*k);
        let lines = (from..to).filter(is_there).rev().map(|k| self.line(k, x));
        let first = self.places.first().zip(self.values.first());
        let before = first.filter(|(place, _)| from == 0 && !x.exceeds(T::of(**place)));
        let before = before.map(|(_, &value)| T::of(value));
        let all = lines.chain(before);
        all.reduce(T::either).unwrap_or(T::exactly(1.0))
    }

    /// Returns the knots of the lines between the jumps on either side of a driver coordinate, and
    /// all knots for a measured length.
    fn between_jumps(&self, near: f64) -> (usize, usize) {
        let count = self.places.len();
        if !self.is_named {
            return (0, count);
        }
        let jumps = || (0..count).filter(|&k| self.is_jump(k));
        let passed = jumps().rfind(|&k| self.places[k].hi <= near);
        let ahead = jumps().find(|&k| self.places[k].hi > near);
        (passed.map_or(0, |k| k + 1), ahead.map_or(count, |k| k + 1))
    }

    /// Returns `true` if the next knot is at the same coordinate.
    fn is_jump(&self, k: usize) -> bool {
        self.places
            .get(k + 1)
            .is_some_and(|next| next.hi == self.places[k].hi)
    }

    /// Returns the force of a press at a distance from the end of its stroke; `towards` is positive
    /// while it closes. Zero beyond the last knot and on the return stroke.
    pub(super) fn press<T: Number>(&self, distance: T, towards: T) -> T {
        let zero = T::default();
        let Some(&last) = self.places.last() else {
            return zero;
        };
        let last = T::of(last);
        if distance.exceeds(last) || zero.exceeds(towards) {
            return zero;
        }
        let force = self.value(distance);
        if last.exceeds(distance) && towards.exceeds(zero) {
            force
        } else {
            // On the last knot, or at the end of the stroke, rounding decides.
            force.either(zero)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Ball, Double};

    fn curve(knots: &[[f64; 2]], is_rotary: bool) -> ReadyProfile {
        ReadyProfile::new(&Profile::new(knots.to_vec()).unwrap(), is_rotary)
    }

    /// Creates a profile with a single cutting stroke from 80 to 120.
    fn stroke(is_named: bool) -> ReadyProfile {
        let knots = vec![[80.0, 0.0], [80.0, 3.0], [120.0, 5.0], [120.0, 0.0]];
        let profile = Profile::new(knots).unwrap();
        match is_named {
            true => ReadyProfile::over_driver(&profile, true),
            false => ReadyProfile::over_length(&profile),
        }
    }

    fn hill() -> ReadyProfile {
        curve(&[[0.0, 1.0], [10.0, 3.0], [20.0, 0.0]], true)
    }

    #[test]
    fn profile_without_knots_is_one_in_every_arithmetic() {
        let neutral = curve(&[], true);
        assert!(neutral.is_one() && !hill().is_one());
        assert_eq!(neutral.value(7.0), 1.0);
        let ball = neutral.value(Ball::new(7.0, 1.0));
        assert_eq!((ball.mid, ball.radius), (1.0, 0.0));
    }

    #[test]
    fn profile_is_linear_between_knots_and_constant_beyond() {
        for (x, y) in [
            (-5.0, 1.0),
            (0.0, 1.0),
            (5.0, 2.0),
            (10.0, 3.0),
            (15.0, 1.5),
            (99.0, 0.0),
        ] {
            assert_eq!(hill().value(x), y, "{x}");
        }
    }

    /// Knots far apart and close together: the segment equals that of a search from the beginning.
    #[test]
    fn segment_is_found_for_any_knot_spacing() {
        let knots = [
            [-3.0, 1.0],
            [0.0, 2.0],
            [1e-9, 5.0],
            [0.3, 4.0],
            [0.31, 7.0],
            [800.0, -1.0],
        ];
        let curve = curve(&knots, false);
        for k in 0..20_000 {
            let x = -4.0 + f64::from(k).powi(3) * 1e-10;
            let after = knots.partition_point(|knot| knot[0] <= x);
            let want = match after {
                0 => 1.0,
                6 => -1.0,
                k => {
                    let [a, b] = [knots[k - 1], knots[k]];
                    a[1] + (b[1] - a[1]) / (b[0] - a[0]) * (x - a[0])
                }
            };
            assert_eq!(curve.value(x), want, "{x}");
        }
    }

    #[test]
    fn search_starts_close_to_its_segment() {
        let knots: Vec<[f64; 2]> = (5..105).map(|k| [f64::from(k), 0.0]).collect();
        let curve = curve(&knots, false);
        for (k, knot) in knots.iter().enumerate().take(99) {
            let part = ((knot[0] + 0.5 - 5.0) * curve.fineness) as usize;
            assert!(
                (k.saturating_sub(1)..=k).contains(&curve.parts[part]),
                "{k}"
            );
        }
    }

    #[test]
    fn ball_over_knot_contains_both_segments() {
        let ball = hill().value(Ball::new(10.0, 0.5));
        for x in [9.5, 9.75, 10.0, 10.25, 10.5] {
            let y: f64 = hill().value(x);
            assert!((y - ball.mid).abs() <= ball.radius, "{x}: {y} {ball:?}");
        }
    }

    #[test]
    fn only_whole_turns_repeat() {
        let knots = [[0.0, 0.0], [90.0, 9.0], [360.0, 0.0]];
        let (turn, length) = (curve(&knots, true), curve(&knots, false));
        assert_eq!(turn.value(720.0 + 45.0), 4.5);
        assert_eq!(turn.value(-360.0 + 45.0), 4.5);
        assert_eq!(length.value(720.0 + 45.0), 0.0);
        assert_eq!(hill().value(380.0), 0.0);
        let profile = Profile::new(knots.to_vec()).unwrap();
        assert_eq!(ReadyProfile::over_length(&profile).value(720.0 + 45.0), 0.0);
        assert_eq!(
            ReadyProfile::over_driver(&profile, true).value(720.0 + 45.0),
            4.5
        );
    }

    /// Exactly at the jump, the value is that behind it, in every arithmetic.
    #[test]
    fn value_at_jump_is_value_behind_it() {
        for (x, y) in [
            (-1e9, 0.0),
            (80.0_f64.next_down(), 0.0),
            (80.0, 3.0),
            (100.0, 4.0),
            (120.0, 0.0),
            (1e9, 0.0),
        ] {
            for curve in [stroke(true), stroke(false)] {
                assert_eq!(curve.value(x), y, "{x}");
                assert_eq!(curve.value(Double::exactly(x)).hi, y, "{x}");
            }
            let ball = stroke(true).value(Ball::new(x, 0.0));
            assert!(
                (ball.mid - y).abs() <= ball.radius && ball.radius < 1e-14,
                "{x}: {ball:?}"
            );
        }
        let below = 120.0_f64.next_down();
        assert!((stroke(true).value(below) - 5.0).abs() < 1e-14);
    }

    /// A measured length may be on either side.
    #[test]
    fn ball_over_jump_contains_both_sides() {
        for (mid, low, high) in [(80.0, 0.0, 3.0), (120.0, 0.0, 5.0)] {
            let ball = stroke(false).value(Ball::new(mid, 1e-9));
            assert!(
                ball.mid - ball.radius <= low && high <= ball.mid + ball.radius,
                "{ball:?}"
            );
        }
    }

    /// A coordinate whose decimal differs from its double, in either direction.
    #[test]
    fn jump_at_decimal_is_at_its_double() {
        for at in [0.1, 0.3, 80.1, 79.9] {
            let profile = Profile::new(vec![[at, 0.0], [at, 1.0]]).unwrap();
            let curve = ReadyProfile::over_driver(&profile, true);
            for (x, y) in [(at.next_down(), 0.0), (at, 1.0), (at.next_up(), 1.0)] {
                assert_eq!(curve.value(x), y);
                let ball = curve.value(Ball::new(x, 0.0));
                assert!(ball.mid == y && ball.radius < 1e-30, "{x}: {ball:?}");
            }
        }
    }

    #[test]
    fn jumps_repeat_with_turns() {
        let knots = [[0.0, 1.0], [90.0, 1.0], [90.0, 0.0], [360.0, 0.0]];
        let curve = curve(&knots, true);
        for turn in [-720.0, 0.0, 3600.0] {
            for (x, y) in [(0.0, 1.0), (89.0, 1.0), (90.0, 0.0), (359.0, 0.0)] {
                assert_eq!(curve.value(turn + x), y, "{turn} {x}");
            }
        }
    }

    #[test]
    fn press_acts_only_towards_its_end() {
        let curve = curve(&[[0.0, 200.0], [4.0, 100.0]], false);
        assert_eq!(curve.press(2.0, 1.0), 150.0);
        assert_eq!(curve.press(2.0, -1.0), 0.0);
        assert_eq!(curve.press(4.5, 1.0), 0.0);
        assert_eq!(curve.press(0.0, 0.0), 200.0);
        let end = curve.press(Ball::new(0.0, 1e-12), Ball::new(0.0, 1e-12));
        assert!(
            end.radius >= 200.0 - end.mid && end.mid - end.radius <= 0.0,
            "{end:?}"
        );
    }
}
