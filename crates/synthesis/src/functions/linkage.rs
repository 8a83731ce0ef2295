//! A function-generating linkage and its output at a crank angle.

use crate::Output;
use kinematics::Vec2;

/// Maximum length relative to the size, and the inverse of the minimum: beyond these limits the
/// linkage could not be built.
const MAX_COUNT: f64 = 1e6;

/// A crank at the origin with its follower. For an angle, the other pivot is at (1, 0), and the
/// output is the angle of the link on it. For a slide, the crank is 1 long, and the output is the
/// pin's x on the line y = `third`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FunctionLinkage {
    pub(super) output: Output,
    /// Negative if the link is opposite to its angle, which is a datum turned by 180 deg.
    pub(super) crank: f64,
    pub(super) coupler: f64,
    /// The link on the other pivot, signed like the crank; for a slide, the y of its line.
    pub(super) third: f64,
}

/// An output, by how much the linkage fails to close, and the derivatives of both with respect to
/// crank, coupler, third and the crank's angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct OutputReach {
    pub(super) output: f64,
    pub(super) by: [f64; 4],
    /// 0 if the linkage closes. If not, the output is that of the nearest dead point.
    pub(super) short: f64,
    pub(super) shortfall: [f64; 4],
}

impl FunctionLinkage {
    /// Returns `true` if the linkage can be built.
    pub(super) fn is_valid(&self) -> bool {
        let is_length = |l: f64| l.abs() < MAX_COUNT && l.abs() > 1.0 / MAX_COUNT;
        let third = match self.output {
            Output::Angle => is_length(self.third),
            Output::Slide => self.third.abs() < MAX_COUNT,
        };
        is_length(self.crank) && self.coupler > 0.0 && is_length(self.coupler) && third
    }

    /// Returns the ratio of the longest length to the shortest. A slide's line does not count,
    /// since it may go through the pivot.
    pub(super) fn ratio(&self) -> f64 {
        let third = match self.output {
            Output::Angle => self.third.abs(),
            Output::Slide => 1.0,
        };
        let lengths = [1.0, self.crank.abs(), self.coupler, third];
        let longest = lengths.into_iter().fold(0.0, f64::max);
        longest / lengths.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Returns the position of the crank's pin; the angle is in radians.
    pub(super) fn b(&self, angle: f64) -> Vec2 {
        let (sin, cos) = angle.sin_cos();
        Vec2::new(self.crank * cos, self.crank * sin)
    }

    /// Returns the position of the coupler's other pin.
    pub(super) fn c(&self, output: f64) -> Vec2 {
        match self.output {
            Output::Angle => {
                let (sin, cos) = output.sin_cos();
                Vec2::new(1.0 + self.third * cos, self.third * sin)
            }
            Output::Slide => Vec2::new(output, self.third),
        }
    }

    /// Returns the side of the crank's pin on which an output lies, 1 or -1: seen from the other
    /// pivot, or along the line.
    pub(super) fn side(&self, angle: f64, output: f64) -> f64 {
        let b = self.b(angle);
        let across = match self.output {
            Output::Angle => (b - Vec2::new(1.0, 0.0)).cross(Vec2::new(output.cos(), output.sin())),
            Output::Slide => output - b.x,
        };
        if across < 0.0 { -1.0 } else { 1.0 }
    }

    /// Returns the output on a side at a crank angle in radians; `None` if the linkage does not
    /// close.
    pub(super) fn output(&self, angle: f64, side: f64) -> Option<f64> {
        let reach = self.reach(angle, side);
        (reach.short == 0.0 && reach.output.is_finite()).then_some(reach.output)
    }

    /// Computes the output on a side with its derivatives. With u from D to B and r = |u|, the
    /// rocker's angle psi satisfies
    ///   cos(psi - arg u) = k = (r^2 + c^2 - b^2) / (2 r c),   psi = arg u + side acos k,
    /// and the slide's position t, with h = b^2 - (e - By)^2, is
    ///   t = Bx + side sqrt h.
    pub(super) fn reach(&self, angle: f64, side: f64) -> OutputReach {
        let (sin, cos) = angle.sin_cos();
        // B and its derivatives with respect to the crank and its angle.
        let pin = Vec2::new(self.crank * cos, self.crank * sin);
        let moves = [Vec2::new(cos, sin), pin.perp()];
        match self.output {
            Output::Angle => self.reach_of_rocker(pin - Vec2::new(1.0, 0.0), moves, side),
            Output::Slide => self.reach_of_slide(pin, moves, side),
        }
    }

    fn reach_of_rocker(&self, u: Vec2, moves: [Vec2; 2], side: f64) -> OutputReach {
        let (b, c, r) = (self.coupler, self.third, u.norm());
        let k = (r * r + c * c - b * b) / (2.0 * r * c);
        let turns = moves.map(|m| u.cross(m) / (r * r));
        let ranges = moves.map(|m| u.dot(m) / r * (1.0 / c - k / r));
        let by_k = [ranges[0], -b / (r * c), 1.0 / r - k / c, ranges[1]];
        let excess = k.abs() - 1.0;
        let arc = -side / (1.0 - k * k).sqrt();
        let closes = excess <= 0.0;
        let weight = if closes && k.abs() < 1.0 { arc } else { 0.0 };
        let turned = [turns[0], 0.0, 0.0, turns[1]];
        OutputReach {
            output: u.y.atan2(u.x) + side * k.clamp(-1.0, 1.0).acos(),
            by: std::array::from_fn(|i| turned[i] + weight * by_k[i]),
            short: if closes { 0.0 } else { excess },
            shortfall: by_k.map(|d| if closes { 0.0 } else { d * k.signum() }),
        }
    }

    fn reach_of_slide(&self, pin: Vec2, moves: [Vec2; 2], side: f64) -> OutputReach {
        let rise = self.third - pin.y;
        let h = self.coupler * self.coupler - rise * rise;
        let by_h = [
            2.0 * rise * moves[0].y,
            2.0 * self.coupler,
            -2.0 * rise,
            2.0 * rise * moves[1].y,
        ];
        let closes = h >= 0.0;
        let weight = if h > 0.0 { 0.5 * side / h.sqrt() } else { 0.0 };
        let along = [moves[0].x, 0.0, 0.0, moves[1].x];
        OutputReach {
            output: pin.x + side * h.max(0.0).sqrt(),
            by: std::array::from_fn(|i| along[i] + weight * by_h[i]),
            short: if closes { 0.0 } else { -h },
            shortfall: by_h.map(|d| if closes { 0.0 } else { -d }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kinematics::numeric::SeededRng;

    #[test]
    fn derivatives_match_difference_quotients() {
        let mut rng = SeededRng::new(7);
        let mut closed = 0;
        for round in 0..2000 {
            let output = if round % 2 == 0 {
                Output::Angle
            } else {
                Output::Slide
            };
            let mut numbers: [f64; 4] = std::array::from_fn(|_| 1.5 * rng.even());
            numbers[1] = numbers[1].abs() + 0.3;
            let linkage = |n: [f64; 4]| FunctionLinkage {
                output,
                crank: n[0],
                coupler: n[1],
                third: n[2],
            };
            let side = if round % 4 < 2 { 1.0 } else { -1.0 };
            let at = |n: [f64; 4]| linkage(n).reach(n[3], side);
            let here = at(numbers);
            closed += u32::from(here.short == 0.0);
            for i in 0..4 {
                let step = 1e-6;
                let [mut above, mut below] = [numbers; 2];
                above[i] += step;
                below[i] -= step;
                let (above, below) = (at(above), at(below));
                if (above.short == 0.0) != (below.short == 0.0) || numbers[2].abs() < 0.05 {
                    continue;
                }
                let slope = super::super::task::wrapped(above.output - below.output) / step / 2.0;
                let size = 1.0 + here.by[i].abs().powi(3);
                assert!((slope - here.by[i]).abs() < 1e-5 * size, "{round} {i}");
                let slope = (above.short - below.short) / step / 2.0;
                let size = 1.0 + here.shortfall[i].abs().powi(2);
                assert!(
                    (slope - here.shortfall[i]).abs() < 1e-5 * size,
                    "{round} {i}"
                );
            }
        }
        assert!((500..1900).contains(&closed), "{closed}");
    }
}
