//! The window of a drawing: maps world points to cells.

mod following;

use super::bounds::Bounds;
use super::motion::extents::{Extents, Margin};
use crate::Vec2;
pub(super) use following::WindowZoom;

/// A window of `cols` x `rows` cells on the world, with the same scale along both axes.
///
/// Cell coordinates begin at the upper left corner, x to the right, y downwards. The cell in column
/// `c` and row `r` covers `c..c + 1` and `r..r + 1`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldView {
    cols: u16,
    rows: u16,
    /// Cells per unit of length, along x and along y.
    scale: Vec2,
    /// The world point at `pin`.
    centre: Vec2,
    /// The position of `centre`, in cell coordinates.
    pin: Vec2,
    /// A world point in the middle of a cell. `None` in a window that follows the linkage, where it
    /// would jump from cell to cell.
    anchor: Option<Vec2>,
    /// The typical distance of neighbouring pins.
    pitch: f64,
}

/// The height of a cell divided by its width in most fonts.
pub(super) const CELL_ASPECT: f64 = 2.0;

/// The columns and rows below which the margins shrink with the window.
const FULL_MARGIN: Vec2 = Vec2::new(40.0, 16.0);

/// Minimum distance of pins for the widest bars, in cell widths: two and a half pins.
const MIN_PITCH: f64 = 7.5;

/// Minimum number of rows of a separate drawing.
const MIN_HEIGHT: u16 = 8;

impl WorldView {
    /// Returns the largest window with equal scales that contains the whole `reach` with its labels
    /// and supports.
    ///
    /// `aspect` is the height of a cell divided by its width; 2 suits most terminals and replaces a
    /// value that is not positive and finite.
    #[must_use]
    pub fn fit(extents: &Extents, cols: u16, rows: u16, aspect: f64) -> WorldView {
        let mut view = WorldView::around(
            &extents.parts(),
            extents.bounds().centre(),
            (cols, rows),
            aspect,
        );
        view.anchor = Some(extents.anchor());
        view.pitch = extents.pitch();
        view.rest();
        view
    }

    /// Returns the window moved so that a point is in its middle.
    #[must_use]
    pub fn centred_on(&self, point: Vec2) -> WorldView {
        if !point.is_finite() {
            return *self;
        }
        WorldView {
            centre: point,
            pin: self.middle(),
            anchor: None,
            ..*self
        }
    }

    /// Returns the largest window with equal scales that contains these parts with the cells around
    /// them.
    fn around(
        parts: &[(Bounds, Margin); 4],
        centre: Vec2,
        (cols, rows): (u16, u16),
        aspect: f64,
    ) -> WorldView {
        let aspect = if aspect > 0.0 && aspect.is_finite() {
            aspect
        } else {
            CELL_ASPECT
        };
        let cells = Vec2::new(f64::from(cols), f64::from(rows));
        let shrink = Vec2::new(
            (cells.x / FULL_MARGIN.x).min(1.0),
            (cells.y / FULL_MARGIN.y).min(1.0),
        );
        let horizontal = parts.map(|(b, m)| AxisSpan {
            low: b.low.x - centre.x,
            high: b.high.x - centre.x,
            before: m.left * shrink.x,
            after: m.right * shrink.x,
        });
        // Rows count downwards, so the world's y axis is flipped here.
        let vertical = parts.map(|(b, m)| AxisSpan {
            low: centre.y - b.high.y,
            high: centre.y - b.low.y,
            before: m.above * shrink.y,
            after: m.below * shrink.y,
        });
        let widest = largest_scale(&horizontal, cells.x);
        let highest = largest_scale(&vertical, cells.y);
        let scale = widest.min(highest * aspect);
        let scale = if scale.is_finite() && scale > 0.0 {
            scale
        } else {
            1.0
        };
        let scale = Vec2::new(scale, scale / aspect);
        WorldView {
            cols,
            rows,
            scale,
            centre,
            pin: Vec2::new(
                middle(&horizontal, cells.x, scale.x),
                middle(&vertical, cells.y, scale.y),
            ),
            anchor: None,
            pitch: f64::INFINITY,
        }
    }

    /// Returns the lowest window of at most `most` rows in which the drawing has the same size as
    /// with `most` rows. `of_rows` returns the window with a number of rows.
    #[must_use]
    pub fn lowest_window(maximum: u16, of_rows: impl Fn(u16) -> WorldView) -> WorldView {
        let highest = of_rows(maximum);
        // A rounding error does not count as a smaller drawing.
        let minimum = highest.scale.x * (1.0 - 1e-9);
        let mut lower = (MIN_HEIGHT..maximum).map(of_rows);
        lower
            .find(|view| view.scale.x >= minimum)
            .unwrap_or(highest)
    }

    /// Returns the window enlarged by `zoom` about its middle, then moved over the world by
    /// `shift`.
    ///
    /// Without a zoom and a shift it is unchanged. Factors that are not positive and finite count
    /// as 1, and shifts that are not finite as zero.
    #[must_use]
    pub fn zoomed(&self, zoom: f64, shift: Vec2) -> WorldView {
        let zoom = if zoom > 0.0 && zoom.is_finite() {
            zoom
        } else {
            1.0
        };
        let shift = if shift.is_finite() { shift } else { Vec2::ZERO };
        let scale = self.scale * zoom;
        if (zoom == 1.0 && shift == Vec2::ZERO) || !(scale.is_finite() && scale.x > 0.0) {
            return *self;
        }
        let middle = self.middle();
        let mut zoomed = WorldView {
            scale,
            centre: self.world(middle) + shift,
            pin: middle,
            ..*self
        };
        // After a shift, the point under the mouse pointer must stay there.
        if shift == Vec2::ZERO {
            zoomed.rest();
        }
        zoomed
    }

    /// Returns the middle of the window, in cell coordinates.
    fn middle(&self) -> Vec2 {
        Vec2::new(f64::from(self.cols), f64::from(self.rows)) * 0.5
    }

    /// Returns the world point at a place in cell coordinates.
    #[must_use]
    pub fn world(&self, cell: Vec2) -> Vec2 {
        let offset = cell - self.pin;
        self.centre + Vec2::new(offset.x / self.scale.x, -offset.y / self.scale.y)
    }

    /// Moves the window by less than a cell so that its anchor is in the middle of one. Ground pins
    /// and guides through it are then drawn along the middle of their row.
    fn rest(&mut self) {
        let Some(anchor) = self.anchor else { return };
        let at = self.cell(anchor);
        let centred = Vec2::new(at.x.floor() + 0.5, at.y.floor() + 0.5);
        if centred.is_finite() && at.is_finite() {
            self.pin += centred - at;
        }
    }

    /// Returns the number of columns.
    #[must_use]
    pub fn cols(&self) -> u16 {
        self.cols
    }

    /// Returns the number of rows.
    #[must_use]
    pub fn rows(&self) -> u16 {
        self.rows
    }

    /// Returns the height of a cell divided by its width.
    #[must_use]
    pub fn aspect(&self) -> f64 {
        self.scale.x / self.scale.y
    }

    /// Returns the width of a link in dots: a line of dots in a small window, a bar in a large one.
    /// Between close pins, wide bars and large pins would hide each other.
    pub(super) fn weight(&self) -> u8 {
        match self.rows.min(self.cols / 2) {
            ..=9 => 1,
            10..=31 => 2,
            _ if self.cells_along(self.pitch) < MIN_PITCH => 2,
            _ => 3,
        }
    }

    /// Returns the number of columns of a horizontal length in the world.
    #[must_use]
    pub fn cells_along(&self, length: f64) -> f64 {
        length * self.scale.x
    }

    /// Returns the position of a world point in cell coordinates.
    #[must_use]
    pub fn cell(&self, point: Vec2) -> Vec2 {
        let offset = point - self.centre;
        Vec2::new(
            self.pin.x + offset.x * self.scale.x,
            self.pin.y - offset.y * self.scale.y,
        )
    }
}

/// A span that must lie inside along one axis: a stretch of the world with cells before and after
/// it.
#[derive(Clone, Copy)]
struct AxisSpan {
    low: f64,
    high: f64,
    before: f64,
    after: f64,
}

/// Returns the largest scale at which all spans fit into `cells`: every end must fit with every
/// beginning.
fn largest_scale(spans: &[AxisSpan], cells: f64) -> f64 {
    let mut scale = f64::INFINITY;
    for first in spans {
        for last in spans {
            let space = (cells - first.before - last.after).max(1.0);
            let length = last.high - first.low;
            if length > 0.0 {
                scale = scale.min(space / length);
            }
        }
    }
    scale
}

/// Returns the place of the world's centre at which the spans and their margins are centred in
/// `cells`.
fn middle(spans: &[AxisSpan], cells: f64, scale: f64) -> f64 {
    let mut start = f64::INFINITY;
    let mut end = f64::NEG_INFINITY;
    for span in spans.iter().filter(|s| s.low <= s.high) {
        start = start.min(span.low * scale - span.before);
        end = end.max(span.high * scale + span.after);
    }
    let centre = cells / 2.0 - (start + end) / 2.0;
    if centre.is_finite() {
        centre
    } else {
        cells / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn extents(points: &[(f64, f64)], ground: &[(f64, f64)]) -> Extents {
        let place = |p: &[(f64, f64)]| p.iter().map(|&(x, y)| Vec2::new(x, y)).collect::<Vec<_>>();
        Extents::of_places(&place(points), &place(ground))
    }

    proptest! {
        #[test]
        fn view_contains_all_points_and_keeps_aspect(
            points in prop::collection::vec((-1.0..1.0, -1.0..1.0), 2..8),
            (size, shift) in (-150.0..150.0, -1e6..1e6),
            (cols, rows) in (12_u16..400, 6_u16..200),
            aspect in 1.0..3.0,
        ) {
            let size = 10_f64.powf(size);
            let shift = shift * size;
            let scaled: Vec<_> = points.iter().map(|p| (p.0 * size + shift, p.1 * size)).collect();
            let extents = extents(&scaled, &scaled[..1]);
            let view = WorldView::fit(&extents, cols, rows, aspect);
            for &(x, y) in &scaled {
                let at = view.cell(Vec2::new(x, y));
                prop_assert!(at.x >= 0.0 && at.x <= f64::from(cols), "{at:?}");
                prop_assert!(at.y >= 0.0 && at.y <= f64::from(rows), "{at:?}");
            }
            let corner = Vec2::new(scaled[0].0, scaled[0].1);
            let origin = view.cell(corner);
            let right = view.cell(corner + Vec2::new(size, 0.0)) - origin;
            let up = view.cell(corner + Vec2::new(0.0, size)) - origin;
            prop_assert!((right.x + up.y * aspect).abs() < 1e-6 * right.x.abs());
        }
    }

    proptest! {
        #[test]
        fn zoomed_view_keeps_size_aspect_and_middle(
            points in prop::collection::vec((-50.0..50.0, -50.0..50.0), 2..8),
            zoom in 0.2..80.0,
            (cols, rows) in (1_u16..400, 1_u16..200),
            (x, y) in (-60.0..60.0, -60.0..60.0),
        ) {
            let extents = extents(&points, &points[..1]);
            let view = WorldView::fit(&extents, cols, rows, 2.0);
            let shift = Vec2::new(x, y);
            let zoomed = view.zoomed(zoom, shift);
            prop_assert_eq!((zoomed.cols(), zoomed.rows()), (cols, rows));
            prop_assert!((zoomed.aspect() / view.aspect() - 1.0).abs() < 1e-12);
            prop_assert!((zoomed.cells_along(1.0) / view.cells_along(zoom) - 1.0).abs() < 1e-12);
            let middle = Vec2::new(f64::from(cols), f64::from(rows)) * 0.5;
            let off = zoomed.cell(view.world(middle) + shift) - middle;
            prop_assert!(off.x.abs() <= 0.5 + 1e-6 && off.y.abs() <= 0.5 + 1e-6, "{off:?}");
            for odd in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
                prop_assert_eq!(view.zoomed(odd, Vec2::new(odd * 0.0, 0.0)), view);
            }
        }
    }

    #[test]
    fn snug_view_is_lower_at_same_scale() {
        let extents = extents(&[(0.0, 0.0), (40.0, 5.0)], &[(0.0, 0.0)]);
        let of_rows = |rows| WorldView::fit(&extents, 80, rows, 2.0);
        let (snug, high) = (WorldView::lowest_window(40, of_rows), of_rows(40));
        assert!(snug.rows() < 20, "{snug:?}");
        assert!((snug.cells_along(1.0) / high.cells_along(1.0) - 1.0).abs() < 1e-6);
        assert_eq!(WorldView::lowest_window(3, of_rows).rows(), 3);
    }

    #[test]
    fn first_ground_point_is_in_middle_of_a_cell() {
        let extents = extents(&[(-3.0, -1.0), (9.7, 5.1)], &[(0.4, 0.3), (7.0, 0.3)]);
        for (cols, rows) in [(80, 24), (79, 23), (40, 12), (5, 3)] {
            let at = WorldView::fit(&extents, cols, rows, 2.0).cell(Vec2::new(0.4, 0.3));
            assert!((at.x.fract() - 0.5).abs() < 1e-9, "{at:?}");
            assert!((at.y.fract() - 0.5).abs() < 1e-9, "{at:?}");
        }
    }

    #[test]
    fn view_has_room_for_support_below_lowest_pin() {
        let extents = extents(&[(0.0, 0.0), (9.0, 9.0)], &[(0.0, 0.0)]);
        let at = WorldView::fit(&extents, 60, 30, 2.0).cell(Vec2::ZERO);
        assert!(at.y.floor() + 2.0 < 30.0, "{at:?}");
    }

    #[test]
    fn empty_views_and_motions_give_finite_cells() {
        for (cols, rows) in [(0, 0), (1, 1), (0, 9), (u16::MAX, 1)] {
            for points in [&[][..], &[(5.0, 5.0)], &[(1.0, 1.0), (1.0, 2.0)]] {
                for aspect in [2.0, 0.0, -1.0, f64::NAN, f64::INFINITY] {
                    let view = WorldView::fit(&extents(points, points), cols, rows, aspect);
                    let at = view.cell(Vec2::new(5.0, 5.0));
                    assert!(at.is_finite(), "{cols} x {rows}, {points:?}: {at:?}");
                }
            }
        }
    }
}
