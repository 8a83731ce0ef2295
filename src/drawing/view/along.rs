//! A window that goes along with the linkage.
//!
//! It is a function of the driver's coordinate alone, as the room that it shows is: the same place always looks
//! the same. Its size goes by small steps and its place by some cells, so that what is fixed stands still between
//! two of them, for the eye and for the line; both are rounded apart from each other, since two steps of which one
//! follows from the other would make the window shake.

use super::super::poses::PoseRoom;
use super::{Margin, Reach, WorldView};
use crate::Vec2;

/// A linkage takes at least so much of the width or of the height of a window that goes along.
const LEAST_FILL: f64 = 0.6;

/// The window is enlarged in so many steps to twice its size, and moved in so many across it.
const STEPS_OF_TWO: f64 = 24.0;
const STEPS_ACROSS: u16 = 40;

/// How much nearer than the whole motion such a window may be; the least that will do.
const NEARER: [f64; 8] = [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0];

/// How near a window of a size goes.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Nearness {
    size: WindowSize,
    /// None where the whole motion will do.
    nearer: Option<f64>,
}

/// Columns, rows, and the height of a cell for its width.
#[derive(Clone, Copy, Debug, PartialEq)]
struct WindowSize {
    cols: u16,
    rows: u16,
    aspect: f64,
}

impl WorldView {
    /// A window in which the linkage is large wherever it stands: the whole motion where that leaves it
    /// three fifths of the width or the height everywhere, else so much nearer to the linkage at this
    /// coordinate of its driver, and going along with it, as that needs.
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

    /// The window on the linkage as it stands at a coordinate of its driver, going along with it.
    #[must_use]
    pub fn pose(reach: &Reach, at: f64, cols: u16, rows: u16, aspect: f64) -> WorldView {
        match reach.poses().room(at) {
            Some(room) => near(reach, room, 1.0, WindowSize { cols, rows, aspect }),
            None => WorldView::fit(reach, cols, rows, aspect),
        }
    }

    /// The larger of the shares of width and height that a linkage takes whose points fill a box: half of
    /// a pin is beyond it on every side.
    fn fill(&self, pose: super::Bounds) -> f64 {
        let size = pose.size();
        let across = (size.x * self.scale.x + 1.0) / f64::from(self.cols);
        across.max((size.y * self.scale.y + 1.0) / f64::from(self.rows))
    }
}

/// How near a window of this size must go so that the linkage is large everywhere.
fn nearer(reach: &Reach, size: WindowSize) -> Option<f64> {
    let whole = WorldView::fit(reach, size.cols, size.rows, size.aspect);
    let mut poses = reach.poses().some();
    if poses.all(|(pose, _)| whole.fill(pose) >= LEAST_FILL) {
        return None;
    }
    let is_large = |nearer: &f64| {
        let mut poses = reach.poses().some();
        poses.all(|(pose, room)| near(reach, room, *nearer, size).fill(pose) >= LEAST_FILL)
    };
    let found = NEARER.into_iter().find(is_large);
    Some(found.unwrap_or(1.0))
}

/// The window on a room that lies a share of the way from the whole motion to this one.
fn near(reach: &Reach, room: PoseRoom, nearer: f64, size: WindowSize) -> WorldView {
    let WindowSize { cols, rows, aspect } = size;
    let [columns, lines] = [cols, rows].map(|cells| f64::from((cells / STEPS_ACROSS).max(1)));
    let whole = reach.bounds();
    let space = whole.towards(room.linkage, nearer);
    // It is moved by up to half a step.
    let parts = reach.parts_near(space, room.tips);
    let parts = parts.map(|(part, margin)| (part, margin.widened(columns / 2.0, lines / 2.0)));
    let mut view = WorldView::around(&parts, space.centre(), (cols, rows), aspect);
    let at = view.cell(reach.anchor());
    if at.is_finite() {
        let steps = (view.scale.x * whole.size().norm()).log2() * STEPS_OF_TWO;
        let smaller = ((steps.floor() - steps) / STEPS_OF_TWO).exp2();
        // Towards the anchor, or what is seen next to it, so that nothing else gets out of sight.
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
    /// The same with so many cells more at the sides, and above and below.
    fn widened(self, side: f64, high: f64) -> Margin {
        Margin {
            left: self.left + side,
            right: self.right + side,
            above: self.above + high,
            below: self.below + high,
        }
    }
}
