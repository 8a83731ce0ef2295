//! Sorts the crank's angles if points are out of order by no more than their noise.
//!
//! A point next to the curve is met best at its foot, and the feet of neighbouring points may have
//! the opposite order. An isotonic regression gives the nearest monotonic angles: neighbours out of
//! order share the mean of their angles (pool adjacent violators: Ayer et al., 1955), each weighted
//! by how fast the tracer leaves its foot.

use super::descent::Fit;
use super::task::TargetPath;

/// Maximum factor by which sorting may increase the mean square. A larger increase is not noise but
/// another order.
const COSTS: f64 = 4.0;
/// Mean square of misses below which only rounding remains.
const ROUNDING: f64 = 1e-20;
/// Step of the crank for the tracer's difference quotient, in degrees.
const STEP: f64 = 1e-3;

/// Neighbours with a common angle.
struct AnglePool {
    weight: f64,
    angle: f64,
    count: usize,
}

impl Fit {
    /// Sorts the crank's angles if this costs little; if not, leaves them unchanged.
    pub(super) fn sort_angles(&mut self, target: &TargetPath) {
        let ends = self.angles.first().zip(self.angles.last());
        let (Some((first, last)), None) = (ends, &target.turns) else {
            return;
        };
        let sense = if last < first { -1.0 } else { 1.0 };
        let is_ordered = |pair: &[f64]| (pair[1] - pair[0]) * sense >= 0.0;
        if self.angles.windows(2).all(is_ordered) {
            return;
        }
        let angles = self.ordered_angles(target, sense);
        let square: f64 = (target.points.iter().zip(&target.weights))
            .zip(&angles)
            .map(|((point, weight), angle)| {
                let [_, _, tracer] = self.places(*angle);
                weight * (*point - tracer).norm2()
            })
            .sum();
        if square <= COSTS * self.square + ROUNDING {
            self.angles = angles;
            self.square = square;
        }
    }

    fn ordered_angles(&self, target: &TargetPath, sense: f64) -> Vec<f64> {
        let mut pools: Vec<AnglePool> = Vec::with_capacity(self.angles.len());
        for (&angle, weight) in self.angles.iter().zip(&target.weights) {
            let [ahead, after] = [STEP, -STEP].map(|step| self.places(angle + step)[2]);
            let mut pool = AnglePool {
                // A point of zero weight, or of zero velocity, still has an angle.
                weight: (weight * (ahead - after).norm2()).max(f64::MIN_POSITIVE),
                angle,
                count: 1,
            };
            while let Some(before) =
                pools.pop_if(|before| (pool.angle - before.angle) * sense < 0.0)
            {
                let weight = before.weight + pool.weight;
                pool.angle += (before.angle - pool.angle) * (before.weight / weight);
                pool.weight = weight;
                pool.count += before.count;
            }
            pools.push(pool);
        }
        let shared = pools.iter();
        shared
            .flat_map(|pool| std::iter::repeat_n(pool.angle, pool.count))
            .collect()
    }
}
