//! An axis-aligned box in the world.

use crate::Vec2;

/// An axis-aligned box in world units; empty until a point is included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The lower left corner.
    pub low: Vec2,
    /// The upper right corner.
    pub high: Vec2,
}

impl Default for Bounds {
    fn default() -> Self {
        Bounds {
            low: Vec2::new(f64::INFINITY, f64::INFINITY),
            high: Vec2::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
        }
    }
}

impl Bounds {
    /// Grows the box to contain `point`, if that is finite.
    pub fn include(&mut self, point: Vec2) {
        if point.is_finite() {
            self.low = Vec2::new(self.low.x.min(point.x), self.low.y.min(point.y));
            self.high = Vec2::new(self.high.x.max(point.x), self.high.y.max(point.y));
        }
    }

    /// Returns the smallest box that contains both boxes.
    pub(super) fn with(mut self, other: Bounds) -> Bounds {
        if !other.is_empty() {
            self.include(other.low);
            self.include(other.high);
        }
        self
    }

    /// Clamps the box to another box. If the boxes do not overlap, the nearest edge of `other`
    /// remains.
    pub(super) fn within(self, other: Bounds) -> Bounds {
        if self.is_empty() || other.is_empty() {
            return self;
        }
        let inside = |p: Vec2| {
            Vec2::new(
                p.x.clamp(other.low.x, other.high.x),
                p.y.clamp(other.low.y, other.high.y),
            )
        };
        Bounds {
            low: inside(self.low),
            high: inside(self.high),
        }
    }

    /// Interpolates linearly between this box and another by `share`; if one is empty, returns the
    /// other.
    pub(super) fn towards(self, other: Bounds, share: f64) -> Bounds {
        if self.is_empty() || other.is_empty() {
            return self.with(other);
        }
        Bounds {
            low: self.low * (1.0 - share) + other.low * share,
            high: self.high * (1.0 - share) + other.high * share,
        }
    }

    /// Returns `true` if no point was included.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.low.x > self.high.x
    }

    /// Returns the width and height; zero if empty.
    #[must_use]
    pub fn size(&self) -> Vec2 {
        if self.is_empty() {
            Vec2::ZERO
        } else {
            self.high - self.low
        }
    }

    /// Returns the centre; the origin if empty.
    #[must_use]
    pub fn centre(&self) -> Vec2 {
        if self.is_empty() {
            Vec2::ZERO
        } else {
            self.low + self.size() * 0.5
        }
    }
}
