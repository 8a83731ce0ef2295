//! Windows that follow the linkage.
//!
//! A window is a function of the driver's coordinate alone, like the extents that it shows, so each
//! place always looks the same. Its size changes in small steps and its position by some cells, so
//! that fixed parts do not move between two steps. Both are rounded independently: steps that
//! depend on each other would make the window shake.

use super::super::poses::PoseExtents;
use super::{Margin, Reach, WorldView};
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
pub(in super::super) struct Nearness {
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
    pub fn along(reach: &Reach, at: f64, cols: u16, rows: u16, aspect: f64) -> WorldView {
        let size = WindowSize { cols, rows, aspect };
        let nearness = reach.nearness(
            |known| known.size == size,
            || Nearness {
                size,
                nearer: nearer(reach, size),
            },
        );
        match (nearness.nearer, reach.poses().room(at)) {
            (Some(nearer), Some(room)) => near(reach, room, nearer, size),
            _ => WorldView::fit(reach, cols, rows, aspect),
        }
    }

    /// Returns the window that follows the linkage most closely, at a driver coordinate.
    #[must_use]
    pub fn pose(reach: &Reach, at: f64, cols: u16, rows: u16, aspect: f64) -> WorldView {
        match reach.poses().room(at) {
            Some(room) => near(reach, room, 1.0, WindowSize { cols, rows, aspect }),
            None => WorldView::fit(reach, cols, rows, aspect),
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
fn nearer(reach: &Reach, size: WindowSize) -> Option<f64> {
    let whole = WorldView::fit(reach, size.cols, size.rows, size.aspect);
    let mut poses = reach.poses().some();
    if poses.all(|(pose, _)| whole.fill(pose) >= MIN_FILL) {
        return None;
    }
    let is_large = |nearer: &f64| {
        let mut poses = reach.poses().some();
        poses.all(|(pose, room)| near(reach, room, *nearer, size).fill(pose) >= MIN_FILL)
    };
    let found = NEARER.into_iter().find(is_large);
    Some(found.unwrap_or(1.0))
}

/// Returns the window on extents interpolated by `nearer` between the whole motion and the pose.
fn near(reach: &Reach, room: PoseExtents, nearer: f64, size: WindowSize) -> WorldView {
    let WindowSize { cols, rows, aspect } = size;
    let [columns, lines] = [cols, rows].map(|cells| f64::from((cells / STEPS_ACROSS).max(1)));
    let whole = reach.bounds();
    let space = whole.towards(room.linkage, nearer);
    // The window moves by up to half a step.
    let parts = reach.parts_near(space, room.tips);
    let parts = parts.map(|(part, margin)| (part, margin.widened(columns / 2.0, lines / 2.0)));
    let mut view = WorldView::around(&parts, space.centre(), (cols, rows), aspect);
    let at = view.cell(reach.anchor());
    if at.is_finite() {
        let steps = (view.scale.x * whole.size().norm()).log2() * STEPS_OF_TWO;
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
