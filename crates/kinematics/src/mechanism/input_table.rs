//! Defines tables by which an input follows the driver.

use super::spline::{Spline, SplineEnds};
use crate::angle::TURN;
use std::sync::Arc;

/// Tolerance for comparing turns and values, in multiples of the machine epsilon, because typed
/// values are rounded.
const EQUALITY_TOLERANCE: f64 = 4.0;

/// An input's coordinate as a function of the driver's: a cubic spline through knots, with
/// continuous first and second derivatives.
///
/// An open table is at rest at both ends, and the motion ends there. A closed table spans whole
/// turns of a driven link and repeats, with continuous derivatives across the seam.
#[derive(Clone, Debug, PartialEq)]
pub struct InputTable {
    curve: Arc<Spline>,
    /// The period of a closed table, in degrees.
    period: Option<f64>,
}

impl InputTable {
    /// Creates an open table through knots of the driver's coordinate and the input's, in degrees
    /// or the scene's length unit.
    ///
    /// Returns `None` for fewer than two knots, if the driver's coordinate does not increase, or if
    /// a number is not finite.
    #[must_use]
    pub fn open(knots: Vec<[f64; 2]>) -> Option<InputTable> {
        let curve = Spline::new(knots, SplineEnds::AtRest)?;
        let (curve, period) = (Arc::new(curve), None);
        Some(InputTable { curve, period })
    }

    /// Creates a closed table, with knots as for [`InputTable::open`]. Also returns `None` if the
    /// knots do not span whole turns.
    ///
    /// The last value must equal the first, for a turned link up to whole turns: see
    /// [`InputTable::is_closed`].
    #[must_use]
    pub fn closed(knots: Vec<[f64; 2]>) -> Option<InputTable> {
        let curve = Spline::new(knots, SplineEnds::Closed)?;
        let [first, last] = curve.ends();
        let period = Some(whole_turns(first[0], last[0]).filter(|&turns| turns > 0.0)?);
        let curve = Arc::new(curve);
        Some(InputTable { curve, period })
    }

    /// Returns the knots as given.
    #[must_use]
    pub fn knots(&self) -> &[[f64; 2]] {
        self.curve.knots()
    }

    /// Returns the second derivatives at the knots.
    pub fn bends(&self) -> &[f64] {
        self.curve.bends()
    }

    /// Returns the period in degrees of the driver, or `None` for an open table.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.period
    }

    /// Returns the driver's coordinates at which the table begins and ends.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        self.curve.ends().map(|knot| knot[0])
    }

    /// Returns `true` if the last value equals the first; for a turned link, up to whole turns.
    #[must_use]
    pub fn is_closed(&self, is_rotary: bool) -> bool {
        let [first, last] = self.curve.ends().map(|knot| knot[1]);
        match whole_turns(first, last) {
            Some(way) => is_rotary || way == 0.0,
            None => false,
        }
    }

    /// Returns the input's coordinate at a coordinate of the driver, and its first two derivatives
    /// by the driver's coordinate, in the units of the knots. Beyond an open end, the coordinate is
    /// constant.
    #[must_use]
    pub fn at(&self, place: f64) -> [f64; 3] {
        let [first, last] = self.curve.ends();
        let Some(period) = self.period else {
            let [value, slope, bend] = self.curve.at(place);
            let is_beyond = place < first[0] || place > last[0];
            return if is_beyond {
                [value, 0.0, 0.0]
            } else {
                [value, slope, bend]
            };
        };
        let times = ((place - first[0]) / period).floor();
        let [value, slope, bend] = self.curve.at(place - times * period);
        [value + times * (last[1] - first[1]), slope, bend]
    }
}

/// Returns `to - from` as whole turns in degrees, or `None` if it differs from whole turns by more
/// than rounding errors.
fn whole_turns(from: f64, to: f64) -> Option<f64> {
    let way = TURN * ((to - from) / TURN).round();
    let slack = EQUALITY_TOLERANCE * f64::EPSILON * from.abs().max(to.abs());
    ((to - from) - way).abs().le(&slack).then_some(way)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_table_needs_whole_turns_and_equal_ends() {
        let closed = |knots: &[[f64; 2]]| InputTable::closed(knots.to_vec());
        let rocks = closed(&[[0.1, 20.0], [180.0, 70.0], [360.1, 20.0]]).unwrap();
        assert_eq!(rocks.period(), Some(360.0));
        assert!(rocks.is_closed(false) && rocks.is_closed(true));
        let turns = closed(&[[0.0, 0.1], [500.0, 30.0], [720.0, 360.1]]).unwrap();
        assert_eq!(turns.period(), Some(720.0));
        assert!(!turns.is_closed(false) && turns.is_closed(true));
        let jumps = closed(&[[0.0, 0.0], [360.0, 10.0]]).unwrap();
        assert!(!jumps.is_closed(true));
        assert_eq!(closed(&[[0.0, 0.0], [300.0, 0.0]]), None);
        assert_eq!(closed(&[[0.0, 0.0], [0.0, 0.0]]), None);
    }

    /// Value, slope and second derivative agree on both sides of the point where the table repeats.
    #[test]
    fn closed_table_is_smooth_where_it_repeats() {
        let knots = vec![[-30.0, 5.0], [40.0, 90.0], [200.0, 60.0], [330.0, 365.0]];
        let table = InputTable::closed(knots.clone()).unwrap();
        for (place, turns) in [(330.0, 0.0), (-30.0, -1.0), (690.0, 1.0)] {
            let by = 1e-9;
            let [before, after] = [table.at(place - by), table.at(place + by)];
            assert!(
                (before[0] - 365.0 - 360.0 * turns).abs() < 1e-7,
                "{before:?}"
            );
            for (one, other) in before.into_iter().zip(after) {
                assert!((one - other).abs() < 1e-7, "{one} {other} at {place}");
            }
        }
        for [place, value] in knots {
            assert!((table.at(place)[0] - value).abs() < 1e-12);
            assert!((table.at(place + 720.0)[0] - value - 720.0).abs() < 1e-12);
        }
    }

    /// Two knots one turn apart define a ratio.
    #[test]
    fn two_knots_a_turn_apart_give_line() {
        let table = InputTable::closed(vec![[0.0, 15.0], [360.0, -705.0]]).unwrap();
        assert_eq!(table.at(90.0), [-165.0, -2.0, 0.0]);
        assert_eq!(table.at(-90.0), [195.0, -2.0, 0.0]);
    }

    #[test]
    fn open_table_is_constant_beyond_its_ends() {
        let table = InputTable::open(vec![[1.0, 2.0], [3.0, 8.0]]).unwrap();
        assert_eq!(table.at(0.0), [2.0, 0.0, 0.0]);
        assert_eq!(table.at(2.0)[..2], [5.0, 4.5]);
        assert_eq!(table.at(9.0), [8.0, 0.0, 0.0]);
        assert!(table.at(1.0)[2] > 0.0);
    }
}
