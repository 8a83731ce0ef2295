//! Scales arrows by one factor over the whole motion.

use super::extents::Extents;
use crate::Vec2;
use crate::drawing::bounds::Bounds;

/// The longest arrow as a fraction of the diagonal of all the linkage's positions.
const MAX_LEN: f64 = 0.2;

/// The factor by which the longest arrow may exceed the upper quartile; longer ones are cut. Rates
/// and forces grow without bound close to a dead point, and would make the others invisible.
const OUTLIER_FACTOR: f64 = 3.0;

/// The scale of arrows of one kind.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::drawing) struct ArrowScale {
    /// The magnitude that the longest arrow shows.
    most: f64,
    /// The drawing's units of length per unit of the magnitude.
    per: f64,
}

/// The driver's coordinate, an arrow's tail there, and its vector.
pub(in crate::drawing) type MovingArrow = (f64, Vec2, Vec2);

/// Returns the length of the longest arrow in a drawing of these extents.
pub(in crate::drawing) fn longest(extents: &Extents) -> f64 {
    MAX_LEN * extents.bounds().size().norm()
}

impl ArrowScale {
    /// Computes the scale at which the longest of a motion's arrows has the length `longest`;
    /// appends the arrows' tips to `tips`.
    pub(in crate::drawing) fn of_motion(
        arrows: &[MovingArrow],
        longest: f64,
        tips: &mut Vec<(f64, Bounds)>,
    ) -> ArrowScale {
        let scale = ArrowScale::of(arrows.iter().map(|(.., size)| size.norm()), longest);
        tips.extend(arrows.iter().map(|&(at, from, size)| {
            let mut tip = Bounds::default();
            tip.include(scale.tip(from, size, 1.0).0);
            (at, tip)
        }));
        scale
    }

    fn of(sizes: impl Iterator<Item = f64>, longest: f64) -> ArrowScale {
        let maximum = typical_max(sizes.collect());
        let per = if maximum > 0.0 {
            longest / maximum
        } else {
            0.0
        };
        ArrowScale { most: maximum, per }
    }

    /// Returns the length of an arrow of magnitude 1, on a drawing enlarged by `zoom`.
    pub(in crate::drawing) fn per(self, zoom: f64) -> f64 {
        self.per / zoom
    }

    /// Returns the magnitude that the longest arrow shows.
    pub(in crate::drawing) fn longest_magnitude(self) -> f64 {
        self.most
    }

    /// Returns the tip of an arrow at a point, and `true` if it was cut.
    pub(in crate::drawing) fn tip(self, from: Vec2, size: Vec2, zoom: f64) -> (Vec2, bool) {
        let norm = size.norm();
        // The rounding error of the longest arrow must not break it.
        let cut = norm > self.most * (1.0 + 1e-9);
        let shown = if cut { size * (self.most / norm) } else { size };
        (from + shown * self.per(zoom), cut)
    }
}

/// Returns the largest size, limited to [`OUTLIER_FACTOR`] times the upper quartile.
fn typical_max(mut sizes: Vec<f64>) -> f64 {
    sizes.retain(|size| size.is_finite());
    sizes.sort_by(f64::total_cmp);
    let largest = sizes.last().copied().unwrap_or(0.0);
    let usual = sizes.get(sizes.len() * 3 / 4).copied().unwrap_or(0.0);
    if usual > 0.0 {
        largest.min(OUTLIER_FACTOR * usual)
    } else {
        largest
    }
}
