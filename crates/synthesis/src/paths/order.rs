//! The crank's angles where points lie out of their order by no more than their noise.
//!
//! A point beside the curve is met best at its foot, and feet of neighbouring points may lie the other way round. The
//! nearest angles that go one way are those of an isotonic regression: neighbours that are out of order share the mean
//! of their angles (pool adjacent violators: Ayer et al., 1955), each weighed by how fast the tracer leaves its foot.

use super::descent::Fit;
use super::wanted::WantedPath;

/// By how much more a linkage may miss in order, in mean squares: what costs more is no noise, but another order.
const COSTS: f64 = 4.0;
/// A mean square of misses below this is rounding.
const ROUNDING: f64 = 1e-20;
/// Degrees by which the tracer is followed on its way.
const STEP: f64 = 1e-3;

/// Neighbours that share an angle.
struct AnglePool {
    weight: f64,
    angle: f64,
    count: usize,
}

impl Fit {
    /// Puts the crank's angles in order where that costs little; else leaves them.
    pub(super) fn put_in_order(&mut self, wanted: &WantedPath) {
        let ends = self.angles.first().zip(self.angles.last());
        let (Some((first, last)), None) = (ends, &wanted.turns) else {
            return;
        };
        let sense = if last < first { -1.0 } else { 1.0 };
        let is_ordered = |pair: &[f64]| (pair[1] - pair[0]) * sense >= 0.0;
        if self.angles.windows(2).all(is_ordered) {
            return;
        }
        let angles = self.ordered_angles(wanted, sense);
        let square: f64 = (wanted.points.iter().zip(&wanted.weights))
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

    fn ordered_angles(&self, wanted: &WantedPath, sense: f64) -> Vec<f64> {
        let mut pools: Vec<AnglePool> = Vec::with_capacity(self.angles.len());
        for (&angle, weight) in self.angles.iter().zip(&wanted.weights) {
            let [ahead, behind] = [STEP, -STEP].map(|step| self.places(angle + step)[2]);
            let mut pool = AnglePool {
                // A point that counts for nothing, or stands, still has an angle.
                weight: (weight * (ahead - behind).norm2()).max(f64::MIN_POSITIVE),
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
