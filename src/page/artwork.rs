//! A picture, element by element: what a drawing or a plot becomes on paper.
//!
//! Coordinates are user units, y downwards. What a shape looks like follows from its class in the style
//! sheet, which every writer reads: the picture is the same as an SVG document, inside a page, and in TikZ.

use super::style::StyleSheet;
use crate::Vec2;

/// Where a text stands against its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TextAnchor {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

/// A picture of a size, filled from the bottom up.
#[derive(Clone, Debug, PartialEq)]
pub struct Artwork {
    pub(super) size: Vec2,
    pub(super) title: String,
    pub(super) style: StyleSheet,
    pub(super) elements: Vec<ArtElement>,
}

/// An element of a picture; every place in it is finite.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ArtElement {
    /// Chains of straight lines, closed or not.
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
    /// A text of one line.
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

    /// How large it is.
    pub(crate) fn size(&self) -> Vec2 {
        self.size
    }

    /// What is drawn, from the bottom up.
    #[cfg(test)]
    pub(crate) fn elements(&self) -> &[ArtElement] {
        &self.elements
    }

    /// A chain of straight lines; what is not finite breaks it.
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

    /// A closed outline.
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
