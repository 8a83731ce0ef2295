//! Defines points that lead, and the motion of a point over time.

use super::spline::ClampedSpline;
use super::{CoordinateAxis, PointId};
use crate::Vec2;
use crate::angle::{self, TURN};

/// Coordinates of points that lead, and the inputs that follow them.
#[derive(Clone, Debug, PartialEq)]
pub struct PointLead {
    /// The leading coordinates.
    pub coordinates: Vec<(PointId, CoordinateAxis)>,
    /// The inputs that follow, by their index; as many as coordinates.
    pub inputs: Vec<usize>,
}

/// The position of a point as a function of time, in the scene's length unit and s.
#[derive(Clone, Debug, PartialEq)]
pub enum PointPath {
    /// Curves through knots of time and of each coordinate, at rest at both ends.
    Knots {
        /// The knots of x.
        x: ClampedSpline,
        /// The knots of y, at the same times.
        y: ClampedSpline,
    },
    /// A circle at constant speed.
    Circle(PointCircle),
}

/// A circle passed at constant speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointCircle {
    /// The centre.
    pub centre: Vec2,
    /// The radius, above 0.
    pub radius: f64,
    /// The direction from the centre to the point at 0 s, in degrees.
    pub angle: f64,
    /// The speed of that direction in rad/s, not 0; counter-clockwise if positive.
    pub speed: f64,
}

impl PointPath {
    /// Creates a path through rows of time, x and y. Returns `None` for fewer than two, if the time
    /// does not increase, or if a number, a speed or an acceleration is not finite.
    #[must_use]
    pub fn through(rows: &[[f64; 3]]) -> Option<PointPath> {
        let [x, y] = [1, 2].map(|k| {
            let knots = rows.iter().map(|row| [row[0], row[k]]);
            ClampedSpline::new(knots.collect())
        });
        let (x, y) = (x?, y?);
        let is_finite = |along: &ClampedSpline| {
            let mut knots = along.knots().iter().flat_map(|knot| along.at(knot[0]));
            knots.all(f64::is_finite)
        };
        (is_finite(&x) && is_finite(&y)).then_some(PointPath::Knots { x, y })
    }

    /// Returns the times at which the path begins and ends, in s; a circle ends after one turn.
    #[must_use]
    pub fn span(&self) -> [f64; 2] {
        match self {
            PointPath::Knots { x, .. } => x.ends().map(|knot| knot[0]),
            PointPath::Circle(circle) => [0.0, angle::radians(TURN) / circle.speed.abs()],
        }
    }

    /// Returns the end of the smooth part of the path from one time towards another: the next knot
    /// before `to`, or `to`.
    pub(crate) fn smooth_end(&self, from: f64, to: f64) -> f64 {
        let PointPath::Knots { x, .. } = self else {
            return to;
        };
        let knots = x.knots().iter().map(|knot| knot[0]);
        match from <= to {
            true => knots.filter(|&at| from < at).fold(to, f64::min),
            false => knots.filter(|&at| at < from).fold(to, f64::max),
        }
    }

    /// Returns three points whose convex hull, with the position at `from`, contains the path between
    /// two times of one smooth part. The last one is the position at `to`. A circle is contained
    /// except for a millionth of its radius, if it turns by at most 6 degrees.
    pub(crate) fn controls(&self, from: f64, to: f64) -> [Vec2; 3] {
        let [begin, leaving, _] = self.at(from);
        let [end, arriving, _] = self.at(to);
        let third = (to - from) / 3.0;
        [begin + leaving * third, end - arriving * third, end]
    }

    /// Returns `true` if the path ends where it begins.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        match self {
            PointPath::Knots { x, y } => [x, y].iter().all(|along| {
                let [first, last] = along.ends();
                first[1] == last[1]
            }),
            PointPath::Circle(_) => true,
        }
    }

    /// Returns the position at a time, and its first and second derivative by time. Before and after
    /// the knots the point is at rest; a circle continues.
    #[must_use]
    pub fn at(&self, time: f64) -> [Vec2; 3] {
        match self {
            PointPath::Knots { x, y } => {
                let [first, last] = self.span();
                let [x, y] = [x, y].map(|along| along.at(time));
                let [at, speed, bend] = [0, 1, 2].map(|k| Vec2::new(x[k], y[k]));
                match first <= time && time <= last {
                    true => [at, speed, bend],
                    false => [at, Vec2::ZERO, Vec2::ZERO],
                }
            }
            PointPath::Circle(circle) => {
                let turned = circle.angle + circle.speed.to_degrees() * time;
                let arm = angle::unit(turned) * circle.radius;
                let speed = arm.perp() * circle.speed;
                [circle.centre + arm, speed, speed.perp() * circle.speed]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn path_of_two_rows_is_a_line_from_rest_to_rest() {
        let path = PointPath::through(&[[1.0, 10.0, 20.0], [3.0, 30.0, 0.0]]).unwrap();
        assert_eq!(path.span(), [1.0, 3.0]);
        assert!(!path.is_closed());
        let [at, speed, acceleration] = path.at(2.0);
        assert_eq!((at.x, at.y), (20.0, 10.0));
        // 3/2 of the mean speed in the middle.
        assert_eq!((speed.x, speed.y), (15.0, -15.0));
        assert_eq!((acceleration.x, acceleration.y), (0.0, 0.0));
        let [at, speed, acceleration] = path.at(5.0);
        assert_eq!(
            [at, speed, acceleration],
            [Vec2::new(30.0, 0.0), Vec2::ZERO, Vec2::ZERO]
        );
        assert_eq!(
            PointPath::through(&[[1.0, 10.0, 20.0], [1.0, 30.0, 0.0]]),
            None
        );
    }

    #[test]
    fn circle_has_centripetal_acceleration() {
        let circle = PointCircle {
            centre: Vec2::new(5.0, -1.0),
            radius: 2.0,
            angle: 90.0,
            speed: -3.0,
        };
        let path = PointPath::Circle(circle);
        assert!(path.is_closed());
        let [at, speed, acceleration] = path.at(0.0);
        assert_eq!([at.x, at.y, speed.x, speed.y], [5.0, 1.0, 6.0, 0.0]);
        assert_eq!([acceleration.x, acceleration.y], [0.0, -18.0]);
        let [_, end] = path.span();
        assert!((path.at(end)[0] - at).norm() < 1e-14);
    }
}
