//! Windows that follow the linkage.
//!
//! A window is a function of the driver's coordinate alone, like the extents that it shows, so each
//! place always looks the same. Its size changes in small steps and its position by some cells, so
//! that fixed parts do not move between two steps. Both are rounded independently: steps that
//! depend on each other would make the window shake.

use super::super::motion::poses::PoseExtents;
use super::{Extents, Margin, WorldView};
use crate::Vec2;

/// Minimum fraction of the window's width or height that a linkage fills.
const MIN_FILL: f64 = 0.6;

/// Number of zoom steps per factor of two, and of steps in position across the window.
const STEPS_OF_TWO: f64 = 24.0;
const STEPS_ACROSS: u16 = 40;

/// Candidates for how far the window moves from the extents of the whole motion, 0, to those of the
/// pose, 1. The smallest sufficient one is used.
const NEARER: [f64; 8] = [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0];

/// The zoom of a window size.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct WindowZoom {
    size: WindowSize,
    /// `None` if the window on the whole motion suffices.
    nearer: Option<f64>,
}

/// Columns, rows, and the height of a cell divided by its width.
#[derive(Clone, Copy, Debug, PartialEq)]
struct WindowSize {
    cols: u16,
    rows: u16,
    aspect: f64,
}

impl WorldView {
    /// Returns a window in which the linkage is large in every pose. The whole motion is shown if
    /// every pose then fills three fifths of the width or the height. If not, the window follows
    /// the linkage at this driver coordinate, as close as necessary.
    #[must_use]
    pub fn along(extents: &Extents, at: f64, cols: u16, rows: u16, aspect: f64) -> WorldView {
        let size = WindowSize { cols, rows, aspect };
        let nearness = extents.nearness(
            |known| known.size == size,
            || WindowZoom {
                size,
                nearer: nearer(extents, size),
            },
        );
        match (nearness.nearer, extents.poses().extents_at(at)) {
            (Some(nearer), Some(space)) => near(extents, space, nearer, size),
            _ => WorldView::fit(extents, cols, rows, aspect),
        }
    }

    /// Returns the window that follows the linkage most closely, at a driver coordinate.
    #[must_use]
    pub fn pose(extents: &Extents, at: f64, cols: u16, rows: u16, aspect: f64) -> WorldView {
        match extents.poses().extents_at(at) {
            Some(space) => near(extents, space, 1.0, WindowSize { cols, rows, aspect }),
            None => WorldView::fit(extents, cols, rows, aspect),
        }
    }

    /// Returns the larger of the fractions of width and height that a pose fills, with half a pin
    /// beyond its box on every side.
    fn fill(&self, pose: super::Bounds) -> f64 {
        let size = pose.size();
        let across = (size.x * self.scale.x + 1.0) / f64::from(self.cols);
        across.max((size.y * self.scale.y + 1.0) / f64::from(self.rows))
    }
}

/// Returns how close a window of this size must be for the linkage to be large in every pose;
/// `None` if the whole motion suffices.
fn nearer(extents: &Extents, size: WindowSize) -> Option<f64> {
    let complete = WorldView::fit(extents, size.cols, size.rows, size.aspect);
    let mut poses = extents.poses().some();
    if poses.all(|(pose, _)| complete.fill(pose) >= MIN_FILL) {
        return None;
    }
    let is_large = |nearer: &f64| {
        let mut poses = extents.poses().some();
        poses.all(|(pose, space)| near(extents, space, *nearer, size).fill(pose) >= MIN_FILL)
    };
    let found = NEARER.into_iter().find(is_large);
    Some(found.unwrap_or(1.0))
}

/// Returns the window on extents interpolated by `nearer` between the whole motion and the pose.
fn near(extents: &Extents, available: PoseExtents, nearer: f64, size: WindowSize) -> WorldView {
    let WindowSize { cols, rows, aspect } = size;
    let [columns, lines] = [cols, rows].map(|cells| f64::from((cells / STEPS_ACROSS).max(1)));
    let complete = extents.bounds();
    let space = complete.towards(available.linkage, nearer);
    // The window moves by up to half a step.
    let parts = extents.parts_near(space, available.tips);
    let parts = parts.map(|(part, margin)| (part, margin.widened(columns / 2.0, lines / 2.0)));
    let mut view = WorldView::around(&parts, space.centre(), (cols, rows), aspect);
    view.pitch = extents.pitch();
    let at = view.cell(extents.anchor());
    if at.is_finite() {
        let steps = (view.scale.x * complete.size().norm()).log2() * STEPS_OF_TWO;
        let smaller = ((steps.floor() - steps) / STEPS_OF_TWO).exp2();
        // Shrinks towards the anchor, or the nearest visible point, so that nothing else leaves the
        // window.
        let kept = Vec2::new(
            at.x.clamp(0.0, f64::from(cols)),
            at.y.clamp(0.0, f64::from(rows)),
        );
        if smaller.is_finite() {
            view.centre = view.world(kept);
            view.pin = kept;
            view.scale = view.scale * smaller;
        }
        let stood = |at: f64, step: f64| ((at - 0.5) / step).round() * step + 0.5;
        view.pin += Vec2::new(stood(at.x, columns), stood(at.y, lines)) - at;
    }
    view
}

impl Margin {
    /// Returns the margin with more cells at the sides, and above and below.
    fn widened(self, side: f64, high: f64) -> Margin {
        Margin {
            left: self.left + side,
            right: self.right + side,
            above: self.above + high,
            below: self.below + high,
        }
    }
}
