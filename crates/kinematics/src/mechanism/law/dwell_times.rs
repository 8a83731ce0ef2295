//! Finds the times at which a driver that moves by a law is at a coordinate.

use super::{MotionLaw, ROUNDING, TimedStep};

/// Number of bisections within an interval of time in which a coordinate is passed once.
const HALVINGS: u32 = 60;

/// The interval of time, in s, during which a driver is at a coordinate; a single moment unless it
/// dwells.
type DwellInterval = [f64; 2];

impl TimedStep {
    /// Returns the times, measured from the step's beginning, between which the coordinate is
    /// monotonic.
    fn turns(&self) -> Vec<f64> {
        match self {
            TimedStep::Law { time, .. } => vec![0.0, *time],
            TimedStep::Table(spline) => {
                let mut turns = vec![0.0];
                turns.extend(spline.turns());
                turns.push(spline.ends()[1][0]);
                turns
            }
            TimedStep::Sine(sine) => {
                let within = sine.turns().into_iter().filter(|&turn| turn > 0.0);
                std::iter::once(0.0)
                    .chain(within)
                    .chain([sine.time])
                    .collect()
            }
        }
    }
}

impl MotionLaw {
    /// Returns the intervals of the first period on which the coordinate is monotonic.
    pub(super) fn stretches(&self) -> impl Iterator<Item = [f64; 2]> {
        let starts = std::iter::once(0.0).chain(self.joints());
        let steps = self.steps.iter().zip(starts.zip(self.joints()));
        steps.flat_map(|(step, (start, end))| {
            let mut turns = step
                .turns()
                .into_iter()
                .map(|turn| start + turn)
                .collect::<Vec<_>>();
            // A step ends where the next one begins, which can differ by rounding from the end of
            // its own time.
            if let Some(last) = turns.last_mut() {
                *last = end;
            }
            let pairs: Vec<[f64; 2]> = turns.windows(2).map(|pair| [pair[0], pair[1]]).collect();
            pairs
        })
    }

    /// Returns the coordinate in the first period; at its end, the coordinate reached.
    fn coordinate(&self, time: f64) -> f64 {
        match self.steps.last() {
            Some(last) if time >= self.period() => last.to(),
            Some(_) | None => self.at(time).at,
        }
    }

    /// Returns the intervals during which the driver is at a coordinate in its first period, which
    /// begins at 0 s.
    pub(super) fn stays(&self, coordinate: f64) -> Vec<DwellInterval> {
        let mut stays = Vec::new();
        for [before, after] in self.stretches() {
            let [low, high] = [before, after].map(|time| self.coordinate(time));
            match (low == coordinate, high == coordinate) {
                (true, true) => stays.push([before, after]),
                (true, false) => stays.push([before; 2]),
                (false, true) => stays.push([after; 2]),
                (false, false) if (low < coordinate) == (high < coordinate) => {}
                (false, false) => stays.push([self.crossing([before, after], coordinate); 2]),
            }
        }
        stays
    }

    /// Finds by bisection the time at which an interval's coordinate crosses the given one. The
    /// interval must begin and end on different sides of it.
    fn crossing(&self, [mut before, mut after]: [f64; 2], coordinate: f64) -> f64 {
        let is_below = self.coordinate(before) < coordinate;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (before + after);
            let is_past = (self.coordinate(middle) < coordinate) != is_below;
            *(if is_past { &mut after } else { &mut before }) = middle;
        }
        after
    }

    /// Returns the first time at which the driver leaves the range `[low, high]`, and the end that
    /// it passes. The driver must begin in the range; reaching an end, up to rounding errors, does
    /// not leave it.
    #[must_use]
    pub fn exit_interval(&self, [low, high]: [f64; 2]) -> Option<[f64; 2]> {
        let slack = ROUNDING * (high - low);
        self.stretches().find_map(|stretch| {
            let end = self.coordinate(stretch[1]);
            let passed = match end {
                _ if end > high + slack => high,
                _ if end < low - slack => low,
                _ => return None,
            };
            let begins_there = self.coordinate(stretch[0]) == passed;
            let time = match begins_there {
                true => stretch[0],
                false => self.crossing(stretch, passed),
            };
            Some([time, passed])
        })
    }

    /// Returns the minimum and the maximum coordinate of the first period.
    #[must_use]
    pub fn reach(&self) -> [f64; 2] {
        let ends = self.stretches().map(|[_, end]| self.coordinate(end));
        ends.fold([self.start; 2], |[low, high], at| {
            [low.min(at), high.max(at)]
        })
    }

    /// Returns the times of the first period at which the driver arrives at a coordinate and those
    /// at which it leaves the coordinate after a dwell.
    pub fn meets(&self, coordinate: f64) -> impl Iterator<Item = f64> {
        self.stays(coordinate).into_iter().flatten()
    }

    /// Returns the time nearest to `time` at which the driver is at a coordinate. If the motion
    /// returns to its start, only the period of `time` is searched. Returns `None` if the driver is
    /// never there.
    #[must_use]
    pub fn nearest(&self, coordinate: f64, time: f64) -> Option<f64> {
        let periods = match self.advance == 0.0 {
            true => vec![(time / self.period()).floor()],
            // A motion that advances may reverse a little within a period.
            false => {
                let period = ((coordinate - self.start) / self.advance).floor();
                [-1.0, 0.0, 1.0].map(|by| period + by).to_vec()
            }
        };
        let times = periods.into_iter().flat_map(|period| {
            let stays = self.stays(coordinate - period * self.advance);
            let started = period * self.period();
            let nearest =
                move |[from, to]: DwellInterval| (time - started).max(from).min(to) + started;
            stays.into_iter().map(nearest)
        });
        times.min_by(|a, b| (a - time).abs().total_cmp(&(b - time).abs()))
    }

    /// Returns the first time from `low` to `high` at which the driver is at a coordinate.
    #[must_use]
    pub fn first(&self, coordinate: f64, [low, high]: [f64; 2]) -> Option<f64> {
        let periods = [low, high].map(|time| (time / self.period()).floor());
        let mut period = periods[0];
        while period <= periods[1] {
            let started = period * self.period();
            let stays = self.stays(coordinate - period * self.advance).into_iter();
            let within = stays.map(|stay| stay.map(|time| time + started));
            let mut within = within.filter(|[from, to]| *from <= high && *to >= low);
            if let Some([from, _]) = within.next() {
                return Some(from.max(low));
            }
            period += 1.0;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{near, step};
    use super::*;
    use crate::{ClampedSpline, StepLaw};

    /// Creates a law: 120 degrees forwards in 0.5 s, 0.25 s at rest, and back in 0.25 s.
    fn oscillate() -> MotionLaw {
        let steps = vec![
            step(StepLaw::Harmonic, 120.0, 0.5),
            step(StepLaw::Constant, 120.0, 0.25),
            step(StepLaw::Harmonic, 0.0, 0.25),
        ];
        MotionLaw::new(0.0, steps, true).unwrap()
    }

    #[test]
    fn nearest_time_of_coordinate_is_found() {
        let law = oscillate();
        for (time, found) in [
            (0.0, 0.25),
            (0.5, 0.25),
            (0.75, 0.875),
            (3.8, 3.875),
            (-0.1, -0.125),
        ] {
            near(law.nearest(60.0, time).unwrap(), found);
        }
        // At rest the current time is returned; at an end the motion reverses.
        assert_eq!(law.nearest(120.0, 0.625), Some(0.625));
        assert_eq!(law.nearest(120.0, 0.1), Some(0.5));
        assert_eq!(law.nearest(0.0, 0.9), Some(1.0));
        assert_eq!(law.nearest(120.5, 0.5), None);
        near(law.first(60.0, [0.3, 2.0]).unwrap(), 0.875);
        assert_eq!(law.first(120.0, [0.6, 2.0]), Some(0.6));
        assert_eq!(law.first(60.0, [0.3, 0.8]), None);
    }

    #[test]
    fn leaving_limits_has_time_and_coordinate() {
        let law = oscillate();
        let [time, at] = law.exit_interval([-10.0, 60.0]).unwrap();
        near(time, 0.25);
        assert_eq!(at, 60.0);
        assert_eq!(law.exit_interval([0.0, 120.0]), None);
        let down = vec![
            step(StepLaw::Constant, 90.0, 1.0),
            step(StepLaw::Constant, -30.0, 1.0),
            step(StepLaw::Constant, 0.0, 1.0),
        ];
        // The motion only touches one limit and passes the other: 90 to 0 of 120 in 1 s.
        let law = MotionLaw::new(0.0, down, false).unwrap();
        let [time, at] = law.exit_interval([0.0, 90.0]).unwrap();
        near(time, 1.75);
        assert_eq!(at, 0.0);
    }

    #[test]
    fn advancing_motion_meets_coordinate_once() {
        let law = MotionLaw::new(30.0, vec![step(StepLaw::Cycloidal, 390.0, 2.0)], true).unwrap();
        for (at, time) in [(30.0, 0.0), (210.0, 1.0), (930.0, 5.0), (-150.0, -1.0)] {
            near(law.nearest(at, 0.3).unwrap(), time);
        }
    }

    /// Through (0.5, 30) the motion exceeds its end coordinates of 20, and is at 25 when rising and
    /// when falling.
    #[test]
    fn table_meets_coordinate_on_either_side_of_peak() {
        let knots = vec![[0.0, 20.0], [0.5, 30.0], [0.6, 29.0], [1.0, 20.0]];
        let table = TimedStep::Table(ClampedSpline::new(knots).unwrap());
        let law = MotionLaw::new(20.0, vec![table], false).unwrap();
        let [up, down] = [0.0, 1.0].map(|time| law.nearest(25.0, time).unwrap());
        assert!(up < 0.5 && down > 0.6, "{up} {down}");
        near(law.at(up).at, 25.0);
        near(law.at(down).at, 25.0);
    }
}
