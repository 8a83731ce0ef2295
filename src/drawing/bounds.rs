//! A box in the world.

use crate::Vec2;

/// A box in world units; empty until something is included.
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
    /// Grows to hold `point`, if it is finite.
    pub fn include(&mut self, point: Vec2) {
        if point.is_finite() {
            self.low = Vec2::new(self.low.x.min(point.x), self.low.y.min(point.y));
            self.high = Vec2::new(self.high.x.max(point.x), self.high.y.max(point.y));
        }
    }

    /// Both boxes' box.
    pub(super) fn with(mut self, other: Bounds) -> Bounds {
        if !other.is_empty() {
            self.include(other.low);
            self.include(other.high);
        }
        self
    }

    /// The part inside another box: where both lie apart, the nearest edge of that.
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

    /// From this box a share of the way to another; where one is empty, the other.
    pub(super) fn towards(self, other: Bounds, share: f64) -> Bounds {
        if self.is_empty() || other.is_empty() {
            return self.with(other);
        }
        Bounds {
            low: self.low * (1.0 - share) + other.low * share,
            high: self.high * (1.0 - share) + other.high * share,
        }
    }

    /// Whether nothing was included.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.low.x > self.high.x
    }

    /// Width and height; zero if empty.
    #[must_use]
    pub fn size(&self) -> Vec2 {
        if self.is_empty() {
            Vec2::ZERO
        } else {
            self.high - self.low
        }
    }

    /// The middle; the origin if empty.
    #[must_use]
    pub fn centre(&self) -> Vec2 {
        if self.is_empty() {
            Vec2::ZERO
        } else {
            self.low + self.size() * 0.5
        }
    }
}
