//! Represents a picture by its elements, for drawings and plots on paper.
//!
//! Coordinates are user units, y downwards. The appearance of a shape follows from its class in the
//! style sheet, which every writer uses. The picture is therefore the same as an SVG document,
//! inside a page, and in TikZ.

use super::style::StyleSheet;
use crate::Vec2;

/// The alignment of a text relative to its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TextAnchor {
    /// The text begins at the position.
    Start,
    /// The text is centred at the position.
    Middle,
    /// The text ends at the position.
    End,
}

/// A picture of a given size; later elements cover earlier ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Artwork {
    pub(super) size: Vec2,
    pub(super) title: String,
    pub(super) style: StyleSheet,
    pub(super) elements: Vec<ArtElement>,
}

/// An element of a picture; all its coordinates are finite.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ArtElement {
    /// Polylines, open or closed.
    Path {
        runs: Vec<Vec<Vec2>>,
        is_closed: bool,
        class: String,
    },
    /// A circle.
    Circle {
        at: Vec2,
        radius: f64,
        class: String,
    },
    /// A single line of text.
    Text {
        at: Vec2,
        anchor: TextAnchor,
        class: String,
        text: String,
    },
}

impl Artwork {
    pub(crate) fn new(size: Vec2, title: &str, style: StyleSheet) -> Self {
        Artwork {
            size,
            title: title.to_owned(),
            style,
            elements: Vec::new(),
        }
    }

    /// Returns the size, in user units.
    pub(crate) fn size(&self) -> Vec2 {
        self.size
    }

    /// Returns the elements, from the bottom up.
    #[cfg(test)]
    pub(crate) fn elements(&self) -> &[ArtElement] {
        &self.elements
    }

    /// Adds a polyline, interrupted at points that are not finite.
    pub(crate) fn polyline(&mut self, points: impl IntoIterator<Item = Vec2>, class: &str) {
        let mut runs: Vec<Vec<Vec2>> = Vec::new();
        let mut pen_is_down = false;
        for point in points {
            if point.is_finite() {
                match runs.last_mut().filter(|_| pen_is_down) {
                    Some(run) => run.push(point),
                    None => runs.push(vec![point]),
                }
            }
            pen_is_down = point.is_finite();
        }
        self.path(runs, false, class);
    }

    /// Adds a closed polygon.
    pub(crate) fn polygon(&mut self, points: impl IntoIterator<Item = Vec2>, class: &str) {
        let corners: Vec<Vec2> = points.into_iter().filter(|p| p.is_finite()).collect();
        let runs = if corners.is_empty() {
            vec![]
        } else {
            vec![corners]
        };
        self.path(runs, true, class);
    }

    fn path(&mut self, runs: Vec<Vec<Vec2>>, is_closed: bool, class: &str) {
        if !runs.is_empty() {
            self.elements.push(ArtElement::Path {
                runs,
                is_closed,
                class: class.to_owned(),
            });
        }
    }

    pub(crate) fn circle(&mut self, at: Vec2, radius: f64, class: &str) {
        if at.is_finite() {
            let class = class.to_owned();
            self.elements.push(ArtElement::Circle { at, radius, class });
        }
    }

    pub(crate) fn text(&mut self, at: Vec2, anchor: TextAnchor, class: &str, text: &str) {
        if at.is_finite() {
            self.elements.push(ArtElement::Text {
                at,
                anchor,
                class: class.to_owned(),
                text: text.to_owned(),
            });
        }
    }
}
