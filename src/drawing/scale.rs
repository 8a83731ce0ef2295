//! How long arrows are: one scale over the whole motion.

use super::bounds::Bounds;
use super::reach::Reach;
use crate::Vec2;

/// The longest arrow for the diagonal of all places that the linkage comes to.
const LONGEST: f64 = 0.2;

/// Close to a dead point rates and forces grow beyond all bounds. What exceeds the upper quartile of all by this factor
/// is cut, so that the rest can still be seen.
const OUTSTANDING: f64 = 3.0;

/// The scale of arrows of one kind.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ArrowScale {
    /// What the longest arrow stands for.
    most: f64,
    /// Units of length of the drawing for one of these.
    per: f64,
}

/// Where the driver stands, where an arrow begins then, and what it stands for.
pub(super) type MovingArrow = (f64, Vec2, Vec2);

/// How long the longest arrow is in the drawing of what needs this space.
pub(super) fn longest(reach: &Reach) -> f64 {
    LONGEST * reach.bounds().size().norm()
}

impl ArrowScale {
    /// At which the longest of these arrows of a whole motion is as long as it may be; `tips` grows by where they come to.
    pub(super) fn of_motion(
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
        let most = usual_most(sizes.collect());
        let per = if most > 0.0 { longest / most } else { 0.0 };
        ArrowScale { most, per }
    }

    /// Units of length for one of what the arrows stand for, on a drawing that is shown `zoom` times as large.
    pub(super) fn per(self, zoom: f64) -> f64 {
        self.per / zoom
    }

    /// What the longest arrow stands for.
    pub(super) fn most(self) -> f64 {
        self.most
    }

    /// The tip of the arrow of a rate or a force at a point, and whether it was cut.
    pub(super) fn tip(self, from: Vec2, size: Vec2, zoom: f64) -> (Vec2, bool) {
        let norm = size.norm();
        // What rounding adds to the longest is no reason to break it.
        let cut = norm > self.most * (1.0 + 1e-9);
        let shown = if cut { size * (self.most / norm) } else { size };
        (from + shown * self.per(zoom), cut)
    }
}

/// The largest of these, or where that stands out, so much as [`OUTSTANDING`] allows.
fn usual_most(mut sizes: Vec<f64>) -> f64 {
    sizes.retain(|size| size.is_finite());
    sizes.sort_by(f64::total_cmp);
    let largest = sizes.last().copied().unwrap_or(0.0);
    let usual = sizes.get(sizes.len() * 3 / 4).copied().unwrap_or(0.0);
    if usual > 0.0 {
        largest.min(OUTSTANDING * usual)
    } else {
        largest
    }
}
